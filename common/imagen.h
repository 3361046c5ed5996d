// Imágenes RGB de 8 bits por componente: lectura de texturas RGB (listado 6.1) y ficheros PPM.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

/// Imagen de ancho × alto texels, 3 bytes por texel sin relleno entre filas.
/// La primera fila es la de ABAJO, como la quiere glTexImage2D y la da glReadPixels; los ficheros
/// empiezan por la de arriba, y leer y guardar dan la vuelta.
struct Imagen {
    int ancho = 0, alto = 0;
    std::vector<unsigned char> rgb;
};

/// Una componente de 0 a 1 (si se sale, el extremo), en el byte más cercano.
template<class T>
unsigned char enOchoBits(T componente) {
    return static_cast<unsigned char>(std::lround(255 * std::clamp(componente, T(0), T(1))));
}

/// Lee un fichero RGB sin cabecera (listado 6.1). Su tamaño debe ser exactamente ancho·alto·3 bytes:
/// si no, termina diciendo el esperado y el encontrado.
Imagen leeTextura(const std::string &fichero, int ancho, int alto);

/// Lee un PPM binario (P6) de 8 bits. Si `comentario` no es nulo, recibe el primer comentario de la cabecera.
Imagen leePpm(const std::string &fichero, std::string *comentario = nullptr);

/// La imagen que se pide en la línea de órdenes, una vez que abreVentana ha quitado lo suyo: «FOTO.ppm» o
/// «FOTO.rgb -talla ANCHOxALTO» (qué es lo dicen sus primeros bytes y no su nombre); sin argumentos, el recurso
/// `porOmision`, RGB de ancho × alto. Si los argumentos no son esos, termina con estado 2.
Imagen imagenDeArgumentos(int argc, char **argv, const std::string &porOmision, int ancho, int alto);

/// Lo mismo con varias imágenes: en los argumentos van todas o ninguna, y -talla es el tamaño de todas las RGB.
struct ImagenPorOmision {
    std::string recurso;
    int ancho, alto;
};
std::vector<Imagen> imagenesDeArgumentos(int argc, char **argv,
                                         const std::vector<ImagenPorOmision> &porOmision);

/// Guarda un PPM binario, entero o nada (intentaGuardar). Si falla, termina diciendo por qué.
void guardaPpm(const std::string &fichero, const Imagen &imagen, const std::string &comentario = "");

/// Como guardaPpm, pero si falla devuelve false y deja en `error` por qué.
bool intentaGuardarPpm(const std::string &fichero, const Imagen &imagen, const std::string &comentario,
                       std::string &error);

/// Los bytes de un PNG, que abre cualquiera; sin comprimir.
std::string enPng(const Imagen &imagen);
