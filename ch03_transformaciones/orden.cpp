// Las mismas dos matrices en los dos órdenes (§3.2): T(5,0,0) y S(5,5,5) aplicadas a una esfera de radio 1.
// Arriba T·S: primero se escala y luego se traslada, y el centro acaba en x = 5. Abajo S·T: el escalado
// también multiplica la traslación, y acaba en x = 25. Gris, la esfera inicial; en líneas, la intermedia;
// cada tramo de la regla mide 5 unidades y empieza en x = 0.
// Controles: ratón orbita · Esc termina.
#include "malla.h"
#include "orbita.h"
#include "shader.h"
#include "transformaciones.h"
#include "ventana.h"
#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

static const float RADIO_PX = 200; // la esfera en una pantalla de 1920×1080
static const glm::vec3 colorEsfera(0.95f, 0.55f, 0.10f), gris(0.55f, 0.58f, 0.62f),
    oscuro(0.16f, 0.17f, 0.20f), blanco(1, 1, 1);
static const glm::vec3 colorEje[3] = {{0.85f, 0.20f, 0.18f}, {0.20f, 0.62f, 0.28f}, {0.16f, 0.38f, 0.80f}};

static struct {
    GLuint programa;
    Buferes esfera, esferaDeLineas, cilindro, cubo;
    Orbita orbita = {0, 0.3f, 19.5f, {13, -0.7f, 0}}; // en paralela, `distancia` es el semiancho de la vista
} estado;

static void inicia() {
    estado.programa = creaPrograma("ch03_transformaciones/objeto.vert", "ch03_transformaciones/objeto.frag");
    // una esfera se hunde a lo largo y a lo ancho: a cada uno, la mitad del medio píxel
    estado.esfera = creaBuferes(esfera(segmentosPara(RADIO_PX, 0.25f)));
    estado.esferaDeLineas = creaBuferes(esfera(12));
    estado.cilindro = creaBuferes(cilindro(16));
    estado.cubo = creaBuferes(cubo());
    glEnable(GL_DEPTH_TEST);
    glClearColor(0.95f, 0.96f, 0.98f, 1);
}

static void dibujaObjeto(const Buferes &objeto, const glm::mat4 &M, const glm::vec3 &color) {
    const glm::mat3 N = matrizNormal(M);
    envia(estado.programa, "M", M);
    envia(estado.programa, "N", N);
    envia(estado.programa, "colorObjeto", color);
    dibuja(objeto);
}

// M = segunda·primera: la de la derecha se aplica antes.
static void dibujaVista(const glm::mat4 &segunda, const glm::mat4 &primera) {
    for (int eje = 0; eje < 3; ++eje)
        dibujaObjeto(estado.cilindro, ejeCoordenado(eje, eje == 0 ? 32 : 5.8f, 0.3f), colorEje[eje]);
    const glm::mat4 M = segunda * primera;
    dibujaObjeto(estado.esfera, M, colorEsfera);
    dibujaObjeto(estado.esfera, glm::mat4(1), gris);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    dibujaObjeto(estado.esferaDeLineas, primera, gris);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);

    const float alturaRegla = -6.5f;
    for (int tramo = 0; tramo < 6; ++tramo)
        dibujaObjeto(estado.cubo,
                     traslacion({5.0f * static_cast<float>(tramo) + 2.5f, alturaRegla, 0}) *
                         escalado({5, 0.8f, 0.8f}),
                     tramo % 2 ? blanco : oscuro);
    // la plomada cuelga del centro, que es donde M lleva el origen
    dibujaObjeto(estado.cilindro, traslacion({M[3].x, alturaRegla, 0}) * ejeCoordenado(1, -alturaRegla, 0.3f),
                 oscuro);
}

static void dibuja() {
    const int ancho = std::max(glutGet(GLUT_WINDOW_WIDTH), 1),
              alto = std::max(glutGet(GLUT_WINDOW_HEIGHT) / 2, 1);
    const glm::mat4 T = traslacion({5, 0, 0}), S = escalado(5);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(estado.programa);
    glLineWidth(static_cast<float>(std::max(alto / 150, 1)));
    // cada vista es al menos 8/3 veces más ancha que alta en unidades de la escena, sea como sea la ventana
    const float aspecto = static_cast<float>(ancho) / static_cast<float>(alto);
    const float x = estado.orbita.distancia * std::max(aspecto * 3 / 8, 1.0f), y = x / aspecto;
    const glm::mat4 camara = glm::ortho(-x, x, -y, y, -100.0f, 200.0f) * camaraOrbita(estado.orbita);
    envia(estado.programa, "camara", camara);
    glViewport(0, alto, ancho, alto);
    dibujaVista(T, S);
    glViewport(0, 0, ancho, alto);
    dibujaVista(S, T);
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
