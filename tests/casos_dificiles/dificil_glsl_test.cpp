// Casos difíciles de GLSL: lo que el lenguaje deja sin definir, en la GPU y leído en float. Lo que los shaders del
// laboratorio guardan tiene que dar lo que debe; y los que usan una función a secas, no pueden llegar a donde no está
// definida.
#include "cota.h"
#include "ejecuta.h"
#include "rutas.h"
#include "sonda.h"

namespace fs = std::filesystem;

namespace {

/// La expresión, de tipo float o vec3, puede ser de los vec3 `a` y `b` y de lo que tiene phong.glsl.
glm::vec3 glsl(const std::string &expresion, const glm::vec3 &a, const glm::vec3 &b = glm::vec3(0)) {
    static std::map<std::string, GLuint> programas;
    GLuint &programa = programas[expresion];
    if (programa == 0) {
        const ConRaiz raiz(carpetaTemporal());
        std::ofstream(carpetaTemporal() / "expresion.frag")
            << "#version 140\n#include \"tests/casos_dificiles/expresion.glsl\"\nvoid main() {\n"
            << "    colorFragmento = vec4(vec3(" << expresion << "), 1.0);\n}\n";
        programa = creaSonda("expresion.frag");
    }
    glUseProgram(programa);
    // ninguna usa todos estos uniforms: los que no, son −1, que OpenGL ignora
    const auto donde = [&](const char *nombre) { return glGetUniformLocation(programa, nombre); };
    glUniform3fv(donde("a"), 1, glm::value_ptr(a));
    glUniform3fv(donde("b"), 1, glm::value_ptr(b));
    return glm::vec3(leeSonda());
}

double numero(const std::string &expresion, const glm::vec3 &a, const glm::vec3 &b = glm::vec3(0)) {
    return glsl(expresion, a, b).x;
}
double error(const std::string &expresion, const glm::vec3 &a, double esperado) {
    return std::fabs(numero(expresion, a) - esperado);
}

/// Lo que le falta al resultado de unitario(v) para ser v/|v| o, si el cuadrado de |v| no cabe en un float, para ser 0.
double faltaDeUnitario(const glm::vec3 &v) {
    const glm::dvec3 r(glsl("unitario(a)", v)), exacto = glm::normalize(glm::dvec3(v));
    return r == glm::dvec3(0) ? 0 : glm::distance(r, exacto);
}

const double PI = glm::pi<double>();

const Cotas POTENCIAS([] {
    struct Potencia {
        float x, y;
        double esperado;
    };
    acotaCada<Potencia>("GlslPow", "*",
                        {{"0_a_0", {0, 0, 1}},
                         {"menos0_a_0", {-0.0f, 0, 1}},
                         {"0_a_1", {0, 1, 0}},
                         {"0_a_1em30", {0, 1e-30f, 0}},
                         {"0_a_500", {0, 500, 0}},
                         {"negativa_a_0", {-0.5f, 0, 1}},
                         {"negativa_a_1", {-0.5f, 1, 0}},
                         {"negativa_a_3", {-0.5f, 3, 0}},
                         {"menos1em7_a_4", {-1e-7f, 4, 0}},
                         {"1_a_500", {1, 500, 1}},
                         {"1_a_0", {1, 0, 1}},
                         {"1em38_a_0", {1e-38f, 0, 1}},
                         {"menos1_a_2", {-1, 2, 0}},
                         {"1em30_a_500", {1e-30f, 500, 0}},
                         {"alfa_0", {0.3f, 0, 1}}},
                        1e-6, "diferencia", [](const Potencia &p) {
                            return error("potencia(a.x, a.y)", {p.x, p.y, 0}, p.esperado);
                        });
    acota("GlslPow", "casi_1_a_500", 500 * 8 * U_FLOAT, "diferencia", [] {
        return error("potencia(a.x, a.y)", {0.99999f, 500, 0}, std::pow(double(0.99999f), 500));
    });
});

const Cotas UNITARIOS([] {
    acota("GlslNormalize", "de_0", 0, "longitud",
          [] { return glm::length(glsl("unitario(a)", glm::vec3(0))); });
    acotaCada<float>("GlslNormalize", "de_*",
                     {1e-38f, 1e-30f, 1e-22f, 1e-20f, 2e-19f, 1e-15f, 1.001f, 2, 1e15f, 1e18f, 1e20f, 1e38f},
                     8 * U_FLOAT, "diferencia",
                     [](float k) { return faltaDeUnitario(k * glm::vec3(1, -2, 2)); });
    // todo el margen de float, de 2⁻¹⁴⁹ a 2¹²⁶: o es unitario o es cero, nunca otra cosa
    acota("GlslNormalize", "todo_el_margen_de_float", 8 * U_FLOAT, "diferencia", [] {
        return peorHasta(
            276, [](int e) { return faltaDeUnitario(std::ldexp(1.0f, e - 149) * glm::vec3(0.6f, 0, 0.8f)); });
    });
});

const Cotas ATENUACIONES([] {
    struct Atenuacion {
        glm::vec3 abc;
        float d;
        double esperada;
    };
    // phong.glsl acota el denominador a 1e-6: 1/0 da 1e6, no infinito
    acotaCada<Atenuacion>(
        "GlslAtenuacion", "*",
        {{"d_0_constante", {{1, 0, 0}, 0, 1}},
         {"d_0_lineal", {{0, 1, 0}, 0, 1e6}},
         {"d_0_cuadratica", {{0, 0, 1}, 0, 1e6}},
         {"d_0_sin_coeficientes", {{0, 0, 0}, 0, 1e6}},
         {"d_1em20_lineal", {{0, 1, 0}, 1e-20f, 1e6}},
         {"d_1em30_cuadratica", {{0, 0, 1}, 1e-30f, 1e6}},
         {"d_1_todo", {{0.5f, 0.25f, 0.25f}, 1, 1}},
         {"d_1e10_cuadratica", {{0, 0, 1}, 1e10f, 1e-20}},
         {"d_1e18_cuadratica", {{0, 0, 1}, 1e18f, 1e-36}}},
        16 * U_FLOAT, "relativo", [](const Atenuacion &f) {
            return std::fabs(
                numero("atenuada(a, -1.0, 0.0, vec3(0.0, 0.0, -b.x))", f.abc, {f.d, 0, 0}) / f.esperada - 1);
        });
    struct Cono {
        double grados, exponente, angulo, esperado;
    };
    acotaCada<Cono>(
        "GlslCono", "*",
        {{"0_grados_en_el_eje", {0, 1, 0, 1}},
         {"0_grados_fuera", {0, 1, 0.05, 0}},
         {"0_grados_exponente_0", {0, 0, 0, 1}},
         {"90_grados_en_el_eje", {90, 1, 0, 1}},
         {"90_grados_a_89_9", {90, 1, 89.9, std::cos(89.9 * PI / 180)}},
         {"90_grados_a_89_9_exponente_0", {90, 0, 89.9, 1}},
         {"90_grados_a_90_1", {90, 0, 90.1, 0}},
         {"90_grados_de_espaldas", {90, 5, 180, 0}},
         {"45_grados_exponente_500", {45, 500, 44, std::pow(std::cos(44 * PI / 180), 500)}}},
        1e-5, "diferencia", [](const Cono &c) {
            const glm::vec3 a(std::cos(float(c.grados * PI / 180)), c.exponente, c.angulo * PI / 180);
            return error("atenuada(vec3(1.0, 0.0, 0.0), a.x, a.y, 3.0 * vec3(sin(a.z), 0.0, -cos(a.z)))", a,
                         c.esperado);
        });
});

} // namespace

