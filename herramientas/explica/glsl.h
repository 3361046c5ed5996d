// Un shader que va diciendo lo que hace: se reescribe para que apunte, paso a paso, lo que vale cada cosa que calcula
// (Hilgart, «Step-Through Debugging of GLSL Shaders», 2006). Texto a texto, sin OpenGL.
#pragma once
#include "lexico.h"

namespace explica {

enum class Etapa { Vertices, Fragmento };

/// Qué se apunta. Las que no llevan valor son de tipo «void».
enum class Clase {
    Entrada,   // lo que llega: un `in` que se usa, gl_FragCoord, gl_FrontFacing, gl_PointCoord; al empezar
    Global,    // una variable global con valor inicial; al empezar
    Declara,   // variable con valor inicial
    Asigna,    // =, +=, ++…: lo que queda en el lado izquierdo, o lo que un modf le deja
    Condicion, // de if o de ?:
    Vuelta,    // condición de un bucle, una vez por vuelta y la que lo acaba
    Caso,      // se llega a un case o default (void)
    Entra,     // se entra en una función (void)
    Argumento, // lo que vale uno de sus parámetros al entrar
    Sale,      // lo que vale uno out o inout al salir
    Devuelve,  // lo que devuelve
    Vuelve,    // sale sin devolver nada (void); también main
    Descarta,  // discard (void): lo último que se apunta
    Salida,    // valor final de lo que da el shader
    Lee, // de texture() o textureLod(), en cuatro notas: dFdx y dFdy de sus coordenadas; ellas y lo que se suma al
    // nivel; lo leído. La primera se llama como el uniform; vacío, si según de dónde se llama es uno u otro
    SinSeguir // lo leído de otra manera, o de otra textura
};

/// Un sitio del shader que se apunta. Su número es su lugar en Reescrito::notas.
struct Nota {
    Clase clase;
    int linea;          // del texto que se dio, o la que diga #line, desde 1
    int fichero;        // el segundo número de #line; 0 si no lo hay
    std::string nombre; // como está escrito: «color.rgb», «a[i]», «luz.Ld», «NdotL <= 0.0»
    std::string tipo; // float, ivec3, mat2x3…: los struct y los arrays van repartidos en una nota por número
    std::string funcion; // en la que está; vacío en lo global
};

struct Aviso {
    int linea, fichero;
    std::string motivo; // lo que no se sabe seguir; lo demás sí se apunta
};

struct Reescrito {
    std::string fuente; // vacía si no se ha podido con nada
    std::vector<Nota> notas;
    std::vector<Aviso> sinSeguir;
};

/// Reescribe un shader de GLSL 1.40 o ES 3.00, de los que compilan. Lo que resulta tiene los mismos uniforms y los
/// mismos `in`, y calcula lo mismo; en 1.40 empieza también por «#version 140\n» y vale para sin_ventana::enEssl.
/// De un fragment shader, lo que da son `out vec4 explica_0`, `explica_1`… de `salidas` framebuffers RGBA32F (de 3 a
/// 6), con esos `location` (en 1.40, si hay GL_ARB_explicit_attrib_location; si no, con glBindFragDataLocation); no
/// descarta.
/// De un vertex shader, lo que daba y, además, esas mismas `flat out`, para recogerlas con transform feedback.
///
/// Cada valor apuntado ocupa uno o varios pasos seguidos (pasosDe). Cada vez que se dibuja salen los huecosDe(salidas)
/// que hay desde el que dice el uniform `int explica_desde`; los demás solo se cuentan. Con más huecos se dibuja menos
/// veces y se tarda más en compilar.
///   explica_0      de qué nota es el paso de cada hueco; -1 si ya no los hay
///   explica_1      (p, q, d, 0): p + 65536 q pasos dados; si d = 1, descarta
///   explica_2 …    el paso de cada hueco: lo que se apuntó, para `valor`
/// `define`: lo que OpenGL define (lexico.h); sin él, de lo que dependa se avisa. `lecturas`: si se apunta lo que lee
/// de cada textura.
Reescrito reescribe(const std::string &fuente, int salidas, Etapa etapa = Etapa::Fragmento,
                    const Define &define = {}, bool lecturas = false);

/// Cuántos pasos salen cada vez: salidas - 2, de 1 a 4.
int huecosDe(int salidas);

/// Cuántos pasos seguidos ocupa un valor de ese tipo: una matriz, uno por columna; un ivec3, ivec4, uvec3 o uvec4, dos
/// (la mitad de abajo de sus bits y la de arriba, que así pasan exactos por un float); los demás, uno.
int pasosDe(const std::string &tipo);

/// El valor de ese tipo, por columnas y exacto, de lo que llevan sus pasosDe(tipo) pasos, cuatro floats cada uno.
/// Vacío si es void; bool da 0 o 1.
std::vector<double> valor(const std::string &tipo, const float *pasos);

} // namespace explica
