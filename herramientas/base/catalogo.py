"""El catálogo: los capítulos, con sus programas, con sus casos. Los hechos de cada uno están solo en el catalogo.toml
de su capítulo, en el orden del libro; cuáles son, en su clase (dice). Solo se leen aquí: CMake pide al configurar lo
que sale de ellos, y de ahí lo toman los demás. Un programa es chNN_…/nombre.cpp; su caso «base» da la imagen
<programa>, y los otros, <programa>-<nombre>.

catalogo.py BUILD RAÍZ escribe BUILD/catalogo.json, lo que leen las herramientas; BUILD/catalogo.cmake, qué programas
hay, y BUILD/casos/PROGRAMA.sh, lo que de cada caso necesitan las pruebas.
"""
import difflib
import json
import re
import shlex
import sys
import unicodedata
from dataclasses import dataclass, field, fields
from pathlib import Path

from base.procesos import Fallo, escribe, principal

try:
    import tomllib
except ImportError:  # es de Python 3.11
    tomllib = None

NOMBRE, ALGO, NADA = r"[a-z0-9_]+", r"[^\n\t]+", r"[^\n\t]*"
LADO = "(izquierda|derecha|abajo|arriba)"


def dice(debe, son):
    """Un hecho que está en los catálogos: cómo debe ser, como expresión regular o de qué tipo, y con palabras."""
    return field(metadata={"debe": debe, "son": son}, default_factory=str if isinstance(debe, str) else debe)


CLASES = {"listado": "l", "list": "l", "ejercicio": "e", "ej": "e", "figura": "f", "fig": "f", "tabla": "t"}
CLASES |= {"ecuacion": "ec", "ec": "ec", "apartado": "§", "capitulo": "ch", "cap": "ch"}
DE_QUE = re.compile(rf"({'|'.join(CLASES)})\.? ?(?=\d)")


def llano(texto):
    """Sin acentos ni mayúsculas."""
    return re.sub("[\u0300-\u036f]", "", unicodedata.normalize("NFD", texto)).lower()


def numero(referencia):
    """3.5, de E3.5."""
    return re.sub(r"^\D*", "", referencia)


def abrevia(pedido):
    """Como se llama en el catálogo lo que alguien pide: «Listado 5.1» es l5.1; «5» y «cap. 5», ch05; «Grúa», grua."""
    suyo = llano(pedido).strip().removesuffix(".cpp")
    if clase := DE_QUE.match(suyo):
        suyo = CLASES[clase[1]] + suyo[clase.end() :]
    return re.sub(r"^(?:ch)?(\d{1,2})$", lambda e: f"ch{int(e[1]):02}", suyo)


def juntas(palabras):
    """Las mismas, con «listado 5.1», que en la terminal son dos, en una."""
    hechas = []
    for palabra in palabras:
        if hechas and llano(hechas[-1]).rstrip(".") in CLASES and re.fullmatch(r"\d+(\.\d+)*", palabra):
            palabra = f"{hechas.pop()} {palabra}"
        hechas.append(palabra)
    return hechas


