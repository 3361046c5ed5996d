// Comprobaciones independientes de zbuffer y del algoritmo Z-Buffer en la CPU (zbuffer.h).
#include "ch04_oraculo.h"
#include "ch04_vista3d/zbuffer.h"
#include <algorithm>
#include <gtest/gtest.h>
#include <iostream>
#include <random>

namespace {

using oraculo::Impacto;
using oraculo::Vec3;

const char *const PROGRAMA = "ch04_vista3d/zbuffer";

/// La escena del programa, escrita otra vez, con sólidos exactos.
oraculo::Escena escena() {
    using namespace oraculo;
    const Mat4 vertical = gira({1, 0, 0}, -PI / 2);
    return {
        caja(traslada({0, -0.1, 0}) * escala({9.6, 0.2, 7})),
        caja(traslada({-1, 1.3, 1}) * gira({0, 1, 0}, 0.35) * escala(2.6)),
        esfera(traslada({-0.7, 2.6, 1.2}) * escala(1.1)),
        cilindro(traslada({2.6, 2.1, -0.6}) * vertical * escala({0.5, 0.5, 4.2})),
        toro(traslada({2.6, 2.4, -0.6}) * gira({1, 0, 0}, 0.45) * vertical, 1.4, 0.35),
        cono(traslada({-2, 0, -1.9}) * vertical * escala({1.5, 1.5, 4.8})),
    };
}

oraculo::Camara camaraDe(double azimut, double elevacion, double distancia) {
    return oraculo::perspectiva(oraculo::orbita(azimut, elevacion, distancia, {0, 1.1, 0}), 0.5, 1, 100);
}

oraculo::ImagenRef referencia(double azimut, double elevacion, double distancia, int ancho = 240,
                              int alto = 180) {
    const glm::vec3 colores[] = {SUELO, ROJO, AMARILLO, AZUL, NARANJA, VERDE};
    return oraculo::render(escena(), camaraDe(azimut, elevacion, distancia), ancho, alto,
                           [&](const Impacto &i) {
                               return i ? luzExacta(i.normal) * vec3De(colores[i.objeto]) : vec3De(CIELO);
                           });
}

/// El rótulo de abajo a la izquierda no se compara.
void sinRotulo(oraculo::ImagenRef &ref, const Imagen &imagen) {
    daPorBuenos(ref, imagen, [](int x, int y) { return x < 82 && y < 20; });
}

/// Píxeles distintos entre dos imágenes (más de un nivel) y longitud en píxeles de los bordes de la primera:
/// los pares de vecinos que se diferencian en más de 8 niveles.
struct Recuento {
    int distintos = 0, bordes = 0;
};
Recuento cuenta(const Imagen &a, const Imagen &b) {
    Recuento r;
    const auto diferencia = [](const Pixel &p, const Pixel &q) {
        return std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
    };
    for (int y = 0; y < a.alto; ++y)
        for (int x = 0; x < a.ancho; ++x) {
            const Pixel p = pixel(a, x, y);
            r.distintos += diferencia(p, pixel(b, x, y)) > 1;
            r.bordes += x > 0 && diferencia(p, pixel(a, x - 1, y)) > 8;
            r.bordes += y > 0 && diferencia(p, pixel(a, x, y - 1)) > 8;
        }
    return r;
}

} // namespace

// La GPU y la CPU, cada una contra el trazado de rayos en doble: el orden de visibilidad es el bueno. Las mallas tienen
// caras: la normal del cono salta en su vértice media cara, sen(π/48)·0.42·255·0.62 = 4.3 niveles, y la interpolada del tubo
// del toro, de 24 lados, es (1 − cos(π/24))·0.42·255·0.95 = 0.9 más corta. Y esas caras y los vértices redondeados a 1/256 mueven los contornos
// hasta 0.08 píxeles, 0.04 de media: en la banda, de dos píxeles, difieren como mucho 1 de cada 50.
TEST(ZBuffer, GpuYCpuContraTrazadoDeRayos) {
    oraculo::ImagenRef ref = referencia(0.55, 0.45, 18.6);
    for (const char *guion : {"", "tecla c"}) {
        const Ejecucion e = ejecuta(PROGRAMA, guion);
        ASSERT_EQ(e.estado, 0) << e.errores;
        sinRotulo(ref, e.imagen);
        const oraculo::Comparacion c = compara(e.imagen, ref, 5);
        std::cout << (*guion ? "CPU: " : "GPU: ") << c << "\n";
        EXPECT_LE(c.maximo, 5) << c;
        EXPECT_LE(c.rmse, 0.6) << c;
        EXPECT_LE(c.bandaDistintos, c.banda / 50) << c;
    }
}

