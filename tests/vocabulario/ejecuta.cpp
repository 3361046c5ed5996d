#include "ejecuta.h"
#include "oraculo/compara.h"
#include "rutas.h"
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace {

std::string entreComillas(const std::string &texto) {
    std::string s = "'";
    for (char c : texto)
        s += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return s + "'";
}

/// El entorno fijado, sin tocar lo que la prueba haya puesto antes.
void fijaEntorno() {
    std::ifstream entorno(LAB_BUILD "/entorno.txt");
    std::string linea;
    while (std::getline(entorno, linea)) {
        const std::size_t igual = linea.find('=');
        setenv(linea.substr(0, igual).c_str(), linea.substr(igual + 1).c_str(), 0);
    }
}

/// Se borra con el proceso que la hizo; los que EXPECT_EXIT desdobla también terminan, y no deben tocarla.
struct CarpetaTemporal {
    const pid_t proceso = getpid();
    fs::path ruta;

    CarpetaTemporal() {
        std::string plantilla = (fs::temp_directory_path() / "labXXXXXX").string();
        if (!mkdtemp(plantilla.data()))
            throw std::runtime_error("no puedo crear una carpeta temporal");
        ruta = plantilla;
    }
    ~CarpetaTemporal() {
        std::error_code nadaQueHacer;
        if (getpid() == proceso)
            fs::remove_all(ruta, nadaQueHacer);
    }
};

std::string ultimoPrograma; // sin su capítulo

/// La peor comparación de la prueba en curso: la referencia y lo obtenido.
struct LadoALado : testing::EmptyTestEventListener {
    double error = -1;
    Imagen esperada, obtenida;

    void apunta(const oraculo::Comparacion &c, const Imagen &gpu, const oraculo::ImagenRef &ref) {
        const double suyo = c.maximo + 255.0 * c.bandaLejos;
        if (suyo <= error)
            return;
        error = suyo;
        esperada = oraculo::enBytes(ref);
        obtenida = gpu;
    }
    /// Si la prueba falla quedan en BUILD/fallos/oraculo/, con su diferencia, como las del comparador; con
    /// LAB_COMPARACIONES=CARPETA quedan ahí las de todas.
    void OnTestEnd(const testing::TestInfo &prueba) override {
        const char *todas = std::getenv("LAB_COMPARACIONES");
        if (error >= 0 && (todas || prueba.result()->Failed())) {
            const fs::path carpeta = todas ? todas : LAB_BUILD "/fallos/oraculo";
            fs::create_directories(carpeta);
            std::string nombre = std::string(prueba.test_suite_name()) + "." + prueba.name();
            std::replace(nombre.begin(), nombre.end(), '/', '_');
            const std::string prefijo = (carpeta / nombre).string();
            Imagen diferencia = esperada;
            for (std::size_t i = 0; i < obtenida.rgb.size(); ++i)
                diferencia.rgb[i] = static_cast<unsigned char>(
                    std::min(8 * std::abs(esperada.rgb[i] - obtenida.rgb[i]), 255));
            guardaPpm(prefijo + "-esperada.ppm", esperada);
            guardaPpm(prefijo + "-obtenida.ppm", obtenida);
            guardaPpm(prefijo + "-diferencia.ppm", diferencia);
            std::printf("imágenes en %s-*.ppm\n",
                        prefijo.c_str()); // las busca herramientas/pruebas/fallos.py
        }
        error = -1;
    }
};
LadoALado *creaLadoALado() {
    auto *oyente = new LadoALado; // lo borra GoogleTest
    testing::UnitTest::GetInstance()->listeners().Append(oyente);
    return oyente;
}
LadoALado *const ladoALado = creaLadoALado();

// Todo lo que compara el oráculo, al informe de la prueba. Su desvío es infinito si el color de algún píxel del borde
// no está a menos de uno de distancia, lo que cada prueba admite en unos pocos: se cuentan aparte.
void apuntaComparacion(const oraculo::Comparacion &c, const Imagen &gpu, const oraculo::ImagenRef &ref) {
    ladoALado->apunta(c, gpu, ref);
    apuntaDiferencia(c.maximo, c.rmse, std::min(c.desvio, 1.0), c.bandaLejos, c.banda);
}
const bool apunta = (oraculo::alComparar = apuntaComparacion);

} // namespace

void apuntaDiferencia(double maximo, double rmse, double borde, int lejos, int banda) {
    static const testing::TestInfo *deEsta = nullptr;
    static std::map<std::string, std::array<double, 5>> peores;
    const testing::TestInfo *prueba = testing::UnitTest::GetInstance()->current_test_info();
    if (prueba != deEsta)
        peores.clear();
    deEsta = prueba;
    std::array<double, 5> &p =
        peores.try_emplace(ultimoPrograma, std::array<double, 5>{-1, -1, -1, 0, 0}).first->second;
    p = {std::max(p[0], maximo), std::max(p[1], rmse), std::max(p[2], borde), p[3] + lejos, p[4] + banda};
    std::ostringstream texto;
    for (const double x : p)
        texto << x << " ";
    testing::Test::RecordProperty("pixeles_" + ultimoPrograma, texto.str());
}

const fs::path &carpetaTemporal() {
    static const CarpetaTemporal carpeta;
    return carpeta.ruta;
}

