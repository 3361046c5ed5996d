// Casos difíciles del capítulo 4: la cámara, la proyección y la profundidad.
#include "ch04_vista3d/profundidad.h"
#include "ch04_vista3d/vista.h"
#include "cota.h"

namespace {

using glm::dvec3;
using testing::ExitedWithCode;

/// Lo que le falta a la base de la cámara para ser unitaria, perpendicular y a derechas, y a p para ir al origen, en u.
double baseTorcida(const dvec3 &p, const dvec3 &i, const dvec3 &UP) {
    const auto [S, V, F] = baseCamara(p, i, UP);
    const double base = peorDe({glm::length(S) - 1, glm::length(V) - 1, glm::length(F) - 1, glm::dot(S, V),
                                glm::dot(S, F), glm::dot(V, F), glm::dot(glm::cross(S, V), -F) - 1},
                               [](double falta) { return std::fabs(falta); });
    const dvec3 origen(transformacionCamara(p, i, UP) * glm::dvec4(p, 1));
    return mayor(base, mayorComponente(origen) / std::max(1.0, glm::length(p))) / U_DOBLE;
}

/// Un vértice a unas 5 unidades del ojo, que está a L del origen: su error en coordenadas de la cámara, restando en
/// doble.
double ojoLejos(double L) {
    const dvec3 p(L, L + 1, L - 2), i = p + dvec3(3, -1, -4), modelo = i + dvec3(0.5, 0.25, -1);
    const glm::vec3 v(0.3f, -0.7f, 0.2f);
    const glm::mat4 MV(transformacionCamara(p, i, {0, 1, 0}) * glm::translate(glm::dmat4(1), modelo));
    const auto [S, V, F] = baseCamara(p, i, {0, 1, 0});
    // modelo − p es exacta: L y p comparten exponente y los pasos son potencias de 2
    const glm::vec<3, Largo> d = glm::vec<3, Largo>(modelo - p) + glm::vec<3, Largo>(v);
    const glm::mat<3, 3, Largo> ejes(S, V, -F);
    return mayorComponente(glm::vec<3, Largo>(MV * glm::vec4(v, 1)) - d * ejes);
}

/// La parte de las 100 000 parejas a 1e-5 que la profundidad en 24 bits debe dejar iguales, con 5 desviaciones: una a s
/// pasos, con probabilidad 1 − s, según dónde caiga.
double partesMal(double cerca, double lejos) {
    const double K = 16777215 * lejos * cerca / (lejos - cerca) * 1e-5 / (1 + 1e-5);
    const int n = 10000;
    double parte = 0;
    for (int i = 0; i < n; ++i)
        parte += std::max(0.0, 1 - K / (cerca * std::pow(lejos / cerca, (i + 0.5) / n))) / n;
    return parte + 5 * std::sqrt(parte * (1 - parte) / 100000);
}

const Cotas CAMARA([] {
    const dvec3 F(0.5, -1, 2), Y(0, 1, 0);
    struct Mirada {
        dvec3 F, UP;
    };
    acotaCada<Mirada>("Camara", "*",
                      {{"up_paralelo", {F, F}},
                       {"up_opuesto", {F, -F}},
                       {"up_nulo", {F, dvec3(0)}},
                       {"up_1em300", {F, 1e-300 * F}},
                       {"up_1e300", {F, 1e300 * F}},
                       {"up_subnormal", {F, 1e-320 * F}},
                       {"up_a_1em11_de_la_vista", {F, F + 1e-11 * Y}},
                       {"up_a_1em15_de_la_vista", {F, F + 1e-15 * Y}},
                       {"up_a_1em11_de_la_contraria", {F, 1e-11 * Y - F}},
                       {"mirando_hacia_arriba", {Y, Y}},
                       {"mirando_hacia_abajo", {-Y, Y}}},
                      8, "u",
                      [p = dvec3(1, 2, 3)](const Mirada &m) { return baseTorcida(p, p + m.F, m.UP); });
    acotaCada<double>("Camara", "ojo_en_el_interes_a_*", {0, 1, 1e6, 1e15}, 8, "u",
                      [=](double lejos) { return baseTorcida(dvec3(lejos), dvec3(lejos), Y); });
    // unos 8 redondeos en float de números menores que 8, y en doble los de L
    acotaCada<double>(
        "Camara", "ojo_a_*", {0, 1e3, 1e5, 1e6, 1e9},
        [](double L) { return 8 * 8 * U_FLOAT + 100 * L * U_DOBLE; }, "unidades", ojoLejos);
});

const Cotas PROYECCION([] {
    acotaCada<double>(
        "Profundidad", "pares_mal_en_doble_razon_*", {1e2, 1e3, 1e4, 1e6},
        [](double razon) { return partesMal(1000 / razon, 1000); }, "parte",
        [](double razon) {
            const ParesMal p = cuentaPares<double>(1000 / razon, 1000, 1e-5, 24);
            return p.iguales + p.invertidos;
        });
});

} // namespace

// Lo que no tiene proyección termina con un mensaje, no con un NaN.
TEST(ProyeccionImposibleDeathTest, UnMensaje) {
    const double PI = glm::pi<double>();
    const struct {
        double theta, aspecto, cerca, lejos;
        const char *mensaje;
    } imposibles[] = {{1, 1, 0, 10, "0 < cerca < lejos"},     {1, 1, -1, 10, "0 < cerca < lejos"},
                      {1, 1, 5, 5, "0 < cerca < lejos"},      {1, 0, 1, 10, "aspecto > 0"},
                      {PI + 1e-7, 1, 1, 10, "0 < theta < π"}, {NAN, 1, 1, 2, "0 < theta < π"}};
    for (const auto &[theta, aspecto, cerca, lejos, mensaje] : imposibles)
        EXPECT_EXIT(proyeccionPerspectiva(theta, aspecto, cerca, lejos), ExitedWithCode(1), mensaje);
    EXPECT_EXIT(proyeccionParalela(2, 2, -1, 1, 0, 10), ExitedWithCode(1), "ancho, alto o fondo");
    EXPECT_EXIT(proyeccionParalela(0, 1, 0, NAN, 0, 1), ExitedWithCode(1), "el volumen");
}
