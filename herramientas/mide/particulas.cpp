// Un tiro parabólico de muchas partículas: la fórmula en la GPU, o integrar en la CPU y enviar las posiciones.
#include "gpu.h"
#include "mide.h"
#include <random>

using namespace mide;

static const float GRAVEDAD = 5, VIDA = 2, CUADRO = 0.02f; // segundos
static const double PIXELES = 180;                         // por unidad

struct Particula {
    glm::vec3 p, v;
};

static void mideParticulas(Medidor &m) {
    abreContexto();
    glDisable(GL_DEPTH_TEST);
    const Framebuffer framebuffer(m.elige(96, 960), m.elige(72, 720));
    const int n = m.elige(100, 100000), muchas = m.elige(1000, 1000000);
    std::mt19937 azar(3);
    const auto al = [&] { return float(double(azar()) / 2147483648.0 - 1); };
    std::vector<Particula> inicio;
    for (int i = 0; i < n; ++i)
        inicio.push_back({{0, 0, 0}, {0.4f * al(), 4.5f + 0.5f * al(), 0.4f * al()}});

    // puntos pelados: lo menos que cuesta dibujarlas
    const GLuint puntos = creaPrograma("herramientas/mide/puntos.vert", "herramientas/mide/nada.frag"),
                 formula = creaPrograma("herramientas/mide/formula.vert", "herramientas/mide/nada.frag");
    GLuint vao, bufer;
    glGenVertexArrays(1, &vao);
    glBindVertexArray(vao);
    glGenBuffers(1, &bufer);
    glBindBuffer(GL_ARRAY_BUFFER, bufer);
    glEnableVertexAttribArray(ATRIBUTO_POSICION);
    const auto dibujaPuntos = [&](GLuint programa, int cuantas) {
        framebuffer.borra(0, 0, 0);
        glUseProgram(programa);
        glBindVertexArray(vao);
        glDrawArrays(GL_POINTS, 0, cuantas);
    };
    // con un paso h, lo que se separa del tiro exacto al final de su vida, con velocidad −v en el suelo
    const auto variante = [&](const char *nombre, float h, const auto &paso, const Rango &espera) {
        std::vector<Particula> p = inicio;
        const int pasos = int(std::lround(VIDA / h)), porCuadro = std::max(int(std::lround(CUADRO / h)), 1);
        for (Particula &q : p)
            for (int i = 0; i < (&q - p.data() < 100 ? pasos : 0); ++i)
                paso(q, h);
        double error = 0;
        for (std::size_t i = 0; i < 100; ++i) {
            const glm::dvec3 v(inicio[i].v),
                exacta = v * double(VIDA) - glm::dvec3(0, 0.5 * double(GRAVEDAD) * double(VIDA * VIDA), 0);
            error = std::max(error, PIXELES * glm::length(glm::dvec3(p[i].p) - exacta));
        }
        p = inicio; // para cronometrar, cada una por donde vaya
        for (Particula &q : p) {
            const float s = 0.8f * (1 + al());
            q.p = s * q.v - glm::vec3(0, 0.5f * GRAVEDAD * s * s, 0);
            q.v.y -= GRAVEDAD * s;
        }
        char texto[60];
        std::snprintf(texto, sizeof texto, "%s, dt = %g ms", nombre, 1000.0 * double(h));
        m.variante(
            texto, error, 0.01 * n, yEspera([&] {
                for (int i = 0; i < porCuadro; ++i)
                    for (std::size_t k = 0; k < p.size(); ++k) {
                        paso(p[k], h);
                        if (p[k].p.y < 0) // otra vez al principio: que siempre se vean todas
                            p[k] = inicio[k];
                    }
                glBindBuffer(GL_ARRAY_BUFFER, bufer);
                glBufferData(GL_ARRAY_BUFFER, n * GLsizei(sizeof(Particula)), p.data(), GL_STREAM_DRAW);
                glBindVertexArray(vao);
                glVertexAttribPointer(ATRIBUTO_POSICION, 3, GL_FLOAT, GL_FALSE, sizeof(Particula), nullptr);
                dibujaPuntos(puntos, n);
            }),
            espera, std::to_string(porCuadro) + " pasos por imagen, en la CPU");
    };
    const auto euler = [](Particula &q, float h) {
        q.p += h * q.v;
        q.v.y -= h * GRAVEDAD;
    };
    const auto verlet = [](Particula &q, float h) { // de velocidad: media aceleración antes y media después
        q.v.y -= 0.5f * h * GRAVEDAD;
        q.p += h * q.v;
        q.v.y -= 0.5f * h * GRAVEDAD;
    };
    for (const float h : {0.02f, 0.01f, 0.001f}) { // a cada paso le falta g·h²/2
        const double falta = 0.5 * double(GRAVEDAD) * double(VIDA) * double(h) * PIXELES;
        variante("Euler", h, euler, {0.9 * falta, 1.1 * falta});
    }
    for (const float h : {0.02f, 0.001f})
        variante("Verlet", h, verlet, {0, 0.1});

    // en la GPU: el tiempo llega ya reducido a una vida, o crece y crece en un float
    const auto conFormula = [&](const char *nombre, double t, bool reducido, int cuantas, const Rango &espera,
                                const char *nota) {
        const double exacta = std::fmod(t, double(VIDA)),
                     s = reducido ? float(exacta) : std::fmod(double(float(t)), double(VIDA));
        const auto y = [](double x) { return 4.5 * x - 0.5 * double(GRAVEDAD) * x * x; };
        glUseProgram(formula);
        envia(formula, "t", float(s));
        m.variante(nombre, std::max(PIXELES * std::fabs(y(s) - y(exacta)), 1e-6), 0.01 * cuantas,
                   yEspera([&] { dibujaPuntos(formula, cuantas); }), espera, nota);
    };
    const double CIEN_HORAS = 360000.0 + 1.2345;
    conFormula("fórmula en la GPU", CIEN_HORAS, true, n, {0, 0.01},
               "a las 100 horas, con el tiempo reducido en double");
    conFormula("con el tiempo en float, fórmula en la GPU", CIEN_HORAS, false, n, {0.5, 1000},
               "a las 100 horas, con el tiempo sin reducir");
    m.grupo = "un millón";
    conFormula("un millón, fórmula en la GPU", CIEN_HORAS, true, muchas, {0, 0.01},
               "por cada cien partículas, como las demás");
    std::vector<glm::vec3> quietas;
    for (int i = 0; i < muchas; ++i)
        quietas.push_back({al(), al(), 0});
    glBindBuffer(GL_ARRAY_BUFFER, bufer);
    glBufferData(GL_ARRAY_BUFFER, muchas * GLsizei(sizeof(glm::vec3)), quietas.data(), GL_STATIC_DRAW);
    glBindVertexArray(vao);
    glVertexAttribPointer(ATRIBUTO_POSICION, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    m.variante("suelo: un millón de puntos quietos", NAN, 0.01 * muchas,
               yEspera([&] { dibujaPuntos(puntos, muchas); }), CUALQUIERA, "lo menos que puede costar");
}

static const Apunta APUNTA({19, "particulas", "Partículas", "µs por cada cien partículas dibujadas",
                            "píxeles que se desvían al final de su vida", "fórmula en la GPU",
                            "Con una fórmula no hay paso que elegir ni nada que enviar, y no se desvía nunca "
                            "si el tiempo se reduce en double. Euler se desvía "
                            "en proporción al paso; Verlet acierta un tiro parabólico con cualquiera.",
                            mideParticulas});
