// Comprobaciones independientes de primitivas, modelo_poligonal y figura_color: qué color debe haber en un
// píxel, calculado en doble precisión con las coordenadas de los vértices.
#include "colores.h"
#include "ejecuta.h"
#include "rotulos.h"
#include <GL/glew.h>
#include <GL/freeglut.h>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <sstream>
#include <vector>

namespace {

struct V {
    double x, y, r, g, b;
};

double area(const V &a, const V &b, double x, double y) {
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

// El color baricéntrico en (x, y), de 0 a 255; `dentro` es la menor coordenada baricéntrica.
V baricentrico(const V &a, const V &b, const V &c, double x, double y, double &dentro) {
    const double total = area(a, b, c.x, c.y), wa = area(b, c, x, y) / total, wb = area(c, a, x, y) / total,
                 wc = 1 - wa - wb;
    dentro = std::min(wa, std::min(wb, wc));
    return {x, y, 255 * (wa * a.r + wb * b.r + wc * c.r), 255 * (wa * a.g + wb * b.g + wc * c.g),
            255 * (wa * a.b + wb * b.b + wc * c.b)};
}

// El color esperado redondeado puede diferir en un nivel: el que pierde la GPU al interpolar en float.
void esperaColor(const Imagen &imagen, int x, int y, const V &esperado) {
    const Pixel p = pixel(imagen, x, y);
    EXPECT_NEAR(p.r, esperado.r, 1) << x << "," << y;
    EXPECT_NEAR(p.g, esperado.g, 1) << x << "," << y;
    EXPECT_NEAR(p.b, esperado.b, 1) << x << "," << y;
    apuntaDiferencia(
        std::max({std::fabs(p.r - esperado.r), std::fabs(p.g - esperado.g), std::fabs(p.b - esperado.b)}));
}

const std::vector<V> VERTICES = {{0, -0.62, 0.95, 0.55, 0.10},     {0.74, -0.38, 0.85, 0.20, 0.18},
                                 {0.31, -0.07, 0.16, 0.38, 0.80},  {0, 0.64, 0.20, 0.62, 0.28},
                                 {-0.31, -0.07, 0.98, 0.78, 0.15}, {-0.74, -0.38, 0.56, 0.24, 0.66}};
const char *const NOMBRES[] = {"GL_POINTS",    "GL_LINES",          "GL_LINE_STRIP",  "GL_LINE_LOOP",
                               "GL_TRIANGLES", "GL_TRIANGLE_STRIP", "GL_TRIANGLE_FAN"};

double diferencia(const Pixel &p, const V &v) { // en niveles, de un color de 0 a 255
    return std::max({std::fabs(p.r - v.r), std::fabs(p.g - v.g), std::fabs(p.b - v.b)});
}
bool esDe(const Pixel &p, const V &v) {
    return diferencia(p, {0, 0, 255 * v.r, 255 * v.g, 255 * v.b}) <= 1;
}

bool esFondo(const Pixel &p) {
    return esDe(p, {0, 0, 0.95, 0.96, 0.98});
}

bool esDeRotulo(const Pixel &p) {
    return esDe(p, {0, 0, 0.16, 0.17, 0.20}) || esDe(p, {0, 0, 1, 1, 1});
}

// La figura de una sola primitiva: un cuadrado de nueve décimos del alto, abajo en el centro.
const int MEDIO = 81; // en 240×180

// Las coordenadas de dispositivo del centro de un píxel en el cuadrado centrado de una ventana.
double ndcX(int x, int ancho, int alto) {
    return (x + 0.5 - (ancho - alto) / 2) / alto * 2 - 1;
}
double ndcY(int y, int alto) {
    return (y + 0.5) / alto * 2 - 1;
}

} // namespace

// Cada punto es un cuadrado del color de su vértice, y no hay más. El lado es 648/14 píxeles; OpenGL deja elegir el redondeo,
// y el halo de su número le come algo.
TEST(Primitivas, Puntos) {
    const Ejecucion e = ejecuta("ch02_modelado/primitivas", "tecla 1", 960, 720);
    ASSERT_EQ(e.estado, 0) << e.errores;
    std::vector<int> cuantos(VERTICES.size(), 0);
    int otros = 0;
    for (int y = 0; y < 720; ++y)
        for (int x = 0; x < 960; ++x) {
            const Pixel p = pixel(e.imagen, x, y);
            bool visto = esFondo(p) || esDeRotulo(p);
            for (std::size_t i = 0; i < VERTICES.size(); ++i)
                if (esDe(p, VERTICES[i])) {
                    ++cuantos[i];
                    visto = true;
                    EXPECT_NEAR(x + 0.5, 480 + VERTICES[i].x * 324, 24);
                    EXPECT_NEAR(y + 0.5, 324 + VERTICES[i].y * 324, 24);
                }
            otros += !visto;
        }
    EXPECT_EQ(otros, 0);
    for (int n : cuantos)
        EXPECT_NEAR(n, 648.0 / 14 * 648 / 14, 150);
}

// En el medio de cada segmento, el color de su último vértice; en el medio de los que no tocan, el fondo.
TEST(Primitivas, Segmentos) {
    const bool hay[3][6] = {{true, false, true, false, true, false}, // GL_LINES
                            {true, true, true, true, true, false},   // GL_LINE_STRIP
                            {true, true, true, true, true, true}};   // GL_LINE_LOOP
    for (int k = 0; k < 3; ++k) {
        const Ejecucion e = ejecuta("ch02_modelado/primitivas", "tecla " + std::to_string(k + 2), 960, 720);
        ASSERT_EQ(e.estado, 0) << e.errores;
        for (std::size_t i = 0; i < 6; ++i) {
            const V &a = VERTICES[i], &b = VERTICES[(i + 1) % 6];
            const double x = 480 + (a.x + b.x) / 2 * 324, y = 324 + (a.y + b.y) / 2 * 324;
            // y a lo ancho: el pincel mide 19 píxeles, contados en vertical o en horizontal
            const bool tendido = std::fabs(b.x - a.x) > std::fabs(b.y - a.y);
            int ancho = 0;
            for (int d = -30; d <= 30; ++d) {
                const Pixel p = pixel(e.imagen, static_cast<int>(x) + (tendido ? 0 : d),
                                      static_cast<int>(y) + (tendido ? d : 0));
                ancho += esDe(p, b);
            }
            if (hay[k][i]) {
                EXPECT_TRUE(ancho >= 19 && ancho <= 38)
                    << "tecla " << k + 2 << " segmento " << i << ": " << ancho;
                EXPECT_TRUE(esDe(pixel(e.imagen, static_cast<int>(x), static_cast<int>(y)), b));
            } else {
                EXPECT_TRUE(esFondo(pixel(e.imagen, static_cast<int>(x), static_cast<int>(y))))
                    << "tecla " << k + 2 << " segmento " << i;
            }
        }
    }
}

// Cada píxel, por la prueba de semiplanos: el triángulo que lo contiene (los de la tira y los del abanico no
// se solapan) dice su color; a menos de 1/256 de píxel de un lado no se mira.
TEST(Primitivas, Triangulos) {
    const std::vector<std::vector<int>> triangulos[3] = {{{0, 1, 2}, {3, 4, 5}},
                                                         {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 5}},
                                                         {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}};
    for (int k = 0; k < 3; ++k) {
        const Ejecucion e = ejecuta("ch02_modelado/primitivas", "tecla " + std::to_string(k + 5));
        ASSERT_EQ(e.estado, 0) << e.errores;
        int comparados = 0;
        double maximo = 0;
        for (int py = 0; py < 180; ++py)
            for (int px = 0; px < 240; ++px) {
                const double x = (px + 0.5 - 120) / MEDIO, y = (py + 0.5 - MEDIO) / MEDIO;
                const V *esperado = nullptr;
                bool dudoso = false;
                int cuantos = 0;
                for (const auto &t : triangulos[k]) {
                    const V *v[3];
                    for (std::size_t i = 0; i < 3; ++i)
                        v[i] = &VERTICES[static_cast<std::size_t>(t[i])];
                    const double giro = area(*v[0], *v[1], v[2]->x, v[2]->y) > 0 ? 1 : -1;
                    double distancia = 1e9; // al lado más próximo, en píxeles; positiva dentro
                    for (std::size_t i = 0; i < 3; ++i) {
                        const V &a = *v[i], &b = *v[(i + 1) % 3];
                        distancia = std::min(distancia, giro * area(a, b, x, y) /
                                                            std::hypot(b.x - a.x, b.y - a.y) * MEDIO);
                    }
                    dudoso = dudoso || std::fabs(distancia) < 1.0 / 256;
                    if (distancia > 0) {
                        esperado =
                            v[2]; // el último vértice es el mayor de los tres índices en las tres primitivas
                        ++cuantos;
                    }
                }
                if (dudoso)
                    continue;
                ASSERT_LE(cuantos, 1);
                const Pixel p = pixel(e.imagen, px, py);
                if (esDeRotulo(p))
                    continue;
                ASSERT_TRUE(esperado ? esDe(p, *esperado) : esFondo(p))
                    << "tecla " << k + 5 << ": " << px << "," << py;
                if (esperado)
                    maximo = std::max(maximo, diferencia(p, {0, 0, 255 * esperado->r, 255 * esperado->g,
                                                             255 * esperado->b}));
                ++comparados;
            }
        apuntaDiferencia(maximo, -1, 1.0 / 256);
        EXPECT_GT(comparados, 240 * 180 * 95 / 100);
    }
}

