// Comprobaciones independientes de malla_vf y de su análisis (ch02_modelado/topologia.h).
#include "ch02_caja.h"
#include "ch02_modelado/encuadre_malla.h"
#include "ch02_modelado/topologia.h"
#include "guiones.h"
#include <algorithm>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <set>
#include <sstream>

namespace {

const std::vector<T3> CARAS = {{1, 3, 2}, {1, 4, 3}, {1, 2, 5}, {2, 6, 5}, {3, 2, 6},
                               {3, 6, 7}, {3, 4, 7}, {4, 8, 7}, {4, 1, 8}, {1, 5, 8}};

/// Lo que escribe malla_vf de una malla orientable de una componente sin aristas de más de dos caras.
std::string informe(int vertices, int caras, int borde, const std::string &contrarias,
                    const std::string &sentido) {
    std::ostringstream s;
    s << "Vértices: " << vertices << "\nCaras: " << caras << "\nComponentes: 1\nAristas de borde: " << borde
      << "\nAristas de más de dos caras: 0\nOrientable: sí\nCaras con orientación contraria: " << contrarias
      << "\nSentido visto desde fuera: " << sentido << "\n";
    return s.str();
}

/// La ruta de un fichero con ese texto.
std::string fichero(const std::string &texto) {
    const std::string ruta = (carpetaTemporal() / "malla.vf").string();
    std::ofstream(ruta) << texto;
    return ruta;
}

MallaVf cuboCerrado() {
    MallaVf m;
    m.vertices.assign(CAJA, CAJA + 8);
    m.caras = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {3, 7, 6, 2}, {1, 2, 6, 5}, {0, 4, 7, 3}};
    return m;
}

void anade(MallaVf &m, const MallaVf &otra, const glm::vec3 &donde) {
    const unsigned base = unsigned(m.vertices.size());
    for (const glm::vec3 &v : otra.vertices)
        m.vertices.push_back(v + donde);
    for (std::vector<unsigned> cara : otra.caras) {
        for (unsigned &i : cara)
            i += base;
        m.caras.push_back(cara);
    }
}

MallaVf alReves(MallaVf m) {
    for (auto &cara : m.caras)
        std::reverse(cara.begin(), cara.end());
    return m;
}

} // namespace

// Sin topología ninguna: la caja es convexa, así que una cara gira en sentido antihorario vista desde fuera
// si su normal se aleja del centro (½,½,½). Solo la 5 y la 6 no lo hacen.
TEST(MallaVf, LasCaras5y6EstanAlReves) {
    for (std::size_t c = 0; c < 10; ++c) {
        const glm::vec3 &p = CAJA[CARAS[c][0] - 1], &q = CAJA[CARAS[c][1] - 1], &r = CAJA[CARAS[c][2] - 1];
        const float fuera = glm::dot(glm::cross(q - p, r - p), (p + q + r) / 3.0f - 0.5f);
        ASSERT_GT(std::fabs(fuera), 0.1f);
        EXPECT_EQ(fuera < 0, c + 1 == 5 || c + 1 == 6) << "cara " << c + 1;
    }
}

// El de antes y, tras f, el de después.
TEST(MallaVf, InformeDelEjercicio) {
    const Ejecucion e = ejecuta("malla_vf", "tecla f; tecla F; tecla f");
    EXPECT_EQ(e.estado, 0);
    EXPECT_EQ(e.errores, "");
    const std::string al = informe(8, 10, 4, "5, 6", "antihorario"),
                      derecho = informe(8, 10, 4, "ninguna", "antihorario");
    EXPECT_EQ(e.salida, al + derecho + al);
}

