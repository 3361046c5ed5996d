# Los fuentes de common/, para todos los enlaces. Quien lo incluye ha puesto antes LAB_FUENTES y LAB_GENERADO: dónde buscan los programas
# lo que leen y lo que se genera.
if(WIN32)
  set(sistema windows)
else()
  set(sistema posix)
endif()
add_library(comun STATIC
  common/buferes.cpp common/captura.cpp common/error.cpp common/imagen.cpp common/malla.cpp common/orbita.cpp
  common/proyeccion.cpp common/rutas.cpp common/shader.cpp common/textura.cpp common/ventana.cpp
  common/encima/ayuda.cpp common/encima/encima.cpp common/encima/letra.cpp common/encima/recuadro.cpp common/encima/rotulo.cpp
  common/encima/trazo.cpp glut/sistema/guarda.cpp glut/sistema/motivo.cpp glut/sistema/${sistema}.cpp)
target_include_directories(comun PUBLIC common common/encima "${CMAKE_SOURCE_DIR}")
target_compile_definitions(comun PRIVATE LAB_FUENTES="${LAB_FUENTES}" LAB_GENERADO="${LAB_GENERADO}")
target_link_libraries(comun PUBLIC -Wl,--wrap=glutSwapBuffers,--wrap=glutMotionFunc,--wrap=glutPassiveMotionFunc # lo dice common/encima/ayuda.cpp
  PRIVATE avisos)

# El GLUT sin ventana, menos su contexto: cada enlace tiene el suyo.
add_library(glut_sin_ventana OBJECT EXCLUDE_FROM_ALL
  glut/sin_ventana/diario.cpp glut/sin_ventana/glut.cpp glut/sin_ventana/guion.cpp
  glut/sin_ventana/medida.cpp glut/sin_ventana/menus.cpp)
target_link_libraries(glut_sin_ventana PRIVATE comun avisos)
