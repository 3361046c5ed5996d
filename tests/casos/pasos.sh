#!/usr/bin/env bash
# pasos.sh BUILD DESTINO CAPÍTULO PROGRAMA: lo que pinta encima el programa tras cada línea de tests/golden/CAPÍTULO/PROGRAMA.pasos, que son
# órdenes de un guion y siguen a las de antes, es lo de PROGRAMA-pasos.encima. La ventana es de 480x360, o de lo que diga un «# talla
# ANCHOxALTO». Con DORA, lo que sale pasa a ser el golden. Estado: 0 bien, 4 si es distinto, 1 lo demás.
set -euo pipefail
build=$1 destino=$2 capitulo=$3 programa=$4
golden=$(cd "$(dirname "$0")/../golden" && pwd)/$capitulo/$programa
carpeta=$(mktemp -d)
trap 'rm -rf "$carpeta"' EXIT
cd "$carpeta"
talla=$(sed -n 's/^# talla //p' "$golden.pasos")
grep -v -e '^#' -e '^ *$' "$golden.pasos" >pasos
awk '{ print $0 "\ncaptura " NR }' pasos >guion
estado=0
LAB_ENCIMA=lista "$build/$destino/$capitulo/$programa" -geometry "${talla:-480x360}" -ppm "última" -guion @guion >/dev/null 2>errores </dev/null || estado=$?
if [ $estado -ne 0 ] || [ -s errores ]; then
  echo "$programa ha acabado con estado $estado y ha escrito en stderr:"
  cat errores
  exit 1
fi
# cada lista, con el nombre de su paso; la última imagen es otra vez la del último
awk -F '\t' -v OFS='\t' 'NR == FNR { paso[NR] = $0; next } /^imagen\t/ { if ($2 == "última") exit; $2 = paso[$2] } { print }' pasos lista >con_nombre
[ -z "${DORA:-}" ] || echo "$programa.pasos:"
"$build/tests/compara_encima" ${DORA:+--escribe} "$golden-pasos.encima" con_nombre || estado=$?
if [ "${DORA:-}" ]; then [ $estado != 1 ]; else [ $estado = 0 ] || exit 4; fi
