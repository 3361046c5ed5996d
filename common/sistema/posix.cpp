#include "sistema.h"
#include <cerrno> // program_invocation_short_name, de glibc
#include <unistd.h>

const char SEPARADOR_DE_CARPETAS = ':';
const int FREEGLUT_CON_UTF8 = 30800; // los anteriores los dan a X11 como Latin-1

std::filesystem::path ejecutable() {
    std::error_code noSeSabe;
    return std::filesystem::read_symlink("/proc/self/exe", noSeSabe);
}

std::string nombreDelEjecutable() {
    return program_invocation_short_name;
}

int numeroDeProceso() {
    return getpid();
}
