// La convolución del capítulo 9 contra la ecuación 9.1 hecha en la CPU en doble precisión, también en el borde, y el shader
// filtro.glsl con filtros sueltos.
#include "ch09_imagen.h"
#include "ch09_imagen/nucleos.h"
#include <cstdio>
#include <numeric>

namespace {

const Imagen A = alAzar(37, 29, 3);
const Imagen LISA = imagen(20, 15, [](int, int) { return Pixel{90, 200, 17}; });

using Nucleo = std::vector<std::vector<double>>; // [j][i], j hacia arriba

/// Ecuación 9.1 con (m − 1)/2 redondeado hacia abajo; fuera de la imagen, el borde.
Vec3 correla(const Imagen &im, const Nucleo &filtro, int x, int y) {
    Vec3 suma;
    const int m = static_cast<int>(filtro[0].size()), n = static_cast<int>(filtro.size());
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < m; ++i)
            suma = suma + filtro[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] *
                              texel(im, x + i - (m - 1) / 2, y + j - (n - 1) / 2);
    return suma;
}
Esperado con(const Imagen &im, const Nucleo &filtro) {
    return [&im, filtro](int x, int y) { return correla(im, filtro, x, y); };
}
/// Suma 0: el gris 128 es 0.
Esperado conSigno(const Imagen &im, const Nucleo &filtro) {
    return [&im, filtro](int x, int y) { return Vec3{128, 128, 128} + correla(im, filtro, x, y); };
}
Vec3 absoluto(const Vec3 &v) {
    return {std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)};
}

const Nucleo SUAVIZADO(3, std::vector<double>(3, 1.0 / 9)), NITIDEZ = {{0, -1, 0}, {-1, 5, -1}, {0, -1, 0}},
                                                            BORDES = {{0, 1, 0}, {1, -4, 1}, {0, 1, 0}};

/// Los filtros de convolucion_variable, calculados aquí.
Nucleo nucleo(int familia, int m) {
    const double c = (m - 1) / 2.0, s = m / 5.0;
    Nucleo f(static_cast<std::size_t>(m), std::vector<double>(static_cast<std::size_t>(m)));
    double positivos = 0;
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < m; ++i) {
            const double x = i - c, y = j - c, g = std::exp(-(x * x + y * y) / (2 * s * s));
            double &v = f[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)];
            v = familia == CAJA        ? 1
                : familia == GAUSSIANA ? g
                : familia == DERIVADA  ? x * g
                                       : 4 * (x * x + y * y) <= m * m;
            positivos += std::max(v, 0.0);
        }
    for (auto &fila : f)
        for (double &v : fila)
            v /= positivos;
    return f;
}
/// El guion que pide esa familia y esa talla; se empieza con 9.
std::string pide(int familia, int m, const std::string &mas = "") {
    std::string guion = "tecla " + std::to_string(familia + 1);
    if (m != 9)
        guion += "; " + repite(m > 9 ? "tecla +" : "tecla -", std::abs(m - 9));
    return guion + (mas.empty() ? "" : "; " + mas);
}
const std::string DIRECTO = "tecla s", SEPARABLE = "tecla s; tecla s";

} // namespace

// --- convolucion ---

TEST(Convolucion, LosTresFiltrosDeLaTabla91) {
    EXPECT_LE(diferenciaMaxima(procesa("convolucion", {A}), con(A, SUAVIZADO)), 0.51);
    EXPECT_LE(diferenciaMaxima(procesa("convolucion", {A}, "tecla 2"), con(A, NITIDEZ)), 0.51);
    EXPECT_LE(diferenciaMaxima(procesa("convolucion", {A}, "tecla 3"), conSigno(A, BORDES)), 0.51);
    EXPECT_LE(diferenciaMaxima(procesa("convolucion", {A}, "tecla 3; tecla s"),
                               [](int x, int y) { return absoluto(correla(A, BORDES, x, y)); }),
              0.51);
}

