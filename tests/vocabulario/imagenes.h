// Imágenes de prueba, lo que lee de ellas una textura y su comparación, píxel a píxel, con lo que se calcula en la CPU:
// en doble precisión y en niveles de 0 a 255. Los texels se cuentan desde abajo a la izquierda.
#pragma once
#include "azar.h"
#include "ejecuta.h"
#include "oraculo/algebra.h"

inline bool operator==(const Pixel &a, const Pixel &b) {
    return a.r == b.r && a.g == b.g && a.b == b.b;
}
inline std::ostream &operator<<(std::ostream &s, const Pixel &p) {
    return s << "(" << p.r << ", " << p.g << ", " << p.b << ")";
}
inline oraculo::Vec3 color(const Pixel &p) {
    return {double(p.r), double(p.g), double(p.b)};
}
inline oraculo::Vec3 color(const glm::vec3 &c) {
    return {255.0 * c.r, 255.0 * c.g, 255.0 * c.b};
}
/// La mayor de las de los tres componentes.
inline double distancia(const Pixel &p, const oraculo::Vec3 &c) {
    return std::max({std::fabs(p.r - c.x), std::fabs(p.g - c.y), std::fabs(p.b - c.z)});
}

using Texel = std::function<Pixel(int x, int y)>;

inline Imagen imagen(int ancho, int alto, const Texel &texel) {
    Imagen i{ancho, alto, {}};
    for (int y = 0; y < alto; ++y)
        for (int x = 0; x < ancho; ++x) {
            const Pixel p = texel(x, y);
            for (const int componente : {p.r, p.g, p.b})
                i.rgb.push_back(static_cast<unsigned char>(componente));
        }
    return i;
}
inline Imagen lisa(int ancho, int alto, const Pixel &color) {
    return imagen(ancho, alto, [&](int, int) { return color; });
}
/// Colores que no se parecen entre vecinos.
inline Imagen alAzar(int ancho, int alto, unsigned semilla = 1) {
    Azar azar(semilla);
    const auto nivel = [&] { return azar.entero(0, 255); };
    return imagen(ancho, alto, [&](int, int) { return Pixel{nivel(), nivel(), nivel()}; });
}
/// Cuántos píxeles la cumplen: condicion(x, y, píxel).
template<class Condicion>
int cuenta(const Imagen &imagen, Condicion condicion) {
    int n = 0;
    for (int y = 0; y < imagen.alto; ++y)
        for (int x = 0; x < imagen.ancho; ++x)
            n += condicion(x, y, pixel(imagen, x, y));
    return n;
}

/// La escribe sin pasar por common/, con cabecera si el fichero acaba en .ppm: desde arriba. Devuelve su ruta.
inline std::string escribe(const Imagen &i, const std::filesystem::path &fichero) {
    std::filesystem::create_directories(fichero.parent_path());
    std::ofstream f(fichero, std::ios::binary);
    if (fichero.extension() == ".ppm")
        f << "P6\n" << i.ancho << " " << i.alto << "\n255\n";
    for (int y = i.alto - 1; y >= 0; --y)
        f.write(reinterpret_cast<const char *>(i.rgb.data()) + 3 * i.ancho * y, 3 * i.ancho);
    return fichero.string();
}
/// En un fichero nuevo.
inline std::string enFichero(const Imagen &i, const std::string &extension = ".ppm") {
    static int n = 0;
    return escribe(i, carpetaTemporal() / ("imagen" + std::to_string(++n) + extension));
}
inline std::vector<std::string> enFicheros(const std::vector<Imagen> &imagenes) {
    std::vector<std::string> rutas;
    for (const Imagen &i : imagenes)
        rutas.push_back(enFichero(i));
    return rutas;
}

/// Lo que se ve del programa con esas imágenes, en una ventana del tamaño de la primera.
inline Imagen procesa(const std::string &programa, const std::vector<Imagen> &imagenes,
                      const std::string &guion = "") {
    return vistaDe(programa, guion, imagenes[0].ancho, imagenes[0].alto, enFicheros(imagenes)).escena;
}

/// El texel (x, y) según la especificación de OpenGL 3.1 (§3.8.7): fuera, el del borde o, si se repite, el que toque.
inline oraculo::Vec3 texel(const Imagen &i, int x, int y, bool repiteS = false, bool repiteT = false) {
    const auto en = [](int k, int n, bool repite) {
        return repite ? (k % n + n) % n : std::clamp(k, 0, n - 1);
    };
    return color(pixel(i, en(x, i.ancho, repiteS), en(y, i.alto, repiteT)));
}
/// El punto (x, y), en texels, con el filtro lineal (§3.8.8): el centro del texel (i, j) es (i + 0.5, j + 0.5).
inline oraculo::Vec3 bilineal(const Imagen &im, double x, double y, bool repiteS = false,
                              bool repiteT = false) {
    const double i = std::floor(x - 0.5), j = std::floor(y - 0.5), a = x - 0.5 - i, b = y - 0.5 - j;
    const auto en = [&](int di, int dj) { return texel(im, int(i) + di, int(j) + dj, repiteS, repiteT); };
    return (1 - b) * ((1 - a) * en(0, 0) + a * en(1, 0)) + b * ((1 - a) * en(0, 1) + a * en(1, 1));
}

/// El color que debe haber en cada píxel.
using Esperado = std::function<oraculo::Vec3(int x, int y)>;

inline Esperado igualQue(const Imagen &i) {
    return [i](int x, int y) { return color(pixel(i, x, y)); };
}
/// Lo más que se aparta de lo esperado, recortado a [0, 255]; y lo apunta.
inline double diferenciaMaxima(const Imagen &obtenida, const Esperado &esperado) {
    double maxima = 0, suma = 0;
    for (int y = 0; y < obtenida.alto; ++y)
        for (int x = 0; x < obtenida.ancho; ++x) {
            const Pixel p = pixel(obtenida, x, y);
            const oraculo::Vec3 c = esperado(x, y), d = color(p) - oraculo::Vec3{std::clamp(c.x, 0.0, 255.0),
                                                                                 std::clamp(c.y, 0.0, 255.0),
                                                                                 std::clamp(c.z, 0.0, 255.0)};
            maxima = std::max(maxima, distancia({0, 0, 0}, d));
            suma += escalar(d, d);
        }
    apuntaDiferencia(maxima, std::sqrt(suma / (3.0 * obtenida.ancho * obtenida.alto)));
    return maxima;
}
