// Qué pasa fuera de [0, 1] (§6.2.2, figura 6.2): la textura se repite en s, en t o en ambas, o se queda con
// el color del borde. El marco es el cuadrado en que s y t van de 0 a 1. El libro fija el borde con GL_CLAMP,
// que OpenGL 3.1 ya no tiene (mezclaba el último texel con un color de borde): aquí es GL_CLAMP_TO_EDGE.
// Controles: 1 repite en s · 2 repite en t · 3 repite en ambas · 4 fija el borde · Esc termina.
#include "malla.h"
#include "shader.h"
#include "textura.h"
#include "ventana.h"
#include <algorithm>

// De (s, t) = (0.5, 0.5) al borde más cercano de la ventana. En una de 180 líneas la textura mide 64 píxeles
// justos y el centro de cada píxel cae en el de un texel de su mipmap: nada depende de cómo redondee el
// filtro.
static const float SEMILADO = 1.40625f;
static const float LARGO = 10; // lado del cuadrado, que llena cualquier ventana hasta 3.5 veces más larga
static const GLint repeticiones[4][2] = {{GL_REPEAT, GL_CLAMP_TO_EDGE},
                                         {GL_CLAMP_TO_EDGE, GL_REPEAT},
                                         {GL_REPEAT, GL_REPEAT},
                                         {GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE}};
static const Imagen texelOscuro = {1, 1, {41, 43, 51}};

static struct {
    GLuint programa, textura, texturaMarco;
    Buferes cuadrado, marco;
    int elegida = 2;
} estado;

static void inicia(const Imagen &imagen) {
    estado.programa = creaPrograma("ch06_texturas/textura.vert", "ch06_texturas/textura.frag");
    Malla malla = plano(1);
    for (Vertice &v : malla.vertices) {
        v.posicion *= LARGO;
        v.coordTextura = glm::vec2(v.posicion) + 0.5f; // de −4.5 a 5.5
    }
    estado.cuadrado = creaBuferes(malla);
    malla = plano(1);
    malla.indices = {0, 1, 3, 2}; // su contorno
    estado.marco = creaBuferes(malla);
    estado.texturaMarco = creaTextura2D(texelOscuro);
    estado.textura = creaTextura2D(imagen);
    glClearColor(0.95f, 0.96f, 0.98f, 1);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT);
    glUseProgram(estado.programa);
    const glm::mat4 matriz = paralelaVentana(SEMILADO);
    envia(estado.programa, "matriz", matriz);
    envia(estado.programa, "Img", 0);

    glBindTexture(GL_TEXTURE_2D, estado.textura);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, repeticiones[estado.elegida][0]);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, repeticiones[estado.elegida][1]);
    dibuja(estado.cuadrado);

    glBindTexture(GL_TEXTURE_2D, estado.texturaMarco);
    glBindVertexArray(estado.marco.vao);
    glLineWidth(static_cast<float>(std::max(glutGet(GLUT_WINDOW_HEIGHT) / 120, 2)));
    glDrawElements(GL_LINE_LOOP, estado.marco.nIndices, GL_UNSIGNED_INT, nullptr);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || tecla < '1' || tecla > '4')
        return;
    estado.elegida = tecla - '1';
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Repetición", GLUT_DOUBLE | GLUT_MULTISAMPLE,
                "[FOTO.ppm | FOTO.rgb -talla ANCHOxALTO]");
    inicia(imagenDeArgumentos(argc, argv, "assets/carta.rgb", 256, 256));
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    glutMainLoop();
    return 0;
}
