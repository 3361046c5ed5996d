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

// El texto con los comentarios en blanco y lo demás en su sitio.
std::string sinComentarios(std::string texto) {
    std::size_t fin = 0; // del último que se ha abierto
    for (std::size_t i = 0; i < texto.size(); ++i) {
        if (i >= fin && texto.compare(i, 2, "//") == 0)
            fin = std::min(texto.find('\n', i), texto.size());
        else if (i >= fin && texto.compare(i, 2, "/*") == 0)
            fin = std::min(texto.find("*/", i + 2), texto.size() - 2) + 2;
        if (i < fin && texto[i] != '\n')
            texto[i] = ' ';
    }
    return texto;
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
    std::string ruta, contenido, linea, enCodigo;
    if (!intentaRecurso(fichero, ruta, error))
        return false;
    leidos[ruta] = fecha(ruta);
    if (!intentaTexto(ruta, contenido, error))
        return false;
    pila.push_back(fichero);
    std::istringstream texto(contenido), codigo(sinComentarios(contenido));
    for (int numero = 1; std::getline(texto, linea) && std::getline(codigo, enCodigo); ++numero) {
        const std::string incluido(incluidoEn(linea));
        if (incluido.empty() || recorta(enCodigo).empty()) {
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
    return salida.empty() ? fichero + ": no vale, y el compilador no dice por qué" : salida;
}

// Si fuera de los comentarios hay una letra que no es ASCII, que en GLSL no vale y el compilador no dice cuál es, qué
// letra es y dónde está.
std::string letraQueNoVale(const std::string &texto, const std::vector<Linea> &lineas) {
    const std::string codigo = sinComentarios(texto);
    const auto sigue = [](char c) { return (c & 0xC0) == 0x80; }; // la letra de antes
    const auto mala = std::find_if(codigo.begin(), codigo.end(), [](char c) { return c & 0x80; });
    if (mala == codigo.end())
        return {};
    const std::size_t i = mala - codigo.begin(), principio = texto.rfind('\n', i) + 1; // si no hay, 0
    const Linea &l = lineas[std::count(codigo.begin(), mala, '\n')];
    const auto columna = i + 1 - principio - std::count_if(&texto[principio], &texto[i], sigue);
    const std::string letra(mala, std::find_if_not(mala + 1, codigo.end(), sigue));
    const std::string que =
        letra == "\u00A0" ? "este espacio no es el del teclado y" : "la letra «" + letra + "»";
    return l.fichero + ":" + std::to_string(l.numero) + ": en la columna " + std::to_string(columna) + ", " +
           que + " no vale en GLSL fuera de un comentario";
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
        error = vert + " y " + frag + " no enlazan: " + traduceInforme(informe.c_str(), {}, vert);
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
