// Las mallas v/f.
#include "malla.h"
#include "soporte.h"
#include <cmath>

int LLVMFuzzerTestOneInput(const std::uint8_t *datos, std::size_t n) {
    ficheros["m.vf"].assign(datos, datos + n);
    lee([] {
        const MallaVf m = leeVf("m.vf");
        exige(!m.caras.empty());
        for (const glm::vec3 &v : m.vertices)
            exige(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z));
        for (const auto &cara : m.caras) {
            exige(cara.size() >= 3);
            for (const unsigned i : cara)
                exige(i < m.vertices.size());
        }
    });
    return 0;
}
