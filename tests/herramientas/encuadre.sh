#!/usr/bin/env bash
# encuadre.sh BUILD DESTINO PROGRAMA CASO: lo que el caso enseña cabe entero en la ventana, ancha, a 4:3, casi cuadrada y alta:
# nada toca el borde. Un caso cuya escena llega al borde a propósito lo dice con BORDE y no pasa por aquí.
set -euo pipefail
build=$1 destino=$2 programa=$3 caso=$4
IFS=$'\t' read -r capitulo _ _ guion argumentos _ \
  < <(awk -F'\t' -v p="$programa" -v c="$caso" '$2 == p && $3 == c' "$build/casos.tsv")
opciones=()
[ "$guion" = - ] || opciones+=(-guion "$guion")
[ "$argumentos" = - ] || { read -ra argumentos <<<"$argumentos"; opciones+=("${argumentos[@]}"); }
carpeta=$(mktemp -d)
trap 'rm -rf "$carpeta"' EXIT
cd "$carpeta"
for talla in 640x360 480x360 480x540 200x450; do
  "$build/$destino/$capitulo/$programa" -geometry $talla -ppm "$programa-$caso-$talla.ppm" "${opciones[@]}" >/dev/null </dev/null
done
"$build/tests/borde" ./*.ppm
