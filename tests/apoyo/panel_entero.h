// Un panel de la ventana, o toda ella: la escena trazada, la silueta de un objeto y la lista entera de lo que se pinta encima.
#pragma once
#include "contra_oraculo.h"
#include "encima.h"

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
inline oraculo::Comparacion compruebaEscena(const Vista &vista, const Hueco &h,
                                            const std::vector<Cuerpo> &cuerpos, const oraculo::Camara &camara,
                                            const glm::vec3 &fondo, const Cotas &cotas = EXACTA) {
    const oraculo::Comparacion c =
        comparaConLuzFija(recorta(vista.escena, h), cuerpos, camara, exacto(fondo));
    comprueba("el panel en " + std::to_string(h.x) + ", " + std::to_string(h.y), c, cotas);
    return c;
}

/// Compara los píxeles de un panel que son de un objeto, según `esSuyo`, con su silueta entera.
template<class EsSuyo>
void compruebaSilueta(const Vista &vista, const Hueco &h, EsSuyo esSuyo, const oraculo::Objeto &objeto,
                      const oraculo::Camara &camara) {
    Imagen imagen = recorta(vista.escena, h);
    for (int i = 0; i < h.ancho * h.alto; ++i) {
        const bool suyo = esSuyo(pixel(imagen, i % h.ancho, i / h.ancho));
        std::fill_n(imagen.rgb.begin() + 3 * i, 3, suyo ? 255 : 0);
    }
    comprueba("la silueta", oraculo::comparaSilueta(imagen, {}, {objeto}, camara), EXACTA);
}

/// Dónde se ve un punto del mundo en un panel, en píxeles de la ventana.
inline glm::dvec2 enPanel(const oraculo::Camara &camara, const Hueco &h, const oraculo::Vec3 &p) {
    return glm::dvec2(h.x, h.y) + enPixeles(camara, p, h.ancho, h.alto);
}
/// Un punto de un panel, de (0, 0) a (1, 1).
inline glm::dvec2 enPanel(const Hueco &h, double x, double y) {
    return {h.x + x * h.ancho, h.y + y * h.alto};
}

/// Un trazo con sus puntos en píxeles de la ventana; sin ninguno, si se miran aparte.
struct Trazo {
    const char *tipo;
    glm::vec3 color;
    double grosor; // píxeles de 1080 líneas
    bool conProfundidad;
    std::vector<glm::dvec2> puntos;
};
struct Letrero {
    std::string texto;
    glm::dvec2 punto; // si cae fuera del panel, no está
    glm::vec3 color;
    Lado lado;
};

/// Comprueba que encima de ese panel hay esos trazos, uno por uno y en el orden en que se pintan, esos letreros y nada más. Los puntos
/// pasan por float: en ventanas de mil píxeles, 0.1 es mil veces su redondeo.
inline void compruebaEncima(const Vista &vista, const Hueco &h, const std::vector<Trazo> &trazos,
                            const std::vector<Letrero> &letreros) {
    const Encima encima = vista.encima.enPanel(h.x, h.y);
    std::size_t pintados = 0;
    for (const Letrero &l : letreros) {
        const glm::dvec2 desde = l.punto - glm::dvec2(h.x, h.y), hasta = glm::dvec2(h.ancho, h.alto) - desde;
        if (std::min({desde.x, desde.y, hasta.x, hasta.y}) < 0)
            continue;
        compruebaRotulo(encima, l.texto, l.punto, l.color, l.lado);
        ++pintados;
    }
    ASSERT_EQ(encima.size(), trazos.size() + pintados);
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
