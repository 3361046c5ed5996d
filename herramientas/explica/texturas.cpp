#include "texturas.h"
#include "nombres.h"
#include "programas.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>

namespace explica {
namespace {

const double IGUAL = 1.1 / 255,
             CONTRASTE = 1.0 / 128; // lo que se puede apartar: los pesos pueden ser de 8 bits

using Ejes = std::array<double, 3>;

// De qué textura de la unidad activa se lee, y de qué cara; y dónde, con un cuadrado o un cubo de 0 a 1.
struct Muestra {
    GLenum objetivo, enlace, cara; // la cara es el objetivo, si no es un cubo
    std::size_t ejes;
    Ejes donde{}, dx{}, dy{};
    double mas = 0;
    bool conNivel = false; // si lo dice textureLod

    GLint parametro(GLenum cual) const {
        return contesta(glGetTexParameteriv, objetivo, cual);
    }
    GLint delNivel(GLint nivel, GLenum cual) const {
        return contesta(glGetTexLevelParameteriv, cara, nivel, cual);
    }
    std::array<int, 3> talla(GLint nivel) const {
        return {delNivel(nivel, GL_TEXTURE_WIDTH), delNivel(nivel, GL_TEXTURE_HEIGHT),
                ejes == 3 ? delNivel(nivel, GL_TEXTURE_DEPTH) : 1};
    }
};

// La cara de un cubo hacia la que va, y dónde la corta (la tabla de la especificación de OpenGL 3.1, §3.8.6).
void vaALaCara(Muestra &m) {
    const auto absoluto = [&](std::size_t k) { return std::fabs(m.donde[k]); };
    const std::size_t mayor = absoluto(2) >= absoluto(0) && absoluto(2) >= absoluto(1) ? 2
                              : absoluto(1) >= absoluto(0)                             ? 1
                                                                                       : 0;
    const bool negativa = m.donde[mayor] < 0;
    m.cara = GLenum(GL_TEXTURE_CUBE_MAP_POSITIVE_X + 2 * int(mayor) + negativa);
    const double signo = negativa ? -1 : 1;
    const auto enCara = [&](const Ejes &r) -> Ejes { // (sc, tc, |ma|)
        if (mayor == 0)
            return {-signo * r[2], -r[1], signo * r[0]};
        if (mayor == 1)
            return {r[0], signo * r[2], signo * r[1]};
        return {signo * r[0], -r[1], signo * r[2]};
    };
    const Ejes c = enCara(m.donde);
    for (Ejes *d : {&m.dx, &m.dy}) {
        const Ejes suya = enCara(*d);
        for (std::size_t k = 0; k < 2; ++k)
            (*d)[k] = (suya[k] - c[k] * suya[2] / c[2]) / c[2] / 2;
        (*d)[2] = 0;
    }
    m.donde = {0.5 + c[0] / c[2] / 2, 0.5 + c[1] / c[2] / 2, 0};
}

bool esAnisotropa(const Muestra &m) {
    static const bool hay = [] {
        for (GLint i = 0; i < entero(GL_NUM_EXTENSIONS); ++i)
            if (!std::strcmp(reinterpret_cast<const char *>(glGetStringi(GL_EXTENSIONS, GLuint(i))),
                             "GL_EXT_texture_filter_anisotropic"))
                return true;
        return false;
    }();
    return hay && m.parametro(GL_TEXTURE_MAX_ANISOTROPY_EXT) > 1;
}

using Valor = std::array<double, 4>;

// Los texels de la textura enlazada, que se leen de un framebuffer.
class Texels {
    const Muestra &m;
    GLuint textura, marco = 0;
    bool profundidad;
    std::map<std::pair<int, std::array<int, 3>>, Valor> leidos;

public:
    explicit Texels(const Muestra &muestra)
        : m(muestra), textura(GLuint(entero(m.enlace))),
          profundidad(m.delNivel(0, GL_TEXTURE_DEPTH_SIZE) > 0) {
        glGenFramebuffers(1, &marco);
    }
    ~Texels() {
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glDeleteFramebuffers(1, &marco);
    }
    Texels(const Texels &) = delete;
    Texels &operator=(const Texels &) = delete;

