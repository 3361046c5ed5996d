// Un vértice y su fragmento (el punto rojo) por las etapas del pipeline (ejercicio 4.1, ecuación 4.4), un panel para cada una,
// con sus números, que también se escriben. Con r, un triángulo que se sale del volumen y llega detrás del ojo:
// etapas.h lo recorta, y el polígono que queda (morado) es justo lo que dibuja OpenGL. Con o, algo tapa el fragmento.
// Controles: clic elige vértice · r recortado · o oculto · arrastrar orbita por fuera · Esc termina.
#include "aspecto.h"
#include "colores.h"
#include "malla.h"
#include "orbita.h"
#include "paneles.h"
#include "rotulo.h"
#include "shader.h"
#include "trazo.h"
#include "ventana.h"

static const double ANGULO = 0.62, CERCA = 4, LEJOS = 8.5; // de la cámara; el ángulo, en radianes
static const glm::dvec3 OJO(2.0, 3.4, 5.4), INTERES(0.1, 0.7, 0);

struct Cuerpo {
    std::vector<glm::vec3> vertices;
    std::vector<GLuint> indices;
    Buferes buferes;
    glm::mat4 M;
    glm::vec3 color;
};
enum { CUBO, TRIANGULO, TAPA, CUERPOS };

static struct {
    GLuint programa;
    Cuerpo cuerpos[CUERPOS];
    int cual = CUBO;
    bool tapado = false;
    std::size_t elegido = 14;
    Matrices m;
    std::array<Panel, PANELES> paneles;
    std::string escrito;
    Orbita orbita = {0.95f, 0.35f, 1}; // la distancia multiplica la de cada panel
} estado;

static Cuerpo creaCuerpo(const Malla &malla, const glm::mat4 &M, const glm::vec3 &color) {
    Cuerpo c = {{}, malla.indices, creaBuferes(malla), M, color};
    for (const Vertice &v : malla.vertices)
        c.vertices.push_back(v.posicion);
    return c;
}

static void inicia() {
    estado.programa = creaPrograma("ch04_vista3d/volumen_vista.vert", "ch04_vista3d/volumen_vista.frag");
    Malla triangulo = {{}, {0, 1, 2}};
    for (const glm::vec3 &v : {glm::vec3(-0.7f, 0.8f, -0.5f), {0.9f, -0.2f, 5}, {1.5f, -0.6f, -1.4f}})
        triangulo.vertices.push_back({v, {0, 1, 0}, {0, 0}});
    const glm::mat4 M = traslacion({0.2f, 0.8f, 0.3f}) * giroY(-0.35f) * escalado({2.0f, 1.2f, 1.4f});
    estado.cuerpos[CUBO] = creaCuerpo(cubo(), M, AMARILLO);
    estado.cuerpos[TRIANGULO] = creaCuerpo(triangulo, M, AMARILLO);
    estado.cuerpos[TAPA] =
        creaCuerpo(cubo(), traslacion({1.45f, 1.75f, 2.1f}) * escalado({0.5f, 0.5f, 0.2f}), VERDE);
}

static const Cuerpo &cuerpo() {
    return estado.cuerpos[estado.cual];
}

// Las matrices de todas las etapas, y las de los paneles.
static void calculaMatrices() {
    auto &p = estado.paneles = colocaPaneles(reparte(PANELES));
    const Recuadro &v = p[VENTANA].escena;
    const double a = static_cast<double>(aspecto(v));
    estado.m = {cuerpo().M, transformacionCamara(OJO, INTERES, {0, 1, 0}),
                proyeccionPerspectiva(anguloVertical(ANGULO, a), a, CERCA, LEJOS),
                transformacionViewport(v.x, v.y, v.ancho, v.alto)};
    colocaMatrices(p, estado.m);
    const Orbita &o = estado.orbita;
    const auto mira = [&](int k, const glm::vec3 &centro, float distancia) {
        p[k].proyeccion = perspectivaVentana(0.5f, 0.5f, 100, aspecto(p[k].escena));
        p[k].camara = camaraOrbita({o.azimut, o.elevacion, o.distancia * distancia, centro});
    };
    mira(OBJETO, {0, 0, 0}, estado.cual == TRIANGULO ? 9.0f : 5.0f);
    mira(MUNDO, {0.4f, 1.3f, 0.9f}, 17);
    mira(CAMARA, {0, 0, -4.4f}, 19);
    mira(NDC, {0, 0, 0}, 8);
    p[NDC].camara *= escalado({1, 1, -1}); // su base es a izquierdas: la profundidad crece hacia el fondo
}