@dataclass
class Caso:
    programa: "Programa" = field(repr=False)
    nombre: str = dice(NOMBRE, "un nombre con minúsculas sin acento, cifras y _")
    fichero: str = ""  # el de su imagen, sin extensión
    titulo: str = dice(r"[^\n\t]{0,40}", "cómo se enseña, con 40 letras como mucho")
    guion: str = dice(NADA, "las órdenes que llevan a esa imagen")
    mira: str = dice(ALGO, "una frase, a qué hay que mirar: es el pie de la imagen")
    cumple: list = dice(list, "lo que dice el pie, para una prueba: es así en su golden y no en los demás")
    # por los demás lados la escena no llega al borde en una ventana de ninguna forma
    borde: str = dice(f"((todos|{LADO}( {LADO})*): .+)?", "«LADOS: por qué», por los que está cortada en una así")
    anima: str = dice("([1-9][0-9]{0,2} .+)?", "«N orden»: N cuadros, a diez por segundo, y entre cada dos, esa orden")
    tolerancia: str = dice(NADA, "la del comparador, si la imagen no es del mismo OpenGL que el golden")
    otro: str = dice(NADA, "la de su --otro")
    motivo: str = dice(NADA, "por qué hacen falta esas tolerancias")
    ventana: str = ""  # el título que le queda; lo que escribe el programa al llegar ahí, y por qué no se ha podido
    salida: str = ""
    fallo: str = ""
    hecho: bool = False  # en la galería que se está dibujando

    @property
    def imagen(self):
        """El PNG de la galería."""
        return f"{self.programa.capitulo.nombre}/{self.fichero}.png"

    @property
    def miniatura(self):
        """La que se ve en las páginas, de la mitad de lado."""
        return f"{self.programa.capitulo.nombre}/{self.fichero}.mini.webp"

    @property
    def animada(self):
        """La animación, como se ve en la página."""
        return f"{self.programa.capitulo.nombre}/{self.fichero}.anima.webp"

    @property
    def cuadros(self):
        """Los de la animación, uno a uno y al tamaño de un proyector."""
        cuantos = int(self.anima.split()[0]) if self.anima else 0
        return [f"{self.programa.capitulo.nombre}/{self.fichero}.anima/{i:03}.webp" for i in range(cuantos)]


@dataclass
class Programa:
    capitulo: "Capitulo" = field(repr=False)
    nombre: str = dice(NOMBRE, "el de su fuente, con minúsculas sin acento, cifras y _")
    ref: str = dice(ALGO, "qué es del libro: «L1.2 E3.5»")
    titulo: str = dice(ALGO, "un texto de un renglón")
    contra: str = dice(NADA, "con qué, que no salga de él, se compara")
    pruebas: list = dice(list, "las de GoogleTest que lo hacen")
    pasa: str = dice(NADA, "por qué se aparta de ello más de 2 niveles de 255")
    captura: str = dice(NADA, "el pie de nombre.png, una captura de pantalla de lo que no pinta OpenGL")
    admite: str = dice("(modelo|imagen|imagenes)?", "modelo, imagen o imagenes (dos): lo que se le da")
    consola: bool = dice(bool, "true, si escribe texto y no tiene imagen")
    casos: list = field(default_factory=list)
    raices = ()  # dónde busca sus ficheros antes que en el laboratorio

    @property
    def referencias(self):
        return self.ref.split()

    @property
    def carpeta(self):
        """Donde están sus ficheros, desde RAÍZ."""
        return Path(self.capitulo.nombre)

    @property
    def fuente(self):
        return self.carpeta / f"{self.nombre}.cpp"

    @property
    def objetivo(self):
        """Con qué nombre se compila, sin el del enlace."""
        return self.nombre

    def ficheros(self, raiz):
        """Su fuente y sus shaders: los lee siempre, aunque no lo apunte en $LAB_LEIDOS porque no usa common/."""
        return sorted(raiz.glob(f"{self.fuente.with_suffix('')}.*"))

    def ejecutable(self, build, enlace=None):
        """El que se usa sin ventana, o el de ese enlace."""
        return build / (enlace or (build / "sin_ventana").read_text().strip()) / self.capitulo.nombre / self.nombre

    def es(self, pedido):
        """Si es lo que se pide, escrito de cualquier manera: su nombre o su fuente, su capítulo o una referencia."""
        capitulo, suyo = self.capitulo.nombre, abrevia(pedido)
        nombres = self.nombre, f"{capitulo}/{self.nombre}", capitulo, capitulo.split("_")[0]
        return suyo in (*nombres, *map(llano, self.referencias), *map(numero, self.referencias))


