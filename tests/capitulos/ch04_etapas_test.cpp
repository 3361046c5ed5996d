// etapas_pipeline: el recortado contra el polígono exacto; lo que escribe y lo que enseña en cada panel, contra el oráculo.
#include "azar.h"
#include "ch04_oraculo.h"
#include "ch04_vista3d/etapas.h"
#include "guiones.h"
#include <map>
#include <sstream>

namespace {

using namespace oraculo;
using Largo = long double; // con 11 bits más que double, sus redondeos no cuentan
using Vec3Largo = glm::vec<3, Largo>;

/// El polígono exacto de un triángulo recortado, dividido por w. Un punto del triángulo es a + s·(b − a) + t·(c − a), y tanto las
/// tres condiciones de estar en él como las seis del volumen son semiplanos p + q·s + r·t ≥ 0: los vértices son los cortes de sus
/// rectas, de dos en dos, que cumplen los demás. En orden alrededor de su centro.
Poligono poligonoExacto(const std::vector<glm::dvec4> &triangulo) {
    const glm::vec<4, Largo> a = triangulo[0], ab = glm::vec<4, Largo>(triangulo[1]) - a,
                             ac = glm::vec<4, Largo>(triangulo[2]) - a;
    std::vector<Vec3Largo> semiplanos = {{0, 1, 0}, {0, 0, 1}, {1, -1, -1}};
    for (int eje = 0; eje < 3; ++eje)
        for (const int signo : {-1, 1})
            semiplanos.push_back({a.w + signo * a[eje], ab.w + signo * ab[eje], ac.w + signo * ac[eje]});
    std::vector<Vec3Largo> cortes; // (1, s, t)
    Vec3Largo centro(0);
    for (std::size_t i = 0; i < semiplanos.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const Vec3Largo corte =
                glm::cross(semiplanos[i], semiplanos[j]) / glm::cross(semiplanos[i], semiplanos[j]).x;
            bool cumple = true;
            for (std::size_t k = 0; k < semiplanos.size(); ++k)
                cumple = cumple && (k == i || k == j || glm::dot(semiplanos[k], corte) >= 0);
            if (cumple)
                cortes.push_back(corte);
        }
    for (const Vec3Largo &c : cortes)
        centro += c / Largo(cortes.size());
    std::sort(cortes.begin(), cortes.end(), [&](const Vec3Largo &u, const Vec3Largo &v) {
        return std::atan2(u.z - centro.z, u.y - centro.y) < std::atan2(v.z - centro.z, v.y - centro.y);
    });
    Poligono poligono;
    for (const Vec3Largo &c : cortes) {
        const glm::vec<4, Largo> v = a + c.y * ab + c.z * ac;
        poligono.push_back({double(v.x / v.w), double(v.y / v.w)});
    }
    return poligono;
}

} // namespace

// Triángulos al azar delante, detrás y a los lados del ojo. Con cerca = 1, w ≥ 1 en lo que queda y las
// coordenadas no pasan de 40: cada corte pierde unos 4 redondeos de 40 y son seis, 1e-13 por vértice; el área,
// con un perímetro de 8, menos de 1e-12.
TEST(Recortado, AreaContraElPoligonoExacto) {
    Azar azar(45);
    std::map<std::size_t, int> lados;
    for (int n = 0; n < 150; ++n) {
        std::vector<glm::dvec4> triangulo;
        for (int k = 0; k < 3; ++k) { // perspectiva de 90 grados, cerca 1 y lejos 10
            const double x = azar.entre(-8.0, 8.0), y = azar.entre(-8.0, 8.0), d = azar.entre(-5.0, 13.0);
            triangulo.push_back({x, y, (11 * d - 20) / 9, d});
        }
        const std::vector<glm::dvec4> poligono = recorta(triangulo);
        const Poligono exacto = poligonoExacto(triangulo);
        ASSERT_EQ(poligono.size(), exacto.size()) << n;
        ++lados[poligono.size()];
        EXPECT_NEAR(areaVentana(poligono, glm::dmat4(1)), std::fabs(area(exacto)), 1e-12) << n;
        for (const glm::dvec4 &v : poligono) {
            EXPECT_GE(v.w, 1 - 1e-13);
            EXPECT_LE(std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}), v.w + 1e-12);
        }
    }
    EXPECT_GT(lados[0], 5);
    EXPECT_GT(lados[5] + lados[6] + lados[7], 10);
}

