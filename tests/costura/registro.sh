#!/usr/bin/env bash
# registro.sh BUILD SIN_VENTANA: el mismo guion a FreeGLUT (Xvfb, xdotool) y a glut_sin_ventana; lo que uno y otro le
# dicen al programa debe ser igual, línea a línea.
set -euo pipefail
build=$1 sin_ventana=$2
source "$(dirname "$0")/../herramientas/xdotool.sh"
DISPLAY=:$(cat "$build/xvfb/pantalla")
export DISPLAY
# Sin mayúsculas: con ellas FreeGLUT da además la pulsación de la tecla de mayúsculas, que el guion no tiene.
# Antes de nada el ratón entra en la ventana, para que la posición de las teclas sea conocida.
guion='mueve 20 30; tecla a; tecla z; tecla 5; tecla -; tecla PuntoYComa; tecla Espacio; tecla Intro; tecla Tab; tecla Retroceso; tecla Supr
especial F1; especial F12; especial IZQUIERDA; especial DERECHA; especial ARRIBA; especial ABAJO; especial INICIO
especial FIN; especial REPAG; especial AVPAG; especial INSERTAR
mueve 100 50; boton IZQUIERDO abajo 100 50; arrastra 120 60; arrastra 290 190; boton IZQUIERDO arriba 290 190
boton DERECHO abajo 10 10; arrastra 11 12; boton DERECHO arriba 30 40; boton CENTRAL abajo 30 40; boton CENTRAL arriba 30 40
rueda +1 50 60; rueda -1 50 60; rueda -1 70 80
tamano 400 300; mueve 390 290; tamano 123 457; tamano 64 1; tecla q; tecla Esc'

carpeta=$(mktemp -d)
trap 'kill $pid 2>/dev/null || true; rm -rf "$carpeta"' EXIT
cd "$carpeta"
xdotool mousemove 1200 1000
"$build/tests/registro_ventana" -geometry 300x200+10+10 >freeglut </dev/null &
pid=$!
espera_ventana $pid
PAUSA=0.08 haz_guion "${guion//$'\n'/;}"
wait $pid
"$build/tests/registro_$sin_ventana" -geometry 300x200+10+10 -guion "${guion//$'\n'/;}" -ppm x.ppm >sin_ventana
diff freeglut sin_ventana || { echo "(< FreeGLUT, > sin ventana)"; exit 1; }
echo "iguales: $(wc -l <freeglut) líneas"
