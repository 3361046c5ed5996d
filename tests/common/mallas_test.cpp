// Las mallas de common/: cerradas, orientadas hacia fuera, con normales unitarias y sobre la superficie que
// dicen ser.
#include "mallas.h"

namespace {

using glm::dvec3;

std::vector<std::array<Vertice, 3>> triangulos(const Malla &m) {
    std::vector<std::array<Vertice, 3>> lista;
    for (std::size_t i = 0; i < m.indices.size(); i += 3)
        lista.push_back(
            {m.vertices.at(m.indices[i]), m.vertices.at(m.indices[i + 1]), m.vertices.at(m.indices[i + 2])});
    return lista;
}

/// El vector perpendicular a un triángulo que mide lo que su área, hacia donde giran sus vértices.
dvec3 area(const std::array<Vertice, 3> &t) {
    const dvec3 a(t[0].posicion);
    return glm::cross(dvec3(t[1].posicion) - a, dvec3(t[2].posicion) - a) / 2.0;
}

const double PI = std::acos(-1.0);
const dvec3 Z(0, 0, 1);

dvec3 vuelta(double s) {
    return {std::cos(2 * PI * s), std::sin(2 * PI * s), 0};
}

/// Dónde está y qué normal tiene el punto (s, t) de una superficie. De una tapa o una cara se sabe por su normal, n.
struct Punto {
    dvec3 posicion, normal;
};
Punto enTapa(double s, double t, double z, const dvec3 &n) {
    return {{2 * s - 1, 2 * t - 1, z}, n};
}
Punto enEsfera(double s, double t, const dvec3 &) {
    const dvec3 p = std::sin(PI * t) * vuelta(s) - std::cos(PI * t) * Z;
    return {p, p};
}
Punto enCilindro(double s, double t, const dvec3 &n) {
    return std::fabs(n.z) == 1 ? enTapa(s, t, n.z / 2, n) : Punto{vuelta(s) + (t - 0.5) * Z, vuelta(s)};
}
Punto enCono(double s, double t, const dvec3 &n) {
    return n.z == -1 ? enTapa(s, t, 0, n)
                     : Punto{(1 - t) * vuelta(s) + t * Z, (vuelta(s) + Z) / std::sqrt(2.0)};
}
Punto enToro(double s, double t, const dvec3 &) {
    const dvec3 n = std::cos(2 * PI * t) * vuelta(s) + std::sin(2 * PI * t) * Z;
    return {2.0 * vuelta(s) + 0.5 * n, n};
}
Punto enPlano(double s, double t, const dvec3 &) {
    return {{s - 0.5, t - 0.5, 0}, Z};
}
Punto enCubo(double s, double t, const dvec3 &n) { // s va por u, y t por v
    const dvec3 u(n.z * n.z, n.x * n.x, n.y * n.y), v = glm::cross(n, u);
    return {0.5 * n + (s - 0.5) * u + (t - 0.5) * v, n};
}

} // namespace

// Cada vértice está donde dice su (s, t) y con la normal exacta de ahí. La malla está cerrada y mira hacia fuera, y su
// volumen se acerca por debajo al exacto cuando crece n (está inscrita); del plano, su área.
TEST(Mallas, SonLaSuperficieQueDicen) {
    const struct {
        const char *nombre;
        std::function<Malla(int)> malla;
        Punto (*superficie)(double s, double t, const dvec3 &n);
        double mide;
    } solidos[] = {{"cubo", [](int) { return cubo(); }, enCubo, 1},
                   {"esfera", esfera, enEsfera, 4 * PI / 3},
                   {"cilindro", cilindro, enCilindro, PI},
                   {"cono", cono, enCono, PI / 3},
                   {"toro", [](int n) { return toro(2, 0.5f, n, n); }, enToro, PI * PI},
                   {"plano", plano, enPlano, 1}};
    for (const auto &solido : solidos)
        for (const int n : {0, 3, 4, 7, 12, 33, 64, 256}) {
            SCOPED_TRACE(solido.nombre + std::string(" ") + std::to_string(n));
            const Malla m = solido.malla(n);
            for (const Vertice &v : m.vertices) {
                ASSERT_TRUE(glm::all(glm::equal(v.coordTextura, glm::clamp(v.coordTextura, 0.0f, 1.0f))));
                const Punto p = solido.superficie(v.coordTextura.s, v.coordTextura.t, v.normal);
                ASSERT_LT(glm::distance(p.posicion, dvec3(v.posicion)), 1e-6);
                ASSERT_LT(glm::distance(p.normal, dvec3(v.normal)), 1e-6);
            }
            const bool abierta = solido.superficie == enPlano;
            double mide = 0;
            for (const auto &t : triangulos(m)) {
                ASSERT_GT(glm::dot(area(t), dvec3(t[0].normal + t[1].normal + t[2].normal)), 0);
                mide += abierta ? area(t).z : glm::dot(dvec3(t[0].posicion), area(t)) / 3;
            }
            EXPECT_TRUE(abierta || n == 256 || aristasSueltas(m) == 0);
            EXPECT_LE(mide, solido.mide * (1 + 1e-6));
            EXPECT_GT(mide, n == 256 ? solido.mide * (1 - 2e-3) : 0);
        }
    EXPECT_EQ(plano(3).indices.size(), 3u * 18);
}

// La flecha del arco, calculada en long double, no pasa de la tolerancia; con un segmento menos sí.
TEST(SegmentosPara, LosJustos) {
    for (float r : {1.0f, 10.0f, 100.0f, 360.0f, 2000.0f})
        for (float tolerancia : {0.5f, 0.25f, 0.1f}) {
            const int n = segmentosPara(r, tolerancia);
            const auto flecha = [&](int k) { return r * (1 - std::cos(std::acos(-1.0L) / k)); };
            EXPECT_LE(flecha(n), tolerancia * (1 + 1e-6L)) << r << " " << tolerancia;
            EXPECT_TRUE(n == 3 || flecha(n - 1) > tolerancia * (1 - 1e-6L)) << r << " " << tolerancia;
        }
    EXPECT_EQ(segmentosPara(0.2f), 3);
    EXPECT_EQ(segmentosPara(0), 3);
    EXPECT_EQ(segmentosPara(1e9f), 1024);
    EXPECT_EQ(segmentosPara(std::nanf("")), 3);
}

// El punto más hundido de la malla, en el centro de una cara: menos de un cuarto de píxel, y no mucho menos.
TEST(SegmentosEsfera, LoQueSeHundeElCentroDeLasCaras) {
    for (const float r : {20.0f, 100.0f, 360.0f}) {
        float hundido = 0;
        for (const auto &t : triangulos(esfera(segmentosEsfera(r))))
            for (std::size_t k = 0; k < 3; ++k)
                hundido =
                    std::max(hundido, r * (1 - glm::length(t[k].posicion + t[(k + 1) % 3].posicion) / 2));
        EXPECT_LE(hundido, 0.25) << r;
        EXPECT_GT(hundido, 0.18) << r;
    }
}
