// Lo que el libro pone mal y no es de ningún programa (docs/erratas.md): lo que no compila, lo que OpenGL 3.1 ya no tiene y lo que
// GLSL entiende de otra manera. Cada prueba dice de qué parte del libro es.
#include "ch03_transformaciones/transformaciones.h"
#include "ch04_vista3d/vista.h"
#include "sonda.h"
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <string>
#include <type_traits>

namespace {

/// Si compila un fragment shader con esas declaraciones y ese main.
GLuint compila(const std::string &declaraciones, const std::string &cuerpo) {
    const std::string texto =
        "#version 140\nout vec4 colorFragmento;\n" + declaraciones + "\nvoid main() {\n" + cuerpo + "\n}\n";
    const char *fuente = texto.c_str();
    const GLuint shader = glCreateShader(GL_FRAGMENT_SHADER);
    glShaderSource(shader, 1, &fuente, nullptr);
    glCompileShader(shader);
    GLint bien = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &bien);
    return bien ? shader : 0;
}

class Gl : public testing::Test {
protected:
    static GLuint programa;
    static void SetUpTestSuite() {
        programa = creaSonda("tests/capitulos/erratas.frag");
    }
    void SetUp() override {
        glDebugMessageCallback(nullptr, nullptr); // estas pruebas buscan el error; que no acabe con ellas
        glUseProgram(programa);
    }
    static glm::vec4 glsl(int cual, const glm::vec4 &v = glm::vec4(0), const glm::mat4 &M = glm::mat4(1)) {
        envia(programa, "cual", cual);
        envia(programa, "v", v);
        envia(programa, "M", M);
        return leeSonda();
    }
};
GLuint Gl::programa;

} // namespace

// --- lo que no es C++ ---

// Listado 1.3: std::string msgs(' ', len).
TEST(Cpp, LosArgumentosDeStringDelListado13) {
    const int len = 65;
    EXPECT_EQ(std::string(' ', static_cast<char>(len)), std::string(32, 'A'));
    EXPECT_EQ(std::string(len, ' ').size(), 65u);
}

// Listado 1.3: glGetShaderiv pide un GLint *; listado 6.2: leeTextura(char *) no admite un literal.
TEST(Cpp, LosPunterosDeLosListados13y61) {
    EXPECT_FALSE((std::is_convertible_v<GLuint *, GLint *>));
    EXPECT_FALSE((std::is_convertible_v<const char(&)[10], char *>));
    EXPECT_TRUE((std::is_convertible_v<const char(&)[10], const char *>));
}

// §10.2.
TEST(Cpp, LosMenusDelListado101) {
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
    EXPECT_EQ(glGetAttribLocation(programa, "noEsta"), -1);
    EXPECT_EQ(glGetUniformLocation(programa, "noEsta"), -1);
}

// Listado 2.4: con un VAO, desenlazar el buffer de índices antes que él se lo quita.
TEST_F(Gl, DesenlazarLosIndicesLosQuitaDelVao) {
    GLuint vao = 0, indices = 0;
    GLint anterior = 0, enlazado = 0;
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &anterior);
    glGenVertexArrays(1, &vao);
    glBindVertexArray(vao);
    glGenBuffers(1, &indices);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
    glBindVertexArray(0);
    glBindVertexArray(vao);
    glGetIntegerv(GL_ELEMENT_ARRAY_BUFFER_BINDING, &enlazado);
    EXPECT_EQ(static_cast<GLuint>(enlazado), indices);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0); // la última línea del listado
    glBindVertexArray(0);
    glBindVertexArray(vao);
    glGetIntegerv(GL_ELEMENT_ARRAY_BUFFER_BINDING, &enlazado);
    EXPECT_EQ(enlazado, 0);
    glBindVertexArray(static_cast<GLuint>(anterior));
}

// §6.2.2.
TEST_F(Gl, GlClampNoExiste) {
    GLuint textura = 0;
    glGenTextures(1, &textura);
    glBindTexture(GL_TEXTURE_2D, textura);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM));
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
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
}

