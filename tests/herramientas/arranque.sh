#!/usr/bin/env bash
# arranque.sh BUILD [VUELTAS]: de arrancar a tener el PPM (240×180), cada programa frente al suelo (suelo_osmesa), en la
# misma tanda y alternados. Escribe una línea TSV por programa: programa, mediana ms, cociente con el suelo; al final,
# el suelo y la mediana de los cocientes.
set -euo pipefail
build=$1 vueltas=${2:-11}
carpeta=$(mktemp -d)
trap 'rm -rf "$carpeta"' EXIT
cd "$carpeta"

cronometra() { # ORDEN…: milisegundos
  local antes=$EPOCHREALTIME despues
  "$@" >/dev/null 2>&1
  despues=$EPOCHREALTIME
  awk -v a="${antes/,/.}" -v b="${despues/,/.}" 'BEGIN { printf "%.2f\n", (b - a) * 1000 }'
}

mapfile -t programas < <(awk -F'\t' '!visto[$2]++ { print $1 "/" $2 }' "$build/casos.tsv")
"$build/tests/suelo_osmesa" x.ppm # en caliente
for ((i = 0; i < vueltas; i++)); do
  cronometra "$build/tests/suelo_osmesa" x.ppm >>suelo
  for p in "${programas[@]}"; do
    [ $i -gt 0 ] || "$build/osmesa/$p" -geometry 240x180 -ppm x.ppm >/dev/null 2>&1
    cronometra "$build/osmesa/$p" -geometry 240x180 -ppm x.ppm >>"${p##*/}"
  done
done
mediana() { sort -n "$1" | awk '{ v[NR] = $1 } END { print v[int((NR + 1) / 2)] }'; }
suelo=$(mediana suelo)
for p in "${programas[@]}"; do
  m=$(mediana "${p##*/}")
  awk -v p="$p" -v m="$m" -v s="$suelo" 'BEGIN { printf "%s\t%.1f\t%.2f\n", p, m, m / s }'
done | tee cocientes
printf 'suelo_osmesa\t%.1f\t1.00\n' "$suelo"
cut -f3 cocientes >c
printf 'mediana de los programas\t\t%s\n' "$(mediana c)"
