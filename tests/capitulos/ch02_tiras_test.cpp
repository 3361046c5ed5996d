// Comprobaciones independientes de tiras (ch02_modelado/tiras.h): las tiras expandidas con la regla de la
// especificación de OpenGL son los mismos triángulos.
#include "ch02_caja.h"
#include "ch02_modelado/tiras.h"
#include "guiones.h"
#include "tabla.h"

namespace {

// Los mismos triángulos orientados, empiecen por donde empiecen.
std::multiset<T3> canonicos(std::vector<T3> triangulos) {
    for (T3 &t : triangulos)
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return {triangulos.begin(), triangulos.end()};
}

// Especificación de OpenGL 3.1, §2.6.1: el triángulo i de una tira (desde 1) es i, i+1, i+2 si i es impar y i+1, i, i+2
// si es par. Los que repiten un vértice no tienen área.
std::vector<T3> expande(const std::vector<Tira> &tiras) {
    std::vector<T3> triangulos;
    for (const Tira &tira : tiras)
        for (std::size_t i = 1; i + 2 <= tira.size(); ++i) {
            const unsigned a = tira[i - 1], b = tira[i], c = tira[i + 1];
            if (a != b && b != c && c != a)
                triangulos.push_back(i % 2 == 1 ? T3{a, b, c} : T3{b, a, c});
        }
    return triangulos;
}

// Las de la caja, y la que dibuja la tecla u.
const std::vector<Tira> DOS = {{5, 2, 6, 3, 7, 4, 8, 1, 5, 2}, {2, 1, 3, 4}},
                        UNA = {{2, 1, 3, 4, 8, 1, 5, 2, 6, 3, 7, 8}},
                        REPETIDO = {{2, 1, 3, 4, 7, 4, 8, 1, 5, 2, 6, 3, 7}};
const glm::vec3 COLORES[] = {NARANJA, AZUL};

std::string separados(const Tira &tira) {
    std::string texto;
    for (const unsigned i : tira)
        texto += (texto.empty() ? "" : " ") + std::to_string(i);
    return texto;
}

} // namespace

TEST(Tiras, ElProgramaDaLosMismosTriangulosConSuOrientacion) {
    EXPECT_EQ(canonicos(expande(DOS)), canonicos(TRIANGULOS));
    EXPECT_EQ(canonicos(expande(REPETIDO)), canonicos(TRIANGULOS));
    std::string espera;
    for (const std::vector<Tira> &tiras : {DOS, UNA, REPETIDO, DOS}) {
        std::size_t indices = 0;
        for (std::size_t i = 0; i < tiras.size(); ++i) {
            espera += "Tira " + std::to_string(i + 1) + ": " + separados(tiras[i]) + "\n";
            indices += tiras[i].size();
        }
        espera += "Triángulos: 10\nTiras: " + std::to_string(tiras.size()) +
                  "\nÍndices con tiras: " + std::to_string(indices) +
                  "\nÍndices con triángulos sueltos: 30\n";
    }
    const Ejecucion e = ejecuta("tiras", "tecla 1; tecla u; tecla 1; tecla u; tecla u");
    EXPECT_EQ(e.estado, 0) << e.errores;
    EXPECT_EQ(e.salida, espera);
}

// Cada triángulo, del color de su tira: de claro a oscuro según su lugar, y el del medio tal cual.
TEST(Tiras, ColoresDeClaroAOscuroYResaltado) {
    const struct {
        std::string guion;
        std::vector<Tira> tiras;
        double gira, sube;
    } casos[] = {{"", DOS, 0, 0},
                 {"tecla 1", {DOS[0], {}}, 0, 0},
                 {"tecla 2", {{}, DOS[1]}, 0, 0},
                 {"tecla 3; tecla x", {{}, DOS[1]}, 0, 0}, // no hay tercera tira
                 {"tecla 0", DOS, 0, 0},
                 {"tecla 2; tecla u", UNA, 0, 0},
                 {"tecla u", REPETIDO, 0, 0},
                 {"tamano 120 200; tecla u", DOS, 0, 0},
                 {arrastra({20, 20}, {70, 10}), DOS, -1, -0.2}};
    paraCada("tiras", casos, ANCHO, ALTO, [](const auto &c, const Vista &vista) {
        std::vector<oraculo::Vec3> colores;
        for (std::size_t k = 0; k < c.tiras.size(); ++k) {
            const glm::dvec3 color = COLORES[k], clara = 0.75 * glm::dvec3(1) + 0.25 * color;
            for (std::size_t i = 2; i < c.tiras[k].size(); ++i) {
                if (c.tiras[k][i] == c.tiras[k][i - 1] || c.tiras[k][i] == c.tiras[k][i - 2])
                    continue; // sin área
                const double t = 2 * double(i - 2) / double(c.tiras[k].size() - 3) - 1;
                colores.push_back(exacto(t < 0 ? color + t * (color - clara) : color * (1 - 0.65 * t)));
            }
        }
        compruebaCaja(c.guion, vista.escena, expande(c.tiras), camaraCaja(0.66, 0.80, c.gira, c.sube),
                      [&](const oraculo::Impacto &i) { return colores[std::size_t(i.corte.triangulo)]; });
    });
}
