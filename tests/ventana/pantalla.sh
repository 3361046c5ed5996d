# Para incluir con `source`: un Xvfb para quien lo pide, que muere con él aunque lo maten (setpriv --pdeathsig).

abre_pantalla() { # [OPCIONES DE Xvfb]: deja su número en DISPLAY
  local fichero _
  fichero=$(mktemp)
  setpriv --pdeathsig KILL Xvfb -displayfd 3 -screen 0 1280x1024x24 -nolisten tcp -noreset "$@" 3>"$fichero" >/dev/null 2>"$fichero.log" &
  xvfb=$!
  for _ in $(seq 600); do
    [ -s "$fichero" ] && break
    kill -0 $xvfb 2>/dev/null || break
    sleep 0.05
  done
  DISPLAY=:$(cat "$fichero")
  [ "$DISPLAY" != : ] || { echo "Xvfb no arranca:"; cat "$fichero.log"; }
  rm -f "$fichero" "$fichero.log"
  export DISPLAY
  [ "$DISPLAY" != : ]
}

cierra_pantalla() {
  kill "${xvfb:-}" 2>/dev/null || true
  wait "${xvfb:-}" 2>/dev/null || true
}
