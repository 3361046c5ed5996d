// etapas_pipeline: lo escrito y cada panel, contra el oráculo.
#include "ch04_oraculo.h"
#include "ch04_vista3d/etapas.h"
#include "guiones.h"

namespace {

using namespace oraculo;

enum { OBJETO, MUNDO, CAMARA, NDC, VENTANA, PROFUNDIDAD, PANELES };

/// Los datos de etapas_pipeline, escritos otra vez.
const Mat4 MM = traslada({0.2, 0.8, 0.3}) * gira({0, 1, 0}, -0.35) * escala({2, 1.2, 1.4});
const Vec3 OJO{2.0, 3.4, 5.4}, TRIANGULO[] = {{-0.7, 0.8, -0.5}, {0.9, -0.2, 5}, {1.5, -0.6, -1.4}};
const Camara CAMARA_REF = perspectiva(miraDesde(OJO, {0.1, 0.7, 0}), 0.62, 3, 7.5);

/// Lo que tapa ese punto.
Mat4 tapa(const Vec3 &mundo) {
    return traslada(OJO + 0.79 * (mundo - OJO)) * escala({0.6, 0.5, 0.2});
}

/// Los huecos, en tres columnas y dos filas.
Hueco entero(int k) {
    return hueco(k % 3, 3, k / 3, 2, 480, 360);
}
/// Desde dónde se ve lo que enseña cada panel, y el trozo en que se dibuja: debajo quedan los números.
Panel panel(int k, double delObjeto = 6) {
    const double distancias[] = {delObjeto, 16, 17, 8};
    const Vec3 centros[] = {{0, 0.2, 0}, {0.6, 1.3, 1.4}, {0, 0, -3.7}, {}};
    const Hueco h = entero(k), escena = {h.x, h.y + 7 * h.alto / 20, h.ancho, h.alto - 7 * h.alto / 20};
    if (k >= VENTANA)
        return {CAMARA_REF, escena};
    return {perspectiva(orbita(0.95, 0.35, distancias[k], centros[k]), 0.5, 0.5, 100), escena};
}

/// Coordenadas de ventana y normalizadas.
Vec3 enVentana(const Vec3 &mundo) {
    const Panel ventana = panel(VENTANA);
    const glm::dvec2 v = ventana(mundo);
    return {v.x, v.y, proyecta(CAMARA_REF, ventana.hueco.ancho, ventana.hueco.alto, mundo).z};
}
Vec3 enNdc(const Vec3 &mundo) {
    const Hueco h = panel(VENTANA).hueco;
    const Vec3 v = enVentana(mundo);
    return {2 * (v.x - h.x) / h.ancho - 1, 2 * (v.y - h.y) / h.alto - 1, 2 * v.z - 1};
}

/// Las coordenadas que enseña el panel k, y dónde se ven. Las normalizadas son a izquierdas.
Vec3 coordenadas(int k, const Vec3 &mundo) {
    if (k == OBJETO)
        return punto(inversa(MM), mundo);
    if (k == CAMARA)
        return enCamara(CAMARA_REF, mundo);
    const Vec3 n = enNdc(mundo);
    return k == NDC ? Vec3{n.x, n.y, -n.z} : mundo;
}
glm::dvec2 enPanel(int k, const Vec3 &mundo) {
    return panel(k)(coordenadas(k, mundo));
}

/// Un cubo del mundo en las coordenadas del panel k, con la luz del mundo.
Cuerpo cuboEn(int k, const Mat4 &M, const glm::vec3 &color) {
    const Objeto enMundo = enElMundo(M, cubo());
    std::vector<VerticeRef> vertices = enMundo.triangulos->vertices;
    for (VerticeRef &v : vertices)
        v.posicion = coordenadas(k, v.posicion);
    return {malla(Mat4(), vertices, enMundo.triangulos->indices), exacto(color)};
}

Vec3 esquinaCubo(int k) {
    return {k & 1 ? 0.5 : -0.5, k & 2 ? 0.5 : -0.5, k & 4 ? 0.5 : -0.5};
}
/// Elegir con el ratón lo que está ahí, dado desde abajo.
std::string elige(const glm::dvec2 &p) {
    return clic({int(p.x), 359 - int(p.y)});
}

/// Lo que hay guardado en el píxel de una esquina del cubo: la profundidad de lo primero que encuentra su rayo, sin
/// ella.
double guardada(const Vec3 &mundo, bool tapado) {
    const Escena cajas = tapado ? Escena{caja(MM), caja(tapa(mundo))} : Escena{caja(MM)};
    for (const Impacto &i : impactos(cajas, {OJO, unitario(mundo - OJO)}))
        if (longitud(i.punto - mundo) >= 1e-4)
            return enVentana(i.punto).z;
    return 1;
}

/// Lo que ha escrito del último vértice, por claves.
using Escrito = std::map<std::string, std::vector<double>>;
Escrito loEscritoTras(const std::string &guion) {
    const std::string salida = ejecuta("etapas_pipeline", guion, 480, 360).salida;
    std::istringstream texto(salida.substr(salida.rfind("vértice:")));
    Escrito valores;
    for (std::string linea; std::getline(texto, linea);) {
        const std::size_t fin = linea.find(':');
        std::vector<double> &v = valores[linea.substr(0, fin)];
        std::istringstream numeros(fin == std::string::npos ? "" : linea.substr(fin + 1));
        for (double n; numeros >> n;)
            v.push_back(n);
    }
    return valores;
}

/// Lo que escribe de una esquina del cubo en cada etapa. La matriz del modelo se hace en float: 4 redondeos de números
/// menores que 2, 5e-7 en el mundo, y en la ventana por 1/tan(0.31)/4 y por 58 píxeles, 5e-5.
void compruebaEsquina(const std::string &guion, int esquina, bool tapado = false) {
    SCOPED_TRACE(guion);
    const Vec3 objeto = esquinaCubo(esquina), mundo = punto(MM, objeto), c = enCamara(CAMARA_REF, mundo),
               n = enNdc(mundo), v = enVentana(mundo);
    const double laGuardada = guardada(mundo, tapado);
    const struct {
        std::string clave;
        std::vector<double> valores;
        double cota;
    } esperado[] = {{"objeto", {objeto.x, objeto.y, objeto.z, 1}, 0},
                    {"mundo", {mundo.x, mundo.y, mundo.z, 1}, 1e-6},
                    {"cámara", {c.x, c.y, c.z, 1}, 1e-6},
                    {"recortado", {-c.z * n.x, -c.z * n.y, -c.z * n.z, -c.z}, 1e-5},
                    {"NDC", {n.x, n.y, n.z}, 2e-6},
                    {"ventana", {v.x, v.y}, 1e-4},
                    {"píxel", {std::floor(v.x), std::floor(v.y)}, 0},
                    {"profundidad", {v.z}, 2e-6},
                    {"guardada", {laGuardada}, 1e-5},
                    {v.z < laGuardada ? "se pinta" : "se descarta", {}, 0}};
    Escrito escrito = loEscritoTras(guion);
    EXPECT_EQ(escrito.size(), 1 + std::size(esperado)); // y «vértice»
    for (const auto &[clave, valores, cota] : esperado) {
        ASSERT_TRUE(escrito.count(clave) && escrito[clave].size() == valores.size()) << clave;
        for (std::size_t i = 0; i < valores.size(); ++i)
            EXPECT_NEAR(escrito[clave][i], valores[i], cota) << clave << " " << i;
    }
}

} // namespace

