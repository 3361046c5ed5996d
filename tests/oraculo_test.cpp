// Comprobaciones del oráculo contra fórmulas cerradas, y de la grúa entera contra el oráculo.
#include "ejecuta.h"
#include "oraculo/oraculo.h"
#include <gtest/gtest.h>

using namespace oraculo;

// Las medidas del ejercicio 3.5 y las que la grúa elige, escritas otra vez; sombreado de objeto.frag.
TEST(Grua, ContraTrazadoDeRayos) {
    const Vec3 fondo{0.87, 0.93, 0.98}, luz{0.20, 0.78, 0.593}, amarillo{0.98, 0.74, 0.12};
    const std::vector<Vec3> colores = {{0.62, 0.72, 0.58}, amarillo,           amarillo,
                                       {0.42, 0.45, 0.50}, {0.16, 0.17, 0.20}, {0.85, 0.20, 0.18}};
    const Escena escena = {
        caja(traslada({0, -0.1, 0}) * escala({20, 0.2, 20})),     // suelo
        caja(traslada({0, 5, 0}) * escala({0.8, 10, 0.8})),       // pie
        caja(traslada({2.5, 10.4, 0}) * escala({10, 0.8, 0.8})),  // brazo, con 2.5 de voladizo
        caja(traslada({-1.8, 9.3, 0}) * escala(1.4)),             // contrapeso
        caja(traslada({5, 7.25, 0}) * escala({0.12, 5.5, 0.12})), // cable, hasta la carga a altura 4
        caja(traslada({5, 4, 0})),                                // carga
    };
    const Camara camara = perspectiva(orbita(0.5, 0.25, 23, {1.5, 5.2, 0}), 0.6, 1, 100);
    const ImagenRef ref = render(escena, camara, 240, 180, [&](const Impacto &i) {
        return i ? (0.58 + 0.42 * escalar(i.normal, luz)) * colores[static_cast<std::size_t>(i.objeto)]
                 : fondo;
    });
    const Ejecucion e = ejecuta("ch03_transformaciones/grua");
    ASSERT_EQ(e.estado, 0) << e.errores;
    const Comparacion c = compara(e.imagen, ref);
    std::cout << c << "\n";
    EXPECT_LE(c.maximo, 1) << c;
    EXPECT_EQ(c.bandaLejos, 0) << c;
}
