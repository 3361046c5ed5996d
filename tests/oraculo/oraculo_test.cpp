// El oráculo contra fórmulas cerradas y ecuaciones implícitas escritas aquí.
#include "ejecuta.h"
#include "malla.h"
#include "oraculo/oraculo.h"
#include <algorithm>
#include <gtest/gtest.h>
#include <iostream>
#include <random>

using namespace oraculo;

namespace {

/// Transformación sin nada especial: escala distinta en cada eje, refleja, gira y traslada.
const Mat4 TORCIDA = traslada({0.3, -1.2, 0.7}) * gira({1, 2, -0.5}, 0.8) * escala({1.3, -0.6, 0.9});

double alAzar(double desde, double hasta) {
    static std::mt19937 generador(12345);
    return std::uniform_real_distribution<>(desde, hasta)(generador);
}

Vec3 puntoAlAzar(double lado) {
    return {alAzar(-lado, lado), alAzar(-lado, lado), alAzar(-lado, lado)};
}

/// Rayo desde lejos hacia las cercanías del centro de M.
Rayo rayoAlAzar(const Mat4 &M, double talla) {
    const Vec3 origen = punto(M, 5 * talla * unitario(puntoAlAzar(1)));
    return {origen, unitario(punto(M, puntoAlAzar(talla)) - origen), 0, INFINITO};
}

double distanciaEntre(const Vec3 &a, const Vec3 &b) {
    return longitud(a - b);
}

/// Cada forma con su ecuación implícita en coordenadas del objeto: negativa dentro, 0 en la superficie.
struct Caso {
    const char *nombre;
    Objeto objeto;
    double (*F)(const Vec3 &);
    double talla;
};
const float RADIO = 1, TUBO = 0.375f; // exactos en float
const std::vector<Caso> CASOS = {
    {"esfera", esfera(TORCIDA), [](const Vec3 &p) { return longitud(p) - 1; }, 1},
    {"caja", caja(TORCIDA),
     [](const Vec3 &p) {
         return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}) - 0.5;
     },
     0.6},
    {"cilindro", cilindro(TORCIDA),
     [](const Vec3 &p) { return std::max(std::hypot(p.x, p.y) - 1, std::fabs(p.z) - 0.5); }, 1.1},
    {"cono", cono(TORCIDA), [](const Vec3 &p) { return std::max(std::hypot(p.x, p.y) + p.z - 1, -p.z); },
     1.1},
    {"toro", toro(TORCIDA, RADIO, TUBO),
     [](const Vec3 &p) { return std::hypot(std::hypot(p.x, p.y) - RADIO, p.z) - TUBO; }, 1.4},
};

} // namespace

// --- Cálculo -----------------------------------------------------------------------------------------------

TEST(Algebra, InversaYGiro) {
    const Mat4 I = TORCIDA * inversa(TORCIDA);
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            EXPECT_NEAR(I.f[i][j], i == j, 1e-15);
    EXPECT_LT(distanciaEntre(direccion(gira({0, 0, 5}, PI / 2), {1, 0, 0}), {0, 1, 0}), 1e-15);
    EXPECT_LT(distanciaEntre(direccion(gira({0, 1, 0}, PI / 2), {1, 0, 0}), {0, 0, -1}), 1e-15);
    EXPECT_LT(distanciaEntre(direccion(gira({1, 1, 1}, 2 * PI / 3), {1, 2, 3}), {3, 1, 2}), 2e-15);
    EXPECT_THROW(inversa(escala({1, 0, 1})), std::invalid_argument);
}

TEST(Algebra, RaicesDePolinomios) {
    // (t+3)(t+1)(t−0.5)(t−2)
    const std::vector<double> cuatro = raicesPolinomio(std::array<double, 5>{3, -3.5, -6, 1.5, 1}, -10, 10);
    ASSERT_EQ(cuatro.size(), 4u);
    const double exactas[] = {-3, -1, 0.5, 2};
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(cuatro[i], exactas[i], 1e-14);
    EXPECT_EQ(raicesPolinomio(std::array<double, 5>{3, -3.5, -6, 1.5, 1}, -2, 1).size(), 2u);
    EXPECT_TRUE(raicesPolinomio(std::array<double, 5>{1, 0, 0, 0, 1}, -10, 10).empty());
}

// --- Cortes ------------------------------------------------------------------------------------------------

