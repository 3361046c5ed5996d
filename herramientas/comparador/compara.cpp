// compara ESPERADA.ppm OBTENIDA.ppm [--redondeo | --amplia | --otro] [--tolerancia "PORCENTAJE NIVELES MAXIMO"] [--deja PREFIJO]
// Compara los tres componentes de dos imágenes y escribe siempre las cifras. Si las hizo el mismo OpenGL en el mismo
// entorno (el sello de la cabecera es igual) deben ser idénticas o, con --redondeo, a un nivel como mucho. Si no, o con
// --amplia, a lo sumo un 0.1 % de los píxeles puede diferir en más de 3 niveles de 255, y ninguno puede salirse en más
// de 32 de los valores que la esperada tiene en los 3×3 píxeles de alrededor: en el borde de una figura un píxel entero
// puede ser de otro color con solo que otro OpenGL redondee de otra manera, y ahí lo que se acota es cuántos.
// --otro, con cualquier otro OpenGL, es que una persona las tenga por la misma: dónde cae un borde no cuenta, sí lo que
// sobra o falta. Un píxel está mal en lo que se sale de los 3×3 de la otra, en los dos sentidos: en más de 3 niveles, el
// 1 % como mucho; en más de 32, ni la décima parte de eso ni 3×3 juntos, que se ven como una mancha. Y como una imagen
// corrida tiene todos sus bordes a un píxel, toda ella no puede haberse movido más de un cuarto de píxel.
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
#include <optional>
#include <sstream>
#include <string>
#include <vector>

/// Cuánto se sale el componente c del píxel (x, y) de los valores que tiene la esperada en los 3×3 de alrededor.
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

/// Lo que sobra o falta en cada píxel: lo que se sale de los 3×3 de la otra imagen.
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

/// El cuadrado de 3×3 que está peor, por su mejor píxel.
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

/// Los píxeles que se ha corrido: el desplazamiento d con que e − ∇e·d se acerca más a o, por mínimos cuadrados.
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

