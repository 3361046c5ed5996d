// Ejecutar un programa del laboratorio desde una prueba, sin ventana y con un guion, y quedarse con lo que ha dibujado.
#pragma once
#include "encima.h"
#include "imagen.h"
#include "prueba.h"

/// Carpeta de este proceso y de nadie más, para todo lo que una prueba escribe: se crea al pedirla y se borra al
/// terminar. Dos pruebas a la vez, o de dos usuarios, no se estorban.
const std::filesystem::path &carpetaTemporal();

struct Ejecucion {
    int estado = -1;     // el de salida; 128 + señal si lo ha matado una
    std::string salida;  // stdout
    std::string errores; // stderr
    Imagen imagen;       // vacía si no ha escrito ninguna
};

/// Ejecuta un programa («grua») con ese tamaño y ese guion, en una carpeta temporal que se borra después. `argumentos`
/// van tal cual al final. Es para probar cómo termina y qué escribe; lo que dibuja se pide abajo.
Ejecucion ejecuta(const std::string &programa, const std::string &guion = "", int ancho = 240, int alto = 180,
                  const std::vector<std::string> &argumentos = {});

/// La imagen de un programa que termina bien y sin avisos: si no, la prueba falla y lo dice.
Imagen imagenDe(const std::string &programa, const std::string &guion = "", int ancho = 240, int alto = 180,
                const std::vector<std::string> &argumentos = {});

/// La escena sola, que es lo que se compara con un oráculo, y la lista de lo que el programa pinta encima de ella.
struct Vista {
    Imagen escena;
    Encima encima;
};

/// La de un programa que termina bien y sin avisos.
Vista vistaDe(const std::string &programa, const std::string &guion = "", int ancho = 240, int alto = 180,
              const std::vector<std::string> &argumentos = {});

/// Las que quedan tras cada guion de una sola ejecución; cada uno sigue al anterior.
std::vector<Vista> vistasDe(const std::string &programa, const std::vector<std::string> &guiones,
                            int ancho = 240, int alto = 180, const std::vector<std::string> &argumentos = {});

/// Mientras existe, los programas buscan los ficheros del laboratorio antes en esa carpeta ($LAB_RAIZ).
class ConRaiz {
public:
    explicit ConRaiz(const std::filesystem::path &carpeta);
    ~ConRaiz();
    ConRaiz(const ConRaiz &) = delete;
    ConRaiz &operator=(const ConRaiz &) = delete;

private:
    const std::string antes;
};

/// Los tres componentes (0 a 255) del píxel (x, y) contado desde ABAJO a la izquierda.
struct Pixel {
    int r, g, b;
};
Pixel pixel(const Imagen &imagen, int x, int y);

/// Apunta en el informe de la prueba, para docs/exactitud.md, lo que el último programa ejecutado se aparta de lo que
/// debe: la mayor diferencia y la cuadrática media, en niveles de 255, y cuánto se desvían los bordes, en píxeles,
/// salvo `lejos` de los `banda` que hay en ellos; negativo lo que no se mide. De varias queda la peor. El oráculo
/// (oraculo::compara) lo hace solo.
void apuntaDiferencia(double maximo, double rmse = -1, double borde = -1, int lejos = 0, int banda = 0);
