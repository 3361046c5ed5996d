// partida SEMILLA CARPETA: en CARPETA, los ficheros tandas, guion, real y titulos de esa partida para una ventana.
#include "partida.h"
#include <cstdlib>
#include <fstream>

int main(int, char **argv) {
    const partida::Partida p(unsigned(std::atoi(argv[1])), true);
    for (const auto &[nombre, texto] :
         {std::pair("tandas", p.tandas), {"guion", p.guion}, {"real", p.real}, {"titulos", p.titulos}})
        std::ofstream(std::string(argv[2]) + "/" + nombre) << texto;
}
