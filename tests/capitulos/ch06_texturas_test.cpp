// Los programas del capítulo 6. El color esperado se calcula aquí, en doble precisión: qué (s, t) ve cada píxel,
// trazando su rayo con el oráculo, y qué da ahí la textura según la especificación de OpenGL.
#include "colores.h"
#include "contra_oraculo.h"
#include "guiones.h"
#include "imagenes.h"
#include "panel.h"
#include "rutas.h"
#include "tabla.h"

using namespace oraculo;

namespace {

/// Una de las de assets/.
Imagen lee(const std::string &nombre, int ancho, int alto) {
    return leeTextura(recurso("assets/" + nombre + ".rgb"), ancho, alto);
}
std::vector<std::string> enRgb(const Imagen &i) {
    return {enFichero(i, ".rgb"), "-talla", std::to_string(i.ancho) + "x" + std::to_string(i.alto)};
}

/// Lo que da una textura en (s, t), en niveles de 0 a 255.
Vec3 lineal(const Imagen &im, double s, double t, bool repiteS = true, bool repiteT = true) {
    return bilineal(im, s * im.ancho, t * im.alto, repiteS, repiteT);
}

/// (s, t) que ve el punto (x, y) de la ventana.
struct Coordenadas {
    bool hay = false;
    double s = 0, t = 0;
    int cara = 0;
};

/// Cota superior del ρ de la especificación, en texels por píxel: con ρ < 1 el filtro es el de ampliación, aunque el
/// controlador lo aproxime. Infinito si a un lado hay otra cosa.
template<class Ve>
double texelsPorPixel(Ve ve, int x, int y, const Imagen &im) {
    const Coordenadas c = ve(x + 0.5, y + 0.5);
    double suma = 0;
    for (const auto &[dx, dy] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
        const Coordenadas v = ve(x + 0.5 + dx, y + 0.5 + dy);
        if (!c.hay || !v.hay || c.cara != v.cara)
            return INFINITO;
        suma += std::fabs(v.s - c.s) * im.ancho + std::fabs(v.t - c.t) * im.alto;
    }
    return suma / 2;
}

// --- textura_objeto ----------------------------------------------------------------------------------------
// Cada píxel interior donde la textura se amplía: bilineal exacto por Phong, sobre la misma malla. La textura mide
// 5 × 3: sus filas no llegan a un múltiplo de 4 bytes, y sin GL_UNPACK_ALIGNMENT las de arriba saldrían torcidas. Medio
// nivel del redondeo a 8 bits y una centésima de hacer las cuentas en float.
TEST(TexturaObjeto, TexelPorIluminacionContraElOraculo) {
    const Imagen im = alAzar(5, 3);
    const Camara camara = perspectiva(orbita(0.25, 0.45, 6), 0.47, 1, 100);
    const Escena escena = {malla(gira({1, 0, 0}, -1.2), toro(1, 0.5f, 160, 80))};
    const Ejes e = ejes(camara); // la luz va con el observador, sobre su hombro izquierdo
    const Luz luz = posicional(camara.ojo - 5.0 * e.x + 2.5 * e.y + 3.0 * e.z);
    const auto impacto = [&](double x, double y) {
        return primerImpacto(escena, rayo(camara, 240, 180, x, y));
    };
    const auto ve = [&](double x, double y) {
        const Impacto i = impacto(x, y);
        return Coordenadas{bool(i), 6 * i.s, 2 * i.t};
    };
    const Imagen gpu = vistaDe("textura_objeto", "", 240, 180, enRgb(im)).escena;
    const int comparados = cuenta(gpu, [&](int x, int y, const Pixel &p) {
        if (texelsPorPixel(ve, x, y, im) > 0.95)
            return false;
        const Impacto i = impacto(x + 0.5, y + 0.5);
        const Vec3 tinte = 1 / 255.0 * lineal(im, 6 * i.s, 2 * i.t);
        const Material m = {0.22 * tinte, 0.85 * tinte, {0.45, 0.45, 0.45}, 40};
        const double d = diferencia(gpu, x, y, phong(m, {1, 1, 1}, {luz}, i.punto, i.normal, haciaOjo(i)));
        EXPECT_LE(d, 0.51) << x << "," << y << p;
        apuntaDiferencia(d);
        return true;
    });
    EXPECT_GT(comparados, 10800); // de los 17 000 que ocupa el toro, sin los de canto
}

// --- repeticion --------------------------------------------------------------------------------------------
/// Todos los píxeles: fract o clamp de la coordenada y bilineal, y una franja blanca arriba, con el rótulo. 1 nivel: el
/// redondeo (0.5) y el de los pesos del filtro en float. Una unidad de s y de t es el alto útil entre 2.8125, y el
/// centro es (0.5, 0.5). Los modos, de dos bits: s repite, t repite.
void compruebaRepeticion(int modo, const Imagen &im, const Imagen &gpu) {
    SCOPED_TRACE(std::to_string(modo) + ", " + std::to_string(gpu.ancho) + "×" + std::to_string(gpu.alto));
    const double unidad = altoUtil(gpu.ancho, gpu.alto) / 2.8125;
    const auto esperado = [&](int x, int y) {
        return y >= gpu.alto - gpu.alto / 9
                   ? color(BLANCO)
                   : lineal(im, 0.5 + (x + 0.5 - 0.5 * gpu.ancho) / unidad,
                            0.5 + (y + 0.5 - 0.5 * gpu.alto) / unidad, modo & 1, modo & 2);
    };
    EXPECT_LE(diferenciaMaxima(gpu, esperado), 1);
}

// Los cuatro modos, y ventanas tres veces más largas: se ve más textura, no una textura deformada.
TEST(Repeticion, FractOClamp) {
    const Imagen im = alAzar(5, 3);
    const struct {
        std::string guion;
        int modo;
    } casos[] = {{"", 3},
                 {"tecla 1", 1},
                 {"tecla 2", 2},
                 {"tecla 4; tecla 5", 0},
                 {"tecla 3; tamano 270 90", 3},
                 {"tamano 90 270", 3}};
    const auto compruebaCaso = [&](const auto &c, const Vista &v) {
        compruebaRepeticion(c.modo, im, v.escena);
    };
    paraCada("repeticion", casos, 240, 180, compruebaCaso, enRgb(im));
    for (const Imagen &otra : {alAzar(1, 17), alAzar(17, 1), alAzar(1, 1)})
        compruebaRepeticion(0, otra, vistaDe("repeticion", "tecla 4", 240, 180, enRgb(otra)).escena);
}

// --- filtrado ----------------------------------------------------------------------------------------------
const int ANCHO = 240, ALTO = 180;

/// El suelo y = 0; la textura abarca 2 unidades y crece con X y hacia −Z.
Coordenadas enSuelo(double x, double y) {
    static const Camara camara = perspectiva(orbita(0.12, 0.3, 3), 0.8, 0.1, 400);
    const Rayo r = rayo(camara, ANCHO, ALTO, x, y);
    const double d = -r.origen.y / r.direccion.y;
    const Vec3 p = r.origen + d * r.direccion;
    return {d > 0 && std::max(std::fabs(p.x), std::fabs(p.z)) < 100, p.x / 2, -p.z / 2};
}

// La verdad es la media de 16 × 16 muestras por píxel de la textura (bilineal), en las filas en que todo es suelo. Cada
// filtro se le parece más que el anterior: medido en Mesa 22.3, 36.8, 23.0, 12.2 y 6.5 niveles. Es también lo que se
// exige del anisótropo, que en cada controlador es otro.
TEST(Filtrado, CadaFiltroSeAcercaMasAlSobremuestreo) {
    const Imagen im = lee("mosaico", 32, 32);
    const int N = 16;
    std::vector<std::pair<glm::ivec2, Vec3>> referencia;
    int y = 0;
    for (; enSuelo(0, y + 1).hay && enSuelo(ANCHO, y + 1).hay; ++y)
        for (int x = y % 3; x < ANCHO; x += 3) {
            Vec3 suma;
            for (int k = 0; k < N * N; ++k) {
                const Coordenadas c = enSuelo(x + (k % N + 0.5) / N, y + (k / N + 0.5) / N);
                suma = suma + lineal(im, c.s, c.t);
            }
            referencia.push_back({{x, y}, 1.0 / (N * N) * suma});
        }
    ASSERT_GT(y, 140);
    const auto gpu = vistasDe("filtrado", {"", "tecla 2", "tecla 3", "tecla 4"}, ANCHO, ALTO);
    double error[4];
    for (int k = 0; k < 4; ++k) {
        double suma = 0;
        for (const auto &[p, esperado] : referencia) {
            const Vec3 d = texel(gpu[k].escena, p.x, p.y) - esperado;
            suma += escalar(d, d) / 3;
        }
        error[k] = std::sqrt(suma / double(referencia.size()));
    }
    EXPECT_LT(error[1], 0.8 * error[0]); // poco: cuatro texels no curan nada donde un píxel abarca cientos
    EXPECT_LT(error[2], 0.6 * error[1]);
    EXPECT_LT(error[3], 0.6 * error[2]);
}

// Vecino y lineal no miran el tamaño del píxel: en su centro, el texel más cercano o el bilineal del nivel 0. En los
// vértices s y t valen ±50 y el último bit de un float vale allí 1/8192 de texel; con ocho de esos, a menos de 1/1024
// de texel de una frontera puede salir el vecino, y el bilineal se desvía 1/1024 del salto entre vecinos.
TEST(Filtrado, VecinoYLinealSonExactosEnElCentroDelPixel) {
    const Imagen im = lee("mosaico", 32, 32);
    const auto gpu = vistasDe("filtrado", {"tecla 2; tecla 1", "tecla 2"}, ANCHO, ALTO);
    const auto aLaFrontera = [](double u) { return std::fabs(u - std::round(u)); };
    const double h = 1.0 / 1024 / 32;
    int lejosDeLaFrontera = 0;
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < ANCHO; ++x) {
            const Coordenadas c = enSuelo(x + 0.5, y + 0.5);
            const Vec3 esperado = lineal(im, c.s, c.t);
            double salto = 0;
            for (const auto &[ds, dt] : {std::pair(h, h), {h, -h}, {-h, h}, {-h, -h}})
                salto = std::max(salto, distancia({0, 0, 0}, lineal(im, c.s + ds, c.t + dt) - esperado));
            EXPECT_LE(distancia(pixel(gpu[1].escena, x, y), esperado), 1 + salto) << x << "," << y;
            if (std::min(aLaFrontera(32 * c.s), aLaFrontera(32 * c.t)) >= 1.0 / 1024) {
                const Vec3 vecino =
                    texel(im, int(std::floor(32 * c.s)), int(std::floor(32 * c.t)), true, true);
                EXPECT_EQ(distancia(pixel(gpu[0].escena, x, y), vecino), 0) << x << "," << y;
                ++lejosDeLaFrontera;
            }
        }
    apuntaDiferencia(0);
    EXPECT_GT(lejosDeLaFrontera, ANCHO * 120 * 95 / 100);
}

