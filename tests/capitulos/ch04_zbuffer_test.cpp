// El programa zbuffer, en la GPU y en la CPU, contra trazado de rayos, y el algoritmo Z-Buffer en la CPU (zbuffer.h).
#include "azar.h"
#include "ch04_oraculo.h"
#include "ch04_vista3d/zbuffer.h"
#include "guiones.h"
#include "imagenes.h"

namespace {

using namespace oraculo;

/// La escena del programa, escrita otra vez; lo redondo, con las caras que tiene.
std::vector<Cuerpo> escena() {
    const Mat4 anillo = gira(X, 0.45) * DE_PIE;
    return {
        {caja(traslada({0, -0.1, 0}) * escala({9.6, 0.2, 7})), exacto(SUELO)},
        {caja(traslada({-1, 1.3, 1}) * gira({0, 1, 0}, 0.35) * escala(2.6)), exacto(ROJO)},
        {enElMundo(traslada({-0.7, 2.6, 1.2}) * escala(1.1), esfera(48)), exacto(AMARILLO)},
        {enElMundo(traslada({2.6, 2.1, -0.6}) * DE_PIE * escala({0.5, 0.5, 4.2}), cilindro(48)),
         exacto(AZUL)},
        {enElMundo(traslada({2.6, 2.4, -0.6}) * anillo, toro(1.4f, 0.35f, 48, 24)), exacto(NARANJA)},
        {enElMundo(traslada({-2, 0, -1.9}) * DE_PIE * escala({1.5, 1.5, 4.8}), porCaras(cono(48))),
         exacto(VERDE)},
    };
}

Camara camaraDe(double azimut = 0.55, double elevacion = 0.45, double distancia = 18.6) {
    return perspectiva(orbita(azimut, elevacion, distancia, {0, 1.1, 0}), 0.5, 1, 100);
}

// La CPU interpola el color con los vértices ya en la rejilla, a √2/512 píxeles como mucho de su sitio; en el tubo del
// toro cambia todo, 0.42·255 niveles, en 3 píxeles: 0.1 más.
const Cotas EN_CPU = {0.6, 500, 0.012};

/// Píxeles en que dos imágenes difieren en más de un nivel.
int distintos(const Imagen &a, const Imagen &b) {
    return cuenta(a, [&](int x, int y, const Pixel &p) { return distancia(p, ::color(pixel(b, x, y))) > 1; });
}

/// Sin test gana lo último que se pinta, el cono, que es lo más lejano: su silueta entera es verde, y nada más.
void compruebaPanel(const Vista &vista, const Panel &panel, bool enCpu, bool conTest) {
    const auto esVerde = [](const Pixel &p) { return p.g > 2 * p.r && p.g > 2 * p.b; };
    if (conTest)
        compruebaEscena(vista, panel, escena(), CIELO, enCpu ? EN_CPU : EXACTA);
    else
        compruebaSilueta(vista, panel, esVerde, escena().back().objeto);
}

const glm::vec3 NEGRO(0);

/// Triángulo en el plano z = 0 de una ventana ancho × alto, dado por sus esquinas en píxeles.
TrianguloZ trianguloEn(const std::array<glm::dvec2, 3> &p, int ancho, int alto) {
    TrianguloZ t;
    for (std::size_t i = 0; i < 3; ++i)
        t[i] = {{2 * p[i].x / ancho - 1, 2 * p[i].y / alto - 1, 0, 1}, BLANCO};
    return t;
}

} // namespace

// También tras girar y acercarse; y la GPU contra la CPU: en los bordes, que miden unos 3000 píxeles, cada una puede
// fallar en uno de cada 500, y las dos juntas en 12. Después los cuatro: por columnas, sin test y con él; por filas, la
// GPU y la CPU.
TEST(ZBuffer, GpuYCpuContraTrazadoDeRayos) {
    const std::pair<std::string, Camara> casos[] = {
        {"", camaraDe()},
        {arrastra({10, 50}, {160, 20}) + "; rueda +1 9 9 ×18", camaraDe(-0.95, 0.15, 0.4 * 18.6)}};
    for (const auto &[guion, camara] : casos) {
        SCOPED_TRACE(guion);
        const std::vector<Vista> v = vistasDe("zbuffer", {guion, "tecla c", "tecla z", "tecla c"});
        for (std::size_t k = 0; k < 4; ++k)
            compruebaPanel(v[k], {camara, v[k].escena}, k == 1 || k == 2, k < 2);
        EXPECT_LE(distintos(v[0].escena, v[1].escena), 12);
        EXPECT_LE(distintos(v[2].escena, v[3].escena), 12);
    }
    const std::vector<Vista> sinBorrar = vistasDe("zbuffer", {"tecla b", "tecla c"}); // la profundidad
    EXPECT_LE(distintos(sinBorrar[0].escena, sinBorrar[1].escena), 12);
    const Vista juntos = vistaDe("zbuffer", "tecla v", 480, 360);
    for (const int k : {0, 1, 2, 3})
        compruebaPanel(juntos, {camaraDe(), juntos.escena, k, 4, 2}, k >= 2, k % 2 == 1);
}

