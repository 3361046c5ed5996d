// ventana espera: espera a que haya una en la pantalla, le da el teclado y escribe su identificador; falla si antes se
// acaba la entrada estándar, o en medio minuto.
// ventana activa CLASE: escribe el identificador de la que tiene el teclado bajo un gestor de ventanas, si es de esa
// clase; si no, falla.
// ventana gobernada: falla si no hay un gestor de ventanas.
// ventana atiende VENTANA: espera a que su programa haya atendido lo que le ha llegado: al _NET_WM_PING contesta
// detrás.
// ventana cierra VENTANA: la cierra como la X de su marco, que pone el gestor de ventanas: le manda WM_DELETE_WINDOW.
#include <X11/Xlib.h>
#include <X11/Xutil.h>
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

static bool esDe(Display *pantalla, Window ventana, const std::string &clase) {
    XClassHint nombres{};
    const bool es = XGetClassHint(pantalla, ventana, &nombres) && clase == nombres.res_name;
    XFree(nombres.res_name);
    XFree(nombres.res_class);
    return es;
}

static int activa(Display *pantalla, const std::string &clase) {
    XSetErrorHandler([](Display *, XErrorEvent *) { return 0; }); // puede cerrarse mientras se mira
    Window ventana = None;
    int vuelve;
    XGetInputFocus(pantalla, &ventana, &vuelve);
    XWindowAttributes como;
    if (ventana <= PointerRoot || !esDe(pantalla, ventana, clase) ||
        !XGetWindowAttributes(pantalla, ventana, &como) || como.map_state != IsViewable)
        return 1;
    std::printf("%lu\n", ventana);
    return 0;
}

static int gobernada(Display *pantalla) {
    XWindowAttributes raiz;
    XGetWindowAttributes(pantalla, DefaultRootWindow(pantalla), &raiz);
    return !(raiz.all_event_masks & SubstructureRedirectMask); // que solo puede pedir uno
}

static bool manda(Display *pantalla, Window ventana, const char *que) {
    XEvent suceso{};
    suceso.xclient.type = ClientMessage;
    suceso.xclient.window = ventana;
    suceso.xclient.message_type = XInternAtom(pantalla, "WM_PROTOCOLS", False);
    suceso.xclient.format = 32;
    suceso.xclient.data.l[0] = long(XInternAtom(pantalla, que, False));
    suceso.xclient.data.l[1] = CurrentTime;
    suceso.xclient.data.l[2] = long(ventana);
    return XSendEvent(pantalla, ventana, False, NoEventMask, &suceso);
}

static int atiende(Display *pantalla, Window ventana) {
    XSetErrorHandler(
        [](Display *, XErrorEvent *) -> int { std::exit(0); }); // ya no está: no hay a qué esperar
    XSelectInput(pantalla, DefaultRootWindow(pantalla), SubstructureNotifyMask);
    XSelectInput(pantalla, ventana, StructureNotifyMask);
    // Wine contesta al leer de X, una vez al mirar si hay algo y otra al recogerlo: a la tercera ya se ha atendido.
    // Con la máquina ocupada contesta a varias en la misma lectura.
    for (int vuelta = 0; vuelta < 16; ++vuelta) {
        XEvent suceso{};
        manda(pantalla, ventana, "_NET_WM_PING");
        do {
            XNextEvent(pantalla, &suceso);
            if (suceso.type == DestroyNotify && suceso.xdestroywindow.window == ventana)
                return 0;
        } while (suceso.type != ClientMessage || Window(suceso.xclient.data.l[2]) != ventana);
    }
    return 0;
}

static int uso() {
    std::fprintf(stderr,
                 "uso: ventana espera | gobernada | activa CLASE | atiende VENTANA | cierra VENTANA\n");
    return 2;
}

int main(int argc, char **argv) {
    const std::string orden = argc > 1 ? argv[1] : "", que = argc > 2 ? argv[2] : "";
    Display *pantalla = XOpenDisplay(nullptr);
    if (!pantalla || argc != (orden == "espera" || orden == "gobernada" ? 2 : 3))
        return uso();
    const Window ventana = std::strtoul(que.c_str(), nullptr, 0);
    const int estado = orden == "espera"      ? espera(pantalla)
                       : orden == "gobernada" ? gobernada(pantalla)
                       : orden == "activa"    ? activa(pantalla, que)
                       : orden == "atiende"   ? atiende(pantalla, ventana)
                       : orden == "cierra"    ? !manda(pantalla, ventana, "WM_DELETE_WINDOW")
                                              : uso();
    XCloseDisplay(pantalla);
    return estado;
}
