#!/usr/bin/env bash
# uso.sh BUILD: los programas de Windows como los usa un alumno, bajo Wine y en una carpeta suya con espacios y eñes:
# los títulos, F12, F5 tras cambiar un shader y tras estropearlo, los mensajes de error y la consola que abre un doble
# clic.
# shellcheck disable=SC2317 # «pronto» llama a las funciones que se le dan
set -euo pipefail
build=$1
aqui=$(cd "$(dirname "$0")" && pwd)
source "$aqui/../ventana/pantalla.sh"
source "$aqui/../ventana/xdotool.sh"
source "$aqui/wine.sh"
fallos=0
mal() { echo "$*"; fallos=1; }

carpeta=$(mktemp -d)
trap 'kill ${pid:-} 2>/dev/null || true; cierra_wine; cierra_pantalla; rm -rf "$carpeta"' EXIT
abre_pantalla
abre_wine "$carpeta"
cp -r "$laboratorio" "$carpeta/Año 2º de Íñigo"
laboratorio="$carpeta/Año 2º de Íñigo"
mkdir "$carpeta/imágenes"
cd "$carpeta/imágenes"

pronto() { # ORDEN…: se cumple en un minuto
  local _
  for _ in $(seq 600); do
    ! "$@" >/dev/null 2>&1 || return 0
    sleep 0.1
  done
  return 1
}
abre() { # PROGRAMA: en una ventana de 240x180
  abre_en_wine "$1" -geometry 240x180+10+10 >salida 2>errores || mal "$1 no abre su ventana: $(cat errores)"
}
tiene_color() { # R G B
  xwd -silent -id "$ventana" | xwdtopnm -quiet | ppmhist -noheader | grep -E "^ *$1 +$2 +$3[[:space:]]"
}
dibujado() { [ "$(xwd -silent -id "$ventana" | xwdtopnm -quiet | ppmhist -noheader | wc -l)" -gt 1 ]; }
# shellcheck disable=SC2034 # es para dibujado
tiene_el_teclado() { ventana=$("$build/tests/ventana" activa "$1"); } # PROGRAMA.exe
con_controles() { [ "$(xwd -silent -id "$ventana" | cksum)" != "$sin_controles" ]; }
acabado() { ! kill -0 "$pid"; }
cierra() { # con Esc
  local estado=0
  xdotool key Escape
  pronto acabado || mal 'Esc no lo termina'
  wait "$pid" || estado=$?
  [ $estado = 0 ] || mal "Esc lo termina con estado $estado"
}
cambia() { # FICHERO PROGRAMA-DE-SED: con los fines de línea del Bloc de notas
  sed -i "$2; s/\r*\$/\r/" "$laboratorio/$1"
}
titulo() { [ "$(xdotool getwindowname "$ventana")" = "$1" ]; }

# --- títulos, F12 y F5 --------------------------------------------------------------------------------------------

abre normales
pronto dibujado || mal 'normales no dibuja'
sin_controles=$(xwd -silent -id "$ventana" | cksum)
xdotool key 67 # F1
pronto con_controles || mal 'F1 no enseña los controles'
pronto titulo 'Normales transformadas: M = I' || mal "el título es «$(xdotool getwindowname "$ventana")»"
xdotool key 3
pronto titulo 'Normales transformadas: M = S(−2, 1, 1)' ||
  mal "tras la tecla 3, el título es «$(xdotool getwindowname "$ventana")»"
cierra

plana=ch02_modelado/plana.frag
abre figura_color
pronto dibujado || mal 'figura_color no dibuja'
xdotool key 96 # F12
pronto grep -qx 'guardado figura_color-1.png' salida || mal "F12 no dice que ha guardado la imagen: $(cat salida)"
pngtopnm figura_color-1.png >figura_color-1.ppm
"$build/herramientas/comparador/compara" "$aqui/../golden/ch02_modelado/figura_color.ppm" figura_color-1.ppm --amplia ||
  fallos=1
cambia $plana 's/= nuevoColor/= vec4(1.0, 0.0, 1.0, 1.0)/'
xdotool key 71 # F5
pronto tiene_color 255 0 255 || mal 'F5 no usa el shader cambiado'
cambia $plana 's/colorFragmento = .*/esto no compila;/'
xdotool key 71
pronto grep -q "^figura_color: .*$plana:7: .*«esto no compila;»" errores ||
  mal "F5 con un shader roto dice: $(cat errores)"
pronto tiene_color 255 0 255 || mal 'F5 con un shader roto no deja lo que había'
cierra

# --- lo que dice cuando no puede ------------------------------------------------------------------------------------

espera() { # ESTADO TEXTO PROGRAMA [opciones]
  local estado=0 esperado=$1 texto=$2
  shift 2
  (ejecuta_en_wine "$@") >salida 2>errores </dev/null || estado=$?
  [ $estado = "$esperado" ] && [[ $(cat salida errores) = *"$texto"* ]] ||
    mal "$*: estado $estado (debía ser $esperado); debía decir «$texto» y ha dicho: $(cat salida errores)"
}
espera 2 'grua: no entiendo «-rápido»' grua -rápido
espera 1 'malla_vf: no puedo leer «Íñigo no está.vf»' malla_vf 'Íñigo no está.vf'
espera 1 "figura_color: $plana:7: " figura_color
rm "$laboratorio/$plana"
espera 1 "figura_color: no encuentro «$plana»; lo he buscado en " figura_color
grep -q 'Año 2º de Íñigo' errores || mal "no dice dónde lo ha buscado: $(cat errores)"

# --- un doble clic ----------------------------------------------------------------------------------------------------

consola() { # ESTADO PROGRAMA
  local estado=0
  (
    cd "$laboratorio/programas" &&
      exec "$wine" "$build/windows/prueba/ejecuta.exe" consola -- "$2.exe" -display DISPLAY
  ) >/dev/null 2>&1 </dev/null || estado=$?
  mv "$laboratorio/programas/consola.txt" .
  [ $estado = "$1" ] || mal "$2, con doble clic, acaba con $estado y debía acabar con $1: $(cat consola.txt)"
}
consola 0 info_opengl
grep -q '^Anisotropía máxima: ' consola.txt && grep -q '^Pulsa Intro' consola.txt ||
  mal "info_opengl no deja leer su consola: $(cat consola.txt)"
consola 1 figura_color
[[ $(tr -d '\n' <consola.txt) = *'figura_color: no encuentro «'*'Pulsa Intro'* ]] ||
  mal "un error no deja leer la consola: $(cat consola.txt)"
{ pronto tiene_el_teclado grua.exe && pronto dibujado && xdotool key Escape; } &
consola 0 grua
! grep 'Pulsa Intro' consola.txt || mal 'la consola no se cierra con la ventana'

exit $fallos
