"""Dónde se aparta una entrega: lo que explica la suya lo ha podido escribir cualquiera."""
import copy
import json
import os
import random
import re
import subprocess

import pytest

from ejercicios.corrige import cuadro, donde
from mentira import BUILD, sin_ventana

PROGRAMAS = "ch03_transformaciones/grua", "ch05_iluminacion/grua_iluminada", "ch07_realismo/transparencia"
HOSTILES = None, True, -5, 1e300, 1 << 900, "", "nan", "x" * (1 << 20), [], {}, [[]], "<script>", 1.5, "\x1b[2J\n"


@pytest.fixture(scope="module", params=PROGRAMAS)
def datos(request, tmp_path_factory):
    """Lo que cuenta uno de los nuestros, de tres píxeles."""
    carpeta = tmp_path_factory.mktemp("cuadro")
    entorno = {"LD_PRELOAD": BUILD / cuadro.DELANTE, "LAB_EXPLICA": cuadro.FICHERO, "LAB_EXPLICA_SUMAS": "1"}
    entorno |= {"LAB_EXPLICA_PIXELES": "120,90 60,120 130,60"}
    orden = [sin_ventana(BUILD) / request.param, "-geometry", "240x180", "-ppm", "i.ppm"]
    subprocess.run(orden, env={**os.environ, **entorno}, cwd=carpeta, check=True)
    return (carpeta / cuadro.FICHERO).read_bytes()


def nudos(que, ruta=()):
    """Los sitios en que hay algo."""
    yield ruta
    dentro = que.items() if isinstance(que, dict) else enumerate(que) if isinstance(que, list) else ()
    for clave, suyo in dentro:
        yield from nudos(suyo, (*ruta, clave))


def con(que, ruta, otro):
    if not ruta:
        return otro
    nuevo = copy.copy(que)
    nuevo[ruta[0]] = con(que[ruta[0]], ruta[1:], otro)
    return nuevo


def compara(suyo, esperado):
    """Todo lo que se dice de cada píxel."""
    nada = donde.Shaders({})
    comparaciones = [donde.Comparacion(suyo, esperado, i, nada, nada) for i in range(len(suyo["pixeles"]))]
    return [c.primera() for c in comparaciones]


def test_de_lo_mismo_no_se_dice_nada(datos):
    leido = cuadro.lee(datos)
    assert len(leido["pixeles"]) == 3 and any(p["historia"] for p in leido["pixeles"])
    assert compara(leido, copy.deepcopy(leido)) == [None] * 3
    sin = copy.deepcopy(leido)
    for o in sin["ordenes"]:
        o["cableado"] = None  # una que dibuja, por otra que no
    for suceso in (s for p in sin["pixeles"] for s in p["historia"]):
        suceso["despues"] = [7, 7, 7]
    assert any(compara(leido, sin)) and any(compara(sin, leido))


def test_un_cuadro_estropeado_no_vale_o_se_compara(datos):
    """De cada cosa, cambiada por algo hostil: o no se lee, o lo que se dice se puede escribir y no es lo mismo."""
    leido = cuadro.lee(datos)
    entero, azar, valen = json.loads(datos), random.Random(1), 0
    todos = list(nudos({**entero, "sospechas": []}))
    for _ in range(150):
        ruta = azar.choice(todos)
        malo = cuadro.lee(json.dumps(con(entero, ruta, azar.choice(HOSTILES))).encode())
        if malo is None:
            continue
        valen += 1
        for hallado in compara(malo, leido) if len(malo["pixeles"]) == 3 else []:
            assert not hallado or json.dumps(hallado, allow_nan=False)
            assert not hallado or not re.search(r"(?:vale|en) (.+) y se espera \1$", hallado["dice"])
    assert 10 < valen < 140
    uniforms, nada = [r for r in todos if r[-3:-2] == ("uniformes",) and r[-1] == "valor"], donde.Shaders({})
    otros = [con(leido, ruta, [7077.0]) for ruta in azar.sample(uniforms, 30)]
    hallados = [h for o in otros if (h := donde.Comparacion(o, leido, 0, nada, nada).del_cuadro())]
    assert hallados and all(" vale 7077 y se espera " in h["dice"] for h in hallados)
    for malo in (b"", b"{", b"[" * 100000, b"null", b"\xff", datos[:-5], datos + b" " * cuadro.BYTES):
        assert cuadro.lee(malo) is None


def traza(*pasos):
    """De «x = 3» en la línea 2: que es lo que declara, si es la primera vez."""
    suya = {"clase": "asigna", "tipo": "float", "funcion": "main"}
    return {"lineas": [{"linea": n, "nombre": x, "valor": [v], **suya} for n, x, v in pasos]}


BUCLE = "suma = 0.0;\nfor (int i = 0; i < 2; i++)\n    suma += f(i);\nc = suma;"
VUELTAS = (2, "i", 0), (3, "st", 7), (3, "suma", 1), (2, "i", 1), (3, "st", 8), (3, "suma", 3), (4, "c", 3)


def test_el_primer_paso_que_se_aparta():
    """En otro orden, o en dos veces, da lo mismo; si no, la línea que yerra: la última vuelta, la de más o la primera
    de que sale."""
    al_reves = (2, "i", -1), (3, "st", 8), (3, "suma", 2), (2, "i", -2), (3, "st", 7), (3, "suma", 3), (4, "c", 3)
    dice = lambda *pasos: donde.primer_paso(traza(*pasos), traza(*VUELTAS), [BUCLE, BUCLE])
    assert dice(*al_reves) is None and dice(*VUELTAS[:5], (3, "suma", 2), (4, "suma", 3), (5, "c", 3)) is None
    assert dice(*al_reves[:5], (3, "suma", 4), (4, "c", 4)) == (5, [3], [])
    assert dice(*VUELTAS[:6], (4, "suma", 1.5), (5, "c", 1.5)) == (6, [3], [])
    suelto = *VUELTAS[:6], (4, "mitad", 0), (5, "d", 0), (6, "c", 0)
    i, esperado, sueltos = dice(*suelto)
    fuente = "\n\n\nmitad = 1 / 2;\nd = suma * mitad;\nc =\n d;"
    assert (i, esperado) == (8, [3]) and donde.de_que_sale(traza(*suelto)["lineas"], sueltos, i, fuente) == [6, 7]


def test_un_shader_que_se_incluye_a_si_mismo_acaba():
    muchas = '#include "b.glsl"\n' * 3000
    shaders = donde.Shaders({"a.frag": muchas, "b.glsl": muchas, "c.frag": '#include "c.frag"', "d.frag": "uno\ndos"})
    assert shaders.sitio("uno\ndos\n", 2) == ("d.frag", 2) and shaders.sitio("otro", 3) == ("", 3)
