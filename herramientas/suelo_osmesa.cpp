// El suelo con que se compara el arranque de los programas: lo menos que se puede hacer con OSMesa para dejar
// en un PPM un triángulo de 240×180. Sin GLUT, sin GLEW y sin common/. Argumento: el fichero.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>
#include <cstdio>
#include <vector>

static GLuint compila(GLenum tipo, const char *fuente) {
    const GLuint shader = glCreateShader(tipo);
    glShaderSource(shader, 1, &fuente, nullptr);
    glCompileShader(shader);
    return shader;
}

int main(int argc, char **argv) {
    const int ancho = 240, alto = 180;
    const int atributos[] = {OSMESA_FORMAT,
                             OSMESA_RGBA,
                             OSMESA_DEPTH_BITS,
                             24,
                             OSMESA_PROFILE,
                             OSMESA_CORE_PROFILE,
                             OSMESA_CONTEXT_MAJOR_VERSION,
                             3,
                             OSMESA_CONTEXT_MINOR_VERSION,
                             1,
                             0};
    std::vector<unsigned char> memoria(4 * ancho * alto), rgb(3 * ancho * alto);
    const OSMesaContext contexto = OSMesaCreateContextAttribs(atributos, nullptr);
    if (argc < 2 || !contexto || !OSMesaMakeCurrent(contexto, memoria.data(), GL_UNSIGNED_BYTE, ancho, alto))
        return 1;

    const GLuint programa = glCreateProgram();
    glAttachShader(programa,
                   compila(GL_VERTEX_SHADER, "#version 140\nin vec2 posicion;\n"
                                             "void main() { gl_Position = vec4(posicion, 0.0, 1.0); }\n"));
    glAttachShader(programa,
                   compila(GL_FRAGMENT_SHADER, "#version 140\nout vec4 color;\n"
                                               "void main() { color = vec4(1.0, 0.0, 0.0, 1.0); }\n"));
    glLinkProgram(programa);
    glUseProgram(programa);

    const GLfloat vertices[] = {-0.8f, -0.7f, 0.8f, -0.7f, 0.0f, 0.8f};
    GLuint vao, buffer;
    glGenVertexArrays(1, &vao);
    glBindVertexArray(vao);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, sizeof vertices, vertices, GL_STATIC_DRAW);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(0);
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, ancho, alto, GL_RGB, GL_UNSIGNED_BYTE, rgb.data());

    FILE *f = std::fopen(argv[1], "wb");
    if (!f)
        return 1;
    std::fprintf(f, "P6\n%d %d\n255\n", ancho, alto);
    for (int y = alto - 1; y >= 0; --y)
        std::fwrite(&rgb[3 * ancho * y], 1, 3 * ancho, f);
    return std::fclose(f) == 0 ? 0 : 1;
}
