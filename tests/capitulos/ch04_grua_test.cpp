// Comprobaciones independientes de grua_vistas, grua_proyeccion y grua_zbuffer: la grúa entera en cada vista,
// y las imágenes contra el trazado de rayos en doble.
#include "ch04_oraculo.h"
#include "ch04_vista3d/vistas_grua.h"
#include <algorithm>
#include <gtest/gtest.h>
#include <iostream>

namespace {

using oraculo::Mat4;
using oraculo::Vec3;

/// La grúa del ejercicio 3.5 escrita otra vez, en doble: suelo, pie, brazo, contrapeso, cable y carga.
struct Postura {
    double giro, distancia, altura;
};
std::vector<Mat4> cajasGrua(const Postura &p) {
    using namespace oraculo;
    const Mat4 giro = gira({0, 1, 0}, p.giro);
    const double cable = 9.5 - p.altura;
    return {
        traslada({0, -0.15, 0}) * escala({10.5, 0.3, 10.5}),
        traslada({0, 5, 0}) * escala({0.8, 10, 0.8}),
        giro * traslada({2.5, 10.4, 0}) * escala({10, 0.8, 0.8}),
        giro * traslada({-1.8, 9.3, 0}) * escala(1.4),
        giro * traslada({p.distancia, 10 - cable / 2, 0}) * escala({0.12, cable, 0.12}),
        giro * traslada({p.distancia, p.altura, 0}),
    };
}
std::vector<Vec3> esquinasDe(const Postura &p) {
    std::vector<Vec3> puntos;
    const std::vector<Mat4> cajas = cajasGrua(p);
    for (std::size_t i = 0; i < cajas.size(); ++i)
        for (int k = 0; k < 8; ++k)
            puntos.push_back(punto(cajas[i], {(k & 1) - 0.5, (k >> 1 & 1) - 0.5, (k >> 2) - 0.5}));
    return puntos;
}

/// 24 giros × 8 distancias × 9 alturas, con los extremos del recorrido: 1728 posturas.
std::vector<Vec3> puntosDeTodasLasPosturas() {
    std::vector<Vec3> puntos;
    for (int g = 0; g < 24; ++g)
        for (int d = 0; d < 8; ++d)
            for (int h = 0; h < 9; ++h) {
                const auto de = esquinasDe({g * oraculo::PI / 12, 1.4 + d * 5.6 / 7, 0.5 + h * 8.5 / 8});
                puntos.insert(puntos.end(), de.begin(), de.end());
            }
    return puntos;
}

const int TAMANOS[][2] = {{240, 180}, {800, 600}, {180, 240}, {333, 77},  {1, 200},
                          {300, 1},   {1, 1},     {2, 3},     {5000, 40}, {3, 16384}};

/// Donde va la grúa en un panel: encima, una novena parte es para el rótulo.
Recuadro sinRotulo(const Hueco &h) {
    return {h.x, h.y, h.ancho, h.alto - h.alto / 9};
}

/// Los recuadros que usan los programas: en la ventana entera o en un cuarto, si no queda vacío.
std::vector<Recuadro> recuadros(int ancho, int alto) {
    std::vector<Recuadro> lista;
    for (const int n : {1, 2})
        if (const Recuadro r = sinRotulo(hueco(0, n, 0, n, ancho, alto)); r.ancho > 0 && r.alto > 0)
            lista.push_back(r);
    return lista;
}

/// Comprueba que `proyeccion · camara` deja dentro todos los puntos y no los deforma, y devuelve lo más que se
/// acercan al borde: 1 es tocarlo.
double masCercaDelBorde(const glm::dmat4 &camara, const glm::dmat4 &proyeccion, const Recuadro &r,
                        const std::vector<Vec3> &puntos) {
    const glm::mat4 aGpu = proyeccion * camara; // en float, como lo recibe la GPU
    double borde = 0;
    for (const Vec3 &p : puntos) {
        double c[4];
        for (int fila = 0; fila < 4; ++fila)
            c[fila] = static_cast<double>(aGpu[0][fila]) * p.x + static_cast<double>(aGpu[1][fila]) * p.y +
                      static_cast<double>(aGpu[2][fila]) * p.z + static_cast<double>(aGpu[3][fila]);
        EXPECT_GT(c[3], 0);
        EXPECT_LT(std::fabs(c[2]), c[3]);
        borde = std::max({borde, std::fabs(c[0] / c[3]), std::fabs(c[1] / c[3])});
    }
    // las mismas unidades por píxel a lo ancho que a lo alto
    EXPECT_NEAR(proyeccion[0][0] * r.ancho / (proyeccion[1][1] * r.alto), 1, 1e-12);
    return borde;
}

} // namespace

