#include "guarda.h"
#include "motivo.h"
#include "sistema.h"
#include <cstdio>
#include <filesystem>
#include <optional>

namespace fs = std::filesystem;

bool intentaGuardar(const std::string &fichero, const std::string &bytes, std::string &error) {
    std::error_code ec;
    error.clear();
    const auto comprueba = [&](bool bien) {
        if (!bien && error.empty()) // el motivo es el del primer fallo
            error = "no puedo guardar «" + fichero + "»: " + (ec ? motivo(ec) : motivo());
        return bien;
    };

    // Renombrar solo vale entre ficheros corrientes; un enlace se sigue hasta donde apunta, exista o no.
    fs::path destino = fs::u8path(fichero);
    const bool dispositivo = fs::exists(destino, ec) && !fs::is_regular_file(destino, ec);
    const fs::file_status estado = fs::status(destino, ec);
    if (!comprueba(estado.type() != fs::file_type::none)) // los enlaces dan vueltas
        return false;
    std::optional<SinSenales> sinSenales; // un dispositivo puede no acabar nunca
    fs::path parcial = destino;
    if (!dispositivo) {
        while (fs::is_symlink(destino, ec))
            destino = destino.parent_path() / fs::read_symlink(destino, ec);
        parcial = destino;
        parcial += "." + std::to_string(numeroDeProceso()) + ".parcial";
        sinSenales.emplace();
    }
    ec.clear();

    FILE *f = std::fopen(parcial.u8string().c_str(), "wb");
    if (!comprueba(f != nullptr))
        return false;
    std::fwrite(bytes.data(), 1, bytes.size(), f);
    comprueba(std::fflush(f) == 0 && !std::ferror(f));
    comprueba(std::fclose(f) == 0);
    if (error.empty() && !dispositivo) {
        fs::rename(parcial, destino, ec); // std::rename no sustituye en Windows
        comprueba(!ec);
    }
    if (!error.empty() && !dispositivo)
        fs::remove(parcial, ec);
    return error.empty();
}
