"""Lo que se cumple con los rótulos: caben, no se tocan y no tapan lo que se dibuja."""
import collections
import itertools
import random
import re
from pathlib import Path

from vista import en_formas

# Las formas de una pantalla, de un cuaderno, de media pantalla y de un teléfono, del alto en que las letras son a
# escala y no las más pequeñas que se leen.
FORMAS = [(360, 270), (480, 270), (360, 405), (400, 900)]
TECLAS = 3  # al azar, si no se piden todas
INTERLINEA, BAJO = 1.5, 0.3  # en altos de mayúscula (common/encima/rotulo.cpp)
# Los de common/encima/colores.h, y el que no es de ningún objeto donde el color dice cuál es.
PALETA = (Path(__file__).parents[2] / "common/encima/colores.h").read_text()
COLORES = {"NEGRO": (0, 0, 0)} | {
    nombre: tuple(int(255 * float(c) + 0.5) for c in re.findall(r"[\d.]+", rgb))
    for nombre, rgb in re.findall(r"([A-Z_]+)\(([\d.f, ]+)\)", PALETA)
}
FONDOS = tuple(COLORES[fondo] for fondo in "NEGRO FONDO_CLARO FONDO_OSCURO CIELO GRIS".split())
TAPA = 40  # de cada cien, más de lo que tapa en las imágenes que se han mirado


def cabe(v):
    """Los que no caben en su panel, a media letra del borde, sin estar en lo más pequeño que se lee."""
    for r in v.encima:
        x, y, ancho, alto = r.panel
        if r.tipo == "rotulo" and r.talla > 7:
            (x0, y0), (x1, y1) = r.puntos[:2]
            if min(x0 - x, y0 - y, x + ancho - x1, y + alto - y1) < r.talla / 2:
                yield f"«{r.texto[:30]}» no cabe en su panel, {r.panel}, de una ventana de {v.talla}"


def rotulos(p):
    """Cada rótulo cabe en su panel, a una letra del borde, también en ventanas menudas."""
    formas, menudas = en_formas(p)
    for v in [v for vistas in formas.values() for v in vistas] + menudas:
        for que in cabe(v):
            yield "rótulo", que


def lineas(r):
    """La caja de cada línea de un rótulo: izquierda, abajo, derecha y arriba."""
    (x0, _), (x1, y1) = r.puntos[:2]
    textos = r.texto.split("\\n")
    avance = (x1 - x0) / max(*map(len, textos), 1)
    for i, texto in enumerate(textos):
        suyo, base = texto.strip(), y1 - r.talla - i * round(INTERLINEA * r.talla)
        if suyo:
            izquierda = x0 + avance * (len(texto) - len(texto.lstrip()))
            baja = BAJO * r.talla if re.search("[gjpqy,;()|]", suyo) else 0
            yield izquierda, base - baja, izquierda + avance * len(suyo), base + r.talla


def se_tocan(uno, otro):
    if max(uno.talla, otro.talla) <= 7:  # lo más pequeño que se lee: no pueden encoger más
        return False
    return any(
        a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]
        for a, b in itertools.product(lineas(uno), lineas(otro))
    )


def pixeles(v, izquierda, abajo, derecha, arriba):
    ancho, alto = v.talla
    xs = range(3 * max(int(izquierda), 0), 3 * min(int(derecha) + 1, ancho), 3)
    for y in range(max(int(abajo), 0), min(int(arriba) + 1, alto)):
        fila = v.filas[alto - 1 - y]
        yield from (fila[x : x + 3] for x in xs)


def es_fondo(color, fondos=FONDOS):
    return any(max(abs(a - b) for a, b in zip(color, fondo)) <= 1 for fondo in fondos)


def tapado(v, r):
    """De la caja de un rótulo, qué parte no es fondo en la escena sin rótulos, en %. Lo que es de su color, como
    la flecha que nombra, es lo suyo."""
    debajo = collections.Counter(c for linea in lineas(r) for c in pixeles(v, *linea))
    suyo = tuple(round(255 * c) for c in r.color)
    son = sum(n for color, n in debajo.items() if not es_fondo(color, (*FONDOS, suyo)))
    return 100 * son / max(debajo.total(), 1)


def rotulados(p, ordenes, formas=FORMAS):
    """Tras cada una de esas órdenes, lo que se ve en cada forma, sin los rótulos."""
    mira = [o for ancho, alto in formas for o in (f"tamano {ancho} {alto}", "captura")]
    return p.vistas([o for orden in ordenes for o in (*([orden] if orden else []), *mira)], LAB_SIN_ENCIMA="rotulo")


def en_casos(p):
    """De cada caso, lo que se ve a 4:3; y en otra forma, al azar, si no se piden todas."""
    azar = random.Random(p.nombre)
    otras = [FORMAS[1:] if p.todo else [azar.choice(FORMAS[1:])] for _ in p.casos]
    return [rotulados(p, [guion], [FORMAS[0], *suyas]) for guion, suyas in zip(p.casos, otras)]


def clave(r):
    return re.sub(r"[-−]?\d+([.,]\d+)?", "#", r.texto)


def partidas(p):
    """De un rosario de órdenes cada una: todas, solas y en la comparación; o unas pocas, unas tras otras."""
    if p.todo:
        return [[o] for o in p.mandos] + [["tecla v; " + o] for o in p.mandos if "tecla v" in p.teclas]
    azar = random.Random(f"{p.nombre} {p.semilla}")
    return [azar.sample(p.mandos, min(TECLAS, len(p.mandos)))] if p.mandos else []


def tapan(p):
    """En una ventana de cualquier forma, tras cualquier tecla, un rótulo no toca otro ni tapa más dibujo del que tapa,
    a 4:3, en las imágenes del catálogo; el que no está en ellas, del que tapa el que más."""
    miradas = en_casos(p)
    tapa = collections.Counter()
    for v, r in ((vistas[0], r) for vistas in miradas for r in vistas[0].encima if r.tipo == "rotulo"):
        tapa[clave(r)] = max(tapa[clave(r)], tapado(v, r))
    mas = max(tapa.values(), default=0)
    juegos = [[guion] for guion in p.casos] + partidas(p)
    todas = miradas + [rotulados(p, ordenes) for ordenes in juegos[len(miradas) :]]
    for ordenes, vistas in zip(juegos, todas):
        for i, v in enumerate(vistas):
            con = f"a {v.talla} tras {'; '.join(ordenes[: i * len(ordenes) // len(vistas) + 1]) or 'nada'}"
            suyos = [r for r in v.encima if r.tipo == "rotulo"]
            for r in suyos:
                if (cuanto := tapado(v, r)) > tapa.get(clave(r), mas) + TAPA:
                    yield f"tapa {r.texto}", f"«{r.texto}» tapa lo que se dibuja en el {cuanto:.0f} % de su caja, {con}"
            for uno, otro in itertools.combinations(suyos, 2):
                if se_tocan(uno, otro):
                    yield "toca", f"«{uno.texto}» toca «{otro.texto}», {con}"
            for que in cabe(v):
                yield "cabe", f"{que}, {con}"