// A un lado y otro de cada uno de los seis planos, y con w negativo.
TEST(Recortado, DentroYFueraDeCadaPlano) {
    for (int eje = 0; eje < 3; ++eje)
        for (const double signo : {-1.0, 1.0}) {
            glm::dvec4 r(0, 0, 0, 2);
            r[eje] = signo * 2;
            EXPECT_TRUE(estaDentro(r)) << eje << " " << signo;
            r[eje] = signo * 2.001;
            EXPECT_FALSE(estaDentro(r)) << eje << " " << signo;
            EXPECT_FALSE(estaDentro(-r)) << eje << " " << signo;
        }
}

TEST(Recortado, CasosLimite) {
    using Vertices = std::vector<glm::dvec4>;
    const Vertices dentro = {{0, 0, 0, 1}, {1, -1, 1, 1}, {-2, 2, 0, 2}}, // dos, en el borde: están dentro
        detrasDelOjo = {{0, 0, 0, -1}, {0.5, 0, 0, -1}, {0, 0.5, 0, -2}},
                   aUnLado = {{3, 0, 0, 1}, {3, 1, 0, 1}, {4, 0, 0, 1}},
                   alrededorDeTodo = {{-9, -9, 0, 1}, {9, -9, 0, 1}, {0, 9, 0, 1}},
                   porElOjo = {{0, 0, 1, 3}, {2, 0, -5, -3}, {-1, 2, -5, -3}}; // w de un signo y de otro
    EXPECT_EQ(recorta(dentro), dentro);
    EXPECT_TRUE(recorta(detrasDelOjo).empty());
    EXPECT_TRUE(recorta(aUnLado).empty());
    EXPECT_NEAR(areaVentana(recorta(alrededorDeTodo), glm::dmat4(1)), 4, 1e-15);
    for (const glm::dvec4 &v : recorta(porElOjo)) {
        EXPECT_GT(v.w, 0);
        EXPECT_TRUE(std::isfinite(divide(v).x));
    }
}

// --- El programa -------------------------------------------------------------------------------------------

