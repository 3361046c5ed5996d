// Casos difíciles de texturas, convolución y ruido (capítulos 6, 8 y 9), en la GPU y leídos en float.
#include "caso.h"
#include "ch08_texturas_avanzadas/ruido.h"
#include "imagen.h"
#include "sonda.h"
#include "textura.h"
#include <algorithm>
#include <random>
#include <vector>

namespace {

enum Cual { TEXEL, LINEAL, CUBO, CONVOLUCION };

GLuint programa() {
    static const GLuint p = creaSonda("tests/casos_dificiles/textura.frag");
    return p;
}
/// Lo que se lee en a, en niveles de 255.
glm::dvec3 lee(Cual cual, const glm::vec3 &a) {
    glUseProgram(programa());
    envia(programa(), "imagen", 0);
    envia(programa(), "filtro", 1);
    envia(programa(), "mapa", 2);
    envia(programa(), "cual", static_cast<int>(cual));
    envia(programa(), "a", a);
    return 255.0 * glm::dvec3(leeSonda());
}

Imagen alAzar(int ancho, int alto) {
    std::mt19937 azar(static_cast<unsigned>(31 * ancho + alto));
    Imagen im{ancho, alto, {}};
    for (int i = 0; i < 3 * ancho * alto; ++i)
        im.rgb.push_back(static_cast<unsigned char>(azar() % 256));
    return im;
}
glm::dvec3 texel(const Imagen &im, int x, int y) { // fuera, el borde
    const int i = 3 * (std::clamp(y, 0, im.alto - 1) * im.ancho + std::clamp(x, 0, im.ancho - 1));
    const unsigned char *c = im.rgb.data() + i;
    return {c[0], c[1], c[2]};
}
double distancia(const glm::dvec3 &a, const glm::dvec3 &b) {
    double peor = 0;
    for (int k = 0; k < 3; ++k)
        peor = mayor(std::fabs(a[k] - b[k]), peor);
    return peor;
}
void ponImagen(const Imagen &im) {
    programa(); // que abre el contexto
    glActiveTexture(GL_TEXTURE0);
    creaTextura2D(im);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
}

double cadaTexel(int ancho, int alto) {
    const Imagen im = alAzar(ancho, alto);
    ponImagen(im);
    double peor = 0;
    for (int y = 0; y < alto; ++y)
        for (int x = 0; x < ancho; ++x)
            peor = mayor(distancia(lee(TEXEL, glm::vec3(x, y, 0)), texel(im, x, y)), peor);
    return peor;
}
double cadaCentro(int ancho) {
    const Imagen im = alAzar(ancho, 3);
    ponImagen(im);
    double peor = 0;
    for (int x = 0; x < ancho; ++x)
        peor = mayor(
            distancia(lee(LINEAL, {(static_cast<float>(x) + 0.5f) / static_cast<float>(ancho), 0.5f, 0}),
                      texel(im, x, 1)),
            peor);
    return peor;
}

const Casos TEXTURAS([] {
    for (const int ancho :
         {1, 2, 3, 5, 6, 7, 9, 13}) // con la alineación a 4 bytes, las filas de 3·ancho se tuercen
        caso("Textura", "ancho_" + std::to_string(ancho) + "_sin_torcer", 1e-4, "niveles",
             [=] { return cadaTexel(ancho, 5); });
    for (const int ancho :
         {1, 3, 5, 7, 16,
          61}) // (x + 0.5)/ancho se redondea: una parte en 2²⁴ de 255·ancho niveles, y 2 del filtro
        caso("Textura", "centros_de_texel_de_" + std::to_string(ancho), 255 * ancho * 4 * U_FLOAT + 1e-4,
             "niveles", [=] { return cadaCentro(ancho); });
    caso("Textura", "de_1x1_en_cualquier_sitio", 1e-4, "niveles", [] {
        const Imagen im = alAzar(1, 1);
        ponImagen(im);
        double peor = 0;
        for (const glm::vec3 &st : {glm::vec3(0), glm::vec3(0.5f), glm::vec3(1), glm::vec3(-3.25f, 7.5f, 0),
                                    glm::vec3(1e9f, -1e9f, 0)})
            peor = mayor(distancia(lee(LINEAL, st), texel(im, 0, 0)), peor);
        return peor;
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
    programa();
    GLuint mapa = 0;
    glActiveTexture(GL_TEXTURE2);
    glGenTextures(1, &mapa);
    glBindTexture(GL_TEXTURE_CUBE_MAP, mapa);
    for (int cara = 0; cara < 6; ++cara) {
        std::vector<glm::vec3> texeles;
        for (int y = 0; y < lado; ++y)
            for (int x = 0; x < lado; ++x)
                texeles.push_back(glm::vec3(
                    entorno(direccion(cara, (2 * x + 1.0) / lado - 1, (2 * y + 1.0) / lado - 1)) / 255.0));
        glTexImage2D(static_cast<GLenum>(GL_TEXTURE_CUBE_MAP_POSITIVE_X + cara), 0, GL_RGB32F, lado, lado, 0,
                     GL_RGB, GL_FLOAT, texeles.data());
    }
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    for (const GLenum eje : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTexParameteri(GL_TEXTURE_CUBE_MAP, eje, GL_CLAMP_TO_EDGE);
    if (GLEW_ARB_seamless_cube_map)
        glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
}
/// A una y otra parte de cada arista, lejos de los vértices: el salto, o lo que se aparta del entorno.
double arista(int lado, bool salto) {
    ponMapa(lado);
    double peor = 0;
    for (int eje = 0; eje < 3; ++eje)
        for (const double a : {-1.0, 1.0})
            for (const double b : {-1.0, 1.0})
                for (double c = -0.9; c <= 0.9; c += 0.2) {
                    const double e = 1e-5;
                    glm::dvec3 dentro, fuera;
                    dentro[eje] = fuera[eje] = c;
                    dentro[(eje + 1) % 3] = a, dentro[(eje + 2) % 3] = b * (1 - e);
                    fuera[(eje + 1) % 3] = a * (1 - e), fuera[(eje + 2) % 3] = b;
                    const glm::dvec3 p = lee(CUBO, glm::vec3(dentro)), q = lee(CUBO, glm::vec3(fuera));
                    peor = mayor(salto ? distancia(p, q)
                                       : mayor(distancia(p, entorno(dentro)), distancia(q, entorno(fuera))),
                                 peor);
                }
    return peor;
}

const Casos CUBOS([] {
    for (const int lado : {4, 16, 64}) {
        const std::string nombre = std::to_string(lado) + "x" + std::to_string(lado);
        // 1e-5 de una parte a la otra, y el peso del filtro en 1/256 de texel
        caso("MapaDeCubo", "salto_en_las_aristas_" + nombre, 255 * (2e-5 + 1.0 / 256 / lado), "niveles",
             [=] { return arista(lado, true); });
        // En la arista se promedian dos texels a h = 1/lado de ella, (1, 1 − h, c) y (1 − h, 1, c): hasta 120·c·h/(2 + c²)^1.5 de
        // primer orden, con c menor que 1, y de segundo no más de 240·h²
        caso("MapaDeCubo", "error_en_las_aristas_" + nombre, 23.1 / lado + 240.0 / lado / lado, "niveles",
             [=] { return arista(lado, false); });
    }
});

// --- convolución ---

/// filtro.glsl con ese filtro, contra la ecuación 9.1 en doble, en todos los texels.
double convoluciona(const Imagen &im, int m, int n, const std::vector<float> &f) {
    ponImagen(im);
    GLuint filtro = 0;
    glActiveTexture(GL_TEXTURE1);
    glGenTextures(1, &filtro);
    glBindTexture(GL_TEXTURE_2D, filtro);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, m, n, 0, GL_RED, GL_FLOAT, f.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    double peor = 0;
    for (int y = 0; y < im.alto; ++y)
        for (int x = 0; x < im.ancho; ++x) {
            glm::dvec3 suma(0);
            for (int j = 0; j < n; ++j)
                for (int i = 0; i < m; ++i)
                    suma += static_cast<double>(f[static_cast<std::size_t>(j * m + i)]) *
                            texel(im, x + i - (m - 1) / 2, y + j - (n - 1) / 2);
            const glm::vec3 st((static_cast<float>(x) + 0.5f) / static_cast<float>(im.ancho),
                               (static_cast<float>(y) + 0.5f) / static_cast<float>(im.alto), 0);
            peor = mayor(distancia(lee(CONVOLUCION, st), suma), peor);
        }
    return peor;
}
std::vector<float> filtroAlAzar(int n, bool sumaCero = false) {
    std::mt19937 azar(static_cast<unsigned>(n));
    std::vector<float> f;
    double suma = 0;
    for (int i = 0; i < n; ++i) {
        f.push_back(static_cast<float>(azar() % 1000) / (1000.0f * static_cast<float>(n)));
        suma += static_cast<double>(f.back());
    }
    if (sumaCero)
        f[static_cast<std::size_t>(n / 2)] -= static_cast<float>(suma);
    return f;
}
// Los pesos suman menos de 1. Leer junto al centro de un texel: 4u·ancho·255; y m·n sumas: m·n·u·255.
double cotaConvolucion(int talla, int mn) {
    return 255 * U_FLOAT * (8 * talla + 2 * mn) + 1e-3;
}

const Casos CONVOLUCIONES([] {
    for (const int m : {2, 4, 6, 30})
        caso("Convolucion", "filtro_par_" + std::to_string(m) + "x" + std::to_string(m),
             cotaConvolucion(11, m * m), "niveles",
             [=] { return convoluciona(alAzar(11, 7), m, m, filtroAlAzar(m * m)); });
    caso("Convolucion", "filtro_de_4x3", cotaConvolucion(11, 12), "niveles",
         [] { return convoluciona(alAzar(11, 7), 4, 3, filtroAlAzar(12)); });
    caso("Convolucion", "filtro_31x31_en_8x8", cotaConvolucion(8, 961), "niveles",
         [] { return convoluciona(alAzar(8, 8), 31, 31, filtroAlAzar(961)); });
    caso("Convolucion", "filtro_que_suma_0", cotaConvolucion(11, 25), "niveles",
         [] { return convoluciona(alAzar(11, 7), 5, 5, filtroAlAzar(25, true)); });
    caso("Convolucion", "delta", 1e-3, "niveles", [] {
        std::vector<float> delta(9, 0);
        delta[4] = 1;
        return convoluciona(alAzar(11, 7), 3, 3, delta);
    });
    for (const int ancho : {1, 2, 3, 9, 255}) // 1/ancho, y no 1/(ancho − 1): de un texel al siguiente, exacto
        caso("Convolucion", "paso_con_ancho_" + std::to_string(ancho), cotaConvolucion(ancho, 9), "niveles",
             [=] { return convoluciona(alAzar(ancho, ancho == 255 ? 1 : 4), 3, 3, filtroAlAzar(9)); });
    // lo que haría el libro, con 1/(ancho − 1), en 9 texels: el de al lado cae a 9/8; un octavo del siguiente
    caso("Convolucion", "paso_del_libro_se_nota", 0.05, "1 / niveles", [] {
        const Imagen im = alAzar(9, 1);
        ponImagen(im);
        double peor = 0;
        for (int x = 1; x < 8; ++x)
            peor = mayor(distancia(lee(LINEAL, {(static_cast<float>(x) + 0.5f) / 9 + 1.0f / 8, 0.5f, 0}),
                                   texel(im, x + 1, 0)),
                         peor);
        return 1 / peor;
    });
});

// --- ruido ---

double ruidoGlsl(const glm::vec3 &p, const glm::ivec3 &periodo) {
    static const GLuint sonda = creaSonda("tests/capitulos/ch08_sonda.frag");
    glUseProgram(sonda);
    envia(sonda, "p", p);
    envia(sonda, "periodoX", periodo.x);
    envia(sonda, "periodoY", periodo.y);
    envia(sonda, "periodoZ", periodo.z);
    envia(sonda, "octavas", 0);
    return static_cast<double>(leeSonda().w);
}
/// GPU en float contra CPU en doble.
double ruidoEn(const glm::vec3 &p, const glm::ivec3 &periodo = glm::ivec3(0)) {
    return std::fabs(ruidoGlsl(p, periodo) - ruido(glm::dvec3(p), periodo));
}

const Casos RUIDOS([] {
    const std::pair<const char *, glm::vec3> puntos[] = {
        {"negativas", {-0.3f, -7.6f, -2.5f}},           {"menos_cero", {-0.0f, 0.3f, -0.0f}},
        {"casi_cero_por_debajo", {-1e-9f, 0.3f, 0.7f}}, {"en_un_plano", {5, 0.3f, 0.7f}},
        {"en_un_plano_negativo", {-5, 0.3f, 0.7f}},     {"en_un_nodo", {3, -2, 7}},
        {"x_2_a_la_24", {16777216, 0.3f, 0.7f}},        {"x_menos_2_a_la_24", {-16777218, 0.3f, 0.7f}},
        {"x_2_a_la_31", {2147483648.0f, 0.3f, 0.7f}},   {"x_1e20", {1e20f, 0.3f, 0.7f}},
        {"x_menos_3e38", {-3e38f, 0.3f, 0.7f}}};
    for (const auto &[nombre, p] : puntos)
        caso("Ruido", nombre, 1e-5, "diferencia", [=, p = p] { return ruidoEn(p); });
    for (const float x : {0.0f, 1.0f, -1.0f, -4.0f,
                          1000.0f}) // pendiente menor que 4: de una parte a otra del plano, 4 por el salto
        caso("Ruido", "a_los_dos_lados_del_plano_" + enNombre(static_cast<double>(x)),
             4 * 2 * 1e-4 * std::max(1.0f, std::fabs(x)) + 1e-5, "diferencia", [=] {
                 const float e = 1e-4f * std::max(1.0f, std::fabs(x));
                 return std::fabs(ruidoGlsl({x - e, 0.3f, 0.7f}, glm::ivec3(0)) -
                                  ruidoGlsl({x + e, 0.3f, 0.7f}, glm::ivec3(0)));
             });
    for (const int periodo : {1, 4, 7, 64}) // p y p + periodo son exactos en float: lo mismo, bit a bit
        for (const float x : {0.25f, -3.25f})
            caso("Ruido", "periodo_" + std::to_string(periodo) + (x < 0 ? "_negativo" : ""), 0, "diferencia",
                 [=] {
                     const glm::vec3 p(x, 0.5f, -0.75f);
                     const glm::ivec3 n(periodo);
                     return std::fabs(ruidoGlsl(p, n) - ruidoGlsl(p + glm::vec3(n), n));
                 });
});

} // namespace
