// mide [--ensayo] CARPETA TÉCNICA: deja CARPETA/TÉCNICA.tsv, con una fila por variante (nombre, grupo, error, nota y lo
// que tarda en cada ronda), y en CARPETA/TÉCNICA-variante.ppm y …-diferencia.ppm las imágenes que haya. mide
// --lista escribe las técnicas: nombre, título, unidad de tiempo, unidad de error, variante elegida, por qué.
#include "mide.h"
#include "contexto_suelto.h"
#include "error.h"
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <fstream>
#include <numeric>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

namespace mide {

std::vector<Tecnica> &tecnicas() {
    static std::vector<Tecnica> todas;
    return todas;
}

double rmse(const Imagen &imagen, const std::vector<double> &exacta) {
    double suma = 0;
    for (std::size_t i = 0; i < exacta.size(); ++i)
        suma += (imagen.rgb[i] - exacta[i]) * (imagen.rgb[i] - exacta[i]);
    return std::sqrt(suma / double(exacta.size()));
}

Imagen redondeada(int ancho, int alto, const std::vector<double> &exacta) {
    Imagen imagen{ancho, alto, {}};
    for (const double v : exacta)
        imagen.rgb.push_back(static_cast<unsigned char>(std::lround(std::clamp(v, 0.0, 255.0))));
    return imagen;
}

namespace {

const int RONDAS = 25, INTENTOS = 4 * RONDAS;
const double RODAJA = 5e6; // ns que dura como poco el turno de una variante
const double OTRO_PASO = 1.2;

// Los de procesador: no cuentan los ratos en que corre otro.
double nsDe(const std::function<void()> &trabajo) {
    const auto gastados = [] {
        timespec nuestro;
        rusage suyo; // de los procesos que han acabado
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &nuestro);
        getrusage(RUSAGE_CHILDREN, &suyo);
        double ns = 1e9 * double(nuestro.tv_sec) + double(nuestro.tv_nsec);
        for (const timeval &t : {suyo.ru_utime, suyo.ru_stime})
            ns += 1e9 * double(t.tv_sec) + 1e3 * double(t.tv_usec);
        return ns;
    };
    const double antes = gastados();
    trabajo();
    return gastados() - antes;
}

// Lo que tarda siempre lo mismo: a qué paso va ahora el procesador.
double paso() {
    return nsDe([] {
        std::minstd_rand azar;
        azar.discard(50000);
        usa(azar);
    });
}

double mediana(std::vector<double> v) {
    std::nth_element(v.begin(), v.begin() + std::ptrdiff_t(v.size() / 2), v.end());
    return v[v.size() / 2];
}

// Una variante espera en un proceso hijo a que le toque: lee un byte y escribe lo que tarda, en nanosegundos.
int aparta(const std::function<double()> &tarda) {
    int extremos[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, extremos))
        falla("no hay por dónde hablar con otra variante");
    std::fflush(nullptr);
    const pid_t hijo = fork();
    if (hijo < 0)
        falla("no hay procesos para otra variante");
    close(extremos[hijo == 0]);
    if (hijo > 0)
        return extremos[1];
    char turno;
    while (read(extremos[0], &turno, 1) == 1) { // hasta que el padre lo cierra
        const double ns = tarda();
        if (write(extremos[0], &ns, sizeof ns) != sizeof ns)
            break;
    }
    _exit(0); // sin deshacer nada: es una copia de lo del padre
}

double turno(int corredor) {
    double ns;
    if (send(corredor, "", 1, MSG_NOSIGNAL) != 1 || read(corredor, &ns, sizeof ns) != sizeof ns)
        falla("una variante ha acabado antes de tiempo");
    return ns;
}

// Lo que tarda cada una en una ronda, y a qué paso iba el procesador antes de cada una.
struct Ronda {
    std::vector<double> ns, pasos;
};

double nanosegundos(const char *unidad) { // los de una unidad de tiempo
    return !std::strncmp(unidad, "ns", 2) ? 1 : !std::strncmp(unidad, "ms", 2) ? 1e6 : 1e3;
}

// Por ocho, alrededor del gris: la diferencia que apenas se ve, a la vista.
Imagen diferencia(const Imagen &a, const Imagen &b) {
    Imagen d{a.ancho, a.alto, {}};
    for (std::size_t i = 0; i < a.rgb.size(); ++i)
        d.rgb.push_back(static_cast<unsigned char>(std::clamp(128 + 8 * (a.rgb[i] - b.rgb[i]), 0, 255)));
    return d;
}

} // namespace

