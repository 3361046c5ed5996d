#include "shader.h"
#include "error.h"
#include "rutas.h"
#include <glm/gtc/type_ptr.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

namespace {

struct Linea {
    std::string fichero, texto;
    int numero;
};

struct Registrado {
    GLuint programa;
    std::string vert, frag;
};
std::vector<Registrado> registrados;

/// Lee un shader línea a línea, con los #include en su sitio; cada línea recuerda de dónde viene.
void leeLineas(const std::string &fichero, std::vector<Linea> &lineas, int nivel = 0) {
    if (nivel > 8)
        falla("«" + fichero + "»: demasiados #include anidados");
    static const std::regex inclusion(R"re(^\s*#include\s+"([^"]+)"\s*$)re");
    std::istringstream texto(leeFichero(recurso(fichero)));
    std::string linea;
    std::smatch m;
    for (int numero = 1; std::getline(texto, linea); ++numero) {
        if (std::regex_match(linea, m, inclusion))
            leeLineas(m[1], lineas, nivel + 1);
        else
            lineas.push_back({fichero, linea, numero});
    }
}

/// Traduce el informe del compilador a «fichero:línea: mensaje — «texto»». Cada fabricante numera a
/// su manera: Mesa «0:12(5): …», NVIDIA «0(12) : …», AMD e Intel «ERROR: 0:12: …».
std::string traduceInforme(const std::string &informe, const std::vector<Linea> &lineas) {
    static const std::regex lugar(
        R"re(^(?:ERROR: |WARNING: )?\d+(?::(\d+)(?:\(\d+\))?|\((\d+)\))\s*:\s*(.*)$)re");
    std::istringstream entrada(informe);
    std::string linea, salida;
    std::size_t anterior = 0;
    while (std::getline(entrada, linea)) {
        if (linea.empty() || linea[0] == '\0')
            continue;
        std::smatch m;
        if (std::regex_match(linea, m, lugar)) {
            const std::size_t n = std::stoul(m[1].matched ? m[1] : m[2]);
            if (n == anterior)
                continue; // los demás errores de una línea suelen venir del primero
            anterior = n;
            if (n >= 1 && n <= lineas.size()) {
                const Linea &l = lineas[n - 1];
                const std::size_t sangria = std::min(l.texto.find_first_not_of(" \t"), l.texto.size());
                linea = l.fichero + ":" + std::to_string(l.numero) + ": " + m[3].str() + " — «" +
                        l.texto.substr(sangria) + "»";
            }
        }
        salida += (salida.empty() ? "" : "\n") + linea;
    }
    return salida;
}

GLuint compila(GLenum tipo, const std::string &fichero, std::string &error) {
    std::vector<Linea> lineas;
    leeLineas(fichero, lineas);
    std::string texto;
    for (const Linea &l : lineas)
        texto += l.texto + '\n';

    const GLuint shader = glCreateShader(tipo);
    const GLchar *fuente = texto.c_str();
    glShaderSource(shader, 1, &fuente, nullptr);
    glCompileShader(shader);

    GLint compilado = GL_FALSE, longitud = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compilado);
    if (compilado)
        return shader;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &longitud);
    std::string informe(static_cast<std::size_t>(longitud) + 1, '\0');
    glGetShaderInfoLog(shader, longitud + 1, nullptr, informe.data());
    error = traduceInforme(informe.c_str(), lineas);
    if (error.empty())
        error = fichero + ": no compila y el compilador no dice por qué";
    glDeleteShader(shader);
    return 0;
}

} // namespace

