// Lo común a las pruebas de imagen del capítulo 3: una escena de sólidos de color, el sombreado de objeto.vert y objeto.frag en
// doble precisión, y cómo encontrar lo que se traza y se rotula encima.
#pragma once
#include "colores.h"
#include "ejecuta.h"
#include "oraculo/oraculo.h"
#include "rotulos.h"
#include <algorithm>
#include <string>
#include <vector>

namespace ch03 {

using oraculo::Vec3;

/// Giro que lleva Z a `eje`: sus columnas son e, f y d, con e según la regla del libro (§3.4), que deja libre qué
/// componente se niega.
inline oraculo::Mat4 baseDelLibro(const Vec3 &eje) {
    const Vec3 d = unitario(eje), a{std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)};
    const Vec3 e = unitario(a.x <= a.y && a.x <= a.z ? Vec3{0, -d.z, d.y}
                            : a.y <= a.z             ? Vec3{d.z, 0, -d.x}
                                                     : Vec3{-d.y, d.x, 0});
    const Vec3 f = vectorial(d, e);
    return {{{e.x, f.x, d.x, 0}, {e.y, f.y, d.y, 0}, {e.z, f.z, d.z, 0}, {0, 0, 0, 1}}};
}

struct Cuerpo {
    oraculo::Objeto objeto;
    Vec3 color;
};

/// La normal que llega al fragment shader: en una malla, la interpolada entre las de los vértices, que son
/// unitarias, sin volver a normalizarla.
inline Vec3 normalInterpolada(const oraculo::Objeto &objeto, const oraculo::Impacto &i) {
    if (objeto.forma != oraculo::Objeto::MALLA)
        return i.normal;
    const oraculo::Triangulos &malla = *objeto.triangulos;
    const auto &esquinas = malla.indices[static_cast<std::size_t>(i.corte.triangulo)];
    const auto normal = [&](std::size_t k) {
        return transformaNormal(objeto.inv, malla.vertices[esquinas[k]].normal);
    };
    return (1 - i.corte.b1 - i.corte.b2) * normal(0) + i.corte.b1 * normal(1) + i.corte.b2 * normal(2);
}

/// Lo que puede desviarse (píxeles) el borde de una misma malla: OpenGL lleva los vértices a una rejilla de 1/256,
/// y la punta donde se cortan dos lados que forman un ángulo agudo se mueve unas cuantas veces más.
const double DESVIO = 1.0 / 32;

/// Si hay un trazo de ese color a menos de dos píxeles de un punto del mundo.
inline bool hayTrazo(const Imagen &imagen, const oraculo::Camara &camara, const Vec3 &p,
                     const glm::vec3 &color) {
    const Vec3 v = proyecta(camara, imagen.ancho, imagen.alto, p);
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
            if (esColor(imagen, static_cast<int>(std::floor(v.x)) + dx,
                        static_cast<int>(std::floor(v.y)) + dy, color))
                return true;
    return false;
}

/// Si ese texto se lee una vez, y a no más de `lejos` píxeles de un punto del mundo.
inline bool estaRotulado(const Imagen &imagen, const oraculo::Camara &camara, const Vec3 &p,
                         const std::u32string &texto, const glm::vec3 &color = OSCURO, double lejos = 10) {
    const std::vector<Rotulo> sitios = buscaRotulo(imagen, texto, color);
    const Vec3 v = proyecta(camara, imagen.ancho, imagen.alto, p);
    return sitios.size() == 1 && std::hypot(sitios[0].x - v.x, sitios[0].y - v.y) <= lejos;
}

/// Si ese texto se lee una vez y su borde está pegado a un punto del mundo: a su derecha (`alLado` 1), a su izquierda (−1) o
/// encima o debajo (0).
inline bool rotuladoJunto(const Imagen &imagen, const oraculo::Camara &camara, const Vec3 &p,
                          const std::u32string &texto, int alLado, const glm::vec3 &color = OSCURO) {
    const std::vector<Rotulo> sitios = buscaRotulo(imagen, texto, color);
    if (sitios.size() != 1)
        return false;
    const double celda = celdaDe(imagen.ancho, imagen.alto);
    const Vec3 v = proyecta(camara, imagen.ancho, imagen.alto, p);
    const double dx = sitios[0].x - v.x - alLado * 3 * celda * static_cast<double>(texto.size()),
                 y = sitios[0].y - v.y, dy = alLado ? y : y - std::copysign(3.5 * celda, y);
    return std::hypot(dx, dy) <= 4.5 * celda;
}

/// Los ejes, con su letra en la punta. Las letras no las tapa nada; la flecha se mira justo antes de la punta.
inline bool estanLosEjes(const Imagen &imagen, const oraculo::Camara &camara, const Vec3 &largos) {
    const Vec3 puntas[] = {{largos.x, 0, 0}, {0, largos.y, 0}, {0, 0, largos.z}};
    const char32_t *const letras[] = {U"X", U"Y", U"Z"};
    bool bien = true;
    for (int i = 0; i < 3; ++i)
        bien = bien && estaRotulado(imagen, camara, puntas[i], letras[i], COLOR_EJE[i], 14) &&
               hayTrazo(imagen, camara, 0.97 * puntas[i], COLOR_EJE[i]);
    return bien;
}

/// Compara la imagen de la GPU con la escena, salvo en los píxeles de trazos y rótulos, cuyos colores son `adornos` (se
/// apuntan en `tapados`). El umbral de los bordes es el mismo nivel que se pide al interior: medio de guardar el color
/// en 8 bits y medio para la aritmética de float.
inline oraculo::Comparacion compara(Imagen gpu, const std::vector<Cuerpo> &cuerpos,
                                    const oraculo::Camara &camara, const Vec3 &fondo, double umbral = 1,
                                    const std::vector<glm::vec3> &adornos = {}, int *tapados = nullptr) {
    oraculo::Escena escena;
    for (const Cuerpo &c : cuerpos)
        escena.push_back(c.objeto);
    const auto sombrea = [&](const oraculo::Impacto &i) {
        if (!i)
            return fondo;
        const Cuerpo &c = cuerpos[static_cast<std::size_t>(i.objeto)];
        return (0.58 + 0.42 * escalar(normalInterpolada(c.objeto, i), {0.20, 0.78, 0.593})) * c.color;
    };
    int n = 0;
    for (int y = 0; y < gpu.alto; ++y)
        for (int x = 0; x < gpu.ancho; ++x)
            if (std::any_of(adornos.begin(), adornos.end(),
                            [&](const glm::vec3 &color) { return esColor(gpu, x, y, color); })) {
                const Vec3 color =
                    sombrea(primerImpacto(escena, rayo(camara, gpu.ancho, gpu.alto, x + 0.5, y + 0.5)));
                for (int k = 0; k < 3; ++k)
                    gpu.rgb[3 * static_cast<std::size_t>(y * gpu.ancho + x) + static_cast<std::size_t>(k)] =
                        static_cast<unsigned char>(std::lround(255 * std::clamp(color[k], 0.0, 1.0)));
                ++n;
            }
    if (tapados)
        *tapados = n;
    return oraculo::compara(gpu, escena, camara, sombrea, umbral);
}

} // namespace ch03
