#!/usr/bin/env python3
"""comprueba_clase.py RAÍZ BUILD [CARPETA]: la página de una clase corregida, en Chromium, en claro y en oscuro.

La tabla se ordena por nombre y por nota, y otra vez al revés; los enlaces siguen llevando a cada una; nada se sale de
un teléfono de 360 píxeles, tampoco de la página de cada una ni de la de las que se parecen, y lo pueden usar todos. En
CARPETA deja las fotos.
"""
import base64
import html
import sys
import tempfile
from pathlib import Path
from types import SimpleNamespace
from urllib.parse import unquote, urlsplit

import navegador
from navegador import PROGRAMAS, TAB, exige

from ejercicios.corrige import conjunto

NOTAS = {"Álvarez, Íñigo": 9.5, "Zoé": 100, "ana": 72.7, "Núñez": 8.75, "Nadal": 100, "<b>Ñíguez</b>": 0}
POR_NOMBRE = ["<b>Ñíguez</b>", "Álvarez, Íñigo", "ana", "Nadal", "Núñez", "Zoé"]
COPIADO = "int main() {\n" + "".join(f"  pinta({i}, {i} + 1, {'x' * i});\n" for i in range(40)) + "}\n"
PUNTO = "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg=="  # un PNG
POR_NOTA = sorted(NOTAS.values())


def correccion(nombre, nota):
    dice = ["se ve lo mismo que en el punto de partida", "y algo más"] if nota < 100 else []
    suyo = {"entrega": nombre, "nota": nota, "bien": 2, "guiones": 5, "semilla": "1", "reglas": "las de siempre"}
    fallo = {"que": "falla tras «tecla d»", "tras": ["tecla d"], "donde": None, "imagenes": [PUNTO] * 3}
    return {**suyo, "dice": dice, "fallos": [fallo] if nota < 100 else [], "casos": {}}


def clase(carpeta):
    """La de esas notas, con dos que se parecen."""
    correcciones = {Path(nombre): correccion(nombre, nota) for nombre, nota in NOTAS.items()}
    leidas = {quien: {"grua.cpp": COPIADO} for quien in list(correcciones)[:2]}
    conjunto.escribe(carpeta, correcciones, SimpleNamespace(programa=PROGRAMAS["grua"], ref="E3.5", dados=()), leidas)


def celdas(n, columna):
    return n.js(
        "return [...document.querySelectorAll('tbody tr')].map(f => f.cells[arguments[0]].textContent)", columna
    )


def ordena(n):
    pulsa = "document.querySelectorAll('th button')[arguments[0]].click()"
    flecha = "return [...document.querySelectorAll('th')].map(th => th.ariaSort)"
    for columna, orden in ((0, POR_NOMBRE), (1, POR_NOTA)):
        for sentido, vuelto in (("ascending", orden), ("descending", orden[::-1]), ("ascending", orden)):
            n.js(pulsa, columna)
            hay = celdas(n, columna)
            hay = [float(nota) for nota in hay] if columna else hay
            exige(hay == vuelto, f"columna {columna}, {sentido}: {hay}")
            debe = [sentido if i == columna else None for i in range(3)]
            exige(n.js(flecha) == debe, f"columna {columna}, y se dice: {n.js(flecha)}")
        exige(dict(zip(celdas(n, 0), map(float, celdas(n, 1)))) == NOTAS, "cada una sigue con su nota")
    enlaces = n.js("return [...document.querySelectorAll('td a')].map(a => [a.href, a.textContent])")
    exige(len(enlaces) == len(NOTAS), "cada una tiene la suya")
    for enlace, nombre in enlaces:
        suya = Path(unquote(urlsplit(enlace).path)).read_text()
        exige(f"<h2><span>{html.escape(nombre)}</span>" in suya, f"el enlace de {nombre} lleva a la suya")


def las_demas(n, carpeta, tema):
    """La página de uno y la de los parecidos."""
    for pagina in (carpeta / "comentarios/ana.html", carpeta / "parecidos.html"):
        n.talla(1280, 900)
        n.abre(pagina)
        navegador.accesible(n, f"{pagina.name}, {tema}")
        n.talla(360, 740)
        navegador.nada_se_sale(n, pagina.name, 360)


def main():
    deja = Path(sys.argv[3]) if len(sys.argv) > 3 else None
    with tempfile.TemporaryDirectory() as carpeta, navegador.chromium("--headless=new") as n:
        pagina = Path(carpeta, "index.html")
        clase(Path(carpeta))
        for tema in ("light", "dark"):
            n.devtools("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": tema}])
            n.talla(1280, 900)
            n.abre(pagina)
            n.tecla(TAB)
            exige(n.js("return document.activeElement.tagName") in ("A", "BUTTON"), "se llega con el tabulador")
            ordena(n)
            navegador.accesible(n, f"la clase, {tema}")
            if deja:
                (deja / f"clase-{tema}.png").write_bytes(base64.b64decode(n.foto()))
            n.talla(360, 740)
            navegador.nada_se_sale(n, "la clase", 360)
            las_demas(n, Path(carpeta), tema)
        exige(not n.registro(), "la consola está vacía")
    navegador.acaba()


if __name__ == "__main__":
    main()
