// Comprobaciones independientes de etapas_pipeline: las cuentas que escribe contra el oráculo, las coordenadas de
// ventana contra el píxel dibujado, y el recortado contra el polígono exacto, en números racionales.
#include "ch04_vista3d/etapas.h"
#include "ejecuta.h"
#include "oraculo/oraculo.h"
#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <sstream>

namespace {

namespace o = oraculo;
using Racional = boost::multiprecision::cpp_rational;

/// El polígono exacto, dividido por w. Un punto del triángulo es a + s·(b − a) + t·(c − a), y tanto las tres
/// condiciones de estar en él como las seis del volumen son semiplanos de (s, t): los vértices son los cortes
/// de sus rectas, de dos en dos, que cumplen las nueve.
struct PuntoExacto {
    Racional s, t, x, y;
};
std::vector<PuntoExacto> poligonoExacto(const std::vector<glm::dvec4> &triangulo) {
    std::array<std::array<Racional, 4>, 3> v; // a, b − a, c − a
    for (std::size_t k = 0; k < 3; ++k)
        for (int c = 0; c < 4; ++c)
            v[k][static_cast<std::size_t>(c)] =
                Racional(triangulo[k][c]) - (k ? Racional(triangulo[0][c]) : Racional(0));
    using Semiplano = std::array<Racional, 3>; // p + q·s + r·t ≥ 0
    std::vector<Semiplano> semiplanos = {{0, 1, 0}, {0, 0, 1}, {1, -1, -1}};
    for (std::size_t eje = 0; eje < 3; ++eje)
        for (const int signo : {-1, 1})
            semiplanos.push_back(
                {v[0][3] + signo * v[0][eje], v[1][3] + signo * v[1][eje], v[2][3] + signo * v[2][eje]});
    std::vector<PuntoExacto> puntos;
    for (std::size_t i = 0; i < semiplanos.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const Semiplano &a = semiplanos[i], &b = semiplanos[j];
            const Racional det = a[1] * b[2] - a[2] * b[1];
            if (det == 0)
                continue;
            const Racional s = (a[2] * b[0] - a[0] * b[2]) / det, t = (a[0] * b[1] - a[1] * b[0]) / det;
            bool cumple = true, esta = false;
            for (const Semiplano &p : semiplanos)
                cumple = cumple && p[0] + p[1] * s + p[2] * t >= 0;
            for (const PuntoExacto &p : puntos)
                esta = esta || (p.s == s && p.t == t);
            if (!cumple || esta)
                continue;
            const auto componente = [&](std::size_t c) -> Racional {
                return v[0][c] + s * v[1][c] + t * v[2][c];
            };
            const Racional w = componente(3);
            puntos.push_back({s, t, componente(0) / w, componente(1) / w});
        }
    // en orden alrededor de su centro, en el plano (s, t)
    double cs = 0, ct = 0;
    for (const PuntoExacto &p : puntos) {
        cs += static_cast<double>(p.s) / static_cast<double>(puntos.size());
        ct += static_cast<double>(p.t) / static_cast<double>(puntos.size());
    }
    const auto angulo = [&](const PuntoExacto &p) {
        return std::atan2(static_cast<double>(p.t) - ct, static_cast<double>(p.s) - cs);
    };
    std::sort(puntos.begin(), puntos.end(),
              [&](const PuntoExacto &a, const PuntoExacto &b) { return angulo(a) < angulo(b); });
    return puntos;
}

/// Su área en [−1, 1]².
double areaExacta(const std::vector<PuntoExacto> &p) {
    Racional doble = 0;
    for (std::size_t k = 0; k < p.size(); ++k) {
        const PuntoExacto &a = p[k], &b = p[(k + 1) % p.size()];
        doble += a.x * b.y - a.y * b.x;
    }
    return std::fabs(static_cast<double>(doble)) / 2;
}

} // namespace

