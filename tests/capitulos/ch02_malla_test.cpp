// Comprobaciones independientes de malla_vf y de su análisis (ch02_modelado/topologia.h).
#include "ch02_caja.h"
#include "ch02_modelado/encuadre_malla.h"
#include "ch02_modelado/topologia.h"
#include "ejecuta.h"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

namespace {

std::string valor(const std::string &salida, const std::string &clave) {
    const std::size_t i = ("\n" + salida).find("\n" + clave + ": ");
    if (i == std::string::npos)
        return "(no está)";
    const std::size_t desde = i + clave.size() + 2;
    return salida.substr(desde, salida.find('\n', desde) - desde);
}

struct FicheroVf {
    std::string ruta = (carpetaTemporal() / "vfXXXXXX").string();
    explicit FicheroVf(const std::string &texto) {
        std::fclose(fdopen(mkstemp(ruta.data()), "w"));
        std::ofstream(ruta) << texto;
    }
    ~FicheroVf() {
        std::filesystem::remove(ruta);
    }
};

MallaVf cuboCerrado() {
    MallaVf m;
    for (const auto &p : CAJA)
        m.vertices.push_back({p[0], p[1], p[2]});
    m.caras = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {3, 7, 6, 2}, {1, 2, 6, 5}, {0, 4, 7, 3}};
    return m;
}

void anade(MallaVf &m, const MallaVf &otra, const glm::vec3 &donde) {
    const auto base = static_cast<unsigned>(m.vertices.size());
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
    for (int c = 0; c < 10; ++c) {
        const auto &cara = CARAS[static_cast<std::size_t>(c)];
        const double *p = CAJA[cara[0] - 1], *q = CAJA[cara[1] - 1], *r = CAJA[cara[2] - 1];
        double a[3], b[3], fuera = 0;
        for (int k = 0; k < 3; ++k) {
            a[k] = q[k] - p[k];
            b[k] = r[k] - p[k];
        }
        for (int k = 0; k < 3; ++k) {
            const int i = (k + 1) % 3, j = (k + 2) % 3;
            fuera += (a[i] * b[j] - a[j] * b[i]) * ((p[k] + q[k] + r[k]) / 3 - 0.5);
        }
        ASSERT_NE(fuera, 0);
        EXPECT_EQ(fuera < 0, c + 1 == 5 || c + 1 == 6) << "cara " << c + 1;
    }
}

TEST(MallaVf, InformeDelEjercicio) {
    const Ejecucion e = ejecuta("ch02_modelado/malla_vf");
    ASSERT_EQ(e.estado, 0) << e.errores;
    EXPECT_EQ(e.errores, "");
    EXPECT_EQ(valor(e.salida, "Vértices"), "8");
    EXPECT_EQ(valor(e.salida, "Caras"), "10");
    EXPECT_EQ(valor(e.salida, "Componentes"), "1");
    EXPECT_EQ(valor(e.salida, "Aristas de borde"), "4");
    EXPECT_EQ(valor(e.salida, "Aristas de más de dos caras"), "0");
    EXPECT_EQ(valor(e.salida, "Orientable"), "sí");
    EXPECT_EQ(valor(e.salida, "Caras con orientación contraria"), "5, 6");
    EXPECT_EQ(valor(e.salida, "Sentido visto desde fuera"), "antihorario");
}

// El informe de después de f es el último.
TEST(MallaVf, ArregladaNoTieneContrarias) {
    const Ejecucion e = ejecuta("ch02_modelado/malla_vf", "tecla f");
    ASSERT_EQ(e.estado, 0) << e.errores;
    const std::string ultimo = e.salida.substr(e.salida.rfind("Vértices: "));
    EXPECT_EQ(valor(ultimo, "Aristas de borde"), "4");
    EXPECT_EQ(valor(ultimo, "Caras con orientación contraria"), "ninguna");
    EXPECT_EQ(valor(ultimo, "Sentido visto desde fuera"), "antihorario");
}

// Cada cara que se ve, con la cámara y la luz calculadas en doble precisión: azul si desde el ojo sus vértices giran en sentido
// antihorario y amarilla si no. Los triángulos son los del enunciado; con f, la 5 y la 6 al revés.
TEST(MallaVf, ElColorDiceElSentido) {
    for (const bool arreglada : {false, true}) {
        auto caras = CARAS;
        if (arreglada)
            for (std::size_t c : {4u, 5u})
                std::swap(caras[c][1], caras[c][2]);
        const VistaCaja vista(0.55, 0.62);
        const oraculo::Escena escena = {mallaCaja({caras.begin(), caras.end()})};
        const Imagen imagen =
            ejecuta("ch02_modelado/malla_vf", arreglada ? "tecla f" : "", ANCHO, ALTO).imagen;
        int vistas = 0;
        for (int c = 0; c < 10; ++c) {
            const Mayoria m = mayoria(imagen, escena, vista.camara, c);
            if (m.pixeles < 300)
                continue;
            ++vistas;
            const oraculo::Vec3 n = m.impacto.frente ? m.impacto.normalCara : -m.impacto.normalCara;
            const double luz = 0.58 + 0.42 * oraculo::escalar(n, {0.20, 0.78, 0.593});
            const glm::vec3 color = m.impacto.frente ? AZUL : AMARILLO;
            EXPECT_LE(m.diferencia(glm::dvec3(color) * luz), 1)
                << "cara " << c + 1 << (arreglada ? " arreglada" : "");
            EXPECT_GT(m.parte, 0.6) << "cara " << c + 1;
        }
        EXPECT_EQ(vistas, 8);
    }
    EXPECT_EQ(ejecuta("ch02_modelado/malla_vf").imagen.rgb,
              ejecuta("ch02_modelado/malla_vf", "tecla f; tecla f").imagen.rgb);
}

