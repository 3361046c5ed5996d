"""Las páginas del laboratorio, a partir de los TSV que escribe CMake (herramientas/programa.cmake) y de las plantillas."""
import itertools
import re
from dataclasses import dataclass, field
from pathlib import Path

import jinja2
from pygments import highlight
from pygments.formatters import HtmlFormatter
from pygments.lexers import CppLexer, GLShaderLexer

PLANTILLAS = Path(__file__).parent / "plantillas"
CLARO, OSCURO = HtmlFormatter(style="xcode", nowrap=True), HtmlFormatter(style="github-dark", nowrap=True)


@dataclass
class Caso:
    capitulo: str
    programa: str
    nombre: str
    guion: str
    argumentos: str
    tolerancia: str
    fichero: str
    mira: str
    borde: str
    anima: str
    salida: str = ""  # lo que escribe el programa
    fallo: str = ""

    @property
    def imagen(self):
        return f"{self.capitulo}/{self.fichero}.png"

    @property
    def animada(self):
        return f"{self.capitulo}/{self.fichero}.anima.png"

    @property
    def titulo(self):
        return "" if self.nombre == "base" else self.nombre.replace("_", " ")

    @property
    def guion_breve(self):
        """El guion, con las repeticiones contadas: «tecla d ×7 · tecla w»."""
        ordenes = itertools.groupby(orden.strip() for orden in self.guion.split(";"))
        veces = ((orden, len(list(grupo))) for orden, grupo in ordenes)
        return " · ".join(orden + (f" ×{n}" if n > 1 else "") for orden, n in veces)


@dataclass
class Programa:
    capitulo: str
    nombre: str
    referencia: str
    titulo: str
    consola: str
    titulo_capitulo: str
    casos: list = field(default_factory=list)
    controles: list = field(default_factory=list)
    fuentes: list = field(default_factory=list)


@dataclass
class Capitulo:
    nombre: str
    titulo: str
    programas: list

    @property
    def numero(self):
        return int(re.match(r"ch(\d+)", self.nombre)[1])


def lee_tsv(fichero, clase):
    filas = fichero.read_text().splitlines()
    return [clase(*("" if campo == "-" else campo for campo in fila.split("\t"))) for fila in filas]


def lee_catalogo(build):
    """Los capítulos, con sus programas, con sus casos. Uno de consola tiene un caso sin imagen: lo que escribe."""
    programas = lee_tsv(build / "catalogo.tsv", Programa)
    casos = lee_tsv(build / "casos.tsv", Caso)
    for p in programas:
        p.casos = [c for c in casos if c.programa == p.nombre]
        if p.consola:
            p.casos = [Caso(p.capitulo, p.nombre, "base", "", "", "", p.nombre, "", "", "")]
    return [Capitulo(nombre, grupo[0].titulo_capitulo or nombre, grupo) for nombre, grupo in
            ((nombre, list(grupo)) for nombre, grupo in itertools.groupby(programas, lambda p: p.capitulo))]


def controles(texto):
    """Los que enumera «// Controles:» hasta el punto final, aunque ocupe varias líneas."""
    hallado = re.search(r"^// Controles: ((?:.*\n// )*?.*\.)$", texto, re.MULTILINE)
    return hallado[1].replace("\n// ", " ").rstrip(".").split(" · ") if hallado else []


def fuentes(raiz, fichero, vistas=None):
    """Un fuente y los de los capítulos que nombra entre comillas, cabeceras y shaders, y así con cada uno."""
    vistas = [] if vistas is None else vistas
    vistas.append(fichero)
    for nombre in re.findall(r'"([\w./]+\.(?:h|cpp|vert|frag|glsl))"', (raiz / fichero).read_text()):
        for candidato in (fichero.parent / nombre, Path(nombre)):
            if candidato not in vistas and candidato.parts[0].startswith("ch") and (raiz / candidato).is_file():
                fuentes(raiz, candidato, vistas)
    return vistas


def colorea(raiz, fichero):
    lexico = CppLexer() if fichero.suffix in (".cpp", ".h") else GLShaderLexer()
    return highlight((raiz / fichero).read_text(), lexico, CLARO)


def escribe(raiz, destino, capitulos):
    """DESTINO/index.html: la galería entera en un fichero, al lado de sus imágenes."""
    for programa in (p for capitulo in capitulos for p in capitulo.programas):
        fichero = Path(programa.capitulo, f"{programa.nombre}.cpp")
        programa.controles = controles((raiz / fichero).read_text())
        programa.fuentes = fuentes(raiz, fichero)
    todas = dict.fromkeys(f for capitulo in capitulos for p in capitulo.programas for f in p.fuentes)
    _pagina(destino, "galeria.html", capitulos=capitulos, codigo={str(f): colorea(raiz, f) for f in todas},
            colores_claros=CLARO.get_style_defs("pre"), colores_oscuros=OSCURO.get_style_defs("pre"))


def cifra(x):
    """Tres cifras significativas, como se leen: 0.0123, 12.3, 1 230 000; las muy pequeñas o muy grandes, 1.2·10⁻⁹."""
    if x != x:
        return "—"
    if x in (0, float("inf")):
        return "0" if x == 0 else "no vale"
    if 1e-3 <= abs(x) < 1e7:
        entera, _, decimal = (f"{x:.3g}" if abs(x) < 1000 else f"{x:.0f}").partition(".")
        return re.sub(r"(?<=\d)(?=(\d{3})+$)", "\u202f", entera) + ("." + decimal if decimal else "")
    mantisa, _, exponente = f"{x:.1e}".partition("e")
    return f"{mantisa}·10{str(int(exponente)).translate(str.maketrans('-0123456789', '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'))}"


def escribe_informe(destino, tecnicas, **datos):
    """DESTINO/index.html: el informe de ./lab mide, al lado de sus gráficas e imágenes."""
    _pagina(destino, "informe.html", tecnicas=tecnicas, lento=100, graficas={t.nombre for t in tecnicas if (destino / f"{t.nombre}.svg").exists()}, **datos)


def _pagina(destino, plantilla, **datos):
    entorno = jinja2.Environment(loader=jinja2.FileSystemLoader(PLANTILLAS), autoescape=True, trim_blocks=True,
                                 lstrip_blocks=True, undefined=jinja2.StrictUndefined)
    entorno.filters["cifra"] = cifra
    parcial = destino / "index.html.parcial"
    parcial.write_text(entorno.get_template(plantilla).render(**datos))
    parcial.replace(destino / "index.html")
