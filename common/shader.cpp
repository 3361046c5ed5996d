#include "shader.h"
#include "error.h"
#include "rutas.h"
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <glm/gtc/type_ptr.hpp>
#include <map>
#include <set>
#include <sstream>
#include <string_view>
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

std::map<std::string, std::filesystem::file_time_type> leidos; // de cada fichero, de cuándo era

std::filesystem::file_time_type fecha(const std::string &ruta) {
    std::error_code nadie; // el que no está, porque un editor lo cambia por otro, es muy antiguo
    return std::filesystem::last_write_time(std::filesystem::u8path(ruta), nadie);
}

// Quita los blancos de delante y de detrás.
std::string_view recorta(std::string_view texto) {
    const std::size_t inicio = std::min(texto.find_first_not_of(" \t\r\v\f"), texto.size());
    return texto.substr(inicio, texto.find_last_not_of(" \t\r\v\f") + 1 - inicio);
}

// El fichero que nombra una línea «#include "fichero"»; vacío si la línea no es eso.
std::string_view incluidoEn(std::string_view linea) {
    const std::string_view orden = "#include";
    linea = recorta(linea);
    if (linea.substr(0, orden.size()) != orden)
        return {};
    linea = recorta(linea.substr(orden.size()));
    const bool entreComillas =
        linea.size() > 2 && linea.find('"') == 0 && linea.find('"', 1) == linea.size() - 1;
    return entreComillas ? linea.substr(1, linea.size() - 2) : std::string_view();
}

// Lee un shader línea a línea, con los #include en su sitio; cada línea recuerda de dónde viene. `pila`: los
// ficheros que se están leyendo, cada uno incluido por el anterior.
bool leeLineas(const std::string &fichero, std::vector<Linea> &lineas, std::vector<std::string> &pila,
               std::string &error) {
    std::string ruta, contenido, linea;
    if (!intentaRecurso(fichero, ruta, error))
        return false;
    leidos[ruta] = fecha(ruta);
    if (!intentaLeer(ruta, contenido, error))
        return false;
    if (const std::string_view bom = "\xEF\xBB\xBF"; contenido.substr(0, bom.size()) == bom)
        contenido.erase(0, bom.size()); // lo pone el Bloc de notas de Windows
    pila.push_back(fichero);
    std::istringstream texto(contenido);
    for (int numero = 1; std::getline(texto, linea); ++numero) {
        const std::string incluido(incluidoEn(linea));
        if (incluido.empty()) {
            lineas.push_back({fichero, linea, numero});
            continue;
        }
        const auto ciclo = std::find(pila.begin(), pila.end(), incluido);
        if (ciclo != pila.end()) {
            error = "#include sin fin: ";
            std::for_each(ciclo, pila.end(), [&](const std::string &f) { error += f + " → "; });
            error += incluido;
        } else if (leeLineas(incluido, lineas, pila, error)) {
            continue;
        }
        error = fichero + ":" + std::to_string(numero) + ": " + error;
        return false;
    }
    pila.pop_back();
    return true;
}

// Una línea del informe del compilador: la del texto de la que habla y lo que dice.
struct Aviso {
    std::size_t linea = 0;
    std::string_view mensaje;
};

// Cada fabricante numera a su manera: Mesa «0:12(5): …», NVIDIA «0(12) : …», AMD, Intel y WebGL «ERROR: 0:12: …».
bool analizaAviso(std::string_view texto, Aviso &aviso) {
    const auto toma = [&texto](std::string_view que) {
        const bool esta = texto.substr(0, que.size()) == que;
        texto.remove_prefix(esta ? que.size() : 0);
        return esta;
    };
    const auto tomaNumero = [&texto](std::size_t &n) {
        const auto [fin, mal] = std::from_chars(texto.data(), texto.data() + texto.size(), n);
        texto.remove_prefix(fin - texto.data());
        return mal == std::errc();
    };
    std::size_t unidad, columna;
    if (!toma("ERROR: "))
        toma("WARNING: ");
    if (!tomaNumero(unidad))
        return false;
    const bool lugar = toma("(") ? tomaNumero(aviso.linea) && toma(")")
                                 : toma(":") && tomaNumero(aviso.linea) &&
                                       (!toma("(") || (tomaNumero(columna) && toma(")")));
    texto = recorta(texto);
    if (!lugar || !toma(":"))
        return false;
    aviso.mensaje = recorta(texto);
    return true;
}

