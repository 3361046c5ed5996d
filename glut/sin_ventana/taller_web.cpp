// El main de un programa que se compila en la página (./lab web): lo que programas_web.cpp es para los demás. Clang llama
// así al de quien lo escribe, según tenga argumentos o no.
#include "error.h"
#include <cerrno> // program_invocation_short_name

extern "C" {
[[gnu::weak]] int __main_argc_argv(int, char **);
[[gnu::weak]] int __main_void(void);
}

int main(int argc, char **argv) {
    program_invocation_short_name = argv[0];
    if (__main_argc_argv)
        return __main_argc_argv(argc, argv);
    if (__main_void)
        return __main_void();
    falla("el programa no tiene main(int argc, char **argv)");
}
