#include "rotulo.h"
#include "colores.h"
#include "encima.h"
#include "letra.h"
#include "proyeccion.h"
#include <GL/glew.h>
#include <algorithm>
#include <cmath>
#include <glm/gtc/color_space.hpp>
#include <vector>

namespace {

const float TEXELS_POR_NIVEL = 255 * ALCANCE / 127.0f; // de 0 a 1 en el atlas
const float BORDE = 128 / 255.0f;
// En altos de mayúscula.
const float INTERLINEA = 1.5f, SEPARACION = 0.43f;
const float CONTRASTE = 4.5f; // el que WCAG 2 pide para leer un texto
const int ALTO_MINIMO = 7;    // píxeles: con menos no se lee

// El contraste de dos colores, de 1 a 21, como lo define WCAG 2.
float contraste(const glm::vec3 &a, const glm::vec3 &b) {
    const auto luminancia = [](const glm::vec3 &color) {
        return 0.05f + glm::dot(glm::convertSRGBToLinear(color), glm::vec3(0.2126f, 0.7152f, 0.0722f));
    };
    return std::max(luminancia(a), luminancia(b)) / std::min(luminancia(a), luminancia(b));
}

// Ese color o, si no se lee junto a su halo, el primero que se lee de los que van de él al contrario del halo.
glm::vec3 legible(const glm::vec3 &color, const glm::vec3 &halo) {
    const glm::vec3 contrario = halo == BLANCO ? glm::vec3(0) : BLANCO;
    float cuanto = 0;
    while (contraste(glm::mix(color, contrario, cuanto), halo) < CONTRASTE)
        cuanto += 0.01f;
    return glm::mix(color, contrario, cuanto);
}

// Los caracteres de un texto en UTF-8, línea a línea. Los de cuatro bytes salen otros: no hay signo para ellos.
std::vector<std::u32string> lineasDe(const std::string &texto) {
    std::vector<std::u32string> lineas(1);
    for (const unsigned char byte : texto) {
        std::u32string &linea = lineas.back();
        if (byte == '\n')
            lineas.emplace_back();
        else if (byte < 0x80 || byte >= 0xC0)
            linea += byte < 0x80 ? byte : byte & 0x1Fu;
        else if (!linea.empty())
            linea.back() = linea.back() << 6 | (byte & 0x3Fu);
    }
    return lineas;
}

// Un texto compuesto para el panel en que se dibuja. Las medidas son píxeles, desde la esquina de abajo a la izquierda
// del panel; el rectángulo va de la línea base de la última línea a lo alto de las mayúsculas de la primera.
struct Rotulo {
    std::vector<std::u32string> lineas;
    int mayuscula, paso, interlinea, bajo, ancho = 0, alto = 0;
    float halo;
    GLint panel[4];

    Rotulo(const std::string &texto, float talla) : lineas(lineasDe(texto)) {
        glGetIntegerv(GL_VIEWPORT, panel);
        mayuscula = int(std::lround(talla * altoUtil()));
        mide();
        while (mayuscula > ALTO_MINIMO && (ancho + 2 * paso > panel[2] || alto + 2 * paso > panel[3])) {
            --mayuscula;
            mide();
        }
    }

    void mide() {
        mayuscula = std::max(mayuscula, ALTO_MINIMO);
        paso = int(std::lround(float(mayuscula) * AVANCE / MAYUSCULA));
        bajo = int(std::lround(BAJO_ROTULO * float(mayuscula)));
        halo = std::max(HALO_ROTULO * float(mayuscula), 1.0f);
        interlinea = int(std::lround(INTERLINEA * float(mayuscula)));
        std::size_t letras = 1;
        for (const std::u32string &linea : lineas)
            letras = std::max(letras, linea.size());
        ancho = paso * int(letras);
        alto = interlinea * (int(lineas.size()) - 1) + mayuscula;
    }

    // Esquina de abajo a la izquierda cuando va a ese lado del punto.
    glm::ivec2 esquina(const glm::ivec2 &punto, Lado lado) const {
        const int hueco = int(std::lround(SEPARACION * float(mayuscula)));
        switch (lado) {
        case Lado::ENCIMA: return {punto.x - ancho / 2, punto.y + hueco + bajo};
        case Lado::DEBAJO: return {punto.x - ancho / 2, punto.y - hueco - alto};
        case Lado::IZQUIERDA: return {punto.x - hueco - ancho, punto.y - alto / 2};
        case Lado::DERECHA: return {punto.x + hueco, punto.y - alto / 2};
        default: return {punto.x - ancho / 2, punto.y - alto / 2};
        }
    }

