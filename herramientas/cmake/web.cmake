# El enlace web: los mismos programas, en un solo binario para el navegador. Lo configura ./lab web con Emscripten, aparte.
# Cada programa se compila a código intermedio con su main llamado main_NOMBRE; opt hace privado todo lo demás, para que dos
# programas puedan tener tipos y funciones que se llamen igual; y se enlazan todos, con comun y con el GLUT sin ventana.

# De las bibliotecas del sistema solo valen las cabeceras que no dependen de la máquina, y esas se toman por su nombre.
find_path(CABECERAS NAMES GL/freeglut.h NO_CMAKE_FIND_ROOT_PATH PATHS /usr/include /usr/local/include REQUIRED)
find_path(CABECERAS_GLM NAMES glm/glm.hpp NO_CMAKE_FIND_ROOT_PATH PATHS /usr/include /usr/local/include REQUIRED)
set(enlaces ${CMAKE_BINARY_DIR}/cabeceras)
file(MAKE_DIRECTORY ${enlaces})
foreach(carpeta GL KHR)
  file(CREATE_LINK ${CABECERAS}/${carpeta} ${enlaces}/${carpeta} SYMBOLIC)
endforeach()
file(CREATE_LINK ${CABECERAS_GLM}/glm ${enlaces}/glm SYMBOLIC)

file(WRITE ${CMAKE_BINARY_DIR}/sin_ventana "web\n")
set(LAB_FUENTES /lab) # donde la página pone los shaders, los modelos y las texturas
set(LAB_GENERADO /lab)
add_compile_options(-Os -Wno-pointer-bool-conversion) # lo segundo: GLEW da punteros a función, que pueden ser nulos
add_library(avisos INTERFACE) # los da la compilación corriente

set(sin_ventana glut/sin_ventana)
include(common/comun.cmake)
target_include_directories(comun BEFORE PUBLIC ${sin_ventana}/web ${enlaces})
add_library(glut_web STATIC $<TARGET_OBJECTS:glut_sin_ventana> ${sin_ventana}/contexto_web.cpp ${sin_ventana}/gl_web.cpp)
target_link_libraries(glut_web PUBLIC comun)

precompila_cabeceras()
set(LAB_DESTINOS "") # programa() solo los compila
lee_capitulos()
include(herramientas/cmake/ejercicios.cmake)
lee_propios()
add_library(compara OBJECT herramientas/comparador/compara.cpp) # con él se corrige también en la página
target_link_libraries(compara PRIVATE comun avisos)

string(REGEX MATCH "^[0-9]+" llvm ${CMAKE_CXX_COMPILER_VERSION}) # el de Emscripten, que no tiene por qué ser el único
find_program(OPT NAMES opt-${llvm} opt REQUIRED)
set(objetos "")
set(indice "")
foreach(programa IN LISTS LAB_PROGRAMAS LAB_PROPIOS ITEMS compara)
  get_filename_component(objetivo ${programa} NAME)
  string(REGEX REPLACE "^propio_" "" nombre ${objetivo})
  set(main main_${nombre})
  target_compile_definitions(${objetivo} PRIVATE main=${main})
  target_compile_options(${objetivo} PRIVATE -emit-llvm)
  string(LENGTH ${main} largo)
  set(objeto ${CMAKE_BINARY_DIR}/objetos/${nombre})
  add_custom_command(OUTPUT ${objeto}.o DEPENDS ${objetivo} $<TARGET_OBJECTS:${objetivo}>
    COMMAND ${OPT} -passes=internalize,globaldce -internalize-public-api-list=_Z${largo}${main}iPPc
      $<TARGET_OBJECTS:${objetivo}> -o ${objeto}.bc
    COMMAND ${CMAKE_CXX_COMPILER} -Os -c ${objeto}.bc -o ${objeto}.o
    COMMENT "Apartando ${nombre}" VERBATIM)
  list(APPEND objetos ${objeto}.o)
  if(TARGET controles_${objetivo})
    list(APPEND objetos $<TARGET_OBJECTS:controles_${objetivo}>)
  endif()
  string(APPEND indice "PROGRAMA(${nombre})\n")
endforeach()
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/objetos)
file(GENERATE OUTPUT ${enlaces}/programas.inc CONTENT "${indice}")

