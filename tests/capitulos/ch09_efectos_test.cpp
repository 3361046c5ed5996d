// Los efectos del capítulo 9 que tratan cada píxel, contra la CPU en doble precisión. Las imágenes son al azar y de lados
// que no son múltiplos de 4.
#include "ch09_imagen.h"
#include <cstdlib>

namespace {

const Imagen A = alAzar(61, 47, 1);

double gris(const Vec3 &c) {
    return (c.x + c.y + c.z) / 3;
}

} // namespace

TEST(Efectos, CadaUnoContraLaCpu) {
    const auto compara = [](const std::string &guion, const std::function<Vec3(const Vec3 &)> &efecto) {
        return diferenciaMaxima(procesa("efectos", {A}, guion),
                                [&](int x, int y) { return efecto(texel(A, x, y)); });
    };
    EXPECT_EQ(compara("", [](const Vec3 &c) { return c; }), 0);
    EXPECT_LE(compara("tecla 2", [](const Vec3 &c) { return 1.6 * c; }), 0.51);
    EXPECT_LE(compara("tecla 2; " + repite("tecla -", 11), [](const Vec3 &c) { return 0.5 * c; }), 0.51);
    EXPECT_LE(compara("tecla 2; " + repite("tecla +", 99), [](const Vec3 &c) { return 4 * c; }), 0.51);
    EXPECT_EQ(compara("tecla 3", [](const Vec3 &c) { return Vec3{255, 255, 255} - c; }), 0);
    EXPECT_LE(compara("tecla 4", [](const Vec3 &c) { return gris(c) * Vec3{1, 1, 1}; }), 0.51);
    EXPECT_LE(compara("tecla 5",
                      [](const Vec3 &c) {
                          return (0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z) * Vec3{1, 1, 1};
                      }),
              0.51);
}

// El menú hace lo mismo que las teclas.
TEST(Efectos, ElMenuEligeLoMismo) {
    const char *const opciones[] = {"Original", "Brillo", "Negativo", "Media", "Luminancia"};
    for (int i = 0; i < 5; ++i)
        EXPECT_EQ(procesa("efectos", {A}, std::string("menu ") + opciones[i]).rgb,
                  procesa("efectos", {A}, "tecla " + std::to_string(i + 1)).rgb);
}

TEST(Efectos, ElNegativoDosVecesEsElOriginal) {
    const Imagen negativo = procesa("efectos", {A}, "tecla 3");
    EXPECT_NE(negativo.rgb, A.rgb);
    EXPECT_EQ(procesa("efectos", {negativo}, "tecla 3").rgb, A.rgb);
}

// La errata: verde y azul puros, igual de grises para la media.
TEST(Efectos, LaMediaNoDistingueElVerdeDelAzul) {
    const Imagen dos = imagen(2, 1, [](int x, int) { return x ? Pixel{0, 255, 0} : Pixel{0, 0, 255}; });
    const Imagen media = procesa("efectos", {dos}, "tecla 4"), luz = procesa("efectos", {dos}, "tecla 5");
    EXPECT_EQ(pixel(media, 0, 0).r, pixel(media, 1, 0).r);
    EXPECT_EQ(pixel(luz, 0, 0).r, 18);
    EXPECT_EQ(pixel(luz, 1, 0).r, 182);
}

// 1×1, una columna y 4096×4096: texel a texel.
TEST(Efectos, TallasExtremas) {
    for (const auto &[ancho, alto] : {std::pair(1, 1), {1, 300}, {300, 1}, {4096, 4096}}) {
        const Imagen i = alAzar(ancho, alto);
        EXPECT_TRUE(procesa("efectos", {i}).rgb == i.rgb) << ancho << "×" << alto;
    }
}

// Sin -geometry la ventana toma el tamaño de la imagen; con ella, no, y la imagen cabe entera sin deformarse.
TEST(Efectos, LaVentanaTomaElTamanoDeLaImagen) {
    const Imagen i = alAzar(30, 20);
    const std::string salida = (carpetaTemporal() / "sin_talla.ppm").string(), fichero = escribe(i, false);
    for (const std::string &argumentos : {escribe(i), fichero + " -talla 30x20"}) {
        std::remove(salida.c_str());
        ASSERT_EQ(
            std::system((LAB_EJECUTABLES "/ch09_imagen/efectos " + argumentos + " -ppm " + salida).c_str()),
            0);
        const Imagen leida = leePpm(salida);
        EXPECT_EQ(leida.ancho, 30);
        EXPECT_EQ(leida.rgb, i.rgb);
    }
    const Ejecucion e = ejecuta("ch09_imagen/efectos", "", 90, 100, {escribe(i)}); // cabe a 3×: 90 × 60
    const Pixel fondo = pixel(e.imagen, 0, 0);
    EXPECT_EQ(fondo.r, 41);
    for (const auto &[y, dentro] : {std::pair(19, false), {20, true}, {79, true}, {80, false}})
        EXPECT_EQ(pixel(e.imagen, 45, y).r == fondo.r && pixel(e.imagen, 46, y).r == fondo.r, !dentro) << y;
    for (int x = 0; x < 30; ++x) // el centro de cada texel es un píxel
        EXPECT_LE(std::fabs(pixel(e.imagen, 3 * x + 1, 20 + 3 * 7 + 1).g - texel(i, x, 7).y), 1) << x;
}

// Los rótulos están con la imagen por omisión y no con la del usuario, salvo que los pida.
TEST(Efectos, LaImagenDelUsuarioNoLlevaRotulos) {
    const Imagen negra = imagen(200, 60, [](int, int) { return Pixel{0, 0, 0}; });
    const auto hayBlanco = [](const Imagen &i) { return std::count(i.rgb.begin(), i.rgb.end(), 255) > 20; };
    EXPECT_FALSE(hayBlanco(procesa("efectos", {negra})));
    EXPECT_TRUE(hayBlanco(procesa("efectos", {negra}, "tecla r")));
    const Imagen con = ejecuta("ch09_imagen/efectos").imagen,
                 sin = ejecuta("ch09_imagen/efectos", "tecla r").imagen;
    EXPECT_NE(con.rgb, sin.rgb);
}

// Con v, en una ventana de 2 × 2 veces la imagen, cada panel es su efecto.
TEST(Efectos, LosCuatroALaVez) {
    const Imagen lisa = imagen(40, 30, [](int, int) { return Pixel{100, 20, 200}; });
    const Ejecucion e = ejecuta("ch09_imagen/efectos", "tecla v", 81, 61, {escribe(lisa)});
    const auto es = [&](int x, int y, const Pixel &c) {
        const Pixel p = pixel(e.imagen, x, y);
        EXPECT_EQ(std::vector<int>({p.r, p.g, p.b}), std::vector<int>({c.r, c.g, c.b})) << x << "," << y;
    };
    es(20, 45, {160, 32, 255});
    es(60, 45, {155, 235, 55});
    es(20, 15, {107, 107, 107});
    es(60, 15, {50, 50, 50});
}
