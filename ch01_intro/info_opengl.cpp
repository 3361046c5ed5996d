// Qué hay instalado y si basta: OpenGL, GLSL, GLEW, GLM, FreeGLUT y los límites que importan en el curso
// (ejercicio 1.1). Programa de consola: una línea «clave: valor» por dato; estado 1 si falta OpenGL 3.1.
// Pide un contexto sin decir versión, para saber cuál es la mayor que da el sistema; si una variable de Mesa la cambia,
// o no hay pantalla y FreeGLUT es imitado, lo dice.
// Controles: sin controles.
#include <GL/glew.h>
#include <GL/freeglut.h>
#include <cstdio>
#include <cstdlib>
#include <glm/glm.hpp>
#include <string>

static void informa(const char *clave, const std::string &valor) {
    std::printf("%s: %s\n", clave, valor.c_str());
}

// Si la versión encontrada llega a la menor que vale, que se escribe `nombre`. Si no llega, lo dice.
static bool basta(const char *nombre, int encontrada, int minima, const char *siNo) {
    if (encontrada < minima)
        informa(siNo, std::string(nombre) + " o posterior");
    return encontrada >= minima;
}

static std::string cadena(GLenum nombre) {
    const GLubyte *s = glGetString(nombre);
    return s ? reinterpret_cast<const char *>(s) : "desconocido";
}

// Lo que añade al valor una variable que lo fuerza.
static std::string forzado(const char *variable) {
    const char *valor = std::getenv(variable);
    return valor ? std::string(" (forzado con ") + variable + "=" + valor + ")" : "";
}

static GLint limite(GLenum nombre) {
    GLint valor = 0;
    glGetIntegerv(nombre, &valor);
    return valor;
}

int main(int argc, char **argv) {
    glutInit(&argc, argv);
    if (argc > 1 && std::string(argv[1]) == "-ayuda") {
        std::puts("uso: info_opengl [opciones de GLUT]");
        return 0;
    }
    if (argc > 1) {
        std::fprintf(stderr, "info_opengl: no entiendo «%s»; uso: info_opengl [opciones de GLUT]\n", argv[1]);
        return 2;
    }
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGBA | GLUT_DEPTH);
    glutCreateWindow("info_opengl");
    glewExperimental = GL_TRUE;
    glewInit();

    const std::string version = cadena(GL_VERSION);
    int mayor = 0, menor = 0;
    std::sscanf(version.c_str(), "%d.%d", &mayor, &menor);
    const int openGL = 100 * mayor + menor;

    informa("OpenGL", version + forzado("MESA_GL_VERSION_OVERRIDE"));
    informa("GLSL", cadena(GL_SHADING_LANGUAGE_VERSION) + forzado("MESA_GLSL_VERSION_OVERRIDE"));
    informa("Fabricante", cadena(GL_VENDOR));
    informa("Renderizador", cadena(GL_RENDERER));
    informa("GLEW", reinterpret_cast<const char *>(glewGetString(GLEW_VERSION)));
    informa("GLM", std::to_string(GLM_VERSION_MAJOR) + "." + std::to_string(GLM_VERSION_MINOR) + "." +
                       std::to_string(GLM_VERSION_PATCH) + "." + std::to_string(GLM_VERSION_REVISION));
    const int glut = glutGet(GLUT_VERSION);
    const bool hayPantalla = glutGet(GLUT_SCREEN_WIDTH_MM) > 0;
    informa("FreeGLUT", std::to_string(glut / 10000) + "." + std::to_string(glut / 100 % 100) + "." +
                            std::to_string(glut % 100) + (hayPantalla ? "" : " (imitado: no hay pantalla)"));
    if (openGL >= 301) {
        informa("Textura 2D máxima", std::to_string(limite(GL_MAX_TEXTURE_SIZE)) + " texeles de lado");
        informa("Textura 3D máxima", std::to_string(limite(GL_MAX_3D_TEXTURE_SIZE)) + " texeles de lado");
        informa("Mapa de cubo máximo",
                std::to_string(limite(GL_MAX_CUBE_MAP_TEXTURE_SIZE)) + " texeles de lado");
        informa("Unidades de textura", std::to_string(limite(GL_MAX_TEXTURE_IMAGE_UNITS)));
        informa("Unidades de textura en el vertex shader",
                std::to_string(limite(GL_MAX_VERTEX_TEXTURE_IMAGE_UNITS)));
        informa("Atributos de vértice", std::to_string(limite(GL_MAX_VERTEX_ATTRIBS)));
        informa("Muestras por píxel", std::to_string(limite(GL_MAX_SAMPLES)));
    }
    const bool hayAnisotropia = GLEW_EXT_texture_filter_anisotropic;
    informa("Anisotropía máxima",
            std::to_string(hayAnisotropia ? limite(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT) : 1));

    const bool hayOpenGL = basta("OpenGL 3.1", openGL, 301, "Falta");
    basta("GLM 0.9.9", 100 * (100 * GLM_VERSION_MAJOR + GLM_VERSION_MINOR) + 10 * GLM_VERSION_PATCH, 990,
          "Anticuado");
    basta("FreeGLUT 3.0", glut / 100, 300, "Anticuado");
    informa("Resultado", hayOpenGL ? "se puede hacer todo el curso" : "falta lo imprescindible");
    return hayOpenGL ? 0 : 1;
}
