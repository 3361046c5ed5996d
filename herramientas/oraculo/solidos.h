// Sólidos del oráculo y lo que ve de ellos un rayo.
#pragma once
#include "camara.h"
#include "triangulos.h"
#include <memory>

namespace oraculo {

/// Un sólido en sus coordenadas y la transformación afín que lo lleva al mundo. Una que aplasta no sirve: lo
/// aplastado es un plano.
struct Objeto {
    enum Forma { ESFERA, CAJA, CILINDRO, PLANO, MALLA };
    Forma forma;
    Mat4 M, inv;
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
inline Objeto plano(const Mat4 &M) { // lado 1 en XY, normal +Z
    return {Objeto::PLANO, M};
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

/// Un rayo en las coordenadas de un objeto, y el corte más cercano que se le encuentra.
struct RayoLocal {
    Vec3 o, d;
    double minimo;
    Corte corte;

    Vec3 en(double t) const {
        return o + t * d;
    }
    void propon(double t, int cara = 0) {
        corte.propon(t, minimo, cara);
    }
    /// De esos cortes con una superficie que no acaba, los que caen entre z0 y z1.
    void lado(const std::array<double, 2> &cortes, double z0 = -INFINITO, double z1 = INFINITO) {
        for (const double t : cortes)
            if (en(t).z >= z0 && en(t).z <= z1)
                propon(t);
    }
    void tapa(double z, int cara) {
        const double t = (z - o.z) / d.z;
        if (std::hypot(en(t).x, en(t).y) <= 1)
            propon(t, cara);
    }
    void caja() {
        double entra = -INFINITO, sale = INFINITO;
        if (!recortaEnCaja({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}, o, d, entra, sale))
            return;
        for (const double t : {entra, sale}) {
            const Vec3 p = en(t), m{std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)};
            const int eje = m.x >= m.y && m.x >= m.z ? 0 : m.y >= m.z ? 1 : 2;
            propon(t, 2 * eje + (p[eje] > 0));
        }
    }
    void plano() {
        const double t = -o.z / d.z;
        if (std::fabs(en(t).x) <= 0.5 && std::fabs(en(t).y) <= 0.5)
            propon(t);
    }
};

/// Mejora `c` con los cortes del objeto y el rayo (en el mundo) que estén más cerca; devuelve si hay alguno.
inline bool corta(const Objeto &objeto, const Rayo &rayo, Corte &c) {
    // Se parte del punto del rayo más cercano al centro (o·d = 0): los números son del tamaño del objeto aunque
    // el ojo esté lejos. d no se normaliza: así t es la misma distancia aquí que en el mundo.
    const Vec3 origen = punto(objeto.inv, rayo.origen), d = direccion(objeto.inv, rayo.direccion);
    const double a = escalar(d, d), salto = -escalar(origen, d) / a, tope = c.t - salto;
    const Vec3 o = origen + salto * d;
    RayoLocal r{o, d, rayo.minimo - salto, {}};
    r.corte.t = tope;
    const double axy = d.x * d.x + d.y * d.y, bxy = o.x * d.x + o.y * d.y, cxy = o.x * o.x + o.y * o.y;
    switch (objeto.forma) {
    case Objeto::ESFERA: r.lado(raices(a, 0, escalar(o, o) - 1)); break;
    case Objeto::CAJA: r.caja(); break;
    case Objeto::CILINDRO:
        r.lado(raices(axy, bxy, cxy - 1), -0.5, 0.5);
        r.tapa(-0.5, 1);
        r.tapa(0.5, 2);
        break;
    case Objeto::PLANO: r.plano(); break;
    case Objeto::MALLA: objeto.triangulos->corta(o, d, r.minimo, r.corte); break;
    }
    if (!(r.corte.t < tope))
        return false;
    c = r.corte;
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
    /// cara: de 0 a 5 en la caja (−x +x −y +y −z +z); en el cilindro, 0 el lado, 1 la tapa de abajo y 2
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
    const double signo = cara % 2 ? 1 : -1;
    const auto pon = [&](const Vec3 &normal, double s, double t) {
        i.normal = i.normalCara = normal;
        i.s = s;
        i.t = t;
    };
    switch (objeto.forma) {
    case Objeto::ESFERA: pon(p, vuelta(p.x, p.y), std::atan2(std::hypot(p.x, p.y), -p.z) / PI); break;
    case Objeto::CAJA: {
        const int eje = cara / 2;
        pon({eje == 0 ? signo : 0, eje == 1 ? signo : 0, eje == 2 ? signo : 0}, p[(eje + 1) % 3] + 0.5,
            signo * p[(eje + 2) % 3] + 0.5);
        break;
    }
    case Objeto::CILINDRO:
        if (cara)
            pon({0, 0, -signo}, 0.5 + 0.5 * p.x, 0.5 + 0.5 * p.y);
        else
            pon({p.x, p.y, 0}, vuelta(p.x, p.y), p.z + 0.5);
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

} // namespace oraculo
