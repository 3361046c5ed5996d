// conductor N SEMILLAS: lo que hace libFuzzer, sin él y siempre igual: cada semilla y N variaciones, al azar fijo.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>
#include <string>
#include <vector>

using namespace std::literals;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *datos, std::size_t n); // el lector

/// Lo que suele romper un lector. Es lo que va entre barras.
static std::vector<std::string> palabras() {
    std::istringstream todas("1e300|-1e39|nan|inf|0x10|1.5.2.3|1-2-3|+3| -0|4294967296|-1|32769"
                             "|99999999999999999999|#|\n|\r\n|\v|\f| |;|@|\"|v |f |p |P6\n|255\n|x|tecla "
                             "|menu /| ×9|escala |#include \"a\"\n|#include \"b\"\n|ERROR: 0:1: |0:1(2): "
                             "|0(99999999999999999999) : |\0"s);
    std::vector<std::string> lista;
    for (std::string palabra; std::getline(todas, palabra, '|');)
        lista.push_back(palabra);
    return lista;
}

int main(int argc, char **argv) {
    if (argc != 3) {
        std::fprintf(stderr, "uso: conductor N SEMILLAS\n");
        return 2;
    }
    const std::vector<std::string> PALABRAS = palabras();
    std::vector<std::filesystem::path> rutas(std::filesystem::directory_iterator(argv[2]), {});
    std::sort(rutas.begin(), rutas.end());
    std::vector<std::string> semillas;
    for (const auto &ruta : rutas) {
        std::ifstream f(ruta, std::ios::binary);
        semillas.emplace_back(std::istreambuf_iterator<char>(f), std::istreambuf_iterator<char>());
    }
    const auto prueba = [](const std::string &s) {
        LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t *>(s.data()), s.size());
    };
    for (const std::string &s : semillas)
        prueba(s);

    std::mt19937 azar(1); // sus números son los mismos en todas partes; los de las distribuciones, no
    const auto hasta = [&azar](std::size_t n) { return azar() % (n + 1); };
    const int N = std::atoi(argv[1]);
    for (int k = 0; k < N; ++k) {
        std::string s = semillas.at(hasta(semillas.size() - 1));
        for (std::size_t cambios = 1 + hasta(4); cambios > 0; --cambios) {
            const std::size_t i = hasta(s.size()), cuantos = hasta(std::min<std::size_t>(s.size() - i, 40));
            const std::string &otra = semillas[hasta(semillas.size() - 1)];
            switch (hasta(5)) {
            case 0: s.insert(i, PALABRAS[hasta(PALABRAS.size() - 1)]); break;
            case 1: s.replace(i, cuantos, PALABRAS[hasta(PALABRAS.size() - 1)]); break;
            case 2: s.erase(i, cuantos); break;
            case 3: s.insert(i, otra, hasta(otra.size()), hasta(60)); break;
            case 4: s.insert(i, 5000, ' '); break;
            default: s.insert(i, 1, char(hasta(255)));
            }
        }
        prueba(s);
    }
    std::printf("%zu semillas y %d variaciones\n", semillas.size(), N);
    return semillas.empty();
}
