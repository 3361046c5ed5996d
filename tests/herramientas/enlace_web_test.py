"""El enlace web (herramientas/cmake/web.cmake) con compiladores de mentira: lo que se les pide, en una carpeta con
mal nombre."""
import shutil
import subprocess
from pathlib import Path

import pytest

from mentira import RAIZ, ejecutable

FALSO = """printf '%s\\0' "${0##*/}" "$@" '
' >>"$APUNTES"
while [ $# -gt 1 ]; do
  case $1 in -o | -MF | qc) : >"$2" ;; esac
  shift
done"""


# el punto y coma separa las listas de CMake
@pytest.mark.parametrize("nombre,vale", [("a'b $(touch pwned) & c", True), ("x';touch pwned;'y", False)])
def test_ninguna_orden_ejecuta_lo_que_dice_la_carpeta(tmp_path, nombre, vale):
    lab, bin, apuntes = tmp_path / nombre, tmp_path / "bin", tmp_path / "apuntes"
    bin.mkdir()
    for quien in ("em++", "opt", "emar"):
        ejecutable(bin / quien, FALSO)
    for carpeta in ("herramientas", "common", "glut", "ch01_intro"):
        shutil.copytree(RAIZ / carpeta, lab / carpeta, ignore=shutil.ignore_patterns("__pycache__", "mide"))
    shutil.copy(RAIZ / "CMakeLists.txt", lab)
    build, entorno = lab / "build", {"PATH": f"{bin}:/usr/bin:/bin", "APUNTES": str(apuntes)}
    opciones = f"""-DEMSCRIPTEN=1 -DCMAKE_CXX_COMPILER={bin}/em++ -DCMAKE_CXX_COMPILER_FORCED=1 -DOPT={bin}/opt
        -DCMAKE_CXX_COMPILER_ID=Clang -DCMAKE_CXX_COMPILER_VERSION=14.0 -DCMAKE_AR={bin}/emar -DCMAKE_RANLIB=true
        -DCMAKE_CXX_STANDARD_COMPUTED_DEFAULT=17"""
    como = {"env": entorno, "text": True, "capture_output": True}
    proceso = subprocess.run(["cmake", "-G", "Ninja", "-S", lab, "-B", build, *opciones.split()], **como)
    if not proceso.returncode:
        proceso = subprocess.run(["ninja", "-j1", "-C", build, "laboratorio"], **como)
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
