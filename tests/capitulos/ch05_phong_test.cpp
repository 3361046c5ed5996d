// phong.glsl con entradas sueltas: una sonda lo ejecuta en la GPU y devuelve el color en float, sin recortar
// ni redondear. Se compara con el oráculo en doble precisión y se prueban los casos difíciles de GLSL.
#include "ch05_iluminacion/iluminacion.h"
#include "oraculo/oraculo.h"
#include "sonda.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>
#include <random>

namespace {

const double PI = oraculo::PI;
const Material MATERIAL = {{0.10f, 0.20f, 0.05f}, {0.50f, 0.0f, 0.70f}, {0.60f, 0.40f, 0.0f}, 8};
const glm::vec3 LA(0.5f);

class Sonda : public testing::Test {
protected:
    static GLuint programa, listado;

    static void SetUpTestSuite() {
        programa = creaSonda("tests/capitulos/ch05_sonda.frag");
        listado = creaSonda("tests/capitulos/ch05_listado.frag");
    }

    /// phong() de phong.glsl.
    static glm::vec3 phong(const Material &m, const Luz &luz, const glm::vec3 &P, const glm::vec3 &N) {
        glUseProgram(programa);
        envia(programa, "La", LA);
        envia(programa, "P", P);
        envia(programa, "N", N);
        enviaMaterial(programa, m);
        enviaLuz(programa, "luz", luz, glm::mat4(1));
        return glm::vec3(leeSonda());
    }

    /// phong() de los listados 5.1 y 5.3.
    static glm::vec3 phongListado(const Material &m, const Luz &luz, const glm::vec3 &P, const glm::vec3 &N) {
        glUseProgram(listado);
        envia(listado, "Ka", glm::vec4(m.Ka, 1));
        envia(listado, "Kd", glm::vec4(m.Kd, 1));
        envia(listado, "Ks", glm::vec4(m.Ks, 1));
        envia(listado, "La", glm::vec4(LA, 1));
        envia(listado, "Ld", glm::vec4(luz.Ld, 1));
        envia(listado, "Ls", glm::vec4(luz.Ls, 1));
        envia(listado, "Lp", luz.Lp);
        envia(listado, "alfa", m.alfa);
        envia(listado, "P", P);
        envia(listado, "N", N);
        return glm::vec3(leeSonda());
    }
};
GLuint Sonda::programa, Sonda::listado;

oraculo::Vec3 doble(const glm::vec3 &v) {
    return {v.x, v.y, v.z};
}

/// Lo mismo, en doble precisión, con `delta` en radianes (negativo: no es un foco).
oraculo::Vec3 exacto(const Material &m, const Luz &luz, const glm::vec3 &P, const glm::vec3 &N,
                     double delta = -1) {
    oraculo::Luz l;
    l.posicion = doble(glm::vec3(luz.Lp)), l.w = luz.Lp.w;
    l.Ld = doble(luz.Ld), l.Ls = doble(luz.Ls);
    l.a = luz.atenuacion.x, l.b = luz.atenuacion.y, l.c = luz.atenuacion.z;
    l.foco = delta >= 0, l.delta = delta, l.S = doble(luz.S), l.exponente = luz.exponente;
    return oraculo::phong({doble(m.Ka), doble(m.Kd), doble(m.Ks), m.alfa}, doble(LA), {l}, doble(P),
                          oraculo::unitario(doble(N)), oraculo::unitario(-doble(P)));
}

/// Mayor diferencia, en niveles de 255, entre los colores que se verían.
double niveles(const glm::vec3 &gpu, const oraculo::Vec3 &ref) {
    double mayor = 0;
    for (int k = 0; k < 3; ++k)
        mayor =
            std::max(mayor, 255 * std::fabs(std::clamp<double>(gpu[k], 0, 1) - std::clamp(ref[k], 0.0, 1.0)));
    return mayor;
}

bool finito(const glm::vec3 &v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

#define ESPERA_AMBIENTE(color) EXPECT_EQ((color), MATERIAL.Ka *LA)

std::string texto(const glm::vec3 &v) {
    return "(" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + ")";
}

} // namespace

// Puntos, normales, materiales y luces de los tres tipos, al azar. Donde el modelo salta (el borde del cono,
// L·N = 0) la sonda puede caer al otro lado: se apartan 1e-4 rad.
TEST_F(Sonda, ContraDobleEnMilesDePuntosAlAzar) {
    std::mt19937 azar(5);
    const auto entre = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(azar); };
    const auto vector = [&](double r) { return glm::vec3(entre(-r, r), entre(-r, r), entre(-r, r)); };
    const float alfas[] = {0, 0.5f, 1, 5, 20, 100, 500};
    double maximo = 0;
    int comparados = 0;
    for (int i = 0; i < 4000; ++i) {
        const glm::vec3 P = glm::vec3(0, 0, -8) + vector(3);
        const glm::vec3 N =
            glm::normalize(vector(1) + glm::vec3(0, 0, 1)) * static_cast<float>(entre(0.3, 3));
        Material m = {vector(0.2) + 0.2f, vector(0.3) + 0.3f, vector(0.3) + 0.3f, alfas[i % 7]};
        Luz luz{glm::vec4(vector(6), i % 3 != 0)};
        luz.Ld = vector(0.5) + 0.5f, luz.Ls = vector(0.5) + 0.5f;
        luz.atenuacion = {entre(0, 1), entre(0, 0.3), entre(0.01, 0.1)};
        double delta = -1, angulo = 0;
        if (i % 3 == 2) {
            delta = entre(0.02, PI / 2);
            luz.S = glm::normalize(P - glm::vec3(luz.Lp) + vector(2));
            luz.cosDelta = static_cast<float>(std::cos(delta));
            luz.exponente = static_cast<float>(entre(0, 30));
            const oraculo::Vec3 L = oraculo::unitario(doble(glm::vec3(luz.Lp) - P));
            angulo = std::atan2(oraculo::longitud(oraculo::vectorial(L, doble(luz.S))),
                                -oraculo::escalar(L, doble(luz.S)));
        }
        const oraculo::Vec3 haciaLuz = doble(glm::vec3(luz.Lp) - luz.Lp.w * P);
        const double NL = oraculo::escalar(oraculo::unitario(haciaLuz), oraculo::unitario(doble(N)));
        if (std::fabs(angulo - delta) < 1e-4 || std::fabs(NL) < 1e-4)
            continue;
        const double error = niveles(phong(m, luz, P, N), exacto(m, luz, P, N, delta));
        EXPECT_LE(error, 0.5) // lo que ya cuesta guardarlo en 8 bits
            << i << ": P " << texto(P) << " N " << texto(N) << " alfa " << m.alfa;
        maximo = std::max(maximo, error);
        ++comparados;
    }
    EXPECT_GT(comparados, 3900);
    std::cout << comparados << " puntos: error máximo " << maximo << " niveles\n";
}

