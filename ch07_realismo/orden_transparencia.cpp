// Dos cristales que se solapan (ecuación 7.2): con la mezcla de la ecuación 7.1 el color depende de cuál se dibuja
// antes. O se ordenan de atrás adelante, o se suma al color acumulado: entonces el orden da igual, pero todo brilla
// más. A la izquierda se manda dibujar primero el rojo, que está delante, y a la derecha el azul. Lo transparente no
// escribe su profundidad (§7.1): si la escribe, el cristal de delante no deja dibujar después el de detrás. De cada
// lado se lee y se enseña el color de un píxel, el del centro del solape mientras no se gire la cámara.
// Controles: 1 según llegan · 2 ordenados de atrás adelante · 3 aditivo · d máscara de profundidad · ratón orbita ·
// Esc termina.
#include "buferes.h"
#include "ch03_transformaciones/transformaciones.h"
#include "colores.h"
#include "malla.h"
#include "modos.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "trazo.h"
#include "ventana.h"
#include <algorithm>
#include <array>

static const float ALFA = 0.55f;
static const struct {
    glm::mat4 M;
    glm::vec3 color;
} CRISTALES[2] = {{traslacion({-0.2f, 0.15f, 0.35f}) * escalado({1.5f, 2.4f, 1}), {1, 0.25f, 0.2f}},
                  {traslacion({0.2f, -0.15f, -0.35f}) * escalado({1.5f, 2.4f, 1}), {0.25f, 0.6f, 1}}};
static const char *const MODOS[3] = {"según llegan", "ordenados", "aditivo"};
static const float MUESTRA = 0.3f; // ancho del color leído, en partes del panel

static struct {
    GLuint programa;
    Buferes cuadrado, cubo;
    int elegido = 0;
    bool escribeProfundidad = false;
    Orbita orbita = {0.55f, 0.25f, 6.6f};
} estado;

static void inicia() {
    estado.programa = creaPrograma("ch03_transformaciones/objeto.vert", "ch07_realismo/liso.frag");
    estado.cuadrado = creaBuferes(plano(1));
    estado.cubo = creaBuferes(cubo());
    glEnable(GL_DEPTH_TEST);
}

static void dibujaPieza(const Buferes &pieza, const glm::mat4 &M, const glm::vec4 &color) {
    envia(estado.programa, "M", M);
    envia(estado.programa, "color", color);
    dibujaMalla(pieza);
}

// Un cuadrado del color que tiene ese punto en la ventana, junto al borde del panel que toca al otro.
static void ensenaColor(const Recuadro &r, const glm::vec4 &recortado, bool aLaDerecha) {
    const glm::vec2 p = glm::vec2(recortado) / recortado.w;
    unsigned char rgba[4] = {};
    glReadPixels(r.x + int((p.x + 1) / 2 * float(r.ancho)), r.y + int((p.y + 1) / 2 * float(r.alto)), 1, 1,
                 GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    const float x = aLaDerecha ? 1 - 2 * MUESTRA : -1, abajo = -0.78f, arriba = -0.62f;
    glDisable(GL_DEPTH_TEST);
    trazaSegmentos({glm::vec3(p, 0), {x + MUESTRA, arriba, 0}}, glm::mat4(1), BLANCO, 3);
    trazaPuntos({glm::vec3(p, 0)}, glm::mat4(1), BLANCO, 14);
    trazaPoligono({{x, abajo, 0}, {x + 2 * MUESTRA, abajo, 0}, {x + 2 * MUESTRA, arriba, 0}, {x, arriba, 0}},
                  glm::mat4(1), glm::vec3(rgba[0], rgba[1], rgba[2]) / 255.0f);
    glEnable(GL_DEPTH_TEST);
}

static void dibujaVista(const Recuadro &r, bool rojoAntes) {
    abreRecuadro(r);
    ponFondo(FONDO_OSCURO);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const glm::mat4 camara = camaraOrbita(estado.orbita),
                    proyeccion = perspectivaVentana(0.7f, 0.1f, 30, aspecto(r), 2.0 / 3);
    usaPrograma(estado.programa, camara, proyeccion);
    for (const float x : {-1.25f, -0.36f, 0.3f}) // lo opaco, antes
        dibujaPieza(estado.cubo, traslacion({x, -0.2f, -1}) * escalado({0.16f, 3.5f, 0.16f}),
                    glm::vec4(GRIS, 1));

    std::array<int, 2> orden = {!rojoAntes, rojoAntes};
    if (estado.elegido == 1) { // antes el que está más lejos de la cámara
        const auto profundidad = [&](int i) { return (camara * CRISTALES[i].M[3]).z; };
        std::sort(orden.begin(), orden.end(), [&](int a, int b) { return profundidad(a) < profundidad(b); });
    }
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, estado.elegido == 2 ? GL_ONE : GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(estado.escribeProfundidad);
    for (const int i : orden)
        dibujaPieza(estado.cuadrado, CRISTALES[i].M, glm::vec4(CRISTALES[i].color, ALFA));
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    ensenaColor(r, proyeccion * camara * glm::vec4(0, 0, 0, 1), rojoAntes);
    rotula(MODOS[estado.elegido], {0.5f, 0.95f}, AMARILLO);
    if (estado.escribeProfundidad)
        rotula("con profundidad", {0.5f, 0.88f}, AMARILLO);
    rotula(rojoAntes ? "primero el rojo" : "primero el azul", {0.5f, 0.06f}, BLANCO);
}

static void dibuja() {
    abreRecuadro(ventanaEntera());
    ponFondo(GRIS);
    glClear(GL_COLOR_BUFFER_BIT);
    const std::vector<Recuadro> mitades = rejilla(2, 1); // los dos colores, juntos
    dibujaVista(mitades[0], true);
    dibujaVista(mitades[1], false);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    if (tecla == 'd')
        estado.escribeProfundidad = !estado.escribeProfundidad;
    else if (!eligeModo(estado.elegido, 3, tecla))
        return;
    ponTitulo(std::string("Dos cristales: ") + MODOS[estado.elegido] +
              (estado.escribeProfundidad ? ", escribiendo la profundidad" : ""));
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Dos cristales: según llegan", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
