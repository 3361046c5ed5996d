// Comprobaciones independientes de las proyecciones y del área de dibujo (ecuaciones 4.2 a 4.4): vista.h y
// volumen.h contra cuádruple precisión y contra GLM, lo que el libro imprime, y los programas proyecciones y
// volumen_vista.
#include "ch04_oraculo.h"
#include "ch04_vista3d/vista.h"
#include "ch04_vista3d/volumen.h"
#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <iostream>
#include <random>

namespace {

using Cuadruple = boost::multiprecision::cpp_bin_float_quad;
using Punto = std::array<Cuadruple, 4>;
using Matriz = std::array<Punto, 4>; // por filas

const double U_DOBLE = std::ldexp(1.0, -53);

/// Ecuación 4.3 corregida, en cuádruple y por filas: el ángulo entero θ, y el aspecto divide.
Matriz perspectivaCuadruple(double theta, double aspecto, double cerca, double lejos) {
    const Cuadruple t = tan(Cuadruple(theta) / 2), c = cerca, l = lejos;
    return {{{1 / (Cuadruple(aspecto) * t), 0, 0, 0},
             {0, 1 / t, 0, 0},
             {0, 0, (l + c) / (c - l), 2 * l * c / (c - l)},
             {0, 0, -1, 0}}};
}
/// Ecuación 4.2 con cerca y lejos como distancias hacia −Z.
Matriz paralelaCuadruple(double i, double d, double b, double a, double c, double l) {
    const Cuadruple ancho = Cuadruple(d) - i, alto = Cuadruple(a) - b, fondo = Cuadruple(l) - c;
    return {{{2 / ancho, 0, 0, -(Cuadruple(d) + i) / ancho},
             {0, 2 / alto, 0, -(Cuadruple(a) + b) / alto},
             {0, 0, -2 / fondo, -(Cuadruple(l) + c) / fondo},
             {0, 0, 0, 1}}};
}

/// El punto que la matriz lleva a v: eliminación de Gauss con pivote, y división por la cuarta componente.
std::array<double, 3> resuelve(Matriz A, Punto v) {
    for (std::size_t k = 0; k < 4; ++k) {
        std::size_t pivote = k;
        for (std::size_t f = k; f < 4; ++f)
            if (abs(A[f][k]) > abs(A[pivote][k]))
                pivote = f;
        std::swap(A[k], A[pivote]);
        std::swap(v[k], v[pivote]);
        for (std::size_t f = 0; f < 4; ++f) {
            if (f == k)
                continue;
            const Cuadruple m = A[f][k] / A[k][k];
            for (std::size_t c = k; c < 4; ++c)
                A[f][c] -= m * A[k][c];
            v[f] -= m * v[k];
        }
    }
    std::array<double, 3> p{};
    for (std::size_t k = 0; k < 3; ++k)
        p[k] = static_cast<double>(v[k] / A[k][k] / (v[3] / A[3][3]));
    return p;
}

/// Mayor error relativo entre los elementos que no son nulos; los nulos tienen que serlo exactamente.
double errorRelativo(const glm::dmat4 &M, const Matriz &exacta) {
    double peor = 0;
    for (int c = 0; c < 4; ++c)
        for (int f = 0; f < 4; ++f) {
            const Cuadruple e = exacta[static_cast<std::size_t>(f)][static_cast<std::size_t>(c)];
            if (e == 0)
                EXPECT_EQ(M[c][f], 0) << f << "," << c;
            else
                peor = std::fmax(peor, static_cast<double>(abs((M[c][f] - e) / e)));
        }
    return peor;
}

const struct {
    double theta, aspecto, cerca, lejos;
} PERSPECTIVAS[] = {{0.6, 1.5, 1, 100},     {1.2, 4.0 / 3, 0.1, 1e3},     {0.5, 1, 0.01, 1e4},
                    {2.9, 0.25, 1e-3, 1e6}, {0.01, 1.0 / 2000, 1, 1.001}, {1.57, 300, 1e-30, 1}};

} // namespace

