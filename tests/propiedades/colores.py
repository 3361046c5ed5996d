#!/usr/bin/env python3
"""colores.py BUILD: nadie se pierde nada por no distinguir los colores. En cada caso del catálogo, en lo que pinta
encima según su golden, de dos rótulos que solo con su color dicen de qué hablan (no están junto a un trazo de ese
color), los colores se distinguen también con deuteranopia, protanopia y tritanopia: una distancia en CIELAB de 27 o
más. Si no, en EXCEPCIONES está qué otra cosa los distingue."""
import itertools
import math
import sys
from functools import cache
from pathlib import Path

PRUEBAS = Path(__file__).parents[1]
sys.path.insert(0, str(PRUEBAS.parent / "herramientas"))
from base import catalogo
from encima import lee

MINIMO = 27
CERCA = 14  # píxeles de un rótulo a lo que nombra, en una imagen de 240×180
# Lo que ve cada dicromático de un color, en RGB lineal (Machado, Oliveira y Fernandes, 2009, severidad 1), y quien
# los ve todos.
VISTAS = {
    "todos": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    "protanopia": ((0.152286, 1.052583, -0.204868), (0.114503, 0.786281, 0.099216), (-0.003882, -0.048116, 1.051998)),
    "deuteranopia": ((0.367322, 0.860646, -0.227968), (0.280085, 0.672501, 0.047413), (-0.011820, 0.042940, 0.968881)),
    "tritanopia": ((1.255528, -0.076749, -0.178779), (-0.078411, 0.930809, 0.147602), (0.004733, 0.691367, 0.303900)),
}
EXCEPCIONES = {
    "grua_vistas": "cada nombre está en su vista",
    "temporizador": "cada cifra está en su reloj",
    "continuidad": "cada nombre está en su gráfica",
}


def visto(color, matriz):
    """Ese color de sRGB como se ve, en CIELAB con el blanco D65."""
    lineal = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in color]
    r, g, b = (min(max(sum(m * c for m, c in zip(fila, lineal)), 0), 1) for fila in matriz)

    def f(t):
        return t ** (1 / 3) if t > 216 / 24389 else (24389 / 27 * t + 16) / 116

    x = f((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047)
    y = f(0.2126729 * r + 0.7151522 * g + 0.0721750 * b)
    z = f((0.0193339 * r + 0.1191920 * g + 0.9503041 * b) / 1.08883)
    return 116 * y - 16, 500 * (x - y), 200 * (y - z)


@cache
def se_distinguen(uno, otro):
    """Quien peor los distingue, y cuánto."""
    return min((math.dist(visto(uno, m), visto(otro, m)), quien) for quien, m in VISTAS.items())


def encima(caso):
    """Los rótulos y los trazos de un caso: color, puntos y texto."""
    golden = PRUEBAS / f"golden/{caso.programa.capitulo.nombre}/{caso.fichero}.encima"
    rotulos, trazos = [], []
    for p in lee(golden)[-1] if golden.exists() else ():
        (rotulos if p.tipo == "rotulo" else trazos).append((p.color, p.puntos, p.texto))
    return rotulos, trazos


def junto_a(rotulo, trazos):
    """Si toca a un trazo de su color: entonces se sabe de cuál habla sin mirarlo."""
    color, ((x0, y0), (x1, y1), _), _ = rotulo
    for suyo, puntos, _ in trazos:
        for (ax, ay), (bx, by) in zip(puntos, puntos[1:] + puntos[-1:]) if suyo == color else ():
            veinte = ((ax + (bx - ax) * k / 20, ay + (by - ay) * k / 20) for k in range(21))
            if any(x0 - CERCA <= x <= x1 + CERCA and y0 - CERCA <= y <= y1 + CERCA for x, y in veinte):
                return True
    return False


def confunden(rotulos, trazos):
    """Los pares de rótulos sueltos cuyos colores alguien no distingue."""
    sueltos = {color: texto for color, _, texto in (r for r in rotulos if not junto_a(r, trazos))}
    for uno, otro in itertools.combinations(sueltos, 2):
        cuanto, quien = se_distinguen(uno, otro)
        if cuanto < MINIMO:
            son = f"«{sueltos[uno]}» y «{sueltos[otro]}»"
            yield f"{son} son de dos colores que con {quien} no se distinguen ({cuanto:.0f} en CIELAB)"


def main():
    fallos, confusos = [], set()
    for programa in catalogo.lee_programas(Path(sys.argv[1]).resolve()):
        for caso in () if programa.consola else programa.casos:
            for que in confunden(*encima(caso)):
                confusos.add(programa.nombre)
                fallos += [] if programa.nombre in EXCEPCIONES else [f"{caso.fichero}: {que}"]
    sobran = sorted(set(EXCEPCIONES) - confusos)
    fallos += [f"{nombre} ya no confunde a nadie y sigue en EXCEPCIONES" for nombre in sobran]
    print(*fallos, sep="\n")
    sys.exit(bool(fallos))


if __name__ == "__main__":
    main()
