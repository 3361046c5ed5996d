// La convolución del capítulo 9 contra la ecuación 9.1 hecha en la CPU en doble precisión, también en el borde, y los
// filtros de tamaño variable.
#include "ch09_imagen/nucleos.h"
#include "ch09_paneles.h"
#include "guiones.h"

namespace {

const Imagen A = alAzar(37, 29, 3);
const Esperado ORIGINAL = igualQue(A);

struct Nucleo {
    int m;
    std::vector<double> valores; // por filas, hacia arriba
};
const Nucleo SUAVIZADO = {3, std::vector<double>(9, 1.0 / 9)}, NITIDEZ = {3, {0, -1, 0, -1, 5, -1, 0, -1, 0}},
             BORDES = {3, {0, 1, 0, 1, -4, 1, 0, 1, 0}};

enum Fuera { BORDE, REPETIDA, CERO };                  // lo que hay fuera de la imagen
enum Signo { POSITIVO, CON_SIGNO, ABSOLUTO };          // con signo, el gris 128 es 0
enum Modo { AUTOMATICO, DIRECTO, SEPARABLE, N_MODOS }; // las veces que se pulsa la s

/// Ecuación 9.1 con (m − 1)/2 redondeado hacia abajo.
Esperado con(const Imagen &im, const Nucleo &filtro, Signo signo = POSITIVO, double ganancia = 1,
             Fuera fuera = BORDE) {
    return [=](int x, int y) {
        Vec3 c;
        const int m = filtro.m, centro = (m - 1) / 2;
        for (int k = 0; k < m * m; ++k) {
            const int i = x + k % m - centro, j = y + k / m - centro;
            const bool dentro = i >= 0 && i < im.ancho && j >= 0 && j < im.alto;
            if (dentro || fuera != CERO)
                c = c + ganancia * filtro.valores[std::size_t(k)] *
                            texel(im, i, j, fuera == REPETIDA, fuera == REPETIDA);
        }
        return signo == CON_SIGNO ? Vec3{128, 128, 128} + c : signo == ABSOLUTO ? absoluto(c) : c;
    };
}

/// Los filtros de convolucion_variable, calculados aquí. La derivada de 1×1 es nula.
Esperado conNucleo(const Imagen &im, int familia, int m, Signo signo = CON_SIGNO) {
    Nucleo f{m, {}};
    double positivos = 0;
    for (int k = 0; k < m * m; ++k) {
        const double s = m / 5.0, x = k % m - (m - 1) / 2.0, y = k / m - (m - 1) / 2.0,
                     g = std::exp(-(x * x + y * y) / (2 * s * s)),
                     valores[] = {1, g, double(4 * (x * x + y * y) <= m * m), x * g};
        f.valores.push_back(valores[familia]);
        positivos += std::max(valores[familia], 0.0);
    }
    for (double &v : f.valores)
        v /= std::max(positivos, 1e-300);
    return con(im, f, familia == DERIVADA ? signo : POSITIVO);
}
/// El guion que pide esa familia, esa talla, que empieza en 9, y ese modo.
std::string pide(int familia, int m, int modo = AUTOMATICO) {
    return "tecla " + std::to_string(familia + 1) + "; " + veces(m - 9, "tecla +") + "; " +
           veces(9 - m, "tecla -") + "; " + veces(modo, "tecla s") + "; ";
}

} // namespace

// --- convolucion ---

// Elegir uno deja de comparar.
TEST(Convolucion, LosTresFiltrosDeLaTabla91) {
    const Esperado suavizado = con(A, SUAVIZADO), nitidez = con(A, NITIDEZ),
                   conSigno = con(A, BORDES, CON_SIGNO, 4), absolutos = con(A, BORDES, ABSOLUTO, 4);
    compruebaPaneles("convolucion", {A},
                     {{{"", "tecla 2; tecla v; tecla 1"}, {suavizado}},
                      {{"tecla 2"}, {nitidez}},
                      {{"tecla 3", "tecla s ×2; tecla v; tecla 3"}, {absolutos}},
                      {{"tecla 3; tecla s"}, {conSigno}},
                      {{"tecla v"}, {ORIGINAL, suavizado, nitidez, absolutos}},
                      {{"tecla v; tecla s"}, {ORIGINAL, suavizado, nitidez, conSigno}}});
}

