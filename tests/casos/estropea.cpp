// Se antepone (LD_PRELOAD) a un programa, delante incluso de lo que lo explica, y le estropea algo de OpenGL, lo que
// diga $ESTROPEA: es lo que pasa cuando a quien lo escribe se le olvida o se equivoca en una llamada.
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <set>
#include <string>
#include <vector>
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

namespace {

bool es(const char *defecto) {
    static const char *const cual = std::getenv("ESTROPEA");
    return cual && !std::strcmp(cual, defecto);
}

template<class Funcion>
Funcion tapada(const char *nombre) {
    return reinterpret_cast<Funcion>(dlsym(RTLD_NEXT, nombre));
}

using Direccion = void (*)();

// La de una función que GLEW pide por su nombre, pasando por quien haya detrás.
template<class Funcion>
Funcion siguiente(const char *nombre) {
    static const auto pide = tapada<Direccion (*)(const char *)>("OSMesaGetProcAddress");
    return reinterpret_cast<Funcion>(pide(nombre));
}

// Los nombres de los uniforms, para saber de cuál se habla.
std::set<GLint> matricesDeCamara, proyecciones, modelos;

GLint sitioDe(GLuint programa, const GLchar *nombre) {
    const GLint sitio = siguiente<decltype(&glGetUniformLocation)>("glGetUniformLocation")(programa, nombre);
    if (!std::strcmp(nombre, "camara"))
        matricesDeCamara.insert(sitio);
    if (!std::strcmp(nombre, "proyeccion"))
        proyecciones.insert(sitio);
    if (!std::strcmp(nombre, "M"))
        modelos.insert(sitio);
    return sitio;
}

// Pone el plano cerca, o el lejos, de una proyección en perspectiva o paralela a esa distancia.
void pasaPorElOrigen(std::vector<GLfloat> &m, GLfloat distancia, bool elCerca) {
    const GLfloat paralela = m[15];
    GLfloat cerca = (m[14] + paralela) / (m[10] - 1 + paralela),
            lejos = (m[14] - paralela) / (m[10] + 1 - paralela);
    (elCerca ? cerca : lejos) = distancia;
    m[10] = (paralela != 0 ? -2 : -(lejos + cerca)) / (lejos - cerca);
    m[14] = (paralela != 0 ? -(lejos + cerca) : -2 * lejos * cerca) / (lejos - cerca);
}

void matriz(GLint sitio, GLsizei n, GLboolean traspone, const GLfloat *valor) {
    const auto deVerdad = siguiente<decltype(&glUniformMatrix4fv)>("glUniformMatrix4fv");
    const bool camara = matricesDeCamara.count(sitio), proyeccion = proyecciones.count(sitio);
    if ((es("sin_camara") && camara) || (es("sin_proyeccion") && proyeccion) ||
        (es("sin_modelo") && modelos.count(sitio)))
        return;
    std::vector<GLfloat> otra(valor, valor + 16 * n);
    if (es("camara_al_reves") && camara) // mira hacia el otro lado
        for (int c = 0; c < 4; ++c)
            otra[std::size_t(4 * c + 2)] *= -1, otra[std::size_t(4 * c)] *= -1;
    if (es("cerca_lejos") && proyeccion) // todo más cerca que el plano cerca
        for (int c = 0; c < 4; ++c)
            otra[std::size_t(4 * c + 2)] -= 3 * otra[std::size_t(4 * c + 3)];
    if (es("proyeccion_nan") && proyeccion)
        otra[0] = otra[5] = std::strtof("nan", nullptr);
    if (es("determinante_cero") && modelos.count(sitio)) // un eje es la suma de los otros dos
        for (int i = 0; i < 3; ++i)
            otra[std::size_t(4 + i)] = otra[std::size_t(i)] + otra[std::size_t(8 + i)];
    static GLfloat lejania = 0; // de la cámara al origen
    if (camara)
        lejania = -valor[14];
    if ((es("cerca_corta") || es("lejos_corta")) && proyeccion && lejania > 0)
        pasaPorElOrigen(otra, lejania, es("cerca_corta"));
    if (es("matriz_cero") && camara)
        otra.assign(otra.size(), 0);
    deVerdad(sitio, n, traspone, otra.data());
}

void fuente(GLuint shader, GLsizei n, const GLchar *const *trozos, const GLint *largos) {
    std::string texto;
    for (GLsizei i = 0; i < n; ++i)
        texto += largos && largos[i] >= 0 ? std::string(trozos[i], std::size_t(largos[i])) : trozos[i];
    const std::string quita = "normalize(";
    for (std::size_t donde = 0; es("sin_normalizar") && (donde = texto.find(quita)) != texto.npos;)
        texto.replace(donde, quita.size() - 1, "");
    const GLchar *const entero = texto.c_str();
    siguiente<decltype(&glShaderSource)>("glShaderSource")(shader, 1, &entero, nullptr);
}

void array(GLuint indice) {
    if (!es("array_sin_activar") || indice != 0)
        siguiente<decltype(&glEnableVertexAttribArray)>("glEnableVertexAttribArray")(indice);
}

void niveles(GLenum objetivo) {
    if (!es("sin_niveles"))
        siguiente<decltype(&glGenerateMipmap)>("glGenerateMipmap")(objetivo);
}

void uniforme1i(GLint sitio, GLint valor) {
    siguiente<decltype(&glUniform1i)>("glUniform1i")(sitio, es("otra_unidad") ? valor + 7 : valor);
}

void llena(GLenum objetivo, GLsizeiptr bytes, const void *datos, GLenum uso) {
    const std::vector<char> ceros(static_cast<std::size_t>(bytes));
    const bool vacia = es("buffer_a_cero") && objetivo == GL_ARRAY_BUFFER;
    siguiente<decltype(&glBufferData)>("glBufferData")(objetivo, bytes, vacia ? ceros.data() : datos, uso);
}

Direccion cambiada(const char *nombre) {
    const struct {
        const char *nombre;
        Direccion funcion;
    } CAMBIADAS[] = {{"glGetUniformLocation", reinterpret_cast<Direccion>(sitioDe)},
                     {"glUniformMatrix4fv", reinterpret_cast<Direccion>(matriz)},
                     {"glShaderSource", reinterpret_cast<Direccion>(fuente)},
                     {"glEnableVertexAttribArray", reinterpret_cast<Direccion>(array)},
                     {"glGenerateMipmap", reinterpret_cast<Direccion>(niveles)},
                     {"glUniform1i", reinterpret_cast<Direccion>(uniforme1i)},
                     {"glBufferData", reinterpret_cast<Direccion>(llena)}};
    for (const auto &[suyo, funcion] : CAMBIADAS)
        if (!std::strcmp(nombre, suyo))
            return funcion;
    return nullptr;
}

} // namespace

