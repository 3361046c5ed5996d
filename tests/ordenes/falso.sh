#!/usr/bin/env bash
# cmake, ninja, ctest, apt-get… y los programas, de mentira, según cómo se le llame: apunta con qué argumentos y, en la
# etapa $PARA, no acaba, ni un hijo suyo, o en la etapa $FALLA falla; con «programa a», solo el que se llama así. Con
# $AVISOS no compila mientras los avisos sean errores.
set -euo pipefail
ulimit -Sf unlimited # un disco lleno es cosa de ./lab
quien=${0##*/}
# Sin finales de línea, con que Bash escribiría en varias veces: pueden apuntar varios a la vez.
printf '%s\0' "$quien" "${@//$'\n'/$'\v'}" ${LAB_VIGILA:+vigilando} $'\f' >>"$APUNTES/llamadas"

etapa() { # ETAPA [CUÁL]
  if [ "${PARA:-}" = "$1" ]; then
    sleep 100 &
    echo $! >>"$APUNTES/nietos" # pueden ser varios a la vez
    wait
  fi
  if [ "${FALLA:-}" = "$1" ] || [ "${FALLA:-}" = "$1 ${2:-$quien}" ]; then
    printf 'error: falla %s %s\nmás\n' "$1" "${PORQUE:-}" >&2
    exit 3
  fi
}

valor() { # OPCIÓN ARGUMENTO…: lo que la sigue
  local opcion=$1
  shift
  while [ $# -gt 1 ]; do
    [ "$1" != "$opcion" ] || { echo "$2"; return; }
    shift
  done
}

configura() { # CARPETA OPCIÓN…
  mkdir -p "$1/assets" "$1/tests" "$1"/herramientas/{mide,comparador} "$1"/{osmesa,ventana}/ch01_{uno,intro}
  [[ "$*" != *AVISOS_SON_ERRORES=OFF* ]] || touch "$1/sin_avisos"
  echo "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" >"$1/CMakeCache.txt"
  cp catalogo.json herramientas/base/entorno.txt "$1"
  echo osmesa >"$1/sin_ventana"
  mkdir -p "$1/dll"
  for f in assets/t.rgb {lab,explica}.{js,wasm} dll/uno.dll ventana/ch01_uno/{a,b}.exe; do echo "$f" >"$1/$f"; done
  for f in {osmesa,ventana}/ch01_uno/{a,b} osmesa/ch01_intro/info_opengl \
    tests/ch01_test herramientas/{comparador/compara,mide/mide}; do
    ln -sf "$(command -v falso.sh)" "$1/$f"
  done
}

case $quien in
cmake)
  if [ "$1" = --build ]; then
    [ "$4" != build.ninja ] || exit 0
    [ -z "${AVISOS:-}" ] || [ -e "$2/sin_avisos" ] || { echo 'error: un aviso [-Werror]' && exit 1; }
    [ "${FALLA:-}" != compila ] || printf 'FAILED: a.o\nc++ -Werror -c a.cpp\nninja: error: falta algo\n'
    etapa compila
    printf '[1/2] Linking CXX executable osmesa/ch01_uno/a\nun aviso\nninja: nada\n'
  else
    etapa configura
    configura "$(valor -B "$@")" "$@"
  fi
  ;;
ninja) etapa compila ;;
ctest)
  if [[ "$*" = *--show-only* ]]; then
    echo '{"tests": [{"name": "uno", "command": ["x"]}, {"name": "dos", "command": ["y"]}]}'
    exit
  fi
  etapa ctest
  xml=$(valor --output-junit "$@")
  echo '<t><testcase name="uno" status="run"/><testcase name="dos" status="run"/></t>' >"$xml"
  [ -n "${MAL:-}" ] || exit 0
  fallos=${xml%/*}/fallos
  mkdir -p "$fallos/osmesa"
  for f in esperada obtenida diferencia; do printf 'P6 1 1 255\nabc' >"$fallos/osmesa/a-$f.ppm"; done
  /usr/bin/python3 - "$fallos/osmesa/a-*.ppm" >"$xml" <<'FIN'
import html, sys
print('<t><testcase name="uno" status="run"/><testcase name="imagen.osmesa.a" status="fail" time="0.5">',
      f'<system-out>DISTINTAS: &lt;b&gt;\nimágenes en {html.escape(sys.argv[1])}\n</system-out></testcase></t>')
FIN
  exit 8
  ;;
casos.sh)
  etapa caso "$3.${4:-}" && printf '%s|' "$DORA" "${GALLIUM_DRIVER}" "$@"
  [ -z "${GOLDEN:-}" ] || echo "de ahora" >"$GOLDEN/ch01_uno/$3.txt"
  ;;
gnuplot) printf '<svg>' && cat ;;
id) echo "${FALSO_ID:-0}" ;;
dpkg-query) printf '%s installed\n' g++ cmake ;;
apt-get)
  etapa red
  if [[ " $* " = *' source '* ]]; then
    etapa fuentes
    mkdir freeglut-3 glew-2
    echo de freeglut >freeglut-3/COPYING
    echo de glew >glew-2/LICENSE.txt
  fi
  [[ "$*" != *--print-uris* ]] || echo "'http://archivo/em.deb' em.deb 2500000 SHA256:0"
  [ "$1" != indextargets ] || echo "$APUNTES/${LISTA:-debian.sources}:1"
  for opcion; do [[ $opcion != Dir::Etc::SourceList=* ]] || cp "${opcion#*=}" "$APUNTES/usada"; done
  ;;
apt-cache) echo 'libglew-dev | 2 | http://archivo bookworm/main amd64 Packages' ;;
x86_64-w64-mingw32-g++-posix) echo "/${1#-print-file-name=}" ;;
x86_64-w64-mingw32-strip) echo aligerada >"$2" ;;
sudo | em++) ;;
mide)
  if [ "$1" = --lista ]; then
    printf 't\tT\tms por cosa\terror\ta\tporque sí\n'
  else
    etapa mide
    printf 'a\t-\t0.5\t-\t2 1 3\n' >"${*: -2:1}/t.tsv"
  fi
  ;;
ch01_test) if [ "$1" = --gtest_list_tests ]; then printf 'G.\n  Uno # x\n'; else etapa prueba; fi ;;
*)
  if [[ "$*" = *-rasgos* ]]; then etapa rasgos; else etapa programa; fi
  [ -z "${DISPLAY:-}" ] || { echo "${ESCRIBE:-}" >&2; exit "${ESTADO:-0}"; }
  [[ "$*" != *-rasgos* ]] || { printf 'ocio\n'; exit; }
  if ! echo "salida de $quien${LAB_RAIZ:+ con $LAB_RAIZ}" 2>/dev/null; then
    echo "$quien: no puedo escribir en la salida" >&2
    exit 1
  fi
  [[ "$*" != *-titulos* ]] || echo "título: la ventana de $quien"
  [[ "$*" != *-diario* ]] || printf '%s\n' $'diario\t' 'otra orden' $'diario\t' 'tras la orden' $'diario\t'
  [ "$quien" != a ] || [ -z "${LAB_LEIDOS:-}" ] || printf '%s\n' ch01_uno/a.vert assets/t.rgb >>"$LAB_LEIDOS"
  [ -z "${LAB_EXPLICA:-}" ] ||
    echo '{"talla": [1, 1], "ordenes": [], "sospechas": [], "programas": [], "pixeles": []}' >"$LAB_EXPLICA"
  ppm=$(valor -ppm "$@") talla=$(valor -geometry "$@")
  talla=${talla:-40x40}
  [ -n "$ppm" ] || exit 0
  ancho=$((${talla%x*} / 40)) alto=$((${talla#*x} / 40))
  for f in "$ppm" $(grep -oE '[0-9]+\.ppm' <<<"$*" || true); do # y lo que capture el guion
    { printf 'P6\n%d %d\n255\n' $ancho $alto; head -c $((3 * ancho * alto)) /dev/zero; } >"$f"
  done
  ;;
esac
