#!/usr/bin/env python3
"""propiedades.py RAÍZ BUILD PROGRAMA… [--ordenes N] [--semilla N] [--solo PROPIEDAD]: lo que todo programa cumple,
sin escribir nada para ninguno. Lo que se puede hacer con él lo dice su línea «// Controles:», y lo que ha pasado, su
diario (-ayuda).

Lo que un programa no cumple está en EXCEPCIONES con su motivo; una que ya no haga falta también es un fallo.
"""
import argparse
import itertools
import os
import random
import re
import shlex
import string
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

sys.path.insert(0, str(Path(__file__).parents[2] / "herramientas"))
from base import catalogo, controles, guiones

TALLA, OTRAS = "120x90", ("1 1", "200 2", "100 130", "100 100")  # de la última solo cambia el alto, y encoge
TAMANOS = ["120 90", "150 90", "100 100", "61 45", "4 90", "1 1", "200 2"]
BYTES = 64 << 20  # lo que cabe en la GPU más modesta con otros programas abiertos
INTENTOS = 100  # de acortar un guion que falla
TECLAS = [c for c in string.printable if c.isprintable() and c not in " ;"]
TECLAS += "Espacio PuntoYComa Intro Tab Retroceso Supr".split()
ESPECIALES = "F2 F3 F4 F6 F10 IZQUIERDA DERECHA ARRIBA ABAJO INICIO FIN REPAG AVPAG".split()
APARTE = {"text": True, "stdin": subprocess.DEVNULL, "capture_output": True}
SIN_NOMBRE = [f"tecla {t}" for t in TECLAS] + [f"especial {t}" for t in ESPECIALES]


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
    def __init__(self, programa, opciones):
        raiz, build = opciones.raiz, opciones.build
        self.nombre, self.ordenes, self.semilla = programa.nombre, opciones.ordenes, opciones.semilla
        self.ejecutable = programa.ejecutable(build)
        leidos = controles.lee(raiz, programa)
        self.controles = [c for c in leidos if c.texto != "ninguno"]
        self.sin_linea = not leidos
        self.dice = " · ".join(c.texto for c in self.controles)
        self.teclas = [o for c in self.controles if not c.termina for o in c.ordenes if o not in controles.COMUNES]
        self.cualquiera = "cualquier tecla" in self.dice  # atiende todo
        self.rasgos, self.opciones = controles.atiende(build, programa)
        self.anima = bool({"temporizador", "ocio"} & self.rasgos)
        self.mandos = self.teclas + [f"menu {o}" for o in self.opciones]
        suyas = {o for c in self.controles for o in c.ordenes}
        self.ajenas = [] if self.cualquiera else [o for o in SIN_NOMBRE if o not in suyas]
        finitos = build / "tests/libfinitos.so"
        self.finitos = {"LD_PRELOAD": str(finitos)} if finitos.exists() else {}
        self.previas = {}  # lo que ha dado antes_de
        self.hechas = set()  # las órdenes que en algún diario han hecho algo
        self.titulo = ""  # el del primer cuadro

    def ejecuta(self, opciones, talla=TALLA, **entorno):
        with tempfile.TemporaryDirectory() as carpeta:
            orden = [self.ejecutable, "-geometry", talla, "-ppm", "imagen.ppm", *opciones]
            r = subprocess.run(orden, cwd=carpeta, env=os.environ | entorno, **APARTE)
        if r.returncode or r.stderr:
            raise Termina(f"estado {r.returncode}: {r.stderr.strip()[-2000:]}\n  con {opciones[-1]}")
        return r.stdout

    def diario(self, ordenes, talla=TALLA, **entorno):
        """Una fila al empezar y una por orden."""
        filas, escrito = [], []
        for linea in self.ejecuta(["-diario", "-guion", "; ".join(ordenes)], talla, **entorno).split("\n"):
            if not linea.startswith("diario\t"):
                escrito += [linea] if linea else []
                continue
            _, *campos, ocupa, esperan = linea.split("\t")
            filas.append(Fila(*campos, int(ocupa), int(esperan), tuple(escrito)))
            escrito = []
        self.hechas |= {orden for orden, antes, fila in zip(ordenes, filas, filas[1:]) if fila.distinta(antes)}
        return filas

    def captura(self, ordenes, *ficheros, talla=TALLA):
        """El último título, con unas órdenes que dejan esos ficheros, y lo que hay en cada uno."""
        with tempfile.TemporaryDirectory() as carpeta:
            guion = "; ".join(o.replace("captura ", f"captura {carpeta}/") for o in ordenes)
            escrito = self.ejecuta(["-titulos", "-", "-guion", guion], talla).splitlines()
            titulo = [linea for linea in escrito if linea.startswith("título: ")][-1]
            return titulo, *(Path(carpeta, f).read_bytes().split(b"\n255\n", 1)[1] for f in ficheros)

    def ventana(self, ordenes, talla=TALLA):
        """El título y los colores con que acaba, con Esc."""
        return self.captura([*ordenes, "captura fin", "tecla Esc"], "fin", talla=talla)

    def nada_cambia(self, ordenes):
        """Si tras ellas la ventana está como al empezar. El título de entonces lo sabe el paseo."""
        titulo, antes, despues = self.captura(["captura antes", *ordenes, "captura despues"], "antes", "despues")
        return antes == despues and titulo == f"título: {self.titulo or self.diario([])[0].titulo}"

    def hace_algo(self, antes, orden):
        """Si esa orden cambia algo tras las de `antes`, ya o al pasar el tiempo."""
        filas = self.diario([*antes, orden])
        if filas[-1].distinta(filas[-2]) or not self.anima:
            return filas[-1].distinta(filas[-2])
        return self.diario([*antes, orden, "espera 500"])[-1].distinta(self.diario([*antes, "espera 500"])[-1])

    def antes_de(self, orden):
        """Tras qué hace algo esa orden: tras nada, si basta; None, si con ningún otro mando delante lo hace."""
        if orden not in self.previas:
            self.previas[orden] = self.busca_antes(orden)
        return self.previas[orden]

    def busca_antes(self, orden):
        if self.hace_algo([], orden):
            return []
        otras = [otra for otra in self.mandos if otra != orden]
        cadena = [o for otra in otras for o in (otra, orden)]
        filas = self.diario(cadena)
        for i in range(2, len(filas), 2):
            if filas[i].distinta(filas[i - 1]):
                return cadena[: i - 1]
        return next(([otra] for otra in otras if self.anima and self.hace_algo([otra], orden)), None)


