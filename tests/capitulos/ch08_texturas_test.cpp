// Los programas del capítulo 8: cada uno contra su escena trazada con el oráculo, que la describe aquí por su cuenta,
// en doble precisión.
#include "ch08_oraculo.h"
#include "colores.h"
#include "contra_oraculo.h"
#include "guiones.h"
#include "imagenes.h"
#include "panel.h"
#include "tabla.h"

using namespace oraculo;

namespace {

double escalon(double desde, double hasta, double x) { // smoothstep
    const double u = std::clamp((x - desde) / (hasta - desde), 0.0, 1.0);
    return u * u * (3 - 2 * u);
}
void compruebaConMedia(const std::string &que, const Comparacion &c, const Cotas &cotas, double rmse) {
    comprueba(que, c, cotas);
    EXPECT_LE(c.rmse, rmse) << que;
}

// --- cubemap -----------------------------------------------------------------------------------------------

/// Las seis fotos, según su nombre: hacia dónde mira cada una quien está en el centro mirando a −Z con +Y arriba, y qué
/// tiene arriba. Las del cielo y el suelo se hacen echando atrás o adelante la cabeza. Y su casilla en el mapa
/// desplegado: de izquierda a derecha −X −Z +X +Z, con +Y encima de −Z y −Y debajo.
struct Foto {
    const char *nombre;
    Vec3 hacia, arriba;
    int columna, fila; // desde abajo
};
const Foto FOTOS[6] = {{"delante", {0, 0, -1}, {0, 1, 0}, 1, 1}, {"derecha", {1, 0, 0}, {0, 1, 0}, 2, 1},
                       {"detras", {0, 0, 1}, {0, 1, 0}, 3, 1},   {"izquierda", {-1, 0, 0}, {0, 1, 0}, 0, 1},
                       {"arriba", {0, 1, 0}, {0, 0, 1}, 1, 2},   {"abajo", {0, -1, 0}, {0, 0, -1}, 1, 0}};

/// En las fotos de prueba el color dice la dirección y cambia despacio, sin saltar de una a otra: filtrarlas no lo
/// cambia.
Vec3 colorDePrueba(const Vec3 &d) {
    return 0.5 * UNO + 0.45 * unitario(d);
}
/// Abarca 90 grados: en una ventana cuadrada, el alto útil es tres cuartos del suyo.
ImagenRef fotoDePrueba(const Foto &f, int lado) {
    return render({}, perspectiva(miraDesde({}, f.hacia, f.arriba), 2 * std::atan(0.75), 0, 1), lado, lado,
                  [](const Impacto &i) { return colorDePrueba(i.rayo.direccion); });
}

/// Mientras vive, los programas leen las fotos de prueba.
struct FotosDePrueba {
    const ConRaiz conRaiz{carpetaTemporal() / "fotos"};

