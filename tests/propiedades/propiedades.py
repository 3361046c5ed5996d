#!/usr/bin/env python3
"""propiedades.py RAÍZ BUILD PROGRAMA… [--ordenes N] [--semilla N] [--solo PROPIEDAD]: lo que todo programa cumple, sin escribir nada
para ninguno. Lo que se puede hacer con él lo dice su línea «// Controles:», y lo que ha pasado, su diario (-ayuda).

Lo que un programa no cumple está en EXCEPCIONES con su motivo; una que ya no haga falta también es un fallo.
"""
import argparse
import os
import random
import re
import string
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2] / "herramientas"))
import catalogo
import controles

TALLA, OTRAS = "120x90", ("150x90", "100x100")
CARACTERES = [c for c in string.printable if c.isprintable() and c not in " ;"]
SIN_NOMBRE = [controles.orden_de(c) for c in CARACTERES] + [f"tecla {t}" for t in ("Espacio", "PuntoYComa", "Intro", "Tab", "Retroceso", "Supr")] + \
    [f"especial {t}" for t in ("F1", "F2", "F3", "F4", "F6", "F10", "IZQUIERDA", "DERECHA", "ARRIBA", "ABAJO", "INICIO", "FIN", "REPAG", "AVPAG")]


@dataclass
class Fila:
    """Lo que queda tras una orden. `escrito`: lo que ha escrito mientras."""
    orden: str
    imagen: str
    repetida: str
    titulo: str
    cambiado: str
    objetos: str
    bytes: int
    temporizadores: int
    escrito: tuple

    def se_ve(self):
        return self.imagen, self.titulo

    def distinta(self, otra):
        return self.se_ve() != otra.se_ve() or bool(self.escrito)


class Termina(Exception):
    pass


class Programa:
    def __init__(self, raiz, build, programa):
        self.nombre = programa.nombre
        enlace = (build / "sin_ventana").read_text().strip()
        self.ejecutable = build / enlace / programa.capitulo.nombre / programa.nombre
        self.entorno = {**os.environ, **dict(linea.split("=", 1) for linea in (build / "entorno.txt").read_text().split())}
        self.controles = [c for c in controles.lee(raiz, programa) if c.texto != "ninguno"]
        self.dice = " · ".join(c.texto for c in self.controles)
        self.teclas = [o for c in self.controles if not c.termina for o in c.ordenes if o not in controles.COMUNES]
        self.cualquiera = "cualquier tecla" in self.dice  # atiende todo
        rasgos = self.ejecuta(["-rasgos"]).splitlines()
        self.opciones = [o for o in (r.removeprefix("opcion ") for r in rasgos if r.startswith("opcion ")) if o != "Salir"]
        self.rasgos = {r for r in rasgos if not r.startswith("opcion ")}
        self.anima = bool({"temporizador", "ocio"} & self.rasgos)
        self.mandos = self.teclas + [f"menu {o}" for o in self.opciones]
        self.previas = {}  # lo que ha dado antes_de

    def ejecuta(self, opciones, talla=TALLA):
        with tempfile.TemporaryDirectory() as carpeta:
            r = subprocess.run([self.ejecutable, "-geometry", talla, "-ppm", "imagen.ppm", *opciones], cwd=carpeta, env=self.entorno, text=True,
                               stdin=subprocess.DEVNULL, capture_output=True)
        if r.returncode or r.stderr:
            raise Termina(f"estado {r.returncode}: {r.stderr.strip()[-2000:]}\n  con {opciones[-1]}")
        return r.stdout

    def diario(self, ordenes, talla=TALLA):
        """Una fila al empezar y una por orden."""
        filas, escrito = [], []
        for linea in self.ejecuta(["-diario", "-guion", "; ".join(ordenes)], talla).split("\n"):
            if not linea.startswith("diario\t"):
                escrito += [linea] if linea else []
                continue
            _, orden, imagen, repetida, titulo, cambiado, objetos, ocupa, esperan = linea.split("\t")
            filas.append(Fila(orden, imagen, repetida, titulo, cambiado, objetos, int(ocupa), int(esperan), tuple(escrito)))
            escrito = []
        return filas

    def ventana(self, ordenes, talla=TALLA):
        """El título y los colores con que acaba."""
        with tempfile.TemporaryDirectory() as carpeta:
            fichero = Path(carpeta, "imagen.ppm")
            titulos = self.ejecuta(["-titulos", "-guion", "; ".join([*ordenes, f"captura {fichero}"])], talla)
            return [linea for linea in titulos.splitlines() if linea.startswith("título: ")][-1], fichero.read_bytes().split(b"\n255\n", 1)[1]

    def hace_algo(self, antes, orden):
        """Si esa orden cambia algo tras las de `antes`, ya o al pasar el tiempo."""
        filas = self.diario([*antes, orden])
        if filas[-1].distinta(filas[-2]) or not self.anima:
            return filas[-1].distinta(filas[-2])
        return self.diario([*antes, orden, "espera 500"])[-1].distinta(self.diario([*antes, "espera 500"])[-1])

    def antes_de(self, orden):
        """Con qué mando delante hace algo esa orden: con ninguno, si basta; None, si con ninguno lo hace."""
        if orden not in self.previas:
            previas = [[], *([otra] for otra in self.mandos if otra != orden)]
            self.previas[orden] = next((antes for antes in previas if self.hace_algo(antes, orden)), None)
        return self.previas[orden]


