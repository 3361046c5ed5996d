// Casos difíciles de GLSL: lo que el lenguaje deja sin definir, en la GPU y leído en float. Lo que los shaders del laboratorio
// guardan tiene que dar lo que debe; y los que usan una función a secas, no pueden llegar a donde no está definida.
#include "caso.h"
#include "rutas.h"
#include "sonda.h"
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <regex>
#include <vector>

namespace {

enum Cual {
    POTENCIA,
    UNITARIO,
    POW,
    NORMALIZE,
    ACOS,
    ATAN,
    FRACT,
    SMOOTHSTEP,
    DOT,
    SENO,
    ATENUADA,
    CONO,
    REFLECT,
    RAIZ
};

glm::vec3 glsl(Cual cual, const glm::vec3 &a, const glm::vec3 &b = glm::vec3(0)) {
    static const GLuint programa = creaSonda("tests/casos_dificiles/glsl.frag");
    glUseProgram(programa);
    envia(programa, "cual", static_cast<int>(cual));
    envia(programa, "a", a);
    envia(programa, "b", b);
    return glm::vec3(leeSonda());
}
double numero(Cual cual, const glm::vec3 &a, const glm::vec3 &b = glm::vec3(0)) {
    return static_cast<double>(glsl(cual, a, b).x);
}
double error(Cual cual, const glm::vec3 &a, double esperado) {
    return std::fabs(numero(cual, a) - esperado);
}

/// Lo que le falta al resultado de unitario(v) para ser v/|v| o, si el cuadrado de |v| no cabe en un float, para ser 0.
double faltaDeUnitario(const glm::vec3 &v) {
    const glm::dvec3 r(glsl(UNITARIO, v)), exacto = glm::normalize(glm::dvec3(v));
    return r == glm::dvec3(0) ? 0 : glm::distance(r, exacto);
}

const double PI = 3.14159265358979323846;

const Casos POTENCIAS([] {
    const struct {
        const char *nombre;
        float x, y;
        double esperado;
    } filas[] = {{"0_a_0", 0, 0, 1},
                 {"menos0_a_0", -0.0f, 0, 1},
                 {"0_a_1", 0, 1, 0},
                 {"0_a_1em30", 0, 1e-30f, 0},
                 {"0_a_500", 0, 500, 0},
                 {"negativa_a_0", -0.5f, 0, 1},
                 {"negativa_a_1", -0.5f, 1, 0},
                 {"negativa_a_3", -0.5f, 3, 0},
                 {"menos1em7_a_4", -1e-7f, 4, 0},
                 {"1_a_500", 1, 500, 1},
                 {"1em30_a_500", 1e-30f, 500, 0},
                 {"alfa_0", 0.3f, 0, 1}};
    for (const auto &f : filas)
        caso("GlslPow", f.nombre, 1e-6, "diferencia", [=] {
            return error(POTENCIA, {f.x, f.y, 0}, f.esperado);
        });
    caso("GlslPow", "casi_1_a_500", 500 * 8 * U_FLOAT, "diferencia", [] {
        return error(POTENCIA, {0.99999f, 500, 0}, std::pow(static_cast<double>(0.99999f), 500));
    });
});

const Casos UNITARIOS([] {
    caso("GlslNormalize", "de_0", 0, "longitud",
         [] { return static_cast<double>(glm::length(glsl(UNITARIO, glm::vec3(0)))); });
    for (const float k :
         {1e-38f, 1e-30f, 1e-22f, 1e-20f, 2e-19f, 1e-15f, 1.001f, 2.0f, 1e15f, 1e18f, 1e20f, 1e38f})
        caso("GlslNormalize", "de_" + enNombre(static_cast<double>(k)), 8 * U_FLOAT, "diferencia",
             [=] { return faltaDeUnitario(k * glm::vec3(1, -2, 2)); });
    // todo el margen de float: o es unitario o es cero, nunca otra cosa
    caso("GlslNormalize", "todo_el_margen_de_float", 8 * U_FLOAT, "diferencia", [] {
        double peor = 0;
        for (int e = -149; e < 127; ++e)
            peor = mayor(faltaDeUnitario(std::ldexp(1.0f, e) * glm::vec3(0.6f, 0, 0.8f)), peor);
        return peor;
    });
});

const Casos ATENUACIONES([] {
    // phong.glsl acota el denominador a 1e-6: 1/0 da 1e6, no infinito
    const struct {
        const char *nombre;
        glm::vec3 abc;
        float d;
        double esperada;
    } filas[] = {{"d_0_constante", {1, 0, 0}, 0, 1},
                 {"d_0_lineal", {0, 1, 0}, 0, 1e6},
                 {"d_0_cuadratica", {0, 0, 1}, 0, 1e6},
                 {"d_0_sin_coeficientes", {0, 0, 0}, 0, 1e6},
                 {"d_1em20_lineal", {0, 1, 0}, 1e-20f, 1e6},
                 {"d_1em30_cuadratica", {0, 0, 1}, 1e-30f, 1e6},
                 {"d_1_todo", {0.5f, 0.25f, 0.25f}, 1, 1},
                 {"d_1e10_cuadratica", {0, 0, 1}, 1e10f, 1e-20},
                 {"d_1e18_cuadratica", {0, 0, 1}, 1e18f, 1e-36}};
    for (const auto &f : filas)
        caso("GlslAtenuacion", f.nombre, 16 * U_FLOAT, "relativo", [=] {
            return std::fabs(numero(ATENUADA, f.abc, {f.d, 0, 0}) / f.esperada - 1);
        });
    const struct {
        const char *nombre;
        double grados, exponente, angulo, esperado;
    } conos[] = {{"0_grados_en_el_eje", 0, 1, 0, 1},
                 {"0_grados_fuera", 0, 1, 0.05, 0},
                 {"0_grados_exponente_0", 0, 0, 0, 1},
                 {"90_grados_en_el_eje", 90, 1, 0, 1},
                 {"90_grados_a_89_9", 90, 1, 89.9, std::cos(89.9 * PI / 180)},
                 {"90_grados_a_89_9_exponente_0", 90, 0, 89.9, 1},
                 {"90_grados_a_90_1", 90, 0, 90.1, 0},
                 {"90_grados_de_espaldas", 90, 5, 180, 0},
                 {"45_grados_exponente_500", 45, 500, 44, std::pow(std::cos(44 * PI / 180), 500)}};
    for (const auto &c : conos)
        caso("GlslCono", c.nombre, 1e-5, "diferencia", [=] {
            return error(
                CONO, {std::cos(static_cast<float>(c.grados * PI / 180)), c.exponente, c.angulo * PI / 180},
                c.esperado);
        });
});

const Casos FUNCIONES([] {
    for (const float x : {-1e-9f, -1e-30f, -0.25f, 8388607.5f, 16777216.0f, -16777217.0f, 1e30f})
        caso("GlslFract", "de_" + enNombre(static_cast<double>(x)), U_FLOAT, "diferencia", [=] {
            const double exacto = static_cast<double>(x) -
                                  std::floor(static_cast<double>(x)); // a −1e-9, el float más próximo es 1
            return error(FRACT, {x, 0, 0}, exacto);
        });
    for (const float x : {-1.0f, 0.0f, 1.0f})
        caso("GlslAcos", "de_" + enNombre(static_cast<double>(x)), 1e-3, "rad", [=] {
            return error(ACOS, {x, 0, 0}, std::acos(static_cast<double>(x)));
        });
    for (const float x :
         {std::nextafter(1.0f, 2.0f), std::nextafter(-1.0f, -2.0f)}) // recortada, que es lo que hay que hacer
        caso("GlslAcos", x > 0 ? "recortada_1_mas_un_ulp" : "recortada_menos_1_menos_un_ulp", 1e-3, "rad",
             [=] {
                 return error(ACOS, {std::clamp(x, -1.0f, 1.0f), 0, 0}, x > 0 ? 0 : PI);
             });
    for (const auto &[nombre, x, y] : {std::tuple("y_0_x_1", 1.0f, 0.0f),
                                       {"y_0_x_menos_1", -1.0f, 0.0f},
                                       {"y_1_x_0", 0.0f, 1.0f},
                                       {"y_menos_1_x_0", 0.0f, -1.0f},
                                       {"y_1em20_x_1em20", 1e-20f, 1e-20f}})
        caso("GlslAtan", nombre, 1e-3, "rad", [=, x = x, y = y] {
            return error(ATAN, {y, x, 0}, std::atan2(double(y), double(x)));
        });
    for (const float x : {0.0f, 1.0f, -1.0f, 1e20f, 0.5f})
        caso("GlslSmoothstep", "bordes_casi_iguales_en_" + enNombre(static_cast<double>(x)), 1e-6,
             "diferencia", [=] {
                 const float a = 0.5f, b = std::nextafter(0.5f, 1.0f);
                 return error(SMOOTHSTEP, {a, b, x}, x >= b ? 1 : 0);
             });

    // Dos vectores normalizados: su producto pasa de 1 en el redondeo, y 1 − N·V puede ser negativo. De ahí el max de tetera.frag.
    caso("GlslDot", "de_dos_unitarios_pasa_de_1", 4 * U_FLOAT, "lo que pasa de 1", [] {
        std::mt19937 azar(1);
        std::uniform_real_distribution<float> d(-1, 1);
        double peor = 0;
        for (int i = 0; i < 2000; ++i) {
            const float x = d(azar), y = d(azar), z = d(azar);
            peor = mayor(numero(DOT, {x, y, z}, {x, y, z}) - 1, peor);
        }
        return peor;
    });
    caso("GlslSeno", "no_pasa_de_1", 4 * U_FLOAT, "lo que pasa de 1", [] {
        double peor = -1;
        for (int i = -2000; i <= 2000; ++i)
            peor = mayor(numero(SENO, {static_cast<float>((i / 100 + 0.5) * PI + i % 100 * 1e-5), 0, 0}) - 1,
                         peor);
        return peor;
    });
    for (const float k :
         {1.001f,
          2.0f}) // reflect con una normal que no es unitaria se sale del círculo: hay que normalizarla
        caso("GlslReflect", "normal_de_longitud_" + enNombre(static_cast<double>(k)) + "_normalizada",
             8 * U_FLOAT, "diferencia", [=] {
                 const glm::vec3 d(0.6f, -0.8f, 0), n = glsl(UNITARIO, k * glm::vec3(0, 1, 0));
                 return glm::distance(glm::dvec3(glsl(REFLECT, d, n)), glm::dvec3(0.6f, 0.8f, 0));
             });
});

/// Los shaders de los programas, sin comentarios.
std::vector<std::pair<std::string, std::string>> shaders() {
    namespace fs = std::filesystem;
    std::vector<std::pair<std::string, std::string>> textos;
    const fs::path raiz = fs::path(recurso("ch05_iluminacion/phong.glsl")).parent_path().parent_path();
    for (const auto &carpeta : fs::directory_iterator(raiz)) {
        const std::string nombre = carpeta.path().filename().string();
        if (nombre != "common" && !std::regex_match(nombre, std::regex("ch[0-9][0-9]_.*")))
            continue;
        for (const auto &f : fs::directory_iterator(carpeta)) {
            const std::string extension = f.path().extension().string();
            if (extension != ".frag" && extension != ".vert" && extension != ".glsl")
                continue;
            std::ifstream entrada(f.path());
            std::string texto, linea;
            while (std::getline(entrada, linea))
                texto += linea.substr(0, linea.find("//")) + "\n";
            textos.emplace_back(nombre + "/" + f.path().filename().string(), texto);
        }
    }
    return textos;
}
/// Cada uso de `funcion(`, con lo que sigue hasta el fin de línea.
std::vector<std::string> usos(const std::string &funcion) {
    std::vector<std::string> lista;
    const std::regex busca("\\b" + funcion + "\\(([^\n]*)");
    for (const auto &[ruta, texto] : shaders())
        for (std::sregex_iterator i(texto.begin(), texto.end(), busca), fin; i != fin; ++i)
            lista.push_back(ruta + ": " + funcion + "(" + (*i)[1].str());
    return lista;
}

} // namespace

