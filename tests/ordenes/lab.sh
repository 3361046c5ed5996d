#!/usr/bin/env bash
# lab.sh RAIZ BUILD: las órdenes de ./lab que compilan y dibujan de verdad (lo demás, en ordenes_test.py), desde otra carpeta; y en una copia con lo mínimo, que lo que se estropea se nota y
# lo que se puede arreglar se arregla, también cuando su carpeta pasa a tener el peor nombre posible.
set -euo pipefail
raiz=$1 hecho=$2 lab=$1/lab fallos=0
export LAB_SIN_INSTALAR=1
unset DISPLAY WAYLAND_DISPLAY
carpeta=$(mktemp -d)
trap 'chmod -R u+w "$carpeta"; rm -rf "$carpeta"' EXIT
mkdir "$carpeta/temporal" "$carpeta/aqui"
export TMPDIR=$carpeta/temporal # al acabar debe estar vacía
cd "$carpeta/aqui"

mal() { echo "$*"; fallos=1; }
espera() { # ESTADO TEXTO ORDEN…: la orden sale con ese estado y su salida (las dos) contiene cada línea del texto
  local estado=0 salida esperado=$1 texto
  salida=$("${@:3}" 2>&1) || estado=$?
  while IFS= read -r texto; do
    [ $estado = "$esperado" ] && [[ $salida = *"$texto"* ]] && continue
    mal "${*:3}: estado $estado (debía ser $esperado); debía decir «$texto» y ha dicho: $(tail -n 5 <<<"$salida" | tail -c 600)"
  done <<<"$2"
}

# --- órdenes y errores ------------------------------------------------------------------------------------------

espera 0 'Grúa de obra' "$lab" lista
espera 1 'no hay ningún programa «gura»; los más parecidos: grua' "$lab" ver gura
espera 0 'lo he dibujado en grua.png' "$lab" ver E3.5
[ "$(head -c 4 grua.png | tail -c 3)" = PNG ] || mal 'ver E3.5 no deja grua.png'
rm grua.png
espera 0 '' "$lab" ver grua -ppm f.ppm
[ -s f.ppm ] && [ ! -e grua.png ] || mal 'ver grua -ppm f.ppm no deja solo f.ppm'
espera 0 'GLSL: ' "$lab" ver info_opengl
espera 2 'no entiendo «-volando»' "$lab" ver grua -volando
DISPLAY=:987 espera 0 'lo he dibujado en grua.png' "$lab" ver grua # una pantalla que no existe
if command -v Xvfb >/dev/null; then                                  # y una sin OpenGL
  Xvfb -displayfd 3 -extension GLX -nolisten tcp 3>pantalla >xvfb.log 2>&1 &
  until [ -s pantalla ] || ! kill -0 $! 2>/dev/null; do sleep 0.1; done
  DISPLAY=:$(cat pantalla) espera 0 'lo he dibujado en grua.png' "$lab" ver grua
  kill $!
fi

# --- una copia con dos programas --------------------------------------------------------------------------------

copia="$carpeta/lab (1) g[h] ñ" lab=./lab
mkdir "$copia"
tar -C "$raiz" --exclude=./build --exclude=./galeria --exclude=./web --exclude=./informe --exclude=./mios --exclude=./windows --exclude=./.git --exclude='./ch0[2-9]*' --exclude='./ch1*' -cf - . |
  tar -C "$copia" -xf -
