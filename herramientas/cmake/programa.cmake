# Cómo se compila y se enlaza un programa. Cuáles hay lo dice el catalogo.toml de cada capítulo, que lee herramientas/base/catalogo.py.

# file(GLOB) en esta carpeta aunque se llame a[b]: esos corchetes no son del patrón.
function(busca variable patron)
  string(REPLACE "[" "[[]" carpeta "${CMAKE_CURRENT_SOURCE_DIR}")
  file(GLOB ficheros CONFIGURE_DEPENDS RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" "${carpeta}/${patron}")
  set(${variable} "${ficheros}" PARENT_SCOPE)
endfunction()

# python3 en esta máquina: ejecuta los módulos de herramientas/.
find_program(PYTHON NAMES python3 python HINTS /usr/bin NO_CMAKE_FIND_ROOT_PATH REQUIRED)

# Las bibliotecas que incluyen todos los programas, analizadas una vez.
function(precompila_cabeceras)
  add_library(precompilada OBJECT herramientas/cmake/precompilada.cpp)
  target_link_libraries(precompilada PRIVATE comun avisos)
  target_compile_options(precompilada PRIVATE ${LAB_LINEAS}) # o no le vale a quien se compila con ella
  target_precompile_headers(precompilada PRIVATE <GL/glew.h> <GL/freeglut.h> <glm/glm.hpp> <glm/gtc/matrix_transform.hpp>
    <glm/gtc/type_ptr.hpp> <algorithm> <array> <cmath> <cstdio> <cstdlib> <string> <vector>)
endfunction()

# Lo que F1 dice de un programa, que es su línea «// Controles:», o la del siguiente fuente si no la tiene: un objeto aparte, que se enlaza
# con él, y así cambiarla no toca a los demás.
function(apunta_controles objetivo nombre) # FUENTE…
  set(suyos "${CMAKE_BINARY_DIR}/controles/${objetivo}.cpp")
  add_custom_command(OUTPUT "${suyos}" DEPENDS ${ARGN} "${CMAKE_SOURCE_DIR}/herramientas/base/controles.py"
    COMMAND "${PYTHON}" -B "${CMAKE_SOURCE_DIR}/herramientas" base.controles objeto "${suyos}" ${nombre} ${ARGN}
    COMMENT "" VERBATIM)
  add_library(controles_${objetivo} OBJECT EXCLUDE_FROM_ALL "${suyos}")
  target_include_directories(controles_${objetivo} PRIVATE "${CMAKE_SOURCE_DIR}/common/encima")
endfunction()

# Compila un fuente una sola vez, en el objetivo que se diga, y lo enlaza para cada destino de LAB_DESTINOS:
# build/<destino>/<carpeta>/<nombre>. TAMBIEN es EXCLUDE_FROM_ALL, si solo se compila cuando se pide.
function(compila objetivo fuente carpeta nombre tambien)
  add_library(${objetivo} OBJECT ${tambien} "${fuente}")
  target_link_libraries(${objetivo} PRIVATE comun avisos)
  target_compile_options(${objetivo} PRIVATE ${LAB_LINEAS})
  if(TARGET precompilada)
    target_precompile_headers(${objetivo} REUSE_FROM precompilada)
  endif()
  foreach(destino IN LISTS LAB_DESTINOS)
    set(ejecutable ${objetivo}_${destino})
    add_executable(${ejecutable} ${tambien} $<TARGET_OBJECTS:${objetivo}> $<TARGET_OBJECTS:controles_${objetivo}>)
    target_link_libraries(${ejecutable} PRIVATE comun glut_${destino})
    if(TARGET texturas) # para ejecutarlo; al compilar para otra máquina son las de esta
      add_dependencies(${ejecutable} texturas)
    endif()
    set_target_properties(${ejecutable} PROPERTIES OUTPUT_NAME ${nombre}
      RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${destino}/${carpeta}")
  endforeach()
endfunction()

function(programa capitulo nombre)
  set(fuente "${CMAKE_SOURCE_DIR}/${capitulo}/${nombre}.cpp")
  apunta_controles(${nombre} ${nombre} "${fuente}")
  compila(${nombre} "${fuente}" ${capitulo} ${nombre} "")
  target_compile_definitions(${nombre} PRIVATE LAB_FUENTES="${LAB_FUENTES}") # para quien no busca sus ficheros con common/
  target_compile_options(${nombre} PRIVATE $<$<BOOL:${LAB_SANEADO}>:-O0>) # se compila en un tercio menos de tiempo
  if(TARGET ${nombre}_ventana)
    add_dependencies(programas ${nombre}_ventana ${nombre}_${LAB_SIN_VENTANA})
    add_dependencies(sin_ventana ${nombre}_${LAB_SIN_VENTANA})
    if(TARGET galeria AND TARGET ${nombre}_egl)
      add_dependencies(galeria ${nombre}_egl)
    endif()
    install(TARGETS ${nombre}_ventana DESTINATION ${capitulo})
  endif()
endfunction()

# Los programas de todos los capítulos. Del catálogo quedan LAB_CAPITULOS; LAB_PROGRAMAS y, de ellos, LAB_CON_VENTANA, que son
# capítulo/programa; y LAB_CASOS, que son programa.caso.
macro(lee_capitulos)
  busca(catalogos ch*/catalogo.toml)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${catalogos} herramientas/base/catalogo.py)
  execute_process(RESULT_VARIABLE mal ERROR_VARIABLE dice
    COMMAND "${PYTHON}" -B "${CMAKE_SOURCE_DIR}/herramientas" base.catalogo "${CMAKE_BINARY_DIR}" "${CMAKE_SOURCE_DIR}")
  if(mal)
    message(FATAL_ERROR "${dice}")
  endif()
  include("${CMAKE_BINARY_DIR}/catalogo.cmake")
  foreach(cual IN LISTS LAB_PROGRAMAS)
    string(REPLACE "/" ";" cual ${cual})
    programa(${cual})
  endforeach()
endmacro()
