// Lo que usan las perturbaciones de herramientas/ejercicios/perturba.py, además de mutante.h. De lo que no tiene
// sentido no hay plantilla: así no compila y no cuenta.
#pragma once
#include <glm/glm.hpp>
#include <type_traits>

template<class T, class = decltype(T{})>
T otroFactor(const T &x) {
    if constexpr (std::is_same_v<T, bool>)
        return !x;
    else if constexpr (std::is_integral_v<T> || std::is_enum_v<T>)
        return T(int(x) + 1);
    else if constexpr (std::is_floating_point_v<T>)
        return x == 0 ? T(0.25) : T(1.25) * x;
    else
        return T{}; // como si no se le hubiera dado nada
}

template<glm::length_t n, class T>
glm::vec<n, T> otroFactor(glm::vec<n, T> v) {
    return v == glm::vec<n, T>(0) ? glm::vec<n, T>(T(0.25)) : T(1.25) * v;
}

/// Solo la primera columna: toda la matriz, con la w, da el mismo punto.
template<glm::length_t c, glm::length_t f, class T>
glm::mat<c, f, T> otroFactor(glm::mat<c, f, T> M) {
    M[0] *= T(1.25);
    return M;
}