    // Nada, si no se puede.
    std::optional<Valor> operator()(int nivel, const std::array<int, 3> &texel) {
        const auto [suyo, nuevo] = leidos.insert({{nivel, texel}, {0, 0, 0, 1}});
        if (!nuevo)
            return suyo->second;
        const GLenum adjunto = profundidad ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0;
        glBindFramebuffer(GL_FRAMEBUFFER, marco);
        if (m.ejes == 3)
            glFramebufferTextureLayer(GL_FRAMEBUFFER, adjunto, textura, nivel, texel[2]);
        else
            glFramebufferTexture2D(GL_FRAMEBUFFER, adjunto, m.cara, textura, nivel);
        glDrawBuffer(GL_NONE);
        glReadBuffer(profundidad ? GL_NONE : GL_COLOR_ATTACHMENT0);
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            return {};
        GLfloat leido[4] = {0, 0, 0, 1};
        GLint codifica = 0;
        glReadPixels(texel[0], texel[1], 1, 1, profundidad ? GL_DEPTH_COMPONENT : GL_RGBA, GL_FLOAT, leido);
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
Mezcla mezclaDe(const Muestra &m, double rho, bool aprisa) {
    const GLint reduce = m.parametro(GL_TEXTURE_MIN_FILTER), amplia = m.parametro(GL_TEXTURE_MAG_FILTER);
    const int base = m.parametro(GL_TEXTURE_BASE_LEVEL), tope = m.parametro(GL_TEXTURE_MAX_LEVEL);
    const std::array<int, 3> tallas = m.talla(base);
    int ultimo = base;
    for (int talla = *std::max_element(tallas.begin(), tallas.end()); talla > 1; talla /= 2)
        ultimo = std::min(ultimo + 1, tope);
    const double lambda = std::clamp(std::log2(rho) + m.mas, double(m.parametro(GL_TEXTURE_MIN_LOD)),
                                     double(m.parametro(GL_TEXTURE_MAX_LOD)));
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
    int nivel;
    std::array<int, 3> donde;
    double peso;
    Valor color;
};

struct Suma {
    Mezcla mezcla;
    std::vector<Texel> texels;
    Valor suma{};
    double error = 0;  // lo que se aparta de lo leído
    bool sale = false; // si alguno no está en su cara

    bool cuadra() const {
        if (sale) // según GL_TEXTURE_CUBE_MAP_SEAMLESS, los hay en la de al lado
            return false;
        double contraste = 0; // lo que va de un texel a otro
        for (const Texel &uno : texels)
            for (const Texel &otro : texels)
                for (std::size_t c = 0; c < 4; ++c)
                    contraste = std::max(contraste, uno.color[c] - otro.color[c]);
        return error <= IGUAL + CONTRASTE * contraste;
    }
};

std::optional<Suma> sumaDe(const Mezcla &mezcla, const Muestra &m, const std::vector<double> &leido,
                           Texels &texels) {
    Suma s{mezcla, {}};
    const bool lineal = mezcla.filtro == GL_LINEAR || mezcla.filtro == GL_LINEAR_MIPMAP_NEAREST ||
                        mezcla.filtro == GL_LINEAR_MIPMAP_LINEAR;
    const GLenum REPITE[] = {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R};
    GLfloat borde[4];
    glGetTexParameterfv(m.objetivo, GL_TEXTURE_BORDER_COLOR, borde);
    for (const auto &[nivel, deNivel] : mezcla.niveles) {
        const std::array<int, 3> talla = m.talla(nivel);
        for (unsigned esquina = 0; esquina < 1u << m.ejes; ++esquina) {
            double peso = deNivel;
            bool fuera = false;
            std::array<int, 3> texel{};
            for (std::size_t k = 0; k < m.ejes; ++k) {
                const bool segundo = esquina >> k & 1;
                const double u = m.donde[k] * talla[k] - (lineal ? 0.5 : 0);
                const double resto = lineal ? u - std::floor(u) : 0;
                const int i = int(std::floor(u)) + segundo;
                peso *= segundo ? resto : 1 - resto;
                texel[k] = repetido(m.parametro(REPITE[k]), i, talla[k]);
                fuera = fuera || texel[k] < 0;
                s.sale = s.sale || (m.objetivo == GL_TEXTURE_CUBE_MAP && peso > 0 && texel[k] != i);
            }
            if (peso <= 0)
                continue;
            const std::optional<Valor> color =
                fuera ? Valor{borde[0], borde[1], borde[2], borde[3]} : texels(nivel, texel);
            if (!color)
                return {};
            s.texels.push_back({nivel, texel, peso, *color});
            for (std::size_t c = 0; c < 4; ++c)
                s.suma[c] += peso * (*color)[c];
        }
    }
    for (std::size_t c = 0; c < 4; ++c)
        s.error = std::max(s.error, std::fabs(s.suma[c] - leido[c]) / std::max(1.0, std::fabs(leido[c])));
    return s;
}

// La que mejor da lo leído, de las que deja OpenGL: con cuántos texels abarca un píxel de verdad o aprisa.
std::optional<Suma> laMejor(const Muestra &m, const std::vector<double> &leido) {
    Texels texels(m);
    const std::array<int, 3> talla = m.talla(0);
    double mayor = 0, exacta = 0;
    for (const Ejes &d : {m.dx, m.dy}) {
        double suma = 0;
        for (std::size_t k = 0; k < m.ejes; ++k) {
            mayor = std::max(mayor, std::fabs(d[k] * talla[k]));
            suma += d[k] * talla[k] * d[k] * talla[k];
        }
        exacta = std::max(exacta, std::sqrt(suma));
    }
    if (m.conNivel) // λ es lo que dice
        mayor = exacta = 1;
    std::optional<Suma> mejor;
    for (const double rho :
         {exacta, mayor, 0.98 * exacta, 1.02 * exacta}) // el logaritmo puede ser aproximado
        for (const bool aprisa : {false, true})
            if (const auto otra = sumaDe(mezclaDe(m, rho, aprisa), m, leido, texels);
                otra && (!mejor || otra->error < mejor->error - 1e-6))
                mejor = otra;
    return mejor;
}

Json enJsonDe(const Suma &s, const Muestra &m) {
    std::vector<Json> texels, niveles;
    for (const Texel &t : s.texels)
        texels.push_back({{"nivel", t.nivel},
                          {"texel", std::vector<int>(t.donde.begin(), t.donde.begin() + int(m.ejes))},
                          {"peso", t.peso},
                          {"color", t.color}});
    for (const auto &[nivel, peso] : s.mezcla.niveles)
        niveles.push_back(Json().pon("nivel", nivel).pon("peso", peso));
    const std::string caras[] = {"+X", "−X", "+Y", "−Y", "+Z", "−Z"};
    const bool cubo = m.objetivo == GL_TEXTURE_CUBE_MAP;
    return {{"lambda", s.mezcla.lambda},
            {"cara", cubo ? caras[m.cara - GL_TEXTURE_CUBE_MAP_POSITIVE_X] : ""},
            {"textura", entero(m.enlace)},
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
    static const std::map<GLenum, Muestra> CLASES = {
        {GL_SAMPLER_2D, {GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D, GL_TEXTURE_2D, 2}},
        {GL_SAMPLER_3D, {GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D, GL_TEXTURE_3D, 3}},
        {GL_SAMPLER_CUBE,
         {GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BINDING_CUBE_MAP, GL_TEXTURE_CUBE_MAP_POSITIVE_X, 2}}};
    const auto clase = suyo == uniforms.end() ? CLASES.end() : CLASES.find(suyo->tipo);
    if (clase != CLASES.end()) {
        const GLint antes = entero(GL_ACTIVE_TEXTURE);
        glActiveTexture(GLenum(GL_TEXTURE0 + GLint(valorDe(programa, *suyo)[0])));
        Muestra m = clase->second;
        std::copy_n(l.coordenadas.begin(), l.coordenadas.size() - 1, m.donde.begin());
        std::copy_n(l.dx.begin(), l.dx.size(), m.dx.begin());
        std::copy_n(l.dy.begin(), l.dy.size(), m.dy.begin());
        m.mas = l.coordenadas.back();
        m.conNivel = l.escrito.compare(0, 10, "textureLod") == 0;
        if (m.objetivo == GL_TEXTURE_CUBE_MAP)
            vaALaCara(m);
        if (m.talla(0)[0] > 0 && (suma = laMejor(m, l.valor)))
            anisotropa = esAnisotropa(m), json = enJsonDe(*suma, m);
        glActiveTexture(GLenum(antes));
    }
    const bool cuadra = suma && suma->cuadra();
    json.pon("linea", l.linea).pon("sampler", l.sampler).pon("escrito", l.escrito).pon("valor", l.valor);
    json.pon("coordenadas", std::vector<double>(l.coordenadas.begin(), l.coordenadas.end() - 1));
    return json.pon("motivo", cuadra              ? ""
                              : l.sampler.empty() ? "según desde dónde se llama, es una textura u otra"
                              : anisotropa        ? "el filtro anisótropo lee más texels, que no sigo"
                              : suma && suma->sale
                                  ? "el filtro sale de la cara, y en la de al lado no sé seguirlo"
                                  : "no sé de qué texels sale");
}

} // namespace explica