// La grúa entera en 1728 posturas, las cuatro vistas, las dos proyecciones y todo tamaño de ventana, con la
// holgura del 6 % (y 1e-6 de las matrices en float). Y sin derrochar sitio: alguna postura llega a ella, salvo el
// 0.12 % del polígono de 64 lados circunscrito y el 1 − cos(π/24) = 0.86 % que se puede perder entre dos giros.
TEST(Encuadre, TodaPosturaEnteraEnCadaVista) {
    const std::vector<Vec3> puntos = puntosDeTodasLasPosturas();
    const std::vector<glm::dvec3> envolvente = envolventeGrua();
    for (const auto &t : TAMANOS)
        for (int v = 0; v < N_VISTAS; ++v)
            for (const Recuadro &r : recuadros(t[0], t[1])) {
                const glm::dmat4 camara = camaraVista(VISTAS[v]);
                const double escala = unidadesPorPixel(envolvente, camara, r);
                for (const glm::dmat4 &proyeccion : {paralelaQueEncierra(envolvente, camara, r, escala),
                                                     perspectivaQueEncierra(envolvente, camara, r)}) {
                    const double borde = masCercaDelBorde(camara, proyeccion, r, puntos);
                    EXPECT_LE(borde, 1 / 1.06 + 1e-6) << t[0] << "x" << t[1] << " vista " << v;
                    EXPECT_GE(borde, 0.99 / 1.06) << t[0] << "x" << t[1] << " vista " << v;
                }
            }
}

// También con la cámara que mueve el ratón, desde cualquier lado de arriba y a las distancias que deja la rueda: de 10.4 a 65.
TEST(Encuadre, TodaPosturaEnteraDesdeCualquierLado) {
    const std::vector<Vec3> puntos = puntosDeTodasLasPosturas();
    const std::vector<glm::dvec3> envolvente = envolventeGrua();
    const Recuadro r{0, 0, 237, 171};
    for (double distancia : {10.4, 26.0, 65.0})
        for (int a = 0; a < 8; ++a)
            for (double elevacion : {0.0, 0.35, 0.7, 1.2, 1.55}) {
                const double azimut = a * oraculo::PI / 4;
                const Vista vista = {"",
                                     {distancia * std::cos(elevacion) * std::sin(azimut),
                                      distancia * std::sin(elevacion),
                                      distancia * std::cos(elevacion) * std::cos(azimut)},
                                     {0, 1, 0},
                                     {}};
                const glm::dmat4 camara = camaraVista(vista);
                const double escala = unidadesPorPixel(envolvente, camara, r);
                for (const glm::dmat4 &proyeccion : {paralelaQueEncierra(envolvente, camara, r, escala),
                                                     perspectivaQueEncierra(envolvente, camara, r)})
                    EXPECT_LE(masCercaDelBorde(camara, proyeccion, r, puntos), 1 / 1.06 + 1e-6)
                        << distancia << " " << azimut << " " << elevacion;
            }
}

// Hacia dónde van los ejes del mundo en cada vista: (derecha, arriba) de X, Y y Z.
TEST(Encuadre, LasDireccionesDeLasVistas) {
    const double x = std::sqrt(0.5), y = std::sqrt(1.0 / 6), k = std::sqrt(2.0 / 3);
    const double esperados[N_VISTAS][3][2] = {
        {{1, 0}, {0, 1}, {0, 0}},   // alzado
        {{1, 0}, {0, 0}, {0, -1}},  // planta
        {{0, 0}, {0, 1}, {-1, 0}},  // perfil derecho
        {{x, -y}, {0, k}, {-x, -y}} // (1,1,1): a 120° y del mismo largo
    };
    for (int v = 0; v < N_VISTAS; ++v)
        for (int eje = 0; eje < 3; ++eje)
            for (int k2 = 0; k2 < 2; ++k2)
                EXPECT_NEAR(camaraVista(VISTAS[v])[eje][k2], esperados[v][eje][k2], 1e-15) << v << " " << eje;
}

