// El capítulo 7: la matriz de la sombra y los cinco programas contra trazado de rayos en doble precisión: un rebote en
// el espejo, rayos a la luz en las sombras y composición de atrás adelante en lo transparente. Las escenas, los
// materiales y las luces están escritos otra vez; las formas curvas son las mallas de common/malla.h.
#include "azar.h"
#include "ch07_realismo/sombra.h"
#include "colores.h"
#include "contra_oraculo.h"
#include "guiones.h"
#include "panel.h"
#include "tabla.h"

using namespace oraculo;

// La sombra de x es donde la recta que sale de la luz y pasa por x corta al plano; w es positiva solo si x está entre
// la luz y el plano o por debajo de él. Con la luz en un punto (L.w = 1 o 2) y en el infinito (L.w = 0).
TEST(Sombra, ContraDoblePrecision) {
    Azar azar(8);
    double peor = 0;
    for (int n = 0; n < 6000; ++n) {
        const Plano plano = planoPor(azar.vector(2), azar.direccion());
        const float w = float(n % 3);
        const glm::vec3 base = -plano.d * plano.N; // un punto del plano
        const glm::vec3 deLuz = plano.N * azar.entre(1.0f, 4.0f) + glm::cross(plano.N, azar.vector(2));
        const glm::vec4 L = w == 0 ? glm::vec4(deLuz, 0) : glm::vec4((base + deLuz) * w, w);
        const glm::vec3 x = base + plano.N * azar.entre(0.0f, 0.8f) + glm::cross(plano.N, azar.vector(3));
        const glm::vec4 y = proyeccionSombra(L, plano) * glm::vec4(x, 1);
        ASSERT_GT(alturaLuz(L, plano), 0);
        ASSERT_GT(y.w, 0);
        EXPECT_NEAR(y.w, alturaLuz(L, plano) - L.w * distancia(plano, x),
                    1e-5); // ocho redondeos de un número de tamaño 8
        // x + t·(x − L) en el plano, con los números float tal como son
        const glm::dvec3 N(plano.N), p(x), haciaAbajo = p * double(w) - glm::dvec3(L);
        const double t = -(glm::dot(N, p) + double(plano.d)) / glm::dot(N, haciaAbajo);
        peor = std::max(peor, glm::distance(glm::dvec3(y) / double(y.w), p + t * haciaAbajo));
    }
    EXPECT_LE(peor, 1e-3); // rayos casi rasantes: la sombra llega a distancia 60
}

namespace {

const Vec3 FONDO = exacto(CIELO);

/// Sin nada que mezclar, el redondeo a 8 bits y una centésima de hacer las cuentas en float. Una mezcla puede costar un
/// nivel: medio por redondear alfa y otro medio por redondear el resultado.
Cotas mezclando(int veces, int lejosDeCada = 500) {
    return {0.51 + veces, lejosDeCada};
}
/// Lo que sale del fragment shader y lo que guarda el framebuffer no pasan de 1.
Vec3 recortado(const Vec3 &c) {
    return {std::min(c.x, 1.0), std::min(c.y, 1.0), std::min(c.z, 1.0)};
}
Vec3 mezclado(const Vec3 &fondo, const Vec3 &color, double alfa) { // ecuación 7.1
    return mezcla(recortado(fondo), recortado(color), alfa);
}

/// Arrastrar desde un mismo punto, en píxeles de una ventana de 180 de alto: 100 son un radián de órbita.
std::string arrastra(int dx, int dy, const std::string &boton = "IZQUIERDO") {
    return ::arrastra({50, 60}, {50 + dx, 60 + dy}, boton);
}
Camara camara(double azimut, double elevacion, double distancia, const Vec3 &centro, double angulo) {
    return perspectiva(orbita(azimut, elevacion, distancia, centro), angulo, 1, 60);
}

/// Objetos pintados, cada uno de un color, con luz ambiente (1, 1, 1) y otra: la ecuación 5.7.
struct Pintados {
    double brillo, alfa;
    Vec3 luz;
    Escena escena = {};
    std::vector<Vec3> colores = {};

