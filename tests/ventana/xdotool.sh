# Para incluir con `source`: un guion de glut_sin_ventana, hecho con xdotool sobre una ventana de verdad.
# Necesita DISPLAY y deja en $ventana el identificador X de la del programa lanzado.

# Espera a que el programa $1 (pid) tenga su ventana, y le da el teclado.
espera_ventana() {
  local _
  for _ in $(seq 600); do
    ventana=$(xdotool search --onlyvisible --name . 2>/dev/null | head -n 1) && [ -n "$ventana" ] && break
    kill -0 "$1" 2>/dev/null || return 1
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
  local orden palabras tecla
  local -A especial=([IZQUIERDA]=Left [DERECHA]=Right [ARRIBA]=Up [ABAJO]=Down [INICIO]=Home [FIN]=End
    [REPAG]=Prior [AVPAG]=Next [INSERTAR]=Insert)
  local -A nombre=([Esc]=Escape [Espacio]=space [Intro]=Return [Tab]=Tab [Retroceso]=BackSpace [Supr]=Delete
    [PuntoYComa]=semicolon [+]=plus [-]=minus [,]=comma [.]=period)
  local -A boton=([IZQUIERDO]=1 [CENTRAL]=2 [DERECHO]=3)
  while read -ra palabras; do
    [ ${#palabras[@]} -gt 0 ] || continue
    orden=${palabras[0]}
    case $orden in
    tecla)
      tecla=${palabras[1]}
      xdotool key "${nombre[$tecla]:-$tecla}"
      ;;
    especial)
      tecla=${palabras[1]}
      case $tecla in
      # por su código: en mapas de teclado recientes (xkb-data 2.48) xdotool cree que F1 se escribe con Alt, y la pulsa
      F[1-9] | F10) tecla=$((66 + ${tecla#F})) ;;
      F1[12]) tecla=$((84 + ${tecla#F})) ;;
      esac
      xdotool key "${especial[$tecla]:-$tecla}"
      ;;
    mueve | arrastra) lleva_raton "${palabras[1]}" "${palabras[2]}" ;;
    boton)
      lleva_raton "${palabras[3]}" "${palabras[4]}"
      if [ "${palabras[2]}" = abajo ]; then xdotool mousedown "${boton[${palabras[1]}]}"; else xdotool mouseup "${boton[${palabras[1]}]}"; fi
      ;;
    rueda)
      lleva_raton "${palabras[2]}" "${palabras[3]}"
      if [ "${palabras[1]}" = -1 ]; then xdotool click 5; else xdotool click 4; fi
      ;;
    tamano) xdotool windowsize "$ventana" "${palabras[1]}" "${palabras[2]}" ;;
    menu) if declare -F elige_en_menu >/dev/null; then elige_en_menu "${palabras[*]:1}"; fi ;;
    espera | captura) ;;
    *) echo "«$orden» no se puede hacer en una ventana" >&2; return 1 ;;
    esac
    sleep "${PAUSA:-0.02}"
  done < <(tr ';' '\n' <<<"$1")
}
