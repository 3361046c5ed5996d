"""escribe.py RAÍZ BUILD: las páginas de docs/ que salen del catálogo y de docs/evidencia.json."""
import sys
from pathlib import Path

from base import catalogo, evidencia, libro
from base.paginas import plantilla
from base.procesos import escribe, principal

AQUI = Path(__file__).parent


def programas_md(raiz, capitulos, programas):
    """Los programas, y dónde está cada cosa del libro o, si no tiene programa, por qué."""
    tabla = []
    for cosa in libro.cosas(raiz):
        donde = [f"[{p.nombre}](../{p.fuente})" for p in programas if cosa.codigo in p.referencias]
        if cosa.enunciado:
            donde.append("[respuesta](soluciones.md)")
        tabla.append((cosa.codigo, cosa.que, cosa.motivo or ", ".join(donde)))
    return {"capitulos": capitulos, "libro": tabla}


def exactitud_md(raiz, _, programas):
    medido, pasan = evidencia.lee(raiz), {}
    for p in programas:
        if p.pasa:
            pasan.setdefault(p.pasa, []).append(p.nombre)
    comparados = [p for p in programas if p.nombre in medido["programas"]]
    de_pixeles = sum(any(evidencia.errores(m)) for m in medido["programas"].values())
    cifras = {"errores": evidencia.errores, "numero": evidencia.numero}
    return {"programas": comparados, "medido": medido, "pasan": pasan, "de_pixeles": de_pixeles, **cifras}


def main():
    raiz, build = map(Path, sys.argv[1:])
    capitulos = catalogo.lee(build)
    programas = [p for capitulo in capitulos for p in capitulo.programas]
    for nombre, dice in ("programas.md", programas_md), ("exactitud.md", exactitud_md):
        escribe(raiz / "docs" / nombre, plantilla(AQUI / nombre).render(**dice(raiz, capitulos, programas)))


if __name__ == "__main__":
    principal(main)