@dataclass
class Capitulo:
    nombre: str
    titulo: str = dice(ALGO, "un texto de un renglón")
    portada: str = dice(NADA, "la imagen, de las suyas, que lo enseña; si no se dice, la primera")
    programas: list = field(default_factory=list)

    @property
    def numero(self):
        return int(re.match(r"ch(\d+)", self.nombre)[1])

    @property
    def caso_de_portada(self):
        """El de su portada o, si no la dice, el primero con imagen."""
        casos = [c for p in self.programas if not p.consola for c in p.casos]
        return next((c for c in casos if c.fichero == self.portada), casos[0] if casos else None)


def vale(valor, debe):
    if isinstance(debe, str):
        return isinstance(valor, str) and re.fullmatch(debe, valor)
    return type(valor) is debe and all(vale(uno, ALGO) for uno in (valor if debe is list else ()))


def hechos(donde, clase, dichos):
    """Lo que se dice de una cosa, entero y en su orden: vacío, lo que no está."""
    campos = {c.name: c for c in fields(clase) if c.metadata}
    if sobran := [campo for campo in dichos if campo not in campos]:
        raise Fallo(f"{donde}: sobra «{sobran[0]}»: de cada {clase.__name__.lower()} se dice {', '.join(campos)}")
    todos = {campo: dichos.get(campo, como.default_factory()) for campo, como in campos.items()}
    for campo, valor in todos.items():
        if not vale(valor, campos[campo].metadata["debe"]):
            mal = f"{campo} no puede ser «{valor}»" if valor else f"falta {campo}"
            raise Fallo(f"{donde}: {mal}: es {campos[campo].metadata['son']}")
    return todos


def tablas(donde, nombre, dichos):
    """Las [[nombre]] de algo, que se quitan de él: cada una, y cómo decir cuál es."""
    suyas = dichos.pop(nombre, [])
    if not isinstance(suyas, list) or not all(isinstance(una, dict) for una in suyas):
        raise Fallo(f"{donde}: cada {nombre} es una tabla [[…{nombre}]]")
    return [(f"{donde}: {una.get('nombre', f'el {nombre} {i}')}", una) for i, una in enumerate(suyas, 1)]


def sin_repetir(donde, cosas, campo):
    for i, una in enumerate(cosas):
        if una[campo] in (otra[campo] for otra in cosas[:i]):
            raise Fallo(f"{donde}: ya hay otro «{una[campo]}»")


def lee_casos(donde, programa, tablas_de_casos):
    casos = []
    for cual, dichos in tablas_de_casos:
        caso = hechos(cual, Caso, dichos)
        es_base = caso["nombre"] == "base"
        for campo, hace_falta in ("titulo", not es_base), ("motivo", caso["tolerancia"] or caso["otro"]):
            if hace_falta and not caso[campo]:
                raise Fallo(f"{cual}: falta {campo}")
        casos.append({"fichero": programa if es_base else f"{programa}-{caso['nombre']}", **caso})
    sin_repetir(donde, casos, "nombre")
    sin_repetir(donde, casos, "titulo")
    return casos


def lee_programa(donde, dichos):
    casos = tablas(donde, "caso", dichos)
    programa = hechos(donde, Programa, dichos)
    return {**programa, "casos": lee_casos(donde, programa["nombre"], casos)}


def lee_capitulos(raiz):
    """Lo que dicen los catalogo.toml, como queda en catalogo.json."""
    if not tomllib:
        raise Fallo(f"los catálogos los lee Python 3.11 o posterior, y este es {sys.version.split()[0]}")
    capitulos = []
    for fichero in sorted(raiz.glob("ch*/catalogo.toml")):
        donde = str(fichero.relative_to(raiz))
        try:
            dichos = tomllib.loads(fichero.read_text(encoding="utf-8"))
        except ValueError as error:  # también lo que no es UTF-8
            raise Fallo(f"{donde}: no es TOML: {error}") from None
        programas = [lee_programa(cual, suyos) for cual, suyos in tablas(donde, "programa", dichos)]
        capitulos.append({"nombre": fichero.parent.name, **hechos(donde, Capitulo, dichos), "programas": programas})
    sin_repetir("catalogo.toml", [p for c in capitulos for p in c["programas"]], "nombre")
    return capitulos


