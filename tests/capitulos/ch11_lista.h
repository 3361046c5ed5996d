// Lo que un programa del capítulo debe pintar encima de su escena, en doble precisión y en el orden en que lo pinta, contra la lista que
// apunta; y que lo que se ve es su escena con esa lista encima, píxel a píxel.
#pragma once
#include "colores.h"
#include "contra_oraculo.h"
#include "guiones.h"
#include "oraculo/cobertura.h"
#include "trazo.h"
#include <functional>

using Puntos = std::vector<glm::dvec2>;

class Lista {
public:
    const glm::ivec2 ventana;
    bool conProfundidad = false; // lo que sigue

    explicit Lista(const glm::ivec2 &laVentana) : ventana(laVentana), tamano(laVentana) {
    }

    // Las unidades de los puntos: píxeles, si no se dice otra cosa.

    void enPanel(const Hueco &h) {
        paneles.push_back(h);
        esquina = {h.x, h.y};
        tamano = {h.ancho, h.alto};
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
    /// Los paneles son claros y entre ellos se ve gris.
    void compruebaEscena(const Imagen &escena) const {
        ASSERT_EQ(glm::ivec2(escena.ancho, escena.alto), ventana);
        int malos = 0;
        for (int y = 0; y < ventana.y; ++y)
            for (int x = 0; x < ventana.x; ++x) {
                bool claro = paneles.empty();
                for (const Hueco &h : paneles)
                    claro |= x >= h.x && y >= h.y && x < h.x + h.ancho && y < h.y + h.alto;
                malos += oraculo::diferencia(escena, x, y, exacto(claro ? FONDO_CLARO : GRIS)) > 0.501;
            }
        EXPECT_EQ(malos, 0);
    }

private:
    struct Debe : Pintado {
        double tolerancia = 0; // de una curva
        Lado lado = Lado::CENTRO;
    };
    std::vector<Debe> cosas;
    std::vector<Hueco> paneles;            // si no hay ninguno, la ventana
    glm::dvec2 esquina{0, 0}, tamano;      // del panel
    glm::dvec2 origen{0, 0}, escala{1, 1}; // un punto está en el píxel origen + escala·punto

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
        for (std::size_t i = 0; i < n; ++i)
            EXPECT_LE(glm::distance(hay.punto(i), debe.punto(i)), juntos) << "punto " << i;
    }
};

/// Una ejecución de un programa: tras cada trozo de guion, que sigue al anterior, lo que debe verse.
template<typename UnaLista>
void compruebaPasos(const std::string &programa, const std::vector<std::pair<std::string, UnaLista>> &pasos) {
    std::vector<std::string> guiones;
    for (const auto &paso : pasos)
        guiones.push_back(paso.first);
    const glm::ivec2 ventana = pasos[0].second.ventana;
    const std::vector<Vista> vistas = vistasDe(programa, guiones, ventana.x, ventana.y);
    for (std::size_t i = 0; i < pasos.size(); ++i) {
        SCOPED_TRACE(programa + ", paso " + std::to_string(i) + ": " + guiones[i]);
        pasos[i].second.compruebaEscena(vistas[i].escena);
        pasos[i].second.comprueba(vistas[i].encima);
    }
}

// ---- Los píxeles ----

