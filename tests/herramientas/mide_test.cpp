// Las cuentas de herramientas/mide/mide.cpp, frente a un caso resuelto a mano.
#define main mainDeMide
#include "mide/mide.cpp"
#undef main
#include "ejecuta.h"
#include <chrono>
#include <ctime>
#include <thread>

static void gasta(double ms) {
    for (const std::clock_t antes = std::clock(); double(std::clock() - antes) < 1e-3 * ms * CLOCKS_PER_SEC;)
        continue;
}

/// Mil unidades en 20 ms de procesador son 20 µs cada una, y lo que se espera sin gastarlo no cuenta.
TEST(Mide, ElTiempoDeUnaUnidad) {
    Medidor m(true, nanosegundos("µs por punto"), carpetaTemporal() / "t");
    m.grupo = "g";
    m.variante("a", "", 0.5, 1000, [&] {
        gasta(20);
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    });
    const std::vector<Medida> v = m.corre();
    ASSERT_EQ(v.size(), 1u);
    ASSERT_EQ(v[0].tiempos.size(), 1u); // en el ensayo, una ronda
    EXPECT_GE(v[0].tiempos[0], 19.9);
    EXPECT_LT(v[0].tiempos[0], 60);
    EXPECT_EQ(v[0].error, 0.5);
    EXPECT_EQ(v[0].grupo, "g");
    EXPECT_EQ(nanosegundos("ns por punto"), 1);
    EXPECT_EQ(nanosegundos("ms por imagen"), 1e6);
}

/// Al medir, todas en cada ronda, cada una en su proceso: lo que una cambie no lo ve otra, ni quien mide.
TEST(Mide, PorRondasYCadaUnaEnSuProceso) {
    Medidor m(false, 1e6, carpetaTemporal() / "t");
    int cuantas = 1;
    for (const double ms : {1, 3})
        m.variante(std::to_string(ms), "", 0, 1, [&cuantas, ms] {
            gasta(ms * cuantas);
            cuantas = 1;
        });
    cuantas = 100; // ya no es de ninguna
    const std::vector<Medida> v = m.corre();
    ASSERT_EQ(v.size(), 2u);
    for (std::size_t i = 0; i < v.size(); ++i) {
        const double ms = i ? 3 : 1;
        ASSERT_EQ(v[i].tiempos.size(), std::size_t(RONDAS));
        EXPECT_GE(*std::min_element(v[i].tiempos.begin(), v[i].tiempos.end()), 0.99 * ms);
        // no todos: el reloj del procesador cuenta también lo que se le quita a una máquina virtual
        EXPECT_LT(mediana(v[i].tiempos), 1.3 * ms);
    }
    EXPECT_EQ(cuantas, 100);
}

/// Una que se muere no es un tiempo.
TEST(Mide, LaQueNoAcaba) {
    Medidor m(true, 1e3, "");
    m.variante("b", "", 1, 1, [] { std::abort(); });
    EXPECT_EXIT(m.corre(), testing::ExitedWithCode(1), "ha acabado antes de tiempo");
}

TEST(Mide, ErrorYDiferenciaDeDosImagenes) {
    const Imagen a{1, 2, {0, 10, 20, 30, 40, 255}}, b{1, 2, {3, 10, 20, 34, 40, 0}};
    EXPECT_DOUBLE_EQ(rmse(a, std::vector<double>{0.5, 10, 20, 30, 40, 255}), 0.5 / std::sqrt(6));
    EXPECT_EQ(diferencia(a, b).rgb, std::vector<unsigned char>({104, 128, 128, 96, 128, 255}));
    EXPECT_EQ(redondeada(1, 1, {-3, 1.6, 300}).rgb, std::vector<unsigned char>({0, 2, 255}));
}

/// Lo suyo y lo del sistema, y no los ratos en que espera.
TEST(Mide, LoQueTardaOtroPrograma) {
    const char *const gasta = "python3 -c \"import os\nwhile sum(os.times()[:2]) < 0.1: os.stat('.')\"";
    EXPECT_GE(nsDe([&] { EXPECT_EQ(std::system(gasta), 0); }), 100e6);
    EXPECT_LT(nsDe([] { EXPECT_EQ(std::system("sleep 0.2"), 0); }), 150e6);
}

TEST(Mide, LoQueNoCabeEnElDiscoSeDice) {
    const Tecnica t{1, "lleno", "", "ms", "", "", "", [](Medidor &m) { m.variante("a", "", 0, 1, [] {}); }};
    std::filesystem::create_symlink("/dev/full", carpetaTemporal() / "lleno.tsv");
    EXPECT_EXIT(corre(t, true, carpetaTemporal()), testing::ExitedWithCode(1), "no puedo escribir");
}

// Cada imagen, con el número de su variante, desde 1; y su diferencia.
TEST(Mide, CadaImagenEsDeSuVariante) {
    Medidor m(true, 1, carpetaTemporal() / "i");
    m.referencia = {1, 1, {10, 10, 10}};
    for (unsigned char nivel = 11; nivel < 14; ++nivel)
        m.variante(std::to_string(nivel), "", 0, 1, [] {}, {1, 1, {nivel, 10, 10}});
    for (const int n : {1, 2, 3}) {
        const std::string base = (carpetaTemporal() / "i").string() + "-" + std::to_string(n);
        EXPECT_EQ(leePpm(base + ".ppm").rgb[0], 10 + n);
        EXPECT_EQ(leePpm(base + "-diferencia.ppm").rgb[0], 128 + 8 * n);
    }
    EXPECT_FALSE(std::filesystem::exists(carpetaTemporal() / "i-0.ppm"));
}
