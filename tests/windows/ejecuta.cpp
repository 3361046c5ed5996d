// ejecuta aqui|consola -- ORDEN…: la ejecuta y acaba con su estado, que Wine no da de un programa que tarda en
// descargar OpenGL: lo mata. Con «consola», en una nueva, como un doble clic; deja en consola.txt lo último que se ha
// leído en ella y, si dice que se pulse Intro, lo pulsa. Acaba con 250 si ORDEN no termina en dos minutos.
#include <cstdio>
#include <string>
#include <windows.h>

static std::wstring leido() {
    const HANDLE pantalla =
        CreateFileW(L"CONOUT$", GENERIC_READ | GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_WRITE, nullptr,
                    OPEN_EXISTING, 0, nullptr);
    CONSOLE_SCREEN_BUFFER_INFO datos{};
    GetConsoleScreenBufferInfo(pantalla, &datos);
    std::wstring texto;
    for (SHORT y = 0; y <= datos.dwCursorPosition.Y; ++y) {
        std::wstring linea(std::size_t(datos.dwSize.X), L' ');
        DWORD n = 0;
        ReadConsoleOutputCharacterW(pantalla, linea.data(), DWORD(linea.size()), {0, y}, &n);
        texto += linea.substr(0, linea.find_last_not_of(L' ') + 1) + L'\n';
    }
    CloseHandle(pantalla);
    return texto;
}

static void pulsaIntro() {
    const HANDLE teclado =
        CreateFileW(L"CONIN$", GENERIC_READ | GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_WRITE, nullptr,
                    OPEN_EXISTING, 0, nullptr);
    INPUT_RECORD tecla{};
    tecla.EventType = KEY_EVENT;
    tecla.Event.KeyEvent.bKeyDown = TRUE;
    tecla.Event.KeyEvent.wRepeatCount = 1;
    tecla.Event.KeyEvent.wVirtualKeyCode = VK_RETURN;
    tecla.Event.KeyEvent.uChar.UnicodeChar = L'\r';
    DWORD n = 0;
    WriteConsoleInputW(teclado, &tecla, 1, &n);
    CloseHandle(teclado);
}

int main() {
    std::wstring orden = GetCommandLineW();
    const bool nueva = orden.find(L" consola -- ") != std::wstring::npos;
    orden.erase(0, orden.find(L" -- ") + 4);
    STARTUPINFOW como{};
    como.cb = sizeof como;
    PROCESS_INFORMATION proceso{};
    if (!CreateProcessW(nullptr, orden.data(), nullptr, nullptr, !nueva, nueva ? CREATE_NEW_CONSOLE : 0,
                        nullptr, nullptr, &como, &proceso))
        return 249;
    DWORD estado = 250;
    if (!nueva) {
        WaitForSingleObject(proceso.hProcess, INFINITE);
        GetExitCodeProcess(proceso.hProcess, &estado);
        return int(estado);
    }
    // Mientras se mira, la consola no es solo suya: se hace de tarde en tarde y un instante.
    std::wstring texto;
    for (int i = 0; i < 60 && WaitForSingleObject(proceso.hProcess, 2000) == WAIT_TIMEOUT; ++i) {
        FreeConsole();
        if (AttachConsole(proceso.dwProcessId))
            texto = leido();
        if (texto.find(L"Pulsa Intro") != std::wstring::npos)
            pulsaIntro();
        FreeConsole();
    }
    char utf8[20000];
    const int largo =
        WideCharToMultiByte(CP_UTF8, 0, texto.data(), int(texto.size()), utf8, sizeof utf8, nullptr, nullptr);
    std::FILE *fichero = std::fopen("consola.txt", "wb");
    std::fwrite(utf8, 1, std::size_t(largo), fichero);
    std::fclose(fichero);
    if (WaitForSingleObject(proceso.hProcess, 0) == WAIT_OBJECT_0)
        GetExitCodeProcess(proceso.hProcess, &estado);
    else
        TerminateProcess(proceso.hProcess, estado);
    return int(estado);
}
