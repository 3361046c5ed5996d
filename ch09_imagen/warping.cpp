// Warping (figura 9.5): en vez de un rectángulo, una malla; cada vértice conserva su sitio en la imagen (s, t) y cambia
// el que ocupa en la ventana. Los puntos se arrastran y entre ellos pasa una superficie suave (malla_imagen.h). Donde
// la malla se pliega se ve lo de la fila más alta y, en ella, lo de más a la derecha: es lo último que se dibuja.
// Controles: 1 sin deformar · 2 caricatura · m malla · v con el original al lado · ratón arrastra un punto ·
// r rótulos · Esc termina.
#include "malla_en_ventana.h"

static const int COLUMNAS = 11, FILAS = 9;
static const MallaImagen REGULAR = creaMallaImagen(repartidos(COLUMNAS), repartidos(FILAS));

static struct {
    GLuint programa;
    Buferes original, deformada;
    glm::ivec2 talla;
    MallaImagen malla = REGULAR;
    std::size_t punto = 0; // el que se arrastra
    bool arrastra = false, conMalla = false, compara = false, rotulos;
} estado;

/// Ensancha la mandíbula, estrecha la frente y alza las comisuras; el borde de la imagen no se mueve.
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

static void dibujaMalla(const Buferes &buferes, const MallaImagen &malla, const Recuadro &panel,
                        const char *rotulo) {
    dibujaEn(encaja(estado.talla, panel));
    glUseProgram(estado.programa);
    envia(estado.programa, "imagen", 0);
    dibuja(buferes);
    if (estado.conMalla)
        trazaMalla(malla);
    if (estado.rotulos)
        rotulaImagen(rotulo);
}

static void dibuja() {
    abreRecuadro(ventanaEntera(), FONDO_OSCURO);
    cambiaVertices(estado.deformada, triangula(estado.malla, REGULAR));
    const char *rotulo = estado.malla.puntos == REGULAR.puntos ? "Original" : "Deformada";
    if (estado.compara) {
        const std::vector<Recuadro> paneles = panelesPara(2, estado.talla);
        dibujaMalla(estado.original, REGULAR, paneles[0], "Original");
        dibujaMalla(estado.deformada, estado.malla, paneles[1], rotulo);
    } else {
        dibujaMalla(estado.deformada, estado.malla, ventanaEntera(), rotulo);
    }
    ponTitulo(std::string("Warping: ") + rotulo);
    glutSwapBuffers();
}

static glm::vec2 enImagen(int x, int y) {
    return enRecuadro(
        encaja(estado.talla, estado.compara ? panelesPara(2, estado.talla)[1] : ventanaEntera()), x, y);
}

static void raton(int boton, int pulsado, int x, int y) {
    estado.arrastra = boton == GLUT_LEFT_BUTTON && pulsado == GLUT_DOWN;
    if (estado.arrastra)
        estado.punto = masCercano(estado.malla, enImagen(x, y), estado.talla);
}

static void arrastra(int x, int y) {
    if (!estado.arrastra)
        return;
    estado.malla.puntos[estado.punto] = glm::clamp(enImagen(x, y), 0.0f, 1.0f);
    glutPostRedisplay();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    switch (tecla) {
    case '1': estado.malla = REGULAR; break;
    case '2': estado.malla = caricatura(); break;
    case 'm': estado.conMalla = !estado.conMalla; break;
    case 'v': estado.compara = !estado.compara; break;
    case 'r': estado.rotulos = !estado.rotulos; break;
    default: return;
    }
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    const auto [imagenes, propias] =
        abreVentanaConImagenes(argc, argv, "Warping", {{"assets/cara.rgb", 960, 720}});
    estado.programa = creaPrograma("ch09_imagen/warping.vert", "ch09_imagen/imagen.frag");
    estado.original = creaBuferes(triangula(REGULAR, REGULAR));
    estado.deformada = creaBuferes(triangula(REGULAR, REGULAR));
    estado.talla = tallaDe(imagenes[0]);
    estado.rotulos = !propias;
    creaTexturaExacta(imagenes[0]);
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    glutMouseFunc(raton);
    glutMotionFunc(arrastra);
    glutMainLoop();
    return 0;
}
