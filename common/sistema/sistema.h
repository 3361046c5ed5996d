// Lo que cada sistema hace a su manera: posix.cpp (también el navegador) y windows.cpp, que elige CMake.
#pragma once
#include <filesystem>
#include <string>

/// Ruta del ejecutable; vacía si no se puede saber.
std::filesystem::path ejecutable();

/// El nombre con que se le llama, sin carpeta.
std::string nombreDelEjecutable();

/// Lo que separa las carpetas de $PATH.
extern const char SEPARADOR_DE_CARPETAS;

/// El número del proceso: con él, dos a la vez no escriben en el mismo fichero.
int numeroDeProceso();

/// Desde qué FreeGLUT van en UTF-8 los títulos de las ventanas.
extern const int FREEGLUT_CON_UTF8;
