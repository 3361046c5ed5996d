// El efecto escalera o de dientes de sierra y cómo se quita (§9.3, figura 9.4): sin nada, un píxel es del triángulo
// si lo es su centro; con multimuestra (que el libro llama también sobremuestreo o FSAA) se miran varios puntos de
// cada píxel y se promedian, con un solo color por triángulo; con sobremuestreo se dibuja todo VECES × VECES mayor y
// se reduce. El libro pide las muestras a la ventana con GLUT_MULTISAMPLE y las cuenta con GL_SAMPLE_BUFFERS (no
// GL_SAMPLES_BUFFERS); una ventana puede no darlas, y aquí se piden a un framebuffer propio. Con los tres a la vez
// se ve solo la punta de un rayo, aumentada, y lo que OpenGL dice de cada framebuffer.
// Controles: 1 sin nada · 2 multimuestra · 3 sobremuestreo · v los tres · espacio gira la estrella o la para ·
// Esc termina.
#include "buferes.h"
#include "colores.h"
#include "estrella.h"
#include "imagen_en_ventana.h"
#include "lupa.h"
#include "modos.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "texto.h"
#include "ventana.h"
#include <glm/gtc/constants.hpp>

static const int VECES = 4, MUESTRAS = 4, DENTRO = 16;
// En la escena, el centro de los DENTRO × 2·DENTRO de una punta.
static const glm::vec2 PUNTA(163 / 240.0f, 210 / 240.0f);
static const int LADO_COMPARADO = 240; // de la escena de la que se compara una punta, sea como sea la ventana
static const int MS = 40;
static const double VELOCIDAD = 5e-5; // radianes por milisegundo
static const char *const NOMBRES[3] = {"Sin antialiasing", "Multimuestra", "Sobremuestreo"},
                         *const CORTOS[3] = {"Sin nada", "Multi", "Sobre"};

static struct {
    GLuint pinta, reduce, renderbuffer, multimuestra;
    Buferes estrella;
    GLint buffersVentana, muestrasVentana, muestras, buffers, muestrasPorPixel;
    Lienzo lienzo = {0, 0}, grande = {0, 0};
    Lupa lupa = {0, 0}; // el lado es el de los framebuffers
    double giro = 0;    // de la estrella, en radianes
    bool girando = false;
    Modos modos{3};
} estado;

// Los framebuffers de lado × lado; se rehacen si cambia.
static void creaLienzos(int lado) {
    if (lado == estado.lupa.lado)
        return;
    for (const Lienzo &l : {estado.lienzo, estado.grande}) {
        glDeleteFramebuffers(1, &l.framebuffer);
        glDeleteTextures(1, &l.textura);
    }
    estado.lupa.lado = lado;
    estado.lienzo = creaLienzo({lado, lado});
    estado.grande = creaLienzo({VECES * lado, VECES * lado});
    GLint mayor = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &mayor);
    glBindRenderbuffer(GL_RENDERBUFFER, estado.renderbuffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, std::min(MUESTRAS, mayor), GL_RGBA8, lado, lado);
    glBindFramebuffer(GL_FRAMEBUFFER, estado.multimuestra);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, estado.renderbuffer);
    glGetIntegerv(GL_SAMPLES, &estado.muestras);
}

static void dibujaEstrella(GLuint framebuffer, int lado) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glGetIntegerv(GL_SAMPLE_BUFFERS, &estado.buffers);
    glGetIntegerv(GL_SAMPLES, &estado.muestrasPorPixel);
    abreRecuadro({0, 0, lado, lado});
    ponFondo(FONDO_CLARO);
    glClear(GL_COLOR_BUFFER_BIT);
    glUseProgram(estado.pinta);
    envia(estado.pinta, "color", OSCURO);
    envia(estado.pinta, "giro", glm::vec2(std::cos(estado.giro), std::sin(estado.giro)));
    dibujaMalla(estado.estrella);
}

