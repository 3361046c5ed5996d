// El reescritor de shaders: lo que apunta es lo que pasa, y lo que calcula no cambia.
#include "azaroso.h"
#include "ejecuta.h"
#include "glut_sin_ventana/essl.h"
#include "rutas.h"
#include "traza.h"

using namespace explica;

namespace {

std::string numero(double v) {
    char texto[40];
    std::snprintf(texto, sizeof texto, "%.10g", v);
    return std::isnan(v) ? "nan" : texto; // el signo de un NaN no dice nada
}

/// Los pasos de un píxel en una línea: «5 x:1.5» es que en la línea 5 x pasa a valer 1.5; la línea se dice cuando cambia.
std::string cuenta(const Reescrito &r, const traza::Traza &t) {
    std::string s;
    int linea = 0;
    for (const traza::Paso &paso : t.pasos) {
        const Nota &n = r.notas[paso.nota];
        if (n.clase == Clase::Entrada || n.clase == Clase::Salida || (n.tipo == "void" && n.nombre == "main"))
            continue;
        if (n.linea != linea)
            s += (linea ? " | " : "") + std::to_string(n.linea);
        linea = n.linea;
        s += n.clase == Clase::Entra      ? " >" + n.nombre
             : n.clase == Clase::Vuelve   ? " <" + n.nombre
             : n.clase == Clase::Devuelve ? " <" + n.funcion
                                          : " " + n.nombre;
        for (std::size_t k = 0; k < paso.valor.size(); ++k)
            s += (k ? "," : ":") + numero(paso.valor[k]);
    }
    return s + (t.descartado ? " !" : "");
}

struct Caso {
    std::string global, cuerpo, esperado; // el cuerpo de main empieza en la línea 3
};

const std::string VERT = "#version 140\nvoid main() {\n    gl_Position = vec4(4 * (gl_VertexID % 2) - 1, 4 * "
                         "(gl_VertexID / 2) - 1, 0.0, 1.0);\n}\n";

const std::vector<Caso> CASOS = {
#include "casos.inc"
};

namespace fs = std::filesystem;

/// Un shader con sus #include en su sitio, como lo da common/shader.cpp.
std::string conInclusiones(const fs::path &ruta) {
    std::ifstream f(ruta);
    std::string todo;
    for (std::string linea; std::getline(f, linea);) {
        std::smatch m;
        if (std::regex_match(linea, m, std::regex("#include \"(.*)\"\r?")))
            todo += conInclusiones(recurso(m[1]));
        else
            todo += linea + "\n";
    }
    return todo;
}

/// Los del laboratorio y los de los estudiantes, por su nombre; los que están mal a propósito, no.
std::map<std::string, std::string> shaders(const std::string &extension) {
    std::map<std::string, std::string> todos;
    const fs::path raiz = fs::path(recurso("CMakeLists.txt")).parent_path();
    for (const auto &carpeta : fs::directory_iterator(raiz))
        if (std::regex_match(carpeta.path().filename().string(), std::regex("common|ch[0-9][0-9]_.*")))
            for (const auto &f : fs::directory_iterator(carpeta))
                if (f.path().extension() == extension &&
                    f.path().filename().string().find("errores_") == std::string::npos)
                    todos[f.path().filename().string()] = conInclusiones(f.path());
    if (extension == ".frag") {
        std::string estudiantes = leeFichero(recurso("tests/explica/estudiantes.glsl"));
        estudiantes.erase(0, estudiantes.find('\n') + 1);
        for (std::size_t i = 0, n = 1; i != std::string::npos; ++n) {
            const std::size_t fin = estudiantes.find("====\n", i);
            todos["estudiante" + std::to_string(n) + ".frag"] = estudiantes.substr(i, fin - i);
            i = fin == std::string::npos ? fin : fin + 5;
        }
    }
    return todos;
}

bool iguales(const glm::vec4 &a, const std::vector<double> &b, double cota) {
    bool si = b.size() == 4;
    for (int k = 0; si && k < 4; ++k)
        si = float(b[k]) == a[k] || (std::isnan(b[k]) && std::isnan(a[k])) ||
             std::fabs(b[k] - a[k]) <= cota * std::fabs(a[k]);
    return si;
}

// Mesa reordena dot(normalize(v), c), salvo si el vector normalizado se usa en otro sitio: una suma de tres números
// cambia en el último bit con solo darlo por otra salida, sin que nada se reescriba.
const std::set<std::string> REORDENADOS = {"textura3d.frag", "volumen_vista.frag"};

/// El color de cada píxel, el que da el shader y el que apunta el reescrito, son el mismo.
void compara(const Reescrito &r, const traza::Pixeles &suyo, const std::vector<traza::Traza> &trazas,
             double cota) {
    for (std::size_t q = 0; q < suyo.size(); ++q) {
        const traza::Traza &t = trazas[q];
        std::vector<double> color;
        for (const traza::Paso &paso : t.pasos)
            if (r.notas[paso.nota].clase == Clase::Salida && r.notas[paso.nota].tipo == "vec4")
                color = paso.valor;
        EXPECT_EQ(t.descartado, suyo[q].x == -777) << "píxel " << q;
        EXPECT_TRUE(t.descartado || iguales(suyo[q], color, cota))
            << "píxel " << q << ": " << suyo[q].x << ' ' << suyo[q].y << ' ' << suyo[q].z << ' ' << suyo[q].w
            << " y " << (color.empty() ? -1 : color[0]) << "; " << t.pasos.size() << " pasos";
    }
}

} // namespace

