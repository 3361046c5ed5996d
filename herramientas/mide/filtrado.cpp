// El suelo de filtrado.cpp: los filtros de la textura frente a 16 × 16 muestras por píxel.
#include "buferes.h"
#include "ch03_transformaciones/transformaciones.h"
#include "escena.h"
#include "orbita.h"
#include "rutas.h"
#include <glm/gtc/constants.hpp>

using namespace mide;

static const int TALLA = 32, MUESTRAS = 16;
static const double LARGO = 200, LADO = 2, ANGULO_SUELO = 0.8;
static const Orbita ORBITA = {0.12f, 0.3f, 3};

// La textura, con filtro lineal y repetida, en double.
static oraculo::Vec3 lineal(const Imagen &t, double s, double v) {
    const double x = s * TALLA - 0.5, y = v * TALLA - 0.5, i = std::floor(x), j = std::floor(y), a = x - i,
                 b = y - j;
    const auto texel = [&](double c, double f) {
        const int u = (int(c) % TALLA + TALLA) % TALLA, w = (int(f) % TALLA + TALLA) % TALLA;
        const std::size_t k = 3 * (w * TALLA + u);
        return oraculo::Vec3{double(t.rgb[k]), double(t.rgb[k + 1]), double(t.rgb[k + 2])};
    };
    return (1 - b) * ((1 - a) * texel(i, j) + a * texel(i + 1, j)) +
           b * ((1 - a) * texel(i, j + 1) + a * texel(i + 1, j + 1));
}

static std::vector<double> exacto(const Imagen &textura, int ancho, int alto, int muestras) {
    const oraculo::Camara camara = oraculo::perspectiva(
        oraculo::orbita(ORBITA.azimut, ORBITA.elevacion, ORBITA.distancia), ANGULO_SUELO, 0.1, 400);
    const oraculo::Ejes ejes = oraculo::ejes(camara);
    const double porPixel = 2 * camara.semilado / alto;
    std::vector<double> rgb;
    for (int y = 0; y < alto; ++y)
        for (int x = 0; x < ancho; ++x) {
            oraculo::Vec3 suma;
            for (int k = 0; k < muestras * muestras; ++k) {
                const double px = x + (k % muestras + 0.5) / muestras - 0.5 * ancho,
                             py = y + (k / muestras + 0.5) / muestras - 0.5 * alto;
                const oraculo::Vec3 d = porPixel * px * ejes.x + porPixel * py * ejes.y - ejes.z;
                const double t = -camara.ojo.y / d.y, X = camara.ojo.x + t * d.x, Z = camara.ojo.z + t * d.z;
                const bool suelo = t > 0 && std::fabs(X) < LARGO / 2 && std::fabs(Z) < LARGO / 2;
                suma = suma + (suelo ? lineal(textura, X / LADO, -Z / LADO) : 255.0 * mide::exacto(CIELO));
            }
            for (int c = 0; c < 3; ++c)
                rgb.push_back(suma[c] / (muestras * muestras));
        }
    return rgb;
}

static void mideFiltrado(Medidor &m) {
    const Framebuffer framebuffer(m.elige(64, 480), m.elige(48, 360));
    const Imagen imagen = leeTextura(recurso("assets/mosaico.rgb"), TALLA, TALLA);
    const std::vector<double> ref = exacto(imagen, framebuffer.ancho, framebuffer.alto, m.elige(4, MUESTRAS));
    m.referencia = redondeada(framebuffer.ancho, framebuffer.alto, ref);
    const GLuint programa = creaPrograma("ch06_texturas/textura.vert", "ch06_texturas/textura.frag");
    Malla malla = plano(1);
    for (Vertice &v : malla.vertices)
        v.coordTextura = (v.coordTextura - 0.5f) * float(LARGO / LADO);
    const Buferes suelo = creaBuferes(malla);
    creaTextura2D(imagen);
    glEnable(GL_DEPTH_TEST);
    glUseProgram(programa);
    envia(programa, "proyeccion",
          glm::perspective(float(ANGULO_SUELO), float(framebuffer.ancho) / float(framebuffer.alto), 0.1f,
                           400.0f));
    envia(programa, "camara", camaraOrbita(ORBITA));
    envia(programa, "M", giroX(-glm::half_pi<float>()) * escalado(float(LARGO)));
    envia(programa, "Img", 0);
    const Dibujadas dibujada{m, framebuffer, [&](const Imagen &i) { return rmse(i, ref); }};
    const auto variante = [&](const char *nombre, GLint ampliacion, GLint reduccion, float anisotropia) {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, ampliacion);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, reduccion);
        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, anisotropia);
        dibujada(nombre, "", [&] {
            framebuffer.borra(CIELO);
            dibujaMalla(suelo);
        });
    };
    variante("vecino", GL_NEAREST, GL_NEAREST, 1);
    variante("lineal", GL_LINEAR, GL_LINEAR, 1);
    variante("mipmap, vecino", GL_LINEAR, GL_NEAREST_MIPMAP_NEAREST, 1);
    variante("mipmap, el nivel más próximo", GL_LINEAR, GL_LINEAR_MIPMAP_NEAREST, 1);
    variante("mipmap trilineal", GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR, 1);
    if (!m.ensayo) // en una imagen diminuta un píxel abarca miles de texels, y tarda segundos en recorrerlos
        variante("anisótropo ×16", GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR, 16);
}

static const Apunta APUNTA({9, "filtrado", "Filtros de la textura", "ms por imagen de 480×360",
                            "niveles de 255 (RMSE), frente a 16×16 muestras por píxel", "mipmap trilineal",
                            "Sin mipmaps el suelo lejano parpadea y el error es el mayor. creaTextura2D pone "
                            "el trilineal; el anisótropo "
                            "se acerca más, pero es una extensión y, sin GPU, tarda veinte veces más.",
                            mideFiltrado});
