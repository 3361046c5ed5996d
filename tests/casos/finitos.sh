#!/usr/bin/env bash
# finitos.sh BUILD: planta un NaN y un infinito en un shader, y exige que se vean en una ventana de float (finitos.cpp).
set -euo pipefail
build=$1 shader=ch05_iluminacion/sombreado_phong.frag
aqui=$(cd "$(dirname "$0")" && pwd)
carpeta=$(mktemp -d)
trap 'rm -rf "$carpeta"' EXIT
cd "$carpeta"
mkdir ch05_iluminacion
for malo in '' 'sqrt(-1.0 - La.x)' '1.0 / (La.x - La.x)'; do
  sed "s|colorFragmento = .*|&${malo:+ colorFragmento.b = $malo;}|" "$aqui/../../$shader" >$shader
  estado=0
  LAB_RAIZ=$carpeta LD_PRELOAD=$build/tests/libfinitos.so "$build/osmesa/ch05_iluminacion/materiales" >/dev/null 2>errores </dev/null || estado=$?
  [ $estado = "$([ -z "$malo" ] && echo 0 || echo 4)" ] || { echo "con «$malo» ha acabado con $estado:"; cat errores; exit 1; }
done
