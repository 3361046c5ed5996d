#include "../error.h"
#include "../imagen.h"
#include "contexto.h"
#include "glut_sin_ventana.h"
#include "guion.h"
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace sin_ventana {
namespace {

const int ANCHO_PANTALLA = 1920, ALTO_PANTALLA = 1080; // la pantalla que no hay, para glutFullScreenToggle
const int VERSION_IMITADA = 30800;                     // FreeGLUT 3.8.0: los títulos, en UTF-8

struct Temporizador {
    long long vence; // ms del reloj virtual
    void (*funcion)(int);
    int valor;
};

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
    // opciones
    std::vector<Orden> guion;
    std::string ppm;
    int mide = 0;
    bool tallaPedida = false;
    // ventana
    int ancho = 300, alto = 300, anchoPrevio = 0, altoPrevio = 0;
    unsigned modo = GLUT_RGBA;
    bool iniciado = false, ayuda = false, abierta = false, repinta = false, termina = false, completa = false;
    int xRaton = 0, yRaton = 0;
    bool ratonDentro = false, pulsado[3] = {};
    // funciones del programa
    void (*dibuja)() = nullptr;
    void (*cambiaTamano)(int, int) = nullptr;
    void (*teclado)(unsigned char, int, int) = nullptr;
    void (*tecladoArriba)(unsigned char, int, int) = nullptr;
    void (*especial)(int, int, int) = nullptr;
    void (*especialArriba)(int, int, int) = nullptr;
    void (*raton)(int, int, int, int) = nullptr;
    void (*arrastre)(int, int) = nullptr;
    void (*movimiento)(int, int) = nullptr;
    void (*rueda)(int, int, int, int) = nullptr;
    void (*ocio)() = nullptr;
    void (*cierre)() = nullptr;
    // tiempo y menús
    long long reloj = 0; // ms desde glutInit
    std::vector<Temporizador> temporizadores;
    std::map<int, Menu> menus;
    int menuActual = 0, ultimoMenu = 0, menuDeBoton[3] = {};
    bool menuAbierto = false;
} g;

std::string errorGL; // el primer error o mensaje de depuración grave

template<typename F>
F funcionGL(const char *nombre) {
    return reinterpret_cast<F>(direccionGL(nombre));
}

void APIENTRY depura(GLenum origen, GLenum tipo, GLuint, GLenum, GLsizei, const GLchar *texto, const void *) {
    // los shaders que no compilan los trata el programa, que puede querer enseñarlos (errores_shader)
    if (origen == GL_DEBUG_SOURCE_SHADER_COMPILER)
        return;
    if ((tipo == GL_DEBUG_TYPE_ERROR || tipo == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR ||
         tipo == GL_DEBUG_TYPE_DEPRECATED_BEHAVIOR) &&
        errorGL.empty())
        errorGL = texto;
}

/// Termina con estado 3 si ha habido un error de OpenGL desde la última vez. `donde`: qué se acaba de hacer.
void compruebaGL(const std::string &donde) {
    for (GLenum e; (e = glGetError()) != GL_NO_ERROR;)
        if (errorGL.empty()) {
            char codigo[16];
            std::snprintf(codigo, sizeof codigo, "0x%04X", e);
            errorGL = codigo;
        }
    if (!errorGL.empty()) {
        const std::string mensaje = "error de OpenGL " + donde + ": " + errorGL;
        errorGL.clear(); // ya está dicho
        falla(mensaje, 3);
    }
}

/// El programa ha llamado a exit antes de que el bucle pudiera comprobar los últimos errores.
void compruebaErroresAlSalir() {
    if (errorGL.empty())
        return;
    std::fflush(stdout);
    std::fprintf(stderr, "%s: error de OpenGL: %s\n", nombrePrograma().c_str(), errorGL.c_str());
    std::_Exit(3);
}

Imagen leeFramebuffer() {
    Imagen imagen{g.ancho, g.alto, {}};
    imagen.rgb.resize(3 * static_cast<std::size_t>(g.ancho) * static_cast<std::size_t>(g.alto));
    GLint framebuffer = 0, bufer = 0;
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &framebuffer);
    glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &bufer);
    const GLenum parametros[] = {GL_PACK_ALIGNMENT, GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS,
                                 GL_PACK_SKIP_PIXELS};
    const GLint normales[] = {1, 0, 0, 0};
    GLint previos[4];
    for (int i = 0; i < 4; ++i) {
        glGetIntegerv(parametros[i], &previos[i]);
        glPixelStorei(parametros[i], normales[i]);
    }
    const auto enlazaFramebuffer = funcionGL<PFNGLBINDFRAMEBUFFERPROC>("glBindFramebuffer");
    const auto enlazaBufer = funcionGL<PFNGLBINDBUFFERPROC>("glBindBuffer");
    enlazaFramebuffer(GL_READ_FRAMEBUFFER, 0);
    enlazaBufer(GL_PIXEL_PACK_BUFFER, 0);
    glReadPixels(0, 0, g.ancho, g.alto, GL_RGB, GL_UNSIGNED_BYTE, imagen.rgb.data());
    enlazaBufer(GL_PIXEL_PACK_BUFFER, static_cast<GLuint>(bufer));
    enlazaFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(framebuffer));
    for (int i = 0; i < 4; ++i)
        glPixelStorei(parametros[i], previos[i]);
    return imagen;
}