cd "$copia"
# compila antes: sin optimizar, con lo que de common/ hay en BUILD, salvo lo que sabe en qué carpeta está, y con pocos assets/
sed -i 's/"Release"/"None"/' CMakePresets.json
cp -r "$hecho"/CMakeFiles/{comun,glut_sin_ventana}.dir "$carpeta" # en BUILD, otro usuario puede no poder leer
HECHO=$carpeta perl -0pi -e 's|common/(?!rutas)(\w+\.cpp)|"$ENV{HECHO}/comun.dir/common/$1.o"|g;
  s|\$<TARGET_OBJECTS:glut_sin_ventana>|\${glut}|g;
  s|(?=add_library\(glut_egl)|file(GLOB glut "$ENV{HECHO}/glut_sin_ventana.dir/common/glut_sin_ventana/*.o")\n|;
  s|(target_precompile_headers\(precompilada PRIVATE)[^)]*|$1 <cstdio>|' CMakeLists.txt common/comun.cmake
perl -0pi -e 's/set\(texturas[^)]*\)/set(texturas luz)/' assets/CMakeLists.txt
cat >assets/genera_assets.cpp <<'FIN'
#include <fstream>
#include <string>
int main(int, char **argv) { std::ofstream(std::string(argv[1]) + "/luz.rgb") << "luz"; }
FIN
cp ch01_intro/primer_programa.cpp ch01_intro/primer_programa_dos.cpp
cat >ch01_intro/CMakeLists.txt <<'FIN'
capitulo("Título; con punto y coma")
programa(primer_programa REF "L1.1" TITULO "Uno")
  caso(primer_programa base
    MIRA "Mira; y \"[remira]\" \\")
programa(primer_programa_dos REF "L1.2" TITULO "Dos" CONTRA "a; b" PRUEBAS ch01.A.B ch01.C)
  caso(primer_programa_dos base GUION "tecla a ×2; tecla '; tecla \"; tecla $; tecla <; tecla \\; tecla b" BORDE "llega" ANIMA "3 tecla i; tecla d"
    MIRA "Dos")
programa(shader_basico REF "L1.2" TITULO "Tres")
target_compile_definitions(shader_basico PRIVATE LAB_FUENTES="${CMAKE_SOURCE_DIR}")
  caso(shader_basico base
    MIRA "Tres")
FIN
: >herramientas/mide/CMakeLists.txt # usa programas que aquí no están
cat >tests/CMakeLists.txt <<'FIN'
configure_file(${CMAKE_SOURCE_DIR}/herramientas/base/entorno.txt ${CMAKE_BINARY_DIR}/entorno.txt COPYONLY)
add_test(NAME imagen COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/casos/casos.sh ${CMAKE_BINARY_DIR} ${LAB_SIN_VENTANA} shader_basico)
FIN
: >tests/propiedades/propiedades.py # las cumple todo
golden=tests/golden/ch01_intro
for e in ppm txt; do cp $golden/primer_programa.$e $golden/primer_programa_dos.$e; done

# una prueba que falla da un estado distinto de 0 y deja sus imágenes; y ninguna prueba, también
espera 0 '100% tests passed' $lab prueba
python3 -B - <<'FIN' || mal "el catálogo no dice lo que el CMakeLists.txt: $(cat build/catalogo.json)"
import sys
sys.path.insert(0, "herramientas")
from base import catalogo
[capitulo] = catalogo.lee("build")
uno, dos, tres = capitulo.programas
assert capitulo.titulo == "Título; con punto y coma"
assert uno.casos[0].mira == 'Mira; y "[remira]" \\' and uno.pruebas == []
assert (dos.contra, dos.pruebas) == ("a; b", ["ch01.A.B", "ch01.C"])
assert dos.casos[0].guion == """tecla a ×2; tecla '; tecla "; tecla $; tecla <; tecla \\; tecla b"""
assert (dos.casos[0].borde, dos.casos[0].anima) == ("llega", "3 tecla i; tecla d")
FIN
# shellcheck disable=SC2317 # lo llama el de CMake
caso() { local "$@" && [ "$capitulo $nombre $fichero $guion $tolerancia$otro$borde" = 'ch01_intro base primer_programa_dos tecla a ×2; tecla '\''; tecla "; tecla $; tecla <; tecla \; tecla b llega' ]; }
source build/casos/primer_programa_dos.sh || mal "el caso no llega como es: $(cat build/casos/primer_programa_dos.sh)"
cp $golden/shader_basico.ppm "$carpeta/golden.ppm"
cp $golden/primer_programa.ppm $golden/shader_basico.ppm
espera 8 'lo que ha fallado, con sus imágenes, está en' $lab prueba
[ -n "$(find build -path '*/fallos/*' -name '*.png')" ] || mal 'una imagen distinta no deja sus PNG'
espera 8 'No tests were found' $lab prueba -R nada

# dora rehace lo que se nombra y nada más
: >"$carpeta/vacio"
for p in primer_programa primer_programa_dos; do cp "$carpeta/vacio" $golden/$p.ppm; done
espera 0 'primer_programa: ' $lab dora primer_programa shader_basico
build/herramientas/comparador/compara "$carpeta/golden.ppm" $golden/shader_basico.ppm --amplia >/dev/null || mal 'dora no rehace shader_basico'
[ -s $golden/primer_programa.ppm ] && [ ! -s $golden/primer_programa_dos.ppm ] || mal 'dora primer_programa no rehace solo ese golden'

# muta: un defecto que ya no se puede plantar, o que no lo es, es un error que dice cuál
mutantes() { printf '%s\n' "$@" >tests/mutantes/ch01.tsv; } # LÍNEA…
uno=ch01_intro/primer_programa.cpp dos=ch01_intro/primer_programa_dos.cpp tres=ch01_intro/shader_basico.cpp
rm tests/mutantes/*.tsv tests/*/*_test.cpp
sed -i 's/^MINIMO = .*/MINIMO = 4/; s/^META, .*/META, META_SIN_GOLDEN = 50, 25/' herramientas/pruebas/muta.py
mutantes "$uno"$'\testo no está\tx\tsigno' "$dos"$'\tfalta una columna' "$tres"$'\t«3», GL_FLOAT\t3\tes igual' \
  "$tres"$'\t2, GL_FLOAT\t3, GL_FLOAT\tse pisa' "$tres"$'\t«2», GL_FLOAT\t3\tcon este' \
  $'ch01_intro/errores_shader.vert\t«nuevoColor» = color\tnoEsta\tno compila'
espera 1 "ch01:1: «esto no está» está 0 veces en $uno
ch01:2: son fichero, texto
ch01:3: ««3», GL_FLOAT» está 0 veces
$tres: se pisa con otro
ch01:6: no compila: 
ningún mutante en ch01_intro/primer_programa_dos" $lab muta --comprueba
bueno=$uno$'\tglClearColor(1.0f, «1.0f», 0.0f\t0.0f\trojo por amarillo'
mutantes "$bueno" "$uno"$'\treturn «0»\t0\tes igual' "$dos"$'\treturn «0»\t1\testado'
espera 1 $'ch01:2: no cambia nada\nhay 3 mutantes, y deben ser 4' $lab muta --comprueba

# y los planta: uno lo nota la prueba; otro, solo un golden; otro, nadie, y no dice por qué. La prueba deja un fichero temporal
cat >tests/capitulos/ch01_test.cpp <<'FIN'
#include <iostream>
#include <string>
#include <unistd.h>
int main(int, char **argv) {
    if (argv[1] == std::string("--gtest_list_tests"))
        return std::cout << "Programa.\n  Acaba\n", 0;
    return execl(LAB_EJECUTABLES "/ch01_intro/primer_programa_dos", "", "-ppm", (std::string(getenv("TMPDIR")) + "/p.ppm").c_str(), nullptr);
}
FIN
cat >>tests/CMakeLists.txt <<'FIN'
add_executable(ch01_test capitulos/ch01_test.cpp)
target_link_libraries(ch01_test PRIVATE comun)
target_compile_definitions(ch01_test PRIVATE LAB_EJECUTABLES="${CMAKE_BINARY_DIR}/${LAB_SIN_VENTANA}")
FIN
bueno+=$'\n'$dos$'\treturn «0»;\t1\testado\n'$tres$'\t«glDeleteShader(shader);» // marcado\t;\tno se borra\tno se ve'
nadie=$uno$'\tcase \'d\': «glutPostRedisplay();»\t;\tno dibuja'
mutantes "$bueno" "${nadie/$'\t;'/$'\tnoEsta();'}"
espera 1 "error: ‘noEsta’" $lab muta
mutantes "$bueno" "$nadie"
espera 1 'primer_programa_dos.base: falla sin ningún mutante' $lab muta
cp $golden/primer_programa.ppm $golden/primer_programa_dos.ppm
espera 1 "ch01:4      $uno, no dibuja: SOBREVIVE, nada lo ejecuta" $lab muta ch01:4
mutantes "$bueno" "$nadie"$'\tnadie lo pulsa'
cp docs/evidencia.json "$carpeta/antes"
espera 0 'nadie lo pulsa' $lab muta ch01:4
cmp -s docs/evidencia.json "$carpeta/antes" || mal 'muta apunta una lista que no ha plantado entera'
espera 0 '| total | 4 | 2 | 50.0 | 1 | 25.0 | 1 | 25.0 |' $lab muta
[ "$(grep plantados docs/evidencia.json)" = '  "ch01": {"plantados": 4, "notados": 2, "sin_golden": 1, "encima": 0}' ] || mal 'muta no apunta lo que se nota de cada lista'
sed -i 's/^META, .*/META, META_SIN_GOLDEN = 50, 26/' herramientas/pruebas/muta.py
espera 1 'se deben notar el 50 % y, sin golden, el 26 %' $lab muta
sed -i 's/\testado$/&\tno se ve/' tests/mutantes/ch01.tsv
espera 1 'o se notan y tienen uno: ch01:2' $lab muta ch01:2

# la galería; un caso con ANIMA tiene además un APNG
espera 0 'Hecha: ' $lab galeria
[[ $(pngtopnm galeria/ch01_intro/shader_basico.png | head -c 12) == *'1440 1080'* ]] || mal 'shader_basico.png no es lo que debe'
decimas=$(python3 - galeria/ch01_intro/primer_programa_dos.anima.png <<'FIN' # lo que dura: apngasm junta los cuadros iguales
import struct, sys
png, lugar, dura = open(sys.argv[1], "rb").read(), 8, 0
while lugar < len(png):
    largo, tipo = struct.unpack_from(">I4s", png, lugar)
    if tipo == b"fcTL":
        numerador, denominador = struct.unpack_from(">HH", png, lugar + 28)
        dura += 10 * numerador / denominador
    lugar += 12 + largo
print(dura)
FIN
)
[ "$decimas" = 3.0 ] && [[ $(pngtopnm galeria/ch01_intro/primer_programa_dos.anima.png | head -c 11) == *'480 360'* ]] ||
  mal "primer_programa_dos.anima.png no son tres cuadros de 480×360: $decimas"
[ ! -e galeria/ch01_intro/primer_programa.anima.png ] || mal 'un caso sin ANIMA tiene APNG'
grep -q 'srcset="ch01_intro/primer_programa_dos.anima.png" media="(prefers-reduced-motion: no-preference)"' galeria/index.html ||
  mal 'la página no lleva la animación'
sed -i 's/3 tecla i; tecla d/cuatro/' ch01_intro/CMakeLists.txt
espera 1 'ANIMA es el número de cuadros' $lab galeria
sed -i 's/cuatro/3 tecla i; tecla d/' ch01_intro/CMakeLists.txt

# un shader roto: su nombre y un estado distinto de 0; lo demás, en ordenes_test.py
cp ch01_intro/shader_basico.frag "$carpeta/bueno.frag"
echo 'esto no es GLSL' >>ch01_intro/shader_basico.frag
espera 1 'no se ha podido dibujar todo: shader_basico' $lab galeria
cp "$carpeta/bueno.frag" ch01_intro/shader_basico.frag

# un programa que no compila no impide ver otro, aunque los avisos fueran errores
echo 'static int noSeUsa() { return 0; }' >>ch01_intro/shader_basico.cpp
espera 1 'noSeUsa' $lab prueba
echo 'int estoNoCompila(' >>ch01_intro/primer_programa.cpp
espera 0 'lo he dibujado en shader_basico.png' $lab ver shader_basico
espera 1 'no compila' $lab galeria
cp "$raiz/ch01_intro/primer_programa.cpp" ch01_intro/

# se arregla de lo que le falte en build/
rm build/CMakeFiles/rules.ninja
espera 0 'Tres' $lab lista

# --- un programa más, con lo que dice CONTRIBUTING.md -------------------------------------------------------------

# 1, su fuente, con sus shaders; 2, sus líneas en el CMakeLists.txt del capítulo; 3, su prueba; 4, sus defectos plantados
for f in ch01_intro/shader_basico.*; do sed 's/shader_basico/nuevo/g' "$f" >"${f/shader_basico/nuevo}"; done
cat >>ch01_intro/CMakeLists.txt <<'FIN'
programa(nuevo REF "E1.2" TITULO "Cuatro" CONTRA "una cuenta" PRUEBAS ch01.Nuevo.EsLoQueEs)
target_compile_definitions(nuevo PRIVATE LAB_FUENTES="${CMAKE_SOURCE_DIR}")
  caso(nuevo base
    MIRA "Es nuevo")
FIN
sed -i 's/Acaba/&\\nNuevo.\\n  EsLoQueEs/' tests/capitulos/ch01_test.cpp
espera 1 'ningún mutante en ch01_intro/nuevo' $lab muta --comprueba
printf '%s\t' ch01_intro/nuevo.cpp '«glDeleteShader(shader);» // marcado' ';' 'no se borra' >>tests/mutantes/ch01.tsv
echo 'no se ve' >>tests/mutantes/ch01.tsv
espera 0 '5 mutantes, y todos se pueden plantar' $lab muta --comprueba

# lo demás sale de ahí: su golden, la galería, docs/, la página y las pruebas
espera 0 'nuevo: nueva' $lab dora nuevo
espera 0 'ch01_intro/nuevo: 1 imagen' $lab galeria
grep -q '<article id="nuevo">' galeria/index.html && grep -q 'Es nuevo' galeria/index.html || mal 'el programa nuevo no está en la galería'
espera 0 '' $lab lista --docs
grep -qF '| [nuevo](../ch01_intro/nuevo.cpp) | E1.2 | Cuatro |' docs/programas.md || mal 'el programa nuevo no está en docs/programas.md'
PYTHONPATH=herramientas python3 -B -c 'import pathlib
from base import catalogo
from web import pagina as web
aqui = pathlib.Path.cwd()
web.Pagina(aqui, aqui / "build/web", aqui / "galeria", aqui / "web").escribe_indice(catalogo.lee("build"))'
grep -q '"nombre":"nuevo".*"mira":"Es nuevo".*"fuentes":\["ch01_intro/nuevo.cpp","ch01_intro/nuevo.vert","ch01_intro/nuevo.frag"\]' web/index.html ||
  mal 'el programa nuevo no está en la página'
mv tests pocas
cp -r "$raiz/tests" tests # las de verdad, que no hace falta compilar
cmake --preset release -B todas >todas.log 2>&1 || { mal 'con las pruebas de verdad no se configura'; cat todas.log; }
pruebas=$(ctest --test-dir todas -N)
for nombre in "imagen.$(cat build/sin_ventana).nuevo.base" encuadre.nuevo.base ventana.nuevo; do
  [[ $pruebas == *": $nombre"$'\n'* ]] || mal "el programa nuevo no tiene la prueba $nombre"
done
rm -rf tests todas todas.log
mv pocas tests

# donde no se puede escribir trabaja en la caché, y si tampoco, lo dice en una línea
otro=()
[ "$(id -u)" != 0 ] || otro=(setpriv --reuid 65534 --regid 65534 --clear-groups)
chmod 755 "$carpeta"
chmod -R a-w .
mkdir -m 777 "$carpeta/cache"
TMPDIR=/tmp espera 0 "trabajo en $carpeta/cache/laboratorio$copia" "${otro[@]}" env XDG_CACHE_HOME="$carpeta/cache" $lab lista
XDG_CACHE_HOME=/proc espera 1 'no puedo escribir en' "${otro[@]}" $lab lista
chmod -R u+w .

# movido, nada de lo compilado vale. Con & y ' en el nombre, Ninja no sabe de qué depende nada y lo compila todo cada vez: aquí, dos
cd "$carpeta"
movido="lab (2) a&b c'd e\$f g[h] ñ"
mv "$copia" "$movido"
cd "$movido"
espera 0 'Tres' $lab lista
grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$carpeta/$movido" build/CMakeCache.txt && [ ! -e build/ventana/ch01_intro/shader_basico ] ||
  mal 'movido, no se configura de nuevo'
espera 0 'Hecha: ' $lab galeria
espera 0 'nadie lo pulsa' $lab muta ch01:4

[ -z "$(ls -A "$TMPDIR")" ] || mal "queda algo en la carpeta temporal: $(ls -AR "$TMPDIR")"
exit $fallos
