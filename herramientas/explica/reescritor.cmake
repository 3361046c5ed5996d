# Lo que reescribe un shader para que apunte lo que hace: texto a texto, sin OpenGL.
set(carpeta ${CMAKE_SOURCE_DIR}/herramientas/explica)
add_library(reescritor STATIC
  ${carpeta}/apuntes.cpp ${carpeta}/declaraciones.cpp ${carpeta}/deduce.cpp ${carpeta}/divisiones.cpp
  ${carpeta}/expresiones.cpp ${carpeta}/glsl.cpp ${carpeta}/lexico.cpp ${carpeta}/preludio.cpp ${carpeta}/sentencias.cpp ${carpeta}/tipos.cpp)
target_link_libraries(reescritor PRIVATE avisos)
set_target_properties(reescritor PROPERTIES POSITION_INDEPENDENT_CODE ON)
