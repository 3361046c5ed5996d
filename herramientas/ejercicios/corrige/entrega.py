"""Lo que entrega un estudiante, que no es de fiar: se lee con cuidado y hasta un límite, y de lo que hay se corrige un
programa con lo que alcanza. Lo demás, aunque no se pueda leer, no estorba: se avisa."""
import itertools
import os
import re
import stat
from collections import deque
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field
from pathlib import Path, PurePath

from base.fuentes import SHADERS
from base.procesos import Fallo
from ejercicios import nuevo

COMPILADOS = ".cpp", ".cc", ".cxx", ".c++"
CODIGO = *COMPILADOS, ".h", ".hpp", ".hh", ".hxx", ".inl", ".inc", ".c", ".vert", ".frag", ".geom", ".glsl"
FUENTES = *CODIGO, ".vf"
COMPRIMIDOS = ".zip", ".rar", ".7z", ".gz", ".tar", ".tgz"
FICHEROS, BYTES, TODO = 400, 1 << 20, 16 << 20  # los que se leen de una entrega; los bytes de cada uno, y de todos
HAY, HONDO = 5000, 6  # lo que se mira de una carpeta, y hasta dónde se baja
PROGRAMAS = 3  # con main, que se intentan
LETRAS = 300
MAIN = re.compile(rb"\bmain\s*\(")
INCLUYE = re.compile(rb'^[ \t]*#[ \t]*include[ \t]+"([^"\n]+)"', re.M)
COMENTARIO = re.compile(rb"//[^\n]*|/\*.*?\*/", re.S)
# Lo que dejan en una carpeta git, macOS, un editor, quien compila o nosotros.
BASURA = re.compile(
    r"\..*|.*~|__MACOSX|correccion|CMakeFiles|cmake-build-.*|_deps|node_modules|build|out|x64|debug|release",
    re.I | re.S,
)


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


# --- lo que alcanza un programa ---


def tallo(fichero):
    return PurePath(fichero).stem.lower()


class Alcance:
    """Quién incluye a quién en una entrega. Vale el nombre, esté en la carpeta que esté, que se busca en todas."""

    def __init__(self, ficheros):
        crudos = {f: c if isinstance(c, bytes) else c.encode() for f, c in ficheros.items()}
        self.nombra = {
            f: {n.decode(errors="replace").rpartition("/")[2] for n in INCLUYE.findall(c)} for f, c in crudos.items()
        }
        self.de = {}
        for f in ficheros:
            self.de.setdefault(PurePath(f).name, []).append(f)
        incluidos = {otro for f in ficheros for n in self.nombra[f] for otro in self.de.get(n, ()) if otro != f}
        self.se_compilan = [f for f in ficheros if tipo(f) in COMPILADOS and f not in incluidos]
        self.con_main = [f for f in self.se_compilan if MAIN.search(COMENTARIO.sub(b"", crudos[f]))]
        self.sin_main = [f for f in self.se_compilan if f not in self.con_main]

    def desde(self, *fuentes):
        """Esos, lo que incluyen, y así con cada uno."""
        vistos, por_ver = set(), [*fuentes]
        while por_ver:
            uno = por_ver.pop()
            if uno not in vistos:
                vistos.add(uno)
                por_ver += (otro for nombre in self.nombra[uno] for otro in self.de.get(nombre, ()))
        return vistos

    def con_los_suyos(self, principal):
        """Y, de los que no tienen main, los que tienen que ver con él: incluyen una cabecera que él alcanza, o se
        llaman como ella."""
        de_cada_uno = {f: self.desde(f) - {f} for f in self.sin_main}
        suyos, alcanzados, antes = [principal], self.desde(principal), None
        while suyos != antes:
            antes, tallos = [*suyos], {tallo(f) for f in alcanzados if tipo(f) not in COMPILADOS}
            suyos += [f for f in de_cada_uno if f not in suyos and (tallo(f) in tallos or alcanzados & de_cada_uno[f])]
            alcanzados = self.desde(*suyos)
        return suyos