// La sonda ve un NaN y un infinito: si los tapara, nada de lo de arriba valdría.
TEST(GlslSonda, VeElNaNYElInfinito) {
    const glm::vec3 r = glsl(RAIZ, {-1, 0, 0});
    EXPECT_EQ(r.x, 0);
    EXPECT_TRUE(std::isnan(r.y));
    EXPECT_TRUE(std::isinf(r.z));
}

// Lo que da este controlador donde GLSL no promete nada: se escribe, no se exige.
TEST(GlslSonda, LoQueDaEsteControlador) {
    const float paso = std::nextafter(1.0f, 2.0f);
    const std::pair<const char *, double> filas[] = {
        {"pow(0, 0)", numero(POW, {0, 0, 0})},
        {"pow(-0.5, 3)", numero(POW, {-0.5f, 3, 0})},
        {"normalize(0)", numero(NORMALIZE, glm::vec3(0))},
        {"normalize(1e-20)", numero(NORMALIZE, {1e-20f, 0, 0})},
        {"acos(1 + un ulp)", numero(ACOS, {paso, 0, 0})},
        {"atan(0, 0)", numero(ATAN, glm::vec3(0))},
        {"smoothstep(0.5, 0.5, 0.5)", numero(SMOOTHSTEP, glm::vec3(0.5f))}};
    int raros = 0;
    for (const auto &[que, valor] : filas) {
        std::cout << que << " = " << valor << "\n";
        RecordProperty(que, std::to_string(valor));
        raros += !std::isfinite(valor);
    }
    EXPECT_GT(raros, 0) << "este controlador lo define todo: las guardas no se están probando";
}

