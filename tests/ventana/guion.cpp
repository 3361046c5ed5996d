// guion ANCHOxALTO GUION: lo que un guion manda hacer en una ventana que empieza con esa talla, ya sin repeticiones ni
// escalas. Cada línea es «X Y orden»: el píxel al que va el ratón, si la orden lo lleva, y ella como está escrita.
#include "glut/sin_ventana/guion.h"
#include "error.h"
#include <cstdio>

using namespace sin_ventana;

int main(int argc, char **argv) {
    if (argc != 3)
        falla("uso: guion ANCHOxALTO GUION", 2);
    Talla ventana = tallaDe(argv[1], "guion");
    for (const Orden &o : leeGuion(argv[2])) {
        const Punto raton = ratonEn(o, ventana);
        std::string linea = std::to_string(raton.x) + " " + std::to_string(raton.y);
        for (const std::string &palabra : o.palabras)
            linea += " " + palabra;
        for (int i = 0; i < o.veces; ++i)
            std::puts(linea.c_str());
        if (o.tipo == Orden::TAMANO)
            ventana = o.talla;
    }
    return 0;
}
