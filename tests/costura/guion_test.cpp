// El guion de glut_sin_ventana: lo que entiende, y qué dice de lo que no.
#include "ejecuta.h"
#include "glut/sin_ventana/guion.h"

using namespace sin_ventana;
using testing::ExitedWithCode;

// Lo que las órdenes hacen, en costura_test.cpp y ch10_menu_test.cpp.
TEST(Guion, SinOrdenes) {
    for (const char *guion : {"", " ; ;; ", "\v;\f; \t\r\v\f", "escala 240 180"})
        EXPECT_TRUE(leeGuion(guion).empty()) << guion;
}

// La última palabra que empieza por × dice cuántas veces; lo de antes es la orden, aunque también lo lleve.
TEST(Guion, CualquierOrdenSeRepite) {
    const auto g = leeGuion(
        "tecla d; tecla d ×7; captura ×9 ×1; menu A ×2; menu A ×2 ×1; captura f ×10000; espera 5 ×3");
    const int veces[] = {1, 7, 1, 2, 1, 10000, 3};
    ASSERT_EQ(g.size(), 7u);
    for (std::size_t i = 0; i < g.size(); ++i)
        EXPECT_EQ(g[i].veces, veces[i]) << g[i].lugar;
    EXPECT_EQ(g[2].texto, "×9");
    EXPECT_EQ(g[3].texto, "A");
    EXPECT_EQ(g[4].texto, "A ×2");
    EXPECT_EQ(g[5].texto, "f");
}

// Lo que está a d píxeles del centro de una escena de alto útil H está a d·k del centro de una ventana de alto útil kH.
// Lo demás de escala (cuál vale, y desde cuándo), en las partidas de glut_test.cpp.
TEST(Guion, LaEscalaLlevaElRatonALoMismo) {
    const struct {
        const char *guion;
        Talla ventana;
        Punto raton;
    } casos[] = {
        {"escala 240 180; mueve 121 89", {960, 720}, {484, 356}},
        {"escala 240 180; mueve 121 89", {1600, 720}, {804, 356}}, // más ancha: se ve más por los lados
        {"escala 240 180; mueve 121 89", {960, 1080}, {484, 536}}, // más estrecha: por arriba y por abajo
        {"escala 960 720; mueve 482 361", {240, 180}, {121, 90}},  // 120.5 y 90.25, al píxel
        {"escala 1 1; mueve 100000 -100000", {16384, 16384}, {100000, -100000}},
    };
    for (const auto &c : casos) {
        const Punto raton = ratonEn(leeGuion(c.guion).at(0), c.ventana);
        EXPECT_EQ(raton.x, c.raton.x) << c.guion;
        EXPECT_EQ(raton.y, c.raton.y) << c.guion;
    }
}

// Cada error termina con 2 y nombra la orden, su número y lo que se esperaba.
TEST(GuionMal, DiceDondeYQue) {
    std::ofstream(carpetaTemporal() / "prueba.guion")
        << "# un comentario\ntecla a; espera 10\n  # otro\n  gira 3\n";
    const std::string fichero = "@" + (carpetaTemporal() / "prueba.guion").string();
    const struct {
        std::string guion;
        std::string mensaje;
    } casos[] = {
        {"tecla a; teclas b", "guion, orden 2 «teclas b»: «teclas» no es una orden; valen arrastra boton"},
        {fichero, ": " + fichero.substr(1) + ":4 «gira 3»: «gira» no es una orden"},
        {"# tecla a", "«#» no es una orden"}, // solo hay comentarios en un fichero
        {"tecla", "orden 1 «tecla»: falta una tecla"},
        {"tecla ab", "«ab» no es una tecla"},
        {"tecla a b", "sobra «b»"},
        {"especial F13", "«F13» no es una tecla especial"},
        {"boton MEDIO abajo 1 2", "«MEDIO» no es un botón"},
        {"boton IZQUIERDO pulsa 1 2", "«pulsa» no es un movimiento del botón"},
        {"boton IZQUIERDO abajo 1", "falta la y"},
        {"arrastra diez 2", "«diez» no es un número"},
        {"rueda 2 1 1", "«2» no es un giro de la rueda"},
        {"tamano 0 10", "«0» no es un número entre 1 y 16384"},
        {"escala 10 16385", "«16385» no es un número entre 1 y 16384"},
        {"espera -1", "«-1» no es un número entre 0"},
        {"menu", "falta la ruta de la opción"},
        {"captura", "falta el fichero"},
        {"arrastra +1 2", "«[+]1» no es un número"},
        {"tecla d ×", "orden 1 «tecla d ×»: «×» no es ×N"},
        {"tecla d ×0", "«×0» no es ×N"},
        {"tecla d ×10001", "«×10001» no es ×N"},
        {"tecla d ×2 ×3", "sobra «×2»"},
        {"@/no/existe.guion", "-guion: no puedo leer «/no/existe.guion»"},
        {"@/dev", "-guion: «/dev» es una carpeta, no un fichero"},
        {"@/dev/zero", "-guion: «/dev/zero» ocupa más de 256 MiB"},
    };
    for (const auto &c : casos)
        EXPECT_EXIT(leeGuion(c.guion), ExitedWithCode(2), c.mensaje) << c.guion;
}

TEST(Talla, AnchoPorAlto) {
    for (const char *bien : {"240x180", "240x180+10-20"}) { // la posición de X se admite
        EXPECT_EQ(tallaDe(bien, "-geometry").ancho, 240) << bien;
        EXPECT_EQ(tallaDe(bien, "-geometry").alto, 180) << bien;
    }
    for (const char *mal :
         {"", "240", "240x", "x180", "0x10", "240x-5", "axb", "240x180z", "10x10+hola", "10x10+1", "10x10+1+",
          "10x10+1+2+3", "10x10++", "+10x+10", " 10x10", "10x 10", "16385x1", "1x16385"})
        EXPECT_EXIT(tallaDe(mal, "-geometry"), ExitedWithCode(2), "-geometry: ") << mal;
}
