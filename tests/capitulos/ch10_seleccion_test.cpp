// Comprobaciones independientes de seleccion: el objeto elegido contra el que ve un rayo en doble, y los identificadores.
#include "ch10_interaccion/identificador.h"
#include "colores.h"
#include "ejecuta.h"
#include "encima.h"
#include "malla.h"
#include "oraculo/oraculo.h"
#include <fstream>
#include <gtest/gtest.h>
#include <iostream>
#include <set>
#include <sstream>

namespace {

using namespace oraculo;

const char *const NOMBRES[] = {"nada",       "cono verde",    "cubo azul",    "toro rojo", "esfera roja",
                               "toro verde", "cono amarillo", "cubo naranja", "toro azul", "esfera morada"};

/// El tablero y los nueve sólidos, por filas desde el fondo: el objeto 0 es el tablero, que no se elige.
Escena escena() {
    const Malla bola = esfera(64), punta = cono(64), aro = toro(0.6f, 0.24f, 64, 32);
    Escena e = {caja(traslada({0, -0.15, 0}) * escala({6, 0.3, 6}))};
    for (int i = 0; i < 9; ++i) {
        const Mat4 lugar = traslada({-2.0 + 2 * (i % 3), 0, -2.0 + 2 * (i / 3)});
        const std::string forma(NOMBRES[i + 1]);
        if (forma.find("cubo") == 0)
            e.push_back(caja(lugar * traslada({0, 0.6, 0}) * gira({0, 1, 0}, 0.4) * escala(1.2)));
        else if (forma.find("esfera") == 0)
            e.push_back(malla(lugar * traslada({0, 0.75, 0}) * escala(0.75), bola));
        else if (forma.find("cono") == 0)
            e.push_back(malla(lugar * gira({1, 0, 0}, -PI / 2) * escala({0.75, 0.75, 1.7}), punta));
        else
            e.push_back(malla(lugar * traslada({0, 0.84, 0}) * gira({0, 1, 0}, 0.45), aro));
    }
    return e;
}

const double DISTANCIA = 11.5;
Camara camaraA(double distancia) {
    return perspectiva(orbita(0.25, 0.55, distancia, {-0.45, 0.05, 0}), 0.6, 1, 60);
}
const Camara CAMARA = camaraA(DISTANCIA);

int objetoEn(const Escena &e, int ancho, int alto, double px, double py, const Camara &camara = CAMARA) {
    return std::max(primerImpacto(e, rayo(camara, ancho, alto, px, py)).objeto, 0);
}

struct Clic {
    int x, y; // y desde arriba, como en GLUT
};

/// Lo que el programa dice haber elegido en cada clic.
std::vector<std::string> elige(const std::vector<Clic> &clics, const std::string &antes, int ancho,
                               int alto) {
    const std::string fichero = (carpetaTemporal() / "clics").string();
    std::ofstream guion(fichero);
    guion << antes << "\n";
    for (const Clic &c : clics)
        guion << "boton IZQUIERDO abajo " << c.x << " " << c.y << "; boton IZQUIERDO arriba " << c.x << " "
              << c.y << "\n";
    guion.close();
    const Ejecucion e = ejecuta("ch10_interaccion/seleccion", "@" + fichero, ancho, alto);
    EXPECT_EQ(e.estado, 0) << e.errores;
    std::vector<std::string> elegidos;
    std::istringstream salida(e.salida);
    for (std::string linea; std::getline(salida, linea);)
        elegidos.push_back(linea.substr(linea.rfind(": ") + 2));
    return elegidos;
}

/// Cada clic elige lo que ve el rayo por el centro de su píxel. Junto a un borde, OpenGL lleva los vértices a una rejilla de
/// 1/256 de píxel y vale lo que se vea a menos de 1/32. Devuelve cuántos objetos distintos se han elegido.
std::size_t comprueba(const std::vector<Clic> &clics, const std::string &antes, int ancho, int alto,
                      int anchoInicial, int altoInicial, const Camara &camara = CAMARA) {
    const Escena e = escena();
    const std::vector<std::string> elegidos = elige(clics, antes, anchoInicial, altoInicial);
    EXPECT_EQ(elegidos.size(), clics.size());
    if (elegidos.size() != clics.size())
        return 0;
    std::set<std::string> vistos;
    int dudosos = 0;
    for (std::size_t i = 0; i < clics.size(); ++i) {
        std::set<std::string> valen;
        for (const auto &[dx, dy] : {Vec2{0, 0}, Vec2{1, 1}, Vec2{1, -1}, Vec2{-1, 1}, Vec2{-1, -1}})
            valen.insert(NOMBRES[objetoEn(e, ancho, alto, clics[i].x + 0.5 + dx / 32,
                                          alto - 1 - clics[i].y + 0.5 + dy / 32, camara)]);
        EXPECT_TRUE(valen.count(elegidos[i])) << clics[i].x << "," << clics[i].y << ": " << elegidos[i];
        dudosos += valen.size() > 1;
        vistos.insert(elegidos[i]);
    }
    std::cout << clics.size() << " clics, " << vistos.size() << " elegidos distintos, " << dudosos
              << " dudosos\n";
    EXPECT_LT(dudosos, static_cast<int>(clics.size()) / 6);
    return vistos.size();
}
const std::size_t TODOS = 10; // los nueve y nada

std::vector<Clic> rejilla(int ancho, int alto, int paso) {
    std::vector<Clic> clics;
    for (int y = 0; y < alto; y += paso)
        for (int x = 0; x < ancho; x += paso)
            clics.push_back({x, y});
    return clics;
}

} // namespace