// De lejos, lo cercano se distingue de lo lejano: dos caras a un centímetro tienen profundidades distintas en 24 bits aunque la
// GPU yerre media docena de pasos.
TEST(Encuadre, LaProfundidadBastaTambienDeLejos) {
    const std::vector<glm::dvec3> envolvente = envolventeGrua();
    for (double distancia : {26.0, 65.0}) {
        const Vista vista = {"", glm::dvec3(distancia / std::sqrt(3.0)), {0, 1, 0}, {}};
        const glm::dmat4 camara = camaraVista(vista),
                         proyeccion = perspectivaQueEncierra(envolvente, camara, {0, 0, 240, 180});
        const auto pasos = [&](double d) {
            const glm::dvec4 r = proyeccion * glm::dvec4(0, 0, -d, 1);
            return (0.5 * r.z / r.w + 0.5) * 16777215;
        };
        for (double d = distancia - 8; d < distancia + 8; d += 0.5)
            EXPECT_GT(pasos(d + 0.01) - pasos(d), 2500) << distancia << " " << d;
    }
}

namespace {

const Postura INICIAL = {0.58, 5, 4};

/// La envolvente de vistas_grua.h, escrita otra vez: la losa y, en lo alto del brazo y en los de la carga, un polígono de 64
/// lados alrededor de lo que más se aleja. (Pie y contrapeso quedan entre ellas.)
std::vector<Vec3> envolvente() {
    std::vector<Vec3> puntos;
    const double brazo = std::hypot(7.5, 0.4), carga = std::hypot(7.5, 0.5);
    for (const double x : {-5.25, 5.25})
        for (const double z : {-5.25, 5.25})
            puntos.push_back({x, -0.3, z});
    for (const auto &[y, radio] : {std::pair(0.0, carga), {9.5, carga}, {10.0, brazo}, {10.8, brazo}})
        for (int i = 0; i < 64; ++i) {
            const double r = radio / std::cos(oraculo::PI / 64), a = i * oraculo::PI / 32;
            puntos.push_back({r * std::cos(a), y, r * std::sin(a)});
        }
    return puntos;
}

/// La cámara de una vista en un recuadro de ancho × alto píxeles. `escala`: la común de varias vistas.
oraculo::Camara camaraDe(int vista, bool enPerspectiva, int ancho, int alto, double distancia = 26,
                         double escala = 0) {
    const Vec3 centro{0, 4.7, 0}, hacia[] = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, unitario(Vec3{1, 1, 1})};
    const Vec3 arriba = vista == PLANTA ? Vec3{0, 0, -1} : Vec3{0, 1, 0};
    oraculo::Camara c = oraculo::miraDesde(centro + distancia * hacia[vista], centro, arriba);
    Vec3 minimo{1e9, 1e9, 1e9}, maximo{-1e9, -1e9, -1e9};
    double tangente = 0;
    const double lado = oraculo::altoUtil(ancho, alto);
    for (const Vec3 &p : envolvente()) {
        const Vec3 q = enCamara(c, p);
        minimo = {std::min(minimo.x, q.x), std::min(minimo.y, q.y), std::min(minimo.z, q.z)};
        maximo = {std::max(maximo.x, q.x), std::max(maximo.y, q.y), std::max(maximo.z, q.z)};
        tangente =
            std::max({tangente, std::fabs(q.y / q.z) * lado / alto, std::fabs(q.x / q.z) * lado / ancho});
    }
    if (enPerspectiva)
        return perspectiva(c, 2 * std::atan(1.06 * tangente), 1, 1000);
    if (escala == 0)
        escala = 1.06 * std::max((maximo.x - minimo.x) / ancho, (maximo.y - minimo.y) / alto);
    const oraculo::Ejes e = ejes(c);
    const Vec3 descentra = 0.5 * (minimo.x + maximo.x) * e.x + 0.5 * (minimo.y + maximo.y) * e.y;
    c.ojo = c.ojo + descentra, c.centro = c.centro + descentra;
    return paralela(c, 0.5 * escala * lado, -1000, 1000);
}