// Una rejilla de triángulos con los vértices en centros y esquinas de píxel, para que muchos centros caigan
// justo en un lado: cada píxel lo pinta exactamente un triángulo.
TEST(Rasteriza, NiHuecosNiDobles) {
    Azar azar(2);
    const int ancho = 24, alto = 18, n = 6;
    for (int vez = 0; vez < 20; ++vez) {
        glm::dvec2 v[n + 1][n + 1];
        for (int j = 0; j <= n; ++j)
            for (int i = 0; i <= n; ++i) {
                const auto mueve = [&](int k) { return k % n ? 0.5 * azar.entero(-2, 2) : 0.0; };
                v[j][i] = {4 * i + mueve(i), 3 * j + mueve(j) / 2};
            }
        std::vector<int> pintados(ancho * alto);
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i)
                for (const glm::dvec2 &tercero : {v[j][i + 1], v[j + 1][i]}) {
                    BufferZ b = creaBufferZ(ancho, alto, NEGRO);
                    pintaTriangulo(b, trianguloEn({v[j][i], v[j + 1][i + 1], tercero}, ancho, alto));
                    for (std::size_t p = 0; p < pintados.size(); ++p)
                        pintados[p] += b.color.rgb[3 * p] > 0;
                }
        EXPECT_EQ(pintados, std::vector<int>(ancho * alto, 1)) << vez;
    }
}

// A la misma profundidad queda lo primero: GL_LESS.
TEST(ZBufferCpu, AIgualProfundidadQuedaElPrimero) {
    BufferZ b = creaBufferZ(4, 4, NEGRO);
    for (const float gris : {1.0f, 0.5f}) {
        TrianguloZ t = trianguloEn({glm::dvec2(0, 0), {8, 0}, {0, 8}}, 4, 4);
        for (VerticeZ &v : t)
            v.color = glm::vec3(gris);
        pintaTriangulo(b, t);
    }
    EXPECT_EQ(pixel(b.color, 1, 1).r, 255);
}

// Un suelo que empieza detrás de la cámara y acaba más allá de lejos: color y profundidad de cada píxel contra
// el corte exacto de su rayo, en doble. Cámara en el origen a altura 1, cerca 0.5, lejos 21, ángulo de 90°.
TEST(ZBufferCpu, RecortadoColorYProfundidadContraElRayo) {
    const int lado = 60;
    const double cerca = 0.5, lejos = 21;
    const auto vertice = [&](double x, double z) { // el suelo es y = −1; el color, u de 0 a 1 a lo largo
        const double zr = -(lejos + cerca) / (lejos - cerca) * z - 2 * lejos * cerca / (lejos - cerca);
        return VerticeZ{{x, -1, zr, -z}, {(x + 40) / 80, (30 - z) / 60, 0.5}};
    };
    BufferZ b = creaBufferZ(lado, lado, NEGRO, false); // ni sin test hay nada más allá de lejos
    pintaTriangulo(b, {vertice(-40, 30), vertice(40, 30), vertice(40, -90)});
    pintaTriangulo(b, {vertice(-40, 30), vertice(40, -90), vertice(-40, -90)});
    int pintados = 0;
    for (int y = 0; y < lado; ++y)
        for (int x = 0; x < lado; ++x) {
            const double px = (x + 0.5) / (lado / 2.0) - 1, py = (y + 0.5) / (lado / 2.0) - 1;
            const double d = py < 0 ? -1 / py : 1e9; // distancia a la que el rayo (px, py, −1) toca el suelo
            const Pixel p = pixel(b.color, x, y);
            const float z = b.profundidad[std::size_t(y * lado + x)];
            if (d > lejos || std::fabs(px * d) > 40) {
                ASSERT_EQ(p.b, 0) << x << "," << y;
                ASSERT_EQ(z, 1);
                continue;
            }
            ++pintados;
            ASSERT_NEAR(p.r, 255 * (px * d + 40) / 80, 1) << x << "," << y;
            ASSERT_NEAR(p.g, 255 * (d + 30) / 60, 1) << x << "," << y;
            ASSERT_EQ(p.b, 128);
            // 1/256 de píxel en un vértice son 0.512·(1/30)/256 = 6.7e-5 de profundidad
            ASSERT_NEAR(z, lejos / (lejos - cerca) * (1 - cerca / d), 7e-5);
        }
    EXPECT_GT(pintados, lado * lado * 4 / 10);
}
