#include "imagen.h"
#include "error.h"
#include "glut/sistema/sistema.h"
#include "motivo.h"
#include "numero.h"
#include "rutas.h"
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>

namespace fs = std::filesystem;

namespace {

const int LADO_MAXIMO = 32768;

Imagen desdeArriba(const char *bytes, int ancho, int alto) {
    Imagen imagen{ancho, alto, {}};
    const std::size_t fila = std::size_t(3) * ancho;
    imagen.rgb.resize(fila * alto);
    for (int y = 0; y < alto; ++y)
        std::memcpy(&imagen.rgb[fila * (alto - 1 - y)], bytes + fila * y, fila);
    return imagen;
}

bool esBlanco(char c) {
    return std::isspace(static_cast<unsigned char>(c));
}

// El siguiente número de una cabecera PPM: antes lleva al menos un blanco, y quizá comentarios.
int numeroDeCabecera(const std::string &datos, std::size_t &i, const std::string &fichero,
                     std::string *comentario, int mayor = LADO_MAXIMO) {
    const std::size_t principio = i;
    while (i < datos.size() && (esBlanco(datos[i]) || datos[i] == '#')) {
        if (datos[i++] != '#')
            continue;
        const std::size_t fin = std::min(datos.find('\n', i), datos.size());
        if (comentario && comentario->empty())
            *comentario = datos.substr(i, fin - i).substr(fin > i && datos[i] == ' ');
        i = fin;
    }
    const std::size_t cifras = std::min(datos.find_first_not_of("0123456789", i), datos.size()) - i;
    const std::optional<int> n = numeroDe<int>(std::string_view(datos).substr(i, cifras));
    if (i == principio || !n || *n < 1 || *n > mayor)
        falla("«" + fichero + "»: la cabecera del PPM no es válida");
    i += cifras;
    return *n;
}

void compruebaTalla(const std::string &fichero, int ancho, int alto, std::size_t encontrado) {
    const std::size_t esperado = std::size_t(3) * ancho * alto;
    if (encontrado != esperado)
        falla("«" + fichero + "»: una imagen RGB de " + std::to_string(ancho) + "×" + std::to_string(alto) +
              " ocupa " + std::to_string(esperado) + " bytes y hay " + std::to_string(encontrado));
}

} // namespace

Imagen leeTextura(const std::string &fichero, int ancho, int alto) {
    if (ancho < 1 || alto < 1 || ancho > LADO_MAXIMO || alto > LADO_MAXIMO)
        falla("«" + fichero + "»: no hay texturas de " + std::to_string(ancho) + "×" + std::to_string(alto));
    const std::string datos = leeFichero(fichero);
    compruebaTalla(fichero, ancho, alto, datos.size());
    return desdeArriba(datos.data(), ancho, alto);
}

Imagen leePpm(const std::string &fichero, std::string *comentario) {
    const std::string datos = leeFichero(fichero);
    if (datos.compare(0, 2, "P6") != 0)
        falla("«" + fichero + "» no es un PPM binario (no empieza por P6)");
    std::size_t i = 2;
    const int ancho = numeroDeCabecera(datos, i, fichero, comentario);
    const int alto = numeroDeCabecera(datos, i, fichero, comentario);
    if (numeroDeCabecera(datos, i, fichero, comentario, 65535) != 255)
        falla("«" + fichero + "»: solo se leen PPM de 8 bits (máximo 255)");
    if (i == datos.size() || !esBlanco(datos[i++])) // uno solo separa la cabecera de los datos
        falla("«" + fichero + "»: la cabecera del PPM no es válida");
    if (datos.compare(i - 1, 2, "\r\n") == 0 && datos.size() - i == std::size_t(3) * ancho * alto + 1)
        ++i; // como acaban las líneas en Windows
    compruebaTalla(fichero, ancho, alto, datos.size() - i);
    return desdeArriba(datos.data() + i, ancho, alto);
}

Imagen imagenDeArgumentos(int argc, char **argv, const std::string &porOmision, int ancho, int alto) {
    return imagenesDeArgumentos(argc, argv, {{porOmision, ancho, alto}})[0];
}

