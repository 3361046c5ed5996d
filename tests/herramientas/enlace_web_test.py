"""El enlace web (herramientas/cmake/web.cmake) con compiladores de mentira: lo que se les pide, en una carpeta con
mal nombre."""
import shutil
import subprocess
from pathlib import Path

import pytest

RAIZ = Path(__file__).parents[2]
FALSO = """#!/bin/sh
printf '%s\\0' "${0##*/}" "$@" '
' >>"$APUNTES"
while [ $# -gt 1 ]; do
  case $1 in -o | -MF | qc) : >"$2" ;; esac
  shift
done
"""


@pytest.mark.parametrize(
    "nombre,vale", [("a'b $(touch pwned) & c", True), ("x';touch pwned;'y", False)]
)  # ; separa las listas de CMake
def test_ninguna_orden_ejecuta_lo_que_dice_la_carpeta(tmp_path, nombre, vale):
    lab, bin, apuntes = tmp_path / nombre, tmp_path / "bin", tmp_path / "apuntes"
    bin.mkdir()
    for quien in ("em++", "opt", "emar"):
        (bin / quien).write_text(FALSO)
        (bin / quien).chmod(0o755)
    for carpeta in ("herramientas", "common", "ch01_intro"):
        shutil.copytree(RAIZ / carpeta, lab / carpeta, ignore=shutil.ignore_patterns("__pycache__", "mide"))
    shutil.copy(RAIZ / "CMakeLists.txt", lab)
    build, entorno = lab / "build", {"PATH": f"{bin}:/usr/bin:/bin", "APUNTES": str(apuntes)}
    opciones = {
        "EMSCRIPTEN": 1,
        "CMAKE_CXX_COMPILER": bin / "em++",
        "CMAKE_CXX_COMPILER_FORCED": 1,
        "CMAKE_CXX_COMPILER_ID": "Clang",
        "OPT": bin / "opt",
        "CMAKE_CXX_COMPILER_VERSION": "14.0",
        "CMAKE_AR": bin / "emar",
        "CMAKE_RANLIB": "true",
        "CMAKE_CXX_STANDARD_COMPUTED_DEFAULT": 17,
    }
    proceso = subprocess.run(
        ["cmake", "-G", "Ninja", "-S", lab, "-B", build, *(f"-D{o}={v}" for o, v in opciones.items())],
        env=entorno,
        text=True,
        capture_output=True,
    )
    if not proceso.returncode:
        proceso = subprocess.run(
            ["ninja", "-j1", "-C", build, "laboratorio"], env=entorno, text=True, capture_output=True
        )
    assert not list(tmp_path.rglob("pwned")) and not Path("pwned").exists()
    if not vale:
        return
    assert proceso.returncode == 0, proceso.stdout[-2000:] + proceso.stderr
    llamadas = [ll.split("\0")[:-1] for ll in apuntes.read_text().split("\n\0")[:-1]]
    fuentes = {Path(ll[-1]) for ll in llamadas if ll[0] == "em++" and "-emit-llvm" in ll}
    assert fuentes == set((lab / "ch01_intro").glob("*.cpp"))
    mains = {f"-internalize-public-api-list=_Z{len('main_' + f.stem)}main_{f.stem}iPPc" for f in fuentes}
    assert {ll[2] for ll in llamadas if ll[0] == "opt"} == mains
    [enlace] = [ll for ll in llamadas if ll[0] == "em++" and "-sMODULARIZE=1" in ll]
    assert {a for a in enlace if a.endswith(".o")} >= {f"objetos/{f.stem}.o" for f in fuentes}