// Con la luz del mundo en todos los paneles y en gris lo que queda fuera del volumen.
static void dibujaCuerpo(const Panel &p, const Cuerpo &c) {
    const GLuint programa = estado.programa;
    glUseProgram(programa);
    envia(programa, "M", glm::mat4(p.delMundo * glm::dmat4(c.M)));
    envia(programa, "N", matrizNormal(c.M));
    envia(programa, "aRecortado", glm::mat4(estado.m.proyeccion * estado.m.camara * glm::dmat4(c.M)));
    envia(programa, "camara", p.camara);
    envia(programa, "proyeccion", p.proyeccion);
    envia(programa, "colorObjeto", c.color);
    dibuja(c.buferes);
}

// El volumen de la vista, con los rayos que salen del ojo, en las coordenadas del panel.
static void trazaVolumen(int k, const glm::mat4 &delMundo, const glm::mat4 &deNdc, const glm::vec3 &vertice) {
    const std::vector<glm::vec3> cerca = caraVolumen(-1), lejos = caraVolumen(1);
    for (std::size_t i = 0; i < 4; ++i)
        trazaSegmentos({cerca[i], lejos[i]}, deNdc, OSCURO, 3);
    trazaPolilinea(cerca, deNdc, NARANJA, GROSOR, true);
    trazaPolilinea(lejos, deNdc, AZUL, GROSOR, true);
    if (k != NDC) // allí el ojo está en el infinito
        trazaSegmentos({glm::vec3(OJO), vertice}, delMundo, ROJO, 3);
}

static void dibujaEscena(int k, const Etapas &e, const std::vector<glm::vec3> &poligono) {
    const Panel &p = estado.paneles[static_cast<std::size_t>(k)];
    const glm::mat4 delMundo = p.aRecortado(),
                    deNdc =
                        glm::mat4(glm::dmat4(delMundo) * glm::inverse(estado.m.proyeccion * estado.m.camara));
    abreRecuadro(p.escena, k == VENTANA ? CIELO : FONDO_CLARO);
    glEnable(GL_DEPTH_TEST);
    dibujaCuerpo(p, cuerpo());
    if (estado.tapado && k != OBJETO)
        dibujaCuerpo(p, estado.cuerpos[TAPA]);
    if (k == OBJETO || k == MUNDO || k == CAMARA)
        for (int eje = 0; eje < 3; ++eje) {
            glm::vec3 punta(0);
            punta[eje] = 1.2f;
            trazaFlecha({0, 0, 0}, punta, p.proyeccion * p.camara, COLOR_EJE[eje]);
        }
    if (k == MUNDO || k == CAMARA || k == NDC)
        trazaVolumen(k, delMundo, deNdc, glm::vec3(e.mundo));
    glDisable(GL_DEPTH_TEST); // lo que se señala, aunque esté tapado
    trazaPolilinea(poligono, deNdc, MORADO, GROSOR, true);
    if (k < NDC || e.recortado.w > 0) // lo de detrás del ojo no tiene sitio después
        trazaPuntos({glm::vec3(e.mundo)}, delMundo, ROJO, 22);
}

