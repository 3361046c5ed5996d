// Lo único que distingue OSMesa, EGL y el navegador: crear el contexto, cambiar de tamaño su framebuffer y, en el
// último, enseñar el título y esperar a los sucesos.
#pragma once
#include <cstdlib>

namespace sin_ventana {

/// Crea un contexto OpenGL 3.1 de ancho × alto y lo hace actual; termina con un mensaje si no puede.
/// Sin `profundidad` o `plantilla` el framebuffer no tiene esos buffers, como en una ventana. Las `muestras` las dan el
/// navegador y, si está LAB_SUAVIZA en el entorno, EGL. Devuelve las que tiene cada píxel al leerlo, o 0.
int creaContexto(int ancho, int alto, bool profundidad, bool plantilla, bool muestras);

/// Cambia el tamaño del framebuffer; los objetos del contexto se conservan, su contenido no.
void cambiaTallaContexto(int ancho, int alto);

void destruyeContexto();

/// Mesa da por omisión un 4.5: así no pasa nada que no esté en OpenGL 3.1 (sin lo obsoleto: FC) y GLSL 1.40.
inline void limitaMesa() {
    setenv("MESA_GL_VERSION_OVERRIDE", "3.1FC", 0);
    setenv("MESA_GLSL_VERSION_OVERRIDE", "140", 0);
}

/// Enseña el título de la ventana, donde se puede ver.
void diTitulo(const char *titulo);

/// Donde los sucesos llegan después, por glutOrden, deja el programa vivo y no vuelve. En los demás no hace nada.
void cedeAlNavegador();

/// Dirección de una función de OpenGL, o nulo.
void (*direccionGL(const char *nombre))();

} // namespace sin_ventana
