// Comprobaciones independientes de etapas_pipeline: las cuentas que escribe contra el oráculo, las coordenadas de
// ventana contra el píxel dibujado, y el recortado contra el polígono exacto, en números racionales.
#include "ch04_oraculo.h"
#include "ch04_vista3d/etapas.h"
#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>
#include <iostream>
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

// A un lado y otro de cada uno de los seis planos, y con w negativo.
TEST(Recortado, DentroYFueraDeCadaPlano) {
    for (int eje = 0; eje < 3; ++eje)
        for (const double signo : {-1.0, 1.0}) {
            glm::dvec4 r(0, 0, 0, 2);
            r[eje] = signo * 2;
            EXPECT_TRUE(estaDentro(r)) << eje << " " << signo;
            r[eje] = signo * 2.001;
            EXPECT_FALSE(estaDentro(r)) << eje << " " << signo;
            EXPECT_FALSE(estaDentro(-r)) << eje << " " << signo;
        }
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

/// Los datos de etapas_pipeline, escritos otra vez.
const o::Mat4 MM = o::traslada({0.2, 0.8, 0.3}) * o::gira({0, 1, 0}, -0.35) * o::escala({2, 1.2, 1.4}),
              TAPA = o::traslada({1.13, 1.82, 2.16}) * o::escala({0.6, 0.5, 0.2});
const double CERCA = 3, LEJOS = 7.5;
const o::Vec3 OJO{2.0, 3.4, 5.4};
const o::Vec3 TRIANGULO[] = {{-0.7, 0.8, -0.5}, {0.9, -0.2, 5}, {1.5, -0.6, -1.4}};
enum { OBJETO, MUNDO, CAMARA, NDC, VENTANA, PROFUNDIDAD };

/// Dónde dibuja el panel k, de tres columnas y dos filas en una ventana 4:3; debajo quedan los números.
Hueco panel(int k, int ancho, int alto) {
    return hueco(k % 3, 3, k / 3, 2, ancho, alto);
}
Hueco escena(int k, int ancho, int alto) {
    Hueco h = panel(k, ancho, alto);
    const int numeros = 7 * h.alto / 20;
    return {h.x, h.y + numeros, h.ancho, h.alto - numeros};
}
const o::Camara CAMARA_REF = oraculo::perspectiva(o::miraDesde(OJO, {0.1, 0.7, 0}), 0.62, CERCA, LEJOS);

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

o::Vec3 esquinaCubo(int k) {
    return {k & 1 ? 0.5 : -0.5, k & 2 ? 0.5 : -0.5, k & 4 ? 0.5 : -0.5};
}

/// Coordenadas de ventana de un punto del mundo, en el panel de la ventana.
o::Vec3 enVentana(const o::Vec3 &mundo, int ancho, int alto) {
    const Hueco h = escena(VENTANA, ancho, alto);
    o::Vec3 w = o::proyecta(CAMARA_REF, h.ancho, h.alto, mundo);
    w.x += h.x, w.y += h.y;
    return w;
}
o::Vec3 enNdc(const o::Vec3 &mundo, int ancho, int alto) {
    const Hueco h = escena(VENTANA, ancho, alto);
    const o::Vec3 w = enVentana(mundo, ancho, alto);
    return {2 * (w.x - h.x) / h.ancho - 1, 2 * (w.y - h.y) / h.alto - 1, 2 * w.z - 1};
}

/// Un punto del mundo en la imagen del panel k, visto desde fuera como lo ve el programa.
o::Vec3 enPanel(int k, const o::Vec3 &mundo, int ancho, int alto) {
    const Hueco h = escena(k, ancho, alto);
    const auto mira = [&](const o::Vec3 &p, double distancia, const o::Vec3 &centro) {
        o::Vec3 w = o::proyecta(oraculo::perspectiva(o::orbita(0.95, 0.35, distancia, centro), 0.5, 0.5, 100),
                                h.ancho, h.alto, p);
        w.x += h.x, w.y += h.y;
        return w;
    };
    const o::Vec3 n = enNdc(mundo, ancho, alto);
    switch (k) {
    case OBJETO: return mira(o::punto(o::inversa(MM), mundo), 6, {0, 0.2, 0});
    case MUNDO: return mira(mundo, 16, {0.6, 1.3, 1.4});
    case CAMARA: return mira(o::enCamara(CAMARA_REF, mundo), 17, {0, 0, -3.7});
    case NDC: return mira({n.x, n.y, -n.z}, 8, {0, 0, 0});
    default: return enVentana(mundo, ancho, alto);
    }
}

/// Lo que hay guardado en el píxel de una esquina del cubo: lo primero que el rayo encuentra aparte de las caras que la tocan, en
/// profundidad de 0 a 1.
double guardada(const o::Vec3 &mundo, bool tapado, int ancho, int alto) {
    const Hueco h = escena(VENTANA, ancho, alto);
    const o::Camara camara = CAMARA_REF;
    const o::Vec3 w = enVentana(mundo, ancho, alto);
    o::Rayo r = o::rayo(camara, h.ancho, h.alto, w.x - h.x, w.y - h.y);
    const double distancia = o::longitud(mundo - r.origen);
    double menor = 1;
    const auto mira = [&](const o::Objeto &objeto, double minimo, double maximo) {
        o::Rayo trozo = r;
        trozo.minimo = minimo, trozo.maximo = maximo;
        if (const o::Impacto i = o::primerImpacto({objeto}, trozo))
            menor = std::min(menor, o::proyecta(camara, h.ancho, h.alto, i.punto).z);
    };
    mira(o::caja(MM), r.minimo, distancia - 1e-4); // delante de la esquina, o detrás
    mira(o::caja(MM), distancia + 1e-4, r.maximo);
    if (tapado)
        mira(o::caja(TAPA), r.minimo, r.maximo);
    return menor;
}

/// Dos decimales, como en los rótulos.
std::u32string dosDecimales(double v) {
    char texto[32];
    std::snprintf(texto, sizeof texto, "%.2f", v);
    std::u32string s(texto, texto + std::string(texto).size());
    return s == U"-0.00" ? U"0.00" : s;
}

} // namespace

