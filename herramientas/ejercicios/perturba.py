"""Lo que va en el hueco de un ejercicio, perturbado: sin una instrucción, con otro signo, con otro factor, con los
operandos, los argumentos o las instrucciones en otro orden. Vale para C++ y para GLSL, y no todo compila."""
import re
from dataclasses import dataclass

PALABRA = re.compile(
    r'"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])*\'|[\d.]*\d[\w.]*|[A-Za-z_][\w:]*\w|\w|[-+*/%<>=!&|]=|&&|\|\||->|\S'
)
DECLARA = re.compile(r"(?:const(?:expr)?\s+)?(?!return\b)[A-Za-z_][\w:]*(?:<[\w: ,]+>)?[\s&*]+(?=\w+\s*[=({])")
OTRO = {"+": "-", "-": "+", "*": "/", "/": "*", "<": "<=", ">": ">=", "<=": "<", ">=": ">", "==": "!=", "!=": "=="}
OTRO |= {"&&": "||", "||": "&&", "+=": "-=", "-=": "+=", "*=": "/=", "%": "+", "!": ""}
CIERRA = {"(": ")", "[": "]", "{": "}"}
CONMUTAN = "std::max", "std::min", "std::minmax", "glm::dot", "max", "min", "dot"


@dataclass(frozen=True)
class Lengua:
    """Cómo se escriben otro factor y, si hay matrices, un producto en otro orden."""

    factores: tuple
    producto: str = ""


EN_CPP, EN_GLSL = Lengua(("otroFactor({})",), "alReves({}, {})"), Lengua(("({} * 1.25)", "({} + 1)"))


@dataclass(frozen=True)
class Perturbacion:
    que: str
    cambios: tuple  # (desde, hasta, lo que va en su lugar) de trozos enteros del fuente
    linea: int
    texto: str  # cómo queda


def sin_comentarios(texto):
    """Con lo mismo en el mismo sitio."""
    return re.sub(r"//[^\n]*", lambda m: " " * len(m[0]), texto)


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
        if self[i] in ("-", "!"):
            return self.primario(i + 1)
        if self[i] in CIERRA:
            i = self.pareja.get(i, i)
        while self[i + 1] in (".", "->", "(", "[") or (self.es_nombre(i) and self[i + 1] == "{"):
            i = self.pareja.get(i + 1, i + 1) if self[i + 1] in CIERRA else i + 2
        return i

    def primario_antes(self, i):
        """Desde qué palabra viene el que acaba en i."""
        while True:
            if self[i] in CIERRA.values():
                i = self.pareja.get(i, i)
                if not self.es_nombre(i - 1) and self[i - 1] not in (")", "]"):
                    return i
                i -= 1
            elif self[i - 1] in (".", "->"):
                i -= 2
            else:
                return i

    def termino(self, i):
        i = self.primario(i)
        while self[i + 1] in ("*", "/", "%"):
            i = self.primario(i + 2)
        return i

    def termino_antes(self, i):
        i = self.primario_antes(i)
        while self[i - 1] in ("*", "/", "%"):
            i = self.primario_antes(i - 2)
        return i

    def es_binario(self, i):
        return i > 0 and (self.es_nombre(i - 1) or self[i - 1] in (")", "]", "}")) and self[i - 1] != "return"

    def con(self, *cambios):
        """El texto con lo de esas palabras, [de, a], cambiado."""
        texto = self.texto
        for de, a, otro in sorted(cambios, reverse=True):
            texto = texto[: self.palabras[de][1]] + otro + texto[self.palabras[a][2] :]
        return texto

    def de(self, i, j):
        return self.texto[self.palabras[i][1] : self.palabras[j][2]]

    def cambiados(self, *lados):
        (a, b), (c, d) = lados
        return self.con((a, b, self.de(c, d)), (c, d, self.de(a, b)))

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

    def perturba(self, lengua):
        """(qué, cómo queda) de cada una de las que se le pueden hacer."""
        for i, (p, *_) in enumerate(self.palabras):
            if p in OTRO:
                yield "operación", self.con((i, i, OTRO[p] if self.es_binario(i) else ""))
            if p in ("*", "-", "/") and self.es_binario(i) and (p != "*" or lengua.producto):
                antes, hasta = (self.primario_antes, self.primario) if p != "-" else (self.termino_antes, self.termino)
                una, otra = (antes(i - 1), i - 1), (i + 1, hasta(i + 1))
                if p == "-" and self[una[0] - 1] in ("-", "+"):  # −a − b es −b − a
                    continue
                producto = lengua.producto.format(self.de(*una), self.de(*otra))
                yield "operandos", self.con((una[0], otra[1], producto)) if p == "*" else self.cambiados(una, otra)
            if p == "?" and (otra := next((j for j in range(i, len(self.palabras)) if self[j] == ":"), 0)):
                fin = otra + 1
                while fin < len(self.palabras) and self[fin] not in (",", ")", "}", ";"):
                    fin = self.pareja.get(fin, fin) + 1 if self[fin] in CIERRA else fin + 1
                yield "las dos ramas", self.cambiados((i + 1, otra - 1), (otra + 1, fin - 1))
            if (
                p in "([{"
                and i in self.pareja
                and self[i - 1] not in ("]", *CONMUTAN)
                and (p != "{" or self[i - 2] not in CONMUTAN)
            ):
                partes = self.partes(i, self.pareja[i])
                for una, otra in zip(partes, partes[1:]):
                    yield "argumentos", self.cambiados(una, otra)
            if self.es_nombre(i) and self[i - 1] not in (".", "->") and p[0] not in "\"'":
                fin = self.primario(i)
                if self[fin + 1] not in ("=", "+=", "-=", "*=", "<") and not self[fin + 1][:1].isalpha():
                    for factor in lengua.factores:
                        yield "factor", self.con((i, fin, factor.format(self.de(i, fin))))


