// La transformación de la cámara (ecuación 4.1): vista.h contra GLM, los casos difíciles y lo que enseña el programa camara.
#include "azar.h"
#include "ch04_oraculo.h"
#include "ch04_vista3d/vista.h"
#include "guiones.h"
#include <glm/gtc/matrix_transform.hpp>

namespace {

using namespace oraculo;

// F y UP normalizados llevan unos 6 redondeos por componente; F × UP los suma y añade 3 (18 en total, por la
// norma), y al normalizar se dividen por el seno. U y S añaden otros 12 sin dividir.
double cotaBase(double seno) {
    return 30 * U_DOBLE / seno + 12 * U_DOBLE;
}

glm::dvec3 alAzar(Azar &azar, double talla) {
    return {azar.entre(-talla, talla), azar.entre(-talla, talla), azar.entre(-talla, talla)};
}

/// Seno del ángulo entre F y UP.
double senoCon(const glm::dvec3 &p, const glm::dvec3 &i, const glm::dvec3 &UP) {
    const Vec3Largo F = glm::normalize(Vec3Largo(i) - Vec3Largo(p));
    return double(glm::length(glm::cross(F, glm::normalize(Vec3Largo(UP)))));
}

/// La matriz contra la de GLM con más precisión, que es la ecuación 4.1 con S normalizado.
void compruebaMatriz(const glm::dvec3 &p, const glm::dvec3 &i, const glm::dvec3 &UP) {
    const Mat4Largo exacta = glm::lookAt(Vec3Largo(p), Vec3Largo(i), Vec3Largo(UP));
    const glm::dmat4 M = transformacionCamara(p, i, UP);
    const double cota = cotaBase(senoCon(p, i, UP));
    for (int c = 0; c < 4; ++c) {
        for (int f = 0; f < 3; ++f)
            ASSERT_NEAR(M[c][f], double(exacta[c][f]), c < 3 ? cota : (cota + 4 * U_DOBLE) * glm::length(p));
        ASSERT_EQ(M[c][3], c == 3);
    }
}

/// Base unitaria, perpendicular, a derechas y sin NaN, y p en el origen.
void compruebaBase(const glm::dvec3 &p, const glm::dvec3 &i, const glm::dvec3 &UP) {
    const auto [S, U, F] = baseCamara(p, i, UP);
    const glm::dmat3 B(S, U, -F), deDosEnDos = glm::transpose(B) * B;
    for (int c = 0; c < 3; ++c)
        for (int f = 0; f < 3; ++f) // en la diagonal, el cuadrado de la longitud
            ASSERT_NEAR(deDosEnDos[c][f], c == f, (c == f ? 16 : 8) * U_DOBLE) << UP.x << " " << UP.y;
    ASSERT_NEAR(glm::determinant(B), 1, 16 * U_DOBLE) << UP.x << " " << UP.y;
    const glm::dvec4 origen = transformacionCamara(p, i, UP) * glm::dvec4(p, 1);
    for (int k = 0; k < 3; ++k)
        ASSERT_NEAR(origen[k], 0, 8 * U_DOBLE * glm::length(p)) << UP.x << " " << UP.y;
}

const Vec3 I{0, 1.7, 0};

/// La escena de camara.cpp, escrita otra vez; lo redondo, con las caras que tiene.
std::vector<Cuerpo> escena() {
    const Mat4 dePie = gira({1, 0, 0}, -PI / 2);
    return {
        {caja(traslada({0, -0.1, 0}) * escala({7, 0.2, 7})), exacto(SUELO)},
        {caja(traslada({0, 0.75, 0}) * escala({0.3, 1.5, 0.3})), exacto(GRIS)},
        {enElMundo(traslada(I) * escala(0.35), esfera(32)), exacto(AMARILLO)},
        {caja(traslada({-2, 0.9, -1.2}) * escala(1.8)), exacto(ROJO)},
        {enElMundo(traslada({2.2, 0, -1}) * dePie * escala({1, 1, 2.8}), porCaras(cono(32))), exacto(VERDE)},
        {caja(traslada({0.9, 0.4, 2}) * gira({0, 1, 0}, 0.5) * escala({1.6, 0.8, 0.8})), exacto(AZUL)}};
}

/// Desde fuera se señalan la pirámide de visión, que a 3 unidades del ojo llega a las esquinas de lo que se ve por `dentro`, la línea
/// de p a i y los ejes, delante de todo y cada uno de su color y con su nombre más allá de la punta.
void compruebaLoSenalado(const Vista &vista, const Panel &fuera, const Panel &dentro) {
    const auto [S, U, Z] = ejes(dentro.camara);
    const Vec3 ojo = dentro.camara.ojo;
    std::vector<glm::dvec2> marco, lados;
    const std::vector<Vec3> esquinas = esquinasA({3}, dentro);
    for (const std::size_t k : {2, 3, 0, 1}) {
        marco.push_back(fuera(esquinas[k]));
        lados.insert(lados.end(), {fuera(ojo), marco.back()});
    }
    marco.push_back(marco[0]);
    const glm::dvec2 p = fuera(ojo), i = fuera(I);
    std::vector<Trazo> trazos = {{"segmentos", GRIS, 3, true, lados},
                                 {"polilinea", GRIS, 4, true, marco},
                                 {"segmentos", OSCURO, 3, true, {p, i}}};
    std::vector<Letrero> letreros = {{"p", p, OSCURO, Lado::DEBAJO}, {"i", i, OSCURO, Lado::DERECHA}};
    const auto flecha = [&](const char *nombre, const Vec3 &v, const glm::vec3 &color) {
        trazos.push_back({"flecha", color, 8, false, {p, fuera(ojo + v)}});
        letreros.push_back({nombre, fuera(ojo + 1.3 * v), color});
    };
    flecha("UP", 3.4 * unitario(dentro.camara.arriba), NARANJA);
    flecha("S", 2.5 * S, ROJO);
    flecha("U", 2.5 * U, VERDE);
    flecha("F", -2.5 * Z, AZUL);
    trazos.push_back({"puntos", OSCURO, 18, false, {p, i}});
    compruebaEncima(vista, fuera.hueco, trazos, letreros);
    compruebaEncima(vista, dentro.hueco, {}, {{"lo que ve", dentro.lugar(0.5, 0.96), OSCURO}});
}

} // namespace

