// Lo que se ve del mundo por un panel de la ventana: la escena trazada y la lista de lo que se pinta encima.
#pragma once
#include "contra_oraculo.h"

/// Con la misma malla y la misma luz solo se pierde el redondeo a 8 bits. En los bordes, la GPU lleva cada vértice a la
/// rejilla de 1/256 de píxel, y un lado se mueve √2/256 como mucho por cada uno de los suyos: 0.011.
const Cotas EXACTA = {0.501, 500, 0.012};
/// Y, si el color sale de más cuentas, una centésima de nivel de hacerlas en float.
const Cotas MISMA_MALLA = {0.51, 500, 0.012};

const oraculo::Vec3 X{1, 0, 0}, Y{0, 1, 0}, Z{0, 0, 1}, UNO{1, 1, 1};
/// De Z, que es el eje de las formas de common/, a Y.
const oraculo::Mat4 DE_PIE = oraculo::gira(X, -oraculo::PI / 2);

inline oraculo::Vec3 mezcla(const oraculo::Vec3 &a, const oraculo::Vec3 &b, double t) {
    return (1 - t) * a + t * b;
}

using Linea = std::vector<oraculo::Vec3>;

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
        const oraculo::Vec3 v = oraculo::proyecta(camara, hueco.ancho, hueco.alto, p);
        return {hueco.x + v.x, hueco.y + v.y};
    }
    std::vector<glm::dvec2> puntos(const Linea &linea) const {
        std::vector<glm::dvec2> enVentana;
        for (const oraculo::Vec3 &p : linea)
            enVentana.push_back((*this)(p));
        return enVentana;
    }
};

/// Lo que debe verse por él, y lo que se ve.
template<class Sombrea>
oraculo::ImagenRef render(const oraculo::Escena &escena, const Panel &panel, Sombrea sombrea) {
    return oraculo::render(escena, panel.camara, panel.hueco.ancho, panel.hueco.alto, sombrea);
}
inline Imagen recorta(const Imagen &ventana, const Panel &panel) {
    return recorta(ventana, panel.hueco);
}

/// Cada triángulo con sus vértices: en el del cono la normal salta de una cara a otra, y así sus aristas son bordes.
inline Malla porCaras(const Malla &m) {
    Malla suelta;
    for (const unsigned i : m.indices) {
        suelta.indices.push_back(unsigned(suelta.vertices.size()));
        suelta.vertices.push_back(m.vertices[i]);
    }
    return suelta;
}

/// Compara un panel con la escena trazada con la luz fija.
inline void compruebaEscena(const Vista &vista, const Panel &panel, const std::vector<Cuerpo> &cuerpos,
                            const glm::vec3 &fondo, const Cotas &cotas = EXACTA) {
    comprueba("el panel en " + std::to_string(panel.hueco.x) + ", " + std::to_string(panel.hueco.y),
              comparaConLuzFija(recorta(vista.escena, panel), cuerpos, panel.camara, exacto(fondo)), cotas);
}

/// Compara los píxeles de un panel que son de un objeto, según `esSuyo`, con su silueta entera.
template<class EsSuyo>
void compruebaSilueta(const Vista &vista, const Panel &panel, EsSuyo esSuyo, const oraculo::Objeto &objeto) {
    Imagen imagen = recorta(vista.escena, panel);
    for (int i = 0; i < imagen.ancho * imagen.alto; ++i) {
        const bool suyo = esSuyo(pixel(imagen, i % imagen.ancho, i / imagen.ancho));
        std::fill_n(imagen.rgb.begin() + 3 * i, 3, suyo ? 255 : 0);
    }
    comprueba("la silueta", oraculo::comparaSilueta(imagen, {}, {objeto}, panel.camara), EXACTA);
}

/// Comprueba que los trazos de ese color son esas líneas, en cualquier orden, y nada más.
inline void compruebaTrazos(const Encima &encima, const Panel &panel, const std::vector<Linea> &lineas,
                            const glm::vec3 &color) {
    double largo = 0;
    for (const Linea &linea : lineas) {
        const std::vector<glm::dvec2> enVentana = panel.puntos(linea);
        compruebaTrazo(encima, enVentana, color);
        for (std::size_t i = 1; i < enVentana.size(); ++i)
            largo += glm::distance(enVentana[i - 1], enVentana[i]);
    }
    EXPECT_NEAR(encima.largo(color), largo, 0.1) << "de trazos de ese color";
}
