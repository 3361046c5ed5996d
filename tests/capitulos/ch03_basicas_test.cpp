// basicas, escalado, tres_cubos, cono, elipsoide y orden (capítulo 3): sus matrices, cada píxel de la escena y lo que
// hay encima de ella. La geometría esperada sale del enunciado; de los programas solo se repiten los datos: dónde está
// la cámara, de qué color es cada cosa y qué elige cada uno donde falta la figura del libro.
#include "ch03_transformaciones/transformaciones.h"
#include "colores.h"
#include "guiones.h"
#include "panel.h"
#include <algorithm>
#include <gtest/gtest.h>
#include <iomanip>
#include <sstream>

using glm::dvec3;

namespace {

using oraculo::Mat4;
using oraculo::PI;
using oraculo::Vec3;

const double U = 0x1p-24; // error relativo de redondear a float
const Vec3 FONDO{0.95, 0.96, 0.98}, ANARANJADO{0.95, 0.55, 0.10}, AMARILLENTO{0.98, 0.78, 0.15},
    GRISACEO{0.55, 0.58, 0.62}, MORADUZCO{0.56, 0.24, 0.66};

/// De cómo se llega a una vista: lo que se hace y lo que con eso gira la cámara, 1.8 radianes por alto.
struct Mirada {
    std::string guion;
    double azimut = 0, elevacion = 0;
};
const Mirada MIRADAS[] = {{""}, {arrastra({100, 100}, {150, 80}) + "; tamano 150 200", -0.5, -0.2}};

/// Desde dónde mira un programa, sin mover el ratón; escalado y orden, de otra manera.
struct Encuadre {
    double azimut, distancia;
    Vec3 centro;
};
Panel ventana(const Vista &v, const Encuadre &e, const Mirada &mirada) {
    return {
        perspectiva(oraculo::orbita(e.azimut + mirada.azimut, 0.35 + mirada.elevacion, e.distancia, e.centro),
                    0.5, 1, 100),
        v.escena};
}

Linea transformada(const Mat4 &M, Linea linea) {
    for (Vec3 &p : linea)
        p = punto(M, p);
    return linea;
}

/// De radio 1, en el plano de u y v. Con 64 lados se separa de la exacta la milésima parte de su radio.
Linea circunferencia(const Vec3 &u, const Vec3 &v) {
    Linea linea;
    for (int i = 0; i <= 64; ++i)
        linea.push_back(std::cos(2 * PI * i / 64) * u + std::sin(2 * PI * i / 64) * v);
    return linea;
}
const Vec3 X{1, 0, 0}, Y{0, 1, 0}, Z{0, 0, 1};
const std::vector<Linea> TRES_CIRCUNFERENCIAS = {circunferencia(X, Y), circunferencia(X, Z),
                                                 circunferencia(-Z, Y)};

/// Los ejes, con su letra más allá de la punta.
void ejes(Dibujo &encima, const Vec3 &largos) {
    const Vec3 unidad[] = {X, Y, Z};
    const double separacion = 0.12 * std::min({largos.x, largos.y, largos.z});
    for (int i = 0; i < 3; ++i) {
        encima.traza("flecha", {{}, largos[i] * unidad[i]}, COLOR_EJE[i], 9);
        encima.rotula(std::string(1, char('X' + i)), encima.en((largos[i] + separacion) * unidad[i]),
                      COLOR_EJE[i]);
    }
}

// --- La F de basicas y escalado ---

/// Un factor cero no tiene inversa, y con uno tan pequeño se ve lo mismo.
const double APLASTADO = 1e-6;

/// El palo y los dos brazos, transformados.
oraculo::Escena efe(const Mat4 &M) {
    const Vec3 cajas[][2] = {{{0.35, 0.9, 0}, {0.4, 1.5, 0.5}}, // centro y lados
                             {{0.925, 1.475, 0}, {0.75, 0.35, 0.5}},
                             {{0.8, 0.875, 0}, {0.5, 0.35, 0.5}}};
    oraculo::Escena escena;
    for (const auto &[centro, lados] : cajas)
        escena.push_back(oraculo::caja(M * oraculo::traslada(centro) * oraculo::escala(lados)));
    return escena;
}

/// La F sin transformar: tenue a través de lo que haya delante y luego más oscura donde se ve.
void original(Dibujo &encima) {
    const double contorno[][2] = {{0.15, 0.15}, {0.55, 0.15}, {0.55, 0.70}, {1.05, 0.70}, {1.05, 1.05},
                                  {0.55, 1.05}, {0.55, 1.30}, {1.30, 1.30}, {1.30, 1.65}, {0.15, 1.65}};
    Linea aristas;
    for (int i = 0; i < 10; ++i) {
        const auto &[ax, ay] = contorno[i];
        const auto &[bx, by] = contorno[(i + 1) % 10];
        for (const double z : {-0.25, 0.25})
            aristas.insert(aristas.end(), {{ax, ay, z}, {bx, by, z}});
        aristas.insert(aristas.end(), {{ax, ay, -0.25}, {ax, ay, 0.25}});
    }
    encima.traza("segmentos", aristas, glm::mix(GRIS, FONDO_CLARO, 0.55f), 2.4, false);
    encima.traza("segmentos", aristas, GRIS, 4.2);
}

} // namespace