namespace {

enum { OBJETO, MUNDO, CAMARA, NDC, VENTANA, PROFUNDIDAD, PANELES };
const int ANCHO = 480, ALTO = 360;

/// Los datos de etapas_pipeline, escritos otra vez.
const Mat4 MM = traslada({0.2, 0.8, 0.3}) * gira({0, 1, 0}, -0.35) * escala({2, 1.2, 1.4}),
           TAPA = traslada({1.13, 1.82, 2.16}) * escala({0.6, 0.5, 0.2});
const double CERCA = 3, LEJOS = 7.5;
const Vec3 OJO{2.0, 3.4, 5.4}, TRIANGULO[] = {{-0.7, 0.8, -0.5}, {0.9, -0.2, 5}, {1.5, -0.6, -1.4}};
const Camara CAMARA_REF = perspectiva(miraDesde(OJO, {0.1, 0.7, 0}), 0.62, CERCA, LEJOS);

/// Los paneles, en tres columnas y dos filas, y dónde dibujan: debajo quedan los números.
Hueco panel(int k) {
    return hueco(k % 3, 3, k / 3, 2, ANCHO, ALTO);
}
Hueco escena(int k) {
    const Hueco h = panel(k);
    const int numeros = 7 * h.alto / 20;
    return {h.x, h.y + numeros, h.ancho, h.alto - numeros};
}

Vec3 enNdc(const Vec3 &mundo) {
    const Hueco h = escena(VENTANA);
    const Vec3 w = proyecta(CAMARA_REF, h.ancho, h.alto, mundo);
    return {2 * w.x / h.ancho - 1, 2 * w.y / h.alto - 1, 2 * w.z - 1};
}

/// Las coordenadas que enseña el panel k, y desde dónde. Las normalizadas son a izquierdas.
Vec3 coordenadas(int k, const Vec3 &mundo) {
    const Vec3 n = enNdc(mundo);
    return k == OBJETO   ? punto(inversa(MM), mundo)
           : k == CAMARA ? enCamara(CAMARA_REF, mundo)
           : k == NDC    ? Vec3{n.x, n.y, -n.z}
                         : mundo;
}
Camara camaraDe(int k, double delObjeto = 6) {
    const Camara desde[] = {orbita(0.95, 0.35, delObjeto, {0, 0.2, 0}),
                            orbita(0.95, 0.35, 16, {0.6, 1.3, 1.4}), orbita(0.95, 0.35, 17, {0, 0, -3.7}),
                            orbita(0.95, 0.35, 8)};
    return k == VENTANA ? CAMARA_REF : perspectiva(desde[k], 0.5, 0.5, 100);
}
glm::dvec2 enPanel(int k, const Vec3 &mundo) {
    return enPanel(camaraDe(k), escena(k), coordenadas(k, mundo));
}

/// Un cubo del mundo en las coordenadas del panel k, con la luz del mundo.
Cuerpo cuboEn(int k, const Mat4 &M, const glm::vec3 &color) {
    const Objeto enMundo = enElMundo(M, cubo());
    std::vector<VerticeRef> vertices = enMundo.triangulos->vertices;
    for (VerticeRef &v : vertices)
        v.posicion = coordenadas(k, v.posicion);
    return {malla(Mat4(), vertices, enMundo.triangulos->indices), exacto(color)};
}

/// Lo que escribe del último vértice: «clave: valores».
std::map<std::string, std::vector<double>> lee(const std::string &salida) {
    std::istringstream texto(salida.substr(salida.rfind("vértice:")));
    std::map<std::string, std::vector<double>> valores;
    for (std::string linea; std::getline(texto, linea);) {
        const std::size_t dosPuntos = linea.find(':');
        std::vector<double> &v = valores[linea.substr(0, dosPuntos)];
        std::istringstream numeros(dosPuntos == std::string::npos ? "" : linea.substr(dosPuntos + 1));
        for (double n; numeros >> n;)
            v.push_back(n);
    }
    return valores;
}

Vec3 esquinaCubo(int k) {
    return {k & 1 ? 0.5 : -0.5, k & 2 ? 0.5 : -0.5, k & 4 ? 0.5 : -0.5};
}

/// Pulsar en un punto dado desde abajo.
std::string pulsa(const glm::dvec2 &p) {
    return clic({int(p.x), ALTO - 1 - int(p.y)});
}

/// Lo que hay guardado en el píxel de una esquina del cubo: la profundidad de lo primero que encuentra el rayo aparte de las caras
/// que la tocan, delante o detrás.
double guardada(const Vec3 &mundo, bool tapado) {
    const Hueco h = escena(VENTANA);
    const Vec3 w = proyecta(CAMARA_REF, h.ancho, h.alto, mundo);
    const Rayo r = rayo(CAMARA_REF, h.ancho, h.alto, w.x, w.y);
    const double distancia = longitud(mundo - r.origen);
    double menor = 1;
    const auto mira = [&](const Mat4 &M, double minimo, double maximo) {
        if (const Impacto i = primerImpacto({caja(M)}, {r.origen, r.direccion, minimo, maximo}))
            menor = std::min(menor, proyecta(CAMARA_REF, h.ancho, h.alto, i.punto).z);
    };
    mira(MM, r.minimo, distancia - 1e-4);
    mira(MM, distancia + 1e-4, r.maximo);
    if (tapado)
        mira(TAPA, r.minimo, r.maximo);
    return menor;
}

std::string conDosDecimales(const std::string &nombre, double v) {
    char numero[32];
    std::snprintf(numero, sizeof numero, "%.2f", v);
    return nombre + (std::string(numero) == "-0.00" ? "0.00" : numero);
}
std::string tres(const std::string &entre, const Vec3 &v) {
    return conDosDecimales("x" + entre, v.x) + "\n" + conDosDecimales("y" + entre, v.y) + "\n" +
           conDosDecimales("z" + entre, v.z);
}

/// El título de cada panel y sus números.
void compruebaNumeros(const Encima &encima, const std::vector<std::string> &numeros) {
    const std::string titulos[] = {"1 objeto",    "2 mundo",   "3 cámara",
                                   "4 recortado", "5 ventana", "6 test de z"};
    for (int k = OBJETO; k < PANELES; ++k) {
        SCOPED_TRACE(titulos[k]);
        const Hueco h = panel(k);
        const double x = h.x + 0.03 * h.ancho;
        compruebaEncima(encima.enPanel(h.x, h.y), ALTO, {},
                        {{titulos[k], {x, h.y + 0.94 * h.alto}, OSCURO, Lado::DERECHA},
                         {numeros[std::size_t(k)], {x, h.y + 0.175 * h.alto}, ROJO, Lado::DERECHA}});
    }
}

/// Una esquina del cubo, de la que el programa escribe y enseña lo que vale en cada etapa. La matriz del modelo se hace en float: 4
/// redondeos de números menores que 2, 5e-7 en el mundo, y en la ventana por 1/tan(0.31)/4 y por 58 píxeles, 5e-5.
struct Esquina {
    Vec3 objeto, mundo, camara, ndc, ventana;
    double guardada;

