// Una textura sobre un objeto iluminado (listados 6.1 a 6.3, figura 6.1): leer la imagen, crear el objeto textura
// y decir al shader en qué unidad está. leeTextura está en common/imagen.cpp y la llama imagenDeArgumentos: en vez de
// malloc, fopen, fread y fclose usa la biblioteca de C++, comprueba lo que lee y le da la vuelta (los ficheros empiezan
// por arriba y OpenGL por abajo). Se aparta del libro en GL_UNPACK_ALIGNMENT, sin el que se tuercen los anchos no
// múltiplos de 4, en los mipmaps (filtrado) y en activar la unidad antes de crear la textura: basta enlazarla una vez.
// Controles: ratón orbita · Esc termina.
#include "buferes.h"
#include "colores.h"
#include "imagen.h"
#include "malla.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "shader.h"
#include "textura.h"
#include "ventana.h"
#include <glm/gtc/matrix_transform.hpp>

static const glm::vec2 REPETICIONES(6, 2); // alrededor del anillo y del tubo

static struct {
    GLuint programa, textura;
    Buferes toro;
    Orbita orbita = {0.25f, 0.45f, 6, {0, 0, 0}};
} estado;

static void creaTextura(int argc, char **argv) {
    // Listado 6.1: la imagen, «metal.rgb» si no se dice otra
    const auto imagen = imagenDeArgumentos(argc, argv, "assets/metal.rgb", 256, 256);
    compruebaQueCabe(imagen);
    // Listado 6.2: un nombre sin usar; su textura, en la unidad 0
    glGenTextures(1, &estado.textura);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, estado.textura);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1); // las filas no se rellenan hasta un múltiplo de 4 bytes
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, imagen.ancho, imagen.alto, 0, GL_RGB, GL_UNSIGNED_BYTE,
                 imagen.rgb.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
}

static void inicia() {
    estado.programa = creaPrograma("ch06_texturas/textura_objeto.vert", "ch06_texturas/textura_objeto.frag");
    estado.toro = creaBuferes(toro(1, 0.5f, 160, 80));
    glEnable(GL_DEPTH_TEST);
    ponFondo(FONDO_CLARO);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(estado.programa);
    const glm::mat4 camara = camaraOrbita(estado.orbita);
    const glm::mat4 M = glm::rotate(glm::mat4(1), -1.2f, glm::vec3(1, 0, 0)); // tumbado hacia quien mira
    const glm::mat3 N(camara * M); // solo hay giros: la matriz de la normal es la misma
    envia(estado.programa, "proyeccion", perspectivaVentana(0.47f, 0.1f, 100));
    envia(estado.programa, "camara", camara);
    envia(estado.programa, "M", M);
    envia(estado.programa, "N", N);
    envia(estado.programa, "repeticiones", REPETICIONES);
    // Final del listado 6.2: a Img, el número de la unidad, que no es el nombre de la textura
    const GLint loc = glGetUniformLocation(estado.programa, "Img");
    glUniform1i(loc, 0);
    dibujaMalla(estado.toro);
    glutSwapBuffers();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Un objeto con textura", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE,
                "[FOTO.ppm | FOTO.rgb -talla ANCHOxALTO]");
    creaTextura(argc, argv);
    inicia();
    glutDisplayFunc(dibuja);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