/// Lo que una pincelada cubre de un píxel: cuánto está su centro dentro de ella, y de lo que quizá pinta, y la profundidad de lo más cercano.
struct Cubierto {
    double dentro = -1e9, quiza = -1e9, profundidad = 0;
};
/// Las bandas de una línea se alargan `solape` donde empalman: entre una y otra no queda borde.
inline std::vector<Cubierto> cubre(const Pintado &p, int ancho, int alto, double solape) {
    std::vector<Cubierto> pixeles(std::size_t(ancho * alto));
    // un polígono convexo; la profundidad cambia de a a b
    const auto convexo = [&](const Puntos &puntos, const glm::dvec3 &a, const glm::dvec3 &b,
                             bool quiza = false) {
        oraculo::Poligono lados;
        glm::dvec2 desde(p.panel.x + p.panel.z, p.panel.y + p.panel.w), hasta(p.panel), tope = desde,
                                                                                        d(b - a);
        for (const glm::dvec2 &v : puntos) {
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
    };
    const double medio = 0.5 * p.talla;
    const auto unitario = [](const glm::dvec2 &v) { return v / std::max(glm::length(v), 1e-9); };
    const auto banda = [&](const glm::dvec3 &a, const glm::dvec3 &b, double antes, double despues) {
        const glm::dvec2 t = unitario(b - a), n = medio * glm::dvec2(-t.y, t.x),
                         desde = glm::dvec2(a) - antes * t, hasta = glm::dvec2(b) + despues * t;
        convexo({desde + n, desde - n, hasta - n, hasta + n}, a, b);
    };
    const auto disco = [&](const glm::dvec3 &c, bool quiza) {
        Puntos puntos;
        for (int k = 0; k < 64; ++k)
            puntos.push_back(glm::dvec2(c) +
                             medio * glm::dvec2(std::cos(M_PI * k / 32), std::sin(M_PI * k / 32)));
        convexo(puntos, c, c, quiza);
    };
    const auto &v = p.puntos;
    if (p.tipo == "poligono")
        convexo(Puntos(v.begin(), v.end()), v[0], v[0]);
    if (p.tipo == "rotulo") { // con su halo y lo que baja de la línea base
        const glm::dvec2 a = p.punto(0) - 0.4 * p.talla, b = p.punto(1) + 0.4 * p.talla;
        convexo({a, {b.x, a.y}, b, {a.x, b.y}}, v[0], v[0]);
    }
    for (std::size_t i = 0; p.tipo == "puntos" && i < v.size(); ++i)
        disco(v[i], false);
    for (std::size_t i = 0; p.tipo == "segmentos" && i < v.size(); i += 2)
        banda(v[i], v[i + 1], medio, medio);
    for (std::size_t i = 0; p.tipo == "polilinea" && i + 1 < v.size(); ++i) {
        const bool cerrada = v.front() == v.back(), acaba = i + 2 == v.size() && !cerrada;
        banda(v[i], v[i + 1], i > 0 || cerrada ? solape : 0, acaba ? 0 : solape);
        if (!acaba)
            disco(v[i + 1], true); // el empalme no llega a ser redondo
    }
    if (p.tipo == "flecha") { // la punta, de 4.5 grosores de largo y 3.8 de ancho
        const double punta = std::min(4.5 * p.talla, glm::distance(p.punto(0), p.punto(1)));
        const glm::dvec2 t = unitario(v[1] - v[0]), n = punta * 1.9 / 4.5 * glm::dvec2(-t.y, t.x),
                         base = p.punto(1) - punta * t;
        banda(v[0], glm::dvec3(base, v[1].z), 0, solape);
        convexo({base + n, base - n, p.punto(1)}, v[1], v[1]);
    }
    return pixeles;
}

/// Si lo que va con profundidad, de la dada, está delante de lo que se ve en un píxel (1), detrás (−1) o no se sabe (0).
using Delante = std::function<int(int x, int y, double profundidad)>;

/// Comprueba que lo que pinta el programa es su escena con la lista encima: cada píxel es de lo último que lo cubre, y junto a un borde, de
/// una de las dos cosas que separa; los rótulos no se miran. Devuelve qué parte se ve de lo que va con profundidad.
inline double compruebaPintado(const std::string &programa, const std::string &guion,
                               const glm::ivec2 &ventana, const Delante &delante = nullptr) {
    SCOPED_TRACE(programa + ": " + guion);
    // los trazos se corren hasta 1/48 de píxel (trazo.cpp), y los discos, de veinte lados, se quedan a un 1 % de su radio
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
        const std::vector<Cubierto> capa = cubre(p, ventana.x, ventana.y, 2 * borde);
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
