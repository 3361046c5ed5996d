#!/usr/bin/env bash
# fuzz.sh LECTOR [opciones de libFuzzer]: busca con libFuzzer, ASan y UBSan entradas que rompan un lector (glsl, shader,
# imagen, malla o guion), a partir de semillas/LECTOR. Paquetes: clang, libclang-rt-dev. Por ejemplo,
# -runs=10000000. Lo que encuentra queda en build/fuzz/; una vez arreglado, la entrada se guarda entre las semillas.
set -euo pipefail
export LECTOR=$1
shift
cd "$(dirname "$0")/../.."
mkdir -p "build/fuzz/corpus_$LECTOR"
clang++ -std=c++17 -O2 -g -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=undefined -Icommon -I. \
  tests/fuzz/lectores.cpp common/{imagen,malla,shader}.cpp glut/sistema/{guarda,motivo,posix}.cpp \
  herramientas/explica/{apuntes,declaraciones,divisiones,expresiones,glsl,lexico,preludio,sentencias,tipos}.cpp \
  glut/sin_ventana/guion.cpp \
  -lGLEW -lGL -o build/fuzz/lectores
exec build/fuzz/lectores -artifact_prefix="build/fuzz/$LECTOR-" -max_len=4096 -timeout=10 "$@" \
  "build/fuzz/corpus_$LECTOR" "tests/fuzz/semillas/$LECTOR"
