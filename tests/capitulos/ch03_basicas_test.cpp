// Comprobaciones independientes de basicas, escalado, tres_cubos, cono, elipsoide y orden (capítulo 3). La geometría
// esperada sale del enunciado y se proyecta aquí, en doble precisión; de los programas solo se repiten los
// datos: dónde está la cámara, de qué color es cada cosa y qué elige cada uno donde falta la figura del libro.
#include "ch03_oraculo.h"
#include "ch03_transformaciones/pasos.h"
#include "ejecuta.h"
#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <gtest/gtest.h>
#include <limits>

using glm::dmat3;
using glm::dvec2;
using glm::dvec3;

namespace {

const double PI = std::acos(-1.0), U = std::ldexp(1.0, -24); // U: error relativo de redondear a float

// --- Color: el del objeto por la luz, que objeto.frag deja entre 0.16 y 1 ---

const dvec3 naranja(0.95, 0.55, 0.10), amarillo(0.98, 0.78, 0.15), gris(0.55, 0.58, 0.62),
    morado(0.56, 0.24, 0.66);

bool esDeColor(const Pixel &p, const dvec3 &color) {
    const dvec3 c(p.r, p.g, p.b);
    const double luz = glm::dot(c, color) / glm::dot(color, color) / 255;
    if (luz < 0.14 || luz > 1.02)
        return false;
    const dvec3 error = glm::abs(c - 255 * luz * color); // medio nivel de redondeo en p y en luz·color
    return std::max({error.x, error.y, error.z}) <= 1;
}

// El color exacto de una cara (2·eje + mira a +eje) con la luz de objeto.frag: ±1 nivel, por los redondeos.
bool esCara(const Pixel &p, const dvec3 &color, int cara) {
    const dvec3 haciaLuz(0.20, 0.78, 0.593);
    const double luz = 0.58 + 0.42 * (cara % 2 ? 1 : -1) * haciaLuz[cara / 2];
    const dvec3 error = glm::abs(dvec3(p.r, p.g, p.b) - 255 * luz * color);
    const double mayor = std::max({error.x, error.y, error.z});
    if (mayor <= 1)
        apuntaDiferencia(mayor, -1, 0.01); // solo se miran píxeles a más de 0.01 de un borde (decidido)
    return mayor <= 1;
}

// Los ejes, las líneas y los rótulos, que pueden tapar el objeto, no llevan luz.
bool esAdorno(const Pixel &p) {
    for (const glm::vec3 &color : {ROJO, VERDE, AZUL, MORADO, GRIS, glm::mix(GRIS, FONDO_CLARO, 0.55f),
                                   glm::mix(GRIS, OSCURO, 0.3f), OSCURO, BLANCO})
        if (glm::ivec3(p.r, p.g, p.b) == glm::ivec3(255.0f * color + 0.5f))
            return true;
    return false;
}

// --- Cámara en doble precisión, con la imagen en píxeles ---

struct Camara {
    dvec3 ojo, derecha, arriba, haciaOjo;
    double focal, cx, cy; // en píxeles; el centro de la imagen está en (cx, cy)

    dvec2 proyecta(const dvec3 &p) const {
        const dvec3 v = p - ojo;
        return dvec2(cx, cy) +
               focal / -glm::dot(v, haciaOjo) * dvec2(glm::dot(v, derecha), glm::dot(v, arriba));
    }
    dvec3 rayo(const dvec2 &px) const {
        return (px.x - cx) * derecha + (px.y - cy) * arriba - focal * haciaOjo;
    }
};

// Cámara en órbita: `angulo` abarca `lado` píxeles, que son los del alto útil de la ventana.
Camara camara(double azimut, double elevacion, double distancia, const dvec3 &centro, double angulo,
              double lado, double cx, double cy) {
    Camara c;
    c.haciaOjo = {std::cos(elevacion) * std::sin(azimut), std::sin(elevacion),
                  std::cos(elevacion) * std::cos(azimut)};
    c.ojo = centro + distancia * c.haciaOjo;
    c.derecha = {std::cos(azimut), 0, -std::sin(azimut)};
    c.arriba = glm::cross(c.haciaOjo, c.derecha);
    c.focal = lado / 2 / std::tan(angulo / 2);
    c.cx = cx;
    c.cy = cy;
    return c;
}

// OpenGL ajusta los vértices a una rejilla de 1/256 de píxel. Lo que vale igual en cuatro puntos a 1/100 del
// centro del píxel está decidido; lo demás es borde y no se compara.
template<class F>
auto decidido(int x, int y, F valor, decltype(valor(dvec2())) dudoso) -> decltype(dudoso) {
    const double e = 0.01;
    const auto v = valor(dvec2(x + 0.5 - e, y + 0.5 - e));
    for (const dvec2 &d : {dvec2(e, -e), dvec2(-e, e), dvec2(e, e)})
        if (valor(dvec2(x + 0.5, y + 0.5) + d) != v)
            return dudoso;
    return v;
}

// La malla dibujada está entre dos sólidos convexos: contiene el de dentro y está contenida en el de fuera.
// Un píxel del de dentro es del objeto o de un adorno, nunca del fondo; uno de fuera nunca es del objeto.
struct Recuento {
    int dentro = 0, objeto = 0, fuera = 0, dudosos = 0;
};
using Pertenece = std::function<bool(const dvec2 &)>;

Recuento compara(const Imagen &imagen, int y0, int y1, const dvec3 &color, const Pertenece &interior,
                 const Pertenece &exterior) {
    Recuento r;
    for (int y = y0; y < y1; ++y)
        for (int x = 0; x < imagen.ancho; ++x) {
            const Pixel p = pixel(imagen, x, y);
            const bool esObjeto = esDeColor(p, color);
            if (decidido(x, y, interior, false)) {
                ++r.dentro;
                r.objeto += esObjeto;
                EXPECT_TRUE(esObjeto || esAdorno(p))
                    << "dentro " << x << "," << y << ": " << p.r << " " << p.g << " " << p.b;
            } else if (decidido(
                           x, y, [&](const dvec2 &q) { return !exterior(q); }, false)) {
                ++r.fuera;
                EXPECT_FALSE(esObjeto) << "fuera " << x << "," << y;
            } else {
                ++r.dudosos;
            }
        }
    apuntaDiferencia(-1, -1, 0.01); // solo la silueta
    return r;
}

// --- Sólidos ---

struct Caja {
    dvec3 minimo, maximo;
};

// Distancia a la caja (infinito si el rayo no la toca) y cara por la que entra: 2·eje + (mira a +eje).
double corta(const Caja &caja, const dvec3 &ojo, const dvec3 &d, int &cara) {
    double entra = 0, sale = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        double a = (caja.minimo[i] - ojo[i]) / d[i], b = (caja.maximo[i] - ojo[i]) / d[i];
        if (a > b)
            std::swap(a, b);
        if (a > entra) {
            entra = a;
            cara = 2 * i + (d[i] < 0);
        }
        sale = std::min(sale, b);
    }
    return entra <= sale ? entra : std::numeric_limits<double>::infinity();
}

