// Se antepone (LD_PRELOAD) a un programa enlazado sin ventana: define las funciones de OpenGL que escriben píxeles y,
// cuando acaba el guion, dibuja el cuadro unas veces más y deja en $LAB_EXPLICA, en JSON, lo que hace cada orden y, de
// cada píxel de $LAB_EXPLICA_PIXELES («240,140 30,20», desde arriba a la izquierda), su historia y los shaders de quien
// lo gana o, si se pide, los de otra primitiva: $LAB_EXPLICA_SOMBREA («7,3», la 3 de la orden 7). Con
// LAB_EXPLICA_IMAGENES=1, también lo que va quedando en cada framebuffer; con LAB_EXPLICA_SUMAS=1, una suma de lo que
// hay en cada array y textura.
#include "enviado.h"
#include "imagenes.h"
#include "pixel.h"
#include "programas.h"
#include "sombreado.h"
#include "sospechas.h"
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace explica {
namespace {

template<class Funcion>
Funcion tapada(const char *nombre) {
    return reinterpret_cast<Funcion>(dlsym(RTLD_NEXT, nombre));
}

struct Copia {
    int numero; // el de la orden
    GLuint origen, destino;
    Orden orden;
};

struct {
    enum { NADA, LISTA, PIXEL, SOMBREADO } pasada = NADA;
    int ancho = 0, alto = 0, numero = 0; // de la orden
    bool imagenes = false, sumas = false;
    std::vector<Json> ordenes;
    std::vector<Suceso> sucesos;
    int ordenSombreada = 0, primitivaSombreada = -1; // por omisión, las que dan el color al píxel
    Json sombreado;
    Sospechas sospechas;
    std::vector<Copia> copias;
    std::map<GLuint, Punto> pixel; // en cada framebuffer
    std::set<GLuint> programas;
} c;

void apuntaOrden(const Orden &orden) {
    const Lienzo lienzo = lienzoActual(c.ancho, c.alto);
    Json json = describe(orden, lienzo);
    const bool dibuja = orden.que == Orden::Que::Dibuja;
    const Cableado cableado = dibuja ? cableadoActual(c.sumas) : Cableado();
    c.sospechas.antes(orden, lienzo, cableado, c.numero);
    if (dibuja) {
        if (const GLuint programa = GLuint(entero(GL_CURRENT_PROGRAM)))
            c.programas.insert(programa);
        const long fragmentos = muestrasDe(orden.hazla);
        const std::string nada = c.sospechas.despues(orden, lienzo, cableado, c.numero, fragmentos);
        json.pon("fragmentos", fragmentos).pon("nada", nada).pon("cableado", deCableado(cableado));
    } else {
        orden.hazla();
    }
    if (orden.que == Orden::Que::Copia && (orden.buferes & GL_COLOR_BUFFER_BIT))
        c.copias.push_back({c.numero, GLuint(entero(GL_READ_FRAMEBUFFER_BINDING)), lienzo.nombre, orden});
    if (c.imagenes) {
        const Guardado guardado;
        apuntaImagenes(lienzo, json);
    }
    c.ordenes.push_back(json.pon("n", c.numero));
}

void llega(const Orden &orden) {
    if (c.pasada == c.NADA)
        return orden.hazla();
    ++c.numero;
    if (c.pasada == c.LISTA)
        return apuntaOrden(orden);
    const auto suyo = c.pixel.find(GLuint(entero(GL_DRAW_FRAMEBUFFER_BINDING)));
    const bool seMira = suyo != c.pixel.end();
    if (c.pasada == c.PIXEL ? !seMira : c.numero != c.ordenSombreada)
        return orden.hazla();
    const Lienzo lienzo = lienzoActual(c.ancho, c.alto);
    const auto origen = c.pixel.find(GLuint(entero(GL_READ_FRAMEBUFFER_BINDING)));
    if (c.pasada == c.PIXEL && orden.que == Orden::Que::Copia && origen != c.pixel.end()) {
        const Lienzo deQueCopia = lienzoActual(c.ancho, c.alto, GL_READ_FRAMEBUFFER);
        const Punto p = origen->second;
        const Guardado guardado;
        if (deQueCopia.conColor() && deQueCopia.dentro(p.x, p.y))
            siLoCambiaOtro(deQueCopia, leeColor(deQueCopia, p.x, p.y), c.sucesos);
    }
    if (c.pasada == c.PIXEL)
        return hazYCuenta(orden, c.numero, lienzo, suyo->second, c.sucesos);
    const Punto p = c.pixel[0]; // de otro framebuffer, el que está en el mismo sitio
    const Punto enOtro = {p.x * lienzo.ancho / c.ancho, p.y * lienzo.alto / c.alto};
    c.sombreado = sombrea(orden, lienzo, seMira ? suyo->second : enOtro, c.primitivaSombreada);
    orden.hazla();
}

// El píxel del framebuffer de que viene, por una copia, ese de la ventana; y así hacia atrás.
std::map<GLuint, Punto> enCadaFramebuffer(Punto p) {
    std::map<GLuint, Punto> donde = {{0, p}};
    for (auto copia = c.copias.rbegin(); copia != c.copias.rend(); ++copia) {
        const auto suyo = donde.find(copia->destino);
        if (suyo == donde.end())
            continue;
        const auto &o = copia->orden.origen, &d = copia->orden.destino;
        const auto lleva = [&](int v, int i) {
            return int(std::floor(o[i] + (v + 0.5 - d[i]) * (o[i + 2] - o[i]) / double(d[i + 2] - d[i])));
        };
        donde.insert({copia->origen, {lleva(suyo->second.x, 0), lleva(suyo->second.y, 1)}});
    }
    return donde;
}

template<class Pasada>
void pasa(Pasada pasada, void (*dibuja)()) {
    c.pasada = pasada;
    c.numero = 0;
    dibuja();
    c.pasada = c.NADA;
}

// Lo último que se escribe con una primitiva, si después no se borra: en la ventana o, si lo que llega a ella es una
// copia, en el framebuffer de que se copia.
const Suceso *quienGana() {
    GLuint framebuffer = 0;
    for (auto s = c.sucesos.rbegin(); s != c.sucesos.rend(); ++s) {
        if (s->framebuffer != framebuffer || s->veredicto != "escrito")
            continue;
        if (s->primitiva >= 0)
            return &*s;
        const auto copia = std::find_if(c.copias.begin(), c.copias.end(),
                                        [&](const Copia &otra) { return otra.numero == s->orden; });
        if (copia == c.copias.end())
            return nullptr;
        framebuffer = copia->origen;
    }
    return nullptr;
}

std::string variable(const char *nombre) {
    const char *const valor = std::getenv(nombre);
    return valor ? valor : "";
}

Json explicaPixel(void (*dibuja)(), int x, int y) {
    char coma;
    c.sucesos.clear();
    c.sombreado = Json();
    const Punto p = {x, c.alto - 1 - y};
    c.pixel = enCadaFramebuffer(p);
    pasa(c.PIXEL, dibuja);
    if (!(std::istringstream(variable("LAB_EXPLICA_SOMBREA")) >> c.ordenSombreada >> coma >>
          c.primitivaSombreada)) {
        const Suceso *const ganador = quienGana();
        c.ordenSombreada = ganador ? ganador->orden : 0;
        c.primitivaSombreada = ganador ? ganador->primitiva : -1;
    }
    if (c.ordenSombreada)
        pasa(c.SOMBREADO, dibuja);
    const Guardado guardado;
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    const Lienzo ventana = lienzoActual(c.ancho, c.alto);
    const Color color = leeColor(ventana, p.x, p.y);
    siLoCambiaOtro(ventana, color, c.sucesos);
    std::vector<Json> historia;
    for (const Suceso &s : c.sucesos)
        historia.push_back(s.json);
    Json json;
    json.pon("pixel", std::array<int, 2>{x, y}).pon("color", color).pon("historia", historia);
    if (c.ordenSombreada)
        json.pon("sombreado",
                 c.sombreado.pon("orden", c.ordenSombreada).pon("primitiva", c.primitivaSombreada));
    return json;
}

std::vector<Json> programasJson() {
    std::vector<Json> programas;
    for (const GLuint programa : c.programas) {
        Json json;
        json.pon("programa", programa);
        for (const Fuente &f : fuentesDe(programa))
            json.pon(f.tipo == GL_VERTEX_SHADER ? "vert" : "frag", f.texto);
        programas.push_back(json);
    }
    return programas;
}

// Si todos los píxeles de la ventana son iguales.
bool ventanaLisa() {
    const Guardado guardado;
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    const std::vector<float> rgba = leeColores(lienzoActual(c.ancho, c.alto), 0, 0, c.ancho, c.alto);
    for (std::size_t i = 4; i < rgba.size(); ++i)
        if (i % 4 < 3 && rgba[i] != rgba[i % 4])
            return false;
    return true;
}

// Por la que se cambia esa función, o nulo.
Direccion tapa(const std::string &nombre) {
    const Direccion deOrden = tapaOrden(nombre, llega);
    return deOrden ? deOrden : tapaEnvio(nombre);
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
    c.ancho = ancho;
    c.alto = alto;
    c.imagenes = variable("LAB_EXPLICA_IMAGENES") == "1";
    c.sumas = variable("LAB_EXPLICA_SUMAS") == "1";
    pasa(c.LISTA, dibuja);
    const std::vector<Json> sospechas = c.sospechas.todas(ventanaLisa());
    std::vector<Json> pixeles;
    std::istringstream pedidos(variable("LAB_EXPLICA_PIXELES"));
    int x, y;
    char coma;
    while (pedidos >> x >> coma >> y)
        pixeles.push_back(explicaPixel(dibuja, x, y));
    Json json;
    json.pon("talla", std::array<int, 2>{ancho, alto}).pon("ordenes", c.ordenes);
    json.pon("sospechas", sospechas).pon("programas", programasJson()).pon("pixeles", pixeles);
    std::ofstream(fichero) << json.texto() << '\n';
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