// Cada cara, con la cámara y la luz calculadas en doble precisión: azul si desde el ojo sus vértices giran en sentido
// antihorario y amarilla si no. Los triángulos son los del enunciado; con f, la 5 y la 6 al revés.
TEST(MallaVf, ElColorDiceElSentido) {
    std::vector<T3> arregladas = CARAS;
    for (const std::size_t c : {4u, 5u})
        std::swap(arregladas[c][1], arregladas[c][2]);
    const struct {
        std::string guion;
        bool arreglada;
        int ancho, alto;
        double gira, sube;
    } casos[] = {{"", false, ANCHO, ALTO, 0, 0},
                 {"tecla f", true, ANCHO, ALTO, 0, 0},
                 {"tecla f; tecla x; tecla f", false, 120, 200, 0, 0},
                 {arrastra({100, 100}, {300, 60}), false, ANCHO, ALTO, -1, -0.2}};
    for (const auto &c : casos)
        compruebaCaja("«" + c.guion + "»", vistaDe("malla_vf", c.guion, c.ancho, c.alto).escena,
                      c.arreglada ? arregladas : CARAS, camaraCaja(0.55, 0.62, c.gira, c.sube),
                      [](const oraculo::Impacto &i) {
                          return luzFija(i.frente ? i.normalCara : -i.normalCara) *
                                 exacto(i.frente ? AZUL : AMARILLO);
                      });
}

// Las de la boca, gruesas y rojas; las demás, finas y oscuras; y ninguna más.
TEST(MallaVf, Aristas) {
    const Encima encima = vistaDe("malla_vf", "", ANCHO, ALTO).encima;
    const oraculo::Camara camara = camaraCaja(0.55, 0.62);
    const std::set<std::pair<unsigned, unsigned>> boca = {{5, 6}, {6, 7}, {7, 8}, {5, 8}};
    std::set<std::pair<unsigned, unsigned>> aristas;
    for (const T3 &c : CARAS)
        for (const std::size_t i : {0u, 1u, 2u})
            aristas.insert(std::minmax(c[i], c[(i + 1) % 3]));
    EXPECT_EQ(aristas.size(), 17u);
    double rojo = 0, oscuro = 0;
    for (const auto &[a, b] : aristas) {
        const glm::dvec2 p = verticeEnPixeles(camara, a), q = verticeEnPixeles(camara, b);
        const bool deBorde = boca.count({a, b}) > 0;
        compruebaTrazo(encima, {p, q}, deBorde ? ROJO : OSCURO);
        (deBorde ? rojo : oscuro) += glm::distance(p, q);
    }
    EXPECT_NEAR(encima.largo(ROJO), rojo, 0.1);
    EXPECT_NEAR(encima.largo(OSCURO), oscuro, 0.1);
    ASSERT_TRUE(encima.trazos(ROJO).size() == 1 && encima.trazos(OSCURO).size() == 1);
    EXPECT_EQ(encima.trazos(ROJO)[0].talla, 12 * 360 / 1080);
    EXPECT_EQ(encima.trazos(OSCURO)[0].talla, 1);
    EXPECT_TRUE(encima.trazos(ROJO)[0].conProfundidad && encima.trazos(OSCURO)[0].conProfundidad);
    // y una cara no tapa la mitad de las suyas: a lo alto se ven enteras
    const Imagen imagen = imagenDe("malla_vf", "", ANCHO, ALTO);
    for (const auto &[a, b] : boca) {
        const int n = gruesoPintado(imagen, camara, a, b, ROJO);
        EXPECT_TRUE(n >= 4 && n <= 9) << a << "-" << b << ": " << n;
    }
    const int n = gruesoPintado(imagen, camara, 3, 6, OSCURO);
    EXPECT_TRUE(n >= 1 && n <= 3) << n;
}

