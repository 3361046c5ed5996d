// Pares de superficies casi juntas que el buffer de profundidad confunde, según lejos/cerca y el formato.
#include "ch04_vista3d/profundidad.h"
#include "gpu.h"
#include "shader.h"

using namespace mide;

static const double SEPARACION = 1e-4; // una diezmilésima de la distancia

// Porcentaje de pares mal ordenados con la profundidad que guarda el formato, calculada en float como la GPU. Al
// revés: 1 cerca y 0 lejos, donde un float tiene más cifras.
static double confundidos(double cerca, double lejos, int bits, bool alReves) {
    const int n = 20000;
    int mal = 0;
    for (int i = 0; i < n; ++i) {
        const double d = cerca * std::pow(lejos / cerca, (i + 0.5) / n);
        const auto valor = [&](double x) {
            const auto fd = float(x), fc = float(cerca), fl = float(lejos);
            if (alReves) // z = cerca·(lejos − d)/(d·(lejos − cerca))
                return -double(fc * (fl - fd) / (fl - fc) / fd);
            const float z = profundidad(fd, fc, fl);
            return bits == 32 ? z : enBuffer(z, bits);
        };
        mal += valor(d * (1 + SEPARACION)) <= valor(d);
    }
    return 100.0 * mal / n;
}

static void mideProfundidad(Medidor &m) {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    const GLuint programa = creaPrograma("ch09_imagen/imagen.vert", "common/liso.frag");
    glUseProgram(programa);
    const struct {
        const char *nombre;
        int bits;
        GLenum formato;
        bool alReves;
    } FORMATOS[] = {{"16 bits", 16, GL_DEPTH_COMPONENT16, false},
                    {"24 bits", 24, GL_DEPTH_COMPONENT24, false},
                    {"float", 32, GL_DEPTH_COMPONENT32F, false},
                    {"float al revés", 32, GL_DEPTH_COMPONENT32F, true}};
    const char *const POTENCIA[] = {"", "", "10²", "", "10⁴", "", "10⁶"};
    for (const int cociente : m.elige<std::vector<int>>({2, 6}, {2, 4, 6})) {
        const double lejos = 1000, cerca = lejos / std::pow(10.0, cociente);
        m.grupo = std::string("lejos/cerca = ") + POTENCIA[cociente];
        for (const auto &f : FORMATOS) {
            const Framebuffer framebuffer(m.elige(48, 480), m.elige(36, 360), 0, f.formato);
            m.variante(f.nombre + std::string(", ") + POTENCIA[cociente], "",
                       confundidos(cerca, lejos, f.bits, f.alReves), 1, yEspera([&] {
                           framebuffer.borra({0, 0, 0});
                           for (int i = 0; i < 8; ++i)
                               dibujaRectangulo();
                       }));
        }
    }
}

static const Apunta APUNTA({16, "profundidad", "El buffer de profundidad", "ms por 8 rectángulos de 480×360",
                            "% de pares a 10⁻⁴ de distancia que se confunden", "24 bits, 10²",
                            "Lo que importa es lejos/cerca, y no los bits: los programas lo dejan en 100 o "
                            "menos. Un float solo gana si se le da la vuelta, "
                            "y no tarda más, pero con OpenGL 3.1 hay que hacerlo en cada shader.",
                            mideProfundidad});
