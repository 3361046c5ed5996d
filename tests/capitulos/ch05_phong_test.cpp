// phong.glsl con entradas sueltas: una sonda lo ejecuta en la GPU y devuelve el color en float, sin recortar ni redondear. Se compara
// con el oráculo en doble precisión y se prueban los casos difíciles de GLSL.
#include "azar.h"
#include "ch05_iluminacion/iluminacion.h"
#include "contra_oraculo.h"
#include "sonda.h"

namespace {

using oraculo::Vec3;

const double PI = oraculo::PI;
const Material MATERIAL = {{0.10f, 0.20f, 0.05f}, {0.50f, 0.0f, 0.70f}, {0.60f, 0.40f, 0.0f}, 8};
const glm::vec3 LA(0.5f), AMBIENTE = MATERIAL.Ka * LA, DE_CARA = AMBIENTE + MATERIAL.Kd + MATERIAL.Ks;

/// phong() de phong.glsl.
glm::vec3 phong(const Material &m, const Luz &luz, const glm::vec3 &P, const glm::vec3 &N) {
    static const GLuint programa = creaSonda("tests/capitulos/ch05_sonda.frag");
    glUseProgram(programa);
    envia(programa, "La", LA);
    envia(programa, "P", P);
    envia(programa, "N", N);
    enviaMaterial(programa, m);
    enviaLuz(programa, "luz", luz, glm::mat4(1));
    return glm::vec3(leeSonda());
}

/// phong() de los listados 5.1 y 5.3.
glm::vec3 listado(const Material &m, const Luz &luz, const glm::vec3 &P, const glm::vec3 &N) {
    static const GLuint programa = creaSonda("tests/capitulos/ch05_listado.frag");
    glUseProgram(programa);
    for (const auto &[nombre, color] :
         {std::pair("Ka", m.Ka), {"Kd", m.Kd}, {"Ks", m.Ks}, {"La", LA}, {"Ld", luz.Ld}, {"Ls", luz.Ls}})
        envia(programa, nombre, glm::vec4(color, 1));
    envia(programa, "Lp", luz.Lp);
    envia(programa, "alfa", m.alfa);
    envia(programa, "P", P);
    envia(programa, "N", N);
    return glm::vec3(leeSonda());
}

/// Lo mismo, en doble precisión.
Vec3 enDoble(const Material &m, const Luz &luz, const glm::vec3 &P, const glm::vec3 &N) {
    const Vec3 Lp = exacto(glm::vec3(luz.Lp));
    oraculo::Luz l = foco(Lp, Lp + exacto(luz.S), std::acos(double(luz.cosDelta)), luz.exponente);
    l.foco = luz.cosDelta > -1;
    l.w = luz.Lp.w;
    l.Ld = exacto(luz.Ld);
    l.Ls = exacto(luz.Ls);
    l.a = luz.atenuacion.x;
    l.b = luz.atenuacion.y;
    l.c = luz.atenuacion.z;
    return oraculo::phong({exacto(m.Ka), exacto(m.Kd), exacto(m.Ks), m.alfa}, exacto(LA), {l}, exacto(P),
                          unitario(exacto(N)), unitario(-exacto(P)));
}

/// Mayor diferencia, en niveles de 255, entre los colores que se verían; infinita si alguno no es finito.
double niveles(const glm::vec3 &gpu, const Vec3 &ref) {
    double mayor = std::isfinite(gpu.x + gpu.y + gpu.z) ? 0 : oraculo::INFINITO;
    for (int k = 0; k < 3; ++k)
        mayor = std::max(
            mayor, 255 * std::fabs(glm::clamp(double(gpu[k]), 0.0, 1.0) - glm::clamp(ref[k], 0.0, 1.0)));
    return mayor;
}
double lejosDelDoble(const Luz &luz, const glm::vec3 &P, const glm::vec3 &N, const Material &m = MATERIAL) {
    return niveles(phong(m, luz, P, N), enDoble(m, luz, P, N));
}

// Puntos, normales, materiales y luces de los tres tipos, al azar. Donde el modelo salta (el borde del cono, L·N = 0) la sonda puede
// caer al otro lado: se apartan 1e-4 rad. Medio nivel es lo que ya cuesta guardarlo en 8 bits.
TEST(Sonda, ContraDobleEnMilesDePuntosAlAzar) {
    Azar azar(5);
    const auto color = [&](float medio) { return azar.vector(medio) + medio; };
    const float alfas[] = {0, 0.5f, 1, 5, 20, 100, 500};
    int comparados = 0;
    for (int i = 0; i < 4000; ++i) {
        const glm::vec3 P = glm::vec3(0, 0, -8) + azar.vector(3);
        const float largo = azar.entre(0.3f, 3.0f);
        const glm::vec3 N = largo * glm::normalize(azar.vector(1) + glm::vec3(0, 0, 1));
        const Material m = {color(0.2f), color(0.3f), color(0.3f), alfas[i % 7]};
        Luz luz{glm::vec4(azar.vector(6), i % 3 != 0)};
        luz.Ld = color(0.5f);
        luz.Ls = color(0.5f);
        luz.atenuacion = {azar.entre(0.0f, 1.0f), azar.entre(0.0f, 0.3f), azar.entre(0.01f, 0.1f)};
        const Vec3 L = unitario(exacto(glm::vec3(luz.Lp) - luz.Lp.w * P));
        double delta = -1, angulo = 0;
        if (i % 3 == 2) {
            delta = azar.entre(0.02, PI / 2);
            luz.S = glm::normalize(P - glm::vec3(luz.Lp) + azar.vector(2));
            luz.cosDelta = float(std::cos(delta));
            luz.exponente = azar.entre(0.0f, 30.0f);
            angulo = std::atan2(longitud(vectorial(L, exacto(luz.S))), -escalar(L, exacto(luz.S)));
        }
        if (std::fabs(angulo - delta) < 1e-4 || std::fabs(escalar(L, unitario(exacto(N)))) < 1e-4)
            continue;
        EXPECT_LE(lejosDelDoble(luz, P, N, m), 0.5) << i << ", alfa " << m.alfa;
        ++comparados;
    }
    EXPECT_GT(comparados, 3900);
}

// El perfil del brillo, de 0 a 90 grados, para cada alfa de la figura 5.3. La cota: un error relativo e en R·V es alfa·e en su potencia,
// y R·V lleva unos 8 redondeos de 2^-24.
TEST(Sonda, PerfilDelBrilloContraCosenoElevadoAAlfa) {
    for (const float alfa : {1.0f, 5.0f, 20.0f, 100.0f, 500.0f})
        for (double grados = 0; grados <= 90; grados += 0.5) {
            const double phi = grados * PI / 180; // entre R y V = (0, 0, 1)
            const glm::vec3 N(std::sin(phi / 2), 0, std::cos(phi / 2));
            const Material soloBrillo = {glm::vec3(0), glm::vec3(0), glm::vec3(1), alfa};
            const double brillo = phong(soloBrillo, Luz{{0, 0, 1, 0}}, {0, 0, -4}, N).x;
            EXPECT_LE(std::fabs(brillo - std::pow(std::cos(phi), alfa)), 8 * (1 + alfa) * 0x1p-24)
                << "alfa " << alfa << " a " << grados;
        }
}

// Con R·V = 0 exacto y con R·V < 0: 0 elevado a 0 es 1, y una base negativa cuenta como 0. Lo que hace el pow del listado 5.1 con (0, 0)
// no está definido.
TEST(Sonda, CeroElevadoACero) {
    const glm::vec3 P(-1, 0, 0), N(0, 0, 1);  // V = (1, 0, 0)
    const glm::vec4 enfrente(-1, 0, 1, 1);    // L = R = (0, 0, 1): R·V = 0
    const glm::vec4 detras(0.6f, 0, 0.8f, 0); // R = (-0.6, 0, 0.8): R·V = -0.6
    for (const float alfa : {0.0f, 1e-3f, 1.0f, 3.0f, 500.0f})
        for (const glm::vec4 &Lp : {enfrente, detras}) {
            Material m = MATERIAL;
            m.alfa = alfa;
            const glm::vec3 esperado = AMBIENTE + Lp.z * m.Kd + (alfa == 0 ? m.Ks : glm::vec3(0));
            EXPECT_LE(niveles(phong(m, Luz{Lp}, P, N), exacto(esperado)), 1e-3) << alfa;
        }
}

TEST(Sonda, AlfaCeroEsUnBrilloConstante) {
    Material m = MATERIAL;
    m.alfa = 0;
    for (const double x : {0.0, 0.3, 0.9})
        EXPECT_LE(lejosDelDoble(Luz{{x, 0, 1, 0}}, {0, 0, -3}, {0, 0, 1}, m), 1e-3) << x;
}

// De espaldas a la luz queda justo la luz ambiente. La ecuación 5.2 sin más restaría luz: L·N es negativo.
TEST(Sonda, DeEspaldasALaLuzSoloHayAmbiente) {
    for (const glm::vec4 Lp : {glm::vec4(0, 0, -1, 0), {1, 0, -0.01f, 0}, {1, 0, 0, 0}, {0, 0, -9, 1}})
        EXPECT_EQ(phong(MATERIAL, Luz{Lp}, {0, 0, -3}, {0, 0, 1}), AMBIENTE) << Lp.z;
    EXPECT_LT(AMBIENTE.z - MATERIAL.Kd.z, 0) << "la ecuación 5.2 con L = (0, 0, -1)";
}

// En el propio punto de la luz no hay dirección L: queda la luz ambiente, también si a = 0.
TEST(Sonda, LaFuenteEnElPropioPunto) {
    const glm::vec3 P(0.3f, -0.2f, -3);
    for (const glm::vec3 abc : {glm::vec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}) {
        Luz luz{glm::vec4(P, 1)};
        luz.atenuacion = abc;
        EXPECT_EQ(phong(MATERIAL, luz, P, {0, 0, 1}), AMBIENTE);
        luz.cosDelta = 0.9f;
        luz.exponente = 0;
        EXPECT_EQ(phong(MATERIAL, luz, P, {0, 0, 1}), AMBIENTE);
    }
}

// Cada vez más cerca, con a = 0: crece hasta saturar, sin infinitos; un coeficiente nulo sigue dando 0 y no NaN, tampoco cuando c·d² se
// anula antes que d.
TEST(Sonda, AtenuacionCuandoLaDistanciaTiendeACero) {
    const auto aDistancia = [](float d, const glm::vec3 &abc) {
        Luz luz{{0, 0, d, 1}};
        luz.atenuacion = abc;
        const glm::vec3 c = phong(MATERIAL, luz, {0, 0, 0}, {0, 0, 1});
        EXPECT_TRUE(std::isfinite(c.x + c.z)) << d;
        EXPECT_EQ(c.y, AMBIENTE.y) << d; // Kd.y = 0; en P = 0 no hay V, ni brillo
        return c.x;
    };
    for (const glm::vec3 abc : {glm::vec3(0, 1, 0), {0, 0, 1}, {0, 0, 0.1f}}) {
        float anterior = 0;
        for (int e = 0; e >= -440; --e) {
            const float d = float(std::pow(10, e / 10.0)), c = aDistancia(d, abc);
            const double esperado = AMBIENTE.x + MATERIAL.Kd.x / (abc.y * d + abc.z * d * d);
            EXPECT_TRUE(esperado > 1e4 || std::fabs(c / esperado - 1) < 1e-5) << d;
            EXPECT_TRUE(d < 1e-18f || c >= anterior) << d; // por debajo, d al cuadrado es 0 en float
            anterior = c;
        }
    }
    EXPECT_GT(aDistancia(1, glm::vec3(0)), 1);
}

TEST(Sonda, AtenuacionMuyLejos) {
    for (const float d : {1e3f, 1e6f, 1e10f, 1e18f})
        for (const glm::vec3 abc : {glm::vec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}}) {
            Luz luz{{0, 0, d, 1}};
            luz.atenuacion = abc;
            EXPECT_LE(lejosDelDoble(luz, {0, 0, -2}, {0, 0, 1}), 1e-3) << d;
        }
}

