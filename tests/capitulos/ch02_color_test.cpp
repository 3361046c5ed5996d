// Comprobaciones independientes de primitivas, modelo_poligonal y figura_color: qué color debe haber en cada píxel,
// calculado en doble precisión con las coordenadas de los vértices.
#include "colores.h"
#include "guiones.h"
#include "plana.h"
#include <gtest/gtest.h>
#include <vector>

namespace {

enum { PUNTOS, SEGMENTOS, TIRA_SEGMENTOS, SECUENCIA_CERRADA, TRIANGULOS, TIRA, ABANICO };
const char *const NOMBRES[][2] = {{"GL_POINTS", "GL_POINTS"},
                                  {"GL_LINES", "GL_LINES"},
                                  {"GL_LINE_STRIP", "GL_LINE_\nSTRIP"},
                                  {"GL_LINE_LOOP", "GL_LINE_\nLOOP"},
                                  {"GL_TRIANGLES", "GL_\nTRIANGLES"},
                                  {"GL_TRIANGLE_STRIP", "GL_\nTRIANGLE_\nSTRIP"},
                                  {"GL_TRIANGLE_FAN", "GL_\nTRIANGLE_\nFAN"}};
const std::vector<VerticePlano> VERTICES = {{0, -0.62, exacto(NARANJA)},      {0.74, -0.38, exacto(ROJO)},
                                            {0.31, -0.07, exacto(AZUL)},      {0, 0.64, exacto(VERDE)},
                                            {-0.31, -0.07, exacto(AMARILLO)}, {-0.74, -0.38, exacto(MORADO)}};
const Lado LADOS[] = {Lado::DEBAJO, Lado::DEBAJO, Lado::DERECHA, Lado::ENCIMA, Lado::IZQUIERDA, Lado::DEBAJO};
const int N = 6;

/// Lo que barre un cuadrado de ese medio lado que va de un punto a otro.
oraculo::Poligono barrido(const oraculo::Vec2 &a, const oraculo::Vec2 &b, double medio) {
    const double dx = b.x < a.x ? -medio : medio, dy = b.y < a.y ? -medio : medio;
    return {{a.x - dx, a.y - dy}, {a.x + dx, a.y - dy}, {b.x + dx, b.y - dy},
            {b.x + dx, b.y + dy}, {b.x - dx, b.y + dy}, {a.x - dx, a.y + dy}};
}

/// Las piezas que salen de los seis vértices en ese cuadrado, cada una del color de su último vértice.
std::vector<Pieza> piezas(int primitiva, const Hueco &h) {
    std::vector<Pieza> p;
    if (primitiva >= TRIANGULOS) {
        const GLenum deOpenGL[] = {GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN};
        p = triangulos(deOpenGL[primitiva - TRIANGULOS], VERTICES, h);
        for (Pieza &pieza : p)
            pieza.colores = {pieza.colores.back()};
    } else if (primitiva ==
               PUNTOS) { // OpenGL deja redondear su lado a un entero y su centro a medio píxel: ¼ + ½
        for (const VerticePlano &v : VERTICES)
            p.push_back({barrido(v.en(h), v.en(h), h.ancho / 28.0), {v.color}, 0.75});
    } else { // un segmento de un píxel se aparta medio en cada extremo y medio a lo ancho
        const int n = primitiva == SECUENCIA_CERRADA ? N : N - 1, paso = primitiva == SEGMENTOS ? 2 : 1;
        for (int i = 0; i < n; i += paso) {
            const VerticePlano &a = VERTICES[i], &b = VERTICES[(i + 1) % N];
            p.push_back({barrido(a.en(h), b.en(h), h.ancho / 72 + 0.5), {b.color}, 1, true});
        }
    }
    return p;
}

struct Esperado {
    std::vector<Pieza> piezas;
    std::vector<Letrero> letreros;

