// Las mallas de common/: cerradas, orientadas hacia fuera, con normales unitarias y sobre la superficie que
// dicen ser.
#include "malla.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <map>
#include <utility>

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

/// Cada arista, vista por posición, la recorren dos triángulos en sentidos opuestos.
void esperaCerradaYOrientada(const Malla &m) {
    using Punto = std::array<float, 3>;
    const auto punto = [](const Vertice &v) { // −0 y 0 son el mismo punto
        return Punto{v.posicion.x + 0.0f, v.posicion.y + 0.0f, v.posicion.z + 0.0f};
    };
    std::map<std::pair<Punto, Punto>, int> aristas;
    for (const auto &t : triangulos(m))
        for (std::size_t k = 0; k < 3; ++k) {
            const Punto a = punto(t[k]), b = punto(t[(k + 1) % 3]);
            ASSERT_NE(a, b) << "triángulo sin área";
            ++aristas[{a, b}];
        }
    for (const auto &[arista, veces] : aristas) {
        ASSERT_EQ(veces, 1);
        ASSERT_EQ(aristas.count({arista.second, arista.first}), 1u) << "arista de borde";
    }
}

void esperaNormales(const Malla &m) {
    for (const Vertice &v : m.vertices) {
        ASSERT_NEAR(glm::length(v.normal), 1, 1e-6);
        ASSERT_GE(std::min(v.coordTextura.s, v.coordTextura.t), 0);
        ASSERT_LE(std::max(v.coordTextura.s, v.coordTextura.t), 1);
    }
    for (const auto &t : triangulos(m)) // la del triángulo mira como las de sus vértices
        ASSERT_GT(glm::dot(area(t), dvec3(t[0].normal + t[1].normal + t[2].normal)), 0);
}

double volumen(const Malla &m) {
    double v = 0;
    for (const auto &t : triangulos(m))
        v += glm::dot(dvec3(t[0].posicion), area(t)) / 3;
    return v;
}

const double PI = std::acos(-1.0);

} // namespace

// El volumen de cada sólido se acerca por debajo al exacto cuando crece n (inscrito), y nunca es negativo.
TEST(Mallas, CerradasOrientadasYConSuVolumen) {
    const struct {
        const char *nombre;
        std::function<Malla(int)> malla;
        double exacto;
    } solidos[] = {{"cubo", [](int) { return cubo(); }, 1},
                   {"esfera", esfera, 4 * PI / 3},
                   {"cilindro", cilindro, PI},
                   {"cono", cono, PI / 3},
                   {"toro", [](int n) { return toro(1, 0.3f, n, n); }, 2 * PI * PI * 0.09}};
    for (const auto &s : solidos) {
        SCOPED_TRACE(s.nombre);
        for (int n : {0, 3, 4, 7, 64}) {
            SCOPED_TRACE(n);
            const Malla m = s.malla(n);
            esperaCerradaYOrientada(m);
            esperaNormales(m);
            EXPECT_GT(volumen(m), 0);
            EXPECT_LE(volumen(m), s.exacto * (1 + 1e-6));
        }
        EXPECT_NEAR(volumen(s.malla(256)), s.exacto, 2e-3 * s.exacto);
    }
}

// Cada vértice está donde dice su (s,t) y con la normal exacta de ahí. Las superficies, en doble precisión y sin nada de
// malla.cpp; de una tapa o una cara se sabe por su normal.
TEST(Mallas, CadaVerticeConLaNormalYLasCoordenadasDeSuSuperficie) {
    struct Punto {
        dvec3 posicion, normal;
    };
    const auto vuelta = [](double s) { return dvec3(std::cos(2 * PI * s), std::sin(2 * PI * s), 0); };
    const dvec3 Z(0, 0, 1);
    const auto tapa = [](double s, double t, double z, const dvec3 &n) {
        return Punto{{2 * s - 1, 2 * t - 1, z}, n};
    };
    const auto enEsfera = [&](double s, double t, const dvec3 &) {
        const dvec3 p = std::sin(PI * t) * vuelta(s) - std::cos(PI * t) * Z;
        return Punto{p, p};
    };
    const auto enCilindro = [&](double s, double t, const dvec3 &n) {
        return std::fabs(n.z) == 1 ? tapa(s, t, n.z / 2, n) : Punto{vuelta(s) + (t - 0.5) * Z, vuelta(s)};
    };
    const auto enCono = [&](double s, double t, const dvec3 &n) {
        return n.z == -1 ? tapa(s, t, 0, n)
                         : Punto{(1 - t) * vuelta(s) + t * Z, (vuelta(s) + Z) / std::sqrt(2.0)};
    };
    const auto enToro = [&](double s, double t, const dvec3 &) {
        const dvec3 n = std::cos(2 * PI * t) * vuelta(s) + std::sin(2 * PI * t) * Z;
        return Punto{2.0 * vuelta(s) + 0.5 * n, n};
    };
    const auto enPlano = [&](double s, double t, const dvec3 &) { return Punto{{s - 0.5, t - 0.5, 0}, Z}; };
    const auto enCubo = [](double s, double t, const dvec3 &n) { // s va por u, y t por v
        const dvec3 u(n.z * n.z, n.x * n.x, n.y * n.y), v = glm::cross(n, u);
        return Punto{0.5 * n + (s - 0.5) * u + (t - 0.5) * v, n};
    };
    const struct {
        const char *nombre;
        Malla malla;
        std::function<Punto(double s, double t, const dvec3 &n)> superficie;
    } solidos[] = {{"esfera", esfera(12), enEsfera},
                   {"esfera de 33", esfera(33), enEsfera},
                   {"cilindro", cilindro(12), enCilindro},
                   {"cono", cono(20), enCono},
                   {"toro", toro(2, 0.5f, 12, 8), enToro},
                   {"plano", plano(5), enPlano},
                   {"cubo", cubo(), enCubo}};
    for (const auto &solido : solidos) {
        double desvio = 0;
        for (const Vertice &v : solido.malla.vertices) {
            const Punto p = solido.superficie(v.coordTextura.s, v.coordTextura.t, v.normal);
            desvio = std::max({desvio, glm::distance(p.posicion, dvec3(v.posicion)),
                               glm::distance(p.normal, dvec3(v.normal))});
        }
        EXPECT_LT(desvio, 1e-6) << solido.nombre;
    }
}

TEST(Mallas, Plano) {
    const Malla m = plano(3);
    EXPECT_EQ(m.indices.size(), 3u * 18);
    esperaNormales(m);
    double suma = 0;
    for (const auto &t : triangulos(m))
        suma += area(t).z;
    EXPECT_NEAR(suma, 1, 1e-6);
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
