// El test de profundidad (listado 4.1, figura 4.5): sólidos que se tapan, se cruzan y se enlazan, pintados de más cerca
// a más lejos. Sin él gana lo último que se pinta. El mismo algoritmo está hecho en la CPU (zbuffer.h), triángulo a
// triángulo; su imagen se copia en la ventana y no se distingue de la de la GPU. Con b no se borra la profundidad antes
// de dibujar: queda la de la imagen anterior, como si la cámara hubiera girado, y solo se ve lo que está más cerca.
// Controles: z test de profundidad · b borra o no la profundidad · c en la CPU o en la GPU · v compara los cuatro ·
// ratón orbita · Esc termina.
#include "zbuffer.h"
#include "buferes.h"
#include "ch03_transformaciones/objeto.h"
#include "ch03_transformaciones/transformaciones.h"
#include "colores.h"
#include "malla.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "ventana.h"
#include <glm/gtc/constants.hpp>

struct Solido {
    Malla malla;
    glm::mat4 M;
    glm::vec3 color;
    Buferes buferes;
};

static struct {
    GLuint programa, programaCopia, textura;
    std::vector<Solido> solidos;
    bool test = true, borra = true, enCpu = false, compara = false;
    Orbita orbita = {0.55f, 0.45f, 18.6f, {0, 1.1f, 0}, 0.02f};
} estado;

static void inicia() {
    estado.programa = creaProgramaObjeto();
    estado.programaCopia = creaPrograma("ch04_vista3d/copia.vert", "ch04_vista3d/copia.frag");
    glGenTextures(1, &estado.textura);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1); // las filas de lo que se copia no acaban en múltiplos de 4

    // El suelo y después los sólidos, de más cerca a más lejos.
    const glm::mat4 vertical = giroX(-glm::half_pi<float>()); // de pie: Z pasa a ser Y
    estado.solidos = {
        {cubo(), traslacion({0, -0.1f, 0}) * escalado({9.6f, 0.2f, 7}), SUELO, {}},
        {cubo(), traslacion({-1, 1.3f, 1}) * giroY(0.35f) * escalado(2.6f), ROJO, {}},
        {esfera(48), traslacion({-0.7f, 2.6f, 1.2f}) * escalado(1.1f), AMARILLO, {}},
        {cilindro(48), traslacion({2.6f, 2.1f, -0.6f}) * vertical * escalado({0.5f, 0.5f, 4.2f}), AZUL, {}},
        {toro(1.4f, 0.35f, 48, 24), traslacion({2.6f, 2.4f, -0.6f}) * giroX(0.45f) * vertical, NARANJA, {}},
        {cono(48), traslacion({-2.0f, 0, -1.9f}) * vertical * escalado({1.5f, 1.5f, 4.8f}), VERDE, {}},
    };
    for (Solido &s : estado.solidos)
        s.buferes = creaBuferes(s.malla);
}

// La de la imagen de antes, que dejó su profundidad.
static glm::mat4 camaraAnterior() {
    Orbita antes = estado.orbita;
    antes.azimut -= 0.35f;
    antes.elevacion += 0.12f;
    return camaraOrbita(antes);
}

static void dibujaEnGpu(const glm::mat4 &proyeccion, const glm::mat4 &camara, bool test) {
    if (test)
        glEnable(GL_DEPTH_TEST);
    usaPrograma(estado.programa, camara, proyeccion);
    for (const Solido &s : estado.solidos)
        dibujaObjeto(estado.programa, s.buferes, s.M, s.color);
    glDisable(GL_DEPTH_TEST);
}

// Lo mismo que objeto.vert y objeto.frag; su color es lineal en la normal y basta calcularlo en los vértices.
static void pintaEnCpu(BufferZ &buffer, const glm::mat4 &proyeccion, const glm::mat4 &camara) {
    for (const Solido &s : estado.solidos) {
        const glm::mat4 aRecortado = proyeccion * camara * s.M;
        const glm::mat3 N = matrizNormal(s.M);
        for (std::size_t i = 0; i < s.malla.indices.size(); i += 3) {
            TrianguloZ t;
            for (std::size_t k = 0; k < 3; ++k) {
                const Vertice &v = s.malla.vertices[s.malla.indices[i + k]];
                t[k] = {aRecortado * glm::vec4(v.posicion, 1), s.color * luzFija(unitario(N * v.normal))};
            }
            pintaTriangulo(buffer, t);
        }
    }
}

static Imagen dibujaEnCpu(const glm::mat4 &proyeccion, bool test, const Recuadro &r) {
    BufferZ buffer = creaBufferZ(r.ancho, r.alto, CIELO, test);
    const Imagen vacia = buffer.color;
    if (!estado.borra) {
        pintaEnCpu(buffer, proyeccion, camaraAnterior());
        buffer.color = vacia;
    }
    pintaEnCpu(buffer, proyeccion, camaraOrbita(estado.orbita));
    return buffer.color;
}

static void copia(const Imagen &imagen, const Recuadro &r) {
    glBindTexture(GL_TEXTURE_2D, estado.textura);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, imagen.ancho, imagen.alto, 0, GL_RGB, GL_UNSIGNED_BYTE,
                 imagen.rgb.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0); // no hay mipmaps
    glUseProgram(estado.programaCopia);
    envia(estado.programaCopia, "esquina", glm::vec2(r.x, r.y));
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

static void dibujaPanel(const Recuadro &r, bool enCpu, bool test) {
    abreRecuadro(r);
    ponFondo(CIELO);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const glm::mat4 proyeccion = perspectivaVentana(0.5f, 1, 100, aspecto(r));
    if (enCpu) {
        copia(dibujaEnCpu(proyeccion, test, r), r);
    } else {
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE); // de la anterior solo queda la profundidad
        if (!estado.borra)
            dibujaEnGpu(proyeccion, camaraAnterior(), test);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        dibujaEnGpu(proyeccion, camaraOrbita(estado.orbita), test);
    }
    rotula(std::string(enCpu ? "CPU " : "GPU ") + (test ? "con test" : "sin test") +
               (estado.borra ? "" : "\nsin borrar la profundidad"),
           {0.02f, estado.borra ? 0.06f : 0.09f}, OSCURO, Lado::DERECHA);
}

static void dibuja() {
    abreRecuadro(ventanaEntera());
    ponFondo(GRIS);
    glClear(GL_COLOR_BUFFER_BIT);
    if (estado.compara) {
        const std::vector<Recuadro> paneles = rejilla(2, 2);
        for (std::size_t k = 0; k < 4; ++k)
            dibujaPanel(paneles[k], k >= 2, k % 2 == 1);
    } else {
        dibujaPanel(ventanaEntera(), estado.enCpu, estado.test);
    }
    const std::string uno = std::string("Z-Buffer en la ") + (estado.enCpu ? "CPU" : "GPU") +
                            (estado.test ? "" : ", sin test de profundidad") +
                            (estado.borra ? "" : ", sin borrarla");
    ponTitulo(estado.compara ? "Z-Buffer: sin test y con él, en la GPU y en la CPU" : uno);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    switch (tecla) {
    case 'z': estado.test = !estado.test; break;
    case 'b': estado.borra = !estado.borra; break;
    case 'c': estado.enCpu = !estado.enCpu; break;
    case 'v': estado.compara = !estado.compara; break;
    default: return;
    }
    if (tecla == 'z' || tecla == 'c')
        estado.compara = false;
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Z-Buffer", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
