// Las transformaciones básicas (§3.1) de una F, con su matriz: traslación (ecuaciones 3.1 a 3.3), escalado (3.4 y 3.5)
// y giros alrededor de X, Y y Z (3.6 a 3.8). Gris, la F original; morados, el camino de su esquina y las columnas que
// no son de la identidad. Un giro de ángulo positivo es antihorario visto desde la punta de su eje. Las matrices son de
// 4×4 porque multiplican puntos en coordenadas homogéneas, (x, y, z, 1): sin el 1 no habría traslación. Con h, el
// producto de una esquina, p, por la matriz (ecuación 3.3).
// Controles: 1 traslación · 2 escalado · 3 4 5 giro en X, Y, Z · + - cambian el valor · h el punto p ·
// ratón orbita · Esc termina.
#include "buferes.h"
#include "colores.h"
#include "dibujos.h"
#include "letra_f.h"
#include "matriz.h"
#include "modos.h"
#include "objeto.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "texto.h"
#include "transformaciones.h"
#include "trazo.h"
#include "ventana.h"
#include <glm/gtc/constants.hpp>

static const float GRADO = glm::pi<float>() / 180;
static const struct Basica {
    const char *antes, *despues; // del valor, al escribirla
    glm::mat4 (*matriz)(float);
    float unidad, neutro, inicial, paso, tope; // `unidad`, en la que se escribe el valor; los demás, en ella
} BASICAS[] = {
    {"T(", ", 0, 0)", [](float t) { return traslacion(glm::vec3(t, 0, 0)); }, 1, 0, 1.5f, 0.25f, 2},
    {"S(", ", 1, 1)", [](float s) { return escalado(glm::vec3(s, 1, 1)); }, 1, 1, 1.5f, 0.25f, 2},
    {"Rx(", "°)", giroX, GRADO, 0, 60, 15, 90},
    {"Ry(", "°)", giroY, GRADO, 0, 60, 15, 90},
    {"Rz(", "°)", giroZ, GRADO, 0, 60, 15, 90},
};

static struct {
    GLuint programa;
    Buferes letra;
    int elegido = 0;
    bool conPunto = false;
    float valor = BASICAS[0].inicial;
    Orbita orbita = {0.55f, 0.35f, 9, {0.3f, -0.05f, 0}};
} estado;

static void inicia() {
    estado.programa = creaProgramaObjeto();
    estado.letra = creaBuferes(letraF());
    glEnable(GL_DEPTH_TEST);
    ponFondo(FONDO_CLARO);
}

static std::string nombre() {
    const Basica &b = BASICAS[estado.elegido];
    return formatea("%s%.4g%s", b.antes, estado.valor, b.despues);
}

// Las cuatro coordenadas, una debajo de otra.
static void rotulaColumna(const char *nombre, const glm::vec4 &v, float x, const glm::vec3 &color) {
    std::string filas;
    for (int i = 0; i < 4; ++i)
        filas += formatea("%s%s%5.3g %s", i ? "\n" : "", ABRE[i], aCentesimas(v[i]), CIERRA[i]);
    rotula(filas, {x, 0.14f}, color, Lado::DERECHA, 0.032f);
    rotula(nombre, {x + 0.08f, 0.29f}, color);
}

static void dibuja() {
    const Basica &b = BASICAS[estado.elegido];
    const glm::mat4 proyeccion = perspectivaVentana(0.5f, 1, 100), camara = camaraOrbita(estado.orbita);
    const glm::mat4 transformacion = proyeccion * camara, M = b.matriz(b.unidad * estado.valor);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    usaPrograma(estado.programa, camara, proyeccion);
    if (glm::determinant(M) == 0) // aplastada, sus dos caras coinciden: solo se dibuja la que mira aquí
        glEnable(GL_CULL_FACE);
    dibujaObjeto(estado.programa, estado.letra, M, NARANJA);
    glDisable(GL_CULL_FACE);
    trazaOriginal(aristasF(), transformacion);

    std::vector<glm::vec3> camino; // de la esquina, mientras el valor va del neutro al suyo
    for (int i = 0; i <= 20; ++i) {
        const float valor = glm::mix(b.neutro, estado.valor, float(i) / 20);
        camino.push_back(b.matriz(b.unidad * valor) * glm::vec4(MAXIMO_F, 1));
    }
    trazaPolilinea({camino.begin(), camino.end() - 3}, transformacion, MORADO, 1.5f * GROSOR);
    trazaFlecha(camino[17], camino[20], transformacion, MORADO, 1.5f * GROSOR);
    trazaEjes({1.85f, 1.65f, 1.85f}, transformacion);
    ponTitulo("Transformaciones básicas: " + nombre());
    if (estado.conPunto) {
        const glm::vec4 p(MAXIMO_F, 1);
        const glm::vec4 q = M * p;
        trazaPuntos({glm::vec3(p)}, transformacion, OSCURO);
        rotulaPunto("p", glm::vec3(p), transformacion, OSCURO);
        rotulaPunto("q", glm::vec3(q), transformacion, MORADO, Lado::DERECHA);
        rotulaColumna("q", q, 0.02f, MORADO);
        rotula("=", {0.215f, 0.14f}, OSCURO);
        rotulaMatriz(M, {0.24f, 0.14f});
        rotula(nombre(), {0.48f, 0.29f}, OSCURO);
        rotulaColumna("p", p, 0.79f, OSCURO);
    } else {
        rotula(nombre() + " =", {0.44f, 0.14f}, OSCURO, Lado::IZQUIERDA);
        rotulaMatriz(M, {0.44f, 0.14f});
    }
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    const Basica &b = BASICAS[estado.elegido];
    if (eligeModo(estado.elegido, 5, tecla))
        estado.valor = BASICAS[estado.elegido].inicial;
    else if (tecla == '+' || tecla == '-')
        estado.valor = glm::clamp(estado.valor + (tecla == '+' ? b.paso : -b.paso), -b.tope, b.tope);
    else if (tecla == 'h')
        estado.conPunto = !estado.conPunto;
    else
        return;
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Transformaciones básicas", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
