// warping, morphing, antialiasing, ampliacion y captura del capítulo 9.
#include "ch09_imagen/malla_imagen.h"
#include "ch09_paneles.h"
#include "contra_oraculo.h"
#include "guiones.h"
#include "oraculo/cobertura.h"
#include <tuple>

namespace {

const Imagen A = alAzar(80, 60, 5), B = alAzar(80, 60, 6);
/// El color dice de qué texel es.
const Imagen RAMPA = imagen(221, 177, [](int x, int y) { return Pixel{x, y, 77}; });

/// Con un cuadrado rojo de 7 × 7 en ese texel.
Imagen conMarca(const Imagen &fondo, int x, int y) {
    return imagen(fondo.ancho, fondo.alto, [&](int i, int j) {
        return std::abs(i - x) < 4 && std::abs(j - y) < 4 ? Pixel{255, 0, 0} : pixel(fondo, i, j);
    });
}
Esperado mezcla(double t) {
    return [t](int x, int y) { return (1 - t) * texel(A, x, y) + t * texel(B, x, y); };
}

} // namespace

// --- malla_imagen.h ---

TEST(MallaImagen, ElPuntoMasCercano) {
    MallaImagen m = creaMallaImagen(repartidos(5), repartidos(4));
    EXPECT_EQ(nudoMasCercano(m, {0.02f, 0.9f}, {80, 60}), 15u);
    // la distancia es en píxeles: en una imagen muy ancha, lo que separa es x
    m = {2, 2, {{0, 0}, {0.3f, 0.5f}, {0, 1}, {1, 1}}};
    EXPECT_EQ(nudoMasCercano(m, {0, 0.4f}, {1, 1}), 1u);
    EXPECT_EQ(nudoMasCercano(m, {0, 0.4f}, {1000, 10}), 0u);
}

// --- warping ---

// No se arrastra con otro botón, ni una esquina fuera de la imagen.
TEST(Warping, LaMallaIdentidadEsElOriginal) {
    const std::string conOtroBoton = clic({40, 30}) + "; " + arrastra({40, 30}, {50, 20}, "CENTRAL");
    compruebaPaneles(
        "warping", {A},
        {{{"", "tecla 2; tecla 1", arrastra({1, 58}, {-500, 900}), conOtroBoton}, {igualQue(A)}}});
    // al comparar se arrastra en la deformada, que en otro sitio de la ventana se redondea de otra manera
    const Imagen movida = procesa("warping", {A}, arrastra({40, 30}, {50, 20})),
                 caricatura = procesa("warping", {A}, "tecla 2");
    compruebaPaneles("warping", {A},
                     {{{"tecla v; " + arrastra({121, 30}, {131, 20})}, {igualQue(A), igualQue(movida)}},
                      {{"tecla v; tecla 2"}, {igualQue(A), igualQue(caricatura)}}},
                     1);
    EXPECT_EQ(procesa("warping", {lisa(1, 1, {9, 99, 199})}).rgb, lisa(1, 1, {9, 99, 199}).rgb);
}

// Arrastrar el punto central (5, 4) lleva su texel al ratón; lo que está a más de dos puntos no se mueve.
TEST(Warping, ElTexelVaConSuPunto) {
    const Imagen r = procesa("warping", {conMarca(RAMPA, 110, 88)}, arrastra({112, 90}, {121, 76}));
    EXPECT_EQ(pixel(r, 121, 100).r, 255);
    EXPECT_LT(pixel(r, 106, 84).r, 255);
    const auto movido = [](int x, int y, const Pixel &p) {
        return (std::abs(x - 110) > 46 || std::abs(y - 88) > 46) && distancia(p, texel(RAMPA, x, y)) > 1;
    };
    EXPECT_EQ(cuenta(r, movido), 0);
}

// --- morphing ---

TEST(Morphing, EnLosExtremosEsAYEsB) {
    compruebaPaneles(
        "morphing", {A, B},
        {{{"tecla 1", "tecla - ×12"}, {igualQue(A)}}, {{"tecla 3", "tecla + ×12"}, {igualQue(B)}}});
    // también con las mallas de las dos caras, que no son regulares
    for (const auto &[tecla, nombre] : {std::pair("tecla 1", "cara.rgb"), {"tecla 3", "gato.rgb"}})
        EXPECT_EQ(vistaDe("morphing", tecla, 960, 720).escena.rgb,
                  leeTextura(std::string(LAB_BUILD "/assets/") + nombre, 960, 720).rgb)
            << nombre;
}

// Con mallas regulares es la mezcla lineal. Al comparar no se arrastra.
TEST(Morphing, SinDeformarEsUnaMezcla) {
    compruebaPaneles("morphing", {A, B},
                     {{{"", "tecla 3; tecla 2"}, {mezcla(0.5)}},
                      {{"tecla 2; tecla +"}, {mezcla(0.55)}},
                      {{"tecla 1; tecla +"}, {mezcla(0.05)}},
                      {{"tecla 2; tecla - ×3; tecla v; " + arrastra({40, 30}, {50, 20})},
                       {igualQue(A), mezcla(0.35), igualQue(B), mezcla(0.35)}}});
}

