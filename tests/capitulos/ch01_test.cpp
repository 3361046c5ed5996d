// Comprobaciones independientes del capítulo 1.
#include "colores.h"
#include "ejecuta.h"
#include "rotulos.h"
#include <GL/glew.h>
#include <GL/freeglut.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <unistd.h>

// Los dos programas que no usan common/ se prueban también por dentro. A primer_programa se le cambian las funciones de OpenGL
// por otras que apuntan a quién se llama.
namespace primer_programa {
std::string llamadas;
#define main mainDelPrograma
#define glClear(x) (llamadas += "borra ")
#define glClearColor(r, g, b, a) (llamadas += (b) > 0.5 ? "azul " : "amarillo ")
#define glutSwapBuffers() (llamadas += "intercambia ")
#define glutPostRedisplay() (llamadas += "pide ")
#define glutSetWindowTitle(t) (llamadas += "titula ")
#include "ch01_intro/primer_programa.cpp"
#undef glClear
#undef glClearColor
#undef glutSwapBuffers
#undef glutPostRedisplay
#undef glutSetWindowTitle
} // namespace primer_programa

namespace shader_basico {
#define LAB_FUENTES "."
#include "ch01_intro/shader_basico.cpp"
} // namespace shader_basico

// Aquí no hay contexto de menos de 3.1: a info_opengl se le dice que el suyo lo es.
namespace info_opengl {
#define glGetString(que) reinterpret_cast<const GLubyte *>((que) == GL_VERSION ? "3.0 Mesa" : "?")
#include "ch01_intro/info_opengl.cpp"
#undef glGetString
#undef main
} // namespace info_opengl

// Todos los píxeles son (255, 255, 0), también después de cambiar de tamaño y mientras no se dibuje tras cambiar el estado.
TEST(PrimerPrograma, TodoDelColorDeBorradoAlDibujar) {
    const struct {
        const char *guion;
        Pixel color;
    } casos[] = {{"", {255, 255, 0}},
                 {"tamano 333 77", {255, 255, 0}},
                 {"tamano 1 1", {255, 255, 0}},
                 {"tecla i", {255, 255, 0}},
                 {"tecla d", {255, 255, 0}},
                 {"tecla i; tecla d", {41, 97, 204}},
                 {"tecla i; tamano 333 77", {41, 97, 204}},
                 {"tecla i; tecla d; tecla i", {41, 97, 204}},
                 {"tecla i; tecla i; tecla d", {255, 255, 0}}};
    for (const auto &caso : casos) {
        const Ejecucion e = ejecuta("ch01_intro/primer_programa", caso.guion);
        ASSERT_EQ(e.estado, 0) << e.errores;
        for (int y = 0; y < e.imagen.alto; ++y)
            for (int x = 0; x < e.imagen.ancho; ++x) {
                const Pixel p = pixel(e.imagen, x, y);
                ASSERT_TRUE(p.r == caso.color.r && p.g == caso.color.g && p.b == caso.color.b)
                    << caso.guion << ": " << x << "," << y;
            }
        apuntaDiferencia(0, 0);
    }
}

// Sin glutSwapBuffers se dibuja igual, pero en una ventana no se vería; sin ventana no hay diferencia, así que se miran las
// llamadas.
TEST(PrimerPrograma, LaTeclaSQuitaElIntercambio) {
    using namespace primer_programa;
    const auto apunta = [](const char *teclas) {
        llamadas.clear();
        for (; *teclas; ++teclas)
            teclado(static_cast<unsigned char>(*teclas), 0, 0);
        dibuja();
        return llamadas;
    };
    EXPECT_EQ(apunta(""), "borra intercambia ");
    EXPECT_EQ(apunta("d"), "pide borra intercambia ");
    EXPECT_EQ(apunta("s"), "titula borra ");
    EXPECT_EQ(apunta("i"), "azul borra ");
    EXPECT_EQ(apunta("s"), "titula borra intercambia ");
    EXPECT_EQ(apunta("i"), "amarillo borra intercambia ");
}

TEST(SinCommon, UnArgumentoDeMasTerminaCon2) {
    for (const std::string programa : {"primer_programa", "shader_basico"}) {
        const Ejecucion e = ejecuta("ch01_intro/" + programa, "", 240, 180, {"sobra"});
        EXPECT_EQ(e.estado, 2);
        EXPECT_EQ(e.errores, "uso: " + programa + " [opciones de GLUT]\n");
    }
}

