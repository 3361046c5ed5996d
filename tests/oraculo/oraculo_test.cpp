// El oráculo contra ecuaciones implícitas y fórmulas escritas aquí. El alto útil de la ventana, la órbita, el modelo
// de Phong y las sombras no se prueban solos: un error suyo lo notan los programas que se comparan con ellos.
#include "azar.h"
#include "contra_oraculo.h"
#include <tuple>

using namespace oraculo;

namespace {

/// Transformación sin nada especial: escala distinta en cada eje, refleja, gira y traslada.
const Mat4 TORCIDA = traslada({0.3, -1.2, 0.7}) * gira({1, 2, -0.5}, 0.8) * escala({1.3, -0.6, 0.9});

Azar azar(12345);

/// Rayo desde lejos hacia las cercanías del centro de M.
Rayo rayoAlAzar(const Mat4 &M, double talla) {
    const Vec3 origen = punto(M, 5 * talla * unitario(exacto(azar.punto(1))));
    return {origen, unitario(punto(M, exacto(azar.punto(talla))) - origen), 0, INFINITO};
}

/// Cada forma con su ecuación implícita en coordenadas del objeto: negativa dentro, 0 en la superficie.
struct Caso {
    const char *nombre;
    Objeto objeto;
    double (*F)(const Vec3 &);
    double talla;
};
const float RADIO = 1, TUBO = 0.375f; // exactos en float
const std::vector<Caso> CASOS = {
    {"esfera", esfera(TORCIDA), [](const Vec3 &p) { return longitud(p) - 1; }, 1},
    {"caja", caja(TORCIDA),
     [](const Vec3 &p) {
         return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}) - 0.5;
     },
     0.6},
    {"cilindro", cilindro(TORCIDA),
     [](const Vec3 &p) { return std::max(std::hypot(p.x, p.y) - 1, std::fabs(p.z) - 0.5); }, 1.1},
    {"cono", cono(TORCIDA), [](const Vec3 &p) { return std::max(std::hypot(p.x, p.y) + p.z - 1, -p.z); },
     1.1},
    {"toro", toro(TORCIDA, RADIO, TUBO),
     [](const Vec3 &p) { return std::hypot(std::hypot(p.x, p.y) - RADIO, p.z) - TUBO; }, 1.4},
};

} // namespace

// --- Cortes ------------------------------------------------------------------------------------------------

// El punto está en la superficie y es el primero (nada hay dentro antes, muestreando el rayo), y la normal es el
// gradiente de la ecuación implícita. Sin corte, el rayo entero está fuera. Desde dentro se ve la otra cara, y la
// normal sigue hacia fuera.
TEST(Cortes, EcuacionesImplicitasYGradientes) {
    const Mat4 inv = inversa(TORCIDA);
    for (const Caso &caso : CASOS) {
        const auto F = [&](const Vec3 &p) { return caso.F(punto(inv, p)); };
        int cortes = 0, salidas = 0;
        double peorF = 0, peorNormal = 0;
        const auto comprueba = [&](const Impacto &i) {
            EXPECT_NEAR(longitud(i.normal), 1, 1e-15);
            EXPECT_LE(longitud(i.punto - (i.rayo.origen + i.distancia * i.rayo.direccion)), 1e-14);
            peorF = std::max(peorF, std::fabs(F(i.punto)));
            const double h = 1e-6;
            const Vec3 gradiente = {F(i.punto + Vec3{h, 0, 0}) - F(i.punto - Vec3{h, 0, 0}),
                                    F(i.punto + Vec3{0, h, 0}) - F(i.punto - Vec3{0, h, 0}),
                                    F(i.punto + Vec3{0, 0, h}) - F(i.punto - Vec3{0, 0, h})};
            peorNormal = std::max(peorNormal, longitud(unitario(gradiente) - i.normal));
        };
        for (int n = 0; n < 2000; ++n) {
            const Rayo r = rayoAlAzar(TORCIDA, caso.talla);
            const Impacto i = primerImpacto({caso.objeto}, r);
            const double hasta = i ? i.distancia - 1e-6 : 12 * caso.talla;
            for (int k = 0; k <= 200; ++k)
                ASSERT_GT(F(r.origen + (hasta * k / 200) * r.direccion), 0) << caso.nombre << " rayo " << n;
            if (!i)
                continue;
            ++cortes;
            EXPECT_TRUE(i.frente);
            comprueba(i);
            const Vec3 dentro = i.punto + 1e-3 * r.direccion;
            if (F(dentro) > -1e-4)
                continue; // pasa rozando
            ++salidas;
            const Impacto otra = primerImpacto({caso.objeto}, {dentro, r.direccion, 0, INFINITO});
            ASSERT_TRUE(otra) << caso.nombre;
            EXPECT_FALSE(otra.frente) << caso.nombre;
            EXPECT_GT(escalar(otra.normal, r.direccion), 0) << caso.nombre;
            comprueba(otra);
        }
        EXPECT_GT(cortes, 500) << caso.nombre;
        EXPECT_GT(salidas, 500) << caso.nombre;
        EXPECT_LT(peorF, 1e-13) << caso.nombre;
        EXPECT_LT(peorNormal, 1e-8) << caso.nombre;
    }
}

