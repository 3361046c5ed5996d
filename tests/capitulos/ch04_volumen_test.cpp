// El programa volumen_vista contra trazado de rayos: la escena, con su color solo dentro del volumen, y los planos
// cerca y lejos, que tiñen lo que se ve a través de ellos; y los límites de sus teclas.
#include "ch04_oraculo.h"
#include "guiones.h"
#include "tabla.h"

namespace {

using namespace oraculo;

const Vec3 OJO{0, 2.5, 6.5}, INTERES{0, 2.5, 0};
const Hueco VENTANA = {0, 0, 480, 360}; // 4:3, como el volumen

/// El volumen es lo que ve esa cámara en un panel de su forma.
Panel volumen(bool enPerspectiva, double cerca, double lejos, double theta = 0.52, double aspecto = 4.0 / 3) {
    const Hueco h = {0, 0, int(std::lround(360 * aspecto)), 360};
    const Camara c = miraDesde(OJO, INTERES);
    const double estrecho =
        altoUtil(h.ancho, h.alto) / h.alto; // una cámara del oráculo se abre en un panel alto
    return {enPerspectiva ? perspectiva(c, 2 * std::atan(estrecho * std::tan(theta / 2)), cerca, lejos)
                          : paralela(c, estrecho * 1.7 / 0.52 * theta, cerca, lejos),
            h};
}

/// Distancia a la que el rayo cruza el plano que está a `d` de la cámara, entre los lados; infinita si no lo cruza.
double cruza(const Rayo &r, const Panel &v, double d) {
    const double t = (OJO.z - d - r.origen.z) / r.direccion.z;
    return t > 0 && entreLosLados(r.origen + t * r.direccion, v) ? t : INFINITO;
}

/// La escena del programa, escrita otra vez; lo redondo, con las caras que tiene. Lo último, la cámara de fotos.
std::vector<Cuerpo> piezas() {
    const Malla bola = esfera(48), pico = porCaras(cono(48));
    const std::vector<Cuerpo> cuerpos = {
        {caja(traslada({0, -0.1, 0.5}) * escala({8, 0.2, 12})), exacto(SUELO)},
        {enElMundo(traslada({-0.7, 2.5, 2.3}) * escala(0.6), bola), exacto(ROJO)},
        {enElMundo(traslada({1.2, 0, 0.2}) * DE_PIE * escala({0.9, 0.9, 3.8}), pico), exacto(VERDE)},
        {caja(traslada({-2.3, 1.5, -0.4}) * escala({1.4, 3, 1.4})), exacto(AMARILLO)},
        {enElMundo(traslada({0.5, 1.8, -2.7}) * escala(1.5), bola), exacto(MORADO)},
        {caja(traslada({1.9, 0.5, 5.7})), exacto(AZUL)},
        {enElMundo(traslada({-3, 0, 3.2}) * DE_PIE * escala({0.8, 0.8, 2.4}), pico), exacto(NARANJA)}};
    return conCamaraDeFotos(cuerpos, traslada(OJO));
}
const int DE_CAMARA = 7;

/// Lo que el programa dibuja, por cada impacto: la normal se interpola, y el shader del volumen la vuelve a normalizar.
Tono sombrea(const Impacto &i, const std::vector<Cuerpo> &cuerpos, const Panel &v) {
    Vec3 color = exacto(FONDO_CLARO);
    const bool deCamara = i.objeto >= DE_CAMARA, dentro = i && !deCamara && dentroDelVolumen(i.punto, v);
    if (i) {
        const Cuerpo &c = cuerpos[std::size_t(i.objeto)];
        const Vec3 normal = normalInterpolada(c.objeto, i);
        color =
            luzFija(deCamara ? normal : unitario(normal)) * (deCamara || dentro ? c.color : deFuera(c.color));
    }
    const double tope = i ? i.distancia : INFINITO, cerca = cruza(i.rayo, v, v.camara.cerca),
                 lejos = cruza(i.rayo, v, v.camara.lejos);
    const std::map<double, glm::vec3, std::greater<>> deAtrasAdelante = {{cerca, NARANJA}, {lejos, AZUL}};
    for (const auto &[t, tinte] : deAtrasAdelante)
        if (t < tope)
            color = 0.65 * color + 0.35 * exacto(tinte);
    return {color, dentro + 2 * (cerca < tope) + 4 * (lejos < tope)};
}

} // namespace

