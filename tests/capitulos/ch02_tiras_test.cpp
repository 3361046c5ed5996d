// Comprobaciones independientes de tiras (ch02_modelado/tiras.h): las tiras expandidas con la regla de la
// especificación de OpenGL son los mismos triángulos, y la respuesta del ejercicio 2.2 por búsqueda
// exhaustiva.
#include "ch02_caja.h"
#include "ch02_modelado/tiras.h"
#include "ejecuta.h"
#include "malla.h"
#include "rutas.h"
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <gtest/gtest.h>
#include <set>
#include <sstream>

namespace {

using T3 = std::array<unsigned, 3>;

T3 canonico(unsigned a, unsigned b, unsigned c) { // el mismo triángulo orientado, empiece por donde empiece
    return a < b && a < c ? T3{a, b, c} : b < c ? T3{b, c, a} : T3{c, a, b};
}

std::multiset<T3> canonicos(const std::vector<T3> &triangulos) {
    std::multiset<T3> s;
    for (const T3 &t : triangulos)
        s.insert(canonico(t[0], t[1], t[2]));
    return s;
}

// Especificación de OpenGL 3.1, §2.6.1: el triángulo i de la tira (desde 1) es i, i+1, i+2 si i es impar y
// i+1, i, i+2 si es par. Los que repiten un vértice no tienen área.
std::vector<T3> expande(const std::vector<unsigned> &tira) {
    std::vector<T3> triangulos;
    for (std::size_t i = 1; i + 2 <= tira.size(); ++i) {
        const unsigned a = tira[i - 1], b = tira[i], c = tira[i + 1];
        if (a != b && b != c && c != a)
            triangulos.push_back(i % 2 == 1 ? T3{a, b, c} : T3{b, a, c});
    }
    return triangulos;
}

// La caja del ejercicio 2.1 con las caras 5 y 6 invertidas, a mano.
const std::vector<T3> TRIANGULOS = {{1, 3, 2}, {1, 4, 3}, {1, 2, 5}, {2, 6, 5}, {3, 6, 2},
                                    {3, 7, 6}, {3, 4, 7}, {4, 8, 7}, {4, 1, 8}, {1, 5, 8}};

// Todas las tiras sin índices repetidos, como máscaras de los triángulos que cubren. Una tira queda
// determinada por su principio: cada vértice nuevo es el del otro triángulo que tiene los dos últimos.
std::set<unsigned> todasLasTiras(const std::vector<T3> &malla, bool orientadas) {
    std::set<unsigned> tiras;
    for (std::size_t primero = 0; primero < malla.size(); ++primero) {
        T3 t = malla[primero];
        std::sort(t.begin(), t.end());
        do {
            if (orientadas && canonico(t[0], t[1], t[2]) !=
                                  canonico(malla[primero][0], malla[primero][1], malla[primero][2]))
                continue;
            unsigned a = t[1], b = t[2], cubiertos = 1u << primero;
            for (bool sigue = true; sigue;) {
                tiras.insert(cubiertos);
                sigue = false;
                for (std::size_t k = 0; k < malla.size() && !sigue; ++k) {
                    const T3 &m = malla[k];
                    const bool tieneA = std::count(m.begin(), m.end(), a) > 0,
                               tieneB = std::count(m.begin(), m.end(), b) > 0;
                    if (cubiertos >> k & 1 || !tieneA || !tieneB)
                        continue;
                    const unsigned c = m[0] + m[1] + m[2] - a - b;
                    a = b;
                    b = c;
                    cubiertos |= 1u << k;
                    sigue = true;
                }
            }
        } while (std::next_permutation(t.begin(), t.end()));
    }
    return tiras;
}

std::size_t masLarga(const std::set<unsigned> &tiras) {
    int mayor = 0;
    for (unsigned t : tiras)
        mayor = std::max(mayor, __builtin_popcount(t));
    return static_cast<std::size_t>(mayor);
}

// Menor número de tiras disjuntas que cubren los 10 triángulos, probándolas todas.
int minimoDeTiras(const std::set<unsigned> &tiras) {
    std::vector<int> minimo(1u << 10, 99);
    minimo[0] = 0;
    for (unsigned m = 0; m < minimo.size(); ++m)
        for (unsigned t : tiras)
            if (!(m & t))
                minimo[m | t] = std::min(minimo[m | t], minimo[m] + 1);
    return minimo.back();
}

// Las tiras que enumera el programa, con los índices desde 1.
std::vector<std::vector<unsigned>> tirasEscritas(const std::string &salida) {
    std::vector<std::vector<unsigned>> tiras;
    std::istringstream lineas(salida);
    for (std::string linea; std::getline(lineas, linea);) {
        if (linea.rfind("Tira ", 0) != 0)
            continue;
        std::istringstream numeros(linea.substr(linea.find(':') + 1));
        tiras.emplace_back();
        for (unsigned i; numeros >> i;)
            tiras.back().push_back(i);
    }
    return tiras;
}

} // namespace

