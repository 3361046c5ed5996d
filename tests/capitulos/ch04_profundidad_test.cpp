// Comprobaciones independientes de profundidad: cuánta profundidad cabe en un buffer de 24 bits.
#include "ch04_oraculo.h"
#include "ch04_vista3d/profundidad.h"
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>
#include <iostream>

namespace {

using Cuadruple = boost::multiprecision::cpp_bin_float_quad;

const double CERCA[] = {10, 0.1, 0.001}, LEJOS = 1000, PASOS = 16777215; // 2^24 − 1

/// Diferencia de profundidad, en pasos del buffer, entre d y d·(1 + e): z(d) = f/(f − n)·(1 − n/d).
double pasosEntre(double d, double e, double n, double f, double pasos) {
    return pasos * f * n / (f - n) * e / (1 + e) / d;
}

/// Con la fase al azar, dos valores a s < 1 pasos se redondean al mismo con probabilidad 1 − s. Se integra con
/// el logaritmo de d uniforme: s = K/d.
double igualesSegunLaFormula(double n, double f, double e, double pasos) {
    const double K = pasosEntre(1, e, n, f, pasos), desde = std::max(n, K);
    return desde >= f ? 0 : (std::log(f / desde) - K * (1 / desde - 1 / f)) / std::log(f / n);
}

/// El porcentaje que sigue a `texto` en la salida del programa.
double numeroTras(const std::string &salida, const std::string &texto) {
    const std::size_t i = salida.rfind(texto);
    return i == std::string::npos ? -1 : std::stod(salida.substr(i + texto.size()));
}

} // namespace

// En doble los pares son los de la fórmula, salvo el azar de la fase: 5 desviaciones típicas de n = 100 000.
TEST(ParesDeProfundidad, EnDobleContraLaFormula) {
    for (const int bits : {16, 24, 32})
        for (const double cerca : {500.0, 10.0, 0.1, 0.001, 1e-6, 1e-20}) {
            const ParesMal p = cuentaPares<double>(cerca, LEJOS, 1e-5, bits);
            const double q = igualesSegunLaFormula(cerca, LEJOS, 1e-5, std::ldexp(1.0, bits) - 1);
            EXPECT_EQ(p.invertidos, 0);
            EXPECT_NEAR(p.iguales, q, 5 * std::sqrt(q * (1 - q) / 100000) + 1e-9)
                << bits << " bits, " << cerca;
            if (bits == 24)
                std::cout << "lejos/cerca " << LEJOS / cerca << ": " << 100 * p.iguales
                          << " % iguales, fórmula " << 100 * q << " %\n";
        }
}

// La profundidad en float contra cuádruple. Con u = 2^-24: los coeficientes traen 3u, y el producto, la suma y
// la división u cada uno. Como |z/d| ≤ 1 y 2·lejos·cerca/(d·(lejos − cerca)) ≤ 2 para lejos ≥ 100·cerca, el error
// de z/d no pasa de 6u + 10u; la mitad y los dos redondeos finales, 9u: nueve pasos de 24 bits. El par que dista
// más de 19 pasos (dos errores y un paso del redondeo) está siempre en orden.
TEST(ParesDeProfundidad, EnFloatContraCuadruple) {
    for (const double n : CERCA) {
        double peor = 0, masLejanoMal = 0;
        int mal = 0;
        const int cuantos = 20000;
        for (int i = 0; i < cuantos; ++i) {
            const double d = n * std::pow(LEJOS / n, (i + 0.5) / cuantos);
            const float df = static_cast<float>(d), detras = static_cast<float>(d * (1 + 1e-5));
            const float nf = static_cast<float>(n), ff = static_cast<float>(LEJOS);
            const Cuadruple exacta = Cuadruple(ff) / (Cuadruple(ff) - nf) * (1 - Cuadruple(nf) / df);
            const Cuadruple error = (Cuadruple(profundidad(df, nf, ff)) - exacta) * PASOS;
            peor = std::max(peor, std::fabs(static_cast<double>(error)));
            if (enBuffer(profundidad(detras, nf, ff), 24) <= enBuffer(profundidad(df, nf, ff), 24)) {
                ++mal;
                masLejanoMal = std::max(masLejanoMal, pasosEntre(d, 1e-5, n, LEJOS, PASOS));
            }
        }
        std::cout << "cerca " << n << ": error máximo " << peor << " pasos; mal el " << 100.0 * mal / cuantos
                  << " %, el que más a " << masLejanoMal << " pasos\n";
        EXPECT_LE(peor, 9) << n;
        EXPECT_LE(masLejanoMal, 19) << n;
    }
}

