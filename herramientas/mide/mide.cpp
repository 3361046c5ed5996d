// mide [--ensayo] CARPETA TÉCNICA: deja CARPETA/TÉCNICA.tsv, con una fila por variante (nombre, grupo, mediana, mínimo
// y máximo del tiempo, error, nota), y en CARPETA/TÉCNICA-variante.ppm y …-diferencia.ppm las imágenes que haya. mide
// --lista escribe las técnicas: nombre, título, unidad de tiempo, unidad de error, variante elegida, por qué.
#include "mide.h"
#include "error.h"
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mide {

std::vector<Tecnica> &tecnicas() {
    static std::vector<Tecnica> todas;
    return todas;
}

double milisegundosDeOrden(std::vector<std::string> orden) {
    std::vector<char *> argumentos; // sin shell: una ruta puede llevar cualquier carácter
    for (std::string &palabra : orden)
        argumentos.push_back(palabra.data());
    argumentos.push_back(nullptr);
    posix_spawn_file_actions_t callado;
    posix_spawn_file_actions_init(&callado);
    posix_spawn_file_actions_addopen(&callado, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&callado, STDOUT_FILENO, STDERR_FILENO);
    const auto antes = std::chrono::steady_clock::now();
    pid_t hijo;
    int estado = -1;
    if (posix_spawnp(&hijo, argumentos[0], &callado, nullptr, argumentos.data(), environ) == 0)
        waitpid(hijo, &estado, 0);
    posix_spawn_file_actions_destroy(&callado);
    return estado == 0
               ? std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - antes).count()
               : NAN;
}

double rmse(const Imagen &imagen, const std::vector<double> &exacta) {
    double suma = 0;
    for (std::size_t i = 0; i < exacta.size(); ++i)
        suma += (imagen.rgb[i] - exacta[i]) * (imagen.rgb[i] - exacta[i]);
    return std::sqrt(suma / double(exacta.size()));
}

double rmse(const Imagen &imagen, const Imagen &referencia) {
    return rmse(imagen, std::vector<double>(referencia.rgb.begin(), referencia.rgb.end()));
}

Imagen redondeada(int ancho, int alto, const std::vector<double> &exacta) {
    Imagen imagen{ancho, alto, {}};
    for (const double v : exacta)
        imagen.rgb.push_back(static_cast<unsigned char>(std::lround(std::clamp(v, 0.0, 255.0))));
    return imagen;
}

namespace {

/// Se queda con los nanosegundos por vuelta de cada repetición.
class Tiempos : public benchmark::BenchmarkReporter {
public:
    std::vector<double> ns;
    bool ReportContext(const Context &) override {
        return true;
    }
    void ReportRuns(const std::vector<Run> &vueltas) override {
        for (const Run &r : vueltas)
            if (r.run_type == Run::RT_Iteration)
                ns.push_back(1e9 * r.real_accumulated_time / double(r.iterations));
    }
};

double nanosegundos(const char *unidad) { // los de una unidad de tiempo
    return !std::strncmp(unidad, "ns", 2) ? 1 : !std::strncmp(unidad, "ms", 2) ? 1e6 : 1e3;
}

/// Por ocho, alrededor del gris: la diferencia que apenas se ve, a la vista.
Imagen diferencia(const Imagen &a, const Imagen &b) {
    Imagen d{a.ancho, a.alto, {}};
    for (std::size_t i = 0; i < a.rgb.size(); ++i)
        d.rgb.push_back(static_cast<unsigned char>(std::clamp(128 + 8 * (a.rgb[i] - b.rgb[i]), 0, 255)));
    return d;
}

} // namespace

void Medidor::yaMedida(const std::string &nombre, double error, std::vector<double> tiempos,
                       const std::string &nota) {
    std::sort(tiempos.begin(), tiempos.end());
    medidas.push_back({nombre, grupo, tiempos[tiempos.size() / 2], tiempos.front(), tiempos.back(), error,
                       CUALQUIERA, nota});
}

