// Partir la ventana en paneles, y de qué color se borran.
#pragma once
#include <glm/glm.hpp>
#include <vector>

/// Rectángulo de la ventana, en píxeles desde abajo a la izquierda, como los de glViewport.
struct Recuadro {
    int x, y, ancho, alto;
};

Recuadro ventanaEntera();

/// ancho/alto, nunca 0 ni infinito.
float aspecto(const Recuadro &r);

/// Columnas × filas paneles iguales, por filas desde arriba a la izquierda, con una raya entre ellos por la que se
/// ve lo que hubiera. En una ventana diminuta algunos pueden quedar vacíos (ancho o alto 0).
std::vector<Recuadro> rejilla(int columnas, int filas, const Recuadro &donde = ventanaEntera());

/// `n` paneles en la rejilla en que caben mayores las escenas de esa relación de aspecto: en una ventana ancha, uno
/// al lado de otro; en una alta, uno encima de otro.
std::vector<Recuadro> reparte(int n, float aspectoEscena = 1, const Recuadro &donde = ventanaEntera());

/// Dibujar y borrar desde ahora solo en ese panel, o en la ventana entera, hasta que se abra otro o acabe el cuadro.
void abreRecuadro(const Recuadro &r);

/// El color con que borra glClear desde ahora.
void ponFondo(const glm::vec3 &color);