// Triángulos al azar delante, detrás y a los lados del ojo. Con cerca = 1, w ≥ 1 en lo que queda y las
// coordenadas no pasan de 40: cada corte pierde unos 4 redondeos de 40 y son seis, 1e-13 por vértice; el área,
// con un perímetro de 8, menos de 1e-12.
TEST(Recortado, AreaContraElPoligonoExacto) {
    std::mt19937 azar(45);
    std::uniform_real_distribution<double> u(-1, 1);
    double peor = 0;
    std::map<std::size_t, int> lados;
    for (int n = 0; n < 150; ++n) {
        std::vector<glm::dvec4> triangulo;
        for (int k = 0; k < 3; ++k) { // perspectiva de 90 grados, cerca 1 y lejos 10
            const double x = 8 * u(azar), y = 8 * u(azar), d = 4 + 9 * u(azar);
            triangulo.push_back({x, y, (11 * d - 20) / 9, d});
        }
        const std::vector<glm::dvec4> poligono = recorta(triangulo);
        const std::vector<PuntoExacto> exacto = poligonoExacto(triangulo);
        ASSERT_EQ(poligono.size(), exacto.size()) << n;
        ++lados[poligono.size()];
        const double error = std::fabs(areaVentana(poligono, glm::dmat4(1)) - areaExacta(exacto));
        peor = std::fmax(peor, error);
        for (const glm::dvec4 &v : poligono) {
            EXPECT_GE(v.w, 1 - 1e-13);
            EXPECT_LE(std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}), v.w + 1e-12);
        }
    }
    std::cout << "error máximo del área: " << peor << "; polígonos por número de lados:";
    for (const auto &[cuantos, veces] : lados)
        std::cout << " " << cuantos << ":" << veces;
    std::cout << "\n";
    EXPECT_LE(peor, 1e-12);
    EXPECT_GT(lados[0], 5);
    EXPECT_GT(lados[5] + lados[6] + lados[7], 10);
}

TEST(Recortado, CasosLimite) {
    using Poligono = std::vector<glm::dvec4>;
    const Poligono dentro = {
        {0, 0, 0, 1}, {1, -1, 1, 1}, {-2, 2, 0, 2}}; // dos vértices en el borde: están dentro
    EXPECT_EQ(recorta(dentro), dentro);
    EXPECT_TRUE(
        recorta(Poligono{{0, 0, 0, -1}, {0.5, 0, 0, -1}, {0, 0.5, 0, -2}}).empty()); // todo detrás del ojo
    EXPECT_TRUE(recorta(Poligono{{3, 0, 0, 1}, {3, 1, 0, 1}, {4, 0, 0, 1}}).empty());
    // el volumen entero dentro del triángulo, y un triángulo que pasa por el ojo (w de un signo y de otro)
    EXPECT_NEAR(areaVentana(recorta(Poligono{{-9, -9, 0, 1}, {9, -9, 0, 1}, {0, 9, 0, 1}}), glm::dmat4(1)), 4,
                1e-15);
    for (const glm::dvec4 &v : recorta(Poligono{{0, 0, 1, 3}, {2, 0, -5, -3}, {-1, 2, -5, -3}})) {
        EXPECT_GT(v.w, 0);
        EXPECT_TRUE(std::isfinite(divide(v).x));
    }
}

namespace {

/// Los datos de etapas_pipeline.cpp, escritos otra vez.
const o::Mat4 MM = o::traslada({0.2, 0.8, 0.3}) * o::gira({0, 1, 0}, -0.35) * o::escala({2, 1.2, 1.4});
const o::Camara CAMARA = o::perspectiva(o::miraDesde({2.0, 3.4, 5.4}, {0.1, 0.7, 0}), 0.62, 4, 8.5);
const o::Vec3 TRIANGULO[] = {{-0.7, 0.8, -0.5}, {0.9, -0.2, 5}, {1.5, -0.6, -1.4}};

/// Las líneas «clave: valores» del último vértice que ha escrito.
std::map<std::string, std::vector<double>> lee(const std::string &salida) {
    std::istringstream texto(salida.substr(salida.rfind("vértice:")));
    std::map<std::string, std::vector<double>> valores;
    for (std::string linea; std::getline(texto, linea);) {
        const std::size_t dosPuntos = linea.find(": ");
        std::istringstream numeros(linea.substr(dosPuntos + 2));
        std::vector<double> &v = valores[linea.substr(0, dosPuntos)];
        for (double n; numeros >> n;)
            v.push_back(n);
    }
    return valores;
}

std::string clic(double x, double yDesdeAbajo, int alto) {
    std::ostringstream s;
    s << "boton IZQUIERDO abajo " << static_cast<int>(x) << " " << alto - 1 - static_cast<int>(yDesdeAbajo)
      << "; boton IZQUIERDO arriba " << static_cast<int>(x) << " "
      << alto - 1 - static_cast<int>(yDesdeAbajo);
    return s.str();
}

void esperaCerca(const std::vector<double> &valores, const o::Vec3 &v, double cota, const char *clave) {
    ASSERT_GE(valores.size(), 3u) << clave;
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(valores[static_cast<std::size_t>(k)], v[k], cota) << clave << " " << k;
}

/// El centro de los píxeles del color de la señal en el panel de la ventana (abajo a la derecha).
o::Vec2 centroDeLaSenal(const Imagen &imagen) {
    double x = 0, y = 0;
    int n = 0;
    for (int py = 0; py < imagen.alto / 2; ++py)
        for (int px = imagen.ancho / 2; px < imagen.ancho; ++px) {
            const Pixel p = pixel(imagen, px, py);
            if (p.r == 217 && p.g == 51 && p.b == 46)
                x += px + 0.5, y += py + 0.5, ++n;
        }
    EXPECT_GT(n, 20);
    return {x / n, y / n};
}

} // namespace

