// La matriz que transforma las normales (§3.3): los casos difíciles de matrizNormal y lo que dibuja normales.
// u = 2⁻²⁴ es el redondeo de float.
#include "ch03_oraculo.h"
#include "ch03_transformaciones/transformaciones.h"
#include "ejecuta.h"
#include <gtest/gtest.h>
#include <random>
#include <sstream>

namespace {

const double U = 0x1p-24;

std::string texto(double x) {
    std::ostringstream s;
    s << x;
    return s.str();
}

float alAzar(std::mt19937 &azar, float desde, float hasta) {
    return std::uniform_real_distribution<float>(desde, hasta)(azar);
}

/// Matriz afín cualquiera: componentes de −1 a 1 y cada columna por una potencia de 10 de −decadas a decadas.
glm::mat4 afinAlAzar(std::mt19937 &azar, float decadas) {
    glm::mat4 M(1);
    for (int j = 0; j < 3; ++j) {
        const float escala = std::pow(10.0f, alAzar(azar, -decadas, decadas));
        for (int i = 0; i < 3; ++i)
            M[j][i] = escala * alAzar(azar, -1, 1);
        M[3][j] = alAzar(azar, -100, 100);
    }
    return M;
}

/// Las variantes que se comparan, todas en float.
glm::mat3 adjuntaFloat(const glm::mat4 &M) {
    const glm::mat3 m(M), N(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    return glm::dot(m[0], N[0]) < 0 ? -N : N;
}
glm::mat3 traspuestaDeLaInversa(const glm::mat4 &M) {
    return glm::transpose(glm::inverse(glm::mat3(M)));
}

/// |n·t|/(|n||t|) de las tres caras de un cubo con sus dos tangentes, todo en doble salvo M y N.
double faltaDePerpendicularidad(const glm::mat4 &M, const glm::mat3 &N) {
    double peor = 0;
    for (int k = 0; k < 3; ++k)
        for (int j = 1; j <= 2; ++j) {
            const glm::dvec3 n = glm::normalize(glm::dvec3(N[k])),
                             t = glm::normalize(glm::dvec3(M[(k + j) % 3]));
            const double d = std::fabs(glm::dot(n, t));
            peor = d <= peor ? peor : std::isnan(d) ? HUGE_VAL : d;
        }
    return peor;
}

bool esFinita(const glm::mat3 &N) {
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i)
            if (!std::isfinite(N[j][i]))
                return false;
    return true;
}

} // namespace

// Con un escalado uniforme N es la identidad, o menos la identidad si es negativo: ni 1e-20, cuyo cuadrado es
// cero en float, ni 1e20, cuyo cubo es infinito, cambian nada.
TEST(MatrizNormal, EscalasUniformesDe1em20A1e20) {
    for (int k = -20; k <= 20; ++k)
        for (float signo : {1.0f, -1.0f}) {
            const float s = signo * static_cast<float>(std::pow(10.0, k));
            EXPECT_EQ(matrizNormal(escalado(s)), glm::mat3(signo)) << "escala " << s;
        }
    EXPECT_FALSE(esFinita(traspuestaDeLaInversa(escalado(1e-20f))));
    EXPECT_FALSE(esFinita(adjuntaFloat(escalado(1e20f))));
    EXPECT_EQ(matrizNormal(escalado(1e-38f)), glm::mat3(1));
    EXPECT_EQ(matrizNormal(escalado(3e38f)), glm::mat3(1));
}

