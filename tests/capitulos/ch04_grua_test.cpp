// grua_vistas, grua_proyeccion y grua_zbuffer: la grúa entera en cada vista, y cada panel contra el oráculo.
#include "ch04_oraculo.h"
#include "ch04_vista3d/camaras_grua.h"
#include "tabla.h"

namespace {

using namespace oraculo;

/// La grúa del ejercicio 3.5 escrita otra vez, en doble.
struct Postura {
    double giro = 0.58, distancia = 5, altura = 4;
};
std::vector<Cuerpo> grua(const Postura &p) {
    const Mat4 giro = gira({0, 1, 0}, p.giro);
    const double cable = 9.5 - p.altura;
    return {
        {caja(traslada({0, -0.15, 0}) * escala({10.5, 0.3, 10.5})), exacto(SUELO)},
        {caja(traslada({0, 5, 0}) * escala({0.8, 10, 0.8})), exacto(AMARILLO)},
        {caja(giro * traslada({2.5, 10.4, 0}) * escala({10, 0.8, 0.8})), exacto(AMARILLO)},
        {caja(giro * traslada({-1.8, 9.3, 0}) * escala(1.4)), exacto(GRIS)},
        {caja(giro * traslada({p.distancia, 10 - cable / 2, 0}) * escala({0.12, cable, 0.12})),
         exacto(OSCURO)},
        {caja(giro * traslada({p.distancia, p.altura, 0})), exacto(ROJO)},
    };
}

/// Sus esquinas en 24 giros × 8 distancias × 9 alturas, con los extremos del recorrido: 1728 posturas.
std::vector<glm::dvec3> esquinasDeTodasLasPosturas() {
    std::vector<glm::dvec3> esquinas;
    for (int g = 0; g < 24; ++g)
        for (int d = 0; d < 8; ++d)
            for (int h = 0; h < 9; ++h)
                for (const Cuerpo &c : grua({g * PI / 12, 1.4 + d * 5.6 / 7, 0.5 + h * 8.5 / 8}))
                    for (int k = 0; k < 8; ++k) {
                        const Vec3 p = punto(c.objeto.M, {(k & 1) - 0.5, (k >> 1 & 1) - 0.5, (k >> 2) - 0.5});
                        esquinas.emplace_back(p.x, p.y, p.z);
                    }
    return esquinas;
}

/// Donde va la grúa en un panel: encima, una novena parte es para el rótulo.
Hueco sinRotulo(const Hueco &h) {
    return {h.x, h.y, h.ancho, h.alto - h.alto / 9};
}

/// La envolvente del programa: que encierra todas las posturas, sin que sobre, lo comprueba Encuadre.
const std::vector<glm::dvec3> &envolvente() {
    static const std::vector<glm::dvec3> puntos = envolventeGrua();
    return puntos;
}

/// La cámara de una vista en un hueco. `escala`: la común de varias vistas, en unidades por píxel. Está centrada en X.
Camara camaraDe(int vista, bool enPerspectiva, const Hueco &h, double distancia = 42, double escala = 0) {
    const Vec3 centro{0, 4.7, 0}, hacia[] = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, unitario(Vec3{1, 1, 1})},
                                  arriba = vista == PLANTA ? Vec3{0, 0, -1} : Vec3{0, 1, 0};
    Camara c = miraDesde(centro + distancia * hacia[vista], centro, arriba);
    double x = 0, desdeY = INFINITO, hastaY = -INFINITO, tangente = 0;
    const double lado = altoUtil(h.ancho, h.alto);
    for (const glm::dvec3 &p : envolvente()) {
        const Vec3 q = enCamara(c, exacto(p));
        x = std::max(x, std::fabs(q.x));
        desdeY = std::min(desdeY, q.y);
        hastaY = std::max(hastaY, q.y);
        tangente = std::max({tangente, std::fabs(q.y / q.z) / h.alto, std::fabs(q.x / q.z) / h.ancho});
    }
    if (enPerspectiva)
        return perspectiva(c, 2 * std::atan(1.06 * lado * tangente), 1, 1000);
    const Vec3 descentra = 0.5 * (desdeY + hastaY) * ejes(c).y;
    c.ojo = c.ojo + descentra;
    c.centro = c.centro + descentra;
    escala = std::max({escala, 1.06 * 2 * x / h.ancho, 1.06 * (hastaY - desdeY) / h.alto});
    return paralela(c, 0.5 * lado * escala, -1000, 1000);
}