namespace {

void escribe(const std::string &fichero, const std::string &texto) {
    std::ofstream(fichero) << texto;
}

// Con los shaders de ./ch01_intro: el estado es el número del paso en que algo no va.
[[noreturn]] void pruebaF5() {
    using namespace shader_basico;
    const auto centro = [] {
        GLubyte p[3];
        dibuja();
        glReadPixels(100, 80, 1, 1, GL_RGB, GL_UNSIGNED_BYTE, p);
        return p[0] == 255 ? 'r' : p[1] == 255 ? 'v' : '?';
    };
    const auto exige = [](bool bien, int paso) {
        if (!bien)
            std::exit(paso);
    };
    const std::string vert = "ch01_intro/shader_basico.vert", frag = "ch01_intro/shader_basico.frag",
                      cabecera = "#version 140\nout vec4 color;\n",
                      fragmentoRojo = cabecera + "void main() { color = vec4(1.0, 0.0, 0.0, 1.0); }\n",
                      fragmentoVerde = cabecera + "void main() { color = vec4(0.0, 1.0, 0.0, 1.0); }\n",
                      vertices = "#version 140\nin vec4 posicion;\nvoid main() { gl_Position = posicion; }\n";
    char nombre[] = "shader_basico", opcion[] = "-geometry", talla[] = "200x200";
    char *argv[] = {nombre, opcion, talla, nullptr};
    int argc = 3;
    glutInit(&argc, argv);
    glutInitContextVersion(3, 1);
    glutCreateWindow("prueba");
    glewExperimental = GL_TRUE;
    glewInit();
    cambiaTamano(200, 200);

    escribe(vert, vertices);
    escribe(frag, fragmentoRojo);
    inicia();
    exige(estado.programa && centro() == 'r', 10);
    escribe(frag, cabecera + "void main() { esto no compila\n");
    tecladoEspecial(GLUT_KEY_F5, 0, 0);
    exige(centro() == 'r', 11);
    escribe(vert, "#version 140\nin vec4 posicion;\nout vec3 c;\nvoid main() { gl_Position = posicion; c = "
                  "vec3(1.0); }\n");
    escribe(frag, cabecera + "in vec4 c;\nvoid main() { color = c; }\n");
    tecladoEspecial(GLUT_KEY_F5, 0, 0);
    exige(centro() == 'r', 12);
    std::remove(frag.c_str());
    tecladoEspecial(GLUT_KEY_F5, 0, 0);
    exige(centro() == 'r', 13);
    escribe(frag, fragmentoVerde);
    escribe(vert, "#version 140\nvoid main() { gl_Position = vec4(0.0); }\n");
    tecladoEspecial(GLUT_KEY_F5, 0, 0);
    exige(centro() == 'r', 14);
    escribe(vert, vertices);
    tecladoEspecial(GLUT_KEY_F5, 0, 0);
    exige(centro() == 'v', 15);
    exige(glGetError() == GL_NO_ERROR, 16);
    std::exit(0);
}

} // namespace

// F5 con el shader roto conserva el programa que había y lo dice; arreglado, lo usa.
TEST(ShaderBasico, F5) {
    std::string plantilla = (std::filesystem::temp_directory_path() / "labXXXXXX").string();
    ASSERT_TRUE(mkdtemp(plantilla.data()));
    std::filesystem::create_directory(plantilla + "/ch01_intro");
    EXPECT_EXIT(
        {
            std::filesystem::current_path(plantilla);
            pruebaF5();
        },
        testing::ExitedWithCode(0),
        "shader_basico.frag no compila: .*\n(.*\n)*.*no enlazan: .*\n(.*\n)*.*«shader_basico.frag» no está, "
        "o está vacío.*\n"
        ".*no usa «posicion»");
    std::filesystem::remove_all(plantilla);
}

