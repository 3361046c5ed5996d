// Las cuatro vistas de la grúa (ejercicios 4.2 a 4.4): la cámara de cada una, su sitio en la ventana, el volumen de la vista que
// encierra la grúa en cualquier postura, sus rótulos y sus teclas. Lo que cada ejercicio añade está en su programa.
#pragma once
#include "ch03_transformaciones/grua.h"
#include "colores.h"
#include "orbita.h"
#include "recuadro.h"
#include "rotulo.h"
#include "trazo.h"
#include "ventana.h"
#include "vista.h"
#include <algorithm>
#include <glm/gtc/constants.hpp>
#include <map>

/// Una cámara que mira al centro de la grúa desde CENTRO_GRUA + haciaCamara.
struct VistaGrua {
    const char *nombre;
    glm::dvec3 haciaCamara, UP;
    glm::vec3 color; // el del eje a lo largo del cual se mira
};

const glm::dvec3 CENTRO_GRUA(0, 4.7, 0);
const double DISTANCIA_CAMARA = 26; // en paralela da igual; con la rueda no llega a entrar en la grúa

/// Las tres vistas a lo largo de un eje (el perfil, el derecho) y la de dirección (1,1,1).
enum { ALZADO, PLANTA, PERFIL, DIAGONAL, N_VISTAS, LAS_CUATRO = -1 };
const VistaGrua VISTAS[N_VISTAS] = {
    {"Alzado", {0, 0, DISTANCIA_CAMARA}, {0, 1, 0}, COLOR_EJE[2]},
    {"Planta", {0, DISTANCIA_CAMARA, 0}, {0, 0, -1}, COLOR_EJE[1]},
    {"Perfil", {DISTANCIA_CAMARA, 0, 0}, {0, 1, 0}, COLOR_EJE[0]},
    {"(1,1,1)", glm::dvec3(DISTANCIA_CAMARA / glm::root_three<double>()), {0, 1, 0}, OSCURO},
};

/// La cámara de una vista. No sabe de proyecciones: al cambiar de paralela a perspectiva es la misma.
inline glm::dmat4 camaraVista(const VistaGrua &v) {
    return transformacionCamara(CENTRO_GRUA + v.haciaCamara, CENTRO_GRUA, v.UP);
}

/// La grúa sobre una losa que no sobresale de lo que barre el brazo.
const float LADO_SUELO = 10.5f, GRUESO_SUELO = 0.3f;
inline std::vector<Pieza> escenaGrua(const PosturaGrua &postura) {
    std::vector<Pieza> piezas = piezasGrua(postura);
    piezas.insert(
        piezas.begin(),
        {traslacion({0, -GRUESO_SUELO / 2, 0}) * escalado({LADO_SUELO, GRUESO_SUELO, LADO_SUELO}), SUELO});
    return piezas;
}

/// Las ocho esquinas de una pieza, en el mundo.
inline std::vector<glm::dvec3> esquinas(const Pieza &pieza) {
    std::vector<glm::dvec3> puntos;
    for (int i = 0; i < 8; ++i)
        puntos.push_back(pieza.M *
                         glm::vec4(i & 1 ? 0.5f : -0.5f, i & 2 ? 0.5f : -0.5f, i & 4 ? 0.5f : -0.5f, 1));
    return puntos;
}

/// Puntos entre los que queda, convexamente, el suelo con la grúa en TODAS sus posturas: encuadrándolos la cámara no se
/// mueve cuando se mueve la grúa. Cada esquina da vueltas alrededor del pie; basta, para cada altura, la que
/// pasa más lejos en los extremos del recorrido de la carga, y un polígono que rodee su circunferencia.
inline std::vector<glm::dvec3> envolventeGrua() {
    std::map<double, double> radioEnAltura;
    for (const float distancia : {DISTANCIA_MINIMA, DISTANCIA_MAXIMA})
        for (const float altura : {ALTURA_MINIMA, ALTURA_MAXIMA})
            for (const Pieza &pieza : piezasGrua({0, distancia, altura}))
                for (const glm::dvec3 &p : esquinas(pieza)) {
                    double &radio = radioEnAltura[p.y];
                    radio = std::max(radio, std::hypot(p.x, p.z));
                }
    const int lados = 64;
    const double paso = glm::two_pi<double>() / lados;
    std::vector<glm::dvec3> puntos = esquinas(escenaGrua({})[0]);
    for (const auto &[y, radio] : radioEnAltura)
        for (int i = 0; i < lados; ++i) {
            const double r = radio / std::cos(paso / 2); // circunscrito
            puntos.push_back({r * std::cos(i * paso), y, r * std::sin(i * paso)});
        }
    return puntos;
}

const double HOLGURA = 1.06; // lo que se deja alrededor

/// Caja que encierra los puntos en coordenadas de la cámara.
struct Caja {
    glm::dvec3 minimo, maximo;
};
inline Caja cajaEnCamara(const std::vector<glm::dvec3> &puntos, const glm::dmat4 &camara) {
    Caja caja{glm::dvec3(INFINITY), glm::dvec3(-INFINITY)};
    for (const glm::dvec3 &p : puntos) {
        const glm::dvec3 q(camara * glm::dvec4(p, 1));
        caja = {glm::min(caja.minimo, q), glm::max(caja.maximo, q)};
    }
    return caja;
}

