#!/usr/bin/env bash
# otro.sh BUILD OPENGL OTRO CAPÍTULO PROGRAMA FICHERO TOLERANCIA GUION: el caso, por EGL y dibujado con ese OpenGL de los paquetes de
# Debian, elegido como dicen sus manuales; el comparador lo mira con --otro y la tolerancia OTRO.
set -euo pipefail
build=$1 opengl=$2 otro=$3 programa=$5
shift 3
aqui=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$build/cache_shaders/$opengl"
unset GALLIUM_DRIVER MESA_LOADER_DRIVER_OVERRIDE DISPLAY WAYLAND_DISPLAY
export OTRO=$opengl MESA_SHADER_CACHE_DIR=$build/cache_shaders/$opengl

vulkan() { # MANIFIESTO…: OpenGL de zink sobre ese Vulkan
  local manifiesto
  for manifiesto; do [ ! -e "$manifiesto" ] || break; done
  # LIBGL_ALWAYS_SOFTWARE: sin ella zink no admite un Vulkan de CPU; NODEVICE_SELECT: que Mesa no busque una pantalla para elegirlo
  export MESA_LOADER_DRIVER_OVERRIDE=zink LIBGL_ALWAYS_SOFTWARE=1 NODEVICE_SELECT=1 VK_ICD_FILENAMES=$manifiesto
}

case $opengl in
llvmpipe) export GALLIUM_DRIVER=llvmpipe ;; # el de los golden, sin el entorno fijado
softpipe)
  export GALLIUM_DRIVER=softpipe
  # sin LLVM numera otra vez desde 0 (gl_VertexID) cada pocos miles de vértices, y a las partículas les hace falta
  [ "$programa" != particulas ] || export SOFTPIPE_DEBUG=use_llvm
  ;;
zink) vulkan /usr/share/vulkan/icd.d/lvp_icd*.json ;; # sobre lavapipe
swiftshader) vulkan /usr/lib/chromium/vk_swiftshader_icd.json ;;
virgl) # su servidor dibuja con llvmpipe en un Xvfb; atiende siempre en /tmp/.virgl_test: de uno en uno
  source "$aqui/../ventana/pantalla.sh"
  trap 'kill ${servidor:-} 2>/dev/null || true; cierra_pantalla' EXIT
  abre_pantalla
  rm -f /tmp/.virgl_test
  # pide antes un 4.6 que los que hay, y Xlib lo mata si no se le dice que sí
  MESA_GL_VERSION_OVERRIDE=4.6 setpriv --pdeathsig KILL virgl_test_server --use-glx >/dev/null 2>&1 &
  servidor=$!
  for _ in $(seq 100); do [ ! -S /tmp/.virgl_test ] || break; sleep 0.05; done
  unset DISPLAY
  export GALLIUM_DRIVER=virpipe
  ;;
*)
  echo "LAB_OPENGL: no conozco «$opengl»; llvmpipe, softpipe, zink, swiftshader o virgl"
  exit 1
  ;;
esac
"$aqui/caso.sh" "$build" egl "$1" "$2" "$3" "$otro" "$5"
