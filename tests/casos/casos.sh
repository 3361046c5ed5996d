#!/usr/bin/env bash
# casos.sh BUILD ENLACE PROGRAMA [CASO]: prueba los casos de un programa, o solo ese, que el catálogo deja en
# BUILD/casos/PROGRAMA.sh. ENLACE dice cómo:
#   osmesa, egl       dibujado con ese destino sin ventana y comparado con su golden: la imagen; en un .txt, los títulos
#                     que pone y lo que escribe; y en un .encima, lo que pinta encima (common/encima/encima.h), que no
#                     está si no pinta nada
#   llvmpipe, softpipe, zink, swiftshader, virgl
#                     lo mismo, por EGL y con ese OpenGL de los paquetes de Debian, elegido como dicen sus manuales
#   encuadre          lo que enseña cabe entero en la ventana, ancha, a 4:3, casi cuadrada y alta: nada toca el borde,
#                     salvo por los lados que diga su BORDE, y por cada uno de esos, en alguna. Y por mucho que se aleje
#                     o se gire, sigue a la vista. De OSMesa, en ventanas de float: ningún color es NaN ni infinito
#                     (finitos.cpp)
#   pasos             lo que pinta encima tras cada línea de tests/golden/CAPÍTULO/PROGRAMA.pasos, que son órdenes de un
#                     guion y siguen a las de antes, es lo de PROGRAMA-pasos.encima. La ventana es de 480x360, o de lo
#                     que diga un «# talla ANCHOxALTO»
#   ventana, windows  en una ventana de verdad (ventana.sh)
# El programa debe acabar con 0 y no escribir nada en stderr. Las imágenes de lo que falla quedan en BUILD/fallos/. Con
# DORA, lo que sale pasa a ser el golden; con GOLDEN, en esa carpeta, que tiene los de antes. Estado: 0 bien, 4 si es
# distinto lo que pinta encima, aunque no sea lo único; 1 lo demás.
# shellcheck disable=SC1090,SC2317 # lo de caso lo llama BUILD/casos/PROGRAMA.sh
set -euo pipefail
build=$1 enlace=$2 programa=$3 pedido=${4:-} destino=$2 opengl='' estado=0 probados=0 con=()
aqui=$(cd "$(dirname "$0")" && pwd)
goldens=${GOLDEN:-$aqui/../golden} compara=$build/herramientas/comparador/compara
carpeta=$(mktemp -d)
source "$aqui/../ventana/pantalla.sh"
acaba() {
  kill ${pid:+"$pid"} ${servidor:+"$servidor"} 2>/dev/null || true
  [ "$enlace" != windows ] || cierra_wine
  cierra_pantalla
  rm -rf "$carpeta"
}
trap acaba EXIT
cd "$carpeta" # ni el laboratorio ni su build: la carpeta de trabajo no importa

mal() { # MENSAJE: con lo que haya escrito el programa
  echo "$fichero: $1"
  cat errores
  exit 1
}
dibuja() { # [opciones]
  local estado=0
  env "${con[@]}" "$build/$destino/$capitulo/$programa" "$@" >salida 2>errores </dev/null || estado=$?
  # a SwiftShader le falta glLogicOp, que aquí no usa nadie, y lo que pide zink para los uniforms en array (28), que
  # dibuja bien
  [ -z "$opengl" ] ||
    sed -i -e '/base Zink requirements: feats.features.logicOp/d' -e '/Unsupported capability 28$/d' errores
  [ $estado = 0 ] && [ ! -s errores ] || mal "ha acabado con estado $estado y ha escrito en stderr:"
}
hace_falta() { # GOLDEN…
  local falta
  for falta; do
    [ -e "$falta" ] || { echo "falta el golden $falta: mira la imagen y hazlo con ./lab dora $fichero"; exit 1; }
  done
}
compara_encima() { # GOLDEN LISTA
  "${PYTHON:-python3}" -BS "$aqui/compara_encima.py" ${DORA:+--escribe} "$1.encima" "$2" || estado=4
}

imagen() {
  local comparacion=(--deja "$build/fallos/$enlace/$fichero")
  con=(LAB_ENCIMA=lista)
  dibuja -geometry 240x180 -ppm "$fichero.ppm" -titulos - ${guion:+-guion "$guion"}
  if [ "${DORA:-}" ]; then # ./lab dora
    mkdir -p "${golden%/*}"
    cp "$fichero.ppm" "$golden.ppm"
    cp salida "$golden.txt"
    compara_encima "$golden" lista
    return
  fi
  hace_falta "$golden.ppm" "$golden.txt"
  mkdir -p "$build/fallos/$enlace"
  # Los golden son de OSMesa. EGL dibuja las filas al revés, lo que se interpola redondea de otra manera y la tinta de
  # un rótulo, que se mezcla, cambia un nivel en unos pocos píxeles: ninguno más. Donde se nota más, el caso da su
  # motivo y su tolerancia.
  if [ "$opengl" ]; then
    comparacion+=(--otro ${otro:+--tolerancia "$otro"})
  elif [ "$tolerancia" ]; then
    comparacion+=(--tolerancia "$tolerancia")
    [ "$destino" != egl ] || comparacion+=(--amplia)
  elif [ "$destino" = egl ]; then
    comparacion+=(--redondeo)
  fi
  "$compara" "$golden.ppm" "$fichero.ppm" "${comparacion[@]}" || estado=1
  # lo que cuenta en sus píxeles un programa que sale distinto también lo es, y lo que dice de ellos encima: queda el
  # texto
  if [ "$opengl" ] && [ "$otro" ]; then
    diff -u <(tr -d 0-9 <"$golden.txt") <(tr -d 0-9 <salida) || estado=1
  else
    diff -u "$golden.txt" salida || estado=1
    compara_encima "$golden" lista
  fi
}

