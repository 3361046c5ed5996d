"""dorado.py RAÍZ BUILD SIN_VENTANA [CASO…]: rehace los golden de esos casos, o todos, y deja en BUILD/dora/index.html
los que cambian: la imagen de antes, la de ahora y su diferencia, y lo que cambia de lo escrito.

Si alguno no se puede dibujar, no cambia ninguno.
"""
import difflib
import os
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from base import catalogo, paginas
from base.procesos import Fallo, en_png, entorno, escribe, lanza, principal
from pruebas.fallos import MUCHO, PLANTILLA, PruebaFallida

TIPOS = ".ppm", ".txt", ".encima"


def dibuja(raiz, build, sin_ventana, pedidos, ahora):
    """Esos casos, y los pasos de los programas que se nombren. Lo que dicen los que no se pueden."""
    casos = catalogo.elegidos(catalogo.lee_programas(build), pedidos)
    piden = [(sin_ventana, caso.programa.nombre, caso.nombre) for caso in casos]
    con_pasos = [f.stem for f in sorted(ahora.rglob("*.pasos"))]
    piden += [("pasos", programa) for programa in con_pasos if programa in pedidos or not pedidos]
    como = {"text": True, "stderr": subprocess.STDOUT}
    como["env"] = {**os.environ, **entorno(), "DORA": "1", "GOLDEN": str(ahora)}
    with ThreadPoolExecutor(len(os.sched_getaffinity(0))) as hilos:
        hechos = list(hilos.map(lambda pide: lanza([raiz / "tests/casos/casos.sh", build, *pide], **como), piden))
    return [hecho.stdout.strip() for hecho in hechos if hecho.returncode]


def cambiados(antes, ahora):
    """Los que no son iguales, o son nuevos: la ruta, sin tipo, y los tipos."""
    cambian = {}
    for ruta in (f.relative_to(carpeta) for carpeta in (antes, ahora) for f in carpeta.rglob("*") if f.suffix in TIPOS):
        parejas = [carpeta / ruta for carpeta in (antes, ahora)]
        if len({f.read_bytes() if f.exists() else None for f in parejas}) > 1:
            cambian.setdefault(ruta.with_suffix(""), set()).add(ruta.suffix)
    return dict(sorted(cambian.items()))


def lineas(fichero):
    return fichero.read_text().splitlines() if fichero.exists() else []


def cambio(build, destino, antes, ahora, ruta, tipos):
    """Uno, como lo enseña la página: sus imágenes, con el prefijo con que quedan, y lo escrito."""
    dice, imagenes = [], []
    for tipo in sorted(tipos, key=TIPOS.index):
        viejo, nuevo = ((carpeta / ruta).with_suffix(tipo) for carpeta in (antes, ahora))
        if tipo != ".ppm":
            dice.append(f"cambia lo de {tipo}")
            dice += difflib.unified_diff(lineas(viejo), lineas(nuevo), "antes", "ahora", lineterm="", n=0)
        elif viejo.exists():
            (destino / ruta).parent.mkdir(parents=True, exist_ok=True)
            compara = [build / "herramientas/comparador/compara", viejo, nuevo, "--deja", destino / ruta]
            dice.append(lanza(compara, text=True).stdout.splitlines()[0])
            imagenes.append(str(ruta))
        else:
            dice.append("imagen nueva")
    return PruebaFallida(str(ruta), "\n".join(dice)[:MUCHO], imagenes)


def ensena(destino, cambios):
    for ppm in destino.rglob("*.ppm"):
        escribe(ppm.with_suffix(".png"), en_png(ppm))
        ppm.unlink()
    paginas.escribe_pagina(
        destino, PLANTILLA, fallos=cambios, titulo="Lo que cambia", nombres=("la de antes", "la de ahora"), cosa="caso"
    )


def main():
    raiz, build, sin_ventana, *pedidos = Path(sys.argv[1]), Path(sys.argv[2]), *sys.argv[3:]
    antes, destino = raiz / "tests/golden", build / "dora"
    shutil.rmtree(destino, ignore_errors=True)
    with tempfile.TemporaryDirectory() as temporal:
        ahora = Path(shutil.copytree(antes, Path(temporal, "golden")))
        if mal := dibuja(raiz, build, sin_ventana, pedidos, ahora):
            raise Fallo("\n".join(["dora: no se rehace ninguno, porque no se pueden dibujar:", *mal]))
        cambian = cambiados(antes, ahora)
        if not cambian:
            return print("Ningún golden cambia")
        cambios = [cambio(build, destino, antes, ahora, ruta, tipos) for ruta, tipos in cambian.items()]
        ensena(destino, cambios)
        for fichero in (ruta.with_suffix(tipo) for ruta, tipos in cambian.items() for tipo in tipos):
            if (ahora / fichero).exists():
                escribe(antes / fichero, (ahora / fichero).read_bytes())
            else:
                (antes / fichero).unlink()
    for c in cambios:
        print(f"{c.prueba}: {c.dice.splitlines()[0].split(';')[0]}")
    print(f"Cambian {len(cambios)}: míralos en {destino}/index.html; git restore tests/golden los deja como estaban")


if __name__ == "__main__":
    principal(main)
