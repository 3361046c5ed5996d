// Convolución con los filtros 3×3 de la tabla 9.1 (listado 9.3, ecuación 9.1): la aplicación calcula una vez los
// desplazamientos, divide el filtro por su suma y se lo manda todo al fragment shader. Se aparta del libro en que el
// paso de un texel al siguiente es 1/ancho y no 1/(ancho − 1), en que no filtra la opacidad y en que el filtro de
// bordes, que suma 0, enseña su signo alrededor del gris. Lo de fuera de la imagen es su borde (GL_CLAMP_TO_EDGE).
// Controles: 1 suavizado · 2 nitidez · 3 bordes · s bordes con signo o en valor absoluto · v los compara · r rótulos ·
// Esc termina.
#include "imagen_en_ventana.h"

static const int TALLA = 9;
static const struct {
    const char *nombre;
    float valores[TALLA], divisor;
} FILTROS[3] = {{"Suavizado", {1, 1, 1, 1, 1, 1, 1, 1, 1}, 9},
                {"Nitidez", {0, -1, 0, -1, 5, -1, 0, -1, 0}, 1},
                {"Bordes", {0, 1, 0, 1, -4, 1, 0, 1, 0}, 1}};
static const int BORDES = 2;

static struct {
    GLuint programa, programaCopia;
    glm::ivec2 talla;
    int elegido = 0;
    bool conSigno = true, compara = false, rotulos;
} estado;

static std::string nombre(int elegido) {
    return FILTROS[elegido].nombre + std::string(elegido != BORDES ? ""
                                                 : estado.conSigno ? " con signo"
                                                                   : " en valor absoluto");
}

static void convoluciona(int elegido) {
    const auto &[nombre, valores, divisor] = FILTROS[elegido];
    glm::vec2 desplazamiento[TALLA];
    float filtro[TALLA];
    for (int i = 0; i < TALLA; ++i) {
        desplazamiento[i] = glm::vec2(i % 3 - 1, i / 3 - 1) / glm::vec2(estado.talla);
        filtro[i] = valores[i] / divisor;
    }
    glUseProgram(estado.programa);
    glUniform2fv(uniforme(estado.programa, "desplazamiento"), TALLA, &desplazamiento[0].x);
    glUniform1fv(uniforme(estado.programa, "filtro"), TALLA, filtro);
    envia(estado.programa, "imagen", 0);
    envia(estado.programa, "sumaCero", elegido == BORDES);
    envia(estado.programa, "conSigno", estado.conSigno);
    dibujaRectangulo();
    if (estado.rotulos)
        rotulaImagen(::nombre(elegido));
}

static void dibuja() {
    abreRecuadro(ventanaEntera(), FONDO_OSCURO);
    if (estado.compara) {
        const std::vector<Recuadro> paneles = panelesPara(4, estado.talla);
        dibujaEn(encaja(estado.talla, paneles[0]));
        glUseProgram(estado.programaCopia);
        envia(estado.programaCopia, "imagen", 0);
        dibujaRectangulo();
        if (estado.rotulos)
            rotulaImagen("Original");
        for (int elegido = 0; elegido < 3; ++elegido) {
            dibujaEn(encaja(estado.talla, paneles[elegido + 1]));
            convoluciona(elegido);
        }
    } else {
        dibujaEn(encaja(estado.talla, ventanaEntera()));
        convoluciona(estado.elegido);
    }
    ponTitulo("Convolución 3×3: " + (estado.compara ? "los tres filtros" : nombre(estado.elegido)));
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    switch (tecla) {
    case '1':
    case '2':
    case '3':
        estado.elegido = tecla - '1';
        estado.compara = false;
        break;
    case 's': estado.conSigno = !estado.conSigno; break;
    case 'v': estado.compara = !estado.compara; break;
    case 'r': estado.rotulos = !estado.rotulos; break;
    default: return;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    const auto [imagenes, propias] =
        abreVentanaConImagenes(argc, argv, "Convolución 3×3", {{"assets/foto.rgb", 250, 190}});
    estado.programa = creaPrograma("ch09_imagen/imagen.vert", "ch09_imagen/convolucion.frag");
    estado.programaCopia = creaPrograma("ch09_imagen/imagen.vert", "ch09_imagen/imagen.frag");
    estado.talla = tallaDe(imagenes[0]);
    estado.rotulos = !propias;
    creaTexturaExacta(imagenes[0]);
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    glutMainLoop();
    return 0;
}
