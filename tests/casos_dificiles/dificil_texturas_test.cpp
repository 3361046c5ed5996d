// Casos difíciles de texturas y convolución (capítulos 6 y 9), en la GPU y leídos en float.
#include "cota.h"
#include "expresion.h"
#include "imagenes.h"
#include "textura.h"

namespace {

/// Lo que da en la GPU una expresión, en niveles de 255.
oraculo::Vec3 lee(const std::string &expresion, const glm::vec3 &a) {
    return color(glsl(expresion, a));
}
const std::string LINEAL = "texture(imagen, a.xy)";

/// Dónde está el centro de un texel.
glm::vec3 centro(const Imagen &im, int x, int y) {
    return {(float(x) + 0.5f) / float(im.ancho), (float(y) + 0.5f) / float(im.alto), 0};
}
double distancia(const oraculo::Vec3 &a, const oraculo::Vec3 &b) {
    return distancia(Pixel{0, 0, 0}, a - b);
}
/// La peor medida de los texels de una imagen al azar de ese tamaño, puesta en la unidad 0.
template<class Mide>
double peorTexel(int ancho, int alto, Mide mide) {
    abreSonda();
    const Imagen im = alAzar(ancho, alto);
    glActiveTexture(GL_TEXTURE0);
    creaTextura2D(im);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    return peorHasta(ancho * alto, [&](int i) { return mide(im, i % ancho, i / ancho); });
}

const Cotas TEXTURAS([] {
    // con la alineación a 4 bytes, las filas de 3·ancho se tuercen
    acotaCada<int>(
        "Textura", "ancho_*_sin_torcer", {1, 2, 3, 5, 6, 7, 9, 13}, 1e-4, "niveles", [](int ancho) {
            return peorTexel(ancho, 5, [](const Imagen &im, int x, int y) {
                return distancia(lee("texelFetch(imagen, ivec2(a.xy), 0)", {x, y, 0}), texel(im, x, y));
            });
        });
    // (x + 0.5)/ancho se redondea: una parte en 2²⁴ de 255·ancho niveles, y 2 del filtro
    acotaCada<int>(
        "Textura", "centros_de_texel_de_*", {1, 3, 5, 7, 16, 61},
        [](int ancho) { return 255 * ancho * 4 * U_FLOAT + 1e-4; }, "niveles",
        [](int ancho) {
            return peorTexel(ancho, 3, [](const Imagen &im, int x, int y) {
                return distancia(lee(LINEAL, centro(im, x, y)), texel(im, x, y));
            });
        });
    acota("Textura", "de_1x1_en_cualquier_sitio", 1e-4, "niveles", [] {
        return peorTexel(1, 1, [](const Imagen &im, int, int) {
            return peorDe({glm::vec3(0), glm::vec3(0.5f), glm::vec3(1), {-3.25f, 7.5f, 0}, {1e9f, -1e9f, 0}},
                          [&](const glm::vec3 &st) { return distancia(lee(LINEAL, st), texel(im, 0, 0)); });
        });
    });
});

// --- convolución ---

/// filtro.glsl con un filtro de m × n, contra la ecuación 9.1 en doble, en todos los texels.
double convoluciona(int ancho, int alto, int m, int n, const std::vector<float> &f) {
    abreSonda();
    GLuint filtro = 0;
    glActiveTexture(GL_TEXTURE1);
    glGenTextures(1, &filtro);
    glBindTexture(GL_TEXTURE_2D, filtro);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, m, n, 0, GL_RED, GL_FLOAT, f.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    return peorTexel(ancho, alto, [&](const Imagen &im, int x, int y) {
        oraculo::Vec3 suma;
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < m; ++i)
                suma = suma + double(f[j * m + i]) * texel(im, x + i - (m - 1) / 2, y + j - (n - 1) / 2);
        return distancia(lee("convoluciona(imagen, a.xy, filtro)", centro(im, x, y)), suma);
    });
}
/// n pesos que suman menos de 1.
std::vector<float> filtroAlAzar(int n) {
    Azar azar(n);
    std::vector<float> f(n);
    for (float &peso : f)
        peso = azar.entre(0.0f, 1.0f) / float(n);
    return f;
}

const Cotas CONVOLUCIONES([] {
    struct Convolucion {
        int ancho, alto, m, n;
    };
    // Leer junto al centro de un texel: 4u·ancho·255; y m·n sumas: m·n·u·255.
    acotaCada<Convolucion>(
        "Convolucion", "*",
        {{"filtro_par_2x2", {11, 7, 2, 2}},
         {"filtro_par_4x4", {11, 7, 4, 4}},
         {"filtro_par_6x6", {11, 7, 6, 6}},
         {"filtro_par_30x30", {11, 7, 30, 30}},
         {"filtro_de_4x3", {11, 7, 4, 3}},
         {"filtro_31x31_en_8x8", {8, 8, 31, 31}},
         {"filtro_que_suma_0", {11, 7, 5, 5}},
         {"paso_con_ancho_1", {1, 4, 3, 3}}, // 1/ancho, y no 1/(ancho − 1): de un texel al siguiente, exacto
         {"paso_con_ancho_2", {2, 4, 3, 3}},
         {"paso_con_ancho_3", {3, 4, 3, 3}},
         {"paso_con_ancho_9", {9, 4, 3, 3}},
         {"paso_con_ancho_255", {255, 1, 3, 3}}},
        [](const Convolucion &c) { return 255 * U_FLOAT * (8 * c.ancho + 2 * c.m * c.n) + 1e-3; }, "niveles",
        [](const Convolucion &c) {
            std::vector<float> filtro = filtroAlAzar(c.m * c.n);
            if (c.m == 5) // el que suma 0
                filtro[12] -= std::accumulate(filtro.begin(), filtro.end(), 0.0f);
            return convoluciona(c.ancho, c.alto, c.m, c.n, filtro);
        });
    acota("Convolucion", "delta", 1e-3, "niveles", [] {
        return convoluciona(11, 7, 3, 3, {0, 0, 0, 0, 1, 0, 0, 0, 0});
    });
    // lo que haría el libro, con 1/(ancho − 1), en 9 texels: el de al lado cae a 9/8; un octavo del siguiente
    acota("Convolucion", "paso_del_libro_se_nota", 0.05, "1 / niveles", [] {
        return 1 / peorTexel(9, 1, [](const Imagen &im, int x, int) {
                   const glm::vec3 alLado = centro(im, x, 0) + glm::vec3(1.0f / 8, 0, 0);
                   return x == 0 || x == 8 ? 0 : distancia(lee(LINEAL, alLado), texel(im, x + 1, 0));
               });
    });
});

} // namespace