// --- basicas ---

// Cada ecuación con números que no se redondean, y los giros en float: cada seno y coseno llega con 1.5·U como mucho,
// así que c² + s² se separa de 1 menos de 2·1.5·√2·U, y el producto de float por float añade otro 2·U.
TEST(Basicas, EcuacionesYSentidoDeGiro) {
    const glm::vec4 p(0.5f, -1.25f, 2, 1);
    EXPECT_EQ(traslacion({1, 2, -3}) * p, glm::vec4(1.5f, 0.75f, -1, 1));
    EXPECT_EQ(escalado({2, -4, 0.5f}) * p, glm::vec4(1, 5, 1, 1));
    for (int eje = 0; eje < 3; ++eje)
        for (float phi = -3; phi <= 3; phi += 0.25f) {
            const glm::mat4 M = eje == 0 ? giroX(phi) : eje == 1 ? giroY(phi) : giroZ(phi);
            const glm::dmat3 R(M), RRt = R * glm::transpose(R) - glm::dmat3(1);
            for (int i = 0; i < 9; ++i)
                EXPECT_LE(std::fabs(RRt[i / 3][i % 3]), 7 * U) << eje << " " << phi;
            // visto desde la punta del eje, el giro de φ > 0 es antihorario: a × b apunta hacia quien mira
            dvec3 hacia(0), a(0);
            hacia[eje] = 1;
            a[(eje + 1) % 3] = 1;
            const dvec3 b = R * a;
            EXPECT_NEAR(glm::dot(glm::cross(a, b), hacia), std::sin(double(phi)), 2 * U);
            EXPECT_NEAR(glm::dot(a, b), std::cos(double(phi)), 2 * U);
            EXPECT_TRUE(R * hacia == hacia);
        }
}

namespace {

/// T y S a lo largo de X, o el giro en grados alrededor de ese eje.
Mat4 basica(char cual, double valor) {
    switch (cual) {
    case 'T': return oraculo::traslada({valor, 0, 0});
    case 'S': return oraculo::escala({valor, 1, 1});
    default: return oraculo::gira(cual == 'X' ? X : cual == 'Y' ? Y : Z, valor * PI / 180);
    }
}

/// A centésimas y en columnas de seis, sin −0.
std::string escrita(const Mat4 &M) {
    std::ostringstream s;
    for (const auto &fila : M.f) {
        s << (&fila == M.f ? "|" : "\n|");
        for (const double x : fila)
            s << std::setw(6) << std::round(100 * x) / 100 + 0.0;
        s << " |";
    }
    return s.str();
}

} // namespace