TEST(ParesDeProfundidad, LosExtremos) {
    for (const double n : {10.0, 0.1, 0.001, 1e-6}) {
        EXPECT_NEAR(profundidad(n, n, LEJOS), 0, 1e-15); // nueve pasos de 2^-53
        EXPECT_NEAR(profundidad(LEJOS, n, LEJOS), 1, 1e-15);
        EXPECT_NEAR(profundidad(2 * n, n, LEJOS), 0.5,
                    0.51 * n / (LEJOS - n) + 1e-15); // medio buffer: de n a 2n
    }
    EXPECT_EQ(enBuffer(0.0, 24), 0);
    EXPECT_EQ(enBuffer(1.0f, 24), PASOS);
    EXPECT_EQ(enBuffer(1.0, 16), 65535);
    const ParesMal p = cuentaPares<float>(1e-30, LEJOS, 1e-5, 24); // ni NaN ni infinitos
    EXPECT_GT(p.iguales + p.invertidos, 0.5);
    EXPECT_LE(p.iguales + p.invertidos, 1);
}

namespace {

using namespace oraculo;

/// Los carteles y sus cuadros, escritos otra vez.
double distanciaCartel(int i) {
    return 12 * std::pow(800.0 / 12, i / 11.0);
}
Vec3 centroCartel(int i) {
    return {0.27 * (i % 4 - 1.5), 0.26 * (1 - i / 4) + 0.035, -1};
}
void ponCarteles(Escena &carteles, Escena &cuadros, double separacion = 0.05) {
    for (int i = 0; i < 12; ++i) {
        const double d = distanciaCartel(i);
        const Vec3 c = d * centroCartel(i);
        const Mat4 giro = gira({0, 1, 0}, 0.5) * gira({1, 0, 0}, -0.5);
        carteles.push_back(plano(traslada(c) * giro * escala(0.185 * d)));
        cuadros.push_back(plano(traslada(c + Vec3{0, 0, separacion}) * giro * escala(0.8 * 0.185 * d)));
    }
}
Camara camaraCarteles(double cerca) {
    return perspectiva(miraDesde({0, 0, 0}, {0, 0, -1}), 0.8, cerca, LEJOS);
}

} // namespace

// Los carteles de la imagen. Los pares son los píxeles cuyo centro ve, en doble, el cuadro con el cartel
// detrás, a más de un píxel de sus bordes. Con `s` la distancia en pasos de 24 bits:
// - la GPU redondea ocho veces por superficie: el producto, la suma, el inverso y la división en el vértice, el
//   paso al área de dibujo, dos sumas al interpolar y los 24 bits. Ninguna vez en más de medio paso, con
//   varianza 1/12 como mucho; la del par, 2·8/12. A cuatro desviaciones típicas, 4.6 pasos, el par está bien;
// - a menos de un paso el modelo ideal deja iguales 1 − s; con errores de la GPU simétricos, el cuadro sigue
//   delante como mucho la mitad de las veces que serían iguales.
static void comprueba(int razon) {
    const double cerca = CERCA[razon];
    const int ancho = 480, alto = 360;
    const Ejecucion e =
        ejecuta("ch04_vista3d/profundidad", "tecla " + std::to_string(razon + 1), ancho, alto);
    ASSERT_EQ(e.estado, 0) << e.errores;

    Escena carteles, cuadros;
    ponCarteles(carteles, cuadros);
    const Camara camara = camaraCarteles(cerca);
    const ImagenRef ref = render(cuadros, camara, ancho, alto, [](const Impacto &) { return Vec3{}; });
    int pares = 0, mal = 0, iguales = 0, amarillos = 0;
    double masLejanoMal = 0;
    for (int y = 0; y < alto; ++y)
        for (int x = 0; x < ancho; ++x) {
            const Pixel p = pixel(e.imagen, x, y);
            amarillos += p.r > 200 && p.b < 100;
            bool dentro = x > 0 && y > 0 && x + 1 < ancho && y + 1 < alto;
            for (int k = 0; dentro && k < 9; ++k)
                dentro = ref.en(x - 1 + k % 3, y - 1 + k / 3).objeto >= 0;
            if (!dentro)
                continue;
            const Impacto detras = primerImpacto(carteles, rayo(camara, ancho, alto, x + 0.5, y + 0.5));
            ASSERT_TRUE(detras);
            const double zCuadro = PASOS * proyecta(camara, ancho, alto, ref.en(x, y).punto).z,
                         zCartel = PASOS * proyecta(camara, ancho, alto, detras.punto).z;
            const bool azul = p.b > 150;
            ++pares;
            mal += azul;
            iguales += std::round(zCuadro) >= std::round(zCartel);
            if (azul)
                masLejanoMal = std::max(masLejanoMal, zCartel - zCuadro);
        }
    const double ideal = static_cast<double>(iguales) / pares, medido = static_cast<double>(mal) / pares;
    std::cout << "cerca " << cerca << ": mal el " << 100 * medido << " % de " << pares
              << " pares (modelo en doble " << 100 * ideal << " %), el que más a " << masLejanoMal
              << " pasos\n";
    EXPECT_GT(pares, 30000);
    EXPECT_LE(masLejanoMal, 4.6);
    EXPECT_GE(medido, ideal / 2);
    EXPECT_EQ(medido > 0, razon > 0);

    // lo que escribe el programa es lo que hay en su imagen, y sus pares, los de la fórmula
    const double enCuadros = numeroTras(e.salida, " % de ");
    EXPECT_NEAR(numeroTras(e.salida, "carteles: "), 100 * (1 - amarillos / enCuadros), 0.051) << e.salida;
    EXPECT_NEAR(numeroTras(e.salida, "1e-5): "), 100 * igualesSegunLaFormula(cerca, LEJOS, 1e-5, PASOS), 0.8);
    EXPECT_NE(e.salida.find(" m, 24 bits\n"), std::string::npos) << e.salida;
}

