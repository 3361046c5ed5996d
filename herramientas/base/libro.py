"""Lo que se sabe de cada cosa del libro: qué es y, de un ejercicio, qué pide (docs/libro.tsv); qué se contesta
(docs/soluciones.md); y qué está mal en ella (docs/erratas.md)."""
import html
import re
from dataclasses import dataclass

from base import fuentes, marcas

CLASES = {"L": "listado", "E": "ejercicio", "F": "figura", "T": "tabla", "Ec": "ecuación", "§": "apartado"}


@dataclass
class Cosa:
    codigo: str
    que: str
    motivo: str = ""  # por qué no tiene programa
    enunciado: str = ""
    funciones: str = ""  # las que llama o define un listado


def filas(fichero):
    """Las de un TSV, sin los comentarios."""
    return [linea.split("\t") for linea in fichero.read_text().splitlines() if linea and not linea.startswith("#")]


@dataclass
class Porque:
    """Una pregunta que contesta un píxel: a qué capítulo pertenece (ch07), en qué enlace de la página se contesta y,
    allí, dónde mirar."""

    capitulo: str
    pregunta: str
    enlace: str  # zbuffer/explica/384,346;tecla z
    mira: str

    @property
    def orden(self):
        """Lo mismo, en la terminal."""
        donde, _, guion = self.enlace.partition(";")
        programa, pixel = donde.split("/explica/")
        return f"./lab explica {programa} {pixel.replace(',', ' ')}" + f' -guion "{guion}"' * bool(guion)


def porques(raiz):
    return [Porque(*fila) for fila in filas(raiz / "docs/porques.tsv")]


def cosas(raiz):
    return [Cosa(*fila) for fila in filas(raiz / "docs/libro.tsv")]


def nombre(codigo):
    """E3.5: ejercicio 3.5."""
    clase = re.match(r"\D+", codigo)[0]
    return f"{CLASES[clase]} {codigo.removeprefix(clase)}"


def codigos(titulo):
    """Las referencias que nombra el título de una errata: «Listado 9.1 y los de §9.1.2», L9.1 y §9.1.2."""
    de = {nombre: clase for clase, nombre in CLASES.items()}
    referencia = r"(listado|ejercicio|figura|tabla|ecuación) (\d+\.\d+)|§(\d+(?:\.\d+)+)"
    hallados = re.findall(referencia, titulo, re.IGNORECASE)
    return [de[clase.lower()] + numero if clase else "§" + apartado for clase, numero, apartado in hallados]


def entradas(texto):
    """Las de una lista de Markdown: el título, que va en negrita, y lo que sigue, sin las pruebas que lo enseñan."""
    for titulo, cuerpo in re.findall(r"^- \*\*(.+?)\*\*(.*(?:\n  .+)*)", texto, re.MULTILINE):
        for citas in (
            r"\s*(?:Sin prueba|Pruebas?)(?: de [^:]*)?:\s.*",
            r"\s+\(pruebas?:\s[^)]*\)",
            r"; pruebas?:\s[^)]*(?=\))",
        ):
            cuerpo = re.sub(citas, "", cuerpo, flags=re.DOTALL)
        yield titulo, cuerpo


def en_html(texto):
    """Las marcas de Markdown que usan esas páginas: código, negrita y cursiva. De un enlace queda su texto."""
    codigo = []

    def aparta(trozo):
        codigo.append(trozo[1])
        return f"\0{len(codigo) - 1}\0"

    texto = re.sub(r"`(.+?)`", aparta, html.escape(" ".join(texto.split()), quote=False))
    for patron, pone in (
        (r"\*\*(.+?)\*\*", r"<b>\1</b>"),
        (r"\*(.+?)\*", r"<i>\1</i>"),
        (r"\[(.+?)\]\(.+?\)", r"\1"),
        (r"\0(\d+)\0", lambda trozo: f"<code>{codigo[int(trozo[1])]}</code>"),
    ):
        texto = re.sub(patron, pone, texto)
    return texto


