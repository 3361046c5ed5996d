"""La nota pieza a pieza: cada hueco de la entrega, puesto solo en la solución, juega los mismos guiones. Así quien hace
bien cuatro de cinco no saca lo mismo que quien no ha hecho nada."""
from pathlib import Path

from base.marcas import TROZO, esqueleto
from ejercicios.corrige.entrega import COMENTARIO, Rechazo
from ejercicios.corrige.injerto import los_suyos, texto_de

BIEN, NADA = 1, 0
NO_COMPILA = "no compila"


def pelado(texto):
    """Sin los comentarios ni los blancos."""
    crudo = texto if isinstance(texto, bytes) else texto.encode()
    return b"".join(COMENTARIO.sub(b"", crudo).split())


def por_hacer(trozo):
    """Lo que hay en ese hueco en el punto de partida."""
    return TROZO.match(esqueleto(trozo[0]))["hecho"]


def los_de(pedidos, hechos, ref):
    """De cada trozo que se pide, el de la entrega, o None: el que pide lo mismo o, si son tantos, el de su sitio. El que
    se ha comido la marca de otro, porque no se cierra, no vale."""
    hechos = [t for t in hechos if f"// {ref}: " not in t["hecho"]]
    piden = {t["pide"]: t for t in hechos}
    mismos = [piden.get(t["pide"]) for t in pedidos]
    en_su_sitio = len(hechos) == len(pedidos) and (None in mismos or len(piden) < len(hechos))
    return hechos if en_su_sitio else mismos


class Piezas:
    """Las de una corrección que ya ha compilado entera."""

    def __init__(self, correccion):
        self.correccion, self.banco = correccion, correccion.banco
        self.motivos, self.pedidos = self.banco.motivos, self.banco.motivos.trozos()
        self.ficheros = correccion.entrega.los_que_alcanza(correccion.jugador.fuentes)

    def juega(self):
        """(la parte de cada una, "") o, si no se puede saber, ([], por qué)."""
        trozos = [t for _, t in self.pedidos]
        if len(trozos) < 2:
            return [], "se pide una pieza sola"
        self.suyos = los_de(trozos, los_suyos(self.ficheros, self.banco.ref), self.banco.ref)
        if None in self.suyos:
            pide = trozos[self.suyos.index(None)]["pide"]
            return [], f"no está entera la marca «// {self.banco.ref}: {pide}», con su «// fin de {self.banco.ref}»"
        partes = []
        for i, t in enumerate(trozos):
            parte = self.parte(i)
            if parte is None:
                sola = f"sola no se puede probar «{t['pide']}»: necesita lo que has escrito en otro sitio"
                return [], sola if self.correccion.hay_tiempo else "es muy lento"
            partes.append(parte)
        return partes, ""

    def parte(self, i):
        """La que saca esa, de 0 a 1; None, si sola no compila o no hay tiempo."""
        suya, pedido = pelado(self.suyos[i]["hecho"]), self.pedidos[i][1]
        if suya == pelado(por_hacer(pedido)):
            return NADA
        if suya == pelado(pedido["hecho"]):
            return BIEN
        memoria = self.banco.piezas  # las que son iguales, de otros, se juegan una vez
        if (i, suya) not in memoria:
            jugador = self.jugador(i)
            parte = self.correccion.parte_de(jugador, self.motivos.sin_hacer(i)) if jugador else None
            if parte is None or jugador.raices[-1].parent.name.startswith("entrega"):  # depende de lo demás suyo
                return parte
            memoria[i, suya] = parte
        return memoria[i, suya]

    def jugador(self, i):
        """La solución con esa pieza o, si usa lo que está fuera de ella, la entrega con las demás de la solución."""
        carpeta = Path(self.correccion.carpeta)
        for donde, ficheros, intentos in (
            ("solucion", self.en_la_solucion(i), ()),
            ("entrega", self.con_las_demas(i), [self.correccion.jugador.fuentes]),
        ):
            try:
                return self.banco.compilador.compila(ficheros, carpeta / f"{donde}{i}", intentos=intentos)
            except Rechazo:
                continue
        return None

    def en_la_solucion(self, i):
        f, t = self.pedidos[i]
        textos = self.motivos.textos()
        hecha = t["abre"] + self.suyos[i]["hecho"] + t["cierra"]
        return self.motivos.limpio(textos | {f: textos[f][: t.start()] + hecha + textos[f][t.end() :]})

    def con_las_demas(self, i):
        """La entrega entera, con lo que no es esa pieza hecho como en la solución."""
        ficheros = {f: texto_de(c) for f, c in self.correccion.entrega.ficheros.items()}
        limpio = self.motivos.limpio({str(j): t[0] for j, (_, t) in enumerate(self.pedidos)})
        for j, suyo in enumerate(self.suyos):
            if j != i:
                ficheros = {f: texto.replace(suyo[0], limpio[str(j)]) for f, texto in ficheros.items()}
        return {f: texto.encode() for f, texto in ficheros.items()}
