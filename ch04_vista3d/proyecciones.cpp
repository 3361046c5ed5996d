// El mismo cubo en perspectiva y en paralela (ecuaciones 4.2 y 4.3, figura 4.2), con sus aristas prolongadas hacia
// el fondo. Cada recta acaba en el punto del infinito de su dirección, (d, 0) en coordenadas homogéneas: en
// perspectiva se ve, y es el punto de fuga de todas sus paralelas; en paralela sigue en el infinito. Los dos
// puntos de fuga de las rectas horizontales están en el horizonte, a la altura de los ojos.
// Controles: p cambia de proyección · ratón orbita · Esc termina.
#include "ch03_transformaciones/transformaciones.h"
#include "malla.h"
#include "orbita.h"
#include "shader.h"
#include "ventana.h"
#include "vista.h"

static const double ANGULO = 1.6, CERCA = 0.1, LEJOS = 2000; // de la perspectiva; el ángulo, en radianes
static const float GRUESO_ARISTA = 0.05f;
static const glm::vec3 coloresEje[] = {{0.85f, 0.20f, 0.18f}, {0.16f, 0.17f, 0.20f}, {0.16f, 0.38f, 0.80f}};
// caras del cubo en el orden de malla.h: −X +X −Y +Y −Z +Z
static const glm::vec3 coloresCara[] = {{0.99f, 0.86f, 0.42f}, {0.99f, 0.86f, 0.42f}, {1.00f, 0.95f, 0.75f},
                                        {1.00f, 0.95f, 0.75f}, {0.97f, 0.74f, 0.28f}, {0.97f, 0.74f, 0.28f}};
static const glm::vec3 gris(0.55f, 0.58f, 0.62f);

static struct {
    GLuint programa, vao, bufer;
    Buferes cubo;
    bool enPerspectiva = true;
    Orbita orbita = {0.75f, 0.46f, 1.6f, {0, 0.12f, 0}};
} estado;

static void inicia() {
    estado.programa = creaPrograma("ch04_vista3d/linea.vert", "ch04_vista3d/linea.frag");
    estado.cubo = creaBuferes(cubo());
    glGenVertexArrays(1, &estado.vao);
    glBindVertexArray(estado.vao);
    glGenBuffers(1, &estado.bufer);
    glBindBuffer(GL_ARRAY_BUFFER, estado.bufer);
    glVertexAttribPointer(ATRIBUTO_POSICION, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(ATRIBUTO_POSICION);
    glEnable(GL_DEPTH_TEST);
    glClearColor(0.95f, 0.96f, 0.98f, 1);
}

// Lleva el cubo unidad a M y lo dibuja entero, o solo una de sus caras (dos triángulos).
static void dibujaCubo(const glm::mat4 &M, const glm::vec3 &color, int cara = -1) {
    envia(estado.programa, "camara", M);
    envia(estado.programa, "colorObjeto", color);
    glBindVertexArray(estado.cubo.vao);
    glDrawElements(
        GL_TRIANGLES, cara < 0 ? estado.cubo.nIndices : 6, GL_UNSIGNED_INT,
        reinterpret_cast<const void *>(static_cast<std::size_t>(std::max(cara, 0)) * 6 * sizeof(GLuint)));
}

static void dibujaLineas(GLenum primitiva, const std::vector<glm::vec4> &puntos, const glm::mat4 &camara,
                         const glm::vec3 &color) {
    envia(estado.programa, "camara", camara);
    envia(estado.programa, "colorObjeto", color);
    glBindVertexArray(estado.vao);
    glBindBuffer(GL_ARRAY_BUFFER, estado.bufer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(puntos.size() * sizeof(glm::vec4)), puntos.data(),
                 GL_STREAM_DRAW);
    glDrawArrays(primitiva, 0, static_cast<GLsizei>(puntos.size()));
}

static void dibuja() {
    const int lado = std::min(glutGet(GLUT_WINDOW_WIDTH), glutGet(GLUT_WINDOW_HEIGHT));
    const float grueso = std::max(static_cast<float>(lado) / 90, 1.0f); // de las líneas, en píxeles
    const glm::dvec3 ojo(posicionCamara(estado.orbita));
    const glm::vec3 F(baseCamara(ojo, estado.orbita.centro, {0, 1, 0}).F);
    const double aspecto = relacionAspecto(), theta = anguloEnY(ANGULO, aspecto);
    // la paralela abarca lo mismo que la perspectiva a la distancia del centro
    const double y = estado.orbita.distancia * std::tan(theta / 2), x = aspecto * y;
    const glm::mat4 camara = (estado.enPerspectiva ? proyeccionPerspectiva(theta, aspecto, CERCA, LEJOS)
                                                   : proyeccionParalela(-x, x, -y, y, -LEJOS, LEJOS)) *
                             transformacionCamara(ojo, estado.orbita.centro, {0, 1, 0});
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(estado.programa);
    for (int cara = 0; cara < 6; ++cara)
        dibujaCubo(camara, coloresCara[cara], cara);

    glLineWidth(grueso);
    std::vector<glm::vec4> fugas; // vistos desde el ojo, donde los puntos del infinito
    for (int eje = 0; eje < 3; ++eje) {
        glm::vec3 fondo(0), talla(GRUESO_ARISTA);
        fondo[eje] = F[eje] < 0 ? -1.0f : 1.0f;
        talla[eje] = eje == 1 ? 1 + GRUESO_ARISTA : 1 - GRUESO_ARISTA; // las esquinas son de las verticales
        std::vector<glm::vec4> rectas;
        for (float a : {-0.5f, 0.5f})
            for (float b : {-0.5f, 0.5f}) {
                glm::vec3 medio(0);
                medio[(eje + 1) % 3] = a;
                medio[(eje + 2) % 3] = b;
                dibujaCubo(camara * traslacion(medio) * escalado(talla), coloresEje[eje]);
                rectas.insert(rectas.end(), {{medio + 0.5f * fondo, 1}, {fondo, 0}});
            }
        if (eje != 1) {
            dibujaLineas(GL_LINES, rectas, camara, coloresEje[eje]);
            fugas.push_back({glm::vec3(ojo) + static_cast<float>(LEJOS / 2) * fondo, 1});
        }
    }
    if (estado.enPerspectiva) {
        const glm::vec4 tramo = 10.0f * (fugas[1] - fugas[0]);
        glPointSize(4 * grueso);
        dibujaLineas(GL_POINTS, fugas, camara, coloresEje[1]);
        glLineWidth(1);
        dibujaLineas(GL_LINES, {fugas[0] - tramo, fugas[1] + tramo}, camara, gris);
    }
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || tecla != 'p')
        return;
    estado.enPerspectiva = !estado.enPerspectiva;
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Perspectiva y paralela", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
