#include "textura.h"
#include "error.h"
#include <cstring>

GLuint creaTextura2D(const Imagen &imagen) {
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

GLuint creaTextura3D(int lado, const std::vector<unsigned char> &valores) {
    const std::size_t n = static_cast<std::size_t>(lado);
    if (valores.size() != n * n * n)
        falla("una textura 3D de lado " + std::to_string(lado) + " necesita " + std::to_string(n * n * n) +
              " valores y hay " + std::to_string(valores.size()));
    GLuint textura;
    glGenTextures(1, &textura);
    glBindTexture(GL_TEXTURE_3D, textura);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_R8, lado, lado, lado, 0, GL_RED, GL_UNSIGNED_BYTE, valores.data());
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    return textura;
}

GLuint creaMapaCubo(const std::array<Imagen, 6> &caras) {
    GLuint textura;
    glGenTextures(1, &textura);
    glBindTexture(GL_TEXTURE_CUBE_MAP, textura);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (GLuint i = 0; i < 6; ++i) {
        const Imagen &cara = caras[i];
        if (cara.ancho != cara.alto || cara.ancho != caras[0].ancho)
            falla("la cara " + std::to_string(i) + " del mapa de cubo mide " + std::to_string(cara.ancho) +
                  "×" + std::to_string(cara.alto) + " y debía medir " + std::to_string(caras[0].ancho) + "×" +
                  std::to_string(caras[0].ancho));
        const std::size_t fila = 3 * static_cast<std::size_t>(cara.ancho);
        std::vector<unsigned char> vuelta;
        for (int y = cara.alto - 1; y >= 0; --y) {
            const unsigned char *p = &cara.rgb[fila * static_cast<std::size_t>(y)];
            vuelta.insert(vuelta.end(), p, p + fila);
        }
        glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + i, 0, GL_RGB8, cara.ancho, cara.alto, 0, GL_RGB,
                     GL_UNSIGNED_BYTE, vuelta.data());
    }
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    for (GLenum eje : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTexParameteri(GL_TEXTURE_CUBE_MAP, eje, GL_CLAMP_TO_EDGE);
    return textura;
}
