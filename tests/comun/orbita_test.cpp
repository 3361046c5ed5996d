// La órbita del ratón: no pasa por el polo, no se pierde de vista y gira lo mismo en una ventana de cualquier tamaño.
#include "orbita.h"
#include "ventana.h"
#include <cmath>
#include <gtest/gtest.h>

namespace {

class Raton : public testing::Test {
protected:
    static void SetUpTestSuite() {
        static char nombre[] = "orbita";
        static char *argv[] = {nombre, nullptr};
        int argc = 1;
        abreVentana(argc, argv, "Órbita", GLUT_DOUBLE);
    }
    Raton() {
        glutReshapeWindow(240, 180);
        orbitaConRaton(orbita);
    }
    static void arrastra(int dx, int dy) {
        orbitaBoton(GLUT_LEFT_BUTTON, GLUT_DOWN, 100, 100);
        orbitaArrastra(100 + dx, 100 + dy);
        orbitaBoton(GLUT_LEFT_BUTTON, GLUT_UP, 100 + dx, 100 + dy);
    }
    Orbita orbita{0.3f, 0, 5, {1, 2, 3}};
};

TEST_F(Raton, LaElevacionNoPasaDelPolo) {
    for (const int y : {100000, -100000, 1000000}) { // hacia arriba, hacia abajo y otra vez hacia arriba
        arrastra(0, y);
        EXPECT_LT(std::fabs(orbita.elevacion), std::acos(-1.0f) / 2);
        EXPECT_GT(std::fabs(orbita.elevacion), 1.4f); // y se llega a ver casi desde el polo
        EXPECT_EQ(orbita.elevacion > 0, y > 0);
        EXPECT_GT(camaraOrbita(orbita)[1][1], 0); // la vertical del mundo sigue hacia arriba
    }
    EXPECT_EQ(orbita.azimut, 0.3f); // arrastrar en vertical no gira
    EXPECT_NEAR(glm::length(posicionCamara(orbita) - orbita.centro), 5, 1e-5);
}

TEST_F(Raton, ConSueloNoSeVeDesdeDebajo) {
    orbita.elevacionMinima = 0.05f;
    arrastra(0, -1000);
    EXPECT_EQ(orbita.elevacion, 0.05f);
}

TEST_F(Raton, LaRuedaTieneTopes) {
    for (int i = 0; i < 100; ++i)
        orbitaRueda(0, -1, 0, 0);
    EXPECT_NEAR(orbita.distancia, 12.5, 1e-4);
    for (int i = 0; i < 100; ++i)
        orbitaRueda(0, 1, 0, 0);
    EXPECT_NEAR(orbita.distancia, 2, 1e-4);
}

TEST_F(Raton, SoloElBotonIzquierdo) {
    orbitaBoton(GLUT_RIGHT_BUTTON, GLUT_DOWN, 0, 0);
    orbitaArrastra(50, 50);
    EXPECT_EQ(orbita.azimut, 0.3f);
}

} // namespace