// Los menores se calculan en doble con productos exactos (24 + 24 bits) y una sola resta, así que cada componente
// de N llega bien salvo el redondeo final a float: |δN| ≤ u·|N|, y para la cara k, cuya normal es la columna k,
// |n·t| ≤ u·|n||t|. Da igual lo mal condicionada que esté M.
TEST(MatrizNormal, PerpendicularidadEnDoble) {
    std::mt19937 azar(1);
    for (float decadas : {0.0f, 3.0f, 10.0f}) {
        double peor = 0, adjunta = 0, inversa = 0;
        for (int k = 0; k < 20000; ++k) {
            const glm::mat4 M = afinAlAzar(azar, decadas);
            const double falta = faltaDePerpendicularidad(M, matrizNormal(M));
            ASSERT_LE(falta, 1.001 * U) << "±10^" << decadas << ", matriz " << k;
            peor = std::max(peor, falta);
            adjunta = std::max(adjunta, faltaDePerpendicularidad(M, adjuntaFloat(M)));
            inversa = std::max(inversa, faltaDePerpendicularidad(M, traspuestaDeLaInversa(M)));
        }
        const std::string clave = "decadas_" + texto(decadas);
        RecordProperty(clave + "_peor_en_u", texto(peor / U));
        RecordProperty(clave + "_adjunta_float_en_u", texto(adjunta / U));
        RecordProperty(clave + "_inversa_float_en_u", texto(inversa / U));
    }
}

// Una normal cualquiera es una combinación de las columnas: el redondeo de cada una cuenta entero, y al cancelarse
// deja |n·t| ≤ u·‖|N||n₀|‖/‖N·n₀‖ (más el de multiplicar, aquí en doble).
TEST(MatrizNormal, PerpendicularidadDeCualquierCara) {
    std::mt19937 azar(2);
    double peor = 0;
    for (int k = 0; k < 20000; ++k) {
        const glm::mat4 M = afinAlAzar(azar, 1);
        const glm::dmat3 N(matrizNormal(M)), m(M);
        const glm::dvec3 n0(alAzar(azar, -1, 1), alAzar(azar, -1, 1), alAzar(azar, -1, 1)),
            otro(alAzar(azar, -1, 1), alAzar(azar, -1, 1), alAzar(azar, -1, 1));
        const glm::dvec3 n = N * n0, t = m * glm::cross(n0, otro);
        const glm::dvec3 sinSigno = glm::abs(N[0] * n0.x) + glm::abs(N[1] * n0.y) + glm::abs(N[2] * n0.z);
        const double falta = std::fabs(glm::dot(n, t)) / (glm::length(n) * glm::length(t));
        ASSERT_LE(falta, 1.001 * U * glm::length(sinSigno) / glm::length(n)) << "matriz " << k;
        peor = std::max(peor, falta);
    }
    RecordProperty("peor_en_u", texto(peor / U));
}

// La adjunta del libro es det(M)·M⁻ᵀ: con det(M) < 0 mira hacia dentro. «Fuera» se decide sin normales: hacia donde
// va, transformado, un punto que estaba delante de la cara.
TEST(MatrizNormal, ConDeterminanteNegativoSigueHaciaFuera) {
    std::mt19937 azar(3);
    int negativos = 0;
    for (int k = 0; k < 20000; ++k) {
        const glm::mat4 M = afinAlAzar(azar, 2);
        const glm::dmat3 m(M);
        const double det = glm::determinant(m),
                     relativo = det / (glm::length(m[0]) * glm::length(m[1]) * glm::length(m[2]));
        if (std::fabs(relativo) < 1e-6)
            continue; // casi plana: el volumen cambia de signo con el redondeo
        const glm::dmat3 N(matrizNormal(M)),
            libro(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
        const glm::dvec3 n0(alAzar(azar, -1, 1), alAzar(azar, -1, 1), alAzar(azar, -1, 1)), fuera = m * n0;
        ASSERT_GT(glm::dot(N * n0, fuera), 0) << "matriz " << k << ", det " << det;
        ASSERT_EQ(glm::dot(libro * n0, fuera) > 0, det > 0) << "matriz " << k;
        negativos += det < 0;
    }
    EXPECT_GT(negativos, 9000);
    EXPECT_EQ(matrizNormal(escalado({-1, 1, 1})), glm::mat3(escalado({-1, 1, 1})));
    EXPECT_EQ(matrizNormal(escalado(-1)), glm::mat3(-1));
}

// Aplastada en un plano, la inversa no existe pero la normal del plano sí, y es la de todas las caras que no se
// quedan sin área. Aplastada en una recta o en un punto no hay normal que valga: cero, y no NaN.
TEST(MatrizNormal, UnEjeAplastado) {
    const glm::mat4 giro = giroX(0.7f) * giroY(-1.1f);
    for (int eje = 0; eje < 3; ++eje) {
        glm::vec3 s(2, 3, 0.5f);
        s[eje] = 0;
        const glm::mat4 M = traslacion({5, -3, 2}) * giro * escalado(s);
        const glm::mat3 N = matrizNormal(M);
        const glm::dvec3 delPlano =
            glm::normalize(glm::cross(glm::dvec3(M[(eje + 1) % 3]), glm::dvec3(M[(eje + 2) % 3])));
        EXPECT_LE(glm::distance(glm::normalize(glm::dvec3(N[eje])), delPlano), 2 * U);
        for (int otro = 1; otro <= 2; ++otro)
            EXPECT_EQ(N[(eje + otro) % 3], glm::vec3(0));
        EXPECT_FALSE(esFinita(traspuestaDeLaInversa(escalado(s))));
    }
    for (const glm::vec3 s : {glm::vec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}, {0, 0, 0}})
        EXPECT_EQ(matrizNormal(giro * escalado(s)), glm::mat3(0));
}

