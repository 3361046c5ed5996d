// La caja del ejercicio 2.1 vista como la ven malla_vf y tiras, en doble precisión.
#pragma once
#include "colores.h"
#include "panel.h"

const int ANCHO = 480, ALTO = 360; // de las imágenes que se comparan
const glm::vec3 CAJA[8] = {{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0},
                           {0, 1, 0}, {0, 1, 1}, {1, 1, 1}, {1, 1, 0}};
using T3 = std::array<unsigned, 3>; // vértices, desde el 1
// Las caras del enunciado y, con la 5 y la 6 al revés, a mano, las que concuerdan.
const std::vector<T3> CARAS = {{1, 3, 2}, {1, 4, 3}, {1, 2, 5}, {2, 6, 5}, {3, 2, 6},
                               {3, 6, 7}, {3, 4, 7}, {4, 8, 7}, {4, 1, 8}, {1, 5, 8}},
                      TRIANGULOS = {{1, 3, 2}, {1, 4, 3}, {1, 2, 5}, {2, 6, 5}, {3, 6, 2},
                                    {3, 7, 6}, {3, 4, 7}, {4, 8, 7}, {4, 1, 8}, {1, 5, 8}};

/// Un vértice llevado a la esfera de radio 1: la media diagonal de la caja mide √3/2.
inline oraculo::Vec3 verticeCaja(unsigned i) {
    return exacto((glm::dvec3(CAJA[i - 1]) - 0.5) / (std::sqrt(3.0) / 2));
}

/// La cámara de los dos programas: a la menor distancia desde la que caben a 4:3 los ocho vértices, aumentados un 22 %;
/// después la gira y la sube el ratón.
inline oraculo::Camara camaraCaja(double azimut, double elevacion, double gira = 0, double sube = 0) {
    const double t = std::tan(0.3);
    const oraculo::Camara lejana = oraculo::orbita(azimut, elevacion, 100);
    double distancia = 0;
    for (unsigned i = 1; i <= 8; ++i) {
        const oraculo::Vec3 p = oraculo::enCamara(lejana, verticeCaja(i));
        distancia =
            std::max(distancia, 1.22 * (p.z + 100 + std::max(std::fabs(p.y), std::fabs(p.x) * 0.75) / t));
    }
    return oraculo::perspectiva(oraculo::orbita(azimut + gira, elevacion + sube, distancia), 0.6, 0.1, 100);
}

/// La escena, contra unos triángulos de la caja, cada uno de un color, que puede depender de por dónde se vea.
template<class Color>
void compruebaCaja(const std::string &que, const Imagen &escena, const std::vector<T3> &triangulos,
                   const oraculo::Camara &camara, Color color) {
    std::vector<oraculo::VerticeRef> vertices;
    for (unsigned i = 1; i <= 8; ++i)
        vertices.push_back({verticeCaja(i), {0, 0, 1}});
    std::vector<oraculo::Triangulos::Indices> indices;
    for (const T3 &t : triangulos)
        indices.push_back({t[0] - 1, t[1] - 1, t[2] - 1});
    const oraculo::Escena caja = {oraculo::malla(oraculo::Mat4(), vertices, indices)};
    comprueba(que,
              oraculo::compara(escena, caja, camara,
                               [&](const oraculo::Impacto &i) {
                                   return i ? oraculo::Tono(color(i), i.corte.triangulo)
                                            : oraculo::Tono(exacto(FONDO_CLARO));
                               }),
              EXACTA);
}
