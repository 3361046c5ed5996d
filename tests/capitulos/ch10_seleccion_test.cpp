// Comprobaciones independientes de seleccion: el objeto elegido contra el que ve un rayo en doble, y los identificadores.
#include "ch10_interaccion/identificador.h"
#include "colores.h"
#include "contra_oraculo.h"
#include "guiones.h"
#include <gtest/gtest.h>
#include <iostream>
#include <set>
#include <sstream>

namespace {

using namespace oraculo;

Objeto tablero(const Mat4 &lugar) {
    return caja(lugar * traslada({0, -0.15, 0}) * escala({6, 0.3, 6}));
}
Objeto cubo(const Mat4 &lugar) {
    return caja(lugar * traslada({0, 0.6, 0}) * gira({0, 1, 0}, 0.4) * escala(1.2));
}
Objeto bola(const Mat4 &lugar) {
    return malla(lugar * traslada({0, 0.75, 0}) * escala(0.75), esfera(64));
}
Objeto punta(const Mat4 &lugar) {
    return malla(lugar * gira({1, 0, 0}, -PI / 2) * escala({0.75, 0.75, 1.7}), cono(64));
}
Objeto aro(const Mat4 &lugar) {
    return malla(lugar * traslada({0, 0.84, 0}) * gira({0, 1, 0}, 0.45), toro(0.6f, 0.24f, 64, 32));
}

/// El tablero, que no se elige, y los nueve sólidos, por filas desde el fondo.
const struct {
    std::string nombre;
    glm::vec3 color;
    Objeto (*en)(const Mat4 &lugar);
} SOLIDOS[] = {{"nada", {0.80f, 0.74f, 0.66f}, tablero},
               {"cono verde", VERDE, punta},
               {"cubo azul", AZUL, cubo},
               {"toro rojo", ROJO, aro},
               {"esfera roja", ROJO, bola},
               {"toro verde", VERDE, aro},
               {"cono amarillo", AMARILLO, punta},
               {"cubo naranja", NARANJA, cubo},
               {"toro azul", AZUL, aro},
               {"esfera morada", MORADO, bola}};
Escena creaEscena() {
    Escena e = {tablero(Mat4())};
    for (int i = 0; i < 9; ++i)
        e.push_back(SOLIDOS[i + 1].en(traslada({-2.0 + 2 * (i % 3), 0, -2.0 + 2 * (i / 3)})));
    return e;
}
const Escena ESCENA = creaEscena();

const double DISTANCIA = 11.5;
Camara camaraA(double distancia) {
    return perspectiva(orbita(0.25, 0.55, distancia, {-0.45, 0.05, 0}), 0.6, 1, 60);
}
const Camara CAMARA = camaraA(DISTANCIA);

/// El que se ve en ese punto; 0, si no se elige ninguno. La y, desde arriba, como en GLUT.
int objetoEn(const glm::ivec2 &talla, double x, double y, const Camara &camara = CAMARA) {
    return std::max(primerImpacto(ESCENA, rayo(camara, talla.x, talla.y, x, talla.y - y)).objeto, 0);
}

/// Lo que el programa dice haber elegido en cada clic.
std::vector<std::string> elige(const std::vector<glm::ivec2> &clics, std::string guion,
                               const glm::ivec2 &talla) {
    for (const glm::ivec2 &c : clics)
        guion += "; " + clic(c);
    const Ejecucion e = ejecuta("seleccion", guion, talla.x, talla.y);
    EXPECT_EQ(e.estado, 0) << e.errores;
    std::vector<std::string> elegidos;
    std::istringstream salida(e.salida);
    for (std::string linea; std::getline(salida, linea);)
        elegidos.push_back(linea.substr(linea.rfind(": ") + 2));
    return elegidos;
}

/// Cada clic elige lo que ve el rayo por el centro de su píxel. Junto a un borde, OpenGL lleva los vértices a una rejilla de
/// 1/256 de píxel y vale lo que se vea a menos de 1/32. Devuelve cuántos objetos distintos se han elegido.
std::size_t compruebaClics(const std::vector<glm::ivec2> &clics, const std::string &antes,
                           const glm::ivec2 &talla, const glm::ivec2 &inicial,
                           const Camara &camara = CAMARA) {
    const std::vector<std::string> elegidos = elige(clics, antes, inicial);
    EXPECT_EQ(elegidos.size(), clics.size());
    std::set<std::string> vistos;
    int dudosos = 0;
    for (std::size_t i = 0; i < std::min(clics.size(), elegidos.size()); ++i) {
        std::set<std::string> valen;
        for (const auto &[dx, dy] : {Vec2{0, 0}, Vec2{1, 1}, Vec2{1, -1}, Vec2{-1, 1}, Vec2{-1, -1}})
            valen.insert(
                SOLIDOS[objetoEn(talla, clics[i].x + 0.5 + dx / 32, clics[i].y + 0.5 + dy / 32, camara)]
                    .nombre);
        EXPECT_TRUE(valen.count(elegidos[i])) << clics[i].x << "," << clics[i].y << ": " << elegidos[i];
        dudosos += valen.size() > 1;
        vistos.insert(elegidos[i]);
    }
    std::cout << clics.size() << " clics, " << vistos.size() << " elegidos distintos, " << dudosos
              << " dudosos\n";
    EXPECT_LT(dudosos, int(clics.size()) / 6);
    return vistos.size();
}
const std::size_t TODOS = 10; // los nueve y nada

/// Los píxeles de la ventana que cumplen eso.
template<class Condicion>
std::vector<glm::ivec2> pixeles(const glm::ivec2 &talla, Condicion condicion) {
    std::vector<glm::ivec2> clics;
    for (int y = 0; y < talla.y; ++y)
        for (int x = 0; x < talla.x; ++x)
            if (condicion(x, y))
                clics.push_back({x, y});
    return clics;
}
std::vector<glm::ivec2> rejilla(const glm::ivec2 &talla, int paso) {
    return pixeles(talla, [=](int x, int y) { return x % paso == 0 && y % paso == 0; });
}

} // namespace

