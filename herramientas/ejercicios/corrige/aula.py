"""Lo que da una plataforma: una carpeta o un .zip con lo de todos, como los descarga Moodle, y dentro, lo que subió
cada uno."""
import re
import unicodedata
import zipfile
from pathlib import Path

from base.procesos import Fallo
from ejercicios import nuevo
from ejercicios.corrige import entrega
from ejercicios.corrige.lector import CLASE, CODIGO, HONDO, Subida, basura, de_carpeta, de_zip, limpio, tipo

# «Ana García_1234_assignsubmission_file_», una carpeta; desde Moodle 4.1, sin el último _; y, si no se descargan en
# carpetas, «…_file_grua.cpp». Un grupo sin nombre no tiene número.
MOODLE = re.compile(
    r"(?P<quien>[^/]+?)(?:_(?P<numero>\d+))?_assignsubmission_(?P<que>file|onlinetext)(?:_(?P<resto>.*))?"
)


def de_moodle(nombre):
    """Quién es, su número y lo demás de un nombre de Moodle, o None."""
    return MOODLE.fullmatch(unicodedata.normalize("NFC", nombre))


def reparte(rutas):
    """De unas rutas en partes, {su carpeta: [(ruta dentro, cuál es)]} de cada uno: son las carpetas de fuera, cuando no
    están todas en una, o lo que tenga un nombre de Moodle. Vacío, si es lo de uno solo."""
    while rutas and len({r[0] for r in rutas}) == 1 and all(len(r) > 1 for r in rutas) and not de_moodle(rutas[0][0]):
        rutas = [r[1:] for r in rutas]
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
    """Como entrega.busca, y además un .zip y lo que descarga Moodle."""
    fichero = Path(pedida).absolute()
    if tipo(pedida) == ".zip" and fichero.is_file():
        hay = en_zip(fichero)
        suyas = subidas(hay)
        return (fichero.with_suffix(""), suyas, []) if suyas else (Subida(fichero.stem, hay), None, [])
    carpeta, dentro, sueltos = entrega.busca(mios, pedida, fuera)
    if carpeta.is_dir() and not (carpeta / nuevo.EJERCICIO).is_file():
        suyas = subidas(de_carpeta(carpeta, CLASE, HONDO + 2))
        if suyas and all(de_moodle(s.name) for s in suyas):
            return carpeta, suyas, []
    return carpeta, dentro, sueltos
