// Imágenes de referencia y su comparación con la de la GPU.
#pragma once
#include "imagen.h"
#include "solidos.h"
#include <algorithm>
#include <ostream>

namespace oraculo {

/// Lo que devuelve `sombrea`: basta el color; `zona` separa además lo que cambia dentro de una cara (sombra o
/// no, lo que se ve en un espejo, las casillas de una textura), o dice que ahí no se compara.
const int SIN_COMPARAR = std::numeric_limits<int>::min();
struct Tono {
    Vec3 color;
    int zona;
    Tono(const Vec3 &elColor = {}, int laZona = 0) : color(elColor), zona(laZona) {
    }
};
struct PixelRef {
    Vec3 color; // 0 a 1, sin recortar ni redondear
    int objeto = -1, cara = 0, zona = 0;
    Vec3 punto, normal;
};
struct ImagenRef {
    int ancho = 0, alto = 0;
    std::vector<PixelRef> pixeles; // primera fila, la de abajo
    const PixelRef &en(int x, int y) const {
        return pixeles[y * ancho + x];
    }
};

/// Un rayo por el centro de cada píxel. `sombrea(impacto)` da el color, o un Tono; también se la llama donde
/// no hay nada (`!impacto`), para el fondo. Un color puede pasar de 1, pero no ser NaN.
template<class Sombrea>
ImagenRef render(const Escena &escena, const Camara &camara, int ancho, int alto, Sombrea sombrea) {
    ImagenRef ref{ancho, alto, {}};
    for (int y = 0; y < alto; ++y)
        for (int x = 0; x < ancho; ++x) {
            const Impacto i = primerImpacto(escena, rayo(camara, ancho, alto, x + 0.5, y + 0.5));
            const Tono tono = sombrea(i);
            if (std::isnan(tono.color.x + tono.color.y + tono.color.z))
                throw std::domain_error("oráculo: el color de referencia es NaN");
            ref.pixeles.push_back({tono.color, i.objeto, i.corte.cara, tono.zona, i.punto, i.normalCara});
        }
    return ref;
}

/// La referencia en 8 bits.
inline Imagen enBytes(const ImagenRef &ref) {
    Imagen imagen{ref.ancho, ref.alto, {}};
    for (const PixelRef &p : ref.pixeles)
        for (int k = 0; k < 3; ++k)
            imagen.rgb.push_back(enOchoBits(p.color[k]));
    return imagen;
}

/// El rectángulo de esquina inferior izquierda (x, y): una vista de una ventana con varias.
inline Imagen recorta(const Imagen &imagen, int x, int y, int ancho, int alto) {
    Imagen r{ancho, alto, {}};
    for (int fila = y; fila < y + alto; ++fila) {
        const auto inicio = imagen.rgb.begin() + 3 * (fila * imagen.ancho + x);
        r.rgb.insert(r.rgb.end(), inicio, inicio + 3 * ancho);
    }
    return r;
}

/// Errores en niveles de 255, el mayor de los tres componentes, contra el color SIN redondear: guardarlo en 8
/// bits ya cuesta hasta 0.5 de máximo.
struct Comparacion {
    int interior = 0;               // píxeles sin borde alrededor (3×3)
    double maximo = 0, rmse = 0;    // en el interior; infinito si no hay interior: no se ha comprobado nada
    int xMaximo = -1, yMaximo = -1; // dónde está el máximo
    int banda = 0;                  // los demás que se comparan
    int bandaDistintos = 0;         // … los que difieren más que el umbral
    int bandaLejos = 0;             // … y no se parecen a nada que la referencia vea a menos de un píxel
    double desvio = 0;              // de los distintos, lo más lejos (px) que hay que ir a buscar su color
};
inline std::ostream &operator<<(std::ostream &s, const Comparacion &c) {
    return s << "interior " << c.interior << " px: máximo " << c.maximo << " en (" << c.xMaximo << ", "
             << c.yMaximo << "), rmse " << c.rmse << "; banda " << c.banda << " px: " << c.bandaDistintos
             << " distintos, desvío " << c.desvio << " px, " << c.bandaLejos << " lejos";
}

/// A quien se le da cada comparación, si hay alguien.
inline void (*alComparar)(const Comparacion &, const Imagen &gpu, const ImagenRef &ref) = nullptr;

/// Si entre dos píxeles vecinos hay un borde: otro objeto, otra cara, otra zona, o el mismo objeto más atrás
/// (uno está lejos del plano tangente del otro).
inline bool hayBorde(const PixelRef &a, const PixelRef &b) {
    if (a.objeto != b.objeto || a.cara != b.cara || a.zona != b.zona)
        return true;
    const Vec3 v = b.punto - a.punto;
    const double separacion = std::max(std::fabs(escalar(v, a.normal)), std::fabs(escalar(v, b.normal)));
    return a.objeto >= 0 && separacion > 0.5 * longitud(v);
}

/// Si hay un borde entre (x, y) y alguno de sus vecinos.
inline bool enBanda(const ImagenRef &ref, int x, int y) {
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, ref.alto - 1); ++v)
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, ref.ancho - 1); ++u)
            if (hayBorde(ref.en(x, y), ref.en(u, v)))
                return true;
    return false;
}

