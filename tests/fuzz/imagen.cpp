// Las imágenes PPM y, con los dos primeros bytes como tamaño, las RGB sin cabecera; y el ANCHOxALTO de -talla.
#include "imagen.h"
#include "numero.h"
#include "soporte.h"

static void esperaEntera(const Imagen &i) {
    exige(i.ancho >= 1 && i.alto >= 1);
    exige(i.rgb.size() == 3 * std::size_t(i.ancho) * i.alto);
}

int LLVMFuzzerTestOneInput(const std::uint8_t *datos, std::size_t n) {
    std::string &fichero = ficheros["f.ppm"];
    fichero.assign(datos, datos + n);
    lee([] {
        std::string comentario;
        esperaEntera(leePpm("f.ppm", &comentario));
        exige(comentario.find('\n') == std::string::npos);
    });
    int ancho = 0, alto = 0;
    exige(!leeTalla(fichero, ancho, alto) || (ancho >= 1 && alto >= 1));
    if (n >= 2) {
        fichero.erase(0, 2);
        lee([datos] { esperaEntera(leeTextura("f.ppm", datos[0], datos[1])); });
    }
    return 0;
}
