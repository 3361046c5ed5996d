// Las primitivas de una orden, puestas en un buffer de índices de donde se puede dibujar una parte.
#pragma once
#include "primitivas.h"

namespace explica {

struct Punto {
    int x = 0, y = 0; // de un píxel, desde la esquina inferior izquierda
};

class Sueltas {
    GLuint bufer = 0;

public:
    const Primitivas primitivas;

    explicit Sueltas(Primitivas p);
    ~Sueltas();
    Sueltas(const Sueltas &) = delete;
    Sueltas &operator=(const Sueltas &) = delete;

    /// Desde esa hasta la anterior a `hasta`, con el estado que haya.
    void dibuja(int desde, int hasta) const;
    /// Sus vértices, como puntos y sin índices, que con transform feedback WebGL no dibuja con ellos.
    void dibujaVertices(int desde, int hasta) const;
};

/// Lo que se dibuje no escribe nada, y de todo solo se rasteriza ese píxel, con las pruebas quitadas.
void soloPregunta(Punto pixel);

} // namespace explica
