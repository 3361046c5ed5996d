// Casos difíciles del capítulo 3: giros alrededor de un eje y matriz normal, contra la doble precisión extendida.
#include "caso.h"
#include "ch03_transformaciones/transformaciones.h"
#include <glm/gtc/quaternion.hpp>

namespace {

using Largo = long double; // 64 bits de mantisa

/// El mayor error de los nueve componentes contra la fórmula de Rodrigues, con 1 − cos t = 2·sen²(t/2). El ángulo es exacto.
double contraRodrigues(const glm::mat3 &A, const glm::vec3 &eje, Largo t, bool sinDiagonal = false) {
    const Largo x = eje.x, y = eje.y, z = eje.z, largo = std::sqrt(x * x + y * y + z * z);
    const Largo d[3] = {x / largo, y / largo, z / largo}, s = std::sin(t),
                v = 2 * std::sin(t / 2) * std::sin(t / 2);
    const Largo cruz[3][3] = {{0, -d[2], d[1]}, {d[2], 0, -d[0]}, {-d[1], d[0], 0}};
    double peor = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (i != j || !sinDiagonal)
                peor = mayor(std::fabs(static_cast<double>((i == j ? 1 - v : 0) + v * d[i] * d[j] +
                                                           s * cruz[i][j] - Largo(A[j][i]))),
                             peor);
    return peor;
}

/// La de ch03_giro_test.cpp: 1 redondeo, y 38 por lo que se aparta de la identidad.
double cotaGiro(double t) {
    return 1 + 38 * 2 * std::fabs(std::sin(t / 2));
}

/// El peor error, en u y dividido por su cota, de varios ángulos.
double giroEnCotas(const glm::vec3 &eje) {
    double peor = 0;
    for (const float t : {1e-4f, 1.0f, 3.0f, -2.0f})
        peor = mayor(contraRodrigues(glm::mat3(giroEje(eje, t)), eje, Largo(t)) /
                         (U_FLOAT * cotaGiro(static_cast<double>(t))),
                     peor);
    return peor;
}

double faltaDeOrtonormalidad(const glm::mat3 &A) {
    const glm::dmat3 a(A), r = glm::transpose(a) * a - glm::dmat3(1);
    double peor = 0;
    for (int i = 0; i < 9; ++i)
        peor = mayor(std::fabs(r[i / 3][i % 3]), peor);
    return peor;
}

// Un millón de pasos de 0.001 rad alrededor de (1, 2, 3), de cinco maneras.
const int PASOS = 1000000;
const float PASO = 0.001f;
const glm::vec3 EJE(1, 2, 3);

template<class Giro, class Da>
Giro compuesto(Giro giro, Da da) {
    for (int i = 0; i < PASOS; ++i)
        giro = da(giro);
    return giro;
}
glm::mat3 matriz() {
    const glm::mat3 S(giroEje(EJE, PASO));
    return compuesto(glm::mat3(1), [&](const glm::mat3 &A) { return S * A; });
}
glm::mat3 reortonormalizada() {
    const glm::mat3 S(giroEje(EJE, PASO));
    return compuesto(glm::mat3(1), [&](const glm::mat3 &antes) {
        glm::mat3 A = S * antes;
        A[0] = glm::normalize(A[0]);
        A[1] = glm::normalize(A[1] - glm::dot(A[0], A[1]) * A[0]);
        A[2] = glm::cross(A[0], A[1]);
        return A;
    });
}
glm::mat3 cuaternion() {
    const glm::quat q = glm::angleAxis(PASO, unitario(EJE));
    return glm::mat3_cast(compuesto(glm::quat(1, 0, 0, 0), [&](const glm::quat &a) { return q * a; }));
}
glm::mat3 cuaternionUnitario() {
    const glm::quat q = glm::angleAxis(PASO, unitario(EJE));
    return glm::mat3_cast(
        compuesto(glm::quat(1, 0, 0, 0), [&](const glm::quat &a) { return glm::normalize(q * a); }));
}
const double ANGULO = static_cast<double>(PASO) * PASOS; // exacto: 24 bits por 20
glm::mat3 recalculada() {
    return glm::mat3(giroEje(EJE, static_cast<float>(std::remainder(ANGULO, 2 * 3.14159265358979323846))));
}
double deriva(const glm::mat3 &A) {
    return contraRodrigues(A, EJE, Largo(PASO) * PASOS);
}

const Casos GIROS([] {
    for (int i = 0; i < 3; ++i)
        for (const float e : {0.0f, 1e-30f, 1e-20f, 1e-10f}) {
            glm::vec3 eje(0);
            eje[i] = 1, eje[(i + 1) % 3] = e;
            caso("GiroEje", std::string("casi_") + "XYZ"[i] + "_" + enNombre(static_cast<double>(e)), 1,
                 "cotas", [=] { return giroEnCotas(eje); });
        }
    for (const float largo : {1e-38f, 1e-23f, 1e-20f, 1e20f, 1e38f})
        caso("GiroEje", "longitud_" + enNombre(static_cast<double>(largo)), 1, "cotas",
             [=] { return giroEnCotas(largo * glm::vec3(1, 2, -2)); });
    caso("GiroEje", "longitud_cero_no_gira", 0, "distancia a I", [] {
        return contraRodrigues(glm::mat3(giroEje(glm::vec3(0), 1)), {1, 0, 0}, 0);
    });
    // relativo al ángulo y fuera de la diagonal: 1 − cos t, en float, ya no tiene ninguna cifra
    for (const float t : {1e-3f, 1e-4f, 1e-6f, 1e-10f})
        caso("GiroEje", "angulo_" + enNombre(static_cast<double>(t)), 40, "u relativos", [=] {
            return contraRodrigues(glm::mat3(giroEje({1, 2, 3}, t)), {1, 2, 3}, Largo(t), true) /
                   (static_cast<double>(t) * U_FLOAT);
        });

    // La cota de lo que acumula: cada producto en float se aparta de un giro exacto en menos de β = ‖S̃ − S‖ + 9u < 3·1.08u + 9u < 13u
    // (la del giro por 3 pasa de la mayor componente a la norma; un producto de matrices ortonormales redondea 3u por componente, 9u
    // en norma), y tras k pasos, (1 + β)^k − 1 ≤ e^(kβ) − 1 = 1.2, que no garantiza nada. Lo que se aprende está en las medidas.
    const double cota = std::expm1(PASOS * 13 * U_FLOAT);
    caso("MillonDePasos", "deriva_matriz", cota, "componente", [] { return deriva(matriz()); });
    caso("MillonDePasos", "deriva_reortonormalizada", cota, "componente",
         [] { return deriva(reortonormalizada()); });
    caso("MillonDePasos", "deriva_cuaternion", cota, "componente", [] { return deriva(cuaternion()); });
    caso("MillonDePasos", "deriva_cuaternion_unitario", cota, "componente",
         [] { return deriva(cuaternionUnitario()); });
    caso("MillonDePasos", "deriva_recalculada", (cotaGiro(ANGULO) + 3.14159265358979323846) * U_FLOAT,
         "componente", [] { return deriva(recalculada()); });
    caso("MillonDePasos", "forma_reortonormalizada", 16 * U_FLOAT, "AᵀA − I",
         [] { return faltaDeOrtonormalidad(reortonormalizada()); });
    caso("MillonDePasos", "forma_cuaternion_unitario", 16 * U_FLOAT, "AᵀA − I",
         [] { return faltaDeOrtonormalidad(cuaternionUnitario()); });
    caso("MillonDePasos", "forma_recalculada", 2 * std::sqrt(3.0) * cotaGiro(ANGULO) * U_FLOAT, "AᵀA − I",
         [] { return faltaDeOrtonormalidad(recalculada()); });
    // la matriz sola se deforma al menos cien veces más que la que se reortonormaliza
    caso("MillonDePasos", "la_matriz_sola_se_deforma", 0.01, "razón",
         [] { return faltaDeOrtonormalidad(reortonormalizada()) / faltaDeOrtonormalidad(matriz()); });
});

// --- matriz normal ---

/// |n·t|/(|n||t|) en u de las tres caras de un cubo con sus dos tangentes; infinito si una normal que existe mira hacia dentro.
double torcida(const glm::mat4 &M) {
    const glm::dmat3 N(matrizNormal(M)), m(M);
    double peor = 0;
    for (int k = 0; k < 3; ++k) {
        if (!(glm::dot(N[k], m[k]) > 0)) // fuera: hacia donde va el punto que estaba delante de la cara
            return HUGE_VAL;
        for (int j = 1; j <= 2; ++j)
            peor = mayor(std::fabs(glm::dot(glm::normalize(N[k]), glm::normalize(m[(k + j) % 3]))) / U_FLOAT,
                         peor);
    }
    return peor;
}
const glm::mat4 INCLINADA = giroX(0.7f) * giroY(-1.1f);

const Casos NORMALES([] {
    for (const int k : {-38, -20, -10, -5, 0, 5, 10, 20, 38})
        for (const float signo : {1.0f, -1.0f}) {
            const float s = signo * static_cast<float>(std::pow(10.0, k));
            caso("MatrizNormal", "uniforme_" + enNombre(static_cast<double>(s)), 1.001, "u",
                 [=] { return torcida(escalado(s) * INCLINADA); });
        }
    for (int eje = 0; eje < 3; ++eje) {
        const std::string letra(1, "XYZ"[eje]);
        glm::vec3 plana(2, 3, 0.5f), espejo(2, 3, 0.5f), fina(1);
        plana[eje] = 0, espejo[eje] *= -1, fina[eje] = 1e-30f;
        // la normal del plano en que queda todo, y ninguna otra
        caso("MatrizNormal", "aplastada_" + letra, 2, "u", [=] {
            const glm::mat4 M = INCLINADA * escalado(plana);
            const glm::mat3 N = matrizNormal(M);
            const glm::dvec3 n =
                glm::normalize(glm::cross(glm::dvec3(M[(eje + 1) % 3]), glm::dvec3(M[(eje + 2) % 3])));
            const bool sobra = N[(eje + 1) % 3] != glm::vec3(0) || N[(eje + 2) % 3] != glm::vec3(0);
            return sobra ? HUGE_VAL : glm::distance(glm::normalize(glm::dvec3(N[eje])), n) / U_FLOAT;
        });
        caso("MatrizNormal", "reflejada_" + letra, 1.001, "u",
             [=] { return torcida(INCLINADA * escalado(espejo)); });
        caso("MatrizNormal", "casi_aplastada_" + letra, 1.001, "u",
             [=] { return torcida(INCLINADA * escalado(fina)); });
    }
    for (const glm::vec3 &s : {glm::vec3(1, 0, 0), glm::vec3(0)})
        caso("MatrizNormal", s.x > 0 ? "aplastada_en_una_recta" : "aplastada_en_un_punto", 0,
             "mayor componente", [=] {
                 const glm::mat3 N = matrizNormal(INCLINADA * escalado(s));
                 double peor = 0;
                 for (int i = 0; i < 9; ++i)
                     peor = mayor(std::fabs(static_cast<double>(N[i / 3][i % 3])), peor);
                 return peor;
             });
    // se escala por la mayor componente: la columna menor de N queda en 1e-36, que aún es un float normal
    caso("MatrizNormal", "columnas_de_1e18_a_1em18", 1.001, "u", [] {
        return torcida(INCLINADA * escalado({1e18f, 1, 1e-18f}));
    });
});

} // namespace