// El número de cada vértice que se ve (todos menos el 1, el del fondo), y el de cada cara, en su centro.
TEST(MallaVf, Numeros) {
    const Encima encima = vistaDe("malla_vf", "", 960, 720).encima;
    const oraculo::Camara camara = camaraCaja(0.55, 0.62);
    compruebaNumeros(encima, camara, {2, 3, 4, 5, 6, 7, 8});
    for (const unsigned cara : {5u, 6u, 7u, 8u, 10u}) {
        oraculo::Vec3 centro;
        for (const unsigned i : CARAS[cara - 1])
            centro = centro + 1 / 3.0 * verticeCaja(i);
        compruebaRotulo(rotulosDe(encima, BLANCO), std::to_string(cara), enPixeles(camara, centro, 960, 720),
                        BLANCO, Lado::CENTRO);
    }
    EXPECT_EQ(encima.textos(BLANCO).size(), 5u);
    compruebaRotulo(encima, "anverso", {0.02 * 960, 0.185 * 720}, AZUL, Lado::DERECHA);
    compruebaRotulo(encima, "reverso", {0.02 * 960, 0.125 * 720}, AMARILLO, Lado::DERECHA);
    compruebaRotulo(encima, "borde", {0.02 * 960, 0.065 * 720}, ROJO, Lado::DERECHA);
}

// Un prisma de base pentagonal con caras de 4 y 5 vértices, enorme y lejos del origen: llena la ventana sin
// salirse.
TEST(MallaVf, CualquierMallaLlenaLaVentana) {
    std::ostringstream texto, lados;
    for (int k = 0; k < 10; ++k) {
        const double a = 2 * oraculo::PI * (k % 5) / 5;
        texto << "v " << 100000 + 3000 * std::cos(a) << (k < 5 ? " -70000 " : " -66000 ")
              << 3000 * std::sin(a) << "\n";
    }
    texto << "f 1 2 3 4 5\nf 10 9 8 7 6\n";
    for (int k = 1; k <= 5; ++k)
        texto << "f " << k << " " << k + 5 << " " << k % 5 + 6 << " " << k % 5 + 1 << "\n";
    const std::string ruta = fichero(texto.str());
    EXPECT_EQ(ejecuta("malla_vf", "", 240, 180, {ruta}).salida, informe(10, 7, 0, "ninguna", "antihorario"));
    const Imagen imagen = imagenDe("malla_vf", "", 240, 180, {ruta});
    glm::ivec2 minimo(240, 180), maximo(0);
    for (int y = 0; y < 180; ++y)
        for (int x = 0; x < 240; ++x)
            if (oraculo::diferencia(imagen, x, y, exacto(FONDO_CLARO)) > 1) {
                minimo = glm::min(minimo, glm::ivec2(x, y));
                maximo = glm::max(maximo, glm::ivec2(x, y));
            }
    EXPECT_GT(maximo.y - minimo.y, 180 * 8 / 10);
    EXPECT_TRUE(minimo.x > 0 && minimo.y > 0 && maximo.x < 239 && maximo.y < 179);
}

// Una malla de un solo punto, o que se ve de canto, no estropea la cámara.
TEST(MallaVf, MallasSinTalla) {
    for (const char *texto :
         {"v 5 5 5\nv 5 5 5\nv 5 5 5\nf 1 2 3\n", "v 1 1 1\nv 2 2 2\nv 3 3 3\nf 1 2 3\n"}) {
        const Ejecucion e = ejecuta("malla_vf", "tecla f", 60, 45, {fichero(texto)});
        EXPECT_EQ(e.estado, 0) << e.errores;
        EXPECT_EQ(e.salida,
                  informe(3, 1, 3, "ninguna", "indefinido") + informe(3, 1, 3, "ninguna", "indefinido"));
    }
}

// La arista de tres caras, en morado.
TEST(MallaVf, AristaDeTresCaras) {
    const std::string ruta =
        fichero("v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 1\nv -1 0 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n");
    EXPECT_NE(ejecuta("malla_vf", "", 60, 45, {ruta})
                  .salida.find("Componentes: 3\nAristas de borde: 6\nAristas de más de dos caras: 1\n"),
              std::string::npos);
    const Encima encima = vistaDe("malla_vf", "", ANCHO, ALTO, {ruta}).encima;
    ASSERT_EQ(encima.trazos(MORADO).size(), 1u);
    EXPECT_EQ(encima.trazos(MORADO)[0].puntos.size(), 2u);
    EXPECT_EQ(encima.trazos(ROJO).at(0).puntos.size(), 12u);
    EXPECT_TRUE(encima.trazos(OSCURO).empty());
}

