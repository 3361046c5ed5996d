#include "imagenes.h"
#include <algorithm>
#include <map>

namespace explica {
namespace {

const int ANCHO = 240; // de una miniatura, como mucho

struct Imagen {
    int ancho = 0, alto = 0, canales = 1;
    std::vector<unsigned char> bytes; // fila a fila desde arriba
};

std::string enBase64(const std::vector<unsigned char> &bytes) {
    const char *const LETRAS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string texto;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned tres = 0;
        for (std::size_t k = 0; k < 3; ++k)
            tres = tres << 8 | (i + k < bytes.size() ? bytes[i + k] : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            texto += i + k > bytes.size() ? '=' : LETRAS[tres >> (18 - 6 * k) & 63];
    }
    return texto;
}

// La media de cada cuadrado de píxeles.
Json miniatura(const Imagen &imagen) {
    const int k = (imagen.ancho + ANCHO - 1) / ANCHO;
    const int ancho = imagen.ancho / k, alto = std::max(imagen.alto / k, 1);
    std::vector<unsigned char> bytes;
    for (int y = 0; y < alto; ++y)
        for (int x = 0; x < ancho; ++x)
            for (int c = 0; c < imagen.canales; ++c) {
                int suma = 0, n = 0;
                for (int j = k * y; j < std::min(k * y + k, imagen.alto); ++j)
                    for (int i = k * x; i < k * x + k; ++i, ++n)
                        suma += imagen.bytes[std::size_t((j * imagen.ancho + i) * imagen.canales + c)];
                bytes.push_back(static_cast<unsigned char>((suma + n / 2) / std::max(n, 1)));
            }
    return {{"ancho", ancho}, {"alto", alto}, {"canales", imagen.canales}, {"datos", enBase64(bytes)}};
}

// De `canales` números por píxel, los primeros `quedan`, en bytes.
template<class Numero, class Funcion>
Imagen enBytes(const Lienzo &l, const std::vector<Numero> &numeros, int canales, int quedan, Funcion byte) {
    Imagen imagen{l.ancho, l.alto, quedan, {}};
    imagen.bytes.reserve(std::size_t(quedan) * numeros.size() / std::size_t(canales));
    for (int y = l.alto - 1; y >= 0; --y)
        for (int x = 0; x < l.ancho; ++x)
            for (int c = 0; c < quedan; ++c)
                imagen.bytes.push_back(
                    static_cast<unsigned char>(byte(numeros[std::size_t((y * l.ancho + x) * canales + c)])));
    return imagen;
}

// De lo que llega más cerca a lo que más lejos sin ser el fondo, de negro a casi blanco.
Imagen enGrises(const Lienzo &l, const std::vector<float> &profundidades) {
    float menor = 1, mayor = 0;
    for (const float z : profundidades)
        if (z < 1)
            menor = std::min(menor, z), mayor = std::max(mayor, z);
    const float tramo = std::max(mayor - menor, 1e-9f);
    return enBytes(l, profundidades, 1, 1,
                   [&](float z) { return z < 1 ? 220 * (z - menor) / tramo : 255.0f; });
}

struct Visto {
    Imagen color, veces;
    std::vector<float> profundidad;
    std::vector<unsigned char> plantilla;
};
std::map<GLuint, Visto> vistos;

void apuntaColor(const Imagen &nueva, Visto &visto, Json &orden, bool dibuja) {
    Imagen &vieja = visto.color, &veces = visto.veces;
    if (veces.bytes.size() * 3 != nueva.bytes.size())
        veces = {nueva.ancho, nueva.alto, 1, std::vector<unsigned char>(nueva.bytes.size() / 3)};
    const bool otra = vieja.bytes.size() != nueva.bytes.size();
    int cuantos = 0, x0 = nueva.ancho, y0 = nueva.alto, x1 = -1, y1 = -1;
    for (int y = 0; y < nueva.alto; ++y)
        for (int x = 0; x < nueva.ancho; ++x) {
            const std::size_t i = std::size_t(y * nueva.ancho + x) * 3;
            if (!otra && std::equal(&nueva.bytes[i], &nueva.bytes[i] + 3, &vieja.bytes[i]))
                continue;
            ++cuantos;
            veces.bytes[i / 3] =
                static_cast<unsigned char>(dibuja ? std::min(veces.bytes[i / 3] + 1, 255) : 0);
            x0 = std::min(x0, x), y0 = std::min(y0, y), x1 = std::max(x1, x), y1 = std::max(y1, y);
        }
    orden.pon("cambian", cuantos);
    if (!cuantos)
        return;
    orden.pon("donde", std::array<int, 4>{x0, y0, x1 - x0 + 1, y1 - y0 + 1});
    orden.pon("miniatura", miniatura(nueva));
    vieja = nueva;
}

} // namespace

void olvidaImagenes() {
    vistos.clear();
}

Json vecesEnJson() {
    Imagen veces = vistos[0].veces;
    if (veces.bytes.empty())
        return {};
    const int maximo = *std::max_element(veces.bytes.begin(), veces.bytes.end());
    for (unsigned char &v : veces.bytes)
        v = static_cast<unsigned char>(255 * v / std::max(maximo, 1));
    return Json().pon("maximo", maximo).pon("imagen", miniatura(veces));
}

void apuntaImagenes(const Lienzo &l, Json &orden, bool dibuja) {
    Visto &visto = vistos[l.nombre];
    if (l.ancho < 1 || l.alto < 1)
        return;
    if (l.conColor())
        apuntaColor(enBytes(l, leeColores(l, 0, 0, l.ancho, l.alto), 4, 3,
                            [](float c) { return std::clamp(c, 0.0f, 1.0f) * 255 + 0.5f; }),
                    visto, orden, dibuja);
    if (l.muestras)
        return; // las muestras de profundidad y de plantilla no se promedian
    if (l.bitsProfundidad) {
        const std::vector<float> nueva = leeProfundidades(l, 0, 0, l.ancho, l.alto);
        if (nueva != visto.profundidad)
            orden.pon("profundidad", miniatura(enGrises(l, nueva)));
        visto.profundidad = nueva;
    }
    if (l.bitsPlantilla) {
        const std::vector<unsigned char> nueva = leePlantilla(l, 0, 0, l.ancho, l.alto);
        const int mayor = nueva.empty() ? 0 : *std::max_element(nueva.begin(), nueva.end());
        if (nueva != visto.plantilla && (mayor || !visto.plantilla.empty()))
            orden.pon("plantilla", miniatura(enBytes(l, nueva, 1, 1,
                                                     [&](int s) { return 255 * s / std::max(mayor, 1); })));
        visto.plantilla = nueva;
    }
}

} // namespace explica
