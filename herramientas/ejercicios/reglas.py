"""Cómo se puntúa: lo que se dice en el reglas.txt de un ejercicio propio, o en el de --reglas; lo que no, como siempre.

    # clave = valor
    caso = 3
    tolerancia = otro
"""
import re
from dataclasses import dataclass, fields, replace

from base.procesos import Fallo
from ejercicios import propios

FICHERO = "reglas.txt"
TOLERANCIAS = "redondeo", "amplia", "otro"  # las del comparador, de la más estrecha a la más ancha
CIEN = 100
NUMERO = "[0-9]{1,4}(?:[.,][0-9]{1,3})?"


@dataclass(frozen=True)
class Reglas:
    """Los pesos; cuántos guiones son al azar; con qué tolerancia son la misma dos imágenes; de cada cien puntos, los
    que da una que se ve casi igual, los que da un caso que se ve bien y falla al seguirlo y los que quita, una vez, lo
    que no es la imagen; y la escala, si se califica con palabras."""

    caso: float = 2
    azar: float = 1
    guiones: int = 24
    tolerancia: str = "amplia"
    casi: float = 50
    medias: float = 50
    titulo: float = 5
    texto: float = 20
    estado: float = 5
    huecos: float = 50
    pesos: str = "iguales"
    cuesta_mas: float = 60
    semillas: str = "1"
    escala: str = "ninguna"

    def peso(self, guion):
        return self.caso if guion.caso else self.azar

    def cuesta(self, que):
        """Lo que no es la imagen, como lo llama arbitro.aparte."""
        return getattr(self, que.replace("í", "i"))

    def de_cada(self, cuantas):
        """Lo que pesa cada pieza."""
        pesos = numeros(self.pesos) or [1] * cuantas
        if len(pesos) != cuantas:
            raise Fallo(f"pesos = {self.pesos}: son {len(pesos)}, y las piezas que se piden, {cuantas}")
        return pesos

    def junta(self, entero, piezas):
        """La parte de lo entero y la de cada pieza, si se sabe, en una, que no es menos que lo que pesan las que están
        del todo bien. Si lo están todas y lo entero no, lo de fuera cuenta como la que menos pesa."""
        if not piezas:
            return entero
        pesos = self.de_cada(len(piezas))
        media = sum(peso * pieza for peso, pieza in zip(pesos, piezas)) / sum(pesos)
        mal = sum(peso for peso, pieza in zip(pesos, piezas) if pieza < 1) or min(filter(None, pesos))
        return max(entero + self.huecos / CIEN * (media - entero), 1 - mal / sum(pesos))

    @property
    def cuanto_casi(self):
        return "la mitad" if self.casi == CIEN / 2 else f"{self.casi:g} de {CIEN}" if self.casi else "cero"

    @property
    def en_palabras(self):
        """Todas, para cada informe."""
        al_azar = (
            f"{self.guiones} al azar, {self.azar:g} cada uno" if self.guiones and self.azar else "al azar, ninguno"
        )
        return (
            f"guiones: los casos, {self.caso:g} cada uno; {al_azar}; tolerancia {self.tolerancia}; lo casi igual, "
            f"{self.casi:g} %; un caso que se ve bien y falla al seguir, {self.medias:g} %; quitan, de 100, el título "
            f"{self.titulo:g}, el texto {self.texto:g} y el estado con que acaba {self.estado:g}; de lo "
            f"que no es 100, las piezas, cada una por su cuenta, {self.huecos:g} %"
            f"{f', con pesos {self.pesos}' if numeros(self.pesos) else ''}"
            f"{', y nunca menos de lo que pesan las que están bien' if self.huecos else ''}"
        ) + (f"; escala: {self.escala}" if self.tramos else "")

    @property
    def tramos(self):
        """De la escala, desde cuántos puntos es cada palabra."""
        return tramos(self.escala) or []


