// La costura: opciones, guion, reloj, menús, errores de OpenGL y estados de salida de glut_sin_ventana,
// vistos desde fuera, con programas enteros.
#include "ejecuta.h"
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <sys/resource.h>
#include <sys/wait.h>

namespace fs = std::filesystem;

namespace {

const char *const GRUA = "ch03_transformaciones/grua";
const char *const DEFECTUOSO = "../tests/defectuoso";

/// Espera un fallo con ese estado, sin imagen y con una sola línea en stderr que contiene `mensaje`.
void esperaFallo(const Ejecucion &e, int estado, const std::string &mensaje) {
    EXPECT_EQ(e.estado, estado) << e.errores;
    EXPECT_TRUE(e.imagen.rgb.empty());
    EXPECT_NE(e.errores.find(mensaje), std::string::npos)
        << "esperaba «" << mensaje << "» y ha dicho: " << e.errores;
    EXPECT_EQ(std::count(e.errores.begin(), e.errores.end(), '\n'), 1) << e.errores;
}

} // namespace

TEST(Opciones, LasMalEscritasAcabanCon2) {
    esperaFallo(ejecuta(GRUA, "", 240, 180, {"-nada"}), 2, "no entiendo «-nada»; uso: grua");
    esperaFallo(ejecuta(GRUA, "", 240, 180, {"foto.ppm"}), 2, "no entiendo «foto.ppm»");
    esperaFallo(ejecuta(GRUA, "", 240, 180, {"-geometry"}), 2, "-geometry: falta su valor");
    esperaFallo(ejecuta(GRUA, "", 240, 180, {"-geometry", "diez"}), 2,
                "-geometry: «diez» no es un tamaño ANCHOxALTO");
    esperaFallo(ejecuta(GRUA, "", 240, 180, {"-mide", "0"}), 2, "-mide: «0» no es un número entre 1 y");
    esperaFallo(ejecuta(GRUA, "", 240, 180, {"-mide", "1e3"}), 2, "-mide: «1e3» no es un número");
    esperaFallo(ejecuta(GRUA, "gira"), 2, "guion, orden 1 «gira»: «gira» no es una orden");
    esperaFallo(ejecuta(GRUA, "tecla d; menu Vista/Planta"), 2,
                "orden 2 «menu Vista/Planta»: no hay esa opción; el programa no tiene menú");
    esperaFallo(ejecuta(GRUA, "tecla Esc; tecla d"), 2, "orden 2 «tecla d»: el programa ya ha terminado");
    esperaFallo(ejecuta(GRUA, "arrastra 1 1"), 2, "no hay ningún botón pulsado; es mueve");
    esperaFallo(ejecuta(GRUA, "boton IZQUIERDO arriba 1 1"), 2, "ese botón ya está arriba");
}

TEST(Opciones, AyudaLasEnumera) {
    const Ejecucion e = ejecuta(GRUA, "", 240, 180, {"-ayuda"});
    EXPECT_EQ(e.estado, 0);
    for (const char *que : {"-geometry", "-guion", "-ppm", "-mide", "-ayuda", "tecla", "especial", "boton",
                            "arrastra", "mueve", "rueda", "menu", "tamano", "espera", "captura"})
        EXPECT_NE(e.salida.find(que), std::string::npos) << que;
    EXPECT_NE(e.salida.find("\nuso: grua [opciones de GLUT]"), std::string::npos) << e.salida;
    EXPECT_TRUE(e.imagen.rgb.empty());
}

// También la de los programas que no saben nada de ella.
TEST(Opciones, AyudaNoDibujaNunca) {
    const Ejecucion e = ejecuta("../tests/tipos_propios", "", 9, 9, {"-ayuda"});
    EXPECT_EQ(e.estado, 0);
    EXPECT_NE(e.salida.find("-guion"), std::string::npos);
    EXPECT_TRUE(e.imagen.rgb.empty());
}

