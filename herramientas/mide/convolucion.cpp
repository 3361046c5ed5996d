// Una gaussiana de 3×3 a 31×31 sobre la foto: directa o en dos pasadas, con el intermedio de 8 bits o de float.
#include "ch09_imagen/nucleos.h"
#include "error.h"
#include "gpu.h"
#include "rutas.h"
#include "shader.h"
#include <filesystem>

using namespace mide;

static const int ANCHO = 250, ALTO = 190;
static const glm::ivec2 TALLA(ANCHO, ALTO);

// Una pasada en double, por filas o por columnas, con el borde repetido.
static std::vector<double> pasada(const std::vector<double> &v, const std::vector<float> &nucleo,
                                  bool columnas) {
    const int n = int(nucleo.size());
    std::vector<double> r;
    for (int y = 0; y < ALTO; ++y)
        for (int x = 0; x < ANCHO; ++x)
            for (int c = 0; c < 3; ++c) {
                double suma = 0;
                for (int i = 0; i < n; ++i) {
                    const int d = i - (n - 1) / 2, u = std::clamp(x + (columnas ? 0 : d), 0, ANCHO - 1),
                              w = std::clamp(y + (columnas ? d : 0), 0, ALTO - 1);
                    suma += double(nucleo[i]) * v[3 * (w * ANCHO + u) + c];
                }
                r.push_back(suma);
            }
    return r;
}

// ImageMagick, con el mismo núcleo y sin más hilos: tantas veces que el arranque y los ficheros no cuentan.
static void parImageMagick(Medidor &m, const Imagen &foto, const Filtro &f,
                           const std::vector<double> &exacta) {
    const std::filesystem::path carpeta = std::filesystem::temp_directory_path();
    std::string nucleo = formatea("%dx%d:", f.talla, f.talla);
    for (const float v : f.valores)
        nucleo += std::to_string(v) + ",";
    nucleo.pop_back();
    guardaPpm((carpeta / "entra.ppm").string(), foto);
    setenv("CARPETA", carpeta.c_str(), 1); // que puede llevar cualquier carácter
    const auto ejecuta = [=](int veces) {
        const std::string orden = "convert -limit thread 1 \"$CARPETA/entra.ppm\" -virtual-pixel edge "
                                  "-morphology Convolve:" +
                                  std::to_string(veces) + " " + nucleo + " -depth 8 \"$CARPETA/sale.ppm\"";
        if (std::system(orden.c_str()))
            falla("ImageMagick ha fallado");
    };
    ejecuta(1);
    const double e = rmse(leePpm((carpeta / "sale.ppm").string()), exacta);
    const int veces = 5000 / (f.talla * f.talla);
    m.variante("par: ImageMagick, " + m.grupo, "directa", e, veces, [=] { ejecuta(veces); });
}

static GLuint creaFiltrador(const std::string &nombre) {
    const GLuint programa = creaPrograma("ch09_imagen/imagen.vert", "ch09_imagen/" + nombre + ".frag");
    glUseProgram(programa);
    for (const char *uniforme : {"imagen", "sumaCero", "conSigno"})
        envia(programa, uniforme, 0);
    return programa;
}

static void dibujaEn(GLuint de, const Lienzo &a) {
    glBindFramebuffer(GL_FRAMEBUFFER, a.framebuffer);
    glBindTexture(GL_TEXTURE_2D, de);
    dibujaRectangulo();
}

static void mideConvolucion(Medidor &m) {
    glViewport(0, 0, ANCHO, ALTO);
    const Imagen foto = leeTextura(recurso("assets/foto.rgb"), ANCHO, ALTO);
    const GLuint entrada = creaTexturaExacta(foto), directo = creaFiltrador("convolucion_variable"),
                 separable = creaFiltrador("convolucion_separable");
    const Lienzo en8 = creaLienzo(TALLA), enFloat = creaLienzo(TALLA, GL_RGBA32F), salida = creaLienzo(TALLA);
    // sin interpolar, que en el centro de un texel da lo mismo
    for (const GLuint textura : {entrada, en8.textura}) {
        glBindTexture(GL_TEXTURE_2D, textura);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    }
    for (const int talla : m.elige<std::vector<int>>({3, 5}, {3, 5, 9, 15, 31})) {
        const Filtro f = creaFiltro(GAUSSIANA, talla);
        const std::vector<double> exacta =
            pasada(pasada({foto.rgb.begin(), foto.rgb.end()}, f.fila, false), f.columna, true);
        m.referencia = redondeada(ANCHO, ALTO, exacta);
        m.grupo = formatea("%d×%d", talla, talla);
        glActiveTexture(GL_TEXTURE1);
        creaTexturaExacta(GL_R32F, {talla, talla}, GL_RED, GL_FLOAT, f.valores.data());
        glActiveTexture(GL_TEXTURE0);
        const Dibujadas variante{m, TALLA, [&](const Imagen &i) { return rmse(i, exacta); }};
        variante("directa, " + m.grupo, "", [&] {
            glUseProgram(directo);
            envia(directo, "filtro", 1);
            dibujaEn(entrada, salida);
        });
        // primero por filas y después por columnas, con lo de en medio en ese lienzo
        const auto enDosPasadas = [&](const Lienzo &por) {
            glUseProgram(separable);
            envia(separable, "talla", f.talla);
            envia(separable, "eje", glm::vec2(1, 0));
            glUniform1fv(uniforme(separable, "filtro"), f.talla, f.fila.data());
            dibujaEn(entrada, por);
            envia(separable, "eje", glm::vec2(0, 1));
            glUniform1fv(uniforme(separable, "filtro"), f.talla, f.columna.data());
            dibujaEn(por.textura, salida);
        };
        variante("separable, 8 bits, " + m.grupo, "", [&] { enDosPasadas(en8); });
        variante("separable, float, " + m.grupo, "", [&] { enDosPasadas(enFloat); });
        if (!m.ensayo && m.pares && (talla == 3 || talla == 15))
            parImageMagick(m, foto, f, exacta);
    }
}

static const Apunta
    APUNTA({10, "convolucion", "Convolución gaussiana", "ms por imagen de 250×190",
            "niveles de 255 (RMSE), frente a double sin redondear", "separable, float",
            "En dos pasadas cuesta 2n lecturas por píxel y no n². Guardar lo de en medio en "
            "8 bits redondea dos veces: convolucion_variable usa float desde 3×3, y la directa solo si el "
            "filtro no es separable.",
            mideConvolucion});
