# Para incluir con `source`: un guion de glut_sin_ventana, hecho con xdotool sobre una ventana de verdad.
# Necesita DISPLAY y $build, y deja en $ventana el identificador X de la del programa lanzado.

# Espera a que el programa $1 (pid) tenga su ventana, y le da el teclado. Lo que siga dice cuál es, a xdotool search.
espera_ventana() {
  local pid=$1
  shift
  [ $# -gt 0 ] || set -- --name .
  local _
  raton= # aún no se sabe dónde está
  for _ in $(seq 600); do
    ventana=$(xdotool search --onlyvisible "$@" 2>/dev/null | head -n 1) && [ -n "$ventana" ] && break
    kill -0 "$pid" 2>/dev/null || return 1
    sleep 0.05
  done
  [ -n "$ventana" ] && xdotool windowfocus --sync "$ventana"
}

# Lleva el ratón a (x, y) de la ventana, si no está ya allí: XTEST avisaría de un movimiento que no lo es.
lleva_raton() {
  [ "${raton:-}" = "$1 $2" ] || xdotool mousemove --window "$ventana" "$1" "$2"
  raton="$1 $2"
}

# Hace las órdenes del guion $1. Las de menú, con elige_en_menu, si quien llama la tiene. Las que no tienen sentido fuera
# del reloj virtual se saltan.
haz_guion() {
  local ordenes x y orden resto a b WIDTH HEIGHT
  local -A especial=([IZQUIERDA]=Left [DERECHA]=Right [ARRIBA]=Up [ABAJO]=Down [INICIO]=Home [FIN]=End
    [REPAG]=Prior [AVPAG]=Next [INSERTAR]=Insert)
  local -A nombre=([Esc]=Escape [Espacio]=space [Intro]=Return [Tab]=Tab [Retroceso]=BackSpace [Supr]=Delete
    [PuntoYComa]=semicolon [+]=plus [-]=minus [,]=comma [.]=period)
  local -A boton=([IZQUIERDO]=1 [CENTRAL]=2 [DERECHO]=3)
  eval "$(xdotool getwindowgeometry --shell "$ventana" | grep -E '^(WIDTH|HEIGHT)=')"
  ordenes=$("$build/tests/guion" "${WIDTH}x$HEIGHT" "$1") || return
  while read -r x y orden resto; do
    read -r a b _ <<<"$resto"
    case $orden in
    tecla) xdotool key "${nombre[$a]:-$a}" ;;
    especial)
      case $a in
      # por su código: en mapas de teclado recientes (xkb-data 2.48) xdotool cree que F1 se escribe con Alt, y la pulsa
      F[1-9] | F10) a=$((66 + ${a#F})) ;;
      F1[12]) a=$((84 + ${a#F})) ;;
      esac
      xdotool key "${especial[$a]:-$a}"
      ;;
    mueve | arrastra) lleva_raton "$x" "$y" ;;
    boton)
      lleva_raton "$x" "$y"
      if [ "$b" = abajo ]; then xdotool mousedown "${boton[$a]}"; else xdotool mouseup "${boton[$a]}"; fi
      ;;
    rueda)
      lleva_raton "$x" "$y"
      if [ "$a" = -1 ]; then xdotool click 5; else xdotool click 4; fi
      ;;
    tamano) xdotool windowsize "$ventana" "$a" "$b" ;;
    menu) if declare -F elige_en_menu >/dev/null; then elige_en_menu "$resto"; fi ;;
    esac
    sleep "${PAUSA:-0.02}"
  done <<<"$ordenes"
}
