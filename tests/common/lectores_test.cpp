// Los lectores de common/: imágenes, mallas v/f y rutas. Lo bueno, y qué dicen de lo malo.
#include "ejecuta.h"
#include "error.h"
#include "imagen.h"
#include "malla.h"
#include "numero.h"
#include "rutas.h"
#include <locale>
#include <sys/resource.h>

namespace fs = std::filesystem;
using testing::ExitedWithCode;

namespace {

std::string escribe(const std::string &nombre, const std::string &contenido) {
    const std::string ruta = (carpetaTemporal() / nombre).string();
    std::ofstream(ruta, std::ios::binary) << contenido;
    return ruta;
}

/// Lo que se lee de cada contenido termina el programa con ese mensaje.
template<class Lee>
void esperaQueTermine(const Lee &lee, const std::string &nombre,
                      const std::vector<std::pair<std::string, const char *>> &casos) {
    for (const auto &[contenido, mensaje] : casos)
        EXPECT_EXIT(lee(escribe(nombre, contenido)), ExitedWithCode(1), mensaje) << contenido;
}

} // namespace

// numeroDe lee todos los números de ficheros, guiones y opciones: es todo el texto o no es.
TEST(Numero, SinNadaQueSobre) {
    for (const char *mal :
         {"", "-", "+1", " 1", "1 ", "1a", "0x10", "1.5", "1e2", "--1", "2147483648", "99999999999999999999"})
        EXPECT_FALSE(numeroDe<int>(mal)) << mal;
    for (const char *mal :
         {"", "-", "+1", " 1", "1 ", "1a", "0x10", "1.5.2", "1-2", "1,5", "1e", ".", "1e99999"})
        EXPECT_FALSE(numeroDe<double>(mal)) << mal;
    EXPECT_EQ(numeroDe<int>("-2147483648"), -2147483647 - 1);
    EXPECT_EQ(numeroDe<double>("-1.5e-3"), -0.0015);
    EXPECT_FALSE(numeroDe<float>("1e300"));
}

// El fichero empieza por la fila de arriba; la imagen, por la de abajo. Anchura 3: no es múltiplo de 4.
TEST(LeeTextura, DaLaVueltaALasFilas) {
    const Imagen i = leeTextura(escribe("t.rgb", "abcdefghi"
                                                 "ABCDEFGHI"),
                                3, 2);
    EXPECT_EQ(std::string(i.rgb.begin(), i.rgb.end()), "ABCDEFGHIabcdefghi");
    const Imagen j = leePpm(escribe("dos.ppm", "P6 1 2 255\nabcDEF"));
    EXPECT_EQ(std::string(j.rgb.begin(), j.rgb.end()), "DEFabc");
}

// Lo demás se pide a todo programa (propiedades/dados.py). Un dispositivo no se acaba: hay un límite, y se dice.
TEST(LeeTextura, LoQueNoEsUnFicheroNiUnaTalla) {
    EXPECT_EXIT(leeTextura(carpetaTemporal().string(), 3, 2), ExitedWithCode(1), "es una carpeta");
    EXPECT_EXIT(leeTextura("/dev/zero", 3, 2), ExitedWithCode(1), "«/dev/zero» ocupa más de 256 MiB");
    EXPECT_EXIT(leeTextura("t.rgb", 0, 2), ExitedWithCode(1), "no hay texturas de 0×2");
}

TEST(Ppm, RechazaLoQueNoEntiende) {
    const char *const CABECERA = "la cabecera del PPM no es válida";
    esperaQueTermine([](const std::string &ruta) { leePpm(ruta); }, "mal.ppm",
                     {{"", "no es un PPM binario"},
                      {"P6 0 1 255\n", CABECERA},
                      {"P6 99999999 1 255\n", CABECERA},
                      {"P6 -1 1 255\n", CABECERA},
                      {"P6\n#", CABECERA},
                      {"P62 1 255\nabcdef", CABECERA},
                      {"P6 1 1 255Xabc", CABECERA},
                      {"P6 1 1 255", CABECERA},
                      {"P6 1 1 65535\nabcdef", "solo se leen PPM de 8 bits"},
                      {"P6 1 1 15\nabc", "solo se leen PPM de 8 bits"},
                      {"P6 2 2 255\nabc", "una imagen RGB de 2×2 ocupa 12 bytes y hay 3"},
                      {"P6 1 1 255\nabcd", "una imagen RGB de 1×1 ocupa 3 bytes y hay 4"},
                      {"P6 32768 32768 255\nabc", "de 32768×32768 ocupa 3221225472 bytes y hay 3"}});
}

