#include "imagen.h"
#include "error.h"
#include "glut/sistema/guarda.h"
#include "numero.h"
#include "rutas.h"
#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <optional>

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

std::string comoSeConvierte(const std::string &fichero) {
    return "; se convierte con: convert \"" + fichero + "\" -depth 8 imagen.ppm";
}

Imagen deRgb(const std::string &fichero, const std::string &datos, int ancho, int alto) {
    compruebaTalla(fichero, ancho, alto, datos.size());
    return desdeArriba(datos.data(), ancho, alto);
}

Imagen dePpm(const std::string &fichero, const std::string &datos, std::string *comentario) {
    if (datos.compare(0, 2, "P6") != 0)
        falla("«" + fichero + "» no es un PPM binario (no empieza por P6)" + comoSeConvierte(fichero));
    std::size_t i = 2;
    const int ancho = numeroDeCabecera(datos, i, fichero, comentario);
    const int alto = numeroDeCabecera(datos, i, fichero, comentario);
    if (numeroDeCabecera(datos, i, fichero, comentario, 65535) != 255)
        falla("«" + fichero + "»: solo se leen PPM de 8 bits (máximo 255)" + comoSeConvierte(fichero));
    if (i == datos.size() || !esBlanco(datos[i++])) // uno solo separa la cabecera de los datos
        falla("«" + fichero + "»: la cabecera del PPM no es válida");
    if (datos.compare(i - 1, 2, "\r\n") == 0 && datos.size() - i == std::size_t(3) * ancho * alto + 1)
        ++i; // como acaban las líneas en Windows
    compruebaTalla(fichero, ancho, alto, datos.size() - i);
    return desdeArriba(datos.data() + i, ancho, alto);
}

void compruebaLados(const std::string &fichero, int ancho, int alto) {
    if (ancho < 1 || alto < 1 || ancho > LADO_MAXIMO || alto > LADO_MAXIMO)
        falla("«" + fichero + "»: no hay texturas de " + std::to_string(ancho) + "×" + std::to_string(alto));
}

// Por sus primeros bytes y no por su nombre; leída una vez, que puede ser una tubería. Ancho 0: no se ha dicho -talla.
Imagen leeImagen(const std::string &fichero, int ancho, int alto) {
    static const std::pair<const char *, const char *> FORMATOS[] = {
        {"\x89PNG", "PNG"}, {"\xFF\xD8", "JPEG"}, {"GIF8", "GIF"}, {"RIFF", "WebP"}, {"BM", "BMP"}};
    const std::string datos = leeFichero(fichero);
    const bool esRgb = ancho > 0 && datos.size() == std::size_t(3) * ancho * alto;
    if (!esRgb && datos.size() > 1 && datos[0] == 'P' && std::isdigit(datos[1]))
        return dePpm(fichero, datos, nullptr);
    for (const auto &[principio, nombre] : FORMATOS)
        if (!esRgb && datos.compare(0, std::strlen(principio), principio) == 0)
            falla("«" + fichero + "» es un " + nombre +
                  ", y aquí se leen PPM binarios (P6) y RGB sin cabecera" + comoSeConvierte(fichero));
    if (ancho == 0)
        falla("«" + fichero + "»: de un fichero RGB sin cabecera hay que decir -talla ANCHOxALTO", 2);
    compruebaLados(fichero, ancho, alto);
    return deRgb(fichero, datos, ancho, alto);
}

} // namespace

Imagen leeTextura(const std::string &fichero, int ancho, int alto) {
    compruebaLados(fichero, ancho, alto);
    return deRgb(fichero, leeFichero(fichero), ancho, alto);
}

Imagen leePpm(const std::string &fichero, std::string *comentario) {
    return dePpm(fichero, leeFichero(fichero), comentario);
}

Imagen imagenDeArgumentos(int argc, char **argv, const std::string &porOmision, int ancho, int alto) {
    return imagenesDeArgumentos(argc, argv, {{porOmision, ancho, alto}})[0];
}