// La que se sigue al empezar y las que se eligen con el ratón, en cualquier panel; lejos de todo vértice y al orbitar
// no cambia nada. Con algo delante, lo guardado es su profundidad y el fragmento se descarta. En cada panel, la escena
// trazada en sus coordenadas: el vértice que se ve es el que se escribe (la 4.4 impresa lo aparta medio píxel).
TEST(EtapasPipeline, EsquinasDelCubo) {
    const auto en = [](int k, int esquina) { return elige(enPanel(k, punto(MM, esquinaCubo(esquina)))); };
    for (const int esquina : {0, 3, 5, 6})
        compruebaEsquina(en(VENTANA, esquina), esquina);
    for (const int k : {OBJETO, MUNDO, CAMARA, NDC})
        compruebaEsquina(en(k, 3), 3);
    const Hueco h = panel(OBJETO).hueco;
    compruebaEsquina(elige({h.x + 0.1 * h.ancho, h.y + 0.5 * h.alto}) + "; tecla r ×2", 7);
    compruebaEsquina(en(VENTANA, 3) + "; tecla o", 3, true);
    EXPECT_EQ(ejecuta("etapas_pipeline", arrastra({330, 349}, {380, 320}), 480, 360).salida,
              ejecuta("etapas_pipeline", "", 480, 360).salida);
    for (const bool tapado : {false, true})
        for (int k = OBJETO; k < PROFUNDIDAD; ++k) {
            std::vector<Cuerpo> cuerpos = {cuboEn(k, MM, AMARILLO)};
            if (tapado && k != OBJETO)
                cuerpos.push_back(cuboEn(k, tapa(punto(MM, esquinaCubo(7))), VERDE));
            compruebaEscena(vistaDe("etapas_pipeline", tapado ? "tecla o" : "", 480, 360), panel(k), cuerpos,
                            k == VENTANA ? CIELO : FONDO_CLARO);
        }
}

