#include "guion.h"
#include "../error.h"
#include "../numero.h"
#include "../rutas.h"
#include <GL/freeglut.h>
#include <algorithm>
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
  -ayuda                  esta lista
Órdenes del guion:
  tecla X                 un carácter, o Esc, Espacio, Intro, Tab, Retroceso, Supr, PuntoYComa
  especial F1             F1 a F12, IZQUIERDA, DERECHA, ARRIBA, ABAJO, INICIO, FIN, REPAG, AVPAG, INSERTAR
  boton IZQUIERDO abajo X Y    también CENTRAL o DERECHO, y arriba
  arrastra X Y            mueve el ratón con un botón pulsado
  mueve X Y               mueve el ratón sin pulsar
  rueda +1 X Y            o -1
  menu Ruta/Opción        elige en el menú del programa
  tamano ANCHO ALTO       cambia el tamaño de la ventana
  espera MS               avanza el reloj virtual; los temporizadores vencen
  captura FICHERO         guarda la imagen de ese momento
Estados de salida: 0 bien; 1 error del programa; 2 opción o guion mal escritos; 3 error de OpenGL.
)";

namespace {

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
const int LADO_MAXIMO = 16384, COORDENADA_MAXIMA = 100000, ESPERA_MAXIMA = 1000000000;

/// Una orden partida en palabras, que se van tomando y comprobando.
struct Palabras {
    std::vector<std::string> palabras;
    std::string lugar;
    std::size_t siguiente = 1;

    std::string toma(const char *que) {
        if (siguiente >= palabras.size())
            falla(lugar + ": falta " + que, 2);
        return palabras[siguiente++];
    }
    int entero(const char *que, int minimo, int maximo) {
        return enteroDe(toma(que), minimo, maximo, lugar);
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
    Palabras p{{}, lugar};
    for (std::string palabra; entrada >> palabra;)
        p.palabras.push_back(palabra);
    const std::string &nombre = p.palabras[0];
    Orden o{};
    o.lugar = lugar;
    auto raton = [&] {
        o.x = p.entero("la x", -COORDENADA_MAXIMA, COORDENADA_MAXIMA);
        o.y = p.entero("la y", -COORDENADA_MAXIMA, COORDENADA_MAXIMA);
    };
    auto resto = [&](const char *que) {
        o.texto = p.toma(que);
        while (p.siguiente < p.palabras.size())
            o.texto += " " + p.toma(que);
    };
    if (nombre == "tecla") {
        o.tipo = Orden::TECLA;
        if (p.palabras.size() > 1 && p.palabras[1].size() == 1)
            o.a = static_cast<unsigned char>(p.toma("la tecla")[0]);
        else
            o.a = p.una(TECLAS, "una tecla (un carácter ASCII o su nombre)");
    } else if (nombre == "especial") {
        o.tipo = Orden::ESPECIAL;
        o.a = p.una(ESPECIALES, "una tecla especial");
    } else if (nombre == "boton") {
        o.tipo = Orden::BOTON;
        o.a = p.una(BOTONES, "un botón");
        o.b = p.una(SENTIDOS, "un movimiento del botón");
        raton();
    } else if (nombre == "arrastra") {
        o.tipo = Orden::ARRASTRA;
        raton();
    } else if (nombre == "mueve") {
        o.tipo = Orden::MUEVE;
        raton();
    } else if (nombre == "rueda") {
        o.tipo = Orden::RUEDA;
        o.a = p.una(RUEDA, "un giro de la rueda");
        raton();
    } else if (nombre == "menu") {
        o.tipo = Orden::MENU;
        resto("la ruta de la opción");
    } else if (nombre == "tamano") {
        o.tipo = Orden::TAMANO;
        o.a = p.entero("el ancho", 1, LADO_MAXIMO);
        o.b = p.entero("el alto", 1, LADO_MAXIMO);
    } else if (nombre == "espera") {
        o.tipo = Orden::ESPERA;
        o.a = p.entero("los milisegundos", 0, ESPERA_MAXIMA);
    } else if (nombre == "captura") {
        o.tipo = Orden::CAPTURA;
        resto("el fichero");
    } else {
        falla(lugar + ": no conozco la orden «" + nombre +
                  "»; hay tecla, especial, boton, arrastra, mueve, rueda, menu, tamano, espera y captura",
              2);
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

void tallaDe(const std::string &texto, int &ancho, int &alto, const std::string &lugar) {
    // como en X, puede seguir la posición (+10-10), que aquí no significa nada
    const std::size_t x = std::min(texto.find_first_of("+-"), texto.size());
    const std::size_t y = std::min(texto.find_first_of("+-", x + 1), texto.size());
    const auto desde = [&](std::size_t i, std::size_t fin) { // lo que va tras el signo
        return i < fin ? numeroDe<int>(texto.substr(i + 1, fin - i - 1)) : std::nullopt;
    };
    if (!leeTalla(texto.substr(0, x), ancho, alto) ||
        (x < texto.size() && !(desde(x, y) && desde(y, texto.size()))))
        falla(lugar + ": «" + texto + "» no es un tamaño ANCHOxALTO", 2);
    if (std::max(ancho, alto) > LADO_MAXIMO)
        falla(lugar + ": «" + texto + "» pasa de " + std::to_string(LADO_MAXIMO) + " píxeles de lado", 2);
}

std::vector<Orden> leeGuion(const std::string &guion) {
    const bool deFichero = !guion.empty() && guion[0] == '@';
    std::string contenido = guion, error;
    if (deFichero && !intentaLeer(guion.substr(1), contenido, error))
        falla("-guion: " + error, 2);
    std::istringstream texto(contenido);
    std::vector<Orden> ordenes;
    std::string linea, orden;
    for (int numero = 1; std::getline(texto, linea); ++numero) {
        if (deFichero && linea[std::min(linea.find_first_not_of(BLANCOS), linea.size())] == '#')
            continue;
        std::istringstream partes(linea);
        while (std::getline(partes, orden, ';')) {
            const std::size_t inicio = orden.find_first_not_of(BLANCOS);
            if (inicio == std::string::npos)
                continue;
            orden = orden.substr(inicio, orden.find_last_not_of(BLANCOS) - inicio + 1);
            const std::string donde = deFichero ? guion.substr(1) + ":" + std::to_string(numero)
                                                : "guion, orden " + std::to_string(ordenes.size() + 1);
            ordenes.push_back(analiza(orden, donde + " «" + orden + "»"));
        }
    }
    return ordenes;
}

} // namespace sin_ventana
