// Un toro que refleja su entorno, delante de él: lado de las caras del mapa, y reflexión por vértice o por fragmento,
// frente a trazar rayos.
#include "escena.h"

using namespace mide;

// El entorno exacto: un cielo degradado y un damero de meridianos y paralelos, con bordes suaves.
static oraculo::Vec3 entorno(const oraculo::Vec3 &d) {
    const double l = oraculo::longitud(d), alto = d.y / l, giro = std::atan2(d.z, d.x);
    const double dibujo = std::tanh(3 * std::sin(6 * giro) * std::cos(8 * alto)) *
                          std::pow(1 - alto * alto, 2); // en los polos, nada
    return {0.5 + 0.3 * dibujo, 0.55 + 0.2 * dibujo * alto, 0.6 + 0.3 * alto};
}

static GLuint creaMapa(int lado) {
    GLuint mapa;
    glGenTextures(1, &mapa);
    glBindTexture(GL_TEXTURE_CUBE_MAP, mapa);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (int cara = 0; cara < 6; ++cara) {
        std::vector<unsigned char> rgb;
        for (int j = 0; j < lado; ++j)
            for (int i = 0; i < lado; ++i) { // la tabla de la especificación, al revés
                const double s = (2 * i + 1.0) / lado - 1, t = (2 * j + 1.0) / lado - 1;
                const oraculo::Vec3 d[6] = {{1, -t, -s}, {-1, -t, s}, {s, 1, t},
                                            {s, -1, -t}, {s, -t, 1},  {-s, -t, -1}};
                const oraculo::Vec3 c = entorno(d[cara]);
                for (int k = 0; k < 3; ++k)
                    rgb.push_back(enOchoBits(c[k]));
            }
        glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + cara, 0, GL_RGB8, lado, lado, 0, GL_RGB,
                     GL_UNSIGNED_BYTE, rgb.data());
    }
    glGenerateMipmap(GL_TEXTURE_CUBE_MAP);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    return mapa;
}

static oraculo::ImagenRef trazaReflejo(const Framebuffer &framebuffer) {
    const oraculo::Vec3 METAL = {0.97, 0.91, 0.80};
    const oraculo::Objeto anillo = oraculo::malla({}, toro(1, 0.5f, 720, 360)); // mucho más fina
    return oraculo::render({anillo}, camaraExacta(), framebuffer.ancho, framebuffer.alto,
                           [&](const oraculo::Impacto &i) {
                               return i ? METAL * entorno(oraculo::refleja(i.rayo.direccion, i.normal))
                                        : entorno(i.rayo.direccion);
                           });
}

static GLuint creaProgramaFondo(const glm::mat4 &proyeccion) {
    const GLuint programa = creaPrograma("ch08_texturas_avanzadas/cubemap_fondo.vert",
                                         "ch08_texturas_avanzadas/cubemap_fondo.frag");
    const glm::mat3 ejes = glm::transpose(glm::mat3(camaraEscena()));
    glUseProgram(programa);
    envia(programa, "base", glm::mat3(ejes[0], ejes[1], -ejes[2]));
    envia(programa, "semitalla", glm::vec2(1 / proyeccion[0][0], 1 / proyeccion[1][1]));
    return programa;
}

static GLuint creaProgramaReflejo(const glm::mat4 &proyeccion) {
    const GLuint programa =
        creaPrograma("ch08_texturas_avanzadas/cubemap.vert", "ch08_texturas_avanzadas/cubemap.frag");
    usaPrograma(programa, camaraEscena(), proyeccion);
    envia(programa, "ojo", OJO);
    envia(programa, "M", glm::mat4(1));
    envia(programa, "N", glm::mat3(1));
    return programa;
}

static void mideEntorno(Medidor &m) {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL); // el fondo está en el plano lejos
    const Framebuffer framebuffer(m.elige(64, 320), m.elige(48, 240));
    const oraculo::ImagenRef ref = trazaReflejo(framebuffer);
    m.referencia = oraculo::enBytes(ref);
    const GLuint reflejo = creaProgramaReflejo(proyeccionEscena(framebuffer)),
                 fondo = creaProgramaFondo(proyeccionEscena(framebuffer));
    for (const GLuint programa : {reflejo, fondo}) {
        glUseProgram(programa);
        envia(programa, "mapa", 0);
        envia(programa, "mapaEsferico", 1); // de otro tipo: no puede ser la misma unidad
    }
    GLuint vao;
    glGenVertexArrays(1, &vao);
    const Dibujadas deFrente{m, framebuffer, [&](const Imagen &i) { return errorDeFrente(i, ref); }},
        detras{m, framebuffer, [&](const Imagen &i) {
                   return errorDonde(i, ref, [&](int x, int y) {
                       return ref.en(x, y).objeto < 0 && !oraculo::enBanda(ref, x, y);
                   });
               }};
    for (const int lado : m.elige<std::vector<int>>({16, 256}, {16, 32, 64, 128, 256, 512})) {
        const GLuint mapa = creaMapa(lado);
        const std::string nota = formatea("%.3g kB", 6 * 3 * lado * lado * 4 / 3 / 1000.0);
        const auto toroDe = [&](const std::string &nombre, int segmentos, bool porVertice) {
            const Buferes b = creaBuferes(toro(1, 0.5f, segmentos, segmentos / 2));
            deFrente(nombre, nota, [&] {
                framebuffer.borra({0, 0, 0});
                glUseProgram(reflejo);
                envia(reflejo, "porVertice", porVertice);
                dibujaMalla(b);
            });
            borraBuferes(b);
        };
        m.grupo = "el reflejo";
        toroDe(formatea("por fragmento, caras de %d²", lado), 180, false);
        for (const int segmentos : lado == 256 ? std::vector<int>{36, 90, 180} : std::vector<int>{})
            toroDe(formatea("por vértice, toro de %d", segmentos), segmentos, true);
        m.grupo = "el fondo";
        detras(formatea("el fondo, caras de %d²", lado), nota, [&] {
            framebuffer.borra({0, 0, 0});
            glUseProgram(fondo);
            glBindVertexArray(vao);
            glDrawArrays(GL_TRIANGLES, 0, 3);
        });
        glDeleteTextures(1, &mapa);
    }
}

static const Apunta APUNTA(
    {14, "entorno", "Reflejar el entorno", "ms por imagen de 320×240",
     "niveles de 255 (RMSE), frente a trazar rayos", "el fondo, caras de 256²",
     "Al reflejo solo le bastan caras de 64²: una superficie curva encoge el entorno. cubemap las tiene "
     "de 256² porque son además el "
     "fondo, que con menos se queda a más de medio nivel. Por vértice, el reflejo se interpola en línea "
     "recta y necesita mucha malla.",
     mideEntorno});
