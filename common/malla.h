// Mallas de triángulos: los sólidos elementales y un lector v/f (listado 2.1). Sin OpenGL: a la GPU las lleva
// buferes.h.
#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

struct Vertice {
    glm::vec3 posicion, normal;
    glm::vec2 coordTextura;
};

/// Triángulos de vértices compartidos; vistos desde fuera giran en sentido antihorario y las normales
/// son unitarias y apuntan hacia fuera. Los vértices se repiten donde cambia la normal o (s,t).
struct Malla {
    std::vector<Vertice> vertices;
    std::vector<unsigned> indices; // tres por triángulo
};

/// Sólidos centrados en el origen. `n`: segmentos de una vuelta, al menos 3. s da la vuelta al eje Z desde +X y t sube
/// (en el toro, da la vuelta al tubo desde fuera); en una tapa o una cara, (s,t) es la posición, de 0 a 1.
Malla cubo();          // lado 1
Malla esfera(int n);   // radio 1; polos en ±Z
Malla cilindro(int n); // radio 1, altura 1 (z de −0.5 a 0.5), con tapas
Malla cono(int n);     // radio 1, base en z = 0 y vértice en z = 1, con tapa
Malla toro(float radio, float radioTubo, int n, int m); // en el plano XY; n segmentos de anillo y m de tubo
Malla plano(int n);                                     // lado 1 en el plano XY, normal +Z, n×n cuadrados

/// Cómo se queja quien lee un fichero de texto: termina diciendo fichero, línea y qué se esperaba.
struct Queja {
    std::string donde, linea;
    [[noreturn]] void operator()(const std::string &seEsperaba) const;
};

/// Llama a `linea` con cada una que no sea solo comentario (desde #): su primera palabra y las que siguen. `nombre`: el
/// del fichero en las quejas.
void leeLineas(
    const std::string &fichero, const std::string &nombre,
    const std::function<void(const std::string &tipo, std::istream &palabras, const Queja &mal)> &linea);

/// Las tres coordenadas que son todo lo que queda de la línea; nada si no son tres números que quepan en un float.
std::optional<glm::dvec3> leePunto(std::istream &linea);

/// Descripción v/f: líneas «v x y z» y «f i j k …» (caras convexas, índices desde 1, `#` comenta). Es parte de lo que
/// hay en un OBJ: lo demás (normales, texturas, materiales) se salta. Cada cara guarda sus índices desde 0.
/// Un error termina diciendo fichero, línea y qué se esperaba.
struct MallaVf {
    std::vector<glm::vec3> vertices;
    std::vector<std::vector<unsigned>> caras;
};
MallaVf leeVf(const std::string &fichero);

/// Segmentos con que una circunferencia de `radioPx` píxeles se separa de la exacta menos de `tolerPx`:
/// la flecha de un arco de 2π/n es r·(1 − cos(π/n)). Entre 3 y 1024.
int segmentosPara(float radioPx, float tolerPx = 0.5f);

/// Segmentos con que `esfera` se separa menos de un cuarto de píxel de la exacta: en el centro de sus caras se hunde el
/// doble que en sus arcos. Pares, porque de polo a polo van la mitad.
int segmentosEsfera(float radioPx);
