"""Con qué palabras se compila y se enlaza lo del laboratorio: lo dicen BUILD/compile_commands.json, que escribe
CMake, y ninja."""
import json
import os
import shlex
from pathlib import Path

from base.procesos import Fallo, ejecuta


def ordenes(build):
    """De cada fuente de C++, la orden que lo compila, que se ejecuta en BUILD; sin ccache, si lo lleva delante."""
    todas = {}
    for hecho in json.loads((build / "compile_commands.json").read_text()):
        palabras = shlex.split(hecho["command"])
        compilador = next(i for i, palabra in enumerate(palabras) if palabra.startswith("-")) - 1
        todas[Path(hecho["file"])] = palabras[compilador:]
    return todas


def compila(build, fuente):
    try:
        return ordenes(build)[fuente]
    except (OSError, KeyError):
        raise Fallo(f"{build} no sabe compilar {fuente}") from None


def enlaza(build, ejecutable):
    """La orden que lo enlaza, que se ejecuta en BUILD."""
    dice = ejecuta(["ninja", "-C", build, "-t", "commands", "-s", os.path.relpath(ejecutable, build)], text=True)
    return [palabra for palabra in shlex.split(dice) if palabra not in (":", "&&")]