// El nombre y el número de cada vértice, junto a él y por fuera de la figura.
TEST(Primitivas, Rotulos) {
    for (int k = 0; k < 7; ++k) {
        const Ejecucion e = ejecuta("ch02_modelado/primitivas", "tecla " + std::to_string(k + 1), 960, 720);
        const auto nombre = buscaRotulo(e.imagen, enLetras(NOMBRES[k]), OSCURO, 4);
        ASSERT_EQ(nombre.size(), 1u) << NOMBRES[k];
        EXPECT_GT(nombre[0].y, 660);
        for (std::size_t i = 0; i < VERTICES.size(); ++i) {
            const glm::dvec2 v(480 + VERTICES[i].x * 324, 324 + VERTICES[i].y * 324);
            const glm::dvec2 r = rotuloJunto(e.imagen, enLetras(static_cast<int>(i)), OSCURO, 8, v);
            EXPECT_LT(glm::distance(r, v), 64) << NOMBRES[k] << " vértice " << i;
            EXPECT_GT(glm::distance(r, v), 28) << NOMBRES[k] << " vértice " << i;
        }
    }
}

// En la rejilla está cada primitiva con su nombre y los colores de lo que sale de ella: los del último vértice de cada punto,
// segmento o triángulo.
TEST(Primitivas, LaRejillaTieneSietePaneles) {
    const Ejecucion e = ejecuta("ch02_modelado/primitivas", "", 960, 720);
    ASSERT_EQ(e.estado, 0) << e.errores;
    const std::u32string ultimaLinea[] = {U"GL_POINTS", U"GL_LINES", U"STRIP", U"LOOP",
                                          U"TRIANGLES", U"STRIP",    U"FAN",   U"vértice"};
    const bool sale[8][6] = {
        {true, true, true, true, true, true},     {false, true, false, true, false, true},
        {false, true, true, true, true, true},    {true, true, true, true, true, true},
        {false, false, true, false, false, true}, {false, false, true, true, true, true},
        {false, false, true, true, true, true},   {}};
    for (int k = 0; k < 8; ++k) {
        const int x0 = k % 4 * 240, y0 = k < 4 ? 360 : 0;
        bool hayNombre = false;
        for (const Rotulo &r : buscaRotulo(e.imagen, ultimaLinea[k], OSCURO, 4))
            hayNombre = hayNombre || (r.x > x0 && r.x < x0 + 240 && r.y > y0 && r.y < y0 + 360);
        EXPECT_TRUE(hayNombre) << k;
        for (std::size_t i = 0; i < 6; ++i) {
            int pixeles = 0;
            for (int y = y0 + 3; y < y0 + 350; ++y)
                for (int x = x0 + 3; x < x0 + 235; ++x)
                    pixeles += esDe(pixel(e.imagen, x, y), VERTICES[i]);
            EXPECT_EQ(pixeles > 0, sale[k][i]) << "panel " << k << " vértice " << i;
        }
    }
    const Ejecucion vuelta =
        ejecuta("ch02_modelado/primitivas", "tecla 6; tamano 1 1; tamano 960 720; tecla 0", 960, 720);
    EXPECT_EQ(e.imagen.rgb, vuelta.imagen.rgb);
}

