"""Una sesión da lo que daría cada guion en un programa recién arrancado. Con los que hay en $LAB_BUILD."""
import os
import subprocess
import sys
from pathlib import Path

import pytest

RAIZ = Path(__file__).parents[2]
BUILD = Path(os.environ.get("LAB_BUILD", RAIZ / "build"))
sys.path[:0] = [str(RAIZ / "herramientas"), str(RAIZ / "tests/propiedades")]
import catalogo
from sesion import Sesion


@pytest.mark.parametrize("nombre, termina", [("eventos", "tecla x; tecla Esc"), ("filtrado", "tecla 4"), ("orden_transparencia", "boton CENTRAL arriba 5 5"), ("morphing", "captura no/hay")])
def test_en_una_sesion_pasa_lo_mismo_que_recien_arrancado(tmp_path, nombre, termina):
    programa = next(p for p in catalogo.lee_programas(BUILD) if p.nombre == nombre)
    orden = [programa.ejecutable(BUILD), "-geometry", "120x90", "-titulos"]
    una = Sesion(orden)
    for i, guion in enumerate(("", f"tamano 150 90; tecla a; espera 500; {termina}", "boton IZQUIERDO abajo 40 40; arrastra 60 50; captura otra.ppm")):
        opciones = ["-diario"][i % 2:] + ["-ppm", "i.ppm", "-guion", guion]
        nueva, suya = tmp_path / f"nueva{i}", tmp_path / f"suya{i}"
        nueva.mkdir()
        suya.mkdir()
        r = subprocess.run([*orden, *opciones], cwd=nueva, stdin=subprocess.DEVNULL, capture_output=True, text=True)
        assert una.sigue(suya, opciones) == (r.returncode, r.stdout, r.stderr), guion
        assert {f.name: f.read_bytes() for f in nueva.iterdir()} == {f.name: f.read_bytes() for f in suya.iterdir() if f.suffix}
    una.cierra()


def test_lo_que_no_arranca_no_tiene_sesion(tmp_path):
    una = Sesion(["sh", "-c", "echo nada >&2; exit 5"])
    assert una.sigue(tmp_path, ["-ppm", "i.ppm"]) == (5, "", "nada\n")
