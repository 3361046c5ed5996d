// Mezcla lineal de dos imágenes (listado 9.2, figura 9.3): A·(1 − alfa) + B·alfa en cada píxel, con cada imagen en su
// unidad de textura. Si no miden lo mismo, B se estira al tamaño de A. Dos caras mezcladas se ven las dos: para que una
// se convierta en la otra hay que mover además sus rasgos (morphing).
// Controles: 1 A · 2 alfa 0.33 · 3 alfa 0.66 · 4 B · + - alfa · v los cuatro a la vez · r rótulos · Esc termina.
#include "colores.h"
#include "imagen.h"
#include "imagen_en_ventana.h"
#include "modos.h"
#include "recuadro.h"
#include "shader.h"
#include "texto.h"
#include "ventana.h"

static const int CENTESIMAS[4] = {0, 33, 66, 100};

static struct {
    GLuint programa;
    Muestra muestra;
    int centesimas = CENTESIMAS[1];
} estado;

static std::string nombre(int centesimas) {
    return formatea("alfa = %d.%02d", centesimas / 100, centesimas % 100);
}

static void dibujaMezcla(int centesimas, const Recuadro &panel, const std::string &rotulo) {
    abreRecuadro(panel);
    envia(estado.programa, "alfa", float(centesimas) / 100);
    dibujaRectangulo();
    rotulaImagen(estado.muestra, rotulo);
}

static void dibuja() {
    abreRecuadro(ventanaEntera());
    ponFondo(FONDO_OSCURO);
    glClear(GL_COLOR_BUFFER_BIT);
    glUseProgram(estado.programa);
    envia(estado.programa, "imagenA", 0);
    envia(estado.programa, "imagenB", 1);
    const std::vector<Recuadro> paneles = recuadros(estado.muestra, 4);
    if (estado.muestra.compara) {
        const std::string rotulos[4] = {"A", nombre(CENTESIMAS[1]), nombre(CENTESIMAS[2]), "B"};
        for (std::size_t k = 0; k < 4; ++k)
            dibujaMezcla(CENTESIMAS[k], paneles[k], rotulos[k]);
    } else {
        dibujaMezcla(estado.centesimas, paneles[0], nombre(estado.centesimas));
    }
    ponTitulo("Mezcla de dos imágenes: " + (estado.muestra.compara ? "de A a B" : nombre(estado.centesimas)));
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaMuestra(estado.muestra, tecla))
        return;
    if (int i; eligeModo(i, 4, tecla))
        estado.centesimas = CENTESIMAS[i];
    else if (tecla == '+')
        estado.centesimas = std::min(estado.centesimas + 1, 100);
    else if (tecla == '-')
        estado.centesimas = std::max(estado.centesimas - 1, 0);
    else
        return;
    estado.muestra.compara = false;
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    const std::vector<Imagen> imagenes = abreVentanaConImagenes(
        argc, argv, "Mezcla de dos imágenes", {{"assets/cara.rgb", 960, 720}, {"assets/gato.rgb", 960, 720}},
        estado.muestra);
    estado.programa = creaPrograma("ch09_imagen/imagen.vert", "ch09_imagen/mezcla.frag");
    for (int unidad = 0; unidad < 2; ++unidad) {
        glActiveTexture(GL_TEXTURE0 + unidad);
        creaTexturaReducible(imagenes[unidad]);
    }
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    glutMainLoop();
    return 0;
}
