// Se antepone (LD_PRELOAD) a un programa enlazado sin ventana: define las funciones de OpenGL que escriben píxeles y,
// cuando acaba el guion, deja en $LAB_EXPLICA, en JSON, el cuadro explicado (cuadro.h) y los píxeles de
// $LAB_EXPLICA_PIXELES («240,140 30,20», desde arriba a la izquierda). Si se pide, con los shaders de otra primitiva:
// $LAB_EXPLICA_SOMBREA («7,3», la 3 de la orden 7). Con $LAB_EXPLICA_TEXTURA («2,9», la 2 como la lee la orden 9), los
// píxeles son, desde abajo, los del framebuffer en que se pinta. Con LAB_EXPLICA_IMAGENES=1, también lo que va quedando
// en cada framebuffer; con LAB_EXPLICA_SUMAS=1, una suma de lo que hay en cada array y textura.
#include "cuadro.h"
#include <cstdlib>
#include <dlfcn.h>
#include <fstream>
#include <sstream>

namespace explica {
namespace {

template<class Funcion>
Funcion tapada(const char *nombre) {
    return reinterpret_cast<Funcion>(dlsym(RTLD_NEXT, nombre));
}

std::string variable(const char *nombre) {
    const char *const valor = std::getenv(nombre);
    return valor ? valor : "";
}

} // namespace

const DeVerdad &deVerdad() {
    static const DeVerdad funciones = {tapada<decltype(&glClear)>("glClear"),
                                       tapada<decltype(&glDrawArrays)>("glDrawArrays"),
                                       tapada<decltype(&glDrawElements)>("glDrawElements")};
    return funciones;
}

} // namespace explica

using namespace explica;

extern "C" {

void explicaCuadro(void (*dibuja)(), int ancho, int alto) {
    const std::string fichero = variable("LAB_EXPLICA");
    if (fichero.empty())
        return;
    Pedido que{variable("LAB_EXPLICA_IMAGENES") == "1", variable("LAB_EXPLICA_SUMAS") == "1"};
    std::istringstream pedidos(variable("LAB_EXPLICA_PIXELES"));
    char coma;
    for (Punto p; pedidos >> p.x >> coma >> p.y;)
        que.pixeles.push_back(p);
    std::istringstream(variable("LAB_EXPLICA_SOMBREA")) >> que.sombrea.first >> coma >> que.sombrea.second;
    std::istringstream(variable("LAB_EXPLICA_TEXTURA")) >> que.textura.first >> coma >> que.textura.second;
    std::ofstream(fichero) << explica::explica(dibuja, ancho, alto, que) << '\n';
}

void glClear(GLbitfield buferes) {
    llega(ordenBorra(buferes));
}

void glDrawArrays(GLenum modo, GLint primero, GLsizei vertices) {
    llega(ordenDibuja(modo, primero, vertices));
}

void glDrawElements(GLenum modo, GLsizei vertices, GLenum tipo, const void *indices) {
    llega(ordenDibuja(modo, vertices, tipo, indices));
}

// Por donde GLEW pregunta las demás: OSMesa y, con EGL, GLX.
Direccion OSMesaGetProcAddress(const char *nombre) {
    const Direccion otra = tapa(nombre);
    return otra ? otra : tapada<Direccion (*)(const char *)>("OSMesaGetProcAddress")(nombre);
}

Direccion glXGetProcAddressARB(const GLubyte *nombre) {
    const char *const texto = reinterpret_cast<const char *>(nombre);
    const Direccion otra = tapa(texto);
    return otra ? otra : tapada<Direccion (*)(const GLubyte *)>("glXGetProcAddressARB")(nombre);
}

} // extern "C"
