#!/usr/bin/env bash
# web.sh RAIZ BUILD: compila los programas para el navegador, hace la página en una carpeta temporal y la prueba con
# comprueba_web.py, en Chromium, y con firefox.py; con LAB_OPENGL=swiftshader, solo los casos y solo en Chromium.
set -euo pipefail
cd "$1"
build=$2
carpeta=$(mktemp -d)
trap 'rm -rf "$carpeta"' EXIT
export NODE_PATH=/usr/share/nodejs
{ cmake --preset web -B "$build/web" && cmake --build "$build/web" --target laboratorio explica; } >"$carpeta/registro" 2>&1 ||
  { cat "$carpeta/registro"; exit 1; }
pagina="$carpeta/página (1)"
python3 -B herramientas web.pagina . "$build/web" "$carpeta/sin galería" "$pagina" # sin miniaturas, que aquí no hacen falta
python3 -B tests/paginas/comprueba_web.py . "$build" "$pagina"
[ "${LAB_OPENGL:-}" = swiftshader ] || python3 -B tests/paginas/firefox.py . "$build" "$pagina"
