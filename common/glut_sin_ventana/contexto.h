// Lo único que distingue OSMesa de EGL: crear el contexto y cambiar de tamaño su framebuffer.
#pragma once

namespace sin_ventana {

/// Crea un contexto OpenGL 3.1 de ancho × alto y lo hace actual; termina con un mensaje si no puede.
/// Sin `profundidad` o `plantilla` el framebuffer no tiene esos buffers, como en una ventana.
void creaContexto(int ancho, int alto, bool profundidad, bool plantilla);

/// Cambia el tamaño del framebuffer; los objetos del contexto se conservan, su contenido no.
void cambiaTallaContexto(int ancho, int alto);

void destruyeContexto();

/// Dirección de una función de OpenGL, o nulo.
void (*direccionGL(const char *nombre))();

} // namespace sin_ventana
