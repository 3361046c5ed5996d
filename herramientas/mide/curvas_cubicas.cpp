// Un punto de una cúbica de Bézier: la matriz del libro, Bernstein, de Casteljau, diferencias o el vertex shader.
#include "bezier_exacta.h"
#include "ch11_curvas/curvas.h"
#include "gpu.h"
#include "mide.h"
#include "shader.h"

using namespace mide;

using G3 = Geometria<float>;

// En píxeles de una ventana de 1080 líneas; lejos del origen, como en una escena grande.
static const G3 G = {glm::vec3(1010, 2040, 15), {1330, 3010, -250}, {1720, 1500, 410}, {2030, 2080, 70}};

// M·G (ecuación 11.18): los coeficientes de u³, u², u y 1.
static G3 coeficientes(const G3 &g) {
    return {-g[0] + 3.0f * g[1] - 3.0f * g[2] + g[3], 3.0f * g[0] - 6.0f * g[1] + 3.0f * g[2],
            3.0f * (g[1] - g[0]), g[0]};
}

static glm::vec3 deCasteljau(const G3 &g, float u) {
    const float c = 1 - u;
    const glm::vec3 a = c * g[0] + u * g[1], b = c * g[1] + u * g[2], d = c * g[2] + u * g[3];
    return c * (c * a + u * b) + u * (c * b + u * d);
}

// Todos los puntos, sumando: tres sumas por punto, pero cada error se arrastra al siguiente.
template<class T>
static void diferencias(const G3 &g, std::vector<glm::vec3> &puntos) {
    using V = glm::vec<3, T>;
    const T h = T(1) / T(puntos.size() - 1);
    const V a = -V(g[0]) + T(3) * V(g[1]) - T(3) * V(g[2]) + V(g[3]),
            b = T(3) * V(g[0]) - T(6) * V(g[1]) + T(3) * V(g[2]), c = T(3) * (V(g[1]) - V(g[0]));
    V q(g[0]), d1 = h * (c + h * (b + h * a)), d2 = h * h * (T(2) * b + T(6) * h * a),
               d3 = T(6) * h * h * h * a;
    for (glm::vec3 &p : puntos) {
        p = glm::vec3(q);
        q += d1;
        d1 += d2;
        d2 += d3;
    }
}

// Los puntos que calcula un vertex shader, leídos por transform feedback; no se dibuja nada.
class EnShader {
public:
    explicit EnShader(std::size_t n) : cuantos(GLsizei(n)) {
        abreContexto();
        programa = creaPrograma("herramientas/mide/bezier.vert", "common/liso.frag");
        const char *salida = "punto";
        glTransformFeedbackVaryings(programa, 1, &salida, GL_INTERLEAVED_ATTRIBS);
        glLinkProgram(programa);
        glUseProgram(programa);
        glUniform3fv(glGetUniformLocation(programa, "G"), 4, &G[0].x);
        envia(programa, "ultimo", float(n - 1));
        glGenBuffers(1, &bufer);
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, bufer);
        glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, cuantos * GLsizei(sizeof(glm::vec3)), nullptr,
                     GL_STREAM_COPY);
        glEnable(GL_RASTERIZER_DISCARD);
    }
    void evalua() const {
        glBeginTransformFeedback(GL_POINTS);
        glDrawArrays(GL_POINTS, 0, cuantos);
        glEndTransformFeedback();
        glFinish();
    }
    void lee(std::vector<glm::vec3> &puntos) const {
        glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, cuantos * GLsizei(sizeof(glm::vec3)),
                           puntos.data());
    }

private:
    GLsizei cuantos;
    GLuint programa = 0, bufer = 0;
};

static void mideCubicas(Medidor &m) {
    const std::size_t n = m.elige<std::size_t>(65, 16385);
    std::vector<glm::vec3> puntos(n);
    const auto u = [&](std::size_t i) { return float(i) / float(n - 1); };
    const auto variante = [&](const char *nombre, const std::function<void()> &todos, const char *nota = "",
                              const std::function<void()> &lee = {}) {
        todos();
        if (lee)
            lee();
        double error = 0;
        for (std::size_t i = 0; i < n; i += 8)
            error = std::max(error, separacion(puntos[i], bezierExacta(G, Cuadruple(i) / Cuadruple(n - 1))));
        m.variante(
            nombre, error, double(n),
            [&] {
                todos();
                usa(puntos.data());
            },
            nota);
    };
    const auto deUnoEnUno = [&](auto Q) {
        return [&, Q] {
            for (std::size_t i = 0; i < n; ++i)
                puntos[i] = Q(u(i));
        };
    };
    const G3 c = coeficientes(G);
    variante("UMG, la matriz en cada punto", deUnoEnUno([](float t) {
                 const G3 k = coeficientes(G);
                 return t * t * t * k[0] + t * t * k[1] + t * k[2] + k[3];
             }),
             "ecuación 11.4 tal cual");
    variante("potencias con Horner",
             deUnoEnUno([&](float t) { return ((t * c[0] + c[1]) * t + c[2]) * t + c[3]; }),
             "M·G, una vez por curva");
    variante("Bernstein", deUnoEnUno([](float t) { return cubica(Base::BEZIER, G, t); }));
    variante("de Casteljau", deUnoEnUno([](float t) { return deCasteljau(G, t); }));
    variante(
        "diferencias en float", [&] { diferencias<float>(G, puntos); },
        "solo para u a pasos iguales; el error crece con el número de puntos");
    variante("diferencias en double", [&] { diferencias<double>(G, puntos); });
    const EnShader gpu(n);
    variante(
        "en el vertex shader", [&] { gpu.evalua(); }, "llvmpipe, con glFinish; sin leerlos",
        [&] { gpu.lee(puntos); });
}

static const Apunta APUNTA(
    {1, "curvas_cubicas", "Un punto de una curva cúbica", "ns por punto",
     "píxeles, frente a cuádruple precisión", "Bernstein",
     "Todas quedan muy por debajo de medio píxel salvo las diferencias en float, que acumulan. Los programas "
     "usan Bernstein factorizado, que no es lo más rápido: da también las derivadas y no resta números casi "
     "iguales.",
     mideCubicas});
