"""La corrección de una entrega: en qué guiones se aparta de la solución, la nota, y de los que antes fallan, en
palabras y en imágenes."""
import base64
import itertools
import os
import tempfile
from pathlib import Path

from base.guiones import acorta, sin_veces
from base.procesos import en_png
from ejercicios.corrige.entrega import Rechazo
from ejercicios.corrige.motivos import como_acaba, no_responden
from ejercicios.corrige.partidas import Guion, Partida, lee_ppm

MUESTRA = 3  # guiones que fallan, con sus imágenes
INTENTOS = 24  # para acortar un guion
CUELGUES = 2  # tras los que no se juega más


def png(imagen, deja):
    ancho, alto, pixeles = imagen
    (deja / "i.ppm").write_bytes(b"P6\n%d %d\n255\n" % (ancho, alto) + pixeles)
    return base64.b64encode(en_png(deja / "i.ppm", 9)).decode()


def primero_distinto(unos, otros, falta):
    """La primera pareja que no son iguales, o None."""
    return next((p for p in itertools.zip_longest(unos, otros, fillvalue=falta) if p[0] != p[1]), None)


class Correccion:
    """En un diccionario que va tal cual a su JSON."""

    def __init__(self, banco, ficheros):
        self.banco, self.arbitro, self.ficheros = banco, banco.arbitro, ficheros

    def hazla(self):
        with tempfile.TemporaryDirectory(dir=self.banco.temporal) as carpeta:
            os.chmod(carpeta, 0o755)  # lo lee quien está en la jaula
            try:
                self.jugador = self.banco.compilador.compila(self.ficheros, Path(carpeta))
            except Rechazo as rechazo:
                return {"nota": 0, "dice": [str(rechazo)], "fallos": []}
            return self.compara()

    def compara(self):
        todos, solucion = self.banco.todos, self.banco.compilador.solucion
        self.esperadas = {g: self.arbitro.juega(solucion, g) for g in todos}
        self.partidas = {}
        for guion in todos:
            self.partidas[guion] = self.arbitro.juega(self.jugador, guion)
            if sum(p.cuelga for p in self.partidas.values()) >= CUELGUES:
                break
        donde = {g: self.arbitro.difiere(self.esperadas[g], p) for g, p in self.partidas.items()}
        fallan = {g: i for g, i in donde.items() if i is not None}
        bien = [g for g in todos if g in self.partidas and g not in fallan]
        muestra = self.muestra(fallan)
        acaban = list(dict.fromkeys(filter(None, (como_acaba(p, g) for g, p in self.partidas.items()))))
        dice = acaban[:3]
        if fallan and not acaban:
            dice += self.explica(fallan, muestra)
        return {"nota": self.nota(bien), "bien": len(bien), "guiones": len(todos), "dice": dice, "fallos": muestra}

    def nota(self, bien):
        """La parte de los guiones que salen bien; un caso vale por dos, y con un fallo no es 100."""
        todos = self.banco.todos
        valen = {g: 2 if g.caso else 1 for g in todos}
        nota = 100 * sum(valen[g] for g in bien) / sum(valen.values())
        return min(round(nota, 1), 100 if len(bien) == len(todos) else 99.9)

    def explica(self, fallan, muestra):
        porque = self.banco.motivos.por_que(self.partidas, fallan)
        if porque == [""]:
            return ["se ve lo mismo que en el punto de partida"]
        dice = ["; o ".join(filter(None, porque[:2]))] if porque else []
        callan, alguna = no_responden(self.partidas, self.esperadas)
        if callan and not alguna:
            dice.append("no responde a nada de lo que debería")
        else:
            dice += [f"«{orden}» no hace nada" for orden in callan[:5]]
        if any(fallo["tras"] and fallo["tras"][-1].startswith("tamano") for fallo in muestra):
            dice.append("está mal al cambiar el tamaño de la ventana")
        return dice

    def muestra(self, fallan):
        """De los guiones que antes fallan, sin repetir: qué órdenes bastan, en palabras y en imágenes."""
        vistos, fallos = [], []
        for guion in sorted(fallan, key=lambda g: (fallan[g], not g.caso))[: 4 * MUESTRA]:
            if len(fallos) == MUESTRA or [] in vistos:
                break
            if [sin_veces(o) for o in guion.ordenes[: fallan[guion]][-1:]] in vistos:  # ya se sabe que con eso basta
                continue
            tras, esperada, obtenida = self.acortado(guion, fallan[guion])
            bastan = [sin_veces(o) for o in tras]
            if bastan not in vistos:
                vistos.append(bastan)
                que = self.que(tras, esperada, obtenida)
                fallos.append(
                    {
                        "guion": guion.nombre,
                        "tras": list(tras),
                        "que": que,
                        "imagenes": self.imagenes(esperada, obtenida),
                    }
                )
        return fallos

    def acortado(self, guion, hasta):
        """Las órdenes de ese guion que bastan para que falle, y las dos partidas."""
        ordenes = guion.ordenes[:hasta]
        jugadas = {guion.ordenes: (self.esperadas[guion], self.partidas[guion])}

        def falla(candidatas):
            g = Guion("", tuple(candidatas))
            esperada = Partida.lee(self.arbitro.juega_de_nuevo(self.banco.compilador.solucion, g), g)
            jugadas[g.ordenes] = esperada, self.arbitro.juega(self.jugador, g)
            return self.arbitro.difiere(*jugadas[g.ordenes]) is not None

        if self.partidas[guion].cuelga:
            return ordenes, *jugadas[guion.ordenes]
        if ordenes:
            ordenes = acorta(ordenes, falla, INTENTOS)
        if ordenes not in jugadas:
            falla(ordenes)
        return ordenes, *jugadas[ordenes]

    def que(self, tras, esperada, obtenida):
        falla = "falla tras " + ", ".join(f"«{o}»" for o in tras) if tras else "falla ya al empezar"
        i = self.arbitro.difiere(esperada, obtenida)
        if (
            i is None
            or i >= len(obtenida.imagenes)
            or not self.arbitro.iguales(esperada.imagenes[i], obtenida.imagenes[i])
        ):
            return falla
        if otro := primero_distinto(esperada.titulos, obtenida.titulos, "título: (ninguno)"):
            return f"{falla}: el título es «{otro[1][8:]}» y debía ser «{otro[0][8:]}»"
        if esperada.texto and (otro := primero_distinto(esperada.texto.split("\n"), obtenida.texto.split("\n"), "")):
            return f"{falla}: escribe «{otro[1]}» y debía escribir «{otro[0]}»"
        return falla

    def imagenes(self, esperada, obtenida):
        """La entregada, la esperada y su diferencia donde se apartan, en PNG."""
        i = self.arbitro.difiere(esperada, obtenida)
        if i is None or i >= len(obtenida.imagenes):
            return []
        una, otra = esperada.imagenes[i], obtenida.imagenes[i]
        if self.arbitro.iguales(una, otra):
            return []
        with tempfile.TemporaryDirectory(dir=self.banco.temporal) as aqui:
            aqui = Path(aqui)
            imagenes = [otra, una]
            self.arbitro.compara(una, otra, deja=aqui / "d")
            if (aqui / "d-diferencia.ppm").exists():
                imagenes.append(lee_ppm((aqui / "d-diferencia.ppm").read_bytes()))
            return [png(imagen, aqui) for imagen in imagenes]
