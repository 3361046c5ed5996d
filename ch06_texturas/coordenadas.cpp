// Coordenadas de textura (§6.4, figura 6.3): un atributo más de cada vértice, que decide qué parte de la imagen le
// toca. A la izquierda, la imagen; a la derecha, el objeto, con los mismos ejes y los mismos puntos (s, t). En el cubo
// cada cara tiene la imagen entera, derecha. En el cilindro y la esfera s es el ángulo y la imagen se junta consigo
// misma; en las tapas es un círculo.
// Controles: 1 cubo · 2 cilindro · 3 esfera · ratón orbita · Esc termina.
#include "buferes.h"
#include "ch03_transformaciones/transformaciones.h"
#include "colores.h"
#include "imagen.h"
#include "malla.h"
#include "modos.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "textura.h"
#include "trazo.h"
#include "ventana.h"
#include <algorithm>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

static const int SEGMENTOS = 128;
static const glm::vec2 P(0.18f, 0.64f); // en medio de la casilla A3 de la carta

// El punto de la superficie que tiene esas coordenadas de textura, en coordenadas del objeto y `alza` veces más lejos
// del centro; el de la imagen, por delante.
using Superficie = glm::vec3 (*)(float s, float t, float alza);
static glm::vec3 enImagen(float s, float t, float alza) {
    return {s - 0.5f, t - 0.5f, alza - 1};
}
static glm::vec3 enCubo(float s, float t, float alza) { // en su cara +Z
    return alza * glm::vec3(s - 0.5f, t - 0.5f, 0.5f);
}
static glm::vec3 enCilindro(float s, float t, float alza) {
    const float angulo = glm::two_pi<float>() * s;
    return alza * glm::vec3(std::cos(angulo), std::sin(angulo), t - 0.5f);
}
static glm::vec3 enEsfera(float s, float t, float alza) {
    const float latitud = glm::pi<float>() * (t - 0.5f);
    const float radio = std::cos(latitud);
    const glm::vec3 p = enCilindro(s, t, alza);
    return {radio * p.x, radio * p.y, alza * std::sin(latitud)};
}

struct Objeto {
    const char *nombre;
    Superficie superficie;
    Buferes buferes;
    glm::mat4 M;
};
static struct {
    GLuint programa, textura;
    Objeto imagen, objetos[3];
    int elegido = 0;
    Orbita orbita = {0.6f, 0.45f, 5.6f, {0, 0, 0}};
} estado;

// Para quien mira una cara de frente, s crece hacia la derecha y t hacia `arriba`.
static Malla cuboConCoordenadas() {
    Malla malla = cubo();
    for (Vertice &v : malla.vertices) {
        const glm::vec3 arriba = v.normal.y == 0 ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, -v.normal.y);
        const glm::vec3 derecha = glm::cross(arriba, v.normal);
        v.coordTextura = 0.5f + glm::vec2(glm::dot(v.posicion, derecha), glm::dot(v.posicion, arriba));
    }
    return malla;
}

static void inicia(const Imagen &imagen) {
    estado.programa = creaPrograma("ch06_texturas/textura_objeto.vert", "ch06_texturas/coordenadas.frag");
    // los ejes del cilindro y de la esfera, a la vertical, y la costura (s = 0 y s = 1), a la vista
    const glm::mat4 depie = giroY(-1.45f) * giroX(-glm::half_pi<float>());
    estado.imagen = {"Imagen", enImagen, creaBuferes(plano(1)), glm::mat4(1)};
    estado.objetos[0] = {"Cubo", enCubo, creaBuferes(cuboConCoordenadas()), escalado(1.65f)};
    estado.objetos[1] = {"Cilindro", enCilindro, creaBuferes(cilindro(SEGMENTOS)),
                         depie * escalado({0.95f, 0.95f, 1.9f})};
    estado.objetos[2] = {"Esfera", enEsfera, creaBuferes(esfera(SEGMENTOS)), depie * escalado(1.35f)};
    estado.textura = creaTextura2D(imagen);
    glEnable(GL_DEPTH_TEST);
    ponFondo(FONDO_CLARO);
}