// La arista de borde 5–6 es gruesa y roja; la diagonal 3–6 de la pared, fina y oscura.
TEST(MallaVf, Aristas) {
    const Imagen imagen = ejecuta("ch02_modelado/malla_vf", "", ANCHO, ALTO).imagen;
    const VistaCaja vista(0.55, 0.62);
    const auto grosor = [&](int a, int b,
                            const glm::vec3 &color) { // en la vertical de un punto a un tercio de la arista
        const glm::dvec2 p = vista.enPixel(2 / 3.0 * vista.vertice(a) + 1 / 3.0 * vista.vertice(b));
        int n = 0;
        for (int d = -12; d <= 12; ++d)
            n += distanciaColor(imagen, static_cast<int>(p.x), static_cast<int>(p.y) + d,
                                glm::dvec3(color)) <= 1;
        return n;
    };
    for (const auto &[a, b] : {std::pair<int, int>{5, 6}, {6, 7}, {7, 8}, {8, 5}})
        EXPECT_TRUE(grosor(a, b, ROJO) >= 4 && grosor(a, b, ROJO) <= 9)
            << a << "-" << b << ": " << grosor(a, b, ROJO);
    EXPECT_TRUE(grosor(3, 6, OSCURO) >= 1 && grosor(3, 6, OSCURO) <= 3) << grosor(3, 6, OSCURO);
}

// El número de cada vértice que se ve (todos menos el 1, el del fondo), junto a él y por fuera; el de cada cara que se ve, en
// su centro.
TEST(MallaVf, Numeros) {
    const Imagen imagen = ejecuta("ch02_modelado/malla_vf", "", 960, 720).imagen;
    const VistaCaja vista(0.55, 0.62, 960, 720);
    for (int i = 2; i <= 8; ++i) {
        const glm::dvec2 v = vista.enPixel(vista.vertice(i));
        const glm::dvec2 r = rotuloJunto(imagen, enLetras(i), OSCURO, 4, v);
        EXPECT_LT(glm::distance(r, v), 40) << i;
        EXPECT_GT(glm::distance(r, glm::dvec2(480, 360)), glm::distance(v, glm::dvec2(480, 360))) << i;
    }
    EXPECT_TRUE(buscaRotulo(imagen, U"1", OSCURO, 4).empty());
    for (int c : {5, 6, 7, 8, 10}) {
        oraculo::Vec3 centro;
        for (int i : CARAS[static_cast<std::size_t>(c - 1)])
            centro = centro + 1 / 3.0 * vista.vertice(i);
        const glm::dvec2 p = vista.enPixel(centro);
        EXPECT_LT(glm::distance(rotuloJunto(imagen, enLetras(c), BLANCO, 4, p), p), 3) << c;
    }
    for (int c : {2, 3, 4, 9})
        EXPECT_TRUE(buscaRotulo(imagen, enLetras(c), BLANCO, 4).empty()) << c;
    EXPECT_EQ(buscaRotulo(imagen, U"anverso", AZUL, 4).size(), 1u);
    EXPECT_EQ(buscaRotulo(imagen, U"reverso", AMARILLO, 4).size(), 1u);
    EXPECT_EQ(buscaRotulo(imagen, U"borde", ROJO, 4).size(), 1u);
}

// Un prisma de base pentagonal con caras de 4 y 5 vértices, enorme y lejos del origen: llena la ventana sin
// salirse.
TEST(MallaVf, CualquierMallaLlenaLaVentana) {
    std::string texto = "# prisma\n";
    for (int k = 0; k < 10; ++k) {
        const double a = 2 * 3.14159265358979 * (k % 5) / 5;
        char linea[100];
        std::snprintf(linea, sizeof linea, "v %.1f %d %.1f\n", 100000 + 3000 * std::cos(a),
                      k < 5 ? -70000 : -66000, 3000 * std::sin(a));
        texto += linea;
    }
    texto += "f 1 2 3 4 5\nf 10 9 8 7 6\n";
    for (int k = 0; k < 5; ++k) {
        const int s = (k + 1) % 5;
        texto += "f " + std::to_string(k + 1) + " " + std::to_string(k + 6) + " " + std::to_string(s + 6) +
                 " " + std::to_string(s + 1) + "\n";
    }
    const FicheroVf f(texto);
    const Ejecucion e = ejecuta("ch02_modelado/malla_vf", "", 240, 180, {f.ruta});
    ASSERT_EQ(e.estado, 0) << e.errores;
    EXPECT_EQ(valor(e.salida, "Aristas de borde"), "0");
    EXPECT_EQ(valor(e.salida, "Caras con orientación contraria"), "ninguna");
    EXPECT_EQ(valor(e.salida, "Sentido visto desde fuera"), "antihorario");
    int arriba = 0, abajo = 180, izquierda = 240, derecha = 0;
    const Pixel fondo = pixel(e.imagen, 0, 0);
    for (int y = 0; y < 180; ++y)
        for (int x = 0; x < 240; ++x) {
            const Pixel p = pixel(e.imagen, x, y);
            if (p.r == fondo.r && p.g == fondo.g && p.b == fondo.b)
                continue;
            arriba = std::max(arriba, y);
            abajo = std::min(abajo, y);
            izquierda = std::min(izquierda, x);
            derecha = std::max(derecha, x);
        }
    EXPECT_GT(arriba - abajo, 180 * 8 / 10);
    EXPECT_TRUE(abajo > 0 && arriba < 179 && izquierda > 0 && derecha < 239);
}

