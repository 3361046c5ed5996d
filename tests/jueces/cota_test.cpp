// Los casos difíciles no pasan por encima de su cota, ni con lo que no es un número.
#include "casos_dificiles/cota.h"
#include "falla.h"

TEST(Cota, LoQuePasaDeEllaYLoQueNoEsUnNumero) {
    for (const auto &[medida, mal] : {std::pair(1.0, false),
                                      {-5.0, false},
                                      {1.0001, true},
                                      {double(NAN), true},
                                      {double(INFINITY), true}}) {
        Acotada a(1, "u", [x = medida] { return x; });
        EXPECT_EQ(falla([&] { a.TestBody(); }), mal) << medida;
    }
    for (int i = 0; i < 3; ++i) {
        const auto con = [i](double x) { return [i, x](int k) { return k == i ? x : 1.0; }; };
        EXPECT_EQ(peorHasta(3, con(2)), 2);
        EXPECT_TRUE(std::isnan(peorHasta(3, con(NAN)))) << i;
        glm::dvec3 v(1);
        v[i] = -4;
        EXPECT_EQ(mayorComponente(v), 4) << i;
    }
    EXPECT_TRUE(std::isnan(peorHasta(0, [](int) { return 0.0; })));
}
