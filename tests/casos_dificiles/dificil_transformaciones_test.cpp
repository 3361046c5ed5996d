// Casos difíciles del capítulo 3: giros alrededor de un eje y matriz normal, contra la doble precisión extendida.
#include "azar.h"
#include "ch03_transformaciones/transformaciones.h"
#include "cota.h"
#include <glm/gtc/quaternion.hpp>

namespace {

using Mat3 = glm::mat<3, 3, Largo>;

/// La fórmula de Rodrigues, con 1 − cos t = 2·sen²(t/2). El ángulo es exacto.
Mat3 rodrigues(const glm::vec3 &eje, Largo t) {
    const glm::vec<3, Largo> d = glm::normalize(glm::vec<3, Largo>(eje));
    const Mat3 cruz({0, d.z, -d.y}, {-d.z, 0, d.x}, {d.y, -d.x, 0});
    return Mat3(1) + std::sin(t) * cruz + 2 * std::sin(t / 2) * std::sin(t / 2) * cruz * cruz;
}
double contraRodrigues(const glm::mat4 &A, const glm::vec3 &eje, Largo t) {
    return mayorComponente(Mat3(A) - rodrigues(eje, t));
}

/// Cota de giroEje, componente a componente. Con D = Rx(t) − I, de norma 2·|sen(t/2)|, el error de I + RᵀDR es el
/// redondeo de la suma (u, porque el resultado no pasa de 1) más 2·‖δR‖·‖D‖ más el de los dos productos de matrices y
/// del seno. d y e llegan con 4u (una división y una normalización) y f = d × e con 10u: ‖δR‖ ≤ √(4² + 4² + 10²)·u <
/// 12u. Cada producto de tres términos añade 3u·‖|R||D|‖ ≤ 6u·‖D‖ y el seno 2u: 24 + 12 + 2.
double cotaGiro(double t) {
    return (1 + 38 * 2 * std::fabs(std::sin(t / 2))) * U_FLOAT;
}

/// El peor error de varios ángulos, dividido por su cota.
double giroEnCotas(const glm::vec3 &eje) {
    return peorDe({0.0f, 1e-6f, 1e-4f, 0.1f, 1.0f, 3.0f, -2.0f, 3.1415927f, 6.2831853f, 100.0f},
                  [&](float t) { return contraRodrigues(giroEje(eje, t), eje, t) / cotaGiro(t); });
}

/// El mayor error relativo de los componentes de fuera de la diagonal, en u. Con el eje (1, 1, 0), dos son (1 − cos
/// t)/2.
double errorRelativo(const glm::mat3 &giro, const glm::vec3 &eje, float t) {
    const Mat3 R = rodrigues(eje, t), A(giro);
    return peorHasta(6, [&](int k) {
        const int i = k / 2, j = (i + 1 + k % 2) % 3;
        return std::fabs(A[i][j] / R[i][j] - 1) / U_FLOAT;
    });
}
double giroPequeno(float t) {
    return peorDe({glm::vec3(1, 2, 3), {1, 1, 0}},
                  [&](const glm::vec3 &eje) { return errorRelativo(glm::mat3(giroEje(eje, t)), eje, t); });
}

double faltaDeOrtonormalidad(const glm::mat3 &A) {
    const glm::dmat3 a(A);
    return mayorComponente(glm::transpose(a) * a - glm::dmat3(1));
}

// Un millón de pasos de 0.001 rad alrededor de (1, 2, 3), de cinco maneras.
const int PASOS = 1000000;
const float PASO = 0.001f;
const glm::vec3 EJE(1, 2, 3);
const double ANGULO = double(PASO) * PASOS; // exacto: 24 bits por 20

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
const glm::quat UNO(1, 0, 0, 0), Q = glm::angleAxis(PASO, unitario(EJE));
glm::mat3 cuaternion() {
    return glm::mat3_cast(compuesto(UNO, [](const glm::quat &a) { return Q * a; }));
}
glm::mat3 cuaternionUnitario() {
    return glm::mat3_cast(compuesto(UNO, [](const glm::quat &a) { return glm::normalize(Q * a); }));
}
glm::mat3 recalculada() {
    return glm::mat3(giroEje(EJE, float(std::remainder(ANGULO, 2 * glm::pi<double>()))));
}
double deriva(const glm::mat3 &A) {
    return contraRodrigues(glm::mat4(A), EJE, ANGULO);
}

const Cotas GIROS([] {
    for (int i = 0; i < 3; ++i)
        acotaCada<float>("GiroEje", std::string("casi_") + "XYZ"[i] + "_*",
                         {0, 1e-38f, 1e-30f, 1e-20f, 1e-10f, 1e-5f}, 1, "cotas", [i](float e) {
                             glm::vec3 eje(0);
                             eje[i] = 1;
                             eje[(i + 1) % 3] = e;
                             return giroEnCotas(eje);
                         });
    acotaCada<float>("GiroEje", "longitud_*", {1e-38f, 1e-30f, 1e-23f, 1e-20f, 1e20f, 1e30f, 1e38f}, 1,
                     "cotas", [](float largo) { return giroEnCotas(largo * glm::vec3(1, 2, -2)); });
    acota("GiroEje", "longitud_cero_no_gira", 0, "distancia a I", [] {
        return contraRodrigues(giroEje(glm::vec3(0), 1), {1, 0, 0}, 0);
    });
    acota("GiroEje", "al_azar", 1, "cotas", [] {
        Azar azar(1);
        return peorHasta(300, [&](int) { return giroEnCotas(azar.entre(0.1f, 3.0f) * azar.direccion()); });
    });
    // Relativo: quien calcule 1 − cos t restando se queda sin cifras en 1e-3 y con 0 en 1e-4. Unos 13 redondeos: el
    // seno de la mitad, su cuadrado y dos componentes del eje, que ya trae tres en cada uno.
    acotaCada<float>("GiroEje", "angulo_*", {1e-3f, 1e-4f, 1e-5f, 1e-6f, 1e-10f, 1e-15f}, 13, "u relativos",
                     giroPequeno);
    // en RᵀRxR, la ecuación 3.10 al pie de la letra, lo que gira se suma a un RᵀR que solo es casi I: se equivoca cien
    // veces más
    acotaCada<float>("GiroEje", "la_ecuacion_310_con_angulo_*", {1e-4f, 1e-6f}, 1,
                     "cien veces la cota / su error", [](float t) {
                         const glm::mat3 R = cambioDeBase(unitario(EJE));
                         return 100 * 13 / errorRelativo(glm::transpose(R) * glm::mat3(giroX(t)) * R, EJE, t);
                     });

    // Cada paso redondea dos cosas siempre hacia el mismo lado: el propio giro (u/2, en su diagonal, que es casi 1) y
    // su producto por lo que ya hay (u/2 en cada componente de una columna unitaria). Los demás redondeos van al azar,
    // y suman mil veces menos. En un cuaternión, que tiene cuatro componentes, lo mismo, y en su matriz el doble.
    const double medio = PASOS * U_FLOAT / 2;
    acota("MillonDePasos", "deriva_matriz", (1 + std::sqrt(3)) * medio, "componente",
          [] { return deriva(matriz()); });
    acota("MillonDePasos", "deriva_cuaternion", 2 * (1 + 2) * medio, "componente",
          [] { return deriva(cuaternion()); });
    // normalizar quita de esa deriva la parte que no es giro: no la aumenta
    acota("MillonDePasos", "deriva_reortonormalizada", 1, "de la de la matriz",
          [] { return deriva(reortonormalizada()) / deriva(matriz()); });
    acota("MillonDePasos", "deriva_cuaternion_unitario", 1, "de la del cuaternión",
          [] { return deriva(cuaternionUnitario()) / deriva(cuaternion()); });
    acota("MillonDePasos", "deriva_recalculada", cotaGiro(ANGULO) + glm::pi<double>() * U_FLOAT, "componente",
          [] { return deriva(recalculada()); });
    acotaCada<glm::mat3 (*)()>(
        "MillonDePasos", "forma_*",
        {{"reortonormalizada", reortonormalizada}, {"cuaternion_unitario", cuaternionUnitario}}, 16 * U_FLOAT,
        "AᵀA − I", [](auto gira) { return faltaDeOrtonormalidad(gira()); });
    acota("MillonDePasos", "forma_recalculada", 2 * std::sqrt(3) * cotaGiro(ANGULO), "AᵀA − I",
          [] { return faltaDeOrtonormalidad(recalculada()); });
    // la matriz sola se deforma al menos cien veces más que la que se reortonormaliza
    acota("MillonDePasos", "la_matriz_sola_se_deforma", 0.01, "razón",
          [] { return faltaDeOrtonormalidad(reortonormalizada()) / faltaDeOrtonormalidad(matriz()); });
});

// --- matriz normal ---

/// |n·t|/(|n||t|) en u de las tres caras de un cubo con sus dos tangentes; infinito si una normal que existe mira hacia
/// dentro.
double torcida(const glm::mat4 &M) {
    const glm::dmat3 N(matrizNormal(M)), m(M);
    return peorHasta(6, [&](int i) {
        const glm::dvec3 n = N[i / 2], t = m[(i / 2 + 1 + i % 2) % 3];
        if (!(glm::dot(n, m[i / 2]) > 0)) // fuera: hacia donde va el punto que estaba delante de la cara
            return HUGE_VAL;
        return std::fabs(glm::dot(glm::normalize(n), glm::normalize(t))) / U_FLOAT;
    });
}
const glm::mat4 INCLINADA = giroX(0.7f) * giroY(-1.1f);

/// Lo que la normal del plano en que queda todo se aparta de la suya, en u; infinito si hay alguna otra.
double aplastada(int eje) {
    glm::vec3 plana(2, 3, 0.5f);
    plana[eje] = 0;
    const glm::mat4 M = INCLINADA * escalado(plana);
    const glm::mat3 N = matrizNormal(M);
    const int i = (eje + 1) % 3, j = (eje + 2) % 3;
    const bool sobra = N[i] != glm::vec3(0) || N[j] != glm::vec3(0);
    const glm::dvec3 n = glm::normalize(glm::cross(glm::dvec3(M[i]), glm::dvec3(M[j])));
    return sobra ? HUGE_VAL : glm::distance(glm::normalize(glm::dvec3(N[eje])), n) / U_FLOAT;
}

const Cotas NORMALES([] {
    acotaCada<float>("MatrizNormal", "uniforme_*",
                     {1e-38f, -1e-38f, 1e-30f, -1e-30f, 1e-20f, -1e-20f, 1e-10f, -1e-10f,
                      1e-5f,  -1e-5f,  1,      -1,      1e5f,   -1e5f,   1e10f,  -1e10f,
                      1e20f,  -1e20f,  1e30f,  -1e30f,  1e38f,  -1e38f},
                     1.001, "u", [](float s) { return torcida(escalado(s) * INCLINADA); });
    const std::vector<Con<int>> ejes = {{"X", 0}, {"Y", 1}, {"Z", 2}};
    acotaCada<int>("MatrizNormal", "aplastada_*", ejes, 2, "u", aplastada);
    acotaCada<int>("MatrizNormal", "casi_aplastada_*", ejes, 1.001, "u", [](int eje) {
        glm::vec3 fina(1);
        fina[eje] = 1e-30f;
        return torcida(INCLINADA * escalado(fina));
    });
    acotaCada<glm::vec3>(
        "MatrizNormal", "aplastada_en_*", {{"una_recta", {1, 0, 0}}, {"un_punto", glm::vec3(0)}}, 0,
        "mayor componente",
        [](const glm::vec3 &s) { return mayorComponente(matrizNormal(INCLINADA * escalado(s))); });
    // Cada cofactor son productos exactos en doble y una resta: llega bien salvo el redondeo a float, |δN| ≤ u·|N|,
    // por mal condicionada que esté M. La mitad reflejan, y ahí la traspuesta de la adjunta mira hacia dentro.
    acotaCada<float>("MatrizNormal", "al_azar_con_decadas_*", {0, 1, 2, 5}, 1.001, "u", [](float decadas) {
        Azar azar(2);
        return peorHasta(20000, [&](int) {
            glm::mat4 M(1);
            for (int j = 0; j < 3; ++j)
                M[j] = glm::vec4(std::pow(10.0f, azar.entre(-decadas, decadas)) * azar.vector(1), 0);
            return torcida(M);
        });
    });
    // se escala por la mayor componente: la columna menor de N queda en 1e-36, que aún es un float normal
    acota("MatrizNormal", "columnas_de_1e18_a_1em18", 1.001, "u", [] {
        return torcida(INCLINADA * escalado({1e18f, 1, 1e-18f}));
    });
});

} // namespace
