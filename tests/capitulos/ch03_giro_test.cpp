// Giro alrededor de un eje (§3.4): los casos difíciles de giroEje contra la fórmula de Rodrigues en cuádruple
// precisión, la deriva de un millón de giros, y giro_eje contra el oráculo. u = 2⁻²⁴ es el redondeo de float.
#include "ch03_oraculo.h"
#include "ch03_transformaciones/transformaciones.h"
#include "ejecuta.h"
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>
#include <random>
#include <sstream>

namespace {

using Cuadruple = boost::multiprecision::cpp_bin_float_quad;
const double U = 0x1p-24;

struct Matriz {
    Cuadruple f[3][3]; // por filas
};

/// Rodrigues: I·cos t + (1 − cos t)·ddᵀ + sen t·[d]×, con 1 − cos t = 2·sen²(t/2). Los datos float son exactos.
Matriz rodrigues(const glm::vec3 &eje, const Cuadruple &t) {
    Cuadruple x = eje.x, y = eje.y, z = eje.z;
    const Cuadruple largo = sqrt(x * x + y * y + z * z), mitad = sin(t / 2);
    x /= largo, y /= largo, z /= largo;
    const Cuadruple c = cos(t), s = sin(t), v = 2 * mitad * mitad;
    return {{{c + v * x * x, v * x * y - s * z, v * x * z + s * y},
             {v * x * y + s * z, c + v * y * y, v * y * z - s * x},
             {v * x * z - s * y, v * y * z + s * x, c + v * z * z}}};
}

/// La mayor diferencia entre componentes. Un NaN sale como infinito.
double distancia(const glm::mat3 &a, const Matriz &b, bool sinDiagonal = false) {
    double mayor = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const double d = std::fabs(static_cast<double>(Cuadruple(a[j][i]) - b.f[i][j]));
            if (i != j || !sinDiagonal)
                mayor = d <= mayor ? mayor : std::isnan(d) ? HUGE_VAL : d;
        }
    return mayor;
}

/// ‖AᵀA − I‖, la mayor componente, en doble.
double faltaDeOrtonormalidad(const glm::mat3 &A) {
    const glm::dmat3 a(A), r = glm::transpose(a) * a - glm::dmat3(1);
    double mayor = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            mayor = std::fabs(r[i][j]) <= mayor ? mayor : std::isnan(r[i][j]) ? HUGE_VAL : std::fabs(r[i][j]);
    return mayor;
}

/// Cota de giroEje, componente a componente. Con D = Rx(t) − I, de norma 2·|sen(t/2)|, el error de I + RᵀDR es
/// el redondeo de la suma (u, porque el resultado no pasa de 1) más 2·‖δR‖·‖D‖ más el de los dos productos de
/// matrices y del seno. d y e llegan con 4u (una división y una normalización) y f = d × e con 10u:
/// ‖δR‖ ≤ √(4² + 4² + 10²)·u < 12u. Cada producto de tres términos añade 3u·‖|R||D|‖ ≤ 6u·‖D‖ y el seno 2u.
double cotaGiro(double t) {
    return U * (1 + (24 + 12 + 2) * 2 * std::fabs(std::sin(t / 2)));
}

std::string texto(double x) {
    std::ostringstream s;
    s << x;
    return s.str();
}

glm::vec3 ejeAlAzar(std::mt19937 &azar) {
    std::normal_distribution<float> normal;
    const float x = normal(azar), y = normal(azar), z = normal(azar);
    return {x, y, z};
}

/// Ecuación 3.10 al pie de la letra, en float.
glm::mat3 giroDelLibro(const glm::vec3 &eje, float t) {
    const glm::mat3 R = cambioDeBase(unitario(eje));
    return glm::transpose(R) * glm::mat3(giroX(t)) * R;
}

} // namespace

TEST(GiroEje, ContraRodriguesEnCuadruple) {
    std::mt19937 azar(1);
    double peor = 0;
    for (float t : {0.0f, 1e-6f, 1e-4f, 0.001f, 0.1f, 1.0f, -2.0f, 3.1415927f, 6.2831853f, 100.0f})
        for (int k = 0; k < 300; ++k) {
            const glm::vec3 eje = ejeAlAzar(azar);
            const double error = distancia(glm::mat3(giroEje(eje, t)), rodrigues(eje, t));
            ASSERT_LE(error, cotaGiro(t)) << "t = " << t << ", error " << error / U << " u";
            peor = std::max(peor, error);
        }
    RecordProperty("peor_en_u", texto(peor / U));
}

