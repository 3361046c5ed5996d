// Lo que common/ hace con una ventana abierta: F5 con shaders mal editados, F12 donde no se puede escribir, texturas.
#include "ejecuta.h"
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <map>

namespace fs = std::filesystem;

namespace {

using Ficheros = std::map<std::string, std::string>; // nombre → contenido

const char *const COLOR = "out vec4 colorFragmento;\n";

std::string vert(const std::string &x) {
    return "#version 140\nin vec3 posicion;\nin vec2 coordTextura;\nout vec2 st;\nvoid main() {\n    st = "
           "coordTextura;\n"
           "    gl_Position = vec4(posicion.x + " +
           x + ", 2.0 * posicion.y, 0.0, 1.0);\n}\n";
}
std::string frag(const std::string &color) {
    return "#version 140\nin vec2 st;\nout vec4 colorFragmento;\nuniform sampler2D Img;\nvoid main() {\n    "
           "colorFragmento = " +
           color + ";\n}\n";
}
const std::string ROJO = frag("vec4(1, 0, 0, 1)"), VERDE = frag("vec4(0, 1, 0, 1)"),
                  AZUL = frag("vec4(0, 0, 1, 1)"), BLANCO = frag("vec4(1, 1, 1, 1)");

Ficheros version(const std::string &fragA, const std::string &fragB) {
    return {{"a.vert", vert("-0.5")}, {"a.frag", fragA}, {"b.vert", vert("0.5")}, {"b.frag", fragB}};
}

/// Ejecuta tests/comun/taller.cpp con esas versiones de sus shaders en $LAB_RAIZ/0, /1…
Ejecucion taller(const std::vector<Ficheros> &versiones, const std::string &guion,
                 const std::vector<std::string> &argumentos = {}) {
    static int n = 0;
    const fs::path raiz = carpetaTemporal() / ("raiz" + std::to_string(++n));
    for (std::size_t v = 0; v < versiones.size(); ++v) {
        const fs::path carpeta = raiz / std::to_string(v);
        fs::create_directories(carpeta);
        for (const auto &[nombre, contenido] : versiones[v])
            std::ofstream(carpeta / nombre, std::ios::binary) << contenido;
    }
    setenv("LAB_RAIZ", raiz.c_str(), 1);
    const Ejecucion e = ejecuta("../tests/taller", guion, 64, 32, argumentos);
    unsetenv("LAB_RAIZ");
    return e;
}

/// El color de cada mitad de la imagen: «rojo azul».
std::string mitades(const Imagen &imagen) {
    std::string s;
    for (const int x : {16, 48}) {
        const Pixel p = pixel(imagen, x, 16);
        s += p.r ? p.g ? "blanco" : "rojo" : p.g ? "verde" : p.b ? "azul" : "negro";
        s += x == 16 ? " " : "";
    }
    return s;
}

/// Una manera de estropear los shaders del primer cuadrado, y lo que debe decirse de ella.
struct Rotura {
    const char *nombre;
    Ficheros cambios; // sobre una versión buena; un contenido "-" quita el fichero
    std::string mensaje;
};

std::vector<Rotura> roturas() {
    const std::string incluye = "#version 140\n" + std::string(COLOR);
    return {
        {"sintaxis", {{"a.frag", frag("vec4(1.0, ,")}}, "taller/a.frag:6: error: "},
        {"falta_un_include",
         {{"a.frag", incluye + "#include \"taller/no_esta.glsl\"\n"}},
         "taller/a.frag:3: no encuentro «taller/no_esta.glsl»; lo he buscado en "},
        {"se_incluye",
         {{"a.frag", incluye + "#include \"taller/a.frag\"\n"}},
         "taller/a.frag:3: #include sin fin: taller/a.frag → taller/a.frag"},
        {"ciclo",
         {{"a.frag", incluye + "  #include  \"taller/c.glsl\" \n"},
          {"c.glsl", "\n#include \"taller/a.frag\"\n"}},
         "taller/a.frag:3: taller/c.glsl:2: #include sin fin: taller/a.frag → taller/c.glsl → taller/a.frag"},
        {"error_en_lo_incluido",
         {{"a.frag", incluye + "#include \"taller/c.glsl\"\n"}, {"c.glsl", "\nfloat x = y;\n"}},
         "taller/c.glsl:2: error: "},
        {"borrado", {{"a.vert", "-"}}, "no encuentro «taller/a.vert»; lo he buscado en "},
        {"vertex_vacio", {{"a.vert", ""}}, "taller/a.vert"},
        {"fragment_vacio", {{"a.frag", ""}}, "taller/a.frag"},
        {"sin_posicion",
         {{"a.vert", "#version 140\nout vec2 st;\nvoid main() {\n    st = vec2(0.0);\n    gl_Position = "
                     "vec4(st, 0.0, 1.0);\n}\n"}},
         "taller/a.vert: no usa el atributo «posicion»"},
        {"no_enlaza",
         {{"a.vert", "#version 140\nin vec3 posicion;\nout vec3 st;\nvoid main() {\n    st = posicion;\n    "
                     "gl_Position = vec4(st, 1.0);\n}\n"},
          {"a.frag", frag("vec4(st, 0, 1)")}},
         "taller/a.vert y taller/a.frag no enlazan: "},
        {"blancos",
         {{"a.frag", "#version 140\n" + std::string(40000, ' ') + "x\n"}},
         "taller/a.frag:2: error: "},
        {"nombre_larguisimo",
         {{"a.frag", incluye + "#include \"" + std::string(200000, 'x') + "\"\n"}},
         "taller/a.frag:3: no encuentro «xxx"},
    };
}

Ficheros estropeada(const Rotura &rotura, Ficheros buena) {
    for (const auto &[nombre, contenido] : rotura.cambios)
        buena[nombre] = contenido;
    for (auto i = buena.begin(); i != buena.end();)
        i = i->second == "-" ? buena.erase(i) : std::next(i);
    return buena;
}

} // namespace