// Lo que no cabe en el disco no se calla: texto, ayuda y medidas.
TEST(Salida, LlenaEsUnError) {
    const std::string grua = std::string("'" LAB_EJECUTABLES "/") + GRUA + "' -ppm /dev/null ";
    for (const std::string &orden :
         {grua + "-mide 1", grua + "-ayuda", std::string("'" LAB_EJECUTABLES "/ch01_intro/info_opengl'")}) {
        const int estado = std::system((orden + " >/dev/full 2>/dev/null").c_str());
        EXPECT_EQ(WIFEXITED(estado) ? WEXITSTATUS(estado) : -1, 1) << orden;
    }
}

TEST(Opciones, MideEscribeUnaLineaTsv) {
    const Ejecucion e = ejecuta("ch01_intro/shader_basico", "", 240, 180, {"-mide", "5"});
    EXPECT_EQ(e.estado, 0) << e.errores;
    EXPECT_EQ(std::count(e.salida.begin(), e.salida.end(), '\n'), 1);
    EXPECT_EQ(std::count(e.salida.begin(), e.salida.end(), '\t'), 9);
    EXPECT_EQ(e.salida.rfind("shader_basico\t240x180\t", 0), 0u) << e.salida;
    EXPECT_NE(e.salida.find("\t1\t"), std::string::npos) << "es un triángulo: " << e.salida;
}

TEST(Imagen, SiNoSePuedeGuardarAcabaCon1YNoQuedaNada) {
    esperaFallo(ejecuta(GRUA, "", 240, 180, {"-ppm", "/no/hay/x.ppm"}), 1,
                "no puedo guardar «/no/hay/x.ppm»");
    esperaFallo(ejecuta(GRUA, "", 240, 180, {"-ppm", "/dev/full"}), 1, "no puedo guardar «/dev/full»");
    esperaFallo(ejecuta(GRUA, "captura /no/hay/y.ppm"), 1, "no puedo guardar «/no/hay/y.ppm»");
}

TEST(Imagen, CualquierTamano) {
    for (const auto &[ancho, alto] : {std::pair(1, 1), {1, 300}, {300, 1}, {3, 2}, {1001, 13}}) {
        const Ejecucion e = ejecuta(GRUA, "", ancho, alto);
        EXPECT_EQ(e.estado, 0) << e.errores;
        EXPECT_EQ(e.imagen.ancho, ancho);
        EXPECT_EQ(e.imagen.alto, alto);
    }
}

// Cambiar de tamaño y volver deja la misma imagen; capturar en medio no la toca.
TEST(Imagen, CambiarDeTamanoYVolver) {
    const Ejecucion e = ejecuta(GRUA),
                    vuelta = ejecuta(GRUA, "tamano 1 1; tamano 500 20; captura c.ppm; tamano 240 180");
    EXPECT_EQ(vuelta.estado, 0) << vuelta.errores;
    EXPECT_EQ(e.imagen.rgb, vuelta.imagen.rgb);
}

/// Lo más que ha ocupado algún proceso que ha esperado éste, en MiB.
static long memoriaDeLosHijos() {
    rusage uso;
    getrusage(RUSAGE_CHILDREN, &uso);
    return uso.ru_maxrss / 1024;
}

// El programa que lee a un buffer lo tiene enlazado aunque en medio se capture.
TEST(Imagen, CapturarDejaElBufferDelPrograma) {
    const Ejecucion e = ejecuta(DEFECTUOSO, "captura a.ppm; tamano 9 8", 9, 9, {"lectura"});
    EXPECT_EQ(e.estado, 0) << e.errores;
    EXPECT_EQ(e.salida, "1\n1\n");
}

// 800 tamaños distintos ocupan como 200: cada framebuffer nuevo no se queda con la memoria del anterior.
TEST(Imagen, CambiarDeTamanoNoOcupaMas) {
    const auto tamanos = [](int cuantos) {
        std::string guion;
        for (int i = 0; i < cuantos; ++i)
            guion += "tamano " + std::to_string(200 + i) + " " + std::to_string(600 - i / 2) + ";";
        return guion;
    };
    EXPECT_EQ(ejecuta(GRUA, tamanos(200)).estado, 0);
    const long antes = memoriaDeLosHijos();
    EXPECT_EQ(ejecuta(GRUA, tamanos(800)).estado, 0);
    EXPECT_LT(memoriaDeLosHijos() - antes, 200);
}