// La F transformada por la ecuación, en cada píxel; el camino de su esquina mientras el valor va del que no hace nada
// al suyo, en veinte tramos y con la flecha en los tres últimos; y la matriz, escrita con su nombre.
TEST(ProgramaBasicas, LaFEstaDondeDicenLasEcuaciones) {
    const struct {
        std::string guion;
        char cual;
        double valor;
        std::string nombre;
        Mirada mirada = {};
    } casos[] = {
        {"", 'T', 1.5, "T(1.5, 0, 0)"},
        {"tecla 1; tecla + ×4", 'T', 2, "T(2, 0, 0)"}, // el tope
        {"tecla 1; tecla - ×20", 'T', -2, "T(-2, 0, 0)", MIRADAS[1]},
        {"tecla 2", 'S', 1.5, "S(1.5, 1, 1)"},
        {"tecla 2; tecla - ×6", 'S', APLASTADO, "S(0, 1, 1)"},
        {"tecla 2; tecla - ×20", 'S', -2, "S(-2, 1, 1)"},
        {"tecla 3; tecla + ×2", 'X', 90, "Rx(90°)"},
        {"tecla 4; tecla - ×8", 'Y', -60, "Ry(-60°)"},
        {"tecla 4; tecla + ×2", 'Y', 90, "Ry(90°)", MIRADAS[1]},
        {"tecla 5", 'Z', 60, "Rz(60°)"},
        {"tecla 5; tecla + ×30", 'Z', 360, "Rz(360°)"},
    };
    for (const auto &caso : casos) {
        SCOPED_TRACE("«" + caso.guion + "»");
        const Vista v = vistaDe("basicas", caso.guion + "; " + caso.mirada.guion);
        const Panel panel = ventana(v, {0.95, 10.2, {0.2, 1.42, 0}}, caso.mirada);
        const Mat4 M = basica(caso.cual, caso.valor);
        std::vector<Cuerpo> cuerpos;
        for (const oraculo::Objeto &caja : efe(M))
            cuerpos.push_back({caja, ANARANJADO});
        compruebaEscena(v, panel, cuerpos, FONDO_CLARO);

        Linea camino;
        for (int i = 0; i <= 18; ++i) {
            const double neutro = caso.cual == 'S' ? 1 : 0, t = i < 18 ? i / 20.0 : 1;
            camino.push_back(punto(basica(caso.cual, neutro + t * (caso.valor - neutro)), {1.3, 1.65, 0.25}));
        }
        Dibujo encima = {panel};
        original(encima);
        encima.traza("polilinea", {camino.begin(), camino.end() - 1}, MORADO, 6);
        encima.traza("flecha", {camino[17], camino[18]}, MORADO, 6);
        ejes(encima, {1.85, 1.85, 1.85});
        encima.rotula(caso.nombre + " =", panel.lugar(0.03, 0.94), OSCURO, Lado::DERECHA);
        encima.rotula(escrita(M), panel.lugar(0.03, 0.78), OSCURO, Lado::DERECHA);
        encima.comprueba(v);
    }
}

// --- escalado ---