def valor(clave, texto):
    """El de esa clave, o nada si no vale."""
    if clave == "tolerancia":
        return texto if texto in TOLERANCIAS else None
    if clave == "pesos":
        return texto if sum(numeros(texto)) else None
    if clave == "semillas":
        return texto if re.fullmatch(r"ninguna|\d{1,9}(\s+\d{1,9})*", texto) else None
    if clave == "guiones":
        return int(texto) if re.fullmatch("[0-9]{1,6}", texto) else None
    if clave == "escala":
        return texto if tramos(texto) else None
    numero = float(texto.replace(",", ".")) if re.fullmatch(NUMERO, texto) else None
    return numero if numero is not None and (numero <= CIEN or clave in ("caso", "azar")) else None


def numeros(texto):
    """Los de «2 1 1», o ninguno."""
    son = re.fullmatch(rf"{NUMERO}(\s+{NUMERO})*", texto)
    return [float(n.replace(",", ".")) for n in texto.split()] if son else []


def tramos(escala):
    """Los de «0 No apto; 50 Apto», de menos a más y desde cero."""
    leidos = [re.fullmatch(rf"({NUMERO})\s+(.+)", tramo.strip()) for tramo in escala.split(";")]
    hay = [(float(t[1].replace(",", ".")), t[2]) for t in leidos if t]
    desde = [d for d, _ in hay]
    return hay if all(leidos) and desde[0] == 0 and desde == sorted({*desde}) and desde[-1] <= CIEN else None


VALEN = {"tolerancia": ", ".join(TOLERANCIAS), "guiones": "un número natural", "caso": "un peso, de 0 a 9999"}
VALEN["azar"] = VALEN["caso"]
VALEN["semillas"] = "las de los guiones que se reparten, «1 7», o «ninguna»"
VALEN["pesos"] = "lo que pesa cada pieza, en el orden del enunciado: «2 1 1»"
VALEN["escala"] = "desde cuántos puntos es cada palabra: «0 No apto; 50 Apto»"


def lee(fichero, como_siempre=Reglas()):
    """Lo que dice un reglas.txt, y lo demás, como siempre."""
    dice = {}
    for n, renglon in propios.renglones(fichero):
        clave, es, texto = (parte.strip() for parte in renglon.partition("="))
        clave, donde = clave.replace("í", "i"), f"{fichero}:{n}"
        if not es:
            raise Fallo(f"{donde}: es «clave = valor»")
        if clave not in (claves := [f.name for f in fields(Reglas)]):
            raise Fallo(f"{donde}: no hay ninguna regla «{clave}»: {', '.join(claves)}")
        if clave in dice:
            raise Fallo(f"{donde}: «{clave}» está dos veces")
        if (leido := valor(clave, texto)) is None:
            raise Fallo(f"{donde}: «{texto}» no vale de {clave}: {VALEN.get(clave, 'puntos, de 0 a 100')}")
        dice[clave] = leido
    return comprueba(replace(como_siempre, **dice), fichero)


def comprueba(reglas, fichero):
    if not reglas.caso and not (reglas.azar and reglas.guiones):
        raise Fallo(f"{fichero}: con esos pesos no queda nada que puntúe")
    if reglas.titulo + reglas.texto + reglas.estado > CIEN:
        raise Fallo(f"{fichero}: el título, el texto y el estado quitan entre los tres más de {CIEN} puntos")
    return reglas


def del_programa(programa, fichero=None, guiones=None, como_siempre=Reglas()):
    """Las de ese fichero o, sin él, las de su carpeta si es propio; y de los guiones, los que se digan."""
    if fichero and not fichero.is_file():
        raise Fallo(f"no hay ningún fichero «{fichero}»")
    suyo = fichero or (programa.carpeta / FICHERO if programa.raices else None)
    reglas = lee(suyo, como_siempre) if suyo else como_siempre
    return reglas if guiones is None else comprueba(replace(reglas, guiones=guiones), suyo or "--guiones")
