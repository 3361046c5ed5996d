// warping, morphing, antialiasing, ampliacion y captura del capítulo 9.
#include "ch09_imagen.h"
#include "ch09_imagen/estrella.h"
#include "ch09_imagen/malla_imagen.h"
#include "ch09_imagen/proporcion.h"
#include "colores.h"
#include "oraculo/cobertura.h"
#include "rotulos.h"
#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace fs = std::filesystem;

namespace {

const Imagen A = alAzar(80, 60, 5), B = alAzar(80, 60, 6);

double separacion(const glm::vec2 &a, const glm::vec2 &b) {
    return static_cast<double>(glm::length(a - b));
}

} // namespace

// --- malla_imagen.h ---

TEST(MallaImagen, PasaPorSusPuntosYLaRegularNoDeforma) {
    MallaImagen m = creaMallaImagen(repartidos(5), repartidos(4));
    for (int k = 0; k < 100; ++k) {
        const float u = 4 * static_cast<float>(k % 10) / 9, v = 3 * static_cast<float>(k / 10) / 9;
        EXPECT_LT(separacion(evalua(m, u, v), {u / 4, v / 3}), 2e-7);
    }
    m.puntos[7] = {0.9f, 0.1f}; // columna 2, fila 1
    EXPECT_LT(separacion(evalua(m, 2, 1), {0.9f, 0.1f}), 1e-7);
    EXPECT_LT(separacion(evalua(m, 1, 2), {0.25f, 2 / 3.0f}), 1e-7);
    EXPECT_GT(separacion(evalua(m, 2.5f, 1), {0.625f, 1 / 3.0f}), 0.1);
    EXPECT_LT(separacion(evalua(m, 1.999f, 1.3f), evalua(m, 2.001f, 1.3f)), 0.005); // sin saltos
    EXPECT_EQ(masCercano(m, {0.85f, 0.15f}, {80, 60}), 7u);
    EXPECT_EQ(masCercano(m, {0.02f, 0.9f}, {80, 60}), 15u);
    // la distancia es en píxeles: en una imagen muy ancha, lo que separa es x
    m = {2, 2, {{0, 0}, {0.3f, 0.5f}, {0, 1}, {1, 1}}};
    EXPECT_EQ(masCercano(m, {0, 0.4f}, {1, 1}), 1u);
    EXPECT_EQ(masCercano(m, {0, 0.4f}, {1000, 10}), 0u);
}

// --- warping ---

TEST(Warping, LaMallaIdentidadEsElOriginal) {
    EXPECT_EQ(procesa("warping", {A}).rgb, A.rgb);
    EXPECT_EQ(procesa("warping", {A}, "tecla 2; tecla 1").rgb, A.rgb);
    EXPECT_NE(procesa("warping", {A}, "tecla 2").rgb, A.rgb);
    EXPECT_EQ(procesa("warping", {alAzar(1, 1)}).rgb, alAzar(1, 1).rgb);
}

// Arrastrar el punto central (5, 4) lleva su texel al ratón; lo que está a más de dos puntos no se mueve.
TEST(Warping, ElTexelVaConSuPunto) {
    const Imagen marca = imagen(221, 177, [](int x, int y) {
        return std::abs(x - 110) < 4 && std::abs(y - 88) < 4 ? Pixel{255, 0, 0} : Pixel{x, y, 77};
    });
    const Imagen r = procesa("warping", {marca},
                             "boton IZQUIERDO abajo 112 90; arrastra 121 76; boton IZQUIERDO arriba 121 76");
    EXPECT_EQ(pixel(r, 121, 100).r, 255);
    EXPECT_LT(pixel(r, 106, 84).r, 255);
    int distintos = 0;
    for (int y = 0; y < 177; ++y)
        for (int x = 0; x < 221; ++x)
            if (std::abs(x - 110) > 46 || std::abs(y - 88) > 46) {
                const Pixel p = pixel(r, x, y);
                distintos += std::abs(p.r - x) > 1 || std::abs(p.g - y) > 1;
            }
    EXPECT_EQ(distintos, 0);
    // con el otro botón no se arrastra
    EXPECT_EQ(procesa("warping", {A}, "boton CENTRAL abajo 40 30; arrastra 50 20").rgb, A.rgb);
}