TEST(GiroEje, LosTresEjesCoordenados) {
    const glm::vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    for (float t : {1e-4f, 0.5f, -1.0f, 2.5f, 3.1415927f}) {
        // cada componente es un seno o un coseno redondeado: medio ulp de la biblioteca y medio de guardarlo
        EXPECT_LE(distancia(glm::mat3(giroX(t)), rodrigues(x, t)), 2 * U);
        EXPECT_LE(distancia(glm::mat3(giroY(t)), rodrigues(y, t)), 2 * U);
        EXPECT_LE(distancia(glm::mat3(giroZ(t)), rodrigues(z, t)), 2 * U);
    }
}

// Ejes (1,e,0) y sus permutaciones: la base sigue siendo ortonormal y a derechas, d va a X y el giro es exacto.
TEST(GiroEje, EjesCasiParalelosAUnCoordenado) {
    double peorBase = 0, peorGiro = 0;
    for (float e : {0.0f, 1e-30f, 1e-20f, 1e-10f})
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                for (float signo : {1.0f, -1.0f}) {
                    if (i == j)
                        continue;
                    glm::vec3 eje(0);
                    eje[i] = signo;
                    eje[j] = e;
                    const glm::mat3 R = cambioDeBase(unitario(eje));
                    peorBase = std::max(peorBase, faltaDeOrtonormalidad(R));
                    // ‖RᵀR − I‖ ≤ 2·‖δR‖ < 24u, como en cotaGiro
                    ASSERT_LE(faltaDeOrtonormalidad(R), 24 * U) << "e = " << e;
                    EXPECT_GT(glm::determinant(glm::dmat3(R)), 0.99);
                    EXPECT_LE(glm::distance(glm::dvec3(R * unitario(eje)), glm::dvec3(1, 0, 0)), 24 * U);
                    for (float t : {1e-4f, 1.0f, 3.0f}) {
                        const double error = distancia(glm::mat3(giroEje(eje, t)), rodrigues(eje, t));
                        ASSERT_LE(error, cotaGiro(t)) << "e = " << e << ", t = " << t;
                        peorGiro = std::max(peorGiro, error);
                    }
                }
    RecordProperty("base_en_u", texto(peorBase / U));
    RecordProperty("giro_en_u", texto(peorGiro / U));
}

// El cuadrado de 1e-23 es cero en float y el de 1e20 infinito; 1e-42 ya es subnormal y 3e38 casi el mayor.
TEST(GiroEje, EjeMuyCortoOMuyLargo) {
    const glm::vec3 direcciones[] = {{1, 0, 0}, {1, 2, -2}, {-0.3f, 1e-3f, 0.9f}};
    for (float largo : {1e-23f, 1e20f, 1e-42f, 1e38f})
        for (const glm::vec3 &direccion : direcciones) {
            const glm::vec3 eje = largo * direccion;
            for (float t : {1e-4f, 1.0f, 3.0f})
                EXPECT_LE(distancia(glm::mat3(giroEje(eje, t)), rodrigues(eje, t)), cotaGiro(t))
                    << "longitud " << largo;
        }
}

TEST(GiroEje, EjeNuloNoGira) {
    EXPECT_EQ(giroEje(glm::vec3(0), 1), glm::mat4(1));
    EXPECT_EQ(giroEje(glm::vec3(-0.0f), 1), glm::mat4(1));
}

// En float 1 − cos(1e-4) es 0, y en RᵀRxR lo que gira se suma a un RᵀR que solo es casi I. giroEje calcula
// aparte lo que se aparta de I: el error relativo del desplazamiento no depende del ángulo.
TEST(GiroEje, AnguloPequeno) {
    EXPECT_EQ(1 - std::cos(1e-4f), 0);
    std::mt19937 azar(2);
    for (float t : {1e-4f, 1e-6f}) {
        double peor = 0, libro = 0;
        for (int k = 0; k < 1000; ++k) {
            const glm::vec3 eje = ejeAlAzar(azar);
            const Matriz exacta = rodrigues(eje, t);
            peor = std::max(peor, distancia(glm::mat3(giroEje(eje, t)), exacta, true) / t);
            libro = std::max(libro, distancia(giroDelLibro(eje, t), exacta, true) / t);
        }
        // fuera de la diagonal no hay suma con 1: el redondeo es el de cotaGiro sin su primer término
        EXPECT_LE(peor, 40 * U) << "t = " << t;
        EXPECT_GT(libro, 1000 * peor) << "t = " << t << ": no hace falta apartarse de la ecuación";
        RecordProperty("relativo_t_" + texto(t), texto(peor));
        RecordProperty("libro_relativo_t_" + texto(t), texto(libro));
    }
}

