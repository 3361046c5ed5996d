// Comprobaciones independientes de tiras (ch02_modelado/tiras.h): las tiras expandidas con la regla de la
// especificación de OpenGL son los mismos triángulos, y la respuesta del ejercicio 2.2 por búsqueda
// exhaustiva.
#include "azar.h"
#include "ch02_caja.h"
#include "ch02_modelado/tiras.h"
#include "guiones.h"
#include "rutas.h"
#include <algorithm>
#include <chrono>
#include <gtest/gtest.h>
#include <set>
#include <sstream>

namespace {

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
std::vector<T3> expande(const Tira &tira) {
    std::vector<T3> triangulos;
    for (std::size_t i = 1; i + 2 <= tira.size(); ++i) {
        const unsigned a = tira[i - 1], b = tira[i], c = tira[i + 1];
        if (a != b && b != c && c != a)
            triangulos.push_back(i % 2 == 1 ? T3{a, b, c} : T3{b, a, c});
    }
    return triangulos;
}

std::vector<T3> expandeTodas(const std::vector<Tira> &tiras) {
    std::vector<T3> triangulos;
    for (const Tira &tira : tiras)
        for (const T3 &t : expande(tira))
            triangulos.push_back(t);
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
    return std::size_t(mayor);
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

// Las de la caja, y la que dibuja la tecla u.
const std::vector<Tira> DOS = {{5, 2, 6, 3, 7, 4, 8, 1, 5, 2}, {2, 1, 3, 4}},
                        UNA = {{2, 1, 3, 4, 8, 1, 5, 2, 6, 3, 7, 8}};
const glm::vec3 COLORES[] = {NARANJA, AZUL};

std::string separados(const Tira &tira) {
    std::string texto;
    for (const unsigned i : tira)
        texto += (texto.empty() ? "" : " ") + std::to_string(i);
    return texto;
}

} // namespace

TEST(Tiras, ElProgramaDaLosMismosTriangulosConSuOrientacion) {
    EXPECT_EQ(canonicos(expandeTodas(DOS)), canonicos(TRIANGULOS));
    std::ostringstream dos, una;
    dos << "Tira 1: " << separados(DOS[0]) << "\nTira 2: " << separados(DOS[1])
        << "\nTriángulos: 10\nTiras: 2\nÍndices con tiras: 14\nÍndices con triángulos sueltos: 30\n";
    una << "Tira 1: " << separados(UNA[0])
        << "\nTriángulos: 10\nTiras: 1\nÍndices con tiras: 12\nÍndices con triángulos sueltos: 30\n";
    const Ejecucion e = ejecuta("tiras", "tecla 1; tecla u; tecla 1; tecla u");
    EXPECT_EQ(e.estado, 0) << e.errores;
    EXPECT_EQ(e.salida, dos.str() + una.str() + dos.str());
}

// Cada triángulo, del color de su tira: de claro a oscuro según su lugar, y el del medio tal cual. Encima, el recorrido por la
// tira y un punto en su primer vértice; de las que no se resaltan, solo el recorrido, más fino y gris.
TEST(Tiras, ColoresDeClaroAOscuroYResaltado) {
    const struct {
        std::string guion;
        std::vector<Tira> tiras;
        int resaltada; // desde 0
        int ancho, alto;
        double gira, sube;
    } casos[] = {{"", DOS, -1, ANCHO, ALTO, 0, 0},
                 {"tecla 1", DOS, 0, ANCHO, ALTO, 0, 0},
                 {"tecla 2", DOS, 1, 120, 200, 0, 0},
                 {"tecla 2; tecla 0", DOS, -1, 120, 200, 0, 0},
                 {"tecla 2; tecla 3; tecla x", DOS, 1, ANCHO, ALTO, 0, 0}, // no hay tercera tira
                 {"tecla u", UNA, -1, ANCHO, ALTO, 0, 0},
                 {"tecla 2; tecla u; tecla 2", UNA, -1, ANCHO, ALTO, 0, 0},
                 {"tecla u; tecla 1; tecla u", DOS, -1, 120, 200, 0, 0},
                 {arrastra({100, 100}, {300, 60}), DOS, -1, ANCHO, ALTO, -1, -0.2}};
    for (const auto &c : casos) {
        SCOPED_TRACE(c.guion);
        const oraculo::Camara camara = camaraCaja(0.66, 0.80, c.gira, c.sube);
        const Vista vista = vistaDe("tiras", c.guion, c.ancho, c.alto);
        std::vector<T3> triangulos;
        std::vector<oraculo::Vec3> colores;
        double largo[2] = {0, 0}; // de los recorridos apagados y de los encendidos
        std::vector<glm::dvec2> principios;
        for (std::size_t k = 0; k < c.tiras.size(); ++k) {
            const bool seDibuja = c.resaltada < 0 || c.resaltada == int(k);
            std::vector<glm::dvec2> recorrido;
            for (const unsigned i : c.tiras[k])
                recorrido.push_back(verticeEnPixeles(camara, i, c.ancho, c.alto));
            compruebaTrazo(vista.encima, recorrido, seDibuja ? OSCURO : GRIS);
            for (std::size_t i = 1; i < recorrido.size(); ++i)
                largo[seDibuja] += glm::distance(recorrido[i - 1], recorrido[i]);
            if (!seDibuja)
                continue;
            principios.push_back(recorrido[0]);
            const std::vector<T3> suyos = expande(c.tiras[k]);
            for (std::size_t i = 0; i < suyos.size(); ++i) {
                const double t = double(i) / double(suyos.size() - 1);
                const glm::dvec3 color = COLORES[k], clara = 0.75 * glm::dvec3(1) + 0.25 * color;
                colores.push_back(
                    exacto(t < 0.5 ? clara + 2 * t * (color - clara) : color * (1 - 0.65 * (2 * t - 1))));
                triangulos.push_back(suyos[i]);
            }
        }
        compruebaCaja(c.guion, vista.escena, triangulos, camara,
                      [&](const oraculo::Impacto &i) { return colores[std::size_t(i.corte.triangulo)]; });
        EXPECT_NEAR(vista.encima.largo(GRIS), largo[false], 0.1);
        EXPECT_NEAR(vista.encima.largo(OSCURO), largo[true], 0.1);
        const Encima puntos = vista.encima.trazos(OSCURO, "puntos");
        ASSERT_EQ(puntos.size(), 1u);
        ASSERT_EQ(puntos[0].puntos.size(), principios.size());
        for (std::size_t i = 0; i < principios.size(); ++i)
            EXPECT_LE(glm::distance(puntos[0].punto(i), principios[i]), 0.1);
        const double porGrosor = oraculo::altoUtil(c.ancho, c.alto) / 1080;
        const auto esperaGrueso = [&](const glm::vec3 &color, const char *tipo, double grosor) {
            for (const Pintado &p : vista.encima.trazos(color, tipo)) {
                EXPECT_NEAR(p.talla, std::max(grosor * porGrosor, 1.0), 1e-4);
                EXPECT_TRUE(p.conProfundidad);
            }
        };
        esperaGrueso(OSCURO, "puntos", 24);
        esperaGrueso(OSCURO, "segmentos", 6);
        esperaGrueso(GRIS, "segmentos", 3);
    }
}

// Los índices de cada tira, escritos en su color; el número de cada vértice. Y el recorrido, entero: la pared del frente está
// partida por 3–6, y sus caras no tapan la mitad de la línea.
TEST(Tiras, RotulosYRecorrido) {
    const std::vector<Vista> vistas = vistasDe("tiras", {"", "tecla u"}, 960, 720);
    const oraculo::Camara camara = camaraCaja(0.66, 0.80);
    for (const Vista &vista : vistas) {
        compruebaNumeros(vista.encima, camara, {1, 2, 3, 4, 5, 6, 7, 8});
        EXPECT_EQ(vista.encima.textos(0.8f * AZUL).size(), &vista == &vistas[0] ? 1u : 0u);
    }
    compruebaRotulo(vistas[0].encima, separados(DOS[0]), {0.02 * 960, 0.09 * 720}, 0.8f * NARANJA,
                    Lado::DERECHA);
    compruebaRotulo(vistas[0].encima, separados(DOS[1]), {0.02 * 960, 0.04 * 720}, 0.8f * AZUL,
                    Lado::DERECHA);
    compruebaRotulo(vistas[1].encima, "2 1 3 4 8 1 5 2 6 3\n7 8", {0.02 * 960, 0.04 * 720}, 0.8f * NARANJA,
                    Lado::DERECHA);
    const int grueso = gruesoPintado(imagenDe("tiras", "", ANCHO, ALTO), camara, 3, 6, OSCURO);
    EXPECT_TRUE(grueso >= 2 && grueso <= 4) << grueso;
}

TEST(Tiras, ConOtraMallaLaTeclaUNoHaceNada) {
    const std::string fichero = recurso("assets/ejercicio_2_1.vf");
    const Ejecucion nada = ejecuta("tiras", "", 120, 90, {fichero}),
                    u = ejecuta("tiras", "tecla u", 120, 90, {fichero});
    EXPECT_EQ(nada.imagen.rgb, u.imagen.rgb);
    EXPECT_EQ(nada.salida, u.salida);
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
            EXPECT_EQ(canonicos(malla), canonicos(expande(UNA[0])));
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
    const Tira encadenadas = {5, 2, 6, 3, 7, 4, 8, 1, 5, 2, 2, 2, 2, 1, 3, 4};
    EXPECT_EQ(encadenadas.size(), 16u);
    EXPECT_EQ(canonicos(expande(encadenadas)), canonicos(TRIANGULOS));
}

TEST(Tiras, MallasCualesquiera) {
    for (const Malla &m :
         {cubo(), esfera(3), esfera(17), cono(7), cilindro(12), toro(1, 0.3f, 9, 5), plano(4)}) {
        std::vector<T3> triangulos;
        for (std::size_t i = 0; i < m.indices.size(); i += 3)
            triangulos.push_back({m.indices[i], m.indices[i + 1], m.indices[i + 2]});
        const std::vector<Tira> tiras = hazTiras(triangulos);
        std::size_t nIndices = 0;
        for (const Tira &tira : tiras) {
            nIndices += tira.size();
            EXPECT_EQ(expandeTira(tira), expande(tira));
        }
        EXPECT_EQ(canonicos(expandeTodas(tiras)), canonicos(triangulos));
        EXPECT_LT(nIndices, m.indices.size());
    }
}

// Triángulos sin vecinos, repetidos, o con una arista de tres caras: cada uno, una vez.
TEST(Tiras, CasosSinVecinos) {
    for (const std::vector<T3> &malla :
         {std::vector<T3>{}, std::vector<T3>{{0, 1, 2}}, std::vector<T3>{{0, 1, 2}, {0, 1, 2}},
          std::vector<T3>{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, std::vector<T3>{{0, 1, 2}, {0, 1, 3}}})
        EXPECT_EQ(canonicos(expandeTodas(hazTiras(malla))), canonicos(malla));
}

// Una malla grande, en un tiempo que no crece con el cuadrado de sus triángulos: una cuadrícula de diagonales al azar, de muchas
// tiras cortas.
TEST(Tiras, MallaGrande) {
    const unsigned n = 300;
    Azar azar(1);
    std::vector<T3> triangulos;
    for (unsigned j = 0; j < n; ++j)
        for (unsigned i = 0; i < n; ++i) {
            const unsigned a = j * (n + 1) + i, b = a + 1, d = a + n + 1, c = d + 1;
            if (azar.entero(0, 1))
                triangulos.insert(triangulos.end(), {{a, b, c}, {a, c, d}});
            else
                triangulos.insert(triangulos.end(), {{a, b, d}, {b, c, d}});
        }
    const auto antes = std::chrono::steady_clock::now();
    const std::vector<Tira> tiras = hazTiras(triangulos);
    const std::chrono::duration<double> tiempo = std::chrono::steady_clock::now() - antes;
    EXPECT_LT(tiempo.count(), 20);
    EXPECT_EQ(canonicos(expandeTodas(tiras)), canonicos(triangulos));
}