// --- coordenadas -------------------------------------------------------------------------------------------
/// Cubo, cilindro o esfera, en el panel de la derecha: su lado menor abarca el ángulo.
struct Solido {
    std::string guion;
    int cual; // 1, 2 o 3
    // arrastrar 1 píxel gira 0.01 rad: la derecha disminuye el azimut, y abajo aumenta la elevación
    int dx = 0, dy = 0;
    const Panel panel{perspectiva(orbita(0.6 - 0.01 * dx, 0.45 - 0.01 * dy, 5.6),
                                  2 * std::atan(0.75 * std::tan(0.25)), 1, 100),
                      Hueco{96, 0, 144, 180}};

    Objeto objeto() const {
        const Mat4 depie = gira({0, 1, 0}, -1.45) * gira({1, 0, 0}, -PI / 2);
        return cual == 1   ? caja(escala(1.65))
               : cual == 2 ? cilindro(depie * escala({0.95, 0.95, 1.9}))
                           : esfera(depie * escala(1.35));
    }
    /// Las del punto que se ve: las de la parametrización exacta y, en el cubo, las de sus caras, −x +x −y +y −z +z,
    /// una a una, como las ve quien las tiene delante con Y hacia arriba.
    Coordenadas coordenadas(const Impacto &i) const {
        if (!i || cual != 1)
            return {bool(i), i.s, i.t, i.corte.cara};
        const Vec3 p = punto(objeto().inv, i.punto);
        const double s[] = {p.z, -p.z, p.x, p.x, -p.x, p.x}, t[] = {p.y, p.y, p.z, -p.z, p.y, p.y};
        return {true, 0.5 + s[i.corte.cara], 0.5 + t[i.corte.cara], i.corte.cara};
    }
};

