// La estrella de antialiasing.cpp: las muestras por píxel frente al área exacta.
#include "buferes.h"
#include "ch09_imagen/estrella.h"
#include "gpu.h"
#include "herramientas/oraculo/oraculo.h"
#include "mide.h"

using namespace mide;

// La estrella, blanca: lo que tapa de cada píxel, tres veces.
static std::vector<double> estrellaExacta(const std::vector<glm::dvec2> &vertices, int lado) {
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

static Malla enMalla(const std::vector<glm::dvec2> &vertices) {
    Malla malla;
    for (const glm::dvec2 &v : vertices) {
        malla.indices.push_back(unsigned(malla.vertices.size()));
        malla.vertices.push_back({glm::vec3(v, 0), {0, 0, 1}, {0, 0}});
    }
    return malla;
}

// Donde se dibuja `veces` mayor y con `muestras` por píxel, y la textura en que se resuelven.
struct Grande {
    const int veces, talla;
    GLuint textura, resuelto;
    Framebuffer framebuffer;

    Grande(int lado, int lasVeces, int muestras)
        : veces(lasVeces), talla(veces * lado), textura(creaTextura(talla)),
          framebuffer(talla, talla, muestras) {
        glGenFramebuffers(1, &resuelto);
        glBindFramebuffer(GL_FRAMEBUFFER, resuelto);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, textura, 0);
    }
    ~Grande() {
        glDeleteFramebuffers(1, &resuelto);
        glDeleteTextures(1, &textura);
    }
    void resuelveEn(GLuint otro) const {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer.nombre);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, otro);
        glBlitFramebuffer(0, 0, talla, talla, 0, 0, talla, talla, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    }

private:
    static GLuint creaTextura(int talla) {
        GLuint textura;
        glGenTextures(1, &textura);
        glBindTexture(GL_TEXTURE_2D, textura);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, talla, talla, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        return textura;
    }
};

static void mideAntialiasing(Medidor &m) {
    abreContexto();
    const int lado = m.elige(48, 360);
    const std::vector<glm::dvec2> vertices = estrella();
    const std::vector<double> exacta = estrellaExacta(vertices, lado);
    m.referencia = redondeada(lado, lado, exacta);

    const Buferes buferes = creaBuferes(enMalla(vertices));
    const GLuint programa = creaPrograma("herramientas/mide/plano.vert", "herramientas/mide/nada.frag"),
                 reduce = creaPrograma("ch09_imagen/imagen.vert", "ch09_imagen/reduce.frag");
    const Framebuffer destino(lado, lado);
    const auto pinta = [&](const Framebuffer &framebuffer) {
        framebuffer.borra(0, 0, 0);
        glUseProgram(programa);
        dibujaMalla(buferes);
    };
    const auto encoge = [&](const Grande &grande) {
        grande.resuelveEn(grande.resuelto);
        destino.abre();
        glUseProgram(reduce);
        envia(reduce, "imagen", 0);
        envia(reduce, "veces", grande.veces);
        dibujaRectangulo();
    };
    const auto variante = [&](const std::string &nombre, int veces, int muestras, const Rango &espera) {
        const Grande grande(lado, veces, muestras);
        const auto trabajo = [&] {
            pinta(veces == 1 && muestras == 0 ? destino : grande.framebuffer);
            if (veces > 1)
                encoge(grande);
            else if (muestras > 0)
                grande.resuelveEn(destino.nombre);
        };
        trabajo();
        const Imagen imagen = destino.lee();
        m.variante(nombre, rmse(imagen, exacta), 1, yEspera(trabajo), espera,
                   std::to_string(veces * veces * std::max(muestras, 1)) + " muestras por píxel", imagen);
    };
    const int muestras = 4; // las da cualquier OpenGL 3.1
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
