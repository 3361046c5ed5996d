// Leer en WebGL 2 lo que no deja: la profundidad y la plantilla se copian a un framebuffer aparte y se dibujan en
// colores; y si pasa algo de lo que se dibuja se ve dibujándolo ahí, con esa copia. Lo que una consulta (occlusion
// query) dice no se sabe hasta otro turno del navegador: solo se usa para lo que se pregunta antes.
#include "estado.h"
#include "programas.h"
#include "sueltas.h"
#include <algorithm>
#include <emscripten.h>
#include <emscripten/html5.h>
#include <map>

DECLARA(glBlitFramebuffer)
DECLARA(glStencilFunc)

// Si hay una consulta en curso. Con EM_JS, por lo que dice contexto_web.cpp.
// clang-format off
EM_JS(int, laboratorioConsulta, (), { return GLctx.getQuery(0x8C2F, 0x8865) ? 1 : 0; });
// clang-format on

namespace sin_ventana {
extern bool plantillaPedida; // contexto_web.cpp
}

namespace explica {
namespace {

const char *const EN_TODO = R"(#version 140
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }
)";
const char *const PROFUNDIDAD = R"(#version 140
uniform sampler2D copia;
uniform int x, y;
out vec4 z;
float de(int i) { return texelFetch(copia, ivec2(x + 4 * int(gl_FragCoord.x) + i, y + int(gl_FragCoord.y)), 0).r; }
void main() { z = vec4(de(0), de(1), de(2), de(3)); }
)";
const char *const BLANCO = R"(#version 140
out vec4 color;
void main() { color = vec4(1.0); }
)";