// Una luz direccional no se atenúa, y su vector puede tener cualquier longitud.
TEST(Sonda, LaDireccionalNoSeAtenua) {
    for (const float k : {1e-15f, 1e-6f, 1.0f, 1e6f, 1e15f})
        for (const glm::vec3 abc : {glm::vec3(1, 0, 0), {0, 0, 0}, {9, 9, 9}})
            for (const glm::vec3 P : {glm::vec3(0, 0, -2), {5, -7, -40}}) {
                Luz luz{glm::vec4(k * glm::vec3(0.3f, 0.5f, 1), 0)};
                luz.atenuacion = abc;
                EXPECT_LE(lejosDelDoble(luz, P, {0, 0, 1}), 1e-2) << k;
            }
}

// La normal interpolada no es unitaria: su longitud no cambia nada. Sin normal, o si el cuadrado de su longitud es 0 en float, queda la
// luz ambiente.
TEST(Sonda, LaNormalNoTieneQueSerUnitaria) {
    const glm::vec3 P(0.5f, 0.2f, -3), N = glm::normalize(glm::vec3(0.2f, 0.3f, 1));
    const Luz luz{{1, 2, 1, 1}};
    for (const float k : {1e-15f, 0.1f, 0.707f, 1.001f, 2.0f, 1e15f})
        EXPECT_LE(lejosDelDoble(luz, P, k * N), 1e-2) << k;
    for (const float k : {0.0f, 1e-20f, 1e-30f, 1e-40f})
        EXPECT_EQ(phong(MATERIAL, luz, P, k * N), AMBIENTE) << k;
}

