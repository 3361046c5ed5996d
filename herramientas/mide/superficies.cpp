// Los parches de la tetera en triángulos, con la tetera a 700 píxeles de ancho.
#include "ch02_modelado/bezier.h"
#include "mide.h"
#ifdef LAB_PAR_GLU
#include "glu.h"
#endif

using namespace mide;

static const double PIXEL = 1 / 110.0; // la tetera mide 6.4 unidades

// La malla de un parche con esa división: los mismos puntos que teselaParches.
static void tesela(const Parche &q, const Division &d, std::vector<Vertice> &vertices) {
    for (int j = 0; j <= d.nv; ++j)
        for (int i = 0; i <= d.nu; ++i) {
            const double u = double(i) / d.nu, v = double(j) / d.nv;
            vertices.push_back({parche::posicion(q, parche::pesos0(u, 1 - u), parche::pesos0(v, 1 - v)),
                                parche::normal(q, u, v),
                                {u, v}});
        }
}

// Lo más que se separan, en píxeles, los triángulos de una división del punto de la superficie de la misma (u, v): en
// los lados y en el centro de cada triángulo.
static double error(const Parche &q, const Division &d) {
    const auto punto = [&](double u, double v) {
        return parche::posicion(q, parche::pesos0(u, 1 - u), parche::pesos0(v, 1 - v));
    };
    const double hu = 1.0 / d.nu, hv = 1.0 / d.nv;
    double mayor = 0;
    for (int j = 0; j < d.nv; ++j)
        for (int i = 0; i < d.nu; ++i) {
            const glm::dvec2 a(i * hu, j * hv), b(a.x + hu, a.y), c(a.x + hu, a.y + hv), e(a.x, a.y + hv);
            for (const auto &[x, y, z] : {std::array{a, b, c}, {a, c, e}})
                for (const glm::dvec3 w :
                     {glm::dvec3(.5, .5, 0), {0, .5, .5}, {.5, 0, .5}, glm::dvec3(1 / 3.0)}) {
                    const glm::dvec2 uv = w.x * x + w.y * y + w.z * z;
                    mayor = std::max(mayor, glm::length(punto(uv.x, uv.y) - w.x * punto(x.x, x.y) -
                                                        w.y * punto(y.x, y.y) - w.z * punto(z.x, z.y)));
                }
        }
    return mayor / PIXEL;
}

static void mideSuperficies(Medidor &m) {
    const std::vector<Parche> parches = leeParches("assets/tetera.txt");
    const auto variante = [&](const std::string &nombre, const std::vector<Division> &d,
                              const std::function<void()> &trabajo) {
        double mayor = 0;
        int triangulos = 0;
        for (std::size_t k = 0; k < parches.size(); ++k) {
            mayor = std::max(mayor, error(parches[k], d[k]));
            triangulos += 2 * d[k].nu * d[k].nv;
        }
        m.variante(nombre, mayor, 1, trabajo, std::to_string(triangulos) + " triángulos");
    };
    const auto sueltos = [&](const std::vector<Division> &d) {
        std::vector<Vertice> vertices;
        for (std::size_t k = 0; k < parches.size(); ++k)
            tesela(parches[k], d[k], vertices);
        usa(vertices.data());
    };
    for (const int n : m.elige<std::vector<int>>({4, 8}, {4, 8, 16, 32, 64})) {
        const std::vector<Division> d(parches.size(), {n, n});
        variante(std::to_string(n) + "×" + std::to_string(n), d, [&] { sueltos(d); });
    }
    const auto cadaUno = [&](double tolerancia) {
        std::vector<Division> d;
        for (const Parche &q : parches)
            d.push_back(divisionPara(q, tolerancia * PIXEL));
        return d;
    };
    variante("cota de cada parche, 0.5 px", cadaUno(0.5), [&] { sueltos(cadaUno(0.5)); });
    for (const double t : {0.5, 0.1})
        variante("cota de la tira, " + std::string(t < 0.3 ? "0.1" : "0.5") + " px",
                 divisionesPara(parches, t * PIXEL), [&] { usa(teselaParches(parches, t * PIXEL)); });
#ifdef LAB_PAR_GLU
    mideGlu(m, parches, PIXEL, 0.5f, "par: GLU, pidiendo 0.5 px");
    mideGlu(m, parches, PIXEL, m.elige(0.5f, 0.04f), "par: GLU, pidiendo 0.04 px");
#endif
}

static const Apunta
    APUNTA({4, "superficies", "Superficies bicúbicas en triángulos", "ms por tetera",
            "píxeles que se separan los triángulos de la superficie", "cota de la tira, 0.5 px",
            "Con la cota de cada parche bastan menos triángulos, pero los vecinos no casan y se ven grietas: "
            "tetera da a toda la tira la división mayor.",
            mideSuperficies});
