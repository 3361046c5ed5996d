// La matriz que transforma las normales (§3.3, figura 3.1): en cada lado de un prisma, en verde su normal por N
// y en rojo por M, que no es perpendicular al lado. Con una reflexión, en naranja, la traspuesta de la adjunta
// tal como la da el libro: apunta hacia dentro, porque le falta el signo del determinante (transformaciones.h).
// Si M y N coinciden solo se ve la verde; una cara aplastada en una recta no tiene normal.
// Controles: 1 original · 2 S(2,1,1) · 3 reflexión S(−2,1,1) · 4 aplastamiento S(2,0,1) · ratón orbita · Esc termina.
#include "colores.h"
#include "modos.h"
#include "objeto.h"
#include "orbita.h"
#include "proyeccion.h"
#include "rotulo.h"
#include "trazo.h"
#include "ventana.h"

static const glm::vec2 POLIGONO[] = {
    {0.25f, -0.95f}, {0.85f, 0.15f}, {-0.10f, 0.90f}, {-0.90f, -0.20f}}; // antihorario
static const int LADOS = 4;
static const float FONDO = 0.9f; // grueso del prisma, a lo largo de Z
static const glm::vec3 COLOR_PRISMA(0.72f, 0.82f, 0.97f);
static const struct {
    glm::vec3 factores;
    const char *nombre;
    int ladoRotulado; // el que tiene sitio
} ESCALADOS[] = {{{1, 1, 1}, "M = I", 1},
                 {{2, 1, 1}, "M = S(2, 1, 1)", 1},
                 {{-2, 1, 1}, "M = S(−2, 1, 1)", 1},
                 {{2, 0, 1}, "M = S(2, 0, 1)", 2}};

static struct {
    GLuint programa;
    Buferes prisma;
    int elegido = 0;
    Orbita orbita = {0.16f, 0.32f, 8};
} estado;

static glm::vec3 normalLado(int i) {
    const glm::vec2 lado = POLIGONO[(i + 1) % LADOS] - POLIGONO[i];
    return glm::normalize(glm::vec3(lado.y, -lado.x, 0));
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

static void dibuja() {
    const glm::mat4 proyeccion = paralelaVentana(1.75f, 1, 20), camara = camaraOrbita(estado.orbita),
                    transformacion = proyeccion * camara, M = escalado(ESCALADOS[estado.elegido].factores);
    const int ladoRotulado = ESCALADOS[estado.elegido].ladoRotulado;
    const glm::mat3 N = matrizNormal(M);
    const bool esReflexion = glm::determinant(glm::mat3(M)) < 0;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    usaPrograma(estado.programa, camara, proyeccion);
    glFrontFace(esReflexion ? GL_CW : GL_CCW); // una reflexión cambia el sentido de giro de las caras
    dibujaObjeto(estado.programa, estado.prisma, M, COLOR_PRISMA);
    glFrontFace(GL_CCW);

    for (int k = 1; k <= LADOS; ++k) {
        const int i = (ladoRotulado + k) % LADOS; // el último, que nada tape sus rótulos
        const glm::vec2 medio = 0.5f * (POLIGONO[i] + POLIGONO[(i + 1) % LADOS]);
        const glm::vec3 pie = M * glm::vec4(medio, 0.52f * FONDO, 1); // delante de la cara, que no la tape
        // Toda flecha mide lo mismo: tras transformar una normal hay que normalizarla.
        const auto flecha = [&](const glm::vec3 &hacia, const glm::vec3 &color, const char *nombre) {
            trazaFlecha(pie, pie + 0.75f * hacia, transformacion, color, 1.5f * GROSOR);
            if (i == ladoRotulado)
                rotulaPunto(nombre, pie + 0.99f * hacia, transformacion, color, Lado::CENTRO);
        };
        const glm::vec3 n = normalLado(i), conM = unitario(glm::mat3(M) * n),
                        conN = unitario(N * n, {0, 0, 0});
        const bool coinciden = glm::dot(conM, conN) > 0.999f;
        if (conN != glm::vec3(0))
            flecha(conN, VERDE, coinciden ? "N·n = M·n" : "N·n");
        if (!coinciden)
            flecha(conM, ROJO, "M·n");
        if (esReflexion)
            flecha(-conN, NARANJA, "adjunta");
    }
    rotula(ESCALADOS[estado.elegido].nombre, {0.03f, 0.06f}, OSCURO, Lado::DERECHA);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || !eligeModo(estado.elegido, 4, tecla))
        return;
    ponTitulo(std::string("Normales transformadas: ") + ESCALADOS[estado.elegido].nombre);
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
