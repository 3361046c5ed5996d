#!/usr/bin/env python3
"""documentos.py RAÍZ BUILD escribe|comprueba: las páginas de docs/ que salen del catálogo y de docs/medidas.json.

comprueba: acaba con 1 si alguna no está al día, y dice qué cambia.
"""
import difflib
import sys
from collections import Counter
from pathlib import Path

import catalogo
import libro
import medidas
import muta
import pagina
from procesos import escribe, principal


def programas_md(raiz, capitulos):
    """Los programas, y dónde está cada cosa del libro o, si no tiene programa, por qué."""
    programas = [p for capitulo in capitulos for p in capitulo.programas]
    tabla = []
    for cosa in libro.cosas(raiz):
        donde = [f"[{p.nombre}](../{p.fuente})" for p in programas if cosa.codigo in p.referencias]
        if cosa.enunciado:
            donde.append("[respuesta](soluciones.md)")
        tabla.append((cosa.codigo, cosa.que, cosa.motivo or ", ".join(donde)))
    return pagina.plantilla("programas.md", texto=True).render(capitulos=capitulos, libro=tabla)


def exactitud_md(raiz, capitulos):
    programas = [p for capitulo in capitulos for p in capitulo.programas]
    medido = medidas.lee(raiz)
    mutantes, _ = muta.lee(raiz)
    pasan = {}
    for p in programas:
        if p.pasa:
            pasan.setdefault(p.pasa, []).append(p.nombre)
    casos = [(f"{tema}: {caso}", citas) for tema, caso, *citas in libro.filas(raiz / "tests/casos_dificiles/casos.tsv")]
    de_pixeles = sum(any(medidas.errores(m)) for m in medido["programas"].values())
    return pagina.plantilla("exactitud.md", texto=True).render(
        programas=[p for p in programas if p.nombre in medido["programas"]], medido=medido, pasan=pasan, de_pixeles=de_pixeles,
        casos=[c for c in casos if c[0] in medido["casos"]], listas=Counter(m.lista for m in mutantes), sobreviven=[m for m in mutantes if m.motivo],
        errores=medidas.errores, numero=medidas.numero)


def main():
    raiz, build, orden = Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3]
    capitulos = catalogo.lee(build)
    viejo = False
    for nombre, texto in (("programas.md", programas_md(raiz, capitulos)), ("exactitud.md", exactitud_md(raiz, capitulos))):
        fichero = raiz / "docs" / nombre
        if orden == "escribe":
            escribe(fichero, texto)
        elif fichero.read_text() != texto:
            print(*difflib.unified_diff(fichero.read_text().splitlines(), texto.splitlines(), f"docs/{nombre}", "al día", lineterm="", n=0),
                  f"docs/{nombre} no está al día: ./lab lista --docs", sep="\n")
            viejo = True
    return viejo


if __name__ == "__main__":
    principal(main)