GLuint intentaPrograma(const std::string &vert, const std::string &frag, std::string &error) {
    const GLuint vertexShader = compila(GL_VERTEX_SHADER, vert, error);
    const GLuint fragmentShader = vertexShader ? compila(GL_FRAGMENT_SHADER, frag, error) : 0;
    if (!fragmentShader) {
        glDeleteShader(vertexShader); // 0 se ignora
        return 0;
    }
    const GLuint programa = glCreateProgram();
    glAttachShader(programa, vertexShader);
    glAttachShader(programa, fragmentShader);
    glDeleteShader(vertexShader); // quedan marcados: mueren con el programa
    glDeleteShader(fragmentShader);
    glBindAttribLocation(programa, ATRIBUTO_POSICION, "posicion");
    glBindAttribLocation(programa, ATRIBUTO_NORMAL, "vNormal");
    glBindAttribLocation(programa, ATRIBUTO_COORD_TEXTURA, "coordTextura");
    glBindAttribLocation(programa, ATRIBUTO_COLOR, "color");
    glLinkProgram(programa);

    GLint enlazado = GL_FALSE, longitud = 0;
    glGetProgramiv(programa, GL_LINK_STATUS, &enlazado);
    if (enlazado)
        return programa;
    glGetProgramiv(programa, GL_INFO_LOG_LENGTH, &longitud);
    std::string informe(static_cast<std::size_t>(longitud) + 1, '\0');
    glGetProgramInfoLog(programa, longitud + 1, nullptr, informe.data());
    error = traduceInforme(informe.c_str(), {});
    error = vert + " y " + frag + " no enlazan: " + (error.empty() ? "el enlazador no dice por qué" : error);
    glDeleteProgram(programa);
    return 0;
}

GLuint creaPrograma(const std::string &vert, const std::string &frag) {
    std::string error;
    const GLuint programa = intentaPrograma(vert, frag, error);
    if (!programa)
        falla(error);
    registrados.push_back({programa, vert, frag});
    return programa;
}

GLint uniforme(GLuint programa, const char *nombre) {
    const GLint posicion = glGetUniformLocation(programa, nombre);
    static std::set<std::pair<GLuint, std::string>> avisados;
    if (posicion == -1 && avisados.insert({programa, nombre}).second) {
        std::string shaders = "el programa";
        for (const Registrado &r : registrados)
            if (r.programa == programa)
                shaders = r.vert + " y " + r.frag;
        avisa("el uniform «" + std::string(nombre) + "» no está o no se usa en " + shaders);
    }
    return posicion;
}

void envia(GLuint programa, const char *nombre, float valor) {
    glUniform1f(uniforme(programa, nombre), valor);
}
void envia(GLuint programa, const char *nombre, int valor) {
    glUniform1i(uniforme(programa, nombre), valor);
}
void envia(GLuint programa, const char *nombre, const glm::vec2 &valor) {
    glUniform2fv(uniforme(programa, nombre), 1, glm::value_ptr(valor));
}
void envia(GLuint programa, const char *nombre, const glm::vec3 &valor) {
    glUniform3fv(uniforme(programa, nombre), 1, glm::value_ptr(valor));
}
void envia(GLuint programa, const char *nombre, const glm::vec4 &valor) {
    glUniform4fv(uniforme(programa, nombre), 1, glm::value_ptr(valor));
}
void envia(GLuint programa, const char *nombre, const glm::mat3 &valor) {
    glUniformMatrix3fv(uniforme(programa, nombre), 1, GL_FALSE, glm::value_ptr(valor));
}
void envia(GLuint programa, const char *nombre, const glm::mat4 &valor) {
    glUniformMatrix4fv(uniforme(programa, nombre), 1, GL_FALSE, glm::value_ptr(valor));
}

void recargaProgramas() {
    for (const Registrado &r : registrados) {
        std::string error;
        const GLuint nuevo = intentaPrograma(r.vert, r.frag, error);
        if (!nuevo) {
            avisa(error);
            continue;
        }
        // El nombre del programa es el que la aplicación conoce: se le cambian los shaders y se reenlaza.
        GLuint viejos[2], nuevos[2];
        glGetAttachedShaders(r.programa, 2, nullptr, viejos);
        glGetAttachedShaders(nuevo, 2, nullptr, nuevos);
        for (int i = 0; i < 2; ++i) {
            glDetachShader(r.programa, viejos[i]);
            glAttachShader(r.programa, nuevos[i]);
        }
        glLinkProgram(r.programa);
        glDeleteProgram(nuevo);
    }
}
