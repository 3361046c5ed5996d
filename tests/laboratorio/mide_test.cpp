// Las cuentas de herramientas/mide/mide.cpp, frente a un caso resuelto a mano.
#define main mainDeMide
#include "mide/mide.cpp"
#undef main
#include "ejecuta.h"
#include <fstream>
#include <gtest/gtest.h>
#include <thread>

/// Mil unidades en 20 ms son 20 µs cada una; otra cuenta se aparta mil veces, o más.
TEST(Mide, ElTiempoDeUnaUnidad) {
    int veces = 0;
    Medidor m(true, nanosegundos("µs por punto"), carpetaTemporal() / "t");
    m.grupo = "g";
    m.variante("a", 0.5, 1000, [&] {
        ++veces;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    });
    ASSERT_EQ(m.hechas().size(), 1u);
    const Medida &v = m.hechas()[0];
    EXPECT_GE(v.minimo, 20);
    EXPECT_LT(v.mediana, 2000);
    EXPECT_EQ(v.error, 0.5);
    EXPECT_EQ(v.grupo, "g");
    EXPECT_EQ(veces, 2); // una en caliente y, en el ensayo, otra
    EXPECT_EQ(nanosegundos("ns por punto"), 1);
    EXPECT_EQ(nanosegundos("ms por imagen"), 1e6);
}

TEST(Mide, MedianaMinimoYMaximo) {
    Medidor m(true, 1, "");
    m.yaMedida("a", 1, {9, 2, 4}, "n");
    const Medida &v = m.hechas()[0];
    EXPECT_EQ(std::vector<double>({v.mediana, v.minimo, v.maximo}), std::vector<double>({4, 2, 9}));
}

TEST(Mide, ErrorYDiferenciaDeDosImagenes) {
    const Imagen a{1, 2, {0, 10, 20, 30, 40, 255}}, b{1, 2, {3, 10, 20, 34, 40, 0}};
    EXPECT_DOUBLE_EQ(rmse(a, b), std::sqrt((9 + 16 + 255 * 255) / 6.0));
    EXPECT_DOUBLE_EQ(rmse(a, std::vector<double>{0.5, 10, 20, 30, 40, 255}), 0.5 / std::sqrt(6));
    EXPECT_EQ(diferencia(a, b).rgb, std::vector<unsigned char>({104, 128, 128, 96, 128, 255}));
    EXPECT_EQ(redondeada(1, 1, {-3, 1.6, 300}).rgb, std::vector<unsigned char>({0, 2, 255}));
}

/// Los argumentos llegan tal cual, se llame como se llame la carpeta; y un programa que falla o que no está no es un tiempo.
TEST(Mide, LoQueTardaOtroPrograma) {
    const auto peor = carpetaTemporal() / "x';touch pwned;'y $(touch pwned)";
    EXPECT_GE(milisegundosDeOrden({"touch", peor}), 0);
    EXPECT_TRUE(std::filesystem::exists(peor));
    EXPECT_GE(milisegundosDeOrden({"sleep", "0.02"}), 20);
    EXPECT_TRUE(std::isnan(milisegundosDeOrden({"false"})));
    EXPECT_TRUE(std::isnan(milisegundosDeOrden({"noesta"})));
}

TEST(Mide, LaFilaDeUnaVariante) {
    const Tecnica t{1, "t", "", "ms", "", "", "", [](Medidor &m) {
                        m.yaMedida("a", 0.5, {3, 1, 2}, "");
                        m.grupo = "g";
                        m.yaMedida("b", NAN, {4}, "nota");
                    }};
    EXPECT_EQ(corre(t, true, carpetaTemporal()), 0);
    std::ifstream f(carpetaTemporal() / "t.tsv");
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(f), {}),
              "a\t-\t2\t1\t3\t0.5\t-\nb\tg\t4\t4\t4\tnan\tnota\n");
}
