// La matriz que transforma las normales (§3.3, figura 3.1): en cada lado de un prisma, en verde su normal por N
// y en rojo, a trazos, por M, que no es perpendicular al lado. Con una reflexión, en naranja, la traspuesta de la
// adjunta tal como la da el libro: apunta hacia dentro, porque le falta el signo del determinante (transformaciones.h).
// Si M y N coinciden solo se ve la verde; una cara aplastada en una recta no tiene normal. La normal de cada cara es el
// producto vectorial de dos de sus aristas (§2.1): con los vértices en el otro orden sale hacia dentro.
// Controles: 1 original · 2 S(2,1,1) · 3 reflexión S(−2,1,1) · 4 aplastamiento S(2,0,1) · 5 giro y traslación ·
// n sin normalizar · t tangentes · o vértices en el otro orden · ratón orbita · Esc termina.
#include "buferes.h"
#include "colores.h"
#include "malla.h"
#include "modos.h"
#include "objeto.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "transformaciones.h"
#include "trazo.h"
#include "ventana.h"

static const glm::vec2 POLIGONO[] = {
    {0.25f, -0.95f}, {0.85f, 0.15f}, {-0.10f, 0.90f}, {-0.90f, -0.20f}}; // antihorario
static const int LADOS = 4;
static const float FONDO = 0.9f;  // grueso del prisma, a lo largo de Z
static const float LARGO = 0.75f; // de la flecha de un vector unitario
static const glm::vec3 COLOR_PRISMA(0.72f, 0.82f, 0.97f);
static const struct {
    glm::mat4 M;
    const char *nombre;
    int ladoRotulado; // el que tiene sitio
} CASOS[] = {
    {glm::mat4(1), "M = I", 1},
    {escalado({2, 1, 1}), "M = S(2, 1, 1)", 1},
    {escalado({-2, 1, 1}), "M = S(−2, 1, 1)", 1},
    {escalado({2, 0, 1}), "M = S(2, 0, 1)", 2},
    {traslacion({0.5f, 0.2f, 0}) * giroZ(glm::radians(30.0f)), "M = T(0.5, 0.2, 0)·Rz(30°)", 1},
};
static const int N_CASOS = sizeof CASOS / sizeof CASOS[0];

static struct {
    GLuint programa;
    Buferes prisma;
    int elegido = 0;
    bool sinNormalizar = false, tangentes = false, alReves = false;
    Orbita orbita = {0.16f, 0.32f, 8};
} estado;

// El producto vectorial de dos aristas de ese lado: la del polígono y la que une las dos tapas.
static glm::vec3 normalLado(int i) {
    const glm::vec3 arista(POLIGONO[(i + 1) % LADOS] - POLIGONO[i], 0);
    return glm::normalize(glm::cross(arista, glm::vec3(0, 0, 1)));
}

static Malla creaPrisma() {
    Malla malla;
    for (int i = 0; i < LADOS; ++i) {
        const unsigned base = unsigned(malla.vertices.size());
        const glm::vec2 &a = POLIGONO[i], &b = POLIGONO[(i + 1) % LADOS];
        for (const glm::vec3 p : {glm::vec3(b, FONDO / 2), {a, FONDO / 2}, {a, -FONDO / 2}, {b, -FONDO / 2}})
            malla.vertices.push_back({p, normalLado(i), {0, 0}});
        malla.indices.insert(malla.indices.end(), {base, base + 1, base + 2, base, base + 2, base + 3});
    }
    for (float z : {FONDO / 2, -FONDO / 2}) {
        const unsigned base = unsigned(malla.vertices.size());
        for (const glm::vec2 &p : POLIGONO)
            malla.vertices.push_back({{p, z}, {0, 0, z > 0 ? 1 : -1}, {0, 0}});
        for (GLuint i = base + 1; i + 1 < base + LADOS; ++i)
            malla.indices.insert(malla.indices.end(), {base, z > 0 ? i : i + 1, z > 0 ? i + 1 : i});
    }
    return malla;
}

static void inicia() {
    estado.programa = creaProgramaObjeto();
    estado.prisma = creaBuferes(creaPrisma());
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE); // las dos caras de un prisma aplastado coinciden: solo se dibuja la que mira aquí
    ponFondo(FONDO_CLARO);
}

