// Con lo que juzgan las pruebas de C++ (vocabulario/): da por bueno lo bueno y no, con una sola cosa mal, de cada
// componente, lado y clase. El oráculo, en oraculo_test.cpp.
#include "falla.h"
#include "imagenes.h"
#include "plana.h"

namespace {

const glm::vec3 TINTA(0.85f, 0.2f, 0.18f), OTRA(0.2f, 0.62f, 0.28f);
const std::vector<glm::dvec2> RAYA = {{10, 20}, {60, 20}, {60, 80}},
                              CORRIDAS = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};

Encima con(const std::string &tipo, const std::vector<glm::dvec2> &puntos, const glm::vec3 &color = TINTA) {
    Pintado p{tipo, color, {0, 0, 240, 180}, 2, false, {}, ""};
    for (const glm::dvec2 &v : puntos)
        p.puntos.emplace_back(v, 0);
    Encima encima;
    encima.push_back(p);
    return encima;
}

/// Las esquinas de una imagen y un píxel de en medio.
std::vector<glm::ivec2> sitios(const Imagen &i) {
    return {{0, 0}, {i.ancho - 1, 0}, {0, i.alto - 1}, {i.ancho - 1, i.alto - 1}, {i.ancho / 2, i.alto / 2}};
}

} // namespace

// Un aviso, un estado o que no haya imagen: de las tres maneras de pedirla.
TEST(Ejecuta, LoQueNoAcabaBienNoEsUnaImagen) {
    const std::string defectuoso = "../tests/defectuoso";
    for (const std::vector<std::string> &mal :
         {std::vector<std::string>{"uniforme"}, {"enum"}, {"-rasgos"}}) {
        EXPECT_THROW(imagenDe(defectuoso, "", 40, 30, mal), std::runtime_error) << mal[0];
        EXPECT_THROW(vistaDe(defectuoso, "", 40, 30, mal), std::runtime_error) << mal[0];
        EXPECT_THROW(vistasDe(defectuoso, {"", "tecla a"}, 40, 30, mal), std::runtime_error) << mal[0];
    }
    EXPECT_EQ(imagenDe(defectuoso, "", 40, 30).ancho, 40);
    EXPECT_THROW(ejecuta("noesta"), std::runtime_error);
}

TEST(Encima, UnTrazoEsEseYEstaEntero) {
    const Encima bueno = con("polilinea", RAYA);
    EXPECT_FALSE(falla([&] { compruebaTrazo(bueno, RAYA, TINTA); }));
    EXPECT_TRUE(falla([&] { compruebaTrazo(bueno, RAYA, OTRA); }));
    EXPECT_TRUE(falla([&] { compruebaTrazo({}, RAYA, TINTA); }));
    EXPECT_TRUE(falla([&] { compruebaTrazo(con("segmentos", RAYA), RAYA, TINTA); }));
    for (std::size_t i = 0; i < RAYA.size(); ++i)
        for (const glm::dvec2 &hacia : CORRIDAS)
            for (const double cuanto : {0.08, 0.12}) {
                auto corrida = RAYA;
                corrida[i] += cuanto * hacia;
                const Encima uno = con("polilinea", corrida);
                const bool alarga = (i == 0 && hacia.x < 0) || (i == 2 && hacia.y > 0);
                EXPECT_EQ(falla([&] { compruebaTrazo(uno, RAYA, TINTA); }), cuanto > 0.1 && !alarga) << i;
                if (alarga) {
                    EXPECT_EQ(falla([&] { compruebaTrazo(bueno, corrida, TINTA); }), cuanto > 0.1) << i;
                }
            }
}

TEST(Encima, LosPuntosSonEsosYEnEseOrden) {
    const Encima buenos = con("puntos", RAYA);
    EXPECT_FALSE(falla([&] { compruebaPuntos(buenos, RAYA, TINTA); }));
    EXPECT_TRUE(falla([&] { compruebaPuntos(buenos, RAYA, OTRA); }));
    EXPECT_TRUE(falla([&] { compruebaPuntos(buenos, {RAYA[0], RAYA[1]}, TINTA); }));
    EXPECT_TRUE(falla([&] { compruebaPuntos(buenos, {RAYA[0], RAYA[1], RAYA[2], RAYA[0]}, TINTA); }));
    EXPECT_TRUE(falla([&] { compruebaPuntos(buenos, {RAYA[1], RAYA[0], RAYA[2]}, TINTA); }));
    for (std::size_t i = 0; i < RAYA.size(); ++i)
        for (const glm::dvec2 &hacia : CORRIDAS)
            for (const double cuanto : {0.09, 0.11}) {
                auto corrida = RAYA;
                corrida[i] += cuanto * hacia;
                EXPECT_EQ(falla([&] { compruebaPuntos(buenos, corrida, TINTA); }), cuanto > 0.1) << i;
            }
}