TEST(ErrorDeOpenGL, AcabaCon3YDiceDonde) {
    esperaFallo(ejecuta(DEFECTUOSO, "", 9, 9, {"enum"}), 3, "error de OpenGL al dibujar: GL_INVALID_ENUM");
    esperaFallo(ejecuta(DEFECTUOSO, "", 9, 9, {"callado"}), 3, "error de OpenGL al dibujar: GL_INVALID_ENUM");
    esperaFallo(ejecuta(DEFECTUOSO, "", 9, 9, {"inicio"}), 3,
                "error de OpenGL antes de glutMainLoop: GL_INVALID_ENUM");
    esperaFallo(ejecuta(DEFECTUOSO, "", 9, 9, {"exit"}), 3, "error de OpenGL: GL_INVALID_ENUM");
}

// Lo que no es OpenGL 3.1 con GLSL 1.40 no pasa.
TEST(ErrorDeOpenGL, EsUn31Estricto) {
    esperaFallo(ejecuta(DEFECTUOSO, "", 9, 9, {"begin"}), 3, "error de OpenGL al dibujar");
    esperaFallo(ejecuta(DEFECTUOSO, "", 9, 9, {"sin_vao"}), 3,
                "error de OpenGL al dibujar: GL_INVALID_OPERATION");
    const Ejecucion e = ejecuta(DEFECTUOSO, "", 9, 9, {"glsl150"});
    EXPECT_EQ(e.estado, 1);
    EXPECT_NE(e.errores.find("tests/costura/glsl150.vert:1: error: GLSL 1.50 is not supported"),
              std::string::npos)
        << e.errores;
}

TEST(ErrorDelPrograma, DosVentanas) {
    esperaFallo(ejecuta(DEFECTUOSO, "", 9, 9, {"dos_ventanas"}), 1,
                "glut_sin_ventana solo tiene una ventana");
}

TEST(Shader, ElQueFaltaDiceDondeSeHaBuscado) {
    esperaFallo(ejecuta(DEFECTUOSO, "", 9, 9, {"sin_shader"}), 1,
                "no encuentro «tests/costura/no_esta.vert»; lo he buscado en ");
}

TEST(Shader, ElErrorDeUnFicheroIncluidoNombraEseFichero) {
    esperaFallo(ejecuta(DEFECTUOSO, "", 9, 9, {"inclusion"}), 1,
                "tests/costura/inclusion.glsl:3: error: `y' undeclared — «return 2.0 * y;»");
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
    std::ofstream(raiz / "tests/costura/recarga.vert")
        << "#version 140\nvoid main() {\n    gl_Position = vec4(4 * "
           "(gl_VertexID % 2) - 1, 4 * (gl_VertexID / 2) - 1, 0.0, "
           "1.0);\n}\n";
    setenv("LAB_RAIZ", raiz.c_str(), 1);
    const Ejecucion e =
        ejecuta(DEFECTUOSO, "espera 10; especial F5; espera 10; especial F5", 9, 9, {"recarga"});
    unsetenv("LAB_RAIZ");
    EXPECT_EQ(e.estado, 0) << e.errores;
    EXPECT_EQ(e.salida, "255 0 0\n255 0 0\n0 255 0\n");
    EXPECT_EQ(e.errores.rfind("defectuoso: aviso: tests/costura/recarga.frag:4: error: ", 0), 0u)
        << e.errores;
}

TEST(TeclasComunes, F11LlenaLaPantallaYVuelve) {
    const Ejecucion e = ejecuta(GRUA), llena = ejecuta(GRUA, "especial F11"),
                    vuelta = ejecuta(GRUA, "especial F11; especial F11");
    EXPECT_EQ(llena.imagen.ancho, 1920);
    EXPECT_EQ(llena.imagen.alto, 1080);
    EXPECT_EQ(vuelta.imagen.rgb, e.imagen.rgb);
}

