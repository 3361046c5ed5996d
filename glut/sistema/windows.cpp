#include "sistema.h"
#include <process.h>
#include <windows.h>

const char SEPARADOR_DE_CARPETAS = ';';
const int FREEGLUT_CON_UTF8 = 0; // el manifiesto del ejecutable hace UTF-8 la página de códigos

std::filesystem::path ejecutable() {
    wchar_t ruta[32768]; // ninguna es más larga
    const DWORD largo = GetModuleFileNameW(nullptr, ruta, DWORD(std::size(ruta)));
    return std::filesystem::path(ruta, ruta + largo);
}

std::string nombreDelEjecutable() {
    return ejecutable().stem().u8string();
}

int numeroDeProceso() {
    return _getpid();
}

struct SinSenales::Antes {};
SinSenales::SinSenales() = default;
SinSenales::~SinSenales() = default;