// Al arrancar, un shader roto termina el programa con una línea que dice cuál es.
TEST(Shaders, AlArrancarUnoRotoTermina) {
    for (const Rotura &r : roturas()) {
        const Ejecucion e = taller({estropeada(r, version(ROJO, AZUL))}, "");
        EXPECT_EQ(e.estado, 1) << r.nombre;
        EXPECT_TRUE(e.imagen.rgb.empty());
        EXPECT_EQ(e.errores.rfind("taller: ", 0), 0u);
        EXPECT_NE(e.errores.find(r.mensaje), std::string::npos)
            << r.nombre << ": " << e.errores.substr(0, 500);
    }
}

// Con la ventana abierta, F5 con el primero roto avisa y lo conserva, y relee el segundo; arreglado, se ve bien.
TEST(Shaders, F5ConUnoRotoAvisaYSigue) {
    EXPECT_EQ(mitades(taller({version(ROJO, AZUL)}, "").imagen), "rojo azul");
    for (const Rotura &r : roturas()) {
        SCOPED_TRACE(r.nombre);
        const std::vector<Ficheros> versiones = {version(ROJO, AZUL), estropeada(r, version(ROJO, VERDE)),
                                                 version(BLANCO, BLANCO)};
        const Ejecucion roto = taller(versiones, "tecla 1; especial F5"),
                        bien = taller(versiones, "tecla 1; especial F5; especial F5; tecla 2; especial F5");
        EXPECT_EQ(roto.estado, 0) << roto.errores.substr(0, 500);
        EXPECT_EQ(roto.errores.rfind("taller: aviso: ", 0), 0u) << roto.errores.substr(0, 500);
        EXPECT_NE(roto.errores.find(r.mensaje), std::string::npos) << roto.errores.substr(0, 500);
        EXPECT_EQ(mitades(roto.imagen), "rojo verde");
        EXPECT_EQ(bien.estado, 0);
        EXPECT_EQ(mitades(bien.imagen), "blanco blanco");
    }
}

