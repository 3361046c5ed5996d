"""docs/plantados.tsv: cómo se notó cada defecto la última vez que se plantó. Por renglones, entre tabuladores: su
lista; un resumen de su línea y otro de cómo estaba su fichero; y quién lo notó: una prueba, lo que se pinta encima
(encima), solo la imagen (golden) o nadie. Lo escribe ./lab muta, de uno en uno; si cambian la línea o el fichero, el
defecto vuelve a estar pendiente.
"""
import hashlib

from base.libro import filas
from base.procesos import escribe

FICHERO = "docs/plantados.tsv"
PRUEBA, NADIE = "prueba", "nadie"
CUENTA = {"notados": (PRUEBA, "encima", "golden"), "sin_golden": (PRUEBA,), "encima": ("encima",)}


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
        quien = (mutante.por or PRUEBA) if mutante.notado else NADIE
        self.apuntados[de_linea(mutante)] = self.de_fichero[mutante.fichero], quien
        renglones = sorted(
            (m.lista, linea, *self.apuntados[linea]) for linea, m in self.lineas.items() if linea in self.apuntados
        )
        escribe(self.fichero, "".join("\t".join(renglon) + "\n" for renglon in renglones))

    def cuentas(self):
        """De cada lista, cuántos hay, cuántos se han plantado como están, cuántos se notan, cuántos sin mirar los
        golden y cuántos más por lo que se pinta encima."""
        de = {}
        for linea, m in sorted(self.lineas.items(), key=lambda par: par[1].lista):
            suya = de.setdefault(m.lista, dict.fromkeys(("hay", "plantados", *CUENTA), 0))
            quien = self.apuntados.get(linea, ("", ""))[1]
            suya["hay"] += 1
            suya["plantados"] += quien != ""
            for que, quienes in CUENTA.items():
                suya[que] += quien in quienes
        return de
