// Sólidos del oráculo y lo que ve de ellos un rayo.
#pragma once
#include "camara.h"
#include "triangulos.h"
#include <memory>

namespace oraculo {

/// Un sólido en sus coordenadas y la transformación afín que lo lleva al mundo. Una que aplasta no sirve: lo
/// aplastado es un plano.
struct Objeto {
    enum Forma { ESFERA, CAJA, CILINDRO, CONO, TORO, PLANO, MALLA };
    Forma forma;
    Mat4 M, inv;
    double radio = 0, radioTubo = 0; // toro
    std::shared_ptr<const Triangulos> triangulos;

    Objeto(Forma laForma, const Mat4 &laM) : forma(laForma), M(laM), inv(inversa(laM)) {
    }
};
using Escena = std::vector<Objeto>;

inline Objeto esfera(const Mat4 &M) { // radio 1
    return {Objeto::ESFERA, M};
}
inline Objeto caja(const Mat4 &M) { // lado 1, centrada
    return {Objeto::CAJA, M};
}
inline Objeto cilindro(const Mat4 &M) { // radio 1, z de −0.5 a 0.5, con tapas
    return {Objeto::CILINDRO, M};
}
inline Objeto cono(const Mat4 &M) { // base de radio 1 en z = 0, vértice en z = 1, con tapa
    return {Objeto::CONO, M};
}
inline Objeto plano(const Mat4 &M) { // lado 1 en XY, normal +Z
    return {Objeto::PLANO, M};
}
inline Objeto toro(const Mat4 &M, double radio, double radioTubo) { // anillo en el plano XY
    Objeto o{Objeto::TORO, M};
    o.radio = radio;
    o.radioTubo = radioTubo;
    return o;
}
inline Objeto malla(const Mat4 &M, std::vector<VerticeRef> vertices,
                    std::vector<Triangulos::Indices> indices) {
    Objeto o{Objeto::MALLA, M};
    o.triangulos = std::make_shared<const Triangulos>(std::move(vertices), std::move(indices));
    return o;
}
/// La misma malla que dibuja un programa: una Malla de common/malla.h o cualquiera con esos campos.
template<class UnaMalla>
Objeto malla(const Mat4 &M, const UnaMalla &m) {
    std::vector<VerticeRef> vertices;
    for (const auto &v : m.vertices)
        vertices.push_back({{v.posicion.x, v.posicion.y, v.posicion.z},
                            {v.normal.x, v.normal.y, v.normal.z},
                            v.coordTextura.x,
                            v.coordTextura.y});
    std::vector<Triangulos::Indices> indices;
    for (std::size_t i = 0; i + 2 < m.indices.size(); i += 3)
        indices.push_back({m.indices[i], m.indices[i + 1], m.indices[i + 2]});
    return malla(M, std::move(vertices), std::move(indices));
}
/// Un triángulo suelto, antihorario visto desde fuera; (s,t) es (0,0), (1,0) y (0,1).
inline Objeto triangulo(const Vec3 &a, const Vec3 &b, const Vec3 &c) {
    const Vec3 n = unitario(vectorial(b - a, c - a));
    return malla(Mat4{}, {{a, n, 0, 0}, {b, n, 1, 0}, {c, n, 0, 1}}, {{0, 1, 2}});
}

/// Raíces de a·t² + 2·b·t + c sin restar números parecidos; NaN o infinito donde no hay.
inline std::array<double, 2> raices(double a, double b, double c) {
    const double q = -(b + std::copysign(std::sqrt(b * b - a * c), b));
    return {q / a, c / q};
}

/// Raíces de p[0] + p[1]·t + p[2]·t² + … en [desde, hasta], de menor a mayor. Entre dos raíces seguidas de la
/// derivada el polinomio es monótono: basta bisecar donde cambia de signo. No ve las raíces dobles: son los
/// rayos tangentes, que no entran en el sólido.
template<std::size_t N>
std::vector<double> raicesPolinomio(const std::array<double, N> &p, double desde, double hasta) {
    std::vector<double> encontradas;
    if constexpr (N > 1) {
        std::array<double, N - 1> derivada;
        for (std::size_t i = 1; i < N; ++i)
            derivada[i - 1] = double(i) * p[i];
        const auto negativo = [&](double t) {
            double v = 0;
            for (std::size_t i = N; i-- > 0;)
                v = v * t + p[i];
            return v < 0;
        };
        std::vector<double> extremos = raicesPolinomio(derivada, desde, hasta);
        extremos.push_back(hasta);
        double a = desde;
        for (double siguiente : extremos) {
            const bool empieza = negativo(a);
            double b = siguiente;
            if (negativo(b) != empieza) {
                for (int i = 0; i < 60; ++i)
                    (negativo(0.5 * (a + b)) == empieza ? a : b) = 0.5 * (a + b);
                encontradas.push_back(0.5 * (a + b));
            }
            a = siguiente;
        }
    }
    return encontradas;
}

/// Mejora `c` con los cortes del objeto y el rayo (en el mundo) que estén más cerca; devuelve si hay alguno.
inline bool corta(const Objeto &objeto, const Rayo &r, Corte &c) {
    Vec3 o = punto(objeto.inv, r.origen);
    const Vec3 d = direccion(objeto.inv, r.direccion);
    // Se parte del punto del rayo más cercano al centro (o·d = 0): los números son del tamaño del objeto aunque
    // el ojo esté lejos. d no se normaliza: así t es la misma distancia aquí que en el mundo.
    const double a = escalar(d, d), salto = -escalar(o, d) / a, minimo = r.minimo - salto;
    o = o + salto * d;
    Corte local;
    local.t = c.t - salto;
    const double tope = local.t;
    const double axy = d.x * d.x + d.y * d.y, bxy = o.x * d.x + o.y * d.y, cxy = o.x * o.x + o.y * o.y;
    const auto lado = [&](const std::array<double, 2> &cortes, double z0, double z1) {
        for (const double t : cortes)
            if (o.z + t * d.z >= z0 && o.z + t * d.z <= z1)
                local.propon(t, minimo);
    };
    const auto tapa = [&](double z, int cara) {
        const double t = (z - o.z) / d.z;
        if (std::hypot(o.x + t * d.x, o.y + t * d.y) <= 1)
            local.propon(t, minimo, cara);
    };
    switch (objeto.forma) {
    case Objeto::ESFERA: lado(raices(a, 0, escalar(o, o) - 1), -INFINITO, INFINITO); break;
    case Objeto::CAJA: {
        double entra = -INFINITO, sale = INFINITO;
        if (recortaEnCaja({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}, o, d, entra, sale))
            for (const double t : {entra, sale}) {
                const Vec3 p = o + t * d, m{std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)};
                const int eje = m.x >= m.y && m.x >= m.z ? 0 : m.y >= m.z ? 1 : 2;
                local.propon(t, minimo, 2 * eje + (p[eje] > 0));
            }
        break;
    }
    case Objeto::CILINDRO:
        lado(raices(axy, bxy, cxy - 1), -0.5, 0.5);
        tapa(-0.5, 1);
        tapa(0.5, 2);
        break;
    case Objeto::CONO: { // x² + y² = (1 − z)²
        const double h = 1 - o.z;
        lado(raices(axy - d.z * d.z, bxy + h * d.z, cxy - h * h), 0, 1);
        tapa(0, 1);
        break;
    }
    case Objeto::TORO: { // (|p|² + R² − r²)² = 4·R²·(x² + y²), dentro de la esfera de radio R + r
        const double RR = objeto.radio * objeto.radio,
                     alcance2 = std::pow(objeto.radio + objeto.radioTubo, 2);
        const double k = escalar(o, o) + RR - objeto.radioTubo * objeto.radioTubo;
        const std::array<double, 5> p = {k * k - 4 * RR * cxy, -8 * RR * bxy, 2 * a * k - 4 * RR * axy, 0,
                                         a * a};
        if (alcance2 <= escalar(o, o))
            break;
        const double alcance = 1.001 * std::sqrt((alcance2 - escalar(o, o)) / a);
        for (const double t : raicesPolinomio(p, -alcance, alcance))
            local.propon(t, minimo);
        break;
    }
    case Objeto::PLANO: {
        const double t = -o.z / d.z;
        if (std::fabs(o.x + t * d.x) <= 0.5 && std::fabs(o.y + t * d.y) <= 0.5)
            local.propon(t, minimo);
        break;
    }
    case Objeto::MALLA: objeto.triangulos->corta(o, d, minimo, local); break;
    }
    if (!(local.t < tope))
        return false;
    c = local;
    c.t += salto;
    return true;
}