GLuint enlaza(const char *fragmento) {
    const GLuint programa = glCreateProgram();
    for (const GLuint shader : {compila(GL_VERTEX_SHADER, EN_TODO), compila(GL_FRAGMENT_SHADER, fragmento)}) {
        glAttachShader(programa, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(programa);
    return programa;
}

// Cubre lo que haya con ese fragment shader; hay que tener un Guardado.
class Cubre {
    GLuint programa, vao = 0;

public:
    explicit Cubre(const char *fragmento) : programa(enlaza(fragmento)) {
        glGenVertexArrays(1, &vao);
    }
    void operator()(std::initializer_list<std::pair<const char *, GLint>> uniforms = {}) const {
        glUseProgram(programa);
        glBindVertexArray(vao);
        for (const auto &[nombre, valor] : uniforms)
            glUniform1i(glGetUniformLocation(programa, nombre), valor);
        deVerdad().dibujaVertices(GL_TRIANGLES, 0, 3);
    }
};

// Un framebuffer con color de ese formato y, en una textura, profundidad del otro, si lo hay.
struct Marco {
    GLuint nombre = 0, color = 0, profundidad = 0;
    int ancho = 0, alto = 0;
};

bool llevaPlantilla(GLenum formato) {
    return formato == GL_DEPTH24_STENCIL8 || formato == GL_DEPTH32F_STENCIL8;
}

const Marco &marcoDe(GLenum formato, int ancho, int alto, GLenum deColor = GL_RGBA32F) {
    static std::map<std::pair<GLenum, GLenum>, Marco> marcos;
    Marco &m = marcos[{formato, deColor}];
    if (m.nombre && m.ancho >= ancho && m.alto >= alto) {
        glBindFramebuffer(GL_FRAMEBUFFER, m.nombre);
        return m;
    }
    const auto vista = cuatro(GL_VIEWPORT);
    glDeleteFramebuffers(1, &m.nombre);
    glDeleteRenderbuffers(1, &m.color);
    glDeleteTextures(1, &m.profundidad);
    m = {0, 0, 0, std::max({ancho, m.ancho, vista[0] + vista[2]}),
         std::max({alto, m.alto, vista[1] + vista[3]})};
    glGenFramebuffers(1, &m.nombre);
    glGenRenderbuffers(1, &m.color);
    glBindFramebuffer(GL_FRAMEBUFFER, m.nombre);
    glBindRenderbuffer(GL_RENDERBUFFER, m.color);
    glRenderbufferStorage(GL_RENDERBUFFER, deColor, m.ancho, m.alto);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, m.color);
    if (formato == GL_NONE)
        return m;
    const GLint textura = entero(GL_TEXTURE_BINDING_2D); // la que lee el programa
    glGenTextures(1, &m.profundidad);
    glBindTexture(GL_TEXTURE_2D, m.profundidad);
    glTexStorage2D(GL_TEXTURE_2D, 1, formato, m.ancho, m.alto);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glFramebufferTexture2D(GL_FRAMEBUFFER,
                           llevaPlantilla(formato) ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT,
                           GL_TEXTURE_2D, m.profundidad, 0);
    glBindTexture(GL_TEXTURE_2D, GLuint(textura));
    return m;
}

// El de la profundidad de ese framebuffer. De la ventana WebGL no lo dice: se prueba a copiarla.
GLenum formatoDe(const Lienzo &l) {
    static GLenum deVentana = GL_NONE;
    if (l.nombre)
        return l.bitsPlantilla ? l.bitsProfundidad == 32 ? GL_DEPTH32F_STENCIL8 : GL_DEPTH24_STENCIL8
               : l.bitsProfundidad == 16 ? GL_DEPTH_COMPONENT16
               : l.bitsProfundidad == 32 ? GL_DEPTH_COMPONENT32F
                                         : GL_DEPTH_COMPONENT24;
    for (const GLenum formato : {GL_DEPTH24_STENCIL8, GL_DEPTH_COMPONENT24}) {
        if (deVentana != GL_NONE)
            break;
        marcoDe(formato, l.ancho, l.alto);
        while (glGetError()) {
        }
        glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
        DE_VERDAD(glBlitFramebuffer)(0, 0, 1, 1, 0, 0, 1, 1, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
        if (!glGetError())
            deVentana = formato;
    }
    return deVentana;
}

// La profundidad y la plantilla de ese rectángulo, en un framebuffer aparte, que queda puesto.
const Marco &copia(const Lienzo &l, int x, int y, int ancho, int alto, GLenum deColor = GL_RGBA32F) {
    const GLenum formato = formatoDe(l);
    const Marco &m = marcoDe(formato, std::max(l.ancho, x + ancho), std::max(l.alto, y + alto), deColor);
    const bool recorta = glIsEnabled(GL_SCISSOR_TEST);
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, l.nombre);
    const GLbitfield buferes =
        GL_DEPTH_BUFFER_BIT | (l.bitsPlantilla && llevaPlantilla(formato) ? GL_STENCIL_BUFFER_BIT : 0u);
    DE_VERDAD(glBlitFramebuffer)(x, y, x + ancho, y + alto, x, y, x + ancho, y + alto, buferes, GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, m.nombre);
    pon(GL_SCISSOR_TEST, recorta);
    return m;
}

// Sin ninguna prueba; lo que se cubra llega a todo el rectángulo (0, 0, ancho, alto).
class SinPruebas {
    std::array<GLint, 4> vista = cuatro(GL_VIEWPORT);

public:
    SinPruebas(int x, int y, int ancho, int alto) {
        glViewport(x, y, ancho, alto);
        for (const GLenum prueba :
             {GL_SCISSOR_TEST, GL_CULL_FACE, GL_STENCIL_TEST, GL_DEPTH_TEST, GL_BLEND, GL_RASTERIZER_DISCARD})
            glDisable(prueba);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glDepthMask(GL_FALSE);
    }
    ~SinPruebas() {
        glViewport(vista[0], vista[1], vista[2], vista[3]);
    }
    SinPruebas(const SinPruebas &) = delete;
    SinPruebas &operator=(const SinPruebas &) = delete;
};

// Las de una textura, de cuatro en cuatro por píxel.
std::vector<float> profundidades(GLuint textura, int x, int y, int ancho, int alto) {
    static const Cubre cubre(PROFUNDIDAD);
    const int w = (ancho + 3) / 4; // lo que sobra de cada fila se olvida
    std::vector<float> leidas(std::size_t(4 * w) * std::size_t(alto));
    marcoDe(GL_NONE, w, alto);
    const SinPruebas sin(0, 0, w, alto);
    glBindTexture(GL_TEXTURE_2D, textura);
    cubre({{"copia", entero(GL_ACTIVE_TEXTURE) - GL_TEXTURE0}, {"x", x}, {"y", y}});
    glReadPixels(0, 0, w, alto, GL_RGBA, GL_FLOAT, leidas.data());
    std::vector<float> salen;
    for (int fila = 0; fila < alto; ++fila)
        salen.insert(salen.end(), &leidas[std::size_t(4 * w * fila)],
                     &leidas[std::size_t(4 * w * fila)] + ancho);
    return salen;
}

GLuint consultaDe(int numero) {
    static std::vector<GLuint> todas;
    while (int(todas.size()) < numero)
        glGenQueries(1, &todas.emplace_back());
    return todas[std::size_t(numero - 1)];
}
std::vector<bool> hay; // de qué órdenes se ha preguntado
GLint referencia = 0;
GLuint aparte = 0; // la profundidad del framebuffer aparte

} // namespace

