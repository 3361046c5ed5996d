// Lo que dibuja normales. La matriz que las transforma (§3.3), sola, está en dificil_transformaciones_test.cpp.
#include "colores.h"
#include "guiones.h"
#include "panel.h"
#include "tabla.h"

namespace {

using namespace oraculo;

const Vec3 COLOR{0.72, 0.82, 0.97};

struct CasoNormales {
    std::string guion;
    double sx, sy, azimut = 0.16, elevacion = 0.32;
    bool gira = false, sinNormalizar = false, tangentes = false, alReves = false;
};

/// El prisma transformado, sin ninguna matriz de normales, y las flechas de cada color.
struct Prisma {
    std::vector<VerticeRef> vertices;
    std::vector<Triangulos::Indices> caras = {{0, 2, 4}, {0, 4, 6}, {1, 3, 5}, {1, 5, 7}};
    std::vector<Linea> deN, deM, deLaAdjunta, delLado, unitarias;
    Vec3 sitio;

    explicit Prisma(const CasoNormales &c) : sitio(c.gira ? Vec3{0.5, 0.2, 0} : Vec3{}) {
        for (std::size_t i = 0; i < 4; ++i)
            pon(c, i);
    }

private:
    void pon(const CasoNormales &c, std::size_t i) {
        const double esquinas[][2] = {
            {0.25, -0.95}, {0.85, 0.15}, {-0.10, 0.90}, {-0.90, -0.20}}; // antihorario
        const auto &[ax, ay] = esquinas[i];
        const auto &[bx, by] = esquinas[(i + 1) % 4];
        const Mat4 giro = c.gira ? gira({0, 0, 1}, PI / 6) : Mat4();
        const Vec3 a = direccion(giro, {c.sx * ax, c.sy * ay, 0.45}) + sitio,
                   b = direccion(giro, {c.sx * bx, c.sy * by, 0.45}) + sitio, medio = 0.5 * (a + b),
                   adjunta = vectorial(b - a, {0, 0, 1}), n = unitario(Vec3{by - ay, ax - bx, 0}),
                   haciaFuera = escalar(adjunta, medio - sitio) < 0 ? -adjunta : adjunta,
                   delante{0, 0, 0.018};
        vertices.insert(vertices.end(), {{a, {0, 0, 1}}, {a - Vec3{0, 0, 0.9}, {0, 0, 1}}});
        const std::size_t k = 2 * i, otro = (k + 2) % 8;
        caras.insert(caras.end(), {{k, otro, otro + 1}, {k, otro + 1, k + 1}});
        const auto flecha = [&, pie = medio + delante](const Vec3 &hacia, double largo = 0.75) {
            return Linea{pie, pie + (c.alReves ? -0.5 : 1) * largo * unitario(hacia)};
        };
        if (c.tangentes)
            delLado.push_back({a + delante, b + delante});
        if (c.sinNormalizar) { // N es la inversa traspuesta: con S(±2, 1, 1), la x a la mitad
            deN.push_back(flecha(haciaFuera, 0.75 * std::hypot(n.x / 2, n.y)));
            unitarias.push_back(flecha(haciaFuera));
            return;
        }
        deN.push_back(flecha(haciaFuera));
        const Linea roja = flecha({c.sx * (by - ay), c.sy * (ax - bx), 0});
        const auto enRoja = [&](double t) { return roja[0] + t * (roja[1] - roja[0]); };
        for (int trazo = 0; c.sx != 1 && trazo < 4; ++trazo) // de quinto en quinto, y la punta
            deM.push_back({enRoja(0.2 * trazo), enRoja(trazo < 3 ? 0.2 * trazo + 0.1 : 1)});
        if (c.sx < 0)
            deLaAdjunta.push_back(flecha(adjunta, c.alReves ? 0.75 : 0.375));
    }
};

// El prisma en cada píxel: la normal de cada cara, ya transformada, mira hacia fuera del centro. Y en cada lado sus
// flechas, de largo 0.75 y, hacia dentro, la mitad: verde, la perpendicular; roja y a trazos, la del lado original con
// su x y su y escaladas; y naranja la de la adjunta del libro, el producto vectorial tal cual. Azul, el propio lado; y,
// sin normalizar, gris la unitaria y verde lo que mide con la inversa traspuesta.
TEST(ProgramaNormales, CadaCasoContraElOraculo) {
    const CasoNormales casos[] = {
        {"", 1, 1},
        {"tecla 2", 2, 1},
        {"tecla 3; tamano 150 200", -2, 1},
        {"tecla 4", 2, 0},
        {"tecla o", 2, 0, 0.16, 0.32, false, false, false, true},
        {"tecla 2; tecla n", 2, 1, 0.16, 0.32, false, true, false, true},
        {"tecla 3; tecla t; tecla o", -2, 1, 0.16, 0.32, false, true, true},
        {"tecla n; tecla 5", 1, 1, 0.16, 0.32, true, false, true},
        {"tecla t; tecla 1; tecla 6; tamano 240 180; " + arrastra({0, 100}, {200, 100}), 1, 1, 0.16 - 2},
        {"tecla 2; " + arrastra({100, 100}, {130, 120}), 2, 1, 0.16 - 2.3, 0.52}};
    paraCada("normales", casos, 240, 180, [&](const CasoNormales &caso, const Vista &v) {
        const Panel panel(paralela(orbita(caso.azimut, caso.elevacion, 8), 1.75, 1, 20), v.escena);
        const Prisma prisma(caso);
        const Vec3 centro = prisma.sitio - Vec3{0, caso.sy == 0 ? 1.0 : 0, 0}; // aplastado, se ve por arriba
        const auto sombrea = [&](const Impacto &i) {
            const bool dentro = escalar(i.normalCara, i.punto - centro) < 0;
            return i ? Tono(luzFija(dentro ? -i.normalCara : i.normalCara) * COLOR, i.corte.triangulo / 2)
                     : Tono(exacto(FONDO_CLARO));
        };
        comprueba("el prisma",
                  compara(v.escena, {malla(Mat4(), prisma.vertices, prisma.caras)}, panel.camara, sombrea),
                  EXACTA);
        compruebaTrazos(v.encima, panel, prisma.deN, VERDE);
        compruebaTrazos(v.encima, panel, prisma.deM, ROJO);
        compruebaTrazos(v.encima, panel, prisma.deLaAdjunta, NARANJA);
        compruebaTrazos(v.encima, panel, prisma.delLado, AZUL);
        compruebaTrazos(v.encima, panel, prisma.unitarias, GRIS);
    });
}

} // namespace