// --- Cámara ------------------------------------------------------------------------------------------------

TEST(Camara, IdaYVuelta) {
    const Camara base = orbita(0.7, -0.4, 12, {1, 2, 3});
    for (const Camara &c : {perspectiva(base, 0.9, 0.5, 80), paralela(base, 3, 1, 30)})
        for (const auto &[ancho, alto] : {std::pair(240, 180), {180, 240}, {1, 1}, {333, 7}})
            for (int n = 0; n < 50; ++n) {
                const double px = azar.entre(0.0, double(ancho)), py = azar.entre(0.0, double(alto));
                const Rayo r = rayo(c, ancho, alto, px, py);
                const auto enVentana = [&](double t) {
                    return proyecta(c, ancho, alto, r.origen + t * r.direccion);
                };
                EXPECT_NEAR(longitud(r.direccion), 1, 1e-15);
                const Vec3 v = enVentana(azar.entre(r.minimo, r.maximo));
                EXPECT_NEAR(v.x, px, 1e-11);
                EXPECT_NEAR(v.y, py, 1e-11);
                EXPECT_NEAR(enVentana(r.minimo).z, 0, 1e-13);
                EXPECT_NEAR(enVentana(r.maximo).z, 1, 1e-13);
                const auto seVe = [&](double t) { // lo que hay a esa distancia
                    return bool(primerImpacto({plano(traslada(r.origen + t * r.direccion))}, r));
                };
                EXPECT_TRUE(seVe(r.minimo + 1e-6) && seVe(r.maximo - 1e-6));
                EXPECT_FALSE(seVe(r.minimo - 1e-6) || seVe(r.maximo + 1e-6));
            }
}

// --- Cobertura ---------------------------------------------------------------------------------------------

// Gire como gire el polígono. Lo demás, en ch09_mallas.Antialiasing.
TEST(Cobertura, LosDosSentidos) {
    EXPECT_DOUBLE_EQ(coberturaPixel({{3, 5}, {4, 5}, {3, 6}}, 3, 5), 0.5);
    EXPECT_DOUBLE_EQ(coberturaPixel({{3, 6}, {4, 5}, {3, 5}}, 3, 5), 0.5);
}

// --- Comparación -------------------------------------------------------------------------------------------

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

} // namespace

TEST(Comparar, UnaImagenConsigoMisma) {
    const Escena escena = esferaYSuelo({});
    const ImagenRef ref = render(escena, CAMARA, 80, 60, sombrea);
    for (const Comparacion &c :
         {compara(enBytes(ref), ref), compara(enBytes(ref), escena, CAMARA, sombrea)}) {
        EXPECT_LE(c.maximo, 0.5 + 1e-12) << c;
        EXPECT_EQ(c.bandaDistintos, 0) << c;
        EXPECT_EQ(c.desvio, 0) << c;
        EXPECT_EQ(c.interior + c.banda, 80 * 60);
        EXPECT_GT(c.banda, 100) << c;
        EXPECT_GT(c.interior, 3000) << c;
    }
    const Comparacion silueta = comparaSilueta(enBytes(ref), FONDO, escena, CAMARA);
    EXPECT_EQ(silueta.maximo, 0) << silueta;
    EXPECT_EQ(silueta.bandaDistintos, 0) << silueta;
}

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

// Un toro que se tapa a sí mismo tiene banda dentro de su silueta; un cubo, en sus aristas; una esfera, solo junto a la
// silueta.
TEST(Comparar, LaBandaVeLosBordesDeUnMismoObjeto) {
    const Camara c = perspectiva(orbita(0.6, 0.5, 6), 0.6, 1, 50);
    const auto bordesDentro = [&](const Objeto &o) {
        const ImagenRef ref = render({o}, c, 120, 120, [](const Impacto &i) {
            return i ? Vec3{1, 1, 1} : Vec3{};
        });
        int n = 0;
        for (int y = 0; y < 120; ++y)
            for (int x = 1; x < 120; ++x) {
                const PixelRef &este = ref.en(x, y), &anterior = ref.en(x - 1, y);
                n += este.objeto == 0 && anterior.objeto == 0 && hayBorde(este, anterior);
            }
        return n;
    };
    EXPECT_GT(bordesDentro(toro(gira({0, 1, 0}, 1.8), 1, 0.4)), 20);
    EXPECT_GT(bordesDentro(caja(escala(1.5))), 40);
    EXPECT_GT(bordesDentro(malla(escala(1.5), cubo())), 40);
    EXPECT_LT(bordesDentro(esfera(Mat4{})), 20);
    EXPECT_LT(bordesDentro(malla(Mat4{}, esfera(64))), 20);
    PixelRef uno, otro; // dos caras en el mismo plano
    uno.objeto = otro.objeto = 0;
    EXPECT_FALSE(hayBorde(uno, otro));
    otro.cara = 1;
    EXPECT_TRUE(hayBorde(uno, otro));
    otro.cara = 0;
    otro.zona = 1;
    EXPECT_TRUE(hayBorde(uno, otro));
}
