#!/usr/bin/env bash
# encuadre.sh BUILD DESTINO libre|llega CAPÍTULO PROGRAMA FICHERO TOLERANCIA GUION: lo que el caso enseña cabe entero en la ventana,
# ancha, a 4:3, casi cuadrada y alta: nada toca el borde, salvo en los casos que dicen con BORDE por qué llegan a él. Y por mucho que
# se aleje o se gire, sigue a la vista. De OSMesa, en ventanas de float: ningún color es NaN ni infinito (finitos.cpp).
set -euo pipefail
build=$1 destino=$2 borde=$3 capitulo=$4 programa=$5 nombre=$6 guion=${8/#-/}
carpeta=$(mktemp -d)
trap 'rm -rf "$carpeta"' EXIT
cd "$carpeta"
finitos=''
[ "$destino" != osmesa ] || finitos=$build/tests/libfinitos.so
dibuja() { # TALLA ÓRDENES: tras el guion
  LD_PRELOAD=$finitos "$build/$destino/$capitulo/$programa" -geometry "$1" -guion "$guion; $2" -ppm "última" >/dev/null </dev/null
}

pulsa='boton IZQUIERDO abajo 240 180' suelta='boton IZQUIERDO arriba' tallas=()
[ "$borde" = llega ] || tallas=(640x360 480x360 480x540 200x450)
ordenes="captura tal_cual; $pulsa; arrastra 240 2180; $suelta 240 2180; captura desde_arriba; $pulsa; arrastra 240 -3820; $suelta 240 -3820; captura desde_abajo
  tamano 32 24; rueda -1 9 9 ×40; tamano 240 180; captura alejada"
case $guion in
escala*) # adónde va el ratón depende de la talla
  for talla in "${tallas[@]}"; do dibuja "$talla" "captura $nombre-$talla.ppm"; done
  dibuja 240x180 "$ordenes"
  ;;
*) dibuja 240x180 "$(for talla in "${tallas[@]}"; do printf 'tamano %s; captura %s;' "${talla/x/ }" "$nombre-$talla.ppm"; done) tamano 240 180; $ordenes" ;;
esac
[ ${#tallas[@]} = 0 ] || "$build/tests/borde" "$nombre"*.ppm
"$build/tests/borde" --queda alejada desde_arriba desde_abajo
