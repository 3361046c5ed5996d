// Lo que se pinta encima de la escena (common/encima/rotulo): se dibuja en una ventana sin pantalla y se miran
// los píxeles. Dónde cae cada cosa y de qué color, en los programas (encima.h); lo que se ve de los trazos, en los del
// capítulo 11 (pintado.h).
#include "captura.h"
#include "colores.h"
#include "imagen.h"
#include "letra.h"
#include "prueba.h"
#include "recuadro.h"
#include "rotulo.h"
#include "trazo.h"
#include "ventana.h"
// después de glew.h
#include "glut/sin_ventana/glut_sin_ventana.h"
// clang-format off
#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H
// clang-format on

namespace {

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
        glutDisplayFunc([] {});
    }

    // Como si lo hiciera el usuario: la que pide el programa no cambia hasta que acaba la función que la pide.
    static void cambiaTalla(const glm::ivec2 &talla) {
        glutOrden(("tamano " + std::to_string(talla.x) + " " + std::to_string(talla.y)).c_str());
    }

    /// La ventana, de ese tamaño, tras dibujar sobre fondo blanco.
    static Imagen pinta(const glm::ivec2 &talla, const std::function<void()> &dibujo) {
        cambiaTalla(talla);
        abreRecuadro(ventanaEntera());
        ponFondo(BLANCO);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
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
};

// La mezcla y el búfer de quien pinta debajo. Lo demás que vuelve a como estaba se le pide a cada programa
// (propiedades).
TEST_F(Ayudas, DejanLaMezclaYElBuferComoEstaban) {
    const auto estado = [] {
        std::vector<GLint> valores;
        for (const GLenum que : {GL_ARRAY_BUFFER_BINDING, GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB,
                                 GL_BLEND_SRC_ALPHA, GL_BLEND_DST_ALPHA})
            glGetIntegerv(que, &valores.emplace_back());
        return valores;
    };
    GLuint bufer;
    glGenBuffers(1, &bufer);
    glBindBuffer(GL_ARRAY_BUFFER, bufer);
    glBlendFuncSeparate(GL_ONE, GL_SRC_COLOR, GL_DST_ALPHA, GL_ZERO);
    const std::vector<GLint> antes = estado();
    rotula("abc", {0.5f, 0.5f}, ROJO);
    EXPECT_EQ(estado(), antes);
}

// Cada signo, a tres tamaños, frente a lo que cubre su contorno en cada píxel, según FreeType. El atlas es de 32 por
// cuadratín y redondea las esquinas: se admite una diferencia cuadrática media de un 8 % de tinta en los píxeles de su
// caja (hay hasta un 7.5).
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

// Lo que no cabe, a lo ancho o a lo alto, se encoge: en el borde no hay nada.
TEST_F(Ayudas, LoQueNoCabeSeEncoge) {
    for (const auto &[veces, trozo] : {std::pair{60, "M"}, {22, "M\n"}}) {
        std::string texto = "M";
        for (int i = 1; i < veces; ++i)
            texto += trozo;
        const Imagen imagen = pinta([&] { rotula(texto, {0.5f, 0.5f}, ROJO); });
        for (int i = 0; i < 480; ++i)
            for (const glm::ivec2 &p : {glm::ivec2(i, 0), {i, 359}, {0, i % 360}, {479, i % 360}})
                ASSERT_EQ(color(imagen, p.x, p.y), glm::ivec3(255)) << p.x << ", " << p.y << ": " << texto;
    }
}

// Ni dónde empieza ni dónde acaba se nota.
TEST_F(Ayudas, UnaPolilineaCerradaEsLaMismaDesdeCadaVertice) {
    std::vector<glm::vec3> puntos = {
        {-0.6f, -0.5f, 0}, {0.5f, -0.7f, 0}, {0.1f, 0, 0}, {0.7f, 0.6f, 0}, {-0.5f, 0.5f, 0}};
    const auto pintada = [&] {
        return pinta([&] { trazaPolilinea(puntos, glm::mat4(1), ROJO, 5 * GROSOR, true); }).rgb;
    };
    const auto desdeElPrimero = pintada();
    for (std::size_t i = 1; i < puntos.size(); ++i) {
        std::rotate(puntos.begin(), puntos.begin() + 1, puntos.end());
        EXPECT_TRUE(pintada() == desdeElPrimero) << i;
    }
}

// Se lea quien se lea y sobre lo que sea: la letra, que es lo que más se pinta, y el halo, lo segundo, contrastan 4.5
// (WCAG 2). El color pedido se cambia solo si no llega.
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
            abreRecuadro(ventanaEntera());
            ponFondo(fondo);
            glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
            rotula("□", {0.5f, 0.5f}, tinta, Lado::CENTRO, 0.3f);
        });
        std::map<std::array<int, 3>, int> cuantos;
        for (int y = 0; y < imagen.alto; ++y)
            for (int x = 0; x < imagen.ancho; ++x)
                if (const glm::ivec3 c = color(imagen, x, y); c != enNiveles(fondo))
                    ++cuantos[{c.r, c.g, c.b}];
        const auto masPintado = [&] {
            const auto este = std::max_element(cuantos.begin(), cuantos.end(),
                                               [](auto &a, auto &b) { return a.second < b.second; });
            const auto [c, n] = *este;
            cuantos.erase(este);
            return glm::ivec3(c[0], c[1], c[2]);
        };
        ASSERT_GE(cuantos.size(), 2u);
        const glm::ivec3 letra = masPintado(), halo = masPintado();
        EXPECT_GE(contraste(letra, halo), 4.45) << i;
        EXPECT_TRUE(letra == enNiveles(tinta) || contraste(enNiveles(tinta), halo) < 4.55) << i;
    }
}

} // namespace