// Un millón de pasos de 0.001 radianes (159 vueltas). Cada producto en float se aparta de un giro exacto en
// menos de β = ‖S̃ − S‖ + 9u < 3·1.08u + 9u < 13u (cotaGiro por 3 pasa de la mayor componente a la norma; un
// producto de matrices ortonormales redondea 3u por componente, 9u en norma): tras k pasos,
// (1 + β)^k − 1 ≤ e^(kβ) − 1 = 1.2, que no garantiza nada. Reortonormalizar quita la deformación y deja la del
// ángulo; recalcular desde el ángulo no acumula nada.
TEST(GiroEje, MillonDePasos) {
    const int pasos = 1000000;
    const float paso = 0.001f;
    const glm::vec3 eje(1, 2, 3), d = unitario(eje);
    const glm::mat3 S(giroEje(eje, paso));
    const glm::quat qPaso = glm::angleAxis(paso, d);

    glm::mat3 producto(1), reortonormalizada(1), libro(1);
    const glm::mat3 SLibro = giroDelLibro(eje, paso);
    glm::quat cuaternion(1, 0, 0, 0), cuaternionUnitario(1, 0, 0, 0);
    for (int i = 0; i < pasos; ++i) {
        producto = S * producto;
        libro = SLibro * libro;
        glm::mat3 &A = reortonormalizada;
        A = S * A;
        A[0] = glm::normalize(A[0]);
        A[1] = glm::normalize(A[1] - glm::dot(A[0], A[1]) * A[0]);
        A[2] = glm::cross(A[0], A[1]);
        cuaternion = qPaso * cuaternion;
        cuaternionUnitario = glm::normalize(qPaso * cuaternionUnitario);
    }
    const double angulo = static_cast<double>(paso) * pasos; // exacto: 24 bits por 20
    const glm::mat3 recalculada(giroEje(eje, static_cast<float>(std::remainder(angulo, 2 * oraculo::PI))));

    const Matriz exacta = rodrigues(eje, Cuadruple(paso) * pasos);
    const auto mide = [&](const char *nombre, const glm::mat3 &A) {
        RecordProperty(std::string(nombre) + "_ortonormalidad", texto(faltaDeOrtonormalidad(A)));
        RecordProperty(std::string(nombre) + "_distancia", texto(distancia(A, exacta)));
        return distancia(A, exacta);
    };
    const double cota = std::expm1(pasos * 13 * U);
    EXPECT_LE(mide("producto", producto), cota);
    mide("producto_del_libro", libro);
    EXPECT_LE(mide("reortonormalizada", reortonormalizada), cota);
    EXPECT_LE(mide("cuaternion", glm::mat3_cast(cuaternion)), cota);
    EXPECT_LE(mide("cuaternion_unitario", glm::mat3_cast(cuaternionUnitario)), cota);
    // el ángulo, menor que π, se redondea a float con error π·u
    EXPECT_LE(mide("recalculada", recalculada), cotaGiro(angulo) + oraculo::PI * U);

    // Lo que se vuelve a normalizar en cada paso no se deforma: 4u por vector y 6u entre ellos
    EXPECT_LE(faltaDeOrtonormalidad(reortonormalizada), 16 * U);
    EXPECT_LE(faltaDeOrtonormalidad(glm::mat3_cast(cuaternionUnitario)), 16 * U);
    EXPECT_LE(faltaDeOrtonormalidad(recalculada), 2 * cotaGiro(angulo) * std::sqrt(3.0));
    EXPECT_GT(faltaDeOrtonormalidad(producto), 100 * faltaDeOrtonormalidad(reortonormalizada));
}

// --- El programa -------------------------------------------------------------------------------------------

