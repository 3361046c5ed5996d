#include "captura.h"
#include "contexto.h"
#include "encima.h"
#include "error.h"
#include "glut_sin_ventana.h"
#include "guion.h"
#include "imagen.h"
#include "interior.h"
#include "texto.h"
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace sin_ventana {
namespace {

const Talla PANTALLA = {1920, 1080}; // la que no hay, para glutFullScreenToggle
const int VERSION_IMITADA = 30800;   // FreeGLUT 3.8.0: los títulos, en UTF-8

struct Temporizador {
    long long vence; // ms del reloj virtual
    void (*funcion)(int);
    int valor;
};

struct {
    // opciones
    std::vector<Orden> guion;
    std::string ppm;
    int mide = 0, lento = 1;
    bool tallaPedida = false, rasgos = false, diario = false, sinPlanos = false;
    std::FILE *titulos = nullptr; // donde se escriben
    // ventana
    std::string titulo;
    Talla talla = {300, 300}, tallaPrevia, pideTalla; // 0×0: ninguna
    unsigned modo = GLUT_RGBA;
    bool iniciado = false, ayuda = false, abierta = false, repinta = false, termina = false, completa = false;
    int muestras = 0;
    bool pideCompleta = false;
    Punto puntero;
    bool ratonDentro = false, pulsado[BOTON_MAXIMO + 1] = {};
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
    // tiempo
    long long reloj = 0;        // ms desde glutInit
    long long ultimoCuadro = 0; // cuándo se dibujó
    std::vector<Temporizador> temporizadores;
} g;

std::string errorGL; // el primer error o mensaje de depuración grave

void GLAPIENTRY depura(GLenum origen, GLenum tipo, GLuint, GLenum, GLsizei, const GLchar *texto,
                       const void *) {
    // los shaders que no compilan los trata el programa, que puede querer enseñarlos (errores_shader)
    if (origen == GL_DEBUG_SOURCE_SHADER_COMPILER)
        return;
    if ((tipo == GL_DEBUG_TYPE_ERROR || tipo == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR ||
         tipo == GL_DEBUG_TYPE_DEPRECATED_BEHAVIOR) &&
        errorGL.empty()) {
        errorGL = texto;
        if (errorGL.find("deprecated function") != std::string::npos) // es de Mesa, y no dice cuál
            errorGL += ": ¿una de OpenGL 1, como glBegin o glMatrixMode? En 3.1 no están";
    }
}

// El programa ha llamado a exit antes de que el bucle pudiera comprobar los últimos errores.
void compruebaErroresAlSalir() {
    if (errorGL.empty())
        return;
    std::fflush(stdout);
    std::fprintf(stderr, "%s: error de OpenGL: %s\n", nombrePrograma().c_str(), errorGL.c_str());
    std::_Exit(3);
}

// Qué ha hecho la imagen: con el mismo sello, dos imágenes del mismo programa deben ser idénticas.
std::string sello() {
    const auto dice = [](GLenum que) {
        return std::string(reinterpret_cast<const char *>(glGetString(que)));
    };
    std::string s = dice(GL_RENDERER) + " | " + dice(GL_VERSION);
    for (const char *variable : {"GALLIUM_OVERRIDE_CPU_CAPS", "GALLIVM_PERF"})
        if (const char *valor = std::getenv(variable))
            s += std::string(" | ") + variable + "=" + valor;
    return s;
}

void guarda(const std::string &fichero) {
    guardaPpm(fichero, leeVentana(), sello());
    guardaEncima(fichero, glutGet(GLUT_WINDOW_WIDTH), glutGet(GLUT_WINDOW_HEIGHT));
}

void dibujaLoPedido() {
    if (!g.repinta || g.termina)
        return;
    g.repinta = false;
    g.ultimoCuadro = g.reloj;
    dibujaCuadro();
    compruebaGL("al dibujar");
}

void cambiaTamano(Talla talla) {
    if (talla.ancho == g.talla.ancho && talla.alto == g.talla.alto)
        return;
    g.talla = talla;
    cambiaTallaContexto(talla.ancho, talla.alto);
    if (g.cambiaTamano)
        g.cambiaTamano(talla.ancho, talla.alto);
    else
        glViewport(0, 0, talla.ancho, talla.alto);
    g.repinta = true;
}

// La que pide el programa no es la de la ventana hasta que acaba la función en que la pide.
void cambiaTallaPedida() {
    if (std::exchange(g.pideCompleta, false)) {
        g.completa = !g.completa;
        if (g.completa)
            g.tallaPrevia = g.talla;
        cambiaTamano(g.completa ? PANTALLA : g.tallaPrevia);
    }
    if (const Talla talla = std::exchange(g.pideTalla, {}); talla.ancho) {
        g.completa = false;
        cambiaTamano(talla);
    }
}

// Con diario se dibuja al apuntar: como en una ventana, donde lo que llega junto se dibuja una vez.
void dibujaSiHaceFalta() {
    if (g.termina)
        return;
    cambiaTallaPedida();
    if (!g.diario)
        dibujaLoPedido();
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

bool botonPulsado(int cuantos = BOTON_MAXIMO + 1) {
    return std::any_of(g.pulsado, g.pulsado + cuantos, [](bool pulsado) { return pulsado; });
}

// Un ratón no salta: para pulsar en otro sitio, antes se mueve, y el programa lo ve.
void llevaRaton(Punto adonde) {
    if (g.ratonDentro && adonde.x == g.puntero.x && adonde.y == g.puntero.y)
        return;
    g.ratonDentro = true;
    g.puntero = adonde;
    if (hayMenuAbierto())
        return;
    // X solo dice cuáles de los cinco primeros están pulsados
    if (auto f = botonPulsado(5) ? g.arrastre : g.movimiento)
        f(adonde.x, adonde.y);
}

// Cada tecla se suelta en cuanto se pulsa.
template<class Tecla>
void pulsaTecla(void (*const &alPulsar)(Tecla, int, int), void (*const &alSoltar)(Tecla, int, int),
                int tecla) {
    if (alPulsar)
        alPulsar(Tecla(tecla), g.puntero.x, g.puntero.y);
    if (alSoltar && !g.termina)
        alSoltar(Tecla(tecla), g.puntero.x, g.puntero.y);
}

// De lo que abre o cierra un menú el programa no se entera; la opción la elige la orden menu.
void pulsaBoton(const Orden &o, Punto raton) {
    const bool abajo = o.sentido == GLUT_DOWN;
    llevaRaton(raton);
    if (g.pulsado[o.boton] == abajo)
        falla(o.lugar + ": ese botón ya está " + (abajo ? "abajo" : "arriba"), 2);
    g.pulsado[o.boton] = abajo;
    if (!loAtiendeUnMenu(o.boton, abajo) && g.raton)
        g.raton(o.boton, o.sentido, raton.x, raton.y);
}

void mueveRaton(const Orden &o, Punto raton) {
    if (botonPulsado() != (o.tipo == Orden::ARRASTRA))
        falla(o.lugar + (botonPulsado() ? ": hay un botón pulsado; es arrastra"
                                        : ": no hay ningún botón pulsado; es mueve"),
              2);
    llevaRaton(raton);
}

void giraRueda(int giro, Punto raton) {
    llevaRaton(raton);
    const int boton = giro > 0 ? 3 : 4; // lo que es, sin función propia
    for (const int sentido : {GLUT_DOWN, GLUT_UP}) {
        if (loAtiendeUnMenu(boton, sentido == GLUT_DOWN))
            continue;
        if (!g.rueda && g.raton)
            g.raton(boton, sentido, raton.x, raton.y);
        else if (g.rueda && sentido == GLUT_DOWN)
            g.rueda(0, giro, raton.x, raton.y);
    }
}

void ejecuta(const Orden &o) {
    const Punto raton = ratonEn(o, g.talla);
    switch (o.tipo) {
    case Orden::TECLA: pulsaTecla(g.teclado, g.tecladoArriba, o.tecla); break;
    case Orden::ESPECIAL: pulsaTecla(g.especial, g.especialArriba, o.tecla); break;
    case Orden::BOTON: pulsaBoton(o, raton); break;
    case Orden::ARRASTRA:
    case Orden::MUEVE: mueveRaton(o, raton); break;
    case Orden::RUEDA: giraRueda(o.giro, raton); break;
    case Orden::MENU: eligeEnMenu(o.texto, o.lugar); break;
    case Orden::TAMANO: cambiaTamano(o.talla); break;
    case Orden::ESPERA: avanzaReloj(o.ms); break;
    case Orden::CAPTURA: guarda(o.texto); break;
    case Orden::ESCALA: break; // no está en lo que da leeGuion
    }
    compruebaGL("tras " + o.lugar);
}

// Una orden del guion, las veces que diga, y lo que viene con cada una: dibujar si hace falta y la función de ocio.
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

// De qué sucesos se entera el programa.
void escribeRasgos() {
    const std::pair<const char *, bool> rasgos[] = {{"teclado", g.teclado != nullptr},
                                                    {"especial", g.especial != nullptr},
                                                    {"raton", g.raton != nullptr},
                                                    {"arrastre", g.arrastre != nullptr},
                                                    {"movimiento", g.movimiento != nullptr},
                                                    {"rueda", g.rueda != nullptr},
                                                    {"ocio", g.ocio != nullptr},
                                                    {"temporizador", !g.temporizadores.empty()}};
    for (const auto &[rasgo, loTiene] : rasgos)
        if (loTiene)
            std::puts(rasgo);
    for (const std::string &opcion : opcionesDeMenu())
        std::printf("opcion %s\n", opcion.c_str());
}

void ponTituloVentana(const char *titulo) {
    if (g.titulos && titulo != g.titulo) {
        std::fprintf(g.titulos, "título: %s\n", titulo);
        std::fflush(g.titulos); // el programa puede acabar de cualquier manera
    }
    g.titulo = titulo;
    diTitulo(titulo);
}

void apunta(const std::string &orden, bool haPasadoTiempo) {
    if (!g.diario || g.termina)
        return;
    g.repinta |= haPasadoTiempo; // el último cuadro es de hace unos milisegundos
    dibujaLoPedido();
    apuntaEnElDiario(orden, g.titulo, g.temporizadores.size());
}

[[noreturn]] void noEsta(const char *funcion, GLenum valor) {
    falla(std::string(funcion) + "(" + std::to_string(valor) + ") no está en glut_sin_ventana");
}

} // namespace

void dibujaCuadro() {
    empiezaCuadroEncima();
    dibujaParaElDiario(g.dibuja);
}

// El que se ve, una vez: también si ha dado un error, que es cuando hace más falta.
static void explicaElCuadro() {
    static bool explicado = false;
    if (!explicaCuadro || g.termina || !g.dibuja || explicado)
        return;
    explicado = true;
    g.reloj = g.ultimoCuadro;
    explicaCuadro(dibujaCuadro, g.talla.ancho, g.talla.alto);
}

void compruebaGL(const std::string &donde) {
    static const char *const NOMBRES[] = {"ENUM", "VALUE", "OPERATION", "", "", "", "FRAMEBUFFER_OPERATION"};
    for (GLenum e; (e = glGetError()) != GL_NO_ERROR;)
        if (const GLenum i = e - GL_INVALID_ENUM; errorGL.empty()) // donde no hay quien los cuente, su nombre
            errorGL = i < 7 && *NOMBRES[i] ? std::string("GL_INVALID_") + NOMBRES[i] : formatea("0x%04X", e);
    if (!errorGL.empty()) {
        const std::string mensaje = "error de OpenGL " + donde + ": " + errorGL;
        explicaElCuadro();
        errorGL.clear(); // ya está dicho
        falla(mensaje, 3);
    }
}

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
            g.talla = tallaDe(valor(), opcion);
            g.tallaPedida = true;
        } else if (opcion == "-guion") {
            g.guion = leeGuion(valor());
        } else if (opcion == "-ppm") {
            g.ppm = valor();
        } else if (opcion == "-mide") {
            g.mide = enteroDe(valor(), 1, 1000000, opcion);
        } else if (opcion == "-rasgos") {
            g.rasgos = true;
        } else if (opcion == "-titulos") {
            const std::string fichero = valor();
            g.titulos = fichero == "-" ? stdout : std::fopen(fichero.c_str(), "w");
            if (!g.titulos)
                falla("no puedo escribir en «" + fichero + "»");
        } else if (opcion == "-diario") {
            g.diario = true;
        } else if (opcion == "-lento") {
            g.lento = enteroDe(valor(), 1, 1000000, opcion);
        } else if (opcion == "-sin_planos") {
            g.sinPlanos = true;
        } else if (opcion == "-ayuda" || opcion == "-h" || opcion == "--help") {
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
        g.talla = {ancho, alto};
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
    g.muestras = creaContexto(g.talla.ancho, g.talla.alto, (g.modo & GLUT_DEPTH) != 0,
                              (g.modo & GLUT_STENCIL) != 0, (g.modo & GLUT_MULTISAMPLE) != 0);
    ponTituloVentana(titulo);
    g.abierta = true;
    g.repinta = true;
    if (g.sinPlanos)
        glEnable(GL_DEPTH_CLAMP);
    // el programa aún no ha llamado a glewInit
    if (const auto pideMensajes =
            reinterpret_cast<PFNGLDEBUGMESSAGECALLBACKPROC>(direccionGL("glDebugMessageCallback"))) {
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

void glutSetWindowTitle(const char *titulo) {
    ponTituloVentana(titulo);
}

void glutSetCursor(int) {
    // no hay cursor
}

void glutReshapeWindow(int ancho, int alto) {
    g.pideTalla = {std::max(ancho, 1), std::max(alto, 1)};
}

void glutFullScreenToggle(void) {
    g.pideCompleta = true;
}

#define QUEDA(glutFuncion, campo, ...)                                                                       \
    void glutFuncion(void (*f)(__VA_ARGS__)) {                                                               \
        g.campo = f;                                                                                         \
    }
QUEDA(glutDisplayFunc, dibuja, void)
QUEDA(glutReshapeFunc, cambiaTamano, int, int)
QUEDA(glutKeyboardFunc, teclado, unsigned char, int, int)
QUEDA(glutKeyboardUpFunc, tecladoArriba, unsigned char, int, int)
QUEDA(glutSpecialFunc, especial, int, int, int)
QUEDA(glutSpecialUpFunc, especialArriba, int, int, int)
QUEDA(glutMouseFunc, raton, int, int, int, int)
QUEDA(glutMotionFunc, arrastre, int, int)
QUEDA(glutPassiveMotionFunc, movimiento, int, int)
QUEDA(glutMouseWheelFunc, rueda, int, int, int, int)
QUEDA(glutIdleFunc, ocio, void)
QUEDA(glutCloseFunc, cierre, void)
#undef QUEDA

void glutTimerFunc(unsigned int ms, void (*f)(int), int valor) {
    const long long vence = g.reloj + std::max(ms, 1u); // lo negativo son 49 días, como en FreeGLUT
    g.temporizadores.push_back({(vence + g.lento - 1) / g.lento * g.lento, f, valor});
}

void glutPostRedisplay(void) {
    g.repinta = true;
}

void glutSwapBuffers(void) {
    glFlush();
}

int glutGet(GLenum que) {
    switch (que) {
    case GLUT_ELAPSED_TIME: return int(g.reloj);
    case GLUT_WINDOW_WIDTH: return g.talla.ancho;
    case GLUT_WINDOW_HEIGHT: return g.talla.alto;
    case GLUT_SCREEN_WIDTH: return PANTALLA.ancho;
    case GLUT_SCREEN_HEIGHT: return PANTALLA.alto;
    case GLUT_SCREEN_WIDTH_MM:
    case GLUT_SCREEN_HEIGHT_MM: return 0; // así se sabe que no la hay
    case GLUT_WINDOW_DOUBLEBUFFER: return (g.modo & GLUT_DOUBLE) != 0;
    case GLUT_WINDOW_DEPTH_SIZE: return g.modo & GLUT_DEPTH ? 24 : 0;
    case GLUT_WINDOW_STENCIL_SIZE: return g.modo & GLUT_STENCIL ? 8 : 0;
    case GLUT_WINDOW_NUM_SAMPLES: return g.muestras;
    case GLUT_INIT_STATE: return g.iniciado;
    case GLUT_VERSION: return VERSION_IMITADA;
    default: noEsta("glutGet", que);
    }
}

void glutMainLoop(void) {
    if (!g.abierta || !g.dibuja)
        falla("glutMainLoop: falta la ventana o glutDisplayFunc");
    compruebaGL("antes de glutMainLoop");
    if (g.cambiaTamano)
        g.cambiaTamano(g.talla.ancho, g.talla.alto);
    cambiaTallaPedida();
    compruebaGL("al dar el tamaño");
    if (g.diario)
        empiezaDiario();
    const double primera = milisegundosDe(dibujaLoPedido);
    apunta("", false);
    for (const Orden &orden : g.guion) {
        atiende(orden);
        apunta(orden.lugar, orden.tipo == Orden::ESPERA);
    }
    cedeAlNavegador();
    explicaElCuadro();
    if (g.mide)
        mideCuadros(g.mide, primera);
    if (g.rasgos)
        escribeRasgos();
    else
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
    static std::string lineas;
    lineas.clear();
    for (const std::string &opcion : opcionesDeMenu())
        lineas += opcion + "\n";
    return lineas.c_str();
}

void glutRedibuja(void) {
    if (g.termina)
        return;
    const long long ahora = std::exchange(g.reloj, g.ultimoCuadro); // el que se ve
    dibujaCuadro();
    g.reloj = ahora;
}

} // extern "C"
