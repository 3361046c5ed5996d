#!/usr/bin/env bash
# suavizada.sh BUILD: con LAB_SUAVIZA, como dibuja la galería, un programa de cada capítulo tiene todos los colores
# que sin ella, y los de sus bordes.
set -euo pipefail
estado=0
imagen=$(mktemp)
trap 'rm -f "$imagen"' EXIT
colores() { "$1" -geometry 240x180 -ppm "$imagen" >/dev/null && ppmhist -noheader "$imagen" | wc -l; }
for capitulo in "$1"/egl/ch*; do
  programa=$(find "$capitulo" -type f -executable -name '[a-h]*' | sort | sed -n 1p)
  con=$(LAB_SUAVIZA=1 colores "$programa") sin=$(colores "$programa")
  ((con >= sin)) || { echo "$programa: $con colores y, sin suavizar, $sin" && estado=1; }
done
exit $estado
