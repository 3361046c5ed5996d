// Un vértice (el cuadrado rojo) por las etapas del pipeline (ejercicio 4.1, ecuación 4.4). Un panel para cada una:
// coordenadas del objeto, del mundo con el volumen de la vista, normalizadas del dispositivo y de ventana; las
// cuentas, por la salida estándar. Con r, un triángulo que se sale del volumen y llega detrás del ojo: etapas.h lo
// recorta, y el polígono que queda (borde morado) es justo lo que dibuja OpenGL.
// Controles: clic elige vértice · r recortado · arrastrar orbita por fuera · Esc termina.
#include "malla.h"
#include "orbita.h"
#include "paneles.h"
#include "shader.h"
#include "ventana.h"

static const double ANGULO = 0.62, CERCA = 4, LEJOS = 8.5; // de la cámara; el ángulo, en radianes
static const glm::dvec3 ojo(2.0, 3.4, 5.4), interes(0.1, 0.7, 0);
static const glm::vec3 rojo(0.85f, 0.20f, 0.18f), verde(0.20f, 0.62f, 0.28f), azul(0.16f, 0.38f, 0.80f),
    naranja(0.95f, 0.55f, 0.10f), amarillo(0.98f, 0.78f, 0.15f), morado(0.50f, 0.25f, 0.65f),
    gris(0.55f, 0.58f, 0.62f), oscuro(0.16f, 0.17f, 0.20f);
static const glm::vec3 fondos[] = {
    {0.95f, 0.96f, 0.98f}, {0.90f, 0.95f, 0.89f}, {0.98f, 0.94f, 0.88f}, {0.78f, 0.88f, 0.96f}};

static struct {
    GLuint deObjetos, deLineas, vao, bufer;
    std::vector<glm::vec3> vertices[2]; // el objeto: el cubo, o el triángulo que se recorta
    Buferes objetos[2];
    int cual = 0;
    std::size_t elegido = 14;
    Matrices m;
    std::array<Panel, PANELES> paneles;
    std::string escrito;
    Orbita orbita = {0.95f, 0.35f, 1}; // la distancia multiplica la de cada panel
} estado;

