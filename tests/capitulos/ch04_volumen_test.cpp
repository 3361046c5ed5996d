// El programa volumen_vista contra trazado de rayos: la escena, con su color solo dentro del volumen, y los planos
// cerca y lejos, que tiñen lo que se ve a través de ellos; sus aristas, sus rótulos y los límites de sus teclas.
#include "ch04_oraculo.h"
#include <algorithm>
#include <gtest/gtest.h>
#include <iostream>
#include <map>

namespace {

using namespace oraculo;

const Vec3 OJO{0, 2.5, 6.5}; // mira hacia −Z con Y arriba: las coordenadas de la cámara son p − OJO
const double THETA = 0.52, ALTO = 1.7, ASPECTO = 4.0 / 3;

struct Volumen {
    bool enPerspectiva;
    double cerca, lejos;
    /// Medio alto a distancia d de la cámara.
    double medioAlto(double d) const {
        return enPerspectiva ? d * std::tan(THETA / 2) : ALTO;
    }
    bool contiene(const Vec3 &p) const {
        const Vec3 c = p - OJO;
        const double y = medioAlto(-c.z);
        return -c.z >= cerca && -c.z <= lejos && std::fabs(c.y) <= y && std::fabs(c.x) <= ASPECTO * y;
    }
    /// Si el rayo cruza el plano a distancia d de la cámara, dentro del volumen y antes de `tope`; y dónde.
    bool cruza(const Rayo &r, double d, double tope, double &t) const {
        t = (OJO.z - d - r.origen.z) / r.direccion.z;
        const Vec3 p = r.origen + t * r.direccion - OJO;
        const double y = medioAlto(d);
        return t > 0 && t < tope && std::fabs(p.y) <= y && std::fabs(p.x) <= ASPECTO * y;
    }
    Vec3 esquina(int k) const { // 0 a 3 en cerca, 4 a 7 en lejos
        const double d = k < 4 ? cerca : lejos, y = medioAlto(d);
        return OJO + Vec3{(k % 4 == 0 || k % 4 == 3 ? -1 : 1) * ASPECTO * y, (k % 4 < 2 ? -1 : 1) * y, -d};
    }
};

struct Arista {
    Vec3 a, b;
    glm::vec3 color;
};
std::vector<Arista> aristas(const Volumen &v) {
    std::vector<Arista> lista;
    for (int k = 0; k < 8; ++k)
        lista.push_back({v.esquina(k), v.esquina(k % 4 == 3 ? k - 3 : k + 1), k < 4 ? NARANJA : AZUL});
    for (int k = 0; k < 4; ++k) {
        lista.push_back({v.esquina(k), v.esquina(k + 4), OSCURO});
        if (v.enPerspectiva)
            lista.push_back({OJO, v.esquina(k), GRIS});
    }
    return lista;
}

double distanciaASegmento(double x, double y, const Vec3 &a, const Vec3 &b) {
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double t =
        std::clamp(((x - a.x) * dx + (y - a.y) * dy) / std::max(dx * dx + dy * dy, 1e-9), 0.0, 1.0);
    return std::hypot(x - a.x - t * dx, y - a.y - t * dy);
}

/// La escena del programa, escrita otra vez, con sólidos exactos.
struct EscenaVolumen {
    Escena escena;
    std::vector<glm::vec3> colores;
    int deCamara; // desde cuál son de la cámara de fotos, que no se recorta

