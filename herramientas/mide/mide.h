// Lo común de las técnicas de ./lab mide: cada una es un fichero de esta carpeta que compara maneras de hacer lo mismo,
// las cronometra y dice el error de cada una frente a algo exacto.
#pragma once
#include "imagen.h"
#include "texto.h"
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace mide {

const double INFINITO = std::numeric_limits<double>::infinity();

struct Medida {
    std::string variante, grupo;
    double error;
    std::string nota;
    std::vector<double> tiempos; // uno por ronda
};

/// Lo que recibe cada técnica: si es el ensayo, y a quién dar sus variantes. Cronometradas una detrás de otra no se
/// podrían comparar: el procesador cambia de paso. Cada una queda en un proceso hijo, con la memoria y el estado de
/// OpenGL que tenía, y al final corren todas por rondas, un rato corto cada una y en otro orden cada vez.
class Medidor {
public:
    const bool ensayo; // tallas diminutas y una sola vuelta: solo se comprueba que todo funciona
    const bool pares;  // comparar también con otros programas (LAB_PARES=1)
    std::string grupo; // de las variantes que sigan: solo se comparan entre sí las del mismo
    Imagen referencia; // con ella y la imagen de una variante se hace la de su diferencia

    Medidor(bool esEnsayo, double losNs, std::string elPrefijo)
        : ensayo(esEnsayo), pares(std::getenv("LAB_PARES") != nullptr), ns(losNs),
          prefijo(std::move(elPrefijo)) {
    }
    /// De lo que se haga en el ensayo y de lo que se haga al medir.
    template<class T>
    T elige(T enEnsayo, T alMedir) const {
        return ensayo ? enEnsayo : alMedir;
    }
    Medidor(const Medidor &) = delete;
    ~Medidor();
    /// Cronometrará `trabajo`, que hace `unidades` de lo que dice la unidad de tiempo de la técnica; también lo que
    /// gasten otros programas, si los ejecuta y espera a que acaben.
    void variante(const std::string &nombre, const std::string &nota, double error, double unidades,
                  const std::function<void()> &trabajo, const Imagen &imagen = {});
    /// Las rondas, y lo medido.
    const std::vector<Medida> &corre();

private:
    double ns;           // los de una unidad de tiempo
    std::string prefijo; // de los ficheros que deja
    std::vector<Medida> medidas;
    std::vector<int> corredores; // por dónde se le habla a cada variante
};

/// Cada fichero define la suya, que se apunta sola en la lista.
struct Tecnica {
    int orden; // el del informe
    const char *nombre, *titulo;
    const char *tiempo;  // «ns por punto»: la unidad (ns, µs o ms) y de qué
    const char *error;   // la unidad del error y contra qué se mide
    const char *elegida; // la variante que usan los programas, y las que la sigan de una coma
    const char *porQue;
    void (*mide)(Medidor &);
};
std::vector<Tecnica> &tecnicas();
struct Apunta {
    Apunta(const Tecnica &tecnica) {
        tecnicas().push_back(tecnica);
    }
};

/// El valor que se calcula solo para cronometrarlo, que el compilador no puede quitar.
template<class T>
void usa(const T &valor) {
    asm volatile("" : : "r,m"(valor) : "memory");
}

/// Números al azar entre −1 y 1: los mismos siempre que se empiece con la misma semilla.
class Azar {
    std::mt19937 azar;

public:
    explicit Azar(unsigned semilla) : azar(semilla) {
    }
    float operator()() {
        return float(double(azar()) / 2147483648.0 - 1);
    }
};

/// Raíz del error cuadrático medio, en niveles de 255, frente a la exacta: sin redondear, tres por píxel.
double rmse(const Imagen &imagen, const std::vector<double> &exacta);
/// La imagen de esos valores (de 0 a 255), redondeados.
Imagen redondeada(int ancho, int alto, const std::vector<double> &exacta);

} // namespace mide
