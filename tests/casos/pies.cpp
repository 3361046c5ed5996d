// pies GOLDEN: lo que cumple cada caso del catálogo, que se lee por la entrada como lo escribe base.catalogo (capítulo,
// programa, imagen y afirmaciones, entre tabuladores), es así en su golden y no en los demás de su programa: un pie que
// vale para la imagen de al lado no dice nada de la suya. Salvo las casi iguales. Los puntos son fracciones de la
// ventana, x hacia la derecha e y hacia abajo; un COLOR es un nombre de common/encima/colores.h o (r,g,b), de 0 a 255:
//   en X Y COLOR                  ese color, a 12 niveles como mucho
//   en X Y como X Y               los dos puntos, a 12 niveles
//   en X Y más claro que X Y      más de 12 niveles de luminancia
//   COLOR entero|cortado|ausente  lo de ese color, con más o menos luz: no toca el borde, lo toca, no está
//   COLOR A a B %                 lo que ocupa de ella
//   distinta de CASO en A a B %   los píxeles que cambian en más de 12 niveles
// Estado: 0 si todas son así; 1 si alguna no, y dice cuál y qué hay; 2 si una está mal escrita.
#include "colores.h"
#include "error.h"
#include "imagen.h"
#include <algorithm>
#include <cstdio>
#include <functional>
#include <iostream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

static const int NIVELES = 12;
static const double CASI_IGUALES = 1; // % de píxeles distintos: las separa un rótulo
static const double PENUMBRA = 0.25;  // lo menos iluminado que es del color de un objeto

