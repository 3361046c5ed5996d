"""Lo que un programa pinta encima de su escena, como lo apunta con LAB_ENCIMA (common/encima/encima.h)."""
from typing import NamedTuple


class Pincelada(NamedTuple):
    tipo: str
    color: tuple
    panel: tuple  # x, y, ancho, alto
    talla: float
    puntos: list  # x y, en píxeles desde abajo a la izquierda
    texto: str


def lee(fichero):
    """Por cada imagen guardada, su lista."""
    imagenes = []
    for linea in fichero.read_text().splitlines():
        tipo, *campos = linea.split("\t")
        if tipo == "imagen":
            imagenes.append([])
            continue
        color, panel, talla, _, puntos, texto = campos
        xyz = [float(v) for v in puntos.split()]
        donde = tuple(map(int, panel.split()))
        rgb, puntos = tuple(map(float, color.split())), list(zip(xyz[::3], xyz[1::3]))
        imagenes[-1].append(Pincelada(tipo, rgb, donde, float(talla), puntos, texto))
    return imagenes
