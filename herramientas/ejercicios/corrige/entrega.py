"""Lo que entrega un estudiante, que no es de fiar: se lee con cuidado, y hasta un límite."""
import itertools
import os
import re
import stat
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path, PurePath

from base.procesos import Fallo
from ejercicios import nuevo

COMPILADOS = ".cpp", ".cc", ".cxx", ".c++"
CODIGO = *COMPILADOS, ".h", ".hpp", ".hh", ".hxx", ".inl", ".inc", ".c", ".vert", ".frag", ".geom", ".glsl"
FUENTES = *CODIGO, ".vf"
COMPRIMIDOS = ".zip", ".rar", ".7z", ".gz", ".tar", ".tgz"
FICHEROS, BYTES = 40, 1 << 20  # de una entrega, y de cada fichero
HAY, HONDO = 5000, 6  # lo que se mira de una carpeta, y hasta dónde se baja
LETRAS = 300
MAIN = re.compile(rb"\bmain\s*\(")


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
    """Lo que dejan en una carpeta git, macOS, un editor o nosotros."""
    return nombre.startswith(".") or nombre.endswith("~") or nombre in ("__MACOSX", "correccion")


def tipo(nombre):
    return PurePath(nombre).suffix.lower()


@dataclass
class Entrega:
    ficheros: dict  # {ruta desde su carpeta: contenido}
    llamadas: tuple = ()  # cómo se llaman sus carpetas: el fuente que se llame así es el que abre ./lab ver
    ejercicio: str = ""  # el que dice que es
    avisos: list = field(default_factory=list)

    def completa(self, de_partida, principal):
        """Lo que no viene, del esqueleto: el programa, si no hay ninguno, y cada fichero que no se llame igual. Si no
        hay principal, es que se piden unos shaders, y solo son ellos."""
        if not principal:
            return self.solo_los_de(de_partida)
        nombres = {PurePath(f).name: contenido for f, contenido in self.ficheros.items()}
        sin_mayusculas = {nombre.lower(): contenido for nombre, contenido in nombres.items()}
        if any(tipo(nombre) in COMPILADOS for nombre in nombres):
            nombres[principal] = b""
        for fichero, texto in de_partida.items():
            if fichero not in nombres:
                self.ficheros[fichero] = sin_mayusculas.get(fichero.lower(), texto.encode())
                if fichero.lower() not in sin_mayusculas:
                    self.avisos.append(f"no viene {fichero}: se ha puesto el de partida")

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
                self.avisos.append(f"no viene {PurePath(ruta).name}: se ha puesto el de partida")
        if len(self.avisos) == len(de_partida):
            raise Rechazo(f"no viene {', '.join(PurePath(ruta).name for ruta in de_partida)}")


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


@contextmanager
def abierta(carpeta, donde=None):
    """Una carpeta, que no es un enlace, mientras se mira."""
    try:
        f = os.open(carpeta, os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW | os.O_CLOEXEC, dir_fd=donde)
    except OSError:
        raise Rechazo("no es una carpeta que se pueda leer") from None
    try:
        yield f
    finally:
        os.close(f)


class Lector:
    """Recorre la carpeta de una entrega sin salir de ella."""

    def __init__(self):
        self.hay, self.leidos = [], {}

    def recorre(self, f, ruta="", hondo=HONDO):
        with os.scandir(f) as entradas:
            dentro = sorted(
                (e.name, e.is_dir(follow_symlinks=False))
                for e in itertools.islice(entradas, HAY + 1 - len(self.hay))
                if not basura(e.name)
            )
        self.hay += [nombre for nombre, _ in dentro]
        if len(self.hay) > HAY:
            raise Rechazo(f"hay más de {HAY} ficheros")
        for nombre, es_carpeta in dentro:
            if es_carpeta and hondo:
                with abierta(nombre, f) as otra:
                    self.recorre(otra, f"{ruta}{limpio(nombre)}/", hondo - 1)
            elif not es_carpeta and (tipo(nombre) in FUENTES or nombre == nuevo.EJERCICIO):
                self.lee(f, nombre, ruta + limpio(nombre))

    def lee(self, f, nombre, ruta):
        if len(self.leidos) == FICHEROS:
            raise Rechazo(f"son más de {FICHEROS} ficheros")
        datos = self.leidos[ruta] = lee_fichero(f, nombre)
        if tipo(nombre) in CODIGO and (datos[:2] in (b"\xff\xfe", b"\xfe\xff") or b"\0" in datos):
            raise Rechazo(f"«{limpio(nombre)}» no es un texto en UTF-8: guárdalo así en el editor")

    def por_que_no_hay(self):
        if comprimido := next((n for n in self.hay if tipo(n) in COMPRIMIDOS), None):
            return f"no hay ningún fuente: hay un «{limpio(comprimido)}» sin descomprimir"
        hay = ", ".join(limpio(nombre) for nombre in sorted(self.hay)[:3])
        return f"no hay ningún fuente: hay {hay}" if hay else "no hay nada en su carpeta"


def sin_numero(ficheros):
    """«grua (2).h», como lo baja un navegador que ya tenía otro, es grua.h si no viene. De varios, el último."""
    nuevos = dict(ficheros)
    bajados = [(int(n[1]), ruta) for ruta in ficheros if (n := re.search(r"[^/]\((\d{1,3})\)\.[^./]+$", ruta))]
    for _, ruta in sorted(bajados, reverse=True):
        sin = re.sub(r"[ _]?\(\d+\)(?=\.[^./]+$)", "", ruta)
        if sin not in nuevos:
            nuevos[sin] = nuevos.pop(ruta)
    return dict(sorted(nuevos.items()))


def lee_entrega(carpeta):
    """Los fuentes de una entrega, con los de sus carpetas; lo demás que haya no se mira. O el fichero que es ella."""
    lector = Lector()
    if carpeta.is_file() and tipo(carpeta.name) in CODIGO:
        with abierta(carpeta.parent) as f:
            lector.lee(f, carpeta.name, limpio(carpeta.name))
        return Entrega(lector.leidos, (carpeta.stem,))
    with abierta(carpeta) as f:
        lector.recorre(f)
    ficheros, llamadas = sin_numero(lector.leidos), [carpeta.name]
    dice = next((f for f in ficheros if PurePath(f).name == nuevo.EJERCICIO), None)
    ejercicio = ficheros.pop(dice).decode(errors="replace").split() if dice else []
    if not any(tipo(f) in CODIGO for f in ficheros):
        raise Rechazo(lector.por_que_no_hay())
    while len(unica := {f.partition("/")[0] for f in ficheros}) == 1 and all("/" in f for f in ficheros):
        llamadas += unica
        ficheros = {f.partition("/")[2]: contenido for f, contenido in ficheros.items()}
    return Entrega(ficheros, tuple(llamadas), limpio(ejercicio[0]) if len(ejercicio) > 1 else "")


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
