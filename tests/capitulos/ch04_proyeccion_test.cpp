// Las proyecciones y el área de dibujo (ecuaciones 4.2 a 4.4), contra GLM; sus erratas, y el programa.
#include "ch04_oraculo.h"
#include "ch04_vista3d/vista.h"
#include "guiones.h"
#include <glm/gtc/matrix_transform.hpp>

namespace {

using namespace oraculo;

const std::array<double, 4> PERSPECTIVAS[] = {{0.6, 1.5, 1, 100},           {1.2, 4.0 / 3, 0.1, 1e3},
                                              {0.5, 1, 0.01, 1e4},          {2.9, 0.25, 1e-3, 1e6},
                                              {0.01, 1.0 / 2000, 1, 1.001}, {1.57, 300, 1e-30, 1}};
const std::array<double, 6> PARALELAS[] = {{-1, 3, -2, 0.5, 1, 100}, {0.1, 0.7, 1e6, 1e6 + 3, -5, 1e-3}};

/// Cada elemento, con 4 redondeos como mucho; los nulos, exactos.
void compruebaMatriz(const glm::dmat4 &M, const Mat4Largo &exacta) {
    for (int c = 0; c < 4; ++c)
        for (int f = 0; f < 4; ++f) {
            const double e = double(exacta[c][f]);
            EXPECT_NEAR(M[c][f], e, 4 * U_DOBLE * std::fabs(e)) << f << "," << c;
        }
}

glm::dvec3 dividido(const glm::dvec4 &v) {
    return glm::dvec3(v) / v.w;
}
double profundidadDe(const glm::dmat4 &M, double d) {
    return dividido(M * glm::dvec4(0, 0, -d, 1)).z;
}

// Por mucho que se gire la rueda, la distancia va de 0.4 a 2.5 veces la del principio.
const struct {
    std::string guion;
    bool enPerspectiva;
    double azimut = 0.50, elevacion = 0.33, distancia = 3;
    int ancho = 480, alto = 360;
} CASOS[] = {
    {"", true},
    {"tecla p", false},
    {"", true, 0.50, 0.33, 3, 240, 360},
    {"tecla p", false, 0.50, 0.33, 3, 240, 360},
    {arrastra({20, 90}, {320, 70}), true, -1.0, 0.23},
    {arrastra({400, 90}, {0, 70}) + "; tecla p", false, 2.5, 0.23},
    {veces(400, "rueda +1 9 9") + "; tecla p", false, 0.50, 0.33, 1.2},
    {"tecla p; " + veces(400, "rueda -1 9 9"), false, 0.50, 0.33, 7.5},
};

/// Las aristas de cada eje y, de las horizontales, su prolongación 1000 unidades hacia el fondo. En paralela nada más.
/// En perspectiva, los puntos de fuga, donde se proyectan sus direcciones, y por los dos el horizonte, de lado a lado.
void compruebaLasRectas(const Vista &vista, const Panel &en) {
    const glm::vec3 colores[] = {ROJO, VERDE, AZUL};
    Dibujo encima = {en};
    std::vector<Vec3> fugas;
    for (int eje = 0; eje < 3; ++eje) {
        const double fondo = ejes(en.camara).z[eje] > 0 ? -1000 : 1000;
        const Mat4 M = gira({1, 1, 1}, 2 * PI / 3 * eje); // lleva X a ese eje
        Linea aristas, rectas;
        for (const double a : {-0.5, 0.5})
            for (const double b : {-0.5, 0.5}) {
                aristas.insert(aristas.end(), {punto(M, {-0.5, a, b}), punto(M, {0.5, a, b})});
                rectas.insert(rectas.end(), {punto(M, {0, a, b}), punto(M, {fondo, a, b})});
            }
        if (eje != 1) {
            encima.traza("segmentos", rectas, colores[eje], 5);
            fugas.push_back(en.camara.ojo + punto(M, {fondo, 0, 0}));
        }
        encima.traza("segmentos", aristas, colores[eje], 14);
    }
    encima.rotula(en.camara.esParalela ? "paralela" : "perspectiva", en.lugar(0.02, 0.05), OSCURO,
                  Lado::DERECHA);
    if (!en.camara.esParalela) {
        const glm::dvec2 fuga = en(fugas[0]);
        encima.rotula("punto de fuga", fuga, OSCURO, Lado::ENCIMA);
        encima.rotula("punto de fuga", en(fugas[1]), OSCURO, Lado::ENCIMA);
        encima.rotula("horizonte", en(0.4 * fugas[0] + 0.6 * fugas[1]), OSCURO, Lado::ENCIMA);
        encima.traza("segmentos", {}, OSCURO, 9); // el horizonte: lo corta el plano cerca
        encima.traza("puntos", fugas, OSCURO, 30, false);
        const Pintado horizonte = vista.encima.trazos(OSCURO, "segmentos").at(0);
        const glm::dvec2 p = horizonte.punto(0), q = horizonte.punto(1);
        EXPECT_LT(std::min(p.x, q.x), 0);
        EXPECT_GT(std::max(p.x, q.x), en.hueco.ancho);
        for (const double x : {0, en.hueco.ancho})
            EXPECT_NEAR(p.y + (x - p.x) / (q.x - p.x) * (q.y - p.y), fuga.y, 0.1);
    }
    encima.comprueba(vista);
}

} // namespace

