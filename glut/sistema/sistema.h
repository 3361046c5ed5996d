// Lo que cada sistema hace a su manera: posix.cpp (también el navegador) y windows.cpp, que elige CMake.
#pragma once
#include <filesystem>
#include <memory>
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

/// Mientras existe, las señales que acaban un programa esperan, y escribir más de lo que se puede es un error como los
/// demás: lo que se está escribiendo no se queda a medias. En Windows no hay nada que hacer.
class SinSenales {
public:
    SinSenales();
    ~SinSenales();
    SinSenales(const SinSenales &) = delete;
    SinSenales &operator=(const SinSenales &) = delete;

private:
    struct Antes;
    std::unique_ptr<Antes> antes;
};
