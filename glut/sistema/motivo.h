// Por qué no se ha podido abrir, leer o escribir algo, en español y sin depender del idioma del sistema.
#pragma once
#include <cerrno>
#include <string>
#include <system_error>

/// El motivo de un error del sistema; sin argumento, el de errno.
std::string motivo(const std::error_code &error = {errno, std::generic_category()});
