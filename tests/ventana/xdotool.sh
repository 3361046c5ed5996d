# Para incluir con `source`: un guion de glut_sin_ventana, hecho con xdotool sobre una ventana de verdad.
# Necesita DISPLAY y $build.

# Lanza un programa y espera a que tenga su ventana, con el teclado: $pid y $ventana. De $vive no se lee nada: se acaba
# con él.
abre() { # PROGRAMA [opciones]
  { exec {vive}< <(exec "$@" 3>&1 >&4 4>&- </dev/null); } 4>&1
  # shellcheck disable=SC2034 # $pid es para quien llama
  pid=$! raton= # aún no se sabe dónde está
  ventana=$("$build/tests/ventana" espera <&"$vive")
}

# Espera esos segundos; falla si el programa acaba antes.
sigue() {
  local estado=0
  read -rt "$1" -u "$vive" || estado=$?
  [ $estado -gt 128 ]
}

# Lo que sigue deja en $pasos lo que hará un solo xdotool.

# Lleva el ratón a (x, y) de la ventana, si no está ya allí: XTEST avisaría de un movimiento que no lo es.
lleva_raton() {
  [ "${raton:-}" = "$1 $2" ] || pasos+=(mousemove --window "$ventana" "$1" "$2")
  raton="$1 $2"
}

# Tras cada una, lo que diga $pausa, que es de xdotool. Las de menú y las del reloj virtual se saltan.
haz_guion() { # TALLA GUION: la de la ventana al empezar, y sus órdenes
  local ordenes x y orden resto a b
  [ -v pausa ] || local pausa=(sleep "${PAUSA:-0.02}")
  local pasos=("${pausa[@]}") # lo que el programa pide al empezar (otra talla) llega antes
  local -A especial=([IZQUIERDA]=Left [DERECHA]=Right [ARRIBA]=Up [ABAJO]=Down [INICIO]=Home [FIN]=End
    [REPAG]=Prior [AVPAG]=Next [INSERTAR]=Insert)
  local -A nombre=([Esc]=Escape [Espacio]=space [Intro]=Return [Tab]=Tab [Retroceso]=BackSpace [Supr]=Delete
    [PuntoYComa]=semicolon [+]=plus [-]=minus [,]=comma [.]=period)
  local -A boton=([IZQUIERDO]=1 [CENTRAL]=2 [DERECHO]=3)
  ordenes=$("$build/tests/guion" "$1" "$2") || return
  while read -r x y orden resto; do
    read -r a b _ <<<"$resto"
    case $orden in
    tecla) pasos+=(key "${nombre[$a]:-$a}") ;;
    especial)
      case $a in
      # por su código: en mapas de teclado recientes (xkb-data 2.48) xdotool cree que F1 se escribe con Alt, y la pulsa
      F[1-9] | F10) a=$((66 + ${a#F})) ;;
      F1[12]) a=$((84 + ${a#F})) ;;
      esac
      pasos+=(key "${especial[$a]:-$a}")
      ;;
    mueve | arrastra) lleva_raton "$x" "$y" ;;
    boton)
      lleva_raton "$x" "$y"
      a=${boton[$a]:-$((a + 1))}
      if [ "$b" = abajo ]; then pasos+=(mousedown "$a"); else pasos+=(mouseup "$a"); fi
      ;;
    rueda)
      lleva_raton "$x" "$y"
      if [ "$a" = -1 ]; then pasos+=(click 5); else pasos+=(click 4); fi
      ;;
    tamano) pasos+=(windowsize "$ventana" "$a" "$b") ;;
    esac
    pasos+=("${pausa[@]}")
  done <<<"$ordenes"
  xdotool "${pasos[@]}"
}
