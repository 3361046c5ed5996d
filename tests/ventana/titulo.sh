#!/usr/bin/env bash
# titulo.sh BUILD PROGRAMA TÍTULO…: el título que X11 enseña de la ventana es uno de los dados (FreeGLUT anterior a 3.8
# no puede poner los que no caben en Latin-1).
set -euo pipefail
build=$1 programa=$2
shift 2
source "$(dirname "$0")/pantalla.sh"
source "$(dirname "$0")/xdotool.sh"
trap 'kill ${pid:-} 2>/dev/null || true; cierra_pantalla' EXIT
abre_pantalla
abre "$build/$programa"
# Manda _NET_WM_NAME, si está, sobre WM_NAME. El programa puede ponerlo con su primera imagen: se mira diez segundos
# como mucho.
for _ in {1..100}; do
  obtenido=$(LC_ALL=C.UTF-8 xprop -id "$ventana" -notype WM_NAME _NET_WM_NAME |
    sed -n 's/.* = "\(.*\)"$/\1/p' | tail -n 1)
  for titulo in "$@"; do [ "$obtenido" != "$titulo" ] || { echo "bien: «$obtenido»"; exit 0; }; done
  sigue 0.1 || break
done
echo "el título es «$obtenido» y debía ser «$1»"
exit 1
