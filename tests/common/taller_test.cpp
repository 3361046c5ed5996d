// Lo que common/ hace con una ventana abierta: F5 con shaders mal editados, F12 donde no se puede escribir.
#include "ejecuta.h"
#include "shader.h"

namespace fs = std::filesystem;

namespace {

using Ficheros = std::map<std::string, std::string>; // nombre → contenido
const char *const BORRADO = "-";

const std::string CABECERA = "#version 140\nout vec4 colorFragmento;\n";

std::string vert(const std::string &x) {
    return "#version 140\nin vec3 posicion;\nin vec2 coordTextura;\nout vec2 st;\nvoid main() {\n    st = "
           "coordTextura;\n"
           "    gl_Position = vec4(posicion.x + " +
           x + ", 2.0 * posicion.y, 0.0, 1.0);\n}\n";
}
std::string frag(const std::string &color) {
    return CABECERA + "in vec2 st;\nvoid main() {\n    colorFragmento = " + color + ";\n}\n";
}
const std::string ROJO = "vec4(1, 0, 0, 1)", VERDE = "vec4(0, 1, 0, 1)", AZUL = "vec4(0, 0, 1, 1)",
                  BLANCO = "vec4(1, 1, 1, 1)";

/// La versión de esos dos colores, con esos cambios.
Ficheros version(const std::string &colorA, const std::string &colorB, Ficheros cambios = {}) {
    cambios.merge(Ficheros{{"a.vert", vert("-0.5")},
                           {"a.frag", frag(colorA)},
                           {"b.vert", vert("0.5")},
                           {"b.frag", frag(colorB)}});
    return cambios;
}

/// Ejecuta el taller de tests/costura/defectuoso.cpp con esas versiones de sus shaders en $LAB_RAIZ/0, /1…
Ejecucion taller(const std::vector<Ficheros> &versiones, const std::string &guion = "", int ancho = 64) {
    static int n = 0;
    const fs::path raiz = carpetaTemporal() / ("raiz" + std::to_string(++n));
    for (std::size_t v = 0; v < versiones.size(); ++v) {
        const fs::path carpeta = raiz / std::to_string(v);
        fs::create_directories(carpeta);
        for (const auto &[nombre, contenido] : versiones[v])
            if (contenido != BORRADO)
                std::ofstream(carpeta / nombre, std::ios::binary) << contenido;
    }
    const ConRaiz conRaiz(raiz);
    return ejecuta("../tests/defectuoso", guion, ancho, ancho / 2, {"taller"});
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
    Ficheros cambios; // sobre una versión buena
    std::string mensaje;
};
const Rotura ROTURAS[] = {
    {{{"a.frag", frag("vec4(1.0, ,")}}, "taller/a.frag:5: error: "},
    {{{"a.frag", CABECERA + "/*/ñ*/ // é\n/**/ float año;\n"}},
     "taller/a.frag:4: en la columna 13, la letra «ñ» no vale en GLSL"},
    {{{"a.frag", CABECERA + "float\u00A0x;\n"}},
     "taller/a.frag:3: en la columna 6, este espacio no es el del teclado y no vale en GLSL"},
    {{{"a.frag", std::string("\xFF\xFE#\0v\0", 6)}},
     "taller/a.frag» está en UTF-16: ábrelo en el editor y guárdalo"},
    {{{"a.vert", "#version 150\nvoid main() {\n}\n"}}, "taller/a.vert:1: error: GLSL 1.50 is not supported"},
    {{{"a.frag", CABECERA + "#include \"taller/no_esta.glsl\"\n"}},
     "taller/a.frag:3: no encuentro «taller/no_esta.glsl»; lo he buscado en "},
    {{{"a.frag", CABECERA + "#include \"taller/a.frag\"\n"}},
     "taller/a.frag:3: #include sin fin: taller/a.frag → taller/a.frag"},
    {{{"a.frag", CABECERA + "  #include  \"taller/c.glsl\" \n"},
      {"c.glsl", "\n#include \"taller/a.frag\"\n"}},
     "taller/a.frag:3: taller/c.glsl:2: #include sin fin: taller/a.frag → taller/c.glsl → taller/a.frag"},
    // el error de un fichero incluido nombra ese fichero
    {{{"a.frag", CABECERA + "#include \"taller/c.glsl\"\n"}, {"c.glsl", "\nfloat x = y;\n"}},
     "taller/c.glsl:2: error: `y' undeclared — «float x = y;»"},
    {{{"a.vert", BORRADO}}, "no encuentro «taller/a.vert»; lo he buscado en "},
    {{{"a.vert", ""}}, "taller/a.vert"},
    {{{"a.vert",
       "#version 140\nout vec2 st;\nvoid main() {\n    st = vec2(0.0);\n    gl_Position = vec4(1.0);\n}\n"}},
     "taller/a.vert: no usa el atributo «posicion»"},
    {{{"a.vert",
       "#version 140\nin vec3 posicion;\nout vec3 st;\nvoid main() {\n    st = posicion;\n    gl_Position = "
       "vec4(st, 1.0);\n}\n"},
      {"a.frag", frag("vec4(st, 0, 1)")}},
     "taller/a.vert y taller/a.frag no enlazan: "},
};

} // namespace

