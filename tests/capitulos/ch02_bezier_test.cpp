// Comprobaciones independientes de la tetera y de ch02_modelado/bezier.h: cada píxel y las grietas.
#include "ch02_modelado/bezier.h"
#include "ch11_referencia.h"
#include "colores.h"
#include "contra_oraculo.h"
#include "guiones.h"

namespace {

using namespace oraculo;

// La cámara del programa.
Camara camaraTetera(double gira = 0, double sube = 0, double distancia = 9.5) {
    return perspectiva(orbita(0.22 + gira, 0.38 + sube, distancia, {0.43, 1.42, 0}), 0.55, 0.5, 50);
}

// ---- El programa contra un oráculo que no comparte con él ni la evaluación ni la luz ----

// Una rejilla densa de cada parche, según su definición (ch11_referencia.h).
Objeto teteraDensa() {
    std::vector<VerticeRef> vertices;
    std::vector<Triangulos::Indices> indices;
    for (const Parche &q : leeParches("assets/tetera.txt")) {
        const auto G = redDe([&](std::size_t i, std::size_t j) { return q.p[i][j]; });
        const auto Q = [&](double u, double v, int du, int dv) { // u recorre una fila, y v va de una a otra
            const glm::dvec3 p = superficieRef(Base::BEZIER, G, v, u, dv, du);
            return glm::dvec3(p.x, p.z, -p.y); // en los datos la vertical es Z, y en la cámara Y
        };
        ponSuperficie(vertices, indices, Q, {96, 96});
    }
    return malla(Mat4(), vertices, indices);
}

// El esmalte que promete tetera.frag: difuso con la luz de la izquierda y el cielo de arriba, brillo de Blinn y reflejo
// en los bordes.
Vec3 esmalte(const Impacto &i, const Vec3 &color) {
    const Vec3 L{-0.62, 0.45, 0.643}, V = haciaOjo(i), N = escalar(i.normal, V) < 0 ? -i.normal : i.normal;
    const double NL = std::max(escalar(N, L), 0.0), NH = std::max(escalar(N, unitario(L + V)), 0.0);
    return (0.36 + 0.68 * NL + 0.26 * N.y) * color + 0.7 * std::pow(NH, 70) * Vec3{1, 1, 1} +
           0.35 * std::pow(1 - std::max(escalar(N, V), 0.0), 4) * Vec3{0.75, 0.86, 1};
}

// Todo el sombreado y la silueta, píxel a píxel, con la tetera más fina; de frente y desde donde la lleva el ratón.
TEST(Tetera, SombreadoYSilueta) {
    const Escena escena = {teteraDensa()};
    const struct {
        std::string guion;
        Camara camara;
        int ancho, alto;
    } casos[] = {{"tecla + ×4", camaraTetera(), 480, 360},
                 {"tecla + ×4; " + arrastra({50, 60}, {90, 100}) + "; rueda -1 50 50",
                  camaraTetera(-40 * 1.8 / 120, 40 * 1.8 / 120, 9.5 * 1.1), 160, 120}};
    for (const auto &c : casos) {
        const auto comparada =
            compara(vistaDe("tetera", c.guion, c.ancho, c.alto).escena, escena, c.camara,
                    [](const Impacto &i) { return i ? esmalte(i, exacto(AZUL)) : exacto(FONDO_CLARO); });
        // en el filo del borde el brillo cambia 200 niveles de un píxel al siguiente: la mitad con la tolerancia
        comprueba(c.guion, comparada, {4, 500, 0.7});
        EXPECT_LE(comparada.rmse, 0.35);
        EXPECT_GT(comparada.interior, c.ancho * c.alto * 8 / 10);
    }
}

// Con las líneas puestas no se afina más allá de medio píxel, tampoco si se ha afinado antes de ponerlas.
TEST(Tetera, AfinadaYConLineas) {
    const auto medio = vistaDe("tetera", "tecla m; tecla +", 160, 120).escena;
    for (const char *guion : {"tecla m; tecla + ×9", "tecla + ×9; tecla m"})
        EXPECT_EQ(vistaDe("tetera", guion, 160, 120).escena.rgb, medio.rgb) << guion;
}

} // namespace
