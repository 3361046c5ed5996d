// El reescritor de shaders: lo que apunta es lo que pasa, y lo que calcula no cambia.
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

} // namespace

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
