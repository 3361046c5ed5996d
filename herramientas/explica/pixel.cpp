#include "pixel.h"
#include "nombres.h"
#include "programas.h"
#include <algorithm>

namespace explica {
namespace {

// Lo que hay en un píxel.
struct Contenido {
    std::optional<Color> color;
    std::optional<double> profundidad;
    std::optional<int> plantilla;
};

Contenido lee(const Lienzo &l, Punto p) {
    const Guardado guardado;
    Contenido c;
    if (l.conColor())
        c.color = leeColor(l, p.x, p.y);
    if (l.bitsProfundidad && !l.muestras)
        c.profundidad = leeProfundidades(l, p.x, p.y, 1, 1)[0];
    if (l.bitsPlantilla && !l.muestras)
        c.plantilla = leePlantilla(l, p.x, p.y, 1, 1)[0];
    return c;
}

// Las que cubren el píxel, aunque luego no se vean.
void cubren(const Sueltas &s, int desde, int hasta, std::vector<int> &cuales) {
    if (desde == hasta || muestrasDe([&] { s.dibuja(desde, hasta); }) == 0)
        return;
    if (hasta - desde == 1)
        return cuales.push_back(desde);
    const int medio = (desde + hasta) / 2;
    cubren(s, desde, medio, cuales);
    cubren(s, medio, hasta, cuales);
}

bool enRecorte(Punto p) {
    const auto r = cuatro(GL_SCISSOR_BOX);
    return p.x >= r[0] && p.y >= r[1] && p.x < r[0] + r[2] && p.y < r[1] + r[3];
}

using Pinta = std::function<void()>;

// Cómo se pregunta por una orden: con su programa, y con otro que cubre lo mismo y no descarta.
struct Pregunta {
    const Lienzo &lienzo;
    Punto pixel;
    GLuint programa, cobertura;
    bool dentroDelRecorte;
};

// La primera prueba que no pasa, en el orden en que las hace OpenGL.
std::string veredicto(const Pregunta &q, const Pinta &pinta) {
    const Guardado g;
    const bool escribe = escribeColor() && q.lienzo.buferColor != GL_NONE;
    soloPregunta(q.pixel);
    const auto pasa = [&](GLuint programa, bool cara, bool plantilla, bool profundidad) {
        glUseProgram(programa);
        pon(GL_CULL_FACE, cara);
        pon(GL_STENCIL_TEST, plantilla);
        pon(GL_DEPTH_TEST, profundidad);
        return muestrasDe(pinta) > 0;
    };
    const bool plantilla = g.lleva(GL_STENCIL_TEST);
    if (g.lleva(GL_CULL_FACE) && !pasa(q.cobertura, true, false, false))
        return "cara";
    if (!q.dentroDelRecorte)
        return "recorte";
    if (q.cobertura != q.programa && !pasa(q.programa, false, false, false))
        return "descartado";
    if (plantilla && !pasa(q.programa, false, true, false))
        return "plantilla";
    if (g.lleva(GL_DEPTH_TEST) && !pasa(q.programa, false, plantilla, true))
        return "profundidad";
    return escribe ? "escrito" : "mascara";
}

// Si lo habría escrito sin esa prueba, que es la primera que no pasa: si pasa las demás.
bool soloEsa(const Pregunta &q, const Pinta &pinta, const std::string &prueba) {
    const Guardado g;
    const bool escribe = escribeColor();
    soloPregunta(q.pixel);
    const auto hay = [&](const char *nombre, GLenum interruptor) {
        pon(interruptor, prueba != nombre && g.lleva(interruptor));
    };
    hay("cara", GL_CULL_FACE);
    hay("plantilla", GL_STENCIL_TEST);
    hay("profundidad", GL_DEPTH_TEST);
    glUseProgram(prueba == "descartado" ? q.cobertura : q.programa);
    return (prueba == "recorte" || q.dentroDelRecorte) && (prueba == "mascara" || escribe) &&
           muestrasDe(pinta) > 0;
}

struct Fragmento {
    Pixel color;
    float profundidad;
};

// Lo que da el shader en ese píxel, sin pruebas ni mezcla. Nada si descarta.
std::optional<Fragmento> fragmentoDe(const Pregunta &q, const Pinta &pinta) {
    const Guardado guardado;
    abreAparte(q.lienzo);
    soloPregunta(q.pixel);
    glDepthMask(GL_TRUE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    Fragmento f{coloresAparte(q.pixel.x, q.pixel.y, 1, 1, pinta)[0], 0};
    if (f.color == NINGUNO)
        return {};
    f.profundidad = profundidadAparte(q.pixel.x, q.pixel.y);
    return f;
}

double factor(GLenum cual, int canal, const std::array<double, 4> &origen,
              const std::array<double, 4> &destino) {
    GLfloat k[4];
    glGetFloatv(GL_BLEND_COLOR, k);
    switch (cual) {
    case GL_ZERO: return 0;
    case GL_ONE: return 1;
    case GL_SRC_COLOR: return origen[canal];
    case GL_ONE_MINUS_SRC_COLOR: return 1 - origen[canal];
    case GL_DST_COLOR: return destino[canal];
    case GL_ONE_MINUS_DST_COLOR: return 1 - destino[canal];
    case GL_SRC_ALPHA: return origen[3];
    case GL_ONE_MINUS_SRC_ALPHA: return 1 - origen[3];
    case GL_DST_ALPHA: return destino[3];
    case GL_ONE_MINUS_DST_ALPHA: return 1 - destino[3];
    case GL_CONSTANT_COLOR: return double(k[canal]);
    case GL_ONE_MINUS_CONSTANT_COLOR: return 1 - double(k[canal]);
    case GL_CONSTANT_ALPHA: return double(k[3]);
    case GL_ONE_MINUS_CONSTANT_ALPHA: return 1 - double(k[3]);
    case GL_SRC_ALPHA_SATURATE: return canal == 3 ? 1 : std::min(origen[3], 1 - destino[3]);
    default: return 0;
    }
}

double combina(GLenum ecuacion, double a, double fa, double b, double fb) {
    switch (ecuacion) {
    case GL_FUNC_SUBTRACT: return a * fa - b * fb;
    case GL_FUNC_REVERSE_SUBTRACT: return b * fb - a * fa;
    case GL_MIN: return std::min(a, b);
    case GL_MAX: return std::max(a, b);
    default: return a * fa + b * fb;
    }
}

// Lo que debe quedar en el píxel, hecho aquí otra vez: el color del shader mezclado con el que hay.
std::pair<Json, bool> mezcla(const Fragmento &f, const Color &antes, const Color &despues, const Lienzo &l) {
    const bool mezcla = glIsEnabled(GL_BLEND), acotado = l.componentes == GL_UNSIGNED_NORMALIZED;
    std::array<double, 4> origen{}, destino{}, factorOrigen{}, factorDestino{};
    Color suma{};
    const auto escribe = mascaraDeColor();
    for (int c = 0; c < 4; ++c) {
        origen[c] = acotado ? std::clamp(double(f.color[c]), 0.0, 1.0) : double(f.color[c]);
        if (acotado && mezcla) // se mezcla con los bits que tiene el framebuffer
            origen[c] = std::round(origen[c] * 255) / 255;
        destino[c] = antes[c] / 255;
    }
    bool cuadra = true;
    for (int c = 0; c < 4; ++c) {
        const bool alfa = c == 3;
        const auto de = [&](GLenum rgb, GLenum a) { return GLenum(entero(alfa ? a : rgb)); };
        factorOrigen[c] = mezcla ? factor(de(GL_BLEND_SRC_RGB, GL_BLEND_SRC_ALPHA), c, origen, destino) : 1;
        factorDestino[c] = mezcla ? factor(de(GL_BLEND_DST_RGB, GL_BLEND_DST_ALPHA), c, origen, destino) : 0;
        const double v = mezcla ? combina(de(GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA), origen[c],
                                          factorOrigen[c], destino[c], factorDestino[c])
                                : origen[c];
        suma[c] = !escribe[c] ? antes[c] : 255 * (acotado ? std::clamp(v, 0.0, 1.0) : v);
        // los dos productos y lo que dan se redondean a un nivel
        cuadra = cuadra && (alfa || std::fabs(suma[c] - despues[c]) <= 1.5 || std::isnan(suma[c]));
    }
    return {{{"si", mezcla},
             {"ecuacion", nombreDe(GLenum(entero(GL_BLEND_EQUATION_RGB)))},
             {"factorOrigen", factorOrigen},
             {"factorDestino", factorDestino},
             {"origen", origen},
             {"destino", destino},
             {"suma", suma},
             {"cuadra", cuadra}},
            cuadra};
}

std::string enPalabras(const std::string &veredicto, const Lienzo &l, const Contenido &antes,
                       const std::optional<Fragmento> &f) {
    const auto constante = [](GLenum cual) { return nombreDe(GLenum(entero(cual))); };
    if (veredicto == "cara")
        return "quitado por su cara (" + constante(GL_CULL_FACE_MODE) + ")";
    if (veredicto == "recorte")
        return "fuera del recorte (glScissor)";
    if (veredicto == "descartado")
        return "el shader lo descarta (discard)";
    if (veredicto == "mascara")
        return l.buferColor != GL_NONE ? "no escribe color (glColorMask)"
               : l.nombre ? "no escribe color: no hay dónde (glFramebufferTexture2D, glDrawBuffer)"
                          : "no escribe color (glDrawBuffer es GL_NONE)";
    if (veredicto == "plantilla")
        return "no pasa la plantilla: hay " + std::to_string(antes.plantilla.value_or(0)) + " y se pide " +
               constante(GL_STENCIL_FUNC) + " " + std::to_string(pideLaPlantilla());
    if (veredicto == "profundidad" && f && antes.profundidad)
        return "oculto: su profundidad es " + cifras(double(f->profundidad), 6) + " y había " +
               cifras(*antes.profundidad, 6) + " (" + constante(GL_DEPTH_FUNC) + ")";
    return veredicto == "profundidad" ? "oculto (" + constante(GL_DEPTH_FUNC) + ")" : "escrito";
}

Suceso suceso(int numero, const Lienzo &l, const std::string &veredicto, const std::string &dice,
              const Contenido &antes, const Contenido &despues) {
    const Json s = {{"orden", numero},
                    {"veredicto", veredicto},
                    {"dice", dice},
                    {"framebuffer", l.nombre},
                    {"antes", antes.color},
                    {"despues", despues.color},
                    {"profundidadAntes", antes.profundidad},
                    {"profundidadDespues", despues.profundidad},
                    {"plantillaAntes", antes.plantilla},
                    {"plantillaDespues", despues.plantilla}};
    return {numero, l.nombre, veredicto, -1, despues.color, s};
}

// Una primitiva que cubre el píxel, y con ella las que van entre la anterior y esta, que no lo cubren.
Suceso hazPrimitiva(const Pregunta &q, const Sueltas &s, int numero, int cual, const Pinta &haz) {
    const Pinta pinta = [&] { s.dibuja(cual, cual + 1); };
    const std::string que = veredicto(q, pinta);
    const std::optional<Fragmento> f = fragmentoDe(q, pinta);
    const bool sinEsa = que != "escrito" && soloEsa(q, pinta, que);
    const Contenido antes = lee(q.lienzo, q.pixel);
    haz();
    const Contenido despues = lee(q.lienzo, q.pixel);
    Suceso hecho = suceso(numero, q.lienzo, que, enPalabras(que, q.lienzo, antes, f), antes, despues);
    hecho.primitiva = cual;
    Json &json = hecho.json;
    const auto primero = s.primitivas.indices.begin() + cual * s.primitivas.vertices;
    json.pon("primitiva", cual).pon("tipo", nombrePrimitiva(s.primitivas)).pon("soloEsa", sinEsa);
    json.pon("vertices", std::vector<GLuint>(primero, primero + s.primitivas.vertices));
    if (glIsEnabled(GL_STENCIL_TEST))
        json.pon("plantillaPide",
                 nombreDe(GLenum(entero(GL_STENCIL_FUNC))) + " " + std::to_string(pideLaPlantilla()));
    if (glIsEnabled(GL_DEPTH_TEST))
        json.pon("profundidadPide", nombreDe(GLenum(entero(GL_DEPTH_FUNC))));
    if (!f)
        return hecho;
    json.pon("color", f->color).pon("profundidad", f->profundidad);
    if (que == "escrito" && antes.color && despues.color && !q.lienzo.muestras) {
        const auto [suya, cuadra] = mezcla(*f, *antes.color, *despues.color, q.lienzo);
        if (cuadra || !EN_WEB || !entero(GL_SAMPLES)) // si la ventana tiene muestras, puede cubrirlo en parte
            json.pon("mezcla", suya), hecho.cambia = antes.color != despues.color || !glIsEnabled(GL_BLEND);
    }
    return hecho;
}

// De muchas instancias a la vez se dice lo que hacen todas: no se sabe dibujar una sola.
void dibujaInstancias(const Orden &o, int numero, const Pregunta &q, std::vector<Suceso> &sucesos) {
    const auto cubre = [&] {
        const Guardado guardado;
        glUseProgram(q.cobertura);
        soloPregunta(q.pixel);
        return muestrasDe(o.hazla) != 0;
    };
    if (!cubre())
        return o.hazla();
    std::string que = veredicto(q, o.hazla);
    const Contenido antes = lee(q.lienzo, q.pixel);
    o.hazla();
    const Contenido despues = lee(q.lienzo, q.pixel);
    if (antes.color != despues.color) // la plantilla o la profundidad de una dejan pasar a la siguiente
        que = "escrito";
    const std::string dice =
        que == "escrito" ? "escrito por alguna instancia" : enPalabras(que, q.lienzo, antes, {});
    sucesos.push_back(suceso(numero, q.lienzo, que, dice, antes, despues));
}

void dibuja(const Orden &o, int numero, const Lienzo &l, Punto p, std::vector<Suceso> &sucesos) {
    const std::optional<Primitivas> primitivas = primitivasDe(o);
    const GLuint programa = GLuint(entero(GL_CURRENT_PROGRAM));
    if (!primitivas || !programa || primitivas->indices.empty() || glIsEnabled(GL_RASTERIZER_DISCARD))
        return o.hazla();
    const GLuint cobertura = [&] {
        const Guardado guardado;
        return sinDescartar(programa);
    }();
    const bool dentro = !glIsEnabled(GL_SCISSOR_TEST) || enRecorte(p);
    const Pregunta q{l, p, programa, cobertura, dentro};
    if (o.instancias != 1)
        return dibujaInstancias(o, numero, q, sucesos);
    const Sueltas s(*primitivas);
    std::vector<int> cuales;
    {
        const Guardado guardado;
        glUseProgram(cobertura);
        soloPregunta(p);
        cubren(s, 0, s.primitivas.cuantas(), cuales);
        // de los puntos, Mesa cuenta también alguno que pasa cerca y no pinta nada
        const auto noPinta = [&](int cual) { return !fragmentoDe(q, [&] { s.dibuja(cual, cual + 1); }); };
        if (s.primitivas.vertices == 1)
            cuales.erase(std::remove_if(cuales.begin(), cuales.end(), noPinta), cuales.end());
    }
    if (cuales.empty())
        return o.hazla();
    if (cuales.size() == 1) {
        sucesos.push_back(hazPrimitiva(q, s, numero, cuales[0], o.hazla));
        return;
    }
    int desde = 0;
    for (const int cual : cuales) {
        const int hasta = cual == cuales.back() ? s.primitivas.cuantas() : cual + 1;
        sucesos.push_back(hazPrimitiva(q, s, numero, cual, [&] { s.dibuja(desde, hasta); }));
        desde = hasta;
    }
}

bool enDestino(const Orden &o, Punto p) {
    const auto [x0, x1] = std::minmax(o.destino[0], o.destino[2]);
    const auto [y0, y1] = std::minmax(o.destino[1], o.destino[3]);
    return p.x >= x0 && p.x < x1 && p.y >= y0 && p.y < y1;
}

} // namespace

void siLoCambiaOtro(const Lienzo &l, const std::optional<Color> &color, std::vector<Suceso> &sucesos) {
    const auto suyo = std::find_if(sucesos.rbegin(), sucesos.rend(),
                                   [&](const Suceso &s) { return s.framebuffer == l.nombre; });
    const auto igual = [](double a, double b) { return a == b || (a != a && b != b); };
    if (suyo == sucesos.rend() || !color || !suyo->queda ||
        std::equal(color->begin(), color->end(), suyo->queda->begin(), igual))
        return;
    const std::string dice = "después de esta orden, algo que no sigo lo ha cambiado";
    sucesos.push_back(suceso(suyo->orden, l, "ajeno", dice, {suyo->queda, {}, {}}, {color, {}, {}}));
}

void hazYCuenta(const Orden &o, int numero, const Lienzo &l, Punto p, std::vector<Suceso> &sucesos) {
    if (!l.dentro(p.x, p.y))
        return o.hazla();
    if (l.conColor())
        siLoCambiaOtro(l, lee(l, p).color, sucesos);
    if (o.que == Orden::Que::Dibuja)
        return dibuja(o, numero, l, p, sucesos);
    if (o.que == Orden::Que::Copia && !enDestino(o, p))
        return o.hazla();
    const bool fuera = glIsEnabled(GL_SCISSOR_TEST) && !enRecorte(p);
    const bool mascara = o.que == Orden::Que::Borra && !escribeColor();
    const Contenido antes = lee(l, p);
    o.hazla();
    const bool conColor = (o.buferes & GL_COLOR_BUFFER_BIT) != 0,
               escribe = conColor && !mascara && l.buferColor != GL_NONE;
    const char *const que = fuera ? "recorte" : escribe ? "escrito" : "mascara";
    const std::string hecho = o.que == Orden::Que::Borra ? "borrado" : "copiado de otro framebuffer";
    const std::string dice = escribe && !fuera     ? hecho
                             : !conColor && !fuera ? hecho + ", pero no el color"
                                                   : enPalabras(que, l, antes, {});
    sucesos.push_back(suceso(numero, l, que, dice, antes, lee(l, p)));
}

} // namespace explica
