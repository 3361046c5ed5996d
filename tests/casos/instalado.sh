#!/usr/bin/env bash
# instalado.sh RAÍZ BUILD: lo que deja `cmake --install` funciona en otro ordenador. Lo instala y, con los fuentes y el
# build escondidos (bubblewrap), cada programa dibuja el golden de su primer caso. Los que se instalan son los de
# ventana: se ejecutan los mismos objetos enlazados sin ella, en su sitio. Sin bubblewrap no se hace (estado 77).
# shellcheck disable=SC2317 # lo de caso lo llama BUILD/casos/PROGRAMA.sh
set -euo pipefail
raiz=$1 build=$2
bwrap --dev-bind / / true || { echo "aquí no se puede encerrar nada (bubblewrap)"; exit 77; }
carpeta=$(mktemp -d)
trap 'rm -rf "$carpeta"' EXIT
cmake --install "$build" --prefix "$carpeta/instalado" >"$carpeta/instala" 2>&1 || { cat "$carpeta/instala"; exit 1; }
mkdir "$carpeta/imagenes"

for casos in "$build"/casos/*.sh; do # una línea por programa: capítulo, programa, fichero del golden, guion
  primero=()
  caso() { [ ${#primero[@]} != 0 ] || primero=("$@"); }
  # shellcheck disable=SC1090
  source "$casos"
  guion='' fichero=''
  for campo in "${primero[@]}"; do declare "$campo"; done
  programa=$(basename "$casos" .sh)
  cp "$build/$(<"$build/sin_ventana")/$capitulo/$programa" "$carpeta/instalado/$capitulo/$programa"
  printf '%s\t%s\t%s\t%s\n' "$capitulo" "$programa" "$fichero" "$(tr '\n' ';' <<<"$guion")"
done >"$carpeta/lista"

unset LAB_LEIDOS
mkdir -p "$build/cache_shaders" # lo único del build que se ve: ahorra compilarlos
# shellcheck disable=SC2016
bwrap --ro-bind / / --dev /dev --proc /proc --bind "$carpeta" "$carpeta" --tmpfs "$raiz" --tmpfs "$build" \
  --bind "$build/cache_shaders" "$build/cache_shaders" --chdir "$carpeta" \
  bash -c 'while IFS=$'"'\\t'"' read -r capitulo programa fichero guion; do
    "instalado/$capitulo/$programa" -geometry 240x180 -ppm "imagenes/$fichero.ppm" -guion "$guion" \
      >/dev/null </dev/null ||
      echo "$programa: estado $?"
  done <lista' 2>&1 | tee "$carpeta/mal"

estado=0
[ ! -s "$carpeta/mal" ] || estado=1
while IFS=$'\t' read -r capitulo _ fichero _; do
  golden=$raiz/tests/golden/$capitulo/$fichero.ppm
  "$build/herramientas/comparador/compara" "$golden" "$carpeta/imagenes/$fichero.ppm" >"$carpeta/dice" 2>&1 ||
    { echo "$fichero: instalado dibuja otra cosa"; cat "$carpeta/dice"; estado=1; }
done <"$carpeta/lista"
exit $estado
