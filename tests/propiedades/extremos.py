"""Lo que se cumple en los extremos: de cada mando, hasta donde llega, se ve algo que mirar."""
import collections
import random

from programa import CONTRARIAS, arrastre
from rotulos import MENUDA, en_casos, es_fondo

VECES, AL_AZAR = 60, 3
POCO = 0.1  # de lo que se ve donde menos, en las imágenes que se han mirado: menos no es ver algo
CORTE = 10  # de cada cien del borde, los que puede tocar de más
LISO = 97  # de cada cien de lo dibujado, del mismo color: no se distingue nada


def extremos_de(p):
    """Lo que se pulsa para llegar al extremo de cada mando, solo y en cada modo; y adónde llevan rueda y ratón."""
    pares = [c.ordenes for c in p.controles if set(c.teclas) in CONTRARIAS and not c.termina]
    suben = [o for par in pares for o in par] + [o for o in p.teclas if o.startswith("especial ")]
    modos = [[]] + [[o] for o in p.mandos if o not in suben]
    hasta = [[*modo, f"{o} ×{VECES}"] for modo in modos for o in suben]
    if "rueda" in p.rasgos:
        hasta += [[f"rueda {giro} 80 60 ×{VECES}"] for giro in ("+1", "-1")]
    if "arrastre" in p.rasgos:
        hasta += [arrastre(80, 60, *donde) for donde in ((0, 60), (159, 60), (80, 0), (80, 119))]
    return hasta + [[o] for o in p.mandos]


def medidas(v):
    """De cada cien píxeles, los dibujados; de cada cien del borde, los dibujados; y de cada cien dibujados, los del
    color que más."""
    ancho = v.talla[0]
    filas = [[fila[i : i + 3] for i in range(0, 3 * ancho, 3)] for fila in v.filas]
    colores = collections.Counter(c for fila in filas for c in fila)
    dibujados = {c: n for c, n in colores.items() if not es_fondo(c)}
    borde = [*filas[0], *filas[-1], *(fila[x] for fila in filas for x in (0, -1))]
    son = sum(dibujados.values())
    return (
        100 * son / colores.total(),
        100 * sum(c in dibujados for c in borde) / len(borde),
        100 * max(dibujados.values(), default=0) / max(son, 1),
    )


def extremos(p):
    """Hasta donde llega cada mando se ve algo, no de un solo color ni más cortado por el borde que lo que se ha
    mirado. Con el ratón es quien mira el que se acerca, se aleja o rodea; que siga a la vista lo pide casos/borde.cpp.
    """
    hay_en, bordes, lisos = zip(*(medidas(vistas[0]) for vistas in en_casos(p)))
    hasta = extremos_de(p)
    if not p.todo:
        hasta = random.Random(f"{p.nombre} {p.semilla}").sample(hasta, min(AL_AZAR, len(hasta)))
    for ordenes in hasta:
        guion = [*ordenes, "captura"]  # -diario: se dibuja una vez, y no sesenta
        talla = "{}x{}".format(*MENUDA)
        hay, corta, liso = medidas(p.vistas(guion, "-diario", talla=talla, LAB_SIN_ENCIMA="rotulo")[0])
        tras, de_cerca = f"tras {'; '.join(ordenes)}", ordenes[0].split()[0] in ("rueda", "boton")
        if hay < POCO * min(hay_en) and not de_cerca:
            yield "nada", f"se dibuja el {hay:.1f} % de la ventana, y en el caso que menos, {min(hay_en):.0f} %, {tras}"
        if liso > max(*lisos, LISO):
            yield "liso", f"el {liso:.0f} % de lo que se ve es de un color {tras}"
        if corta > max(bordes) + CORTE and not de_cerca:
            yield "corta", f"el {corta:.0f} % del borde está dibujado {tras}"
