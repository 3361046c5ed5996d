// Las primitivas de una orden, puestas en un buffer de índices de donde se puede dibujar una parte.
#pragma once
#include "primitivas.h"

namespace explica {

struct Punto {
    int x = 0, y = 0; // de un píxel, desde la esquina inferior izquierda
};

class Sueltas {
    GLuint bufer = 0;
    void recoge(int desde, int hasta, void *salen, GLsizeiptr bytes) const;

public:
    const Primitivas primitivas;

    explicit Sueltas(Primitivas p);
    ~Sueltas();
    Sueltas(const Sueltas &) = delete;
    Sueltas &operator=(const Sueltas &) = delete;

    /// Desde esa hasta la anterior a `hasta`, con el estado que haya.
    void dibuja(int desde, int hasta) const;
    /// Lo que da de cada vértice suyo el programa en uso (transform feedback), sin rasterizar.
    template<class DeCada>
    std::vector<DeCada> recoge(int desde, int hasta) const {
        std::vector<DeCada> salen(std::size_t((hasta - desde) * primitivas.vertices));
        recoge(desde, hasta, salen.data(), GLsizeiptr(salen.size() * sizeof(DeCada)));
        return salen;
    }
};

/// Lo que se dibuje no escribe nada, y de todo solo se rasteriza ese píxel, con las pruebas quitadas.
void soloPregunta(Punto pixel);

} // namespace explica
