#!/usr/bin/env bash
# textos.sh RAIZ BIBLIOTECA: lo que se puede comprobar sin ejecutar nada: todo lo del libro está en
# docs/programas.md, cada shader empieza por #version 140 y pasa glslangValidator, también como GLSL ES 3.00 (el de
# ./lab web), y glut_sin_ventana.h enumera lo que hay, que no choca con lo que defina un programa.
set -euo pipefail
cd "$1"
fallos=0
mal() { echo "$*"; fallos=1; }

grep '|  |$' docs/programas.md && mal 'eso es del libro y no tiene programa, respuesta ni, en docs/libro.tsv, motivo'

cabecera_essl=$(sed -n '/R"(/,/^)"/{s/.*R"(//;/^)"/!p}' glut/sin_ventana/essl.h)
[ "${cabecera_essl%%$'\n'*}" = '#version 300 es' ] || mal 'no encuentro la cabecera de essl.h'
carpeta=$(mktemp -d)
trap 'rm -rf "$carpeta"' EXIT
python3 -B herramientas base.marcas . "$carpeta/por hacer"
for arbol in . "$carpeta/por hacer"; do # también con los ejercicios por hacer
  python3 -B herramientas base.fuentes "$arbol" "$carpeta"
  pushd "$arbol" >/dev/null
  for shader in common/*.frag common/encima/*.vert common/encima/*.frag ch*/*.vert ch*/*.frag; do
    [ "$(head -n 1 "$shader")" = '#version 140' ] || mal "$shader no empieza por #version 140"
    llano=${shader//\//-} # hay dos que se llaman igual
    [[ $shader != *errores_shader_compila.frag ]] || { rm "$carpeta/$llano"; continue; } # está mal a propósito
    { echo "$cabecera_essl"; tail -n +2 "$carpeta/$llano"; } >"$carpeta/es-$llano"
  done
  if ! glslangValidator "$carpeta"/*.vert "$carpeta"/*.frag >"$carpeta/informe"; then
    dice=$(awk '/^(ERROR|WARNING)/ { print fichero ": " $0; next } { fichero = $0 }' "$carpeta/informe")
    mal "en $arbol no pasan glslangValidator: $dice"
  fi
  popd >/dev/null
done

diff <(grep -oE '\bglut[A-Z][A-Za-z]+' <(sed '/Cualquier otra/,$d' glut/sin_ventana/glut_sin_ventana.h) | sort) \
  <(nm -C --defined-only "$2" | awk '$2 == "T" && $3 ~ /^glut[A-Z]/ { print $3 }' | sort) ||
  mal 'glut_sin_ventana.h no enumera justo las funciones que hay'
# sus demás nombres van en su espacio: los que defina un programa no chocan con ellos
suyos='^(glut[A-Z]|glX[A-Z]|__wrap_glewInit$|sin_ventana::)'
awk -v suyos="$suyos" '$2 ~ /^[TDBRC]$/ && $3 !~ suyos { print $3; mal = 1 } END { exit mal }' \
  <(nm -C --defined-only "$2") ||
  mal 'glut_sin_ventana tiene nombres fuera de sin_ventana'

exit $fallos
