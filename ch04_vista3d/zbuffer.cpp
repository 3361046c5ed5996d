// El test de profundidad (listado 4.1, figura 4.5): sólidos que se tapan, se cruzan y se enlazan, pintados de
// más cerca a más lejos. Sin él gana lo último que se pinta. El mismo algoritmo está hecho en la CPU
// (zbuffer.h), triángulo a triángulo; su imagen se copia en la ventana y no se distingue de la de la GPU.
// Controles: z test de profundidad · c en la CPU o en la GPU · ratón orbita · Esc termina.
#include "zbuffer.h"
#include "ch03_transformaciones/transformaciones.h"
#include "malla.h"
#include "orbita.h"
#include "shader.h"
#include "ventana.h"

static const glm::vec3 FONDO(0.87f, 0.93f, 0.98f);
static const glm::vec3 ROJO(0.85f, 0.20f, 0.18f), AMARILLO(0.98f, 0.78f, 0.15f), AZUL(0.16f, 0.38f, 0.80f),
    NARANJA(0.95f, 0.55f, 0.10f), VERDE(0.20f, 0.62f, 0.28f);
static const float RECTO = 1.57079632679f; // π/2

struct Solido {
    Malla malla;
    glm::mat4 M;
    glm::vec3 color;
    Buferes buferes;
};

static struct {
    GLuint programa, programaCopia, textura;
    std::vector<Solido> solidos;
    bool test = true, enCpu = false;
    Orbita orbita = {0.55f, 0.45f, 18.6f, {0, 1.1f, 0}};
} estado;

static void inicia() {
    estado.programa = creaPrograma("ch03_transformaciones/objeto.vert", "ch03_transformaciones/objeto.frag");
    estado.programaCopia = creaPrograma("ch04_vista3d/copia.vert", "ch04_vista3d/copia.frag");
    glGenTextures(1, &estado.textura);
    glClearColor(FONDO.r, FONDO.g, FONDO.b, 1);

    // El suelo y después los sólidos, de más cerca a más lejos.
    const auto vertical = giroX(-RECTO); // de pie: Z pasa a ser Y
    estado.solidos = {
        {cubo(), traslacion({0, -0.1f, 0}) * escalado({9.6f, 0.2f, 7}), {0.62f, 0.72f, 0.58f}, {}},
        {cubo(), traslacion({-1, 1.3f, 1}) * giroY(0.35f) * escalado(2.6f), ROJO, {}},
        {esfera(48), traslacion({-0.7f, 2.6f, 1.2f}) * escalado(1.1f), AMARILLO, {}},
        {cilindro(48), traslacion({2.6f, 2.1f, -0.6f}) * vertical * escalado({0.5f, 0.5f, 4.2f}), AZUL, {}},
        {toro(1.4f, 0.35f, 48, 24), traslacion({2.6f, 2.4f, -0.6f}) * giroX(0.45f) * vertical, NARANJA, {}},
        {cono(48), traslacion({-2.0f, 0, -1.9f}) * vertical * escalado({1.5f, 1.5f, 4.8f}), VERDE, {}},
    };
    for (Solido &s : estado.solidos)
        s.buferes = creaBuferes(s.malla);
}

static void dibujaEnGpu(const glm::mat4 &camara) {
    if (estado.test)
        glEnable(GL_DEPTH_TEST);
    glUseProgram(estado.programa);
    envia(estado.programa, "camara", camara);
    for (const Solido &s : estado.solidos) {
        const glm::mat3 N = matrizNormal(s.M);
        envia(estado.programa, "M", s.M);
        envia(estado.programa, "N", N);
        envia(estado.programa, "colorObjeto", s.color);
        dibuja(s.buferes);
    }
    glDisable(GL_DEPTH_TEST);
}

// Lo mismo que objeto.vert y objeto.frag; su color es lineal en la normal y basta calcularlo en los vértices.
static Imagen dibujaEnCpu(const glm::mat4 &camara) {
    const glm::vec3 haciaLuz(0.20f, 0.78f, 0.593f);
    BufferZ buffer = creaBufferZ(glutGet(GLUT_WINDOW_WIDTH), glutGet(GLUT_WINDOW_HEIGHT), FONDO, estado.test);
    for (const Solido &s : estado.solidos) {
        const glm::mat4 aRecortado = camara * s.M;
        const glm::mat3 N = matrizNormal(s.M);
        for (std::size_t i = 0; i < s.malla.indices.size(); i += 3) {
            TrianguloZ t;
            for (std::size_t k = 0; k < 3; ++k) {
                const Vertice &v = s.malla.vertices[s.malla.indices[i + k]];
                const float luz = 0.58f + 0.42f * glm::dot(unitario(N * v.normal), haciaLuz);
                t[k] = {aRecortado * glm::vec4(v.posicion, 1), s.color * luz};
            }
            pintaTriangulo(buffer, t);
        }
    }
    return buffer.color;
}

static void copiaEnVentana(const Imagen &imagen) {
    glBindTexture(GL_TEXTURE_2D, estado.textura);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, imagen.ancho, imagen.alto, 0, GL_RGB, GL_UNSIGNED_BYTE,
                 imagen.rgb.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0); // no hay mipmaps
    glUseProgram(estado.programaCopia);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const glm::mat4 camara = perspectivaVentana(0.5f, 1, 100) * camaraOrbita(estado.orbita);
    if (estado.enCpu)
        copiaEnVentana(dibujaEnCpu(camara));
    else
        dibujaEnGpu(camara);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    switch (tecla) {
    case 'z': estado.test = !estado.test; break;
    case 'c': estado.enCpu = !estado.enCpu; break;
    default: return;
    }
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