std::string renderizador() {
    return reinterpret_cast<const char *>(glGetString(GL_RENDERER));
}

/// Qué ha hecho la imagen: con el mismo sello, dos imágenes del mismo programa deben ser idénticas.
std::string sello() {
    std::string s = renderizador() + " | " + reinterpret_cast<const char *>(glGetString(GL_VERSION));
    for (const char *variable : {"GALLIUM_OVERRIDE_CPU_CAPS", "GALLIVM_PERF"})
        if (const char *valor = std::getenv(variable))
            s += std::string(" | ") + variable + "=" + valor;
    return s;
}

void guarda(const std::string &fichero) {
    guardaPpm(fichero, leeFramebuffer(), sello());
}

void dibujaSiHaceFalta() {
    if (!g.repinta || g.termina)
        return;
    g.repinta = false;
    if (g.dibuja)
        g.dibuja();
    compruebaGL("al dibujar");
}

void cambiaTamano(int ancho, int alto) {
    if (ancho == g.ancho && alto == g.alto)
        return;
    g.ancho = ancho;
    g.alto = alto;
    cambiaTallaContexto(ancho, alto);
    if (g.cambiaTamano)
        g.cambiaTamano(ancho, alto);
    else
        glViewport(0, 0, ancho, alto);
    g.repinta = true;
}

void avanzaReloj(int ms) {
    const long long fin = g.reloj + ms;
    while (!g.termina) {
        // el que antes vence; entre iguales, el que antes se pidió
        const auto t =
            std::min_element(g.temporizadores.begin(), g.temporizadores.end(),
                             [](const Temporizador &a, const Temporizador &b) { return a.vence < b.vence; });
        if (t == g.temporizadores.end() || t->vence > fin)
            break;
        const Temporizador vencido = *t;
        g.temporizadores.erase(t);
        g.reloj = vencido.vence;
        vencido.funcion(vencido.valor);
        compruebaGL("en un temporizador");
        dibujaSiHaceFalta();
    }
    g.reloj = fin;
}

/// Busca «Submenú/Opción» en los menús asignados a los botones y llama a la función del que la contiene.
void eligeEnMenu(const Orden &orden) {
    for (int raiz : g.menuDeBoton) {
        int menu = raiz;
        std::size_t inicio = 0;
        while (menu) {
            const std::size_t barra = orden.texto.find('/', inicio);
            const std::string parte =
                orden.texto.substr(inicio, barra == std::string::npos ? barra : barra - inicio);
            const auto &entradas = g.menus.at(menu).entradas;
            const auto e = std::find_if(entradas.begin(), entradas.end(), [&](const Entrada &entrada) {
                return entrada.texto == parte && (entrada.submenu != 0) == (barra != std::string::npos);
            });
            if (e == entradas.end())
                break;
            if (!e->submenu) {
                const int anterior = std::exchange(g.menuActual, menu), valor = e->valor;
                g.menuAbierto = false;
                g.menus.at(menu).funcion(valor); // que puede cambiar el menú
                g.menuActual = g.menus.count(anterior) ? anterior : 0;
                return;
            }
            menu = e->submenu;
            inicio = barra + 1;
        }
    }
    std::string opciones;
    for (int raiz : g.menuDeBoton)
        if (raiz)
            for (const Entrada &e : g.menus.at(raiz).entradas)
                opciones += " «" + e.texto + (e.submenu ? "/…»" : "»");
    falla(orden.lugar + ": no hay esa opción; " +
              (opciones.empty() ? "el programa no tiene menú" : "el menú tiene" + opciones),
          2);
}

