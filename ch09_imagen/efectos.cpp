// Efectos de imagen (listado 9.1, figura 9.2): cada píxel sale solo de su texel, así que basta un fragment shader. La
// escala de grises es la media del libro y, además, la luminancia: para la media el azul y el verde puros son el mismo
// gris, aunque el verde se ve diez veces más claro. El libro lleva la imagen con glDrawPixels, que OpenGL 3.1 ya no
// tiene: aquí es una textura.
// Controles: 1 original · 2 brillo · 3 negativo · 4 grises, media · 5 grises, luminancia · + - brillo ·
// v los de la figura 9.2 · c los dos grises de seis colores puros · r rótulos · botón derecho menú · Esc termina.
#include "colores.h"
#include "imagen.h"
#include "imagen_en_ventana.h"
#include "modos.h"
#include "recuadro.h"
#include "shader.h"
#include "ventana.h"

static const char *const EFECTOS[] = {"Original", "Brillo", "Negativo", "Media", "Luminancia"};
enum { ORIGINAL, BRILLO, NEGATIVO, MEDIA, LUMINANCIA };
static const int BRILLO_MAXIMO = 40; // décimas
static const Imagen COLORES_PUROS = {
    6, 1, {255, 0, 0, 255, 255, 0, 0, 255, 0, 0, 255, 255, 0, 0, 255, 255, 0, 255}};

static struct {
    GLuint programa;
    Muestra muestra;
    int elegido = 0, decimas = 16; // alfa = 1.6, como en la figura 9.2
    bool conColores = false;
} estado;

static std::string nombre(int efecto) {
    const std::string alfa = std::to_string(estado.decimas / 10) + "." + std::to_string(estado.decimas % 10);
    return EFECTOS[efecto] + (efecto == BRILLO ? " ×" + alfa : "");
}

static void dibujaEfecto(int efecto, const Recuadro &donde) {
    abreRecuadro(donde);
    envia(estado.programa, "elegido", efecto);
    dibujaRectangulo();
    rotulaImagen(estado.muestra, nombre(efecto));
}

static void dibuja() {
    abreRecuadro(ventanaEntera());
    ponFondo(FONDO_OSCURO);
    glClear(GL_COLOR_BUFFER_BIT);
    glUseProgram(estado.programa);
    envia(estado.programa, "imagen", estado.conColores ? 1 : 0); // la unidad de cada textura
    envia(estado.programa, "alfa", float(estado.decimas) / 10);
    std::string titulo = estado.muestra.compara ? "los cuatro" : nombre(estado.elegido);
    if (estado.conColores) {
        titulo = "media y luminancia de seis colores puros";
        const std::vector<Recuadro> franjas = rejilla(1, 3);
        dibujaEfecto(ORIGINAL, franjas[0]);
        dibujaEfecto(MEDIA, franjas[1]);
        dibujaEfecto(LUMINANCIA, franjas[2]);
    } else {
        int efecto = estado.muestra.compara ? ORIGINAL : estado.elegido;
        for (const Recuadro &panel : recuadros(estado.muestra, 4))
            dibujaEfecto(efecto++, panel);
    }
    ponTitulo("Efectos de imagen: " + titulo);
    glutSwapBuffers();
}

static void elige(int efecto) {
    estado.elegido = efecto;
    estado.muestra.compara = estado.conColores = false;
    glutPostRedisplay();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaMuestra(estado.muestra, tecla)) {
        estado.conColores = estado.conColores && !estado.muestra.compara;
        return;
    }
    if (int efecto; eligeModo(efecto, 5, tecla))
        return elige(efecto);
    switch (tecla) {
    case '+': estado.decimas = std::min(estado.decimas + 1, BRILLO_MAXIMO); break;
    case '-': estado.decimas = std::max(estado.decimas - 1, 0); break;
    case 'c': estado.muestra.compara = false; break;
    default: return;
    }
    estado.conColores = tecla == 'c' && !estado.conColores;
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    const std::vector<Imagen> imagenes = abreVentanaConImagenes(
        argc, argv, "Efectos de imagen", {{"assets/foto_grande.rgb", 1000, 760}}, estado.muestra);
    estado.programa = creaPrograma("ch09_imagen/imagen.vert", "ch09_imagen/efectos.frag");
    creaTexturaReducible(imagenes[0]);
    glActiveTexture(GL_TEXTURE1);
    creaTexturaExacta(COLORES_PUROS);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    glutCreateMenu(elige);
    for (int efecto = 0; efecto < int(std::size(EFECTOS)); ++efecto)
        glutAddMenuEntry(EFECTOS[efecto], efecto);
    glutAttachMenu(GLUT_RIGHT_BUTTON);
    glutMainLoop();
    return 0;
}