// El punto P y sus dos guías: hasta t = 0, que dice su s, y hasta s = 0, que dice su t.
static void dibujaMarcas(Superficie superficie, const glm::mat4 &transformacion) {
    const auto encima = [&](const glm::vec2 &st) { return superficie(st.s, st.t, 1.01f); };
    const auto guia = [&](const glm::vec2 &fin, const glm::vec3 &color) {
        std::vector<glm::vec3> camino;
        for (int i = 0; i <= 24; ++i)
            camino.push_back(encima(glm::mix(P, fin, float(i) / 24)));
        trazaPolilinea(camino, transformacion, color, 10);
    };
    guia({P.s, 0}, ROJO);
    guia({0, P.t}, VERDE);
    trazaPuntos({encima(P)}, transformacion, OSCURO, 30);
    const auto enVentana = [&](const glm::vec2 &st) {
        const glm::vec4 p = transformacion * glm::vec4(encima(st), 1);
        return glm::vec3(glm::vec2(p) / p.w, 0);
    };
    // por detrás, s y t giran al revés
    const glm::vec3 p = enVentana(P);
    if (glm::cross(enVentana(P + glm::vec2(0.01f, 0)) - p, enVentana(P + glm::vec2(0, 0.01f)) - p).z < 0)
        return;
    rotulaPunto("P", encima(P), transformacion, OSCURO, Lado::DERECHA);
    rotulaPunto("s", encima({P.s, 0}), transformacion, ROJO, Lado::DEBAJO);
    rotulaPunto("t", encima({0, P.t}), transformacion, VERDE, Lado::IZQUIERDA);
}

static void dibujaTexturado(const Objeto &objeto, const glm::mat4 &camara, const glm::mat4 &proyeccion) {
    envia(estado.programa, "proyeccion", proyeccion);
    envia(estado.programa, "camara", camara);
    envia(estado.programa, "M", objeto.M);
    envia(estado.programa, "N", matrizNormal(objeto.M));
    envia(estado.programa, "repeticiones", glm::vec2(1));
    envia(estado.programa, "Img", 0);
    dibujaMalla(objeto.buferes);
    dibujaMarcas(objeto.superficie, proyeccion * camara * objeto.M);
}

static void dibuja() {
    const Recuadro v = ventanaEntera();
    const int ancho = std::min(v.ancho * 2 / 5, v.alto * 3 / 5);
    const Recuadro izquierda = {0, 0, ancho, v.alto}, derecha = {ancho, 0, v.ancho - ancho, v.alto};
    const Objeto &objeto = estado.objetos[estado.elegido];
    glUseProgram(estado.programa);
    glBindTexture(GL_TEXTURE_2D, estado.textura);
    abreRecuadro(izquierda);
    ponFondo(FONDO_CLARO);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const glm::mat4 deFrente = paralelaVentana(0.48f, -1, 1, aspecto(izquierda));
    dibujaTexturado(estado.imagen, glm::mat4(1), deFrente);
    rotulaPunto("s = 0.18\nt = 0.64", {0, -0.66f, 0}, deFrente, OSCURO, Lado::DEBAJO);
    abreRecuadro(derecha);
    ponFondo(FONDO_CLARO);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    dibujaTexturado(objeto, camaraOrbita(estado.orbita),
                    perspectivaVentana(0.5f, 0.1f, 100, aspecto(derecha), 1));
    ponTitulo(std::string("Coordenadas de textura: ") + objeto.nombre);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (!teclaComun(tecla))
        eligeModo(estado.elegido, 3, tecla);
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Coordenadas de textura", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE,
                "[FOTO.ppm | FOTO.rgb -talla ANCHOxALTO]");
    inicia(imagenDeArgumentos(argc, argv, "assets/carta.rgb", 256, 256));
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
