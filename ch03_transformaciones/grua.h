// La grúa de obra del ejercicio 3.5, hecha solo de cubos de lado uno: qué cubos y con qué transformación.
// Sin OpenGL; la usan los programas grua* de los capítulos 3, 4 y 5.
#pragma once
#include "colores.h"
#include "transformaciones.h"
#include <algorithm>
#include <glm/glm.hpp>
#include <vector>

/// Medidas del enunciado: carga de lado 1, contrapeso de 1.4, pie y brazo de longitud 10.
const float LADO_CARGA = 1.0f, LADO_CONTRAPESO = 1.4f, LARGO_PIE = 10.0f, LARGO_BRAZO = 10.0f;
/// Las que el enunciado deja libres.
const float GRUESO = 0.8f, GRUESO_CABLE = 0.12f, VOLADIZO_ATRAS = 2.5f;

/// Postura: giro sobre el pie (radianes), distancia de la carga al pie y altura del centro de la carga.
struct PosturaGrua {
    float giro = 0, distancia = 5, altura = 4;
};

/// Recorrido de la carga: dentro del brazo y sin tocar el pie; sobre el suelo y bajo el brazo.
const float DISTANCIA_MINIMA = GRUESO / 2 + LADO_CARGA,
            DISTANCIA_MAXIMA = LARGO_BRAZO - VOLADIZO_ATRAS - LADO_CARGA / 2;
const float ALTURA_MINIMA = LADO_CARGA / 2, ALTURA_MAXIMA = LARGO_PIE - LADO_CARGA;

inline PosturaGrua limita(PosturaGrua p) {
    p.distancia = std::clamp(p.distancia, DISTANCIA_MINIMA, DISTANCIA_MAXIMA);
    p.altura = std::clamp(p.altura, ALTURA_MINIMA, ALTURA_MAXIMA);
    return p;
}

/// Teclas de la grúa, las mismas en todos los programas: a d giran, q e desplazan la carga, w s la suben y bajan.
/// Devuelve si la tecla era suya.
inline bool mueve(PosturaGrua &p, unsigned char tecla) {
    const float PASO_GIRO = 0.1f, PASO = 0.5f; // radianes, y unidades del mundo
    switch (tecla) {
    case 'a': p.giro += PASO_GIRO; break;
    case 'd': p.giro -= PASO_GIRO; break;
    case 'q': p.distancia -= PASO; break;
    case 'e': p.distancia += PASO; break;
    case 'w': p.altura += PASO; break;
    case 's': p.altura -= PASO; break;
    default: return false;
    }
    p = limita(p);
    return true;
}

/// Un cubo de lado uno centrado en el origen, llevado a su sitio por M.
struct Pieza {
    glm::mat4 M;
    glm::vec3 color;
};

/// Pie, brazo, contrapeso, cable y carga, en este orden. El pie se apoya en el origen; Y es la vertical y, sin giro, el
/// brazo, que se apoya en él y sobresale VOLADIZO_ATRAS por detrás, apunta a +X. El contrapeso cuelga de ese extremo,
/// al ras, y de la carga tira el cable, que va de la cara de abajo del brazo a la de arriba de ella. Pie y brazo son
/// del color AMARILLO, el contrapeso GRIS, el cable OSCURO y la carga ROJO.
inline std::vector<Pieza> piezasGrua(const PosturaGrua &postura) {
    // E3.5: los cinco cubos de lado uno, cada uno con su transformación y su color; el giro mueve todos menos el pie
    const PosturaGrua p = limita(postura);
    const float alturaBrazo = LARGO_PIE + GRUESO / 2;
    const float largoCable = LARGO_PIE - p.altura - LADO_CARGA / 2;

    const glm::mat4 giro = giroY(p.giro);
    const glm::mat4 carro = giro * traslacion({p.distancia, 0, 0});
    return {
        {traslacion({0, LARGO_PIE / 2, 0}) * escalado({GRUESO, LARGO_PIE, GRUESO}), AMARILLO},
        {giro * traslacion({LARGO_BRAZO / 2 - VOLADIZO_ATRAS, alturaBrazo, 0}) *
             escalado({LARGO_BRAZO, GRUESO, GRUESO}),
         AMARILLO},
        {giro * traslacion({LADO_CONTRAPESO / 2 - VOLADIZO_ATRAS, LARGO_PIE - LADO_CONTRAPESO / 2, 0}) *
             escalado(LADO_CONTRAPESO),
         GRIS},
        {carro * traslacion({0, LARGO_PIE - largoCable / 2, 0}) *
             escalado({GRUESO_CABLE, largoCable, GRUESO_CABLE}),
         OSCURO},
        {carro * traslacion({0, p.altura, 0}) * escalado(LADO_CARGA), ROJO},
    };
    // de partida: (void)postura; // de la que salen el giro, la distancia y la altura de la carga
    // de partida: return {{traslacion({0, LARGO_PIE / 2, 0}) * escalado({GRUESO, LARGO_PIE, GRUESO}), AMARILLO}};
    // fin de E3.5
}
