"""Los controles de un programa, según su línea «// Controles:», y sucesos al azar de entre ellos.

controles.py objeto FICHERO PROGRAMA FUENTE…       el fuente que se enlaza con ese programa para que F1 los diga
                                                   (common/encima/ayuda.h): los del primer fuente que los tiene
controles.py guion RAÍZ BUILD PROGRAMA SEMILLA N   un guion de unas N órdenes al azar para ese programa
"""
import os
import random
import re
import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

from base import catalogo
from base.procesos import ejecuta, principal

ESPECIALES = {"←": "IZQUIERDA", "→": "DERECHA", "↑": "ARRIBA", "↓": "ABAJO"}
COMUNES = ["especial F5"]  # las teclas de todos (common/ventana.h), salvo Esc y las que salen de la ventana


@dataclass
class Control:
    texto: str
    teclas: list = field(default_factory=list)  # como se leen: a, espacio, ←
    hace: str = ""  # lo que dice de ellas

    @property
    def ordenes(self):
        return [orden_de(tecla) for tecla in self.teclas]

    @property
    def termina(self):
        return "termina" in self.hace

    @property
    def menu(self):
        return not self.teclas and "menú" in self.texto

    @property
    def partes(self):
        """Lo que se toca y lo que hace."""
        mando = re.match(r"(botón \w+|ratón|rueda|clic|menú|arrastrar?) (?=.)", self.texto)
        mando = mando[1] if mando else self.texto.removesuffix(self.hace).strip()
        return mando, self.texto[len(mando) :].strip()


def orden_de(tecla):
    """La orden del guion que da una tecla como se nombra en «// Controles:», o nada si no es una tecla."""
    if tecla in ESPECIALES:
        return "especial " + ESPECIALES[tecla]
    if re.fullmatch(r"F([1-9]|1[0-2])", tecla):
        return "especial " + tecla
    if tecla in ("espacio", "Esc"):
        return "tecla " + tecla.capitalize()
    return "tecla " + ("PuntoYComa" if tecla == ";" else tecla) if len(tecla) == 1 and tecla.isascii() else ""


def clase(tecla):
    return "cifra" if tecla.isdigit() else "letra" if tecla.isalpha() else "otra"


def analiza(texto):
    """Un control en teclas y lo que hacen: «a d giran» son dos teclas; «1 a 9 resaltan», nueve; «arrastra (o n y
    flechas)», cinco."""
    palabras = texto.replace(" o espacio ", " espacio ").split()
    if rango := re.match(r"(\d) a (\d) (.*)", texto):
        return Control(texto, [str(n) for n in range(int(rango[1]), int(rango[2]) + 1)], rango[3])
    if flechas := re.search(r" \(o (\w) y flechas\)$", texto):
        return Control(texto, [flechas[1], *ESPECIALES], texto[: flechas.start()])
    teclas = []
    while len(palabras) > 1 and orden_de(palabras[0]) and (not teclas or clase(teclas[0]) == clase(palabras[0])):
        teclas.append(palabras.pop(0))
    return Control(texto, teclas, " ".join(palabras))


def linea(fuente):
    """Lo que dice «// Controles:» hasta el punto final, aunque ocupe varias líneas; nada, si el fuente no la tiene."""
    hallado = re.search(r"^// Controles: ((?:.*\n// )*?.*)\.$", fuente.read_text(), re.MULTILINE)
    return hallado[1].replace("\n// ", " ") if hallado else ""


def de(texto):
    """Los que enumera ese texto."""
    return [analiza(c.strip()) for c in texto.split(" · ") if c]


def lee(raiz, programa):
    """Los que enumera su línea."""
    return de(linea(raiz / programa.fuente))


def objeto(programa, fuentes):
    suyos = " · ".join("\t".join(c.partes) for c in de(next(filter(None, map(linea, fuentes)), "")))
    return suyos and f'#include "ayuda.h"\nstatic const bool apuntados = apuntaControles("{programa}", R"({suyos})");\n'


