"""Lo que va en el hueco de un ejercicio, perturbado: sin una instrucción, con otro signo o con otro factor. Vale para
C++ y para GLSL, y no todo compila."""
import re
from dataclasses import dataclass

from base.defectos import DE_NADIE, Mutante, cambia

PALABRA = re.compile(
    r'R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])*\'|(?:\d[\d.]*|\.\d+)(?:[eE][-+]?\d+)?\w*'
    r"|(?:sizeof|alignof|offsetof|decltype)\s*\([^()]*\)|[A-Za-z_][\w:]*<[\w:, ]+>(?=[({:])"
    r"|[A-Za-z_][\w:]*\w|\w|\+\+|--|[-+*/%<>=!&|]=|&&|\|\||->|\S",
    re.S,
)
# lo que no es código: los textos se quedan, y lo demás, comentarios y directivas, se borra
TEXTOS = r'R"(?P<marca>\w*)\(.*?\)(?P=marca)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\''
FUERA = re.compile(rf"(?P<queda>{TEXTOS})|//[^\n]*|/\*.*?(?:\*/|\Z)|^[ \t]*#(?:\\\n|[^\n])*", re.S | re.M)
DECLARA = re.compile(
    r"(?:(?:const|static|unsigned|signed|volatile|extern|inline|mutable|thread_local)\s+)*"
    r"(?!(?:return|delete|throw|new|goto)\b)[A-Za-z_][\w:]*(?:<[\w:\s,<>*&()]*>)?(?:\s+const\b)?[\s&*]+"
    r"(?:\[[\w\s,]+\]|[A-Za-z_]\w*)\s*(?=[=({;,\[:]|$)"
)
NI_TOCARLO = "constexpr", "using", "typedef", "template", "static_assert", "enum", "friend", "goto", "asm", "operator"
TRAS_LOS_PARAMETROS = ")", "const", "noexcept", "override", "mutable"
BLOQUES = "struct", "class", "union", "namespace", "extern"
CON_DOS_PUNTOS = "case", "default", "public", "private", "protected"
CON_CONDICION = "for", "while", "if", "switch"
TIPOS = "int", "float", "double", "bool", "char", "void", "unsigned", "const"
OTRO = {"+": "-", "-": "+", "*": "/", "/": "*", "<": "<=", ">": ">=", "<=": "<", ">=": ">", "==": "!=", "!=": "=="}
OTRO |= {"&&": "||", "||": "&&", "+=": "-=", "-=": "+=", "*=": "/=", "%": "+", "!": ""}
NO_ES_VALOR = "=", "+=", "-=", "*=", "/=", "<", "++", "--"  # lo que tiene eso detrás
BUCLES = "for", "while", "do"
ACABA_EN = {"break": ("switch",), "continue": BUCLES}  # qué acaba un salto; hacia él se sale de lo demás
SIN_ELLA, NUNCA = ("sin ella", ";"), ("nunca", "false")  # una instrucción; la condición de un if o de un bucle
CIERRA = {"(": ")", "[": "]", "{": "}"}
EN_CPP, EN_GLSL = ("otroFactor({})",), ("({} * 1.25)", "({} + 1)")  # cómo se escribe otro factor


# Todas se compilan en un binario, y el compilador dice de cada error en cuál está, que es su línea.
MARCA = '\n#line {} "perturbado"\n'
ERROR = re.compile(r"perturbado:(\d+):(?:\d+:)? (?:fatal )?error: (.*)")


@dataclass(frozen=True)
class Perturbacion:
    que: str
    desde: int  # de un trozo entero del fuente
    hasta: int
    otro: str  # lo que va en su lugar
    linea: int


@dataclass(eq=False)
class Perturbado(Mutante):
    """Un defecto que es una de ellas: se sabe dónde está."""

    perturbacion: Perturbacion = None

    def sitio(self, fuente):
        return self.perturbacion.desde, self.perturbacion.hasta


