// Contexto sobre EGL sin ventana: Mesa 25.1 y posteriores, que ya no traen OSMesa (EGL_MESA_platform_surfaceless), y
// otros controladores en una máquina sin pantalla (EGL_EXT_platform_device). El framebuffer es un pbuffer.
#include "contexto.h"
#include "error.h"
#include "texto.h"
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <cstdio>

namespace sin_ventana {

namespace {

EGLDisplay pantalla = EGL_NO_DISPLAY;
EGLConfig configuracion = nullptr;
EGLContext contexto = EGL_NO_CONTEXT;
EGLSurface superficie = EGL_NO_SURFACE;

[[noreturn]] void fallaEgl(const std::string &que) {
    falla("EGL " + que + formatea(" (error 0x%04X)", unsigned(eglGetError())));
}

bool abre(EGLDisplay cual) {
    if (cual != EGL_NO_DISPLAY && eglInitialize(cual, nullptr, nullptr))
        pantalla = cual;
    return pantalla != EGL_NO_DISPLAY;
}

void abrePantalla() {
    if (abre(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr)))
        return;
    const auto dispositivos =
        reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    EGLDeviceEXT candidatos[16];
    EGLint cuantos = 0;
    if (dispositivos)
        dispositivos(16, candidatos, &cuantos);
    for (EGLint i = 0; i < cuantos; ++i)
        if (abre(eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, candidatos[i], nullptr)))
            return;
    fallaEgl(
        "no tiene una plataforma sin ventanas (EGL_MESA_platform_surfaceless o EGL_EXT_platform_device)");
}

// Mesa 25.0 da un pbuffer con muestras y no deja leerlo: todo saldría vacío.
bool seLee() {
    unsigned char rgba[4];
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    return glGetError() == GL_NO_ERROR;
}

} // namespace

int creaContexto(int ancho, int alto, bool profundidad, bool plantilla, bool muestras) {
    limitaMesa();
    // en un pbuffer, el rasterizador lineal de llvmpipe descoloca los componentes de los rectángulos lisos y pequeños
    setenv("LP_PERF", "no_rast_linear", 0);
    abrePantalla();
    // clang-format off
    const EGLint atributos[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT,
                                EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                EGL_RED_SIZE, 8,
                                EGL_GREEN_SIZE, 8,
                                EGL_BLUE_SIZE, 8,
                                EGL_ALPHA_SIZE, 8,
                                EGL_DEPTH_SIZE, profundidad ? 24 : 0,
                                EGL_STENCIL_SIZE, plantilla ? 8 : 0,
                                EGL_SAMPLES, muestras && std::getenv("LAB_SUAVIZA") ? 4 : 0,
                                EGL_NONE};
    // clang-format on
    // EGL ofrece primero las de más bits por componente: hay que buscar la de 8 exactos
    EGLConfig candidatas[64];
    EGLint cuantas = 0, bits = 0;
    eglChooseConfig(pantalla, atributos, candidatas, 64, &cuantas);
    for (EGLint i = 0; i < cuantas && !configuracion; ++i)
        if (eglGetConfigAttrib(pantalla, candidatas[i], EGL_RED_SIZE, &bits) && bits == 8)
            configuracion = candidatas[i];
    if (!configuracion)
        fallaEgl("no ofrece un framebuffer RGB de 8 bits para OpenGL");
    eglBindAPI(EGL_OPENGL_API);
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 1, EGL_NONE};
    contexto = eglCreateContext(pantalla, configuracion, EGL_NO_CONTEXT, version);
    if (contexto == EGL_NO_CONTEXT)
        fallaEgl("no puede crear un contexto OpenGL 3.1");
    cambiaTallaContexto(ancho, alto);
    EGLint suyas = 0;
    eglGetConfigAttrib(pantalla, configuracion, EGL_SAMPLES, &suyas);
    if (suyas == 0 || seLee())
        return suyas;
    destruyeContexto();
    configuracion = nullptr;
    return creaContexto(ancho, alto, profundidad, plantilla, false);
}

void cambiaTallaContexto(int ancho, int alto) {
    const EGLint talla[] = {EGL_WIDTH, ancho, EGL_HEIGHT, alto, EGL_NONE};
    const EGLSurface nueva = eglCreatePbufferSurface(pantalla, configuracion, talla);
    if (nueva == EGL_NO_SURFACE || !eglMakeCurrent(pantalla, nueva, nueva, contexto))
        fallaEgl("no admite una imagen de " + std::to_string(ancho) + "×" + std::to_string(alto));
    if (superficie != EGL_NO_SURFACE)
        eglDestroySurface(pantalla, superficie);
    superficie = nueva;
}

void destruyeContexto() {
    eglMakeCurrent(pantalla, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroySurface(pantalla, superficie);
    eglDestroyContext(pantalla, contexto);
    eglTerminate(pantalla);
    superficie = EGL_NO_SURFACE;
    contexto = EGL_NO_CONTEXT;
}

void diTitulo(const char *) {
}

void cedeAlNavegador() {
}

void (*direccionGL(const char *nombre))() {
    return eglGetProcAddress(nombre);
}

} // namespace sin_ventana