// Listado 5.3: N, L y V llegan interpolados. A mitad de una arista cuyas normales forman 90 grados, N mide 0.71.
TEST(Sonda, ElListado53SinNormalizarOscurece) {
    const glm::vec3 P(0, 0, -3), N(0, 0, std::sqrt(0.5f));
    const Luz luz{{0, 0, 1, 1}};
    const Vec3 ref = enDoble(MATERIAL, luz, P, {0, 0, 1});
    EXPECT_GT(niveles(listado(MATERIAL, luz, P, N), ref), 20);
    EXPECT_LE(niveles(phong(MATERIAL, luz, P, N), ref), 1e-2);
}

// Listado 5.3: L = vec3(normalize(Lp - ecPosition)), en cuatro dimensiones, solo vale si Lp.w = 1. Con una direccional la diferencia
// tiene w = -1, y L ni es unitario ni es la dirección de la luz.
TEST(Sonda, ElListado53NoValeParaUnaDireccional) {
    const glm::vec3 P(2, 1, -5), N(0, 0, 1);
    const Luz cercana{{3, 4, 2, 1}}, lejana{{0.6f, 0, 0.8f, 0}};
    const Vec3 ref = enDoble(MATERIAL, lejana, P, N);
    EXPECT_LE(niveles(listado(MATERIAL, cercana, P, N), enDoble(MATERIAL, cercana, P, N)), 0.1);
    EXPECT_GT(niveles(listado(MATERIAL, lejana, P, N), ref), 10);
    EXPECT_LE(lejosDelDoble(lejana, P, N), 1e-2);
}