def perturbado(p, numero, fichero, texto):
    antes = texto[p.desde : p.hasta]
    imita = f"línea {p.linea}, {p.que}: «{antes}» → «{p.otro}»".replace("\n", " ")
    return Perturbado("azar", numero, numero, fichero, antes, p.otro, imita, perturbacion=p)


def sin_comentarios(texto):
    """Ni directivas, con lo mismo en el mismo sitio."""
    return FUERA.sub(lambda m: m["queda"] or re.sub(r"[^\n]", " ", m[0]), texto)


class Trozo:
    """Las palabras de una expresión, con su sitio, y qué abre y cierra cada una."""

    def __init__(self, texto):
        self.texto = texto
        self.palabras = [(m[0], m.start(), m.end()) for m in PALABRA.finditer(texto)]
        self.pareja, abiertas = {}, []
        for i, (p, *_) in enumerate(self.palabras):
            if p in CIERRA:
                abiertas.append(i)
            elif p in CIERRA.values() and abiertas:
                otra = abiertas.pop()
                self.pareja[i], self.pareja[otra] = otra, i

    def de_que(self, cierra):
        """De qué es el bloque que se cierra ahí: switch, for…, «{» si es uno suelto, o nada si no se sabe o de él no se
        sale por abajo."""
        antes = self.pareja.get(cierra, 0) - 1
        if self[antes] == ")":
            antes = self.pareja.get(antes, 0) - 1
            return self[antes] if self[antes] in CON_CONDICION else ""
        return "do" if self[antes] == "do" else "{" if self[antes] in ("else", *"{};:") else ""

    def es_nombre(self, i):
        return (
            0 <= i < len(self.palabras)
            and bool(re.match(r"[\w.\"']", self.palabras[i][0]))
            and self[i] not in (".", "return")
        )

    def __getitem__(self, i):
        return self.palabras[i][0] if 0 <= i < len(self.palabras) else ""

    def primario(self, i):
        """Hasta qué palabra llega el que empieza en i: f(x)[k].y."""
        while self[i] in ("-", "!"):
            i += 1
        if self[i] in CIERRA:
            i = self.pareja.get(i, i)
        while self[i + 1] in (".", "->", "(", "[") or (self.es_nombre(i) and self[i + 1] == "{"):
            i = self.pareja.get(i + 1, i + 1) if self[i + 1] in CIERRA else i + 2
        return min(i, len(self.palabras) - 1)

    def es_binario(self, i):
        return (
            0 < i < len(self.palabras) - 1
            and (self.es_nombre(i - 1) or self[i - 1] in (")", "]", "}"))
            and self[i - 1] != "return"
        )

    def con(self, i, j, otro):
        """El texto con lo que hay de una palabra a otra cambiado."""
        return self.texto[: self.palabras[i][1]] + otro + self.texto[self.palabras[j][2] :]

    def de(self, i, j):
        return self.texto[self.palabras[i][1] : self.palabras[j][2]]

    def partes(self, abre, cierra, coma=","):
        """Los argumentos entre esas dos palabras, [de, a]."""
        partes, i, de = [], abre + 1, abre + 1
        while i <= cierra:
            if i == cierra or self[i] == coma:
                if de < i:
                    partes.append((de, i - 1))
                de = i + 1
            i = self.pareja.get(i, i) + 1 if self[i] in CIERRA else i + 1
        return partes

    def perturba(self, factores):
        """(qué, cómo queda) de cada una de las que se le pueden hacer."""
        for i, (p, *_) in enumerate(self.palabras):
            if p in OTRO:
                yield "operación", self.con(i, i, OTRO[p] if self.es_binario(i) else "")
            if self.es_nombre(i) and self[i - 1] not in (".", "->", "++", "--", "&") and p[0] not in "\"'":
                fin = self.primario(i)
                instruccion = i == 0 and self[fin + 1] == ";"  # no da nada que se use
                sigue = self[fin + 1]
                if sigue not in NO_ES_VALOR and not sigue[:1].isalpha() and not instruccion:
                    for factor in factores:
                        yield "factor", self.con(i, fin, factor.format(self.de(i, fin)))


