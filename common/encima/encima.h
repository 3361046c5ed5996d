// Lo que explica una imagen se pinta encima de ella en un solo sitio: ahí acaban los rótulos (rotulo.h) y los trazos
// (trazo.h), con un solo programa de shaders. Deja OpenGL como estaba, salvo que en la unidad de textura 15 queda el
// atlas.
//
// Con LAB_ENCIMA=FICHERO en el entorno, lo que se pinta se escribe además en el fichero, para quien quiera comprobarlo;
// con LAB_SIN_ENCIMA=1 no se pinta, y queda la escena sola; con un tipo, no se pinta lo que es de ese tipo. Por cada
// imagen guardada, una línea «imagen FICHERO ANCHO ALTO» y las de lo que llevaba, en orden. Con tabuladores entre los
// campos y blancos dentro de ellos:
//   tipo        rotulo, segmentos, polilinea, puntos, flecha o poligono, o velo, que es todo el panel y no tiene puntos
//   color       r g b, de 0 a 1
//   panel       x y ancho alto, en píxeles desde abajo a la izquierda
//   talla       alto de las mayúsculas, grosor o diámetro, en píxeles
//   profundidad 1 si obedece al test de profundidad
//   puntos      x y z de cada uno: píxeles de la ventana y profundidad normalizada. De un rótulo, sus dos
//               esquinas y su punto
//   texto       el del rótulo; el fin de línea es un \n
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

/// Una pincelada, como se apunta.
struct Pincelada {
    const char *tipo;
    glm::vec3 color;
    float talla;
    std::vector<glm::vec3> puntos; // en píxeles del panel, desde su centro
    std::string texto;
};

/// Un vértice de los triángulos que la pintan: en coordenadas normalizadas del panel y en texels del atlas de letras.
struct VerticePintado {
    glm::vec3 posicion;
    glm::vec2 enAtlas;
};

/// Los triángulos se pintan del color de la pincelada donde el atlas pasa de `borde`, que crece `nitidez` por píxel. Lo
/// que es todo tinta no mira el atlas: es lo que valen si no se dan.
struct Tinta {
    glm::vec3 color;
    float borde = -1, nitidez = 1;
};

/// Pinta los triángulos una vez con cada tinta, y apunta la pincelada.
void pintaEncima(const Pincelada &pincelada, const std::vector<VerticePintado> &triangulos,
                 const std::vector<Tinta> &tintas, bool conProfundidad);

/// Lo apuntado en el cuadro anterior se olvida. Lo llama glut_sin_ventana antes de dibujar.
void empiezaCuadroEncima();

/// Escribe lo apuntado en este cuadro, que está en esa imagen. Lo llama glut_sin_ventana al guardarla.
void guardaEncima(const std::string &imagen, int ancho, int alto);