TEST(Tiras, ElProgramaDaLosMismosTriangulosConSuOrientacion) {
    const Ejecucion e = ejecuta("ch02_modelado/tiras");
    ASSERT_EQ(e.estado, 0) << e.errores;
    std::vector<T3> triangulos;
    std::size_t nIndices = 0;
    const auto tiras = tirasEscritas(e.salida);
    for (const std::vector<unsigned> &tira : tiras) {
        for (const T3 &t : expande(tira))
            triangulos.push_back(t);
        nIndices += tira.size();
    }
    EXPECT_EQ(canonicos(triangulos), canonicos(TRIANGULOS));
    EXPECT_NE(e.salida.find("Triángulos: 10\nTiras: " + std::to_string(tiras.size()) + "\n"),
              std::string::npos);
    EXPECT_NE(e.salida.find("Índices con tiras: " + std::to_string(nIndices) + "\n"), std::string::npos);
    EXPECT_NE(e.salida.find("Índices con triángulos sueltos: 30\n"), std::string::npos);
    EXPECT_EQ(tiras.size(), 2u);
    EXPECT_EQ(nIndices, 14u);
}

// Cada triángulo que se ve, del color de su tira: de claro a oscuro según su lugar, y el del medio tal cual. `resaltada` desde 0.
void esperaTiras(const std::string &guion, const std::vector<std::vector<unsigned>> &tiras,
                 int resaltada = -1) {
    const glm::dvec3 colores[] = {NARANJA, AZUL};
    std::vector<std::array<int, 3>> triangulos;
    std::vector<glm::dvec3> esperados;
    for (std::size_t k = 0; k < tiras.size(); ++k) {
        if (resaltada >= 0 && resaltada != static_cast<int>(k))
            continue;
        const auto deLaTira = expande(tiras[k]);
        for (std::size_t i = 0; i < deLaTira.size(); ++i) {
            const double t = static_cast<double>(i) / static_cast<double>(deLaTira.size() - 1);
            const glm::dvec3 c = colores[k], clara = 0.75 * glm::dvec3(1) + 0.25 * c;
            esperados.push_back(t < 0.5 ? clara + 2 * t * (c - clara) : c * (1 - 0.65 * (2 * t - 1)));
            triangulos.push_back({static_cast<int>(deLaTira[i][0]), static_cast<int>(deLaTira[i][1]),
                                  static_cast<int>(deLaTira[i][2])});
        }
    }
    const Imagen imagen = ejecuta("ch02_modelado/tiras", guion, ANCHO, ALTO).imagen;
    const VistaCaja vista(0.66, 0.80);
    const oraculo::Escena escena = {mallaCaja(triangulos)};
    int vistos = 0;
    for (std::size_t i = 0; i < triangulos.size(); ++i) {
        const Mayoria m = mayoria(imagen, escena, vista.camara, static_cast<int>(i));
        if (m.pixeles < 400)
            continue;
        ++vistos;
        EXPECT_LE(m.diferencia(esperados[i]), 1) << guion << " triángulo " << i;
        EXPECT_GT(m.parte, 0.25) << guion << " triángulo " << i;
    }
    EXPECT_GE(vistos, resaltada == 1 ? 2 : 6) << guion;
    EXPECT_LE(mayoria(imagen, escena, vista.camara, -1).diferencia(FONDO_CLARO), 1);
    // un punto en el primer vértice de cada tira que se dibuja, y en ninguno más de los que se ven
    for (unsigned v = 2; v <= 8; ++v) {
        bool principio = false;
        for (std::size_t k = 0; k < tiras.size(); ++k)
            principio =
                principio || (tiras[k][0] == v && (resaltada < 0 || resaltada == static_cast<int>(k)));
        const glm::dvec2 p = vista.enPixel(vista.vertice(static_cast<int>(v)));
        int oscuros = 0;
        for (int dy = -3; dy <= 3; ++dy)
            for (int dx = -3; dx <= 3; ++dx)
                oscuros += distanciaColor(imagen, static_cast<int>(p.x) + dx, static_cast<int>(p.y) + dy,
                                          OSCURO) <= 1;
        EXPECT_EQ(oscuros > 34, principio) << guion << " vértice " << v << ": " << oscuros;
    }
}