struct Tolerancia {
    double porcentaje = 0.1; // de los píxeles
    int niveles = 3, maximo = 32;
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

int main(int argc, char **argv) {
    std::string esperada, obtenida, deja;
    bool amplia = false, redondeo = false, otro = false;
    std::optional<Tolerancia> pedida;
    for (int i = 1; i < argc; ++i) {
        const std::string a = argv[i];
        if (a == "--amplia")
            amplia = true;
        else if (a == "--redondeo")
            redondeo = true;
        else if (a == "--otro")
            otro = amplia = true;
        else if (a == "--deja" && i + 1 < argc)
            deja = argv[++i];
        else if (a == "--tolerancia" && i + 1 < argc)
            pedida = leeTolerancia(argv[++i]);
        else if (esperada.empty())
            esperada = a;
        else if (obtenida.empty())
            obtenida = a;
        else
            falla("sobra «" + a + "»", 2);
    }
    if (obtenida.empty())
        falla("uso: compara ESPERADA OBTENIDA [--redondeo | --amplia | --otro] [--tolerancia \"% NIVELES "
              "MAXIMO\"] "
              "[--deja PREFIJO]",
              2);

    std::string selloEsperada, selloObtenida;
    const Imagen e = leePpm(esperada, &selloEsperada), o = leePpm(obtenida, &selloObtenida);
    if (selloEsperada.empty() || (selloObtenida.empty() && !amplia))
        falla("«" + (selloEsperada.empty() ? esperada : obtenida) +
                  "» no lleva el sello de quién la hizo: no se sabe cuánto puede diferir",
              2);
    if (e.ancho != o.ancho || e.alto != o.alto)
        falla("«" + esperada + "» mide " + std::to_string(e.ancho) + "×" + std::to_string(e.alto) + " y «" +
                  obtenida + "» " + std::to_string(o.ancho) + "×" + std::to_string(o.alto),
              2);

    const Tolerancia tolerancia = pedida.value_or(otro ? Tolerancia{1, 3, 32} : Tolerancia{0.1, 3, 32});
    const std::vector<int> mal = otro ? sobraOFalta(e, o) : std::vector<int>();
    int maximo = 0, maximoExceso = 0, fuera = 0, muyFuera = 0;
    double suma = 0, cuadrados = 0;
    Imagen diferencia{e.ancho, e.alto, std::vector<unsigned char>(e.rgb.size())};
    for (int y = 0; y < e.alto; ++y)
        for (int x = 0; x < e.ancho; ++x) {
            int delPixel = 0;
            for (int c = 0; c < 3; ++c) {
                const std::size_t i = static_cast<std::size_t>(3 * (y * e.ancho + x) + c);
                const int d = std::abs(int{e.rgb[i]} - int{o.rgb[i]});
                delPixel = std::max(delPixel, d);
                if (d > 0)
                    maximoExceso = std::max(maximoExceso, exceso(e, o, x, y, c));
                suma += d;
                cuadrados += static_cast<double>(d) * d;
                diferencia.rgb[i] = static_cast<unsigned char>(std::min(8 * d, 255));
            }
            maximo = std::max(maximo, delPixel);
            const int cuenta = otro ? mal[std::size_t(y * e.ancho + x)] : delPixel;
            fuera += cuenta > tolerancia.niveles;
            muyFuera += cuenta > tolerancia.maximo;
        }
    const double n = static_cast<double>(e.rgb.size()), rmse = std::sqrt(cuadrados / n);
    const double porcentaje = 100.0 * fuera / (n / 3), muchos = 100.0 * muyFuera / (n / 3);
    const bool exacta = !amplia && selloEsperada == selloObtenida;
    bool bien = exacta ? maximo <= redondeo
                       : porcentaje <= tolerancia.porcentaje && (otro || maximoExceso <= tolerancia.maximo);
    std::string comoOtro;
    if (otro) {
        const int m = mancha(mal, e.ancho, e.alto);
        const double corrida = corrimiento(e, o);
        bien = bien && muchos <= tolerancia.porcentaje / 10 && m <= tolerancia.maximo && corrida <= 0.25;
        char texto[120];
        std::snprintf(texto, sizeof texto, ", %d a más de %d (%.3f %%), mancha %d, corrida %.2f píxeles",
                      muyFuera, tolerancia.maximo, muchos, m, corrida);
        comoOtro = texto;
    }

    char admite[120];
    std::snprintf(admite, sizeof admite, "%s: el %g %% a más de %d, %s a más de %d",
                  otro ? "otro OpenGL" : "tolerancia amplia", tolerancia.porcentaje, tolerancia.niveles,
                  otro ? "la décima parte" : "ninguno", tolerancia.maximo);
    char psnr[32] = "inf";
    if (rmse > 0)
        std::snprintf(psnr, sizeof psnr, "%.1f", 20 * std::log10(255 / rmse));
    std::printf("%s: máximo %d (fuera de los bordes %d), media %.4f, RMSE %.4f, PSNR %s dB, %d píxeles a más "
                "de %d niveles (%.3f %%)%s; %s; hecha con %s\n",
                bien ? "bien" : "DISTINTAS", maximo, maximoExceso, suma / n, rmse, psnr, fuera,
                tolerancia.niveles, porcentaje, comoOtro.c_str(),
                !exacta    ? admite
                : redondeo ? "a un nivel"
                           : "deben ser idénticas",
                selloObtenida.empty() ? "un renderizador sin sello" : selloObtenida.c_str());
    if (!bien && !deja.empty()) {
        guardaPpm(deja + "-esperada.ppm", e);
        guardaPpm(deja + "-obtenida.ppm", o);
        guardaPpm(deja + "-diferencia.ppm", diferencia);
        std::printf("imágenes en %s-*.ppm\n", deja.c_str()); // las busca herramientas/pruebas/fallos.py
    }
    return bien ? 0 : 1;
}