class Hueco(Trozo):
    """Las instrucciones de un hueco, que puede acabar y empezar en cualquier sitio."""

    def __init__(self, texto, desde, hasta):
        self.entero, self.desde = sin_comentarios(texto[:hasta]), desde
        self.todo = Trozo(sin_comentarios(texto))  # lo que hay fuera dice adónde lleva un salto
        super().__init__(self.entero[desde:])
        self.n = len(self.palabras)

    def sitio(self, i, j):
        return self.desde + self.palabras[i][1], self.desde + self.palabras[min(j, self.n - 1)][2]

    def cierra(self, i):
        """La pareja de esa palabra o, si se queda fuera del hueco, la última."""
        return self.pareja.get(i, self.n - 1)

    def es_declaracion(self, i, j, entera=True):
        """Si lo es esa instrucción o, si no es una ENTERA, esa expresión, en la que a * b es un producto."""
        desde, hasta = self.sitio(i, j)
        declara = DECLARA.match(self.entero[:hasta], desde)
        es_producto = declara and not entera and re.search(r"\w\s*[*&]+\s*\w+\s*$", declara[0])
        tras_ella = self.entero[declara.end() : declara.end() + 1] if declara else ""
        return self[i] in TIPOS or bool(declara) and not (es_producto and tras_ella not in "={")

    def expresion(self, i, j):
        if self[i] == "{" and self.pareja.get(i) == j:
            for parte in self.partes(i, j):
                yield from self.expresion(*parte)
        elif i <= j and self[i][0] not in "\"'." and self[i][:2] != 'R"' and not self.es_declaracion(i, j, False):
            yield *self.sitio(i, j), ()

    def acaba(self, i):
        """Dónde acaba la instrucción que empieza ahí: en su «;» o en la llave que abre un bloque, el de una función o
        una lambda, que va tras sus parámetros."""
        fin = i
        while fin < self.n and self[fin] != ";":
            if self[fin] == "{" and fin > i and (self[i] in BLOQUES or self[fin - 1] in TRAS_LOS_PARAMETROS):
                return fin
            con_lambda = any(self[k] == ";" for k in range(fin, self.cierra(fin)))
            fin = self.cierra(fin) + 1 if self[fin] in CIERRA and not con_lambda else fin + 1
        return fin

    def trozos(self):
        """(desde, hasta, cómo se quita entera, si se puede) de cada expresión que se puede perturbar por su cuenta."""
        i = 0
        while i < self.n:
            sigue = i + 1
            if self[i] in CON_CONDICION and self[i + 1] == "(":
                sigue = self.cierra(i + 1) + 1
                partes = self.partes(i + 1, sigue - 1, ";")
                for k, parte in enumerate(partes[1:] if self[i] == "for" else partes[-1:]):
                    como = NUNCA if not k and self[i] != "switch" else ()
                    yield from ((desde, hasta, como) for desde, hasta, _ in self.expresion(*parte))
            elif self[i] in CON_DOS_PUNTOS or self[i + 1] == ":" and self.es_nombre(i):
                sigue = next((k for k in range(i, self.n) if self[k] == ":"), i) + 1
            elif self[i] == "{" and self[self.cierra(i) + 1] == ",":  # la fila de una tabla
                yield from self.expresion(i, self.cierra(i))
                sigue = self.cierra(i) + 1
            elif self[i] not in ("else", "do", "try", *"{}(),;:[]"):
                fin = self.acaba(i)
                yield from self.de_instruccion(i, fin)
                sigue = fin + 1
            i = sigue

    def sobra(self, i):
        """Si esa instrucción solo salta adonde se llega igual: el break con que acaba un switch, o al que sigue otro, y
        el continue con que acaba un bucle."""
        salto, todo, desde = self[i], self.todo, self.sitio(i, i)[1]
        k = next((k for k, (_, de, _) in enumerate(todo.palabras) if de >= desde), 0)  # su «;»
        antes = k - 2
        while todo[antes] == ")":  # de un for o un if sin llaves
            antes = todo.pareja.get(antes, 0) - 2
            if todo[antes + 1] in BUCLES:
                return False
        while salto in ACABA_EN and k < len(todo.palabras):
            if todo[k] in ("case", "default"):
                k = next((j for j in range(k, len(todo.palabras)) if todo[j] == ":"), k)
            elif todo[k] == "}":
                de = todo.de_que(k)
                if de in ACABA_EN[salto] or de in ("", *BUCLES):
                    return de in ACABA_EN[salto]
            elif todo[k] != ";":
                return todo[k] == salto
            k += 1
        return False

    def de_instruccion(self, i, fin):
        if self.sobra(i) or self[fin] == "{" or any(self[k] in NI_TOCARLO for k in range(i, min(i + 3, fin))):
            return
        if self[i] in ("return", "throw"):
            yield from self.expresion(i + 1, fin - 1)
        elif self[i] in BLOQUES or self.es_declaracion(i, fin):
            yield from self.declaradas(i, fin)
        elif fin < self.n:
            yield *self.sitio(i, fin), SIN_ELLA
        else:
            yield from self.expresion(i, fin - 1)

    def declaradas(self, i, fin):
        """Lo que valen las que se declaran en esa instrucción."""
        for de, a in self.partes(i - 1, fin):
            igual = next((k for k in range(de, a + 1) if self[k] in ("=", "(", "{", "[")), a)
            if self[igual] == "=":
                yield from self.expresion(igual + 1, a)
            elif self[igual] in ("(", "{") and self.pareja.get(igual) == a:
                for parte in self.partes(igual, a):
                    yield from self.expresion(*parte)


