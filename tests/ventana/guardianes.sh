#!/usr/bin/env bash
# guardianes.sh BUILD SIN_VENTANA: casos.sh, en una ventana (sin ella, jueces_test.py), da por bueno lo bueno y falla
# con un golden que no es, un programa que acaba mal, que escribe en stderr, que no abre la ventana o que no atiende
# Esc. También prueba que una prueba de ventana interrumpida no deja su Xvfb.
set -euo pipefail
build=$1 sin_ventana=$2
aqui=$(cd "$(dirname "$0")" && pwd)
carpeta=$(mktemp -d)
trap 'rm -rf "$carpeta"' EXIT
cd "$carpeta"
fallos=0

# Un build y unas pruebas de mentira, con un solo programa de verdad detrás.
mkdir -p tests build/{tests,casos} build/ventana/cap tests/golden/cap
cp -r "$aqui" "$aqui/../casos" tests
ln -s "$build/herramientas" build
ln -s "$build/tests/guion" "$build/tests/ventana" build/tests
"$build/$sin_ventana/ch03_transformaciones/grua" -geometry 240x180 -ppm bien.ppm
"$build/$sin_ventana/ch03_transformaciones/grua" -geometry 240x180 -ppm otro.ppm -guion 'tecla d; tecla d; tecla d'

programa() { # CUERPO: el programa del caso es un script que lo ejecuta; en él, `grua` es el de verdad
  printf '#!/usr/bin/env bash\ngrua() { "%s" "$@"; }\n%s\n' "$build/ventana/ch03_transformaciones/grua" "$1" \
    >build/ventana/cap/grua
  chmod +x build/ventana/cap/grua
}
ventana() { # ESTADO QUÉ MENSAJE [FICHERO GUION]: si acaba así, y si lo explica
  local esperado=$1 que=$2 mensaje=$3 estado=0
  printf '%s\n' 'capitulo=cap' "caso nombre=base fichero=${4:-grua} guion='${5:-}' tolerancia='' otro='' borde=''" \
    >build/casos/grua.sh
  SIN_PASEO=1 tests/casos/casos.sh "$carpeta/build" ventana grua >salida 2>&1 || estado=$?
  [ $estado = "$esperado" ] && grep -q "$mensaje" salida && return
  echo "$que: acaba con $estado y debía acabar con $esperado diciendo «$mensaje»:"
  cat salida
  fallos=1
}

cp bien.ppm tests/golden/cap/grua.ppm
cp bien.ppm tests/golden/cap/grua-quieta.ppm
programa 'grua "$@"'
ventana 0 "todo bien" '^grua: bien'
ventana 0 "con espera" 'dibuja algo' grua-quieta 'espera 10'
programa 'grua "$@"; exit 3'
ventana 1 "acaba mal" 'estado 3'
programa 'grua "$@"; echo aviso >&2'
ventana 1 "escribe en stderr" 'estado 0 y ha escrito'
programa 'exit 0'
ventana 1 "no abre su ventana" 'no abre su ventana'
programa 'grua "$@"; exec sleep 60 >/dev/null 2>&1'
PACIENCIA=30 ventana 1 "no atiende Esc" 'no lo termina'
programa "exec '$build/ventana/ch01_intro/primer_programa' \"\$@\""
PACIENCIA=5 ventana 1 "de un solo color" 'un solo color' grua-quieta 'espera 10'
programa 'grua "$@"'
cp otro.ppm tests/golden/cap/grua.ppm
PACIENCIA=5 ventana 1 "golden que no es" 'píxeles a más de 3'

# Interrumpida sin remedio (KILL), ni el Xvfb ni el programa la sobreviven.
cp otro.ppm tests/golden/cap/grua.ppm
PACIENCIA=600 SIN_PASEO=1 tests/casos/casos.sh "$carpeta/build" ventana grua >/dev/null 2>&1 &
prueba=$!
hijos() { ps -o pid= --ppid "$1" | xargs; }
for _ in $(seq 100); do [ "$(hijos $prueba | wc -w)" -ge 2 ] && break; sleep 0.05; done
sleep 0.5
lista=$(hijos $prueba)
kill -KILL $prueba
{ wait $prueba; } 2>/dev/null || true
for _ in $(seq 100); do
  vivos=
  for p in $lista; do kill -0 "$p" 2>/dev/null && vivos+=" $p"; done
  [ -z "$vivos" ] && break
  sleep 0.05
done
[ -n "$lista" ] && [ -z "$vivos" ] || { echo "una prueba interrumpida deja procesos:$vivos"; fallos=1; }

exit $fallos
