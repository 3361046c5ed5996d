// Mezcla lineal de dos imágenes (listado 9.2, figura 9.3): A·(1 − alfa) + B·alfa en cada píxel, con cada imagen en su
// unidad de textura. Si no miden lo mismo, B se estira al tamaño de A. Dos caras mezcladas se ven las dos: para que una
// se convierta en la otra hay que mover además sus rasgos (morphing).
// Controles: 1 A · 2 alfa 0.33 · 3 alfa 0.66 · 4 B · + - alfa · v los cuatro a la vez · r rótulos · Esc termina.
#include "imagen_en_ventana.h"
#include <cstdio>

static const int CENTESIMAS[4] = {0, 33, 66, 100};

static struct {
    GLuint programa;
    glm::ivec2 talla;
    int centesimas = CENTESIMAS[1];
    bool compara = false, rotulos;
} estado;

static std::string nombre(int centesimas) {
    char alfa[32];
    std::snprintf(alfa, sizeof alfa, "alfa = %d.%02d", centesimas / 100, centesimas % 100);
    return alfa;
}

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
    if (estado.compara) {
        const std::vector<Recuadro> paneles = panelesPara(4, estado.talla);
        const std::string rotulos[4] = {"A", nombre(CENTESIMAS[1]), nombre(CENTESIMAS[2]), "B"};
        for (std::size_t k = 0; k < 4; ++k)
            dibujaMezcla(CENTESIMAS[k], paneles[k], rotulos[k]);
    } else {
        dibujaMezcla(estado.centesimas, ventanaEntera(), nombre(estado.centesimas));
    }
    ponTitulo("Mezcla de dos imágenes: " + (estado.compara ? "de A a B" : nombre(estado.centesimas)));
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
    if (tecla != 'v' && tecla != 'r')
        estado.compara = false;
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    const auto [imagenes, propias] = abreVentanaConImagenes(
        argc, argv, "Mezcla de dos imágenes", {{"assets/cara.rgb", 960, 720}, {"assets/gato.rgb", 960, 720}});
    estado.programa = creaPrograma("ch09_imagen/imagen.vert", "ch09_imagen/mezcla.frag");
    estado.talla = tallaDe(imagenes[0]);
    estado.rotulos = !propias;
    for (int unidad = 0; unidad < 2; ++unidad) {
        glActiveTexture(GL_TEXTURE0 + unidad);
        creaTexturaReducible(imagenes[unidad]);
    }
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    glutMainLoop();
    return 0;
}
