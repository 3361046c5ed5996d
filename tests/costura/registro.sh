#!/usr/bin/env bash
# registro.sh BUILD SIN_VENTANA: los mismos guiones a FreeGLUT (Xvfb, xdotool) y a glut_sin_ventana; lo que uno y otro le
# dicen al programa debe ser igual, línea a línea.
set -euo pipefail
build=$1 sin_ventana=$2
source "$(dirname "$0")/../ventana/xdotool.sh"
source "$(dirname "$0")/../ventana/pantalla.sh"
# Sin mayúsculas: con ellas FreeGLUT da además la pulsación de la tecla de mayúsculas, que el guion no tiene.
# Antes de nada el ratón entra en la ventana, para que la posición de las teclas sea conocida.
guion='mueve 20 30; tecla a; tecla z; tecla 5; tecla -; tecla PuntoYComa; tecla Espacio; tecla Intro; tecla Tab; tecla Retroceso; tecla Supr
especial F1; especial F12; especial IZQUIERDA; especial DERECHA; especial ARRIBA; especial ABAJO; especial INICIO
especial FIN; especial REPAG; especial AVPAG; especial INSERTAR
mueve 100 50; boton IZQUIERDO abajo 100 50; arrastra 120 60; arrastra 290 190; boton IZQUIERDO arriba 290 190
boton DERECHO abajo 10 10; arrastra 11 12; boton DERECHO arriba 30 40; boton CENTRAL abajo 30 40; boton CENTRAL arriba 30 40
rueda +1 50 60; rueda -1 50 60; rueda -1 70 80
tecla q ×3; escala 150 100; mueve 70 90; tamano 400 300; mueve 138 98; tamano 123 457; tamano 64 1; tecla q; tecla Esc'
# La rueda como botones, el ocio, y los menús: abrir y no elegir, el submenú, una opción que cambia, y la que termina.
guion_menu='mueve 20 30; rueda +1 20 30; rueda -1 50 60; tecla o; tecla a; tecla o; tecla b
boton DERECHO abajo 200 50; boton DERECHO arriba 200 50; mueve 100 50; boton IZQUIERDO abajo 100 50; boton IZQUIERDO arriba 100 50
mueve 290 150; menu Vista/Perfil; mueve 21 31; tecla c; mueve 290 150; menu Ejes quitados; mueve 22 32; tecla d
mueve 290 150; menu Ejes puestos; mueve 23 33; tecla e; mueve 290 150; menu Salir'
# El menú se abre donde está el ratón y sale por la derecha de la ventana: al soltar sobre él, el programa no se entera.
# Cada opción mide 24 píxeles de alto; el submenú sale a la altura de la suya, y su x está dentro de él.
elige_en_menu() {
  local -A fila=([Vista/Perfil]=0 [Ejes quitados]=1 [Ejes puestos]=1 [Salir]=2)
  local x=${raton% *} y=${raton#* }
  pasos+=(click 3 sleep "$PAUSA")
  lleva_raton $((x + 20)) $((y + 14 + 24 * fila[$1]))
  pasos+=(sleep "$PAUSA")
  if [ "$1" = Vista/Perfil ]; then
    lleva_raton $((x + 300)) $((y + 14 + 24))
    pasos+=(sleep "$PAUSA")
  fi
  pasos+=(click 1)
}

carpeta=$(mktemp -d)
trap 'kill $pid 2>/dev/null || true; cierra_pantalla; rm -rf "$carpeta"' EXIT
cd "$carpeta"
abre_pantalla

compara() { # PROGRAMA GUION [ARGUMENTO]: a los dos, y la diferencia; en PROGRAMA, DESTINO es con qué GLUT
  local programa=$build/$1 ordenes=${2//$'\n'/;}
  shift 2
  "${programa/DESTINO/$sin_ventana}" -geometry 300x200+10+10 -guion "$ordenes" -ppm x.ppm "$@" >sin_ventana
  # Con la máquina ocupada X junta sucesos que el guion separa: si algo difiere se repite más despacio.
  for PAUSA in 0.03 0.1 0.3 1; do
    rm -f ./*.ppm # F12 las numera
    xdotool mousemove 1200 1000
    abre "${programa/DESTINO/ventana}" -geometry 300x200+10+10 "$@" >freeglut
    haz_guion 300x200 "$ordenes"
    ! sigue 5 || kill "$pid"
    wait "$pid" && diff freeglut sin_ventana >diferencia && { echo "iguales: $(wc -l <freeglut) líneas"; return; }
  done
  cat diferencia 2>/dev/null || echo "${programa##*/} no acaba con 0"
  echo "(< FreeGLUT, > sin ventana)"
  exit 1
}
compara tests/registro_DESTINO "$guion"
compara tests/registro_DESTINO "$guion_menu" menu
