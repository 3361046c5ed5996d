// Desde dónde se llama a OpenGL: las llamadas en curso que son del ejecutable, cada pila una sola vez.
#pragma once
#include "json.h"

namespace explica {

/// El número de la pila que hay ahora; -1 si no se puede saber.
int pilaActual();

/// Todas. De cada una, de dentro a fuera, dónde está en el ejecutable cada llamada: lo que se da a addr2line.
std::vector<Json> pilasEnJson();

} // namespace explica
