// glewInit sin ventana. GLEW carga todas las funciones y después da error, porque no encuentra GLX; quien escribe su
// main lo mira, como manda su documentación. Aquí está bien si están las funciones.
#include <GL/glew.h>

extern "C" {
GLenum __real_glewInit(void);
GLenum __wrap_glewInit(void); // el enlazador la pone por glewInit

GLenum __wrap_glewInit(void) {
    const GLenum error = __real_glewInit();
    return GLEW_VERSION_3_1 && glGenVertexArrays ? GLEW_OK : error;
}
}
