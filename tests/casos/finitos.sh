#!/usr/bin/env bash
# finitos.sh BUILD CAPÍTULO PROGRAMA FICHERO TOLERANCIA GUION: dibuja el caso en una ventana de float y mira que todos sus colores sean
# finitos.
# finitos.sh BUILD planta: planta un NaN y un infinito en un shader, y exige que se vean.
set -euo pipefail
build=$1
aqui=$(cd "$(dirname "$0")" && pwd)
carpeta=$(mktemp -d)
trap 'rm -rf "$carpeta"' EXIT
cd "$carpeta"

dibuja() { # CAPÍTULO PROGRAMA GUION
  LD_PRELOAD=$build/tests/libfinitos.so "$build/osmesa/$1/$2" -geometry 240x180 -ppm imagen.ppm -guion "$3" >/dev/null 2>errores </dev/null
}

if [ "$2" != planta ]; then
  dibuja "$2" "$3" "${6/#-/}" || { cat errores; exit 1; }
  exit 0
fi
shader=ch05_iluminacion/sombreado_phong.frag
mkdir ch05_iluminacion
for malo in '' 'sqrt(-1.0 - La.x)' '1.0 / (La.x - La.x)'; do
  sed "s|colorFragmento = .*|&${malo:+ colorFragmento.b = $malo;}|" "$aqui/../../$shader" >$shader
  estado=0
  LAB_RAIZ=$carpeta dibuja ch05_iluminacion materiales '' || estado=$?
  [ $estado = "$([ -z "$malo" ] && echo 0 || echo 4)" ] || { echo "con «$malo» ha acabado con $estado:"; cat errores; exit 1; }
done
