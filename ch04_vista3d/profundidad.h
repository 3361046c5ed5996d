// Cuánta profundidad cabe en un buffer de pocos bits (§4.4, ecuación 4.3): qué valor recibe cada distancia y
// cuántos pares de superficies casi juntas quedan iguales o invertidos. Sin OpenGL; lo usa el programa
// profundidad y lo comprueban las pruebas. T es el tipo con que se calcula: float, como la GPU, o double.
#pragma once
#include <cmath>

/// Profundidad, de 0 (cerca) a 1 (lejos), de lo que está a distancia d por delante de la cámara: la tercera
/// fila de la ecuación 4.3, la división perspectiva y el paso de [−1, 1] a [0, 1]. 0 < cerca < lejos.
template<class T>
T profundidad(T d, T cerca, T lejos) {
    const T z = (lejos + cerca) / (cerca - lejos) * -d + 2 * lejos * cerca / (cerca - lejos);
    return T(0.5) * (z / d) + T(0.5);
}

/// Entero que guarda un buffer de `bits` bits (de 1 a 32).
template<class T>
double enBuffer(T profundidad, int bits) {
    return std::round(double(profundidad) * (std::ldexp(1.0, bits) - 1));
}

/// Proporción (de 0 a 1) de pares mal ordenados: los dos con el mismo valor, o el de detrás con uno menor.
struct ParesMal {
    double iguales = 0, invertidos = 0;
};

/// Compara lo que guarda el buffer de d y de d·(1 + separacion), con 100 000 distancias d de cerca a lejos
/// repartidas por igual en el logaritmo: tantas entre 1 m y 2 m como entre 100 m y 200 m.
template<class T>
ParesMal cuentaPares(double cerca, double lejos, double separacion, int bits) {
    const int n = 100000;
    int iguales = 0, invertidos = 0;
    for (int i = 0; i < n; ++i) {
        const double d = cerca * std::pow(lejos / cerca, (i + 0.5) / n);
        const auto valor = [&](double distancia) {
            return enBuffer(profundidad(T(distancia), T(cerca), T(lejos)), bits);
        };
        const double delante = valor(d), detras = valor(d * (1 + separacion));
        iguales += detras == delante;
        invertidos += detras < delante;
    }
    return {double(iguales) / n, double(invertidos) / n};
}
