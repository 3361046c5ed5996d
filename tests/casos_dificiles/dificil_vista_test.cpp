// Casos difíciles del capítulo 4: la cámara, la proyección y la profundidad.
#include "caso.h"
#include "ch04_vista3d/profundidad.h"
#include "ch04_vista3d/vista.h"
#include "ejecuta.h"
#include <glm/gtc/matrix_transform.hpp>

namespace {

using Largo = long double;
using glm::dvec3;

/// Lo que le falta a la base de la cámara para ser unitaria, perpendicular y a derechas, y a p para ir al origen, en u.
double baseTorcida(const dvec3 &p, const dvec3 &i, const dvec3 &UP) {
    const auto [S, V, F] = baseCamara(p, i, UP);
    double peor = 0;
    for (const double falta : {glm::length(S) - 1, glm::length(V) - 1, glm::length(F) - 1, glm::dot(S, V),
                               glm::dot(S, F), glm::dot(V, F), glm::dot(glm::cross(S, V), -F) - 1})
        peor = mayor(std::fabs(falta) / U_DOBLE, peor);
    const glm::dvec4 origen = transformacionCamara(p, i, UP) * glm::dvec4(p, 1);
    for (int k = 0; k < 3; ++k)
        peor = mayor(std::fabs(origen[k]) / (U_DOBLE * std::max(1.0, glm::length(p))), peor);
    return peor;
}

/// UP apartado `desvio` radianes de F: lo que la base se aparta de la que pide, en u y por el seno.
double inclinacion(double desvio) {
    const dvec3 p(1, 2, 3), F = glm::normalize(dvec3(1, -2, 0.5)),
                            lado = glm::normalize(glm::cross(F, dvec3(0.3, 0.2, 1)));
    const dvec3 S = glm::cross(F, lado); // hacia donde debe quedar la derecha
    return glm::distance(baseCamara(p, p + F, std::cos(desvio) * F + std::sin(desvio) * lado).S, S) * desvio /
           U_DOBLE;
}

/// Un vértice a unas 5 unidades del ojo, que está a L del origen: su error en coordenadas de la cámara, restando en doble.
double ojoLejos(double L) {
    const dvec3 p(L, L + 1, L - 2), i = p + dvec3(3, -1, -4), modelo = i + dvec3(0.5, 0.25, -1);
    const glm::vec3 v(0.3f, -0.7f, 0.2f);
    const glm::mat4 MV(transformacionCamara(p, i, {0, 1, 0}) * glm::translate(glm::dmat4(1), modelo));
    const glm::vec4 q = MV * glm::vec4(v, 1);
    const auto [S, V, F] = baseCamara(p, i, {0, 1, 0});
    const dvec3 ejes[] = {S, V, -F},
                d = modelo - p; // exacta: L y p comparten exponente y los pasos son potencias de 2
    double peor = 0;
    for (int k = 0; k < 3; ++k) {
        Largo exacto = 0;
        for (int c = 0; c < 3; ++c)
            exacto += Largo(ejes[k][c]) * (Largo(d[c]) + Largo(v[c]));
        peor = mayor(std::fabs(static_cast<double>(Largo(q[k]) - exacto)), peor);
    }
    return peor;
}

/// Parte de los pares a 1e-5 que la profundidad en 24 bits deja iguales o invertidos.
template<class T>
double paresMal(double cerca) {
    const ParesMal p = cuentaPares<T>(cerca, 1000, 1e-5, 24);
    return p.iguales + p.invertidos;
}

/// Con la separación 1e-5, de los pares repartidos por igual en el logaritmo de la distancia, los que distan menos de `pasos` pasos de
/// 24 bits, contando 1 − s por cada uno a s veces esa distancia: la separación en pasos es K/d.
double partesIguales(double cerca, double pasos) {
    const double lejos = 1000, K = 16777215 * lejos * cerca / (lejos - cerca) * 1e-5 / (1 + 1e-5) / pasos,
                 desde = std::max(cerca, K);
    if (desde >= lejos)
        return 0;
    const double todos = std::log(lejos / desde),
                 s = pasos > 1 ? 0 : K * (1 / desde - 1 / lejos); // con margen, todos
    return (todos - s) / std::log(lejos / cerca);
}

/// Error relativo de la profundidad de la matriz de la ecuación 4.3, en doble, contra la fórmula en precisión extendida.
double profundidadDeLaMatriz(double cerca, double lejos) {
    double peor = 0;
    for (const double d : {cerca, 2 * cerca, std::sqrt(cerca * lejos), lejos}) {
        const glm::dvec4 q = proyeccionPerspectiva(1, 1, cerca, lejos) * glm::dvec4(0, 0, -d, 1);
        const Largo n = cerca, f = lejos, exacta = (f + n - 2 * f * n / d) / (f - n);
        peor = mayor(std::fabs(static_cast<double>(Largo(q.z) / Largo(q.w) - exacta)) / U_DOBLE, peor);
    }
    return peor;
}

/// 0 si el programa dibuja sin quejarse en una ventana de ese tamaño.
double dibujaEn(const std::string &programa, int ancho, int alto) {
    const Ejecucion e = ejecuta(programa, "", ancho, alto);
    EXPECT_EQ(e.errores, "");
    return e.estado + (e.imagen.ancho == ancho && e.imagen.alto == alto ? 0 : 1);
}

const Casos CAMARA([] {
    const dvec3 p(1, 2, 3), F(0.5, -1, 2);
    const std::pair<const char *, dvec3> paralelos[] = {
        {"up_paralelo", F},        {"up_opuesto", -F},      {"up_nulo", dvec3(0)},
        {"up_1em300", 1e-300 * F}, {"up_1e300", 1e300 * F}, {"up_subnormal", 1e-320 * F}};
    for (const auto &[nombre, UP] : paralelos)
        caso("Camara", nombre, 8, "u", [=, UP = UP] { return baseTorcida(p, p + F, UP); });
    caso("Camara", "mirando_hacia_arriba", 8, "u", [=] {
        return baseTorcida(p, p + dvec3(0, 1, 0), {0, 1, 0});
    });
    caso("Camara", "mirando_hacia_abajo", 8, "u", [=] {
        return baseTorcida(p, p - dvec3(0, 1, 0), {0, 1, 0});
    });
    for (const double desvio : {1e-3, 1e-5, 1e-7, 1e-9})
        caso("Camara", "up_a_" + enNombre(desvio) + "_rad", 30, "u / seno",
             [=] { return inclinacion(desvio); });
    for (const double lejos : {0.0, 1.0, 1e6})
        caso("Camara", "ojo_en_el_interes_a_" + enNombre(lejos), 8, "u", [=] {
            return baseTorcida(dvec3(lejos), dvec3(lejos), {0, 1, 0});
        });
    // unos 8 redondeos en float de números menores que 8, y en doble los de L
    for (const double L : {0.0, 1e3, 1e5, 1e6})
        caso("Camara", "ojo_a_" + enNombre(L), 8 * 8 * U_FLOAT + 100 * L * U_DOBLE, "unidades",
             [=] { return ojoLejos(L); });
});

const Casos PROYECCION([] {
    for (const double razon : {1e2, 1e4, 1e6})
        caso("Profundidad", "matriz_razon_" + enNombre(razon), 8, "u",
             [=] { return profundidadDeLaMatriz(1000 / razon, 1000); });
    for (const double cerca : {1e-3, 1e-6, 1e-30, 1e-300})
        caso("Profundidad", "matriz_cerca_" + enNombre(cerca), 8, "u",
             [=] { return profundidadDeLaMatriz(cerca, 1000); });
    // En doble quedan iguales los de la fórmula de partesIguales, con la fase al azar (5 desviaciones de 100 000); en float se añaden
    // nueve pasos de error por superficie (ch04_profundidad_test.cpp): solo puede fallar el par que dista menos de 19.
    for (const double razon : {1e2, 1e4, 1e6}) {
        caso("Profundidad", "pares_mal_en_doble_razon_" + enNombre(razon),
             partesIguales(1000 / razon, 1) + 0.008, "parte", [=] { return paresMal<double>(1000 / razon); });
        caso("Profundidad", "pares_mal_en_float_razon_" + enNombre(razon),
             partesIguales(1000 / razon, 19) + 0.008, "parte", [=] { return paresMal<float>(1000 / razon); });
    }
    caso("Profundidad", "cerca_casi_cero_en_float", 1, "parte", [] { return paresMal<float>(1e-30); });
    for (const auto &[ancho, alto] : {std::pair(1, 180), {1, 1}, {240, 1}, {3, 500}})
        for (const char *programa : {"ch04_vista3d/proyecciones", "ch04_vista3d/grua_proyeccion"})
            caso("Ventana",
                 std::string(programa + 13) + "_" + std::to_string(ancho) + "x" + std::to_string(alto), 0,
                 "estado", [=, ancho = ancho, alto = alto] { return dibujaEn(programa, ancho, alto); });
});

} // namespace

