// Casos difíciles de texturas, convolución y ruido (capítulos 6, 8 y 9), en la GPU y leídos en float.
#include "azar.h"
#include "caso.h"
#include "ch08_texturas_avanzadas/ruido.h"
#include "expresion.h"
#include "imagen.h"
#include "textura.h"
#include <algorithm>

namespace {

/// Lo que da en la GPU una expresión, en niveles de 255.
glm::dvec3 lee(const std::string &expresion, const glm::vec3 &a) {
    return 255.0 * glm::dvec3(glsl(expresion, a));
}
const std::string LINEAL = "texture(imagen, a.xy)", CUBO = "texture(mapa, a)";

Imagen alAzar(int ancho, int alto) {
    Azar azar(31 * ancho + alto);
    Imagen im{ancho, alto, {}};
    for (int i = 0; i < 3 * ancho * alto; ++i)
        im.rgb.push_back(static_cast<unsigned char>(azar.entero(0, 255)));
    return im;
}
glm::dvec3 texel(const Imagen &im, int x, int y) { // fuera, el borde
    const unsigned char *c =
        im.rgb.data() + 3 * (std::clamp(y, 0, im.alto - 1) * im.ancho + std::clamp(x, 0, im.ancho - 1));
    return {c[0], c[1], c[2]};
}
/// Dónde está el centro de un texel.
glm::vec3 centro(const Imagen &im, int x, int y) {
    return {(float(x) + 0.5f) / float(im.ancho), (float(y) + 0.5f) / float(im.alto), 0};
}
double distancia(const glm::dvec3 &a, const glm::dvec3 &b) {
    return mayorComponente(a - b);
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

const Casos TEXTURAS([] {
    // con la alineación a 4 bytes, las filas de 3·ancho se tuercen
    casos<int>("Textura", "ancho_*_sin_torcer", {1, 2, 3, 5, 6, 7, 9, 13}, 1e-4, "niveles", [](int ancho) {
        return peorTexel(ancho, 5, [](const Imagen &im, int x, int y) {
            return distancia(lee("texelFetch(imagen, ivec2(a.xy), 0)", {x, y, 0}), texel(im, x, y));
        });
    });
    // (x + 0.5)/ancho se redondea: una parte en 2²⁴ de 255·ancho niveles, y 2 del filtro
    casos<int>(
        "Textura", "centros_de_texel_de_*", {1, 3, 5, 7, 16, 61},
        [](int ancho) { return 255 * ancho * 4 * U_FLOAT + 1e-4; }, "niveles",
        [](int ancho) {
            return peorTexel(ancho, 3, [](const Imagen &im, int x, int y) {
                return distancia(lee(LINEAL, centro(im, x, y)), texel(im, x, y));
            });
        });
    caso("Textura", "de_1x1_en_cualquier_sitio", 1e-4, "niveles", [] {
        return peorTexel(1, 1, [](const Imagen &im, int, int) {
            return peorDe({glm::vec3(0), glm::vec3(0.5f), glm::vec3(1), {-3.25f, 7.5f, 0}, {1e9f, -1e9f, 0}},
                          [&](const glm::vec3 &st) { return distancia(lee(LINEAL, st), texel(im, 0, 0)); });
        });
    });
});

// --- mapa de cubo ---

/// La dirección del punto (s, t), de −1 a 1, de la cara: la tabla de OpenGL al revés.
glm::dvec3 direccion(int cara, double s, double t) {
    const glm::dvec3 d[] = {{1, -t, -s}, {-1, -t, s}, {s, 1, t}, {s, -1, -t}, {s, -t, 1}, {-s, -t, -1}};
    return d[cara];
}
/// Un color que cambia despacio con la dirección, en niveles.
glm::dvec3 entorno(const glm::dvec3 &d) {
    return 127.5 + 120.0 * glm::normalize(d);
}
void ponMapa(int lado) {
    abreSonda();
    GLuint mapa = 0;
    glActiveTexture(GL_TEXTURE2);
    glGenTextures(1, &mapa);
    glBindTexture(GL_TEXTURE_CUBE_MAP, mapa);
    for (int cara = 0; cara < 6; ++cara) {
        std::vector<glm::vec3> texeles;
        for (int y = 0; y < lado; ++y)
            for (int x = 0; x < lado; ++x)
                texeles.emplace_back(
                    entorno(direccion(cara, (2 * x + 1.0) / lado - 1, (2 * y + 1.0) / lado - 1)) / 255.0);
        glTexImage2D(GLenum(GL_TEXTURE_CUBE_MAP_POSITIVE_X + cara), 0, GL_RGB32F, lado, lado, 0, GL_RGB,
                     GL_FLOAT, texeles.data());
    }
    for (const GLenum filtro : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_CUBE_MAP, filtro, GL_LINEAR);
    for (const GLenum eje : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTexParameteri(GL_TEXTURE_CUBE_MAP, eje, GL_CLAMP_TO_EDGE);
    if (GLEW_ARB_seamless_cube_map)
        glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
}
/// La peor medida de las direcciones de una y otra parte de cada arista, lejos de los vértices.
template<class Mide>
double peorArista(int lado, Mide mide) {
    ponMapa(lado);
    return peorHasta(120, [&](int i) { // ejes, a y b, de 1 en 1, y diez pasos de c
        const int eje = i / 40, j = (eje + 1) % 3, k = (eje + 2) % 3;
        const double a = i / 20 % 2 ? 1 : -1, b = i / 10 % 2 ? 1 : -1, c = -0.9 + 0.2 * (i % 10), e = 1e-5;
        glm::dvec3 dentro, fuera;
        dentro[eje] = fuera[eje] = c;
        dentro[j] = a;
        dentro[k] = b * (1 - e);
        fuera[j] = a * (1 - e);
        fuera[k] = b;
        return mide(dentro, fuera);
    });
}

const Casos CUBOS([] {
    const std::vector<Con<int>> lados = {{"4x4", 4}, {"16x16", 16}, {"64x64", 64}};
    // 1e-5 de una parte a la otra, y el peso del filtro en 1/256 de texel
    casos<int>(
        "MapaDeCubo", "salto_en_las_aristas_*", lados,
        [](int lado) { return 255 * (2e-5 + 1.0 / 256 / lado); }, "niveles",
        [](int lado) {
            return peorArista(lado, [](const glm::dvec3 &dentro, const glm::dvec3 &fuera) {
                return distancia(lee(CUBO, dentro), lee(CUBO, fuera));
            });
        });
    // En la arista se promedian dos texels a h = 1/lado de ella, (1, 1 − h, c) y (1 − h, 1, c): hasta 120·c·h/(2 + c²)^1.5 de
    // primer orden, con c menor que 1, y de segundo no más de 240·h²
    casos<int>(
        "MapaDeCubo", "error_en_las_aristas_*", lados,
        [](int lado) { return 23.1 / lado + 240.0 / lado / lado; }, "niveles",
        [](int lado) {
            return peorArista(lado, [](const glm::dvec3 &dentro, const glm::dvec3 &fuera) {
                return mayor(distancia(lee(CUBO, dentro), entorno(dentro)),
                             distancia(lee(CUBO, fuera), entorno(fuera)));
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
        glm::dvec3 suma(0);
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < m; ++i)
                suma += double(f[j * m + i]) * texel(im, x + i - (m - 1) / 2, y + j - (n - 1) / 2);
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

const Casos CONVOLUCIONES([] {
    struct Convolucion {
        int ancho, alto, m, n;
    };
    // Leer junto al centro de un texel: 4u·ancho·255; y m·n sumas: m·n·u·255.
    casos<Convolucion>(
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
    caso("Convolucion", "delta", 1e-3, "niveles", [] {
        return convoluciona(11, 7, 3, 3, {0, 0, 0, 0, 1, 0, 0, 0, 0});
    });
    // lo que haría el libro, con 1/(ancho − 1), en 9 texels: el de al lado cae a 9/8; un octavo del siguiente
    caso("Convolucion", "paso_del_libro_se_nota", 0.05, "1 / niveles", [] {
        return 1 / peorTexel(9, 1, [](const Imagen &im, int x, int) {
                   const glm::vec3 alLado = centro(im, x, 0) + glm::vec3(1.0f / 8, 0, 0);
                   return x == 0 || x == 8 ? 0 : distancia(lee(LINEAL, alLado), texel(im, x + 1, 0));
               });
    });
});

// --- ruido ---

double ruidoGlsl(const glm::vec3 &p, int periodo = 0) {
    return glsl("ruidoConGradiente(a, ivec3(b)).w", p, glm::vec3(float(periodo))).x;
}

const Casos RUIDOS([] {
    // GPU en float contra CPU en doble
    casos<glm::vec3>("Ruido", "*",
                     {{"negativas", {-0.3f, -7.6f, -2.5f}},
                      {"menos_cero", {-0.0f, 0.3f, -0.0f}},
                      {"casi_cero_por_debajo", {-1e-9f, 0.3f, 0.7f}},
                      {"en_un_plano", {5, 0.3f, 0.7f}},
                      {"en_un_plano_negativo", {-5, 0.3f, 0.7f}},
                      {"en_un_nodo", {3, -2, 7}},
                      {"x_2_a_la_24", {16777216, 0.3f, 0.7f}},
                      {"x_menos_2_a_la_24", {-16777218, 0.3f, 0.7f}},
                      {"x_2_a_la_31", {2147483648.0f, 0.3f, 0.7f}},
                      {"x_1e20", {1e20f, 0.3f, 0.7f}},
                      {"x_menos_3e38", {-3e38f, 0.3f, 0.7f}}},
                     1e-5, "diferencia",
                     [](const glm::vec3 &p) { return std::fabs(ruidoGlsl(p) - ruido(glm::dvec3(p))); });
    // pendiente menor que 4: de una parte a otra del plano, 4 por el salto
    const auto salto = [](float x) { return 1e-4f * std::max(1.0f, std::fabs(x)); };
    casos<float>(
        "Ruido", "a_los_dos_lados_del_plano_*", {0, 1, -1, -4, 1000},
        [=](float x) { return 4 * 2 * salto(x) + 1e-5; }, "diferencia",
        [=](float x) {
            return std::fabs(ruidoGlsl({x - salto(x), 0.3f, 0.7f}) - ruidoGlsl({x + salto(x), 0.3f, 0.7f}));
        });
    // p y p + periodo son exactos en float: lo mismo, bit a bit
    for (const auto &[nombre, x] : {std::pair("periodo_*", 0.25f), {"periodo_*_negativo", -3.25f}})
        casos<int>("Ruido", nombre, {1, 4, 7, 64}, 0, "diferencia",
                   [p = glm::vec3(x, 0.5f, -0.75f)](int periodo) {
                       return std::fabs(ruidoGlsl(p, periodo) - ruidoGlsl(p + float(periodo), periodo));
                   });
});

} // namespace
