// Lo que el enlace con ventana añade en Windows, sin que los programas hagan nada: su consola entiende UTF-8, y un
// error se puede leer aunque la consola se abra y se cierre con el programa, como tras un doble clic.
#include "error.h"
#include <GL/freeglut.h>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <io.h>
#include <windows.h>

namespace {

UINT paginaDeAntes = 0;

void fallaFreeglut(const char *formato, va_list valores) {
    char texto[500];
    std::vsnprintf(texto, sizeof texto, formato, valores);
    falla(std::string("FreeGLUT: ") + texto);
}

// Si nadie más usa la consola, como el símbolo del sistema desde el que se llama a un programa.
bool consolaPropia() {
    DWORD procesos[2];
    return GetConsoleProcessList(procesos, 2) == 1;
}

void despide() {
    // cerrar la ventana o Esc deshacen lo que hizo glutInit; si no, el programa no ha podido seguir o era de consola
    if (glutGet(GLUT_INIT_STATE) && consolaPropia()) {
        if (HDC ventana = wglGetCurrentDC())
            ShowWindow(WindowFromDC(ventana), SW_HIDE); // ya no atiende
        std::fprintf(stderr, "\nPulsa Intro para cerrar esta ventana.\n");
        std::fflush(nullptr);
        std::getchar();
    }
    SetConsoleOutputCP(paginaDeAntes);
}

[[maybe_unused]] const bool preparada = [] {
    paginaDeAntes = GetConsoleOutputCP();
    SetConsoleOutputCP(CP_UTF8);
    for (FILE *salida : {stdout, stderr}) {
        _setmode(_fileno(salida), _O_BINARY); // en modo texto los bytes no llegan tal cual a la consola
        std::setvbuf(salida, nullptr, _IOFBF,
                     BUFSIZ); // sin búfer van de uno en uno, y no junta los de una letra
    }
    glutInitErrorFunc(fallaFreeglut);
    return std::atexit(despide) == 0 && std::atexit(compruebaSalida) == 0;
}();

} // namespace