    FotosDePrueba() {
        for (const Foto &f : FOTOS)
            escribe(enBytes(fotoDePrueba(f, 512)),
                    carpetaTemporal() / "fotos/assets" / (std::string("entorno_") + f.nombre + ".rgb"));
    }
};

const Mat4 GIRO_TORO = gira({0, 0, 1}, 0.35) * gira(X, -1.05);

/// Un toro de metal que lo refleja todo menos a sí mismo y, detrás, el fondo. No se compara de refilón, donde entre un
/// píxel y el siguiente lo reflejado cambia tanto que cuenta el nivel de mipmap.
Comparacion comparaReflejo(const Imagen &escena, const Objeto &toro, const Panel &panel, bool porVertice) {
    const auto sombrea = [&](const Impacto &i) -> Tono {
        const Vec3 &d = i.rayo.direccion;
        if (!i)
            return colorDePrueba(d);
        const auto reflejadaEn = [&](const VerticeRef &v) {
            return refleja(punto(toro.M, v.posicion) - panel.camara.ojo,
                           transformaNormal(toro.inv, v.normal));
        };
        const Vec3 R = porVertice ? interpola(toro, i, reflejadaEn) : refleja(d, i.normal);
        return {Vec3{0.97, 0.91, 0.80} * colorDePrueba(R), -escalar(d, i.normal) < 0.3 ? SIN_COMPARAR : 0};
    };
    return compara(recorta(escena, panel), render({toro}, panel, sombrea), 4);
}
Camara camaraCubemap(double azimut, double elevacion, double angulo = 0.75) {
    return perspectiva(orbita(azimut, elevacion, 4.7), angulo, 0.5, 100);
}

// El reflejo y el fondo desde cuatro sitios: si el entorno girase con la cámara, o una cara estuviera en otro sitio,
// del revés o en espejo, los colores serían otros. Con el mapa esférico, lo mismo, también donde acaba una vuelta y
// junto a los polos. Con la misma malla y con una cuatro veces más fina. Se pierden dos redondeos a 8 bits y lo que
// cambia el nivel de mipmap.
TEST(Cubemap, ReflejoYFondoContraTrazadoDeRayos) {
    const FotosDePrueba fotos;
    const struct {
        std::string guion;
        double azimut, elevacion;
    } casos[] = {
        {"", 0.35, 0.06},
        {arrastra({200, 100}, {400, 100}), 0.35 - 1, 0.06},
        {arrastra({200, 100}, {-160, 260}), 0.35 + 0.8, 0.06 + 0.8},
        {arrastra({200, 300}, {240, -100}), 0.35 + 0.6, 0.06 - 1.2},
        {"tecla e", 0.35 + 0.6, 0.06 - 1.2},
        {arrastra({200, 200}, {440, 730}), 0.35 - 0.6, 0.06 + 1.45},
        {arrastra({300, 300}, {-350, 10}), 3, 0.06},
        {arrastra({0, 100}, {530, 100}), 0.35, 0.06},
    };
    paraCada("cubemap", casos, 480, 360, [](const auto &c, const Vista &v) {
        const Panel panel(camaraCubemap(c.azimut, c.elevacion), v.escena);
        for (const Objeto &t :
             {malla(GIRO_TORO, toro(1, 0.5f, 90, 46)), malla(GIRO_TORO, toro(1, 0.5f, 360, 184))})
            compruebaConMedia(c.guion, comparaReflejo(v.escena, t, panel, false), {4}, 0.8);
    });
}

// Por vértice, la dirección que se interpola es la reflejada en cada vértice, y con pocas caras se nota.
TEST(Cubemap, PorVerticeYPorFragmento) {
    const FotosDePrueba fotos;
    const Imagen gpu = vistaDe("cubemap", "tecla c; tecla v", 720, 360).escena;
    const Objeto t = malla(GIRO_TORO, toro(1, 0.5f, 12, 6));
    for (const bool porVertice : {false, true}) {
        const Panel panel(camaraCubemap(0.35, 0.06, 0.47), gpu, porVertice, 2, 2);
        compruebaConMedia("por vértice y por fragmento", comparaReflejo(gpu, t, panel, porVertice), {4}, 0.8);
        EXPECT_GT(comparaReflejo(gpu, t, panel, !porVertice).rmse, 2);
    }
}

// El mapa desplegado: en cada casilla, su foto, derecha; y en el esférico, el punto, donde mira la cámara.
TEST(Cubemap, Desplegado) {
    const FotosDePrueba fotos;
    const int lado = 228; // con una raya entre cada dos casillas
    const Imagen gpu = vistaDe("cubemap", "tecla v; tecla c", 960, 720).escena;
    for (const Foto &f : FOTOS) {
        const Hueco h{480 + lado * (f.columna - 2), 18 + lado * f.fila, lado - 1, lado - 1};
        comprueba(f.nombre, recorta(gpu, h), fotoDePrueba(f, lado - 1), {3});
    }
    const Pintado mira = vistaDe("cubemap", "tecla e; tecla c", 240, 180).encima.trazos(ROJO, "puntos").at(0);
    const glm::dvec2 uv = (mira.punto(0) - glm::dvec2(mira.panel)) / glm::dvec2(mira.panel.z, mira.panel.w);
    EXPECT_LT(glm::distance(uv, 0.5 - glm::dvec2(0.35 / 2, 0.06) / glm::pi<double>()), 1e-3) << "mira";
}

// La ecuación 8.1 no es la tabla de OpenGL: con x positiva intercambia las dos coordenadas y les da la vuelta, un
// espejo; con x negativa, gira la cara un cuarto de vuelta.
TEST(Erratas, Ecuacion81) {
    for (const double x : {1.0, -1.0})
        for (const double y : {-0.7, 0.1, 0.6})
            for (const double z : {-0.4, 0.2, 0.9}) {
                const double u = (y + x) / (2 * x), v = (z + x) / (2 * x);
                // la especificación (2.1, tabla 3.19): en las dos caras sc/|x| es −z/x, y tc, −y
                const double s = (-z / x + 1) / 2, t = (-y / std::fabs(x) + 1) / 2;
                EXPECT_NEAR(u, x > 0 ? 1 - t : t, 1e-15);
                EXPECT_NEAR(v, 1 - s, 1e-15);
            }
}

// --- enrejado ----------------------------------------------------------------------------------------------

// Los barrotes de fuera, los de detrás vistos por dentro, iluminados con la normal opuesta, y el fondo: cada uno, una
// zona. Cada talla manda en su coordenada: con una de las dos a 1 la esfera está entera; menos de 0.05 no llegan a ser.
TEST(Enrejado, HuecosContraFract) {
    const Material fuera{0.22 * exacto(NARANJA), 0.80 * exacto(NARANJA), 0.55 * UNO, 50},
        dentro{0.25 * exacto(AZUL), 0.80 * exacto(AZUL), {}, 1};
    const auto resto = [](double x) { return x - std::floor(x); };
    const struct {
        std::string guion;
        double tallaS, tallaT, azimut = 0.1, elevacion = 1.55; // los polos, en ±Y
        int veces = 12;                                        // en t; en s, el doble
    } casos[] = {
        {"", 0.35, 0.35, 0.4, 0.35},
        {"tecla a ×5; tecla w ×2", 0.1, 0.45, 0.4, 0.35},
        {"tecla d ×2; tecla x ×5", 0.2, 0.2, 0.4, 0.35},
        {veces(10, "tecla +"), 0.7, 0.7, 0.4, 0.35},
        {arrastra({100, 100}, {140, 500}), 0.7, 0.7},
        {veces(9, "tecla +"), 1, 1},
        {"tecla a ×21", 0.05, 1},
        {"tecla d ×3; tecla x ×21", 0.2, 0.05},
        {veces(4, "tecla -"), 0.05, 0.05},
        {"tecla + ×6; tecla n ×8", 0.35, 0.35, 0.1, 1.55, 4},
        {"tecla b ×99; tecla n", 0.35, 0.35, 0.1, 1.55, 23},
    };
    paraCada("enrejado", casos, 320, 240, [&](const auto &c, const Vista &v) {
        const Camara camara = perspectiva(orbita(c.azimut, c.elevacion, 6), 0.4, 1, 100);
        const Escena bola = {malla(DE_PIE, esfera(segmentosEsfera(400)))};
        const Comparacion d = compara(v.escena, bola, camara, [&](const Impacto &visto) -> Tono {
            for (const Impacto &i : impactos(bola, visto.rayo))
                if (resto(2 * c.veces * i.s) <= c.tallaS || resto(c.veces * i.t) <= c.tallaT)
                    return {phong(i.frente ? fuera : dentro, UNO, {posicional({-4, 6, 5})}, i.punto,
                                  i.frente ? i.normal : -i.normal, haciaOjo(i)),
                            1 + i.frente};
            return exacto(FONDO_CLARO);
        });
        compruebaConMedia(c.guion, d, MISMA_MALLA, 0.6);
    });
}

// --- textura3d ---------------------------------------------------------------------------------------------
using Texels = std::vector<unsigned char>;

/// De qué color es el bloque en p: madera (0), mármol (1) o el ruido tal cual (2). Con el ruido S2 veces mayor, anillos
/// y vetas se tuercen S2 veces más.
Vec3 colorBloque(int elegido, const Texels &texels, const Vec3 &p, double S2) {
    const auto ruido = [&](double escala, double corre) {
        return definicion::trilineal(texels, escala * p + Vec3{corre, corre, corre});
    };
    if (elegido == 0) {
        const double x = p.x + 0.08 * p.y + 0.22 * S2 * (ruido(0.4, 0) - 0.5) + 0.22,
                     z = p.z + 0.08 * p.y + 0.22 * S2 * (ruido(0.4, 0.5) - 0.5) + 0.10,
                     r = 13 * std::hypot(x, z), anillo = r - std::floor(r),
                     tardia = anillo * anillo * (1 - escalon(0.86, 1, anillo)),
                     hebras = definicion::trilineal(texels, Vec3{6 * p.x, 0.35 * p.y, 6 * p.z});
        return mezcla({0.87, 0.63, 0.37}, {0.48, 0.25, 0.11},
                      std::clamp(1.15 * tardia + 0.9 * (hebras - 0.45), 0.0, 1.0));
    }
    if (elegido == 1) {
        const double torcido = S2 * (ruido(0.35, 0) + 0.4 * ruido(0.9, 0.3)),
                     onda = std::fabs(std::sin(5 * (p.x + 0.7 * p.y + 0.4 * p.z) + 6 * torcido)),
                     veta = std::pow(1 - onda, 3) * escalon(0.25, 0.65, ruido(0.7, 0.6));
        const Vec3 fondo =
            mezcla({0.97, 0.96, 0.94}, {0.74, 0.77, 0.82}, escalon(0.35, 0.75, ruido(0.3, 0.25)));
        return mezcla(fondo, {0.24, 0.28, 0.34}, std::min(1.2 * veta, 1.0));
    }
    return S2 * ruido(1, 0) * UNO;
}

/// El nivel siguiente de mipmap: cada texel, la media de ocho.
Texels mitad(const Texels &texels) {
    Texels menores;
    for (int i = 0; i < 32 * 32 * 32; ++i) {
        int suma = 0;
        for (const int salto : {0, 1, 64, 65, 4096, 4097, 4160, 4161})
            suma += texels[2 * (i % 32) + 128 * (i / 32 % 32) + 8192 * (i / 1024) + salto];
        menores.push_back(static_cast<unsigned char>(std::lround(suma / 8.0)));
    }
    return menores;
}

// El bloque y el peón de cada material: trilineal en los puntos del bloque, por Phong. Se compara donde la textura se
// amplía y, si el bloque se ve de frente, también en él, donde todos los texels abarcan lo mismo: con su nivel de
// mipmap, que cuesta otro medio nivel. `detalle`: las veces que el material más repite la textura. S1 y S2 no pasan de
// sus topes.
TEST(Textura3d, CadaMaterialContraTrazadoDeRayos) {
    const Texels texels = definicion::textura3d(), niveles[] = {texels, mitad(texels)};
    const auto pieza = [](const Vec3 &donde, const Vec3 &talla) { // el eje, hacia +Y
        return traslada(donde) * DE_PIE * escala(talla);
    };
    const int n = segmentosEsfera(250);
    const Malla anillo = toro(0.42f, 0.14f, n, n / 2);
    const Escena mallas = {caja(pieza({-1.15, 0, 0}, {1.5, 1.5, 2.6})),
                           enElMundo(pieza({1.15, -1.19, 0}, {0.85, 0.85, 0.22}), cilindro(n)),
                           enElMundo(pieza({1.15, -1.08, 0}, {0.74, 0.74, 2.1}), cono(n)),
                           enElMundo(pieza({1.15, 0.78, 0}, {0.52, 0.52, 0.52}), esfera(n)),
                           enElMundo(pieza({1.15, -1.0, 0}, {1.45, 1.45, 1}), anillo),
                           enElMundo(pieza({1.15, 0.28, 0}, {0.85, 0.85, 0.6}), anillo)};
    const struct {
        std::string guion;
        int elegido;
        double S1, S2 = 1, detalle = 1, azimut = 0.45, elevacion = 0.32;
    } casos[] = {
        {"tecla 3", 2, 0.5},
        {"tecla 2", 1, 0.5},
        {"tecla 1; " + veces(3, "tecla -"), 0, 0.125, 1, 6},
        {"tecla a ×9", 0, 0.125, 0, 6},
        {"tecla +; tecla 2", 1, 0.25, 0},
        {"tecla d ×9", 1, 0.25, 2},
        {"tecla 3; tecla a ×5", 2, 0.25, 0.75},
        {"tamano 240 180; tecla d; " + arrastra({100, 100}, {145, 68}) + "; " + veces(5, "tecla +"), 2, 2, 1,
         1, 0, 0},
    };
    paraCada("textura3d", casos, 480, 360, [&](const auto &c, const Vista &v) {
        const Panel panel(perspectiva(orbita(c.azimut, c.elevacion, 9.9, {0.05, 0, 0}), 0.4, 1, 100),
                          v.escena);
        const ImagenRef ref = render(mallas, panel, [&](const Impacto &i) -> Tono {
            if (!i)
                return exacto(FONDO_CLARO);
            const double coseno = escalar(haciaOjo(i), i.normal),
                         pixel = tallaPixel(panel.camara, v.escena.ancho, v.escena.alto, i.punto);
            const bool amplia = 64 * c.S1 * c.detalle * pixel < coseno,
                       deFrente = c.azimut == 0 && coseno > 0.97;
            const Vec3 color = colorBloque(c.elegido, niveles[!amplia], c.S1 * i.punto, c.S2);
            const Material m{0.35 * color, 0.75 * color, (c.elegido == 1 ? 0.45 : 0.15) * UNO, 40};
            return {phong(m, UNO, {posicional({-3, 6, 8})}, i.punto, i.normal, haciaOjo(i)),
                    amplia || deFrente ? 0 : SIN_COMPARAR};
        });
        compruebaConMedia(c.guion, compara(v.escena, ref), {1.2}, 0.5);
    });
}

// --- bump --------------------------------------------------------------------------------------------------
/// Altura del bulto que se repite en (s, t), en lados del mapa: mapa_normales.h dice el radio y la altura.
double alturaBulto(double s, double t) {
    const double u = (s - std::floor(s) - 0.5) / 0.42, v = (t - std::floor(t) - 0.5) / 0.42,
                 q = 1 - u * u - v * v;
    return q > 0 ? 0.15 * q * q : 0;
}

enum { SUELO_BUMP, BOLA_BUMP };
const Vec3 CENTRO_BUMP{0, 0.25, 0}, EJE_BUMP{std::cos(0.3), 0, -std::sin(0.3)}; // de polo a polo, a los lados
const Escena ESCENA_BUMP = {
    plano(traslada({0, -1, 0}) * DE_PIE * escala({2.8, 2.8, 1})),
    esfera(traslada(CENTRO_BUMP) * gira({0, 1, 0}, PI / 2 + 0.3) * escala({1.25, 1.25, 1.125}))};

/// La de la superficie desplazada de verdad, P + h·N, por diferencias.
Vec3 normalDesplazada(const Impacto &i) {
    const Objeto &o = ESCENA_BUMP[i.objeto];
    const auto desplazada = [&](double s, double t) {
        const bool bola = i.objeto == BOLA_BUMP;
        const double a = PI * t, b = 2 * PI * s,
                     h = bola ? 0.36 * alturaBulto(20 * s, 10 * t) : 0.4 * alturaBulto(7 * s, 7 * t);
        const Vec3 p = bola ? Vec3{std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), -std::cos(a)}
                            : Vec3{s - 0.5, t - 0.5, 0};
        return punto(o.M, p) + h * transformaNormal(o.inv, bola ? p : Vec3{0, 0, 1});
    };
    const double d = 1e-5;
    const Vec3 n = unitario(vectorial(desplazada(i.s + d, i.t) - desplazada(i.s - d, i.t),
                                      desplazada(i.s, i.t + d) - desplazada(i.s, i.t - d)));
    return escalar(n, i.normal) < 0 ? -n : n;
}
const Camara CAMARA_BUMP = perspectiva(orbita(0.3, 0.5, 8.8, {0, -0.25, 0}), 0.45, 1, 100);