// Traduce el informe del compilador a «fichero:línea: mensaje — «texto»». `fichero`: de quién se habla si la
// línea no es ninguna de las leídas.
std::string traduceInforme(const std::string &informe, const std::vector<Linea> &lineas,
                           const std::string &fichero) {
    std::istringstream entrada(informe);
    std::string linea, salida;
    std::size_t anterior = std::string::npos;
    while (std::getline(entrada, linea)) {
        Aviso aviso;
        if (linea.empty())
            continue;
        if (analizaAviso(linea, aviso)) {
            if (aviso.linea == anterior)
                continue; // los demás errores de una línea suelen venir del primero
            anterior = aviso.linea;
            const std::string mensaje(aviso.mensaje);
            if (aviso.linea < 1 || aviso.linea > lineas.size()) {
                linea = fichero + ": " + mensaje;
            } else {
                const Linea &l = lineas[aviso.linea - 1];
                linea = l.fichero + ":" + std::to_string(l.numero) + ": " + mensaje + " — «" +
                        std::string(recorta(l.texto)) + "»";
            }
        }
        salida += (salida.empty() ? "" : "\n") + linea;
    }
    return salida;
}

// Si fuera de los comentarios hay una letra que no es ASCII, que en GLSL no vale y el compilador no dice cuál es, qué
// letra es y dónde está.
std::string letraQueNoVale(const std::string &texto, const std::vector<Linea> &lineas) {
    std::size_t n = 0, columna = 0, abre = 0;
    char comentario = 0; // en el que se está: de // o de /*
    for (std::size_t i = 0; i < texto.size(); ++i) {
        const unsigned char c = texto[i], otra = texto.c_str()[i + 1];
        columna = c == '\n' ? 0 : columna + ((c & 0xC0) != 0x80);
        n += c == '\n';
        bool cambia = c == '/' && (otra == '/' || otra == '*');
        if (comentario)
            cambia = comentario == '/' ? c == '\n' : c == '/' && texto[i - 1] == '*' && i > abre + 2;
        if (cambia) {
            comentario = comentario ? char(0) : char(otra);
            abre = i;
        } else if (!comentario && c > 0x7F && n < lineas.size()) {
            std::size_t fin = i + 1;
            while ((texto[fin] & 0xC0) == 0x80)
                ++fin;
            const std::string letra = texto.substr(i, fin - i);
            const std::string que =
                letra == "\u00A0" ? "este espacio no es el del teclado y" : "la letra «" + letra + "»";
            return lineas[n].fichero + ":" + std::to_string(lineas[n].numero) + ": en la columna " +
                   std::to_string(columna) + ", " + que + " no vale en GLSL fuera de un comentario";
        }
    }
    return {};
}

GLuint compila(GLenum tipo, const std::string &fichero, std::string &texto, std::string &error) {
    std::vector<Linea> lineas;
    std::vector<std::string> pila;
    if (!leeLineas(fichero, lineas, pila, error))
        return 0;
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
    std::string informe(longitud + 1, '\0');
    glGetShaderInfoLog(shader, longitud + 1, nullptr, informe.data());
    error = letraQueNoVale(texto, lineas);
    if (error.empty())
        error = traduceInforme(informe.c_str(), lineas, fichero);
    if (error.empty())
        error = fichero + ": no compila y el compilador no dice por qué";
    glDeleteShader(shader);
    return 0;
}

} // namespace

