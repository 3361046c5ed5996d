"""Lo que va en el hueco de un ejercicio, perturbado: sin una instrucción, con otro signo, con otro factor, con los
operandos, los argumentos o las instrucciones en otro orden. Vale para C++ y para GLSL, y no todo compila."""
import re
from dataclasses import dataclass

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
BLOQUES = "struct", "class", "union", "namespace", "extern"
CON_CONDICION = "for", "while", "if", "switch"
TIPOS = "int", "float", "double", "bool", "char", "void", "unsigned", "const"
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

    def primario_antes(self, i):
        """Desde qué palabra viene el que acaba en i."""
        while True:
            if self[i] in CIERRA.values():
                i = self.pareja.get(i, i)
                if not self.es_nombre(i - 1) and self[i - 1] not in (")", "]"):
                    return max(i, 0)
                i -= 1
            elif self[i - 1] in (".", "->"):
                i -= 2
            else:
                return max(i, 0)

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
        return (
            0 < i < len(self.palabras) - 1
            and (self.es_nombre(i - 1) or self[i - 1] in (")", "]", "}"))
            and self[i - 1] != "return"
        )

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

    def clase(self, i, lengua):
        """Para no cambiar un argumento por otro que no puede ser del mismo tipo; en C++, de una función, casi nunca un
        número por otra cosa."""
        if '"' in self[i] or self[i][0] in "&['{":
            return self[i][0]
        return "número" if lengua.producto and self[i][0].isdigit() else "valor"

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
                if p == "*" and (self[una[0]][0].isdigit() or self[otra[0]][0].isdigit()):  # da lo mismo en otro orden
                    continue
                producto = lengua.producto.format(self.de(*una), self.de(*otra))
                yield "operandos", self.con((una[0], otra[1], producto)) if p == "*" else self.cambiados(una, otra)
            if p == "?" and (otra := next((j for j in range(i, len(self.palabras)) if self[j] == ":"), 0)):
                fin = otra + 1
                while fin < len(self.palabras) and self[fin] not in (",", ")", "}", ";"):
                    fin = self.pareja.get(fin, fin) + 1 if self[fin] in CIERRA else fin + 1
                if i + 1 < otra < fin - 1:
                    yield "las dos ramas", self.cambiados((i + 1, otra - 1), (otra + 1, fin - 1))
            if (
                p in "([{"
                and i in self.pareja
                and self[i - 1] not in ("]", *CONMUTAN)
                and (p != "{" or self[i - 2] not in CONMUTAN)
            ):
                partes = self.partes(i, self.pareja[i])
                for una, otra in zip(partes, partes[1:]):
                    es_valor = p != "(" or re.search(r"(vec|mat)\d$", self[i - 1])
                    if es_valor or self.clase(una[0], lengua) == self.clase(otra[0], lengua):
                        yield "argumentos", self.cambiados(una, otra)
            if self.es_nombre(i) and self[i - 1] not in (".", "->", "++", "--", "&") and p[0] not in "\"'":
                fin = self.primario(i)
                instruccion = i == 0 and self[fin + 1] == ";"  # no da nada que se use
                sigue = self[fin + 1]
                if (
                    sigue not in ("=", "+=", "-=", "*=", "/=", "<", "++", "--")
                    and not sigue[:1].isalpha()
                    and not instruccion
                ):
                    for factor in lengua.factores:
                        yield "factor", self.con((i, fin, factor.format(self.de(i, fin))))