// Cuatro esquinas del cubo, cada una elegida con el ratón en el panel de la ventana: lo que escribe en cada etapa contra el
// oráculo, y el píxel que señala. La matriz del modelo se hace en float: 4 redondeos de números menores que 2,
// 5e-7 en el mundo, y en la ventana por 1/tan(0.31)/4 y por 45 píxeles, 4e-5. La señal mide un número impar de
// píxeles, así que su centro dista del vértice medio como mucho en cada dirección.
TEST(EtapasPipeline, EsquinasDelCubo) {
    const int ancho = 240, alto = 180;
    double peor = 0, conLaImpresa = 0;
    for (const int k : {0, 3, 5, 6}) { // una de cada dos
        const o::Vec3 esquina{k & 1 ? 0.5 : -0.5, k & 2 ? 0.5 : -0.5, k & 4 ? 0.5 : -0.5},
            mundo = o::punto(MM, esquina), camara = o::enCamara(CAMARA, mundo);
        o::Vec3 ventana = o::proyecta(CAMARA, ancho / 2, alto / 2, mundo);
        ventana.x += ancho / 2;
        const Ejecucion e = ejecuta("ch04_vista3d/etapas_pipeline", clic(ventana.x, ventana.y, alto));
        ASSERT_EQ(e.estado, 0) << e.errores;
        auto v = lee(e.salida);
        esperaCerca(v["objeto"], esquina, 0, "objeto");
        esperaCerca(v["mundo"], mundo, 1e-6, "mundo");
        esperaCerca(v["cámara"], camara, 1e-6, "cámara");
        ASSERT_EQ(v["recortado"].size(), 4u);
        const double w = v["recortado"][3];
        EXPECT_NEAR(w, -camara.z, 1e-6);
        const o::Vec3 ndc{(ventana.x - ancho / 2) / 60 - 1, ventana.y / 45 - 1, 2 * ventana.z - 1};
        esperaCerca(v["recortado"], w * ndc, 1e-5, "recortado");
        esperaCerca(v["NDC"], ndc, 2e-6, "NDC");
        ASSERT_EQ(v["ventana"].size(), 2u);
        EXPECT_NEAR(v["ventana"][0], ventana.x, 1e-4);
        EXPECT_NEAR(v["ventana"][1], ventana.y, 1e-4);
        ASSERT_EQ(v["profundidad"].size(), 1u);
        EXPECT_NEAR(v["profundidad"][0], ventana.z, 2e-6);
        ASSERT_EQ(v["píxel"].size(), 2u);
        const Pixel p = pixel(e.imagen, static_cast<int>(v["píxel"][0]), static_cast<int>(v["píxel"][1]));
        EXPECT_TRUE(p.r == 217 && p.g == 51 && p.b == 46) << k;
        const o::Vec2 centro = centroDeLaSenal(e.imagen);
        const double dx = centro.x - v["ventana"][0], dy = centro.y - v["ventana"][1];
        EXPECT_LE(std::fabs(dx), 0.5 + 1e-3) << k;
        EXPECT_LE(std::fabs(dy), 0.5 + 1e-3) << k;
        peor = std::fmax(peor, std::fmax(std::fabs(dx), std::fabs(dy)));
        conLaImpresa = std::fmax(conLaImpresa, std::fmax(dx, dy) + 0.5);
    }
    std::cout << "del píxel a lo escrito, " << peor << " píxeles; con la ecuación 4.4 impresa serían "
              << conLaImpresa << "\n";
    EXPECT_GT(conLaImpresa, 0.6); // errata de la ecuación 4.4: resta medio píxel
}

