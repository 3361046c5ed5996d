"""dorado.py RAÍZ BUILD mira|visto: los golden que ./lab dora ha dejado en BUILD/dora, al lado de los de antes.

mira: BUILD/dora/index.html, con los que cambian: la imagen de antes, la de ahora y su diferencia, y lo que cambia
de lo escrito. visto: esos pasan a ser los golden.
"""
import difflib
import sys
from pathlib import Path

from base import paginas
from base.procesos import Fallo, en_png, escribe, lanza, principal
from pruebas.fallos import MUCHO, PLANTILLA, PruebaFallida

TIPOS = ".ppm", ".txt", ".encima"


def cambiados(antes, ahora):
    """Los que no son iguales, o no están en los dos sitios: la ruta, sin tipo, y los tipos."""
    cambian = {}
    for ruta in {f.relative_to(carpeta) for carpeta in (antes, ahora) for f in carpeta.rglob("*") if f.suffix in TIPOS}:
        parejas = [carpeta / ruta for carpeta in (antes, ahora)]
        if len({f.read_bytes() if f.exists() else None for f in parejas}) > 1:
            cambian.setdefault(ruta.with_suffix(""), []).append(ruta.suffix)
    return dict(sorted(cambian.items()))


def lineas(fichero):
    return fichero.read_text().splitlines() if fichero.exists() else []


def cambio(build, antes, ahora, ruta, tipos):
    """Uno, como lo enseña la página: sus imágenes, con el prefijo con que quedan, y lo escrito."""
    dice, imagenes = [], []
    for tipo in tipos:
        viejo, nuevo = ((carpeta / ruta).with_suffix(tipo) for carpeta in (antes, ahora))
        if tipo != ".ppm":
            dice += difflib.unified_diff(
                lineas(viejo), lineas(nuevo), f"{tipo}, antes", f"{tipo}, ahora", lineterm="", n=0
            )
        elif viejo.exists() and nuevo.exists():
            compara = [build / "herramientas/comparador/compara", viejo, nuevo, "--deja", (ahora / ruta)]
            dice.append(lanza(compara, text=True).stdout.splitlines()[0])
            imagenes.append(str(ruta))
        else:
            dice.append("imagen nueva" if nuevo.exists() else "ya no se dibuja")
    return PruebaFallida(str(ruta), "\n".join(dice)[:MUCHO], imagenes)


def ensena(build, antes, ahora, cambian):
    cambios = [cambio(build, antes, ahora, ruta, tipos) for ruta, tipos in cambian.items()]
    for ppm in ahora.rglob("*-*.ppm"):
        if ppm.stem.endswith(("-esperada", "-obtenida", "-diferencia")):
            escribe(ppm.with_suffix(".png"), en_png(ppm))
            ppm.unlink()
    paginas.escribe_pagina(
        ahora, PLANTILLA, fallos=cambios, titulo="Lo que cambia", nombres=("la de antes", "la de ahora"), cosa="caso"
    )
    print(f"Cambian {len(cambios)}: míralos en {ahora}/index.html; si están bien, ./lab dora visto")


def main():
    raiz, build, orden = Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3]
    antes, ahora = raiz / "tests/golden", build / "dora"
    if not ahora.is_dir():
        raise Fallo("dora: antes, ./lab dora todo, o ./lab dora --mira CASO…")
    cambian = cambiados(antes, ahora)
    if not cambian:
        print("Ningún golden cambia")
    elif orden == "mira":
        ensena(build, antes, ahora, cambian)
    else:
        pagina = ahora / "index.html"
        if not pagina.exists():
            raise Fallo("dora: no acabó de dibujarse: hazlo otra vez, y mira su página")
        if despues := [f for f in raiz.glob("c*/**/*.*") if f.stat().st_mtime > pagina.stat().st_mtime]:
            raise Fallo(f"dora: {despues[0].relative_to(raiz)} ha cambiado después de dibujarse: hazlo otra vez")
        for ruta in (ruta.with_suffix(tipo) for ruta, tipos in cambian.items() for tipo in tipos):
            if (ahora / ruta).exists():
                escribe(antes / ruta, (ahora / ruta).read_bytes())
            else:
                (antes / ruta).unlink()
        print(f"Hechos: {', '.join(map(str, cambian))}")


if __name__ == "__main__":
    principal(main)
