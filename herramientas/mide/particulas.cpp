// Un tiro parabólico de muchas partículas: la fórmula en la GPU, o integrar en la CPU y enviar las posiciones.
#include "gpu.h"
#include "shader.h"

using namespace mide;

static const float GRAVEDAD = 5, VIDA = 2, CUADRO = 0.02f; // segundos
static const double PIXELES = 180;                         // por unidad

struct Particula {
    glm::vec3 p, v;
};

static void euler(Particula &q, float h) {
    q.p += h * q.v;
    q.v.y -= h * GRAVEDAD;
}
static void verlet(Particula &q, float h) { // de velocidad: media aceleración antes y media después
    q.v.y -= 0.5f * h * GRAVEDAD;
    q.p += h * q.v;
    q.v.y -= 0.5f * h * GRAVEDAD;
}
using Paso = void (*)(Particula &, float);

// Donde está al cabo de s segundos la que sale del origen con esa velocidad.
static Particula tiro(const glm::vec3 &v, float s) {
    return {s * v - glm::vec3(0, 0.5f * GRAVEDAD * s * s, 0), v - glm::vec3(0, GRAVEDAD * s, 0)};
}

// Los píxeles que se separa alguna, con un paso h, del tiro exacto al final de su vida.
static double desvio(const std::vector<glm::vec3> &velocidades, float h, Paso paso) {
    double error = 0;
    for (std::size_t k = 0; k < 100; ++k) {
        Particula q{glm::vec3(0), velocidades[k]};
        for (long i = std::lround(VIDA / h); i > 0; --i)
            paso(q, h);
        const glm::dvec3 exacta = glm::dvec3(velocidades[k]) * double(VIDA) -
                                  glm::dvec3(0, 0.5 * double(GRAVEDAD) * double(VIDA * VIDA), 0);
        error = std::max(error, PIXELES * glm::length(glm::dvec3(q.p) - exacta));
    }
    return error;
}

// Enviar lo que se dibuja como puntos: cada posición, al principio de un T.
template<class T>
static void envia(const std::vector<T> &datos, GLenum uso) {
    glBufferData(GL_ARRAY_BUFFER, GLsizei(datos.size() * sizeof(T)), datos.data(), uso);
    glVertexAttribPointer(ATRIBUTO_POSICION, 3, GL_FLOAT, GL_FALSE, sizeof(T), nullptr);
}

// Dibuja tantos puntos con ese programa.
using Dibuja = std::function<void(GLuint programa, int cuantas)>;

static void mideIntegradas(Medidor &m, const Dibuja &dibuja, GLuint pelados, Azar &al, int n) {
    std::vector<glm::vec3> velocidades;
    std::vector<Particula> enMarcha; // cada una por donde vaya: que al cronometrar se vea de todo
    for (int i = 0; i < n; ++i) {
        velocidades.push_back({0.4f * al(), 4.5f + 0.5f * al(), 0.4f * al()});
        enMarcha.push_back(tiro(velocidades.back(), 0.8f * (1 + al())));
    }
    const auto variante = [&](const char *nombre, float h, Paso paso) {
        const int porCuadro = std::max(int(std::lround(CUADRO / h)), 1);
        m.variante(formatea("%s, dt = %g ms", nombre, 1000.0 * double(h)),
                   std::to_string(porCuadro) + " pasos por imagen, en la CPU", desvio(velocidades, h, paso),
                   0.01 * n, yEspera([&] {
                       for (int i = 0; i < porCuadro; ++i)
                           for (std::size_t k = 0; k < enMarcha.size(); ++k) {
                               paso(enMarcha[k], h);
                               if (enMarcha[k].p.y < 0) // otra vez al principio: que siempre se vean todas
                                   enMarcha[k] = {glm::vec3(0), velocidades[k]};
                           }
                       envia(enMarcha, GL_STREAM_DRAW);
                       dibuja(pelados, n);
                   }));
    };
    for (const float h : {0.02f, 0.01f, 0.001f})
        variante("Euler", h, euler);
    for (const float h : {0.02f, 0.001f})
        variante("Verlet", h, verlet);
}

// El tiempo llega a la GPU ya reducido a una vida, o crece y crece en un float.
static void mideFormula(Medidor &m, const Dibuja &dibuja, int n, int muchas) {
    const GLuint formula = creaPrograma("herramientas/mide/formula.vert", "common/liso.frag");
    const double CIEN_HORAS = 360000.0 + 1.2345, exacto = std::fmod(CIEN_HORAS, double(VIDA)),
                 reducido = double(float(exacto));
    const auto variante = [&](const char *nombre, const char *nota, double t, int cuantas) {
        const auto y = [](double x) { return 4.5 * x - 0.5 * double(GRAVEDAD) * x * x; };
        glUseProgram(formula);
        envia(formula, "t", float(t));
        m.variante(nombre, nota, std::max(PIXELES * std::fabs(y(t) - y(exacto)), 1e-6), 0.01 * cuantas,
                   yEspera([&] { dibuja(formula, cuantas); }));
    };
    variante("fórmula en la GPU", "a las 100 horas, con el tiempo reducido en double", reducido, n);
    variante("con el tiempo en float, fórmula en la GPU", "a las 100 horas, con el tiempo sin reducir",
             std::fmod(double(float(CIEN_HORAS)), double(VIDA)), n);
    m.grupo = "un millón";
    variante("un millón, fórmula en la GPU", "por cada cien partículas, como las demás", reducido, muchas);
}

static void mideParticulas(Medidor &m) {
    const Framebuffer framebuffer(m.elige(96, 960), m.elige(72, 720));
    const int n = m.elige(100, 100000), muchas = m.elige(1000, 1000000);
    const GLuint pelados = creaPrograma("herramientas/mide/puntos.vert", "common/liso.frag");
    GLuint bufer;
    glGenBuffers(1, &bufer);
    glBindBuffer(GL_ARRAY_BUFFER, bufer);
    glEnableVertexAttribArray(ATRIBUTO_POSICION);
    const Dibuja dibuja = [&](GLuint programa, int cuantas) {
        framebuffer.borra({0, 0, 0});
        glUseProgram(programa);
        glDrawArrays(GL_POINTS, 0, cuantas);
    };
    Azar al(3);
    mideIntegradas(m, dibuja, pelados, al, n);
    mideFormula(m, dibuja, n, muchas);
    std::vector<glm::vec3> quietas;
    for (int i = 0; i < muchas; ++i)
        quietas.push_back({al(), al(), 0});
    envia(quietas, GL_STATIC_DRAW);
    m.variante("suelo: un millón de puntos quietos", "lo menos que puede costar", NAN, 0.01 * muchas,
               yEspera([&] { dibuja(pelados, muchas); }));
}

static const Apunta APUNTA({19, "particulas", "Partículas", "µs por cada cien partículas dibujadas",
                            "píxeles que se desvían al final de su vida", "fórmula en la GPU",
                            "Con una fórmula no hay paso que elegir ni nada que enviar, y no se desvía nunca "
                            "si el tiempo se reduce en double. Euler se desvía "
                            "en proporción al paso; Verlet acierta un tiro parabólico con cualquiera.",
                            mideParticulas});
