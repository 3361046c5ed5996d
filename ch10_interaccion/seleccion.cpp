// Elegir un objeto con el ratón (listados 10.2 y 10.3; sus initFramebuffer y renderToFramebuffer son aquí
// creaFramebuffer y selecciona): la escena se dibuja otra vez, en un framebuffer propio y cada objeto del color de su
// identificador (identificador.h), y se lee el clic. El libro enlaza GL_DRAW_FRAMEBUFFER y, para leer,
// GL_READ_FRAMEBUFFER, que se queda puesto; GL_FRAMEBUFFER son los dos, y los dos vuelven a la ventana. Lee GL_FLOAT;
// un identificador es un número entero, que en bytes llega exacto.
// Controles: clic elige · v lo que hay en el framebuffer · arrastrar orbita · rueda acerca · Esc termina.
#include "buferes.h"
#include "ch03_transformaciones/objeto.h"
#include "ch03_transformaciones/transformaciones.h"
#include "colores.h"
#include "error.h"
#include "identificador.h"
#include "malla.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "solidos.h"
#include "texto.h"
#include "trazo.h"
#include "ventana.h"
#include <cmath>
#include <cstdio>
#include <vector>

static const float APAGADO = 0.7f, RADIO_ARO = 0.98f;

enum { COLOR, PROFUNDIDAD, N_RENDERBUFFERS };
static struct {
    GLuint programa, programaIdentificador;
    GLuint framebuffer = 0, renderbuffer[N_RENDERBUFFERS] = {};
    Buferes formas[N_FORMAS];
    unsigned elegido = NADA; // SOLIDOS[elegido]
    std::string leido = "clic en un objeto";
    std::vector<glm::vec3> cruz; // dos segmentos donde se hizo clic, en coordenadas normalizadas
    bool conIdentificadores = false;
    Orbita orbita = {0.25f, 0.55f, 11.5f, {-0.45f, 0.05f, 0}, 0.1f};
} estado;

// Listado 10.2 (initFramebuffer, con renderbuffer[Color] y [Depth]). Si la ventana cambia de tamaño se hace otra vez.
static void creaFramebuffer(int ancho, int alto) {
    glDeleteFramebuffers(1, &estado.framebuffer); // si no había, borrar el 0 no hace nada
    glDeleteRenderbuffers(N_RENDERBUFFERS, estado.renderbuffer);
    glGenRenderbuffers(N_RENDERBUFFERS, estado.renderbuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, estado.renderbuffer[COLOR]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, ancho, alto); // GL_RGBA a secas no promete 8 bits
    glBindRenderbuffer(GL_RENDERBUFFER, estado.renderbuffer[PROFUNDIDAD]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, ancho, alto);

    glGenFramebuffers(1, &estado.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, estado.framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                              estado.renderbuffer[COLOR]);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                              estado.renderbuffer[PROFUNDIDAD]);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        falla("este OpenGL no admite el framebuffer de la selección");
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

static void inicia() {
    estado.programa = creaProgramaObjeto();
    estado.programaIdentificador =
        creaPrograma("ch03_transformaciones/objeto.vert", "ch10_interaccion/identificador.frag");
    const Malla mallas[N_FORMAS] = {cubo(), cubo(), esfera(64), cono(64), toro(0.6f, 0.24f, 64, 32)};
    for (int i = 0; i < N_FORMAS; ++i)
        estado.formas[i] = creaBuferes(mallas[i]);
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_DITHER); // un identificador no se puede redondear
}

static glm::mat4 proyeccion() {
    return perspectivaVentana(0.6f, 0.1f, 60);
}

// Con el color de cada objeto o con el de su identificador.
static void dibujaObjetos(bool conIdentificadores) {
    const GLuint p = conIdentificadores ? estado.programaIdentificador : estado.programa;
    usaPrograma(p, camaraOrbita(estado.orbita), proyeccion());
    unsigned identificador = NADA;
    for (const auto &s : SOLIDOS) {
        const glm::mat4 M = traslacion(s.lugar) * POSADA[s.forma];
        if (conIdentificadores) {
            envia(p, "M", M);
            envia(p, "identificador", colorDe(identificador));
            dibujaMalla(estado.formas[s.forma]);
        } else {
            const bool apagado = estado.elegido != NADA && estado.elegido != identificador;
            dibujaObjeto(p, estado.formas[s.forma], M,
                         apagado ? glm::mix(s.color, SOLIDOS[NADA].color, APAGADO) : s.color);
        }
        ++identificador;
    }
}

