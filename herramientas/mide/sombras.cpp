// El desplazamiento de polígono de las sombras proyectivas: con poco, sombra y mesa se cosen; con mucho, la sombra tapa
// lo que está encima de la mesa. Frente a la sombra trazada.
#include "ch07_realismo/sombra.h"
#include "escena.h"
#include "orbita.h"

using namespace mide;

static const double ANGULO_SOMBRAS = 0.45, RADIO = 0.5;
static const glm::vec3 CENTRO(0.2f, 0.5f, 0);

struct Vista {
    Orbita orbita;
    glm::vec3 luz;
};
static const Vista VISTAS[] = {{{0.25f, 0.42f, 8}, {-1.8f, 3.6f, 0.8f}},
                               {{1.3f, 0.1f, 8}, {-1.8f, 2.0f, 0.8f}},
                               {{-2.1f, 0.05f, 9}, {1.2f, 1.6f, -1}},
                               {{0.6f, 1.2f, 8}, {0.5f, 3, 2.2f}}};

// Una bola roja sobre una mesa blanca, y su sombra negra.
class Escena {
    const Framebuffer &framebuffer;
    const GLuint programa = creaPrograma("ch03_transformaciones/objeto.vert", "common/liso.frag");
    const Buferes mesa = creaBuferes(plano(1)), bola = creaBuferes(esfera(64));
    const glm::mat4 tablero = giroX(-1.57079633f) * escalado(5.0f),
                    colocada = traslacion(CENTRO) * escalado(float(RADIO));

    void pinta(const Buferes &b, const glm::mat4 &M, const glm::vec3 &color) const {
        envia(programa, "M", M);
        envia(programa, "color", color);
        dibujaMalla(b);
    }

public:
    explicit Escena(const Framebuffer &donde) : framebuffer(donde) {
    }
    void dibuja(const Vista &v, const glm::vec2 &desplaza) const {
        const float aspecto = float(framebuffer.ancho) / float(framebuffer.alto);
        framebuffer.borra({1, 1, 1});
        usaPrograma(programa, camaraOrbita(v.orbita),
                    glm::perspective(float(ANGULO_SOMBRAS), aspecto, 1.0f, 60.0f));
        pinta(mesa, tablero, {1, 1, 1});
        pinta(bola, colocada, {1, 0, 0});
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(desplaza.x, desplaza.y);
        pinta(bola, proyeccionSombra(glm::vec4(v.luz, 1), Plano{{0, 1, 0}, 0}) * colocada, {0, 0, 0});
        glDisable(GL_POLYGON_OFFSET_FILL);
    }
};

// La misma escena, trazada; la zona de un píxel es si está en la sombra.
static oraculo::ImagenRef traza(const Vista &v, const Framebuffer &framebuffer) {
    const oraculo::Objeto mesa = oraculo::plano(oraculo::gira({1, 0, 0}, -0.5 * oraculo::PI) *
                                                oraculo::escala(5)),
                          bola = oraculo::esfera(oraculo::traslada(exacto(CENTRO)) * oraculo::escala(RADIO));
    oraculo::Luz luz;
    luz.posicion = exacto(v.luz);
    const oraculo::Camara camara = oraculo::perspectiva(
        oraculo::orbita(v.orbita.azimut, v.orbita.elevacion, v.orbita.distancia), ANGULO_SOMBRAS, 1, 60);
    const oraculo::Vec3 blanco = {1, 1, 1}, rojo = {1, 0, 0}, negro;
    return oraculo::render({mesa, bola}, camara, framebuffer.ancho, framebuffer.alto,
                           [&](const oraculo::Impacto &i) {
                               const bool sombra = i.objeto == 0 && oraculo::enSombra({bola}, i.punto, luz);
                               return oraculo::Tono(i.objeto == 1 ? rojo : sombra ? negro : blanco, sombra);
                           });
}

static void mideSombras(Medidor &m) {
    glEnable(GL_DEPTH_TEST);
    const Framebuffer framebuffer(m.elige(64, 400), m.elige(48, 300));
    const Escena escena(framebuffer);
    std::vector<oraculo::ImagenRef> refs;
    for (const Vista &v : VISTAS)
        refs.push_back(traza(v, framebuffer));
    m.referencia = oraculo::enBytes(refs[0]);
    // con el factor y las unidades de glPolygonOffset
    for (const glm::vec2 &d : m.elige<std::vector<glm::vec2>>(
             {{0, 0}, {-0.25f, -2}, {-10, -10000}},
             {{0, 0}, {0, -1}, {0, -2}, {-0.25f, -2}, {-1, -1}, {-1, -100}, {-10, -10000}, {0, -1000000}})) {
        double sombra = 0, falta = 0, sobra = 0; // píxeles
        Imagen primera;
        for (std::size_t v = 0; v < refs.size(); ++v) {
            escena.dibuja(VISTAS[v], d);
            primera = framebuffer.lee();
            for (int y = 0; y < framebuffer.alto; ++y)
                for (int x = 0; x < framebuffer.ancho; ++x) {
                    const oraculo::PixelRef &p = refs[v].en(x, y);
                    const bool mal = oraculo::diferencia(primera, x, y, p.color) > 2,
                               cuenta = !oraculo::enBanda(refs[v], x, y);
                    sombra += cuenta && p.zona;
                    falta += cuenta && p.zona && mal;
                    sobra += cuenta && !p.zona && mal;
                }
        }
        m.variante(formatea("(%g, %g)", double(d.x), double(d.y)),
                   formatea("falta %.2g %% de la sombra y sobra %.2g %%", 100 * falta / sombra,
                            100 * sobra / sombra),
                   100 * (falta + sobra) / sombra, 1, yEspera([&] { escena.dibuja(VISTAS[0], d); }), primera);
    }
}

static const Apunta
    APUNTA({17, "sombras", "El desplazamiento de las sombras", "ms por imagen de 400×300",
            "% de la sombra mal, en cuatro vistas, frente a trazar rayos", "(-0.25, -2)",
            "El tiempo es el mismo: se elige el menor desplazamiento con el que ya no se cose ninguna vista.",
            mideSombras});