// Cuatro esquinas del cubo, cada una elegida con el ratón en el panel de la ventana: lo que escribe en cada etapa contra el
// oráculo, y el píxel que señala. La matriz del modelo se hace en float: 4 redondeos de números menores que 2,
// 5e-7 en el mundo, y en la ventana por 1/tan(0.31)/4 y por 58 píxeles, 5e-5. La señal es un disco: su centro está a menos
// de medio píxel del vértice.
TEST(EtapasPipeline, EsquinasDelCubo) {
    const int ancho = 480, alto = 360;
    double peor = 0, conLaImpresa = 0;
    for (const int k : {0, 3, 5, 6}) { // una de cada dos
        const o::Vec3 mundo = o::punto(MM, esquinaCubo(k)), ventana = enVentana(mundo, ancho, alto),
                      camara = o::enCamara(CAMARA_REF, mundo);
        const Ejecucion e =
            ejecuta("ch04_vista3d/etapas_pipeline", clic(ventana.x, ventana.y, alto), ancho, alto);
        ASSERT_EQ(e.estado, 0) << e.errores;
        auto v = lee(e.salida);
        esperaCerca(v["objeto"], esquinaCubo(k), 0, "objeto");
        esperaCerca(v["mundo"], mundo, 1e-6, "mundo");
        esperaCerca(v["cámara"], camara, 1e-6, "cámara");
        ASSERT_EQ(v["recortado"].size(), 4u);
        const double w = v["recortado"][3];
        EXPECT_NEAR(w, -camara.z, 1e-6);
        const o::Vec3 ndc = enNdc(mundo, ancho, alto);
        esperaCerca(v["recortado"], w * ndc, 1e-5, "recortado");
        esperaCerca(v["NDC"], ndc, 2e-6, "NDC");
        ASSERT_EQ(v["ventana"].size(), 2u);
        EXPECT_NEAR(v["ventana"][0], ventana.x, 1e-4);
        EXPECT_NEAR(v["ventana"][1], ventana.y, 1e-4);
        ASSERT_EQ(v["profundidad"].size(), 1u);
        EXPECT_NEAR(v["profundidad"][0], ventana.z, 2e-6);
        ASSERT_EQ(v["guardada"].size(), 1u);
        EXPECT_NEAR(v["guardada"][0], guardada(mundo, false, ancho, alto), 1e-5) << k;
        EXPECT_EQ(v.count("se pinta"), v["profundidad"][0] < v["guardada"][0] ? 1u : 0u);
        ASSERT_EQ(v["píxel"].size(), 2u);
        const int px = static_cast<int>(v["píxel"][0]), py = static_cast<int>(v["píxel"][1]);
        EXPECT_TRUE(esColor(pixel(e.imagen, px, py), ROJO)) << k;
        double x = 0, y = 0;
        int n = 0;
        for (int j = py - 8; j <= py + 8; ++j)
            for (int i = px - 8; i <= px + 8; ++i)
                if (esColor(pixel(e.imagen, i, j), ROJO))
                    x += i + 0.5, y += j + 0.5, ++n;
        ASSERT_GT(n, 20);
        const double dx = x / n - v["ventana"][0], dy = y / n - v["ventana"][1];
        EXPECT_LE(std::fabs(dx), 0.5) << k;
        EXPECT_LE(std::fabs(dy), 0.5) << k;
        peor = std::fmax(peor, std::fmax(std::fabs(dx), std::fabs(dy)));
        conLaImpresa = std::fmax(conLaImpresa, std::fmax(dx, dy) + 0.5);
    }
    std::cout << "del píxel a lo escrito, " << peor << " píxeles; con la ecuación 4.4 impresa serían "
              << conLaImpresa << "\n";
    EXPECT_GT(conLaImpresa, 0.55); // errata de la ecuación 4.4: resta medio píxel
}

