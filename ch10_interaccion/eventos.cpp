// Los sucesos de §10.1: teclado, teclas especiales, botones, arrastre, movimiento, rueda y tamaño. Cada uno se escribe
// en stdout tal como lo recibe su función (su callback) y se ve en la ventana: los últimos, el rastro del puntero y los
// botones pulsados.
// Controles: cualquier tecla, el ratón y el tamaño de la ventana · Esc termina.
#include "colores.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "trazo.h"
#include "ventana.h"
#include <cstdio>
#include <map>

static const std::map<int, std::string> TECLAS = {{8, "Retroceso"}, {9, "Tab"},      {13, "Intro"},
                                                  {27, "Esc"},      {32, "Espacio"}, {127, "Supr"}};
static const std::map<int, std::string> ESPECIALES = {
    {GLUT_KEY_LEFT, "IZQUIERDA"}, {GLUT_KEY_RIGHT, "DERECHA"},   {GLUT_KEY_UP, "ARRIBA"},
    {GLUT_KEY_DOWN, "ABAJO"},     {GLUT_KEY_HOME, "INICIO"},     {GLUT_KEY_END, "FIN"},
    {GLUT_KEY_PAGE_UP, "REPAG"},  {GLUT_KEY_PAGE_DOWN, "AVPAG"}, {GLUT_KEY_INSERT, "INSERTAR"}};
static const char *const BOTONES[] = {"izquierdo", "central", "derecho"};
static const std::size_t ULTIMOS = 9, LARGO_RASTRO = 400;

static struct {
    std::vector<std::string> sucesos;
    struct Paso {
        glm::vec2 lugar; // píxeles, desde arriba
        bool arrastrando;
    };
    std::vector<Paso> rastro;
    bool pulsado[3] = {};
} estado;

static void anota(const std::string &suceso) {
    std::printf("%s\n", suceso.c_str());
    std::fflush(stdout);
    const auto clase = [](const std::string &s) { return s.substr(0, s.find(' ')); };
    std::vector<std::string> &s = estado.sucesos;
    // un movimiento son muchos sucesos: en la ventana se ve el último
    if (!s.empty() && clase(s.back()) == clase(suceso) &&
        (clase(suceso) == "movimiento" || clase(suceso) == "arrastre"))
        s.pop_back();
    s.push_back(suceso);
    if (s.size() > ULTIMOS)
        s.erase(s.begin());
    ponTitulo("Eventos: " + suceso);
    glutPostRedisplay();
}

static std::string en(int x, int y) {
    return " " + std::to_string(x) + " " + std::to_string(y);
}

static void teclado(unsigned char tecla, int x, int y) {
    const auto conNombre = TECLAS.find(tecla);
    std::string nombre = std::to_string(tecla);
    if (conNombre != TECLAS.end())
        nombre = conNombre->second;
    else if (tecla > 32 && tecla < 127)
        nombre = std::string(1, char(tecla));
    anota("tecla " + nombre + en(x, y));
    teclaComun(tecla);
}

static void especial(int tecla, int x, int y) {
    const auto conNombre = ESPECIALES.find(tecla);
    std::string nombre = std::to_string(tecla);
    if (conNombre != ESPECIALES.end())
        nombre = conNombre->second;
    else if (tecla >= GLUT_KEY_F1 && tecla <= GLUT_KEY_F12)
        nombre = "F" + std::to_string(tecla - GLUT_KEY_F1 + 1);
    anota("especial " + nombre + en(x, y));
    teclaEspecialComun(tecla);
}

static void apunta(int x, int y, bool arrastrando) {
    estado.rastro.push_back({{x, y}, arrastrando});
    if (estado.rastro.size() > LARGO_RASTRO)
        estado.rastro.erase(estado.rastro.begin());
}

static void boton(int cual, int movimiento, int x, int y) {
    if (cual > GLUT_RIGHT_BUTTON)
        return;
    estado.pulsado[cual] = movimiento == GLUT_DOWN;
    anota(std::string("botón ") + BOTONES[cual] + (estado.pulsado[cual] ? " abajo" : " arriba") + en(x, y));
}

static void arrastre(int x, int y) {
    apunta(x, y, true);
    anota("arrastre" + en(x, y));
}

static void mueve(int x, int y) {
    apunta(x, y, false);
    anota("movimiento" + en(x, y));
}

static void rueda(int, int direccion, int x, int y) {
    anota(std::string("rueda ") + (direccion > 0 ? "+1" : "-1") + en(x, y));
}

static void cambiaTamano(int ancho, int alto) {
    anota("tamaño" + en(ancho, alto));
}

// El centro del píxel, en coordenadas normalizadas del dispositivo: la Y de GLUT crece hacia abajo.
static glm::vec3 normalizado(const glm::vec2 &p) {
    const Recuadro v = ventanaEntera();
    return {2 * (p.x + 0.5f) / float(v.ancho) - 1, 1 - 2 * (p.y + 0.5f) / float(v.alto), 0};
}

static void dibujaRastro() {
    std::vector<glm::vec3> tramos[2];
    for (std::size_t i = 1; i < estado.rastro.size(); ++i)
        for (const std::size_t k : {i - 1, i})
            tramos[estado.rastro[i].arrastrando].push_back(normalizado(estado.rastro[k].lugar));
    trazaSegmentos(tramos[0], glm::mat4(1), GRIS, 1.5f * GROSOR);
    trazaSegmentos(tramos[1], glm::mat4(1), NARANJA, 3 * GROSOR);
    if (!estado.rastro.empty())
        trazaPuntos({normalizado(estado.rastro.back().lugar)}, glm::mat4(1), ROJO, 5 * GROSOR);
}

// El ratón visto desde arriba, en un cuadrado arriba a la derecha: los botones pulsados, en naranja.
static void dibujaRaton() {
    const Recuadro v = ventanaEntera();
    const int lado = int(0.46f * altoUtil());
    abreRecuadro({v.ancho - lado, v.alto - lado, lado, lado});
    const auto caja = [](float x0, float y0, float x1, float y1, const glm::vec3 &color) {
        trazaPoligono({{x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y1, 0}}, glm::mat4(1), color);
    };
    caja(-0.55f, -0.8f, 0.55f, 0.8f, OSCURO);
    caja(-0.5f, -0.75f, 0.5f, 0.1f, BLANCO);
    for (int i = 0; i < 3; ++i) {
        const float x = -0.5f + 0.35f * float(i);
        caja(x, 0.15f, x + 0.3f, 0.75f, estado.pulsado[i] ? NARANJA : BLANCO);
    }
    abreRecuadro(v);
}

static void dibuja() {
    abreRecuadro(ventanaEntera());
    ponFondo(FONDO_CLARO);
    glClear(GL_COLOR_BUFFER_BIT);
    dibujaRastro();
    dibujaRaton();
    const float renglon = 0.1f * altoUtil() / float(ventanaEntera().alto);
    for (std::size_t i = 0; i < estado.sucesos.size(); ++i)
        rotula(estado.sucesos[i], {0.03f, 1 - (float(i) + 0.8f) * renglon},
               i + 1 == estado.sucesos.size() ? AZUL : OSCURO, Lado::DERECHA, 0.038f);
    glutSwapBuffers();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Eventos", GLUT_DOUBLE | GLUT_MULTISAMPLE);
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    glutSpecialFunc(especial);
    glutMouseFunc(boton);
    glutMotionFunc(arrastre);
    glutPassiveMotionFunc(mueve);
    glutMouseWheelFunc(rueda);
    glutReshapeFunc(cambiaTamano);
    glutMainLoop();
    return 0;
}
