// Las ayudas de dibujo de common/: trazo, rotulo, recuadro y el encuadre de perspectivaVentana y paralelaVentana. Se dibuja en una
// ventana sin pantalla y se miran los píxeles.
#include "aspecto.h"
#include "colores.h"
#include "imagen.h"
#include "letra.h"
#include "buferes.h"
#include "recuadro.h"
#include "rotulo.h"
#include "trazo.h"
#include "ventana.h"
#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <set>
#include <utility>

namespace {

const glm::mat4 UNO(1);

class Ayudas : public testing::Test {
protected:
    static void SetUpTestSuite() {
        static char nombre[] = "ayudas", opcion[] = "-geometry", talla[] = "480x360";
        static char *argv[] = {nombre, opcion, talla, nullptr};
        int argc = 3;
        abreVentana(argc, argv, "Ayudas", GLUT_DOUBLE | GLUT_DEPTH);
    }

    /// La ventana, de ese tamaño, tras dibujar sobre fondo blanco.
    static Imagen pinta(const std::function<void()> &dibujo, int ancho = 480, int alto = 360) {
        glutReshapeWindow(ancho, alto);
        abreRecuadro(ventanaEntera(), BLANCO);
        dibujo();
        EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
        return leeVentana();
    }

    static glm::ivec3 color(const Imagen &i, int x, int y) {
        const std::size_t k = 3 * static_cast<std::size_t>(y * i.ancho + x);
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

TEST_F(Ayudas, ElGrosorEsEnPixelesDe1080Lineas) {
    for (const glm::ivec2 talla : {glm::ivec2(480, 360), {960, 720}, {640, 360}, {360, 900}}) {
        const double altoUtil = std::min<double>(talla.y, 0.75 * talla.x);
        for (const float grosor : {6.0f, 30.0f, 60.0f}) {
            const double esperado = std::max(grosor * altoUtil / 1080, 1.0);
            const Caja h = caja(pinta(
                [&] {
                    trazaPolilinea({{-0.5f, 0, 0}, {0.5f, 0, 0}}, UNO, ROJO, grosor);
                },
                talla.x, talla.y));
            EXPECT_NEAR(h.maximo.y - h.minimo.y + 1, esperado, 1)
                << talla.x << "×" << talla.y << " " << grosor;
            EXPECT_NEAR(h.maximo.x - h.minimo.x + 1, talla.x / 2, 1);
            const Caja v = caja(pinta(
                [&] {
                    trazaPolilinea({{0, -0.5f, 0}, {0, 0.5f, 0}}, UNO, ROJO, grosor);
                },
                talla.x, talla.y));
            EXPECT_NEAR(v.maximo.x - v.minimo.x + 1, esperado, 1);
        }
    }
}

// Un segmento inclinado cubre largo × grosor píxeles y tiene su color.
TEST_F(Ayudas, AreaYColorDeUnSegmentoInclinado) {
    const Imagen imagen = pinta([] { trazaPolilinea({{-0.5f, -0.5f, 0}, {0.5f, 0.43f, 0}}, UNO, AZUL, 30); });
    const double largo = std::hypot(1.0 * 240, 0.93 * 180);
    EXPECT_NEAR(caja(imagen).pixeles, largo * 10, largo * 0.2);
    EXPECT_EQ(color(imagen, 240, 174), glm::ivec3(255.0f * AZUL + 0.5f));
}

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

TEST_F(Ayudas, LaFlechaAcabaEnSuPunta) {
    const Caja c = caja(pinta([] { trazaFlecha({-0.5f, 0, 0}, {0.5f, 0, 0}, UNO, ROJO, 12); }));
    EXPECT_NEAR(c.maximo.x, 359, 2); // el último píxel de la punta es estrecho
    EXPECT_NEAR(c.minimo.x, 120, 1);
    EXPECT_GT(c.maximo.y - c.minimo.y, 12); // la punta es más ancha que el palo, de 4 píxeles
    const Imagen f = pinta([] { trazaFlecha({-0.5f, 0, 0}, {0.5f, 0, 0}, UNO, ROJO, 12); });
    EXPECT_TRUE(esBlanco(f, 130, 188)); // la punta está en b y no en a
    EXPECT_FALSE(esBlanco(f, 344, 185));
    // una flecha de largo nulo no pinta ni da NaN
    EXPECT_EQ(caja(pinta([] { trazaFlecha({0, 0, 0}, {0, 0, 0}, UNO, ROJO); })).pixeles, 0);
}

TEST_F(Ayudas, LosPuntosSonDiscos) {
    const Caja c = caja(pinta([] { trazaPuntos({{0, 0, 0}}, UNO, ROJO, 120); }));
    EXPECT_NEAR(c.pixeles, 3.1416 * 20 * 20, 40);
    EXPECT_NEAR(c.maximo.x - c.minimo.x + 1, 40, 1);
}

TEST_F(Ayudas, ObedecenALaProfundidad) {
    const Imagen imagen = pinta([] {
        glEnable(GL_DEPTH_TEST);
        trazaPoligono({{-1, -1, 0}, {0, -1, 0}, {0, 1, 0}, {-1, 1, 0}}, UNO, GRIS);
        trazaSegmentos({{-0.8f, 0, 0.5f}, {0.8f, 0, 0.5f}}, UNO, ROJO, 30);
        trazaSegmentos({{-0.9f, 0.5f, 0.5f}, {-0.1f, 0.5f, -0.5f}}, UNO, ROJO, 30); // asoma por la mitad
        rotula("T", {0.25f, 0.25f}, OSCURO);                                        // los rótulos, no
        EXPECT_TRUE(glIsEnabled(GL_DEPTH_TEST));
        glDisable(GL_DEPTH_TEST);
    });
    EXPECT_EQ(color(imagen, 120, 180), glm::ivec3(255.0f * GRIS + 0.5f));
    EXPECT_EQ(color(imagen, 360, 180), glm::ivec3(255.0f * ROJO + 0.5f));
    EXPECT_EQ(color(imagen, 60, 270), glm::ivec3(255.0f * GRIS + 0.5f));
    EXPECT_EQ(color(imagen, 180, 270), glm::ivec3(255.0f * ROJO + 0.5f));
    EXPECT_EQ(color(imagen, 120, 90), glm::ivec3(255.0f * OSCURO + 0.5f));
}

TEST_F(Ayudas, DejanElEstadoComoEstaba) {
    const Buferes cubo = creaBuferes(::cubo());
    glBindVertexArray(cubo.vao);
    glUseProgram(0);
    glEnable(GL_CULL_FACE);
    pinta([] {
        trazaPuntos({{0, 0, 0}}, UNO, ROJO);
        rotula("abc", {0.5f, 0.5f}, ROJO);
    });
    GLint vao, programa;
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &vao);
    glGetIntegerv(GL_CURRENT_PROGRAM, &programa);
    EXPECT_EQ(static_cast<GLuint>(vao), cubo.vao);
    EXPECT_EQ(programa, 0);
    EXPECT_TRUE(glIsEnabled(GL_CULL_FACE));
    glDisable(GL_CULL_FACE);
}

// --- rotulo -----------------------------------------------------------------------------------------------------

TEST_F(Ayudas, CadaLetraEsDistintaYTieneTinta) {
    std::set<std::array<unsigned char, 7>> formas;
    for (const auto &[c, filas] : LETRA) {
        unsigned tinta = 0;
        for (const unsigned char fila : filas) {
            EXPECT_LT(fila, 32) << static_cast<unsigned>(c);
            tinta += fila;
        }
        EXPECT_GT(tinta, 0u);
        EXPECT_TRUE(formas.insert(filas).second || c == U'θ' || c == U'−')
            << "repetida: " << static_cast<unsigned>(c);
    }
    for (const char32_t c : std::u32string(U"áéíóúüñÁÉÍÓÚÑ¿¡π√·×°θΦφαδ"))
        EXPECT_TRUE(LETRA.count(c)) << static_cast<unsigned>(c);
}

// La F: sus cuadrados, en su sitio, al derecho y nítidos (solo tres colores).
TEST_F(Ayudas, LaLetraSaleComoEs) {
    for (const int alto : {180, 360, 1080}) {
        const Imagen imagen = pinta([] { rotula("F", {0.5f, 0.5f}, AZUL); }, alto * 4 / 3, alto);
        const int celda = std::max(static_cast<int>(std::lround(0.04 * alto / 7)), 1),
                  halo = std::max(celda / 2, 1);
        const Caja c = caja(imagen); // el halo es blanco: la caja es la de la tinta
        EXPECT_EQ(c.maximo - c.minimo + 1, glm::ivec2(5 * celda, 7 * celda)) << alto;
        const char *const F[7] = {"#####", "#....", "#....", "####.", "#....", "#....", "#...."};
        for (int fila = 0; fila < 7; ++fila)
            for (int columna = 0; columna < 5; ++columna)
                EXPECT_EQ(!esBlanco(imagen, c.minimo.x + columna * celda + celda / 2,
                                    c.maximo.y - fila * celda - celda / 2),
                          F[fila][columna] == '#')
                    << alto << " " << fila << " " << columna;
        const Imagen oscura = pinta(
            [] {
                abreRecuadro(ventanaEntera(), OSCURO);
                rotula("F", {0.5f, 0.5f}, AZUL);
            },
            alto * 4 / 3, alto);
        std::set<int> colores;
        for (std::size_t k = 0; k < oscura.rgb.size(); k += 3)
            colores.insert(oscura.rgb[k] << 16 | oscura.rgb[k + 1] << 8 | oscura.rgb[k + 2]);
        EXPECT_EQ(colores.size(), 3u) << "fondo, halo y tinta";
        EXPECT_TRUE(esBlanco(oscura, c.minimo.x - halo, c.maximo.y)) << "el halo mide " << halo;
        EXPECT_FALSE(esBlanco(oscura, c.minimo.x - halo - 1, c.maximo.y));
    }
}

TEST_F(Ayudas, UnRotuloNoTapaSuPuntoNiSeSale) {
    for (const glm::ivec2 talla : {glm::ivec2(240, 180), {480, 360}, {200, 450}, {640, 360}})
        for (const Lado lado : {Lado::ENCIMA, Lado::DEBAJO, Lado::IZQUIERDA, Lado::DERECHA})
            for (float x = -0.9f; x < 1; x += 0.3f)
                for (float y = -0.9f; y < 1; y += 0.3f) {
                    const Imagen imagen = pinta(
                        [&] {
                            rotulaPunto("P(1,2)", {x, y, 0}, UNO, ROJO, lado);
                        },
                        talla.x, talla.y);
                    const Caja c = caja(imagen);
                    EXPECT_GT(c.pixeles, 50);
                    EXPECT_GE(c.minimo.x, 1);
                    EXPECT_GE(c.minimo.y, 1);
                    EXPECT_LE(c.maximo.x, talla.x - 2);
                    EXPECT_LE(c.maximo.y, talla.y - 2);
                    const int px = static_cast<int>((x + 1) / 2 * static_cast<float>(talla.x)),
                              py = static_cast<int>((y + 1) / 2 * static_cast<float>(talla.y));
                    for (int dx = -1; dx <= 1; ++dx)
                        for (int dy = -1; dy <= 1; ++dy)
                            EXPECT_TRUE(esBlanco(imagen, px + dx, py + dy))
                                << talla.x << "×" << talla.y << " lado " << static_cast<int>(lado) << " en "
                                << x << " " << y;
                }
}

TEST_F(Ayudas, ElRotuloVaASuLado) {
    const auto centro = [](Lado lado) {
        const Caja c = caja(pinta([&] { rotulaPunto("abc", {0, 0, 0}, UNO, ROJO, lado); }));
        return 0.5 * glm::dvec2(c.minimo + c.maximo) - glm::dvec2(239.5, 179.5);
    };
    EXPECT_GT(centro(Lado::ENCIMA).y, 8);
    EXPECT_LT(centro(Lado::DEBAJO).y, -8);
    EXPECT_GT(centro(Lado::DERECHA).x, 15);
    EXPECT_LT(centro(Lado::IZQUIERDA).x, -15);
    EXPECT_LT(glm::length(centro(Lado::CENTRO)), 3);
}

TEST_F(Ayudas, FueraDelVolumenNoHayRotulo) {
    const glm::mat4 proyeccion = perspectivaVentana(1, 0.1f, 100);
    for (const glm::vec3 &p : {glm::vec3(0, 0, 5), {0, 0, 0}, {50, 0, -5}, {0, -50, -5}, {0, 0, -0.05f}})
        EXPECT_EQ(caja(pinta([&] { rotulaPunto("abc", p, proyeccion, ROJO); })).pixeles, 0)
            << p.x << p.y << p.z;
    EXPECT_GT(caja(pinta([&] { rotulaPunto("abc", {0, 0, -5}, proyeccion, ROJO); })).pixeles, 0);
}

TEST_F(Ayudas, UnRotuloLargoEncogeYLaLineaNuevaBaja) {
    const Caja largo = caja(pinta([] { rotula(std::string(60, 'M'), {0.5f, 0.5f}, ROJO); }));
    EXPECT_GT(largo.minimo.x, 0);
    EXPECT_LT(largo.maximo.x, 479);
    EXPECT_EQ(largo.maximo.y - largo.minimo.y + 1, 7);
    const Imagen dos = pinta([] { rotula("F\nF", {0.5f, 0.5f}, ROJO); });
    const Caja c = caja(dos);
    EXPECT_EQ(c.maximo - c.minimo + 1, glm::ivec2(5 * 2, (7 + 10) * 2));
}

// --- recuadro ---------------------------------------------------------------------------------------------------

TEST_F(Ayudas, LaRejillaLlenaLaVentanaSinSolaparse) {
    for (int ancho = 1; ancho < 60; ++ancho)
        for (int alto : {1, 2, 7, 50}) {
            glutReshapeWindow(ancho, alto);
            for (const auto &[columnas, filas] : {std::pair(1, 1), {2, 2}, {3, 2}, {1, 4}}) {
                const std::vector<Recuadro> paneles = rejilla(columnas, filas);
                std::vector<int> veces(static_cast<std::size_t>(ancho * alto));
                for (const Recuadro &r : paneles) {
                    ASSERT_GE(std::min({r.x, r.y, r.ancho, r.alto}), 0);
                    for (int y = r.y; y < r.y + r.alto; ++y)
                        for (int x = r.x; x < r.x + r.ancho; ++x)
                            ++veces.at(static_cast<std::size_t>(y * ancho + x));
                }
                EXPECT_LE(*std::max_element(veces.begin(), veces.end()), 1);
                if (ancho > 20 && alto > 20) {
                    EXPECT_EQ(std::count(veces.begin(), veces.end(), 0),
                              (columnas - 1) * alto + (filas - 1) * ancho - (columnas - 1) * (filas - 1));
                    EXPECT_EQ(paneles.front().x, 0);
                    EXPECT_EQ(paneles.front().y + paneles.front().alto, alto)
                        << "la primera fila es la de arriba";
                    EXPECT_EQ(paneles.back().x + paneles.back().ancho, ancho);
                    EXPECT_EQ(paneles.back().y, 0);
                }
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
}

TEST_F(Ayudas, AbrirUnRecuadroSoloBorraElSuyo) {
    const Imagen imagen = pinta([] {
        glViewport(0, 0, 480, 360);
        const Recuadro r = rejilla(2, 2)[1];
        abreRecuadro(r, ROJO);
        GLint v[4];
        glGetIntegerv(GL_VIEWPORT, v);
        EXPECT_EQ(glm::ivec4(v[0], v[1], v[2], v[3]), glm::ivec4(r.x, r.y, r.ancho, r.alto));
        EXPECT_FALSE(glIsEnabled(GL_SCISSOR_TEST));
    });
    const Caja c = caja(imagen);
    EXPECT_EQ(c.minimo, glm::ivec2(241, 181));
    EXPECT_EQ(c.maximo, glm::ivec2(479, 359));
    EXPECT_EQ(c.pixeles, 239 * 179);
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
