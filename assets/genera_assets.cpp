// Las texturas del laboratorio, hechas con cuentas: genera_assets CARPETA las escribe en RGB sin cabecera, la
// fila de arriba primero, como las lee leeTextura (listado 6.1). Deben salir idénticas en cualquier máquina:
// solo hay enteros y sumas, restas, productos, divisiones y raíces en double, que IEEE 754 redondea siempre
// igual. Las funciones de libm (pow, sin…) no lo hacen, y CMakeLists.txt prohíbe además juntar producto y
// suma en una sola operación.
#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

static_assert(FLT_EVAL_METHOD == 0, "los double deben redondearse en cada operación");

namespace {

// --- Números -----------------------------------------------------------------------------------------------

struct Color {
    double r = 0, g = 0, b = 0;
};
Color operator+(const Color &a, const Color &b) {
    return {a.r + b.r, a.g + b.g, a.b + b.b};
}
Color operator*(const Color &a, const Color &b) {
    return {a.r * b.r, a.g * b.g, a.b * b.b};
}
Color operator*(double k, const Color &a) {
    return {k * a.r, k * a.g, k * a.b};
}
Color mezcla(const Color &a, const Color &b, double t) {
    return (1 - t) * a + t * b;
}
double mezcla(double a, double b, double t) {
    return (1 - t) * a + t * b;
}
double entre01(double x) {
    return std::clamp(x, 0.0, 1.0);
}
// El smoothstep de GLSL.
double escalon(double a, double b, double x) {
    const double t = entre01((x - a) / (b - a));
    return t * t * (3 - 2 * t);
}
// x elevado a 2ⁿ.
double potencia2(double x, int n) {
    for (; n > 0; --n)
        x *= x;
    return x;
}
double fraccion(double x) {
    return x - std::floor(x);
}
double modulo(double x, double y, double z = 0) {
    return std::sqrt(x * x + y * y + z * z);
}

// Un número de 0 a 1 que parece al azar y depende solo de los argumentos.
double azar(int x, int y, int semilla) {
    std::uint32_t h = std::uint32_t(x) * 0x9E3779B1u ^ std::uint32_t(y) * 0x85EBCA77u ^
                      std::uint32_t(semilla) * 0xC2B2AE3Du;
    h = (h ^ h >> 15) * 0x2C1B3C6Du;
    h = (h ^ h >> 12) * 0x297A2D39u;
    return double((h ^ h >> 15) >> 8) / 16777216.0;
}

int resto(int i, int n) {
    return n == 0 ? i : ((i % n) + n) % n;
}

// Ruido de valores, de 0 a 1, en una rejilla de lado 1 que se repite cada px × py (0: no se repite).
double ruido(double x, double y, int px, int py, int semilla) {
    const double x0 = std::floor(x), y0 = std::floor(y), fx = x - x0, fy = y - y0;
    const int i = int(x0), j = int(y0);
    const double u = fx * fx * fx * (fx * (fx * 6 - 15) + 10), v = fy * fy * fy * (fy * (fy * 6 - 15) + 10);
    const auto nodo = [&](int a, int b) { return azar(resto(i + a, px), resto(j + b, py), semilla); };
    return mezcla(mezcla(nodo(0, 0), nodo(1, 0), u), mezcla(nodo(0, 1), nodo(1, 1), u), v);
}

// Suma de octavas de ruido, de 0 a 1; la primera se repite cada px × py.
double nubes(double x, double y, int octavas, int px, int py, int semilla) {
    double suma = 0, peso = 0.5, total = 0;
    for (int k = 0; k < octavas; ++k) {
        suma += peso * ruido(x, y, px, py, semilla + k);
        total += peso;
        peso *= 0.5;
        x *= 2;
        y *= 2;
        px *= 2;
        py *= 2;
    }
    return suma / total;
}

// --- Texturas: su color en (x, y), en texels y con y hacia arriba ------------------------------------------

// Luz (−1 a 1) que un relieve esférico de radio r recibe desde arriba a la izquierda, a (dx, dy) de su
// centro.
double luzDeBola(double dx, double dy, double r) {
    const double nx = dx / r, ny = dy / r, nz = std::sqrt(std::max(0.0, 1 - nx * nx - ny * ny));
    return -0.48 * nx + 0.62 * ny + 0.62 * nz;
}

// Plancha de metal cepillado con remaches.
Color metal(double x, double y) {
    const double hebras = 0.5 * ruido(x / 64, y, 4, 256, 11) + 0.3 * ruido(x / 16, y, 16, 256, 12) +
                          0.2 * ruido(x / 128, y / 2, 2, 128, 13);
    double luz = 0.66 + 0.34 * (hebras - 0.5) + 0.14 * (nubes(x / 64, y / 128, 3, 4, 2, 14) - 0.5);
    if (azar(int(y), 0, 15) < 0.05) // algún arañazo más hondo, que no da toda la vuelta
        luz -= 0.12 * escalon(0.45, 0.75, ruido(x / 32, y, 8, 256, 16));
    // la junta con la plancha vecina: una ranura, y el canto iluminado por arriba y por la izquierda
    const double borde = std::min({x, 256 - x, y, 256 - y});
    const bool aLaLuz = std::min(x, 256 - y) < std::min(256 - x, y);
    luz += (aLaLuz ? 0.16 : -0.16) * (escalon(2, 3.5, borde) - escalon(5, 8, borde));
    luz *= mezcla(0.30, 1, escalon(1, 3, borde));
    for (const double cx : {28.0, 128.0, 228.0})
        for (const double cy : {28.0, 128.0, 228.0}) {
            if (cx == 128 && cy == 128)
                continue;
            const double dx = x - cx, dy = y - cy, d = modulo(dx, dy), sombra = modulo(dx - 3, dy + 4);
            luz *= 1 - 0.45 * (1 - escalon(8, 15, sombra)) * escalon(9.5, 11, d);
            if (d < 11) {
                const double l = luzDeBola(dx, dy, 11.5);
                luz = mezcla(0.34 + 0.40 * l + 0.5 * potencia2(std::max(l, 0.0), 4) + 0.10 * (hebras - 0.5),
                             luz, escalon(10, 11, d));
            }
        }
    return luz * Color{0.96, 0.99, 1.03};
}

// Cuatro tablas, cortadas cada una a su distancia del centro del tronco, que va casi paralelo a ellas.
Color madera(double x, double y) {
    const int tabla = int(x / 64);
    const double enTabla = x - 64 * tabla, junta = 256 * fraccion(0.17 + 0.37 * tabla);
    const double largo = 256 * fraccion((y - junta) / 256); // desde la junta: da la vuelta sin costura
    const double centro = 64 * azar(tabla, 1, 21), hondura = 1.0 + 2.5 * azar(tabla, 2, 21);
    double X = (enTabla - centro) / 64 * 7, Z = hondura + (largo - 256 * azar(tabla, 3, 21)) / 256 * 9;
    X += 1.6 * (nubes(enTabla / 64, largo / 64, 3, 0, 0, 22 + 7 * tabla) - 0.5);
    double r = modulo(X, Z) + 0.35 * nubes(enTabla / 16, largo / 64, 2, 0, 0, 23 + 7 * tabla);
    // un nudo desvía los anillos, que lo rodean
    const double dx = (enTabla - mezcla(16, 48, azar(tabla, 4, 21))) / 9,
                 dy = (largo - mezcla(50, 206, azar(tabla, 5, 21))) / 14, d2 = dx * dx + dy * dy;
    const double nudo = tabla % 2 == 0 ? 1 / (1 + d2 * d2) : 0;
    r += 3.2 * nudo;
    // cada anillo se oscurece poco a poco y acaba de golpe
    const double anillo = fraccion(r), tardia = anillo * anillo * (1 - escalon(0.86, 1, anillo));
    const double vetas = ruido(enTabla * 0.9, largo / 24, 0, 0, 24 + 7 * tabla);
    Color c = mezcla({0.86, 0.64, 0.39}, {0.55, 0.31, 0.14}, entre01(1.25 * tardia + 0.30 * (vetas - 0.4)));
    c = mezcla(c, {0.30, 0.15, 0.07}, 0.85 * escalon(0.55, 0.95, nudo));
    c = (0.84 + 0.26 * azar(tabla, 6, 21)) * c;
    if (ruido(enTabla * 1.3, largo / 9, 0, 0, 25 + tabla) > 0.86) // poros
        c = 0.86 * c;
    const double borde = std::min({enTabla, 64 - enTabla, largo, 256 - largo});
    return mezcla(0.28, 1, escalon(0.4, 2.2, borde)) * c;
}

// Ladrillos de 64 × 32 texels, a soga; la luz viene de arriba a la izquierda.
Color ladrillo(double x, double y) {
    const int fila = int(y / 32);
    const double corrido = x + 32 * (fila % 2);
    const int columna = resto(int(std::floor(corrido / 64)), 4);
    const double grano = nubes(x / 4, y / 4, 3, 64, 64, 31), mancha = nubes(x / 32, y / 32, 3, 8, 8, 32);
    const double ondula = 2.2 * (nubes(x / 8, y / 8, 2, 32, 32, 33) - 0.5);
    const double u = 64 * fraccion(corrido / 64), v = y - 32 * fila;
    const double izquierda = u - 2.5 + ondula, derecha = 61.5 - u + ondula, abajo = v - 2.5 + ondula,
                 arriba = 29.5 - v + ondula, dentro = std::min({izquierda, derecha, abajo, arriba});
    const Color mortero =
        (0.84 + 0.30 * (grano - 0.5) - 0.16 * escalon(-2.5, 0.5, dentro)) * Color{0.86, 0.83, 0.78};
    const double tono = azar(columna, fila, 34), quemado = azar(columna, fila, 35);
    Color c = mezcla({0.74, 0.33, 0.22}, {0.86, 0.47, 0.31}, tono);
    c = mezcla(c, {0.50, 0.22, 0.17}, quemado > 0.72 ? 0.75 : 0.15 * quemado);
    double luz = 0.94 + 0.42 * (grano - 0.5) + 0.36 * (mancha - 0.5);
    luz += 0.17 * (1 - escalon(0.5, 3, std::min(izquierda, arriba)));
    luz -= 0.26 * (1 - escalon(0.5, 3, std::min(derecha, abajo)));
    if (ruido(x / 3, y / 3, 0, 0, 36) > 0.88) // picaduras
        luz *= 0.80;
    return mezcla(mortero, luz * c, escalon(-0.6, 0.6, dentro));
}

// Suelo de baldosas de mármol, dos claras y dos oscuras.
Color baldosas(double x, double y) {
    const int columna = int(x / 128), fila = int(y / 128), losa = 2 * fila + columna;
    const double u = x - 128 * columna, v = y - 128 * fila;
    const double torcido = nubes(u / 40, v / 40, 4, 0, 0, 111 + 9 * losa);
    const double veta = 1 - std::fabs(2 * fraccion((u + (losa % 2 ? v : -v)) / 110 + 1.5 * torcido) - 1);
    const double grano = 0.10 * (nubes(u / 6, v / 6, 3, 0, 0, 112 + 9 * losa) - 0.5),
                 fina = potencia2(veta, 3);
    const Color c = columna == fila ? mezcla({0.13, 0.20, 0.25}, {0.42, 0.50, 0.54}, 0.75 * fina + grano)
                                    : mezcla({0.95, 0.93, 0.89}, {0.66, 0.62, 0.60}, 0.60 * fina - grano);
    const double borde = std::min({u, 128 - u, v, 128 - v});
    return mezcla({0.45, 0.44, 0.43}, c, escalon(1.5, 3, borde));
}

// Mosaico de 32 × 32 teselas, que son sus texels: losas claras y oscuras con un rombo y una junta de un texel.
Color mosaico(double x, double y) {
    const int i = int(x), j = int(y), u = i % 16, v = j % 16;
    const bool clara = i / 16 == j / 16;
    const double tono = 0.9 + 0.1 * azar(i, j, 121);
    const int rombo = std::abs(2 * u - 16) + std::abs(2 * v - 16); // el centro, en el texel (8, 8)
    if (u == 0 || v == 0)
        return tono * Color{0.55, 0.53, 0.50};
    if (rombo <= 4 || (rombo >= 8 && rombo <= 10))
        return tono * (clara ? Color{0.80, 0.36, 0.20} : Color{0.98, 0.78, 0.15});
    return tono * (clara ? Color{0.97, 0.94, 0.88} : Color{0.14, 0.25, 0.38});
}

// Matas de musgo.
Color musgo(double x, double y) {
    const auto altura = [](double u, double v) {
        const double matas = nubes(u / 32, v / 32, 2, 8, 8, 41);
        return 0.6 * matas + 0.4 * nubes(u / 6.4, v / 6.4, 3, 40, 40, 42);
    };
    const double h = altura(x, y), luz = 0.5 + 2.2 * (altura(x - 1.5, y + 1.5) - h);
    const Color c = mezcla({0.16, 0.27, 0.07}, {0.56, 0.66, 0.20}, escalon(0.25, 0.72, h));
    return (0.62 + 0.75 * entre01(1 - luz)) * c;
}

// Cuánto musgo hay en cada punto de una pared de 4 × 3: sube desde el suelo y baja por una esquina.
Color mascara(double x, double y) {
    const double s = x / 128, t = y / 96, n = nubes(x / 18, y / 18, 4, 0, 0, 51);
    const double suelo = 0.55 - 1.9 * t, esquina = 0.62 - 1.5 * modulo(s - 1.03, t - 1.02);
    const double m = escalon(-0.10, 0.16, std::max(suelo, esquina) + 0.95 * (n - 0.5));
    return {m, m, m};
}

// Luz que llega a una pared de 4 × 3: la del anochecer y dos apliques que alumbran hacia abajo y hacia
// arriba.
Color luz(double x, double y) {
    const double X = x / 16, Y = y / 16;
    Color c = (0.85 + 0.15 * Y / 3) * Color{0.30, 0.33, 0.44};
    for (const double cx : {1.05, 2.95}) {
        const double dx = X - cx, dy = Y - 1.80, dz = 0.45, d = modulo(dx, dy, dz);
        const double abajo = escalon(0.40, 0.80, -dy / d), arriba = escalon(0.50, 0.88, dy / d);
        c = c + (4.5 * (abajo + 0.7 * arriba) * dz / (d * d * d) + 0.04 / (d * d)) * Color{1.0, 0.82, 0.56};
    }
    return {c.r / (0.75 + 0.6 * c.r), c.g / (0.78 + 0.6 * c.g), c.b / (0.85 + 0.6 * c.b)};
}

// --- Carta de ajuste ---------------------------------------------------------------------------------------

// Letras de 5 × 7; cada cifra hexadecimal doble es una fila, la de arriba primero.
struct Letra {
    char nombre;
    std::uint8_t filas[7];
};
const Letra LETRAS[] = {
    {'A', {0x0E, 0x11, 0x11, 0x1F, 0x11, 0x11, 0x11}}, {'B', {0x1E, 0x11, 0x11, 0x1E, 0x11, 0x11, 0x1E}},
    {'C', {0x0E, 0x11, 0x10, 0x10, 0x10, 0x11, 0x0E}}, {'D', {0x1E, 0x11, 0x11, 0x11, 0x11, 0x11, 0x1E}},
    {'1', {0x04, 0x0C, 0x04, 0x04, 0x04, 0x04, 0x0E}}, {'2', {0x0E, 0x11, 0x01, 0x06, 0x08, 0x10, 0x1F}},
    {'3', {0x0E, 0x11, 0x01, 0x06, 0x01, 0x11, 0x0E}}, {'4', {0x02, 0x06, 0x0A, 0x12, 0x1F, 0x02, 0x02}},
    {'s', {0x00, 0x00, 0x0F, 0x10, 0x0E, 0x01, 0x1E}}, {'t', {0x08, 0x08, 0x1E, 0x08, 0x08, 0x09, 0x06}},
};

// Si (x, y) cae en un trazo de la letra cuya esquina inferior izquierda es (x0, y0), de puntos de `talla`.
bool enLetra(char nombre, double x, double y, double x0, double y0, double talla) {
    const double u = (x - x0) / talla, v = 7 - (y - y0) / talla;
    if (u < 0 || u >= 5 || v < 0 || v >= 7)
        return false;
    for (const Letra &letra : LETRAS)
        if (letra.nombre == nombre)
            return letra.filas[int(v)] >> (4 - int(u)) & 1;
    return false;
}

// Tablero de 4 × 4 casillas con letra (s) y número (t); los ejes s y t, en los bordes donde t o s valen 0.
Color carta(double x, double y) {
    const Color rojo{0.85, 0.20, 0.18}, verde{0.20, 0.62, 0.28}, oscuro{0.16, 0.17, 0.20},
        blanco{0.97, 0.97, 0.95};
    const Color tonos[4] = {{0.98, 0.78, 0.15}, {0.95, 0.55, 0.10}, {0.56, 0.24, 0.66}, {0.16, 0.38, 0.80}};
    const int columna = int(x / 64), fila = int(y / 64);
    const bool clara = (columna + fila) % 2 != 0;
    const Color tono = mezcla(tonos[columna], blanco, 0.10 * fila);
    // los ejes: una banda con su nombre y una flecha, que no llegan al borde porque GL_CLAMP_TO_EDGE lo
    // estira
    const auto flecha = [](double a, double b) {
        const double ancho = a < 222 ? 1.5 : (246 - a) * 0.16;
        return a > 136 && a < 246 && std::fabs(b - 8) < ancho;
    };
    if (x < 16 && y < 16)
        return oscuro;
    if (y < 16)
        return flecha(x, y) || enLetra('s', x, y, 112, 4, 2) ? blanco : rojo;
    if (x < 16)
        return flecha(y, x) || enLetra('t', x, y, 4, 108, 2) ? blanco : verde;
    const double x0 = 64 * columna + (columna ? 10 : 18), y0 = 64 * fila + (fila ? 18 : 26);
    const char letra = char('A' + columna), numero = char('1' + fila);
    if (enLetra(letra, x, y, x0, y0, 4) || enLetra(numero, x, y, x0 + 24, y0, 4))
        return clara || columna < 2 ? oscuro : blanco;
    return clara ? mezcla(tono, blanco, 0.72) : tono;
}

// --- «Fotografía»: un lago al anochecer; x va de 0 a 1.316 e y de 0 (abajo) a 1 ----------------------------

const double HORIZONTE = 0.44, SOL_X = 0.50, SOL_Y = 0.485;

Color cielo(double x, double y) {
    const double h = entre01((y - HORIZONTE) / (1 - HORIZONTE)), d = modulo(x - SOL_X, 1.5 * (y - SOL_Y));
    Color c = mezcla({0.99, 0.70, 0.40}, {0.86, 0.52, 0.52}, escalon(0, 0.28, h));
    c = mezcla(c, {0.42, 0.44, 0.68}, escalon(0.15, 0.60, h));
    c = mezcla(c, {0.17, 0.25, 0.50}, escalon(0.50, 1.05, h));
    // nubes más chatas cuanto más lejos, encendidas por debajo
    const double v = 0.9 / (h + 0.22), u = (x - SOL_X) * v,
                 espesor = nubes(2.2 * u + 9, 5.5 * v, 5, 0, 0, 61);
    const double densidad = escalon(0.50, 0.68, espesor + 0.05 * h) * escalon(0.02, 0.12, h);
    const double debajo = nubes(2.2 * u + 9, 5.5 * v + 0.35, 5, 0, 0, 61);
    const Color nube =
        mezcla({0.42, 0.36, 0.50}, {1.0, 0.72, 0.52}, entre01(0.55 + 5 * (espesor - debajo) - 0.35 * h));
    c = mezcla(c, nube, 0.85 * densidad);
    c = c + (0.30 / (1 + 40 * d * d)) * Color{1.0, 0.62, 0.25};
    return mezcla({1.0, 0.96, 0.80}, c, escalon(0.028, 0.036, modulo(x - SOL_X, y - SOL_Y)));
}

// Las sierras del fondo, delante del cielo.
Color fondo(double x, double y) {
    Color c = cielo(x, y);
    const double lejana =
        HORIZONTE + 0.02 +
        0.20 * nubes(2.3 * x + 3.1, 0.5, 5, 0, 0, 62) * escalon(0.1, 0.9, std::fabs(x - SOL_X) + 0.25);
    const double cercana =
        HORIZONTE + 0.11 * nubes(3.5 * x + 7.7, 0.5, 5, 0, 0, 63) * escalon(0.05, 0.7, std::fabs(x - SOL_X));
    c = mezcla(mezcla({0.50, 0.38, 0.50}, {0.76, 0.50, 0.46}, escalon(lejana, HORIZONTE, y)), c,
               escalon(-0.002, 0.002, y - lejana));
    const double bosque = cercana + 0.018 * nubes(60 * x, 2, 2, 0, 0, 64);
    return mezcla(mezcla({0.16, 0.21, 0.22}, {0.32, 0.28, 0.30}, escalon(bosque, HORIZONTE, y)), c,
                  escalon(-0.002, 0.002, y - bosque));
}

Color agua(double x, double y) {
    const double lejos = 0.10 / (HORIZONTE - y + 0.03);
    const double onda = nubes(9 * x * lejos + 2, 60 * lejos, 3, 0, 0, 65) - 0.5;
    const Color reflejo = fondo(x + 0.05 * onda, 2 * HORIZONTE - y + 0.10 * onda + 0.01);
    const double destello = escalon(0.12, 0.26, onda) / (1 + 120 * (x - SOL_X) * (x - SOL_X));
    return mezcla(Color{0.96, 0.82, 0.70} * reflejo, {1.0, 0.88, 0.62}, destello);
}

Color prado(double x, double y) {
    const double hebras = nubes(70 * x + 8 * y, 16 * y, 3, 0, 0, 66),
                 matas = nubes(7 * x, 14 * y, 3, 0, 0, 67);
    Color c = mezcla({0.10, 0.17, 0.07}, {0.40, 0.44, 0.16}, entre01(1.7 * hebras * matas + 0.15));
    // flores: una en alguna de las casillas de una rejilla
    const double u = 34 * x, v = 46 * y, i = std::floor(u), j = std::floor(v);
    const int I = int(i), J = int(j);
    const double d = modulo((u - i - mezcla(0.3, 0.7, azar(I, J, 68))) / 34,
                            (v - j - mezcla(0.3, 0.7, azar(I, J, 69))) / 34);
    if (azar(I, J, 100) < 0.13)
        c = mezcla(azar(I / 4, J / 3, 101) < 0.5 ? Color{0.98, 0.80, 0.22} : Color{0.95, 0.86, 0.92}, c,
                   escalon(0.004, 0.008, d));
    return c;
}

// Árbol de la izquierda: si (x, y) es de él, cambia c.
void arbol(double x, double y, Color &c) {
    const double torcido = 0.17 + 0.03 * (nubes(3 * y, 1, 2, 0, 0, 70) - 0.5),
                 grueso = 0.020 + 0.45 * potencia2(entre01(0.42 - y), 1);
    if (y > 0.19 + 0.03 * nubes(90 * x, 3, 2, 0, 0, 74) && y < 0.75 && std::fabs(x - torcido) < grueso) {
        const double corteza = nubes(90 * x, 18 * y, 3, 0, 0, 71);
        c = (0.55 + 0.9 * corteza) *
            mezcla({0.16, 0.11, 0.09}, {0.42, 0.27, 0.17}, entre01(0.5 + (x - torcido) / grueso / 2));
    }
    double copa = -1;
    const double bultos[][3] = {{0.15, 0.74, 0.15}, {0.05, 0.66, 0.12}, {0.27, 0.66, 0.11},
                                {0.17, 0.88, 0.13}, {0.02, 0.82, 0.12}, {0.31, 0.79, 0.10}};
    for (const auto &b : bultos)
        copa = std::max(copa, 1 - modulo(x - b[0], y - b[1]) / b[2]);
    const double hojas = nubes(46 * x, 46 * y, 3, 0, 0, 72), ramas = nubes(11 * x, 11 * y, 3, 0, 0, 73);
    if (copa + 1.3 * (ramas - 0.5) + 0.9 * (hojas - 0.5) > 0.05) {
        const double relieve = ramas - nubes(11 * (x + 0.022), 11 * (y - 0.012), 3, 0, 0, 73);
        const double l = entre01(0.36 - 2.4 * relieve + 1.7 * (hojas - 0.5));
        c = mezcla({0.06, 0.11, 0.06}, {0.55, 0.58, 0.17}, l);
    }
}

// Un cuerpo de revolución visto de frente: (nx, ny) es la normal en la imagen. La luz llega de la izquierda,
// alta, y el cielo rojizo del horizonte asoma en los bordes.
Color ilumina(const Color &base, double nx, double ny, double brillo) {
    const double nz = std::sqrt(std::max(0.0, 1 - nx * nx - ny * ny));
    const double difusa = std::max(0.0, -0.55 * nx + 0.55 * ny + 0.63 * nz);
    const double medio = std::max(0.0, -0.31 * nx + 0.31 * ny + 0.90 * nz);
    const double filo = potencia2(1 - nz, 1);
    return (0.24 + 0.86 * difusa) * base * Color{1.0, 0.95, 0.90} + (0.22 * filo) * Color{0.95, 0.55, 0.40} +
           (brillo * potencia2(medio, 6)) * Color{1, 0.97, 0.92};
}

// Mesa de piedra con una vasija de barro y una bola de porcelana de color carne.
void bodegon(double x, double y, Color &c) {
    const double canto = 0.085;
    if (y < canto + 0.085 && x > 0.60) {
        const double piedra = nubes(24 * x, 40 * y, 4, 0, 0, 81);
        const double sombraBola = modulo((x - 1.135) / 0.165, (y - 0.135) / 0.030),
                     sombraVasija = modulo((x - 0.855) / 0.125, (y - 0.140) / 0.028);
        c = (y > canto ? 0.92 : 0.50) * (0.62 + 0.55 * piedra) * Color{0.78, 0.68, 0.64};
        if (y > canto)
            c = mezcla(0.36, 1, escalon(0.35, 1.2, std::min(sombraBola, sombraVasija))) * c;
    }
    // perfil de la vasija, por altura: pie, panza, cuello y boca
    const double X = x - 0.83, a = (y - 0.130 - 1.8 * X * X * (0.64 - y)) / 0.34;
    if (a > 0 && a < 1) {
        const double perfil[] = {0.070, 0.105, 0.132, 0.142, 0.132, 0.104, 0.070, 0.052, 0.053, 0.072, 0.076};
        const int i = std::min(int(a * 10), 9);
        const double f = a * 10 - i, t = f * f * (3 - 2 * f), radio = mezcla(perfil[i], perfil[i + 1], t);
        if (std::fabs(X) < radio) {
            const double pendiente = (perfil[i + 1] - perfil[i]) / 0.034;
            const double nx = X / radio, n = std::sqrt(1 + pendiente * pendiente);
            Color barro = (0.82 + 0.36 * nubes(30 * x, 90 * y, 3, 0, 0, 82)) * Color{0.76, 0.37, 0.22};
            if ((a > 0.50 && a < 0.53) || (a > 0.22 && a < 0.25)) // dos franjas esmaltadas
                barro = {0.20, 0.32, 0.46};
            const double zigzag = std::fabs(fraccion(nx * 2.5 + 0.25 * nx * nx * nx) - 0.5);
            if (a > 0.27 && a < 0.48 && std::fabs((a - 0.375) / 0.16 - 2 * (zigzag - 0.25)) < 0.20)
                barro = {0.93, 0.80, 0.58};
            c = ilumina(barro, nx / n, -pendiente / n, 0.55);
        }
    }
    const double boca = modulo(X / 0.071, (y - 0.474) / 0.013);
    c = mezcla({0.20, 0.09, 0.06}, c, escalon(0.85, 1, boca));
    const double bx = (x - 1.10) / 0.135, by = (y - 0.262) / 0.135;
    if (bx * bx + by * by < 1) {
        const double manchas = nubes(5 * x, 5 * y, 3, 0, 0, 83);
        c = ilumina(mezcla({0.95, 0.68, 0.55}, {0.88, 0.55, 0.44}, manchas), bx, by, 0.95);
    }
}

Color foto(double px, double py) {
    const double x = px / 190, y = py / 190;
    const double orilla =
        0.27 + 0.05 * (nubes(4 * x, 1, 3, 0, 0, 90) - 0.5) + 0.10 * (SOL_X - x) * (SOL_X - x);
    Color c = y > HORIZONTE ? fondo(x, y) : agua(x, y);
    if (y < orilla + 0.02 * nubes(50 * x, 1, 2, 0, 0, 91))
        c = (0.62 + 1.3 * std::max(0.0, orilla - y)) * prado(x, y) * Color{1.25, 1.1, 1.0};
    arbol(x, y, c);
    bodegon(x, y, c);
    return c;
}

// --- Entorno: lo que se ve desde un prado en cada dirección; el mapa de cubo del capítulo 8 son seis fotos suyas ----

struct Direccion {
    double x, y, z;
};

// Un abeto o un árbol redondo hacia (cx, cz), de copa tan ancha y tan alta vista desde el centro.
struct Arbol {
    double cx, cz, ancho, alto;
    bool abeto;
};
const Arbol ARBOLES[] = {{0.98, -0.20, 0.13, 0.52, true},  {0.90, 0.44, 0.20, 0.42, false},
                         {0.99, 0.12, 0.10, 0.36, true},   {-0.95, -0.31, 0.22, 0.46, false},
                         {-0.99, 0.14, 0.09, 0.34, true},  {-0.91, 0.41, 0.12, 0.50, true},
                         {0.50, 0.87, 0.17, 0.34, false},  {-0.62, 0.78, 0.09, 0.36, true},
                         {-0.66, -0.75, 0.06, 0.24, true}, {0.71, -0.70, 0.05, 0.20, true}};

Color entornoCielo(const Direccion &d) {
    const Direccion sol{-0.48, 0.60, 0.64};
    const double h = entre01(d.y), hacia = d.x * sol.x + d.y * sol.y + d.z * sol.z;
    Color c = mezcla({0.78, 0.88, 0.96}, {0.16, 0.38, 0.78}, 1 - potencia2(1 - h, 1));
    const double u = 1.3 * d.x / (h + 0.18), v = 1.3 * d.z / (h + 0.18),
                 n = nubes(u + 20, v + 20, 5, 0, 0, 131);
    const double sombra = nubes(u + 20 - 0.12 * sol.x, v + 20 - 0.12 * sol.z, 5, 0, 0, 131) - n;
    c = mezcla(c, mezcla({0.72, 0.76, 0.84}, {1, 1, 1}, entre01(0.75 - 3 * sombra)),
               0.95 * escalon(0.50, 0.66, n) * escalon(0.0, 0.22, d.y));
    c = c + 0.55 * potencia2(std::max(hacia, 0.0), 5) * Color{1.0, 0.85, 0.55};
    return mezcla(c, {1.0, 0.99, 0.90}, escalon(0.9965, 0.9975, hacia));
}

Color entornoSuelo(double x, double z) { // a una unidad por debajo del centro
    const double lejos = modulo(x, z), nitidez = 1 / (1 + 0.02 * lejos * lejos);
    const double matas = nubes(1.5 * x + 40, 1.5 * z + 40, 4, 0, 0, 141),
                 franjas =
                     escalon(0.42, 0.58, fraccion(z / 5 + 0.2 * (nubes(x / 3, z / 3, 2, 0, 0, 142) - 0.5)));
    Color c = (0.80 + 0.5 * nitidez * (matas - 0.5)) *
              mezcla({0.33, 0.55, 0.18}, {0.46, 0.66, 0.24}, mezcla(0.5, franjas, nitidez));
    // el camino, de delante a detrás, con sus rodadas
    const double centro = 0.9 * (nubes(z / 7 + 30, 0.5, 2, 0, 0, 143) - 0.5) + 0.04 * z,
                 lado = std::fabs(x - centro), grava = nubes(6 * x, 6 * z, 3, 0, 0, 144);
    const double rodada = escalon(0.16, 0.10, std::fabs(lado - 0.34));
    const Color tierra = (1 + 0.5 * nitidez * (grava - 0.5) - 0.14 * rodada) * Color{0.80, 0.67, 0.48};
    return mezcla(tierra, c, escalon(0.62, 0.74, lado + 0.15 * (grava - 0.5)));
}

Color entorno(const Direccion &haciaDonde) {
    const double largo = modulo(haciaDonde.x, haciaDonde.y, haciaDonde.z);
    const Direccion d{haciaDonde.x / largo, haciaDonde.y / largo, haciaDonde.z / largo};
    const double llano = std::max(modulo(d.x, d.z), 1e-9), hx = d.x / llano, hz = d.z / llano,
                 e = d.y / llano;
    if (e < 0) {
        const Color suelo = entornoSuelo(d.x / -d.y, d.z / -d.y);
        return mezcla({0.52, 0.66, 0.42}, suelo, escalon(0, 0.06, -e));
    }
    Color c = entornoCielo(d);
    // la sierra nevada, delante (−Z); alrededor, colinas
    const double cumbre = nubes(3.2 * hx + 5, 3.2 * hz + 5, 5, 0, 0, 151),
                 sierra = escalon(0.25, 0.85, -hz) * (0.10 + 0.55 * cumbre);
    const double luz = nubes(26 * hx + 3, 9 * e + 8 * hz, 4, 0, 0, 152),
                 nieve = escalon(-0.06, 0.05, e - 0.20 + 0.30 * (luz - 0.5));
    const Color roca = mezcla((0.55 + 0.6 * luz) * Color{0.44, 0.47, 0.58},
                              (0.72 + 0.42 * luz) * Color{0.92, 0.95, 1}, nieve);
    c = mezcla(roca, c, escalon(-0.004, 0.004, e - sierra));
    const double colina = 0.04 + 0.13 * nubes(2.1 * hx + 9, 2.1 * hz + 14, 4, 0, 0, 153),
                 bosque = nubes(40 * hx + 50, 40 * hz + 30 * e + 50, 3, 0, 0, 154);
    c = mezcla((0.6 + 0.7 * bosque) * mezcla({0.30, 0.50, 0.22}, {0.40, 0.58, 0.44}, escalon(0, 0.14, e)), c,
               escalon(-0.004, 0.004, e - colina - 0.02 * bosque));
    for (const Arbol &a : ARBOLES) {
        const double frente = hx * a.cx + hz * a.cz, lado = (hz * a.cx - hx * a.cz) / std::max(frente, 1e-9);
        if (frente < 0.5)
            continue;
        const double hojas = nubes(60 * hx + 80, 60 * hz + 60 * e + 80, 3, 0, 0, 155), t = e / a.alto;
        const double copa =
            a.abeto ? (1 - t) * (0.75 + 0.25 * fraccion(6 * t)) - std::fabs(lado) / a.ancho - (t < 0.12)
                    : 1 - modulo(lado / a.ancho, (t - 0.62) / 0.38);
        const double luzHoja = 0.65 + 0.9 * (hojas - 0.5) + 0.25 * lado / a.ancho * (a.cx > 0 ? -1 : 1);
        if (t < 0.4 && std::fabs(lado) < 0.11 * a.ancho)
            c = (0.7 + 0.5 * hojas) * Color{0.36, 0.25, 0.17};
        if (copa + 0.7 * (hojas - 0.5) > 0)
            c = luzHoja * (a.abeto ? Color{0.13, 0.36, 0.20} : Color{0.36, 0.55, 0.16});
    }
    // detrás (+Z), una casa de tejado rojo
    const double s = hx / std::max(hz, 1e-9) + 0.10;
    if (hz > 0.5 && std::fabs(s) < 0.24 && e < 0.32 - 0.5 * std::fabs(s) && e < 0.32) {
        if (e > 0.14 && e < 0.30 - 0.62 * std::max(0.0, std::fabs(s) - 0.08))
            c = (0.85 + 0.3 * fraccion(60 * e)) * Color{0.74, 0.24, 0.17};
        else if (e <= 0.14 && std::fabs(s) < 0.20)
            c = std::fabs(s) < 0.04 && e < 0.09                                   ? Color{0.35, 0.22, 0.14}
                : std::fabs(std::fabs(s) - 0.12) < 0.028 && e > 0.045 && e < 0.10 ? Color{0.30, 0.42, 0.55}
                                                                                  : Color{0.95, 0.91, 0.82};
    }
    return c;
}

const double LADO_ENTORNO = 256;

// Foto desde el centro: qué dirección se ve a la derecha y hacia arriba de lo que está en `centro`.
template<int CX, int CY, int CZ, int DX, int DZ, int AY, int AZ>
Color fotoEntorno(double x, double y) {
    const double a = 2 * x / LADO_ENTORNO - 1, b = 2 * y / LADO_ENTORNO - 1;
    return entorno({CX + a * DX, CY + b * AY, CZ + a * DZ + b * AZ});
}

// La misma foto con cinco cambios: la bola es azul, hay un velero y una luna, falta una nube y una franja de
// la vasija es verde.
Color fotoCambiada(double px, double py) {
    const double x = px / 190, y = py / 190;
    Color c = foto(px, py);
    const double bx = (x - 1.10) / 0.135, by = (y - 0.262) / 0.135;
    if (bx * bx + by * by < 1)
        c = ilumina({0.45, 0.62, 0.92}, bx, by, 0.95);
    const double vela = (x - 0.645) / 0.035, alto = (y - 0.385) / 0.11;
    if (alto > 0 && alto < 1 && vela > alto - 1 && vela < 1 - alto && std::fabs(vela) > 0.08)
        c = vela < 0 ? Color{0.97, 0.95, 0.90} : Color{0.90, 0.30, 0.22};
    if (std::fabs(alto + 0.10) < 0.08 && std::fabs(vela) < 1.1 + 2 * alto)
        c = {0.30, 0.17, 0.12};
    c = mezcla({0.97, 0.96, 0.88}, c, escalon(0.040, 0.046, modulo(x - 1.17, y - 0.86)));
    if (modulo(x - 0.62, (y - 0.80) * 2.2) < 0.10)
        c = mezcla({0.30, 0.36, 0.60}, c, escalon(0.06, 0.10, modulo(x - 0.62, (y - 0.80) * 2.2)));
    const double X = x - 0.83, a = (y - 0.130 - 1.8 * X * X * (0.64 - y)) / 0.34;
    if (a > 0.50 && a < 0.53 && std::fabs(X) < 0.104)
        c = c + Color{0.0, 0.30, -0.10};
    return c;
}

// --- Dos caras con los mismos rasgos, para pasar de una a otra; x va de 0 a 4/3 e y de 0 (abajo) a 1 ---------

// Un disco o una elipse de semiejes a y b: 1 dentro y 0 fuera, con el canto suavizado.
double elipse(double x, double y, double cx, double cy, double a, double b) {
    return 1 - escalon(0.985, 1.015, modulo((x - cx) / a, (y - cy) / b));
}
// 1 a menos de medio grosor del arco de parábola y = cy + k·(x − cx)², |x − cx| < largo.
double arco(double x, double y, double cx, double cy, double k, double largo, double grosor) {
    const double dx = x - cx, pendiente = 2 * k * dx, d = std::fabs(y - cy - k * dx * dx);
    return (1 - escalon(0.8 * grosor, grosor, 2 * d / std::sqrt(1 + pendiente * pendiente))) *
           (1 - escalon(0.97, 1.03, std::fabs(dx) / largo));
}
// 1 dentro del triángulo de vértices a, b y c, en sentido antihorario.
double triangulo(double x, double y, const double (&v)[3][2]) {
    double dentro = 1;
    for (int i = 0; i < 3; ++i) {
        const double *p = v[i], *q = v[(i + 1) % 3], dx = q[0] - p[0], dy = q[1] - p[1];
        dentro *= escalon(-0.004, 0.004, (dx * (y - p[1]) - dy * (x - p[0])) / modulo(dx, dy));
    }
    return dentro;
}
// Lo esférico de la cara: más clara arriba a la izquierda.
double bulto(double x, double y, double cx, double cy, double r) {
    const double dx = (x - cx) / r, dy = (y - cy) / r;
    return 1.03 - 0.10 * dx + 0.10 * dy - 0.10 * (dx * dx + dy * dy);
}

const double MEDIO = 2.0 / 3;

// Niña pelirroja con pecas sobre fondo azul.
Color cara(double px, double py) {
    const double x = px / 240, y = py / 240, lado = std::fabs(x - MEDIO); // simétrica
    Color c = mezcla({0.55, 0.78, 0.90}, {0.30, 0.52, 0.78}, y);
    const Color piel{0.98, 0.80, 0.68}, pelo{0.80, 0.36, 0.14}, oscuro{0.20, 0.12, 0.10};
    const double mechas = 0.85 + 0.3 * nubes(40 * x, 4 * y, 2, 0, 0, 201);
    c = mezcla(c, mechas * pelo, elipse(x, y, MEDIO, 0.52, 0.375, 0.43));   // pelo por detrás
    c = mezcla(c, mechas * pelo, elipse(lado, y, 0.39, 0.30, 0.085, 0.17)); // coletas
    c = mezcla(c, {0.95, 0.78, 0.15}, elipse(lado, y, 0.36, 0.44, 0.05, 0.035));
    c = mezcla(c, {0.86, 0.25, 0.30}, elipse(x, y, MEDIO, -0.06, 0.30, 0.19)); // jersey
    c = mezcla(c, 0.90 * piel, elipse(x, y, MEDIO, 0.14, 0.09, 0.12));
    c = mezcla(c, 0.94 * piel, elipse(lado, y, 0.285, 0.47, 0.045, 0.07)); // orejas
    c = mezcla(c, bulto(x, y, MEDIO, 0.46, 0.33) * piel, elipse(x, y, MEDIO, 0.46, 0.28, 0.34));
    const double flequillo = elipse(x, y, MEDIO, 0.80, 0.27, 0.165);
    c = mezcla(c, mechas * pelo, flequillo * elipse(x, y, MEDIO, 0.52, 0.375, 0.43));
    c = mezcla(c, {0.97, 0.55, 0.50},
               0.55 * (1 - escalon(0.2, 1, modulo((lado - 0.17) / 0.08, (y - 0.36) / 0.06))));
    c = mezcla(c, {1, 1, 1}, elipse(lado, y, 0.125, 0.50, 0.055, 0.050)); // ojos
    c = mezcla(c, {0.25, 0.55, 0.30}, elipse(lado, y, 0.125, 0.50, 0.036, 0.040));
    c = mezcla(c, oscuro, elipse(lado, y, 0.125, 0.50, 0.019, 0.022));
    c = mezcla(c, {1, 1, 1}, elipse(x - (x < MEDIO ? -0.125 : 0.125), y, MEDIO - 0.012, 0.515, 0.010, 0.011));
    c = mezcla(c, 0.6 * pelo, arco(lado, y, 0.125, 0.60, -4, 0.06, 0.022));         // cejas
    c = mezcla(c, {0.86, 0.58, 0.46}, arco(x, y, MEDIO, 0.375, 10, 0.035, 0.016));  // nariz
    c = mezcla(c, {0.72, 0.20, 0.22}, arco(x, y, MEDIO, 0.225, 3.5, 0.105, 0.026)); // boca
    for (int i = 0; i < 5; ++i)                                                     // pecas
        c = mezcla(c, {0.80, 0.50, 0.34},
                   0.8 * elipse(lado, y, 0.10 + 0.026 * i, 0.375 + 0.02 * ((i * 3) % 4 - 1.5), 0.007, 0.007));
    return c;
}

// Gato gris a rayas sobre fondo verde: los ojos, más abiertos y más altos, y la boca y el hocico, más juntos.
Color gato(double px, double py) {
    const double x = px / 240, y = py / 240, lado = std::fabs(x - MEDIO);
    Color c = mezcla({0.62, 0.80, 0.52}, {0.36, 0.62, 0.44}, y);
    const Color gris{0.62, 0.60, 0.62}, blanco{0.97, 0.95, 0.92}, rosa{0.93, 0.58, 0.58},
        oscuro{0.13, 0.11, 0.13};
    const double pelaje = 0.90 + 0.2 * nubes(60 * x, 60 * y, 2, 0, 0, 203);
    c = mezcla(c, 0.9 * pelaje * gris, elipse(x, y, MEDIO, -0.12, 0.34, 0.30)); // cuerpo
    c = mezcla(c, blanco, elipse(x, y, MEDIO, 0.0, 0.13, 0.16));
    c = mezcla(c, 0.9 * pelaje * gris,
               triangulo(lado, y, {{0.10, 0.68}, {0.36, 0.52}, {0.36, 0.97}})); // orejas
    c = mezcla(c, rosa, triangulo(lado, y, {{0.18, 0.70}, {0.325, 0.60}, {0.33, 0.89}}));
    c = mezcla(c, bulto(x, y, MEDIO, 0.44, 0.40) * pelaje * gris, elipse(x, y, MEDIO, 0.44, 0.39, 0.32));
    for (int i = 0; i < 3; ++i) // rayas
        c = mezcla(c, 0.55 * gris, arco(lado, y, 0.34, 0.36 + 0.065 * i, 2, 0.055, 0.022));
    for (const double raya : {0.0, 0.055})
        c = mezcla(c, 0.55 * gris,
                   (1 - escalon(0.008, 0.014, std::fabs(lado - raya))) * escalon(0.62, 0.64, y + raya / 4) *
                       (1 - escalon(0.71, 0.74, y + raya / 4)));
    c = mezcla(c, blanco, elipse(lado, y, 0.065, 0.27, 0.095, 0.080));              // hocico
    c = mezcla(c, {0.96, 0.85, 0.30}, elipse(lado, y, 0.175, 0.485, 0.078, 0.075)); // ojos
    c = mezcla(c, oscuro, elipse(lado, y, 0.175, 0.485, 0.022, 0.066));
    c = mezcla(c, {1, 1, 1}, elipse(x - (x < MEDIO ? -0.175 : 0.175), y, MEDIO - 0.022, 0.515, 0.014, 0.016));
    c = mezcla(c, rosa, triangulo(x, y, {{MEDIO - 0.045, 0.355}, {MEDIO, 0.305}, {MEDIO + 0.045, 0.355}}));
    c = mezcla(c, oscuro,
               (1 - escalon(0.005, 0.008, lado)) * escalon(0.268, 0.274, y) * (1 - escalon(0.305, 0.310, y)));
    c = mezcla(c, oscuro, arco(lado, y, 0.055, 0.245, 8, 0.055, 0.015)); // boca
    for (int i = -1; i <= 1; ++i)                                        // bigotes
        c = mezcla(c, blanco,
                   (1 - escalon(0.003, 0.006, std::fabs(y - 0.29 - 0.02 * i - 0.28 * i * (lado - 0.12)))) *
                       escalon(0.15, 0.17, lado) * (1 - escalon(0.42, 0.45, lado)));
    return c;
}

// --- Ficheros ----------------------------------------------------------------------------------------------

// Cada texel es la media de LADO × LADO muestras. Con `veces`, `color` es una escena tantas veces menor, y bastan 2×2.
std::vector<std::uint8_t> pinta(int ancho, int alto, const std::function<Color(double, double)> &color,
                                int veces) {
    const int LADO = veces == 1 ? 4 : 2;
    std::vector<std::uint8_t> rgb;
    for (int fila = 0; fila < alto; ++fila)
        for (int x = 0; x < ancho; ++x) {
            Color suma;
            for (int i = 0; i < LADO * LADO; ++i) {
                const Color c = color((x + (i % LADO + 0.5) / LADO) / veces,
                                      (alto - 1 - fila + (i / LADO + 0.5) / LADO) / veces);
                suma = suma + Color{entre01(c.r), entre01(c.g), entre01(c.b)};
            }
            for (const double k : {suma.r, suma.g, suma.b})
                rgb.push_back(std::uint8_t(k / (LADO * LADO) * 255 + 0.5));
        }
    return rgb;
}

struct Asset {
    const char *nombre;
    int ancho, alto;
    Color (*color)(double, double);
    int veces = 1; // lo que se aumenta la escena
};
const Asset ASSETS[] = {{"metal", 256, 256, metal},
                        {"madera", 256, 256, madera},
                        {"ladrillo", 256, 256, ladrillo},
                        {"carta", 256, 256, carta},
                        {"foto", 250, 190, foto},
                        {"musgo", 256, 256, musgo},
                        {"baldosas", 256, 256, baldosas},
                        {"mascara", 128, 96, mascara},
                        {"luz", 64, 48, luz},
                        {"mosaico", 32, 32, mosaico},
                        {"entorno_derecha", 512, 512, fotoEntorno<1, 0, 0, 0, 1, 1, 0>, 2},
                        {"entorno_izquierda", 512, 512, fotoEntorno<-1, 0, 0, 0, -1, 1, 0>, 2},
                        {"entorno_arriba", 512, 512, fotoEntorno<0, 1, 0, 1, 0, 0, 1>, 2},
                        {"entorno_abajo", 512, 512, fotoEntorno<0, -1, 0, 1, 0, 0, -1>, 2},
                        {"entorno_detras", 512, 512, fotoEntorno<0, 0, 1, -1, 0, 1, 0>, 2},
                        {"entorno_delante", 512, 512, fotoEntorno<0, 0, -1, 1, 0, 1, 0>, 2},
                        {"foto_grande", 1000, 760, foto, 4},
                        {"foto_cambiada", 1000, 760, fotoCambiada, 4},
                        {"cara", 960, 720, cara, 3},
                        {"gato", 960, 720, gato, 3}};

} // namespace

int main(int argc, char **argv) {
    if (argc != 2) {
        std::fprintf(stderr, "uso: genera_assets CARPETA\n");
        return 2;
    }
    for (const Asset &a : ASSETS) {
        const std::string ruta = std::string(argv[1]) + "/" + a.nombre + ".rgb";
        const std::vector<std::uint8_t> rgb = pinta(a.ancho, a.alto, a.color, a.veces);
        FILE *f = std::fopen(ruta.c_str(), "wb");
        const bool escrito = f && std::fwrite(rgb.data(), 1, rgb.size(), f) == rgb.size();
        if (!f || std::fclose(f) != 0 || !escrito) {
            std::perror(("genera_assets: no puedo escribir " + ruta).c_str());
            return 1;
        }
    }
    return 0;
}
