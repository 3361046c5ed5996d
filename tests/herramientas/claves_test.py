"""Lo que se guarda para no hacerlo otra vez: vale mientras todo sea igual, y basta que cambie cualquiera de las cosas
de que depende para que ya no valga."""
import os
import re
import sys
from pathlib import Path
from types import SimpleNamespace

RAIZ = Path(__file__).parents[2]
sys.path[:0] = [str(RAIZ / carpeta) for carpeta in ("herramientas", "tests/ordenes")]
from galeria import dibuja
from pruebas import evidencia, fallos
from mentira import siembra


def pon(que, nombre):
    """Cambia ese dato, y cómo se deshace."""
    antes = getattr(que, nombre)
    setattr(que, nombre, f"{antes} 1" if isinstance(antes, str) else (*antes, "1"))
    return lambda: setattr(que, nombre, antes)


def test_una_imagen_de_la_galeria(tmp_path, monkeypatch):
    """Cada cosa que está en su clave, como la dice el fuente; y cada fichero."""
    siembra(tmp_path, {"ch/a.cpp": "x", "b/a": "x", "b/t.rgb": "x", "d/i.png": "x"})

    def hace(orden, env=None, **_):
        Path((env or {"LAB_LEIDOS": os.devnull})["LAB_LEIDOS"]).write_text("t.rgb\n")
        Path(orden[orden.index("-ppm") + 1]).write_text("P6")
        return "título: T\ndiario\t\nuno\ndiario\t\n".encode()

    monkeypatch.setattr(dibuja, "ejecuta", hace)
    monkeypatch.setattr(dibuja.procesos, "en_png", lambda *_: b"png")

    def anima(*argumentos):
        animada, cuadros = argumentos[-2:]
        for fichero in (animada, *cuadros):
            siembra(tmp_path, {fichero.relative_to(tmp_path): "x"})

    monkeypatch.setattr(dibuja.Galeria, "anima", anima)
    suyos = {"imagen": "i.png", "animada": "a.webp", "cuadros": ["a/0.webp"], "fichero": "a"}
    caso = SimpleNamespace(**suyos, guion="tecla a", anima="1 tecla a")
    p = SimpleNamespace(consola="", ejecutable=lambda _: tmp_path / "b/a", ficheros=lambda _: [tmp_path / "ch/a.cpp"])
    galeria = SimpleNamespace(hecho={})

    def otra_vez():
        nueva = dibuja.Galeria.__new__(dibuja.Galeria)
        nueva.raiz, nueva.build, nueva.destino, nueva.hecho = tmp_path, tmp_path / "b", tmp_path / "d", galeria.hecho
        return nueva.dibuja(p, caso, tmp_path)

    assert otra_vez() and not otra_vez() and (caso.ventana, caso.salida) == ("T", "uno\n")
    como = re.search(r" como = (.*)", Path(dibuja.__file__).read_text())[1]
    nombrados = set(re.findall(r"\b(?:caso\.\w+|[A-Z]+)\b", como))
    assert len(nombrados) >= 7
    for que in nombrados:
        vuelve = pon(caso if "." in que else dibuja, que.rpartition(".")[2])
        assert otra_vez() and not otra_vez(), que
        vuelve()
        assert otra_vez() and not otra_vez(), que
    for fichero in ("ch/a.cpp", "b/a", "b/t.rgb"):
        siembra(tmp_path, {fichero: "otro"})
        assert otra_vez() and not otra_vez(), fichero
    for fichero in ("d/i.png", "d/a.webp", "d/a/0.webp"):
        for estropea in ((tmp_path / fichero).unlink, lambda f=tmp_path / fichero: f.write_text("")):
            estropea()
            assert otra_vez() and not otra_vez(), fichero


def test_lo_que_midio_una_prueba(tmp_path):
    """También los programas y los shaders que usa."""
    build = tmp_path / "build"
    siembra(tmp_path, {"ch/a.vert": "", "build/osmesa/a": "", "build/tests/x_test": "", "build/x.json": ""})
    siembra(build, {"leidos/x_test": f"{build}/osmesa/a\nch/a.vert\nnoesta\n"})
    usa = build / "tests/x_test", build / "osmesa/a", tmp_path / "ch/a.vert"
    pregunta = tmp_path, build, build / "x.json", usa[0]
    os.utime(build / "x.json", (2e9, 2e9))
    assert evidencia.al_dia(*pregunta)
    for fichero in usa:
        os.utime(fichero, (2.1e9, 2.1e9))
        assert not evidencia.al_dia(*pregunta), fichero
        os.utime(fichero, (1e9, 1e9))
    (build / "x.json").unlink()
    assert not evidencia.al_dia(*pregunta)


def test_de_mucho_que_escribe_una_prueba_se_ve_el_final(tmp_path):
    dice = f"principio {'x' * fallos.MUCHO} final"
    siembra(
        tmp_path,
        {"pruebas.xml": f'<t><testcase name="a.b" status="fail"><system-out>{dice}</system-out></testcase></t>'},
    )
    [f] = fallos.lee(tmp_path)
    assert f.dice.endswith(" final") and len(f.dice) == fallos.MUCHO
