// La costura: opciones, guion, reloj, menús, errores de OpenGL y estados de salida de glut_sin_ventana,
// vistos desde fuera, con programas enteros.
#include "ejecuta.h"
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <regex>
#include <sstream>
#include <sys/resource.h>
#include <sys/wait.h>

namespace fs = std::filesystem;

namespace {

const std::string GRUA = "ch03_transformaciones/grua", DEFECTUOSO = "../tests/defectuoso",
                  TIPOS_PROPIOS = "../tests/tipos_propios",
                  REGISTRO = "../tests/registro_" + fs::path(LAB_EJECUTABLES).filename().string();

/// Una tabla de casos: «programa argumentos | guion | lo que dice». Cada uno empieza en su línea, y las que están más adentro lo
/// siguen; con # empieza un comentario.
struct Caso {
    std::string programa, guion, dice;
    std::vector<std::string> argumentos;
};
std::vector<Caso> casosDe(const std::string &tabla) {
    const std::map<std::string, std::string> programas = {
        {"grua", GRUA}, {"defectuoso", DEFECTUOSO}, {"tipos_propios", TIPOS_PROPIOS}, {"registro", REGISTRO}};
    const std::regex fila(R"(\s*(\S+)\s*(.*?)\s*\|\s*(.*?)\s*\|\s*(.*))");
    std::vector<Caso> casos;
    std::istringstream lineas(std::regex_replace(tabla, std::regex("\\n {12}"), " "));
    for (std::string linea; std::getline(lineas, linea);) {
        if (std::regex_match(linea, std::regex(" *(#.*)?")))
            continue;
        std::smatch partes;
        EXPECT_TRUE(std::regex_match(linea, partes, fila)) << linea;
        std::istringstream argumentos(partes[2]);
        casos.push_back({programas.at(partes[1]),
                         partes[3],
                         partes[4],
                         {std::istream_iterator<std::string>(argumentos), {}}});
    }
    return casos;
}

/// Cada caso falla con ese estado, sin imagen y con una sola línea en stderr que contiene ese mensaje.
void esperaFallos(const std::string &tabla) {
    for (const Caso &c : casosDe(tabla)) {
        const Ejecucion e = ejecuta(c.programa, c.guion, 9, 9, c.argumentos);
        EXPECT_EQ(e.estado, std::stoi(c.dice)) << c.dice;
        EXPECT_TRUE(e.imagen.rgb.empty()) << c.dice;
        EXPECT_NE(e.errores.find(c.dice.substr(2)), std::string::npos)
            << c.dice << ", y ha dicho " << e.errores;
        EXPECT_EQ(std::count(e.errores.begin(), e.errores.end(), '\n'), 1) << e.errores;
    }
}

/// Cada caso acaba bien, sin avisos, y escribe en stdout justo esas líneas, separadas por « / ». De registro, todas menos la
/// primera y las dos últimas, que siempre son las mismas.
void esperaSalidas(const std::string &tabla) {
    for (const Caso &c : casosDe(tabla)) {
        const Ejecucion e = ejecuta(c.programa, c.guion, 32, 24, c.argumentos);
        std::string dice = std::regex_replace(c.dice, std::regex(" / "), "\n") + "\n";
        if (c.programa == REGISTRO)
            dice = "tamano 32 24 32 24\n" + dice + "cierre 1 0 0 0\nfin 0 0 0 0\n";
        EXPECT_EQ(e.estado, 0) << c.guion;
        EXPECT_EQ(e.errores, "") << c.guion;
        EXPECT_EQ(e.salida, dice) << c.guion;
    }
}

} // namespace

