// Trozos de guion que piden muchas pruebas.
#pragma once
#include "prueba.h"

/// Varias veces la misma orden; ninguna, si son 0.
inline std::string veces(int n, const std::string &orden) {
    return n > 0 ? orden + " ×" + std::to_string(n) : "";
}

inline std::string enGuion(const glm::ivec2 &p) {
    return std::to_string(p.x) + " " + std::to_string(p.y);
}

/// Pulsar y soltar en un punto, en píxeles desde ARRIBA a la izquierda, como los da GLUT.
inline std::string clic(const glm::ivec2 &p, const std::string &boton = "IZQUIERDO") {
    return "boton " + boton + " abajo " + enGuion(p) + "; boton " + boton + " arriba " + enGuion(p);
}

/// Coger en un punto, llevar a otro y soltar.
inline std::string arrastra(const glm::ivec2 &desde, const glm::ivec2 &hasta,
                            const std::string &boton = "IZQUIERDO") {
    return "boton " + boton + " abajo " + enGuion(desde) + "; arrastra " + enGuion(hasta) + "; boton " +
           boton + " arriba " + enGuion(hasta);
}