TEST(Cortes, DistanciasExactas) {
    const auto distancia = [](const Objeto &o, const Vec3 &origen, const Vec3 &hacia) {
        return primerImpacto({o}, {origen, unitario(hacia), 0, INFINITO}).distancia;
    };
    const Mat4 I;
    EXPECT_DOUBLE_EQ(distancia(esfera(I), {0, 0, 5}, {0, 0, -1}), 4);
    EXPECT_DOUBLE_EQ(distancia(esfera(I), {0, 0.6, 5}, {0, 0, -1}), 4.2);
    EXPECT_DOUBLE_EQ(distancia(esfera(I), {0, 0, 0}, {1, 2, 3}), 1); // desde dentro
    EXPECT_DOUBLE_EQ(distancia(esfera(traslada({2, 0, 0}) * escala({0.5, 0.5, 3})), {2, 0, 9}, {0, 0, -1}),
                     6);
    EXPECT_NEAR(distancia(esfera(I), {1e6, 0.6, 0}, {-1, 0, 0}), 1e6 - 0.8, 2e-10); // un ulp de 1e6
    EXPECT_DOUBLE_EQ(distancia(caja(I), {0.2, 0.3, 5}, {0, 0, -1}), 4.5);
    EXPECT_DOUBLE_EQ(distancia(caja(I), {0, 0, 0}, {0, -1, 0}), 0.5);
    EXPECT_NEAR(distancia(caja(I), {2, 2, 2}, {-1, -1, -1}), 1.5 * std::sqrt(3), 1e-15); // por la esquina
    EXPECT_DOUBLE_EQ(distancia(cilindro(I), {0.6, 5, 0.1}, {0, -1, 0}), 4.2);
    EXPECT_DOUBLE_EQ(distancia(cilindro(I), {0.6, 0.2, 5}, {0, 0, -1}), 4.5); // paralelo al eje
    EXPECT_DOUBLE_EQ(distancia(cono(I), {5, 0, 0.25}, {-1, 0, 0}), 4.25);
    EXPECT_NEAR(distancia(cono(I), {5, 0, 0}, {-1, 0, 0.1}), 4 / 0.9 * std::hypot(1, 0.1), 1e-15);
    EXPECT_DOUBLE_EQ(distancia(cono(I), {0.2, 0.1, -3}, {0, 0, 1}), 3); // la tapa
    EXPECT_DOUBLE_EQ(distancia(toro(I, 1, 0.25), {5, 0, 0}, {-1, 0, 0}), 3.75);
    EXPECT_DOUBLE_EQ(distancia(toro(I, 1, 0.25), {0, 0, 0}, {0, 1, 0}), 0.75); // desde el agujero
    EXPECT_FALSE(primerImpacto({toro(I, 1, 0.25)}, {{0.1, 0, 5}, {0, 0, -1}, 0, INFINITO}));
    EXPECT_DOUBLE_EQ(distancia(plano(escala(4)), {1, 1.5, 3}, {0, 0, -1}), 3);
    EXPECT_DOUBLE_EQ(distancia(triangulo({0, 0, 0}, {2, 0, 0}, {0, 2, 0}), {0.5, 0.5, 7}, {0, 0, -1}), 7);
    EXPECT_FALSE(
        primerImpacto({triangulo({0, 0, 0}, {2, 0, 0}, {0, 2, 0})}, {{1.1, 1, 7}, {0, 0, -1}, 0, INFINITO}));
}

// El punto está en la superficie y es el primero (nada hay dentro antes, muestreando el rayo), y la normal es
// el gradiente de la ecuación implícita. Sin corte, el rayo entero está fuera.
TEST(Cortes, EcuacionesImplicitasYGradientes) {
    for (const Caso &caso : CASOS) {
        const Mat4 inv = inversa(TORCIDA);
        const auto F = [&](const Vec3 &p) { return caso.F(punto(inv, p)); };
        int cortes = 0;
        double peorF = 0, peorNormal = 0;
        for (int n = 0; n < 2000; ++n) {
            const Rayo r = rayoAlAzar(TORCIDA, caso.talla);
            const Impacto i = primerImpacto({caso.objeto}, r);
            const double hasta = i ? i.distancia - 1e-6 : 12 * caso.talla;
            for (int k = 0; k <= 200; ++k)
                ASSERT_GT(F(r.origen + (hasta * k / 200) * r.direccion), 0) << caso.nombre << " rayo " << n;
            if (!i)
                continue;
            ++cortes;
            EXPECT_TRUE(i.frente);
            EXPECT_NEAR(longitud(i.normal), 1, 1e-15);
            peorF = std::max(peorF, std::fabs(F(i.punto)));
            const double h = 1e-6;
            const Vec3 gradiente = {F(i.punto + Vec3{h, 0, 0}) - F(i.punto - Vec3{h, 0, 0}),
                                    F(i.punto + Vec3{0, h, 0}) - F(i.punto - Vec3{0, h, 0}),
                                    F(i.punto + Vec3{0, 0, h}) - F(i.punto - Vec3{0, 0, h})};
            peorNormal = std::max(peorNormal, distanciaEntre(unitario(gradiente), i.normal));
        }
        EXPECT_GT(cortes, 500) << caso.nombre;
        EXPECT_LT(peorF, 1e-13) << caso.nombre;
        EXPECT_LT(peorNormal, 1e-8) << caso.nombre;
        std::cout << caso.nombre << ": " << cortes << " cortes, |F| " << peorF << ", normal " << peorNormal
                  << "\n";
    }
}