// Las flechas de un lado, delante de la cara, que no las tape. Un vector unitario mide LARGO y, hacia dentro, la mitad:
// que no se junten en el centro.
static void trazaLado(int i, const glm::mat4 &M, const glm::mat4 &transformacion) {
    const glm::vec2 &a = POLIGONO[i], &b = POLIGONO[(i + 1) % LADOS];
    const glm::vec4 medio(0.5f * (a + b), 0.52f * FONDO, 1), medioLado(0.5f * (b - a), 0, 0);
    const glm::vec3 pie = M * medio;
    const float largo = estado.alReves ? LARGO / 2 : LARGO;
    const auto flecha = [&](const glm::vec3 &v, const glm::vec3 &color, const char *nombre, float mide,
                            int trazos = 0) {
        float desde = 0; // un quinto por trazo, la mitad vacía
        for (int k = 0; k < trazos; ++k, desde += 0.2f * mide)
            trazaSegmentos({pie + desde * v, pie + (desde + 0.1f * mide) * v}, transformacion, color,
                           1.5f * GROSOR);
        trazaFlecha(pie + desde * v, pie + mide * v, transformacion, color, 1.5f * GROSOR);
        if (i == CASOS[estado.elegido].ladoRotulado)
            rotulaPunto(nombre, pie + (estado.alReves ? -0.8f : mide + 0.24f) * unitario(v), transformacion,
                        color, Lado::CENTRO);
    };
    const glm::vec3 n = (estado.alReves ? -1.0f : 1.0f) * normalLado(i);
    const glm::vec3 Nn = matrizNormal(M) * n, conM = unitario(glm::mat3(M) * n);
    const glm::vec3 conN = unitario(Nn, {0, 0, 0});
    const bool coinciden = glm::dot(conM, conN) > 0.999f, hayNormal = conN != glm::vec3(0);
    if (estado.tangentes) {
        trazaFlecha(M * (medio - medioLado), M * (medio + medioLado), transformacion, AZUL, 1.5f * GROSOR);
        if (i == (CASOS[estado.elegido].ladoRotulado + 2) % LADOS) // enfrente de las normales rotuladas
            rotulaPunto("M·t",
                        glm::vec3(M * (medio + 0.55f * medioLado)) + 0.25f * (estado.alReves ? -conN : conN),
                        transformacion, AZUL, Lado::CENTRO);
    }
    if (estado.sinNormalizar && hayNormal) {
        trazaSegmentos({pie, pie + largo * conN}, transformacion, GRIS);
        trazaPuntos({pie + largo * conN}, transformacion, GRIS);
        flecha(Nn, VERDE, "N·n", largo);
    } else if (!estado.sinNormalizar) {
        if (hayNormal)
            flecha(conN, VERDE, coinciden ? "N·n = M·n" : "N·n", largo);
        if (!coinciden)
            flecha(conM, ROJO, "M·n", largo, 3);
        if (glm::determinant(glm::mat3(M)) < 0)
            flecha(-conN, NARANJA, "adj(M)ᵀ·n", LARGO / 2);
    }
}

static void dibuja() {
    const auto &[M, nombre, ladoRotulado] = CASOS[estado.elegido];
    const glm::mat4 proyeccion = paralelaVentana(1.75f, 1, 20), camara = camaraOrbita(estado.orbita);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    usaPrograma(estado.programa, camara, proyeccion);
    // una reflexión cambia el sentido de giro de las caras
    glFrontFace(glm::determinant(glm::mat3(M)) < 0 ? GL_CW : GL_CCW);
    dibujaObjeto(estado.programa, estado.prisma, M, COLOR_PRISMA);
    glFrontFace(GL_CCW);

    for (int k = 1; k <= LADOS; ++k) // el rotulado, el último, que nada tape sus rótulos
        trazaLado((ladoRotulado + k) % LADOS, M, proyeccion * camara);
    rotula(nombre, {0.03f, 0.06f}, OSCURO, Lado::DERECHA);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    switch (tecla) {
    case 'n': estado.sinNormalizar = !estado.sinNormalizar; break;
    case 't': estado.tangentes = !estado.tangentes; break;
    case 'o': estado.alReves = !estado.alReves; break;
    default:
        if (!eligeModo(estado.elegido, N_CASOS, tecla))
            return;
    }
    ponTitulo(std::string("Normales transformadas: ") + CASOS[estado.elegido].nombre +
              (estado.alReves ? ", con los vértices en el otro orden" : "") +
              (estado.sinNormalizar ? ", sin normalizar" : ""));
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Normales transformadas: M = I", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
