#include "sospechas.h"
#include "arrays.h"
#include "enviado.h"
#include "nombres.h"
#include "sueltas.h"
#include <algorithm>
#include <cstring>
#include <regex>

namespace explica {
namespace {

const int SEGURO = 2, SI_NO_SE_VE_NADA = 1; // con la ventana lisa se dice todo
const int MUCHAS = 40;                      // órdenes: de las que siguen no se miran los colores

// Los colores que da el shader donde se ve lo que dibuja, fila a fila desde abajo.
std::vector<Pixel> coloresDe(const Orden &o, const Lienzo &l) {
    const Guardado g;
    abreAparte(l);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_STENCIL_TEST);
    glDepthMask(GL_TRUE);
    if (l.bitsProfundidad)
        deVerdad().borra(GL_DEPTH_BUFFER_BIT);
    else
        glDisable(GL_DEPTH_TEST);
    return coloresAparte(0, 0, l.ancho, l.alto, o.hazla);
}

// Si lo que dibuja depende de ese uniform.
bool importa(const Orden &o, Lienzo l, const Variable &uniform) {
    const GLuint original = GLuint(entero(GL_CURRENT_PROGRAM));
    l.bitsProfundidad = 0;
    const Guardado guardado;
    const GLuint otro = gemelo(original, "igual", [&] { return enlazaComo(original, shadersDe(original)); });
    if (!otro)
        return true;
    glDisable(GL_CULL_FACE);
    const std::vector<Pixel> antes = coloresDe(o, l);
    for (const Variable &v : uniformsDe(otro))
        if (v.nombre == uniform.nombre)
            daOtroValor(v);
    const std::vector<Pixel> despues = coloresDe(o, l);
    return std::memcmp(antes.data(), despues.data(), antes.size() * sizeof antes[0]) != 0;
}

std::string fuentesDelPrograma(GLenum tipo) {
    return fuenteDe(GLuint(entero(GL_CURRENT_PROGRAM)), tipo);
}

// Si lo lejano tiene menos profundidad, porque así se pide.
bool alReves() {
    const GLint funcion = entero(GL_DEPTH_FUNC);
    return funcion == GL_GREATER || funcion == GL_GEQUAL;
}

Dicho oSi(const Dicho &uno, const Dicho &otro) {
    return uno.first.empty() ? otro : uno;
}

std::vector<Matriz> matricesDe(const Cableado &c, bool tambienDe3 = false) {
    std::vector<Matriz> todas;
    for (const Uniforme &u : c.uniformes)
        if (u.variable.tipo == GL_FLOAT_MAT4 || (tambienDe3 && u.variable.tipo == GL_FLOAT_MAT3))
            todas.push_back({u.variable.nombre, u.valor});
    return todas;
}

const Atributo *atributoDe(const Cableado &c, const char *nombre) {
    for (const Atributo &a : c.atributos)
        if (a.variable.nombre.find(nombre) != std::string::npos && a.componentes == 3 && !a.primeros.empty())
            return &a;
    return nullptr;
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

// El ancho entre el alto de lo que se ve con una proyección perspectiva y nada más; de otra matriz, ninguno.
std::optional<double> aspectoDe(const std::vector<double> &m) {
    if (m.size() != 16 || m[11] != -1 || m[15] != 0 || m[1] != 0 || m[4] != 0 || !(m[0] * m[5] > 0))
        return {};
    return m[5] / m[0];
}

double largo(const std::array<float, 4> &v) {
    const double suyo[] = {double(v[0]), double(v[1]), double(v[2])};
    return largo(suyo);
}

bool casiCero(const std::vector<double> &v) {
    return std::all_of(v.begin(), v.end(), [](double x) { return x == 0; });
}

// Qué tiene de raro una matriz con que se dibuja, y qué probar.
std::optional<std::pair<std::string, std::string>> loRaro(const std::vector<double> &m, const Lienzo &l) {
    if (casiCero(m))
        return {{"es una matriz toda de ceros", "Debería ser al menos la identidad: glm::mat4(1)."}};
    if (aplasta(m))
        return {{"es una matriz de determinante 0: lo que dibuja queda en un plano",
                 "Si no es lo que se quiere, ¿hay un factor de escala que es 0, o un eje repetido?"}};
    const auto viewport = cuatro(GL_VIEWPORT);
    const double aspecto = double(l.ancho) / l.alto;
    const std::optional<double> suyo = aspectoDe(m);
    if (!suyo || viewport[2] != l.ancho || viewport[3] != l.alto || std::fabs(*suyo / aspecto - 1) <= 0.05)
        return {};
    return {{"es una proyección de aspecto " + cifras(*suyo, 3) + " y la ventana mide " + cifras(aspecto, 3) +
                 " de ancho por cada uno de alto: lo que se ve sale deformado",
             "El aspecto es ancho / alto, en reales: entre enteros, 4 / 3 es 1."}};
}

// Sin escribir nada ni mirar la profundidad. Hay que tener un Guardado.
bool pasaAlguno(const Orden &o) {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthMask(GL_FALSE);
    glStencilMask(0);
    glDisable(GL_DEPTH_TEST);
    return muestrasDe(o.hazla) != 0;
}

// Si las normales apuntan hacia fuera de los vértices de que son.
bool haciaFuera(const Cableado &c) {
    const Atributo *const normales = atributoDe(c, "ormal"), *const posiciones = atributoDe(c, "osi");
    if (!normales || !posiciones)
        return false;
    std::array<double, 3> centro{};
    double suma = 0;
    for (const auto &p : posiciones->primeros)
        for (std::size_t i = 0; i < 3; ++i)
            centro[i] += double(p[i]) / double(posiciones->primeros.size());
    for (std::size_t k = 0; k < std::min(normales->primeros.size(), posiciones->primeros.size()); ++k)
        for (std::size_t i = 0; i < 3; ++i)
            suma += double(normales->primeros[k][i]) * (double(posiciones->primeros[k][i]) - centro[i]);
    return suma > 0;
}

// Con qué factores se mezcla lo que casi nunca se quiere. De las otras parejas raras, alguna sirve para algo.
Dicho deMezcla(GLenum origen, GLenum destino) {
    const std::string pareja = "la mezcla (" + nombreFactor(origen) + ", " + nombreFactor(destino) + ") ";
    const char *const prueba =
        "Lo usual es glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA): alfa y lo que le falta para 1.";
    if (origen == GL_ONE_MINUS_SRC_ALPHA)
        return {pareja + "está al revés: cuanto mayor es el alfa de lo que se dibuja, menos se ve", prueba};
    const std::string pesa = destino == GL_SRC_ALPHA             ? "el mismo alfa"
                             : destino == GL_DST_ALPHA           ? "el de la ventana"
                             : destino == GL_ONE_MINUS_DST_ALPHA ? "1 menos el de la ventana"
                                                                 : "";
    if (origen != GL_SRC_ALPHA || pesa.empty())
        return {};
    return {pareja + "no reparte: de lo que se dibuja queda su alfa, y de lo que había, " + pesa, prueba};
}

} // namespace

void Sospechas::pon(int gravedad, int orden, const std::string &dice, const std::string &prueba,
                    const LineaDeShader &linea) {
    static const std::regex NUMERO("orden [0-9]+|[0-9]+ de sus [0-9]+|hasta [0-9]+");
    const auto sin = [](const std::string &texto) { return std::regex_replace(texto, NUMERO, "orden"); };
    const auto igual = [&](const Sospecha &s) { return sin(s.dice) == sin(dice); };
    const auto otra = std::find_if(lista.begin(), lista.end(), igual);
    if (otra == lista.end()) // la misma en cada orden se dice una vez
        lista.push_back({gravedad, orden, dice, prueba, linea});
    else
        otra->otras += otra->dice != dice;
}

void Sospechas::delCableado(const Cableado &c, const Orden &o, const Lienzo &l, int n) {
    const auto vale = [&](const Uniforme &u) { // sin que nadie se lo dé: lo dice el shader, o es la unidad 0
        return !casiCero(u.valor) || esSampler(u.variable.tipo);
    };
    // de una struct o de un array están todas las partes, y hay enlazadores que dejan lo que no sirve para nada
    const auto esParte = [](const Uniforme &u) {
        return EN_WEB || u.variable.nombre.find_first_of(".[") != std::string::npos;
    };
    for (const Uniforme &u : c.uniformes) {
        const std::string quien = "el uniform «" + u.variable.nombre + "» ";
        const bool matriz =
            u.valor.size() >= 4 && !esEntero(u.variable.tipo) && tipoDe(u.variable.tipo)[0] == 'm';
        if (std::any_of(u.valor.begin(), u.valor.end(), [](double x) { return !std::isfinite(x); }))
            pon(SEGURO, n, quien + "tiene algo que no es un número", "Mira de qué cuenta sale.");
        else if (!u.malDado.empty())
            pon(SEGURO, n,
                "al " + quien.substr(3) + "se le da valor con " + u.malDado + " y es un " +
                    tipoDe(u.variable.tipo),
                esSampler(u.variable.tipo) ? "A un sampler se le da el número de su unidad, con glUniform1i."
                                           : "La función es la de su tipo: glUniform3f para un vec3…");
        else if (!u.dado && !vale(u) && (!esParte(u) || importa(o, l, u.variable)))
            pon(esEntero(u.variable.tipo) ? SI_NO_SE_VE_NADA : SEGURO, n,
                quien + "lo usa el shader y nadie le ha dado valor: es 0",
                "Falta enviarlo, se llama de otra manera o se ha enviado sin glUseProgram antes.");
        else if (const auto raro = matriz && (u.dado || vale(u)) ? loRaro(u.valor, l) : std::nullopt)
            pon(SEGURO, n, "en la orden " + std::to_string(n) + ", " + quien + raro->first, raro->second);
    }
    for (const Textura &t : c.texturas)
        if (!t.incompleta.empty())
            pon(SEGURO, n,
                "la textura de «" + t.sampler + "», en la unidad " + std::to_string(t.unidad) +
                    ", está incompleta: " + t.incompleta,
                t.nombre
                    ? "De una textura incompleta se lee negro."
                    : "Mira glActiveTexture, glBindTexture y lo que se envía al sampler con glUniform1i.");
    for (const Atributo &a : c.atributos) {
        const std::string quien = "el atributo «" + a.variable.nombre + "» ";
        if (!a.constante && (!a.activo || !a.bufer))
            pon(SEGURO, n, quien + "lo lee el shader y no lo da ningún array",
                "Falta glVertexAttribPointer o glEnableVertexAttribArray, con su VAO enlazado.");
        else if (a.primeros.size() > 2 &&
                 (!c.texturas.empty() || a.variable.nombre.find("oord") == std::string::npos) &&
                 std::all_of(a.primeros.begin(), a.primeros.end(),
                             [](const auto &v) { return v == std::array<float, 4>{}; }))
            pon(a.variable.nombre == "vNormal" ? SEGURO : SI_NO_SE_VE_NADA, n,
                quien + "es 0 en todos los vértices",
                "Mira cómo se rellena el buffer, su paso y su desplazamiento.");
    }
}

// Las que el shader usa como unitarias sin que lo sean.
void Sospechas::deNormales(const Cableado &c, int n) {
    const std::string texto = fuentesDelPrograma(GL_VERTEX_SHADER) + fuentesDelPrograma(GL_FRAGMENT_SHADER);
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
            return pon(SEGURO, n,
                       "las normales («" + a.variable.nombre + "») no son unitarias, miden " +
                           cifras(mide, 3) + ", y el shader no las normaliza",
                       "Falta normalize en el shader, o las da así la matriz con que se transforman.");
        }
    }
}