// θ/2 es exacto, la tangente de la biblioteca yerra menos de 1 ulp (2 u) y el producto y el cociente 1 u cada uno;
// la tercera fila, tres redondeos. En total no más de 4 u.
TEST(Proyeccion, ContraLaEcuacionEnCuadruple) {
    double peor = 0;
    for (const auto &p : PERSPECTIVAS)
        peor = std::fmax(peor, errorRelativo(proyeccionPerspectiva(p.theta, p.aspecto, p.cerca, p.lejos),
                                             perspectivaCuadruple(p.theta, p.aspecto, p.cerca, p.lejos)));
    // lados sin redondear el ancho, el alto ni el fondo: la resta no añade error
    peor = std::fmax(peor, errorRelativo(proyeccionParalela(-1, 3, -2, 0.5, 1, 100),
                                         paralelaCuadruple(-1, 3, -2, 0.5, 1, 100)));
    peor = std::fmax(peor, errorRelativo(proyeccionParalela(0.1, 0.7, 1e6, 1e6 + 3, -5, 1e-3),
                                         paralelaCuadruple(0.1, 0.7, 1e6, 1e6 + 3, -5, 1e-3)));
    std::cout << "error relativo máximo: " << peor / U_DOBLE << " u\n";
    EXPECT_LE(peor, 4 * U_DOBLE);
}

TEST(Proyeccion, ContraGlm) {
    for (const auto &p : PERSPECTIVAS) {
        const glm::dmat4 M = proyeccionPerspectiva(p.theta, p.aspecto, p.cerca, p.lejos),
                         G = glm::perspective(p.theta, p.aspecto, p.cerca, p.lejos);
        for (int c = 0; c < 4; ++c)
            for (int f = 0; f < 4; ++f)
                EXPECT_NEAR(M[c][f], G[c][f], 8 * U_DOBLE * std::fabs(G[c][f]));
    }
    const glm::dmat4 M = proyeccionParalela(-1, 3, -2, 0.5, 1, 100),
                     G = glm::ortho(-1.0, 3.0, -2.0, 0.5, 1.0, 100.0);
    for (int c = 0; c < 4; ++c)
        for (int f = 0; f < 4; ++f)
            EXPECT_NEAR(M[c][f], G[c][f], 8 * U_DOBLE * std::fabs(G[c][f]));
}

// La profundidad normalizada va de −1 en cerca a 1 en lejos y crece siempre, aunque lejos/cerca sea 1e9.
TEST(Proyeccion, LaProfundidadCreceDeCercaALejos) {
    for (const double cerca : {1e-30, 1e-3, 1.0})
        for (const double razon : {1e2, 1e4, 1e6, 1e9}) {
            const glm::dmat4 M = proyeccionPerspectiva(1, 1, cerca, cerca * razon);
            double anterior = -2;
            for (int k = 0; k <= 20; ++k) {
                const double d = k == 20 ? cerca * razon : cerca * std::pow(razon, k / 20.0);
                const glm::dvec4 v = M * glm::dvec4(0, 0, -d, 1);
                EXPECT_GT(v.z / v.w, anterior);
                anterior = v.z / v.w;
                if (k == 0) {
                    EXPECT_NEAR(anterior, -1, 8 * U_DOBLE);
                }
            }
            EXPECT_NEAR(anterior, 1, 8 * U_DOBLE);
        }
}

// El libro imprime 2/(lejos − cerca) en la ecuación 4.2 y la 4.3 con el signo contrario: de dos puntos que están
// delante de la cámara, el lejano sale con menos profundidad que el cercano, y ninguno en [−1, 1].
TEST(Erratas, Ecuacion42DelReves) {
    const double c = 1, l = 100;
    glm::dmat4 impresa = proyeccionParalela(-1, 1, -1, 1, c, l);
    impresa[2][2] = 2 / (l - c);
    const auto z = [](const glm::dmat4 &M, double d) {
        const glm::dvec4 v = M * glm::dvec4(0, 0, -d, 1);
        return v.z / v.w;
    };
    const glm::dmat4 per = proyeccionPerspectiva(1, 1, c, l), par = proyeccionParalela(-1, 1, -1, 1, c, l);
    EXPECT_LT(z(per, 2), z(per, 50));
    EXPECT_LT(z(par, 2), z(par, 50));
    EXPECT_GT(z(impresa, 2), z(impresa, 50));
    // no solo del revés: con 0 < cerca < lejos, todo lo que hay entre los dos planos queda fuera y se recorta
    for (double d = c; d <= l; d += 1)
        EXPECT_LT(z(impresa, d), -1) << d;
    glm::dmat4 deDiez = proyeccionParalela(-1, 1, -1, 1, 1, 10);
    deDiez[2][2] = 2.0 / (10 - 1);
    EXPECT_NEAR(z(deDiez, 1), -1.44, 0.005);
    EXPECT_NEAR(z(deDiez, 10), -3.44, 0.005);
}

