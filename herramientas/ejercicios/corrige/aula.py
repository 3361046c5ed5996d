"""Lo que da una plataforma: una carpeta o un .zip con lo de todos, como los descarga Moodle, y dentro, lo que subió
cada uno, que puede ser otro .zip. Nada de lo que hay en él es de fiar: de un .zip solo salen ficheros corrientes de
los que se leen, a una carpeta temporal, y hasta un límite."""
import itertools
import os
import re
import stat
import tempfile
import threading
import unicodedata
import zipfile
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from base.procesos import Fallo
from ejercicios import nuevo
from ejercicios.corrige import entrega
from ejercicios.corrige.entrega import BYTES, CODIGO, FUENTES, HAY, HONDO, Rechazo, basura, limpio, tipo

# «Ana García_1234_assignsubmission_file_», una carpeta; desde Moodle 4.1, sin el último _; y, si no se descargan en
# carpetas, «…_file_grua.cpp». Un grupo sin nombre no tiene número.
MOODLE = re.compile(
    r"(?P<quien>[^/]+?)(?:_(?P<numero>\d+))?_assignsubmission_(?P<que>file|onlinetext)(?:_(?P<resto>.*))?"
)
COMPRIMIDO = 64 << 20  # bytes de un .zip, y de todo lo que sale de los de una entrega
DENTRO = 2  # .zip dentro de otro
CLASE = 200_000  # ficheros de un .zip con los de todos
ESPANOL = set("áéíóúüñçàèòïÁÉÍÓÚÜÑÇÀÈÒÏºª·¿¡")
ENTRADA = b"PK\x01\x02"  # con que empieza cada fichero en el índice de un .zip


def nombre_de(miembro):
    """Cómo se llama en un .zip: en UTF-8 o, si es de los de antes, en lo que usaba cada sistema, que no se dice."""
    nombre = miembro.filename
    if not miembro.flag_bits & 0x800:
        try:
            crudo = nombre.encode("cp437")
            como = "utf-8", "cp437", "cp850", "cp1252"
            posibles = [unicodedata.normalize("NFC", crudo.decode(c, "replace")) for c in como]
            nombre = max(posibles, key=lambda n: sum(c in ESPANOL for c in n) - 9 * n.count("\ufffd"))
        except UnicodeEncodeError:  # lo ha leído ya en otra cosa
            pass
    return unicodedata.normalize("NFC", nombre if "/" in nombre else nombre.replace("\\", "/"))


def partes(nombre):
    """Las de una ruta de un .zip, que no puede salir de donde se pone."""
    todas = [p for p in nombre.split("/") if p not in ("", ".")]
    if nombre.startswith("/") or ".." in todas or any(":" in p[1:2] for p in todas[:1]):
        raise Rechazo(f"en el .zip hay una ruta que sale de su carpeta: «{limpio(nombre)}»")
    return todas


def de_moodle(nombre):
    """Quién es, su número y lo demás de un nombre de Moodle, o None."""
    return MOODLE.fullmatch(unicodedata.normalize("NFC", nombre))


@dataclass(eq=False)
class Subida:
    """Lo de uno que no es una carpeta del disco: de cada fichero, su ruta y cómo se pone en una, mientras se lee."""

    name: str
    ficheros: list
    mal: str = ""  # por qué no se puede ni mirar


# --- descomprimir ---