// Ningún shader puede llegar a donde no está definido. acos y asin, ninguno los usa.
TEST(GlslFuentes, NingunShaderUsaAcosNiAsin) {
    EXPECT_EQ(usos("acos"), std::vector<std::string>());
    EXPECT_EQ(usos("asin"), std::vector<std::string>());
    EXPECT_GT(shaders().size(), 40u);
}
// atan(y, x) no está definida en (0, 0): con un número positivo sumado a x, el origen queda fuera.
TEST(GlslFuentes, NingunAtanEnElOrigen) {
    for (const std::string &uso : usos("atan"))
        EXPECT_TRUE(std::regex_search(uso, std::regex("atan\\([^,()]+, [^,()]+ \\+ 1e-6\\)"))) << uso;
}
// Los bordes de smoothstep son dos números distintos, el menor primero.
TEST(GlslFuentes, LosBordesDeSmoothstepCrecen) {
    const std::vector<std::string> lista = usos("smoothstep");
    EXPECT_GT(lista.size(), 5u);
    for (const std::string &uso : lista) {
        std::smatch m;
        ASSERT_TRUE(std::regex_search(uso, m, std::regex("smoothstep\\((-?[0-9.]+), (-?[0-9.]+), "))) << uso;
        EXPECT_LT(std::stod(m[1]), std::stod(m[2])) << uso;
    }
}
// La base de pow no puede ser negativa: es un max o un clamp, o se ha guardado antes. Y el exponente es un número mayor que cero.
TEST(GlslFuentes, LaBaseDePowNoEsNegativa) {
    const std::vector<std::string> lista = usos("pow");
    EXPECT_GT(lista.size(), 5u);
    for (const std::string &uso : lista)
        EXPECT_TRUE(std::regex_search(
            uso, std::regex("pow\\((max|clamp)\\(.*, [0-9.]+\\)|pow\\((haciaSol|b|1\\.0 - cosV), [0-9.]+\\)|"
                            "phong.glsl: pow\\(x, y\\)")))
            << uso;
}