/// Lo que hay tras un guion, que sigue al anterior.
struct Estado {
    std::string guion;
    int vista = DIAGONAL;
    bool enPerspectiva = false;
    Postura postura = {};
    double distancia = 42;
    bool europeo = false, conTest = true;
};

/// Un panel: la grúa o, sin el test de profundidad, el suelo, que se pinta lo último y lo tapa todo.
void compruebaPanel(const Vista &v, const Hueco &h, int vista, const Estado &e, double escala = 0) {
    const Panel panel(camaraDe(vista, e.enPerspectiva, sinRotulo(h), e.distancia, escala), sinRotulo(h));
    const auto esSuelo = [](const Pixel &p) { return p.g > p.r && p.r > p.b; };
    if (e.conTest)
        compruebaEscena(v, panel, grua(e.postura), CIELO);
    else
        compruebaSilueta(v, panel, esSuelo, grua(e.postura)[0].objeto);
}

/// Una vista, o las cuatro a la misma escala: en el sistema americano la planta va sobre el alzado y el perfil derecho
/// a su derecha; en el europeo, la planta debajo y el perfil a su izquierda.
void compruebaEstado(const Estado &e, const Vista &v) {
    const int americano[] = {PLANTA, DIAGONAL, ALZADO, PERFIL}, // por filas
        europeo[] = {PERFIL, ALZADO, DIAGONAL, PLANTA}, *orden = e.europeo ? europeo : americano;
    const int lado = e.vista == LAS_CUATRO ? 2 : 1;
    const auto vista = [&](int k) { return lado == 1 ? e.vista : orden[k]; };
    const auto panel = [&](int k) { return Panel({}, v.escena, k, lado * lado, lado).hueco; };
    double escala = 0;
    for (int k = 0; k < lado * lado; ++k) {
        const Hueco h = sinRotulo(panel(k));
        escala = std::max(escala, 2 * camaraDe(vista(k), false, h).semilado / altoUtil(h.ancho, h.alto));
    }
    for (int k = 0; k < lado * lado; ++k)
        compruebaPanel(v, panel(k), vista(k), e, escala);
}

} // namespace

// En cada vista la envolvente encierra todas las posturas, y le sobra poco: el 0.12 % del polígono de 64 lados
// circunscrito y el 1 − cos(π/24) = 0.86 % de lo que hay entre dos giros.
TEST(Encuadre, TodaPosturaEntera) {
    const std::vector<glm::dvec3> todas = esquinasDeTodasLasPosturas();
    for (const VistaGrua &v : VISTAS) {
        const Caja caja = cajaEnCamara(envolvente(), camaraVista(v)),
                   suya = cajaEnCamara(todas, camaraVista(v));
        for (int k = 0; k < 3; ++k) {
            EXPECT_LE(suya.maximo[k], caja.maximo[k] + 1e-5) << v.nombre;
            EXPECT_GE(suya.minimo[k], caja.minimo[k] - 1e-5) << v.nombre;
            EXPECT_GE(suya.maximo[k] - suya.minimo[k], 0.99 * (caja.maximo[k] - caja.minimo[k])) << v.nombre;
        }
    }
}

