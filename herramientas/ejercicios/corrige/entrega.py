"""Lo que entrega un estudiante, que no es de fiar: se lee con cuidado, y hasta un límite."""
import itertools
import os
import re
import stat
from pathlib import Path

from base.procesos import Fallo

FUENTES = ".cpp", ".h", ".vert", ".frag", ".glsl"
FICHEROS, BYTES = 40, 1 << 20  # de una entrega, y de cada fichero


class Rechazo(Exception):
    """Por qué no se puede ni probar una entrega; y, si es el compilador, todo lo que dice."""

    def __init__(self, por, todo=""):
        super().__init__(por)
        self.todo = todo


def lee_fichero(carpeta, nombre):
    """Un fichero corriente y corto de otro: ni enlaces, ni tuberías, ni dispositivos."""
    try:
        f = os.open(nombre, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC, dir_fd=carpeta)
    except OSError as error:
        raise Rechazo(
            f"no se puede leer «{nombre}»: es un enlace o no hay permiso" if error.errno else str(error)
        ) from None
    with open(f, "rb") as fichero:
        if not stat.S_ISREG(os.fstat(f).st_mode):
            raise Rechazo(f"«{nombre}» no es un fichero corriente")
        datos = fichero.read(BYTES + 1)
    if len(datos) > BYTES:
        raise Rechazo(f"«{nombre}» pasa de {BYTES >> 20} MiB")
    return datos


def es_fuente(nombre):
    return re.fullmatch(r"\w[\w.-]*", nombre, re.A) and nombre.endswith(FUENTES)


def lee_entrega(carpeta):
    """{nombre: contenido} de los fuentes de una entrega; lo demás que haya en su carpeta no se mira."""
    try:
        f = os.open(carpeta, os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW | os.O_CLOEXEC)
    except OSError:
        raise Rechazo("no es una carpeta que se pueda leer") from None
    try:
        with os.scandir(f) as hay:
            nombres = sorted(e.name for e in itertools.islice(hay, 1000) if es_fuente(e.name))
        if len(nombres) > FICHEROS:
            raise Rechazo(f"son más de {FICHEROS} ficheros")
        ficheros = {nombre: lee_fichero(f, nombre) for nombre in nombres}
    finally:
        os.close(f)
    if not any(nombre.endswith(".cpp") for nombre in ficheros):
        raise Rechazo("no hay ningún .cpp")
    return ficheros


def busca(mios, entrega):
    """Su carpeta, que puede estar en MIOS, y, si es una clase, las de dentro."""
    carpeta = next((c for c in (mios / entrega, Path(entrega)) if c.is_dir()), None)
    if not carpeta:
        raise Fallo(f"no hay ninguna carpeta «{entrega}», ni mios/{entrega}")
    carpeta = carpeta.absolute()
    if any(f.suffix == ".cpp" for f in carpeta.iterdir()):
        return carpeta, None
    dentro = sorted(c for c in carpeta.iterdir() if (c.is_dir() or c.is_symlink()) and not c.name.startswith("."))
    return carpeta, dentro or None
