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

/// UP apartado `desvio` radianes de F: lo que la base se aparta de la que pide, en u y por el seno.
double inclinacion(double desvio) {
    const dvec3 p(1, 2, 3), F = glm::normalize(dvec3(1, -2, 0.5)),
                            lado = glm::normalize(glm::cross(F, dvec3(0.3, 0.2, 1)));
    const dvec3 S = glm::cross(F, lado); // hacia donde debe quedar la derecha
    return glm::distance(baseCamara(p, p + F, std::cos(desvio) * F + std::sin(desvio) * lado).S, S) * desvio /
           U_DOBLE;
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

/// Parte de las parejas a 1e-5 que la profundidad en 24 bits deja iguales o invertidas.
template<class T>
double paresMal(double cerca) {
    const ParesMal p = cuentaPares<T>(cerca, 1000, 1e-5, 24);
    return p.iguales + p.invertidos;
}

/// La que debe ser, con 5 desviaciones de las 100 000. Una pareja a s pasos se queda igual con probabilidad 1 − s,
/// según dónde caiga. Si además el redondeo aparta una superficie de otra e pasos, de desviación `sigma`, se confunde
/// si s no llega a lo que le falta a la primera, de 0 a 1, más e: en media, sigma·(G((1 − s)/sigma) − G(−s/sigma)), con
/// G(x) = x·Φ(x) + φ(x). De las dos, la mayor.
double partesMal(double cerca, double sigma) {
    const double lejos = 1000, K = 16777215 * lejos * cerca / (lejos - cerca) * 1e-5 / (1 + 1e-5);
    const auto G = [](double x) {
        return x * std::erfc(-x / std::sqrt(2)) / 2 + std::exp(-x * x / 2) / std::sqrt(2 * glm::pi<double>());
    };
    const int n = 10000;
    double parte = 0;
    for (int i = 0; i < n; ++i) {
        const double s = K / (cerca * std::pow(lejos / cerca, (i + 0.5) / n));
        parte += std::max({0.0, 1 - s, sigma * (G((1 - s) / sigma) - G(-s / sigma))}) / n;
    }
    return parte + 5 * std::sqrt(parte * (1 - parte) / 100000);
}

/// Error relativo de la profundidad de la matriz de la ecuación 4.3, en doble, contra la fórmula en precisión
/// extendida.
double profundidadDeLaMatriz(double cerca, double lejos) {
    return peorDe({cerca, 2 * cerca, std::sqrt(cerca * lejos), lejos}, [=](double d) {
        const glm::dvec4 q = proyeccionPerspectiva(1, 1, cerca, lejos) * glm::dvec4(0, 0, -d, 1);
        const Largo n = cerca, f = lejos, exacta = (f + n - 2 * f * n / d) / (f - n);
        return std::fabs(Largo(q.z) / Largo(q.w) - exacta) / U_DOBLE;
    });
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
    acotaCada<double>("Camara", "up_a_*_rad", {1e-3, 1e-5, 1e-7, 1e-8, 1e-9}, 30, "u / seno", inclinacion);
    acotaCada<double>("Camara", "ojo_en_el_interes_a_*", {0, 1, 1e6, 1e15}, 8, "u",
                      [=](double lejos) { return baseTorcida(dvec3(lejos), dvec3(lejos), Y); });
    // unos 8 redondeos en float de números menores que 8, y en doble los de L
    acotaCada<double>(
        "Camara", "ojo_a_*", {0, 1e3, 1e5, 1e6, 1e9},
        [](double L) { return 8 * 8 * U_FLOAT + 100 * L * U_DOBLE; }, "unidades", ojoLejos);
});

const Cotas PROYECCION([] {
    acotaCada<double>("Profundidad", "matriz_razon_*", {1e2, 1e4, 1e6, 1e9, 1e15}, 8, "u",
                      [](double razon) { return profundidadDeLaMatriz(1000 / razon, 1000); });
    acotaCada<double>("Profundidad", "matriz_cerca_*", {1e-3, 1e-6, 1e-30, 1e-100, 1e-300}, 8, "u",
                      [](double cerca) { return profundidadDeLaMatriz(cerca, 1000); });
    // En doble el redondeo no aparta nada. En float, medio paso como mucho en el producto, la suma, el cociente y el
    // paso a [0, 1] de cada superficie: ocho veces, de varianza 1/12.
    const double EN_DOBLE = 1e-6, EN_FLOAT = std::sqrt(8.0 / 12);
    acotaCada<double>(
        "Profundidad", "pares_mal_en_doble_razon_*", {1e2, 1e3, 1e4, 1e6},
        [=](double razon) { return partesMal(1000 / razon, EN_DOBLE); }, "parte",
        [](double razon) { return paresMal<double>(1000 / razon); });
    acotaCada<double>(
        "Profundidad", "pares_mal_en_float_razon_*", {1e2, 1e4, 1e6},
        [=](double razon) { return partesMal(1000 / razon, EN_FLOAT); }, "parte",
        [](double razon) { return paresMal<float>(1000 / razon); });
    acota("Profundidad", "cerca_casi_cero_en_float", partesMal(1e-30, EN_FLOAT), "parte",
          [] { return paresMal<float>(1e-30); });
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
