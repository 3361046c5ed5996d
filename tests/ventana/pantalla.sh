# Para incluir con `source`: un Xvfb para quien lo pide, que muere con él aunque lo maten (setpriv --pdeathsig).

abre_pantalla() { # [OPCIONES DE Xvfb]: deja su número en DISPLAY, si no está ya con PANTALLA_ABIERTA
  local numero
  [ -z "${PANTALLA_ABIERTA:-}" ] || return 0
  exec {lista}< <(
    exec setpriv --pdeathsig KILL \
      Xvfb -displayfd 3 -screen 0 1280x1024x24 -nolisten tcp -noreset "$@" 3>&1 >/dev/null
  )
  xvfb=$!
  read -rt 30 -u "$lista" numero || { echo "Xvfb no arranca"; return 1; }
  export DISPLAY=:$numero
}

cierra_pantalla() {
  kill "${xvfb:-}" 2>/dev/null || true
  wait "${xvfb:-}" 2>/dev/null || true
}

# Un gestor de ventanas: vuelve cuando ya manda en ellas, que es cuando otro no podría.
abre_gestor() { # ORDEN…
  local registro
  registro=$(mktemp)
  LC_ALL=C setpriv --pdeathsig KILL "$@" >"$registro" 2>&1 & # en C, que twm no arranca sin las letras de otros
  gestor=$!
  until "${build:?}/tests/ventana" gobernada; do
    kill -0 $gestor 2>/dev/null || { echo "$1 no arranca: $(cat "$registro")"; rm "$registro"; return 1; }
    sleep 0.05
  done
  rm "$registro"
}
