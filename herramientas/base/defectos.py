"""Defectos que se pueden plantar en los fuentes: los que conoce ./lab corrige (herramientas/ejercicios/errores/) y
los demás de ./lab muta (tests/mutantes/). Una lista por fichero y, en cada línea, entre tabuladores: fichero, texto
(que está una sola vez en él; \\n, si pasa de línea), texto estropeado, qué imita y, si no lo puede notar nadie, por
qué; la sexta columna, en lo que pide un ejercicio, qué se le dice a quien ha hecho lo mismo. Con «…» dentro del
texto, el resto solo sirve para encontrarlo y se cambia lo que va entre ellas.

En C++ una expresión queda como (mutante(5012) ? (estropeada) : (original)), una instrucción como if/else, y
$LAB_MUTANTE elige una o varias (mutante.h): se compilan todos a la vez."""
import re
from collections import defaultdict
from dataclasses import dataclass, field
from pathlib import Path

from base.fuentes import SHADERS

MUTANTE_H = Path("herramientas/base/mutante.h")
DE_NADIE = 1 << 20  # el número que no es de ningún mutante


@dataclass(eq=False)
class Mutante:
    lista: str
    linea: int
    numero: int  # el de $LAB_MUTANTE
    fichero: str
    texto: str
    estropeado: str
    imita: str
    motivo: str = ""
    dice: str = ""
    pruebas: list = field(default_factory=list)  # las que lo usan
    notado: str = ""
    por: str = ""  # encima o golden, si no lo nota nada más

    @property
    def nombre(self):
        return f"{self.lista}:{self.linea}"

    @property
    def lo_nota_otro(self):
        """Si el motivo es que lo nota algo que no siempre se prueba: una ventana, un navegador."""
        return self.motivo.startswith("lo nota ")

    @property
    def en_shader(self):
        return self.fichero.endswith(SHADERS)

    def es_de(self, pedido):
        """Si es lo que se pide: su lista, él, su fichero, su carpeta o el capítulo o el programa por los que empiezan
        sus nombres."""
        fichero = Path(self.fichero)
        carpeta = fichero.parts[0]
        suyos = self.lista, self.nombre, self.fichero, carpeta, carpeta.split("_")[0]
        return pedido in suyos or fichero.stem.startswith(pedido)

    def sitio(self, fuente):
        """Dónde empieza y acaba en ese fuente lo que se cambia."""
        antes, marcado, despues = "", self.texto, ""
        if "«" in self.texto:
            antes, marcado, despues = re.fullmatch("(?s)(.*?)«(.*)»(.*)", self.texto).groups()
        veces = fuente.count(antes + marcado + despues)
        if veces != 1:
            raise ValueError(f"«{self.texto}» está {veces} veces en {self.fichero}")
        if marcado == self.estropeado:
            raise ValueError(f"«{self.texto}» no cambia nada")
        desde = fuente.index(antes + marcado + despues) + len(antes)
        return desde, desde + len(marcado)


def lee(*carpetas):
    """Los mutantes de todas las listas de esas carpetas, y los fallos que haya en ellas."""
    mutantes, fallos = [], []
    listas = sorted(lista for carpeta in carpetas for lista in carpeta.glob("*.tsv"))
    for n, lista in enumerate(listas):
        suyos, mal = lee_lista(lista, 1000 * n)
        mutantes += suyos
        fallos += mal
    return mutantes, fallos


def lee_lista(lista, desde=0):
    """Los de una, si la hay."""
    mutantes, fallos = [], []
    for i, linea in enumerate(lista.read_text().splitlines() if lista.is_file() else (), 1):
        columnas = linea.replace("\\n", "\n").split("\t")
        if len(columnas) in (4, 5, 6) and all(columnas[:4]) and columnas[-1]:
            mutantes.append(Mutante(lista.stem, i, desde + i, *columnas))
        else:
            son = "fichero, texto, texto estropeado, qué imita y, si acaso, motivo y qué se le dice a un alumno"
            fallos.append(f"{lista.stem}:{i}: son {son}")
    return mutantes, fallos


def por_fichero(mutantes):
    grupos = defaultdict(list)
    for m in mutantes:
        grupos[m.fichero].append(m)
    return grupos


