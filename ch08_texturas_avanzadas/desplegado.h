// Los dos mapas de entorno de cubemap desplegados, con el punto que toca en ellos a un vector. `dibujaMapa` dibuja,
// en el panel abierto, lo que se ve con esa base y esa semitalla o, si se le dice, el esférico entero.
#pragma once
#include "ch03_transformaciones/transformaciones.h"
#include "colores.h"
#include "mapa_cubo.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "rotulo.h"
#include "texto.h"
#include "trazo.h"
#include <GL/glew.h>
#include <algorithm>

/// En el panel, el punto p y sus coordenadas, que se cuentan desde la esquina `cero`; de 0 a 1.
inline void marcaPunto(const glm::vec2 &cero, const glm::vec2 &p) {
    const glm::mat4 deCeroAUno = traslacion({-1, -1, 0}) * escalado({2, 2, 1});
    trazaSegmentos({{cero.x, p.y, 0}, {p, 0}, {p.x, cero.y, 0}, {p, 0}}, deCeroAUno, ROJO);
    trazaPuntos({{p, 0}}, deCeroAUno, ROJO);
    rotulaPunto("u", {(cero.x + p.x) / 2, p.y, 0}, deCeroAUno, ROJO, Lado::ENCIMA);
    rotulaPunto("v", {p.x, (cero.y + p.y) / 2, 0}, deCeroAUno, ROJO, Lado::DERECHA);
}

/// En esos píxeles, de qué vector se trata y sus coordenadas.
inline void explica(const Recuadro &r, const glm::vec3 &R, const std::string &cuentas) {
    abreRecuadro(r);
    rotula(formatea("R = (%.2f, %.2f, %.2f)\n", R.x, R.y, R.z) + cuentas, {0, 0.5f}, BLANCO, Lado::DERECHA,
           0.03f);
}

/// El mapa de cubo, en cruz, y lo que toca en él a ese vector.
template<class DibujaMapa>
void desplegaCubo(const glm::vec3 &R, DibujaMapa dibujaMapa) {
    const EnCara c = enCara(R);
    const Recuadro w = ventanaEntera();
    const int lado = std::max(int(0.95f * std::min(float(w.ancho) / 4, altoUtil() / 3)), 2); // con la raya
    const auto celda = [&](int columna, int fila) -> Recuadro {
        return {w.ancho / 2 + lado * (columna - 2), w.alto / 2 + lado * (2 - fila) - 3 * lado / 2, lado - 1,
                lado - 1};
    };
    for (const Cara &cara : CARAS) {
        abreRecuadro(celda(cara.columna, cara.fila));
        ponFondo(FONDO_OSCURO);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        dibujaMapa(cara.base, glm::vec2(1), false);
        rotula(std::string(cara.nombre) + "\n" + cara.donde, {0.5f, 0}, OSCURO, Lado::ENCIMA, 0.03f);
        const float cero = cara.delReves();
        if (&cara == &CARAS[c.cara])
            marcaPunto(glm::vec2(cero), cero + (1 - 2 * cero) * glm::vec2(c.u, c.v));
    }
    const Cara &cara = CARAS[c.cara];
    const char mayor = "xyz"[c.cara / 2];
    const Recuadro hueco = celda(2, 0);
    const int encima = w.alto - hueco.y - lado;
    explica(encima > lado ? Recuadro{0, w.alto - encima, w.ancho, encima}
                          : Recuadro{hueco.x, hueco.y, w.ancho - hueco.x, lado},
            R,
            formatea("|%c| es la mayor: cara %s\n", mayor, cara.nombre) +
                formatea("u = (1 %s/|%c|)/2 = %.2f\n", cara.u, mayor, c.u) +
                formatea("v = (1 %s/|%c|)/2 = %.2f", cara.v, mayor, c.v));
}

/// El esférico, dos veces más ancho que alto.
template<class DibujaMapa>
void desplegaEsferico(const glm::vec3 &R, DibujaMapa dibujaMapa) {
    const Recuadro w = ventanaEntera();
    const int alto = std::max(int(0.95f * std::min(float(w.ancho) / 2, altoUtil() * 3 / 4)), 1),
              y = w.alto / 40;
    abreRecuadro({w.ancho / 2 - alto, y, 2 * alto, alto});
    ponFondo(FONDO_OSCURO);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    dibujaMapa(glm::mat3(1), glm::vec2(1), true);
    const glm::vec2 st = enEsfera(R);
    marcaPunto({0, 0}, st);
    explica({w.ancho / 2 - alto, y + alto, w.ancho / 2 + alto, w.alto - y - alto}, R,
            formatea("u = 0.5 + atan(x, −z)/2π = %.2f\nv = 0.5 + asen(y)/π = %.2f", st.x, st.y));
}
