// Comprobaciones independientes del capítulo 1.
#include "ejecuta.h"
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>

// Todos los píxeles son (255, 255, 0), también después de cambiar de tamaño.
TEST(PrimerPrograma, TodoAmarillo) {
    for (const char *guion : {"", "tamano 333 77", "tamano 1 1"}) {
        const Ejecucion e = ejecuta("ch01_intro/primer_programa", guion);
        ASSERT_EQ(e.estado, 0) << e.errores;
        for (int y = 0; y < e.imagen.alto; ++y)
            for (int x = 0; x < e.imagen.ancho; ++x) {
                const Pixel p = pixel(e.imagen, x, y);
                ASSERT_TRUE(p.r == 255 && p.g == 255 && p.b == 0) << x << "," << y;
            }
    }
}

// La cobertura del triángulo contra la prueba exacta de semiplanos en el centro de cada píxel, en doble
// precisión. Los centros a menos de 1/256 de píxel de un lado (la rejilla de OpenGL) quedan fuera.
TEST(ShaderBasico, CoberturaDelTriangulo) {
    const int ancho = 240, alto = 180;
    const Ejecucion e = ejecuta("ch01_intro/shader_basico", "", ancho, alto);
    ASSERT_EQ(e.estado, 0) << e.errores;
    const double ndc[3][2] = {{-0.8, -0.7}, {0.8, -0.7}, {0.0, 0.8}};
    double v[3][2];
    for (int i = 0; i < 3; ++i) {
        v[i][0] = (ancho - alto) / 2 + (ndc[i][0] + 1) / 2 * alto;
        v[i][1] = (ndc[i][1] + 1) / 2 * alto;
    }
    int comparados = 0, dentroTotal = 0;
    for (int y = 0; y < alto; ++y)
        for (int x = 0; x < ancho; ++x) {
            double distancia = 1e9;
            for (int i = 0; i < 3; ++i) {
                const double *a = v[i], *b = v[(i + 1) % 3];
                const double dx = b[0] - a[0], dy = b[1] - a[1];
                distancia =
                    std::min(distancia, (dx * (y + 0.5 - a[1]) - dy * (x + 0.5 - a[0])) / std::hypot(dx, dy));
            }
            if (std::fabs(distancia) < 1.0 / 256)
                continue;
            const Pixel p = pixel(e.imagen, x, y);
            const bool dentro = p.r == 255 && p.g == 0 && p.b == 0,
                       fuera = p.r == 255 && p.g == 255 && p.b == 255;
            ASSERT_TRUE(distancia > 0 ? dentro : fuera) << x << "," << y << " distancia " << distancia;
            ++comparados;
            dentroTotal += dentro;
        }
    EXPECT_GT(comparados, ancho * alto * 99 / 100);
    EXPECT_GT(dentroTotal, 5000);
}

TEST(InfoOpengl, CadaClaveEsta) {
    const Ejecucion e = ejecuta("ch01_intro/info_opengl");
    EXPECT_EQ(e.estado, 0) << e.errores;
    for (const char *clave :
         {"OpenGL", "GLSL", "Fabricante", "Renderizador", "GLEW", "GLM", "FreeGLUT", "Textura 2D máxima",
          "Textura 3D máxima", "Mapa de cubo máximo", "Unidades de textura",
          "Unidades de textura en el vertex shader", "Atributos de vértice", "Muestras por píxel",
          "Anisotropía máxima", "Resultado"}) {
        const std::size_t i = ("\n" + e.salida).find("\n" + std::string(clave) + ": ");
        ASSERT_NE(i, std::string::npos) << clave;
        EXPECT_NE(e.salida[i + std::string(clave).size() + 2], '\n') << clave << " sin valor";
    }
}

// Sin ventana, ni la versión de OpenGL ni FreeGLUT son los del sistema, y lo dice.
TEST(InfoOpengl, DiceLoQueEsImitado) {
    const Ejecucion e = ejecuta("ch01_intro/info_opengl");
    EXPECT_NE(e.salida.find("(forzado con MESA_GL_VERSION_OVERRIDE=3.1FC)\n"), std::string::npos) << e.salida;
    EXPECT_NE(e.salida.find("(forzado con MESA_GLSL_VERSION_OVERRIDE=140)\n"), std::string::npos) << e.salida;
    EXPECT_NE(e.salida.find("(imitado: no hay pantalla)\n"), std::string::npos) << e.salida;
}

TEST(InfoOpengl, NoAceptaArgumentos) {
    const Ejecucion mal = ejecuta("ch01_intro/info_opengl", "", 9, 9, {"sobra"});
    EXPECT_EQ(mal.estado, 2);
    EXPECT_EQ(mal.errores, "info_opengl: no entiendo «sobra»; uso: info_opengl [opciones de GLUT]\n");
    EXPECT_EQ(ejecuta("ch01_intro/info_opengl", "", 9, 9, {"-ayuda"}).estado, 0);
}

TEST(InfoOpengl, SinOpengl31NoSaleConCero) {
    setenv("MESA_GL_VERSION_OVERRIDE", "2.1", 1);
    const Ejecucion e = ejecuta("ch01_intro/info_opengl");
    unsetenv("MESA_GL_VERSION_OVERRIDE");
    EXPECT_EQ(e.estado, 1);
    EXPECT_NE(e.errores.find("OpenGL 3.1"), std::string::npos) << e.errores;
}

TEST(ErroresShader, NombraFicheroYLinea) {
    const Ejecucion e = ejecuta("ch01_intro/errores_shader", "tecla 2");
    EXPECT_EQ(e.estado, 0) << e.errores;
    EXPECT_NE(e.salida.find("ch01_intro/errores_shader_compila.frag:8: "), std::string::npos) << e.salida;
    EXPECT_NE(e.salida.find("«colorFragmento = nuevoColor;»"), std::string::npos) << e.salida;
}

TEST(ErroresShader, ElDeEnlazadoNombraLosDosShadersYLaVariable) {
    const Ejecucion e = ejecuta("ch01_intro/errores_shader", "tecla 3");
    EXPECT_EQ(e.estado, 0) << e.errores;
    EXPECT_NE(
        e.salida.find("ch01_intro/errores_shader.vert y ch01_intro/errores_shader_enlaza.frag no enlazan"),
        std::string::npos)
        << e.salida;
    EXPECT_NE(e.salida.find("nuevoColor"), std::string::npos) << e.salida;
}

// Tras un error sigue vivo, con lo que dibujaba, y se recupera.
TEST(ErroresShader, SigueVivo) {
    const Ejecucion bien = ejecuta("ch01_intro/errores_shader");
    const Ejecucion vuelta = ejecuta("ch01_intro/errores_shader", "tecla 2; tecla 3; especial F5; tecla 1");
    const Ejecucion mal = ejecuta("ch01_intro/errores_shader", "tecla 2");
    EXPECT_EQ(bien.imagen.rgb, vuelta.imagen.rgb);
    EXPECT_NE(bien.imagen.rgb, mal.imagen.rgb);
    const Pixel centroBien = pixel(bien.imagen, 120, 80), centroMal = pixel(mal.imagen, 120, 80);
    EXPECT_TRUE(centroBien.r == centroMal.r && centroBien.g == centroMal.g && centroBien.b == centroMal.b);
}
