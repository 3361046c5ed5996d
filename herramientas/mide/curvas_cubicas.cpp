// Un punto de una cúbica de Bézier: la matriz del libro, Bernstein, de Casteljau, diferencias o el vertex shader.
#include "ch11_curvas/curvas.h"
#include "gpu.h"
#include "mide.h"
#include "shader.h"

using namespace mide;

using G3 = Geometria<float>;

// En píxeles de una ventana de 1080 líneas; lejos del origen, como en una escena grande.
static const G3 G = {glm::vec3(1010, 2040, 15), {1330, 3010, -250}, {1720, 1500, 410}, {2030, 2080, 70}};

// M·G (ecuación 11.18): los coeficientes de u³, u², u y 1.
template<class T>
static Geometria<T> coeficientes() {
    const std::array<glm::vec<3, T>, 4> g = {G[0], G[1], G[2], G[3]};
    return {-g[0] + T(3) * g[1] - T(3) * g[2] + g[3], T(3) * g[0] - T(6) * g[1] + T(3) * g[2],
            T(3) * (g[1] - g[0]), g[0]};
}

static glm::vec3 deCasteljau(const G3 &g, float u) {
    const float c = 1 - u;
    const glm::vec3 a = c * g[0] + u * g[1], b = c * g[1] + u * g[2], d = c * g[2] + u * g[3];
    return c * (c * a + u * b) + u * (c * b + u * d);
}

// Todos los puntos, sumando: tres sumas por punto, pero cada error se arrastra al siguiente.
template<class T>
static void diferencias(std::vector<glm::vec3> &puntos) {
    const T h = T(1) / T(puntos.size() - 1);
    const auto [a, b, c, primero] = coeficientes<T>();
    glm::vec<3, T> q = primero, d1 = h * (c + h * (b + h * a)), d2 = h * h * (T(2) * b + T(6) * h * a),
                   d3 = T(6) * h * h * h * a;
    for (glm::vec3 &p : puntos) {
        p = glm::vec3(q);
        q += d1;
        d1 += d2;
        d2 += d3;
    }
}

// El vertex shader que los calcula, y que los deja en un buffer por transform feedback; no se dibuja nada.
static void usaShader(std::size_t n) {
    const GLuint programa = creaPrograma("herramientas/mide/bezier.vert", "common/liso.frag");
    const char *salida = "punto";
    glTransformFeedbackVaryings(programa, 1, &salida, GL_INTERLEAVED_ATTRIBS);
    glLinkProgram(programa);
    glUseProgram(programa);
    glUniform3fv(uniforme(programa, "G"), 4, &G[0].x);
    envia(programa, "ultimo", float(n - 1));
    GLuint bufer;
    glGenBuffers(1, &bufer);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, bufer);
    glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, GLsizei(n * sizeof(glm::vec3)), nullptr, GL_STREAM_COPY);
    glEnable(GL_RASTERIZER_DISCARD);
}

static void mideCubicas(Medidor &m) {
    const std::size_t n = m.elige<std::size_t>(65, 16385);
    std::vector<glm::vec3> puntos(n);
    const std::vector<Punto<long double>> exacta(G.begin(), G.end());
    const auto variante = [&](
                              const char *nombre, const char *nota, const std::function<void()> &todos,
                              const std::function<void()> &lee = [] {}) {
        todos();
        lee();
        double error = 0;
        for (std::size_t i = 0; i < n; i += 8) {
            const auto u = static_cast<long double>(i) / static_cast<long double>(n - 1);
            error = std::max(error, double(glm::length(Punto<long double>(puntos[i]) - bezier(exacta, u))));
        }
        m.variante(nombre, nota, error, double(n), [&] {
            todos();
            usa(puntos.data());
        });
    };
    const auto deUnoEnUno = [&](const char *nombre, const char *nota, const auto &Q) {
        variante(nombre, nota, [&] {
            for (std::size_t i = 0; i < n; ++i)
                puntos[i] = Q(float(i) / float(n - 1));
        });
    };
    const G3 c = coeficientes<float>();
    deUnoEnUno("UMG, la matriz en cada punto", "ecuación 11.4 tal cual", [](float t) {
        const G3 k = coeficientes<float>();
        return t * t * t * k[0] + t * t * k[1] + t * k[2] + k[3];
    });
    deUnoEnUno("potencias con Horner", "M·G, una vez por curva",
               [&](float t) { return ((t * c[0] + c[1]) * t + c[2]) * t + c[3]; });
    deUnoEnUno("Bernstein", "", [](float t) { return cubica(Base::BEZIER, G, t); });
    deUnoEnUno("de Casteljau", "", [](float t) { return deCasteljau(G, t); });
    variante("diferencias en float", "solo para u a pasos iguales; el error crece con el número de puntos",
             [&] { diferencias<float>(puntos); });
    variante("diferencias en double", "", [&] { diferencias<double>(puntos); });
    usaShader(n);
    variante(
        "en el vertex shader", "llvmpipe, con glFinish; sin leerlos",
        [&] {
            glBeginTransformFeedback(GL_POINTS);
            glDrawArrays(GL_POINTS, 0, GLsizei(n));
            glEndTransformFeedback();
            glFinish();
        },
        [&] {
            glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, GLsizei(n * sizeof(glm::vec3)),
                               puntos.data());
        });
}

static const Apunta APUNTA(
    {1, "curvas_cubicas", "Un punto de una curva cúbica", "ns por punto", "píxeles, frente a doble extendida",
     "Bernstein",
     "Todas quedan muy por debajo de medio píxel salvo las diferencias en float, que acumulan. Los programas "
     "usan Bernstein factorizado, que no es lo más rápido: da también las derivadas y no resta números casi "
     "iguales.",
     mideCubicas});
