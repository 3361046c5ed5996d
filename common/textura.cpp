#include "textura.h"
#include "error.h"
#include <algorithm>
#include <string>

void compruebaQueCabe(const Imagen &imagen) {
    GLint mayor = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &mayor);
    if (std::max(imagen.ancho, imagen.alto) > mayor)
        falla("una textura de " + std::to_string(imagen.ancho) + "×" + std::to_string(imagen.alto) +
              " es demasiado grande: este OpenGL las admite de hasta " + std::to_string(mayor) + " de lado");
}

GLuint creaTextura2D(const Imagen &imagen) {
    compruebaQueCabe(imagen);
    GLuint textura;
    glGenTextures(1, &textura);
    glBindTexture(GL_TEXTURE_2D, textura);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1); // con 4, lo normal, se tuercen los anchos no múltiplos de 4
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, imagen.ancho, imagen.alto, 0, GL_RGB, GL_UNSIGNED_BYTE,
                 imagen.rgb.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    return textura;
}
