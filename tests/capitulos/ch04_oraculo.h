// Lo que comparten las pruebas del capítulo 4: más precisión, la lista entera de lo que se pinta encima de un panel, siluetas y la
// cámara de fotos que dibujan dos programas.
#pragma once
#include "colores.h"
#include "contra_oraculo.h"

using Largo = long double; // con 11 bits más que double, sus redondeos no cuentan
using Vec3Largo = glm::vec<3, Largo>;
using Vec4Largo = glm::vec<4, Largo>;
using Mat4Largo = glm::mat<4, 4, Largo>;
const double U_DOBLE = 0x1p-53, U_FLOAT = 0x1p-24; // error de un redondeo

/// Con la misma malla y la misma luz solo se pierde el redondeo a 8 bits. En los bordes, la GPU lleva cada vértice a la rejilla de
/// 1/256 de píxel, y un lado se mueve √2/256 como mucho por cada uno de los suyos: 0.011.
const Cotas EXACTA = {0.501, 500, 0.012};

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

/// Las esquinas de lo que abarca una cámara a esas distancias a lo largo de la vista: las cuatro de cada una, desde abajo a la izquierda
/// y en sentido antihorario.
inline std::vector<oraculo::Vec3> esquinasA(const std::vector<double> &distancias,
                                            const oraculo::Camara &camara, const Hueco &h) {
    std::vector<oraculo::Vec3> esquinas;
    for (const double d : distancias)
        for (const auto &[x, y] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
            const oraculo::Rayo r = rayo(camara, h.ancho, h.alto, x * h.ancho, y * h.alto);
            esquinas.push_back(r.origen + d / -escalar(r.direccion, ejes(camara).z) * r.direccion);
        }
    return esquinas;
}
/// Si un punto está entre los cuatro lados de lo que abarca.
inline bool entreLosLados(const oraculo::Vec3 &p, const oraculo::Camara &camara, const Hueco &h) {
    const oraculo::Vec3 v = oraculo::proyecta(camara, h.ancho, h.alto, p);
    return v.x >= 0 && v.x <= h.ancho && v.y >= 0 && v.y <= h.alto;
}
/// Y si está además entre cerca y lejos.
inline bool dentroDelVolumen(const oraculo::Vec3 &p, const oraculo::Camara &camara, const Hueco &h) {
    const double d = -enCamara(camara, p).z;
    return d >= camara.cerca && d <= camara.lejos && entreLosLados(p, camara, h);
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

/// Cada triángulo con sus vértices: en el del cono la normal salta de una cara a otra, y así sus aristas son bordes.
inline Malla porCaras(const Malla &m) {
    Malla suelta;
    for (const unsigned i : m.indices) {
        suelta.indices.push_back(unsigned(suelta.vertices.size()));
        suelta.vertices.push_back(m.vertices[i]);
    }
    return suelta;
}

/// Esos cuerpos y la cámara de fotos, en los ejes que dé M. Su cilindro, con las caras que tiene.
inline std::vector<Cuerpo> conCamaraDeFotos(std::vector<Cuerpo> cuerpos, const oraculo::Mat4 &M) {
    using namespace oraculo;
    cuerpos.push_back({caja(M * traslada({0, 0, 0.5}) * escala({1, 0.65, 0.55})), exacto(GRIS)});
    cuerpos.push_back({caja(M * traslada({0, 0.42, 0.5}) * escala({0.4, 0.22, 0.4})), exacto(OSCURO)});
    cuerpos.push_back({caja(M * traslada({0.34, 0.36, 0.5}) * escala({0.18, 0.1, 0.18})), exacto(ROJO)});
    const Mat4 objetivo = M * traslada({0, 0, 0.1}) * escala({0.27, 0.27, 0.3});
    cuerpos.push_back({enElMundo(objetivo, cilindro(24)), exacto(OSCURO)});
    return cuerpos;
}
