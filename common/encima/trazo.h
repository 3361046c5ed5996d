// Líneas, puntos y flechas de cualquier grosor, hechos de triángulos: en OpenGL 3.1 una línea mide un píxel
// (glLineWidth es de antes) y cada controlador elige cuáles pinta. Los grosores son píxeles de una pantalla de 1080
// líneas, y nunca menos de uno de los de la ventana.
//
// `transformacion` lleva los puntos a coordenadas de recortado (proyeccion * camara * M; mat4(1) si ya son las
// normalizadas del panel). Lo que queda delante del plano cerca se corta, y el trazo que va por el borde del panel se
// mete dentro. Obedecen al test de profundidad si está activo y no cambian el estado de OpenGL.
#pragma once
#include <glm/glm.hpp>
#include <vector>

const float GROSOR = 6;

/// Un segmento por cada dos puntos.
void trazaSegmentos(const std::vector<glm::vec3> &extremos, const glm::mat4 &transformacion,
                    const glm::vec3 &color, float grosor = GROSOR);

/// La línea que une los puntos, en orden; `cerrada`, también el último con el primero.
void trazaPolilinea(const std::vector<glm::vec3> &puntos, const glm::mat4 &transformacion,
                    const glm::vec3 &color, float grosor = GROSOR, bool cerrada = false);

/// Los puntos de una circunferencia centrada en el origen, en el plano XY, para una polilínea cerrada.
std::vector<glm::vec3> circunferencia(float radio, int tramos = 64);

/// Los segmentos de una cuadrícula centrada en el origen, en el plano XY.
std::vector<glm::vec3> cuadricula(float lado, float casilla);

/// Un disco en cada punto.
void trazaPuntos(const std::vector<glm::vec3> &puntos, const glm::mat4 &transformacion,
                 const glm::vec3 &color, float diametro = 3 * GROSOR);

/// Una flecha de `a` a `b`.
void trazaFlecha(const glm::vec3 &a, const glm::vec3 &b, const glm::mat4 &transformacion,
                 const glm::vec3 &color, float grosor = GROSOR);

/// Un polígono convexo relleno.
void trazaPoligono(const std::vector<glm::vec3> &puntos, const glm::mat4 &transformacion,
                   const glm::vec3 &color);
