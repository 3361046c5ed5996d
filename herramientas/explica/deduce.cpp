#include "deduce.h"
#include "json.h"
#include "lexico.h"
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <regex>

namespace explica {
namespace {

using P = std::array<float, 4>;
using V = glm::dvec3;

// El número de cada punto, el mismo si están en el mismo sitio.
std::vector<unsigned> sitiosDe(const Puntos &puntos) {
    std::vector<unsigned> orden(puntos.size()), sitios(puntos.size());
    for (unsigned i = 0; i < orden.size(); ++i)
        orden[i] = i;
    std::sort(orden.begin(), orden.end(), [&](unsigned a, unsigned b) { return puntos[a] < puntos[b]; });
    for (std::size_t k = 1; k < orden.size(); ++k)
        sitios[orden[k]] = sitios[orden[k - 1]] + (puntos[orden[k]] != puntos[orden[k - 1]]);
    return sitios;
}

bool estaCerrado(const Puntos &puntos, const std::vector<unsigned> &triangulos) {
    const std::vector<unsigned> sitios = sitiosDe(puntos);
    std::vector<std::pair<unsigned, unsigned>> van, vuelven;
    for (std::size_t i = 0; i < triangulos.size(); ++i) {
        const unsigned a = sitios[triangulos[i]], b = sitios[triangulos[i % 3 == 2 ? i - 2 : i + 1]];
        if (a != b)
            van.push_back({a, b}), vuelven.push_back({b, a});
    }
    std::sort(van.begin(), van.end());
    std::sort(vuelven.begin(), vuelven.end());
    return !van.empty() && van == vuelven;
}

// El ángulo sólido con que se ve un triángulo desde el origen (Van Oosterom y Strackee, 1983).
double anguloSolido(const V &a, const V &b, const V &c) {
    const double A = glm::length(a), B = glm::length(b), C = glm::length(c);
    return 2 * std::atan2(glm::dot(a, glm::cross(b, c)),
                          A * B * C + glm::dot(a, b) * C + glm::dot(b, c) * A + glm::dot(c, a) * B);
}

} // namespace

Dicho fueraDe(const Puntos &puntos) {
    const auto todos = [&](auto es) {
        return !puntos.empty() && std::all_of(puntos.begin(), puntos.end(), es);
    };
    if (todos([](const P &p) { return !std::isfinite(p[0] + p[1] + p[2] + p[3]); }))
        return {"las posiciones de todos sus vértices son NaN o infinitas",
                "Mira las matrices y lo que se divide."};
    if (todos([](const P &p) { return p[0] == 0 && p[1] == 0 && p[2] == 0; }) ||
        todos([](const P &p) { return p[3] == 0; }))
        return {"gl_Position es 0 en todos sus vértices",
                "¿Se ha enviado cada matriz, y después de glUseProgram?"};
    if (todos([&](const P &p) { return p == puntos[0]; }))
        return {"todos sus vértices caen en el mismo punto",
                "Mira la matriz del modelo y el array de posiciones."};
    if (todos([](const P &p) { return p[3] < 0; }))
        return {"todos sus vértices están detrás de la cámara (w < 0)",
                "Mira la posición de la cámara y hacia dónde mira."};
    const char *const LADOS[3][2] = {{"a la izquierda", "a la derecha"},
                                     {"por debajo", "por encima"},
                                     {"más cerca que cerca", "más lejos que lejos"}};
    for (std::size_t eje = 0; eje < 3; ++eje)
        for (const int lado : {0, 1})
            if (todos([&](const P &p) { return lado ? p[eje] > p[3] : p[eje] < -p[3]; }))
                return {std::string("todos sus vértices quedan fuera, ") + LADOS[eje][lado],
                        eje == 2 ? "Mira los planos cerca y lejos de la proyección."
                                 : "Mira la cámara y la matriz del modelo."};
    return {"ninguna de sus primitivas cubre el centro de un píxel",
            "¿Son muy pequeñas, están fuera de la ventana o los índices no son los suyos?"};
}

Dicho corteDe(const Puntos &puntos) {
    int cerca = 0, lejos = 0, dentro = 0;
    for (const auto &[x, y, z, w] : puntos)
        if (w > 0 && std::fabs(x) <= w && std::fabs(y) <= w)
            ++(z < -w ? cerca : z > w ? lejos : dentro);
    if (!dentro || cerca + lejos == 0)
        return {};
    const auto corta = [&](const char *plano, int cuantos) {
        return "el plano " + std::string(plano) + " la corta: quita " + std::to_string(cuantos) + " de los " +
               std::to_string(cerca + lejos + dentro) + " vértices que se verían";
    };
    return cerca ? Dicho(corta("cerca", cerca), "Acerca ese plano a la cámara.")
                 : Dicho(corta("lejos", lejos), "Aleja ese plano de la cámara.");
}

// La cámara está donde x, y y w son 0. Con perspectiva, −1/w crece con la distancia como la profundidad, y no depende
// de los planos cerca y lejos.
Solido solidoDe(const Puntos &puntos, const std::vector<unsigned> &triangulos, bool alReves) {
    Solido s;
    for (const P &p : puntos)
        if (!std::isfinite(p[0] + p[1] + p[2] + p[3]))
            return s;
    double angulo = 0, volumen = 0, cabe = 0;
    bool delante = true, perspectiva = false;
    V centro(0);
    std::vector<V> vistos;
    for (const auto &[x, y, z, w] : puntos) {
        delante = delante && w > 0;
        perspectiva = perspectiva || w != puntos[0][3];
        vistos.push_back({double(x) / double(w), double(y) / double(w), double(z)});
    }
    for (std::size_t i = 0; i < vistos.size(); ++i) {
        vistos[i][2] = perspectiva ? -1 / double(puntos[i][3]) : alReves ? -vistos[i][2] : vistos[i][2];
        centro += vistos[i] / double(vistos.size());
    }
    for (std::size_t i = 0; i + 2 < triangulos.size(); i += 3) {
        const auto desdeLaCamara = [&](std::size_t k) {
            const auto &[x, y, z, w] = puntos[triangulos[i + k]];
            return V{double(x), double(y), double(w)};
        };
        const auto en = [&](std::size_t k) { return vistos[triangulos[i + k]] - centro; };
        angulo += anguloSolido(desdeLaCamara(0), desdeLaCamara(1), desdeLaCamara(2));
        const V a = en(0), b = en(1), c = en(2);
        volumen += glm::dot(a, glm::cross(b, c));
        cabe += glm::length(a) * glm::length(b) * glm::length(c);
    }
    s.rodea = perspectiva && std::fabs(std::fabs(angulo) - 4 * M_PI) < 0.1;
    const bool aplastado = std::fabs(volumen) < 1e-5 * cabe;
    s.cerrado = (s.rodea || (delante && !aplastado)) && estaCerrado(puntos, triangulos);
    s.antihorario =
        (s.rodea ? angulo : volumen) < 0; // con la profundidad hacia dentro, los ejes van a izquierdas
    return s;
}

Productos productosDe(const std::string &fuente) {
    Palabras p;
    try {
        p = preprocesa(fuente).palabras;
    } catch (const NoSe &) {
        return {};
    }
    const auto cierra = [&](std::size_t i) { // lo que sigue a lo que abre esa
        int hondo = 0;
        do {
            hondo += p[i].texto == "(" || p[i].texto == "[";
            hondo -= p[i].texto == ")" || p[i].texto == "]";
        } while (p[i++].clase != Palabra::Fin && hondo > 0 && i + 1 < p.size());
        return i;
    };
    const auto abre = [&](std::size_t i) { return p[i].texto == "(" || p[i].texto == "["; };
    Productos todos;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (i > 0 && (p[i - 1].texto == "*" || p[i - 1].texto == "." || p[i - 1].clase == Palabra::Nombre))
            continue;
        std::vector<std::string> factores;
        for (std::size_t j = i; p[j].clase == Palabra::Nombre || p[j].clase == Palabra::Numero || abre(j);) {
            const std::size_t desde = j;
            j += !abre(j);
            while (abre(j) || p[j].texto == ".")
                j = abre(j) ? cierra(j) : std::min(j + 2, p.size() - 1);
            factores.push_back(texto(&p[desde], &p[j]));
            if (p[j].texto != "*")
                break;
            ++j;
        }
        if (factores.size() > 1)
            todos.push_back(factores);
    }
    return todos;
}