TEST(Morphing, ElMovimientoSigueAlReloj) {
    for (const auto &[guion, t] :
         {std::pair("1500", 0.5), {"3000", 1.0}, {"6000", 0.0}, {"4500; tecla -", 0.45}})
        EXPECT_LE(diferenciaMaxima(
                      procesa("morphing", {A, B}, std::string("tecla 1; tecla Espacio; espera ") + guion),
                      mezcla(t)),
                  4)
            << guion;
}

// Se arrastra el punto (3, 3) de 7 × 8 a (120, 84): el intermedio queda bajo el ratón. Con t < 0.5 cambia la malla de
// A, y en el ratón sigue el texel de B; si no, al revés.
TEST(Morphing, ElPuntoIntermedioQuedaBajoElRaton) {
    const Imagen negra = lisa(211, 141, {0, 0, 0}), marca = conMarca(negra, 105, 60);
    const std::string arrastrado = arrastra({105, 80}, {120, 84});
    for (const Imagen &r : {procesa("morphing", {negra, marca}, "tecla 2; tecla -; " + arrastrado),
                            procesa("morphing", {marca, negra}, "tecla 2; tecla +; " + arrastrado)}) {
        EXPECT_NEAR(pixel(r, 120, 56).r, 0.45 * 255, 1);
        EXPECT_EQ(pixel(r, 105, 60).r, 0);
    }
}

// --- antialiasing ---

// Contra el área exacta, y las dos técnicas de muestras conocidas, muestra a muestra: el centro del píxel y los
// centros de sus 4 × 4 partes. De las que caen a menos de una centésima de píxel de un lado no se dice nada. Lo que
// se hace antes deja la estrella con ese giro.
void compruebaCobertura(const std::string &antes, double giro) {
    const double fondo = std::round(color(FONDO_CLARO).x), tinta = std::round(color(OSCURO).x);
    std::vector<oraculo::Poligono>
        rayos; // triángulos isósceles; la escena son 180 × 180 píxeles desde (10, 20)
    for (int i = 0; i < 24; ++i) {
        const double a = oraculo::PI * (i + 0.3) / 12 + giro, c = std::cos(a), s = std::sin(a);
        const auto en = [&](double lejos, double aUnLado) {
            return oraculo::Vec2{90 + 90 * (lejos * c - aUnLado * s), 90 + 90 * (lejos * s + aUnLado * c)};
        };
        rayos.push_back({en(0.45, -0.035), en(0.95, 0), en(0.45, 0.035)});
    }
    const std::vector<Vista> vistas =
        vistasDe("antialiasing", {antes + "tecla 1", "tecla 2", "tecla 3"}, 200, 200);
    double suma[3] = {}, maximo[3] = {};
    int n = 0, malos = 0;
    for (int y = 0; y < 180; ++y)
        for (int x = 0; x < 180; ++x) {
            if (std::hypot(x + 0.5 - 90, y + 0.5 - 90) < 0.44 * 90)
                continue; // la lupa
            double area = 0;
            for (const oraculo::Poligono &rayo : rayos)
                area += oraculo::coberturaPixel(rayo, x, y);
            n += area > 0 && area < 1;
            const auto dentro = [&](int lado, double margen) { // de las muestras, cuántas
                int cuantas = 0;
                for (int i = 0; i < lado * lado; ++i)
                    for (const oraculo::Poligono &rayo : rayos)
                        cuantas += oraculo::distanciaDentro(rayo, x + (i % lado + 0.5) / lado,
                                                            y + (i / lado + 0.5) / lado) > margen;
                return double(cuantas) / (lado * lado);
            };
            for (std::size_t k = 0; k < 3; ++k) {
                const double visto = (fondo - pixel(vistas[k].escena, 10 + x, 20 + y).r) / (fondo - tinta);
                const int lado = k == 2 ? 4 : 1;
                malos +=
                    k != 1 && (visto < dentro(lado, 0.01) - 0.006 || visto > dentro(lado, -0.01) + 0.006);
                suma[k] += (visto - area) * (visto - area);
                maximo[k] = std::max(maximo[k], std::fabs(visto - area));
            }
        }
    EXPECT_EQ(malos, 0);
    EXPECT_GT(n, 2000);
    // en la lupa, 3 veces mayores, los 16 × 16 que hay alrededor de 8 píxeles antes de la punta del tercer rayo
    const double a = oraculo::PI * 2.3 / 12 + giro, hasta = 0.95 * 90 - 8;
    const int x0 = int(90 + hasta * std::cos(a) - 8), y0 = int(90 + hasta * std::sin(a) - 8);
    for (const Vista &v : vistas)
        EXPECT_EQ(oraculo::recorta(v.escena, 10 + 66, 20 + 66, 48, 48).rgb,
                  imagen(48, 48, [&](int x, int y) {
                      return pixel(v.escena, 10 + x0 + x / 3, 20 + y0 + y / 3);
                  }).rgb);
    EXPECT_LE(maximo[1], 0.45);
    EXPECT_LE(maximo[2], 0.20);
    EXPECT_LT(std::sqrt(suma[1]), 0.6 * std::sqrt(suma[0]));
    EXPECT_LT(std::sqrt(suma[2]), 0.6 * std::sqrt(suma[1]));
}