oraculo::ImagenRef referencia(const oraculo::Camara &camara, const Postura &postura, int ancho, int alto) {
    const glm::vec3 colores[] = {SUELO, AMARILLO, AMARILLO, GRIS, OSCURO, ROJO};
    oraculo::Escena escena;
    for (const Mat4 &M : cajasGrua(postura))
        escena.push_back(oraculo::caja(M));
    return render(escena, camara, ancho, alto, [&](const oraculo::Impacto &i) -> Vec3 {
        return i ? luzExacta(i.normal) * vec3De(colores[i.objeto]) : vec3De(CIELO);
    });
}

/// Compara el recuadro `r` de la imagen, menos el cuadrado de los ejes (un tercio del lado menor del panel), con la referencia.
oraculo::Comparacion comparaRecuadro(const Imagen &imagen, const Recuadro &r, int altoPanel,
                                     oraculo::ImagenRef ref) {
    const Imagen trozo = recorta(imagen, {r.x, r.y, r.ancho, r.alto});
    const int ejes = std::min(r.ancho, altoPanel) / 3;
    daPorBuenos(ref, trozo, [ejes, altoEscena = r.alto](int x, int y) {
        return (x < ejes && y < ejes) || y > altoEscena - 4;
    }); // y lo que baje el rótulo
    return compara(trozo, ref);
}

/// En el interior, a un nivel. En los bordes, la GPU redondea los vértices a 1/256 de píxel y mueve un lado
/// √2/256 como mucho: difieren a lo sumo 2·√2/256 = 1/90 de los píxeles de borde. (Y como no se descartan caras
/// traseras, uno de ellos puede enseñar la de detrás, de un color que no tiene ningún vecino.)
void bienDibujada(const oraculo::Comparacion &c, int pixeles) {
    EXPECT_LE(c.maximo, 1) << c;
    EXPECT_LE(c.bandaDistintos, c.banda / 90) << c;
    EXPECT_GT(c.interior, pixeles / 2) << c;
}

/// Ejecuta, comprueba una vista entera contra el oráculo y devuelve su imagen.
Imagen compruebaVista(const std::string &programa, const std::string &guion, int vista, bool enPerspectiva,
                      const Postura &postura, int ancho = 240, int alto = 180, double distancia = 26) {
    const Ejecucion e = ejecuta("ch04_vista3d/" + programa, guion, ancho, alto);
    EXPECT_EQ(e.estado, 0) << e.errores;
    const Recuadro r = sinRotulo({0, 0, ancho, alto});
    const oraculo::ImagenRef ref =
        referencia(camaraDe(vista, enPerspectiva, r.ancho, r.alto, distancia), postura, r.ancho, r.alto);
    const oraculo::Comparacion c = comparaRecuadro(e.imagen, r, alto, ref);
    std::cout << "vista " << vista << ": " << c << "\n";
    bienDibujada(c, r.ancho * r.alto);
    return e.imagen;
}

std::string veces(int n, const std::string &orden) {
    std::string guion;
    for (int i = 0; i < n; ++i)
        guion += orden + "; ";
    return guion;
}

} // namespace

TEST(GruaVistas, CadaVistaContraTrazadoDeRayos) {
    for (int v = 0; v < N_VISTAS; ++v)
        compruebaVista("grua_vistas", "tecla " + std::to_string(v + 1), v, false, INICIAL);
}

// La postura extrema, girada, y en una ventana apaisada y en otra alta.
TEST(GruaVistas, OtraPosturaYOtraVentana) {
    const std::string guion = veces(7, "tecla a") + veces(6, "tecla e") + veces(12, "tecla w") + "tecla 4";
    const Postura extrema = {0.58 + 0.7, 7, 9};
    compruebaVista("grua_vistas", guion, DIAGONAL, false, extrema, 300, 70);
    compruebaVista("grua_vistas", guion, DIAGONAL, false, extrema, 70, 200);
}

