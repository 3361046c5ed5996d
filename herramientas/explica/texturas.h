// Lo que lee un shader de una textura: de qué nivel y de qué texels sale, y cuánto pesa cada uno.
#pragma once
#include "json.h"
#include "opengl.h"

namespace explica {

/// Un texture(sampler, coordenadas) de un fragmento, con dFdx y dFdy de sus coordenadas y lo que ha dado.
struct Lectura {
    int linea;
    std::string sampler, escrito;
    std::vector<double> dx, dy, coordenadas,
        valor; // de las coordenadas, la última es lo que se suma al nivel
};

/// Sus `texels`, con lo que pesan, la `suma` y si `cuadra` con lo leído; si no, `motivo`. El programa, con sus texturas
/// como cuando dibuja. Hay que tener un Guardado.
Json deLectura(GLuint programa, const Lectura &lectura);

} // namespace explica
