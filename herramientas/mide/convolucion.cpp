// Una gaussiana de 3×3 a 31×31 sobre la foto: directa o en dos pasadas, con el intermedio de 8 bits o de float.
#include "ch09_imagen/nucleos.h"
#include "gpu.h"
#include "rutas.h"
#include "shader.h"
#include <filesystem>
#ifdef LAB_PAR_OPENCV
#include <opencv2/imgproc.hpp>
#endif

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

// El filtro de m × n números, como textura.
static GLuint texturaFiltro(const std::vector<float> &valores, int m) {
    return creaTexturaExacta(GL_R32F, {m, int(valores.size()) / m}, GL_RED, GL_FLOAT, valores.data());
}

// ImageMagick, si está, con el mismo núcleo: lo que tarda una pasada más, sin el arranque ni los ficheros.
static void parImageMagick(Medidor &m, const Imagen &foto, const Filtro &f,
                           const std::vector<double> &exacta) {
    const std::string entra = (std::filesystem::temp_directory_path() / "mide_entra.ppm").string(),
                      sale = (std::filesystem::temp_directory_path() / "mide_sale.ppm").string();
    std::string nucleo = std::to_string(f.talla) + "x" + std::to_string(f.talla) + ":";
    for (const float v : f.valores)
        nucleo += (nucleo.back() == ':' ? "" : ",") + std::to_string(v);
    guardaPpm(entra, foto);
    const auto ejecuta = [&](int veces) {
        return milisegundosDeOrden({"convert", "-limit", "thread", "1", entra, "-virtual-pixel", "edge",
                                    "-morphology", "Convolve:" + std::to_string(veces), nucleo, "-depth", "8",
                                    sale});
    };
    ejecuta(1);
    const double e = rmse(leePpm(sale), exacta);
    m.cronometrada(
        "par: ImageMagick, " + std::to_string(f.talla) + "×" + std::to_string(f.talla), e,
        [&] { return (ejecuta(11) - ejecuta(1)) / 10; }, "directa");
}

#ifdef LAB_PAR_OPENCV
static void parOpenCv(Medidor &m, const Imagen &foto, const Filtro &f, const std::vector<double> &exacta) {
    cv::setNumThreads(1);
    cv::Mat origen(ALTO, ANCHO, CV_8UC3, const_cast<unsigned char *>(foto.rgb.data())), destino;
    const auto filtra = [&] {
        cv::sepFilter2D(origen, destino, CV_8U, f.fila, f.columna, {-1, -1}, 0, cv::BORDER_REPLICATE);
    };
    filtra();
    const Imagen imagen{ANCHO, ALTO, {destino.datastart, destino.dataend}};
    m.variante("par: OpenCV, " + m.grupo, rmse(imagen, exacta), 1, filtra, "separable, en la CPU", imagen);
}
#endif

// La foto, donde se deja filtrada y los programas que la filtran.
struct Banco {
    const GLuint entrada;
    const Lienzo en8 = creaLienzo(TALLA), enFloat = creaLienzo(TALLA, GL_RGBA32F), salida = creaLienzo(TALLA);
    const GLuint directo = creaFiltrador("convolucion_variable"),
                 separable = creaFiltrador("convolucion_separable");

    explicit Banco(const Imagen &foto) : entrada(creaTexturaExacta(foto)) {
        glViewport(0, 0, ANCHO, ALTO);
        interpola(GL_NEAREST);
    }
    // Con un filtro de cualquier forma, en una textura.
    void filtra(GLuint de, const Lienzo &a, GLuint filtro) const {
        glActiveTexture(GL_TEXTURE1);
        glBindTexture(GL_TEXTURE_2D, filtro);
        glActiveTexture(GL_TEXTURE0);
        glUseProgram(directo);
        envia(directo, "filtro", 1);
        dibujaEn(de, a);
    }
    // De la entrada a la salida, primero por filas y después por columnas, con lo de en medio en `por`.
    void enDosPasadas(const Lienzo &por, const Filtro &f) const {
        glUseProgram(separable);
        envia(separable, "talla", f.talla);
        envia(separable, "eje", glm::vec2(1, 0));
        glUniform1fv(uniforme(separable, "filtro"), f.talla, f.fila.data());
        dibujaEn(entrada, por);
        envia(separable, "eje", glm::vec2(0, 1));
        glUniform1fv(uniforme(separable, "filtro"), f.talla, f.columna.data());
        dibujaEn(por.textura, salida);
    }
    void interpola(GLint como) const {
        for (const GLuint textura : {entrada, en8.textura, enFloat.textura}) {
            glBindTexture(GL_TEXTURE_2D, textura);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, como);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, como);
        }
    }

private:
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
};

static void mideTalla(Medidor &m, const Banco &banco, const Imagen &foto, int talla) {
    const Filtro f = creaFiltro(GAUSSIANA, talla);
    const std::vector<double> exacta =
        pasada(pasada({foto.rgb.begin(), foto.rgb.end()}, f.fila, false), f.columna, true);
    m.referencia = redondeada(ANCHO, ALTO, exacta);
    m.grupo = std::to_string(talla) + "×" + std::to_string(talla);
    const auto variante = [&](const std::string &nombre, const std::function<void()> &dibuja) {
        mideImagen(m, nombre + ", " + m.grupo, TALLA, dibuja,
                   [&](const Imagen &i) { return rmse(i, exacta); });
    };
    const GLuint entero = texturaFiltro(f.valores, talla), fila = texturaFiltro(f.fila, talla),
                 columna = texturaFiltro(f.columna, 1);
    variante("directa", [&] { banco.filtra(banco.entrada, banco.salida, entero); });
    variante("separable, 8 bits", [&] { banco.enDosPasadas(banco.en8, f); });
    variante("separable, float", [&] { banco.enDosPasadas(banco.enFloat, f); });
    variante("separable, el filtro en una textura", [&] {
        banco.filtra(banco.entrada, banco.enFloat, fila);
        banco.filtra(banco.enFloat.textura, banco.salida, columna);
    });
    banco.interpola(GL_LINEAR);
    variante("separable, interpolando", [&] { banco.enDosPasadas(banco.enFloat, f); });
    banco.interpola(GL_NEAREST);
#ifdef LAB_PAR_OPENCV
    parOpenCv(m, foto, f, exacta);
#endif
    if (!m.ensayo && m.pares && (talla == 3 || talla == 15))
        parImageMagick(m, foto, f, exacta);
}

static void mideConvolucion(Medidor &m) {
    abreContexto();
    glDisable(GL_DEPTH_TEST);
    const Imagen foto = leeTextura(recurso("assets/foto.rgb"), ANCHO, ALTO);
    const Banco banco(foto);
    for (const int talla : m.elige<std::vector<int>>({3, 5}, {3, 5, 9, 15, 31}))
        mideTalla(m, banco, foto, talla);
}

static const Apunta
    APUNTA({10, "convolucion", "Convolución gaussiana", "ms por imagen de 250×190",
            "niveles de 255 (RMSE), frente a double sin redondear", "separable, float",
            "En dos pasadas cuesta 2n lecturas por píxel y no n². Guardar lo de en medio en "
            "8 bits redondea dos veces: convolucion_variable usa float desde 3×3, y la directa solo si el "
            "filtro no es separable. El filtro, en un uniform: leerlo de una textura cuesta tanto como "
            "leer la imagen. Y sin interpolar, que en el centro de un texel da lo mismo.",
            mideConvolucion});
