#include "rotulo.h"
#include "colores.h"
#include "letra.h"
#include "trazo.h"
#include "ventana.h"
#include <algorithm>
#include <cmath>
#include <vector>

namespace {

const int COLUMNAS = 5, FILAS = 7, PASO = COLUMNAS + 1, INTERLINEA = FILAS + 3; // en cuadrados
const int SEPARACION = 3; // del punto al rótulo, en cuadrados
const std::array<unsigned char, FILAS> DESCONOCIDO = {0x1F, 0x11, 0x11, 0x11, 0x11, 0x11, 0x1F};

/// Los caracteres de un texto en UTF-8, línea a línea.
std::vector<std::u32string> lineasDe(const std::string &texto) {
    std::vector<std::u32string> lineas(1);
    for (std::size_t i = 0; i < texto.size();) {
        const unsigned char primero = static_cast<unsigned char>(texto[i++]);
        char32_t c = primero < 0x80 ? primero
                                    : primero & (primero < 0xE0   ? 0x1Fu
                                                 : primero < 0xF0 ? 0x0Fu
                                                                  : 0x07u);
        for (; i < texto.size() && (static_cast<unsigned char>(texto[i]) & 0xC0) == 0x80; ++i)
            c = c << 6 | (static_cast<unsigned char>(texto[i]) & 0x3Fu);
        if (c == U'\n')
            lineas.emplace_back();
        else
            lineas.back() += c;
    }
    return lineas;
}

struct Rotulo {
    std::vector<std::u32string> lineas;
    int ancho = 0, alto = 0, celda = 1, halo = 1; // en píxeles
    GLint viewport[4];

    Rotulo(const std::string &texto, float talla) : lineas(lineasDe(texto)) {
        glGetIntegerv(GL_VIEWPORT, viewport);
        std::size_t letras = 1;
        for (const std::u32string &linea : lineas)
            letras = std::max(letras, linea.size());
        const int columnas = PASO * static_cast<int>(letras) - 1,
                  filas = INTERLINEA * static_cast<int>(lineas.size()) - (INTERLINEA - FILAS);
        celda = static_cast<int>(std::lround(talla * altoUtil() / FILAS));
        celda = std::max(std::min({celda, viewport[2] / (columnas + 2), viewport[3] / (filas + 2)}), 1);
        halo = std::max(celda / 2, 1);
        ancho = columnas * celda;
        alto = filas * celda;
    }

    /// Esquina de abajo a la izquierda del rótulo, en píxeles del panel, cuando va a ese lado del punto.
    glm::ivec2 esquina(const glm::ivec2 &punto, Lado lado) const {
        const int hueco = SEPARACION * celda;
        switch (lado) {
        case Lado::ENCIMA: return {punto.x - ancho / 2, punto.y + hueco};
        case Lado::DEBAJO: return {punto.x - ancho / 2, punto.y - hueco - alto};
        case Lado::IZQUIERDA: return {punto.x - hueco - ancho, punto.y - alto / 2};
        case Lado::DERECHA: return {punto.x + hueco, punto.y - alto / 2};
        default: return {punto.x - ancho / 2, punto.y - alto / 2};
        }
    }

    /// Esa esquina, corrida lo justo para que el rótulo no se salga del panel.
    glm::ivec2 dentro(const glm::ivec2 &e) const {
        const int margen = halo + 1;
        return {std::clamp(e.x, margen, std::max(viewport[2] - ancho - margen, margen)),
                std::clamp(e.y, margen, std::max(viewport[3] - alto - margen, margen))};
    }

    bool tapa(const glm::ivec2 &e, const glm::ivec2 &punto) const {
        const glm::ivec2 d = punto - e;
        return d.x >= -celda && d.y >= -celda && d.x <= ancho + celda && d.y <= alto + celda;
    }

    /// Los cuadrados de las letras, agrandados en `margen` píxeles por los cuatro lados.
    void pinta(const glm::ivec2 &e, int margen, const glm::vec3 &color) const {
        const glm::vec2 porPixel(2.0f / static_cast<float>(std::max(viewport[2], 1)),
                                 2.0f / static_cast<float>(std::max(viewport[3], 1)));
        std::vector<glm::vec3> vertices;
        const auto vertice = [&](int x, int y) {
            vertices.push_back(glm::vec3(glm::vec2(x, y) * porPixel - 1.0f, 0));
        };
        int arriba = e.y + alto;
        for (const std::u32string &linea : lineas) {
            int izquierda = e.x;
            for (const char32_t c : linea) {
                const auto letra = LETRA.find(c);
                for (int fila = 0; fila < FILAS; ++fila) {
                    const unsigned bits = c == U' ' ? 0u
                                          : letra != LETRA.end()
                                              ? letra->second[static_cast<std::size_t>(fila)]
                                              : DESCONOCIDO[static_cast<std::size_t>(fila)];
                    for (int columna = 0; columna < COLUMNAS; ++columna) {
                        if (!(bits >> (COLUMNAS - 1 - columna) & 1u))
                            continue;
                        const int x0 = izquierda + columna * celda - margen, x1 = x0 + celda + 2 * margen,
                                  y1 = arriba - fila * celda + margen, y0 = y1 - celda - 2 * margen;
                        vertice(x0, y0), vertice(x1, y0), vertice(x1, y1);
                        vertice(x0, y0), vertice(x1, y1), vertice(x0, y1);
                    }
                }
                izquierda += PASO * celda;
            }
            arriba -= INTERLINEA * celda;
        }
        pintaTriangulos(vertices, color);
    }

    void dibuja(const glm::ivec2 &punto, Lado lado, const glm::vec3 &color) const {
        glm::ivec2 e = dentro(esquina(punto, lado));
        for (const Lado otro : {Lado::DEBAJO, Lado::ENCIMA, Lado::IZQUIERDA, Lado::DERECHA})
            if (lado != Lado::CENTRO && tapa(e, punto))
                e = dentro(esquina(punto, otro));

        const bool claro = glm::dot(color, glm::vec3(0.3f, 0.6f, 0.1f)) > 0.5f;
        const GLboolean profundidad = glIsEnabled(GL_DEPTH_TEST);
        glDisable(GL_DEPTH_TEST);
        pinta(e, halo, claro ? OSCURO : BLANCO);
        pinta(e, 0, color);
        if (profundidad)
            glEnable(GL_DEPTH_TEST);
    }
};

} // namespace

void rotula(const std::string &texto, const glm::vec2 &lugar, const glm::vec3 &color, Lado lado,
            float talla) {
    const Rotulo r(texto, talla);
    r.dibuja(glm::ivec2(lugar * glm::vec2(r.viewport[2], r.viewport[3])), lado, color);
}

void rotulaPunto(const std::string &texto, const glm::vec3 &punto, const glm::mat4 &transformacion,
                 const glm::vec3 &color, Lado lado, float talla) {
    const glm::vec4 p = transformacion * glm::vec4(punto, 1);
    if (!(p.w > 0) || std::fabs(p.x) > p.w || std::fabs(p.y) > p.w || p.z < -p.w)
        return;
    rotula(texto, 0.5f * glm::vec2(p) / p.w + 0.5f, color, lado, talla);
}
