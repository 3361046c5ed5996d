// Las mismas dos matrices en los dos órdenes (§3.2): T(5,0,0) y S(5,5,5) aplicadas a una esfera de radio 1. Con T·S primero se
// escala y luego se traslada, y el centro acaba en x = 5; con S·T el escalado también multiplica la traslación, y acaba en
// x = 25. Gris, la esfera inicial; en línea, la intermedia. Cada tramo de la regla mide 5 unidades y empieza en x = 0.
// Controles: ratón orbita · Esc termina.
#include "ejes.h"
#include "objeto.h"
#include "orbita.h"
#include "recuadro.h"
#include "ventana.h"
#include <algorithm>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <string>

static const float RADIO_PX = 200; // la esfera en una pantalla de 1920×1080
static const float ALTURA_REGLA = -6.5f;

static struct {
    GLuint programa;
    Buferes esfera, cubo;
    Orbita orbita = {
        0, 0.3f, 19.5f, {13.2f, -0.7f, 0}}; // en paralela, `distancia` es el semiancho de la vista
} estado;

static void inicia() {
    estado.programa = creaProgramaObjeto();
    // una esfera se hunde a lo largo y a lo ancho: a cada uno, la mitad del medio píxel
    estado.esfera = creaBuferes(esfera(segmentosPara(RADIO_PX, 0.25f)));
    estado.cubo = creaBuferes(cubo());
    glEnable(GL_DEPTH_TEST);
}

// La silueta de una esfera en paralela: la circunferencia que mira a la cámara.
static void trazaSilueta(const glm::mat4 &M, const glm::mat4 &camara, const glm::mat4 &proyeccion) {
    const glm::vec4 centro = camara * M[3];
    std::vector<glm::vec3> puntos;
    for (int i = 0; i < 64; ++i) {
        const float a = glm::two_pi<float>() * static_cast<float>(i) / 64;
        puntos.push_back(glm::vec3(centro) + M[0][0] * glm::vec3(std::cos(a), std::sin(a), 0));
    }
    trazaPolilinea(puntos, proyeccion, GRIS, 5, true);
}

// M = segunda·primera: la de la derecha se aplica antes.
static void dibujaVista(const Recuadro &r, const char *nombre, const glm::mat4 &segunda,
                        const glm::mat4 &primera) {
    abreRecuadro(r, FONDO_CLARO);
    // cada vista es al menos 8/3 veces más ancha que alta en unidades de la escena, sea como sea la ventana
    const float x = estado.orbita.distancia * std::max(aspecto(r) * 3 / 8, 1.0f), y = x / aspecto(r);
    const glm::mat4 camara = camaraOrbita(estado.orbita),
                    proyeccion = glm::ortho(-x, x, -y, y, -100.0f, 200.0f);
    const GLuint p = estado.programa;
    glUseProgram(p);
    envia(p, "proyeccion", proyeccion);
    envia(p, "camara", camara);
    const glm::mat4 M = segunda * primera;
    dibujaObjeto(p, estado.esfera, M, NARANJA);
    dibujaObjeto(p, estado.esfera, glm::mat4(1), GRIS);
    for (int tramo = 0; tramo < 6; ++tramo) {
        const float inicio = 5.0f * static_cast<float>(tramo);
        dibujaObjeto(p, estado.cubo, traslacion({inicio + 2.5f, ALTURA_REGLA, 0}) * escalado({5, 0.8f, 0.8f}),
                     tramo % 2 ? BLANCO : OSCURO);
    }
    trazaSilueta(primera, camara, proyeccion);
    trazaEjes(proyeccion * camara, {30.5f, 4.5f, 4.5f});
    // la plomada cuelga del centro, que es donde M lleva el origen
    trazaSegmentos({M[3], {M[3].x, ALTURA_REGLA, 0}}, proyeccion * camara, OSCURO, 8);
    rotulaPunto("x = " + std::to_string(static_cast<int>(M[3].x)), {M[3].x, ALTURA_REGLA, 0},
                proyeccion * camara, OSCURO, Lado::DEBAJO);
    rotula(nombre, {0.5f, 0.9f}, OSCURO, Lado::CENTRO, 0.05f);
}

static void dibuja() {
    const glm::mat4 T = traslacion({5, 0, 0}), S = escalado(5);
    abreRecuadro(ventanaEntera(), GRIS);
    const std::vector<Recuadro> mitades = rejilla(1, 2);
    dibujaVista(mitades[0], "T · S", T, S);
    dibujaVista(mitades[1], "S · T", S, T);
    glutSwapBuffers();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "T·S arriba, S·T abajo", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
