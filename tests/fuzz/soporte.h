// Para estrellar entradas contra un lector: lo que él cree leer de un fichero es la entrada, y `falla` lanza una
// excepción en vez de terminar. Cada <lector>.cpp define la función que llaman libFuzzer (fuzz.sh) o conductor.cpp.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *datos, std::size_t n);

/// Los ficheros que hay.
extern std::map<std::string, std::string> ficheros;

/// Llama al lector. Puede acabar bien o en falla, con un mensaje de una línea y estado 1 o 2.
void lee(const std::function<void()> &lector);

/// Aborta, para que la entrada se note, si algo que debe cumplirse no se cumple.
void exige(bool cierto);
