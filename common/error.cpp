#include "error.h"
#include <cerrno> // program_invocation_short_name, de glibc
#include <cstdio>
#include <cstdlib>
#include <cstring>

std::string nombrePrograma() {
    return program_invocation_short_name;
}

void avisa(const std::string &mensaje) {
    std::fprintf(stderr, "%s: aviso: %s\n", program_invocation_short_name, mensaje.c_str());
}

void falla(const std::string &mensaje, int estado) {
    std::fflush(stdout);
    std::fprintf(stderr, "%s: %s\n", program_invocation_short_name, mensaje.c_str());
    std::exit(estado);
}

void compruebaSalida() {
    if (std::fflush(stdout) == 0 && !std::ferror(stdout))
        return;
    std::fprintf(stderr, "%s: no puedo escribir en la salida: %s\n", program_invocation_short_name,
                 std::strerror(errno));
    std::_Exit(1);
}
