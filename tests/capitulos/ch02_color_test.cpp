// Comprobaciones independientes de primitivas, modelo_poligonal y figura_color: qué color debe haber en cada píxel, calculado en
// doble precisión con las coordenadas de los vértices.
#include "colores.h"
#include "guiones.h"
#include "plana.h"
#include <GL/glew.h>
#include <GL/freeglut.h>
#include <cstdlib>
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

/// Cada primitiva, en ese cuadrado: las piezas que salen de los seis vértices, del color del último de cada una.
std::vector<Pieza> piezas(int primitiva, const Hueco &h) {
    std::vector<Pieza> p;
    if (primitiva >= TRIANGULOS) {
        const GLenum deOpenGL[] = {GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN};
        p = triangulos(deOpenGL[primitiva - TRIANGULOS], VERTICES, h);
        for (Pieza &pieza : p)
            pieza.colores = {pieza.colores.back()};
    } else if (primitiva == PUNTOS) {
        for (const VerticePlano &v : VERTICES)
            p.push_back({barrido(v.en(h), v.en(h), h.ancho / 28.0), {v.color}});
    } else {
        const int n = primitiva == SECUENCIA_CERRADA ? N : N - 1, paso = primitiva == SEGMENTOS ? 2 : 1;
        for (int i = 0; i < n; i += paso) {
            const VerticePlano &a = VERTICES[i], &b = VERTICES[(i + 1) % N];
            p.push_back({barrido(a.en(h), b.en(h), h.ancho / 72 + 0.5), {b.color}});
        }
    }
    return p;
}

/// Sola, y en su panel de la rejilla: cada píxel, el nombre y el número de cada vértice.
void comprueba(int primitiva) {
    const std::vector<Vista> vistas =
        vistasDe("primitivas", {"", "tecla " + std::to_string(primitiva + 1)}, 960, 720);
    for (const bool sola : {false, true}) {
        const Vista &vista = vistas[sola];
        const Hueco panel =
            sola ? Hueco{0, 0, 960, 720} : hueco(primitiva % 4, 4, primitiva / 4, 2, 960, 720);
        const int alto = sola ? 648 : panel.alto * 2 / 3, cabe = std::min(panel.ancho, alto);
        const Hueco figura = {(panel.ancho - cabe) / 2, (alto - cabe) / 2, cabe, cabe};
        // OpenGL deja redondear el lado de un punto a un entero y su centro a medio píxel: ¼ + ½. Un segmento de un píxel se
        // aparta medio en cada extremo y medio a lo ancho, y en los vértices que comparten dos vale el color de los dos
        const double holgura = primitiva >= TRIANGULOS ? 1.0 / 256 : primitiva == PUNTOS ? 0.75 : 1;
        const std::string nombre = NOMBRES[primitiva][sola ? 0 : 1];
        compruebaPlana(nombre, recorta(vista.escena, panel), piezas(primitiva, figura), exacto(FONDO_CLARO),
                       0.501, holgura, primitiva == PUNTOS || primitiva >= TRIANGULOS);
        const Encima encima = vista.encima.enPanel(panel.x, panel.y),
                     numeros = vista.encima.enPanel(panel.x + figura.x, panel.y + figura.y);
        compruebaRotulo(encima, nombre, {panel.x + 0.5 * panel.ancho, panel.y + 0.99 * panel.alto}, OSCURO,
                        Lado::DEBAJO);
        for (int i = 0; i < N; ++i) {
            const oraculo::Vec2 v = VERTICES[i].en(figura);
            // en la rejilla el 3 no cabe entre su vértice y el nombre
            const Lado lado = i == 3 && !sola ? Lado::DEBAJO : LADOS[i];
            compruebaRotulo(numeros, std::to_string(i), {panel.x + v.x, panel.y + v.y}, OSCURO, lado);
        }
    }
}

} // namespace

TEST(Primitivas, PuntosYSegmentos) {
    for (int primitiva = PUNTOS; primitiva < TRIANGULOS; ++primitiva)
        comprueba(primitiva);
}

TEST(Primitivas, Triangulos) {
    for (int primitiva = TRIANGULOS; primitiva <= ABANICO; ++primitiva)
        comprueba(primitiva);
}

// El octavo panel dice qué color toma cada una; entre ellos hay una raya. Y se vuelve a la rejilla desde cualquier sitio.
TEST(Primitivas, LaRejilla) {
    const std::vector<Vista> vistas = vistasDe(
        "primitivas", {"", "tecla 6; tamano 1 1; tamano 960 720; tecla 0; tecla 8; tecla 9"}, 960, 720);
    const Hueco ultimo = hueco(3, 4, 1, 2, 960, 720);
    const Imagen &escena = vistas[0].escena;
    compruebaPlana("el último panel", recorta(escena, ultimo), {}, exacto(FONDO_CLARO));
    compruebaPlana("la raya a su izquierda", recorta(escena, {ultimo.x - 4, 0, 4, 720}), {}, exacto(GRIS));
    compruebaPlana("la raya de encima", recorta(escena, {0, ultimo.alto, 960, 4}), {}, exacto(GRIS));
    compruebaRotulo(vistas[0].encima, "El color\nes el del\núltimo\nvértice",
                    {ultimo.x + 0.5 * ultimo.ancho, 0.5 * ultimo.alto}, OSCURO, Lado::CENTRO);
    EXPECT_EQ(vistas[0].encima.size(), 7 * (N + 1) + 1u);
    EXPECT_EQ(vistas[1].encima.size(), 7 * (N + 1) + 1u);
    EXPECT_EQ(escena.rgb, vistas[1].escena.rgb);
}

// El listado 2.4 dibuja sin VAO: un contexto core lo rechaza. Con uno, aunque esté vacío, el mismo dibujo es
// válido. (Cada caso en un proceso, que termina con 3 si hay un error de OpenGL.)
TEST(ModeloPoligonal, SinVaoNoSeDibuja) {
    const auto dibuja = [](bool conVao) {
        char nombre[] = "prueba", *argv[] = {nombre, nullptr};
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

// Seis triángulos alrededor del centro; la rueda conserva su forma. El número de cada vértice, por fuera de ella; el 0, bajo el centro.
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
        EXPECT_EQ(vista.encima.size(), 7u);
        for (int i = 0; i < 7; ++i) {
            const oraculo::Vec2 v = rueda[i].en(h);
            compruebaRotulo(vista.encima, std::to_string(i), {v.x, v.y}, BLANCO, lados[i]);
        }
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
