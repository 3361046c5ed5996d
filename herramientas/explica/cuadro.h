// Un cuadro explicado: se vuelve a dibujar unas veces, con algo delante de las funciones de OpenGL que escriben
// píxeles, y se cuenta en JSON lo que hace cada orden y, de los píxeles que se pidan, su historia y los shaders de
// quien los gana.
#pragma once
#include "ordenes.h"
#include "sueltas.h"

namespace explica {

struct Pedido {
    bool imagenes = false,
         sumas = false;              // lo que va quedando en cada framebuffer; y de lo que hay en cada array
    std::vector<Punto> pixeles = {}; // desde arriba a la izquierda
    std::pair<int, int> sombrea = {0, -1};   // otra primitiva, y no la de quien gana: su orden y su número
    std::pair<GLuint, int> textura = {0, 0}; // los píxeles, desde abajo, de esa, como la encuentra esa orden
};

std::string explica(void (*dibuja)(), int ancho, int alto, const Pedido &que);

/// En la página, antes: qué órdenes dibujan algo, que se sabe en otro turno del navegador (lee_web.cpp).
void pregunta(void (*dibuja)());

/// Mientras se explica, cada orden que llega se mira; si no, se hace.
bool seExplica();
void llega(const Orden &orden);
bool esNuestro(); // lo que se llama ahora lo llama quien explica, y no el programa

/// La función por la que se cambia esa, o nulo.
Direccion tapa(const std::string &nombre);

} // namespace explica
