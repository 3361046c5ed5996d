// Lo que un programa pinta encima de su escena (rótulos y trazos), como lo apunta common/encima/encima.h, y cómo
// comprobarlo.
// Los puntos y las distancias son píxeles de la ventana, desde abajo a la izquierda.
#pragma once
#include "prueba.h"

struct Pintado {
    std::string tipo; // rotulo, segmentos, polilinea, puntos, flecha o poligono
    glm::vec3 color;
    glm::dvec4 panel; // x, y, ancho, alto
    double talla;     // alto de las mayúsculas, grosor o diámetro
    bool conProfundidad;
    std::vector<glm::dvec3> puntos; // con la profundidad normalizada; de un rótulo, dos esquinas y el suyo
    std::string texto;

    bool es(const glm::vec3 &otro) const; // de ese color
    glm::dvec2 punto(std::size_t i) const {
        return glm::dvec2(puntos.at(i));
    }
    /// De los trazos, los tramos que los forman: parejas de puntos.
    std::vector<std::pair<glm::dvec2, glm::dvec2>> tramos() const;
};

struct Encima : std::vector<Pintado> {
    Encima los(const std::function<bool(const Pintado &)> &queCumplan) const;
    /// Los rótulos con ese texto.
    Encima rotulos(const std::string &texto) const;
    /// Los trazos de ese color; con `tipo`, solo los de ese tipo.
    Encima trazos(const glm::vec3 &color, const std::string &tipo = "") const;
    /// Lo que va en el panel cuya esquina está en (x, y).
    Encima enPanel(double x, double y) const;

    /// Distancia de un punto al trazo de ese color más cercano, de su eje: infinita si no hay ninguno.
    double lejosDeTrazo(const glm::dvec2 &p, const glm::vec3 &color) const;
    /// Lo que miden en total los trazos de ese color que son líneas.
    double largo(const glm::vec3 &color) const;
};

/// Lo apuntado para cada imagen guardada, en orden.
std::vector<Encima> leeEncima(const std::string &fichero);

/// Comprueba que hay un trazo de ese color a lo largo de la línea de esos puntos, a `lejos` píxeles como mucho.
void compruebaTrazo(const Encima &encima, const std::vector<glm::dvec2> &linea, const glm::vec3 &color,
                    double lejos = 0.1);

/// Comprueba que los puntos de ese color son esos, en ese orden.
void compruebaPuntos(const Encima &encima, const std::vector<glm::dvec2> &puntos, const glm::vec3 &color);
