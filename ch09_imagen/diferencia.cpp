// Diferencia de dos imágenes (ejercicio 9.1): |A − B| en cada componente, negro donde son iguales; o con signo, A − B a
// la mitad alrededor del gris 128. Las dos tienen que medir lo mismo: si no, no hay píxeles que restar.
// Controles: s con signo · v con A y B al lado, las dos maneras · r rótulos · Esc termina.
#include "imagen_en_ventana.h"

static struct {
    GLuint programa, programaCopia;
    glm::ivec2 talla;
    bool conSigno = false, compara = false, rotulos;
} estado;

static void rotulaSiHaceFalta(const std::string &rotulo) {
    if (estado.rotulos)
        rotulaImagen(rotulo);
}

static void dibujaImagen(int unidad, const Recuadro &panel) {
    dibujaEn(encaja(estado.talla, panel));
    glUseProgram(estado.programaCopia);
    envia(estado.programaCopia, "imagen", unidad);
    dibujaRectangulo();
    rotulaSiHaceFalta(unidad == 0 ? "A" : "B");
}

static void dibujaDiferencia(bool conSigno, const Recuadro &panel) {
    dibujaEn(encaja(estado.talla, panel));
    glUseProgram(estado.programa);
    envia(estado.programa, "imagenA", 0);
    envia(estado.programa, "imagenB", 1);
    envia(estado.programa, "conSigno", conSigno);
    dibujaRectangulo();
    rotulaSiHaceFalta(conSigno ? "(A − B)/2" : "|A − B|");
}

static void dibuja() {
    abreRecuadro(ventanaEntera(), FONDO_OSCURO);
    if (estado.compara) {
        const std::vector<Recuadro> paneles = panelesPara(4, estado.talla);
        dibujaImagen(0, paneles[0]);
        dibujaImagen(1, paneles[1]);
        dibujaDiferencia(false, paneles[2]);
        dibujaDiferencia(true, paneles[3]);
    } else {
        dibujaDiferencia(estado.conSigno, ventanaEntera());
    }
    const char *conUnSigno = estado.conSigno ? ", con signo" : "";
    ponTitulo(std::string("Diferencia de dos imágenes") +
              (estado.compara ? ", sin signo y con él" : conUnSigno));
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    switch (tecla) {
    case 's':
        estado.conSigno = !estado.conSigno;
        estado.compara = false;
        break;
    case 'v': estado.compara = !estado.compara; break;
    case 'r': estado.rotulos = !estado.rotulos; break;
    default: return;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    const auto [imagenes, propias] = abreVentanaConImagenes(
        argc, argv, "Diferencia de dos imágenes",
        {{"assets/foto_grande.rgb", 1000, 760}, {"assets/foto_cambiada.rgb", 1000, 760}});
    if (tallaDe(imagenes[0]) != tallaDe(imagenes[1]))
        falla("las dos imágenes tienen que medir lo mismo");
    estado.programa = creaPrograma("ch09_imagen/imagen.vert", "ch09_imagen/diferencia.frag");
    estado.programaCopia = creaPrograma("ch09_imagen/imagen.vert", "ch09_imagen/imagen.frag");
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
