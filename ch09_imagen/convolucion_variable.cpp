// Filtros de tamaño variable, hasta 31×31 (ejercicio 9.2): el filtro es una textura de números y el shader pregunta su
// tamaño (filtro.glsl). Uno separable se puede hacer de una vez, con talla² texeles por píxel, o en dos pasadas, fila y
// columna, con 2·talla (convolucion_separable.frag), por un framebuffer intermedio; se elige lo más rápido: dos
// pasadas, si se puede. El intermedio guarda float: con 8 bits redondea dos veces y un filtro con negativos los pierde.
// Se filtra a la resolución de la imagen.
// Controles: 1 caja · 2 gaussiana · 3 disco · 4 derivada · + - talla · s automático, directo o separable ·
// p intermedio de float o de 8 bits · a derivada con signo o absoluta · v compara con el original · r rótulos · Esc
// termina.
#include "colores.h"
#include "imagen.h"
#include "imagen_en_ventana.h"
#include "modos.h"
#include "nucleos.h"
#include "recuadro.h"
#include "shader.h"
#include "texto.h"
#include "ventana.h"

// Medido con llvmpipe en una imagen de 1024×1024: con 2 y con 3 las dos pasadas tardan la mitad que la directa, con 9
// la octava parte y con 31, ni la vigésima.
static const int TALLA_SEPARABLE = 2;
static const char *const NOMBRES[FAMILIAS] = {"Caja", "Gaussiana", "Disco", "Derivada"};
static const char *const MODOS[3] = {"automático", "directo", "separable"};

static struct {
    GLuint directo, separable, copia, imagen, filtro;
    Lienzo intermedio[2], resultado; // el intermedio, en float y en 8 bits
    Muestra muestra;
    int familia = CAJA;
    int tallaFiltro = 9, modo = 0;
    bool en8Bits = false, conSigno = true;
} estado;

static void inicia(const Imagen &imagen) {
    estado.directo = creaPrograma("ch09_imagen/imagen.vert", "ch09_imagen/convolucion_variable.frag");
    estado.separable = creaPrograma("ch09_imagen/imagen.vert", "ch09_imagen/convolucion_separable.frag");
    estado.copia = creaPrograma("ch09_imagen/imagen.vert", "ch09_imagen/imagen.frag");
    estado.imagen = creaTexturaExacta(imagen);
    estado.intermedio[0] = creaLienzo(estado.muestra.talla, GL_RGBA32F);
    estado.intermedio[1] = creaLienzo(estado.muestra.talla);
    estado.resultado = creaLienzo(estado.muestra.talla);
    glGenTextures(1, &estado.filtro);
}

// Enlaza la textura, que se verá con ese filtro.
static void enlaza(GLuint textura, GLint filtro) {
    glBindTexture(GL_TEXTURE_2D, textura);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filtro);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filtro);
}

// Con el programa en uso, de la textura al framebuffer, los dos del tamaño de la imagen.
static void filtra(GLuint programa, GLuint textura, GLuint framebuffer, bool sumaCero) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    abreRecuadro({0, 0, estado.muestra.talla.x, estado.muestra.talla.y});
    enlaza(textura, GL_NEAREST); // en el centro de un texel interpolar da lo mismo, y cuesta el cuádruple
    envia(programa, "imagen", 0);
    envia(programa, "sumaCero", sumaCero);
    envia(programa, "conSigno", estado.conSigno);
    dibujaRectangulo();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

static void filtraDirecto(const Filtro &f, bool sumaCero) {
    glActiveTexture(GL_TEXTURE1);
    enlaza(estado.filtro, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, f.talla, f.talla, 0, GL_RED, GL_FLOAT, f.valores.data());
    glActiveTexture(GL_TEXTURE0);
    glUseProgram(estado.directo);
    envia(estado.directo, "filtro", 1);
    filtra(estado.directo, estado.imagen, estado.resultado.framebuffer, sumaCero);
}

static void filtraSeparable(const Filtro &f, bool sumaCero) {
    const Lienzo &intermedio = estado.intermedio[estado.en8Bits];
    const auto pasada = [&](GLuint textura, GLuint framebuffer, const std::vector<float> &valores,
                            const glm::vec2 &eje, bool conSuma) {
        glUniform1fv(uniforme(estado.separable, "filtro"), f.talla, valores.data());
        envia(estado.separable, "eje", eje);
        filtra(estado.separable, textura, framebuffer, conSuma);
    };
    glUseProgram(estado.separable);
    envia(estado.separable, "talla", f.talla);
    pasada(estado.imagen, intermedio.framebuffer, f.fila, {1, 0}, false);
    pasada(intermedio.textura, estado.resultado.framebuffer, f.columna, {0, 1}, sumaCero);
}

static bool enDosPasadas(const Filtro &f) {
    return f.esSeparable() && (estado.modo == 2 || (estado.modo == 0 && f.talla >= TALLA_SEPARABLE));
}

static void dibujaTextura(GLuint textura, const Recuadro &panel, const std::string &rotulo) {
    abreRecuadro(panel);
    glUseProgram(estado.copia);
    enlaza(textura, GL_LINEAR);
    envia(estado.copia, "imagen", 0);
    dibujaRectangulo();
    rotulaImagen(estado.muestra, rotulo);
}

static void dibuja() {
    const Filtro f = creaFiltro(Familia(estado.familia), estado.tallaFiltro);
    const bool dosPasadas = enDosPasadas(f), sumaCero = estado.familia == DERIVADA;
    if (dosPasadas)
        filtraSeparable(f, sumaCero);
    else
        filtraDirecto(f, sumaCero);

    abreRecuadro(ventanaEntera());
    ponFondo(FONDO_OSCURO);
    glClear(GL_COLOR_BUFFER_BIT);
    const char *const signo = estado.conSigno ? " con signo " : " absoluta ";
    const char *const separable = estado.en8Bits ? "separable, 8 bits" : "separable, float";
    const std::string como = dosPasadas ? separable : "directo";
    const std::string nombre =
        NOMBRES[estado.familia] + std::string(sumaCero ? signo : " ") + formatea("%d×%d", f.talla, f.talla);
    const std::vector<Recuadro> paneles = recuadros(estado.muestra, 2);
    if (estado.muestra.compara) {
        dibujaTextura(estado.imagen, paneles[0], "Original");
        dibujaTextura(estado.resultado.textura, paneles[1], nombre);
    } else {
        dibujaTextura(estado.resultado.textura, paneles[0], nombre + "\n" + como);
    }
    ponTitulo(nombre + ", " + como + " (" + MODOS[estado.modo] + ")");
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaMuestra(estado.muestra, tecla) || eligeModo(estado.familia, 4, tecla))
        return;
    switch (tecla) {
    case '+': estado.tallaFiltro = std::min(estado.tallaFiltro + 1, TALLA_MAXIMA); break;
    case '-': estado.tallaFiltro = std::max(estado.tallaFiltro - 1, 1); break;
    case 's': estado.modo = (estado.modo + 1) % 3; break;
    case 'p': estado.en8Bits = !estado.en8Bits; break;
    case 'a': estado.conSigno = !estado.conSigno; break;
    default: return;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    const std::vector<Imagen> imagenes = abreVentanaConImagenes(
        argc, argv, "Filtros de tamaño variable", {{"assets/foto.rgb", 250, 190}}, estado.muestra);
    inicia(imagenes[0]);
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    glutMainLoop();
    return 0;
}
