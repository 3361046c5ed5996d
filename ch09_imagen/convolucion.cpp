// Convolución con los filtros 3×3 de la tabla 9.1 (listado 9.3, ecuación 9.1): la aplicación calcula una vez los
// desplazamientos, divide el filtro por su suma y se lo manda todo al fragment shader. Se aparta del libro en que el
// paso de un texel al siguiente es 1/ancho y no 1/(ancho − 1), en que no filtra la opacidad y en que del filtro de
// bordes, que suma 0 y da números pequeños, se ve el valor absoluto, multiplicado, o su signo alrededor del gris. Lo de
// fuera lo dicen los parámetros de la textura (§6.2.2): su borde o la imagen repetida; reflejada, con un texel fuera,
// es su borde otra vez. El cero lo pone el shader: WebGL 2 no tiene GL_CLAMP_TO_BORDER.
// Controles: 1 suavizado · 2 nitidez · 3 bordes · s bordes con signo o en valor absoluto · + - ganancia de los bordes ·
// b lo de fuera es su borde, la imagen repetida o cero · v los compara · r rótulos · Esc termina.
#include "colores.h"
#include "imagen.h"
#include "imagen_en_ventana.h"
#include "modos.h"
#include "recuadro.h"
#include "shader.h"
#include "ventana.h"

static const int TALLA = 9;
static const struct {
    const char *nombre;
    float valores[TALLA], divisor;
} FILTROS[3] = {{"Suavizado", {1, 1, 1, 1, 1, 1, 1, 1, 1}, 9},
                {"Nitidez", {0, -1, 0, -1, 5, -1, 0, -1, 0}, 1},
                {"Bordes", {0, 1, 0, 1, -4, 1, 0, 1, 0}, 1}};
static const int BORDES = 2, GANANCIA_MAXIMA = 9;
static const struct {
    const char *nombre;
    GLint repeticion;
} FUERA[3] = {{"", GL_CLAMP_TO_EDGE}, {", repetida fuera", GL_REPEAT}, {", ceros fuera", GL_CLAMP_TO_EDGE}};
static const int CERO = 2;

static struct {
    GLuint programa, programaCopia;
    Muestra muestra;
    int elegido = 0, fuera = 0, ganancia = 4;
    bool conSigno = false;
} estado;

static std::string nombre(int elegido) {
    const std::string ganancia = " ×" + std::to_string(estado.ganancia);
    const std::string bordes = (estado.conSigno ? " con signo" : " absolutos") + ganancia;
    return FILTROS[elegido].nombre + (elegido == BORDES ? bordes : "") + FUERA[estado.fuera].nombre;
}

static void convoluciona(int elegido) {
    const auto &[nombre, valores, divisor] = FILTROS[elegido];
    glm::vec2 desplazamiento[TALLA];
    float filtro[TALLA];
    for (int i = 0; i < TALLA; ++i) {
        desplazamiento[i] = glm::vec2(i % 3 - 1, i / 3 - 1) / glm::vec2(estado.muestra.talla);
        filtro[i] = valores[i] / divisor;
    }
    glUseProgram(estado.programa);
    glUniform2fv(uniforme(estado.programa, "desplazamiento"), TALLA, &desplazamiento[0].x);
    glUniform1fv(uniforme(estado.programa, "filtro"), TALLA, filtro);
    envia(estado.programa, "imagen", 0);
    envia(estado.programa, "sumaCero", elegido == BORDES);
    envia(estado.programa, "conSigno", estado.conSigno);
    envia(estado.programa, "ganancia", float(estado.ganancia));
    envia(estado.programa, "ceroFuera", estado.fuera == CERO);
    dibujaRectangulo();
    rotulaImagen(estado.muestra, ::nombre(elegido));
}

static void dibuja() {
    for (const GLenum sentido : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glTexParameteri(GL_TEXTURE_2D, sentido, FUERA[estado.fuera].repeticion);
    abreRecuadro(ventanaEntera());
    ponFondo(FONDO_OSCURO);
    glClear(GL_COLOR_BUFFER_BIT);
    const std::vector<Recuadro> paneles = recuadros(estado.muestra, 4);
    if (estado.muestra.compara) {
        abreRecuadro(paneles[0]);
        glUseProgram(estado.programaCopia);
        envia(estado.programaCopia, "imagen", 0);
        dibujaRectangulo();
        rotulaImagen(estado.muestra, "Original");
        for (int elegido = 0; elegido < 3; ++elegido) {
            abreRecuadro(paneles[elegido + 1]);
            convoluciona(elegido);
        }
    } else {
        abreRecuadro(paneles[0]);
        convoluciona(estado.elegido);
    }
    ponTitulo("Convolución 3×3: " + (estado.muestra.compara
                                         ? std::string("los tres filtros") + FUERA[estado.fuera].nombre
                                         : nombre(estado.elegido)));
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaMuestra(estado.muestra, tecla))
        return;
    if (eligeModo(estado.elegido, 3, tecla)) {
        estado.muestra.compara = false;
        return;
    }
    switch (tecla) {
    case 's': estado.conSigno = !estado.conSigno; break;
    case '+': estado.ganancia = std::min(estado.ganancia + 1, GANANCIA_MAXIMA); break;
    case '-': estado.ganancia = std::max(estado.ganancia - 1, 1); break;
    case 'b': estado.fuera = (estado.fuera + 1) % 3; break;
    default: return;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    const std::vector<Imagen> imagenes = abreVentanaConImagenes(
        argc, argv, "Convolución 3×3", {{"assets/foto.rgb", 250, 190}}, estado.muestra);
    estado.programa = creaPrograma("ch09_imagen/imagen.vert", "ch09_imagen/convolucion.frag");
    estado.programaCopia = creaPrograma("ch09_imagen/imagen.vert", "ch09_imagen/imagen.frag");
    creaTexturaExacta(imagenes[0]);
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    glutMainLoop();
    return 0;
}