// Con una textura cuyo rojo es s, cuyo verde es t y cuyo azul es 255, la luz multiplica los tres por igual: el azul es
// la luz fija del capítulo 3, y s y t salen de rojo/azul y verde/azul. Contra la parametrización exacta (esfera y
// cilindro sin facetas), desde arriba y, tras girar media vuelta, por detrás y desde abajo.
TEST(Coordenadas, SeLeenEnLaImagenLasDeLaParametrizacion) {
    const Imagen im = imagen(256, 256, [](int x, int y) { return Pixel{x, y, 255}; });
    const auto comprueba = [&](const Solido &s, const Vista &v) {
        const Imagen gpu = recorta(v.escena, s.panel.hueco);
        const Escena escena = {s.objeto()};
        const auto impacto = [&](double x, double y) {
            return primerImpacto(escena, rayo(s.panel.camara, s.panel.hueco.ancho, ALTO, x, y));
        };
        const auto ve = [&](double x, double y) { return s.coordenadas(impacto(x, y)); };
        int dentro = 0, comparados = 0;
        for (int y = 1; y < ALTO - 1; y += 3)
            for (int x = 1; x < s.panel.hueco.ancho - 1; x += 2) {
                const Coordenadas c = ve(x + 0.5, y + 0.5);
                dentro += c.hay;
                // junto a la costura el filtro mezcla s = 1 con s = 0; de canto o en un polo caben muchos texels
                const double rho = texelsPorPixel(ve, x, y, im);
                if (rho > 16 || std::min({c.s, 1 - c.s, c.t, 1 - c.t}) < 0.06)
                    continue;
                const Vec3 p = texel(gpu, x, y);
                const double aLuz = std::fabs(p.z - 255 * luzFija(impacto(x + 0.5, y + 0.5).normal));
                apuntaDiferencia(aLuz);
                EXPECT_LE(aLuz, 1.5) << x << "," << y;
                // el valor del texel i es i, así que en s vale 256·s − 0.5, más lo que se redondean los mipmaps (0.5:
                // 2i y 2i + 1 dan 2i + 1, y así en cada nivel). Medio nivel de redondeo se agranda al dividir por la
                // luz, y las facetas y el float mueven el punto hasta 0.1 píxeles
                const double cota = 0.5 + 255 / p.z + 0.1 * rho;
                EXPECT_NEAR(255 * p.x / p.z, 256 * c.s - 0.5, cota) << x << "," << y;
                EXPECT_NEAR(255 * p.y / p.z, 256 * c.t - 0.5, cota) << x << "," << y;
                ++comparados;
            }
        EXPECT_GT(comparados, dentro / 2);
    };
    const Solido casos[] = {{"", 1},
                            {"tecla 2", 2},
                            {"tecla 3", 3},
                            {arrastra({0, 0}, {314, -90}), 3, 314, 90},
                            {"tecla 2", 2, 314, 90},
                            {"tecla 1", 1, 314, 90}};
    paraCada("coordenadas", casos, ANCHO, ALTO, comprueba, enRgb(im));
}

