// La opción -sesion: el programa arranca una vez y cada guion sigue en un proceso desdoblado de él. Arrancar es casi todo lo que
// cuesta un guion corto: Mesa y LLVM, los shaders, las texturas.
#include "../error.h"
#include "interior.h"
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <iostream>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

namespace sin_ventana {
namespace {

void llevaA(const char *fichero, int descriptor) {
    const int nuevo = open(fichero, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (nuevo < 0 || dup2(nuevo, descriptor) < 0)
        falla("-sesion: no puedo escribir en «" + std::string(fichero) + "»");
    close(nuevo);
}

} // namespace

void preparaSesion() {
    setenv("LP_NUM_THREADS", "0", 1); // los hilos no se desdoblan
}

std::vector<std::string> abreSesion() {
    const auto contesta = [](int estado) { dprintf(STDIN_FILENO, "%d\n", estado); };
    std::cin.tie(nullptr); // lo que el programa ha escrito y no ha salido aún lo escribe cada uno
    contesta(0);
    for (std::string linea; std::getline(std::cin, linea);) {
        const pid_t hijo = fork();
        if (hijo == 0) {
            // sin lo que Mesa hace al salir, que espera a un hilo que aquí no está
            on_exit([](int estado, void *) { std::fflush(stdout), _exit(estado); }, nullptr);
            std::vector<std::string> campos;
            std::istringstream texto(linea + '\t'); // el último campo puede estar vacío
            for (std::string campo; std::getline(texto, campo, '\t');)
                campos.push_back(campo);
            if (chdir(campos[0].c_str()) != 0)
                falla("-sesion: no está la carpeta «" + campos[0] + "»", 2);
            llevaA("errores", STDERR_FILENO);
            llevaA("salida", STDOUT_FILENO);
            return {campos.begin() + 1, campos.end()};
        }
        int estado = 0;
        if (hijo < 0 || waitpid(hijo, &estado, 0) != hijo)
            falla("-sesion: no puedo desdoblar el programa");
        contesta(WIFEXITED(estado) ? WEXITSTATUS(estado) : 128 + WTERMSIG(estado));
    }
    std::_Exit(0);
}

} // namespace sin_ventana