// Deja la escena en estado.lienzo con esa técnica.
static void dibujaEscena(int tecnica) {
    const int lado = estado.lupa.lado;
    if (tecnica == 0) {
        dibujaEstrella(estado.lienzo.framebuffer, lado);
    } else if (tecnica == 1) {
        glEnable(GL_MULTISAMPLE);
        dibujaEstrella(estado.multimuestra, lado);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, estado.lienzo.framebuffer);
        glBlitFramebuffer(0, 0, lado, lado, 0, 0, lado, lado, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    } else {
        dibujaEstrella(estado.grande.framebuffer, VECES * lado);
        glBindFramebuffer(GL_FRAMEBUFFER, estado.lienzo.framebuffer);
        abreRecuadro({0, 0, lado, lado});
        glUseProgram(estado.reduce);
        glBindTexture(GL_TEXTURE_2D, estado.grande.textura);
        envia(estado.reduce, "imagen", 0);
        envia(estado.reduce, "veces", VECES);
        dibujaRectangulo();
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glBindTexture(GL_TEXTURE_2D, estado.lienzo.textura);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

static std::string conVeces(const char *nombre, int tecnica) {
    const int veces[3] = {1, estado.muestras, VECES * VECES};
    return nombre + (tecnica == 0 ? "" : " ×" + std::to_string(veces[tecnica]));
}

// El cuadrado de la escena, píxel a píxel, y en su centro, que está vacío, la punta de un rayo aumentada; debajo, el
// nombre.
static void dibujaPanel(int tecnica, const Recuadro &panel) {
    const int lado = std::max(std::min(panel.ancho, panel.alto * 9 / 10), 1);
    creaLienzos(lado);
    dibujaEscena(tecnica);
    const int x = panel.x + (panel.ancho - lado) / 2, y = panel.y + (panel.alto - lado + lado / 9) / 2;
    dibujaPixeles(estado.lupa, {0, 0}, {lado, lado}, {x, y, lado, lado}, FONDO_CLARO);
    const int lupa = std::max(lado * 3 / 10 / DENTRO, 1) * DENTRO;
    const glm::vec2 punta = glm::vec2(estrella()[7]) / 2.0f; // la del tercer rayo, desde el centro
    const glm::vec2 centro = punta - glm::normalize(punta) * 8.0f / float(lado) + 0.5f; // 8 píxeles antes
    const glm::vec2 primero = primerPixel(estado.lupa, centro, glm::vec2(DENTRO), estado.giro);
    senalaPixeles(estado.lupa, primero, {DENTRO, DENTRO}, NARANJA);
    dibujaPixeles(estado.lupa, primero, {DENTRO, DENTRO},
                  {x + (lado - lupa) / 2, y + (lado - lupa) / 2, lupa, lupa}, NARANJA);
    abreRecuadro({panel.x, y - lado / 9, panel.ancho, lado / 9});
    rotula(conVeces(NOMBRES[tecnica], tecnica), {0.5f, 0.5f}, OSCURO);
}

// La punta, todo lo aumentada que quepa, y debajo lo que dice OpenGL de donde se ha dibujado.
static void dibujaPunta(int tecnica, const Recuadro &panel) {
    creaLienzos(LADO_COMPARADO);
    dibujaEscena(tecnica);
    const int pie = panel.alto * 9 / 40;
    const int libre = panel.alto - pie - 8;
    const int ancho = std::max(std::min((panel.ancho - 4) / DENTRO, libre / (2 * DENTRO)), 1) * DENTRO;
    dibujaPixeles(
        estado.lupa, primerPixel(estado.lupa, PUNTA, {DENTRO, 2 * DENTRO}, estado.giro), {DENTRO, 2 * DENTRO},
        {panel.x + (panel.ancho - ancho) / 2, panel.y + pie + (libre - 2 * ancho) / 2, ancho, 2 * ancho},
        NARANJA);
    abreRecuadro(panel);
    rotula(conVeces(CORTOS[tecnica], tecnica), {0.5f, 0.17f}, OSCURO);
    rotula(formatea("%d y %d", estado.buffers, estado.muestrasPorPixel), {0.5f, 0.11f}, AZUL);
}

static void dibuja() {
    abreRecuadro(ventanaEntera());
    ponFondo(FONDO_CLARO);
    glClear(GL_COLOR_BUFFER_BIT);
    if (estado.modos.todos) {
        const std::vector<Recuadro> paneles = rejilla(3, 1);
        for (int tecnica = 0; tecnica < 3; ++tecnica)
            dibujaPunta(tecnica, paneles[tecnica]);
        abreRecuadro(ventanaEntera());
        rotula("GL_SAMPLE_BUFFERS y GL_SAMPLES", {0.5f, 0.045f}, AZUL, Lado::CENTRO, 0.035f);
    } else {
        dibujaPanel(estado.modos.elegido, ventanaEntera());
    }
    ponTitulo(formatea("Antialiasing: %s%s (ventana: GL_SAMPLE_BUFFERS %d, GL_SAMPLES %d)",
                       estado.modos.todos ? "los tres" : NOMBRES[estado.modos.elegido],
                       estado.girando ? ", girando" : "", estado.buffersVentana, estado.muestrasVentana));
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    if (tecla == ' ')
        estado.girando = !estado.girando;
    else
        teclaModos(estado.modos, tecla);
    glutPostRedisplay();
}

static void reloj(int antes) {
    const int ahora = glutGet(GLUT_ELAPSED_TIME);
    if (estado.girando) {
        // cada RAYOS-ésimo de vuelta la estrella es la misma, y se aumenta otro rayo
        estado.giro = std::fmod(estado.giro + VELOCIDAD * (ahora - antes), glm::two_pi<double>() / RAYOS);
        glutPostRedisplay();
    }
    glutTimerFunc(MS, reloj, ahora);
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Antialiasing", GLUT_DOUBLE | GLUT_MULTISAMPLE);
    estado.estrella = creaBuferes(mallaEstrella());
    estado.pinta = creaPrograma("ch09_imagen/estrella.vert", "common/liso.frag");
    estado.reduce = creaPrograma("ch09_imagen/imagen.vert", "ch09_imagen/reduce.frag");
    estado.lupa.programa = creaPrograma("ch09_imagen/lupa.vert", "ch09_imagen/imagen.frag");
    glGetIntegerv(GL_SAMPLE_BUFFERS, &estado.buffersVentana);
    glGetIntegerv(GL_SAMPLES, &estado.muestrasVentana);
    glGenRenderbuffers(1, &estado.renderbuffer);
    glGenFramebuffers(1, &estado.multimuestra);
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    reloj(glutGet(GLUT_ELAPSED_TIME));
    glutMainLoop();
    return 0;
}