TEST(Tiras, ColoresDeClaroAOscuroYResaltado) {
    const auto dos = tirasEscritas(ejecuta("ch02_modelado/tiras").salida);
    esperaTiras("", dos);
    esperaTiras("tecla 1", dos, 0);
    esperaTiras("tecla 2", dos, 1);
    esperaTiras("tecla 2; tecla 0", dos);
    esperaTiras("tecla 2; tecla 3; tecla x", dos, 1); // no hay tercera tira
    const std::vector<std::vector<unsigned>> una = {{2, 1, 3, 4, 8, 1, 5, 2, 6, 3, 7, 8}};
    esperaTiras("tecla u", una);
    esperaTiras("tecla 2; tecla u", una);
    esperaTiras("tecla u; tecla u", dos);
}

// Los índices de cada tira, escritos en su color; el número de cada vértice que se ve, junto a él. Y el recorrido por la tira.
TEST(Tiras, RotulosYRecorrido) {
    const Imagen dos = ejecuta("ch02_modelado/tiras", "", 960, 720).imagen,
                 una = ejecuta("ch02_modelado/tiras", "tecla u", 960, 720).imagen;
    const auto tira1 = buscaRotulo(dos, U"5 2 6 3 7 4 8 1 5 2", 0.8f * NARANJA, 3),
               tira2 = buscaRotulo(dos, U"2 1 3 4", 0.8f * AZUL, 3);
    ASSERT_TRUE(tira1.size() == 1 && tira2.size() == 1);
    EXPECT_GT(tira1[0].y, tira2[0].y);
    EXPECT_EQ(buscaRotulo(una, U"2 1 3 4 8 1 5 2 6 3 7 8", 0.8f * NARANJA, 3).size(), 1u);
    const VistaCaja vista(0.66, 0.80, 960, 720);
    for (int i = 1; i <= 8; ++i) {
        const glm::dvec2 v = vista.enPixel(vista.vertice(i));
        EXPECT_LT(glm::distance(rotuloJunto(dos, enLetras(i), OSCURO, 4, v), v), 40) << i;
    }
    // la pared del frente está partida por 3–6, no por 2–7
    const auto oscuro = [&](const Imagen &imagen, int a, int b) {
        const glm::dvec2 p = vista.enPixel(0.25 * vista.vertice(a) + 0.75 * vista.vertice(b));
        return distanciaColor(imagen, static_cast<int>(p.x), static_cast<int>(p.y), OSCURO) <= 1;
    };
    EXPECT_TRUE(oscuro(dos, 3, 6) && oscuro(una, 3, 6));
    EXPECT_FALSE(oscuro(dos, 2, 7) || oscuro(una, 2, 7));
}

TEST(Tiras, ConOtraMallaLaTeclaUNoHaceNada) {
    const std::string fichero = recurso("assets/ejercicio_2_1.vf");
    const Ejecucion nada = ejecuta("ch02_modelado/tiras", "", 120, 90, {fichero}),
                    u = ejecuta("ch02_modelado/tiras", "tecla u", 120, 90, {fichero});
    EXPECT_EQ(nada.imagen.rgb, u.imagen.rgb);
    const std::string salida = ejecuta("ch02_modelado/tiras", "tecla u", 120, 90).salida;
    EXPECT_NE(
        salida.find("Tira 1: 2 1 3 4 8 1 5 2 6 3 7 8\nTriángulos: 10\nTiras: 1\nÍndices con tiras: 12\n"),
        std::string::npos);
}

// La respuesta del ejercicio 2.2.
TEST(Tiras, UnaSolaTiraNoBasta) {
    const auto orientadas = todasLasTiras(TRIANGULOS, true), todas = todasLasTiras(TRIANGULOS, false);
    EXPECT_EQ(masLarga(orientadas), 8u);
    EXPECT_EQ(minimoDeTiras(orientadas), 2);
    EXPECT_LT(masLarga(todas), 10u); // ni aunque dé igual en qué sentido giren
    EXPECT_EQ(minimoDeTiras(todas), 2);
}

