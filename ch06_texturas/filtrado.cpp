// Filtrado de la textura (§6.2.2) en un suelo que llega al horizonte: cerca, un texel ocupa varios píxeles
// (ampliación); lejos, un píxel abarca muchos texels (reducción). El libro confunde ahí píxeles y texels, y
// solo trata GL_NEAREST y GL_LINEAR, que lejos parpadean; lo curan los mipmaps y, sin emborronar, el filtro
// anisótropo (una extensión).
// Controles: 1 vecino · 2 lineal · 3 mipmap · 4 anisótropo · ratón orbita · Esc termina.
#include "ch03_transformaciones/transformaciones.h"
#include "malla.h"
#include "orbita.h"
#include "shader.h"
#include "textura.h"
#include "ventana.h"
#include <cstdio>

// El suelo, y lo que abarca una vez la textura. Con uno mucho mayor, un píxel del horizonte abarcaría miles de
// texels aun en el último mipmap, y el filtro anisótropo de Mesa tarda lo que tarda en recorrerlos.
static const float LARGO = 200, LADO_BALDOSAS = 2;
static const struct {
    GLint ampliacion, reduccion;
    bool anisotropo;
} filtros[4] = {{GL_NEAREST, GL_NEAREST, false},
                {GL_LINEAR, GL_LINEAR, false},
                {GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR, false},
                {GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR, true}};

static struct {
    GLuint programa;
    Buferes suelo;
    int elegido = 0;
    GLfloat anisotropia = 1; // la mayor que da el contexto; 1 es ninguna
    Orbita orbita = {0.12f, 0.27f, 3.6f, {0, 0, 0}};
} estado;

static void inicia(const Imagen &imagen) {
    estado.programa = creaPrograma("ch06_texturas/textura.vert", "ch06_texturas/textura.frag");
    Malla malla = plano(1);
    for (Vertice &v : malla.vertices) // 0 en el centro: cerca de la cámara es donde se notaría el redondeo
        v.coordTextura = (v.coordTextura - 0.5f) * LARGO / LADO_BALDOSAS;
    estado.suelo = creaBuferes(malla);
    creaTextura2D(imagen);
    if (GLEW_EXT_texture_filter_anisotropic)
        glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &estado.anisotropia);
    else
        std::printf(
            "Este contexto no tiene GL_EXT_texture_filter_anisotropic: la tecla 4 hace lo mismo que la 3\n");
    glEnable(GL_DEPTH_TEST);
    glClearColor(0.62f, 0.78f, 0.93f, 1);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(estado.programa);
    const auto &filtro = filtros[estado.elegido];
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filtro.ampliacion);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filtro.reduccion);
    if (GLEW_EXT_texture_filter_anisotropic)
        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT,
                        filtro.anisotropo ? estado.anisotropia : 1);
    const glm::mat4 matriz = perspectivaVentana(0.8f, 0.1f, 2 * LARGO) * camaraOrbita(estado.orbita) *
                             giroX(-1.57079632679f) * escalado(LARGO);
    envia(estado.programa, "matriz", matriz);
    envia(estado.programa, "Img", 0);
    dibuja(estado.suelo);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || tecla < '1' || tecla > '4')
        return;
    estado.elegido = tecla - '1';
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Filtrado", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE,
                "[FOTO.ppm | FOTO.rgb -talla ANCHOxALTO]");
    inicia(imagenDeArgumentos(argc, argv, "assets/baldosas.rgb", 256, 256));
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
