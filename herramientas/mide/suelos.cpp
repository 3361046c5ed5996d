// Lo menos que puede costar una imagen en esta máquina: borrarla y pintar un triángulo, o llenarla.
#include "gpu.h"
#include "shader.h"

using namespace mide;

static void mideSuelos(Medidor &m) {
    glEnable(GL_DEPTH_TEST);
    const GLuint programa = creaPrograma("ch09_imagen/imagen.vert", "common/liso.frag");
    for (const auto &[ancho, alto] : {std::pair(960, 720), {1920, 1080}}) {
        const Framebuffer framebuffer(m.elige(32, ancho), m.elige(24, alto));
        const std::string talla = " " + std::to_string(ancho) + "×" + std::to_string(alto);
        m.grupo = talla.substr(1);
        m.variante("borrar" + talla, "", NAN, 1, yEspera([&] { framebuffer.borra({1, 1, 1}); }));
        m.variante("llenar" + talla, "", NAN, 1, yEspera([&] {
                       framebuffer.borra({1, 1, 1});
                       glUseProgram(programa);
                       dibujaRectangulo();
                   }));
        m.variante("llenar y leer" + talla, "", NAN, 1, [&] {
            framebuffer.borra({1, 1, 1});
            dibujaRectangulo();
            usa(framebuffer.lee());
        });
    }
}

static const Apunta APUNTA({21, "suelos", "Los suelos", "ms por imagen",
                            "sin error: no hay nada que calcular", "",
                            "Con ellos se comparan los programas en la tabla de costes.", mideSuelos});
