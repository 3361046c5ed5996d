// El oráculo contra fórmulas cerradas y ecuaciones implícitas escritas aquí.
#include "azar.h"
#include "contra_oraculo.h"
#include <algorithm>
#include <gtest/gtest.h>

using namespace oraculo;

namespace {

/// Transformación sin nada especial: escala distinta en cada eje, refleja, gira y traslada.
const Mat4 TORCIDA = traslada({0.3, -1.2, 0.7}) * gira({1, 2, -0.5}, 0.8) * escala({1.3, -0.6, 0.9});

Azar azar(12345);

/// Rayo desde lejos hacia las cercanías del centro de M.
Rayo rayoAlAzar(const Mat4 &M, double talla) {
    const Vec3 origen = punto(M, 5 * talla * unitario(exacto(azar.punto(1))));
    return {origen, unitario(punto(M, exacto(azar.punto(talla))) - origen), 0, INFINITO};
}

void esperaCerca(const Vec3 &a, const Vec3 &b, double tolerancia) {
    EXPECT_LE(longitud(a - b), tolerancia) << "(" << a.x << ", " << a.y << ", " << a.z << ") y debía (" << b.x
                                           << ", " << b.y << ", " << b.z << ")";
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
    esperaCerca(direccion(gira({0, 0, 5}, PI / 2), {1, 0, 0}), {0, 1, 0}, 1e-15);
    esperaCerca(direccion(gira({0, 1, 0}, PI / 2), {1, 0, 0}), {0, 0, -1}, 1e-15);
    esperaCerca(direccion(gira({1, 1, 1}, 2 * PI / 3), {1, 2, 3}), {3, 1, 2}, 2e-15);
    EXPECT_THROW(inversa(escala({1, 0, 1})), std::invalid_argument);
}

// --- Cortes ------------------------------------------------------------------------------------------------

// Lo que un rayo al azar no da, y las coordenadas de textura de common/malla.h. Salvo el último redondeo.
TEST(Cortes, DistanciasYCoordenadasExactas) {
    const Mat4 I;
    const Objeto tres = triangulo({0, 0, 0}, {2, 0, 0}, {0, 2, 0});
    const struct {
        Objeto objeto;
        Vec3 origen, hacia;
        double distancia, s = NAN, t = NAN; // si no se dan, no se miran
    } casos[] = {
        {esfera(I), {1e6, 0.6, 0}, {-1, 0, 0}, 1e6 - 0.8}, // desde muy lejos
        {esfera(I), {0, 5, 0.6}, {0, -1, 0}, 4.2, 0.25, std::atan2(0.8, -0.6) / PI},
        {caja(I), {0.2, 0.3, 5}, {0, 0, -1}, 4.5, 0.7, 0.8}, // paralelo a cuatro caras
        {caja(I), {0.2, -5, 0.3}, {0, 1, 0}, 4.5, 0.8, 0.3},
        {caja(I), {2, 2, 2}, {-1, -1, -1}, 1.5 * std::sqrt(3)},  // por la esquina
        {cilindro(I), {0.6, 0.2, 5}, {0, 0, -1}, 4.5, 0.8, 0.6}, // paralelo al eje
        {cilindro(I), {0, 5, 0.25}, {0, -1, 0}, 4, 0.25, 0.75},
        {cono(I), {5, 0, 0}, {-1, 0, 0.1}, 4 / 0.9 * std::hypot(1, 0.1)}, // por el borde de la tapa
        {cono(I), {0.2, 0.1, -3}, {0, 0, 1}, 3, 0.6, 0.55},
        {cono(I), {0, 5, 0.25}, {0, -1, 0}, 4.25, 0.25, 0.25},
        {toro(I, 1, 0.25), {0, 0, 0}, {0, 1, 0}, 0.75}, // desde el agujero
        {toro(I, 1, 0.25), {0, 1, 5}, {0, 0, -1}, 4.75, 0.25, 0.25},
        {toro(I, 1, 0.25), {0.1, 0, 5}, {0, 0, -1}, INFINITO},
        {plano(escala(4)), {1, 1.5, 3}, {0, 0, -1}, 3, 0.75, 0.875},
        {tres, {0.5, 0.5, 7}, {0, 0, -1}, 7},
        {tres, {1.1, 1, 7}, {0, 0, -1}, INFINITO},
    };
    for (const auto &c : casos) {
        const Impacto i = primerImpacto({c.objeto}, {c.origen, unitario(c.hacia), 0, INFINITO});
        ASSERT_EQ(bool(i), std::isfinite(c.distancia)) << c.distancia;
        EXPECT_TRUE(!i || std::fabs(i.distancia / c.distancia - 1) < 2.3e-16) << i.distancia;
        EXPECT_TRUE(std::isnan(c.s) || std::max(std::fabs(i.s - c.s), std::fabs(i.t - c.t)) < 1e-15)
            << c.distancia << ": " << i.s << ", " << i.t;
    }
}

// El punto está en la superficie y es el primero (nada hay dentro antes, muestreando el rayo), y la normal es el gradiente de la
// ecuación implícita. Sin corte, el rayo entero está fuera. Desde dentro se ve la otra cara, y la normal sigue hacia fuera.
TEST(Cortes, EcuacionesImplicitasYGradientes) {
    const Mat4 inv = inversa(TORCIDA);
    for (const Caso &caso : CASOS) {
        const auto F = [&](const Vec3 &p) { return caso.F(punto(inv, p)); };
        int cortes = 0, salidas = 0;
        double peorF = 0, peorNormal = 0;
        const auto comprueba = [&](const Impacto &i) {
            EXPECT_NEAR(longitud(i.normal), 1, 1e-15);
            esperaCerca(i.punto, i.rayo.origen + i.distancia * i.rayo.direccion, 1e-14);
            peorF = std::max(peorF, std::fabs(F(i.punto)));
            const double h = 1e-6;
            const Vec3 gradiente = {F(i.punto + Vec3{h, 0, 0}) - F(i.punto - Vec3{h, 0, 0}),
                                    F(i.punto + Vec3{0, h, 0}) - F(i.punto - Vec3{0, h, 0}),
                                    F(i.punto + Vec3{0, 0, h}) - F(i.punto - Vec3{0, 0, h})};
            peorNormal = std::max(peorNormal, longitud(unitario(gradiente) - i.normal));
        };
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
            comprueba(i);
            const Vec3 dentro = i.punto + 1e-3 * r.direccion;
            if (F(dentro) > -1e-4)
                continue; // pasa rozando
            ++salidas;
            const Impacto otra = primerImpacto({caso.objeto}, {dentro, r.direccion, 0, INFINITO});
            ASSERT_TRUE(otra) << caso.nombre;
            EXPECT_FALSE(otra.frente) << caso.nombre;
            EXPECT_GT(escalar(otra.normal, r.direccion), 0) << caso.nombre;
            comprueba(otra);
        }
        EXPECT_GT(cortes, 500) << caso.nombre;
        EXPECT_GT(salidas, 500) << caso.nombre;
        EXPECT_LT(peorF, 1e-13) << caso.nombre;
        EXPECT_LT(peorNormal, 1e-8) << caso.nombre;
    }
}

