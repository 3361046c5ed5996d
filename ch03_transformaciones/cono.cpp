// Del cono de radio y altura 1 al de altura 3 en su sitio (ejercicio 3.3), transformación a transformación (pasos.h). La
// figura del libro no está en el texto: aquí acaba tumbado en el eje X con el vértice en el origen. En gris, de dónde
// sale y adónde va.
// Controles: t aplica la transformación siguiente, y tras la última empieza · ratón orbita · Esc termina.
#include "ejes.h"
#include "objeto.h"
#include "orbita.h"
#include "pasos.h"
#include "ventana.h"

static const float RADIO_PX = 300; // la base en una pantalla de 1080 líneas
static const int GENERATRICES = 8;

static struct {
    GLuint programa;
    Buferes cono;
    std::size_t aplicados = 0;
    Orbita orbita = {0.6f, 0.35f, 9.6f, {1.25f, 0.1f, 0}};
} estado;

static void inicia() {
    estado.programa = creaProgramaObjeto();
    estado.cono = creaBuferes(cono(segmentosPara(RADIO_PX)));
    glEnable(GL_DEPTH_TEST);
    glClearColor(FONDO_CLARO.r, FONDO_CLARO.g, FONDO_CLARO.b, 1);
}

// La base del cono y unas generatrices.
static void trazaCono(const glm::mat4 &transformacion) {
    std::vector<glm::vec3> base, generatrices;
    for (int i = 0; i < 8 * GENERATRICES; ++i) {
        const float a = glm::two_pi<float>() * static_cast<float>(i) / (8 * GENERATRICES);
        base.push_back({std::cos(a), std::sin(a), 0});
        if (i % 8 == 0)
            generatrices.insert(generatrices.end(), {base.back(), {0, 0, 1}});
    }
    trazaPolilinea(base, transformacion, GRIS, 4, true);
    trazaSegmentos(generatrices, transformacion, GRIS, 4);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const glm::mat4 camara = camaraOrbita(estado.orbita), proyeccion = perspectivaVentana(0.5f, 1, 100);
    const std::vector<Paso> pasos = pasosCono();
    glUseProgram(estado.programa);
    envia(estado.programa, "proyeccion", proyeccion);
    envia(estado.programa, "camara", camara);
    dibujaObjeto(estado.programa, estado.cono, concatena(pasos, estado.aplicados), NARANJA);
    for (const std::size_t extremo : {std::size_t(0), pasos.size()})
        if (extremo != estado.aplicados) // donde está el cono no hacen falta líneas
            trazaCono(proyeccion * camara * concatena(pasos, extremo));
    trazaEjes(proyeccion * camara, {3.7f, 1.7f, 1.7f});
    rotula(producto(pasos, estado.aplicados, " ·\n    "), {0.02f, 0.86f}, OSCURO, Lado::DERECHA);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || tecla != 't')
        return;
    estado.aplicados = (estado.aplicados + 1) % (pasosCono().size() + 1);
    ponTitulo("Cono: " + producto(pasosCono(), estado.aplicados));
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Cono: M = I", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
