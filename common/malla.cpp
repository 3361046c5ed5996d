#include "malla.h"
#include "error.h"
#include "numero.h"
#include "rutas.h"
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>
#include <sstream>

namespace {

// Punto i de n en la circunferencia unidad; i y i+n dan el mismo valor, bit a bit, y la costura cierra.
glm::vec2 enCirculo(int i, int n) {
    const double a = 2.0 * glm::pi<double>() * (i % n) / n;
    return {std::cos(a), std::sin(a)};
}

// Cuadrícula de n×m cuadrados sobre (s,t) en [0,1]²; los triángulos que se quedan sin área se omiten.
void cuadricula(Malla &malla, int n, int m, const std::function<Vertice(int, int)> &vertice) {
    const unsigned base = unsigned(malla.vertices.size());
    for (int j = 0; j <= m; ++j)
        for (int i = 0; i <= n; ++i)
            malla.vertices.push_back(vertice(i, j));
    auto triangulo = [&](unsigned a, unsigned b, unsigned c) {
        const glm::vec3 &p = malla.vertices[a].posicion, &q = malla.vertices[b].posicion,
                        &r = malla.vertices[c].posicion;
        if (p != q && q != r && r != p)
            malla.indices.insert(malla.indices.end(), {a, b, c});
    };
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i) {
            const unsigned a = base + j * (n + 1) + i;
            const unsigned b = a + n + 1;
            triangulo(a, a + 1, b + 1);
            triangulo(a, b + 1, b);
        }
}

// Disco de radio 1 a la altura z, que mira hacia ±Z según `haciaArriba`.
void tapa(Malla &malla, int n, float z, bool haciaArriba) {
    const glm::vec3 normal(0, 0, haciaArriba ? 1 : -1);
    const unsigned centro = unsigned(malla.vertices.size());
    malla.vertices.push_back({{0, 0, z}, normal, {0.5f, 0.5f}});
    for (int i = 0; i <= n; ++i) {
        const glm::vec2 c = enCirculo(i, n);
        malla.vertices.push_back({{c, z}, normal, 0.5f + 0.5f * c});
    }
    for (unsigned i = centro + 1; i <= centro + n; ++i)
        malla.indices.insert(malla.indices.end(), {centro, haciaArriba ? i : i + 1, haciaArriba ? i + 1 : i});
}

} // namespace

Malla cubo() {
    Malla malla;
    for (int eje = 0; eje < 3; ++eje)
        for (float lado : {-0.5f, 0.5f}) {
            // u, v, n: base a derechas con n hacia fuera, para que la cara gire en sentido antihorario
            glm::vec3 n(0), u(0), v(0);
            n[eje] = 2 * lado;
            u[(eje + 1) % 3] = 1;
            v[(eje + 2) % 3] = 2 * lado;
            const unsigned base = unsigned(malla.vertices.size());
            for (const glm::vec2 st : {glm::vec2(0, 0), {1, 0}, {1, 1}, {0, 1}})
                malla.vertices.push_back({0.5f * n + (st.s - 0.5f) * u + (st.t - 0.5f) * v, n, st});
            malla.indices.insert(malla.indices.end(), {base, base + 1, base + 2, base, base + 2, base + 3});
        }
    return malla;
}

Malla esfera(int n) {
    n = std::max(n, 3);
    const int m = std::max(n / 2, 2);
    Malla malla;
    cuadricula(malla, n, m, [&](int i, int j) {
        // colatitud desde el polo sur; en los polos el radio es 0 exacto y la malla cierra
        const double a = glm::pi<double>() * j / m;
        const float radio = j == 0 || j == m ? 0.0f : float(std::sin(a));
        const glm::vec3 p(enCirculo(i, n) * radio, -std::cos(a));
        return Vertice{p, p, {float(i) / float(n), float(j) / float(m)}};
    });
    return malla;
}

Malla cilindro(int n) {
    n = std::max(n, 3);
    Malla malla;
    cuadricula(malla, n, 1, [&](int i, int j) {
        const glm::vec2 c = enCirculo(i, n);
        return Vertice{{c, float(j) - 0.5f}, {c, 0}, {float(i) / float(n), j}};
    });
    tapa(malla, n, 0.5f, true);
    tapa(malla, n, -0.5f, false);
    return malla;
}

Malla cono(int n) {
    n = std::max(n, 3);
    Malla malla;
    cuadricula(malla, n, 1, [&](int i, int j) {
        // la normal de la generatriz que baja 1 y sale 1 sube 45 grados
        const glm::vec2 c = enCirculo(i, n);
        return Vertice{{c * float(1 - j), j},
                       glm::vec3(c, 1) * glm::one_over_root_two<float>(),
                       {float(i) / float(n), j}};
    });
    tapa(malla, n, 0, false);
    return malla;
}

