// Una tabla de casos, cada uno con su guion, que sigue al anterior, en una sola ejecución.
#pragma once
#include "ejecuta.h"
#include <gtest/gtest.h>

/// `comprueba(caso, vista)` con cada fila y lo que queda tras su guion.
template<class Casos, class Comprueba>
void paraCada(const std::string &programa, const Casos &casos, int ancho, int alto, Comprueba comprueba,
              const std::vector<std::string> &argumentos = {}) {
    std::vector<std::string> guiones;
    for (const auto &caso : casos)
        guiones.push_back(caso.guion);
    const std::vector<Vista> vistas = vistasDe(programa, guiones, ancho, alto, argumentos);
    for (std::size_t i = 0; i < vistas.size(); ++i) {
        SCOPED_TRACE(programa + " tras «" + guiones[i] + "»");
        comprueba(casos[i], vistas[i]);
    }
}
