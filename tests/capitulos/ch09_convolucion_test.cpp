// La convolución del capítulo 9 contra la ecuación 9.1 hecha en la CPU en doble precisión, también en el borde, y los filtros de
// tamaño variable.
#include "ch09_imagen/nucleos.h"
#include "ch09_paneles.h"
#include "guiones.h"
#include <iostream>

namespace {

const Imagen A = alAzar(37, 29, 3), LISA = lisa(20, 15, {90, 200, 17}),
             GRIS128 = lisa(20, 15, {128, 128, 128});

using Nucleo = std::vector<std::vector<double>>; // [j][i], j hacia arriba

/// Ecuación 9.1 con (m − 1)/2 redondeado hacia abajo; fuera de la imagen, el borde.
Vec3 correla(const Imagen &im, const Nucleo &filtro, int x, int y) {
    Vec3 suma;
    const int m = int(filtro[0].size()), n = int(filtro.size());
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < m; ++i)
            suma = suma + filtro[std::size_t(j)][std::size_t(i)] *
                              texel(im, x + i - (m - 1) / 2, y + j - (n - 1) / 2);
    return suma;
}
enum Signo { POSITIVO, CON_SIGNO, ABSOLUTO }; // con signo, el gris 128 es 0
Panel con(const Imagen &im, const Nucleo &filtro, const std::string &rotulo, Signo signo = POSITIVO) {
    return {[=](int x, int y) {
                const Vec3 c = correla(im, filtro, x, y);
                return signo == CON_SIGNO ? Vec3{128, 128, 128} + c : signo == ABSOLUTO ? absoluto(c) : c;
            },
            rotulo};
}
/// Lo mismo que la imagen, exacto.
Panel original(const Imagen &im, const std::string &rotulo) {
    return {igualQue(im), rotulo, 0};
}

const Nucleo SUAVIZADO(3, std::vector<double>(3, 1.0 / 9)), NITIDEZ = {{0, -1, 0}, {-1, 5, -1}, {0, -1, 0}},
                                                            BORDES = {{0, 1, 0}, {1, -4, 1}, {0, 1, 0}};

/// Los filtros de convolucion_variable, calculados aquí.
Nucleo nucleo(int familia, int m) {
    const double c = (m - 1) / 2.0, s = m / 5.0;
    Nucleo f;
    double positivos = 0;
    for (int j = 0; j < m; ++j) {
        f.emplace_back();
        for (int i = 0; i < m; ++i) {
            const double x = i - c, y = j - c, g = std::exp(-(x * x + y * y) / (2 * s * s));
            f.back().push_back(familia == CAJA        ? 1
                               : familia == GAUSSIANA ? g
                               : familia == DERIVADA  ? x * g
                                                      : 4 * (x * x + y * y) <= m * m);
            positivos += std::max(f.back().back(), 0.0);
        }
    }
    for (auto &fila : f)
        for (double &v : fila)
            v = positivos > 0 ? v / positivos : 0; // la derivada de 1×1 es nula
    return f;
}

/// Automático, directo o separable: las veces que se pulsa la s.
enum Modo { AUTOMATICO, DIRECTO, SEPARABLE, N_MODOS };

/// El guion que pide esa familia, esa talla, que empieza en 9, y ese modo.
std::string pide(int familia, int m, int modo = AUTOMATICO, const std::string &mas = "") {
    return "tecla " + std::to_string(familia + 1) + "; " + veces(m - 9, "tecla +") + "; " +
           veces(9 - m, "tecla -") + "; " + veces(modo, "tecla s") + "; " + mas;
}
/// Qué filtro es y cómo se ha hecho: en dos pasadas, si se puede y no se pide otra cosa.
std::string rotulo(int familia, int m, int modo = AUTOMATICO, const std::string &intermedio = "float") {
    const char *const nombres[] = {"Caja ", "Gaussiana ", "Disco ", "Derivada "};
    const bool directo = familia == DISCO || modo == DIRECTO || (modo == AUTOMATICO && m == 1);
    return nombres[familia] + std::to_string(m) + "×" + std::to_string(m) +
           (directo ? "\ndirecto" : "\nseparable, " + intermedio);
}
Panel conNucleo(const Imagen &im, int familia, int m, int modo) {
    return con(im, nucleo(familia, m), rotulo(familia, m, modo), familia == DERIVADA ? CON_SIGNO : POSITIVO);
}

} // namespace

// --- convolucion ---

// En lo liso no cambia nada, ni en el borde; con bordes es justo el gris 128. Elegir uno deja de comparar.
TEST(Convolucion, LosTresFiltrosDeLaTabla91) {
    const Panel suavizado = con(A, SUAVIZADO, "Suavizado"), nitidez = con(A, NITIDEZ, "Nitidez"),
                conSigno = con(A, BORDES, "Bordes con signo", CON_SIGNO),
                absolutos = con(A, BORDES, "Bordes en valor absoluto", ABSOLUTO);
    compruebaPaneles("convolucion", {A},
                     {{"", {suavizado}},
                      {"tecla 2", {nitidez}},
                      {"tecla 3", {conSigno}},
                      {"tecla 3; tecla s", {absolutos}},
                      {"tecla s ×2; tecla v; tecla 3", {conSigno}},
                      {"tecla 2; tecla v; tecla 1", {suavizado}},
                      {"tecla v", {original(A, "Original"), suavizado, nitidez, conSigno}, 2},
                      {"tecla v; tecla s", {original(A, "Original"), suavizado, nitidez, absolutos}, 2}});
    compruebaPaneles("convolucion", {LISA},
                     {{"", {original(LISA, "Suavizado")}},
                      {"tecla 2", {original(LISA, "Nitidez")}},
                      {"tecla 3", {original(GRIS128, "Bordes con signo")}}});
}

