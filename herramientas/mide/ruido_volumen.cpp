// Hacer el volumen de ruido que guarda textura3d.
#include "ch08_texturas_avanzadas/textura3d.h"
#include "mide.h"
#include <array>
#ifdef LAB_PAR_LIBNOISE
#include <libnoise/noise.h>
#endif

using namespace mide;

template<class T>
static std::vector<unsigned char> volumen(int n, int octavas) {
    std::vector<unsigned char> texels;
    for (int i = 0; i < n * n * n; ++i) {
        const glm::vec<3, T> p =
            T(CELDAS) / static_cast<T>(n) * (glm::vec<3, T>(i % n, i / n % n, i / n / n) + T(0.5));
        texels.push_back(static_cast<unsigned char>(std::lround(
            T(255) * glm::clamp(T(0.5) + T(0.5) * turbulencia(p, octavas, glm::ivec3(CELDAS)), T(0), T(1)))));
    }
    return texels;
}

/// Los de detalle_ruido::gradiente, según el eje nulo y los tres bits de los signos.
static const std::array<std::array<glm::vec3, 8>, 3> GRADIENTES = [] {
    std::array<std::array<glm::vec3, 8>, 3> t;
    for (std::size_t eje = 0; eje < 3; ++eje)
        for (std::size_t s = 0; s < 8; ++s) {
            t[eje][s] = glm::vec3(s & 1 ? -1 : 1, s & 2 ? -1 : 1, s & 4 ? -1 : 1);
            t[eje][s][static_cast<int>(eje)] = 0;
        }
    return t;
}();

/// El mismo ruido sin su gradiente: la parte del hash de cada eje se hace una vez y no ocho, y se mezcla de dos en dos.
static float soloValor(const glm::vec3 &p, const glm::ivec3 &periodo) {
    const auto suelo = [](float x) { // std::floor es una llamada en un x86-64 cualquiera
        const int i = static_cast<int>(x);
        return i - (x < static_cast<float>(i));
    };
    const glm::ivec3 celda(suelo(p.x), suelo(p.y), suelo(p.z)),
        primero = detalle_ruido::resto(celda, periodo);
    const glm::vec3 f = p - glm::vec3(celda);
    const auto hash = [&](int eje, int lado, std::uint32_t primo) {
        const int nodo = primero[eje] + lado;
        return static_cast<std::uint32_t>(nodo == periodo[eje] ? 0 : nodo) * primo;
    };
    const std::uint32_t hx[2] = {hash(0, 0, 0x8da6b343u), hash(0, 1, 0x8da6b343u)},
                        hy[2] = {hash(1, 0, 0xd8163841u), hash(1, 1, 0xd8163841u)},
                        hz[2] = {hash(2, 0, 0xcb1ab31fu), hash(2, 1, 0xcb1ab31fu)};
    const auto rampa = [&](std::size_t i, std::size_t j, std::size_t k) {
        std::uint32_t h = hx[i] ^ hy[j] ^ hz[k];
        h = (h ^ (h >> 15)) * 0x2c1b3c6du;
        h = (h ^ (h >> 12)) * 0x297a2d39u;
        h ^= h >> 15;
        const std::uint32_t nulo = ((h >> 16) * 3u) >> 16; // el gradiente, de una tabla: signos y eje nulo
        const glm::vec3 &g = GRADIENTES[nulo][h & 7u];
        return g.x * (f.x - static_cast<float>(i)) + g.y * (f.y - static_cast<float>(j)) +
               g.z * (f.z - static_cast<float>(k));
    };
    const glm::vec3 u = f * f * f * (f * (f * 6.0f - 15.0f) + 10.0f);
    const auto mezcla = [](float a, float b, float t) { return a + t * (b - a); };
    const auto enX = [&](std::size_t j, std::size_t k) {
        return mezcla(rampa(0, j, k), rampa(1, j, k), u.x);
    };
    return mezcla(mezcla(enX(0, 0), enX(1, 0), u.y), mezcla(enX(0, 1), enX(1, 1), u.y), u.z);
}

static std::vector<unsigned char> volumenSoloValor(int n) {
    std::vector<unsigned char> texels;
    for (int i = 0; i < n * n * n; ++i) {
        const glm::vec3 p =
            float(CELDAS) / static_cast<float>(n) * (glm::vec3(i % n, i / n % n, i / n / n) + 0.5f);
        float suma = 0;
        for (int o = 0; o < OCTAVAS; ++o) {
            const float frecuencia = static_cast<float>(1 << o);
            suma += soloValor(p * frecuencia + glm::vec3(5.375f, 3.625f, 7.75f) * static_cast<float>(o),
                              glm::ivec3(CELDAS << o)) /
                    frecuencia;
        }
        texels.push_back(
            static_cast<unsigned char>(std::lround(255 * glm::clamp(0.5f + 0.5f * suma, 0.0f, 1.0f))));
    }
    return texels;
}

static void mideVolumen(Medidor &m) {
    const int n = m.talla(8, 64);
    const double muestras = double(n) * n * n;
    const std::vector<unsigned char> exacto = volumen<double>(n, OCTAVAS);
    const auto variante = [&](const std::string &nombre,
                              const std::function<std::vector<unsigned char>()> &hace, const Rango &espera,
                              const char *nota = "") {
        const std::vector<unsigned char> texels = hace();
        double suma = 0;
        for (std::size_t i = 0; i < exacto.size(); ++i)
            suma += std::pow(texels[i] - exacto[i], 2);
        m.variante(
            nombre, std::sqrt(suma / muestras), muestras, [&] { usa(hace()); }, espera, nota);
    };
    variante("en float", [&] { return volumen<float>(n, OCTAVAS); }, {0, 0.05});
    variante("en double", [&] { return volumen<double>(n, OCTAVAS); }, {0, 0});
    if (!m.ensayo)
        variante("texelsRuido", texelsRuido, {0, 0.05}, "lo que llama el programa");
    variante(
        "solo el valor, en float", [&] { return volumenSoloValor(n); }, {0, 0.05},
        "sin el gradiente y sin repetir el hash");
    for (const int octavas : {1, 2})
        variante("en float, octavas: " + std::to_string(octavas), [&] { return volumen<float>(n, octavas); },
                 {1, 60});
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
                texels.push_back(static_cast<unsigned char>(std::lround(
                    255 * glm::clamp(0.5 + 0.5 * perlin.GetValue(i % n * 0.0625, i / n % n * 0.0625,
                                                                 i / n / n * 0.0625),
                                     0.0, 1.0))));
            return texels;
        };
        m.variante(
            std::string("par: libnoise, ") + c.nombre, NAN, muestras, [&] { usa(hace()); }, CUALQUIERA,
            "otro ruido: solo se compara el tiempo; no se repite");
    }
#endif
}

static const Apunta APUNTA({13, "ruido_volumen", "Hacer un volumen de ruido", "ns por muestra de 3 octavas",
                            "niveles de 255 (RMSE), frente a double", "texelsRuido",
                            "texelsRuido llama a la función que da también el gradiente, que bump_ruido "
                            "necesita y textura3d no: sin él tardaría la tercera parte.",
                            mideVolumen});