// El perfil del brillo, de 0 a 90 grados, para cada alfa de la figura 5.3. La cota: un error relativo e en
// R·V es alfa·e en su potencia, y R·V lleva unos 8 redondeos de 2^-24.
TEST_F(Sonda, PerfilDelBrilloContraCosenoElevadoAAlfa) {
    const glm::vec3 P(0, 0, -4);
    for (const float alfa : {1.0f, 5.0f, 20.0f, 100.0f, 500.0f}) {
        double maximo = 0;
        for (int grados10 = 0; grados10 <= 900; grados10 += 5) {
            const double phi = grados10 * PI / 1800; // entre R y V = (0, 0, 1)
            const glm::vec3 N(std::sin(phi / 2), 0, std::cos(phi / 2));
            const Material m = {glm::vec3(0), glm::vec3(0), glm::vec3(1), alfa};
            const double brillo = phong(m, Luz{{0, 0, 1, 0}}, P, N).x;
            maximo = std::max(maximo, 255 * std::fabs(brillo - std::pow(std::cos(phi), alfa)));
        }
        std::cout << "alfa " << alfa << ": error máximo " << maximo << " niveles\n";
        EXPECT_LE(maximo, 255 * 8 * (1 + alfa) * std::ldexp(1, -24));
    }
}

// Con R·V = 0 exacto y con R·V < 0: 0 elevado a 0 es 1, y una base negativa cuenta como 0. Lo que hace el pow
// del listado 5.1 con (0, 0) no está definido: se escribe, no se exige.
TEST_F(Sonda, CeroElevadoACero) {
    const glm::vec3 P(-1, 0, 0), N(0, 0, 1); // V = (1, 0, 0)
    const Luz enfrente{{-1, 0, 1, 1}};       // L = R = (0, 0, 1): R·V = 0
    const Luz detras{{0.6f, 0, 0.8f, 0}};    // R = (-0.6, 0, 0.8): R·V = -0.6
    for (const float alfa : {0.0f, 1e-3f, 1.0f, 3.0f, 500.0f}) {
        Material m = MATERIAL;
        m.alfa = alfa;
        const glm::vec3 brillo = alfa == 0 ? m.Ks : glm::vec3(0);
        EXPECT_LE(niveles(phong(m, enfrente, P, N), doble(m.Ka * LA + m.Kd + brillo)), 1e-3) << alfa;
        EXPECT_LE(niveles(phong(m, detras, P, N), doble(m.Ka * LA + 0.8f * m.Kd + brillo)), 1e-3) << alfa;
        std::cout << "alfa " << alfa << ", R·V = 0: el listado 5.1 da "
                  << texto(phongListado(m, enfrente, P, N)) << "\n";
    }
}

