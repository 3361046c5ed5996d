// Los parches de Bézier de assets/tetera.txt.
#include "ch02_modelado/bezier.h"
#include "soporte.h"

int LLVMFuzzerTestOneInput(const std::uint8_t *datos, std::size_t n) {
    ficheros["p.txt"].assign(datos, datos + n);
    lee([] {
        const std::vector<Parche> parches = leeParches("p.txt");
        exige(!parches.empty());
        for (const Parche &q : parches)
            for (const auto &fila : q.p)
                for (const glm::vec3 p : fila)
                    exige(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    });
    return 0;
}
