"""Dónde está lo que importan las pruebas de herramientas/, y lo que comparten las de ./lab corrige."""
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

RAIZ = Path(__file__).parents[2]
sys.path[:0] = [
    str(RAIZ / carpeta) for carpeta in ("herramientas", "tests/ordenes", "tests/paginas", "tests/propiedades")
]
from ejercicios.corrige import clase as de_clase


@pytest.fixture
def juzga(monkeypatch):
    """En vez de compilar y jugar, una función de (banco, entrega), que da la nota y lo que se dice."""

    def pon(funcion):
        monkeypatch.setattr(
            de_clase,
            "Correccion",
            lambda *p: SimpleNamespace(dibuja=True, hazla=lambda: {"fallos": [], **funcion(*p)}),
        )

    return pon
