"""La página de la galería, a partir del catálogo, de lo que dice el libro y de los fuentes."""
from pathlib import Path

from pygments import highlight
from pygments.formatters import HtmlFormatter
from pygments.lexers import CppLexer, GLShaderLexer

from base import controles, fuentes, libro, paginas

PLANTILLA = Path(__file__).with_name("galeria.html")
CLARO, OSCURO = (HtmlFormatter(style=estilo, nowrap=True) for estilo in ("xcode", "github-dark"))


def colorea(raiz, fichero):
    lexico = CppLexer() if fichero.suffix in (".cpp", ".h") else GLShaderLexer()
    return highlight((raiz / fichero).read_text(), lexico, CLARO)


class PaginaGaleria:
    """Entera en un fichero, al lado de sus imágenes. Mientras no están todas se escribe con las que hay, y se vuelve
    a cargar sola."""

    def __init__(self, raiz, destino, capitulos):
        programas = [p for capitulo in capitulos for p in capitulo.programas]
        suyos = {p.nombre: fuentes.alcanza(raiz, p.fuente) for p in programas}
        todos = dict.fromkeys(f for ficheros in suyos.values() for f in ficheros)
        self.destino = destino
        self.datos = {
            "capitulos": capitulos,
            "libro": libro.Libro(raiz),
            "fuentes": suyos,
            "controles": {p.nombre: [c.texto for c in controles.lee(raiz, p)] for p in programas},
            "codigo": {str(f): colorea(raiz, f) for f in todos},
            "colores_claros": CLARO.get_style_defs("pre"),
            "colores_oscuros": OSCURO.get_style_defs("pre"),
        }

    def escribe(self, faltan=0):
        """DESTINO/index.html, cuando aún no se han dibujado tantos programas."""
        paginas.escribe_pagina(self.destino, PLANTILLA, faltan=faltan, **self.datos)
