"""Leer lo que entrega un estudiante, que no es de fiar: una carpeta o los .zip y .tar que haya en ella. De cada
fichero se da su ruta, en partes, y una función que lo lee hasta un límite o dice por qué no se puede; se leen los que
sirven, también hasta un límite. Lo demás, aunque no se pueda leer, no estorba."""
import functools
import gzip
import io
import itertools
import os
import re
import stat
import tarfile
import threading
import unicodedata
import zipfile
from collections import deque
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import PurePath

from base.procesos import Fallo
from ejercicios import nuevo

COMPILADOS = ".cpp", ".cc", ".cxx", ".c++"
CODIGO = *COMPILADOS, ".h", ".hpp", ".hh", ".hxx", ".inl", ".inc", ".c", ".vert", ".frag", ".geom", ".glsl"
FUENTES = *CODIGO, ".vf"
ABIERTOS = ".zip", ".tar", ".tgz"
COMPRIMIDOS = ".rar", ".7z", ".gz", ".xz", ".bz2"
FICHEROS, BYTES, TODO = 400, 1 << 20, 16 << 20  # los que se leen de una entrega; los bytes de cada uno, y de todos
HAY, HONDO = 5000, 6  # lo que se mira de una carpeta, y hasta dónde se baja
COMPRIMIDO, DENTRO = 64 << 20, 3  # bytes de todos los .zip de una entrega, y cuántos, uno dentro de otro
CLASE = 200_000  # ficheros de un .zip con los de todos; de uno de una entrega, la cuarta parte
LETRAS = 300
# Lo que dejan en una carpeta git, macOS, un editor, quien compila o nosotros.
BASURA = re.compile(
    r"\..*|.*~|__MACOSX|correccion|CMakeFiles|cmake-build-.*|_deps|node_modules|build|out|x64|debug|release",
    re.I | re.S,
)


ESPANOL = set("áéíóúüñçàèòïÁÉÍÓÚÜÑÇÀÈÒÏºª·¿¡")
ENTRADA = b"PK\x01\x02"  # con que empieza cada fichero en el índice de un .zip
GZIP = b"\x1f\x8b"  # y cualquier cosa comprimida con gzip
TURNO = threading.Lock()  # un .zip no lo pueden leer varios a la vez


class Rechazo(Exception):
    """Por qué no se puede ni probar una entrega; y, si es el compilador, todo lo que dice."""

    def __init__(self, por, todo=""):
        super().__init__(por)
        self.todo = todo


def limpio(texto):
    """Lo que viene de otro, en una línea corta y sin caracteres de control: ni borra la terminal en que se lee, ni
    parte una línea, ni llena una celda."""
    texto = "".join(letra if letra.isprintable() else " " for letra in texto[: 4 * LETRAS])
    texto = " ".join(texto.split())
    return texto if len(texto) <= LETRAS else texto[: LETRAS - 1] + "…"


def basura(nombre):
    return bool(BASURA.fullmatch(nombre))


def tipo(nombre):
    return PurePath(nombre).suffix.lower()


def legible(nombre):
    """Con los acentos como se escriben aquí, aunque los de un Mac se hayan leído por el camino en cp437: Garci╠üa."""
    with suppress(UnicodeError):
        nombre = nombre.encode("cp437").decode()
    return unicodedata.normalize("NFC", nombre)


def limpia(ruta):
    return "/".join(map(limpio, ruta))


def en_utf8(datos):
    """Un fuente que otro guardó como lo hacía su editor."""
    if datos[:2] in (b"\xff\xfe", b"\xfe\xff"):
        return datos.decode("utf-16").encode()
    if b"\0" in datos:
        raise ValueError
    try:
        datos.decode()
        return datos
    except UnicodeDecodeError:
        return datos.decode("cp1252", "replace").encode()


# --- lo que hay en una carpeta ---