Medidor::~Medidor() {
    for (const int corredor : corredores) // sin quien le pida nada, el hijo acaba
        close(corredor);
}

void Medidor::variante(const std::string &nombre, const std::string &nota, double error, double unidades,
                       const std::function<void()> &trabajo, const Imagen &imagen) {
    medidas.push_back({nombre, grupo, error, nota, {}});
    long vueltas = ensayo ? 1 : 0; // las que llenan una rodaja, que se saben al acabar la primera
    corredores.push_back(aparta([&] {
        if (vueltas == 0) {
            trabajo(); // en caliente
            vueltas = std::max(1L, std::lround(RODAJA / nsDe(trabajo)));
        }
        return nsDe([&] {
                   for (long i = 0; i < vueltas; ++i)
                       trabajo();
               }) /
               double(vueltas) / ns / unidades;
    }));
    if (imagen.rgb.empty())
        return;
    const std::string base = prefijo + "-" + std::to_string(medidas.size());
    guardaPpm(base + ".ppm", imagen);
    if (referencia.rgb.size() == imagen.rgb.size())
        guardaPpm(base + "-diferencia.ppm", diferencia(imagen, referencia));
}

// Con ensayo basta una ronda, al paso que sea. Una a otro paso que las demás se tira y se repite, y si no hay bastantes
// a uno, valen las que menos se apartan.
const std::vector<Medida> &Medidor::corre() {
    std::vector<std::size_t> orden(corredores.size());
    std::iota(orden.begin(), orden.end(), 0);
    std::mt19937 azar(1);
    std::vector<Ronda> rondas;
    const auto seAparta = [&](const Ronda &r, double normal) {
        const auto [menor, mayor] = std::minmax_element(r.pasos.begin(), r.pasos.end());
        return std::max(*mayor / normal, normal / *menor);
    };
    const int intentos = ensayo ? 1 : INTENTOS;
    for (int buenas = 0; buenas < RONDAS && int(rondas.size()) < intentos;) {
        std::shuffle(orden.begin(), orden.end(), azar);
        Ronda ronda{std::vector<double>(corredores.size()), {}};
        for (const std::size_t i : orden) {
            ronda.pasos.push_back(paso());
            ronda.ns[i] = turno(corredores[i]);
        }
        rondas.push_back(ronda);
        std::vector<double> pasos;
        for (const Ronda &r : rondas)
            pasos.push_back(mediana(r.pasos));
        const double normal = mediana(pasos);
        std::sort(rondas.begin(), rondas.end(),
                  [&](const Ronda &a, const Ronda &b) { return seAparta(a, normal) < seAparta(b, normal); });
        buenas = int(std::count_if(rondas.begin(), rondas.end(),
                                   [&](const Ronda &r) { return seAparta(r, normal) <= OTRO_PASO; }));
    }
    rondas.resize(std::min(rondas.size(), std::size_t(RONDAS)));
    for (std::size_t i = 0; i < medidas.size(); ++i)
        for (const Ronda &r : rondas)
            medidas[i].tiempos.push_back(r.ns[i]);
    return medidas;
}

} // namespace mide

using namespace mide;

static void corre(const Tecnica &t, bool ensayo, const std::string &carpeta) {
    const std::string base = carpeta + "/" + t.nombre;
    Medidor medidor(ensayo, nanosegundos(t.tiempo), base);
    t.mide(medidor);
    std::ofstream f(base + ".tsv");
    for (const Medida &v : medidor.corre()) {
        f << v.variante << '\t' << (v.grupo.empty() ? "-" : v.grupo) << '\t' << v.error << '\t'
          << (v.nota.empty() ? "-" : v.nota) << '\t';
        for (std::size_t i = 0; i < v.tiempos.size(); ++i)
            f << (i ? " " : "") << v.tiempos[i];
        f << '\n';
    }
    f.close();
    if (!f)
        falla("no puedo escribir «" + base + ".tsv»");
}

int main(int argc, char **argv) {
    // los hijos no heredan hilos: ni los de llvmpipe ni el de su caché
    setenv("LP_NUM_THREADS", "0", 1);
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
    setenv("LIBGL_ALWAYS_SOFTWARE", "true", 1); // ni el estado de una GPU de verdad
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
        if (!std::strcmp(t.nombre, argv[2 + ensayo])) {
            abreContexto();
            corre(t, ensayo, argv[1 + ensayo]);
            return 0;
        }
    falla(std::string("no hay ninguna técnica «") + argv[2 + ensayo] + "»", 2);
}
