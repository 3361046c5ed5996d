"""El catálogo: los capítulos, con sus programas, con sus casos. Los hechos de cada uno están solo en el catalogo.toml de
su capítulo, en el orden del libro; qué se dice de cada cosa, en CAMPOS. Solo se leen aquí: CMake pide al configurar lo
que sale de ellos, y de ahí lo toman los demás. Un programa es chNN_…/nombre.cpp; su caso «base» da la imagen
<programa>, y los otros, <programa>-<nombre>.

catalogo.py BUILD escribe RAÍZ    BUILD/catalogo.json, lo que leen las herramientas; BUILD/catalogo.cmake, qué programas
                                  hay, y BUILD/casos/PROGRAMA.sh, lo que de cada caso necesitan las pruebas
catalogo.py BUILD lista [--tsv]   capítulo, programa, referencia y título
catalogo.py BUILD resuelve QUÉ    los programas de que se habla (su nombre, L1.2, E3.5, F3.3, ch05): capítulo, programa,
                                  imagen o texto, y título, entre tabuladores
catalogo.py BUILD casos QUÉ…      de cada caso que se nombra (grua, grua-girada), su programa y su nombre
catalogo.py BUILD cumple QUÉ…     de esos, lo que cumplen sus imágenes: capítulo, programa, imagen y afirmaciones, entre
                                  tabuladores
"""
import difflib
import json
import re
import shlex
import sys
from dataclasses import dataclass, field
from pathlib import Path

from base.procesos import Fallo, escribe, principal

try:
    import tomllib
except ImportError:  # es de Python 3.11
    tomllib = None

NOMBRE = "[a-z0-9_]+", "un nombre, solo con minúsculas sin acento, cifras y _"
FRASE = r"[^\n\t]+", "un texto de un renglón"
NADA_O_FRASE = r"[^\n\t]*", FRASE[1]
LADO = "(izquierda|derecha|abajo|arriba)"
CAMPOS = {  # lo que se dice de cada cosa, como expresión regular y con palabras; de [] y False, varias, y sí o no
    "capítulo": {
        "titulo": FRASE,
        "portada": (NADA_O_FRASE[0], "la imagen, de las suyas, que lo enseña; si no se dice, la primera"),
    },
    "programa": {
        "nombre": NOMBRE,
        "ref": (FRASE[0], "qué es del libro: «L1.2 E3.5»"),
        "titulo": FRASE,
        "contra": (NADA_O_FRASE[0], "con qué, que no salga de él, se compara"),
        "pruebas": ([], "las de GoogleTest que lo hacen"),
        "pasa": (NADA_O_FRASE[0], "por qué se aparta de ello más de 2 niveles de 255"),
        "captura": (NADA_O_FRASE[0], "el pie de nombre.png, una captura de pantalla de lo que no pinta OpenGL"),
        "admite": (
            "(modelo|imagen|imagenes)?",
            "el fichero que se le puede dar: modelo, imagen o, si son dos, imagenes",
        ),
        "consola": (False, "true, si escribe texto y no tiene imagen"),
    },
    "caso": {
        "nombre": NOMBRE,
        "titulo": (r"[^\n\t]{0,40}", "cómo se enseña, con 40 letras como mucho"),
        "guion": (NADA_O_FRASE[0], "las órdenes que llevan a esa imagen"),
        "mira": (FRASE[0], "una frase, a qué hay que mirar: es el pie de la imagen"),
        "cumple": (
            [],
            "lo que dice el pie, para tests/casos/pies.cpp: es así en su golden y no en los demás del programa",
        ),
        "borde": (
            f"((todos|{LADO}( {LADO})*): .+)?",
            "«LADOS: por qué», los de la ventana (izquierda, derecha, abajo, arriba, o todos) por los que está cortada la "
            "escena, en una de alguna forma",
        ),
        "anima": (
            "([1-9][0-9]{0,2} .+)?",
            "«N orden»: en la galería son N cuadros, a diez por segundo, y entre cada dos, esa orden",
        ),
        "tolerancia": (NADA_O_FRASE[0], "la del comparador, si la imagen no es del mismo OpenGL que el golden"),
        "otro": (NADA_O_FRASE[0], "la de su --otro"),
        "motivo": (NADA_O_FRASE[0], "por qué hacen falta esas tolerancias"),
    },
}
EN_JSON = "nombre titulo fichero guion tolerancia otro mira cumple borde anima".split()
EN_SH = "nombre fichero guion tolerancia otro borde".split()