@dataclass
class Entrega:
    ficheros: dict  # {ruta desde su carpeta: contenido}
    llamadas: tuple = ()  # cómo se llaman sus carpetas: el fuente que se llame así es el que abre ./lab ver
    ejercicio: str = ""  # el que dice que es
    mal: dict = field(default_factory=dict)  # de lo que no se ha podido leer, por qué
    avisos: list = field(default_factory=list)
    intentos: list = field(default_factory=list)  # qué fuentes se compilan; si no se puede con unos, con los otros

    def completa(self, de_partida, principal):
        """Qué se compila, y lo que no viene, del esqueleto: el programa, si no hay ninguno, y cada fichero que no se
        llame igual. Si no hay principal, es que se piden unos shaders, y solo son ellos."""
        if not principal:
            return self.solo_los_de(de_partida)
        hay_programa_ = any(tipo(f) in COMPILADOS for f in self.ficheros)
        for fichero, texto in de_partida.items():
            if fichero != principal or not hay_programa_:
                self.pon_de_partida(fichero, texto)
        self.alcance = Alcance(self.ficheros)
        self.elige(de_partida, principal)
        self.mira_lo_que_falta()

    def pon_de_partida(self, fichero, texto):
        suyos = {PurePath(f).name: f for f in self.ficheros}
        sin_mayusculas = {nombre.lower(): f for nombre, f in suyos.items()}
        if fichero in suyos:
            return
        if otro := sin_mayusculas.get(fichero.lower()):
            self.ficheros[fichero] = self.ficheros[otro]
            return
        for ruta, por in self.mal.items():
            if PurePath(ruta).name.lower() == fichero.lower() or {tipo(ruta), tipo(fichero)} <= {*COMPILADOS}:
                raise Rechazo(por)
        self.ficheros[fichero] = texto.encode()
        self.avisos.append(f"no viene {fichero}: se ha puesto el de partida")

    def elige(self, de_partida, principal):
        """De los que tienen main, antes el que se llama como su carpeta o como el programa, el que es de este ejercicio
        y el que no es una copia de otro; y con cada uno, lo suyo, todo lo que no tiene main o nada más."""
        nombres = [n.lower() for n in (*self.llamadas, PurePath(principal).stem)]
        lineas = {*filter(None, map(str.strip, de_partida[principal].splitlines()))}

        def es_del_ejercicio(f):
            suyas = {linea.strip() for linea in self.ficheros[f].decode(errors="replace").splitlines()}
            return 2 * len(lineas & suyas) > len(lineas) or any(d in self.alcance.nombra[f] for d in de_partida)

        def orden(f):
            es_copia = any(tallo(f).startswith(tallo(g)) and tallo(f) != tallo(g) for g in self.alcance.con_main)
            llamado = nombres.index(tallo(f)) if tallo(f) in nombres else len(nombres)
            return llamado, not es_del_ejercicio(f), es_copia, f.count("/"), f

        intentos = [
            intento
            for f in sorted(self.alcance.con_main, key=orden)[:PROGRAMAS]
            for intento in (self.alcance.con_los_suyos(f), [f, *self.alcance.sin_main], [f])
        ]
        self.intentos = [i for n, i in enumerate(intentos) if i not in intentos[:n]] or [self.alcance.se_compilan]

    @property
    def suyos(self):
        """Lo que alcanza el programa que se corrige, y sus shaders."""
        alcanzados = self.alcance.desde(*self.intentos[0]) if self.intentos else self.ficheros
        return {f: c for f, c in self.ficheros.items() if f in alcanzados or tipo(f) in SHADERS}

    def mira_lo_que_falta(self):
        """Si el programa incluye algo que no se ha podido leer, no se puede corregir; si no, se avisa."""
        nombrados = {n for f in self.alcance.desde(*self.intentos[0]) for n in self.alcance.nombra[f]}
        for ruta, por in self.mal.items():
            if (nombre := PurePath(ruta).name) in nombrados and nombre not in self.alcance.de:
                raise Rechazo(por)
        if self.mal:
            mas = f", y {len(self.mal) - 1} más" if len(self.mal) > 1 else ""
            self.avisos.append(f"no se ha mirado todo: {next(iter(self.mal.values()))}{mas}")

    def corregida(self, fuentes):
        """Cuando ya se sabe con cuáles compila: si había otro programa, se avisa."""
        otros = [f for f in self.alcance.con_main if self.ficheros[f] != self.ficheros[fuentes[0]]]
        if otros:
            self.avisos.append(f"se ha corregido {fuentes[0]}, y no {otros[0]}")

    def solo_los_de(self, de_partida):
        """Cada shader que se pide, por su nombre o, si de su tipo no hay otro, por su tipo."""
        suyos = self.ficheros
        self.ficheros = {}
        for ruta, texto in de_partida.items():
            llamados = [f for f in suyos if PurePath(f).name.lower() == PurePath(ruta).name.lower()]
            de_su_tipo = [f for f in suyos if tipo(f) == tipo(ruta)]
            hallado = llamados or (de_su_tipo if len(de_su_tipo) == 1 else [])
            self.ficheros[ruta] = suyos[hallado[0]] if hallado else texto.encode()
            if not hallado:
                if por := next((por for f, por in self.mal.items() if tipo(f) == tipo(ruta)), ""):
                    raise Rechazo(por)
                self.avisos.append(f"no viene {PurePath(ruta).name}: se ha puesto el de partida")
        if len(self.avisos) == len(de_partida):
            raise Rechazo(f"no viene {', '.join(PurePath(ruta).name for ruta in de_partida)}")


# --- leerla ---