// Al arrancar, un shader roto termina el programa con una línea que dice cuál es. Con la ventana abierta, F5 con el
// primero roto avisa y lo conserva, y relee el segundo; arreglado, se ve bien.
TEST(Shaders, UnoRoto) {
    EXPECT_EQ(mitades(taller({version(ROJO, AZUL)}).imagen), "rojo azul");
    for (const Rotura &r : ROTURAS) {
        SCOPED_TRACE(r.mensaje);
        const std::vector<Ficheros> versiones = {version(ROJO, AZUL), version(ROJO, VERDE, r.cambios),
                                                 version(BLANCO, BLANCO)};
        const Ejecucion alArrancar = taller({versiones[1]}), roto = taller(versiones, "tecla 1; especial F5"),
                        bien = taller(versiones, "tecla 1; especial F5 ×2; tecla 2; especial F5");
        EXPECT_EQ(alArrancar.estado, 1);
        EXPECT_TRUE(alArrancar.imagen.rgb.empty());
        EXPECT_EQ(roto.estado, 0);
        EXPECT_EQ(mitades(roto.imagen), "rojo verde");
        for (const auto &[dice, principio] :
             {std::pair(alArrancar.errores, "defectuoso: "), {roto.errores, "defectuoso: aviso: "}}) {
            EXPECT_EQ(dice.rfind(principio, 0), 0u) << dice.substr(0, 500);
            EXPECT_NE(dice.find(r.mensaje), std::string::npos) << dice.substr(0, 500);
        }
        EXPECT_EQ(bien.estado, 0);
        EXPECT_EQ(mitades(bien.imagen), "blanco blanco");
    }
}