// Un nivel de más o de menos, en cualquier componente de cualquier píxel; y la pieza corrida, o de otro orden.
TEST(Plana, CadaPixelEsDeLaUltimaPieza) {
    const std::vector<Pieza> piezas = {rectangulo({2, 2, 6, 5}, {0.2, 0.4, 0.6}),
                                       rectangulo({5, 4, 6, 5}, {0.6, 0.4, 0.2})};
    const oraculo::Vec3 fondo{0.8, 0.8, 0.8};
    const Imagen buena = imagen(12, 10, [](int x, int y) {
        return x >= 5 && x < 11 && y >= 4 && y < 9  ? Pixel{153, 102, 51}
               : x >= 2 && x < 8 && y >= 2 && y < 7 ? Pixel{51, 102, 153}
                                                    : Pixel{204, 204, 204};
    });
    EXPECT_FALSE(falla([&] { compruebaPlana("p", buena, piezas, fondo); }));
    EXPECT_TRUE(falla([&] { compruebaPlana("p", buena, {piezas[1], piezas[0]}, fondo); }));
    EXPECT_TRUE(falla([&] { compruebaPlana("p", buena, {piezas[0]}, fondo); }));
    EXPECT_TRUE(falla([&] { compruebaPlana("p", buena, {}, fondo); }));
    for (std::size_t i = 0; i < buena.rgb.size(); ++i)
        for (const int cuanto : {-1, 1}) {
            Imagen mala = buena;
            mala.rgb[i] = static_cast<unsigned char>(mala.rgb[i] + cuanto);
            EXPECT_TRUE(falla([&] { compruebaPlana("p", mala, piezas, fondo); })) << i;
        }
}

// Cada cota por separado: lo que la alcanza pasa, y lo que la pasa, o no es un número, no.
TEST(ContraOraculo, CadaCota) {
    oraculo::Comparacion bueno;
    bueno.interior = 5000, bueno.maximo = 0.5, bueno.rmse = 0.2;
    bueno.banda = 1000, bueno.bandaDistintos = 10, bueno.bandaLejos = 2, bueno.desvio = 0.5;
    const auto mal = [&](const std::function<void(oraculo::Comparacion &)> &cambia) {
        oraculo::Comparacion c = bueno;
        cambia(c);
        return falla([&] { comprueba("c", c, {0.501, 500, 0.6}); });
    };
    EXPECT_FALSE(mal([](auto &) {}));
    for (const double x : {0.502, double(NAN), double(INFINITY)})
        EXPECT_TRUE(mal([x](auto &c) { c.maximo = x; })) << x;
    for (const double x : {0.601, double(NAN), double(INFINITY)})
        EXPECT_TRUE(mal([x](auto &c) { c.desvio = x; })) << x;
    EXPECT_TRUE(mal([](auto &c) { c.bandaLejos = 3; }));
    EXPECT_TRUE(mal([](auto &c) { c.interior = c.banda; }));
    EXPECT_TRUE(mal([](auto &c) { c.interior = c.banda = c.bandaLejos = 0; }));
}

TEST(Imagenes, LoMasQueSeAparta) {
    const Imagen buena = lisa(5, 4, {100, 110, 120});
    EXPECT_EQ(diferenciaMaxima(buena, igualQue(buena)), 0);
    for (const glm::ivec2 &p : sitios(buena))
        for (int k = 0; k < 3; ++k)
            for (const int cuanto : {-7, 7}) {
                Imagen mala = buena;
                mala.rgb[std::size_t(3 * (p.y * 5 + p.x) + k)] += static_cast<unsigned char>(cuanto);
                EXPECT_EQ(diferenciaMaxima(mala, igualQue(buena)), 7) << p.x << " " << p.y << " " << k;
            }
}
