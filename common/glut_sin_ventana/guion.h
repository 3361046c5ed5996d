// El guion: los sucesos que glut_sin_ventana da a un programa, en orden. La lista de órdenes está en AYUDA.
#pragma once
#include <string>
#include <vector>

namespace sin_ventana {

struct Orden {
    enum Tipo { TECLA, ESPECIAL, BOTON, ARRASTRA, MUEVE, RUEDA, MENU, TAMANO, ESPERA, CAPTURA };
    Tipo tipo;
    int a = 0;         // tecla, tecla especial, botón, dirección de la rueda, ancho o milisegundos
    int b = 0;         // GLUT_DOWN, GLUT_UP o alto
    int x = 0, y = 0;  // ratón, en píxeles desde la esquina superior izquierda
    std::string texto; // ruta del menú o fichero
    std::string lugar; // dónde está escrita, para los errores: «orden 2 «tecla ab»»
};

/// Analiza un guion: órdenes separadas por `;` o por fin de línea; en un fichero («@fichero»), una línea que
/// empieza por `#` es un comentario.
/// Una orden que no se entiende termina con estado 2 nombrando el lugar.
std::vector<Orden> leeGuion(const std::string &guion);

/// Entero en [minimo, maximo]; si no lo es termina con estado 2, diciendo `lugar`.
int enteroDe(const std::string &texto, int minimo, int maximo, const std::string &lugar);

/// «ANCHOxALTO» en píxeles, entre 1 y 16384.
void tallaDe(const std::string &texto, int &ancho, int &alto, const std::string &lugar);

/// Lo que escribe la opción -ayuda.
extern const char *const AYUDA;

} // namespace sin_ventana
