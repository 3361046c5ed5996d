#!/usr/bin/env bash
# encuadre.sh BUILD DESTINO PROGRAMA CASO libre|llega: lo que el caso enseña cabe entero en la ventana, ancha, a 4:3, casi cuadrada y alta:
# nada toca el borde, salvo en los casos que dicen con BORDE por qué llegan a él. Y por mucho que se aleje o se gire, sigue a la vista.
set -euo pipefail
build=$1 destino=$2 programa=$3 caso=$4 borde=$5
IFS=$'\t' read -r capitulo _ _ guion argumentos _ \
  < <(awk -F'\t' -v p="$programa" -v c="$caso" '$2 == p && $3 == c' "$build/casos.tsv")
extra=()
[ "$argumentos" = - ] || read -ra extra <<<"$argumentos"
[ "$guion" != - ] || guion=
carpeta=$(mktemp -d)
trap 'rm -rf "$carpeta"' EXIT
cd "$carpeta"
# El guion, con el ratón llevado de la ventana de 240×180 para la que está escrito a una de talla $1
a_escala() {
  awk -v ancho="${1%x*}" -v alto="${1#*x}" -v RS=';' -v ORS=';' '
    $1 ~ /^(boton|arrastra|mueve|rueda)$/ { $(NF - 1) = int($(NF - 1) * ancho / 240); $NF = int($NF * alto / 180) }
    { print }' <<<"$2"
}
dibuja() { # TALLA GUION
  "$build/$destino/$capitulo/$programa" -geometry "$1" -guion "$2" -ppm "última" "${extra[@]}" >/dev/null </dev/null
}

if [ "$borde" = libre ]; then
  tallas=(640x360 480x360 480x540 200x450)
  case ";$guion" in
  *boton* | *arrastra* | *mueve* | *rueda*) # el ratón depende de la talla: una ejecución cada una
    for talla in "${tallas[@]}"; do dibuja $talla "$(a_escala $talla "$guion"); captura $programa-$caso-$talla.ppm"; done ;;
  *) dibuja 240x180 "$guion$(for talla in "${tallas[@]}"; do
      printf '; tamano %s; captura %s' "${talla/x/ }" "$programa-$caso-$talla.ppm"
    done)" ;;
  esac
  "$build/tests/borde" "$programa"*.ppm
fi
pulsa='boton IZQUIERDO abajo 240 180' suelta='boton IZQUIERDO arriba'
dibuja 240x180 "$guion$(printf '; rueda -1 9 9%.0s' {1..40}); captura alejada"
dibuja 240x180 "$guion; $pulsa; arrastra 240 2180; $suelta 240 2180; captura desde_arriba
  $pulsa; arrastra 240 -3820; $suelta 240 -3820; captura desde_abajo"
"$build/tests/borde" --queda alejada desde_arriba desde_abajo