/// Añade una línea «Submenú/Opción» por cada opción de un menú.
void enumeraMenu(int menu, const std::string &ruta, std::string &lineas) {
    for (const Entrada &e : g.menus.at(menu).entradas)
        if (e.submenu)
            enumeraMenu(e.submenu, ruta + e.texto + "/", lineas);
        else
            lineas += ruta + e.texto + "\n";
}

bool botonPulsado() {
    return std::any_of(std::begin(g.pulsado), std::end(g.pulsado), [](bool pulsado) { return pulsado; });
}

/// Un ratón no salta: para pulsar en otro sitio, antes se mueve, y el programa lo ve.
void llevaRaton(int x, int y) {
    if (g.ratonDentro && x == g.xRaton && y == g.yRaton)
        return;
    g.ratonDentro = true;
    g.xRaton = x;
    g.yRaton = y;
    if (g.menuAbierto)
        return;
    if (auto f = botonPulsado() ? g.arrastre : g.movimiento)
        f(x, y);
}

void ejecuta(const Orden &o) {
    const auto [x, y] = ratonEn(o, {g.ancho, g.alto});
    switch (o.tipo) {
    case Orden::TECLA:
        if (g.teclado)
            g.teclado(static_cast<unsigned char>(o.tecla), g.xRaton, g.yRaton);
        if (g.tecladoArriba && !g.termina)
            g.tecladoArriba(static_cast<unsigned char>(o.tecla), g.xRaton, g.yRaton);
        break;
    case Orden::ESPECIAL:
        if (g.especial)
            g.especial(o.tecla, g.xRaton, g.yRaton);
        if (g.especialArriba && !g.termina)
            g.especialArriba(o.tecla, g.xRaton, g.yRaton);
        break;
    case Orden::BOTON:
        llevaRaton(x, y);
        if (g.pulsado[o.boton] == (o.sentido == GLUT_DOWN))
            falla(o.lugar + ": ese botón ya está " + (o.sentido == GLUT_DOWN ? "abajo" : "arriba"), 2);
        g.pulsado[o.boton] = o.sentido == GLUT_DOWN;
        // De lo que abre o cierra un menú el programa no se entera; la opción la elige la orden menu.
        if (g.menuAbierto || (g.menuDeBoton[o.boton] && o.sentido == GLUT_DOWN)) {
            g.menuAbierto = o.sentido == GLUT_UP || g.menuDeBoton[o.boton];
            break;
        }
        if (g.raton)
            g.raton(o.boton, o.sentido, x, y);
        break;
    case Orden::ARRASTRA:
    case Orden::MUEVE:
        if (botonPulsado() != (o.tipo == Orden::ARRASTRA))
            falla(o.lugar + (botonPulsado() ? ": hay un botón pulsado; es arrastra"
                                            : ": no hay ningún botón pulsado; es mueve"),
                  2);
        llevaRaton(x, y);
        break;
    case Orden::RUEDA:
        llevaRaton(x, y);
        if (g.rueda) {
            g.rueda(0, o.giro, x, y);
        } else if (g.raton) { // sin función propia, la rueda son los botones 3 y 4
            g.raton(o.giro > 0 ? 3 : 4, GLUT_DOWN, x, y);
            g.raton(o.giro > 0 ? 3 : 4, GLUT_UP, x, y);
        }
        break;
    case Orden::MENU: eligeEnMenu(o); break;
    case Orden::TAMANO: cambiaTamano(o.talla.ancho, o.talla.alto); break;
    case Orden::ESPERA: avanzaReloj(o.ms); break;
    case Orden::CAPTURA: guarda(o.texto); break;
    case Orden::ESCALA: break; // no está en lo que da leeGuion
    }
    compruebaGL("tras " + o.lugar);
}

