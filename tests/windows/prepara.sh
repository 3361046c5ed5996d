#!/usr/bin/env bash
# prepara.sh RAIZ BUILD: el zip de Windows, descomprimido como lo haría un alumno, en una carpeta con espacios y eñes, y
# un disco C: de Wine. Mira lo que hay en el zip.
set -euo pipefail
raiz=$1 build=$2 prueba=$2/windows/prueba
fallos=0
mal() { echo "$*"; fallos=1; }

rm -rf "$prueba"
mkdir -p "$prueba/wine"
aqui=$(cd "$(dirname "$0")" && pwd)
source "$aqui/wine.sh"
# sin miniaturas, que aquí no hacen falta
python3 -B "$raiz/herramientas" windows.paquete "$raiz" "$build" "$prueba/sin galería" "$prueba"
[ "$(stat -c %s "$prueba/laboratorio-windows.zip")" -lt 20000000 ] || mal 'el zip pasa de 20 MB'
python3 -m zipfile -e "$prueba/laboratorio-windows.zip" "$prueba"
mv "$prueba/laboratorio" "$laboratorio"
cd "$laboratorio"
diff <(find "$raiz"/ch* -name '*.cpp' -printf '%f\n' | sed 's/cpp$/exe/' | sort) \
  <(find programas -name '*.exe' -printf '%f\n' | sort) ||
  mal 'no están todos los programas'

# lo que no es de Windows va en el zip
while read -r dll; do
  [ -e "programas/$dll" ] || [[ ${dll,,} =~ ^(advapi32|gdi32|kernel32|msvcrt|opengl32|user32|winmm)\.dll$ ]] ||
    mal "falta $dll"
done < <(x86_64-w64-mingw32-objdump -p programas/*.exe programas/*.dll | sed -n 's/.*DLL Name: //p' | sort -u)

x86_64-w64-mingw32-g++-posix -std=c++17 -O1 -static "$aqui/ejecuta.cpp" -o "$prueba/ejecuta.exe"

WINEPREFIX=$prueba/wine WINEARCH=win64 DISPLAY='' "$wine" wineboot -i </dev/null >"$prueba/wine.log" 2>&1
WINEPREFIX=$prueba/wine "$servidor_wine" -w
[ -s "$prueba/wine/user.reg" ] || { mal 'Wine no prepara su disco C:'; cat "$prueba/wine.log"; }
exit $fallos
