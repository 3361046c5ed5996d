// Coordenadas de textura (§6.4, figura 6.3): un atributo más de cada vértice, que decide qué parte de la
// imagen le toca. En el cilindro y la esfera s es el ángulo y t la altura o la latitud, y la imagen se junta
// consigo misma; en las tapas es un círculo. En el cubo, cada cara tiene la imagen entera, derecha, y las
// coordenadas salen de la posición.
// Controles: 1 cubo · 2 cilindro · 3 esfera · ratón orbita · Esc termina.
#include "ch03_transformaciones/transformaciones.h"
#include "ch05_iluminacion/iluminacion.h"
#include "malla.h"
#include "orbita.h"
#include "textura.h"
#include "ventana.h"

static const float RADIO_PX = 500; // de la esfera, en una pantalla de 1080 líneas
static const glm::vec2 repeticiones(1);
static const glm::vec3 La(1);
static const Material material = {glm::vec3(0.45f), glm::vec3(0.55f), glm::vec3(0), 1};
static const Luz luz{{2.5f, 4, 6, 0}};

static struct {
    GLuint programa;
    Buferes objetos[3];
    glm::mat4 M[3];
    int elegido = 0;
    Orbita orbita = {0.6f, 0.45f, 5.9f, {0, 0, 0}};
} estado;

// Para quien mira una cara de frente, s crece hacia la derecha y t hacia `arriba`.
static Malla cuboConCoordenadas() {
    Malla malla = cubo();
    for (Vertice &v : malla.vertices) {
        const glm::vec3 arriba = v.normal.y == 0 ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, -v.normal.y);
        const glm::vec3 derecha = glm::cross(arriba, v.normal);
        v.coordTextura = 0.5f + glm::vec2(glm::dot(v.posicion, derecha), glm::dot(v.posicion, arriba));
    }
    return malla;
}

static void inicia(const Imagen &imagen) {
    estado.programa = creaPrograma("ch06_texturas/textura_objeto.vert", "ch06_texturas/textura_objeto.frag");
    const int n = segmentosPara(RADIO_PX, 0.25f); // una esfera se hunde a lo largo y a lo ancho
    estado.objetos[0] = creaBuferes(cuboConCoordenadas());
    estado.objetos[1] = creaBuferes(cilindro(n));
    estado.objetos[2] = creaBuferes(esfera(n));
    // los ejes del cilindro y de la esfera, a la vertical, y la costura (s = 0 y s = 1), a la vista
    const glm::mat4 depie = giroY(-0.65f) * giroX(-1.57079632679f);
    estado.M[0] = escalado(1.65f);
    estado.M[1] = depie * escalado({1, 1, 2});
    estado.M[2] = depie * escalado(1.35f);
    creaTextura2D(imagen);
    glEnable(GL_DEPTH_TEST);
    glClearColor(0.95f, 0.96f, 0.98f, 1);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(estado.programa);
    const glm::mat4 vista = camaraOrbita(estado.orbita), &M = estado.M[estado.elegido];
    const glm::mat4 proyeccion = perspectivaVentana(0.5f, 1, 100);
    const glm::mat3 N = matrizNormal(vista * M);
    envia(estado.programa, "proyeccion", proyeccion);
    envia(estado.programa, "vista", vista);
    envia(estado.programa, "M", M);
    envia(estado.programa, "N", N);
    envia(estado.programa, "repeticiones", repeticiones);
    envia(estado.programa, "Img", 0);
    envia(estado.programa, "La", La);
    enviaMaterial(estado.programa, material);
    enviaLuz(estado.programa, "luz", luz, vista);
    const Buferes &objeto = estado.objetos[estado.elegido];
    dibuja(objeto);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || tecla < '1' || tecla > '3')
        return;
    estado.elegido = tecla - '1';
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Coordenadas de textura", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE,
                "[FOTO.ppm | FOTO.rgb -talla ANCHOxALTO]");
    inicia(imagenDeArgumentos(argc, argv, "assets/carta.rgb", 256, 256));
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
