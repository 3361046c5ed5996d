#!/usr/bin/env bash
# ventana.sh BUILD paseo|windows|- {CAPÍTULO PROGRAMA FICHERO TOLERANCIA GUION}…: cada caso en una ventana de FreeGLUT, uno detrás de otro en un
# Xvfb para ellos solos, con teclado y ratón de verdad; la ventana debe acabar igual que el golden (tolerancia amplia) y Esc, o cerrarla,
# debe terminar el programa con 0. Con «paseo», el último aguanta además sucesos al azar y cambios de tamaño bajo un gestor de ventanas.
# El reloj virtual y los menús no se pueden repetir aquí: de los casos que los usan se mira que dibuje algo.
# Con «windows», lo mismo con los ejecutables de Windows, bajo Wine.
set -euo pipefail
build=$1 modo=$2
shift 2
aqui=$(cd "$(dirname "$0")" && pwd)
source "$aqui/../ventana/pantalla.sh"
source "$aqui/../ventana/xdotool.sh"
lanza() { abre "$build/ventana/$1/$2" "${@:3}"; } # CAPÍTULO PROGRAMA [opciones]
if [ "$modo" = windows ]; then
  source "$aqui/../windows/wine.sh"
  lanza() { abre_en_wine "${@:2}"; }
  PAUSA=${PAUSA:-0.1} # Wine junta los movimientos del ratón que van más seguidos
fi

colores() { ppmhist -noheader "$1" 2>/dev/null | wc -l; }
dibuja_algo() {
  if [ "$(colores ventana.ppm)" -gt 1 ] || [ "$(colores "$golden")" = 1 ]; then echo "bien: dibuja algo"; else echo "la ventana es de un solo color"; fi
}
espera_dibujo() { # dos segundos como mucho; en Windows, lo que llega antes se atiende antes de saber el tamaño
  local i
  for ((i = 20; i > 0; --i)); do
    xwd -silent -id "$ventana" 2>/dev/null | xwdtopnm -quiet >ventana.ppm 2>/dev/null || true
    [ "$(colores ventana.ppm)" -le 1 ] || return 0
    sleep 0.1
  done
}
mira() {
  case $guion in
  *espera* | *menu*) dibuja_algo ;;
  *) "$build/herramientas/comparador/compara" "$golden" ventana.ppm "${opciones[@]}" "$@" 2>&1 || true ;;
  esac
}
pasea() { # PROGRAMA
  local sucesos
  setpriv --pdeathsig KILL twm -f /dev/null >/dev/null 2>&1 &
  sucesos=$(python3 -B "$aqui/../../herramientas" base.controles guion "$aqui/../.." "$build" "$1" 1 25)
  PAUSA=0.002 haz_guion 240x180 "tamano 300 200; $sucesos; tamano 200 240; $sucesos" # seguidos: no se mira qué hace cada uno
  while cp salida antes && sigue 0.2 && ! cmp -s antes salida; do :; done # hasta que los haya atendido
}
mal() { # MENSAJE: con lo que haya escrito el programa
  echo "$nombre: $1"
  cat errores
  exit 1
}

caso() { # CAPÍTULO PROGRAMA FICHERO TOLERANCIA GUION
  local capitulo=$1 programa=$2 tolerancia=$4 guion=$5 resultado='' estado=0 como i
  nombre=$3
  golden=$aqui/../golden/$capitulo/$nombre.ppm opciones=(--amplia)
  [ "$tolerancia" = - ] || opciones+=(--tolerancia "$tolerancia")
  [ -z "${raton:-}" ] || xdotool mousemove 1000 900 # lejos de la ventana
  lanza "$capitulo" "$programa" -geometry 240x180+10+10 >salida 2>errores || mal "no abre su ventana"
  [ "$modo" != windows ] || espera_dibujo
  [ "$guion" = - ] || haz_guion 240x180 "$guion"

  # La ventana tarda en dibujarse: se mira hasta que coincide, quince segundos como mucho.
  for ((i = ${PACIENCIA:-150}; i > 0; --i)); do
    xwd -silent -id "$ventana" 2>/dev/null | xwdtopnm -quiet >ventana.ppm 2>/dev/null || true
    resultado=$(mira)
    [ "${resultado%%:*}" = bien ] && break
    sigue 0.1 || break
  done
  echo "$nombre: $resultado"
  if [ "${resultado%%:*}" != bien ]; then
    mkdir -p "$build/fallos/ventana"
    mira --deja "$build/fallos/ventana/$nombre"
    exit 1
  fi
  [ "$paseo" != paseo ] || pasea "$programa"

  cp salida antes # lo escrito sale al escribirlo, no al terminar
  # El último caso, sin guion o con animación, se cierra con la X de su marco: un temporizador puede vencer cuando la ventana ya no está. Si no, Esc.
  case $guion$paseo in
  - | *espera* | *paseo | *windows) como='la X de la ventana' && "$build/tests/ventana" cierra "$ventana" ;;
  *) como=Esc && xdotool key Escape ;;
  esac
  ! sigue $((${PACIENCIA:-150} / 10)) || mal "$como no lo termina"
  wait "$pid" || estado=$?
  cmp antes salida || exit 1
  [ $estado = 0 ] && [ ! -s errores ] || mal "$como lo termina con estado $estado y ha escrito en stderr:"
}

carpeta=$(mktemp -d)
trap 'kill ${pid:-} 2>/dev/null || true; [ "$modo" != windows ] || cierra_wine; cierra_pantalla; rm -rf "$carpeta"' EXIT
cd "$carpeta"
abre_pantalla
[ "$modo" != windows ] || abre_wine "$carpeta"
paseo=-
while [ $# -gt 0 ]; do
  [ $# -gt 5 ] || paseo=$modo
  caso "${@:1:5}"
  shift 5
done