// El pliegue: el punto (4, 4) llevado más allá del (5, 4) y del (6, 4). Se ve siempre lo mismo, lo último de la fila, que es lo de
// más a la derecha.
TEST(Warping, ElPliegueTieneUnOrden) {
    const Imagen rampa = imagen(221, 177, [](int x, int) { return Pixel{x, 0, 0}; });
    const std::string guion = "boton IZQUIERDO abajo 88 88; arrastra 143 88";
    const Imagen r = procesa("warping", {rampa}, guion);
    EXPECT_EQ(procesa("warping", {rampa}, guion).rgb, r.rgb);
    // en (126, 88) hay tres capas; la de arriba viene de la derecha del punto 5 (x > 110)
    EXPECT_GT(pixel(r, 126, 88).r, 110);
}

// La caricatura ensancha por abajo y estrecha por arriba, igual a los dos lados: se ve un texel más cerca o más lejos del eje.
TEST(Warping, LaCaricatura) {
    const Imagen r = procesa("warping",
                             {imagen(221, 177,
                                     [](int x, int) {
                                         return Pixel{x, 0, 0};
                                     })},
                             "tecla 2");
    for (const int lado : {-1, 1}) {
        const auto texelA = [&](int lejos, int y) {
            return lado * (pixel(r, 110 + lado * lejos, y).r - 110);
        };
        EXPECT_LT(texelA(66, 44), 66 - 15) << lado;
        EXPECT_GT(texelA(44, 133), 44 + 10) << lado;
        EXPECT_NEAR(texelA(66, 44), pixel(r, 176, 44).r - 110, 1);
    }
}

// Los puntos no salen de la imagen.
TEST(Warping, UnPuntoNoSaleDeLaImagen) {
    const std::string hasta = "boton IZQUIERDO abajo 1 58; arrastra ";
    EXPECT_EQ(procesa("warping", {A}, hasta + "-500 900").rgb, A.rgb); // la esquina ya está en el borde
}

// --- morphing ---

TEST(Morphing, EnLosExtremosEsAYEsB) {
    EXPECT_EQ(procesa("morphing", {A, B}, "tecla 1").rgb, A.rgb);
    EXPECT_EQ(procesa("morphing", {A, B}, "tecla 3").rgb, B.rgb);
    EXPECT_EQ(procesa("morphing", {A, B}, repite("tecla -", 12)).rgb, A.rgb);
    EXPECT_EQ(procesa("morphing", {A, B}, repite("tecla +", 12)).rgb, B.rgb);
}

// También con las mallas de las dos caras, que no son regulares.
TEST(Morphing, LasCarasSonExactas) {
    const auto lee = [](const char *nombre) {
        return leeTextura(std::string(LAB_BUILD "/assets/") + nombre, 320, 240);
    };
    for (const auto &[tecla, nombre] :
         {std::pair("tecla 1; tecla r", "cara.rgb"), {"tecla 3; tecla r", "gato.rgb"}})
        EXPECT_EQ(ejecuta("ch09_imagen/morphing", tecla, 320, 240).imagen.rgb, lee(nombre).rgb) << nombre;
}

// Con mallas regulares es la mezcla lineal.
TEST(Morphing, SinDeformarEsUnaMezcla) {
    for (const auto &[guion, t] :
         {std::pair(std::string("tecla 2"), 0.5), {"tecla 2; tecla +", 0.55}, {"tecla 1; tecla +", 0.05}}) {
        const double k = t;
        EXPECT_LE(
            diferenciaMaxima(procesa("morphing", {A, B}, guion),
                             [k](int x, int y) { return (1 - k) * texel(A, x, y) + k * texel(B, x, y); }),
            0.6);
    }
}

