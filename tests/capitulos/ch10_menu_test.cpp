// Comprobaciones independientes de menu y eventos.
#include "colores.h"
#include "ejecuta.h"
#include "guiones.h"

// La escena de cada opción es la de grua_proyeccion, que ch04_grua comprueba contra rayos en doble. Se empieza en
// perspectiva, que el botón izquierdo orbita, porque el menú está en el derecho.
TEST(Menu, CadaOpcionDaSuMatriz) {
    const std::string gira = arrastra({120, 90}, {150, 80});
    const struct {
        std::vector<std::string> guiones;
        std::string enGrua;
    } casos[] = {{{"", "tecla 2; menu Perspectiva", "tecla 3; tecla 1"}, "tecla 4; tecla p"},
                 {{gira, "tecla 2; tecla 1; " + gira}, "tecla 4; tecla p; " + gira},
                 {{"menu Paralela/Alzado", "tecla 2"}, "tecla 1"},
                 {{"menu Paralela/Planta", "tecla 3"}, "tecla 2"},
                 {{"menu Paralela/Perfil", "tecla 4"}, "tecla 3"}};
    for (const auto &c : casos)
        for (const std::string &guion : c.guiones)
            EXPECT_EQ(vistaDe("menu", guion).escena.rgb, vistaDe("grua_proyeccion", c.enGrua).escena.rgb)
                << guion;
}

// Lo que se recibe es el número, venga del menú, del submenú o de la tecla; y tras Salir el programa ha terminado: la
// orden siguiente sobra.
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
              lineas + "especial F12 5 6\nguardado eventos-1.png\n");
}

// El rastro son los últimos 400 puntos: con uno más, el primero, que está lejos, ya no se ve.
TEST(Eventos, ElRastroNoCreceSinFin) {
    std::string guion = "mueve 10 10";
    for (int i = 1; i < 400; ++i)
        guion += i % 2 ? "; mueve 100 100" : "; mueve 101 100";
    EXPECT_NEAR(vistaDe("eventos", guion).encima.largo(GRIS), std::hypot(90, 90) + 398, 0.1);
    EXPECT_NEAR(vistaDe("eventos", guion + "; mueve 101 100").encima.largo(GRIS), 399, 0.1);
}