TEST(TransformacionCamara, ContraGlmConMasPrecision) {
    Azar azar(4);
    for (int n = 0; n < 2000; ++n) {
        const glm::dvec3 p = alAzar(azar, 10), i = alAzar(azar, 10);
        compruebaMatriz(p, i, alAzar(azar, 3));
    }
}

// El libro no dice que S haya que normalizarlo; sin eso, con UP oblicuo, la matriz encoge la imagen.
TEST(TransformacionCamara, SinNormalizarSNoEsUnGiro) {
    const glm::dvec3 F = glm::normalize(glm::dvec3(0, -1, -1)), UP(0, 1, 0), S = glm::cross(F, UP);
    EXPECT_NEAR(glm::length(S), std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(glm::length(baseCamara({0, 0, 0}, F, UP).S), 1, 8 * U_DOBLE);
}

TEST(TransformacionCamara, UpParaleloNuloODeCualquierLongitud) {
    Azar azar(41);
    for (int n = 0; n < 300; ++n) {
        const glm::dvec3 p = alAzar(azar, 10), i = alAzar(azar, 10);
        for (const double k : {1.0, -1.0, 1e-3, 1e-300, 1e300, 0.0, 1e-320})
            compruebaBase(p, i, k * (i - p));
    }
    for (const glm::dvec3 &d :
         {glm::dvec3(1, 0, 0), {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}})
        for (const double k : {1.0, -1.0, 0.0}) {
            const glm::dvec3 p(1, 2, 3);
            compruebaBase(p, p + d, k * d);
            const auto [S, U, F] = baseCamara(p, p + d, k * d);
            EXPECT_EQ(F, d);
            const bool enPlanta = d.y != 0; // X a la derecha; si no, Y hacia arriba
            EXPECT_EQ(enPlanta ? S : U, enPlanta ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
        }
    // lookAt, en float y en doble, da NaN
    EXPECT_TRUE(std::isnan(glm::lookAt(glm::vec3(0, 5, 0), glm::vec3(0), glm::vec3(0, 1, 0))[0][0]));
}

TEST(TransformacionCamara, OjoEnElPuntoDeInteres) {
    for (const glm::dvec3 &p : {glm::dvec3(0), {1, -2, 3}, glm::dvec3(1e6)})
        for (const glm::dvec3 &UP : {glm::dvec3(0, 1, 0), {0, 0, 1}, {1, 1, 0}, {0, 0, 0}}) {
            compruebaBase(p, p, UP);
            EXPECT_EQ(baseCamara(p, p, UP).F, glm::dvec3(0, 0, -1));
        }
}

// UP separado de F un ángulo de 1e-3 a 1e-9: la base sigue siendo exacta y la inclinación, la pedida con el error
// que cabe esperar, u/seno. A 1e-11 ya no hay inclinación que pedir, pero sí base.
TEST(TransformacionCamara, UpCasiParalelo) {
    Azar azar(42);
    for (const double desvio : {1e-3, 1e-5, 1e-7, 1e-9})
        for (int n = 0; n < 200; ++n) {
            const glm::dvec3 p = alAzar(azar, 10), i = alAzar(azar, 10), d = i - p,
                             lado = glm::normalize(glm::cross(d, alAzar(azar, 1))),
                             UP = d + desvio * glm::length(d) * lado;
            compruebaMatriz(p, i, UP);
            compruebaBase(p, i, UP);
        }
    compruebaBase({0, 0, 0}, {1, 2, 3}, {1, 2, 3 + 1e-11});
    compruebaBase({0, 0, 0}, {1e-5, 2, 3}, {1e-5, 2, 3 + 1e-9});
}

// Con el ojo a L del origen, un vértice a unas 5 unidades del ojo. Multiplicando en doble por la del modelo antes de pasar a float, el
// error no crece con L: 4 productos y sumas de números menores que 16, unos 8 redondeos de 16·2⁻²⁴, y en doble 8·L·2⁻⁵³.
TEST(TransformacionCamara, OjoLejosDelOrigen) {
    Azar azar(43);
    for (const double L : {0.0, 1e3, 1e5, 1e6})
        for (int n = 0; n < 300; ++n) {
            const glm::dvec3 p = glm::dvec3(L) + alAzar(azar, 1), i = p + alAzar(azar, 5),
                             modelo = i + alAzar(azar, 2), UP(0, 1, 0);
            const glm::vec3 v(alAzar(azar, 1));
            if (senoCon(p, i, UP) < 0.1)
                continue;
            const glm::mat4 juntas(transformacionCamara(p, i, UP) * glm::translate(glm::dmat4(1), modelo));
            const Vec4Largo exacto = glm::lookAt(Vec3Largo(p), Vec3Largo(i), Vec3Largo(UP)) *
                                     Vec4Largo(Vec3Largo(modelo) + Vec3Largo(v), 1);
            for (int f = 0; f < 3; ++f)
                ASSERT_NEAR((juntas * glm::vec4(v, 1))[f], double(exacto[f]),
                            8 * 16 * U_FLOAT + 10 * cotaBase(0.1) + 100 * L * U_DOBLE);
        }
}

// En cada panel, la misma escena trazada: a la derecha, desde la cámara; a la izquierda, desde fuera y con la cámara en ella.
TEST(Camara, LoQueVe) {
    const Vec3 p1{4.4, 4.6, 0.4}, p2{-4, 1.5, 0.9}, Y{0, 1, 0};
    const struct {
        std::string guion;
        Vec3 p, UP;
        double inclinacion = 0; // radianes alrededor de F
    } posturas[] = {{"", p1, Y},
                    {"tecla 2; " + veces(3, "tecla i"), p2, Y, -0.3},
                    {"tecla 2; tecla o", p2, Y, 0.1},
                    {"tecla 2; tecla i; tecla 1", p1, Y}, // cada vista empieza derecha
                    {"tecla 3", {0.4, 7.2, 0.8}, {0, 0, -1}},
                    {"tecla 4", {2.4, 5.4, 2.0}, {-2.4, -3.7, -2.0 + 1e-7}}}; // UP a 1e-7 de F
    for (const auto &[guion, p, UP, inclinacion] : posturas) {
        SCOPED_TRACE(guion);
        const Vista vista = vistaDe("camara", guion);
        const Vec3 arriba = direccion(gira(I - p, inclinacion), UP);
        const Panel dentro(perspectiva(miraDesde(p, I, arriba), 0.85, 0.5, 60), hueco(1, 2, 0, 1, 240, 180)),
            fuera(perspectiva(orbita(0.75, 0.32, 18.5, {-0.3, 2.7, 0}), 0.54, 1, 100),
                  hueco(0, 2, 0, 1, 240, 180));
        const auto [S, U, Z] = ejes(dentro.camara);
        const Mat4 alMundo = {
            {{S.x, U.x, Z.x, p.x}, {S.y, U.y, Z.y, p.y}, {S.z, U.z, Z.z, p.z}, {0, 0, 0, 1}}};
        compruebaEscena(vista, dentro, escena(), CIELO);
        compruebaEscena(vista, fuera, conCamaraDeFotos(escena(), alMundo * escala(1.2)), FONDO_CLARO);
        compruebaLoSenalado(vista, fuera, dentro);
    }
}
