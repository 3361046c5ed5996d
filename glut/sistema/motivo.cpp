#include "motivo.h"

std::string motivo(const std::error_code &error) {
    static const struct {
        std::errc cual;
        const char *dice;
    } MOTIVOS[] = {
        {std::errc::no_such_file_or_directory, "no existe"},
        {std::errc::not_a_directory, "parte de la ruta no es una carpeta"},
        {std::errc::is_a_directory, "es una carpeta"},
        {std::errc::permission_denied, "no hay permiso"},
        {std::errc::operation_not_permitted, "no hay permiso"},
        {std::errc::read_only_file_system, "no se puede escribir ahí"},
        {std::errc::no_space_on_device, "no queda sitio en el disco"},
        {std::errc::file_too_large, "es demasiado grande"},
        {std::errc::filename_too_long, "el nombre es demasiado largo"},
        {std::errc::too_many_symbolic_link_levels, "los enlaces dan vueltas"},
        {std::errc::broken_pipe, "nadie la lee"},
        {std::errc::bad_file_descriptor, "está cerrada"},
    };
    for (const auto &[cual, dice] : MOTIVOS)
        if (error == cual)
            return dice;
    return error.message();
}