    void pon(const Objeto &objeto, const glm::dvec3 &color) {
        escena.push_back(objeto);
        colores.push_back(exacto(color));
    }
    Vec3 color(const Impacto &i, const Vec3 &c) const {
        return phong({0.35 * c, 0.75 * c, brillo * UNO, alfa}, UNO, {posicional(luz)}, i.punto, i.normal,
                     haciaOjo(i));
    }
    Vec3 color(const Impacto &i) const {
        return i ? color(i, colores[i.objeto]) : FONDO;
    }
};

// --- espejo y espejo_plantilla -----------------------------------------------------------------------------
const Vec3 CENTRO{0, 1.68, -1.9}, AZOGUE{0.40, 0.52, 0.60};
const double GIRO = 0.35, ANCHO = 5.2, ALTO = 2.9, MARCO = 0.18, ALFA_ESPEJO = 0.25;
const Vec3 NORMAL_ESPEJO{std::sin(GIRO), 0, std::cos(GIRO)};
enum { SUELO_ESPEJO, CONO_ESPEJO = 5, ESPEJO = 11 }; // en la lista
const int REFLEJADO = 1 << 28;                       // zona de lo que se ve por el espejo

Pintados escenaEspejo(double avance) {
    Pintados e{0.35, 40, {2.5, 6, 5}};
    e.pon(plano(DE_PIE * escala({8, 6, 1})), {}); // el suelo: su color depende de la baldosa
    const glm::dvec3 rojo{0.90, 0.22, 0.18}, madera{0.62, 0.42, 0.24};
    const Mat4 F = traslada(-avance * NORMAL_ESPEJO + Vec3{0.5, 0, 0.9}) * gira(Y, 0.2);
    e.pon(caja(F * traslada({-0.45, 1, 0}) * escala({0.4, 2, 0.4})), rojo);
    e.pon(caja(F * traslada({0.25, 1.8, 0}) * escala({1, 0.4, 0.4})), rojo);
    e.pon(caja(F * traslada({0.10, 1.1, 0}) * escala({0.7, 0.35, 0.4})), rojo);
    e.pon(enElMundo(traslada({2.1, 0.6, 0.6}) * escala(0.6), esfera(64)), {0.98, 0.75, 0.12});
    e.pon(enElMundo(traslada({-2.4, 0, 1.6}) * DE_PIE * escala({0.6, 0.6, 1.5}), cono(64)),
          {0.20, 0.62, 0.30});
    const Mat4 tabla = traslada(CENTRO) * gira(Y, GIRO) * traslada({0, 0, -MARCO / 2 - 0.02});
    e.pon(caja(tabla * escala({ANCHO + 2 * MARCO, ALTO + 2 * MARCO, MARCO})), madera);
    for (const double s : {-0.5, 0.5}) {
        e.pon(caja(tabla * traslada({0, s * (ALTO + MARCO), MARCO}) *
                   escala({ANCHO + 2 * MARCO, MARCO, MARCO})),
              madera);
        e.pon(caja(tabla * traslada({s * (ANCHO + MARCO), 0, MARCO}) * escala({MARCO, ALTO, MARCO})), madera);
    }
    e.pon(plano(traslada(CENTRO) * gira(Y, GIRO) * escala({ANCHO, ALTO, 1})), {});
    return e;
}

/// Lo que se ve sin contar el espejo. Son zonas distintas cada cara de cada objeto, cada baldosa y cada faceta del
/// cono, que en el vértice cambia de normal.
Tono tono(const Pintados &e, const Impacto &i) {
    if (!i)
        return FONDO;
    const bool deSuelo = i.objeto == SUELO_ESPEJO,
               oscura = deSuelo && int(std::floor(i.punto.x) + std::floor(i.punto.z)) % 2 != 0;
    const Vec3 baldosa = oscura ? Vec3{0.36, 0.52, 0.62} : Vec3{0.92, 0.90, 0.84};
    const int cara = i.objeto == CONO_ESPEJO ? i.corte.triangulo : i.corte.cara;
    return {e.color(i, deSuelo ? baldosa : e.colores[i.objeto]),
            2 * (10000 * (i.objeto + 1) + cara) + oscura};
}
/// Y con él: el reflejo es lo que ve, del otro lado del plano, el rayo simétrico. Sin plantilla se sale del espejo, y
/// se ve donde nada real lo tapa: el suelo y su reflejo coinciden. Como en el listado, lo que hay detrás del espejo no
/// se ha quitado, y se ve lo que esté más cerca.
Tono conEspejo(const Pintados &e, const Impacto &i, double azogue, bool conPlantilla = true,
               bool comoEnElListado = false) {
    const auto alEspejo = [](const Vec3 &v) { return escalar(v, NORMAL_ESPEJO); };
    const Rayo &r = i.rayo;
    const double alto = alEspejo(r.origen - CENTRO), lejos = -alto / alEspejo(r.direccion);
    const bool enEspejo = i.objeto == ESPEJO;
    if (!enEspejo && (conPlantilla || lejos < 0))
        return tono(e, i);
    const Impacto visto = primerImpacto(
        e.escena, {r.origen - 2 * alto * NORMAL_ESPEJO, refleja(r.direccion, NORMAL_ESPEJO), lejos + 1e-6});
    if (!enEspejo && (!visto || (i && visto.distancia > i.distancia - 1e-6)))
        return tono(e, i);
    const Impacto detras =
        comoEnElListado ? primerImpacto(e.escena, {r.origen, r.direccion, lejos + 1e-6}) : Impacto{};
    const Tono t = tono(e, detras && !(visto && visto.distancia < detras.distancia) ? detras : visto);
    return {mezclado(t.color, AZOGUE, azogue), REFLEJADO + t.zona};
}

// La figura 7.2 contra un rebote. Delante del espejo hay objetos más cercanos, que lo tapan: el cono y la F, que lo
// atraviesa: de la parte que está detrás no hay reflejo. La cámara da la vuelta: de frente, casi de canto, de canto,
// donde el espejo no se ve, y por detrás, donde solo hay tabla; y no baja del suelo. En el orden del listado la tabla
// tapa lo reflejado.
TEST(Espejo, ContraTrazadoDeRayosConUnRebote) {
    const struct {
        std::string guion;
        double avance, azimut = -0.30, elevacion = 0.30;
        bool comoEnElListado = false;
    } casos[] = {
        {"", 0},
        {"tecla l", 0, -0.30, 0.30, true},
        {"tecla l", 0},
        {veces(14, "tecla a"), 2.8},
        {veces(6, "tecla a") + "; " + arrastra(-40, 50), 3, 0.10, 0.80}, // desde arriba la tabla no tapa la F
        {arrastra(40, -50) + "; " + veces(40, "tecla d"), -1},
        {veces(5, "tecla a") + "; " + arrastra(60, 0), 0, -0.90},
        {arrastra(45, 0), 0, -1.35},
        {arrastra(45, 0), 0, -1.80},
        {arrastra(105, 0), 0, -2.85},
        {arrastra(-255, -300), 0, -0.30, 0.02},
    };
    paraCada("espejo", casos, 240, 180, [](const auto &c, const Vista &v) {
        const Pintados e = escenaEspejo(c.avance);
        const Camara desde = camara(c.azimut, c.elevacion, 15.5, {0.35, 0.95, 0}, 0.5);
        const auto sombrea = [&](const Impacto &i) {
            return conEspejo(e, i, ALFA_ESPEJO, true, c.comoEnElListado);
        };
        comprueba(c.guion, v.escena, render(e.escena, desde, 240, 180, sombrea), mezclando(1));
    });
}

// Figura 7.3. Las dos a la vez se reparten la ventana según su forma; una encima de otra, son muy anchas.
TEST(EspejoPlantilla, ConYSin) {
    const struct {
        std::string guion;
        std::vector<bool> conPlantilla; // en cada panel
        int columnas = 1;
        double azimut = -0.30;
    } casos[] = {
        {"", {true}},
        {"tecla p", {false}},
        {"tecla v", {false, true}},
        {"tecla p; tecla v; tamano 361 180", {false, true}, 2},
        {"tecla v; tamano 240 181; " + arrastra(-30, 0), {true}, 1, 0},
    };
    paraCada("espejo_plantilla", casos, 240, 181, [](const auto &c, const Vista &v) {
        const Pintados e = escenaEspejo(0);
        const int n = int(c.conPlantilla.size());
        const Camara desde = camara(c.azimut, 0.30, 17.5, {-0.7, 0.95, 0}, c.columnas < n ? 0.36 : 0.5);
        for (int k = 0; k < n; ++k) {
            const Panel panel(desde, v.escena, k, n, c.columnas);
            const auto sombrea = [&](const Impacto &i) { return conEspejo(e, i, 0, c.conPlantilla[k]); };
            comprueba(c.guion, recorta(v.escena, panel), render(e.escena, panel, sombrea), mezclando(0));
        }
    });
}

// --- transparencia -----------------------------------------------------------------------------------------
/// Composición de atrás adelante: lo opaco, la pared del cilindro vista por dentro y la vista por fuera.
ImagenRef vidrio(double alfa, const Panel &panel) {
    Pintados opacos{0.2, 20, {4, 7, 6}};
    opacos.pon(caja(traslada({0, -0.1, 0}) * escala({4.4, 0.2, 3.4})), {0.85, 0.82, 0.74});
    opacos.pon(caja(traslada({0, 0.55, 0}) * gira(Y, 0.6) * escala(0.75)), ROJO);
    opacos.pon(enElMundo(traslada({1.45, 0.45, -0.9}) * escala(0.45), esfera(48)), AMARILLO);
    for (int i = 0; i < 5; ++i)
        opacos.pon(caja(traslada({-1.8 + 0.55 * i, 0.9, -1.4}) * escala({0.26, 1.8, 0.12})),
                   i % 2 ? VERDE : NARANJA);
    const Escena cilindros = {
        enElMundo(traslada({0, 1.07, 0}) * DE_PIE * escala({1, 1, 2.1}), cilindro(segmentosPara(250)))};
    const Material cristal{{0.10, 0.28, 0.42}, {0.15, 0.50, 0.75}, {0.9, 0.9, 0.9}, 60};
    return render(opacos.escena, panel, [&](const Impacto &fondo) -> Tono {
        Rayo r = fondo.rayo;
        r.maximo = fondo ? fondo.distancia : r.maximo;
        const std::vector<Impacto> paredes = impactos(cilindros, r);
        Vec3 color = opacos.color(fondo);
        int zona = 0;
        for (auto i = paredes.rbegin(); i != paredes.rend(); ++i) {
            const Vec3 normal = i->frente ? i->normal : -i->normal;
            color = mezclado(
                color, phong(cristal, UNO, {posicional(opacos.luz)}, i->punto, normal, haciaOjo(*i)), alfa);
            zona = 1000 * zona + 2 * (1 + i->corte.cara) + i->frente;
        }
        return {color, zona};
    });
}

// Desde el otro lado son otras las caras de delante. Alfa no sale de 0 a 1.
TEST(Transparencia, DeAtrasAdelanteEnDoble) {
    const struct {
        std::string guion;
        std::vector<double> alfas; // la de cada panel
        double azimut = 0.35, elevacion = 0.30;
    } casos[] = {
        {"", {0.4}},
        {"tecla 1", {0.1}},
        {"tecla 3", {0.7}},
        {"tecla 4; tecla - ×2", {0.8}},
        {"tecla + ×9", {1}},
        {"tecla - ×20", {0}},
        {"tecla v; tamano 481 361", {0.1, 0.4, 0.7, 1}},
        {"tecla v; tamano 240 180; tecla 2; " + arrastra(250, 0), {0.4}, 0.35 - 2.5},
        {arrastra(0, -300), {0.4}, 0.35 - 2.5, 0.02},
    };
    paraCada("transparencia", casos, 240, 180, [](const auto &c, const Vista &v) {
        const int n = int(c.alfas.size());
        for (int k = 0; k < n; ++k) {
            const Panel panel(camara(c.azimut, c.elevacion, 9.2, {0, 0.95, 0}, 0.5), v.escena, k, n,
                              n == 4 ? 2 : 1);
            comprueba(c.guion, recorta(v.escena, panel), vidrio(c.alfas[k], panel), mezclando(2));
        }
    });
}

// --- orden_transparencia -----------------------------------------------------------------------------------
/// Un panel: las barras opacas y los dos cristales, lisos, en el orden dado (0, el rojo). Con `aditivo`, la ecuación
/// 7.2; si `escriben` su profundidad, el que está detrás de uno ya dibujado no se dibuja.
ImagenRef cristales(std::array<int, 2> orden, bool aditivo, bool escriben, const Panel &panel) {
    Escena barras;
    for (const double x : {-1.25, -0.36, 0.3})
        barras.push_back(caja(traslada({x, -0.2, -1}) * escala({0.16, 3.5, 0.16})));
    const Escena cristal[2] = {{plano(traslada({-0.2, 0.15, 0.35}) * escala({1.5, 2.4, 1}))},
                               {plano(traslada({0.2, -0.15, -0.35}) * escala({1.5, 2.4, 1}))}};
    const Vec3 colores[2] = {{1, 0.25, 0.2}, {0.25, 0.6, 1}};
    const double alfa = 0.55;
    return render(barras, panel, [&](const Impacto &i) -> Tono {
        Vec3 color = exacto(i ? GRIS : FONDO_OSCURO);
        int zona = 0;
        double delante = i ? i.distancia : 1e9;
        for (const int k : orden) {
            const Impacto c = primerImpacto(cristal[k], i.rayo);
            if (!c || c.distancia > delante)
                continue;
            delante = escriben ? c.distancia : delante;
            zona += 1 + k;
            color = aditivo ? recortado(color + alfa * colores[k]) : mezclado(color, colores[k], alfa);
        }
        return {color, zona};
    });
}

// Ecuaciones 7.1 y 7.2 con los colores exactos. Según llegan, los dos lados difieren donde se solapan; ordenados o
// sumando, no. Por detrás el más lejano es el otro: el orden no es fijo. Si escriben su profundidad, sumar depende
// también del orden, y ordenarlos lo arregla.
TEST(OrdenTransparencia, ColoresExactos) {
    const struct {
        std::string guion;
        std::array<int, 2> izquierda, derecha;
        bool aditivo, escriben, iguales;
        double azimut = 0.55;
    } casos[] = {
        {"", {0, 1}, {1, 0}, false, false, false},
        {"tecla 2", {1, 0}, {1, 0}, false, false, true},
        {"tecla 3", {0, 1}, {1, 0}, true, false, true},
        {"tecla d", {0, 1}, {1, 0}, true, true, false},
        {"tecla 2", {1, 0}, {1, 0}, false, true, true},
        {"tecla d; " + arrastra(300, 0), {0, 1}, {0, 1}, false, false, true, 0.55 - 3},
        {"tecla 1", {0, 1}, {1, 0}, false, false, false, 0.55 - 3},
    };
    paraCada("orden_transparencia", casos, 241, 180, [](const auto &c, const Vista &v) {
        Imagen lados[2];
        for (const int k : {0, 1}) {
            const Panel panel(camara(c.azimut, 0.25, 6.6, {}, 0.36), v.escena, k, 2, 2);
            lados[k] = recorta(v.escena, panel);
            comprueba(c.guion, lados[k], cristales(k ? c.derecha : c.izquierda, c.aditivo, c.escriben, panel),
                      mezclando(2));
        }
        EXPECT_EQ(lados[0].rgb == lados[1].rgb, c.iguales);
    });
}

// --- sombras -----------------------------------------------------------------------------------------------
struct CasoSombras {
    std::string guion;
    Vec3 luz;
    double azimut = 0.25, elevacion = 0.48;
    bool transparente = true, plantilla = true;

