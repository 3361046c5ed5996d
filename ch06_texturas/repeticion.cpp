// Qué pasa fuera de [0, 1] (§6.2.2, figura 6.2): la textura se repite en s, en t o en ambas, o se queda con el color
// del borde. El marco es el cuadrado en que s y t van de 0 a 1. El libro fija el borde con GL_CLAMP, que OpenGL 3.1
// ya no tiene (mezclaba el último texel con un color de borde): aquí es GL_CLAMP_TO_EDGE.
// Controles: 1 repite en s · 2 repite en t · 3 repite en ambas · 4 fija el borde · Esc termina.
#include "colores.h"
#include "imagen.h"
#include "modos.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "textura.h"
#include "trazo.h"
#include "ventana.h"

// De (s, t) = (0.5, 0.5) al borde de abajo de la ventana. En una de 180 líneas la textura mide 64 píxeles justos y el
// centro de cada píxel cae en el de un texel de su mipmap: nada depende de cómo redondee el filtro.
static const float SEMIALTO = 1.40625f;
static const struct {
    const char *nombre;
    GLint enS, enT;
} MODOS[4] = {{"GL_REPEAT en s, GL_CLAMP_TO_EDGE en t", GL_REPEAT, GL_CLAMP_TO_EDGE},
              {"GL_CLAMP_TO_EDGE en s, GL_REPEAT en t", GL_CLAMP_TO_EDGE, GL_REPEAT},
              {"GL_REPEAT en s y en t", GL_REPEAT, GL_REPEAT},
              {"GL_CLAMP_TO_EDGE en s y en t", GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE}};

static struct {
    GLuint programa, textura, vao;
    int elegido = 2;
} estado;

static void dibuja() {
    const auto &modo = MODOS[estado.elegido];
    const glm::mat4 proyeccion = paralelaVentana(SEMIALTO);
    glClear(GL_COLOR_BUFFER_BIT);
    glUseProgram(estado.programa);
    envia(estado.programa, "proyeccion", proyeccion);
    envia(estado.programa, "Img", 0);
    glBindTexture(GL_TEXTURE_2D, estado.textura);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, modo.enS);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, modo.enT);
    glBindVertexArray(estado.vao);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);

    // el marco y sus ejes; el centro de la ventana es (s, t) = (0.5, 0.5)
    trazaPolilinea({{-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0.5f, 0.5f, 0}, {-0.5f, 0.5f, 0}}, proyeccion,
                   OSCURO, 8, true);
    const auto rotulaEn = [&](const char *texto, float x, float y, float semiancho) { // en blanco, que se lea
        const glm::vec3 c(x, y, 0), dx(semiancho, 0, 0), dy(0, 0.09f, 0);
        trazaPoligono({c - dx - dy, c + dx - dy, c + dx + dy, c - dx + dy}, proyeccion, BLANCO);
        rotulaPunto(texto, c, proyeccion, OSCURO, Lado::CENTRO);
    };
    rotulaEn("0", -0.61f, -0.61f, 0.07f);
    rotulaEn("s=1", 0.5f, -0.62f, 0.17f);
    rotulaEn("t=1", -0.71f, 0.5f, 0.17f);

    const int ancho = glutGet(GLUT_WINDOW_WIDTH), alto = glutGet(GLUT_WINDOW_HEIGHT);
    const int franja = alto / 9;
    glScissor(0, alto - franja, ancho, franja); // arriba, lisa, para el rótulo
    glEnable(GL_SCISSOR_TEST);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
    rotula(modo.nombre, {0.5f, 1 - 0.5f / 9}, OSCURO);
    ponTitulo(modo.nombre);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (!teclaComun(tecla))
        eligeModo(estado.elegido, 4, tecla);
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Repetición", GLUT_DOUBLE | GLUT_MULTISAMPLE,
                "[FOTO.ppm | FOTO.rgb -talla ANCHOxALTO]");
    estado.programa = creaPrograma("ch06_texturas/repeticion.vert", "ch06_texturas/textura.frag");
    estado.textura = creaTextura2D(imagenDeArgumentos(argc, argv, "assets/carta.rgb", 256, 256));
    glGenVertexArrays(1, &estado.vao);
    ponFondo(BLANCO);
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    glutMainLoop();
    return 0;
}
