// Todos los programas están en el mismo binario: su main es main_NOMBRE (herramientas/cmake/web.cmake) y aquí se elige.
#include "error.h"
#include <cerrno> // program_invocation_short_name
#include <cstring>

#define PROGRAMA(nombre) int main_##nombre(int, char **);
#include "programas.inc"
#undef PROGRAMA

int main(int argc, char **argv) {
    program_invocation_short_name = argv[0];
#define PROGRAMA(nombre)                                                                                     \
    if (!std::strcmp(argv[0], #nombre))                                                                      \
        return main_##nombre(argc, argv);
#include "programas.inc"
#undef PROGRAMA
    falla("no hay ningún programa que se llame así");
}
