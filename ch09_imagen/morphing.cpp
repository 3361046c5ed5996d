// Morphing (§9.4): una malla en cada imagen, con los mismos puntos sobre los mismos rasgos. Al pasar t de 0 a 1 los
// vértices van de los sitios de una a los de la otra y, a la vez, los colores se mezclan: los ojos van a los ojos. Con
// t = 0 se ve A, exacta, y con t = 1, B. La mezcla del listado 9.2, con los mismos colores, no mueve nada: se ven las
// dos caras. Si las imágenes son del usuario, las mallas empiezan regulares y los puntos se arrastran: con t < 0.5 los
// de A y, si no, los de B.
// Controles: 1 2 3 t = 0, 0.5 y 1 · + - t · espacio lo mueve · m malla · v A, t, B y su mezcla ·
// ratón arrastra un punto · r rótulos · Esc termina.
#include "buferes.h"
#include "colores.h"
#include "imagen.h"
#include "imagen_en_ventana.h"
#include "malla_en_ventana.h"
#include "malla_imagen.h"
#include "mallas_cara.h"
#include "modos.h"
#include "recuadro.h"
#include "shader.h"
#include "texto.h"
#include "ventana.h"

static const int VUELTA = 6000;          // ms que t tarda en ir y volver
static const int VIGESIMO = VUELTA / 40; // y en pasar 1/20
static const int MS_CUADRO = 33;

static struct {
    GLuint programa, programaMezcla;
    Buferes buferes;
    Muestra muestra;
    MallaImagen a, b;
    int recorrido = VUELTA / 4, comienzo = 0; // ms andados, y reloj al echar a andar
    std::size_t punto = 0;
    bool mueve = false, arrastra = false, conMalla = false;
} estado;

static MallaImagen intermedia(float t) {
    MallaImagen m = estado.a;
    for (std::size_t i = 0; i < m.puntos.size(); ++i)
        m.puntos[i] = glm::mix(estado.a.puntos[i], estado.b.puntos[i], t);
    return m;
}

// Los milisegundos que lleva t yendo de 0 a 1 y volviendo.
static int andado() {
    return (estado.recorrido + (estado.mueve ? glutGet(GLUT_ELAPSED_TIME) - estado.comienzo : 0)) % VUELTA;
}

static int deIda() {
    return std::min(andado(), VUELTA - andado());
}

static float tActual() {
    return float(deIda()) / float(VUELTA / 2);
}

static void sigueDesde(int ms) {
    estado.recorrido = ms;
    estado.comienzo = glutGet(GLUT_ELAPSED_TIME);
}

static void dibujaMorphing(float t, const Recuadro &panel, const std::string &rotulo) {
    abreRecuadro(panel);
    glUseProgram(estado.programa);
    envia(estado.programa, "imagenA", 0);
    envia(estado.programa, "imagenB", 1);
    envia(estado.programa, "t", t);
    dibujaMalla(estado.buferes);
    if (estado.conMalla)
        trazaMalla(intermedia(t));
    rotulaImagen(estado.muestra, rotulo);
}

static void dibujaMezcla(float t, const Recuadro &panel, const std::string &rotulo) {
    abreRecuadro(panel);
    glUseProgram(estado.programaMezcla);
    envia(estado.programaMezcla, "imagenA", 0);
    envia(estado.programaMezcla, "imagenB", 1);
    envia(estado.programaMezcla, "alfa", t);
    dibujaRectangulo();
    rotulaImagen(estado.muestra, rotulo);
}

static void dibuja() {
    const float t = tActual();
    const std::string rotulo = formatea("t = %.2f", t);
    abreRecuadro(ventanaEntera());
    ponFondo(FONDO_OSCURO);
    glClear(GL_COLOR_BUFFER_BIT);
    cambiaVertices(estado.buferes, triangulaImagen(estado.a, estado.b));
    const std::vector<Recuadro> paneles = recuadros(estado.muestra, 4);
    if (estado.muestra.compara) {
        dibujaMorphing(0, paneles[0], "A");
        dibujaMorphing(t, paneles[1], rotulo);
        dibujaMorphing(1, paneles[2], "B");
        dibujaMezcla(t, paneles[3], std::string("mezcla, ") + rotulo);
    } else {
        dibujaMorphing(t, paneles[0], rotulo);
    }
    ponTitulo(std::string("Morphing: ") + rotulo);
    glutSwapBuffers();
}

static void cuadro(int) {
    if (estado.mueve)
        glutPostRedisplay();
    glutTimerFunc(MS_CUADRO, cuadro, 0);
}

static glm::vec2 enImagen(int x, int y) {
    return enRecuadro(recuadros(estado.muestra, 4)[0], x, y);
}

static void raton(int boton, int pulsado, int x, int y) {
    if (boton != GLUT_LEFT_BUTTON)
        return;
    estado.arrastra = pulsado == GLUT_DOWN && !estado.muestra.compara;
    if (estado.arrastra)
        estado.punto = nudoMasCercano(intermedia(tActual()), enImagen(x, y), estado.muestra.talla);
}

// Mueve el punto de la imagen de la que más se ve, de modo que el intermedio quede bajo el ratón.
static void arrastra(int x, int y) {
    if (!estado.arrastra)
        return;
    const float t = tActual();
    glm::vec2 &a = estado.a.puntos[estado.punto], &b = estado.b.puntos[estado.punto];
    const glm::vec2 p = enImagen(x, y);
    if (t < 0.5f)
        a = glm::clamp((p - t * b) / (1 - t), 0.0f, 1.0f);
    else
        b = glm::clamp((p - (1 - t) * a) / t, 0.0f, 1.0f);
    glutPostRedisplay();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaMuestra(estado.muestra, tecla))
        return;
    if (int cuarto; eligeModo(cuarto, 3, tecla))
        return sigueDesde(cuarto * VUELTA / 4);
    switch (tecla) {
    case '+': sigueDesde(std::min(deIda() + VIGESIMO, VUELTA / 2)); break;
    case '-': sigueDesde(std::max(deIda() - VIGESIMO, 0)); break;
    case ' ':
        sigueDesde(andado());
        estado.mueve = !estado.mueve;
        break;
    case 'm': estado.conMalla = !estado.conMalla; break;
    default: return;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    const std::vector<Imagen> imagenes = abreVentanaConImagenes(
        argc, argv, "Morphing", {{"assets/cara.rgb", 960, 720}, {"assets/gato.rgb", 960, 720}},
        estado.muestra);
    estado.programa = creaPrograma("ch09_imagen/morphing.vert", "ch09_imagen/morphing.frag");
    estado.programaMezcla = creaPrograma("ch09_imagen/imagen.vert", "ch09_imagen/mezcla.frag");
    const bool propias = argc > 1;
    estado.a = propias ? REGULAR : CARA;
    estado.b = propias ? REGULAR : GATO;
    estado.buferes = creaBuferes(triangulaImagen(estado.a, estado.b));
    for (int unidad = 0; unidad < 2; ++unidad) {
        glActiveTexture(GL_TEXTURE0 + unidad);
        creaTexturaExacta(imagenes[unidad]);
    }
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    glutMouseFunc(raton);
    glutMotionFunc(arrastra);
    glutTimerFunc(MS_CUADRO, cuadro, 0);
    glutMainLoop();
    return 0;
}
