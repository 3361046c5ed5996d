// De GLSL 1.40 a GLSL ES 3.00, el de WebGL 2. Los programas se atienen a lo que hay en los dos (diseño: web), y así
// basta con cambiar la primera línea del shader, «#version 140», por estas. Las demás conservan su número para los
// errores.
#pragma once
#include <string>

namespace sin_ventana {

const char *const CABECERA_ESSL = R"(#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler3D;
precision highp samplerCube;
precision highp sampler2DShadow;
precision highp usampler2D;
#line 2
)";

inline std::string enEssl(const std::string &shader) {
    const std::string version = "#version 140\n";
    return shader.compare(0, version.size(), version) == 0 ? CABECERA_ESSL + shader.substr(version.size())
                                                           : shader;
}

} // namespace sin_ventana