// Un aro a sus pies y, abajo, su nombre, o su identificador: a su lado taparía otro objeto.
static void nombraElegido(const glm::vec3 &color) {
    const auto &s = SOLIDOS[estado.elegido];
    const glm::mat4 transformacion = proyeccion() * camaraOrbita(estado.orbita);
    const glm::mat4 enTablero = traslacion(s.lugar + glm::vec3(0, 0.02f * RADIO_ARO, 0)) * giroX(RECTO);
    trazaPolilinea(circunferencia(RADIO_ARO), transformacion * enTablero, color, GROSOR, true);
    // en el framebuffer, su color no es el del nombre
    const std::string nombre =
        estado.conIdentificadores ? "objeto " + std::to_string(estado.elegido) : s.nombre;
    rotula(nombre, {0.5f, 0.06f}, color);
}

static void dibuja() {
    const glm::vec3 color = estado.conIdentificadores ? BLANCO : OSCURO;
    abreRecuadro(ventanaEntera());
    ponFondo(estado.conIdentificadores ? colorDe(NADA) : CIELO);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    dibujaObjetos(estado.conIdentificadores);
    if (estado.elegido != NADA)
        nombraElegido(color);
    else if (!estado.cruz.empty())
        rotulaPunto(SOLIDOS[NADA].nombre, estado.cruz[1], glm::mat4(1), color, Lado::DERECHA);
    trazaSegmentos(estado.cruz, glm::mat4(1), color);
    rotula(estado.leido, {0.5f, 0.94f}, color);
    glutSwapBuffers();
}

// Listado 10.3, renderToFramebuffer. GLUT cuenta las filas desde arriba, de 0 a alto − 1, y OpenGL desde abajo.
static void selecciona(int x, int y) {
    const int fila = glutGet(GLUT_WINDOW_HEIGHT) - 1 - y;
    glBindFramebuffer(GL_FRAMEBUFFER, estado.framebuffer);
    abreRecuadro(ventanaEntera());
    ponFondo(colorDe(NADA));
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_SCISSOR_TEST); // se va a leer un píxel: los demás, ni dibujarlos
    glScissor(x, fila, 1, 1);
    dibujaObjetos(true);
    glDisable(GL_SCISSOR_TEST);
    unsigned char pixel[4] = {}; // lo que quede si el clic cae fuera
    glReadPixels(x, fila, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    glBindFramebuffer(GL_FRAMEBUFFER, 0); // el de dibujar y el de leer

    const glm::vec2 talla(glutGet(GLUT_WINDOW_WIDTH), glutGet(GLUT_WINDOW_HEIGHT));
    const glm::vec2 lugar = 2.0f * (glm::vec2(x, fila) + 0.5f) / talla - 1.0f,
                    brazo = 0.045f * altoUtil() / talla;
    estado.cruz.clear();
    for (const glm::vec2 &d : {glm::vec2(brazo.x, 0), {0, brazo.y}})
        estado.cruz.insert(estado.cruz.end(), {{lugar - d, -0.99f}, {lugar + d, -0.99f}});

    estado.elegido = identificadorDe({pixel[0], pixel[1], pixel[2]});
    const std::string nombre = SOLIDOS[estado.elegido].nombre;
    estado.leido = formatea("color %d %d %d → objeto %u", pixel[0], pixel[1], pixel[2], estado.elegido);
    std::printf("(%d, %d) %s: %s\n", x, y, estado.leido.c_str(), nombre.c_str());
    std::fflush(stdout);
    ponTitulo("Selección: " + nombre);
    glutPostRedisplay();
}

static void boton(int cual, int movimiento, int x, int y) {
    orbitaBoton(cual, movimiento, x, y);
    if (cual == GLUT_LEFT_BUTTON && movimiento == GLUT_DOWN)
        selecciona(x, y);
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || tecla != 'v')
        return;
    estado.conIdentificadores = !estado.conIdentificadores;
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Selección", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutReshapeFunc(creaFramebuffer);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMouseFunc(boton);
    glutMainLoop();
    return 0;
}