def perturbaciones(texto, desde, hasta, glsl):
    """Todas las de ese hueco."""
    for de, a, quitada in Hueco(texto, desde, hasta).trozos():
        original = re.sub(r"\s+", " ", sin_comentarios(texto[de:a]))
        otros = dict.fromkeys(Trozo(original).perturba(EN_GLSL if glsl else EN_CPP))
        for que, otro in [*otros, *[quitada] * bool(quitada)]:
            if otro != original:
                yield Perturbacion(que, de, a, otro, texto.count("\n", 0, de) + 1)


def antes(raiz):
    """Lo que va al principio de un fuente que las tiene: lo que era constante ya no lo es."""
    otro_factor = raiz / "herramientas/ejercicios/otro_factor.h"
    return f'#pragma GCC diagnostic ignored "-Wnarrowing"\n#include "{otro_factor}"\n'


def culpables(dice, textos, vivas):
    """Los números de las que no compilan. Si en una declaración hay un error, lo que se declara detrás no está, y de
    quien lo usa se queja también el compilador: no tiene la culpa. Y si lo que ya no es constante debe serlo, la tiene
    quien lo declara."""
    errores = [(int(n), que) for n, que in ERROR.findall(dice)]
    de_rebote = {n for n, que in errores if "was not declared" in que}
    suyas = {n for n, _ in errores if n < DE_NADIE}
    if suyas:
        return suyas - de_rebote or suyas
    nombres = {nombre for _, que in errores for nombre in re.findall(r"‘(\w+)’", que)}
    declara = re.compile(rf"\b(?:{'|'.join(nombres) or '(?!)'})\s*[=({{]\s*\Z")
    sitios = {m.numero: (textos[m.fichero], m.sitio("")[0]) for m in vivas}
    return {n for n, (texto, desde) in sitios.items() if declara.search(texto, max(0, desde - 80), desde)}


def se_puede(m, texto):
    """Si en C++ cabe entre paréntesis, o es una instrucción entera."""
    try:
        return m.en_shader or bool(cambia(texto, [m]))
    except ValueError:
        return False
