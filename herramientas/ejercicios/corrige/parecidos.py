"""Qué entregas se parecen más de lo que explican el esqueleto, la solución y lo que escribe casi toda la clase. Es un
indicio, con lo de las dos al lado para que lo mire alguien; de la nota no quita nada.

Se comparan palabras seguidas de una función. Los nombres que son de quien escribe, que son los que no son del lenguaje,
de OpenGL, de GLM ni de lo que se incluye del laboratorio, se llaman según el orden en que salen en ellas, y no cuentan
ni los comentarios, ni los blancos, ni las llaves, ni los textos: con otros nombres, con las funciones en otro orden o
con otros comentarios, son las mismas. Lo que viene de fuera (giroY, glEnable, un número) sí cuenta, que no se le puede
cambiar el nombre.

No lo hace sim_c++ (similarity-tester), que no sabe quitar lo que se da: con 47 grúas de un error cada una y una copia
de cada, da del 97 al 99 % a las copias y, a las demás parejas, que comparten el esqueleto, también."""
import functools
import itertools
import re
from collections import Counter, defaultdict
from dataclasses import dataclass, replace
from pathlib import Path

from pygments.lexers import CppLexer
from pygments.lexers.graphics import GLShaderLexer
from pygments.token import Keyword, Name

from ejercicios.corrige.entrega import CODIGO, tipo

SEGUIDAS = 12  # palabras que se miran juntas
BASTA = 0.5  # lo que tienen que compartir de lo que solo es suyo, de 0 a 1
MINIMO = 2  # y lo que tiene que pesar
TOPE = 200_000  # letras que se miran de una entrega
COMUN = 4, 10  # lo que está en más de tantas, y en más de una de cada tantas, es de todos
ALREDEDOR, ANCHO, ALTO = 2, 200, 400  # líneas que se enseñan de más, y lo que se enseña de cada fichero

PALABRA = re.compile(
    r"""(?P<nada>//(?:\\\n|[^\n])*|/\*.*?(?:\*/|\Z)|^[ \t]*\#(?:\\\n|[^\n])*)
    |(?P<texto>"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*')
    |(?P<numero>\.?\d(?:[\w.]|(?<=[eE])[+-])*)
    |(?P<nombre>[^\W\d]\w*)
    |(?P<signo>::|->|\+\+|--|<=|>=|==|!=|&&|\|\||[-+*/%&|^]=|\S)""",
    re.X | re.M | re.S,
)
LENGUAS = CppLexer(), GLShaderLexer()
DE_GL = re.compile("(gl|glut|glew)[A-Z]|(GL|GLUT|GLEW)_|GL[a-z]")
RAIZ, GLM = Path(__file__).parents[3], Path("/usr/include/glm")
DEL_LABORATORIO = "common/**/*.h", "ch*/*.h", "common/*.glsl", "ch*/*.glsl"
INCLUYE = re.compile(r'#\s*include\s+[<"](?:[^">\n]*/)?([^">\n]+)')
CON_CAMPOS = {"struct", "class", "union"}
AMBITOS = CON_CAMPOS | {"namespace", "enum"}
SIGUE_A_UN_NOMBRE = set("= ; , ( [ : { }".split())


@dataclass(frozen=True)
class Palabra:
    que: str
    clase: str
    linea: int


NADA = Palabra("", "", 0)


@dataclass
class Pareja:
    una: object
    otra: object
    cuanto: float  # comparten de lo que solo es suyo, de 0 a 1
    pesa: float  # eso: lo que además tienen otros, menos
    lineas: tuple  # de cada una, {fichero: sus líneas}


def palabras(texto):
    """Las del lenguaje, cada una con su línea."""
    hay, linea, hasta = [], 1, 0
    for m in PALABRA.finditer(texto):
        linea += texto.count("\n", hasta, m.start())
        hasta = m.start()
        if m.lastgroup != "nada":
            hay.append(Palabra(m[0], m.lastgroup, linea))
    return hay


@functools.lru_cache(None)
def es_del_lenguaje(nombre):
    """De C++ o de GLSL, o de OpenGL, que no tiene otro nombre."""
    clases = (next(iter(lengua.get_tokens(nombre)))[0] for lengua in LENGUAS)
    return bool(DE_GL.match(nombre)) or any(c in Keyword or c in Name.Builtin for c in clases)


def ofrece(hay):
    """Los nombres que declara una cabecera para quien la incluye: no están entre paréntesis, ni en el cuerpo de una
    función, ni son de una plantilla. Los campos, con un punto delante; las funciones, con un paréntesis detrás."""
    dentro, de = [], ""
    for p, luego in zip(hay, [*hay[1:], NADA]):
        if p.que in ("(", "{") or p.que == "<" and not {"(", "{"} & {*dentro}:
            dentro.append(de if p.que == "{" and de in AMBITOS else p.que)
        elif dentro and (p.que in (")", "}") or p.que == ">" and dentro[-1] == "<"):
            dentro.pop()
        elif p.clase == "nombre" and luego.que in SIGUE_A_UN_NOMBRE and not {"(", "{", "<"} & {*dentro}:
            yield "." * bool(CON_CAMPOS & {*dentro}) + p.que + "(" * (luego.que == "(")
        de = p.que if p.que in AMBITOS or p.que in (";", ")") else de


@functools.lru_cache(None)
def de_cabecera(ruta):
    return {*ofrece(palabras(ruta.read_text()))}


