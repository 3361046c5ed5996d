// compara_encima [--escribe] GOLDEN LISTA: si lo que un programa pinta encima (common/encima.h) es lo del golden: los
// mismos trazos en el mismo orden, con el mismo tipo, panel y texto; los sitios y las tallas, a 0.05 píxeles, que es
// más de lo que cambia un redondeo de un compilador a otro; los colores y las profundidades, a 0.001. Lo que no pinta
// nada no tiene golden. Estado: 0 bien; 4 mal, y dice qué trazo; 1 si no se puede leer. Con --escribe, lo que es
// distinto pasa a ser el golden, y está bien.
#include "encima.h"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

namespace {

const double DE_SITIO = 0.05, DE_COLOR = 0.001;

std::string enUnaLinea(std::string texto) {
    for (std::size_t i; (i = texto.find('\n')) != std::string::npos;)
        texto.replace(i, 1, "\\n");
    return texto;
}

/// Los números, con esos decimales como mucho y blancos entre ellos.
std::string numeros(std::initializer_list<double> valores, int decimales) {
    const double unidades = std::pow(10, decimales);
    std::ostringstream s;
    s.precision(12);
    for (const double v : valores)
        s << (s.tellp() > 0 ? " " : "")
          << std::round(v * unidades) / unidades + 0.0; // + 0.0: que no quede -0
    return s.str();
}

std::string color(const Pintado &p) {
    return numeros({p.color.r, p.color.g, p.color.b}, 3);
}

std::string panel(const Pintado &p) {
    return numeros({p.panel.x, p.panel.y, p.panel.z, p.panel.w}, 2);
}

std::string punto(const glm::dvec3 &p) {
    return numeros({p.x, p.y}, 2) + " " + numeros({p.z}, 3);
}

std::string nombre(const Pintado &p) {
    return p.tipo + (p.texto.empty() ? "" : " «" + enUnaLinea(p.texto) + "»");
}

bool lejos(double a, double b, double cuanto) {
    return !(std::fabs(a - b) <= cuanto);
}

bool lejos(const glm::dvec3 &a, const glm::dvec3 &b) {
    return lejos(a.x, b.x, DE_SITIO) || lejos(a.y, b.y, DE_SITIO) || lejos(a.z, b.z, DE_COLOR);
}

/// En qué se distinguen; vacío si en nada.
std::string distinto(const Pintado &debe, const Pintado &es) {
    std::string todo;
    const auto apunta = [&](bool lo, const std::string &que, const std::string &a, const std::string &b) {
        if (lo)
            todo += (todo.empty() ? "" : "; ") + que + " debía ser " + a + " y es " + b;
    };
    apunta(nombre(debe) != nombre(es), "el trazo", nombre(debe), nombre(es));
    if (debe.tipo != es.tipo) // lo demás no se parece en nada
        return todo;
    const glm::vec3 c = glm::abs(debe.color - es.color);
    apunta(lejos(c.r, 0, DE_COLOR) || lejos(c.g, 0, DE_COLOR) || lejos(c.b, 0, DE_COLOR), "el color",
           color(debe), color(es));
    apunta(debe.panel != es.panel, "el panel", panel(debe), panel(es));
    apunta(lejos(debe.talla, es.talla, DE_SITIO), "la talla", numeros({debe.talla}, 2),
           numeros({es.talla}, 2));
    apunta(debe.conProfundidad != es.conProfundidad, "la profundidad", debe.conProfundidad ? "1" : "0",
           es.conProfundidad ? "1" : "0");
    const std::size_t n = debe.puntos.size();
    apunta(n != es.puntos.size(), "el número de puntos", std::to_string(n), std::to_string(es.puntos.size()));
    for (std::size_t i = 0; i < std::min(n, es.puntos.size()); ++i)
        if (lejos(debe.puntos[i], es.puntos[i])) { // basta con el primero
            apunta(true, "el punto " + std::to_string(i + 1), punto(debe.puntos[i]), punto(es.puntos[i]));
            break;
        }
    return todo;
}

bool iguales(const Pintado &a, const Pintado &b) {
    return distinto(a, b).empty();
}

/// Dice en qué se distinguen los trazos de una imagen, y si se distinguen.
bool compara(const Encima &deben, const Encima &son) {
    bool mal = false;
    const auto dice = [&](std::size_t i, const std::string &que) {
        mal = true;
        std::cout << deben.imagen.substr(0, deben.imagen.find('\t')) << ", trazo " << i + 1 << ", " << que
                  << '\n';
    };
    if (deben.imagen != son.imagen) {
        dice(0, "la imagen debía ser " + deben.imagen + " y es " + son.imagen);
        return true;
    }
    // lo que sobra o falta en medio no es que todo lo demás esté cambiado
    const std::ptrdiff_t n = std::ptrdiff_t(deben.size()), m = std::ptrdiff_t(son.size());
    const auto principio =
        std::mismatch(deben.begin(), deben.end(), son.begin(), son.end(), iguales).first - deben.begin();
    std::ptrdiff_t fin = 0;
    while (fin < std::min(n, m) - principio &&
           iguales(deben[std::size_t(n - 1 - fin)], son[std::size_t(m - 1 - fin)]))
        ++fin;
    for (auto i = std::size_t(principio); i < std::size_t(std::max(n, m) - fin); ++i)
        if (n != m) {
            if (i < std::size_t(n - fin))
                dice(i, "falta " + nombre(deben[i]));
            if (i < std::size_t(m - fin))
                dice(i, "sobra " + nombre(son[i]));
        } else if (!iguales(deben[i], son[i]))
            dice(i, nombre(deben[i]) + ": " + distinto(deben[i], son[i]));
    return mal;
}

void escribe(const std::string &fichero, const std::vector<Encima> &imagenes) {
    std::ofstream salida(fichero);
    for (const Encima &imagen : imagenes) {
        salida << "imagen\t" << imagen.imagen << '\n';
        for (const Pintado &p : imagen) {
            salida << p.tipo << '\t' << color(p) << '\t' << panel(p) << '\t' << numeros({p.talla}, 2) << '\t'
                   << p.conProfundidad << '\t';
            for (const glm::dvec3 &v : p.puntos)
                salida << (&v == &p.puntos[0] ? "" : " ") << punto(v);
            salida << '\t' << enUnaLinea(p.texto) << '\n';
        }
    }
    if (!salida.flush())
        throw std::runtime_error("no puedo escribir en " + fichero);
}

/// Vacío si en ninguna imagen hay nada.
std::vector<Encima> lee(const std::string &fichero) {
    const std::vector<Encima> imagenes = leeEncima(fichero);
    const bool nada =
        std::all_of(imagenes.begin(), imagenes.end(), [](const Encima &e) { return e.empty(); });
    return nada ? std::vector<Encima>() : imagenes;
}

} // namespace

int main(int argc, char **argv) try {
    const bool dora = argc > 1 && std::string(argv[1]) == "--escribe";
    const std::string golden = argv[argc - 2];
    const std::vector<Encima> deben = lee(golden), son = lee(argv[argc - 1]);
    if (leeEncima(argv[argc - 1]).empty())
        throw std::runtime_error("el programa no ha apuntado ninguna imagen");
    bool mal = deben.size() != son.size();
    if (mal)
        std::cout << golden.substr(golden.rfind('/') + 1) << ": debía haber " << deben.size()
                  << " imágenes con algo encima y hay " << son.size() << '\n';
    for (std::size_t i = 0; i < std::min(deben.size(), son.size()); ++i)
        mal = compara(deben[i], son[i]) || mal;
    if (mal && dora) {
        std::filesystem::remove(golden);
        if (!son.empty())
            escribe(golden, son);
    }
    return mal && !dora ? 4 : 0;
} catch (const std::exception &error) {
    std::cerr << "compara_encima: " << error.what() << '\n';
    return 1;
}
