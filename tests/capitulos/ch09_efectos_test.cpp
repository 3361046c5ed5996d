// Los efectos del capítulo 9 que tratan cada píxel, contra la CPU en doble precisión. Las imágenes son al azar y de
// lados que no son múltiplos de 4.
#include "ch09_paneles.h"

namespace {

const Imagen A = alAzar(61, 47, 1), B = alAzar(61, 47, 2);
const Vec3 UNO{1, 1, 1}, PESOS{0.2126, 0.7152, 0.0722};

/// Lo que sale de cada texel de A y el suyo de B.
template<class Efecto>
Esperado deTexels(Efecto efecto) {
    return [=](int x, int y) { return efecto(texel(A, x, y), texel(B, x, y)); };
}
Esperado brillo(double alfa) {
    return deTexels([=](auto a, auto) { return alfa * a; });
}
Esperado gris(const Vec3 &pesos) {
    return deTexels([=](auto a, auto) { return escalar(a, pesos) * UNO; });
}
Esperado mezcla(double alfa) {
    return deTexels([=](auto a, auto b) { return (1 - alfa) * a + alfa * b; });
}
const Esperado SOLO_A = igualQue(A), SOLO_B = igualQue(B);

Esperado volteada(bool horizontal, bool vertical) {
    return [=](int x, int y) {
        return texel(A, horizontal ? A.ancho - 1 - x : x, vertical ? A.alto - 1 - y : y);
    };
}

/// Gira en el sentido contrario a las agujas del reloj; fuera del círculo que cabe en la imagen no cambia nada.
Esperado girada(const Imagen &im, int grados) {
    return [im, grados](int x, int y) {
        const double cx = im.ancho / 2.0, cy = im.alto / 2.0, dx = x + 0.5 - cx, dy = y + 0.5 - cy,
                     cerca = std::max(1 - std::hypot(dx, dy) / std::min(cx, cy), 0.0),
                     a = -grados * oraculo::PI / 180 * cerca * cerca;
        return bilineal(im, cx + std::cos(a) * dx - std::sin(a) * dy,
                        cy + std::sin(a) * dx + std::cos(a) * dy);
    };
}

} // namespace

// Con su tecla y con el menú, que además deja de comparar. El negativo es exacto: hecho dos veces da el original.
TEST(Efectos, CadaUnoContraLaCpu) {
    const Esperado negativo = deTexels([](auto a, auto) { return 255 * UNO - a; }),
                   media = gris(1 / 3.0 * UNO);
    compruebaPaneles(
        "efectos", {A},
        {{{"", "tecla v; tecla 1", "tecla 3; menu Original", "tecla v; tecla c ×2", "tecla c; tecla +"},
          {SOLO_A}},
         {{"tecla 2", "tecla v; menu Brillo"}, {brillo(1.6)}},
         {{"tecla 2; tecla + ×3"}, {brillo(1.9)}},
         {{"tecla 2; tecla + ×99"}, {brillo(4)}},
         {{"tecla 2; tecla - ×99; tecla + ×5"}, {brillo(0.5)}},
         {{"tecla 3", "menu Negativo"}, {negativo}},
         {{"tecla 4", "menu Media"}, {media}},
         {{"tecla v; tecla v; tecla 5", "menu Luminancia"}, {gris(PESOS)}},
         {{"tecla v", "tecla c; tecla v"}, {SOLO_A, brillo(1.6), negativo, media}}});
}

// La errata: de seis colores puros la media da dos grises, el verde como el azul; la luminancia, seis.
TEST(Efectos, LosDosGrisesDeSeisColores) {
    const Imagen gpu = vistaDe("efectos", "tecla v; tecla c", 60, 62).escena;
    const Vec3 puros[] = {{255, 0, 0}, {255, 255, 0}, {0, 255, 0}, {0, 255, 255}, {0, 0, 255}, {255, 0, 255}};
    for (const int y : {0, 21, 42}) {
        const auto esperado = [&](int x, int) {
            const Vec3 &c = puros[x / 10];
            return y == 42 ? c : escalar(c, y == 21 ? 1 / 3.0 * UNO : PESOS) * UNO;
        };
        EXPECT_LE(diferenciaMaxima(oraculo::recorta(gpu, 0, y, 60, 20), esperado), REDONDEO) << y;
    }
}