// Con aspect/tan(θ) un cuadrado no se ve cuadrado, y con θ (el ángulo entero de la figura 4.4 y de
// glm::perspective) en vez de θ/2 el borde del campo no cae en el borde de la ventana.
TEST(Erratas, Ecuacion43AspectoYAngulo) {
    const double theta = 0.8, nx = 640, ny = 240;
    const auto ventana = [&](const glm::dmat4 &P, const glm::dvec4 &v) {
        const glm::dvec4 r = P * v;
        return transformacionViewport(0, 0, nx, ny) * (r / r.w);
    };
    const glm::dmat4 P = proyeccionPerspectiva(theta, nx / ny, 1, 100);
    glm::dmat4 impresa = P;
    impresa[0][0] = nx / ny / std::tan(theta);
    impresa[1][1] = 1 / std::tan(theta);
    const glm::dvec4 centro(0, 0, -5, 1), x(1, 0, -5, 1), y(0, 1, -5, 1),
        borde(0, 5 * std::tan(theta / 2), -5, 1);
    const auto razon = [&](const glm::dmat4 &M) {
        return (ventana(M, x).x - ventana(M, centro).x) / (ventana(M, y).y - ventana(M, centro).y);
    };
    EXPECT_NEAR(razon(P), 1, 1e-14);
    EXPECT_NEAR(razon(impresa), std::pow(nx / ny, 2), 1e-12);
    EXPECT_NEAR(ventana(P, borde).y, ny, 1e-12);
    EXPECT_LT(ventana(impresa, borde).y, 0.96 * ny);
}

// El volumen canónico llena justo la ventana y la profundidad va de 0 a 1 (o lo que diga glDepthRange). La matriz
// del libro pone el centro del píxel (0, 0) en (0, 0) y OpenGL en (0.5, 0.5): ch04_etapas_test lo ve en la imagen.
TEST(Viewport, EsquinasYProfundidad) {
    const glm::dmat4 M = transformacionViewport(10, 20, 300, 7, 0.25, 0.75);
    EXPECT_EQ(M * glm::dvec4(-1, -1, -1, 1), glm::dvec4(10, 20, 0.25, 1));
    EXPECT_EQ(M * glm::dvec4(1, 1, 1, 1), glm::dvec4(310, 27, 0.75, 1));
    EXPECT_EQ(transformacionViewport(0, 0, 1, 1) * glm::dvec4(0, 0, 0, 1), glm::dvec4(0.5, 0.5, 0.5, 1));
}

// Parámetros imposibles: un mensaje en una línea y estado 1, nunca una matriz con NaN.
TEST(ProyeccionDeathTest, ParametrosImposibles) {
    const auto acaba1 = testing::ExitedWithCode(1);
    EXPECT_EXIT(proyeccionPerspectiva(0, 1, 1, 2), acaba1, "proyeccionPerspectiva: hace falta 0 < theta < π");
    EXPECT_EXIT(proyeccionPerspectiva(3.2, 1, 1, 2), acaba1, "proyeccionPerspectiva");
    EXPECT_EXIT(proyeccionPerspectiva(1, 0, 1, 2), acaba1, "proyeccionPerspectiva");
    EXPECT_EXIT(proyeccionPerspectiva(1, 1, 0, 2), acaba1, "proyeccionPerspectiva");
    EXPECT_EXIT(proyeccionPerspectiva(1, 1, 2, 2), acaba1, "proyeccionPerspectiva");
    EXPECT_EXIT(proyeccionPerspectiva(std::nan(""), 1, 1, 2), acaba1, "proyeccionPerspectiva");
    EXPECT_EXIT(proyeccionParalela(1, 1, 0, 1, 0, 1), acaba1, "proyeccionParalela");
    EXPECT_EXIT(proyeccionParalela(0, 1, 0, std::nan(""), 0, 1), acaba1, "proyeccionParalela");
}

