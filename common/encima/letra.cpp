#include "letra.h"
#include "error.h"
#include "rutas.h"
#include <cstring>

const unsigned char *Letra::texels() const {
    return reinterpret_cast<const unsigned char *>(fichero.data());
}

CajaSigno Letra::caja(int signo) const {
    CajaSigno c;
    std::memcpy(&c, texels() + ANCHO_ATLAS * ALTO_ATLAS + signo * int(sizeof c), sizeof c);
    return c;
}

const Letra &letra() {
    static const Letra unica = [] {
        const std::string nombre = "assets/letra.r8";
        const std::size_t tamano = ANCHO_ATLAS * ALTO_ATLAS + SIGNOS.size() * sizeof(CajaSigno);
        Letra l{leeFichero(recurso(nombre))};
        if (l.fichero.size() != tamano)
            falla("«" + nombre + "» debe ocupar " + std::to_string(tamano) + " bytes y ocupa " +
                  std::to_string(l.fichero.size()));
        return l;
    }();
    return unica;
}