// Cada cara del volumen deja fuera lo que está al otro lado: también la de cerca.
TEST(EtapasPipeline, CadaCaraDelVolumen) {
    for (int eje = 0; eje < 3; ++eje)
        for (const double lado : {-1.0, 1.0}) {
            glm::dvec4 r(0.1, 0.2, 0.3, 2);
            r[eje] = lado * 1.9;
            EXPECT_TRUE(estaDentro(r)) << eje << " " << lado;
            r[eje] = lado * 2.1;
            EXPECT_FALSE(estaDentro(r)) << eje << " " << lado;
        }
}

// El triángulo llega detrás del ojo, y el volumen lo deja en un hexágono. En el mundo, gris lo que queda fuera; en la
// ventana, lo que recorta la GPU por su cuenta, y el área de lo que se escribe es la que se ve, un píxel más o menos en
// cada fila.
TEST(EtapasPipeline, Recortado) {
    Escrito escrito = loEscritoTras("tecla r");
    EXPECT_EQ(escrito["vértice"], std::vector<double>{0}); // el que se sigue al empezar
    EXPECT_EQ(escrito["lados"], std::vector<double>{6});
    const Vista vista = vistaDe("etapas_pipeline", "tecla r", 480, 360);
    const Escena enMundo = {
        triangulo(punto(MM, TRIANGULO[0]), punto(MM, TRIANGULO[1]), punto(MM, TRIANGULO[2]))};
    const Hueco h = panel(VENTANA).hueco;
    for (const int k : {MUNDO, VENTANA}) {
        const auto tono = [&](const Impacto &i) {
            if (!i)
                return Tono(exacto(k == VENTANA ? CIELO : FONDO_CLARO));
            const bool dentro = dentroDelVolumen(i.punto, panel(VENTANA));
            return Tono(luzFija({0, 1, 0}) * (dentro ? exacto(AMARILLO) : deFuera(exacto(AMARILLO))), dentro);
        };
        comprueba("panel " + std::to_string(k + 1),
                  compara(recorta(vista.escena, panel(k)), enMundo, panel(k).camara, tono), EXACTA);
        const ImagenRef ref = render(enMundo, panel(k), tono);
        const auto dentro = std::count_if(ref.pixeles.begin(), ref.pixeles.end(),
                                          [](const PixelRef &p) { return p.zona == 1; });
        EXPECT_TRUE(k == MUNDO || std::fabs(escrito["área en píxeles"].at(0) - double(dentro)) < h.alto)
            << dentro;
    }

    // también en el triángulo, lo que tapa está delante del vértice
    EXPECT_EQ(loEscritoTras("tecla r; tecla o").count("se descarta"), 1u);

    // un vértice de fuera del volumen llega hasta las coordenadas de recortado, y ahí se acaba
    std::string claves;
    for (const auto &[clave, valores] : loEscritoTras("tecla r; " + elige(panel(OBJETO, 14)(TRIANGULO[2]))))
        claves += clave + ", ";
    EXPECT_EQ(claves, "cámara, fuera, lados, mundo, objeto, recortado, vértice, área en píxeles, ");
}
