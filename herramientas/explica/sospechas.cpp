#include "sospechas.h"
#include "enviado.h"
#include "nombres.h"
#include "sueltas.h"
#include <algorithm>
#include <regex>

namespace explica {
namespace {

const int SEGURO = 2, SI_NO_SE_VE_NADA = 1; // con la ventana lisa se dice todo
const std::size_t VERTICES = 256;           // los que se miran

using Puntos = std::vector<std::array<float, 4>>;

// Dónde caen los vértices de la orden, recogidos sin rasterizar.
Puntos posicionesDe(const Orden &orden) {
    const GLuint programa = GLuint(entero(GL_CURRENT_PROGRAM));
    std::optional<Primitivas> p = primitivasDe(orden);
    std::vector<GLuint> shaders;
    for (const Fuente &f : fuentesDe(programa))
        shaders.push_back(f.shader);
    if (!p || p->indices.empty() || shaders.empty() || orden.instancias != 1)
        return {};
    const Guardado guardado;
    const GLchar *const nombre = "gl_Position";
    const GLuint otro = gemelo(programa, "posiciones", [&] {
        return enlazaComo(programa, shaders, [&](GLuint suyo) {
            glTransformFeedbackVaryings(suyo, 1, &nombre, GL_INTERLEAVED_ATTRIBS);
        });
    });
    if (!otro)
        return {};
    p->modo = GL_POINTS, p->vertices = 1;
    std::sort(p->indices.begin(), p->indices.end()); // cada vértice, una vez
    p->indices.erase(std::unique(p->indices.begin(), p->indices.end()), p->indices.end());
    const std::size_t hay = p->indices.size(), caben = std::min(hay, VERTICES);
    for (std::size_t i = 0; i < caben; ++i) // de toda la orden
        p->indices[i] = p->indices[i * hay / caben];
    p->indices.resize(caben);
    const Sueltas s(*p);
    Puntos puntos(p->indices.size());
    GLuint bufer;
    const GLint antes = entero(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING);
    glGenBuffers(1, &bufer);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, bufer);
    const auto bytes = GLsizeiptr(puntos.size() * sizeof puntos[0]);
    glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, bytes, nullptr, GL_STREAM_READ);
    glEnable(GL_RASTERIZER_DISCARD);
    glUseProgram(otro);
    glBeginTransformFeedback(GL_POINTS);
    s.dibujaVertices(0, s.primitivas.cuantas());
    glEndTransformFeedback();
    glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, bytes, puntos.data());
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, GLuint(antes));
    glDeleteBuffers(1, &bufer);
    return puntos;
}

// Por qué nada de eso cae en la ventana.
std::pair<std::string, std::string> fueraDe(const Puntos &puntos) {
    const auto todos = [&](auto es) {
        return !puntos.empty() && std::all_of(puntos.begin(), puntos.end(), es);
    };
    using P = std::array<float, 4>;
    if (todos([](const P &p) { return !std::isfinite(p[0] + p[1] + p[2] + p[3]); }))
        return {"las posiciones de todos sus vértices son NaN o infinitas",
                "Mira las matrices y lo que se divide."};
    if (todos([](const P &p) { return p[0] == 0 && p[1] == 0 && p[2] == 0; }) ||
        todos([](const P &p) { return p[3] == 0; }))
        return {"gl_Position es 0 en todos sus vértices",
                "¿Se ha enviado cada matriz, y después de glUseProgram?"};
    if (todos([&](const P &p) { return p == puntos[0]; }))
        return {"todos sus vértices caen en el mismo punto",
                "Mira la matriz del modelo y el array de posiciones."};
    if (todos([](const P &p) { return p[3] < 0; }))
        return {"todos sus vértices están detrás de la cámara (w < 0)",
                "Mira la posición de la cámara y hacia dónde mira."};
    const char *const LADOS[3][2] = {{"a la izquierda", "a la derecha"},
                                     {"por debajo", "por encima"},
                                     {"más cerca que cerca", "más lejos que lejos"}};
    for (std::size_t eje = 0; eje < 3; ++eje)
        for (const int lado : {0, 1})
            if (todos([&](const P &p) { return lado ? p[eje] > p[3] : p[eje] < -p[3]; }))
                return {std::string("todos sus vértices quedan fuera, ") + LADOS[eje][lado],
                        eje == 2 ? "Mira los planos cerca y lejos de la proyección."
                                 : "Mira la cámara y la matriz del modelo."};
    return {"ninguna de sus primitivas cubre el centro de un píxel",
            "¿Son muy pequeñas, o están fuera de la ventana?"};
}

