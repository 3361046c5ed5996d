// Mezcla lineal de dos imágenes (listado 9.2, figura 9.3): A·(1 − alfa) + B·alfa en cada píxel, con cada imagen en su
// unidad de textura. Si no miden lo mismo, B se estira al tamaño de A. Dos caras mezcladas se ven las dos: para que una
// se convierta en la otra hay que mover además sus rasgos (morphing).
// Controles: 1 A · 2 alfa 0.33 · 3 alfa 0.66 · 4 B · + - alfa · v con A y B al lado · r rótulos · Esc termina.
#include "imagen_en_ventana.h"
#include <cstdio>

static const int CENTESIMAS[4] = {0, 33, 66, 100};

static struct {
    GLuint programa;
    glm::ivec2 talla;
    int centesimas = CENTESIMAS[1];
    bool compara = false, rotulos;
} estado;

static void dibujaMezcla(int centesimas, const Recuadro &panel, const std::string &rotulo) {
    dibujaEn(encaja(estado.talla, panel));
    envia(estado.programa, "alfa", float(centesimas) / 100);
    dibujaRectangulo();
    if (estado.rotulos)
        rotulaImagen(rotulo);
}

static void dibuja() {
    abreRecuadro(ventanaEntera(), FONDO_OSCURO);
    glUseProgram(estado.programa);
    envia(estado.programa, "imagenA", 0);
    envia(estado.programa, "imagenB", 1);
    char alfa[32];
    std::snprintf(alfa, sizeof alfa, "alfa = %d.%02d", estado.centesimas / 100, estado.centesimas % 100);
    if (estado.compara) {
        const std::vector<Recuadro> paneles = panelesPara(3, estado.talla);
        dibujaMezcla(0, paneles[0], "A");
        dibujaMezcla(estado.centesimas, paneles[1], alfa);
        dibujaMezcla(100, paneles[2], "B");
    } else {
        dibujaMezcla(estado.centesimas, ventanaEntera(), alfa);
    }
    ponTitulo(std::string("Mezcla de dos imágenes: ") + alfa);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    switch (tecla) {
    case '1':
    case '2':
    case '3':
    case '4': estado.centesimas = CENTESIMAS[tecla - '1']; break;
    case '+': estado.centesimas = std::min(estado.centesimas + 1, 100); break;
    case '-': estado.centesimas = std::max(estado.centesimas - 1, 0); break;
    case 'v': estado.compara = !estado.compara; break;
    case 'r': estado.rotulos = !estado.rotulos; break;
    default: return;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    const auto [imagenes, propias] = abreVentanaConImagenes(
        argc, argv, "Mezcla de dos imágenes", {{"assets/cara.rgb", 320, 240}, {"assets/gato.rgb", 320, 240}});
    estado.programa = creaPrograma("ch09_imagen/imagen.vert", "ch09_imagen/mezcla.frag");
    estado.talla = tallaDe(imagenes[0]);
    estado.rotulos = !propias;
    for (int unidad = 0; unidad < 2; ++unidad) {
        glActiveTexture(GL_TEXTURE0 + unidad);
        creaTexturaExacta(imagenes[unidad]);
    }
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    glutMainLoop();
    return 0;
}