// En cada objeto, la luz sobre la superficie desplazada de verdad (con su normal, en el punto sin desplazar). En el
// plano no hay más error que el mapa de 8 bits y su filtro; en la bola, además, lo que §8.4 desprecia: que al alejarse
// de ella, h, la superficie se agranda (h llega al 5 % del radio). De refilón, el mipmap alisa.
TEST(Bump, LaLuzDeLaSuperficieDesplazada) {
    const Material material[2] = {{{0.17, 0.20, 0.24}, {0.50, 0.58, 0.68}, {0.20, 0.20, 0.20}, 20},
                                  {{0.26, 0.14, 0.09}, {0.80, 0.42, 0.26}, {0.40, 0.40, 0.40}, 40}};
    const struct {
        std::string guion;
        std::vector<bool> conBultos; // en cada panel
    } casos[] = {{"", {true}},
                 {"tecla b", {false}},
                 {"tecla v; tamano 2565 960", {false, true}},
                 {"tecla b; tamano 1280 960", {true}}};
    const double maximo[2][2] = {{2, 2}, {6, 25}},
                 rmse[2][2] = {{0.5, 0.5}, {0.9, 1.3}}; // sin el mapa y con él
    paraCada("bump", casos, 1280, 960, [&](const auto &c, const Vista &v) {
        const int paneles = int(c.conBultos.size());
        for (int k = 0; k < paneles; ++k) {
            const bool con = c.conBultos[k];
            const Panel panel(CAMARA_BUMP, v.escena, k, paneles, paneles);
            const ImagenRef ref = render(ESCENA_BUMP, panel, [&](const Impacto &i) -> Tono {
                const bool bola = i.objeto == BOLA_BUMP;
                if (!i || (bola && (escalar(haciaOjo(i), i.normal) < 0.3 ||
                                    std::fabs(escalar(i.punto - CENTRO_BUMP, EJE_BUMP)) > 1.09)))
                    return {{}, SIN_COMPARAR};
                return phong(material[bola], UNO, {posicional({-4, 5, 4})}, i.punto,
                             con ? normalDesplazada(i) : i.normal, haciaOjo(i));
            });
            for (const int objeto : {SUELO_BUMP, BOLA_BUMP}) {
                ImagenRef solo = ref;
                for (PixelRef &p : solo.pixeles)
                    p.zona = p.objeto == objeto ? p.zona : SIN_COMPARAR;
                compruebaConMedia(objeto == BOLA_BUMP ? "bola" : "suelo",
                                  compara(recorta(v.escena, panel), solo),
                                  {maximo[con][objeto], con ? 0 : 500}, rmse[con][objeto]);
            }
        }
    });
}

