// GLUT sin ventana: la parte de la API de FreeGLUT que usan los programas, sobre un contexto OpenGL sin pantalla
// (contexto.h). No hay usuario ni reloj: los sucesos salen de un guion (guion.h) y el tiempo es virtual, así que
// la misma orden da siempre la misma imagen. Los programas incluyen <GL/freeglut.h> y no saben con qué se enlazan.
//
// Están, con el significado que tienen en FreeGLUT:
//   glutInit glutInitWindowSize glutInitWindowPosition glutInitDisplayMode glutInitContextVersion
//   glutInitContextFlags glutInitContextProfile glutSetOption glutCreateWindow glutDestroyWindow glutGetWindow
//   glutSetWindowTitle glutReshapeWindow glutFullScreenToggle glutSetCursor glutDisplayFunc glutReshapeFunc
//   glutKeyboardFunc glutKeyboardUpFunc glutSpecialFunc glutSpecialUpFunc glutMouseFunc glutMotionFunc
//   glutPassiveMotionFunc glutMouseWheelFunc glutIdleFunc glutTimerFunc glutCloseFunc glutPostRedisplay
//   glutSwapBuffers glutGet glutMainLoop glutLeaveMainLoop glutCreateMenu glutSetMenu glutAddMenuEntry
//   glutAddSubMenu glutAttachMenu
// Y tres que FreeGLUT no tiene, para quien da los sucesos desde fuera (la página web):
//   glutOrden glutOpciones glutRedibuja
// Cualquier otra no está, y el enlazador lo dice. Un valor de glutGet o glutSetOption que no se imita termina
// el programa con un mensaje.
//
// Se aparta de FreeGLUT en que
// - hay una sola ventana, y sin pantalla no tiene posición, título (salvo en la web) ni cursor: llamarlas no hace nada;
// - la pantalla completa es de 1920×1080 y mide 0 mm, por lo que se sabe que no la hay;
// - la ventana no tiene muestras aunque se pida GLUT_MULTISAMPLE, salvo con EGL y LAB_SUAVIZA en el entorno;
// - la función de glutIdleFunc se llama una vez tras cada orden del guion, después de dibujar lo que ella pida;
// - un temporizador de 0 ms espera 1 ms;
// - las teclas modificadoras no se ven;
// - al acabar el guion la ventana se cierra, como si lo hiciera el usuario, y glutMainLoop vuelve.
//
// Opciones, órdenes del guion y estados de salida: las escribe cualquier programa sin ventana con -ayuda (AYUDA
// en guion.cpp). El contexto es un OpenGL 3.1 core con GLSL 1.40 y nada más, ni siquiera lo obsoleto (no hay líneas de
// más de un píxel). Todo lo que no es glut* está en el espacio de nombres sin_ventana: un programa puede tener tipos y
// funciones que se llamen igual. Un error de OpenGL, o un mensaje
// de depuración de error, de comportamiento indefinido o de función obsoleta, acaba el programa con estado 3,
// aunque el programa se trague el error.
#pragma once
// clang-format off
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/freeglut.h>
// clang-format on

extern "C" {
/// Atiende un guion cuando glutMainLoop ya ha cedido el control. Devuelve si el programa ha terminado.
int glutOrden(const char *guion);

/// Las opciones de los menús del programa, una por línea: «Submenú/Opción».
const char *glutOpciones(void);
/// El mismo cuadro otra vez, ahora.
void glutRedibuja(void);
}