// Un factor negativo pone los vértices de una cara en el sentido contrario, y dos los dejan como estaban: con
// determinante negativo se ve el lado de dentro, morado, pero siempre con la luz de la normal que sale del objeto. De
// frente y por detrás, y con los paneles en tres columnas y en dos; en los últimos, estrechos, se ve más a lo alto.
TEST(Escalado, CarasYDeterminanteEnCadaVista) {
    const struct {
        dvec3 s;
        const char *nombre;
    } escalados[] = {{{2, 2, 2}, "S(2,2,2)"},         {{2, 0.5, 1}, "S(2,.5,1)"},
                     {{1, 1, APLASTADO}, "S(1,1,0)"}, {{-1, 1, 1}, "S(-1,1,1)"},
                     {{-1, -1, 1}, "S(-1,-1,1)"},     {{0.5, 0.5, 0.5}, "S(.5,.5,.5)"}};
    const int columnas[] = {3, 3, 2, 3};
    const auto vistas = vistasDe(
        "escalado",
        {"",
         "boton IZQUIERDO abajo 470 10; arrastra 170 10; arrastra -130 10; boton IZQUIERDO arriba -130 10",
         "tamano 300 480", "tamano 480 400"},
        480, 360);
    for (int v = 0; v < 4; ++v)
        for (int i = 0; i < 6; ++i) {
            const Imagen &escena = vistas[v].escena;
            const auto &[s, nombre] = escalados[i];
            SCOPED_TRACE(std::string(nombre) + " en la vista " + std::to_string(v));
            const int n = columnas[v];
            const Hueco h = hueco(i % n, n, i / n, 6 / n, escena.ancho, escena.alto);

            const dvec3 minimo(0.15, 0.15, -0.25), maximo(1.30, 1.65, 0.25),
                a = s * minimo, b = s * maximo, desde = glm::min(minimo, glm::min(a, b)),
                hasta = glm::max(maximo, glm::max(a, b)), centro = 0.5 * (desde + hasta) - dvec3(0, 0.28, 0);
            const double aspecto = double(h.ancho) / h.alto,
                         semialto = 0.26 * std::max(0.85 / aspecto, 1.0), // a distancia 1
                semilado = semialto * oraculo::altoUtil(h.ancho, h.alto) / h.alto;
            const Panel panel(perspectiva(oraculo::orbita(v == 0 ? 1 : 4, 0.3, 10, exacto(centro)),
                                          2 * std::atan(semilado), 1, 100),
                              h);
            const bool espejo = s.x * s.y * s.z < 0;
            comprueba(nombre,
                      oraculo::compara(
                          recorta(escena, h), efe(oraculo::escala(exacto(s))), panel.camara,
                          [&](const oraculo::Impacto &impacto) {
                              const Vec3 &color = impacto.frente == espejo ? MORADUZCO : AMARILLENTO;
                              return impacto ? luzFija(impacto.normal) * color : FONDO;
                          },
                          1),
                      EXACTA);
            Dibujo suyo = {panel};
            original(suyo);
            ejes(suyo, {1.7, 1.9, 0.8});
            suyo.rotula(nombre, panel.lugar(0.5, 0.06), OSCURO);
            suyo.comprueba(vistas[v]);
        }
}

// --- tres_cubos ---

TEST(TresCubos, ImagenContraTrazadoDeRayos) {
    const struct {
        double lado, centro; // cada centro sube medio lado del anterior más medio del suyo
        Vec3 color;
        const char *nombre;
    } cubos[] = {
        {1, 0, GRISACEO, "M = I"}, {0.5, 0.75, ANARANJADO, "M = A"}, {0.25, 1.125, AMARILLENTO, "M = A·A"}};
    for (const Mirada &mirada : MIRADAS) {
        const Vista v = vistaDe("tres_cubos", mirada.guion);
        const Panel panel = ventana(v, {0.55, 5.6, {0.15, 0.38, 0}}, mirada);
        Dibujo encima = {panel};
        ejes(encima, {1.5, 1.5, 1.5});
        encima.rotula("A = T(0, 0.75, 0) · S(0.5)", panel.lugar(0.5, 0.05), OSCURO);
        std::vector<Cuerpo> cuerpos;
        for (const auto &[lado, centro, color, nombre] : cubos) {
            cuerpos.push_back(
                {oraculo::caja(oraculo::traslada({0, centro, 0}) * oraculo::escala(lado)), color});
            // en la arista derecha de la cara de delante
            encima.rotula(nombre, panel({lado / 2, centro + lado / 4, -lado / 2}), OSCURO, Lado::DERECHA);
        }
        compruebaEscena(v, panel, cuerpos, FONDO_CLARO);
        encima.comprueba(v);
    }
}

// --- cono y elipsoide ---

