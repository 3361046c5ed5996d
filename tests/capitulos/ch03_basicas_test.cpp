// basicas, escalado, tres_cubos, cono, elipsoide y orden (capítulo 3): cada píxel de la escena. La
// geometría esperada sale del enunciado; de los programas solo se repiten los datos: dónde está la cámara, de qué color
// es cada cosa y qué elige cada uno donde falta la figura del libro.
#include "colores.h"
#include "guiones.h"
#include "panel.h"
#include "tabla.h"

using glm::dvec3;

namespace {

using namespace oraculo;

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
Panel ventana(const Vista &v, const Encuadre &e, const Mirada &mirada = {}) {
    return {perspectiva(orbita(e.azimut + mirada.azimut, 0.35 + mirada.elevacion, e.distancia, e.centro), 0.5,
                        1, 100),
            v.escena};
}

// --- La F de basicas y escalado ---

/// Un factor cero no tiene inversa, y con uno tan pequeño se ve lo mismo.
const double APLASTADO = 1e-6;

/// El palo y los dos brazos, transformados. El corto acaba en bisel, 0.1 en 0.35; su otro lado está dentro del palo.
Escena efe(const Mat4 &M) {
    const Mat4 inclina{{{1, -0.1 / 0.35, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    return {caja(M * traslada({0.35, 0.9, 0}) * escala({0.4, 1.5, 0.5})), // centro y lados
            caja(M * traslada({0.925, 1.475, 0}) * escala({0.75, 0.35, 0.5})),
            caja(M * traslada({0.775, 0.875, 0}) * inclina * escala({0.55, 0.35, 0.5}))};
}

// --- basicas ---

/// T y S a lo largo de X, o el giro en grados alrededor de ese eje.
Mat4 basica(char cual, double valor) {
    switch (cual) {
    case 'T': return traslada({valor, 0, 0});
    case 'S': return escala({valor, 1, 1});
    default: return gira(cual == 'X' ? X : cual == 'Y' ? Y : Z, valor * PI / 180);
    }
}

// La F transformada por la ecuación, en cada píxel.
TEST(ProgramaBasicas, LaFEstaDondeDicenLasEcuaciones) {
    const struct {
        std::string guion;
        char cual;
        double valor;
    } casos[] = {
        {"", 'T', 1.5},
        {"tecla + ×4", 'T', 2}, // el tope
        {"tecla - ×20", 'T', -2},
        {"tecla 2", 'S', 1.5},
        {"tecla - ×6", 'S', APLASTADO},
        {"tecla - ×20", 'S', -2},
        {"tecla 3; tecla + ×2", 'X', 90},
        {"tecla 4; tecla - ×8", 'Y', -60},
        {"tecla 5", 'Z', 60},
        {"tecla + ×30", 'Z', 90},
    };
    paraCada("basicas", casos, 240, 180, [](const auto &caso, const Vista &v) {
        std::vector<Cuerpo> cuerpos;
        for (const Objeto &caja : efe(basica(caso.cual, caso.valor)))
            cuerpos.push_back({caja, ANARANJADO});
        compruebaEscena(v, ventana(v, {0.55, 9, {0.3, -0.05, 0}}), cuerpos, FONDO_CLARO);
    });
}

// --- escalado ---

// Un factor negativo pone los vértices de una cara en el sentido contrario, y dos los dejan como estaban: con
// determinante negativo se ve el lado de dentro, morado, pero siempre con la luz de la normal que sale del objeto. De
// frente y por detrás, y con los paneles en tres columnas y en dos; en los últimos, estrechos, se ve más a lo alto.
TEST(Escalado, CarasYDeterminanteEnCadaVista) {
    const dvec3 escalados[] = {{2, 2, 2},  {2, 0.5, 1}, {1, 1, APLASTADO},
                               {-1, 1, 1}, {-1, -1, 1}, {0.5, 0.5, 0.5}};
    const struct {
        std::string guion;
        double azimut;
        int columnas;
    } vistas[] = {{"", 0.55, 3},
                  {arrastra({470, 10}, {-130, 10}), 3.55, 3},
                  {"tamano 300 480", 3.55, 2},
                  {"tamano 480 400", 3.55, 3}};
    paraCada("escalado", vistas, 480, 360, [&](const auto &vista, const Vista &v) {
        for (int i = 0; i < 6; ++i) {
            const dvec3 &s = escalados[i], minimo(0.15, 0.15, -0.25), maximo(1.30, 1.65, 0.25),
                        desde = glm::min(minimo, glm::min(s * minimo, s * maximo)),
                        hasta = glm::max(maximo, glm::max(s * minimo, s * maximo)),
                        centro = 0.5 * (desde + hasta) - dvec3(0, 0.45, 0);
            const Panel panel({}, v.escena, i, 6, vista.columnas);
            const auto &[x, y, ancho, alto] = panel.hueco;
            const double semialto = 0.236 * std::max(0.92 * alto / ancho, 1.0), // a distancia 1
                semilado = semialto * altoUtil(ancho, alto) / alto;
            const bool espejo = s.x * s.y * s.z < 0;
            comprueba("el panel " + std::to_string(i),
                      compara(
                          recorta(v.escena, panel), efe(escala(exacto(s))),
                          perspectiva(orbita(vista.azimut, 0.25, 10, exacto(centro)), 2 * std::atan(semilado),
                                      1, 100),
                          [&](const Impacto &impacto) {
                              const Vec3 &color = impacto.frente == espejo ? MORADUZCO : AMARILLENTO;
                              return impacto ? luzFija(impacto.normal) * color : FONDO;
                          },
                          1),
                      EXACTA);
        }
    });
}

// --- tres_cubos ---

// Cada centro sube medio lado del anterior más medio del suyo.
TEST(TresCubos, ImagenContraTrazadoDeRayos) {
    const std::vector<Cuerpo> cubos = {{caja(Mat4()), GRISACEO},
                                       {caja(traslada({0, 0.75, 0}) * escala(0.5)), ANARANJADO},
                                       {caja(traslada({0, 1.125, 0}) * escala(0.25)), AMARILLENTO}};
    paraCada("tres_cubos", MIRADAS, 240, 180, [&](const Mirada &mirada, const Vista &v) {
        compruebaEscena(v, ventana(v, {0.55, 5.6, {0.15, 0.38, 0}}, mirada), cubos, FONDO_CLARO);
    });
}

// --- cono y elipsoide ---

/// Segmentos con que una circunferencia de `radioPx` se separa `tolerPx` de su polígono.
int segmentos(double radioPx, double tolerPx) {
    return int(std::ceil(PI / std::acos(1 - tolerPx / radioPx)));
}
/// Las mallas se separan del sólido menos de medio píxel en una ventana de 1080 líneas, así que 1/12 en una de 180, más
/// la rejilla de los vértices; el desvío se busca en círculos cada vez √2 veces mayores.
const double DESVIO_DEL_SOLIDO = std::sqrt(2.0) * (1.0 / 12 + 1.0 / 256);

/// El sólido exacto, solo su silueta, y la misma malla, cada píxel.
void compruebaSolidos(const Imagen &escena, const Escena &exactos, const std::vector<Cuerpo> &mallas,
                      const Camara &camara) {
    comprueba("silueta", comparaSilueta(escena, FONDO, exactos, camara), {0, 0, DESVIO_DEL_SOLIDO});
    comprueba("malla", comparaConLuzFija(escena, mallas, camara, FONDO), EXACTA);
}

struct Solido {
    Objeto (*exacto)(const Mat4 &);
    Malla malla;
};

/// Un programa que aplica sus transformaciones una a una.
void compruebaPasos(const std::string &programa, const Encuadre &encuadre, const Solido &solido,
                    const std::vector<Mat4> &pasos) {
    for (const Mirada &mirada : MIRADAS) {
        std::vector<std::string> guiones(pasos.size() + 1, "tecla t");
        guiones[0] = mirada.guion;
        Mat4 M;
        std::size_t paso = 0;
        for (const Vista &v : vistasDe(programa, guiones)) {
            SCOPED_TRACE(programa + ", paso " + std::to_string(paso));
            compruebaSolidos(v.escena, {solido.exacto(M)}, {{malla(M, solido.malla), ANARANJADO}},
                             ventana(v, encuadre, mirada).camara);
            if (paso < pasos.size())
                M = pasos[paso++] * M;
        }
    }
}

TEST(Cono, SiluetaDeCadaPaso) {
    const auto fino = [](const Mat4 &M) { return malla(M, cono(2000)); };
    compruebaPasos("cono", {0.6, 9, {1.15, -0.1, 0}}, {fino, porCaras(cono(segmentos(300, 0.5)))},
                   {traslada({0, 0, -1}), escala({1, 1, 3}), gira(Y, -PI / 2)});
}

TEST(Elipsoide, SiluetaDeCadaPaso) {
    compruebaPasos("elipsoide", {-0.5, 15.5, {0.9, 1.3, 0.8}}, {esfera, esfera(segmentos(525, 0.25))},
                   {escala({0.5, 0.5, 3}), traslada({0, 0, 3}), gira(X, -std::asin(std::sqrt(1 / 3.0))),
                    gira(Y, PI / 4)});
}

// --- orden ---

// En cada panel, la esfera transformada y la inicial.
TEST(Orden, DiscosEnLaImagen) {
    const Mat4 T = traslada({5, 0, 0}), S = escala(5);
    const Malla bola = esfera(segmentos(200, 0.25));
    paraCada("orden", MIRADAS, 240, 180, [&](const Mirada &mirada, const Vista &v) {
        for (int fila = 0; fila < 2; ++fila) {
            const Panel panel({}, v.escena, fila, 2, 1);
            const auto &[x, y, ancho, alto] = panel.hueco;
            // 42 unidades a lo ancho y al menos 3/8 de ellas a lo alto
            const double semialto = 21 * std::max(double(alto) / ancho, 3 / 8.0);
            const Mat4 M = fila == 0 ? T * S : S * T;
            compruebaSolidos(recorta(v.escena, panel), {esfera(M), esfera(Mat4())},
                             {{malla(M, bola), ANARANJADO}, {malla(Mat4(), bola), GRISACEO}},
                             paralela(orbita(mirada.azimut, 0.3 + mirada.elevacion, 21, {13.8, -1.4, 0}),
                                      semialto * altoUtil(ancho, alto) / alto, -100, 200));
        }
    });
}

} // namespace