// --- Cámara ------------------------------------------------------------------------------------------------

TEST(Camara, IdaYVuelta) {
    const Camara base = orbita(0.7, -0.4, 12, {1, 2, 3});
    for (const Camara &c : {perspectiva(base, 0.9, 0.5, 80), paralela(base, 3, 1, 30)})
        for (const auto &[ancho, alto] : {std::pair(240, 180), {180, 240}, {1, 1}, {333, 7}})
            for (int n = 0; n < 50; ++n) {
                const double px = azar.entre(0.0, double(ancho)), py = azar.entre(0.0, double(alto));
                const Rayo r = rayo(c, ancho, alto, px, py);
                const auto enVentana = [&](double t) {
                    return proyecta(c, ancho, alto, r.origen + t * r.direccion);
                };
                EXPECT_NEAR(longitud(r.direccion), 1, 1e-15);
                const Vec3 v = enVentana(azar.entre(r.minimo, r.maximo));
                EXPECT_NEAR(v.x, px, 1e-11);
                EXPECT_NEAR(v.y, py, 1e-11);
                EXPECT_NEAR(enVentana(r.minimo).z, 0, 1e-13);
                EXPECT_NEAR(enVentana(r.maximo).z, 1, 1e-13);
                const auto seVe = [&](double t) { // lo que hay a esa distancia
                    return bool(primerImpacto({plano(traslada(r.origen + t * r.direccion))}, r));
                };
                EXPECT_TRUE(seVe(r.minimo + 1e-6) && seVe(r.maximo - 1e-6));
                EXPECT_FALSE(seVe(r.minimo - 1e-6) || seVe(r.maximo + 1e-6));
            }
}