@dataclass
class Caso:
    programa: "Programa" = field(repr=False)
    nombre: str
    fichero: str  # el de su imagen, sin extensión
    titulo: str = ""  # cómo se enseña
    guion: str = ""
    tolerancia: str = ""
    otro: str = ""
    mira: str = ""
    cumple: list = field(default_factory=list)
    borde: str = ""
    anima: str = ""
    ventana: str = ""  # el título que le queda; lo que escribe el programa al llegar ahí, y por qué no se ha podido
    salida: str = ""
    fallo: str = ""
    hecho: bool = False  # en la galería que se está dibujando

    @property
    def imagen(self):
        """El PNG de la galería."""
        return f"{self.programa.capitulo.nombre}/{self.fichero}.png"

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
    nombre: str
    ref: str
    titulo: str
    contra: str = ""
    pruebas: list = field(default_factory=list)
    pasa: str = ""
    captura: str = ""
    admite: str = ""
    consola: bool = False
    casos: list = field(default_factory=list)

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
    def raices(self):
        """Dónde busca sus ficheros antes que en el laboratorio."""
        return []

    @property
    def objetivo(self):
        """Con qué nombre se compila, sin el del enlace."""
        return self.nombre

    def ficheros(self, raiz):
        """Su fuente y sus shaders: los lee siempre, aunque no lo apunte en $LAB_LEIDOS porque no usa common/."""
        return sorted(raiz.glob(f"{self.fuente.with_suffix('')}.*"))

    def ejecutable(self, build):
        """El que se usa sin ventana."""
        return build / (build / "sin_ventana").read_text().strip() / self.capitulo.nombre / self.nombre

    def es(self, pedido):
        """Si es lo que se pide: su nombre, su capítulo o una de sus referencias."""
        capitulo = self.capitulo.nombre
        return pedido in (self.nombre, capitulo, capitulo.split("_")[0]) or pedido.lower() in self.ref.lower().split()


@dataclass
class Capitulo:
    nombre: str
    titulo: str
    portada: str = ""  # la imagen que lo enseña, por su fichero
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
    if isinstance(debe, bool):
        return isinstance(valor, bool)
    return isinstance(valor, list) and all(vale(uno, FRASE[0]) for uno in valor)


def hechos(donde, que, dichos):
    """Lo que se dice de una cosa, entero y en su orden: vacío, lo que no está."""
    for campo in dichos:
        if campo not in CAMPOS[que]:
            raise Fallo(f"{donde}: sobra «{campo}»: de cada {que} se dice {', '.join(CAMPOS[que])}")
    todos = {}
    for campo, (debe, son) in CAMPOS[que].items():
        todos[campo] = valor = dichos.get(campo, "" if isinstance(debe, str) else debe)
        if not vale(valor, debe):
            raise Fallo(f"{donde}: {f'{campo} no puede ser «{valor}»' if valor else f'falta {campo}'}: es {son}")
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


def lee_caso(donde, programa, dichos):
    caso = hechos(donde, "caso", dichos)
    if not caso["titulo"] and caso["nombre"] != "base":
        raise Fallo(f"{donde}: falta titulo: es {CAMPOS['caso']['titulo'][1]}")
    if (caso["tolerancia"] or caso["otro"]) and not caso["motivo"]:
        raise Fallo(f"{donde}: falta motivo: es {CAMPOS['caso']['motivo'][1]}")
    nombre = programa["nombre"]
    return {**caso, "fichero": nombre if caso["nombre"] == "base" else f"{nombre}-{caso['nombre']}"}


def lee_programa(donde, capitulo, dichos):
    casos = tablas(donde, "caso", dichos)
    programa = hechos(donde, "programa", dichos)
    programa["casos"] = [lee_caso(cual, programa, caso) for cual, caso in casos]
    sin_repetir(donde, programa["casos"], "nombre")
    sin_repetir(donde, programa["casos"], "titulo")
    return {"capitulo": capitulo, **programa}


def lee_capitulos(raiz):
    """Lo que dicen los catalogo.toml: los capítulos, y los programas con sus casos."""
    if not tomllib:
        raise Fallo(f"los catálogos los lee Python 3.11 o posterior, y este es {sys.version.split()[0]}")
    capitulos, programas = [], []
    for fichero in sorted(raiz.glob("ch*/catalogo.toml")):
        donde, nombre = str(fichero.relative_to(raiz)), fichero.parent.name
        try:
            dichos = tomllib.loads(fichero.read_text(encoding="utf-8"))
        except ValueError as error:  # también lo que no es UTF-8
            raise Fallo(f"{donde}: no es TOML: {error}") from None
        suyos = tablas(donde, "programa", dichos)
        capitulos.append({"nombre": nombre, **hechos(donde, "capítulo", dichos)})
        programas += [lee_programa(cual, nombre, programa) for cual, programa in suyos]
    sin_repetir("catalogo.toml", programas, "nombre")
    return capitulos, programas


def cambia(fichero, texto):
    """Lo escribe si no es lo que hay: lo que depende de él no se hace otra vez."""
    if not fichero.exists() or fichero.read_text(encoding="utf-8") != texto:
        escribe(fichero, texto)


