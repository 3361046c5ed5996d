// La grúa con eliminación de partes ocultas (ejercicio 4.4): hacen falta GLUT_DEPTH, que abreVentana pide siempre,
// GL_DEPTH_TEST y limpiar el buffer. Sin el test, cada pieza y cada cara tapa lo que se ha pintado antes, esté
// delante o detrás; aquí se pinta de la carga al suelo para que se note.
// Controles: z partes ocultas · p paralela o perspectiva · 1 alzado · 2 planta · 3 perfil · 4 dirección (1,1,1) · 0 las cuatro · a d giran · q e desplazan la carga · w s la suben y bajan · botón derecho menú · ratón orbita la cuarta · Esc termina.
#include "encuadre.h"
#include "malla.h"
#include "orbita.h"
#include "shader.h"
#include "ventana.h"

static const float PASO_GIRO = 0.1f, PASO = 0.5f; // el giro, en radianes
static const glm::vec3 CIELO(0.87f, 0.93f, 0.98f), SUELO(0.62f, 0.72f, 0.58f);
static const glm::vec3 COLOR_EJE[] = {{0.85f, 0.20f, 0.18f}, {0.20f, 0.62f, 0.28f}, {0.16f, 0.38f, 0.80f}};
static const int LAS_CUATRO = -1; // en vez de una de VISTAS

static struct {
    GLuint programa;
    Buferes cubo, cilindro;
    std::vector<glm::dvec3> envolvente = envolventeGrua();
    PosturaGrua postura = {0.58f, 5, 4};
    int vista = DIAGONAL;
    bool enPerspectiva = true, test = true;
    Orbita orbita = {0.785398f, 0.615480f, static_cast<float>(DISTANCIA_CAMARA), CENTRO_GRUA}; // (1,1,1)
} estado;

static void inicia() {
    estado.programa = creaPrograma("ch03_transformaciones/objeto.vert", "ch03_transformaciones/objeto.frag");
    estado.cubo = creaBuferes(cubo());
    estado.cilindro = creaBuferes(cilindro(24));
    glEnable(GL_SCISSOR_TEST);
}

static void dibujaPieza(const Buferes &solido, const glm::mat4 &M, const glm::vec3 &color) {
    const glm::mat3 N = matrizNormal(M);
    envia(estado.programa, "M", M);
    envia(estado.programa, "N", N);
    envia(estado.programa, "colorObjeto", color);
    dibuja(solido);
}

// Limpiar obedece al recorte de glScissor: cada vista limpia lo suyo.
static void limpia(const Recuadro &r, const glm::vec3 &color) {
    glViewport(r.x, r.y, r.ancho, r.alto);
    glScissor(r.x, r.y, r.ancho, r.alto);
    glClearColor(color.r, color.g, color.b, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

static void enviaCamara(const glm::mat4 &camara) {
    envia(estado.programa, "camara", camara);
}

// Los tres ejes, en una esquina, como se ven desde la cámara.
static void dibujaEjes(const Recuadro &r, const glm::dmat4 &camara) {
    const int lado = std::min(r.ancho, r.alto) / 4;
    glViewport(r.x, r.y, lado, lado);
    glClear(GL_DEPTH_BUFFER_BIT);
    enviaCamara(proyeccionParalela(-1.3, 1.3, -1.3, 1.3, -2, 2) * glm::dmat4(glm::dmat3(camara)));
    for (int eje = 0; eje < 3; ++eje)
        dibujaPieza(estado.cilindro, ejeCoordenado(eje, 1.1f, 0.18f), COLOR_EJE[eje]);
}

static glm::dmat4 camara(int i) {
    Vista vista = VISTAS[i];
    if (i == DIAGONAL) {
        estado.orbita.distancia = std::max(estado.orbita.distancia, 12.0f); // fuera de la grúa
        vista.haciaCamara = glm::dvec3(posicionCamara(estado.orbita)) - CENTRO_GRUA;
    }
    return camaraVista(vista);
}

static void dibujaVista(int i, const Recuadro &r, double escala) {
    if (estado.test)
        glEnable(GL_DEPTH_TEST);
    else
        glDisable(GL_DEPTH_TEST);
    limpia(r, CIELO);
    const glm::dmat4 proyeccion = estado.enPerspectiva
                                      ? perspectivaQueEncierra(estado.envolvente, camara(i), r)
                                      : paralelaQueEncierra(estado.envolvente, camara(i), r, escala);
    enviaCamara(proyeccion * camara(i));
    const std::vector<Pieza> piezas = piezasGrua(estado.postura);
    for (auto pieza = piezas.rbegin(); pieza != piezas.rend(); ++pieza)
        dibujaPieza(estado.cubo, pieza->M, pieza->color);
    dibujaPieza(estado.cubo, traslacion({0, -0.1f, 0}) * escalado({20, 0.2f, 20}), SUELO);
    dibujaEjes(r, camara(i));
}

static void dibuja() {
    const int ancho = glutGet(GLUT_WINDOW_WIDTH), alto = glutGet(GLUT_WINDOW_HEIGHT);
    const int marco = (std::min(ancho, alto) + 80) / 100;
    glUseProgram(estado.programa);
    Recuadro recuadros[N_VISTAS] = {};
    double escala = 0;
    for (int i = 0; i < N_VISTAS; ++i) {
        if (estado.vista != LAS_CUATRO && estado.vista != i)
            continue;
        const Recuadro r = estado.vista == i ? Recuadro{0, 0, ancho, alto} : recuadroVista(i, ancho, alto);
        limpia(r, VISTAS[i].colorMarco);
        recuadros[i] = interior(r, marco);
        if (!vacio(recuadros[i]))
            escala = std::max(escala, unidadesPorPixel(estado.envolvente, camara(i), recuadros[i]));
    }
    for (int i = 0; i < N_VISTAS; ++i)
        if (!vacio(recuadros[i]))
            dibujaVista(i, recuadros[i], escala);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla))
        return;
    PosturaGrua &p = estado.postura;
    switch (tecla) {
    case 'a': p.giro += PASO_GIRO; break;
    case 'd': p.giro -= PASO_GIRO; break;
    case 'q': p.distancia -= PASO; break;
    case 'e': p.distancia += PASO; break;
    case 'w': p.altura += PASO; break;
    case 's': p.altura -= PASO; break;
    case 'z': estado.test = !estado.test; break;
    case 'p': estado.enPerspectiva = !estado.enPerspectiva; break;
    default:
        if (tecla < '0' || tecla > '4')
            return;
        estado.vista = tecla - '1';
    }
    p = limita(p);
    glutPostRedisplay();
}

// Cada opción del menú vale lo que su tecla.
static void eligeMenu(int opcion) {
    teclado(static_cast<unsigned char>(opcion), 0, 0);
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "La grúa sin partes ocultas", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutCreateMenu(eligeMenu);
    glutAddMenuEntry("Con o sin partes ocultas", 'z');
    glutAddMenuEntry("Paralela o perspectiva", 'p');
    glutAddMenuEntry("Alzado", '1');
    glutAddMenuEntry("Planta", '2');
    glutAddMenuEntry("Perfil", '3');
    glutAddMenuEntry("(1,1,1)", '4');
    glutAddMenuEntry("Las cuatro", '0');
    glutAttachMenu(GLUT_RIGHT_BUTTON);
    glutMainLoop();
    return 0;
}
