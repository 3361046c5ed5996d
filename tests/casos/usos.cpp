// BASE=… USO=… usos: una escena como la que escribe un estudiante, de una de dos bases (toro: un objeto con textura;
// grua: unas cajas iluminadas y sin lo de atrás), con uno de los usos de usos.inc: maneras legales de usar OpenGL, de
// que ./lab explica no debe sospechar, o errores que debe nombrar.
#include "malla.h"
#include <GL/glew.h>

#include <GL/freeglut.h>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

// clang-format off
static std::string VERT = R"(#version 140
uniform mat4 M, camara, proyeccion;
uniform mat3 N;
in vec3 posicion, vNormal;
in vec2 coordTextura;
out vec3 ecPosicion, normal;
out vec2 coord;
//global
void main() {
    ecPosicion = (camara * M * vec4(posicion, 1.0)).xyz;
    normal = normalize(N * vNormal);
    coord = coordTextura;
    gl_Position = proyeccion * camara * M * vec4(posicion, 1.0);
    //fin
}
)";
static std::string FRAG = R"(#version 140
uniform sampler2D Img;
uniform vec4 Lp;
uniform vec3 Ld, color;
in vec3 ecPosicion, normal;
in vec2 coord;
out vec4 colorFragmento;
//global
void main() {
    vec3 n = normalize(normal), L = normalize(Lp.xyz - ecPosicion), base = color * texture(Img, coord).rgb;
    //antes
    float alfa = 1.0;
    colorFragmento = vec4(base * (0.2 + max(dot(n, L), 0.0) * Ld), alfa);
    //fin
}
)";
// clang-format on

struct Pieza {
    glm::mat4 M;
    glm::vec3 color;
};

static bool enGrua;
static GLuint programa, vao, vbo, ebo, textura;
static Malla malla;
static std::vector<Pieza> piezas;
static glm::mat4 camara, proyeccion;
static glm::vec4 Lp(-3, 4, 3, 1);
static glm::vec3 Ld(0.8f);
static unsigned modo = GLUT_DOUBLE | GLUT_DEPTH | GLUT_STENCIL;
static GLbitfield borra = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT;
static std::function<void()> trasIniciar, trasUsar, antes, despues, alPieza, enviaLoDemas, dibujaPieza;