// Las ocho esquinas son los puntos que la proyección lleva a (±1, ±1, ±1). En cuádruple y al revés, por Gauss.
// Las de volumen.h llevan la tangente (2 u), el aspecto y la distancia (1 u cada uno).
TEST(VolumenVista, EsquinasContraLaInversaEnCuadruple) {
    const int lados[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    double peor = 0;
    const auto comprueba = [&](const Esquinas &e, const Matriz &P) {
        for (std::size_t k = 0; k < 8; ++k) {
            const auto exacta = resuelve(P, {lados[k % 4][0], lados[k % 4][1], k < 4 ? -1 : 1, 1});
            for (int c = 0; c < 3; ++c) {
                const double x = exacta[static_cast<std::size_t>(c)];
                EXPECT_NEAR(e[k][c], x, 5 * U_DOBLE * std::fabs(x)) << k << "," << c;
                peor = std::fmax(peor, std::fabs(e[k][c] / x - 1));
            }
        }
    };
    for (const auto &p : PERSPECTIVAS)
        if (p.lejos / p.cerca <
            1e15) // con 1e30, la matriz pierde cerca incluso en cuádruple: no tiene inversa
            comprueba(esquinasPerspectiva(p.theta, p.aspecto, p.cerca, p.lejos),
                      perspectivaCuadruple(p.theta, p.aspecto, p.cerca, p.lejos));
    comprueba(esquinasParalela(-1, 3, -2, 0.5, 1, 100), paralelaCuadruple(-1, 3, -2, 0.5, 1, 100));
    std::cout << "error relativo máximo: " << peor / U_DOBLE << " u\n";
}

// --- proyecciones ------------------------------------------------------------------------------------------

namespace {

namespace o = oraculo;

const int ANCHO = 960, ALTO = 720;

/// La vista de proyecciones.cpp, escrita otra vez.
o::Camara camaraCubo(bool enPerspectiva) {
    const o::Camara c = o::orbita(0.50, 0.33, 3.0, {0.1, 0.2, 0});
    return enPerspectiva ? o::perspectiva(c, 1.0, 0.1, 2000)
                         : o::paralela(c, 3.0 * std::tan(0.5), -2000, 2000);
}

/// Centros de los tramos de un color en una columna, de arriba abajo, si no tocan una arista.
std::vector<double> tramos(const Imagen &imagen, int x, const glm::vec3 &color) {
    std::vector<double> centros;
    int desde = -1;
    for (int y = imagen.alto - 1; y >= -1; --y) {
        const bool esta = y >= 0 && esColor(pixel(imagen, x, y), color);
        if (esta && desde < 0)
            desde = y;
        if (!esta && desde >= 0) {
            centros.push_back(0.5 * (desde + y + 1) + 0.5);
            desde = -1;
        }
    }
    return centros;
}

/// Las cuatro aristas en la dirección del eje `e`, prolongadas hacia el fondo desde su extremo lejano.
std::vector<o::Vec3> finales(int e, double signo) {
    std::vector<o::Vec3> v;
    for (const double a : {-0.5, 0.5})
        for (const double b : {-0.5, 0.5})
            v.push_back(e == 0 ? o::Vec3{0.5 * signo, a, b} : o::Vec3{a, b, 0.5 * signo});
    return v;
}

} // namespace

// En paralela, direcciones iguales dan direcciones iguales; en perspectiva todas las paralelas van al mismo punto, el
// de la proyección de (d, 0). Con matrices de vista.h y rectas al azar.
TEST(Proyecciones, RectasParalelasYPuntoDeFuga) {
    std::mt19937 azar(44);
    std::uniform_real_distribution<double> u(-1, 1);
    const glm::dmat4 V = transformacionCamara({4, 3, 6}, {0, 0, 0}, {0, 1, 0}),
                     par = proyeccionParalela(-2, 2, -2, 2, 1, 20) * V,
                     per = proyeccionPerspectiva(1, 1, 0.1, 2000) * V;
    for (int n = 0; n < 1000; ++n) {
        const glm::dvec3 d(u(azar), u(azar), u(azar) - 1), a(u(azar), u(azar), u(azar)),
            b(u(azar), u(azar), u(azar));
        const auto divide = [](const glm::dvec4 &v) { return glm::dvec3(v) / v.w; };
        const auto en = [&](const glm::dmat4 &M, const glm::dvec3 &p) {
            return divide(M * glm::dvec4(p, 1));
        };
        EXPECT_LE(glm::length((en(par, a + d) - en(par, a)) - (en(par, b + d) - en(par, b))), 16 * U_DOBLE);
        // el punto de fuga, con la cámara del oráculo: la dirección en sus ejes
        const o::Ejes e = o::ejes(o::miraDesde({4, 3, 6}, {0, 0, 0}));
        const o::Vec3 dir{d.x, d.y, d.z};
        const double fondo = -o::escalar(dir, e.z);
        if (fondo < 0.3)
            continue;
        const double t = std::tan(0.5), x = o::escalar(dir, e.x) / fondo / t,
                     y = o::escalar(dir, e.y) / fondo / t;
        const glm::dvec3 fuga = divide(per * glm::dvec4(d, 0));
        EXPECT_NEAR(fuga.x, x, 1e-14);
        EXPECT_NEAR(fuga.y, y, 1e-14);
        const glm::dvec3 lejosA = en(per, a + 1e6 * d), lejosB = en(per, b + 1e6 * d);
        // a 1e6 veces d, un punto que empezó a menos de 10 del ojo se aparta de la fuga menos de esto
        EXPECT_NEAR(lejosA.x, x, 10 * (1 / t + std::fabs(x)) / (1e6 * fondo - 10));
        EXPECT_NEAR(lejosB.y, y, 10 * (1 / t + std::fabs(y)) / (1e6 * fondo - 10));
    }
}

// En la imagen paralela: entre dos columnas las cuatro rectas rojas suben lo mismo, y están donde dice el oráculo.
TEST(Proyecciones, EnParalelaSiguenParalelas) {
    const Ejecucion e = ejecuta("ch04_vista3d/proyecciones", "tecla p", ANCHO, ALTO);
    ASSERT_EQ(e.estado, 0) << e.errores;
    const o::Camara camara = camaraCubo(false);
    for (const auto &[eje, color, x1, x2] : {std::tuple(0, ROJO, 40, 240), {2, AZUL, 700, 790}}) {
        const std::vector<double> y1 = tramos(e.imagen, x1, color), y2 = tramos(e.imagen, x2, color);
        ASSERT_EQ(y1.size(), 4u);
        ASSERT_EQ(y2.size(), 4u);
        std::vector<double> esperadas;
        const o::Vec3 d = eje == 0 ? o::Vec3{-1, 0, 0} : o::Vec3{0, 0, -1};
        for (const o::Vec3 &v : finales(eje, -1)) {
            const o::Vec3 a = o::proyecta(camara, ANCHO, ALTO, v),
                          b = o::proyecta(camara, ANCHO, ALTO, v + d);
            esperadas.push_back(a.y + (x1 + 0.5 - a.x) * (b.y - a.y) / (b.x - a.x));
        }
        std::sort(esperadas.rbegin(), esperadas.rend());
        for (std::size_t k = 0; k < 4; ++k) {
            EXPECT_NEAR(y2[k] - y1[k], y2[0] - y1[0], 1) << "recta " << k << " del eje " << eje;
            EXPECT_NEAR(y1[k], esperadas[k], 1) << "recta " << k << " del eje " << eje;
        }
    }
}

// En perspectiva: cada recta pasa por el extremo de su arista y por el punto de fuga, que está donde debe.
TEST(Proyecciones, EnPerspectivaVanAlPuntoDeFuga) {
    const Ejecucion e = ejecuta("ch04_vista3d/proyecciones", "", ANCHO, ALTO);
    ASSERT_EQ(e.estado, 0) << e.errores;
    const o::Camara camara = camaraCubo(true);
    const o::Ejes ejes = o::ejes(camara);
    for (const auto &[eje, color, x] : {std::tuple(0, ROJO, 150), {2, AZUL, 690}}) {
        const o::Vec3 d = eje == 0 ? o::Vec3{-1, 0, 0} : o::Vec3{0, 0, -1};
        const double k = 0.5 * ALTO / std::tan(0.5) / -o::escalar(d, ejes.z);
        const double fx = 0.5 * ANCHO + k * o::escalar(d, ejes.x),
                     fy = 0.5 * ALTO + k * o::escalar(d, ejes.y);
        if (eje == 2) { // el otro cae fuera de la imagen
            // el disco que lo señala, de 20 píxeles, por los límites de su parte de abajo (encima está el rótulo)
            int minX = ANCHO, maxX = -1, minY = ALTO;
            for (int py = static_cast<int>(fy) - 14; py + 0.5 < fy - 5; ++py)
                for (int px = static_cast<int>(fx) - 14; px <= fx + 14; ++px)
                    if (esColor(pixel(e.imagen, px, py), OSCURO))
                        minX = std::min(minX, px), maxX = std::max(maxX, px), minY = std::min(minY, py);
            EXPECT_NEAR(0.5 * (minX + maxX + 1), fx, 1);
            EXPECT_NEAR(minY, fy - 10, 1);
            EXPECT_LE(distanciaRotulo(e.imagen, U"punto de fuga", OSCURO, fx, fy + 26), 70.0 / ALTO);
        }

        std::vector<double> esperadas;
        for (const o::Vec3 &v : finales(eje, -1)) {
            const o::Vec3 a = o::proyecta(camara, ANCHO, ALTO, v);
            esperadas.push_back(a.y + (x + 0.5 - a.x) * (fy - a.y) / (fx - a.x));
        }
        std::sort(esperadas.rbegin(), esperadas.rend());
        const std::vector<double> y = tramos(e.imagen, x, color);
        ASSERT_EQ(y.size(), 4u) << eje;
        for (std::size_t n = 0; n < 4; ++n)
            EXPECT_NEAR(y[n], esperadas[n], 1) << "recta " << n << " del eje " << eje;
    }
}

// El horizonte: a la altura de los ojos, de lado a lado, más grueso que las rectas; en paralela no hay.
TEST(Proyecciones, ElHorizonte) {
    const Ejecucion e = ejecuta("ch04_vista3d/proyecciones", "", ANCHO, ALTO),
                    paralela = ejecuta("ch04_vista3d/proyecciones", "tecla p", ANCHO, ALTO);
    const double y = 0.5 * ALTO * (1 + std::tan(0.33) / std::tan(0.5)); // el ojo mira 0.33 hacia abajo
    for (int x = 3; x < ANCHO; x += 50) {
        int grueso = 0;
        double suma = 0;
        for (int py = static_cast<int>(y) - 8; py <= y + 8; ++py)
            if (esColor(pixel(e.imagen, x, py), OSCURO))
                ++grueso, suma += py + 0.5;
        if (std::abs(x - 860) < 60)
            continue;                   // el punto de fuga
        EXPECT_NEAR(grueso, 6, 1) << x; // 9 de 1080
        EXPECT_NEAR(suma / grueso, y, 1) << x;
    }
    EXPECT_EQ(buscaRotulo(e.imagen, U"horizonte", OSCURO).size(), 1u);
    EXPECT_EQ(buscaRotulo(e.imagen, U"perspectiva", OSCURO).size(), 1u);
    EXPECT_EQ(buscaRotulo(paralela.imagen, U"paralela", OSCURO).size(), 1u);
    EXPECT_TRUE(buscaRotulo(paralela.imagen, U"horizonte", OSCURO).empty());
    EXPECT_LE(distanciaRotulo(e.imagen, U"horizonte", OSCURO, 430, y + 26), 0.2);
}

// El cubo, con sus tres caras a la vista, de la luz que les toca.
TEST(Proyecciones, ElCubo) {
    for (const bool enPerspectiva : {true, false}) {
        const Ejecucion e = ejecuta("ch04_vista3d/proyecciones", enPerspectiva ? "" : "tecla p", ANCHO, ALTO);
        for (const o::Vec3 &n : {o::Vec3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
            const o::Vec3 w = o::proyecta(camaraCubo(enPerspectiva), ANCHO, ALTO, 0.5 * n);
            const o::Vec3 color = 255 * luzExacta(n) * vec3De(AMARILLO);
            const Pixel p = pixel(e.imagen, static_cast<int>(w.x), static_cast<int>(w.y));
            EXPECT_NEAR(p.r, color.x, 1);
            EXPECT_NEAR(p.g, color.y, 1);
            EXPECT_NEAR(p.b, color.z, 1);
            apuntaDiferencia(
                std::max({std::fabs(p.r - color.x), std::fabs(p.g - color.y), std::fabs(p.b - color.z)}));
        }
    }
}

// Por mucho que se gire la rueda, la proyección sigue siendo posible y la escena a la vista.
TEST(Proyecciones, LaRuedaNoAcabaElPrograma) {
    for (const char *rueda : {"rueda +1 9 9; ", "rueda -1 9 9; "})
        for (const char *tecla : {"", "tecla p; "}) {
            std::string guion = tecla;
            for (int i = 0; i < 400; ++i)
                guion += rueda;
            const Ejecucion e = ejecuta("ch04_vista3d/proyecciones", guion);
            EXPECT_EQ(e.estado, 0) << e.errores;
            int amarillos = 0;
            for (int y = 0; y < 180; ++y)
                for (int x = 0; x < 240; ++x) {
                    const Pixel p = pixel(e.imagen, x, y);
                    amarillos += p.r > 1.5 * p.b && p.g > 1.5 * p.b;
                }
            EXPECT_GT(amarillos, 500) << rueda;
        }
}
