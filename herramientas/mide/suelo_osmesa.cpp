// El suelo con que se compara el arranque de los programas: lo menos que se puede hacer con OSMesa para dejar
// en un PPM un triángulo iluminado de 240×180. Sin GLUT, sin GLEW y sin common/. Argumento: el fichero.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>
#include <cstdio>
#include <vector>

static const int ANCHO = 240, ALTO = 180;

static GLuint compila(GLenum tipo, const char *fuente) {
    const GLuint shader = glCreateShader(tipo);
    glShaderSource(shader, 1, &fuente, nullptr);
    glCompileShader(shader);
    return shader;
}

static void usaPrograma() {
    const GLuint programa = glCreateProgram();
    glAttachShader(programa, compila(GL_VERTEX_SHADER, R"(#version 140
in vec3 posicion, normal;
uniform mat4 camara, proyeccion;
out vec3 N, P;
void main() {
    vec4 p = camara * vec4(posicion, 1.0);
    P = p.xyz;
    N = mat3(camara) * normal;
    gl_Position = proyeccion * p;
})"));
    glAttachShader(programa, compila(GL_FRAGMENT_SHADER, R"(#version 140
uniform vec3 luz, color;
in vec3 N, P;
out vec4 colorFragmento;
void main() {
    vec3 n = normalize(N), L = normalize(luz - P), V = normalize(-P);
    float brillo = pow(max(dot(reflect(-L, n), V), 0.0), 16.0);
    colorFragmento = vec4(color * (0.2 + max(dot(n, L), 0.0)) + vec3(brillo), 1.0);
})"));
    glBindAttribLocation(programa, 0, "posicion");
    glBindAttribLocation(programa, 1, "normal");
    glLinkProgram(programa);
    glUseProgram(programa);
    const GLfloat identidad[] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    glUniformMatrix4fv(glGetUniformLocation(programa, "camara"), 1, GL_FALSE, identidad);
    glUniformMatrix4fv(glGetUniformLocation(programa, "proyeccion"), 1, GL_FALSE, identidad);
    glUniform3f(glGetUniformLocation(programa, "luz"), -0.5f, 0.5f, 2);
    glUniform3f(glGetUniformLocation(programa, "color"), 0.7f, 0.2f, 0.1f);
}

static void enviaTriangulo() {
    const GLfloat vertices[] = {-0.8f, -0.7f, -0.5f, 0,    0,    1,     0.8f, -0.7f, -0.5f,
                                0,     0,     1,     0.0f, 0.8f, -0.5f, 0,    0,     1};
    GLuint vao, buffer;
    glGenVertexArrays(1, &vao);
    glBindVertexArray(vao);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, sizeof vertices, vertices, GL_STATIC_DRAW);
    for (GLuint i = 0; i < 2; ++i) {
        glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, 6 * sizeof(GLfloat),
                              reinterpret_cast<const void *>(3 * i * sizeof(GLfloat)));
        glEnableVertexAttribArray(i);
    }
}

// De abajo arriba, como los da OpenGL.
static bool guarda(const char *fichero, const std::vector<unsigned char> &rgb) {
    FILE *f = std::fopen(fichero, "wb");
    if (!f)
        return false;
    std::fprintf(f, "P6\n%d %d\n255\n", ANCHO, ALTO);
    for (int y = ALTO - 1; y >= 0; --y)
        std::fwrite(&rgb[3 * ANCHO * y], 1, 3 * ANCHO, f);
    return std::fclose(f) == 0;
}

int main(int argc, char **argv) {
    // clang-format off
    const int atributos[] = {OSMESA_FORMAT, OSMESA_RGBA,
                             OSMESA_DEPTH_BITS, 24,
                             OSMESA_PROFILE, OSMESA_CORE_PROFILE,
                             OSMESA_CONTEXT_MAJOR_VERSION, 3,
                             OSMESA_CONTEXT_MINOR_VERSION, 1,
                             0};
    // clang-format on
    std::vector<unsigned char> memoria(4 * ANCHO * ALTO), rgb(3 * ANCHO * ALTO);
    const OSMesaContext contexto = OSMesaCreateContextAttribs(atributos, nullptr);
    if (argc < 2 || !contexto || !OSMesaMakeCurrent(contexto, memoria.data(), GL_UNSIGNED_BYTE, ANCHO, ALTO))
        return 1;
    usaPrograma();
    enviaTriangulo();
    glEnable(GL_DEPTH_TEST);
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, ANCHO, ALTO, GL_RGB, GL_UNSIGNED_BYTE, rgb.data());
    return guarda(argv[1], rgb) ? 0 : 1;
}
