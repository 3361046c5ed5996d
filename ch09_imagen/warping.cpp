// Warping (figura 9.5): en vez de un rectángulo, una malla; cada vértice conserva su sitio en la imagen (s, t) y cambia
// el que ocupa en la ventana. Los puntos se arrastran y entre ellos pasa una superficie suave (malla_imagen.h). Donde
// la malla se pliega se ve lo de la fila más alta y, en ella, lo de más a la derecha: es lo último que se dibuja.
// Controles: 1 sin deformar · 2 caricatura · m malla · v con el original al lado (y cada una con su malla) ·
// ratón arrastra un punto · r rótulos · Esc termina.
#include "buferes.h"
#include "colores.h"
#include "imagen.h"
#include "imagen_en_ventana.h"
#include "malla_en_ventana.h"
#include "malla_imagen.h"
#include "recuadro.h"
#include "shader.h"
#include "ventana.h"

static const int COLUMNAS = 11, FILAS = 9;
static const MallaImagen REGULAR = creaMallaImagen(repartidos(COLUMNAS), repartidos(FILAS));

static struct {
    GLuint programa;
    Buferes buferes;
    Muestra muestra;
    MallaImagen malla = REGULAR;
    std::size_t punto = 0; // el que se arrastra
    bool arrastra = false, conMalla = false;
} estado;

// Ensancha la mandíbula, estrecha la frente y alza las comisuras; el borde de la imagen no se mueve.
static MallaImagen caricatura() {
    const auto bulto = [](float t) { return std::pow(std::max(1 - t * t, 0.0f), 2.0f); };
    MallaImagen malla = REGULAR;
    for (glm::vec2 &p : malla.puntos) {
        const float x = p.x - 0.5f, y = p.y,
                    dentro = std::min(5 * std::min({p.x, 1 - p.x, p.y, 1 - p.y}), 1.0f);
        p.x += dentro * x * (0.55f * bulto((y - 0.25f) / 0.35f) - 0.45f * bulto((y - 0.75f) / 0.35f));
        p.y += dentro * (2.2f * x * x * bulto((y - 0.25f) / 0.3f) +
                         0.07f * bulto(x / 0.2f) * bulto((y - 0.5f) / 0.25f));
    }
    return malla;
}

static void dibujaDeformada(const MallaImagen &malla, const Recuadro &panel, const char *rotulo,
                            bool conMalla) {
    abreRecuadro(panel);
    glUseProgram(estado.programa);
    envia(estado.programa, "imagen", 0);
    cambiaVertices(estado.buferes, triangulaImagen(malla, REGULAR));
    dibujaMalla(estado.buferes);
    if (conMalla)
        trazaMalla(malla);
    rotulaImagen(estado.muestra, rotulo);
}

// El original y la deformada; con la malla, cada una sin ella y con ella. El último es el que se edita.
static std::vector<Recuadro> paneles() {
    return recuadros(estado.muestra, estado.conMalla ? 4 : 2);
}

static void dibuja() {
    abreRecuadro(ventanaEntera());
    ponFondo(FONDO_OSCURO);
    glClear(GL_COLOR_BUFFER_BIT);
    const char *rotulo = estado.malla.puntos == REGULAR.puntos ? "Original" : "Deformada";
    const std::vector<Recuadro> sitios = paneles();
    if (estado.muestra.compara)
        dibujaDeformada(REGULAR, sitios[0], "Original", false);
    if (sitios.size() == 4) {
        dibujaDeformada(REGULAR, sitios[1], "su malla", true);
        dibujaDeformada(estado.malla, sitios[2], rotulo, false);
    }
    dibujaDeformada(estado.malla, sitios.back(), sitios.size() == 4 ? "su malla" : rotulo, estado.conMalla);
    ponTitulo(std::string("Warping: ") + rotulo);
    glutSwapBuffers();
}

static glm::vec2 enImagen(int x, int y) {
    return enRecuadro(paneles().back(), x, y);
}

static void raton(int boton, int pulsado, int x, int y) {
    if (boton != GLUT_LEFT_BUTTON)
        return;
    estado.arrastra = pulsado == GLUT_DOWN;
    if (estado.arrastra)
        estado.punto = nudoMasCercano(estado.malla, enImagen(x, y), estado.muestra.talla);
}

static void arrastra(int x, int y) {
    if (!estado.arrastra)
        return;
    estado.malla.puntos[estado.punto] = glm::clamp(enImagen(x, y), 0.0f, 1.0f);
    glutPostRedisplay();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaMuestra(estado.muestra, tecla))
        return;
    switch (tecla) {
    case '1': estado.malla = REGULAR; break;
    case '2': estado.malla = caricatura(); break;
    case 'm': estado.conMalla = !estado.conMalla; break;
    default: return;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    const std::vector<Imagen> imagenes =
        abreVentanaConImagenes(argc, argv, "Warping", {{"assets/cara.rgb", 960, 720}}, estado.muestra);
    estado.programa = creaPrograma("ch09_imagen/warping.vert", "ch09_imagen/imagen.frag");
    estado.buferes = creaBuferes(triangulaImagen(REGULAR, REGULAR));
    creaTexturaExacta(imagenes[0]);
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    glutMouseFunc(raton);
    glutMotionFunc(arrastra);
    glutMainLoop();
    return 0;
}
