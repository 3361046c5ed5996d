# programa(nombre REF "L1.2 E3.5" TITULO "…" [CONSOLA])
#   Compila <nombre>.cpp una sola vez y lo enlaza para cada destino de LAB_DESTINOS:
#   build/<destino>/<capítulo>/<nombre>. CONSOLA: escribe texto y no tiene imagen.
#
# caso(programa nombre [GUION "orden; orden"] [ARGUMENTOS a b …] [LINEAS | TOLERANCIA "…" MOTIVO "…"])
#   Una imagen de ese programa: tras el guion debe ser tests/golden/<capítulo>/<programa>[-nombre].ppm;
#   el caso que se llama base no lleva sufijo. TOLERANCIA cambia la que usa el comparador cuando la imagen no es del
#   mismo OpenGL que el golden, y exige un MOTIVO. LINEAS es la de los casos con puntos o líneas: OpenGL deja
#   a cada controlador elegir qué píxeles pintan, y por tanto dónde las tapa una cara.
#
# Con esas dos funciones se escriben build/catalogo.tsv (capítulo, programa, referencia, título) y
# build/casos.tsv (capítulo, programa, caso, guion, argumentos, tolerancia): todo lo demás sale de ahí.

define_property(GLOBAL PROPERTY LAB_CATALOGO BRIEF_DOCS "Filas de build/catalogo.tsv" FULL_DOCS "-")
define_property(GLOBAL PROPERTY LAB_CASOS BRIEF_DOCS "Filas de build/casos.tsv" FULL_DOCS "-")

function(programa nombre)
  cmake_parse_arguments(P "CONSOLA" "REF;TITULO" "" ${ARGN})
  if(P_UNPARSED_ARGUMENTS OR NOT P_REF OR NOT P_TITULO)
    message(FATAL_ERROR "programa(${nombre}): faltan REF o TITULO, o sobra «${P_UNPARSED_ARGUMENTS}»")
  endif()
  get_filename_component(capitulo ${CMAKE_CURRENT_SOURCE_DIR} NAME)
  add_library(${nombre} OBJECT ${nombre}.cpp)
  target_link_libraries(${nombre} PRIVATE comun avisos)
  foreach(destino IN LISTS LAB_DESTINOS)
    set(ejecutable ${nombre}_${destino})
    add_executable(${ejecutable} $<TARGET_OBJECTS:${nombre}>)
    target_link_libraries(${ejecutable} PRIVATE comun glut_${destino})
    set_target_properties(${ejecutable} PROPERTIES OUTPUT_NAME ${nombre}
      RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/${destino}/${capitulo})
  endforeach()
  add_dependencies(programas ${nombre}_ventana ${nombre}_${LAB_SIN_VENTANA})
  install(TARGETS ${nombre}_ventana DESTINATION ${capitulo})
  set_property(GLOBAL APPEND PROPERTY LAB_CATALOGO "${capitulo}\t${nombre}\t${P_REF}\t${P_TITULO}")
  if(P_CONSOLA)
    set_property(GLOBAL APPEND PROPERTY LAB_CONSOLA ${nombre})
  endif()
endfunction()

function(capitulo titulo)
endfunction()

function(caso programa nombre)
  cmake_parse_arguments(PARSE_ARGV 2 C "LINEAS" "GUION;TOLERANCIA;MOTIVO;MIRA;BORDE" "ARGUMENTOS")
  if(C_UNPARSED_ARGUMENTS OR (C_TOLERANCIA AND NOT C_MOTIVO))
    message(FATAL_ERROR "caso(${programa} ${nombre}): sobra «${C_UNPARSED_ARGUMENTS}» o falta el MOTIVO")
  endif()
  if(C_LINEAS)
    set(C_TOLERANCIA "4 3 255")
  endif()
  get_filename_component(capitulo ${CMAKE_CURRENT_SOURCE_DIR} NAME)
  # El guion lleva `;`, que CMake toma por separador de listas: en las filas viaja como \;
  string(REPLACE ";" "\\;" guion "${C_GUION}")
  string(REPLACE ";" " " argumentos "${C_ARGUMENTOS}")
  foreach(campo guion argumentos C_TOLERANCIA)
    if(NOT ${campo})
      set(${campo} "-")
    endif()
  endforeach()
  set_property(GLOBAL APPEND PROPERTY LAB_CASOS
    "${capitulo}\t${programa}\t${nombre}\t${guion}\t${argumentos}\t${C_TOLERANCIA}")
  if(C_BORDE)
    set_property(GLOBAL APPEND PROPERTY LAB_CASOS_QUE_LLEGAN_AL_BORDE ${programa}.${nombre})
  endif()
  set_property(GLOBAL APPEND PROPERTY LAB_NOMBRES_DE_CASOS ${programa}.${nombre})
  set_property(GLOBAL PROPERTY LAB_GUION_${programa}.${nombre} "${C_GUION}")
endfunction()

function(escribe_catalogo)
  get_property(filas GLOBAL PROPERTY LAB_CATALOGO)
  set(texto "")
  foreach(fila IN LISTS filas)
    string(APPEND texto "${fila}\n")
  endforeach()
  file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/catalogo.tsv CONTENT "${texto}")
  get_property(filas GLOBAL PROPERTY LAB_CASOS)
  set(texto "")
  foreach(fila IN LISTS filas)
    string(APPEND texto "${fila}\n")
  endforeach()
  file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/casos.tsv CONTENT "${texto}")
endfunction()