// Las cuatro a la vez, con la misma escala. En el sistema americano la planta va sobre el alzado y el perfil derecho a su
// derecha; en el europeo, la planta debajo y el perfil a su izquierda. Cada panel, con su nombre.
TEST(GruaVistas, LasCuatroContraTrazadoDeRayos) {
    const int columna[2][N_VISTAS] = {{0, 0, 1, 1}, {1, 1, 0, 0}},
              fila[2][N_VISTAS] = {{1, 0, 1, 0}, {0, 1, 0, 1}};
    const char32_t *const nombres[] = {U"Alzado", U"Planta", U"Perfil", U"(1,1,1)"};
    const glm::vec3 colores[] = {AZUL, VERDE, ROJO, OSCURO};
    for (const int europeo : {0, 1}) {
        const Ejecucion e = ejecuta("ch04_vista3d/grua_vistas", europeo ? "tecla u" : "", 482,
                                    360); // paneles de ancho par: el canto del pie no cae en centros de píxel
        ASSERT_EQ(e.estado, 0) << e.errores;
        double escala = 0;
        for (const bool mide : {true, false})
            for (int v = 0; v < N_VISTAS; ++v) {
                const Hueco h = hueco(columna[europeo][v], 2, fila[europeo][v], 2, 482, 360);
                const Recuadro r = sinRotulo(h);
                if (mide) {
                    const oraculo::Camara c = camaraDe(v, false, r.ancho, r.alto);
                    escala = std::max(escala, 2 * c.semilado / oraculo::altoUtil(r.ancho, r.alto));
                    continue;
                }
                const oraculo::ImagenRef ref =
                    referencia(camaraDe(v, false, r.ancho, r.alto, 26, escala), INICIAL, r.ancho, r.alto);
                const oraculo::Comparacion c = comparaRecuadro(e.imagen, r, h.alto, ref);
                std::cout << "vista " << v << ": " << c << "\n";
                bienDibujada(c, r.ancho * r.alto);
                const std::vector<Rotulo> rotulos = buscaRotulo(e.imagen, nombres[v], colores[v]);
                ASSERT_EQ(rotulos.size(), 1u) << v;
                EXPECT_TRUE(rotulos[0].x > h.x && rotulos[0].x < h.x + h.ancho) << v;
                EXPECT_TRUE(rotulos[0].y > r.y + r.alto && rotulos[0].y < h.y + h.alto) << v;
            }
    }
}

// En la esquina, cada eje va hacia donde debe, con su letra más allá de la punta.
TEST(GruaVistas, LosEjes) {
    const double x = std::sqrt(0.5), y = std::sqrt(1.0 / 6), k = std::sqrt(2.0 / 3);
    const double ejes[N_VISTAS][3][2] = {{{1, 0}, {0, 1}, {0, 0}},
                                         {{1, 0}, {0, 0}, {0, -1}},
                                         {{0, 0}, {0, 1}, {-1, 0}},
                                         {{x, -y}, {0, k}, {-x, -y}}};
    const char32_t *const letras[] = {U"X", U"Y", U"Z"};
    for (int v = 0; v < N_VISTAS; ++v) {
        const Ejecucion e = ejecuta("ch04_vista3d/grua_vistas", "tecla " + std::to_string(v + 1), 960, 720);
        ASSERT_EQ(e.estado, 0) << e.errores;
        for (int eje = 0; eje < 3; ++eje) { // el cuadrado es de 240 y abarca 4 unidades
            const auto lugar = [&](double t, int c) { return 120 + 60 * t * ejes[v][eje][c]; };
            EXPECT_LE(
                distanciaRotulo(e.imagen, letras[eje], COLOR_EJE[eje], lugar(1.35, 0), lugar(1.35, 1), 0.03),
                4 / 720.0)
                << v << " eje " << eje;
            if (ejes[v][eje][0] == 0 && ejes[v][eje][1] == 0)
                continue; // de punta
            EXPECT_TRUE(
                esColor(pixel(e.imagen, static_cast<int>(lugar(0.6, 0)), static_cast<int>(lugar(0.6, 1))),
                        COLOR_EJE[eje]))
                << v << " eje " << eje;
        }
    }
}

