// La superficie de Bézier (ecuaciones 11.40 y 11.41, figura 11.2) y los 16 puntos de control que la definen. Se parte
// en los triángulos que bastan para no separarse de ella más de una tolerancia en píxeles.
// Controles: arrastra los puntos (o n y flechas) · m malla · + - mitad o doble de tolerancia · ratón orbita ·
// Esc termina.
#include "lamina.h"
#include "rotulo.h"
#include "trazo.h"
#include <cstdio>
#include <string>

static const double TOLERANCIA_MINIMA = 0.125, TOLERANCIA_MAXIMA = 64;

static struct {
    std::vector<glm::vec3> P = {
        {-1.5f, 0.1f, 1.5f}, {-1.5f, 0.8f, 0.5f}, {-1.5f, 0.5f, -0.5f}, {-1.5f, -0.1f, -1.5f},
        {-0.5f, 0.5f, 1.5f}, {-0.5f, 1.5f, 0.5f}, {-0.5f, 0.3f, -0.5f}, {-0.5f, -0.3f, -1.5f},
        {0.5f, -0.2f, 1.5f}, {0.5f, -0.2f, 0.5f}, {0.5f, -1.3f, -0.5f}, {0.5f, 0.2f, -1.5f},
        {1.5f, -0.5f, 1.5f}, {1.5f, 0.2f, 0.5f},  {1.5f, 0.3f, -0.5f},  {1.5f, 0.7f, -1.5f}};
    double tolerancia = 0.5; // píxeles
    bool malla = false;
    Lamina lamina;
    Editor editor;
} estado;

static glm::mat4 vista() {
    return vistaLamina(estado.lamina);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const Geometria2<float> G = geometriaDeRed(estado.P, 4);
    const Malla malla =
        mallaSuperficie(Base::BEZIER, G, segmentosLamina(estado.lamina, Base::BEZIER, G, estado.tolerancia));
    dibujaLamina(estado.lamina, malla, LAMINA_AZUL);
    char texto[60];
    std::snprintf(texto, sizeof texto, "hasta %g px: %zu triángulos", estado.tolerancia,
                  malla.indices.size() / 3);
    if (estado.malla) {
        std::vector<glm::vec3> lados;
        for (std::size_t i = 0; i < malla.indices.size(); i += 3)
            for (std::size_t k = 0; k < 3; ++k)
                for (const std::size_t extremo : {k, (k + 1) % 3})
                    lados.push_back(malla.vertices[malla.indices[i + extremo]].posicion);
        trazaSegmentos(lados, vista(), BLANCO, 0.5f * GROSOR);
        rotula(texto, {0.5f, 0.94f}, OSCURO);
    } else {
        glDisable(GL_DEPTH_TEST); // la red, entera, también por detrás de la superficie
        trazaSegmentos(redDeControl(estado.P, 4), vista(), GRIS, 0.7f * GROSOR);
        trazaPuntos(estado.P, vista(), ROJO, 3.5f * GROSOR);
        glEnable(GL_DEPTH_TEST);
        for (std::size_t k = 0; k < 16; ++k)
            if (k == 0 || k == 3 || k == 12 || k == 15 || int(k) == estado.editor.elegido)
                rotulaPunto("P" + std::to_string(k / 4) + std::to_string(k % 4), estado.P[k], vista(),
                            colorNombre(estado.editor, k), k == 0 || k == 12 ? Lado::DEBAJO : Lado::ENCIMA);
    }
    ponTitulo("Superficie de Bézier: " + std::string(texto));
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || teclaEditor(estado.editor, tecla))
        return;
    if (tecla == 'm')
        estado.malla = !estado.malla;
    else if (tecla == '+' || tecla == '-')
        estado.tolerancia =
            glm::clamp(estado.tolerancia * (tecla == '+' ? 0.5 : 2), TOLERANCIA_MINIMA, TOLERANCIA_MAXIMA);
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Superficie de Bézier", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    estado.lamina = creaLamina({0.55f, 0.65f, 8, {0, -0.35f, 0}});
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.lamina.orbita);
    estado.editor = {&estado.P, vista, true};
    glutMouseFunc(
        [](int boton, int pulsado, int x, int y) { botonEditor(estado.editor, boton, pulsado, x, y); });
    glutMotionFunc([](int x, int y) { arrastraEditor(estado.editor, x, y); });
    glutSpecialFunc([](int tecla, int, int) { especialEditor(estado.editor, tecla); });
    glutMainLoop();
    return 0;
}
