"""Dónde está el laboratorio, de qué se hace uno de mentira, y si lo de verdad se puede encerrar."""
import os
import shutil
import subprocess
import time
from pathlib import Path

RAIZ = Path(__file__).parents[2]
BUILD = Path(os.environ.get("LAB_BUILD", RAIZ / "build"))

ENCIERRA = "bwrap --ro-bind / / --unshare-pid --proc /proc --dev /dev true".split()


def se_encierra(*dentro):
    """Si bwrap puede con algo: en un contenedor sin permisos, o en un chroot, no puede con nada. `dentro`: de qué."""
    return bool(shutil.which("bwrap")) and not subprocess.run([*dentro, *ENCIERRA], capture_output=True).returncode


def sin_ventana(build):
    """La carpeta de los programas que dibujan sin ventana, con el OpenGL que haya; puede no estar."""
    cual = build / "sin_ventana"
    return build / (cual.read_text().strip() if cual.exists() else "osmesa")


def siembra(raiz, ficheros):
    """Esos ficheros, con sus carpetas."""
    for fichero, texto in ficheros.items():
        (raiz / fichero).parent.mkdir(parents=True, exist_ok=True)
        (raiz / fichero).write_text(texto)


def ejecutable(fichero, guion):
    """Un guion de sh, en lugar de lo que hubiera."""
    fichero.unlink(missing_ok=True)
    fichero.write_text(f"#!/bin/sh\n{guion}\n")
    fichero.chmod(0o755)


def espera_a(que, segundos=30):
    """Lo que da, en cuanto da algo o pasan esos segundos."""
    limite = time.monotonic() + segundos
    while not (dado := que()) and time.monotonic() < limite:
        time.sleep(0.02)
    return dado


def faltan(texto, *partes):
    """Las que no están en él."""
    return [parte for parte in partes if parte not in texto]