namespace {

/// La ruta del ejecutable de un programa del libro, por su nombre, o de otro, por su ruta.
std::string ejecutable(const std::string &programa) {
    if (programa.find('/') != std::string::npos)
        return LAB_EJECUTABLES "/" + programa;
    for (const auto &capitulo : fs::directory_iterator(LAB_EJECUTABLES))
        if (fs::is_regular_file(capitulo.path() / programa))
            return capitulo.path() / programa;
    throw std::runtime_error("no hay ningún programa «" + programa + "»");
}

/// La ejecución, en `carpeta`, con lo que haya que poner en el entorno.
Ejecucion ejecutaEn(const fs::path &carpeta, const std::string &entorno, const std::string &programa,
                    const std::string &guion, int ancho, int alto,
                    const std::vector<std::string> &argumentos) {
    fijaEntorno();
    ultimoPrograma = programa.substr(programa.rfind('/') + 1);
    testing::Test::RecordProperty("ejecuta_" + ultimoPrograma, 1);
    const std::string ruta = ejecutable(programa);
    std::string orden = "cd " + entreComillas(carpeta.string()) + " && " + entorno + " " +
                        entreComillas(ruta) + " -geometry " + std::to_string(ancho) + "x" +
                        std::to_string(alto) + " -ppm imagen.ppm";
    if (!guion.empty())
        orden += " -guion " + entreComillas(guion);
    for (const std::string &a : argumentos)
        orden += " " + entreComillas(a);
    orden += " >salida 2>errores </dev/null";

    Ejecucion e;
    const int estado = std::system(orden.c_str());
    e.estado = WIFEXITED(estado) ? WEXITSTATUS(estado) : 128 + WTERMSIG(estado);
    e.salida = leeFichero(carpeta / "salida");
    e.errores = leeFichero(carpeta / "errores");
    if (fs::exists(carpeta / "imagen.ppm"))
        e.imagen = leePpm((carpeta / "imagen.ppm").string());
    return e;
}

/// Una carpeta vacía, que se borra al acabar.
struct Aparte {
    const fs::path ruta = carpetaTemporal() / "ejecucion";
    Aparte() {
        fs::create_directory(ruta);
    }
    ~Aparte() {
        std::error_code nadaQueHacer;
        fs::remove_all(ruta, nadaQueHacer);
    }
};

void exigeQueAcabeBien(const Ejecucion &e, const std::string &programa, const std::string &guion) {
    if (e.estado != 0 || !e.errores.empty() || e.imagen.rgb.empty())
        throw std::runtime_error(programa + " con el guion «" + guion + "» acaba con estado " +
                                 std::to_string(e.estado) + ": " + e.errores);
    // Bajo ASan basta con eso: lo que dibuja no depende de cómo se compile, y se compara en la otra compilación.
    const testing::UnitTest &pruebas = *testing::UnitTest::GetInstance();
    if (LAB_SANEADO && pruebas.test_to_run_count() == 1)
        std::exit(pruebas.current_test_info()->result()->Failed());
}

} // namespace

Ejecucion ejecuta(const std::string &programa, const std::string &guion, int ancho, int alto,
                  const std::vector<std::string> &argumentos) {
    const Aparte carpeta;
    return ejecutaEn(carpeta.ruta, "", programa, guion, ancho, alto, argumentos);
}

Imagen imagenDe(const std::string &programa, const std::string &guion, int ancho, int alto,
                const std::vector<std::string> &argumentos) {
    const Ejecucion e = ejecuta(programa, guion, ancho, alto, argumentos);
    exigeQueAcabeBien(e, programa, guion);
    return e.imagen;
}

Vista vistaDe(const std::string &programa, const std::string &guion, int ancho, int alto,
              const std::vector<std::string> &argumentos) {
    return vistasDe(programa, {guion}, ancho, alto, argumentos).front();
}

std::vector<Vista> vistasDe(const std::string &programa, const std::vector<std::string> &guiones, int ancho,
                            int alto, const std::vector<std::string> &argumentos) {
    const Aparte carpeta;
    std::string guion;
    for (std::size_t i = 0; i < guiones.size(); ++i)
        guion += guiones[i] + "; captura " + std::to_string(i) + ".ppm; ";
    const Ejecucion e = ejecutaEn(carpeta.ruta, "LAB_SIN_ENCIMA=1 LAB_ENCIMA=encima.tsv", programa, guion,
                                  ancho, alto, argumentos);
    exigeQueAcabeBien(e, programa, guion);
    const std::vector<Encima> encima = leeEncima(carpeta.ruta / "encima.tsv");
    std::vector<Vista> vistas;
    for (std::size_t i = 0; i < guiones.size(); ++i)
        vistas.push_back({leePpm((carpeta.ruta / (std::to_string(i) + ".ppm")).string()), encima.at(i)});
    return vistas;
}

ConRaiz::ConRaiz(const fs::path &carpeta) : antes(std::getenv("LAB_RAIZ") ? std::getenv("LAB_RAIZ") : "") {
    setenv("LAB_RAIZ", (carpeta.string() + ":" + antes).c_str(), 1);
}

ConRaiz::~ConRaiz() {
    setenv("LAB_RAIZ", antes.c_str(), 1);
}

Pixel pixel(const Imagen &imagen, int x, int y) {
    const std::size_t i = std::size_t(3 * (y * imagen.ancho + x));
    return {imagen.rgb.at(i), imagen.rgb.at(i + 1), imagen.rgb.at(i + 2)};
}
