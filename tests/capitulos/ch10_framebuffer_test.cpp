// Lo que seleccion deja en OpenGL, que en sus imágenes no se ve: el programa se incluye entero.

#define main programaSeleccion
#include "ch10_interaccion/seleccion.cpp"
#include "prueba.h"
#undef main

namespace {

class Framebuffer : public testing::Test {
protected:
    static void SetUpTestSuite() {
        static char nombre[] = "seleccion", opcion[] = "-geometry", talla[] = "240x180";
        char *argv[] = {nombre, opcion, talla, nullptr};
        int argc = 3;
        abreVentana(argc, argv, "Selección", GLUT_DOUBLE | GLUT_DEPTH | GLUT_MULTISAMPLE);
        inicia();
        creaFramebuffer(240, 180);
    }
};

GLint delRenderbuffer(int cual, GLenum que) {
    GLint valor = -1;
    glBindRenderbuffer(GL_RENDERBUFFER, estado.renderbuffer[cual]);
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, que, &valor);
    return valor;
}

} // namespace

// Un framebuffer enlazado para leer, o un recorte, no se nota hasta que alguien lee o borra la ventana.
TEST_F(Framebuffer, SeleccionarDejaEnlazadaLaVentana) {
    selecciona(180, 112);
    GLint leyendo = -1;
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &leyendo);
    EXPECT_EQ(leyendo, 0);
    EXPECT_FALSE(glIsEnabled(GL_SCISSOR_TEST));
}

// Cada identificador se guarda tal cual: ni muestras, ni mezcla, ni tramado.
TEST_F(Framebuffer, NadaCambiaElColor) {
    EXPECT_EQ(delRenderbuffer(COLOR, GL_RENDERBUFFER_SAMPLES), 0);
    for (const GLenum bits :
         {GL_RENDERBUFFER_RED_SIZE, GL_RENDERBUFFER_GREEN_SIZE, GL_RENDERBUFFER_BLUE_SIZE})
        EXPECT_EQ(delRenderbuffer(COLOR, bits), 8);
    EXPECT_EQ(delRenderbuffer(PROFUNDIDAD, GL_RENDERBUFFER_DEPTH_SIZE), 24);
    for (const GLenum nada : {GL_DITHER, GL_BLEND, GL_FRAMEBUFFER_SRGB})
        EXPECT_FALSE(glIsEnabled(nada));
    EXPECT_TRUE(glIsEnabled(GL_DEPTH_TEST));
}

// Si OpenGL no lo da, se dice.
TEST_F(Framebuffer, SiNoEstaCompletoSeDice) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    EXPECT_DEATH(creaFramebuffer(1 << 24, 1), "no admite el framebuffer de la selección");
}