// Desde dentro se ve la otra cara y la normal sigue hacia fuera.
TEST(Cortes, DesdeDentro) {
    for (const Caso &caso : CASOS) {
        const Vec3 dentro =
            punto(TORCIDA, caso.objeto.forma == Objeto::TORO ? Vec3{RADIO, 0, 0} : Vec3{0, 0, 0.1});
        const Impacto i = primerImpacto({caso.objeto}, {dentro, unitario({0.3, 0.5, -0.7}), 0, INFINITO});
        ASSERT_TRUE(i) << caso.nombre;
        EXPECT_FALSE(i.frente) << caso.nombre;
        EXPECT_GT(escalar(i.normal, i.rayo.direccion), 0) << caso.nombre;
        EXPECT_NEAR(caso.F(punto(inversa(TORCIDA), i.punto)), 0, 1e-14) << caso.nombre;
    }
}

// Cada sólido contra la malla fina que dibujan los programas: mismo punto, misma normal y mismas coordenadas de
// textura (módulo 1: la costura). Con n segmentos la flecha es 1 − cos(π/n) y la normal varía hasta π/n.
TEST(Cortes, CoincidenConLasMallas) {
    const int n = 256;
    const double paso = PI / n, mirada = 40; // un corte rasante aleja el punto: flecha/coseno
    const struct {
        Objeto solido;
        Malla malla;
        double talla;
    } parejas[] = {{esfera(TORCIDA), esfera(n), 1},
                   {caja(TORCIDA), cubo(), 0.6},
                   {cilindro(TORCIDA), cilindro(n), 1.1},
                   {cono(TORCIDA), cono(n), 1.1},
                   {toro(TORCIDA, RADIO, TUBO), toro(RADIO, TUBO, n, n), 1.4},
                   {plano(TORCIDA), plano(3), 0.5}};
    for (const auto &[solido, laMalla, talla] : parejas) {
        const Objeto conMalla = malla(TORCIDA, laMalla);
        int cortes = 0;
        for (int k = 0; k < 500; ++k) {
            const Rayo r = rayoAlAzar(TORCIDA, talla);
            const Impacto a = primerImpacto({solido}, r), b = primerImpacto({conMalla}, r);
            if (!a || !b || escalar(a.normal, a.rayo.direccion) > -0.1 ||
                distanciaEntre(a.normal, b.normal) > 0.3)
                continue; // las aristas y lo rasante no se comparan
            ++cortes;
            ASSERT_LT(distanciaEntre(a.punto, b.punto), mirada * paso * paso) << solido.forma;
            ASSERT_LT(distanciaEntre(a.normal, b.normal), 10 * paso) << solido.forma;
            const auto modulo1 = [](double v) { return std::fabs(v - std::round(v)); };
            const double rho = std::hypot(punto(solido.inv, a.punto).x, punto(solido.inv, a.punto).y);
            if (rho < 0.2)
                continue; // cerca de los polos s cambia muy deprisa
            ASSERT_LT(modulo1(a.s - b.s), 10 * paso) << solido.forma << " s " << a.s << " " << b.s;
            ASSERT_LT(modulo1(a.t - b.t), 10 * paso) << solido.forma << " t " << a.t << " " << b.t;
        }
        EXPECT_GT(cortes, 100) << solido.forma;
    }
}

