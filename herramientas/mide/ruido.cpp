// El ruido de textura3d en un corte del bloque: leído de una textura 3D o calculado en el shader.
#include "ch08_texturas_avanzadas/textura3d.h"
#include "gpu.h"
#include "shader.h"

using namespace mide;

static void mideRuido(Medidor &m) {
    abreContexto();
    glDisable(GL_DEPTH_TEST);
    const int lado = m.elige(32, 512);
    const Framebuffer framebuffer(lado, lado);
    std::vector<double> exacta;
    for (int y = 0; y < lado; ++y)
        for (int x = 0; x < lado; ++x) {
            const glm::dvec3 p = double(CELDAS) * glm::dvec3((x + 0.5) / lado, (y + 0.5) / lado, 0.3);
            exacta.insert(exacta.end(), 3,
                          255 *
                              glm::clamp(0.5 + 0.5 * turbulencia(p, OCTAVAS, glm::ivec3(CELDAS)), 0.0, 1.0));
        }
    m.referencia = redondeada(lado, lado, exacta);
    const GLuint programa = creaPrograma("ch09_imagen/imagen.vert", "herramientas/mide/ruido.frag");
    glUseProgram(programa);
    envia(programa, "ruidoGuardado", 0);
    const auto variante = [&](const std::string &nombre, int octavas, const std::string &nota) {
        envia(programa, "octavas", octavas);
        const auto dibuja = [&] {
            framebuffer.abre();
            dibujaRectangulo();
        };
        mideImagen(
            m, nombre, framebuffer, dibuja, [&](const Imagen &i) { return rmse(i, exacta); }, nota);
    };
    for (const int n : m.elige<std::vector<int>>({16, 64}, {16, 32, 64, 128})) {
        std::vector<unsigned char> texels;
        for (int i = 0; i < n * n * n; ++i) {
            const glm::vec3 p = float(CELDAS) / float(n) * (glm::vec3(i % n, i / n % n, i / n / n) + 0.5f);
            texels.push_back(enOchoBits(0.5f + 0.5f * turbulencia(p, OCTAVAS, glm::ivec3(CELDAS))));
        }
        GLuint textura;
        glGenTextures(1, &textura);
        glBindTexture(GL_TEXTURE_3D, textura);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glTexImage3D(GL_TEXTURE_3D, 0, GL_R8, n, n, n, 0, GL_RED, GL_UNSIGNED_BYTE, texels.data());
        glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        variante(formatea("textura de %d³", n), 0, formatea("%.3g kB", n * n * n / 1000.0));
        glDeleteTextures(1, &textura);
    }
    variante("en el shader, 1 octava", 1, "sin memoria");
    variante("en el shader, 3 octavas", OCTAVAS, "sin memoria");
}

static const Apunta APUNTA({12, "ruido", "Ruido: guardarlo o calcularlo", "ms por imagen de 512×512",
                            "niveles de 255 (RMSE), frente a double", "textura de 64³",
                            "La textura de 64³ ocupa lo que una foto y se equivoca pocos niveles. Calcularlo "
                            "es exacto y cuesta varias veces más: es lo que "
                            "hacen los programas que lo necesitan sin que se repita, o con su gradiente.",
                            mideRuido});
