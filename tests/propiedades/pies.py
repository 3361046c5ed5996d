#!/usr/bin/env python3
"""pies.py BUILD [PROGRAMA…]: lo que el catálogo dice que cumple cada caso es así en su golden y no en los demás de su
programa: un pie que vale para la imagen de al lado no dice nada de la suya. Salvo las casi iguales. Los puntos son
fracciones de la ventana, x hacia la derecha e y hacia abajo; un COLOR es un nombre de common/encima/colores.h o
(r,g,b), de 0 a 255:

  en X Y COLOR                  ese color, a 12 niveles como mucho
  en X Y como X Y               los dos puntos, a 12 niveles
  en X Y más claro que X Y      más de 12 niveles de luminancia
  COLOR entero|cortado|ausente  lo de ese color, con más o menos luz: no toca el borde, lo toca, no está
  COLOR A a B %                 lo que ocupa de ella
  distinta de CASO en A a B %   los píxeles que cambian en más de 12 niveles

Con GOLDEN, los de esa carpeta. Estado 1 si alguna no es así, y dice cuál y qué hay."""
import collections
import functools
import os
import re
import sys
from pathlib import Path

from programa import lee_ppm
from rotulos import COLORES
from base import catalogo

NIVELES = 12
CASI_IGUALES = 1  # % de píxeles distintos: las separa un rótulo
PENUMBRA = 0.25  # lo menos iluminado que es del color de un objeto
GOLDEN = Path(os.environ.get("GOLDEN", Path(__file__).parents[1] / "golden"))


def color_de(nombre):
    return tuple(map(int, nombre[1:-1].split(","))) if nombre[0] == "(" else COLORES[nombre]


def iguales(a, b):
    return max(abs(x - y) for x, y in zip(a, b)) <= NIVELES


@functools.cache
def del_color(pixel, color):
    """Si es ese color con la luz que sea: un múltiplo suyo."""
    luz = sum(p * c for p, c in zip(pixel, color)) / max(sum(c * c for c in color), 1)
    return iguales(pixel, [int(min(max(luz, PENUMBRA), 1) * c + 0.5) for c in color])


class Caso:
    def __init__(self, caso):
        self.fichero, self.afirmaciones = caso.fichero, caso.cumple
        filas = lee_ppm(GOLDEN / caso.programa.capitulo.nombre / f"{caso.fichero}.ppm")
        self.filas = [list(zip(fila[::3], fila[1::3], fila[2::3])) for fila in filas]
        self.pixeles = [pixel for fila in self.filas for pixel in fila]
        borde = [*self.filas[0], *self.filas[-1], *(fila[k] for fila in self.filas[1:-1] for k in (0, -1))]
        self.veces = [collections.Counter(suyos).items() for suyos in (self.pixeles, borde)]

    def en(self, x, y):
        return self.filas[int(float(y) * len(self.filas))][int(float(x) * len(self.filas[0]))]

    def de_color(self, color):
        """Cuántos píxeles lo son, y cuántos del borde."""
        suyo = color_de(color)
        return [sum(n for pixel, n in veces if del_color(pixel, suyo)) for veces in self.veces]

    @functools.cache
    def distinto(self, otro):
        """En qué parte de los píxeles, en %."""
        parejas = collections.Counter(zip(self.pixeles, otro.pixeles)).items()
        return 100 * sum(n for (a, b), n in parejas if not iguales(a, b)) / len(self.pixeles)


# De cada forma de escribir una afirmación, lo que hay si no es lo que afirma.


def es_de_color(caso, _, x, y, color):
    return None if iguales(caso.en(x, y), color_de(color)) else caso.en(x, y)


def es_como(caso, _, x, y, como, u, v):
    a, b = caso.en(x, y), caso.en(u, v)
    luz, otra = (0.299 * rojo + 0.587 * verde + 0.114 * azul for rojo, verde, azul in (a, b))
    return None if (iguales(a, b) if como == "como" else luz > otra + NIVELES) else f"{a} y {b}"


def toca(caso, _, color, como):
    son, en_borde = caso.de_color(color)
    hay = "ausente" if not son else "cortado" if en_borde else "entero"
    return None if hay == como else f"{hay}: {son} píxeles, {en_borde} en el borde"


def entre(cuanto, de, a):
    return None if float(de) <= cuanto <= float(a) else f"{cuanto:.3g} %"


def ocupa(caso, _, color, de, a):
    return entre(100 * caso.de_color(color)[0] / len(caso.pixeles), de, a)


def es_distinta(caso, programa, otro, de, a):
    return entre(caso.distinto(programa[otro]), de, a)


PUNTO, COLOR = r"(0(?:\.\d+)?) (0(?:\.\d+)?)", r"([A-Z_]+|\(\d+,\d+,\d+\))"
TRAMO = r"(\d+(?:\.\d+)?) a (\d+(?:\.\d+)?) %"
FORMAS = {
    f"en {PUNTO} {COLOR}": es_de_color,
    f"en {PUNTO} (como|más claro que) {PUNTO}": es_como,
    f"{COLOR} (entero|cortado|ausente)": toca,
    f"{COLOR} {TRAMO}": ocupa,
    rf"distinta de (\w+) en {TRAMO}": es_distinta,
}


def lo_que_hay(afirmacion, caso, programa):
    for escrita, hay in FORMAS.items():
        if palabras := re.fullmatch(escrita, afirmacion):
            return hay(caso, programa, *palabras.groups())
    return "que no se entiende"


def juzga(programa):
    for caso in programa.values():
        for una in caso.afirmaciones:
            if hay := lo_que_hay(una, caso, programa):
                yield f"{caso.fichero}: «{una}», y hay {hay}"
        for otro in programa.values() if caso.afirmaciones else ():
            vale = otro is not caso and not any(lo_que_hay(una, otro, programa) for una in caso.afirmaciones)
            if vale and caso.distinto(otro) >= CASI_IGUALES:
                yield f"{caso.fichero}: lo que cumple también lo cumple {otro.fichero}"


def main():
    programas = [p for p in catalogo.lee_programas(Path(sys.argv[1])) if not p.consola]
    programas = [p for p in programas if not sys.argv[2:] or p.nombre in sys.argv[2:]]
    fallos = [fallo for p in programas for fallo in juzga({caso.nombre: Caso(caso) for caso in p.casos})]
    print(*fallos, sep="\n")
    sys.exit(bool(fallos))


if __name__ == "__main__":
    main()
