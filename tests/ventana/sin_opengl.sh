#!/usr/bin/env bash
# sin_opengl.sh BUILD: sin pantalla, con una sin GLX y con un OpenGL anterior, una ventana no se abre y lo dice una sola
# línea en español, con estado 1; info_opengl, que no pide versión, dice que falta.
set -euo pipefail
build=$1
source "$(dirname "$0")/pantalla.sh"
salida=$(mktemp)
trap 'cierra_pantalla; rm -f "$salida"' EXIT
fallos=0
espera() { # MENSAJE ORDEN…
  local mensaje=$1 estado=0
  shift
  timeout 20 "$@" >"$salida" 2>&1 </dev/null || estado=$?
  [ $estado = 1 ] && grep -q "^$mensaje" "$salida" &&
    { [ "$(wc -l <"$salida")" = 1 ] || [ "${1##*/}" = info_opengl ]; } && return
  echo "$*: acaba con $estado y debía acabar con 1 diciendo «$mensaje»:"
  cat "$salida"
  fallos=1
}
grua=$build/ventana/ch03_transformaciones/grua
primer=$build/ventana/ch01_intro/primer_programa info=$build/ventana/ch01_intro/info_opengl
unset DISPLAY WAYLAND_DISPLAY
espera 'grua: no hay pantalla en que abrir la ventana: ' "$grua"
espera 'primer_programa: no hay pantalla en que abrir la ventana: ' "$primer"
abre_pantalla -extension GLX
espera 'grua: hace falta OpenGL 3.1 y esta pantalla no lo da: ' "$grua"
espera 'primer_programa: hace falta OpenGL 3.1 y esta pantalla no lo da: ' "$primer"
espera 'info_opengl: hace falta OpenGL 3.1 y esta pantalla no lo da: ' "$info"
cierra_pantalla
abre_pantalla
export MESA_GL_VERSION_OVERRIDE=2.1
espera 'grua: hace falta OpenGL 3.1 y ' "$grua"
espera 'primer_programa: hace falta OpenGL 3.1 y ' "$primer"
espera 'Falta: OpenGL 3.1 o posterior' "$info"
exit $fallos