# Quien explica, delante de OpenGL. Es lo único que lanza excepciones, al reescribir un shader.
include(${CMAKE_SOURCE_DIR}/herramientas/explica/reescritor.cmake)
set_target_properties(reescritor PROPERTIES POSITION_INDEPENDENT_CODE OFF)
target_include_directories(reescritor PRIVATE ${enlaces})
target_compile_options(reescritor PRIVATE -fexceptions)
add_library(explica STATIC
  ${carpeta}/arrays.cpp ${carpeta}/cableado.cpp ${carpeta}/cuadro.cpp ${carpeta}/enviado.cpp ${carpeta}/estado.cpp ${carpeta}/imagenes.cpp
  ${carpeta}/lee_web.cpp ${carpeta}/posiciones.cpp ${carpeta}/nombres.cpp ${carpeta}/ordenes.cpp ${carpeta}/pixel.cpp ${carpeta}/primitivas.cpp
  ${carpeta}/programas.cpp ${carpeta}/sombreado.cpp ${carpeta}/sospechas.cpp ${carpeta}/sueltas.cpp ${carpeta}/web.cpp)
target_include_directories(explica PRIVATE ${sin_ventana})
target_link_libraries(explica PUBLIC reescritor comun)

add_executable(laboratorio ${sin_ventana}/programas_web.cpp ${objetos})
target_link_libraries(laboratorio PRIVATE explica glut_web)
set_target_properties(laboratorio PROPERTIES OUTPUT_NAME lab)
set(en_la_pagina -fexceptions -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2 -sALLOW_MEMORY_GROWTH=1
  -sMODULARIZE=1 -sINVOKE_RUN=0 -sEXIT_RUNTIME=0 -sFORCE_FILESYSTEM=1 -sENVIRONMENT=web
  -sEXPORTED_RUNTIME_METHODS=ENV,FS,callMain,ccall
  -sEXPORTED_FUNCTIONS=_main,_glutOrden,_glutOpciones,_glutRedibuja,_explicaPregunta,_explicaResponde,_explicaCuadroVivo)
target_link_options(laboratorio PRIVATE -Oz -sEXPORT_NAME=Laboratorio ${en_la_pagina})

# El taller: lo que hace falta para enlazar en la página un programa que se acaba de escribir. Un objeto con todo lo que no se toca (GLUT,
# quien explica, la biblioteca de C++), y el JavaScript de cualquiera que se enlace con él: se hace con -O1 y -sWASM_BIGINT, que dejan a
# cada función su nombre y el binario como sale, y sin quitar lo que nadie llama, que alguno lo llamará.
find_program(WASM_LD NAMES wasm-ld-${llvm} wasm-ld REQUIRED)
find_program(OBJCOPY NAMES llvm-objcopy-${llvm} llvm-objcopy REQUIRED)
set(partes ${CMAKE_BINARY_DIR}/taller)
file(MAKE_DIRECTORY ${partes})
foreach(cual GL-webgl2 html5 stubs noexit c dlmalloc compiler_rt c++ c++abi)
  list(APPEND del_sistema ${EMSCRIPTEN_SYSROOT}/lib/wasm32-emscripten/lib${cual}.a)
endforeach()
function(junta_en objeto) # BIBLIOTECA…: entera, sin lo que solo sirve para depurar
  add_custom_command(OUTPUT ${partes}/${objeto} DEPENDS ${ARGN} VERBATIM COMMENT "Juntando ${objeto}"
    COMMAND ${WASM_LD} -r --strip-debug --whole-archive ${ARGN} -o ${partes}/${objeto}
    COMMAND ${OBJCOPY} --remove-section=name --remove-section=producers ${partes}/${objeto})
endfunction()
junta_en(fijo.o $<TARGET_FILE:explica> $<TARGET_FILE:reescritor> $<TARGET_FILE:glut_web> ${del_sistema})
add_library(main_taller OBJECT ${sin_ventana}/taller_web.cpp)
target_link_libraries(main_taller PRIVATE comun)
target_compile_options(main_taller PRIVATE -fmacro-prefix-map=${CMAKE_SOURCE_DIR}/=) # su assert no dice dónde se ha hecho
add_executable(taller EXCLUDE_FROM_ALL $<TARGET_OBJECTS:main_taller> ${partes}/fijo.o)
target_link_libraries(taller PRIVATE comun)
set_target_properties(taller PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${partes})
target_link_options(taller PRIVATE -O1 -sWASM_BIGINT -sEXPORT_NAME=LaboratorioDelTaller -sERROR_ON_UNDEFINED_SYMBOLS=0
  -Wl,--no-gc-sections ${en_la_pagina})
add_custom_command(TARGET taller POST_BUILD VERBATIM
  COMMAND ${CMAKE_COMMAND} -E copy $<TARGET_OBJECTS:main_taller> ${partes}/main.o)