TEST_F(Sonda, AlfaCeroEsUnBrilloConstante) {
    Material m = MATERIAL;
    m.alfa = 0;
    for (const float x : {0.0f, 0.3f, 0.9f}) {
        const Luz luz{{x, 0, 1, 0}};
        const double NL = 1 / std::sqrt(1 + static_cast<double>(x) * x);
        EXPECT_LE(niveles(phong(m, luz, {0, 0, -3}, {0, 0, 1}), doble(m.Ka * LA + m.Ks) + NL * doble(m.Kd)),
                  1e-3)
            << x;
    }
}

// De espaldas a la luz queda justo la luz ambiente. La ecuación 5.2 sin más restaría luz: L·N es negativo.
TEST_F(Sonda, DeEspaldasALaLuzSoloHayAmbiente) {
    const glm::vec3 P(0, 0, -3);
    for (const glm::vec4 Lp : {glm::vec4(0, 0, -1, 0), {1, 0, -0.01f, 0}, {1, 0, 0, 0}, {0, 0, -9, 1}})
        ESPERA_AMBIENTE(phong(MATERIAL, Luz{Lp}, P, {0, 0, 1})) << Lp.z;
    const double sinLimite = MATERIAL.Ka.z * LA.z + MATERIAL.Kd.z * -1.0;
    EXPECT_LT(sinLimite, 0) << "la ecuación 5.2 con L = (0, 0, -1)";
}

// En el propio punto de la luz no hay dirección L: queda la luz ambiente, también si a = 0.
TEST_F(Sonda, LaFuenteEnElPropioPunto) {
    const glm::vec3 P(0.3f, -0.2f, -3);
    for (const glm::vec3 abc : {glm::vec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}) {
        Luz luz{glm::vec4(P, 1)};
        luz.atenuacion = abc;
        ESPERA_AMBIENTE(phong(MATERIAL, luz, P, {0, 0, 1}));
        luz.cosDelta = 0.9f, luz.exponente = 0;
        ESPERA_AMBIENTE(phong(MATERIAL, luz, P, {0, 0, 1}));
    }
}

// Cada vez más cerca, con a = 0: crece hasta saturar, sin infinitos; un coeficiente nulo sigue dando 0 y no
// NaN, tampoco cuando c·d² se anula antes que d.
TEST_F(Sonda, AtenuacionCuandoLaDistanciaTiendeACero) {
    for (const glm::vec3 abc : {glm::vec3(0, 1, 0), {0, 0, 1}, {0, 0, 0.1f}}) {
        float anterior = 0;
        for (int e = 0; e >= -440; --e) {
            const float d = static_cast<float>(std::pow(10, e / 10.0));
            Luz luz{{0, 0, d, 1}};
            luz.atenuacion = abc;
            const glm::vec3 c = phong(MATERIAL, luz, {0, 0, 0}, {0, 0, 1});
            ASSERT_TRUE(finito(c)) << d << ": " << texto(c);
            EXPECT_EQ(c.y, MATERIAL.Ka.y * LA.y) << d; // Kd.y = 0; en P = 0 no hay V, ni brillo
            const double exacta = MATERIAL.Ka.x * LA.x + MATERIAL.Kd.x / (abc.y * d + abc.z * d * d);
            EXPECT_TRUE(exacta > 1e4 || std::fabs(c.x / exacta - 1) < 1e-5) << d;
            EXPECT_TRUE(d < 1e-18f || c.x >= anterior) << d; // por debajo, d al cuadrado es 0 en float
            anterior = c.x;
        }
    }
    Luz sinCoeficientes{{0, 0, 1, 1}};
    sinCoeficientes.atenuacion = glm::vec3(0);
    const glm::vec3 c = phong(MATERIAL, sinCoeficientes, {0, 0, 0}, {0, 0, 1});
    EXPECT_TRUE(finito(c) && c.x > 1 && c.y == MATERIAL.Ka.y * LA.y) << texto(c);
}

