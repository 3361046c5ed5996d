// Rótulos cortos, en DejaVu Sans Mono Bold: nítidos a cualquier tamaño, con un halo que los separa del fondo y siempre
// delante de todo. Los signos que hay están en letra.h; `\n` parte el rótulo en líneas. Quedan siempre a una letra del
// borde del panel, como poco: si no caben, se corren o encogen.
#pragma once
#include <glm/glm.hpp>
#include <string>

/// Alto de las mayúsculas, en partes del alto de la ventana (o de ¾ de su ancho, si es menor).
const float TALLA_ROTULO = 0.04f;

/// Lo que un rótulo pinta fuera de su rectángulo, que va de la línea base de la última línea a lo alto de las
/// mayúsculas de la primera: lo que bajan p, g, comas y paréntesis, y el halo, en altos de mayúscula; y lo que se
/// suaviza su borde, en píxeles.
const float BAJO_ROTULO = 0.3f, HALO_ROTULO = 0.07f, SUAVIZADO_ROTULO = 0.5f;

/// A qué lado de su punto va el rótulo. Si ahí no cabe, va a otro.
enum class Lado { CENTRO, ENCIMA, DEBAJO, IZQUIERDA, DERECHA };

/// Rótulo en un punto del panel en que se dibuja: (0, 0) es su esquina de abajo a la izquierda y (1, 1) la contraria.
void rotula(const std::string &texto, const glm::vec2 &lugar, const glm::vec3 &color,
            Lado lado = Lado::CENTRO, float talla = TALLA_ROTULO);

/// Rótulo junto a un punto, que no tapa. `transformacion` lo lleva a coordenadas de recortado; si el punto no está en
/// el volumen de la vista no hay rótulo.
void rotulaPunto(const std::string &texto, const glm::vec3 &punto, const glm::mat4 &transformacion,
                 const glm::vec3 &color, Lado lado = Lado::ENCIMA, float talla = TALLA_ROTULO);

/// Cuántas letras caben en una línea del panel en que se dibuja, dejando una a cada lado.
int letrasQueCaben(float talla);
