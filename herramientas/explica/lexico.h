// De un shader a sus palabras, con las macros ya expandidas.
#pragma once
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace explica {

struct Palabra {
    enum Clase { Nombre, Numero, Signo, Fin } clase = Fin;
    std::string texto;
    int linea = 0, fichero = 0;
    bool blanco = false; // si en el texto va separada de la anterior
};
using Palabras = std::vector<Palabra>;

/// Lo que no se sabe seguir, y dónde.
struct NoSe : std::runtime_error {
    NoSe(const Palabra &p, const std::string &motivo)
        : runtime_error(motivo), linea(p.linea), fichero(p.fichero) {
    }
    int linea, fichero;
};

struct Preprocesado {
    std::string cabecera; // #version, #extension y #pragma, como estaban
    Palabras palabras;    // la última, Fin
    std::vector<NoSe> avisos;
};

/// Si, con esa cabecera, OpenGL define ese nombre.
using Define = std::function<bool(const std::string &cabecera, const std::string &nombre)>;

/// Quita comentarios y condicionales y expande las macros: cada palabra queda en la línea en que se usa.
/// Lanza NoSe si no puede (una macro que no acaba de crecer). Sin `define`, lo que OpenGL define no se sabe.
Preprocesado preprocesa(const std::string &fuente, const Define &define = {});

/// El texto de unas palabras, espaciadas como lo estaban.
std::string texto(const Palabra *desde, const Palabra *hasta);

/// De un operador de dos lados; 0, si no lo es.
int prioridad(const std::string &signo);

/// El valor de una expresión constante entera, con lo que `conoce` diga de cada nombre; false si no se sabe.
bool evalua(const Palabra *desde, const Palabra *hasta,
            const std::function<bool(const std::string &nombre, long long &valor)> &conoce,
            long long &resultado);

} // namespace explica
