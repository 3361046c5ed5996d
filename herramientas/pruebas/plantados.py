"""docs/plantados.tsv: cómo se notó cada defecto la última vez que se plantó. Por renglones, entre tabuladores: su
lista; un resumen de su línea y otro de cómo estaba su fichero; y quién lo notó: el nombre de una prueba, lo que se
pinta encima (encima), solo la imagen (golden) o nadie. Lo escribe ./lab muta, de uno en uno; si cambian la línea o el
fichero, el defecto vuelve a estar pendiente, y lo primero que se prueba es lo que ya lo notó.
"""
import hashlib
from collections import Counter

from base.libro import filas
from base.procesos import escribe

FICHERO = "docs/plantados.tsv"
PRUEBA, ENCIMA, GOLDEN, NADIE = "prueba", "encima", "golden", "nadie"
CUENTA = {"notados": (PRUEBA, ENCIMA, GOLDEN), "sin_golden": (PRUEBA,), "encima": (ENCIMA,)}


def resumen(*textos):
    return hashlib.sha1("\0".join(textos).encode()).hexdigest()[:10]


def de_linea(mutante):
    return resumen(mutante.fichero, mutante.texto, mutante.estropeado)


class Plantados:
    """Los de esas listas, con sus ficheros como están al empezar."""

    def __init__(self, raiz, mutantes):
        self.fichero, self.mutantes = raiz / FICHERO, mutantes
        textos = {f: (raiz / f).read_text() for f in {m.fichero for m in mutantes} if (raiz / f).is_file()}
        self.de_fichero = {f: resumen(texto) for f, texto in textos.items()}
        self.lineas = {de_linea(m): m for m in mutantes}
        self.apuntados = {}
        if self.fichero.exists():
            self.apuntados = {linea: (con, quien) for _, linea, con, quien in filas(self.fichero)}

    def pendientes(self):
        """Los que no se han plantado desde que cambiaron ellos o su fichero."""
        return [
            m
            for linea, m in self.lineas.items()
            if self.apuntados.get(linea, [None])[0] != self.de_fichero.get(m.fichero)
        ]

    def apunta(self, mutante):
        quien = mutante.por or mutante.notado or NADIE
        self.apuntados[de_linea(mutante)] = self.de_fichero[mutante.fichero], quien
        renglones = sorted(
            (m.lista, linea, *self.apuntados[linea]) for linea, m in self.lineas.items() if linea in self.apuntados
        )
        escribe(self.fichero, "".join("\t".join(renglon) + "\n" for renglon in renglones))

    def lo_notan(self):
        """De cada (fichero, prueba), cuántos de sus defectos ha notado."""
        return Counter((m.fichero, self.quien(m)) for m in self.lineas.values())

    def quien(self, mutante):
        return self.apuntados.get(de_linea(mutante), ("", ""))[1]

    def cuentas(self):
        """De cada lista, cuántos hay, cuántos se han plantado como están, cuántos se notan, cuántos sin mirar los
        golden y cuántos más por lo que se pinta encima."""
        de = {}
        for m in sorted(self.lineas.values(), key=lambda m: m.lista):
            suya = de.setdefault(m.lista, dict.fromkeys(("hay", "plantados", *CUENTA), 0))
            quien = self.quien(m)
            suya["hay"] += 1
            suya["plantados"] += quien != ""
            for que, quienes in CUENTA.items():
                suya[que] += (quien if quien in ("", ENCIMA, GOLDEN, NADIE) else PRUEBA) in quienes
        return de