def arrastre(x0, y0, x1, y1, boton="IZQUIERDO", pasos=1):
    puntos = [(round(x0 + (x1 - x0) * k / pasos), round(y0 + (y1 - y0) * k / pasos)) for k in range(pasos + 1)]
    return [f"boton {boton} abajo {x0} {y0}", *(f"arrastra {x} {y}" for x, y in puntos[1:]), f"boton {boton} arriba {x1} {y1}"]


# --- las propiedades: cada una da los fallos que encuentra: en qué y cuál ----------------------------------------------


def paseo(p, ordenes, semilla):
    """Sucesos al azar, con tamaños, F5 y teclas que no son suyas entre ellos. El primer cuadro puede dejar puesto lo que es de todos."""
    azar = random.Random(f"{p.nombre} {semilla}")
    ajenas = [] if p.cualquiera else [o for o in SIN_NOMBRE if o not in p.teclas]
    guion = []
    while len(guion) < ordenes:
        guion += controles.sucesos_al_azar(azar, p.controles, p.rasgos, p.opciones, 120, 90)
        cual = azar.random()
        if cual < 0.3 and ajenas:
            guion.append(azar.choice(ajenas))
        elif cual < 0.4:
            guion += [f"tamano {azar.choice(['120 90', '150 90', '100 100', '61 45'])}", "especial F5"]
    filas = p.diario(guion)
    hechas, temporizadores = set(), max(filas[0].temporizadores, 1)
    for i, (orden, antes, fila) in enumerate(zip(guion, filas, filas[1:])):
        donde = f"tras {'; '.join(guion[max(0, i - 3):i + 1])}"
        if fila.repetida:
            yield "repetir", f"el mismo cuadro dibujado otra vez es distinto {donde}"
        if fila.cambiado and i > 0:
            yield "estado", f"el cuadro no deja OpenGL como estaba: {fila.cambiado}, {donde}"
        if orden == "especial F5" and fila.distinta(antes) and not p.cualquiera:
            yield "F5", f"releer lo mismo cambia algo {donde}"
        if orden == "especial F5" and fila.objetos != antes.objetos:
            yield "objetos", f"releer lo mismo deja otros objetos {donde}: {antes.objetos} → {fila.objetos}"
        if orden in ajenas and fila.distinta(antes):
            yield "ajena", f"«{orden}» hace algo y no está en «// Controles:», {donde}"
        if fila.distinta(antes):
            hechas.add(orden)
        if fila.temporizadores > temporizadores:
            yield "temporizadores", f"esperan {fila.temporizadores} temporizadores {donde}"
    for orden in p.mandos:
        if orden not in hechas and p.antes_de(orden) is None:
            yield orden, f"«{orden}» no hace nada, ni tras ninguna otra"


def nombres(p):
    """Lo que se nombra y lo que se atiende: el ratón, la rueda, el menú."""
    dice = p.dice.replace("botón derecho menú", "menú").replace("ratón orbita", "ratón orbita, rueda acerca")
    if p.cualquiera:
        dice += ", rueda"
    for que, palabras, hay in (("ratón", ("ratón", "rrastra", "clic", "botón"), bool({"raton", "arrastre"} & p.rasgos)),
                               ("rueda", ("rueda",), "rueda" in p.rasgos), ("menú", ("menú",), bool(p.opciones))):
        nombra = any(palabra in dice for palabra in palabras)
        if nombra != hay:
            yield que, f"«// Controles:» {'nombra' if nombra else 'no nombra'} {que} y el programa {'lo' if hay else 'no lo'} atiende"


CONTRARIAS = [set(par.split()) for par in ("+ -", "a d", "q e", "w s", ", .", "u U", "i o")]


