// La letra de los rótulos: los signos que hay (el último, por los que no) y su atlas, que hace assets/genera_letra.cpp
// y está en assets/letra.r8. Es una rejilla de celdas iguales, por filas desde arriba, con la distancia de cada texel
// al borde de su signo: 128 en él, más dentro y menos fuera. Detrás de los texels, la caja de cada signo.
#pragma once
#include <string>
#include <string_view>

constexpr std::u32string_view SIGNOS =
    U" !\"#$%&'()*+,-./0123456789:;<=>?@ABCDEFGHIJKLMNOPQRSTUVWXYZ[\\]^_`abcdefghijklmnopqrstuvwxyz{|}~"
    U"¡«°±²³·º»¿ÁÉÍÑÓÚÜ×áéíñóúü÷ΓΔΘΛΠΣΦΨΩαβγδεθλμπρσφψω′″…←↑→↓−√∞≈≠≤≥ᵀ⁻¹⎡⎢⎣⎤⎥⎦—□";

// En texels. La letra es DejaVu Sans Mono Bold.
constexpr int CUADRATIN = 32,
              ALCANCE = 6; // hasta esa distancia del borde, por dentro y por fuera, la da el atlas
constexpr int ANCHO_CELDA = 32, ALTO_CELDA = 52, COLUMNAS_ATLAS = 16;
constexpr int FILAS_ATLAS = (int(SIGNOS.size()) + COLUMNAS_ATLAS - 1) / COLUMNAS_ATLAS;
constexpr int ANCHO_ATLAS = COLUMNAS_ATLAS * ANCHO_CELDA, ALTO_ATLAS = FILAS_ATLAS * ALTO_CELDA;
constexpr int ORIGEN_X = ALCANCE,
              ORIGEN_Y = 15; // el de cada signo, en la línea base, desde abajo a la izquierda de su celda
constexpr float MAYUSCULA = 23.3f, AVANCE = 19.27f;

/// Lo que ocupa un signo en su celda, sin el ALCANCE que le queda alrededor.
struct CajaSigno {
    unsigned char x0, y0, x1, y1;
};

struct Letra {
    std::string fichero;
    const unsigned char *texels() const; // ANCHO_ATLAS × ALTO_ATLAS, la fila de abajo primero
    CajaSigno caja(int signo) const;
};

/// La letra, que se lee la primera vez.
const Letra &letra();
