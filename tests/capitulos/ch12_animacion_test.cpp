// Comprobaciones independientes de los programas del capítulo 12 que no son partículas: qué debe verse en cada
// instante se calcula aquí, en doble precisión.
#include "ch08_oraculo.h"
#include "ch12_instante.h"
#include "ch12_ruido.h"
#include "colores.h"
#include "panel.h"
#include "tabla.h"
#include <tuple>

using namespace oraculo;

namespace {

/// De 0 a 1 y de vuelta a 0.
double pulso(double t, double periodo) {
    return 0.5 - 0.5 * std::cos(2 * PI * t / periodo);
}

// Con el anillo opaco (t = 1) se ve él y sin él (t = 3), el cubo entero; en medio, la mezcla con alfa = (1 +
// sen(2πt/4))/2. Un nivel y medio: lo que hay, lo que llega y alfa se redondean a 8 bits.
TEST(Desvanecer, MezclaExacta) {
    const Camara camara = perspectiva(orbita(0.5, 0.55, 9.5), 0.42, 1, 50);
    const Cuerpo cubo = {caja(escala(1.5)), exacto(AMARILLO)},
                 anillo = {enElMundo(gira({1, 0, 0}, 0.6), toro(1.45f, 0.35f, 90, 36)), exacto(AZUL)};
    std::vector<Cuerpo> fondo = {cubo};
    for (int x = 0; x < 8; ++x)
        for (int z = 0; z < 8; ++z)
            fondo.push_back({caja(traslada({x - 3.5, -1.9, z - 3.5}) * escala({1, 0.1, 1})),
                             exacto((x + z) % 2 ? GRIS : BLANCO)});
    const Imagen sin = vistaDe("desvanecer", instante(3)).escena,
                 con = vistaDe("desvanecer", instante(1)).escena;
    comprueba("sin anillo", comparaConLuzFija(sin, fondo, camara, exacto(CIELO)));
    fondo.push_back(anillo);
    comprueba("con él", comparaConLuzFija(con, fondo, camara, exacto(CIELO)));
    for (const double t : {0.0, 0.5, 1.7, 2.0, 3.5, 6.5, HORAS + 0.5, HORAS + 2, HORAS + 3}) {
        const double alfa = pulso(t + 1, 4);
        const auto mezcla = [&](int x, int y) {
            return (1 - alfa) * texel(sin, x, y) + alfa * texel(con, x, y);
        };
        EXPECT_LE(diferenciaMaxima(vistaDe("desvanecer", instante(t)).escena, mezcla), 1.5) << t;
    }
}

// El avión, con M(t) aplicada aquí; y sus estelas, cada una delante de las anteriores.
TEST(ObjetoAnimado, LaMatrizDeCadaInstante) {
    const Vec3 piezas[][3] = {{{0, 0, 0}, {1.1, 0.22, 0.22}, exacto(NARANJA)},
                              {{0.1, 0, 0}, {0.32, 0.08, 1.3}, exacto(AMARILLO)},
                              {{-0.45, 0, 0}, {0.18, 0.06, 0.5}, exacto(AMARILLO)},
                              {{-0.42, 0.22, 0}, {0.2, 0.34, 0.07}, exacto(ROJO)}};
    const auto matrizEn = [](int modo, double t) {
        const double a = 2 * PI * t / 6;
        return modo == 0   ? traslada({std::cos(a), 0, -std::sin(a)})
               : modo == 1 ? escala((1 + 0.5 * std::sin(a)) * Vec3{1, 1, 1})
                           : gira({0, 1, 0}, a);
    };
    for (const int modo : {0, 1, 2})
        for (const double t : {0.0, 0.5, 2.0, 3.5, 7.5, HORAS + 8.5}) {
            SCOPED_TRACE(std::to_string(modo) + " en " + conDosCifras(t));
            const Camara camara =
                perspectiva(orbita(0.35, 0.5, 5.7, {0, -0.2, 0}), modo ? 0.41 : 0.5, 1, 1000);
            const Vista v =
                vistaDe("objeto_animado", "tecla " + std::to_string(modo + 1) + "; " + instante(t));
            std::vector<Cuerpo> cuerpos;
            for (int k = 0; k <= 3; ++k) {
                // cuatro veces mayor y más lejos del ojo se ve igual, pero detrás
                const double palidez = k ? 0.5 + 0.12 * k : 0, lejos = std::pow(4, k);
                const Mat4 M = traslada(camara.ojo) * escala(lejos * Vec3{1, 1, 1}) *
                               traslada(-1 * camara.ojo) * matrizEn(modo, t - 0.35 * k);
                for (const auto &[centro, lados, color] : piezas)
                    cuerpos.push_back({caja(M * traslada(centro) * escala(lados)),
                                       (1 - palidez) * color + palidez * exacto(FONDO_CLARO)});
            }
            compruebaEscena(v, Panel(camara, v.escena), cuerpos, FONDO_CLARO);
        }
}

// Cada sólido, con el modelo de Phong y una luz de intensidad I(t) y color C(t); la bombilla, que está donde la
// fuente, es de ese color, y delante de lo que hay detrás de ella se suma su halo: son dos redondeos a 8 bits.
TEST(LucesAnimadas, ProporcionalALaLuz) {
    const Camara camara = perspectiva(orbita(0.4, 0.38, 12.4, {0.1, 0.25, 0}), 0.45, 1, 50);
    const Vec3 fuente{-0.1, 2.3, 1.3}, La{0.5, 0.5, 0.5}, gris{0.25, 0.25, 0.25};
    const Malla bola = esfera(segmentosEsfera(150));
    const Escena escena = {plano(gira({1, 0, 0}, -PI / 2) * escala({4.5, 4.5, 1})),
                           enElMundo(traslada({0.8, 0.7, -0.3}) * escala(0.7), bola),
                           caja(traslada({-1, 0.5, 0.3}) * gira({0, 1, 0}, 0.4)),
                           enElMundo(traslada(fuente) * escala(0.16), bola)};
    const Material brillante{gris, {0.80, 0.80, 0.80}, {0.15, 0.15, 0.15}, 30},
        clara{gris, {0.85, 0.85, 0.85}, {}, 1}, oscura{{0.12, 0.12, 0.12}, {0.40, 0.40, 0.40}, {}, 1};
    const auto colorDeLuz = [](double t) {
        return pulso(t, 8) * Vec3{0.3, 0.6, 1} + (1 - pulso(t, 8)) * Vec3{1, 0.6, 0.25};
    };
    for (const double t : {0.0, 0.5, 1.5, 2.0, 4.0, 7.0, HORAS + 9, HORAS + 9.5, HORAS + 13}) {
        Luz luz = posicional(fuente);
        luz.Ld = luz.Ls = pulso(t + 2, 4) * colorDeLuz(t);
        const Material bombilla{2 * luz.Ld, {}, {}, 1};
        const auto iluminado = [&](const Impacto &i) -> Tono {
            const Vec3 frente = ejes(camara).z, &d = i.rayo.direccion;
            const double hasta = escalar(fuente - camara.ojo, frente) / escalar(d, frente),
                         lejos = longitud(camara.ojo + hasta * d - fuente);
            const double halo = !i || hasta < i.distancia ? 0.8 * std::pow(std::max(1 - lejos, 0.0), 2) : 0;
            if (!i)
                return exacto(FONDO_OSCURO) + halo * luz.Ld;
            const Vec3 N = unitario(normalInterpolada(escena[std::size_t(i.objeto)], i));
            const bool par = (int(std::floor(i.punto.x / 0.75)) + int(std::floor(i.punto.z / 0.75))) % 2 == 0;
            const Material &m = i.objeto == 3 ? bombilla : i.objeto ? brillante : par ? clara : oscura;
            return {phong(m, La, {luz}, i.punto, N, haciaOjo(i)) + halo * luz.Ld, i.objeto == 0 && par};
        };
        const Vista v = vistaDe("luces_animadas", instante(t));
        comprueba("t = " + conDosCifras(t), compara(v.escena, escena, camara, iluminado), {1.001});
    }
}

// Cada píxel, lo que hay en la imagen donde dice el seno, con el filtro lineal; fuera de ella, su borde. El cuadrado
// no se deforma.
TEST(TexturaOndulada, LeeDondeDiceElSeno) {
    const Imagen im = alAzar(64, 48); // menos de un texel por píxel
    for (const double t : {0.0, 0.5, 1.0, 2.5, HORAS + 3.5, HORAS + 6}) {
        const Vista v = vistaDe("textura_ondulada", instante(t), 240, 180, enFicheros({im}));
        const auto onda = [&](double s) { return 0.03 * std::sin(2 * PI * (3 * s - t / 4)); };
        const auto esperado = [&](int x, int y) {
            const double k = 90 / 0.64, s = (x + 0.5 - 120) / k + 0.5, u = (y + 0.5 - 90) / k + 0.5;
            const bool dentro = std::min(s, u) > 0 && std::max(s, u) < 1;
            return dentro ? bilineal(im, 64 * (s + onda(u)), 48 * (u + onda(s))) : color(FONDO_CLARO);
        };
        EXPECT_LE(diferenciaMaxima(v.escena, esperado), 1) << t;
    }
}

/// El toro del programa con sus vértices donde los lleva el ruido en el segundo t. La normal es la del producto
/// vectorial de dos tangentes, que se miden con diferencias: las del toro, muy pequeñas, y las de la textura, de un
/// texel a cada lado.
Malla toroDesplazado(double t, double S2, double centro) {
    const TexturaDeRuido ruido;
    const auto enToro = [](double s, double u) {
        const double radio = 1 + 0.42 * std::cos(2 * PI * u);
        return glm::dvec3(radio * std::cos(2 * PI * s), radio * std::sin(2 * PI * s),
                          0.42 * std::sin(2 * PI * u));
    };
    const auto valor = [&](double s, double u) {
        return S2 * (ruido(2 * s + t / 5, 2 * u + t / 5) - centro);
    };
    Malla m = toro(1, 0.42f, 128, 64);
    for (Vertice &v : m.vertices) {
        const double s = v.coordTextura.x, u = v.coordTextura.y, h = 1e-5, texel = 1 / 64.0;
        const glm::dvec3 porS = (enToro(s + h, u) - enToro(s - h, u)) / h +
                                (valor(s + texel, u) - valor(s - texel, u)) / texel,
                         porT = (enToro(s, u + h) - enToro(s, u - h)) / h +
                                (valor(s, u + texel) - valor(s, u - texel)) / texel;
        v.posicion = enToro(s, u) + valor(s, u);
        v.normal = glm::normalize(glm::cross(porS, porT));
    }
    return m;
}

/// El objeto de ese panel es, píxel a píxel, el toro del programa con sus vértices desplazados aquí y su normal.
void compruebaRuido(const Vista &v, const Hueco &h, int modo, double t, double S2) {
    const double deLosDos =
        2 * std::atan(0.8 / (4 / 3.0) * std::tan(0.51 / 2)); // compuestos para 0.8, y no para 4:3
    const Panel panel(perspectiva(orbita(-0.3, 0.35, 10), h.ancho < h.alto ? deLosDos : 0.4, 1, 50), h);
    const Cuerpo cuerpo = {enElMundo(Mat4(), toroDesplazado(std::fmod(t, 5), S2, modo == 0 ? 0.5 : 0)),
                           exacto(modo == 0 ? VERDE : NARANJA)};
    comprueba("t = " + conDosCifras(t),
              comparaConLuzFija(recorta(v.escena, h), {cuerpo}, panel.camara, exacto(FONDO_CLARO)), {1});
}

// Con más y menos amplitud; y los dos modos a la vez. Medio nivel más que lo exacto: en los pliegues hay triángulos
// de décimas de píxel de ancho, y llevar sus vértices a la rejilla de 1/256 se nota en la normal que se interpola.
TEST(RuidoVertices, CadaPixelDeLaMallaDesplazada) {
    for (const std::string modo : {"1", "2"}) {
        const auto casos = {
            std::tuple(0.0, 0.3, ""),         {2.5, 0.3, ""},           {HORAS + 7, 0.3, ""},
            {HORAS + 19.5, 0.3, ""},          {2.5, 0.1, "tecla - ×2"}, {2.5, 0.6, "tecla + ×3"},
            {2.5, 0.1, "tecla - ×9; tecla +"}};
        for (const auto &[t, S2, amplitud] : casos)
            compruebaRuido(
                vistaDe("ruido_vertices", "tecla v; tecla " + modo + "; " + amplitud + "; " + instante(t)),
                {0, 0, 240, 180}, modo == "2", t, S2);
    }
    const Vista dos = vistaDe("ruido_vertices", "tecla v; " + instante(2.5));
    for (const int modo : {0, 1})
        compruebaRuido(dos, hueco(modo, 2, 0, 1, 240, 180), modo, 2.5, 0.3);
}

// Los disparos de cada temporizador: los que se cuentan y una marca por cada uno de los tres últimos segundos, en su
// instante. En pausa no dispara ninguno.
TEST(Temporizador, DisparosDeCadaUno) {
    const struct {
        std::string guion;
        double t;
        int disparos[3];
    } casos[] = {{"", 0, {0, 0, 0}},
                 {"espera 1100; tecla Espacio; espera 3330; tecla Espacio; espera 1400", 2.5, {10, 6, 2}},
                 {"espera 1500", 4, {16, 10, 4}},
                 {"tecla l; tecla o; espera 3000; tecla o; tecla l; espera 4000", 11, {42, 27, 11}}};
    const glm::vec3 colores[] = {ROJO, VERDE, AZUL};
    const int periodos[] = {250, 400, 1000};
    paraCada("temporizador", casos, 240, 180, [&](const auto &c, const Vista &v) {
        const double desde = std::max(0.0, c.t - 3);
        for (int i = 0; i < 3; ++i) {
            const auto esRotulo = [&](const Pintado &p) { return p.tipo == "rotulo" && p.es(colores[i]); };
            const Encima cuenta = v.encima.los(esRotulo);
            EXPECT_TRUE(cuenta.size() == 1 && cuenta[0].texto == std::to_string(c.disparos[i])) << i;
            std::vector<glm::dvec2> marcas;
            for (int n = 1; n * periodos[i] <= 1000 * c.t; ++n)
                if (n * periodos[i] >= 1000 * desde)
                    marcas.push_back({120 + 90 * (-0.42 + 1.62 * (n * periodos[i] / 1000.0 - desde) / 3),
                                      90 + 90 * (0.6 - 0.55 * i)});
            compruebaPuntos(v.encima, marcas, colores[i]);
        }
    });
}

// El color del punto de la esfera o del anillo que ve cada rayo, con la textura hecha otra vez según la definición
// del ruido.
TEST(Textura3dAnimada, ElRuidoEnCadaPuntoYPeriodica) {
    const Camara camara = perspectiva(orbita(0.4, 0.4, 9.5), 0.4, 1, 50);
    const Escena escena = {enElMundo(Mat4(), esfera(segmentosEsfera(250))),
                           enElMundo(gira({1, 0, 0}, 1.3), toro(1.7f, 0.22f, 120, 40))};
    const std::vector<unsigned char> texels = definicion::textura3d();
    for (const double t : {0.0, 1.0, 4.0, HORAS + 4.5, HORAS + 13}) {
        const Vista v = vistaDe("textura3d_animada", instante(t));
        const Comparacion c = compara(v.escena, escena, camara, [&](const Impacto &i) {
            if (!i)
                return exacto(FONDO_OSCURO);
            const double valor = definicion::trilineal(texels, 0.4 * i.punto - Vec3{0, t / 4, 0}),
                         u = std::clamp((valor - 0.40) / 0.35, 0.0, 1.0), calor = u * u * (3 - 2 * u);
            const Vec3 roca = luzFija(normalInterpolada(escena[std::size_t(i.objeto)], i)) *
                              Vec3{0.26, 0.20, 0.19},
                       lava = (1 - calor) * Vec3{0.85, 0.15, 0.02} + calor * Vec3{1, 0.85, 0.30};
            return (1 - calor) * roca + calor * lava;
        });
        comprueba("t = " + conDosCifras(t), c);
    }
}

} // namespace
