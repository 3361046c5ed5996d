#!/usr/bin/env bash
# prueba.sh RAIZ BUILD PRUEBA [opción de node…]: PRUEBA.mjs, con sus bibliotecas de npm en BUILD/paginas, sobre
# llvmpipe y en una pantalla de Xvfb, que sin ninguna Firefox no tiene WebGL 2. Antes hace en una carpeta temporal lo
# que se abre.
# Una sola pregunta: prueba.sh . build web --test-name-pattern='a toda pantalla'.
set -euo pipefail
cd "$1"
build=$(realpath "$2") prueba=$3
carpeta=$(mktemp -d)
trap 'kill ${xvfb:-} 2>/dev/null || true; rm -rf "$carpeta"' EXIT
export NODE_PATH=/usr/share/nodejs TMPDIR=$carpeta
dice() { "$@" >"$carpeta/registro" 2>&1 || { cat "$carpeta/registro"; exit 1; }; }

# Las bibliotecas, las del package-lock.json: otra vez solo si ha cambiado.
bibliotecas() {
  cmp -s tests/paginas/package-lock.json "$build/paginas/puesto.json" && return
  mkdir -p "$build/paginas"
  cp tests/paginas/package*.json "$build/paginas"
  npm ci --prefix "$build/paginas" --ignore-scripts --no-audit --no-fund
  cp tests/paginas/package-lock.json "$build/paginas/puesto.json"
}
programas() {
  python3 -B herramientas web.taller "$build"
  cmake --preset web -B "$build/web" && cmake --build "$build/web" --target laboratorio taller
}

abre="$carpeta/página (1)"
exec 9>"$build/web.cerrojo"
flock 9
dice bibliotecas
[ "$prueba" = galeria ] || [ "$prueba" = clase ] || dice programas
exec 9>&-
case "$prueba" in
  galeria) dice python3 -B herramientas galeria.dibuja . "$build" "$abre" ;;
  clase) mkdir "$abre" ;;
  *) dice python3 -B herramientas web.pagina . "$build/web" "$carpeta/sin galería" "$abre" ;; # ni miniaturas
esac
exec 8< <(exec Xvfb -displayfd 1 -screen 0 1920x1200x24 -nolisten tcp 2>/dev/null)
xvfb=$!
read -r pantalla <&8
set -a
. "$build/entorno.txt"
DISPLAY=:$pantalla LIBGL_ALWAYS_SOFTWARE=1 node "${@:4}" "tests/paginas/$prueba.mjs" "$PWD" "$build" "$abre"