// --- bump_ruido --------------------------------------------------------------------------------------------
const Vec3 HACIA_SOL = unitario({0.1219, 0.0975, -0.9877});

Vec3 cielo(const Vec3 &d) {
    const double sol = std::max(escalar(d, HACIA_SOL), 0.0);
    Vec3 c = mezcla({1.00, 0.62, 0.30}, {0.74, 0.42, 0.50}, escalon(0, 0.22, d.y));
    c = mezcla(c, {0.14, 0.20, 0.44}, escalon(0.10, 0.65, d.y));
    c = c + (0.45 * std::pow(sol, 24) + 0.5 * std::pow(sol, 400)) * Vec3{1, 0.55, 0.20};
    c = mezcla(c, {1, 0.95, 0.75}, escalon(0.9990, 0.9993, sol));
    const double llano = std::hypot(d.x, d.z),
                 cumbre = 0.055 + 0.07 * definicion::turbulencia({3 * d.x / llano, 3 * d.z / llano, 0.5}, 3);
    const Vec3 colina = mezcla({0.42, 0.26, 0.30}, {0.13, 0.11, 0.20}, escalon(0, 0.09, d.y));
    return mezcla(colina, c, escalon(-0.002, 0.002, d.y - cumbre));
}
/// Lo que se ve en una dirección desde `ojo`; la inclinación de las olas, por diferencias.
Vec3 lago(const Vec3 &ojo, const Vec3 &d, double tiempo) {
    if (d.y >= 0)
        return cielo(d);
    const double lejos = -ojo.y / d.y, h = 1e-5;
    const double x = ojo.x + lejos * d.x, z = ojo.z + lejos * d.z;
    const auto ola = [&](double a, double b) {
        return definicion::turbulencia({0.55 * a, 0.55 * b, tiempo}, 4, {0, 0, 64});
    };
    const double alisa = 0.10 / (1 + 0.0012 * lejos * lejos);
    const Vec3 N = unitario({-alisa * (ola(x + h, z) - ola(x - h, z)) / (2 * h), 1,
                             -alisa * (ola(x, z + h) - ola(x, z - h)) / (2 * h)});
    // el agua llana devolvería el rayo con la altura −d.y: si va una décima por debajo empieza a dar en otras olas, y
    // si va tres, da siempre; de refilón, con −d.y pequeña, eso es hacia abajo
    Vec3 R = refleja(d, N);
    const double alCielo = 1 - escalon(0.1, 0.3, -d.y - R.y);
    R.y = std::max(R.y, 0.0);
    const double fresnel = 0.02 + 0.98 * std::pow(1 - std::clamp(-escalar(d, N), 0.0, 1.0), 5);
    const Vec3 agua = mezcla({0.02, 0.10, 0.16}, {0.05, 0.24, 0.28}, std::clamp(0.5 + ola(x, z), 0.0, 1.0));
    return mezcla(agua, cielo(R), fresnel * alCielo) +
           alCielo * 0.8 * std::pow(std::max(escalar(R, HACIA_SOL), 0.0), 300) * Vec3{1, 0.75, 0.45};
}

