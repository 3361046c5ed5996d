"""Un guion jugado por un programa: las imágenes, los títulos y el texto que deja, y los guiones que juegan todos."""
import itertools
import random
import re
from dataclasses import dataclass, field
from pathlib import Path

from base import controles
from ejercicios.corrige.jaula import NO_ACABA, desempaqueta

TALLA = 240, 180
TALLAS = "320 180", "180 180", "120 160", "240 180"
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


@dataclass(frozen=True)
class Guion:
    nombre: str
    ordenes: tuple
    caso: bool = False

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

    @classmethod
    def lee(cls, datos, guion):
        ficheros = desempaqueta(datos)
        imagenes = []
        for i in range(len(guion.ordenes) + 1):
            imagen = lee_ppm(ficheros.get(f"{i:03}.ppm", b""))
            if not imagen:
                break
            imagenes.append(imagen)
        lineas = ficheros.get("salida", b"")[: 1 << 16].decode(errors="replace").splitlines()
        titulos = [linea.replace("-0°", "0°") for linea in lineas if linea.startswith("título: ")]
        texto = [linea.rstrip() for linea in lineas if not linea.startswith("título: ")]
        estado = ficheros.get("estado", b"").strip()
        return cls(
            imagenes,
            [titulo for titulo, _ in itertools.groupby(titulos)],
            "\n".join(texto),
            int(estado) if estado.isdigit() else -1,
            ficheros.get("errores", b"")[:4000].decode(errors="replace"),
        )

    @property
    def cuelga(self):
        return self.estado in NO_ACABA


def repite(azar, suceso):
    """Una tecla, a veces muchas veces."""
    veces = azar.choice(VECES)
    return (
        [f"{suceso[0]} ×{veces}"]
        if veces > 1 and len(suceso) == 1 and suceso[0].startswith(("tecla", "especial"))
        else suceso
    )


def guiones_al_azar(clave, n, mandos, sucesos):
    """n guiones con sucesos(azar); entre todos empiezan por todos los mandos."""
    for i in range(n):
        azar = random.Random(f"{clave} {i}")
        ordenes = repite(azar, [mandos[i % len(mandos)]]) if mandos else []
        while len(ordenes) < LARGO:
            ordenes += repite(azar, sucesos(azar))
        if i % 2:
            ordenes.insert(azar.randint(1, LARGO), f"tamano {azar.choice(TALLAS)}")
        yield Guion(f"al azar {i + 1}", tuple(ordenes))


def de_los_casos(programa):
    for caso in programa.casos:
        yield Guion(caso.nombre, tuple(o.strip() for o in caso.guion.split(";") if o.strip()), True)


def al_azar(raiz, build, programa, clave, n, entorno):
    """n guiones con los controles de ese programa."""
    suyos = controles.lee(raiz, programa)
    rasgos, opciones = controles.atiende(build, programa, **entorno)
    teclas = [o for c in suyos if not c.termina for o in c.ordenes if o not in controles.COMUNES]
    mandos = teclas + [f"menu {o}" for o in opciones]
    return guiones_al_azar(
        clave, n, mandos, lambda azar: controles.sucesos_al_azar(azar, suyos, rasgos, opciones, *TALLA)
    )