def cambia(fichero, texto):
    """Lo escribe si no es lo que hay: lo que depende de él no se hace otra vez."""
    if not fichero.exists() or fichero.read_text(encoding="utf-8") != texto:
        escribe(fichero, texto)


def main():
    build, raiz = map(Path, sys.argv[1:])
    cambia(build / "catalogo.json", json.dumps(lee_capitulos(raiz), ensure_ascii=False, indent=1) + "\n")
    programas = lee_programas(build)
    con_ventana = [p for p in programas if not p.consola]
    listas = {
        "CAPITULOS": [c.nombre for c in lee(build)],
        "PROGRAMAS": [f"{p.capitulo.nombre}/{p.nombre}" for p in programas],
        "CON_VENTANA": [f"{p.capitulo.nombre}/{p.nombre}" for p in con_ventana],
        "CASOS": [f"{p.nombre}.{c.nombre}" for p in con_ventana for c in p.casos],
    }
    cambia(build / "catalogo.cmake", "".join(f"set(LAB_{n} {' '.join(cosas)})\n" for n, cosas in listas.items()))
    for viejo in {f.stem for f in build.glob("casos/*.sh")} - {p.nombre for p in con_ventana}:
        (build / f"casos/{viejo}.sh").unlink()
    for p in con_ventana:
        lineas = [f"capitulo={p.capitulo.nombre}\n"]
        for caso in p.casos:
            campos = "nombre", "fichero", "guion", "tolerancia", "otro", "borde"
            lineas.append(f"caso {' '.join(f'{campo}={shlex.quote(getattr(caso, campo))}' for campo in campos)}\n")
        cambia(build / f"casos/{p.nombre}.sh", "".join(lineas))


def lee(build):
    """Los capítulos."""
    capitulos = [Capitulo(**c) for c in json.loads(Path(build, "catalogo.json").read_text())]
    for capitulo in capitulos:
        capitulo.programas = [Programa(capitulo, **p) for p in capitulo.programas]
        for p in capitulo.programas:  # el de uno de consola es lo que escribe, sin imagen
            p.casos = [Caso(p, "base", p.nombre)] if p.consola else [Caso(p, **c) for c in p.casos]
    return capitulos


def lee_programas(build):
    return [p for capitulo in lee(build) for p in capitulo.programas]


def resuelve(programas, pedido):
    """Los que son lo que se pide. De un número a secas (5.1), si son varias cosas de varios, hay que decir cuál."""
    elegidos, suyo = [p for p in programas if p.es(pedido)], abrevia(pedido)
    if not elegidos:
        hay = {llano(nombre): nombre for p in programas for nombre in (p.nombre, *p.referencias)}
        parecidos = [hay[nombre] for nombre in difflib.get_close_matches(suyo, hay, 3, 0)]
        raise Fallo(f"no hay ningún programa «{pedido}»; lo más parecido: {', '.join(parecidos)}")
    cosas = {}
    for referencia, nombre in ((r, p.nombre) for p in elegidos for r in p.referencias if numero(r) == suyo):
        cosas.setdefault(referencia, []).append(nombre)
    if len(cosas) > 1 and len(elegidos) > 1:
        son = ", ".join(f"{referencia} ({' '.join(suyos)})" for referencia, suyos in cosas.items())
        raise Fallo(f"«{pedido}» puede ser {son}: di cuál")
    return elegidos


def casos(programas, pedido):
    hay = [c for p in programas for c in p.casos if not p.consola and pedido in (p.nombre, c.fichero)]
    if not hay:
        nombre = pedido.split("-")[0]
        resuelve(programas, nombre)
        raise Fallo(f"«{pedido}» no es un caso de {nombre}")
    return hay


def elegidos(programas, pedidos):
    """Los casos que se nombran, o todos."""
    todos = [c for p in programas if not p.consola for c in p.casos]
    return [c for pedido in pedidos for c in casos(programas, pedido)] or todos


if __name__ == "__main__":
    principal(main)