// Cada vista, con su tecla y con su opción del menú; las cuatro, en paneles de ancho par: el canto del pie no cae en
// centros de píxel; y la postura extrema, girada, en una ventana apaisada y en otra alta.
TEST(GruaVistas, CadaVistaContraTrazadoDeRayos) {
    const Postura extrema = {0.58 + 0.7, 7, 9};
    const Estado casos[] = {
        {"tecla 1", ALZADO},
        {"tecla 2", PLANTA},
        {"tecla 3", PERFIL},
        {"tecla 4"},
        {"menu Alzado", ALZADO},
        {"menu Planta", PLANTA},
        {"menu Perfil", PERFIL},
        {"menu (1,1,1)"},
        {"tamano 482 360; menu Las cuatro", LAS_CUATRO, false, {}, 42, true},
        {"tecla u", LAS_CUATRO},
        {"menu Europeo o americano; tecla 2; tecla 0", LAS_CUATRO, false, {}, 42, true},
        {"tamano 300 70; tecla a ×7; tecla e ×6; tecla w ×12; tecla 4", DIAGONAL, false, extrema},
        {"tamano 70 200", DIAGONAL, false, extrema},
    };
    paraCada("grua_vistas", casos, 240, 180, compruebaEstado);
}

// Las dos proyecciones con la MISMA cámara, que camaraDe construye igual. Al acercarla, en paralela no cambia nada; en
// perspectiva la grúa sigue entera, hasta los topes de la rueda.
TEST(GruaProyeccion, LasDosContraTrazadoDeRayos) {
    const Estado casos[] = {
        {""},
        {"tecla p", DIAGONAL, true},
        {"tecla 1", ALZADO, true},
        {"tecla 2", PLANTA, true},
        {"tecla 3", PERFIL, true},
        {"tamano 482 360; tecla 0; tecla u", LAS_CUATRO, true, {}, 42, true},
        {"menu Paralela o perspectiva; tecla u", LAS_CUATRO},
        {"tamano 240 180; tecla 4; rueda +1 9 9 ×3"},
        {"tecla p", DIAGONAL, true, {}, 42 / std::pow(1.1, 3)},
        {"rueda +1 9 9 ×40", DIAGONAL, true, {}, 0.4 * 42},
        {"rueda -1 9 9 ×40", DIAGONAL, true, {}, 2.5 * 42},
        {"tamano 70 200", DIAGONAL, true, {}, 2.5 * 42},
    };
    paraCada("grua_proyeccion", casos, 240, 180, compruebaEstado);
}

// Con eliminación de partes ocultas, lo que ve el rayo, también con la carga delante y detrás del pie; y sin ella.
TEST(GruaZBuffer, OrdenDeVisibilidadContraTrazadoDeRayos) {
    const Postura delante = {0.58 - 1.4, 1.5, 4}, detras = {0.58 + 1.8, 1.5, 4};
    const Estado casos[] = {
        {"", DIAGONAL, true},
        {"tecla z", DIAGONAL, true, {}, 42, false, false},
        {"menu Con o sin partes ocultas", DIAGONAL, true},
        {"menu Comparar; tecla v; menu Paralela o perspectiva", DIAGONAL, false},
        {"tecla p; tecla q ×7; tecla d ×14", DIAGONAL, true, delante},
        {"tecla a ×32; tecla p", DIAGONAL, false, detras},
        {"tamano 482 360; tecla 0; menu Europeo o americano", LAS_CUATRO, false, detras, 42, true},
        {"tamano 240 180; tecla 4; tecla p; rueda -1 9 9 ×40", DIAGONAL, true, detras, 2.5 * 42},
    };
    paraCada("grua_zbuffer", casos, 240, 180, compruebaEstado);
    // a la izquierda sin el test y a la derecha con él
    const Vista dos = vistaDe("grua_zbuffer", "tecla z; menu Comparar", 640, 360);
    for (const bool conTest : {false, true})
        compruebaPanel(dos, hueco(conTest, 2, 0, 1, 640, 360), DIAGONAL,
                       {"", DIAGONAL, true, {}, 42, false, conTest});
}