// Lo liso no cambia, ni en el borde; con bordes es justo el gris 128.
TEST(Convolucion, LoLisoSigueLiso) {
    EXPECT_EQ(diferenciaMaxima(procesa("convolucion", {LISA}), igualQue(LISA)), 0);
    EXPECT_EQ(diferenciaMaxima(procesa("convolucion", {LISA}, "tecla 2"), igualQue(LISA)), 0);
    const Imagen gris = procesa("convolucion", {LISA}, "tecla 3");
    EXPECT_EQ(std::count(gris.rgb.begin(), gris.rgb.end(), 128), std::ptrdiff_t(gris.rgb.size()));
}

// La errata de §9.2: con 1/(ancho − 1) el texel de al lado no es el de al lado, y con ancho 1 no hay ninguno.
TEST(Convolucion, UnTexelEsUnoEntreElAncho) {
    const Imagen columna = alAzar(1, 9), fila = alAzar(9, 1), punto = alAzar(1, 1);
    for (const Imagen &i : {columna, fila, punto})
        EXPECT_LE(diferenciaMaxima(procesa("convolucion", {i}), con(i, SUAVIZADO)), 0.51);
    double peor = 0; // lo que daría el libro en una imagen de 9 de ancho
    for (int x = 0; x < 9; ++x) {
        const double p = 9.0 / 8;
        const Vec3 libro = 1.0 / 3 *
                           (bilineal(fila, x + 0.5 - p, 0.5) + bilineal(fila, x + 0.5, 0.5) +
                            bilineal(fila, x + 0.5 + p, 0.5));
        peor = std::max(peor, std::fabs(libro.x - correla(fila, SUAVIZADO, x, 0).x));
    }
    EXPECT_GT(peor, 5);
}

TEST(Convolucion, LosTresALaVez) {
    const Imagen lisa = imagen(40, 30, [](int, int) { return Pixel{100, 20, 200}; });
    const Ejecucion e = ejecuta("ch09_imagen/convolucion", "tecla v", 81, 61, {escribe(lisa)});
    for (const auto &[x, y, r] : {std::tuple(20, 45, 100), {60, 45, 100}, {20, 15, 100}, {60, 15, 128}})
        EXPECT_EQ(pixel(e.imagen, x, y).r, r) << x << "," << y;
    const Imagen original = procesa("convolucion", {A}, "tecla 2; tecla v; tecla 1");
    EXPECT_LE(diferenciaMaxima(original, con(A, SUAVIZADO)), 0.51); // elegir uno deja de comparar
}

// --- convolucion_variable ---

TEST(ConvolucionVariable, CadaFamiliaYTallaDirectaYSeparable) {
    for (int familia = 0; familia < FAMILIAS; ++familia)
        for (const int m : {1, 2, 3, 8, 31})
            for (const std::string &modo : {std::string(), DIRECTO, SEPARABLE}) {
                if (familia == DISCO && !modo.empty())
                    continue; // siempre es directo
                if (m == 31 && modo == DIRECTO)
                    continue; // lento: abajo, sobre 8×8
                if (familia == DERIVADA && m == 1)
                    continue; // no hay derivada: abajo
                const Imagen r = procesa("convolucion_variable", {A}, pide(familia, m, modo));
                EXPECT_LE(diferenciaMaxima(r, familia == DERIVADA ? conSigno(A, nucleo(familia, m))
                                                                  : con(A, nucleo(familia, m))),
                          0.52)
                    << familia << " " << m << " " << modo;
            }
}

// 31×31 sobre 8×8: casi todo lo que suma es borde.
TEST(ConvolucionVariable, Un31x31SobreUnaImagenDe8x8) {
    const Imagen pequena = alAzar(8, 8);
    for (const std::string &modo : {DIRECTO, SEPARABLE})
        EXPECT_LE(diferenciaMaxima(procesa("convolucion_variable", {pequena}, pide(CAJA, 31, modo)),
                                   con(pequena, nucleo(CAJA, 31))),
                  0.52);
}

