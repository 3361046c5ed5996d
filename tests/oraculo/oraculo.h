// Referencia en doble precisión de lo que deben dibujar los programas: trazado de rayos de unos pocos
// sólidos, términos de Phong, cobertura exacta y comparación con la imagen de la GPU. No comparte código
// numérico con los programas, ni con common/, ni con GLM: de common/ solo toma Imagen, como caja de píxeles.
// Ángulos en radianes; en las imágenes, la fila 0 es la de abajo. Una escena:
//   const Camara camara = perspectiva(orbita(0.5, 0.25, 23, {1.5, 5.2, 0}), 0.6, 1, 100);
//   const Escena escena = {caja(traslada({0, 5, 0}) * escala({0.8, 10, 0.8})), esfera(traslada({2, 1, 0}))};
//   const ImagenRef ref = render(escena, camara, 240, 180, [&](const Impacto &i) { … });
//   const Comparacion c = compara(ejecuta("ch…/programa").imagen, ref);
#pragma once
#include "imagen.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <ostream>
#include <stdexcept>
#include <vector>

namespace oraculo {

const double PI = 3.14159265358979323846;
const double INFINITO = std::numeric_limits<double>::infinity();

// --- Vectores y matrices -----------------------------------------------------------------------------------

struct Vec3 {
    double x = 0, y = 0, z = 0;
    double operator[](int i) const {
        return i == 0 ? x : i == 1 ? y : z;
    }
};
inline Vec3 operator+(const Vec3 &a, const Vec3 &b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec3 operator-(const Vec3 &a, const Vec3 &b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3 operator-(const Vec3 &a) {
    return {-a.x, -a.y, -a.z};
}
inline Vec3 operator*(const Vec3 &a, const Vec3 &b) { // componente a componente: coeficiente por luz
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}
inline Vec3 operator*(double k, const Vec3 &a) {
    return {k * a.x, k * a.y, k * a.z};
}
inline double escalar(const Vec3 &a, const Vec3 &b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec3 vectorial(const Vec3 &a, const Vec3 &b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double longitud(const Vec3 &a) {
    return std::sqrt(escalar(a, a));
}
/// Vector unitario; el nulo se queda nulo.
inline Vec3 unitario(const Vec3 &a) {
    const double l = longitud(a);
    return l > 0 ? (1 / l) * a : Vec3{};
}
/// Dirección d tras rebotar en una superficie de normal unitaria n.
inline Vec3 refleja(const Vec3 &d, const Vec3 &n) {
    return d - 2 * escalar(d, n) * n;
}

/// Matriz por FILAS, como se escribe en el papel: f[fila][columna]. Por defecto, la identidad.
struct Mat4 {
    double f[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
};
inline Mat4 operator*(const Mat4 &a, const Mat4 &b) {
    Mat4 r;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            r.f[i][j] = 0;
            for (int k = 0; k < 4; ++k)
                r.f[i][j] += a.f[i][k] * b.f[k][j];
        }
    return r;
}
inline Mat4 traslada(const Vec3 &t) {
    return {{{1, 0, 0, t.x}, {0, 1, 0, t.y}, {0, 0, 1, t.z}, {0, 0, 0, 1}}};
}
inline Mat4 escala(const Vec3 &s) {
    return {{{s.x, 0, 0, 0}, {0, s.y, 0, 0}, {0, 0, s.z, 0}, {0, 0, 0, 1}}};
}
inline Mat4 escala(double s) {
    return escala({s, s, s});
}
/// Giro alrededor de un eje que pasa por el origen (Rodrigues), en el sentido de la mano derecha.
inline Mat4 gira(const Vec3 &eje, double angulo) {
    const Vec3 e = unitario(eje);
    const double c = std::cos(angulo), s = std::sin(angulo), v = 2 * std::pow(std::sin(angulo / 2), 2);
    return {{{c + v * e.x * e.x, v * e.x * e.y - s * e.z, v * e.x * e.z + s * e.y, 0},
             {v * e.x * e.y + s * e.z, c + v * e.y * e.y, v * e.y * e.z - s * e.x, 0},
             {v * e.x * e.z - s * e.y, v * e.y * e.z + s * e.x, c + v * e.z * e.z, 0},
             {0, 0, 0, 1}}};
}
/// M·(v, w), sin dividir por la cuarta componente.
inline Vec3 porVector(const Mat4 &M, const Vec3 &v, double w) {
    const auto fila = [&](int i) {
        return M.f[i][0] * v.x + M.f[i][1] * v.y + M.f[i][2] * v.z + M.f[i][3] * w;
    };
    return {fila(0), fila(1), fila(2)};
}
inline Vec3 punto(const Mat4 &M, const Vec3 &p) {
    return porVector(M, p, 1);
}
inline Vec3 direccion(const Mat4 &M, const Vec3 &v) {
    return porVector(M, v, 0);
}
/// Inversa de una transformación afín. Una que aplasta no la tiene: el objeto aplastado es un plano.
inline Mat4 inversa(const Mat4 &M) {
    const auto columna = [&](int j) { return Vec3{M.f[0][j], M.f[1][j], M.f[2][j]}; };
    const Vec3 a = columna(0), b = columna(1), c = columna(2), t = columna(3);
    const double det = escalar(a, vectorial(b, c));
    if (det == 0 || !std::isfinite(det))
        throw std::invalid_argument("oráculo: la transformación no tiene inversa");
    const Vec3 filas[3] = {(1 / det) * vectorial(b, c), (1 / det) * vectorial(c, a),
                           (1 / det) * vectorial(a, b)};
    Mat4 r;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            r.f[i][j] = filas[i][j];
        r.f[i][3] = -escalar(filas[i], t);
    }
    return r;
}
/// Normal unitaria por la traspuesta de la inversa, que aquí se recibe ya calculada.
inline Vec3 transformaNormal(const Mat4 &inv, const Vec3 &n) {
    return unitario({inv.f[0][0] * n.x + inv.f[1][0] * n.y + inv.f[2][0] * n.z,
                     inv.f[0][1] * n.x + inv.f[1][1] * n.y + inv.f[2][1] * n.z,
                     inv.f[0][2] * n.x + inv.f[1][2] * n.y + inv.f[2][2] * n.z});
}

// --- Cámara ------------------------------------------------------------------------------------------------

/// origen + t·direccion, con t entre minimo y maximo. La dirección es unitaria: t es una distancia.
struct Rayo {
    Vec3 origen, direccion;
    double minimo = 0, maximo = INFINITO;
};

struct Camara {
    Vec3 ojo, centro{0, 0, -1}, arriba{0, 1, 0};
    bool esParalela = true;
    double semilado = 1; // mitad del lado MENOR de la ventana; en perspectiva, a distancia 1 del ojo
    double cerca = -1, lejos = 1;
};
inline Camara miraDesde(const Vec3 &ojo, const Vec3 &centro, const Vec3 &arriba = {0, 1, 0}) {
    Camara c;
    c.ojo = ojo, c.centro = centro, c.arriba = arriba;
    return c;
}
/// La de common/orbita.h: desde +Z, sube `elevacion` (giro alrededor de X) y luego gira `azimut` alrededor de
/// Y.
inline Camara orbita(double azimut, double elevacion, double distancia, const Vec3 &centro = {}) {
    const Mat4 giro = gira({0, 1, 0}, azimut) * gira({1, 0, 0}, -elevacion);
    return miraDesde(centro + direccion(giro, {0, 0, distancia}), centro);
}
/// perspectivaVentana: `angulo` abarca el lado menor.
inline Camara perspectiva(Camara c, double angulo, double cerca, double lejos) {
    c.esParalela = false, c.semilado = std::tan(angulo / 2), c.cerca = cerca, c.lejos = lejos;
    return c;
}
/// paralelaVentana: [−semilado, semilado] en el lado menor.
inline Camara paralela(Camara c, double semilado, double cerca = -1, double lejos = 1) {
    c.esParalela = true, c.semilado = semilado, c.cerca = cerca, c.lejos = lejos;
    return c;
}

/// Los ejes de la cámara en el mundo; se mira hacia −z.
struct Ejes {
    Vec3 x, y, z;
};
inline Ejes ejes(const Camara &c) {
    const Vec3 z = unitario(c.ojo - c.centro), x = unitario(vectorial(c.arriba, z));
    if (longitud(x) == 0)
        throw std::invalid_argument("oráculo: la cámara no tiene vertical");
    return {x, vectorial(z, x), z};
}
/// Coordenadas de cámara de un punto del mundo.
inline Vec3 enCamara(const Camara &c, const Vec3 &p) {
    const Ejes e = ejes(c);
    const Vec3 v = p - c.ojo;
    return {escalar(v, e.x), escalar(v, e.y), escalar(v, e.z)};
}
/// Rayo por el punto (px, py) de la ventana, en píxeles: el centro del píxel (x, y) es (x + 0.5, y + 0.5).
inline Rayo rayo(const Camara &c, int ancho, int alto, double px, double py) {
    const Ejes e = ejes(c);
    const double porPixel = 2 * c.semilado / std::min(ancho, alto);
    const Vec3 v = porPixel * (px - 0.5 * ancho) * e.x + porPixel * (py - 0.5 * alto) * e.y;
    if (c.esParalela)
        return {c.ojo + v, -e.z, c.cerca, c.lejos};
    const double oblicuo = longitud(v - e.z); // cerca y lejos se miden a lo largo de −z
    return {c.ojo, unitario(v - e.z), c.cerca * oblicuo, c.lejos * oblicuo};
}
/// Coordenadas de ventana (x e y en píxeles, z la profundidad de 0 a 1) de un punto que está delante del ojo.
inline Vec3 proyecta(const Camara &c, int ancho, int alto, const Vec3 &p) {
    const Vec3 q = enCamara(c, p);
    const double d = -q.z, k = 0.5 * std::min(ancho, alto) / (c.esParalela ? c.semilado : c.semilado * d);
    const double z = c.esParalela ? (d - c.cerca) / (c.lejos - c.cerca)
                                  : (1 / c.cerca - 1 / d) / (1 / c.cerca - 1 / c.lejos);
    return {0.5 * ancho + k * q.x, 0.5 * alto + k * q.y, z};
}

// --- Objetos -----------------------------------------------------------------------------------------------

struct Vertice {
    Vec3 posicion, normal;
    double s = 0, t = 0;
};
/// Triángulos sueltos y una jerarquía de cajas para no probarlos todos. `zona`: los que se tocan por vértices
/// compartidos tienen la misma, así que cambia donde la malla repite vértices porque cambia la normal.
struct Triangulos {
    struct Nodo {
        Vec3 minimo, maximo;
        int primero, cuantos, derecha; // hoja si cuantos > 0; el hijo izquierdo es el nodo siguiente
    };
    std::vector<Vertice> vertices;
    std::vector<std::array<std::size_t, 3>> indices;
    std::vector<int> zona, orden;
    std::vector<Nodo> nodos;

    const Vec3 &esquina(int triangulo, std::size_t k) const {
        return vertices[indices[static_cast<std::size_t>(triangulo)][k]].posicion;
    }
    void calculaZonas() {
        std::vector<std::size_t> padre(vertices.size());
        std::iota(padre.begin(), padre.end(), std::size_t{0});
        const auto raiz = [&](std::size_t i) {
            while (padre[i] != i)
                i = padre[i] = padre[padre[i]];
            return i;
        };
        for (const auto &t : indices)
            padre[raiz(t[1])] = raiz(t[0]), padre[raiz(t[2])] = raiz(t[0]);
        for (const auto &t : indices)
            zona.push_back(static_cast<int>(raiz(t[0])));
        orden.resize(indices.size());
        std::iota(orden.begin(), orden.end(), 0);
    }
    void agrupa(int primero, int cuantos) {
        Nodo n{{INFINITO, INFINITO, INFINITO}, {-INFINITO, -INFINITO, -INFINITO}, primero, cuantos, 0};
        const auto inicio = orden.begin() + primero;
        for (auto i = inicio; i != inicio + cuantos; ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3 &p = esquina(*i, k);
                n.minimo = {std::min(n.minimo.x, p.x), std::min(n.minimo.y, p.y), std::min(n.minimo.z, p.z)};
                n.maximo = {std::max(n.maximo.x, p.x), std::max(n.maximo.y, p.y), std::max(n.maximo.z, p.z)};
            }
        const std::size_t este = nodos.size();
        nodos.push_back(n);
        if (cuantos <= 4)
            return;
        const Vec3 lado = n.maximo - n.minimo;
        const int eje = lado.x >= lado.y && lado.x >= lado.z ? 0 : lado.y >= lado.z ? 1 : 2;
        std::nth_element(inicio, inicio + cuantos / 2, inicio + cuantos, [&](int a, int b) {
            const auto suma = [&](int t) {
                return esquina(t, 0)[eje] + esquina(t, 1)[eje] + esquina(t, 2)[eje];
            };
            return suma(a) < suma(b);
        });
        nodos[este].cuantos = 0;
        agrupa(primero, cuantos / 2);
        nodos[este].derecha = static_cast<int>(nodos.size());
        agrupa(primero + cuantos / 2, cuantos - cuantos / 2);
    }
};

/// Un sólido en sus coordenadas y la transformación afín que lo lleva al mundo.
struct Objeto {
    enum Forma { ESFERA, CAJA, CILINDRO, CONO, TORO, PLANO, MALLA } forma;
    Mat4 M, inv;
    double radio = 0, radioTubo = 0;
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
    o.radio = radio, o.radioTubo = radioTubo;
    return o;
}
inline Objeto malla(const Mat4 &M, std::vector<Vertice> vertices,
                    std::vector<std::array<std::size_t, 3>> indices) {
    auto t = std::make_shared<Triangulos>();
    t->vertices = std::move(vertices), t->indices = std::move(indices);
    t->calculaZonas();
    if (!t->indices.empty())
        t->agrupa(0, static_cast<int>(t->indices.size()));
    Objeto o{Objeto::MALLA, M};
    o.triangulos = t;
    return o;
}
/// La misma malla que dibuja un programa: la Malla de common/malla.h, o cualquiera con esos nombres.
template<class UnaMalla>
Objeto malla(const Mat4 &M, const UnaMalla &m) {
    std::vector<Vertice> vertices;
    for (const auto &v : m.vertices)
        vertices.push_back({{v.posicion.x, v.posicion.y, v.posicion.z},
                            {v.normal.x, v.normal.y, v.normal.z},
                            v.coordTextura.x,
                            v.coordTextura.y});
    std::vector<std::array<std::size_t, 3>> indices;
    for (std::size_t i = 0; i + 2 < m.indices.size(); i += 3)
        indices.push_back({m.indices[i], m.indices[i + 1], m.indices[i + 2]});
    return malla(M, std::move(vertices), std::move(indices));
}

// --- Intersecciones ----------------------------------------------------------------------------------------

/// Corte más cercano encontrado: `cara` es 0 a 5 en la caja (−x +x −y +y −z +z), 0 el lado y 1 y 2 las tapas
/// de abajo y de arriba en cilindro y cono, la zona en una malla y 0 en los demás.
struct Corte {
    double t;
    int cara = 0, triangulo = -1;
    double b1 = 0, b2 = 0; // coordenadas baricéntricas del segundo y del tercer vértice

    void propon(double otra, double minimo, int laCara = 0) { // con otra = NaN no pasa nada
        if (otra > minimo && otra < t)
            t = otra, cara = laCara;
    }
};

/// Raíces de a·t² + 2·b·t + c sin restar números parecidos; NaN o infinito si no hay.
inline std::array<double, 2> raices(double a, double b, double c) {
    const double q = -(b + std::copysign(std::sqrt(b * b - a * c), b));
    return {q / a, c / q};
}
/// Raíces simples de p[0] + p[1]·t + … + p[n]·tⁿ en [desde, hasta]: entre dos raíces seguidas de la derivada
/// es monótono y basta bisecar. Una raíz doble es un rayo tangente, que da igual perder.
template<std::size_t N>
std::vector<double> raicesPolinomio(const std::array<double, N> &p, double desde, double hasta) {
    std::vector<double> encontradas;
    if constexpr (N > 1) {
        std::array<double, N - 1> derivada;
        for (std::size_t i = 1; i < N; ++i)
            derivada[i - 1] = static_cast<double>(i) * p[i];
        std::vector<double> cortes = raicesPolinomio(derivada, desde, hasta);
        cortes.push_back(hasta);
        const auto valor = [&](double t) {
            return std::accumulate(p.rbegin(), p.rend(), 0.0, [&](double v, double k) { return v * t + k; });
        };
        double a = desde;
        for (const double b : cortes) {
            double bajo = a, alto = b;
            const bool sube = valor(a) < 0;
            if (sube != (valor(b) < 0)) {
                for (int i = 0; i < 60 && bajo < alto; ++i) {
                    const double medio = 0.5 * (bajo + alto);
                    ((valor(medio) < 0) == sube ? bajo : alto) = medio;
                }
                encontradas.push_back(0.5 * (bajo + alto));
            }
            a = b;
        }
    }
    return encontradas;
}

inline void cortaCaja(const Vec3 &o, const Vec3 &d, double minimo, Corte &c) {
    double entra = -INFINITO, sale = INFINITO;
    int caraEntra = 0, caraSale = 0;
    for (int eje = 0; eje < 3; ++eje) {
        if (d[eje] == 0 && std::fabs(o[eje]) > 0.5)
            return;
        if (d[eje] == 0)
            continue;
        const double s = d[eje] > 0 ? 0.5 : -0.5, cerca = (-s - o[eje]) / d[eje],
                     lejos = (s - o[eje]) / d[eje];
        if (cerca > entra)
            entra = cerca, caraEntra = 2 * eje + (s < 0);
        if (lejos < sale)
            sale = lejos, caraSale = 2 * eje + (s > 0);
    }
    if (entra <= sale) {
        c.propon(entra, minimo, caraEntra);
        c.propon(sale, minimo, caraSale);
    }
}

inline void cortaMalla(const Triangulos &m, std::size_t nodo, const Vec3 &o, const Vec3 &d, double minimo,
                       Corte &c) {
    const Triangulos::Nodo &n = m.nodos[nodo];
    double entra = minimo, sale = c.t;
    for (int eje = 0; eje < 3; ++eje) {
        const double a = (n.minimo[eje] - o[eje]) / d[eje], b = (n.maximo[eje] - o[eje]) / d[eje];
        entra = std::fmax(entra, std::fmin(a, b)); // fmax y fmin no hacen caso del NaN de 0/0
        sale = std::fmin(sale, std::fmax(a, b));
    }
    if (entra > sale + 1e-12 * (1 + std::fabs(sale)))
        return;
    if (n.cuantos == 0) {
        cortaMalla(m, nodo + 1, o, d, minimo, c);
        cortaMalla(m, static_cast<std::size_t>(n.derecha), o, d, minimo, c);
    }
    for (int i = n.primero; i < n.primero + n.cuantos; ++i) {
        const int t = m.orden[static_cast<std::size_t>(i)];
        const Vec3 a = m.esquina(t, 0), ab = m.esquina(t, 1) - a, ac = m.esquina(t, 2) - a;
        const Vec3 normal = vectorial(ab, ac), w = vectorial(o - a, d);
        const double det = -escalar(d, normal), b1 = escalar(ac, w) / det, b2 = -escalar(ab, w) / det;
        const double corte = escalar(o - a, normal) / det;
        if (b1 < -1e-12 || b2 < -1e-12 || b1 + b2 > 1 + 1e-12 || !(corte > minimo && corte < c.t))
            continue; // la holgura evita rendijas en las aristas
        c = {corte, m.zona[static_cast<std::size_t>(t)], t, b1, b2};
    }
}

/// Mejora `c` con los cortes del objeto y el rayo, en el mundo, más allá de `minimo`.
inline bool corta(const Objeto &objeto, const Rayo &r, Corte &c) {
    Vec3 o = punto(objeto.inv, r.origen);
    const Vec3 d = direccion(objeto.inv, r.direccion);
    // Se empieza por el punto del rayo más cercano al centro: así los números son del tamaño del objeto.
    const double salto = -escalar(o, d) / escalar(d, d), minimo = r.minimo - salto, antes = c.t;
    o = o + salto * d;
    c.t -= salto;
    const double tope = c.t, a = escalar(d, d), axy = d.x * d.x + d.y * d.y, bxy = o.x * d.x + o.y * d.y,
                 cxy = o.x * o.x + o.y * o.y;
    const auto enTapa = [&](double z, int cara) {
        const double t = (z - o.z) / d.z;
        if (std::hypot(o.x + t * d.x, o.y + t * d.y) <= 1)
            c.propon(t, minimo, cara);
    };
    switch (objeto.forma) {
    case Objeto::ESFERA:
        for (const double t : raices(a, 0, escalar(o, o) - 1))
            c.propon(t, minimo);
        break;
    case Objeto::CAJA: cortaCaja(o, d, minimo, c); break;
    case Objeto::CILINDRO:
        for (const double t : raices(axy, bxy, cxy - 1))
            if (std::fabs(o.z + t * d.z) <= 0.5)
                c.propon(t, minimo, 0);
        enTapa(-0.5, 1);
        enTapa(0.5, 2);
        break;
    case Objeto::CONO: // x² + y² = (1 − z)²
        for (const double t : raices(axy - d.z * d.z, bxy + (1 - o.z) * d.z, cxy - (1 - o.z) * (1 - o.z)))
            if (o.z + t * d.z >= 0 && o.z + t * d.z <= 1)
                c.propon(t, minimo, 0);
        enTapa(0, 1);
        break;
    case Objeto::TORO: { // (|p|² + R² − r²)² = 4·R²·(x² + y²), con o·d = 0
        const double R = objeto.radio, r2 = objeto.radioTubo, oo = escalar(o, o), k = oo + R * R - r2 * r2;
        const double fuera = ((R + r2) * (R + r2) - oo) / a; // la esfera que lo contiene
        if (fuera <= 0)
            break;
        const double alcance = 1.001 * std::sqrt(fuera);
        for (const double t : raicesPolinomio<5>(
                 {k * k - 4 * R * R * cxy, -8 * R * R * bxy, 2 * a * k - 4 * R * R * axy, 0, a * a}, -alcance,
                 alcance))
            c.propon(t, minimo);
        break;
    }
    case Objeto::PLANO: {
        const double t = -o.z / d.z;
        if (std::fabs(o.x + t * d.x) <= 0.5 && std::fabs(o.y + t * d.y) <= 0.5)
            c.propon(t, minimo);
        break;
    }
    case Objeto::MALLA:
        if (!objeto.triangulos->nodos.empty())
            cortaMalla(*objeto.triangulos, 0, o, d, minimo, c);
    }
    const bool mejora = c.t < tope;
    c.t = mejora ? c.t + salto : antes;
    return mejora;
}

/// Lo que ve un rayo. Si no ve nada, `objeto` es −1 y solo vale `rayo`.
struct Impacto {
    Rayo rayo;
    int objeto = -1;      // posición en la escena
    double distancia = 0; // desde el origen del rayo
    Vec3 punto, normal;   // en el mundo; normal unitaria, hacia fuera aunque se mire desde dentro
    double s = 0, t = 0;  // coordenadas de textura, las de common/malla.h sin el error de las facetas
    bool frente = true;   // se ve la cara de fuera
    Corte corte;          // cara, triángulo y coordenadas baricéntricas
    Vec3 normalCara;      // en una malla, la del triángulo; `normal` es la interpolada y normalizada

    explicit operator bool() const {
        return objeto >= 0;
    }
};

/// Fracción de vuelta de 0 a 1 del ángulo de (x, y).
inline double vuelta(double x, double y) {
    const double v = std::atan2(y, x) / (2 * PI);
    return v < 0 ? v + 1 : v;
}

/// Normal y coordenadas de textura, en coordenadas del objeto, del punto p que ha dado `corte`.
inline void superficie(const Objeto &objeto, const Corte &corte, const Vec3 &p, Impacto &i) {
    const bool tapa = corte.cara > 0;
    const double rho = std::hypot(p.x, p.y);
    switch (objeto.forma) {
    case Objeto::ESFERA:
        i.normal = p;
        i.s = vuelta(p.x, p.y), i.t = std::atan2(rho, -p.z) / PI;
        break;
    case Objeto::CAJA: {
        const int eje = corte.cara / 2;
        const double lado = corte.cara % 2 ? 1 : -1;
        i.normal = {eje == 0 ? lado : 0, eje == 1 ? lado : 0, eje == 2 ? lado : 0};
        i.s = p[(eje + 1) % 3] + 0.5, i.t = lado * p[(eje + 2) % 3] + 0.5;
        break;
    }
    case Objeto::CILINDRO:
        i.normal = tapa ? Vec3{0, 0, corte.cara == 2 ? 1.0 : -1.0} : Vec3{p.x, p.y, 0};
        i.s = tapa ? 0.5 + 0.5 * p.x : vuelta(p.x, p.y), i.t = tapa ? 0.5 + 0.5 * p.y : p.z + 0.5;
        break;
    case Objeto::CONO:
        i.normal = tapa ? Vec3{0, 0, -1} : Vec3{p.x, p.y, rho};
        i.s = tapa ? 0.5 + 0.5 * p.x : vuelta(p.x, p.y), i.t = tapa ? 0.5 + 0.5 * p.y : p.z;
        break;
    case Objeto::TORO:
        i.normal = p - (objeto.radio / rho) * Vec3{p.x, p.y, 0};
        i.s = vuelta(p.x, p.y), i.t = vuelta(rho - objeto.radio, p.z);
        break;
    case Objeto::PLANO:
        i.normal = {0, 0, 1};
        i.s = p.x + 0.5, i.t = p.y + 0.5;
        break;
    case Objeto::MALLA: {
        const auto &tri = objeto.triangulos->indices[static_cast<std::size_t>(corte.triangulo)];
        const Vertice &v0 = objeto.triangulos->vertices[tri[0]], &v1 = objeto.triangulos->vertices[tri[1]],
                      &v2 = objeto.triangulos->vertices[tri[2]];
        const double b0 = 1 - corte.b1 - corte.b2;
        i.normal = b0 * v0.normal + corte.b1 * v1.normal + corte.b2 * v2.normal;
        i.normalCara = vectorial(v1.posicion - v0.posicion, v2.posicion - v0.posicion);
        i.s = b0 * v0.s + corte.b1 * v1.s + corte.b2 * v2.s,
        i.t = b0 * v0.t + corte.b1 * v1.t + corte.b2 * v2.t;
    }
    }
    if (objeto.forma != Objeto::MALLA)
        i.normalCara = i.normal;
}

/// Primer objeto que ve el rayo.
inline Impacto primerImpacto(const Escena &escena, const Rayo &r) {
    Impacto i;
    i.rayo = r;
    i.corte.t = r.maximo;
    for (std::size_t k = 0; k < escena.size(); ++k)
        if (corta(escena[k], r, i.corte))
            i.objeto = static_cast<int>(k);
    if (!i)
        return i;
    const Objeto &objeto = escena[static_cast<std::size_t>(i.objeto)];
    i.distancia = i.corte.t;
    i.punto = r.origen + i.distancia * r.direccion;
    superficie(objeto, i.corte, punto(objeto.inv, i.punto), i);
    i.normal = transformaNormal(objeto.inv, i.normal);
    i.normalCara = transformaNormal(objeto.inv, i.normalCara);
    i.frente = escalar(i.normalCara, r.direccion) < 0;
    return i;
}

/// Rayo que sale de la superficie, separado de ella lo justo para no volver a cortarla.
inline Rayo rayoDesde(const Vec3 &p, const Vec3 &hacia, double maximo = INFINITO) {
    return {p, unitario(hacia), 1e-7, maximo};
}
/// El rebote en un espejo: primerImpacto(escena, rebote(i)).
inline Rayo rebote(const Impacto &i) {
    return rayoDesde(i.punto, refleja(i.rayo.direccion, i.normal));
}

// --- Iluminación (ecuaciones 5.1 a 5.7) --------------------------------------------------------------------

struct Material {
    Vec3 ka, kd, ks;
    double alfa = 1;
};
struct Luz {
    Vec3 posicion; // con w = 0, dirección HACIA la luz
    double w = 1;
    Vec3 Ld{1, 1, 1}, Ls{1, 1, 1};
    double a = 1, b = 0, c = 0; // atenuación 1/(a + b·d + c·d²); no se aplica si w = 0
    bool foco = false;
    Vec3 S{0, 0, -1};  // hacia dónde apunta el foco
    double delta = PI; // semiángulo de su cono
    double exponente = 0;
};

/// Vector unitario hacia la luz; nulo si el punto está en la propia luz.
inline Vec3 haciaLuz(const Luz &luz, const Vec3 &p) {
    return unitario(luz.w == 0 ? luz.posicion : luz.posicion - p);
}
/// Lo que llega de la luz a p: atenuación por distancia y por el cono del foco. Con a + b·d + c·d² = 0 el
/// factor es enorme pero finito: el color se satura y nunca hay NaN.
inline double atenuacion(const Luz &luz, const Vec3 &p) {
    const double d = longitud(luz.posicion - p), denominador = luz.a + luz.b * d + luz.c * d * d;
    double factor = luz.w == 0 ? 1 : 1 / std::max(denominador, 1e-300);
    if (luz.foco) { // el ángulo por atan2: el acos pierde las cifras cerca del eje
        const Vec3 L = haciaLuz(luz, p), S = unitario(luz.S);
        const double coseno = -escalar(L, S), angulo = std::atan2(longitud(vectorial(L, S)), coseno);
        factor *= angulo > luz.delta ? 0 : std::pow(std::max(coseno, 0.0), luz.exponente);
    }
    return factor;
}
/// Términos difuso y especular de una luz. Valen 0 si L·N ≤ 0. R·V negativo cuenta como 0, y 0 elevado a 0
/// es 1: con alfa = 0 el especular es constante en toda la parte iluminada. N y V unitarios; V va hacia el
/// ojo.
inline Vec3 difusaYEspecular(const Material &m, const Luz &luz, const Vec3 &p, const Vec3 &N, const Vec3 &V) {
    const Vec3 L = haciaLuz(luz, p);
    const double NL = escalar(N, L);
    if (!(NL > 0))
        return {};
    const Vec3 R = 2 * NL * N - L;
    return atenuacion(luz, p) *
           (NL * (m.kd * luz.Ld) + std::pow(std::max(escalar(R, V), 0.0), m.alfa) * (m.ks * luz.Ls));
}
/// Ecuación 5.7: el ambiente una sola vez y la suma de las luces.
inline Vec3 phong(const Material &m, const Vec3 &La, const std::vector<Luz> &luces, const Vec3 &p,
                  const Vec3 &N, const Vec3 &V) {
    Vec3 color = m.ka * La;
    for (const Luz &luz : luces)
        color = color + difusaYEspecular(m, luz, p, N, V);
    return color;
}
/// Si algún objeto de `tapan` se interpone entre p y la luz.
inline bool enSombra(const Escena &tapan, const Vec3 &p, const Luz &luz) {
    const Rayo r = rayoDesde(p, haciaLuz(luz, p), luz.w == 0 ? INFINITO : longitud(luz.posicion - p));
    return std::any_of(tapan.begin(), tapan.end(), [&](const Objeto &o) {
        Corte c{r.maximo};
        return corta(o, r, c);
    });
}

/// Cara (GL_TEXTURE_CUBE_MAP_POSITIVE_X + cara) y (s, t) que elige OpenGL para la dirección d, según la tabla
/// de su especificación; la ecuación 8.1 es lo mismo.
struct CaraCubo {
    int cara;
    double s, t;
};
inline CaraCubo caraDelCubo(const Vec3 &d) {
    const double x = std::fabs(d.x), y = std::fabs(d.y), z = std::fabs(d.z);
    const auto cara = [](int n, double sc, double tc, double ma) {
        return CaraCubo{n, 0.5 * (sc / ma + 1), 0.5 * (tc / ma + 1)};
    };
    if (x >= y && x >= z)
        return d.x > 0 ? cara(0, -d.z, -d.y, x) : cara(1, d.z, -d.y, x);
    if (y >= z)
        return d.y > 0 ? cara(2, d.x, d.z, y) : cara(3, d.x, -d.z, y);
    return d.z > 0 ? cara(4, d.x, -d.y, z) : cara(5, -d.x, -d.y, z);
}

// --- Cobertura exacta en la ventana ------------------------------------------------------------------------

struct Vec2 {
    double x, y;
};
using Poligono = std::vector<Vec2>;

/// Área con signo: positiva si gira en sentido antihorario.
inline double area(const Poligono &p) {
    double a = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Vec2 &u = p[i], &v = p[(i + 1) % p.size()];
        a += 0.5 * ((u.x - p[0].x) * (v.y - p[0].y) - (u.y - p[0].y) * (v.x - p[0].x));
    }
    return a;
}
/// Distancia con signo a la recta del lado más próximo de un polígono convexo: positiva dentro. Para la
/// cobertura sin antialiasing, en el centro (x + 0.5, y + 0.5) del píxel.
inline double distanciaDentro(const Poligono &convexo, double x, double y) {
    double d = INFINITO;
    const double sentido = area(convexo) < 0 ? -1 : 1;
    for (std::size_t i = 0; i < convexo.size(); ++i) {
        const Vec2 &u = convexo[i], &v = convexo[(i + 1) % convexo.size()];
        const double dx = v.x - u.x, dy = v.y - u.y;
        d = std::min(d, sentido * (dx * (y - u.y) - dy * (x - u.x)) / std::hypot(dx, dy));
    }
    return d;
}
/// Parte del píxel (x, y), de 0 a 1, que cubre el polígono: lo que queda al recortarlo con sus cuatro lados.
inline double coberturaPixel(Poligono p, int x, int y) {
    for (int lado = 0; lado < 4 && !p.empty(); ++lado) {
        const auto dentro = [&](const Vec2 &v) {
            return lado == 0 ? v.x - x : lado == 1 ? x + 1 - v.x : lado == 2 ? v.y - y : y + 1 - v.y;
        };
        Poligono q;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const Vec2 &u = p[i], &v = p[(i + 1) % p.size()];
            const double du = dentro(u), dv = dentro(v);
            if (du >= 0)
                q.push_back(u);
            if ((du >= 0) != (dv >= 0))
                q.push_back({u.x + du / (du - dv) * (v.x - u.x), u.y + du / (du - dv) * (v.y - u.y)});
        }
        p = q;
    }
    return p.empty() ? 0 : std::fabs(area(p));
}

// --- Imágenes de referencia y comparación ------------------------------------------------------------------

/// Lo que devuelve `sombrea`: basta el color; `zona` separa además lo que cambia dentro de una cara (sombra o
/// no, lo que se ve en un espejo, las casillas de una textura).
struct Tono {
    Vec3 color;
    int zona;
    Tono(const Vec3 &elColor = {}, int laZona = 0) : color(elColor), zona(laZona) {
    }
};
struct PixelRef {
    Vec3 color; // 0 a 1, sin recortar ni redondear
    int objeto = -1, cara = 0, zona = 0;
    Vec3 punto, normal;
};
struct ImagenRef {
    int ancho = 0, alto = 0;
    std::vector<PixelRef> pixeles; // primera fila, la de abajo
    const PixelRef &en(int x, int y) const {
        return pixeles[static_cast<std::size_t>(y) * static_cast<std::size_t>(ancho) +
                       static_cast<std::size_t>(x)];
    }
};

/// Un rayo por el centro de cada píxel. `sombrea(impacto)` da el color, o un Tono; también se la llama donde
/// no hay nada (`!impacto`), para el fondo.
template<class Sombrea>
ImagenRef render(const Escena &escena, const Camara &camara, int ancho, int alto, Sombrea sombrea) {
    ImagenRef ref{ancho, alto, {}};
    for (int y = 0; y < alto; ++y)
        for (int x = 0; x < ancho; ++x) {
            const Impacto i = primerImpacto(escena, rayo(camara, ancho, alto, x + 0.5, y + 0.5));
            const Tono tono = sombrea(i);
            ref.pixeles.push_back({tono.color, i.objeto, i.corte.cara, tono.zona, i.punto, i.normalCara});
        }
    return ref;
}

/// Si entre dos píxeles vecinos hay un borde: otro objeto, otra cara, otra zona, o el mismo objeto a otra
/// distancia (uno está lejos del plano tangente del otro).
inline bool hayBorde(const PixelRef &a, const PixelRef &b) {
    if (a.objeto != b.objeto || a.cara != b.cara || a.zona != b.zona)
        return true;
    const Vec3 v = b.punto - a.punto;
    return a.objeto >= 0 &&
           std::max(std::fabs(escalar(v, a.normal)), std::fabs(escalar(v, b.normal))) > 0.5 * longitud(v);
}

/// Errores en niveles de 255, el mayor de los tres componentes, contra el color SIN redondear: guardarlo en 8
/// bits ya cuesta hasta 0.5 de máximo y 0.29 de error cuadrático medio.
struct Comparacion {
    int interior = 0;               // píxeles sin borde en sus 3×3 vecinos
    double maximo = 0, rmse = 0;    // en el interior
    int xMaximo = -1, yMaximo = -1; // dónde está ese máximo
    int banda = 0;                  // los demás
    int bandaDistintos = 0;         // difieren más que el umbral
    int bandaLejos = 0; // … y tampoco se parecen a ninguno de sus vecinos: el borde falla más de un píxel
};
inline std::ostream &operator<<(std::ostream &s, const Comparacion &c) {
    return s << "interior " << c.interior << " px: máximo " << c.maximo << " en (" << c.xMaximo << ", "
             << c.yMaximo << "), rmse " << c.rmse << "; banda " << c.banda << " px: " << c.bandaDistintos
             << " distintos, " << c.bandaLejos << " lejos";
}

/// Diferencia en niveles entre el píxel (x, y) de la GPU y un color de referencia.
inline double diferencia(const Imagen &gpu, int x, int y, const Vec3 &color) {
    double mayor = 0;
    for (int k = 0; k < 3; ++k) {
        const std::size_t i = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(gpu.ancho) +
                                   static_cast<std::size_t>(x));
        mayor = std::max(mayor, std::fabs(gpu.rgb[i + static_cast<std::size_t>(k)] -
                                          255 * std::clamp(color[k], 0.0, 1.0)));
    }
    return mayor;
}

inline Comparacion compara(const Imagen &gpu, const ImagenRef &ref, double umbral = 2) {
    if (gpu.ancho != ref.ancho || gpu.alto != ref.alto)
        throw std::invalid_argument("oráculo: las imágenes no tienen el mismo tamaño");
    Comparacion c;
    double suma = 0;
    for (int y = 0; y < ref.alto; ++y)
        for (int x = 0; x < ref.ancho; ++x) {
            bool borde = false;
            double parecido = INFINITO;
            for (int v = std::max(y - 1, 0); v <= std::min(y + 1, ref.alto - 1); ++v)
                for (int u = std::max(x - 1, 0); u <= std::min(x + 1, ref.ancho - 1); ++u) {
                    borde = borde || hayBorde(ref.en(x, y), ref.en(u, v));
                    parecido = std::min(parecido, diferencia(gpu, x, y, ref.en(u, v).color));
                }
            const double d = diferencia(gpu, x, y, ref.en(x, y).color);
            if (borde) {
                ++c.banda;
                c.bandaDistintos += d > umbral;
                c.bandaLejos += parecido > umbral;
                continue;
            }
            ++c.interior;
            suma += d * d;
            if (!(d <= c.maximo))
                c.maximo = d, c.xMaximo = x, c.yMaximo = y;
        }
    c.rmse = c.interior ? std::sqrt(suma / c.interior) : 0;
    return c;
}

} // namespace oraculo