def arrastre(x0, y0, x1, y1, boton="IZQUIERDO", pasos=1):
    puntos = [(round(x0 + (x1 - x0) * k / pasos), round(y0 + (y1 - y0) * k / pasos)) for k in range(pasos + 1)]
    return [
        f"boton {boton} abajo {x0} {y0}",
        *(f"arrastra {x} {y}" for x, y in puntos[1:]),
        f"boton {boton} arriba {x1} {y1}",
    ]


# --- las propiedades: cada una da los fallos que encuentra, en qué y cuál -------------------------------------------


def guion_al_azar(p):
    """Sucesos suyos, con tamaños, F5 y teclas que no son suyas entre ellos."""
    azar = random.Random(f"{p.nombre} {p.semilla}")
    guion = []
    while len(guion) < p.ordenes:
        guion += controles.sucesos_al_azar(azar, p.controles, p.rasgos, p.opciones, 120, 90)
        cual = azar.random()
        if cual < 0.3 and p.ajenas:
            guion.append(azar.choice(p.ajenas))
        elif cual < 0.4:
            guion += [f"tamano {azar.choice(TAMANOS)}", "especial F5"]
    return guion


def del_paso(p, orden, antes, fila, temporizadores):
    """Lo que no debe pasar tras ninguna orden."""
    if fila.repetida:
        yield "repetir", "el mismo cuadro dibujado otra vez es distinto"
    if fila.cambiado:
        yield "estado", f"el cuadro no deja OpenGL como estaba: {fila.cambiado}"
    if orden == "especial F5" and fila.distinta(antes) and not p.cualquiera:
        yield "F5", "releer lo mismo cambia algo"
    if orden == "especial F5" and fila.objetos != antes.objetos:
        yield "objetos", f"releer lo mismo deja otros objetos: {antes.objetos} → {fila.objetos}"
    if orden in p.ajenas and fila.distinta(antes):
        yield "ajena", f"«{orden}» hace algo y no está en «// Controles:»"
    if fila.bytes > BYTES:
        yield "bytes", f"ocupa {fila.bytes} bytes"
    if fila.temporizadores > max(temporizadores, 1):
        yield "temporizadores", f"esperan {fila.temporizadores} temporizadores"


