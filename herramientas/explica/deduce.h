// Lo que se deduce de dónde caen los vértices de una orden, de sus matrices y de cómo las usa el shader. Sin OpenGL.
#pragma once
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace explica {

using Puntos = std::vector<std::array<float, 4>>;  // como gl_Position
using Dicho = std::pair<std::string, std::string>; // lo que pasa y qué probar; vacío, nada

/// Por qué nada de eso cae en la ventana.
Dicho fueraDe(const Puntos &puntos);

/// Si los planos cerca o lejos quitan parte de lo que, si no, se vería.
Dicho corteDe(const Puntos &puntos);

/// Lo que son unos triángulos, de tres en tres índices.
struct Solido {
    bool cerrado = false;    // cada lado lo es de dos, uno a cada sentido
    bool rodea = false;      // si la cámara está dentro
    bool antihorario = true; // si sus caras de fuera giran así en la ventana; solo si está cerrado
};
Solido solidoDe(const Puntos &puntos, const std::vector<unsigned> &triangulos, bool alReves);

/// Los productos de un shader, cada uno con sus factores como están escritos.
using Productos = std::vector<std::vector<std::string>>;
Productos productosDe(const std::string &fuente);

struct Matriz {
    std::string nombre;
    std::vector<double> valor; // de 4×4, por columnas
};

/// Lo que está mal en una de las matrices de un shader. `alReves`: si lo lejano tiene menos profundidad.
Dicho deMatriz(const Matriz &matriz, const std::vector<Matriz> &todas, const Productos &productos,
               bool alReves);

/// Si multiplica la posición con w = 0.
Dicho conCero(const Productos &productos, const std::vector<Matriz> &matrices);

/// Si la posición con que se ilumina pasa por la cámara y la normal no. `matrices`: las de 4×4 y las de 3×3.
struct Iluminacion {
    std::string vert, frag, posicion, normal; // los dos shaders, y cómo se llaman esos atributos
};
Dicho deIluminacion(const Iluminacion &shaders, const Productos &productos,
                    const std::vector<Matriz> &matrices);

/// Una división de números enteros que vale 0, «1 / 2», en esa línea del shader: nadie la escribe a propósito.
struct Division {
    int linea;
    long long dividendo, divisor;
};
std::vector<Division> divisionesEnteras(const std::string &fuente);

} // namespace explica