// ¿Toca el rayo el cono macizo? w = ojo − vértice; a lo largo del eje, h de 0 (vértice) a la altura.
bool tocaCono(const dvec3 &vertice, const dvec3 &centroBase, double radio, const dvec3 &ojo, const dvec3 &d) {
    const double altura = glm::length(centroBase - vertice), k = 1 + radio * radio / altura / altura;
    const dvec3 eje = (centroBase - vertice) / altura, w = ojo - vertice;
    const double we = glm::dot(w, eje), de = glm::dot(d, eje);
    const dvec3 enBase = w + (altura - we) / de * d - altura * eje;
    if (glm::dot(enBase, enBase) <= radio * radio)
        return true;
    // superficie lateral: |p|² = k·(p·eje)²
    const double a = glm::dot(d, d) - k * de * de, b = glm::dot(d, w) - k * de * we,
                 c = glm::dot(w, w) - k * we * we, discriminante = b * b - a * c;
    if (discriminante < 0)
        return false;
    for (double signo : {-1.0, 1.0}) {
        const double h = we + (-b + signo * std::sqrt(discriminante)) / a * de;
        if (h >= 0 && h <= altura)
            return true;
    }
    return false;
}

// Elipsoide de revolución: semieje `largo` según `eje` (unitario) y `corto` en perpendicular.
struct Elipsoide {
    dvec3 centro, eje;
    double largo, corto;
};

// Cónica C con q·C·q <= 0 dentro de su contorno en la imagen. La cuádrica dual Q* = [A − c·cᵀ, −c; −cᵀ, −1],
// con A la matriz de los semiejes al cuadrado, se proyecta en la cónica dual P·Q*·Pᵀ, inversa de C.
dmat3 contorno(const Elipsoide &e, const Camara &k) {
    const dmat3 A = e.corto * e.corto * dmat3(1) +
                    (e.largo * e.largo - e.corto * e.corto) * glm::outerProduct(e.eje, e.eje);
    const dmat3 R = glm::transpose(dmat3(k.derecha, k.arriba, -k.haciaOjo));
    const dmat3 K(dvec3(k.focal, 0, 0), dvec3(0, k.focal, 0), dvec3(k.cx, k.cy, 1));
    const dvec3 c = R * (e.centro - k.ojo);
    const dmat3 dual = K * (R * A * glm::transpose(R) - glm::outerProduct(c, c)) * glm::transpose(K);
    const dmat3 C = glm::inverse(dual);
    const dvec3 centro = K * c; // la imagen del centro está dentro: fija el signo
    return glm::dot(centro, C * centro) > 0 ? -C : C;
}

Pertenece dentroDe(const dmat3 &conica) {
    return [conica](const dvec2 &q) { return glm::dot(dvec3(q, 1), conica * dvec3(q, 1)) <= 0; };
}

// Segmentos con que una circunferencia de `radioPx` se separa `tolerPx` de su polígono.
int segmentos(double radioPx, double tolerPx) {
    return static_cast<int>(std::ceil(PI / std::acos(1 - tolerPx / radioPx)));
}

// Radio de la mayor bola dentro de la esfera unidad de n meridianos y n/2 franjas: la malla es convexa y sus
// caras son trapecios planos, así que es la menor distancia del centro al plano de uno. Cada plano corta al
// meridiano de en medio por los puntos medios de los dos paralelos.
double radioInscrito(int n) {
    double menor = 1;
    const int m = n / 2;
    for (int j = 0; j < m; ++j) {
        const double a = PI * j / m, b = PI * (j + 1) / m, c = std::cos(PI / n);
        const dvec2 p(c * std::sin(a), std::cos(a)), q(c * std::sin(b), std::cos(b));
        menor = std::min(menor, std::fabs(p.x * q.y - p.y * q.x) / glm::length(p - q));
    }
    return menor;
}

std::string pulsaT(std::size_t veces) {
    std::string guion;
    for (std::size_t i = 0; i < veces; ++i)
        guion += "tecla t;";
    return guion;
}

dvec3 aplica(const glm::mat4 &M, const glm::vec3 &p) {
    const glm::vec4 q = M * glm::vec4(p, 1);
    EXPECT_EQ(q.w, 1.0f);
    return dvec3(q);
}

const int TALLAS[][2] = {{240, 180}, {150, 200}};

} // namespace

// --- basicas ---

