// La estrella de antialiasing.cpp: las muestras por píxel frente al área exacta.
#include "buferes.h"
#include "ch09_imagen/estrella.h"
#include "gpu.h"
#include "herramientas/oraculo/oraculo.h"
#include "mide.h"

using namespace mide;

static void mideAntialiasing(Medidor &m) {
    abreContexto();
    const int lado = m.elige(48, 360);
    const std::vector<glm::dvec2> vertices = estrella();
    std::vector<double> exacta; // blanco donde hay estrella
    for (int y = 0; y < lado; ++y)
        for (int x = 0; x < lado; ++x) {
            double cubierto = 0;
            for (std::size_t i = 0; i < vertices.size(); i += 3) {
                oraculo::Poligono p;
                for (std::size_t k = i; k < i + 3; ++k)
                    p.push_back({0.5 * lado * (vertices[k].x + 1), 0.5 * lado * (vertices[k].y + 1)});
                if (oraculo::distanciaDentro(p, x + 0.5, y + 0.5) > -2)
                    cubierto += oraculo::coberturaPixel(p, x, y);
            }
            exacta.insert(exacta.end(), 3, 255 * std::min(cubierto, 1.0));
        }
    m.referencia = redondeada(lado, lado, exacta);

    Malla malla;
    for (const glm::dvec2 &v : vertices) {
        malla.indices.push_back(unsigned(malla.vertices.size()));
        malla.vertices.push_back({glm::vec3(v, 0), {0, 0, 1}, {0, 0}});
    }
    const Buferes buferes = creaBuferes(malla);
    const GLuint programa = creaPrograma("herramientas/mide/plano.vert", "herramientas/mide/nada.frag"),
                 reduce = creaPrograma("ch09_imagen/imagen.vert", "ch09_imagen/reduce.frag");
    const int muestras = 4; // las da cualquier OpenGL 3.1
    const Framebuffer destino(lado, lado);
    const auto variante = [&](const std::string &nombre, int veces, int n, const Rango &espera) {
        const int talla = veces * lado;
        GLuint textura;
        glGenTextures(1, &textura);
        glBindTexture(GL_TEXTURE_2D, textura);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, talla, talla, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        const Framebuffer grande(talla, talla, n);
        GLuint resuelto;
        glGenFramebuffers(1, &resuelto);
        glBindFramebuffer(GL_FRAMEBUFFER, resuelto);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, textura, 0);
        const auto dibuja = [&] {
            const Framebuffer &framebuffer = veces == 1 && n == 0 ? destino : grande;
            framebuffer.borra(0, 0, 0);
            glUseProgram(programa);
            ::dibuja(buferes);
            if (&framebuffer == &destino)
                return;
            const bool reducir = veces > 1;
            glBindFramebuffer(GL_READ_FRAMEBUFFER, grande.nombre);
            glBindFramebuffer(GL_DRAW_FRAMEBUFFER, reducir ? resuelto : destino.nombre);
            glBlitFramebuffer(0, 0, talla, talla, 0, 0, talla, talla, GL_COLOR_BUFFER_BIT, GL_NEAREST);
            if (!reducir)
                return;
            destino.abre();
            glUseProgram(reduce);
            envia(reduce, "imagen", 0);
            envia(reduce, "veces", veces);
            dibujaRectangulo();
        };
        dibuja();
        const Imagen imagen = destino.lee();
        m.variante(nombre, rmse(imagen, exacta), 1, yEspera(dibuja), espera,
                   std::to_string(veces * veces * std::max(n, 1)) + " muestras por píxel", imagen);
        glDeleteFramebuffers(1, &resuelto);
        glDeleteTextures(1, &textura);
    };
    variante("sin nada", 1, 0, {5, 80});
    variante("multimuestra", 1, muestras, {1, 40});
    variante("sobremuestreo 2×2", 2, 0, {1, 40});
    variante("sobremuestreo 4×4", 4, 0, {0.5, 20});
    variante("sobremuestreo 8×8", 8, 0, {0.2, 10});
    variante("multimuestra y 2×2", 2, muestras, {0.5, 20});
    variante("multimuestra y 4×4", 4, muestras, {0.2, 10});
}

static const Apunta APUNTA({11, "antialiasing", "Antialiasing", "ms por imagen de 360×360",
                            "niveles de 255 (RMSE), frente al área exacta", "multimuestra",
                            "Las ventanas piden multimuestra: quita tanta escalera como dibujar 2×2 veces "
                            "mayor, y cuesta menos. El error baja con "
                            "las muestras, y el tiempo sube con ellas.",
                            mideAntialiasing});
