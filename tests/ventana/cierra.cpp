// cierra VENTANA: la cierra como la X de su marco, que pone el gestor de ventanas: le manda WM_DELETE_WINDOW.
#include <X11/Xlib.h>
#include <cstdio>
#include <cstdlib>

int main(int argc, char **argv) {
    Display *pantalla = XOpenDisplay(nullptr);
    if (argc != 2 || !pantalla) {
        std::fprintf(stderr, "uso: cierra VENTANA, con DISPLAY\n");
        return 2;
    }
    XEvent suceso{};
    suceso.xclient.type = ClientMessage;
    suceso.xclient.window = std::strtoul(argv[1], nullptr, 0);
    suceso.xclient.message_type = XInternAtom(pantalla, "WM_PROTOCOLS", False);
    suceso.xclient.format = 32;
    suceso.xclient.data.l[0] = long(XInternAtom(pantalla, "WM_DELETE_WINDOW", False));
    suceso.xclient.data.l[1] = CurrentTime;
    XSendEvent(pantalla, suceso.xclient.window, False, NoEventMask, &suceso);
    XCloseDisplay(pantalla);
}
