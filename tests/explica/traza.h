// Ejecuta un shader reescrito y recoge lo que apunta, en cada píxel de un framebuffer de LADO × LADO.
#pragma once
#include "explica/glsl.h"
#include "mide/contexto_suelto.h"
#include "prueba.h"

namespace traza {

const int LADO = 4, SALIDAS = 4; // de LADO × LADO, para que dFdx y dFdy tengan vecinos

struct Paso {
    int nota;
    std::vector<double> valor;
};
struct Traza {
    std::vector<Paso> pasos;
    bool descartado = false;
};
using Pixeles = std::vector<glm::vec4>;

/// Abre el contexto la primera vez y deja enlazado un framebuffer con `cuantas` texturas RGBA32F.
inline void abre(int cuantas) {
    static std::map<int, GLuint> hechos;
    if (hechos.empty()) {
        abreContexto();
        glClampColor(GL_CLAMP_READ_COLOR, GL_FALSE);
    }
    GLuint &f = hechos[cuantas];
    if (f == 0) {
        glGenFramebuffers(1, &f);
        glBindFramebuffer(GL_FRAMEBUFFER, f);
        std::vector<GLuint> color(cuantas);
        std::vector<GLenum> cuales;
        glGenRenderbuffers(cuantas, color.data());
        for (int k = 0; k < cuantas; ++k) {
            glBindRenderbuffer(GL_RENDERBUFFER, color[k]);
            glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, LADO, LADO);
            cuales.push_back(GL_COLOR_ATTACHMENT0 + k);
            glFramebufferRenderbuffer(GL_FRAMEBUFFER, cuales[k], GL_RENDERBUFFER, color[k]);
        }
        glDrawBuffers(cuantas, cuales.data());
    }
    glBindFramebuffer(GL_FRAMEBUFFER, f);
    glViewport(0, 0, LADO, LADO);
}

/// El programa de dos textos; 0 y lo que dice el compilador, si no valen.
inline GLuint enlaza(const std::string &vert, const std::string &frag, std::string &error) {
    const GLuint programa = glCreateProgram();
    const auto informe = [&](auto pide, GLuint cual) {
        char texto[2000] = "";
        pide(cual, 2000, nullptr, texto);
        error += texto;
    };
    GLint bien = 0;
    for (const auto &[tipo, texto] :
         {std::pair{GL_VERTEX_SHADER, vert}, std::pair{GL_FRAGMENT_SHADER, frag}}) {
        const GLuint shader = glCreateShader(tipo);
        const char *fuente = texto.c_str();
        glShaderSource(shader, 1, &fuente, nullptr);
        glCompileShader(shader);
        glGetShaderiv(shader, GL_COMPILE_STATUS, &bien);
        if (!bien)
            informe(glGetShaderInfoLog, shader);
        glAttachShader(programa, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(programa);
    glGetProgramiv(programa, GL_LINK_STATUS, &bien);
    if (!bien)
        informe(glGetProgramInfoLog, programa);
    return bien ? programa : 0;
}

/// Lo que da cada salida del programa en uso, con un triángulo que lo cubre todo; `fondo`, lo que no pinta.
inline std::vector<Pixeles> dibuja(int cuantas, float fondo) {
    abre(cuantas);
    std::vector<Pixeles> todas(cuantas, Pixeles(LADO * LADO));
    glClearColor(fondo, fondo, fondo, fondo);
    glClear(GL_COLOR_BUFFER_BIT);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    for (int k = 0; k < cuantas; ++k) {
        glReadBuffer(GL_COLOR_ATTACHMENT0 + k);
        glReadPixels(0, 0, LADO, LADO, GL_RGBA, GL_FLOAT, todas[k].data());
    }
    return todas;
}

/// Lo apuntado en cada píxel, hasta `maximo` pasos, con el programa reescrito en uso.
inline std::vector<Traza> ejecuta(GLuint programa, const explica::Reescrito &r, int maximo = 4000) {
    const int n = LADO * LADO, huecos = explica::huecosDe(SALIDAS);
    std::vector<Traza> trazas(n);
    std::vector<int> total(n);
    std::vector<std::vector<int>> notas(n);
    std::vector<std::vector<glm::vec4>> valores(n);
    int mas = 1;
    for (int desde = 0; desde < std::min(mas, maximo); desde += huecos) {
        glUniform1i(glGetUniformLocation(programa, "explica_desde"), desde);
        const auto s = dibuja(SALIDAS, NAN);
        for (int q = 0; q < n; ++q) {
            total[q] = int(s[1][q].x) + 65536 * int(s[1][q].y);
            trazas[q].descartado = s[1][q].z != 0;
            mas = std::max(mas, total[q]);
            for (int h = 0; h < huecos; ++h) {
                notas[q].push_back(int(s[0][q][h]));
                valores[q].push_back(s[2 + h][q]);
            }
        }
    }
    for (int q = 0; q < n; ++q)
        for (int k = 0; k < std::min(total[q], maximo);) {
            const int nota = notas[q][k];
            EXPECT_TRUE(nota >= 0 && nota < int(r.notas.size())) << "paso " << k << ": " << nota;
            if (nota < 0 || nota >= int(r.notas.size()))
                return trazas;
            const std::string &tipo = r.notas[nota].tipo;
            valores[q].resize(std::max(valores[q].size(), std::size_t(k + 4)));
            trazas[q].pasos.push_back({nota, explica::valor(tipo, &valores[q][k].x)});
            for (int hueco = 1; hueco < explica::pasosDe(tipo); ++hueco)
                EXPECT_TRUE(k + hueco >= maximo || notas[q][k + hueco] == nota);
            k += explica::pasosDe(tipo);
        }
    return trazas;
}

} // namespace traza