// El lago en doble. Donde lo que se ve cambia deprisa (olas lejanas, contorno de las colinas) cuenta la última cifra
// del float: se apartan los píxeles cuyo color cambia al moverse una centésima de píxel. El tiempo se para, sigue donde
// estaba y se repite a los 160 s: 64 celdas a 0.4 por segundo.
TEST(BumpRuido, ContraElLagoEnDoble) {
    const struct {
        std::string guion;
        double segundos, azimut, elevacion;
    } casos[] = {
        {"", 0, 0, 0.13},
        {"espera 2000", 2, 0, 0.13},
        {"tecla Espacio; espera 2000", 2, 0, 0.13},
        {"tecla Espacio; espera 2000; tamano 100 40", 4, 0, 0.13},
        {"tecla Espacio; " + veces(311, "tecla t"), 159.5, 0, 0.13},
        {"tecla t; tamano 80 60", 0, 0, 0.13},
        {arrastra({50, 40}, {70, 10}), 0, -0.6, 0.02},
    };
    paraCada("bump_ruido", casos, 80, 60, [](const auto &c, const Vista &v) {
        const Panel panel(perspectiva(orbita(c.azimut, c.elevacion, 12, {0, 0.6, 0}), 0.75, 1, 100),
                          v.escena);
        const ImagenRef ref = render({}, panel, [&](const Impacto &i) -> Tono {
            const Vec3 &d = i.rayo.direccion, &ojo = panel.camara.ojo;
            const auto ve = [&](const Vec3 &hacia) { return lago(ojo, unitario(hacia), 0.4 * c.segundos); };
            const double centesima = 0.01 * tallaPixel(panel.camara, v.escena.ancho, v.escena.alto, ojo + d);
            const bool deprisa = longitud(ve(d + centesima * X) - ve(d)) > 0.004 ||
                                 longitud(ve(d + centesima * Y) - ve(d)) > 0.004;
            return {ve(d), deprisa ? SIN_COMPARAR : 0};
        });
        compruebaConMedia(c.guion, compara(v.escena, ref), {1}, 0.6);
    });
}

