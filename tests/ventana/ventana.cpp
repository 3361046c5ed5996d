// ventana espera: espera a que haya una en la pantalla, le da el teclado y escribe su identificador; falla si antes se
// acaba la entrada estándar, o en medio minuto.
// ventana cierra VENTANA: la cierra como la X de su marco, que pone el gestor de ventanas: le manda WM_DELETE_WINDOW.
#include <X11/Xlib.h>
#include <cstdio>
#include <cstdlib>
#include <poll.h>
#include <string>
#include <unistd.h>

static Window visible(Display *pantalla) {
    Window raiz, padre, *hijas = nullptr, hallada = None;
    unsigned cuantas = 0;
    XQueryTree(pantalla, DefaultRootWindow(pantalla), &raiz, &padre, &hijas, &cuantas);
    for (unsigned i = 0; i < cuantas; ++i) {
        XWindowAttributes como;
        if (XGetWindowAttributes(pantalla, hijas[i], &como) && como.map_state == IsViewable)
            hallada = hijas[i];
    }
    XFree(hijas);
    return hallada;
}

static int espera(Display *pantalla) {
    XSelectInput(pantalla, DefaultRootWindow(pantalla), SubstructureNotifyMask);
    Window ventana;
    while (!(ventana = visible(pantalla))) {
        pollfd de[] = {{ConnectionNumber(pantalla), POLLIN, 0}, {STDIN_FILENO, POLLIN, 0}};
        if (!XPending(pantalla) && (poll(de, 2, 30000) <= 0 || de[1].revents))
            return 1;
        XSync(pantalla, True); // se olvidan los sucesos: se mira cómo está
    }
    XSetInputFocus(pantalla, ventana, RevertToParent, CurrentTime);
    std::printf("%lu\n", ventana);
    return 0;
}

static int cierra(Display *pantalla, Window ventana) {
    XEvent suceso{};
    suceso.xclient.type = ClientMessage;
    suceso.xclient.window = ventana;
    suceso.xclient.message_type = XInternAtom(pantalla, "WM_PROTOCOLS", False);
    suceso.xclient.format = 32;
    suceso.xclient.data.l[0] = long(XInternAtom(pantalla, "WM_DELETE_WINDOW", False));
    suceso.xclient.data.l[1] = CurrentTime;
    return !XSendEvent(pantalla, ventana, False, NoEventMask, &suceso);
}

int main(int argc, char **argv) {
    const std::string orden = argc > 1 ? argv[1] : "";
    Display *pantalla = XOpenDisplay(nullptr);
    if (!pantalla || !(orden == "espera" ? argc == 2 : orden == "cierra" && argc == 3)) {
        std::fprintf(stderr, "uso: ventana espera | cierra VENTANA, con DISPLAY\n");
        return 2;
    }
    const int estado =
        orden == "espera" ? espera(pantalla) : cierra(pantalla, std::strtoul(argv[2], nullptr, 0));
    XCloseDisplay(pantalla);
    return estado;
}
