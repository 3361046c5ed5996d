#!/usr/bin/env bash
# mutaciones.sh BUILD: el comparador acepta la imagen repetida y rechaza, también con la tolerancia amplia,
# cada una de las estropeadas.
set -euo pipefail
build=$1 mutante=$1/tests/mutante fallos=0
carpeta=$(mktemp -d)
trap 'rm -rf "$carpeta"' EXIT
cd "$carpeta"
"$mutante" -ppm buena.ppm
for mutacion in nada luz textura pixel triangulo; do
  "$mutante" -ppm mala.ppm $mutacion
  for opcion in '' --amplia; do
    esperado=1
    [ $mutacion != nada ] || esperado=0
    estado=0
    resultado=$("$build/tests/compara" buena.ppm mala.ppm $opcion) || estado=$?
    printf '%-9s %-8s %s\n' $mutacion "$opcion" "${resultado%%; hecha*}"
    [ $estado = $esperado ] || { echo "el comparador ha salido con $estado y debía salir con $esperado"; fallos=1; }
  done
done
exit $fallos
