// Una tabla de casos, cada uno con su guion, que sigue al anterior, en una sola ejecución: la ventana se abre con otro
// tamaño y, antes de nada, toma el que se pide.
#pragma once
#include "ejecuta.h"

/// `comprueba(caso, vista)` con cada fila y lo que queda tras su guion.
template<class Casos, class Comprueba>
void paraCada(const std::string &programa, const Casos &casos, int ancho, int alto, Comprueba comprueba,
              const std::vector<std::string> &argumentos = {}) {
    std::vector<std::string> guiones;
    const std::string tamano = "tamano " + std::to_string(ancho) + " " + std::to_string(alto) + "; ";
    for (const auto &caso : casos)
        guiones.push_back((guiones.empty() ? tamano : "") + caso.guion);
    const std::vector<Vista> vistas = vistasDe(programa, guiones, 100, 300, argumentos);
    for (std::size_t i = 0; i < vistas.size(); ++i) {
        SCOPED_TRACE(programa + " tras «" + guiones[i] + "»");
        comprueba(casos[i], vistas[i]);
    }
}