void Sospechas::delEstado(const Orden &o, const Lienzo &l, int n) {
    if (glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        return pon(
            SEGURO, n, "el framebuffer " + std::to_string(l.nombre) + ", en que se dibuja, no está completo",
            "Le falta una textura o un renderbuffer, o no son de la misma talla: glCheckFramebufferStatus.");
    const auto v = cuatro(GL_VIEWPORT);
    if (v[2] == 0 || v[3] == 0 || v[0] >= l.ancho || v[1] >= l.alto || v[0] + v[2] <= 0 || v[1] + v[3] <= 0)
        pon(SEGURO, n, "el viewport queda fuera o no mide nada",
            "Mira glViewport: ¿en la función de cambio de tamaño?");
    if (!o.vertices())
        pon(SEGURO, n, "se pide dibujar 0 vértices", "¿Está vacía la malla, o el número es de otra cosa?");
    if (!entero(GL_VERTEX_ARRAY_BINDING))
        pon(SEGURO, n, "se dibuja sin ningún VAO enlazado",
            "Falta glBindVertexArray, o alguien ha enlazado el 0.");
    if (l.nombre == 0 && l.buferColor == GL_NONE)
        pon(SEGURO, n, "glDrawBuffer es GL_NONE: en la ventana no se escribe ningún color",
            "Falta glDrawBuffer(GL_BACK), que es lo que hay si no se dice nada.");
    if (!EN_WEB && entero(GL_POLYGON_MODE) == GL_POINT && o.modo >= GL_TRIANGLES)
        pon(SEGURO, n, "glPolygonMode es GL_POINT: de cada triángulo solo se ven sus vértices",
            "Falta glPolygonMode(GL_FRONT_AND_BACK, GL_FILL).");
    if (!EN_WEB && glIsEnabled(GL_FRAMEBUFFER_SRGB) &&
        std::regex_search(fuentesDelPrograma(GL_FRAGMENT_SHADER),
                          std::regex("pow\\s*\\([^;]*(2\\.2|0\\.45)")))
        pon(SEGURO, n, "los colores pasan a sRGB dos veces: con GL_FRAMEBUFFER_SRGB y con pow en el shader",
            "Basta con una: quita la otra.");
    if (!glIsEnabled(GL_DEPTH_TEST))
        return;
    conTest = conTest || l.nombre == 0;
    apuntaProfundidad |= l.nombre == 0 && (entero(GL_DEPTH_WRITEMASK) || glIsEnabled(GL_BLEND));
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

void Sospechas::pon(int gravedad, int orden, const Dicho &dicho) {
    if (!dicho.first.empty())
        pon(gravedad, orden, dicho.first, dicho.second);
}

// Lo que se ve en el texto de los dos shaders, con su línea.
void Sospechas::deShaders(int n) {
    if (!leidos.insert(entero(GL_CURRENT_PROGRAM)).second)
        return;
    for (const auto &[etapa, tipo] : {std::pair("vert", GL_VERTEX_SHADER), {"frag", GL_FRAGMENT_SHADER}})
        for (const Division &d : divisionesEnteras(fuentesDelPrograma(GLenum(tipo)))) {
            const std::string a = std::to_string(d.dividendo), b = std::to_string(d.divisor);
            pon(SEGURO, n, a + " / " + b + " es una división entera y vale 0",
                "Entre enteros se pierde el resto: escribe " + a + ".0 / " + b + ".0.", {etapa, d.linea});
        }
}

void Sospechas::apuntaIndices(const Orden &o) {
    Indices &i = indices[entero(GL_ELEMENT_ARRAY_BUFFER_BINDING)];
    i.hay = contesta(glGetBufferParameteriv, GL_ELEMENT_ARRAY_BUFFER, GL_BUFFER_SIZE);
    i.cadaUno = std::intptr_t(bytesDe(o.tipoIndice));
    for (const Tramo &t : o.tramos)
        i.hasta = std::max(i.hasta, reinterpret_cast<std::intptr_t>(t.indices) + i.cadaUno * t.vertices);
}

void Sospechas::deMatrices(const Cableado &c, const Lienzo &l, int n) {
    const std::vector<Matriz> todas = matricesDe(c);
    const std::string texto = fuentesDelPrograma(GL_VERTEX_SHADER);
    const Productos productos = todas.empty() ? Productos() : productosDe(texto);
    for (const Matriz &m : todas) {
        enPerspectiva = enPerspectiva || (l.nombre == 0 && m.valor[11] == -1);
        pon(SEGURO, n, deMatriz(m, todas, productos, alReves()));
    }
    const Atributo *const posiciones = atributoDe(c, "osi"), *const normales = atributoDe(c, "ormal");
    if (posiciones && normales)
        pon(SEGURO, n,
            deIluminacion({texto, fuentesDelPrograma(GL_FRAGMENT_SHADER), posiciones->variable.nombre,
                           normales->variable.nombre},
                          productos, matricesDe(c, true)));
    for (const Uniforme &u : c.uniformes)
        if (u.variable.tipo == GL_FLOAT && std::fabs(u.valor[0]) > 6.3 &&
            u.valor[0] == std::floor(u.valor[0]) &&
            std::regex_search(texto + fuentesDelPrograma(GL_FRAGMENT_SHADER),
                              std::regex("\\b(sin|cos|tan)\\s*\\(\\s*" + u.variable.nombre + "\\s*\\)")))
            pon(SEGURO, n,
                "«" + u.variable.nombre +
                    "» parece un ángulo en grados, y el shader le calcula el seno o el coseno",
                "sin y cos quieren radianes: radians(" + u.variable.nombre +
                    ") en el shader, o glm::radians.");
}

// Si no se ven las caras que tiene delante, o está alrededor de la cámara.
void Sospechas::deMalla(const Cableado &c, const Orden &o, const Lienzo &l, const Malla &m, int n) {
    if (m.triangulos.empty() || l.buferColor == GL_NONE)
        return;
    const Solido s = solidoDe(m.puntos, m.triangulos, alReves());
    const bool quita = glIsEnabled(GL_CULL_FACE);
    const GLenum cual = quita ? GLenum(entero(GL_CULL_FACE_MODE)) : GL_NONE;
    const GLenum deFuera = s.antihorario == (entero(GL_FRONT_FACE) == GL_CCW) ? GL_FRONT : GL_BACK;
    if (s.rodea && cual != deFuera && entero(GL_DEPTH_WRITEMASK) && haciaFuera(c))
        pon(SEGURO, n,
            oSi(conCero(productosDe(fuentesDelPrograma(GL_VERTEX_SHADER)), matricesDe(c)),
                {"la cámara está dentro de lo que se dibuja en la orden " + std::to_string(n),
                 "Aléjala, o mira el orden de sus transformaciones."}));
    const std::string malla = std::to_string(entero(GL_VERTEX_ARRAY_BINDING)) + o.llamada;
    quitadas[malla].insert(cual);
    if (s.cerrado && !s.rodea && cual == deFuera)
        sinLoDeFrente.push_back({n, malla});
}

// Si el shader da NaN, todo negro o mucho más de lo que se puede ver.
void Sospechas::deColores(const Cableado &c, const Orden &o, const Lienzo &l, int n) {
    const std::vector<Pixel> colores = coloresDe(o, l);
    long hay = 0, raros = 0, negros = 0, pasados = 0, traslucidos = 0;
    std::string donde;
    float mayor = 0;
    for (std::size_t i = colores.size(); i-- > 0;) { // desde arriba
        const Pixel &p = colores[i];
        if (p == NINGUNO)
            continue;
        ++hay;
        const float suma = p[0] + p[1] + p[2], suyo = std::max({p[0], p[1], p[2]});
        negros += suma == 0;
        pasados += suyo > 8;
        traslucidos += p[3] < 1 && p[3] != 0.5f; // con ½ las dos partes son iguales
        if (suma == suma)
            mayor = std::max(mayor, suyo);
        else if (!raros++)
            donde = std::to_string(int(i) % l.ancho) + " " + std::to_string(l.alto - 1 - int(i) / l.ancho);
    }
    const std::string orden = "en la orden " + std::to_string(n) + " el shader da ";
    const auto de = [&](long cuantos) {
        return " en " + std::to_string(cuantos) + " de sus " + std::to_string(hay) + " píxeles";
    };
    if (raros)
        pon(SEGURO, n, orden + "algo que no es un número (NaN)" + de(raros),
            "Pide el píxel " + donde +
                " y se dirá la línea: normalize de un vector nulo, pow de un negativo, 0 / 0…");
    if (pasados > hay / 2) {
        std::string cual;
        for (const Uniforme &u : c.uniformes)
            if (u.valor.size() <= 4 && !esEntero(u.variable.tipo) && u.valor.size() > 2 &&
                *std::max_element(u.valor.begin(), u.valor.end()) > 8 && cual.empty())
                cual = " ¿Es por «" + u.variable.nombre + "»?";
        pon(SEGURO, n,
            orden + "colores de hasta " + std::to_string(long(mayor)) + de(pasados) + ", y van de 0 a 1",
            "Lo que pasa de 1 se queda en 1. Si vienen de 0 a 255, divídelos por 255." + cual);
    }
    if (traslucidos && glIsEnabled(GL_BLEND) && entero(GL_BLEND_EQUATION_RGB) == GL_FUNC_ADD)
        pon(SEGURO, n, deMezcla(GLenum(entero(GL_BLEND_SRC_RGB)), GLenum(entero(GL_BLEND_DST_RGB))));
    if (hay && negros == hay)
        for (const Uniforme &u : c.uniformes)
            if (u.valor.size() >= 3 && u.valor.size() <= 4 && u.dado &&
                casiCero({u.valor.begin(), u.valor.begin() + 3}) && atributoDe(c, "ormal") &&
                !esEntero(u.variable.tipo))
                pon(std::regex_search(u.variable.nombre, std::regex("L[ads]?$|[Ll]u[zc]|[Ll]ight"))
                        ? SEGURO
                        : SI_NO_SE_VE_NADA,
                    n, orden + "negro en todos sus píxeles, y «" + u.variable.nombre + "» es 0",
                    "¿Está apagada la luz?");
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
    delEstado(o, l, n);
    if (!entero(GL_CURRENT_PROGRAM) || !entero(GL_VERTEX_ARRAY_BINDING))
        return;
    const std::optional<Primitivas> primitivas = primitivasDe(o);
    for (const Dicho &d : deArrays(cableado, o, primitivas ? primitivas->indices : std::vector<GLuint>()))
        pon(SEGURO, n, d);
    const Atributo *const normales = atributoDe(cableado, "ormal");
    const Atributo *const posiciones = atributoDe(cableado, "osi");
    const auto unitarios = [](const auto &v) { return std::fabs(largo(v) - 1) < 1e-3; };
    if (normales && posiciones &&
        std::none_of(normales->primeros.begin(), normales->primeros.end(), unitarios) &&
        std::all_of(posiciones->primeros.begin(), posiciones->primeros.end(), unitarios))
        pon(SEGURO, n,
            "«" + posiciones->variable.nombre + "» y «" + normales->variable.nombre +
                "» parecen cambiados: miden 1 las posiciones y no las normales",
            "Mira el índice y el desplazamiento de cada glVertexAttribPointer.");
    if (o.tipoIndice != GL_NONE && entero(GL_ELEMENT_ARRAY_BUFFER_BINDING))
        apuntaIndices(o);
    deShaders(n);
    deMatrices(cableado, l, n);
    delCableado(cableado, o, l, n);
    deNormales(cableado, n);
    const Guardado g;
    pasaPlantilla = !glIsEnabled(GL_STENCIL_TEST) || pasaAlguno(o); // después, quizá la ha cambiado
}

std::string Sospechas::porQueNada(const Orden &o, const Cableado &c, int n) {
    const GLuint programa = GLuint(entero(GL_CURRENT_PROGRAM));
    if (!programa) {
        pon(SEGURO, n, "se dibuja sin programa en uso", "Falta glUseProgram, o su programa no enlaza.");
        return "no hay programa en uso";
    }
    if (!o.vertices())
        return "no tiene vértices";
    if (!entero(GL_VERTEX_ARRAY_BINDING))
        return "no hay ningún VAO enlazado";
    if (o.tipoIndice != GL_NONE && !entero(GL_ELEMENT_ARRAY_BUFFER_BINDING))
        return "no hay buffer de índices";
    Dicho que;
    {
        const Guardado g;
        const GLuint libre = sinDescartar(programa);
        const auto pasa = [&](GLuint con, bool cara, bool recorte) {
            glUseProgram(con);
            explica::pon(GL_CULL_FACE, cara && g.lleva(GL_CULL_FACE));
            explica::pon(GL_SCISSOR_TEST, recorte && g.lleva(GL_SCISSOR_TEST));
            glDisable(GL_STENCIL_TEST);
            return pasaAlguno(o);
        };
        if (!pasa(libre, false, false)) {
            glUseProgram(programa);
            que = fueraDe(posicionesDe(o).puntos);
            que = oSi(conCero(productosDe(fuentesDelPrograma(GL_VERTEX_SHADER)), matricesDe(c)), que);
        } else if (!pasa(libre, true, false)) {
            que = {"todas sus caras se quitan (" + nombreDe(GLenum(entero(GL_CULL_FACE_MODE))) + ")",
                   "Mira el sentido de sus vértices, glFrontFace y glCullFace."};
        } else if (!pasa(programa, true, false)) {
            que = {"el shader descarta todos sus fragmentos (discard)", "Mira de qué condición depende."};
        } else if (!pasa(programa, true, true)) {
            que = {"queda toda fuera del recorte (glScissor)",
                   "Mira glScissor, o falta glDisable(GL_SCISSOR_TEST)."};
        } else if (!pasaPlantilla) {
            que = {"ningún fragmento pasa la plantilla",
                   "Mira glStencilFunc y qué se ha escrito antes en ella."};
        } else {
            que = {"ningún fragmento pasa el test de profundidad (" +
                       nombreDe(GLenum(entero(GL_DEPTH_FUNC))) + ")",
                   "Mira glDepthFunc, glClearDepth y si hay algo delante."};
        }
    }
    const bool seguro = std::regex_search(que.first, std::regex("NaN|gl_Position"));
    pon(seguro ? SEGURO : SI_NO_SE_VE_NADA, n,
        "la orden " + std::to_string(n) + " no dibuja nada: " + que.first, que.second);
    return que.first;
}

std::string Sospechas::despues(const Orden &o, const Lienzo &l, const Cableado &c, int n, long fragmentos) {
    // common/encima pinta los rótulos con este sampler
    const bool rotulo = std::any_of(c.texturas.begin(), c.texturas.end(),
                                    [](const Textura &t) { return t.sampler == "atlas"; });
    const bool puede = !rotulo && entero(GL_CURRENT_PROGRAM) && entero(GL_VERTEX_ARRAY_BINDING);
    const Malla malla = puede ? posicionesDe(o) : Malla();
    deMalla(c, o, l, malla, n);
    hayFigura = hayFigura || !rotulo;
    figuraEscrita = figuraEscrita || (!rotulo && fragmentos != 0);
    if (fragmentos == 0)
        return porQueNada(o, c, n);
    if (rotulo)
        return "";
    hayEscrito = true;
    if (l.nombre == 0 && l.buferColor != GL_NONE && n <= MUCHAS &&
        (EN_WEB || fragmentos > 0)) // -1: hay otra consulta
        deColores(c, o, l, n);
    const auto [corte, prueba] = corteDe(malla.puntos);
    if (!corte.empty())
        pon(SEGURO, n, "en la orden " + std::to_string(n) + ", " + corte, prueba);
    const auto m = mascaraDeColor();
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
    for (const DeFrente &d : sinLoDeFrente)
        if (quitadas[d.malla].size() == 1) // si no, cada cara se dibuja por su lado
            pon(SEGURO, d.orden,
                "en la orden " + std::to_string(d.orden) +
                    " se quitan las caras de delante y se ve por dentro",
                "Están al revés el sentido de los vértices, glFrontFace o glCullFace.");
    for (const auto &[bufer, i] : indices)
        if (i.hasta > 0 && i.hasta < i.hay && (3 * i.hasta == i.hay || i.hasta == 3 * i.cadaUno))
            pon(SEGURO, 0,
                "solo se dibujan " + std::to_string(i.hasta / i.cadaUno) + " de los " +
                    std::to_string(i.hay / i.cadaUno) + " índices del buffer " + std::to_string(bufer),
                "glDrawElements quiere el número de índices, no el de triángulos ni el de vértices de cada "
                "uno.");
    const bool borraProfundidad = std::count(conProfundidad.begin(), conProfundidad.end(), 0u);
    if (borraProfundidad && enPerspectiva && enVentana && !conTest)
        pon(SEGURO, 0, "se borra la profundidad y ninguna orden la mira: GL_DEPTH_TEST no está puesto",
            "Falta glEnable(GL_DEPTH_TEST): lo último que se dibuja tapa a lo demás.");
    if (borraProfundidad && conTest && !apuntaProfundidad)
        pon(SEGURO, 0, "glDepthMask es GL_FALSE en todas las órdenes: ninguna apunta su profundidad",
            "Falta glDepthMask(GL_TRUE): lo último que se dibuja tapa a lo demás.");
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
                {{"orden", s.orden},
                 {"dice", s.dice + (s.otras ? "; otras " + std::to_string(s.otras) + ", por lo mismo" : "")},
                 {"prueba", s.prueba},
                 {"etapa", s.linea.etapa},
                 {"linea", s.linea.linea}});
    return salen;
}

} // namespace explica