    Camara camara() const {
        return ::camara(azimut, elevacion, 13, {0.2, 0.8, 0}, 0.45);
    }
};
enum { TABLERO = 5, TABLA, LAMPARA };

/// Zona: las capas de sombra, que son las caras que miran a la luz entre ella y el punto de la mesa que se ve.
ImagenRef traza(const CasoSombras &c) {
    Pintados e{0.3, 30, c.luz};
    e.pon(enElMundo(traslada({-0.6, 1.1, 0.3}) * gira(Y, 0.7), toro(0.7f, 0.22f, 64, 32)), NARANJA);
    e.pon(enElMundo(traslada({-0.6, 0.1, 0.3}) * DE_PIE * escala({0.35, 0.35, 0.2}), cilindro(48)), OSCURO);
    e.pon(enElMundo(traslada({1.4, 0.5, 1.1}) * escala(0.5), esfera(48)), ROJO);
    e.pon(caja(traslada({0.75, 0.45, -1.0}) * gira(Y, 0.5) * escala(0.9)), VERDE);
    e.pon(enElMundo(traslada({1.9, 0.55, -0.5}) * DE_PIE * escala({0.16, 0.16, 1.1}), cilindro(48)), AZUL);
    const Escena objetos = e.escena;
    e.pon(plano(DE_PIE * escala({6, 4.4, 1})), {0.88, 0.80, 0.66});
    e.pon(caja(traslada({0, -0.135, 0}) * escala({5.94, 0.25, 4.34})), {0.55, 0.38, 0.22});
    e.pon(enElMundo(traslada(c.luz) * escala(0.14), esfera(48)), {});
    return render(e.escena, c.camara(), 240, 180, [&](const Impacto &i) -> Tono {
        const bool enMesa = i.objeto == TABLERO,
                   oscura =
                       enMesa && int(std::floor(i.punto.x / 0.75) + std::floor(i.punto.z * 6 / 4.4)) % 2 != 0;
        Vec3 color = i.objeto == LAMPARA ? Vec3{1, 0.95, 0.6}
                     : oscura            ? e.color(i, {0.74, 0.58, 0.42})
                                         : e.color(i);
        const double t = -i.rayo.origen.y / i.rayo.direccion.y; // hasta el plano de la mesa
        if (c.luz.y <= 0 || t < 0 || (i && !enMesa && i.distancia < t) || (c.plantilla && !enMesa))
            return {color, oscura};
        const Vec3 p = i.rayo.origen + t * i.rayo.direccion;
        int capas = 0;
        for (const Impacto &tapa : impactos(objetos, rayoDesde(p, c.luz - p, longitud(c.luz - p))))
            capas += !tapa.frente;
        if (c.plantilla)
            capas = std::min(capas, 1);
        for (int k = 0; k < capas; ++k)
            color = c.transparente ? mezclado(color, {}, 0.5) : exacto(OSCURO);
        return {color, 2 * capas + oscura};
    });
}

// Con la luz más baja que los objetos, lo que queda por encima de ella no da sombra, ni la da al otro lado: se mira
// desde varios por si la antisombra quedara delante de la cámara. Bajo la mesa la luz no da sombras.
TEST(Sombras, ContraRayosALaLuz) {
    const Vec3 alta{-1.8, 3.2, 0.8}, media{-1.8, 0.6, 0.8};
    const std::string derecho = "DERECHO";
    const CasoSombras casos[] = {
        {"", alta},
        {"tecla o; tecla t; tecla o", alta, 0.25, 0.48, false},
        {"tecla t; tecla p", alta, 0.25, 0.48, true, false},
        {"tecla p; " + arrastra(20, 10), alta, 0.05, 0.58},
        {arrastra(-20, -10) + "; " + arrastra(0, 270, derecho), {-1.8, 0.5, 0.8}},
        {arrastra(0, -400), {-1.8, 0.5, 0.8}, 0.25, 0.05},
        {arrastra(0, 37) + "; " + arrastra(0, -10, derecho) + "; tecla p; " + arrastra(-150, 0), media, 1.75,
         0.42, true, false},
        {arrastra(250, 0), media, -0.75, 0.42, true, false},
        {arrastra(100, 0), media, -1.75, 0.42, true, false},
        {"tecla p; " + arrastra(-200, 0) + "; " + arrastra(-500, -500, derecho), {-3, 3.4, 0.8}, 0.25, 0.42},
        {arrastra(900, 900, derecho), {3, -0.5, 0.8}, 0.25, 0.42},
        {arrastra(-60, -180, derecho) + "; tecla w ×6", {2.4, 1.3, -0.4}, 0.25, 0.42},
    };
    paraCada("sombras", casos, 240, 180, [](const CasoSombras &c, const Vista &v) {
        // sin plantilla, el desplazamiento adelanta la sombra un cuarto de píxel sobre lo que se apoya en la mesa
        comprueba(c.guion, v.escena, traza(c), c.plantilla ? mezclando(1) : mezclando(3, 200));
    });
}

// Sin desplazamiento, mesa y sombra se cosen: faltan trozos de sombra.
TEST(Sombras, DesplazamientoDePoligono) {
    const Comparacion c = compara(vistaDe("sombras", "tecla o").escena, traza({"", {-1.8, 3.2, 0.8}}));
    EXPECT_GT(c.maximo, 50);
    EXPECT_GT(c.rmse, 5); // con ese máximo, cientos de píxeles
}

} // namespace
