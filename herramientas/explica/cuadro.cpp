#include "cuadro.h"
#include "enviado.h"
#include "imagenes.h"
#include "pila.h"
#include "pixel.h"
#include "programas.h"
#include "sombreado.h"
#include "sospechas.h"
#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace explica {
namespace {

struct Copia {
    int numero; // el de la orden
    GLuint origen, destino;
    Orden orden;
};

struct Cuadro {
    enum Pasada { NADA, CUENTA, LISTA, PIXEL, SOMBREADO } pasada = NADA;
    int ancho = 0, alto = 0, numero = 0; // de la orden
    Pedido que;
    std::vector<Json> ordenes;
    std::vector<Suceso> sucesos;
    int ordenSombreada = 0, primitivaSombreada = -1;
    Json sombreado;
    Sospechas sospechas;
    std::vector<Copia> copias;
    struct Pintada {
        int numero;
        GLuint textura, framebuffer;
    };
    std::vector<Pintada> pintadas; // las texturas, al dibujar en un framebuffer que tiene una
    GLuint framebuffer = 0; // el del píxel que se explica: la ventana o, de una textura, el que la pinta
    std::map<GLuint, Punto> pixel; // en cada framebuffer
    std::set<GLuint> programas;
} c;
bool enOrden = false; // si lo que se llama no es del programa

void apuntaOrden(const Orden &orden) {
    const Lienzo lienzo = lienzoActual(c.ancho, c.alto);
    Json json = describe(orden, lienzo);
    json.pon("pila", pilaActual());
    if (lienzo.textura)
        c.pintadas.push_back({c.numero, lienzo.textura, lienzo.nombre});
    const bool dibuja = orden.que == Orden::Que::Dibuja;
    const Cableado cableado = dibuja ? cableadoActual(c.que.sumas) : Cableado();
    c.sospechas.antes(orden, lienzo, cableado, c.numero);
    if (dibuja) {
        if (const GLuint programa = GLuint(entero(GL_CURRENT_PROGRAM)))
            c.programas.insert(programa);
        const long fragmentos = dibujaYCuenta(orden.hazla, c.numero);
        const std::string nada = c.sospechas.despues(orden, lienzo, cableado, c.numero, fragmentos);
        json.pon("fragmentos", fragmentos).pon("nada", nada).pon("cableado", deCableado(cableado));
    } else {
        orden.hazla();
    }
    if (orden.que == Orden::Que::Copia && (orden.buferes & GL_COLOR_BUFFER_BIT))
        c.copias.push_back({c.numero, GLuint(entero(GL_READ_FRAMEBUFFER_BINDING)), lienzo.nombre, orden});
    if (c.que.imagenes) {
        const Guardado guardado;
        apuntaImagenes(lienzo, json, dibuja);
    }
    c.ordenes.push_back(json.pon("n", c.numero));
}

void llegaOrden(const Orden &orden) {
    ++c.numero;
    if (c.pasada == c.CUENTA && orden.que == Orden::Que::Dibuja)
        return preguntaSiDibuja(orden.hazla, c.numero);
    if (c.pasada == c.CUENTA)
        return orden.hazla();
    if (c.pasada == c.LISTA)
        return apuntaOrden(orden);
    const auto suyo = c.pixel.find(GLuint(entero(GL_DRAW_FRAMEBUFFER_BINDING)));
    const auto &[textura, hasta] = c.que.textura;
    const bool seMira =
        suyo != c.pixel.end() &&
        (!textura || (c.numero < hasta &&
                      (suyo->first != c.framebuffer || lienzoActual(c.ancho, c.alto).textura == textura)));
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
    if (c.que.imagenes)
        c.sombreado.pon("malla", mallaEnJson(orden));
    orden.hazla();
}

// El píxel del framebuffer de que viene, por una copia, ese; y así hacia atrás.
std::map<GLuint, Punto> enCadaFramebuffer(Punto p) {
    std::map<GLuint, Punto> donde = {{c.framebuffer, p}};
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

void pasa(Cuadro::Pasada pasada, void (*dibuja)()) {
    c.pasada = pasada;
    c.numero = 0;
    dibuja();
    c.pasada = c.NADA;
}

// Lo último que se escribe con una primitiva, si después no se borra: donde se mira o, si lo que llega ahí es una
// copia, en el framebuffer de que se copia. `cambia`: de lo que cambia algo.
const Suceso *quienGana(bool cambia) {
    GLuint framebuffer = c.framebuffer;
    for (auto s = c.sucesos.rbegin(); s != c.sucesos.rend(); ++s) {
        if (s->framebuffer != framebuffer || s->veredicto != "escrito" || (cambia && !s->cambia))
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

Json explicaPixel(void (*dibuja)(), Punto pedido) {
    c.sucesos.clear();
    c.sombreado = Json();
    const auto &[textura, hasta] = c.que.textura;
    const Punto p = {pedido.x, textura ? pedido.y : c.alto - 1 - pedido.y};
    c.framebuffer = 0;
    for (const auto &pintada : c.pintadas)
        if (pintada.textura == textura && pintada.numero < hasta)
            c.framebuffer = pintada.framebuffer;
    c.pixel = {{c.framebuffer, p}};
    if (!EN_WEB) // ahí los demás framebuffers no se pueden leer
        c.pixel = enCadaFramebuffer(p);
    pasa(c.PIXEL, dibuja);
    std::tie(c.ordenSombreada, c.primitivaSombreada) = c.que.sombrea;
    const Suceso *const ganador = quienGana(true) ? quienGana(true) : quienGana(false);
    if (!c.ordenSombreada && ganador)
        std::tie(c.ordenSombreada, c.primitivaSombreada) = std::pair(ganador->orden, ganador->primitiva);
    if (c.ordenSombreada)
        pasa(c.SOMBREADO, dibuja);
    const Guardado guardado;
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    const Lienzo ventana = lienzoActual(c.ancho, c.alto);
    std::optional<Color> color;
    if (!textura) {
        color = leeColor(ventana, p.x, p.y);
        siLoCambiaOtro(ventana, color, c.sucesos);
    }
    std::vector<Json> historia;
    for (const Suceso &s : c.sucesos) {
        historia.push_back(s.json);
        if (textura && s.framebuffer == c.framebuffer) // después puede cambiar
            color = s.queda;
    }
    Json json = {{"pixel", std::array<int, 2>{pedido.x, pedido.y}},
                 {"framebuffer", c.framebuffer},
                 {"color", color},
                 {"historia", historia}};
    if (c.ordenSombreada)
        json.pon("sombreado",
                 c.sombreado.pon("orden", c.ordenSombreada).pon("primitiva", c.primitivaSombreada));
    return json;
}

std::vector<Json> programasJson() {
    std::vector<Json> programas;
    for (const GLuint programa : c.programas) {
        Json json = {{"programa", programa}};
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

// Lo que se llame hasta que se destruya no es del programa.
class EnOrden {
public:
    EnOrden() {
        enOrden = true;
    }
    ~EnOrden() {
        enOrden = false;
    }
    EnOrden(const EnOrden &) = delete;
    EnOrden &operator=(const EnOrden &) = delete;
};

} // namespace

bool seExplica() {
    return c.pasada != c.NADA;
}

bool esNuestro() {
    return enOrden;
}

void llega(const Orden &orden) {
    if (!seExplica() || esNuestro())
        return orden.hazla();
    const EnOrden nuestra;
    llegaOrden(orden);
    while (EN_WEB && glGetError()) { // ninguno es del programa
    }
}

Direccion tapa(const std::string &nombre) {
    const Direccion deOrden = tapaOrden(nombre, llega);
    return deOrden ? deOrden : tapaEnvio(nombre);
}

void pregunta(void (*dibuja)()) {
    pasa(c.CUENTA, dibuja);
}

std::string explica(void (*dibuja)(), int ancho, int alto, const Pedido &que) {
    c = {};
    c.ancho = ancho, c.alto = alto, c.que = que;
    olvidaImagenes();
    olvidaGemelos();
    pasa(c.LISTA, dibuja);
    const auto sospechas = [&] {
        const EnOrden nuestra;
        return c.sospechas.todas(ventanaLisa());
    }();
    std::vector<Json> pixeles;
    for (const Punto p : que.pixeles)
        pixeles.push_back(explicaPixel(dibuja, p));
    Json json = {{"talla", std::array<int, 2>{ancho, alto}},
                 {"ordenes", c.ordenes},
                 {"sospechas", sospechas},
                 {"programas", programasJson()},
                 {"pixeles", pixeles},
                 {"pilas", pilasEnJson()}};
    if (c.que.imagenes)
        json.pon("veces", vecesEnJson());
    return json.texto();
}

} // namespace explica