TEST(Ppm, LosComentariosDeLaCabecera) {
    std::string comentario;
    for (const auto &[cabecera, primero] : {std::pair("P6\n# uno\n1 1\n255\nabc", "uno"),
                                            {"P6 #uno\n#dos\n1 # tres\n1\n255\nabc", "uno"},
                                            {"P6\n#\n1 1 255\nabc", ""},
                                            {"P6\r\n1 1\r\n255\r\nabc", ""}}) {
        comentario.clear();
        EXPECT_EQ(leePpm(escribe("c.ppm", cabecera), &comentario).rgb.size(), 3u);
        EXPECT_EQ(comentario, primero);
    }
}

TEST(ImagenDeArgumentos, LoQueEsLoDicenSusPrimerosBytes) {
    for (const char *nombre : {"f.ppm", "foto.pnm", "foto.png", "sin_extension"}) {
        std::string programa = "programa", foto = escribe(nombre, "P6 2 1 255\nabcdef");
        char *argv[] = {programa.data(), foto.data()};
        EXPECT_EQ(imagenDeArgumentos(2, argv, "", 1, 1).ancho, 2) << nombre;
    }
    std::string programa = "programa", talla = "-talla", tamano = "2x1", rgb = escribe("f.rgb", "P6BMab");
    char *argv[] = {programa.data(), rgb.data(), talla.data(),
                    tamano.data()}; // del tamaño que se dice, es RGB
    EXPECT_EQ(imagenDeArgumentos(4, argv, "", 1, 1).rgb[2], 'B');
}

// Lo lee otro igual que lo escrito, también con filas que no caben en un bloque.
TEST(EnPng, LoLeeOtro) {
    const fs::path png = carpetaTemporal() / "i.png", ppm = carpetaTemporal() / "de_png.ppm";
    for (const auto &[ancho, alto] : {std::pair(1, 1), {5, 3}, {30000, 2}}) {
        Imagen i{ancho, alto, std::vector<unsigned char>(std::size_t(3) * ancho * alto)};
        for (std::size_t k = 0; k < i.rgb.size(); ++k)
            i.rgb[k] = static_cast<unsigned char>(k * k % 251);
        std::ofstream(png, std::ios::binary) << enPng(i);
        ASSERT_EQ(std::system(("pngtopnm '" + png.string() + "' >'" + ppm.string() + "'").c_str()), 0);
        EXPECT_EQ(leePpm(ppm.string()).rgb, i.rgb) << ancho;
    }
}

// Hay mensaje, en español, y no queda nada más; un dispositivo lo sigue siendo.
TEST(GuardaPpm, DondeNoSePuede) {
    const fs::path carpeta = carpetaTemporal() / "no se puede";
    fs::create_directories(carpeta / "carpeta");
    fs::create_symlink("/no/hay/carpeta.ppm", carpeta / "a donde no hay");
    fs::create_symlink("lazo", carpeta / "lazo");
    const int habia = 3;
    for (const auto &[ruta, motivo] : {std::pair{"/dev/full", "no queda sitio en el disco"},
                                       {"/no/hay/carpeta.ppm", "no existe"},
                                       {"a donde no hay", "no existe"},
                                       {"lazo", "los enlaces dan vueltas"},
                                       {"carpeta", "es una carpeta"},
                                       {"lazo/x.ppm", "los enlaces dan vueltas"},
                                       {"/dev/null/x.ppm", "parte de la ruta no es una carpeta"}})
        EXPECT_EXIT(guardaPpm((carpeta / ruta).string(), {1, 1, {1, 2, 3}}), ExitedWithCode(1),
                    "no puedo guardar «.*»: " + std::string(motivo) + "\n");
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
    EXPECT_EQ(std::distance(fs::directory_iterator(carpeta), {}), habia);
}

