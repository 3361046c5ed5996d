# capitulo("Transformaciones geométricas" [PORTADA grua-girada])
#   El título del capítulo de esta carpeta; va el primero. PORTADA: la imagen, de las suyas, que lo enseña al abrir la galería y la página;
#   si no se dice, la primera.
#
# programa(nombre REF "L1.2 E3.5" TITULO "…" CONTRA "…" PRUEBAS a.B.C … [PASA "…"] [CAPTURA "…"] [ADMITE modelo|imagen|imagenes] [CONSOLA])
#   Compila <nombre>.cpp una sola vez y lo enlaza para cada destino de LAB_DESTINOS:
#   build/<destino>/<capítulo>/<nombre>. Van en el orden del libro.
#   CONTRA: con qué, que no salga de él, se compara; PRUEBAS: las de GoogleTest que lo hacen.
#   PASA: por qué se aparta de ello más de 2 niveles de 255.
#   CAPTURA: el pie de <nombre>.png, una captura de pantalla de lo que no pinta OpenGL; va en la galería tras sus imágenes.
#   ADMITE: el fichero que se le puede dar: un modelo v/f, una imagen o dos. CONSOLA: escribe texto y no tiene imagen.
#
# caso(programa nombre NOMBRE "…" [GUION "orden; orden"] [BORDE "…"] [ANIMA "N orden"] [TOLERANCIA "…"] [OTRO "…"] [MOTIVO "…"] MIRA "…"
#   [CUMPLE "…; …"])
#   Una imagen de ese programa, la de tras el guion: se llama <programa>-<nombre>, y la del caso base, <programa>.
#   NOMBRE: cómo se enseña («Con un factor negativo»), distinto de los demás de su programa y hasta 40 letras, las acentuadas por dos;
#   el caso base puede no tenerlo.
#   MIRA: una frase, a qué hay que mirar; es el pie de la imagen en la galería. En su propio renglón.
#   CUMPLE: lo que tiene que ser así en la imagen porque lo dice el pie, y no en las de los demás casos del programa; en
#   el renglón siguiente. Lo comprueba la prueba pies.<programa> a 480×360, a 960×720 y a 960×1080. Los puntos son
#   fracciones del 4:3 central de la ventana, x hacia la derecha e y hacia abajo; un COLOR es un nombre de
#   common/encima/colores.h o (r,g,b), de 0 a 255:
#     en X Y COLOR                  ese color, a 12 niveles como mucho
#     en X Y como X Y               los dos puntos, a 12 niveles
#     en X Y más claro que X Y      más de 12 niveles de luminancia
#     COLOR entero|cortado|ausente  lo de ese color, con más o menos luz: no toca el borde de la ventana, lo toca, no está
#     COLOR A a B %                 lo que ocupa del 4:3 central
#     distinta de CASO en A a B %   los píxeles del 4:3 central que cambian en más de 12 niveles
#     igual que CASO                ninguno de la ventana cambia en más de 12
#   Con «a 4:3: » delante, solo en las dos primeras tallas: lo que parte la ventana de otra manera cuando es alta.
#   BORDE: «LADOS: por qué», los lados de la ventana (izquierda, derecha, abajo, arriba, o todos) por los que la escena está cortada en una de
#   alguna forma; por los demás no debe llegar al borde en ninguna.
#   ANIMA: en la galería se mueve: N cuadros, a diez por segundo, y la orden del guion que lleva de cada uno al siguiente.
#   TOLERANCIA cambia la que usa el comparador cuando la imagen no es del mismo OpenGL que el golden, y OTRO la de su --otro; las dos
#   exigen un MOTIVO.
#
# Con todo ello se escribe build/catalogo.json, que solo lee herramientas/base/catalogo.py, y de ahí sale lo demás: ./lab, la galería,
# las páginas, docs/. Lo que de cada caso necesitan las pruebas queda en build/casos/<programa>.sh.

