// La órbita del ratón: por mucho que se arrastre, la cámara no pasa por el polo ni se da la vuelta.
#include "orbita.h"
#include <GL/freeglut.h>
#include <cmath>
#include <gtest/gtest.h>

// El GLUT justo para que la órbita crea que hay una ventana.
void glutMouseFunc(void (*)(int, int, int, int)) {
}
void glutMotionFunc(void (*)(int, int)) {
}
void glutMouseWheelFunc(void (*)(int, int, int, int)) {
}
void glutPostRedisplay() {
}

TEST(Orbita, LaElevacionNoPasaDelPolo) {
    Orbita orbita{0.3f, 0, 5, {1, 2, 3}};
    orbitaConRaton(orbita);
    orbitaBoton(GLUT_LEFT_BUTTON, GLUT_DOWN, 100, 100);
    for (const int y : {100000, -100000, 1000000}) { // hacia arriba, hacia abajo y otra vez hacia arriba
        orbitaArrastra(100, y);
        EXPECT_LT(std::fabs(orbita.elevacion), std::acos(-1.0f) / 2);
        EXPECT_GT(std::fabs(orbita.elevacion), 1.4f); // y se llega a ver casi desde el polo
        EXPECT_EQ(orbita.elevacion > 0, y > 0);
        EXPECT_GT(camaraOrbita(orbita)[1][1], 0); // la vertical del mundo sigue hacia arriba
    }
    EXPECT_EQ(orbita.azimut, 0.3f); // arrastrar en vertical no gira
    EXPECT_NEAR(glm::length(posicionCamara(orbita) - orbita.centro), 5, 1e-5);
}