    Esquina(int k, bool tapado)
        : objeto(esquinaCubo(k)), mundo(punto(MM, objeto)), camara(enCamara(CAMARA_REF, mundo)),
          ndc(enNdc(mundo)), guardada(::guardada(mundo, tapado)) {
        const Hueco h = escena(VENTANA);
        ventana = proyecta(CAMARA_REF, h.ancho, h.alto, mundo) + Vec3{double(h.x), double(h.y), 0};
    }
    bool seVe() const {
        return ventana.z < guardada;
    }

    void compruebaLoEscrito(const std::string &salida) const {
        const double w = -camara.z;
        const struct {
            std::string clave;
            std::vector<double> valores;
            double cota;
        } esperadas[] = {{"objeto", {objeto.x, objeto.y, objeto.z, 1}, 0},
                         {"mundo", {mundo.x, mundo.y, mundo.z, 1}, 1e-6},
                         {"cámara", {camara.x, camara.y, camara.z, 1}, 1e-6},
                         {"recortado", {w * ndc.x, w * ndc.y, w * ndc.z, w}, 1e-5},
                         {"NDC", {ndc.x, ndc.y, ndc.z}, 2e-6},
                         {"ventana", {ventana.x, ventana.y}, 1e-4},
                         {"píxel", {std::floor(ventana.x), std::floor(ventana.y)}, 0},
                         {"profundidad", {ventana.z}, 2e-6},
                         {"guardada", {guardada}, 1e-5},
                         {seVe() ? "se pinta" : "se descarta", {}, 0}};
        auto escritas = lee(salida);
        EXPECT_EQ(escritas.size(), 1 + std::size(esperadas)) << salida; // y «vértice»
        for (const auto &[clave, valores, cota] : esperadas) {
            ASSERT_TRUE(escritas.count(clave)) << clave;
            ASSERT_EQ(escritas[clave].size(), valores.size()) << clave;
            for (std::size_t i = 0; i < valores.size(); ++i)
                EXPECT_NEAR(escritas[clave][i], valores[i], cota) << clave << " " << i;
        }
    }

    void compruebaLoSenalado(const Encima &encima) const {
        const std::string w = conDosDecimales("w ", -camara.z);
        compruebaNumeros(encima,
                         {tres(" ", objeto), tres(" ", mundo), tres(" ", camara), w + "\n" + tres("/w ", ndc),
                          conDosDecimales("x ", ventana.x) + "\n" + conDosDecimales("y ", ventana.y),
                          conDosDecimales("", ventana.z) + conDosDecimales(seVe() ? " < " : " ≥ ", guardada) +
                              (seVe() ? "\nse pinta" : "\nse descarta")});
        // las esquinas del volumen, primero las de cerca, por las de la ventana
        const Hueco v = escena(VENTANA);
        std::vector<Vec3> volumen;
        for (const double d : {CERCA, LEJOS})
            for (const auto &[x, y] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
                const Rayo r = rayo(CAMARA_REF, v.ancho, v.alto, x * v.ancho, y * v.alto);
                volumen.push_back(OJO + d / -escalar(r.direccion, ejes(CAMARA_REF).z) * r.direccion);
            }
        for (int k = OBJETO; k < PROFUNDIDAD; ++k) {
            SCOPED_TRACE("panel " + std::to_string(k + 1));
            const auto en = [k](const Vec3 &p) { return enPanel(k, p); };
            std::vector<Trazo> trazos;
            const auto flecha = [&](const Vec3 &eje, const glm::vec3 &color) {
                const auto enEjes = [&](const Vec3 &p) { return ::enPanel(camaraDe(k), escena(k), p); };
                trazos.push_back({"flecha", color, 6, true, {enEjes({}), enEjes(1.2 * eje)}});
            };
            if (k <= CAMARA) {
                flecha({1, 0, 0}, ROJO);
                flecha({0, 1, 0}, VERDE);
                flecha({0, 0, 1}, AZUL);
            }
            if (k == MUNDO || k == CAMARA || k == NDC) {
                for (std::size_t i = 0; i < 4; ++i)
                    trazos.push_back({"segmentos", OSCURO, 3, true, {en(volumen[i]), en(volumen[i + 4])}});
                for (const auto &[i, color] : {std::pair(0u, NARANJA), {4u, AZUL}})
                    trazos.push_back({"polilinea",
                                      color,
                                      6,
                                      true,
                                      {en(volumen[i]), en(volumen[i + 1]), en(volumen[i + 2]),
                                       en(volumen[i + 3]), en(volumen[i])}});
            }
            if (k == MUNDO || k == CAMARA)
                trazos.push_back({"segmentos", ROJO, 3, true, {en(OJO), en(mundo)}});
            trazos.push_back({"puntos", ROJO, 22, false, {en(mundo)}});
            compruebaEncima(encima.enPanel(escena(k).x, escena(k).y), ALTO, trazos, {});
        }
        // la escala del sexto, de cerca a lejos
        const Hueco h = escena(PROFUNDIDAD);
        const auto enEscala = [&](double z, double y = 0.45) {
            return glm::dvec2(h.x + h.ancho * (0.275 + 0.45 * z), h.y + h.alto * y);
        };
        const glm::dvec2 deGuardada = enEscala(guardada, 0.3);
        compruebaEncima(encima.enPanel(h.x, h.y), ALTO,
                        {{"segmentos", OSCURO, 6, false, {enEscala(0), enEscala(1)}},
                         {"puntos", NARANJA, 18, false, {enEscala(0)}},
                         {"puntos", AZUL, 18, false, {enEscala(1)}},
                         {"flecha", OSCURO, 6, false, {deGuardada, enEscala(guardada)}},
                         {"puntos", ROJO, 22, false, {enEscala(ventana.z)}}},
                        {{"fragmento", enEscala(ventana.z), ROJO, Lado::ENCIMA},
                         {"guardada", deGuardada, OSCURO, Lado::DEBAJO}});
    }
};

} // namespace