// --- desplazamiento ----------------------------------------------------------------------------------------
double alturaIslaExacta(double s, double t) {
    const double r = 2.1 * std::hypot(s - 0.5, t - 0.5), isla = escalon(0, 1, 1 - r);
    return std::clamp(isla * (0.62 + 0.75 * definicion::turbulencia({5 * s, 5 * t, 2.5}, 6)), 0.0, 1.0);
}
Vec3 colorIsla(double h) {
    Vec3 c = mezcla({0.16, 0.42, 0.66}, {0.88, 0.79, 0.55}, escalon(0.004, 0.012, h));
    c = mezcla(c, {0.34, 0.55, 0.20}, escalon(0.04, 0.09, h));
    c = mezcla(c, {0.47, 0.42, 0.38}, escalon(0.30, 0.48, h));
    return mezcla(c, {0.97, 0.98, 1.00}, escalon(0.56, 0.68, h));
}

/// El plano desplazado con amplitud 1, con las normales de las alturas de sus vecinos.
Malla islaDeAmplitudUno() {
    Malla m = plano(192);
    const double paso = 1.0 / 192;
    for (Vertice &v : m.vertices) {
        const double s = v.coordTextura.x, t = v.coordTextura.y;
        v.posicion.z = float(alturaIslaExacta(s, t));
        v.normal = glm::dvec3(alturaIslaExacta(s - paso, t) - alturaIslaExacta(s + paso, t),
                              alturaIslaExacta(s, t - paso) - alturaIslaExacta(s, t + paso), 2 * paso);
    }
    return m;
}

