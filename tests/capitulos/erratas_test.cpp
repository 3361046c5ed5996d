// Lo que el libro pone mal y no es de ningún programa (docs/erratas.md): lo que no compila, lo que OpenGL 3.1 ya no
// tiene y lo que GLSL entiende de otra manera. Cada prueba dice de qué parte del libro es.
#include "ch03_transformaciones/transformaciones.h"
#include "ch04_vista3d/vista.h"
#include "ejecuta.h"
#include "sonda.h"
#include <fstream>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <string>
#include <type_traits>

namespace {

class Gl : public testing::Test {
protected:
    GLint vao = 0; // el que usa la sonda

    void SetUp() override {
        static const GLuint sonda =
            creaSonda("tests/capitulos/ch05_listado.frag"); // una, para abrir la ventana
        glUseProgram(sonda);
        glDebugMessageCallback(nullptr, nullptr); // estas pruebas buscan el error; que no acabe con ellas
        glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &vao);
    }
    /// La sonda con esas declaraciones y ese color, ya en uso; 0 si no compila.
    static GLuint compila(const std::string &declaraciones, const std::string &color) {
        const std::string fichero = carpetaTemporal() / "prueba.frag";
        std::ofstream(fichero) << "#version 140\nout vec4 colorFragmento;\n"
                               << declaraciones << "\nvoid main() {\n    colorFragmento = " << color
                               << ";\n}\n";
        std::string error;
        const GLuint programa = intentaPrograma("tests/apoyo/sonda.vert", fichero, error);
        glUseProgram(programa);
        return programa;
    }
    static void esperaError(GLenum error) {
        EXPECT_EQ(glGetError(), error);
    }
};

} // namespace

// --- lo que no es C++ ---

// Listado 1.3: std::string msgs(' ', len) y un GLuint * donde se pide un GLint *; listado 6.2: leeTextura(char *) no admite un literal;
// y §10.2, los menús.
TEST(Cpp, LosArgumentosQueNoSon) {
    const int len = 65;
    EXPECT_EQ(std::string(' ', char(len)), std::string(32, 'A'));
    EXPECT_EQ(std::string(len, ' ').size(), 65u);
    EXPECT_FALSE((std::is_convertible_v<GLuint *, GLint *>));
    EXPECT_FALSE((std::is_convertible_v<const char(&)[10], char *>));
    EXPECT_TRUE((std::is_convertible_v<const char(&)[10], const char *>));
    EXPECT_TRUE((std::is_same_v<decltype(&glutAddMenuEntry), void (*)(const char *, int)>));
    EXPECT_TRUE((std::is_same_v<decltype(&glutAddSubMenu), void (*)(const char *, int)>));
}

// Listado 1.3 (FALSE), §6.5 (glUniformi) y §9.3 (GL_SAMPLES_BUFFERS).
TEST(Cpp, LosNombresQueNoExisten) {
#if defined(FALSE) || defined(glUniformi) || defined(GL_SAMPLES_BUFFERS)
    ADD_FAILURE() << "sí existen";
#endif
#if !defined(GL_FALSE) || !defined(glUniform1i) || !defined(GL_SAMPLE_BUFFERS)
    ADD_FAILURE() << "no existen los buenos";
#endif
}

// --- lo que OpenGL 3.1 ya no tiene, o exige ---

// Listado 2.3 y listado 6.2: en un GLuint, el −1 de lo que no está no se ve.
TEST_F(Gl, LoQueNoEstaEnElShaderValeMenosUno) {
    const GLuint programa = compila("", "vec4(1.0)");
    EXPECT_EQ(glGetAttribLocation(programa, "noEsta"), -1);
    EXPECT_EQ(glGetUniformLocation(programa, "noEsta"), -1);
}

// Listado 2.4 dibuja sin VAO: un contexto core lo rechaza. Con uno, aunque esté vacío, el mismo dibujo es válido.
TEST_F(Gl, SinVaoNoSeDibuja) {
    glBindVertexArray(0);
    glDrawArrays(GL_POINTS, 0, 1);
    esperaError(GL_INVALID_OPERATION);
    glBindVertexArray(GLuint(vao));
    glDrawArrays(GL_POINTS, 0, 1);
    esperaError(GL_NO_ERROR);
}

// Listado 2.4: con un VAO, desenlazar el buffer de índices antes que él se lo quita.
TEST_F(Gl, DesenlazarLosIndicesLosQuitaDelVao) {
    GLuint otro = 0, indices = 0;
    glGenVertexArrays(1, &otro);
    glGenBuffers(1, &indices);
    for (const GLuint enlazado : {indices, 0u}) { // el 0 es la última línea del listado
        glBindVertexArray(otro);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, enlazado);
        glBindVertexArray(GLuint(vao));
        glBindVertexArray(otro);
        GLint quedan = -1;
        glGetIntegerv(GL_ELEMENT_ARRAY_BUFFER_BINDING, &quedan);
        EXPECT_EQ(GLuint(quedan), enlazado);
    }
    glBindVertexArray(GLuint(vao));
}

