// Comprobaciones independientes de seleccion: el objeto elegido contra el que ve un rayo en doble.
#include "colores.h"
#include "contra_oraculo.h"
#include "guiones.h"
#include "tabla.h"

namespace {

using namespace oraculo;

Mat4 en(double x, double z) {
    return traslada({x, 0, z});
}
const Mat4 CUBO = traslada({0, 0.6, 0}) * gira({0, 1, 0}, 0.4) * escala(1.2),
           BOLA = traslada({0, 0.75, 0}) * escala(0.75),
           CONO = gira({1, 0, 0}, -PI / 2) * escala({0.75, 0.75, 1.7}),
           ARO = traslada({0, 0.84, 0}) * gira({0, 1, 0}, 0.45);
const Malla bola = esfera(64), punta = cono(64), aro = toro(0.6f, 0.24f, 64, 32);

/// El tablero, que no se elige, y los nueve sólidos, por filas desde el fondo.
const std::vector<Cuerpo> CUERPOS = {
    {caja(traslada({0, -0.15, 0}) * escala({6, 0.3, 6})), {0.80, 0.74, 0.66}},
    {malla(en(-2, -2) * CONO, punta), exacto(VERDE)},
    {caja(en(0, -2) * CUBO), exacto(AZUL)},
    {malla(en(2, -2) * ARO, aro), exacto(ROJO)},
    {malla(en(-2, 0) * BOLA, bola), exacto(ROJO)},
    {malla(en(0, 0) * ARO, aro), exacto(VERDE)},
    {malla(en(2, 0) * CONO, punta), exacto(AMARILLO)},
    {caja(en(-2, 2) * CUBO), exacto(NARANJA)},
    {malla(en(0, 2) * ARO, aro), exacto(AZUL)},
    {malla(en(2, 2) * BOLA, bola), exacto(MORADO)}};
const std::string NOMBRES[] = {"nada",       "cono verde",    "cubo azul",    "toro rojo", "esfera roja",
                               "toro verde", "cono amarillo", "cubo naranja", "toro azul", "esfera morada"};
const Escena ESCENA = objetos(CUERPOS);

const double DISTANCIA = 11.5;
Camara camaraA(double distancia, double azimut = 0.25) {
    return perspectiva(orbita(azimut, 0.55, distancia, {-0.45, 0.05, 0}), 0.6, 1, 60);
}
const Camara CAMARA = camaraA(DISTANCIA);

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
    if (elegidos.size() > clics.size()) // antes de ellos, lo que se pulsa para orbitar
        elegidos.erase(elegidos.begin(), elegidos.end() - long(clics.size()));
    return elegidos;
}

/// Un clic en cada píxel, de `paso` en `paso`, elige lo que ve el rayo por su centro. Junto a un borde, OpenGL lleva
/// los vértices a una rejilla de 1/256 de píxel y vale lo que se vea a menos de 1/32. Devuelve cuántos objetos
/// distintos se han elegido.
std::size_t compruebaClics(const glm::ivec2 &talla, int paso, const std::string &antes,
                           const glm::ivec2 &inicial, const Camara &camara = CAMARA) {
    std::vector<glm::ivec2> clics;
    for (int y = 0; y < talla.y; y += paso)
        for (int x = 0; x < talla.x; x += paso)
            clics.push_back({x, y});
    const std::vector<std::string> elegidos = elige(clics, antes, inicial);
    EXPECT_EQ(elegidos.size(), clics.size());
    int dudosos = 0;
    for (std::size_t i = 0; i < std::min(clics.size(), elegidos.size()); ++i) {
        const auto vale = [&](double dx, double dy) {
            const double x = clics[i].x + 0.5 + dx / 32, y = talla.y - (clics[i].y + 0.5 + dy / 32);
            const int objeto = primerImpacto(ESCENA, rayo(camara, talla.x, talla.y, x, y)).objeto;
            return elegidos[i] == NOMBRES[std::max(objeto, 0)]; // el 0, si no se elige ninguno
        };
        if (vale(0, 0))
            continue;
        EXPECT_TRUE(vale(1, 1) || vale(1, -1) || vale(-1, 1) || vale(-1, -1))
            << clics[i].x << "," << clics[i].y << ": " << elegidos[i];
        ++dudosos;
    }
    EXPECT_LE(dudosos, int(clics.size()) / 100);
    return std::set<std::string>(elegidos.begin(), elegidos.end()).size();
}
const std::size_t TODOS = 10; // los nueve y nada

} // namespace

// Cada píxel, linde con lo que linde; de cerca, que hay objetos hasta en el marco de la ventana; y por detrás, donde
// el que se dibuja después no es el que está delante.
TEST(Seleccion, CadaPixelDeBorde) {
    EXPECT_EQ(compruebaClics({48, 36}, 1, "", {48, 36}), TODOS);
    EXPECT_GE(compruebaClics({24, 18}, 1, "rueda +1 10 10 ×20", {24, 18}, camaraA(0.4 * DISTANCIA)), 5u);
    EXPECT_EQ(compruebaClics({48, 36}, 1, arrastra({0, 9}, {60, 9}), {48, 36}, camaraA(DISTANCIA, 0.25 - 3)),
              TODOS);
}

// El framebuffer se rehace: mayor, menor, y de otra forma.
TEST(Seleccion, TrasCambiarDeTamano) {
    EXPECT_EQ(compruebaClics({320, 200}, 12, "tamano 320 200", {100, 60}), TODOS);
    EXPECT_EQ(compruebaClics({90, 150}, 5, "tamano 400 400; tamano 90 150", {90, 150}), TODOS);
}

// Lo elegido conserva su color y lo demás se apaga; con un clic en el fondo todo vuelve a como estaba.
TEST(Seleccion, SeVeCualEs) {
    const struct {
        std::string guion;
        int elegido;
    } casos[] = {{"", 0}, {clic({180, 112}), 9}, {clic({9, 9}), 0}};
    paraCada("seleccion", casos, 240, 180, [](const auto &c, const Vista &v) {
        std::vector<Cuerpo> cuerpos = CUERPOS;
        for (int k = 0; k < 10; ++k)
            if (c.elegido != 0 && c.elegido != k)
                cuerpos[std::size_t(k)].color = 0.3 * CUERPOS[std::size_t(k)].color + 0.7 * CUERPOS[0].color;
        comprueba("lo elegido", comparaConLuzFija(v.escena, cuerpos, CAMARA, exacto(CIELO)));
    });
}

// Otro botón no elige, soltar tampoco, y un clic fuera de la ventana no es nada.
TEST(Seleccion, SoloElBotonIzquierdo) {
    EXPECT_EQ(ejecuta("seleccion", clic({180, 112}, "DERECHO")).salida, "");
    EXPECT_EQ(elige({{-5, -5}}, "", {240, 180}), std::vector<std::string>{"nada"});
    EXPECT_EQ(ejecuta("seleccion", arrastra({180, 112}, {20, 20})).salida,
              "(180, 112) color 221 223 249 → objeto 9: esfera morada\n"); // al pulsar, no al soltar
}
