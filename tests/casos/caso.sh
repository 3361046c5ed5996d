#!/usr/bin/env bash
# caso.sh BUILD DESTINO CAPÍTULO PROGRAMA FICHERO TOLERANCIA GUION
# Dibuja un caso del catálogo con un destino sin ventana y lo compara con su golden: la imagen y, en un .txt, los títulos que pone y lo
# que escribe; y en un .encima, lo que pinta encima (common/encima.h), que no está si no pinta nada. El programa debe acabar con 0 y no
# escribir nada en stderr. Si algo falla deja las imágenes en BUILD/fallos/. Con DORA, lo que sale pasa a ser el golden. Estado: 0 bien, 4
# si es distinto lo que pinta encima, aunque no sea lo único; 1 lo demás.
set -euo pipefail
build=$1 destino=$2 capitulo=$3 programa=$4 nombre=$5 tolerancia=$6 guion=$7
golden=$(cd "$(dirname "$0")/../golden" && pwd)/$capitulo/$nombre.ppm
texto=${golden%.ppm}.txt encima=${golden%.ppm}.encima

carpeta=$(mktemp -d)
trap 'rm -rf "$carpeta"' EXIT
cd "$carpeta" # ni el laboratorio ni su build: la carpeta de trabajo no importa
opciones=(-geometry 240x180 -ppm "$nombre.ppm" -titulos)
[ "$guion" = - ] || opciones+=(-guion "$guion")

estado=0
LAB_ENCIMA=lista "$build/$destino/$capitulo/$programa" "${opciones[@]}" >salida 2>errores </dev/null || estado=$?
# a SwiftShader le falta glLogicOp, que aquí no usa nadie, y lo que pide zink para los uniforms en array (28), que dibuja bien
[ -z "${OTRO:-}" ] || sed -i -e '/base Zink requirements: feats.features.logicOp/d' -e '/Unsupported capability 28$/d' errores
if [ $estado -ne 0 ] || [ -s errores ]; then
  echo "$programa ha acabado con estado $estado y ha escrito en stderr:"
  cat errores
  exit 1
fi
if [ "${DORA:-}" ]; then # ./lab dora: enseña lo que cambia y guarda la imagen como golden
  mkdir -p "$(dirname "$golden")"
  printf '%s: ' "$nombre"
  if [ -e "$golden" ]; then "$build/herramientas/comparador/compara" "$golden" "$nombre.ppm" || true; else echo "nueva"; fi
  cp "$nombre.ppm" "$golden"
  diff -N "$texto" salida || cp salida "$texto"
  "$build/tests/compara_encima" --escribe "$encima" lista || [ $? = 4 ]
  exit 0
fi
for falta in "$golden" "$texto"; do
  [ -e "$falta" ] && continue
  echo "falta el golden $falta: mira la imagen y hazlo con ./lab dora $nombre"
  exit 1
done
fallos=$build/fallos/${OTRO:-$destino}
mkdir -p "$fallos"
comparacion=(--deja "$fallos/$nombre")
# Los golden son de OSMesa. EGL dibuja las filas al revés, lo que se interpola redondea de otra manera y la tinta de un rótulo, que
# se mezcla, cambia un nivel en unos pocos píxeles: ninguno más. Donde se nota más, el caso da su motivo y su tolerancia.
if [ "${OTRO:-}" ]; then
  comparacion+=(--otro)
  [ "$tolerancia" = - ] || comparacion+=(--tolerancia "$tolerancia")
elif [ "$tolerancia" != - ]; then
  comparacion+=(--tolerancia "$tolerancia")
  [ "$destino" != egl ] || comparacion+=(--amplia)
elif [ "$destino" = egl ]; then
  comparacion+=(--redondeo)
fi
"$build/herramientas/comparador/compara" "$golden" "$nombre.ppm" "${comparacion[@]}" || estado=1
# lo que cuenta en sus píxeles un programa que sale distinto también lo es: queda el texto
if [ "${OTRO:-}" ] && [ "$tolerancia" != - ]; then
  diff -u <(tr -d 0-9 <"$texto") <(tr -d 0-9 <salida) || estado=1
else
  diff -u "$texto" salida || estado=1
fi
"$build/tests/compara_encima" "$encima" lista || estado=4
exit $estado