class Libro:
    """Con CAPITULOS, también qué programa es el primero de cada cosa: a él lleva su enlace."""

    nombre, en_html = staticmethod(nombre), staticmethod(en_html)

    def __init__(self, raiz, capitulos=()):
        self.raiz = raiz
        self.primeros = {}
        for programa in (p for capitulo in capitulos for p in capitulo.programas):
            for referencia in programa.referencias:
                self.primeros.setdefault(referencia, programa.nombre)
        textos = {f: f.read_text() for f in raiz.glob("ch*/*.*") if f.suffix in (".cpp", ".h", *fuentes.SHADERS)}
        self.por_hacer = set(marcas.que_piden(textos))  # E3.5, con ./lab nuevo; L5.1, en la página
        self.cosas = {c.codigo: c for c in cosas(raiz)}
        self.respuestas = {}
        for titulo, cuerpo in entradas((raiz / "docs/soluciones.md").read_text()):
            codigo = titulo if titulo[0] == "§" else f"E{titulo}"
            if codigo in marcas.ocultos(raiz):
                continue
            self.respuestas[codigo] = en_html(re.sub(r"^(?: \([^)]*\))?: ", "", cuerpo))  # lo que pide se lee encima
        capitulos = re.split(r"^## Capítulo (\d+)$", (raiz / "docs/erratas.md").read_text(), flags=re.MULTILINE)[1:]
        self.erratas = [
            (int(numero), set(codigos(titulo)), en_html(f"**{titulo}**{cuerpo}"), nombrado)
            for numero, texto in zip(capitulos[::2], capitulos[1::2])
            for titulo, todo in entradas(texto)
            for nombrado, cuerpo in [re.fullmatch(r"(?: \(`(\w+)`\))?(.*)", todo, re.DOTALL).groups()]
        ]

    def es_primero(self, referencia, programa):
        return self.primeros.get(referencia) == programa.nombre

    def anclas(self, programa):
        """Las referencias que llevan a ese programa, salvo las de sus enunciados, que llevan a ellos."""
        suyas = [r for r in programa.referencias if self.es_primero(r, programa)]
        return [r for r in suyas if not (r in self.cosas and self.cosas[r].enunciado)]

    def referencias(self, programa):
        """Cada una, con lo que es: E3.5, «ejercicio 3.5: la grúa de obra»."""
        return [(r, nombre(r) + (f": {self.cosas[r].que}" if r in self.cosas else "")) for r in programa.referencias]

    def explicacion(self, programa):
        """El comentario con que empieza su fuente, hasta sus controles."""
        comentario = re.match(r"(?:// (?!Controles: ).*\n)*", (self.raiz / programa.fuente).read_text())[0]
        return " ".join(linea.removeprefix("// ") for linea in comentario.splitlines())

    def ejercicios(self, programa):
        """Su código, lo que pide y lo que se contesta, en HTML. También lo que el texto propone fuera de ellos."""
        suyos = [r for r in programa.referencias if r in self.cosas and self.cosas[r].enunciado]
        return [(r, en_html(self.cosas[r].enunciado), self.respuestas.get(r, "")) for r in suyos]

    @staticmethod
    def es_de(errata, programa):
        """Del programa que nombra entre paréntesis o, si no nombra ninguno, de los que llevan una referencia suya."""
        _, suyos, _, nombrado = errata
        return programa.nombre == nombrado if nombrado else bool(suyos & set(programa.referencias))

    def erratas_de(self, programa):
        return [errata[2] for errata in self.erratas if self.es_de(errata, programa)]

    def porques(self, capitulo):
        return [p for p in porques(self.raiz) if capitulo.nombre.startswith(p.capitulo)]

    def otras_erratas(self, capitulo):
        """Las de ese capítulo que no son de ninguno de sus programas."""
        suyas = [e for e in self.erratas if e[0] == capitulo.numero]
        return [e[2] for e in suyas if not any(self.es_de(e, p) for p in capitulo.programas)]