def lee_fichero(carpeta, *ruta, limite=BYTES):
    """Un fichero corriente y corto de otro: ni enlaces, ni tuberías, ni dispositivos."""
    visto = limpio(ruta[-1])
    try:
        f = os.open(carpeta.joinpath(*ruta), os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC)
    except OSError:
        raise Rechazo(f"no se puede leer «{visto}»: es un enlace o no hay permiso") from None
    with open(f, "rb") as fichero:
        if not stat.S_ISREG(os.fstat(f).st_mode):
            raise Rechazo(f"«{visto}» no es un fichero corriente")
        datos = fichero.read(limite + 1)
    return corto(datos, visto, limite)


def corto(datos, visto, limite=BYTES):
    if len(datos) > limite:
        raise Rechazo(f"«{visto}» pasa de {limite >> 20} MiB")
    return datos


def de_carpeta(carpeta, cuantos=HAY, hondo=HONDO):
    """(ruta, cómo se lee) de cada fichero, sin salir de ella, antes lo de fuera que lo de dentro."""
    if carpeta.is_symlink() or not os.access(carpeta, os.R_OK | os.X_OK):
        raise Rechazo("no es una carpeta que se pueda leer")
    por_ver, vistos = deque([()]), 0
    while por_ver and vistos < cuantos:
        ruta = por_ver.popleft()
        try:
            with os.scandir(carpeta.joinpath(*ruta)) as hay:
                suyas = ((e.name, e.is_dir(follow_symlinks=False)) for e in itertools.islice(hay, cuantos - vistos))
                dentro = sorted(e for e in suyas if not basura(e[0]))
        except OSError:
            continue
        vistos += len(dentro)
        por_ver += [(*ruta, nombre) for nombre, es_carpeta in dentro if es_carpeta and len(ruta) < hondo]
        for nombre, es_carpeta in dentro:
            if not es_carpeta:
                yield (*ruta, nombre), functools.partial(lee_fichero, carpeta, *ruta, nombre)


# --- lo que hay en un .zip ---


def nombre_de(miembro):
    """Cómo se llama en un .zip: en UTF-8 o, si es de los de antes, en lo que usaba cada sistema, que no se dice."""
    nombre = miembro.filename
    if not miembro.flag_bits & 0x800:
        with suppress(UnicodeEncodeError):  # lo ha leído ya en otra cosa
            crudo = nombre.encode("cp437")
            como = "utf-8", "cp437", "cp850", "cp1252"
            posibles = [unicodedata.normalize("NFC", crudo.decode(c, "replace")) for c in como]
            nombre = max(posibles, key=lambda n: sum(c in ESPANOL for c in n) - 9 * n.count("\ufffd"))
    return legible(nombre if "/" in nombre else nombre.replace("\\", "/"))


@contextmanager
def cuidado(nombre):
    """Mientras se lee un .zip: lo que salga mal es de quien lo entrega."""
    try:
        yield
    except (Rechazo, Fallo):
        raise
    except Exception:  # pylint: disable=broad-except  # estropeado, puede ser de cualquier manera
        raise Rechazo(f"«{limpio(nombre)}» no se puede abrir: está estropeado, o no es lo que dice ser") from None


def lee_miembro(z, miembro, visto, limite=BYTES):
    modo = stat.S_IFMT(miembro.external_attr >> 16)
    if modo == stat.S_IFLNK:
        raise Rechazo(f"no se puede leer «{visto}»: es un enlace o no hay permiso")
    if modo not in (0, stat.S_IFREG):
        raise Rechazo(f"«{visto}» no es un fichero corriente")
    if miembro.flag_bits & 1:
        raise Rechazo(f"«{visto}» está en un .zip con contraseña")
    with TURNO, cuidado(visto), z.open(miembro) as f:
        return corto(f.read(limite + 1), visto, limite)


def de_zip(z, debajo=()):
    """Lo mismo que de_carpeta; de lo que tiene una ruta que sale de su carpeta, al leerlo se dice."""
    for miembro in z.infolist():
        if not miembro.is_dir():
            yield from de_dentro(nombre_de(miembro), functools.partial(lee_miembro, z, miembro), debajo)