TEST(MallaVf, ErroresDelUsuario) {
    const struct {
        std::vector<std::string> argumentos;
        int estado;
        std::string error;
    } casos[] = {{{"a.vf", "b.vf"}, 2, "sobra «b.vf»"},
                 {{"no_existe.vf"}, 1, "no_existe.vf"},
                 {{fichero("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n")}, 1, ":4: "}};
    for (const std::string programa : {"malla_vf", "tiras"})
        for (const auto &c : casos) {
            const Ejecucion e = ejecuta(programa, "", 60, 45, c.argumentos);
            EXPECT_EQ(e.estado, c.estado) << programa;
            EXPECT_NE(e.errores.find(c.error), std::string::npos) << e.errores;
        }
}

TEST(Topologia, SolidoCerradoEnLosDosSentidos) {
    for (const glm::vec3 &donde : {glm::vec3(0), glm::vec3(-1e6f, 2e6f, 3e6f)}) {
        MallaVf m;
        anade(m, cuboCerrado(), donde);
        const Topologia t = analizaTopologia(m), i = analizaTopologia(alReves(m));
        EXPECT_EQ(t.aristas.size(), 12u);
        EXPECT_EQ(t.deBorde, 0u);
        EXPECT_TRUE(t.contrarias.empty() && i.contrarias.empty());
        EXPECT_EQ(t.sentidos, std::vector<Sentido>{Sentido::ANTIHORARIO});
        EXPECT_EQ(i.sentidos, std::vector<Sentido>{Sentido::HORARIO});
    }
}

// Con cualquier subconjunto de caras invertido, las contrarias son la minoría (en un empate, las que no
// concuerdan con la primera), y arreglarla las deja todas concordes. Los 64 casos.
TEST(Topologia, LaMayoriaManda) {
    for (unsigned invertidas = 0; invertidas < 64; ++invertidas) {
        MallaVf m = cuboCerrado();
        std::vector<std::size_t> si, no;
        for (std::size_t c = 0; c < 6; ++c) {
            if (invertidas >> c & 1)
                std::reverse(m.caras[c].begin(), m.caras[c].end());
            (invertidas >> c & 1 ? si : no).push_back(c);
        }
        const bool ganaNo = no.size() > si.size() || (no.size() == si.size() && !(invertidas & 1));
        const Topologia t = analizaTopologia(m);
        EXPECT_EQ(t.contrarias, ganaNo ? si : no) << invertidas;
        EXPECT_EQ(t.sentidos[0], ganaNo ? Sentido::ANTIHORARIO : Sentido::HORARIO) << invertidas;
        const Topologia despues = analizaTopologia(concuerda(m, t));
        EXPECT_TRUE(despues.contrarias.empty());
        EXPECT_EQ(despues.sentidos, t.sentidos);
    }
}

// Quitar cualquiera de las caras de un cubo no cambia el sentido: la tapa que falta se supone.
TEST(Topologia, CajaSinTapa) {
    for (std::size_t quitada = 0; quitada < 6; ++quitada) {
        MallaVf m = cuboCerrado();
        m.caras.erase(m.caras.begin() + std::ptrdiff_t(quitada));
        EXPECT_EQ(analizaTopologia(m).deBorde, 4u);
        EXPECT_EQ(analizaTopologia(m).sentidos[0], Sentido::ANTIHORARIO);
        EXPECT_EQ(analizaTopologia(alReves(m)).sentidos[0], Sentido::HORARIO);
    }
}

