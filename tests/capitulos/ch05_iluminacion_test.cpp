// Los programas del capítulo 5 contra trazado de rayos en doble precisión; las escenas, los materiales y las luces
// están escritos otra vez. Cada escena se traza con la misma malla que dibuja el programa: no debe haber más error que
// el redondeo.
#include "colores.h"
#include "contra_oraculo.h"
#include "guiones.h"
#include "panel.h"
#include "tabla.h"

using namespace oraculo;

namespace {

const Vec3 FONDO{0.16, 0.17, 0.20};

enum Modelo { PLANO, GOURAUD, PHONG };
const char *const MODELOS[] = {"Plano", "Gouraud", "Phong"};

/// De brillo gris.
Material pintura(const Vec3 &ka, const Vec3 &kd, double ks, double alfa) {
    return {ka, kd, {ks, ks, ks}, alfa};
}

/// El panel k de n, uno al lado de otro o, en una ventana alta, uno encima de otro.
Panel enTira(int k, int n, const Imagen &ventana) {
    return {{}, ventana, k, n, ventana.ancho > ventana.alto ? n : 1};
}

Luz atenuada(Luz luz, double a, double b, double c) {
    luz.a = a;
    luz.b = b;
    luz.c = c;
    return luz;
}

/// Un sólido, con las caras con que lo dibuja el programa, y de qué está hecho.
struct Solido {
    Objeto objeto;
    Material material;
};
Objeto bola(const Mat4 &M, int n) {
    return malla(M, esfera(n));
}
Objeto bloque(const Mat4 &M) {
    return malla(M, cubo());
}

/// Una escena con luz ambiente (1, 1, 1): la ecuación 5.7 en cada píxel, con la normal interpolada y normalizada, o los
/// otros modelos de sombreado, sobre la malla: Gouraud con los tres colores interpolados, y plano con el color del
/// primer vértice de cada triángulo (facetas lo pone el último, el que manda) y la normal del triángulo.
struct Iluminada {
    std::vector<Solido> solidos;
    std::vector<Luz> luces;
    Camara camara;
    Vec3 fondo = FONDO;
    int modelo = PHONG;

