// La matriz que transforma las normales (§3.3) y lo que dibuja normales. Las escalas difíciles, los ejes aplastados y
// las reflexiones, una a una, están en dificil_transformaciones_test.cpp.
#include "azar.h"
#include "ch03_transformaciones/transformaciones.h"
#include "colores.h"
#include "guiones.h"
#include "panel.h"
#include "tabla.h"
#include <gtest/gtest.h>

namespace {

using glm::dmat3;
using glm::dvec3;

const double U = 0x1p-24; // el redondeo de float

/// Matriz afín cualquiera: componentes de −1 a 1 y cada columna por una potencia de 10 de −decadas a decadas.
glm::mat4 afin(Azar &azar, float decadas) {
    glm::mat4 M(1);
    for (int j = 0; j < 3; ++j)
        M[j] = glm::vec4(std::pow(10.0f, azar.entre(-decadas, decadas)) * azar.vector(1), 0);
    M[3] = glm::vec4(azar.vector(100), 1);
    return M;
}

/// La traspuesta de la adjunta, como la da el libro.
dmat3 adjunta(const dmat3 &m) {
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

} // namespace

// Los menores se calculan en doble con productos exactos (24 + 24 bits) y una sola resta, así que cada componente de N
// llega bien salvo el redondeo final a float: |δN| ≤ u·|N|. Una normal cualquiera es una combinación de las columnas:
// el redondeo de cada una cuenta entero, y al cancelarse deja |n·t| ≤ u·‖|N||n₀|‖/‖N·n₀‖ (más el de multiplicar, aquí
// en doble). Da igual lo mal condicionada que esté M.
//
// La adjunta del libro es det(M)·M⁻ᵀ: con det(M) < 0 mira hacia dentro. «Fuera» se decide sin normales: hacia donde va,
// transformado, un punto que estaba delante de la cara.
TEST(MatrizNormal, CualquierCaraPerpendicularYHaciaFuera) {
    Azar azar(2);
    int negativos = 0;
    for (const float decadas : {0.0f, 1.0f, 2.0f, 10.0f})
        for (int k = 0; k < 20000; ++k) {
            const glm::mat4 M = afin(azar, decadas);
            const dmat3 N(matrizNormal(M)), m(M);
            const dvec3 n0(azar.vector(1)), otro(azar.vector(1)),
                n = N * n0, fuera = m * n0, t = glm::normalize(m * glm::cross(n0, otro)),
                sinSigno = glm::abs(N[0] * n0.x) + glm::abs(N[1] * n0.y) + glm::abs(N[2] * n0.z);
            ASSERT_LE(std::fabs(glm::dot(n, t)), 1.001 * U * glm::length(sinSigno)) << decadas << ", " << k;
            const double det = glm::determinant(m),
                         relativo = det / (glm::length(m[0]) * glm::length(m[1]) * glm::length(m[2]));
            if (decadas > 2 || std::fabs(relativo) < 1e-6)
                continue; // casi plana: el volumen cambia de signo con el redondeo
            ASSERT_GT(glm::dot(n, fuera), 0) << decadas << ", " << k << ", det " << det;
            ASSERT_EQ(glm::dot(adjunta(m) * n0, fuera) > 0, det > 0) << decadas << ", " << k;
            negativos += det < 0;
        }
    EXPECT_GT(negativos, 27000);
}

// --- El programa -------------------------------------------------------------------------------------------

namespace {

using oraculo::Vec3;

const Vec3 COLOR{0.72, 0.82, 0.97};

/// El prisma transformado y sus normales sin ninguna matriz de normales: las de los lados salen del producto vectorial
/// de los lados ya transformados, puestas hacia fuera del centro. La adjunta del libro es ese producto vectorial tal
/// cual, y la roja, la normal del lado original con su x y su y escaladas.
struct Prisma {
    std::vector<oraculo::VerticeRef> vertices;
    std::vector<oraculo::Triangulos::Indices> indices;
    struct Flechas {
        Vec3 pie, conN, conM, adjunta;
    } lados[4];