class Extractor:
    """Pone en una carpeta lo que se lee de una entrega, hasta un límite entre todos sus .zip; de lo que no se puede,
    por qué."""

    def __init__(self, carpeta):
        self.carpeta, self.cuantos, self.bytes, self.comprimidos, self.mal = carpeta, 0, 0, [], {}

    def pon(self, ruta, abre):
        """Un fichero; de lo que no se lee, solo su nombre. RUTA, en partes."""
        if not ruta or any(map(basura, ruta)) or len(ruta) > HONDO + 1:
            return
        try:
            self.escribe(self.carpeta.joinpath(*ruta), abre)
        except (OSError, ValueError):
            self.mal["/".join(ruta)] = f"«{limpio('/'.join(ruta))}» no se puede poner en una carpeta"
        except Rechazo as por:
            self.mal["/".join(ruta)] = str(por)

    def escribe(self, sitio, abre):
        es_zip = tipo(sitio.name) == ".zip"
        se_lee = es_zip or tipo(sitio.name) in FUENTES or sitio.name == nuevo.EJERCICIO
        self.cuantos += 1
        if self.cuantos > HAY:
            if not se_lee:
                return
            raise Rechazo(f"hay más de {HAY} ficheros")
        datos, limite = b"", COMPRIMIDO if es_zip else BYTES
        if se_lee:
            with cuidado(sitio.name), abre() as f:
                datos = f.read(limite + 1)
            self.bytes += len(datos)
            if len(datos) > limite:
                raise Rechazo(f"«{limpio(sitio.name)}» pasa de {limite >> 20} MiB")
            if self.bytes > COMPRIMIDO:
                raise Rechazo(f"entre todos los ficheros pasan de {COMPRIMIDO >> 20} MiB")
        sitio.parent.mkdir(parents=True, exist_ok=True)
        sitio.write_bytes(datos)
        if es_zip:
            self.comprimidos.append(sitio)

    def abre_zips(self, dentro=0):
        """Los que haya, si no hay fuentes fuera de ellos: quien sube las dos cosas no entrega dos veces."""
        if any(tipo(f.name) in CODIGO for f in self.carpeta.rglob("*")):
            return
        por_abrir, self.comprimidos = self.comprimidos, []
        for fichero in por_abrir:
            try:
                with cuidado(fichero.name):
                    self.abre_zip(fichero)
            except Rechazo as por:
                self.mal[fichero.name] = str(por)
            fichero.unlink()
        if self.comprimidos and dentro < DENTRO:
            self.abre_zips(dentro + 1)

    def abre_zip(self, fichero):
        if fichero.read_bytes().count(ENTRADA) > CLASE // 4:
            raise Rechazo(f"en «{limpio(fichero.name)}» hay más de {CLASE // 4} ficheros")
        debajo = *fichero.relative_to(self.carpeta).parts[:-1], "zip" if basura(fichero.stem) else fichero.stem
        with zipfile.ZipFile(fichero) as z:
            for miembro in z.infolist():
                try:
                    self.saca(z, miembro, (*debajo, *partes(nombre_de(miembro))))
                except Rechazo as por:
                    self.mal[nombre_de(miembro)] = str(por)

    def saca(self, z, miembro, ruta):
        """Un miembro de un .zip."""
        if miembro.is_dir() or not ruta or any(map(basura, ruta)):
            return
        nombre = limpio(ruta[-1])
        modo = stat.S_IFMT(miembro.external_attr >> 16)
        if modo not in (0, stat.S_IFREG):
            if tipo(nombre) in FUENTES or nombre == nuevo.EJERCICIO:
                enlace = f"no se puede leer «{nombre}»: es un enlace o no hay permiso"
                self.mal["/".join(ruta)] = enlace if modo == stat.S_IFLNK else f"«{nombre}» no es un fichero corriente"
        elif miembro.flag_bits & 1:
            self.mal["/".join(ruta)] = f"«{nombre}» está en un .zip con contraseña"
        else:
            self.pon(ruta, lambda: z.open(miembro))


@contextmanager
def cuidado(nombre):
    """Mientras se lee un .zip: lo que salga mal es de quien lo entrega."""
    try:
        yield
    except (Rechazo, Fallo):
        raise
    except Exception:  # pylint: disable=broad-except  # estropeado, puede ser de cualquier manera
        raise Rechazo(f"«{limpio(nombre)}» no se puede abrir: está estropeado, o no es un .zip") from None


def zips(carpeta, hondo=HONDO):
    """Los .zip de una carpeta en que no hay ningún fuente."""
    hallados = []
    try:
        with os.scandir(carpeta) as entradas:
            for e in itertools.islice(entradas, HAY):
                if basura(e.name) or e.is_symlink():
                    continue
                if e.is_dir() and hondo:
                    dentro = zips(e.path, hondo - 1)
                    if dentro is None:
                        return None
                    hallados += dentro
                elif tipo(e.name) in CODIGO:
                    return None
                elif tipo(e.name) == ".zip" and e.is_file() and e.stat().st_size:
                    hallados.append(Path(e.path))
    except OSError:  # ya lo dirá quien la lea
        return None
    return hallados


def suelto(fichero):
    """Cómo se pone uno del disco, que no se sigue si es un enlace."""

    def abre():
        try:
            f = open(os.open(fichero, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC), "rb")
        except OSError:
            raise Rechazo(f"no se puede leer «{limpio(fichero.name)}»: es un enlace o no hay permiso") from None
        if not stat.S_ISREG(os.fstat(f.fileno()).st_mode):
            f.close()
            raise Rechazo(f"«{limpio(fichero.name)}» no es un fichero corriente")
        return f

    return lambda extractor, ruta: extractor.pon(ruta, abre)