// Solo lo que se incluye a sí mismo no acaba; dos veces seguidas sí se puede. Y la normal está en su índice, el de los
// buffers, aunque el shader tenga antes otro atributo.
TEST(Shaders, LoQueSePuede) {
    const std::string incluye = "#include \"taller/c.glsl\"\n";
    const Ficheros dosVeces = {
        {"a.frag", CABECERA +
                       "/* /\n#include \"taller/no_esta.glsl\"\n// */\nvoid main() {\n    float x = 0.0;\n" +
                       incluye + incluye + "    colorFragmento = vec4(0, step(1.0, x), 0, 1);\n}\n"},
        {"c.glsl", "    x += 0.5;\n"}};
    const Ficheros conNormal = {{"a.vert", R"(#version 140
in vec3 posicion, antes, vNormal;
out vec2 st;
void main() {
    st = vec2(min(antes.x, 0.0), vNormal.z);
    gl_Position = vec4(posicion.x - 0.5, 2.0 * posicion.y, 0.0, 1.0);
}
)"}};
    Ficheros deMac = dosVeces, deWindows;
    for (const auto &[nombre, texto] : dosVeces)
        deWindows[nombre] = std::regex_replace(texto, std::regex("\n"), "\r\n");
    std::replace(deMac["a.frag"].begin(), deMac["a.frag"].end(), '\n', '\r');
    for (const Ficheros &cambios : {dosVeces, conNormal, deMac, deWindows}) {
        const Ejecucion e = taller({version("vec4(st, 0, 1)", AZUL, cambios)});
        EXPECT_EQ(e.errores, "");
        EXPECT_EQ(mitades(e.imagen), "verde azul");
    }
}

// Cada fabricante da a su manera la línea de un error, que se dice una vez: aquí los compiladores son de mentira.
TEST(Shaders, ElInformeDeCadaFabricante) {
    static std::string informe;
    glCreateShader = [](GLenum) { return 1u; };
    glShaderSource = [](GLuint, GLsizei, const GLchar *const *, const GLint *) {};
    glCompileShader = glDeleteShader = [](GLuint) {};
    glGetShaderiv = [](GLuint, GLenum que, GLint *valor) {
        *valor = que == GL_INFO_LOG_LENGTH ? GLint(informe.size()) + 1 : GL_FALSE;
    };
    glGetShaderInfoLog = [](GLuint, GLsizei, GLsizei *, GLchar *texto) {
        std::strcpy(texto, informe.c_str());
    };
    std::ofstream(carpetaTemporal() / "tres.frag") << "uno\ndos\n  tres\n";
    const ConRaiz raiz(carpetaTemporal());
    for (const auto &[dado, traducido] :
         {std::pair("0:3(5): error: mal\n0:3(7): error: peor", "tres.frag:3: error: mal — «tres»"), // Mesa
          {"0(2) : error C1008: mal\n0(1) : warning: bah",
           "tres.frag:2: error C1008: mal — «dos»\ntres.frag:1: warning: bah — «uno»"}, // NVIDIA
          {"ERROR: 0:1: 'y' : mal\nERROR: 1 compilation errors.",
           "tres.frag:1: 'y' : mal — «uno»\nERROR: 1 compilation errors."}, // AMD
          {"0:9(1): error: lejos", "tres.frag: error: lejos"}}) {
        informe = dado;
        std::string error;
        EXPECT_EQ(intentaPrograma("tres.frag", "tres.frag", error), 0u);
        EXPECT_EQ(error, traducido);
    }
}

// Con F3 no hace falta F5: lo que se guarda se relee, también lo incluido; lo que no compila se dice sobre la imagen,
// que sigue con lo de antes, hasta que se arregla. Sin F3, y tras pulsarla otra vez, nada.
TEST(F3, LoQueSeGuardaSeRelee) {
    const std::string incluye = "#include \"taller/c.glsl\"\n",
                      incluido = CABECERA + incluye + "void main() {\n    colorFragmento = COLOR;\n}\n",
                      comun = "const vec4 COLOR = vec4(0, ";
    const std::vector<Ficheros> versiones = {
        version(ROJO, AZUL, {{"a.frag", incluido}, {"c.glsl", comun + "1, 0, 1);\n"}}),
        version(ROJO, BLANCO, {{"a.frag", incluido}, {"c.glsl", comun + "0, 1, 1);\n"}}),
        version(ROJO, VERDE, {{"a.frag", incluido}, {"c.glsl", comun + "0, 1;\n"}})};
    const std::string espera = "; espera 600";
    for (const auto &[guion, debe] :
         {std::pair("tecla 1" + espera, "verde azul"),
          {"especial F3; tecla 1; espera 200", "verde azul"},
          {"especial F3; tecla 1" + espera, "azul blanco"},
          {"especial F3 ×2; tecla 1" + espera, "verde azul"},
          {"especial F3 ×3; tecla 1" + espera, "azul blanco"},
          {"especial F3; tecla 2" + espera + "; tecla 1" + espera, "azul blanco"}}) {
        const Ejecucion e = taller(versiones, guion);
        EXPECT_EQ(mitades(e.imagen), debe) << guion;
        EXPECT_EQ(e.estado, 0);
    }
    const Ejecucion roto = taller(versiones, "especial F3; tecla 2" + espera, 400);
    EXPECT_EQ(std::count(roto.errores.begin(), roto.errores.end(), '\n'), 1) << roto.errores; // no se repite
    EXPECT_NE(roto.errores.find("taller/c.glsl:1: "), std::string::npos) << roto.errores;
    EXPECT_EQ(roto.salida, "vigilo los shaders\n");
    const int alto = roto.imagen.alto;
    EXPECT_EQ(pixel(roto.imagen, 100, alto - 1).g, 255); // sigue con lo de antes, y se ve
    EXPECT_EQ(pixel(roto.imagen, 300, alto - 1).g, 255); // el otro se ha releído
    int claros = 0;                                      // abajo, en un velo, el error: unas cuantas letras
    for (int x = 3; x < 200; ++x)
        for (int y = 3; y < 20; ++y)
            claros += pixel(roto.imagen, x, y).b > 200 && pixel(roto.imagen, x, y).r > 200;
    EXPECT_LT(pixel(roto.imagen, 3, 3).g, 128);
    EXPECT_GT(claros, 200);
    const Ejecucion otra = taller(
        versiones, "especial F3; tecla 2" + espera + "; especial F3; tecla 1; especial F5; especial F3", 400);
    EXPECT_GT(pixel(otra.imagen, 3, 3).b, 200) << "arreglado, el error ya no está";
}

TEST(F12, DondeNoSePuedeEscribirAvisaYSigue) {
    const Ejecucion e = taller({version(ROJO, AZUL)}, "tecla n; especial F12; tecla v; especial F12");
    EXPECT_EQ(e.estado, 0);
    EXPECT_EQ(e.errores.rfind("defectuoso: aviso: no puedo guardar «defectuoso-1.png»: ", 0), 0u)
        << e.errores;
    EXPECT_EQ(std::count(e.errores.begin(), e.errores.end(), '\n'), 1);
    EXPECT_EQ(e.salida, "guardado defectuoso-1.png\n");
    EXPECT_EQ(mitades(e.imagen), "rojo azul");
    const std::string doce = taller({version(ROJO, AZUL)}, "especial F12 ×12").salida;
    EXPECT_NE(doce.find("-12.png\n"), std::string::npos) << "ninguna pisa a otra: " << doce;
}
