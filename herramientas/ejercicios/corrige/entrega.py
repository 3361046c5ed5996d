"""Lo que entrega un estudiante: de lo que hay (lector.py) se corrige un programa con lo que alcanza. Lo demás no
estorba: se avisa."""
import re
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path, PurePath

from base.fuentes import SHADERS
from base.procesos import Fallo
from ejercicios import nuevo
from ejercicios.corrige.lector import CODIGO, COMPILADOS, Lector, Rechazo, basura, de_carpeta, lee_fichero, tipo

PROGRAMAS = 3  # con main, que se intentan
MAIN = re.compile(rb"\bmain\s*\(")
INCLUYE = re.compile(rb'^[ \t]*#[ \t]*include[ \t]+"([^"\n]+)"', re.M)
COMENTARIO = re.compile(rb"//[^\n]*|/\*.*?\*/", re.S)


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
    version: str = ""  # la del punto de partida que se le dio, si lo dice
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
        return self.los_que_alcanza(self.intentos[0] if self.intentos else ())

    def los_que_alcanza(self, fuentes):
        alcanzados = self.alcance.desde(*fuentes) if fuentes else self.ficheros
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
        suyos, faltan = self.ficheros, []
        self.ficheros = {}
        for ruta, texto in de_partida.items():
            llamados = [f for f in suyos if PurePath(f).name.lower() == PurePath(ruta).name.lower()]
            de_su_tipo = [f for f in suyos if tipo(f) == tipo(ruta)]
            hallado = llamados or (de_su_tipo if len(de_su_tipo) == 1 else [])
            self.ficheros[ruta] = suyos[hallado[0]] if hallado else texto.encode()
            if not hallado:
                if por := next((por for f, por in self.mal.items() if tipo(f) == tipo(ruta)), ""):
                    raise Rechazo(por)
                faltan.append(PurePath(ruta).name)
        if len(faltan) == len(de_partida):
            raise Rechazo(f"no viene {', '.join(faltan)}")
        self.avisos += [f"no viene {nombre}: se ha puesto el de partida" for nombre in faltan]


# --- leerla ---


def sin_numero(ficheros):
    """«grua (2).h», como lo baja un navegador que ya tenía otro, es grua.h si no viene. De varios, el último."""
    nuevos = dict(ficheros)
    bajados = [(int(n[1]), ruta) for ruta in ficheros if (n := re.search(r"[^/]\((\d{1,3})\)\.[^./]+$", ruta))]
    for _, ruta in sorted(bajados, reverse=True):
        sin = re.sub(r"[ _]?\(\d+\)(?=\.[^./]+$)", "", ruta)
        if sin not in nuevos:
            nuevos[sin] = nuevos.pop(ruta)
    return dict(sorted(nuevos.items()))


def lee_entrega(que, ref="", de_otro=lambda ruta: False):
    """Los fuentes de una carpeta y de las de dentro, de un fichero o de lo que da una plataforma; lo demás no se
    mira."""
    lector = Lector(que, de_otro)
    ejercicio = lector.lee_los_de(ref)
    ficheros, llamadas = sin_numero(lector.leidos), [que.name]
    if not any(tipo(f) in CODIGO for f in ficheros):
        raise Rechazo(lector.por_que_no_hay())
    while len(unica := {f.partition("/")[0] for f in ficheros}) == 1 and all("/" in f for f in ficheros):
        llamadas += unica
        ficheros = {f.partition("/")[2]: contenido for f, contenido in ficheros.items()}
    return Entrega(ficheros, tuple(llamadas), ejercicio, lector.version, lector.mal, lector.avisos)


def ejercicio_de(carpeta, programas):
    """Lo que dice ejercicio.txt: la referencia, vacía si solo es una copia, y el programa del que viene."""
    try:
        *referencia, origen = lee_fichero(carpeta, nuevo.EJERCICIO).decode().partition("\n")[0].split()
        return "".join(referencia), next(p for p in programas if f"{p.capitulo.nombre}/{p.nombre}" == origen)
    except (Rechazo, UnicodeDecodeError, ValueError, StopIteration) as error:
        por_que = f": {error}" if isinstance(error, Rechazo) and (carpeta / nuevo.EJERCICIO).exists() else ""
        raise Fallo(f"{carpeta / nuevo.EJERCICIO} no dice de qué ejercicio es{por_que}: dilo detrás (E3.5)") from None


def hay_programa(carpeta):
    """Si dentro hay un fuente con main."""

    def tiene_main(lee):
        with suppress(Rechazo):
            return MAIN.search(lee())

    with suppress(Rechazo):
        return any(tiene_main(lee) for ruta, lee in de_carpeta(carpeta) if tipo(ruta[-1]) in COMPILADOS)


def busca(mios, entrega, fuera=None):
    """Su carpeta, que puede estar en MIOS, o su fichero y, si es una clase, las de dentro, menos esa de fuera. Lo
    suelto en ella, que será de quien enseña, no hace de la clase una entrega."""
    suelto = Path(entrega)
    carpeta = next((c for c in (mios / entrega, suelto) if c.is_dir()), None)
    if not carpeta and suelto.is_file():
        return suelto.absolute(), None, []
    if not carpeta:
        raise Fallo(f"no hay ninguna carpeta «{entrega}», ni mios/{entrega}")
    carpeta = carpeta.absolute()
    aqui = [f for f in sorted(carpeta.iterdir()) if not basura(f.name)]
    dentro = [c for c in aqui if c.is_dir() and c != fuera]
    sueltos = [f.name for f in aqui if tipo(f.name) in CODIGO]
    es_una = (carpeta / nuevo.EJERCICIO).is_file() or (sueltos and not any(map(hay_programa, dentro)))
    return (carpeta, None, []) if es_una else (carpeta, dentro or None, sueltos)