def cambia(fuente, mutantes, marca=""):
    """El fuente de C++ con todos sus mutantes dentro. Los que estropean lo mismo van en cadena; el que estropea una
    parte de lo de otro, dentro de lo que ese deja como está. MARCA: lo que va delante de cada uno, con su número, y
    detrás, sin él."""
    sitios = defaultdict(list)
    for m in mutantes:
        sitios[m.sitio(fuente)].append(m)

    def entre(desde, hasta, lugares):
        texto = ""
        while lugares:
            (principio, fin), *lugares = lugares
            dentro = [lugar for lugar in lugares if lugar[0] < fin]
            if any(otro_fin > fin for _, otro_fin in dentro):
                raise ValueError(f"se pisa con otro: «{fuente[principio:fin]}»")
            suyo = entre(principio, fin, dentro)
            texto += fuente[desde:principio] + con_mutantes(fuente, principio, fin, suyo, sitios[principio, fin], marca)
            desde, lugares = fin, lugares[len(dentro) :]
        return texto + fuente[desde:hasta]

    return entre(0, len(fuente), sorted(sitios, key=lambda lugar: (lugar[0], -lugar[1])))


# Los operadores de C++ de dos operandos, de lo que más une a lo que menos.
UNEN = "* / %", "+ -", "<< >>", "< <= > >=", "== !=", "&", "^", "|", "&&", "||", "= += -= *= /= ?", ","
UNE = {operador: n for n, operadores in enumerate(UNEN) for operador in operadores.split()}
OPERADOR = re.compile(
    r"(?<=[\w\])\"'}]) ?(<<|>>|[<>=!]=|&&|\|\||[-+*/]=|[-*/%+&^|?,=]|(?<= )[<>](?= ))(?!>)\s*(?=[^\s)=])"
)


def sin_lo_de_dentro(texto):
    """Sin lo que va entre paréntesis, corchetes, llaves o comillas, ni el signo de un exponente."""
    antes, texto = None, re.sub(r"(\d\.?)e[-+](\d)", r"\1\2", texto)
    while antes != (antes := texto):
        texto = re.sub(r"\([^()\[\]{}]*\)|\[[^()\[\]{}]*\]|\{[^()\[\]{}]*\}|\"(?:\\.|[^\"\\])*\"", "a", texto)
    return texto


def parte_una_expresion(antes, texto, despues):
    """Si ese trozo de C++, entre paréntesis, deja de ser lo que era: el + de a + b en «a + b» * c."""
    suyos = [UNE[m[1]] for m in OPERADOR.finditer(sin_lo_de_dentro(texto) + " a")]
    if not suyos:
        return False
    izquierda = re.search(r"[\w\])\"'] ?([-*/%+&|<>=!?]+)\s*$", antes)
    derecha = OPERADOR.match("a" + re.match(r"\s*\S*\s*\S?", despues)[0] + "a", 1)
    une_antes = UNE.get(izquierda[1], 99) if izquierda else 99
    une_despues = UNE.get(derecha[1], 99) if derecha else 99
    resta = izquierda and izquierda[1] in ("-", "/", "%")
    de_una_lista = UNE[","] in suyos  # de argumentos: sería el operador coma
    return de_una_lista or max(suyos) > min(une_antes, une_despues) or resta and max(suyos) == une_antes


def con_mutantes(fuente, desde, hasta, nuevo, mutantes, marca):
    """Ese trozo de C++, que con los de dentro es NUEVO, con los suyos."""
    sin_marca = marca.format(DE_NADIE)
    antes, texto = fuente[:desde], fuente[desde:hasta]
    if not texto.endswith((";", "}")):
        if parte_una_expresion(antes, texto, fuente[hasta:]):
            raise ValueError(f"entre paréntesis, la expresión sería otra: «{texto}»")
        nuevo = f"({nuevo})"
        for m in mutantes:
            nuevo = f"{marca.format(m.numero)}(mutante({m.numero}) ? ({m.estropeado}) : {nuevo}){sin_marca}"
        return nuevo
    tras_dos_puntos = re.search(r":\s*$", antes) and "?" in antes.rpartition(";")[2]  # de ?:, y no de un case
    if tras_dos_puntos or not re.search(r"(^|[;{}):]|\belse|//.*)\s*$", antes):
        raise ValueError(f"no es una instrucción entera: «{texto}»")
    nuevo = f"{{ {nuevo} }}"
    for m in mutantes:
        nuevo = f"{marca.format(m.numero)}if (mutante({m.numero})) {{ {m.estropeado} }} else {nuevo}{sin_marca}"
    return nuevo


def estropea(fuente, *mutantes):
    for m in mutantes:
        desde, hasta = m.sitio(fuente)
        fuente = fuente[:desde] + m.estropeado + fuente[hasta:]
    return fuente
