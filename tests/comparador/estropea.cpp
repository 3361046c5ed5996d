// estropea ENTRADA.ppm SALIDA.ppm COMPONENTE PÍXELES NIVELES [sin_sello]
// Copia un PPM con los primeros PÍXELES (desde abajo a la izquierda) NIVELES más allá en un componente (0, 1 o 2): con
// eso se prueba que el comparador lo nota (defectos.sh).
#include "error.h"
#include "imagen.h"
#include "numero.h"

int main(int argc, char **argv) {
    if (argc < 6)
        falla("uso: estropea ENTRADA SALIDA COMPONENTE PÍXELES NIVELES [sin_sello]", 2);
    const auto componente = numeroDe<std::size_t>(argv[3]), pixeles = numeroDe<std::size_t>(argv[4]);
    const auto niveles = numeroDe<int>(argv[5]);
    std::string sello;
    Imagen imagen = leePpm(argv[1], &sello);
    if (!componente || *componente > 2 || !pixeles || 3 * *pixeles > imagen.rgb.size() || !niveles)
        falla("esos números no valen para «" + std::string(argv[1]) + "»", 2);
    for (std::size_t i = *componente; i < 3 * *pixeles; i += 3)
        imagen.rgb[i] = static_cast<unsigned char>(imagen.rgb[i] +
                                                   (imagen.rgb[i] + *niveles > 255 ? -*niveles : *niveles));
    guardaPpm(argv[2], imagen, argc > 6 ? "" : sello);
    return 0;
}
