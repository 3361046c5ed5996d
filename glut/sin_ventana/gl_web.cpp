// Lo que OpenGL 3.1 tiene y WebGL 2 no, o hace de otra manera. Lo demás que falte, que WebGL 2 no puede dar, lo dice el
// enlazador. Cada función sustituye a la de Emscripten, que sigue llamándose emscripten_gl…
#include "essl.h"
#include <GL/glew.h>
#include <algorithm>
#include <cstring>
#include <emscripten.h>
#include <emscripten/html5.h>
#include <string>
#include <vector>

using namespace sin_ventana;

// clang-format off
EM_JS(int, laboratorioPuesto, (GLuint shader), {
    const suyo = GL.shaders[shader];
    return suyo && GL.programs.some(p => p && (GLctx.getAttachedShaders(p) || []).includes(suyo)) ? 1 : 0;
});
// clang-format on

extern "C" {

void emscripten_glDeleteShader(GLuint);
void emscripten_glDeleteProgram(GLuint);

void emscripten_glEnable(GLenum);
void emscripten_glDepthRangef(GLfloat, GLfloat);
void emscripten_glClearDepthf(GLfloat);
const GLubyte *emscripten_glGetString(GLenum);
void emscripten_glShaderSource(GLuint, GLsizei, const GLchar *const *, const GLint *);
void emscripten_glReadPixels(GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, void *);

// --- lo que en WebGL 2 está siempre puesto --------------------------------------------------------------------

void glEnable(GLenum que) {
    if (que != GL_MULTISAMPLE && que != GL_PROGRAM_POINT_SIZE && que != GL_TEXTURE_CUBE_MAP_SEAMLESS)
        emscripten_glEnable(que);
}

// --- lo que cambia de tipo o de nombre ------------------------------------------------------------------------

void glDepthRange(GLdouble cerca, GLdouble lejos) {
    emscripten_glDepthRangef(GLfloat(cerca), GLfloat(lejos));
}

void glClearDepth(GLdouble z) {
    emscripten_glClearDepthf(GLfloat(z));
}

void glPixelStoref(GLenum que, GLfloat valor) {
    glPixelStorei(que, GLint(valor));
}

void glGetDoublev(GLenum que, GLdouble *valores) {
    GLfloat reales[16] = {};
    glGetFloatv(que, reales);
    const int cuantos = que == GL_VIEWPORT || que == GL_SCISSOR_BOX || que == GL_COLOR_CLEAR_VALUE ? 4
                        : que == GL_DEPTH_RANGE                                                    ? 2
                                                                                                   : 1;
    std::copy_n(reales, cuantos, valores);
}

void glGetQueryObjectiv(GLuint consulta, GLenum que, GLint *valor) {
    GLuint natural = 0;
    glGetQueryObjectuiv(consulta, que, &natural);
    *valor = GLint(natural);
}

// De la ventana, solo hay la parte de atrás; de un framebuffer, la suya en su sitio.
void glDrawBuffer(GLenum cual) {
    const int n = int(cual) - GL_COLOR_ATTACHMENT0;
    std::vector<GLenum> todos(n > 0 && n < 16 ? n : 0, GL_NONE);
    todos.push_back(cual == GL_FRONT ? GLenum(GL_BACK) : cual);
    glDrawBuffers(GLsizei(todos.size()), todos.data());
}

void glMultiDrawArrays(GLenum modo, const GLint *primeros, const GLsizei *cuantos, GLsizei veces) {
    for (GLsizei i = 0; i < veces; ++i)
        glDrawArrays(modo, primeros[i], cuantos[i]);
}

void glMultiDrawElements(GLenum modo, const GLsizei *cuantos, GLenum tipo, const void *const *indices,
                         GLsizei veces) {
    for (GLsizei i = 0; i < veces; ++i)
        glDrawElements(modo, cuantos[i], tipo, indices[i]);
}

const GLubyte *glGetString(GLenum nombre) {
    const GLubyte *valor = emscripten_glGetString(nombre);
    if (nombre != GL_VERSION && nombre != GL_SHADING_LANGUAGE_VERSION)
        return valor;
    static std::string versiones[2];
    std::string &version = versiones[nombre == GL_VERSION];
    version = std::string(nombre == GL_VERSION ? "3.1" : "1.40") +
              " (imitado: " + reinterpret_cast<const char *>(valor) + ")";
    return reinterpret_cast<const GLubyte *>(version.c_str());
}

void glShaderSource(GLuint shader, GLsizei cuantos, const GLchar *const *textos, const GLint *longitudes) {
    std::string texto;
    for (GLsizei i = 0; i < cuantos; ++i)
        texto +=
            longitudes && longitudes[i] >= 0 ? std::string(textos[i], longitudes[i]) : std::string(textos[i]);
    texto = enEssl(texto);
    const GLchar *uno = texto.c_str();
    emscripten_glShaderSource(shader, 1, &uno, nullptr);
}

// El que está puesto en un programa, OpenGL lo borra con él, y mientras lo puede leer quien explica un cuadro;
// Emscripten olvida su nombre.
static std::vector<GLuint> porBorrar;

void glDeleteShader(GLuint shader) {
    if (laboratorioPuesto(shader))
        porBorrar.push_back(shader);
    else
        emscripten_glDeleteShader(shader);
}

void glDeleteProgram(GLuint programa) {
    emscripten_glDeleteProgram(programa);
    std::vector<GLuint> antes;
    antes.swap(porBorrar);
    std::for_each(antes.begin(), antes.end(), glDeleteShader);
}

// WebGL solo da RGBA: RGB se lee así y se le quita la opacidad.
void glReadPixels(GLint x, GLint y, GLsizei ancho, GLsizei alto, GLenum formato, GLenum tipo, void *datos) {
    if (formato != GL_RGB || tipo != GL_UNSIGNED_BYTE)
        return emscripten_glReadPixels(x, y, ancho, alto, formato, tipo, datos);
    const std::size_t w = ancho, h = alto;
    GLint alineacion = 4;
    glGetIntegerv(GL_PACK_ALIGNMENT, &alineacion);
    const std::size_t a = alineacion, fila = (3 * w + a - 1) / a * a;
    std::vector<unsigned char> rgba(4 * w * h);
    emscripten_glReadPixels(x, y, ancho, alto, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    for (std::size_t j = 0; j < h; ++j)
        for (std::size_t i = 0; i < w; ++i)
            std::copy_n(&rgba[4 * (j * w + i)], 3, static_cast<unsigned char *>(datos) + j * fila + 3 * i);
}

// WebGL no lo dice. Lo pregunta la opción -mide, que en la página no se usa.
void glGetTexLevelParameteriv(GLenum, GLint, GLenum, GLint *valor) {
    *valor = 0;
}

// --- GLEW -----------------------------------------------------------------------------------------------------

GLboolean glewExperimental = GL_FALSE, labHayGL31 = GL_FALSE, labHayAnisotropia = GL_FALSE;

GLenum glewInit(void) {
    labHayGL31 = GL_TRUE;
    labHayAnisotropia = emscripten_webgl_enable_extension(emscripten_webgl_get_current_context(),
                                                          "EXT_texture_filter_anisotropic");
    return GLEW_OK;
}

const GLubyte *glewGetString(GLenum) {
    return reinterpret_cast<const GLubyte *>("no hace falta: las funciones son del navegador");
}

} // extern "C"
