// Diferencia de dos imágenes (ejercicio 9.1): |A − B| en cada componente, negro donde son iguales; o con signo, A − B a
// la mitad alrededor del gris 128. Las dos tienen que medir lo mismo: si no, no hay píxeles que restar.
// Controles: s con signo · v con A y B al lado, las dos maneras · r rótulos · Esc termina.
#include "colores.h"
#include "error.h"
#include "imagen.h"
#include "imagen_en_ventana.h"
#include "recuadro.h"
#include "shader.h"
#include "ventana.h"

static struct {
    GLuint programa, programaCopia;
    Muestra muestra;
    bool conSigno = false;
} estado;

static void dibujaImagen(int unidad, const Recuadro &panel) {
    abreRecuadro(panel);
    glUseProgram(estado.programaCopia);
    envia(estado.programaCopia, "imagen", unidad);
    dibujaRectangulo();
    rotulaImagen(estado.muestra, unidad == 0 ? "A" : "B");
}

static void dibujaDiferencia(bool conSigno, const Recuadro &panel) {
    abreRecuadro(panel);
    glUseProgram(estado.programa);
    envia(estado.programa, "imagenA", 0);
    envia(estado.programa, "imagenB", 1);
    envia(estado.programa, "conSigno", conSigno);
    dibujaRectangulo();
    rotulaImagen(estado.muestra, conSigno ? "(A − B)/2 + 0.5" : "|A − B|");
}

static void dibuja() {
    abreRecuadro(ventanaEntera());
    ponFondo(FONDO_OSCURO);
    glClear(GL_COLOR_BUFFER_BIT);
    const std::vector<Recuadro> paneles = recuadros(estado.muestra, 4);
    if (estado.muestra.compara) {
        dibujaImagen(0, paneles[0]);
        dibujaImagen(1, paneles[1]);
        dibujaDiferencia(false, paneles[2]);
        dibujaDiferencia(true, paneles[3]);
    } else {
        dibujaDiferencia(estado.conSigno, paneles[0]);
    }
    const char *conUnSigno = estado.conSigno ? ", con signo" : "";
    ponTitulo(std::string("Diferencia de dos imágenes") +
              (estado.muestra.compara ? ", sin signo y con él" : conUnSigno));
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaMuestra(estado.muestra, tecla) || tecla != 's')
        return;
    estado.conSigno = !estado.conSigno;
    estado.muestra.compara = false;
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    const std::vector<Imagen> imagenes = abreVentanaConImagenes(
        argc, argv, "Diferencia de dos imágenes",
        {{"assets/foto_grande.rgb", 1000, 760}, {"assets/foto_cambiada.rgb", 1000, 760}}, estado.muestra);
    if (tallaDe(imagenes[0]) != tallaDe(imagenes[1]))
        falla("las dos imágenes tienen que medir lo mismo");
    estado.programa = creaPrograma("ch09_imagen/imagen.vert", "ch09_imagen/diferencia.frag");
    estado.programaCopia = creaPrograma("ch09_imagen/imagen.vert", "ch09_imagen/imagen.frag");
    for (int unidad = 0; unidad < 2; ++unidad) {
        glActiveTexture(GL_TEXTURE0 + unidad);
        creaTexturaReducible(imagenes[unidad]);
    }
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    glutMainLoop();
    return 0;
}
