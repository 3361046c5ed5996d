"""causas.py BUILD [CAUSA…] [--todos]: si ./lab explica acaba bien y nombra, entre sus dos primeras sospechas, cada
causa de causas.tsv plantada en el primero de sus programas o, con --todos, en cada uno. Estado 1 si deja de nombrar
alguna."""
import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

RAIZ = Path(__file__).parents[2]
sys.path.insert(0, str(RAIZ / "herramientas"))
from base import catalogo  # noqa: E402

LISTA = Path(__file__).with_suffix(".tsv")


def sospechas(build, programa, causa):
    """Las dos primeras del cuadro entero."""
    entorno = {**os.environ, "ESTROPEA": causa, "LD_PRELOAD": str(build / "tests/libestropea.so")}
    with tempfile.TemporaryDirectory() as carpeta:
        orden = [sys.executable, "-B", RAIZ / "herramientas", "explica.orden", RAIZ, build, carpeta]
        suyo = [programa.capitulo.nombre, programa.nombre, programa.nombre, programa.titulo]
        hecho = Path(carpeta, "e.json")
        r = subprocess.run([*orden, *suyo, "-geometry", "240x180", "--json", hecho], env=entorno, capture_output=True)
        if r.returncode:
            return [f"acaba con {r.returncode}: {r.stderr.decode()}"]
        return [s["dice"] for s in json.loads(hecho.read_text())["sospechas"][:2]]


def main():
    build, *resto = sys.argv[1:]
    build, todos = Path(build).absolute(), "--todos" in resto
    programas = {p.nombre: p for p in catalogo.lee_programas(build)}
    filas = [fila.split("\t") for fila in LISTA.read_text().splitlines() if not fila.startswith("#")]
    plantadas = nombradas = 0
    for causa, en, debe in filas:
        if set(resto) - {"--todos"} and causa not in resto:
            continue
        for nombre in en.split()[: None if todos else 1]:
            dichas = sospechas(build, programas[nombre], causa)
            plantadas += 1
            if any(re.search(debe, dicha) for dicha in dichas):
                nombradas += 1
            else:
                print(f"{causa} en {nombre}: {dichas}")
    print(f"{nombradas} de {plantadas} causas nombradas")
    return plantadas == 0 or nombradas < plantadas


if __name__ == "__main__":
    sys.exit(main())
