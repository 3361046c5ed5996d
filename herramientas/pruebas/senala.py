"""senala.py RAÍZ BUILD [EJERCICIO…] [--uno-de N] [-v]: si lo primero que dice ./lab corrige que se aparta (donde.py) es
donde está el error, con uno de cada N de los conocidos (herramientas/ejercicios/errores) que cambian alguna imagen. Lo
que debe decir está en tests/casos/senala.tsv; de un shader, que sea una de sus líneas. Escribe los que no o, con -v,
todos. Estado 1 si lo dicen menos del 70 %."""
import difflib
import re
import sys
import tempfile
from pathlib import Path

from base import catalogo, defectos
from base.procesos import principal
from ejercicios import nuevo
from ejercicios.corrige.banco import Banco
from ejercicios.corrige.partidas import Guion
from ejercicios.reglas import Reglas

LISTA = "tests/casos/senala.tsv"
PARTE = 0.7


def falla(banco, jugador):
    """El primer guion en que se nota, hasta donde se nota, y las dos imágenes; o nada."""
    for g in banco.todos:
        esperada = banco.arbitro.juega(banco.compilador.solucion, g)
        obtenida = banco.arbitro.juega(jugador, g, esperada)
        i = banco.arbitro.difiere(esperada, obtenida)
        if i is not None and i < len(obtenida.imagenes):
            return Guion("", g.ordenes[:i]), esperada.imagenes[i], obtenida.imagenes[i]
    return None


def lineas(bien, mal):
    """Las que cambian de uno a otro, en el segundo."""
    cambios = difflib.SequenceMatcher(None, bien.splitlines(), mal.splitlines(), autojunk=False).get_opcodes()
    return {n + 1 for que, _, _, desde, hasta in cambios for n in range(desde, max(hasta, desde + 1)) if que != "equal"}


def es_ahi(debe, m, hallado, suyas):
    if m.en_shader and hallado.get("fichero") == Path(m.fichero).name:
        return hallado["linea"] in suyas
    reglas = [r for r in debe if r[0] == m.fichero and r[1] in f"{m.texto} {m.estropeado} {m.imita}"]
    return any(re.search(r[2], hallado["dice"]) for r in reglas)


def de_ejercicio(raiz, build, ref, programa, temporal, uno_de):
    """De cada error que se ve, lo que se dice; None, si nada."""
    banco = Banco(raiz, build, ref, programa, temporal, None, 1, Reglas())
    suyos = banco.motivos.defectos
    for k, (m, (_, jugador)) in enumerate(zip(suyos, banco.motivos.variantes()[-len(suyos) :])):
        if k % uno_de:
            continue
        caso = falla(banco, jugador)
        if caso:
            textos, nombre = banco.motivos.textos(), Path(m.fichero).name
            bien = banco.motivos.limpio(textos)
            mal = banco.motivos.limpio({**textos, nombre: defectos.estropea(textos[nombre], m)})
            yield m, banco.donde.busca(jugador, mal, *caso), lineas(bien[nombre], mal[nombre])


def main():
    raiz, build = (Path(p).resolve() for p in sys.argv[1:3])
    resto, uno_de = [p for p in sys.argv[3:] if p != "-v"], 1
    if "--uno-de" in resto:
        i = resto.index("--uno-de")
        uno_de = int(resto[i + 1])
        del resto[i : i + 2]
    hay = nuevo.ejercicios(raiz, catalogo.lee_programas(build))
    debe = [f.split("\t") for f in (raiz / LISTA).read_text().splitlines() if f and f[0] != "#"]
    vistos = bien = 0
    for ref in resto or hay:
        with tempfile.TemporaryDirectory() as temporal:
            for m, hallado, suyas in de_ejercicio(raiz, build, ref, hay[ref], Path(temporal), uno_de):
                acierta = bool(hallado) and es_ahi(debe, m, hallado, suyas)
                vistos, bien = vistos + 1, bien + acierta
                if not acierta or "-v" in sys.argv:
                    print(f"{'+' if acierta else '-'} {m.nombre} {m.imita}: {hallado and hallado['dice']}", flush=True)
    print(f"{bien} de {vistos} ({bien / max(vistos, 1):.0%}) dicen dónde está el error")
    return bool(resto or hay) and (vistos == 0 or bien < PARTE * vistos)


if __name__ == "__main__":
    principal(main)
