// phong.glsl con entradas sueltas: una sonda lo ejecuta en la GPU y devuelve el color en float, sin recortar ni
// redondear.
#include "azar.h"
#include "ch05_iluminacion/iluminacion.h"
#include "contra_oraculo.h"
#include "sonda.h"

namespace {

using oraculo::Vec3;

const double PI = oraculo::PI;
const Material MATERIAL = {{0.10f, 0.20f, 0.05f}, {0.50f, 0.0f, 0.70f}, {0.60f, 0.40f, 0.0f}, 8};
const glm::vec3 LA(0.5f), AMBIENTE = MATERIAL.Ka * LA;

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

// Puntos, normales de cualquier longitud, materiales y luces de los tres tipos, al azar. Donde el modelo salta (el
// borde del cono, L·N = 0) la sonda puede caer al otro lado: se apartan 1e-4 rad. Medio nivel es lo que ya cuesta
// guardarlo en 8 bits.
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
        EXPECT_LE(niveles(phong(m, luz, P, N), enDoble(m, luz, P, N)), 0.5) << i << ", alfa " << m.alfa;
        ++comparados;
    }
    EXPECT_GT(comparados, 3900);
}

// De espaldas a la luz queda justo la luz ambiente. La ecuación 5.2 sin más restaría luz: L·N es negativo.
TEST(Sonda, DeEspaldasALaLuzSoloHayAmbiente) {
    for (const glm::vec4 Lp : {glm::vec4(0, 0, -1, 0), {1, 0, -0.01f, 0}, {1, 0, 0, 0}, {0, 0, -9, 1}})
        EXPECT_EQ(phong(MATERIAL, Luz{Lp}, {0, 0, -3}, {0, 0, 1}), AMBIENTE) << Lp.z;
}

// §5.2 compara con delta el ángulo entre L y S. L va del punto a la luz: en el eje de un foco que apunta hacia el punto
// ese ángulo es de 180 grados, y lo iluminado sería lo que queda a su espalda. El que vale es el de −L y S.
TEST(Sonda, ElFocoAlumbraHaciaDondeApunta) {
    Luz foco{{0, 0, 0, 1}};
    foco.cosDelta = std::cos(0.5f); // como los programas
    for (const bool delante : {false, true}) {
        const glm::vec3 P(0.3f, 0, delante ? -3 : 3);
        EXPECT_EQ(phong(MATERIAL, foco, P, -P) != AMBIENTE, delante);
    }
}

} // namespace
