// El reescritor de shaders para la página, en un .wasm que se descarga la primera vez que se explica un píxel.
#include "glsl.h"
#include "json.h"
#include <emscripten.h>

using namespace explica;

extern "C" {

/// En JSON: fuente, notas (clase, linea, nombre, tipo, funcion y los pasos que ocupa) y sinSeguir (linea y motivo).
EMSCRIPTEN_KEEPALIVE const char *explicaReescribe(const char *fuente, int salidas, int deVertices) {
    static std::string json;
    const Reescrito r = reescribe(fuente, salidas, deVertices ? Etapa::Vertices : Etapa::Fragmento);
    std::vector<Json> notas, sinSeguir;
    for (const Nota &n : r.notas)
        notas.push_back(Json()
                            .pon("clase", int(n.clase))
                            .pon("linea", n.linea)
                            .pon("nombre", n.nombre)
                            .pon("tipo", n.tipo)
                            .pon("funcion", n.funcion)
                            .pon("pasos", pasosDe(n.tipo)));
    for (const Aviso &a : r.sinSeguir)
        sinSeguir.push_back(Json().pon("linea", a.linea).pon("motivo", a.motivo));
    json = Json().pon("fuente", r.fuente).pon("notas", notas).pon("sinSeguir", sinSeguir).texto();
    return json.c_str();
}

} // extern "C"
