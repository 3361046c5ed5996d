# Los fuentes de common/, para todos los enlaces. Quien lo incluye ha puesto antes LAB_FUENTES y LAB_GENERADO: dónde buscan los programas
# lo que leen y lo que se genera.
if(WIN32)
  set(sistema windows)
else()
  set(sistema posix)
endif()
add_library(comun STATIC
  common/ayuda.cpp common/buferes.cpp common/captura.cpp common/encima.cpp common/error.cpp common/imagen.cpp common/letra.cpp
  common/malla.cpp common/motivo.cpp common/orbita.cpp common/proyeccion.cpp common/recuadro.cpp common/rotulo.cpp common/rutas.cpp
  common/shader.cpp common/textura.cpp common/trazo.cpp common/ventana.cpp common/sistema/${sistema}.cpp)
target_include_directories(comun PUBLIC common "${CMAKE_SOURCE_DIR}")
target_compile_definitions(comun PRIVATE LAB_FUENTES="${LAB_FUENTES}" LAB_GENERADO="${LAB_GENERADO}")
target_link_libraries(comun PUBLIC -Wl,--wrap=glutSwapBuffers,--wrap=glutMotionFunc,--wrap=glutPassiveMotionFunc # lo dice common/ayuda.cpp
  PRIVATE avisos)
recoge_controles(comun)

# El GLUT sin ventana, menos su contexto: cada enlace tiene el suyo.
add_library(glut_sin_ventana OBJECT EXCLUDE_FROM_ALL
  common/glut_sin_ventana/diario.cpp common/glut_sin_ventana/glut.cpp common/glut_sin_ventana/guion.cpp
  common/glut_sin_ventana/medida.cpp common/glut_sin_ventana/menus.cpp)
target_link_libraries(glut_sin_ventana PRIVATE comun avisos)
