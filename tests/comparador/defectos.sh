#!/usr/bin/env bash
# defectos.sh BUILD: el comparador acepta lo que debe y rechaza lo demás. Primero, imágenes con una cosa estropeada al
# dibujar (escena_comparador); después, con unos píxeles cambiados (estropea), a uno y otro lado de cada límite.
set -euo pipefail
build=$1/tests compara=$1/herramientas/comparador/compara fallos=0
carpeta=$(mktemp -d)
trap 'rm -rf "$carpeta"' EXIT
cd "$carpeta"
"$build/escena_comparador" -geometry 240x180 -ppm buena.ppm

# espera NOMBRE ESTADO TEXTO [opciones]: compara buena.ppm con mala.ppm; el resultado debe llevar TEXTO
espera() {
  local nombre=$1 esperado=$2 texto=$3 estado=0 resultado
  shift 3
  resultado=$("$compara" buena.ppm mala.ppm "$@" 2>&1) || estado=$?
  printf '%-34s %-8s %s\n' "$nombre" "$*" "${resultado%%; hecha*}"
  [[ $estado = "$esperado" && $resultado = *"$texto"* ]] ||
    { echo "ha salido con $estado y debía salir con $esperado y decir «$texto»"; fallos=1; }
}

for defecto in nada luz textura pixel medio triangulo raya colores oscura; do
  "$build/escena_comparador" -geometry 240x180 -ppm mala.ppm $defecto
  esperado=1
  [ $defecto != nada ] || esperado=0
  for opcion in '' --amplia --otro; do espera $defecto $esperado '' $opcion; done
done

# Nombre, argumentos de estropea y los estados que deben dar el mismo OpenGL y otro. 43 píxeles son el 0.1 % de 240×180.
# En la esquina el fondo es liso, y los 3×3 de alrededor no disculpan nada.
while IFS='|' read -r nombre estropea igual otro; do
  read -ra estropea <<<"$estropea"
  "$build/estropea" buena.ppm mala.ppm "${estropea[@]}"
  niveles=${estropea[2]}
  espera "$nombre" "$igual" "máximo $niveles "
  espera "$nombre" "$otro" "máximo $niveles " --amplia
done <<'FIN'
un nivel en un píxel|0 1 1|1|0
todo a 3 niveles, rojo|0 43200 3|1|0
todo a 3 niveles, verde|1 43200 3|1|0
todo a 3 niveles, azul|2 43200 3|1|0
todo a 4 niveles, rojo|0 43200 4|1|1
todo a 4 niveles, verde|1 43200 4|1|1
todo a 4 niveles, azul|2 43200 4|1|1
el 0.1 % a 10 niveles|1 43 10|1|0
algo más del 0.1 % a 4 niveles|2 44 4|1|1
el 0.2 % a 10 niveles|0 86 10|1|1
un píxel a 32 niveles, azul|2 1 32|1|0
un píxel a 33 niveles, azul|2 1 33|1|1
un píxel enorme|1 1 120|1|1
FIN

# El mismo OpenGL, que redondea de otra manera: un nivel donde sea, y dos en ninguna parte.
"$build/estropea" buena.ppm mala.ppm 0 43200 1
espera 'todo a un nivel' 0 'a un nivel' --redondeo
"$build/estropea" buena.ppm mala.ppm 0 1 2
espera 'dos niveles en un píxel' 1 'a un nivel' --redondeo

# La tolerancia de un caso cambia los límites, y solo ella.
"$build/estropea" buena.ppm mala.ppm 1 86 10
espera 'el 0.2 %, con permiso' 0 '' --amplia --tolerancia '0.2 3 32'
espera 'el 0.2 %, con permiso' 1 '' --tolerancia '0.2 3 32' # es el mismo OpenGL: idénticas
espera 'el 0.2 %, con permiso' 1 '' --amplia --tolerancia '0.2 3 9'
for mal in '0.2 3' '0.2 3 32 1' '0,2 3 32' '0.2 3.5 32' '-1 3 32' 'nan 3 32' ''; do
  espera "tolerancia «$mal»" 2 'son PORCENTAJE NIVELES MAXIMO' --amplia --tolerancia "$mal"
done

# Otro OpenGL: lo que sobra o falta, a uno y otro lado de cada límite, y una mancha de 3×3, pero no de 2×3.
while IFS='|' read -r nombre estropea estado; do
  read -ra estropea <<<"$estropea"
  "$build/estropea" buena.ppm mala.ppm "${estropea[@]}"
  espera "$nombre" "$estado" 'otro OpenGL' --otro
done <<'FIN'
todo a 3 niveles|0 43200 3|0
el 1 % a 4 niveles|1 432 4|0
algo más del 1 % a 4 niveles|1 433 4|1
el 0.1 % a 33 niveles|2 43 33|0
algo más del 0.1 % a 33 niveles|2 44 33|1
FIN
for lado in 2 3; do
  ppmmake black 3 $lado >mancha.ppm
  pnmpaste mancha.ppm 5 5 buena.ppm >mala.ppm
  espera "una mancha de 3×$lado" $((lado - 2)) 'otro OpenGL' --otro
done
"$build/estropea" buena.ppm mala.ppm 2 86 60
espera 'el 0.2 % a 60 niveles, con permiso' 0 '' --otro --tolerancia '2 3 32'
espera 'el 0.2 % a 60 niveles, con permiso' 0 '' --otro --tolerancia '1 3 60'
espera 'el 0.2 % a 60 niveles, con permiso' 1 '' --otro --tolerancia '1 3 59'

# Sin sello no se sabe qué exigir. Una captura de una ventana de verdad no lo lleva, y se compara con --amplia.
"$build/estropea" buena.ppm mala.ppm 0 0 0 sin_sello
espera 'obtenida sin sello' 2 '«mala.ppm» no lleva el sello'
espera 'obtenida sin sello' 0 '' --amplia
mv buena.ppm otra.ppm && mv mala.ppm buena.ppm && mv otra.ppm mala.ppm
for opcion in '' --amplia; do espera 'golden sin sello' 2 '«buena.ppm» no lleva el sello' $opcion; done
exit $fallos