    EscenaVolumen() {
        const Mat4 dePie = gira({1, 0, 0}, -PI / 2);
        pon(caja(traslada({0, -0.1, 0.5}) * escala({8, 0.2, 12})), SUELO);
        pon(esfera(traslada({-0.7, 2.5, 2.3}) * escala(0.6)), ROJO);
        pon(cono(traslada({1.2, 0, 0.2}) * dePie * escala({0.9, 0.9, 3.8})), VERDE);
        pon(caja(traslada({-2.3, 1.5, -0.4}) * escala({1.4, 3, 1.4})), AMARILLO);
        pon(esfera(traslada({0.5, 1.8, -2.7}) * escala(1.5)), MORADO);
        pon(caja(traslada({1.9, 0.5, 5.7})), AZUL);
        pon(cono(traslada({-3, 0, 3.2}) * dePie * escala({0.8, 0.8, 2.4})), NARANJA);
        deCamara = static_cast<int>(escena.size());
        pon(caja(traslada(OJO + Vec3{0, 0, 0.5}) * escala({1, 0.65, 0.55})), GRIS);
        pon(caja(traslada(OJO + Vec3{0, 0.42, 0.5}) * escala({0.4, 0.22, 0.4})), OSCURO);
        pon(caja(traslada(OJO + Vec3{0.34, 0.36, 0.5}) * escala({0.18, 0.1, 0.18})), ROJO);
        pon(cilindro(traslada(OJO + Vec3{0, 0, 0.1}) * escala({0.27, 0.27, 0.3})), OSCURO);
    }
    void pon(const Objeto &objeto, const glm::vec3 &color) {
        escena.push_back(objeto);
        colores.push_back(color);
    }
};

Camara desde(double azimut) {
    return perspectiva(orbita(azimut, 0.36, 20.3, {0, 1.6, 0.9}), 0.55, 1, 100);
}

void comprueba(const std::string &guion, const Volumen &v, double azimut = 0.95) {
    const Vec3 fuera{0.80, 0.82, 0.84}, naranja = vec3De(NARANJA), azul = vec3De(AZUL);
    const EscenaVolumen e;
    const Camara camara = desde(azimut);
    const auto sombrea = [&](const Impacto &i) {
        Vec3 color = vec3De(FONDO_CLARO);
        int zona = 0;
        if (i) {
            const Vec3 propio = vec3De(e.colores[static_cast<std::size_t>(i.objeto)]);
            zona = i.objeto < e.deCamara && v.contiene(i.punto);
            color = luzExacta(i.normal) * (zona || i.objeto >= e.deCamara ? propio : fuera);
        }
        const double tope = i ? i.distancia : INFINITO;
        double tCerca, tLejos;
        const bool cruzaCerca = v.cruza(i.rayo, v.cerca, tope, tCerca),
                   cruzaLejos = v.cruza(i.rayo, v.lejos, tope, tLejos);
        const auto tinta = [&](bool cruza, const Vec3 &tinte) {
            if (cruza)
                color = 0.65 * color + 0.35 * tinte;
        };
        tinta(cruzaLejos && tLejos > tCerca, azul); // de atrás adelante
        tinta(cruzaCerca, naranja);
        tinta(cruzaLejos && tLejos <= tCerca, azul);
        return Tono(color, zona + 2 * cruzaCerca + 4 * cruzaLejos);
    };
    const int ancho = 480, alto = 360;
    ImagenRef ref = render(e.escena, camara, ancho, alto, sombrea);
    const Ejecucion ejecucion = ejecuta("ch04_vista3d/volumen_vista", guion, ancho, alto);
    ASSERT_EQ(ejecucion.estado, 0) << ejecucion.errores;
    const std::vector<Arista> lados = aristas(v);
    std::vector<std::array<Vec3, 2>> enImagen;
    for (const Arista &a : lados)
        enImagen.push_back({proyecta(camara, ancho, alto, a.a), proyecta(camara, ancho, alto, a.b)});
    struct Zona {
        Vec3 w;
        double dx, dy;
    };
    std::vector<Zona> zonas; // donde puede haber un rótulo: a un lado o al otro de su punto
    const auto zona = [&](const Vec3 &p, double dx, double dy) {
        zonas.push_back({proyecta(camara, ancho, alto, p), dx, dy});
    };
    const auto medio = [&](int a, int b) { return 0.5 * (v.esquina(a) + v.esquina(b)); };
    zona(v.esquina(3), 60, 28);
    zona(v.esquina(6), 60, 28);
    zona(medio(v.enPerspectiva ? 4 : 0, v.enPerspectiva ? 5 : 1), 38, 28);
    zona(medio(5, 6), 100, 12);
    if (v.enPerspectiva)
        zona(OJO - Vec3{0, 0.4, 0}, 12, 28);
    else
        zona(medio(0, 3), 124, 12), zona(medio(3, 7), 44, 28);
    daPorBuenos(ref, ejecucion.imagen, [&](int x, int y) {
        for (const auto &[a, b] : enImagen)
            if (distanciaASegmento(x + 0.5, y + 0.5, a, b) < 3.5)
                return true;
        for (const Zona &z : zonas)
            if (std::fabs(x - z.w.x) < z.dx && std::fabs(y - z.w.y) < z.dy)
                return true;
        return false;
    });
    const Comparacion c = compara(ejecucion.imagen, ref, 5);
    std::cout << "«" << guion << "»: " << c << "\n";
    // la normal del cono naranja, de 48 caras, salta en su vértice media cara: sen(π/48)·0.42·255·0.95 = 6.7
    EXPECT_LE(c.maximo, 7) << c;
    EXPECT_LE(c.rmse, 0.6) << c;
    EXPECT_GT(c.interior, 70000);
    EXPECT_LE(c.bandaLejos, 5) << c;

    // las aristas que nada tapa, de su color; los rótulos y otras aristas pueden tapar una parte
    int buenos = 0, vistos = 0;
    for (std::size_t k = 0; k < lados.size(); ++k)
        for (int n = 1; n < 40; ++n) {
            const Vec3 p = lados[k].a + n / 40.0 * (lados[k].b - lados[k].a),
                       w = proyecta(camara, ancho, alto, p);
            const Rayo r = rayo(camara, ancho, alto, w.x, w.y);
            const double distancia = longitud(p - r.origen);
            const Impacto i = primerImpacto(e.escena, r);
            if (i && i.distancia < distancia + 0.3)
                continue;
            ++vistos;
            buenos += esColor(pixel(ejecucion.imagen, static_cast<int>(w.x), static_cast<int>(w.y)),
                              lados[k].color);
        }
    EXPECT_GE(buenos, (azimut == 0.95 ? 0.8 : 0.5) * vistos) << vistos; // de frente se tapan unas a otras
}

Imagen imagen(const std::string &guion, int ancho = 960, int alto = 720) {
    const Ejecucion e = ejecuta("ch04_vista3d/volumen_vista", guion, ancho, alto);
    EXPECT_EQ(e.estado, 0) << e.errores;
    return e.imagen;
}

std::string veces(int n, const std::string &orden) {
    std::string guion;
    for (int i = 0; i < n; ++i)
        guion += orden + "; ";
    return guion;
}

} // namespace

