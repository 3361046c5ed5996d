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
#include "texto.h"
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

static int valor(const Imagen &i, int x, int y, int c) {
    return i.rgb[std::size_t(3 * (y * i.ancho + x) + c)];
}

// Cuánto se sale el componente c del píxel (x, y) de los valores que tiene la esperada en los 3×3 de alrededor.
static int exceso(const Imagen &esperada, const Imagen &obtenida, int x, int y, int c) {
    int menor = 255, mayor = 0;
    for (int py = std::max(y - 1, 0); py <= std::min(y + 1, esperada.alto - 1); ++py)
        for (int px = std::max(x - 1, 0); px <= std::min(x + 1, esperada.ancho - 1); ++px) {
            menor = std::min(menor, valor(esperada, px, py, c));
            mayor = std::max(mayor, valor(esperada, px, py, c));
        }
    const int v = valor(obtenida, x, y, c);
    return std::max({menor - v, v - mayor, 0});
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
    const auto cerca = [&](int x, int y, int c) {
        return double(valor(e, std::clamp(x, 0, e.ancho - 1), std::clamp(y, 0, e.alto - 1), c));
    };
    for (int y = 0; y < e.alto; ++y)
        for (int x = 0; x < e.ancho; ++x)
            for (int c = 0; c < 3; ++c) {
                const glm::dvec2 gradiente(cerca(x + 1, y, c) - cerca(x - 1, y, c),
                                           cerca(x, y + 1, c) - cerca(x, y - 1, c));
                A += glm::outerProduct(gradiente, gradiente) / 4.0;
                b += gradiente / 2.0 * double(valor(e, x, y, c) - valor(o, x, y, c));
            }
    return glm::length(glm::inverse(A) * b);
}

enum class Modo { MISMO, REDONDEO, AMPLIA, OTRO };

struct Tolerancia {
    double porcentaje = 0.1; // de los píxeles
    int niveles = 3, maximo = 32;
};

struct Pedido {
    std::vector<std::string> ficheros;
    std::string deja;
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
        else
            p.ficheros.push_back(a);
    }
    if (p.ficheros.size() != 2)
        falla("uso: compara ESPERADA OBTENIDA [--redondeo | --amplia | --otro] [--tolerancia \"% NIVELES "
              "MAXIMO\"] [--deja PREFIJO]",
              2);
    return p;
}

// Lo que se separan dos imágenes. Un píxel está fuera si está a más de `niveles` de lo que debe, y muy fuera a más de
// `maximo`; en porcentaje.
struct Medidas {
    int maximo = 0, maximoExceso = 0, fuera = 0, muyFuera = 0, mancha = 0;
    double media = 0, rmse = 0, porcentajeFuera = 0, porcentajeMuyFuera = 0, corrida = 0;
};

static Medidas mide(const Imagen &e, const Imagen &o, bool otro, const Tolerancia &tolerancia) {
    const double pixeles = double(e.ancho) * e.alto;
    std::vector<int> mal; // cuánto lo está cada píxel
    Medidas m;
    for (int y = 0; y < e.alto; ++y)
        for (int x = 0; x < e.ancho; ++x) {
            int diferencia = 0, sobraOFalta = 0; // lo que se sale de los 3×3 de la otra imagen
            for (int c = 0; c < 3; ++c) {
                const int d = std::abs(valor(e, x, y, c) - valor(o, x, y, c));
                const int sobra = d > 0 ? exceso(e, o, x, y, c) : 0;
                diferencia = std::max(diferencia, d);
                m.maximoExceso = std::max(m.maximoExceso, sobra);
                sobraOFalta = std::max({sobraOFalta, sobra, otro && d > 0 ? exceso(o, e, x, y, c) : 0});
                m.media += d / (3 * pixeles);
                m.rmse += double(d) * d / (3 * pixeles);
            }
            m.maximo = std::max(m.maximo, diferencia);
            mal.push_back(otro ? sobraOFalta : diferencia);
            m.fuera += mal.back() > tolerancia.niveles;
            m.muyFuera += mal.back() > tolerancia.maximo;
        }
    m.rmse = std::sqrt(m.rmse);
    m.porcentajeFuera = 100 * m.fuera / pixeles;
    m.porcentajeMuyFuera = 100 * m.muyFuera / pixeles;
    if (otro) {
        m.mancha = mancha(mal, e.ancho, e.alto);
        m.corrida = corrimiento(e, o);
    }
    return m;
}

