// Luces que cambian con el tiempo (§12.1): la intensidad crece y decae, y el color pasa suavemente del naranja al azul.
// La fuente no se mueve: solo cambian Ld y Ls, dos uniform del modelo de Phong (capítulo 5).
// Controles: espacio pausa · s adelanta medio segundo · d una décima · h diez horas · ratón orbita · Esc termina.
#include "animacion.h"
#include "ch05_iluminacion/iluminacion.h"
#include "orbita.h"
#include <glm/gtc/constants.hpp>

static const double PERIODO_INTENSIDAD = 4, PERIODO_COLOR = 12; // segundos
static const glm::vec3 CALIDO(1.0f, 0.6f, 0.25f), FRIO(0.3f, 0.6f, 1.0f), LA(0.5f);
static const glm::vec4 FUENTE(-0.1f, 2.3f, 1.3f, 1);
static const Material PISO = {{0.25f, 0.25f, 0.25f}, {0.85f, 0.85f, 0.85f}, {0, 0, 0}, 1};
static const Material BOLA = {{0.25f, 0.25f, 0.25f}, {0.80f, 0.80f, 0.80f}, {0.15f, 0.15f, 0.15f}, 30};

static struct {
    GLuint programa;
    Buferes plano, esfera, cubo;
    Orbita orbita = {0.4f, 0.42f, 12, {0.1f, 0.65f, 0}, 0.05f};
    Reloj reloj;
} estado;

// De 0 a 1 y de vuelta a 0.
static float pulso(double t, double periodo) {
    return 0.5f - 0.5f * std::cos(glm::two_pi<float>() * fase(t, periodo));
}

static void dibuja() {
    const glm::mat4 camara = camaraOrbita(estado.orbita);
    const float intensidad = pulso(tiempo(estado.reloj), PERIODO_INTENSIDAD);
    Luz luz{FUENTE};
    luz.Ld = luz.Ls = intensidad * glm::mix(CALIDO, FRIO, pulso(tiempo(estado.reloj), PERIODO_COLOR));

    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(estado.programa);
    envia(estado.programa, "proyeccion", perspectivaVentana(0.45f, 1, 50));
    envia(estado.programa, "camara", camara);
    envia(estado.programa, "La", LA);
    enviaLuz(estado.programa, "luz", luz, camara);
    const auto solido = [&](const Buferes &buferes, const glm::mat4 &M, const Material &material) {
        dibujaObjeto(estado.programa, buferes, M, camara, material);
    };
    solido(estado.plano, giroX(-glm::half_pi<float>()) * escalado({4.4f, 4.4f, 1}), PISO);
    solido(estado.esfera, traslacion({0.8f, 0.7f, -0.3f}) * escalado(0.7f), BOLA);
    solido(estado.cubo, traslacion({-1.0f, 0.5f, 0.3f}) * giroY(0.4f), BOLA);
    // la bombilla no refleja: tiene, como si fuera suyo, el color de la luz
    solido(estado.esfera, traslacion(glm::vec3(FUENTE)) * escalado(0.16f), {luz.Ld / LA, {}, {}, 1});

    char ademas[32];
    std::snprintf(ademas, sizeof ademas, ", I = %.2f", intensidad);
    rotulaTiempo(estado.reloj, BLANCO, ademas);
    tituloAnimado(estado.reloj, std::string("Luces animadas") + ademas);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    teclaAnimacion(estado.reloj, tecla);
}

static void anima(int) {
    pideCuadro(estado.reloj, anima);
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Luces animadas", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    estado.programa = creaSombreado("phong");
    estado.plano = creaBuferes(plano(1));
    estado.esfera = creaBuferes(esfera(segmentosEsfera(150)));
    estado.cubo = creaBuferes(cubo());
    glEnable(GL_DEPTH_TEST);
    glClearColor(FONDO_OSCURO.r, FONDO_OSCURO.g, FONDO_OSCURO.b, 1);
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    anima(0);
    glutMainLoop();
    return 0;
}
