// La matriz del modelo cambia con el tiempo (§12.1), y con ella la posición, el tamaño o la orientación del objeto: la
// malla y el shader son siempre los mismos. Con líneas, el objeto en instantes anteriores; en morado, el camino de su
// punta.
// Controles: 1 posición · 2 tamaño · 3 orientación · espacio pausa · s adelanta medio segundo · d una décima ·
// h diez horas · ratón orbita · Esc termina.
#include "animacion.h"
#include "ch03_transformaciones/objeto.h"
#include "matriz.h"
#include "modos.h"
#include "orbita.h"
#include "proyeccion.h"
#include "trazo.h"
#include <glm/gtc/constants.hpp>

static const double PERIODO = 6, ENTRE_ESTELAS = 0.35; // segundos
static const int ESTELAS = 4;
static const struct {
    const char *nombre, *matriz;
    glm::mat4 (*M)(float a); // a: de 0 a 2π en un periodo
} MODOS[] = {
    {"posición", "T(1.5 cos a, 0, −1.5 sen a) =",
     [](float a) { return traslacion(glm::vec3(1.5f * std::cos(a), 0, -1.5f * std::sin(a))); }},
    {"tamaño", "S(1 + 0.5 sen a) =", [](float a) { return escalado(1 + 0.5f * std::sin(a)); }},
    {"orientación", "Ry(a) =", giroY},
};
static const glm::vec3 PUNTA(1.7f, 0, 0), BASE[4] = {{-1.2f, -0.4f, 1},
                                                     {-1.2f, -0.4f, -1},
                                                     {-1.2f, 0.4f, -1},
                                                     {-1.2f, 0.4f, 1}};

static struct {
    GLuint programa;
    Buferes piramide;
    std::vector<glm::vec3> aristas; // dos extremos cada una
    int elegido = 0;
    Orbita orbita = {0.35f, 0.5f, 10.8f, {0.1f, 0.75f, 0}};
    Reloj reloj;
} estado;

static void inicia() {
    Malla malla;
    const auto cara = [&](const glm::vec3 &a, const glm::vec3 &b, const glm::vec3 &c) {
        for (const glm::vec3 &vertice : {a, b, c}) {
            malla.indices.push_back(unsigned(malla.vertices.size()));
            malla.vertices.push_back({vertice, glm::normalize(glm::cross(b - a, c - a)), {}});
        }
    };
    for (int i = 0; i < 4; ++i) {
        const glm::vec3 &siguiente = BASE[(i + 1) % 4];
        cara(BASE[i], siguiente, PUNTA);
        estado.aristas.insert(estado.aristas.end(), {BASE[i], siguiente, BASE[i], PUNTA});
    }
    cara(BASE[2], BASE[1], BASE[0]);
    cara(BASE[3], BASE[2], BASE[0]);
    estado.piramide = creaBuferes(malla);
    estado.programa = creaProgramaObjeto();
    glEnable(GL_DEPTH_TEST);
    ponFondo(FONDO_CLARO);
}

static glm::mat4 matrizEn(double t) {
    return MODOS[estado.elegido].M(glm::two_pi<float>() * fase(t, PERIODO));
}

static void dibuja() {
    const auto &modo = MODOS[estado.elegido];
    const double t = tiempo(estado.reloj);
    const glm::mat4 camara = camaraOrbita(estado.orbita), proyeccion = perspectivaVentana(0.5f, 1, 50),
                    M = matrizEn(t);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    usaPrograma(estado.programa, camara, proyeccion);
    dibujaObjeto(estado.programa, estado.piramide, M, NARANJA);

    std::vector<glm::vec3> camino;
    for (int i = 0; i < 90; ++i)
        camino.push_back(matrizEn(PERIODO * i / 90) * glm::vec4(PUNTA, 1));
    trazaPolilinea(camino, proyeccion * camara, MORADO, GROSOR, true);
    for (int k = ESTELAS; k > 0; --k) // cuanto más antiguas, más claras
        trazaSegmentos(estado.aristas, proyeccion * camara * matrizEn(t - k * ENTRE_ESTELAS),
                       glm::mix(GRIS, FONDO_CLARO, float(k - 1) / ESTELAS));
    trazaPuntos({M * glm::vec4(PUNTA, 1)}, proyeccion * camara, MORADO);

    rotula(modo.matriz, {0.03f, 0.95f}, OSCURO, Lado::DERECHA);
    rotula(filasDe(M), {0.03f, 0.79f}, OSCURO, Lado::DERECHA);
    rotulaTiempo(estado.reloj, OSCURO);
    tituloAnimado(estado.reloj, std::string("Matriz del modelo: ") + modo.nombre);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (!teclaAnimacion(estado.reloj, tecla))
        eligeModo(estado.elegido, 3, tecla);
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Matriz del modelo", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    orbitaConRaton(estado.orbita);
    animaConReloj(estado.reloj);
    glutKeyboardFunc(teclado);
    glutMainLoop();
    return 0;
}
