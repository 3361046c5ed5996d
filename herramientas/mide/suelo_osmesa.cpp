// El suelo con que se compara el arranque de los programas: lo menos que se puede hacer con OSMesa para dejar
// en un PPM un triángulo iluminado de 240×180. Sin GLUT, sin GLEW y sin common/. Argumento: el fichero.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>
#include <cstdio>
#include <utility>
#include <vector>

static const int ANCHO = 240, ALTO = 180;

static const char *const VERTICES = R"(#version 140
in vec3 posicion;
out vec3 P;
void main() {
    P = posicion;
    gl_Position = vec4(posicion, 1.0);
})";
static const char *const FRAGMENTOS = R"(#version 140
uniform vec3 luz, color;
in vec3 P;
out vec4 colorFragmento;
void main() {
    vec3 n = vec3(0.0, 0.0, 1.0), L = normalize(luz - P), V = normalize(-P);
    float brillo = pow(max(dot(reflect(-L, n), V), 0.0), 16.0);
    colorFragmento = vec4(color * (0.2 + max(dot(n, L), 0.0)) + vec3(brillo), 1.0);
})";

static void usaPrograma() {
    const GLuint programa = glCreateProgram();
    for (const auto &[tipo, fuente] :
         {std::pair(GL_VERTEX_SHADER, VERTICES), {GL_FRAGMENT_SHADER, FRAGMENTOS}}) {
        const GLuint shader = glCreateShader(GLenum(tipo));
        glShaderSource(shader, 1, &fuente, nullptr);
        glCompileShader(shader);
        glAttachShader(programa, shader);
    }
    glBindAttribLocation(programa, 0, "posicion");
    glLinkProgram(programa);
    glUseProgram(programa);
    glUniform3f(glGetUniformLocation(programa, "luz"), -0.5f, 0.5f, 2);
    glUniform3f(glGetUniformLocation(programa, "color"), 0.7f, 0.2f, 0.1f);
}

static void enviaTriangulo() {
    const GLfloat vertices[] = {-0.8f, -0.7f, -0.5f, 0.8f, -0.7f, -0.5f, 0.0f, 0.8f, -0.5f};
    GLuint vao, buffer;
    glGenVertexArrays(1, &vao);
    glBindVertexArray(vao);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, sizeof vertices, vertices, GL_STATIC_DRAW);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(0);
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
    FILE *f = std::fopen(argv[1], "wb");
    if (!f)
        return 1;
    std::fprintf(f, "P6\n%d %d\n255\n", ANCHO, ALTO);
    for (int y = ALTO - 1; y >= 0; --y) // de abajo arriba, como los da OpenGL
        std::fwrite(&rgb[3 * ANCHO * y], 1, 3 * ANCHO, f);
    return std::fclose(f) == 0 ? 0 : 1;
}
