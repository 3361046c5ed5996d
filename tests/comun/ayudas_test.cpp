// Las ayudas de dibujo de common/: trazo, rotulo, recuadro y el encuadre de perspectivaVentana y paralelaVentana. Se dibuja en una
// ventana sin pantalla y se miran los píxeles.
#include "aspecto.h"
#include "buferes.h"
#include "colores.h"
#include "imagen.h"
#include "letra.h"
#include "recuadro.h"
#include "rotulo.h"
#include "trazo.h"
#include "ventana.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <utility>
// clang-format off
#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H
// clang-format on

namespace {

const glm::mat4 UNO(1);

std::string enUtf8(char32_t c) {
    if (c < 0x80)
        return {char(c)};
    if (c < 0x800)
        return {char(0xC0 | c >> 6), char(0x80 | (c & 0x3F))};
    return {char(0xE0 | c >> 12), char(0x80 | (c >> 6 & 0x3F)), char(0x80 | (c & 0x3F))};
}

glm::ivec3 enNiveles(const glm::vec3 &color) {
    return 255.0f * color + 0.5f;
}

class Ayudas : public testing::Test {
protected:
    static void SetUpTestSuite() {
        static char nombre[] = "ayudas", opcion[] = "-geometry", talla[] = "480x360";
        static char *argv[] = {nombre, opcion, talla, nullptr};
        int argc = 3;
        abreVentana(argc, argv, "Ayudas", GLUT_DOUBLE | GLUT_DEPTH);
    }

    /// La ventana, de ese tamaño, tras dibujar sobre fondo blanco.
    static Imagen pinta(const glm::ivec2 &talla, const std::function<void()> &dibujo) {
        glutReshapeWindow(talla.x, talla.y);
        abreRecuadro(ventanaEntera(), BLANCO);
        dibujo();
        EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
        return leeVentana();
    }
    static Imagen pinta(const std::function<void()> &dibujo) {
        return pinta({480, 360}, dibujo);
    }

    static glm::ivec3 color(const Imagen &i, int x, int y) {
        const std::size_t k = 3 * std::size_t(y * i.ancho + x);
        return {i.rgb.at(k), i.rgb.at(k + 1), i.rgb.at(k + 2)};
    }
    static bool esBlanco(const Imagen &i, int x, int y) {
        return color(i, x, y) == glm::ivec3(255);
    }