/// Un foco en el origen que apunta a -Z, y un punto a ese ángulo de su eje: de cara a él, la normal es -P.
Luz enElOrigen(double delta, double exponente) {
    Luz luz{{0, 0, 0, 1}};
    luz.cosDelta = std::cos(float(delta)); // como los programas
    luz.exponente = float(exponente);
    return luz;
}
glm::vec3 aAngulo(double angulo) {
    return 3.0f * glm::vec3(std::sin(angulo), 0, -std::cos(angulo));
}
glm::vec3 phong(const Luz &luz, double angulo) {
    return phong(MATERIAL, luz, aAngulo(angulo), -aAngulo(angulo));
}

// El borde del cono, a 1e-5 rad a una y otra parte del ángulo exacto.
TEST(Sonda, BordeDelConoContraElAnguloExacto) {
    for (const double grados : {1.0, 5.0, 20.0, 45.0, 60.0, 80.0, 89.0, 90.0}) {
        const double delta = grados * PI / 180, holgura = 1e-5;
        EXPECT_LE(niveles(phong(enElOrigen(delta, 0), delta - holgura), exacto(DE_CARA)), 1e-2) << grados;
        EXPECT_EQ(phong(enElOrigen(delta, 0), delta + holgura), AMBIENTE) << grados;
    }
}

