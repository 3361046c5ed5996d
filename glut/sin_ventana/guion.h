// El guion: los sucesos que glut_sin_ventana da a un programa, en orden. La lista de órdenes está en AYUDA.
#pragma once
#include <string>
#include <vector>

namespace sin_ventana {

const int BOTON_MAXIMO = 8; // de un ratón con los de los lados; el 3 y el 4 son la rueda

struct Talla {
    int ancho = 0, alto = 0;
};

struct Punto {
    int x = 0, y = 0;
};

struct Orden {
    enum Tipo { TECLA, ESPECIAL, BOTON, ARRASTRA, MUEVE, RUEDA, MENU, TAMANO, ESPERA, CAPTURA, ESCALA };
    Tipo tipo;
    std::vector<std::string> palabras; // como está escrita, sin ×N
    std::string lugar;                 // dónde, para los errores: «guion, orden 2 «tecla ab»»
    int veces = 1;
    int tecla = 0;   // un carácter, o GLUT_KEY_… si es especial
    int boton = 0;   // GLUT_LEFT_BUTTON…
    int sentido = 0; // GLUT_DOWN o GLUT_UP
    int giro = 0;    // de la rueda, ±1
    Punto raton;     // desde la esquina superior izquierda; ratonEn dice a qué píxel va
    Talla escala;    // la ventana de la que es `raton`; 0×0: la que haya
    Talla talla;     // la de tamano y la de escala
    int ms = 0;
    std::string texto; // ruta del menú o fichero
};

/// Píxel de una ventana de esa talla al que va el ratón. Las escenas se componen para 4:3 y las demás ventanas enseñan
/// más alrededor (common/aspecto.h): lo que está a d píxeles del centro de la escala está a d·k del centro de la
/// ventana, con k el cociente de sus altos útiles.
Punto ratonEn(const Orden &orden, Talla ventana);

/// Analiza un guion: órdenes separadas por `;` o por fin de línea; en un fichero («@fichero»), una línea que
/// empieza por `#` es un comentario.
/// Las órdenes `escala` no están: cada una dice en `escala` la suya.
/// Una orden que no se entiende termina con estado 2 nombrando el lugar.
std::vector<Orden> leeGuion(const std::string &guion);

/// Entero en [minimo, maximo]; si no lo es termina con estado 2, diciendo `lugar`.
int enteroDe(const std::string &texto, int minimo, int maximo, const std::string &lugar);

/// «ANCHOxALTO» en píxeles, entre 1 y 16384.
Talla tallaDe(const std::string &texto, const std::string &lugar);

/// Lo que escribe la opción -ayuda.
extern const char *const AYUDA;

} // namespace sin_ventana