def del_guion(p, guion):
    """En qué y cuál: lo que va mal al jugarlo, en una ventana de float, donde ningún color deja de ser un número."""
    try:
        filas = p.diario(guion, **p.finitos)
    except Termina as error:
        return {"termina": error}
    p.titulo = filas[0].titulo
    pasos = zip(["", *guion], filas[:1] + filas, filas)
    hallados = [del_paso(p, *paso, filas[0].temporizadores) for paso in pasos]
    return dict(itertools.chain.from_iterable(hallados))


def paseo(p):
    """Sucesos al azar. De lo que va mal, con las menos órdenes con las que aún lo va."""
    guion = guion_al_azar(p)
    for en_que in del_guion(p, guion):

        def minimo():
            corto = guiones.acorta(guion, lambda menos: en_que in del_guion(p, menos), INTENTOS)
            como = f"DISPLAY= ./lab ver {p.nombre} -geometry {TALLA} -diario -guion {shlex.quote('; '.join(corto))}"
            return f"{del_guion(p, corto)[en_que]}\n  {como}"

        yield en_que, minimo


def nombres(p):
    """Lo que se nombra y lo que se atiende: las teclas, el ratón, la rueda, el menú."""
    atiende = {"ratón": {"raton", "arrastre"} & p.rasgos, "rueda": {"rueda"} & p.rasgos, "menú": p.opciones}
    dicen = {"ratón": ("ratón", "rrastra", "clic", "botón"), "rueda": ("rueda",), "menú": ("menú",)}
    if p.sin_linea:
        yield "línea", "falta «// Controles: … .», en las líneas que haga falta"
    filas = [] if p.nada_cambia(p.ajenas) else p.diario(p.ajenas)
    for orden, antes, fila in zip(p.ajenas, filas, filas[1:]):
        if fila.distinta(antes):
            yield "ajena", f"«{orden}» hace algo y no está en «// Controles:»"
    dice = p.dice.replace("botón derecho menú", "menú").replace("ratón orbita", "ratón orbita, rueda acerca")
    if p.cualquiera:
        dice += ", rueda"
    for que, palabras in dicen.items():
        nombra = any(palabra in dice for palabra in palabras)
        if nombra and not atiende[que]:
            yield que, f"«// Controles:» nombra {que} y el programa no lo atiende"
        if atiende[que] and not nombra:
            yield que, f"«// Controles:» no nombra {que} y el programa lo atiende"


CONTRARIAS = [set(par.split()) for par in ("+ -", "a d", "q e", "w s", ", .", "u U", "i o")]


def se_deshacen(nada, sube, baja, otra_vez, vuelve):
    """Si de dos teclas, una y otra por turno, una deshace la otra. El título puede decir cuál ha sido la última."""
    if sube != nada:
        return baja[0] == nada[0] and vuelve == baja
    return baja == nada or otra_vez[0] == nada[0]  # se empieza en el límite de la primera


class Extremo(NamedTuple):
    """Lo que se ve tras pulsar cientos de veces una tecla, ella, su contraria y ella."""

    alli: tuple
    otra_mas: tuple
    de_vuelta: tuple
    otra_vez: tuple

    @property
    def es_limite(self):  # si no, da la vuelta
        return self.otra_mas == self.alli

    def mal(self, hacia, desde):
        if self.es_limite and self.de_vuelta == self.alli:
            yield hacia, f"pasado el límite de «{hacia}», «{desde}» no hace nada"
        if self.es_limite and self.otra_vez != self.alli:
            yield hacia, f"al límite de «{hacia}» no se vuelve por donde se fue"


