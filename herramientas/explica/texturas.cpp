#include "texturas.h"
#include "nombres.h"
#include "programas.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <tuple>

namespace explica {
namespace {

const double IGUAL = 1.1 / 255,
             CONTRASTE = 1.0 / 128; // lo que se puede apartar: los pesos pueden ser de 8 bits

GLint parametro(GLenum cual) {
    return contesta(glGetTexParameteriv, GL_TEXTURE_2D, cual);
}
GLint delNivel(GLint nivel, GLenum cual) {
    return contesta(glGetTexLevelParameteriv, GL_TEXTURE_2D, nivel, cual);
}

bool esAnisotropa() {
    static const bool hay = [] {
        for (GLint i = 0; i < entero(GL_NUM_EXTENSIONS); ++i)
            if (!std::strcmp(reinterpret_cast<const char *>(glGetStringi(GL_EXTENSIONS, GLuint(i))),
                             "GL_EXT_texture_filter_anisotropic"))
                return true;
        return false;
    }();
    return hay && parametro(GL_TEXTURE_MAX_ANISOTROPY_EXT) > 1;
}

using Valor = std::array<double, 4>;

// Los texels de la textura enlazada, que se leen de un framebuffer.
class Texels {
    GLuint textura, marco = 0;
    bool profundidad;
    std::map<std::tuple<int, int, int>, Valor> leidos;

public:
    Texels()
        : textura(GLuint(entero(GL_TEXTURE_BINDING_2D))),
          profundidad(delNivel(0, GL_TEXTURE_DEPTH_SIZE) > 0) {
        glGenFramebuffers(1, &marco);
    }
    ~Texels() {
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glDeleteFramebuffers(1, &marco);
    }
    Texels(const Texels &) = delete;
    Texels &operator=(const Texels &) = delete;