// El ángulo y el semilado abarcan el alto de la ventana, o el que tendría a 4:3 si es más estrecha, sin deformar. Ecuaciones 4.2 y 4.3:
// profundidad 1/2 a 2·cerca·lejos/(cerca + lejos), y a medio camino.
TEST(Camara, AltoUtil) {
    const Camara base = miraDesde({0, 0, 4}, {0, 0, 0}), P = perspectiva(base, 0.6, 1, 9),
                 O = paralela(base, 2, 1, 9);
    const double t = 4 * std::tan(0.3);
    const struct {
        Camara camara;
        int ancho, alto;
        Vec3 punto, enVentana;
    } casos[] = {
        {P, 240, 180, {0, t, 0}, {120, 180, 0.84375}},   {P, 240, 180, {t, 0, 0}, {210, 90, 0.84375}},
        {P, 100, 300, {t, 0, 0}, {87.5, 150, 0.84375}},  {O, 240, 180, {-2, -2, 0}, {30, 0, 0.375}},
        {O, 100, 300, {-2, 2, 0}, {12.5, 187.5, 0.375}}, {P, 9, 9, {0, 0, 4 - 1.8}, {4.5, 4.5, 0.5}},
        {O, 9, 9, {0, 0, 4 - 5}, {4.5, 4.5, 0.5}}};
    for (const auto &c : casos) {
        const Vec3 v = proyecta(c.camara, c.ancho, c.alto, c.punto);
        esperaCerca(v, c.enVentana, 1e-12);
        EXPECT_NEAR(v.z, c.enVentana.z, 1e-15);
    }
}

TEST(Camara, Orbita) {
    const Vec3 haciaElOjo{std::cos(0.25) * std::sin(0.5), std::sin(0.25), std::cos(0.25) * std::cos(0.5)};
    esperaCerca(orbita(0.5, 0.25, 23, {1.5, 5.2, 0}).ojo, Vec3{1.5, 5.2, 0} + 23 * haciaElOjo, 1e-14);
    const Camara c = miraDesde({3, 1, 2}, {0, 1, 2});
    esperaCerca(enCamara(c, {0, 1, 2}), {0, 0, -3}, 1e-15);
    esperaCerca(enCamara(c, {3, 2, 1}), {1, 1, 0}, 1e-15);
    EXPECT_THROW(ejes(miraDesde({0, 5, 0}, {0, 0, 0})), std::invalid_argument);
}

// --- Luz ---------------------------------------------------------------------------------------------------

// Una esfera entre una luz y un plano: la sombra es un disco de radio h·tan(asen(r/distancia)).
TEST(Luz, SombraDeUnaEsfera) {
    const Escena tapan = {esfera(traslada({0, 0, 3}))};
    Luz luz = posicional({0, 0, 10});
    const double radio = 10 * std::tan(std::asin(1.0 / 7));
    for (int k = 0; k < 16; ++k) {
        const Vec3 u{std::cos(k * PI / 8), std::sin(k * PI / 8), 0};
        EXPECT_TRUE(enSombra(tapan, (radio - 1e-9) * u, luz));
        EXPECT_FALSE(enSombra(tapan, (radio + 1e-9) * u, luz));
    }
    EXPECT_FALSE(enSombra(tapan, {}, posicional({0, 0, 1.5}))); // la esfera está detrás de la luz
    EXPECT_TRUE(enSombra(tapan, {0.999999, 0, -50}, direccional({0, 0, 1.5})));
    EXPECT_FALSE(enSombra(tapan, {1.000001, 0, -50}, direccional({0, 0, 1.5})));
}

// Sale de donde llega, al otro lado de la perpendicular, y no vuelve a cortar el mismo espejo.
TEST(Luz, ReboteEnUnEspejo) {
    const Mat4 M = traslada({0.4, 0.2, 1.5}) * gira({1, 1, 0}, 0.7) * escala(20);
    const Vec3 N = unitario(direccion(M, {0, 0, 1})), X = unitario(direccion(M, {1, 0, 0}));
    for (double alto = 0.1; alto < 10; alto += 0.1) {
        const Impacto i =
            primerImpacto({plano(M)}, {punto(M, {}) + alto * N, 0.6 * X - 0.8 * N, 0, INFINITO});
        const Rayo r = rebote(i);
        esperaCerca(r.origen, i.punto, 0);
        esperaCerca(r.direccion, 0.6 * X + 0.8 * N, 1e-15);
        EXPECT_FALSE(primerImpacto({plano(M)}, r));
    }
}