namespace {

using oraculo::escala;
using oraculo::Mat4;
using oraculo::traslada;
using oraculo::Vec3;

const Vec3 FONDO{0.95, 0.96, 0.98};

/// La matriz de Rodrigues, en cuádruple precisión hasta el final.
Mat4 giroExacto(const Vec3 &d, double t) {
    const Matriz m = rodrigues({d.x, d.y, d.z}, t);
    Mat4 r;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            r.f[i][j] = static_cast<double>(m.f[i][j]);
    return r;
}

void ponAvion(std::vector<ch03::Cuerpo> &cuerpos, const Mat4 &M, double viveza) {
    const Vec3 naranja{0.95, 0.55, 0.10}, amarillo{0.98, 0.78, 0.15}, rojo{0.85, 0.20, 0.18};
    const Vec3 piezas[][3] = {{{0, 0, 0}, {1.1, 0.22, 0.22}, naranja},
                              {{0.1, 0, 0}, {0.32, 0.08, 1.3}, amarillo},
                              {{-0.45, 0, 0}, {0.18, 0.06, 0.5}, amarillo},
                              {{-0.42, 0.22, 0}, {0.2, 0.34, 0.07}, rojo}};
    for (const auto &p : piezas)
        cuerpos.push_back(
            {oraculo::caja(M * traslada(p[0]) * escala(p[1])), FONDO + viveza * (p[2] - FONDO)});
}

/// El avión sin girar y girado, en doble.
const Vec3 SITIO_AVION{-1.1, 0.2, 1.2};
std::vector<ch03::Cuerpo> escenaGiro(const Vec3 &eje, double angulo) {
    std::vector<ch03::Cuerpo> cuerpos;
    ponAvion(cuerpos, traslada(SITIO_AVION), 0.3);
    ponAvion(cuerpos, giroExacto(unitario(eje), angulo) * traslada(SITIO_AVION), 1);
    return cuerpos;
}

oraculo::Camara camaraGiro(double azimut = -0.5, double elevacion = 0.4) {
    return perspectiva(oraculo::orbita(azimut, elevacion, 7), 0.6, 1, 30);
}

/// Qué parte de esos puntos, de los que no tapa el avión, está trazada con ese color; −1 si los tapa casi todos.
double trazados(const Imagen &imagen, const oraculo::Camara &camara, const std::vector<ch03::Cuerpo> &cuerpos,
                const std::vector<Vec3> &puntos, const glm::vec3 &color) {
    oraculo::Escena escena;
    for (const ch03::Cuerpo &c : cuerpos)
        escena.push_back(c.objeto);
    int vistos = 0, bien = 0;
    for (const Vec3 &p : puntos) {
        const double distancia = longitud(p - camara.ojo);
        const oraculo::Impacto i =
            primerImpacto(escena, {camara.ojo, unitario(p - camara.ojo), 0, oraculo::INFINITO});
        if (i && i.distancia < distancia + 0.1)
            continue;
        ++vistos;
        bien += ch03::hayTrazo(imagen, camara, p, color);
    }
    return vistos > 5 ? static_cast<double>(bien) / vistos : -1;
}

/// La imagen de giro_eje tras `guion` es la de ese eje y ese ángulo: los dos aviones, píxel a píxel; el eje y la base según la
/// regla del libro, con sus letras; y lo que recorre el avión.
void compruebaGiro(const std::string &guion, const Vec3 &eje, double angulo, const oraculo::Camara &camara) {
    SCOPED_TRACE(guion);
    const Ejecucion e = ejecuta("ch03_transformaciones/giro_eje", guion);
    ASSERT_EQ(e.estado, 0) << e.errores;
    const std::vector<ch03::Cuerpo> cuerpos = escenaGiro(eje, angulo);
    int tapados = 0;
    const oraculo::Comparacion c = ch03::compara(e.imagen, cuerpos, camara, FONDO, 1,
                                                 {ROJO, VERDE, AZUL, MORADO, GRIS, OSCURO, BLANCO}, &tapados);
    EXPECT_LE(c.maximo, 1) << c;
    EXPECT_LE(c.desvio, ch03::DESVIO) << c;
    EXPECT_LT(tapados, 5000);

    const Vec3 d = unitario(eje), letraE = direccion(ch03::baseDelLibro(d), {1, 0, 0}),
               letraF = direccion(ch03::baseDelLibro(d), {0, 1, 0});
    EXPECT_TRUE(ch03::estaRotulado(e.imagen, camara, 1.75 * d, U"d", ROJO, 2));
    EXPECT_TRUE(ch03::estaRotulado(e.imagen, camara, 1.05 * letraE, U"e", VERDE, 2));
    EXPECT_TRUE(ch03::estaRotulado(e.imagen, camara, 1.05 * letraF, U"f", AZUL, 2));
    const auto tramo = [](const Vec3 &v, double desde, double hasta) {
        std::vector<Vec3> puntos;
        for (int i = 0; i <= 20; ++i)
            puntos.push_back((desde + (hasta - desde) * i / 20) * v);
        return puntos;
    };
    EXPECT_EQ(trazados(e.imagen, camara, cuerpos, tramo(d, 0.2, 1.55), ROJO), 1);
    const double detras = trazados(e.imagen, camara, cuerpos, tramo(d, -1.55, -0.3), OSCURO);
    EXPECT_TRUE(detras == -1 || detras > 0.7) << detras; // el arco lo cruza
    EXPECT_GT(trazados(e.imagen, camara, cuerpos, tramo(letraE, 0.2, 0.85), VERDE), 0.7);
    EXPECT_GT(trazados(e.imagen, camara, cuerpos, tramo(letraF, 0.2, 0.85), AZUL), 0.7);
    std::vector<Vec3> recorrido, lejos;
    for (int i = 1; i < 40; ++i) {
        recorrido.push_back(punto(giroExacto(d, angulo * i / 40), SITIO_AVION));
        const double resto = angulo + std::copysign(2 * oraculo::PI - std::fabs(angulo), angulo) * i / 40;
        lejos.push_back(punto(giroExacto(d, resto), SITIO_AVION));
    }
    EXPECT_GT(trazados(e.imagen, camara, cuerpos, recorrido, MORADO),
              0.75); // lo demás lo tapan flechas y letras
    EXPECT_GT(trazados(e.imagen, camara, cuerpos, lejos, GRIS), 0.75);
    const Vec3 medio = punto(giroExacto(d, angulo / 2), SITIO_AVION),
               haciaFuera = unitario(medio - escalar(medio, d) * d);
    EXPECT_TRUE(ch03::estaRotulado(e.imagen, camara, medio + 0.2 * haciaFuera, U"φ", MORADO, 2));
    testing::Test::RecordProperty("eje_" + texto(eje.x) + "_" + texto(eje.y) + "_" + texto(eje.z),
                                  (std::ostringstream() << c).str());
}

bool seLee(const std::string &guion, const std::u32string &leyenda) {
    return buscaRotulo(ejecuta("ch03_transformaciones/giro_eje", guion).imagen, leyenda, OSCURO).size() == 1;
}

} // namespace