// Los cuatro paneles: por columnas sin test y con él, por filas GPU y CPU; y lo que dice cada rótulo.
TEST(ZBuffer, LosCuatroPaneles) {
    const Ejecucion e = ejecuta(PROGRAMA, "tecla v", 480, 360);
    ASSERT_EQ(e.estado, 0) << e.errores;
    std::vector<Imagen> sueltos;
    for (const char *guion : {"tecla z", "", "tecla z; tecla c", "tecla c"}) {
        sueltos.push_back(ejecuta(PROGRAMA, guion, 480, 360).imagen);
    }
    const char32_t *const rotulos[] = {U"GPU sin test", U"GPU con test", U"CPU sin test", U"CPU con test"};
    for (int k = 0; k < 4; ++k) {
        const Hueco h = hueco(k % 2, 2, k / 2, 2, 480, 360);
        const Imagen panel = recorta(e.imagen, h);
        oraculo::ImagenRef ref = referencia(0.55, 0.45, 18.6, h.ancho, h.alto);
        const std::size_t suelto = static_cast<std::size_t>(k);
        daPorBuenos(ref, panel, [](int x, int y) { return x < 155 && y < 30; });
        const oraculo::Comparacion c = compara(panel, ref, 5);
        EXPECT_EQ(c.maximo <= 5, k % 2 == 1) << k << ": " << c; // solo con test está bien
        for (int otro = 0; otro < 4; ++otro) {
            const std::size_t cuantos = buscaRotulo(panel, rotulos[otro], OSCURO, celdaDe(480, 360)).size();
            EXPECT_EQ(cuantos, otro == k ? 1u : 0u) << k << " " << otro;
        }
        EXPECT_EQ(buscaRotulo(sueltos[suelto], rotulos[k], OSCURO).size(), 1u) << k;
    }
    // sin test, en la CPU y en la GPU, el cono tapa: la misma imagen por columnas
    for (int columna = 0; columna < 2; ++columna) {
        Imagen gpu = recorta(e.imagen, hueco(columna, 2, 0, 2, 480, 360)),
               cpu = recorta(e.imagen, hueco(columna, 2, 1, 2, 480, 360));
        int distintos = 0;
        for (int y = 30; y < gpu.alto; ++y)
            for (int x = 0; x < gpu.ancho; ++x) {
                const Pixel p = pixel(gpu, x, y), q = pixel(cpu, x, y);
                distintos += std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)}) > 1;
            }
        EXPECT_LE(distintos, 40) << columna;
    }
}

// La CPU y la GPU, píxel a píxel. En el interior no difieren en más de un nivel; en los bordes, por lo mismo de
// antes, en 1/90 píxeles por píxel de longitud. `ref`, si la hay, dice cuál es el interior.
static void coinciden(const std::string &guion, const oraculo::ImagenRef *ref) {
    const Ejecucion gpu = ejecuta(PROGRAMA, guion), cpu = ejecuta(PROGRAMA, guion + "tecla c");
    ASSERT_EQ(gpu.estado, 0) << gpu.errores;
    ASSERT_EQ(cpu.estado, 0) << cpu.errores;
    const Recuento r = cuenta(gpu.imagen, cpu.imagen);
    std::cout << r.distintos << " distintos en " << r.bordes << " px de borde\n";
    EXPECT_GT(r.bordes, 500);
    EXPECT_LE(r.distintos, r.bordes / 90.0 + 60); // y el rótulo, que difiere en la G y la C
    int interior = 0, malos = 0;
    for (int y = 1; ref && y < ref->alto - 1; ++y)
        for (int x = 1; x < ref->ancho - 1; ++x) {
            bool borde = x < 82 && y < 20; // el rótulo
            for (int k = 0; k < 9; ++k)
                borde = borde || hayBorde(ref->en(x, y), ref->en(x - 1 + k % 3, y - 1 + k / 3));
            const Pixel p = pixel(gpu.imagen, x, y), q = pixel(cpu.imagen, x, y);
            const int d = std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
            malos += !borde && d > 1; // en las aristas de las mallas, que la referencia no tiene
            interior += !borde;
        }
    EXPECT_LE(malos, 3);
    EXPECT_TRUE(!ref || interior > 30000) << interior;
}