    Vec3 color(int objeto, const Vec3 &p, const Vec3 &normal) const {
        return phong(solidos[objeto].material, UNO, luces, p, normal, unitario(camara.ojo - p));
    }
    /// Dentro y fuera del cono de un foco son zonas distintas, y cada polígono plano.
    Tono tono(const Escena &escena, const Impacto &i) const {
        if (!i)
            return fondo;
        int zona = 0;
        for (const Luz &luz : luces) {
            const Vec3 v = i.punto - luz.posicion;
            const double angulo = std::atan2(longitud(vectorial(v, luz.S)), escalar(v, luz.S));
            zona = 2 * zona + (luz.foco && angulo <= luz.delta);
        }
        if (modelo == PHONG)
            return {color(i.objeto, i.punto, i.normal), zona};
        const Objeto &o = escena[i.objeto];
        if (modelo == GOURAUD)
            return interpola(o, i, [&](const VerticeRef &v) {
                return color(i.objeto, punto(o.M, v.posicion), transformaNormal(o.inv, v.normal));
            });
        const VerticeRef &primero = o.triangulos->vertices[o.triangulos->indices[i.corte.triangulo][0]];
        return {color(i.objeto, punto(o.M, primero.posicion), i.normalCara), i.corte.triangulo / 2};
    }
    void compara(const Imagen &gpu) const {
        Escena escena;
        for (const Solido &s : solidos)
            escena.push_back(s.objeto);
        const auto sombrea = [&](const Impacto &i) { return tono(escena, i); };
        comprueba(MODELOS[modelo], oraculo::compara(gpu, escena, camara, sombrea), MISMA_MALLA);
    }
};

// --- componentes_phong -------------------------------------------------------------------------------------
const Vec3 LUZ_PHONG{-3.5, 4, 6};
const Material CERAMICA = pintura({0.08, 0.20, 0.38}, {0.14, 0.36, 0.62}, 0.75, 30),
               LATON = {{0.42, 0.23, 0.05}, {0.58, 0.36, 0.08}, {0.60, 0.55, 0.45}, 30};
const Solido BOLA_PHONG = {bola({}, segmentosEsfera(230)), CERAMICA};

Camara camaraPhong(double azimut, double elevacion) {
    return perspectiva(orbita(azimut, elevacion, 10), 0.31, 1, 100);
}

Iluminada componentes(int cuantos, const Camara &camara) {
    Luz luz = posicional(LUZ_PHONG);
    luz.Ld = cuantos >= 2 ? UNO : Vec3{};
    luz.Ls = cuantos >= 3 ? UNO : Vec3{};
    const Malla anillo = toro(1.55f, 0.22f, segmentosEsfera(400), segmentosEsfera(60));
    return {{BOLA_PHONG, {malla(gira(Z, 0.35) * gira(X, -1.15), anillo), LATON}}, {luz}, camara};
}

TEST(ComponentesPhong, ContraTrazadoDeRayos) {
    const struct {
        std::string guion;
        int cuantos;
        double azimut, elevacion;
    } casos[] = {
        {"", 3, 0, 0},
        {"tecla 1", 1, 0, 0},
        {"tecla 2", 2, 0, 0},
        // la luz no gira con la cámara: el brillo se mueve
        {"tecla 3; " + arrastra({100, 90}, {140, 120}), 3, -0.4, 0.3},
    };
    paraCada("componentes_phong", casos, 240, 180, [](const auto &c, const Vista &v) {
        componentes(c.cuantos, camaraPhong(c.azimut, c.elevacion)).compara(v.escena);
    });
}

// Figura 5.2 y ecuación 5.5: en el punto elegido con un clic, los vectores que dan las ecuaciones. De espaldas a la luz
// no hay R. Los demás clics, en componentes_phong.pasos.
TEST(ComponentesPhong, VectoresYAngulosEnElPuntoElegido) {
    const auto elegido = [](int x, int y, double azimut = 0, double elevacion = 0) {
        const Rayo r = rayo(camaraPhong(azimut, elevacion), 239, 360, x + 0.5, 359.5 - y);
        return primerImpacto({esfera(Mat4())}, r).punto;
    };
    const struct {
        std::string guion;
        Vec3 P;
        double azimut, elevacion;
    } casos[] = {
        {clic({100, 150}) + "; tecla n", unitario({-0.16, 0.18, 0.97}), 0, 0}, // sin la n, el clic no elige
        {"tamano 480 540; " + clic({240, 130}) + "; tamano 480 360; " + clic({119, 170}), elegido(119, 170),
         0, 0},
        {arrastra({119, 170}, {179, 210}), elegido(119, 170), -0.3, 0.2},
        {clic({130, 160}), elegido(130, 160, -0.3, 0.2), -0.3, 0.2},
    };
    paraCada("componentes_phong", casos, 480, 360, [&](const auto &c, const Vista &v) {
        const Hueco una = enTira(0, 2, v.escena).hueco, otra = enTira(1, 2, v.escena).hueco;
        const Panel escena(camaraPhong(c.azimut, c.elevacion), una);
        const Vec3 P = c.P, N = P, L = unitario(LUZ_PHONG - P), V = unitario(escena.camara.ojo - P),
                   R = 2 * escalar(N, L) * N - L, centro = P - 0.25 * N;
        // el plano de N y L: caben 3.9 unidades a lo alto
        const Panel lado(paralela(miraDesde(centro + 5 * unitario(vectorial(N, L)), centro, N),
                                  1.95 * altoUtil(otra.ancho, otra.alto) / otra.alto, 1, 10),
                         otra);
        componentes(3, escena.camara).compara(recorta(v.escena, una));
        Iluminada{{BOLA_PHONG}, {}, lado.camara}.compara(recorta(v.escena, otra));

        const auto compruebaVector = [&](const Vec3 &u, const glm::vec3 &color) {
            compruebaTrazo(v.encima, lado.puntos({P, P + 1.2 * u}), color);
        };
        compruebaVector(N, BLANCO);
        compruebaVector(V, VERDE);
        compruebaVector(L, AMARILLO);
        if (escalar(N, L) > 0)
            compruebaVector(R, ROJO);
        else
            EXPECT_TRUE(v.encima.trazos(ROJO).empty());
        compruebaPuntos(v.encima, {escena(P)}, OSCURO);
    });
}

// --- exponente_brillo --------------------------------------------------------------------------------------
// Cinco esferas que solo se distinguen en su α.
TEST(ExponenteBrillo, ContraTrazadoDeRayos) {
    Iluminada e{{}, {direccional({-0.45, 0.60, 1})}, perspectiva(orbita(0, 0, 17), 0.31, 1, 100)};
    const std::pair<Vec3, double> bolas[] = {{{-2.3, 1.25, 0}, 1},
                                             {{0, 1.25, 0}, 5},
                                             {{2.3, 1.25, 0}, 20},
                                             {{-1.15, -1.25, 0}, 100},
                                             {{1.15, -1.25, 0}, 500}};
    for (const auto &[centro, alfa] : bolas)
        e.solidos.push_back({bola(traslada(centro) * escala(1.12), segmentosEsfera(200)),
                             {{0.09, 0.02, 0.03}, {0.44, 0.07, 0.10}, {0.85, 0.85, 0.85}, alfa}});
    e.compara(vistaDe("exponente_brillo", "", 480, 360).escena);
}

// --- materiales --------------------------------------------------------------------------------------------
/// La tabla 5.1 tal como se imprime: el último número es su alfa, una fracción de 128.
const Material TABLA[12] = {{{0.022, 0.17, 0.02}, {0.08, 0.61, 0.08}, {0.63, 0.73, 0.63}, 0.6}, // esmeralda
                            {{0.14, 0.22, 0.16}, {0.54, 0.89, 0.63}, {0.32, 0.32, 0.32}, 0.10},
                            {{0.05, 0.05, 0.07}, {0.18, 0.17, 0.23}, {0.33, 0.33, 0.35}, 0.30},
                            {{0.25, 0.21, 0.21}, {1.0, 0.83, 0.83}, {0.30, 0.30, 0.30}, 0.09},
                            {{0.18, 0.01, 0.01}, {0.61, 0.04, 0.04}, {0.73, 0.63, 0.63}, 0.60},
                            {{0.10, 0.19, 0.17}, {0.39, 0.74, 0.69}, {0.29, 0.31, 0.31}, 0.10},
                            {{0.21, 0.13, 0.05}, {0.71, 0.43, 0.18}, {0.39, 0.27, 0.17}, 0.20},
                            {{0.19, 0.07, 0.02}, {0.71, 0.27, 0.08}, {0.26, 0.14, 0.09}, 0.10},
                            {{0.25, 0.20, 0.07}, {0.75, 0.61, 0.23}, {0.63, 0.56, 0.37}, 0.40},
                            {{0.20, 0.20, 0.20}, {0.51, 0.51, 0.51}, {0.51, 0.51, 0.51}, 0.40},
                            {{0.0, 0.0, 0.0}, {0.55, 0.55, 0.55}, {0.70, 0.70, 0.70}, 0.25},
                            {{0.05, 0.05, 0.05}, {0.50, 0.50, 0.50}, {0.70, 0.70, 0.70}, 0.08}}; // goma

/// El material elegido, de radio 3 y en el centro, o, con −1, los doce, de radio 1 y en tres filas de cuatro.
Iluminada muestra(int elegido) {
    Iluminada e{
        {}, {direccional({-0.9, 0.9, 1})}, perspectiva(orbita(0, 0, 26, {0, -0.3, 0}), 0.325, 1, 100)};
    for (int i = 0; i < 12; ++i)
        if (elegido < 0 || elegido == i) {
            const Mat4 M = elegido < 0 ? traslada(2.7 * Vec3{i % 4 - 1.5, double(1 - i / 4), 0}) : escala(3);
            Material m = TABLA[i];
            m.alfa *= 128;
            e.solidos.push_back({bola(M, segmentosEsfera(elegido < 0 ? 95 : 290)), m});
        }
    return e;
}

// La tecla n pasa al siguiente, y tras el duodécimo, o tras la t, que los enseña todos, al primero.
TEST(Materiales, ContraTrazadoDeRayos) {
    std::vector<std::string> guiones(16, "tecla n");
    guiones[0] = "";
    guiones[14] = "tecla t";
    const auto vistas = vistasDe("materiales", guiones);
    for (int i = 0; i < 16; ++i)
        muestra(i % 14 == 0 ? -1 : (i % 14 - 1) % 12).compara(vistas[i].escena);
}

// --- fuentes -----------------------------------------------------------------------------------------------
const Vec3 FUENTE{-0.9, 3.3, 1.1}, S = unitario(Vec3{0.3, 0, 0} - FUENTE);

struct Fuente {
    std::string guion;
    int tipo; // 1 posicional, 2 direccional, 3 foco
    double grados = 30, exponente = 4, azimut = 0.35, elevacion = 0.5;