def limites(p):
    """De dos teclas contrarias una deshace la otra. O dan la vuelta o llegan a un límite, en que se deja de contar."""
    for c in p.controles:
        if set(c.teclas) not in CONTRARIAS or c.termina or None in map(p.antes_de, c.ordenes):
            continue
        mas, menos = c.ordenes
        antes = max(map(p.antes_de, c.ordenes), key=len)
        por_turno, arriba = [mas, menos, mas, menos], [f"{mas} ×300", mas, menos, mas]
        abajo, otra_vez_arriba = [f"{menos} ×600", menos, mas, menos], [f"{mas} ×600", menos]
        filas = p.diario([*antes, *por_turno, *arriba, *abajo, *otra_vez_arriba])
        vistas = [fila.se_ve() for fila in filas[len(antes) :]]
        arriba, abajo, otra_vez_arriba = Extremo(*vistas[5:9]), Extremo(*vistas[9:13]), tuple(vistas[13:])
        if not se_deshacen(*vistas[:5]):
            yield mas, f"de «{mas}» y «{menos}» una no deshace la otra"
        yield from arriba.mal(mas, menos)
        yield from abajo.mal(menos, mas)
        if arriba.es_limite and abajo.es_limite and otra_vez_arriba != (arriba.alli, arriba.de_vuelta):
            yield mas, f"de un límite al otro de «{mas}» y «{menos}» no se llega donde se estaba"


def comparacion(p):
    """Con la comparación puesta toda tecla hace algo, o la deja."""
    if "tecla v" not in p.teclas:
        return
    for orden in p.teclas:
        if orden == "tecla v" or p.hace_algo(["tecla v"], orden):
            continue
        antes = p.antes_de(orden)
        if antes is None or p.hace_algo([*antes, "tecla v"], orden):
            continue
        if p.diario([*antes, "tecla v", orden])[-1].se_ve() != p.diario([*antes, orden])[-1].se_ve():
            yield orden, f"«{orden}» no hace nada en la comparación, ni la deja"


def vuelta(p):
    """De un modo se sale con la tecla con que se entró: pulsada otra vez, hace algo."""
    mandan = [c for c in p.controles if set(c.teclas) not in CONTRARIAS and not c.termina]
    letras = [o for c in mandan for o in c.ordenes if o in p.teclas and o[-1].isalpha() and o.startswith("tecla ")]
    filas = iter(p.diario([o for orden in letras for o in (orden, orden)]))
    ultima = next(filas)
    for orden, una, otra in zip(letras, filas, filas):
        desde = p.antes_de(orden) or []
        if una.distinta(ultima) and not otra.distinta(una) and not p.hace_algo([*desde, orden], orden):
            yield orden, f"«{orden}» hace algo la primera vez y la segunda no"
        ultima = otra


def parecidas(una, otra):
    """El mismo título y, salvo lo que pueda mover el redondeo, la misma imagen: uno de cada cien colores, más de 3
    niveles."""
    (titulo, colores), (otro_titulo, otros) = una, otra
    if titulo != otro_titulo or len(colores) != len(otros):
        return False
    return 100 * sum(abs(a - b) > 3 for a, b in zip(colores, otros)) <= len(colores)


def conmutan(p, una, otra):
    """Si da igual el orden de dos teclas, o manda la última."""
    (_, a, ab), (_, b, ba) = ([f.se_ve() for f in p.diario(par)] for par in ((una, otra), (otra, una)))
    relativa = any({una, otra} & set(c.ordenes) for c in p.controles if set(c.teclas) in CONTRARIAS)
    return ab == ba or (ab, ba) == (b, a) or (relativa and (ab == b or ba == a))