def atiende(build, programa, guion="", **entorno):
    """De qué se entera tras ese guion: lo que dice -rasgos de él, y las opciones de sus menús, salvo la que lo
    termina."""
    raices = {"LAB_RAIZ": ":".join(map(str, programa.raices))} if programa.raices else {}
    dos = programa.ejecutable(build), programa.ejecutable(build, "egl")  # dicen lo mismo: el que esté compilado
    orden = [next((e for e in dos if e.exists()), dos[0]), "-guion", guion, "-rasgos"]
    with tempfile.TemporaryDirectory() as carpeta:
        dice = ejecuta(orden, cwd=carpeta, text=True, env={**os.environ, **raices, **entorno})
    rasgos = {linea for linea in dice.splitlines() if not linea.startswith("opcion ")}
    opciones = [linea.removeprefix("opcion ") for linea in dice.splitlines() if linea.startswith("opcion ")]
    return rasgos, [o for o in opciones if o != "Salir"]


def punto(azar, ancho, alto):
    return f"{azar.randrange(ancho)} {azar.randrange(alto)}"


def rueda(azar, ancho, alto):
    return [f"rueda {azar.choice(['+1', '-1'])} {punto(azar, ancho, alto)}"]


def clic(azar, ancho, alto):
    """Un clic o un arrastre en varios pasos."""
    boton = azar.choice(["IZQUIERDO", "IZQUIERDO", "DERECHO"])
    recorrido = [punto(azar, ancho, alto) for _ in range(azar.randint(1, 3))]
    arrastra = [f"arrastra {p}" for p in recorrido[1:]]
    return [f"boton {boton} abajo {recorrido[0]}", *arrastra, f"boton {boton} arriba {recorrido[-1]}"]


def tiempo(azar, *_):
    return [f"espera {azar.choice([1, 20, 333, 1700])}"]


MANDOS = {  # los que no son una tecla ni una opción, con de qué se entera quien los atiende
    clic: {"raton", "arrastre", "movimiento"},
    rueda: {"rueda"},
    tiempo: {"temporizador", "ocio"},
}


def raton_al_azar(azar, ancho, alto, rasgos):
    """Un clic, un arrastre o un giro de la rueda, dentro de la ventana."""
    return (rueda if "rueda" in rasgos and azar.random() < 0.3 else clic)(azar, ancho, alto)


def sucesos_al_azar(azar, controles, rasgos, opciones, ancho, alto):
    """Uno de lo que el programa dice que atiende, o de lo que atienden todos: órdenes del guion."""
    posibles = [o for c in controles if not c.termina for o in c.ordenes] + COMUNES + [f"menu {o}" for o in opciones]
    if rasgos & {"raton", "arrastre", "rueda", "movimiento"}:
        posibles += ["raton"] * max(2, len(posibles) // 4)
    if rasgos & MANDOS[tiempo]:
        posibles += tiempo(azar) * 2
    elegido = azar.choice(posibles)
    return raton_al_azar(azar, ancho, alto, rasgos) if elegido == "raton" else [elegido]


def paseo(azar, n, controles, rasgos, opciones, ancho, alto):
    """Al menos n órdenes, de suceso en suceso."""
    guion = []
    while len(guion) < n:
        guion += sucesos_al_azar(azar, controles, rasgos, opciones, ancho, alto)
    return guion


def main():
    que, *resto = sys.argv[1:]
    if que == "objeto":
        fichero, nombre, *fuentes = resto
        return catalogo.cambia(Path(fichero), objeto(nombre, map(Path, fuentes)))
    raiz, build, nombre, semilla, n = resto
    raiz, build = Path(raiz).resolve(), Path(build).resolve()
    programa = next(p for p in catalogo.lee_programas(build) if p.nombre == nombre)
    azar = random.Random(f"{nombre} {semilla}")
    print("; ".join(paseo(azar, int(n), lee(raiz, programa), *atiende(build, programa), 240, 180)))


if __name__ == "__main__":
    principal(main)
