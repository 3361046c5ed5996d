// Un objeto que refleja su entorno, guardado en un mapa de cubo (§8.1, listados 8.1 y 8.2, figura 8.1). Se aparta del
// libro en que el entorno está fijo en el mundo, en que el vector de reflexión se calcula en cada fragmento, en el
// orden de las caras y de sus filas, que es el de OpenGL, y en GL_CLAMP_TO_EDGE. La unidad activa es siempre la 0: no
// hace falta glActiveTexture. El toro no se refleja a sí mismo: no está en el mapa.
// Controles: c mapa desplegado · v por fragmento y por vértice · ratón orbita · Esc termina.
#include "buferes.h"
#include "ch03_transformaciones/transformaciones.h"
#include "colores.h"
#include "imagen.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "rutas.h"
#include "shader.h"
#include "ventana.h"
#include <algorithm>

// Las caras, en el orden de OpenGL. Cada una es una foto hecha desde el centro: qué ejes del mundo tiene a la derecha,
// arriba y enfrente, y su sitio (columna y fila) en el mapa desplegado.
struct Cara {
    const char *fichero, *nombre;
    glm::mat3 base;
    int columna, fila;
};
static const glm::vec3 X(1, 0, 0), Y(0, 1, 0), Z(0, 0, 1);
static const Cara CARAS[6] = {
    {"derecha", "+X\nderecha", {Z, Y, X}, 2, 1}, {"izquierda", "−X\nizquierda", {-Z, Y, -X}, 0, 1},
    {"arriba", "+Y\narriba", {X, Z, Y}, 1, 0},   {"abajo", "−Y\nabajo", {X, -Z, -Y}, 1, 2},
    {"detras", "+Z\ndetrás", {-X, Y, Z}, 3, 1},  {"delante", "−Z\ndelante", {X, Y, -Z}, 1, 1}};
static const int LADO = 256;

static struct {
    GLuint programa, fondo, mapa, vao;
    Buferes toro, basto; // el segundo, de muy pocas caras: en ellas se ve la diferencia
    bool desplegado = false, comparando = false;
    Orbita orbita = {0.35f, 0.06f, 4.7f, {0, 0, 0}};
} estado;

// Listado 8.2.
static void creaMapa() {
    glGenTextures(1, &estado.mapa);
    glBindTexture(GL_TEXTURE_CUBE_MAP, estado.mapa);
    for (GLuint i = 0; i < 6; ++i) {
        Imagen foto =
            leeTextura(recurso(std::string("assets/entorno_") + CARAS[i].fichero + ".rgb"), LADO, LADO);
        // OpenGL mira el cubo desde fuera: en las cuatro caras de los lados s va de derecha a izquierda de la foto y t,
        // de arriba abajo. Es la foto dada media vuelta.
        if (CARAS[i].fila == 1)
            for (auto a = foto.rgb.begin(), b = foto.rgb.end() - 3; a < b; a += 3, b -= 3)
                std::swap_ranges(a, a + 3, b);
        glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + i, 0, GL_RGB8, LADO, LADO, 0, GL_RGB, GL_UNSIGNED_BYTE,
                     foto.rgb.data());
    }
    glGenerateMipmap(GL_TEXTURE_CUBE_MAP);
    // con GL_REPEAT, junto a cada arista se colaría el borde contrario de la misma cara
    for (const GLenum eje : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTexParameteri(GL_TEXTURE_CUBE_MAP, eje, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    if (GLEW_ARB_seamless_cube_map) // y filtrar entre caras vecinas borra la costura
        glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
}

static void inicia() {
    estado.programa =
        creaPrograma("ch08_texturas_avanzadas/cubemap.vert", "ch08_texturas_avanzadas/cubemap.frag");
    estado.fondo = creaPrograma("ch08_texturas_avanzadas/cubemap_fondo.vert",
                                "ch08_texturas_avanzadas/cubemap_fondo.frag");
    estado.toro = creaBuferes(toro(1, 0.5f, 90, 46)); // con el doble, el reflejo mejora 0.2 niveles
    estado.basto = creaBuferes(toro(1, 0.5f, 12, 6));
    creaMapa();
    glGenVertexArrays(1, &estado.vao);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL); // el fondo está en el plano lejos
}

// Lo que se ve del mapa en esa dirección.
static void dibujaMapa(const glm::mat3 &base, const glm::vec2 &semitalla) {
    glUseProgram(estado.fondo);
    envia(estado.fondo, "base", base);
    envia(estado.fondo, "semitalla", semitalla);
    envia(estado.fondo, "mapa", 0);
    glBindVertexArray(estado.vao);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

static void dibujaReflejo(const Recuadro &panel, const Buferes &objeto, bool porVertice, float angulo) {
    abreRecuadro(panel, CIELO);
    const glm::mat4 camara = camaraOrbita(estado.orbita),
                    proyeccion = perspectivaVentana(angulo, 0.1f, 100, aspecto(panel));
    const glm::mat4 M = giroZ(0.35f) * giroX(-1.05f);
    usaPrograma(estado.programa, camara, proyeccion);
    envia(estado.programa, "ojo", posicionCamara(estado.orbita));
    envia(estado.programa, "M", M);
    envia(estado.programa, "N", matrizNormal(M));
    envia(estado.programa, "mapa", 0);
    envia(estado.programa, "porVertice", porVertice);
    dibuja(objeto);
    // la cámara mira hacia su −z; su matriz solo gira, y la traspuesta es la inversa
    const glm::mat3 ejes = glm::transpose(glm::mat3(camara));
    dibujaMapa({ejes[0], ejes[1], -ejes[2]}, {1 / proyeccion[0][0], 1 / proyeccion[1][1]});
}

static void dibujaDesplegado() {
    abreRecuadro(ventanaEntera(), FONDO_OSCURO);
    const Recuadro v = ventanaEntera();
    const int lado = std::max(int(0.95f * std::min(float(v.ancho) / 4, altoUtil() / 3)), 2); // con la raya
    for (const Cara &cara : CARAS) {
        abreRecuadro({v.ancho / 2 + lado * (cara.columna - 2),
                      v.alto / 2 + lado * (2 - cara.fila) - 3 * lado / 2, lado - 1, lado - 1},
                     FONDO_OSCURO);
        dibujaMapa(cara.base, {1, 1});
        rotula(cara.nombre, {0.5f, 0}, OSCURO, Lado::ENCIMA, 0.03f);
    }
}

static void dibuja() {
    if (estado.desplegado) {
        dibujaDesplegado();
    } else if (estado.comparando) {
        abreRecuadro(ventanaEntera(), OSCURO);
        const std::vector<Recuadro> paneles = reparte(2);
        for (const bool porVertice : {false, true}) {
            dibujaReflejo(paneles[porVertice], estado.basto, porVertice, 0.47f);
            rotula(porVertice ? "por vértice" : "por fragmento", {0.5f, 0.02f}, OSCURO, Lado::ENCIMA);
        }
    } else {
        dibujaReflejo(ventanaEntera(), estado.toro, false, 0.75f);
    }
    ponTitulo(estado.desplegado   ? "Mapa de cubo desplegado, visto desde el centro"
              : estado.comparando ? "Reflexión por fragmento y por vértice"
                                  : "Mapa de cubo: reflexión del entorno");
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    if (tecla == 'c') {
        estado.desplegado = !estado.desplegado;
    } else if (tecla == 'v') {
        estado.comparando = !estado.comparando;
        estado.desplegado = false;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Mapa de cubo", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
