// El primer shader: un triángulo rojo (listados 1.2 y 1.3). Leer, compilar, enlazar y obtener índices,
// todo a la vista y sin common/. Del libro se aparta en que los shaders son ficheros, en que un error
// termina el programa y en el VAO, sin el que un contexto core no dibuja.
// Controles: F5 relee los shaders · Esc termina.
#include <GL/glew.h>
#include <GL/freeglut.h>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

static const GLfloat vertices[3][2] = {{-0.8f, -0.7f}, {0.8f, -0.7f}, {0.0f, 0.8f}};

static struct {
    GLuint programa = 0, vao = 0, bufferVertices = 0;
    GLuint posicion = 0; // índice del atributo
    std::string ejecutable;
} estado;

// Los shaders están junto al ejecutable o junto a este fuente, se arranque el programa desde donde se
// arranque.
static std::string lee(const std::string &fichero) {
    std::string lugares;
    for (const std::string &ruta : {estado.ejecutable, std::string(__FILE__)}) {
        const std::string junto = ruta.substr(0, ruta.rfind('/') + 1) + fichero;
        if (std::ifstream f{junto})
            return {std::istreambuf_iterator<char>(f), {}};
        lugares += (lugares.empty() ? "" : ", ") + junto;
    }
    std::fprintf(stderr, "shader_basico: no encuentro «%s»; lo he buscado en %s\n", fichero.c_str(),
                 lugares.c_str());
    std::exit(1);
}

static GLuint compila(GLenum tipo, const std::string &fichero) {
    const std::string fuente = lee(fichero);
    const GLchar *texto = fuente.c_str();
    const GLuint shader = glCreateShader(tipo);
    glShaderSource(shader, 1, &texto, nullptr);
    glCompileShader(shader);

    GLint compilado, longitud;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compilado);
    if (!compilado) {
        glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &longitud);
        std::string informe(static_cast<std::size_t>(longitud), ' ');
        glGetShaderInfoLog(shader, longitud, nullptr, informe.data());
        std::fprintf(stderr, "shader_basico: %s no compila: %s\n", fichero.c_str(), informe.c_str());
        std::exit(1);
    }
    return shader;
}

static void iniciaShader() {
    // 1. Crear y compilar los objetos shader.
    const GLuint vertexShader = compila(GL_VERTEX_SHADER, "shader_basico.vert");
    const GLuint fragmentShader = compila(GL_FRAGMENT_SHADER, "shader_basico.frag");

    // 2. Crear un programa y añadírselos. Marcados para borrar, desaparecerán con él.
    glDeleteProgram(estado.programa);
    estado.programa = glCreateProgram();
    for (GLuint shader : {vertexShader, fragmentShader}) {
        glAttachShader(estado.programa, shader);
        glDeleteShader(shader);
    }

    // 3. Enlazar el programa.
    GLint enlazado, longitud;
    glLinkProgram(estado.programa);
    glGetProgramiv(estado.programa, GL_LINK_STATUS, &enlazado);
    if (!enlazado) {
        glGetProgramiv(estado.programa, GL_INFO_LOG_LENGTH, &longitud);
        std::string informe(static_cast<std::size_t>(longitud), ' ');
        glGetProgramInfoLog(estado.programa, longitud, nullptr, informe.data());
        std::fprintf(stderr, "shader_basico: no enlaza: %s\n", informe.c_str());
        std::exit(1);
    }

    // El índice de la variable `posicion`, para decirle de dónde salen sus valores.
    estado.posicion = static_cast<GLuint>(glGetAttribLocation(estado.programa, "posicion"));
    glVertexAttribPointer(estado.posicion, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(estado.posicion);
}

static void inicia() {
    glGenVertexArrays(1, &estado.vao);
    glBindVertexArray(estado.vao);
    glGenBuffers(1, &estado.bufferVertices);
    glBindBuffer(GL_ARRAY_BUFFER, estado.bufferVertices);
    glBufferData(GL_ARRAY_BUFFER, sizeof vertices, vertices, GL_STATIC_DRAW);
    iniciaShader();
    glClearColor(1.0f, 1.0f, 1.0f, 1.0f);
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
    glutInitWindowSize(800, 600);
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGBA);
    glutInitContextVersion(3, 1);
    glutCreateWindow("Shader básico");
    glewExperimental = GL_TRUE;
    glewInit();
    if (!GLEW_VERSION_3_1) {
        std::fprintf(stderr, "shader_basico: hace falta OpenGL 3.1\n");
        return 1;
    }
    estado.ejecutable = argv[0];
    inicia();
    glutDisplayFunc(dibuja);
    glutReshapeFunc(cambiaTamano);
    glutKeyboardFunc(teclado);
    glutSpecialFunc(tecladoEspecial);
    glutMainLoop();
    return 0;
}