// Si los planos cerca o lejos quitan parte de lo que, si no, se vería.
std::pair<std::string, std::string> corteDe(const Puntos &puntos) {
    int cerca = 0, lejos = 0, dentro = 0;
    for (const auto &[x, y, z, w] : puntos)
        if (w > 0 && std::fabs(x) <= w && std::fabs(y) <= w)
            ++(z < -w ? cerca : z > w ? lejos : dentro);
    if (!dentro || cerca + lejos == 0)
        return {};
    const auto corta = [&](const char *plano, int cuantos) {
        return "el plano " + std::string(plano) + " la corta: quita " + std::to_string(cuantos) + " de los " +
               std::to_string(cerca + lejos + dentro) + " vértices que se verían";
    };
    return cerca ? std::pair(corta("cerca", cerca), std::string("Acerca ese plano a la cámara."))
                 : std::pair(corta("lejos", lejos), std::string("Aleja ese plano de la cámara."));
}

double largo(const double *v) {
    return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

// Si una matriz afín, que es la de un objeto o de una cámara, lo aplasta todo en un plano.
bool aplasta(const std::vector<double> &m) {
    if (m.size() != 16 || m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] == 0)
        return false;
    const double det = m[0] * (m[5] * m[10] - m[6] * m[9]) - m[4] * (m[1] * m[10] - m[2] * m[9]) +
                       m[8] * (m[1] * m[6] - m[2] * m[5]);
    return std::fabs(det) <= 1e-6 * largo(&m[0]) * largo(&m[4]) * largo(&m[8]);
}

bool casiCero(const std::vector<double> &v) {
    return std::all_of(v.begin(), v.end(), [](double x) { return x == 0; });
}

} // namespace

void Sospechas::pon(int gravedad, int orden, const std::string &dice, const std::string &prueba) {
    static const std::regex NUMERO("orden [0-9]+");
    const auto sin = [](const std::string &texto) { return std::regex_replace(texto, NUMERO, "orden"); };
    const auto igual = [&](const Sospecha &s) { return sin(s.dice) == sin(dice); };
    const auto otra = std::find_if(lista.begin(), lista.end(), igual);
    if (otra == lista.end()) // la misma en cada orden se dice una vez
        lista.push_back({gravedad, orden, dice, prueba});
    else
        otra->otras += otra->dice != dice;
}

