// Comprobaciones independientes del capítulo 1.
#include "colores.h"
#include "guiones.h"
#include "imagenes.h"
#include "plana.h"
#include "tabla.h"
#include <GL/glew.h>
// después de glew.h
#include "glut/sin_ventana/glut_sin_ventana.h"
#include <unistd.h>

// Los dos programas que no usan common/ se prueban también por dentro. A primer_programa se le cambian las funciones de
// OpenGL por otras que apuntan a quién se llama.
namespace primer_programa {
std::string llamadas;
#define main mainDelPrograma
#define glClear(x) (llamadas += "borra ")
#define glutSwapBuffers() (llamadas += "intercambia ")
#define glutSetWindowTitle(t) (llamadas += std::string("«") + (t) + "» ")
#include "ch01_intro/primer_programa.cpp"
#undef glClear
#undef glutSwapBuffers
#undef glutSetWindowTitle
} // namespace primer_programa

namespace shader_basico {
#define LAB_FUENTES "."
#include "ch01_intro/shader_basico.cpp"
} // namespace shader_basico

// A info_opengl se le dice que cada límite es su nombre.
namespace info_opengl {
#define glGetIntegerv(que, valor) (*(valor) = GLint(que))
#include "ch01_intro/info_opengl.cpp"
#undef glGetIntegerv
#undef main
} // namespace info_opengl

// Todos los píxeles son de él, también después de cambiar de tamaño; tras cambiar el estado, hasta dibujar no cambian.
TEST(PrimerPrograma, TodoDelColorDeBorradoAlDibujar) {
    const oraculo::Vec3 amarillo{1, 1, 0}, azul = exacto(AZUL);
    const struct {
        std::string guion;
        oraculo::Vec3 color;
    } casos[] = {{"tecla d; tecla i", amarillo},
                 {"tecla d", azul},
                 {"tecla i", azul},
                 {"tamano 333 77", amarillo},
                 {"tecla i; tamano 1 1", azul}};
    paraCada("primer_programa", casos, 240, 180,
             [](const auto &c, const Vista &vista) { compruebaPlana(c.guion, vista.escena, {}, c.color); });
}

// Sin glutSwapBuffers se dibuja igual, pero en una ventana no se vería: se miran las llamadas.
TEST(PrimerPrograma, LaTeclaSQuitaElIntercambio) {
    using namespace primer_programa;
    for (const char *esperadas :
         {"«Primer programa: sin glutSwapBuffers» borra ", "«Primer programa» borra intercambia "}) {
        llamadas.clear();
        teclado('s', 0, 0);
        dibuja();
        EXPECT_EQ(llamadas, esperadas);
    }
}

// Los tres programas sin common/ leen sus argumentos ellos mismos.
TEST(SinCommon, UnArgumentoDeMasTerminaCon2) {
    for (const std::string programa : {"primer_programa", "shader_basico", "info_opengl"}) {
        const std::string uso = "uso: " + programa + " [opciones de GLUT]\n";
        const Ejecucion mal = ejecuta(programa, "", 240, 180, {"sobra"}),
                        ayuda = ejecuta(programa, "", 240, 180, {"-ayuda"});
        EXPECT_EQ(mal.estado, 2);
        EXPECT_EQ(mal.errores, (programa == "info_opengl" ? "info_opengl: no entiendo «sobra»; " : "") + uso);
        EXPECT_TRUE(ayuda.estado == 0 && ayuda.errores.empty()) << programa;
    }
}

