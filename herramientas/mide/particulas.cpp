// Un tiro parabólico de muchas partículas: la fórmula en la GPU, o integrar en la CPU y enviar las posiciones.
#include "gpu.h"
#include "shader.h"

using namespace mide;

static const float GRAVEDAD = 5, VIDA = 2, CUADRO = 0.02f; // segundos
static const double PIXELES = 180;                         // por unidad

struct Particula {
    glm::vec3 p, v;
};

static std::vector<Particula> alNacer(Azar &al, int cuantas) {
    std::vector<Particula> p;
    for (int i = 0; i < cuantas; ++i)
        p.push_back({{0, 0, 0}, {0.4f * al(), 4.5f + 0.5f * al(), 0.4f * al()}});
    return p;
}

// Cada una por donde vaya: que al cronometrar se vea de todo.
static std::vector<Particula> enMarcha(Azar &al, std::vector<Particula> p) {
    for (Particula &q : p) {
        const float s = 0.8f * (1 + al());
        q.p = s * q.v - glm::vec3(0, 0.5f * GRAVEDAD * s * s, 0);
        q.v.y -= GRAVEDAD * s;
    }
    return p;
}

static const auto EULER = [](Particula &q, float h) {
    q.p += h * q.v;
    q.v.y -= h * GRAVEDAD;
};
static const auto VERLET = [](Particula &q,
                              float h) { // de velocidad: media aceleración antes y media después
    q.v.y -= 0.5f * h * GRAVEDAD;
    q.p += h * q.v;
    q.v.y -= 0.5f * h * GRAVEDAD;
};

// Los píxeles que se separa alguna, con un paso h, del tiro exacto al final de su vida.
template<class Paso>
static double desvio(const std::vector<Particula> &inicio, float h, const Paso &paso) {
    const int pasos = int(std::lround(VIDA / h));
    double error = 0;
    for (std::size_t k = 0; k < 100; ++k) {
        Particula q = inicio[k];
        for (int i = 0; i < pasos; ++i)
            paso(q, h);
        const glm::dvec3 exacta = glm::dvec3(inicio[k].v) * double(VIDA) -
                                  glm::dvec3(0, 0.5 * double(GRAVEDAD) * double(VIDA * VIDA), 0);
        error = std::max(error, PIXELES * glm::length(glm::dvec3(q.p) - exacta));
    }
    return error;
}

// Las partículas, dibujadas como puntos.
class Puntos {
    const Framebuffer &framebuffer;
    GLuint vao = 0, bufer = 0;

public:
    explicit Puntos(const Framebuffer &donde) : framebuffer(donde) {
        glGenVertexArrays(1, &vao);
        glBindVertexArray(vao);
        glGenBuffers(1, &bufer);
        glBindBuffer(GL_ARRAY_BUFFER, bufer);
        glEnableVertexAttribArray(ATRIBUTO_POSICION);
    }
    // Cada posición, al principio de un T.
    template<class T>
    void envia(const std::vector<T> &datos, GLenum uso) const {
        glBindBuffer(GL_ARRAY_BUFFER, bufer);
        glBufferData(GL_ARRAY_BUFFER, GLsizei(datos.size() * sizeof(T)), datos.data(), uso);
        glBindVertexArray(vao);
        glVertexAttribPointer(ATRIBUTO_POSICION, 3, GL_FLOAT, GL_FALSE, sizeof(T), nullptr);
    }
    void dibuja(GLuint programa, int cuantos) const {
        framebuffer.borra({0, 0, 0});
        glUseProgram(programa);
        glBindVertexArray(vao);
        glDrawArrays(GL_POINTS, 0, cuantos);
    }
};