void Sospechas::delCableado(const Cableado &c, const Orden &o, const Lienzo &l, int n) {
    const auto vale = [&](const Uniforme &u) { // sin que nadie se lo dé: lo dice el shader, o es la unidad 0
        const bool incompleta = std::any_of(c.texturas.begin(), c.texturas.end(), [&](const Textura &t) {
            return t.sampler == u.variable.nombre && !t.incompleta.empty();
        });
        return !casiCero(u.valor) || (esSampler(u.variable.tipo) && !incompleta);
    };
    for (const Uniforme &u : c.uniformes) {
        const std::string quien = "el uniform «" + u.variable.nombre + "» ";
        const bool matriz =
            u.valor.size() >= 4 && !esEntero(u.variable.tipo) && tipoDe(u.variable.tipo)[0] == 'm';
        if (std::any_of(u.valor.begin(), u.valor.end(), [](double x) { return !std::isfinite(x); }))
            pon(SEGURO, n, quien + "tiene algo que no es un número", "Mira de qué cuenta sale.");
        else if (!u.dado && !vale(u) && importa(o.hazla, l, u.variable.nombre))
            pon(SEGURO, n, quien + "lo usa el shader y nadie le ha dado valor: es 0",
                "Falta enviarlo, se llama de otra manera o se ha enviado sin glUseProgram antes.");
        else if (matriz && casiCero(u.valor))
            pon(SEGURO, n, quien + "es una matriz toda de ceros",
                "Debería ser al menos la identidad: glm::mat4(1).");
        else if (matriz && aplasta(u.valor))
            pon(SEGURO, n, quien + "es una matriz de determinante 0: todo queda en un plano",
                "¿Hay un factor de escala que es 0, o un eje repetido?");
    }
    for (const Textura &t : c.texturas)
        if (!t.incompleta.empty())
            pon(SEGURO, n,
                "la textura de «" + t.sampler + "», en la unidad " + std::to_string(t.unidad) +
                    ", está incompleta: " + t.incompleta,
                "De una textura incompleta se lee negro.");
    for (const Atributo &a : c.atributos) {
        const std::string quien = "el atributo «" + a.variable.nombre + "» ";
        if (!a.constante && (!a.activo || !a.bufer))
            pon(SEGURO, n, quien + "lo lee el shader y no lo da ningún array",
                "Falta glVertexAttribPointer o glEnableVertexAttribArray, con su VAO enlazado.");
        else if (a.primeros.size() > 2 &&
                 std::all_of(a.primeros.begin(), a.primeros.end(),
                             [](const auto &v) { return v == std::array<float, 4>{}; }))
            pon(a.variable.nombre == "vNormal" ? SEGURO : SI_NO_SE_VE_NADA, n,
                quien + "es 0 en todos los vértices",
                "Mira cómo se rellena el buffer, su paso y su desplazamiento.");
    }
}

// Las que el shader usa como unitarias sin que lo sean.
void Sospechas::deNormales(const Cableado &c, int n) {
    std::string texto;
    for (const Fuente &f : fuentesDe(GLuint(entero(GL_CURRENT_PROGRAM))))
        texto += f.texto;
    if (nombra(texto, "normalize") || nombra(texto, "inversesqrt") || nombra(texto, "length"))
        return;
    for (const Atributo &a : c.atributos) {
        if (a.variable.nombre.find("ormal") == std::string::npos || a.componentes != 3)
            continue;
        std::vector<double> m = {1, 0, 0, 0, 1, 0, 0, 0, 1};
        std::smatch por;
        if (std::regex_search(texto, por, std::regex("(\\w+)\\s*\\*\\s*" + a.variable.nombre + "\\b")))
            for (const Uniforme &u : c.uniformes)
                if (u.variable.nombre == por[1] && u.valor.size() == 9)
                    m = u.valor;
        for (const auto &v : a.primeros) {
            double N[3];
            for (std::size_t i = 0; i < 3; ++i)
                N[i] = m[i] * double(v[0]) + m[3 + i] * double(v[1]) + m[6 + i] * double(v[2]);
            const double mide = largo(N);
            if (mide == 0 || std::fabs(mide - 1) <= 0.01)
                continue;
            char cifras[24];
            std::snprintf(cifras, sizeof cifras, "%.3g", mide);
            return pon(SEGURO, n,
                       "las normales («" + a.variable.nombre + "») no son unitarias, miden " + cifras +
                           ", y el shader no las normaliza",
                       "Falta normalize en el shader, o las da así la matriz con que se transforman.");
        }
    }
}

