#!/usr/bin/env bash
# textos.sh RAIZ BIBLIOTECA: lo que se puede comprobar sin ejecutar nada: la tabla de README.md está al día, cada programa
# dice sus controles, cada shader empieza por #version 140 y pasa glslangValidator, y glut_sin_ventana.h enumera lo que hay.
set -euo pipefail
cd "$1"
fallos=0
mal() { echo "$*"; fallos=1; }

diff <(sed -n '/<!-- tabla/,/<!-- fin de la tabla/p' README.md | grep '^|') <(LAB_SIN_INSTALAR=1 ./lab lista --tabla) ||
  mal 'la tabla de README.md no está al día: ./lab lista --readme'

while IFS=$'\t' read -r capitulo programa _; do
  grep -q '^// Controles: .*\.$' "$capitulo/$programa.cpp" || mal "$capitulo/$programa.cpp: falta la línea «// Controles: ….»"
done < <(LAB_SIN_INSTALAR=1 ./lab lista --tsv)

carpeta=$(mktemp -d)
trap 'rm -rf "$carpeta"' EXIT
for shader in ch*/*.vert ch*/*.frag; do
  [ "$(head -n 1 "$shader")" = '#version 140' ] || mal "$shader no empieza por #version 140"
  [[ $shader != *errores_shader_compila.frag ]] || continue # está mal a propósito
  # los #include del laboratorio se sustituyen como lo hace common/shader.cpp
  awk '/^#include "/ { gsub(/"/, "", $2); while ((getline linea < $2) > 0) print linea; next } { print }' "$shader" \
    >"$carpeta/${shader##*/}"
  glslangValidator "$carpeta/${shader##*/}" >"$carpeta/informe" || { mal "$shader no pasa glslangValidator"; cat "$carpeta/informe"; }
done

diff <(grep -oE '\bglut[A-Z][A-Za-z]+' <(sed '/Cualquier otra/,$d' common/glut_sin_ventana/glut_sin_ventana.h) | sort) \
  <(nm -C --defined-only "$2" | awk '$2 == "T" && $3 ~ /^glut[A-Z]/ { print $3 }' | sort) ||
  mal 'glut_sin_ventana.h no enumera justo las funciones que hay'
exit $fallos
