#!/usr/bin/env bash
# lab.sh RAIZ: las órdenes de ./lab, desde otra carpeta, y sus errores.
set -euo pipefail
lab=$1/lab fallos=0
export LAB_SIN_INSTALAR=1
unset DISPLAY WAYLAND_DISPLAY
carpeta=$(mktemp -d)
trap 'rm -rf "$carpeta"' EXIT
cd "$carpeta"

espera() { # ESTADO TEXTO ORDEN…: la orden sale con ese estado y su salida (las dos) contiene el texto
  local estado=0 salida esperado=$1 texto=$2
  shift 2
  salida=$("$@" 2>&1) || estado=$?
  if [ $estado != "$esperado" ] || [[ $salida != *"$texto"* ]]; then
    echo "$*: estado $estado (debía ser $esperado); debía decir «$texto» y ha dicho: $salida"
    fallos=1
  fi
}

espera 0 './lab galeria' "$lab"
espera 0 './lab prueba' "$lab" ayuda
espera 2 'no conozco la orden «gallery»' "$lab" gallery
espera 0 'Grúa de obra' "$lab" lista
espera 1 'no entiendo «--csv»' "$lab" lista --csv
espera 1 'falta el programa' "$lab" ver
espera 1 'no hay ningún programa «gura»; los más parecidos: grua' "$lab" ver gura
espera 1 'no hay ningún programa «E99.9»' "$lab" ver E99.9
espera 1 'di qué casos' "$lab" dora
espera 1 '«grua-volando» no es un caso de grua' "$lab" dora grua-volando
for nombre in grua E3.5 f3.3; do
  rm -f grua.png
  espera 0 'lo he dibujado en grua.png' "$lab" ver $nombre
  [ "$(head -c 4 grua.png | tail -c 3)" = PNG ] || { echo "ver $nombre no deja grua.png"; fallos=1; }
done
espera 0 'GLSL: ' "$lab" ver info_opengl
espera 2 'no entiendo «-volando»' "$lab" ver grua -volando
DISPLAY=:987 espera 0 'lo he dibujado en grua.png' "$lab" ver grua # una pantalla que no existe

# cuatro columnas, sin cabecera, una fila por programa
"$lab" lista --tsv >lista.tsv
awk -F'\t' 'NF != 4 { print "lista --tsv: fila de " NF " columnas: " $0; mal = 1 } END { exit mal }' lista.tsv || fallos=1
[ "$(wc -l <lista.tsv)" = "$(grep -ch '^programa(' "$1"/ch*/CMakeLists.txt | awk "{ n += \$1 } END { print n }")" ] || { echo 'lista --tsv no tiene todos los programas'; fallos=1; }
exit $fallos