/// Una orden del guion, las veces que diga, y lo que viene con cada una: dibujar si hace falta y la función de ocio.
void atiende(const Orden &orden) {
    for (int i = 0; i < orden.veces; ++i) {
        if (g.termina)
            falla(orden.lugar + ": el programa ya ha terminado", 2);
        ejecuta(orden);
        dibujaSiHaceFalta();
        if (g.ocio && !g.termina) {
            g.ocio();
            compruebaGL("en la función de ocio");
            dibujaSiHaceFalta();
        }
    }
}

double milisegundosDe(void (*f)()) {
    const auto antes = std::chrono::steady_clock::now();
    f();
    glFinish();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - antes).count();
}

GLint sumaParametros(GLenum objetivo, GLint nivel, std::initializer_list<GLenum> cuales) {
    GLint suma = 0;
    for (const GLenum cual : cuales) {
        GLint n = 0;
        glGetTexLevelParameteriv(objetivo, nivel, cual, &n);
        suma += n;
    }
    return suma;
}

/// Lo que ocupan los buffer objects y las texturas que hay, con sus mipmaps. Se pregunta por todos los nombres que Mesa ha podido
/// dar, y a cada textura con qué objetivo se creó, que es el único con el que enlazarla no es un error.
void cuentaBytes(long long &buferes, long long &texturas) {
    const auto esBufer = funcionGL<PFNGLISBUFFERPROC>("glIsBuffer");
    const auto enlazaBufer = funcionGL<PFNGLBINDBUFFERPROC>("glBindBuffer");
    const auto pregunta = funcionGL<PFNGLGETBUFFERPARAMETERIVPROC>("glGetBufferParameteriv");
    buferes = texturas = 0;
    for (GLuint nombre = 1; nombre < 4096; ++nombre) {
        if (esBufer(nombre)) {
            GLint bytes = 0;
            enlazaBufer(GL_COPY_READ_BUFFER, nombre);
            pregunta(GL_COPY_READ_BUFFER, GL_BUFFER_SIZE, &bytes);
            buferes += bytes;
        }
        if (!glIsTexture(nombre))
            continue;
        for (const GLenum objetivo :
             {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_RECTANGLE}) {
            glBindTexture(objetivo, nombre);
            if (glGetError() != GL_NO_ERROR)
                continue;
            const bool cubo = objetivo == GL_TEXTURE_CUBE_MAP;
            const GLenum cara = cubo ? GL_TEXTURE_CUBE_MAP_POSITIVE_X : objetivo;
            for (GLint nivel = 0;; ++nivel) {
                const GLint ancho = sumaParametros(cara, nivel, {GL_TEXTURE_WIDTH}),
                            alto = sumaParametros(cara, nivel, {GL_TEXTURE_HEIGHT}),
                            fondo = sumaParametros(cara, nivel, {GL_TEXTURE_DEPTH});
                if (ancho == 0)
                    break;
                texturas += (cubo ? 6LL : 1LL) * ancho * alto * fondo *
                            sumaParametros(cara, nivel,
                                           {GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_BLUE_SIZE,
                                            GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_DEPTH_SIZE}) /
                            8;
            }
            break;
        }
    }
    while (glGetError() != GL_NO_ERROR) {
    }
    errorGL.clear(); // los de probar objetivos y niveles
}

