// El desplazamiento de polígono de las sombras proyectivas: con poco, sombra y mesa se cosen; con mucho, la sombra tapa
// lo que está encima de la mesa. Frente a la sombra trazada.
#include "buferes.h"
#include "ch03_transformaciones/transformaciones.h"
#include "ch07_realismo/sombra.h"
#include "gpu.h"
#include "herramientas/oraculo/oraculo.h"
#include "mide.h"
#include "orbita.h"
#include <glm/gtc/matrix_transform.hpp>

using namespace mide;

static const double ANGULO_SOMBRAS = 0.45, RADIO = 0.5;
static const glm::vec3 CENTRO(0.2f, 0.5f, 0);

static void mideSombras(Medidor &m) {
    abreContexto();
    glEnable(GL_DEPTH_TEST);
    const Framebuffer framebuffer(m.elige(64, 400), m.elige(48, 300));
    const GLuint programa = creaPrograma("herramientas/mide/liso.vert", "ch07_realismo/liso.frag");
    const Buferes mesa = creaBuferes(plano(1)), bola = creaBuferes(esfera(64));
    const glm::mat4 tablero = giroX(-1.57079633f) * escalado(5.0f),
                    M = traslacion(CENTRO) * escalado(float(RADIO));
    const Plano suelo = {{0, 1, 0}, 0};
    const struct {
        Orbita orbita;
        glm::vec3 luz;
    } VISTAS[] = {{{0.25f, 0.42f, 8}, {-1.8f, 3.6f, 0.8f}},
                  {{1.3f, 0.1f, 8}, {-1.8f, 2.0f, 0.8f}},
                  {{-2.1f, 0.05f, 9}, {1.2f, 1.6f, -1}},
                  {{0.6f, 1.2f, 8}, {0.5f, 3, 2.2f}}};
    const auto dibuja = [&](std::size_t i, float factor, float unidades) {
        const auto &v = VISTAS[i];
        const auto pinta = [&](const Buferes &b, const glm::mat4 &modelo, const glm::vec4 &color) {
            envia(programa, "M", modelo);
            envia(programa, "color", color);
            ::dibuja(b);
        };
        framebuffer.borra(1, 1, 1);
        glUseProgram(programa);
        envia(programa, "vista",
              glm::perspective(float(ANGULO_SOMBRAS), float(framebuffer.ancho) / float(framebuffer.alto),
                               1.0f, 60.0f) *
                  camaraOrbita(v.orbita));
        pinta(mesa, tablero, {1, 1, 1, 1});
        pinta(bola, M, {1, 0, 0, 1});
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(factor, unidades);
        pinta(bola, proyeccionSombra(glm::vec4(v.luz, 1), suelo) * M, {0, 0, 0, 1});
        glDisable(GL_POLYGON_OFFSET_FILL);
    };
    const auto xyz = [](const glm::vec3 &v) { return oraculo::Vec3{v.x, v.y, v.z}; };
    const oraculo::Escena escena = {
        oraculo::plano(oraculo::gira({1, 0, 0}, -0.5 * oraculo::PI) * oraculo::escala(5)),
        oraculo::esfera(oraculo::traslada(xyz(CENTRO)) * oraculo::escala(RADIO))};
    std::vector<oraculo::ImagenRef> refs;
    for (const auto &v : VISTAS) {
        oraculo::Luz luz;
        luz.posicion = xyz(v.luz);
        const oraculo::Camara camara = oraculo::perspectiva(
            oraculo::orbita(v.orbita.azimut, v.orbita.elevacion, v.orbita.distancia), ANGULO_SOMBRAS, 1, 60);
        refs.push_back(oraculo::render(
            escena, camara, framebuffer.ancho, framebuffer.alto, [&](const oraculo::Impacto &i) {
                const bool sombra = i.objeto == 0 && oraculo::enSombra({escena[1]}, i.punto, luz);
                return oraculo::Tono(i.objeto == 1 ? oraculo::Vec3{1, 0, 0}
                                     : sombra      ? oraculo::Vec3{}
                                                   : oraculo::Vec3{1, 1, 1},
                                     sombra);
            }));
    }
    m.referencia = oraculo::enBytes(refs[0]);
    for (const auto &[factor, unidades] : {std::pair(0.0f, 0.0f),
                                           {0.0f, -1.0f},
                                           {0.0f, -2.0f},
                                           {-0.25f, -2.0f},
                                           {-1.0f, -1.0f},
                                           {-1.0f, -100.0f},
                                           {-10.0f, -10000.0f},
                                           {0.0f, -1000000.0f}}) {
        double cosido = 0, encima = 0, sombra = 0;
        Imagen imagen;
        for (std::size_t k = 0; k < refs.size(); ++k) {
            dibuja(k, factor, unidades);
            const Imagen gpu = framebuffer.lee();
            if (k == 0)
                imagen = gpu;
            for (int y = 0; y < framebuffer.alto; ++y)
                for (int x = 0; x < framebuffer.ancho; ++x) {
                    if (oraculo::enBanda(refs[k], x, y))
                        continue;
                    const oraculo::PixelRef &p = refs[k].en(x, y);
                    const bool mal = oraculo::diferencia(gpu, x, y, p.color) > 2;
                    sombra += p.zona;
                    cosido += p.zona && mal;
                    encima += !p.zona && mal;
                }
        }
        char nombre[40], nota[80];
        std::snprintf(nombre, sizeof nombre, "(%g, %g)", double(factor), double(unidades));
        std::snprintf(nota, sizeof nota, "falta %.2g %% de la sombra y sobra %.2g %%", 100 * cosido / sombra,
                      100 * encima / sombra);
        m.variante(nombre, 100 * (cosido + encima) / sombra, 1,
                   yEspera([&, f = factor, u = unidades] { dibuja(0, f, u); }),
                   unidades == -2 && factor != 0 ? Rango{0, 0.5} : CUALQUIERA, nota, imagen);
    }
}

static const Apunta
    APUNTA({17, "sombras", "El desplazamiento de las sombras", "ms por imagen de 400×300",
            "% de la sombra mal, en cuatro vistas, frente a trazar rayos", "(-0.25, -2)",
            "El tiempo es el mismo: se elige el menor desplazamiento con el que ya no se cose ninguna vista.",
            mideSombras});
