// Un vértice y su fragmento (el punto rojo) por las etapas del pipeline (figura 1.3, ejercicio 4.1, ecuación 4.4); en
// morado, lo que hace un procesador programable. Con r, un triángulo que llega detrás del ojo: etapas.h lo recorta, y
// el polígono que queda (de borde morado) es justo lo que dibuja OpenGL. Con o, algo tapa el fragmento.
// Controles: clic elige vértice · r recortado · o oculto · arrastrar orbita por fuera · rueda acerca · Esc termina.
#include "buferes.h"
#include "ch03_transformaciones/transformaciones.h"
#include "colores.h"
#include "etapas.h"
#include "malla.h"
#include "orbita.h"
#include "paneles_etapas.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "trazo.h"
#include "ventana.h"

static const float TALLA = 0.03f, DONDE_TAPA = 0.79f; // del ojo (0) al vértice (1)

enum { CUBO, TRIANGULO, TAPA, CUERPOS };
static const glm::vec3 COLORES[CUERPOS] = {AMARILLO, AMARILLO, VERDE};
static const std::size_t PRIMERO[] = {14, 0}; // el vértice que se sigue al empezar

static struct {
    GLuint programa;
    Modelo cuerpos[CUERPOS];
    Buferes buferes[CUERPOS];
    int cuerpo = CUBO;
    bool tapado = false;
    std::size_t elegido = PRIMERO[CUBO];
    Matrices m;
    std::array<Panel, PANELES> paneles;
    std::string escrito;
    Orbita orbita = {0.95f, 0.35f, 1};
} estado;

static void creaCuerpo(int cual, const Malla &malla, const glm::mat4 &M) {
    estado.cuerpos[cual] = {{}, malla.indices, M};
    estado.buferes[cual] = creaBuferes(malla);
    for (const Vertice &v : malla.vertices)
        estado.cuerpos[cual].vertices.push_back(v.posicion);
}

static void inicia() {
    estado.programa = creaPrograma("ch04_vista3d/volumen_vista.vert", "ch04_vista3d/volumen_vista.frag");
    Malla triangulo = {{}, {0, 1, 2}};
    for (const glm::vec3 &v : {glm::vec3(-0.7f, 0.8f, -0.5f), {0.9f, -0.2f, 5}, {1.5f, -0.6f, -1.4f}})
        triangulo.vertices.push_back({v, {0, 1, 0}, {0, 0}});
    const glm::mat4 M = traslacion({0.2f, 0.8f, 0.3f}) * giroY(-0.35f) * escalado({2.0f, 1.2f, 1.4f});
    creaCuerpo(CUBO, cubo(), M);
    creaCuerpo(TRIANGULO, triangulo, M);
    creaCuerpo(TAPA, cubo(), glm::mat4(1));
}

// Con la luz del mundo en todos los paneles y en gris lo que queda fuera del volumen.
static void dibujaCuerpo(const Panel &p, int cual) {
    const glm::dmat4 &M = estado.cuerpos[cual].M;
    usaPrograma(estado.programa, p.camara, p.proyeccion);
    envia(estado.programa, "M", glm::mat4(p.delMundo * M));
    envia(estado.programa, "N", matrizNormal(glm::mat4(M)));
    envia(estado.programa, "aRecortado", glm::mat4(estado.m.proyeccion * estado.m.camara * M));
    envia(estado.programa, "colorObjeto", COLORES[cual]);
    dibujaMalla(estado.buferes[cual]);
}

// Las aristas del volumen de la vista, llevadas de las coordenadas normalizadas al panel.
static void trazaVolumen(const glm::mat4 &deNdc) {
    const std::vector<glm::vec3> cerca = caraVolumen(-1), lejos = caraVolumen(1);
    for (std::size_t i = 0; i < 4; ++i)
        trazaSegmentos({cerca[i], lejos[i]}, deNdc, OSCURO, 3);
    trazaPolilinea(cerca, deNdc, NARANJA, GROSOR, true);
    trazaPolilinea(lejos, deNdc, AZUL, GROSOR, true);
}

static void dibujaEscena(std::size_t k, const Etapas &e, const std::vector<glm::dvec4> &poligono) {
    const Panel &p = estado.paneles[k];
    const glm::mat4 delMundo = p.aRecortado();
    const glm::mat4 deNdc = delMundo * glm::mat4(glm::inverse(estado.m.proyeccion * estado.m.camara));
    abreRecuadro(p.escena);
    ponFondo(k == VENTANA ? CIELO : FONDO_CLARO);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    dibujaCuerpo(p, estado.cuerpo);
    if (estado.tapado && k != OBJETO)
        dibujaCuerpo(p, TAPA);
    if (k == OBJETO || k == MUNDO || k == CAMARA)
        for (int eje = 0; eje < 3; ++eje)
            trazaFlecha({0, 0, 0}, glm::mat3(1.2f)[eje], p.proyeccion * p.camara, COLOR_EJE[eje]);
    if (k == MUNDO || k == CAMARA || k == NDC)
        trazaVolumen(deNdc);
    if (k == MUNDO || k == CAMARA)
        trazaSegmentos({glm::vec3(OJO), glm::vec3(e.mundo)}, delMundo, ROJO, 3);
    glDisable(GL_DEPTH_TEST); // lo que se señala, aunque esté tapado
    trazaPolilinea(divide(poligono), deNdc, MORADO, GROSOR, true);
    if (k < NDC || e.recortado.w > 0) // lo de detrás del ojo no tiene sitio después
        trazaPuntos({glm::vec3(e.mundo)}, delMundo, ROJO, 22);
}

