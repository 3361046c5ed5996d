// Comprobaciones independientes de menu y eventos.
#include "colores.h"
#include "ejecuta.h"
#include <cstdlib>
#include <gtest/gtest.h>

namespace {
/// Las imágenes, menos la franja de arriba, donde menu dice cómo se abre.
void mismaEscena(const Ejecucion &a, const Ejecucion &b) {
    ASSERT_EQ(a.estado, 0) << a.errores;
    ASSERT_EQ(b.estado, 0) << b.errores;
    for (int y = 0; y < 160; ++y)
        for (int x = 0; x < 240; ++x) {
            const Pixel p = pixel(a.imagen, x, y), q = pixel(b.imagen, x, y);
            ASSERT_TRUE(p.r == q.r && p.g == q.g && p.b == q.b) << x << "," << y;
        }
}
bool es(const Pixel &p, const glm::vec3 &color) {
    const glm::ivec3 c(255.0f * color + 0.5f);
    return p.r == c.r && p.g == c.g && p.b == c.b;
}
} // namespace

// Las matrices de cada opción son las de grua_proyeccion, que ch04_grua comprueba contra rayos en doble.
TEST(Menu, CadaOpcionDaSuMatriz) {
    const struct {
        const char *opcion, *tecla, *otro;
    } casos[] = {{"menu Perspectiva", "tecla 1", "tecla 4; tecla p"},
                 {"menu Paralela/Alzado", "tecla 2", "tecla 1"},
                 {"menu Paralela/Planta", "tecla 3", "tecla 2"},
                 {"menu Paralela/Perfil", "tecla 4", "tecla 3"}};
    for (const auto &c : casos) {
        SCOPED_TRACE(c.opcion);
        const Ejecucion menu = ejecuta("ch10_interaccion/menu", std::string("tecla 2; tecla 3; ") + c.opcion);
        EXPECT_EQ(menu.imagen.rgb, ejecuta("ch10_interaccion/menu", c.tecla).imagen.rgb);
        mismaEscena(menu, ejecuta("ch04_vista3d/grua_proyeccion", c.otro));
    }
}

// Tras Salir (y tras la tecla 0) el programa ha terminado: la orden siguiente sobra.
TEST(Menu, SalirTermina) {
    for (const std::string orden : {"menu Salir", "tecla 0"}) {
        EXPECT_EQ(ejecuta("ch10_interaccion/menu", orden).estado, 0);
        EXPECT_EQ(ejecuta("ch10_interaccion/menu", orden + "; tecla 1").estado, 2) << orden;
    }
    EXPECT_EQ(ejecuta("ch10_interaccion/menu", "menu Alzado").estado, 2); // está en el submenú
}

TEST(Eventos, ElGuionDaJustoSusLineas) {
    const Ejecucion e =
        ejecuta("ch10_interaccion/eventos",
                "mueve 20 30; tecla a; tecla Tab; tecla PuntoYComa; especial F1; especial F10; "
                "especial IZQUIERDA; especial REPAG; boton IZQUIERDO abajo 40 50; arrastra 60 70; "
                "boton IZQUIERDO arriba 60 70; boton CENTRAL abajo 60 70; boton CENTRAL arriba 61 70; "
                "boton DERECHO abajo 61 70; boton DERECHO arriba 61 70; rueda +1 61 70; "
                "rueda -1 61 71; tamano 300 200; tecla Esc");
    EXPECT_EQ(e.estado, 0) << e.errores;
    EXPECT_EQ(e.salida,
              "tamaño 240 180\nmovimiento 20 30\ntecla a 20 30\ntecla Tab 20 30\ntecla ; 20 30\n"
              "especial F1 20 30\nespecial F10 20 30\nespecial IZQUIERDA 20 30\nespecial REPAG 20 30\n"
              "movimiento 40 50\nbotón izquierdo abajo 40 50\narrastre 60 70\nbotón izquierdo arriba 60 70\n"
              "botón central abajo 60 70\narrastre 61 70\nbotón central arriba 61 70\n"
              "botón derecho abajo 61 70\nbotón derecho arriba 61 70\nrueda +1 61 70\nmovimiento 61 71\n"
              "rueda -1 61 71\ntamaño 300 200\ntecla Esc 61 71\n");
}

// El rastro pasa por donde ha ido el puntero, contado desde arriba; y solo el botón pulsado está en naranja.
TEST(Eventos, ElRastroYLosBotones) {
    const char *const botones[] = {"IZQUIERDO", "CENTRAL", "DERECHO"};
    for (int i = 0; i < 3; ++i) {
        const Imagen imagen = ejecuta("ch10_interaccion/eventos", "mueve 40 160; mueve 80 160; boton " +
                                                                      std::string(botones[i]) +
                                                                      " abajo 80 160; arrastra 140 160")
                                  .imagen;
        EXPECT_TRUE(es(pixel(imagen, 60, 179 - 160), GRIS));
        EXPECT_TRUE(es(pixel(imagen, 110, 179 - 160), NARANJA));
        EXPECT_TRUE(es(pixel(imagen, 140, 179 - 160), ROJO));
        for (int k = 0; k < 3; ++k) // el cuadrado del ratón mide 57 píxeles y llega al borde derecho
            EXPECT_EQ(es(pixel(imagen, 183 + 28 + 10 * (k - 1), 90 + 13), NARANJA), k == i) << i << k;
    }
}