def eligen(p):
    """Los grupos de teclas que eligen entre sí; las cifras son uno, que suele empezar con 1."""
    sueltos = [c for c in p.controles if c.teclas and not c.termina and not {"↑", "v"} & set(c.teclas)]
    grupos = [c.ordenes for c in sueltos if set(c.ordenes) <= set(p.teclas)]
    cifras = [o for grupo in grupos for o in grupo if o[-1] in "234567890"]
    return [grupo for grupo in [*(g for g in grupos if not g[0][-1].isdigit()), cifras] if grupo]


def tallas(p):
    """Lo hecho en una ventana y llevado a otra es lo mismo que hecho en esa y en el orden contrario; o de dos teclas
    manda la última."""
    azar = random.Random(f"{p.nombre} {p.semilla}")
    final = OTRAS[-1].replace(" ", "x")
    guion = [azar.choice(grupo) for grupo in eligen(p)]
    mandan = [o for o in p.mandos if o == "tecla v" or o.startswith("menu ")]  # siempre al final
    bien = True
    for cola in [[], *([[azar.choice(mandan)]] if mandan else [])]:
        llevada = p.ventana([*guion, *cola, *(f"tamano {talla}" for talla in OTRAS)])
        if not parecidas(llevada, p.ventana([*guion[::-1], *cola], final)):
            bien = False
            if not parecidas(llevada, p.ventana([*guion, *cola], final)):
                con = "; ".join(guion + cola)
                yield "talla", f"una ventana de {TALLA} llevada a {OTRAS} no se ve como una de {final}, con {con}"
    for una, otra in () if bien else itertools.combinations(guion, 2):
        if not conmutan(p, una, otra):
            yield f"{una}, {otra}", f"de «{una}» y «{otra}», ni da igual el orden ni manda la última"


def arrastres(p):
    """Arrastrar en un paso o en tres deja lo mismo; y en horizontal, de una vez o soltando a la mitad."""
    if "arrastre" not in p.rasgos or p.cualquiera:
        return
    botones = ["IZQUIERDO"] if p.opciones else ["IZQUIERDO", "DERECHO"]  # el derecho abre el menú
    caminos = [(60, 45, 90, 60), (30, 60, 42, 30), (100, 45, 70, 60)]
    una, tres = (
        [o for boton in botones for puntos in caminos for o in arrastre(*puntos, boton, pasos)] for pasos in (1, 3)
    )
    for boton in [] if "clic" in p.dice else botones:  # pulsar otra vez elegiría otra cosa
        una += arrastre(40, 45, 80, 45, boton)
        tres += arrastre(40, 45, 60, 45, boton) + arrastre(60, 45, 80, 45, boton)
    if not parecidas(p.ventana(una), p.ventana(tres)):
        yield "pasos", f"arrastrar en uno o en tres pasos, o soltando a la mitad, no deja lo mismo: {'; '.join(una)}"


def pausa(p):
    """Lo que se anima, sigue; con el reloj parado no pasa nada, y al seguir, el tiempo de la pausa no ha contado. Hay
    programas que empiezan parados."""
    if not p.anima or "tecla Espacio" not in p.teclas:
        return
    nada, luego = p.diario(["espera 960"])
    if luego.temporizadores < nada.temporizadores:
        yield "temporizador", "el temporizador no se vuelve a pedir"
    with tempfile.TemporaryDirectory() as carpeta:  # sin diario no se dibuja si nadie lo pide
        for i, guion in enumerate(("espera 960", "espera 960; especial F5")):
            p.ejecuta(["-guion", guion, "-ppm", f"{carpeta}/{i}"])
        if Path(carpeta, "0").read_bytes() != Path(carpeta, "1").read_bytes():
            yield "temporizador", "el temporizador no pide que se vuelva a dibujar"
    anda = [] if luego.distinta(nada) else ["tecla Espacio"]
    seguido = p.diario([*anda, "espera 960"])[-1]
    filas = p.diario([*anda, "espera 640", "tecla Espacio", "espera 4960", "tecla Espacio", "espera 320"])[len(anda) :]
    if filas[2].titulo == filas[1].titulo:
        yield "título", "el título no dice que está en pausa"
    if filas[3].se_ve() != filas[2].se_ve():
        yield "pausa", "en la pausa cambia algo"
    if filas[5].se_ve() != seguido.se_ve():
        yield "pausa", f"tras una pausa no se sigue donde se estaba: {seguido.titulo} y {filas[5].titulo}"
    filas = p.diario([*anda, "tecla Espacio ×40", "espera 960"])
    if filas[-1].se_ve() != seguido.se_ve():
        yield "pausa", "parar y seguir muchas veces en el mismo instante cambia algo"


