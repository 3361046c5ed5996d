// Lo que se ve de un programa es su escena con la lista de lo que apunta encima, píxel a píxel.
#pragma once
#include "contra_oraculo.h"
#include "oraculo/cobertura.h"
#include "prueba.h"
#include "rotulo.h"

/// Lo que una pincelada cubre de un píxel: cuánto está su centro dentro de ella, y de lo que quizá pinta, y la
/// profundidad de lo más cercano.
struct Cubierto {
    double dentro = -1e9, quiza = -1e9, profundidad = 0;
};
/// Lo que cubre de cada píxel una pincelada.
class Cobertura {
    const Pintado &p;
    const int ancho;
    const double medio, solape;

    static glm::dvec2 unitario(const glm::dvec2 &v) {
        return v / std::max(glm::length(v), 1e-9);
    }
    /// Un polígono convexo; la profundidad cambia de a a b.
    void convexo(const std::vector<glm::dvec2> &vertices, const glm::dvec3 &a, const glm::dvec3 &b,
                 bool quiza = false) {
        oraculo::Poligono lados;
        glm::dvec2 desde(p.panel.x + p.panel.z, p.panel.y + p.panel.w), hasta(p.panel), tope = desde,
                                                                                        d(b - a);
        for (const glm::dvec2 &v : vertices) {
            lados.push_back({v.x, v.y});
            desde = glm::max(glm::min(desde, v - 1.0), glm::dvec2(p.panel));
            hasta = glm::min(glm::max(hasta, v + 1.0), tope);
        }
        for (int y = int(desde.y); y < hasta.y && std::fabs(oraculo::area(lados)) > 1e-6; ++y)
            for (int x = int(desde.x); x < hasta.x; ++x) {
                Cubierto &pixel = pixeles[std::size_t(y * ancho + x)];
                const glm::dvec2 c = glm::dvec2(x + 0.5, y + 0.5) - glm::dvec2(a);
                const double cuanto = oraculo::distanciaDentro(lados, x + 0.5, y + 0.5),
                             t = glm::clamp(glm::dot(c, d) / std::max(glm::dot(d, d), 1e-9), 0.0, 1.0),
                             z = glm::mix(a.z, b.z, t);
                pixel.quiza = std::max(pixel.quiza, cuanto);
                if (quiza)
                    continue;
                if (cuanto > 0 && (pixel.dentro <= 0 || z < pixel.profundidad))
                    pixel.profundidad = z;
                pixel.dentro = std::max(pixel.dentro, cuanto);
            }
    }
    void banda(const glm::dvec3 &a, const glm::dvec3 &b, double antes, double despues) {
        const glm::dvec2 t = unitario(b - a), n = medio * glm::dvec2(-t.y, t.x),
                         desde = glm::dvec2(a) - antes * t, hasta = glm::dvec2(b) + despues * t;
        convexo({desde + n, desde - n, hasta - n, hasta + n}, a, b);
    }
    void disco(const glm::dvec3 &c, bool quiza) {
        std::vector<glm::dvec2> vertices;
        for (int k = 0; k < 64; ++k)
            vertices.push_back(glm::dvec2(c) +
                               medio * glm::dvec2(std::cos(M_PI * k / 32), std::sin(M_PI * k / 32)));
        convexo(vertices, c, c, quiza);
    }
    void rotulo() { // con su halo y lo que baja de la línea base
        const double margen = BAJO_ROTULO * p.talla + std::max(HALO_ROTULO * p.talla, 1.0) + SUAVIZADO_ROTULO;
        const glm::dvec2 a = p.punto(0) - margen, b = p.punto(1) + margen;
        convexo({a, {b.x, a.y}, b, {a.x, b.y}}, p.puntos[0], p.puntos[0]);
    }
    void polilinea() {
        const auto &v = p.puntos;
        for (std::size_t i = 0; i + 1 < v.size(); ++i) {
            const bool cerrada = v.front() == v.back(), acaba = i + 2 == v.size() && !cerrada;
            banda(v[i], v[i + 1], i > 0 || cerrada ? solape : 0, acaba ? 0 : solape);
            if (!acaba)
                disco(v[i + 1], true); // el empalme no llega a ser redondo
        }
    }
    void flecha() { // la punta, de 4.5 grosores de largo y 3.8 de ancho
        const auto &v = p.puntos;
        const double punta = std::min(4.5 * p.talla, glm::distance(p.punto(0), p.punto(1)));
        const glm::dvec2 t = unitario(v[1] - v[0]), n = punta * 1.9 / 4.5 * glm::dvec2(-t.y, t.x),
                         base = p.punto(1) - punta * t;
        banda(v[0], glm::dvec3(base, v[1].z), 0, solape);
        convexo({base + n, base - n, p.punto(1)}, v[1], v[1]);
    }

public:
    std::vector<Cubierto> pixeles;

