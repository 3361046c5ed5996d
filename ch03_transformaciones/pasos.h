// Las transformaciones que piden los ejercicios 3.2, 3.3 y 3.4, paso a paso. Sin OpenGL: las dibujan
// tres_cubos, cono y elipsoide y las comprueban las pruebas. Faltan las figuras del libro a las que se
// refieren: dónde queda cada objeto, cuando el enunciado no lo dice, se ha elegido aquí.
#pragma once
#include "transformaciones.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>
#include <string>
#include <vector>

/// Una transformación y cómo se escribe: con sus números, y con una letra en un producto.
struct Paso {
    const char *nombre, *letra;
    glm::mat4 M;
};

/// Las `cuantos` primeras transformaciones en una sola matriz.
inline glm::mat4 concatena(const std::vector<Paso> &pasos, std::size_t cuantos) {
    glm::mat4 M(1);
    for (std::size_t i = 0; i < std::min(cuantos, pasos.size()); ++i) {
        // E3.3: añade a M la transformación siguiente, que se aplica después
        M = pasos[i].M * M; // la que se aplica después se escribe a la izquierda: con tres, M3·M2·M1 (§3.2)
        // de partida: M = pasos[i].M;
        // fin de E3.3
    }
    return M;
}

/// Ese producto, escrito: «M = Ry·S·T».
inline std::string producto(const std::vector<Paso> &pasos, std::size_t cuantos) {
    std::string factores;
    for (std::size_t i = 0; i < std::min(cuantos, pasos.size()); ++i)
        factores = pasos[i].letra + (i ? "·" + factores : "");
    return "M = " + (factores.empty() ? "I" : factores);
}

/// Ejercicio 3.2: tres cubos de lado 1, 1/2 y 1/4, cada uno centrado sobre la cara superior del anterior.
inline std::array<glm::mat4, 3> tresCubos() {
    // E3.2: la transformación de cada uno; A lleva el de lado uno al siguiente
    // En el sistema del cubo anterior, de lado 1, el nuevo siempre está en el mismo sitio: se reduce a la mitad
    // y sube medio lado del anterior más medio del nuevo. Por eso el tercero es A·A, que vale T(0, 9/8, 0)·S(1/4).
    const glm::mat4 A = traslacion({0, 0.75f, 0}) * escalado(0.5f);
    return {glm::mat4(1), A, A * A};
    // de partida: return {glm::mat4(1), glm::mat4(1), glm::mat4(1)};
    // fin de E3.2
}

/// Ejercicio 3.3: el cono de radio y altura 1 (base en z = 0, vértice en z = 1) acaba tumbado en el eje X,
/// con el vértice en el origen y la base, de radio 1, en x = 3.
inline std::vector<Paso> pasosCono() {
    // E3.3: una traslación, un escalado y un giro, en ese orden y con esos nombres, que es como se enseñan los pasos
    // Primero se lleva el vértice al origen, el único punto que ni el escalado ni el giro mueven: M = Ry·S·T.
    const glm::mat4 T = traslacion({0, 0, -1}), S = escalado({1, 1, 3}), Ry = giroY(-glm::half_pi<float>());
    // de partida: const glm::mat4 T(1), S(1), Ry(1);
    // fin de E3.3
    return {{"T(0, 0, −1)", "T", T}, {"S(1, 1, 3)", "S", S}, {"Ry(−π/2)", "Ry", Ry}};
}

/// Ejercicio 3.4: la esfera de radio 1 se escala, se traslada hasta apoyar un extremo en el origen y se
/// inclina en dos giros; el otro extremo acaba en 6/√3·(1, 1, 1).
inline std::vector<Paso> pasosElipsoide() {
    // E3.4: un escalado, una traslación y dos giros, en ese orden y con esos nombres, que es como se enseñan los pasos
    // Rx levanta el eje Z hasta que la Y de su vector unitario vale 1/√3, y Ry reparte lo que queda a partes
    // iguales entre X y Z: M = Ry·Rx·T·S.
    const float inclinacion = std::asin(1 / std::sqrt(3.0f));
    const glm::mat4 S = escalado({0.5f, 0.5f, 3}), T = traslacion({0, 0, 3}), Rx = giroX(-inclinacion),
                    Ry = giroY(glm::quarter_pi<float>());
    // de partida: const glm::mat4 S(1), T(1), Rx(1), Ry(1);
    // fin de E3.4
    return {{"S(0.5, 0.5, 3)", "S", S},
            {"T(0, 0, 3)", "T", T},
            {"Rx(−asen 1/√3)", "Rx", Rx},
            {"Ry(π/4)", "Ry", Ry}};
}
