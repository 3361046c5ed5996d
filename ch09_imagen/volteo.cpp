// Volteo horizontal y vertical (ejercicio 9.4): el vertex shader cambia el signo de x o de y a los vértices del
// rectángulo y la textura va con ellos. Los dos a la vez son un giro de media vuelta.
// Controles: x horizontal · y vertical · v los cuatro a la vez · r rótulos · Esc termina.
#include "colores.h"
#include "imagen.h"
#include "imagen_en_ventana.h"
#include "recuadro.h"
#include "shader.h"
#include "ventana.h"

static const char *const NOMBRES[4] = {"Original", "Horizontal", "Vertical", "Los dos"};
static const int EN_PANEL[4] = {0, 3, 1,
                                2}; // ninguno sigue donde acaba el de al lado: no parecen una sola imagen

static struct {
    GLuint programa;
    Muestra muestra;
    bool horizontal = false, vertical = false;
} estado;

static void dibujaVolteo(bool horizontal, bool vertical, const Recuadro &panel) {
    abreRecuadro(panel);
    // E9.4: envía sentido
    envia(estado.programa, "sentido", glm::vec2(horizontal ? -1 : 1, vertical ? -1 : 1));
    // fin de E9.4
    dibujaRectangulo();
    rotulaImagen(estado.muestra, NOMBRES[horizontal + 2 * vertical]);
}

static void dibuja() {
    abreRecuadro(ventanaEntera());
    ponFondo(FONDO_OSCURO);
    glClear(GL_COLOR_BUFFER_BIT);
    glUseProgram(estado.programa);
    envia(estado.programa, "imagen", 0);
    const std::vector<Recuadro> paneles = recuadros(estado.muestra, 4);
    if (estado.muestra.compara) {
        for (std::size_t k = 0; k < 4; ++k)
            dibujaVolteo(EN_PANEL[k] % 2 == 1, EN_PANEL[k] >= 2, paneles[k]);
    } else {
        dibujaVolteo(estado.horizontal, estado.vertical, paneles[0]);
    }
    ponTitulo(std::string("Volteo: ") +
              (estado.muestra.compara ? "los cuatro" : NOMBRES[estado.horizontal + 2 * estado.vertical]));
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaMuestra(estado.muestra, tecla))
        return;
    switch (tecla) {
    case 'x': estado.horizontal = !estado.horizontal; break;
    case 'y': estado.vertical = !estado.vertical; break;
    default: return;
    }
    estado.muestra.compara = false;
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    const std::vector<Imagen> imagenes =
        abreVentanaConImagenes(argc, argv, "Volteo", {{"assets/foto_grande.rgb", 1000, 760}}, estado.muestra);
    estado.programa = creaPrograma("ch09_imagen/volteo.vert", "ch09_imagen/imagen.frag");
    creaTexturaReducible(imagenes[0]);
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    glutMainLoop();
    return 0;
}
