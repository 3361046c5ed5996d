// glut_sin_ventana: partidas al azar, contra lo que dijo de ellas un modelo; lo que dice de la ventana, contra lo que
// hay; lo que rechaza, y lo que ve su diario.
#include "ejecuta.h"
#include "rutas.h"
#include <GL/glew.h>
#include <GL/freeglut.h>
#include <unistd.h>

using testing::ExitedWithCode;

namespace {

void abre(unsigned modo, std::vector<std::string> opciones = {}) {
    opciones.insert(opciones.begin(), "x");
    std::vector<char *> palabras;
    for (std::string &o : opciones)
        palabras.push_back(o.data());
    palabras.push_back(nullptr);
    int cuantas = int(opciones.size());
    glutInit(&cuantas, palabras.data());
    glutInitDisplayMode(modo);
    glutCreateWindow("x");
    glewExperimental = GL_TRUE;
    glewInit();
}

/// Acaba con 0 si lo que dice glutGet de la ventana es lo que hay.
[[noreturn]] void diceLoQueHay(unsigned modo) {
    const int antes = glutGet(GLUT_INIT_STATE);
    abre(modo);
    const auto bits = [](GLenum que, GLenum parametro) {
        GLint tipo = 0, n = 0;
        glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, que, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE,
                                              &tipo);
        if (tipo)
            glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, que, parametro, &n);
        return n;
    };
    GLint muestras = -1;
    glGetIntegerv(GL_SAMPLES, &muestras);
    const bool bien =
        antes == 0 && glutGet(GLUT_INIT_STATE) == 1 && glutGet(GLUT_WINDOW_NUM_SAMPLES) == muestras &&
        glutGet(GLUT_WINDOW_DEPTH_SIZE) == bits(GL_DEPTH, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE) &&
        glutGet(GLUT_WINDOW_STENCIL_SIZE) == bits(GL_STENCIL, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE) &&
        bits(GL_DEPTH, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE) == (modo & GLUT_DEPTH ? 24 : 0) &&
        bits(GL_STENCIL, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE) == (modo & GLUT_STENCIL ? 8 : 0) &&
        glutGet(GLUT_WINDOW_DOUBLEBUFFER) == (modo & GLUT_DOUBLE ? 1 : 0) &&
        glutGet(GLUT_SCREEN_WIDTH) == 1920 && glutGet(GLUT_SCREEN_HEIGHT) == 1080 &&
        glutGet(GLUT_SCREEN_WIDTH_MM) == 0 && glutGet(GLUT_SCREEN_HEIGHT_MM) == 0 &&
        glutGet(GLUT_VERSION) >= 30800;
    std::exit(bien ? 0 : 1);
}

/// Lo que el primer cuadro deja cambiado, y no los siguientes; el diario, en stderr.
[[noreturn]] void dejaCambiado(void (*que)()) {
    static void (*cambia)() = que;
    dup2(2, 1);
    abre(GLUT_DEPTH | GLUT_STENCIL, {"-diario", "-guion", "tecla a", "-ppm", "/dev/null"});
    glutDisplayFunc([] { std::exchange(cambia, [] {})(); });
    glutMainLoop();
    std::exit(0);
}

/// Acaba con las veces que se llama a la función de ocio: una tras cada orden, hasta que el programa termina.
[[noreturn]] void cuentaOcios() {
    static int ocios = 0;
    abre(GLUT_DEPTH, {"-guion", "tecla a; tecla b ×2; tecla c", "-ppm", "/dev/null"});
    glutDisplayFunc([] {});
    glutIdleFunc([] { ++ocios; });
    glutKeyboardFunc([](unsigned char tecla, int, int) {
        if (tecla == 'c')
            glutLeaveMainLoop();
    });
    glutMainLoop();
    std::exit(ocios);
}

} // namespace

TEST(Glut, LaFuncionDeOcioTrasCadaOrden) {
    EXPECT_EXIT(cuentaOcios(), ExitedWithCode(3), "");
}