TEST(ZBuffer, CpuYGpuCoinciden) {
    const oraculo::ImagenRef ref = referencia(0.55, 0.45, 18.6);
    coinciden("", &ref);
}

TEST(ZBuffer, CpuYGpuCoincidenTrasGirar) {
    const oraculo::ImagenRef ref = referencia(0.55 - 1.5, 0.45 - 0.3, 18.6);
    coinciden("boton IZQUIERDO abajo 10 50; arrastra 160 20; boton IZQUIERDO arriba 160 20; ", &ref);
}

TEST(ZBuffer, CpuYGpuCoincidenSinTest) {
    coinciden("tecla z; ", nullptr);
}

// Con la rueda se entra en la escena: el plano cerca corta los sólidos.
TEST(ZBuffer, CpuYGpuCoincidenDentroDeLaEscena) {
    std::string guion;
    for (int i = 0; i < 18; ++i)
        guion += "rueda +1 120 90; ";
    const oraculo::ImagenRef ref = referencia(0.55, 0.45, std::max(18.6 / std::pow(1.1, 18), 0.4 * 18.6));
    coinciden(guion, &ref);
}

// Sin test gana lo último que se pinta, el cono, que es lo más lejano: su silueta entera es verde.
TEST(ZBuffer, SinTestGanaElUltimo) {
    const oraculo::Escena solidos = escena(), soloElCono = {solidos.back()};
    const oraculo::Camara camara = camaraDe(0.55, 0.45, 18.6);
    const Ejecucion sin = ejecuta(PROGRAMA, "tecla z"), con = ejecuta(PROGRAMA);
    ASSERT_EQ(sin.estado, 0) << sin.errores;
    int verdes = 0, tapados = 0;
    for (int y = 0; y < 180; ++y)
        for (int x = 0; x < 240; ++x) {
            const auto cerca = [&](double dx, double dy) {
                return static_cast<bool>(
                    primerImpacto(soloElCono, rayo(camara, 240, 180, x + 0.5 + dx, y + 0.5 + dy)));
            };
            if (!cerca(-1, -1) || !cerca(1, -1) || !cerca(-1, 1) || !cerca(1, 1))
                continue;
            const Pixel p = pixel(sin.imagen, x, y), q = pixel(con.imagen, x, y);
            ASSERT_TRUE(p.g > p.r && p.g > p.b) << x << "," << y;
            ++verdes;
            tapados += !(q.g > 1.5 * q.r && q.g > 1.5 * q.b);
        }
    std::cout << "cono: " << verdes << " px, " << tapados << " deberían estar tapados\n";
    EXPECT_GT(tapados, 500);
}

namespace {

const glm::vec3 NEGRO(0);

/// Triángulo en el plano z = 0 de una ventana ancho × alto, dado por sus esquinas en píxeles.
TrianguloZ enPixeles(const double (&p)[3][2], int ancho, int alto, float z = 0,
                     const glm::vec3 &color = BLANCO) {
    TrianguloZ t;
    for (std::size_t i = 0; i < 3; ++i)
        t[i] = {{2 * p[i][0] / ancho - 1, 2 * p[i][1] / alto - 1, z, 1}, color};
    return t;
}

} // namespace

// Cobertura contra los semiplanos en doble; lo que está a menos de 1/256 de un lado depende del redondeo.
TEST(Rasteriza, CoberturaContraSemiplanos) {
    std::mt19937 azar(1);
    std::uniform_real_distribution<double> coordenada(-20, 60);
    int comparados = 0;
    for (int n = 0; n < 300; ++n) {
        double p[3][2];
        oraculo::Poligono poligono;
        for (auto &q : p) {
            q[0] = coordenada(azar), q[1] = coordenada(azar);
            poligono.push_back({q[0], q[1]});
        }
        BufferZ b = creaBufferZ(40, 30, NEGRO);
        pintaTriangulo(b, enPixeles(p, 40, 30));
        for (int y = 0; y < 30; ++y)
            for (int x = 0; x < 40; ++x) {
                const double d = distanciaDentro(poligono, x + 0.5, y + 0.5);
                if (std::fabs(d) < 1.0 / 256)
                    continue;
                ASSERT_EQ(pixel(b.color, x, y).r, d > 0 ? 255 : 0) << n << ": " << x << "," << y;
                ++comparados;
            }
    }
    EXPECT_GT(comparados, 350000);
}

