// Casos difíciles del tiempo y las partículas (capítulo 12).
#include "ch12_animacion/piezas.h"
#include "ch12_animacion/reloj.h"
#include "cota.h"

namespace {

/// La parte del periodo que ha pasado a las `horas` y pico, contra la precisión extendida: lo más que se aparta, en
/// vueltas.
double errorDeFase(double horas, double periodo) {
    return peorHasta(2858, [=](int i) { // veinte segundos, de 7 en 7 ms
        const Largo t = Largo(horas) * 3600 + 7 * i / 1000.0L, vueltas = t / periodo;
        const Largo d = std::fabs(fase(double(t), periodo) - (vueltas - std::floor(vueltas)));
        return std::min(d, 1 - d); // 0 y 1 son lo mismo
    });
}

/// Cuántos segundos se aparta un reloj que llega a `total` segundos de `paso` en `paso`.
double adelantado(double total, double paso) {
    Reloj reloj;
    const long pasos = std::lround(total / paso);
    for (long i = 0; i < pasos; ++i)
        adelanta(reloj, paso);
    return std::fabs(segundos(reloj, 0) - total);
}

const Cotas TIEMPO([] {
    // la fase en float, y en doble t: t·2⁻⁵³ segundos
    for (const double periodo : {10.0, 2.5})
        acotaCada<double>(
            "Tiempo", "fase_a_las_*_h_periodo_" + enNombre(periodo), {0, 1, 10, 100, 1000},
            [=](double horas) { return U_FLOAT + (horas * 3600 + 20) * 4 * U_DOBLE / periodo; }, "vueltas",
            [=](double horas) { return errorDeFase(horas, periodo); });
    acota("Tiempo", "la_fase_no_llega_a_1", 1 - U_FLOAT, "fase",
          [] { return peorHasta(999, [](int k) { return fase(std::nextafter(10.0 * (k + 1), 0.0), 10); }); });
    acota("Tiempo", "fase_de_un_tiempo_negativo", 2 * U_FLOAT, "diferencia",
          [] { return std::fabs(fase(-2.5, 10) - 0.75); });
    // pasos de 1 ms y de 10 s: lo que se acumula son redondeos en doble, un paso por vez
    acota("Tiempo", "pasos_de_1_ms_durante_100_s", 100000 * 100 * U_DOBLE, "segundos",
          [] { return adelantado(100, 0.001); });
    acota("Tiempo", "pasos_de_10_s_durante_100_h", 0, "segundos", [] { return adelantado(360000, 10); });
    acota("Tiempo", "pausa_a_las_100_h", 360000 * 2 * U_DOBLE, "segundos", [] {
        Reloj reloj;
        adelanta(reloj, 360000);
        conmutaPausa(reloj, 1234);
        const double parado = segundos(reloj, 99999);
        conmutaPausa(reloj, 50000);
        return mayor(std::fabs(parado - 360001.234), std::fabs(segundos(reloj, 50000) - parado));
    });
});

const Cotas PIEZAS([] {
    acota("Piezas", "ninguna_muere_antes_de_nacer", -2.5, "nacer − morir", [] {
        return peorDe(creaPiezas(200, 100), [](const VerticePieza &v) { return v.vida.x - v.vida.y; });
    });
    acota("Piezas", "azar_menor_que_1", 1 - U_FLOAT, "azar",
          [] { return mayor(peorHasta(2000000, [](int n) { return azar(n); }), azar(0xffffffffu)); });
});

} // namespace