static void cambia(std::string &texto, const std::string &de, const std::string &a) {
    const std::size_t donde = texto.find(de);
    if (donde == texto.npos)
        std::fprintf(stderr, "usos: no está «%s»\n", de.c_str()), std::exit(1);
    for (std::size_t i = donde; i != texto.npos; i = texto.find(de, i + a.size()))
        texto.replace(i, de.size(), a);
}
// En el fragment shader: fuera de main, y antes de dar el color, que multiplica «base».
static void pon(const std::string &global, const std::string &cuerpo) {
    cambia(FRAG, "//global", global);
    cambia(FRAG, "//antes", cuerpo);
}
static GLint donde(const char *nombre) {
    return glGetUniformLocation(programa, nombre);
}
static const char *sinEnviar = "";
static void matriz(const char *nombre, const glm::mat4 &m) {
    if (std::strcmp(nombre, sinEnviar) != 0)
        glUniformMatrix4fv(donde(nombre), 1, GL_FALSE, glm::value_ptr(m));
}
static GLsizei cuantos() {
    return GLsizei(malla.indices.size());
}
static void pieza() {
    glDrawElements(GL_TRIANGLES, cuantos(), GL_UNSIGNED_INT, nullptr);
}
static void atributo(GLuint indice, GLint n, std::size_t desde, std::size_t paso = sizeof(Vertice)) {
    glVertexAttribPointer(indice, n, GL_FLOAT, GL_FALSE, GLsizei(paso), reinterpret_cast<void *>(desde));
    glEnableVertexAttribArray(indice);
}
static void lleva(std::size_t bytesVertices, std::size_t bytesIndices) {
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(bytesVertices), malla.vertices.data(), GL_STATIC_DRAW);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(bytesIndices), malla.indices.data(), GL_STATIC_DRAW);
}
// Otra textura, de 8×4×2, en la unidad y el objetivo que se diga: ningún lado como otro, ni una cara de un cubo.
static void imagen(GLenum unidad, GLenum objetivo, GLint formato = GL_RGB8, GLenum datos = GL_RGB,
                   GLenum tipo = GL_UNSIGNED_BYTE) {
    GLuint otra;
    std::vector<float> ruido(8 * 4 * 4 * 4);
    for (std::size_t i = 0; i < ruido.size(); ++i)
        if (tipo == GL_FLOAT)
            ruido[i] = float(i % 7) / 7;
        else
            std::memset(&ruido[i], int(60 + 37 * i % 190), sizeof(float));
    glGenTextures(1, &otra);
    glActiveTexture(GL_TEXTURE0 + unidad);
    glBindTexture(objetivo, otra);
    if (objetivo == GL_TEXTURE_1D)
        glTexImage1D(objetivo, 0, formato, 8, 0, datos, tipo, ruido.data());
    else if (objetivo == GL_TEXTURE_3D || objetivo == GL_TEXTURE_2D_ARRAY)
        glTexImage3D(objetivo, 0, formato, 8, 4, 2, 0, datos, tipo, ruido.data());
    else if (objetivo == GL_TEXTURE_CUBE_MAP)
        for (GLenum cara = 0; cara < 6; ++cara)
            glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + cara, 0, formato, 4, 4, 0, datos, tipo,
                         &ruido[5 * cara]);
    else
        glTexImage2D(objetivo, 0, formato, 8, 4, 0, datos, tipo, ruido.data());
    glTexParameteri(objetivo, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(objetivo, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glActiveTexture(GL_TEXTURE0);
}

struct Uso {
    const char *nombre;
    void (*haz)();
};
#define USO(nombre, debe, ...) {#nombre, [] { __VA_ARGS__; }},
static const Uso USOS[] = {
    {"nada", [] {}},
    {"caso", // de explica/casos.inc: en toda la ventana, ese fragment shader
     [] {
         VERT = "#version 140\nvoid main() {\n    gl_Position = vec4(4 * (gl_VertexID % 2) - 1, "
                "4 * (gl_VertexID / 2) - 1, 0.0, 1.0);\n}\n";
         FRAG = std::getenv("CASO");
         antes = [] { glUniform1i(donde("uno"), 1), glUniform1f(donde("medio"), 0.5f); };
         dibujaPieza = [] { glDrawArrays(GL_TRIANGLES, 0, 3); };
     }},
#include "usos.inc"
};

static GLuint compila(GLenum tipo, const std::string &texto) {
    const GLuint shader = glCreateShader(tipo);
    const GLchar *const suyo = texto.c_str();
    glShaderSource(shader, 1, &suyo, nullptr);
    glCompileShader(shader);
    GLint bien;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &bien);
    if (!bien) {
        char dice[2000];
        glGetShaderInfoLog(shader, sizeof dice, nullptr, dice);
        std::fprintf(stderr, "usos: %s\n", dice), std::exit(1);
    }
    return shader;
}

static void inicia() {
    programa = glCreateProgram();
    glAttachShader(programa, compila(GL_VERTEX_SHADER, VERT));
    glAttachShader(programa, compila(GL_FRAGMENT_SHADER, FRAG));
    const char *const ATRIBUTOS[] = {"posicion", "vNormal", "coordTextura"};
    for (GLuint i = 0; i < 3; ++i)
        glBindAttribLocation(programa, i, ATRIBUTOS[i]);
    glLinkProgram(programa);
    glGenVertexArrays(1, &vao);
    glBindVertexArray(vao);
    glGenBuffers(1, &vbo);
    glBindBuffer(GL_ARRAY_BUFFER, vbo);
    glGenBuffers(1, &ebo);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, ebo);
    lleva(malla.vertices.size() * sizeof(Vertice), malla.indices.size() * sizeof(unsigned));
    atributo(0, 3, offsetof(Vertice, posicion));
    atributo(1, 3, offsetof(Vertice, normal));
    atributo(2, 2, offsetof(Vertice, coordTextura));
    std::vector<unsigned char> damas;
    for (int i = 0; i < 32 * 8; ++i)
        damas.insert(damas.end(), 3, (i / 8 + i / 64) % 2 ? 255 : 160);
    glGenTextures(1, &textura);
    glBindTexture(GL_TEXTURE_2D, textura);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, 32, 8, 0, GL_RGB, GL_UNSIGNED_BYTE, damas.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glEnable(GL_DEPTH_TEST);
    if (enGrua)
        glEnable(GL_CULL_FACE);
    glClearColor(0.9f, 0.93f, 0.96f, 1);
    if (trasIniciar)
        trasIniciar();
}

