// Casos difíciles del capítulo 7: el plano del espejo y la sombra proyectada.
#include "ch07_realismo/sombra.h"
#include "cota.h"
#include "ejecuta.h"
#include "guiones.h"

namespace {

using testing::ExitedWithCode;

double involucion(const glm::mat4 &M) {
    return mayorComponente(M * M - glm::mat4(1));
}
const glm::vec3 V(2.0f / 3, -1.0f / 3, 2.0f / 3), P(1, 2, -3);

const Cotas ESPEJO([] {
    const std::vector<Con<float>> largos = {1e-38f, 1e-20f, 1, 1.001f, 2, 1e20f, 3e38f};
    // la simetría de un punto a 10 unidades, contra la de V unitaria: unos 10 redondeos de 10
    acotaCada<float>("Espejo", "normal_de_longitud_*", largos, 100 * U_FLOAT, "unidades", [](float k) {
        const glm::dvec3 v = glm::normalize(glm::dvec3(V)), x(3, -5, 8);
        const glm::dvec3 exacto = x - 2 * glm::dot(v, x - glm::dvec3(P)) * v;
        return glm::distance(glm::dvec3(reflexion(planoPor(P, k * V)) * glm::vec4(glm::vec3(x), 1)), exacto);
    });
    acotaCada<float>("Espejo", "M_por_M_con_longitud_*", largos, 50 * U_FLOAT, "M·M − I",
                     [](float k) { return involucion(reflexion(planoPor(P, k * V))); });
    // lo que da la ecuación 7.3 tal cual si V no es unitaria: M·M se aparta de I
    acota("Espejo", "sin_normalizar_no_es_simetria", 0.1, "1 / (M·M − I)", [] {
        return 1 / involucion(reflexion({2.0f * V, 1}));
    });
    acota("Espejo", "ojo_en_el_plano_es_su_reflejo", 20 * U_FLOAT, "unidades", [] {
        const Plano plano = planoPor(P, V);
        const glm::vec3 ojo =
            P + 3.0f * glm::cross(plano.N, glm::vec3(0, 1, 0)) + glm::cross(plano.N, glm::vec3(1, 0, 0));
        return glm::distance(glm::vec3(reflexion(plano) * glm::vec4(ojo, 1)), ojo);
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

const Plano SUELO = {{0, 1, 0}, 0};

/// La sombra de un punto en el suelo, en coordenadas homogéneas.
glm::vec4 sombra(const glm::vec4 &luz, const glm::vec3 &x) {
    return proyeccionSombra(luz, SUELO) * glm::vec4(x, 1);
}
glm::vec3 euclidea(const glm::vec4 &q) {
    return glm::vec3(q) / q.w;
}

const Cotas SOMBRA([] {
    const glm::vec4 enElPlano(3, 0, 1, 1), a4(0, 4, 0, 1);
    acota("Sombra", "luz_en_el_plano_altura", 0, "altura", [=] { return alturaLuz(enElPlano, SUELO); });
    acota("Sombra", "luz_en_el_plano_es_finita", 0, "no",
          [=] { return std::isfinite(mayorComponente(proyeccionSombra(enElPlano, SUELO))) ? 0 : 1; });
    // todo va a la propia luz: no hay sombra, y w = 0 en el plano
    acota("Sombra", "luz_en_el_plano_w_de_un_punto_del_plano", 0, "w", [=] {
        return std::fabs(sombra(enElPlano, {7, 0, -2}).w);
    });
    acotaCada<float>("Sombra", "objeto_sobre_la_luz_a_*_w_negativa", {4.001f, 5, 100}, 0, "w", [=](float y) {
        return sombra(a4, {1, y, 1}).w;
    });
    acota("Sombra", "objeto_a_la_altura_de_la_luz_w_0", 0, "w", [=] {
        return std::fabs(sombra(a4, {1, 4, 1}).w);
    });
    acota("Sombra", "objeto_en_el_plano_no_se_mueve", 4 * U_FLOAT, "unidades", [] {
        const glm::vec3 x(3, 0, 5);
        return glm::distance(euclidea(sombra({1, 4, -2, 1}, x)), x);
    });
    // una luz cada vez más lejos es una direccional: 1/lejos, y el redondeo
    acotaCada<float>(
        "Sombra", "luz_a_*_como_direccional", {1e3f, 1e6f, 1e18f},
        [](float lejos) { return 4.0 / lejos + 16 * U_FLOAT; }, "unidades",
        [](float lejos) {
            const glm::vec3 hacia(0.6f, 0.8f, 0), x(1, 0.5f, 2);
            return glm::distance(euclidea(sombra(glm::vec4(lejos * hacia, 1), x)),
                                 euclidea(sombra(glm::vec4(hacia, 0), x)));
        });
});

} // namespace

// Un plano sin perpendicular termina con un mensaje.
TEST(EspejoImposibleDeathTest, PerpendicularNulaNaNOInfinita) {
    for (const float x : {0.0f, NAN, INFINITY})
        EXPECT_EXIT(planoPor(P, {x, 0, 0}), ExitedWithCode(1), "perpendicular que no sea nula");
}
