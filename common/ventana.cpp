#include "ventana.h"
#include "ayuda.h"
#include "error.h"
#include "glut/sistema/sistema.h"
#include "shader.h"
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

const unsigned char ESC = 27;

// Donde los títulos van en Latin-1, lo que no está en él va con sus letras, α como «alfa».
std::string tituloParaGlut(const std::string &utf8) {
    if (glutGet(GLUT_VERSION) >= FREEGLUT_CON_UTF8)
        return utf8;
    static const std::pair<const char *, const char *> FUERA[] = {
        {"−", "-"},     {"√", "raiz "}, {"π", "pi"},  {"α", "alfa"},
        {"δ", "delta"}, {"θ", "theta"}, {"Φ", "Phi"}, {"→", "->"}};
    std::string s = utf8;
    for (const auto &[de, a] : FUERA)
        for (std::size_t i; (i = s.find(de)) != std::string::npos;)
            s.replace(i, std::strlen(de), a);
    std::string latin1;
    for (std::size_t i = 0; i < s.size(); ++i) {
        const unsigned char c = static_cast<unsigned char>(s[i]);
        if ((c == 0xC2 || c == 0xC3) && i + 1 < s.size())
            latin1 += char((c << 6 & 0xC0) | (static_cast<unsigned char>(s[++i]) & 0x3F));
        else
            latin1 += c < 0x80 ? s[i] : '?';
    }
    return latin1;
}

} // namespace

void abreVentana(int &argc, char **argv, const char *titulo, unsigned modo, const char *argumentos) {
    glutInitWindowSize(960, 720); // antes de glutInit, para que valga la opción -geometry
    glutInit(&argc, argv);
    glutInitDisplayMode(modo);
    glutInitContextVersion(3, 1);
    const std::string uso =
        "uso: " + nombrePrograma() + " [opciones de GLUT] " + (argumentos ? argumentos : "");
    const std::string primero = argc > 1 ? argv[1] : "";
    if (primero == "-ayuda" || primero == "-h" || primero == "--help") {
        std::printf("%s\n%s\n", uso.c_str(), controlesDelPrograma().c_str());
        std::exit(0);
    }
    for (int i = 1; i < argc; ++i)
        if (!argumentos || !*argv[i]) // un argumento vacío no es de nadie
            falla("no entiendo «" + std::string(argv[i]) + "»; " + uso, 2);
    glutCreateWindow(tituloParaGlut(titulo).c_str());
    glewExperimental = GL_TRUE;
    glewInit(); // su resultado no sirve: sin GLX da error aunque haya encontrado todas las funciones
    if (!GLEW_VERSION_3_1 || !glGenVertexArrays)
        falla("hace falta OpenGL 3.1 y hay " +
              std::string(reinterpret_cast<const char *>(glGetString(GL_VERSION))));
    glutKeyboardFunc([](unsigned char tecla, int, int) { teclaComun(tecla); });
    glutSpecialFunc([](int tecla, int, int) { teclaEspecialComun(tecla); });
    if (std::getenv("LAB_VIGILA"))
        cambiaVigilancia();
}

void ponTitulo(const std::string &titulo) {
    glutSetWindowTitle(tituloParaGlut(titulo).c_str());
}

bool teclaComun(unsigned char tecla) {
    if (tecla == ESC)
        glutLeaveMainLoop();
    return tecla == ESC;
}

bool teclaEspecialComun(int tecla) {
    switch (tecla) {
    case GLUT_KEY_F1: cambiaAyuda(); break;
    case GLUT_KEY_F2: cambiaPuntero(); break;
    case GLUT_KEY_F3: cambiaVigilancia(); break;
    case GLUT_KEY_F5: recargaProgramas(); break;
    case GLUT_KEY_F11: glutFullScreenToggle(); break;
    case GLUT_KEY_F12: pideCaptura(); break;
    default: return false;
    }
    glutPostRedisplay();
    return true;
}
