"""Dónde está lo que importan las pruebas de herramientas/, y lo que comparten las de ./lab corrige."""
import sys
from html.parser import HTMLParser
from pathlib import Path
from types import SimpleNamespace

import jinja2
import pytest

RAIZ = Path(__file__).parents[2]
CARPETAS = "herramientas", "tests/ordenes", "tests/paginas", "tests/propiedades"
sys.path[:0] = [str(RAIZ / carpeta) for carpeta in CARPETAS]
from ejercicios.corrige import clase as de_clase


@pytest.fixture
def juzga(monkeypatch):
    """En vez de compilar y jugar, una función de (banco, entrega), que da la nota y lo que se dice."""

    def pon(funcion):
        hecha = lambda *p: SimpleNamespace(dibuja=True, hazla=lambda: {"fallos": [], **funcion(*p)})
        monkeypatch.setattr(de_clase, "Correccion", hecha)

    return pon


class Etiquetas(HTMLParser):
    """Que cada una se cierre en su orden, que ningún id se repita y que cada enlace a la misma página lleve a uno."""

    def __init__(self, texto):
        super().__init__()
        self.abiertas, self.ids, self.enlaces = [], [], []
        self.feed(texto)
        assert not self.abiertas and len(self.ids) == len({*self.ids}), (self.abiertas, self.ids)
        assert "programas" in self.ids or {*self.enlaces} <= {*self.ids}, {*self.enlaces} - {*self.ids}

    def handle_starttag(self, etiqueta, suyos):
        suyos = dict(suyos)
        self.ids += [suyos["id"]] if "id" in suyos else []
        self.enlaces += [e[1:] for e in [suyos.get("href") or ""] if e[1:] and e[0] == "#"]
        if etiqueta not in ("meta", "link", "img", "input", "br", "source", "col", "hr"):
            self.abiertas.append(etiqueta)

    def handle_endtag(self, etiqueta):
        assert etiqueta == self.abiertas.pop(), self.getpos()


@pytest.fixture(autouse=True)
def paginas_enteras(monkeypatch):
    """Las que escriba cualquier prueba."""
    hace = jinja2.Template.render

    def comprueba(plantilla, *p, **datos):
        hecha = hace(plantilla, *p, **datos)
        if hecha.lstrip().startswith("<!DOCTYPE"):
            Etiquetas(hecha)
        return hecha

    monkeypatch.setattr(jinja2.Template, "render", comprueba)