encuadre() {
  local pulsa='boton IZQUIERDO abajo 240 180' suelta='boton IZQUIERDO arriba' talla capturas='' ordenes
  local tallas=(640x360 480x360 480x540 200x450)
  ordenes="captura tal_cual; $pulsa; arrastra 240 2180; $suelta 240 2180; captura desde_arriba
    $pulsa; arrastra 240 -3820; $suelta 240 -3820; captura desde_abajo
    tamano 32 24; rueda -1 9 9 ×40; tamano 240 180; captura alejada"
  for talla in "${tallas[@]}"; do
    case $guion in
    # adónde va el ratón depende de la talla
    escala*) dibuja -geometry "$talla" -ppm "$fichero-$talla.ppm" -guion "$guion" ;;
    *) capturas+="; tamano ${talla/x/ }; captura $fichero-$talla.ppm" ;;
    esac
  done
  dibuja -geometry 240x180 -ppm "última" -guion "$guion$capturas; tamano 240 180; $ordenes"
  "$build/tests/borde" ${borde:+--corta "${borde%%:*}"} "$fichero"*.ppm
  "$build/tests/borde" --queda alejada desde_arriba desde_abajo
}

pasos() {
  local fichero=$programa golden=$goldens/$capitulo/$programa talla
  con=(LAB_ENCIMA=lista)
  talla=$(sed -n 's/^# talla //p' "$golden.pasos")
  grep -v -e '^#' -e '^ *$' "$golden.pasos" >pasos
  awk '{ print $0 "\ncaptura " NR }' pasos >guion
  dibuja -geometry "${talla:-480x360}" -ppm "última" -guion @guion
  # cada lista, con el nombre de su paso; la última imagen es otra vez la del último
  awk -F '\t' -v OFS='\t' 'NR == FNR { paso[NR] = $0; next }
    /^imagen\t/ { if ($2 == "última") exit; $2 = paso[$2] } { print }' pasos lista >con_nombre
  [ "${DORA:-}" ] || hace_falta "$golden-pasos.encima"
  compara_encima "$golden-pasos" con_nombre
}

vulkan() { # MANIFIESTO…: OpenGL de zink sobre ese Vulkan
  local manifiesto
  for manifiesto; do [ ! -e "$manifiesto" ] || break; done
  # LIBGL_ALWAYS_SOFTWARE: sin ella zink no admite un Vulkan de CPU; NODEVICE_SELECT: que Mesa no busque una pantalla
  # para elegirlo
  export MESA_LOADER_DRIVER_OVERRIDE=zink LIBGL_ALWAYS_SOFTWARE=1 NODEVICE_SELECT=1 VK_ICD_FILENAMES=$manifiesto
}
elige_opengl() {
  opengl=$enlace destino=egl
  mkdir -p "$build/cache_shaders/$opengl"
  unset GALLIUM_DRIVER MESA_LOADER_DRIVER_OVERRIDE DISPLAY WAYLAND_DISPLAY
  export MESA_SHADER_CACHE_DIR=$build/cache_shaders/$opengl
  case $opengl in
  llvmpipe) export GALLIUM_DRIVER=llvmpipe ;; # el de los golden, sin el entorno fijado
  softpipe)
    export GALLIUM_DRIVER=softpipe
    # sin LLVM numera otra vez desde 0 (gl_VertexID) cada pocos miles de vértices, y a las partículas les hace falta
    [ "$programa" != particulas ] || export SOFTPIPE_DEBUG=use_llvm
    ;;
  zink) vulkan /usr/share/vulkan/icd.d/lvp_icd*.json ;; # sobre lavapipe
  swiftshader) vulkan /usr/lib/chromium/vk_swiftshader_icd.json ;;
  virgl) # su servidor dibuja con llvmpipe en un Xvfb; atiende siempre en /tmp/.virgl_test: de uno en uno
    abre_pantalla
    rm -f /tmp/.virgl_test
    # pide antes un 4.6 que los que hay, y Xlib lo mata si no se le dice que sí
    MESA_GL_VERSION_OVERRIDE=4.6 setpriv --pdeathsig KILL virgl_test_server --use-glx >/dev/null 2>&1 &
    servidor=$!
    for _ in $(seq 100); do [ ! -S /tmp/.virgl_test ] || break; sleep 0.05; done
    unset DISPLAY
    export GALLIUM_DRIVER=virpipe
    ;;
  *)
    echo "no conozco el OpenGL «$opengl»: llvmpipe, softpipe, zink, swiftshader o virgl"
    exit 1
    ;;
  esac
}

case $enlace in
osmesa | egl) prueba=imagen ;;
encuadre | pasos)
  prueba=$enlace destino=$(cat "$build/sin_ventana")
  [ "$prueba$destino" != encuadreosmesa ] || con=(LD_PRELOAD="$build/tests/libfinitos.so")
  ;;
ventana | windows) prueba=ventana && source "$aqui/ventana.sh" ;;
*) prueba=imagen && elige_opengl ;;
esac

caso() { # nombre=… fichero=… guion=… tolerancia=… otro=… borde=…
  local "$@" golden
  [[ $prueba != pasos && (-z $pedido || $nombre = "$pedido") ]] || return 0
  golden=$goldens/$capitulo/$fichero
  ((++probados))
  $prueba
}
source "$build/casos/$programa.sh"
if [ "$prueba" = pasos ]; then
  pasos
elif [ $probados = 0 ]; then
  echo "$programa no tiene ningún caso «$pedido»"
  exit 1
fi
exit $estado
