// compara ESPERADA.ppm OBTENIDA.ppm [--redondeo | --amplia | --otro] [--tolerancia "PORCENTAJE NIVELES MAXIMO"]
//   [--deja PREFIJO]
// Compara los tres componentes de dos imágenes y escribe siempre las cifras. Si las hizo el mismo OpenGL en el mismo
// entorno (el sello de la cabecera es igual) deben ser idénticas o, con --redondeo, a un nivel como mucho. Si no, o con
// --amplia, a lo sumo un 0.1 % de los píxeles puede diferir en más de 3 niveles de 255, y ninguno puede salirse en más
// de 32 de los valores que la esperada tiene en los 3×3 píxeles de alrededor: en el borde de una figura un píxel entero
// puede ser de otro color con solo que otro OpenGL redondee de otra manera, y ahí lo que se acota es cuántos.
// --otro, con cualquier otro OpenGL, es que una persona las tenga por la misma: dónde cae un borde no cuenta, sí lo que
// sobra o falta. Un píxel está mal en lo que se sale de los 3×3 de la otra, en los dos sentidos: en más de 3 niveles,
// el 1 % como mucho; en más de 32, ni la décima parte de eso ni 3×3 juntos, que se ven como una mancha. Y como una
// imagen corrida tiene todos sus bordes a un píxel, toda ella no puede haberse movido más de un cuarto de píxel.
// Estado: 0 iguales; 1 distintas; 2 no se pueden comparar, y la que no lleva sello tampoco (con --amplia y --otro, solo
// la esperada). Si son distintas, --deja guarda PREFIJO-esperada, -obtenida y -diferencia (ampliada 8 veces).
#include "error.h"
#include "imagen.h"
#include "numero.h"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

// Cuánto se sale el componente c del píxel (x, y) de los valores que tiene la esperada en los 3×3 de alrededor.
static int exceso(const Imagen &esperada, const Imagen &obtenida, int x, int y, int c) {
    const auto valor = [c](const Imagen &i, int px, int py) {
        return int{i.rgb[static_cast<std::size_t>(3 * (py * i.ancho + px) + c)]};
    };
    int menor = 255, mayor = 0;
    for (int py = std::max(y - 1, 0); py <= std::min(y + 1, esperada.alto - 1); ++py)
        for (int px = std::max(x - 1, 0); px <= std::min(x + 1, esperada.ancho - 1); ++px) {
            menor = std::min(menor, valor(esperada, px, py));
            mayor = std::max(mayor, valor(esperada, px, py));
        }
    const int v = valor(obtenida, x, y);
    return std::max({menor - v, v - mayor, 0});
}

// Lo que sobra o falta en cada píxel: lo que se sale de los 3×3 de la otra imagen.
static std::vector<int> sobraOFalta(const Imagen &a, const Imagen &b) {
    std::vector<int> mal;
    for (int y = 0; y < a.alto; ++y)
        for (int x = 0; x < a.ancho; ++x) {
            int delPixel = 0;
            for (int c = 0; c < 3; ++c)
                delPixel = std::max({delPixel, exceso(a, b, x, y, c), exceso(b, a, x, y, c)});
            mal.push_back(delPixel);
        }
    return mal;
}

// El cuadrado de 3×3 que está peor, por su mejor píxel.
static int mancha(const std::vector<int> &mal, int ancho, int alto) {
    int peor = 0;
    for (int y = 0; y + 3 <= alto; ++y)
        for (int x = 0; x + 3 <= ancho; ++x) {
            int mejor = 255;
            for (int i = 0; i < 9; ++i)
                mejor = std::min(mejor, mal[std::size_t((y + i / 3) * ancho + x + i % 3)]);
            peor = std::max(peor, mejor);
        }
    return peor;
}

// Los píxeles que se ha corrido: el desplazamiento d con que e − ∇e·d se acerca más a o, por mínimos cuadrados.
static double corrimiento(const Imagen &e, const Imagen &o) {
    glm::dmat2 A(1e-9);
    glm::dvec2 b(0);
    const auto valor = [&](int x, int y, int c) {
        x = std::clamp(x, 0, e.ancho - 1), y = std::clamp(y, 0, e.alto - 1);
        return double(e.rgb[std::size_t(3 * (y * e.ancho + x) + c)]);
    };
    for (int y = 0; y < e.alto; ++y)
        for (int x = 0; x < e.ancho; ++x)
            for (int c = 0; c < 3; ++c) {
                const glm::dvec2 gradiente(valor(x + 1, y, c) - valor(x - 1, y, c),
                                           valor(x, y + 1, c) - valor(x, y - 1, c));
                A += glm::outerProduct(gradiente, gradiente) / 4.0;
                b += gradiente / 2.0 *
                     (valor(x, y, c) - double(o.rgb[std::size_t(3 * (y * e.ancho + x) + c)]));
            }
    return glm::length(glm::inverse(A) * b);
}

