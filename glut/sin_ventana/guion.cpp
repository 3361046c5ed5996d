#include "guion.h"
#include "aspecto.h"
#include "error.h"
#include "numero.h"
#include "rutas.h"
#include <GL/freeglut.h>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <sstream>

namespace sin_ventana {

const char *const AYUDA = R"(Opciones de la ventana sin pantalla:
  -geometry ANCHOxALTO    tamaño de la imagen (el que pida el programa, si no se da)
  -guion "ORDEN; ORDEN"   sucesos, en orden; -guion @fichero los lee de un fichero
  -ppm FICHERO            dónde va la última imagen (<programa>.ppm, si no se da)
  -mide N                 dibuja N veces más y escribe una línea TSV: programa, tamaño, primera ms,
                          mediana ms, mínimo ms, máximo ms, primitivas, renderizador, bytes de buffer objects
                          y bytes de texturas
  -rasgos                 en vez de guardar la imagen escribe de qué se entera el programa, un rasgo por línea: teclado,
                          especial, raton, arrastre, movimiento, rueda, ocio, temporizador, opcion Ruta/Opción
  -titulos FICHERO        escribe en él (-: en la salida) cada título que pone el programa: «título: …»
  -diario                 escribe tras cada orden, y al empezar, una línea TSV: diario, la orden, resumen de la imagen,
                          «otra» si al repetir el cuadro sale otra, título, lo que el cuadro no deja como estaba en
                          OpenGL, cuántos buffer objects, texturas, programas, shaders, framebuffers, renderbuffers y
                          vertex arrays hay, bytes que ocupan y temporizadores que esperan. Tras espera se dibuja antes
                          el cuadro de ese momento
  -lento MS               como en un ordenador lento: un temporizador no vence hasta el primer múltiplo de MS
  -sin_planos             la escena no se corta en los planos cerca y lejos (GL_DEPTH_CLAMP)
  -ayuda                  esta lista
Órdenes del guion:
  tecla X                 un carácter, su código (10 a 255) o Esc, Espacio, Intro, Tab, Retroceso, Supr, PuntoYComa
  especial F1             F1 a F12, IZQUIERDA, DERECHA, ARRIBA, ABAJO, INICIO, FIN, REPAG, AVPAG, INSERTAR o un código
  boton IZQUIERDO abajo X Y    también CENTRAL, DERECHO o, de un ratón con más, 5 a 8; y arriba
  arrastra X Y            mueve el ratón con un botón pulsado
  mueve X Y               mueve el ratón sin pulsar
  rueda +1 X Y            o -1
  menu Ruta/Opción        elige en el menú del programa
  tamano ANCHO ALTO       cambia el tamaño de la ventana
  espera MS               avanza el reloj virtual; los temporizadores vencen
  captura FICHERO         guarda la imagen de ese momento
  escala ANCHO ALTO       el ratón de las órdenes que siguen es el de una ventana de ese tamaño
  ORDEN ×N                cualquiera, N veces (hasta 10000). La última palabra, si empieza por ×, siempre es esto:
                          la opción «A ×2» de un menú se elige con menu A ×2 ×1
Estados de salida: 0 bien; 1 error del programa; 2 opción o guion mal escritos; 3 error de OpenGL.
)";