TEST(Fallos, CadaUnoConSuEstadoYSuMensaje) {
    esperaFallos(R"(
        grua -nada                       | | 2 no entiendo «-nada»; uso: grua
        grua foto.ppm                    | | 2 no entiendo «foto.ppm»
        grua -geometry                   | | 2 -geometry: falta su valor
        grua -geometry diez              | | 2 -geometry: «diez» no es un tamaño ANCHOxALTO
        grua -mide 0                     | | 2 -mide: «0» no es un número entre 1 y
        grua -mide 1e3                   | | 2 -mide: «1e3» no es un número
        grua            | gira                                 | 2 guion, orden 1 «gira»: «gira» no es una orden
        grua            | tecla Esc; tecla d                   | 2 orden 2 «tecla d»: el programa ya ha terminado
        grua            | tecla Esc ×2                         | 2 orden 1 «tecla Esc ×2»: el programa ya ha terminado
        grua            | arrastra 1 1                         | 2 no hay ningún botón pulsado; es mueve
        grua            | boton IZQUIERDO abajo 1 1; mueve 1 1 | 2 hay un botón pulsado; es arrastra
        grua            | boton IZQUIERDO abajo 1 1 ×2         | 2 ese botón ya está abajo
        grua            | boton IZQUIERDO arriba 1 1           | 2 ese botón ya está arriba
        grua            | menu Vista/Planta                    | 2 «menu Vista/Planta»: no hay esa opción; el programa no tiene menú
        registro menu   | menu Vista                           | 2 el menú tiene «Vista/…» «Ejes quitados» «Salir»
        registro menu   | menu Vista/Alzado                    | 2 el menú tiene «Vista/…»
        registro menu   | menu Salir/Perfil                    | 2 el menú tiene «Vista/…»
        registro menu   | menu Perfil                          | 2 el menú tiene «Vista/…»
        registro menu   | menu Ejes quitados ×2                | 2 el menú tiene «Vista/…» «Ejes puestos» «Salir»
        grua            | captura /no/hay/y.ppm                | 1 no puedo guardar «/no/hay/y.ppm»
        grua -ppm /no/hay/x.ppm          | | 1 no puedo guardar «/no/hay/x.ppm»
        grua -ppm /dev/full              | | 1 no puedo guardar «/dev/full»
        defectuoso dos_ventanas          | | 1 glut_sin_ventana solo tiene una ventana
        defectuoso submenu_que_no_hay    | | 1 glutAddSubMenu(77): no hay ese menú
        defectuoso shader no_esta.vert   | | 1 no encuentro «tests/costura/no_esta.vert»; lo he buscado en
        # el error de un fichero incluido nombra ese fichero
        defectuoso shader inclusion.vert | | 1 inclusion.glsl:3: error: `y' undeclared — «return 2.0 * y;»
        defectuoso enum                  | | 3 error de OpenGL al dibujar: GL_INVALID_ENUM
        defectuoso callado               | | 3 error de OpenGL al dibujar: GL_INVALID_ENUM
        defectuoso inicio                | | 3 error de OpenGL antes de glutMainLoop: GL_INVALID_ENUM
        defectuoso exit                  | | 3 error de OpenGL: GL_INVALID_ENUM)");
}

// Lo que no es OpenGL 3.1 con GLSL 1.40 no pasa.
TEST(ErrorDeOpenGL, EsUn31Estricto) {
    esperaFallos(R"(
        defectuoso begin               | | 3 error de OpenGL al dibujar
        defectuoso sin_vao             | | 3 error de OpenGL al dibujar: GL_INVALID_OPERATION
        defectuoso shader glsl150.vert | | 1 tests/costura/glsl150.vert:1: error: GLSL 1.50 is not supported)");
}

// Lo que no cabe en el disco no se calla: texto, ayuda, medidas y rasgos.
TEST(Salida, LlenaEsUnError) {
    const std::string grua = "'" LAB_EJECUTABLES "/" + GRUA + "' -ppm /dev/null ";
    for (const std::string &orden : {grua + "-mide 1", grua + "-ayuda", grua + "-rasgos",
                                     std::string("'" LAB_EJECUTABLES "/ch01_intro/info_opengl'")}) {
        const int estado = std::system((orden + " >/dev/full 2>/dev/null").c_str());
        EXPECT_EQ(WIFEXITED(estado) ? WEXITSTATUS(estado) : -1, 1) << orden;
    }
}

TEST(Shader, UnUniformQueNoEstaAvisaUnaVez) {
    const Ejecucion e = ejecuta(DEFECTUOSO, "", 9, 9, {"uniforme"});
    EXPECT_EQ(e.estado, 0);
    EXPECT_EQ(
        e.errores,
        "defectuoso: aviso: el uniform «noExiste» no está o no se usa en tests/comparador/escena.vert y "
        "tests/comparador/escena.frag\n");
}

// F5 con el shader roto conserva el que había y dice la línea; arreglado, lo usa.
TEST(Shader, F5LosVuelveALeer) {
    const fs::path raiz = carpetaTemporal() / "raiz_f5";
    fs::create_directories(raiz / "tests/costura");
    std::ofstream(raiz / "tests/costura/recarga.vert") << R"(#version 140
void main() {
    gl_Position = vec4(4 * (gl_VertexID % 2) - 1, 4 * (gl_VertexID / 2) - 1, 0.0, 1.0);
}
)";
    setenv("LAB_RAIZ", raiz.c_str(), 1);
    const Ejecucion e =
        ejecuta(DEFECTUOSO, "espera 10; especial F5; espera 10; especial F5", 9, 9, {"recarga"});
    unsetenv("LAB_RAIZ");
    EXPECT_EQ(e.estado, 0) << e.errores;
    EXPECT_EQ(e.salida, "255 0 0\n255 0 0\n0 255 0\n");
    EXPECT_EQ(e.errores.rfind("defectuoso: aviso: tests/costura/recarga.frag:4: error: ", 0), 0u)
        << e.errores;
}

TEST(Guion, LeDiceAlPrograma) {
    esperaSalidas(R"(
        # el reloj solo avanza con espera; los temporizadores vencen en orden, y entre iguales el que antes se pidió
        defectuoso tiempo | tecla a; espera 249; espera 1; espera 150
            | 100 a 100 ms / 100 a 200 ms / 250 a 250 ms / menu 1 en el 0 / 100 a 300 ms / 100 a 400 ms
        # uno de 0 ms vence al milisegundo: ni el que se pide otra vez al vencer para el reloj
        defectuoso enseguida | espera 3 | 1 / 2 / 3
        # el ocio, una vez tras cada orden, cuando ya se ha dibujado lo que ella pedía; luego se dibuja lo que pide él
        defectuoso ocio | tecla a; espera 5; tamano 8 8; tecla b ×2
            | dibuja / ocio 1 / dibuja / ocio 2 / dibuja / dibuja / ocio 3 / dibuja
        # las muestras se pueden pedir, y no las hay
        defectuoso muestras | | 0
        # el programa que lee a un buffer lo tiene enlazado aunque en medio se capture
        defectuoso lectura | captura a.ppm; tamano 9 8 | 1 / 1
        # F12 no pisa lo guardado
        grua | especial F12; tecla d; especial F12
            | guardado grua-1.ppm / guardado grua-2.ppm
        # sin función propia, la rueda son los botones 3 y 4
        registro menu | rueda +1 5 5; rueda -1 5 5
            | movimiento 5 5 0 0 / boton 3 0 5 5 / boton 3 1 5 5 / boton 4 0 5 5 / boton 4 1 5 5
        # la escala es la de la ventana que haya cuando el ratón se mueve
        registro | escala 8 6; mueve 1 1; tamano 16 24; mueve 1 1
            | movimiento 4 4 0 0 / tamano 16 24 16 24 / movimiento 2 8 0 0
        registro | escala 8 6; rueda +1 4 3
            | movimiento 16 12 0 0 / rueda 0 1 16 12)");
}

TEST(Guion, LosMenus) {
    esperaSalidas(R"(
        # cada opción llama a la función del menú en que está, que es el actual mientras dura; luego, el que lo era
        registro menu | menu Vista/Perfil ×2; menu Ejes quitados; tecla a
            | submenu 2 1 0 0 / submenu 2 1 0 0 / menu 3 2 0 0 / tecla 97 0 0 1 / tecla arriba 97 0 0 0
        registro menu | menu Ejes quitados; menu Ejes puestos; menu Salir
            | menu 3 2 0 0 / menu 4 2 0 0 / menu 5 2 0 0
        # abierto, el programa no ve el ratón, ni el clic que lo cierra; sí que el botón que eligió se suelta
        registro menu | boton DERECHO abajo 1 1; boton DERECHO arriba 1 1; mueve 2 2; boton IZQUIERDO abajo 2 2;
            boton IZQUIERDO arriba 2 2; boton IZQUIERDO abajo 3 3
            | movimiento 1 1 0 0 / boton 0 1 2 2 / movimiento 3 3 0 0 / boton 0 0 3 3
        registro menu | boton DERECHO abajo 1 1; menu Vista/Perfil; boton DERECHO arriba 1 1
            | movimiento 1 1 0 0 / submenu 2 1 0 0 / boton 2 1 1 1
        # el borrado deja su sitio vacío
        defectuoso menu_borrado | menu Vista | menu -1 en el 2)");
}

TEST(Opciones, RasgosDiceDeQueSeEntera) {
    esperaSalidas(R"(
        tipos_propios -rasgos     |                    | 3 7 1.5 entrada 2 ninguna no hay
        grua -rasgos              |                    | teclado / especial / raton / arrastre / rueda
        defectuoso tiempo -rasgos |                    | teclado / especial / temporizador
        registro -rasgos          |                    | teclado / especial / raton / arrastre / movimiento / rueda
        registro menu -rasgos     | mueve 1 1; tecla o
            | movimiento 1 1 0 0 / tecla 111 1 1 1 / tecla arriba 111 1 1 0 / ocio 1 0 0 0 / teclado / especial
            / raton / arrastre / movimiento / ocio / opcion Vista/Planta, que es como se ve desde arriba
            / opcion Vista/Perfil / opcion Ejes quitados / opcion Salir)");
    EXPECT_TRUE(ejecuta(GRUA, "", 9, 9, {"-rasgos"}).imagen.rgb.empty());
}

// También la de un programa que no sabe nada de ella.
TEST(Opciones, AyudaLasEnumeraYNoDibuja) {
    for (const std::string &programa : {GRUA, TIPOS_PROPIOS}) {
        const Ejecucion e = ejecuta(programa, "", 9, 9, {"-ayuda"});
        EXPECT_EQ(e.estado, 0) << e.errores;
        EXPECT_TRUE(e.imagen.rgb.empty());
        std::istringstream ordenes(
            "-geometry -guion -ppm -mide -rasgos -ayuda tecla especial boton arrastra mueve rueda "
            "menu tamano espera captura escala ORDEN");
        for (std::string que; ordenes >> que;)
            EXPECT_NE(e.salida.find("\n  " + que + " "), std::string::npos) << que;
        EXPECT_EQ(e.salida.find("\nuso: grua [opciones de GLUT]") != std::string::npos, programa == GRUA);
    }
}

// Un triángulo de tres vértices en el plano, y un mapa de cubo de seis caras RGB de 256 × 256 con sus mipmaps.
TEST(Opciones, MideEscribeUnaLineaTsv) {
    const std::string tiempos = "\t240x180(\t[0-9]+\\.[0-9]{3}){4}",
                      bytesDelMapa = std::to_string(6 * 3 * 87381);
    for (const auto &[programa, linea] :
         {std::pair("ch01_intro/shader_basico", "shader_basico" + tiempos + "\t1\t[^\t]+\t24\t0\n"),
          {"ch08_texturas_avanzadas/cubemap",
           "cubemap" + tiempos + "\t[0-9]+\t[^\t]+\t[0-9]+\t" + bytesDelMapa + "\n"}}) {
        const Ejecucion e = ejecuta(programa, "", 240, 180, {"-mide", "5"});
        EXPECT_EQ(e.estado, 0) << e.errores;
        EXPECT_TRUE(std::regex_match(e.salida, std::regex(linea))) << e.salida;
    }
}

TEST(Imagen, LaTallaEsLaDeGeometry) {
    for (const std::string &programa : {GRUA, TIPOS_PROPIOS}) // el segundo pide otra
        for (const auto &[ancho, alto] : {std::pair(1, 1), {1, 300}, {300, 1}, {3, 2}, {1001, 13}}) {
            const Ejecucion e = ejecuta(programa, "", ancho, alto);
            EXPECT_EQ(e.estado, 0) << e.errores;
            EXPECT_EQ(e.imagen.ancho, ancho);
            EXPECT_EQ(e.imagen.alto, alto);
        }
}

// Cambiar de tamaño o llenar la pantalla y volver deja la misma imagen; capturar en medio no la toca.
TEST(Imagen, CambiarDeTamanoYVolver) {
    const Imagen imagen = ejecuta(GRUA).imagen, llena = ejecuta(GRUA, "especial F11").imagen;
    EXPECT_EQ(llena.ancho, 1920);
    EXPECT_EQ(llena.alto, 1080);
    for (const char *guion : {"tamano 1 1; tamano 500 20; captura c.ppm; tamano 240 180", "especial F11 ×2"})
        EXPECT_EQ(ejecuta(GRUA, guion).imagen.rgb, imagen.rgb) << guion;
}

// 800 tamaños distintos ocupan como 200: cada framebuffer nuevo no se queda con la memoria del anterior.
TEST(Imagen, CambiarDeTamanoNoOcupaMas) {
    const auto tamanos = [](int cuantos) {
        std::string guion;
        for (int i = 0; i < cuantos; ++i)
            guion += "tamano " + std::to_string(200 + i) + " " + std::to_string(600 - i / 2) + ";";
        return guion;
    };
    const auto mebibytes = [] { // lo más que ha ocupado algún proceso que ha esperado éste
        rusage uso;
        getrusage(RUSAGE_CHILDREN, &uso);
        return uso.ru_maxrss / 1024;
    };
    EXPECT_EQ(ejecuta(GRUA, tamanos(200)).estado, 0);
    const long antes = mebibytes();
    EXPECT_EQ(ejecuta(GRUA, tamanos(800)).estado, 0);
    EXPECT_LT(mebibytes() - antes, 200);
}

// Ni los procesadores ni la carpeta de trabajo (ejecuta usa una temporal) cambian la imagen.
TEST(Determinismo, LosHilosNoCambianLaImagen) {
    const Ejecucion e = ejecuta(GRUA);
    for (const char *hilos : {"0", "2", "16"}) {
        setenv("LP_NUM_THREADS", hilos, 1);
        EXPECT_EQ(ejecuta(GRUA).imagen.rgb, e.imagen.rgb) << hilos;
    }
    unsetenv("LP_NUM_THREADS");
}

// Una orden con ×N son N órdenes seguidas.
TEST(Imagen, RepetirEsEscribirlaOtraVez) {
    EXPECT_EQ(ejecuta(GRUA, "tecla d ×3").imagen.rgb, ejecuta(GRUA, "tecla d; tecla d; tecla d").imagen.rgb);
}

TEST(EspacioDeNombres, UnProgramaPuedeTenerTiposYFuncionesQueSeLlamenIgual) {
    const Ejecucion e = ejecuta(TIPOS_PROPIOS, "tecla a; espera 3; tamano 8 8", 9, 9);
    EXPECT_EQ(e.estado, 0) << e.errores;
    EXPECT_EQ(e.salida, "3 7 1.5 entrada 2 ninguna no hay\n");
    ASSERT_EQ(e.imagen.ancho, 8);
    EXPECT_EQ(pixel(e.imagen, 4, 4).g, 255);
}

// Todos los programas acaban con Esc, sin imagen a medias ni mensajes, y aguantan 1×1 y volver.
TEST(TodosLosProgramas, TerminanConEscYAguantan1x1) {
    std::istringstream programas(LAB_PROGRAMAS);
    int cuantos = 0;
    for (std::string programa; programas >> programa;) {
        ++cuantos;
        const Ejecucion e =
            ejecuta(programa, "tamano 1 1; tamano 1 200; tamano 300 1; tamano 240 180; tecla Esc");
        EXPECT_EQ(e.estado, 0) << programa << ": " << e.errores;
        EXPECT_EQ(e.errores, "") << programa;
        EXPECT_EQ(e.imagen.ancho, 240) << programa;
        if (programa != "ch10_interaccion/eventos") { // su imagen enseña los cambios de tamaño
            EXPECT_EQ(e.imagen.rgb, ejecuta(programa).imagen.rgb) << programa << " no vuelve a su imagen";
        }
    }
    EXPECT_GE(cuantos, 80);
}