// El listado 2.4 dibuja sin VAO: un contexto core lo rechaza. Con uno, aunque esté vacío, el mismo dibujo es
// válido. (Cada caso en un proceso, que termina con 3 si hay un error de OpenGL.)
TEST(ModeloPoligonal, SinVaoNoSeDibuja) {
    const auto dibuja = [](bool conVao) {
        char nombre[] = "prueba";
        char *argv[] = {nombre, nullptr};
        int argc = 1;
        glutInit(&argc, argv);
        glutInitContextVersion(3, 1);
        glutCreateWindow("prueba");
        glewExperimental = GL_TRUE;
        glewInit();
        GLuint vao;
        glGenVertexArrays(1, &vao);
        if (conVao)
            glBindVertexArray(vao);
        glDrawArrays(GL_POINTS, 0, 1);
        std::exit(glGetError() == GL_NO_ERROR ? 0 : 3);
    };
    EXPECT_EXIT(dibuja(false), testing::ExitedWithCode(3), "");
    EXPECT_EXIT(dibuja(true), testing::ExitedWithCode(0), "");
}

// Un píxel interior de cada uno de los seis triángulos, con el color baricéntrico exacto.
TEST(ModeloPoligonal, ColorBaricentrico) {
    const std::vector<V> rueda = {{0, 0, 1, 1, 1},           {0, 0.850, 1, 0, 0},  {-0.736, 0.425, 1, 1, 0},
                                  {-0.736, -0.425, 0, 1, 0}, {0, -0.850, 0, 1, 1}, {0.736, -0.425, 0, 0, 1},
                                  {0.736, 0.425, 1, 0, 1}};
    const Ejecucion e = ejecuta("ch02_modelado/modelo_poligonal");
    ASSERT_EQ(e.estado, 0) << e.errores;
    for (std::size_t t = 0; t < 6; ++t) {
        const V &a = rueda[0], &b = rueda[t + 1], &c = rueda[t == 5 ? 1 : t + 2];
        const int px = static_cast<int>(120 + (0.25 * a.x + 0.45 * b.x + 0.30 * c.x) * 90),
                  py = static_cast<int>(90 + (0.25 * a.y + 0.45 * b.y + 0.30 * c.y) * 90);
        double dentro;
        const V esperado = baricentrico(a, b, c, ndcX(px, 240, 180), ndcY(py, 180), dentro);
        ASSERT_GT(dentro, 0.1);
        esperaColor(e.imagen, px, py, esperado);
    }
    const Pixel fondo = pixel(e.imagen, 5, 90);
    EXPECT_TRUE(esDe(fondo, {0, 0, 0.16, 0.17, 0.20}));
}