TEST(VolumenVista, Piramide) {
    comprueba("", {true, 2.5, 9});
}

TEST(VolumenVista, Caja) {
    comprueba("tecla p", {false, 2.5, 9});
}

TEST(VolumenVista, PlanosMovidos) {
    comprueba("tecla -; tecla -; tecla -; tecla ,", {true, 2, 7.5});
    comprueba("tecla +; tecla +; tecla p; tecla .", {false, 3, 10});
}

// Las teclas paran en sus límites: 1.5 ≤ cerca ≤ lejos − 0.5 y lejos ≤ 12.
TEST(VolumenVista, LosPlanosTienenLimites) {
    comprueba(veces(40, "tecla +") + veces(40, "tecla ,"), {true, 1.5, 12});
    comprueba(veces(40, "tecla -"), {true, 2.5, 3});
    comprueba(veces(40, "tecla .") + "tecla p", {false, 8.5, 9});
}

// Casi de frente, y desde el otro lado, un plano se ve a través del otro: el orden de los tintes cambia.
TEST(VolumenVista, UnPlanoATravesDelOtro) {
    comprueba("boton IZQUIERDO abajo 20 90; arrastra 140 90; boton IZQUIERDO arriba 140 90", {true, 2.5, 9},
              0.35);
    comprueba("boton IZQUIERDO abajo 400 90; arrastra 30 90; boton IZQUIERDO arriba 30 90", {true, 2.5, 9},
              2.8);
}

// Cada parámetro de las figuras 4.3 y 4.4 está rotulado junto a lo que decide, con el valor de los que cambian.
TEST(VolumenVista, LosParametrosDeLasFiguras) {
    const auto comprueba = [](const std::string &guion, const Volumen &v, const char32_t *texto,
                              const Vec3 &punto, double dx, double dy, const glm::vec3 &color) {
        const Vec3 w = proyecta(desde(0.95), 960, 720, punto);
        const double letras = static_cast<double>(std::u32string(texto).size());
        EXPECT_LE(
            distanciaRotulo(imagen(guion), texto, color, w.x + dx * (9 + 9 * letras), w.y + 21 * dy, 0.033),
            6 / 720.0)
            << guion << " " << v.cerca << " " << letras << " letras";
    };
    const auto medio = [](const Volumen &v, int a, int b) { return 0.5 * (v.esquina(a) + v.esquina(b)); };
    const Volumen piramide{true, 2.5, 9}, caja{false, 2.5, 9}, movida{true, 3, 8};
    comprueba("", piramide, U"cerca 2.5", piramide.esquina(3), 0, 1, NARANJA);
    comprueba("", piramide, U"lejos 9", piramide.esquina(6), 0, 1, AZUL);
    comprueba("tecla .; tecla -; tecla -", movida, U"cerca 3", movida.esquina(3), 0, 1, NARANJA);
    comprueba("tecla .; tecla -; tecla -", movida, U"lejos 8", movida.esquina(6), 0, 1, AZUL);
    comprueba("", piramide, U"ancho", medio(piramide, 4, 5), 0, -1, OSCURO);
    comprueba("", piramide, U"alto", medio(piramide, 5, 6), 1, 0, OSCURO);
    comprueba("", piramide, U"θ", OJO - Vec3{0, 0.4, 0}, 0, -1, OSCURO);
    comprueba("tecla p", caja, U"izquierda", medio(caja, 0, 3), -1, 0, OSCURO);
    comprueba("tecla p", caja, U"derecha", medio(caja, 5, 6), 1, 0, OSCURO);
    comprueba("tecla p", caja, U"abajo", medio(caja, 0, 1), 0, -1, OSCURO);
    comprueba("tecla p", caja, U"arriba", medio(caja, 3, 7), 0, 1, OSCURO);
}
