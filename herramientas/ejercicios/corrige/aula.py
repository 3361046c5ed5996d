"""Lo que da una plataforma: una carpeta o un .zip con lo de todos, como los descarga Moodle, Canvas o Blackboard, y
dentro, lo que subió cada uno."""
import os
import re
import zipfile
from pathlib import Path

from base.procesos import Fallo
from ejercicios import nuevo
from ejercicios.corrige import entrega
from ejercicios.corrige.lector import CLASE, CODIGO, HONDO, Subida, basura, de_carpeta, de_zip, legible, limpio, tipo

# «Ana García_1234_assignsubmission_file_», una carpeta; desde Moodle 4.1, sin el último _; y, si no se descargan en
# carpetas, «…_file_grua.cpp». Un grupo sin nombre no tiene número.
MOODLE = re.compile(
    r"(?P<quien>[^/]+?)(?:_(?P<numero>\d+))?_assignsubmission_(?P<que>file|onlinetext)(?:_(?P<resto>.*))?"
)
# «garciaana_LATE_33333_444444_grua-1.cpp», de Canvas, que numera lo que se sube otra vez; y de Blackboard, con lo que
# dice de ella, «Tarea 1_al123456_attempt_2026-11-20-09-30-00_grua.cpp». Las dos lo dan todo suelto.
SUELTOS = (
    re.compile(
        r"(?P<quien>[^_]+_)(?:LATE_)?(?P<numero>\d+)_\d+(?P<fecha>)_(?P<resto>.+?)(?:-\d+)?(?P<tipo>(\.[^.]+)?)"
    ),
    re.compile(r"(?P<quien>.+_[^_]+)_attempt_(?P<fecha>[\d-]{19})(?P<numero>)(?:_(?P<resto>.+?))?(?P<tipo>\.[^.]+)"),
)


def de_moodle(nombre):
    """Quién es, su número y lo demás de un nombre de Moodle, o None."""
    return MOODLE.fullmatch(legible(nombre))


def de_sueltos(rutas):
    """Lo de cada uno, si es de una de las que lo dan todo suelto; de varias veces, la última."""
    for patron in SUELTOS:
        leidos = {i: m for i, r in enumerate(rutas) if len(r) == 1 and (m := patron.fullmatch(legible(r[0])))}
        if leidos and all(i in leidos or len(r) == 1 and tipo(r[0]) not in CODIGO for i, r in enumerate(rutas)):
            ultima, de_cada_uno, todos = {}, {}, list(leidos.values())
            tarea = "" if todos[0]["numero"] else os.path.commonprefix([m["quien"] for m in todos]).rpartition("_")[0]
            for m in todos:
                ultima[m["quien"]] = max(ultima.get(m["quien"], ""), m["fecha"])
            for i, m in leidos.items():
                if m["resto"] and m["fecha"] == ultima[m["quien"]]:
                    quien = m["quien"].removeprefix(f"{tarea}_") + m["numero"]
                    de_cada_uno.setdefault(quien, []).append(((m["resto"] + m["tipo"],), i))
            return de_cada_uno
    return {}


def sin_la_de_todos(rutas):
    """Si están todas en una carpeta que no es la de nadie, lo que hay en ella."""
    while rutas and len({r[0] for r in rutas}) == 1 and all(len(r) > 1 for r in rutas) and not de_moodle(rutas[0][0]):
        rutas = [r[1:] for r in rutas]
    return rutas


def reparte(rutas):
    """De unas rutas en partes, {su carpeta: [(ruta dentro, cuál es)]} de cada uno: son las carpetas de fuera, cuando no
    están todas en una, o lo que tenga un nombre de Moodle. Vacío, si es lo de uno solo."""
    rutas = sin_la_de_todos(rutas)
    if sueltos := de_sueltos(rutas):
        return sueltos
    quienes, de_cada_uno = {}, {}
    for i, ruta in enumerate(rutas):
        if m := de_moodle(ruta[0]):
            suelto_ = m["resto"] or "" if len(ruta) == 1 else ""  # el nombre del fichero, en el de la carpeta
            carpeta = quienes.setdefault((m["quien"], m["numero"]), ruta[0].removesuffix(suelto_))
            de_cada_uno.setdefault(carpeta, []).append(((suelto_,) if suelto_ else ruta[1:], i))
    if de_cada_uno or any(len(r) == 1 and (tipo(r[0]) in CODIGO or r[0] == nuevo.EJERCICIO) for r in rutas):
        return de_cada_uno
    for i, ruta in enumerate(rutas):
        if len(ruta) > 1:
            de_cada_uno.setdefault(ruta[0], []).append((ruta[1:], i))
    return de_cada_uno if len(de_cada_uno) > 1 else {}


def subidas(hay):
    """Lo de cada uno, si es de una clase."""
    hay = [(ruta, lee) for ruta, lee in hay if not any(map(basura, ruta))]
    de_cada_uno = reparte([ruta for ruta, _ in hay])
    return [Subida(q, [(ruta, hay[i][1]) for ruta, i in suyos]) for q, suyos in sorted(de_cada_uno.items())]


def en_zip(fichero):
    try:
        z = zipfile.ZipFile(fichero)
        cuantos = len(z.infolist())
    except Exception:  # pylint: disable=broad-except  # estropeado, puede ser de cualquier manera
        raise Fallo(f"«{limpio(fichero.name)}» no se puede abrir: está estropeado, o no es un .zip") from None
    if cuantos > CLASE:
        raise Fallo(f"en «{limpio(fichero.name)}» hay más de {CLASE} ficheros")
    return list(de_zip(z))


def busca(mios, pedida, fuera=None):
    """Como entrega.busca, y además un .zip y lo que descarga una plataforma."""
    fichero = Path(pedida).absolute()
    if tipo(pedida) == ".zip" and fichero.is_file():
        hay = en_zip(fichero)
        suyas = subidas(hay)
        return (fichero.with_suffix(""), suyas, []) if suyas else (Subida(fichero.stem, hay), None, [])
    carpeta, dentro, sueltos = entrega.busca(mios, pedida, fuera)
    if carpeta.is_dir() and not (carpeta / nuevo.EJERCICIO).is_file():
        hay = list(de_carpeta(carpeta, CLASE, HONDO + 2))
        suyas = subidas(hay)
        if suyas and all(map(de_moodle, [s.name for s in suyas])) or de_sueltos(sin_la_de_todos([r for r, _ in hay])):
            return carpeta, suyas, []
    return carpeta, dentro, sueltos