TEST(TeclasComunes, F12GuardaLaVentanaSinPisarOtra) {
    const Ejecucion e = ejecuta(GRUA, "especial F12; tecla d; especial F12", 24, 18);
    EXPECT_EQ(e.estado, 0) << e.errores;
    EXPECT_EQ(e.salida, "guardado grua-1.ppm\nguardado grua-2.ppm\n");
}

// El reloj solo avanza con `espera`; los temporizadores vencen en orden, y entre iguales el que antes se
// pidió.
TEST(Reloj, LosTemporizadoresVencenEnOrden) {
    const Ejecucion e = ejecuta(DEFECTUOSO, "tecla a; espera 249; espera 1; espera 150", 9, 9, {"tiempo"});
    EXPECT_EQ(e.estado, 0) << e.errores;
    EXPECT_EQ(e.salida,
              "100 a 100 ms\n100 a 200 ms\n250 a 250 ms\nmenu 1 en el 0\n100 a 300 ms\n100 a 400 ms\n");
}

// Ni uno de 0 ms, que se pide otra vez al vencer, para el reloj.
TEST(Reloj, ElDe0VenceAlMilisegundo) {
    EXPECT_EQ(ejecuta(DEFECTUOSO, "espera 3", 9, 9, {"enseguida"}).salida, "1\n2\n3\n");
}

// Cada opción llama a la función del menú en que está, que es el actual mientras dura; después vuelve a serlo el de antes.
TEST(Menu, SeEligePorSuRuta) {
    const Ejecucion e =
        ejecuta(DEFECTUOSO, "menu Vista/Perfil; menu Vista/Planta; menu Salir; tecla a", 9, 9, {"menu"});
    EXPECT_EQ(e.estado, 0) << e.errores;
    EXPECT_EQ(e.salida, "submenu 2 en el 1\nsubmenu 1 en el 1\nmenu 3 en el 2\ntecla en el 1\n");
    for (const char *mal : {"menu Vista", "menu Vista/Alzado", "menu Salir/Planta", "menu Planta"})
        esperaFallo(ejecuta(DEFECTUOSO, mal, 9, 9, {"menu"}), 2,
                    "no hay esa opción; el menú tiene «Vista/…» «Con ejes» «Salir»");
}

TEST(Menu, UnaOpcionPuedeCambiar) {
    const Ejecucion e = ejecuta(DEFECTUOSO, "menu Con ejes; menu Sin ejes; menu Salir", 9, 9, {"menu"});
    EXPECT_EQ(e.estado, 0) << e.errores;
    EXPECT_EQ(e.salida, "menu 4 en el 2\nmenu 5 en el 2\nmenu 3 en el 2\n");
    esperaFallo(ejecuta(DEFECTUOSO, "menu Con ejes; menu Con ejes", 9, 9, {"menu"}), 2,
                "el menú tiene «Vista/…» «Sin ejes» «Salir»");
}

// Mientras está abierto el programa no ve el ratón, ni el clic que lo cierra; sí que ese botón se suelta.
TEST(Menu, AbiertoSeQuedaElRaton) {
    const Ejecucion e =
        ejecuta(DEFECTUOSO,
                "mueve 1 1; boton DERECHO abajo 1 1; boton DERECHO arriba 1 1; mueve 2 2; "
                "boton IZQUIERDO abajo 2 2; boton IZQUIERDO arriba 2 2; boton IZQUIERDO abajo 3 3",
                9, 9, {"menu"});
    EXPECT_EQ(e.estado, 0) << e.errores;
    EXPECT_EQ(e.salida, "movimiento 1 1\nboton 0 1\nmovimiento 3 3\nboton 0 0\n");
    EXPECT_EQ(
        ejecuta(DEFECTUOSO, "boton DERECHO abajo 1 1; menu Salir; boton DERECHO arriba 1 1", 9, 9, {"menu"})
            .salida,
        "movimiento 1 1\nmenu 3 en el 2\nboton 2 1\n");
}

