// Filtros de tamaño variable, hasta 31×31 (ejercicio 9.2): el filtro es una textura de números y el shader pregunta su tamaño
// (filtro.glsl). Uno separable se puede hacer de una vez, con talla² texels por píxel, o en dos pasadas, fila y columna, con
// 2·talla, por un framebuffer intermedio; se elige lo más rápido: dos pasadas desde TALLA_SEPARABLE. El intermedio guarda
// float: con 8 bits redondea dos veces y un filtro con negativos los pierde. Se filtra a la resolución de la imagen.
// Controles: 1 caja · 2 gaussiana · 3 disco · 4 derivada · + - talla · s automático, directo o separable ·
// p intermedio de float o de 8 bits · a derivada con signo o absoluta · v compara con el original · r rótulos · Esc termina.
#include "imagen_en_ventana.h"
#include "nucleos.h"

// Medido con llvmpipe en una imagen de 1024×1024: con 2 cuestan lo mismo, con 3 las dos pasadas tardan 0.8 veces lo que la
// directa, con 9 la cuarta parte y con 31 la décima.
static const int TALLA_SEPARABLE = 3;
static const char *const NOMBRES[FAMILIAS] = {"Caja", "Gaussiana", "Disco", "Derivada"};
static const char *const MODOS[3] = {"automático", "directo", "separable"};

static struct {
    GLuint programa, programaCopia, imagen, filtro;
    Lienzo intermedio[2], resultado; // el intermedio, en float y en 8 bits
    glm::ivec2 talla;
    Familia familia = CAJA;
    int tallaFiltro = 9, modo = 0;
    bool en8Bits = false, conSigno = true, compara = false, rotulos;
} estado;

static void inicia(const Imagen &imagen) {
    estado.programa = creaPrograma("ch09_imagen/imagen.vert", "ch09_imagen/convolucion_variable.frag");
    estado.programaCopia = creaPrograma("ch09_imagen/imagen.vert", "ch09_imagen/imagen.frag");
    estado.talla = tallaDe(imagen);
    estado.imagen = creaTexturaExacta(imagen);
    estado.intermedio[0] = creaLienzo(estado.talla, GL_RGBA32F);
    estado.intermedio[1] = creaLienzo(estado.talla);
    estado.resultado = creaLienzo(estado.talla);
    glGenTextures(1, &estado.filtro);
}

/// Una pasada con el filtro de m × n: de la textura al framebuffer, los dos del tamaño de la imagen.
static void filtra(GLuint textura, GLuint framebuffer, const std::vector<float> &valores, int m,
                   bool sumaCero) {
    const int n = static_cast<int>(valores.size()) / m;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    dibujaEn({0, 0, estado.talla.x, estado.talla.y});
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, estado.filtro);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, m, n, 0, GL_RED, GL_FLOAT, valores.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, textura);
    glUseProgram(estado.programa);
    envia(estado.programa, "imagen", 0);
    envia(estado.programa, "filtro", 1);
    envia(estado.programa, "sumaCero", sumaCero);
    envia(estado.programa, "conSigno", estado.conSigno);
    dibujaRectangulo();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

static bool enDosPasadas(const Filtro &f) {
    return f.esSeparable() && (estado.modo == 2 || (estado.modo == 0 && f.talla >= TALLA_SEPARABLE));
}

static void dibujaTextura(GLuint textura, const Recuadro &panel, const std::string &rotulo) {
    dibujaEn(encaja(estado.talla, panel));
    glUseProgram(estado.programaCopia);
    glBindTexture(GL_TEXTURE_2D, textura);
    envia(estado.programaCopia, "imagen", 0);
    dibujaRectangulo();
    if (estado.rotulos)
        rotulaImagen(rotulo);
}

static void dibuja() {
    const Filtro f = creaFiltro(estado.familia, estado.tallaFiltro);
    const bool dosPasadas = enDosPasadas(f), sumaCero = estado.familia == DERIVADA;
    if (dosPasadas) {
        const Lienzo &intermedio = estado.intermedio[estado.en8Bits];
        filtra(estado.imagen, intermedio.framebuffer, f.fila, f.talla, false);
        filtra(intermedio.textura, estado.resultado.framebuffer, f.columna, 1, sumaCero);
    } else {
        filtra(estado.imagen, estado.resultado.framebuffer, f.valores, f.talla, sumaCero);
    }

    abreRecuadro(ventanaEntera(), FONDO_OSCURO);
    const std::string lado = std::to_string(f.talla),
                      nombre = NOMBRES[estado.familia] + std::string(" ") + lado + "×" + lado,
                      como = !dosPasadas ? "directo"
                                         : std::string("separable, ") + (estado.en8Bits ? "8 bits" : "float");
    if (estado.compara) {
        const std::vector<Recuadro> paneles = panelesPara(2, estado.talla);
        dibujaTextura(estado.imagen, paneles[0], "Original");
        dibujaTextura(estado.resultado.textura, paneles[1], nombre);
    } else {
        dibujaTextura(estado.resultado.textura, ventanaEntera(), nombre + "\n" + como);
    }
    ponTitulo(nombre + ", " + como + " (" + MODOS[estado.modo] + ")");
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    switch (tecla) {
    case '1':
    case '2':
    case '3':
    case '4': estado.familia = static_cast<Familia>(tecla - '1'); break;
    case '+': estado.tallaFiltro = std::min(estado.tallaFiltro + 1, TALLA_MAXIMA); break;
    case '-': estado.tallaFiltro = std::max(estado.tallaFiltro - 1, 1); break;
    case 's': estado.modo = (estado.modo + 1) % 3; break;
    case 'p': estado.en8Bits = !estado.en8Bits; break;
    case 'a': estado.conSigno = !estado.conSigno; break;
    case 'v': estado.compara = !estado.compara; break;
    case 'r': estado.rotulos = !estado.rotulos; break;
    default: return;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    const auto [imagenes, propias] =
        abreVentanaConImagenes(argc, argv, "Filtros de tamaño variable", {{"assets/foto.rgb", 250, 190}});
    inicia(imagenes[0]);
    estado.rotulos = !propias;
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    glutMainLoop();
    return 0;
}