// La jerarquía de cajas ve lo mismo que probar los triángulos uno a uno.
TEST(Cortes, LaJerarquiaNoPierdeTriangulos) {
    const Malla laMalla = toro(RADIO, TUBO, 24, 12);
    const Objeto conJerarquia = malla(TORCIDA, laMalla);
    Escena sueltos;
    for (std::size_t i = 0; i < laMalla.indices.size(); i += 3) {
        const auto v = [&](std::size_t k) {
            const glm::vec3 &p = laMalla.vertices[laMalla.indices[i + k]].posicion;
            return punto(TORCIDA, {p.x, p.y, p.z});
        };
        sueltos.push_back(triangulo(v(0), v(1), v(2)));
    }
    int cortes = 0;
    for (int k = 0; k < 1000; ++k) {
        const Rayo r = rayoAlAzar(TORCIDA, 1.4);
        const Impacto a = primerImpacto({conJerarquia}, r), b = primerImpacto(sueltos, r);
        ASSERT_EQ(static_cast<bool>(a), static_cast<bool>(b));
        cortes += static_cast<bool>(a);
        if (a) {
            ASSERT_NEAR(a.distancia, b.distancia, 1e-13);
        }
    }
    EXPECT_GT(cortes, 300);
}

TEST(Cortes, ZonasDeUnaMalla) {
    const auto zonas = [](const Malla &m) {
        std::vector<int> z = malla(Mat4{}, m).triangulos->zona;
        std::sort(z.begin(), z.end());
        return std::unique(z.begin(), z.end()) - z.begin();
    };
    EXPECT_EQ(zonas(cubo()), 6);
    EXPECT_EQ(zonas(cilindro(16)), 3);
    EXPECT_EQ(zonas(cono(16)), 2);
    EXPECT_EQ(zonas(esfera(16)), 1);
}

// --- Cámara ------------------------------------------------------------------------------------------------

TEST(Camara, IdaYVuelta) {
    const Camara base = orbita(0.7, -0.4, 12, {1, 2, 3});
    for (const Camara &c : {perspectiva(base, 0.9, 0.5, 80), paralela(base, 3, 1, 30)})
        for (const auto &[ancho, alto] : {std::pair(240, 180), {180, 240}, {1, 1}, {333, 7}})
            for (int n = 0; n < 50; ++n) {
                const double px = alAzar(0, ancho), py = alAzar(0, alto);
                const Rayo r = rayo(c, ancho, alto, px, py);
                EXPECT_NEAR(longitud(r.direccion), 1, 1e-15);
                const double t = alAzar(r.minimo, r.maximo);
                const Vec3 v = proyecta(c, ancho, alto, r.origen + t * r.direccion);
                EXPECT_NEAR(v.x, px, 1e-11);
                EXPECT_NEAR(v.y, py, 1e-11);
                EXPECT_NEAR(proyecta(c, ancho, alto, r.origen + r.minimo * r.direccion).z, 0, 1e-13);
                EXPECT_NEAR(proyecta(c, ancho, alto, r.origen + r.maximo * r.direccion).z, 1, 1e-13);
            }
}

// El ángulo y el semilado abarcan el alto de la ventana, o el que tendría a 4:3 si es más estrecha, sin deformar.
TEST(Camara, AltoUtil) {
    const Camara base = miraDesde({0, 0, 4}, {0, 0, 0});
    const double t = 4 * std::tan(0.3);
    const auto iguales = [](const Vec3 &v, double x, double y) {
        EXPECT_NEAR(v.x, x, 1e-12);
        EXPECT_NEAR(v.y, y, 1e-12);
    };
    iguales(proyecta(perspectiva(base, 0.6, 1, 9), 240, 180, {0, t, 0}), 120, 180);
    iguales(proyecta(perspectiva(base, 0.6, 1, 9), 240, 180, {t, 0, 0}), 210, 90);
    iguales(proyecta(perspectiva(base, 0.6, 1, 9), 100, 300, {t, 0, 0}), 87.5, 150);
    iguales(proyecta(paralela(base, 2, 1, 9), 240, 180, {-2, -2, 0}), 30, 0);
    iguales(proyecta(paralela(base, 2, 1, 9), 100, 300, {-2, 2, 0}), 12.5, 187.5);
    // ecuaciones 4.2 y 4.3: profundidad 1/2 a 2·cerca·lejos/(cerca + lejos), y a medio camino
    EXPECT_NEAR(proyecta(perspectiva(base, 0.6, 1, 9), 9, 9, {0, 0, 4 - 1.8}).z, 0.5, 1e-15);
    EXPECT_NEAR(proyecta(paralela(base, 2, 1, 9), 9, 9, {0, 0, 4 - 5}).z, 0.5, 1e-15);
}

