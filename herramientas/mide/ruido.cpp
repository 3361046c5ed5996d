// El ruido de textura3d en un corte del bloque: leído de una textura 3D o calculado en el shader. Y hacer su textura.
#include "ch08_texturas_avanzadas/textura3d.h"
#include "gpu.h"
#include "shader.h"
#ifdef LAB_PAR_LIBNOISE
#include <libnoise/noise.h>
#endif

using namespace mide;

template<class T>
static T valor(const glm::vec<3, T> &p) {
    return (1 + turbulencia(p, OCTAVAS, glm::ivec3(CELDAS))) / 2;
}

// Lo mismo que texelsRuido, de otro lado y en otro tipo.
template<class T>
static std::vector<unsigned char> texels(int n) {
    std::vector<unsigned char> hechos;
    for (int i = 0; i < n * n * n; ++i) {
        const glm::vec<3, T> p = T(CELDAS) / T(n) * (glm::vec<3, T>(i % n, i / n % n, i / n / n) + T(0.5));
        hechos.push_back(enOchoBits(valor(p)));
    }
    return hechos;
}

static void mideVolumen(Medidor &m) {
    m.grupo = "hacer la textura";
    double suma = 0;
    const std::vector<unsigned char> hechos = texelsRuido(), exactos = texels<double>(LADO_TEXTURA);
    for (std::size_t i = 0; i < exactos.size(); ++i)
        suma += std::pow(hechos[i] - exactos[i], 2);
    m.variante("textura de 64³, hacerla", "lo que llama el programa: el valor, en float",
               std::sqrt(suma / double(exactos.size())), 1, [] { usa(texelsRuido()); });
#ifdef LAB_PAR_LIBNOISE
    noise::module::Perlin perlin;
    perlin.SetOctaveCount(OCTAVAS);
    m.variante("par: libnoise", "otro ruido: solo se compara el tiempo; no se repite", NAN, 1, [&] {
        std::vector<unsigned char> suyos;
        for (int i = 0; i < LADO_TEXTURA * LADO_TEXTURA * LADO_TEXTURA; ++i) {
            const glm::dvec3 p = 0.0625 * glm::dvec3(i % LADO_TEXTURA, i / LADO_TEXTURA % LADO_TEXTURA,
                                                     i / LADO_TEXTURA / LADO_TEXTURA);
            suyos.push_back(enOchoBits(0.5 + 0.5 * perlin.GetValue(p.x, p.y, p.z)));
        }
        usa(suyos);
    });
#endif
}

static void mideRuido(Medidor &m) {
    const int lado = m.elige(32, 512);
    const Framebuffer framebuffer(lado, lado);
    std::vector<double> exacta;
    for (int y = 0; y < lado; ++y)
        for (int x = 0; x < lado; ++x) {
            const glm::dvec3 p = double(CELDAS) * glm::dvec3((x + 0.5) / lado, (y + 0.5) / lado, 0.3);
            exacta.insert(exacta.end(), 3, 255 * glm::clamp(valor(p), 0.0, 1.0));
        }
    m.referencia = redondeada(lado, lado, exacta);
    const GLuint programa = creaPrograma("ch09_imagen/imagen.vert", "herramientas/mide/ruido.frag");
    glUseProgram(programa);
    envia(programa, "ruidoGuardado", 0);
    const Dibujadas dibujada{m, framebuffer, [&](const Imagen &i) { return rmse(i, exacta); }};
    const auto variante = [&](const std::string &nombre, const std::string &nota, int octavas) {
        envia(programa, "octavas", octavas);
        dibujada(nombre, nota, [&] {
            framebuffer.abre();
            dibujaRectangulo();
        });
    };
    for (const int n : m.elige<std::vector<int>>({16, 64}, {16, 32, 64, 128})) {
        GLuint textura;
        glGenTextures(1, &textura);
        glBindTexture(GL_TEXTURE_3D, textura);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glTexImage3D(GL_TEXTURE_3D, 0, GL_R8, n, n, n, 0, GL_RED, GL_UNSIGNED_BYTE, texels<float>(n).data());
        glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        variante(formatea("textura de %d³", n), formatea("%.3g kB", n * n * n / 1000.0), 0);
        glDeleteTextures(1, &textura);
    }
    variante("en el shader, 1 octava", "sin memoria", 1);
    variante("en el shader, 3 octavas", "sin memoria", OCTAVAS);
    mideVolumen(m);
}

static const Apunta APUNTA({12, "ruido", "Ruido: guardarlo o calcularlo",
                            "ms por imagen de 512×512, o por textura",
                            "niveles de 255 (RMSE), frente a double", "textura de 64³",
                            "La textura de 64³ ocupa lo que una foto y se equivoca pocos niveles. Calcularlo "
                            "es exacto y cuesta varias veces más: es lo que "
                            "hacen los programas que lo necesitan sin que se repita, o con su gradiente.",
                            mideRuido});
