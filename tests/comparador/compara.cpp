// compara ESPERADA.ppm OBTENIDA.ppm [--redondeo | --amplia] [--tolerancia "PORCENTAJE NIVELES MAXIMO"] [--deja PREFIJO]
// Compara los tres componentes de dos imágenes y escribe siempre las cifras. Si las hizo el mismo OpenGL en el mismo
// entorno (el sello de la cabecera es igual) deben ser idénticas o, con --redondeo, a un nivel como mucho. Si no, o con
// --amplia, a lo sumo un 0.1 % de los píxeles puede diferir en más de 3 niveles de 255, y ninguno puede salirse en más
// de 32 de los valores que la esperada tiene en los 3×3 píxeles de alrededor: en el borde de una figura un píxel entero
// puede ser de otro color con solo que otro OpenGL redondee de otra manera, y ahí lo que se acota es cuántos.
// Estado: 0 iguales; 1 distintas; 2 no se pueden comparar, y la que no lleva sello tampoco (con --amplia, solo la
// esperada). Si son distintas, --deja guarda PREFIJO-esperada, -obtenida y -diferencia (ampliada 8 veces).
#include "error.h"
#include "imagen.h"
#include "numero.h"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>

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
    bool amplia = false, redondeo = false;
    Tolerancia tolerancia;
    for (int i = 1; i < argc; ++i) {
        const std::string a = argv[i];
        if (a == "--amplia")
            amplia = true;
        else if (a == "--redondeo")
            redondeo = true;
        else if (a == "--deja" && i + 1 < argc)
            deja = argv[++i];
        else if (a == "--tolerancia" && i + 1 < argc) {
            tolerancia = leeTolerancia(argv[++i]);
        } else if (esperada.empty())
            esperada = a;
        else if (obtenida.empty())
            obtenida = a;
        else
            falla("sobra «" + a + "»", 2);
    }
    if (obtenida.empty())
        falla("uso: compara ESPERADA OBTENIDA [--redondeo | --amplia] [--tolerancia \"% NIVELES MAXIMO\"] "
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

    int maximo = 0, maximoExceso = 0, fuera = 0;
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
            fuera += delPixel > tolerancia.niveles;
        }
    const double n = static_cast<double>(e.rgb.size()), rmse = std::sqrt(cuadrados / n);
    const double porcentaje = 100.0 * fuera / (n / 3);
    const bool exacta = !amplia && selloEsperada == selloObtenida;
    const bool bien = exacta ? maximo <= redondeo
                             : porcentaje <= tolerancia.porcentaje && maximoExceso <= tolerancia.maximo;

    char psnr[32] = "inf";
    if (rmse > 0)
        std::snprintf(psnr, sizeof psnr, "%.1f", 20 * std::log10(255 / rmse));
    std::printf("%s: máximo %d (fuera de los bordes %d), media %.4f, RMSE %.4f, PSNR %s dB, %d píxeles a más "
                "de %d niveles (%.3f %%); "
                "%s; hecha con %s\n",
                bien ? "bien" : "DISTINTAS", maximo, maximoExceso, suma / n, rmse, psnr, fuera,
                tolerancia.niveles, porcentaje,
                !exacta    ? "tolerancia amplia"
                : redondeo ? "a un nivel"
                           : "deben ser idénticas",
                selloObtenida.empty() ? "un renderizador sin sello" : selloObtenida.c_str());
    if (!bien && !deja.empty()) {
        guardaPpm(deja + "-esperada.ppm", e);
        guardaPpm(deja + "-obtenida.ppm", o);
        guardaPpm(deja + "-diferencia.ppm", diferencia);
    }
    return bien ? 0 : 1;
}
