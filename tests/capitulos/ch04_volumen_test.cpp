// El programa volumen_vista contra trazado de rayos: la escena, con su color solo dentro del volumen, y los planos
// cerca y lejos, que tiñen lo que se ve a través de ellos.
#include "ch04_mallas.h"
#include "ejecuta.h"
#include <gtest/gtest.h>

namespace {

using namespace oraculo;

const Vec3 OJO{0, 2.5, 6.5}; // mira hacia −Z con Y arriba: las coordenadas de la cámara son p − OJO
const double CERCA = 2.5, THETA = 0.52, ALTO = 1.7, ASPECTO = 4.0 / 3;

struct Volumen {
    bool enPerspectiva;
    double lejos;
    /// Medio alto a distancia d de la cámara.
    double medioAlto(double d) const {
        return enPerspectiva ? d * std::tan(THETA / 2) : ALTO;
    }
    bool contiene(const Vec3 &p) const {
        const Vec3 c = p - OJO;
        const double y = medioAlto(-c.z);
        return -c.z >= CERCA && -c.z <= lejos && std::fabs(c.y) <= y && std::fabs(c.x) <= ASPECTO * y;
    }
    /// Si el rayo cruza el plano a distancia d de la cámara, dentro del volumen y antes de `tope`; y dónde.
    bool cruza(const Rayo &r, double d, double tope, double &t) const {
        t = (OJO.z - d - r.origen.z) / r.direccion.z;
        const Vec3 p = r.origen + t * r.direccion - OJO;
        const double y = medioAlto(d);
        return t > 0 && t < tope && std::fabs(p.y) <= y && std::fabs(p.x) <= ASPECTO * y;
    }
    Vec3 esquina(int k) const { // 0 a 3 en cerca, 4 a 7 en lejos
        const double d = k < 4 ? CERCA : lejos, y = medioAlto(d);
        return OJO + Vec3{(k % 4 == 0 || k % 4 == 3 ? -1 : 1) * ASPECTO * y, (k % 4 < 2 ? -1 : 1) * y, -d};
    }
};

/// El cilindro de 24 caras y radio `grosor` entre a y b; su X, lo más cerca posible de Y (o de ±Z, si es vertical).
Objeto barra(const Vec3 &a, const Vec3 &b, double grosor) {
    const Vec3 d = b - a, arriba = d.x == 0 && d.z == 0 ? Vec3{0, 0, d.y < 0 ? -1.0 : 1.0} : Vec3{0, 1, 0};
    const Vec3 y = unitario(vectorial(d, arriba)), x = unitario(vectorial(y, d)), medio = 0.5 * (a + b);
    return enMundo({{{grosor * x.x, grosor * y.x, d.x, medio.x},
                     {grosor * x.y, grosor * y.y, d.y, medio.y},
                     {grosor * x.z, grosor * y.z, d.z, medio.z},
                     {0, 0, 0, 1}}},
                   ::cilindro(24));
}

void comprueba(const std::string &guion, const Volumen &v, const Camara &camara) {
    const Vec3 naranja{0.95, 0.55, 0.10}, azul{0.16, 0.38, 0.80}, oscuro{0.16, 0.17, 0.20},
        gris{0.55, 0.58, 0.62}, rojo{0.85, 0.20, 0.18}, fuera{0.80, 0.82, 0.84}, luz{0.20, 0.78, 0.593};
    const Mat4 dePie = gira({1, 0, 0}, -PI / 2);
    Escena escena;
    std::vector<Vec3> colores;
    const auto pon = [&](const Objeto &objeto, const Vec3 &color) {
        escena.push_back(objeto);
        colores.push_back(color);
    };
    pon(caja(traslada({0, -0.1, 0.5}) * escala({9, 0.2, 12})), {0.60, 0.80, 0.58});
    pon(enMundo(traslada({-0.7, 2.5, 2.3}) * escala(0.6), ::esfera(48)), rojo);
    pon(enMundo(traslada({1.2, 0, 0.2}) * dePie * escala({0.9, 0.9, 3.8}), ::cono(48)), {0.20, 0.62, 0.28});
    pon(caja(traslada({-2.3, 1.5, -0.4}) * escala({1.4, 3, 1.4})), {0.98, 0.78, 0.15});
    pon(enMundo(traslada({0.5, 1.8, -2.7}) * escala(1.5), ::esfera(48)), {0.55, 0.30, 0.70});
    pon(caja(traslada({1.9, 0.5, 5.7})), azul);
    pon(enMundo(traslada({-3, 0, 3.2}) * dePie * escala({0.8, 0.8, 2.4}), ::cono(48)), naranja);
    const int deEscena = static_cast<int>(escena.size());
    pon(caja(traslada(OJO + Vec3{0, 0, 0.5}) * escala({1, 0.65, 0.55})), gris);
    pon(caja(traslada(OJO + Vec3{0, 0.42, 0.5}) * escala({0.4, 0.22, 0.4})), oscuro);
    pon(caja(traslada(OJO + Vec3{0.34, 0.36, 0.5}) * escala({0.18, 0.1, 0.18})), rojo);
    pon(enMundo(traslada(OJO + Vec3{0, 0, 0.1}) * escala({0.27, 0.27, 0.3}), ::cilindro(24)), oscuro);
    for (int k = 0; k < 8; ++k) {
        pon(barra(v.esquina(k), v.esquina(k % 4 == 3 ? k - 3 : k + 1), 0.06), k < 4 ? naranja : azul);
        pon(enMundo(traslada(v.esquina(k)) * escala(0.1), ::esfera(48)), k < 4 ? naranja : azul);
    }
    for (int k = 0; k < 4; ++k) {
        pon(barra(v.esquina(k), v.esquina(k + 4), 0.05), oscuro);
        if (v.enPerspectiva)
            pon(barra(OJO, v.esquina(k), 0.02), gris);
    }

    const auto sombrea = [&](const Impacto &i) {
        Vec3 color{0.95, 0.96, 0.98};
        int zona = 0;
        if (i.objeto >= deEscena) {
            color = (0.58 + 0.42 * escalar(normalInterpolada(escena, i), luz)) *
                    colores[static_cast<std::size_t>(i.objeto)];
        } else if (i) {
            zona = v.contiene(i.punto);
            color = (0.58 + 0.42 * escalar(i.normal, luz)) *
                    (zona ? colores[static_cast<std::size_t>(i.objeto)] : fuera);
        }
        const double tope = i ? i.distancia : INFINITO;
        double tCerca, tLejos;
        const bool cruzaCerca = v.cruza(i.rayo, CERCA, tope, tCerca),
                   cruzaLejos = v.cruza(i.rayo, v.lejos, tope, tLejos);
        const auto tinta = [&](bool cruza, const Vec3 &tinte) {
            if (cruza)
                color = 0.65 * color + 0.35 * tinte;
        };
        tinta(cruzaLejos && tLejos > tCerca, azul); // de atrás adelante
        tinta(cruzaCerca, naranja);
        tinta(cruzaLejos && tLejos <= tCerca, azul);
        // entre las caras de un cono la normal salta: en su vértice hay una por cara
        return Tono(color, zona + 2 * cruzaCerca + 4 * cruzaLejos +
                               (i.objeto == 2 || i.objeto == 6 ? 8 * i.corte.triangulo : 0));
    };
    const ImagenRef ref = render(escena, camara, 240, 180, sombrea);
    const Ejecucion e = ejecuta("ch04_vista3d/volumen_vista", guion);
    ASSERT_EQ(e.estado, 0) << e.errores;
    const Comparacion c = compara(e.imagen, ref);
    std::cout << "«" << guion << "»: " << c << "\n";
    // dos tintes sobre 8 bits son dos redondeos más
    EXPECT_LE(c.maximo, 2) << c;
    EXPECT_LE(c.rmse, 0.5) << c;
    EXPECT_GT(c.interior, 30000);
    // Los bordes, a menos de un píxel. Donde el centro de un píxel cae a menos de 1/256 de una arista de la silueta
    // (la rejilla de OpenGL), la cara de atrás tiene la misma profundidad que la de delante y, si se dibujó antes, se
    // queda: en estas imágenes pasa en cinco píxeles como mucho.
    EXPECT_LE(c.bandaLejos, 5) << c;
}

const Camara DESDE_FUERA = perspectiva(orbita(0.95, 0.38, 17.5, {0, 2.2, 1.5}), 0.55, 1, 100);

} // namespace

TEST(VolumenVista, Piramide) {
    comprueba("", {true, 9}, DESDE_FUERA);
}

TEST(VolumenVista, Caja) {
    comprueba("tecla p", {false, 9}, DESDE_FUERA);
}

TEST(VolumenVista, PlanoLejosMovido) {
    comprueba("tecla -; tecla -; tecla -", {true, 7.5}, DESDE_FUERA);
    comprueba("tecla +; tecla +; tecla p", {false, 10}, DESDE_FUERA);
}

// Casi de frente, y desde el otro lado, un plano se ve a través del otro: el orden de los tintes cambia.
TEST(VolumenVista, UnPlanoATravesDelOtro) {
    const auto camara = [](double azimut) {
        return perspectiva(orbita(azimut, 0.38, 17.5, {0, 2.2, 1.5}), 0.55, 1, 100);
    };
    comprueba("boton IZQUIERDO abajo 20 90; arrastra 80 90; boton IZQUIERDO arriba 80 90", {true, 9},
              camara(0.35));
    comprueba("boton IZQUIERDO abajo 200 90; arrastra 15 90; boton IZQUIERDO arriba 15 90", {true, 9},
              camara(2.8));
}