    Iluminada escena() const {
        const int n = segmentosEsfera(100);
        return {{{plano(DE_PIE * escala(6)), pintura({0.20, 0.21, 0.23}, {0.62, 0.64, 0.68}, 0.15, 20)},
                 {bola(traslada({0.3, 0.8, 0.2}) * escala(0.8), n),
                  pintura({0.18, 0.05, 0.05}, {0.75, 0.18, 0.16}, 0.60, 50)},
                 {malla(traslada({2.0, 0, -1.2}) * DE_PIE * escala({0.8, 0.8, 1.9}), porCaras(cono(n))),
                  pintura({0.05, 0.15, 0.07}, {0.18, 0.62, 0.28}, 0.50, 50)},
                 {bloque(traslada({-1.7, 0.6, -1.1}) * gira(Y, 0.5) * escala(1.2)),
                  pintura({0.05, 0.10, 0.20}, {0.16, 0.40, 0.80}, 0.60, 50)},
                 {malla(traslada({1.5, 0.25, 1.9}) * DE_PIE, toro(0.7f, 0.25f, segmentosEsfera(400), n)),
                  pintura({0.19, 0.11, 0.03}, {0.80, 0.46, 0.10}, 0.50, 50)}},
                {tipo == 1   ? posicional(FUENTE)
                 : tipo == 2 ? direccional(-S)
                             : foco(FUENTE, FUENTE + S, grados * PI / 180, exponente)},
                perspectiva(orbita(azimut, elevacion, 19, {0, 0.75, 0}), 0.35, 1, 100)};
    }
};

TEST(Fuentes, LosTresTiposContraTrazadoDeRayos) {
    const Fuente casos[] = {
        {"tecla 2", 2},
        {"tecla 1", 1},
        {"tecla 3", 3},
        {"tecla + ×2", 3, 30, 16},
        // el exponente, entre 0.5 y 64; el cono, entre 0 y 90 grados
        {"tecla - ×6", 3, 30, 0.5},
        {"tecla + ×8", 3, 30, 64},
        {"tecla - ×4; tecla ,", 3, 25},
        {"tecla . ×21", 3, 90},
        {"tecla , ×21", 3, 0},
        // por mucho que se arrastre, la cámara no baja del suelo
        {"tecla . ×6; " + arrastra({100, 200}, {20, -2000}), 3, 30, 4, 0.95, 0.05},
        {"tamano 800 600", 3, 30, 4, 0.95, 0.05}, // el borde del cono, de cerca
    };
    paraCada("fuentes", casos, 320, 240,
             [](const Fuente &f, const Vista &v) { f.escena().compara(v.escena); });
}

// --- atenuacion --------------------------------------------------------------------------------------------
struct Atenuacion {
    std::string guion;
    double b, c; // a = 1