def limites(p):
    """De dos teclas contrarias una deshace la otra. O dan la vuelta o llegan a un límite, en el que se deja de contar."""
    for c in p.controles:
        if set(c.teclas) not in CONTRARIAS or c.termina or None in map(p.antes_de, c.ordenes):
            continue
        for mas, menos in (c.ordenes, c.ordenes[::-1]):
            antes = p.antes_de(mas)
            filas = p.diario([*antes, mas, menos, mas, menos, f"{mas} ×300", mas, menos, mas, f"{menos} ×600", f"{mas} ×600", menos])[len(antes):]
            nada, sube, baja, _, vuelve, tope, otra, uno, torna, _, lejos, cerca = filas
            if sube.distinta(nada) and (baja.imagen != nada.imagen or vuelve.se_ve() != baja.se_ve()):
                yield mas, f"«{menos}» no deshace «{mas}»"
            if otra.se_ve() != tope.se_ve():
                continue  # da la vuelta
            if uno.se_ve() == tope.se_ve():
                yield mas, f"pasado el límite de «{mas}», «{menos}» no hace nada"
            if not torna.se_ve() == lejos.se_ve() == tope.se_ve() or cerca.se_ve() != uno.se_ve():
                yield mas, f"al límite de «{mas}» no se vuelve por donde se fue"


def comparacion(p):
    """Con la comparación puesta toda tecla hace algo, o la deja."""
    if "tecla v" not in p.teclas:
        return
    for orden in p.teclas:
        antes = p.antes_de(orden)
        if orden == "tecla v" or antes is None or p.hace_algo([*antes, "tecla v"], orden):
            continue
        if p.diario([*antes, "tecla v", orden])[-1].se_ve() != p.diario([*antes, orden])[-1].se_ve():
            yield orden, f"«{orden}» no hace nada en la comparación, ni la deja"


def parecidas(una, otra):
    """El mismo título y, salvo lo que pueda mover el redondeo, la misma imagen: uno de cada cien colores, más de 3 niveles."""
    return una[0] == otra[0] and len(una[1]) == len(otra[1]) and 100 * sum(abs(a - b) > 3 for a, b in zip(una[1], otra[1])) <= len(una[1])


def tallas(p, semilla):
    """Lo hecho en una ventana y llevado a otra es lo mismo que hecho en esa. Sin las flechas, que mueven hasta cerca del borde de la que hay."""
    azar = random.Random(f"{p.nombre} {semilla}")
    mandos = [o for o in p.mandos if not o.startswith("especial ")]
    for otra in OTRAS:
        guion = azar.choices(mandos, k=8) if mandos else []
        if not parecidas(p.ventana([*guion, "tamano " + otra.replace("x", " ")]), p.ventana(guion, otra)):
            yield "talla", f"en una ventana de {TALLA} llevada a {otra} no se ve lo mismo que en una de {otra}, con {'; '.join(guion)}"


def arrastres(p):
    """Arrastrar en un paso o en tres deja lo mismo."""
    if "arrastre" not in p.rasgos or p.cualquiera:
        return
    for boton in ("IZQUIERDO", "DERECHO"):
        if boton == "DERECHO" and p.opciones:
            continue  # abre el menú
        for puntos in ((60, 45, 90, 60), (30, 60, 42, 30), (100, 45, 70, 60)):
            if not parecidas(*(p.ventana(arrastre(*puntos, boton, pasos)) for pasos in (1, 3))):
                yield boton, f"arrastrar con el botón {boton} por {puntos} en uno o en tres pasos no deja lo mismo"


def pausa(p):
    """Con el reloj parado no pasa nada, y al seguir, el tiempo de la pausa no ha contado. Hay programas que empiezan parados."""
    if not p.anima or "tecla Espacio" not in p.teclas:
        return
    nada, luego = p.diario(["espera 960"])
    anda = [] if luego.distinta(nada) else ["tecla Espacio"]
    seguido = p.diario([*anda, "espera 960"])[-1]
    filas = p.diario([*anda, "espera 640", "tecla Espacio", "espera 4960", "tecla Espacio", "espera 320"])[len(anda):]
    if filas[3].se_ve() != filas[2].se_ve():
        yield "pausa", "en la pausa cambia algo"
    if filas[5].se_ve() != seguido.se_ve():
        yield "pausa", f"tras una pausa no se sigue donde se estaba: {seguido.titulo} y {filas[5].titulo}"
    filas = p.diario([*anda, "tecla Espacio ×40", "espera 960"])
    if filas[-1].se_ve() != seguido.se_ve():
        yield "pausa", "parar y seguir muchas veces en el mismo instante cambia algo"