TEST(ProgramaGiroEje, CadaEjeContraElOraculo) {
    compruebaGiro("", {0, 1, 0}, 2, camaraGiro());
    compruebaGiro("tecla 2", {1, 1, 1}, 2, camaraGiro());
    compruebaGiro("tecla 3", {-0.6, 0.7, 0.4}, 2, camaraGiro());
    compruebaGiro("tecla 4", {1, 1e-10, 0}, 2, camaraGiro());
}

TEST(ProgramaGiroEje, LasTeclasGiran) {
    compruebaGiro("tecla 3; tecla a; tecla a; tecla a", {-0.6, 0.7, 0.4}, 2.3, camaraGiro());
    std::string guion = "tecla 2";
    for (int i = 0; i < 30; ++i)
        guion += "; tecla d";
    compruebaGiro(guion, {1, 1, 1}, -1, camaraGiro());
}

// 2 radianes son 114.6°; 1/√3 = 0.577.
TEST(ProgramaGiroEje, LaLeyendaDiceElAnguloYElEje) {
    EXPECT_TRUE(seLee("", U"φ = 115°, d = (0, 1, 0)"));
    EXPECT_TRUE(seLee("tecla 2", U"φ = 115°, d = (0.58, 0.58, 0.58)"));
    EXPECT_TRUE(seLee("tecla 4; tecla d", U"φ = 109°, d = (1, 0, 0)"));
}

// Con el botón izquierdo el eje gira alrededor de los ejes de la pantalla: 50 píxeles a la derecha son medio
// radián alrededor de la vertical de la cámara y 30 hacia abajo 0.3 alrededor de su horizontal.
TEST(ProgramaGiroEje, ElRatonMueveElEje) {
    const oraculo::Ejes camara = ejes(camaraGiro());
    const Vec3 lado = direccion(giroExacto(camara.y, 0.5), {0, 1, 0});
    compruebaGiro("boton IZQUIERDO abajo 100 80; arrastra 150 80; boton IZQUIERDO arriba 150 80", lado, 2,
                  camaraGiro());
    const Vec3 abajo = direccion(giroExacto(camara.x, 0.3), {0, 1, 0});
    compruebaGiro("boton IZQUIERDO abajo 100 80; arrastra 100 110; boton IZQUIERDO arriba 100 110", abajo, 2,
                  camaraGiro());
}

TEST(ProgramaGiroEje, ElBotonDerechoOrbita) {
    compruebaGiro("tecla 3; boton DERECHO abajo 100 80; arrastra 60 90; boton DERECHO arriba 60 90",
                  {-0.6, 0.7, 0.4}, 2, camaraGiro(-0.1, 0.5));
}