// Con delta = 0 solo queda el eje (lo que mide un float: 3.5e-4 rad); nunca un NaN.
TEST(Sonda, ConoDeCeroGrados) {
    EXPECT_LE(niveles(phong(enElOrigen(0, 1), 0), exacto(DE_CARA)), 1e-2);
    for (const double angulo : {1e-3, 1e-2, 0.5, PI / 2, PI - 1e-3, PI})
        EXPECT_EQ(phong(enElOrigen(0, 1), angulo), AMBIENTE) << angulo;
}

// Con delta = 90 grados el coseno en float es -4.4e-8: sigue siendo un foco, que alumbra medio espacio, y con exponente llega a 0 sin
// escalón.
TEST(Sonda, ConoDeNoventaGrados) {
    EXPECT_LT(std::cos(float(PI / 2)), 0);
    for (const double exponente : {0.0, 1.0, 10.0})
        for (const double angulo : {0.0, 0.7, 1.5, PI / 2 - 1e-5, PI / 2 + 1e-5, 2.0, PI}) {
            const glm::vec3 P = aAngulo(angulo);
            EXPECT_LE(lejosDelDoble(enElOrigen(PI / 2, exponente), P, -P), 1e-2)
                << exponente << " a " << angulo;
        }
}

// Lo que no es un foco alumbra también justo detrás de S, donde el coseno en float puede ser menor que -1.
TEST(Sonda, LoQueNoEsUnFocoNoMiraElCono) {
    for (int i = 0; i < 200; ++i) {
        Luz luz{{0, 0, 0, 1}};
        luz.S = -glm::normalize(aAngulo(0.01 * i));
        EXPECT_LE(niveles(phong(luz, 0.01 * i), exacto(DE_CARA)), 1e-2) << i;
    }
}

// §5.2 compara con delta el ángulo entre L y S. L va del punto a la luz: en el eje de un foco que apunta hacia el punto ese ángulo es de
// 180 grados, y lo iluminado sería lo que queda a su espalda. El que vale es el de -L y S.
TEST(Sonda, ElFocoAlumbraHaciaDondeApunta) {
    const glm::vec3 P = aAngulo(0.1);
    EXPECT_GT(std::acos(escalar(unitario(-exacto(P)), {0, 0, -1})), 3.0)
        << "el ángulo entre L y S, en el eje";
    EXPECT_LE(lejosDelDoble(enElOrigen(0.5, 2), P, -P), 1e-2);
    EXPECT_EQ(phong(enElOrigen(0.5, 2), PI - 0.1), AMBIENTE);
}

} // namespace