def rondas(p):
    """Los objetos de OpenGL son los mismos tras una ronda de todo que tras tres, y con lo mismo a la vista ocupan lo
    mismo."""
    ronda = [*p.mandos, "tamano 150 90", *p.mandos[::-1], "especial F5", "tamano 120 90", "especial F5"]
    if "arrastre" in p.rasgos:
        ronda += arrastre(40, 30, 70, 52)
    quieta = ["tamano 150 90", "especial F5", "tamano 120 90", "especial F5"]
    filas = p.diario(ronda * 3 + quieta * 2)
    una, tres = filas[len(ronda)], filas[3 * len(ronda)]
    if una.objetos != tres.objetos:
        son = "buferes texturas programas shaders framebuffers renderbuffers vaos"
        yield "objetos", f"tras una ronda hay {una.objetos} ({son}) y tras tres {tres.objetos}"
    antes, despues = filas[-1 - len(quieta)].bytes, filas[-1].bytes
    if antes != despues:
        yield "bytes", f"cambiar de tamaño y releer ocupa más cada vez: {antes} y {despues} bytes"


def comunes(p):
    """Lo que cambia con el tiempo se anima; F1 pone la ayuda, que es lo que dice «// Controles:», y la quita; F12
    guarda y lo dice, y Esc termina: tras él no hay fila."""
    antes, nada, puesta, quitada, guardada, *mas = p.diario(
        ["espera 960", "especial F1", "especial F1", "especial F12", "tecla Esc"]
    )
    if nada.distinta(antes) and not p.anima:
        yield "tiempo", "cambia con el tiempo y nadie pide que se vuelva a dibujar"
    if puesta.imagen == nada.imagen or quitada.imagen != nada.imagen or puesta.titulo != nada.titulo:
        yield "F1", "F1 no pone la ayuda, o no la quita"
    with tempfile.NamedTemporaryFile("r") as encima:
        p.ejecuta(["-guion", "especial F1"], LAB_ENCIMA=encima.name)
        rotulos = [linea.split("\t")[-1].split("\\n") for linea in encima if linea.startswith("rotulo")]
    suyos = p.dice.split(" · ")
    for donde, lineas in (
        ("F1", rotulos[-1] if rotulos else []),
        ("-ayuda", p.ejecuta(["-ayuda"]).splitlines()[-len(suyos) - 4 :]),
    ):
        if lineas[: len(suyos)] != suyos:
            yield donde, f"{donde} no dice sus controles: {lineas}"
    if not any(linea.startswith("guardado ") for linea in guardada.escrito):
        yield "F12", "F12 no guarda la ventana, o no lo dice"
    if mas:
        yield "Esc", "Esc no termina"
    for dados in (["uno"], ["uno", "dos"], ["uno", "dos", "tres"]):
        r = subprocess.run([p.ejecutable, *dados, "-ppm", "/dev/null"], **APARTE)
        if re.search("sobra|no entiendo", r.stderr):
            break
    if r.returncode != 2 or [dado for dado in dados if f"«{dado}»" in r.stderr] != dados[-1:]:
        yield "argumentos", f"con {' '.join(dados)} no dice que sobra lo último: {r.returncode}, {r.stderr}"


