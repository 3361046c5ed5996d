// Casos difíciles del capítulo 7: el plano del espejo y la sombra proyectada.
#include "caso.h"
#include "ch07_realismo/sombra.h"
#include "ejecuta.h"

namespace {

/// El mayor componente de M·M − I.
double involucion(const glm::mat4 &M) {
    const glm::mat4 MM = M * M;
    double peor = 0;
    for (int i = 0; i < 16; ++i)
        peor = mayor(std::fabs(static_cast<double>(MM[i / 4][i % 4]) - (i % 5 == 0)), peor);
    return peor;
}
const glm::vec3 V(2.0f / 3, -1.0f / 3, 2.0f / 3), P(1, 2, -3);

const Casos ESPEJO([] {
    for (const float k : {1e-38f, 1e-20f, 1.0f, 1.001f, 2.0f, 1e20f, 3e38f}) {
        const std::string nombre = enNombre(static_cast<double>(k));
        // la simetría de un punto a 10 unidades, contra la de V unitaria: unos 10 redondeos de 10
        caso("Espejo", "normal_de_longitud_" + nombre, 100 * U_FLOAT, "unidades", [=] {
            const glm::dvec3 v = glm::normalize(glm::dvec3(V)), x(3, -5, 8);
            const glm::dvec3 exacto = x - 2 * glm::dot(v, x - glm::dvec3(P)) * v;
            return glm::distance(glm::dvec3(reflexion(planoPor(P, k * V)) * glm::vec4(glm::vec3(x), 1)),
                                 exacto);
        });
        caso("Espejo", "M_por_M_con_longitud_" + nombre, 50 * U_FLOAT, "M·M − I",
             [=] { return involucion(reflexion(planoPor(P, k * V))); });
    }
    // lo que da la ecuación 7.3 tal cual si V no es unitaria: M·M se aparta de I
    caso("Espejo", "sin_normalizar_no_es_simetria", 0.1, "1 / (M·M − I)", [] {
        return 1 / involucion(reflexion({2.0f * V, 1}));
    });
    caso("Espejo", "ojo_en_el_plano_es_su_reflejo", 20 * U_FLOAT, "unidades", [] {
        const Plano plano = planoPor(P, V);
        const glm::vec3 ojo =
            P + 3.0f * glm::cross(plano.N, glm::vec3(0, 1, 0)) + glm::cross(plano.N, glm::vec3(1, 0, 0));
        return static_cast<double>(glm::distance(glm::vec3(reflexion(plano) * glm::vec4(ojo, 1)), ojo));
    });
    caso("Espejo", "el_sentido_de_giro_se_invierte", 20 * U_FLOAT, "det + 1",
         [] { return std::fabs(glm::determinant(glm::dmat4(reflexion(planoPor(P, V)))) + 1); });
    // Con el ojo en el plano del espejo, que visto así es una raya: de la órbita de partida hay que girar 1.0498 rad, 52.5 píxeles
    // en una ventana de 90 de alto.
    for (const int pixeles : {52, 53})
        caso("Espejo", "ojo_en_el_plano_" + std::to_string(pixeles), 0, "estado", [=] {
            const Ejecucion e = ejecuta(
                "ch07_realismo/espejo",
                "boton IZQUIERDO abajo 60 30; arrastra " + std::to_string(60 + pixeles) + " 30", 120, 90);
            EXPECT_EQ(e.errores, "");
            return static_cast<double>(e.estado);
        });
});

const Plano SUELO = {{0, 1, 0}, 0};
bool finita(const glm::mat4 &M) {
    for (int i = 0; i < 16; ++i)
        if (!std::isfinite(M[i / 4][i % 4]))
            return false;
    return true;
}

const Casos SOMBRA([] {
    caso("Sombra", "luz_en_el_plano_altura", 0, "altura", [] {
        return static_cast<double>(alturaLuz({3, 0, 1, 1}, SUELO));
    });
    caso("Sombra", "luz_en_el_plano_es_finita", 0, "no", [] {
        return finita(proyeccionSombra({3, 0, 1, 1}, SUELO)) ? 0.0 : 1.0;
    });
    // todo va a la propia luz: no hay sombra, y w = 0 en el plano
    caso("Sombra", "luz_en_el_plano_w_de_un_punto_del_plano", 0, "w", [] {
        return std::fabs(
            static_cast<double>((proyeccionSombra({3, 0, 1, 1}, SUELO) * glm::vec4(7, 0, -2, 1)).w));
    });
    for (const float y : {4.001f, 5.0f, 100.0f}) // la luz está a 4
        caso(
            "Sombra", "objeto_sobre_la_luz_a_" + enNombre(static_cast<double>(y)) + "_w_negativa", 0, "w",
            [=] {
                return static_cast<double>((proyeccionSombra({0, 4, 0, 1}, SUELO) * glm::vec4(1, y, 1, 1)).w);
            });
    caso("Sombra", "objeto_a_la_altura_de_la_luz_w_0", 0, "w", [] {
        return std::fabs(
            static_cast<double>((proyeccionSombra({0, 4, 0, 1}, SUELO) * glm::vec4(1, 4, 1, 1)).w));
    });
    caso("Sombra", "objeto_en_el_plano_no_se_mueve", 4 * U_FLOAT, "unidades", [] {
        const glm::vec4 q = proyeccionSombra({1, 4, -2, 1}, SUELO) * glm::vec4(3, 0, 5, 1);
        return static_cast<double>(glm::distance(glm::vec3(q) / q.w, glm::vec3(3, 0, 5)));
    });
    for (const float lejos :
         {1e3f, 1e6f, 1e18f}) // una luz cada vez más lejos es una direccional: 1/lejos, y el redondeo
        caso("Sombra", "luz_a_" + enNombre(static_cast<double>(lejos)) + "_como_direccional",
             4.0 / static_cast<double>(lejos) + 16 * U_FLOAT, "unidades", [=] {
                 const glm::vec3 hacia(0.6f, 0.8f, 0), x(1, 0.5f, 2);
                 const glm::vec4 q = proyeccionSombra(glm::vec4(lejos * hacia, 1), SUELO) * glm::vec4(x, 1),
                                 r = proyeccionSombra(glm::vec4(hacia, 0), SUELO) * glm::vec4(x, 1);
                 return static_cast<double>(glm::distance(glm::vec3(q) / q.w, glm::vec3(r) / r.w));
             });
});

} // namespace

// Un plano sin perpendicular termina con un mensaje.
TEST(EspejoImposibleDeathTest, PerpendicularNula) {
    EXPECT_EXIT(planoPor(P, glm::vec3(0)), testing::ExitedWithCode(1), "perpendicular que no sea nula");
}
TEST(EspejoImposibleDeathTest, PerpendicularNaN) {
    EXPECT_EXIT(planoPor(P, glm::vec3(NAN, 0, 1)), testing::ExitedWithCode(1),
                "perpendicular que no sea nula");
}
TEST(EspejoImposibleDeathTest, PerpendicularInfinita) {
    EXPECT_EXIT(planoPor(P, glm::vec3(INFINITY, 0, 1)), testing::ExitedWithCode(1),
                "perpendicular que no sea nula");
}
