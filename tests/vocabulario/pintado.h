// Lo que se ve de un programa es su escena con la lista de lo que apunta encima, píxel a píxel.
#pragma once
#include "contra_oraculo.h"
#include "oraculo/cobertura.h"
#include "rotulo.h"

/// Lo que cubre de cada píxel una pincelada: cuánto está su centro dentro de ella, y de lo que quizá pinta.
class Cobertura {
    struct Cubierto {
        double dentro = -1e9, quiza = -1e9;
    };
    const Pintado &p;
    const int ancho;
    const double medio, solape;

    static glm::dvec2 unitario(const glm::dvec2 &v) {
        return v / std::max(glm::length(v), 1e-9);
    }
    void convexo(const std::vector<glm::dvec2> &vertices, bool quiza = false) {
        oraculo::Poligono lados;
        const glm::dvec2 esquina(p.panel), tope = esquina + glm::dvec2(p.panel.z, p.panel.w);
        glm::dvec2 desde = tope, hasta = esquina;
        for (const glm::dvec2 &v : vertices) {
            lados.push_back({v.x, v.y});
            desde = glm::max(glm::min(desde, v - 1.0), esquina);
            hasta = glm::min(glm::max(hasta, v + 1.0), tope);
        }
        for (int y = int(desde.y); y < hasta.y && std::fabs(oraculo::area(lados)) > 1e-6; ++y)
            for (int x = int(desde.x); x < hasta.x; ++x) {
                Cubierto &pixel = pixeles[std::size_t(y * ancho + x)];
                const double cuanto = oraculo::distanciaDentro(lados, x + 0.5, y + 0.5);
                pixel.quiza = std::max(pixel.quiza, cuanto);
                pixel.dentro = quiza ? pixel.dentro : std::max(pixel.dentro, cuanto);
            }
    }
    void banda(const glm::dvec2 &a, const glm::dvec2 &b, double antes, double despues) {
        const glm::dvec2 t = unitario(b - a), n = medio * glm::dvec2(-t.y, t.x), desde = a - antes * t,
                         hasta = b + despues * t;
        convexo({desde + n, desde - n, hasta - n, hasta + n});
    }
    void disco(const glm::dvec2 &c, bool quiza) {
        std::vector<glm::dvec2> vertices;
        for (int k = 0; k < 64; ++k)
            vertices.push_back(c + medio * glm::dvec2(std::cos(M_PI * k / 32), std::sin(M_PI * k / 32)));
        convexo(vertices, quiza);
    }
    void rotulo() { // con su halo y lo que baja de la línea base
        const double margen = BAJO_ROTULO * p.talla + std::max(HALO_ROTULO * p.talla, 1.0) + SUAVIZADO_ROTULO;
        const glm::dvec2 a = p.punto(0) - margen, b = p.punto(1) + margen;
        convexo({a, {b.x, a.y}, b, {a.x, b.y}});
    }
    void polilinea() {
        const auto n = p.puntos.size();
        const bool cerrada = p.puntos.front() == p.puntos.back();
        for (std::size_t i = 0; i + 1 < n; ++i) {
            const bool acaba = i + 2 == n && !cerrada;
            banda(p.punto(i), p.punto(i + 1), i > 0 || cerrada ? solape : 0, acaba ? 0 : solape);
            if (!acaba)
                disco(p.punto(i + 1), true); // el empalme no llega a ser redondo
        }
    }
    void flecha() { // la punta, de 4.5 grosores de largo y 3.8 de ancho
        const glm::dvec2 a = p.punto(0), b = p.punto(1), t = unitario(b - a);
        const double punta = std::min(4.5 * p.talla, glm::distance(a, b));
        const glm::dvec2 n = punta * 1.9 / 4.5 * glm::dvec2(-t.y, t.x), base = b - punta * t;
        banda(a, base, 0, solape);
        convexo({base + n, base - n, b});
    }

public:
    std::vector<Cubierto> pixeles;

    /// Las bandas de una línea se alargan `elSolape` donde empalman: entre una y otra no queda borde.
    Cobertura(const Pintado &deQue, const glm::ivec2 &ventana, double elSolape)
        : p(deQue), ancho(ventana.x), medio(0.5 * p.talla), solape(elSolape),
          pixeles(std::size_t(ventana.x * ventana.y)) {
        if (p.tipo == "poligono")
            convexo(std::vector<glm::dvec2>(p.puntos.begin(), p.puntos.end()));
        else if (p.tipo == "rotulo")
            rotulo();
        else if (p.tipo == "polilinea")
            polilinea();
        else if (p.tipo == "flecha")
            flecha();
        for (std::size_t i = 0; p.tipo == "puntos" && i < p.puntos.size(); ++i)
            disco(p.punto(i), false);
        for (std::size_t i = 0; p.tipo == "segmentos" && i < p.puntos.size(); i += 2)
            banda(p.punto(i), p.punto(i + 1), medio, medio);
    }
};

/// Comprueba que lo que pinta el programa es su escena con la lista encima: cada píxel es de lo último que lo cubre, y
/// junto a un borde, de una de las dos cosas que separa. No se miran los rótulos ni lo que se pinta con profundidad.
inline void compruebaPintado(const std::string &programa, const std::string &guion,
                             const glm::ivec2 &ventana) {
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
    for (const Pintado &p : vista.encima) {
        const auto capa = Cobertura(p, ventana, 2 * borde).pixeles;
        for (std::size_t i = 0; i < capa.size(); ++i)
            if (capa[i].quiza >= -borde) {
                const double suya = p.tipo == "rotulo" ? 0 : difiere(i, p.color);
                menor[i] = capa[i].dentro > borde && !p.conProfundidad ? suya : std::min(menor[i], suya);
            }
    }
    const double maximo = *std::max_element(menor.begin(), menor.end());
    EXPECT_LE(maximo, 0.501) << std::count_if(menor.begin(), menor.end(), [](double d) { return d > 0.501; })
                             << " píxeles";
    apuntaDiferencia(maximo, -1, borde);
}
