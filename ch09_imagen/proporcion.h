// La proporción del rectángulo de §9.4. Sin OpenGL; la usa ampliacion y la comprueban las pruebas.
#pragma once
#include <glm/glm.hpp>

/// Por cuánto hay que multiplicar un cuadrado de −1 a 1 para que se vea con la forma de la imagen y quepa justo en el
/// área de dibujo. Los dos aspectos son ancho/alto.
inline glm::vec2 proporcion(float aspectoImagen, float aspectoArea) {
    return aspectoImagen > aspectoArea ? glm::vec2(1, aspectoArea / aspectoImagen)
                                       : glm::vec2(aspectoImagen / aspectoArea, 1);
}
