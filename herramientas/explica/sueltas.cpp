#include "sueltas.h"
#include "estado.h"

namespace explica {

Sueltas::Sueltas(Primitivas p) : primitivas(std::move(p)) {
    const Guardado guardado;
    glGenBuffers(1, &bufer);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, bufer); // WebGL no deja que antes lo sea de otra cosa
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(primitivas.indices.size() * sizeof(GLuint)),
                 primitivas.indices.data(), GL_STREAM_DRAW);
}

Sueltas::~Sueltas() {
    glDeleteBuffers(1, &bufer);
}

void Sueltas::dibuja(int desde, int hasta) const {
    const GLint antes = entero(GL_ELEMENT_ARRAY_BUFFER_BINDING);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, bufer);
    const std::size_t byte = sizeof(GLuint) * std::size_t(primitivas.vertices) * std::size_t(desde);
    deVerdad().dibujaIndices(primitivas.modo, primitivas.vertices * (hasta - desde), GL_UNSIGNED_INT,
                             reinterpret_cast<const void *>(byte));
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, GLuint(antes));
}

// Como puntos y sin índices, que con ellos WebGL no deja; los que van seguidos, de una vez.
void Sueltas::recoge(int desde, int hasta, void *salen, GLsizeiptr bytes) const {
    GLuint recogido;
    const GLint antes = entero(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING);
    glGenBuffers(1, &recogido);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, recogido);
    glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, bytes, nullptr, GL_STREAM_READ);
    glEnable(GL_RASTERIZER_DISCARD);
    glBeginTransformFeedback(GL_POINTS);
    const auto &indices = primitivas.indices;
    const auto fin = std::size_t(hasta * primitivas.vertices);
    for (auto i = std::size_t(desde * primitivas.vertices), j = i; i < fin; i = j) {
        while (++j < fin && indices[j] == indices[i] + (j - i)) {
        }
        deVerdad().dibujaVertices(GL_POINTS, GLint(indices[i]), GLsizei(j - i));
    }
    glEndTransformFeedback();
    glDisable(GL_RASTERIZER_DISCARD);
    glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, bytes, salen);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, GLuint(antes));
    glDeleteBuffers(1, &recogido);
}

void soloPregunta(Punto p) {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthMask(GL_FALSE);
    glStencilMask(0);
    glEnable(GL_SCISSOR_TEST);
    glScissor(p.x, p.y, 1, 1);
    glDisable(GL_CULL_FACE);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_DEPTH_TEST);
}

} // namespace explica
