"""La nota de ./lab corrige de lo que hacen unos estudiantes: el punto de partida, la solución, la misma escrita de otra
manera y algunos de los errores que se conocen. La página tiene que dar la misma (notas.mjs)."""
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from base import catalogo, defectos
from ejercicios import comprueba, en_pagina, nuevo

AL_AZAR = 4  # guiones, además de los casos
ERRORES = 2


def programas(raiz, build):
    return en_pagina.los_que_hay(raiz, catalogo.lee_programas(build))


def entregas(c):
    """Sus ficheros, por lo que son."""
    bien = [m for m in defectos.lee(c.raiz / comprueba.BIEN)[0] if m.lista == c.ref][-1:]
    mal = c.banco.motivos.defectos
    hechas = dict(zip(("el punto de partida", "la solución"), c.banco.dados))
    for m in (*bien, *mal[:: max(1, -(-len(mal) // ERRORES))]):
        hechas[f"{m.nombre}, {m.imita}"] = c.banco.motivos.limpio(c.banco.motivos.estropeados(m))
    return hechas


def de(raiz, build, ref):
    """Lo que se juega y, de cada entrega, sus ficheros y su nota; y lo que se juega si no se dice otra cosa."""
    programa = programas(raiz, build)[ref]
    cuantos = None if nuevo.es_de_shaders(ref) else AL_AZAR
    with tempfile.TemporaryDirectory() as temporal, ThreadPoolExecutor(2) as hilos:
        c = comprueba.Comprobacion(raiz, build, ref, programa, Path(temporal), hilos, cuantos)
        hechas = {}
        for i, (nombre, ficheros) in enumerate(entregas(c).items()):
            nota, mal, *_ = c.entregado(ficheros, f"e{i}")
            assert not mal, mal
            hechas[nombre] = {"ficheros": ficheros, "nota": nota}
    return {"datos": en_pagina.corrige(raiz, build, programa, ref, cuantos), "entregas": hechas}