void Sospechas::delEstado(const Orden &o, const Lienzo &l, int n) {
    GLint v[4];
    glGetIntegerv(GL_VIEWPORT, v);
    if (v[2] == 0 || v[3] == 0 || v[0] >= l.ancho || v[1] >= l.alto || v[0] + v[2] <= 0 || v[1] + v[3] <= 0)
        pon(SEGURO, n, "el viewport queda fuera o no mide nada",
            "Mira glViewport: ¿en la función de cambio de tamaño?");
    if (!o.vertices())
        pon(SEGURO, n, "se pide dibujar 0 vértices", "¿Está vacía la malla, o el número es de otra cosa?");
    if (!glIsEnabled(GL_DEPTH_TEST))
        return;
    if (!l.bitsProfundidad)
        pon(SEGURO, n, "el test de profundidad está puesto y el framebuffer no tiene profundidad",
            "Falta GLUT_DEPTH en glutInitDisplayMode, o el renderbuffer.");
    else if (std::find(conProfundidad.begin(), conProfundidad.end(), l.nombre) == conProfundidad.end())
        pon(SEGURO, n, "el test de profundidad está puesto y en este cuadro no se ha borrado la profundidad",
            "Falta GL_DEPTH_BUFFER_BIT en glClear, o glDepthMask(GL_TRUE) antes.");
    const GLint funcion = entero(GL_DEPTH_FUNC);
    if (funcion == GL_NEVER)
        pon(SEGURO, n, "glDepthFunc es GL_NEVER: no pasa nada", "Es GL_LESS si no se dice otra cosa.");
}

void Sospechas::antes(const Orden &o, const Lienzo &l, const Cableado &cableado, int n) {
    if (o.que == Orden::Que::Borra) {
        const bool entera = !glIsEnabled(GL_SCISSOR_TEST);
        if ((o.buferes & GL_DEPTH_BUFFER_BIT) && entero(GL_DEPTH_WRITEMASK))
            conProfundidad.push_back(l.nombre);
        if ((o.buferes & GL_COLOR_BUFFER_BIT) && l.nombre == 0 && entera)
            borradoElFinal = enVentana;
        return;
    }
    enVentana = enVentana || l.nombre == 0;
    if (l.nombre == 0)
        borradoElFinal = false;
    if (o.que == Orden::Que::Copia)
        return;
    hayDibujos = true;
    delCableado(cableado, o, l, n);
    deNormales(cableado, n);
    delEstado(o, l, n);
}

std::string Sospechas::porQueNada(const Orden &o, int n) {
    const GLuint programa = GLuint(entero(GL_CURRENT_PROGRAM));
    if (!programa) {
        pon(SEGURO, n, "se dibuja sin programa en uso", "Falta glUseProgram, o su programa no enlaza.");
        return "no hay programa en uso";
    }
    if (!o.vertices())
        return "no tiene vértices";
    if (!entero(GL_VERTEX_ARRAY_BINDING))
        return "no hay ningún VAO enlazado";
    std::pair<std::string, std::string> que;
    int gravedad = SI_NO_SE_VE_NADA;
    {
        const Guardado g;
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        glDepthMask(GL_FALSE);
        glStencilMask(0);
        const GLuint cobertura = sinDescartar(programa);
        const auto pasa = [&](GLuint con, bool cara, bool recorte, bool plantilla, bool profundidad) {
            glUseProgram(con);
            explica::pon(GL_CULL_FACE, cara && g.lleva(GL_CULL_FACE));
            explica::pon(GL_SCISSOR_TEST, recorte && g.lleva(GL_SCISSOR_TEST));
            explica::pon(GL_STENCIL_TEST, plantilla && g.lleva(GL_STENCIL_TEST));
            explica::pon(GL_DEPTH_TEST, profundidad && g.lleva(GL_DEPTH_TEST));
            return muestrasDe(o.hazla) != 0;
        };
        const GLuint libre = cobertura ? cobertura : programa;
        if (!pasa(libre, false, false, false, false)) {
            glUseProgram(programa);
            que = fueraDe(posicionesDe(o));
            gravedad =
                que.first.find("NaN") != que.first.npos || que.first.find("gl_Position") != que.first.npos
                    ? SEGURO
                    : gravedad;
        } else if (!pasa(libre, true, false, false, false)) {
            que = {"todas sus caras se quitan (" + nombreDe(GLenum(entero(GL_CULL_FACE_MODE))) + ")",
                   "Mira el sentido de sus vértices, glFrontFace y glCullFace."};
        } else if (!pasa(programa, true, false, false, false)) {
            que = {"el shader descarta todos sus fragmentos (discard)", "Mira de qué condición depende."};
        } else if (!pasa(programa, true, true, false, false)) {
            que = {"queda toda fuera del recorte (glScissor)",
                   "Mira glScissor, o falta glDisable(GL_SCISSOR_TEST)."};
        } else if (!pasa(programa, true, true, true, false)) {
            que = {"ningún fragmento pasa la plantilla",
                   "Mira glStencilFunc y qué se ha escrito antes en ella."};
        } else {
            que = {"ningún fragmento pasa el test de profundidad (" +
                       nombreDe(GLenum(entero(GL_DEPTH_FUNC))) + ")",
                   "Mira glDepthFunc, glClearDepth y si hay algo delante."};
        }
    }
    pon(gravedad, n, "la orden " + std::to_string(n) + " no dibuja nada: " + que.first, que.second);
    return que.first;
}