    /// Las bandas de una línea se alargan `elSolape` donde empalman: entre una y otra no queda borde.
    Cobertura(const Pintado &deQue, const glm::ivec2 &ventana, double elSolape)
        : p(deQue), ancho(ventana.x), medio(0.5 * p.talla), solape(elSolape),
          pixeles(std::size_t(ventana.x * ventana.y)) {
        const auto &v = p.puntos;
        if (p.tipo == "poligono")
            convexo(std::vector<glm::dvec2>(v.begin(), v.end()), v[0], v[0]);
        else if (p.tipo == "rotulo")
            rotulo();
        else if (p.tipo == "polilinea")
            polilinea();
        else if (p.tipo == "flecha")
            flecha();
        for (std::size_t i = 0; p.tipo == "puntos" && i < v.size(); ++i)
            disco(v[i], false);
        for (std::size_t i = 0; p.tipo == "segmentos" && i < v.size(); i += 2)
            banda(v[i], v[i + 1], medio, medio);
    }
};

/// Si lo que va con profundidad, de la dada, está delante de lo que se ve en un píxel (1), detrás (−1) o a saber (0).
using Delante = std::function<int(int x, int y, double profundidad)>;

/// Comprueba que lo que pinta el programa es su escena con la lista encima: cada píxel es de lo último que lo cubre, y
/// junto a un borde, de una de las dos cosas que separa; los rótulos no se miran. Devuelve qué parte se ve de lo que va
/// con profundidad.
inline double compruebaPintado(const std::string &programa, const std::string &guion,
                               const glm::ivec2 &ventana, const Delante &delante = nullptr) {
    SCOPED_TRACE(programa + ": " + guion);
    // los trazos se corren hasta 1/48 de píxel (trazo.cpp), y los discos, de 20 lados, un 1 % de su radio
    const double borde = 0.1;
    const Vista vista = vistaDe(programa, guion, ventana.x, ventana.y);
    const Imagen imagen = imagenDe(programa, guion, ventana.x, ventana.y);
    const auto difiere = [&](std::size_t i, const glm::vec3 &color) {
        return oraculo::diferencia(imagen, int(i) % ventana.x, int(i) / ventana.x, exacto(color));
    };
    std::vector<double> menor; // diferencia de cada píxel con los colores que puede tener
    for (std::size_t i = 0; 3 * i < imagen.rgb.size(); ++i) {
        const Pixel p = pixel(vista.escena, int(i) % ventana.x, int(i) / ventana.x);
        menor.push_back(difiere(i, glm::vec3(p.r, p.g, p.b) / 255.0f));
    }
    int posibles = 0, vistos = 0;
    for (const Pintado &p : vista.encima) {
        const std::vector<Cubierto> capa = Cobertura(p, ventana, 2 * borde).pixeles;
        for (std::size_t i = 0; i < capa.size(); ++i) {
            const auto &[dentro, quiza, z] = capa[i];
            const int orden = !p.conProfundidad ? 1
                              : delante         ? delante(int(i) % ventana.x, int(i) / ventana.x, z)
                                                : 0;
            if (quiza < -borde || orden < 0)
                continue;
            const double suya = p.tipo == "rotulo" ? 0 : difiere(i, p.color);
            menor[i] = dentro > borde && orden > 0 ? suya : std::min(menor[i], suya);
            posibles += p.conProfundidad && dentro > borde;
            vistos += p.conProfundidad && dentro > borde && suya < 1;
        }
    }
    const double maximo = *std::max_element(menor.begin(), menor.end());
    EXPECT_LE(maximo, 0.501) << std::count_if(menor.begin(), menor.end(), [](double d) { return d > 0.501; })
                             << " píxeles";
    apuntaDiferencia(maximo, -1, borde);
    return double(vistos) / std::max(posibles, 1);
}
