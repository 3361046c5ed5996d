// Un caso difícil es una prueba con nombre propio que mide un número y dice cuánto puede valer. Lo medido y su cota
// quedan en el informe de GoogleTest (--gtest_output=json), y de ahí los toma herramientas/pruebas/evidencia.py para
// docs/exactitud.md.
#pragma once
#include "prueba.h"
#include <type_traits>

using Largo = long double; // 64 bits de mantisa

const double U_FLOAT = 0x1p-24; // el redondeo de float, en un número próximo a 1
const double U_DOBLE = 0x1p-53; // y el de double

class Acotada : public testing::Test {
    const double cota;
    const std::string unidad;
    const std::function<double()> mide;

    static std::string texto(double x) {
        std::ostringstream s;
        s << x;
        return s.str();
    }

public:
    Acotada(double laCota, std::string laUnidad, std::function<double()> queMide)
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

/// La prueba `grupo`.`nombre`: lo que da `mide`, en `unidad`, no pasa de `cota`. Se llama antes de main, desde unas
/// Cotas.
inline void acota(const std::string &grupo, const std::string &nombre, double cota, const std::string &unidad,
                  const std::function<double()> &mide) {
    testing::RegisterTest(grupo.c_str(), nombre.c_str(), nullptr, nullptr, __FILE__, __LINE__,
                          [=]() -> testing::Test * { return new Acotada(cota, unidad, mide); });
}

/// Un número en un nombre: «1em20» es 1e-20. Los enteros, con todas sus cifras.
template<class T>
std::string enNombre(T x) {
    std::ostringstream s;
    s << x;
    std::string nombre;
    for (const char c : s.str())
        nombre += c == '-' ? "m" : c == '.' ? "_" : c == '+' ? "" : std::string(1, c);
    return nombre;
}

/// Un valor con el nombre de su caso: el dado o, si es un número, él.
template<class T>
struct Con {
    std::string nombre;
    T valor;
    Con(const T &x) : nombre(enNombre(x)), valor(x) {
    }
    Con(const std::string &comoSeLlama, const T &x) : nombre(comoSeLlama), valor(x) {
    }
};

/// Un caso por valor, cuyo nombre va donde el * de `nombre`. La cota puede depender del valor.
template<class T, class Cota, class Mide>
void acotaCada(const std::string &grupo, const std::string &nombre, const std::vector<Con<T>> &valores,
               const Cota &cota, const std::string &unidad, const Mide &mide) {
    const std::size_t donde = nombre.find('*');
    for (const Con<T> &v : valores) {
        double suya;
        if constexpr (std::is_invocable_v<Cota, T>)
            suya = cota(v.valor);
        else
            suya = cota;
        acota(grupo, std::string(nombre).replace(donde, 1, v.nombre), suya, unidad,
              [mide, x = v.valor] { return mide(x); });
    }
}

struct Cotas {
    template<class Registra>
    explicit Cotas(Registra registra) {
        registra();
    }
};

/// La mayor de varias medidas; un NaN no se pierde.
inline double mayor(double a, double b) {
    return std::isnan(a) || a > b ? a : b;
}

/// La mayor medida de unos valores; de ninguno, NaN.
template<class Valores, class Mide>
double peorDe(const Valores &valores, const Mide &mide) {
    double peor = std::empty(valores) ? NAN : -HUGE_VAL;
    for (const auto &x : valores)
        peor = mayor(double(mide(x)), peor);
    return peor;
}
template<class T, class Mide>
double peorDe(std::initializer_list<T> valores, const Mide &mide) {
    return peorDe(std::vector<T>(valores), mide);
}
/// La de los enteros de 0 a n − 1.
template<class Mide>
double peorHasta(int n, const Mide &mide) {
    std::vector<int> enteros(n);
    std::iota(enteros.begin(), enteros.end(), 0);
    return peorDe(enteros, mide);
}

/// El mayor componente, sin signo, de un vector o una matriz.
template<class V>
double mayorComponente(const V &v) {
    const auto *const uno = glm::value_ptr(v);
    return peorHasta(int(sizeof(V) / sizeof(*uno)), [&](int i) { return double(std::fabs(uno[i])); });
}