static void dibuja() {
    glClear(borra);
    glUseProgram(programa);
    if (trasUsar)
        trasUsar();
    matriz("camara", camara);
    matriz("proyeccion", proyeccion);
    glUniform4fv(donde("Lp"), 1, glm::value_ptr(Lp));
    glUniform3fv(donde("Ld"), 1, glm::value_ptr(Ld));
    if (antes)
        antes();
    for (const Pieza &p : piezas) {
        const glm::mat3 N = glm::transpose(glm::inverse(glm::mat3(camara * p.M)));
        matriz("M", p.M);
        if (std::strcmp("N", sinEnviar) != 0)
            glUniformMatrix3fv(donde("N"), 1, GL_FALSE, glm::value_ptr(N));
        glUniform3fv(donde("color"), 1, glm::value_ptr(p.color));
        if (alPieza)
            alPieza();
        (dibujaPieza ? dibujaPieza : pieza)();
    }
    if (despues)
        despues();
    glutSwapBuffers();
}

int main(int argc, char **argv) {
    const auto pide = [](const char *cual) {
        return std::string(std::getenv(cual) ? std::getenv(cual) : "");
    };
    const std::string uso = pide("USO");
    enGrua = pide("BASE") == "grua";
    malla = enGrua ? cubo() : toro(1, 0.4f, 24, 12);
    camara = enGrua ? glm::lookAt(glm::vec3(4, 4, 9), glm::vec3(0, 2, 0), glm::vec3(0, 1, 0))
                    : glm::lookAt(glm::vec3(0, 1.5f, 4), glm::vec3(0, 0, 0), glm::vec3(0, 1, 0)) *
                          glm::translate(glm::mat4(1), {-0.9f, 0, 0});
    proyeccion = glm::perspective(0.7f, 4 / 3.0f, 0.5f, 50.0f);
    const auto caja = [](float x, float y, float z, float ancho, float alto, float hondo, glm::vec3 color) {
        piezas.push_back({glm::scale(glm::translate(glm::mat4(1), {x, y, z}), {ancho, alto, hondo}), color});
    };
    if (enGrua) {
        caja(0, -0.1f, 0, 5, 0.2f, 4, {0.4f, 0.5f, 0.4f});
        caja(0, 1.8f, 0, 0.5f, 3.6f, 0.5f, {0.9f, 0.7f, 0.1f});
        caja(0.8f, 3.4f, 0, 3.4f, 0.4f, 0.4f, {0.9f, 0.7f, 0.1f});
        caja(2.1f, 2, 0, 0.7f, 0.7f, 0.7f, {0.7f, 0.2f, 0.2f});
    } else {
        piezas.push_back({glm::rotate(glm::mat4(1), 0.3f, {1, 0, 0}), {0.8f, 0.8f, 0.9f}});
    }
    for (const Uso &u : USOS)
        if (uso == u.nombre)
            u.haz();
    glutInit(&argc, argv);
    glutInitDisplayMode(modo);
    glutInitContextVersion(3, 1);
    glutInitWindowSize(240, 180);
    glutCreateWindow("usos");
    glewExperimental = GL_TRUE;
    glewInit();
    inicia();
    glutDisplayFunc(dibuja);
    glutMainLoop();
    return 0;
}
