"""fallos.py RAÍZ BUILD: dice qué no se ha podido probar, y deja BUILD/fallos/index.html, con lo que dice cada prueba
de BUILD/pruebas.xml que ha fallado y las imágenes que ha dejado, también en PNG: la esperada, la obtenida y su
diferencia ampliada. Solo enlaza a lo que tiene al lado: la carpeta se puede guardar aparte.
"""
import re
import sys
import xml.etree.ElementTree as xml
from dataclasses import dataclass
from pathlib import Path

from base import paginas
from base.procesos import en_png, escribe, principal

PLANTILLA = Path(__file__).with_name("fallos.html")
MUCHO = 20000  # letras de lo que escribe una prueba


@dataclass
class PruebaFallida:
    prueba: str
    dice: str
    comparaciones: list  # los nombres de sus imágenes, sin «-esperada.png»


def lee(build):
    """Las pruebas que han fallado. El comparador y el oráculo dicen dónde han dejado las imágenes."""
    fallos, carpeta = [], build / "fallos"
    for caso in xml.parse(build / "pruebas.xml").getroot().iter("testcase"):
        if caso.get("status") != "fail":
            continue
        dice = (caso.findtext("system-out") or "").strip()
        dejadas = dict.fromkeys(re.findall(r"imágenes en (.+)-\*\.ppm", dice))
        imagenes = [str(Path(d).relative_to(carpeta)) for d in dejadas if Path(f"{d}-esperada.ppm").exists()]
        fallos.append(PruebaFallida(caso.get("name"), dice[-MUCHO:], imagenes))
    return fallos


def saltadas(build):
    """De lo que no se ha probado aquí, por qué: lo que dicen pytest y ctest."""
    motivos = {}
    for caso in xml.parse(build / "pruebas.xml").getroot().iter("testcase"):
        dichos = re.findall(r"^SKIPPED \[(\d+)\] \S+: (.+)", caso.findtext("system-out") or "", re.M)
        if caso.get("status") == "notrun":
            dichos = [(1, "no se puede aquí")]
        for cuantas, motivo in dichos:
            motivos.setdefault((caso.get("name"), motivo), []).append(int(cuantas))
    return [f"{nombre}, {sum(veces)}: {motivo}" for (nombre, motivo), veces in motivos.items()]


def main():
    build = Path(sys.argv[2]).resolve()
    for linea in saltadas(build):
        print(f"lab: sin probar: {linea}", file=sys.stderr)
    fallos = lee(build)
    if not fallos:
        return
    for ppm in (build / "fallos").rglob("*.ppm"):
        escribe(ppm.with_suffix(".png"), en_png(ppm))
    paginas.escribe_pagina(
        build / "fallos",
        PLANTILLA,
        fallos=fallos,
        titulo="Lo que ha fallado",
        nombres=("la esperada", "la obtenida"),
        cosa="prueba",
    )
    print(f"lab: lo que ha fallado, con sus imágenes, está en {build}/fallos/index.html", file=sys.stderr)


if __name__ == "__main__":
    principal(main)