// Aplastar casi del todo, o estirar sin medida, no es distinto: nada se sale de rango.
TEST(MatrizNormal, UnEjeCasiAplastado) {
    for (float s : {1e-3f, 1e-10f, 1e-20f, 1e-30f, 1e30f})
        for (int eje = 0; eje < 3; ++eje)
            for (float signo : {1.0f, -1.0f}) {
                glm::vec3 escalas(1);
                escalas[eje] = signo * s;
                const glm::mat4 M = giroZ(0.3f) * escalado(escalas);
                const glm::mat3 N = matrizNormal(M);
                ASSERT_TRUE(esFinita(N));
                EXPECT_LE(faltaDePerpendicularidad(M, N), 1.001 * U) << "escala " << s;
                for (int k = 0; k < 3; ++k)
                    EXPECT_GT(glm::dot(glm::dvec3(N[k]), glm::dvec3(M[k])), 0) << "escala " << s;
            }
}

// --- El programa -------------------------------------------------------------------------------------------

namespace {

using oraculo::Mat4;
using oraculo::Vec3;

const Vec3 FONDO{0.95, 0.96, 0.98};

struct Flecha {
    Vec3 pie, hacia;
    glm::vec3 color;
    std::u32string rotulo; // vacío si no lleva
};

/// La escena sin ninguna matriz de normales: las de los lados salen del producto vectorial de los lados ya
/// transformados, puestas hacia fuera del centro del prisma. La adjunta del libro es ese producto vectorial
/// tal cual, y la roja, la normal del lado original con su x y su y escaladas.
struct EscenaNormales {
    std::vector<ch03::Cuerpo> cuerpos;
    std::vector<Flecha> flechas;
};
EscenaNormales escenaNormales(double sx, double sy) {
    const double p[4][2] = {{0.25, -0.95}, {0.85, 0.15}, {-0.10, 0.90}, {-0.90, -0.20}}, fondo = 0.45;
    EscenaNormales escena;
    std::vector<oraculo::VerticeRef> vertices;
    std::vector<std::array<std::size_t, 3>> indices;
    const auto poligono = [&](const std::vector<Vec3> &esquinas, const Vec3 &normal) {
        const std::size_t b = vertices.size();
        for (const Vec3 &q : esquinas)
            vertices.push_back({q, normal});
        for (std::size_t i = b + 1; i + 1 < vertices.size(); ++i)
            indices.push_back({b, i, i + 1});
    };
    std::vector<Vec3> delante, detras;
    for (int i = 0; i < 4; ++i) {
        const double *a = p[i], *b = p[(i + 1) % 4];
        const Vec3 A{sx * a[0], sy * a[1], fondo}, B{sx * b[0], sy * b[1], fondo}, alFondo{0, 0, -2 * fondo},
            medio = 0.5 * (A + B);
        const Vec3 vectorialLado = vectorial(B - A, {0, 0, 1}); // hacia fuera si el polígono gira antihorario
        Vec3 n = unitario(escalar(vectorialLado, medio) < 0 ? -vectorialLado : vectorialLado);
        if (sy == 0)
            n = {0, b[0] < a[0] ? 1.0 : -1.0, 0}; // los lados de arriba, que son los que se ven
        if (sy != 0 || n.y > 0)
            poligono({A, B, B + alFondo, A + alFondo}, n);
        delante.push_back(A), detras.push_back(A + alFondo);

        const Vec3 pie = medio + Vec3{0, 0, 0.018},
                   conM = oraculo::unitario({sx * (b[1] - a[1]), sy * (a[0] - b[0]), 0});
        const bool coinciden = escalar(conM, n) > 0.999;
        const auto flecha = [&](const Vec3 &hacia, const glm::vec3 &color, const std::u32string &rotulo) {
            escena.flechas.push_back({pie, unitario(hacia), color, i == (sy == 0 ? 2 : 1) ? rotulo : U""});
        };
        flecha(n, VERDE, coinciden ? U"N·n = M·n" : U"N·n");
        if (!coinciden)
            flecha(conM, ROJO, U"M·n");
        if (sx * sy < 0)
            flecha(vectorialLado, NARANJA, U"adjunta");
    }
    if (sy != 0)
        poligono(delante, {0, 0, 1}), poligono(detras, {0, 0, -1});
    escena.cuerpos.push_back({oraculo::malla(Mat4(), vertices, indices), {0.72, 0.82, 0.97}});
    return escena;
}

} // namespace