TEST(Identificador, LosBitsPorTurno) {
    EXPECT_EQ(rgbDe(0), (Rgb{0, 0, 0}));
    EXPECT_EQ(rgbDe((1u << 24) - 1), (Rgb{255, 255, 255}));
    EXPECT_EQ(rgbDe(1), (Rgb{128, 0, 0}));
    EXPECT_EQ(rgbDe(12), (Rgb{64, 0, 128})); // 1100: el bit 2 al azul y el 3 al rojo
    EXPECT_EQ(rgbDe(256), (Rgb{0, 0, 32}));  // el bit 8, el tercero del azul
}

// Los 2²⁴ van y vuelven: ninguno repite color. Y lo que la GPU guarda del color (255·c redondeado) es el byte.
TEST(Identificador, TodosSonDistintos) {
    for (unsigned id = 0; id < 1u << 24; ++id) {
        const Rgb c = rgbDe(id);
        ASSERT_EQ(identificadorDe(c), id);
        for (int k = 0; k < 3 && id % 257 == 0; ++k)
            ASSERT_EQ(std::lround(255 * double(colorDe(id)[k])), c[std::size_t(k)]);
    }
}

TEST(IdentificadorDeathTest, ElQueNoCabe) {
    EXPECT_EXIT(rgbDe(1u << 24), testing::ExitedWithCode(1), "no cabe en 24 bits");
}

TEST(Seleccion, UnaRejillaDeClicsContraRayos) {
    EXPECT_EQ(compruebaClics(rejilla({240, 180}, 10), "", {240, 180}, {240, 180}), TODOS);
}

// Cada píxel que linda con uno de otro objeto, por los cuatro lados.
TEST(Seleccion, CadaPixelDeBorde) {
    const glm::ivec2 talla(80, 60);
    const auto en = [&](int x, int y) { return objetoEn(talla, x + 0.5, y + 0.5); };
    const std::vector<glm::ivec2> borde = pixeles(talla, [&](int x, int y) {
        return x > 0 && y > 0 && x < 79 && y < 59 &&
               (en(x, y) != en(x - 1, y) || en(x, y) != en(x + 1, y) || en(x, y) != en(x, y - 1) ||
                en(x, y) != en(x, y + 1));
    });
    EXPECT_GT(borde.size(), 400u);
    EXPECT_EQ(compruebaClics(borde, "", talla, talla), TODOS);
}

// De cerca hay objetos hasta en el marco de la ventana: la primera y la última fila y columna.
TEST(Seleccion, CadaPixelDelMarcoDeLaVentana) {
    const std::vector<glm::ivec2> marco =
        pixeles({80, 60}, [](int x, int y) { return x == 0 || y == 0 || x == 79 || y == 59; });
    EXPECT_GE(compruebaClics(marco, "rueda +1 40 30 ×20", {80, 60}, {80, 60}, camaraA(0.4 * DISTANCIA)), 5u);
}

