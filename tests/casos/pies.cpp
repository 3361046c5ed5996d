// pies CASO "AFIRMACIÓN; …" [CASO "…"]…: comprueba que cada imagen de la carpeta de trabajo, CASO-TALLA.ppm a las tres
// TALLAS, es como afirma el CUMPLE de su caso, con las palabras que explica herramientas/cmake/programa.cmake, y que
// ninguna otra lo es: un pie que vale para la imagen de al lado no dice nada de la suya. Salvo las casi iguales.
// Estado: 0 si todas lo son; 1 si alguna no, y dice cuál y qué hay; 2 si una está mal escrita.
#include "colores.h"
#include "error.h"
#include "imagen.h"
#include "numero.h"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

static const std::vector<std::string> TALLAS = {"480x360", "960x720", "960x1080"};
static const int NIVELES = 12;
static const double CASI_IGUALES = 1; // % de píxeles distintos: las separa un rótulo
static const double PENUMBRA = 0.25;  // lo menos iluminado que es del color de un objeto

static const std::map<std::string, glm::vec3> COLORES = {{"ROJO", ROJO},
                                                         {"VERDE", VERDE},
                                                         {"AZUL", AZUL},
                                                         {"NARANJA", NARANJA},
                                                         {"AMARILLO", AMARILLO},
                                                         {"MORADO", MORADO},
                                                         {"GRIS", GRIS},
                                                         {"OSCURO", OSCURO},
                                                         {"BLANCO", BLANCO},
                                                         {"NEGRO", {0, 0, 0}},
                                                         {"CIELO", CIELO},
                                                         {"SUELO", SUELO},
                                                         {"FONDO_CLARO", FONDO_CLARO},
                                                         {"FONDO_OSCURO", FONDO_OSCURO}};

// Las palabras de una afirmación, de las que se va tomando la primera.
struct Frase {
    std::string entera;
    std::istringstream palabras;
    explicit Frase(const std::string &texto) : entera(texto), palabras(texto) {
    }
    [[noreturn]] void mal() const {
        falla("no entiendo «" + entera + "»", 2);
    }
    std::string palabra() {
        std::string p;
        palabras >> p;
        return p;
    }
    void exige(const std::string &esperada) {
        std::istringstream son(esperada);
        for (std::string p; son >> p;)
            if (palabra() != p)
                mal();
    }
    double numero() {
        const auto n = numeroDe<double>(palabra());
        return n ? *n : (mal(), 0);
    }
    double fraccion() {
        const double n = numero();
        return n >= 0 && n < 1 ? n : (mal(), 0);
    }
    glm::ivec3 color(const std::string &nombre) const {
        if (const auto c = COLORES.find(nombre); c != COLORES.end())
            return glm::ivec3(255.0f * c->second + 0.5f);
        int r = 0, g = 0, b = 0, leido = 0;
        if (std::sscanf(nombre.c_str(), "(%d,%d,%d)%n", &r, &g, &b, &leido) != 3 ||
            leido != static_cast<int>(nombre.size()))
            mal();
        return {r, g, b};
    }
    void acaba() {
        if (!palabra().empty())
            mal();
    }
};

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

struct Foto {
    Imagen imagen;
    int x0, y0, ancho, alto; // el 4:3 central
    explicit Foto(const std::string &fichero) : imagen(leePpm(fichero)) {
        ancho = std::min(imagen.ancho, imagen.alto * 4 / 3);
        alto = std::min(imagen.alto, imagen.ancho * 3 / 4);
        x0 = (imagen.ancho - ancho) / 2;
        y0 = (imagen.alto - alto) / 2;
    }
    // De arriba abajo.
    glm::ivec3 pixel(int x, int y) const {
        const std::size_t i = std::size_t(3 * ((imagen.alto - 1 - y) * imagen.ancho + x));
        return {imagen.rgb[i], imagen.rgb[i + 1], imagen.rgb[i + 2]};
    }
    glm::ivec3 en(double x, double y) const {
        return pixel(x0 + int(x * ancho), y0 + int(y * alto));
    }
    template<class Que>
    double porcentaje(Que que) const {
        int suyos = 0;
        for (int y = y0; y < y0 + alto; ++y)
            for (int x = x0; x < x0 + ancho; ++x)
                suyos += que(x, y);
        return 100.0 * suyos / (double(ancho) * alto);
    }
    // Cuántos píxeles de la ventana, y cuántos de su borde.
    template<class Que>
    glm::ivec2 cuenta(Que que) const {
        glm::ivec2 n(0);
        for (int y = 0; y < imagen.alto; ++y)
            for (int x = 0; x < imagen.ancho; ++x)
                if (que(x, y)) {
                    ++n.x;
                    n.y += x == 0 || y == 0 || x == imagen.ancho - 1 || y == imagen.alto - 1;
                }
        return n;
    }
};

// Cada una devuelve lo que hay, si no es lo que se afirma.
static std::string entre(double hay, const std::optional<double> &de, Frase &f) {
    if (!de)
        f.mal();
    f.exige("a");
    const double a = f.numero();
    f.exige("%");
    char texto[32];
    std::snprintf(texto, sizeof texto, "%.3g %%", hay);
    return hay >= *de && hay <= a ? "" : texto;
}