// §6.2.2.
TEST_F(Gl, GlClampNoExiste) {
    GLuint textura = 0;
    glGenTextures(1, &textura);
    glBindTexture(GL_TEXTURE_2D, textura);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    esperaError(GL_NO_ERROR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP);
    esperaError(GL_INVALID_ENUM);
}

// §6.3: no 4, sino 16.
TEST_F(Gl, HayAlMenos16UnidadesDeTextura) {
    GLint unidades = 0;
    glGetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &unidades);
    EXPECT_GE(unidades, 16);
}

// §9.1 y §9.1.4.
TEST_F(Gl, GlDrawPixelsNoExiste) {
    const unsigned char rgb[4] = {};
    glDrawPixels(1, 1, GL_RGB, GL_UNSIGNED_BYTE, rgb);
    esperaError(GL_INVALID_OPERATION);
}

// --- GLSL ---

// Listado 9.3.
TEST_F(Gl, ElListado93NoCompila) {
    EXPECT_NE(compila("const int tallaFiltro = 9;", "vec4(tallaFiltro)"), 0u);
    EXPECT_EQ(compila("const int tallaFiltro 9;", "vec4(tallaFiltro)"), 0u);
    EXPECT_NE(compila("uniform sampler2D imagen;", "texture(imagen, vec2(0.5))"), 0u);
    EXPECT_EQ(compila("uniform sampler2D imagen;", "textura(imagen, vec2(0.5))"), 0u);
}

// §8.3: donde aún compila, no es ruido.
TEST_F(Gl, NoiseNoExisteODaCero) {
    const GLuint ruido =
        compila("uniform float x;", "vec4(noise1(x), noise1(2.0 * x), noise1(x + 0.3), 1.0)");
    for (float x = 0.1f; ruido && x < 20; x += 0.37f) {
        glUniform1f(glGetUniformLocation(ruido, "x"), x); // que puede haber desaparecido con ellas
        EXPECT_EQ(leeSonda(), glm::vec4(0, 0, 0, 1)) << x;
    }
}

// §1.5: «vec4 a = b * c» toma b como una fila: es la traspuesta de c por b, y no lo que hace el resto del libro, c·b.
TEST_F(Gl, UnVectorPorUnaMatrizEsUnaFila) {
    const glm::mat4 M = giroZ(0.5f) * traslacion({1, 2, 3});
    const glm::vec4 v(1, 2, 3, 1);
    const auto da = [&](const std::string &producto, const glm::vec4 &esperado) {
        const GLuint programa = compila("uniform vec4 v;\nuniform mat4 M;", producto);
        envia(programa, "v", v);
        envia(programa, "M", M);
        return glm::distance(leeSonda(), esperado) < 1e-5f;
    };
    EXPECT_TRUE(da("v * M", glm::transpose(M) * v));
    EXPECT_FALSE(da("v * M", M * v));
    EXPECT_TRUE(da("M * v", M * v));
}

// §9.1.2: 1 − color hace transparente lo opaco.
TEST_F(Gl, ElNegativoDelLibroEsTransparente) {
    EXPECT_NE(compila("", "1.0 - vec4(0.2, 0.5, 1.0, 1.0)"), 0u);
    EXPECT_EQ(leeSonda().w, 0);
}

// Listado 5.1: suma también las opacidades; con las de la tabla 5.1, que valen 1, pasa de 1.
TEST_F(Gl, ElListado51SumaLasOpacidades) {
    const GLuint listado = creaSonda("tests/capitulos/ch05_listado.frag");
    glUseProgram(listado);
    for (const char *color : {"Ka", "Kd", "Ks", "La", "Ld", "Ls"})
        envia(listado, color, glm::vec4(0.5f, 0.5f, 0.5f, 1));
    envia(listado, "Lp", glm::vec4(0, 0, 0, 1));
    envia(listado, "alfa", 10.0f);
    envia(listado, "P", glm::vec3(0, 0, -1));
    envia(listado, "N", glm::vec3(0, 0, 1));
    EXPECT_NEAR(leeSonda().w, 3, 1e-5);
}

// --- matemáticas ---

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
    EXPECT_EQ(matrizNormal(traslacion({5, -3, 2})), glm::mat3(1));
    EXPECT_EQ(matrizNormal(traslacion({5, -3, 2}) * escalado({2, 1, 1})), matrizNormal(escalado({2, 1, 1})));
}

// §3.5: las funciones de GLM multiplican la matriz que se les da, y piden radianes.
TEST(Libro, LasFuncionesDeGlmDeAhora) {
    EXPECT_EQ(glm::translate(glm::mat4(1), {10, 0, 0}) * glm::scale(glm::mat4(1), glm::vec3(2)),
              traslacion({10, 0, 0}) * escalado(2));
    const glm::vec4 x = glm::rotate(glm::mat4(1), glm::half_pi<float>(), {0, 0, 1}) * glm::vec4(1, 0, 0, 1);
    EXPECT_NEAR(x.y, 1, 1e-6);
}
