// Luces que cambian con el tiempo (§12.1): la intensidad crece y decae, y el color pasa suavemente del naranja al azul.
// La fuente no se mueve: solo cambian Ld y Ls, dos uniform del modelo de Phong (capítulo 5). Abajo, los dos a lo largo
// del tiempo: la altura es la intensidad y el color, el de la luz.
// Controles: espacio pausa · s adelanta medio segundo · d una décima · h diez horas · ratón orbita · Esc termina.
#include "animacion.h"
#include "buferes.h"
#include "ch03_transformaciones/transformaciones.h"
#include "ch05_iluminacion/iluminacion.h"
#include "ch05_iluminacion/materiales.h"
#include "colores.h"
#include "malla.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "reloj.h"
#include "rotulo.h"
#include "shader.h"
#include "texto.h"
#include "trazo.h"
#include "ventana.h"
#include <glm/gtc/constants.hpp>

static const double PERIODO_INTENSIDAD = 4, PERIODO_COLOR = 8; // segundos; el segundo, múltiplo del primero
static const glm::vec3 CALIDO(1.0f, 0.6f, 0.25f), FRIO(0.3f, 0.6f, 1.0f), LA(0.5f);
static const glm::vec4 FUENTE(-0.1f, 2.3f, 1.3f, 1);
static const Material BALDOSAS[] = {{{0.25f, 0.25f, 0.25f}, {0.85f, 0.85f, 0.85f}, {0, 0, 0}, 1},
                                    {{0.12f, 0.12f, 0.12f}, {0.40f, 0.40f, 0.40f}, {0, 0, 0}, 1}};
static const int LADO = 6; // baldosas
static const float BALDOSA = 0.75f, RADIO_HALO = 1;
static const Material BOLA = {{0.25f, 0.25f, 0.25f}, {0.80f, 0.80f, 0.80f}, {0.15f, 0.15f, 0.15f}, 30};

static struct {
    GLuint programa, halo;
    Buferes plano, esfera, cubo;
    Orbita orbita = {0.4f, 0.38f, 12.4f, {0.1f, 0.25f, 0}, 0.05f};
    Reloj reloj;
} estado;

// De 1 a 0 y de vuelta a 1.
static float pulso(double t, double periodo) {
    return 0.5f + 0.5f * std::cos(glm::two_pi<float>() * fase(t, periodo));
}

static float intensidadEn(double t) {
    return pulso(t, PERIODO_INTENSIDAD);
}

static glm::vec3 colorEn(double t) {
    return glm::mix(FRIO, CALIDO, pulso(t, PERIODO_COLOR));
}

// Suma a la imagen la luz que llega directa de la bombilla.
static void dibujaHalo(const glm::mat4 &camara, const glm::mat4 &proyeccion, const glm::vec3 &color) {
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    usaPrograma(estado.halo, camara, proyeccion);
    envia(estado.halo, "centro", glm::vec3(FUENTE));
    envia(estado.halo, "radio", RADIO_HALO);
    envia(estado.halo, "colorLuz", color);
    dibujaMalla(estado.plano);
    glDisable(GL_BLEND);
}

// Un periodo entero, en coordenadas normalizadas, y el instante en que se está.
static void dibujaGrafica(double t) {
    const int columnas = 256;
    const float izquierda = -0.9f;
    const float ancho = 1.76f, abajo = -0.76f, alto = 0.2f;
    const auto x = [&](float parte) { return izquierda + ancho * parte; };
    glDisable(GL_DEPTH_TEST);
    for (int i = 0; i < columnas; ++i) {
        const double t0 = i * PERIODO_COLOR / columnas, t1 = (i + 1) * PERIODO_COLOR / columnas;
        const float x0 = x(float(i) / columnas), x1 = x(float(i + 1) / columnas);
        trazaPoligono({{x0, abajo, 0},
                       {x1, abajo, 0},
                       {x1, abajo + alto * intensidadEn(t1), 0},
                       {x0, abajo + alto * intensidadEn(t0), 0}},
                      glm::mat4(1), colorEn(0.5 * (t0 + t1)));
    }
    const float ahora = x(fase(t, PERIODO_COLOR));
    trazaSegmentos({{ahora, abajo, 0}, {ahora, abajo + alto, 0}}, glm::mat4(1), BLANCO);
    const glm::vec3 origen = {izquierda, abajo, 0}, ejeT = {x(1) + 0.05f, abajo, 0},
                    ejeI = {izquierda, abajo + alto + 0.08f, 0};
    trazaFlecha(origen, ejeT, glm::mat4(1), BLANCO, 0.5f * GROSOR);
    trazaFlecha(origen, ejeI, glm::mat4(1), BLANCO, 0.5f * GROSOR);
    rotulaPunto("t", ejeT, glm::mat4(1), BLANCO, Lado::ENCIMA);
    rotulaPunto("I", ejeI, glm::mat4(1), BLANCO, Lado::DERECHA);
    glEnable(GL_DEPTH_TEST);
}

static void dibuja() {
    const glm::mat4 camara = camaraOrbita(estado.orbita), proyeccion = perspectivaVentana(0.45f, 1, 50);
    const double t = tiempo(estado.reloj);
    const float intensidad = intensidadEn(t);
    Luz luz{FUENTE};
    luz.Ld = luz.Ls = intensidad * colorEn(t);

    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    usaPrograma(estado.programa, camara, proyeccion);
    envia(estado.programa, "La", LA);
    enviaLuz(estado.programa, "luz", luz, camara);
    const auto solido = [&](const Buferes &buferes, const glm::mat4 &M, const Material &material) {
        dibujaIluminado(estado.programa, buferes, M, camara, material);
    };
    for (int i = 0; i < LADO * LADO; ++i) {
        const int columna = i % LADO, fila = i / LADO;
        const glm::vec3 centro =
            BALDOSA * (glm::vec3(columna, 0, fila) - 0.5f * float(LADO - 1) * glm::vec3(1, 0, 1));
        solido(estado.plano, traslacion(centro) * giroX(-glm::half_pi<float>()) * escalado(BALDOSA),
               BALDOSAS[(columna + fila) % 2]);
    }
    solido(estado.esfera, traslacion({0.8f, 0.7f, -0.3f}) * escalado(0.7f), BOLA);
    solido(estado.cubo, traslacion({-1.0f, 0.5f, 0.3f}) * giroY(0.4f), BOLA);
    // la bombilla no refleja: tiene, como si fuera suyo, el color de la luz
    solido(estado.esfera, traslacion(glm::vec3(FUENTE)) * escalado(0.16f), {luz.Ld / LA, {}, {}, 1});
    dibujaHalo(camara, proyeccion, luz.Ld);
    dibujaGrafica(t);

    const std::string ademas = formatea(", I = %.2f", intensidad);
    rotulaTiempo(estado.reloj, BLANCO, ademas);
    tituloAnimado(estado.reloj, "Luces animadas" + ademas);
    glutSwapBuffers();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Luces animadas", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    estado.programa = creaSombreado("phong");
    estado.halo = creaPrograma("ch12_animacion/halo.vert", "ch12_animacion/halo.frag");
    estado.plano = creaBuferes(plano(1));
    estado.esfera = creaBuferes(esfera(segmentosEsfera(150)));
    estado.cubo = creaBuferes(cubo());
    glEnable(GL_DEPTH_TEST);
    ponFondo(FONDO_OSCURO);
    glutDisplayFunc(dibuja);
    orbitaConRaton(estado.orbita);
    animaConReloj(estado.reloj);
    glutMainLoop();
    return 0;
}
