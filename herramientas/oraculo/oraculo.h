// Referencia en doble precisión de lo que deben dibujar los programas: trazado de rayos de unos pocos
// sólidos, modelo de Phong, cobertura exacta y comparación con la imagen de la GPU. No comparte código
// numérico con los programas, ni con common/, ni con GLM: de common/ solo toma Imagen, como caja de píxeles.
// Ángulos en radianes; la fila 0 de una imagen es la de abajo. Se usa así:
//
//   const Camara camara = perspectiva(orbita(0.5, 0.25, 23, {1.5, 5.2, 0}), 0.6, 1, 100);
//   const Escena escena = {caja(traslada({0, 5, 0}) * escala({1, 10, 1})), esfera(traslada({2, 1, 0}))};
//   const Imagen gpu = ejecuta("ch05_iluminacion/…").imagen;
//   const Comparacion c = compara(gpu, escena, camara, [&](const Impacto &i) {
//       return i ? phong(materiales[i.objeto], La, {luz}, i.punto, i.normal, haciaOjo(i)) : fondo;
//   });
//   EXPECT_LE(c.maximo, 1) << c; // niveles de 255, lejos de los bordes
//   EXPECT_LE(c.desvio, 1) << c; // píxeles, en los bordes
//
// Quien incluya además una cabecera con los mismos nombres (Luz, Material, Camara…), que escriba oraculo::.
#pragma once
#include "cobertura.h"
#include "compara.h"
#include "luz.h"
