// Remolino (figura 9.1): el fragment shader mira en la imagen el punto que el remolino ha llevado a cada píxel. Se
// pregunta de dónde viene cada píxel y no adónde va cada texel: así no quedan huecos.
// Controles: + - ángulo · v con el original al lado · r rótulos · Esc termina.
#include "colores.h"
#include "imagen.h"
#include "imagen_en_ventana.h"
#include "recuadro.h"
#include "shader.h"
#include "ventana.h"

static const int PASO = 15, MAXIMO = 720; // grados

static struct {
    GLuint programa;
    Muestra muestra;
    int grados = 240;
} estado;

static void dibujaRemolino(int grados, const Recuadro &panel) {
    abreRecuadro(panel);
    envia(estado.programa, "angulo", glm::radians(float(grados)));
    dibujaRectangulo();
    rotulaImagen(estado.muestra, std::to_string(grados) + "°");
}

static void dibuja() {
    abreRecuadro(ventanaEntera());
    ponFondo(FONDO_OSCURO);
    glClear(GL_COLOR_BUFFER_BIT);
    glUseProgram(estado.programa);
    envia(estado.programa, "imagen", 0);
    const std::vector<Recuadro> paneles = recuadros(estado.muestra, 2);
    if (estado.muestra.compara)
        dibujaRemolino(0, paneles[0]);
    dibujaRemolino(estado.grados, paneles.back());
    ponTitulo("Remolino de " + std::to_string(estado.grados) + "°");
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaMuestra(estado.muestra, tecla))
        return;
    switch (tecla) {
    case '+': estado.grados = std::min(estado.grados + PASO, MAXIMO); break;
    case '-': estado.grados = std::max(estado.grados - PASO, -MAXIMO); break;
    default: return;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    const std::vector<Imagen> imagenes = abreVentanaConImagenes(
        argc, argv, "Remolino", {{"assets/foto_grande.rgb", 1000, 760}}, estado.muestra);
    estado.programa = creaPrograma("ch09_imagen/imagen.vert", "ch09_imagen/remolino.frag");
    creaTexturaExacta(imagenes[0]);
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    glutMainLoop();
    return 0;
}
