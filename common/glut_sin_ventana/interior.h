// Lo que los ficheros de glut_sin_ventana se piden unos a otros.
#pragma once
#include <string>
#include <vector>

namespace sin_ventana {

// glut.cpp

/// Llama a la función de dibujo del programa.
void dibujaCuadro();

/// Termina con estado 3 si ha habido un error de OpenGL desde la última vez. `donde`: qué se acaba de hacer.
void compruebaGL(const std::string &donde);

// menus.cpp

/// Busca «Submenú/Opción» en los menús asignados a los botones y llama a la función del que la contiene; si no está, termina
/// con estado 2, diciendo `lugar`.
void eligeEnMenu(const std::string &ruta, const std::string &lugar);

/// Las rutas de todas las opciones de esos menús.
std::vector<std::string> opcionesDeMenu();

bool hayMenuAbierto();

/// Si lo que le ha pasado a ese botón abre o cierra un menú.
bool loAtiendeUnMenu(int boton, bool pulsado);

// medida.cpp

/// Lo que tarda f, hasta que OpenGL ha acabado.
double milisegundosDe(void (*f)());

/// La línea TSV de la opción -mide, con `cuadros` imágenes más. `primera`: lo que costó la primera, en ms.
void mideCuadros(int cuadros, double primera);

} // namespace sin_ventana
