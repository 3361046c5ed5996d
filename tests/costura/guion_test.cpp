// El guion de glut_sin_ventana: lo que entiende, y qué dice de lo que no.
#include "ejecuta.h"
#include "glut_sin_ventana/guion.h"
#include <GL/freeglut.h>
#include <cstdio>
#include <gtest/gtest.h>

using namespace sin_ventana;
using testing::ExitedWithCode;

TEST(Guion, EntiendeCadaOrden) {
    const auto g =
        leeGuion("tecla a; tecla Esc;especial F5 ; boton DERECHO abajo 3 -4;arrastra 10 20; mueve 1 2;"
                 "rueda -1 5 6; menu Vista/Planta baja; tamano 320 200; espera 250; captura una foto.ppm");
    ASSERT_EQ(g.size(), 11u);
    EXPECT_EQ(g[0].tipo, Orden::TECLA);
    EXPECT_EQ(g[0].a, 'a');
    EXPECT_EQ(g[1].a, 27);
    EXPECT_EQ(g[2].a, GLUT_KEY_F5);
    EXPECT_EQ(g[3].a, GLUT_RIGHT_BUTTON);
    EXPECT_EQ(g[3].b, GLUT_DOWN);
    EXPECT_EQ(g[3].x, 3);
    EXPECT_EQ(g[3].y, -4);
    EXPECT_EQ(g[4].tipo, Orden::ARRASTRA);
    EXPECT_EQ(g[5].tipo, Orden::MUEVE);
    EXPECT_EQ(g[6].a, -1);
    EXPECT_EQ(g[7].texto, "Vista/Planta baja");
    EXPECT_EQ(g[8].a, 320);
    EXPECT_EQ(g[8].b, 200);
    EXPECT_EQ(g[9].a, 250);
    EXPECT_EQ(g[10].texto, "una foto.ppm");
}

TEST(Guion, SinOrdenes) {
    EXPECT_TRUE(leeGuion("").empty());
    EXPECT_TRUE(leeGuion(" ; ;; ").empty());
    EXPECT_TRUE(leeGuion("\v;\f; \t\r\v\f").empty());
}

TEST(Guion, TeclaPuntoYComaYAlmohadilla) {
    const auto g = leeGuion("tecla PuntoYComa; tecla #");
    EXPECT_EQ(g[0].a, ';');
    EXPECT_EQ(g[1].a, '#');
}

// Cada error termina con 2 y nombra la orden, su número y lo que se esperaba.
TEST(GuionMal, DiceDondeYQue) {
    const struct {
        const char *guion, *mensaje;
    } casos[] = {
        {"tecla a; teclas b", "guion, orden 2 «teclas b»: no conozco la orden «teclas»"},
        {"tecla", "orden 1 «tecla»: falta una tecla"},
        {"tecla ab", "«ab» no es una tecla"},
        {"tecla a b", "sobra «b»"},
        {"especial F13", "«F13» no es una tecla especial"},
        {"boton MEDIO abajo 1 2", "«MEDIO» no es un botón"},
        {"boton IZQUIERDO pulsa 1 2", "«pulsa» no es un movimiento del botón"},
        {"boton IZQUIERDO abajo 1", "falta la y"},
        {"arrastra 1.5 2", "«1.5» no es un número"},
        {"arrastra diez 2", "«diez» no es un número"},
        {"rueda 2 1 1", "«2» no es un giro de la rueda"},
        {"tamano 0 10", "«0» no es un número entre 1 y 16384"},
        {"tamano 99999999999999999999 10", "no es un número entre 1 y 16384"},
        {"espera -1", "«-1» no es un número entre 0"},
        {"menu", "falta la ruta de la opción"},
        {"captura", "falta el fichero"},
        {"arrastra +1 2", "«[+]1» no es un número"},
        {"arrastra 1 0x10", "«0x10» no es un número"},
        {"tamano 1e2 10", "«1e2» no es un número"},
        {"@/no/existe.guion", "-guion: no puedo leer «/no/existe.guion»"},
        {"@/dev", "-guion: «/dev» es una carpeta, no un fichero"},
        {"@/dev/zero", "-guion: «/dev/zero» ocupa más de 256 MiB"},
    };
    for (const auto &c : casos)
        EXPECT_EXIT(leeGuion(c.guion), ExitedWithCode(2), c.mensaje) << c.guion;
}

TEST(GuionMal, EnUnFicheroDiceLaLinea) {
    const std::string fichero = (carpetaTemporal() / "prueba.guion").string();
    FILE *f = std::fopen(fichero.c_str(), "w");
    std::fputs("# un comentario\ntecla a; espera 10\n\n  gira 3\n", f);
    std::fclose(f);
    EXPECT_EXIT(leeGuion("@" + fichero), ExitedWithCode(2),
                "prueba.guion:4 «gira 3»: no conozco la orden «gira»");
}

TEST(Talla, AnchoPorAlto) {
    int ancho = 0, alto = 0;
    tallaDe("240x180", ancho, alto, "-geometry");
    EXPECT_EQ(ancho, 240);
    EXPECT_EQ(alto, 180);
    tallaDe("300x200+10-20", ancho, alto, "-geometry"); // la posición de X se admite
    EXPECT_EQ(alto, 200);
    for (const char *mal :
         {"", "240", "240x", "x180", "0x10", "240x-5", "axb", "240x180z", "10x10+hola", "10x10+1", "10x10+1+",
          "10x10+1+2+3", "10x10++", "+10x+10", " 10x10", "10x 10", "16385x1"})
        EXPECT_EXIT(tallaDe(mal, ancho, alto, "-geometry"), ExitedWithCode(2), "-geometry: ") << mal;
}