    Iluminada escena() const {
        const int n = segmentosEsfera(90);
        const Mat4 suelo = traslada({3, -0.42, 0}) * DE_PIE * escala({7.2, 2, 1});
        Iluminada e{{{plano(suelo), {{0.05, 0.05, 0.06}, {0.55, 0.57, 0.60}, {}, 1}},
                     {bola(escala(0.2), n), {{1.00, 0.93, 0.60}, {}, {}, 1}}},
                    {atenuada(posicional({}), 1, b, c)},
                    perspectiva(orbita(0, 0.012, 150, {3.1, 1.6, 0}), 0.0385, 50, 400)};
        for (int d = 1; d <= 6; ++d)
            e.solidos.push_back({bola(traslada({double(d), 0, 0}) * escala(0.42), n),
                                 pintura({0.26, 0.15, 0.04}, {0.84, 0.50, 0.12}, 0.30, 20)});
        return e;
    }
};

TEST(Atenuacion, ContraTrazadoDeRayos) {
    const Atenuacion casos[] = {
        {"tecla 1", 0, 0}, {"tecla 2", 1 / 3.0, 0}, {"tecla 3", 0, 1 / 9.0}, {"tecla 1", 0, 0}};
    paraCada("atenuacion", casos, 240, 180,
             [](const Atenuacion &a, const Vista &v) { a.escena().compara(v.escena); });
}

// --- varias_luces ------------------------------------------------------------------------------------------
struct VariasLuces {
    std::string guion;
    bool encendida[3];

