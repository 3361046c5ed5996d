// El atlas de los rótulos: genera_letra LETRA.ttf FICHERO escribe, un byte por texel y la fila de abajo primero, la
// distancia con signo de cada texel al borde de su signo, a 127/ALCANCE por texel, y la caja de cada uno
// (common/encima/letra.h).
#include "common/encima/letra.h"
#include <cstdio>
#include <string>
#include <vector>
// clang-format off
#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_MODULE_H
// clang-format on

namespace {

std::vector<unsigned char> atlas(ANCHO_ATLAS *ALTO_ATLAS);
std::vector<CajaSigno> cajas(SIGNOS.size());

// Copia en su celda el signo recién dibujado. Devuelve si cabe.
bool copia(const FT_GlyphSlot &signo, int celda) {
    const FT_Bitmap &b = signo->bitmap;
    const int x0 = ORIGEN_X + signo->bitmap_left, y0 = ORIGEN_Y + signo->bitmap_top - int(b.rows);
    if (x0 < 0 || y0 < 0 || x0 + int(b.width) > ANCHO_CELDA || y0 + int(b.rows) > ALTO_CELDA)
        return false;
    const auto byte = [](int x) { return static_cast<unsigned char>(x); };
    cajas[celda] = {byte(x0 + ALCANCE), byte(y0 + ALCANCE), byte(x0 + int(b.width) - ALCANCE),
                    byte(y0 + int(b.rows) - ALCANCE)};
    const int columna = celda % COLUMNAS_ATLAS * ANCHO_CELDA + x0,
              fila = (FILAS_ATLAS - 1 - celda / COLUMNAS_ATLAS) * ALTO_CELDA + y0;
    for (int y = 0; y < int(b.rows); ++y)
        for (int x = 0; x < int(b.width); ++x)
            atlas[(fila + y) * ANCHO_ATLAS + columna + x] = b.buffer[(int(b.rows) - 1 - y) * b.pitch + x];
    return true;
}

} // namespace

int main(int argc, char **argv) {
    if (argc != 3) {
        std::fprintf(stderr, "uso: genera_letra LETRA.ttf FICHERO\n");
        return 2;
    }
    const auto falla = [](const std::string &que) {
        std::fprintf(stderr, "genera_letra: %s\n", que.c_str());
        return 1;
    };
    FT_Library freetype;
    FT_Face letra;
    FT_Int alcance = ALCANCE;
    if (FT_Init_FreeType(&freetype) || FT_Property_Set(freetype, "sdf", "spread", &alcance))
        return falla("hace falta FreeType 2.11 o posterior");
    if (FT_New_Face(freetype, argv[1], 0, &letra) || FT_Set_Pixel_Sizes(letra, 0, CUADRATIN))
        return falla(std::string("no puedo leer la letra «") + argv[1] + "»");
    for (int i = 0; i < int(SIGNOS.size()); ++i) {
        const FT_UInt indice = FT_Get_Char_Index(letra, SIGNOS[i]);
        const std::string cual = "el signo U+" + std::to_string(unsigned(SIGNOS[i])) + " (decimal)";
        if (!indice || FT_Load_Glyph(letra, indice, FT_LOAD_NO_HINTING))
            return falla("la letra no tiene " + cual);
        if (letra->glyph->outline.n_contours == 0)
            continue; // el espacio
        if (FT_Render_Glyph(letra->glyph, FT_RENDER_MODE_SDF) || !copia(letra->glyph, i))
            return falla("no cabe en su celda " + cual);
    }
    FT_Done_FreeType(freetype);
    FILE *f = std::fopen(argv[2], "wb");
    const bool escrito = f && std::fwrite(atlas.data(), 1, atlas.size(), f) == atlas.size() &&
                         std::fwrite(cajas.data(), sizeof(CajaSigno), cajas.size(), f) == cajas.size();
    if (!f || std::fclose(f) != 0 || !escrito) {
        std::perror((std::string("genera_letra: no puedo escribir ") + argv[2]).c_str());
        return 1;
    }
    return 0;
}
