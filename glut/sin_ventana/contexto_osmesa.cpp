// Contexto sobre OSMesa: Mesa dibuja en la memoria del programa, sin servidor gráfico ni dispositivo.
#include "contexto.h"
#include "error.h"
#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <vector>
// clang-format off
#include <GL/gl.h>
#include <GL/osmesa.h>
// clang-format on

namespace sin_ventana {

namespace {
OSMesaContext contexto = nullptr;
std::vector<unsigned char> memoria; // RGBA, una fila tras otra desde abajo
int anchoMemoria = 0, altoMemoria = 0;
const long long MAXIMO_PERDIDOS = 8 << 20, MAXIMO_HOLGURA = 16 << 20; // píxeles, a 8 bytes cada uno
long long pixelesPerdidos = 0;
} // namespace

int creaContexto(int ancho, int alto, bool profundidad, bool plantilla, bool) {
    limitaMesa();
    // clang-format off
    const int atributos[] = {OSMESA_FORMAT, OSMESA_RGBA,
                             OSMESA_DEPTH_BITS, profundidad ? 24 : 0,
                             OSMESA_STENCIL_BITS, plantilla ? 8 : 0,
                             OSMESA_PROFILE, OSMESA_CORE_PROFILE,
                             OSMESA_CONTEXT_MAJOR_VERSION, 3,
                             OSMESA_CONTEXT_MINOR_VERSION, 1,
                             0};
    // clang-format on
    contexto = OSMesaCreateContextAttribs(atributos, nullptr);
    if (!contexto)
        falla(std::getenv("MESA_GL_VERSION_OVERRIDE")
                  ? "OSMesa no puede crear un contexto OpenGL 3.1 con esa MESA_GL_VERSION_OVERRIDE: quítala"
                  : "OSMesa no puede crear un contexto OpenGL 3.1");
    cambiaTallaContexto(ancho, alto);
    return 0;
}

// OSMesa no libera el framebuffer que deja. Cuando lo perdido ya es mucho se sigue en el mismo, si la ventana cabe en
// él (los dos empiezan abajo a la izquierda), o en otro que sea el doble en lo que crece. Hasta entonces son de la
// talla justa, porque del alto del framebuffer depende el último bit de algunos píxeles.
void cambiaTallaContexto(int ancho, int alto) {
    if (pixelesPerdidos > MAXIMO_PERDIDOS) {
        if (ancho <= anchoMemoria && alto <= altoMemoria)
            return;
        const int holgado[] = {ancho > anchoMemoria ? std::max(ancho, 2 * anchoMemoria) : anchoMemoria,
                               alto > altoMemoria ? std::max(alto, 2 * altoMemoria) : altoMemoria};
        if (1LL * holgado[0] * holgado[1] <= MAXIMO_HOLGURA)
            ancho = holgado[0], alto = holgado[1];
    }
    std::vector<unsigned char> nueva(std::size_t{4} * ancho * alto);
    if (!OSMesaMakeCurrent(contexto, nueva.data(), GL_UNSIGNED_BYTE, ancho, alto))
        falla("OSMesa no admite una imagen de " + std::to_string(ancho) + "×" + std::to_string(alto));
    memoria.swap(nueva); // OSMesa usa la vieja hasta que tiene la nueva
    pixelesPerdidos += 1LL * anchoMemoria * altoMemoria;
    anchoMemoria = ancho;
    altoMemoria = alto;
}

void destruyeContexto() {
    OSMesaDestroyContext(contexto);
    contexto = nullptr;
}

void diTitulo(const char *) {
}

void cedeAlNavegador() {
}

void (*direccionGL(const char *nombre))() {
    return OSMesaGetProcAddress(nombre);
}

} // namespace sin_ventana

// El GLEW de Debian busca las funciones con glXGetProcAddress: estas definiciones, que se enlazan antes que las de
// libGL, lo llevan a OSMesa. De lo demás de GLX solo nombra dos funciones, y aquí, donde no hay pantalla, no las llama:
// con ellas el GLEW estático no necesita libGL. Las que acaban en dos mayúsculas (ARB, EXT, NV) son de extensiones:
// pide dos mil, y por cada una que no conoce, aunque sea de GLX, Mesa prepara otra que da un error.
extern "C" {
void (*glXGetProcAddressARB(const GLubyte *nombre))() {
    const std::string_view funcion = reinterpret_cast<const char *>(nombre);
    const auto esMayuscula = [](char c) { return 'A' <= c && c <= 'Z'; };
    const bool esDeExtension = esMayuscula(*funcion.rbegin()) && esMayuscula(*std::next(funcion.rbegin()));
    return esDeExtension || funcion.substr(0, 3) == "glX" ? nullptr : OSMesaGetProcAddress(funcion.data());
}

void (*glXGetProcAddress(const GLubyte *nombre))() {
    return glXGetProcAddressARB(nombre);
}

int glXQueryVersion(void *, int *, int *) {
    return 0;
}

const char *glXGetClientString(void *, int) {
    return "";
}
}
