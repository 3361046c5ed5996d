# Para incluir con `source` en casos.sh: casos en una ventana de FreeGLUT, uno detrás de otro en un Xvfb, el suyo o
# el de su capítulo (ventana/capitulo.sh), con teclado y ratón de verdad; la ventana debe acabar igual que el golden
# (tolerancia amplia) y Esc, o cerrarla, debe terminar el programa con 0. El último aguanta además sucesos al azar y
# cambios de tamaño bajo un gestor de ventanas, salvo con SIN_PASEO. El reloj virtual y los menús no se pueden repetir
# aquí: de los casos que los usan se mira que dibuje algo. ENLACE windows es lo mismo, sin paseo, con los ejecutables
# de Windows, bajo Wine.
source "$aqui/../ventana/xdotool.sh"
lanza() { abre "$build/ventana/$capitulo/$programa" "$@"; } # [opciones]
abre_pantalla
if [ "$enlace" = windows ]; then
  source "$aqui/../windows/wine.sh"
  PACIENCIA=${PACIENCIA:-600}
  lanza() {
    abre_en_wine "$programa" "$@" || return
    # Wine junta los movimientos del ratón que aún no se han atendido
    # shellcheck disable=SC2034 # es para haz_guion
    pausa=(exec --sync --args 3 "$build/tests/ventana" atiende "$ventana")
    espera_dibujo
  }
  abre_wine "$carpeta"
fi
quedan=$(grep -c '^caso ' "$build/casos/$programa.sh")

colores() { ppmhist -noheader "$1" 2>/dev/null | wc -l; }
dibuja_algo() {
  if [ "$(colores ventana.ppm)" -gt 1 ] || [ "$(colores "$golden.ppm")" = 1 ]; then
    echo "bien: dibuja algo"
  else
    echo "la ventana es de un solo color"
  fi
}
captura() { xwd -silent -id "$ventana" 2>/dev/null | xwdtopnm -quiet >ventana.ppm 2>/dev/null || true; }
espera_dibujo() { # en Windows, lo que llega antes se atiende antes de saber el tamaño
  local i
  for ((i = PACIENCIA; i > 0; --i)); do
    captura
    [ "$(colores ventana.ppm)" -le 1 ] && [ "$(colores "$golden.ppm")" -gt 1 ] || return 0
    sigue 0.1 || return
  done
}
mira() { # [opciones del comparador]
  case $guion in
  *espera* | *menu*) dibuja_algo ;;
  *)
    "$build/herramientas/comparador/compara" "$golden.ppm" ventana.ppm \
      --amplia ${tolerancia:+--tolerancia "$tolerancia"} "$@" 2>&1 || true
    ;;
  esac
}
pasea() {
  local sucesos
  abre_gestor twm -f /dev/null || mal 'no hay con qué pasear'
  local raiz=$aqui/../..
  sucesos=$("${PYTHON:-python3}" -B "$raiz/herramientas" base.controles guion "$raiz" "$build" "$programa" 1 25)
  # seguidos: no se mira qué hace cada uno
  PAUSA=0.002 haz_guion 240x180 "tamano 300 200; $sucesos; tamano 200 240; $sucesos"
  while cp salida antes && sigue 0.2 && ! cmp -s antes salida; do :; done # hasta que los haya atendido
}

ventana() {
  local resultado='' estado=0 como cierra='' i
  [ $((--quedan)) != 0 ] || cierra=la
  # de los de en medio, los que solo pulsan letras no dicen nada que no digan el primero y el último
  [[ $probados = 1 || $cierra || $guion =~ boton|rueda|especial|mueve|tamano ]] || return 0
  xdotool mousemove 1000 900 # lejos de la ventana
  lanza -geometry 240x180+10+10 >salida 2>errores || mal "no abre su ventana"
  [ -z "$guion" ] || haz_guion 240x180 "$guion"

  # La ventana tarda en dibujarse: se mira hasta que coincide, PACIENCIA décimas de segundo como mucho.
  for ((i = ${PACIENCIA:-150}; i > 0; --i)); do
    captura
    resultado=$(mira)
    [ "${resultado%%:*}" = bien ] && break
    sigue 0.1 || break
  done
  echo "$fichero: $resultado"
  if [ "${resultado%%:*}" != bien ]; then
    mkdir -p "$build/fallos/ventana"
    mira --deja "$build/fallos/ventana/$fichero"
    exit 1
  fi
  [ "$cierra$enlace${SIN_PASEO:-}" != laventana ] || pasea

  cp salida antes # lo escrito sale al escribirlo, no al terminar
  # El último caso, sin guion o con animación, se cierra con la X de su marco: un temporizador puede vencer cuando la
  # ventana ya no está. Si no, Esc.
  case $guion:$cierra in
  : | *espera* | *:la) como='la X de la ventana' && "$build/tests/ventana" cierra "$ventana" ;;
  *) como=Esc && xdotool key Escape ;;
  esac
  ! sigue $((${PACIENCIA:-150} / 10)) || mal "$como no lo termina"
  wait "$pid" || estado=$?
  cmp antes salida || exit 1
  [ $estado = 0 ] && [ ! -s errores ] || mal "$como lo termina con estado $estado y ha escrito en stderr:"
}
