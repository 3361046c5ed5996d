# capitulo("Transformaciones geométricas")
#   El título del capítulo de esta carpeta; va el primero.
#
# programa(nombre REF "L1.2 E3.5" TITULO "…" [CONSOLA])
#   Compila <nombre>.cpp una sola vez y lo enlaza para cada destino de LAB_DESTINOS:
#   build/<destino>/<capítulo>/<nombre>. CONSOLA: escribe texto y no tiene imagen.
#
# caso(programa nombre [GUION "orden; orden"] [ARGUMENTOS a b …] [MIRA "…"] [BORDE "…"] [ANIMA "N orden"] [TOLERANCIA "…" MOTIVO "…"])
#   Una imagen de ese programa: tras el guion debe ser tests/golden/<capítulo>/<programa>[-nombre].ppm;
#   el caso que se llama base no lleva sufijo.
#   MIRA: una frase, a qué hay que mirar; es el pie de la imagen en la galería.
#   BORDE: por qué la escena llega al borde de la ventana; sin él, no debe llegar.
#   ANIMA: en la galería se mueve: N cuadros, a diez por segundo, y la orden del guion que lleva de cada uno al siguiente.
#   TOLERANCIA cambia la que usa el comparador cuando la imagen no es del mismo OpenGL que el golden, y exige un MOTIVO.
#
# Con esas funciones se escriben build/catalogo.tsv y build/casos.tsv, y todo lo demás (las pruebas, ./lab, la galería,
# docs/programas.md) sale de ahí. Sus columnas, donde lo que falta es un guion y lo nuevo se añade al final:
#   catalogo.tsv: capítulo, programa, referencia, título, consola, título del capítulo
#   casos.tsv: capítulo, programa, caso, guion, argumentos, tolerancia, nombre del fichero, mira, borde, anima

foreach(tabla CATALOGO CASOS NOMBRES_DE_CASOS)
  define_property(GLOBAL PROPERTY LAB_${tabla} BRIEF_DOCS "Filas de los TSV" FULL_DOCS "-")
endforeach()