def escribe_todo(raiz, build):
    capitulos, programas = lee_capitulos(raiz)
    casos = [{"programa": p["nombre"], **{c: caso[c] for c in EN_JSON}} for p in programas for caso in p["casos"]]
    de_programas = [
        {**p, "pruebas": " ".join(p["pruebas"]), "consola": "TRUE" if p["consola"] else ""} for p in programas
    ]
    for p in de_programas:
        del p["casos"]
    datos = {"capitulos": capitulos, "programas": de_programas, "casos": casos}
    cambia(build / "catalogo.json", json.dumps(datos, ensure_ascii=False, indent=1) + "\n")
    con_imagen = [p for p in programas if not p["consola"]]
    listas = {
        "CAPITULOS": [c["nombre"] for c in capitulos],
        "PROGRAMAS": [f"{p['capitulo']}/{p['nombre']}" for p in programas],
        "CON_VENTANA": [f"{p['capitulo']}/{p['nombre']}" for p in con_imagen],
        "CASOS": [f"{p['nombre']}.{caso['nombre']}" for p in con_imagen for caso in p["casos"]],
    }
    cambia(build / "catalogo.cmake", "".join(f"set(LAB_{n} {' '.join(cosas)})\n" for n, cosas in listas.items()))
    for viejo in {f.stem for f in build.glob("casos/*.sh")} - {p["nombre"] for p in con_imagen}:
        (build / f"casos/{viejo}.sh").unlink()
    for p in con_imagen:
        lineas = [" ".join(f"{c}={shlex.quote(caso[c])}" for c in EN_SH) for caso in p["casos"]]
        suyo = "".join(f"caso {linea}\n" for linea in lineas)
        cambia(build / f"casos/{p['nombre']}.sh", f"capitulo={p['capitulo']}\n{suyo}")


def lee(build):
    """Los capítulos."""
    datos = json.loads(Path(build, "catalogo.json").read_text())
    capitulos = {c["nombre"]: Capitulo(**c) for c in datos["capitulos"]}
    programas = {}
    for p in datos["programas"]:
        capitulo = capitulos[p.pop("capitulo")]
        programa = Programa(capitulo, **{**p, "pruebas": p["pruebas"].split(), "consola": bool(p["consola"])})
        capitulo.programas.append(programa)
        programas[programa.nombre] = programa
    for c in datos["casos"]:
        programa = programas[c.pop("programa")]
        programa.casos.append(Caso(programa, **c))
    for programa in programas.values():  # el de uno de consola es lo que escribe, sin imagen
        if programa.consola:
            programa.casos = [Caso(programa, "base", programa.nombre)]
    return list(capitulos.values())


def lee_programas(build):
    return [p for capitulo in lee(build) for p in capitulo.programas]


def resuelve(programas, pedido):
    elegidos = [p for p in programas if p.es(pedido)]
    if not elegidos:
        parecidos = difflib.get_close_matches(pedido, [p.nombre for p in programas], 3, 0)
        sys.exit(f"lab: no hay ningún programa «{pedido}»; los más parecidos: {', '.join(parecidos)}")
    return elegidos


def casos(programas, pedido):
    hay = [c for p in programas for c in p.casos if not p.consola and pedido in (p.nombre, c.fichero)]
    if not hay:
        nombre = pedido.split("-")[0]
        resuelve(programas, nombre)
        sys.exit(f"lab: «{pedido}» no es un caso de {nombre}")
    return hay


def elegidos(programas, pedidos):
    """Los casos que se nombran, o todos."""
    return [c for pedido in pedidos for c in casos(programas, pedido)] or [
        c for p in programas if not p.consola for c in p.casos
    ]


def main():
    build, orden, *resto = sys.argv[1:]
    if orden == "escribe":
        return escribe_todo(Path(*resto), Path(build))
    programas = lee_programas(build)
    if orden == "lista":
        formato = "{}\t{}\t{}\t{}" if resto == ["--tsv"] else "{:<22} {:<22} {:<14} {}"
        for p in programas:
            print(formato.format(p.capitulo.nombre, p.nombre, p.ref, p.titulo))
    elif orden == "resuelve":
        for p in resuelve(programas, *resto):
            print(p.capitulo.nombre, p.nombre, "texto" if p.consola else "imagen", p.titulo, sep="\t")
    elif orden == "casos":
        for caso in elegidos(programas, resto):
            print(caso.programa.nombre, caso.nombre)
    elif orden == "cumple":
        for caso in elegidos(programas, resto):
            print(caso.programa.capitulo.nombre, caso.programa.nombre, caso.fichero, *caso.cumple, sep="\t")


if __name__ == "__main__":
    principal(main)