/// Cuántas unidades del mundo debe abarcar un píxel del recuadro, como poco, para que los puntos quepan en
/// paralelo. Varias vistas dibujadas con la mayor de las suyas tienen todas la misma escala.
inline double unidadesPorPixel(const std::vector<glm::dvec3> &puntos, const glm::dmat4 &camara,
                               const Recuadro &r) {
    const Caja caja = cajaEnCamara(puntos, camara);
    const glm::dvec3 lados = caja.maximo - caja.minimo;
    return HOLGURA * std::max(lados.x / r.ancho, lados.y / r.alto);
}

/// Proyección paralela centrada en los puntos y con esa escala, sin deformar.
inline glm::dmat4 paralelaQueEncierra(const std::vector<glm::dvec3> &puntos, const glm::dmat4 &camara,
                                      const Recuadro &r, double unidadesPorPixel) {
    const Caja caja = cajaEnCamara(puntos, camara);
    const glm::dvec3 centro = 0.5 * (caja.minimo + caja.maximo);
    const double x = 0.5 * unidadesPorPixel * r.ancho, y = 0.5 * unidadesPorPixel * r.alto,
                 z = 0.5 * HOLGURA * (caja.maximo.z - caja.minimo.z);
    return proyeccionParalela(centro.x - x, centro.x + x, centro.y - y, centro.y + y, -centro.z - z,
                              -centro.z + z);
}

/// Proyección perspectiva que encierra los puntos, que han de estar todos delante de la cámara. La pirámide de
/// la ecuación 4.3 no se puede descentrar: se abre hasta el punto que más se aparta del eje. Cerca y lejos se
/// ajustan a los puntos: un volumen más hondo gasta la profundidad en lo vacío, y de lejos se confunden las caras.
inline glm::dmat4 perspectivaQueEncierra(const std::vector<glm::dvec3> &puntos, const glm::dmat4 &camara,
                                         const Recuadro &r) {
    const double aspecto = double(r.ancho) / r.alto;
    double tangente = 0, cerca = INFINITY, lejos = 0;
    for (const glm::dvec3 &p : puntos) {
        const glm::dvec3 q(camara * glm::dvec4(p, 1));
        tangente = std::max({tangente, std::fabs(q.y / q.z), std::fabs(q.x / q.z) / aspecto});
        cerca = std::min(cerca, -q.z), lejos = std::max(lejos, -q.z);
    }
    return proyeccionPerspectiva(2 * std::atan(HOLGURA * tangente), aspecto, cerca / HOLGURA,
                                 HOLGURA * lejos);
}

/// Lo que el usuario elige de las vistas. El ratón aparta la cuarta de (1,1,1).
struct VistasGrua {
    int elegido = LAS_CUATRO;
    bool europeo = false;
    Orbita orbita = {glm::quarter_pi<float>(), 0.615480f, float(DISTANCIA_CAMARA), CENTRO_GRUA, 0};
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
    const int lado = v.elegido == LAS_CUATRO ? 2 : 1;
    const std::vector<Recuadro> recuadros = rejilla(lado, lado, donde);
    std::vector<PanelVista> paneles;
    double escala = 0;
    for (std::size_t k = 0; k < recuadros.size(); ++k) {
        const Recuadro &r = recuadros[k], escena = {r.x, r.y, r.ancho, r.alto - r.alto / 9};
        if (r.ancho == 0 || r.alto == 0)
            continue;
        const int i = lado == 1 ? v.elegido : (v.europeo ? EUROPEO : AMERICANO)[k];
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

/// Dibujar desde ahora en la escena del panel, que se borra entero.
inline void abreVista(const PanelVista &p) {
    abreRecuadro(p.panel, CIELO);
    glViewport(p.escena.x, p.escena.y, p.escena.ancho, p.escena.alto);
}

/// El nombre de la vista con lo que se añada y, en la esquina, los ejes como se ven desde la cámara.
inline void rotulaVista(const PanelVista &p, const std::string &detalle = "") {
    glViewport(p.panel.x, p.panel.y, p.panel.ancho, p.panel.alto);
    rotula(VISTAS[p.vista].nombre + detalle, {0.02f, 0.94f}, VISTAS[p.vista].color, Lado::DERECHA);
    const int lado = std::min(p.panel.ancho, p.panel.alto) / 3;
    glViewport(p.panel.x, p.panel.y, lado, lado);
    glClear(GL_DEPTH_BUFFER_BIT); // los ejes, delante de todo
    const glm::mat4 ejes(proyeccionParalela(-2, 2, -2, 2, -2, 2) * glm::dmat4(glm::dmat3(p.camara)));
    for (int eje = 0; eje < 3; ++eje)
        trazaFlecha({0, 0, 0}, glm::mat3(1)[eje], ejes, COLOR_EJE[eje]);
    for (int eje = 0; eje < 3; ++eje)
        rotulaPunto(std::string(1, char('X' + eje)), glm::mat3(1.35f)[eje], ejes, COLOR_EJE[eje],
                    Lado::CENTRO, 0.03f);
}

/// Teclas de las vistas: 1 a 4 una, 0 las cuatro, u el sistema. Devuelve si la tecla era suya.
inline bool eligeVista(VistasGrua &v, unsigned char tecla) {
    if (tecla == 'u')
        v.europeo = !v.europeo;
    else if (tecla >= '0' && tecla <= '4')
        v.elegido = tecla - '1';
    else
        return false;
    return true;
}

/// Las opciones del menú, que valen lo que sus teclas.
inline void ponOpcionesVistas() {
    for (int i = 0; i < N_VISTAS; ++i)
        glutAddMenuEntry(VISTAS[i].nombre, '1' + i);
    glutAddMenuEntry("Las cuatro", '0');
    glutAddMenuEntry("Europeo o americano", 'u');
}
