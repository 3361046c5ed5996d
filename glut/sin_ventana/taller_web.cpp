// El main de un programa que se compila en la página (./lab web): lo que programas_web.cpp es para los demás. Clang
// llama así al de quien lo escribe, según tenga argumentos o no.
#undef NDEBUG // el JavaScript que se hace con él tiene que dar también lo que usa assert
#include "error.h"
#include <cassert>
#include <cerrno> // program_invocation_short_name
#include <emscripten.h>

// Si se ha pasado la hora a que la página espera que acabe (herramientas/web/programa.mjs), no acaba.
// clang-format off
EM_JS(void, laboratorioVigila, (), {
    if (performance.now() > Module["hasta"]) throw new Error("no acaba");
});
// clang-format on

extern "C" {
[[gnu::weak]] int __main_argc_argv(int, char **);
[[gnu::weak]] int __main_void(void);

// Clang la llama en cada bucle y en cada rama de lo que se compila en la página.
void __sanitizer_cov_trace_pc(void) {
    static unsigned veces = 0;
    if (++veces % 65536 == 0)
        laboratorioVigila();
}
}

int main(int argc, char **argv) {
    assert(argc > 0);
    program_invocation_short_name = argv[0];
    if (__main_argc_argv)
        return __main_argc_argv(argc, argv);
    if (__main_void)
        return __main_void();
    falla("el programa no tiene main(int argc, char **argv)");
}
