// Las mismas dos matrices en los dos órdenes (§3.2): T(5,0,0) y S(5,5,5) aplicadas a una esfera de radio 1.
// Arriba T·S: primero se escala y luego se traslada, y el centro acaba en x = 5. Abajo S·T: el escalado
// también multiplica la traslación, y acaba en x = 25. Gris, la esfera inicial; en líneas, tras la primera. El producto
// es asociativo, y así M se calcula una vez por objeto y no dos matrices por vértice: con c, cuántos productos ahorra.
// Controles: c cuenta los productos · ratón orbita · Esc termina.
#include "buferes.h"
#include "colores.h"
#include "dibujos.h"
#include "malla.h"
#include "objeto.h"
#include "orbita.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "transformaciones.h"
#include "trazo.h"
#include "ventana.h"
#include <glm/gtc/matrix_transform.hpp>

static const float RADIO_PX = 200; // la esfera en una pantalla de 1920×1080
static const float ALTURA_REGLA = -6.5f;

static struct {
    GLuint programa;
    Buferes esfera;
    std::size_t vertices; // de la esfera
    bool cuenta = false;
    Orbita orbita = {0, 0.3f, 21, {13.8f, -1.4f, 0}}; // en paralela, `distancia` es el semiancho de la vista
} estado;

static void inicia() {
    estado.programa = creaProgramaObjeto();
    // una esfera se hunde a lo largo y a lo ancho: a cada uno, la mitad del medio píxel
    const Malla malla = esfera(segmentosPara(RADIO_PX, 0.25f));
    estado.esfera = creaBuferes(malla);
    estado.vertices = malla.vertices.size();
    glEnable(GL_DEPTH_TEST);
}

// Una división cada 5 unidades, desde x = 0, y una plomada desde el centro de la esfera.
static void trazaRegla(const glm::vec3 &centro, const glm::mat4 &transformacion) {
    trazaPolilinea({{0, ALTURA_REGLA, 0}, {30, ALTURA_REGLA, 0}}, transformacion, OSCURO, 1.5f * GROSOR);
    for (int x = 0; x <= 30; x += 5) {
        const glm::vec3 marca(x, ALTURA_REGLA, 0);
        trazaPolilinea({marca, marca + glm::vec3(0, 0.8f, 0)}, transformacion, OSCURO, 1.5f * GROSOR);
        rotulaPunto(std::to_string(x), marca, transformacion, OSCURO, Lado::DEBAJO);
    }
    trazaPolilinea({centro, {centro.x, ALTURA_REGLA, 0}}, transformacion, MORADO, 2 * GROSOR);
}

// M = segunda·primera: la de la derecha se aplica antes.
static void dibujaVista(const glm::mat4 &segunda, const glm::mat4 &primera, const char *nombre,
                        const char *nombrePrimera, const Recuadro &r) {
    // al menos 8/3 veces más ancha que alta en unidades de la escena, sea como sea la ventana
    const float x = estado.orbita.distancia * std::max(aspecto(r) * 3 / 8, 1.0f);
    const float y = x / aspecto(r);
    const glm::mat4 proyeccion = glm::ortho(-x, x, -y, y, -100.0f, 200.0f),
                    camara = camaraOrbita(estado.orbita);
    const glm::mat4 transformacion = proyeccion * camara, M = segunda * primera;
    abreRecuadro(r);
    ponFondo(FONDO_CLARO);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    envia(estado.programa, "proyeccion", proyeccion);
    envia(estado.programa, "camara", camara);
    dibujaObjeto(estado.programa, estado.esfera, M, NARANJA);
    dibujaObjeto(estado.programa, estado.esfera, glm::mat4(1), GRIS);
    trazaEsfera(transformacion * primera, GRIS);
    trazaRegla(M[3], transformacion);
    trazaEjes({32, 5.3f, 9}, transformacion);
    rotulaPunto(nombre, M[3], transformacion, BLANCO, Lado::CENTRO);
    rotulaPunto(nombrePrimera, primera * glm::vec4(-0.7f, 0.7f, 0, 1), transformacion, OSCURO);
}

// Los productos de números que hacen falta para llevar todos los vértices a su sitio: 4×4×4 al multiplicar dos
// matrices, 4×4 al multiplicar una por un vértice.
static std::string productos(const char *de, std::size_t fijos, std::size_t porVertice) {
    const std::string n = std::to_string(fijos + porVertice * estado.vertices);
    return de + std::string(": ") + n + " productos";
}

static void dibuja() {
    const glm::mat4 T = traslacion({5, 0, 0}), S = escalado(5);
    const std::vector<Recuadro> paneles = rejilla(1, 2);
    abreRecuadro(ventanaEntera()); // la raya que separa las dos
    ponFondo(GRIS);
    glClear(GL_COLOR_BUFFER_BIT);
    glUseProgram(estado.programa);
    dibujaVista(T, S, "T·S", "S", paneles[0]);
    if (estado.cuenta)
        rotula(productos("T·(S·v)", 0, 2 * 16) + "\n" + productos("(T·S)·v", 4 * 16, 16), {0.98f, 0.86f},
               MORADO, Lado::IZQUIERDA, 0.034f);
    dibujaVista(S, T, "S·T", "T", paneles[1]);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || tecla != 'c')
        return;
    estado.cuenta = !estado.cuenta;
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "T·S arriba, S·T abajo", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