// Si se acaba el sitio a media imagen, la que había sigue ahí, y no queda nada más.
TEST(GuardaPpm, EnteraOLaQueHabia) {
    const fs::path carpeta = carpetaTemporal() / "medias";
    fs::create_directory(carpeta);
    const std::string ruta = (carpeta / "foto.ppm").string();
    const Imagen grande{100, 100, std::vector<unsigned char>(30000, 9)};
    guardaPpm(ruta, {1, 1, {1, 2, 3}});
    const auto sinSitio = [&] {
        const rlimit limite{1000, 1000};
        setrlimit(RLIMIT_FSIZE, &limite);
        guardaPpm(ruta, grande);
    };
    EXPECT_EXIT(sinSitio(), ExitedWithCode(1), "no puedo guardar «.*foto.ppm»: es demasiado grande");
    EXPECT_EQ(leePpm(ruta).rgb, (std::vector<unsigned char>{1, 2, 3}));
    EXPECT_EQ(std::distance(fs::directory_iterator(carpeta), {}), 1);
}

// Por un enlace se guarda donde apunta, lo haya o no.
TEST(GuardaPpm, PorUnEnlace) {
    const fs::path carpeta = carpetaTemporal() / "enlaces", foto = carpeta / "otra/foto.ppm";
    fs::create_directories(carpeta / "otra");
    fs::create_symlink("otra/foto.ppm", carpeta / "uno.ppm");
    fs::create_symlink("uno.ppm", carpeta / "dos.ppm");
    for (const unsigned char gris : std::vector<unsigned char>{1, 2}) {
        guardaPpm((carpeta / "dos.ppm").string(), {1, 1, {gris, gris, gris}});
        EXPECT_EQ(leePpm(foto.string()).rgb, std::vector<unsigned char>(3, gris));
    }
    EXPECT_TRUE(fs::is_symlink(carpeta / "dos.ppm") && fs::is_symlink(carpeta / "uno.ppm"));
}

// Lo que se cita de un fichero no estropea la terminal ni la llena.
TEST(Falla, EnUnaLineaLegible) {
    EXPECT_EXIT(falla("«\x1B[2J" + std::string(1'000'000, 'x') + "\x7F» fin"), ExitedWithCode(1),
                "^[^:\n]+: «\\?\\[2Jx{200,300} … x{100,200}\\?» fin\n$");
    EXPECT_EXIT(falla("a\tb\nc"), ExitedWithCode(1), ": a\tb\nc\n$");
}

TEST(LeeVf, CadaErrorDiceFicheroYLinea) {
    const std::string tres = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    const char *const TRES_NUMEROS = "m.vf:1: un vértice son tres números";
    esperaQueTermine(leeVf, "m.vf",
                     {{"# 1\n\n" + tres + "f 0 1 2", "m.vf:6: el vértice 0 no existe: hay 3, desde el 1"},
                      {tres + "f 1 2", "m.vf:4: una cara necesita al menos tres vértices y hay 2"},
                      {tres + "f 1 2 2", "m.vf:4: el vértice 2 está dos veces en la cara"},
                      {tres + "f 1 b 3", "m.vf:4: «b» no es un número de vértice"},
                      {tres + "f 1 -4 3", "m.vf:4: el vértice -4 no existe: hay 3"},
                      {"v 0 0\n", "m.vf:1: un vértice son tres números — «v 0 0»"},
                      {"v 0 0 x\n", TRES_NUMEROS},
                      {"v 0 0 0 0\n", TRES_NUMEROS},
                      {"v 0 0 nan\n", TRES_NUMEROS},
                      {"v 0 0 inf\n", TRES_NUMEROS},
                      {"v 0 0 1e300\n", TRES_NUMEROS},
                      {"v 1-2-3\n", TRES_NUMEROS},
                      {"hola\n", "m.vf:1: cada línea empieza por v o por f, o por otra palabra de un OBJ"},
                      {tres, "m.vf» no tiene ninguna cara"},
                      {"", "m.vf» no tiene ninguna cara"}});
}

