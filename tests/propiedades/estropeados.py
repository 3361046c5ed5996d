"""Lo que se cumple cuando se estropean los shaders mientras se mira."""
import os
import shutil
import subprocess
import tempfile
from pathlib import Path

from programa import APARTE, TALLA


def estropeados(p):
    """Con F5, una vez y otra, se dice qué está mal, se sigue con los que había y no quedan objetos de más; y con F3 se
    dice aunque lo que llega sea más antiguo y de lo que incluye. Lo que los estropea es una captura."""
    if not p.shaders:
        return
    for cada, que, shaders in (["especial F5"], "F5", p.shaders), (["especial F3", "espera 600"], "F3", p.incluidos):
        with tempfile.TemporaryDirectory() as carpeta:
            ejecutable = Path(carpeta, "bin", p.nombre)  # quien no usa common/ los busca al lado de su carpeta
            ejecutable.parent.mkdir()
            ejecutable.symlink_to(p.ejecutable)
            for shader in shaders:
                suyo = Path(carpeta, shader)
                suyo.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(p.raiz / shader, suyo)
                os.utime(suyo, (1 << 32, 1 << 32))  # del futuro
            guion = "; ".join([cada[0], *(f"captura {carpeta}/{shader}" for shader in shaders), *2 * cada[-1:]])
            orden = [ejecutable, "-geometry", TALLA, "-ppm", "/dev/null", "-diario", "-guion", guion]
            r = subprocess.run(orden, env=os.environ | {"LAB_RAIZ": carpeta}, errors="replace", **APARTE)
        if r.returncode or not r.stderr:
            yield que, f"con los shaders estropeados, {que} no dice nada, o acaba con {r.returncode}"
        filas = [linea.split("\t") for linea in r.stdout.splitlines() if linea.startswith("diario\t")]
        queda = [(fila[2], fila[6]) for fila in filas[1:]]  # la imagen y los objetos
        if que == "F5" and len({*queda}) != 1:
            yield que, f"releer unos shaders estropeados cambia lo que se ve o deja objetos: {queda}"