// La que se sigue al empezar y las que se eligen con el ratón, en cualquier panel; lejos de todo vértice no cambia nada. Con algo
// delante, lo guardado es su profundidad y el fragmento se descarta. En cada panel, la escena trazada en sus coordenadas: el vértice
// que se ve es el que se escribe (la ecuación 4.4 impresa lo aparta medio píxel).
TEST(EtapasPipeline, EsquinasDelCubo) {
    const auto elige = [](int k, int esquina) { return pulsa(enPanel(k, punto(MM, esquinaCubo(esquina)))); };
    const struct {
        std::string guion;
        int esquina = 7;
        bool tapado = false;
    } casos[] = {{""},
                 {elige(VENTANA, 0), 0},
                 {elige(VENTANA, 3), 3},
                 {elige(VENTANA, 5), 5},
                 {elige(VENTANA, 6), 6},
                 {elige(OBJETO, 3), 3},
                 {elige(MUNDO, 3), 3},
                 {elige(CAMARA, 3), 3},
                 {elige(NDC, 3), 3},
                 {pulsa({330, 10})},
                 {"tecla r; tecla r"},
                 {"tecla o", 7, true},
                 {elige(VENTANA, 3) + "; tecla o", 3, true},
                 {"tecla o; tecla o"}};
    for (const auto &c : casos) {
        SCOPED_TRACE(c.guion);
        const Esquina esquina(c.esquina, c.tapado);
        const auto [imagen, encima] = vistaDe("etapas_pipeline", c.guion, ANCHO, ALTO);
        esquina.compruebaLoEscrito(ejecuta("etapas_pipeline", c.guion, ANCHO, ALTO).salida);
        esquina.compruebaLoSenalado(encima);
        for (int k = OBJETO; k < PROFUNDIDAD; ++k) {
            std::vector<Cuerpo> cuerpos = {cuboEn(k, MM, AMARILLO)};
            if (c.tapado && k != OBJETO)
                cuerpos.push_back(cuboEn(k, TAPA, VERDE));
            comprueba("panel " + std::to_string(k + 1),
                      comparaConLuzFija(recorta(imagen, escena(k)), cuerpos, camaraDe(k),
                                        exacto(k == VENTANA ? CIELO : FONDO_CLARO)),
                      EXACTA);
        }
    }
}