class Hueco:
    """Las instrucciones de un hueco, que puede acabar y empezar en cualquier sitio."""

    def __init__(self, texto, desde, hasta):
        self.texto, self.desde = sin_comentarios(texto[:hasta]), desde
        self.t = Trozo(self.texto[desde:])
        self.n = len(self.t.palabras)

    def sitio(self, i, j):
        return self.desde + self.t.palabras[i][1], self.desde + self.t.palabras[min(j, self.n - 1)][2]

    def cierra(self, i):
        """La pareja de esa palabra o, si se queda fuera del hueco, la última."""
        return self.t.pareja.get(i, self.n - 1)

    def lambdas(self, i, j):
        """Las llaves de las que hay entre esas palabras."""
        t, k = self.t, i
        while k < j:
            fin = t.pareja.get(k, k) + 1
            if t[k] == "[" and not t.es_nombre(k - 1) and t[k - 1] not in (")", "]") and t[fin] in ("(", "{"):
                abre = next((m for m in range(t.pareja.get(fin, fin), j) if t[m] == "{"), None)
                if abre and abre in t.pareja:
                    yield abre, t.pareja[abre]
                    k = t.pareja[abre]
            k += 1

    def expresion(self, i, j):
        t = self.t
        if cuerpos := [*self.lambdas(i, j)]:
            for abre, cierra in cuerpos:
                yield from self.trozos(abre + 1, cierra)
        elif t[i] == "{" and t.pareja.get(i) == j:
            for parte in t.partes(i, j):
                yield from self.expresion(*parte)
        elif i <= j and t[i][0] not in "\"'." and t[i][:2] != 'R"' and not self.es_declaracion(i, j, False):
            yield *self.sitio(i, j), False

    def es_declaracion(self, i, j, entera=True):
        """Si lo es esa instrucción o, si no es una ENTERA, esa expresión, en la que a * b es un producto."""
        desde, hasta = self.sitio(i, j)
        declara = DECLARA.match(self.texto[:hasta], desde)
        es_producto = declara and not entera and re.search(r"\w\s*[*&]+\s*\w+\s*$", declara[0])
        return (
            self.t[i] in TIPOS
            or bool(declara)
            and not (es_producto and self.texto[declara.end() : declara.end() + 1] not in "={")
        )

    def instruccion(self, i):
        """Hasta dónde llega la que empieza ahí: su «;» o, si abre un bloque (una función, una estructura), la llave."""
        t, fin = self.t, i
        while fin < self.n and t[fin] != ";":
            if t[fin] == "{" and (t[i] in BLOQUES or self.es_cuerpo(i, fin)):
                return fin
            fin = self.cierra(fin) + 1 if t[fin] in CIERRA else fin + 1
        return fin

    def es_cuerpo(self, i, llave):
        """De una función, y no lo que vale algo ni una lambda."""
        t, antes = self.t, llave - 1
        while antes > i and t[antes] in ("const", "noexcept", "override", "mutable"):
            antes -= 1
        return (
            t[antes] == ")" and t[t.pareja.get(antes, 0) - 1] not in ("]", "=", "(") and self.es_declaracion(i, llave)
        )

    def declaradas(self, i, fin):
        """Lo que valen las que se declaran en esa instrucción."""
        t = self.t
        for de, a in t.partes(i - 1, fin):
            igual = next((k for k in range(de, a + 1) if t[k] in ("=", "(", "{", "[")), a)
            if t[igual] == "=":
                yield from self.expresion(igual + 1, a)
            elif t[igual] in ("(", "{") and t.pareja.get(igual) == a:
                for parte in t.partes(igual, a):
                    yield from self.expresion(*parte)

    def trozos(self, i=0, hasta=None):
        """(desde, hasta, si es una instrucción) de cada expresión que se puede perturbar por su cuenta."""
        t, hasta = self.t, self.n if hasta is None else hasta
        while i < hasta:
            sigue = i + 1
            if t[i] in CON_CONDICION and t[i + 1] == "(":
                sigue = self.cierra(i + 1) + 1
                partes = t.partes(i + 1, sigue - 1, ";")
                for parte in partes[1:] if t[i] == "for" else partes[-1:]:
                    yield from self.expresion(*parte)
            elif t[i] == "catch":
                sigue = self.cierra(i + 1) + 1
            elif t[i] in ("case", "default", "public", "private", "protected") or t[i + 1] == ":" and t.es_nombre(i):
                sigue = next((k for k in range(i, self.n) if t[k] == ":"), i) + 1
            elif t[i] == "{" and t[self.cierra(i) + 1] == ",":  # la fila de una tabla
                yield from self.expresion(i, self.cierra(i))
                sigue = self.cierra(i) + 1
            elif (
                t[i] not in ("else", "do", "try", *"{}(),;:[]", "constexpr") or t[i] == "constexpr" and t[i - 1] != "if"
            ):
                fin = self.instruccion(i)
                yield from self.de_instruccion(i, fin)
                sigue = fin + 1
            i = sigue

    def de_instruccion(self, i, fin):
        t = self.t
        if t[fin] == "{" or any(t[k] in NI_TOCARLO for k in range(i, min(i + 3, fin))):
            return
        if t[i] in ("return", "throw"):
            yield from self.expresion(i + 1, fin - 1)
        elif t[i] in BLOQUES or self.es_declaracion(i, fin):
            yield from self.declaradas(i, fin)
        elif fin < self.n and not any(self.lambdas(i, fin)):
            yield *self.sitio(i, fin), True
        else:
            yield from self.expresion(i, fin - 1)


def perturbaciones(texto, desde, hasta, glsl):
    """Todas las de ese hueco."""
    hechas, anterior = [], None

    def apunta(que, *cambios):
        linea = texto.count("\n", 0, cambios[0][0]) + 1
        hechas.append(Perturbacion(que, cambios, linea, re.sub(r"\s+", " ", cambios[-1][2])))

    for de, a, instruccion in Hueco(texto, desde, hasta).trozos():
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