@contextmanager
def abierta(que, temporal):
    """La carpeta en que está lo de uno, la suya o, si viene en un .zip, otra mientras se lee; y lo que de él no se
    puede leer, con su porqué."""
    if not isinstance(que, Subida):
        hay = zips(que)
        if not hay:
            yield que, {}
            return
        que = Subida(que.name, [(f.relative_to(que).parts, suelto(f)) for f in hay])
    if que.mal:
        raise Rechazo(que.mal)
    with tempfile.TemporaryDirectory(dir=temporal) as aqui:
        carpeta = Path(aqui, que.name if que.name.isprintable() and len(os.fsencode(que.name)) <= 200 else "entrega")
        carpeta.mkdir()
        extractor = Extractor(carpeta)
        for ruta, pon in que.ficheros:
            with cuidado(ruta[-1] if ruta else que.name):
                pon(extractor, ruta)
        extractor.abre_zips()
        yield carpeta, extractor.mal


# --- qué hay en lo que se da ---


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


def de_zip(fichero):
    """Lo de cada uno en un .zip, y si es de una clase o lo de uno solo."""
    try:
        z = zipfile.ZipFile(fichero)
        miembros = [m for m in z.infolist() if not m.is_dir()]
    except Exception:  # pylint: disable=broad-except  # estropeado, puede ser de cualquier manera
        raise Fallo(f"«{limpio(fichero.name)}» no se puede abrir: está estropeado, o no es un .zip") from None
    if len(miembros) > CLASE:
        raise Fallo(f"en «{limpio(fichero.name)}» hay más de {CLASE} ficheros")
    turno = threading.Lock()  # no lo pueden leer varios a la vez

    def pone(miembro):
        def pon(extractor, ruta):
            with turno:
                extractor.saca(z, miembro, ruta)

        return pon

    rutas, sirven, mal = [], [], {}
    for m in miembros:
        try:
            ruta = partes(nombre_de(m))
        except Rechazo as rechazo:  # de quién es, si se sabe
            ruta = [p for p in nombre_de(m).split("/") if p not in ("", ".", "..")]
            mal[len(rutas)] = str(rechazo)
        if ruta and not any(map(basura, ruta)):
            rutas.append(tuple(ruta))
            sirven.append(m)
    de_cada_uno = reparte(rutas)
    es_clase = bool(de_cada_uno)
    subidas = [
        Subida(nombre, [(ruta, pone(sirven[i])) for ruta, i in suyos], next((mal[i] for _, i in suyos if i in mal), ""))
        for nombre, suyos in sorted((de_cada_uno or {fichero.stem: [(r, i) for i, r in enumerate(rutas)]}).items())
    ]
    return subidas, es_clase


def de_carpeta(carpeta):
    """Lo de cada uno en una carpeta con nombres de Moodle, o en la única que haya dentro; nada, si no los tiene."""
    while True:
        aqui = sorted(f for f in carpeta.iterdir() if not basura(f.name))
        if any(de_moodle(f.name) for f in aqui):
            break
        if len(aqui) != 1 or not aqui[0].is_dir() or aqui[0].is_symlink():
            return []
        carpeta = aqui[0]
    de_cada_uno, hay = {}, []
    for f in aqui:
        if m := de_moodle(f.name):
            de_cada_uno.setdefault((m["quien"], m["numero"]), []).append((f, m))
    for suyos in de_cada_uno.values():
        carpetas = [f for f, m in suyos if f.is_dir() and not f.is_symlink()]
        if carpetas:  # la de lo que escribió en la web no tiene fuentes
            hay.append(next((f for f in carpetas if "_assignsubmission_file" in f.name), carpetas[0]))
            continue
        nombre = suyos[0][0].name.removesuffix(suyos[0][1]["resto"] or "")
        hay.append(Subida(nombre, [((m["resto"] or f.name,), suelto(f)) for f, m in suyos]))
    return sorted(hay, key=lambda que: que.name)


def busca(mios, pedida, fuera=None):
    """Como entrega.busca, y además un .zip y lo que descarga Moodle."""
    fichero = Path(pedida).absolute()
    if tipo(pedida) == ".zip" and fichero.is_file():
        subidas, es_clase = de_zip(fichero)
        return (fichero.with_suffix(""), subidas, []) if es_clase else (subidas[0], None, [])
    carpeta, dentro, sueltos = entrega.busca(mios, pedida, fuera)
    hay = [] if carpeta.is_file() or (carpeta / nuevo.EJERCICIO).is_file() else de_carpeta(carpeta)
    return (carpeta, hay, []) if hay else (carpeta, dentro, sueltos)
