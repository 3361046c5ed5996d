// Lo que se ve del mundo por un panel de la ventana, y si los trazos que hay encima son los que deben y no hay más.
#pragma once
#include "contra_oraculo.h"

/// Para caras o mallas iguales que las del programa, que solo redondea a 8 bits y lleva los vértices a una rejilla de 1/256 de
/// píxel: la punta donde se cortan dos lados que forman un ángulo agudo se mueve unas cuantas veces más.
const Cotas LA_MISMA_MALLA = {0.501, 500, 1.0 / 32};

struct Panel {
    oraculo::Camara camara;
    Hueco hueco;

    Panel(const oraculo::Camara &laCamara, const Hueco &elHueco) : camara(laCamara), hueco(elHueco) {
    }
    /// El que es toda la ventana.
    Panel(const oraculo::Camara &laCamara, const Imagen &ventana)
        : Panel(laCamara, Hueco{0, 0, ventana.ancho, ventana.alto}) {
    }
    /// El k-ésimo de n, por filas desde arriba, de una rejilla de esas columnas que llena la ventana.
    Panel(const oraculo::Camara &laCamara, const Imagen &ventana, int k, int n, int columnas)
        : Panel(laCamara,
                ::hueco(k % columnas, columnas, k / columnas, n / columnas, ventana.ancho, ventana.alto)) {
    }
    /// Dónde se ve un punto, en píxeles de la ventana.
    glm::dvec2 operator()(const oraculo::Vec3 &p) const {
        return glm::dvec2(hueco.x, hueco.y) + enPixeles(camara, p, hueco.ancho, hueco.alto);
    }
    /// Y un lugar del panel: (0, 0) es su esquina de abajo a la izquierda y (1, 1) la contraria.
    glm::dvec2 lugar(double x, double y) const {
        return {hueco.x + x * hueco.ancho, hueco.y + y * hueco.alto};
    }
};

using Linea = std::vector<oraculo::Vec3>;

/// Comprueba que los trazos de ese color son esas líneas y nada más: están todas, y entre todas miden lo que ellos.
inline void compruebaTrazos(const Encima &encima, const Panel &panel, const std::vector<Linea> &lineas,
                            const glm::vec3 &color) {
    double largo = 0;
    for (const Linea &linea : lineas) {
        std::vector<glm::dvec2> enVentana;
        for (const oraculo::Vec3 &p : linea)
            enVentana.push_back(panel(p));
        compruebaTrazo(encima, enVentana, color);
        for (std::size_t i = 1; i < enVentana.size(); ++i)
            largo += glm::distance(enVentana[i - 1], enVentana[i]);
    }
    EXPECT_NEAR(encima.largo(color), largo, 0.1) << "de trazos de ese color";
}

/// Comprueba que hay una flecha de ese color, y una sola, de un punto a otro.
inline void compruebaFlecha(const Encima &encima, const Panel &panel, const oraculo::Vec3 &desde,
                            const oraculo::Vec3 &hasta, const glm::vec3 &color) {
    const glm::dvec2 a = panel(desde), b = panel(hasta);
    int cuantas = 0;
    for (const Pintado &p : encima.trazos(color, "flecha"))
        cuantas += glm::distance(p.punto(0), a) <= 0.1 && glm::distance(p.punto(1), b) <= 0.1;
    EXPECT_EQ(cuantas, 1) << "flechas de (" << a.x << ", " << a.y << ") a (" << b.x << ", " << b.y << ")";
}

/// Lo que debe verse por él, y lo que se ve.
template<class Sombrea>
oraculo::ImagenRef render(const oraculo::Escena &escena, const Panel &panel, Sombrea sombrea) {
    return oraculo::render(escena, panel.camara, panel.hueco.ancho, panel.hueco.alto, sombrea);
}
inline Imagen recorta(const Imagen &ventana, const Panel &panel) {
    return recorta(ventana, panel.hueco);
}