enum class Modo { MISMO, REDONDEO, AMPLIA, OTRO };

struct Tolerancia {
    double porcentaje = 0.1; // de los píxeles
    int niveles = 3, maximo = 32;
};

struct Pedido {
    std::string esperada, obtenida, deja;
    Modo modo = Modo::MISMO;
    std::optional<Tolerancia> tolerancia;
};

static Tolerancia leeTolerancia(const std::string &texto) {
    std::istringstream palabras(texto);
    std::string porcentaje, niveles, maximo, sobra;
    palabras >> porcentaje >> niveles >> maximo >> sobra;
    const auto p = numeroDe<double>(porcentaje);
    const auto n = numeroDe<int>(niveles), m = numeroDe<int>(maximo);
    if (!p || !n || !m || !(*p >= 0) || *n < 0 || *m < 0 || !sobra.empty())
        falla("--tolerancia «" + texto + "»: son PORCENTAJE NIVELES MAXIMO", 2);
    return {*p, *n, *m};
}

static Pedido leeArgumentos(int argc, char **argv) {
    static const std::map<std::string, Modo> MODOS = {
        {"--redondeo", Modo::REDONDEO}, {"--amplia", Modo::AMPLIA}, {"--otro", Modo::OTRO}};
    Pedido p;
    for (int i = 1; i < argc; ++i) {
        const std::string a = argv[i];
        if (const auto modo = MODOS.find(a); modo != MODOS.end())
            p.modo = modo->second;
        else if (a == "--deja" && i + 1 < argc)
            p.deja = argv[++i];
        else if (a == "--tolerancia" && i + 1 < argc)
            p.tolerancia = leeTolerancia(argv[++i]);
        else if (p.esperada.empty())
            p.esperada = a;
        else if (p.obtenida.empty())
            p.obtenida = a;
        else
            falla("sobra «" + a + "»", 2);
    }
    if (p.obtenida.empty())
        falla("uso: compara ESPERADA OBTENIDA [--redondeo | --amplia | --otro] [--tolerancia \"% NIVELES "
              "MAXIMO\"] [--deja PREFIJO]",
              2);
    return p;
}

struct Sellada {
    std::string fichero, sello;
    Imagen imagen;
    explicit Sellada(const std::string &cual) : fichero(cual), imagen(leePpm(cual, &sello)) {
    }
    std::string talla() const {
        return std::to_string(imagen.ancho) + "×" + std::to_string(imagen.alto);
    }
};

static void exigeComparables(const Sellada &e, const Sellada &o, Modo modo) {
    const bool valeSinSello = modo == Modo::AMPLIA || modo == Modo::OTRO;
    if (e.sello.empty() || (o.sello.empty() && !valeSinSello))
        falla("«" + (e.sello.empty() ? e : o).fichero +
                  "» no lleva el sello de quién la hizo: no se sabe cuánto puede diferir",
              2);
    if (e.talla() != o.talla())
        falla("«" + e.fichero + "» mide " + e.talla() + " y «" + o.fichero + "» " + o.talla(), 2);
}

// Lo que se separan dos imágenes. Un píxel está fuera si está a más de `niveles` de lo que debe, y muy fuera a más de
// `maximo`; en porcentaje.
struct Medidas {
    int maximo = 0, maximoExceso = 0, fuera = 0, muyFuera = 0, mancha = 0;
    double media = 0, rmse = 0, porcentajeFuera = 0, porcentajeMuyFuera = 0, corrida = 0;
};

static std::vector<int> diferencias(const Imagen &e, const Imagen &o) {
    std::vector<int> d(e.rgb.size());
    for (std::size_t i = 0; i < d.size(); ++i)
        d[i] = std::abs(int{e.rgb[i]} - int{o.rgb[i]});
    return d;
}

static Medidas mide(const Imagen &e, const Imagen &o, bool otro, const Tolerancia &tolerancia) {
    const std::vector<int> d = diferencias(e, o);
    const double pixeles = double(e.ancho) * e.alto;
    std::vector<int> mal; // cuánto lo está cada píxel
    Medidas m;
    double suma = 0, cuadrados = 0;
    for (std::size_t i = 0; i < d.size(); ++i) {
        const int pixel = int(i / 3), c = int(i % 3);
        if (c == 0)
            mal.push_back(0);
        mal.back() = std::max(mal.back(), d[i]);
        if (d[i] > 0)
            m.maximoExceso = std::max(m.maximoExceso, exceso(e, o, pixel % e.ancho, pixel / e.ancho, c));
        suma += d[i];
        cuadrados += double(d[i]) * d[i];
    }
    m.media = suma / (3 * pixeles);
    m.rmse = std::sqrt(cuadrados / (3 * pixeles));
    m.maximo = *std::max_element(mal.begin(), mal.end());
    if (otro) {
        mal = sobraOFalta(e, o);
        m.mancha = mancha(mal, e.ancho, e.alto);
        m.corrida = corrimiento(e, o);
    }
    for (const int cuanto : mal) {
        m.fuera += cuanto > tolerancia.niveles;
        m.muyFuera += cuanto > tolerancia.maximo;
    }
    m.porcentajeFuera = 100 * m.fuera / pixeles;
    m.porcentajeMuyFuera = 100 * m.muyFuera / pixeles;
    return m;
}

