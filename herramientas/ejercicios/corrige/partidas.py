"""Un guion jugado por un programa: las imágenes, los títulos y el texto que deja, y los guiones que juegan todos."""
import itertools
import random
import re
from dataclasses import dataclass, field
from pathlib import Path

from base import controles
from ejercicios.corrige.jaula import NO_ACABA, desempaqueta

TALLA = 240, 180
TALLAS = "120 160", "320 180", "180 180"
FINAL = "tamano 120 160", "tamano 320 180", "tamano 240 180"  # de todos: estrecha, ancha y la suya
TEXTO = 1 << 20  # bytes que se miran de lo que escribe
LARGO = 10  # órdenes de un guion al azar, al menos
VECES = 1, 1, 1, 2, 5, 30  # que se repite una tecla: a veces, hasta sus límites


@dataclass
class Jugador:
    """Un programa que juega: la solución, la entrega, un mutante."""

    nombre: str
    programa: Path
    raices: list  # dónde busca sus ficheros, antes que en el laboratorio
    entorno: dict = field(default_factory=dict)
    ajeno: bool = False
    fuentes: list = field(default_factory=list)  # los que se han compilado, si son de una entrega


@dataclass(frozen=True)
class Guion:
    nombre: str
    ordenes: tuple
    caso: bool = False
    suyas: int = 0  # de un caso, cuántas órdenes son las del catálogo: las demás las siguen

    @property
    def texto(self):
        """Con una captura al empezar y otra tras cada orden."""
        capturas = [f"captura {i:03}.ppm" for i in range(len(self.ordenes) + 1)]
        return "; ".join([capturas[0], *(p for par in zip(self.ordenes, capturas[1:]) for p in par)])


def lee_ppm(datos):
    """(ancho, alto, píxeles) de un PPM como los que guarda un programa, o None."""
    cabecera = re.match(rb"P6\n((?:#[^\n]{0,1000}\n)*)([1-9]\d{0,3}) ([1-9]\d{0,3})\n255\n", datos)
    if not cabecera:
        return None
    ancho, alto, pixeles = int(cabecera[2]), int(cabecera[3]), datos[cabecera.end() :]
    return (ancho, alto, pixeles) if len(pixeles) == 3 * ancho * alto else None


@dataclass
class Partida:
    """Lo que ha dado un programa con un guion: una imagen al empezar y otra tras cada orden, si ha llegado."""

    imagenes: list
    titulos: list
    texto: str
    estado: int
    errores: str
    segundos: float = 0  # de procesador
    limite: float = 0
    escrito: int = 0  # bytes

    @classmethod
    def lee(cls, datos, guion, limite=0):
        ficheros = desempaqueta(datos)
        imagenes = []
        for i in range(len(guion.ordenes) + 1):
            imagen = lee_ppm(ficheros.get(f"{i:03}.ppm", b""))
            if not imagen:
                break
            imagenes.append(imagen)
        titulos, texto = (
            [linea.rstrip() for linea in ficheros.get(f, b"")[:TEXTO].decode(errors="replace").splitlines()]
            for f in ("titulos", "salida")
        )
        estado = ficheros.get("estado", b"").strip()
        tiempos = ficheros.get("tiempos", b"").strip().rpartition(b"\n")[2]  # tras los del intérprete
        return cls(
            imagenes,
            [t.removeprefix("título: ").replace("-0°", "0°") for t, _ in itertools.groupby(titulos)],
            "\n".join(texto),
            int(estado) if estado.isdigit() else -1,
            ficheros.get("errores", b"")[:4000].decode(errors="replace"),
            sum(60 * int(m) + float(s) for m, s in re.findall(rb"(\d{1,4})m([\d.]{1,9})s", tiempos)),
            limite,
            sum(len(ficheros.get(f, b"")) for f in ("salida", "errores")),
        )

    @property
    def cuelga(self):
        return self.estado in NO_ACABA


def repite(azar, suceso):
    """Una tecla, a veces muchas veces."""
    veces = azar.choice(VECES)
    es_tecla = len(suceso) == 1 and suceso[0].startswith(("tecla", "especial"))
    return [f"{suceso[0]} ×{veces}"] if veces > 1 and es_tecla else suceso


def guiones_al_azar(clave, n, mandos, sucesos):
    """n guiones con sucesos(azar), que empiezan por los mandos(azar): entre todos, por todos, si hace falta por
    varios."""
    for i in range(n):
        azar = random.Random(f"{clave} {i}")
        ordenes = []
        for mando in mandos[i::n] or mandos[i % max(len(mandos), 1) :][:1]:
            ordenes += repite(azar, mando(azar))
        while len(ordenes) < LARGO:
            ordenes += repite(azar, sucesos(azar))
        if i % 2:
            ordenes.insert(azar.randint(1, LARGO), f"tamano {TALLAS[i // 2 % len(TALLAS)]}")
        yield Guion(f"al azar {i + 1}", (*ordenes, *FINAL))


def de_los_casos(programa, tras=FINAL):
    for caso in programa.casos:
        suyas = [o.strip() for o in caso.guion.split(";") if o.strip()]
        yield Guion(caso.nombre, (*suyas, *tras), True, len(suyas))


def al_azar(raiz, build, programa, clave, n, entorno):
    """n guiones con los controles de ese programa."""
    suyos = controles.lee(raiz, programa)
    rasgos, opciones = controles.atiende(build, programa, **entorno)
    teclas = [o for c in suyos if not c.termina for o in c.ordenes if o not in controles.COMUNES]
    mandos = [lambda azar, o=o: [o] for o in (*teclas, *(f"menu {o}" for o in opciones))]
    mueven = [mueve for mueve, cual in controles.MANDOS.items() if cual & rasgos]
    mandos += [lambda azar, mueve=mueve: mueve(azar, *TALLA) for mueve in mueven]
    sucesos = lambda azar: controles.sucesos_al_azar(azar, suyos, rasgos, opciones, *TALLA)
    return guiones_al_azar(clave, n, mandos, sucesos)