namespace {

const std::size_t FUERA[] = {1, 2, 4, 6, 8, 9}; // de la diagonal, en las tres primeras filas y columnas

enum class Lado { No, Derecha, Izquierda }; // dónde está lo que multiplican

// En un producto, dónde está el vector; y si por fuera de esa matriz hay otra que gira o inclina.
struct Uso {
    Lado vector = Lado::No;
    bool porDentro = false;
};

Uso usoDe(const std::string &nombre, const std::vector<Matriz> &todas, const Productos &productos) {
    const auto matriz = [&](const std::string &factor) {
        return std::find_if(todas.begin(), todas.end(), [&](const Matriz &m) { return m.nombre == factor; });
    };
    const auto gira =
        [&](const std::string &factor) { // la que solo escala y traslada puede ir tras la proyección
            const auto suya = matriz(factor);
            return suya != todas.end() && std::any_of(std::begin(FUERA), std::end(FUERA),
                                                      [&](std::size_t i) { return suya->valor[i] != 0; });
        };
    for (const auto &factores : productos) {
        const auto suyo = std::find(factores.begin(), factores.end(), nombre);
        if (suyo == factores.end())
            continue;
        const bool izquierda = matriz(factores[0]) == todas.end(),
                   derecha = matriz(factores.back()) == todas.end();
        static const std::regex PUNTO("1(\\.0*)?\\s*\\)$|[Pp]osici");
        if (izquierda == derecha || (izquierda && !std::regex_search(factores[0], PUNTO)))
            continue; // a la izquierda puede ir un plano o una normal
        return {izquierda ? Lado::Izquierda : Lado::Derecha, izquierda
                                                                 ? std::any_of(suyo + 1, factores.end(), gira)
                                                                 : std::any_of(factores.begin(), suyo, gira)};
    }
    return {};
}

bool perpendiculares(const std::vector<double> &m) { // las tres filas
    for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t b = (a + 1) % 3;
        const V u = {m[a], m[4 + a], m[8 + a]}, v = {m[b], m[4 + b], m[8 + b]};
        if (std::fabs(glm::dot(u, v)) > 1e-4 * glm::length(u) * glm::length(v))
            return false;
    }
    return true;
}