TEST(Topologia, CadaComponenteTieneSuMayoria) {
    MallaVf m;
    anade(m, cuboCerrado(), glm::vec3(0));
    anade(m, alReves(cuboCerrado()), glm::vec3(3, 0, 0));
    std::reverse(m.caras[2].begin(), m.caras[2].end());
    std::reverse(m.caras[9].begin(), m.caras[9].end());
    const Topologia t = analizaTopologia(m);
    EXPECT_EQ(t.contrarias, (std::vector<std::size_t>{2, 9}));
    EXPECT_EQ(t.sentidos, (std::vector<Sentido>{Sentido::ANTIHORARIO, Sentido::HORARIO}));
}

// Dos cubos que comparten una arista: esa tiene cuatro caras y no dice nada de cómo giran unas respecto a
// otras.
TEST(Topologia, AristaDeCuatroCaras) {
    MallaVf m = cuboCerrado();
    anade(m, alReves(cuboCerrado()), {1, 0, 1});
    for (std::vector<unsigned> &cara : m.caras)
        for (unsigned &i : cara) // la arista (1,0,1)–(1,1,1) es la 2–6 del primero y la 0–4 del segundo
            i = i == 8 + 0 ? 2 : i == 8 + 4 ? 6 : i;
    const Topologia t = analizaTopologia(m);
    EXPECT_EQ(t.aristas.size(), 23u);
    EXPECT_EQ(t.ramificadas, 1u);
    EXPECT_EQ(t.deBorde, 0u);
    EXPECT_TRUE(t.contrarias.empty());
    EXPECT_EQ(t.sentidos, (std::vector<Sentido>{Sentido::ANTIHORARIO, Sentido::HORARIO}));
}

TEST(Topologia, BandaDeMobius) {
    MallaVf m;
    const unsigned n = 12;
    for (unsigned i = 0; i < n; ++i)
        for (double lado : {-0.4, 0.4}) {
            const double a = 2 * oraculo::PI * i / n, r = 1 + lado * std::cos(a / 2);
            m.vertices.push_back({r * std::cos(a), r * std::sin(a), lado * std::sin(a / 2)});
        }
    for (unsigned i = 0; i < n; ++i) {
        const unsigned p = 2 * i, q = i + 1 < n ? p + 2 : 1, r = i + 1 < n ? p + 3 : 0;
        m.caras.push_back({p, q, r, p + 1});
    }
    const Topologia t = analizaTopologia(m);
    EXPECT_EQ(t.orientables, std::vector<bool>{false});
    EXPECT_EQ(t.sentidos[0], Sentido::INDEFINIDO);
    EXPECT_EQ(t.deBorde, 2 * n);
}

// Una hoja plana e inclinada no tiene fuera, aunque el redondeo a float la alabee.
TEST(Topologia, UnaHojaPlanaNoTieneFuera) {
    MallaVf m;
    for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 5; ++j)
            m.vertices.push_back(glm::vec3(0.1f, 0.7f, 0.3f) + float(i) * glm::vec3(0.3f, 0.11f, 0.7f) +
                                 float(j) * glm::vec3(-0.13f, 0.9f, 0.37f));
    for (unsigned i = 0; i < 4; ++i)
        for (unsigned j = 0; j < 4; ++j)
            m.caras.push_back({5 * i + j, 5 * i + j + 1, 5 * i + j + 6, 5 * i + j + 5});
    EXPECT_EQ(analizaTopologia(m).sentidos[0], Sentido::INDEFINIDO);
    EXPECT_EQ(analizaTopologia({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}).sentidos[0],
              Sentido::INDEFINIDO);
}

TEST(Topologia, EncuadraSinDesbordarNiDividirPorCero) {
    for (const glm::vec3 &v : encuadra({{1e30f, 0, 0}, {-1e30f, 0, 0}, {0, 1e30f, 0}}))
        EXPECT_TRUE(std::isfinite(v.x) && glm::length(v) <= 1.0001f) << v.x << " " << v.y << " " << v.z;
    EXPECT_EQ(encuadra({{5, 5, 5}})[0], glm::vec3(0));
}