TEST_F(Sonda, AtenuacionMuyLejos) {
    for (const float d : {1e3f, 1e6f, 1e10f, 1e18f})
        for (const glm::vec3 abc : {glm::vec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}}) {
            Luz luz{{0, 0, d, 1}};
            luz.atenuacion = abc;
            const glm::vec3 c = phong(MATERIAL, luz, {0, 0, -2}, {0, 0, 1});
            ASSERT_TRUE(finito(c)) << d;
            EXPECT_LE(niveles(c, exacto(MATERIAL, luz, {0, 0, -2}, {0, 0, 1})), 1e-3) << d;
        }
}

// Una luz direccional no se atenúa, y su vector puede tener cualquier longitud.
TEST_F(Sonda, LaDireccionalNoSeAtenua) {
    for (const float k : {1e-15f, 1e-6f, 1.0f, 1e6f, 1e15f})
        for (const glm::vec3 abc : {glm::vec3(1, 0, 0), {0, 0, 0}, {9, 9, 9}})
            for (const glm::vec3 P : {glm::vec3(0, 0, -2), {5, -7, -40}}) {
                Luz luz{glm::vec4(k * glm::vec3(0.3f, 0.5f, 1), 0)};
                luz.atenuacion = abc;
                EXPECT_LE(niveles(phong(MATERIAL, luz, P, {0, 0, 1}), exacto(MATERIAL, luz, P, {0, 0, 1})),
                          1e-2)
                    << k;
            }
}

// La normal interpolada no es unitaria: su longitud no cambia nada. Sin normal, queda la luz ambiente.
TEST_F(Sonda, LaNormalNoTieneQueSerUnitaria) {
    const glm::vec3 P(0.5f, 0.2f, -3), N = glm::normalize(glm::vec3(0.2f, 0.3f, 1));
    const Luz luz{{1, 2, 1, 1}};
    for (const float k : {1e-15f, 0.1f, 0.707f, 1.001f, 2.0f, 1e15f})
        EXPECT_LE(niveles(phong(MATERIAL, luz, P, k * N), exacto(MATERIAL, luz, P, N)), 1e-2) << k;
    ESPERA_AMBIENTE(phong(MATERIAL, luz, P, glm::vec3(0)));
    for (const float k : {1e-20f, 1e-30f, 1e-40f})
        ESPERA_AMBIENTE(phong(MATERIAL, luz, P, k * N)); // el cuadrado de su longitud es 0 en float
}

// Listado 5.3: N, L y V llegan interpolados. A mitad de una arista cuyas normales forman 90 grados, N mide
// 0.71.
TEST_F(Sonda, ElListado53SinNormalizarOscurece) {
    const glm::vec3 P(0, 0, -3),
        N = 0.5f * (glm::normalize(glm::vec3(-1, 0, 1)) + glm::normalize(glm::vec3(1, 0, 1)));
    const Luz luz{{0, 0, 1, 1}};
    const oraculo::Vec3 ref = exacto(MATERIAL, luz, P, {0, 0, 1});
    const double listado53 = niveles(phongListado(MATERIAL, luz, P, N), ref);
    std::cout << "N interpolada: el listado 5.3 se aparta " << listado53 << " niveles\n";
    EXPECT_GT(listado53, 20);
    EXPECT_LE(niveles(phong(MATERIAL, luz, P, N), ref), 1e-2);
}

// Listado 5.3: L = vec3(normalize(Lp - ecPosition)), en cuatro dimensiones, solo vale si Lp.w = 1. Con una
// direccional la diferencia tiene w = -1, y L ni es unitario ni es la dirección de la luz.
TEST_F(Sonda, ElListado53NoValeParaUnaDireccional) {
    const glm::vec3 P(2, 1, -5), N(0, 0, 1);
    const Luz posicional{{3, 4, 2, 1}}, direccional{{0.6f, 0, 0.8f, 0}};
    EXPECT_LE(niveles(phongListado(MATERIAL, posicional, P, N), exacto(MATERIAL, posicional, P, N)), 0.1);
    const oraculo::Vec3 ref = exacto(MATERIAL, direccional, P, N);
    const double listado53 = niveles(phongListado(MATERIAL, direccional, P, N), ref);
    std::cout << "direccional: el listado 5.3 se aparta " << listado53 << " niveles\n";
    EXPECT_GT(listado53, 10);
    EXPECT_LE(niveles(phong(MATERIAL, direccional, P, N), ref), 1e-2);
}

namespace {

/// Un foco en el origen que apunta a -Z, y un punto a `angulo` del eje, de cara a él.
struct EnElFoco {
    Luz luz{{0, 0, 0, 1}};
    glm::vec3 P, N;
    EnElFoco(double delta, double exponente, double angulo) {
        luz.cosDelta = std::cos(static_cast<float>(delta)); // como los programas
        luz.exponente = static_cast<float>(exponente);
        P = 3.0f * glm::vec3(std::sin(angulo), 0, -std::cos(angulo));
        N = -P;
    }
};

} // namespace