Dicho dePlanos(const std::string &quien, const std::vector<double> &m, bool alReves) {
    const double cerca = m[14] / (m[10] - 1), lejos = m[14] / (m[10] + 1);
    if (m[14] == 0 || cerca < 0)
        return {"en la proyección, " + quien + ", el plano cerca es " +
                    (m[14] == 0 ? "0" : cifras(cerca, 4)) + ": todo queda a la misma profundidad",
                "cerca tiene que ser mayor que 0: 0.1, por ejemplo."};
    if (cerca > lejos && lejos > 0 && !alReves)
        return {"en la proyección, " + quien + ", cerca (" + cifras(cerca, 4) + ") es mayor que lejos (" +
                    cifras(lejos, 4) + ")",
                "glm::perspective(ángulo, aspecto, cerca, lejos): están cambiados."};
    for (int grados = 20; grados < 180; ++grados)
        if (std::fabs(m[5] * std::tan(grados / 2.0) - 1) < 2e-6)
            return {"el ángulo de la proyección, " + quien +
                        ", parece dado en grados: " + std::to_string(grados) + " radianes son " +
                        std::to_string(int(grados / (2 * M_PI))) + " vueltas y pico",
                    "glm::perspective quiere radianes: glm::radians(" + std::to_string(grados) + ".0f)."};
    return {};
}

} // namespace

Dicho deMatriz(const Matriz &matriz, const std::vector<Matriz> &todas, const Productos &productos,
               bool alReves) {
    const std::vector<double> &m = matriz.valor;
    const std::string quien = "«" + matriz.nombre + "»";
    const Uso uso = usoDe(matriz.nombre, todas, productos);
    const auto ceros = [&](std::initializer_list<std::size_t> cuales) {
        return std::all_of(cuales.begin(), cuales.end(), [&](std::size_t i) { return m[i] == 0; });
    };
    const bool afin = m[15] == 1 && ceros({3, 7, 11}) && !ceros({12, 13, 14});
    const bool afinTraspuesta = m[15] == 1 && !ceros({3, 7, 11}) && ceros({12, 13, 14}) && perpendiculares(m);
    const bool plana = ceros({1, 3, 4, 7, 12, 13, 15});
    const bool perspectiva = plana && std::fabs(m[11]) == 1;
    const bool perspectivaTraspuesta = plana && !perspectiva && std::fabs(m[14]) == 1 && m[11] != 0;
    if (uso.vector == Lado::Derecha && (afinTraspuesta || perspectivaTraspuesta))
        return {quien + " parece traspuesta: su última columna está donde debía ir la última fila",
                "Las de glm se envían con GL_FALSE y sin glm::transpose."};
    if (uso.vector == Lado::Izquierda && (afin || perspectiva))
        return {"el shader pone el vector a la izquierda de " + quien + ", que no está traspuesta",
                "Con las matrices de glm el vector va a la derecha: proyeccion * camara * M * vec4(posicion, "
                "1.0)."};
    if (perspectiva && uso.porDentro)
        return {quien + ", que es la proyección, no va a la izquierda de las demás matrices",
                "Se aplican de derecha a izquierda: proyeccion * camara * M * vec4(posicion, 1.0)."};
    if (m[11] == -1 && ceros({3, 7, 15}) && !ceros({12, 13}) && !ceros({2, 6}))
        return {quien + " parece una proyección multiplicada al revés: a la derecha de otra matriz",
                "La proyección va a la izquierda: proyeccion * camara."};
    return perspectiva ? dePlanos(quien, m, alReves) : Dicho();
}

