// La costura: opciones, guion, reloj, menús, errores de OpenGL y estados de salida de glut_sin_ventana,
// vistos desde fuera, con programas enteros.
#include "ejecuta.h"
#include "guiones.h"
#include <sys/resource.h>
#include <sys/wait.h>

namespace fs = std::filesystem;

namespace {

const std::string DEFECTUOSO = "../tests/defectuoso",
                  REGISTRO = "../tests/registro_" + fs::path(LAB_EJECUTABLES).filename().string();

// Un submenú con una opción y otra suelta.
const char *const MENU = "crea 1;opcion 1 10;crea 1;submenu 3 1;opcion 4 10;enlaza 2";

using Orden = std::vector<std::string>; // un programa y sus argumentos

Ejecucion lanza(const Orden &orden, const std::string &guion = "") {
    return ejecuta(orden.at(0), guion, 32, 24, {orden.begin() + 1, orden.end()});
}

struct Caso {
    Orden orden;
    std::string guion, dice;
    int estado = 0;
};

} // namespace

// Con una sola línea en stderr y, si no es un aviso, sin imagen.
TEST(Fallos, CadaUnoConSuEstadoYSuMensaje) {
    const std::vector<Caso> casos = {
        {{"grua", "-nada"}, "", "no entiendo «-nada»; uso: grua", 2},
        {{"grua", "-geometry"}, "", "-geometry: falta su valor", 2},
        {{"grua", "-mide", "0"}, "", "-mide: «0» no es un número entre 1 y", 2},
        {{"grua"}, "tecla Esc; tecla d", "orden 2 «tecla d»: el programa ya ha terminado", 2},
        {{"grua"}, "tecla Esc ×2", "orden 1 «tecla Esc ×2»: el programa ya ha terminado", 2},
        {{"grua"}, "arrastra 1 1", "no hay ningún botón pulsado; es mueve", 2},
        {{"grua"}, "boton IZQUIERDO abajo 1 1; mueve 1 1", "hay un botón pulsado; es arrastra", 2},
        {{"grua"}, "boton IZQUIERDO abajo 1 1 ×2", "ese botón ya está abajo", 2},
        {{"grua"}, "boton IZQUIERDO arriba 1 1", "ese botón ya está arriba", 2},
        {{"grua"},
         "menu Vista/Planta",
         "«menu Vista/Planta»: no hay esa opción; el programa no tiene menú",
         2},
        {{REGISTRO, MENU}, "menu 3", "el menú tiene «3/…» «4»", 2},
        {{REGISTRO, MENU}, "menu 4/1", "el menú tiene «3/…»", 2},
        {{"grua"}, "captura /no/hay/y.ppm", "no puedo guardar «/no/hay/y.ppm»", 1},
        {{"grua", "-ppm", "/dev/full"}, "", "no puedo guardar «/dev/full»", 1},
        {{DEFECTUOSO, "enum"}, "", "error de OpenGL al dibujar: GL_INVALID_ENUM", 3},
        {{DEFECTUOSO, "callado"}, "", "error de OpenGL al dibujar: GL_INVALID_ENUM", 3},
        {{DEFECTUOSO, "inicio"}, "", "error de OpenGL antes de glutMainLoop: GL_INVALID_ENUM", 3},
        {{DEFECTUOSO, "exit"}, "", "error de OpenGL: GL_INVALID_ENUM", 3},
        // lo que no es OpenGL 3.1 no pasa; lo que no es GLSL 1.40, en taller_test.cpp
        {{DEFECTUOSO, "begin"}, "", "¿una de OpenGL 1, como glBegin", 3},
        {{DEFECTUOSO, "sin_vao"}, "", "error de OpenGL al dibujar: GL_INVALID_OPERATION", 3},
        {{DEFECTUOSO, "uniforme"},
         "",
         "defectuoso: aviso: el uniform «noExiste» no está o no se usa en ch06_texturas/textura_objeto.vert "
         "y "
         "ch06_texturas/textura_objeto.frag\n"},
    };
    for (const Caso &c : casos) {
        const Ejecucion e = lanza(c.orden, c.guion);
        EXPECT_EQ(e.estado, c.estado) << c.dice;
        EXPECT_EQ(e.imagen.rgb.empty(), c.estado != 0) << c.dice;
        EXPECT_NE(e.errores.find(c.dice), std::string::npos) << c.dice << ", y ha dicho " << e.errores;
        EXPECT_EQ(std::count(e.errores.begin(), e.errores.end(), '\n'), 1) << e.errores;
    }
}

