// El reescritor de shaders: lo que apunta es lo que pasa. Que lo que calcula no cambia, propiedades/explica.py.
#include "traza.h"

using namespace explica;

namespace {

std::string numero(double v) {
    char texto[40];
    std::snprintf(texto, sizeof texto, "%.10g", v);
    return std::isnan(v) ? "nan" : texto; // el signo de un NaN no dice nada
}

/// Los pasos de un píxel en una línea: «5 x:1.5» es que en la línea 5 x vale 1.5; la línea se dice cuando cambia.
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

std::string conMain(const std::string &global, const std::string &cuerpo) {
    return "#version 140\nuniform int uno; uniform float medio; out vec4 o; " + global +
           "\n#line 2\n\nvoid main() { " + cuerpo + "\n}\n";
}

/// Lo que apunta en el píxel (1, 1) un shader de conMain.
std::string loQuePasa(const Reescrito &r) {
    std::string error;
    const GLuint programa = traza::enlaza(VERT, r.fuente, error);
    if (programa == 0)
        return error + r.fuente;
    glUseProgram(programa);
    glUniform1i(glGetUniformLocation(programa, "uno"), 1);
    glUniform1f(glGetUniformLocation(programa, "medio"), 0.5f);
    const std::string pasa = cuenta(r, traza::ejecuta(programa, r)[traza::LADO + 1]);
    glDeleteProgram(programa);
    return pasa;
}

const std::vector<Caso> CASOS = {
#include "casos.inc"
};

} // namespace

// Mesa enlaza con una salida de más y con una entrada que nadie da; la web, no.
TEST(ExplicaGlsl, SoloLasSalidasYEntradasQueHacenFalta) {
    const Reescrito r = reescribe(
        "#version 140\nin vec3 sobra; in vec3 usa; out vec4 o;\nvoid main() { o = vec4(usa, 1.0); }\n", 3);
    EXPECT_FALSE(std::regex_search(r.fuente, std::regex("\\bout vec4 o\\b"))) << r.fuente;
    EXPECT_TRUE(std::regex_search(r.fuente, std::regex("\\bvec4 o\\b"))) << r.fuente;
    std::string entradas;
    for (const Nota &n : r.notas)
        entradas += n.clase == Clase::Entrada ? n.nombre + " " : "";
    EXPECT_EQ(entradas, "usa ");
}

TEST(ExplicaGlsl, ApuntaLoQuePasa) {
    traza::abre(1);
    for (const Caso &c : CASOS) {
        SCOPED_TRACE(c.global + " … " + c.cuerpo);
        const Reescrito r = reescribe(conMain(c.global, c.cuerpo), traza::SALIDAS);
        for (const Aviso &a : r.sinSeguir)
            ADD_FAILURE() << a.linea << ": " << a.motivo;
        EXPECT_EQ(loQuePasa(r), c.esperado);
    }
}

// De miles de vueltas se cuentan todas y se lee la que se pida.
TEST(ExplicaGlsl, UnaVueltaEntreMiles) {
    traza::abre(1);
    const Reescrito r =
        reescribe("#version 140\nout vec4 o;\nvoid main() {\n    int s = 0;\n    for (int i = 0; i < 3000; "
                  "++i)\n        s += i;\n    o = vec4(float(s));\n}\n",
                  traza::SALIDAS);
    std::string error;
    const GLuint programa = traza::enlaza(VERT, r.fuente, error);
    ASSERT_NE(programa, 0u) << error;
    glUseProgram(programa);
    for (const int vuelta : {0, 1500, 2999}) { // se entra, s, i y, en cada vuelta, la condición, s e i
        glUniform1i(glGetUniformLocation(programa, "explica_desde"), 4 + 3 * vuelta);
        const auto s = traza::dibuja(traza::SALIDAS, NAN);
        EXPECT_EQ(s[1][0], glm::vec4(9007, 0, 0, 0)); // y la que lo acaba, o, se sale y el color
        const Nota &nota = r.notas.at(int(s[0][0].x));
        EXPECT_EQ(nota.nombre + " " + std::to_string(nota.linea), "s 6");
        EXPECT_EQ(valor(nota.tipo, &s[2][0].x), std::vector<double>{vuelta * (vuelta + 1) / 2.0});
    }
}

