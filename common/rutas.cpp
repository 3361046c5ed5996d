#include "rutas.h"
#include "error.h"
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

namespace fs = std::filesystem;

namespace {

const std::size_t TAMANO_MAXIMO = 256 << 20; // /dev/zero no se acaba nunca

/// Las carpetas de $LAB_RAIZ, separadas por «:» como en $PATH.
std::vector<fs::path> raicesPedidas() {
    std::vector<fs::path> raices;
    const char *pedidas = std::getenv("LAB_RAIZ");
    std::istringstream texto(pedidas ? pedidas : "");
    for (std::string raiz; std::getline(texto, raiz, ':');)
        if (!raiz.empty())
            raices.emplace_back(raiz);
    return raices;
}

/// Quien quiere saber qué lee un programa lo pide en $LAB_LEIDOS, el fichero en que se apunta.
void apuntaLeido(const std::string &relativa) {
    if (const char *fichero = std::getenv("LAB_LEIDOS"))
        std::ofstream(fichero, std::ios::app) << relativa << '\n';
}

} // namespace

bool intentaRecurso(const std::string &relativa, std::string &ruta, std::string &error) {
    std::vector<fs::path> raices = raicesPedidas();
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
        ruta = (raiz / relativa).string();
        std::error_code ec;
        if (fs::is_regular_file(ruta, ec)) {
            apuntaLeido(relativa);
            return true;
        }
        lugares += (lugares.empty() ? "" : ", ") + ruta;
    }
    error = "no encuentro «" + relativa + "»; lo he buscado en " + lugares;
    return false;
}

bool intentaLeer(const std::string &ruta, std::string &contenido, std::string &error) {
    std::error_code ec;
    if (fs::is_directory(ruta, ec)) {
        error = "«" + ruta + "» es una carpeta, no un fichero";
        return false;
    }
    std::ifstream fichero(ruta, std::ios::binary);
    contenido.clear();
    char trozo[1 << 16];
    while (fichero && contenido.size() <= TAMANO_MAXIMO) {
        fichero.read(trozo, sizeof trozo);
        contenido.append(trozo, static_cast<std::size_t>(fichero.gcount()));
    }
    if (contenido.size() > TAMANO_MAXIMO)
        error = "«" + ruta + "» ocupa más de 256 MiB";
    else if (!fichero.eof())
        error = "no puedo leer «" + ruta + "»: " + std::strerror(errno);
    else
        return true;
    return false;
}

std::string recurso(const std::string &relativa) {
    std::string ruta, error;
    if (!intentaRecurso(relativa, ruta, error))
        falla(error);
    return ruta;
}

std::string leeFichero(const std::string &ruta) {
    std::string contenido, error;
    if (!intentaLeer(ruta, contenido, error))
        falla(error);
    return contenido;
}