    /// Una primitiva con su nombre y los números de sus vértices, en un panel: sola, o en la rejilla.
    void anade(int primitiva, const Hueco &panel, bool sola) {
        const int alto = sola ? panel.alto * 9 / 10 : panel.alto * 2 / 3, cabe = std::min(panel.ancho, alto);
        const Hueco figura = {panel.x + (panel.ancho - cabe) / 2, panel.y + (alto - cabe) / 2, cabe, cabe};
        piezas.push_back(rectangulo(panel, exacto(FONDO_CLARO)));
        for (const Pieza &p : ::piezas(primitiva, figura))
            piezas.push_back(p);
        const glm::dvec2 arriba(panel.x + 0.5 * panel.ancho, panel.y + 0.99 * panel.alto);
        letreros.push_back({NOMBRES[primitiva][sola ? 0 : 1], arriba, OSCURO, Lado::DEBAJO});
        for (int i = 0; i < N; ++i) {
            const oraculo::Vec2 v = VERTICES[i].en(figura);
            // en la rejilla el 3 no cabe entre su vértice y el nombre
            const Lado lado = i == 3 && !sola ? Lado::DEBAJO : LADOS[i];
            letreros.push_back({std::to_string(i), {v.x, v.y}, OSCURO, lado});
        }
    }
    void comprueba(const std::string &guion) const {
        const Vista vista = vistaDe("primitivas", guion, 960, 720);
        compruebaPlana(guion, vista.escena, piezas, exacto(GRIS));
        compruebaRotulos(vista.encima, letreros);
    }
};

void compruebaSola(int primitiva) {
    Esperado esperado;
    esperado.anade(primitiva, {0, 0, 960, 720}, true);
    esperado.comprueba("tecla " + std::to_string(primitiva + 1));
}

} // namespace

TEST(Primitivas, PuntosYSegmentos) {
    for (int primitiva = PUNTOS; primitiva < TRIANGULOS; ++primitiva)
        compruebaSola(primitiva);
}

TEST(Primitivas, Triangulos) {
    for (int primitiva = TRIANGULOS; primitiva <= ABANICO; ++primitiva)
        compruebaSola(primitiva);
}

// El octavo panel dice qué color toma cada una. Se vuelve a la rejilla desde cualquier sitio.
TEST(Primitivas, LaRejilla) {
    Esperado esperado;
    for (int primitiva = PUNTOS; primitiva <= ABANICO; ++primitiva)
        esperado.anade(primitiva, hueco(primitiva % 4, 4, primitiva / 4, 2, 960, 720), false);
    const Hueco ultimo = hueco(3, 4, 1, 2, 960, 720);
    esperado.piezas.push_back(rectangulo(ultimo, exacto(FONDO_CLARO)));
    esperado.letreros.push_back({"El color\nes el del\núltimo\nvértice",
                                 {ultimo.x + 0.5 * ultimo.ancho, ultimo.y + 0.5 * ultimo.alto},
                                 OSCURO});
    esperado.comprueba("");
    esperado.comprueba("tecla 6; tamano 1 1; tamano 960 720; tecla 0; tecla 8; tecla 9");
}

// Seis triángulos alrededor del centro; la rueda conserva su forma. El número de cada vértice, por fuera; el 0, debajo.
TEST(ModeloPoligonal, ColorBaricentrico) {
    const std::vector<VerticePlano> rueda = {{0, 0, {1, 1, 1}},         {0, 0.78, {1, 0, 0}},
                                             {-0.675, 0.39, {1, 1, 0}}, {-0.675, -0.39, {0, 1, 0}},
                                             {0, -0.78, {0, 1, 1}},     {0.675, -0.39, {0, 0, 1}},
                                             {0.675, 0.39, {1, 0, 1}},  {0, 0.78, {1, 0, 0}}};
    const Lado lados[] = {Lado::DEBAJO, Lado::ENCIMA,  Lado::IZQUIERDA, Lado::IZQUIERDA,
                          Lado::DEBAJO, Lado::DERECHA, Lado::DERECHA};
    for (const glm::ivec2 t : {glm::ivec2(240, 180), {180, 240}, {960, 720}}) {
        const Vista vista = vistaDe("modelo_poligonal", "", t.x, t.y);
        const Hueco h = cuadrado(t.x, t.y);
        compruebaPlana("la rueda", vista.escena, triangulos(GL_TRIANGLE_FAN, rueda, h), exacto(FONDO_OSCURO));
        std::vector<Letrero> numeros;
        for (int i = 0; i < 7; ++i) {
            const oraculo::Vec2 v = rueda[i].en(h);
            numeros.push_back({std::to_string(i), {v.x, v.y}, BLANCO, lados[i]});
        }
        compruebaRotulos(vista.encima, numeros);
    }
}

