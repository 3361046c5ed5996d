// Lo que ocupa lo que el programa ha enviado a la GPU, y la opción -mide: eso y lo que cuesta dibujar una imagen.
#include "error.h"
#include "interior.h"
#include <GL/glew.h>
#include <GL/freeglut.h>
#include <algorithm>
#include <chrono>
#include <cstdio>

namespace sin_ventana {
namespace {

// Mesa da los nombres seguidos, y los de shaders no los vuelve a dar: tras tantos sin nada no queda ninguno.
const GLuint HUECO = 1024;

GLint parametro(GLenum objetivo, GLint nivel, GLenum cual) {
    GLint n = 0; // lo que queda si no hay ese nivel
    glGetTexLevelParameteriv(objetivo, nivel, cual, &n);
    return n;
}

void olvidaErrores() {
    while (glGetError() != GL_NO_ERROR) {
    }
}

const struct {
    GLenum objetivo, enlazada;
} OBJETIVOS[] = {{GL_TEXTURE_1D, GL_TEXTURE_BINDING_1D},
                 {GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D},
                 {GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D},
                 {GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BINDING_CUBE_MAP},
                 {GL_TEXTURE_RECTANGLE, GL_TEXTURE_BINDING_RECTANGLE}};

// Con sus mipmaps. Es textura de ese objetivo.
long long bytesDeNiveles(GLenum objetivo) {
    const bool cubo = objetivo == GL_TEXTURE_CUBE_MAP;
    const GLenum cara = cubo ? GL_TEXTURE_CUBE_MAP_POSITIVE_X : objetivo;
    long long bytes = 0, texels = 1;
    for (GLint nivel = 0; texels > 0; ++nivel) {
        texels = cubo ? 6 : 1;
        for (const GLenum lado : {GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_DEPTH})
            texels *= parametro(cara, nivel, lado);
        GLint bits = 0;
        for (const GLenum talla : {GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_BLUE_SIZE,
                                   GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_DEPTH_SIZE})
            bits += parametro(cara, nivel, talla);
        bytes += texels * bits / 8;
    }
    olvidaErrores(); // el de pedir un nivel de más
    return bytes;
}

// Solo el objetivo con el que se creó no da un error al enlazarla.
long long bytesDeTextura(GLuint nombre) {
    for (const auto &[objetivo, enlazada] : OBJETIVOS) {
        GLint anterior = 0;
        glGetIntegerv(enlazada, &anterior);
        glBindTexture(objetivo, nombre);
        if (glGetError() != GL_NO_ERROR)
            continue;
        const long long bytes = bytesDeNiveles(objetivo);
        glBindTexture(objetivo, GLuint(anterior));
        return bytes;
    }
    return 0;
}

long long bytesDeBufer(GLuint nombre) {
    GLint bytes = 0, anterior = 0;
    glGetIntegerv(GL_COPY_READ_BUFFER_BINDING, &anterior);
    glBindBuffer(GL_COPY_READ_BUFFER, nombre);
    glGetBufferParameteriv(GL_COPY_READ_BUFFER, GL_BUFFER_SIZE, &bytes);
    glBindBuffer(GL_COPY_READ_BUFFER, GLuint(anterior));
    return bytes;
}

} // namespace

Ocupado ocupado() {
    Ocupado o;
    glDisable(GL_DEBUG_OUTPUT); // para buscar los objetivos hay que equivocarse
    GLuint vacios = 0;
    for (GLuint nombre = 1; vacios < HUECO; ++nombre) {
        const int antes = o.objetos();
        if (glIsBuffer(nombre)) {
            ++o.buferes;
            o.bytesBuferes += bytesDeBufer(nombre);
        }
        if (glIsTexture(nombre)) {
            ++o.texturas;
            o.bytesTexturas += bytesDeTextura(nombre);
        }
        o.programas += glIsProgram(nombre);
        o.shaders += glIsShader(nombre);
        o.framebuffers += glIsFramebuffer(nombre);
        o.renderbuffers += glIsRenderbuffer(nombre);
        o.vaos += glIsVertexArray(nombre);
        vacios = o.objetos() == antes ? vacios + 1 : 0;
    }
    glEnable(GL_DEBUG_OUTPUT);
    return o;
}

double milisegundosDe(void (*f)()) {
    const auto antes = std::chrono::steady_clock::now();
    f();
    glFinish();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - antes).count();
}

void mideCuadros(int cuadros, double primera) {
    glewExperimental = GL_TRUE;
    glewInit(); // el programa puede no haberlo necesitado
    GLuint consulta = 0, primitivas = 0;
    glGenQueries(1, &consulta);
    glBeginQuery(GL_PRIMITIVES_GENERATED, consulta);
    dibujaCuadro();
    glEndQuery(GL_PRIMITIVES_GENERATED);
    glGetQueryObjectuiv(consulta, GL_QUERY_RESULT, &primitivas);

    std::vector<double> ms;
    for (int i = 0; i < cuadros; ++i)
        ms.push_back(milisegundosDe(dibujaCuadro));
    std::sort(ms.begin(), ms.end());
    compruebaGL("al medir");
    const Ocupado o = ocupado();
    std::printf("%s\t%dx%d\t%.3f\t%.3f\t%.3f\t%.3f\t%u\t%s\t%lld\t%lld\n", nombrePrograma().c_str(),
                glutGet(GLUT_WINDOW_WIDTH), glutGet(GLUT_WINDOW_HEIGHT), primera, ms[ms.size() / 2],
                ms.front(), ms.back(), primitivas, reinterpret_cast<const char *>(glGetString(GL_RENDERER)),
                o.bytesBuferes, o.bytesTexturas);
}

} // namespace sin_ventana
