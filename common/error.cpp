#include "error.h"
#include <cerrno> // program_invocation_short_name, de glibc
#include <cstdio>
#include <cstdlib>

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