std::vector<Imagen> imagenesDeArgumentos(int argc, char **argv,
                                         const std::vector<ImagenPorOmision> &porOmision) {
    const std::size_t cuantas = porOmision.size();
    const std::string varias = cuantas == 1 ? "una imagen" : std::to_string(cuantas) + " imágenes";
    std::vector<std::string> ficheros;
    int ancho = 0, alto = 0;
    for (int i = 1; i < argc; ++i) {
        const std::string argumento = argv[i];
        if (argumento == "-talla" && ancho == 0) {
            if (++i == argc || !leeTalla(argv[i], ancho, alto))
                falla("detrás de -talla va el tamaño, ANCHOxALTO", 2);
        } else if (!argumento.empty() && argumento[0] != '-' && ficheros.size() < cuantas) {
            ficheros.push_back(argumento);
        } else {
            falla("sobra «" + argumento + "»: solo se dan " + varias, 2);
        }
    }
    std::vector<Imagen> imagenes;
    if (ficheros.empty() && ancho == 0) {
        for (const ImagenPorOmision &i : porOmision)
            imagenes.push_back(leeTextura(recurso(i.recurso), i.ancho, i.alto));
        return imagenes;
    }
    if (ficheros.size() < cuantas)
        falla("se dan " + varias + ", y hay " + std::to_string(ficheros.size()), 2);
    for (const std::string &fichero : ficheros)
        imagenes.push_back(leeImagen(fichero, ancho, alto));
    return imagenes;
}

std::string enPng(const Imagen &imagen) {
    const auto entero = [](std::uint32_t n) {
        return std::string{char(n >> 24), char(n >> 16), char(n >> 8), char(n)};
    };
    const auto trozo = [&](const std::string &tipo, const std::string &datos) {
        std::uint32_t crc = ~0u;
        for (const char c : tipo + datos) {
            crc ^= static_cast<unsigned char>(c);
            for (int bit = 0; bit < 8; ++bit)
                crc = crc >> 1 ^ (crc & 1 ? 0xEDB88320u : 0);
        }
        return entero(std::uint32_t(datos.size())) + tipo + datos + entero(~crc);
    };
    const std::size_t fila = std::size_t(3) * imagen.ancho;
    std::string datos = "\x78\x01"; // zlib: cada fila, con su filtro (ninguno), en un bloque sin comprimir
    std::uint32_t a = 1, b = 0;     // de Adler-32
    for (int y = imagen.alto - 1; y >= 0; --y) {
        const std::string linea =
            '\0' + std::string(reinterpret_cast<const char *>(&imagen.rgb[fila * y]), fila);
        for (std::size_t i = 0; i < linea.size(); i += 0xFFFF) { // un bloque no tiene más
            const std::string bloque = linea.substr(i, 0xFFFF);
            const std::size_t n = bloque.size();
            const bool ultimo = y == 0 && i + n == linea.size();
            datos += std::string{char(ultimo), char(n), char(n >> 8), char(~n), char(~n >> 8)} + bloque;
        }
        for (const char c : linea) {
            a = (a + static_cast<unsigned char>(c)) % 65521;
            b = (b + a) % 65521;
        }
    }
    return "\x89PNG\r\n\x1A\n" +
           trozo("IHDR", entero(imagen.ancho) + entero(imagen.alto) + std::string("\x08\x02\0\0\0", 5)) +
           trozo("IDAT", datos + entero(b << 16 | a)) + trozo("IEND", "");
}

bool intentaGuardarPpm(const std::string &fichero, const Imagen &imagen, const std::string &comentario,
                       std::string &error) {
    std::string bytes = "P6\n" + (comentario.empty() ? "" : "# " + comentario + "\n") +
                        std::to_string(imagen.ancho) + " " + std::to_string(imagen.alto) + "\n255\n";
    const std::size_t fila = std::size_t(3) * imagen.ancho;
    for (int y = imagen.alto - 1; y >= 0; --y)
        bytes.append(reinterpret_cast<const char *>(&imagen.rgb[fila * y]), fila);
    return intentaGuardar(fichero, bytes, error);
}

void guardaPpm(const std::string &fichero, const Imagen &imagen, const std::string &comentario) {
    std::string error;
    if (!intentaGuardarPpm(fichero, imagen, comentario, error))
        falla(error);
}