// Lo que ve la cámara, en un área de dibujo de 4:3, en la que el volumen ancho sale apretado y el estrecho, estirado, y
// en una de su forma. Cada píxel, por el rayo que le toca en el volumen.
TEST(VolumenVista, LoQueVeLaCamaraSeDeformaSiElAreaDeDibujoNoTieneSuForma) {
    const struct {
        std::string guion;
        double aspecto;
    } casos[] = {{"tecla e", 4.0 / 3}, {"tecla d", 5.0 / 3}, {"tecla d", 2}, {"tecla a ×9", 2.0 / 3}};
    std::vector<Cuerpo> cuerpos = piezas();
    cuerpos.erase(cuerpos.begin() + DE_CAMARA, cuerpos.end());
    const Escena escena = objetos(cuerpos);
    paraCada("volumen_vista", casos, VENTANA.ancho, VENTANA.alto, [&](const auto &c, const Vista &vista) {
        const double t = std::tan(0.52 / 2), lado = 0.26 * 360;
        const struct { double x, aspecto; } visores[] = {{0.62, 4.0 / 3}, {0.975, c.aspecto}};
        for (const auto &visor : visores) {
            const Hueco h = {int(240 + (visor.x - 2.0 / 3) * 360), 25,
                             int(std::min(lado * 4 / 3, lado * visor.aspecto)),
                             int(std::min(lado, lado * 4 / 3 / visor.aspecto))};
            ImagenRef ref{h.ancho, h.alto, {}};
            for (int y = 0; y < h.alto; ++y)
                for (int x = 0; x < h.ancho; ++x) {
                    const Vec3 hacia{c.aspecto * t * (2 * (x + 0.5) / h.ancho - 1),
                                     t * (2 * (y + 0.5) / h.alto - 1), -1};
                    const double oblicuo = longitud(hacia);
                    const Impacto i =
                        primerImpacto(escena, {OJO, unitario(hacia), 2.5 * oblicuo, 9 * oblicuo});
                    const Cuerpo &cuerpo = cuerpos[i ? std::size_t(i.objeto) : 0];
                    const Vec3 color =
                        i ? luzFija(unitario(normalInterpolada(cuerpo.objeto, i))) * cuerpo.color
                          : exacto(CIELO);
                    ref.pixeles.push_back({color, i.objeto, i.corte.cara, 0, i.punto, i.normalCara});
                }
            comprueba("el visor", recorta(vista.escena, h), ref);
        }
    });
}

// Los topes: 1.5 ≤ cerca ≤ lejos − 3 y lejos ≤ 10; de ellos se vuelve a la primera. Casi de frente, y desde el otro
// lado, un plano se ve a través del otro: el orden de los tintes cambia. Cada tinte pierde el redondeo de lo que tiñe
// (0.65·e), el suyo (0.35·0.5), el de 0.35 a 8 bits (0.25 en 255) y el de la suma (0.5): de e = 0.5, con uno, 1.25; con
// los dos, 1.74.
TEST(VolumenVista, ContraTrazadoDeRayos) {
    const struct {
        std::string guion;
        Panel volumen;
        double azimut = 0.95;
    } casos[] = {
        {"", volumen(true, 2.5, 9)},
        {"tecla p", volumen(false, 2.5, 9)},
        {"tecla p; tecla - ×3; tecla ,", volumen(true, 2, 7.5)},
        {"tecla + ×5; tecla . ×2; tecla p", volumen(false, 3, 10)},
        {"tecla + ×40; tecla , ×40; tecla -; tecla .; tecla p", volumen(true, 2, 9.5)},
        {"tecla .; tecla - ×40; tecla +", volumen(true, 2.5, 6)},
        {"tecla + ×6; tecla . ×40; tecla ,", volumen(true, 5.5, 9)},
        {"tecla , ×6; " + arrastra({20, 90}, {140, 90}), volumen(true, 2.5, 9), 0.35},
        {arrastra({490, 90}, {0, 90}), volumen(true, 2.5, 9), 2.8},
        {"tecla p", volumen(false, 2.5, 9), 2.8},
        {"tecla p; tecla d; tecla s", volumen(true, 2.5, 9, 0.455, 5.0 / 3), 2.8},
        {"tecla w ×9; tecla d ×9; tecla s ×2; tecla p", volumen(false, 2.5, 9, 0.455, 2), 2.8},
        {"tecla p; tecla s ×9; tecla a ×9; tecla d", volumen(true, 2.5, 9, 0.26, 1), 2.8},
    };
    const std::vector<Cuerpo> cuerpos = piezas();
    const Escena escena = objetos(cuerpos);
    paraCada("volumen_vista", casos, VENTANA.ancho, VENTANA.alto, [&](const auto &c, const Vista &vista) {
        const Camara camara = perspectiva(orbita(c.azimut, 0.36, 20.3, {0, 1.6, 0.9}), 0.55, 1, 100);
        const auto tono = [&](const Impacto &i) { return sombrea(i, cuerpos, c.volumen); };
        comprueba("la escena", compara(vista.escena, escena, camara, tono), {1.75, 500, 0.012});
    });
}