/// Lo que ve un rayo. Si no ve nada, `objeto` es −1 y solo vale `rayo`.
struct Impacto {
    Rayo rayo;
    int objeto = -1;      // posición en la escena
    double distancia = 0; // desde el origen del rayo
    Vec3 punto;           // en el mundo
    Vec3 normal;          // unitaria y hacia fuera, aunque se mire desde dentro; en una malla, la interpolada
    Vec3 normalCara;      // igual, salvo en una malla: la del triángulo
    bool frente = true;   // se ve la cara de fuera
    double s = 0, t = 0;  // coordenadas de textura de common/malla.h, sin el error de sus facetas
    /// cara: de 0 a 5 en la caja (−x +x −y +y −z +z); en cilindro y cono, 0 el lado, 1 la tapa de abajo y 2
    /// la de arriba; la zona en una malla. Con triangulo, b1 y b2 se interpola lo que se quiera sobre la
    /// malla.
    Corte corte;

    explicit operator bool() const {
        return objeto >= 0;
    }
};

/// Ángulo de (x, y) como fracción de vuelta, de 0 a 1.
inline double vuelta(double x, double y) {
    const double v = std::atan2(y, x) / (2 * PI);
    return v < 0 ? v + 1 : v;
}

/// Pone en `i` la normal (sin normalizar) y las coordenadas de textura de p, todo en coordenadas del objeto.
inline void superficie(const Objeto &objeto, const Vec3 &p, Impacto &i) {
    const int cara = i.corte.cara;
    const double rho = std::hypot(p.x, p.y), signo = cara % 2 ? 1 : -1;
    const auto pon = [&](const Vec3 &normal, double s, double t) {
        i.normal = i.normalCara = normal;
        i.s = s;
        i.t = t;
    };
    switch (objeto.forma) {
    case Objeto::ESFERA: pon(p, vuelta(p.x, p.y), std::atan2(rho, -p.z) / PI); break;
    case Objeto::CAJA: {
        const int eje = cara / 2;
        pon({eje == 0 ? signo : 0, eje == 1 ? signo : 0, eje == 2 ? signo : 0}, p[(eje + 1) % 3] + 0.5,
            signo * p[(eje + 2) % 3] + 0.5);
        break;
    }
    case Objeto::CILINDRO:
    case Objeto::CONO:
        if (cara)
            pon({0, 0, -signo}, 0.5 + 0.5 * p.x, 0.5 + 0.5 * p.y);
        else if (objeto.forma == Objeto::CILINDRO)
            pon({p.x, p.y, 0}, vuelta(p.x, p.y), p.z + 0.5);
        else
            pon({p.x, p.y, rho}, vuelta(p.x, p.y), p.z);
        break;
    case Objeto::TORO:
        pon(p - (objeto.radio / rho) * Vec3{p.x, p.y, 0}, vuelta(p.x, p.y), vuelta(rho - objeto.radio, p.z));
        break;
    case Objeto::PLANO: pon({0, 0, 1}, p.x + 0.5, p.y + 0.5); break;
    case Objeto::MALLA: {
        const Triangulos &m = *objeto.triangulos;
        const auto &[v0, v1, v2] = m.indices[i.corte.triangulo];
        const VerticeRef &a = m.vertices[v0], &b = m.vertices[v1], &c = m.vertices[v2];
        const double b1 = i.corte.b1, b2 = i.corte.b2, b0 = 1 - b1 - b2;
        pon(b0 * a.normal + b1 * b.normal + b2 * c.normal, b0 * a.s + b1 * b.s + b2 * c.s,
            b0 * a.t + b1 * b.t + b2 * c.t);
        i.normalCara = vectorial(b.posicion - a.posicion, c.posicion - a.posicion);
        break;
    }
    }
}