    // Esa esquina, corrida lo justo para que el rótulo quede a una letra del borde del panel.
    glm::ivec2 dentro(const glm::ivec2 &e) const {
        return {std::clamp(e.x, paso, std::max(panel[2] - ancho - paso, paso)),
                std::clamp(e.y, paso, std::max(panel[3] - alto - paso, paso))};
    }

    bool tapa(const glm::ivec2 &e, const glm::ivec2 &punto) const {
        const glm::ivec2 d = punto - e;
        const int cerca = mayuscula / ALTO_MINIMO;
        return d.x >= -cerca && d.y >= -bajo - cerca && d.x <= ancho + cerca && d.y <= alto + cerca;
    }

    // Dos triángulos por letra, con su caja.
    std::vector<VerticePintado> triangulos(const glm::ivec2 &e) const {
        const float escala = float(mayuscula) / MAYUSCULA;
        const float margen = (halo + SUAVIZADO_ROTULO) / escala;
        const glm::vec2 porPixel(2 / float(std::max(panel[2], 1)), 2 / float(std::max(panel[3], 1))),
            atlas(ANCHO_ATLAS, ALTO_ATLAS),
            // el avance se redondea a píxeles, y lo que sobra va por igual a los dos lados
            origen(ORIGEN_X - 0.5f * (float(paso) / escala - AVANCE), ORIGEN_Y);
        std::vector<VerticePintado> vertices;
        glm::vec2 pluma(e.x, e.y + alto - mayuscula);
        for (const std::u32string &linea : lineas) {
            for (const char32_t signo : linea) {
                const int i = int(std::min(SIGNOS.find(signo), SIGNOS.size() - 1));
                const glm::vec2 celda(i % COLUMNAS_ATLAS * ANCHO_CELDA,
                                      (FILAS_ATLAS - 1 - i / COLUMNAS_ATLAS) * ALTO_CELDA);
                const CajaSigno caja = letra().caja(i);
                const glm::vec2 desde(caja.x0 - margen, caja.y0 - margen),
                    hasta(caja.x1 + margen, caja.y1 + margen);
                for (const glm::vec2 lado : {glm::vec2(0, 0), {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}) {
                    const glm::vec2 texel = glm::mix(desde, hasta, lado);
                    const glm::vec2 pixel = pluma + (texel - origen) * escala;
                    vertices.push_back({glm::vec3(pixel * porPixel - 1.0f, 0), (celda + texel) / atlas});
                }
                pluma.x += float(paso);
            }
            pluma = {e.x, pluma.y - float(interlinea)};
        }
        return vertices;
    }

    void dibuja(const std::string &texto, const glm::vec2 &lugar, Lado lado, const glm::vec3 &color) const {
        const glm::vec2 enPanel = lugar * glm::vec2(panel[2], panel[3]);
        const glm::ivec2 punto(enPanel);
        glm::ivec2 e = dentro(esquina(punto, lado));
        for (const Lado otro : {Lado::DEBAJO, Lado::ENCIMA, Lado::IZQUIERDA, Lado::DERECHA})
            if (lado != Lado::CENTRO && tapa(e, punto))
                e = dentro(esquina(punto, otro));

        const glm::vec3 colorHalo = glm::dot(color, glm::vec3(0.3f, 0.6f, 0.1f)) > 0.5f ? OSCURO : BLANCO;
        const float pixelesPorNivel = TEXELS_POR_NIVEL * float(mayuscula) / MAYUSCULA;
        const glm::vec2 centro = 0.5f * glm::vec2(panel[2], panel[3]);
        const glm::vec2 abajo = glm::vec2(e) - centro;
        pintaEncima({"rotulo",
                     color,
                     float(mayuscula),
                     {{abajo, 0}, {abajo + glm::vec2(ancho, alto), 0}, {enPanel - centro, 0}},
                     texto},
                    triangulos(e),
                    {{colorHalo, BORDE - halo / pixelesPorNivel, pixelesPorNivel},
                     {legible(color, colorHalo), BORDE, pixelesPorNivel}},
                    false);
    }
};

} // namespace

int letrasQueCaben(float talla) {
    const Rotulo uno("", talla);
    return uno.panel[2] / uno.paso - 2;
}

void rotula(const std::string &texto, const glm::vec2 &lugar, const glm::vec3 &color, Lado lado,
            float talla) {
    Rotulo(texto, talla).dibuja(texto, lugar, lado, color);
}

void rotulaPunto(const std::string &texto, const glm::vec3 &punto, const glm::mat4 &transformacion,
                 const glm::vec3 &color, Lado lado, float talla) {
    const glm::vec4 p = transformacion * glm::vec4(punto, 1);
    if (!(p.w > 0) || std::fabs(p.x) > p.w || std::fabs(p.y) > p.w || p.z < -p.w)
        return;
    rotula(texto, 0.5f * glm::vec2(p) / p.w + 0.5f, color, lado, talla);
}