TEST(Camara, Orbita) {
    const Vec3 ojo = orbita(0.5, 0.25, 23, {1.5, 5.2, 0}).ojo;
    EXPECT_LT(
        distanciaEntre(ojo, Vec3{1.5, 5.2, 0} + 23 * Vec3{std::cos(0.25) * std::sin(0.5), std::sin(0.25),
                                                          std::cos(0.25) * std::cos(0.5)}),
        1e-14);
    const Camara c = miraDesde({3, 1, 2}, {0, 1, 2});
    EXPECT_LT(distanciaEntre(enCamara(c, {0, 1, 2}), {0, 0, -3}), 1e-15);
    EXPECT_LT(distanciaEntre(enCamara(c, {3, 2, 1}), {1, 1, 0}), 1e-15);
    EXPECT_THROW(ejes(miraDesde({0, 5, 0}, {0, 0, 0})), std::invalid_argument);
}

// cerca y lejos recortan por profundidad, no por distancia al ojo.
TEST(Camara, CercaYLejosSonPlanos) {
    const Camara c = perspectiva(miraDesde({0, 0, 4}, {0, 0, 0}), 1.2, 1, 4.01);
    const Escena escena = {plano(escala(100))};
    EXPECT_TRUE(primerImpacto(escena, rayo(c, 60, 60, 0.5, 0.5)));
    EXPECT_TRUE(primerImpacto({plano(Mat4{})},
                              rayo(Camara{}, 60, 60, 30, 30))); // la cámara de los programas 2D: z de −1 a 1
    EXPECT_FALSE(primerImpacto({plano(traslada({0, 0, 1.1}))}, rayo(Camara{}, 60, 60, 30, 30)));
    const Camara corta = perspectiva(c, 1.2, 1, 3.99), pegada = perspectiva(c, 1.2, 4.01, 9);
    EXPECT_FALSE(primerImpacto(escena, rayo(corta, 60, 60, 30, 30)));
    EXPECT_FALSE(primerImpacto(escena, rayo(pegada, 60, 60, 0.5, 0.5)));
}

// --- Luz ---------------------------------------------------------------------------------------------------

// Una esfera entre una luz y un plano: la sombra es un disco de radio h·tan(asen(r/distancia)).
TEST(Luz, SombraDeUnaEsfera) {
    const Escena tapan = {esfera(traslada({0, 0, 3}))};
    Luz luz;
    luz.posicion = {0, 0, 10};
    const double radio = 10 * std::tan(std::asin(1.0 / 7));
    for (int k = 0; k < 16; ++k) {
        const Vec3 u{std::cos(k * PI / 8), std::sin(k * PI / 8), 0};
        EXPECT_TRUE(enSombra(tapan, (radio - 1e-9) * u, luz));
        EXPECT_FALSE(enSombra(tapan, (radio + 1e-9) * u, luz));
    }
    luz.posicion = {0, 0, 1.5}; // la esfera está detrás de la luz: no da sombra
    EXPECT_FALSE(enSombra(tapan, {0, 0, 0}, luz));
    luz.w = 0; // direccional
    EXPECT_TRUE(enSombra(tapan, {0.999999, 0, -50}, luz));
    EXPECT_FALSE(enSombra(tapan, {1.000001, 0, -50}, luz));
}

// Ningún punto de un sólido convexo se da sombra a sí mismo por redondeo, y todos los del otro lado sí.
TEST(Luz, SombraPropia) {
    Luz luz;
    luz.posicion = {3, 8, 5};
    for (const Caso &caso : CASOS) {
        if (caso.objeto.forma == Objeto::TORO)
            continue;
        for (int n = 0; n < 2000; ++n) {
            const Impacto i = primerImpacto({caso.objeto}, rayoAlAzar(TORCIDA, caso.talla));
            const double NL = escalar(i.normal, haciaLuz(luz, i.punto));
            if (i && std::fabs(NL) > 1e-3) {
                ASSERT_EQ(enSombra({caso.objeto}, i.punto, luz), NL < 0) << caso.nombre << " N·L " << NL;
            }
        }
    }
}

