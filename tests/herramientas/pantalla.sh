#!/usr/bin/env bash
# pantalla.sh abre|cierra CARPETA: un Xvfb para las pruebas de ventana; CARPETA/pantalla guarda su número.
set -euo pipefail
mkdir -p "$2"
case $1 in
abre)
  rm -f "$2/pantalla"
  Xvfb -displayfd 3 -screen 0 1280x1024x24 -nolisten tcp -noreset 3>"$2/pantalla" >"$2/xvfb.log" 2>&1 &
  echo $! >"$2/xvfb.pid"
  disown
  for _ in $(seq 100); do
    [ -s "$2/pantalla" ] && exit 0
    sleep 0.1
  done
  echo "Xvfb no arranca:"
  cat "$2/xvfb.log"
  exit 1
  ;;
cierra)
  kill "$(cat "$2/xvfb.pid")" 2>/dev/null || true
  rm -f "$2/pantalla" "$2/xvfb.pid"
  ;;
esac