// A medio camino las pupilas de las dos caras están en el mismo sitio, la media.
TEST(Morphing, LosOjosVanALosOjos) {
    const Imagen r = ejecuta("ch09_imagen/morphing", "tecla 2; tecla r", 320, 240).imagen;
    const int y = static_cast<int>(0.4925 * 240);
    for (const double x : {0.5 - 0.1125, 0.5 + 0.1125})
        EXPECT_LT(pixel(r, static_cast<int>(x * 320), y).r, 60);
}

// Se arrastra el punto (3, 3) de 7 × 8 a (120, 84): el intermedio queda bajo el ratón. Con t < 0.5 cambia la malla de A, y en el ratón
// sigue el texel de B; si no, al revés.
TEST(Morphing, ElPuntoIntermedioQuedaBajoElRaton) {
    const Imagen negra = imagen(211, 141,
                                [](int, int) {
                                    return Pixel{0, 0, 0};
                                }),
                 marca = imagen(211, 141, [](int x, int y) {
                     return std::abs(x - 105) < 4 && std::abs(y - 60) < 4 ? Pixel{255, 0, 0} : Pixel{0, 0, 0};
                 });
    const std::string arrastra = "; boton IZQUIERDO abajo 105 80; arrastra 120 84";
    const Imagen enA = procesa("morphing", {negra, marca}, "tecla 2; tecla -" + arrastra),
                 enB = procesa("morphing", {marca, negra}, "tecla 2; tecla +" + arrastra);
    EXPECT_NEAR(pixel(enA, 120, 56).r, 0.45 * 255, 1);
    EXPECT_NEAR(pixel(enB, 120, 56).r, 0.45 * 255, 1);
    EXPECT_EQ(pixel(enA, 105, 60).r + pixel(enB, 105, 60).r, 0);
}

// El movimiento depende solo del reloj: a los 1500 ms, t = 0.5; a los 3000, 1; a los 6000, 0 otra vez.
TEST(Morphing, ElMovimientoSigueAlReloj) {
    const auto en = [](int ms) {
        return procesa("morphing", {A, B}, "tecla 1; tecla Espacio; espera " + std::to_string(ms));
    };
    const Imagen lisa = en(1500);
    EXPECT_LE(diferenciaMaxima(lisa, [](int x, int y) { return 0.5 * (texel(A, x, y) + texel(B, x, y)); }),
              4);
    EXPECT_LE(diferenciaMaxima(en(3000), igualQue(B)), 4); // el último cuadro es de hasta 33 ms antes
    EXPECT_LE(diferenciaMaxima(en(6000), igualQue(A)), 4);
}

// --- antialiasing ---

// La escena: rayos iguales cada 15 grados, cada uno un triángulo isósceles que apunta hacia fuera.
TEST(Antialiasing, LaEstrella) {
    const std::vector<glm::dvec2> v = estrella();
    ASSERT_EQ(v.size(), 72u);
    for (std::size_t k = 0; k < v.size(); k += 3) {
        const glm::dvec2 d = glm::normalize(v[k + 1]), base = v[k + 2] - v[k],
                         otro = glm::normalize(v[(k + 4) % 72]);
        EXPECT_NEAR(glm::length(v[k + 1]), RADIO_FUERA, 1e-12);
        EXPECT_NEAR(glm::dot(base, d), 0, 1e-12) << k;
        EXPECT_NEAR(glm::length(base), 2 * SEMIANCHO, 1e-12);
        EXPECT_NEAR(glm::distance(0.5 * (v[k] + v[k + 2]), RADIO_DENTRO * d), 0, 1e-12);
        EXPECT_NEAR(d.x * otro.y - d.y * otro.x, std::sin(2 * oraculo::PI / 24), 1e-12);
    }
}

