// Comprobaciones independientes de escalado, tres_cubos, cono, elipsoide y orden (capítulo 3). La geometría
// esperada sale del enunciado y se proyecta aquí, en doble precisión; de los programas solo se repiten los
// datos: dónde está la cámara, de qué color es cada cosa y qué elige cada uno donde falta la figura del libro.
#include "ch03_transformaciones/ejercicios.h"
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

const dvec3 rojo(0.85, 0.20, 0.18), verde(0.20, 0.62, 0.28), azul(0.16, 0.38, 0.80),
    naranja(0.95, 0.55, 0.10), amarillo(0.98, 0.78, 0.15), gris(0.55, 0.58, 0.62), oscuro(0.16, 0.17, 0.20),
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
    return std::max({error.x, error.y, error.z}) <= 1;
}

// Los ejes, la recta x = y = z y las líneas pueden tapar el objeto.
bool esAdorno(const Pixel &p) {
    for (const dvec3 &color : {rojo, verde, azul, gris, oscuro})
        if (esDeColor(p, color))
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

// Cámara en órbita: `angulo` abarca `lado` píxeles.
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

// --- escalado ---

// Cada vista contra el trazado de rayos a las tres cajas de la F escalada. La cara que se ve en cada píxel
// se proyecta con sus cuatro vértices en el orden que en la F sin escalar es antihorario desde fuera: si en la
// imagen siguen siéndolo tiene que verse el color de fuera, y si no, el de dentro; y siempre con la luz de la normal que
// sale del objeto. De frente y por detrás.
TEST(Escalado, CarasYDeterminanteEnCadaVista) {
    const dvec3 factores[6] = {{1.4, 1.4, 1.4}, {1.8, 0.6, 1}, {1, 1, 0},
                               {-1, 1, 1},      {-1, -1, 1},   {0.5, 0.5, 0.5}};
    const Caja trazos[3] = {{{0.15, 0.15, -0.25}, {0.55, 1.65, 0.25}},
                            {{0.55, 1.30, -0.25}, {1.30, 1.65, 0.25}},
                            {{0.55, 0.70, -0.25}, {1.05, 1.05, 0.25}}};
    const Caja todo = {{0.15, 0.15, -0.25}, {1.30, 1.65, 0.25}};
    for (const bool detras : {false, true}) {
        // el ratón gira 0.01 radianes por píxel
        const Ejecucion e = ejecuta("ch03_transformaciones/escalado",
                                    detras ? "boton IZQUIERDO abajo 400 10; arrastra 100 10" : "", 480, 360);
        ASSERT_EQ(e.estado, 0) << e.errores;
        const double azimut = detras ? 0.6 + 3.0 : 0.6;
        const int ancho = 160, alto = 180, lado = 160;
        for (int i = 0; i < 6; ++i) {
            SCOPED_TRACE("vista " + std::to_string(i) + (detras ? " por detrás" : ""));
            const dvec3 s = factores[i];
            const double determinante = s.x * s.y * s.z;
            const int x0 = i % 3 * ancho, y0 = (1 - i / 3) * alto;
            const dvec3 a = s * todo.minimo, b = s * todo.maximo;
            const dvec3 centro =
                0.5 * (glm::min(todo.minimo, glm::min(a, b)) + glm::max(todo.maximo, glm::max(a, b)));
            const Camara k = camara(azimut, 0.3, 10, centro, 0.34, lado, x0 + ancho / 2, y0 + alto / 2);

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
            EXPECT_GT(dentro, 300);
            EXPECT_GT(vistos, dentro / 2);
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
    const dvec3 colores[3] = {naranja, amarillo, gris};
    for (const auto &talla : TALLAS) {
        const Ejecucion e = ejecuta("ch03_transformaciones/tres_cubos", "", talla[0], talla[1]);
        ASSERT_EQ(e.estado, 0) << e.errores;
        const Camara k = camara(0.55, 0.35, 5.4, {0.1, 0.42, 0}, 0.5, std::min(talla[0], talla[1]),
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
                ASSERT_TRUE(bien || esDeColor(p, rojo) || esDeColor(p, verde) || esDeColor(p, azul))
                    << x << "," << y << " cubo " << cual / 6;
            }
        for (int i = 0; i < 3; ++i)
            EXPECT_GT(vistos[i], 200) << "cubo " << i;
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
            const Camara k = camara(0.6, 0.35, 9, {1.15, 0.1, 0}, 0.5, std::min(talla[0], talla[1]),
                                    talla[0] / 2.0, talla[1] / 2.0);
            const auto cono = [&](double radio) {
                return [&, radio](const dvec2 &q) {
                    return tocaCono(pasos[i][0], pasos[i][1], radio, k.ojo, k.rayo(q));
                };
            };
            const Recuento r = compara(e.imagen, 0, talla[1], naranja, cono(menor), cono(1));
            EXPECT_GT(r.dentro, 1500);
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
        return camara(-0.5, 0.35, 16, {1.6, 1.1, 1.6}, 0.5, std::min(ancho, alto), ancho / 2.0, alto / 2.0);
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
            EXPECT_GT(n.dentro, 600);
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
    const dvec3 interes(13, -0.7, 0);
    for (const auto &talla : TALLAS) {
        const Ejecucion e = ejecuta("ch03_transformaciones/orden", "", talla[0], talla[1]);
        ASSERT_EQ(e.estado, 0) << e.errores;
        const int ancho = talla[0], alto = talla[1] / 2;
        const double escala = std::min(ancho / 39.0, alto / (39.0 * 3 / 8)); // píxeles por unidad
        for (const bool arriba : {true, false}) {
            SCOPED_TRACE(arriba ? "T·S" : "S·T");
            const dvec3 centro(arriba ? 5 : 25, 0, 0), v = centro - interes;
            const dvec2 enImagen(ancho / 2.0 + escala * v.x,
                                 (arriba ? alto : 0) + alto / 2.0 +
                                     escala * (std::cos(elevacion) * v.y - std::sin(elevacion) * v.z));
            const auto disco = [&](double radio) {
                return [=](const dvec2 &q) { return glm::length(q - enImagen) <= escala * radio; };
            };
            const Recuento n = compara(e.imagen, arriba ? alto : 0, arriba ? 2 * alto : alto, naranja,
                                       disco(5 * r), disco(5));
            EXPECT_GT(n.dentro, 900);
            EXPECT_GT(n.objeto, n.dentro * 8 / 10);
            EXPECT_LT(n.dudosos, n.dentro / 20);
        }
    }
    // hundimiento de la malla en 1920×1080, en píxeles
    EXPECT_LT((1 - r) * 5 * std::min(1920 / 39.0, 540 / (39.0 * 3 / 8)), 0.5);
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
    for (const char *programa : {"escalado", "tres_cubos", "cono", "elipsoide", "orden"}) {
        const Ejecucion e = ejecuta(std::string("ch03_transformaciones/") + programa,
                                    "tamano 1 1; tamano 500 1; tamano 1 500; tamano 77 33");
        EXPECT_EQ(e.estado, 0) << programa << e.errores;
        EXPECT_EQ(e.errores, "") << programa;
    }
}
