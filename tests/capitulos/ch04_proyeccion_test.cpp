// Las proyecciones y el área de dibujo (ecuaciones 4.2 a 4.4), contra GLM; sus erratas, y el programa.
#include "ch04_oraculo.h"
#include "ch04_vista3d/vista.h"
#include "guiones.h"
#include "tabla.h"

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

} // namespace

// θ/2 es exacto, la tangente de la biblioteca yerra menos de 1 ulp (2 u) y el producto y el cociente 1 u cada uno;
// la tercera fila, tres redondeos. En total no más de 4 u. Los lados de la paralela se restan sin error.
TEST(Proyeccion, ContraGlmConMasPrecision) {
    for (const auto &[theta, aspecto, cerca, lejos] : PERSPECTIVAS)
        compruebaMatriz(proyeccionPerspectiva(theta, aspecto, cerca, lejos),
                        glm::perspective<Largo>(theta, aspecto, cerca, lejos));
    for (const auto &[i, d, b, a, cerca, lejos] : PARALELAS)
        compruebaMatriz(proyeccionParalela(i, d, b, a, cerca, lejos),
                        glm::ortho<Largo>(i, d, b, a, cerca, lejos));
}

// El libro imprime 2/(lejos − cerca) en la ecuación 4.2 y la 4.3 con el signo contrario: de dos puntos que están
// delante de la cámara, el lejano sale con menos profundidad que el cercano, y ninguno en [−1, 1].
TEST(Erratas, Ecuacion42DelReves) {
    const auto profundidades = [](const glm::dmat4 &M) {
        const glm::dvec4 cerca = M * glm::dvec4(0, 0, -1, 1), lejos = M * glm::dvec4(0, 0, -10, 1);
        return glm::dvec2(cerca.z / cerca.w, lejos.z / lejos.w);
    };
    glm::dmat4 M = proyeccionParalela(-1, 1, -1, 1, 1, 10);
    for (const glm::dmat4 &buena : {M, proyeccionPerspectiva(1, 1, 1, 10)})
        EXPECT_LT(glm::distance(profundidades(buena), {-1, 1}), 1e-15);
    M[2][2] = -M[2][2];
    EXPECT_LT(glm::distance(profundidades(M), {-1.44, -3.44}), 0.01);
}

// Con aspect/tan(θ) un cuadrado no se ve cuadrado, y con θ (el ángulo entero de la figura 4.4 y de
// glm::perspective) en vez de θ/2 el borde del campo no cae en el borde de la ventana.
TEST(Erratas, Ecuacion43AspectoYAngulo) {
    const double theta = 0.8, aspecto = 640.0 / 240, borde = 5 * std::tan(theta / 2); // a 5 de la cámara
    const auto esquina = [&](const glm::dmat4 &M) {
        const glm::dvec4 v = M * glm::dvec4(aspecto * borde, borde, -5, 1);
        return glm::dvec2(v) / v.w;
    };
    glm::dmat4 M = proyeccionPerspectiva(theta, aspecto, 1, 100);
    EXPECT_LT(glm::distance(esquina(M), {1, 1}), 1e-14);
    M[0][0] = aspecto / std::tan(theta);
    M[1][1] = 1 / std::tan(theta);
    EXPECT_LT(esquina(M).y, 0.96);
    EXPECT_NEAR(esquina(M).x / esquina(M).y, aspecto * aspecto, 1e-12);
}

// El volumen canónico llena justo la ventana y la profundidad va de 0 a 1 (o lo que diga glDepthRange). La matriz
// del libro pone el centro del píxel (0, 0) en (0, 0) y OpenGL en (0.5, 0.5): ch04_etapas_test lo ve en la imagen.
TEST(Viewport, EsquinasYProfundidad) {
    const glm::dmat4 M = transformacionViewport(10, 20, 300, 7, 0.25, 0.75);
    EXPECT_EQ(M * glm::dvec4(-1, -1, -1, 1), glm::dvec4(10, 20, 0.25, 1));
    EXPECT_EQ(M * glm::dvec4(1, 1, 1, 1), glm::dvec4(310, 27, 0.75, 1));
    EXPECT_EQ(transformacionViewport(0, 0, 1, 1) * glm::dvec4(0, 0, 0, 1), glm::dvec4(0.5, 0.5, 0.5, 1));
}

// El cubo y, en perspectiva, los puntos de fuga de sus aristas horizontales: donde se ve lo que está muy lejos en sus
// direcciones. Por mucho que se gire la rueda, la distancia va de 0.4 a 2.5 veces la del principio.
TEST(Proyecciones, ElCuboYSusRectas) {
    const struct {
        std::string guion;
        bool enPerspectiva;
        double azimut = 0.50, elevacion = 0.33, distancia = 3;
    } casos[] = {{"", true},
                 {"tecla p", false},
                 {"tamano 240 360", false},
                 {"tecla p", true},
                 {"tamano 480 360; " + arrastra({20, 90}, {320, 70}), true, -1.0, 0.23},
                 {arrastra({400, 90}, {-300, 90}) + "; tecla p", false, 2.5, 0.23},
                 {arrastra({0, 70}, {400, 90}) + "; " + veces(400, "rueda +1 9 9"), false, 0.50, 0.33, 1.2},
                 {veces(400, "rueda -1 9 9"), false, 0.50, 0.33, 7.5}};
    paraCada("proyecciones", casos, 480, 360, [](const auto &c, const Vista &v) {
        const Camara desde = orbita(c.azimut, c.elevacion, c.distancia, {0.1, 0.2, 0});
        const Panel ventana(c.enPerspectiva ? perspectiva(desde, 1.0, 0.1, 2000)
                                            : paralela(desde, c.distancia * std::tan(0.5), -2000, 2000),
                            v.escena);
        compruebaEscena(v, ventana, {{caja({}), exacto(AMARILLO)}}, FONDO_CLARO);
        Linea fugas;
        for (const Vec3 &eje : {Vec3{1, 0, 0}, {0, 0, 1}})
            fugas.push_back(desde.ojo + (escalar(eje, desde.centro - desde.ojo) < 0 ? -1000 : 1000) * eje);
        const Encima puntos = v.encima.trazos(OSCURO, "puntos");
        ASSERT_EQ(puntos.size(), c.enPerspectiva ? 1u : 0u);
        for (std::size_t k = 0; c.enPerspectiva && k < 2; ++k)
            EXPECT_LE(glm::distance(puntos[0].punto(k), ventana(fugas[k])), 0.1);
    });
}
