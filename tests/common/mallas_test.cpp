// Las mallas de common/: cerradas, orientadas hacia fuera y con normales unitarias.
#include "malla.h"
#include "prueba.h"

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

/// Cuántas aristas son de un solo triángulo, soldando los vértices que coinciden bit a bit. Las demás son de dos, que
/// las recorren en sentidos opuestos.
int aristasSueltas(const Malla &m) {
    using Bits = std::array<float, 3>;
    std::map<std::pair<Bits, Bits>, std::vector<bool>> usos; // y en qué sentido
    for (std::size_t t = 0; t < m.indices.size(); ++t) {
        const glm::vec3 p = m.vertices.at(m.indices[t]).posicion + 0.0f, // −0 y +0 son el mismo sitio
            q = m.vertices.at(m.indices[t % 3 == 2 ? t - 2 : t + 1]).posicion + 0.0f;
        const Bits a = {p.x, p.y, p.z}, b = {q.x, q.y, q.z};
        usos[std::minmax(a, b)].push_back(a < b);
    }
    int sueltas = 0;
    for (const auto &[arista, sentidos] : usos) {
        sueltas += sentidos.size() == 1;
        EXPECT_TRUE(sentidos.size() == 1 || (sentidos.size() == 2 && sentidos[0] != sentidos[1]));
    }
    return sueltas;
}

} // namespace

// Normales unitarias, hacia donde mira cada triángulo, y todos con área; cerrada, si no es el plano. Que es la que
// dice, en los programas: objetos, sombras, coordenadas.
TEST(Mallas, CerradasYHaciaFuera) {
    const std::function<Malla(int)> mallas[] = {
        [](int) { return cubo(); }, esfera, cilindro, cono, [](int n) { return toro(2, 0.5f, n, n); }, plano};
    for (const auto &malla : mallas)
        for (const int n : {0, 3, 4, 7, 12, 33, 64}) {
            SCOPED_TRACE(std::to_string(&malla - mallas) + " de " + std::to_string(n));
            const Malla m = malla(n);
            for (const Vertice &v : m.vertices)
                ASSERT_NEAR(glm::length(dvec3(v.normal)), 1, 1e-6);
            for (const auto &t : triangulos(m)) {
                ASSERT_GT(glm::dot(area(t), dvec3(t[0].normal + t[1].normal + t[2].normal)), 0);
                const glm::vec2 st = t[0].coordTextura;
                const float vista =
                    glm::determinant(glm::mat2(t[1].coordTextura - st, t[2].coordTextura - st));
                ASSERT_TRUE(vista > 0 ||
                            t[0].normal.z == -1); // una textura no se ve del revés: solo en la base
            }
            EXPECT_FALSE(m.indices.empty());
            EXPECT_EQ(aristasSueltas(m) == 0, &malla != std::end(mallas) - 1);
        }
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
    EXPECT_EQ(segmentosPara(0.2f), 3);
    EXPECT_EQ(segmentosPara(1e9f), 1024);
}
