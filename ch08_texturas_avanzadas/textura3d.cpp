// Texturas 3D (§8.3, listado 8.4, figuras 8.3 y 8.4): una textura de ruido da un valor a cada punto del espacio, y de
// él salen la madera y el mármol. El peón está tallado en el bloque: la veta sigue por dentro, y por eso coordVertice
// son aquí las coordenadas en el bloque; en las de cada pieza, que es lo del libro para un objeto, no pasaría de una a
// otra. El libro guarda 512³ texeles de tres bytes, 403 MB; el ruido solo necesita un byte por texel y, como se repite
// sin costura, 64³ texeles, que no se leen de un fichero (leeTextura3D): los calcula ruido.h. Al reducir se usan
// mipmaps, y la unidad activa es siempre la 0: no hace falta glActiveTexture.
// Controles: 1 madera · 2 mármol · 3 el ruido · + - frecuencia S1 · a d amplitud S2 · ratón orbita · Esc termina.
#include "textura3d.h"
#include "buferes.h"
#include "ch03_transformaciones/transformaciones.h"
#include "ch05_iluminacion/iluminacion.h"
#include "colores.h"
#include "malla.h"
#include "modos.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "texto.h"
#include "ventana.h"
#include <algorithm>
#include <glm/gtc/constants.hpp>

static const char *NOMBRES[3] = {"madera", "mármol", "el ruido"};
static const float S1_MINIMA = 0.125f, S1_MAXIMA = 2, PASO_S2 = 0.25f, S2_MAXIMA = 2;

static struct {
    GLuint programa, textura;
    Buferes cubo, esfera, cilindro, cono, toro;
    int elegido = 0;
    float S1 = 0.5f, S2 = 1;
    Orbita orbita = {0.45f, 0.32f, 9.9f, {0.05f, 0, 0}};
} estado;

// Listado 8.4.
static void creaTextura() {
    glGenTextures(1, &estado.textura);
    glBindTexture(GL_TEXTURE_3D, estado.textura);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_R8, LADO_TEXTURA, LADO_TEXTURA, LADO_TEXTURA, 0, GL_RED,
                 GL_UNSIGNED_BYTE, texelsRuido().data());
    glGenerateMipmap(GL_TEXTURE_3D);
    for (const GLenum eje : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTexParameteri(GL_TEXTURE_3D, eje, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
}

static void inicia() {
    estado.programa =
        creaPrograma("ch08_texturas_avanzadas/textura3d.vert", "ch08_texturas_avanzadas/textura3d.frag");
    const int n = segmentosEsfera(250);
    estado.cubo = creaBuferes(cubo());
    estado.esfera = creaBuferes(esfera(n));
    estado.cilindro = creaBuferes(cilindro(n));
    estado.cono = creaBuferes(cono(n));
    estado.toro = creaBuferes(toro(0.42f, 0.14f, n, n / 2));
    creaTextura();
    glEnable(GL_DEPTH_TEST);
    ponFondo(FONDO_CLARO);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const glm::mat4 camara = camaraOrbita(estado.orbita);
    usaIluminado(estado.programa, camara, perspectivaVentana(0.4f, 1, 100), {{-3, 6, 8, 1}});
    envia(estado.programa, "ruido", 0);
    envia(estado.programa, "S1", estado.S1);
    envia(estado.programa, "S2", estado.S2);
    envia(estado.programa, "elegido", estado.elegido);
    const auto pieza = [&](const Buferes &solido, const glm::vec3 &donde, const glm::vec3 &talla) {
        const glm::mat4 M =
            traslacion(donde) * giroX(-glm::half_pi<float>()) * escalado(talla); // el eje, hacia +Y
        envia(estado.programa, "M", M);
        envia(estado.programa, "N", matrizNormal(camara * M));
        dibujaMalla(solido);
    };
    pieza(estado.cubo, {-1.15f, 0, 0}, {1.5f, 1.5f, 2.6f});
    pieza(estado.cilindro, {1.15f, -1.19f, 0}, {0.85f, 0.85f, 0.22f});
    pieza(estado.toro, {1.15f, -1.0f, 0}, {1.45f, 1.45f, 1});
    pieza(estado.cono, {1.15f, -1.08f, 0}, {0.74f, 0.74f, 2.1f});
    pieza(estado.toro, {1.15f, 0.28f, 0}, {0.85f, 0.85f, 0.6f});
    pieza(estado.esfera, {1.15f, 0.78f, 0}, {0.52f, 0.52f, 0.52f});

    const std::string texto = formatea("%s, S1 = %g, S2 = %g", NOMBRES[estado.elegido], estado.S1, estado.S2);
    rotula(texto, {0.02f, 0.98f}, OSCURO, Lado::DERECHA);
    rotula("64³ texeles\nde 1 byte", {0.02f, 0.02f}, OSCURO, Lado::DERECHA);
    ponTitulo("Textura 3D: " + texto);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || eligeModo(estado.elegido, 3, tecla))
        return;
    switch (tecla) {
    case '+': estado.S1 = std::min(2 * estado.S1, S1_MAXIMA); break;
    case '-': estado.S1 = std::max(estado.S1 / 2, S1_MINIMA); break;
    case 'a': estado.S2 = std::max(estado.S2 - PASO_S2, 0.0f); break;
    case 'd': estado.S2 = std::min(estado.S2 + PASO_S2, S2_MAXIMA); break;
    default: return;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Textura 3D", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
