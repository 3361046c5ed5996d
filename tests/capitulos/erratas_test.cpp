// Lo que el libro pone mal y no es de ningún programa (docs/erratas.md), si se puede probar aquí.
#include "ch03_transformaciones/transformaciones.h"
#include "ch04_vista3d/vista.h"
#include "ejecuta.h"
#include "sonda.h"

// Lo que GLSL no entiende, o entiende de otra manera.
TEST(Glsl, NoEsLoQueDiceElLibro) {
    abreSonda();
    const struct {
        const char *parte, *declaraciones, *color;
        bool compila;
        glm::vec4 da;
    } casos[] = {
        // un vector por una matriz es una fila: la traspuesta de la matriz por el vector
        {"§1.5",
         "",
         "vec4(vec2(1, 2) * mat2(1, 2, 3, 4), mat2(1, 2, 3, 4) * vec2(1, 2))",
         true,
         {5, 11, 7, 10}},
        {"§1.5", "float f(float x) { return x > 0.0 ? f(x - 1.0) : 1.0; }", "vec4(f(2.0))", false, {}},
        {"§1.5", "void f(float x) { x = 2.0; }\nfloat g() { float x = 1.0; f(x); return x; }", "vec4(g())",
         true, glm::vec4(1)},
        {"§1.5",
         "",
         "vec4(gl_DepthRange.near, gl_DepthRange.far, gl_DepthRange.diff, 0)",
         true,
         {0, 1, 1, 0}},
        {"§1.5", "", "gl_ModelViewMatrix * vec4(1)", false, {}},
        {"§9.1.2", "", "1.0 - vec4(0, 0, 1, 1)", true, {1, 1, 0, 0}}, // lo opaco, transparente
        {"listado 9.3", "const int tallaFiltro = 9;", "vec4(tallaFiltro)", true, glm::vec4(9)},
        {"listado 9.3", "const int tallaFiltro 9;", "vec4(tallaFiltro)", false, {}},
        {"listado 9.3", "uniform sampler2D imagen;", "textura(imagen, vec2(0.5))", false, {}}};
    for (const auto &[parte, declaraciones, color, compila, da] : casos) {
        SCOPED_TRACE(std::string(parte) + ": " + color);
        const std::string fichero = carpetaTemporal() / "prueba.frag";
        std::ofstream(fichero) << "#version 140\nout vec4 colorFragmento;\n"
                               << declaraciones << "\nvoid main() {\n    colorFragmento = " << color
                               << ";\n}\n";
        std::string error;
        const GLuint programa = intentaPrograma("tests/vocabulario/sonda.vert", fichero, error);
        EXPECT_EQ(programa != 0, compila) << error;
        glUseProgram(programa);
        EXPECT_TRUE(!compila || leeSonda() == da);
    }
}

// §4.2: «preservar longitudes y ángulos» solo lo hace la proyección paralela con lo que es paralelo al plano de
// proyección. En la vista (1, 1, 1) un cubo tiene sus aristas acortadas a √(2/3) y a 120 grados.
TEST(Libro, LaParalelaNoConservaLongitudesNiAngulos) {
    const glm::dmat4 M =
        proyeccionParalela(-1, 1, -1, 1, -10, 10) * transformacionCamara({1, 1, 1}, {0, 0, 0}, {0, 1, 0});
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(glm::length(glm::dvec2(M[i])), std::sqrt(2.0 / 3), 1e-12);
        EXPECT_NEAR(glm::dot(glm::dvec2(M[i]), glm::dvec2(M[(i + 1) % 3])), -0.5 * 2 / 3, 1e-12);
    }
}

// §3.3: la traslación es afín y no cambia la normal; lo que importa es que el resto es lineal.
TEST(Libro, LaTraslacionNoCambiaLaNormal) {
    EXPECT_EQ(matrizNormal(traslacion({5, -3, 2}) * escalado({2, 1, 1})), matrizNormal(escalado({2, 1, 1})));
}

// §6.3: a una unidad no se le asigna un objeto textura, sino uno de cada tipo.
TEST(Libro, UnaUnidadGuardaUnaTexturaDeCadaTipo) {
    abreSonda();
    const struct {
        GLenum objetivo, enlace;
    } tipos[] = {{GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D},
                 {GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D},
                 {GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BINDING_CUBE_MAP}};
    GLuint texturas[3];
    glGenTextures(3, texturas);
    for (int i = 0; i < 3; ++i)
        glBindTexture(tipos[i].objetivo, texturas[i]);
    for (int i = 0; i < 3; ++i) {
        GLint enlazada;
        glGetIntegerv(tipos[i].enlace, &enlazada);
        EXPECT_EQ(GLuint(enlazada), texturas[i]);
    }
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    glDeleteTextures(3, texturas);
}
