"""Lo que se guarda para no hacerlo otra vez: vale mientras todo de lo que depende sea igual."""
import os
from pathlib import Path
from types import SimpleNamespace

import pytest

from galeria import dibuja
from mentira import siembra


@pytest.fixture
def otra_vez(tmp_path, monkeypatch):
    """Si se dibuja, otra vez, un caso de un programa de mentira, que lee una textura."""
    siembra(tmp_path, {"ch/a.cpp": "x", "b/a": "x", "b/t.rgb": "x", "d/i.png": "x"})

    def hace(orden, env=None, **_):
        Path((env or {"LAB_LEIDOS": os.devnull})["LAB_LEIDOS"]).write_text("t.rgb\n")
        Path(orden[orden.index("-ppm") + 1]).write_text("P6")
        return "título: T\ndiario\t\nuno\ndiario\t\n".encode()

    def anima(*argumentos):
        siembra(tmp_path, {f.relative_to(tmp_path): "x" for f in (argumentos[-2], *argumentos[-1])})

    monkeypatch.setattr(dibuja, "ejecuta", hace)
    monkeypatch.setattr(dibuja.procesos, "en_png", lambda *_: b"png")
    monkeypatch.setattr(dibuja.Galeria, "anima", anima)
    suyos = {"imagen": "i.png", "animada": "a.webp", "cuadros": ["a/0.webp"], "fichero": "a"}
    caso = SimpleNamespace(**suyos, guion="tecla a", anima="1 tecla a")
    p = SimpleNamespace(consola="", ejecutable=lambda _: tmp_path / "b/a", ficheros=lambda _: [tmp_path / "ch/a.cpp"])
    hecho = {}

    def dibuja_otra_vez():
        nueva = dibuja.Galeria.__new__(dibuja.Galeria)
        nueva.raiz, nueva.build, nueva.destino, nueva.hecho = tmp_path, tmp_path / "b", tmp_path / "d", hecho
        return nueva.dibuja(p, caso, tmp_path)

    return caso, dibuja_otra_vez


def test_una_imagen_de_la_galeria(tmp_path, monkeypatch, otra_vez):
    caso, otra_vez = otra_vez
    assert otra_vez() and not otra_vez() and (caso.ventana, caso.salida) == ("T", "uno\n")
    for fichero in ("ch/a.cpp", "b/a", "b/t.rgb"):
        siembra(tmp_path, {fichero: "otro"})
        assert otra_vez() and not otra_vez(), fichero
    for fichero in ("d/i.png", "d/a.webp", "d/a/0.webp"):
        (tmp_path / fichero).write_text("")
        assert otra_vez() and not otra_vez(), fichero
    for que, nombre in ((dibuja, "TALLA"), (dibuja, "PROYECTADA"), (dibuja, "WEBP"), (caso, "guion"), (caso, "anima")):
        monkeypatch.setattr(que, nombre, "1 otra")
        assert otra_vez() and not otra_vez(), nombre