// El número de cada vértice, por fuera de la rueda (el 0, bajo el centro).
TEST(ModeloPoligonal, Numeros) {
    const double vertices[7][2] = {{0, 0},      {0, 0.850},      {-0.736, 0.425}, {-0.736, -0.425},
                                   {0, -0.850}, {0.736, -0.425}, {0.736, 0.425}};
    const Ejecucion e = ejecuta("ch02_modelado/modelo_poligonal", "", 960, 720);
    for (int i = 0; i < 7; ++i) {
        const glm::dvec2 v(480 + 360 * vertices[i][0], 360 + 360 * vertices[i][1]);
        const glm::dvec2 r = rotuloJunto(e.imagen, enLetras(i), BLANCO, 4, v);
        EXPECT_LT(glm::distance(r, v), 30) << i;
        if (i > 0) {
            EXPECT_GT(glm::distance(r, glm::dvec2(480, 360)), 320) << i;
        }
    }
}

// La forma se conserva: en una ventana alta la rueda es la misma, centrada.
TEST(ModeloPoligonal, ConservaLaForma) {
    const Ejecucion ancha = ejecuta("ch02_modelado/modelo_poligonal", "", 240, 180),
                    alta = ejecuta("ch02_modelado/modelo_poligonal", "tamano 180 240", 240, 180);
    ASSERT_EQ(alta.estado, 0) << alta.errores;
    for (int y = 0; y < 180; y += 7)
        for (int x = 0; x < 180; x += 7) {
            const Pixel p = pixel(ancha.imagen, x + 30, y), q = pixel(alta.imagen, x, y + 30);
            ASSERT_TRUE(p.r == q.r && p.g == q.g && p.b == q.b) << x << "," << y;
        }
}

