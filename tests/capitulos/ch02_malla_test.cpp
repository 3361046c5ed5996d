// Comprobaciones independientes de malla_vf y de su análisis (ch02_modelado/topologia.h).
#include "ch02_caja.h"
#include "ch02_modelado/encuadre_malla.h"
#include "ch02_modelado/topologia.h"
#include "guiones.h"
#include "tabla.h"

namespace {

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

} // namespace

// El de antes y, tras f, el de después.
TEST(MallaVf, InformeDelEjercicio) {
    const Ejecucion e = ejecuta("malla_vf", "tecla f; tecla F; tecla f");
    EXPECT_EQ(e.estado, 0);
    EXPECT_EQ(e.errores, "");
    const std::string al = informe(8, 10, 4, "5, 6", "antihorario"),
                      derecho = informe(8, 10, 4, "ninguna", "antihorario");
    EXPECT_EQ(e.salida, al + derecho + al);
}

// El número de un cuadrilátero está en su centro: el de los de sus vértices, que se apartan un poco de ellos.
TEST(MallaVf, NumeroEnElCentroDeLaCara) {
    const std::string dos =
        fichero("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nf 1 2 5 4\nf 2 3 6 5\n");
    const Encima encima = vistaDe("malla_vf", "", 480, 360, {dos}).encima;
    const auto en = [&](const std::string &cual) { return encima.rotulos(cual).at(0).punto(2); };
    for (const auto &[cara, vertices] : {std::pair("c1", "1254"), {"c2", "2365"}}) {
        glm::dvec2 centro(0);
        for (const char *v = vertices; *v; ++v)
            centro += en(std::string(1, *v)) / 4.0;
        EXPECT_LT(glm::distance(en(cara), centro), 20) << cara;
    }
}

// Cada cara, con la cámara y la luz calculadas en doble precisión: azul si desde el ojo sus vértices giran en sentido
// antihorario y amarilla si no. Los triángulos son los del enunciado; con f, la 5 y la 6 al revés.
TEST(MallaVf, ElColorDiceElSentido) {
    const struct {
        std::string guion;
        const std::vector<T3> &caras;
        double gira, sube;
    } casos[] = {{"", CARAS, 0, 0},
                 {"tecla f", TRIANGULOS, 0, 0},
                 {"tecla x; tamano 120 200", TRIANGULOS, 0, 0},
                 {arrastra({20, 20}, {70, 10}) + "; tecla f", CARAS, -1, -0.2}};
    paraCada("malla_vf", casos, ANCHO, ALTO, [](const auto &c, const Vista &vista) {
        compruebaCaja(c.guion, vista.escena, c.caras, camaraCaja(0.55, 0.62, c.gira, c.sube),
                      [](const oraculo::Impacto &i) {
                          return luzFija(i.frente ? i.normalCara : -i.normalCara) *
                                 exacto(i.frente ? AZUL : AMARILLO);
                      });
    });
}

TEST(MallaVf, AristaDeTresCaras) {
    const std::string ruta =
        fichero("v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 1\nv -1 0 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n");
    EXPECT_NE(ejecuta("malla_vf", "", 60, 45, {ruta})
                  .salida.find("Componentes: 3\nAristas de borde: 6\nAristas de más de dos caras: 1\n"),
              std::string::npos);
    const Encima encima = vistaDe("malla_vf", "", ANCHO, ALTO, {ruta}).encima;
    EXPECT_EQ(encima.trazos(MORADO).at(0).puntos.size(), 2u);
    EXPECT_EQ(encima.trazos(ROJO).at(0).puntos.size(), 12u);
    EXPECT_TRUE(encima.trazos(OSCURO).empty());
}

// Un sólido cerrado, también lejos del origen. Con cualquier subconjunto de caras invertido, las contrarias son la
// minoría (en un empate, las que no concuerdan con la primera), y arreglarla las deja todas concordes. Los 64 casos.
TEST(Topologia, LaMayoriaManda) {
    for (unsigned invertidas = 0; invertidas < 64; ++invertidas)
        for (const glm::vec3 &donde : {glm::vec3(0), glm::vec3(-1e6f, 2e6f, 3e6f)}) {
            MallaVf m;
            anade(m, cuboCerrado(), donde);
            std::vector<std::size_t> si, no;
            for (std::size_t c = 0; c < 6; ++c) {
                if (invertidas >> c & 1)
                    std::reverse(m.caras[c].begin(), m.caras[c].end());
                (invertidas >> c & 1 ? si : no).push_back(c);
            }
            const bool ganaNo = no.size() > si.size() || (no.size() == si.size() && !(invertidas & 1));
            const Topologia t = analizaTopologia(m);
            EXPECT_TRUE(t.aristas.size() == 12 && t.deBorde == 0);
            EXPECT_EQ(t.contrarias, ganaNo ? si : no) << invertidas;
            EXPECT_EQ(t.sentidos, std::vector{ganaNo ? Sentido::ANTIHORARIO : Sentido::HORARIO})
                << invertidas;
            const Topologia despues = analizaTopologia(concuerda(m, t));
            EXPECT_TRUE(despues.contrarias.empty());
            EXPECT_EQ(despues.sentidos, t.sentidos);
        }
}

// Dos cubos que comparten una arista: esa tiene cuatro caras y no dice nada de cómo giran unas respecto a otras; son
// dos componentes, y cada una tiene su mayoría.
TEST(Topologia, AristaDeCuatroCaras) {
    MallaVf m = cuboCerrado();
    anade(m, cuboCerrado(), {1, 0, 1});
    for (std::size_t c = 6; c < 12; ++c) // el segundo, al revés; y de cada uno, una cara
        std::reverse(m.caras[c].begin(), m.caras[c].end());
    for (const std::size_t c : {2u, 9u})
        std::reverse(m.caras[c].begin(), m.caras[c].end());
    for (std::vector<unsigned> &cara : m.caras)
        for (unsigned &i : cara) // la arista (1,0,1)–(1,1,1) es la 2–6 del primero y la 0–4 del segundo
            i = i == 8 + 0 ? 2 : i == 8 + 4 ? 6 : i;
    const Topologia t = analizaTopologia(m);
    EXPECT_TRUE(t.aristas.size() == 23 && t.ramificadas == 1 && t.deBorde == 0);
    EXPECT_EQ(t.contrarias, (std::vector<std::size_t>{2, 9}));
    EXPECT_EQ(t.sentidos, (std::vector<Sentido>{Sentido::ANTIHORARIO, Sentido::HORARIO}));
}
