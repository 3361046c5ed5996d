// Un suelo de baldosas de dos colores, en dos mallas. Sin OpenGL.
#pragma once
#include "malla.h"

/// Las baldosas de lado 1 del suelo, en el plano Y = 0, como las de un tablero: las claras o las oscuras.
inline Malla baldosas(bool oscuras) {
    Malla malla;
    for (int x = -4; x < 4; ++x)
        for (int z = -3; z < 3; ++z) {
            if (((x + z) % 2 != 0) != oscuras)
                continue;
            const unsigned k = unsigned(malla.vertices.size());
            for (const glm::ivec2 e : {glm::ivec2(0, 1), {1, 1}, {1, 0}, {0, 0}})
                malla.vertices.push_back({glm::vec3(x + e.x, 0, z + e.y), {0, 1, 0}, glm::vec2(e)});
            malla.indices.insert(malla.indices.end(), {k, k + 1, k + 2, k, k + 2, k + 3});
        }
    return malla;
}