/// La línea TSV de la opción -mide. `primera`: lo que costó la primera imagen, en ms.
void mideCuadros(double primera) {
    const auto generaConsultas = funcionGL<PFNGLGENQUERIESPROC>("glGenQueries");
    const auto empieza = funcionGL<PFNGLBEGINQUERYPROC>("glBeginQuery");
    const auto acaba = funcionGL<PFNGLENDQUERYPROC>("glEndQuery");
    const auto resultado = funcionGL<PFNGLGETQUERYOBJECTUIVPROC>("glGetQueryObjectuiv");
    GLuint consulta = 0, primitivas = 0;
    generaConsultas(1, &consulta);
    empieza(GL_PRIMITIVES_GENERATED, consulta);
    g.dibuja();
    acaba(GL_PRIMITIVES_GENERATED);
    resultado(consulta, GL_QUERY_RESULT, &primitivas);

    std::vector<double> ms;
    for (int i = 0; i < g.mide; ++i)
        ms.push_back(milisegundosDe(g.dibuja));
    std::sort(ms.begin(), ms.end());
    compruebaGL("al medir");
    long long buferes, texturas;
    cuentaBytes(buferes, texturas);
    std::printf("%s\t%dx%d\t%.3f\t%.3f\t%.3f\t%.3f\t%u\t%s\t%lld\t%lld\n", nombrePrograma().c_str(), g.ancho,
                g.alto, primera, ms[ms.size() / 2], ms.front(), ms.back(), primitivas, renderizador().c_str(),
                buferes, texturas);
}

[[noreturn]] void noEsta(const char *funcion, GLenum valor) {
    falla(std::string(funcion) + "(" + std::to_string(valor) + ") no está en glut_sin_ventana");
}

Menu &menuActual(const char *funcion) {
    if (!g.menuActual)
        falla(std::string(funcion) + ": no hay menú; falta glutCreateMenu");
    return g.menus.at(g.menuActual);
}

} // namespace
} // namespace sin_ventana

using namespace sin_ventana;