// La ganancia, de 1 a 9, solo de los bordes; y lo de fuera, en los tres filtros y al comparar.
TEST(Convolucion, GananciaYLoDeFuera) {
    const auto bordes = [](int ganancia, Fuera fuera = BORDE) {
        return con(A, BORDES, ABSOLUTO, ganancia, fuera);
    };
    const Esperado cero = con(A, SUAVIZADO, POSITIVO, 1, CERO);
    compruebaPaneles(
        "convolucion", {A},
        {{{"tecla 3; tecla - ×99"}, {bordes(1)}},
         {{"tecla 3; tecla + ×99; tecla -"}, {bordes(8)}},
         {{"tecla 3; tecla s; tecla - ×2"}, {con(A, BORDES, CON_SIGNO, 2)}},
         {{"tecla +; tecla b"}, {con(A, SUAVIZADO, POSITIVO, 1, REPETIDA)}},
         {{"tecla b ×2"}, {cero}},
         {{"tecla b ×3"}, {con(A, SUAVIZADO)}},
         {{"tecla 3; tecla b; tecla +"}, {bordes(5, REPETIDA)}},
         {{"tecla v; tecla b ×2"}, {ORIGINAL, cero, con(A, NITIDEZ, POSITIVO, 1, CERO), bordes(4, CERO)}}});
}

// La errata de §9.2: con 1/(ancho − 1) el texel de al lado no es el de al lado, y con ancho 1 no hay ninguno.
TEST(Convolucion, UnTexelEsUnoEntreElAncho) {
    for (const Imagen &i : {alAzar(1, 9), alAzar(9, 1), alAzar(1, 1)})
        compruebaPaneles("convolucion", {i}, {{{""}, {con(i, SUAVIZADO)}}});
}

// --- convolucion_variable ---

// El de 1×1 es la delta, o nulo. 31×31 directo es lento: sobre 8×8, donde casi todo lo que suma es borde.
TEST(ConvolucionVariable, CadaFamiliaYTallaDirectaYSeparable) {
    const Imagen pequena = alAzar(8, 8);
    for (int familia = 0; familia < FAMILIAS; ++familia)
        for (const int m : {1, 2, 3, 8, 31})
            for (int modo = 0; modo < (familia == DISCO ? 1 : N_MODOS); ++modo) {
                const Imagen &im = m == 31 && modo != AUTOMATICO ? pequena : A;
                compruebaPaneles("convolucion_variable", {im},
                                 {{{pide(familia, m, modo)}, {conNucleo(im, familia, m)}}});
            }
    const Esperado caja9 = conNucleo(A, CAJA, 9);
    compruebaPaneles("convolucion_variable", {A},
                     {{{"", "tecla s ×3"}, {caja9}},
                      {{"tecla + ×99; tecla -"}, {conNucleo(A, CAJA, 30)}},
                      {{"tecla - ×99; tecla +"}, {conNucleo(A, CAJA, 2)}},
                      {{pide(DERIVADA, 5) + "tecla a"}, {conNucleo(A, DERIVADA, 5, ABSOLUTO)}},
                      {{"tecla v"}, {ORIGINAL, caja9}}});
}

// Lo que cuesta un intermedio de 8 bits: hasta casi un nivel más, y con negativos el resultado deja de valer.
TEST(ConvolucionVariable, IntermedioDe8BitsContraFloat) {
    const auto error = [](int familia, const std::string &teclas) {
        return diferenciaMaxima(procesa("convolucion_variable", {A}, pide(familia, 9, SEPARABLE) + teclas),
                                conNucleo(A, familia, 9));
    };
    const double enFloat = error(GAUSSIANA, ""), en8Bits = error(GAUSSIANA, "tecla p");
    EXPECT_LE(enFloat, REDONDEO);
    EXPECT_GT(en8Bits, enFloat + 0.05);
    EXPECT_LE(en8Bits, 1.01);
    EXPECT_LE(error(DERIVADA, "tecla p; tecla p"), REDONDEO);
    EXPECT_GT(error(DERIVADA, "tecla p"), 20);
}