TEST(GruaVistas, ElMenuEsComoLasTeclas) {
    const std::pair<const char *, const char *> iguales[] = {{"Alzado", "tecla 1"},
                                                             {"Planta", "tecla 2"},
                                                             {"Perfil", "tecla 3"},
                                                             {"(1,1,1)", "tecla 4"},
                                                             {"Europeo o americano", "tecla u"}};
    for (const auto &[opcion, tecla] : iguales) {
        const Ejecucion menu = ejecuta("ch04_vista3d/grua_vistas", std::string("menu ") + opcion);
        EXPECT_EQ(menu.estado, 0) << menu.errores;
        EXPECT_EQ(menu.imagen.rgb, ejecuta("ch04_vista3d/grua_vistas", tecla).imagen.rgb) << opcion;
    }
    EXPECT_EQ(ejecuta("ch04_vista3d/grua_vistas", "tecla 2; menu Las cuatro").imagen.rgb,
              ejecuta("ch04_vista3d/grua_vistas").imagen.rgb);
}

// Las dos proyecciones con la MISMA cámara (camaraDe la construye igual) contra el oráculo.
TEST(GruaProyeccion, LasDosContraTrazadoDeRayos) {
    const Imagen paralela = compruebaVista("grua_proyeccion", "", DIAGONAL, false, INICIAL);
    compruebaVista("grua_proyeccion", "tecla p", DIAGONAL, true, INICIAL);
    EXPECT_EQ(ejecuta("ch04_vista3d/grua_proyeccion", "menu Paralela o perspectiva; tecla p").imagen.rgb,
              paralela.rgb);
}

TEST(GruaProyeccion, CadaVistaEnPerspectiva) {
    for (int v = 0; v < 3; ++v)
        compruebaVista("grua_proyeccion", "tecla p; tecla " + std::to_string(v + 1), v, true, INICIAL);
}

// Cada tecla de la grúa, con lo que debe mover: la carga sube con w, baja con s, se aleja con e, se acerca con q y el brazo gira
// con a (a izquierdas visto desde arriba) y con d.
TEST(GruaProyeccion, LasTeclasDeLaGrua) {
    const std::pair<const char *, Postura> casos[] = {
        {"tecla w; tecla w", {0.58, 5, 5}}, {"tecla s; tecla s", {0.58, 5, 3}},
        {"tecla e; tecla e", {0.58, 6, 4}}, {"tecla q; tecla q", {0.58, 4, 4}},
        {"tecla a; tecla a", {0.78, 5, 4}}, {"tecla d; tecla d", {0.38, 5, 4}},
    };
    for (const char *programa : {"grua_vistas", "grua_proyeccion", "grua_zbuffer"})
        for (const auto &[guion, postura] : casos) {
            const bool enPerspectiva = std::string(programa) == "grua_zbuffer";
            compruebaVista(programa, std::string(guion) + "; tecla 4", DIAGONAL, enPerspectiva, postura);
        }
}

// Lo que se ve lleva su nombre.
TEST(GruaProyeccion, LosRotulos) {
    EXPECT_EQ(
        buscaRotulo(ejecuta("ch04_vista3d/grua_proyeccion", "", 480, 360).imagen, U"(1,1,1) paralela", OSCURO)
            .size(),
        1u);
    EXPECT_EQ(buscaRotulo(ejecuta("ch04_vista3d/grua_proyeccion", "tecla p; tecla 1", 480, 360).imagen,
                          U"Alzado perspectiva", AZUL)
                  .size(),
              1u);
}

// Acercar la cámara: en paralela no cambia nada; en perspectiva la grúa sigue entera, hasta los topes de la rueda.
TEST(GruaProyeccion, LaRuedaNoCortaLaGrua) {
    EXPECT_EQ(ejecuta("ch04_vista3d/grua_proyeccion", veces(3, "rueda +1 9 9")).imagen.rgb,
              ejecuta("ch04_vista3d/grua_proyeccion").imagen.rgb);
    compruebaVista("grua_proyeccion", veces(3, "rueda +1 9 9") + "tecla p", DIAGONAL, true, INICIAL, 240, 180,
                   26 / std::pow(1.1, 3));
    compruebaVista("grua_proyeccion", veces(40, "rueda +1 9 9") + "tecla p", DIAGONAL, true, INICIAL, 240,
                   180, 0.4 * 26);
    compruebaVista("grua_zbuffer", veces(40, "rueda -1 9 9"), DIAGONAL, true, INICIAL, 240, 180, 2.5 * 26);
}