namespace {

/// Segmentos con que una circunferencia de `radioPx` se separa `tolerPx` de su polígono.
int segmentos(double radioPx, double tolerPx) {
    return int(std::ceil(PI / std::acos(1 - tolerPx / radioPx)));
}
/// Las mallas se separan del sólido menos de medio píxel en una ventana de 1080 líneas, así que 1/12 en una de 180, más
/// la rejilla de los vértices; el desvío se busca en círculos cada vez √2 veces mayores.
const double DESVIO_DEL_SOLIDO = std::sqrt(2.0) * (1.0 / 12 + 1.0 / 256);

/// El sólido exacto, solo su silueta, y la misma malla, cada píxel.
void compruebaSolidos(const Imagen &escena, const oraculo::Escena &exactos, const std::vector<Cuerpo> &mallas,
                      const oraculo::Camara &camara) {
    comprueba("silueta", comparaSilueta(escena, FONDO, exactos, camara), {0, 0, DESVIO_DEL_SOLIDO});
    comprueba("malla", comparaConLuzFija(escena, mallas, camara, FONDO), EXACTA);
}

struct Solido {
    oraculo::Objeto (*exacto)(const Mat4 &);
    Malla malla;
    std::vector<Linea> lineas; // de donde sale y de adonde va
};
struct Paso {
    std::string nombre;
    Mat4 M;
    std::string producto; // con las anteriores
};

/// Un programa que aplica sus transformaciones una a una: el sólido en cada píxel, las líneas
/// de dónde sale y adónde va, salvo donde ya está, la recta y la leyenda, desde `abajo` y oscura hasta ese paso.
void compruebaPasos(const std::string &programa, const Encuadre &encuadre, const Vec3 &largos, double abajo,
                    const Solido &solido, const std::vector<Paso> &pasos, const Linea &recta = {}) {
    const int n = int(pasos.size());
    std::vector<Mat4> M(1);
    std::vector<std::string> productos = {"M = I"};
    for (const auto &paso : pasos) {
        M.push_back(paso.M * M.back());
        productos.push_back("M = " + paso.producto);
    }
    for (const Mirada &mirada : MIRADAS) {
        std::vector<std::string> guiones(M.size(), "tecla t");
        guiones[0] = mirada.guion;
        const std::vector<Vista> vistas = vistasDe(programa, guiones);
        const Panel panel = ventana(vistas[0], encuadre, mirada);
        for (int paso = 0; paso <= n; ++paso) {
            SCOPED_TRACE(programa + ", paso " + std::to_string(paso));
            compruebaSolidos(vistas[paso].escena, {solido.exacto(M[paso])},
                             {{oraculo::malla(M[paso], solido.malla), ANARANJADO}}, panel.camara);
            Dibujo encima = {panel};
            for (const int extremo : {0, n})
                for (const Linea &linea : solido.lineas)
                    if (extremo != paso)
                        encima.traza("polilinea", transformada(M[extremo], linea), GRIS, 4.2);
            if (!recta.empty()) {
                encima.traza("polilinea", recta, OSCURO, 6);
                encima.rotula("x=y=z", panel(recta[1]), OSCURO, Lado::ENCIMA);
            }
            ejes(encima, largos);
            encima.rotula(productos[paso], panel.lugar(0.02, abajo), OSCURO, Lado::DERECHA);
            for (int i = 0; i < n; ++i)
                encima.rotula(std::to_string(i + 1) + " " + pasos[i].nombre,
                              panel.lugar(0.02, abajo + 0.07 * (n - i)),
                              i < paso ? OSCURO : glm::mix(GRIS, OSCURO, 0.3f), Lado::DERECHA);
            encima.comprueba(vistas[paso]);
        }
    }
}

} // namespace

TEST(Cono, SiluetaDeCadaPaso) {
    const int n = segmentos(300, 0.5);
    std::vector<Linea> lineas = {circunferencia(X, Y)};
    for (int i = 0; i < 64; i += 8)
        lineas.push_back({lineas[0][i], Z});
    compruebaPasos("cono", {0.6, 9, {1.15, -0.1, 0}}, {3.7, 1.5, 1.8}, 0.06,
                   {oraculo::cono, porCaras(cono(n)), lineas},
                   {{"T(0, 0, −1)", oraculo::traslada({0, 0, -1}), "T"},
                    {"S(1, 1, 3)", oraculo::escala({1, 1, 3}), "S·T"},
                    {"Ry(−π/2)", oraculo::gira(Y, -PI / 2), "Ry·S·T"}});
}

