// Lo que suele estar mal cuando la ventana queda negra o no es lo que se esperaba; solo lo que es así en este cuadro.
#pragma once
#include "cableado.h"
#include "posiciones.h"
#include <map>
#include <set>

namespace explica {

struct LineaDeShader {
    std::string etapa = {}; // vert o frag; vacía, si no es de ninguno
    int linea = 0;
};

struct Sospecha {
    int gravedad; // antes las mayores
    int orden;    // 0: de todo el cuadro
    std::string dice, prueba;
    LineaDeShader linea;
    int otras = 0; // órdenes de que se podría decir lo mismo
};

/// Mira el cuadro según se dibuja.
class Sospechas {
    std::vector<Sospecha> lista;
    bool hayFigura = false, figuraEscrita = false; // lo que no es un rótulo
    bool pasaPlantilla = true;                     // algún fragmento de la orden
    bool hayDibujos = false, hayEscrito = false, enVentana = false, borradoElFinal = false;
    std::vector<GLuint> conProfundidad; // los framebuffers en que se ha borrado
    bool conTest = false, apuntaProfundidad = false, enPerspectiva = false; // alguna orden, en la ventana
    struct DeFrente {
        int orden;
        std::string malla;
    };
    std::vector<DeFrente> sinLoDeFrente;              // las órdenes que quitan las caras de delante
    std::map<std::string, std::set<GLenum>> quitadas; // de cada malla, las caras que quita alguna
    struct Indices {
        std::intptr_t cadaUno = 4, hay = 0, hasta = 0; // en bytes
    };
    std::set<GLint> leidos;           // los programas cuyos shaders se han leído
    std::map<GLint, Indices> indices; // de cada buffer, los que se usan

    void pon(int gravedad, int orden, const std::string &dice, const std::string &prueba,
             const LineaDeShader &linea = {});
    void pon(int gravedad, int orden, const Dicho &dicho);
    void apuntaIndices(const Orden &orden);
    void deShaders(int n);
    void deMatrices(const Cableado &cableado, const Lienzo &lienzo, int n);
    void deMalla(const Cableado &cableado, const Orden &orden, const Lienzo &lienzo, const Malla &malla,
                 int n);
    void deColores(const Cableado &cableado, const Orden &orden, const Lienzo &lienzo, int n);
    void delCableado(const Cableado &cableado, const Orden &orden, const Lienzo &lienzo, int n);
    void delEstado(const Orden &orden, const Lienzo &lienzo, int n);
    void deNormales(const Cableado &cableado, int n);
    std::string porQueNada(const Orden &orden, const Cableado &cableado, int n);

public:
    /// Antes de hacerla. Hay que tener el estado del programa.
    void antes(const Orden &orden, const Lienzo &lienzo, const Cableado &cableado, int n);
    /// Después, con los fragmentos que ha escrito. Si son ninguno, devuelve por qué.
    std::string despues(const Orden &orden, const Lienzo &lienzo, const Cableado &cableado, int n,
                        long fragmentos);
    /// Todas, las más graves antes, cuando el cuadro está entero. `unColor`: si la ventana queda lisa.
    std::vector<Json> todas(bool unColor);
};

} // namespace explica
