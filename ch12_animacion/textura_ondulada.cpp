// Una textura que ondula (§12.1): la geometría es siempre el mismo cuadrado, y lo que cambia con el tiempo son las
// coordenadas con que el fragment shader lee la imagen, a las que suma un seno. Es lo que se ve a través del agua.
// Controles: espacio pausa · s adelanta medio segundo · d una décima · h diez horas · Esc termina.
#include "animacion.h"
#include "buferes.h"
#include "colores.h"
#include "imagen.h"
#include "malla.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "reloj.h"
#include "shader.h"
#include "textura.h"
#include "ventana.h"

static const double PERIODO = 4; // segundos
static const float AMPLITUD = 0.03f;

static struct {
    GLuint programa, textura;
    Buferes plano;
    Reloj reloj;
} estado;

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT);
    usaPrograma(estado.programa, glm::mat4(1), paralelaVentana(0.64f));
    envia(estado.programa, "M", glm::mat4(1));
    envia(estado.programa, "Img", 0);
    envia(estado.programa, "tau", fase(tiempo(estado.reloj), PERIODO));
    envia(estado.programa, "amplitud", AMPLITUD);
    glBindTexture(GL_TEXTURE_2D, estado.textura);
    dibujaMalla(estado.plano);
    rotulaTiempo(estado.reloj, OSCURO);
    tituloAnimado(estado.reloj, "Textura ondulada");
    glutSwapBuffers();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Textura ondulada", GLUT_DOUBLE | GLUT_MULTISAMPLE,
                "[FOTO.ppm | FOTO.rgb -talla ANCHOxALTO]");
    estado.programa = creaPrograma("ch06_texturas/textura.vert", "ch12_animacion/textura_ondulada.frag");
    estado.textura = creaTextura2D(imagenDeArgumentos(argc, argv, "assets/carta.rgb", 256, 256));
    // fuera de la imagen, su borde
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    estado.plano = creaBuferes(plano(1));
    ponFondo(FONDO_CLARO);
    glutDisplayFunc(dibuja);
    animaConReloj(estado.reloj);
    glutMainLoop();
    return 0;
}
