// Las primitivas de una orden de dibujar, cada una suelta: con ellas se puede dibujar una parte. Sin OpenGL.
#pragma once
#include "opengl.h"
#include <optional>
#include <string>
#include <vector>

namespace explica {

struct Primitivas {
    GLenum modo = GL_POINTS; // GL_POINTS, GL_LINES o GL_TRIANGLES
    int vertices = 1;        // de cada una
    std::vector<GLuint> indices;

    int cuantas() const {
        return int(indices.size()) / vertices;
    }
};

/// Las que dibuja esa orden, con el vértice que da el color plano y el sentido de giro que tienen en ella. `reinicia`:
/// el índice que corta una tira. Vacío si el modo no se conoce.
std::optional<Primitivas> sueltas(GLenum modo, const std::vector<GLuint> &indices,
                                  std::optional<GLuint> reinicia);

/// «36 triángulos», «1 punto».
std::string cuantasSon(const Primitivas &primitivas);

/// «triángulo», «segmento» o «punto».
std::string nombrePrimitiva(const Primitivas &primitivas);

} // namespace explica