static const glm::vec3 NEGRO(0);
#define CON_NOMBRE(color)                                                                                    \
    { #color, color }
static const std::map<std::string, glm::vec3> COLORES = {
    CON_NOMBRE(ROJO),        CON_NOMBRE(VERDE),       CON_NOMBRE(AZUL),  CON_NOMBRE(NARANJA),
    CON_NOMBRE(AMARILLO),    CON_NOMBRE(MORADO),      CON_NOMBRE(GRIS),  CON_NOMBRE(OSCURO),
    CON_NOMBRE(BLANCO),      CON_NOMBRE(NEGRO),       CON_NOMBRE(CIELO), CON_NOMBRE(SUELO),
    CON_NOMBRE(FONDO_CLARO), CON_NOMBRE(FONDO_OSCURO)};

static glm::ivec3 colorDe(const std::string &nombre) {
    glm::ivec3 c;
    if (std::sscanf(nombre.c_str(), "(%d,%d,%d)", &c.r, &c.g, &c.b) == 3)
        return c;
    if (!COLORES.count(nombre))
        falla("no hay ningún color «" + nombre + "»", 2);
    return glm::ivec3(255.0f * COLORES.at(nombre) + 0.5f);
}

static bool iguales(const glm::ivec3 &a, const glm::ivec3 &b) {
    const glm::ivec3 d = glm::abs(a - b);
    return std::max({d.r, d.g, d.b}) <= NIVELES;
}

// Si es ese color con la luz que sea: un múltiplo suyo.
static bool delColor(const glm::ivec3 &pixel, const glm::ivec3 &color) {
    const glm::dvec3 c(color);
    const double luz = glm::dot(glm::dvec3(pixel), c) / std::max(glm::dot(c, c), 1.0);
    return iguales(pixel, glm::ivec3(std::clamp(luz, PENUMBRA, 1.0) * c + 0.5));
}

static double luminancia(const glm::ivec3 &p) {
    return 0.299 * p.r + 0.587 * p.g + 0.114 * p.b;
}

static std::string dice(const glm::ivec3 &c) {
    return "(" + std::to_string(c.r) + "," + std::to_string(c.g) + "," + std::to_string(c.b) + ")";
}

struct Caso {
    std::string fichero;
    std::vector<std::string> afirmaciones;
    Imagen imagen;

    glm::ivec3 pixel(int x, int y) const { // de arriba abajo
        const std::size_t i = std::size_t(3 * ((imagen.alto - 1 - y) * imagen.ancho + x));
        return {imagen.rgb[i], imagen.rgb[i + 1], imagen.rgb[i + 2]};
    }
    glm::ivec3 en(const std::string &x, const std::string &y) const {
        return pixel(int(std::stod(x) * imagen.ancho), int(std::stod(y) * imagen.alto));
    }
    // Cuántos píxeles son eso, y cuántos del borde.
    glm::ivec2 cuenta(const std::function<bool(int, int)> &lo_es) const {
        glm::ivec2 n(0);
        for (int y = 0; y < imagen.alto; ++y)
            for (int x = 0; x < imagen.ancho; ++x)
                if (lo_es(x, y)) {
                    ++n.x;
                    n.y += x == 0 || y == 0 || x == imagen.ancho - 1 || y == imagen.alto - 1;
                }
        return n;
    }
    glm::ivec2 deColor(const std::string &color) const {
        return cuenta([&, suyo = colorDe(color)](int x, int y) { return delColor(pixel(x, y), suyo); });
    }
    int distintos(const Caso &otro) const {
        return cuenta([&](int x, int y) { return !iguales(pixel(x, y), otro.pixel(x, y)); }).x;
    }
    double porcentaje(int cuantos) const {
        return 100.0 * cuantos / (imagen.ancho * imagen.alto);
    }
    std::string entre(int cuantos, const std::string &de, const std::string &a) const {
        char texto[32];
        std::snprintf(texto, sizeof texto, "%.3g %%", porcentaje(cuantos));
        return porcentaje(cuantos) >= std::stod(de) && porcentaje(cuantos) <= std::stod(a) ? "" : texto;
    }
};

struct Programa {
    std::string nombre;
    std::vector<Caso> casos;
    const Caso &operator[](const std::string &caso) const {
        const std::string fichero = caso == "base" ? nombre : nombre + "-" + caso;
        const auto es =
            std::find_if(casos.begin(), casos.end(), [&](auto &c) { return c.fichero == fichero; });
        return es != casos.end() ? *es : (falla(nombre + " no tiene el caso «" + caso + "»", 2), *es);
    }
};

// Cómo se escribe una afirmación, y lo que hay si no es lo que afirma.
struct Forma {
    std::regex escrita;
    std::string (*hay)(const std::smatch &palabras, const Caso &caso, const Programa &programa);
};
static const std::string PUNTO = "(0(?:\\.\\d+)?) (0(?:\\.\\d+)?)";
static const std::string COLOR = "([A-Z_]+|\\(\\d+,\\d+,\\d+\\))", CUANTO = "(\\d+(?:\\.\\d+)?)";
static const std::string TRAMO = CUANTO + " a " + CUANTO + " %";
static const Forma FORMAS[] = {
    {std::regex("en " + PUNTO + " " + COLOR),
     [](const std::smatch &m, const Caso &caso, const Programa &) {
         const glm::ivec3 hay = caso.en(m[1], m[2]);
         return iguales(hay, colorDe(m[3])) ? "" : dice(hay);
     }},
    {std::regex("en " + PUNTO + " (como|más claro que) " + PUNTO),
     [](const std::smatch &m, const Caso &caso, const Programa &) {
         const glm::ivec3 a = caso.en(m[1], m[2]), b = caso.en(m[4], m[5]);
         const bool bien = m[3] == "como" ? iguales(a, b) : luminancia(a) > luminancia(b) + NIVELES;
         return bien ? "" : dice(a) + " y " + dice(b);
     }},
    {std::regex(COLOR + " (entero|cortado|ausente)"),
     [](const std::smatch &m, const Caso &caso, const Programa &) {
         const glm::ivec2 n = caso.deColor(m[1]);
         const std::string hay = !n.x ? "ausente" : n.y ? "cortado" : "entero";
         const std::string son = std::to_string(n.x) + " píxeles, " + std::to_string(n.y) + " en el borde";
         return hay == m[2] ? "" : hay + ": " + son;
     }},
    {std::regex(COLOR + " " + TRAMO),
     [](const std::smatch &m, const Caso &caso, const Programa &) {
         return caso.entre(caso.deColor(m[1]).x, m[2], m[3]);
     }},
    {std::regex("distinta de (\\w+) en " + TRAMO),
     [](const std::smatch &m, const Caso &caso, const Programa &programa) {
         return caso.entre(caso.distintos(programa[m[1]]), m[2], m[3]);
     }},
};

static std::string lo_que_hay(const std::string &afirmacion, const Caso &caso, const Programa &programa) {
    std::smatch palabras;
    for (const Forma &forma : FORMAS)
        if (std::regex_match(afirmacion, palabras, forma.escrita))
            return forma.hay(palabras, caso, programa);
    falla("no entiendo «" + afirmacion + "»", 2);
}

static bool valePara(const Caso &caso, const Caso &otro, const Programa &programa) {
    const auto lo_es = [&](const std::string &una) { return lo_que_hay(una, otro, programa).empty(); };
    return std::all_of(caso.afirmaciones.begin(), caso.afirmaciones.end(), lo_es) &&
           caso.porcentaje(caso.distintos(otro)) >= CASI_IGUALES;
}

static int juzga(const Programa &programa) {
    int mal = 0;
    for (const Caso &caso : programa.casos) {
        for (const std::string &una : caso.afirmaciones)
            if (const std::string hay = lo_que_hay(una, caso, programa); !hay.empty())
                mal = std::printf("%s: «%s», y hay %s\n", caso.fichero.c_str(), una.c_str(), hay.c_str());
        for (const Caso &otro : programa.casos)
            if (!caso.afirmaciones.empty() && &otro != &caso && valePara(caso, otro, programa))
                mal = std::printf("%s: lo que cumple también lo cumple %s\n", caso.fichero.c_str(),
                                  otro.fichero.c_str());
    }
    return mal != 0;
}

int main(int argc, char **argv) {
    if (argc != 2)
        falla("pies GOLDEN", 2);
    std::vector<Programa> programas;
    for (std::string linea, capitulo, nombre, afirmacion; std::getline(std::cin, linea);) {
        std::istringstream campos(linea);
        Caso caso;
        std::getline(std::getline(std::getline(campos, capitulo, '\t'), nombre, '\t'), caso.fichero, '\t');
        while (std::getline(campos, afirmacion, '\t'))
            caso.afirmaciones.push_back(afirmacion);
        caso.imagen = leePpm(std::string(argv[1]) + "/" + capitulo + "/" + caso.fichero + ".ppm");
        if (programas.empty() || programas.back().nombre != nombre)
            programas.push_back({nombre, {}});
        programas.back().casos.push_back(caso);
    }
    int estado = programas.empty();
    for (const Programa &programa : programas)
        estado |= juzga(programa);
    return estado;
}