// De cerca (0) a lejos (1): la profundidad del fragmento y la que ya está guardada en su píxel.
static void dibujaProfundidad(const Etapas &e, double guardada) {
    abreRecuadro(estado.paneles[PROFUNDIDAD].escena, FONDO_CLARO);
    const auto enEscala = [](double z) { return glm::vec3(1.5 * z - 0.75, -0.1, 0); };
    const glm::mat4 uno(1);
    trazaSegmentos({enEscala(0), enEscala(1)}, uno, OSCURO, GROSOR);
    trazaPuntos({enEscala(0)}, uno, NARANJA);
    trazaPuntos({enEscala(1)}, uno, AZUL);
    if (!e.dentro)
        return;
    trazaFlecha(enEscala(guardada) - glm::vec3(0, 0.5f, 0), enEscala(guardada), uno, OSCURO);
    trazaPuntos({enEscala(e.ventana.z)}, uno, ROJO, 22);
    rotulaPunto("fragmento", enEscala(e.ventana.z), uno, ROJO, Lado::ENCIMA, 0.03f);
    rotulaPunto("guardada", enEscala(guardada) - glm::vec3(0, 0.5f, 0), uno, OSCURO, Lado::DEBAJO, 0.03f);
}

static void dibuja() {
    calculaMatrices();
    const Cuerpo &c = cuerpo(), &tapa = estado.cuerpos[TAPA];
    const glm::dmat4 aRecortado = estado.m.proyeccion * estado.m.camara;
    const Etapas e = recorre(c.vertices[estado.elegido], estado.m);
    std::vector<Triangulo> demas =
        triangulosSin(c.vertices, c.indices, aRecortado * estado.m.M, c.vertices[estado.elegido]);
    if (estado.tapado)
        for (const Triangulo &t :
             triangulosSin(tapa.vertices, tapa.indices, aRecortado * glm::dmat4(tapa.M), OJO))
            demas.push_back(t);
    const double guardada = profundidadGuardada(demas, estado.m.viewport, glm::dvec2(e.ventana));
    const auto poligono =
        estado.cual == TRIANGULO ? recorta(c.vertices, estado.m) : std::vector<glm::dvec4>();
    const std::string texto = "vértice: " + std::to_string(estado.elegido) + "\n" + describe(e) +
                              (e.dentro ? describeTest(e.ventana.z, guardada) : "") +
                              describe(poligono, estado.m.viewport);
    if (texto != estado.escrito) // al orbitar por fuera no cambia nada
        std::fputs(texto.c_str(), stdout);
    estado.escrito = texto;

    abreRecuadro(ventanaEntera(), GRIS);
    std::vector<glm::vec3> enNdc;
    for (const glm::dvec4 &v : poligono)
        enNdc.push_back(divide(v));
    for (int k = 0; k < PANELES; ++k) {
        abreRecuadro(estado.paneles[static_cast<std::size_t>(k)].panel, FONDO_CLARO);
        if (k == PROFUNDIDAD)
            dibujaProfundidad(e, guardada);
        else
            dibujaEscena(k, e, enNdc);
        const Recuadro &r = estado.paneles[static_cast<std::size_t>(k)].panel;
        glViewport(r.x, r.y, r.ancho, r.alto);
        rotula(TITULOS[k], {0.03f, 0.94f}, OSCURO, Lado::DERECHA, 0.03f);
        rotula(numerosPanel(k, e, guardada), {0.03f, 0.15f}, ROJO, Lado::DERECHA, 0.03f);
        if (k == NDC)
            rotula(conDosDecimales("w", e.recortado.w), {0.97f, 0.15f}, ROJO, Lado::IZQUIERDA, 0.03f);
    }
    ponTitulo("Las etapas del pipeline: vértice " + std::to_string(estado.elegido));
    glutSwapBuffers();
}

static void raton(int boton, int pulsado, int x, int y) {
    if (boton == GLUT_LEFT_BUTTON && pulsado == GLUT_DOWN)
        estado.elegido = verticeSenalado(estado.paneles, estado.m.M, cuerpo().vertices, x,
                                         glutGet(GLUT_WINDOW_HEIGHT) - 1 - y, estado.elegido);
    orbitaBoton(boton, pulsado, x, y);
    glutPostRedisplay();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    if (tecla == 'r') {
        estado.cual = estado.cual == CUBO ? TRIANGULO : CUBO;
        estado.elegido = estado.cual == CUBO ? 14 : 0;
    } else if (tecla == 'o') {
        estado.tapado = !estado.tapado;
    } else {
        return;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Las etapas del pipeline", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMouseFunc(raton);
    glutMainLoop();
    return 0;
}