TEST(Shaders, F5MuchasVeces) {
    std::string guion;
    for (int i = 0; i < 40; ++i)
        guion += "tecla " + std::to_string(i % 2) + "; especial F5;";
    const Ejecucion e = taller({version(ROJO, AZUL), version(VERDE, BLANCO)}, guion);
    EXPECT_EQ(e.estado, 0) << e.errores;
    EXPECT_EQ(e.errores, "");
    EXPECT_EQ(mitades(e.imagen), "verde blanco");
}

// Solo lo que se incluye a sí mismo no acaba; dos veces seguidas sí se puede.
TEST(Shaders, IncluirDosVecesLoMismo) {
    Ficheros dosVeces = version(ROJO, AZUL);
    dosVeces["a.frag"] = "#version 140\n" + std::string(COLOR) +
                         "void main() {\n    float x = 0.0;\n#include \"taller/c.glsl\"\n#include "
                         "\"taller/c.glsl\"\n    colorFragmento = vec4(0, step(1.0, x), 0, 1);\n}\n";
    dosVeces["c.glsl"] = "    x += 0.5;\n";
    const Ejecucion e = taller({dosVeces}, "");
    EXPECT_EQ(e.errores, "");
    EXPECT_EQ(mitades(e.imagen), "verde azul");
}

// La normal está en su índice, el de los buffers, aunque el shader tenga antes otro atributo.
TEST(Shaders, CadaAtributoEnSuIndice) {
    Ficheros conNormal = version(frag("vec4(st, 0, 1)"), AZUL);
    conNormal["a.vert"] = "#version 140\nin vec3 posicion, antes, vNormal;\nout vec2 st;\nvoid main() {\n"
                          "    st = vec2(min(antes.x, 0.0), vNormal.z);\n"
                          "    gl_Position = vec4(posicion.x - 0.5, 2.0 * posicion.y, 0.0, 1.0);\n}\n";
    EXPECT_EQ(mitades(taller({conNormal}, "").imagen), "verde azul");
}

TEST(F12, DondeNoSePuedeEscribirAvisaYSigue) {
    const Ejecucion e = taller({version(ROJO, AZUL)}, "tecla n; especial F12; tecla v; especial F12");
    EXPECT_EQ(e.estado, 0);
    EXPECT_EQ(e.errores.rfind("taller: aviso: no puedo guardar «taller-1.ppm»: ", 0), 0u) << e.errores;
    EXPECT_EQ(std::count(e.errores.begin(), e.errores.end(), '\n'), 1);
    EXPECT_EQ(e.salida, "guardado taller-1.ppm\n");
    EXPECT_EQ(mitades(e.imagen), "rojo azul");
}

// Ocho texels por píxel: con mipmaps, el ajedrez se ve del gris de su media. Medio texel más allá, el centro de cada
// píxel es el de un texel y sin mipmaps se vería blanco o negro.
TEST(Textura, DeLejosSeVeSuMedia) {
    const Ejecucion e = taller({version(frag("texture(Img, st + 0.5 / 256.0)"), AZUL)}, "");
    ASSERT_EQ(e.estado, 0) << e.errores;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x)
            ASSERT_NEAR(pixel(e.imagen, x, y).g, 127.5, 1) << x << " " << y;
}

TEST(Textura, LaQueNoCabeLoDice) {
    const Ejecucion e = taller({version(ROJO, AZUL)}, "", {"enorme"});
    EXPECT_EQ(e.estado, 1);
    EXPECT_EQ(e.errores, "taller: una textura de 32768×2 es demasiado grande: este OpenGL las admite de "
                         "hasta 16384 de lado\n");
}
