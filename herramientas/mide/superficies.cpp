// Los parches de la tetera en triángulos, con la tetera a 700 píxeles de ancho.
#include "ch02_modelado/bezier.h"
#include "mide.h"
#ifdef LAB_PAR_GLU
#include "glu.h"
#endif

using namespace mide;

static const double PIXEL = 1 / 110.0; // la tetera mide 6.4 unidades

static glm::dvec3 punto(const Parche &q, const glm::dvec2 &uv) {
    return parche::posicion(q, parche::pesos0(uv.x, 1 - uv.x), parche::pesos0(uv.y, 1 - uv.y));
}

// Los vértices de un parche con esa división: los mismos que hace teselaParches.
static void tesela(const Parche &q, const Division &d, std::vector<Vertice> &vertices) {
    for (int j = 0; j <= d.nv; ++j)
        for (int i = 0; i <= d.nu; ++i) {
            const glm::dvec2 uv(double(i) / d.nu, double(j) / d.nv);
            vertices.push_back({punto(q, uv), parche::normal(q, uv.x, uv.y), uv});
        }
}

// Lo más que se separa, en píxeles, un triángulo del punto de la superficie de la misma (u, v): en los lados y en el
// centro.
static double separa(const Parche &q, const std::array<glm::dvec2, 3> &uv,
                     const std::array<glm::dvec3, 3> &p) {
    double mayor = 0;
    for (const glm::dvec3 w : {glm::dvec3(.5, .5, 0), {0, .5, .5}, {.5, 0, .5}, glm::dvec3(1 / 3.0)})
        mayor = std::max(mayor, glm::length(punto(q, w.x * uv[0] + w.y * uv[1] + w.z * uv[2]) -
                                            (w.x * p[0] + w.y * p[1] + w.z * p[2])));
    return mayor / PIXEL;
}

static double error(const Parche &q, const Division &d) {
    const double hu = 1.0 / d.nu, hv = 1.0 / d.nv;
    double mayor = 0;
    for (int j = 0; j < d.nv; ++j)
        for (int i = 0; i < d.nu; ++i) {
            const glm::dvec2 a(i * hu, j * hv), b(a.x + hu, a.y), c(a.x + hu, a.y + hv), e(a.x, a.y + hv);
            for (const auto &uv : {std::array{a, b, c}, {a, c, e}})
                mayor = std::max(mayor, separa(q, uv, {punto(q, uv[0]), punto(q, uv[1]), punto(q, uv[2])}));
        }
    return mayor;
}

#ifdef LAB_PAR_GLU
static void mideGlu(Medidor &m, const std::vector<Parche> &parches, float tolerancia) {
    double mayor = 0;
    const Recogido r = teselaGlu(parches, PIXEL, tolerancia);
    for (const auto &[cual, t] : r.triangulos)
        mayor = std::max(mayor, separa(parches[cual], {t[0].uv, t[1].uv, t[2].uv}, {t[0].p, t[1].p, t[2].p}));
    m.variante(formatea("par: GLU, pidiendo %g px", double(tolerancia)),
               std::to_string(r.triangulos.size()) + " triángulos", mayor, 1,
               [&] { usa(teselaGlu(parches, PIXEL, tolerancia).triangulos.data()); });
}
#endif

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
        m.variante(nombre, std::to_string(triangulos) + " triángulos", mayor, 1, trabajo);
    };
    const auto sueltos = [&](const std::vector<Division> &d) {
        std::vector<Vertice> vertices;
        for (std::size_t k = 0; k < parches.size(); ++k)
            tesela(parches[k], d[k], vertices);
        usa(vertices.data());
    };
    for (const int n : m.elige<std::vector<int>>({4, 8}, {4, 8, 16, 32, 64})) {
        const std::vector<Division> d(parches.size(), {n, n});
        variante(formatea("%d×%d", n, n), d, [&] { sueltos(d); });
    }
    const auto cadaUno = [&] {
        std::vector<Division> d;
        for (const Parche &q : parches)
            d.push_back(divisionPara(q, 0.5 * PIXEL));
        return d;
    };
    variante("cota de cada parche, 0.5 px", cadaUno(), [&] { sueltos(cadaUno()); });
    for (const double t : {0.5, 0.1})
        variante(formatea("cota de la tira, %g px", t), divisionesPara(parches, t * PIXEL),
                 [&] { usa(teselaParches(parches, t * PIXEL)); });
#ifdef LAB_PAR_GLU
    for (const float tolerancia : m.elige<std::vector<float>>({0.5f}, {0.5f, 0.04f}))
        mideGlu(m, parches, tolerancia);
#endif
}

static const Apunta
    APUNTA({4, "superficies", "Superficies bicúbicas en triángulos", "ms por tetera",
            "píxeles que se separan los triángulos de la superficie", "cota de la tira, 0.5 px",
            "Con la cota de cada parche bastan menos triángulos, pero los vecinos no casan y se ven grietas: "
            "tetera da a toda la tira la división mayor.",
            mideSuperficies});
