// Casos difíciles del tiempo y las partículas (capítulo 12).
#include "caso.h"
#include "ch12_animacion/piezas.h"
#include "ch12_animacion/reloj.h"

namespace {

/// La parte del periodo que ha pasado a las `horas` y pico, contra la precisión extendida: lo más que se aparta, en vueltas.
double errorDeFase(double horas, double periodo) {
    double peor = 0;
    for (int ms = 0; ms < 20000; ms += 7) {
        const long double t = static_cast<long double>(horas) * 3600 + ms / 1000.0L, vueltas = t / periodo;
        const double exacta = static_cast<double>(vueltas - std::floor(vueltas)),
                     f = static_cast<double>(fase(static_cast<double>(t), periodo));
        const double d = std::fabs(f - exacta);
        peor = mayor(std::min(d, 1 - d), peor); // 0 y 1 son lo mismo
    }
    return peor;
}
/// Lo mismo con el tiempo guardado en un float: lo que salta, en segundos.
double saltoDeUnFloat(double horas) {
    const float t = static_cast<float>(horas * 3600);
    return static_cast<double>(std::nextafter(t, 1e30f) - t);
}

/// Cuántos segundos se aparta un reloj que llega a `total` segundos de `paso` en `paso`.
double adelantado(double total, double paso) {
    Reloj reloj;
    const int pasos = static_cast<int>(std::lround(total / paso));
    for (int i = 0; i < pasos; ++i)
        adelanta(reloj, paso);
    return std::fabs(segundos(reloj, 0) - total);
}

const Casos TIEMPO([] {
    for (const double horas : {0.0, 1.0, 10.0, 100.0})
        for (const double periodo : {10.0, 2.5}) // la fase en float, y en doble t: t·2⁻⁵³ segundos
            caso("Tiempo", "fase_a_las_" + enNombre(horas) + "_h_periodo_" + enNombre(periodo),
                 U_FLOAT + (horas * 3600 + 20) * 4 * U_DOBLE / periodo, "vueltas",
                 [=] { return errorDeFase(horas, periodo); });
    // por eso el tiempo no se guarda en un float: a las 100 h salta más que un cuadro de 20 ms
    caso("Tiempo", "un_float_a_las_100_h_salta_mas_de_un_cuadro", 1, "cuadro / salto",
         [] { return 0.020 / saltoDeUnFloat(100); });
    caso("Tiempo", "la_fase_no_llega_a_1", 1 - U_FLOAT, "fase", [] {
        double peor = 0;
        for (int k = 1; k < 1000; ++k)
            peor = mayor(static_cast<double>(fase(std::nextafter(10.0 * k, 0.0), 10)), peor);
        return peor;
    });
    caso("Tiempo", "fase_de_un_tiempo_negativo", 2 * U_FLOAT, "diferencia",
         [] { return std::fabs(static_cast<double>(fase(-2.5, 10)) - 0.75); });
    // pasos de 1 ms y de 10 s: lo que se acumula son redondeos en doble, un paso por vez
    caso("Tiempo", "pasos_de_1_ms_durante_100_s", 100000 * 100 * U_DOBLE, "segundos",
         [] { return adelantado(100, 0.001); });
    caso("Tiempo", "pasos_de_10_s_durante_100_h", 0, "segundos", [] { return adelantado(360000, 10); });
    caso("Tiempo", "pausa_a_las_100_h", 360000 * 2 * U_DOBLE, "segundos", [] {
        Reloj reloj;
        adelanta(reloj, 360000);
        conmutaPausa(reloj, 1234);
        const double parado = segundos(reloj, 99999);
        conmutaPausa(reloj, 50000);
        return mayor(std::fabs(parado - 360001.234), std::fabs(segundos(reloj, 50000) - parado));
    });
});

/// Lo que crece una pieza (piezas.glsl), de 0 a 1.
float crecida(float nace, float muere, float t) {
    return glm::clamp(std::min(t - nace, muere - t) / 0.4f, 0.0f, 1.0f);
}

const Casos PIEZAS([] {
    for (const float instante : {0.0f, 3.5f, 10.0f})
        caso("Piezas", "nacer_y_morir_a_la_vez_en_" + enNombre(static_cast<double>(instante)), 0, "tamaño",
             [=] {
                 double peor = 0;
                 for (const float t : {0.0f, 3.5f, 5.0f, 10.0f})
                     peor = mayor(static_cast<double>(crecida(instante, instante, t)), peor);
                 return peor;
             });
    caso("Piezas", "ninguna_muere_antes_de_nacer", -2.5, "nacer − morir", [] {
        double peor = -HUGE_VAL;
        for (const VerticePieza &v : creaPiezas(200, 100))
            peor = mayor(static_cast<double>(v.vida.x - v.vida.y), peor);
        return peor;
    });
    caso("Piezas", "al_volver_a_empezar_no_queda_ninguna", 0, "tamaño", [] {
        double peor = 0;
        for (const VerticePieza &v : creaPiezas(200, 100))
            for (const float t : {0.0f, static_cast<float>(PERIODO_PIEZAS)})
                peor = mayor(static_cast<double>(crecida(v.vida.x, v.vida.y, t)), peor);
        return peor;
    });
    caso("Piezas", "azar_menor_que_1", 1 - U_FLOAT, "azar", [] {
        double peor = 0;
        for (std::uint32_t n = 0; n < 2000000; ++n)
            peor = mayor(static_cast<double>(azar(n)), peor);
        return mayor(static_cast<double>(azar(0xffffffffu)), peor);
    });
});

} // namespace
