// El reescritor de shaders, en lo que al ejecutarlo en Mesa no se nota (lo demás, casos/usos.py).
#include "explica/glsl.h"
#include "prueba.h"

// Mesa enlaza con una salida de más y con una entrada que nadie da; la web, no.
TEST(ExplicaGlsl, SoloLasSalidasYEntradasQueHacenFalta) {
    const explica::Reescrito r = explica::reescribe(
        "#version 140\nin vec3 sobra; in vec3 usa; out vec4 o;\nvoid main() { o = vec4(usa, 1.0); }\n", 3);
    EXPECT_FALSE(std::regex_search(r.fuente, std::regex("\\bout vec4 o\\b"))) << r.fuente;
    std::string entradas;
    for (const explica::Nota &n : r.notas)
        entradas += n.clase == explica::Clase::Entrada ? n.nombre + " " : "";
    EXPECT_EQ(entradas, "usa ");
}
