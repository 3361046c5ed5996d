// Los efectos del capítulo 9 que tratan cada píxel, contra la CPU en doble precisión. Las imágenes son al azar y de lados
// que no son múltiplos de 4.
#include "ch09_imagen.h"
#include "colores.h"
#include "rotulos.h"
#include <cstdio>
#include <cstdlib>
#include <glm/glm.hpp>

namespace {

const Imagen A = alAzar(61, 47, 1), B = alAzar(61, 47, 2);

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

// --- mezcla ---

TEST(Mezcla, ContraLaCpu) {
    const auto con = [](double alfa) {
        return [alfa](int x, int y) { return (1 - alfa) * texel(A, x, y) + alfa * texel(B, x, y); };
    };
    EXPECT_EQ(procesa("mezcla", {A, B}, "tecla 1").rgb, A.rgb);
    EXPECT_EQ(procesa("mezcla", {A, B}, "tecla 4").rgb, B.rgb);
    EXPECT_LE(diferenciaMaxima(procesa("mezcla", {A, B}), con(0.33)), 0.51);
    EXPECT_LE(diferenciaMaxima(procesa("mezcla", {A, B}, "tecla 3"), con(0.66)), 0.51);
    EXPECT_LE(diferenciaMaxima(procesa("mezcla", {A, B}, "tecla 3; tecla +; tecla +; tecla -"), con(0.67)),
              0.51);
    EXPECT_EQ(procesa("mezcla", {A, B}, "tecla 4; tecla +").rgb, B.rgb); // alfa no pasa de 1
    EXPECT_EQ(procesa("mezcla", {A, B}, "tecla 1; tecla -").rgb, A.rgb);
}

TEST(Mezcla, OtraTallaSeEstira) {
    const Imagen lisa = imagen(5, 3, [](int, int) { return Pixel{10, 20, 30}; });
    EXPECT_EQ(diferenciaMaxima(procesa("mezcla", {A, lisa}, "tecla 4"),
                               [](int, int) {
                                   return Vec3{10, 20, 30};
                               }),
              0);
}

TEST(Mezcla, HacenFaltaDosImagenes) {
    const struct {
        std::vector<std::string> argumentos;
        const char *mensaje;
    } casos[] = {{{escribe(A)}, "hacen falta 2 imágenes y solo hay 1"},
                 {{escribe(A), escribe(B), escribe(A)}, "solo se leen 2 imágenes"},
                 {{escribe(A), escribe(B, false)}, "hay que decir -talla ANCHOxALTO"},
                 {{escribe(A), escribe(B), "-talla", "61x47"}, "sobra -talla"}};
    for (const auto &c : casos) {
        const Ejecucion e = ejecuta("ch09_imagen/mezcla", "", 61, 47, c.argumentos);
        EXPECT_EQ(e.estado, 2);
        EXPECT_NE(e.errores.find(c.mensaje), std::string::npos) << e.errores;
    }
    const Ejecucion e =
        ejecuta("ch09_imagen/mezcla", "tecla 4", 61, 47, {escribe(A), "-talla", "61x47", escribe(B, false)});
    EXPECT_EQ(e.imagen.rgb, B.rgb);
}

// --- diferencia ---

TEST(Diferencia, ContraLaCpu) {
    const Imagen d = procesa("diferencia", {A, B});
    EXPECT_EQ(diferenciaMaxima(d,
                               [](int x, int y) {
                                   const Vec3 r = texel(A, x, y) - texel(B, x, y);
                                   return Vec3{std::fabs(r.x), std::fabs(r.y), std::fabs(r.z)};
                               }),
              0);
    EXPECT_EQ(procesa("diferencia", {B, A}).rgb, d.rgb);
    EXPECT_LE(diferenciaMaxima(procesa("diferencia", {A, B}, "tecla s"),
                               [](int x, int y) {
                                   return Vec3{128, 128, 128} + 0.5 * (texel(A, x, y) - texel(B, x, y));
                               }),
              0.51);
}

TEST(Diferencia, DeUnaImagenConsigoMisma) {
    const Imagen negra = procesa("diferencia", {A, A}), gris = procesa("diferencia", {A, A}, "tecla s");
    EXPECT_EQ(std::count(negra.rgb.begin(), negra.rgb.end(), 0), std::ptrdiff_t(negra.rgb.size()));
    EXPECT_EQ(std::count(gris.rgb.begin(), gris.rgb.end(), 128), std::ptrdiff_t(gris.rgb.size()));
}

// Con v, en una ventana de tres veces el ancho: A, B y su diferencia.
TEST(Diferencia, LasTresALaVez) {
    const Imagen v = ejecuta("ch09_imagen/diferencia", "tecla v", 185, 47, {escribe(A), escribe(B)}).imagen,
                 d = procesa("diferencia", {A, B});
    const Imagen *const paneles[] = {&A, &B, &d};
    for (int k = 0; k < 3; ++k)
        EXPECT_EQ(diferenciaMaxima(imagen(61, 47, [&](int x, int y) { return pixel(v, 62 * k + x, y); }),
                                   igualQue(*paneles[k])),
                  0)
            << k;
}

TEST(Diferencia, DosTallasNoSePuedenRestar) {
    const Ejecucion e = ejecuta("ch09_imagen/diferencia", "", 61, 47, {escribe(A), escribe(alAzar(61, 48))});
    EXPECT_EQ(e.estado, 1);
    EXPECT_NE(e.errores.find("tienen que medir lo mismo"), std::string::npos);
}

// Las dos de por omisión se diferencian en cinco sitios y en nada más.
TEST(Diferencia, CincoSitios) {
    const Imagen d = ejecuta("ch09_imagen/diferencia", "tecla r", 250, 190).imagen;
    const glm::ivec4 sitios[] = {{95, 142, 142, 162},
                                 {209, 154, 236, 173},
                                 {113, 60, 132, 96},
                                 {180, 20, 236, 77},
                                 {135, 50, 180, 65}};
    int contados[5] = {}, fuera = 0;
    for (int y = 0; y < 190; ++y)
        for (int x = 0; x < 250; ++x) {
            const Pixel p = pixel(d, x, y);
            if (p.r + p.g + p.b < 9)
                continue;
            int donde = -1;
            for (int k = 0; k < 5; ++k)
                if (x >= sitios[k].x && y >= sitios[k].y && x < sitios[k].z && y < sitios[k].w)
                    donde = k;
            ++(donde < 0 ? fuera : contados[donde]);
        }
    EXPECT_EQ(fuera, 0);
    for (const int n : contados)
        EXPECT_GT(n, 20);
}

// --- volteo ---

TEST(Volteo, ContraLaCpuYDosVecesEsElOriginal) {
    const auto volteada = [](bool h, bool v) {
        return [=](int x, int y) { return texel(A, h ? A.ancho - 1 - x : x, v ? A.alto - 1 - y : y); };
    };
    EXPECT_EQ(procesa("volteo", {A}).rgb, A.rgb);
    EXPECT_EQ(diferenciaMaxima(procesa("volteo", {A}, "tecla h"), volteada(true, false)), 0);
    EXPECT_EQ(diferenciaMaxima(procesa("volteo", {A}, "tecla v"), volteada(false, true)), 0);
    EXPECT_EQ(diferenciaMaxima(procesa("volteo", {A}, "tecla h; tecla v"), volteada(true, true)), 0);
    for (const std::string tecla : {"tecla h", "tecla v"}) {
        EXPECT_EQ(procesa("volteo", {procesa("volteo", {A}, tecla)}, tecla).rgb, A.rgb);
        EXPECT_EQ(procesa("volteo", {A}, tecla + "; " + tecla).rgb, A.rgb);
    }
}

// El nombre que lleva la imagen es el de lo que se le ha hecho.
TEST(Volteo, LosRotulos) {
    const std::pair<const char *, const char32_t *> casos[] = {{"", U"Original"},
                                                               {"tecla h", U"Horizontal"},
                                                               {"tecla v", U"Vertical"},
                                                               {"tecla h; tecla v", U"Los dos"}};
    for (const auto &[guion, nombre] : casos)
        EXPECT_EQ(buscaRotulo(ejecuta("ch09_imagen/volteo", guion, 960, 720).imagen, nombre, BLANCO).size(),
                  1u)
            << guion;
}

// --- remolino ---

// Gira en el sentido contrario a las agujas del reloj; fuera del círculo que cabe en la imagen no cambia nada.
TEST(Remolino, ContraLaCpu) {
    const auto girada = [](const Imagen &im, double grados) {
        return [&im, grados](int x, int y) {
            const double cx = im.ancho / 2.0, cy = im.alto / 2.0, dx = x + 0.5 - cx, dy = y + 0.5 - cy,
                         cerca = std::max(1 - std::hypot(dx, dy) / std::min(cx, cy), 0.0),
                         a = -grados * 3.14159265358979323846 / 180 * cerca * cerca;
            return bilineal(im, cx + std::cos(a) * dx - std::sin(a) * dy,
                            cy + std::sin(a) * dx + std::cos(a) * dy);
        };
    };
    for (const Imagen &im : {A, alAzar(40, 90, 7)}) {
        EXPECT_LE(diferenciaMaxima(procesa("remolino", {im}), girada(im, 240)), 1);
        EXPECT_LE(diferenciaMaxima(procesa("remolino", {im}, repite("tecla -", 20)), girada(im, -60)), 1);
        EXPECT_LE(diferenciaMaxima(procesa("remolino", {im}, repite("tecla +", 99)), girada(im, 720)), 1);
    }
    EXPECT_EQ(procesa("remolino", {A}, repite("tecla -", 16)).rgb, A.rgb); // 0°
    EXPECT_EQ(procesa("remolino", {alAzar(1, 1)}).rgb, alAzar(1, 1).rgb);
}