static void inicia() {
    estado.deObjetos = creaPrograma("ch04_vista3d/volumen_vista.vert", "ch04_vista3d/volumen_vista.frag");
    estado.deLineas = creaPrograma("ch04_vista3d/linea.vert", "ch04_vista3d/linea.frag");
    Malla mallas[] = {cubo(), {{}, {0, 1, 2}}};
    for (const glm::vec3 &v : {glm::vec3(-0.7f, 0.8f, -0.5f), {0.9f, -0.2f, 5}, {1.5f, -0.6f, -1.4f}})
        mallas[1].vertices.push_back({v, {0, 1, 0}, {0, 0}});
    for (int k = 0; k < 2; ++k) {
        estado.objetos[k] = creaBuferes(mallas[k]);
        for (const Vertice &v : mallas[k].vertices)
            estado.vertices[k].push_back(v.posicion);
    }
    glGenVertexArrays(1, &estado.vao);
    glBindVertexArray(estado.vao);
    glGenBuffers(1, &estado.bufer);
    glBindBuffer(GL_ARRAY_BUFFER, estado.bufer);
    glVertexAttribPointer(ATRIBUTO_POSICION, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(ATRIBUTO_POSICION);
    glEnable(GL_SCISSOR_TEST); // cada panel borra solo lo suyo
}

// Las matrices de todas las etapas, y las de los paneles.
static void calculaMatrices() {
    auto &p = estado.paneles = reparte(glutGet(GLUT_WINDOW_WIDTH), glutGet(GLUT_WINDOW_HEIGHT));
    const Panel &v = p[VENTANA];
    const double aspecto = static_cast<double>(v.ancho) / v.alto;
    estado.m = {traslacion({0.2f, 0.8f, 0.3f}) * giroY(-0.35f) * escalado({2.0f, 1.2f, 1.4f}),
                transformacionCamara(ojo, interes, {0, 1, 0}),
                proyeccionPerspectiva(anguloEnY(ANGULO, aspecto), aspecto, CERCA, LEJOS),
                transformacionViewport(v.x, v.y, v.ancho, v.alto)};
    colocaMatrices(p, estado.m);
    const Orbita &o = estado.orbita;
    const auto camara = [&](const glm::vec3 &centro, float distancia) {
        return perspectivaVentana(0.5f, 0.5f, 100, static_cast<float>(aspecto)) *
               camaraOrbita({o.azimut, o.elevacion, o.distancia * distancia, centro});
    };
    p[OBJETO].camara = camara({0, 0, 0}, estado.cual ? 8.0f : 4.0f);
    p[MUNDO].camara = camara({0.2f, 1.3f, 0.6f}, 15.5f);
    // En NDC la profundidad crece hacia el fondo, base a izquierdas: para verla así se cambia el signo de z.
    p[NDC].camara = camara({0, 0, 0}, 7.2f) * escalado({1, 1, -1});
}

// El objeto, con la luz del mundo en todos los paneles y en gris lo que queda fuera del volumen.
static void dibujaObjeto(const glm::dmat4 &deRecortado) {
    const glm::dmat4 volumen = estado.m.MProy * estado.m.MC;
    const glm::mat4 M(estado.m.MM), camara(deRecortado * volumen), enFloat(volumen);
    const GLuint p = estado.deObjetos;
    glUseProgram(p);
    envia(p, "M", M);
    envia(p, "N", matrizNormal(M));
    envia(p, "volumen", enFloat);
    envia(p, "camara", camara);
    envia(p, "colorObjeto", amarillo);
    dibuja(estado.objetos[estado.cual]);
}

static void dibujaPuntos(GLenum primitiva, const std::vector<glm::vec4> &puntos, const glm::mat4 &camara,
                         const glm::vec3 &color) {
    glUseProgram(estado.deLineas);
    envia(estado.deLineas, "camara", camara);
    envia(estado.deLineas, "colorObjeto", color);
    glBindVertexArray(estado.vao);
    glBindBuffer(GL_ARRAY_BUFFER, estado.bufer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(puntos.size() * sizeof(glm::vec4)), puntos.data(),
                 GL_STREAM_DRAW);
    glDrawArrays(primitiva, 0, static_cast<GLsizei>(puntos.size()));
}

static void dibujaPanel(int k, const glm::vec4 &vertice, const std::vector<glm::vec4> &poligono) {
    const Panel &p = estado.paneles[static_cast<std::size_t>(k)];
    const glm::dmat4 deRecortado = p.camara * p.deRecortado;
    const float grueso = std::max(static_cast<float>(std::min(p.ancho, p.alto)) / 45, 1.0f);
    const bool delante = k == OBJETO || k == MUNDO || vertice.w > 0; // si no, tampoco tiene sitio en NDC
    glViewport(p.x, p.y, p.ancho, p.alto);
    glScissor(p.x, p.y, p.ancho, p.alto);
    glClearColor(fondos[k].r, fondos[k].g, fondos[k].b, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glLineWidth(grueso);
    glPointSize(2 * std::floor(grueso) + 5);
    if (k == NDC && estado.cual) // lo de detrás del ojo no tiene sitio en NDC: solo lo que queda
        dibujaPuntos(GL_TRIANGLE_FAN, poligono, deRecortado, amarillo);
    else
        dibujaObjeto(deRecortado);
    if (k == OBJETO || k == MUNDO) {
        dibujaPuntos(GL_LINES, {{0, 0, 0, 1}, {1, 0, 0, 1}}, p.camara, rojo);
        dibujaPuntos(GL_LINES, {{0, 0, 0, 1}, {0, 1, 0, 1}}, p.camara, verde);
        dibujaPuntos(GL_LINES, {{0, 0, 0, 1}, {0, 0, 1, 1}}, p.camara, azul);
    }
    if (k == MUNDO || k == NDC) {
        dibujaPuntos(GL_LINES, aristasVolumen(0), deRecortado, oscuro);
        dibujaPuntos(GL_LINES, aristasVolumen(-1), deRecortado, naranja);
        dibujaPuntos(GL_LINES, aristasVolumen(1), deRecortado, azul);
        glLineWidth(std::max(grueso / 2, 1.0f));
        const glm::vec4 delOjo(0, 0, -1, 0); // en coordenadas de recortado el ojo está en el infinito
        for (const glm::vec4 &esquina : aristasVolumen(-1))
            dibujaPuntos(GL_LINES, {delOjo, esquina}, deRecortado, gris);
        if (delante)
            dibujaPuntos(GL_LINES, {delOjo, vertice}, deRecortado, rojo);
    }
    glDisable(GL_DEPTH_TEST); // lo que se señala, aunque esté tapado
    glLineWidth(grueso);
    dibujaPuntos(GL_LINE_LOOP, poligono, deRecortado, morado);
    if (delante)
        dibujaPuntos(GL_POINTS, {vertice}, deRecortado, rojo);
}

static void dibuja() {
    calculaMatrices();
    const std::vector<glm::vec3> &vertices = estado.vertices[estado.cual];
    const Etapas e = recorre(vertices[estado.elegido], estado.m);
    const auto poligono = estado.cual ? recorta(vertices, estado.m) : std::vector<glm::dvec4>();
    const std::string texto =
        "vértice: " + std::to_string(estado.elegido) + "\n" + describe(e) + describe(poligono, estado.m.Mvp);
    if (texto != estado.escrito) // al orbitar por fuera no cambia nada
        std::fputs(texto.c_str(), stdout);
    estado.escrito = texto;
    for (int k = 0; k < PANELES; ++k)
        dibujaPanel(k, e.recortado, {poligono.begin(), poligono.end()});
    glutSwapBuffers();
}

static void raton(int boton, int pulsado, int x, int y) {
    if (boton == GLUT_LEFT_BUTTON && pulsado == GLUT_DOWN)
        estado.elegido = verticeSenalado(estado.paneles, estado.vertices[estado.cual], x,
                                         glutGet(GLUT_WINDOW_HEIGHT) - 1 - y, estado.elegido);
    orbitaBoton(boton, pulsado, x, y);
    glutPostRedisplay();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || tecla != 'r')
        return;
    estado.cual = 1 - estado.cual;
    estado.elegido = 0;
    glutPostRedisplay();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Las etapas del pipeline", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    inicia();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    orbitaConRaton(estado.orbita);
    glutMouseFunc(raton);
    glutMainLoop();
    return 0;
}