static bool admite(Modo modo, const Medidas &m, const Tolerancia &t) {
    switch (modo) {
    case Modo::MISMO: return m.maximo == 0;
    case Modo::REDONDEO: return m.maximo <= 1;
    case Modo::AMPLIA: return m.porcentajeFuera <= t.porcentaje && m.maximoExceso <= t.maximo;
    case Modo::OTRO:
        return m.porcentajeFuera <= t.porcentaje && m.porcentajeMuyFuera <= t.porcentaje / 10 &&
               m.mancha <= t.maximo && m.corrida <= 0.25;
    }
    return false;
}

// Como std::printf, en un std::string.
template<class... Valores>
static std::string texto(const char *formato, const Valores &...valores) {
    char s[160];
    std::snprintf(s, sizeof s, formato, valores...);
    return s;
}

static std::string queSeAdmite(Modo modo, const Tolerancia &t) {
    switch (modo) {
    case Modo::MISMO: return "deben ser idénticas";
    case Modo::REDONDEO: return "a un nivel";
    case Modo::AMPLIA:
        return texto("tolerancia amplia: el %g %% a más de %d, ninguno a más de %d", t.porcentaje, t.niveles,
                     t.maximo);
    case Modo::OTRO:
        return texto("otro OpenGL: el %g %% a más de %d, la décima parte a más de %d", t.porcentaje,
                     t.niveles, t.maximo);
    }
    return "";
}

static void escribe(Modo modo, const Medidas &m, const Tolerancia &t, bool bien, const std::string &sello) {
    const std::string psnr = m.rmse > 0 ? texto("%.1f", 20 * std::log10(255 / m.rmse)) : "inf";
    std::printf("%s: máximo %d (fuera de los bordes %d), media %.4f, RMSE %.4f, PSNR %s dB, ",
                bien ? "bien" : "DISTINTAS", m.maximo, m.maximoExceso, m.media, m.rmse, psnr.c_str());
    std::printf("%d píxeles a más de %d niveles (%.3f %%)", m.fuera, t.niveles, m.porcentajeFuera);
    if (modo == Modo::OTRO)
        std::printf(", %d a más de %d (%.3f %%), mancha %d, corrida %.2f píxeles", m.muyFuera, t.maximo,
                    m.porcentajeMuyFuera, m.mancha, m.corrida);
    std::printf("; %s; hecha con %s\n", queSeAdmite(modo, t).c_str(),
                sello.empty() ? "un renderizador sin sello" : sello.c_str());
}

static void guarda(const std::string &prefijo, const Imagen &e, const Imagen &o) {
    Imagen diferencia = e;
    const std::vector<int> d = diferencias(e, o);
    std::transform(d.begin(), d.end(), diferencia.rgb.begin(),
                   [](int x) { return static_cast<unsigned char>(std::min(8 * x, 255)); });
    guardaPpm(prefijo + "-esperada.ppm", e);
    guardaPpm(prefijo + "-obtenida.ppm", o);
    guardaPpm(prefijo + "-diferencia.ppm", diferencia);
    std::printf("imágenes en %s-*.ppm\n", prefijo.c_str()); // las busca herramientas/pruebas/fallos.py
}

int main(int argc, char **argv) {
    const Pedido pedido = leeArgumentos(argc, argv);
    const Sellada e(pedido.esperada), o(pedido.obtenida);
    exigeComparables(e, o, pedido.modo);
    const bool delMismo = e.sello == o.sello || pedido.modo == Modo::OTRO;
    const Modo modo = delMismo ? pedido.modo : Modo::AMPLIA;
    const Tolerancia t =
        pedido.tolerancia.value_or(modo == Modo::OTRO ? Tolerancia{1, 3, 32} : Tolerancia{0.1, 3, 32});
    const Medidas m = mide(e.imagen, o.imagen, modo == Modo::OTRO, t);
    const bool bien = admite(modo, m, t);
    escribe(modo, m, t, bien, o.sello);
    if (!bien && !pedido.deja.empty())
        guarda(pedido.deja, e.imagen, o.imagen);
    return bien ? 0 : 1;
}
