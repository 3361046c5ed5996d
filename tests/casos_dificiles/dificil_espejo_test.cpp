// Casos difíciles del capítulo 7: el plano del espejo.
#include "ch07_realismo/reflexion.h"
#include "cota.h"
#include "ejecuta.h"
#include "guiones.h"

namespace {

using testing::ExitedWithCode;

const glm::vec3 V(2.0f / 3, -1.0f / 3, 2.0f / 3), P(1, 2, -3);

const Cotas ESPEJO([] {
    const std::vector<Con<float>> largos = {1e-38f, 1e-20f, 1, 1.001f, 2, 1e20f, 3e38f};
    // la simetría de un punto a 10 unidades, contra la de V unitaria: unos 10 redondeos de 10
    acotaCada<float>("Espejo", "normal_de_longitud_*", largos, 100 * U_FLOAT, "unidades", [](float k) {
        const glm::dvec3 v = glm::normalize(glm::dvec3(V)), x(3, -5, 8);
        const glm::dvec3 exacto = x - 2 * glm::dot(v, x - glm::dvec3(P)) * v;
        return glm::distance(glm::dvec3(reflexion(planoPor(P, k * V)) * glm::vec4(glm::vec3(x), 1)), exacto);
    });
    acota("Espejo", "el_sentido_de_giro_se_invierte", 20 * U_FLOAT, "det + 1",
          [] { return std::fabs(glm::determinant(glm::dmat4(reflexion(planoPor(P, V)))) + 1); });
    // Con el ojo en el plano del espejo, que visto así es una raya: de la órbita de partida hay que girar 1.0498 rad,
    // 52.5 píxeles en una ventana de 90 de alto.
    acotaCada<int>("Espejo", "ojo_en_el_plano_*", {52, 53}, 0, "estado", [](int pixeles) {
        const Ejecucion e = ejecuta("espejo", arrastra({60, 30}, {60 + pixeles, 30}), 120, 90);
        EXPECT_EQ(e.errores, "");
        return e.estado;
    });
});

} // namespace

// Un plano sin perpendicular termina con un mensaje.
TEST(EspejoImposibleDeathTest, PerpendicularNulaNaNOInfinita) {
    for (const float x : {0.0f, NAN, INFINITY})
        EXPECT_EXIT(planoPor(P, {x, 0, 0}), ExitedWithCode(1), "perpendicular que no sea nula");
}