static std::string enUnPunto(const Foto &foto, Frase &f) {
    const double x = f.fraccion(), y = f.fraccion();
    const glm::ivec3 hay = foto.en(x, y);
    const std::string que = f.palabra();
    if (que != "como" && que != "más")
        return iguales(hay, f.color(que)) ? "" : dice(hay);
    if (que == "más")
        f.exige("claro que");
    const double otraX = f.fraccion(), otraY = f.fraccion();
    const glm::ivec3 otro = foto.en(otraX, otraY);
    const bool bien = que == "como" ? iguales(hay, otro) : luminancia(hay) > luminancia(otro) + NIVELES;
    return bien ? "" : dice(hay) + " y " + dice(otro);
}

static std::string comparada(const Foto &foto, const std::string &talla, bool distinta, Frase &f) {
    f.exige(distinta ? "de" : "que");
    const std::string caso = f.palabra();
    if (caso.empty())
        f.mal();
    const Foto otra(caso + "-" + talla + ".ppm");
    const auto cambia = [&](int x, int y) { return !iguales(foto.pixel(x, y), otra.pixel(x, y)); };
    if (distinta) {
        f.exige("en");
        return entre(foto.porcentaje(cambia), f.numero(), f);
    }
    const int cuantos = foto.cuenta(cambia).x;
    return cuantos ? std::to_string(cuantos) + " píxeles distintos" : "";
}

static std::string deUnColor(const Foto &foto, const std::string &nombre, Frase &f) {
    const glm::ivec3 color = f.color(nombre);
    const auto suyo = [&](int x, int y) { return delColor(foto.pixel(x, y), color); };
    const std::string como = f.palabra();
    if (como != "entero" && como != "cortado" && como != "ausente")
        return entre(foto.porcentaje(suyo), numeroDe<double>(como), f);
    const glm::ivec2 n = foto.cuenta(suyo);
    const std::string hay = !n.x ? "ausente" : n.y ? "cortado" : "entero";
    return hay == como
               ? ""
               : hay + ": " + std::to_string(n.x) + " píxeles, " + std::to_string(n.y) + " en el borde";
}

static std::string juzga(const std::string &afirmacion, const Foto &foto, const std::string &talla) {
    Frase f(afirmacion);
    const std::string primera = f.palabra();
    const std::string hay = primera == "en"         ? enUnPunto(foto, f)
                            : primera == "distinta" ? comparada(foto, talla, true, f)
                            : primera == "igual"    ? comparada(foto, talla, false, f)
                                                    : deUnColor(foto, primera, f);
    f.acaba();
    return hay;
}

struct Afirmacion {
    std::string texto, dicho; // como está escrita, y sin su «a 4:3: »
    bool solo43;
};

static std::vector<Afirmacion> separa(const std::string &cumple) {
    const std::string SOLO = "a 4:3: ";
    std::vector<Afirmacion> afirmaciones;
    std::istringstream son(cumple);
    for (std::string una; std::getline(son, una, ';');) {
        una.erase(0, una.find_first_not_of(' '));
        const bool solo43 = una.rfind(SOLO, 0) == 0;
        afirmaciones.push_back({una, solo43 ? una.substr(SOLO.size()) : una, solo43});
    }
    return afirmaciones;
}

// Si todas son de las imágenes de ese caso; las que no, con `dicho`, se dicen.
static bool sonDe(const std::vector<Afirmacion> &afirmaciones, const std::string &caso, bool dicho) {
    bool todas = true;
    for (const Afirmacion &a : afirmaciones)
        for (const std::string &talla : TALLAS) {
            if (a.solo43 && talla == TALLAS.back())
                continue;
            const std::string hay = juzga(a.dicho, Foto(caso + "-" + talla + ".ppm"), talla);
            if (hay.empty())
                continue;
            if (!dicho)
                return false;
            std::printf("%s, a %s: «%s», y hay %s\n", caso.c_str(), talla.c_str(), a.texto.c_str(),
                        hay.c_str());
            todas = false;
        }
    return todas;
}

static bool casiIguales(const std::string &una, const std::string &otra) {
    const Foto a(una + "-" + TALLAS[0] + ".ppm"), b(otra + "-" + TALLAS[0] + ".ppm");
    return a.porcentaje([&](int x, int y) { return !iguales(a.pixel(x, y), b.pixel(x, y)); }) < CASI_IGUALES;
}

int main(int argc, char **argv) {
    int estado = 0;
    for (int i = 1; i + 1 < argc; i += 2) {
        const std::string caso = argv[i];
        const std::vector<Afirmacion> afirmaciones = separa(argv[i + 1]);
        if (!sonDe(afirmaciones, caso, true))
            estado = 1;
        for (int j = 1; j + 1 < argc && !afirmaciones.empty(); j += 2)
            if (j != i && sonDe(afirmaciones, argv[j], false) && !casiIguales(caso, argv[j])) {
                std::printf("%s: lo que cumple también lo cumple %s\n", caso.c_str(), argv[j]);
                estado = 1;
            }
    }
    return estado;
}