# file(GLOB) en esta carpeta aunque se llame a[b]: esos corchetes no son del patrón.
function(busca variable patron)
  string(REPLACE "[" "[[]" carpeta "${CMAKE_CURRENT_SOURCE_DIR}")
  file(GLOB ficheros CONFIGURE_DEPENDS RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" "${carpeta}/${patron}")
  set(${variable} "${ficheros}" PARENT_SCOPE)
endfunction()

# Añade a una de las listas del catálogo un objeto de JSON: sus campos son las variables <prefijo>_<CAMPO>.
function(apunta lista prefijo)
  set(objeto "")
  foreach(campo IN LISTS ARGN)
    string(REPLACE "\\" "\\\\" valor "${${prefijo}_${campo}}")
    string(REPLACE "\"" "\\\"" valor "${valor}")
    string(TOLOWER ${campo} nombre)
    string(APPEND objeto ", \"${nombre}\": \"${valor}\"")
  endforeach()
  string(SUBSTRING "${objeto}" 2 -1 objeto)
  set_property(GLOBAL APPEND_STRING PROPERTY LAB_CATALOGO_${lista} ",\n {${objeto}}")
endfunction()

function(exige_nombre nombre)
  if(NOT nombre MATCHES "^[a-z0-9_]+$")
    message(FATAL_ERROR "«${nombre}»: un nombre lleva solo minúsculas sin acento, cifras y _")
  endif()
endfunction()

function(capitulo titulo)
  cmake_parse_arguments(PARSE_ARGV 1 C "" "PORTADA" "")
  get_filename_component(C_NOMBRE "${CMAKE_CURRENT_SOURCE_DIR}" NAME)
  set(C_TITULO "${titulo}")
  apunta(CAPITULOS C NOMBRE TITULO PORTADA)
  set(capitulo ${C_NOMBRE} PARENT_SCOPE)
endfunction()

# Las bibliotecas que incluyen todos los programas, analizadas una vez.
function(precompila_cabeceras)
  add_library(precompilada OBJECT herramientas/cmake/precompilada.cpp)
  target_link_libraries(precompilada PRIVATE comun avisos)
  target_precompile_headers(precompilada PRIVATE <GL/glew.h> <GL/freeglut.h> <glm/glm.hpp> <glm/gtc/matrix_transform.hpp>
    <glm/gtc/type_ptr.hpp> <algorithm> <array> <cmath> <cstdio> <cstdlib> <string> <vector>)
endfunction()

# Hacen falta para ejecutarlo y no para compilarlo. Al compilar para otra máquina son las de esta.
function(con_texturas ejecutable)
  if(TARGET texturas)
    add_dependencies(${ejecutable} texturas)
  endif()
endfunction()

function(programa nombre)
  cmake_parse_arguments(PARSE_ARGV 1 P "CONSOLA" "REF;TITULO;CONTRA;PASA;CAPTURA;ADMITE" "PRUEBAS")
  if(P_UNPARSED_ARGUMENTS OR NOT P_REF OR NOT P_TITULO OR NOT capitulo)
    message(FATAL_ERROR "programa(${nombre}): faltan REF, TITULO o, antes, capitulo(…), o sobra «${P_UNPARSED_ARGUMENTS}»")
  endif()
  if(NOT "${P_ADMITE}" MATCHES "^(|modelo|imagen|imagenes)$")
    message(FATAL_ERROR "programa(${nombre}): ADMITE modelo, imagen o imagenes, y no «${P_ADMITE}»")
  endif()
  exige_nombre(${nombre})
  add_library(${nombre} OBJECT ${nombre}.cpp)
  target_link_libraries(${nombre} PRIVATE comun avisos)
  target_compile_options(${nombre} PRIVATE $<$<BOOL:${LAB_SANEADO}>:-O0>) # se compila en un tercio menos de tiempo
  if(TARGET precompilada)
    target_precompile_headers(${nombre} REUSE_FROM precompilada)
  endif()
  set_property(GLOBAL APPEND PROPERTY LAB_PROGRAMAS ${nombre})
  foreach(destino IN LISTS LAB_DESTINOS)
    set(ejecutable ${nombre}_${destino})
    add_executable(${ejecutable} $<TARGET_OBJECTS:${nombre}>)
    target_link_libraries(${ejecutable} PRIVATE comun glut_${destino})
    con_texturas(${ejecutable})
    set_target_properties(${ejecutable} PROPERTIES OUTPUT_NAME ${nombre}
      RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${destino}/${capitulo}")
  endforeach()
  if(TARGET ${nombre}_ventana)
    add_dependencies(programas ${nombre}_ventana ${nombre}_${LAB_SIN_VENTANA})
    add_dependencies(sin_ventana ${nombre}_${LAB_SIN_VENTANA})
    install(TARGETS ${nombre}_ventana DESTINATION ${capitulo})
  endif()
  if(NOT P_CONSOLA)
    set_property(GLOBAL APPEND PROPERTY LAB_CON_VENTANA ${capitulo}/${nombre})
  endif()
  set(P_CAPITULO ${capitulo})
  set(P_NOMBRE ${nombre})
  string(REPLACE ";" " " P_PRUEBAS "${P_PRUEBAS}")
  string(REPLACE "FALSE" "" P_CONSOLA ${P_CONSOLA})
  apunta(PROGRAMAS P CAPITULO NOMBRE REF TITULO CONTRA PRUEBAS PASA CAPTURA ADMITE CONSOLA)
endfunction()

function(caso programa nombre)
  cmake_parse_arguments(PARSE_ARGV 2 C "" "NOMBRE;GUION;MIRA;CUMPLE;BORDE;ANIMA;TOLERANCIA;OTRO;MOTIVO" "")
  if(C_UNPARSED_ARGUMENTS OR NOT C_MIRA OR ((C_TOLERANCIA OR C_OTRO) AND NOT C_MOTIVO))
    message(FATAL_ERROR "caso(${programa} ${nombre}): sobra «${C_UNPARSED_ARGUMENTS}» o falta MIRA o el MOTIVO")
  endif()
  if(C_ANIMA AND NOT C_ANIMA MATCHES "^[1-9][0-9]?[0-9]? ")
    message(FATAL_ERROR "caso(${programa} ${nombre}): ANIMA es el número de cuadros, hasta 999, y la orden que lleva al siguiente")
  endif()
  if(C_BORDE AND NOT C_BORDE MATCHES "^(todos|(izquierda|derecha|abajo|arriba)( (izquierda|derecha|abajo|arriba))*): .")
    message(FATAL_ERROR "caso(${programa} ${nombre}): BORDE es «LADOS: por qué», y no «${C_BORDE}»")
  endif()
  exige_nombre(${nombre})
  if(NOT TARGET ${programa})
    message(FATAL_ERROR "caso(${programa} ${nombre}): no hay ningún programa «${programa}»")
  endif()
  string(LENGTH "${C_NOMBRE}" letras)
  if(letras GREATER 40 OR (letras EQUAL 0 AND NOT nombre STREQUAL "base"))
    message(FATAL_ERROR "caso(${programa} ${nombre}): falta NOMBRE o pasa de 40 letras: «${C_NOMBRE}»")
  endif()
  get_property(nombres GLOBAL PROPERTY LAB_NOMBRES_DE_${programa})
  if("${C_NOMBRE}" IN_LIST nombres)
    message(FATAL_ERROR "caso(${programa} ${nombre}): ya hay otro que se llama «${C_NOMBRE}»")
  endif()
  set_property(GLOBAL APPEND PROPERTY LAB_NOMBRES_DE_${programa} "${C_NOMBRE}")
  if(C_CUMPLE)
    set_property(GLOBAL APPEND PROPERTY LAB_CUMPLEN ${programa})
  endif()
  set(C_TITULO "${C_NOMBRE}")
  set(C_PROGRAMA ${programa})
  set(C_NOMBRE ${nombre})
  set(C_FICHERO ${programa}-${nombre})
  if(nombre STREQUAL "base")
    set(C_FICHERO ${programa})
  endif()
  apunta(CASOS C PROGRAMA NOMBRE TITULO FICHERO GUION TOLERANCIA OTRO MIRA BORDE ANIMA)
  set_property(GLOBAL APPEND PROPERTY LAB_NOMBRES_DE_CASOS ${programa}.${nombre})

  set(linea "caso")
  foreach(campo NOMBRE FICHERO GUION TOLERANCIA OTRO BORDE CUMPLE)
    string(TOLOWER ${campo} variable)
    string(REPLACE "'" "'\\''" valor "${C_${campo}}")
    string(APPEND linea " ${variable}='${valor}'")
  endforeach()
  set_property(GLOBAL APPEND_STRING PROPERTY LAB_CASOS_DE_${programa} "${linea}\n")
endfunction()

# python3 en esta máquina: ejecuta los módulos de herramientas/.
find_program(PYTHON NAMES python3 python HINTS /usr/bin NO_CMAKE_FIND_ROOT_PATH REQUIRED)

# Los controles de los programas, para common/encima/ayuda.cpp, que está en esa biblioteca.
function(recoge_controles biblioteca)
  busca(fuentes ch*/*.cpp)
  set(tabla "${CMAKE_BINARY_DIR}/generado/controles.inc")
  add_custom_command(OUTPUT "${tabla}" DEPENDS ${fuentes} herramientas/base/controles.py
    COMMAND "${PYTHON}" -B herramientas base.controles tabla . "${tabla}"
    WORKING_DIRECTORY "${CMAKE_SOURCE_DIR}" COMMENT "Recogiendo los controles" VERBATIM)
  target_sources(${biblioteca} PRIVATE "${tabla}")
  target_include_directories(${biblioteca} PRIVATE "${CMAKE_BINARY_DIR}/generado")
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

# Lo de quien aprende (./lab nuevo): mios/<nombre>/<nombre>.cpp, al lado de la carpeta en que se compila. Cada uno es mio_<nombre>_<destino>,
# que nadie más pide porque puede no compilar, y se llama como el programa del que viene, que lo dice su ejercicio.txt: así F1 da sus teclas.
function(lee_mios)
  get_filename_component(mios "${CMAKE_BINARY_DIR}/../mios" ABSOLUTE)
  string(REPLACE "[" "[[]" carpeta "${mios}")
  file(GLOB nombres CONFIGURE_DEPENDS RELATIVE "${mios}" "${carpeta}/*/ejercicio.txt")
  foreach(nombre IN LISTS nombres)
    get_filename_component(nombre "${nombre}" DIRECTORY)
    set(fuente "${mios}/${nombre}/${nombre}.cpp")
    set(de_donde "(ch[a-z0-9_]+|ejercicios/[a-z0-9_]+)/[a-z0-9_]+$")
    file(STRINGS "${mios}/${nombre}/ejercicio.txt" origen LIMIT_COUNT 1 REGEX "${de_donde}")
    get_filename_component(programa "${origen}" NAME)
    set(es_propio FALSE) # el de un ejercicio de quien enseña, del que quizá aquí no está la solución
    if(origen MATCHES "ejercicios/")
      set(es_propio TRUE)
    endif()
    if(NOT nombre MATCHES "^[a-z0-9_]+$" OR NOT EXISTS "${fuente}" OR NOT (es_propio OR TARGET "${programa}"))
      continue()
    endif()
    de_una_carpeta(mio_${nombre} "${fuente}" ${programa} mios/${nombre})
    if(NOT es_propio)
      get_target_property(capitulo ${programa} SOURCE_DIR)
      target_include_directories(mio_${nombre} PRIVATE "${capitulo}")
    endif()
    target_compile_definitions(mio_${nombre} PRIVATE LAB_FUENTES="${mios}/${nombre}") # shader_basico, que no usa common/
  endforeach()
endfunction()

# Un programa que está solo en su carpeta, que puede no compilar y solo se compila si se pide.
function(de_una_carpeta objetivo fuente programa salida)
  add_library(${objetivo} OBJECT EXCLUDE_FROM_ALL "${fuente}")
  target_link_libraries(${objetivo} PRIVATE comun avisos)
  set_source_files_properties("${fuente}" PROPERTIES COMPILE_OPTIONS -Wno-error)
  if(TARGET precompilada)
    target_precompile_headers(${objetivo} REUSE_FROM precompilada)
  endif()
  foreach(destino IN LISTS LAB_DESTINOS)
    set(ejecutable ${objetivo}_${destino})
    add_executable(${ejecutable} EXCLUDE_FROM_ALL $<TARGET_OBJECTS:${objetivo}>)
    target_link_libraries(${ejecutable} PRIVATE comun glut_${destino})
    con_texturas(${ejecutable})
    set_target_properties(${ejecutable} PROPERTIES OUTPUT_NAME ${programa}
      RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${destino}/${salida}")
  endforeach()
endfunction()

# La solución de cada ejercicio de quien enseña: ejercicios/NOMBRE/NOMBRE.cpp, y las de las carpetas que apunta
# herramientas/ejercicios/propios.py en propios.txt. Cada una es propio_NOMBRE_<destino>.
function(lee_propios)
  set(apuntados "${CMAKE_BINARY_DIR}/propios.txt")
  if(NOT EXISTS "${apuntados}")
    file(WRITE "${apuntados}" "")
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${apuntados}")
  busca(relativas ejercicios/*/*.cpp)
  set(carpetas "")
  foreach(relativa IN LISTS relativas)
    get_filename_component(carpeta "${relativa}" DIRECTORY)
    list(APPEND carpetas "${CMAKE_CURRENT_SOURCE_DIR}/${carpeta}")
  endforeach()
  list(REMOVE_DUPLICATES carpetas)
  file(STRINGS "${apuntados}" otras ENCODING UTF-8)
  foreach(carpeta IN LISTS carpetas otras)
    get_filename_component(nombre "${carpeta}" NAME)
    set(fuente "${carpeta}/${nombre}.cpp")
    if(nombre MATCHES "^[a-z0-9_]+$" AND EXISTS "${fuente}" AND NOT TARGET ${nombre} AND NOT TARGET propio_${nombre})
      de_una_carpeta(propio_${nombre} "${fuente}" ${nombre} ejercicios/${nombre})
    endif()
  endforeach()
endfunction()

function(escribe_catalogo)
  set(catalogo "")
  foreach(lista CAPITULOS PROGRAMAS CASOS)
    get_property(objetos GLOBAL PROPERTY LAB_CATALOGO_${lista})
    string(SUBSTRING "${objetos}" 1 -1 objetos)
    string(TOLOWER ${lista} nombre)
    string(APPEND catalogo ",\n\"${nombre}\": [${objetos}]")
  endforeach()
  string(SUBSTRING "${catalogo}" 1 -1 catalogo)
  file(GENERATE OUTPUT "${CMAKE_BINARY_DIR}/catalogo.json" CONTENT "{${catalogo}\n}\n")
  get_property(programas GLOBAL PROPERTY LAB_CON_VENTANA)
  foreach(programa IN LISTS programas)
    get_filename_component(nombre ${programa} NAME)
    get_filename_component(capitulo ${programa} DIRECTORY)
    get_property(casos GLOBAL PROPERTY LAB_CASOS_DE_${nombre})
    file(GENERATE OUTPUT "${CMAKE_BINARY_DIR}/casos/${nombre}.sh" CONTENT "capitulo=${capitulo}\n${casos}")
  endforeach()
endfunction()
