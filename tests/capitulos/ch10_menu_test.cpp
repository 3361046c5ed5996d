// Comprobaciones independientes de menu y eventos.
#include "colores.h"
#include "ejecuta.h"
#include "guiones.h"
#include <gtest/gtest.h>

// La escena de cada opción, y los ejes de su esquina, son los de grua_proyeccion, que ch04_grua comprueba contra rayos en doble. Se
// empieza en perspectiva, que el botón izquierdo orbita, porque el menú está en el derecho. Y cada vista dice cuál es.
TEST(Menu, CadaOpcionDaSuMatriz) {
    const std::string gira = arrastra({120, 90}, {150, 80});
    const struct {
        std::vector<std::string> guiones;
        std::string enGrua, rotulo;
        glm::vec3 color;
    } casos[] = {
        {{"", "tecla 2; menu Perspectiva", "tecla 3; tecla 1"},
         "tecla 4; tecla p",
         "(1,1,1) perspectiva",
         OSCURO},
        {{gira, "tecla 2; tecla 1; " + gira}, "tecla 4; tecla p; " + gira, "(1,1,1) perspectiva", OSCURO},
        {{"menu Paralela/Alzado", "tecla 2"}, "tecla 1", "Alzado paralela", AZUL},
        {{"menu Paralela/Planta", "tecla 3"}, "tecla 2", "Planta paralela", VERDE},
        {{"menu Paralela/Perfil", "tecla 4"}, "tecla 3", "Perfil paralela", ROJO}};
    for (const auto &c : casos)
        for (const std::string &guion : c.guiones) {
            SCOPED_TRACE(guion);
            const Vista menu = vistaDe("menu", guion), grua = vistaDe("grua_proyeccion", c.enGrua);
            EXPECT_EQ(menu.escena.rgb, grua.escena.rgb);
            for (const glm::vec3 &eje : COLOR_EJE)
                EXPECT_EQ(menu.encima.trazos(eje).at(0).puntos, grua.encima.trazos(eje).at(0).puntos);
            compruebaRotulo(menu.encima, c.rotulo, {0.02 * 240, 0.94 * 180}, c.color, Lado::DERECHA);
            compruebaRotulo(menu.encima, "clic derecho", {0.98 * 240, 0.94 * 180}, OSCURO, Lado::IZQUIERDA);
        }
}

// Lo que se recibe es el número, venga del menú, del submenú o de la tecla; y tras Salir el programa ha terminado: la orden siguiente
// sobra.
TEST(Menu, EscribeElNumero) {
    const Ejecucion e = ejecuta("menu", "menu Paralela/Perfil; menu Paralela/Alzado; menu Perspectiva; "
                                        "menu Paralela/Planta; tecla 2; tecla 5; menu Salir; tecla 1");
    EXPECT_EQ(e.salida, "opción 4\nopción 2\nopción 1\nopción 3\nopción 2\nopción 0\n");
    EXPECT_EQ(e.estado, 2);
    EXPECT_EQ(ejecuta("menu", "tecla 0").salida, "opción 0\n");
}

TEST(Eventos, ElGuionDaJustoSusLineas) {
    const Ejecucion e = ejecuta(
        "eventos", "mueve 20 30; tecla PuntoYComa; boton IZQUIERDO abajo 40 50; arrastra 60 70; boton "
                   "IZQUIERDO arriba 60 70; "
                   "boton CENTRAL abajo 60 70; boton CENTRAL arriba 61 70; boton DERECHO abajo 61 70; "
                   "boton DERECHO arriba 61 70; rueda +1 61 70; rueda -1 61 71; tamano 300 200; tecla Esc");
    EXPECT_EQ(e.estado, 0) << e.errores;
    EXPECT_EQ(e.salida,
              "tamaño 240 180\nmovimiento 20 30\ntecla ; 20 30\n"
              "movimiento 40 50\nbotón izquierdo abajo 40 50\narrastre 60 70\nbotón izquierdo arriba 60 70\n"
              "botón central abajo 60 70\narrastre 61 70\nbotón central arriba 61 70\n"
              "botón derecho abajo 61 70\nbotón derecho arriba 61 70\nrueda +1 61 70\nmovimiento 61 71\n"
              "rueda -1 61 71\ntamaño 300 200\ntecla Esc 61 71\n");
}

