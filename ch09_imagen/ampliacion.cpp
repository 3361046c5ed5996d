// Ampliar y reducir (§9.4): el vertex shader multiplica siempre el mismo rectángulo por el factor y por la proporción
// que evita deformar la imagen. Con ×1 cabe justa en la ventana. Al ampliar se interpola entre texeles o se toma el más
// cercano; al reducir hacen falta mipmaps: sin ellos se saltan texeles y sale otra imagen.
// Controles: + - factor · f filtro lineal o vecino · v sin la proporción y con ella · r rótulos · Esc termina.
#include "colores.h"
#include "imagen.h"
#include "imagen_en_ventana.h"
#include "proporcion.h"
#include "recuadro.h"
#include "shader.h"
#include "texto.h"
#include "textura.h"
#include "ventana.h"

static const int PASOS = 8; // hasta ×2⁴ y ×2⁻⁴: dos pasos duplican
static const float TENUE = 0.3f;

static struct {
    GLuint programa;
    Muestra muestra;
    int pasos = 0;
    bool vecino = false;
} estado;

static void dibujaAmpliada(const Recuadro &panel, bool conProporcion, const std::string &rotulo) {
    const float factor = std::exp2(float(estado.pasos) / 2);
    const Recuadro imagen = {0, 0, estado.muestra.talla.x, estado.muestra.talla.y};
    abreRecuadro(panel);
    ponFondo(FONDO_OSCURO);
    glClear(GL_COLOR_BUFFER_BIT);
    glUseProgram(estado.programa);
    envia(estado.programa, "imagen", 0);
    const glm::vec2 justa = conProporcion ? proporcion(aspecto(imagen), aspecto(panel)) : glm::vec2(1);
    if (factor < 1 && estado.muestra.rotulos) { // detrás y tenue, la de ×1
        glEnable(GL_BLEND);
        glBlendColor(0, 0, 0, TENUE);
        glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
        envia(estado.programa, "escala", justa);
        dibujaRectangulo();
        glDisable(GL_BLEND);
    }
    envia(estado.programa, "escala", factor * justa);
    dibujaRectangulo();
    rotulaImagen(estado.muestra, rotulo);
}

static void dibuja() {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, estado.vecino ? GL_NEAREST : GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                    estado.vecino ? GL_NEAREST : GL_LINEAR_MIPMAP_LINEAR);
    const std::string factor =
        formatea("×%.3g, %s", std::exp2(estado.pasos / 2.0), estado.vecino ? "vecino" : "lineal");
    abreRecuadro(ventanaEntera());
    ponFondo(GRIS);
    glClear(GL_COLOR_BUFFER_BIT);
    if (estado.muestra.compara) {
        const std::vector<Recuadro> paneles = rejilla(2, 1);
        dibujaAmpliada(paneles[0], false, "sin proporción");
        dibujaAmpliada(paneles[1], true, "con proporción");
    } else {
        dibujaAmpliada(ventanaEntera(), true, factor);
    }
    ponTitulo("Ampliación " + factor + (estado.muestra.compara ? ": sin proporción y con ella" : ""));
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaMuestra(estado.muestra, tecla))
        return;
    switch (tecla) {
    case '+': estado.pasos = std::min(estado.pasos + 1, PASOS); break;
    case '-': estado.pasos = std::max(estado.pasos - 1, -PASOS); break;
    case 'f': estado.vecino = !estado.vecino; break;
    default: return;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    const std::vector<Imagen> imagenes =
        abreVentanaConImagenes(argc, argv, "Ampliación", {{"assets/foto.rgb", 250, 190}}, estado.muestra);
    estado.programa = creaPrograma("ch09_imagen/ampliacion.vert", "ch09_imagen/imagen.frag");
    creaTextura2D(imagenes[0]);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    glutMainLoop();
    return 0;
}
