// Una gaussiana de 3×3 a 31×31 sobre la foto: directa o en dos pasadas, con el intermedio de 8 bits o de float.
#include "ch09_imagen/nucleos.h"
#include "gpu.h"
#include "mide.h"
#include "rutas.h"
#include "textura.h"
#include <filesystem>
#ifdef LAB_PAR_OPENCV
#include <opencv2/imgproc.hpp>
#endif

using namespace mide;

static const int ANCHO = 250, ALTO = 190;

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

// Una textura sin mipmaps que repite el borde, y un framebuffer que dibuja en ella.
struct Capa {
    GLuint textura, framebuffer;
    Capa(GLint formato, const void *rgb) {
        glGenTextures(1, &textura);
        glBindTexture(GL_TEXTURE_2D, textura);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glTexImage2D(GL_TEXTURE_2D, 0, formato, ANCHO, ALTO, 0, GL_RGB, GL_UNSIGNED_BYTE, rgb);
        for (const GLenum eje : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
            glTexParameteri(GL_TEXTURE_2D, eje, GL_CLAMP_TO_EDGE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glGenFramebuffers(1, &framebuffer);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, textura, 0);
    }
};

// El filtro de m × n números, como textura en la unidad 1.
static GLuint texturaFiltro(const std::vector<float> &valores, int m) {
    GLuint textura;
    glActiveTexture(GL_TEXTURE1);
    glGenTextures(1, &textura);
    glBindTexture(GL_TEXTURE_2D, textura);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, m, int(valores.size()) / m, 0, GL_RED, GL_FLOAT, valores.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glActiveTexture(GL_TEXTURE0);
    return textura;
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
    m.variante("par: OpenCV, " + m.grupo, rmse(imagen, exacta), 1, filtra, CUALQUIERA, "separable, en la CPU",
               imagen);
}
#endif

// La foto, donde se deja filtrada y los programas que la filtran.
struct Banco {
    const Capa entrada, en8{GL_RGBA8, nullptr}, enFloat{GL_RGBA32F, nullptr}, salida{GL_RGBA8, nullptr};
    const GLuint directo = creaFiltrador("convolucion_variable"),
                 separable = creaFiltrador("convolucion_separable");

    explicit Banco(const Imagen &foto) : entrada(GL_RGB8, foto.rgb.data()) {
        glViewport(0, 0, ANCHO, ALTO);
    }
    // Con un filtro de cualquier forma, en una textura.
    void filtra(const Capa &de, const Capa &a, GLuint filtro) const {
        glActiveTexture(GL_TEXTURE1);
        glBindTexture(GL_TEXTURE_2D, filtro);
        glActiveTexture(GL_TEXTURE0);
        glUseProgram(directo);
        envia(directo, "filtro", 1);
        dibujaEn(de, a);
    }
    // De la entrada a la salida, primero por filas y después por columnas, con lo de en medio en `por`.
    void enDosPasadas(const Capa &por, const Filtro &f) const {
        glUseProgram(separable);
        envia(separable, "talla", f.talla);
        envia(separable, "eje", glm::vec2(1, 0));
        glUniform1fv(uniforme(separable, "filtro"), f.talla, f.fila.data());
        dibujaEn(entrada, por);
        envia(separable, "eje", glm::vec2(0, 1));
        glUniform1fv(uniforme(separable, "filtro"), f.talla, f.columna.data());
        dibujaEn(por, salida);
    }
    void interpola(GLint como) const {
        for (const Capa *capa : {&entrada, &enFloat}) {
            glBindTexture(GL_TEXTURE_2D, capa->textura);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, como);
        }
    }
    Imagen lee() const {
        Imagen imagen{ANCHO, ALTO, std::vector<unsigned char>(3 * ANCHO * ALTO)};
        glBindFramebuffer(GL_FRAMEBUFFER, salida.framebuffer);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, ANCHO, ALTO, GL_RGB, GL_UNSIGNED_BYTE, imagen.rgb.data());
        return imagen;
    }

private:
    static GLuint creaFiltrador(const std::string &nombre) {
        const GLuint programa = creaPrograma("ch09_imagen/imagen.vert", "ch09_imagen/" + nombre + ".frag");
        glUseProgram(programa);
        for (const char *uniforme : {"imagen", "sumaCero", "conSigno"})
            envia(programa, uniforme, 0);
        return programa;
    }
    static void dibujaEn(const Capa &de, const Capa &a) {
        glBindFramebuffer(GL_FRAMEBUFFER, a.framebuffer);
        glBindTexture(GL_TEXTURE_2D, de.textura);
        dibujaRectangulo();
    }
};

static void mideTalla(Medidor &m, const Banco &banco, const Imagen &foto, int talla) {
    const Filtro f = creaFiltro(GAUSSIANA, talla);
    const std::vector<double> exacta =
        pasada(pasada({foto.rgb.begin(), foto.rgb.end()}, f.fila, false), f.columna, true);
    m.referencia = redondeada(ANCHO, ALTO, exacta);
    m.grupo = std::to_string(talla) + "×" + std::to_string(talla);
    const auto variante = [&](const std::string &nombre, const std::function<void()> &dibuja,
                              const Rango &espera) {
        dibuja();
        const Imagen imagen = banco.lee();
        m.variante(nombre + ", " + m.grupo, rmse(imagen, exacta), 1, yEspera(dibuja), espera, "", imagen);
    };
    const GLuint entero = texturaFiltro(f.valores, talla), fila = texturaFiltro(f.fila, talla),
                 columna = texturaFiltro(f.columna, 1);
    // guardar en 8 bits cuesta 1/√12 = 0.29 niveles; dos veces, algo más
    const Rango unaVez = {0.2, 0.32}, dosVeces = {0.2, 0.5};
    variante(
        "directa", [&] { banco.filtra(banco.entrada, banco.salida, entero); }, unaVez);
    variante(
        "separable, 8 bits", [&] { banco.enDosPasadas(banco.en8, f); }, dosVeces);
    variante(
        "separable, float", [&] { banco.enDosPasadas(banco.enFloat, f); }, unaVez);
    variante(
        "separable, el filtro en una textura",
        [&] {
            banco.filtra(banco.entrada, banco.enFloat, fila);
            banco.filtra(banco.enFloat, banco.salida, columna);
        },
        unaVez);
    banco.interpola(GL_LINEAR);
    variante(
        "separable, interpolando", [&] { banco.enDosPasadas(banco.enFloat, f); }, unaVez);
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
