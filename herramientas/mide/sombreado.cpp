// Plano, Gouraud y Phong, según la subdivisión, frente a trazar la esfera con su normal exacta.
#include "escena.h"

using namespace mide;

// La normal de cada triángulo en sus tres vértices.
static Malla facetas(const Malla &malla) {
    Malla plana;
    for (std::size_t i = 0; i < malla.indices.size(); i += 3) {
        const auto v = [&](std::size_t k) { return malla.vertices[malla.indices[i + k]]; };
        const glm::vec3 n =
            glm::normalize(glm::cross(v(1).posicion - v(0).posicion, v(2).posicion - v(0).posicion));
        for (const std::size_t k : {1u, 2u, 0u}) {
            plana.indices.push_back(unsigned(plana.vertices.size()));
            plana.vertices.push_back({v(k).posicion, n, v(k).coordTextura});
        }
    }
    return plana;
}

static void mideSombreado(Medidor &m) {
    const Framebuffer framebuffer(m.elige(64, 640), m.elige(48, 480));
    glEnable(GL_DEPTH_TEST);
    const oraculo::ImagenRef ref = trazaEsfera(framebuffer);
    m.referencia = oraculo::enBytes(ref);
    const Dibujadas variante{m, framebuffer, [&](const Imagen &i) { return errorDeFrente(i, ref); }};
    const auto muchos = m.elige<std::vector<int>>({12, 48}, {12, 24, 48, 192});
    const struct {
        const char *nombre;
        GLuint programa;
        std::vector<int> segmentos;
    } MODELOS[] = {
        {"plano", creaSombreado("plano"), muchos},
        {"Gouraud", creaSombreado("gouraud"), muchos},
        {"Phong sin normalizar",
         creaPrograma("ch05_iluminacion/sombreado_phong.vert", "herramientas/mide/phong_sin_normalizar.frag"),
         {12, 48}},
        {"Phong", creaSombreado("phong"), muchos}};
    for (const auto &modelo : MODELOS)
        for (const int n : modelo.segmentos) {
            const bool plano = modelo.nombre == std::string("plano");
            mideIluminada(variante, framebuffer, formatea("%s de %d", modelo.nombre, n), "", modelo.programa,
                          plano ? facetas(esfera(n)) : esfera(n), glm::mat4(1));
        }
}

static const Apunta APUNTA({6, "sombreado", "Plano, Gouraud y Phong", "ms por imagen de 640×480",
                            "niveles de 255 (RMSE), frente a la esfera exacta trazada", "Phong de 48",
                            "Gouraud gana en tiempo solo si hay menos vértices que píxeles, y su brillo "
                            "depende de la malla. Phong con 48 "
                            "segmentos se equivoca menos que Gouraud con 192.",
                            mideSombreado});
