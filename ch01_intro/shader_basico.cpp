// El primer shader: un triángulo rojo (listados 1.2 y 1.3). Leer, compilar, enlazar y obtener índices, todo a la vista
// y sin common/. Del libro se aparta en que los shaders son ficheros, en que un error al empezar termina el programa
// (con F5 se queda el programa que había) y en el VAO, sin el que un contexto core no dibuja. La función initShader es
// aquí iniciaShader; chequeaCompilacion y chequeaEnlazado están dentro de compila y enlaza. Los pasos, como en §1.6.
// Controles: F5 relee los shaders · Esc termina.
#include <GL/glew.h>
#include <GL/freeglut.h>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

static const GLfloat VERTICES[3][2] = {{-0.95f, -0.82f}, {0.95f, -0.82f}, {0.0f, 0.82f}};

static struct {
    std::filesystem::path ejecutable;
    GLuint programa = 0, vao = 0, bufferVertices = 0;
} estado;

static GLuint avisa(const std::string &mensaje) {
    std::fprintf(stderr, "shader_basico: %s\n", mensaje.c_str());
    std::fflush(stderr);
    return 0;
}

// Los shaders están en ch01_intro, junto a la carpeta del ejecutable (árbol instalado) o en el árbol de fuentes, que
// dice CMake: LAB_FUENTES. La ruta de __FILE__ no valdría: puede ser relativa a la carpeta en que se compiló.
static std::string lee(const std::string &fichero) {
    using std::filesystem::u8path;
    for (const auto &raiz : {estado.ejecutable.parent_path() / "..", u8path(LAB_FUENTES)})
        if (std::ifstream f{raiz / "ch01_intro" / fichero})
            return {std::istreambuf_iterator<char>(f), {}};
    return "";
}

// Devuelve 0 si no compila.
static GLuint compila(GLenum tipo, const std::string &fichero) {
    const std::string fuente = lee(fichero);
    if (fuente.empty())
        return avisa("«" + fichero +
                     "» no está, o está vacío, en la carpeta ch01_intro: ni junto a la del ejecutable ni "
                     "en " LAB_FUENTES);
    const GLchar *texto = fuente.c_str();
    const GLuint shader = glCreateShader(tipo);
    glShaderSource(shader, 1, &texto, nullptr);
    glCompileShader(shader);

    GLint compilado, longitud;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compilado);
    if (compilado)
        return shader;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &longitud);
    std::string informe(longitud, ' ');
    glGetShaderInfoLog(shader, longitud, nullptr, informe.data());
    glDeleteShader(shader);
    return avisa(fichero + " no compila: " + informe.c_str());
}

// Devuelve 0 si no enlaza.
static GLuint enlaza(GLuint vertexShader, GLuint fragmentShader) {
    // 2. Crear un programa y añadirle los objetos compilados.
    const GLuint programa = glCreateProgram();
    for (GLuint shader : {vertexShader, fragmentShader}) {
        glAttachShader(programa, shader);
        glDeleteShader(shader); // marcado para borrar: desaparecerá con el programa
    }
    // 3. Enlazar el programa: un ejecutable.
    GLint enlazado, longitud;
    glLinkProgram(programa);
    glGetProgramiv(programa, GL_LINK_STATUS, &enlazado);
    if (enlazado)
        return programa;
    glGetProgramiv(programa, GL_INFO_LOG_LENGTH, &longitud);
    std::string informe(longitud, ' ');
    glGetProgramInfoLog(programa, longitud, nullptr, informe.data());
    glDeleteProgram(programa);
    return avisa(std::string("los shaders no enlazan: ") + informe.c_str());
}

// Si algo falla, el programa que hubiera sigue en uso.
static void iniciaShader() {
    // 1. Crear y compilar los objetos shader.
    const GLuint vertexShader = compila(GL_VERTEX_SHADER, "shader_basico.vert"),
                 fragmentShader = compila(GL_FRAGMENT_SHADER, "shader_basico.frag");

    if (!vertexShader || !fragmentShader) {
        glDeleteShader(vertexShader); // borrar el 0 no hace nada
        glDeleteShader(fragmentShader);
        return;
    }

    // 2 y 3. Añadirlos a un programa y enlazarlo.
    const GLuint programa = enlaza(vertexShader, fragmentShader);
    if (!programa)
        return;

    // Y el índice de la variable `posicion`, para decirle de dónde salen sus valores.
    const GLint posicion = glGetAttribLocation(programa, "posicion");
    if (posicion < 0) {
        avisa("shader_basico.vert no usa «posicion»");
        glDeleteProgram(programa);
        return;
    }
    glVertexAttribPointer(posicion, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(posicion);
    glDeleteProgram(estado.programa);
    estado.programa = programa;
}

static void inicia() {
    glGenVertexArrays(1, &estado.vao);
    glBindVertexArray(estado.vao);
    glGenBuffers(1, &estado.bufferVertices);
    glBindBuffer(GL_ARRAY_BUFFER, estado.bufferVertices);
    glBufferData(GL_ARRAY_BUFFER, sizeof VERTICES, VERTICES, GL_STATIC_DRAW);
    iniciaShader();
    glClearColor(0.95f, 0.96f, 0.98f, 1.0f);
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT);
    glUseProgram(estado.programa);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glutSwapBuffers();
}

// El mayor cuadrado centrado que cabe: el triángulo conserva su forma en cualquier ventana.
static void cambiaTamano(int ancho, int alto) {
    const int lado = std::max(std::min(ancho, alto), 1);
    glViewport((ancho - lado) / 2, (alto - lado) / 2, lado, lado);
}

static void teclado(unsigned char tecla, int, int) {
    const unsigned char ESC = 27;
    if (tecla == ESC)
        glutLeaveMainLoop();
}

static void tecladoEspecial(int tecla, int, int) {
    if (tecla == GLUT_KEY_F5) {
        iniciaShader();
        glutPostRedisplay();
    }
}

int main(int argc, char **argv) {
    glutInitWindowSize(960, 720);
    glutInit(&argc, argv);
    if (argc > 1) { // glutInit ha quitado sus opciones
        const bool ayuda = std::string(argv[1]) == "-ayuda";
        std::fprintf(ayuda ? stdout : stderr, "uso: shader_basico [opciones de GLUT]\n");
        return ayuda ? 0 : 2;
    }
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGBA);
    glutInitContextVersion(3, 1);
    glutCreateWindow("Primer shader");
    glewExperimental = GL_TRUE;
    glewInit();
    if (!GLEW_VERSION_3_1) {
        avisa("hace falta OpenGL 3.1");
        return 1;
    }
    estado.ejecutable = std::filesystem::u8path(argv[0]);
    inicia();
    if (!estado.programa)
        return 1;
    glutDisplayFunc(dibuja);
    glutReshapeFunc(cambiaTamano);
    glutKeyboardFunc(teclado);
    glutSpecialFunc(tecladoEspecial);
    glutMainLoop();
    return 0;
}