// La misma caja con las diagonales que se quieran, una por pared y la del fondo: de las 2⁵ maneras, en 10 sí
// hay una tira, y en 6 de ellas sin descuidar el sentido. Basta cambiar una de las del ejercicio.
TEST(Tiras, CambiandoUnaDiagonalSi) {
    // en cada lado, la diagonal del ejercicio es la del primer vértice al tercero
    const unsigned lados[5][4] = {{1, 4, 3, 2}, {2, 6, 5, 1}, {3, 7, 6, 2}, {4, 8, 7, 3}, {1, 5, 8, 4}};
    int conUna = 0, conUnaOrientada = 0, conUnCambio = 0;
    for (unsigned cambiadas = 0; cambiadas < 32; ++cambiadas) {
        std::vector<T3> malla;
        for (unsigned k = 0; k < 5; ++k) {
            const unsigned *q = lados[k];
            if (cambiadas >> k & 1)
                malla.insert(malla.end(), {{q[1], q[2], q[3]}, {q[1], q[3], q[0]}});
            else
                malla.insert(malla.end(), {{q[0], q[1], q[2]}, {q[0], q[2], q[3]}});
        }
        if (cambiadas == 0) {
            EXPECT_EQ(canonicos(malla), canonicos(TRIANGULOS));
        }
        if (cambiadas == 8) { // 3–8 en lugar de 4–7
            EXPECT_EQ(canonicos(malla), canonicos(expande({2, 1, 3, 4, 8, 1, 5, 2, 6, 3, 7, 8})));
        }
        const bool una = masLarga(todasLasTiras(malla, false)) == 10,
                   orientada = masLarga(todasLasTiras(malla, true)) == 10;
        conUna += una;
        conUnaOrientada += orientada;
        conUnCambio += orientada && __builtin_popcount(cambiadas) == 1;
    }
    EXPECT_EQ(conUna, 10);
    EXPECT_EQ(conUnaOrientada, 6);
    EXPECT_GT(conUnCambio, 0);
}

// Repitiendo dos índices, las dos tiras se encadenan en una de 16 con dos uniones sin área.
TEST(Tiras, ConIndicesRepetidosSi) {
    const std::vector<unsigned> una = {5, 2, 6, 3, 7, 4, 8, 1, 5, 2, 2, 2, 2, 1, 3, 4};
    EXPECT_EQ(una.size(), 16u);
    EXPECT_EQ(canonicos(expande(una)), canonicos(TRIANGULOS));
}

TEST(Tiras, MallasCualesquiera) {
    for (const Malla &m :
         {cubo(), esfera(3), esfera(17), cono(7), cilindro(12), toro(1, 0.3f, 9, 5), plano(4)}) {
        std::vector<T3> triangulos;
        for (std::size_t i = 0; i < m.indices.size(); i += 3)
            triangulos.push_back({m.indices[i], m.indices[i + 1], m.indices[i + 2]});
        std::vector<T3> expandidos;
        std::size_t nIndices = 0;
        for (const Tira &tira : hazTiras(triangulos)) {
            nIndices += tira.size();
            for (const T3 &t : expande(tira))
                expandidos.push_back(t);
            EXPECT_EQ(expandeTira(tira).size(), tira.size() - 2);
            EXPECT_EQ(canonicos(expandeTira(tira)), canonicos(expande(tira)));
        }
        EXPECT_EQ(canonicos(expandidos), canonicos(triangulos));
        EXPECT_LT(nIndices, m.indices.size());
    }
}

// Triángulos sin vecinos, repetidos, o con una arista de tres caras: cada uno, una vez.
TEST(Tiras, CasosSinVecinos) {
    for (const std::vector<T3> &malla :
         {std::vector<T3>{}, std::vector<T3>{{0, 1, 2}}, std::vector<T3>{{0, 1, 2}, {0, 1, 2}},
          std::vector<T3>{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, std::vector<T3>{{0, 1, 2}, {0, 1, 3}}}) {
        std::vector<T3> expandidos;
        for (const Tira &tira : hazTiras(malla))
            for (const T3 &t : expande(tira))
                expandidos.push_back(t);
        EXPECT_EQ(canonicos(expandidos), canonicos(malla));
    }
}

// Una malla grande, en un tiempo que no crece con el cuadrado de sus triángulos: una cuadrícula de diagonales al azar, de muchas
// tiras cortas.
TEST(Tiras, MallaGrande) {
    const unsigned n = 300;
    unsigned azar = 1;
    std::vector<T3> triangulos;
    for (unsigned j = 0; j < n; ++j)
        for (unsigned i = 0; i < n; ++i) {
            const unsigned a = j * (n + 1) + i, b = a + 1, d = a + n + 1, c = d + 1;
            azar = azar * 1664525u + 1013904223u;
            if (azar >> 31)
                triangulos.insert(triangulos.end(), {{a, b, c}, {a, c, d}});
            else
                triangulos.insert(triangulos.end(), {{a, b, d}, {b, c, d}});
        }
    const auto antes = std::chrono::steady_clock::now();
    const std::vector<Tira> tiras = hazTiras(triangulos);
    const std::chrono::duration<double> tiempo = std::chrono::steady_clock::now() - antes;
    EXPECT_LT(tiempo.count(), 20);
    std::vector<T3> expandidos;
    for (const Tira &tira : tiras)
        for (const T3 &t : expande(tira))
            expandidos.push_back(t);
    EXPECT_EQ(canonicos(expandidos), canonicos(triangulos));
    std::printf("%zu triángulos, %zu tiras: %.2f s\n", triangulos.size(), tiras.size(), tiempo.count());
}
