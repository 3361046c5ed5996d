#!/usr/bin/env bash
# capitulo.sh BUILD CAPÍTULO: los casos de todos sus programas en una ventana de verdad (casos.sh), uno tras otro en el
# mismo Xvfb.
set -euo pipefail
build=$1 capitulo=$2 estado=0
aqui=$(cd "$(dirname "$0")" && pwd)
source "$aqui/pantalla.sh"
trap cierra_pantalla EXIT
abre_pantalla
export PANTALLA_ABIERTA=1
((10#${capitulo:2:2} % 2)) || xdotool key Caps_Lock # en los pares: con él, las teclas son las mismas
for casos in $(cd "$build/casos" && grep -lx "capitulo=$capitulo" -- *.sh); do
  setpriv --pdeathsig KILL "$aqui/../casos/casos.sh" "$build" ventana "${casos%.sh}" || estado=1
done
exit $estado
