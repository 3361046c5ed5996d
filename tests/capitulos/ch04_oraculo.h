// Lo que comparten las pruebas del capítulo 4: la lista entera de lo que se pinta encima de un panel, las siluetas y la cámara de
// fotos que dibujan dos programas.
#pragma once
#include "colores.h"
#include "contra_oraculo.h"

/// Con la misma malla y la misma luz solo se pierde el redondeo a 8 bits. En los bordes, la GPU lleva cada vértice a la rejilla de
/// 1/256 de píxel, y un lado se mueve √2/256 como mucho por cada uno de los suyos: 0.011.
const Cotas EXACTA = {0.501, 500, 0.012};

/// Dónde se ve un punto del mundo en un panel, en píxeles de la ventana.
inline glm::dvec2 enPanel(const oraculo::Camara &camara, const Hueco &h, const oraculo::Vec3 &p) {
    return glm::dvec2(h.x, h.y) + enPixeles(camara, p, h.ancho, h.alto);
}

/// Un trazo con sus puntos en píxeles de la ventana; sin ninguno, si son otros quienes los miran.
struct Trazo {
    const char *tipo;
    glm::vec3 color;
    double grosor; // píxeles de 1080 líneas
    bool conProfundidad;
    std::vector<glm::dvec2> puntos;
};
struct Letrero {
    std::string texto;
    glm::dvec2 punto;
    glm::vec3 color;
    Lado lado;
};

/// De lo que cae fuera de la imagen no hay letrero.
inline std::vector<Letrero> losQueSeVen(std::vector<Letrero> letreros, int ancho, int alto) {
    const auto noSeVe = [=](const Letrero &l) {
        return l.punto.x < 0 || l.punto.y < 0 || l.punto.x > ancho || l.punto.y > alto;
    };
    letreros.erase(std::remove_if(letreros.begin(), letreros.end(), noSeVe), letreros.end());
    return letreros;
}

/// Comprueba que encima hay esos trazos, uno por uno y en el orden en que se pintan, esos letreros y nada más. `alto`: el útil de la
/// ventana. Los puntos pasan por la GPU en float: en ventanas de mil píxeles, 0.1 es mil veces su redondeo.
inline void compruebaEncima(const Encima &encima, int alto, const std::vector<Trazo> &trazos,
                            const std::vector<Letrero> &letreros) {
    EXPECT_EQ(encima.size(), trazos.size() + letreros.size());
    std::size_t n = 0;
    for (const Pintado &p : encima) {
        if (p.tipo == "rotulo")
            continue;
        SCOPED_TRACE("el trazo " + std::to_string(n) + ", " + p.tipo);
        ASSERT_LT(n, trazos.size());
        const Trazo &t = trazos[n++];
        EXPECT_EQ(p.tipo, t.tipo);
        EXPECT_TRUE(p.es(t.color));
        EXPECT_EQ(p.conProfundidad, t.conProfundidad);
        EXPECT_NEAR(p.talla, std::max(t.grosor * alto / 1080, 1.0), 1e-4);
        if (t.puntos.empty())
            continue;
        ASSERT_EQ(p.puntos.size(), t.puntos.size());
        for (std::size_t k = 0; k < t.puntos.size(); ++k)
            EXPECT_LE(glm::distance(p.punto(k), t.puntos[k]), 0.1)
                << "en (" << p.punto(k).x << ", " << p.punto(k).y << ") y no en (" << t.puntos[k].x << ", "
                << t.puntos[k].y << ")";
    }
    for (const Letrero &l : letreros)
        compruebaRotulo(encima, l.texto, l.punto, l.color, l.lado);
}

/// Los píxeles de la imagen que son de un objeto, según `esSuyo`, contra su silueta entera.
template<class EsSuyo>
oraculo::Comparacion comparaSilueta(Imagen imagen, EsSuyo esSuyo, const oraculo::Objeto &objeto,
                                    const oraculo::Camara &camara) {
    for (int i = 0; i < imagen.ancho * imagen.alto; ++i) {
        const bool suyo = esSuyo(pixel(imagen, i % imagen.ancho, i / imagen.ancho));
        std::fill_n(imagen.rgb.begin() + 3 * i, 3, suyo ? 255 : 0);
    }
    return oraculo::comparaSilueta(imagen, {}, {objeto}, camara);
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

/// La cámara de fotos, en los ejes que dé M. El cilindro, con las caras que tiene.
inline std::vector<Cuerpo> camaraDeFotos(const oraculo::Mat4 &M) {
    using namespace oraculo;
    return {{caja(M * traslada({0, 0, 0.5}) * escala({1, 0.65, 0.55})), exacto(GRIS)},
            {caja(M * traslada({0, 0.42, 0.5}) * escala({0.4, 0.22, 0.4})), exacto(OSCURO)},
            {caja(M * traslada({0.34, 0.36, 0.5}) * escala({0.18, 0.1, 0.18})), exacto(ROJO)},
            {enElMundo(M * traslada({0, 0, 0.1}) * escala({0.27, 0.27, 0.3}), cilindro(24)), exacto(OSCURO)}};
}