// Ningún shader de un programa puede llegar a donde una función no está definida: cada uso es como aquí se dice.
TEST(GlslFuentes, NingunoLlegaADondeNoEstaDefinida) {
    const struct {
        std::string funcion, argumentos;
        int veces; // como poco
    } REGLAS[] = {
        {"acos", "nunca", 0},
        {"asin", "^clamp\\(.*, -1\\.0, 1\\.0\\)", 0},
        // atan(y, x) no lo está en (0, 0): con un número positivo sumado a x, el origen queda fuera
        {"atan", "^[^,()]+, [^,()]+ \\+ 1e-6\\)", 0},
        // los bordes son dos números distintos, el menor primero
        {"smoothstep", "^(-?[0-9.]+), (-?[0-9.]+), ", 6},
        // la base no puede ser negativa: es un max o un clamp, o se ha guardado antes; el exponente, mayor que cero
        {"pow", "^(?:max|clamp)\\(.*, [0-9.]+\\)|^(?:haciaSol|b|1\\.0 - cosV), [0-9.]+\\)|^x, y\\)", 6},
    };
    std::string fuentes;
    const fs::path raiz = fs::path(recurso("CMakeLists.txt")).parent_path();
    for (const auto &carpeta : fs::directory_iterator(raiz))
        if (std::regex_match(carpeta.path().filename().string(), std::regex("common|ch[0-9][0-9]_.*")))
            for (const auto &f : fs::directory_iterator(carpeta))
                if (std::regex_match(f.path().extension().string(), std::regex("\\.(frag|vert|glsl)")))
                    fuentes += leeFichero(f.path());
    fuentes = std::regex_replace(fuentes, std::regex("//[^\n]*"), "");
    for (const auto &[funcion, argumentos, veces] : REGLAS) {
        const std::regex usa("\\b" + funcion + "\\(([^\n]*)");
        const std::sregex_iterator usos(fuentes.begin(), fuentes.end(), usa), fin;
        EXPECT_GE(std::distance(usos, fin), veces) << funcion;
        for (auto uso = usos; uso != fin; ++uso) {
            const std::string suyos = uso->str(1);
            std::smatch m;
            ASSERT_TRUE(std::regex_search(suyos, m, std::regex(argumentos))) << uso->str();
            EXPECT_TRUE(funcion != "smoothstep" || std::stod(m[1]) < std::stod(m[2])) << uso->str();
        }
    }
}