// El triángulo llega detrás del ojo. Los lados y el área de lo que queda, y la línea que lo rodea, contra el polígono exacto; y la
// imagen de la GPU, que recorta por su cuenta, contra el triángulo trazado entre cerca y lejos. En el mundo, gris lo que queda fuera.
TEST(EtapasPipeline, Recortado) {
    const Hueco h = escena(VENTANA);
    const double t = std::tan(0.31) * std::max(1.0, 4.0 * h.alto / (3.0 * h.ancho));
    std::vector<glm::dvec4> triangulo;
    for (const Vec3 &v : TRIANGULO) {
        const Vec3 c = enCamara(CAMARA_REF, punto(MM, v));
        const double d = -c.z;
        triangulo.push_back({c.x / t * h.alto / h.ancho, c.y / t,
                             ((CERCA + LEJOS) * d - 2 * CERCA * LEJOS) / (LEJOS - CERCA), d});
    }
    Poligono poligono;
    std::vector<glm::dvec2> linea;
    for (const Vec2 &v : poligonoExacto(triangulo)) {
        poligono.push_back({h.x + h.ancho * (1 + v.x) / 2, h.y + h.alto * (1 + v.y) / 2});
        linea.push_back({poligono.back().x, poligono.back().y});
    }
    linea.push_back(linea[0]);
    const auto [imagen, encima] = vistaDe("etapas_pipeline", "tecla r", ANCHO, ALTO);
    auto escrito = lee(ejecuta("etapas_pipeline", "tecla r", ANCHO, ALTO).salida);
    EXPECT_EQ(escrito["lados"], std::vector<double>{double(poligono.size())});
    ASSERT_EQ(escrito["área en píxeles"].size(), 1u);
    EXPECT_NEAR(escrito["área en píxeles"][0], std::fabs(area(poligono)),
                0.1); // 1e-4 píxeles por vértice y 500 de perímetro
    const Encima enVentana = encima.enPanel(h.x, h.y).trazos(MORADO);
    compruebaTrazo(enVentana, linea, MORADO);
    double largo = 0;
    for (std::size_t i = 0; i + 1 < linea.size(); ++i)
        largo += glm::distance(linea[i], linea[i + 1]);
    EXPECT_NEAR(enVentana.largo(MORADO), largo, 0.1 * double(linea.size()));
    EXPECT_EQ(encima.trazos(MORADO).size(), 5u); // uno por panel

    const Escena enMundo = {
        oraculo::triangulo(punto(MM, TRIANGULO[0]), punto(MM, TRIANGULO[1]), punto(MM, TRIANGULO[2]))};
    for (const int k : {MUNDO, VENTANA}) {
        const auto tono = [&](const Impacto &i) {
            if (!i)
                return Tono(exacto(k == VENTANA ? CIELO : FONDO_CLARO));
            const Vec3 c = enCamara(CAMARA_REF, i.punto);
            const bool dentro = -c.z >= CERCA && -c.z <= LEJOS && std::fabs(c.y) <= -c.z * t &&
                                std::fabs(c.x) <= -c.z * t * h.ancho / h.alto;
            return Tono(luzFija({0, 1, 0}) * (dentro ? exacto(AMARILLO) : Vec3{0.80, 0.82, 0.84}), dentro);
        };
        comprueba("panel " + std::to_string(k + 1),
                  compara(recorta(imagen, escena(k)), enMundo, camaraDe(k), tono), EXACTA);
    }
}

// Un vértice de fuera del volumen llega hasta las coordenadas de recortado, y ahí se acaba.
TEST(EtapasPipeline, VerticeDeFuera) {
    const std::string guion =
        "tecla r; " + pulsa(enPanel(camaraDe(OBJETO, 14), escena(OBJETO), TRIANGULO[2]));
    const auto escrito = lee(ejecuta("etapas_pipeline", guion, ANCHO, ALTO).salida);
    std::string claves;
    for (const auto &[clave, valores] : escrito)
        claves += clave + " ";
    EXPECT_EQ(claves, "cámara fuera lados mundo objeto recortado vértice área en píxeles ");
    EXPECT_EQ(escrito.at("vértice"), std::vector<double>{2});
    const Vec3 mundo = punto(MM, TRIANGULO[2]), c = enCamara(CAMARA_REF, mundo);
    const Encima encima = vistaDe("etapas_pipeline", guion, ANCHO, ALTO).encima;
    compruebaNumeros(encima, {tres(" ", TRIANGULO[2]), tres(" ", mundo), tres(" ", c),
                              conDosDecimales("w ", -c.z) + "\n" + tres(" ", -c.z * enNdc(mundo)), "no llega",
                              "no llega"});
}