// Colores esperados en puntos dados, con los de los vértices interpolados en doble precisión. El cuadrado de
// la figura es el ancho de la ventana: 240×240 centrado en 240×180.
TEST(FiguraColor, DegradadosEnPuntosDados) {
    const Ejecucion e = ejecuta("ch02_modelado/figura_color");
    ASSERT_EQ(e.estado, 0) << e.errores;
    struct Muestra {
        double x, y;
        V a, b, c;
    };
    const V noche1{-1, 1, 0.10, 0.12, 0.36}, noche2{1, 1, 0.10, 0.12, 0.36},
        tarde1{-1, 0.45, 0.42, 0.24, 0.55}, tarde2{1, 0.45, 0.42, 0.24, 0.55},
        ocaso1{-1, 0.10, 0.93, 0.42, 0.38}, ocaso2{1, 0.10, 0.93, 0.42, 0.38};
    const V agua1{-1, -0.45, 0.36, 0.33, 0.60}, agua2{1, -0.45, 0.36, 0.33, 0.60},
        hondo1{-1, -1, 0.05, 0.13, 0.33};
    const std::vector<Muestra> muestras = {
        {-0.8, 0.60, noche1, tarde1, tarde2}, // cielo, arriba a la izquierda
        {0.7, 0.65, noche1, noche2, tarde2},  // cielo, arriba a la derecha
        {-0.9, 0.30, tarde1, ocaso1, ocaso2}, // cielo, más abajo
        {-0.9, -0.60, agua1, hondo1, agua2},  // mar
        {0.20,
         -0.10,
         {0.30, -0.36, 0.98, 0.84, 0.70},
         {0.30, 0.52, 1.00, 0.97, 0.92},
         {-0.12, -0.36, 0.95, 0.55, 0.10}}, // vela
        {0.275,
         0.38,
         {0.30, -0.36, 0.98, 0.84, 0.70},
         {0.30, 0.52, 1.00, 0.97, 0.92},
         {-0.12, -0.36, 0.95, 0.55, 0.10}}, // cerca del tope
        {0.45,
         -0.20,
         {0.35, -0.36, 0.85, 0.20, 0.18},
         {0.62, -0.34, 0.72, 0.10, 0.22},
         {0.33, 0.40, 1.00, 0.62, 0.30}},
        {0.30,
         -0.50,
         {0.27, -0.40, 0.55, 0.27, 0.20},
         {-0.06, -0.56, 0.24, 0.11, 0.16},
         {0.56, -0.56, 0.18, 0.08, 0.14}}, // casco
    };
    for (const Muestra &m : muestras) {
        const int px = static_cast<int>(120 + m.x * 120), py = static_cast<int>(90 + m.y * 120);
        double dentro;
        const V esperado = baricentrico(m.a, m.b, m.c, (px + 0.5 - 120) / 120, (py + 0.5 - 90) / 120, dentro);
        ASSERT_GT(dentro, 0.02) << m.x << "," << m.y;
        esperaColor(e.imagen, px, py, esperado);
    }
    // El sol: del centro al borde el color cambia con la distancia (los 24 lados del abanico la acortan un
    // 0.2 % como mucho, menos de un nivel). La columna que sube desde su centro.
    const int px = static_cast<int>(120 - 0.28 * 120);
    for (int k = 2; k < 33; k += 3) {
        const double x = (px + 0.5 - 120) / 120 + 0.28, y = (k + 66 + 0.5 - 90) / 120 + 0.20,
                     t = std::hypot(x, y) / 0.30;
        esperaColor(e.imagen, px, k + 66,
                    {0, 0, 255, 255 * (0.98 + t * (0.62 - 0.98)), 255 * (0.75 + t * (0.16 - 0.75))});
    }
}

TEST(FiguraColor, CubreCualquierVentana) {
    for (const char *guion : {"tamano 300 60", "tamano 60 300", "tamano 1 1"}) {
        const Ejecucion e = ejecuta("ch02_modelado/figura_color", guion);
        ASSERT_EQ(e.estado, 0) << e.errores;
        for (int y = 0; y < e.imagen.alto; ++y)
            for (int x = 0; x < e.imagen.ancho; ++x) {
                const Pixel p = pixel(e.imagen, x, y);
                ASSERT_GT(p.r + p.g + p.b, 0) << guion; // el color de borrado es negro y no debe asomar
            }
    }
}