void Medidor::variante(const std::string &nombre, double error, double unidades,
                       const std::function<void()> &trabajo, const Rango &espera, const std::string &nota,
                       const Imagen &imagen) {
    const auto antes = std::chrono::steady_clock::now();
    trabajo(); // en caliente
    const double segundos = std::chrono::duration<double>(std::chrono::steady_clock::now() - antes).count();
    Tiempos tiempos;
    auto *prueba = benchmark::RegisterBenchmark(nombre.c_str(), [&](benchmark::State &estado) {
        for ([[maybe_unused]] auto vuelta : estado)
            trabajo();
    });
    prueba->UseRealTime();
    if (ensayo)
        prueba->Iterations(1);
    else
        prueba->MinTime(0.04)->Repetitions(segundos > 0.2 ? 3 : 9);
    benchmark::RunSpecifiedBenchmarks(&tiempos);
    benchmark::ClearRegisteredBenchmarks();
    for (double &t : tiempos.ns)
        t /= ns * unidades;
    yaMedida(nombre, error, tiempos.ns, nota);
    medidas.back().espera = espera;
    if (imagen.rgb.empty())
        return;
    const std::string base = prefijo + "-" + std::to_string(medidas.size());
    guardaPpm(base + ".ppm", imagen);
    if (referencia.rgb.size() == imagen.rgb.size())
        guardaPpm(base + "-diferencia.ppm", diferencia(imagen, referencia));
}

} // namespace mide

using namespace mide;

static int corre(const Tecnica &t, bool ensayo, const std::string &carpeta) {
    const std::string base = carpeta + "/" + t.nombre;
    Medidor medidor(ensayo, nanosegundos(t.tiempo), base);
    t.mide(medidor);
    FILE *f = std::fopen((base + ".tsv").c_str(), "w");
    if (!f)
        falla("no puedo escribir «" + base + ".tsv»");
    int mal = 0;
    for (const Medida &v : medidor.hechas()) {
        std::fprintf(f, "%s\t%s\t%.6g\t%.6g\t%.6g\t%.6g\t%s\n", v.variante.c_str(),
                     v.grupo.empty() ? "-" : v.grupo.c_str(), v.mediana, v.minimo, v.maximo, v.error,
                     v.nota.empty() ? "-" : v.nota.c_str());
        if (std::isnan(v.error) ||
            (v.error >= v.espera.minimo && v.error <= v.espera.maximo)) // NaN: no se mide
            continue;
        std::fprintf(stderr, "mide: %s, %s: el error es %g y debía estar entre %g y %g\n", t.nombre,
                     v.variante.c_str(), v.error, v.espera.minimo, v.espera.maximo);
        ++mal;
    }
    if (std::fclose(f))
        falla("no puedo escribir «" + base + ".tsv»");
    return mal != 0;
}

int main(int argc, char **argv) {
    const bool ensayo = argc > 1 && !std::strcmp(argv[1], "--ensayo");
    std::sort(tecnicas().begin(), tecnicas().end(),
              [](const Tecnica &a, const Tecnica &b) { return a.orden < b.orden; });
    if (argc == 2 && !std::strcmp(argv[1], "--lista")) {
        for (const Tecnica &t : tecnicas())
            std::printf("%s\t%s\t%s\t%s\t%s\t%s\n", t.nombre, t.titulo, t.tiempo, t.error, t.elegida,
                        t.porQue);
        return 0;
    }
    if (argc != 3 + ensayo)
        falla("uso: mide [--ensayo] CARPETA TÉCNICA | mide --lista", 2);
    for (const Tecnica &t : tecnicas())
        if (!std::strcmp(t.nombre, argv[2 + ensayo]))
            return corre(t, ensayo, argv[1 + ensayo]);
    falla(std::string("no hay ninguna técnica «") + argv[2 + ensayo] + "»", 2);
}