// El mismo punto en los cinco primeros paneles, con sus números debajo; y el volumen de la vista alrededor.
TEST(EtapasPipeline, ElPuntoYSusNumerosEnCadaPanel) {
    const int ancho = 960, alto = 720, k = 7; // la esquina que se sigue al empezar
    const Ejecucion e = ejecuta("ch04_vista3d/etapas_pipeline", "", ancho, alto);
    ASSERT_EQ(e.estado, 0) << e.errores;
    const o::Vec3 mundo = o::punto(MM, esquinaCubo(k)), n = enNdc(mundo, ancho, alto),
                  camara = o::enCamara(CAMARA_REF, mundo), ventana = enVentana(mundo, ancho, alto);
    const char32_t *const titulos[] = {U"1 objeto",    U"2 mundo",   U"3 cámara",
                                       U"4 recortado", U"5 ventana", U"6 test de z"};
    const o::Vec3 numeros[] = {esquinaCubo(k), mundo, camara, n, ventana};
    const int celda = celdaDe(ancho, alto, 0.03);
    const auto rotulado = [&](int donde, const std::u32string &texto, const glm::vec3 &color) {
        const Hueco h = panel(donde, ancho, alto);
        for (const Rotulo &c : buscaRotulo(e.imagen, texto, color, celda))
            if (c.x > h.x && c.x < h.x + h.ancho && c.y > h.y && c.y < h.y + h.alto)
                return true;
        return false;
    };
    for (int donde = OBJETO; donde <= VENTANA; ++donde) {
        const o::Vec3 w = enPanel(donde, mundo, ancho, alto);
        for (const double d : {-4.0, 0.0, 4.0}) { // un disco de 15 píxeles
            EXPECT_TRUE(esColor(pixel(e.imagen, static_cast<int>(w.x + d), static_cast<int>(w.y)), ROJO))
                << donde;
            EXPECT_TRUE(esColor(pixel(e.imagen, static_cast<int>(w.x), static_cast<int>(w.y + d)), ROJO))
                << donde;
        }
        const std::u32string divididos = donde == NDC ? U"/w " : U" ";
        EXPECT_TRUE(rotulado(donde, U"x" + divididos + dosDecimales(numeros[donde].x), ROJO)) << donde;
        EXPECT_TRUE(rotulado(donde, U"y" + divididos + dosDecimales(numeros[donde].y), ROJO)) << donde;
        EXPECT_EQ(rotulado(donde, U"z" + divididos + dosDecimales(numeros[donde].z), ROJO), donde < VENTANA)
            << donde;
    }
    for (int donde = OBJETO; donde <= PROFUNDIDAD; ++donde)
        EXPECT_TRUE(rotulado(donde, titulos[donde], OSCURO)) << donde;
    EXPECT_TRUE(rotulado(NDC, U"w " + dosDecimales(-camara.z), ROJO));
    EXPECT_TRUE(rotulado(PROFUNDIDAD,
                         dosDecimales(ventana.z) + U" < " + dosDecimales(guardada(mundo, false, ancho, alto)),
                         ROJO));
    EXPECT_TRUE(rotulado(PROFUNDIDAD, U"se pinta", ROJO));

    // los marcos de cerca y de lejos, por el medio de sus lados de la derecha y de abajo
    const Hueco h = escena(VENTANA, ancho, alto);
    const double t = std::tan(0.31) * std::max(1.0, 4.0 * h.alto / (3.0 * h.ancho)),
                 a = static_cast<double>(h.ancho) / h.alto;
    const o::Ejes ejes = o::ejes(CAMARA_REF);
    for (const int donde : {MUNDO, CAMARA, NDC})
        for (const auto &[d, color] : {std::pair(CERCA, NARANJA), {LEJOS, AZUL}}) {
            int buenos = 0;
            for (int lado = 0; lado < 4; ++lado)
                for (const double u : {-0.5, 0.0, 0.5}) {
                    const double x = lado == 0   ? 1
                                     : lado == 1 ? -1
                                                 : u,
                                 y = lado == 2   ? 1
                                     : lado == 3 ? -1
                                                 : u;
                    const o::Vec3 p = OJO + d * (x * t * a * ejes.x + y * t * ejes.y - ejes.z),
                                  w = enPanel(donde, p, ancho, alto);
                    buenos += esColor(pixel(e.imagen, static_cast<int>(w.x), static_cast<int>(w.y)), color);
                }
            EXPECT_GE(buenos, 8) << donde << " a " << d; // de 12: los demás los tapa algo
        }
}