GLuint intentaPrograma(const std::string &vert, const std::string &frag, std::string &error) {
    std::string textoVert, textoFrag;
    const GLuint vertexShader = compila(GL_VERTEX_SHADER, vert, textoVert, error);
    const GLuint fragmentShader = vertexShader ? compila(GL_FRAGMENT_SHADER, frag, textoFrag, error) : 0;
    if (!fragmentShader) {
        glDeleteShader(vertexShader); // 0 se ignora
        return 0;
    }
    const GLuint programa = glCreateProgram();
    glAttachShader(programa, vertexShader);
    glAttachShader(programa, fragmentShader);
    glBindAttribLocation(programa, ATRIBUTO_POSICION, "posicion");
    glBindAttribLocation(programa, ATRIBUTO_NORMAL, "vNormal");
    glBindAttribLocation(programa, ATRIBUTO_COORD_TEXTURA, "coordTextura");
    glBindAttribLocation(programa, ATRIBUTO_COLOR, "color");
    glLinkProgram(programa);

    GLint enlazado = GL_FALSE, longitud = 0;
    glGetProgramiv(programa, GL_LINK_STATUS, &enlazado);
    const bool tienePosicion = enlazado && glGetAttribLocation(programa, "posicion") != -1;
    if (tienePosicion || (enlazado && textoVert.find("gl_VertexID") != std::string::npos))
        return programa;
    if (enlazado) {
        error = vert + ": no usa el atributo «posicion»";
    } else {
        glGetProgramiv(programa, GL_INFO_LOG_LENGTH, &longitud);
        std::string informe(longitud + 1, '\0');
        glGetProgramInfoLog(programa, longitud + 1, nullptr, informe.data());
        error = traduceInforme(informe.c_str(), {}, vert);
        error =
            vert + " y " + frag + " no enlazan: " + (error.empty() ? "el enlazador no dice por qué" : error);
    }
    borraPrograma(programa);
    return 0;
}

void borraPrograma(GLuint programa) {
    GLuint shaders[2];
    GLsizei n = 0;
    if (programa)
        glGetAttachedShaders(programa, 2, &n, shaders);
    glDeleteProgram(programa); // antes que sus shaders: WebGL no sabe borrarlos mientras están en uno
    for (GLsizei i = 0; i < n; ++i)
        glDeleteShader(shaders[i]);
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

void usaPrograma(GLuint programa, const glm::mat4 &camara, const glm::mat4 &proyeccion) {
    glUseProgram(programa);
    envia(programa, "camara", camara);
    envia(programa, "proyeccion", proyeccion);
}

bool hanCambiadoLosShaders() {
    return std::any_of(leidos.begin(), leidos.end(), [](const auto &leido) {
        const auto ahora = fecha(leido.first);
        return ahora != leido.second && ahora != std::filesystem::file_time_type::min();
    });
}

std::string recargaProgramas() {
    std::string errores;
    for (const Registrado &r : registrados) {
        std::string error;
        const GLuint nuevo = intentaPrograma(r.vert, r.frag, error);
        if (!nuevo) {
            avisa(error);
            errores += (errores.empty() ? "" : "\n") + error;
            continue;
        }
        // El nombre del programa es el que la aplicación conoce: se le cambian los shaders y se reenlaza.
        GLuint viejos[2], nuevos[2];
        glGetAttachedShaders(r.programa, 2, nullptr, viejos);
        glGetAttachedShaders(nuevo, 2, nullptr, nuevos);
        for (int i = 0; i < 2; ++i) {
            glDetachShader(r.programa, viejos[i]);
            glDeleteShader(viejos[i]);
            glDetachShader(nuevo, nuevos[i]);
            glAttachShader(r.programa, nuevos[i]);
        }
        glLinkProgram(r.programa);
        glDeleteProgram(nuevo);
    }
    return errores;
}