// --- multitextura ------------------------------------------------------------------------------------------
using Texturas = std::array<Imagen, 4>; // lo que hay en cada unidad

/// La pared de 4 × 3, vista de frente en el panel de la derecha, el 78 % del ancho, con la mezcla de cada tecla.
void compruebaPared(const Imagen &gpu, const Texturas &texturas, int tecla) {
    SCOPED_TRACE("tecla " + std::to_string(tecla));
    const int columna = gpu.ancho * 22 / 100, resto = gpu.ancho - columna;
    const double unidad = resto / (2 * 5 * std::tan(0.62 / 2) * 4 / 3);
    const auto mezcla = [&](double s, double t) {
        Vec3 c = lineal(texturas[0], 2 * s, 1.5 * t);
        if (tecla != 2) {
            const double m = lineal(texturas[2], s, t, false, false).x / 255;
            c = (1 - m) * c + m * lineal(texturas[1], 2 * s, 1.5 * t);
        }
        return tecla != 1 ? 1 / 255.0 * (c * lineal(texturas[3], s, t, false, false)) : c;
    };
    const auto esperado = [&](int x, int y) {
        const double s = 0.5 + (x + 0.5 - 0.5 * resto) / (4 * unidad),
                     t = 0.5 + (y + 0.5 - 0.5 * gpu.alto) / (3 * unidad);
        return s < 0 || s > 1 || t < 0 || t > 1 ? color(FONDO_OSCURO) : mezcla(s, t);
    };
    EXPECT_LE(diferenciaMaxima(recorta(gpu, {columna, 0, resto, gpu.alto}), esperado), 1);
}

// Las texturas de verdad, en una ventana tan grande que ninguna se reduce (512 texels en 629 píxeles): la mezcla, en la
// CPU, de cuatro bilineales. Cada textura está en su unidad y cada sampler2D lee la suya.
TEST(Multitextura, LaMezclaCalculadaEnLaCpu) {
    const Texturas x = {lee("ladrillo", 256, 256), lee("musgo", 256, 256), lee("mascara", 128, 96),
                        lee("luz", 64, 48)};
    const auto gpu = vistasDe("multitextura", {"tecla 1", "tecla 2", "tecla 3", "tecla c"}, 960, 720);
    for (int tecla = 1; tecla <= 3; ++tecla)
        compruebaPared(gpu[tecla - 1].escena, x, tecla);
    compruebaPared(gpu[3].escena, {lee("madera", 256, 256), x[1], x[2], x[3]}, 3);
    EXPECT_EQ(gpu[3].encima.rotulos("0 madera").size(), 1u);
}

} // namespace
