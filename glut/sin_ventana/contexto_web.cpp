// Contexto WebGL 2 en el elemento <canvas> de la página, que es la ventana. `Module` es la instancia del laboratorio
// que la página ha creado para este programa: en Module.canvas está el elemento y con Module.titulo se le dice el
// título.
#include "contexto.h"
#include "error.h"
#include <emscripten.h>
#include <emscripten/html5.h>

// Con EM_JS y no con EM_ASM, que se encuentra por su dirección: el JavaScript que se hace al enlazar sirve así también
// para un programa que se enlace después, en la página.
// clang-format off
EM_JS(void, laboratorioLienzo, (), { specialHTMLTargets["!canvas"] = Module["canvas"]; });
EM_JS(int, laboratorioSuaviza, (), { return Module["suavizado"] ? 1 : 0; });
EM_JS(void, laboratorioTitulo, (const char *titulo), {
    if (Module["titulo"]) Module["titulo"](UTF8ToString(titulo));
});
// clang-format on

namespace sin_ventana {

bool plantillaPedida = false; // la mira quien explica (herramientas/explica/lee_web.cpp)

namespace {

const char *const LIENZO = "!canvas"; // el de Module, que no tiene por qué estar en el documento
EMSCRIPTEN_WEBGL_CONTEXT_HANDLE contexto = 0;

} // namespace

int creaContexto(int ancho, int alto, bool profundidad, bool plantilla, bool muestras) {
    laboratorioLienzo();
    emscripten_set_canvas_element_size(LIENZO, ancho, alto);
    EmscriptenWebGLContextAttributes atributos;
    // trae puestas todas las extensiones, que los framebuffers de float necesitan
    emscripten_webgl_init_context_attributes(&atributos);
    atributos.majorVersion = 2;
    atributos.alpha = false;
    atributos.depth = profundidad;
    atributos.stencil = profundidad || plantilla; // sin ella, Firefox no deja copiar la profundidad
    plantillaPedida = plantilla;
    atributos.antialias = muestras && laboratorioSuaviza();
    atributos.preserveDrawingBuffer = true; // como en una ventana, lo que no se vuelve a dibujar sigue ahí
    contexto = emscripten_webgl_create_context(LIENZO, &atributos);
    if (contexto <= 0 || emscripten_webgl_make_context_current(contexto) != EMSCRIPTEN_RESULT_SUCCESS)
        falla("este navegador no da WebGL 2: activa en él la aceleración gráfica, actualízalo o prueba con "
              "otro");
    return 0; // las que haya, las promedia él al leer
}

void cambiaTallaContexto(int ancho, int alto) {
    emscripten_set_canvas_element_size(LIENZO, ancho, alto);
}

void destruyeContexto() {
    emscripten_webgl_destroy_context(contexto);
}

void (*direccionGL(const char *))() {
    return nullptr; // las de WebGL 2 están enlazadas, y de las demás no hay ninguna
}

void diTitulo(const char *titulo) {
    laboratorioTitulo(titulo);
}

void cedeAlNavegador() {
    emscripten_exit_with_live_runtime();
}

} // namespace sin_ventana
