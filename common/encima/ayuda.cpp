#include "ayuda.h"
#include "captura.h"
#include "colores.h"
#include "encima.h"
#include "error.h"
#include "imagen.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "texto.h"
#include <GL/glew.h>
#include <GL/freeglut.h>
#include <algorithm>
#include <cstdio>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

namespace {

const float TALLA = 0.032f; // con que los controles de cualquiera caben enteros a 4:3
const int MS_VIGILA = 250, MS_AVISO = 2000, LINEAS_DE_ERROR = 6;

struct {
    bool ayuda = false, puntero = false, vigila = false, captura = false;
    glm::ivec2 raton{-1}; // píxeles, desde arriba a la izquierda
    int vueltas = 0;      // las veces que se ha puesto a vigilar
    std::string errores, aviso;
    void (*arrastre)(int, int) = nullptr; // las del programa
    void (*movimiento)(int, int) = nullptr;
} estado;

// De cada programa de este binario: en la página están todos. Es de una función porque se llena antes de main.
std::map<std::string, std::string> &apuntados() {
    static std::map<std::string, std::string> suyos;
    return suyos;
}

const char *const DE_TODOS =
    "F1\testa ayuda · F2\tel píxel bajo el puntero · F3\tvigila los shaders · F5\tlos relee · "
    "F11\tpantalla completa · F12\tguarda la imagen";

std::vector<std::string> separa(const std::string &texto, const std::string &separador) {
    std::vector<std::string> partes;
    std::size_t desde = 0, hasta;
    while ((hasta = texto.find(separador, desde)) != std::string::npos) {
        partes.push_back(texto.substr(desde, hasta - desde));
        desde = hasta + separador.size();
    }
    partes.push_back(texto.substr(desde));
    return partes;
}

int letrasDe(const std::string &texto) {
    return int(std::count_if(texto.begin(), texto.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

/// Las primeras letras de un texto.
std::string corta(const std::string &texto, int letras) {
    std::size_t i = 0;
    for (; i < texto.size() && (letras > 0 || (texto[i] & 0xC0) == 0x80); ++i)
        letras -= (texto[i] & 0xC0) != 0x80;
    return texto.substr(0, i);
}

/// Un texto en líneas de esas letras; una palabra que no cabe en una se corta.
std::vector<std::string> parte(const std::string &texto, int letras) {
    std::vector<std::string> lineas(1);
    std::istringstream palabras(texto);
    for (std::string palabra; palabras >> palabra;) {
        palabra = corta(palabra, letras);
        if (lineas.back().empty())
            lineas.back() = palabra;
        else if (letrasDe(lineas.back()) + 1 + letrasDe(palabra) <= letras)
            lineas.back() += " " + palabra;
        else
            lineas.push_back(palabra);
    }
    return lineas;
}

// Tapa el 85 % de la imagen: el atlas vale 0 en su esquina, y encima.frag le suma ½.
void pintaVelo() {
    const VerticePintado a{{-1, -1, 0}, {0, 0}}, b{{1, -1, 0}, {0, 0}}, c{{1, 1, 0}, {0, 0}},
        d{{-1, 1, 0}, {0, 0}};
    pintaEncima({"velo", OSCURO, 0, {}, ""}, {a, b, c, a, c, d}, {{OSCURO, -0.35f, 1}}, false);
}

std::vector<std::string> controles() {
    const auto suyos = apuntados().find(nombrePrograma());
    return separa((suyos == apuntados().end() ? "" : suyos->second + " · ") + DE_TODOS, " · ");
}

// Dos columnas: son dos rótulos de las mismas líneas, cada uno con los blancos del otro.
void pintaAyuda() {
    const int caben = letrasQueCaben(TALLA);
    int ancho = 0;
    std::vector<std::vector<std::string>> filas;
    for (const std::string &control : controles()) {
        filas.push_back(separa(control, "\t"));
        ancho = std::max(ancho, letrasDe(filas.back()[0]));
    }
    std::string mandos, hacen;
    int largo = 0;
    std::vector<std::pair<std::string, std::string>> lineas;
    for (const auto &fila : filas) {
        std::string mando = fila[0];
        for (const std::string &linea : parte(fila.size() > 1 ? fila[1] : "", caben - ancho - 2)) {
            lineas.emplace_back(mando, linea);
            largo = std::max(largo, letrasDe(linea));
            mando.clear();
        }
    }
    const auto blancos = [](int cuantos) { return std::string(std::size_t(std::max(cuantos, 0)), ' '); };
    for (const auto &[mando, hace] : lineas) {
        const std::string fin = mandos.empty() ? "" : "\n";
        mandos += fin + blancos(ancho - letrasDe(mando)) + mando + blancos(2 + largo);
        hacen += fin + blancos(ancho + 2) + hace + blancos(largo - letrasDe(hace));
    }
    pintaVelo();
    rotula(mandos, {0.5f, 0.5f}, NARANJA, Lado::CENTRO, TALLA);
    rotula(hacen, {0.5f, 0.5f}, BLANCO, Lado::CENTRO, TALLA);
}

// «x, y» como los da GLUT y el color de ese píxel, al lado de él.
void pintaPuntero() {
    const Imagen imagen = leeVentana();
    const glm::ivec2 p = estado.raton;
    if (p.x < 0 || p.y < 0 || p.x >= imagen.ancho || p.y >= imagen.alto)
        return;
    const unsigned char *rgb = &imagen.rgb[3 * (std::size_t(imagen.alto - 1 - p.y) * imagen.ancho + p.x)];
    const glm::vec2 lugar = (glm::vec2(p) + 0.5f) / glm::vec2(imagen.ancho, imagen.alto);
    rotula(formatea("%d, %d\n(%d, %d, %d)", p.x, p.y, rgb[0], rgb[1], rgb[2]), {lugar.x, 1 - lugar.y}, OSCURO,
           Lado::DERECHA, TALLA);
}

// Abajo, sobre un velo que no tapa el resto. Enteros están en stderr.
void pintaErrores() {
    std::string texto;
    int n = 0;
    for (const std::string &error : separa(estado.errores, "\n"))
        for (const std::string &linea : parte(error, letrasQueCaben(TALLA)))
            if (n < LINEAS_DE_ERROR)
                texto += (n++ ? "\n" : "") + linea;
    const Recuadro ventana = ventanaEntera();
    const int alto = std::min(int(float(n + 1) * 1.5f * TALLA * altoUtil()), ventana.alto);
    glViewport(0, 0, ventana.ancho, alto);
    pintaVelo();
    rotula(texto, {0.5f, 0.5f}, BLANCO, Lado::CENTRO, TALLA);
}

void pintaSobreLaImagen() {
    GLint panel[4];
    glGetIntegerv(GL_VIEWPORT, panel);
    glViewport(0, 0, glutGet(GLUT_WINDOW_WIDTH), glutGet(GLUT_WINDOW_HEIGHT));
    if (estado.puntero)
        pintaPuntero();
    if (estado.ayuda)
        pintaAyuda();
    if (!estado.aviso.empty())
        rotula(estado.aviso, {0.5f, 0}, NARANJA, Lado::CENTRO, TALLA);
    if (!estado.errores.empty())
        pintaErrores();
    glViewport(panel[0], panel[1], panel[2], panel[3]);
}

void callaAviso(int) {
    estado.aviso.clear();
    glutPostRedisplay();
}

// Se ve un rato.
void anuncia(const char *aviso) {
    estado.aviso = aviso;
    glutTimerFunc(MS_AVISO, callaAviso, 0);
}

void sigueAlRaton(int x, int y) {
    estado.raton = {x, y};
    estado.aviso.clear();
    glutPostRedisplay();
}

void vigila(int vuelta) {
    if (!estado.vigila || vuelta != estado.vueltas)
        return;
    if (hanCambiadoLosShaders()) {
        estado.errores = recargaProgramas();
        glutPostRedisplay();
    }
    glutTimerFunc(MS_VIGILA, vigila, vuelta);
}

} // namespace

bool apuntaControles(const char *programa, const char *suyos) {
    return apuntados().emplace(programa, suyos).second;
}

std::string controlesDelPrograma() {
    std::string lineas;
    for (const std::string &control : controles()) {
        const std::size_t t = control.find('\t'); // hay quien solo dice lo que hace
        lineas +=
            (lineas.empty() ? "" : "\n") + control.substr(0, t) + (t ? " " : "") + control.substr(t + 1);
    }
    return lineas;
}

void cambiaAyuda() {
    estado.ayuda = !estado.ayuda;
}

// common/comun.cmake enlaza con --wrap: un programa llama a estas, y aquí las de GLUT son __real_….
extern "C" {
void __real_glutSwapBuffers();
void __real_glutMotionFunc(void (*)(int, int));
void __real_glutPassiveMotionFunc(void (*)(int, int));

void __wrap_glutSwapBuffers() {
    glDisable(GL_SCISSOR_TEST); // lo dejó puesto abreRecuadro, y lo que viene no es de su panel
    if (estado.puntero || estado.ayuda || !estado.aviso.empty() || !estado.errores.empty())
        pintaSobreLaImagen();
    if (std::exchange(estado.captura, false))
        guardaVentana();
    __real_glutSwapBuffers();
}

void __wrap_glutMotionFunc(void (*f)(int, int)) {
    estado.arrastre = f;
    if (!estado.puntero)
        __real_glutMotionFunc(f);
}

void __wrap_glutPassiveMotionFunc(void (*f)(int, int)) {
    estado.movimiento = f;
    if (!estado.puntero)
        __real_glutPassiveMotionFunc(f);
}
}

void pideCaptura() {
    estado.captura = true;
}

void cambiaPuntero() {
    estado.puntero = !estado.puntero;
    estado.raton = glm::ivec2(-1); // dónde está no se sabe hasta que se mueva
    estado.aviso.clear();
    if (!estado.puntero) {
        __real_glutMotionFunc(estado.arrastre);
        __real_glutPassiveMotionFunc(estado.movimiento);
        return;
    }
    anuncia("mueve el ratón");
    __real_glutMotionFunc([](int x, int y) {
        sigueAlRaton(x, y);
        if (estado.arrastre)
            estado.arrastre(x, y);
    });
    __real_glutPassiveMotionFunc([](int x, int y) {
        sigueAlRaton(x, y);
        if (estado.movimiento)
            estado.movimiento(x, y);
    });
}

void cambiaVigilancia() {
    estado.vigila = !estado.vigila;
    anuncia(estado.vigila ? "vigilo los shaders" : "ya no vigilo los shaders");
    std::puts(estado.aviso.c_str());
    std::fflush(stdout);
    estado.errores.clear();
    if (estado.vigila)
        vigila(++estado.vueltas);
}
