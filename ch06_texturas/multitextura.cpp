// Varias unidades de textura en un fragment shader (§6.3, §6.5): los ladrillos, el musgo, la máscara que dice dónde lo
// hay y la luz de dos apliques, calculada de antemano. Cada textura está en su unidad, a la izquierda, y cada
// sampler2D recibe el número de una. Ladrillos y musgo se repiten; la máscara y la luz abarcan la pared entera. Con c
// se enlaza otro objeto textura en la unidad 0, la madera: el shader lee lo que haya en su unidad, sin enviarle nada.
// Controles: 1 ladrillos y musgo · 2 ladrillos y luz · 3 las cuatro texturas · c cambia la de la unidad 0 ·
// ratón orbita · Esc termina.
#include "buferes.h"
#include "ch03_transformaciones/transformaciones.h"
#include "colores.h"
#include "imagen.h"
#include "malla.h"
#include "modos.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "rutas.h"
#include "shader.h"
#include "textura.h"
#include "ventana.h"

static const glm::vec3 TALLA(4, 3, 1); // de la pared
static const glm::vec2 REPETICIONES(2, 1.5f);
static const float COLUMNA = 0.22f; // lo que ocupan del ancho, a la izquierda, las texturas de las unidades
static const struct {
    const char *nombre, *rotulo; // el nombre, del fichero y del sampler2D
    int ancho, alto;
    GLint borde;
} TEXTURAS[5] = {{"ladrillo", "ladrillo", 256, 256, GL_REPEAT},
                 {"musgo", "musgo", 256, 256, GL_REPEAT},
                 {"mascara", "máscara", 128, 96, GL_CLAMP_TO_EDGE},
                 {"luz", "luz", 64, 48, GL_CLAMP_TO_EDGE},
                 {"madera", "madera", 256, 256, GL_REPEAT}};
enum { LADRILLO, MADERA = 4, UNIDADES = 4 };
static const struct {
    const char *titulo;
    bool conMusgo, conLuz;
} MEZCLAS[3] = {{"Ladrillo y musgo, según la máscara", true, false},
                {"Ladrillo por luz", false, true},
                {"Ladrillo y musgo, según la máscara, por luz", true, true}};

static struct {
    GLuint programa, programaUnidad, texturas[5];
    int enLaPrimera = LADRILLO; // la textura de la unidad 0
    Buferes pared;
    int elegido = 2;
    Orbita orbita = {0, 0, 5, {0, 0, 0}};
} estado;

static void inicia() {
    estado.programa = creaPrograma("ch06_texturas/multitextura.vert", "ch06_texturas/multitextura.frag");
    estado.programaUnidad = creaPrograma("ch06_texturas/textura.vert", "ch06_texturas/textura.frag");
    estado.pared = creaBuferes(plano(1));
    for (int i = 0; i < 5; ++i) {
        const auto &t = TEXTURAS[i];
        glActiveTexture(GL_TEXTURE0 + GLenum(i)); // creaTextura2D deja su textura en la unidad activa
        estado.texturas[i] =
            creaTextura2D(leeTextura(recurso("assets/" + std::string(t.nombre) + ".rgb"), t.ancho, t.alto));
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, t.borde);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, t.borde);
    }
    glActiveTexture(GL_TEXTURE0);
    glEnable(GL_DEPTH_TEST);
}

static void dibujaPared(GLuint programa, const glm::mat4 &camara, const glm::mat4 &proyeccion) {
    envia(programa, "proyeccion", proyeccion);
    envia(programa, "camara", camara);
    envia(programa, "M", escalado(TALLA));
    dibujaMalla(estado.pared);
}

// Lo que hay en cada unidad, con su número; en gris, lo que la mezcla no usa.
static void dibujaUnidades(const Recuadro &donde, bool conMusgo, bool conLuz) {
    const bool usadas[4] = {true, conMusgo, conMusgo, conLuz};
    const std::vector<Recuadro> paneles = rejilla(1, 4, donde);
    glUseProgram(estado.programaUnidad);
    for (int unidad = 0; unidad < 4; ++unidad) {
        const Recuadro &panel = paneles[unidad];
        abreRecuadro(panel);
        ponFondo(FONDO_OSCURO);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        envia(estado.programaUnidad, "Img", unidad);
        dibujaPared(estado.programaUnidad, traslacion({0, 0.13f * TALLA.y, 0}),
                    paralelaVentana(0.72f * TALLA.y, -1, 1, aspecto(panel)));
        rotula(std::to_string(unidad) + " " + TEXTURAS[unidad ? unidad : estado.enLaPrimera].rotulo,
               {0.5f, 0.12f}, usadas[unidad] ? BLANCO : GRIS, Lado::CENTRO, 0.028f);
    }
}

static void dibuja() {
    const Recuadro v = ventanaEntera();
    const Recuadro unidades = {0, 0, int(COLUMNA * float(v.ancho)), v.alto};
    const Recuadro mezcla = {unidades.ancho, 0, v.ancho - unidades.ancho, v.alto};
    const auto &[titulo, conMusgo, conLuz] = MEZCLAS[estado.elegido];
    abreRecuadro(v);
    ponFondo(FONDO_OSCURO);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    dibujaUnidades(unidades, conMusgo, conLuz);

    abreRecuadro(mezcla);
    ponFondo(FONDO_OSCURO);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(estado.programa);
    envia(estado.programa, "repeticiones", REPETICIONES);
    for (GLint unidad = 0; unidad < UNIDADES; ++unidad)
        envia(estado.programa, TEXTURAS[unidad].nombre, unidad);
    envia(estado.programa, "conMusgo", conMusgo);
    envia(estado.programa, "conLuz", conLuz);
    dibujaPared(estado.programa, camaraOrbita(estado.orbita),
                perspectivaVentana(0.62f, 0.1f, 100, aspecto(mezcla)));
    ponTitulo(titulo);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || eligeModo(estado.elegido, 3, tecla) || tecla != 'c')
        return;
    estado.enLaPrimera = estado.enLaPrimera == LADRILLO ? MADERA : LADRILLO;
    glBindTexture(GL_TEXTURE_2D, estado.texturas[estado.enLaPrimera]); // la unidad activa es la 0
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Multitextura", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