def de_dentro(nombre, lee, debajo):
    ruta = tuple(p for p in nombre.split("/") if p not in ("", ".", ".."))
    if nombre.startswith("/") or ".." in nombre.split("/") or ruta and ruta[0][1:2] == ":":
        lee = functools.partial(no_se_lee, f"en lo comprimido hay una ruta que sale de su carpeta: «{limpio(nombre)}»")
    if ruta:
        yield (*debajo, *ruta), functools.partial(lee, limpio(ruta[-1]))


def de_tar(datos, debajo=()):
    """Y lo de un .tar, que ya está en memoria: los ficheros corrientes."""
    with tarfile.open(fileobj=io.BytesIO(datos), mode="r:") as t:
        for miembro in itertools.islice(t, CLASE // 4):
            if miembro.isreg() and not miembro.issparse():  # lo que no está escrito puede ser enorme
                suyos = datos[miembro.offset_data : miembro.offset_data + miembro.size]
                if len(suyos) < miembro.size:
                    raise ValueError("está cortado")
                yield from de_dentro(miembro.name, functools.partial(corto, suyos), debajo)


def sin_comprimir(datos, nombre):
    """Un .zip o un .tar; de uno comprimido, que muchos también llaman .tar, hasta un límite."""
    if tipo(nombre) == ".zip" or not datos.startswith(GZIP):
        return datos
    with cuidado(nombre), gzip.open(io.BytesIO(datos)) as f:
        return corto(f.read(COMPRIMIDO + 1), limpio(nombre), COMPRIMIDO)


def no_se_lee(por, *_, **__):
    raise Rechazo(por)


# --- lo que sirve de ello ---


@dataclass(eq=False)
class Subida:
    """Lo de uno que no es una carpeta del disco: la ruta de cada fichero y cómo se lee."""

    name: str
    entradas: list


def entradas(que):
    if isinstance(que, Subida):
        return que.entradas
    return [((que.name,), functools.partial(lee_fichero, que.parent, que.name))] if que.is_file() else de_carpeta(que)


class Lector:
    """Los fuentes de una entrega; de lo que no se puede leer, por qué. DE_OTRO: si una ruta es de algo que ya está
    aquí."""

    def __init__(self, que, de_otro=lambda ruta: False):
        self.de_otro = de_otro
        self.hay, self.fuentes, self.zips, self.comprimidos = [], [], [], 0  # nombres; (ruta, cómo se lee)
        self.leidos, self.mal, self.bytes, self.traducidos = {}, {}, 0, []
        self.con_txt, self.abiertos = [], []
        self.mira(entradas(que))
        for _ in range(DENTRO):  # si hay fuentes fuera de ellos, no: quien sube las dos cosas no entrega dos veces
            if not any(tipo(ruta[-1]) in CODIGO for ruta, _ in self.fuentes):
                self.abre_zips()

    def mira(self, hay):
        for ruta, lee in hay:
            ruta = tuple(map(legible, ruta))
            nombre = ruta[-1]
            if any(map(basura, ruta)) or len(ruta) > HONDO + 1:
                continue
            if tipo(nombre) in ABIERTOS or nombre.lower().endswith(".tar.gz"):
                self.zips.append((ruta, lee))
                continue
            self.hay.append(nombre)
            if tipo(nombre) == ".txt" and tipo(nombre[:-4]) in FUENTES:  # Windows lo pone, y no lo enseña
                ruta = (*ruta[:-1], nombre[:-4])
                self.con_txt.append(ruta)
                self.fuentes.insert(0, (ruta, lee))  # si también está sin él, vale ese
            elif tipo(nombre) in FUENTES or nombre == nuevo.EJERCICIO:
                self.fuentes.append((ruta, lee))

    def abre_zips(self):
        por_abrir, self.zips = self.zips, []
        for ruta, lee in por_abrir:
            nombre = PurePath(ruta[-1])
            try:
                datos = sin_comprimir(lee(limite=COMPRIMIDO), nombre.name)
                self.comprimidos += len(datos)
                if self.comprimidos > COMPRIMIDO:
                    raise Rechazo(f"entre todos los comprimidos pasan de {COMPRIMIDO >> 20} MiB")
                if datos.count(ENTRADA) > CLASE // 4:
                    raise Rechazo(f"en «{limpio(nombre.name)}» hay más de {CLASE // 4} ficheros")
                debajo = (*ruta[:-1], "zip" if basura(nombre.stem) else nombre.stem)
                with cuidado(nombre.name):
                    es_zip = tipo(nombre.name) == ".zip"
                    self.mira(de_zip(zipfile.ZipFile(io.BytesIO(datos)), debajo) if es_zip else de_tar(datos, debajo))
                    self.abiertos += [] if es_zip else [nombre.name]
            except Rechazo as por:
                self.mal[limpia(ruta)] = str(por)

    def lee_los_de(self, ref):
        """Los fuentes; si hay carpetas de varios ejercicios y una es del que se pide, sin los de las otras. De qué
        ejercicio dice que es."""
        for ruta, lee in self.fuentes:
            if ruta[-1] == nuevo.EJERCICIO:
                self.lee(ruta, lee)
        textos = {r: self.leidos.pop(r).decode(errors="replace").split() for r in [*self.leidos]}
        dichos = {r[: -len(nuevo.EJERCICIO)]: limpio(que[0]) for r, que in textos.items() if len(que) > 1}
        de_otros = [c for c, dice in dichos.items() if dice != ref] if ref in dichos.values() else []
        for ruta, lee in self.fuentes:
            es_suyo = ruta[-1] != nuevo.EJERCICIO and not any(limpia(ruta).startswith(c) for c in de_otros)
            if es_suyo and not self.de_otro("/".join(ruta)):
                self.lee(ruta, lee)
        versiones = [que[-1] for que in textos.values() if len(que) > 3 and limpio(que[0]) == ref]
        self.version = versiones[0] if versiones else ""
        return ref if ref in dichos.values() else next(iter(dichos.values()), "")

    def lee(self, ruta, lee):
        escrita, nombre = limpia(ruta), ruta[-1]
        choca = lambda otra: otra.startswith(f"{escrita}/") or escrita.startswith(f"{otra}/")
        try:
            if len(self.leidos) == FICHEROS or self.bytes > TODO:
                raise Rechazo(f"son más de {FICHEROS} ficheros, o de {TODO >> 20} MiB entre todos")
            if len(os.fsencode(nombre)) > 255 or any(map(choca, self.leidos)):
                raise Rechazo(f"«{limpio(escrita)}» no se puede poner en una carpeta")
            datos = lee()
            self.bytes += len(datos)
            if tipo(nombre) in CODIGO:
                crudos, datos = datos, en_utf8(datos)
                self.traducidos += [nombre] if crudos != datos else []
            self.leidos[escrita] = datos
            self.mal.pop(escrita, None)  # en un .zip puede estar dos veces: vale la última
        except Rechazo as por:
            self.mal[escrita] = str(por)
        except ValueError:
            self.mal[escrita] = f"«{limpio(nombre)}» no es un texto en UTF-8: guárdalo así en el editor"

    @property
    def avisos(self):
        """Lo que se ha hecho para leerla, que no lo pide nadie."""
        rutas = [ruta for ruta, _ in self.fuentes]
        con_txt = [ruta[-1] for ruta in self.con_txt if rutas.count(ruta) == 1]
        return [
            *(f"no está en UTF-8, y se ha traducido: {limpio(f)}" for f in self.traducidos[:1]),
            *(f"se llama {limpio(f)}.txt, y se ha leído como {limpio(f)}" for f in con_txt[:1]),
            *(f"se ha abierto «{limpio(f)}»: entrégalo sin comprimir o en un .zip" for f in self.abiertos[:1]),
        ]

    def por_que_no_hay(self):
        if self.mal:
            return next(iter(self.mal.values()))
        sin_abrir = [ruta[-1] for ruta, _ in self.zips]
        if comprimido := next((n for n in [*sin_abrir, *self.hay] if tipo(n) in (*ABIERTOS, *COMPRIMIDOS)), None):
            return f"no hay ningún fuente: hay un «{limpio(comprimido)}» sin descomprimir"
        hay = ", ".join(limpio(nombre) for nombre in sorted(self.hay)[:3])
        return f"no hay ningún fuente: hay {hay}" if hay else "no hay nada en su carpeta"