// Contra el área exacta, y las dos técnicas de muestras conocidas, muestra a muestra: el centro del píxel y los centros de sus
// 4 × 4 partes. De las que caen a menos de una centésima de píxel de un lado no se dice nada.
TEST(Antialiasing, CoberturaContraElAreaExacta) {
    const int LADO = 180; // de una ventana de 200 × 200, desde (10, 20)
    const double fondo = std::round(255.0 * static_cast<double>(FONDO_CLARO.r)),
                 tinta = std::round(255.0 * static_cast<double>(OSCURO.r));
    std::vector<oraculo::Poligono> rayos;
    const std::vector<glm::dvec2> v = estrella();
    for (std::size_t k = 0; k < v.size(); k += 3) {
        rayos.emplace_back();
        for (std::size_t i = k; i < k + 3; ++i)
            rayos.back().push_back({90 + 90 * v[i].x, 90 + 90 * v[i].y});
    }
    double rmse[3];
    for (int tecnica = 0; tecnica < 3; ++tecnica) {
        const Ejecucion e =
            ejecuta("ch09_imagen/antialiasing", "tecla " + std::to_string(tecnica + 1), 200, 200);
        ASSERT_EQ(e.estado, 0) << e.errores;
        double suma = 0, maximo = 0;
        int n = 0, malos = 0;
        for (int y = 0; y < LADO; ++y)
            for (int x = 0; x < LADO; ++x) {
                if (std::hypot(x + 0.5 - 90, y + 0.5 - 90) < 0.44 * 90)
                    continue; // la lupa
                const int lado = tecnica == 2 ? 4 : 1;
                double area = 0, pocas = 0, muchas = 0;
                for (const oraculo::Poligono &rayo : rayos) {
                    if (std::hypot(rayo[0].x - x, rayo[0].y - y) > 60)
                        continue;
                    area += oraculo::coberturaPixel(rayo, x, y);
                    for (int i = 0; i < lado * lado; ++i) {
                        const double d = oraculo::distanciaDentro(rayo, x + (i % lado + 0.5) / lado,
                                                                  y + (i / lado + 0.5) / lado);
                        pocas += d > 0.01 ? 1.0 / (lado * lado) : 0;
                        muchas += d > -0.01 ? 1.0 / (lado * lado) : 0;
                    }
                }
                const double visto = (fondo - pixel(e.imagen, 10 + x, 20 + y).r) / (fondo - tinta);
                malos += tecnica != 1 && (visto < pocas - 0.006 || visto > muchas + 0.006);
                suma += (visto - area) * (visto - area);
                maximo = std::max(maximo, std::fabs(visto - area));
                n += area > 0 && area < 1;
            }
        rmse[tecnica] = std::sqrt(suma / n);
        EXPECT_EQ(malos, 0) << "técnica " << tecnica;
        EXPECT_GT(n, 2000);
        EXPECT_LE(maximo, tecnica == 0 ? 1 : tecnica == 1 ? 0.45 : 0.20);
        std::printf("técnica %d: RMSE %.4f de cobertura en %d píxeles de borde, máximo %.3f\n", tecnica,
                    rmse[tecnica], n, maximo);
    }
    EXPECT_LT(rmse[1], 0.6 * rmse[0]);
    EXPECT_LT(rmse[2], 0.6 * rmse[1]);
}

// La lupa son 16 × 16 píxeles de la propia imagen, también cuando aumentada entera no cabría en un área de dibujo.
TEST(Antialiasing, LaLupaSonPixelesDeLaImagen) {
    const struct {
        int ancho, alto, lado, x, y, aumento;
    } casos[] = {{200, 200, 180, 10, 20, 3}, {960, 1080, 960, 0, 113, 18}};
    for (const auto &c : casos)
        for (const char *guion : {"tecla 1", "tecla 2", "tecla 3"}) {
            const Imagen imagen = ejecuta("ch09_imagen/antialiasing", guion, c.ancho, c.alto).imagen;
            const int esquina = (c.lado - 16 * c.aumento) / 2, columna = static_cast<int>(0.895 * c.lado - 8),
                      fila = static_cast<int>(0.530 * c.lado - 8);
            std::set<int> tonos;
            for (int j = 0; j < 16; ++j)
                for (int i = 0; i < 16; ++i) {
                    const Pixel original = pixel(imagen, c.x + columna + i, c.y + fila + j);
                    tonos.insert(original.g);
                    for (const int borde : {0, c.aumento - 1}) {
                        const Pixel visto = pixel(imagen, c.x + esquina + c.aumento * i + borde,
                                                  c.y + esquina + c.aumento * j + borde);
                        ASSERT_EQ(visto.g, original.g) << guion << " " << c.ancho << ": " << i << "," << j;
                    }
                }
            EXPECT_GE(tonos.size(), guion[6] == '1' ? 2u : 4u) << guion;
        }
}

