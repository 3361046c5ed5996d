#include "error.h"
#include "glut/sistema/motivo.h"
#include "glut/sistema/sistema.h"
#include <cstdio>
#include <cstdlib>
#include <sstream>

namespace {

const std::size_t LARGO_MAXIMO = 600; // de una línea, en bytes: más no se lee

// Lo que se cita de un fichero puede ser binario, o una línea sin fin: lo que no se puede imprimir se enseña como «?»,
// que a una terminal le diría otra cosa, y de una línea larga quedan el principio y el final.
std::string legible(const std::string &mensaje) {
    std::istringstream lineas(mensaje);
    std::string texto, linea;
    while (std::getline(lineas, linea)) {
        const auto signo = [&](std::size_t i) { // si no, está dentro de uno de UTF-8
            while (i > 0 && (linea[i] & 0xC0) == 0x80)
                --i;
            return i;
        };
        if (linea.size() > LARGO_MAXIMO) {
            const std::size_t fin = signo(linea.size() - LARGO_MAXIMO / 4);
            linea = linea.substr(0, signo(LARGO_MAXIMO / 2)) + " … " + linea.substr(fin);
        }
        for (char &c : linea)
            if ((c >= 0 && c < ' ' && c != '\t') || c == 0x7F)
                c = '?';
        texto += (texto.empty() ? "" : "\n") + linea;
    }
    return texto;
}

void escribe(const char *que, const std::string &mensaje) {
    std::fprintf(stderr, "%s: %s%s\n", nombrePrograma().c_str(), que, legible(mensaje).c_str());
    std::fflush(stderr); // en Windows se guarda hasta que se pide
}

} // namespace

std::string nombrePrograma() {
    return nombreDelEjecutable();
}

void avisa(const std::string &mensaje) {
    escribe("aviso: ", mensaje);
}

void falla(const std::string &mensaje, int estado) {
    std::fflush(stdout);
    escribe("", mensaje);
    std::exit(estado);
}

void compruebaSalida() {
    errno = 0; // si lo que se perdió fue antes, el motivo ya no se sabe
    if (std::fflush(stdout) == 0 && !std::ferror(stdout))
        return;
    escribe("", "no puedo escribir en la salida" + (errno ? ": " + motivo() : ""));
    std::_Exit(1);
}
