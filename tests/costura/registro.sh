#!/usr/bin/env bash
# registro.sh BUILD SIN_VENTANA SEMILLA…: las mismas partidas (partida.h) con FreeGLUT (Xvfb, xdotool) y con
# glut_sin_ventana: lo que registro.cpp apunta con uno y otro es igual, línea a línea, y el título de la ventana, el que
# pidió. Menos la hora, cuántas veces se dibuja lo que nadie ha pedido que se repinte y las tallas de la ventana que ya
# no está.
set -euo pipefail
build=$1 sin_ventana=$2
shift 2
source "$(dirname "$0")/../ventana/xdotool.sh"
source "$(dirname "$0")/../ventana/pantalla.sh"
carpeta=$(mktemp -d)
trap 'kill ${pid:-} 2>/dev/null || true; cierra_pantalla; rm -rf "$carpeta"' EXIT
cd "$carpeta"
abre_pantalla

# De lo dibujado queda lo primero tras pedirlo.
limpia() { # DIARIO LIMPIO
  sed 's/, a [0-9]* ms$//' "$1" | awk '/^- repinta/ { pedido = 1 }
    /^dibuja / { if (!pedido) next; pedido = 0 } { print }' >"$2"
}
prueba() { # SEMILLA
  "$build/tests/partida" "$1" .
  "$build/tests/registro_$sin_ventana" -geometry 300x200 -guion "$(cat guion)" -ppm x.ppm "$(cat tandas)" >diario
  limpia diario debe
  # Con la máquina ocupada X junta sucesos que el guion separa: si algo difiere se repite más despacio.
  # shellcheck disable=SC2034 # es para haz_guion
  # shellcheck disable=SC2034 # la usa haz_guion
  for PAUSA in 0.03 0.1 0.3 1; do
    xdotool mousemove 1200 1000
    abre "$build/tests/registro_ventana" -geometry 300x200+10+10 "$(cat tandas)" >diario
    { TITULOS=1 haz_guion 300x200 "$(cat real)" 2>/dev/null || true; } | uniq >vistos # la última orden lo acaba
    ! sigue 5 || kill "$pid"
    wait "$pid" && limpia diario hay &&
      diff debe hay >diferencia && diff titulos <(sed 1d vistos) >>diferencia && return
  done
  cat diferencia
  echo "(< sin ventana, > FreeGLUT) con la semilla $1"
  fallos=1
}
fallos=0
for semilla; do prueba "$semilla"; done
exit $fallos
