// Un objeto que refleja su entorno, guardado en un mapa de cubo (§8.1, listados 8.1 y 8.2, figura 8.1) o, con e, en
// una sola textura que se lee con coordenadas esféricas. Se aparta del libro en que el entorno está fijo en el
// mundo, en que el vector de reflexión se calcula en cada fragmento, en el orden de las caras y de sus filas, que es
// el de OpenGL, y en GL_CLAMP_TO_EDGE. El toro no se refleja a sí mismo: no está en el mapa. En el mapa desplegado
// se ve qué cara y qué (u, v) tocan a un vector, que es aquel en que mira la cámara (mapa_cubo.h).
// Controles: c mapa desplegado · e de cubo o esférico · v por fragmento y por vértice · ratón orbita · Esc termina.
#include "buferes.h"
#include "ch03_transformaciones/transformaciones.h"
#include "colores.h"
#include "desplegado.h"
#include "imagen.h"
#include "malla.h"
#include "mapa_cubo.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "rutas.h"
#include "shader.h"
#include "textura.h"
#include "ventana.h"
#include <algorithm>

static const int LADO = 512; // de cada foto

static struct {
    GLuint programa, fondo, mapa, esferico, vao;
    Buferes toro, basto; // el segundo, de muy pocas caras: en ellas se ve la diferencia
    bool desplegado = false, comparando = false, conEsferico = false;
    Orbita orbita = {0.35f, 0.06f, 4.7f, {0, 0, 0}};
} estado;

// Listado 8.2.
static void creaMapa(const std::array<Imagen, 6> &fotos) {
    glGenTextures(1, &estado.mapa);
    glBindTexture(GL_TEXTURE_CUBE_MAP, estado.mapa);
    for (GLuint i = 0; i < 6; ++i)
        glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + i, 0, GL_RGB8, LADO, LADO, 0, GL_RGB, GL_UNSIGNED_BYTE,
                     fotos[i].rgb.data());
    glGenerateMipmap(GL_TEXTURE_CUBE_MAP);
    // con GL_REPEAT, junto a cada arista se colaría el borde contrario de la misma cara
    for (const GLenum eje : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTexParameteri(GL_TEXTURE_CUBE_MAP, eje, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    if (GLEW_ARB_seamless_cube_map) // y filtrar entre caras vecinas borra la costura
        glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
}

// Sin mipmaps: donde la longitud pasa de una vuelta a cero, el nivel que se elegiría sería el de un texel.
static void creaMapaEsferico(const std::array<Imagen, 6> &fotos) {
    glActiveTexture(GL_TEXTURE1);
    estado.esferico = creaTextura2D(mapaEsferico(fotos, LADO));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glActiveTexture(GL_TEXTURE0);
}

static void creaMapas() {
    std::array<Imagen, 6> fotos;
    for (std::size_t i = 0; i < 6; ++i) {
        std::vector<unsigned char> &rgb = fotos[i].rgb;
        fotos[i] =
            leeTextura(recurso(std::string("assets/entorno_") + CARAS[i].fichero + ".rgb"), LADO, LADO);
        if (CARAS[i].delReves()) // media vuelta
            for (auto a = rgb.begin(), b = rgb.end() - 3; a < b; a += 3, b -= 3)
                std::swap_ranges(a, a + 3, b);
    }
    creaMapa(fotos);
    creaMapaEsferico(fotos);
}

static void inicia() {
    estado.programa =
        creaPrograma("ch08_texturas_avanzadas/cubemap.vert", "ch08_texturas_avanzadas/cubemap.frag");
    estado.fondo = creaPrograma("ch08_texturas_avanzadas/cubemap_fondo.vert",
                                "ch08_texturas_avanzadas/cubemap_fondo.frag");
    estado.toro = creaBuferes(toro(1, 0.5f, 90, 46)); // con el doble, el reflejo mejora 0.2 niveles
    estado.basto = creaBuferes(toro(1, 0.5f, 12, 6));
    creaMapas();
    glGenVertexArrays(1, &estado.vao);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL); // el fondo está en el plano lejos
}

static void enviaMapas(GLuint programa) {
    envia(programa, "mapa", 0);
    envia(programa, "mapaEsferico", 1);
    envia(programa, "conEsferico", estado.conEsferico);
}

// Lo que se ve del mapa en esa dirección; `desplegado`, el esférico, entero.
static void dibujaMapa(const glm::mat3 &base, const glm::vec2 &semitalla, bool desplegado = false) {
    glUseProgram(estado.fondo);
    envia(estado.fondo, "base", base);
    envia(estado.fondo, "semitalla", semitalla);
    envia(estado.fondo, "desplegado", desplegado);
    enviaMapas(estado.fondo);
    glBindVertexArray(estado.vao);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

static void dibujaReflejo(const Recuadro &panel, const Buferes &objeto, bool porVertice, float angulo) {
    abreRecuadro(panel);
    ponFondo(CIELO);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const glm::mat4 camara = camaraOrbita(estado.orbita),
                    proyeccion = perspectivaVentana(angulo, 0.1f, 100, aspecto(panel));
    const glm::mat4 M = giroZ(0.35f) * giroX(-1.05f);
    usaPrograma(estado.programa, camara, proyeccion);
    envia(estado.programa, "ojo", posicionCamara(estado.orbita));
    envia(estado.programa, "M", M);
    envia(estado.programa, "N", matrizNormal(M));
    enviaMapas(estado.programa);
    envia(estado.programa, "porVertice", porVertice);
    dibujaMalla(objeto);
    // la cámara mira hacia su −z; su matriz solo gira, y la traspuesta es la inversa
    const glm::mat3 ejes = glm::transpose(glm::mat3(camara));
    dibujaMapa({ejes[0], ejes[1], -ejes[2]}, {1 / proyeccion[0][0], 1 / proyeccion[1][1]});
}

static void dibuja() {
    if (estado.desplegado) {
        // hacia donde mira la cámara
        const glm::vec3 R = glm::normalize(estado.orbita.centro - posicionCamara(estado.orbita));
        abreRecuadro(ventanaEntera());
        ponFondo(FONDO_OSCURO);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        estado.conEsferico ? desplegaEsferico(R, dibujaMapa) : desplegaCubo(R, dibujaMapa);
    } else if (estado.comparando) {
        abreRecuadro(ventanaEntera());
        ponFondo(OSCURO);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        const std::vector<Recuadro> paneles = reparte(2);
        for (const bool porVertice : {false, true}) {
            dibujaReflejo(paneles[porVertice], estado.basto, porVertice, 0.47f);
            rotula(porVertice ? "por vértice" : "por fragmento", {0.5f, 0.02f}, OSCURO, Lado::ENCIMA);
        }
    } else {
        dibujaReflejo(ventanaEntera(), estado.toro, false, 0.75f);
    }
    const char *const reflexion =
        estado.comparando ? "reflexión por fragmento y por vértice" : "reflexión del entorno";
    ponTitulo(std::string(estado.conEsferico ? "Mapa esférico: " : "Mapa de cubo: ") +
              (estado.desplegado ? "desplegado, visto desde el centro" : reflexion));
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    if (tecla == 'c') {
        estado.desplegado = !estado.desplegado;
    } else if (tecla == 'e') {
        estado.conEsferico = !estado.conEsferico;
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
