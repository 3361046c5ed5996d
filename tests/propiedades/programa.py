"""Un programa, para preguntarle: lo que se puede hacer con él, lo que pasa al hacerlo y lo que entonces se ve."""
import os
import string
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2] / "herramientas"))
from base import controles, fuentes
from encima import lee

TALLA = "120x90"
TECLAS = [c for c in string.printable if c.isprintable() and c not in " ;"]
TECLAS += "Espacio PuntoYComa Intro Tab Retroceso Supr".split()
ESPECIALES = "F4 F6 F10 IZQUIERDA DERECHA ARRIBA ABAJO INICIO FIN REPAG AVPAG".split()
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


@dataclass
class Vista:
    """Una imagen guardada: los colores de cada fila, desde arriba, y lo que lleva pintado encima."""

    filas: list
    encima: list

    @property
    def talla(self):
        return len(self.filas[0]) // 3, len(self.filas)

    def centro(self, ancho, alto):
        """Lo de en medio, de ese tamaño."""
        x, y = (self.talla[0] - ancho) // 2, (self.talla[1] - alto) // 2
        return b"".join(fila[3 * x : 3 * (x + ancho)] for fila in self.filas[y : y + alto])

    def entera(self):
        """Si no está partida en paneles, que se sepa."""
        return all(p.panel == (0, 0, *self.talla) for p in self.encima)


def lee_ppm(fichero):
    cabecera, colores = fichero.read_bytes().split(b"\n255\n", 1)
    ancho = 3 * int(cabecera.split()[-2])
    return [colores[i : i + ancho] for i in range(0, len(colores), ancho)]


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
        todos = [f for f in fuentes.alcanza(raiz, programa.fuente) if f.suffix in fuentes.SHADERS]
        reales = [f for f in todos if f.suffix in fuentes.SHADERS[:2]]
        self.raiz, self.shaders = raiz, [f for f in reales if f.suffix == ".frag"] or reales
        self.incluidos = [f for f in todos if f not in reales] or self.shaders
        self.finitos = {"LD_PRELOAD": str(finitos)} if finitos.exists() else {}
        self.previas = {}  # lo que ha dado antes_de
        self.hechas = set()  # las órdenes que en algún diario han hecho algo
        self.titulo = ""  # el del primer cuadro
        self.admite = programa.admite
        self.ultimo = programa is [otro for otro in programa.capitulo.programas if not otro.consola][-1]
        self.casos = [caso.guion for caso in programa.casos]
        self.todo = opciones.todo
        self.diarios, self.rotulos = [], set()  # todo lo que se ha visto

    def ejecuta(self, opciones, talla=TALLA, **entorno):
        with tempfile.TemporaryDirectory() as carpeta:
            return self.ejecuta_en(carpeta, opciones, talla, **entorno)

    def ejecuta_en(self, carpeta, opciones, talla=TALLA, **entorno):
        orden = [self.ejecutable, "-geometry", talla, "-ppm", "imagen.ppm", *opciones]
        r = subprocess.run(orden, cwd=carpeta, env=os.environ | entorno, **APARTE)
        if r.returncode or r.stderr:
            raise Termina(f"estado {r.returncode}: {r.stderr.strip()[-2000:]}\n  con {opciones[-1]}")
        return r.stdout

    def vistas(self, ordenes, *opciones, talla=TALLA, **entorno):
        """Lo que hay tras cada «captura», que aquí va sin fichero, de esas órdenes."""
        nombres = [str(i) for i in range(ordenes.count("captura"))]
        numero = iter(nombres)
        guion = "; ".join(f"captura {next(numero)}" if o == "captura" else o for o in ordenes)
        with tempfile.TemporaryDirectory() as carpeta:
            self.ejecuta_en(carpeta, [*opciones, "-guion", guion], talla, LAB_ENCIMA="encima", **entorno)
            fichero = Path(carpeta, "encima")
            encima = lee(fichero) if fichero.exists() else [[] for _ in nombres]
            vistas = [Vista(lee_ppm(Path(carpeta, f)), e) for f, e in zip(nombres, encima)]
        self.rotulos |= {p.texto for v in vistas for p in v.encima if p.tipo == "rotulo"}
        return vistas

    def diario(self, ordenes, talla=TALLA, opciones=(), **entorno):
        """Una fila al empezar y una por orden."""
        filas, escrito = [], []
        for linea in self.ejecuta([*opciones, "-diario", "-guion", "; ".join(ordenes)], talla, **entorno).split("\n"):
            if not linea.startswith("diario\t"):
                escrito += [linea] if linea else []
                continue
            _, *campos, ocupa, esperan = linea.split("\t")
            filas.append(Fila(*campos, int(ocupa), int(esperan), tuple(escrito)))
            escrito = []
        self.diarios.append(filas)
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
    lleva = [f"arrastra {x} {y}" for x, y in puntos[1:]]
    return [f"boton {boton} abajo {x0} {y0}", *lleva, f"boton {boton} arriba {x1} {y1}"]


CONTRARIAS = [set(par.split()) for par in ("+ -", "a d", "q e", "w s", ", .", "u U", "i o", "w x", "b n")]


def parecidas(una, otra):
    """El mismo título y, salvo lo que pueda mover el redondeo, la misma imagen: uno de cada cien colores, más de 3
    niveles."""
    (titulo, colores), (otro_titulo, otros) = una, otra
    if titulo != otro_titulo or len(colores) != len(otros):
        return False
    return 100 * sum(abs(a - b) > 3 for a, b in zip(colores, otros)) <= len(colores)


def distintos(una, otra, niveles=24):
    """Cuántos de esos colores difieren en más de esos niveles, de cada mil."""
    if una == otra:
        return 0
    return 1000 * sum(abs(a - b) > niveles for a, b in zip(una, otra)) / len(una)
