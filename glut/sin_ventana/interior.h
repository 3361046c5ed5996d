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

/// Busca «Submenú/Opción» en los menús asignados a los botones y llama a la función del que la contiene; si no está,
/// termina con estado 2, diciendo `lugar`.
void eligeEnMenu(const std::string &ruta, const std::string &lugar);

/// Las rutas de todas las opciones de esos menús.
std::vector<std::string> opcionesDeMenu();

bool hayMenuAbierto();

/// Si lo que le ha pasado a ese botón abre o cierra un menú.
bool loAtiendeUnMenu(int boton, bool pulsado);

// medida.cpp

/// Los objetos de OpenGL que hay y lo que ocupan. Deja todo como estaba.
struct Ocupado {
    int buferes = 0, texturas = 0, programas = 0, shaders = 0, framebuffers = 0, renderbuffers = 0, vaos = 0;
    long long bytesBuferes = 0, bytesTexturas = 0;

    int objetos() const {
        return buferes + texturas + programas + shaders + framebuffers + renderbuffers + vaos;
    }
};
Ocupado ocupado();

/// Lo que tarda f, hasta que OpenGL ha acabado.
double milisegundosDe(void (*f)());

/// La línea TSV de la opción -mide, con `cuadros` imágenes más. `primera`: lo que costó la primera, en ms.
void mideCuadros(int cuadros, double primera);

// diario.cpp

/// Desde ahora se apunta lo que queda tras cada orden.
void empiezaDiario();

/// Dibuja y, si hay diario, mira qué del estado de OpenGL no queda como estaba.
void dibujaParaElDiario(void (*dibuja)());

/// Si hay diario, vuelve a dibujar y escribe una línea. `temporizadores`: cuántos esperan.
void apuntaEnElDiario(const std::string &orden, const std::string &titulo, std::size_t temporizadores);

} // namespace sin_ventana

/// Está solo si ./lab explica se pone delante de OpenGL (herramientas/explica/entrada.cpp): dibuja unas veces más y
/// cuenta lo que hace cada orden.
extern "C" [[gnu::weak]] void explicaCuadro(void (*dibuja)(), int ancho, int alto);
