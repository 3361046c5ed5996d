"""Las páginas y los textos que salen de una plantilla de Jinja: cada una, en el cuarto de quien la usa."""
import re
import statistics
from pathlib import Path

import jinja2

from base import procesos

AQUI = Path(__file__).parent  # las que usan varios


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


def plantilla(fichero):
    """La de ese fichero, que puede usar las que tiene al lado y las de aquí. La que no es de HTML, sin escapar nada."""
    en_html = fichero.suffix == ".html"
    entorno = jinja2.Environment(
        loader=jinja2.FileSystemLoader([fichero.parent, AQUI]),
        autoescape=en_html,
        trim_blocks=True,
        lstrip_blocks=True,
        undefined=jinja2.StrictUndefined,
        keep_trailing_newline=not en_html,
    )
    entorno.filters["cifra"] = cifra
    entorno.tests["search"] = lambda texto, buscado: buscado in texto
    entorno.filters["median"] = statistics.median
    entorno.policies["json.dumps_kwargs"] = {"ensure_ascii": False, "separators": (",", ":")}
    return entorno.get_template(fichero.name)


def junta(carpeta, modulos):
    """Los módulos, de los que hay en esa carpeta y aquí, en un guion: de file:// un navegador no carga lo que importan.
    Lo que cada uno declara fuera de sus funciones tiene otro nombre en los demás."""
    donde = {f.name: f for c in (AQUI, carpeta) for f in c.glob("*.mjs")}
    sin_importar = (re.sub(r"^import .*?;\n", "", donde[m].read_text(), flags=re.M | re.S) for m in modulos)
    return "\n".join(re.sub("^export ", "", texto, flags=re.MULTILINE) for texto in sin_importar)


def escribe_pagina(destino, fichero, **datos):
    """DESTINO/index.html, entera o nada."""
    procesos.escribe(destino / "index.html", plantilla(fichero).render(**datos))