// Una rejilla de triángulos con los vértices en centros y esquinas de píxel, para que muchos centros caigan
// justo en un lado: cada píxel lo pinta exactamente un triángulo.
TEST(Rasteriza, NiHuecosNiDobles) {
    std::mt19937 azar(2);
    const int ancho = 24, alto = 18, n = 6;
    for (int vez = 0; vez < 20; ++vez) {
        double v[n + 1][n + 1][2];
        for (int j = 0; j <= n; ++j)
            for (int i = 0; i <= n; ++i) {
                const auto mueve = [&](int k) {
                    return k % n ? 0.5 * (static_cast<int>(azar() % 5) - 2) : 0.0;
                };
                v[j][i][0] = 4 * i + mueve(i), v[j][i][1] = 3 * j + mueve(j) / 2;
            }
        std::vector<int> veces(ancho * alto);
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i)
                for (int k = 0; k < 2; ++k) {
                    const double *a = v[j][i], *b = v[j + 1][i + 1], *c = k ? v[j + 1][i] : v[j][i + 1];
                    const double t[3][2] = {{a[0], a[1]}, {b[0], b[1]}, {c[0], c[1]}};
                    BufferZ buffer = creaBufferZ(ancho, alto, NEGRO);
                    pintaTriangulo(buffer, enPixeles(t, ancho, alto));
                    for (int p = 0; p < ancho * alto; ++p)
                        veces[static_cast<std::size_t>(p)] += pixel(buffer.color, p % ancho, p / ancho).r > 0;
                }
        for (int p = 0; p < ancho * alto; ++p)
            ASSERT_EQ(veces[static_cast<std::size_t>(p)], 1) << vez << ": " << p % ancho << "," << p / ancho;
    }
}

// Listado 4.1: a igual profundidad se queda el primero (es `<`, no `<=`), y al quedarse se guarda su profundidad.
TEST(ZBufferCpu, AIgualProfundidadSeQuedaElPrimero) {
    BufferZ b = creaBufferZ(1, 1, NEGRO);
    const auto pinta = [&](float z, const glm::vec3 &color) {
        pintaFragmento(b, 0, 0, z, color);
        return pixel(b.color, 0, 0);
    };
    pinta(1.0f, BLANCO); // la máxima tampoco es menor que la máxima
    EXPECT_EQ(pixel(b.color, 0, 0).r, 0);
    EXPECT_EQ(pinta(0.5f, {1, 0, 0}).r, 255);
    EXPECT_EQ(b.profundidad[0], 0.5f);
    EXPECT_EQ(pinta(0.5f, {0, 1, 0}).g, 0);
    EXPECT_EQ(pinta(0.75f, {0, 1, 0}).g, 0);
    EXPECT_EQ(pinta(0.25f, {0, 1, 0}).g, 255);
    EXPECT_EQ(b.profundidad[0], 0.25f);
}

// §4.4: no importa el orden en que se pintan las primitivas. Sin test sí importa.
TEST(ZBufferCpu, ElOrdenNoImporta) {
    std::mt19937 azar(3);
    std::uniform_real_distribution<float> u(-1, 1);
    std::vector<TrianguloZ> triangulos(60);
    for (TrianguloZ &t : triangulos)
        for (VerticeZ &v : t)
            v = {{u(azar), u(azar), u(azar), 1},
                 {std::fabs(u(azar)), std::fabs(u(azar)), std::fabs(u(azar))}};
    for (const bool test : {true, false}) {
        std::vector<std::vector<unsigned char>> imagenes;
        for (int vez = 0; vez < 5; ++vez) {
            std::shuffle(triangulos.begin(), triangulos.end(), azar);
            BufferZ b = creaBufferZ(64, 48, NEGRO, test);
            for (const TrianguloZ &t : triangulos)
                pintaTriangulo(b, t);
            imagenes.push_back(b.color.rgb);
        }
        for (const auto &imagen : imagenes)
            EXPECT_EQ(imagen == imagenes[0], test || &imagen == &imagenes[0]);
    }
}