// Lo que se ve en un espejo plano es la escena reflejada, a la distancia del camino entero.
TEST(Luz, ReboteEnUnEspejo) {
    const Mat4 M = traslada({0.4, 0.2, 1.5}) * gira({1, 1, 0}, 0.7) * escala({1, 0.5, 0.8});
    const Escena espejo = {plano(escala(20))}, objeto = {caja(M)}, reflejado = {caja(escala({1, 1, -1}) * M)};
    int vistos = 0;
    for (int n = 0; n < 500; ++n) {
        const Vec3 ojo{3, -2, 4}, hacia{alAzar(-1, 2), alAzar(-1, 1), -1.5};
        const Rayo r{ojo, unitario(hacia - ojo), 0, INFINITO};
        const Impacto enEspejo = primerImpacto(espejo, r), directo = primerImpacto(reflejado, r);
        const Impacto i = primerImpacto(objeto, rebote(enEspejo));
        ASSERT_EQ(static_cast<bool>(i), static_cast<bool>(directo));
        if (!i)
            continue;
        ++vistos;
        EXPECT_NEAR(enEspejo.distancia + i.distancia, directo.distancia, 1e-13);
        EXPECT_LT(distanciaEntre(i.normal, {directo.normal.x, directo.normal.y, -directo.normal.z}), 1e-14);
    }
    EXPECT_GT(vistos, 50);
}

TEST(Luz, PhongEnValoresConocidos) {
    const Material m{{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}, {0.2, 0.1, 0.05}, 3};
    Luz luz;
    luz.posicion = {0, 0, 2};
    const Vec3 N{0, 0, 1}, La{1, 1, 1};
    EXPECT_LT(distanciaEntre(phong(m, La, {luz}, {}, N, N), {0.7, 0.8, 0.95}), 1e-15); // N = L = V = R
    EXPECT_LT(distanciaEntre(phong(m, La, {luz, luz}, {}, N, N), {1.3, 1.4, 1.6}),
              1e-15);                                                                // 5.7: ambiente, una vez
    EXPECT_LT(distanciaEntre(phong(m, La, {luz}, {}, -N, N), m.ka), 1e-15);          // de espaldas
    EXPECT_LT(distanciaEntre(phong(m, La, {luz}, luz.posicion, N, N), m.ka), 1e-15); // en la propia luz
    // R = (1,0,1)/√2 con L = (−1,0,1)/√2: V a 45° de R, cos³45° = 0.3535…
    luz.posicion = {-1, 0, 1};
    luz.w = 0;
    const double c = std::sqrt(0.5);
    EXPECT_LT(distanciaEntre(difusaYEspecular(m, luz, {7, 8, 9}, N, N), c * m.kd + c * c * c * m.ks), 1e-15);
    EXPECT_LT(distanciaEntre(difusaYEspecular(m, luz, {}, N, {c, 0, c}), c * m.kd + m.ks), 1e-15);
    EXPECT_LT(distanciaEntre(difusaYEspecular(m, luz, {}, N, {-1, 0, 0}), c * m.kd), 1e-15); // R·V < 0
    const Material sinBrillo{m.ka, m.kd, m.ks, 0};
    EXPECT_LT(distanciaEntre(difusaYEspecular(sinBrillo, luz, {}, N, {0, 1, 0}), c * m.kd + m.ks),
              1e-15); // 0⁰
}

TEST(Luz, AtenuacionYFoco) {
    Luz luz;
    luz.a = 1, luz.b = 0.5, luz.c = 0.25;
    EXPECT_DOUBLE_EQ(atenuacion(luz, {0, 0, -2}), 1.0 / 3);
    luz.a = 0;
    const Material m{{}, {1, 1, 1}, {1, 1, 1}, 10};
    EXPECT_TRUE(std::isfinite(atenuacion(luz, {})));
    EXPECT_FALSE(std::isnan(difusaYEspecular(m, luz, {}, {0, 0, 1}, {0, 0, 1}).x));
    luz = {};
    luz.foco = true;
    const auto en = [&](double angulo) {
        return atenuacion(luz, {5 * std::sin(angulo), 0, -5 * std::cos(angulo)});
    };
    for (const double delta : {1e-6, 0.3, 1.2, PI / 2}) {
        luz.delta = delta;
        luz.exponente = 4;
        EXPECT_NEAR(en(delta * (1 - 1e-9)), std::pow(std::cos(delta), 4), 1e-8);
        EXPECT_EQ(en(delta + 1e-12), 0);
    }
    luz.delta = 0;
    EXPECT_EQ(en(0), 1); // solo el eje
    EXPECT_EQ(en(1e-12), 0);
}

