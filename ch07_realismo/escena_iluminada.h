// Dibujar escena_espejo.h, tal cual o reflejada. Los programas espejo y espejo_plantilla.
#pragma once
#include "ch05_iluminacion/iluminacion.h"
#include "escena_espejo.h"
#include "malla.h"
#include <array>

struct EscenaIluminada {
    GLuint programa;
    std::array<Buferes, SOLIDOS> solidos;
};

/// Las baldosas de lado 1 del suelo, en el plano Y = 0, como las de un tablero: las claras o las oscuras.
inline Malla baldosas(bool oscuras) {
    Malla malla;
    for (int x = -4; x < 4; ++x)
        for (int z = -3; z < 3; ++z) {
            if (((x + z) % 2 != 0) != oscuras)
                continue;
            const GLuint k = static_cast<GLuint>(malla.vertices.size());
            for (const glm::ivec2 e : {glm::ivec2(0, 1), {1, 1}, {1, 0}, {0, 0}})
                malla.vertices.push_back({glm::vec3(x + e.x, 0, z + e.y), {0, 1, 0}, glm::vec2(e)});
            malla.indices.insert(malla.indices.end(), {k, k + 1, k + 2, k, k + 2, k + 3});
        }
    return malla;
}

inline EscenaIluminada creaEscena() {
    return {creaPrograma("ch05_iluminacion/sombreado_phong.vert", "ch07_realismo/reflejo.frag"),
            {creaBuferes(cubo()), creaBuferes(esfera(64)), creaBuferes(cono(64)),
             creaBuferes(baldosas(false)), creaBuferes(baldosas(true))}};
}

/// Dibuja la escena transformada por `simetria`, que también lo hace con la luz. Con una simetría, solo queda lo que
/// está detrás del plano del espejo: lo que el espejo puede reflejar.
inline void dibujaEscena(const EscenaIluminada &e, const std::vector<PiezaEscena> &piezas,
                         const glm::mat4 &camara, const glm::mat4 &simetria = glm::mat4(1)) {
    const Luz luz{{2.5f, 6, 5, 1}, glm::vec3(1), glm::vec3(1)};
    const bool reflejada = simetria != glm::mat4(1);
    const Plano espejo = planoEspejo();
    // el plano, en coordenadas de la cámara; todo 0 y −1 no corta nada
    const glm::vec4 corte = reflejada ? glm::transpose(glm::inverse(camara)) * glm::vec4(espejo.N, espejo.d)
                                      : glm::vec4(0, 0, 0, -1);
    glUseProgram(e.programa);
    envia(e.programa, "camara", camara);
    envia(e.programa, "La", glm::vec3(1));
    envia(e.programa, "corte", corte);
    Luz suya = luz;
    suya.Lp = simetria * luz.Lp;
    enviaLuz(e.programa, "luz", suya, camara);
    glFrontFace(reflejada ? GL_CW : GL_CCW); // la simetría invierte el sentido de giro
    for (const PiezaEscena &pieza : piezas)
        dibujaObjeto(e.programa, e.solidos[pieza.solido], simetria * pieza.M, camara, pieza.material);
    glFrontFace(GL_CCW);
}
