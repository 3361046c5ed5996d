// De dónde le llega a una orden lo que dibuja: los arrays de vértices, los uniforms y las texturas.
#pragma once
#include "json.h"
#include "programas.h"
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace explica {

struct Atributo {
    Variable variable;
    bool activo = false;    // su array
    bool constante = false; // no lo hay y se le ha dado un valor, el mismo para todos los vértices
    GLint bufer = 0, componentes = 0, paso = 0, bytes = 0; // bytes: los de su buffer
    GLenum tipo = GL_FLOAT;
    std::intptr_t desplazamiento = 0;
    std::vector<std::array<float, 4>> primeros; // los de los primeros vértices, si son float
    std::string suma;                           // de lo suyo en todo el buffer
};

struct Uniforme {
    Variable variable;
    std::vector<double> valor;
    bool dado = true;         // si alguien le ha dado un valor
    std::string malDado = ""; // la función con que se le ha dado, si no es la suya
    int pila = -1;            // desde dónde se le ha dado
};

struct Textura {
    std::string sampler;
    GLint unidad = 0, nombre = 0; // 0: ninguna
    GLenum objetivo = GL_TEXTURE_2D;
    GLint ancho = 0, alto = 0, formato = 0, reduce = 0, amplia = 0, repiteS = 0, repiteT = 0;
    std::string incompleta; // por qué; vacío si está completa
    std::string suma;       // de su imagen
};

struct Cableado {
    std::vector<Atributo> atributos;
    std::vector<Uniforme> uniformes;
    std::vector<Textura> texturas;
    std::string sumaIndices;
};

/// Lo que usa el programa en curso; con `sumas`, también una de lo que hay en cada array y en cada textura, para saber
/// si en otro cuadro hay lo mismo. No cambia nada del estado.
Cableado cableadoActual(bool sumas = false);
/// Los bytes que ocupa un número de ese tipo.
std::size_t bytesDe(GLenum tipo);

Json deCableado(const Cableado &cableado);

} // namespace explica
