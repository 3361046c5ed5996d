// Los guiones, dados en la línea de órdenes o, si la entrada empieza por @, en un fichero; y el tamaño de -geometry.
#include "glut_sin_ventana/guion.h"
#include "soporte.h"
#include <cstdlib>

namespace sin_ventana {}
using namespace sin_ventana;

int LLVMFuzzerTestOneInput(const std::uint8_t *datos, std::size_t n) {
    const std::string texto(datos, datos + n);
    const bool deFichero = n > 0 && datos[0] == '@';
    ficheros["g"] = deFichero ? texto.substr(1) : "";
    lee([&] {
        for (const Orden &o : leeGuion(deFichero ? "@g" : texto)) {
            exige(!o.lugar.empty() && o.veces >= 1 && o.veces <= 10000);
            for (const Talla ventana : {Talla{1, 1}, Talla{240, 180}, Talla{16384, 16384}}) {
                const Punto raton = ratonEn(o, ventana);
                exige(std::abs(raton.x) <= 100000 && std::abs(raton.y) <= 100000);
            }
        }
    });
    // el mensaje cita el argumento, que en una línea de órdenes también puede llevar un fin de línea
    if (texto.find('\n') == std::string::npos)
        lee([&] {
            const Talla t = tallaDe(texto, "-geometry");
            exige(t.ancho >= 1 && t.alto >= 1 && t.ancho <= 16384 && t.alto <= 16384);
        });
    return 0;
}
