// Los menús: se hacen como en FreeGLUT, y en ellos elige el guion.
#include "error.h"
#include "glut_sin_ventana.h"
#include "guion.h"
#include "interior.h"
#include <map>
#include <utility>

namespace sin_ventana {
namespace {

struct Entrada {
    std::string texto;
    int valor;   // lo que recibe la función del menú
    int submenu; // 0 si es una opción
};

struct Menu {
    void (*funcion)(int);
    std::vector<Entrada> entradas;
};

struct {
    std::map<int, Menu> todos;
    int actual = 0, ultimo = 0, deBoton[BOTON_MAXIMO + 1] = {};
    bool abierto = false;
} menus;

Menu &actual(const char *funcion) {
    if (!menus.actual)
        falla(std::string(funcion) + ": no hay menú; falta glutCreateMenu");
    return menus.todos.at(menus.actual);
}

void exigeMenu(const char *funcion, int menu) {
    if (!menus.todos.count(menu))
        falla(std::string(funcion) + "(" + std::to_string(menu) + "): no hay ese menú");
}

// Su función se llama con él como menú actual, y puede cambiarlo.
void elige(int menu, int valor) {
    menus.abierto = false;
    const int anterior = std::exchange(menus.actual, menu);
    menus.todos.at(menu).funcion(valor);
    menus.actual = anterior;
}

// Si en ese menú hay esa opción, la elige.
bool eligeDesde(int menu, const std::string &ruta) {
    const std::size_t barra = ruta.find('/');
    for (const Entrada &e : menus.todos.at(menu).entradas) {
        if (e.texto != ruta.substr(0, barra) || (e.submenu != 0) != (barra != std::string::npos))
            continue;
        if (e.submenu)
            return eligeDesde(e.submenu, ruta.substr(barra + 1));
        elige(menu, e.valor);
        return true;
    }
    return false;
}

void enumera(int menu, const std::string &ruta, std::vector<std::string> &opciones) {
    for (const Entrada &e : menus.todos.at(menu).entradas)
        if (e.submenu)
            enumera(e.submenu, ruta + e.texto + "/", opciones);
        else
            opciones.push_back(ruta + e.texto);
}

} // namespace

void eligeEnMenu(const std::string &ruta, const std::string &lugar) {
    std::string opciones;
    for (const int raiz : menus.deBoton) {
        if (!raiz)
            continue;
        if (eligeDesde(raiz, ruta))
            return;
        for (const Entrada &e : menus.todos.at(raiz).entradas)
            opciones += " «" + e.texto + (e.submenu ? "/…»" : "»");
    }
    falla(lugar + ": no hay esa opción; " +
              (opciones.empty() ? "el programa no tiene menú" : "el menú tiene" + opciones),
          2);
}

std::vector<std::string> opcionesDeMenu() {
    std::vector<std::string> opciones;
    for (const int raiz : menus.deBoton)
        if (raiz)
            enumera(raiz, "", opciones);
    return opciones;
}

bool hayMenuAbierto() {
    return menus.abierto;
}

bool loAtiendeUnMenu(int boton, bool pulsado) {
    const bool suyo = menus.deBoton[boton] != 0;
    if (!menus.abierto && !(suyo && pulsado))
        return false;
    menus.abierto = suyo || !pulsado;
    return true;
}

} // namespace sin_ventana

using namespace sin_ventana;

extern "C" {

int glutCreateMenu(void (*f)(int)) {
    menus.actual = ++menus.ultimo;
    menus.todos[menus.actual] = {f, {}};
    return menus.actual;
}

void glutSetMenu(int menu) {
    exigeMenu("glutSetMenu", menu);
    menus.actual = menu;
}

void glutAddMenuEntry(const char *texto, int valor) {
    actual("glutAddMenuEntry").entradas.push_back({texto, valor, 0});
}

void glutAddSubMenu(const char *texto, int submenu) {
    exigeMenu("glutAddSubMenu", submenu);
    actual("glutAddSubMenu").entradas.push_back({texto, 0, submenu});
}

void glutAttachMenu(int boton) {
    actual("glutAttachMenu");
    if (boton < 0 || boton > 2)
        falla("glutAttachMenu(" + std::to_string(boton) + "): no hay ese botón");
    menus.deBoton[boton] = menus.actual;
}

} // extern "C"