TEST(Antialiasing, CambiarDeTamanoYCualquierTalla) {
    const Ejecucion directa = ejecuta("ch09_imagen/antialiasing", "tecla v", 240, 180),
                    cambiada =
                        ejecuta("ch09_imagen/antialiasing", "tecla v; tamano 77 33; tamano 240 180", 90, 90);
    EXPECT_EQ(directa.imagen.rgb, cambiada.imagen.rgb);
    EXPECT_EQ(ejecuta("ch09_imagen/antialiasing", "tecla v", 1, 1).estado, 0);
}

// --- ampliacion ---

TEST(Ampliacion, LaProporcionSeConserva) {
    for (const float imagen : {0.01f, 0.75f, 1.0f, 1.3f, 100.0f})
        for (const float area : {0.01f, 0.5f, 1.0f, 1.78f, 100.0f}) {
            const glm::vec2 e = proporcion(imagen, area);
            EXPECT_NEAR(static_cast<double>(e.x * area / e.y / imagen), 1, 1e-6);
            EXPECT_EQ(std::max(e.x, e.y), 1.0f);
        }
}

// Un rectángulo rojo de 40 × 20 en ventanas de varias formas y factores: lo que mide en píxeles.
TEST(Ampliacion, LoQueMideEnPixeles) {
    const std::string roja = escribe(imagen(40, 20, [](int, int) { return Pixel{255, 0, 0}; }));
    const struct {
        int ancho, alto;
        std::string guion;
        int anchoRojo, altoRojo;
    } casos[] = {{80, 80, "tecla -; tecla -", 40, 20},
                 {160, 60, "tecla -; tecla -", 60, 30},
                 {80, 80, "", 80, 40},
                 {160, 160, repite("tecla -", 4), 40, 20},
                 {80, 80, "tecla +; tecla +", 80, 80}};
    for (const auto &c : casos)
        for (const std::string f : {"", "tecla f"}) {
            const std::string guion = c.guion + (c.guion.empty() || f.empty() ? "" : "; ") + f;
            const Imagen i = ejecuta("ch09_imagen/ampliacion", guion, c.ancho, c.alto, {roja}).imagen;
            int ancho = 0, alto = 0;
            for (int x = 0; x < c.ancho; ++x)
                ancho += pixel(i, x, c.alto / 2).r == 255;
            for (int y = 0; y < c.alto; ++y)
                alto += pixel(i, c.ancho / 2, y).r == 255;
            EXPECT_EQ(ancho, c.anchoRojo) << c.ancho << "×" << c.alto << " " << guion;
            EXPECT_EQ(alto, c.altoRojo) << c.ancho << "×" << c.alto << " " << guion;
        }
    EXPECT_EQ(procesa("ampliacion", {A}, "tecla f").rgb, A.rgb);
}

// Dos texels en 40 píxeles: con el vecino, cada mitad es de un color; con el lineal se pasa de uno a otro.
TEST(Ampliacion, VecinoYLineal) {
    const std::string dos = escribe(imagen(2, 1, [](int x, int) { return Pixel{200 * x, 0, 0}; }));
    const Imagen lineal = ejecuta("ch09_imagen/ampliacion", "", 40, 20, {dos}).imagen,
                 vecino = ejecuta("ch09_imagen/ampliacion", "tecla f", 40, 20, {dos}).imagen;
    for (int x = 0; x < 40; ++x) {
        EXPECT_EQ(pixel(vecino, x, 10).r, x < 20 ? 0 : 200) << x;
        EXPECT_NEAR(pixel(lineal, x, 10).r, std::clamp(200 * ((x + 0.5) / 20 - 0.5), 0.0, 200.0), 1) << x;
    }
}

