// El GLSL que un shader reescrito lleva delante: con qué apunta.
#pragma once
#include <set>
#include <string>
#include <utility>

namespace explica {

/// De qué sampler y con qué función se lee: «sampler2D», «textureLod3», con el número de argumentos.
using Leida = std::pair<std::string, std::string>;

/// Cuántas coordenadas tiene, de los que se siguen; de los demás, 0.
int ejesDe(const std::string &sampler);

/// Los uniforms, las salidas y las funciones de apuntar: explica_v(nota, valor), que devuelve el valor, de cada tipo de
/// `tipos`; explica_mas y explica_menos, que son v++ y v--, de los de `varian`; explica_n(nota), sin valor;
/// explica_descarta, desde la que ya no se apunta; explica_sigue, la condición de un bucle, que tras ella no deja dar
/// vueltas sin fin; explica_texture2, que es texture() con dos argumentos, y las demás de `lecturas`; y explica_acaba.
std::string preludio(int salidas, bool fragmento, const std::set<std::string> &tipos,
                     const std::set<std::string> &varian, const std::set<Leida> &lecturas = {});

} // namespace explica