// θ/2 es exacto, la tangente de la biblioteca yerra menos de 1 ulp (2 u) y el producto y el cociente 1 u cada uno;
// la tercera fila, tres redondeos. En total no más de 4 u. Los lados de la paralela se restan sin error.
TEST(Proyeccion, ContraGlmConMasPrecision) {
    for (const auto &[theta, aspecto, cerca, lejos] : PERSPECTIVAS) {
        compruebaMatriz(proyeccionPerspectiva(theta, aspecto, cerca, lejos),
                        glm::perspective<Largo>(theta, aspecto, cerca, lejos));
    }
    for (const auto &[i, d, b, a, cerca, lejos] : PARALELAS) {
        compruebaMatriz(proyeccionParalela(i, d, b, a, cerca, lejos),
                        glm::ortho<Largo>(i, d, b, a, cerca, lejos));
    }
}

// El libro imprime 2/(lejos − cerca) en la ecuación 4.2 y la 4.3 con el signo contrario: de dos puntos que están
// delante de la cámara, el lejano sale con menos profundidad que el cercano, y ninguno en [−1, 1].
TEST(Erratas, Ecuacion42DelReves) {
    const auto impresa = [](double cerca, double lejos) {
        glm::dmat4 M = proyeccionParalela(-1, 1, -1, 1, cerca, lejos);
        M[2][2] = 2 / (lejos - cerca);
        return M;
    };
    for (const glm::dmat4 &M :
         {proyeccionPerspectiva(1, 1, 1, 100), proyeccionParalela(-1, 1, -1, 1, 1, 100)})
        EXPECT_LT(profundidadDe(M, 2), profundidadDe(M, 50));
    EXPECT_GT(profundidadDe(impresa(1, 100), 2), profundidadDe(impresa(1, 100), 50));
    // no solo del revés: con 0 < cerca < lejos, todo lo que hay entre los dos planos queda fuera y se recorta
    for (int d = 1; d <= 100; ++d)
        EXPECT_LT(profundidadDe(impresa(1, 100), d), -1) << d;
    EXPECT_NEAR(profundidadDe(impresa(1, 10), 1), -1.44, 0.005);
    EXPECT_NEAR(profundidadDe(impresa(1, 10), 10), -3.44, 0.005);
}

// Con aspect/tan(θ) un cuadrado no se ve cuadrado, y con θ (el ángulo entero de la figura 4.4 y de
// glm::perspective) en vez de θ/2 el borde del campo no cae en el borde de la ventana.
TEST(Erratas, Ecuacion43AspectoYAngulo) {
    const double theta = 0.8, nx = 640, ny = 240;
    const glm::dmat4 P = proyeccionPerspectiva(theta, nx / ny, 1, 100);
    glm::dmat4 impresa = P;
    impresa[0][0] = nx / ny / std::tan(theta);
    impresa[1][1] = 1 / std::tan(theta);
    const auto enVentana = [&](const glm::dmat4 &M, double x, double y) { // a 5 de la cámara
        return transformacionViewport(0, 0, nx, ny) * glm::dvec4(dividido(M * glm::dvec4(x, y, -5, 1)), 1);
    };
    const auto razon = [&](const glm::dmat4 &M) {
        return (enVentana(M, 1, 0).x - nx / 2) / (enVentana(M, 0, 1).y - ny / 2);
    };
    EXPECT_NEAR(razon(P), 1, 1e-14);
    EXPECT_NEAR(razon(impresa), std::pow(nx / ny, 2), 1e-12);
    const double borde = 5 * std::tan(theta / 2);
    EXPECT_NEAR(enVentana(P, 0, borde).y, ny, 1e-12);
    EXPECT_LT(enVentana(impresa, 0, borde).y, 0.96 * ny);
}

// El volumen canónico llena justo la ventana y la profundidad va de 0 a 1 (o lo que diga glDepthRange). La matriz
// del libro pone el centro del píxel (0, 0) en (0, 0) y OpenGL en (0.5, 0.5): ch04_etapas_test lo ve en la imagen.
TEST(Viewport, EsquinasYProfundidad) {
    const glm::dmat4 M = transformacionViewport(10, 20, 300, 7, 0.25, 0.75);
    EXPECT_EQ(M * glm::dvec4(-1, -1, -1, 1), glm::dvec4(10, 20, 0.25, 1));
    EXPECT_EQ(M * glm::dvec4(1, 1, 1, 1), glm::dvec4(310, 27, 0.75, 1));
    EXPECT_EQ(transformacionViewport(0, 0, 1, 1) * glm::dvec4(0, 0, 0, 1), glm::dvec4(0.5, 0.5, 0.5, 1));
}

TEST(Proyecciones, ElCuboYSusRectas) {
    for (const auto &c : CASOS) {
        SCOPED_TRACE(c.guion);
        const Vista vista = vistaDe("proyecciones", c.guion, c.ancho, c.alto);
        const Camara desde = orbita(c.azimut, c.elevacion, c.distancia, {0.1, 0.2, 0});
        const Camara camara = c.enPerspectiva ? perspectiva(desde, 1.0, 0.1, 2000)
                                              : paralela(desde, c.distancia * std::tan(0.5), -2000, 2000);
        const Panel ventana(camara, vista.escena);
        compruebaEscena(vista, ventana, {{caja({}), exacto(AMARILLO)}}, FONDO_CLARO);
        compruebaLasRectas(vista, ventana);
    }
}
