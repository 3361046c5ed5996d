// Una página de muestras de lo que dibujan trazo y rotulo, para mirarla: build/tests/muestras -ppm muestras.ppm
#include "colores.h"
#include "recuadro.h"
#include "rotulo.h"
#include "trazo.h"
#include "ventana.h"
#include <cmath>

static void dibujaRotulos() {
    const char *const lineas[] = {"ABCDEFGHIJKLMNÑOPQRSTUVWXYZ ÁÉÍÓÚ", "abcdefghijklmnñopqrstuvwxyz áéíóúü",
                                  "0123456789 +-−×·=<>≤≥≈/%#&*^_|",    "¿? ¡! «» () [] . , : ; ' \" …",
                                  "αδθπφΦΔσ √2 90° x² y³ ←→↑↓",        "Grúa de obra: M = T · S"};
    float y = 0.93f;
    for (const char *linea : lineas) {
        rotula(linea, {0.02f, y}, OSCURO, Lado::DERECHA);
        y -= 0.09f;
    }
    const glm::vec3 colores[] = {ROJO, VERDE, AZUL, NARANJA, AMARILLO, MORADO, GRIS, OSCURO, BLANCO};
    for (int i = 0; i < 9; ++i)
        rotula("abc", {0.06f + 0.11f * static_cast<float>(i), 0.34f}, colores[i]);
    for (int i = 0; i < 5; ++i)
        rotula("Talla " + std::to_string(i + 2) + " %", {0.02f, 0.25f - 0.05f * static_cast<float>(i)}, AZUL,
               Lado::DERECHA, 0.01f * static_cast<float>(i + 2));
    rotula("dos\nlíneas", {0.8f, 0.12f}, MORADO);
}

static void dibujaTrazos(const glm::mat4 &transformacion) {
    std::vector<glm::vec3> curva, estrella;
    for (int i = 0; i <= 40; ++i)
        curva.push_back({-0.9f + 0.045f * static_cast<float>(i),
                         0.55f + 0.3f * std::sin(0.4f * static_cast<float>(i)), 0});
    for (int i = 0; i < 5; ++i)
        estrella.push_back({-0.55f + 0.35f * std::sin(2.513f * static_cast<float>(i)),
                            -0.3f + 0.35f * std::cos(2.513f * static_cast<float>(i)), 0});
    trazaPolilinea(curva, transformacion, AZUL, 20);
    trazaPolilinea(estrella, transformacion, NARANJA, 14, true);
    trazaSegmentos({{0, 0, 0}, {0.3f, 0, 0}, {0.3f, 0, 0}, {0.3f, -0.4f, 0}}, transformacion, OSCURO, 20);
    for (int i = 0; i < 8; ++i) {
        const float a = 0.785398f * static_cast<float>(i), r = 0.05f + 0.04f * static_cast<float>(i);
        trazaFlecha({0.6f, -0.4f, 0}, {0.6f + r * std::cos(a), -0.4f + r * std::sin(a), 0}, transformacion,
                    ROJO, 8);
    }
    trazaPuntos({{0.6f, -0.4f, 0}, {0, 0, 0}, {-0.9f, -0.9f, 0}}, transformacion, VERDE, 40);
    rotulaPunto("origen", {0, 0, 0}, transformacion, VERDE, Lado::ENCIMA);
    rotulaPunto("esquina", {-0.9f, -0.9f, 0}, transformacion, VERDE, Lado::DEBAJO);
    rotulaPunto("derecha", {0.6f, -0.4f, 0}, transformacion, VERDE, Lado::DERECHA);
}

static void dibuja() {
    abreRecuadro(ventanaEntera(), GRIS);
    const std::vector<Recuadro> paneles = reparte(3, 4.0f / 3);
    abreRecuadro(paneles[0], FONDO_CLARO);
    dibujaRotulos();
    abreRecuadro(paneles[1], FONDO_OSCURO);
    dibujaRotulos();
    abreRecuadro(paneles[2], CIELO);
    dibujaTrazos(paralelaVentana(1, -1, 1, aspecto(paneles[2])));
    glutSwapBuffers();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Muestras", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    glutDisplayFunc(dibuja);
    glutMainLoop();
    return 0;
}
