#include "error.h"
#include "sistema/sistema.h"
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

std::string nombrePrograma() {
    return nombreDelEjecutable();
}

void avisa(const std::string &mensaje) {
    std::fprintf(stderr, "%s: aviso: %s\n", nombrePrograma().c_str(), mensaje.c_str());
    std::fflush(stderr); // en Windows se guarda hasta que se pide
}

void falla(const std::string &mensaje, int estado) {
    std::fflush(stdout);
    std::fprintf(stderr, "%s: %s\n", nombrePrograma().c_str(), mensaje.c_str());
    std::exit(estado);
}

void compruebaSalida() {
    if (std::fflush(stdout) == 0 && !std::ferror(stdout))
        return;
    std::fprintf(stderr, "%s: no puedo escribir en la salida: %s\n", nombrePrograma().c_str(),
                 std::strerror(errno));
    std::_Exit(1);
}