// --- GLSL ---

// Listado 9.3.
TEST_F(Gl, ElListado93NoCompila) {
    EXPECT_NE(compila("const int tallaFiltro = 9;", "colorFragmento = vec4(tallaFiltro);"), 0u);
    EXPECT_EQ(compila("const int tallaFiltro 9;", "colorFragmento = vec4(tallaFiltro);"), 0u);
    const std::string imagen = "uniform sampler2D imagen;";
    EXPECT_NE(compila(imagen, "colorFragmento = texture(imagen, vec2(0.5));"), 0u);
    EXPECT_EQ(compila(imagen, "colorFragmento = textura(imagen, vec2(0.5));"), 0u);
}

// §8.3: donde aún compila, no es ruido.
TEST_F(Gl, NoiseNoExisteODaCero) {
    const GLuint shader = compila("uniform float x;",
                                  "colorFragmento = vec4(noise1(x), noise1(2.0 * x), noise1(x + 0.3), 1.0);");
    if (shader == 0)
        return;
    const GLuint ruido = creaSonda("tests/capitulos/erratas.frag"); // con el vertex shader de la sonda
    GLuint partes[2];
    GLsizei cuantas = 0;
    glGetAttachedShaders(ruido, 2, &cuantas, partes);
    for (GLsizei i = 0; i < cuantas; ++i) {
        GLint tipo = 0;
        glGetShaderiv(partes[i], GL_SHADER_TYPE, &tipo);
        if (tipo == GL_FRAGMENT_SHADER)
            glDetachShader(ruido, partes[i]);
    }
    glAttachShader(ruido, shader);
    glLinkProgram(ruido);
    glUseProgram(ruido);
    for (float x = 0.1f; x < 20; x += 0.37f) {
        glUniform1f(glGetUniformLocation(ruido, "x"), x); // que puede haber desaparecido con ellas
        EXPECT_EQ(leeSonda(), glm::vec4(0, 0, 0, 1)) << x;
    }
}

// §1.5: «vec4 a = b * c» toma b como una fila: es la traspuesta de c por b, y no lo que hace el resto del libro, c·b.
TEST_F(Gl, UnVectorPorUnaMatrizEsUnaFila) {
    const glm::mat4 M = giroZ(0.5f) * traslacion({1, 2, 3});
    const glm::vec4 v(1, 2, 3, 1);
    const auto cerca = [](const glm::vec4 &a, const glm::vec4 &b) { return glm::distance(a, b) < 1e-5f; };
    EXPECT_TRUE(cerca(glsl(0, v, M), glm::transpose(M) * v));
    EXPECT_FALSE(cerca(glsl(0, v, M), M * v));
    EXPECT_TRUE(cerca(glsl(1, v, M), M * v));
}

// §9.1.2: 1 − color hace transparente lo opaco.
TEST_F(Gl, ElNegativoDelLibroEsTransparente) {
    EXPECT_EQ(glsl(2, {0.2f, 0.5f, 1, 1}).w, 0);
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

// §4.2: «preservar longitudes y ángulos» solo lo hace la proyección paralela con lo que es paralelo al plano de proyección.
// En la vista (1, 1, 1) un cubo tiene sus aristas acortadas a √(2/3) y a 120 grados.
TEST(Libro, LaParalelaNoConservaLongitudesNiAngulos) {
    const glm::dmat4 M =
        proyeccionParalela(-1, 1, -1, 1, -10, 10) * transformacionCamara({1, 1, 1}, {0, 0, 0}, {0, 1, 0});
    glm::dvec2 aristas[3];
    for (int i = 0; i < 3; ++i)
        aristas[i] = glm::dvec2(M[i]);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(glm::length(aristas[i]), std::sqrt(2.0 / 3), 1e-12);
        EXPECT_NEAR(glm::dot(aristas[i], aristas[(i + 1) % 3]), -0.5 * 2 / 3, 1e-12);
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
