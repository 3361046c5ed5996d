// Una textura sobre un objeto iluminado (listados 6.1 a 6.3, figura 6.1): leer el fichero RGB, crear el
// objeto textura y decir al shader en qué unidad está. Se aparta del libro en comprobar lo que lee y darle la
// vuelta (los ficheros empiezan por arriba y OpenGL por abajo), en GL_UNPACK_ALIGNMENT, sin el que se tuercen
// los anchos no múltiplos de 4, y en los mipmaps (filtrado).
// Controles: ratón orbita · Esc termina.
#include "ch03_transformaciones/transformaciones.h"
#include "ch05_iluminacion/iluminacion.h"
#include "imagen.h"
#include "malla.h"
#include "orbita.h"
#include "textura.h"
#include "ventana.h"

static const float RADIO_PX = 200;         // del tubo, en una pantalla de 1080 líneas
static const glm::vec2 repeticiones(6, 2); // alrededor del anillo y del tubo
static const glm::vec3 La(1);
static const Material material = {glm::vec3(0.22f), glm::vec3(0.85f), glm::vec3(0.45f), 40};
static const Luz luz{{-3, 6, 8, 1}};

static struct {
    GLuint programa, textura;
    Buferes toro;
    Orbita orbita = {0.25f, 0.45f, 6, {0, 0, 0}};
} estado;

// Listado 6.2.
static void creaTextura(const Imagen &imagen) {
    compruebaQueCabe(imagen);
    glGenTextures(1, &estado.textura); // 1. un nombre sin usar
    glActiveTexture(GL_TEXTURE0);      // 2. la unidad de textura 0
    glBindTexture(GL_TEXTURE_2D, estado.textura);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1); // 3. la imagen, de filas sin rellenar hasta un múltiplo de 4 bytes
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, imagen.ancho, imagen.alto, 0, GL_RGB, GL_UNSIGNED_BYTE,
                 imagen.rgb.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT); // 4. la repetición y el filtrado
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
}

static void inicia(const Imagen &imagen) {
    estado.programa = creaPrograma("ch06_texturas/textura_objeto.vert", "ch06_texturas/textura_objeto.frag");
    // segmentos para el anillo y el tubo: se hunden los dos, la mitad del medio píxel cada uno
    estado.toro =
        creaBuferes(toro(1, 0.5f, segmentosPara(3 * RADIO_PX, 0.25f), segmentosPara(RADIO_PX, 0.25f)));
    creaTextura(imagen);
    glEnable(GL_DEPTH_TEST);
    glClearColor(0.95f, 0.96f, 0.98f, 1);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(estado.programa);
    const glm::mat4 vista = camaraOrbita(estado.orbita), M = giroX(-1.2f);
    const glm::mat4 proyeccion = perspectivaVentana(0.47f, 1, 100);
    const glm::mat3 N = matrizNormal(vista * M);
    envia(estado.programa, "proyeccion", proyeccion);
    envia(estado.programa, "vista", vista);
    envia(estado.programa, "M", M);
    envia(estado.programa, "N", N);
    envia(estado.programa, "repeticiones", repeticiones);
    envia(estado.programa, "Img", 0); // la unidad, no el nombre de la textura
    envia(estado.programa, "La", La);
    enviaMaterial(estado.programa, material);
    enviaLuz(estado.programa, "luz", luz, vista);
    dibuja(estado.toro);
    glutSwapBuffers();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Un objeto con textura", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE,
                "[FOTO.ppm | FOTO.rgb -talla ANCHOxALTO]");
    inicia(imagenDeArgumentos(argc, argv, "assets/metal.rgb", 256, 256));
    glutDisplayFunc(dibuja);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