/// Diferencia en niveles entre el píxel (x, y) de la GPU y un color.
inline double diferencia(const Imagen &gpu, int x, int y, const Vec3 &color) {
    double mayor = 0;
    for (int k = 0; k < 3; ++k) {
        const std::size_t i = 3 * (y * gpu.ancho + x) + k;
        mayor = std::max(mayor, std::fabs(gpu.rgb[i] - 255 * std::clamp(color[k], 0.0, 1.0)));
    }
    return mayor;
}

/// Lo común de las dos formas de comparar. `desvio(x, y)`: a cuántos píxeles de (x, y) está su color.
template<class Desvio>
Comparacion comparaCon(const Imagen &gpu, const ImagenRef &ref, double umbral, Desvio desvio) {
    if (gpu.ancho != ref.ancho || gpu.alto != ref.alto)
        throw std::invalid_argument("oráculo: las imágenes no tienen el mismo tamaño");
    Comparacion c;
    double suma = 0;
    for (int y = 0; y < ref.alto; ++y)
        for (int x = 0; x < ref.ancho; ++x) {
            if (ref.en(x, y).zona == SIN_COMPARAR)
                continue;
            const double d = diferencia(gpu, x, y, ref.en(x, y).color);
            if (!enBanda(ref, x, y)) {
                ++c.interior;
                suma += d * d;
                if (c.xMaximo < 0 || d > c.maximo) {
                    c.maximo = d;
                    c.xMaximo = x;
                    c.yMaximo = y;
                }
                continue;
            }
            ++c.banda;
            if (d <= umbral)
                continue;
            ++c.bandaDistintos;
            const double lejos = desvio(x, y);
            c.desvio = std::max(c.desvio, lejos);
            c.bandaLejos += lejos > 1;
        }
    c.rmse = std::sqrt(suma / c.interior);
    if (c.interior == 0)
        c.maximo = c.rmse = INFINITO;
    if (alComparar)
        alComparar(c, gpu, ref);
    return c;
}

/// Compara con una imagen ya hecha. El desvío es 1 si el color está en un píxel vecino: una cara más estrecha que
/// un píxel puede no estar en ninguno.
inline Comparacion compara(const Imagen &gpu, const ImagenRef &ref, double umbral = 2) {
    return comparaCon(gpu, ref, umbral, [&](int x, int y) {
        for (int v = std::max(y - 1, 0); v <= std::min(y + 1, ref.alto - 1); ++v)
            for (int u = std::max(x - 1, 0); u <= std::min(x + 1, ref.ancho - 1); ++u)
                if (diferencia(gpu, x, y, ref.en(u, v).color) <= umbral)
                    return 1.0;
        return INFINITO;
    });
}

/// Hace la imagen de referencia y compara. El desvío se mide trazando más rayos alrededor del píxel, en círculos
/// cada vez mayores, de 1/256 a 1. Junto al contorno de un sólido, donde es más delgado que un píxel, la GPU puede
/// dejar ver la cara de detrás, que tiene la misma profundidad: también se mira esa.
template<class Sombrea>
Comparacion compara(const Imagen &gpu, const Escena &escena, const Camara &camara, Sombrea sombrea,
                    double umbral = 2) {
    const int ancho = gpu.ancho, alto = gpu.alto;
    return comparaCon(gpu, render(escena, camara, ancho, alto, sombrea), umbral, [&](int x, int y) {
        for (int k = 0; k <= 16; ++k)
            for (int n = 0; n < 32; ++n) {
                const double radio = std::exp2(0.5 * k - 8), a = n * PI / 16;
                Rayo r =
                    rayo(camara, ancho, alto, x + 0.5 + radio * std::cos(a), y + 0.5 + radio * std::sin(a));
                Impacto i = primerImpacto(escena, r);
                const double grueso = i.distancia + tallaPixel(camara, ancho, alto, i.punto);
                do {
                    if (diferencia(gpu, x, y, Tono(sombrea(i)).color) <= umbral)
                        return radio;
                    r.minimo = i.distancia + 1e-9;
                    i = primerImpacto(escena, r);
                } while (i && i.distancia < grueso);
            }
        return INFINITO;
    });
}

/// Solo la silueta: qué píxeles no son del color del fondo (a más de 1 nivel) y en cuáles ve algo la referencia.
/// Un error en el interior vale 255; `desvio` es lo que se separan los contornos.
inline Comparacion comparaSilueta(Imagen gpu, const Vec3 &fondo, const Escena &escena, const Camara &camara) {
    for (std::size_t i = 0; i + 2 < gpu.rgb.size(); i += 3) {
        bool algo = false;
        for (int k = 0; k < 3; ++k)
            algo = algo || std::fabs(gpu.rgb[i + k] - 255 * fondo[k]) > 1;
        std::fill_n(gpu.rgb.begin() + i, 3, algo ? 255 : 0);
    }
    return compara(gpu, escena, camara, [](const Impacto &i) { return i ? Vec3{1, 1, 1} : Vec3{}; });
}

} // namespace oraculo