// Lo que exporta Blender: sus vértices y caras, también contadas desde el final y con la marca de UTF-8 delante.
TEST(LeeVf, UnObj) {
    const MallaVf m = leeVf(escribe(
        "m.obj", "\xEF\xBB\xBF# Blender\nmtllib m.mtl\no Cubo\nv 0 0 0\nv 1 0 0\nv 1 1 0\n"
                 "vn 0 0 1\nvt 0.5 0.5\ns 0\nusemtl M\nf 1/1/1 2//1 3/1\nv 0 1 0\nf -4 -2 -1\nl 1 2\n"));
    EXPECT_EQ(m.vertices.size(), 4u);
    EXPECT_EQ(m.caras, (std::vector<std::vector<unsigned>>{{0, 1, 2}, {0, 2, 3}}));
}

// El idioma del usuario no cambia lo que se lee, aunque escriba los decimales con coma.
TEST(LeeVf, NoDependeDelIdioma) {
    struct Coma : std::numpunct<char> {
        char do_decimal_point() const override {
            return ',';
        }
    };
    const std::locale antes = std::locale::global(std::locale(std::locale(), new Coma));
    const MallaVf m = leeVf(escribe(
        "m.vf", "# dos triángulos\nv 0 0 0\nv 1 0 0 # otro\nv 1 1 0\n\nv 0.25 1.5e0 -2\nf 1 2 3\nf 1 3 4\n"));
    std::locale::global(antes);
    ASSERT_EQ(m.vertices.size(), 4u);
    EXPECT_EQ(m.vertices[3], glm::vec3(0.25f, 1.5f, -2));
    EXPECT_EQ(m.caras, (std::vector<std::vector<unsigned>>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Recurso, SeBuscaPrimeroEnLabRaizYSeApuntaEnLabLeidos) {
    const fs::path raiz = carpetaTemporal() / "raiz", leidos = carpetaTemporal() / "leidos";
    fs::create_directories(raiz / "ch03_transformaciones");
    std::ofstream(raiz / "ch03_transformaciones/objeto.vert") << "otro";
    setenv("LAB_RAIZ", (":/no/existe:" + raiz.string()).c_str(), 1);
    setenv("LAB_LEIDOS", leidos.c_str(), 1);
    EXPECT_EQ(leeFichero(recurso("ch03_transformaciones/objeto.vert")), "otro");
    EXPECT_NE(leeFichero(recurso("ch03_transformaciones/objeto.frag")),
              ""); // no está allí: el del árbol de fuentes
    EXPECT_EXIT(recurso("ch99/nada.vert"), ExitedWithCode(1),
                "no encuentro «ch99/nada.vert»; lo he buscado en /no/existe/ch99.*raiz/ch99.*, .*, ");
    // y después, en la carpeta del programa y en la de encima, que son las de un árbol instalado, y en otras dos
    const fs::path carpeta = fs::read_symlink("/proc/self/exe").parent_path();
    std::string ruta, error, lugares;
    for (const fs::path &lugar : {fs::path("/no/existe"), raiz, carpeta, carpeta.parent_path()})
        lugares += (lugar / "ch99/nada.vert").string() + ", ";
    EXPECT_FALSE(intentaRecurso("ch99/nada.vert", ruta, error));
    EXPECT_NE(error.find("lo he buscado en " + lugares), std::string::npos) << error;
    EXPECT_EQ(std::count(error.begin(), error.end(), ','), 5) << error;
    unsetenv("LAB_RAIZ");
    unsetenv("LAB_LEIDOS");
    EXPECT_EQ(leeFichero(leidos.string()),
              "ch03_transformaciones/objeto.vert\nch03_transformaciones/objeto.frag\n");
}
