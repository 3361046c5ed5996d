// Hacer el volumen de ruido que guarda textura3d.
#include "ch08_texturas_avanzadas/textura3d.h"
#include "mide.h"
#ifdef LAB_PAR_LIBNOISE
#include <libnoise/noise.h>
#endif

using namespace mide;

// Los texels de textura3d, de n en n, con esa turbulencia.
template<class T, class Turbulencia>
static std::vector<unsigned char> volumen(int n, const Turbulencia &turbulencia) {
    std::vector<unsigned char> texels;
    for (int i = 0; i < n * n * n; ++i) {
        const glm::vec<3, T> p = T(CELDAS) / T(n) * (glm::vec<3, T>(i % n, i / n % n, i / n / n) + T(0.5));
        texels.push_back(enOchoBits(T(0.5) + T(0.5) * turbulencia(p)));
    }
    return texels;
}

static void mideVolumen(Medidor &m) {
    const int n = LADO_TEXTURA;
    const double muestras = double(n) * n * n;
    const auto valor = [](int octavas) {
        return [=](const auto &p) { return turbulencia(p, octavas, glm::ivec3(CELDAS)); };
    };
    const std::vector<unsigned char> exacto = volumen<double>(n, valor(OCTAVAS));
    const auto variante = [&](const std::string &nombre,
                              const std::function<std::vector<unsigned char>()> &hace,
                              const char *nota = "") {
        const std::vector<unsigned char> texels = hace();
        double suma = 0;
        for (std::size_t i = 0; i < exacto.size(); ++i)
            suma += std::pow(texels[i] - exacto[i], 2);
        m.variante(
            nombre, std::sqrt(suma / muestras), muestras, [&] { usa(hace()); }, nota);
    };
    variante("texelsRuido", texelsRuido, "lo que llama el programa: el valor, en float");
    variante("el valor, en double", [&] { return volumen<double>(n, valor(OCTAVAS)); });
    variante(
        "con el gradiente",
        [&] {
            return volumen<float>(n, [](const glm::vec3 &p) {
                return turbulenciaConGradiente(p, OCTAVAS, glm::ivec3(CELDAS)).w;
            });
        },
        "y se tira");
    for (const int octavas : {1, 2})
        variante(octavas == 1 ? "1 octava" : "2 octavas", [&] { return volumen<float>(n, valor(octavas)); });
#ifdef LAB_PAR_LIBNOISE
    const struct {
        const char *nombre;
        noise::NoiseQuality calidad;
    } CALIDADES[] = {
        {"rápida", noise::QUALITY_FAST}, {"normal", noise::QUALITY_STD}, {"mejor", noise::QUALITY_BEST}};
    for (const auto &c : CALIDADES) {
        noise::module::Perlin perlin;
        perlin.SetNoiseQuality(c.calidad);
        perlin.SetOctaveCount(OCTAVAS);
        const auto hace = [&] {
            std::vector<unsigned char> texels;
            for (int i = 0; i < n * n * n; ++i)
                texels.push_back(enOchoBits(
                    0.5 + 0.5 * perlin.GetValue(i % n * 0.0625, i / n % n * 0.0625, i / n / n * 0.0625)));
            return texels;
        };
        m.variante(
            std::string("par: libnoise, ") + c.nombre, NAN, muestras, [&] { usa(hace()); },
            "otro ruido: solo se compara el tiempo; no se repite");
    }
#endif
}

static const Apunta
    APUNTA({13, "ruido_volumen", "Hacer un volumen de ruido", "ns por muestra de 3 octavas",
            "niveles de 255 (RMSE), frente a double", "texelsRuido",
            "textura3d no necesita el gradiente: sin él, y con el hash de cada eje hecho una vez, cuesta "
            "la tercera parte. El float no se nota: ningún texel cambia más de un nivel.",
            mideVolumen});
