#include "rutas.h"
#include "error.h"
#include "glut/sistema/motivo.h"
#include "glut/sistema/sistema.h"
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

namespace fs = std::filesystem;

namespace {

const std::size_t TAMANO_MAXIMO = 256 << 20; // /dev/zero no se acaba nunca

// Las carpetas de $LAB_RAIZ, separadas como en $PATH.
std::vector<fs::path> raicesPedidas() {
    std::vector<fs::path> raices;
    const char *pedidas = std::getenv("LAB_RAIZ");
    std::istringstream texto(pedidas ? pedidas : "");
    for (std::string raiz; std::getline(texto, raiz, SEPARADOR_DE_CARPETAS);)
        if (!raiz.empty())
            raices.push_back(fs::u8path(raiz));
    return raices;
}

// Quien quiere saber qué lee un programa lo pide en $LAB_LEIDOS, el fichero en que se apunta.
void apuntaLeido(const std::string &relativa) {
    if (const char *fichero = std::getenv("LAB_LEIDOS"))
        std::ofstream(fs::u8path(fichero), std::ios::app) << relativa << '\n';
}

} // namespace

bool intentaRecurso(const std::string &relativa, std::string &ruta, std::string &error) {
    std::vector<fs::path> raices = raicesPedidas();
    const fs::path carpeta = ejecutable().parent_path();
    for (const fs::path &raiz :
         {carpeta, carpeta.parent_path(), fs::u8path(LAB_GENERADO), fs::u8path(LAB_FUENTES)})
        if (!raiz.empty() && !std::getenv("LAB_SOLO_RAIZ"))
            raices.push_back(raiz);

    std::string lugares;
    for (const fs::path &raiz : raices) {
        const fs::path candidata = raiz / fs::u8path(relativa);
        ruta = candidata.u8string();
        std::error_code ec;
        if (fs::is_regular_file(candidata, ec)) {
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
    if (fs::is_directory(fs::u8path(ruta), ec)) {
        error = "«" + ruta + "» es una carpeta, no un fichero";
        return false;
    }
    std::ifstream fichero(fs::u8path(ruta), std::ios::binary);
    contenido.clear();
    char trozo[1 << 16];
    while (fichero && contenido.size() <= TAMANO_MAXIMO) {
        fichero.read(trozo, sizeof trozo);
        contenido.append(trozo, static_cast<std::size_t>(fichero.gcount()));
    }
    if (contenido.size() > TAMANO_MAXIMO)
        error = "«" + ruta + "» ocupa más de 256 MiB";
    else if (!fichero.eof())
        error = "no puedo leer «" + ruta + "»: " + motivo();
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