/// El primer objeto que ve el rayo.
inline Impacto primerImpacto(const Escena &escena, const Rayo &r) {
    Impacto i;
    i.rayo = r;
    i.corte.t = r.maximo;
    for (std::size_t k = 0; k < escena.size(); ++k)
        if (corta(escena[k], r, i.corte))
            i.objeto = int(k);
    if (!i)
        return i;
    const Objeto &objeto = escena[i.objeto];
    i.distancia = i.corte.t;
    i.punto = r.origen + i.distancia * r.direccion;
    superficie(objeto, punto(objeto.inv, i.punto), i);
    i.normal = transformaNormal(objeto.inv, i.normal);
    i.normalCara = transformaNormal(objeto.inv, i.normalCara);
    i.frente = escalar(i.normalCara, r.direccion) < 0;
    return i;
}

/// V en el modelo de Phong: del punto hacia el ojo.
inline Vec3 haciaOjo(const Impacto &i) {
    return -i.rayo.direccion;
}

/// Rayo que sale de una superficie, separado de ella lo justo para no volver a cortarla.
inline Rayo rayoDesde(const Vec3 &p, const Vec3 &hacia, double maximo = INFINITO) {
    return {p, unitario(hacia), 1e-6, maximo};
}
/// El rebote en un espejo, para llamar a primerImpacto otra vez.
inline Rayo rebote(const Impacto &i) {
    return rayoDesde(i.punto, refleja(i.rayo.direccion, i.normal));
}

} // namespace oraculo