// Un suelo que empieza detrás de la cámara y acaba más allá de lejos: color y profundidad de cada píxel contra
// el corte exacto de su rayo, en doble. Cámara en el origen a altura 1, cerca 0.5, lejos 21, ángulo de 90°.
TEST(ZBufferCpu, RecortadoColorYProfundidadContraElRayo) {
    const int lado = 60;
    const double cerca = 0.5, lejos = 21;
    const auto proyecta = [&](double x, double z) { // el suelo es y = −1; el color, u de 0 a 1 a lo largo
        const double zRecortado =
            -(lejos + cerca) / (lejos - cerca) * z - 2 * lejos * cerca / (lejos - cerca);
        return VerticeZ{{x, -1, zRecortado, -z}, {(x + 40) / 80, (30 - z) / 60, 0.5}};
    };
    BufferZ b = creaBufferZ(lado, lado, NEGRO);
    pintaTriangulo(b, {proyecta(-40, 30), proyecta(40, 30), proyecta(40, -30)});
    pintaTriangulo(b, {proyecta(-40, 30), proyecta(40, -30), proyecta(-40, -30)});
    double peor = 0;
    int pintados = 0;
    for (int y = 0; y < lado; ++y)
        for (int x = 0; x < lado; ++x) {
            const double px = (x + 0.5) / (lado / 2.0) - 1, py = (y + 0.5) / (lado / 2.0) - 1;
            const double d = py < 0 ? -1 / py : 1e9; // distancia a la que el rayo (px, py, −1) toca el suelo
            const Pixel p = pixel(b.color, x, y);
            const float z = b.profundidad[static_cast<std::size_t>(y * lado + x)];
            if (d > lejos || std::fabs(px * d) > 40) {
                ASSERT_EQ(p.b, 0) << x << "," << y;
                ASSERT_EQ(z, 1);
                continue;
            }
            ASSERT_GE(d, 1);
            ++pintados;
            ASSERT_NEAR(p.r, 255 * (px * d + 40) / 80, 1) << x << "," << y;
            ASSERT_NEAR(p.g, 255 * (d + 30) / 60, 1) << x << "," << y;
            ASSERT_EQ(p.b, 128);
            const double exacta = lejos / (lejos - cerca) * (1 - cerca / d);
            peor = std::max(peor, std::fabs(static_cast<double>(z) - exacta));
        }
    std::cout << pintados << " px; profundidad: error máximo " << peor << "\n";
    EXPECT_GT(pintados, lado * lado * 4 / 10);
    // 1/256 de píxel en un vértice son 0.512·(1/30)/256 = 6.7e-5 de profundidad
    EXPECT_LT(peor, 7e-5);
}

// Lo que no se puede dibujar no se dibuja: sin área, detrás de la cámara, en el plano w = 0, fuera de la ventana.
TEST(ZBufferCpu, CasosDegenerados) {
    const BufferZ vacio = creaBufferZ(16, 9, NEGRO);
    const TrianguloZ casos[] = {
        {{{{0, 0, 0, 1}, BLANCO}, {{0, 0, 0, 1}, BLANCO}, {{0.5f, 0.5f, 0, 1}, BLANCO}}},
        {{{{-1, -1, 0, -1}, BLANCO}, {{1, -1, 0, -1}, BLANCO}, {{0, 1, 0, -1}, BLANCO}}},
        {{{{-1, -1, 0, 0}, BLANCO}, {{1, -1, 0, 0}, BLANCO}, {{0, 1, 0, 0}, BLANCO}}},
        {{{{3, 3, 0, 1}, BLANCO}, {{1e6f, 3, 0, 1}, BLANCO}, {{3, 1e6f, 0, 1}, BLANCO}}},
    };
    for (const TrianguloZ &t : casos)
        for (const bool test : {true, false}) {
            BufferZ b = creaBufferZ(16, 9, NEGRO, test);
            pintaTriangulo(b, t);
            EXPECT_EQ(b.color.rgb, vacio.color.rgb) << &t - casos;
            EXPECT_EQ(b.profundidad, vacio.profundidad) << &t - casos;
        }
}