namespace {

const std::vector<glm::vec3> ADORNOS = {ROJO,   VERDE, AZUL, MORADO, GRIS, glm::mix(GRIS, FONDO_CLARO, 0.55f),
                                        OSCURO, BLANCO};
const double GRADO = PI / 180;

oraculo::Camara camaraBasicas() {
    return perspectiva(oraculo::orbita(0.95, 0.35, 10.2, {0.2, 1.42, 0}), 0.5, 1, 100);
}

// Las matrices de las ecuaciones, escritas por filas.
oraculo::Mat4 T(double x) {
    return {{{1, 0, 0, x}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
}
oraculo::Mat4 S(double x) {
    return {{{x, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
}
oraculo::Mat4 Rx(double grados) {
    const double c = std::cos(grados * GRADO), s = std::sin(grados * GRADO);
    return {{{1, 0, 0, 0}, {0, c, -s, 0}, {0, s, c, 0}, {0, 0, 0, 1}}};
}
oraculo::Mat4 Ry(double grados) {
    const double c = std::cos(grados * GRADO), s = std::sin(grados * GRADO);
    return {{{c, 0, s, 0}, {0, 1, 0, 0}, {-s, 0, c, 0}, {0, 0, 0, 1}}};
}
oraculo::Mat4 Rz(double grados) {
    const double c = std::cos(grados * GRADO), s = std::sin(grados * GRADO);
    return {{{c, -s, 0, 0}, {s, c, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
}

std::string repite(const std::string &orden, int veces) {
    std::string guion;
    for (int i = 0; i < veces; ++i)
        guion += "; " + orden;
    return guion;
}

} // namespace

// La F son tres cajas; transformadas por la ecuación tienen que estar en cada píxel, con la luz de sus normales. Y la esquina
// (1.3, 1.65, 0.25) pasa por donde dice la ecuación con los valores intermedios.
TEST(ProgramaBasicas, LaFEstaDondeDicenLasEcuaciones) {
    const oraculo::Camara k = camaraBasicas();
    const struct {
        std::string guion;
        oraculo::Mat4 (*M)(double);
        double valor, neutro;
    } casos[] = {{"", T, 1.5, 0},
                 {"tecla 5; tecla 1; tecla +; tecla +; tecla +; tecla +", T, 2, 0}, // el tope
                 {"tecla 1; tecla +; tecla +; tecla +; tecla -", T, 1.75, 0},
                 {"tecla 1" + repite("tecla -", 20), T, -2, 0},
                 {"tecla 2", S, 1.5, 1},
                 {"tecla 2" + repite("tecla -", 20), S, -2, 1},
                 {"tecla 3", Rx, 60, 0},
                 {"tecla 3; tecla +; tecla +", Rx, 90, 0},
                 {"tecla 4", Ry, 60, 0},
                 {"tecla 4" + repite("tecla -", 8), Ry, -60, 0},
                 {"tecla 5", Rz, 60, 0},
                 {"tecla 5; tecla -", Rz, 45, 0}};
    for (const auto &caso : casos) {
        SCOPED_TRACE(caso.guion);
        const Ejecucion e = ejecuta("ch03_transformaciones/basicas", caso.guion);
        ASSERT_EQ(e.estado, 0) << e.errores;
        std::vector<ch03::Cuerpo> cuerpos;
        for (const Caja &c :
             {Caja{{0.15, 0.15, -0.25}, {0.55, 1.65, 0.25}}, Caja{{0.55, 1.30, -0.25}, {1.30, 1.65, 0.25}},
              Caja{{0.55, 0.70, -0.25}, {1.05, 1.05, 0.25}}}) {
            const dvec3 centro = 0.5 * (c.minimo + c.maximo), lados = c.maximo - c.minimo;
            cuerpos.push_back(
                {oraculo::caja(caso.M(caso.valor) * oraculo::traslada({centro.x, centro.y, centro.z}) *
                               oraculo::escala({lados.x, lados.y, lados.z})),
                 {0.95, 0.55, 0.10}});
        }
        int tapados = 0;
        const oraculo::Comparacion c =
            ch03::compara(e.imagen, cuerpos, k, {0.95, 0.96, 0.98}, 1, ADORNOS, &tapados);
        EXPECT_LE(c.maximo, 1) << c;
        EXPECT_LE(c.desvio, ch03::DESVIO) << c;
        EXPECT_LT(tapados, 8000);
        int vistos = 0; // la F y las líneas de la original tapan parte del camino
        for (const double t : {0.2, 0.35, 0.5, 0.65, 0.8, 0.9})
            vistos += ch03::hayTrazo(
                e.imagen, k, punto(caso.M(caso.neutro + t * (caso.valor - caso.neutro)), {1.3, 1.65, 0.25}),
                MORADO);
        EXPECT_GE(vistos, 3);
    }
}

TEST(ProgramaBasicas, LosEjes) {
    EXPECT_TRUE(ch03::estanLosEjes(ejecuta("ch03_transformaciones/basicas", "tecla 4").imagen,
                                   camaraBasicas(), {1.85, 1.85, 1.85}));
}

TEST(ProgramaBasicas, LaMatrizEstaEscrita) {
    const struct {
        const char *guion;
        std::u32string lineas[5];
    } casos[] = {{"",
                  {U"T(1.5, 0, 0) =", U"|     1     0     0   1.5 |", U"|     0     1     0     0 |",
                   U"|     0     0     1     0 |", U"|     0     0     0     1 |"}},
                 {"tecla 2; tecla +",
                  {U"S(1.75, 1, 1) =", U"|  1.75     0     0     0 |", U"|     0     1     0     0 |",
                   U"|     0     0     1     0 |", U"|     0     0     0     1 |"}},
                 {"tecla 3",
                  {U"Rx(60°) =", U"|     1     0     0     0 |", U"|     0   0.5 -0.87     0 |",
                   U"|     0  0.87   0.5     0 |", U"|     0     0     0     1 |"}},
                 {"tecla 4; tecla +; tecla +",
                  {U"Ry(90°) =", U"|     0     0     1     0 |", U"|     0     1     0     0 |",
                   U"|    -1     0     0     0 |", U"|     0     0     0     1 |"}},
                 {"tecla 5; tecla -; tecla -; tecla -; tecla -; tecla -",
                  {U"Rz(-15°) =", U"|  0.97  0.26     0     0 |", U"| -0.26  0.97     0     0 |",
                   U"|     0     0     1     0 |", U"|     0     0     0     1 |"}}};
    for (const auto &caso : casos) {
        const Ejecucion e = ejecuta("ch03_transformaciones/basicas", caso.guion);
        double anterior = 180;
        for (const std::u32string &linea : caso.lineas) {
            const std::vector<Rotulo> sitios = buscaRotulo(e.imagen, linea, OSCURO);
            ASSERT_EQ(sitios.size(), 1u) << caso.guion;
            EXPECT_LT(sitios[0].y, anterior) << caso.guion;
            anterior = sitios[0].y;
        }
    }
}

// Cada ecuación con números que no se redondean, y los giros en float: cada seno y coseno llega con 1.5·U como mucho, así que
// c² + s² se separa de 1 menos de 2·1.5·√2·U, y el producto de float por float añade otro 2·U.
TEST(Basicas, EcuacionesYSentidoDeGiro) {
    const glm::vec3 p(0.5f, -1.25f, 2);
    EXPECT_TRUE(aplica(traslacion({1, 2, -3}), p) == dvec3(1.5, 0.75, -1));
    EXPECT_TRUE(aplica(escalado({2, -4, 0.5f}), p) == dvec3(1, 5, 1));
    for (int eje = 0; eje < 3; ++eje)
        for (float phi = -3; phi <= 3; phi += 0.25f) {
            const glm::mat4 M = eje == 0 ? giroX(phi) : eje == 1 ? giroY(phi) : giroZ(phi);
            const dmat3 R(M), RRt = R * glm::transpose(R) - dmat3(1);
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j)
                    EXPECT_LE(std::fabs(RRt[i][j]), 7 * U) << eje << " " << phi;
            // visto desde la punta del eje, el giro de φ > 0 es antihorario: a × b apunta hacia quien mira
            dvec3 hacia(0), a(0);
            hacia[eje] = 1;
            a[(eje + 1) % 3] = 1;
            const dvec3 b = R * a;
            EXPECT_NEAR(glm::dot(glm::cross(a, b), hacia), std::sin(static_cast<double>(phi)), 2 * U);
            EXPECT_NEAR(glm::dot(a, b), std::cos(static_cast<double>(phi)), 2 * U);
            EXPECT_TRUE(R * hacia == hacia);
        }
}

// --- escalado ---

// Cada vista contra el trazado de rayos a las tres cajas de la F escalada. La cara que se ve en cada píxel
// se proyecta con sus cuatro vértices en el orden que en la F sin escalar es antihorario desde fuera: si en la
// imagen siguen siéndolo tiene que verse el color de fuera, y si no, el de dentro; y siempre con la luz de la normal que
// sale del objeto. De frente y por detrás.
TEST(Escalado, CarasYDeterminanteEnCadaVista) {
    const dvec3 factores[6] = {{2, 2, 2}, {2, 0.5, 1}, {1, 1, 0}, {-1, 1, 1}, {-1, -1, 1}, {0.5, 0.5, 0.5}};
    const std::u32string rotulos[6] = {U"S(2, 2, 2)",  U"S(2, .5, 1)",  U"S(1, 1, 0)",
                                       U"S(-1, 1, 1)", U"S(-1, -1, 1)", U"S(.5, .5, .5)"};
    const Caja trazos[3] = {{{0.15, 0.15, -0.25}, {0.55, 1.65, 0.25}},
                            {{0.55, 1.30, -0.25}, {1.30, 1.65, 0.25}},
                            {{0.55, 0.70, -0.25}, {1.05, 1.05, 0.25}}};
    const Caja todo = {{0.15, 0.15, -0.25}, {1.30, 1.65, 0.25}};
    for (const bool detras : {false, true}) {
        // el ratón gira 1.8 radianes por alto de la ventana: 0.005 por píxel
        const Ejecucion e = ejecuta(
            "ch03_transformaciones/escalado",
            detras ? "boton IZQUIERDO abajo 470 10; arrastra 170 10; arrastra -130 10" : "", 480, 360);
        ASSERT_EQ(e.estado, 0) << e.errores;
        const double azimut = detras ? 1 + 3.0 : 1;
        // tres columnas y dos filas, con rayas de dos píxeles entre ellas: 158, 159 y 159 por 179 y 179
        const int columnas[4] = {0, 160, 321, 482}, filas[3] = {0, 181, 362};
        for (int i = 0; i < 6; ++i) {
            SCOPED_TRACE("vista " + std::to_string(i) + (detras ? " por detrás" : ""));
            const dvec3 s = factores[i];
            const double determinante = s.x * s.y * s.z;
            const int x0 = columnas[i % 3], ancho = columnas[i % 3 + 1] - x0 - 2, y0 = filas[1 - i / 3],
                      alto = filas[2 - i / 3] - y0 - 2;
            const dvec3 a = s * todo.minimo, b = s * todo.maximo;
            const dvec3 centro =
                0.5 * (glm::min(todo.minimo, glm::min(a, b)) + glm::max(todo.maximo, glm::max(a, b)));
            const Camara k = camara(azimut, 0.3, 10, centro - dvec3(0, 0.18, 0), 2 * std::atan(0.24), alto,
                                    x0 + ancho / 2.0, y0 + alto / 2.0);

            // 1 + cara si la que se ve gira en sentido antihorario, −(1 + cara) si en horario, 0 donde no hay nada
            const auto sentido = [&](const dvec2 &q) {
                const dvec3 d = k.rayo(q);
                double cerca = std::numeric_limits<double>::infinity();
                int trazo = -1, cara = 0;
                for (int j = 0; j < 3; ++j) {
                    int c = 0;
                    const Caja escalada = {glm::min(s * trazos[j].minimo, s * trazos[j].maximo),
                                           glm::max(s * trazos[j].minimo, s * trazos[j].maximo)};
                    const double t = corta(escalada, k.ojo, d, c);
                    if (t < cerca)
                        cerca = t, trazo = j, cara = c;
                }
                if (trazo < 0)
                    return 0;
                // la cara de la F sin escalar que el escalado lleva ahí: con factor negativo, la opuesta; con
                // factor cero las dos, y de ellas se ve la que mira al ojo
                const int eje = cara / 2, u = (eje + 1) % 3, v = (eje + 2) % 3;
                const int lejos = s[eje] < 0 ? 1 - cara % 2 : cara % 2;
                double area = 0;
                dvec2 esquinas[4];
                for (int n = 0; n < 4; ++n) {
                    dvec3 p;
                    p[eje] = lejos ? trazos[trazo].maximo[eje] : trazos[trazo].minimo[eje];
                    const int giro = lejos ? n : 3 - n; // antihorario desde fuera
                    p[u] = giro == 1 || giro == 2 ? trazos[trazo].maximo[u] : trazos[trazo].minimo[u];
                    p[v] = giro >= 2 ? trazos[trazo].maximo[v] : trazos[trazo].minimo[v];
                    esquinas[n] = k.proyecta(s * p);
                }
                for (int n = 0; n < 4; ++n) {
                    const dvec2 &p = esquinas[n], &r = esquinas[(n + 1) % 4];
                    area += p.x * r.y - p.y * r.x;
                }
                return area > 0 ? 1 + cara : -(1 + cara);
            };

            int vistos = 0, dentro = 0;
            for (int y = y0; y < y0 + alto; ++y)
                for (int x = x0; x < x0 + ancho; ++x) {
                    const int esperado = decidido(x, y, sentido, 99);
                    const Pixel p = pixel(e.imagen, x, y);
                    const bool fuera = esDeColor(p, amarillo), reves = esDeColor(p, morado);
                    if (esperado == 99)
                        continue;
                    if (esperado == 0) {
                        ASSERT_FALSE(fuera || reves) << x << "," << y;
                        continue;
                    }
                    ++dentro;
                    ASSERT_EQ(esperado > 0, determinante >= 0) << x << "," << y;
                    const bool bien = esCara(p, esperado > 0 ? amarillo : morado, std::abs(esperado) - 1);
                    ASSERT_TRUE(bien || esAdorno(p)) << x << "," << y;
                    vistos += bien;
                }
            EXPECT_GT(dentro, 200);
            EXPECT_GT(vistos, dentro / 2);
            const std::vector<Rotulo> sitios = buscaRotulo(e.imagen, rotulos[i], OSCURO);
            ASSERT_EQ(sitios.size(), 1u);
            EXPECT_NEAR(sitios[0].x, x0 + ancho / 2.0, 2);
            EXPECT_TRUE(sitios[0].y > y0 && sitios[0].y < y0 + alto / 8.0);
            // la F sin escalar, en líneas: ninguna tapa a otra donde no está la escalada
            int aristas = 0;
            for (const dvec3 &p : {dvec3(0.15, 0.9, 0.25),
                                   {0.15, 0.9, -0.25},
                                   {0.7, 1.65, 0.25},
                                   {1.3, 1.5, 0.25},
                                   {1.3, 1.5, -0.25},
                                   {0.35, 0.15, 0.25},
                                   {1.05, 0.9, 0.25},
                                   {0.7, 1.65, -0.25}}) {
                const dvec2 q = k.proyecta(p);
                bool hay = false;
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx)
                        for (const glm::vec3 &color : {GRIS, glm::mix(GRIS, FONDO_CLARO, 0.55f)})
                            hay = hay || esColor(e.imagen, static_cast<int>(q.x) + dx,
                                                 static_cast<int>(q.y) + dy, color);
                aristas += hay;
            }
            EXPECT_GE(aristas, 6);
            RecordProperty("vista" + std::to_string(i) + (detras ? "detras" : ""),
                           std::to_string(vistos) + "/" + std::to_string(dentro));
        }
    }
}

// --- tres_cubos ---

namespace {
// De lado 1, 1/2 y 1/4; el centro sube medio lado del anterior más medio del nuevo.
std::vector<Caja> cubosDelEnunciado() {
    std::vector<Caja> cajas;
    double lado = 1, centro = 0;
    for (int i = 0; i < 3; ++i) {
        cajas.push_back({dvec3(0, centro, 0) - lado / 2, dvec3(0, centro, 0) + lado / 2});
        centro += lado / 2 + lado / 4;
        lado /= 2;
    }
    return cajas;
}
} // namespace

// Todos los números son fracciones de denominador 8 como mucho: en float no hay redondeo y la igualdad es exacta.
TEST(TresCubos, VerticesExactos) {
    const std::vector<Caja> esperados = cubosDelEnunciado();
    const auto cubos = tresCubos();
    for (std::size_t i = 0; i < 3; ++i)
        for (int esquina = 0; esquina < 8; ++esquina) {
            const glm::bvec3 b(esquina & 1, esquina & 2, esquina & 4);
            const dvec3 p = aplica(cubos[i], glm::mix(glm::vec3(-0.5f), glm::vec3(0.5f), b));
            const dvec3 esperado = glm::mix(esperados[i].minimo, esperados[i].maximo, b);
            EXPECT_TRUE(p == esperado) << "cubo " << i << " esquina " << esquina;
        }
}

TEST(TresCubos, ImagenContraTrazadoDeRayos) {
    const std::vector<Caja> cajas = cubosDelEnunciado();
    const dvec3 colores[3] = {gris, naranja, amarillo};
    for (const auto &talla : TALLAS) {
        const Ejecucion e = ejecuta("ch03_transformaciones/tres_cubos", "", talla[0], talla[1]);
        ASSERT_EQ(e.estado, 0) << e.errores;
        const Camara k = camara(0.55, 0.35, 5.6, {0.15, 0.38, 0}, 0.5, oraculo::altoUtil(talla[0], talla[1]),
                                talla[0] / 2.0, talla[1] / 2.0);
        const auto visible = [&](const dvec2 &q) { // 6·cubo + cara, o −1
            double cerca = std::numeric_limits<double>::infinity();
            int cual = -1;
            for (int i = 0; i < 3; ++i) {
                int cara = 0;
                const double t = corta(cajas[static_cast<std::size_t>(i)], k.ojo, k.rayo(q), cara);
                if (t < cerca)
                    cerca = t, cual = 6 * i + cara;
            }
            return cual;
        };
        int vistos[3] = {};
        for (int y = 0; y < talla[1]; ++y)
            for (int x = 0; x < talla[0]; ++x) {
                const int cual = decidido(x, y, visible, 99);
                const Pixel p = pixel(e.imagen, x, y);
                if (cual == 99)
                    continue;
                if (cual < 0) {
                    ASSERT_FALSE(esDeColor(p, naranja) || esDeColor(p, amarillo)) << x << "," << y;
                    continue;
                }
                const bool bien = esCara(p, colores[cual / 6], cual % 6);
                vistos[cual / 6] += bien;
                ASSERT_TRUE(bien || esAdorno(p)) << x << "," << y << " cubo " << cual / 6;
            }
        for (int i = 0; i < 3; ++i)
            EXPECT_GT(vistos[i], 150) << "cubo " << i;
    }
}

// --- cono ---

// El vértice llega al origen sin ningún redondeo. La base, a x = 3 con radio 1: error de M·p, calculado con tres
// productos de matrices 4×4 y uno por vector, 16·U·(|Ry||S||T||p|), que aquí no pasa de 3 por componente; y
// π/2 en float se separa 4.4e-8 del exacto, por la distancia al eje Y, √(1+9).
TEST(Cono, VerticeYBaseExactos) {
    const glm::mat4 M = concatena(pasosCono(), 3);
    EXPECT_TRUE(aplica(M, {0, 0, 1}) == dvec3(0));
    const double cota = 16 * U * 3 + 4.4e-8 * std::sqrt(10.0);
    EXPECT_LE(glm::length(aplica(M, {0, 0, 0}) - dvec3(3, 0, 0)), cota);
    double peor = 0;
    for (int i = 0; i < 360; ++i) {
        const glm::vec3 p(std::cos(static_cast<float>(i)), std::sin(static_cast<float>(i)), 0);
        const dvec3 q = aplica(M, p), error = glm::abs(q - dvec3(3, p.y, p.x));
        peor = std::max({peor, error.x, error.y, error.z});
    }
    EXPECT_LE(peor, cota);
    RecordProperty("peor", std::to_string(peor * 1e7) + "e-7");
}

// Silueta tras cada paso. El polígono de la base está inscrito en la circunferencia: contiene la de radio
// cos(π/n).
TEST(Cono, SiluetaDeCadaPaso) {
    const dvec3 pasos[4][2] = {// vértice y centro de la base
                               {{0, 0, 1}, {0, 0, 0}},
                               {{0, 0, 0}, {0, 0, -1}},
                               {{0, 0, 0}, {0, 0, -3}},
                               {{0, 0, 0}, {3, 0, 0}}};
    const double menor = std::cos(PI / segmentos(300, 0.5));
    for (const auto &talla : TALLAS)
        for (std::size_t i = 0; i < 4; ++i) {
            SCOPED_TRACE("paso " + std::to_string(i));
            const Ejecucion e = ejecuta("ch03_transformaciones/cono", pulsaT(i), talla[0], talla[1]);
            ASSERT_EQ(e.estado, 0) << e.errores;
            const Camara k = camara(0.6, 0.35, 9, {1.15, -0.1, 0}, 0.5, oraculo::altoUtil(talla[0], talla[1]),
                                    talla[0] / 2.0, talla[1] / 2.0);
            const auto cono = [&](double radio) {
                return [&, radio](const dvec2 &q) {
                    return tocaCono(pasos[i][0], pasos[i][1], radio, k.ojo, k.rayo(q));
                };
            };
            const Recuento r = compara(e.imagen, 0, talla[1], naranja, cono(menor), cono(1));
            EXPECT_GT(r.dentro, 800);
            EXPECT_GT(r.objeto, r.dentro * 7 / 10);
            EXPECT_LT(r.dudosos, r.dentro / 20);
        }
}

// --- elipsoide ---

// Un extremo queda en el origen sin ningún redondeo (se resta lo mismo) y el otro a 6 unidades por la recta. Cota:
// cuatro productos de matrices y uno por vector, 20·U·3.5; y los ángulos en float, 4·U de error por 6 unidades.
TEST(Elipsoide, ExtremosExactos) {
    const glm::mat4 M = concatena(pasosElipsoide(), 4);
    EXPECT_TRUE(aplica(M, {0, 0, -1}) == dvec3(0));
    const dvec3 error = glm::abs(aplica(M, {0, 0, 1}) - dvec3(6 / std::sqrt(3.0)));
    const double peor = std::max({error.x, error.y, error.z}), cota = 20 * U * 3.5 + 4 * U * 6;
    EXPECT_LE(peor, cota);
    RecordProperty("extremo", std::to_string(peor * 1e7) + "e-7");

    // y la esfera entera cae en el elipsoide: |w∥|²/9 + |w⊥|²/0.25 = 1, cuyo gradiente no pasa de 2/0.5 por
    // unidad en perpendicular; en cada componente el error es el de arriba, y √3 veces en longitud
    const dvec3 d = dvec3(1) / std::sqrt(3.0), c = 3.0 * d;
    double residuo = 0;
    for (int i = 0; i < 1000; ++i) {
        const double z = (i + 0.5) / 500 - 1, a = 2.4 * i, rho = std::sqrt(1 - z * z);
        const dvec3 unidad(rho * std::cos(a), rho * std::sin(a), z);
        const dvec3 w = aplica(M, glm::vec3(unidad)) - c;
        const double largo = glm::dot(w, d);
        const dvec3 lejos = w - largo * d;
        residuo = std::max(residuo, std::fabs(largo * largo / 9 + glm::dot(lejos, lejos) / 0.25 - 1));
    }
    // más el redondeo del punto a float: cada componente U, y |p|² cambia como mucho 2·√3·U
    EXPECT_LE(residuo, 4 * std::sqrt(3.0) * cota + 2 * std::sqrt(3.0) * U);
    RecordProperty("residuo", std::to_string(residuo * 1e7) + "e-7");
}

// Silueta tras cada paso contra la cónica del elipsoide analítico. La malla está inscrita en la esfera y
// contiene la de radio r = radioInscrito(n); una transformación afín conserva las inclusiones, así que lo
// dibujado está entre el elipsoide y el mismo reducido r veces hacia su centro.
TEST(Elipsoide, SiluetaDeCadaPaso) {
    const dvec3 Z(0, 0, 1), inclinado(0, 1 / std::sqrt(3.0), std::sqrt(2.0 / 3)),
        recta = dvec3(1) / std::sqrt(3.0);
    const Elipsoide pasos[5] = {{dvec3(0), Z, 1, 1},
                                {dvec3(0), Z, 3, 0.5},
                                {3.0 * Z, Z, 3, 0.5},
                                {3.0 * inclinado, inclinado, 3, 0.5},
                                {3.0 * recta, recta, 3, 0.5}};
    const double r = radioInscrito(segmentos(450, 0.25));
    const auto camaraPara = [](int ancho, int alto) {
        return camara(-0.5, 0.35, 18, {0.5, 1.3, 0.8}, 0.5, oraculo::altoUtil(ancho, alto), ancho / 2.0,
                      alto / 2.0);
    };
    for (const auto &talla : TALLAS)
        for (std::size_t i = 0; i < 5; ++i) {
            SCOPED_TRACE("paso " + std::to_string(i));
            const Ejecucion e = ejecuta("ch03_transformaciones/elipsoide", pulsaT(i), talla[0], talla[1]);
            ASSERT_EQ(e.estado, 0) << e.errores;
            const Camara k = camaraPara(talla[0], talla[1]);
            Elipsoide menor = pasos[i];
            menor.largo *= r;
            menor.corto *= r;
            const Recuento n = compara(e.imagen, 0, talla[1], naranja, dentroDe(contorno(menor, k)),
                                       dentroDe(contorno(pasos[i], k)));
            EXPECT_GT(n.dentro, 350);
            EXPECT_GT(n.objeto, n.dentro * 6 / 10);
            EXPECT_LT(n.dudosos, n.dentro / 20);
        }

    // En 1920×1080 el hundimiento de la malla, hacia el centro, no llega a medio píxel en ningún paso.
    const Camara k = camaraPara(1920, 1080);
    for (const Elipsoide &e : pasos)
        for (double signo : {-1.0, 1.0}) {
            const double hundido = glm::length(k.proyecta(e.centro + signo * e.largo * e.eje) -
                                               k.proyecta(e.centro + signo * r * e.largo * e.eje));
            EXPECT_LT(hundido, 0.5);
        }
}

// --- orden ---

TEST(Orden, CentroYRadioDeLasMatrices) {
    const glm::mat4 T = traslacion({5, 0, 0}), S = escalado(5);
    for (const auto &[M, centro] : {std::pair(T * S, 5.0), std::pair(S * T, 25.0)})
        for (int eje = 0; eje < 3; ++eje) {
            glm::vec3 p(0);
            p[eje] = 1;
            dvec3 esperado(centro, 0, 0);
            esperado[eje] += 5; // enteros pequeños: sin redondeo
            EXPECT_TRUE(aplica(M, p) == esperado);
        }
}

// En paralela una esfera se ve como un disco de su radio, y su centro según la base de la cámara.
TEST(Orden, DiscosEnLaImagen) {
    const double r = radioInscrito(segmentos(200, 0.25)), elevacion = 0.3;
    const dvec3 interes(13.8, -0.9, 0);
    for (const auto &talla : TALLAS) {
        const Ejecucion e = ejecuta("ch03_transformaciones/orden", "", talla[0], talla[1]);
        ASSERT_EQ(e.estado, 0) << e.errores;
        const int ancho = talla[0]; // entre las dos vistas, una raya de un píxel
        const int yArriba = (talla[1] + 1) / 2;
        for (const bool arriba : {true, false}) {
            SCOPED_TRACE(arriba ? "T·S" : "S·T");
            const int y0 = arriba ? yArriba : 0, y1 = arriba ? talla[1] : yArriba - 1, alto = y1 - y0;
            const double escala = std::min(ancho / 42.0, alto / (42.0 * 3 / 8)); // píxeles por unidad
            const dvec3 centro(arriba ? 5 : 25, 0, 0), v = centro - interes;
            const dvec2 enImagen(ancho / 2.0 + escala * v.x,
                                 y0 + alto / 2.0 +
                                     escala * (std::cos(elevacion) * v.y - std::sin(elevacion) * v.z));
            const auto disco = [&](double radio) {
                return [=](const dvec2 &q) { return glm::length(q - enImagen) <= escala * radio; };
            };
            const Recuento n = compara(e.imagen, y0, y1, naranja, disco(5 * r), disco(5));
            EXPECT_GT(n.dentro, 750);
            EXPECT_GT(n.objeto, n.dentro * 8 / 10);
            EXPECT_LT(n.dudosos, n.dentro / 20);
        }
    }
    // hundimiento de la malla en 1920×1080, en píxeles
    EXPECT_LT((1 - r) * 5 * std::min(1920 / 42.0, 540 / (42.0 * 3 / 8)), 0.5);
}

// --- rótulos y líneas ---

namespace {

oraculo::Camara camaraCono() {
    return perspectiva(oraculo::orbita(0.6, 0.35, 9, {1.15, -0.1, 0}), 0.5, 1, 100);
}
oraculo::Camara camaraElipsoide() {
    return perspectiva(oraculo::orbita(-0.5, 0.35, 18, {0.5, 1.3, 0.8}), 0.5, 1, 100);
}

// La parte de la circunferencia de ese centro y semiejes que está trazada en gris.
double circunferencia(const Imagen &imagen, const oraculo::Camara &k, const oraculo::Vec3 &centro,
                      const oraculo::Vec3 &u, const oraculo::Vec3 &v) {
    int bien = 0;
    for (int i = 0; i < 60; ++i) {
        const double a = 2 * PI * i / 60;
        bien += ch03::hayTrazo(imagen, k, centro + std::cos(a) * u + std::sin(a) * v, GRIS);
    }
    return bien / 60.0;
}

} // namespace

// Una línea por paso, en orden, oscura si está aplicado; y debajo el producto, con la última a la izquierda.
TEST(PasoAPaso, LaLeyenda) {
    const struct {
        const char *programa;
        oraculo::Camara camara;
        oraculo::Vec3 ejes;
        std::vector<std::u32string> pasos, productos;
    } casos[] = {{"cono",
                  camaraCono(),
                  {3.7, 1.5, 1.8},
                  {U"1 T(0, 0, −1)", U"2 S(1, 1, 3)", U"3 Ry(−π/2)"},
                  {U"M = I", U"M = T", U"M = S·T", U"M = Ry·S·T"}},
                 {"elipsoide",
                  camaraElipsoide(),
                  {4, 3.2, 4},
                  {U"1 S(0.5, 0.5, 3)", U"2 T(0, 0, 3)", U"3 Rx(−asen 1/√3)", U"4 Ry(π/4)"},
                  {U"M = I", U"M = S", U"M = T·S", U"M = Rx·T·S", U"M = Ry·Rx·T·S"}}};
    for (const auto &caso : casos)
        for (std::size_t aplicados = 0; aplicados <= caso.pasos.size(); ++aplicados) {
            SCOPED_TRACE(caso.programa + std::to_string(aplicados));
            const Ejecucion e =
                ejecuta(std::string("ch03_transformaciones/") + caso.programa, pulsaT(aplicados), 480, 360);
            double anterior = 360;
            for (std::size_t i = 0; i < caso.pasos.size(); ++i) {
                const auto sitios = buscaRotulo(e.imagen, caso.pasos[i],
                                                i < aplicados ? OSCURO : glm::mix(GRIS, OSCURO, 0.3f));
                ASSERT_EQ(sitios.size(), 1u) << i;
                EXPECT_LT(sitios[0].y, anterior);
                anterior = sitios[0].y;
            }
            const auto producto = buscaRotulo(e.imagen, caso.productos[aplicados], OSCURO);
            ASSERT_EQ(producto.size(), 1u);
            EXPECT_LT(producto[0].y, anterior);
        }
    for (const auto &caso : casos)
        EXPECT_TRUE(ch03::estanLosEjes(ejecuta(std::string("ch03_transformaciones/") + caso.programa).imagen,
                                       caso.camara, caso.ejes))
            << caso.programa;
}

// Al principio se ve en líneas adónde hay que llegar, y al final, de dónde se ha salido.
TEST(PasoAPaso, DeDondeSaleYAdondeVa) {
    const std::string ruta = "ch03_transformaciones/";
    const Imagen cono0 = ejecuta(ruta + "cono").imagen, cono3 = ejecuta(ruta + "cono", pulsaT(3)).imagen;
    EXPECT_GT(circunferencia(cono0, camaraCono(), {3, 0, 0}, {0, 1, 0}, {0, 0, 1}), 0.85);
    EXPECT_GT(circunferencia(cono3, camaraCono(), {0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 0.7); // el cono tapa
    EXPECT_TRUE(ch03::hayTrazo(cono3, camaraCono(), {-0.25, 0, 0.75}, GRIS));             // una generatriz
    EXPECT_LT(circunferencia(cono0, camaraCono(), {0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 0.2);

    const Imagen esfera0 = ejecuta(ruta + "elipsoide").imagen,
                 esfera4 = ejecuta(ruta + "elipsoide", pulsaT(4)).imagen;
    const double r = std::sqrt(1 / 3.0), raiz2 = std::sqrt(0.5), raiz6 = std::sqrt(1 / 6.0);
    const oraculo::Vec3 d{r, r, r}, u{raiz2, 0, -raiz2}, v{-raiz6, 2 * raiz6, -raiz6};
    EXPECT_GT(circunferencia(esfera0, camaraElipsoide(), 3.0 * d, 0.5 * u, 0.5 * v), 0.6); // la recta pasa
    EXPECT_GT(circunferencia(esfera4, camaraElipsoide(), {}, {1, 0, 0}, {0, 1, 0}), 0.6);
    EXPECT_GT(circunferencia(esfera4, camaraElipsoide(), {}, {0, 1, 0}, {0, 0, 1}), 0.6);
    EXPECT_GT(circunferencia(esfera4, camaraElipsoide(), {}, {1, 0, 0}, {0, 0, 1}), 0.6);
    for (const Imagen *imagen : {&esfera0, &esfera4}) {
        EXPECT_TRUE(ch03::hayTrazo(*imagen, camaraElipsoide(), {3.9, 3.9, 3.9}, OSCURO));
        EXPECT_TRUE(ch03::hayTrazo(*imagen, camaraElipsoide(), {-1.1, -1.1, -1.1}, OSCURO));
        EXPECT_TRUE(ch03::rotuladoJunto(*imagen, camaraElipsoide(), {4, 4, 4}, U"x=y=z", 0));
    }
}

TEST(TresCubos, Rotulos) {
    const oraculo::Camara k = perspectiva(oraculo::orbita(0.55, 0.35, 5.6, {0.15, 0.38, 0}), 0.5, 1, 100);
    const Imagen imagen = ejecuta("ch03_transformaciones/tres_cubos").imagen;
    EXPECT_TRUE(ch03::rotuladoJunto(imagen, k, {0.5, 0.25, -0.5}, U"M = I", 1));
    EXPECT_TRUE(ch03::rotuladoJunto(imagen, k, {0.25, 0.875, -0.25}, U"M = A", 1) ||
                buscaRotulo(imagen, U"M = A", OSCURO).size() == 2); // también es el principio de M = A·A
    EXPECT_TRUE(ch03::rotuladoJunto(imagen, k, {0.125, 1.1875, -0.125}, U"M = A·A", 1));
    EXPECT_EQ(buscaRotulo(imagen, U"A = T(0, 0.75, 0) · S(0.5)", OSCURO).size(), 1u);
    EXPECT_TRUE(ch03::estanLosEjes(imagen, k, {1.5, 1.5, 1.5}));
}

// En cada vista su producto sobre la esfera, y bajo cada división de la regla su número.
TEST(Orden, RotulosYRegla) {
    const Imagen ventana = ejecuta("ch03_transformaciones/orden", "", 480, 361).imagen;
    for (const bool arriba : {true, false}) {
        const Imagen imagen = oraculo::recorta(ventana, 0, arriba ? 181 : 0, 480, 179);
        oraculo::Camara k =
            oraculo::orbita(0, 0.3, 50, {13.8, -0.9, 0}); // de lejos: solo cuenta la dirección
        k = paralela(k, std::max(179 * 21 / 480.0, 21 * 3 / 8.0), 1, 300);
        const auto rotulo = [&](const std::u32string &texto, const glm::vec3 &color) {
            // la vista es media ventana, pero la letra mide lo mismo
            std::vector<oraculo::Vec3> suyos;
            for (const Rotulo &r : buscaRotulo(ventana, texto, color))
                if ((r.y > 180) == arriba)
                    suyos.push_back({r.x, r.y - (arriba ? 181 : 0), 0});
            return suyos;
        };
        const auto nombre = rotulo(arriba ? U"T·S" : U"S·T", BLANCO),
                   primera = rotulo(arriba ? U"S" : U"T", OSCURO);
        ASSERT_EQ(nombre.size(), 1u);
        ASSERT_EQ(primera.size(), 1u);
        const auto lejos = [&](const oraculo::Vec3 &s, const oraculo::Vec3 &p) {
            return longitud(s - proyecta(k, 480, 179, p) + oraculo::Vec3{0, 0, proyecta(k, 480, 179, p).z});
        };
        EXPECT_LE(lejos(nombre[0], {arriba ? 5.0 : 25.0, 0, 0}), 3);
        EXPECT_LE(lejos(primera[0], arriba ? oraculo::Vec3{-3.5, 3.5, 0} : oraculo::Vec3{4.3, 0.7, 0}), 18);
        for (int x = 10; x <= 30; x += 5) {
            const std::string numero = std::to_string(x);
            const auto sitios = rotulo(std::u32string(numero.begin(), numero.end()), OSCURO);
            ASSERT_EQ(sitios.size(), 1u) << x;
            const oraculo::Vec3 marca = proyecta(k, 480, 179, {static_cast<double>(x), -6.5, 0});
            EXPECT_NEAR(sitios[0].x, marca.x, 3) << x;
            EXPECT_LT(sitios[0].y, marca.y) << x;
            EXPECT_TRUE(ch03::hayTrazo(imagen, k, {static_cast<double>(x), -6.1, 0}, OSCURO)) << x;
        }
        EXPECT_TRUE(ch03::hayTrazo(imagen, k, {arriba ? 5.0 : 25.0, -5.8, 0}, MORADO)); // la plomada
        // la esfera tras la primera transformación, en líneas: S la deja en el origen y T la lleva a 5
        const double centro = arriba ? 0 : 5, radio = arriba ? 5 : 1;
        EXPECT_TRUE(ch03::hayTrazo(imagen, k, {centro - radio * 0.8, radio * 0.6, 0}, GRIS));
        EXPECT_TRUE(ch03::hayTrazo(imagen, k, {centro - radio * 0.8, 0, radio * 0.6}, GRIS));
    }
}

// --- lo común ---

TEST(PasoAPaso, TrasElUltimoEmpieza) {
    for (const auto &[programa, pasos] : {std::pair("cono", 4), std::pair("elipsoide", 5)}) {
        const std::string nombre = std::string("ch03_transformaciones/") + programa;
        EXPECT_EQ(ejecuta(nombre).imagen.rgb,
                  ejecuta(nombre, pulsaT(static_cast<std::size_t>(pasos))).imagen.rgb);
    }
}

TEST(Basicas, CualquierTamano) {
    for (const char *programa : {"basicas", "escalado", "tres_cubos", "cono", "elipsoide", "orden"}) {
        const Ejecucion e = ejecuta(std::string("ch03_transformaciones/") + programa,
                                    "tamano 1 1; tamano 500 1; tamano 1 500; tamano 77 33");
        EXPECT_EQ(e.estado, 0) << programa << e.errores;
        EXPECT_EQ(e.errores, "") << programa;
    }
}
