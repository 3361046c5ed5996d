// Comprobaciones independientes de primitivas, modelo_poligonal y figura_color: qué color debe haber en cada píxel,
// calculado en doble precisión con las coordenadas de los vértices.
#include "colores.h"
#include "guiones.h"
#include "plana.h"
#include "shader.h"
#include "tabla.h"
#include "ventana.h"

// Los vértices de figura_color son los del programa.
namespace figura_color {
#define main mainDelPrograma
#include "ch02_modelado/figura_color.cpp"
#undef main
} // namespace figura_color

namespace {

using namespace oraculo;

enum { PUNTOS, SEGMENTOS, TIRA_SEGMENTOS, SECUENCIA_CERRADA, TRIANGULOS, TIRA, ABANICO };
const std::vector<VerticePlano> VERTICES = {{0, -0.68, exacto(NARANJA)},      {0.81, -0.42, exacto(ROJO)},
                                            {0.34, -0.08, exacto(AZUL)},      {0, 0.66, exacto(VERDE)},
                                            {-0.34, -0.08, exacto(AMARILLO)}, {-0.81, -0.42, exacto(MORADO)}};
const int N = 6;

/// Lo que barre un cuadrado de ese medio lado que va de un punto a otro.
Poligono barrido(const Vec2 &a, const Vec2 &b, double medio) {
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
            p.push_back({barrido(v.en(h), v.en(h), h.ancho / 40.0), {v.color}, 0.75});
    } else { // un segmento de un píxel se aparta medio en cada extremo y medio a lo ancho
        const int n = primitiva == SECUENCIA_CERRADA ? N : N - 1, paso = primitiva == SEGMENTOS ? 2 : 1;
        for (int i = 0; i < n; i += paso) {
            const VerticePlano &a = VERTICES[i], &b = VERTICES[(i + 1) % N];
            p.push_back({barrido(a.en(h), b.en(h), h.ancho / 72 + 0.5), {b.color}, 1, true});
        }
    }
    return p;
}

} // namespace

// Sola, con el nombre encima, o en una rejilla a la que se vuelve desde cualquier sitio; en su octavo hueco no hay
// nada.
TEST(Primitivas, CadaUna) {
    const struct {
        std::string guion;
        std::vector<int> primitivas;
    } casos[] = {{"tecla 1", {PUNTOS}},
                 {"tecla 2", {SEGMENTOS}},
                 {"tecla 3", {TIRA_SEGMENTOS}},
                 {"tecla 4", {SECUENCIA_CERRADA}},
                 {"tecla 5", {TRIANGULOS}},
                 {"tecla 6", {TIRA}},
                 {"tecla 7", {ABANICO}},
                 {"tamano 1 1; tamano 960 720; tecla 0; tecla 8; tecla 9",
                  {PUNTOS, SEGMENTOS, TIRA_SEGMENTOS, SECUENCIA_CERRADA, TRIANGULOS, TIRA, ABANICO}}};
    paraCada("primitivas", casos, 960, 720, [](const auto &c, const Vista &v) {
        const bool sola = c.primitivas.size() == 1;
        std::vector<Pieza> todas = {rectangulo(hueco(3, 4, 1, 2, 960, 720), exacto(FONDO_CLARO))};
        for (const int primitiva : c.primitivas) {
            const Hueco panel =
                sola ? Hueco{0, 0, 960, 720} : hueco(primitiva % 4, 4, primitiva / 4, 2, 960, 720);
            const int alto = sola ? panel.alto * 9 / 10 : panel.alto * 2 / 3,
                      lado = std::min(panel.ancho, alto);
            todas.push_back(rectangulo(panel, exacto(FONDO_CLARO)));
            for (const Pieza &p : piezas(primitiva, {panel.x + (panel.ancho - lado) / 2,
                                                     panel.y + (alto - lado) / 2, lado, lado}))
                todas.push_back(p);
        }
        compruebaPlana(c.guion, v.escena, todas, exacto(GRIS));
    });
}

// Seis triángulos alrededor del centro; la rueda conserva su forma.
TEST(ModeloPoligonal, ColorBaricentrico) {
    const std::vector<VerticePlano> rueda = {{0, 0, {1, 1, 1}},         {0, 0.78, {1, 0, 0}},
                                             {-0.675, 0.39, {1, 1, 0}}, {-0.675, -0.39, {0, 1, 0}},
                                             {0, -0.78, {0, 1, 1}},     {0.675, -0.39, {0, 0, 1}},
                                             {0.675, 0.39, {1, 0, 1}},  {0, 0.78, {1, 0, 0}}};
    for (const glm::ivec2 t : {glm::ivec2(240, 180), {180, 240}, {960, 720}})
        compruebaPlana(enGuion(t), vistaDe("modelo_poligonal", "", t.x, t.y).escena,
                       triangulos(GL_TRIANGLE_FAN, rueda, cuadrado(t.x, t.y)), exacto(FONDO_OSCURO));
}

// El velero: los trozos del programa, cada uno en su sitio y con su primitiva, y el sol, por la ecuación de la
// circunferencia. Llena cualquier ventana: el color de borrado, negro, no asoma.
TEST(FiguraColor, DegradadosEnCadaPixel) {
    for (const glm::ivec2 t : {glm::ivec2(240, 180), {960, 720}, {300, 60}, {60, 300}, {1, 1}}) {
        std::vector<Pieza> piezas;
        for (const figura_color::Trozo &trozo : figura_color::trozos()) {
            std::vector<VerticePlano> vertices;
            for (const auto &[p, c] : trozo.vertices)
                vertices.push_back({p[0], p[1], {c[0], c[1], c[2]}});
            if (vertices.size() == 26) // el centro del sol y medio círculo
                for (int i = 0; i <= 24; ++i) {
                    const double a = PI * i / 24;
                    vertices[i + 1].x = -0.28 + 0.30 * std::cos(a);
                    vertices[i + 1].y = -0.20 + 0.30 * std::sin(a);
                }
            for (const Pieza &p : triangulos(trozo.primitiva, vertices, cuadrado(t.x, t.y, true)))
                piezas.push_back(p);
        }
        compruebaPlana(enGuion(t), imagenDe("figura_color", "", t.x, t.y), piezas, {0, 0, 0});
    }
}