namespace {

const std::map<std::string, int> ORDENES = {
    {"tecla", Orden::TECLA},       {"especial", Orden::ESPECIAL}, {"boton", Orden::BOTON},
    {"arrastra", Orden::ARRASTRA}, {"mueve", Orden::MUEVE},       {"rueda", Orden::RUEDA},
    {"menu", Orden::MENU},         {"tamano", Orden::TAMANO},     {"espera", Orden::ESPERA},
    {"captura", Orden::CAPTURA},   {"escala", Orden::ESCALA}};

const std::map<std::string, int> TECLAS = {{"Esc", 27},      {"Espacio", 32}, {"Intro", 13},      {"Tab", 9},
                                           {"Retroceso", 8}, {"Supr", 127},   {"PuntoYComa", ';'}};

const std::map<std::string, int> ESPECIALES = {
    {"F1", GLUT_KEY_F1},          {"F2", GLUT_KEY_F2},           {"F3", GLUT_KEY_F3},
    {"F4", GLUT_KEY_F4},          {"F5", GLUT_KEY_F5},           {"F6", GLUT_KEY_F6},
    {"F7", GLUT_KEY_F7},          {"F8", GLUT_KEY_F8},           {"F9", GLUT_KEY_F9},
    {"F10", GLUT_KEY_F10},        {"F11", GLUT_KEY_F11},         {"F12", GLUT_KEY_F12},
    {"IZQUIERDA", GLUT_KEY_LEFT}, {"DERECHA", GLUT_KEY_RIGHT},   {"ARRIBA", GLUT_KEY_UP},
    {"ABAJO", GLUT_KEY_DOWN},     {"INICIO", GLUT_KEY_HOME},     {"FIN", GLUT_KEY_END},
    {"REPAG", GLUT_KEY_PAGE_UP},  {"AVPAG", GLUT_KEY_PAGE_DOWN}, {"INSERTAR", GLUT_KEY_INSERT}};

const std::map<std::string, int> BOTONES = {
    {"IZQUIERDO", GLUT_LEFT_BUTTON}, {"CENTRAL", GLUT_MIDDLE_BUTTON}, {"DERECHO", GLUT_RIGHT_BUTTON}};

const std::map<std::string, int> SENTIDOS = {{"abajo", GLUT_DOWN}, {"arriba", GLUT_UP}};

const std::map<std::string, int> RUEDA = {{"+1", 1}, {"1", 1}, {"-1", -1}};

const char *const BLANCOS = " \t\r\v\f"; // los mismos que separan palabras
const int LADO_MAXIMO = 16384, COORDENADA_MAXIMA = 100000, ESPERA_MAXIMA = 1000000000, VECES_MAXIMAS = 10000;
const std::string POR = "×";

// Una orden partida en palabras, que se van tomando y comprobando.
struct Palabras {
    std::vector<std::string> palabras;
    std::string lugar;
    std::size_t siguiente = 0;

    std::string toma(const char *que) {
        if (siguiente >= palabras.size())
            falla(lugar + ": falta " + que, 2);
        return palabras[siguiente++];
    }
    int entero(const char *que, int minimo, int maximo) {
        return enteroDe(toma(que), minimo, maximo, lugar);
    }
    int tecla() {
        if (siguiente < palabras.size() && palabras[siguiente].size() == 1)
            return static_cast<unsigned char>(toma("la tecla")[0]);
        return codigo(TECLAS, "una tecla (un carácter ASCII, su código o su nombre)", 10);
    }
    Talla talla() {
        const int ancho = entero("el ancho", 1, LADO_MAXIMO);
        return {ancho, entero("el alto", 1, LADO_MAXIMO)};
    }
    Punto raton() {
        const int x = entero("la x", -COORDENADA_MAXIMA, COORDENADA_MAXIMA);
        return {x, entero("la y", -COORDENADA_MAXIMA, COORDENADA_MAXIMA)};
    }
    std::string resto(const char *que) {
        std::string texto = toma(que);
        while (siguiente < palabras.size())
            texto += " " + toma(que);
        return texto;
    }
    // Quita el ×N del final. La primera palabra es la orden, empiece como empiece.
    int veces() {
        if (palabras.size() < 2 || palabras.back().rfind(POR, 0) != 0)
            return 1;
        const std::string palabra = palabras.back();
        palabras.pop_back();
        const std::optional<int> n = numeroDe<int>(palabra.substr(POR.size()));
        if (!n || *n < 1 || *n > VECES_MAXIMAS)
            falla(lugar + ": «" + palabra + "» no es ×N, con N entre 1 y " + std::to_string(VECES_MAXIMAS),
                  2);
        return *n;
    }
    int codigo(const std::map<std::string, int> &tabla, const char *que, int minimo, int maximo = 255) {
        const bool esNumero = siguiente < palabras.size() && numeroDe<int>(palabras[siguiente]);
        return esNumero ? entero(que, minimo, maximo) : una(tabla, que);
    }
    int una(const std::map<std::string, int> &tabla, const char *que) {
        const std::string palabra = toma(que);
        const auto i = tabla.find(palabra);
        if (i != tabla.end())
            return i->second;
        std::string validas;
        for (const auto &par : tabla)
            validas += " " + par.first;
        falla(lugar + ": «" + palabra + "» no es " + que + "; valen" + validas, 2);
    }
};

Orden analiza(const std::string &texto, const std::string &lugar) {
    std::istringstream entrada(texto);
    Palabras p{{std::istream_iterator<std::string>(entrada), {}}, lugar};
    Orden o{};
    o.lugar = lugar;
    o.veces = p.veces();
    o.palabras = p.palabras;
    o.tipo = Orden::Tipo(p.una(ORDENES, "una orden"));
    switch (o.tipo) {
    case Orden::TECLA: o.tecla = p.tecla(); break;
    case Orden::ESPECIAL: o.tecla = p.codigo(ESPECIALES, "una tecla especial", 0); break;
    case Orden::BOTON:
        o.boton = p.codigo(BOTONES, "un botón", GLUT_RIGHT_BUTTON + 3, BOTON_MAXIMO);
        o.sentido = p.una(SENTIDOS, "un movimiento del botón");
        o.raton = p.raton();
        break;
    case Orden::ARRASTRA:
    case Orden::MUEVE: o.raton = p.raton(); break;
    case Orden::RUEDA:
        o.giro = p.una(RUEDA, "un giro de la rueda");
        o.raton = p.raton();
        break;
    case Orden::MENU: o.texto = p.resto("la ruta de la opción"); break;
    case Orden::CAPTURA: o.texto = p.resto("el fichero"); break;
    case Orden::TAMANO:
    case Orden::ESCALA: o.talla = p.talla(); break;
    case Orden::ESPERA: o.ms = p.entero("los milisegundos", 0, ESPERA_MAXIMA); break;
    }
    if (p.siguiente < p.palabras.size())
        falla(lugar + ": sobra «" + p.palabras[p.siguiente] + "»", 2);
    return o;
}

} // namespace