// Con eliminación de partes ocultas, lo que ve el rayo; en varias posturas, con la carga delante y detrás del pie.
TEST(GruaZBuffer, OrdenDeVisibilidadContraTrazadoDeRayos) {
    compruebaVista("grua_zbuffer", "", DIAGONAL, true, INICIAL);
    const std::string cerca = veces(7, "tecla q");
    compruebaVista("grua_zbuffer", cerca + veces(14, "tecla d"), DIAGONAL, true, {0.58 - 1.4, 1.5, 4});
    compruebaVista("grua_zbuffer", cerca + veces(18, "tecla a") + "tecla p", DIAGONAL, false,
                   {0.58 + 1.8, 1.5, 4});
}

// Sin ella gana lo último que se pinta, que es el suelo: lo tapa todo, también lo que está delante.
TEST(GruaZBuffer, SinTestElSueloLoTapaTodo) {
    const Ejecucion sin = ejecuta("ch04_vista3d/grua_zbuffer", "tecla z"),
                    con = ejecuta("ch04_vista3d/grua_zbuffer");
    ASSERT_EQ(sin.estado, 0) << sin.errores;
    const Recuadro r = sinRotulo({0, 0, 240, 180});
    const int ancho = r.ancho, alto = r.alto, ejes = 60;
    const oraculo::Camara camara = camaraDe(DIAGONAL, true, ancho, alto);
    const oraculo::Escena suelo = {oraculo::caja(cajasGrua(INICIAL)[0])};
    const oraculo::ImagenRef ref = referencia(camara, INICIAL, ancho, alto);
    int deSuelo = 0, tapados = 0;
    for (int y = 0; y < alto; ++y)
        for (int x = 0; x < ancho; ++x) {
            if (x < ejes && y < ejes)
                continue;
            bool dentro = true; // más de un píxel dentro de la cara de arriba
            for (int k = 0; k < 4; ++k)
                dentro = dentro && primerImpacto(suelo, rayo(camara, ancho, alto, x + (k & 1 ? 2 : -1),
                                                             y + (k & 2 ? 2 : -1)))
                                           .normal.y > 0.5;
            if (!dentro)
                continue;
            ++deSuelo;
            const Pixel p = pixel(sin.imagen, x, y);
            ASSERT_TRUE(p.g > p.r && p.r > p.b) << x << "," << y;
            tapados += ref.en(x, y).objeto > 0;
        }
    std::cout << "suelo: " << deSuelo << " px, y en " << tapados << " debería verse la grúa\n";
    EXPECT_GT(tapados, 150);
    EXPECT_EQ(ejecuta("ch04_vista3d/grua_zbuffer", "tecla z; menu Con o sin partes ocultas").imagen.rgb,
              con.imagen.rgb);
}

// Lado a lado: a la izquierda sin el test y a la derecha con él, cada mitad con su rótulo.
TEST(GruaZBuffer, LadoALado) {
    const Ejecucion e = ejecuta("ch04_vista3d/grua_zbuffer", "tecla v", 640, 360);
    ASSERT_EQ(e.estado, 0) << e.errores;
    for (const int columna : {0, 1}) {
        const Hueco h = hueco(columna, 2, 0, 1, 640, 360);
        const Recuadro r = sinRotulo(h);
        const oraculo::ImagenRef ref =
            referencia(camaraDe(DIAGONAL, true, r.ancho, r.alto), INICIAL, r.ancho, r.alto);
        const oraculo::Comparacion c = comparaRecuadro(e.imagen, r, h.alto, ref);
        EXPECT_EQ(c.maximo <= 1, columna == 1) << c;
        const auto rotulos =
            buscaRotulo(e.imagen, columna ? U"(1,1,1) con Z-Buffer" : U"(1,1,1) sin Z-Buffer", OSCURO);
        ASSERT_EQ(rotulos.size(), 1u) << columna;
        EXPECT_TRUE(rotulos[0].x > h.x && rotulos[0].x < h.x + h.ancho) << columna;
    }
}