Dicho conCero(const Productos &productos, const std::vector<Matriz> &matrices) {
    const auto pierde = [](const std::string &factor) {
        return factor.compare(0, 4, "vec4") == 0 && factor.find(',') != factor.npos &&
               factor.find_first_not_of(" 0.f)", factor.rfind(',') + 1) == factor.npos;
    };
    const bool hay = std::any_of(productos.begin(), productos.end(), [&](const auto &factores) {
        return std::any_of(factores.begin(), factores.end(), pierde) &&
               std::any_of(matrices.begin(), matrices.end(), [&](const Matriz &m) {
                   return m.valor[11] != 0 &&
                          std::find(factores.begin(), factores.end(), m.nombre) != factores.end();
               });
    });
    return hay ? Dicho("la posición se multiplica con w = 0, y las matrices no la trasladan",
                       "Es vec4(posicion, 1.0): con 0 es una dirección.")
               : Dicho();
}

namespace {

using Giro = glm::dmat3;

Giro giroDe(const std::vector<double> &m) {
    const std::size_t alto = m.size() == 16 ? 4 : 3;
    Giro g;
    for (int i = 0; i < 9; ++i)
        g[i / 3][i % 3] = m[std::size_t(i) / 3 * alto + std::size_t(i) % 3];
    return g;
}

// Si lo que lleva así las normales las deja perpendiculares a lo que lleva así los puntos.
bool sonDe(const Giro &normales, const Giro &puntos) {
    const Giro g = glm::transpose(normales) * puntos;
    const double vale = g[0][0];
    for (int i = 0; i < 9; ++i)
        if (std::fabs(g[i / 3][i % 3] - (i % 4 ? 0 : vale)) > 1e-3 * std::fabs(vale))
            return false;
    return true;
}

} // namespace

Dicho deIluminacion(const Iluminacion &s, const Productos &productos, const std::vector<Matriz> &matrices) {
    const auto llevan = [&](const std::string &atributo,
                            bool ultima) { // el producto, y lo que queda sin la primera
        std::vector<std::pair<Giro, std::string>> todos;
        for (const auto &factores : productos) {
            if (!std::regex_search(factores.back(), std::regex("\\b" + atributo + "\\b")))
                continue;
            Giro g(1);
            std::string primera;
            bool conocidas = true;
            for (std::size_t i = factores.size() - 1; i-- > (ultima ? 0 : 1);) {
                const auto suya = std::find_if(matrices.begin(), matrices.end(), [&](const Matriz &m) {
                    return factores[i] == m.nombre || factores[i] == "mat3(" + m.nombre + ")";
                });
                conocidas =
                    conocidas && suya != matrices.end() && (suya->valor.size() == 9 || suya->valor[11] == 0);
                if (conocidas)
                    g = giroDe(suya->valor) * g, primera = factores[0];
            }
            if (conocidas)
                todos.push_back({g, primera});
        }
        return todos;
    };
    for (const auto &normales : llevan(s.normal, true)) {
        const auto es = [&](const auto &puntos) { return sonDe(normales.first, puntos.first); };
        const auto conCamara = llevan(s.posicion, true), sinCamara = llevan(s.posicion, false);
        if (std::any_of(conCamara.begin(), conCamara.end(), es))
            continue;
        const auto suyo = std::find_if(sinCamara.begin(), sinCamara.end(), es);
        if (suyo == sinCamara.end() || suyo->second.empty())
            continue;
        const std::regex punto("(\\w+)\\s*=[^;]*\\b" + suyo->second + "\\b[^;]*\\b" + s.posicion + "\\b");
        std::smatch hallado;
        if (std::regex_search(s.vert, hallado, punto) &&
            std::regex_search(s.frag, std::regex("-\\s*" + hallado[1].str() + "\\b")))
            return {"la luz se calcula con «" + hallado[1].str() + "», que pasa por «" + suyo->second +
                        "», y con una normal que no: queda en coordenadas del mundo",
                    "La normal va por transpose(inverse(mat3(" + suyo->second + " * M))), o todo sin " +
                        suyo->second + "."};
    }
    return {};
}

} // namespace explica
