// Que el oráculo nota los errores. Lo que traza no se prueba solo: si fuera otra cosa, lo notarían los programas que se
// comparan con él.
#include "contra_oraculo.h"
#include <tuple>

using namespace oraculo;

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

// Cada estropicio se nota: una componente de un píxel, en más o en menos, dentro o en un borde; la esfera movida, el
// color casi igual, otra talla, o nada que comparar.
TEST(Comparar, CadaErrorSeNota) {
    const Escena escena = esferaYSuelo({});
    const ImagenRef ref = render(escena, CAMARA, 80, 60, sombrea);
    Imagen mala;
    for (int n = 0; n < 80 * 60; n += n == 4740 ? 59 : 79) // del primero al último
        for (int k = 0; k < 3; ++k) {
            mala = enBytes(ref);
            unsigned char &estropeado = mala.rgb[std::size_t(3 * n + k)];
            estropeado = static_cast<unsigned char>(estropeado + (estropeado > 127 ? -90 : 90));
            const Comparacion c = compara(mala, ref);
            if (enBanda(ref, n % 80, n / 80))
                EXPECT_TRUE(c.maximo < 1 && c.bandaDistintos == 1) << n << " " << k << c;
            else
                EXPECT_TRUE(c.maximo > 89 && c.xMaximo == n % 80 && c.yMaximo == n / 80 && c.rmse > 1)
                    << n << " " << k << c;
        }
    const ImagenRef sinNada =
        render(escena, CAMARA, 80, 60, [](const Impacto &) { return Tono({}, SIN_COMPARAR); });
    EXPECT_EQ(compara(enBytes(ref), sinNada).maximo, INFINITO);
    for (const auto &[ancho, alto] : {std::pair(79, 60), {80, 59}})
        EXPECT_THROW(compara(recorta(enBytes(ref), 0, 0, ancho, alto), ref), std::invalid_argument);
    mala = enBytes(ref); // la silueta: algo donde no hay nada, y nada donde lo hay
    for (const auto &[x, y, color] : {std::tuple(2, 57, Vec3{0, 0, 0}), {40, 30, FONDO}})
        for (int k = 0; k < 3; ++k) {
            Imagen una = mala;
            for (int i = 0; i < 3; ++i)
                una.rgb[std::size_t(3 * (y * 80 + x) + i)] =
                    enOchoBits(y == 30 || i == k ? color[i] : FONDO[i]);
            EXPECT_EQ(comparaSilueta(una, FONDO, escena, CAMARA).maximo, 255) << x << " " << k;
        }

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
    EXPECT_THROW(render({}, Camara{}, 4, 4,
                        [](const Impacto &) {
                            return Vec3{0, NAN, 0};
                        }),
                 std::domain_error);
}

} // namespace
