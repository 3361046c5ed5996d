"""Las páginas del laboratorio, a partir del catálogo y de las plantillas."""
import re
import statistics
from pathlib import Path

import jinja2
from pygments import highlight
from pygments.formatters import HtmlFormatter
from pygments.lexers import CppLexer, GLShaderLexer

import controles
import libro
import procesos

PLANTILLAS = Path(__file__).parent / "plantillas"
CLARO, OSCURO = HtmlFormatter(style="xcode", nowrap=True), HtmlFormatter(style="github-dark", nowrap=True)


def fuentes(raiz, fichero, vistas=None):
    """Un fuente y los de los capítulos que nombra entre comillas, cabeceras y shaders, y así con cada uno."""
    vistas = [] if vistas is None else vistas
    vistas.append(fichero)
    for nombre in re.findall(r'"([\w./]+\.(?:h|cpp|vert|frag|glsl))"', (raiz / fichero).read_text()):
        for candidato in (fichero.parent / nombre, Path(nombre)):
            if candidato not in vistas and candidato.parts[0].startswith("ch") and (raiz / candidato).is_file():
                fuentes(raiz, candidato, vistas)
    return vistas


def colorea(raiz, fichero):
    lexico = CppLexer() if fichero.suffix in (".cpp", ".h") else GLShaderLexer()
    return highlight((raiz / fichero).read_text(), lexico, CLARO)


class Galeria:
    """La galería entera en un fichero, al lado de sus imágenes. Mientras no están todas se escribe con las que hay, y se vuelve a cargar sola."""

    def __init__(self, raiz, destino, capitulos):
        programas = [p for capitulo in capitulos for p in capitulo.programas]
        suyas = {p.nombre: fuentes(raiz, p.fuente) for p in programas}
        todas = dict.fromkeys(f for ficheros in suyas.values() for f in ficheros)
        self.destino = destino
        self.datos = {"capitulos": capitulos, "libro": libro.Libro(raiz), "fuentes": suyas,
                      "controles": {p.nombre: [c.texto for c in controles.lee(raiz, p)] for p in programas},
                      "codigo": {str(f): colorea(raiz, f) for f in todas},
                      "colores_claros": CLARO.get_style_defs("pre"), "colores_oscuros": OSCURO.get_style_defs("pre")}

    def escribe(self, faltan=0):
        """DESTINO/index.html, cuando aún no se han dibujado tantos programas."""
        escribe_pagina(self.destino, "galeria.html", faltan=faltan, **self.datos)


def cifra(x):
    """Tres cifras significativas, como se leen: 0.0123, 12.3, 1 230 000; las muy pequeñas o muy grandes, 1.2·10⁻⁹."""
    if x != x:
        return "—"
    if x in (0, float("inf")):
        return "0" if x == 0 else "no vale"
    if 1e-3 <= abs(x) < 1e7:
        entera, _, decimal = (f"{x:.3g}" if abs(x) < 999.5 else f"{x:.0f}").partition(".")
        return re.sub(r"(?<=\d)(?=(\d{3})+$)", "\u202f", entera) + ("." + decimal if decimal else "")
    mantisa, _, exponente = f"{x:.1e}".partition("e")
    return f"{mantisa}·10{str(int(exponente)).translate(str.maketrans('-0123456789', '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'))}"


def escribe_informe(destino, tecnicas, **datos):
    """DESTINO/index.html: el informe de ./lab mide, al lado de sus gráficas e imágenes."""
    escribe_pagina(destino, "informe.html", tecnicas=tecnicas, lento=100, graficas={t.nombre for t in tecnicas if (destino / f"{t.nombre}.svg").exists()}, **datos)


def plantilla(nombre, texto=False):
    """Una de herramientas/plantillas/; si es de texto, sin escapar nada como en HTML."""
    entorno = jinja2.Environment(loader=jinja2.FileSystemLoader(PLANTILLAS), autoescape=not texto, trim_blocks=True, lstrip_blocks=True,
                                 undefined=jinja2.StrictUndefined, keep_trailing_newline=texto)
    entorno.filters["cifra"] = cifra
    entorno.filters["median"] = statistics.median
    entorno.policies["json.dumps_kwargs"] = {"ensure_ascii": False, "separators": (",", ":")}
    return entorno.get_template(nombre)


def escribe_pagina(destino, nombre, **datos):
    """DESTINO/index.html, entera o nada."""
    procesos.escribe(destino / "index.html", plantilla(nombre).render(**datos))