std::string Sospechas::despues(const Orden &o, const Lienzo &l, const Cableado &c, int n, long fragmentos) {
    // common/encima pinta los rótulos con este sampler
    const bool rotulo = std::any_of(c.texturas.begin(), c.texturas.end(),
                                    [](const Textura &t) { return t.sampler == "atlas"; });
    hayFigura = hayFigura || !rotulo;
    figuraEscrita = figuraEscrita || (!rotulo && fragmentos != 0);
    if (fragmentos == 0)
        return porQueNada(o, n);
    if (rotulo)
        return "";
    hayEscrito = true;
    const auto [corte, prueba] = corteDe(posicionesDe(o));
    if (!corte.empty())
        pon(SEGURO, n, "en la orden " + std::to_string(n) + ", " + corte, prueba);
    GLboolean m[4];
    glGetBooleanv(GL_COLOR_WRITEMASK, m);
    if (!m[0] && !m[1] && !m[2])
        pon(SI_NO_SE_VE_NADA, n, "glColorMask no deja escribir el color",
            "Falta glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE).");
    if (!glIsEnabled(GL_BLEND) || l.nombre)
        return "";
    const GLenum origen = GLenum(entero(GL_BLEND_SRC_RGB)), destino = GLenum(entero(GL_BLEND_DST_RGB));
    pon(origen == GL_ZERO && destino == GL_ONE ? SEGURO : SI_NO_SE_VE_NADA, n,
        "lo que se dibuja se mezcla con lo que hay (" + nombreFactor(origen) + ", " + nombreFactor(destino) +
            ") y no cambia nada",
        "Mira glBlendFunc y lo que vale su alfa, o falta glDisable(GL_BLEND).");
    return "";
}

std::vector<Json> Sospechas::todas(bool unColor) {
    const bool noSeVeNada = unColor || (hayFigura && !figuraEscrita);
    if (borradoElFinal)
        pon(SEGURO + 1, 0, "la ventana se borra después de dibujar en ella",
            "glClear va antes que lo demás.");
    if (!hayDibujos)
        pon(SI_NO_SE_VE_NADA, 0, "no se dibuja nada: no hay glDrawArrays ni glDrawElements",
            "¿Se llama a la función que dibuja?");
    else if (!enVentana)
        pon(SEGURO, 0, "todo se dibuja en otro framebuffer y nada en la ventana",
            "Falta glBindFramebuffer(GL_FRAMEBUFFER, 0).");
    if (unColor && hayEscrito)
        pon(0, 0, "se escriben fragmentos y todo queda del mismo color",
            "¿Es el del fondo el que da el shader? Mira el color y las luces.");
    std::stable_sort(lista.begin(), lista.end(),
                     [](const auto &a, const auto &b) { return a.gravedad > b.gravedad; });
    std::vector<Json> salen;
    for (const Sospecha &s : lista)
        if (noSeVeNada || s.gravedad >= SEGURO)
            salen.push_back(
                Json()
                    .pon("orden", s.orden)
                    .pon("dice",
                         s.dice + (s.otras ? "; otras " + std::to_string(s.otras) + ", por lo mismo" : ""))
                    .pon("prueba", s.prueba));
    return salen;
}

} // namespace explica