// El velero, con sus vértices escritos otra vez. Llena cualquier ventana: el color de borrado, negro, no asoma.
TEST(FiguraColor, DegradadosEnCadaPixel) {
    const oraculo::Vec3 noche{0.10, 0.12, 0.36}, tarde{0.42, 0.24, 0.55}, ocaso{0.93, 0.42, 0.38},
        dorado{1.00, 0.78, 0.38}, tierra{0.45, 0.24, 0.45}, cumbre{0.62, 0.36, 0.52},
        orilla{0.93, 0.55, 0.40}, agua{0.36, 0.33, 0.60}, hondo{0.05, 0.13, 0.33}, fuera{0.96, 0.60, 0.36},
        dentro{1.00, 0.90, 0.60};
    const double horizonte = -0.20, x = -0.28, radio = 0.30; // del sol
    std::vector<VerticePlano> sol = {{x, horizonte, {1.00, 0.98, 0.75}}};
    for (int i = 0; i <= 24; ++i) {
        const double a = oraculo::PI * i / 24;
        sol.push_back({x + radio * std::cos(a), horizonte + radio * std::sin(a), {1.00, 0.62, 0.16}});
    }
    const struct {
        GLenum primitiva;
        std::vector<VerticePlano> vertices;
    } partes[] = {{GL_TRIANGLE_STRIP, // cielo
                   {{-1, 1, noche},
                    {1, 1, noche},
                    {-1, 0.45, tarde},
                    {1, 0.45, tarde},
                    {-1, 0.10, ocaso},
                    {1, 0.10, ocaso},
                    {-1, horizonte, dorado},
                    {1, horizonte, dorado}}},
                  {GL_TRIANGLE_FAN, sol},
                  {GL_TRIANGLE_STRIP, // costa
                   {{0.25, horizonte, tierra},
                    {0.50, 0.02, cumbre},
                    {0.68, horizonte, tierra},
                    {0.80, 0.10, cumbre},
                    {1.00, horizonte, tierra},
                    {1.00, -0.02, cumbre}}},
                  {GL_TRIANGLE_STRIP, // mar
                   {{-1, horizonte, orilla},
                    {1, horizonte, orilla},
                    {-1, -0.45, agua},
                    {1, -0.45, agua},
                    {-1, -1, hondo},
                    {1, -1, hondo}}},
                  {GL_TRIANGLES, // reflejo
                   {{x - radio, horizonte, fuera},
                    {x + radio, horizonte, fuera},
                    {x, -0.90, {0.24, 0.22, 0.46}},
                    {x - 0.14, horizonte, dentro},
                    {x + 0.14, horizonte, dentro},
                    {x, -0.62, {0.62, 0.42, 0.52}}}},
                  {GL_TRIANGLE_STRIP, // mástil
                   {{0.303, -0.42, {0.30, 0.14, 0.16}},
                    {0.327, -0.42, {0.20, 0.10, 0.14}},
                    {0.303, 0.58, {0.52, 0.26, 0.22}},
                    {0.327, 0.58, {0.36, 0.18, 0.20}}}},
                  {GL_TRIANGLES, // velas
                   {{0.30, -0.36, {0.98, 0.84, 0.70}},
                    {0.30, 0.52, {1.00, 0.97, 0.92}},
                    {-0.12, -0.36, {0.95, 0.55, 0.10}},
                    {0.35, -0.36, {0.85, 0.20, 0.18}},
                    {0.62, -0.34, {0.72, 0.10, 0.22}},
                    {0.33, 0.40, {1.00, 0.62, 0.30}}}},
                  {GL_TRIANGLE_FAN, // casco
                   {{0.27, -0.40, {0.55, 0.27, 0.20}},
                    {-0.20, -0.40, {0.70, 0.34, 0.20}},
                    {-0.06, -0.56, {0.24, 0.11, 0.16}},
                    {0.56, -0.56, {0.18, 0.08, 0.14}},
                    {0.76, -0.38, {0.42, 0.18, 0.18}}}}};
    for (const glm::ivec2 t : {glm::ivec2(240, 180), {960, 720}, {300, 60}, {60, 300}, {1, 1}}) {
        std::vector<Pieza> piezas;
        for (const auto &parte : partes)
            for (const Pieza &p : triangulos(parte.primitiva, parte.vertices, cuadrado(t.x, t.y, true)))
                piezas.push_back(p);
        compruebaPlana(enGuion(t), imagenDe("figura_color", "", t.x, t.y), piezas, {0, 0, 0});
    }
}