    // Nada, si no se puede.
    std::optional<Valor> operator()(int nivel, int x, int y) {
        const auto [suyo, nuevo] = leidos.insert({{nivel, x, y}, {0, 0, 0, 1}});
        if (!nuevo)
            return suyo->second;
        const GLenum adjunto = profundidad ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0;
        glBindFramebuffer(GL_FRAMEBUFFER, marco);
        glFramebufferTexture2D(GL_FRAMEBUFFER, adjunto, GL_TEXTURE_2D, textura, nivel);
        glDrawBuffer(GL_NONE);
        glReadBuffer(profundidad ? GL_NONE : GL_COLOR_ATTACHMENT0);
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            return {};
        GLfloat leido[4] = {0, 0, 0, 1};
        GLint codifica = 0;
        glReadPixels(x, y, 1, 1, profundidad ? GL_DEPTH_COMPONENT : GL_RGBA, GL_FLOAT, leido);
        if (!profundidad)
            glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, adjunto,
                                                  GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING, &codifica);
        for (std::size_t c = 0; c < 4; ++c) {
            const double v = double(leido[c]);
            const bool curva = codifica == GL_SRGB && c < 3;
            suyo->second[c] = !curva ? v : v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
        }
        return suyo->second;
    }
};

// De qué niveles se lee, con lo que pesa cada uno, y con qué filtro.
struct Mezcla {
    double lambda;
    GLint filtro;
    std::vector<std::pair<int, double>> niveles;
};

// Con un píxel que abarca rho texels. `aprisa`: con los dos niveles solo cerca de donde pesan lo mismo, como Mesa.
Mezcla mezclaDe(double rho, double mas, bool aprisa) {
    const GLint reduce = parametro(GL_TEXTURE_MIN_FILTER), amplia = parametro(GL_TEXTURE_MAG_FILTER);
    const int base = parametro(GL_TEXTURE_BASE_LEVEL), tope = parametro(GL_TEXTURE_MAX_LEVEL);
    int ultimo = base;
    for (int talla = std::max(delNivel(base, GL_TEXTURE_WIDTH), delNivel(base, GL_TEXTURE_HEIGHT)); talla > 1;
         talla /= 2)
        ultimo = std::min(ultimo + 1, tope);
    const double lambda = std::clamp(std::log2(rho) + mas, double(parametro(GL_TEXTURE_MIN_LOD)),
                                     double(parametro(GL_TEXTURE_MAX_LOD)));
    const bool deCerca = reduce == GL_NEAREST_MIPMAP_NEAREST || reduce == GL_NEAREST_MIPMAP_LINEAR;
    if (!(lambda > (amplia == GL_LINEAR && deCerca ? 0.5 : 0)))
        return {lambda, amplia, {{base, 1}}};
    if (reduce == GL_NEAREST || reduce == GL_LINEAR)
        return {lambda, reduce, {{base, 1}}};
    if (reduce == GL_NEAREST_MIPMAP_NEAREST || reduce == GL_LINEAR_MIPMAP_NEAREST)
        return {lambda, reduce, {{std::min(base + int(std::ceil(lambda + 0.5)) - 1, ultimo), 1}}};
    int nivel = int(std::floor(lambda));
    double segundo = lambda - nivel;
    if (aprisa) { // lp_build_brilinear_rho
        const double suyo = std::exp2(lambda) * 3.5 / (2 * std::sqrt(2.0));
        nivel = int(std::floor(std::log2(suyo)));
        segundo = std::max(2 * suyo / std::exp2(nivel) - 3, 0.0);
    }
    if (base + nivel >= ultimo)
        return {lambda, reduce, {{ultimo, 1}}};
    return {lambda, reduce, {{base + nivel, 1 - segundo}, {base + nivel + 1, segundo}}};
}

// El texel que hay donde dice, con la textura repetida; -1, ninguno.
int repetido(GLint como, int i, int cuantos) {
    const auto modulo = [](int a, int n) { return (a % n + n) % n; };
    if (como == GL_REPEAT)
        return modulo(i, cuantos);
    if (como == GL_MIRRORED_REPEAT)
        return std::min(modulo(i, 2 * cuantos), 2 * cuantos - 1 - modulo(i, 2 * cuantos));
    return como == GL_CLAMP_TO_BORDER && (i < 0 || i >= cuantos) ? -1 : std::clamp(i, 0, cuantos - 1);
}

struct Texel {
    int nivel, x, y;
    double peso;
    Valor color;
};

struct Suma {
    Mezcla mezcla;
    std::vector<Texel> texels;
    Valor suma{};
    double error = 0; // lo que se aparta de lo leído

    bool cuadra() const {
        double contraste = 0; // lo que va de un texel a otro
        for (const Texel &uno : texels)
            for (const Texel &otro : texels)
                for (std::size_t c = 0; c < 4; ++c)
                    contraste = std::max(contraste, uno.color[c] - otro.color[c]);
        return error <= IGUAL + CONTRASTE * contraste;
    }
};

std::optional<Suma> sumaDe(const Mezcla &m, const Lectura &l, Texels &texels) {
    Suma s{m, {}};
    const bool lineal =
        m.filtro == GL_LINEAR || m.filtro == GL_LINEAR_MIPMAP_NEAREST || m.filtro == GL_LINEAR_MIPMAP_LINEAR;
    const GLint repite[] = {parametro(GL_TEXTURE_WRAP_S), parametro(GL_TEXTURE_WRAP_T)};
    GLfloat borde[4];
    glGetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, borde);
    for (const auto &[nivel, deNivel] : m.niveles) {
        const int talla[] = {delNivel(nivel, GL_TEXTURE_WIDTH), delNivel(nivel, GL_TEXTURE_HEIGHT)};
        int primero[2];
        double resto[2];
        for (std::size_t k = 0; k < 2; ++k) {
            const double u = l.coordenadas[k] * talla[k] - (lineal ? 0.5 : 0);
            primero[k] = int(std::floor(u)), resto[k] = lineal ? u - primero[k] : 0;
        }
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i) {
                const double peso = deNivel * (i ? resto[0] : 1 - resto[0]) * (j ? resto[1] : 1 - resto[1]);
                if (peso <= 0)
                    continue;
                const int x = repetido(repite[0], primero[0] + i, talla[0]),
                          y = repetido(repite[1], primero[1] + j, talla[1]);
                const bool fuera = x < 0 || y < 0;
                const std::optional<Valor> color =
                    fuera ? Valor{borde[0], borde[1], borde[2], borde[3]} : texels(nivel, x, y);
                if (!color)
                    return {};
                s.texels.push_back({nivel, x, y, peso, *color});
                for (std::size_t c = 0; c < 4; ++c)
                    s.suma[c] += peso * (*color)[c];
            }
    }
    for (std::size_t c = 0; c < 4; ++c)
        s.error = std::max(s.error, std::fabs(s.suma[c] - l.valor[c]) / std::max(1.0, std::fabs(l.valor[c])));
    return s;
}

