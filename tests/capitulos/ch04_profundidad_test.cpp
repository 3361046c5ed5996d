// Cuánta profundidad cabe en un buffer de 24 bits: las cuentas de profundidad.h, y el programa profundidad.
#include "ch04_oraculo.h"
#include "ch04_vista3d/profundidad.h"
#include "guiones.h"
#include "tabla.h"

namespace {

using namespace oraculo;

const int ANCHO = 480, ALTO = 360;
const double CERCA[] = {10, 0.1, 0.001}, LEJOS = 1000, PASOS = 0x1p24 - 1;

/// Los doce carteles o, con `delante` y `parte`, sus cuadros, escritos otra vez.
double distanciaCartel(int i) {
    return 12 * std::pow(800.0 / 12, i / 11.0);
}
Vec3 centroCartel(int i) {
    return {0.27 * (i % 4 - 1.5), 0.245 * (1 - i / 4) + 0.055, -1};
}
Escena planos(double delante = 0, double parte = 1) {
    Escena escena;
    for (int i = 0; i < 12; ++i) {
        const double d = distanciaCartel(i);
        escena.push_back(plano(traslada(d * centroCartel(i) + Vec3{0, 0, delante}) * gira({0, 1, 0}, 0.5) *
                               gira({1, 0, 0}, -0.5) * escala(0.185 * d * parte)));
    }
    return escena;
}
const Escena CARTELES = planos(), CUADROS = planos(0.05, 0.8);
Camara camaraCarteles(double cerca, double azimut = 0, double elevacion = 0) {
    return perspectiva(orbita(azimut, elevacion, 15, {0, 0, -15}), 0.8, cerca, LEJOS);
}

/// El número que sigue a `texto` en la salida del programa.
double numeroTras(const std::string &salida, const std::string &texto) {
    const std::size_t i = salida.rfind(texto);
    return i == std::string::npos ? -1 : std::stod(salida.substr(i + texto.size()));
}

} // namespace

// Los carteles de la imagen. Los pares son los píxeles cuyo centro ve, en doble, el cuadro con el cartel
// detrás, a más de un píxel de sus bordes. Con `s` la distancia en pasos de 24 bits:
// - la GPU redondea ocho veces por superficie: el producto, la suma, el inverso y la división en el vértice, el
//   paso al área de dibujo, dos sumas al interpolar y los 24 bits. Ninguna vez en más de medio paso, con
//   varianza 1/12 como mucho; la del par, 2·8/12. A cuatro desviaciones típicas, 4.6 pasos, el par está bien;
// - a menos de un paso el modelo ideal deja iguales 1 − s; con errores de la GPU simétricos, el cuadro sigue
//   delante como mucho la mitad de las veces que serían iguales.
TEST(Profundidad, ParesMalOrdenados) {
    for (const int razon : {0, 1, 2}) {
        const Ejecucion e = ejecuta("profundidad", "tecla " + std::to_string(razon + 1), ANCHO, ALTO);
        ASSERT_EQ(e.estado, 0) << e.errores;
        const Camara camara = camaraCarteles(CERCA[razon]);
        const ImagenRef ref = render(CUADROS, camara, ANCHO, ALTO, [](const Impacto &) { return Vec3{}; });
        int pares = 0, mal = 0, iguales = 0, amarillos = 0;
        for (int y = 0; y < ALTO; ++y)
            for (int x = 0; x < ANCHO; ++x) {
                const Pixel p = pixel(e.imagen, x, y);
                amarillos += p.r > 200 && p.b < 100;
                if (ref.en(x, y).objeto < 0 || enBanda(ref, x, y))
                    continue;
                const Impacto cartel = primerImpacto(CARTELES, rayo(camara, ANCHO, ALTO, x + 0.5, y + 0.5));
                ASSERT_TRUE(cartel);
                const double zCuadro = PASOS * proyecta(camara, ANCHO, ALTO, ref.en(x, y).punto).z,
                             zCartel = PASOS * proyecta(camara, ANCHO, ALTO, cartel.punto).z;
                const bool azul = p.b > 150;
                ++pares;
                mal += azul;
                iguales += std::round(zCuadro) >= std::round(zCartel);
                ASSERT_TRUE(!azul || zCartel - zCuadro <= 4.6) << x << "," << y;
            }
        EXPECT_GT(pares, 30000);
        EXPECT_GE(mal, iguales / 2.0);
        EXPECT_EQ(mal > 0, razon > 0);

        // lo que escribe el programa es lo que hay en su imagen, y lo de una cienmilésima, lo que dificil_vista compara
        // con la fórmula
        const double enCuadros = numeroTras(e.salida, " % de ");
        EXPECT_NEAR(numeroTras(e.salida, "carteles: "), 100 * (1 - amarillos / enCuadros), 0.051) << e.salida;
        EXPECT_NEAR(numeroTras(e.salida, "su distancia, "),
                    100 * cuentaPares<double>(CERCA[razon], LEJOS, 1e-5, 24).iguales, 0.051);
        const char *const cercas[] = {"cerca 10 m", "cerca 0.1 m", "cerca 0.001 m"};
        EXPECT_EQ(e.salida.rfind(std::string(cercas[razon]) + ", lejos 1000 m, 24 bits\n"),
                  e.salida.rfind("cerca"));
    }
}

// Con todo en orden, la imagen entera, también al orbitar: el cuadro está 5 cm por delante, que en el cartel de 12 m se
// ve a 0.65 píxeles, cincuenta veces lo que se admite. El framebuffer propio cambia de tamaño con la ventana.
TEST(Profundidad, LosCartelesYSusDistancias) {
    Escena todo = CARTELES;
    todo.insert(todo.end(), CUADROS.begin(), CUADROS.end());
    const struct {
        std::string guion;
        Camara camara;
    } casos[] = {{"", camaraCarteles(10)},
                 {arrastra({240, 180}, {250, 175}), camaraCarteles(10, -1.8 * 10 / ALTO, -1.8 * 5 / ALTO)}};
    paraCada("profundidad", casos, ANCHO, ALTO, [&](const auto &c, const Vista &v) {
        comprueba("los carteles",
                  compara(v.escena, todo, c.camara,
                          [](const Impacto &i) {
                              return exacto(!i ? CIELO : i.objeto < 12 ? AZUL : AMARILLO);
                          }),
                  EXACTA);
    });
}
