// La estrella de antialiasing.cpp: las muestras por píxel frente al área exacta.
#include "buferes.h"
#include "ch09_imagen/estrella.h"
#include "gpu.h"
#include "herramientas/oraculo/oraculo.h"
#include "shader.h"

using namespace mide;

// La estrella, blanca: lo que tapa de cada píxel, tres veces.
static std::vector<double> estrellaExacta(int lado) {
    const std::vector<glm::dvec2> vertices = estrella();
    std::vector<oraculo::Poligono> triangulos(vertices.size() / 3);
    for (std::size_t k = 0; k < vertices.size(); ++k)
        triangulos[k / 3].push_back({0.5 * lado * (vertices[k].x + 1), 0.5 * lado * (vertices[k].y + 1)});
    std::vector<double> exacta;
    for (int y = 0; y < lado; ++y)
        for (int x = 0; x < lado; ++x) {
            double cubierto = 0;
            for (const oraculo::Poligono &p : triangulos)
                if (oraculo::distanciaDentro(p, x + 0.5, y + 0.5) > -2)
                    cubierto += oraculo::coberturaPixel(p, x, y);
            exacta.insert(exacta.end(), 3, 255 * std::min(cubierto, 1.0));
        }
    return exacta;
}

static void resuelve(const Framebuffer &de, GLuint a) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, de.nombre);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, a);
    glBlitFramebuffer(0, 0, de.ancho, de.alto, 0, 0, de.ancho, de.alto, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, a);
}

static void mideAntialiasing(Medidor &m) {
    const int lado = m.elige(48, 360);
    const std::vector<double> exacta = estrellaExacta(lado);
    m.referencia = redondeada(lado, lado, exacta);

    const Buferes buferes = creaBuferes(mallaEstrella());
    const GLuint programa = creaPrograma("ch09_imagen/estrella.vert", "common/liso.frag"),
                 reduce = creaPrograma("ch09_imagen/imagen.vert", "ch09_imagen/reduce.frag");
    glUseProgram(programa);
    envia(programa, "giro", glm::vec2(1, 0));
    envia(programa, "color", glm::vec3(1));
    const Framebuffer destino(lado, lado);
    const auto pinta = [&](const Framebuffer &framebuffer) {
        framebuffer.borra({0, 0, 0});
        glUseProgram(programa);
        dibujaMalla(buferes);
    };
    const Dibujadas dibujada{m, destino, [&](const Imagen &i) { return rmse(i, exacta); }};
    // dibujada `veces` mayor y con `muestras` por píxel
    const auto variante = [&](const std::string &nombre, int veces, int muestras) {
        const Framebuffer grande(veces * lado, veces * lado, muestras);
        const Lienzo resuelto = creaLienzo(glm::ivec2(veces * lado));
        dibujada(nombre, formatea("%d muestras por píxel", veces * veces * std::max(muestras, 1)), [&] {
            pinta(veces == 1 && muestras == 0 ? destino : grande);
            if (veces > 1) {
                resuelve(grande, resuelto.framebuffer);
                destino.abre();
                glUseProgram(reduce);
                envia(reduce, "imagen", 0);
                envia(reduce, "veces", veces);
                dibujaRectangulo();
            } else if (muestras > 0) {
                resuelve(grande, destino.nombre);
            }
        });
        glDeleteFramebuffers(1, &resuelto.framebuffer);
        glDeleteTextures(1, &resuelto.textura);
    };
    const int muestras = 4; // las da cualquier OpenGL 3.1
    variante("sin nada", 1, 0);
    variante("multimuestra", 1, muestras);
    variante("sobremuestreo 2×2", 2, 0);
    variante("sobremuestreo 4×4", 4, 0);
    variante("sobremuestreo 8×8", 8, 0);
    variante("multimuestra y 2×2", 2, muestras);
    variante("multimuestra y 4×4", 4, muestras);
}

static const Apunta APUNTA({11, "antialiasing", "Antialiasing", "ms por imagen de 360×360",
                            "niveles de 255 (RMSE), frente al área exacta", "multimuestra",
                            "Las ventanas piden multimuestra: quita tanta escalera como dibujar 2×2 veces "
                            "mayor, y cuesta menos. El error baja con "
                            "las muestras, y el tiempo sube con ellas.",
                            mideAntialiasing});