TEST(Elipsoide, SiluetaDeCadaPaso) {
    const int n = segmentos(450, 0.25);
    const double inclinacion = std::asin(std::sqrt(1 / 3.0));
    compruebaPasos("elipsoide", {-0.5, 18, {0.5, 1.3, 0.8}}, {4, 2.6, 4}, 0.67,
                   {oraculo::esfera, esfera(n), TRES_CIRCUNFERENCIAS},
                   {{"S(0.5, 0.5, 3)", oraculo::escala({0.5, 0.5, 3}), "S"},
                    {"T(0, 0, 3)", oraculo::traslada({0, 0, 3}), "T·S"},
                    {"Rx(−asen 1/√3)", oraculo::gira(X, -inclinacion), "Rx·T·S"},
                    {"Ry(π/4)", oraculo::gira(Y, PI / 4), "Ry·Rx·T·S"}},
                   {{-1.2, -1.2, -1.2}, {4, 4, 4}});
}

// --- orden ---

// En cada panel, la esfera transformada y la inicial; en líneas, tras la primera transformación, que se nombra en
// ellas; y la regla, con sus números y la plomada del centro.
TEST(Orden, DiscosEnLaImagen) {
    const Mat4 T = oraculo::traslada({5, 0, 0}), S = oraculo::escala(5);
    const struct {
        Mat4 segunda, primera;
        const char *nombre, *nombrePrimera;
        double centro;
    } casos[] = {{T, S, "T·S", "S", 5}, {S, T, "S·T", "T", 25}};
    const int n = segmentos(200, 0.25);
    for (const Mirada &mirada : MIRADAS) {
        const Vista v = vistaDe("orden", mirada.guion);
        for (int fila = 0; fila < 2; ++fila) {
            const auto &caso = casos[fila];
            SCOPED_TRACE(caso.nombre);
            const Hueco h = hueco(0, 1, fila, 2, v.escena.ancho, v.escena.alto);
            // 42 unidades a lo ancho y al menos 3/8 de ellas a lo alto
            const double semialto = 21 * std::max(double(h.alto) / h.ancho, 3 / 8.0);
            const Panel panel(
                paralela(oraculo::orbita(mirada.azimut, 0.3 + mirada.elevacion, 21, {13.8, -1.4, 0}),
                         semialto * oraculo::altoUtil(h.ancho, h.alto) / h.alto, -100, 200),
                h);
            const Mat4 M = caso.segunda * caso.primera;
            compruebaSolidos(
                recorta(v.escena, h), {oraculo::esfera(M), oraculo::esfera(Mat4())},
                {{oraculo::malla(M, esfera(n)), ANARANJADO}, {oraculo::malla(Mat4(), esfera(n)), GRISACEO}},
                panel.camara);

            Dibujo encima = {panel};
            for (const Linea &linea : TRES_CIRCUNFERENCIAS)
                encima.traza("polilinea", transformada(caso.primera, linea), GRIS, 4.2);
            encima.traza("polilinea", {{0, -6.5, 0}, {30, -6.5, 0}}, OSCURO, 9);
            for (double x = 0; x <= 30; x += 5) {
                encima.traza("polilinea", {{x, -6.5, 0}, {x, -5.7, 0}}, OSCURO, 9);
                encima.rotula(std::to_string(int(x)), panel({x, -6.5, 0}), OSCURO, Lado::DEBAJO);
            }
            encima.traza("polilinea", {{caso.centro, 0, 0}, {caso.centro, -6.5, 0}}, MORADO, 12);
            ejes(encima, {32, 5.3, 9});
            encima.rotula(caso.nombre, panel({caso.centro, 0, 0}), BLANCO);
            encima.rotula(caso.nombrePrimera, panel(punto(caso.primera, {-0.7, 0.7, 0})), OSCURO,
                          Lado::ENCIMA);
            encima.comprueba(v);
        }
    }
}