# file(GLOB) en esta carpeta aunque se llame a[b]: esos corchetes no son del patrón.
function(busca variable patron)
  string(REPLACE "[" "[[]" carpeta "${CMAKE_CURRENT_SOURCE_DIR}")
  file(GLOB ficheros CONFIGURE_DEPENDS RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" "${carpeta}/${patron}")
  set(${variable} "${ficheros}" PARENT_SCOPE)
endfunction()

# Añade a una tabla la fila de esos campos.
function(anade_fila tabla)
  set(fila "")
  foreach(campo IN LISTS ARGN)
    if("${${campo}}" STREQUAL "")
      set(${campo} "-")
    endif()
    string(APPEND fila "\t${${campo}}")
  endforeach()
  string(SUBSTRING "${fila}" 1 -1 fila)
  set_property(GLOBAL APPEND_STRING PROPERTY LAB_${tabla} "${fila}\n")
endfunction()

function(exige_nombre nombre)
  if(NOT nombre MATCHES "^[a-z0-9_]+$")
    message(FATAL_ERROR "«${nombre}»: un nombre lleva solo minúsculas sin acento, cifras y _")
  endif()
endfunction()

function(capitulo titulo)
  set(titulo_capitulo "${titulo}" PARENT_SCOPE)
endfunction()

function(programa nombre)
  cmake_parse_arguments(PARSE_ARGV 1 P "CONSOLA" "REF;TITULO" "")
  if(P_UNPARSED_ARGUMENTS OR NOT P_REF OR NOT P_TITULO)
    message(FATAL_ERROR "programa(${nombre}): faltan REF o TITULO, o sobra «${P_UNPARSED_ARGUMENTS}»")
  endif()
  exige_nombre(${nombre})
  get_filename_component(capitulo "${CMAKE_CURRENT_SOURCE_DIR}" NAME)
  add_library(${nombre} OBJECT ${nombre}.cpp)
  target_link_libraries(${nombre} PRIVATE comun avisos)
  if(TARGET precompilada)
    target_precompile_headers(${nombre} REUSE_FROM precompilada)
  endif()
  set_property(GLOBAL APPEND PROPERTY LAB_PROGRAMAS ${nombre})
  foreach(destino IN LISTS LAB_DESTINOS)
    set(ejecutable ${nombre}_${destino})
    add_executable(${ejecutable} $<TARGET_OBJECTS:${nombre}>)
    target_link_libraries(${ejecutable} PRIVATE comun glut_${destino})
    set_target_properties(${ejecutable} PROPERTIES OUTPUT_NAME ${nombre}
      RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${destino}/${capitulo}")
  endforeach()
  if(TARGET programas)
    add_dependencies(programas ${nombre}_ventana ${nombre}_${LAB_SIN_VENTANA})
    install(TARGETS ${nombre}_ventana DESTINATION ${capitulo})
  endif()
  set(consola "")
  if(P_CONSOLA)
    set(consola "consola")
  endif()
  anade_fila(CATALOGO capitulo nombre P_REF P_TITULO consola titulo_capitulo)
endfunction()

function(caso programa nombre)
  cmake_parse_arguments(PARSE_ARGV 2 C "" "GUION;MIRA;BORDE;ANIMA;TOLERANCIA;MOTIVO" "ARGUMENTOS")
  if(C_UNPARSED_ARGUMENTS OR (C_TOLERANCIA AND NOT C_MOTIVO))
    message(FATAL_ERROR "caso(${programa} ${nombre}): sobra «${C_UNPARSED_ARGUMENTS}» o falta el MOTIVO")
  endif()
  if(C_ANIMA AND NOT C_ANIMA MATCHES "^[1-9][0-9]?[0-9]? ")
    message(FATAL_ERROR "caso(${programa} ${nombre}): ANIMA es el número de cuadros, hasta 999, y la orden que lleva al siguiente")
  endif()
  exige_nombre(${nombre})
  if(NOT TARGET ${programa})
    message(FATAL_ERROR "caso(${programa} ${nombre}): no hay ningún programa «${programa}»")
  endif()
  get_filename_component(capitulo "${CMAKE_CURRENT_SOURCE_DIR}" NAME)
  string(REPLACE ";" " " argumentos "${C_ARGUMENTOS}")
  set(fichero ${programa}-${nombre})
  if(nombre STREQUAL "base")
    set(fichero ${programa})
  endif()
  anade_fila(CASOS capitulo programa nombre C_GUION argumentos C_TOLERANCIA fichero C_MIRA C_BORDE C_ANIMA)
  if(C_BORDE)
    set_property(GLOBAL APPEND PROPERTY LAB_CASOS_QUE_LLEGAN_AL_BORDE ${programa}.${nombre})
  endif()
  set_property(GLOBAL APPEND PROPERTY LAB_NOMBRES_DE_CASOS ${programa}.${nombre})
endfunction()

# Los índices de todos los capítulos, que quedan en la variable `capitulos`, y el catálogo que sale de ellos.
macro(lee_capitulos)
  busca(indices ch*/CMakeLists.txt)
  foreach(indice IN LISTS indices)
    get_filename_component(capitulo ${indice} DIRECTORY)
    list(APPEND capitulos ${capitulo})
    add_subdirectory(${capitulo})
  endforeach()
  escribe_catalogo()
endmacro()

function(escribe_catalogo)
  get_property(catalogo GLOBAL PROPERTY LAB_CATALOGO)
  get_property(casos GLOBAL PROPERTY LAB_CASOS)
  file(GENERATE OUTPUT "${CMAKE_BINARY_DIR}/catalogo.tsv" CONTENT "${catalogo}")
  file(GENERATE OUTPUT "${CMAKE_BINARY_DIR}/casos.tsv" CONTENT "${casos}")
endfunction()
