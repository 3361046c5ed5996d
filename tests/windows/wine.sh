# Para incluir con `source`: los programas de Windows tal como salen del zip, que prepara.sh ha descomprimido, bajo
# Wine. Necesita $build y DISPLAY. Cada uno tiene su servidor de Wine y su registro, y así varias pruebas van a la vez;
# el disco C:, de 700 MB, es el mismo para todas.
laboratorio="$build/windows/prueba/Prácticas de la señora Núñez (1)"
export WINEPREFIX='' WINEDEBUG=-all WINEDLLOVERRIDES='mscoree,mshtml,winemenubuilder.exe=' LC_ALL=C.UTF-8
# La memoria que entorno.txt pide de una vez cae a veces donde Wine necesita la suya, y entonces no arranca.
unset GLIBC_TUNABLES
wine=$(command -v wine64 /usr/lib/wine/wine64 wine)
wine=${wine%%$'\n'*}
servidor_wine=$(dirname "$(readlink -f "$wine")")/wineserver

abre_wine() { # CARPETA en que dejar lo suyo
  local molde=$build/windows/prueba/wine
  WINEPREFIX=$1/wine
  mkdir "$WINEPREFIX"
  cp -a "$molde"/*.reg "$molde/dosdevices" "$molde/.update-timestamp" "$WINEPREFIX"
  ln -s "$molde/drive_c" "$WINEPREFIX"
  # Sin un gestor de ventanas que las active, como openbox, la del menú de FreeGLUT se queda con las teclas.
  abre_gestor openbox
  # lo que digan los servicios de Wine no es del programa; en su registro, por si no arrancan
  "$wine" wineboot </dev/null >"$1/wineboot" 2>&1 || { echo "Wine no arranca: $(cat "$1/wineboot")"; return 1; }
  # Sin ningún programa su servidor se va enseguida, y uno que empiece entonces no arranca: este espera a que acabe la
  # prueba, aunque la maten.
  # shellcheck disable=SC2034 # se cierra al acabar
  exec {vive_wine}> >(exec "$wine" cmd >/dev/null 2>&1)
}

cierra_wine() {
  [ -z "$WINEPREFIX" ] || "$servidor_wine" -k >/dev/null 2>&1 || true
}

# FreeGLUT toma de DISPLAY, que es de X, el nombre de la pantalla, y avisa de que no existe; la de Windows se llama así.
ejecuta_en_wine() { # PROGRAMA [opciones]
  exec "$wine" "$build/windows/prueba/ejecuta.exe" aqui -- "$laboratorio/programas/$1.exe" -display DISPLAY "${@:2}"
}

# Como abre y sigue, de xdotool.sh: la ventana es la de su clase, y no una de Wine, en cuanto tiene el teclado.
# shellcheck disable=SC2034 # deja $pid, $raton y $ventana
abre_en_wine() { # PROGRAMA [opciones]
  while "$build/tests/ventana" activa "$1.exe" >/dev/null; do sleep 0.05; done # la de otra vez, que aún no se ha ido
  ejecuta_en_wine "$@" </dev/null &
  pid=$! raton=
  until ventana=$("$build/tests/ventana" activa "$1.exe"); do
    kill -0 "$pid" 2>/dev/null || return 1
    sleep 0.05
  done
}
sigue() { ! timeout "$1" tail --pid="$pid" -s 0.05 -f /dev/null; }