// --- mezcla ---

TEST(Mezcla, ContraLaCpu) {
    compruebaPaneles("mezcla", {A, B},
                     {{{"", "tecla 3; tecla 2"}, {mezcla(0.33)}},
                      {{"tecla 3; tecla + ×2; tecla -"}, {mezcla(0.67)}},
                      {{"tecla 1", "tecla - ×99"}, {SOLO_A}},
                      {{"tecla 4", "tecla + ×99"}, {SOLO_B}},
                      {{"tecla v; tecla 2", "tecla v; tecla -; tecla +"}, {mezcla(0.33)}},
                      {{"tecla 4; tecla v"}, {SOLO_A, mezcla(0.33), mezcla(0.66), SOLO_B}}});
    EXPECT_EQ(procesa("mezcla", {A, lisa(5, 3, {10, 20, 30})}, "tecla 4").rgb,
              lisa(61, 47, {10, 20, 30}).rgb);
    const std::vector<std::string> ficheros = {enFichero(A), "-talla", "61x47", enFichero(B, ".rgb")};
    EXPECT_EQ(vistaDe("mezcla", "tecla 4", 61, 47, ficheros).escena.rgb, B.rgb);
}

// --- diferencia ---

TEST(Diferencia, ContraLaCpu) {
    const Esperado sinSigno = deTexels([](auto a, auto b) { return absoluto(a - b); }),
                   conSigno = deTexels([](auto a, auto b) { return 128 * UNO + 0.5 * (a - b); });
    compruebaPaneles("diferencia", {A, B},
                     {{{""}, {sinSigno}},
                      {{"tecla s", "tecla v; tecla s"}, {conSigno}},
                      {{"tecla v", "tecla s; tecla v"}, {SOLO_A, SOLO_B, sinSigno, conSigno}}});
    compruebaPaneles("diferencia", {B, A}, {{{""}, {sinSigno}}});
    const Ejecucion e = ejecuta("diferencia", "", 61, 47, enFicheros({A, alAzar(61, 48)}));
    EXPECT_NE(e.errores.find("tienen que medir lo mismo"), std::string::npos) << e.errores;
}

// --- volteo ---

TEST(Volteo, ContraLaCpu) {
    const Esperado horizontal = volteada(true, false), vertical = volteada(false, true),
                   losDos = volteada(true, true);
    compruebaPaneles("volteo", {A},
                     {{{"", "tecla x ×2; tecla y ×2"}, {SOLO_A}},
                      {{"tecla x", "tecla v; tecla x"}, {horizontal}},
                      {{"tecla y"}, {vertical}},
                      {{"tecla x; tecla y"}, {losDos}},
                      {{"tecla y; tecla v"}, {SOLO_A, losDos, horizontal, vertical}}});
}

// --- remolino ---

// Un nivel: la GPU interpola con fracciones de texel de 8 bits.
TEST(Remolino, ContraLaCpu) {
    for (const Imagen &im : {A, alAzar(40, 90, 7)})
        compruebaPaneles("remolino", {im},
                         {{{""}, {girada(im, 240)}},
                          {{"tecla - ×20"}, {girada(im, -60)}},
                          {{"tecla + ×99"}, {girada(im, 720)}},
                          {{"tecla - ×99"}, {girada(im, -720)}},
                          {{"tecla - ×16"}, {igualQue(im)}},
                          {{"tecla v; tecla +"}, {igualQue(im), girada(im, 255)}}},
                         1);
    EXPECT_EQ(procesa("remolino", {lisa(1, 1, {9, 99, 199})}).rgb, lisa(1, 1, {9, 99, 199}).rgb);
}