// La tecla s lleva del modo automático, que con 2×2 es separable, al directo y al separable: el que se nota si el intermedio
// es de 8 bits.
TEST(ConvolucionVariable, LosTresModos) {
    const auto con2x2 = [](const std::string &teclas) {
        return procesa("convolucion_variable", {A}, pide(CAJA, 2, "tecla p" + teclas)).rgb;
    };
    const auto automatico = con2x2(""), directo = con2x2("; tecla s"),
               separable = con2x2("; tecla s; tecla s");
    EXPECT_EQ(automatico, separable);
    EXPECT_NE(separable, directo);
    EXPECT_EQ(con2x2("; tecla s; tecla s; tecla s; tecla s"), directo);
}

// El filtro de 1×1 es la delta: la imagen, intacta.
TEST(ConvolucionVariable, LaDeltaEsElOriginal) {
    for (const std::string &modo : {std::string(), DIRECTO, SEPARABLE})
        EXPECT_EQ(procesa("convolucion_variable", {A}, pide(GAUSSIANA, 1, modo)).rgb, A.rgb) << modo;
}

TEST(ConvolucionVariable, SumaCero) {
    const Imagen lisa = procesa("convolucion_variable", {LISA}, pide(DERIVADA, 9));
    EXPECT_EQ(std::count(lisa.rgb.begin(), lisa.rgb.end(), 128), std::ptrdiff_t(lisa.rgb.size()));
    const Imagen una = procesa("convolucion_variable", {A}, pide(DERIVADA, 1)); // un filtro nulo, no 0/0
    EXPECT_EQ(std::count(una.rgb.begin(), una.rgb.end(), 128), std::ptrdiff_t(una.rgb.size()));
    const Nucleo f = nucleo(DERIVADA, 5);
    EXPECT_LE(diferenciaMaxima(procesa("convolucion_variable", {A}, pide(DERIVADA, 5, "tecla a")),
                               [&](int x, int y) { return absoluto(correla(A, f, x, y)); }),
              0.52);
}

// Lo que cuesta un intermedio de 8 bits: hasta casi un nivel más, y con negativos el resultado deja de valer.
TEST(ConvolucionVariable, IntermedioDe8BitsContraFloat) {
    const auto error = [](int familia, const std::string &modo) {
        const Nucleo f = nucleo(familia, 9);
        return diferenciaMaxima(procesa("convolucion_variable", {A}, pide(familia, 9, modo)),
                                familia == DERIVADA ? conSigno(A, f) : con(A, f));
    };
    const double enFloat = error(GAUSSIANA, SEPARABLE), en8Bits = error(GAUSSIANA, SEPARABLE + "; tecla p");
    EXPECT_LE(enFloat, 0.51);
    EXPECT_GT(en8Bits, enFloat + 0.05);
    EXPECT_LE(en8Bits, 1.01);
    EXPECT_LE(error(DERIVADA, SEPARABLE), 0.51);
    EXPECT_GT(error(DERIVADA, SEPARABLE + "; tecla p"), 20);
    std::printf("intermedio: float %.3f, 8 bits %.3f; derivada en 8 bits %.1f niveles\n", enFloat, en8Bits,
                error(DERIVADA, SEPARABLE + "; tecla p"));
}

// Los núcleos en float contra los de arriba, y lo que suman.
TEST(Nucleos, SumanUnoOCero) {
    for (int familia = 0; familia < FAMILIAS; ++familia)
        for (int m = 2; m <= TALLA_MAXIMA; ++m) {
            const Filtro f = creaFiltro(static_cast<Familia>(familia), m);
            const Nucleo exacto = nucleo(familia, m);
            double suma = 0, peor = 0;
            for (std::size_t k = 0; k < f.valores.size(); ++k) {
                suma += static_cast<double>(f.valores[k]);
                peor = std::max(
                    peor,
                    std::fabs(static_cast<double>(f.valores[k]) -
                              exacto[k / static_cast<std::size_t>(m)][k % static_cast<std::size_t>(m)]));
            }
            EXPECT_NEAR(suma, familia == DERIVADA ? 0 : 1, 1e-5) << familia << " " << m;
            EXPECT_LT(peor, 1e-7);
            EXPECT_EQ(f.esSeparable(), familia != DISCO);
        }
}