def lee_fichero(carpeta, nombre):
    """Un fichero corriente y corto de otro: ni enlaces, ni tuberías, ni dispositivos."""
    visto = limpio(nombre)
    try:
        f = os.open(nombre, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC, dir_fd=carpeta)
    except OSError:
        raise Rechazo(f"no se puede leer «{visto}»: es un enlace o no hay permiso") from None
    with open(f, "rb") as fichero:
        if not stat.S_ISREG(os.fstat(f).st_mode):
            raise Rechazo(f"«{visto}» no es un fichero corriente")
        datos = fichero.read(BYTES + 1)
    if len(datos) > BYTES:
        raise Rechazo(f"«{visto}» pasa de {BYTES >> 20} MiB")
    return datos


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


@contextmanager
def abierta(carpeta, *dentro):
    """Una carpeta, o la que hay bajando por esas, que no es un enlace, mientras se mira."""
    with ExitStack() as pila:
        f = None
        for paso in (carpeta, *dentro):
            try:
                f = os.open(paso, os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW | os.O_CLOEXEC, dir_fd=f)
            except OSError:
                raise Rechazo("no es una carpeta que se pueda leer") from None
            pila.callback(os.close, f)
        yield f


class Lector:
    """Recorre la carpeta de una entrega sin salir de ella, antes lo de fuera que lo de dentro. DE_OTRO: si una ruta es
    de algo que ya está aquí."""

    def __init__(self, carpeta, mal=None, de_otro=lambda ruta: False):
        self.carpeta, self.de_otro = carpeta, de_otro
        self.vistos, self.hay, self.fuentes = 0, [], []  # cuántos, sus nombres, y rutas en partes
        self.leidos, self.mal, self.bytes, self.traducidos = {}, dict(mal or {}), 0, []

    def recorre(self):
        por_ver = deque([()])
        while por_ver and self.vistos < HAY:
            ruta = por_ver.popleft()
            try:
                with abierta(self.carpeta, *ruta) as f, os.scandir(f) as entradas:
                    dentro = sorted(
                        (e.name, e.is_dir(follow_symlinks=False))
                        for e in itertools.islice(entradas, HAY - self.vistos)
                        if not basura(e.name)
                    )
            except Rechazo:
                if not ruta:
                    raise
                continue
            self.vistos += len(dentro)
            self.hay += [nombre for nombre, es_carpeta in dentro if not es_carpeta]
            por_ver += [(*ruta, nombre) for nombre, es_carpeta in dentro if es_carpeta and len(ruta) < HONDO]
            self.fuentes += [(*ruta, n) for n, es_carpeta in dentro if not es_carpeta and tipo(n) in FUENTES]
            if (nuevo.EJERCICIO, False) in dentro:
                self.lee(*ruta, nuevo.EJERCICIO)

    def ejercicios(self):
        """{carpeta: el que dice su ejercicio.txt}."""
        dichos = {ruta: self.leidos.pop(ruta).decode(errors="replace").split() for ruta in [*self.leidos]}
        return {ruta[: -len(nuevo.EJERCICIO)]: limpio(que[0]) for ruta, que in dichos.items() if len(que) > 1}

    def lee_los_de(self, ref):
        """Los fuentes; si hay carpetas de varios ejercicios y una es del que se pide, sin los de las otras."""
        dichos = self.ejercicios()
        de_otros = [c for c, dice in dichos.items() if dice != ref] if ref in dichos.values() else []
        for ruta in self.fuentes:
            escrita = "/".join(ruta)
            if not any(limpia(ruta).startswith(c) for c in de_otros) and not self.de_otro(escrita):
                self.lee(*ruta)
        return ref if ref in dichos.values() else next(iter(dichos.values()), "")

    def lee(self, *ruta):
        try:
            if len(self.leidos) == FICHEROS or self.bytes > TODO:
                raise Rechazo(f"son más de {FICHEROS} ficheros, o de {TODO >> 20} MiB entre todos")
            with abierta(self.carpeta, *ruta[:-1]) as f:
                datos = lee_fichero(f, ruta[-1])
            self.bytes += len(datos)
            if tipo(ruta[-1]) in CODIGO:
                crudos, datos = datos, en_utf8(datos)
                self.traducidos += [ruta[-1]] if crudos != datos else []
            self.leidos[limpia(ruta)] = datos
        except Rechazo as por:
            self.mal[limpia(ruta)] = str(por)
        except ValueError:
            self.mal[limpia(ruta)] = f"«{limpio(ruta[-1])}» no es un texto en UTF-8: guárdalo así en el editor"

    def por_que_no_hay(self):
        if self.mal:
            return next(iter(self.mal.values()))
        if comprimido := next((n for n in self.hay if tipo(n) in COMPRIMIDOS), None):
            return f"no hay ningún fuente: hay un «{limpio(comprimido)}» sin descomprimir"
        hay = ", ".join(limpio(nombre) for nombre in sorted(self.hay)[:3])
        return f"no hay ningún fuente: hay {hay}" if hay else "no hay nada en su carpeta"


