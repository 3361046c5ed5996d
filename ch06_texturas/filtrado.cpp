// Filtrado de la textura (§6.2.2) en un suelo que llega al horizonte: cerca, un texel ocupa muchos píxeles
// (ampliación); lejos, un píxel, muchos texeles (reducción). El libro confunde ahí píxeles y texeles, y solo trata
// GL_NEAREST y GL_LINEAR: cerca se distinguen, y lejos las dos parpadean; lo curan los mipmaps y, sin emborronar, el
// filtro anisótropo (una extensión). La textura que trae el programa mide 32 × 32. Con n, cada resolución se da a mano
// (el `nivel` de glTexImage2D, §6.2.1) y es de un color: se ve cuál se usa en cada sitio.
// Controles: 1 vecino · 2 lineal · 3 mipmap · 4 anisótropo · v los cuatro a la vez · n niveles de colores ·
// ratón orbita · Esc termina.
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
#include "ventana.h"
#include <algorithm>
#include <cstdio>
#include <glm/gtc/constants.hpp>

// El suelo, y lo que abarca una vez la textura. Con uno mucho mayor, un píxel del horizonte abarcaría miles de texeles
// aun en el último mipmap, y el filtro anisótropo de Mesa tarda lo que tarda en recorrerlos.
static const float LARGO = 200, LADO_MOSAICO = 2;
static const struct {
    const char *nombre, *titulo;
    GLint ampliacion, reduccion;
    bool anisotropo;
} FILTROS[4] = {
    {"1 vecino", "Vecino: GL_NEAREST", GL_NEAREST, GL_NEAREST, false},
    {"2 lineal", "Lineal: GL_LINEAR", GL_LINEAR, GL_LINEAR, false},
    {"3 mipmap", "Mipmap: GL_LINEAR_MIPMAP_LINEAR", GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR, false},
    {"4 anisótropo", "Anisótropo: GL_TEXTURE_MAX_ANISOTROPY_EXT", GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR, true}};

static struct {
    GLuint programa, textura, deNiveles;
    bool conNiveles = false;
    Buferes suelo;
    Modos modos = {4};
    GLfloat anisotropia = 1; // la mayor que da el contexto; 1 es ninguna
    Orbita orbita = {0.12f, 0.3f, 3, {0, 0, 0}, 0.05f};
} estado;

// El nivel 0 es la imagen; los demás, cada uno de la mitad de lado que el anterior, de un color.
static GLuint creaNiveles(const Imagen &imagen) {
    static const glm::vec3 COLORES[] = {ROJO, NARANJA, AMARILLO, VERDE, AZUL, MORADO};
    const GLuint textura = creaTextura2D(imagen);
    GLsizei ancho = imagen.ancho, alto = imagen.alto;
    for (GLint nivel = 1; ancho > 1 || alto > 1; ++nivel) {
        ancho = std::max(ancho / 2, 1);
        alto = std::max(alto / 2, 1);
        std::vector<unsigned char> texeles;
        for (int i = 0; i < 3 * ancho * alto; ++i)
            texeles.push_back(enOchoBits(COLORES[(nivel - 1) % 6][i % 3]));
        glTexImage2D(GL_TEXTURE_2D, nivel, GL_RGB8, ancho, alto, 0, GL_RGB, GL_UNSIGNED_BYTE, texeles.data());
    }
    return textura;
}

static void inicia(const Imagen &imagen) {
    estado.programa = creaPrograma("ch06_texturas/textura.vert", "ch06_texturas/textura.frag");
    Malla malla = plano(1);
    for (Vertice &v : malla.vertices) // 0 en el centro: cerca de la cámara es donde se notaría el redondeo
        v.coordTextura = (v.coordTextura - 0.5f) * LARGO / LADO_MOSAICO;
    estado.suelo = creaBuferes(malla);
    estado.textura = creaTextura2D(imagen);
    estado.deNiveles = creaNiveles(imagen);
    if (GLEW_EXT_texture_filter_anisotropic)
        glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &estado.anisotropia);
    else
        std::printf(
            "Este contexto no tiene GL_EXT_texture_filter_anisotropic: la tecla 4 hace lo mismo que la 3\n");
    glEnable(GL_DEPTH_TEST);
}

static void dibujaSuelo(int elegido, const Recuadro &panel) {
    const auto &filtro = FILTROS[elegido];
    abreRecuadro(panel);
    ponFondo(CIELO);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glBindTexture(GL_TEXTURE_2D, estado.conNiveles ? estado.deNiveles : estado.textura);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filtro.ampliacion);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filtro.reduccion);
    if (GLEW_EXT_texture_filter_anisotropic)
        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT,
                        filtro.anisotropo ? estado.anisotropia : 1);
    usaPrograma(estado.programa, camaraOrbita(estado.orbita),
                perspectivaVentana(0.8f, 0.1f, 2 * LARGO, aspecto(panel)));
    envia(estado.programa, "M", giroX(-glm::half_pi<float>()) * escalado(LARGO));
    envia(estado.programa, "Img", 0);
    dibujaMalla(estado.suelo);
    rotula(filtro.nombre, {0.5f, 1}, OSCURO, Lado::DEBAJO, estado.modos.todos ? 0.03f : 0.05f);
}

static void dibuja() {
    dibujaModos(estado.modos, dibujaSuelo, 4.0f / 3);
    ponTitulo(estado.modos.todos ? "Los cuatro filtros" : FILTROS[estado.modos.elegido].titulo);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || teclaModos(estado.modos, tecla) || tecla != 'n')
        return;
    estado.conNiveles = !estado.conNiveles;
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Filtrado", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE,
                "[FOTO.ppm | FOTO.rgb -talla ANCHOxALTO]");
    inicia(imagenDeArgumentos(argc, argv, "assets/mosaico.rgb", 32, 32));
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