// Cada fragment shader, reescrito, da el mismo color, bit a bit, con lo que le llegue.
TEST(ExplicaGlsl, NoCambiaLoQueCalcula) {
    traza::abre(1);
    for (const auto &[nombre, texto] : shaders(".frag")) {
        SCOPED_TRACE(nombre);
        const Reescrito r = reescribe(texto, traza::SALIDAS);
        for (const Aviso &a : r.sinSeguir)
            ADD_FAILURE() << a.linea << ": " << a.motivo;
        std::string error;
        const std::string vert = azaroso::vertex(texto, 1);
        const GLuint suyo = traza::enlaza(vert, texto, error),
                     reescrito = traza::enlaza(vert, r.fuente, error);
        ASSERT_TRUE(suyo && reescrito) << error << "\n" << vert << (suyo ? r.fuente : texto);
        for (int semilla = 1; semilla <= 2; ++semilla) {
            azaroso::uniforms(suyo, semilla);
            const auto color = traza::dibuja(1, -777)[0];
            azaroso::uniforms(reescrito, semilla);
            compara(r, color, traza::ejecuta(reescrito, r, 20000),
                    REORDENADOS.count(nombre) ? std::ldexp(1, -21) : 0);
        }
        EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
        glDeleteProgram(suyo);
        glDeleteProgram(reescrito);
    }
}

/// De unos textos, por el nombre de su fichero, lo que dice glslangValidator de cada uno que no vale.
std::map<std::string, std::string> rechazados(const std::map<std::string, std::string> &textos) {
    std::string orden = "cd " + carpetaTemporal().string() + "; glslangValidator";
    for (const auto &[nombre, texto] : textos) {
        std::ofstream(carpetaTemporal() / nombre) << texto;
        orden += " " + nombre;
    }
    EXPECT_NE(std::system((orden + " >informe").c_str()), -1);
    std::ifstream informe(carpetaTemporal() / "informe");
    std::map<std::string, std::string> mal;
    std::string quien;
    for (std::string linea; std::getline(informe, linea);)
        if (textos.count(linea))
            quien = linea;
        else if (linea.find("ERROR") == 0)
            mal[quien] += linea + "\n";
    return mal;
}

// Y es GLSL como lo entiende otro compilador, también traducido a ES 3.00 si así vale el original.
TEST(ExplicaGlsl, EsValidoParaOtroCompilador) {
    std::map<std::string, std::string> suyos, reescritos, traducidos;
    for (const std::string extension : {".frag", ".vert"})
        for (const auto &[nombre, texto] : shaders(extension)) {
            const Reescrito r =
                reescribe(texto, 8, extension == ".frag" ? Etapa::Fragmento : Etapa::Vertices);
            EXPECT_TRUE(r.sinSeguir.empty()) << nombre << ": " << r.sinSeguir[0].motivo;
            suyos[nombre] = sin_ventana::enEssl(texto);
            reescritos[nombre] = r.fuente;
            traducidos[nombre] = sin_ventana::enEssl(r.fuente);
        }
    for (const auto &[nombre, mal] : rechazados(reescritos))
        ADD_FAILURE() << nombre << ": " << mal << reescritos[nombre];
    const auto noSonEs = rechazados(suyos);
    EXPECT_LT(noSonEs.size(), 15u);
    EXPECT_GT(suyos.size(), 120u);
    for (const auto &[nombre, mal] : rechazados(traducidos))
        EXPECT_TRUE(noSonEs.count(nombre)) << nombre << ": " << mal << traducidos[nombre];
}

TEST(ExplicaGlsl, ApuntaLoQuePasa) {
    traza::abre(1);
    for (const Caso &c : CASOS) {
        SCOPED_TRACE(c.global + " … " + c.cuerpo);
        const Reescrito r = reescribe("#version 140\nuniform int uno; uniform float medio; out vec4 o; " +
                                          c.global + "\n" + "#line 3\nvoid main() { " + c.cuerpo + "\n}\n",
                                      traza::SALIDAS);
        for (const Aviso &a : r.sinSeguir)
            ADD_FAILURE() << a.linea << ": " << a.motivo;
        std::string error;
        const GLuint programa = traza::enlaza(VERT, r.fuente, error);
        ASSERT_NE(programa, 0u) << error << r.fuente;
        glUseProgram(programa);
        glUniform1i(glGetUniformLocation(programa, "uno"), 1);
        glUniform1f(glGetUniformLocation(programa, "medio"), 0.5f);
        EXPECT_EQ(cuenta(r, traza::ejecuta(programa, r)[5]), c.esperado);
        glDeleteProgram(programa);
    }
}
