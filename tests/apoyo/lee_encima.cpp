#include "encima.h"
#include <fstream>
#include <sstream>
#include <stdexcept>

static Pintado leePintado(const std::string &linea) {
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

std::vector<Encima> leeEncima(const std::string &fichero) {
    std::ifstream entrada(fichero);
    std::vector<Encima> imagenes;
    for (std::string linea; std::getline(entrada, linea);)
        if (linea.rfind("imagen\t", 0) == 0)
            imagenes.emplace_back().imagen = linea.substr(linea.find('\t') + 1);
        else
            imagenes.at(imagenes.size() - 1).push_back(leePintado(linea));
    return imagenes;
}
