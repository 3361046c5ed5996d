#include "encima.h"
#include "buferes.h"
#include "error.h"
#include "letra.h"
#include "shader.h"
#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace {

const GLuint UNIDAD_ATLAS = 15; // ningún programa usa tantas

const char *const fichero = std::getenv("LAB_ENCIMA");
const std::string sinPintar = std::getenv("LAB_SIN_ENCIMA") ? std::getenv("LAB_SIN_ENCIMA") : "";
std::ostringstream apuntado; // en este cuadro

struct Pincel {
    GLuint programa, vao, bufer, atlas;
};

Pincel creaPincel() {
    Pincel p{};
    p.programa = creaPrograma("common/encima/encima.vert", "common/encima/encima.frag");
    glGenVertexArrays(1, &p.vao);
    glBindVertexArray(p.vao);
    glGenBuffers(1, &p.bufer);
    glBindBuffer(GL_ARRAY_BUFFER, p.bufer);
    ponAtributo(ATRIBUTO_POSICION, 3, sizeof(VerticePintado), offsetof(VerticePintado, posicion));
    ponAtributo(ATRIBUTO_COORD_TEXTURA, 2, sizeof(VerticePintado), offsetof(VerticePintado, enAtlas));

    glGenTextures(1, &p.atlas);
    glBindTexture(GL_TEXTURE_2D, p.atlas);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, ANCHO_ATLAS, ALTO_ATLAS, 0, GL_RED, GL_UNSIGNED_BYTE,
                 letra().texels());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR); // sin mipmaps: la distancia ya es suave
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return p;
}

/// El estado que la pintura cambia; vuelve a ser el de antes al destruirse.
class EstadoGuardado {
    GLint programa, vao, bufer, unidad, mezcla[4];
    GLboolean activo[3];
    static constexpr GLenum INTERRUPTORES[3] = {GL_BLEND, GL_DEPTH_TEST, GL_CULL_FACE};

public:
    EstadoGuardado() {
        glGetIntegerv(GL_CURRENT_PROGRAM, &programa);
        glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &vao);
        glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &bufer);
        glGetIntegerv(GL_ACTIVE_TEXTURE, &unidad);
        glGetIntegerv(GL_BLEND_SRC_RGB, &mezcla[0]);
        glGetIntegerv(GL_BLEND_DST_RGB, &mezcla[1]);
        glGetIntegerv(GL_BLEND_SRC_ALPHA, &mezcla[2]);
        glGetIntegerv(GL_BLEND_DST_ALPHA, &mezcla[3]);
        for (int i = 0; i < 3; ++i)
            activo[i] = glIsEnabled(INTERRUPTORES[i]);
    }
    ~EstadoGuardado() {
        for (int i = 0; i < 3; ++i)
            (activo[i] ? glEnable : glDisable)(INTERRUPTORES[i]);
        glBlendFuncSeparate(GLenum(mezcla[0]), GLenum(mezcla[1]), GLenum(mezcla[2]), GLenum(mezcla[3]));
        glActiveTexture(GLenum(unidad));
        glBindBuffer(GL_ARRAY_BUFFER, GLuint(bufer));
        glBindVertexArray(GLuint(vao));
        glUseProgram(GLuint(programa));
    }
    EstadoGuardado(const EstadoGuardado &) = delete;
    EstadoGuardado &operator=(const EstadoGuardado &) = delete;
};

void apunta(const Pincelada &p, bool conProfundidad) {
    GLint panel[4];
    glGetIntegerv(GL_VIEWPORT, panel);
    const glm::vec3 centro = {panel[0] + 0.5 * panel[2], panel[1] + 0.5 * panel[3], 0};
    apuntado << p.tipo << '\t' << p.color.r << ' ' << p.color.g << ' ' << p.color.b << '\t' << panel[0] << ' '
             << panel[1] << ' ' << panel[2] << ' ' << panel[3] << '\t' << p.talla << '\t' << conProfundidad
             << '\t';
    for (const glm::vec3 &punto : p.puntos) {
        const glm::vec3 v = centro + punto;
        apuntado << v.x << ' ' << v.y << ' ' << v.z << ' ';
    }
    apuntado << '\t';
    for (const char c : p.texto)
        apuntado << (c == '\n' ? std::string("\\n") : std::string(1, c));
    apuntado << '\n';
}

} // namespace

void pintaEncima(const Pincelada &pincelada, const std::vector<VerticePintado> &triangulos,
                 const std::vector<Tinta> &tintas, bool conProfundidad) {
    if (fichero)
        apunta(pincelada, conProfundidad && glIsEnabled(GL_DEPTH_TEST));
    if (sinPintar == "1" || sinPintar == pincelada.tipo)
        return;
    const EstadoGuardado estado;
    glActiveTexture(GL_TEXTURE0 + UNIDAD_ATLAS);
    static const Pincel pincel = creaPincel();
    glUseProgram(pincel.programa);
    glBindVertexArray(pincel.vao);
    glBindTexture(GL_TEXTURE_2D, pincel.atlas);
    glBindBuffer(GL_ARRAY_BUFFER, pincel.bufer);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(triangulos.size() * sizeof(VerticePintado)), triangulos.data(),
                 GL_STREAM_DRAW);
    glDisable(GL_CULL_FACE);
    if (!conProfundidad)
        glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    envia(pincel.programa, "atlas", int(UNIDAD_ATLAS));
    for (const Tinta &tinta : tintas) {
        envia(pincel.programa, "tinta", tinta.color);
        envia(pincel.programa, "borde", tinta.borde);
        envia(pincel.programa, "nitidez", tinta.nitidez);
        glDrawArrays(GL_TRIANGLES, 0, GLsizei(triangulos.size()));
    }
}

void empiezaCuadroEncima() {
    apuntado.str("");
    apuntado.precision(9);
}

void guardaEncima(const std::string &imagen, int ancho, int alto) {
    if (!fichero)
        return;
    static std::ofstream salida(fichero);
    salida << "imagen\t" << imagen << '\t' << ancho << '\t' << alto << '\n' << apuntado.str() << std::flush;
    if (!salida)
        falla("no puedo escribir en «" + std::string(fichero) + "» (LAB_ENCIMA)");
}