// Con algo delante, lo guardado es su profundidad y el fragmento se descarta; en la ventana se ve lo que tapa.
TEST(EtapasPipeline, Oculto) {
    const int ancho = 960, alto = 720;
    const Ejecucion e = ejecuta("ch04_vista3d/etapas_pipeline", "tecla o", ancho, alto);
    ASSERT_EQ(e.estado, 0) << e.errores;
    const o::Vec3 mundo = o::punto(MM, esquinaCubo(7)), w = enVentana(mundo, ancho, alto);
    auto v = lee(e.salida);
    ASSERT_EQ(v["guardada"].size(), 1u);
    const double z = guardada(mundo, true, ancho, alto);
    EXPECT_NEAR(v["guardada"][0], z, 1e-5);
    EXPECT_LT(v["guardada"][0], v["profundidad"][0]);
    EXPECT_TRUE(v.count("se descarta"));
    EXPECT_FALSE(v.count("se pinta"));
    EXPECT_EQ(
        buscaRotulo(e.imagen, U"se descarta", ROJO, celdaDe(e.imagen.ancho, e.imagen.alto, 0.03)).size(), 1u);
    EXPECT_EQ(buscaRotulo(e.imagen, dosDecimales(w.z) + U" ≥ " + dosDecimales(z), ROJO,
                          celdaDe(e.imagen.ancho, e.imagen.alto, 0.03))
                  .size(),
              1u);
    const Pixel p = pixel(e.imagen, static_cast<int>(w.x) - 14, static_cast<int>(w.y));
    EXPECT_TRUE(p.g > 1.5 * p.r && p.g > 1.5 * p.b)
        << p.r << " " << p.g << " " << p.b; // verde alrededor del punto
    // en la escala del sexto panel, el fragmento y la flecha de lo guardado
    const Hueco h = escena(PROFUNDIDAD, ancho, alto);
    const auto enEscala = [&](double valor, double y) {
        return pixel(e.imagen, static_cast<int>(h.x + h.ancho * (0.5 + 0.5 * (0.9 * valor - 0.45))),
                     static_cast<int>(h.y + h.alto * (0.5 + 0.5 * y)));
    };
    EXPECT_TRUE(esColor(enEscala(w.z, -0.1), ROJO));
    EXPECT_TRUE(esColor(enEscala(z, -0.5), OSCURO));
    EXPECT_FALSE(esColor(enEscala(w.z, -0.5), OSCURO));
    EXPECT_TRUE(esColor(enEscala(0, -0.1), NARANJA));
    EXPECT_TRUE(esColor(enEscala(1, -0.1), AZUL));
}

// En los otros paneles también se elige, y lejos de todo vértice no cambia nada.
TEST(EtapasPipeline, EligeEnCadaPanel) {
    const int ancho = 480, alto = 360;
    const o::Vec3 mundo = o::punto(MM, esquinaCubo(3));
    for (const int donde : {OBJETO, MUNDO, CAMARA, NDC}) {
        const o::Vec3 w = enPanel(donde, mundo, ancho, alto);
        const Ejecucion e = ejecuta("ch04_vista3d/etapas_pipeline", clic(w.x, w.y, alto), ancho, alto);
        esperaCerca(lee(e.salida)["objeto"], esquinaCubo(3), 0, "objeto");
    }
    const Ejecucion lejos = ejecuta("ch04_vista3d/etapas_pipeline", clic(165, 5, 180)),
                    quieto = ejecuta("ch04_vista3d/etapas_pipeline");
    EXPECT_EQ(lejos.salida, quieto.salida);
    EXPECT_EQ(lejos.imagen.rgb, quieto.imagen.rgb);
}

