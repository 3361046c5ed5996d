# El enlace de Windows: los mismos programas, con FreeGLUT y GLEW en DLL. Desde Debian (herramientas/cmake/mingw.cmake) las compila de los
# fuentes que ./lab windows deja al lado; en Windows, con MSYS2, son sus paquetes.
enable_language(C RC)
find_package(OpenGL REQUIRED)
if(CMAKE_CROSSCOMPILING)
  get_filename_component(fuentes "${CMAKE_BINARY_DIR}/../fuentes" ABSOLUTE)
  set(LAB_FUENTES "") # los shaders están junto a la carpeta del ejecutable
  set(LAB_GENERADO "")
  set(CMAKE_POLICY_DEFAULT_CMP0077 NEW) # estas opciones valen como variables
  set(CMAKE_POLICY_VERSION_MINIMUM 3.5) # piden una que CMake 4 ya no tiene
  foreach(opcion FREEGLUT_BUILD_STATIC_LIBS FREEGLUT_BUILD_DEMOS BUILD_UTILS)
    set(${opcion} OFF)
  endforeach()
  add_subdirectory("${fuentes}/freeglut" freeglut EXCLUDE_FROM_ALL)
  add_subdirectory("${fuentes}/glew/build/cmake" glew EXCLUDE_FROM_ALL)
  foreach(biblioteca freeglut glew)
    target_compile_options(${biblioteca} PRIVATE -w)
    set_target_properties(${biblioteca} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/dll")
  endforeach()
  set(bibliotecas freeglut glew)
  find_path(CABECERAS_GLM NAMES glm/glm.hpp NO_CMAKE_FIND_ROOT_PATH PATHS /usr/include /usr/local/include REQUIRED)
  file(COPY "${CABECERAS_GLM}/glm" DESTINATION "${CMAKE_BINARY_DIR}/cabeceras") # y no las demás del sistema
  include_directories("${CMAKE_BINARY_DIR}/cabeceras" "${fuentes}/freeglut/include" "${fuentes}/glew/include")
else()
  set(LAB_FUENTES "${CMAKE_SOURCE_DIR}")
  set(LAB_GENERADO "${CMAKE_BINARY_DIR}")
  find_package(GLEW REQUIRED)
  find_package(glm REQUIRED)
  find_package(Freetype REQUIRED)
  find_package(FreeGLUT CONFIG QUIET)
  if(TARGET FreeGLUT::freeglut)
    set(glut FreeGLUT::freeglut)
  elseif(TARGET FreeGLUT::freeglut_static)
    set(glut FreeGLUT::freeglut_static)
  else()
    find_library(FREEGLUT_BIBLIOTECA NAMES freeglut glut REQUIRED)
    set(glut "${FREEGLUT_BIBLIOTECA}")
  endif()
  set(bibliotecas ${glut} GLEW::GLEW glm::glm)
endif()

file(WRITE "${CMAKE_BINARY_DIR}/sin_ventana" "ventana\n")
add_library(avisos INTERFACE) # los da la compilación corriente
# FREEGLUT_STATIC: lo de la DLL se llama por su nombre, y no por __imp_…, que --wrap no ve
add_compile_definitions(NOMINMAX WIN32_LEAN_AND_MEAN FREEGLUT_STATIC)
include(common/comun.cmake)
target_link_libraries(comun PUBLIC ${bibliotecas} OpenGL::GL)
if(NOT CMAKE_CROSSCOMPILING) # si no, las texturas son las de la compilación corriente
  add_subdirectory(assets)
endif()

add_library(consola OBJECT glut/ventana/windows.cpp glut/ventana/mayusculas.cpp glut/ventana/windows.rc)
target_link_libraries(consola PRIVATE comun)
add_library(glut_ventana INTERFACE)
target_sources(glut_ventana INTERFACE $<TARGET_OBJECTS:consola>)
target_link_libraries(glut_ventana INTERFACE -Wl,--wrap=glutKeyboardFunc)

precompila_cabeceras()

set(LAB_DESTINOS ventana)
set(LAB_SIN_VENTANA ventana) # no hay otro
add_custom_target(programas)
add_custom_target(sin_ventana)
lee_capitulos()