// La errata de §9.2: con 1/(ancho − 1) el texel de al lado no es el de al lado, y con ancho 1 no hay ninguno.
TEST(Convolucion, UnTexelEsUnoEntreElAncho) {
    const Imagen fila = alAzar(9, 1);
    for (const Imagen &i : {alAzar(1, 9), fila, alAzar(1, 1)})
        compruebaPaneles("convolucion", {i}, {{"", {con(i, SUAVIZADO, "Suavizado")}}});
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

// --- convolucion_variable ---

// 31×31 directo es lento: sobre 8×8, donde casi todo lo que suma es borde.
TEST(ConvolucionVariable, CadaFamiliaYTallaDirectaYSeparable) {
    const Imagen pequena = alAzar(8, 8);
    for (int familia = 0; familia < FAMILIAS; ++familia)
        for (const int m : {1, 2, 3, 8, 31})
            for (int modo = 0; modo < (familia == DISCO ? 1 : N_MODOS); ++modo) {
                const Imagen &im = m == 31 && modo != AUTOMATICO ? pequena : A;
                compruebaPaneles("convolucion_variable", {im},
                                 {{pide(familia, m, modo), {conNucleo(im, familia, m, modo)}}});
            }
    const std::string caja9 = rotulo(CAJA, 9), derivada5 = rotulo(DERIVADA, 5);
    compruebaPaneles(
        "convolucion_variable", {A},
        {{"", {conNucleo(A, CAJA, 9, AUTOMATICO)}},
         {"tecla s ×3", {conNucleo(A, CAJA, 9, AUTOMATICO)}},
         {"tecla + ×99; tecla -", {conNucleo(A, CAJA, 30, AUTOMATICO)}},
         {"tecla - ×99; tecla +", {conNucleo(A, CAJA, 2, AUTOMATICO)}},
         {pide(DERIVADA, 5, AUTOMATICO, "tecla a"), {con(A, nucleo(DERIVADA, 5), derivada5, ABSOLUTO)}},
         {"tecla v",
          {original(A, "Original"), con(A, nucleo(CAJA, 9), caja9.substr(0, caja9.find('\n')))},
          2}});
}

// El filtro de 1×1 es la delta: la imagen, intacta; y lo liso, con uno que suma 0, el gris 128.
TEST(ConvolucionVariable, LaDeltaEsElOriginalYSumaCeroElGris) {
    for (int modo = 0; modo < N_MODOS; ++modo) {
        EXPECT_EQ(procesa("convolucion_variable", {A}, pide(GAUSSIANA, 1, modo)).rgb, A.rgb) << modo;
        EXPECT_EQ(procesa("convolucion_variable", {LISA}, pide(DERIVADA, 9, modo)).rgb, GRIS128.rgb) << modo;
    }
}

// Lo que cuesta un intermedio de 8 bits: hasta casi un nivel más, y con negativos el resultado deja de valer.
TEST(ConvolucionVariable, IntermedioDe8BitsContraFloat) {
    const auto error = [](int familia, const std::string &intermedio) {
        const Imagen r = procesa("convolucion_variable", {A}, pide(familia, 9, SEPARABLE, intermedio));
        const double e = diferenciaMaxima(r, conNucleo(A, familia, 9, SEPARABLE).esperado);
        std::cout << familia << " «" << intermedio << "»: " << e << " niveles\n";
        return e;
    };
    const double enFloat = error(GAUSSIANA, ""), en8Bits = error(GAUSSIANA, "tecla p");
    EXPECT_LE(enFloat, 0.51);
    EXPECT_GT(en8Bits, enFloat + 0.05);
    EXPECT_LE(en8Bits, 1.01);
    EXPECT_LE(error(DERIVADA, "tecla p; tecla p"), 0.51);
    EXPECT_GT(error(DERIVADA, "tecla p"), 20);
    EXPECT_EQ(vistaDe("convolucion_variable", "tecla p").encima.at(0).texto,
              rotulo(CAJA, 9, AUTOMATICO, "8 bits"));
}

// Los núcleos en float contra los de arriba, y lo que suman.
TEST(Nucleos, SumanUnoOCero) {
    for (int familia = 0; familia < FAMILIAS; ++familia)
        for (int m = 2; m <= TALLA_MAXIMA; ++m) {
            const Filtro f = creaFiltro(Familia(familia), m);
            std::vector<double> exactos;
            for (const auto &fila : nucleo(familia, m))
                exactos.insert(exactos.end(), fila.begin(), fila.end());
            ASSERT_EQ(f.valores.size(), exactos.size());
            double suma = 0;
            for (std::size_t k = 0; k < exactos.size(); ++k) {
                suma += double(f.valores[k]);
                EXPECT_NEAR(double(f.valores[k]), exactos[k], 1e-7);
            }
            EXPECT_NEAR(suma, familia == DERIVADA ? 0 : 1, 1e-5) << familia << " " << m;
            EXPECT_EQ(f.esSeparable(), familia != DISCO);
        }
}