// Lo que no cabe en el disco no se calla: texto, ayuda, medidas y rasgos.
TEST(Salida, LlenaEsUnError) {
    const std::string capitulos = LAB_EJECUTABLES,
                      grua = capitulos + "/ch03_transformaciones/grua -ppm /dev/null ";
    for (const std::string &orden :
         {grua + "-mide 1", grua + "-ayuda", grua + "-rasgos", capitulos + "/ch01_intro/info_opengl"}) {
        const int estado = std::system((orden + " >/dev/full 2>/dev/null").c_str());
        EXPECT_EQ(WIFEXITED(estado) ? WEXITSTATUS(estado) : -1, 1) << orden;
    }
}

// Lo demás, en glut_test.cpp.
TEST(Guion, LeDiceAlPrograma) {
    const std::vector<Caso> casos = {
        // el programa que lee a un buffer lo tiene enlazado aunque en medio se capture
        {{DEFECTUOSO, "lectura"}, "captura a.ppm; tamano 9 8", "1\n1\n"},
        // sin función propia, dibuja en la ventana entera
        {{DEFECTUOSO, "suelto"}, "tamano 16 9", "32 24\n16 9\n"},
    };
    for (const Caso &c : casos) {
        const Ejecucion e = lanza(c.orden, c.guion);
        EXPECT_EQ(e.estado, 0) << c.guion;
        EXPECT_EQ(e.errores + e.salida, c.dice) << c.guion;
    }
}

// También la de un programa que no sabe nada de ella.
TEST(Opciones, AyudaLasEnumeraYNoDibuja) {
    EXPECT_TRUE(lanza({"grua", "-rasgos"}).imagen.rgb.empty());
    for (const Orden &orden : {Orden{"grua", "--help"}, {DEFECTUOSO, "-ayuda", "suelto"}}) {
        const Ejecucion e = lanza(orden);
        EXPECT_EQ(e.estado, 0) << e.errores;
        EXPECT_TRUE(e.imagen.rgb.empty());
        for (const char *que :
             {"-geometry", "-guion", "-ppm", "-mide", "-rasgos", "-ayuda", "tecla", "especial", "boton",
              "arrastra", "mueve", "rueda", "menu", "tamano", "espera", "captura", "escala", "ORDEN"})
            EXPECT_NE(e.salida.find("\n  " + std::string(que) + " "), std::string::npos) << que;
        EXPECT_EQ(e.salida.find("\nuso: grua [opciones de GLUT]") != std::string::npos, orden[0] == "grua");
    }
}

// Un triángulo de tres vértices en el plano; y seis caras RGB de 512 × 512 y un mapa de 1024 × 512, con sus mipmaps.
TEST(Opciones, MideEscribeUnaLineaTsv) {
    const std::string tiempos = "\t32x24(\t[0-9]+\\.[0-9]{3}){4}",
                      bytesDelMapa = std::to_string(6 * 3 * 349525 + 3 * 699051);
    for (const auto &[programa, linea] :
         {std::pair("shader_basico", "shader_basico" + tiempos + "\t1\t[^\t]+\t24\t0\n"),
          {"cubemap", "cubemap" + tiempos + "\t[0-9]+\t[^\t]+\t[0-9]+\t" + bytesDelMapa + "\n"}}) {
        const Ejecucion e = lanza({programa, "-mide", "5"});
        EXPECT_EQ(e.estado, 0) << e.errores;
        EXPECT_TRUE(std::regex_match(e.salida, std::regex(linea))) << e.salida;
    }
    // de 31 cuadros no tardan 16 lo mismo
    std::istringstream campos(lanza({"cubemap", "-mide", "31"}).salida);
    std::string programa, talla;
    double primera = 0, mediana = 0, menor = 0, mayor = 0;
    campos >> programa >> talla >> primera >> mediana >> menor >> mayor;
    EXPECT_LT(menor, mediana);
    EXPECT_LT(mediana, mayor);
}

