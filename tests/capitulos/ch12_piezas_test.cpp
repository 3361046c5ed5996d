// Comprobaciones independientes de las partículas del capítulo 12: la imagen entera, con cada una donde se calcula
// aquí, en doble precisión, y del color que debe.
#include "ch12_instante.h"
#include "ch12_ruido.h"
#include "colores.h"
#include "panel.h"
#include "plana.h"

using namespace oraculo;

namespace {

const int ANCHO = 960, ALTO = 720;

double azarDe(std::uint32_t n) {
    n = (n ^ (n >> 16)) * 0x7feb352du;
    n = (n ^ (n >> 15)) * 0x846ca68bu;
    n ^= n >> 16;
    return (n >> 8) / 16777216.0;
}
double parteDecimal(double x) {
    return x - std::floor(x);
}

// --- Partículas ---

enum Modo { FUENTE, HUMO, FUEGO };
const double VIDAS[] = {3, 4, 1.5}; // segundos
const std::uint32_t GRUPOS[] = {13, 60, 7};
const Camara CAMARA = perspectiva(orbita(0.4, 0.12, 12, {0, 1.95, 0}), 0.55, 0.5, 50);

struct Particula {
    Vec3 P;
    double diametro;
    Vec3 color;
    double alfa;
};
/// La partícula `id` en el segundo t. Las de una bocanada de humo nacen juntas.
Particula particula(int modo, std::uint32_t id, double t) {
    const std::uint32_t semilla = 4 * id + 0x9e3779b9u, grupo = id % GRUPOS[modo];
    const double a = azarDe(semilla), b = azarDe(semilla + 1), c = azarDe(semilla + 2),
                 tau = parteDecimal(t / VIDAS[modo]),
                 edad = parteDecimal(tau + azarDe(modo == HUMO ? grupo : id)), s = edad * VIDAS[modo];
    const auto seno = [](double vueltas) { return std::sin(2 * PI * vueltas); };
    const auto coseno = [](double vueltas) { return std::cos(2 * PI * vueltas); };
    if (modo == FUENTE) { // v·t + g·t²/2, con g = 5; doce chorros alrededor de uno más alto
        const bool alto = grupo % 2 == 0;
        const double sale = grupo ? (alto ? 0.60 : 1.05) + 0.14 * b : 0.30 * std::sqrt(b) * (1 - c),
                     u = grupo ? (grupo + 0.16 * a) / 12 : a,
                     v = grupo ? (alto ? 4.9 : 3.7) + 0.35 * c : 5.6 + 1.0 * c;
        return {{sale * coseno(u) * s, v * s - 5 * s * s / 2, sale * seno(u) * s},
                0.07,
                mezcla({0.20, 0.50, 0.95}, {0.85, 0.95, 1}, c),
                0.4};
    }
    if (modo ==
        HUMO) { // en una esfera que crece, gira y se aleja; la luz viene de arriba a la izquierda y delante
        const double r = std::pow(b, 0.33), R = (0.20 + 0.85 * edad) * r, z = 2 * c - 1,
                     h = std::sqrt(1 - z * z), u = a + 0.5 * edad,
                     sale = std::sqrt(azarDe(grupo + 100)) * edad, w = azarDe(grupo + 200),
                     luz = 0.5 + 0.5 * r * (-0.49 * h * coseno(u) + 0.78 * h * seno(u) + 0.39 * z);
        return {{R * h * coseno(u) + sale * coseno(w) + 0.09 * s * s, R * h * seno(u) + 0.93 * s + 0.12,
                 R * z + sale * seno(w)},
                0.15 + 0.24 * edad,
                mezcla({0.16, 0.17, 0.21}, {0.98, 0.96, 0.92}, luz),
                0.20 * (1 - edad) * std::min(8 * edad, 1.0)};
    }
    const double llega = grupo ? 0.45 + 0.4 * azarDe(grupo) : 1, fase = azarDe(grupo + 50),
                 mece = seno(edad - tau + fase) + 0.5 * seno(2.3 * edad - 3 * tau + 3 * fase),
                 base = grupo ? 0.75 * (1 - 0.8 * edad) : 0, u = grupo / 6.0,
                 r = 0.5 * std::sqrt(b) * (1 - edad) * (0.7 + 2 * edad);
    return {{base * coseno(u) + r * coseno(a) + 0.28 * edad * mece, 4.8 * llega * edad * (0.7 + 0.3 * c),
             base * seno(u) + r * seno(a)},
            0.26 * (1 - 0.7 * edad),
            mezcla({1, 0.62, 0.18}, {0.85, 0.10, 0.02}, edad),
            0.11 * (1 - edad * edad)};
}

/// Las `cuantas` primeras, mezcladas en orden: el humo tapa y lo demás se suma. Cuantas menos, mayores, hasta el
/// triple.
Esperado particulas(int modo, std::uint32_t cuantas, double t) {
    const double escala = std::min(100 / std::sqrt(cuantas), 3.0);
    std::vector<Vec3> imagen(ANCHO * ALTO, color(FONDO_OSCURO));
    for (std::uint32_t id = 0; id < cuantas; ++id) {
        const Particula p = particula(modo, id, t);
        if (p.P.y < 0)
            continue; // ya ha caído
        const Vec3 q = proyecta(CAMARA, ANCHO, ALTO, p.P);
        const double radio = 0.5 * escala * p.diametro / tallaPixel(CAMARA, ANCHO, ALTO, p.P);
        for (int y = std::max(0, int(q.y - radio)); y <= std::min(ALTO - 1, int(q.y + radio)); ++y)
            for (int x = std::max(0, int(q.x - radio)); x <= std::min(ANCHO - 1, int(q.x + radio)); ++x) {
                const double u = (x + 0.5 - q.x) / radio, v = (y + 0.5 - q.y) / radio,
                             alfa = p.alfa * std::max(0.0, 1 - u * u - v * v);
                Vec3 &c = imagen[std::size_t(y * ANCHO + x)];
                c = (modo == HUMO ? 1 - alfa : 1.0) * c + 255 * alfa * p.color;
            }
    }
    return [imagen](int x, int y) { return imagen[std::size_t(y * ANCHO + x)]; };
}

/// Ese modo, con diez mil partículas por 10^pasos.
std::string pide(int modo, int pasos = 0) {
    return "tecla " + std::to_string(modo + 1) + "; " + veces(pasos, "tecla +") + veces(-pasos, "tecla -") +
           "; ";
}

// Una sola, de cada clase cien, más de las que hay grupos, mil gotas y diez mil de cada clase: la imagen entera,
// también a las cien horas. Cada capa redondea a 8 bits el color, la opacidad y el resultado: una, un nivel y medio;
// con diez mil hay sitios con decenas.
TEST(Particulas, CadaUnaContraSuFormaCerrada) {
    const struct {
        int pasos, cuantas;
        double cota;
        std::vector<int> modos;
        std::vector<double> instantes;
    } casos[] = {{-4, 1, 1.5, {FUENTE, HUMO, FUEGO}, {0.5, 2.5, 4.5, HORAS + 7.5, HORAS + 11.5}},
                 {-2, 100, 6, {FUENTE, HUMO, FUEGO}, {1, 3.5}},
                 {-1, 1000, 6, {FUENTE}, {0, 1.5, HORAS + 11}},
                 {0, 10000, 20, {FUENTE, HUMO, FUEGO}, {1.5}}};
    for (const auto &[pasos, cuantas, cota, modos, instantes] : casos)
        for (const int modo : modos)
            for (const double t : instantes) {
                SCOPED_TRACE(pide(modo, pasos) + conDosCifras(t));
                const Vista v = vistaDe("particulas", pide(modo, pasos) + instante(t), ANCHO, ALTO);
                EXPECT_LE(diferenciaMaxima(v.escena, particulas(modo, std::uint32_t(cuantas), t)), cota);
            }
}

// --- Mosaico y banderas ---

const double INICIO = 2; // los segundos andados con que se abren

/// De 0 (aún no ha nacido, o ya ha muerto) a 1: nacen entre 0 y 3.5 s y mueren entre 6 y 9.5.
double crecida(int i, double t) {
    const auto n = 2 * std::uint32_t(i);
    const double nace = 3.5 * azarDe(n), muere = 6 + 3.5 * azarDe(n + 1);
    return std::clamp(std::min(t - nace, muere - t) / 0.4, 0.0, 1.0);
}
/// Lo que lee de la textura de ruido la pieza de esa columna y esa fila, de −1 a 1.
glm::dvec3 vaivenDe(int c, int f, double t) {
    static const TexturaDeRuido ruido;
    return 2.0 * ruido(0.08 * c + t / 2, 0.08 * f + t / 2) - 1.0;
}
glm::dvec2 girado(const glm::dvec2 &v, double a) {
    return {std::cos(a) * v.x - std::sin(a) * v.y, std::sin(a) * v.x + std::cos(a) * v.y};
}

/// El dibujo del mosaico: el centro rojo, ocho pétalos amarillos con el filo naranja, la orla oscura y el fondo azul.
glm::vec3 colorDeFlor(const glm::dvec2 &p) {
    const double r = glm::length(p), petalo = 0.62 + 0.22 * std::cos(8 * std::atan2(p.y, p.x));
    const bool orla = std::max(std::fabs(p.x) * 39 / 52, std::fabs(p.y)) > 0.9;
    return r < 0.2             ? ROJO
           : r < petalo - 0.22 ? AMARILLO
           : r < petalo        ? NARANJA
           : orla              ? OSCURO
                               : glm::vec3(0.30f, 0.55f, 0.78f);
}

// Cada tesela, en su sitio y de su color, encima de las anteriores.
TEST(Mosaico, CadaTeselaVivaEstaEnSuSitio) {
    const int C = 52, F = 39;
    const double k = 90 / 1.28; // píxeles por unidad
    for (const double t : {2.0, 2.5, 5.0, 8.0, 9.5, 10.0, HORAS + 3}) {
        const double tt = std::fmod(t, 10);
        std::vector<Pieza> teselas;
        for (int i = 0; i < C * F; ++i) {
            const int c = i % C, f = i / C;
            const glm::dvec3 va = vaivenDe(c, f, tt);
            const double lado = 0.9 * crecida(i, tt) / F, giro = 0.5 * va.z;
            const glm::dvec2 centro = glm::dvec2(2 * c + 1 - C, 2 * f + 1 - F) / double(F),
                             p = centro + 0.9 / F * glm::dvec2(va);
            Pieza tesela = {{}, {(1 + 0.12 * std::sin(91.0 * c + 57.0 * f)) * exacto(colorDeFlor(centro))}};
            for (const glm::dvec2 &esquina : {glm::dvec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
                const glm::dvec2 v = k * (p + lado * girado(esquina, giro));
                tesela.contorno.push_back({120 + v.x, 90 + v.y});
            }
            if (lado > 0)
                teselas.push_back(tesela);
        }
        const Vista v = vistaDe("mosaico", instante(t, INICIO));
        compruebaPlana("t = " + conDosCifras(t), v.escena, teselas, exacto(FONDO_CLARO));
    }
}

struct Bandera {
    Vec3 pie, color;
    double crece, inclina, onda;

    /// Si la ve el rayo antes de `distancia`, hasta dónde llega y el tono de ese punto: del asta o, arriba, de la
    /// tela, que ondea.
    void mira(const Rayo &r, double &distancia, Tono &tono, int cual) const {
        const double d = (pie.z - r.origen.z) / r.direccion.z;
        const Vec3 v = r.origen + d * r.direccion - pie;
        const glm::dvec2 tela = girado({v.x, v.y}, -inclina) / (crece * glm::dvec2(0.9, 1.1));
        const double y = tela.y + 0.06 * tela.x * std::sin(7 * tela.x - onda);
        const bool enAsta = tela.x < 0.07, dentro = tela.x >= 0 && tela.x <= 1 && tela.y >= 0 && tela.y <= 1;
        if (crece == 0 || d >= distancia || !dentro || (!enAsta && (y < 0.45 || y > 0.94)))
            return;
        distancia = d;
        tono = enAsta ? Tono({0.35, 0.25, 0.18}, 2 * cual + 1)
                      : Tono((0.86 + 0.14 * std::cos(7 * tela.x - onda)) * color, 2 * cual + 2);
    }
};

// La imagen entera: la grada, maciza hasta el suelo, que está un escalón por debajo de la primera fila, y cada
// bandera con su asta.
TEST(Banderas, CadaUnaConSuAstaEnSuSitio) {
    const int C = 26, F = 12;
    const Camara camara = perspectiva(orbita(0.35, 0.34, 43, {0.4, 3.9, -4.5}), 0.5, 1, 200);
    const glm::vec3 paleta[] = {ROJO, AMARILLO, AZUL};
    Escena grada;
    for (int f = 0; f < F; ++f)
        grada.push_back(caja(traslada({0, 0.4 * f - 0.4, -0.9 * f}) * escala({26.6, 0.8 * (f + 1), 0.9})));
    const auto lejos = [](int c, int f) { return std::hypot(c - 12.5, f - 5.5); };
    for (const double t : {2.0, 5.0, 8.0, 9.5, 11.5, HORAS + 3}) {
        const double tt = std::fmod(t, 10);
        std::vector<Bandera> banderas;
        for (int i = 0; i < C * F; ++i) {
            const int c = i % C, f = i / C, franja = lejos(c, f) < 3.2 ? 0 : lejos(c, f) < 5.6 ? 1 : 2;
            const glm::dvec3 va = vaivenDe(c, f, tt);
            banderas.push_back({{c - 12.75, 0.8 * f + 0.25 + 0.3 * va.z, -0.9 * f + 0.02 * (c % 2)},
                                exacto(paleta[franja]),
                                crecida(i, tt),
                                0.7 * va.x,
                                6 * va.y});
        }
        const Vista v = vistaDe("banderas", instante(t, INICIO), 480, 360);
        comprueba("t = " + conDosCifras(t), compara(v.escena, grada, camara, [&](const Impacto &i) {
                      Tono tono = i ? Tono(luzFija(i.normal) * Vec3{0.66, 0.68, 0.72}) : Tono(exacto(CIELO));
                      double distancia = i ? i.distancia : INFINITO;
                      for (int k = 0; k < C * F; ++k)
                          banderas[std::size_t(k)].mira(i.rayo, distancia, tono, k);
                      return tono;
                  }));
    }
}

} // namespace
