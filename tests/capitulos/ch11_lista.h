// Lo que un programa del capítulo debe pintar encima de su escena, en doble precisión y en el orden en que lo pinta,
// contra la lista que apunta.
#pragma once
#include "colores.h"
#include "contra_oraculo.h"
#include "guiones.h"
#include "plana.h"
#include "tabla.h"
#include "trazo.h"

using Puntos = std::vector<glm::dvec2>;

class Lista {
public:
    const glm::ivec2 ventana;
    bool conProfundidad = false; // lo que sigue

    explicit Lista(const glm::ivec2 &laVentana) : ventana(laVentana), tamano(laVentana) {
    }

    // Las unidades de los puntos: píxeles, si no se dice otra cosa.

    void enPanel(const Hueco &h, const glm::vec3 &fondo = FONDO_CLARO) {
        paneles.push_back({h, fondo});
        esquina = {h.x, h.y};
        tamano = {h.ancho, h.alto};
    }
    void pixeles() {
        escala = {1, 1};
        origen = {0, 0};
    }
    /// Las de paralelaVentana(semialto) centrada en un punto.
    void paralela(double semialto, const glm::dvec2 &centro = {0, 0}) {
        escala = glm::dvec2(0.5 * oraculo::altoUtil(int(tamano.x), int(tamano.y)) / semialto);
        origen = esquina + 0.5 * tamano - escala * centro;
    }
    /// Las que, por m y más d, son coordenadas normalizadas del panel.
    void normalizadas(const glm::dvec2 &m, const glm::dvec2 &d) {
        escala = 0.5 * tamano * m;
        origen = esquina + 0.5 * tamano * (d + 1.0);
    }
    /// El píxel en que está un punto, como lo da el ratón, y el punto que hay en el centro de uno.
    glm::ivec2 raton(const glm::dvec2 &punto) const {
        const glm::ivec2 p(glm::floor(origen + escala * punto));
        return {p.x, ventana.y - 1 - p.y};
    }
    glm::dvec2 punto(const glm::ivec2 &raton) const {
        return (glm::dvec2(raton.x + 0.5, ventana.y - raton.y - 0.5) - origen) / escala;
    }

    // Lo que se pinta, en orden. El grosor, o el diámetro, es el de trazo.h.

    void trazo(const std::string &tipo, const Puntos &puntos, const glm::vec3 &color,
               double grosor = GROSOR) {
        debe(tipo, puntos, color, tipo == "poligono" ? 1 : std::max(grosor * alto() / 1080, 1.0));
    }
    /// Cuerdas de f(u), con u de 0 a 1, que no se separan de ella más de `tolerancia` píxeles.
    template<typename Curva>
    void curva(const Curva &f, const glm::vec3 &color, double grosor, double tolerancia) {
        Puntos puntos;
        for (int i = 0; i <= 3000; ++i)
            puntos.push_back(glm::dvec2(f(i / 3000.0)));
        trazo("polilinea", puntos, color, grosor);
        cosas.back().tolerancia = tolerancia;
    }
    /// Si el punto no está en el panel no hay rótulo.
    void rotulo(const std::string &texto, const glm::dvec2 &p, const glm::vec3 &color, Lado lado,
                double talla = TALLA_ROTULO) {
        const glm::dvec2 enPanel = (origen + escala * p - esquina) / tamano;
        if (enPanel != glm::clamp(enPanel, 0.0, 1.0))
            return;
        debe("rotulo", {p}, color, std::round(talla * alto()));
        cosas.back().texto = texto;
        cosas.back().lado = lado;
    }

