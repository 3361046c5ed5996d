// Con el bloqueo de mayúsculas puesto `d` llegaría como `D`, que en los programas es otra tecla o ninguna: aquí llega
// como si no lo estuviera. FreeGLUT no lo distingue de la tecla Mayús.
#include <GL/freeglut.h>
#include <cctype>
#include <map>
#ifdef _WIN32
#include <windows.h>
static bool estaPuesto() {
    return (GetKeyState(VK_CAPITAL) & 1) != 0;
}
#else
#include <GL/glx.h>
#include <X11/XKBlib.h>
static bool estaPuesto() {
    XkbStateRec teclado{};
    XkbGetState(glXGetCurrentDisplay(), XkbUseCoreKbd, &teclado);
    return (teclado.locked_mods & LockMask) != 0;
}
#endif

static std::map<int, void (*)(unsigned char, int, int)> delPrograma; // en cada ventana

static void sinBloqueo(unsigned char tecla, int x, int y) {
    if (tecla < 0x80 && std::isalpha(tecla) && estaPuesto())
        tecla = static_cast<unsigned char>(std::islower(tecla) ? std::toupper(tecla) : std::tolower(tecla));
    delPrograma[glutGetWindow()](tecla, x, y);
}

// El enlace con ventana va con --wrap: un programa llama a esta, y la de GLUT es __real_….
extern "C" {
void __real_glutKeyboardFunc(void (*)(unsigned char, int, int));

void __wrap_glutKeyboardFunc(void (*f)(unsigned char, int, int)) {
    delPrograma[glutGetWindow()] = f;
    __real_glutKeyboardFunc(f ? sinBloqueo : nullptr);
}
}
