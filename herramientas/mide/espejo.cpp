// Una esfera sobre un espejo: dibujarla otra vez, simétrica (ecuación 7.3), con más o menos malla, frente a trazar
// rayos.
#include "ch07_realismo/reflexion.h"
#include "escena.h"

using namespace mide;

static const float ALTO_ESFERA = 0.45f, RADIO_ESFERA = 0.55f, ALTO_ESPEJO = -0.15f;

static void mideEspejo(Medidor &m) {
    abreContexto();
    glEnable(GL_DEPTH_TEST);
    const Framebuffer framebuffer(m.elige(64, 960), m.elige(48, 720));
    const glm::mat4 M = traslacion({0, ALTO_ESFERA, 0}) * escalado(RADIO_ESFERA),
                    simetria = reflexion({{0, 1, 0}, -ALTO_ESPEJO});
    const oraculo::Escena esfera = {oraculo::esfera(oraculo::traslada({0, double(ALTO_ESFERA), 0}) *
                                                    oraculo::escala(double(RADIO_ESFERA)))};
    oraculo::Escena escena = esfera;
    escena.push_back(oraculo::plano(oraculo::traslada({0, double(ALTO_ESPEJO), 0}) *
                                    oraculo::gira({1, 0, 0}, -0.5 * oraculo::PI) * oraculo::escala(400)));
    const auto color = [](const oraculo::Impacto &i) {
        return i ? phongExacto(i.punto, i.normal, i.rayo.origen) : exacto(FONDO);
    };
    const oraculo::ImagenRef ref = oraculo::render(
        escena, camaraExacta(), framebuffer.ancho, framebuffer.alto, [&](const oraculo::Impacto &i) {
            if (i.objeto != 1)
                return oraculo::Tono(color(i));
            const oraculo::Impacto visto = oraculo::primerImpacto(esfera, oraculo::rebote(i));
            return oraculo::Tono(color(visto), visto ? 1 : 0);
        });
    m.referencia = oraculo::enBytes(ref);
    const GLuint programa = creaSombreado("phong");
    enviaEscena(programa, framebuffer);
    for (const int n : m.elige<std::vector<int>>({12, 96}, {12, 24, 48, 96, 192})) {
        const Buferes b = creaBuferes(::esfera(n));
        const auto dibuja = [&] {
            framebuffer.borra(FONDO);
            for (const glm::mat4 &mundo : {glm::mat4(1), simetria}) { // con su luz, también simétrica
                glUseProgram(programa);
                enviaLuz(programa, "luz", LUZ, camaraEscena() * mundo);
                dibujaIluminado(programa, b, mundo * M, camaraEscena(), CORAL);
            }
        };
        mideImagen(m, formatea("simétrica, esferas de %d", n), framebuffer, dibuja, [&](const Imagen &i) {
            return errorDonde(i, ref, [&](int x, int y) { return !oraculo::enBanda(ref, x, y); });
        });
        borraBuferes(b);
    }
}

static const Apunta
    APUNTA({18, "espejo", "Un espejo plano", "ms por imagen de 960×720",
            "niveles de 255 (RMSE), frente a trazar rayos, fuera del contorno", "simétrica, esferas de 96",
            "Dibujar la escena otra vez da el mismo espejo que trazar rayos. La malla tiene los "
            "segmentos de segmentosEsfera, unos cien.",
            mideEspejo});