def de_fuera(dadas):
    """Lo que ofrecen GLM y lo que se incluye del laboratorio, menos lo que se da a medio hacer."""
    suyas = {ruta.rpartition("/")[2] for textos in dadas for ruta in textos}
    donde = {f.name: f for patron in DEL_LABORATORIO for f in RAIZ.glob(patron) if f.name not in suyas}
    por_ver, vistas = [texto for textos in dadas for texto in textos.values()], {}
    while por_ver:
        nuevas = {n: donde[n] for n in INCLUYE.findall(por_ver.pop()) if n in donde and n not in vistas}
        vistas |= nuevas
        por_ver += [f.read_text() for f in nuevas.values()]
    return {"std", "glm"}.union(*map(de_cabecera, (*GLM.glob("*.hpp"), *vistas.values())))


def con_los_suyos(hay, de_otros):
    """Las mismas, con los nombres que son de quien escribe: los que no son del lenguaje ni de otros."""
    salen = [NADA, NADA]
    for p, luego in zip(hay, [*hay[1:], NADA]):
        es_campo, de_dado = salen[-1].que in (".", "->"), salen[-1].que == "::" and salen[-2].clase == "nombre"
        asi = {punto + p.que + par for punto in ("", "." * es_campo) for par in ("", "(" * (luego.que == "("))}
        es_suyo = p.clase == "nombre" and not (de_dado or asi & de_otros or es_del_lenguaje(p.que))
        salen.append(replace(p, clase="suyo") if es_suyo else p)
    return salen[2:]


def cosas(hay):
    """Las palabras de cada cosa que se declara fuera de todo, una función o una estructura, sin llaves."""
    todas, hondo = [[]], 0
    for palabra in hay:
        if palabra.que not in ("{", "}"):
            todas[-1].append(palabra)
        hondo = max(0, hondo + (palabra.que == "{") - (palabra.que == "}"))
        if not hondo and palabra.que in ("}", ";"):
            todas.append([])
    return filter(None, todas)


def normal(juntas):
    """Cómo cuentan. De los textos, solo los que son un nombre, sin blancos."""
    orden = {}
    return tuple(
        orden.setdefault(p.que, len(orden))
        if p.clase == "suyo"
        else "T"
        if p.clase == "texto" and " " in p.que
        else p.que
        for p in juntas
    )


def senas(ficheros, de_otros):
    """{seña de unas palabras seguidas: dónde está la de en medio, como (fichero, línea)}."""
    donde = defaultdict(set)
    for ruta, texto in ficheros.items():
        for cosa in cosas(con_los_suyos(palabras(texto), de_otros)):
            for i in range(max(1, len(cosa) - SEGUIDAS + 1)):
                juntas = cosa[i : i + SEGUIDAS]
                donde[hash(normal(juntas))].add((ruta, juntas[len(juntas) // 2].linea))
    return donde


def codigo(ficheros):
    """Los textos de una entrega, hasta un límite."""
    queda, textos = TOPE, {}
    for ruta, contenido in sorted(ficheros.items()):
        if tipo(ruta) in CODIGO and queda:
            texto = contenido if isinstance(contenido, str) else contenido[:TOPE].decode(errors="replace")
            textos[ruta] = texto[:queda]
            queda -= len(textos[ruta])
    return textos


def lineas(donde, comunes):
    """En qué líneas de cada fichero están esas señas."""
    hay = defaultdict(set)
    for ruta, linea in set().union(*(donde[sena] for sena in comunes)):
        hay[ruta].add(linea)
    return dict(hay)


def parejas(entregas, dadas=(), basta=BASTA):
    """De {quién: sus textos}, las que se parecen, antes las que más tienen en común y menos propio. DADAS: lo que
    tiene cualquiera."""
    de_otros = de_fuera(dadas)
    de_todos = set().union(*(senas(textos, de_otros) for textos in dadas))
    suyas = {quien: senas(textos, de_otros) for quien, textos in entregas.items()}
    donde = {quien: {s: d for s, d in hay.items() if s not in de_todos} for quien, hay in suyas.items()}
    veces = Counter(sena for hay in donde.values() for sena in hay)
    muchas = max(COMUN[0], len(entregas) // COMUN[1])
    peso = {s: 1 / max(1, n - 1) for s, n in veces.items() if n <= muchas}  # lo que hacen varios dice menos
    pesan = {q: sum(peso.get(s, 0) for s in hay) for q, hay in donde.items()}
    quienes = defaultdict(list)
    for quien, hay in donde.items():
        for sena in peso.keys() & hay.keys():
            quienes[sena].append(quien)
    comunes = defaultdict(list)
    for sena, son in quienes.items():
        for par in itertools.combinations(son, 2):
            comunes[par].append(sena)
    halladas = []
    for (una, otra), hay in comunes.items():
        pesa = sum(peso[s] for s in hay)
        cuanto = 2 * pesa / (pesan[una] + pesan[otra])
        if cuanto >= basta and pesa >= MINIMO:
            halladas.append(Pareja(una, otra, cuanto, pesa, (lineas(donde[una], hay), lineas(donde[otra], hay))))
    return sorted(halladas, key=lambda p: (-round(p.pesa * p.cuanto, 6), -round(p.pesa, 6), str(p.una), str(p.otra)))


def al_lado(textos, marcadas):
    """De cada fichero, sus líneas marcadas y las de alrededor: (fichero, [(número, línea, si está marcada)]); donde se
    salta alguna, None."""
    for ruta in sorted(marcadas.keys() & textos.keys()):
        todas, son, filas, antes = textos[ruta].split("\n"), marcadas[ruta], [], 0
        for n in range(1, len(todas) + 1):
            if any(k in son for k in range(n - ALREDEDOR, n + ALREDEDOR + 1)):
                filas += [None] * (n > antes + 1) + [(n, todas[n - 1].expandtabs(4)[:ANCHO], n in son)]
                antes = n
        yield ruta, filas[:ALTO]
