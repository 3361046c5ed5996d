// Desplazamiento (§8.5, figura 8.7): el vertex shader lee un mapa de alturas y mueve cada vértice en la dirección de su
// normal. Al contrario que con bump mapping, la geometría cambia de verdad: cambia el contorno y unas partes tapan a
// otras.
// Controles: + - amplitud · ratón orbita · Esc termina.
#include "buferes.h"
#include "ch03_transformaciones/transformaciones.h"
#include "ch05_iluminacion/iluminacion.h"
#include "colores.h"
#include "malla.h"
#include "mapa_alturas.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "texto.h"
#include "ventana.h"
#include <algorithm>
#include <glm/gtc/constants.hpp>

static struct {
    GLuint programa, mapa;
    Buferes plano;
    int amplitud = 7; // veinteavos del lado del plano
    Orbita orbita = {0.12f, 0.5f, 4.1f, {-0.07f, 0.14f, 0}, 0.05f};
} estado;

static void inicia() {
    estado.programa = creaPrograma("ch08_texturas_avanzadas/desplazamiento.vert",
                                   "ch08_texturas_avanzadas/desplazamiento.frag");
    estado.plano = creaBuferes(plano(LADO_MAPA - 1));
    glGenTextures(1, &estado.mapa);
    glBindTexture(GL_TEXTURE_2D, estado.mapa);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, LADO_MAPA, LADO_MAPA, 0, GL_RED, GL_FLOAT, mapaAlturas().data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                    GL_NEAREST); // cada vértice cae en el centro de un texel
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glEnable(GL_DEPTH_TEST);
    ponFondo(CIELO);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const float amplitud = float(estado.amplitud) / 20;
    const glm::mat4 camara = camaraOrbita(estado.orbita), M = giroX(-glm::half_pi<float>()) * escalado(2);
    usaPrograma(estado.programa, camara, perspectivaVentana(0.5f, 0.5f, 50));
    envia(estado.programa, "M", M);
    envia(estado.programa, "N", matrizNormal(camara * M));
    envia(estado.programa, "La", glm::vec3(1));
    enviaLuz(estado.programa, "luz", {{-3, 2.2f, 1, 0}}, camara);
    envia(estado.programa, "alturas", 0);
    envia(estado.programa, "amplitud", amplitud);
    envia(estado.programa, "lado", float(LADO_MAPA));
    dibujaMalla(estado.plano);

    const std::string texto = formatea("amplitud = %.2f", amplitud);
    rotula(texto, {0.02f, 0.98f}, OSCURO, Lado::DERECHA);
    ponTitulo("Desplazamiento: " + texto);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || (tecla != '+' && tecla != '-'))
        return;
    estado.amplitud = std::clamp(estado.amplitud + (tecla == '+' ? 1 : -1), 0, 10);
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Desplazamiento", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
