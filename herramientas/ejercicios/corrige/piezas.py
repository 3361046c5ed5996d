"""La nota pieza a pieza: cada hueco de la entrega, puesto solo en la solución, juega los mismos guiones. Así quien hace
bien cuatro de cinco no saca lo mismo que quien no ha hecho nada."""
from pathlib import Path

from base.marcas import TROZO, esqueleto, fin_de_nadie
from ejercicios.corrige.entrega import COMENTARIO, Rechazo
from ejercicios.corrige.injerto import los_suyos, texto_de

BIEN, NADA = 1, 0
NO_COMPILA, PARECE = "no compila", "parece "  # así empieza lo que dice motivos.py de un error conocido


def pelado(texto):
    """Sin los comentarios ni los blancos."""
    crudo = texto if isinstance(texto, bytes) else texto.encode()
    return b"".join(COMENTARIO.sub(b"", crudo).split())


def por_hacer(trozo):
    """Lo que hay en ese hueco en el punto de partida."""
    return TROZO.match(esqueleto(trozo[0]))["hecho"]


def los_de(pedidos, hechos, ref):
    """De cada trozo que se pide, el de la entrega, o None: el que pide lo mismo o, si son tantos, el de su sitio. No
    vale el que se ha comido la marca de otro porque no se cierra."""
    hechos = [t for t in hechos if f"// {ref}: " not in t["hecho"]]
    piden = {t["pide"]: t for t in hechos}
    mismos = [piden.get(t["pide"]) for t in pedidos]
    en_su_sitio = len(hechos) == len(pedidos) and (None in mismos or len(piden) < len(hechos))
    return hechos if en_su_sitio else mismos


class SoloLoEntero(Exception):
    """Por qué no se sabe lo que vale cada pieza."""


class Piezas:
    """Las de una corrección que ya ha compilado entera."""

    def __init__(self, correccion):
        self.correccion, self.banco, self.motivos = correccion, correccion.banco, correccion.banco.motivos
        self.pedidos, ref = self.motivos.trozos(), self.banco.ref
        trozos = [t for _, t in self.pedidos]
        if len(trozos) < 2:
            raise SoloLoEntero("se pide una pieza sola")
        ficheros = correccion.entrega.los_que_alcanza(correccion.jugador.fuentes)
        self.suyos = los_de(trozos, los_suyos(ficheros, ref), ref)
        if None in self.suyos:
            pide = trozos[self.suyos.index(None)]["pide"]
            hallados = [(f, fin_de_nadie(texto_de(c), ref)) for f, c in sorted(ficheros.items())]
            mal = [f"; en {f}:{de[0]}, «{de[1]}» no es de nadie" for f, de in hallados if de]
            raise SoloLoEntero(
                f"no está entera la marca «// {ref}: {pide}», con su «// fin de {ref}»{''.join(mal[:1])}"
            )

    def juega(self):
        """De cada una, su parte, de 0 a 1, y qué errores conocidos parecen."""
        return [self.parte(i, t) for i, (_, t) in enumerate(self.pedidos)]

    def parte(self, i, pedido):
        suya = pelado(self.suyos[i]["hecho"])
        if suya == pelado(por_hacer(pedido)):
            return NADA, [f"{PARECE}que falta: {pedido['pide']}"]
        if suya == pelado(pedido["hecho"]):
            return BIEN, []
        memoria = self.banco.piezas  # las que son iguales, de otros, se juegan una vez
        if (i, suya) in memoria:
            return memoria[i, suya]
        jugador = self.jugador(i)
        parte = self.correccion.parte_de(jugador, self.motivos.sin_hacer(i))
        if jugador.raices[-1].parent.name.startswith("solucion"):  # si no, depende de lo demás suyo
            memoria[i, suya] = parte
        return parte

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
        pide = self.suyos[i]["pide"]
        raise SoloLoEntero(f"sola no se puede probar «{pide}»: necesita lo que has escrito en otro sitio")

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