// La tabla de la especificación de OpenGL (2.1, tabla 3.19) al revés: de cara y (s, t) a dirección.
TEST(Luz, CarasDelCubo) {
    const auto hacia = [](int cara, double s, double t) {
        const double u = 2 * s - 1, v = 2 * t - 1;
        const Vec3 d[6] = {{1, -v, -u}, {-1, -v, u}, {u, 1, v}, {u, -1, -v}, {u, -v, 1}, {-u, -v, -1}};
        return d[cara];
    };
    for (int cara = 0; cara < 6; ++cara)
        for (int n = 0; n < 100; ++n) {
            const double s = alAzar(0, 1), t = alAzar(0, 1);
            const CaraCubo c = caraDelCubo(alAzar(1e-3, 1e3) * hacia(cara, s, t));
            ASSERT_EQ(c.cara, cara);
            EXPECT_NEAR(c.s, s, 1e-15);
            EXPECT_NEAR(c.t, t, 1e-15);
        }
}

// --- Cobertura ---------------------------------------------------------------------------------------------

TEST(Cobertura, AreasConocidas) {
    const Poligono mitad = {{3, 5}, {4, 5}, {3, 6}}, cuarto = {{0, 0}, {1, 0}, {0, 0.5}};
    EXPECT_DOUBLE_EQ(coberturaPixel(mitad, 3, 5), 0.5);
    EXPECT_DOUBLE_EQ(coberturaPixel({mitad[2], mitad[1], mitad[0]}, 3, 5), 0.5); // horario
    EXPECT_DOUBLE_EQ(coberturaPixel(mitad, 4, 5), 0);
    EXPECT_DOUBLE_EQ(coberturaPixel(cuarto, 0, 0), 0.25);
    const Poligono grande = {{-50, -50}, {90, -50}, {-50, 90}};
    EXPECT_DOUBLE_EQ(coberturaPixel(grande, 3, 5), 1);
    EXPECT_DOUBLE_EQ(coberturaPixel({{0.5, -9}, {9, -9}, {9, 9}, {0.5, 9}}, 0, 0), 0.5);
    // una punta de flecha, cóncava: (0,0) (1,0.5) (0,1) menos el triángulo con (0.5,0.5)
    EXPECT_DOUBLE_EQ(coberturaPixel({{0, 0}, {1, 0.5}, {0, 1}, {0.5, 0.5}}, 0, 0), 0.25);
    // la suma de todos los píxeles es el área
    const Poligono p = {{1.2, 3.7}, {17.9, 0.4}, {11.3, 15.8}};
    double suma = 0;
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 20; ++x)
            suma += coberturaPixel(p, x, y);
    EXPECT_NEAR(suma, area(p), 1e-12);
    EXPECT_NEAR(area(p), 0.5 * ((17.9 - 1.2) * (15.8 - 3.7) - (0.4 - 3.7) * (11.3 - 1.2)), 1e-13);
}

TEST(Cobertura, DistanciaDentro) {
    const Poligono t = {{0, 0}, {4, 0}, {0, 3}}, alReves = {t[2], t[1], t[0]};
    EXPECT_DOUBLE_EQ(distanciaDentro(t, 1, 1), 1); // el incentro
    EXPECT_DOUBLE_EQ(distanciaDentro(alReves, 1, 1), 1);
    EXPECT_DOUBLE_EQ(distanciaDentro(t, 2, -0.25), -0.25);
    EXPECT_DOUBLE_EQ(distanciaDentro(t, 4, 3), -2.4); // a la hipotenusa
    EXPECT_DOUBLE_EQ(distanciaDentro(t, 2, 1.5), 0);
}

// --- Comparación -------------------------------------------------------------------------------------------

namespace {

Escena esferaYSuelo(const Vec3 &centro) {
    return {esfera(traslada(centro)), plano(traslada({0, -1, 0}) * gira({1, 0, 0}, -PI / 2) * escala(8))};
}
const Camara CAMARA = perspectiva(orbita(0.3, 0.4, 8), 0.6, 1, 50);
const Vec3 FONDO{0.95, 0.96, 0.98};
const auto sombrea = [](const Impacto &i) {
    const double difusa = 0.2 + 0.7 * std::max(0.0, escalar(i.normal, unitario({1, 2, 1})));
    return !i ? FONDO : difusa * (i.objeto == 0 ? Vec3{1, 0.3, 0.2} : Vec3{0.4, 0.6, 1});
};

} // namespace

