// Los tipos de GLSL, los que hacen falta para saber qué se apunta.
#pragma once
#include <memory>
#include <string>
#include <vector>

namespace explica {

struct Campo;
using Estructura = std::vector<Campo>;

/// Sin base: no se sabe.
struct Tipo {
    std::string base; // «vec3», «Luz», «sampler2D»
    std::shared_ptr<const Estructura> estructura;
    int cuantos = 0; // los de un array; 0, no lo es; -1, no se sabe cuántos

    bool numerico() const; // un número, un vector o una matriz
    bool opaco() const;    // una textura
};

struct Campo {
    std::string nombre;
    Tipo tipo;
};

/// De qué está hecho un tipo numérico: «mat2x3» son 2 columnas de 3 float.
struct Forma {
    std::string escalar; // float, int, uint, bool; vacío si no es numérico
    int columnas = 1, filas = 1;
};
Forma forma(const std::string &base);

/// Cómo se llama ese: «vec2», «bool», «mat3» (y no mat3x3).
std::string nombreDe(const Forma &f);

bool esDeGlsl(const std::string &palabra); // un tipo del lenguaje, void y las texturas incluidos

/// El de `de.campo` y el de `de[i]`; sin base, si no lo tiene.
Tipo miembro(const Tipo &de, const std::string &campo);
Tipo elemento(const Tipo &de);

/// Los números de que está hecho lo que se llama `nombre`, cada uno con su nombre y su tipo, sin las texturas. Vacío si
/// no se sabe cuántos son o pasan de 40.
std::vector<Campo> hojas(const std::string &nombre, const Tipo &tipo);

} // namespace explica
