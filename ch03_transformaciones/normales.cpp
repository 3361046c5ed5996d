// La matriz que transforma las normales (§3.3, figura 3.1): en cada lado de un prisma, en verde su normal por N
// y en rojo por M, que no es perpendicular al lado. Con una reflexión, en naranja, la traspuesta de la adjunta
// tal como la da el libro: apunta hacia dentro, porque le falta el signo del determinante (transformaciones.h).
// Si M y N coinciden solo se ve la verde; una cara aplastada en una recta no tiene normal.
// Controles: 1 original · 2 S(2,1,1) · 3 reflexión S(−2,1,1) · 4 aplastamiento S(2,0,1) · ratón orbita · Esc termina.
#include "malla.h"
#include "orbita.h"
#include "shader.h"
#include "transformaciones.h"
#include "ventana.h"

static const glm::vec2 poligono[] = {
    {0.25f, -0.95f}, {0.85f, 0.15f}, {-0.10f, 0.90f}, {-0.90f, -0.20f}}; // antihorario
static const int LADOS = 4;
static const float FONDO = 0.9f; // grueso del prisma, a lo largo de Z
static const glm::vec3 escalas[] = {{1, 1, 1}, {2, 1, 1}, {-2, 1, 1}, {2, 0, 1}};

static const glm::vec3 verde(0.20f, 0.62f, 0.28f), rojo(0.85f, 0.20f, 0.18f), naranja(0.95f, 0.55f, 0.10f),
    colorPrisma(0.72f, 0.82f, 0.97f);

static struct {
    GLuint programa;
    Buferes prisma, cilindro, cono;
    int caso = 0;
    Orbita orbita = {0.16f, 0.32f, 8};
} estado;

static glm::vec3 normalLado(int i) {
    const glm::vec2 lado = poligono[(i + 1) % LADOS] - poligono[i];
    return glm::normalize(glm::vec3(lado.y, -lado.x, 0));
}

static Malla creaPrisma() {
    Malla malla;
    for (int i = 0; i < LADOS; ++i) {
        const GLuint base = static_cast<GLuint>(malla.vertices.size());
        const glm::vec2 &a = poligono[i], &b = poligono[(i + 1) % LADOS];
        for (const glm::vec3 p : {glm::vec3(b, FONDO / 2), {a, FONDO / 2}, {a, -FONDO / 2}, {b, -FONDO / 2}})
            malla.vertices.push_back({p, normalLado(i), {0, 0}});
        malla.indices.insert(malla.indices.end(), {base, base + 1, base + 2, base, base + 2, base + 3});
    }
    for (float z : {FONDO / 2, -FONDO / 2}) {
        const GLuint base = static_cast<GLuint>(malla.vertices.size());
        for (const glm::vec2 &p : poligono)
            malla.vertices.push_back({{p, z}, {0, 0, z > 0 ? 1 : -1}, {0, 0}});
        for (GLuint i = base + 1; i + 1 < base + LADOS; ++i)
            malla.indices.insert(malla.indices.end(), {base, z > 0 ? i : i + 1, z > 0 ? i + 1 : i});
    }
    return malla;
}

static void inicia() {
    estado.programa = creaPrograma("ch03_transformaciones/objeto.vert", "ch03_transformaciones/objeto.frag");
    estado.prisma = creaBuferes(creaPrisma());
    estado.cilindro = creaBuferes(cilindro(16));
    estado.cono = creaBuferes(cono(24));
    glEnable(GL_DEPTH_TEST);
    glEnable(
        GL_CULL_FACE); // las dos caras de un prisma aplastado coinciden: que solo se dibuje la que mira aquí
    glClearColor(0.95f, 0.96f, 0.98f, 1);
}

static void dibujaMalla(const Buferes &malla, const glm::mat4 &M, const glm::vec3 &color) {
    const glm::mat3 N = matrizNormal(M);
    envia(estado.programa, "M", M);
    envia(estado.programa, "N", N);
    envia(estado.programa, "colorObjeto", color);
    dibuja(malla);
}

// Toda flecha mide lo mismo: tras transformar una normal hay que normalizarla.
static void dibujaFlecha(const glm::vec3 &origen, const glm::vec3 &direccion, const glm::vec3 &color) {
    const float largo = 0.75f, punta = 0.25f, grueso = 0.04f;
    const glm::mat4 base = traslacion(origen) * haciaDireccion(direccion);
    dibujaMalla(estado.cilindro, base * escalado({grueso, grueso, largo - punta}) * traslacion({0, 0, 0.5f}),
                color);
    dibujaMalla(estado.cono,
                base * traslacion({0, 0, largo - punta}) * escalado({3 * grueso, 3 * grueso, punta}), color);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(estado.programa);
    const glm::mat4 camara = paralelaVentana(1.75f, 1, 20) * camaraOrbita(estado.orbita);
    envia(estado.programa, "camara", camara);

    const glm::mat4 M = escalado(escalas[estado.caso]);
    const glm::mat3 N = matrizNormal(M);
    const bool esReflexion = glm::determinant(glm::mat3(M)) < 0;
    glFrontFace(esReflexion ? GL_CW : GL_CCW); // una reflexión cambia el sentido de giro de las caras
    dibujaMalla(estado.prisma, M, colorPrisma);
    glFrontFace(GL_CCW);

    for (int i = 0; i < LADOS; ++i) {
        const glm::vec2 medio = 0.5f * (poligono[i] + poligono[(i + 1) % LADOS]);
        const glm::vec3 pie = M * glm::vec4(medio, FONDO / 2, 1);
        const glm::vec3 n = normalLado(i), conM = unitario(glm::mat3(M) * n), conN = N * n;
        if (conN != glm::vec3(0))
            dibujaFlecha(pie, conN, verde);
        if (glm::dot(conM, unitario(conN)) < 0.999f)
            dibujaFlecha(pie, conM, rojo);
        if (esReflexion)
            dibujaFlecha(pie, -conN, naranja);
    }
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || tecla < '1' || tecla > '4')
        return;
    estado.caso = tecla - '1';
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Normales transformadas", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