// F5 con el shader roto conserva el programa que había y lo dice; arreglado, lo usa. Los shaders son los de
// ./ch01_intro.
TEST(ShaderBasico, F5) {
    using namespace shader_basico;
    const std::string
        vertices = "in vec4 posicion;\nvoid main() { gl_Position = posicion; }",
        otraSalida = "out vec3 c;\nin vec4 posicion;\nvoid main() { gl_Position = posicion; c = vec3(1.0); }",
        sinPosicion = "void main() { gl_Position = vec4(0.0); }",
        rojo = "out vec4 color;\nvoid main() { color = vec4(1.0, 0.0, 0.0, 1.0); }",
        verde = "out vec4 color;\nvoid main() { color = vec4(0.0, 1.0, 0.0, 1.0); }",
        roto = "out vec4 color;\nvoid main() { esto no compila",
        otraEntrada = "out vec4 color;\nin vec4 c;\nvoid main() { color = c; }";
    const struct {
        std::string vert, frag;
        int nivelRojo;
        std::string dice;
    } pasos[] = {{vertices, rojo, 255, ""},
                 {vertices, roto, 255, "shader_basico.frag no compila: "},
                 {otraSalida, otraEntrada, 255, "no enlazan: "},
                 {vertices, "", 255, "«shader_basico.frag» no está, o está vacío"},
                 {sinPosicion, verde, 255, "no usa «posicion»"},
                 {vertices, verde, 0, ""}};
    std::filesystem::create_directory(carpetaTemporal() / "ch01_intro");
    std::filesystem::current_path(carpetaTemporal());
    char nombre[] = "shader_basico", opcion[] = "-geometry", talla[] = "200x200";
    char *argv[] = {nombre, opcion, talla, nullptr};
    int argc = 3;
    glutInit(&argc, argv);
    glutInitContextVersion(3, 1);
    glutCreateWindow("prueba");
    glewExperimental = GL_TRUE;
    glewInit();
    inicia(); // aún no hay shaders
    glutDisplayFunc(dibuja);
    glutSpecialFunc(tecladoEspecial);
    for (const auto &[vert, frag, nivelRojo, dice] : pasos) {
        std::ofstream("ch01_intro/shader_basico.vert") << "#version 140\n" << vert;
        std::ofstream("ch01_intro/shader_basico.frag") << (frag.empty() ? "" : "#version 140\n") << frag;
        testing::internal::CaptureStderr();
        glutOrden("especial F5");
        const std::string dicho = testing::internal::GetCapturedStderr();
        GLubyte centro[3];
        glReadPixels(100, 80, 1, 1, GL_RGB, GL_UNSIGNED_BYTE, centro);
        EXPECT_TRUE(dice.empty() ? dicho.empty() : dicho.find(dice) != std::string::npos) << dicho;
        EXPECT_TRUE(centro[0] == nivelRojo && centro[1] == 255 - nivelRojo) << dice;
        EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR)) << dice;
    }
}

// Cada píxel, por la prueba de semiplanos en su centro.
TEST(ShaderBasico, CoberturaDelTriangulo) {
    const oraculo::Vec3 rojo{1, 0, 0};
    for (const glm::ivec2 t : {glm::ivec2(240, 180), {120, 200}, {300, 60}})
        compruebaPlana(enGuion(t), imagenDe("shader_basico", "", t.x, t.y),
                       triangulos(GL_TRIANGLES, {{-0.95, -0.82, rojo}, {0.95, -0.82, rojo}, {0, 0.82, rojo}},
                                  cuadrado(t.x, t.y)),
                       exacto(FONDO_CLARO));
}

// Una línea con valor por dato. Sin ventana, ni la versión de OpenGL ni FreeGLUT son los del sistema, y lo dice.
TEST(InfoOpengl, CadaClaveEsta) {
    const Ejecucion e = ejecuta("info_opengl");
    EXPECT_EQ(e.estado, 0) << e.errores;
    std::string forma;
    for (const char *linea :
         {"OpenGL: .*\\(forzado con MESA_GL_VERSION_OVERRIDE=3\\.1FC\\)",
          "GLSL: .*\\(forzado con MESA_GLSL_VERSION_OVERRIDE=140\\)", "Fabricante: .+", "Renderizador: .+",
          "GLEW: .+", "GLM: .+", "FreeGLUT: .* \\(imitado: no hay pantalla\\)", "Textura 2D máxima: .+",
          "Textura 3D máxima: .+", "Mapa de cubo máximo: .+", "Unidades de textura: .+",
          "Unidades de textura en el vertex shader: .+", "Atributos de vértice: .+", "Muestras por píxel: .+",
          "Anisotropía máxima: .+", "Resultado: se puede hacer todo el curso"})
        forma += linea + std::string("\n");
    EXPECT_TRUE(std::regex_match(e.salida, std::regex(forma))) << e.salida;
}