// Los casos en que una cuenta de bytes se equivoca.
TEST(Identificador, IdaYVuelta) {
    for (const unsigned id : {0u, 1u, 255u, 256u, 65535u, 65536u, (1u << 24) - 1})
        EXPECT_EQ(identificadorDe(rgbDe(id)), id);
    EXPECT_EQ(rgbDe(0), (Rgb{0, 0, 0}));
    EXPECT_EQ(rgbDe((1u << 24) - 1), (Rgb{255, 255, 255}));
    EXPECT_EQ(rgbDe(1), (Rgb{128, 0, 0}));
    EXPECT_EQ(rgbDe(12), (Rgb{64, 0, 128})); // 1100: el bit 2 al azul y el 3 al rojo
    EXPECT_EQ(rgbDe(256), (Rgb{0, 0, 32}));  // el bit 8, el tercero del azul
}

// Los 2²⁴: ninguno repite color, y lo que la GPU guarda del color (255·c redondeado) es el byte.
TEST(Identificador, TodosSonDistintos) {
    std::vector<bool> visto(1u << 24);
    for (unsigned id = 0; id < 1u << 24; ++id) {
        const Rgb c = rgbDe(id);
        const unsigned n = c[0] | c[1] << 8 | c[2] << 16;
        ASSERT_FALSE(visto[n]) << id;
        visto[n] = true;
        if (id % 257 == 0) {
            ASSERT_EQ(identificadorDe(c), id);
            for (int k = 0; k < 3; ++k)
                ASSERT_EQ(std::lround(255 * static_cast<double>(colorDe(id)[k])),
                          c[static_cast<std::size_t>(k)]);
        }
    }
}

TEST(IdentificadorDeathTest, ElQueNoCabe) {
    EXPECT_EXIT(rgbDe(1u << 24), testing::ExitedWithCode(1), "no cabe en 24 bits");
}

TEST(Seleccion, UnaRejillaDeClicsContraRayos) {
    EXPECT_EQ(comprueba(rejilla(240, 180, 10), "", 240, 180, 240, 180), TODOS);
}

// Cada píxel que linda con uno de otro objeto, por los cuatro lados.
TEST(Seleccion, CadaPixelDeBorde) {
    const int ancho = 80, alto = 60;
    const Escena e = escena();
    std::vector<int> objeto;
    for (int y = 0; y < alto; ++y)
        for (int x = 0; x < ancho; ++x)
            objeto.push_back(objetoEn(e, ancho, alto, x + 0.5, alto - 1 - y + 0.5));
    std::vector<Clic> borde;
    for (int y = 1; y < alto - 1; ++y)
        for (int x = 1; x < ancho - 1; ++x) {
            const auto en = [&](int i, int j) { return objeto[static_cast<std::size_t>(j * ancho + i)]; };
            if (en(x, y) != en(x - 1, y) || en(x, y) != en(x + 1, y) || en(x, y) != en(x, y - 1) ||
                en(x, y) != en(x, y + 1))
                borde.push_back({x, y});
        }
    EXPECT_GT(borde.size(), 400u);
    EXPECT_EQ(comprueba(borde, "", ancho, alto, ancho, alto), TODOS);
}

// De cerca hay objetos hasta en el marco de la ventana: la primera y la última fila y columna.
TEST(Seleccion, CadaPixelDelMarcoDeLaVentana) {
    const int ancho = 80, alto = 60;
    std::string acerca;
    for (int i = 0; i < 20; ++i)
        acerca += "rueda +1 40 30; ";
    std::vector<Clic> marco;
    for (int y = 0; y < alto; ++y)
        for (int x = 0; x < ancho; x += y == 0 || y == alto - 1 ? 1 : ancho - 1)
            marco.push_back({x, y});
    EXPECT_GE(comprueba(marco, acerca, ancho, alto, ancho, alto, camaraA(0.4 * DISTANCIA)), 5u);
}

// El framebuffer se rehace: mayor, menor, y de otra forma.
TEST(Seleccion, TrasCambiarDeTamano) {
    EXPECT_EQ(comprueba(rejilla(320, 200, 12), "tamano 320 200", 320, 200, 100, 60), TODOS);
    EXPECT_EQ(comprueba(rejilla(90, 150, 5), "tamano 400 400; tamano 90 150", 90, 150, 90, 150), TODOS);
}

