#!/usr/bin/env bash
# finitos.sh BUILD CAPITULO: dibuja cada caso del capítulo en una ventana de float y mira que todos sus colores sean finitos.
# finitos.sh BUILD planta: planta un NaN y un infinito en un shader, y exige que se vean.
set -euo pipefail
build=$1
aqui=$(cd "$(dirname "$0")" && pwd)
carpeta=$(mktemp -d)
trap 'rm -rf "$carpeta"' EXIT

dibuja() { # CAPITULO PROGRAMA GUION ARGUMENTOS
  local opciones=(-geometry 240x180 -ppm "$carpeta/imagen.ppm") argumentos=()
  [ "$3" = - ] || opciones+=(-guion "$3")
  [ "$4" = - ] || read -ra argumentos <<<"$4"
  (cd "$carpeta" && LD_PRELOAD=$build/tests/libfinitos.so "$build/osmesa/$1/$2" "${opciones[@]}" "${argumentos[@]}" \
    >/dev/null 2>"$carpeta/errores" </dev/null)
}

if [ "$2" = planta ]; then
  shader=ch05_iluminacion/sombreado_phong.frag
  mkdir "$carpeta/ch05_iluminacion"
  for malo in '' 'sqrt(-1.0 - La.x)' '1.0 / (La.x - La.x)'; do
    sed "s|colorFragmento = .*|&${malo:+ colorFragmento.b = $malo;}|" "$aqui/../../$shader" >"$carpeta/$shader"
    estado=0
    LAB_RAIZ=$carpeta dibuja ch05_iluminacion materiales - - || estado=$?
    [ $estado = $([ -z "$malo" ] && echo 0 || echo 4) ] ||
      { echo "con «$malo» ha acabado con $estado:"; cat "$carpeta/errores"; exit 1; }
  done
  exit 0
fi
fallos=0
while IFS=$'\t' read -r capitulo programa caso guion argumentos _; do
  [ "$capitulo" = "$2" ] || continue
  dibuja "$capitulo" "$programa" "$guion" "$argumentos" || { echo "$programa, $caso: $(cat "$carpeta/errores")"; fallos=1; }
done <"$build/casos.tsv"
exit $fallos
