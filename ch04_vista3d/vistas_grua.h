// Las cuatro vistas de la grúa en la ventana: el panel de cada una, sus rótulos, sus teclas y su menú. Lo que cada
// ejercicio añade está en su programa.
#pragma once
#include "camaras_grua.h"
#include "colores.h"
#include "modos.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "trazo.h"
#include "vista.h"

/// La órbita que empieza en la cámara de la vista.
inline Orbita orbitaDe(const VistaGrua &v) {
    const glm::dvec3 d = v.haciaCamara;
    const double distancia = glm::length(d);
    return {float(std::atan2(d.x, d.z)), float(std::asin(d.y / distancia)), float(distancia), CENTRO_GRUA, 0};
}

/// Lo que el usuario elige de las vistas. El ratón aparta la cuarta de (1,1,1).
struct VistasGrua {
    int elegido = LAS_CUATRO;
    bool europeo = false;
    Orbita orbita = orbitaDe(VISTAS[DIAGONAL]);
};

/// Un panel con una vista. En `escena` va la grúa; lo que queda encima es para el rótulo.
struct PanelVista {
    int vista;
    Recuadro panel, escena;
    glm::dmat4 camara;
    double unidadesPorPixel; // la misma en todos, como en un plano
};

/// Los paneles de las vistas elegidas. En el sistema americano cada vista está del lado desde el que se mira (la planta
/// sobre el alzado y el perfil derecho a su derecha); en el europeo, del contrario. (1,1,1) va en el que queda.
inline std::vector<PanelVista> reparteVistas(const VistasGrua &v, const std::vector<glm::dvec3> &envolvente,
                                             const Recuadro &donde = ventanaEntera()) {
    static const int AMERICANO[] = {PLANTA, DIAGONAL, ALZADO, PERFIL}, // por filas, desde arriba
        EUROPEO[] = {PERFIL, ALZADO, DIAGONAL, PLANTA};
    const int *const orden = v.europeo ? EUROPEO : AMERICANO;
    const int lado = v.elegido == LAS_CUATRO ? 2 : 1;
    const std::vector<Recuadro> recuadros = rejilla(lado, lado, donde);
    std::vector<PanelVista> paneles;
    double escala = 0;
    for (std::size_t k = 0; k < recuadros.size(); ++k) {
        const Recuadro &r = recuadros[k];
        const Recuadro escena = {r.x, r.y, r.ancho, r.alto - r.alto / 9};
        if (r.ancho == 0 || r.alto == 0)
            continue;
        const int i = lado == 1 ? v.elegido : orden[k];
        VistaGrua vista = VISTAS[i];
        if (i == DIAGONAL)
            vista.haciaCamara = glm::dvec3(posicionCamara(v.orbita)) - CENTRO_GRUA;
        paneles.push_back({i, r, escena, camaraVista(vista), 0});
        escala = std::max(escala, unidadesPorPixel(envolvente, paneles.back().camara, escena));
    }
    for (PanelVista &p : paneles)
        p.unidadesPorPixel = escala;
    return paneles;
}

/// El nombre de la vista con lo que se añada y, en la esquina, los ejes como se ven desde la cámara.
inline void rotulaVista(const PanelVista &p, const std::string &detalle = "") {
    abreRecuadro(p.panel);
    rotula(VISTAS[p.vista].nombre + detalle, {0.02f, 0.94f}, VISTAS[p.vista].color, Lado::DERECHA);
    const int lado = std::min(p.panel.ancho / 4, p.panel.alto / 3);
    if (float(lado) < altoUtil() / 8) // sus letras se amontonarían
        return;
    abreRecuadro({p.panel.x, p.panel.y, lado, lado});
    glClear(GL_DEPTH_BUFFER_BIT); // los ejes, delante de todo
    const glm::mat4 ejes(proyeccionParalela(-2, 2, -2, 2, -2, 2) * glm::dmat4(glm::dmat3(p.camara)));
    for (int eje = 0; eje < 3; ++eje)
        trazaFlecha({0, 0, 0}, glm::mat3(1)[eje], ejes, COLOR_EJE[eje]);
    for (int eje = 0; eje < 3; ++eje)
        rotulaPunto(std::string(1, char('X' + eje)), glm::mat3(1.55f)[eje], ejes, COLOR_EJE[eje],
                    Lado::CENTRO, 0.03f);
}

static_assert(LAS_CUATRO == TODOS);

/// Teclas de las vistas: 1 a 4 una, 0 las cuatro, u el sistema. Devuelve si la tecla era suya.
inline bool eligeVista(VistasGrua &v, unsigned char tecla) {
    if (tecla == 'u')
        v.europeo = !v.europeo;
    return tecla == 'u' || eligeModoOTodos(v.elegido, N_VISTAS, tecla);
}

/// Las opciones del menú, que valen lo que sus teclas.
inline void ponOpcionesVistas() {
    for (int i = 0; i < N_VISTAS; ++i)
        glutAddMenuEntry(VISTAS[i].nombre, '1' + i);
    glutAddMenuEntry("Las cuatro", '0');
    glutAddMenuEntry("Europeo o americano", 'u');
}