TEST(Eventos, CadaTeclaConSuNombre) {
    std::string guion = "mueve 5 6", lineas = "tamaño 240 180\nmovimiento 5 6\n";
    for (const std::string tecla : {"especial ARRIBA",  "especial ABAJO",  "especial IZQUIERDA",
                                    "especial DERECHA", "especial INICIO", "especial FIN",
                                    "especial REPAG",   "especial AVPAG",  "especial INSERTAR",
                                    "especial F1",      "especial F2",     "especial F9",
                                    "especial F10",     "tecla Espacio",   "tecla Intro",
                                    "tecla Tab",        "tecla Retroceso", "tecla Supr",
                                    "tecla Z",          "tecla z",         "tecla 0",
                                    "tecla #",          "tecla ~"}) {
        guion += "; " + tecla;
        lineas += tecla + " 5 6\n";
    }
    EXPECT_EQ(ejecuta("eventos", guion + "; especial F12").salida,
              lineas + "especial F12 5 6\nguardado eventos-1.ppm\n");
}

// En la ventana, los nueve últimos, de arriba abajo y el último en azul; los movimientos seguidos, como uno.
TEST(Eventos, SeVenLosUltimos) {
    const auto comprueba = [](const std::string &guion, const std::vector<std::string> &sucesos) {
        std::vector<Letrero> letreros;
        for (const std::string &suceso : sucesos)
            letreros.push_back(
                {suceso, {0.03 * 240, 180 * (0.92 - 0.1 * double(letreros.size()))}, OSCURO, Lado::DERECHA});
        letreros.back().color = AZUL;
        compruebaRotulos(vistaDe("eventos", guion).encima, letreros);
    };
    const std::string mueve = "mueve 199 175; mueve 198 170; ";
    comprueba(mueve, {"tamaño 240 180", "movimiento 198 170"});
    comprueba(mueve + "tecla a; tecla b; tecla c; tecla d; tecla e; tecla f; especial F3; tecla g; mueve 196 "
                      "170; mueve 195 170",
              {"tecla a 198 170", "tecla b 198 170", "tecla c 198 170", "tecla d 198 170", "tecla e 198 170",
               "tecla f 198 170", "especial F3 198 170", "tecla g 198 170", "movimiento 195 170"});
}

// El rastro son los últimos 400 puntos: con uno más, el primero, que está lejos, ya no se ve.
TEST(Eventos, ElRastroNoCreceSinFin) {
    std::string guion = "mueve 10 10";
    for (int i = 1; i < 400; ++i)
        guion += i % 2 ? "; mueve 100 100" : "; mueve 101 100";
    EXPECT_NEAR(vistaDe("eventos", guion).encima.largo(GRIS), std::hypot(90, 90) + 398, 0.1);
    EXPECT_NEAR(vistaDe("eventos", guion + "; mueve 101 100").encima.largo(GRIS), 399, 0.1);
}

// El rastro pasa por donde ha ido el puntero, contado desde arriba; y solo el botón pulsado está en naranja.
TEST(Eventos, ElRastroYLosBotones) {
    const std::string botones[] = {"IZQUIERDO", "CENTRAL", "DERECHO"};
    const glm::dvec2 a(40.5, 180 - 160.5), b(80.5, 180 - 160.5), c(140.5, 180 - 150.5);
    for (int i = 0; i < 3; ++i) {
        const std::string &boton = botones[i];
        const std::string guion =
            "mueve 40 160; mueve 80 160; boton " + boton + " abajo 80 160; arrastra 140 150";
        const Encima encima = vistaDe("eventos", guion).encima;
        compruebaTrazo(encima, {a, b}, GRIS);
        EXPECT_NEAR(encima.largo(GRIS), glm::distance(a, b), 0.1);
        compruebaTrazo(encima.trazos(NARANJA, "segmentos"), {b, c}, NARANJA);
        compruebaPuntos(encima, {c}, ROJO);
        // el cuadrado del ratón mide 57 píxeles y llega al borde derecho
        const Encima pulsados = encima.trazos(NARANJA, "poligono");
        ASSERT_EQ(pulsados.size(), 1u);
        const glm::dvec2 centro = 0.5 * (pulsados[0].punto(0) + pulsados[0].punto(2));
        EXPECT_LE(glm::distance(centro, {183 + 28.5 * (0.65 + 0.35 * i), 61 + 28.5 * 1.45}), 0.1) << boton;
        EXPECT_TRUE(vistaDe("eventos", guion + "; boton " + boton + " arriba 140 150")
                        .encima.trazos(NARANJA, "poligono")
                        .empty());
    }
}