// La cobertura del triángulo contra la prueba exacta de semiplanos en el centro de cada píxel, en doble
// precisión. Los centros a menos de 1/256 de píxel de un lado (la rejilla de OpenGL) quedan fuera.
TEST(ShaderBasico, CoberturaDelTriangulo) {
    const int ancho = 240, alto = 180;
    const Ejecucion e = ejecuta("ch01_intro/shader_basico", "", ancho, alto);
    ASSERT_EQ(e.estado, 0) << e.errores;
    const double ndc[3][2] = {{-0.95, -0.82}, {0.95, -0.82}, {0.0, 0.82}};
    double v[3][2];
    for (int i = 0; i < 3; ++i) {
        v[i][0] = (ancho - alto) / 2 + (ndc[i][0] + 1) / 2 * alto;
        v[i][1] = (ndc[i][1] + 1) / 2 * alto;
    }
    int comparados = 0, dentroTotal = 0;
    for (int y = 0; y < alto; ++y)
        for (int x = 0; x < ancho; ++x) {
            double distancia = 1e9;
            for (int i = 0; i < 3; ++i) {
                const double *a = v[i], *b = v[(i + 1) % 3];
                const double dx = b[0] - a[0], dy = b[1] - a[1];
                distancia =
                    std::min(distancia, (dx * (y + 0.5 - a[1]) - dy * (x + 0.5 - a[0])) / std::hypot(dx, dy));
            }
            if (std::fabs(distancia) < 1.0 / 256)
                continue;
            const Pixel p = pixel(e.imagen, x, y);
            const bool dentro = p.r == 255 && p.g == 0 && p.b == 0,
                       fuera = p.r == 242 && p.g == 245 && p.b == 250;
            ASSERT_TRUE(distancia > 0 ? dentro : fuera) << x << "," << y << " distancia " << distancia;
            ++comparados;
            dentroTotal += dentro;
        }
    apuntaDiferencia(0, 0, 1.0 / 256);
    EXPECT_GT(comparados, ancho * alto * 99 / 100);
    EXPECT_GT(dentroTotal, 5000);
}

TEST(InfoOpengl, CadaClaveEsta) {
    const Ejecucion e = ejecuta("ch01_intro/info_opengl");
    EXPECT_EQ(e.estado, 0) << e.errores;
    for (const char *clave :
         {"OpenGL", "GLSL", "Fabricante", "Renderizador", "GLEW", "GLM", "FreeGLUT", "Textura 2D máxima",
          "Textura 3D máxima", "Mapa de cubo máximo", "Unidades de textura",
          "Unidades de textura en el vertex shader", "Atributos de vértice", "Muestras por píxel",
          "Anisotropía máxima", "Resultado"}) {
        const std::size_t i = ("\n" + e.salida).find("\n" + std::string(clave) + ": ");
        ASSERT_NE(i, std::string::npos) << clave;
        EXPECT_NE(e.salida[i + std::string(clave).size() + 2], '\n') << clave << " sin valor";
    }
}

// Sin ventana, ni la versión de OpenGL ni FreeGLUT son los del sistema, y lo dice.
TEST(InfoOpengl, DiceLoQueEsImitado) {
    const Ejecucion e = ejecuta("ch01_intro/info_opengl");
    EXPECT_NE(e.salida.find("(forzado con MESA_GL_VERSION_OVERRIDE=3.1FC)\n"), std::string::npos) << e.salida;
    EXPECT_NE(e.salida.find("(forzado con MESA_GLSL_VERSION_OVERRIDE=140)\n"), std::string::npos) << e.salida;
    EXPECT_NE(e.salida.find("(imitado: no hay pantalla)\n"), std::string::npos) << e.salida;
}

TEST(InfoOpengl, NoAceptaArgumentos) {
    const Ejecucion mal = ejecuta("ch01_intro/info_opengl", "", 9, 9, {"sobra"});
    EXPECT_EQ(mal.estado, 2);
    EXPECT_EQ(mal.errores, "info_opengl: no entiendo «sobra»; uso: info_opengl [opciones de GLUT]\n");
    EXPECT_EQ(ejecuta("ch01_intro/info_opengl", "", 9, 9, {"-ayuda"}).estado, 0);
}

TEST(InfoOpengl, SinOpengl31NoSaleConCero) {
    setenv("MESA_GL_VERSION_OVERRIDE", "2.1", 1);
    const Ejecucion e = ejecuta("ch01_intro/info_opengl");
    unsetenv("MESA_GL_VERSION_OVERRIDE");
    EXPECT_EQ(e.estado, 1);
    EXPECT_NE(e.errores.find("OpenGL 3.1"), std::string::npos) << e.errores;
}

TEST(InfoOpengl, ConUnOpenglAntiguoDiceLoQueFalta) {
    char nombre[] = "info_opengl", *argumentos[] = {nombre, nullptr};
    EXPECT_EXIT((dup2(2, 1), std::exit(info_opengl::mainDelPrograma(1, argumentos))),
                testing::ExitedWithCode(1),
                "Falta: OpenGL 3.1 o posterior\n(.*\n)*Resultado: falta lo imprescindible");
}

TEST(ErroresShader, NombraFicheroYLinea) {
    const Ejecucion e = ejecuta("ch01_intro/errores_shader", "tecla 2");
    EXPECT_EQ(e.estado, 0) << e.errores;
    EXPECT_NE(e.salida.find("ch01_intro/errores_shader_compila.frag:8: "), std::string::npos) << e.salida;
    EXPECT_NE(e.salida.find("«colorFragmento = nuevoColor;»"), std::string::npos) << e.salida;
}

