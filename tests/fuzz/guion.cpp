// Los guiones, dados en la línea de órdenes o, si la entrada empieza por @, en un fichero; y el tamaño de -geometry.
#include "glut_sin_ventana/guion.h"
#include "soporte.h"

namespace sin_ventana {}
using namespace sin_ventana;

int LLVMFuzzerTestOneInput(const std::uint8_t *datos, std::size_t n) {
    const std::string texto(datos, datos + n);
    const bool deFichero = n > 0 && datos[0] == '@';
    ficheros["g"] = deFichero ? texto.substr(1) : "";
    lee([&] {
        for (const Orden &o : leeGuion(deFichero ? "@g" : texto))
            exige(!o.lugar.empty());
    });
    // el mensaje cita el argumento, que en una línea de órdenes también puede llevar un fin de línea
    if (texto.find('\n') == std::string::npos)
        lee([&] {
            int ancho = 0, alto = 0;
            tallaDe(texto, ancho, alto, "-geometry");
            exige(ancho >= 1 && alto >= 1 && ancho <= 16384 && alto <= 16384);
        });
    return 0;
}
