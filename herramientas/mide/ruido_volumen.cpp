// Hacer el volumen de ruido que guarda textura3d.
#include "ch08_texturas_avanzadas/textura3d.h"
#include "mide.h"
#ifdef LAB_PAR_LIBNOISE
#include <libnoise/noise.h>
#endif

using namespace mide;

template<class T>
static std::vector<unsigned char> volumen(int n, int octavas) {
    std::vector<unsigned char> texels;
    for (int i = 0; i < n * n * n; ++i) {
        const glm::vec<3, T> p = T(CELDAS) / static_cast<T>(n) * (glm::vec<3, T>(i % n, i / n % n, i / n / n) + T(0.5));
        texels.push_back(static_cast<unsigned char>(std::lround(T(255) * glm::clamp(T(0.5) + T(0.5) * turbulencia(p, octavas, glm::ivec3(CELDAS)), T(0), T(1)))));
    }
    return texels;
}

static void mideVolumen(Medidor &m) {
    const int n = m.talla(8, 64);
    const double muestras = double(n) * n * n;
    const std::vector<unsigned char> exacto = volumen<double>(n, OCTAVAS);
    const auto variante = [&](const std::string &nombre, const std::function<std::vector<unsigned char>()> &hace, const Rango &espera, const char *nota = "") {
        const std::vector<unsigned char> texels = hace();
        double suma = 0;
        for (std::size_t i = 0; i < exacto.size(); ++i)
            suma += std::pow(texels[i] - exacto[i], 2);
        m.variante(nombre, std::sqrt(suma / muestras), muestras, [&] { usa(hace()); }, espera, nota);
    };
    variante("en float", [&] { return volumen<float>(n, OCTAVAS); }, {0, 0.05});
    variante("en double", [&] { return volumen<double>(n, OCTAVAS); }, {0, 0});
    if (!m.ensayo)
        variante("texelsRuido", texelsRuido, {0, 0.05}, "lo que llama el programa");
    for (const int octavas : {1, 2})
        variante("en float, octavas: " + std::to_string(octavas), [&] { return volumen<float>(n, octavas); }, {1, 60});
#ifdef LAB_PAR_LIBNOISE
    const struct {
        const char *nombre;
        noise::NoiseQuality calidad;
    } CALIDADES[] = {{"rápida", noise::QUALITY_FAST}, {"normal", noise::QUALITY_STD}, {"mejor", noise::QUALITY_BEST}};
    for (const auto &c : CALIDADES) {
        noise::module::Perlin perlin;
        perlin.SetNoiseQuality(c.calidad);
        perlin.SetOctaveCount(OCTAVAS);
        const auto hace = [&] {
            std::vector<unsigned char> texels;
            for (int i = 0; i < n * n * n; ++i)
                texels.push_back(static_cast<unsigned char>(std::lround(255 * glm::clamp(0.5 + 0.5 * perlin.GetValue(i % n * 0.0625, i / n % n * 0.0625, i / n / n * 0.0625), 0.0, 1.0))));
            return texels;
        };
        m.variante(std::string("par: libnoise, ") + c.nombre, NAN, muestras, [&] { usa(hace()); }, CUALQUIERA, "otro ruido: solo se compara el tiempo; no se repite");
    }
#endif
}

static const Apunta APUNTA({13, "ruido_volumen", "Hacer un volumen de ruido", "ns por muestra de 3 octavas", "niveles de 255 (RMSE), frente a double", "texelsRuido",
                            "En float se hace casi igual que en double. El ruido da también su gradiente, que textura3d no usa.",
                            mideVolumen});
