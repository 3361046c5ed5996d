// Se antepone (LD_PRELOAD) a un programa sin ventana. Acabado el guion lo dibuja otra vez o, si detrás va lo que lo
// explica, deja que lo explique, y escribe en $PREGUNTA, de cada glClear, glDrawArrays y glDrawElements, lo que OpenGL
// contesta a todo lo que de ella dice ./lab explica: en números y sin decidir nada (propiedades/preguntado.py).
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <cstdint>
#include <cstdlib>
#include <dlfcn.h>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

std::ofstream salida;

void di(const std::string &que, const std::vector<double> &numeros) {
    salida << que;
    for (const double n : numeros)
        salida << ' ' << n;
    salida << '\n';
}

template<class Funcion, class... Parametros>
double da(Funcion funcion, Parametros... parametros) {
    GLint n[4] = {};
    funcion(parametros..., n);
    return n[0];
}

void diAtributo(GLuint programa, const std::string &nombre) {
    const GLint donde = glGetAttribLocation(programa, nombre.c_str());
    if (donde < 0) // gl_VertexID
        return;
    void *desde = nullptr;
    glGetVertexAttribPointerv(GLuint(donde), GL_VERTEX_ATTRIB_ARRAY_POINTER, &desde);
    std::vector<double> todo = {double(reinterpret_cast<std::intptr_t>(desde))};
    for (const GLenum que : {GL_VERTEX_ATTRIB_ARRAY_ENABLED, GL_VERTEX_ATTRIB_ARRAY_SIZE,
                             GL_VERTEX_ATTRIB_ARRAY_TYPE, GL_VERTEX_ATTRIB_ARRAY_STRIDE})
        todo.push_back(da(glGetVertexAttribiv, GLuint(donde), que));
    di("atributo " + nombre, todo);
}

void diUniform(GLuint programa, const std::string &nombre) { // de un array, el primero
    GLfloat v[16] = {};
    if (const GLint donde = glGetUniformLocation(programa, nombre.c_str()); donde >= 0)
        glGetUniformfv(programa, donde, v), di("uniform " + nombre, {v, v + 16});
}

void diTextura(int unidad) {
    glActiveTexture(GLenum(GL_TEXTURE0 + unidad));
    std::vector<double> todo = {da(glGetIntegerv, GL_TEXTURE_BINDING_2D)};
    for (const GLenum que : {GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_INTERNAL_FORMAT})
        todo.push_back(da(glGetTexLevelParameteriv, GL_TEXTURE_2D, 0, que));
    for (const GLenum que :
         {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER, GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        todo.push_back(da(glGetTexParameteriv, GL_TEXTURE_2D, que));
    di("textura " + std::to_string(unidad), todo);
}

void apunta(const std::string &funcion, const std::vector<double> &numeros) {
    di("orden " + funcion, numeros);
    std::istringstream cuales(std::getenv("PREGUNTA_ESTADO"));
    for (GLenum cual; cuales >> cual;) {
        std::vector<double> v(4);
        glGetDoublev(cual, v.data());
        di("estado " + std::to_string(cual), v);
    }
    const auto programa = GLuint(da(glGetIntegerv, GL_CURRENT_PROGRAM));
    const auto activa = GLenum(da(glGetIntegerv, GL_ACTIVE_TEXTURE));
    char nombre[256];
    GLint n = 0;
    GLenum tipo = 0;
    for (GLuint i = 0; programa && i < da(glGetProgramiv, programa, GL_ACTIVE_ATTRIBUTES); ++i)
        glGetActiveAttrib(programa, i, 256, nullptr, &n, &tipo, nombre), diAtributo(programa, nombre);
    for (GLuint i = 0; programa && i < da(glGetProgramiv, programa, GL_ACTIVE_UNIFORMS); ++i)
        glGetActiveUniform(programa, i, 256, nullptr, &n, &tipo, nombre), diUniform(programa, nombre);
    for (int unidad = 0; unidad < 16; ++unidad)
        diTextura(unidad);
    glActiveTexture(activa);
}

template<class... P>
void sigue(const char *nombre, P... p) {
    if (salida.is_open())
        apunta(nombre, {double(std::intptr_t(p))...});
    reinterpret_cast<void (*)(P...)>(dlsym(RTLD_NEXT, nombre))(p...);
}

} // namespace

extern "C" {

void explicaCuadro(void (*dibuja)(), int ancho, int alto) {
    const auto explica = reinterpret_cast<decltype(&explicaCuadro)>(dlsym(RTLD_NEXT, "explicaCuadro"));
    salida.open(std::getenv("PREGUNTA"));
    salida.precision(9);
    explica ? explica(dibuja, ancho, alto) : dibuja();
    salida.close();
}
void glClear(GLbitfield buferes) {
    sigue("glClear", buferes);
}
void glDrawArrays(GLenum modo, GLint primero, GLsizei vertices) {
    sigue("glDrawArrays", modo, primero, vertices);
}
void glDrawElements(GLenum modo, GLsizei vertices, GLenum tipo, const void *indices) {
    sigue("glDrawElements", modo, vertices, tipo, indices);
}

} // extern "C"