int enteroDe(const std::string &texto, int minimo, int maximo, const std::string &lugar) {
    const std::optional<int> n = numeroDe<int>(texto);
    if (!n || *n < minimo || *n > maximo)
        falla(lugar + ": «" + texto + "» no es un número entre " + std::to_string(minimo) + " y " +
                  std::to_string(maximo),
              2);
    return *n;
}

Talla tallaDe(const std::string &texto, const std::string &lugar) {
    // como en X, puede seguir la posición (+10-10), que aquí no significa nada
    const std::size_t x = std::min(texto.find_first_of("+-"), texto.size());
    const std::size_t y = std::min(texto.find_first_of("+-", x + 1), texto.size());
    const auto desde = [&](std::size_t i, std::size_t fin) { // lo que va tras el signo
        return i < fin ? numeroDe<int>(texto.substr(i + 1, fin - i - 1)) : std::nullopt;
    };
    Talla t;
    if (!leeTalla(texto.substr(0, x), t.ancho, t.alto) ||
        (x < texto.size() && !(desde(x, y) && desde(y, texto.size()))))
        falla(lugar + ": «" + texto + "» no es un tamaño ANCHOxALTO", 2);
    if (std::max(t.ancho, t.alto) > LADO_MAXIMO)
        falla(lugar + ": «" + texto + "» pasa de " + std::to_string(LADO_MAXIMO) + " píxeles de lado", 2);
    return t;
}

Punto ratonEn(const Orden &orden, Talla ventana) {
    if (orden.escala.ancho == 0)
        return orden.raton;
    const double k =
        altoUtilDe(ventana.ancho, ventana.alto) / altoUtilDe(orden.escala.ancho, orden.escala.alto);
    const auto pixel = [&](int coordenada, int enEscala, int enVentana) {
        const double p = std::round(enVentana / 2.0 + (coordenada - enEscala / 2.0) * k);
        return int(std::clamp(p, -double(COORDENADA_MAXIMA), double(COORDENADA_MAXIMA)));
    };
    return {pixel(orden.raton.x, orden.escala.ancho, ventana.ancho),
            pixel(orden.raton.y, orden.escala.alto, ventana.alto)};
}

std::vector<Orden> leeGuion(const std::string &guion) {
    const bool deFichero = !guion.empty() && guion[0] == '@';
    std::string contenido = guion, error;
    if (deFichero && !intentaLeer(guion.substr(1), contenido, error))
        falla("-guion: " + error, 2);
    std::istringstream texto(contenido);
    std::vector<Orden> ordenes;
    Talla escala;
    std::string linea, orden;
    int numeroOrden = 0;
    for (int numeroLinea = 1; std::getline(texto, linea); ++numeroLinea) {
        if (deFichero && linea[std::min(linea.find_first_not_of(BLANCOS), linea.size())] == '#')
            continue;
        std::istringstream partes(linea);
        while (std::getline(partes, orden, ';')) {
            const std::size_t inicio = orden.find_first_not_of(BLANCOS);
            if (inicio == std::string::npos)
                continue;
            orden = orden.substr(inicio, orden.find_last_not_of(BLANCOS) - inicio + 1);
            ++numeroOrden;
            const std::string donde = deFichero ? guion.substr(1) + ":" + std::to_string(numeroLinea)
                                                : "guion, orden " + std::to_string(numeroOrden);
            Orden o = analiza(orden, donde + " «" + orden + "»");
            o.escala = escala;
            if (o.tipo == Orden::ESCALA)
                escala = o.talla;
            else
                ordenes.push_back(o);
        }
    }
    return ordenes;
}

} // namespace sin_ventana