    static Vec3 hacia(int i) {
        const double a = (-150 + 120 * i) * PI / 180;
        return {std::cos(a), 0, -std::sin(a)};
    }
    Iluminada escena() const {
        const Vec3 colores[] = {{0.92, 0.06, 0.06}, {0.06, 0.95, 0.06}, {0.06, 0.06, 1}};
        const Material mate = {{0.20, 0.20, 0.22}, {0.80, 0.80, 0.80}, {}, 1},
                       brillante = pintura({0.20, 0.20, 0.22}, {0.60, 0.60, 0.60}, 0.30, 40);
        const Mat4 disco = traslada({0, -0.1, 0}) * DE_PIE * escala({3.7, 3.7, 0.2});
        Iluminada e{{{malla(disco, cilindro(segmentosEsfera(430))), mate},
                     {bola(traslada({0, 0.65, -1}) * escala(0.65), segmentosEsfera(100)), brillante}},
                    {},
                    perspectiva(orbita(0, 0.85, 18.2, {0, -0.25, 0}), 0.36, 1, 100)};
        for (int i = 0; i < 3; ++i) {
            e.luces.push_back(
                atenuada(foco(3 * hacia(i) + 5 * Y, 1.1 * hacia(i), 0.40, 2 + i), 0.6, 0.04, 0.01));
            e.luces[i].Ld = e.luces[i].Ls = encendida[i] ? colores[i] : Vec3{};
        }
        return e;
    }
};

TEST(VariasLuces, ContraTrazadoDeRayos) {
    const VariasLuces casos[] = {{"", {true, true, true}},
                                 {"tecla 2; tecla 3", {true, false, false}},
                                 {"tecla 1; tecla 2", {false, true, false}},
                                 {"tecla 2; tecla 3", {false, false, true}},
                                 {"tecla 3", {false, false, false}},
                                 {"tecla 2; tecla 3", {false, true, true}}};
    paraCada("varias_luces", casos, 240, 180,
             [](const VariasLuces &c, const Vista &v) { c.escena().compara(v.escena); });
}

// --- sombreado ---------------------------------------------------------------------------------------------
/// En un panel alto la esfera está encima del toro, y la vista, compuesta para 4:9, abarca 0.42 radianes a lo alto; de
/// una de 4:3 sería la tercera parte de su tangente.
struct Sombreado {
    std::string guion;
    int modelo, n, paneles = 1; // cada uno, el modelo siguiente

    Iluminada escena(bool alto) const {
        const Mat4 E = traslada(alto ? 0.8 * Y : Vec3{-0.95, 0.25, 0}) * gira(X, -1.2),
                   T = traslada(alto ? Vec3{0, -0.95, 0.5} : Vec3{0.98, -0.35, 0.5}) * gira(X, -0.7);
        return {{{bola(E, n), pintura({0.05, 0.14, 0.14}, {0.12, 0.50, 0.50}, 0.75, 16)},
                 {malla(T, toro(0.68f, 0.30f, n, n / 2)),
                  pintura({0.20, 0.08, 0.05}, {0.62, 0.26, 0.17}, 0.70, 16)}},
                {posicional({-3, 4, 6})},
                perspectiva(orbita(0, 0, 12), alto ? 2 * std::atan(std::tan(0.21) / 3) : 0.27, 1, 100),
                FONDO,
                modelo};
    }
};

// Con v, los tres a la vez y en su orden.
TEST(Sombreado, CadaModeloContraSuMallaEnDoble) {
    const Sombreado casos[] = {{"", PLANO, 12},
                               {"tecla -", PLANO, 6},
                               {"tecla 2", GOURAUD, 6},
                               {"tecla 3", PHONG, 6},
                               // la subdivisión tiene tope por los dos lados
                               {"tecla -; tecla + ×2", PHONG, 24},
                               {"tecla 1", PLANO, 24},
                               {"tecla 3; tecla + ×4", PHONG, 192},
                               {"tecla 1; tecla -", PLANO, 96},
                               {"tecla - ×3; tecla v; tamano 480 360", PLANO, 12, 3},
                               {"tamano 180 400", PLANO, 12, 3}};
    paraCada("sombreado", casos, 320, 240, [](Sombreado s, const Vista &v) {
        const bool alto = s.paneles > 1 && v.escena.ancho > v.escena.alto;
        for (int k = 0; k < s.paneles; ++k, ++s.modelo)
            s.escena(alto).compara(recorta(v.escena, enTira(k, s.paneles, v.escena)));
    });
}

// --- grua_iluminada ----------------------------------------------------------------------------------------
/// El suelo, la zapata, la caseta y la grúa del ejercicio 3.5 con sus medidas, girada `giro`, con la carga a `lejos`
/// del pie y a esa altura.
struct Grua {
    std::string guion;
    int modelo;
    double giro = 0, lejos = 5, altura = 4;
    int paneles = 1;