    Prisma(double sx, double sy) {
        const double p[4][2] = {{0.25, -0.95}, {0.85, 0.15}, {-0.10, 0.90}, {-0.90, -0.20}}; // antihorario
        const Vec3 alFondo{0, 0, -0.9};
        Linea delante, detras;
        for (int i = 0; i < 4; ++i) {
            const auto &[ax, ay] = p[i];
            const auto &[bx, by] = p[(i + 1) % 4];
            const Vec3 a{sx * ax, sy * ay, 0.45}, b{sx * bx, sy * by, 0.45},
                medio = 0.5 * (a + b), adjunta = vectorial(b - a, {0, 0, 1});
            Vec3 n = unitario(escalar(adjunta, medio) < 0 ? -adjunta : adjunta);
            if (sy == 0)
                n = {0, bx < ax ? 1.0 : -1.0, 0};
            if (sy != 0 || n.y > 0) // de los aplastados se ven los de arriba
                cara({a, b, b + alFondo, a + alFondo}, n);
            delante.push_back(a);
            detras.push_back(a + alFondo);
            lados[i] = {medio + Vec3{0, 0, 0.018}, n, {sx * (by - ay), sy * (ax - bx), 0}, adjunta};
        }
        if (sy != 0) {
            cara(delante, {0, 0, 1});
            cara(detras, {0, 0, -1});
        }
    }
    void cara(const Linea &esquinas, const Vec3 &normal) {
        const std::size_t base = vertices.size();
        for (const Vec3 &q : esquinas)
            vertices.push_back({q, normal});
        for (std::size_t i = base + 1; i + 1 < vertices.size(); ++i)
            indices.push_back({base, i, i + 1});
    }
};

} // namespace

// El prisma en cada píxel, y en cada lado sus flechas, todas de largo 0.75: verde la de N, roja la de M y naranja la de
// la adjunta.
TEST(ProgramaNormales, CadaCasoContraElOraculo) {
    const struct {
        std::string guion;
        double sx, sy, azimut = 0.16, elevacion = 0.32;
    } casos[] = {{"", 1, 1},
                 {"tecla 2", 2, 1},
                 {"tecla 3; tamano 150 200", -2, 1},
                 {"tecla 4", 2, 0},
                 {"tecla 1; tecla 5; tamano 240 180; " + arrastra({0, 100}, {200, 100}), 1, 1, 0.16 - 2},
                 {"tecla 2; " + arrastra({100, 100}, {130, 120}), 2, 1, 0.16 - 2.3, 0.52}};
    paraCada("normales", casos, 240, 180, [](const auto &caso, const Vista &v) {
        const Panel panel(paralela(oraculo::orbita(caso.azimut, caso.elevacion, 8), 1.75, 1, 20), v.escena);
        const Prisma prisma(caso.sx, caso.sy);
        compruebaEscena(v, panel, {{oraculo::malla(oraculo::Mat4(), prisma.vertices, prisma.indices), COLOR}},
                        FONDO_CLARO);
        std::vector<Linea> deN, deM, deLaAdjunta;
        for (const auto &[pie, conN, conM, adjunta] : prisma.lados) {
            const auto flecha = [pie = pie](const Vec3 &n) { return Linea{pie, pie + 0.75 * unitario(n)}; };
            deN.push_back(flecha(conN));
            if (caso.sx != 1)
                deM.push_back(flecha(conM));
            if (caso.sx < 0)
                deLaAdjunta.push_back(flecha(adjunta));
        }
        compruebaTrazos(v.encima, panel, deN, VERDE);
        compruebaTrazos(v.encima, panel, deM, ROJO);
        compruebaTrazos(v.encima, panel, deLaAdjunta, NARANJA);
    });
}