TEST(ProgramaNormales, CadaCasoContraElOraculo) {
    const oraculo::Camara camara = paralela(oraculo::orbita(0.16, 0.32, 8), 1.75, 1, 20);
    const struct {
        const char *guion;
        double sx, sy;
        std::u32string leyenda;
    } casos[] = {{"", 1, 1, U"M = I"},
                 {"tecla 4; tecla 1", 1, 1, U"M = I"},
                 {"tecla 2", 2, 1, U"M = S(2, 1, 1)"},
                 {"tecla 3", -2, 1, U"M = S(−2, 1, 1)"},
                 {"tecla 4", 2, 0, U"M = S(2, 0, 1)"}};
    for (const auto &caso : casos) {
        SCOPED_TRACE(caso.guion);
        const Ejecucion e = ejecuta("ch03_transformaciones/normales", caso.guion);
        ASSERT_EQ(e.estado, 0) << e.errores;
        const EscenaNormales escena = escenaNormales(caso.sx, caso.sy);
        int tapados = 0;
        const oraculo::Comparacion c = ch03::compara(e.imagen, escena.cuerpos, camara, FONDO, 1,
                                                     {ROJO, VERDE, NARANJA, OSCURO, BLANCO}, &tapados);
        EXPECT_LE(c.maximo, 1) << c;
        EXPECT_LE(c.desvio, ch03::DESVIO) << c;
        EXPECT_LT(tapados, 4000);
        RecordProperty("escalado_" + texto(caso.sx) + "_" + texto(caso.sy),
                       (std::ostringstream() << c).str());

        int deCadaColor[3] = {};
        for (const Flecha &f : escena.flechas) {
            const int color = f.color == VERDE ? 0 : f.color == ROJO ? 1 : 2;
            ++deCadaColor[color];
            for (double largo : {0.3, 0.5, 0.7}) // de largo 0.75
                EXPECT_TRUE(ch03::hayTrazo(e.imagen, camara, f.pie + largo * f.hacia, f.color))
                    << color << " " << largo;
            if (f.color == VERDE && f.rotulo.empty()) { // las verdes no se cruzan con nada
                EXPECT_FALSE(ch03::hayTrazo(e.imagen, camara, f.pie + 0.8 * f.hacia, f.color));
            }
            if (!f.rotulo.empty()) {
                EXPECT_TRUE(
                    ch03::estaRotulado(e.imagen, camara, f.pie + 0.99 * f.hacia, f.rotulo, f.color, 2))
                    << color;
            }
        }
        EXPECT_EQ(deCadaColor[0], 4);
        EXPECT_EQ(deCadaColor[1], caso.sx == 1 ? 0 : 4);
        EXPECT_EQ(deCadaColor[2], caso.sx < 0 ? 4 : 0);
        EXPECT_EQ(buscaRotulo(e.imagen, caso.leyenda, OSCURO).size(), 1u);
    }
}
