// De dónde le llega a una orden lo que dibuja: los arrays de vértices, los uniforms y las texturas.
#pragma once
#include "json.h"
#include "programas.h"

namespace explica {

struct Atributo {
    Variable variable;
    bool activo = false; // su array
    GLint bufer = 0, componentes = 0, paso = 0;
    GLenum tipo = GL_FLOAT;
    std::intptr_t desplazamiento = 0;
    std::vector<std::array<float, 4>> primeros; // los de los primeros vértices, si son float
};

struct Uniforme {
    Variable variable;
    std::vector<double> valor;
    bool dado = true; // si alguien le ha dado un valor
};

struct Textura {
    std::string sampler;
    GLint unidad = 0, nombre = 0; // 0: ninguna
    GLenum objetivo = GL_TEXTURE_2D;
    GLint ancho = 0, alto = 0, formato = 0, reduce = 0, amplia = 0, repiteS = 0, repiteT = 0;
    std::string incompleta; // por qué; vacío si está completa
};

struct Cableado {
    std::vector<Atributo> atributos;
    std::vector<Uniforme> uniformes;
    std::vector<Textura> texturas;
};

/// Lo que usa el programa en curso. No cambia nada del estado.
Cableado cableadoActual();
Json deCableado(const Cableado &cableado);

/// Apunta que a ese uniform del programa en curso se le da un valor.
void apuntaUniforme(GLint donde);

} // namespace explica
