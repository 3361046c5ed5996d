// El reescritor de shaders para la página, en un .wasm que se descarga la primera vez que se explica un píxel.
#include "glsl.h"
#include <emscripten.h>

using namespace explica;

namespace {

std::string entreComillas(const std::string &s) {
    std::string t = "\"";
    for (const char c : s)
        if (c == '"' || c == '\\')
            t += std::string("\\") + c;
        else
            t += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    return t + '"';
}

} // namespace

extern "C" {

/// En JSON: fuente, notas (clase, linea, nombre, tipo, funcion y los pasos que ocupa) y sinSeguir (linea y motivo).
EMSCRIPTEN_KEEPALIVE const char *explicaReescribe(const char *fuente, int salidas, int deVertices) {
    static std::string json;
    const Reescrito r = reescribe(fuente, salidas, deVertices ? Etapa::Vertices : Etapa::Fragmento);
    json = "{\"fuente\":\"";
    for (const char c : r.fuente) // sin comillas: GLSL no las tiene
        json += c == '\n' ? "\\n" : std::string(1, c);
    json += "\",\"notas\":[";
    for (const Nota &n : r.notas)
        json += std::string(&n == &r.notas[0] ? "" : ",") + "{\"clase\":" + std::to_string(int(n.clase)) +
                ",\"linea\":" + std::to_string(n.linea) + ",\"nombre\":" + entreComillas(n.nombre) +
                ",\"tipo\":" + entreComillas(n.tipo) + ",\"funcion\":" + entreComillas(n.funcion) +
                ",\"pasos\":" + std::to_string(pasosDe(n.tipo)) + "}";
    json += "],\"sinSeguir\":[";
    for (const Aviso &a : r.sinSeguir)
        json += std::string(&a == &r.sinSeguir[0] ? "" : ",") + "{\"linea\":" + std::to_string(a.linea) +
                ",\"motivo\":" + entreComillas(a.motivo) + "}";
    json += "]}";
    return json.c_str();
}

} // extern "C"
