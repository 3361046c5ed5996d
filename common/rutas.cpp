#include "rutas.h"
#include "error.h"
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

namespace fs = std::filesystem;

std::string recurso(const std::string &relativa) {
    std::vector<fs::path> raices;
    if (const char *raiz = std::getenv("LAB_RAIZ"))
        raices.emplace_back(raiz);
    std::error_code sinEjecutable;
    const fs::path carpeta = fs::read_symlink("/proc/self/exe", sinEjecutable).parent_path();
    if (!sinEjecutable) {
        raices.push_back(carpeta);
        raices.push_back(carpeta.parent_path());
    }
    raices.emplace_back(LAB_GENERADO);
    raices.emplace_back(LAB_FUENTES);

    std::string lugares;
    for (const fs::path &raiz : raices) {
        const fs::path ruta = raiz / relativa;
        std::error_code ec;
        if (fs::is_regular_file(ruta, ec))
            return ruta.string();
        lugares += (lugares.empty() ? "" : ", ") + ruta.string();
    }
    falla("no encuentro «" + relativa + "»; lo he buscado en " + lugares);
}

std::string leeFichero(const std::string &ruta) {
    std::error_code ec;
    if (fs::is_directory(ruta, ec))
        falla("«" + ruta + "» es una carpeta, no un fichero");
    std::ifstream fichero(ruta, std::ios::binary);
    if (!fichero)
        falla("no puedo leer «" + ruta + "»: " + std::strerror(errno));
    std::string contenido{std::istreambuf_iterator<char>(fichero), {}};
    if (fichero.bad())
        falla("no puedo leer «" + ruta + "»: " + std::strerror(errno));
    return contenido;
}