// Lo que no tiene proyección termina con un mensaje, no con un NaN.
TEST(ProyeccionImposibleDeathTest, CercaCero) {
    EXPECT_EXIT(proyeccionPerspectiva(1, 1, 0, 10), testing::ExitedWithCode(1), "0 < cerca < lejos");
}
TEST(ProyeccionImposibleDeathTest, CercaNegativa) {
    EXPECT_EXIT(proyeccionPerspectiva(1, 1, -1, 10), testing::ExitedWithCode(1), "0 < cerca < lejos");
}
TEST(ProyeccionImposibleDeathTest, CercaIgualALejos) {
    EXPECT_EXIT(proyeccionPerspectiva(1, 1, 5, 5), testing::ExitedWithCode(1), "0 < cerca < lejos");
}
TEST(ProyeccionImposibleDeathTest, AspectoCero) {
    EXPECT_EXIT(proyeccionPerspectiva(1, 0, 1, 10), testing::ExitedWithCode(1), "aspecto > 0");
}
TEST(ProyeccionImposibleDeathTest, AnguloDe180Grados) {
    EXPECT_EXIT(proyeccionPerspectiva(3.1415927, 1, 1, 10), testing::ExitedWithCode(1), "theta");
}
TEST(ProyeccionImposibleDeathTest, ParalelaSinAncho) {
    EXPECT_EXIT(proyeccionParalela(2, 2, -1, 1, 0, 10), testing::ExitedWithCode(1), "ancho, alto o fondo");
}