TEST(Glut, ComoElModelo) {
    std::istringstream partidas(leeFichero(recurso("tests/golden/costura/partidas.txt")));
    std::string linea, tandas, guion;
    int jugadas = 0;
    while (std::getline(partidas, linea)) {
        if (linea[0] != '=')
            continue;
        std::getline(partidas, tandas);
        std::getline(partidas, guion);
        std::string debe = "título: Registro, así: θ · 2° → π\n", acaba;
        while (acaba != "fin" && std::getline(partidas, acaba))
            debe += acaba + "\n";
        for (const char *destino : {"osmesa", "egl"}) {
            const std::string registro = std::string("../tests/registro_") + destino;
            if (!std::filesystem::exists(LAB_EJECUTABLES "/" + registro))
                continue;
            const Ejecucion e = ejecuta(registro, guion, 300, 200, {"-rasgos", "-titulos", "-", tandas});
            EXPECT_EQ(e.errores, "");
            ASSERT_EQ(e.salida, debe) << destino << ", partida " << linea;
        }
        ++jugadas;
    }
    EXPECT_EQ(jugadas, 24);
}

// EGL no tiene plantilla sin profundidad: ahí hay más de lo que se pide.
TEST(Glut, DiceLoQueHay) {
    const bool egl = std::filesystem::path(LAB_EJECUTABLES).filename() == "egl";
    for (unsigned i = 0; i < 16; ++i) {
        const unsigned modo = (i & 1 ? GLUT_DOUBLE : 0u) | (i & 2 ? GLUT_DEPTH : 0u) |
                              (i & 4 ? GLUT_STENCIL : 0u) | (i & 8 ? GLUT_MULTISAMPLE : 0u);
        if (egl && (modo & (GLUT_DEPTH | GLUT_STENCIL)) == GLUT_STENCIL)
            continue;
        EXPECT_EXIT(diceLoQueHay(modo), ExitedWithCode(0), "") << i;
    }
}

// De un interruptor y, de lo que tiene varios valores, el último. Lo dice de ese cuadro, y de los siguientes no.
TEST(Glut, ElDiarioVeLoQueQuedaPuesto) {
    const std::pair<const char *, void (*)()> casos[] = {
        {"SCISSOR_TEST", [] { glEnable(GL_SCISSOR_TEST); }},
        {"COLOR_WRITEMASK", [] { glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE); }},
        {"DEPTH_RANGE", [] { glDepthRange(0, 0.5); }},
        {"STENCIL_BACK_WRITEMASK", [] { glStencilMaskSeparate(GL_BACK, 1); }}};
    for (const auto &[nombre, cambia] : casos)
        EXPECT_EXIT(dejaCambiado(cambia), ExitedWithCode(0),
                    "diario\t\t[^\n]*" + std::string(nombre) + " [^\n]*\ndiario(\t[^\t]*){4}\t\t")
            << nombre;
}

// Cada cosa que dice al acabar un programa.
TEST(Glut, LoQueRechazaSeDice) {
    const auto menu = [](int) {};
    const std::vector<std::pair<std::string, std::function<void()>>> casos = {
        {"glutInit se llama una sola vez", [] { abre(0), abre(0); }},
        {"pide 3.2", [] { glutInitContextVersion(3, 2); }},
        {"pide 4.0", [] { glutInitContextVersion(4, 0); }},
        {"solo da el perfil core", [] { glutInitContextProfile(GLUT_COMPATIBILITY_PROFILE); }},
        {"glutSetOption\\([0-9]+\\) no está", [] { glutSetOption(GLUT_RENDERING_CONTEXT, 1); }},
        {"glutGet\\([0-9]+\\) no está", [] { glutGet(GLUT_WINDOW_X); }},
        {"antes hay que llamar a glutInit", [] { glutCreateWindow("x"); }},
        {"solo tiene una ventana", [] { abre(0), glutCreateWindow("otra"); }},
        {"falta la ventana o glutDisplayFunc", [] { glutMainLoop(); }},
        {"falta la ventana o glutDisplayFunc", [] { abre(0), glutMainLoop(); }},
        {"glutAddMenuEntry: no hay menú; falta", [] { glutAddMenuEntry("x", 1); }},
        {"glutAddSubMenu\\(7\\): no hay ese menú", [=] { glutCreateMenu(menu), glutAddSubMenu("x", 7); }},
        {"glutAttachMenu: no hay menú", [] { glutAttachMenu(0); }},
        {"glutAttachMenu\\(-1\\): no hay ese botón", [=] { glutCreateMenu(menu), glutAttachMenu(-1); }},
        {"glutAttachMenu\\(3\\): no hay ese botón", [=] { glutCreateMenu(menu), glutAttachMenu(3); }},
        {"glutSetMenu\\(1\\): no hay ese menú", [] { glutSetMenu(1); }},
    };
    for (const auto &caso : casos)
        EXPECT_EXIT((caso.second(), std::exit(0)), ExitedWithCode(1), caso.first) << caso.first;
}