// Una malla de un solo punto, o que se ve de canto, no estropea la cámara.
TEST(MallaVf, MallasSinTalla) {
    for (const char *texto :
         {"v 5 5 5\nv 5 5 5\nv 5 5 5\nf 1 2 3\n", "v 1 1 1\nv 2 2 2\nv 3 3 3\nf 1 2 3\n"}) {
        const FicheroVf f(texto);
        const Ejecucion e = ejecuta("ch02_modelado/malla_vf", "tecla f", 60, 45, {f.ruta});
        EXPECT_EQ(e.estado, 0) << e.errores;
        EXPECT_EQ(valor(e.salida, "Sentido visto desde fuera"), "indefinido");
    }
}

TEST(MallaVf, ErroresDelUsuario) {
    EXPECT_EQ(ejecuta("ch02_modelado/malla_vf", "", 60, 45, {"a.vf", "b.vf"}).estado, 2);
    const Ejecucion falta = ejecuta("ch02_modelado/malla_vf", "", 60, 45, {"no_existe.vf"});
    EXPECT_EQ(falta.estado, 1);
    EXPECT_NE(falta.errores.find("no_existe.vf"), std::string::npos);
    const FicheroVf f("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n");
    const Ejecucion mala = ejecuta("ch02_modelado/malla_vf", "", 60, 45, {f.ruta});
    EXPECT_EQ(mala.estado, 1);
    EXPECT_NE(mala.errores.find(":4: "), std::string::npos) << mala.errores;
}

TEST(Topologia, SolidoCerradoEnLosDosSentidos) {
    for (const glm::vec3 &donde : {glm::vec3(0), glm::vec3(-1e6f, 2e6f, 3e6f)}) {
        MallaVf m, inverso;
        anade(m, cuboCerrado(), donde);
        inverso = alReves(m);
        const Topologia t = analizaTopologia(m), i = analizaTopologia(inverso);
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
        m.caras.erase(m.caras.begin() + static_cast<std::ptrdiff_t>(quitada));
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
    MallaVf m = cuboCerrado(), otro = alReves(cuboCerrado());
    const auto base = static_cast<unsigned>(m.vertices.size());
    for (const glm::vec3 &v : otro.vertices)
        m.vertices.push_back(v + glm::vec3(1, 0, 1));
    for (std::vector<unsigned> cara : otro.caras) {
        for (unsigned &i : cara) // la arista (1,0,1)–(1,1,1) es la 2–6 del primero y la 0–4 del segundo
            i = i == 0 ? 2 : i == 4 ? 6 : i + base;
        m.caras.push_back(cara);
    }
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
            const double a = 2 * 3.14159265358979 * i / n, r = 1 + lado * std::cos(a / 2);
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
            m.vertices.push_back(glm::vec3(0.1f, 0.7f, 0.3f) +
                                 static_cast<float>(i) * glm::vec3(0.3f, 0.11f, 0.7f) +
                                 static_cast<float>(j) * glm::vec3(-0.13f, 0.9f, 0.37f));
    for (unsigned i = 0; i < 4; ++i)
        for (unsigned j = 0; j < 4; ++j)
            m.caras.push_back({5 * i + j, 5 * i + j + 1, 5 * i + j + 6, 5 * i + j + 5});
    EXPECT_EQ(analizaTopologia(m).sentidos[0], Sentido::INDEFINIDO);
    MallaVf una;
    una.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    una.caras = {{0, 1, 2}};
    EXPECT_EQ(analizaTopologia(una).sentidos[0], Sentido::INDEFINIDO);
}

TEST(Topologia, EncuadraSinDesbordarNiDividirPorCero) {
    for (const glm::vec3 &v : encuadra({{1e30f, 0, 0}, {-1e30f, 0, 0}, {0, 1e30f, 0}}))
        EXPECT_TRUE(std::isfinite(v.x) && glm::length(v) <= 1.0001f) << v.x << " " << v.y << " " << v.z;
    EXPECT_EQ(encuadra({{5, 5, 5}})[0], glm::vec3(0));
}