// Integrar en la CPU y enviar las posiciones.
static void mideIntegradas(Medidor &m, Azar &al, const Puntos &puntos, GLuint pelados,
                           const std::vector<Particula> &inicio) {
    const int n = int(inicio.size());
    const auto variante = [&](const char *nombre, float h, const auto &paso) {
        const int porCuadro = std::max(int(std::lround(CUADRO / h)), 1);
        std::vector<Particula> p = enMarcha(al, inicio);
        m.variante(formatea("%s, dt = %g ms", nombre, 1000.0 * double(h)), desvio(inicio, h, paso), 0.01 * n,
                   yEspera([&] {
                       for (int i = 0; i < porCuadro; ++i)
                           for (std::size_t k = 0; k < p.size(); ++k) {
                               paso(p[k], h);
                               if (p[k].p.y < 0) // otra vez al principio: que siempre se vean todas
                                   p[k] = inicio[k];
                           }
                       puntos.envia(p, GL_STREAM_DRAW);
                       puntos.dibuja(pelados, n);
                   }),
                   std::to_string(porCuadro) + " pasos por imagen, en la CPU");
    };
    for (const float h : {0.02f, 0.01f, 0.001f})
        variante("Euler", h, EULER);
    for (const float h : {0.02f, 0.001f})
        variante("Verlet", h, VERLET);
}

// La fórmula en la GPU: el tiempo llega ya reducido a una vida, o crece y crece en un float.
static void mideFormula(Medidor &m, const Puntos &puntos, int n, int muchas) {
    const double CIEN_HORAS = 360000.0 + 1.2345, exacta = std::fmod(CIEN_HORAS, double(VIDA)),
                 sinReducir = std::fmod(double(float(CIEN_HORAS)), double(VIDA));
    const GLuint formula = creaPrograma("herramientas/mide/formula.vert", "common/liso.frag");
    const auto variante = [&](const char *nombre, double t, int cuantas, const char *nota) {
        const auto y = [](double x) { return 4.5 * x - 0.5 * double(GRAVEDAD) * x * x; };
        glUseProgram(formula);
        envia(formula, "t", float(t));
        m.variante(nombre, std::max(PIXELES * std::fabs(y(t) - y(exacta)), 1e-6), 0.01 * cuantas,
                   yEspera([&] { puntos.dibuja(formula, cuantas); }), nota);
    };
    const double reducido = double(float(exacta));
    variante("fórmula en la GPU", reducido, n, "a las 100 horas, con el tiempo reducido en double");
    variante("con el tiempo en float, fórmula en la GPU", sinReducir, n,
             "a las 100 horas, con el tiempo sin reducir");
    m.grupo = "un millón";
    variante("un millón, fórmula en la GPU", reducido, muchas, "por cada cien partículas, como las demás");
}

static void mideParticulas(Medidor &m) {
    abreContexto();
    glDisable(GL_DEPTH_TEST);
    const Framebuffer framebuffer(m.elige(96, 960), m.elige(72, 720));
    const int n = m.elige(100, 100000), muchas = m.elige(1000, 1000000);
    const GLuint pelados = creaPrograma("herramientas/mide/puntos.vert", "common/liso.frag");
    const Puntos puntos(framebuffer);
    Azar al(3);
    mideIntegradas(m, al, puntos, pelados, alNacer(al, n));
    mideFormula(m, puntos, n, muchas);
    std::vector<glm::vec3> quietas;
    for (int i = 0; i < muchas; ++i)
        quietas.push_back({al(), al(), 0});
    puntos.envia(quietas, GL_STATIC_DRAW);
    m.variante("suelo: un millón de puntos quietos", NAN, 0.01 * muchas,
               yEspera([&] { puntos.dibuja(pelados, muchas); }), "lo menos que puede costar");
}

static const Apunta APUNTA({19, "particulas", "Partículas", "µs por cada cien partículas dibujadas",
                            "píxeles que se desvían al final de su vida", "fórmula en la GPU",
                            "Con una fórmula no hay paso que elegir ni nada que enviar, y no se desvía nunca "
                            "si el tiempo se reduce en double. Euler se desvía "
                            "en proporción al paso; Verlet acierta un tiro parabólico con cualquiera.",
                            mideParticulas});