TEST(Luz, PhongEnValoresConocidos) {
    const Material m{{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}, {0.2, 0.1, 0.05}, 3}, sinBrillo{m.ka, m.kd, m.ks, 0};
    const Luz luz = posicional({0, 0, 2});
    const Vec3 N{0, 0, 1}, La{1, 1, 1};
    esperaCerca(phong(m, La, {luz}, {}, N, N), {0.7, 0.8, 0.95}, 1e-15);     // N = L = V = R
    esperaCerca(phong(m, La, {luz, luz}, {}, N, N), {1.3, 1.4, 1.6}, 1e-15); // 5.7: ambiente, una vez
    esperaCerca(phong(m, La, {luz}, {}, -N, N), m.ka, 1e-15);                // de espaldas
    esperaCerca(phong(m, La, {luz}, luz.posicion, N, N), m.ka, 1e-15);       // en la propia luz
    // R = (1,0,1)/√2 con L = (−1,0,1)/√2: V a 45° de R, cos³45° = 0.3535…
    const Luz deLado = direccional({-1, 0, 1});
    const double c = std::sqrt(0.5);
    esperaCerca(difusaYEspecular(m, deLado, {7, 8, 9}, N, N), c * m.kd + c * c * c * m.ks, 1e-15);
    esperaCerca(difusaYEspecular(m, deLado, {}, N, {c, 0, c}), c * m.kd + m.ks, 1e-15);
    esperaCerca(difusaYEspecular(m, deLado, {}, N, {-1, 0, 0}), c * m.kd, 1e-15);               // R·V < 0
    esperaCerca(difusaYEspecular(sinBrillo, deLado, {}, N, {0, 1, 0}), c * m.kd + m.ks, 1e-15); // 0⁰
}

TEST(Luz, AtenuacionYFoco) {
    Luz luz;
    luz.b = 0.5;
    luz.c = 0.25;
    EXPECT_DOUBLE_EQ(atenuacion(luz, {0, 0, -2}), 1.0 / 3);
    luz.a = 0;
    const Material m{{}, {1, 1, 1}, {1, 1, 1}, 10};
    EXPECT_TRUE(std::isfinite(atenuacion(luz, {})));
    EXPECT_FALSE(std::isnan(difusaYEspecular(m, luz, {}, {0, 0, 1}, {0, 0, 1}).x));
    const auto en = [](double delta, double angulo) {
        return atenuacion(foco({}, {0, 0, -1}, delta, 4), {5 * std::sin(angulo), 0, -5 * std::cos(angulo)});
    };
    for (const double delta : {1e-6, 0.3, 1.2, PI / 2}) {
        EXPECT_NEAR(en(delta, delta * (1 - 1e-9)), std::pow(std::cos(delta), 4), 1e-8);
        EXPECT_EQ(en(delta, delta + 1e-12), 0);
    }
    EXPECT_EQ(en(0, 0), 1); // solo el eje
    EXPECT_EQ(en(0, 1e-12), 0);
}

// La tabla de la especificación de OpenGL (2.1, tabla 3.19) al revés: de cara y (s, t) a dirección.
TEST(Luz, CarasDelCubo) {
    for (int n = 0; n < 600; ++n) {
        const int cara = n % 6;
        const double u = azar.entre(-1.0, 1.0), v = azar.entre(-1.0, 1.0);
        const Vec3 hacia[6] = {{1, -v, -u}, {-1, -v, u}, {u, 1, v}, {u, -1, -v}, {u, -v, 1}, {-u, -v, -1}};
        const CaraCubo c = caraDelCubo(azar.entre(1e-3, 1e3) * hacia[cara]);
        ASSERT_EQ(c.cara, cara);
        EXPECT_NEAR(c.s, (u + 1) / 2, 1e-15);
        EXPECT_NEAR(c.t, (v + 1) / 2, 1e-15);
    }
}

// --- Cobertura ---------------------------------------------------------------------------------------------