// El borde del cono, a 1e-5 rad a una y otra parte del ángulo exacto.
TEST_F(Sonda, BordeDelConoContraElAnguloExacto) {
    for (const double grados : {1.0, 5.0, 20.0, 45.0, 60.0, 80.0, 89.0, 90.0}) {
        const double delta = grados * PI / 180, holgura = 1e-5;
        const EnElFoco dentro(delta, 0, delta - holgura), fuera(delta, 0, delta + holgura);
        EXPECT_LE(niveles(phong(MATERIAL, dentro.luz, dentro.P, dentro.N),
                          doble(MATERIAL.Ka * LA + MATERIAL.Kd + MATERIAL.Ks)),
                  1e-2)
            << grados;
        ESPERA_AMBIENTE(phong(MATERIAL, fuera.luz, fuera.P, fuera.N)) << grados;
    }
}

// Con delta = 0 solo queda el eje (lo que mide un float: 3.5e-4 rad); nunca un NaN.
TEST_F(Sonda, ConoDeCeroGrados) {
    const EnElFoco eje(0, 1, 0);
    EXPECT_LE(
        niveles(phong(MATERIAL, eje.luz, eje.P, eje.N), doble(MATERIAL.Ka * LA + MATERIAL.Kd + MATERIAL.Ks)),
        1e-2);
    for (const double angulo : {1e-3, 1e-2, 0.5, PI / 2, PI - 1e-3, PI}) {
        const EnElFoco fuera(0, 1, angulo);
        ESPERA_AMBIENTE(phong(MATERIAL, fuera.luz, fuera.P, fuera.N)) << angulo;
    }
}

// Con delta = 90 grados el coseno en float es -4.4e-8: sigue siendo un foco, que alumbra medio espacio, y con
// exponente llega a 0 sin escalón.
TEST_F(Sonda, ConoDeNoventaGrados) {
    EXPECT_LT(std::cos(static_cast<float>(PI / 2)), 0);
    for (const double exponente : {0.0, 1.0, 10.0})
        for (const double angulo : {0.0, 0.7, 1.5, PI / 2 - 1e-5, PI / 2 + 1e-5, 2.0, PI}) {
            const EnElFoco f(PI / 2, exponente, angulo);
            const glm::vec3 c = phong(MATERIAL, f.luz, f.P, f.N);
            ASSERT_TRUE(finito(c));
            const double factor = angulo > PI / 2 ? 0 : std::pow(std::cos(angulo), exponente);
            EXPECT_LE(niveles(c, doble(MATERIAL.Ka * LA) + factor * doble(MATERIAL.Kd + MATERIAL.Ks)), 1e-2)
                << exponente << " a " << angulo;
        }
}

// Lo que no es un foco alumbra también justo detrás de S, donde el coseno en float puede ser menor que -1.
TEST_F(Sonda, LoQueNoEsUnFocoNoMiraElCono) {
    for (int i = 0; i < 200; ++i) {
        EnElFoco f(0, 0, 0.01 * i);
        f.luz.cosDelta = -1;
        f.luz.S = -glm::normalize(f.P);
        EXPECT_LE(
            niveles(phong(MATERIAL, f.luz, f.P, f.N), doble(MATERIAL.Ka * LA + MATERIAL.Kd + MATERIAL.Ks)),
            1e-2)
            << i;
    }
}

// §5.2 compara con delta el ángulo entre L y S. L va del punto a la luz: en el eje de un foco que apunta
// hacia el punto ese ángulo es de 180 grados, y lo iluminado sería lo que queda a su espalda. El que vale es
// el de -L y S.
TEST_F(Sonda, ElFocoAlumbraHaciaDondeApunta) {
    const EnElFoco delante(0.5, 2, 0.1), detras(0.5, 2, PI - 0.1);
    const oraculo::Vec3 L = oraculo::unitario(-doble(delante.P));
    EXPECT_GT(std::acos(oraculo::escalar(L, {0, 0, -1})), 3.0) << "el ángulo entre L y S, en el eje";
    EXPECT_LE(niveles(phong(MATERIAL, delante.luz, delante.P, delante.N),
                      exacto(MATERIAL, delante.luz, delante.P, delante.N, 0.5)),
              1e-2);
    ESPERA_AMBIENTE(phong(MATERIAL, detras.luz, detras.P, detras.N));
}