// La que mejor da lo leído, de las que deja OpenGL: con cuántos texels abarca un píxel de verdad o aprisa.
std::optional<Suma> laMejor(const Lectura &l) {
    Texels texels;
    const double ancho = delNivel(0, GL_TEXTURE_WIDTH), alto = delNivel(0, GL_TEXTURE_HEIGHT);
    const double ux = l.derivadas[0] * ancho, vx = l.derivadas[1] * alto, uy = l.derivadas[2] * ancho,
                 vy = l.derivadas[3] * alto;
    const double exacta = std::max(std::hypot(ux, vx), std::hypot(uy, vy));
    const double mayor = std::max({std::fabs(ux), std::fabs(vx), std::fabs(uy), std::fabs(vy)});
    std::optional<Suma> mejor;
    for (const double rho : {exacta, mayor})
        for (const bool aprisa : {false, true})
            if (const auto otra = sumaDe(mezclaDe(rho, l.coordenadas[2], aprisa), l, texels);
                otra && (!mejor || otra->error < mejor->error - 1e-6))
                mejor = otra;
    return mejor;
}

Json enJsonDe(const Suma &s) {
    std::vector<Json> texels, niveles;
    for (const Texel &t : s.texels)
        texels.push_back({{"nivel", t.nivel},
                          {"texel", std::array<int, 2>{t.x, t.y}},
                          {"peso", t.peso},
                          {"color", t.color}});
    for (const auto &[nivel, peso] : s.mezcla.niveles)
        niveles.push_back(Json().pon("nivel", nivel).pon("peso", peso));
    return {{"lambda", s.mezcla.lambda},
            {"filtro", nombreDe(GLenum(s.mezcla.filtro))},
            {"niveles", niveles},
            {"texels", texels},
            {"suma", s.suma},
            {"cuadra", s.cuadra()}};
}

} // namespace

Json deLectura(GLuint programa, const Lectura &l) {
    Json json;
    const std::vector<Variable> uniforms = uniformsDe(programa);
    const auto suyo = std::find_if(uniforms.begin(), uniforms.end(),
                                   [&](const Variable &v) { return v.nombre == l.sampler; });
    std::optional<Suma> suma;
    bool anisotropa = false;
    GLint textura = 0;
    if (suyo != uniforms.end() && suyo->tipo == GL_SAMPLER_2D) {
        const GLint antes = entero(GL_ACTIVE_TEXTURE);
        glActiveTexture(GLenum(GL_TEXTURE0 + GLint(valorDe(programa, *suyo)[0])));
        if (delNivel(0, GL_TEXTURE_WIDTH) > 0)
            suma = laMejor(l), anisotropa = esAnisotropa(), textura = entero(GL_TEXTURE_BINDING_2D);
        glActiveTexture(GLenum(antes));
    }
    if (suma)
        json = enJsonDe(*suma).pon("textura", textura);
    const bool cuadra = suma && suma->cuadra();
    json.pon("linea", l.linea).pon("sampler", l.sampler).pon("escrito", l.escrito).pon("valor", l.valor);
    json.pon("coordenadas", std::array<double, 2>{l.coordenadas[0], l.coordenadas[1]});
    return json.pon("motivo", cuadra              ? ""
                              : l.sampler.empty() ? "según desde dónde se llama, es una textura u otra"
                              : anisotropa        ? "el filtro anisótropo lee más texels, que no sigo"
                                                  : "no sé de qué texels sale");
}

} // namespace explica
