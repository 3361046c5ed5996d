// Cómo se ve un error de compilación y uno de enlazado (§1.6, listado 1.3): fichero, línea y texto de la línea, en la
// consola, con las palabras del compilador, y, sin ellas, abajo. El programa sigue vivo con los shaders que tenía,
// dentro de un marco rojo; F5 vuelve a intentarlo. Lo que en el libro es initShader lo hace intentaPrograma, que
// también mira los errores (chequeaCompilacion y chequeaEnlazado): está en common/shader.cpp.
// Controles: 1 sin error · 2 error de compilación · 3 error de enlazado · F5 relee · Esc termina.
#include "buferes.h"
#include "colores.h"
#include "modos.h"
#include "recuadro.h"
#include "rotulo.h"
#include "shader.h"
#include "ventana.h"
#include <algorithm>
#include <cstdio>
#include <string>

static const struct {
    const char *fragmentShader, *titulo, *motivo;
} CASOS[] = {{"ch01_intro/errores_shader.frag", "Compila y enlaza", ""},
             {"ch01_intro/errores_shader_compila.frag", "Error de compilación", "a un vec4 se le da un vec3"},
             {"ch01_intro/errores_shader_enlaza.frag", "Error de enlazado",
              "nuevoColor es vec3 en uno y vec4 en otro"}};

static const float CONSOLA = 0.3f, MARCO = 0.02f; // en partes del alto de la ventana

static const std::vector<VerticeColor> VERTICES = {
    {{-0.95f, -0.92f, 0}, AMARILLO}, {{0.95f, -0.92f, 0}, VERDE}, {{0, 0.62f, 0}, AZUL}};

static struct {
    GLuint programa = 0;
    int elegido = 0;
    bool hayError = false;
    std::string dicho;
} estado;

// Dónde está el error y la línea que lo tiene, sin las palabras del compilador: cada OpenGL tiene las suyas.
static std::string lugar(const std::string &error) {
    const std::string raya = " — ";
    std::string texto = error.substr(0, error.find(": "));
    if (const std::size_t y = texto.find(" y "); y != std::string::npos)
        texto[y + 2] = '\n'; // los dos ficheros, cada uno en su renglón
    if (const std::size_t linea = error.find(raya); linea != std::string::npos)
        texto += ":\n" + error.substr(linea + raya.size());
    return texto;
}

static void intenta() {
    std::string error;
    const char *fragmentShader = CASOS[estado.elegido].fragmentShader;
    const GLuint nuevo = intentaPrograma("ch01_intro/errores_shader.vert", fragmentShader, error);
    estado.hayError = nuevo == 0;
    if (nuevo) {
        borraPrograma(estado.programa);
        estado.programa = nuevo;
        std::printf("%s: compila y enlaza\n", fragmentShader);
        estado.dicho = std::string(fragmentShader) + ":\ncompila y enlaza";
    } else {
        std::printf("%s\n", error.c_str());
        estado.dicho = lugar(error) + "\n" + CASOS[estado.elegido].motivo;
    }
    std::fflush(stdout);
    ponTitulo(CASOS[estado.elegido].titulo);
    glutPostRedisplay();
}

static void dibuja() {
    const Recuadro v = ventanaEntera();
    const int marco = int(MARCO * float(v.alto)), alto = int(CONSOLA * float(v.alto));
    const int ancho = std::max(v.ancho - 2 * marco, 1);
    abreRecuadro(v);
    ponFondo(estado.hayError ? ROJO : GRIS);
    glClear(GL_COLOR_BUFFER_BIT);

    const Recuadro escena = {marco, alto, ancho, std::max(v.alto - alto - marco, 1)};
    const int lado = std::min(escena.ancho, escena.alto);
    abreRecuadro(escena);
    ponFondo(FONDO_CLARO);
    glClear(GL_COLOR_BUFFER_BIT);
    glViewport(marco + (escena.ancho - lado) / 2, alto + (escena.alto - lado) / 2, lado, lado);
    glUseProgram(estado.programa);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    abreRecuadro(escena);
    rotula(CASOS[estado.elegido].titulo + std::string(estado.hayError ? ": sigue el de antes" : ""),
           {0.5f, 0.97f}, estado.hayError ? ROJO : OSCURO, Lado::DEBAJO);

    abreRecuadro({marco, marco, ancho, std::max(alto - 2 * marco, 1)});
    ponFondo(FONDO_OSCURO);
    glClear(GL_COLOR_BUFFER_BIT);
    rotula(estado.dicho, {0.03f, 0.5f}, BLANCO, Lado::DERECHA);
    glutSwapBuffers();
}

static void teclado(unsigned char tecla, int, int) {
    if (teclaComun(tecla) || !eligeModo(estado.elegido, 3, tecla))
        return;
    intenta();
}

static void tecladoEspecial(int tecla, int, int) {
    if (tecla == GLUT_KEY_F5)
        intenta();
    else
        teclaEspecialComun(tecla);
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Errores en los shaders", GLUT_DOUBLE | GLUT_MULTISAMPLE);
    creaVerticesColor(VERTICES);
    intenta();
    glutDisplayFunc(dibuja);
    glutKeyboardFunc(teclado);
    glutSpecialFunc(tecladoEspecial);
    glutMainLoop();
    return 0;
}