def vivos(p):
    """En un editor se ve qué punto se elige con n, y las flechas lo mueven."""
    if "especial ARRIBA" not in p.teclas or "tecla n" not in p.teclas:
        return
    modos = [o for o in p.teclas if not o.startswith("especial ") and o != "tecla n"]
    recorre = ["tecla n", "especial ARRIBA", "especial ABAJO"] * 10
    guion = recorre + [o for modo in modos for o in (modo, *recorre)]
    filas = p.diario(guion)
    for antes, fila, orden in zip(filas, filas[1:], guion):
        if orden not in modos and not fila.distinta(antes):
            yield "vivos", f"{fila.orden} no cambia nada: elige o mueve un punto que no se ve"


def mandos(p):
    """Todo lo que se nombra hace algo: lo ha hecho ya en algo de lo anterior o se busca tras qué."""
    for orden in p.mandos:
        if orden not in p.hechas and p.antes_de(orden) is None:
            yield orden, f"«{orden}» no hace nada, ni tras ninguna otra"


PROPIEDADES = paseo, nombres, limites, comparacion, vuelta, tallas, arrastres, pausa, rondas, comunes, vivos, mandos

# (programa, propiedad, en qué, expresión regular): por qué no
EXCEPCIONES = {
    ("primer_programa", "paseo", "repetir|ajena|F5"): "i solo cambia el color de borrado: se ve al borrar otra vez",
    ("primer_programa", "comunes", "F1|-ayuda|F12|argumentos"): "no usa common/: lo suyo sería más largo que él",
    ("primer_programa", "vuelta", "tecla d"): "dibuja otra vez lo mismo, que es lo que enseña",
    ("primer_programa", "tallas", "tecla i, tecla [ds]"): "lo mismo: se ve al borrar otra vez",
    ("shader_basico", "comunes", "F1|-ayuda|F12|argumentos"): "tampoco: es el listado del libro",
    ("errores_shader", "paseo", "F5"): "releer vuelve a escribir el error, o que no lo hay",
    ("tiras", "mandos", "tecla [3-9]"): "la malla que trae tiene dos tiras: son para la del usuario",
    ("eventos", "comunes", "F1"): "también enseña esa tecla",
    ("eventos", "tallas", "talla"): "escribe el tamaño de cada suceso",
    ("materiales", "vuelta", "tecla t"): "vuelve a todos: con n se ve uno",
    ("captura", "vuelta", "tecla g"): "vuelve a guardar lo mismo",
    ("captura", "paseo", "estado"): "g deja en 1 la alineación, que es lo que enseña el listado",
    ("captura", "tallas", "talla|tecla g, .*"): "lo guardado es de cuando se guardó",
    ("morphing", "pausa", "título"): "así empieza: lo que se ve es que t no cambia",
    ("continuidad", "pausa", "título"): "así empieza: lo que se ve es que u no cambia",
    ("superficie_bezier", "tallas", "tecla [mf], tecla [-+]"): "cambian una cosa distinta en cada modo",
    ("superficie_bezier", "vivos", "vivos"): "con m y con f la superficie tapa la red, pero los puntos se mueven",
}


def comprueba(p, solo):
    fallos = []
    for propiedad in PROPIEDADES:
        nombre = propiedad.__name__
        if solo and nombre != solo:
            continue
        admitidos = {clave[2] for clave in EXCEPCIONES if clave[:2] == (p.nombre, nombre)}
        sobran = set(admitidos)
        try:
            for en_que, que in propiedad(p):
                suyas = {a for a in admitidos if re.fullmatch(a, en_que)}
                sobran -= suyas
                if not suyas:
                    fallos.append(f"{p.nombre}, {nombre}: {que() if callable(que) else que}")
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
    lee.add_argument("--ordenes", type=int, default=50)
    lee.add_argument("--semilla", type=int, default=1)
    lee.add_argument("--solo")
    opciones = lee.parse_args()
    opciones.raiz, opciones.build = opciones.raiz.resolve(), opciones.build.resolve()
    todos = [p for p in catalogo.lee_programas(opciones.build) if not p.consola]
    elegidos = [Programa(p, opciones) for p in todos if not opciones.programas or p.nombre in opciones.programas]
    sys.exit(any([comprueba(p, opciones.solo) for p in elegidos]))


if __name__ == "__main__":
    main()