TEST(Menu, ElBorradoDejaSuSitioVacio) {
    const Ejecucion e = ejecuta(DEFECTUOSO, "menu Vista", 9, 9, {"menu_borrado"});
    EXPECT_EQ(e.estado, 0) << e.errores;
    EXPECT_EQ(e.salida, "menu -1 en el 2\n");
    esperaFallo(ejecuta(DEFECTUOSO, "", 9, 9, {"submenu_que_no_hay"}), 1,
                "glutAddSubMenu(77): no hay ese menú");
}

// Una vez tras cada orden, cuando ya se ha dibujado lo que ella pedía; luego se dibuja lo que pide el ocio.
TEST(Ocio, TrasCadaOrdenYSePuedeQuitar) {
    const Ejecucion e =
        ejecuta(DEFECTUOSO, "tecla a; espera 5; tamano 8 8; tecla b; tecla c", 9, 9, {"ocio"});
    EXPECT_EQ(e.estado, 0) << e.errores;
    EXPECT_EQ(e.salida, "dibuja\nocio 1\ndibuja\nocio 2\ndibuja\ndibuja\nocio 3\ndibuja\n");
}

TEST(Rueda, SinFuncionPropiaSonLosBotones3Y4) {
    EXPECT_EQ(ejecuta(DEFECTUOSO, "rueda +1 5 5; rueda -1 5 5", 9, 9, {"menu"}).salida,
              "movimiento 5 5\nboton 3 0\nboton 3 1\nboton 4 0\nboton 4 1\n");
}

TEST(Muestras, SePuedenPedirYNoLasHay) {
    const Ejecucion e = ejecuta(DEFECTUOSO, "", 9, 9, {"muestras"});
    EXPECT_EQ(e.estado, 0) << e.errores;
    EXPECT_EQ(e.salida, "0\n");
}

TEST(Opciones, GeometryPuedeMasQueElPrograma) {
    const Ejecucion e = ejecuta("../tests/tipos_propios", "", 9, 7);
    EXPECT_EQ(e.imagen.ancho, 9);
    EXPECT_EQ(e.imagen.alto, 7);
}

TEST(EspacioDeNombres, UnProgramaPuedeTenerTiposYFuncionesQueSeLlamenIgual) {
    const Ejecucion e = ejecuta("../tests/tipos_propios", "tecla a; espera 3; tamano 8 8", 9, 9);
    EXPECT_EQ(e.estado, 0) << e.errores;
    EXPECT_EQ(e.salida, "3 7 1.5 entrada 2 ninguna no hay\n");
    ASSERT_EQ(e.imagen.ancho, 8);
    EXPECT_EQ(pixel(e.imagen, 4, 4).g, 255);
}

// Una orden con ×N son N órdenes seguidas, cada una con su dibujo y su ocio.
TEST(Guion, RepetirEsEscribirlaOtraVez) {
    EXPECT_EQ(ejecuta(DEFECTUOSO, "tecla a ×2; espera 1 ×2", 9, 9, {"ocio"}).salida,
              ejecuta(DEFECTUOSO, "tecla a; tecla a; espera 1; espera 1", 9, 9, {"ocio"}).salida);
    EXPECT_EQ(ejecuta(GRUA, "tecla d ×7").imagen.rgb,
              ejecuta(GRUA, "tecla d; tecla d; tecla d; tecla d; tecla d; tecla d; tecla d").imagen.rgb);
    esperaFallo(ejecuta(GRUA, "tecla Esc ×2"), 2, "orden 1 «tecla Esc ×2»: el programa ya ha terminado");
}

// La escala es la de la ventana que haya al mover el ratón.
TEST(Guion, EscalaCuandoSeMueve) {
    const Ejecucion e =
        ejecuta(DEFECTUOSO, "mueve 1 1; escala 8 6; mueve 1 1; tamano 16 24; mueve 1 1; rueda +1 4 3", 32, 24,
                {"menu"});
    EXPECT_EQ(e.estado, 0) << e.errores;
    EXPECT_EQ(e.salida,
              "movimiento 1 1\nmovimiento 4 4\nmovimiento 2 8\nmovimiento 8 12\nboton 3 0\nboton 3 1\n");
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
