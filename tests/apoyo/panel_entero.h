// Todo lo que hay en un panel: la escena trazada, o la silueta de un objeto, y la lista entera de lo que se pinta encima.
#pragma once
#include "panel.h"

/// Con la misma malla y la misma luz solo se pierde el redondeo a 8 bits. En los bordes, la GPU lleva cada vértice a la rejilla de
/// 1/256 de píxel, y un lado se mueve √2/256 como mucho por cada uno de los suyos: 0.011.
const Cotas EXACTA = {0.501, 500, 0.012};

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
              comparaConLuzFija(recorta(vista.escena, panel.hueco), cuerpos, panel.camara, exacto(fondo)),
              cotas);
}

/// Compara los píxeles de un panel que son de un objeto, según `esSuyo`, con su silueta entera.
template<class EsSuyo>
void compruebaSilueta(const Vista &vista, const Panel &panel, EsSuyo esSuyo, const oraculo::Objeto &objeto) {
    Imagen imagen = recorta(vista.escena, panel.hueco);
    for (int i = 0; i < imagen.ancho * imagen.alto; ++i) {
        const bool suyo = esSuyo(pixel(imagen, i % imagen.ancho, i / imagen.ancho));
        std::fill_n(imagen.rgb.begin() + 3 * i, 3, suyo ? 255 : 0);
    }
    comprueba("la silueta", oraculo::comparaSilueta(imagen, {}, {objeto}, panel.camara), EXACTA);
}

/// Un trazo con sus puntos en píxeles de la ventana; sin ninguno, si se miran aparte.
struct Trazo {
    const char *tipo;
    glm::vec3 color;
    double grosor; // píxeles de 1080 líneas
    bool conProfundidad;
    std::vector<glm::dvec2> puntos;
};

/// Comprueba que encima de ese panel hay esos trazos, uno por uno y en el orden en que se pintan, los letreros que nombran puntos que
/// caen en él y nada más. Los puntos pasan por float: en ventanas de mil píxeles, 0.1 es mil veces su redondeo.
inline void compruebaEncima(const Vista &vista, const Hueco &h, const std::vector<Trazo> &trazos,
                            std::vector<Letrero> letreros) {
    const auto fuera = [&](const Letrero &l) {
        const double x = l.punto.x - h.x, y = l.punto.y - h.y;
        return x < 0 || y < 0 || x > h.ancho || y > h.alto;
    };
    letreros.erase(std::remove_if(letreros.begin(), letreros.end(), fuera), letreros.end());
    const Encima encima = vista.encima.enPanel(h.x, h.y);
    compruebaRotulos(encima, letreros);
    ASSERT_EQ(encima.size(), trazos.size() + letreros.size());
    std::size_t n = 0;
    for (const Pintado &p : encima) {
        if (p.tipo == "rotulo")
            continue;
        SCOPED_TRACE("el trazo " + std::to_string(n) + ", " + p.tipo);
        const Trazo &t = trazos.at(n++);
        EXPECT_EQ(p.tipo, t.tipo);
        EXPECT_TRUE(p.es(t.color));
        EXPECT_EQ(p.conProfundidad, t.conProfundidad);
        const double alto = oraculo::altoUtil(vista.escena.ancho, vista.escena.alto);
        EXPECT_NEAR(p.talla, std::max(t.grosor * alto / 1080, 1.0), 1e-4);
        EXPECT_TRUE(t.puntos.empty() || p.puntos.size() == t.puntos.size());
        for (std::size_t k = 0; k < t.puntos.size(); ++k)
            EXPECT_LE(glm::distance(p.punto(k), t.puntos[k]), 0.1) << "el punto " << k;
    }
}
