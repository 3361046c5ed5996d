#!/usr/bin/env bash
# caso.sh BUILD DESTINO PROGRAMA CASO [opciones de compara]
# Dibuja un caso de build/casos.tsv con un destino sin ventana y lo compara con su golden. El programa debe acabar con
# 0 y no escribir nada en stderr. Si algo falla deja las imágenes en BUILD/fallos/.
set -euo pipefail
build=$1 destino=$2 programa=$3 caso=$4
shift 4
aqui=$(cd "$(dirname "$0")" && pwd)

IFS=$'\t' read -r capitulo _ _ guion argumentos tolerancia nombre _ \
  < <(awk -F'\t' -v p="$programa" -v c="$caso" '$2 == p && $3 == c' "$build/casos.tsv")
golden=$aqui/../golden/$capitulo/$nombre.ppm

carpeta=$(mktemp -d)
trap 'rm -rf "$carpeta"' EXIT
cd "$carpeta" # ni el laboratorio ni su build: la carpeta de trabajo no importa
opciones=(-geometry 240x180 -ppm "$nombre.ppm")
[ "$guion" = - ] || opciones+=(-guion "$guion")
[ "$argumentos" = - ] || read -ra argumentos <<<"$argumentos"
[ "${argumentos[0]}" = - ] || opciones+=("${argumentos[@]}")

estado=0
"$build/$destino/$capitulo/$programa" "${opciones[@]}" >salida 2>errores </dev/null || estado=$?
if [ $estado -ne 0 ] || [ -s errores ]; then
  echo "$programa ha acabado con estado $estado y ha escrito en stderr:"
  cat errores
  exit 1
fi
if [ "${DORA:-}" ]; then # ./lab dora: enseña lo que cambia y guarda la imagen como golden
  mkdir -p "$(dirname "$golden")"
  if [ -e "$golden" ]; then "$build/tests/compara" "$golden" "$nombre.ppm" || true; else echo "nueva"; fi
  cp "$nombre.ppm" "$golden"
  exit 0
fi
if [ ! -e "$golden" ]; then
  echo "falta el golden $golden: mira la imagen y hazlo con ./lab dora $nombre"
  exit 1
fi
mkdir -p "$build/fallos/$destino"
if [ "$tolerancia" != - ]; then
  set -- --tolerancia "$tolerancia" "$@"
  # los golden son de OSMesa, que dibuja las filas al revés que EGL: donde eso se nota, el caso da su motivo y su tolerancia
  [ "$destino" != egl ] || set -- --amplia "$@"
fi
"$build/tests/compara" "$golden" "$nombre.ppm" --deja "$build/fallos/$destino/$nombre" "$@"