// En el panel del mundo también se elige, y lejos de todo vértice no cambia nada.
TEST(EtapasPipeline, EligeEnElPanelDelMundo) {
    const o::Camara fuera = o::perspectiva(o::orbita(0.95, 0.35, 15.5, {0.2, 1.3, 0.6}), 0.5, 0.5, 100);
    const o::Vec3 esquina{0.5, 0.5, -0.5}, w = o::proyecta(fuera, 120, 90, o::punto(MM, esquina));
    const Ejecucion e = ejecuta("ch04_vista3d/etapas_pipeline", clic(120 + w.x, 90 + w.y, 180));
    esperaCerca(lee(e.salida)["objeto"], esquina, 0, "objeto");
    const Ejecucion lejos = ejecuta("ch04_vista3d/etapas_pipeline", clic(125, 5, 180)),
                    quieto = ejecuta("ch04_vista3d/etapas_pipeline");
    EXPECT_EQ(lejos.salida, quieto.salida);
    EXPECT_EQ(lejos.imagen.rgb, quieto.imagen.rgb);
}

// El triángulo recortado: lados y área contra el polígono exacto, y la imagen de la GPU, que recorta por su cuenta,
// contra ese mismo polígono, salvo el borde de 8 píxeles que lo señala.
TEST(EtapasPipeline, Recortado) {
    const int ancho = 960, alto = 720, nx = 480, ny = 360;
    const Ejecucion e = ejecuta("ch04_vista3d/etapas_pipeline", "tecla r", ancho, alto);
    ASSERT_EQ(e.estado, 0) << e.errores;
    std::vector<glm::dvec4> triangulo;
    for (const o::Vec3 &v : TRIANGULO) {
        const o::Vec3 c = o::enCamara(CAMARA, o::punto(MM, v));
        const double t = std::tan(0.31), d = -c.z;
        triangulo.push_back({c.x / t * ny / nx, c.y / t, ((4 + 8.5) * d - 2 * 4 * 8.5) / (8.5 - 4), d});
    }
    const std::vector<PuntoExacto> exacto = poligonoExacto(triangulo);
    auto v = lee(e.salida);
    ASSERT_EQ(v["lados"].size(), 1u);
    ASSERT_EQ(v["área en píxeles"].size(), 1u);
    EXPECT_EQ(v["lados"][0], static_cast<double>(exacto.size()));
    const double area = areaExacta(exacto) * nx * ny / 4;
    EXPECT_NEAR(v["área en píxeles"][0], area, 0.2); // 1e-4 píxeles por vértice y 1400 de perímetro
    std::cout << "lados " << exacto.size() << ", área " << v["área en píxeles"][0] << ", exacta " << area
              << "\n";

    o::Poligono p;
    for (const PuntoExacto &q : exacto)
        p.push_back({nx + nx * (1 + static_cast<double>(q.x)) / 2, ny * (1 + static_cast<double>(q.y)) / 2});
    int dentro = 0, fuera = 0;
    for (int y = 0; y < ny; ++y)
        for (int x = nx; x < ancho; ++x) {
            const double d = o::distanciaDentro(p, x + 0.5, y + 0.5);
            const Pixel c = pixel(e.imagen, x, y);
            const bool esSenal = c.r == 217 && c.g == 51 && c.b == 46;
            if (esSenal || std::fabs(d) < 8)
                continue;
            ++(d > 0 ? dentro : fuera);
            const bool esTriangulo = c.r > c.g && c.g > 2 * c.b,
                       esFondo = c.r == 199 && c.g == 224 && c.b == 245;
            ASSERT_TRUE(d > 0 ? esTriangulo : esFondo) << x << "," << y;
        }
    EXPECT_GT(dentro, 50000);
    EXPECT_GT(fuera, 30000);
}

// Un vértice de fuera del volumen llega hasta las coordenadas de recortado, y ahí se acaba.
TEST(EtapasPipeline, VerticeDeFuera) {
    const o::Camara objeto = o::perspectiva(o::orbita(0.95, 0.35, 8, {0, 0, 0}), 0.5, 0.5, 100);
    const o::Vec3 w = o::proyecta(objeto, 480, 360, TRIANGULO[2]);
    const Ejecucion e =
        ejecuta("ch04_vista3d/etapas_pipeline", "tecla r; " + clic(w.x, 360 + w.y, 720), 960, 720);
    ASSERT_EQ(e.estado, 0) << e.errores;
    auto v = lee(e.salida);
    EXPECT_EQ(v["vértice"], std::vector<double>{2});
    EXPECT_TRUE(v.count("fuera"));
    EXPECT_TRUE(v.count("recortado"));
    EXPECT_FALSE(v.count("NDC"));
    EXPECT_FALSE(v.count("ventana"));
}