// De cerca (0) a lejos (1): la profundidad del fragmento y la que ya está guardada en su píxel.
static void dibujaProfundidad(const Etapas &e, double guardada) {
    abreRecuadro(estado.paneles[PROFUNDIDAD].escena);
    ponFondo(FONDO_CLARO);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const auto enEscala = [](double z) { return glm::vec3(0.9 * z - 0.45, -0.1, 0); };
    trazaSegmentos({enEscala(0), enEscala(1)}, glm::mat4(1), OSCURO);
    trazaPuntos({enEscala(0)}, glm::mat4(1), NARANJA);
    trazaPuntos({enEscala(1)}, glm::mat4(1), AZUL);
    if (!e.dentro)
        return;
    const glm::vec3 pie = enEscala(guardada) - glm::vec3(0, 0.3f, 0);
    trazaFlecha(pie, enEscala(guardada), glm::mat4(1), OSCURO);
    trazaPuntos({enEscala(e.ventana.z)}, glm::mat4(1), ROJO, 22);
    rotulaPunto("fragmento", enEscala(e.ventana.z), glm::mat4(1), ROJO, Lado::ENCIMA, TALLA);
    rotulaPunto("guardada", pie, glm::mat4(1), OSCURO, Lado::DEBAJO, TALLA);
}

static void dibuja() {
    const Modelo &c = estado.cuerpos[estado.cuerpo];
    estado.paneles = colocaPaneles(reparte(PANELES));
    estado.m = matricesEn(estado.paneles[VENTANA].escena, c.M);
    colocaMatrices(estado.paneles, estado.m, estado.orbita, estado.cuerpo == CUBO ? 6.0f : 14.0f);

    const Etapas e = recorre(c.vertices[estado.elegido], estado.m);
    std::vector<Modelo> pintados = {c};
    if (estado.tapado) { // en la recta del ojo al vértice
        estado.cuerpos[TAPA].M = traslacion(glm::mix(glm::vec3(OJO), glm::vec3(e.mundo), DONDE_TAPA)) *
                                 escalado({0.6f, 0.5f, 0.2f});
        pintados.push_back(estado.cuerpos[TAPA]);
    }
    const double guardada = profundidadGuardada(pintados, estado.m, e);
    const auto poligono =
        estado.cuerpo == TRIANGULO ? recorta(c.vertices, estado.m) : std::vector<glm::dvec4>();
    const std::string texto = "vértice: " + std::to_string(estado.elegido) + "\n" +
                              describeEtapas(e, guardada, poligono, estado.m.viewport);
    if (texto != estado.escrito) { // al orbitar por fuera no cambia nada
        std::fputs(texto.c_str(), stdout);
        std::fflush(stdout);
    }
    estado.escrito = texto;

    abreRecuadro(ventanaEntera());
    ponFondo(GRIS);
    glClear(GL_COLOR_BUFFER_BIT);
    for (std::size_t k = 0; k < PANELES; ++k) {
        const Recuadro &r = estado.paneles[k].panel;
        abreRecuadro(r);
        ponFondo(FONDO_CLARO);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        if (k == PROFUNDIDAD)
            dibujaProfundidad(e, guardada);
        else
            dibujaEscena(k, e, poligono);
        abreRecuadro(r);
        rotula(TITULOS[k], {0.03f, 0.94f}, OSCURO, Lado::DERECHA, TALLA);
        rotula(numerosPanel(k, e, guardada), {0.03f, 0.175f}, ROJO, Lado::DERECHA, TALLA);
        if (*PROCESADOR[k])
            rotula(PROCESADOR[k], {0.97f, 0.175f}, MORADO, Lado::IZQUIERDA, 0.025f);
    }
    ponTitulo("Las etapas del pipeline: vértice " + std::to_string(estado.elegido));
    glutSwapBuffers();
}

static void raton(int boton, int pulsado, int x, int y) {
    if (boton == GLUT_LEFT_BUTTON && pulsado == GLUT_DOWN)
        estado.elegido = verticeSenalado(estado.paneles, estado.m.M, estado.cuerpos[estado.cuerpo].vertices,
                                         x, glutGet(GLUT_WINDOW_HEIGHT) - 1 - y, estado.elegido);
    orbitaBoton(boton, pulsado, x, y);
    glutPostRedisplay();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || (tecla != 'r' && tecla != 'o'))
        return;
    if (tecla == 'r') {
        estado.cuerpo = estado.cuerpo == CUBO ? TRIANGULO : CUBO;
        estado.elegido = PRIMERO[estado.cuerpo];
    } else {
        estado.tapado = !estado.tapado;
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
