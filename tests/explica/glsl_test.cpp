// El reescritor de shaders, sin OpenGL. Que lo que apunta es lo que pasa, casos/usos.py, con casos.inc; que lo que calcula
// no cambia, propiedades/explica.py.
#include "explica/glsl.h"
#include "prueba.h"

using namespace explica;

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

TEST(ExplicaGlsl, LoQueNoCompilaLoDice) {
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
        const Reescrito r = reescribe(m.texto, 4);
        ASSERT_EQ(r.sinSeguir.size(), 1u) << m.texto;
        EXPECT_TRUE(r.fuente.empty()) << m.texto;
        EXPECT_EQ(
            (std::to_string(r.sinSeguir[0].linea) + ": " + r.sinSeguir[0].motivo).substr(0, m.motivo.size()),
            m.motivo);
    }
}

// Lo que da tiene una medida.
TEST(ExplicaGlsl, MilesDeSitios) {
    std::string fuente = "#version 140\nout vec4 o;\nvoid main() {\n";
    for (int k = 0; k < 5000; ++k)
        fuente += "o.x = 1.0;\n";
    const Reescrito r = reescribe(fuente + "}\n", 3);
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
