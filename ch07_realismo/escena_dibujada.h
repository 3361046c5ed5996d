// Dibujar escena_espejo.h, tal cual o reflejada, y el espejo solo. Los programas espejo y espejo_plantilla.
#pragma once
#include "baldosas.h"
#include "buferes.h"
#include "ch05_iluminacion/iluminacion.h"
#include "colores.h"
#include "escena_espejo.h"
#include "malla.h"
#include "reflexion.h"
#include "shader.h"
#include <array>

struct EscenaDibujada {
    GLuint programa, programaEspejo;
    std::array<Buferes, SOLIDOS> solidos;
    Buferes espejo;
};

inline EscenaDibujada creaEscena() {
    return {creaPrograma("ch05_iluminacion/sombreado_phong.vert", "ch07_realismo/reflejo.frag"),
            creaPrograma("ch03_transformaciones/objeto.vert", "ch07_realismo/liso.frag"),
            {creaBuferes(cubo()), creaBuferes(esfera(64)), creaBuferes(cono(64)),
             creaBuferes(baldosas(false)), creaBuferes(baldosas(true))},
            creaBuferes(plano(1))};
}

/// La escena o, reflejada, su simétrica, con la luz también simétrica: solo lo que queda detrás del espejo.
inline void dibujaEscena(const EscenaDibujada &e, const std::vector<PiezaEscena> &piezas,
                         const glm::mat4 &camara, const glm::mat4 &proyeccion, bool reflejada = false) {
    const Plano espejo = planoEspejo();
    const glm::mat4 simetria = reflejada ? reflexion(espejo) : glm::mat4(1);
    Luz luz{{2.5f, 6, 5, 1}};
    luz.Lp = simetria * luz.Lp;
    usaIluminado(e.programa, camara, proyeccion, luz);
    // el plano, en coordenadas de la cámara; uno nulo no corta nada
    envia(e.programa, "corte",
          reflejada ? glm::transpose(glm::inverse(camara)) * glm::vec4(espejo.N, espejo.d) : glm::vec4(0));
    glFrontFace(reflejada ? GL_CW : GL_CCW); // la simetría invierte el sentido de giro
    for (const PiezaEscena &pieza : piezas)
        dibujaIluminado(e.programa, e.solidos[pieza.solido], simetria * pieza.M, camara, pieza.material);
    glFrontFace(GL_CCW);
}

/// El espejo, liso.
inline void dibujaEspejo(const EscenaDibujada &e, const glm::mat4 &camara, const glm::mat4 &proyeccion,
                         const glm::vec4 &color) {
    usaPrograma(e.programaEspejo, camara, proyeccion);
    envia(e.programaEspejo, "M", colocaEspejo());
    envia(e.programaEspejo, "color", color);
    dibujaMalla(e.espejo);
}

/// Borra la profundidad de donde se ve el espejo: lo dibuja en el fondo, del color del cielo.
inline void borraTrasEspejo(const EscenaDibujada &e, const glm::mat4 &camara, const glm::mat4 &proyeccion) {
    glDepthFunc(GL_ALWAYS);
    glDepthRange(1, 1);
    dibujaEspejo(e, camara, proyeccion, glm::vec4(CIELO, 1));
    glDepthRange(0, 1);
    glDepthFunc(GL_LESS);
}