def limpia(ruta):
    return "/".join(map(limpio, ruta))


def sin_numero(ficheros):
    """«grua (2).h», como lo baja un navegador que ya tenía otro, es grua.h si no viene. De varios, el último."""
    nuevos = dict(ficheros)
    bajados = [(int(n[1]), ruta) for ruta in ficheros if (n := re.search(r"[^/]\((\d{1,3})\)\.[^./]+$", ruta))]
    for _, ruta in sorted(bajados, reverse=True):
        sin = re.sub(r"[ _]?\(\d+\)(?=\.[^./]+$)", "", ruta)
        if sin not in nuevos:
            nuevos[sin] = nuevos.pop(ruta)
    return dict(sorted(nuevos.items()))


def lee_entrega(carpeta, ref="", mal=None, de_otro=lambda ruta: False):
    """Los fuentes de una entrega, con los de sus carpetas; lo demás que haya no se mira. O el fichero que es ella. MAL:
    lo que ya se sabe que no se puede leer."""
    if carpeta.is_file() and tipo(carpeta.name) in CODIGO:
        lector = Lector(carpeta.parent)
        lector.lee(carpeta.name)
        if lector.mal:
            raise Rechazo(lector.por_que_no_hay())
        return Entrega(lector.leidos, (carpeta.stem,))
    lector = Lector(carpeta, mal, de_otro)
    lector.recorre()
    ejercicio = lector.lee_los_de(ref)
    ficheros, llamadas = sin_numero(lector.leidos), [carpeta.name]
    if not any(tipo(f) in CODIGO for f in ficheros):
        raise Rechazo(lector.por_que_no_hay())
    while len(unica := {f.partition("/")[0] for f in ficheros}) == 1 and all("/" in f for f in ficheros):
        llamadas += unica
        ficheros = {f.partition("/")[2]: contenido for f, contenido in ficheros.items()}
    avisos = [f"no está en UTF-8, y se ha traducido: {limpio(lector.traducidos[0])}"] if lector.traducidos else []
    return Entrega(ficheros, tuple(llamadas), ejercicio, lector.mal, avisos)


def ejercicio_de(carpeta, programas):
    """Lo que dice ejercicio.txt: la referencia, vacía si solo es una copia, y el programa."""
    try:
        with abierta(carpeta) as f:
            return nuevo.ejercicio_dicho(lee_fichero(f, nuevo.EJERCICIO).decode(), programas)
    except (Rechazo, UnicodeDecodeError, ValueError, StopIteration) as error:
        por_que = f": {error}" if isinstance(error, Rechazo) and (carpeta / nuevo.EJERCICIO).exists() else ""
        raise Fallo(f"{carpeta / nuevo.EJERCICIO} no dice de qué ejercicio es{por_que}") from None


def tiene_main(fuente):
    with open(fuente, "rb") as f:
        return bool(MAIN.search(f.read(BYTES)))


def hay_programa(carpeta, hondo=HONDO):
    """Si dentro hay un fuente con main."""
    try:
        with os.scandir(carpeta) as entradas:
            dentro = [e for e in itertools.islice(entradas, HAY) if not basura(e.name) and not e.is_symlink()]
        suyos = (e for e in dentro if tipo(e.name) in COMPILADOS and e.is_file())
        if any(tiene_main(Path(e.path)) for e in suyos):
            return True
        return hondo > 0 and any(hay_programa(e.path, hondo - 1) for e in dentro if e.is_dir())
    except OSError:
        return False


def busca(mios, entrega, fuera=None):
    """Su carpeta, que puede estar en MIOS, y, si es una clase, las de dentro, menos esa de fuera. Un fuente suelto, que
    será de quien enseña, no hace de la clase una entrega."""
    suelto = Path(entrega)
    if suelto.is_file() and tipo(suelto.name) in CODIGO:
        return suelto.absolute(), None, []
    carpeta = next((c for c in (mios / entrega, suelto) if c.is_dir()), None)
    if not carpeta:
        raise Fallo(f"no hay ninguna carpeta «{entrega}», ni mios/{entrega}")
    carpeta = carpeta.absolute()
    aqui = [f for f in sorted(carpeta.iterdir()) if not basura(f.name)]
    dentro = [c for c in aqui if c.is_dir() and c != fuera]
    sueltos = [f.name for f in aqui if tipo(f.name) in CODIGO]
    es_una = (carpeta / nuevo.EJERCICIO).is_file() or (sueltos and not any(map(hay_programa, dentro)))
    return (carpeta, None, []) if es_una else (carpeta, dentro or None, sueltos)