Malla toro(float radio, float radioTubo, int n, int m) {
    n = std::max(n, 3);
    m = std::max(m, 3);
    Malla malla;
    cuadricula(malla, n, m, [&](int i, int j) {
        const glm::vec2 anillo = enCirculo(i, n), tubo = enCirculo(j, m);
        const glm::vec3 normal(anillo * tubo.x, tubo.y);
        return Vertice{glm::vec3(anillo * radio, 0) + radioTubo * normal,
                       normal,
                       {float(i) / float(n), float(j) / float(m)}};
    });
    return malla;
}

Malla plano(int n) {
    n = std::max(n, 1);
    Malla malla;
    cuadricula(malla, n, n, [&](int i, int j) {
        const glm::vec2 st = glm::vec2(i, j) / float(n);
        return Vertice{{st - 0.5f, 0}, {0, 0, 1}, st};
    });
    return malla;
}

void Queja::operator()(const std::string &seEsperaba) const {
    falla(donde + ": " + seEsperaba + " — «" + linea + "»");
}

void leeLineas(const std::string &fichero, const std::string &nombre,
               const std::function<void(const std::string &, std::istream &, const Queja &)> &linea) {
    std::string leido, entera, tipo, error;
    if (!intentaTexto(fichero, leido, error))
        falla(error);
    std::istringstream texto(leido);
    for (int numero = 1; std::getline(texto, entera); ++numero) {
        std::istringstream palabras(entera.substr(0, entera.find('#')));
        if (palabras >> tipo)
            linea(tipo, palabras, {nombre + ":" + std::to_string(numero), entera});
    }
}

std::optional<glm::dvec3> leePunto(std::istream &linea) {
    glm::dvec3 p;
    std::string palabra;
    for (int i = 0; i < 3; ++i) {
        const std::optional<double> x = linea >> palabra ? numeroDe<double>(palabra) : std::nullopt;
        if (!x || !(std::fabs(*x) <= double{std::numeric_limits<float>::max()})) // tampoco NaN
            return {};
        p[i] = *x;
    }
    return linea >> palabra ? std::nullopt : std::optional(p);
}

MallaVf leeVf(const std::string &fichero) {
    MallaVf malla;
    leeLineas(fichero, fichero, [&](const std::string &tipo, std::istream &palabras, const Queja &mal) {
        if (tipo == "v") {
            const std::optional<glm::dvec3> p = leePunto(palabras);
            if (!p)
                mal("un vértice son tres números");
            malla.vertices.emplace_back(*p);
        } else if (tipo == "f") {
            std::vector<unsigned> cara;
            const int hay = int(malla.vertices.size());
            for (std::string palabra; palabras >> palabra;) {
                const std::optional<int> n = numeroDe<int>(palabra.substr(0, palabra.find('/')));
                if (!n)
                    mal("«" + palabra + "» no es un número de vértice");
                const int i = *n < 0 ? hay + *n : *n - 1; // los negativos cuentan desde el último
                if (i < 0 || i >= hay)
                    mal("el vértice " + palabra + " no existe: hay " + std::to_string(hay) + ", desde el 1");
                if (std::find(cara.begin(), cara.end(), unsigned(i)) != cara.end())
                    mal("el vértice " + palabra + " está dos veces en la cara");
                cara.push_back(unsigned(i));
            }
            if (cara.size() < 3)
                mal("una cara necesita al menos tres vértices y hay " + std::to_string(cara.size()));
            malla.caras.push_back(cara);
        } else if (std::string(" g l o p s vn vp vt mtllib usemtl ").find(" " + tipo + " ") ==
                   std::string::npos) {
            mal("cada línea empieza por v o por f, o por otra palabra de un OBJ");
        }
    });
    if (malla.caras.empty())
        falla("«" + fichero + "» no tiene ninguna cara");
    return malla;
}

int segmentosPara(float radioPx, float tolerPx) {
    if (!(radioPx > tolerPx))
        return 3;
    // 1 − cos x = 2·sen²(x/2): el arcocoseno de un número casi 1 perdería todas las cifras
    const double n = glm::pi<double>() / (2.0 * std::asin(std::sqrt(0.5 * tolerPx / radioPx)));
    return int(std::clamp(std::ceil(n), 3.0, 1024.0));
}

int segmentosEsfera(float radioPx) {
    const int n = segmentosPara(radioPx, 0.125f);
    return n + n % 2;
}
