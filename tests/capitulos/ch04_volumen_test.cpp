// El programa volumen_vista contra trazado de rayos: la escena, con su color solo dentro del volumen, y los planos
// cerca y lejos, que tiñen lo que se ve a través de ellos; sus aristas, sus rótulos y los límites de sus teclas.
#include "ch04_oraculo.h"
#include "guiones.h"
#include <map>
#include <sstream>

namespace {

using namespace oraculo;

const Vec3 OJO{0, 2.5, 6.5}; // mira hacia −Z con Y arriba: las coordenadas de la cámara son p − OJO
const double THETA = 0.52, ALTO = 1.7, ASPECTO = 4.0 / 3;

struct Volumen {
    bool enPerspectiva;
    double cerca, lejos;

    double medioAlto(double d) const { // a distancia d de la cámara
        return enPerspectiva ? d * std::tan(THETA / 2) : ALTO;
    }
    bool entreLosLados(const Vec3 &p) const {
        const Vec3 c = p - OJO;
        return std::fabs(c.y) <= medioAlto(-c.z) && std::fabs(c.x) <= ASPECTO * medioAlto(-c.z);
    }
    bool contiene(const Vec3 &p) const {
        const double d = OJO.z - p.z;
        return d >= cerca && d <= lejos && entreLosLados(p);
    }
    /// Distancia a la que el rayo cruza el plano que está a `d` de la cámara, entre los lados; infinita si no lo cruza.
    double cruza(const Rayo &r, double d) const {
        const double t = (OJO.z - d - r.origen.z) / r.direccion.z;
        return t > 0 && entreLosLados(r.origen + t * r.direccion) ? t : INFINITO;
    }
    Vec3 esquina(int k) const { // 0 a 3 en cerca, 4 a 7 en lejos
        const double d = k < 4 ? cerca : lejos, y = medioAlto(d);
        return OJO + Vec3{(k % 4 == 0 || k % 4 == 3 ? -1 : 1) * ASPECTO * y, (k % 4 < 2 ? -1 : 1) * y, -d};
    }
};

/// La escena del programa, escrita otra vez; lo redondo, con las caras que tiene. Lo último es la cámara de fotos, que no se recorta.
std::vector<Cuerpo> piezas() {
    const Mat4 dePie = gira({1, 0, 0}, -PI / 2);
    const Malla bola = esfera(48), pico = porCaras(cono(48));
    std::vector<Cuerpo> cuerpos = {
        {caja(traslada({0, -0.1, 0.5}) * escala({8, 0.2, 12})), exacto(SUELO)},
        {enElMundo(traslada({-0.7, 2.5, 2.3}) * escala(0.6), bola), exacto(ROJO)},
        {enElMundo(traslada({1.2, 0, 0.2}) * dePie * escala({0.9, 0.9, 3.8}), pico), exacto(VERDE)},
        {caja(traslada({-2.3, 1.5, -0.4}) * escala({1.4, 3, 1.4})), exacto(AMARILLO)},
        {enElMundo(traslada({0.5, 1.8, -2.7}) * escala(1.5), bola), exacto(MORADO)},
        {caja(traslada({1.9, 0.5, 5.7})), exacto(AZUL)},
        {enElMundo(traslada({-3, 0, 3.2}) * dePie * escala({0.8, 0.8, 2.4}), pico), exacto(NARANJA)}};
    for (const Cuerpo &pieza : camaraDeFotos(traslada(OJO)))
        cuerpos.push_back(pieza);
    return cuerpos;
}
const int DE_CAMARA = 7;

/// Lo que el programa dibuja, por cada impacto: la normal se interpola, y el shader del volumen la vuelve a normalizar.
Tono sombrea(const Impacto &i, const std::vector<Cuerpo> &cuerpos, const Volumen &v) {
    Vec3 color = exacto(FONDO_CLARO);
    const bool deCamara = i.objeto >= DE_CAMARA, dentro = i && !deCamara && v.contiene(i.punto);
    if (i) {
        const Cuerpo &c = cuerpos[std::size_t(i.objeto)];
        const Vec3 normal = normalInterpolada(c.objeto, i);
        color = luzFija(deCamara ? normal : unitario(normal)) *
                (deCamara || dentro ? c.color : Vec3{0.80, 0.82, 0.84});
    }
    const double tope = i ? i.distancia : INFINITO, tCerca = v.cruza(i.rayo, v.cerca),
                 tLejos = v.cruza(i.rayo, v.lejos);
    const std::map<double, glm::vec3, std::greater<>> deAtrasAdelante = {{tCerca, NARANJA}, {tLejos, AZUL}};
    for (const auto &[t, tinte] : deAtrasAdelante)
        if (t < tope)
            color = 0.65 * color + 0.35 * exacto(tinte);
    return {color, dentro + 2 * (tCerca < tope) + 4 * (tLejos < tope)};
}

// Los topes: 1.5 ≤ cerca ≤ lejos − 0.5 y lejos ≤ 12; de ellos se vuelve a la primera. Casi de frente, y desde el otro lado, un plano se
// ve a través del otro: el orden de los tintes cambia.
const struct {
    std::string guion;
    Volumen volumen;
    double azimut = 0.95;
} CASOS[] = {
    {"", {true, 2.5, 9}},
    {"tecla p", {false, 2.5, 9}},
    {"tecla p; tecla p", {true, 2.5, 9}},
    {veces(3, "tecla -") + "; tecla ,", {true, 2, 7.5}},
    {veces(2, "tecla +") + "; tecla p; tecla .", {false, 3, 10}},
    {veces(40, "tecla +") + "; " + veces(40, "tecla ,"), {true, 1.5, 12}},
    {veces(40, "tecla +") + "; " + veces(40, "tecla ,") + "; tecla -; tecla .", {true, 2, 11.5}},
    {veces(40, "tecla -"), {true, 2.5, 3}},
    {veces(40, "tecla -") + "; tecla +", {true, 2.5, 3.5}},
    {veces(40, "tecla .") + "; tecla p", {false, 8.5, 9}},
    {veces(40, "tecla .") + "; tecla ,", {true, 8, 9}},
    {arrastra({10, 45}, {70, 45}), {true, 2.5, 9}, 0.35},
    {arrastra({200, 45}, {15, 45}), {true, 2.5, 9}, 2.8},
    {arrastra({200, 45}, {15, 45}) + "; tecla p", {false, 2.5, 9}, 2.8},
};
const int ANCHO_VENTANA = 240, ALTO_VENTANA = 180;

/// Las aristas del volumen, con las que van del ojo a la pirámide, y cada parámetro de las figuras 4.3 y 4.4 junto a lo que decide.
void compruebaAristasYParametros(const Encima &encima, const Volumen &v, const Camara &camara) {
    const auto en = [&](const Vec3 &p) { return enPixeles(camara, p, ANCHO_VENTANA, ALTO_VENTANA); };
    const auto medio = [&](int a, int b) { return en(0.5 * (v.esquina(a) + v.esquina(b))); };
    const auto vertice = [&](int k) { return en(v.esquina(k)); };
    std::vector<Trazo> trazos;
    for (int k = 0; k < 4; ++k) {
        trazos.push_back({"segmentos", OSCURO, 5, true, {vertice(k), vertice(k + 4)}});
        if (v.enPerspectiva)
            trazos.push_back({"segmentos", GRIS, 3, true, {en(OJO), vertice(k)}});
    }
    for (const auto &[k, color] : {std::pair(0, NARANJA), {4, AZUL}})
        trazos.push_back({"polilinea",
                          color,
                          8,
                          true,
                          {vertice(k), vertice(k + 1), vertice(k + 2), vertice(k + 3), vertice(k)}});
    std::ostringstream cerca, lejos;
    cerca << "cerca " << v.cerca;
    lejos << "lejos " << v.lejos;
    std::vector<Letrero> letreros = {{cerca.str(), vertice(3), NARANJA, Lado::ENCIMA},
                                     {lejos.str(), vertice(6), AZUL, Lado::ENCIMA}};
    const std::vector<Letrero> deLaPiramide = {{"θ", en(OJO - Vec3{0, 0.4, 0}), OSCURO, Lado::DEBAJO},
                                               {"ancho", medio(4, 5), OSCURO, Lado::DEBAJO},
                                               {"alto", medio(5, 6), OSCURO, Lado::DERECHA}},
                               deLaCaja = {{"izquierda", medio(0, 3), OSCURO, Lado::IZQUIERDA},
                                           {"derecha", medio(5, 6), OSCURO, Lado::DERECHA},
                                           {"abajo", medio(0, 1), OSCURO, Lado::DEBAJO},
                                           {"arriba", medio(3, 7), OSCURO, Lado::ENCIMA}};
    for (const Letrero &l : v.enPerspectiva ? deLaPiramide : deLaCaja)
        letreros.push_back(l);
    compruebaEncima(encima, ALTO_VENTANA, trazos, losQueSeVen(letreros, ANCHO_VENTANA, ALTO_VENTANA));
}

} // namespace

// Cada tinte pierde el redondeo de lo que tiñe (0.65·e), el suyo (0.35·0.5), el de 0.35 a 8 bits (0.25 en 255) y el de la suma (0.5):
// de e = 0.5, con uno, 1.25; con los dos, 1.74.
TEST(VolumenVista, ContraTrazadoDeRayos) {
    const std::vector<Cuerpo> cuerpos = piezas();
    Escena objetos;
    for (const Cuerpo &c : cuerpos)
        objetos.push_back(c.objeto);
    for (const auto &[guion, v, azimut] : CASOS) {
        SCOPED_TRACE(guion);
        const Camara camara = perspectiva(orbita(azimut, 0.36, 20.3, {0, 1.6, 0.9}), 0.55, 1, 100);
        const auto [escena, encima] = vistaDe("volumen_vista", guion, ANCHO_VENTANA, ALTO_VENTANA);
        const auto tono = [&, &v = v](const Impacto &i) { return sombrea(i, cuerpos, v); };
        comprueba("«" + guion + "»", compara(escena, objetos, camara, tono), {1.75, 500, 0.012});
        compruebaAristasYParametros(encima, v, camara);
    }
}
