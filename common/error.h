// Cómo termina un programa que no puede seguir: una línea en español en stderr y un estado distinto de cero.
#pragma once
#include <string>

/// Escribe «programa: mensaje» en stderr y termina con `estado`
/// (1: error del propio programa; 2: opción o guion mal escritos).
[[noreturn]] void falla(const std::string &mensaje, int estado = 1);

/// Escribe «programa: aviso: mensaje» en stderr y sigue.
void avisa(const std::string &mensaje);

/// Para std::atexit: estado 1 si algo de lo escrito en stdout se ha perdido.
void compruebaSalida();

/// Nombre del ejecutable, sin carpeta.
std::string nombrePrograma();
