// Las transformaciones básicas: traslación (ecuaciones 3.1 y 3.2), escalado (3.4 y 3.5) y giros alrededor de X, Y y Z (3.6, 3.7 y
// 3.8) de una F, con su matriz. En gris, la F de partida. Los giros positivos son antihorarios mirando hacia el origen
// desde el eje.
// Controles: 1 traslación · 2 escalado · 3 4 5 giros en X, Y y Z · + - valor · ratón orbita · Esc termina.
#include "ejes.h"
#include "letra_f.h"
#include "objeto.h"
#include "orbita.h"
#include "ventana.h"
#include <algorithm>
#include <cstdio>

static const struct {
    const char *nombre, *parametros; // con el valor en lugar de %.2f
    glm::mat4 (*matriz)(float valor);
    float inicial, paso, minimo, maximo; // unidades del mundo, factor o radianes
} TRANSFORMACIONES[5] = {
    {"Traslación", "T(%.2f, 0, 0)",
     [](float t) {
         return traslacion({t, 0, 0});
     },
     1.5f, 0.25f, -2, 2},
    {"Escalado", "S(%.2f, 1, 1)",
     [](float s) {
         return escalado({s, 1, 1});
     },
     1.75f, 0.25f, -2, 2},
    {"Giro en X", "Rx(%.2f rad)", giroX, 0.7f, 0.1f, -3.2f, 3.2f},
    {"Giro en Y", "Ry(%.2f rad)", giroY, 0.7f, 0.1f, -3.2f, 3.2f},
    {"Giro en Z", "Rz(%.2f rad)", giroZ, 0.7f, 0.1f, -3.2f, 3.2f},
};

static struct {
    GLuint programa;
    Buferes letra;
    int elegido = 0;
    float valor = TRANSFORMACIONES[0].inicial;
    Orbita orbita = {0.55f, 0.35f, 11.5f, {0.5f, 0.75f, 0}};
} estado;

static void inicia() {
    estado.programa = creaProgramaObjeto();
    estado.letra = creaBuferes(letraF());
    glEnable(GL_DEPTH_TEST);
    glClearColor(FONDO_CLARO.r, FONDO_CLARO.g, FONDO_CLARO.b, 1);
}

static std::string nombreConValor() {
    char texto[40];
    std::snprintf(texto, sizeof texto, TRANSFORMACIONES[estado.elegido].parametros,
                  static_cast<double>(estado.valor));
    return texto;
}

// Las cuatro filas, como se escriben: glm::mat4 guarda columnas.
static std::string textoMatriz(const glm::mat4 &M) {
    std::string texto;
    for (int fila = 0; fila < 4; ++fila) {
        char linea[48];
        std::snprintf(linea, sizeof linea, "%s%5.2f %5.2f %5.2f %5.2f", fila ? "\n" : "",
                      static_cast<double>(M[0][fila]), static_cast<double>(M[1][fila]),
                      static_cast<double>(M[2][fila]), static_cast<double>(M[3][fila]));
        texto += linea;
    }
    return texto;
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const glm::mat4 camara = camaraOrbita(estado.orbita), proyeccion = perspectivaVentana(0.5f, 1, 100);
    const glm::mat4 M = TRANSFORMACIONES[estado.elegido].matriz(estado.valor);
    glUseProgram(estado.programa);
    envia(estado.programa, "proyeccion", proyeccion);
    envia(estado.programa, "camara", camara);
    glFrontFace(glm::determinant(M) < 0 ? GL_CW : GL_CCW);
    dibujaObjeto(estado.programa, estado.letra, M, NARANJA);
    trazaSegmentos(aristasF(), proyeccion * camara, GRIS, 4);
    trazaEjes(proyeccion * camara, glm::vec3(2.3f, 2.1f, 2.1f));
    rotula(nombreConValor(), {0.25f, 0.88f}, OSCURO, Lado::CENTRO, 0.05f);
    rotula(textoMatriz(M), {0.71f, 0.87f}, AZUL, Lado::CENTRO, 0.03f);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    const auto &t = TRANSFORMACIONES[estado.elegido];
    if (tecla >= '1' && tecla <= '5') {
        estado.elegido = tecla - '1';
        estado.valor = TRANSFORMACIONES[estado.elegido].inicial;
    } else if (tecla == '+' || tecla == '-') {
        estado.valor = std::clamp(estado.valor + (tecla == '+' ? t.paso : -t.paso), t.minimo, t.maximo);
    } else {
        return;
    }
    ponTitulo(TRANSFORMACIONES[estado.elegido].nombre + (": " + nombreConValor()));
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Traslación: T(1.50, 0, 0)", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