def trozos(texto, desde, hasta):
    """(desde, hasta, si es una instrucción) de cada expresión que se puede perturbar por su cuenta."""
    t = Trozo(sin_comentarios(texto[:hasta])[desde:])
    n = len(t.palabras)

    def sitio(i, j):
        return desde + t.palabras[i][1], desde + t.palabras[j][2]

    def expresion(i, j):
        if t[i] == "{" and t.pareja.get(i) == j:
            for parte in t.partes(i, j):
                yield from expresion(*parte)
        elif i <= j and t[i][0] not in "\"'":
            yield *sitio(i, j), False

    i = 0
    while i < n:
        if t[i] in ("for", "while", "if") and t[i + 1] == "(":
            partes = t.partes(i + 1, t.pareja[i + 1], ";")
            for parte in partes[1:] if t[i] == "for" else partes:
                yield *sitio(*parte), False
            i = t.pareja[i + 1] + 1
            continue
        if t[i] in ("else", "}", ",", ";"):
            i += 1
            continue
        if t[i] == "{":
            if t[t.pareja[i] + 1] == ",":  # la fila de una tabla
                yield from expresion(i, t.pareja[i])
                i = t.pareja[i] + 1
            else:
                i += 1
            continue
        fin = i
        while fin < n and t[fin] != ";":
            fin = t.pareja.get(fin, fin) + 1 if t[fin] in CIERRA else fin + 1
        if t[i] == "return":
            yield from expresion(i + 1, fin - 1)
        elif DECLARA.match(texto, t.palabras[i][1] + desde):
            for de, a in t.partes(i - 1, fin):
                igual = next((k for k in range(de, a + 1) if t[k] in ("=", "(", "{")), a)
                con = (igual + 1, a) if t[igual] == "=" else (igual + 1, a - 1)
                yield from expresion(*con)
        else:
            yield *sitio(i, fin), True
        i = fin + 1


def perturbaciones(texto, desde, hasta, glsl):
    """Todas las de ese hueco."""
    hechas, anterior = [], None

    def apunta(que, *cambios):
        linea = texto.count("\n", 0, cambios[0][0]) + 1
        hechas.append(Perturbacion(que, cambios, linea, re.sub(r"\s+", " ", cambios[-1][2])))

    for de, a, instruccion in trozos(texto, desde, hasta):
        original = re.sub(r"\s+", " ", sin_comentarios(texto[de:a]))
        for que, otro in dict.fromkeys(Trozo(original).perturba(EN_GLSL if glsl else EN_CPP)):
            if otro != original:
                apunta(que, (de, a, otro))
        if instruccion:
            apunta("sin ella", (de, a, ";"))
            if anterior and not texto[anterior[1] : de].strip():
                apunta("orden", (*anterior[:2], ";"), (de, a, f"{original} {anterior[2]}"))
        anterior = (de, a, original) if instruccion else None
    return hechas