TEST(InfoOpengl, CadaLimiteEsElSuyo) { // con un OpenGL anterior, sin_opengl.sh
    char nombre[] = "info_opengl", *argumentos[] = {nombre, nullptr};
    std::string limites;
    for (const auto &[clave, cual] :
         {std::pair("Textura 2D máxima", GL_MAX_TEXTURE_SIZE),
          {"Textura 3D máxima", GL_MAX_3D_TEXTURE_SIZE},
          {"Mapa de cubo máximo", GL_MAX_CUBE_MAP_TEXTURE_SIZE},
          {"Unidades de textura", GL_MAX_TEXTURE_IMAGE_UNITS},
          {"Unidades de textura en el vertex shader", GL_MAX_VERTEX_TEXTURE_IMAGE_UNITS},
          {"Atributos de vértice", GL_MAX_VERTEX_ATTRIBS},
          {"Muestras por píxel", GL_MAX_SAMPLES}})
        limites += clave + (": " + std::to_string(cual)) + "( .*)?\n";
    EXPECT_EXIT((dup2(2, 1), std::exit(info_opengl::mainDelPrograma(1, argumentos))),
                testing::ExitedWithCode(0), limites);
}

// Cada error nombra fichero y línea, o los dos shaders y la variable; F5 vuelve a intentarlo, y lo cuenta otra vez.
TEST(ErroresShader, NombraFicheroYLinea) {
    const Ejecucion e = ejecuta("errores_shader",
                                "tecla 2; especial F5; tecla 3; especial F5; tecla 4; tecla 1; especial F5");
    EXPECT_EQ(e.estado, 0) << e.errores;
    const std::string mensaje = "(.|\n)*", bien = "ch01_intro/errores_shader\\.frag: compila y enlaza\n",
                      noCompila = "ch01_intro/errores_shader_compila\\.frag:8: " + mensaje +
                                  " — «colorFragmento = nuevoColor;»\n",
                      noEnlaza = "ch01_intro/errores_shader\\.vert y ch01_intro/errores_shader_enlaza\\.frag "
                                 "no enlazan: " +
                                 mensaje + "nuevoColor" + mensaje + "\n";
    EXPECT_TRUE(std::regex_match(
        e.salida, std::regex(bien + noCompila + noCompila + noEnlaza + noEnlaza + bien + bien)))
        << e.salida;
}

// El marco dice si va mal; el triángulo, con sus colores, sigue siempre sobre la consola, que ocupa tres décimas.
TEST(ErroresShader, SigueVivoYDiceEnQueCasoEsta) {
    const struct {
        std::string guion;
        glm::vec3 marco;
    } casos[] = {{"", GRIS},
                 {"tecla 2", ROJO},
                 {"especial F5; tecla 0; tecla 4", ROJO},
                 {"tamano 120 200; tecla 3", ROJO},
                 {"especial F5; tecla 1", GRIS}};
    const std::vector<VerticePlano> vertices = {
        {-0.95, -0.92, exacto(AMARILLO)}, {0.95, -0.92, exacto(VERDE)}, {0, 0.62, exacto(AZUL)}};
    paraCada("errores_shader", casos, 240, 180, [&](const auto &c, const Vista &vista) {
        const int ancho = vista.escena.ancho, alto = vista.escena.alto, marco = alto / 50,
                  consola = 3 * alto / 10;
        const Imagen escena =
            recorta(vista.escena, Hueco{marco, consola, ancho - 2 * marco, alto - consola - marco});
        compruebaPlana(c.guion, escena,
                       triangulos(GL_TRIANGLES, vertices, cuadrado(escena.ancho, escena.alto)),
                       exacto(FONDO_CLARO));
        EXPECT_LT(distancia(pixel(vista.escena, 0, 0), color(c.marco)), 1) << c.guion;
        EXPECT_LT(distancia(pixel(vista.escena, ancho / 2, consola - marco - 2), color(FONDO_OSCURO)), 1);
    });
}
