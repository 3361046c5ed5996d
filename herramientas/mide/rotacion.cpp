// Un giro alrededor de un eje cualquiera: su matriz, y lo que se desvía tras muchos pasos.
#include "ch03_transformaciones/transformaciones.h"
#include "mide.h"
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

using namespace mide;
using Largo = long double;

static const double RADIO_PX = 500; // a esta distancia del eje se ve el error

struct Giro {
    glm::vec3 eje;
    float angulo;
};

// Lo que se separa en píxeles, como mucho, un punto girado con M del girado con el giro exacto (Rodrigues, en
// doble extendida).
static double error(const glm::mat3 &M, const glm::vec3 &eje, Largo angulo) {
    using V = glm::vec<3, Largo>;
    const V e = glm::normalize(V(eje));
    const Largo v = 2 * std::pow(std::sin(angulo / 2), Largo(2));
    Largo suma = 0;
    for (int j = 0; j < 3; ++j) {
        V base(0);
        base[j] = 1;
        const V exacta = std::cos(angulo) * base + std::sin(angulo) * glm::cross(e, base) + v * e[j] * e,
                d = V(M[j]) - exacta;
        suma += glm::dot(d, d);
    }
    return RADIO_PX * double(std::sqrt(suma));
}

static glm::mat3 ortonormal(const glm::mat3 &M) {
    const glm::vec3 x = glm::normalize(M[0]), z = glm::normalize(glm::cross(x, M[1]));
    return {x, glm::cross(z, x), z};
}

static std::vector<Giro> girosCorrientes(int cuantos) {
    Azar al(1);
    std::vector<Giro> giros;
    for (int i = 0; i < cuantos; ++i)
        giros.push_back({{al(), al(), al()}, i % 3 ? 3 * al() : 1e-4f * al()});
    // también los ejes de los casos difíciles: muy cortos, muy largos y casi a lo largo de X
    for (const glm::vec3 &e : {glm::vec3(1, 1e-20f, 0), glm::vec3(1, 1e-10f, 0),
                               glm::vec3(2e-4f, 1e-4f, 3e-4f), glm::vec3(3e4f, 1e4f, -2e4f)})
        giros.push_back({e, 1});
    return giros;
}

template<class Matriz>
static double peorError(const std::vector<Giro> &giros, const Matriz &matriz) {
    double peor = 0;
    for (const Giro &g : giros) {
        const double e = error(matriz(g), g.eje, Largo(g.angulo));
        peor = std::max(peor, std::isfinite(e) ? e : INFINITO);
    }
    return peor;
}

static void mideMatrices(Medidor &m) {
    const std::vector<Giro> corrientes = girosCorrientes(m.elige(60, 600));
    std::vector<Giro> todos = corrientes;
    for (const float l : {1e-23f, 1e20f}) // cuyo cuadrado no cabe en un float
        todos.push_back({l * glm::vec3(1, 2, 3), 1});
    const auto matriz = [&](const char *nombre, const char *nota, const auto &f) {
        m.variante(nombre, formatea("%scon ejes corrientes, %.2g px", nota, peorError(corrientes, f)),
                   peorError(todos, f), double(todos.size()), [&] {
                       for (const Giro &g : todos)
                           usa(f(g));
                   });
    };
    matriz("cambio de base", "giroEje; ", [](const Giro &g) { return glm::mat3(giroEje(g.eje, g.angulo)); });
    matriz("par: glm::rotate", "Rodrigues; ",
           [](const Giro &g) { return glm::mat3(glm::rotate(glm::mat4(1), g.angulo, g.eje)); });
    matriz("cuaternión a matriz (GLM)", "",
           [](const Giro &g) { return glm::mat3_cast(glm::angleAxis(g.angulo, glm::normalize(g.eje))); });
}

static const Giro PASO = {{1, 2, 3}, 0.001f};

static void mideDerivas(Medidor &m) {
    m.grupo = "10⁶ pasos";
    const int pasos = m.elige(1000, 1000000);
    const auto deriva = [&](const std::string &nombre, const char *nota, const auto &recorre) {
        // lo exacto: tantas veces el ángulo que de verdad tiene el float
        const double e = error(recorre(pasos), PASO.eje, Largo(PASO.angulo) * pasos);
        const int n = m.elige(10, 1000); // los que da al cronometrar
        m.variante("10⁶ pasos, " + nombre, nota, e, n, [&] { usa(recorre(n)); });
    };
    const glm::mat3 unPaso(giroEje(PASO.eje, PASO.angulo));
    deriva("matriz", "deja de ser un giro: deforma", [&](int n) {
        glm::mat3 M(1);
        for (int i = 0; i < n; ++i)
            M = unPaso * M;
        return M;
    });
    deriva("matriz ortonormalizada", "no deforma, pero el ángulo se desvía", [&](int n) {
        glm::mat3 M(1);
        for (int i = 0; i < n; ++i)
            M = ortonormal(unPaso * M);
        return M;
    });
    deriva("cuaternión normalizado", "", [](int n) {
        const glm::quat q = glm::angleAxis(PASO.angulo, glm::normalize(PASO.eje));
        glm::quat giro(1, 0, 0, 0);
        for (int i = 0; i < n; ++i)
            giro = glm::normalize(q * giro);
        return glm::mat3_cast(giro);
    });
    deriva("recalculada", "del ángulo total, cada vez", [](int n) {
        glm::mat3 M;
        for (int i = 1; i <= n; ++i) { // el ángulo, en double y reducido a una vuelta
            const double vuelta = 2 * 3.14159265358979323846, t = i * double(PASO.angulo);
            M = glm::mat3(giroEje(PASO.eje, float(std::remainder(t, vuelta))));
            usa(M);
        }
        return M;
    });
}

static void mideRotacion(Medidor &m) {
    mideMatrices(m);
    mideDerivas(m);
}

static const Apunta APUNTA(
    {7, "rotacion", "Girar alrededor de un eje", "ns por giro",
     "píxeles a 500 del eje, frente a doble extendida", "cambio de base",
     "Con un eje corriente todas son exactas a una milésima de píxel. Los programas usan la del libro, "
     "con el eje escalado: vale también con uno de 10⁻²³ o de 10²⁰, en que las demás dan NaN. Lo "
     "que importa es no acumular: los programas animados recalculan el giro con el ángulo total.",
     mideRotacion});