TEST(Cobertura, AreasConocidas) {
    const struct {
        Poligono poligono;
        int x, y;
        double parte;
    } casos[] = {{{{3, 5}, {4, 5}, {3, 6}}, 3, 5, 0.5},
                 {{{3, 6}, {4, 5}, {3, 5}}, 3, 5, 0.5}, // horario
                 {{{3, 5}, {4, 5}, {3, 6}}, 4, 5, 0},
                 {{{0, 0}, {1, 0}, {0, 0.5}}, 0, 0, 0.25},
                 {{{-50, -50}, {90, -50}, {-50, 90}}, 3, 5, 1},
                 {{{0.5, -9}, {9, -9}, {9, 9}, {0.5, 9}}, 0, 0, 0.5},
                 {{{0, 0}, {1, 0.5}, {0, 1}, {0.5, 0.5}}, 0, 0, 0.25}}; // una punta de flecha, cóncava
    for (const auto &c : casos)
        EXPECT_DOUBLE_EQ(coberturaPixel(c.poligono, c.x, c.y), c.parte);
    // la suma de todos los píxeles es el área
    const Poligono p = {{1.2, 3.7}, {17.9, 0.4}, {11.3, 15.8}};
    double suma = 0;
    for (int i = 0; i < 400; ++i)
        suma += coberturaPixel(p, i % 20, i / 20);
    EXPECT_NEAR(suma, area(p), 1e-12);
    EXPECT_NEAR(area(p), 0.5 * ((17.9 - 1.2) * (15.8 - 3.7) - (0.4 - 3.7) * (11.3 - 1.2)), 1e-13);
}

TEST(Cobertura, DistanciaDentro) {
    const Poligono t = {{0, 0}, {4, 0}, {0, 3}}, alReves = {t[2], t[1], t[0]};
    const Vec3 puntos[] = {
        {1, 1, 1}, {2, -0.25, -0.25}, {4, 3, -2.4}, {2, 1.5, 0}}; // el incentro; a la hipotenusa
    for (const Vec3 &p : puntos)
        for (const Poligono &triangulo : {t, alReves})
            EXPECT_DOUBLE_EQ(distanciaDentro(triangulo, p.x, p.y), p.z);
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
    const Comparacion c = compara(mala, ref);
    EXPECT_GT(c.maximo, 15) << c;
    EXPECT_TRUE(c.xMaximo == 40 && c.yMaximo == 30) << c;

    // La esfera movida: el desvío mide cuánto, salvo la proyección (de 8/7 a 7/8 según la parte) y el paso de √2
    // entre radios.
    const double pixel = 2 * 8 * std::tan(0.3) / 240; // a la distancia del centro
    for (const double pixeles : {0.2, 0.6, 4.0}) {
        const Vec3 centro = pixeles * pixel * Vec3{std::cos(0.3), 0, -std::sin(0.3)};
        const Imagen movida = enBytes(render(esferaYSuelo(centro), CAMARA, 320, 240, sombrea));
        const Comparacion d = compara(movida, escena, CAMARA, sombrea, 12);
        if (pixeles > 1) {
            EXPECT_GT(d.bandaLejos, 100) << d;
        } else {
            EXPECT_GT(d.desvio, 0.7 * pixeles) << d;
            EXPECT_LT(d.desvio, 1.7 * pixeles) << d;
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

// Un toro que se tapa a sí mismo tiene banda dentro de su silueta; un cubo, en sus aristas; una esfera, solo junto a la silueta.
TEST(Comparar, LaBandaVeLosBordesDeUnMismoObjeto) {
    const Camara c = perspectiva(orbita(0.6, 0.5, 6), 0.6, 1, 50);
    const auto bordesDentro = [&](const Objeto &o) {
        const ImagenRef ref = render({o}, c, 120, 120, [](const Impacto &i) {
            return i ? Vec3{1, 1, 1} : Vec3{};
        });
        int n = 0;
        for (int y = 0; y < 120; ++y)
            for (int x = 1; x < 120; ++x) {
                const PixelRef &este = ref.en(x, y), &anterior = ref.en(x - 1, y);
                n += este.objeto == 0 && anterior.objeto == 0 && hayBorde(este, anterior);
            }
        return n;
    };
    EXPECT_GT(bordesDentro(toro(gira({0, 1, 0}, 1.8), 1, 0.4)), 20);
    EXPECT_GT(bordesDentro(caja(escala(1.5))), 40);
    EXPECT_GT(bordesDentro(malla(escala(1.5), cubo())), 40);
    EXPECT_LT(bordesDentro(esfera(Mat4{})), 20);
    EXPECT_LT(bordesDentro(malla(Mat4{}, esfera(64))), 20);
    PixelRef uno, otro; // dos caras en el mismo plano
    uno.objeto = otro.objeto = 0;
    EXPECT_FALSE(hayBorde(uno, otro));
    otro.cara = 1;
    EXPECT_TRUE(hayBorde(uno, otro));
    otro.cara = 0;
    otro.zona = 1;
    EXPECT_TRUE(hayBorde(uno, otro));
}