// La isla con varias amplitudes, hasta sus topes: posiciones (el contorno y lo que tapa), normales y color. La playa es
// tan estrecha que su color se nota en la sexta cifra de la altura. Las caras que se ven de refilón, que asoman menos
// que un píxel, son zonas.
TEST(Desplazamiento, ContraLaMallaDesplazadaEnLaCpu) {
    const Malla unidad = islaDeAmplitudUno();
    const struct {
        std::string guion;
        double amplitud, azimut, elevacion;
    } casos[] = {
        {"", 0.35, 0.12, 0.5},
        {veces(9, "tecla +"), 0.5, 0.12, 0.5},
        {"tecla - ×2; " + arrastra({50, 60}, {150, -300}), 0.4, -0.38, 0.05},
        {veces(20, "tecla -") + "; " + arrastra({50, 60}, {-50, 134}), 0, 0.12, 0.42},
    };
    paraCada("desplazamiento", casos, 480, 360, [&](const auto &c, const Vista &v) {
        const double lado = 2, alto = lado * std::max(c.amplitud, 1e-6);
        const Escena escena = {enElMundo(DE_PIE * escala({lado, lado, alto}), unidad)};
        const Camara camara = perspectiva(orbita(c.azimut, c.elevacion, 4.1, {-0.07, 0.14, 0}), 0.5, 0.5, 50);
        const Comparacion d = compara(v.escena, escena, camara, [&](const Impacto &i) -> Tono {
            if (!i)
                return exacto(CIELO);
            const Vec3 color = colorIsla(i.punto.y / alto);
            return {phong({0.35 * color, 0.85 * color, 0.06 * UNO, 15}, UNO, {direccional({-3, 2.2, 1})},
                          i.punto, i.normal, haciaOjo(i)),
                    escalar(haciaOjo(i), i.normalCara) < 0.2 ? i.corte.triangulo : -1};
        });
        comprueba(c.guion, d, {0.6, 500, 0.012});
    });
}

} // namespace
