"""La página de la galería, a partir del catálogo, de lo que dice el libro y de los fuentes."""
import json
from pathlib import Path

from pygments import highlight
from pygments.formatters import HtmlFormatter
from pygments.lexers import CppLexer, GLShaderLexer

from base import controles, fuentes, guiones, indice, libro, marcas, paginas, procesos

AQUI = Path(__file__).parent
PLANTILLA = AQUI / "galeria.html"
MODULOS = "documento.mjs", "busca.mjs", "buscador.mjs", "lado.mjs", "proyector.mjs", "galeria.mjs"
CLARO, OSCURO = (HtmlFormatter(style=estilo, nowrap=True) for estilo in ("xcode", "github-dark"))


def colorea(raiz, fichero):
    lexico = CppLexer() if fichero.suffix in (".cpp", ".h") else GLShaderLexer()
    return highlight(marcas.publico(raiz, fichero), lexico, CLARO)


class PaginaGaleria:
    """Al lado de sus imágenes y de los fuentes, coloreados, que trae al abrirlos. Mientras no están todas se escribe
    con las que hay, y se vuelve a cargar sola."""

    def __init__(self, raiz, destino, capitulos):
        programas = [p for capitulo in capitulos for p in capitulo.programas]
        suyos = {p.nombre: fuentes.alcanza(raiz, p.fuente) for p in programas}
        todos = dict.fromkeys(f for ficheros in suyos.values() for f in ficheros)
        for f in todos:
            suyo = json.dumps(str(f)), json.dumps(colorea(raiz, f), ensure_ascii=False)
            procesos.escribe(destino / "fuentes" / f"{f}.js", "fuente({}, {})\n".format(*suyo))
        del_libro = libro.Libro(raiz, capitulos)
        en_marcha = "../web/index.html"
        self.destino, self.casos = destino, [c for p in programas if not p.consola for c in p.casos]
        self.datos = {
            "capitulos": capitulos,
            "libro": del_libro,
            "indice": indice.hace(raiz, capitulos, del_libro),
            "en_marcha": en_marcha if (destino / en_marcha).is_file() else "",
            "en_breve": guiones.en_breve,
            "guion": paginas.junta(AQUI, MODULOS),
            "fuentes": suyos,
            "controles": {p.nombre: [c.texto for c in controles.lee(raiz, p)] for p in programas},
            "colores_claros": CLARO.get_style_defs("pre"),
            "colores_oscuros": OSCURO.get_style_defs("pre"),
        }

    def escribe(self, faltan=0, sigue=True):
        """DESTINO/index.html, cuando aún no se han dibujado tantos programas, y si se sigue con ellos."""
        imagenes = {c.fichero: c.miniatura for c in self.casos if c.hecho and not c.fallo}
        paginas.escribe_pagina(self.destino, PLANTILLA, faltan=faltan, sigue=sigue, imagenes=imagenes, **self.datos)
