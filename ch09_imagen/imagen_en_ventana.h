// Lo que comparten los programas de este capítulo: la imagen es una textura pegada en un rectángulo que cabe en la
// ventana sin deformarse. Con una imagen del usuario la ventana toma su tamaño, salvo que -geometry diga otro, y
// entonces el texel (i, j) es el píxel (i, j): sin remuestrear y sin rótulos, para que se pueda comparar con lo que
// haga cualquier otra herramienta.
#pragma once
#include "colores.h"
#include "error.h"
#include "imagen.h"
#include "recuadro.h"
#include "rotulo.h"
#include "textura.h"
#include "ventana.h"
#include <algorithm>
#include <cmath>
#include <cstring>

/// Cómo se ve un programa del capítulo.
struct Muestra {
    glm::ivec2 talla; // de la imagen
    bool rotulos, compara = false;
};

inline glm::ivec2 tallaDe(const Imagen &imagen) {
    return {imagen.ancho, imagen.alto};
}

/// Abre la ventana y lee las imágenes que se pidan, tantas como las que hay por omisión. Se muestran con la forma de la
/// primera y, si no son del usuario, con rótulos.
inline std::vector<Imagen> abreVentanaConImagenes(int &argc, char **argv, const char *titulo,
                                                  const std::vector<ImagenPorOmision> &porOmision,
                                                  Muestra &muestra) {
    const bool conTalla =
        std::any_of(argv, argv + argc, [](const char *a) { return !std::strcmp(a, "-geometry"); });
    abreVentana(argc, argv, titulo, GLUT_DOUBLE | GLUT_MULTISAMPLE,
                porOmision.size() == 1 ? "[FOTO.ppm | FOTO.rgb -talla ANCHOxALTO]"
                                       : "[A.ppm B.ppm | A.rgb B.rgb -talla ANCHOxALTO]");
    const std::vector<Imagen> imagenes = imagenesDeArgumentos(argc, argv, porOmision);
    const bool propias = argc > 1;
    muestra = {tallaDe(imagenes[0]), !propias};
    if (propias && !conTalla)
        glutReshapeWindow(muestra.talla.x, muestra.talla.y);
    return imagenes;
}

/// Textura sin mipmaps y con GL_CLAMP_TO_EDGE, en la unidad activa: en el centro de un texel el filtro lineal da ese
/// texel y fuera de la imagen, el del borde.
inline GLuint creaTexturaExacta(GLint formatoInterno, const glm::ivec2 &talla, GLenum formato, GLenum tipo,
                                const void *datos) {
    GLuint textura;
    glGenTextures(1, &textura);
    glBindTexture(GL_TEXTURE_2D, textura);
    glTexImage2D(GL_TEXTURE_2D, 0, formatoInterno, talla.x, talla.y, 0, formato, tipo, datos);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return textura;
}
inline GLuint creaTexturaExacta(const Imagen &imagen) {
    compruebaQueCabe(imagen);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    return creaTexturaExacta(GL_RGB8, {imagen.ancho, imagen.alto}, GL_RGB, GL_UNSIGNED_BYTE,
                             imagen.rgb.data());
}

/// La misma con mipmaps: reducida a la mitad o más, promedia; a su tamaño o mayor no cambia nada.
inline GLuint creaTexturaReducible(const Imagen &imagen) {
    const GLuint textura = creaTexturaExacta(imagen);
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    return textura;
}

/// Un framebuffer cuyo color es una textura: lo que se dibuja en él se lee después.
struct Lienzo {
    GLuint framebuffer, textura;
};
inline Lienzo creaLienzo(const glm::ivec2 &talla, GLint formatoInterno = GL_RGBA8) {
    const bool enFloat = formatoInterno == GL_RGBA32F;
    Lienzo lienzo;
    lienzo.textura =
        creaTexturaExacta(formatoInterno, talla, GL_RGBA, enFloat ? GL_FLOAT : GL_UNSIGNED_BYTE, nullptr);
    if (enFloat) { // no todos saben interpolar texturas de float
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    }
    glGenFramebuffers(1, &lienzo.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, lienzo.framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, lienzo.textura, 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        falla("este OpenGL no dibuja en un framebuffer de esa clase");
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return lienzo;
}

/// El mayor rectángulo con la forma de la imagen que cabe en el panel, en su centro. Si miden lo mismo es el panel.
inline Recuadro encaja(const glm::ivec2 &talla, const Recuadro &panel) {
    const double escala = std::min(double(panel.ancho) / talla.x, double(panel.alto) / talla.y);
    const int ancho = std::max(int(std::lround(escala * talla.x)), 1),
              alto = std::max(int(std::lround(escala * talla.y)), 1);
    return {panel.x + (panel.ancho - ancho) / 2, panel.y + (panel.alto - alto) / 2, ancho, alto};
}

/// Dónde va la imagen: en la ventana entera o, si se compara, en `n` paneles, juntos en medio de ella.
inline std::vector<Recuadro> recuadros(const Muestra &muestra, int n) {
    std::vector<Recuadro> sitios =
        reparte(muestra.compara ? n : 1, float(muestra.talla.x) / float(muestra.talla.y));
    int columnas = 0;
    for (const Recuadro &sitio : sitios)
        columnas += sitio.y == sitios[0].y;
    const int filas = (int(sitios.size()) + columnas - 1) / columnas;
    for (int i = 0; i < int(sitios.size()); ++i) {
        const Recuadro panel = sitios[i];
        Recuadro &sitio = sitios[i] = encaja(muestra.talla, panel);
        sitio.x += (columnas - 1 - i % columnas * 2) * (panel.ancho - sitio.ancho) / 2;
        sitio.y -= (filas - 1 - i / columnas * 2) * (panel.alto - sitio.alto) / 2;
    }
    return sitios;
}

/// El rectángulo de imagen.vert, con el programa en uso.
inline void dibujaRectangulo() {
    static GLuint vao = 0;
    if (!vao)
        glGenVertexArrays(1, &vao);
    glBindVertexArray(vao);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

/// Rótulo en la esquina de abajo de lo que se dibuja, si se piden.
inline void rotulaImagen(const Muestra &muestra, const std::string &texto) {
    if (muestra.rotulos)
        rotula(texto, {0, 0.02f}, BLANCO, Lado::ENCIMA);
}

/// Atiende las teclas comunes, v (compara) y r (rótulos). Devuelve si la tecla era suya.
inline bool teclaMuestra(Muestra &muestra, unsigned char tecla) {
    if (tecla == 'v')
        muestra.compara = !muestra.compara;
    else if (tecla == 'r')
        muestra.rotulos = !muestra.rotulos;
    else
        return teclaComun(tecla);
    glutPostRedisplay();
    return true;
}
