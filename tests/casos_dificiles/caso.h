// Un caso difícil es una prueba con nombre propio que mide un número y dice cuánto puede valer. Lo medido y su cota quedan en el
// informe de GoogleTest (--gtest_output=json), y de ahí los toma tests/laboratorio/evidencia.py para docs/exactitud.md.
#pragma once
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <iostream>
#include <sstream>
#include <string>

class CasoDificil : public testing::Test {
    const double cota;
    const std::string unidad;
    const std::function<double()> mide;

    static std::string texto(double x) {
        std::ostringstream s;
        s << x;
        return s.str();
    }

public:
    CasoDificil(double laCota, std::string laUnidad, std::function<double()> queMide)
        : cota(laCota), unidad(std::move(laUnidad)), mide(std::move(queMide)) {
    }
    void TestBody() override {
        const double medida = mide();
        RecordProperty("medida", texto(medida));
        RecordProperty("cota", texto(cota));
        RecordProperty("unidad", unidad);
        std::cout << medida << " " << unidad << ", cota " << cota << "\n";
        EXPECT_LE(medida, cota) << unidad; // un NaN no es menor que nada
    }
};

/// La prueba `grupo`.`nombre`: lo que da `mide`, en `unidad`, no pasa de `cota`. Se llama antes de main, desde un CASOS {…}.
inline void caso(const std::string &grupo, const std::string &nombre, double cota, const std::string &unidad,
                 const std::function<double()> &mide) {
    testing::RegisterTest(grupo.c_str(), nombre.c_str(), nullptr, nullptr, __FILE__, __LINE__,
                          [=]() -> testing::Test * { return new CasoDificil(cota, unidad, mide); });
}

struct Casos {
    template<class Registra>
    explicit Casos(Registra registra) {
        registra();
    }
};

/// Un número en un nombre: «1em20» es 1e-20.
inline std::string enNombre(double x) {
    std::ostringstream s;
    s << x;
    std::string nombre;
    for (const char c : s.str())
        nombre += c == '-' ? "m" : c == '.' ? "_" : c == '+' ? "" : std::string(1, c);
    return nombre;
}

/// La mayor de varias medidas; un NaN no se pierde.
inline double mayor(double a, double b) {
    return std::isnan(a) || a > b ? a : b;
}

const double U_FLOAT = 0x1p-24; // el redondeo de float, en un número próximo a 1
const double U_DOBLE = 0x1p-53; // y el de double