extern "C" {

void glClear(GLbitfield buferes) {
    static const auto deVerdad = tapada<decltype(&glClear)>("glClear");
    if (es("recorte"))
        glEnable(GL_SCISSOR_TEST), glScissor(0, 0, 0, 0);
    if (es("viewport"))
        glViewport(0, 0, 0, 0);
    if (es("cara"))
        glEnable(GL_CULL_FACE), glCullFace(GL_FRONT_AND_BACK);
    if (es("profundidad_nunca"))
        glEnable(GL_DEPTH_TEST), glDepthFunc(GL_NEVER);
    if (es("borra_cerca"))
        glClearDepth(0);
    if (es("sin_color"))
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    if (es("mezcla_nada"))
        glEnable(GL_BLEND), glBlendFunc(GL_ZERO, GL_ONE);
    deVerdad(es("sin_borrar_profundidad") ? buferes & ~GLbitfield(GL_DEPTH_BUFFER_BIT) : buferes);
}

void glFlush() {
    if (es("borra_al_final"))
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    tapada<decltype(&glFlush)>("glFlush")();
}

void glDrawElements(GLenum modo, GLsizei n, GLenum tipo, const void *indices) {
    static const auto usa = siguiente<decltype(&glUseProgram)>("glUseProgram");
    GLint suyo = 0;
    glGetIntegerv(GL_CURRENT_PROGRAM, &suyo);
    if (es("sin_programa"))
        usa(0);
    tapada<decltype(&glDrawElements)>("glDrawElements")(modo, es("cero_vertices") ? 0 : n, tipo, indices);
    usa(GLuint(suyo));
}

Direccion OSMesaGetProcAddress(const char *nombre) {
    const Direccion otra = cambiada(nombre);
    return otra ? otra : tapada<Direccion (*)(const char *)>("OSMesaGetProcAddress")(nombre);
}

} // extern "C"