TEST(Comparar, UnaImagenConsigoMisma) {
    const Escena escena = esferaYSuelo({});
    const ImagenRef ref = render(escena, CAMARA, 80, 60, sombrea);
    for (const Comparacion &c :
         {compara(enBytes(ref), ref), compara(enBytes(ref), escena, CAMARA, sombrea)}) {
        EXPECT_LE(c.maximo, 0.5 + 1e-12) << c;
        EXPECT_EQ(c.bandaDistintos, 0) << c;
        EXPECT_EQ(c.desvio, 0) << c;
        EXPECT_EQ(c.interior + c.banda, 80 * 60);
        EXPECT_GT(c.banda, 100) << c;
        EXPECT_GT(c.interior, 3000) << c;
    }
    const Comparacion silueta = comparaSilueta(enBytes(ref), FONDO, escena, CAMARA);
    EXPECT_EQ(silueta.maximo, 0) << silueta;
    EXPECT_EQ(silueta.bandaDistintos, 0) << silueta;
}

// Cada estropicio se nota: un píxel interior cambiado, la esfera movida, el color casi igual, otra talla.
TEST(Comparar, CadaErrorSeNota) {
    const Escena escena = esferaYSuelo({});
    const ImagenRef ref = render(escena, CAMARA, 80, 60, sombrea);
    Imagen mala = enBytes(ref);
    mala.rgb[3 * (30 * 80 + 40)] ^= 16;
    Comparacion c = compara(mala, ref);
    EXPECT_GT(c.maximo, 15) << c;
    EXPECT_TRUE(c.xMaximo == 40 && c.yMaximo == 30) << c;

    // La esfera movida: el desvío mide cuánto, salvo la proyección (de 8/7 a 7/8 según la parte) y el paso de √2
    // entre radios.
    const double pixel = 2 * 8 * std::tan(0.3) / 240; // a la distancia del centro
    for (const double pixeles : {0.2, 0.6, 4.0}) {
        const Vec3 centro = pixeles * pixel * Vec3{std::cos(0.3), 0, -std::sin(0.3)};
        const Imagen movida = enBytes(render(esferaYSuelo(centro), CAMARA, 320, 240, sombrea));
        c = compara(movida, escena, CAMARA, sombrea, 12);
        if (pixeles > 1) {
            EXPECT_GT(c.bandaLejos, 100) << c;
        } else {
            EXPECT_GT(c.desvio, 0.7 * pixeles) << c;
            EXPECT_LT(c.desvio, 1.7 * pixeles) << c;
        }
    }

    mala = enBytes(ref);
    for (unsigned char &b : mala.rgb)
        b = static_cast<unsigned char>(std::min(b + 2, 255));
    EXPECT_GT(compara(mala, ref).maximo, 1.5);
    EXPECT_THROW(compara(recorta(mala, 0, 0, 40, 60), ref), std::invalid_argument);
    EXPECT_THROW(render({}, Camara{}, 4, 4,
                        [](const Impacto &) {
                            return Vec3{0, NAN, 0};
                        }),
                 std::domain_error);
}

// Un toro que se tapa a sí mismo tiene banda dentro de su silueta; un cubo, en sus aristas.
TEST(Comparar, LaBandaVeLosBordesDeUnMismoObjeto) {
    const Camara c = perspectiva(orbita(0.6, 0.5, 6), 0.6, 1, 50);
    const auto bordesDentro = [&](const Objeto &o) {
        const ImagenRef ref = render({o}, c, 120, 120, [](const Impacto &i) {
            return i ? Vec3{1, 1, 1} : Vec3{};
        });
        int n = 0;
        for (int y = 0; y < 120; ++y)
            for (int x = 1; x < 120; ++x)
                n += ref.en(x, y).objeto == 0 && ref.en(x - 1, y).objeto == 0 &&
                     hayBorde(ref.en(x, y), ref.en(x - 1, y));
        return n;
    };
    EXPECT_GT(bordesDentro(toro(gira({0, 1, 0}, 1.8), 1, 0.4)), 20);
    EXPECT_GT(bordesDentro(caja(escala(1.5))), 40);
    EXPECT_GT(bordesDentro(malla(escala(1.5), cubo())), 40);
    EXPECT_LT(bordesDentro(esfera(Mat4{})), 20); // solo junto a la silueta
    PixelRef uno, otro;                          // dos caras en el mismo plano
    uno.objeto = otro.objeto = 0;
    EXPECT_FALSE(hayBorde(uno, otro));
    otro.cara = 1;
    EXPECT_TRUE(hayBorde(uno, otro));
    otro.cara = 0, otro.zona = 1;
    EXPECT_TRUE(hayBorde(uno, otro));
}
