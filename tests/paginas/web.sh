#!/usr/bin/env bash
# web.sh RAIZ BUILD [PARTE]: compila los programas para el navegador, hace la página en una carpeta temporal y la
# prueba con comprueba_web.py, en Chromium, y con firefox.py; con LAB_OPENGL=swiftshader, solo los casos y solo en
# Chromium; con una parte de comprueba_web.py, solo esa.
set -euo pipefail
cd "$1"
build=$2
carpeta=$(mktemp -d)
trap 'rm -rf "$carpeta"' EXIT
export NODE_PATH=/usr/share/nodejs
compila() { cmake --preset web -B "$build/web" && cmake --build "$build/web" --target laboratorio explica; }
{ flock 9 && compila; } >"$carpeta/registro" 2>&1 9>"$build/web.cerrojo" || { cat "$carpeta/registro"; exit 1; }
pagina="$carpeta/página (1)"
# sin miniaturas, que aquí no hacen falta
python3 -B herramientas web.pagina . "$build/web" "$carpeta/sin galería" "$pagina"
python3 -B tests/paginas/comprueba_web.py . "$build" "$pagina" "${@:3}"
[ "${LAB_OPENGL:-}" = swiftshader ] || [ $# -gt 2 ] || python3 -B tests/paginas/firefox.py . "$build" "$pagina"
