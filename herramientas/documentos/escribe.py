"""escribe.py RAÍZ BUILD escribe|comprueba: las páginas de docs/ que salen del catálogo y de docs/evidencia.json.

comprueba: acaba con 1 si alguna no está al día, y dice qué cambia.
"""
import difflib
import sys
from pathlib import Path

from base import catalogo, evidencia, libro
from base.paginas import plantilla
from base.procesos import escribe, principal

AQUI = Path(__file__).parent


def programas_md(raiz, capitulos):
    """Los programas, y dónde está cada cosa del libro o, si no tiene programa, por qué."""
    programas = [p for capitulo in capitulos for p in capitulo.programas]
    tabla = []
    for cosa in libro.cosas(raiz):
        donde = [f"[{p.nombre}](../{p.fuente})" for p in programas if cosa.codigo in p.referencias]
        if cosa.enunciado:
            donde.append("[respuesta](soluciones.md)")
        tabla.append((cosa.codigo, cosa.que, cosa.motivo or ", ".join(donde)))
    return plantilla(AQUI / "programas.md").render(capitulos=capitulos, libro=tabla)


def exactitud_md(raiz, capitulos):
    programas = [p for capitulo in capitulos for p in capitulo.programas]
    medido = evidencia.lee(raiz)
    pasan = {}
    for p in programas:
        if p.pasa:
            pasan.setdefault(p.pasa, []).append(p.nombre)
    return plantilla(AQUI / "exactitud.md").render(
        programas=[p for p in programas if p.nombre in medido["programas"]],
        medido=medido,
        pasan=pasan,
        de_pixeles=sum(any(evidencia.errores(m)) for m in medido["programas"].values()),
        errores=evidencia.errores,
        numero=evidencia.numero,
    )


def main():
    raiz, build, orden = Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3]
    capitulos = catalogo.lee(build)
    viejo = False
    for nombre, texto in (
        ("programas.md", programas_md(raiz, capitulos)),
        ("exactitud.md", exactitud_md(raiz, capitulos)),
    ):
        fichero = raiz / "docs" / nombre
        if orden == "escribe":
            escribe(fichero, texto)
        elif fichero.read_text() != texto:
            print(
                *difflib.unified_diff(
                    fichero.read_text().splitlines(), texto.splitlines(), f"docs/{nombre}", "al día", lineterm="", n=0
                ),
                f"docs/{nombre} no está al día: ./lab lista --docs",
                sep="\n",
            )
            viejo = True
    return viejo


if __name__ == "__main__":
    principal(main)