TEST(Profundidad, Razon1e2TodoEnOrden) {
    comprueba(0);
}
TEST(Profundidad, Razon1e4) {
    comprueba(1);
}
TEST(Profundidad, Razon1e6) {
    comprueba(2);
}

// El cuadro está 5 cm por delante: en el cartel de 12 m, visto de frente, eso lo agranda y lo aparta del centro de la imagen.
// El centro de sus píxeles, a 960×720, se mueve 1.3 píxeles; se mide a 0.1, que son 4 mm.
TEST(Profundidad, LaSeparacionEsDe5Centimetros) {
    const int ancho = 960, alto = 720;
    const Ejecucion e = ejecuta("ch04_vista3d/profundidad", "", ancho, alto);
    ASSERT_EQ(e.estado, 0) << e.errores;
    Escena carteles, cuadros;
    ponCarteles(carteles, cuadros);
    const Escena primero = {cuadros[0]};
    double x = 0, y = 0, rx = 0, ry = 0;
    int n = 0, rn = 0;
    for (int py = 3 * alto / 4 - 30; py < alto; ++py) // el primero
        for (int px = 0; px < ancho / 4; ++px) {
            if (esColor(pixel(e.imagen, px, py), AMARILLO))
                x += px, y += py, ++n;
            if (primerImpacto(primero, rayo(camaraCarteles(10), ancho, alto, px + 0.5, py + 0.5)))
                rx += px, ry += py, ++rn;
        }
    ASSERT_GT(n, 5000);
    EXPECT_NEAR(n, rn, 60);
    EXPECT_NEAR(x / n, rx / rn, 0.1);
    EXPECT_NEAR(y / n, ry / rn, 0.1);
}

// Al orbitar, los carteles se ven desde donde ha ido la cámara: en el centro de cada cuadro sigue el amarillo.
TEST(Profundidad, LosCartelesAlOrbitar) {
    const int ancho = 960, alto = 720;
    const Ejecucion e = ejecuta(
        "ch04_vista3d/profundidad",
        "boton IZQUIERDO abajo 480 360; arrastra 500 350; boton IZQUIERDO arriba 500 350", ancho, alto);
    ASSERT_EQ(e.estado, 0) << e.errores;
    const double azimut = -1.8 * 20 / alto, elevacion = -1.8 * 10 / alto;
    const Vec3 interes{0, 0, -300},
        ojo = interes + 300 * Vec3{std::cos(elevacion) * std::sin(azimut), std::sin(elevacion),
                                   std::cos(elevacion) * std::cos(azimut)};
    const Camara camara = perspectiva(miraDesde(ojo, interes), 0.8, 10, LEJOS);
    for (int i = 6; i < 12; ++i) {
        const Vec3 p = proyecta(camara, ancho, alto, distanciaCartel(i) * centroCartel(i) + Vec3{0, 0, 0.05});
        EXPECT_TRUE(esColor(e.imagen, static_cast<int>(p.x), static_cast<int>(p.y), AMARILLO)) << i;
    }
}

// Bajo cada cartel, su distancia.
TEST(Profundidad, LasDistanciasBajoCadaCartel) {
    const Ejecucion e = ejecuta("ch04_vista3d/profundidad", "", 960, 720);
    const char32_t *const rotulos[] = {U"12 m",  U"18 m",  U"26 m",  U"38 m",  U"55 m",  U"81 m",
                                       U"119 m", U"174 m", U"254 m", U"373 m", U"546 m", U"800 m"};
    for (int i = 0; i < 12; ++i) {
        const Vec3 p = proyecta(camaraCarteles(10), 960, 720, centroCartel(i) - Vec3{0, 0.107, 0});
        EXPECT_LE(distanciaRotulo(e.imagen, rotulos[i], OSCURO, p.x, p.y - 20, 0.033), 6 / 720.0) << i;
    }
}
