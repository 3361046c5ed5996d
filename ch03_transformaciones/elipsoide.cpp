// La esfera de radio 1, escalada con (0.5, 0.5, 3), acaba con un extremo en el origen y el otro en la recta x = y = z, la
// oscura (ejercicio 3.4), transformación a transformación (pasos.h). En gris, de dónde sale y adónde va.
// Controles: t aplica la transformación siguiente, y tras la última empieza · ratón orbita · Esc termina.
#include "ejes.h"
#include "objeto.h"
#include "orbita.h"
#include "pasos.h"
#include "ventana.h"

static const float RADIO_PX = 450; // el semieje mayor, donde más cerca está, en una pantalla de 1080 líneas
static const int MERIDIANOS = 4, PUNTOS = 48;

static struct {
    GLuint programa;
    Buferes esfera;
    std::size_t aplicados = 0;
    Orbita orbita = {-0.5f, 0.35f, 17, {1.7f, 1.2f, 1.7f}};
} estado;

static void inicia() {
    estado.programa = creaProgramaObjeto();
    // una esfera se hunde a lo largo y a lo ancho: a cada uno, la mitad del medio píxel
    estado.esfera = creaBuferes(esfera(segmentosPara(RADIO_PX, 0.25f)));
    glEnable(GL_DEPTH_TEST);
    glClearColor(FONDO_CLARO.r, FONDO_CLARO.g, FONDO_CLARO.b, 1);
}

// El ecuador y unos meridianos.
static void trazaEsfera(const glm::mat4 &transformacion) {
    std::vector<glm::vec3> ecuador;
    for (int i = 0; i < PUNTOS; ++i) {
        const float a = glm::two_pi<float>() * static_cast<float>(i) / PUNTOS;
        ecuador.push_back({std::cos(a), std::sin(a), 0});
    }
    trazaPolilinea(ecuador, transformacion, GRIS, 4, true);
    for (int i = 0; i < MERIDIANOS; ++i) // el ecuador, puesto de pie
        trazaPolilinea(ecuador,
                       transformacion * giroZ(glm::pi<float>() * static_cast<float>(i) / MERIDIANOS) *
                           giroX(glm::half_pi<float>()),
                       GRIS, 4, true);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const glm::mat4 camara = camaraOrbita(estado.orbita), proyeccion = perspectivaVentana(0.5f, 1, 100);
    const std::vector<Paso> pasos = pasosElipsoide();
    glUseProgram(estado.programa);
    envia(estado.programa, "proyeccion", proyeccion);
    envia(estado.programa, "camara", camara);
    dibujaObjeto(estado.programa, estado.esfera, concatena(pasos, estado.aplicados), NARANJA);
    for (const std::size_t extremo : {std::size_t(0), pasos.size()})
        if (extremo != estado.aplicados) // donde está la esfera no hacen falta líneas
            trazaEsfera(proyeccion * camara * concatena(pasos, extremo));
    trazaSegmentos({glm::vec3(-1.2f), glm::vec3(4.2f)}, proyeccion * camara, OSCURO);
    rotulaPunto("x = y = z", glm::vec3(4.2f), proyeccion * camara, OSCURO, Lado::IZQUIERDA);
    trazaEjes(proyeccion * camara, glm::vec3(4));
    rotula(producto(pasos, estado.aplicados, " ·\n    "), {0.60f, 0.16f}, OSCURO, Lado::DERECHA);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || tecla != 't')
        return;
    estado.aplicados = (estado.aplicados + 1) % (pasosElipsoide().size() + 1);
    ponTitulo("Elipsoide: " + producto(pasosElipsoide(), estado.aplicados));
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Elipsoide: M = I", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