// Lo que no sabe seguir lo dice, y apunta lo demás.
TEST(ExplicaGlsl, DiceLoQueNoSabe) {
    traza::abre(1);
    const struct {
        std::string global, cuerpo, motivo, esperado; // el motivo, tras su línea; sin él, no da shader
    } DUDAS[] = {
        {"", "int i = 0; int a[2];\na[i++]++; i = 5;", "4: no sé apuntar aquí lo que vale «a[i++]»",
         "3 i:0 | 4 i:1 i:5"},
        {"struct S { int n; }; int t() { return 1; }", "S a[2], b; b.n = 1;\na[t()] = b;",
         "4: no sé apuntar aquí lo que vale «a[t()]»", "3 b.n:1 | 2 >t <t:1"},
        {"struct S { int n; };", "S a[2], b; b.n = 1; int i = 0;\na[0 + i++] = b; i += 0;",
         "4: no sé apuntar aquí lo que vale «a[0 + i++]»", "3 b.n:1 i:0 | 4 i:1 i:1"},
        {"", "float a[41]; float b[41];\nb = a; int i = 1;", "4: no sé apuntar «b» entero", "4 i:1"},
        {"struct S { int n; };", "S a, b, c; a.n = 1;\nc = b = a; a.n = 2;",
         "4: no sé apuntar aquí lo que vale «b»", "3 a.n:1 | 4 c.n:1 a.n:2"},
        {"void f(out int a) { a = 1; { int a = 2; return; } }", "int k; f(k); k++;",
         "2: otra variable tapa aquí al parámetro «a»", "2 >f a:1 a:2 <f | 3 k:2"},
        {"", "float e; if (modf(2.5, e) > 0.0) e += 1.0;", "3: no sé apuntar aquí lo que modf deja en «e»",
         "3 modf(2.5, e) > 0.0:1 e:3"},
        {"\n#ifdef GL_ARB_nada\nint q = 1;\n#endif", "int i = 1;",
         "3: depende de si OpenGL define GL_ARB_nada", "3 i:1"},
        {"const int N = int(2.0);", "int a[N] = int[N](1, 2);", "", "2 N:2 | 3 a[0]:1 a[1]:2"},
    };
    for (const auto &d : DUDAS) {
        SCOPED_TRACE(d.global + " … " + d.cuerpo);
        const Reescrito r = reescribe(conMain(d.global, d.cuerpo), traza::SALIDAS);
        EXPECT_EQ(r.sinSeguir.size(), d.motivo.empty() ? 0u : 1u);
        for (const Aviso &a : r.sinSeguir)
            EXPECT_EQ((std::to_string(a.linea) + ": " + a.motivo).substr(0, d.motivo.size()), d.motivo);
        EXPECT_EQ(loQuePasa(r), d.esperado);
    }
    const struct {
        std::string texto, motivo;
    } MAL[] = {
        {"#version 140\nout vec4 o;\n", "3: no hay main"},
        {"#version 140\nvoid main() {\n    int explica_x;\n}\n", "3: los nombres que empiezan por explica_"},
        {"#version 140\n#define A B(B(B(B(B(B(B(B(1))))))))\n#define B(x) x x x x x x x x\nvoid main() {\n   "
         " A;\n}\n",
         "5: las macros dan un texto demasiado largo"},
        {"#version 140\n#if 1 / 0\n#endif\nvoid main() {}\n", "2: no sé qué vale esta condición"},
    };
    for (const auto &m : MAL) {
        const Reescrito r = reescribe(m.texto, traza::SALIDAS);
        ASSERT_EQ(r.sinSeguir.size(), 1u) << m.texto;
        EXPECT_TRUE(r.fuente.empty()) << m.texto;
        EXPECT_EQ(
            (std::to_string(r.sinSeguir[0].linea) + ": " + r.sinSeguir[0].motivo).substr(0, m.motivo.size()),
            m.motivo);
    }
}

// Los else if van seguidos, y no unos dentro de otros: no hay límite. Y lo que OpenGL define se le pregunta.
TEST(ExplicaGlsl, MuchosElseYLoDefinido) {
    std::string cuerpo = "int k = 0;\nif (uno == 300) k = 1;\n";
    for (int i = 0; i < 260; ++i)
        cuerpo += "else if (uno == 7) k = 2;\n";
    const std::string global = "\n#if defined(GL_si) && !defined(GL_no) && GL_si\n#else\nno\n#endif";
    const Reescrito r = reescribe(conMain(global, cuerpo), 3, Etapa::Fragmento,
                                  [](const auto &, const std::string &nombre) { return nombre == "GL_si"; });
    EXPECT_TRUE(r.sinSeguir.empty()) << r.sinSeguir[0].motivo;
    EXPECT_GT(r.notas.size(), 500u);
}

// Lo que da tiene una medida.
TEST(ExplicaGlsl, MilesDeSitios) {
    std::string cuerpo = "float x;\n";
    for (int k = 0; k < 5000; ++k)
        cuerpo += "x = 1.0;\n";
    const Reescrito r = reescribe(conMain("", cuerpo), 3);
    EXPECT_EQ(r.notas.size(), 4096u);
    ASSERT_EQ(r.sinSeguir.size(), 1u);
    EXPECT_EQ(r.sinSeguir[0].linea, 4 + 4096 - 2); // el color y que se entra van antes
}

// Lo que no se entiende se copia, y un discard de dentro tampoco deja sin apuntar lo anterior.
TEST(ExplicaGlsl, LoQueNoEntiendeLoCopia) {
    const Reescrito r = reescribe(
        "#version 140\nout vec4 o;\n@raro;\nvoid main() {\n    int i = 1;\n    do { $; if (x) discard; } "
        "while (@);\n    o = vec4(1.0);\n}\n",
        3);
    std::string lineas;
    for (const Aviso &a : r.sinSeguir)
        lineas += std::to_string(a.linea) + " ";
    EXPECT_EQ(lineas, "3 6 6 ");
    EXPECT_NE(r.fuente.find("@ raro ;"), std::string::npos) << r.fuente;
    EXPECT_NE(r.fuente.find("do { $ ; if ( x ) explica_descarta ( ) ; } while ( @ ) ;"), std::string::npos)
        << r.fuente;
    EXPECT_EQ(r.notas.size(), 5u); // se entra, i, o, se sale y el color
}