def rondas(p):
    """Los objetos de OpenGL son los mismos tras una ronda de todo que tras cuatro, y con lo mismo a la vista ocupan lo mismo."""
    ronda = [*p.mandos, "tamano 150 90", *p.mandos[::-1], "especial F5", "tamano 120 90", "especial F5"]
    if "arrastre" in p.rasgos:
        ronda += arrastre(40, 30, 70, 52)
    filas = p.diario(ronda * 4)
    una, cuatro = filas[len(ronda)], filas[-1]
    if una.objetos != cuatro.objetos:
        yield "objetos", f"tras una ronda hay {una.objetos} (buferes texturas programas shaders framebuffers renderbuffers vaos) y tras cuatro {cuatro.objetos}"
    quieta = p.diario(["tamano 150 90", "especial F5", "tamano 120 90", "especial F5"] * 3)
    if quieta[4].bytes != quieta[-1].bytes:
        yield "bytes", f"cambiar de tamaño y releer ocupa más cada vez: {quieta[4].bytes} y {quieta[-1].bytes} bytes"


def vivos(p):
    """En un editor se ve qué punto se elige con n, y las flechas lo mueven."""
    if "especial ARRIBA" not in p.teclas or "tecla n" not in p.teclas:
        return
    modos = [o for o in p.teclas if not o.startswith("especial ") and o != "tecla n"]
    for modo in ([], *([o] for o in modos)):
        guion = [*modo, *["tecla n", "especial ARRIBA", "especial ABAJO"] * 10]
        filas = p.diario(guion)[len(modo):]
        for antes, fila in zip(filas, filas[1:]):
            if not fila.distinta(antes):
                yield "vivos", f"{fila.orden}, tras {modo}, no cambia nada: elige o mueve un punto que no se ve"
                break


def propiedades(p, opciones):
    yield "paseo", paseo(p, opciones.ordenes, opciones.semilla)
    yield "nombres", nombres(p)
    yield "limites", limites(p)
    yield "comparacion", comparacion(p)
    yield "tallas", tallas(p, opciones.semilla)
    yield "arrastres", arrastres(p)
    yield "pausa", pausa(p)
    yield "rondas", rondas(p)
    yield "vivos", vivos(p)


# (programa, propiedad, en qué, expresión regular): por qué no
EXCEPCIONES = {
    ("primer_programa", "paseo", "repetir|ajena|F5"): "i solo cambia el color de borrado: se ve al borrar otra vez, que es lo que enseña",
    ("primer_programa", "tallas", "talla"): "i solo cambia el color de borrado, que se ve al cambiar de tamaño",
    ("errores_shader", "paseo", "F5"): "releer vuelve a escribir el error, o que no lo hay",
    ("tiras", "paseo", "tecla [3-9]"): "la malla que trae tiene dos tiras: son para la del usuario",
    ("eventos", "tallas", "talla"): "escribe el tamaño de cada suceso",
    ("captura", "tallas", "talla"): "lo guardado es de cuando se guardó",
    ("superficie_bezier", "vivos", "vivos"): "con m la malla tapa la red, pero los puntos se mueven",
}


def comprueba(p, opciones):
    fallos = []
    for nombre, hallados in propiedades(p, opciones):
        if opciones.solo and nombre != opciones.solo:
            continue
        admitidos = {clave[2] for clave in EXCEPCIONES if clave[:2] == (p.nombre, nombre)}
        sobran = set(admitidos)
        try:
            for en_que, que in hallados:
                suyas = {a for a in admitidos if re.fullmatch(a, en_que)}
                sobran -= suyas
                fallos += [] if suyas else [f"{p.nombre}, {nombre}: {que}"]
        except Termina as error:
            fallos.append(f"{p.nombre}, {nombre}: {error}")
        fallos += [f"{p.nombre}, {nombre}: ya cumple «{a}» y sigue en EXCEPCIONES" for a in sobran]
    print("\n".join(fallos[:20]) + ("\n…" if len(fallos) > 20 else ""))
    return bool(fallos)


def main():
    lee = argparse.ArgumentParser()
    lee.add_argument("raiz", type=Path)
    lee.add_argument("build", type=Path)
    lee.add_argument("programas", nargs="*")
    lee.add_argument("--ordenes", type=int, default=100)
    lee.add_argument("--semilla", type=int, default=1)
    lee.add_argument("--solo")
    opciones = lee.parse_args()
    opciones.raiz, opciones.build = opciones.raiz.resolve(), opciones.build.resolve()
    todos = [p for p in catalogo.lee_programas(opciones.build) if not p.consola and (not opciones.programas or p.nombre in opciones.programas)]
    sys.exit(any([comprueba(Programa(opciones.raiz, opciones.build, p), opciones) for p in todos]))


if __name__ == "__main__":
    main()