// Si se admite, y qué se admite.
static std::pair<bool, std::string> juzga(Modo modo, const Medidas &m, const Tolerancia &t) {
    const bool pocos = m.porcentajeFuera <= t.porcentaje;
    switch (modo) {
    case Modo::MISMO: return {m.maximo == 0, "deben ser idénticas"};
    case Modo::REDONDEO: return {m.maximo <= 1, "a un nivel"};
    case Modo::AMPLIA:
        return {pocos && m.maximoExceso <= t.maximo,
                formatea("tolerancia amplia: el %g %% a más de %d, ninguno a más de %d", t.porcentaje,
                         t.niveles, t.maximo)};
    default:
        return {pocos && m.porcentajeMuyFuera <= t.porcentaje / 10 && m.mancha <= t.maximo &&
                    m.corrida <= 0.25,
                formatea("otro OpenGL: el %g %% a más de %d, la décima parte a más de %d", t.porcentaje,
                         t.niveles, t.maximo)};
    }
}

static void guarda(const std::string &prefijo, const Imagen &e, const Imagen &o) {
    Imagen diferencia = e;
    for (std::size_t i = 0; i < e.rgb.size(); ++i)
        diferencia.rgb[i] =
            static_cast<unsigned char>(std::min(8 * std::abs(int{e.rgb[i]} - int{o.rgb[i]}), 255));
    guardaPpm(prefijo + "-esperada.ppm", e);
    guardaPpm(prefijo + "-obtenida.ppm", o);
    guardaPpm(prefijo + "-diferencia.ppm", diferencia);
    std::printf("imágenes en %s-*.ppm\n", prefijo.c_str()); // las busca herramientas/pruebas/fallos.py
}

int main(int argc, char **argv) {
    const Pedido pedido = leeArgumentos(argc, argv);
    const std::string &esperada = pedido.ficheros[0], &obtenida = pedido.ficheros[1];
    std::string sello, suyo;
    const Imagen e = leePpm(esperada, &sello), o = leePpm(obtenida, &suyo);
    const bool mismo = pedido.modo == Modo::MISMO || pedido.modo == Modo::REDONDEO;
    if (sello.empty() || (suyo.empty() && mismo))
        falla("«" + (sello.empty() ? esperada : obtenida) +
                  "» no lleva el sello de quién la hizo: no se sabe cuánto puede diferir",
              2);
    if (e.ancho != o.ancho || e.alto != o.alto)
        falla("«" + esperada + formatea("» mide %d×%d y «", e.ancho, e.alto) + obtenida +
                  formatea("» %d×%d", o.ancho, o.alto),
              2);
    const Modo modo = sello == suyo || pedido.modo == Modo::OTRO ? pedido.modo : Modo::AMPLIA;
    const bool otro = modo == Modo::OTRO;
    const Tolerancia t = pedido.tolerancia.value_or(Tolerancia{otro ? 1 : 0.1, 3, 32});
    const Medidas m = mide(e, o, otro, t);
    const auto [bien, seAdmite] = juzga(modo, m, t);
    const std::string psnr = m.rmse > 0 ? formatea("%.1f", 20 * std::log10(255 / m.rmse)) : "inf";
    std::printf("%s: máximo %d (fuera de los bordes %d), media %.4f, RMSE %.4f, PSNR %s dB, ",
                bien ? "bien" : "DISTINTAS", m.maximo, m.maximoExceso, m.media, m.rmse, psnr.c_str());
    std::printf("%d píxeles a más de %d niveles (%.3f %%)", m.fuera, t.niveles, m.porcentajeFuera);
    if (otro)
        std::printf(", %d a más de %d (%.3f %%), mancha %d, corrida %.2f píxeles", m.muyFuera, t.maximo,
                    m.porcentajeMuyFuera, m.mancha, m.corrida);
    std::printf("; %s; hecha con %s\n", seAdmite.c_str(),
                suyo.empty() ? "un renderizador sin sello" : suyo.c_str());
    if (!bien && !pedido.deja.empty())
        guarda(pedido.deja, e, o);
    return bien ? 0 : 1;
}