    /// Caja de los píxeles que no son blancos; vacía (minimo > maximo) si todos lo son.
    struct Caja {
        glm::ivec2 minimo{100000}, maximo{-1};
        int pixeles = 0;
    };
    static Caja caja(const Imagen &imagen) {
        Caja c;
        for (int y = 0; y < imagen.alto; ++y)
            for (int x = 0; x < imagen.ancho; ++x)
                if (!esBlanco(imagen, x, y)) {
                    c.minimo = glm::min(c.minimo, {x, y});
                    c.maximo = glm::max(c.maximo, {x, y});
                    ++c.pixeles;
                }
        return c;
    }
};

// --- trazo ------------------------------------------------------------------------------------------------------

// Con un extremo detrás de la cámara se ve lo que queda delante, y hacia donde va: (0, 0, −5) a (3, 0, 5) deja la
// pantalla por la derecha.
TEST_F(Ayudas, UnExtremoDetrasDeLaCamara) {
    const glm::mat4 proyeccion = perspectivaVentana(1, 0.1f, 100);
    for (const bool alReves : {false, true}) {
        std::vector<glm::vec3> p = {{0, 0, -5}, {3, 0, 5}};
        if (alReves)
            std::swap(p[0], p[1]);
        for (const auto &traza :
             std::vector<std::function<void()>>{[&] { trazaSegmentos(p, proyeccion, ROJO, 12); },
                                                [&] { trazaPolilinea(p, proyeccion, ROJO, 12); },
                                                [&] { trazaFlecha(p[0], p[1], proyeccion, ROJO, 12); }}) {
            const Caja c = caja(pinta(traza));
            EXPECT_GE(c.minimo.x, 225); // la punta de la flecha ensancha por la izquierda, cuando está allí
            EXPECT_EQ(c.maximo.x, 479);
            EXPECT_GE(c.minimo.y, 170);
            EXPECT_LE(c.maximo.y, 190);
        }
    }
    EXPECT_EQ(caja(pinta([&] {
                  trazaSegmentos({{0, 0, 1}, {3, 0, 5}}, proyeccion, ROJO);
                  trazaFlecha({0, 0, 1}, {3, 0, 5}, proyeccion, ROJO);
                  trazaPuntos({{0, 0, 5}, {0, 0, 0}}, proyeccion, ROJO);
              })).pixeles,
              0);
}

TEST_F(Ayudas, LosTramosEmpalmanSinMella) {
    // una V: la esquina de fuera, medio grosor bajo el vértice, está pintada
    const Imagen v = pinta([] {
        trazaPolilinea({{-0.4f, 0.4f, 0}, {0, -0.4f, 0}, {0.4f, 0.4f, 0}}, UNO, ROJO, 60);
    });
    EXPECT_FALSE(esBlanco(v, 240, 180 - 72 - 3));
    const std::vector<glm::vec3> cuadrado = {
        {-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0.5f, 0.5f, 0}, {-0.5f, 0.5f, 0}};
    const auto lados = [&](bool cerrada) {
        return caja(pinta([&] { trazaPolilinea(cuadrado, UNO, ROJO, 30, cerrada); })).pixeles;
    };
    EXPECT_NEAR(lados(false), (2 * 240 + 180) * 10, 200);
    EXPECT_NEAR(lados(true), (2 * 240 + 2 * 180) * 10, 200);
}

// Nada de lo que un programa haya puesto cambia porque se pinte encima de su escena.
TEST_F(Ayudas, DejanElEstadoComoEstaba) {
    const auto estado = [] {
        std::vector<GLint> valores;
        for (const GLenum que :
             {GL_CURRENT_PROGRAM, GL_VERTEX_ARRAY_BINDING, GL_ARRAY_BUFFER_BINDING, GL_ACTIVE_TEXTURE,
              GL_TEXTURE_BINDING_2D, GL_BLEND, GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA,
              GL_BLEND_DST_ALPHA, GL_DEPTH_TEST, GL_DEPTH_WRITEMASK, GL_CULL_FACE, GL_SCISSOR_TEST})
            glGetIntegerv(que, &valores.emplace_back());
        return valores;
    };
    const auto pintaAlgo = [] {
        trazaPuntos({{0, 0, 0}}, UNO, ROJO);
        rotula("abc", {0.5f, 0.5f}, ROJO);
    };
    const Buferes cubo = creaBuferes(::cubo());
    const GLenum INTERRUPTORES[] = {GL_BLEND, GL_DEPTH_TEST, GL_CULL_FACE};
    for (const bool puesto : {true, false}) {
        glutReshapeWindow(480, 360);
        glBindVertexArray(puesto ? cubo.vao : 0);
        glActiveTexture(puesto ? GL_TEXTURE2 : GL_TEXTURE0);
        glBlendFuncSeparate(GL_ONE, puesto ? GL_ONE : GL_ZERO, GL_DST_ALPHA, GL_SRC_COLOR);
        for (const GLenum que : INTERRUPTORES)
            (puesto ? glEnable : glDisable)(que);
        const std::vector<GLint> antes = estado();
        pintaAlgo();
        EXPECT_EQ(estado(), antes);
    }
}

// --- rotulo -----------------------------------------------------------------------------------------------------

// Cada signo, a tres tamaños, frente a lo que cubre su contorno en cada píxel, según FreeType. El atlas es de 32 por cuadratín y
// redondea las esquinas: se admite una diferencia cuadrática media de un 8 % de tinta en los píxeles de su caja (hay hasta un 7.5).
TEST_F(Ayudas, CadaSignoEsElDeLaLetra) {
    FT_Library freetype;
    FT_Face fuente;
    ASSERT_EQ(FT_Init_FreeType(&freetype), 0);
    ASSERT_EQ(FT_New_Face(freetype, LAB_LETRA, 0, &fuente), 0);
    for (const int alto : {180, 720, 1080})
        for (const char32_t signo : SIGNOS) {
            const int mayuscula = std::max(int(std::lround(0.04 * alto)), 7),
                      paso = int(std::lround(float(mayuscula) * AVANCE / MAYUSCULA));
            const glm::ivec2 origen(alto * 2 / 3 - paso / 2, alto / 2 - mayuscula / 2);
            const double escala = mayuscula / double(MAYUSCULA),
                         pluma = origen.x + (paso - AVANCE * escala) / 2;
            const Imagen imagen = pinta({alto * 4 / 3, alto}, [&] {
                rotula(enUtf8(signo), {0.5f, 0.5f}, {0, 0, 0});
            });

            ASSERT_EQ(FT_Set_Char_Size(fuente, 0, FT_F26Dot6(std::lround(64 * CUADRATIN * escala)), 72, 72),
                      0);
            ASSERT_EQ(FT_Load_Char(fuente, signo, FT_LOAD_NO_HINTING), 0);
            FT_Outline_Translate(&fuente->glyph->outline,
                                 FT_Pos(std::lround(64 * (pluma - std::floor(pluma)))), 0);
            ASSERT_EQ(FT_Render_Glyph(fuente->glyph, FT_RENDER_MODE_NORMAL), 0);
            const FT_Bitmap &exacta = fuente->glyph->bitmap;
            const int x0 = int(std::floor(pluma)) + fuente->glyph->bitmap_left,
                      y0 = origen.y + fuente->glyph->bitmap_top - 1; // la fila de arriba
            double suma = 0;
            const int filas = int(exacta.rows), columnas = int(exacta.width);
            for (int y = -1; y <= filas; ++y)
                for (int x = -1; x <= columnas; ++x) {
                    const bool dentro = x >= 0 && y >= 0 && x < columnas && y < filas;
                    const double tinta = dentro ? exacta.buffer[y * exacta.pitch + x] / 255.0 : 0;
                    suma += std::pow(tinta - (1 - color(imagen, x0 + x, y0 - y).g / 255.0), 2);
                }
            EXPECT_LT(std::sqrt(suma / ((filas + 2) * (columnas + 2))), 0.08)
                << enUtf8(signo) << " con " << alto << " líneas";
        }
    FT_Done_FreeType(freetype);
}

// Un signo que la letra no tiene es un cuadrado, y no otro signo.
TEST_F(Ayudas, UnSignoQueNoHayEsUnCuadrado) {
    const auto imagen = [](const char *texto) {
        return pinta([&] { rotula(texto, {0.5f, 0.5f}, ROJO); }).rgb;
    };
    EXPECT_EQ(imagen("€"), imagen("□"));
    EXPECT_NE(imagen("€"), imagen("a"));
}

// Sobre un fondo de su color, la letra se ve por su halo, que mide un píxel o una décima de su alto.
TEST_F(Ayudas, ElHaloSeparaLaLetraDelFondo) {
    for (const auto &[tinta, halo] : {std::pair(OSCURO, BLANCO), {BLANCO, OSCURO}}) {
        const glm::vec3 fondo = tinta;
        for (const int alto : {180, 1080}) {
            const Imagen imagen = pinta({alto * 4 / 3, alto}, [&] {
                abreRecuadro(ventanaEntera(), fondo);
                rotula("□", {0.5f, 0.5f}, tinta);
            });
            int distintos =
                0; // en la fila del medio: el halo de los dos lados del cuadrado, por fuera y por dentro
            for (int x = 0; x < imagen.ancho; ++x)
                distintos += color(imagen, x, alto / 2) != enNiveles(fondo);
            EXPECT_GE(distintos, 4);
            EXPECT_LE(distintos, 4 * std::max(0.1 * 0.04 * alto + 1, 2.0));
            glm::ivec3 lejos(0);
            for (std::size_t k = 0; k < imagen.rgb.size(); ++k)
                lejos[int(k % 3)] =
                    std::max(lejos[int(k % 3)], std::abs(imagen.rgb[k] - int(255 * fondo[int(k % 3)])));
            EXPECT_GT(lejos.g, 0.6 * 255 * std::fabs(halo.g - fondo.g)) << "el halo es del otro color";
        }
    }
}

// Se lea quien se lea y sobre lo que sea: la letra, que es lo que más se pinta, y el halo, lo segundo, contrastan 4.5 (WCAG 2). El
// color pedido se cambia solo si no llega.
TEST_F(Ayudas, DeCualquierColorSeLee) {
    const auto luminancia = [](const glm::ivec3 &c) {
        const auto lineal = [](double v) {
            return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
        };
        return 0.05 + 0.2126 * lineal(c.r / 255.0) + 0.7152 * lineal(c.g / 255.0) +
               0.0722 * lineal(c.b / 255.0);
    };
    const auto contraste = [&](const glm::ivec3 &a, const glm::ivec3 &b) {
        return std::max(luminancia(a), luminancia(b)) / std::min(luminancia(a), luminancia(b));
    };
    const glm::vec3 fondo(0.2f, 0.8f, 0.6f);
    for (int i = 0; i < 125; ++i) {
        const glm::vec3 tinta = 0.25f * glm::vec3(i % 5, i / 5 % 5, i / 25);
        const Imagen imagen = pinta({720, 540}, [&] {
            abreRecuadro(ventanaEntera(), fondo);
            rotula("□", {0.5f, 0.5f}, tinta, Lado::CENTRO, 0.3f);
        });
        std::map<std::array<int, 3>, int> cuantos;
        for (int y = 0; y < imagen.alto; ++y)
            for (int x = 0; x < imagen.ancho; ++x)
                if (const glm::ivec3 c = color(imagen, x, y); c != enNiveles(fondo))
                    ++cuantos[{c.r, c.g, c.b}];
        std::vector<std::pair<int, glm::ivec3>> ordenados;
        for (const auto &[c, n] : cuantos)
            ordenados.push_back({-n, {c[0], c[1], c[2]}});
        std::sort(ordenados.begin(), ordenados.end(),
                  [](const auto &a, const auto &b) { return a.first < b.first; });
        ASSERT_GE(ordenados.size(), 2u);
        const glm::ivec3 letra = ordenados[0].second, halo = ordenados[1].second;
        EXPECT_GE(contraste(letra, halo), 4.45) << i;
        EXPECT_TRUE(letra == enNiveles(tinta) || contraste(enNiveles(tinta), halo) < 4.55) << i;
    }
}

TEST_F(Ayudas, UnRotuloNoTapaSuPuntoNiSeSale) {
    for (const glm::ivec2 talla : {glm::ivec2(240, 180), {480, 360}, {200, 450}, {640, 360}})
        for (const Lado lado : {Lado::ENCIMA, Lado::DEBAJO, Lado::IZQUIERDA, Lado::DERECHA})
            for (float x = -0.9f; x < 1; x += 0.3f)
                for (float y = -0.9f; y < 1; y += 0.3f) {
                    const Imagen imagen = pinta(talla, [&] {
                        rotulaPunto("P(1,2)", {x, y, 0}, UNO, ROJO, lado);
                    });
                    const Caja c = caja(imagen);
                    EXPECT_GT(c.pixeles, 50);
                    // a una letra del borde, como poco; los palotes de la p y la coma bajan de la línea
                    const int letra =
                        std::max(int(std::lround(0.04 * std::min(talla.y, talla.x * 3 / 4))), 7);
                    const glm::ivec2 margen(letra * 8 / 10 - 1, letra / 2);
                    EXPECT_TRUE(glm::all(glm::greaterThanEqual(c.minimo, margen)));
                    EXPECT_TRUE(glm::all(glm::lessThan(c.maximo, talla - margen)));
                    const int px = int((x + 1) / 2 * float(talla.x)), py = int((y + 1) / 2 * float(talla.y));
                    for (int dx = -1; dx <= 1; ++dx)
                        for (int dy = -1; dy <= 1; ++dy)
                            EXPECT_TRUE(esBlanco(imagen, px + dx, py + dy))
                                << talla.x << "×" << talla.y << " lado " << int(lado) << " en " << x << " "
                                << y;
                }
}

TEST_F(Ayudas, FueraDelVolumenNoHayRotulo) {
    const glm::mat4 proyeccion = perspectivaVentana(1, 0.1f, 100);
    for (const glm::vec3 &p : {glm::vec3(0, 0, 5), {0, 0, 0}, {50, 0, -5}, {0, -50, -5}, {0, 0, -0.05f}})
        EXPECT_EQ(caja(pinta([&] { rotulaPunto("abc", p, proyeccion, ROJO); })).pixeles, 0)
            << p.x << p.y << p.z;
    EXPECT_GT(caja(pinta([&] { rotulaPunto("abc", {0, 0, -5}, proyeccion, ROJO); })).pixeles, 0);
}

TEST_F(Ayudas, UnRotuloLargoEncogeYLaLineaNuevaBaja) {
    const auto deMes = [](int cuantas) {
        return caja(pinta([&] { rotula(std::string(std::size_t(cuantas), 'M'), {0.5f, 0.5f}, ROJO); }));
    };
    const Caja corto = deMes(10), largo = deMes(60);
    // un borde suavizado asoma hasta un píxel por cada lado
    EXPECT_NEAR(corto.maximo.y - corto.minimo.y + 1, 14 + 1, 1);
    EXPECT_LT(largo.maximo.y - largo.minimo.y + 1, 12); // 60 letras en 480 píxeles: de 7 a lo ancho
    EXPECT_GE(largo.minimo.x, 6);
    EXPECT_LE(largo.maximo.x, 479 - 6);
    const Caja dos = caja(pinta([] { rotula("F\nF", {0.5f, 0.5f}, ROJO); }));
    EXPECT_NEAR(dos.maximo.y - dos.minimo.y + 1, 2.5 * 14 + 1,
                1); // de una línea a otra, una mayúscula y media
}

// --- recuadro ---------------------------------------------------------------------------------------------------

// Por pequeña que sea la ventana. Dónde cae cada uno, en los programas con paneles (panel.h).
TEST_F(Ayudas, LosPanelesNoSeSolapanNiSeSalen) {
    for (int ancho = 1; ancho < 60; ++ancho)
        for (int alto : {1, 2, 7, 50}) {
            glutReshapeWindow(ancho, alto);
            for (const auto &[columnas, filas] : {std::pair(1, 1), {2, 2}, {3, 2}, {1, 4}}) {
                std::vector<int> veces(std::size_t(ancho * alto));
                for (const Recuadro &r : rejilla(columnas, filas)) {
                    ASSERT_GE(std::min({r.x, r.y, r.ancho, r.alto}), 0);
                    for (int y = r.y; y < r.y + r.alto; ++y)
                        for (int x = r.x; x < r.x + r.ancho; ++x)
                            ++veces.at(std::size_t(y * ancho + x));
                }
                EXPECT_LE(*std::max_element(veces.begin(), veces.end()), 1);
            }
        }
}

TEST_F(Ayudas, RepartePorLaFormaDeLaVentana) {
    const auto filas = [](int ancho, int alto, int n, float aspectoEscena) {
        glutReshapeWindow(ancho, alto);
        std::set<int> ys;
        for (const Recuadro &r : reparte(n, aspectoEscena))
            ys.insert(r.y);
        return ys.size();
    };
    EXPECT_EQ(filas(640, 360, 2, 1), 1u);
    EXPECT_EQ(filas(400, 900, 2, 1), 2u);
    EXPECT_EQ(filas(640, 360, 4, 1.5f), 2u);
    EXPECT_EQ(filas(400, 900, 3, 1), 3u);
    EXPECT_EQ(filas(640, 360, 6, 1), 2u);
    EXPECT_EQ(filas(400, 250, 3, 1), 1u); // con dos columnas harían falta dos filas
}

// --- encuadre ---------------------------------------------------------------------------------------------------

// A 4:3 y más ancha, el ángulo vertical es el pedido; más estrecha, se ve lo mismo a lo ancho que a 4:3. Nunca se deforma.
TEST(Encuadre, EstrecharLaVentanaNoCorta) {
    for (const float aspecto : {0.05f, 0.4444f, 0.8889f, 1.0f, 1.2f, 4.0f / 3, 1.7778f, 20.0f}) {
        const glm::mat4 P = perspectivaVentana(0.6f, 1, 100, aspecto), O = paralelaVentana(2, -1, 1, aspecto);
        const double tangenteY = 1 / P[1][1], tangenteX = 1 / P[0][0], y = 1 / O[1][1], x = 1 / O[0][0];
        EXPECT_NEAR(tangenteX / tangenteY, aspecto, 1e-5 * aspecto);
        EXPECT_NEAR(x / y, aspecto, 1e-5 * aspecto);
        EXPECT_GE(tangenteY, std::tan(0.3) - 1e-6);
        EXPECT_GE(tangenteX, std::tan(0.3) * 4 / 3 - 1e-6);
        EXPECT_NEAR(std::min(tangenteY / std::tan(0.3), tangenteX / std::tan(0.3) * 3 / 4), 1, 1e-5);
        EXPECT_NEAR(std::min(y / 2, x / 2 * 3 / 4), 1, 1e-5);
    }
}

} // namespace
