// Dónde están los ficheros del laboratorio (shaders, modelos, texturas). La carpeta de trabajo nunca importa.
#pragma once
#include <algorithm>
#include <string>

/// Ruta completa de un fichero del laboratorio, dado por su ruta desde la raíz
/// («ch03_transformaciones/objeto.vert»). Se busca, por este orden, en las carpetas de $LAB_RAIZ (separadas como
/// las de $PATH), en la del ejecutable y en la que la contiene (árbol instalado), en la carpeta en que se compiló
/// (texturas) y en el árbol de fuentes; con $LAB_SOLO_RAIZ, solo en las primeras. Si no está en ninguna, termina con
/// un mensaje que las enumera todas.
/// Lo que se encuentra se apunta en el fichero $LAB_LEIDOS, si se pide.
std::string recurso(const std::string &relativa);

/// Contenido completo de un fichero de 256 MiB a lo sumo; si no se puede leer, termina diciendo por qué.
std::string leeFichero(const std::string &ruta);

/// Las mismas para lo que se lee con la ventana abierta: si no pueden, devuelven false y dejan en `error` por qué.
bool intentaRecurso(const std::string &relativa, std::string &ruta, std::string &error);
bool intentaLeer(const std::string &ruta, std::string &contenido, std::string &error);

/// Como intentaLeer, de un texto en UTF-8, sin la marca que le pone el Bloc de notas y con sus líneas acabadas en '\n',
/// aunque las acabe solo '\r', como en un Mac antiguo. En UTF-16 no se lee, y se dice.
inline bool intentaTexto(const std::string &ruta, std::string &texto, std::string &error) {
    if (!intentaLeer(ruta, texto, error))
        return false;
    if (const std::string marca = texto.substr(0, 2); marca == "\xFF\xFE" || marca == "\xFE\xFF") {
        error = "«" + ruta +
                "» está en UTF-16: ábrelo en el editor y guárdalo en UTF-8 (lo elige «Guardar como»)";
        return false;
    }
    if (texto.compare(0, 3, "\xEF\xBB\xBF") == 0)
        texto.erase(0, 3);
    if (texto.find('\n') == std::string::npos)
        std::replace(texto.begin(), texto.end(), '\r', '\n');
    return true;
}