TEST(ErroresShader, ElDeEnlazadoNombraLosDosShadersYLaVariable) {
    const Ejecucion e = ejecuta("ch01_intro/errores_shader", "tecla 3");
    EXPECT_EQ(e.estado, 0) << e.errores;
    EXPECT_NE(
        e.salida.find("ch01_intro/errores_shader.vert y ch01_intro/errores_shader_enlaza.frag no enlazan"),
        std::string::npos)
        << e.salida;
    EXPECT_NE(e.salida.find("nuevoColor"), std::string::npos) << e.salida;
}

// Cerca de cada vértice manda su color: amarillo, verde y azul.
TEST(ErroresShader, InterpolaElColorDeCadaVertice) {
    const glm::dvec2 vertices[] = {{-0.95, -0.92}, {0.95, -0.92}, {0, 0.62}};
    const glm::dvec3 colores[] = {AMARILLO, VERDE, AZUL};
    const Ejecucion e = ejecuta("ch01_intro/errores_shader", "", 960, 720);
    for (int cerca = 0; cerca < 3; ++cerca) {
        glm::dvec2 punto(0);
        glm::dvec3 color(0);
        for (int k = 0; k < 3; ++k) {
            const double peso = k == cerca ? 0.8 : 0.1;
            punto += peso * vertices[k];
            color += peso * colores[k];
        }
        const glm::ivec2 p(glm::dvec2(480, 360) + 360.0 * punto);
        const Pixel obtenido = pixel(e.imagen, p.x, p.y);
        const glm::dvec3 error = glm::dvec3(obtenido.r, obtenido.g, obtenido.b) - 255.0 * color;
        EXPECT_LE(glm::length(error), 2) << cerca;
    }
}

// F5 vuelve a intentarlo, y lo cuenta otra vez.
TEST(ErroresShader, F5VuelveAIntentarlo) {
    const auto veces = [](const std::string &guion, const std::string &texto) {
        const std::string salida = ejecuta("ch01_intro/errores_shader", guion).salida;
        int n = 0;
        for (std::size_t i = 0; (i = salida.find(texto, i)) != std::string::npos; ++i)
            ++n;
        return n;
    };
    EXPECT_EQ(veces("tecla 3; especial F5", "no enlazan"), 2);
    EXPECT_EQ(veces("especial F5", "compila y enlaza"), 2);
}

// Tras un error sigue vivo, con lo que dibujaba, y se recupera.
TEST(ErroresShader, SigueVivo) {
    const Ejecucion bien = ejecuta("ch01_intro/errores_shader");
    const Ejecucion vuelta = ejecuta("ch01_intro/errores_shader", "tecla 2; tecla 3; especial F5; tecla 1");
    const Ejecucion mal = ejecuta("ch01_intro/errores_shader", "tecla 2");
    EXPECT_EQ(bien.imagen.rgb, vuelta.imagen.rgb);
    EXPECT_NE(bien.imagen.rgb, mal.imagen.rgb);
    const Pixel centroBien = pixel(bien.imagen, 120, 80), centroMal = pixel(mal.imagen, 120, 80);
    EXPECT_TRUE(centroBien.r == centroMal.r && centroBien.g == centroMal.g && centroBien.b == centroMal.b);
}

// El fondo y el rótulo dicen en qué caso se está.
TEST(ErroresShader, FondoYRotulo) {
    const struct {
        const char *guion;
        glm::vec3 fondo, letras;
        std::u32string linea;
    } casos[] = {{"", FONDO_CLARO, OSCURO, U"Compila y enlaza"},
                 {"tecla 2", ROJO, BLANCO, U"Error de compilación:"},
                 {"tecla 3", ROJO, BLANCO, U"Error de enlazado:"},
                 {"tecla 3; tecla 1", FONDO_CLARO, OSCURO, U"Compila y enlaza"}};
    for (const auto &caso : casos) {
        const Ejecucion e = ejecuta("ch01_intro/errores_shader", caso.guion, 960, 720);
        const Pixel p = pixel(e.imagen, 20, 360);
        EXPECT_EQ(glm::ivec3(p.r, p.g, p.b), glm::ivec3(255.0f * caso.fondo + 0.5f)) << caso.guion;
        EXPECT_EQ(buscaRotulo(e.imagen, caso.linea, caso.letras, 4).size(), 1u) << caso.guion;
    }
}