// El framebuffer se rehace: mayor, menor, y de otra forma.
TEST(Seleccion, TrasCambiarDeTamano) {
    EXPECT_EQ(compruebaClics(rejilla({320, 200}, 12), "tamano 320 200", {320, 200}, {100, 60}), TODOS);
    EXPECT_EQ(compruebaClics(rejilla({90, 150}, 5), "tamano 400 400; tamano 90 150", {90, 150}, {90, 150}),
              TODOS);
}

// Lo elegido conserva su color y lo demás se apaga; con un clic en el fondo todo vuelve a como estaba.
TEST(Seleccion, SeVeCualEs) {
    const std::vector<Vista> v = vistasDe("seleccion", {"", clic({180, 112}), clic({9, 9})});
    const int elegidos[] = {0, 9, 0};
    for (std::size_t i = 0; i < 3; ++i) {
        std::vector<Cuerpo> cuerpos;
        for (int k = 0; k < 10; ++k) {
            const bool apagado = elegidos[i] != 0 && elegidos[i] != k;
            cuerpos.push_back({ESCENA[std::size_t(k)],
                               exacto(glm::mix(SOLIDOS[k].color, SOLIDOS[0].color, apagado ? 0.7f : 0.0f))});
        }
        comprueba("elegido " + std::to_string(elegidos[i]),
                  comparaConLuzFija(v[i].escena, cuerpos, CAMARA, exacto(CIELO)));
    }
    compruebaRotulo(v[0].encima, "clic en un objeto", {120, 0.06 * 180}, OSCURO, Lado::CENTRO);
    compruebaRotulo(v[1].encima, "color 192 0 0 → objeto 9", {120, 0.06 * 180}, OSCURO, Lado::CENTRO);
    compruebaRotulo(v[2].encima, "color 0 0 0 → objeto 0", {120, 0.06 * 180}, OSCURO, Lado::CENTRO);
    compruebaRotulo(v[1].encima, "esfera morada", enPixeles(CAMARA, {2, 1.6, 2}), OSCURO, Lado::ENCIMA);
    EXPECT_EQ(v[0].encima.size(), 1u);
    EXPECT_EQ(v[2].encima.size(), 1u);
    std::vector<glm::dvec2> aro;
    for (int k = 0; k <= 64; ++k)
        aro.push_back(
            enPixeles(CAMARA, {2 + 0.98 * std::cos(k * PI / 32), 0.02, 2 + 0.98 * std::sin(k * PI / 32)}));
    compruebaTrazo(v[1].encima, aro, OSCURO);
    EXPECT_TRUE(v[1].encima.trazos(OSCURO).at(0).conProfundidad);
}

// Con el framebuffer a la vista se elige igual, y cada píxel es del color que dice qué objeto se ve en él.
TEST(Seleccion, ElFramebufferALaVista) {
    const Vec3 colores[] = {{0, 0, 0},     {128, 0, 0},   {0, 128, 0},     {128, 128, 0}, {0, 0, 128},
                            {128, 0, 128}, {0, 128, 128}, {128, 128, 128}, {64, 0, 0},    {192, 0, 0}};
    const std::vector<Vista> v =
        vistasDe("seleccion", {"tecla v", clic({100, 100}), clic({9, 9}) + "; tecla v"});
    comprueba("identificadores", compara(v[0].escena, ESCENA, CAMARA, [&](const Impacto &i) {
                  return 1 / 255.0 * colores[std::max(i.objeto, 0)];
              }));
    EXPECT_EQ(v[1].escena.rgb, v[0].escena.rgb);
    compruebaRotulo(v[1].encima, "color 64 0 0 → objeto 8", {120, 0.06 * 180}, BLANCO, Lado::CENTRO);
    compruebaRotulo(v[1].encima, "toro azul", enPixeles(CAMARA, {0, 1.78, 2}), BLANCO, Lado::ENCIMA);
    EXPECT_EQ(v[2].escena.rgb, vistaDe("seleccion").escena.rgb);
    for (const std::string antes : {"", "tecla v; "})
        EXPECT_EQ(ejecuta("seleccion", antes + clic({100, 100})).salida,
                  "(100, 100) color 64 0 0 → objeto 8: toro azul\n");
}

// Otro botón no elige, soltar tampoco, y un clic fuera de la ventana no es nada.
TEST(Seleccion, SoloElBotonIzquierdo) {
    EXPECT_EQ(ejecuta("seleccion", clic({180, 112}, "DERECHO")).salida, "");
    EXPECT_EQ(elige({{-5, -5}}, "", {240, 180}), std::vector<std::string>{"nada"});
    EXPECT_EQ(ejecuta("seleccion", arrastra({180, 112}, {20, 20})).salida,
              "(180, 112) color 192 0 0 → objeto 9: esfera morada\n"); // al pulsar, no al soltar
}