TEST(Antialiasing, CoberturaContraElAreaExacta) {
    compruebaCobertura("", 0);
    compruebaCobertura("tecla Espacio; espera 2000; tecla Espacio; espera 500; ", 0.1);
}

// --- ampliacion ---

// Un rectángulo rojo de 40 × 20 en ventanas de varias formas y factores: lo que mide, y el de ×1, tenue, con rótulos.
TEST(Ampliacion, LoQueMideEnPixeles) {
    const std::vector<std::string> roja = enFicheros({lisa(40, 20, {255, 0, 0})});
    const auto mide = [](const Imagen &i, int ancho, int alto, int detras = 0) {
        const auto esperado = [&](int x, int y) {
            const Vec3 rojo{255, 0, 0}, fondo = color(FONDO_OSCURO);
            const int dx = std::abs(2 * x + 1 - i.ancho), dy = std::abs(2 * y + 1 - i.alto);
            const Vec3 fuera = dx < detras && 2 * dy < detras ? 0.3 * rojo + 0.7 * fondo : fondo;
            return dx < ancho && dy < alto ? rojo : fuera;
        };
        EXPECT_LE(diferenciaMaxima(i, esperado), REDONDEO);
    };
    for (const auto &[ancho, alto, guion, anchoRojo, altoRojo] :
         {std::tuple(80, 80, "tecla - ×2", 40, 20),
          {160, 60, "tecla - ×2", 60, 30},
          {80, 80, "tecla f", 80, 40},
          {160, 160, "tecla - ×4", 40, 20},
          {320, 320, "tecla - ×99", 20, 10},
          {80, 80, "tecla + ×99; tecla - ×10", 40, 20},
          {80, 80, "tecla + ×2", 80, 80}}) {
        SCOPED_TRACE(guion);
        mide(vistaDe("ampliacion", guion, ancho, alto, roja).escena, anchoRojo, altoRojo);
    }
    mide(vistaDe("ampliacion", "tecla r; tecla - ×2", 80, 80, roja).escena, 40, 20, 80);
    const Imagen las2 = vistaDe("ampliacion", "tecla v", 161, 80, roja).escena;
    mide(oraculo::recorta(las2, 0, 0, 80, 80), 80, 80);
    mide(oraculo::recorta(las2, 81, 0, 80, 80), 80, 40);
    EXPECT_EQ(procesa("ampliacion", {A}, "tecla f").rgb, A.rgb);
}

// Dos texels en 40 píxeles: con el vecino, cada mitad es de un color; con el lineal se pasa de uno a otro.
TEST(Ampliacion, VecinoYLineal) {
    const Imagen dos = imagen(2, 1, [](int x, int) { return Pixel{200 * x, 0, 0}; });
    const auto en40 = [&](const std::string &guion) {
        return vistaDe("ampliacion", guion, 40, 20, enFicheros({dos})).escena;
    };
    EXPECT_EQ(diferenciaMaxima(en40("tecla f"), [](int x, int) { return Vec3{x < 20 ? 0.0 : 200.0}; }), 0);
    EXPECT_LE(diferenciaMaxima(en40(""), [&](int x, int) { return bilineal(dos, (x + 0.5) / 20, 0.5); }), 1);
}

// --- captura ---

// Anchos que no son múltiplos de 4. Se guarda la escena, sin lo que se enseña de la captura anterior; y la última, si
// ha cambiado.
TEST(Captura, ElFicheroEsElFramebuffer) {
    const std::string fichero = (carpetaTemporal() / "captura.ppm").string();
    for (const std::string guion : {"tecla d; tecla g", "tecla g; tecla d; tecla g"})
        for (const auto &[ancho, alto] : {std::pair(241, 181), {7, 5}, {1, 1}}) {
            vistaDe("captura", guion, ancho, alto, {fichero});
            EXPECT_EQ(leePpm(fichero).rgb, vistaDe("captura", "tecla d", ancho, alto).escena.rgb);
        }
}

// También la segunda vez, con la ventana de otra forma.
TEST(Captura, LaEsquinaEnsenaLoLeido) {
    const std::string fichero = (carpetaTemporal() / "captura.ppm").string(),
                      guion = "tamano 300 500; tecla g; tamano 960 720; tecla g";
    const Imagen gpu = vistaDe("captura", guion, 960, 720, {fichero}).escena, leida = leePpm(fichero);
    const auto deEnMedio = [&](int x, int y) { return texel(leida, 3 * x + 1, 3 * y + 1); };
    EXPECT_LE(diferenciaMaxima(oraculo::recorta(gpu, 24, 702 - 240, 320, 240), deEnMedio), 2);
}

// Con el disco lleno se dice; que no quede nada a medias, en lectores_test.cpp.
TEST(Captura, DiscoLleno) {
    const Ejecucion e = ejecuta("captura", "tecla g", 240, 180, {"/dev/full"});
    EXPECT_NE(e.errores.find("no puedo guardar «/dev/full»"), std::string::npos) << e.errores;
}