std::vector<Imagen> imagenesDeArgumentos(int argc, char **argv,
                                         const std::vector<ImagenPorOmision> &porOmision) {
    const std::size_t cuantas = porOmision.size();
    std::vector<std::string> ficheros;
    std::string talla;
    int ancho = 0, alto = 0;
    for (int i = 1; i < argc; ++i) {
        const std::string argumento = argv[i];
        if (argumento == "-talla" && talla.empty()) {
            if (++i == argc)
                falla("detrás de -talla va el tamaño, ANCHOxALTO", 2);
            talla = argv[i];
            if (!leeTalla(talla, ancho, alto))
                falla("«" + talla + "» no es un tamaño ANCHOxALTO", 2);
        } else if (!argumento.empty() && argumento[0] != '-' && ficheros.size() < cuantas) {
            ficheros.push_back(argumento);
        } else {
            falla("sobra «" + argumento + "»: solo se " +
                      (cuantas == 1 ? "lee una imagen" : "leen " + std::to_string(cuantas) + " imágenes"),
                  2);
        }
    }
    std::vector<Imagen> imagenes;
    if (ficheros.empty() && talla.empty()) {
        for (const ImagenPorOmision &i : porOmision)
            imagenes.push_back(leeTextura(recurso(i.recurso), i.ancho, i.alto));
        return imagenes;
    }
    if (ficheros.empty())
        falla("con -talla falta el fichero RGB", 2);
    if (ficheros.size() < cuantas)
        falla("hacen falta " + std::to_string(cuantas) + " imágenes y solo hay " +
                  std::to_string(ficheros.size()),
              2);
    const auto esPpm = [](const std::string &fichero) {
        std::string extension = fs::u8path(fichero).extension().u8string();
        for (char &c : extension)
            c = char(std::tolower(static_cast<unsigned char>(c)));
        return extension == ".ppm";
    };
    if (!talla.empty() && std::all_of(ficheros.begin(), ficheros.end(), esPpm))
        falla("«" + ficheros[0] + "»: un PPM ya dice su tamaño, sobra -talla", 2);
    for (const std::string &fichero : ficheros)
        if (talla.empty() && !esPpm(fichero))
            falla("«" + fichero + "»: de un fichero RGB sin cabecera hay que decir -talla ANCHOxALTO", 2);
    for (const std::string &fichero : ficheros)
        imagenes.push_back(esPpm(fichero) ? leePpm(fichero) : leeTextura(fichero, ancho, alto));
    return imagenes;
}

bool intentaGuardarPpm(const std::string &fichero, const Imagen &imagen, const std::string &comentario,
                       std::string &error) {
    std::error_code ec;
    error.clear();
    const auto comprueba = [&](bool bien) {
        if (!bien && error.empty()) // el motivo es el del primer fallo
            error = "no puedo guardar «" + fichero + "»: " + (ec ? motivo(ec) : motivo());
        return bien;
    };

    // Renombrar solo vale entre ficheros corrientes; un enlace se sigue hasta donde apunta, exista o no.
    fs::path destino = fs::u8path(fichero);
    const bool dispositivo = fs::exists(destino, ec) && !fs::is_regular_file(destino, ec);
    const fs::file_status estado = fs::status(destino, ec);
    if (!comprueba(estado.type() != fs::file_type::none)) // los enlaces dan vueltas
        return false;
    std::optional<SinSenales> sinSenales; // un dispositivo puede no acabar nunca
    fs::path parcial = destino;
    if (!dispositivo) {
        while (fs::is_symlink(destino, ec))
            destino = destino.parent_path() / fs::read_symlink(destino, ec);
        parcial = destino;
        parcial += "." + std::to_string(numeroDeProceso()) + ".parcial";
        sinSenales.emplace();
    }
    ec.clear();

    FILE *f = std::fopen(parcial.u8string().c_str(), "wb");
    if (!comprueba(f != nullptr))
        return false;
    std::fprintf(f, "P6\n");
    if (!comentario.empty())
        std::fprintf(f, "# %s\n", comentario.c_str());
    std::fprintf(f, "%d %d\n255\n", imagen.ancho, imagen.alto);
    const std::size_t fila = std::size_t(3) * imagen.ancho;
    for (int y = imagen.alto - 1; y >= 0; --y)
        std::fwrite(&imagen.rgb[fila * y], 1, fila, f);
    comprueba(std::fflush(f) == 0 && !std::ferror(f));
    comprueba(std::fclose(f) == 0);
    if (error.empty() && !dispositivo) {
        fs::rename(parcial, destino, ec); // std::rename no sustituye en Windows
        comprueba(!ec);
    }
    if (!error.empty() && !dispositivo)
        fs::remove(parcial, ec);
    return error.empty();
}

void guardaPpm(const std::string &fichero, const Imagen &imagen, const std::string &comentario) {
    std::string error;
    if (!intentaGuardarPpm(fichero, imagen, comentario, error))
        falla(error);
}