    void comprueba(const Encima &encima) const {
        Encima hay; // un rótulo sin letras no se ve
        std::copy_if(encima.begin(), encima.end(), std::back_inserter(hay),
                     [](const Pintado &p) { return p.tipo != "rotulo" || !p.texto.empty(); });
        EXPECT_EQ(hay.size(), cosas.size());
        for (std::size_t i = 0; i < std::min(hay.size(), cosas.size()); ++i) {
            SCOPED_TRACE("pincelada " + std::to_string(i) + ": " + hay[i].tipo + " " + hay[i].texto);
            comprueba(hay[i], cosas[i]);
        }
    }
    /// Cada panel, con su fondo; entre ellos se ve gris.
    void compruebaEscena(const Imagen &escena) const {
        ASSERT_EQ(glm::ivec2(escena.ancho, escena.alto), ventana);
        std::vector<Pieza> fondos;
        for (const auto &[h, fondo] : paneles)
            fondos.push_back(rectangulo(h, exacto(fondo)));
        compruebaPlana("el fondo", escena, fondos, exacto(fondos.empty() ? FONDO_CLARO : GRIS));
    }

private:
    struct Debe : Pintado {
        double tolerancia = 0; // de una curva
        Lado lado = Lado::CENTRO;
    };
    std::vector<Debe> cosas;
    std::vector<std::pair<Hueco, glm::vec3>> paneles; // con su fondo; si no hay ninguno, la ventana
    glm::dvec2 esquina{0, 0}, tamano;                 // del panel
    glm::dvec2 origen{0, 0}, escala{1, 1};            // un punto está en el píxel origen + escala·punto

    double alto() const {
        return oraculo::altoUtil(ventana.x, ventana.y);
    }
    void debe(const std::string &tipo, const Puntos &puntos, const glm::vec3 &color, double talla) {
        Debe &d = cosas.emplace_back();
        d.tipo = tipo;
        d.color = color;
        d.talla = talla;
        d.panel = {esquina, tamano};
        d.conProfundidad = conProfundidad && tipo != "rotulo";
        for (const glm::dvec2 &p : puntos)
            d.puntos.emplace_back(origen + escala * p, 0);
    }

    static void comprueba(const Pintado &hay, const Debe &debe) {
        // píxeles: un float de 1000 se redondea a 6e-5, y detrás hay unas cuantas cuentas
        const double juntos = 0.01;
        ASSERT_EQ(hay.tipo, debe.tipo);
        EXPECT_TRUE(hay.es(debe.color)) << hay.color.r << " " << hay.color.g << " " << hay.color.b;
        EXPECT_EQ(hay.panel, debe.panel);
        EXPECT_EQ(hay.conProfundidad, debe.conProfundidad);
        EXPECT_NEAR(hay.talla, debe.talla, 1e-4);
        const std::size_t n = hay.puntos.size();
        if (hay.tipo == "rotulo")
            return compruebaRotulo({{hay}}, debe.texto, debe.punto(0), debe.color, debe.lado);
        // va de un extremo al otro, por puntos de la curva, sin volver atrás ni separarse de ella
        if (debe.tolerancia > 0) {
            const Encima curva = {{debe}}, cuerdas = {{hay}};
            EXPECT_LE(glm::distance(hay.punto(0), debe.punto(0)), juntos);
            EXPECT_LE(glm::distance(hay.punto(n - 1), debe.punto(debe.puntos.size() - 1)), juntos);
            double lejos = 0;
            for (std::size_t i = 0; i < n; ++i)
                lejos = std::max(lejos, curva.lejosDeTrazo(hay.punto(i), debe.color));
            EXPECT_LE(lejos, juntos);
            EXPECT_LE(cuerdas.largo(debe.color), curva.largo(debe.color) + juntos);
            return compruebaTrazo(cuerdas, Puntos(debe.puntos.begin(), debe.puntos.end()), debe.color,
                                  debe.tolerancia);
        }
        ASSERT_EQ(n, debe.puntos.size());
        for (std::size_t i = 0; i < n; ++i) // y lejos de la ventana, en proporción
            EXPECT_LE(glm::distance(hay.punto(i), debe.punto(i)),
                      juntos * std::max(1.0, glm::length(debe.punto(i)) / 1000))
                << "punto " << i;
    }
};

/// Una ejecución de un programa: tras cada trozo de guion, que sigue al anterior, lo que debe verse.
template<typename UnaLista>
struct Paso {
    std::string guion;
    UnaLista lista;
};
template<typename UnaLista>
void compruebaPasos(const std::string &programa, const std::vector<Paso<UnaLista>> &pasos) {
    const glm::ivec2 ventana = pasos[0].lista.ventana;
    paraCada(programa, pasos, ventana.x, ventana.y, [](const Paso<UnaLista> &paso, const Vista &vista) {
        paso.lista.compruebaEscena(vista.escena);
        paso.lista.comprueba(vista.encima);
    });
}
