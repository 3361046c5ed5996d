// Remolino (figura 9.1): el fragment shader mira en la imagen el punto que el remolino ha llevado a cada píxel. Se
// pregunta de dónde viene cada píxel y no adónde va cada texel: así no quedan huecos.
// Controles: + - ángulo · v con el original al lado · r rótulos · Esc termina.
#include "imagen_en_ventana.h"

static const int PASO = 15, MAXIMO = 720; // grados

static struct {
    GLuint programa;
    glm::ivec2 talla;
    int grados = 240;
    bool compara = false, rotulos;
} estado;

static void dibujaRemolino(int grados, const Recuadro &panel) {
    dibujaEn(encaja(estado.talla, panel));
    envia(estado.programa, "angulo", glm::radians(float(grados)));
    dibujaRectangulo();
    if (estado.rotulos)
        rotulaImagen(std::to_string(grados) + "°");
}

static void dibuja() {
    abreRecuadro(ventanaEntera(), FONDO_OSCURO);
    glUseProgram(estado.programa);
    envia(estado.programa, "imagen", 0);
    if (estado.compara) {
        const std::vector<Recuadro> paneles = panelesPara(2, estado.talla);
        dibujaRemolino(0, paneles[0]);
        dibujaRemolino(estado.grados, paneles[1]);
    } else {
        dibujaRemolino(estado.grados, ventanaEntera());
    }
    ponTitulo("Remolino de " + std::to_string(estado.grados) + "°");
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    switch (tecla) {
    case '+': estado.grados = std::min(estado.grados + PASO, MAXIMO); break;
    case '-': estado.grados = std::max(estado.grados - PASO, -MAXIMO); break;
    case 'v': estado.compara = !estado.compara; break;
    case 'r': estado.rotulos = !estado.rotulos; break;
    default: return;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    const auto [imagenes, propias] =
        abreVentanaConImagenes(argc, argv, "Remolino", {{"assets/foto_grande.rgb", 1000, 760}});
    estado.programa = creaPrograma("ch09_imagen/imagen.vert", "ch09_imagen/remolino.frag");
    estado.talla = tallaDe(imagenes[0]);
    estado.rotulos = !propias;
    creaTexturaExacta(imagenes[0]);
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    glutMainLoop();
    return 0;
}
