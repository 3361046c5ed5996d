// Una textura 3D que se traslada (§12.1): el ruido llena el espacio y el objeto, quieto, lo corta en cada instante por
// otro sitio. La textura es periódica y en un periodo avanza justo una vez su lado: la animación no tiene principio ni
// fin.
// Controles: espacio pausa · s adelanta medio segundo · d una décima · h diez horas · ratón orbita · Esc termina.
#include "animacion.h"
#include "buferes.h"
#include "ch03_transformaciones/transformaciones.h"
#include "ch08_texturas_avanzadas/ruido.h"
#include "colores.h"
#include "imagen.h"
#include "malla.h"
#include "orbita.h"
#include "proyeccion.h"
#include "recuadro.h"
#include "reloj.h"
#include "shader.h"
#include "ventana.h"

static const double PERIODO = 4; // segundos
static const int LADO = 64, CELDAS = 4, OCTAVAS = 3;
static const float ESCALA = 0.4f;

static struct {
    GLuint programa, textura;
    Buferes esfera, toro;
    Orbita orbita = {0.4f, 0.4f, 9.5f};
    Reloj reloj;
} estado;

// De un canal, 64³: un cuarto de megabyte. El ruido, de −1 a 1, va de 0 a 255.
static GLuint creaTexturaRuido() {
    std::vector<unsigned char> texels;
    for (int i = 0; i < LADO * LADO * LADO; ++i) {
        const glm::vec3 p =
            (glm::vec3(i % LADO, i / LADO % LADO, i / (LADO * LADO)) + 0.5f) * (float(CELDAS) / LADO);
        texels.push_back(enOchoBits(0.5f + 0.5f * turbulencia(p, OCTAVAS, glm::ivec3(CELDAS))));
    }
    GLuint textura;
    glGenTextures(1, &textura);
    glBindTexture(GL_TEXTURE_3D, textura);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_R8, LADO, LADO, LADO, 0, GL_RED, GL_UNSIGNED_BYTE, texels.data());
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR); // se repite en las tres: es lo normal
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    return textura;
}

static void dibuja() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    usaPrograma(estado.programa, camaraOrbita(estado.orbita), perspectivaVentana(0.4f, 1, 50));
    envia(estado.programa, "Ruido", 0);
    envia(estado.programa, "escala", ESCALA);
    envia(estado.programa, "tau", fase(tiempo(estado.reloj), PERIODO));
    glBindTexture(GL_TEXTURE_3D, estado.textura);
    for (const auto &[solido, M] :
         {std::pair(estado.esfera, glm::mat4(1)), std::pair(estado.toro, giroX(1.3f))}) {
        envia(estado.programa, "M", M);
        envia(estado.programa, "N", matrizNormal(M));
        dibujaMalla(solido);
    }
    rotulaTiempo(estado.reloj, BLANCO);
    tituloAnimado(estado.reloj, "Textura 3D animada");
    glutSwapBuffers();
}

int main(int argc, char **argv) {
    abreVentana(argc, argv, "Textura 3D animada", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
    estado.programa =
        creaPrograma("ch12_animacion/textura3d_animada.vert", "ch12_animacion/textura3d_animada.frag");
    estado.textura = creaTexturaRuido();
    estado.esfera = creaBuferes(esfera(segmentosEsfera(250)));
    estado.toro = creaBuferes(toro(1.7f, 0.22f, 120, 40));
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    ponFondo(FONDO_OSCURO);
    glutDisplayFunc(dibuja);
    orbitaConRaton(estado.orbita);
    animaConReloj(estado.reloj);
    glutMainLoop();
    return 0;
}
