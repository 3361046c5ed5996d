// Los lectores de lo que da el usuario, para estrellar entradas contra ellos: lo que uno cree leer de un fichero es la
// entrada, y `falla` lanza una excepción en vez de terminar. $LECTOR dice cuál; los llaman libFuzzer (fuzz.sh) o
// conductor.cpp.
#include "error.h"
#include "glut/sin_ventana/guion.h"
#include "herramientas/explica/deduce.h"
#include "herramientas/explica/glsl.h"
#include "imagen.h"
#include "malla.h"
#include "numero.h"
#include "rutas.h"
#include "shader.h"
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <map>

using Texto = std::string;

static std::map<Texto, Texto> ficheros; // los que hay

struct Falla {
    Texto mensaje;
    int estado;
};

/// Aborta, para que la entrada se note, si algo que debe cumplirse no se cumple.
static void exige(bool cierto) {
    if (!cierto)
        std::abort();
}

/// Llama al lector. Puede acabar bien o en falla, con un mensaje de una línea y estado 1 o 2.
template<class Lector>
static void lee(const Lector &lector) {
    try {
        lector();
    } catch (const Falla &f) {
        exige(!f.mensaje.empty() && f.mensaje.find('\n') == Texto::npos && (f.estado == 1 || f.estado == 2));
    }
}

