"""Dónde está lo que importan las pruebas de herramientas/, y lo que comparten las de ./lab corrige."""
import argparse
import html
import re
import shlex
import sys
from html.parser import HTMLParser
from pathlib import Path
from types import SimpleNamespace

import jinja2
import pytest

RAIZ = Path(__file__).parents[2]
CARPETAS = "herramientas", "tests/ordenes", "tests/paginas"
sys.path[:0] = [str(RAIZ / carpeta) for carpeta in CARPETAS]
import lab
from ejercicios.corrige import clase as de_clase
from explica.orden import opciones

argparse._ = str  # lo que dice en español lo cambia lab, y las demás órdenes van en otro proceso


@pytest.fixture
def juzga(monkeypatch):
    """En vez de compilar y jugar, una función de (banco, entrega), que da la nota y lo que se dice."""

    def pon(funcion):
        hecha = lambda *p: SimpleNamespace(dibuja=True, hazla=lambda: {"fallos": [], **funcion(*p)})
        monkeypatch.setattr(de_clase, "Correccion", hecha)

    return pon


class Etiquetas(HTMLParser):
    """Que cada una se cierre en su orden, que ningún id se repita y que cada enlace a la misma página lleve a uno."""

    def __init__(self, pagina):
        super().__init__()
        self.abiertas, self.ids, self.enlaces = [], [], set()
        self.feed(pagina)
        assert not self.abiertas and len(self.ids) == len({*self.ids})
        assert "programas" in self.ids or self.enlaces <= {*self.ids}, self.enlaces - {*self.ids}

    def handle_starttag(self, etiqueta, suyos):
        self.ids += [id_ for que, id_ in suyos if que == "id"]
        self.enlaces |= {enlace[1:] for que, enlace in suyos if que == "href" and re.match("#.", enlace)}
        self.abiertas += [etiqueta] * (etiqueta not in ("meta", "link", "img", "input", "br", "source", "col", "hr"))

    def handle_endtag(self, etiqueta):
        assert etiqueta == self.abiertas.pop(), self.getpos()


def se_entienden(pagina):
    """Las órdenes que dice, tal como se copian."""
    for dicha in re.findall(r"<code>([^<]*\./lab [^<]*)", pagina):
        quien, orden, *palabras = shlex.split(html.unescape(dicha))
        pide = palabras and lab.entiende(orden, palabras)  # sin programa, se lo pone la página
        assert quien == "./lab" and (orden != "explica" or opciones(pide.resto)), dicha


@pytest.fixture(autouse=True)
def paginas_enteras(monkeypatch):
    """Las que escriba cualquier prueba."""
    hace = jinja2.Template.render

    def comprueba(*p, **datos):
        hecha = hace(*p, **datos)
        if hecha.startswith("<!DOCTYPE"):
            Etiquetas(hecha), se_entienden(hecha)
        return hecha

    monkeypatch.setattr(jinja2.Template, "render", comprueba)