extern "C" {

void glutInit(int *argc, char **argv) {
    if (g.iniciado)
        falla("glutInit se llama una sola vez");
    g.iniciado = true;
    std::atexit(compruebaSalida);
    g.ppm = nombrePrograma() + ".ppm";
    int quedan = 1;
    for (int i = 1; i < *argc; ++i) {
        const std::string opcion = argv[i];
        auto valor = [&] {
            if (i + 1 >= *argc)
                falla(opcion + ": falta su valor", 2);
            return std::string(argv[++i]);
        };
        if (opcion == "-geometry") {
            const Talla talla = tallaDe(valor(), opcion);
            g.ancho = talla.ancho;
            g.alto = talla.alto;
            g.tallaPedida = true;
        } else if (opcion == "-guion") {
            g.guion = leeGuion(valor());
        } else if (opcion == "-ppm") {
            g.ppm = valor();
        } else if (opcion == "-mide") {
            g.mide = enteroDe(valor(), 1, 1000000, opcion);
        } else if (opcion == "-ayuda") {
            std::printf("%s", AYUDA);
            g.ayuda = true;
            argv[quedan++] = argv[i]; // el programa puede añadir su uso
        } else {
            argv[quedan++] = argv[i];
        }
    }
    *argc = quedan;
    argv[quedan] = nullptr;
}

void glutInitWindowSize(int ancho, int alto) {
    if (!g.tallaPedida && ancho > 0 && alto > 0)
        g.ancho = ancho, g.alto = alto;
}

void glutInitWindowPosition(int, int) {
    // no hay pantalla en la que colocarla
}

void glutInitDisplayMode(unsigned int modo) {
    g.modo = modo;
}

// El contexto es siempre 3.1: lo que pidan se comprueba, no se cambia.
void glutInitContextVersion(int mayor, int menor) {
    if (10 * mayor + menor > 31)
        falla("glut_sin_ventana da OpenGL 3.1 y el programa pide " + std::to_string(mayor) + "." +
              std::to_string(menor));
}

void glutInitContextFlags(int) {
    // depurar y compatible hacia delante: aquí siempre es así
}

void glutInitContextProfile(int perfil) {
    if (perfil != GLUT_CORE_PROFILE)
        falla("glut_sin_ventana solo da el perfil core");
}

void glutSetOption(GLenum opcion, int) {
    if (opcion != GLUT_ACTION_ON_WINDOW_CLOSE && opcion != GLUT_MULTISAMPLE)
        noEsta("glutSetOption", opcion);
}

int glutCreateWindow(const char *titulo) {
    if (!g.iniciado)
        falla("glutCreateWindow: antes hay que llamar a glutInit");
    if (g.ayuda)
        std::exit(0);
    if (g.abierta)
        falla("glut_sin_ventana solo tiene una ventana");
    creaContexto(g.ancho, g.alto, (g.modo & GLUT_DEPTH) != 0, (g.modo & GLUT_STENCIL) != 0,
                 (g.modo & GLUT_MULTISAMPLE) != 0);
    diTitulo(titulo);
    g.abierta = true;
    g.repinta = true;
    if (const auto pideMensajes = funcionGL<PFNGLDEBUGMESSAGECALLBACKPROC>("glDebugMessageCallback")) {
        glEnable(GL_DEBUG_OUTPUT);
        glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
        pideMensajes(depura, nullptr);
        if (glGetError() != GL_NO_ERROR)
            avisa("este OpenGL no tiene GL_KHR_debug: solo se comprueba glGetError");
    }
    std::atexit(compruebaErroresAlSalir);
    return 1;
}

void glutDestroyWindow(int) {
    g.termina = true;
}

int glutGetWindow(void) {
    return g.abierta ? 1 : 0;
}

void glutSetWindow(int ventana) {
    if (ventana != 1)
        falla("glutSetWindow(" + std::to_string(ventana) + "): no hay esa ventana");
}

void glutSetWindowTitle(const char *titulo) {
    diTitulo(titulo);
}

void glutSetCursor(int) {
    // no hay cursor
}

void glutReshapeWindow(int ancho, int alto) {
    cambiaTamano(std::max(ancho, 1), std::max(alto, 1));
}

void glutFullScreenToggle(void) {
    g.completa = !g.completa;
    if (g.completa) {
        g.anchoPrevio = g.ancho, g.altoPrevio = g.alto;
        cambiaTamano(ANCHO_PANTALLA, ALTO_PANTALLA);
    } else {
        cambiaTamano(g.anchoPrevio, g.altoPrevio);
    }
}

void glutDisplayFunc(void (*f)(void)) {
    g.dibuja = f;
}
void glutReshapeFunc(void (*f)(int, int)) {
    g.cambiaTamano = f;
}
void glutKeyboardFunc(void (*f)(unsigned char, int, int)) {
    g.teclado = f;
}
void glutKeyboardUpFunc(void (*f)(unsigned char, int, int)) {
    g.tecladoArriba = f;
}
void glutSpecialFunc(void (*f)(int, int, int)) {
    g.especial = f;
}
void glutSpecialUpFunc(void (*f)(int, int, int)) {
    g.especialArriba = f;
}
void glutMouseFunc(void (*f)(int, int, int, int)) {
    g.raton = f;
}
void glutMotionFunc(void (*f)(int, int)) {
    g.arrastre = f;
}
void glutPassiveMotionFunc(void (*f)(int, int)) {
    g.movimiento = f;
}
void glutMouseWheelFunc(void (*f)(int, int, int, int)) {
    g.rueda = f;
}
void glutIdleFunc(void (*f)(void)) {
    g.ocio = f;
}
void glutCloseFunc(void (*f)(void)) {
    g.cierre = f;
}

void glutTimerFunc(unsigned int ms, void (*f)(int), int valor) {
    g.temporizadores.push_back({g.reloj + std::max(static_cast<int>(ms), 1), f, valor});
}

void glutPostRedisplay(void) {
    g.repinta = true;
}

void glutSwapBuffers(void) {
    glFlush();
}

int glutGet(GLenum que) {
    switch (que) {
    case GLUT_ELAPSED_TIME: return static_cast<int>(g.reloj);
    case GLUT_WINDOW_WIDTH: return g.ancho;
    case GLUT_WINDOW_HEIGHT: return g.alto;
    case GLUT_SCREEN_WIDTH: return ANCHO_PANTALLA;
    case GLUT_SCREEN_HEIGHT: return ALTO_PANTALLA;
    case GLUT_SCREEN_WIDTH_MM:
    case GLUT_SCREEN_HEIGHT_MM: return 0; // así se sabe que no la hay
    case GLUT_WINDOW_DOUBLEBUFFER: return (g.modo & GLUT_DOUBLE) != 0;
    case GLUT_WINDOW_DEPTH_SIZE: return g.modo & GLUT_DEPTH ? 24 : 0;
    case GLUT_WINDOW_STENCIL_SIZE: return g.modo & GLUT_STENCIL ? 8 : 0;
    case GLUT_WINDOW_NUM_SAMPLES: return 0; // aunque se pida GLUT_MULTISAMPLE
    case GLUT_INIT_STATE: return g.iniciado;
    case GLUT_MENU_NUM_ITEMS:
        return g.menuActual ? static_cast<int>(g.menus.at(g.menuActual).entradas.size()) : 0;
    case GLUT_VERSION: return VERSION_IMITADA;
    default: noEsta("glutGet", que);
    }
}

void glutMainLoop(void) {
    if (!g.abierta || !g.dibuja)
        falla("glutMainLoop: falta la ventana o glutDisplayFunc");
    compruebaGL("antes de glutMainLoop");
    if (g.cambiaTamano)
        g.cambiaTamano(g.ancho, g.alto);
    compruebaGL("al dar el tamaño");
    const double primera = milisegundosDe(dibujaSiHaceFalta);
    for (const Orden &orden : g.guion)
        atiende(orden);
    cedeAlNavegador();
    if (g.mide)
        mideCuadros(primera);
    guarda(g.ppm);
    compruebaGL("al leer la imagen");
    if (g.cierre)
        g.cierre();
    destruyeContexto();
    g.abierta = false;
}

void glutLeaveMainLoop(void) {
    g.termina = true;
}

int glutOrden(const char *guion) {
    for (const Orden &orden : leeGuion(guion))
        atiende(orden);
    return g.termina;
}

const char *glutOpciones(void) {
    static std::string opciones;
    opciones.clear();
    for (int raiz : g.menuDeBoton)
        if (raiz)
            enumeraMenu(raiz, "", opciones);
    return opciones.c_str();
}

int glutCreateMenu(void (*f)(int)) {
    g.menuActual = ++g.ultimoMenu;
    g.menus[g.menuActual] = {f, {}};
    return g.menuActual;
}

void glutDestroyMenu(int menu) {
    g.menus.erase(menu);
    for (auto &par : g.menus)
        for (Entrada &e : par.second.entradas)
            if (e.submenu == menu)
                e = {e.texto, -1, 0};
    for (int &m : g.menuDeBoton)
        m = m == menu ? 0 : m;
    g.menuActual = g.menuActual == menu ? 0 : g.menuActual;
}

int glutGetMenu(void) {
    return g.menuActual;
}

void glutSetMenu(int menu) {
    if (!g.menus.count(menu))
        falla("glutSetMenu(" + std::to_string(menu) + "): no hay ese menú");
    g.menuActual = menu;
}

void glutAddMenuEntry(const char *texto, int valor) {
    menuActual("glutAddMenuEntry").entradas.push_back({texto, valor, 0});
}

void glutAddSubMenu(const char *texto, int submenu) {
    if (!g.menus.count(submenu))
        falla("glutAddSubMenu(" + std::to_string(submenu) + "): no hay ese menú");
    menuActual("glutAddSubMenu").entradas.push_back({texto, 0, submenu});
}

void glutChangeToMenuEntry(int entrada, const char *texto, int valor) {
    auto &entradas = menuActual("glutChangeToMenuEntry").entradas;
    if (entrada < 1 || entrada > static_cast<int>(entradas.size()))
        falla("glutChangeToMenuEntry(" + std::to_string(entrada) + "): el menú tiene " +
              std::to_string(entradas.size()) + " opciones");
    entradas[static_cast<std::size_t>(entrada - 1)] = {texto, valor, 0};
}

void glutAttachMenu(int boton) {
    menuActual("glutAttachMenu");
    if (boton < 0 || boton > 2)
        falla("glutAttachMenu(" + std::to_string(boton) + "): no hay ese botón");
    g.menuDeBoton[boton] = g.menuActual;
}

void glutDetachMenu(int boton) {
    if (boton >= 0 && boton <= 2)
        g.menuDeBoton[boton] = 0;
}

} // extern "C"
