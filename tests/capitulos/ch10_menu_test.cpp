// Comprobaciones independientes de menu y eventos.
#include "colores.h"
#include "ejecuta.h"
#include "encima.h"
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

// Al empezar está en perspectiva; el botón izquierdo la orbita, porque el menú está en el derecho; y cada vista dice cuál es.
TEST(Menu, EmpiezaEnPerspectivaYSeOrbita) {
    const std::string gira = "boton IZQUIERDO abajo 120 90; arrastra 150 80; boton IZQUIERDO arriba 150 80";
    const Imagen inicial = ejecuta("ch10_interaccion/menu").imagen;
    EXPECT_EQ(inicial.rgb, ejecuta("ch10_interaccion/menu", "menu Perspectiva").imagen.rgb);
    const Ejecucion girada = ejecuta("ch10_interaccion/menu", gira);
    EXPECT_NE(inicial.rgb, girada.imagen.rgb);
    mismaEscena(girada, ejecuta("ch04_vista3d/grua_proyeccion", "tecla 4; tecla p; " + gira));
    const struct {
        const char *opcion, *rotulo;
        glm::vec3 color;
    } casos[] = {{"Perspectiva", "(1,1,1) perspectiva", OSCURO},
                 {"Paralela/Alzado", "Alzado paralela", AZUL},
                 {"Paralela/Planta", "Planta paralela", VERDE},
                 {"Paralela/Perfil", "Perfil paralela", ROJO}};
    for (const auto &c : casos) {
        const Imagen imagen =
            ejecuta("ch10_interaccion/menu", std::string("tecla 1; menu ") + c.opcion).imagen;
        const std::vector<Rotulo> cajas = leeRotulo(imagen, c.rotulo, c.color);
        ASSERT_EQ(cajas.size(), 1u) << c.rotulo;
        EXPECT_LT(cajas[0].x0, 12);
        EXPECT_GT(cajas[0].y0, 160);
        EXPECT_TRUE(seLee(imagen, "clic derecho", OSCURO, 198, 169, 6));
    }
}

// Lo que se recibe es el número, venga del menú, del submenú o de la tecla.
TEST(Menu, EscribeElNumero) {
    EXPECT_EQ(ejecuta("ch10_interaccion/menu",
                      "menu Paralela/Perfil; menu Paralela/Alzado; menu Perspectiva; "
                      "menu Paralela/Planta; tecla 2; tecla 5; menu Salir")
                  .salida,
              "opción 4\nopción 2\nopción 1\nopción 3\nopción 2\nopción 0\n");
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

TEST(Eventos, CadaTeclaConSuNombre) {
    const char *const especiales[] = {"ARRIBA", "ABAJO", "IZQUIERDA", "DERECHA", "INICIO", "FIN",
                                      "REPAG",  "AVPAG", "INSERTAR",  "F2",      "F9"};
    const char *const teclas[] = {"Espacio", "Intro", "Tab", "Retroceso", "Supr", "Z", "z", "0"};
    std::string guion = "mueve 5 6", lineas = "tamaño 240 180\nmovimiento 5 6\n";
    for (const std::string nombre : especiales) {
        guion += "; especial " + nombre;
        lineas += "especial " + nombre + " 5 6\n";
    }
    for (const std::string nombre : teclas) {
        guion += "; tecla " + nombre;
        lineas += "tecla " + nombre + " 5 6\n";
    }
    EXPECT_EQ(ejecuta("ch10_interaccion/eventos", guion).salida, lineas);
}

// Esc termina y F12 guarda la ventana, además de verse.
TEST(Eventos, LasTeclasComunesSiguen) {
    EXPECT_EQ(ejecuta("ch10_interaccion/eventos", "tecla Esc; tecla a").estado, 2); // la segunda sobra
    EXPECT_NE(ejecuta("ch10_interaccion/eventos", "especial F12").salida.find("guardado eventos-1.ppm"),
              std::string::npos);
}

// En la ventana, los nueve últimos, de arriba abajo y el último en azul; los movimientos seguidos, como uno.
TEST(Eventos, SeVenLosUltimos) {
    const Imagen imagen =
        ejecuta("ch10_interaccion/eventos",
                "mueve 199 175; mueve 198 170; tecla a; tecla b; tecla c; tecla d; tecla e; tecla f; "
                "especial F3; tecla g; mueve 196 170; mueve 195 170")
            .imagen;
    const char *const seguidos[] = {"tecla a 198 170",     "tecla b 198 170", "tecla c 198 170",
                                    "tecla d 198 170",     "tecla e 198 170", "tecla f 198 170",
                                    "especial F3 198 170", "tecla g 198 170", "movimiento 195 170"};
    for (int i = 0; i < 9; ++i) {
        const std::vector<Rotulo> cajas = leeRotulo(imagen, seguidos[i], i == 8 ? AZUL : OSCURO);
        ASSERT_EQ(cajas.size(), 1u) << seguidos[i];
        EXPECT_NEAR(0.5 * (cajas[0].y0 + cajas[0].y1), 180 * (0.92 - 0.1 * i), 2) << seguidos[i];
    }
    for (const char *otro : {"tamaño 240 180", "movimiento 198 170", "movimiento 196 170"})
        EXPECT_TRUE(leeRotulo(imagen, otro, OSCURO).empty()) << otro;
    const Imagen pocos = ejecuta("ch10_interaccion/eventos", "mueve 199 170; mueve 198 170").imagen;
    EXPECT_EQ(leeRotulo(pocos, "movimiento 198 170", AZUL).size(), 1u);
    EXPECT_TRUE(leeRotulo(pocos, "movimiento 199 170", OSCURO).empty());
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