// --- captura ---

TEST(Captura, ElFicheroEsElFramebuffer) {
    const std::string fichero = (carpetaTemporal() / "captura.ppm").string();
    for (const auto &[ancho, alto] :
         {std::pair(241, 181), {7, 5}, {1, 1}}) { // anchos que no son múltiplos de 4
        const Imagen sin = ejecuta("ch09_imagen/captura", "tecla d", ancho, alto).imagen;
        const Ejecucion e = ejecuta("ch09_imagen/captura", "tecla d; tecla g", ancho, alto, {fichero});
        ASSERT_EQ(e.estado, 0) << e.errores;
        EXPECT_EQ(e.errores, "");
        EXPECT_EQ(leePpm(fichero).rgb, sin.rgb);
    }
}

// Se guarda la escena, sin lo que se enseña de la captura anterior; y la última, si la escena ha cambiado.
TEST(Captura, LaSegundaNoIncluyeLaPrimera) {
    const std::string fichero = (carpetaTemporal() / "captura3.ppm").string();
    const Imagen sin = ejecuta("ch09_imagen/captura", "tecla d").imagen;
    ejecuta("ch09_imagen/captura", "tecla g; tecla d; tecla g", 240, 180, {fichero});
    EXPECT_EQ(leePpm(fichero).rgb, sin.rgb);
}

// Lo que hay en la esquina es lo leído: la zona de la carga, en pequeño.
TEST(Captura, LaEsquinaEnsenaLoLeido) {
    const std::string fichero = (carpetaTemporal() / "captura2.ppm").string();
    const Imagen i = ejecuta("ch09_imagen/captura", "tecla g", 960, 720, {fichero}).imagen,
                 sin = leePpm(fichero);
    double peor = 0; // 320 × 240 en (24, 702 − 240): se compara en lo liso, dentro del cielo y del brazo
    int lisos = 0;
    for (int y = 2; y < 238; y += 3)
        for (int x = 2; x < 318; x += 3) {
            const Pixel a = pixel(sin, 3 * x + 1, 3 * y + 1), b = pixel(sin, 3 * x - 4, 3 * y - 4),
                        c = pixel(sin, 3 * x + 6, 3 * y + 6), p = pixel(i, 24 + x, 462 + y);
            if (std::abs(a.r - b.r) + std::abs(a.r - c.r) > 0)
                continue;
            ++lisos;
            peor = std::max<double>(peor, std::abs(p.r - a.r));
        }
    EXPECT_GT(lisos, 3000);
    EXPECT_LE(peor, 2);
    EXPECT_EQ(buscaRotulo(i, U"960×720, idéntica", OSCURO, celdaDe(960, 720, 0.03)).size(), 1u);
}

// Disco lleno o fichero que no cabe: se dice, y no queda nada a medias.
TEST(Captura, DiscoLleno) {
    const Ejecucion e = ejecuta("ch09_imagen/captura", "tecla g", 240, 180, {"/dev/full"});
    EXPECT_NE(e.errores.find("no puedo guardar «/dev/full»"), std::string::npos) << e.errores;
    const fs::path carpeta = carpetaTemporal() / "sin_sitio";
    fs::create_directory(carpeta);
    const std::string orden =
        "cd " + carpeta.string() +
        " && bash -c 'trap \"\" XFSZ; ulimit -f 8; exec " LAB_EJECUTABLES
        "/ch09_imagen/captura -guion \"tecla g\" -ppm imagen.ppm c.ppm' 2>errores >salida";
    EXPECT_NE(std::system(orden.c_str()), 0); // tampoco cabe la imagen final
    EXPECT_FALSE(fs::exists(carpeta / "c.ppm"));
    for (const auto &f : fs::directory_iterator(carpeta))
        EXPECT_TRUE(f.path().filename() == "errores" || f.path().filename() == "salida") << f.path();
}
