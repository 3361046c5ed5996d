// Guardar un fichero entero o nada.
#pragma once
#include <string>

/// Guarda esos bytes: se escriben aparte y se renombra al final; por un enlace, donde apunta. Un dispositivo
/// (/dev/full, una tubería) se escribe directamente. Si falla devuelve false y deja en `error` por qué.
bool intentaGuardar(const std::string &fichero, const std::string &bytes, std::string &error);