// Lo elegido conserva su color y lo demás se apaga; con un clic en el fondo todo vuelve a como estaba.
TEST(Seleccion, SeVeCualEs) {
    const std::string clic = "boton IZQUIERDO abajo 180 112; boton IZQUIERDO arriba 180 112";
    const Imagen sin = ejecuta("ch10_interaccion/seleccion").imagen,
                 con = ejecuta("ch10_interaccion/seleccion", clic).imagen;
    const Escena e = escena();
    int iguales = 0, apagados = 0, mal = 0;
    for (int y = 20; y < 180; ++y) // encima del rótulo
        for (int x = 0; x < 240; ++x) {
            const int i = objetoEn(e, 240, 180, x + 0.5, y + 0.5);
            const Pixel a = pixel(sin, x, y), b = pixel(con, x, y);
            const bool igual = a.r == b.r && a.g == b.g && a.b == b.b;
            if (i == 9)
                (igual ? iguales : mal)++;
            else if (i > 0)
                (igual ? mal : apagados)++;
        }
    EXPECT_GT(iguales, 500);
    EXPECT_GT(apagados, 4000);
    EXPECT_LT(mal, 120);                                       // los bordes, el aro y el rótulo
    const Vec3 cima = proyecta(CAMARA, 240, 180, {2, 1.5, 2}); // de la esfera, con su nombre encima
    EXPECT_TRUE(seLee(con, "esfera morada", OSCURO, cima.x, cima.y + 9, 8));
    EXPECT_TRUE(seLee(con, "color 192 0 0 → objeto 9", OSCURO, 120, 11, 4));
    EXPECT_TRUE(seLee(sin, "clic en un objeto", OSCURO, 120, 11, 4));
    int puntos = 0, vistos = 0; // de la mitad del aro que queda delante
    for (double a = 0.1; a < 3; a += 0.05, ++puntos) {
        const Vec3 p = proyecta(CAMARA, 240, 180, {2 + 0.98 * std::cos(a), 0.02, 2 + 0.98 * std::sin(a)});
        const int x = static_cast<int>(p.x), y = static_cast<int>(p.y);
        bool visto = false;
        for (int k = 0; k < 9; ++k)
            visto = visto || esColor(con, x - 1 + k % 3, y - 1 + k / 3, OSCURO);
        vistos += visto;
    }
    EXPECT_EQ(vistos, puntos);
    const Imagen fondo = ejecuta("ch10_interaccion/seleccion",
                                 clic + "; boton IZQUIERDO abajo 9 9; boton IZQUIERDO arriba 9 9")
                             .imagen;
    for (int y = 20; y < 180; ++y)
        for (int x = 0; x < 240; ++x)
            ASSERT_EQ(pixel(sin, x, y).r, pixel(fondo, x, y).r);
}

// Con el framebuffer a la vista se elige igual, y cada píxel es del color que dice qué objeto se ve en él.
TEST(Seleccion, ElFramebufferALaVista) {
    const std::string clic = "boton IZQUIERDO abajo 100 100; boton IZQUIERDO arriba 100 100";
    const int colores[][3] = {{0, 0, 0},     {128, 0, 0},   {0, 128, 0},     {128, 128, 0}, {0, 0, 128},
                              {128, 0, 128}, {0, 128, 128}, {128, 128, 128}, {64, 0, 0},    {192, 0, 0}};
    const Imagen imagen = ejecuta("ch10_interaccion/seleccion", "tecla v").imagen;
    const Escena e = escena();
    int mal = 0;
    for (int y = 20; y < 180; ++y) // encima del rótulo
        for (int x = 0; x < 240; ++x) {
            const int *c = colores[objetoEn(e, 240, 180, x + 0.5, y + 0.5)];
            const Pixel p = pixel(imagen, x, y);
            mal += p.r != c[0] || p.g != c[1] || p.b != c[2];
        }
    EXPECT_LT(mal, 20); // los dudosos
    const Ejecucion elegido = ejecuta("ch10_interaccion/seleccion", "tecla v; " + clic);
    EXPECT_EQ(elegido.salida, "(100, 100) color 64 0 0 → objeto 8: toro azul\n");
    EXPECT_EQ(elegido.salida, ejecuta("ch10_interaccion/seleccion", clic).salida);
    EXPECT_TRUE(seLee(elegido.imagen, "color 64 0 0 → objeto 8", BLANCO, 120, 11, 4));
    EXPECT_EQ(ejecuta("ch10_interaccion/seleccion", "tecla v; tecla v").imagen.rgb,
              ejecuta("ch10_interaccion/seleccion").imagen.rgb);
}

// Otro botón no elige, soltar tampoco, y un clic fuera de la ventana no es nada.
TEST(Seleccion, SoloElBotonIzquierdo) {
    EXPECT_EQ(
        ejecuta("ch10_interaccion/seleccion", "boton DERECHO abajo 180 112; boton DERECHO arriba 180 112")
            .salida,
        "");
    EXPECT_EQ(elige({{-5, -5}}, "", 240, 180), std::vector<std::string>{"nada"});
    EXPECT_EQ(ejecuta("ch10_interaccion/seleccion",
                      "boton IZQUIERDO abajo 180 112; arrastra 20 20; boton IZQUIERDO arriba 20 20")
                  .salida,
              "(180, 112) color 192 0 0 → objeto 9: esfera morada\n"); // al pulsar, no al soltar
}