// Cambiar de tamaño o llenar la pantalla y volver deja la misma imagen, y capturar en medio no la toca; una orden con
// ×N son N seguidas.
TEST(Imagen, LoMismoDaLaMisma) {
    const Imagen llena = imagenDe("grua", "especial F11");
    EXPECT_EQ(llena.ancho, 1920);
    EXPECT_EQ(llena.alto, 1080);
    for (const auto &[uno, otro] : {std::pair("tamano 1 1; tamano 500 20; captura c.ppm; tamano 240 180", ""),
                                    {"especial F11 ×2", ""},
                                    {"especial F11 ×2; tamano 60 50; especial F11 ×2", "tamano 60 50"},
                                    // pasado de lo que se deja perder, ni más ancha ni más alta sale cortada
                                    {"tamano 3000 3000; tamano 64 64; tamano 40 500", "tamano 40 500"},
                                    {"tamano 3000 3000; tamano 64 64; tamano 500 40", "tamano 500 40"},
                                    {"tecla d ×3", "tecla d; tecla d; tecla d"}})
        EXPECT_EQ(imagenDe("grua", uno).rgb, imagenDe("grua", otro).rgb) << uno;
}

// Con otro entorno la imagen puede ser otra: si el sello no lo dijera, se compararían como si debieran ser la misma.
TEST(Imagen, ElSelloDiceConQueEntornoSeDibujo) {
    const std::string ppm = (carpetaTemporal() / "sello.ppm").string();
    EXPECT_EQ(ejecuta("grua", "captura " + ppm).estado, 0);
    std::string sello;
    leePpm(ppm, &sello);
    for (const char *variable : {" | GALLIUM_OVERRIDE_CPU_CAPS=", " | GALLIVM_PERF="})
        EXPECT_NE(sello.find(variable), std::string::npos) << sello;
}

// Con cada destino, 800 tamaños distintos ocupan como 200: un framebuffer no se queda con la memoria del anterior.
TEST(Imagen, CambiarDeTamanoNoOcupaMas) {
    const auto mebibytes = [](const std::string &grua,
                              int tamanos) { // lo más que ha ocupado algún proceso que ha esperado éste
        std::string guion;
        for (int i = 0; i < tamanos; ++i)
            guion += "tamano " + enGuion({200 + i, 600 - i / 2}) + ";";
        EXPECT_EQ(ejecuta(grua, guion).estado, 0);
        rusage uso;
        getrusage(RUSAGE_CHILDREN, &uso);
        return uso.ru_maxrss / 1024;
    };
    for (const std::string destino : {"osmesa", "egl"}) {
        const std::string grua = "../" + destino + "/ch03_transformaciones/grua";
        if (!fs::exists(LAB_EJECUTABLES "/" + grua))
            continue;
        const long antes = mebibytes(grua, 200);
        EXPECT_LT(mebibytes(grua, 800) - antes, 200) << destino;
    }
}

// De shader_basico, el triángulo y su programa de dos shaders. Lo que ocupa son los búferes y las texturas que dice
// -mide.
TEST(Diario, DiceLoQueElCuadroDejaYLoQueOcupa) {
    const auto diario = [](Orden orden) {
        orden.push_back("-diario");
        return lanza(orden).salida;
    };
    EXPECT_NE(diario({DEFECTUOSO, "repetido"}).find("\totra\t"), std::string::npos);
    EXPECT_NE(diario({"shader_basico"}).find("\t1 0 1 2 0 0 1\t24\t0\n"), std::string::npos);
    std::smatch bytes, ocupa;
    const std::string mide = lanza({"cubemap", "-mide", "1"}).salida, delCubo = diario({"cubemap"});
    ASSERT_TRUE(std::regex_search(mide, bytes, std::regex("\t([0-9]+)\t([0-9]+)\n$"))) << mide;
    ASSERT_TRUE(std::regex_search(delCubo, ocupa, std::regex("\t([0-9]+)\t[0-9]+\n$"))) << delCubo;
    EXPECT_EQ(std::stol(ocupa[1]), std::stol(bytes[1]) + std::stol(bytes[2]));
}
