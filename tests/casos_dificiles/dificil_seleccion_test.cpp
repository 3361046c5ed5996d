// Casos difíciles de la selección por color (capítulo 10): cada identificador, pintado en un framebuffer de 8 bits y
// leído.
#include "ch10_interaccion/identificador.h"
#include "cota.h"
#include "sonda.h"

namespace {

/// Lo que se lee menos lo que se pintó.
double errorDeIdentificador(unsigned identificador) {
    static GLuint programa = 0;
    if (programa == 0) {
        programa = creaSonda("ch10_interaccion/identificador.frag"); // que abre el contexto
        enlazaUnPixel(GL_RGBA8);
    }
    glUseProgram(programa);
    envia(programa, "identificador", colorDe(identificador));
    glDrawArrays(GL_TRIANGLES, 0, 3);
    unsigned char leido[4] = {};
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, leido);
    return std::fabs(double(identificadorDe({leido[0], leido[1], leido[2]})) - identificador);
}

const Cotas IDENTIFICADORES([] {
    acotaCada<unsigned>("Identificador", "id_*",
                        {0u, 1u, 127u, 128u, 255u, 256u, 65535u, 65536u, 8388608u, IDENTIFICADOR_MAXIMO}, 0,
                        "diferencia", errorDeIdentificador);
    acota("Identificador", "todos_los_de_un_bit_menos", 0, "diferencia", [] {
        return peorHasta(24,
                         [](int bit) { return errorDeIdentificador(IDENTIFICADOR_MAXIMO ^ (1u << bit)); });
    });
});

} // namespace

// El que no cabe termina con un mensaje, y no se confunde con otro.
TEST(IdentificadorImposibleDeathTest, DosALa24) {
    EXPECT_EXIT(rgbDe(1u << 24), testing::ExitedWithCode(1), "16777216 no cabe en 24 bits");
}
