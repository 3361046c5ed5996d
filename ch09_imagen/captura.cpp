// Guardar lo que se ve (listado 9.4) y volver a leerlo: glReadPixels con GL_PACK_ALIGNMENT 1 lleva la ventana a memoria
// y un PPM, a un fichero; lo leído del fichero se enseña en la esquina. El segundo paso del listado, fopen, fwrite y
// fclose, está en intentaGuardarPpm (common/imagen.cpp), y en vez de calloc y free hay un std::vector. Se aparta del
// libro en que el fichero lleva su tamaño, en que la fila de arriba va la primera (glReadPixels empieza por la de
// abajo), en que se lee el buffer de detrás antes de intercambiarlos y en que se guarda entero o nada, y si no se puede
// se dice por qué. Lo que se enseña de la captura anterior no se guarda.
// Controles: g guarda y lee · a d q e w s mueven la grúa · ratón orbita · Esc termina.
#include "buferes.h"
#include "ch03_transformaciones/grua.h"
#include "ch03_transformaciones/objeto.h"
#include "ch03_transformaciones/transformaciones.h"
#include "colores.h"
#include "error.h"
#include "imagen.h"
#include "imagen_en_ventana.h"
#include "malla.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "trazo.h"
#include "ventana.h"

static const glm::mat4 SUELO_GRUA = traslacion({0, -0.1f, 0}) * escalado({14, 0.2f, 14});

static struct {
    GLuint programa, programaCopia, textura = 0;
    Buferes cubo;
    PosturaGrua postura;
    Orbita orbita = {0.51f, 0.25f, 51.5f, {-2.6f, 5.4f, 1.4f}, 0.02f};
    std::string fichero = "captura.ppm", resultado;
    glm::ivec2 talla; // de la captura leída
    bool guarda = false;
} estado;

static void inicia() {
    estado.programa = creaProgramaObjeto();
    estado.programaCopia = creaPrograma("ch09_imagen/imagen.vert", "ch09_imagen/imagen.frag");
    estado.cubo = creaBuferes(cubo());
    // Con 4, lo normal, cada fila acabaría en un múltiplo de 4 bytes, al leer la ventana y al crear la textura.
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

static void dibujaGrua() {
    abreRecuadro(ventanaEntera());
    ponFondo(CIELO);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glUseProgram(estado.programa);
    const glm::mat4 camara = camaraOrbita(estado.orbita),
                    proyeccion = perspectivaVentana(ANGULO_GRUA, 1, 200);
    envia(estado.programa, "proyeccion", proyeccion);
    envia(estado.programa, "camara", camara);
    dibujaObjeto(estado.programa, estado.cubo, SUELO_GRUA, SUELO);
    for (const Pieza &pieza : piezasGrua(estado.postura))
        dibujaObjeto(estado.programa, estado.cubo, pieza.M, pieza.color);
    glDisable(GL_DEPTH_TEST);
}

// Listado 9.4: primero a memoria, después al fichero; y de vuelta.
static void guardaYLee() {
    Imagen imagen{glutGet(GLUT_WINDOW_WIDTH), glutGet(GLUT_WINDOW_HEIGHT), {}};
    imagen.rgb.resize(std::size_t(3) * imagen.ancho * imagen.alto);
    glReadPixels(0, 0, imagen.ancho, imagen.alto, GL_RGB, GL_UNSIGNED_BYTE, imagen.rgb.data());
    if (!intentaGuardarPpm(estado.fichero, imagen, "", estado.resultado)) {
        avisa(estado.resultado);
        estado.resultado = "no se ha podido guardar";
        return;
    }
    const Imagen leida = leePpm(estado.fichero);
    glDeleteTextures(1, &estado.textura);
    estado.textura = creaTexturaExacta(leida);
    estado.talla = tallaDe(leida);
    estado.resultado = std::to_string(leida.ancho) + "×" + std::to_string(leida.alto) +
                       (leida.rgb == imagen.rgb ? ", idéntica" : ", distinta");
}

// Lo leído, en la esquina de arriba a la izquierda, con un marco; mientras no hay nada, el marco.
static void dibujaLeida() {
    const Recuadro v = ventanaEntera();
    const Recuadro esquina = {v.ancho / 40, v.alto * 39 / 40 - v.alto / 3, v.ancho / 3, v.alto / 3};
    const Recuadro r = encaja(estado.textura ? estado.talla : glm::ivec2(4, 3), esquina);
    if (!estado.textura) {
        abreRecuadro(r);
        trazaPolilinea({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, glm::mat4(1), NARANJA, GROSOR, true);
        rotula("g guarda\ny lee", {0.5f, 0.5f}, OSCURO);
        return;
    }
    const int marco = std::max(v.alto / 120, 1);
    abreRecuadro({r.x - marco, r.y - marco, r.ancho + 2 * marco, r.alto + 2 * marco});
    ponFondo(NARANJA);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    abreRecuadro(r);
    glUseProgram(estado.programaCopia);
    envia(estado.programaCopia, "imagen", 0);
    dibujaRectangulo();
}

static void dibuja() {
    dibujaGrua();
    if (estado.guarda)
        guardaYLee();
    estado.guarda = false;
    dibujaLeida();
    abreRecuadro(ventanaEntera());
    if (!estado.resultado.empty())
        rotula(estado.resultado, {0.19f, 0.62f}, OSCURO, Lado::DEBAJO, 0.03f);
    ponTitulo("Captura" + (estado.resultado.empty() ? "" : ": " + estado.resultado));
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    if (tecla == 'g')
        estado.guarda = true;
    else if (!mueve(estado.postura, tecla))
        return;
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Captura", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE, "[FICHERO.ppm]");
    if (argc > 2)
        falla("sobra «" + std::string(argv[2]) + "»: solo se guarda un fichero", 2);
    if (argc == 2)
        estado.fichero = argv[1];
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMainLoop();
    return 0;
}