static bool finito(const glm::vec3 &v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// --- en lugar de error.cpp y rutas.cpp ---

Texto nombrePrograma() {
    return "fuzz";
}
void avisa(const Texto &) {
}
void falla(const Texto &mensaje, int estado) {
    throw Falla{mensaje, estado};
}
bool intentaLeer(const Texto &ruta, Texto &contenido, Texto &error) {
    if (ficheros.count(ruta) == 0)
        error = "no encuentro «" + ruta + "»";
    else
        contenido = ficheros[ruta];
    return ficheros.count(ruta) == 1;
}
bool intentaRecurso(const Texto &relativa, Texto &ruta, Texto &error) {
    Texto contenido;
    ruta = relativa;
    return intentaLeer(ruta, contenido, error);
}
Texto recurso(const Texto &relativa) {
    return relativa;
}
Texto leeFichero(const Texto &ruta) {
    Texto contenido, error;
    if (!intentaLeer(ruta, contenido, error))
        falla(error);
    return contenido;
}

// --- los lectores ---

/// Los guiones, dados en la línea de órdenes o, si la entrada empieza por @, en un fichero; y el tamaño de -geometry.
static void guion(const Texto &entrada) {
    using namespace sin_ventana;
    const bool deFichero = entrada[0] == '@';
    ficheros["g"] = deFichero ? entrada.substr(1) : "";
    lee([&] {
        for (const Orden &o : leeGuion(deFichero ? "@g" : entrada)) {
            exige(!o.lugar.empty() && o.veces >= 1 && o.veces <= 10000);
            for (const Talla ventana : {Talla{1, 1}, Talla{240, 180}, Talla{16384, 16384}}) {
                const auto raton = ratonEn(o, ventana);
                exige(std::abs(raton.x) <= 100000 && std::abs(raton.y) <= 100000);
            }
        }
    });
    // el mensaje cita el argumento, que en una línea de órdenes también puede llevar un fin de línea
    if (entrada.find('\n') == Texto::npos)
        lee([&] {
            const Talla t = tallaDe(entrada, "-geometry");
            exige(t.ancho >= 1 && t.alto >= 1 && t.ancho <= 16384 && t.alto <= 16384);
        });
}

/// Las imágenes PPM y, con los dos primeros bytes como tamaño, las RGB sin cabecera; y el ANCHOxALTO de -talla.
static void imagen(const Texto &entrada) {
    const auto esperaEntera = [](const Imagen &i) {
        exige(i.ancho >= 1 && i.alto >= 1 && i.rgb.size() == 3 * std::size_t(i.ancho) * i.alto);
    };
    ficheros["f.ppm"] = entrada;
    lee([&] {
        Texto comentario;
        esperaEntera(leePpm("f.ppm", &comentario));
        exige(comentario.find('\n') == Texto::npos);
    });
    int ancho = 0, alto = 0;
    exige(!leeTalla(entrada, ancho, alto) || (ancho >= 1 && alto >= 1));
    if (entrada.size() >= 2) {
        ficheros["f.ppm"].erase(0, 2);
        lee([&] { esperaEntera(leeTextura("f.ppm", std::uint8_t(entrada[0]), std::uint8_t(entrada[1]))); });
    }
}

/// Las mallas v/f.
static void malla(const Texto &entrada) {
    ficheros["m.vf"] = entrada;
    lee([] {
        const MallaVf m = leeVf("m.vf");
        exige(!m.caras.empty());
        for (const glm::vec3 &v : m.vertices)
            exige(finito(v));
        for (const auto &cara : m.caras) {
            exige(cara.size() >= 3);
            for (const unsigned i : cara)
                exige(i < m.vertices.size());
        }
    });
}

/// Los #include de los shaders y la traducción del informe de un compilador, que rechaza todos. La entrada son,
/// separados por bytes nulos: el shader, el informe y dos ficheros, a y b, que se pueden incluir.
static void shader(const Texto &entrada) {
    static Texto informe;
    glCreateShader = [](GLenum) { return 1u; };
    glShaderSource = [](GLuint, GLsizei, const GLchar *const *texto, const GLint *) {
        exige(std::strlen(*texto) < 100000000);
    };
    glCompileShader = glDeleteShader = [](GLuint) {};
    glGetShaderiv = [](GLuint, GLenum cual, GLint *valor) {
        *valor = cual == GL_INFO_LOG_LENGTH ? GLint(informe.size()) + 1 : GL_FALSE;
    };
    glGetShaderInfoLog = [](GLuint, GLsizei cabe, GLsizei *, GLchar *texto) {
        exige(std::size_t(cabe) > informe.size());
        std::memcpy(texto, informe.c_str(), informe.size() + 1);
    };
    Texto partes[4];
    int parte = 0;
    for (const char c : entrada)
        if (c == '\0' && parte < 3)
            ++parte;
        else
            partes[parte] += c;
    informe = partes[1].c_str(); // sin bytes nulos, como lo da OpenGL
    ficheros = {{"shader", partes[0]}, {"a", partes[2]}, {"b", partes[3]}};
    Texto error;
    exige(intentaPrograma("shader", "shader", error) == 0 && !error.empty());
}

/// El reescritor de shaders: lo que da tiene una medida, y todo lo que apunta es de un tipo que se sabe leer.
static void glsl(const Texto &entrada) {
    using namespace explica;
    for (const Division &d : divisionesEnteras(entrada))
        exige(d.divisor != 0 && d.dividendo % d.divisor != 0);
    for (const Etapa etapa : {Etapa::Fragmento, Etapa::Vertices}) {
        const Reescrito r = reescribe(entrada, 4, etapa);
        exige(r.notas.size() <= 4096 && r.fuente.size() <= 4000000 &&
              r.sinSeguir.size() <= entrada.size() + 1000000);
        exige(!r.fuente.empty() || (r.notas.empty() && r.sinSeguir.size() == 1));
        for (const Nota &n : r.notas)
            exige((n.tipo == "void") == valor(n.tipo, std::vector<float>(16).data()).empty());
    }
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *datos, std::size_t n) {
    static const std::map<Texto, void (*)(const Texto &)> LECTORES = {
        {"glsl", glsl}, {"guion", guion}, {"imagen", imagen}, {"malla", malla}, {"shader", shader}};
    static const auto lector = LECTORES.at(std::getenv("LECTOR"));
    lector(Texto(datos, datos + n));
    return 0;
}