// El que dice Firefox está acotado por el framebuffer que él tenga puesto, que no es este.
GLint pideLaPlantilla() {
    return referencia;
}

std::vector<float> leeProfundidades(const Lienzo &l, int x, int y, int ancho, int alto) {
    return profundidades(copia(l, x, y, ancho, alto).profundidad, x, y, ancho, alto);
}

// Los cuatro bits de abajo y los cuatro de arriba: cada uno, en un canal.
std::vector<unsigned char> leePlantilla(const Lienzo &l, int x, int y, int ancho, int alto) {
    static const Cubre cubre(BLANCO);
    std::vector<unsigned char> leida(std::size_t(ancho) * std::size_t(alto));
    copia(l, x, y, ancho, alto, GL_RGBA8);
    const GLint funcion = entero(GL_STENCIL_FUNC), mira = entero(GL_STENCIL_VALUE_MASK);
    const SinPruebas sin(x, y, ancho, alto);
    glStencilMask(0);
    std::vector<unsigned char> rgba(4 * leida.size());
    for (int desde : {0, 4}) {
        glClearBufferfv(GL_COLOR, 0, Pixel{}.data());
        glEnable(GL_STENCIL_TEST);
        for (int bit = 0; bit < 4; ++bit) {
            DE_VERDAD(glStencilFunc)(GL_EQUAL, 1 << (desde + bit), 1u << (desde + bit));
            glColorMask(bit == 0, bit == 1, bit == 2, bit == 3);
            cubre();
        }
        glDisable(GL_STENCIL_TEST);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glReadPixels(x, y, ancho, alto, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
        for (std::size_t i = 0; i < rgba.size(); ++i)
            leida[i / 4] = static_cast<unsigned char>(leida[i / 4] | (rgba[i] > 0) << (desde + int(i % 4)));
    }
    DE_VERDAD(glStencilFunc)(GLenum(funcion), referencia, GLuint(mira));
    return leida;
}

void leePixeles(const Lienzo &l, int x, int y, int ancho, int alto, float *rgba) {
    if (l.componentes != GL_UNSIGNED_NORMALIZED)
        return glReadPixels(x, y, ancho, alto, GL_RGBA, GL_FLOAT, rgba);
    std::vector<unsigned char> bytes(std::size_t(4 * ancho * alto));
    glReadPixels(x, y, ancho, alto, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    std::transform(bytes.begin(), bytes.end(), rgba, [](unsigned char b) { return float(b) / 255; });
}

// En el framebuffer aparte, con la profundidad y la plantilla de donde se dibuja, solo se escribe el color: si cambia
// es que pasa. De lo que el recorte deja y, si no lo hay, de todo.
long muestrasDe(const std::function<void()> &dibuja) {
    const GLint nombre = entero(GL_DRAW_FRAMEBUFFER_BINDING);
    const bool recorta = glIsEnabled(GL_SCISSOR_TEST);
    const auto r = cuatro(recorta ? GL_SCISSOR_BOX : GL_VIEWPORT);
    Lienzo l;
    l.nombre = GLuint(nombre);
    l.ancho = r[0] + r[2], l.alto = r[1] + r[3];
    if (glIsEnabled(GL_DEPTH_TEST) || glIsEnabled(GL_STENCIL_TEST)) {
        l = lienzoActual(l.ancho, l.alto);
        copia(l, r[0], r[1], r[2], r[3]);
        if (!l.bitsProfundidad) // lo que no tiene lo pasa todo
            glDisable(GL_DEPTH_TEST);
        if (!l.bitsPlantilla)
            glDisable(GL_STENCIL_TEST);
    } else {
        marcoDe(GL_NONE, l.ancho, l.alto);
    }
    glDepthMask(GL_FALSE);
    glStencilMask(0);
    const std::vector<Pixel> leidos = coloresAparte(r[0], r[1], r[2], r[3], dibuja);
    glBindFramebuffer(GL_FRAMEBUFFER, GLuint(nombre));
    return std::any_of(leidos.begin(), leidos.end(), [](const Pixel &p) { return p != NINGUNO; });
}

void preguntaSiDibuja(const std::function<void()> &dibuja, int numero) {
    hay.resize(std::size_t(numero - 1));
    const bool otra = laboratorioConsulta();
    hay.push_back(!otra);
    if (!otra)
        glBeginQuery(GL_ANY_SAMPLES_PASSED, consultaDe(numero));
    dibuja();
    if (!otra)
        glEndQuery(GL_ANY_SAMPLES_PASSED);
}

namespace {

GLuint deConsulta(int numero, GLenum que) {
    GLuint valor = 1;
    if (numero <= int(hay.size()) && hay[std::size_t(numero - 1)])
        glGetQueryObjectuiv(consultaDe(numero), que, &valor);
    return valor;
}

} // namespace

bool hayRespuestas() {
    for (int n = int(hay.size()); n > 0; --n)
        if (!deConsulta(n, GL_QUERY_RESULT_AVAILABLE))
            return false;
    return true;
}

long dibujaYCuenta(const std::function<void()> &dibuja, int numero) {
    dibuja();
    return deConsulta(numero, GL_QUERY_RESULT) ? -1 : 0;
}

void abreAparte(const Lienzo &l) {
    aparte = marcoDe(formatoDe(l), l.ancho, l.alto).profundidad;
}

float profundidadAparte(int x, int y) {
    return profundidades(aparte, x, y, 1, 1)[0];
}

void bitsDeLaVentana(GLenum, Lienzo &l) {
    EmscriptenWebGLContextAttributes tiene;
    emscripten_webgl_get_context_attributes(emscripten_webgl_get_current_context(), &tiene);
    l.bitsProfundidad = tiene.depth ? 24 : 0;
    l.bitsPlantilla = sin_ventana::plantillaPedida ? 8 : 0;
}

} // namespace explica

extern "C" {

void glStencilFunc(GLenum funcion, GLint valor, GLuint mascara) {
    explica::referencia = valor;
    DE_VERDAD(glStencilFunc)(funcion, valor, mascara);
}

// Para las sumas y los programas de C++, que en la página no se piden.
void glGetTexImage(GLenum, GLint, GLenum, GLenum, void *) {
}
void glBindFragDataLocation(GLuint, GLuint, const GLchar *) {
}

} // extern "C"