    Iluminada escena() const {
        const Mat4 G = gira(Y, giro), caseta = traslada({-2.4, 0, 2.4}) * gira(Y, 0.4);
        const double cable = 10 - altura - 0.5;
        const Material tierra = pintura({0.13, 0.17, 0.12}, {0.46, 0.58, 0.42}, 0.25, 12),
                       hormigon = pintura({0.12, 0.13, 0.14}, {0.45, 0.47, 0.50}, 0.05, 5),
                       amarilla = pintura({0.25, 0.18, 0.03}, {0.68, 0.50, 0.08}, 0.60, 15),
                       acero = pintura({0.06, 0.06, 0.07}, {0.20, 0.21, 0.24}, 0.70, 80),
                       chapa = pintura({0.22, 0.05, 0.05}, {0.68, 0.14, 0.12}, 0.60, 30);
        return {{{bloque(traslada({0, -0.1, 0}) * escala({8, 0.2, 8})), tierra},
                 {bloque(traslada({0, 0.2, 0}) * escala({2.4, 0.4, 2.4})), hormigon},
                 {bloque(caseta * traslada({0, 0.6, 0}) * escala({1.6, 1.2, 1.8})), hormigon},
                 {bloque(caseta * traslada({0, 1.2, 0}) * escala({1.4, 0.9, 1.78}) * gira({0, 0, 1}, PI / 4)),
                  chapa},
                 {bloque(traslada({0, 5, 0}) * escala({0.8, 10, 0.8})), amarilla},
                 {bloque(G * traslada({2.5, 10.4, 0}) * escala({10, 0.8, 0.8})), amarilla},
                 {bloque(G * traslada({-1.8, 9.3, 0}) * escala(1.4)), hormigon},
                 {bloque(G * traslada({lejos, 10 - cable / 2, 0}) * escala({0.12, cable, 0.12})), acero},
                 {bloque(G * traslada({lejos, altura, 0})), chapa}},
                {posicional({3.5, 8.5, 5.5})},
                perspectiva(orbita(0.5, 0.25, 34, {0.3, 4.7, 0}), 0.45, 1, 200),
                {0.87, 0.93, 0.98},
                modelo};
    }
};

// Cada tecla, en su sentido: q acerca la carga al pie y e la aleja; w la sube y s la baja; a y d giran. Con v, Gouraud
// a la izquierda y Phong a la derecha o, en una ventana alta, debajo.
TEST(GruaIluminada, CarasContraLaEcuacion56) {
    const Grua casos[] = {{"", GOURAUD},
                          {"tecla g", PHONG},
                          {"tecla g; tecla d ×3", GOURAUD, -0.3},
                          {"tecla a ×6; tecla g; tecla q ×2", PHONG, 0.3, 4},
                          {"tecla e ×4; tecla w ×3", PHONG, 0.3, 6, 5.5},
                          {"tecla s ×5", PHONG, 0.3, 6, 3},
                          {"tecla v; tamano 484 180", GOURAUD, 0.3, 6, 3, 2},
                          {"tamano 240 360", GOURAUD, 0.3, 6, 3, 2}};
    paraCada("grua_iluminada", casos, 240, 180, [](Grua g, const Vista &v) {
        for (int k = 0; k < g.paneles; ++k, ++g.modelo)
            g.escena().compara(recorta(v.escena, enTira(k, g.paneles, v.escena)));
    });
}

} // namespace