// El triángulo recortado: lados y área contra el polígono exacto, y la imagen de la GPU, que recorta por su cuenta,
// contra ese mismo polígono, salvo el borde de 8 píxeles que lo señala.
TEST(EtapasPipeline, Recortado) {
    const int ancho = 960, alto = 720;
    const Hueco h = escena(VENTANA, ancho, alto);
    const Ejecucion e = ejecuta("ch04_vista3d/etapas_pipeline", "tecla r", ancho, alto);
    ASSERT_EQ(e.estado, 0) << e.errores;
    const double t = std::tan(0.31) * std::max(1.0, 4.0 * h.alto / (3.0 * h.ancho));
    std::vector<glm::dvec4> triangulo;
    for (const o::Vec3 &v : TRIANGULO) {
        const o::Vec3 c = o::enCamara(CAMARA_REF, o::punto(MM, v));
        const double d = -c.z;
        triangulo.push_back({c.x / t * h.alto / h.ancho, c.y / t,
                             ((CERCA + LEJOS) * d - 2 * CERCA * LEJOS) / (LEJOS - CERCA), d});
    }
    const std::vector<PuntoExacto> exacto = poligonoExacto(triangulo);
    auto v = lee(e.salida);
    ASSERT_EQ(v["lados"].size(), 1u);
    ASSERT_EQ(v["área en píxeles"].size(), 1u);
    EXPECT_EQ(v["lados"][0], static_cast<double>(exacto.size()));
    const double area = areaExacta(exacto) * h.ancho * h.alto / 4;
    EXPECT_NEAR(v["área en píxeles"][0], area, 0.2); // 1e-4 píxeles por vértice y 1000 de perímetro
    std::cout << "lados " << exacto.size() << ", área " << v["área en píxeles"][0] << ", exacta " << area
              << "\n";

    o::Poligono p;
    for (const PuntoExacto &q : exacto)
        p.push_back({h.x + h.ancho * (1 + static_cast<double>(q.x)) / 2,
                     h.y + h.alto * (1 + static_cast<double>(q.y)) / 2});
    int dentro = 0, fuera = 0;
    for (int y = h.y; y < h.y + h.alto - 45; ++y) // arriba, el título
        for (int x = h.x; x < h.x + h.ancho; ++x) {
            const double d = o::distanciaDentro(p, x + 0.5, y + 0.5);
            const Pixel c = pixel(e.imagen, x, y);
            if (esColor(c, ROJO) || std::fabs(d) < 6)
                continue;
            ++(d > 0 ? dentro : fuera);
            const bool esTriangulo = c.r > c.g && c.g > 2 * c.b;
            ASSERT_TRUE(d > 0 ? esTriangulo : esColor(c, CIELO)) << x << "," << y;
        }
    EXPECT_GT(dentro, 30000);
    EXPECT_GT(fuera, 8000);
}

// Un vértice de fuera del volumen llega hasta las coordenadas de recortado, y ahí se acaba.
TEST(EtapasPipeline, VerticeDeFuera) {
    const Hueco h = escena(OBJETO, 960, 720);
    const o::Camara objeto = oraculo::perspectiva(o::orbita(0.95, 0.35, 14, {0, 0.2, 0}), 0.5, 0.5, 100);
    const o::Vec3 w = o::proyecta(objeto, h.ancho, h.alto, TRIANGULO[2]);
    const Ejecucion e =
        ejecuta("ch04_vista3d/etapas_pipeline", "tecla r; " + clic(h.x + w.x, h.y + w.y, 720), 960, 720);
    ASSERT_EQ(e.estado, 0) << e.errores;
    auto v = lee(e.salida);
    EXPECT_EQ(v["vértice"], std::vector<double>{2});
    EXPECT_TRUE(v.count("fuera"));
    EXPECT_TRUE(v.count("recortado"));
    EXPECT_FALSE(v.count("NDC"));
    EXPECT_FALSE(v.count("ventana"));
    EXPECT_EQ(buscaRotulo(e.imagen, U"no llega", ROJO, celdaDe(e.imagen.ancho, e.imagen.alto, 0.03)).size(),
              2u);
}
