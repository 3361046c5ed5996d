#include "encima.h"
#include <limits>

namespace {

Pintado leePintado(const std::string &linea) {
    std::vector<std::string> campos;
    std::istringstream partes(linea);
    for (std::string campo; std::getline(partes, campo, '\t');)
        campos.push_back(campo);
    campos.resize(7);
    Pintado p;
    p.tipo = campos[0];
    std::istringstream color(campos[1]), panel(campos[2]), puntos(campos[5]);
    color >> p.color.r >> p.color.g >> p.color.b;
    panel >> p.panel.x >> p.panel.y >> p.panel.z >> p.panel.w;
    p.talla = std::stod(campos[3]);
    p.conProfundidad = campos[4] == "1";
    for (glm::dvec3 v; puntos >> v.x >> v.y >> v.z;)
        p.puntos.push_back(v);
    p.texto = campos[6];
    for (std::size_t i; (i = p.texto.find("\\n")) != std::string::npos;)
        p.texto.replace(i, 2, "\n");
    if (!color || !panel || !puntos.eof() || (p.puntos.empty() && p.tipo != "velo"))
        throw std::runtime_error("no entiendo lo apuntado encima: " + linea);
    return p;
}

double distancia(const glm::dvec2 &p, const glm::dvec2 &a, const glm::dvec2 &b) {
    const glm::dvec2 d = b - a;
    const double largo2 = glm::dot(d, d), t = largo2 > 0 ? glm::dot(p - a, d) / largo2 : 0;
    return glm::distance(p, a + glm::clamp(t, 0.0, 1.0) * d);
}

} // namespace

bool Pintado::es(const glm::vec3 &otro) const {
    return glm::all(glm::lessThan(glm::abs(color - otro), glm::vec3(1e-5f)));
}

std::vector<std::pair<glm::dvec2, glm::dvec2>> Pintado::tramos() const {
    std::vector<std::pair<glm::dvec2, glm::dvec2>> t;
    const bool sueltos = tipo == "puntos";
    for (std::size_t i = 0; i + 1 < puntos.size() || (sueltos && i < puntos.size());
         i += tipo == "segmentos" ? 2 : 1)
        t.emplace_back(punto(i), punto(sueltos ? i : i + 1));
    return t;
}

Encima Encima::los(const std::function<bool(const Pintado &)> &queCumplan) const {
    Encima hallados;
    std::copy_if(begin(), end(), std::back_inserter(hallados), queCumplan);
    return hallados;
}

Encima Encima::rotulos(const std::string &texto) const {
    return los([&](const Pintado &p) { return p.tipo == "rotulo" && p.texto == texto; });
}

Encima Encima::trazos(const glm::vec3 &color, const std::string &tipo) const {
    return los([&](const Pintado &p) {
        return p.tipo != "rotulo" && p.es(color) && (tipo.empty() || p.tipo == tipo);
    });
}

Encima Encima::enPanel(double x, double y) const {
    return los([&](const Pintado &p) { return p.panel.x == x && p.panel.y == y; });
}

double Encima::lejosDeTrazo(const glm::dvec2 &p, const glm::vec3 &color) const {
    double menor = std::numeric_limits<double>::infinity();
    for (const Pintado &t : trazos(color))
        for (const auto &[a, b] : t.tramos())
            menor = std::min(menor, distancia(p, a, b));
    return menor;
}

double Encima::largo(const glm::vec3 &color) const {
    double suma = 0;
    for (const Pintado &t : trazos(color))
        for (const auto &[a, b] : t.tramos())
            suma += glm::distance(a, b);
    return suma;
}

std::vector<Encima> leeEncima(const std::string &fichero) {
    std::ifstream entrada(fichero);
    std::vector<Encima> imagenes;
    for (std::string linea; std::getline(entrada, linea);)
        if (linea.rfind("imagen\t", 0) == 0)
            imagenes.emplace_back();
        else
            imagenes.at(imagenes.size() - 1).push_back(leePintado(linea));
    return imagenes;
}

void compruebaTrazo(const Encima &encima, const std::vector<glm::dvec2> &linea, const glm::vec3 &color,
                    double lejos) {
    double mayor = 0;
    glm::dvec2 donde(0);
    const std::size_t n = linea.size();
    for (std::size_t i = 0; i < n; ++i) {
        const glm::dvec2 a = linea[i], b = linea[std::min(i + 1, n - 1)];
        const int pasos = std::max(int(glm::distance(a, b) / 2), 1);
        for (int k = 0; k <= pasos; ++k) {
            const glm::dvec2 p = glm::mix(a, b, double(k) / pasos);
            const double d = encima.lejosDeTrazo(p, color);
            if (d > mayor) {
                mayor = d;
                donde = p;
            }
        }
    }
    EXPECT_LE(mayor, lejos) << "no hay trazo en (" << donde.x << ", " << donde.y << ")";
}

void compruebaPuntos(const Encima &encima, const std::vector<glm::dvec2> &puntos, const glm::vec3 &color) {
    std::vector<glm::dvec2> hallados;
    for (const Pintado &p : encima.trazos(color, "puntos"))
        for (std::size_t i = 0; i < p.puntos.size(); ++i)
            hallados.push_back(p.punto(i));
    ASSERT_EQ(hallados.size(), puntos.size());
    for (std::size_t i = 0; i < puntos.size(); ++i)
        EXPECT_LE(glm::distance(hallados[i], puntos[i]), 0.1) << "el punto " << i;
}
