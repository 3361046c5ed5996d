"""El catálogo: los capítulos, con sus programas, con sus casos. Lo escribe CMake (herramientas/cmake/programa.cmake)
en BUILD/catalogo.json y solo se lee aquí.

catalogo.py BUILD lista [--tsv]   capítulo, programa, referencia y título
catalogo.py BUILD resuelve QUÉ    los programas de que se habla (su nombre, L1.2, E3.5, F3.3, ch05): capítulo, programa,
                                  imagen o texto, y título, entre tabuladores
catalogo.py BUILD casos QUÉ…      de cada caso que se nombra (grua, grua-girada), su programa y su nombre
"""
import difflib
import json
import re
import sys
from dataclasses import dataclass, field
from pathlib import Path

from base.procesos import principal


@dataclass
class Caso:
    programa: "Programa" = field(repr=False)
    nombre: str
    fichero: str  # el de su imagen, sin extensión
    titulo: str = ""  # cómo se enseña: el NOMBRE de su caso(…)
    guion: str = ""
    tolerancia: str = ""
    otro: str = ""
    mira: str = ""
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


def main():
    build, orden, *resto = sys.argv[1:]
    programas = lee_programas(build)
    if orden == "lista":
        formato = "{}\t{}\t{}\t{}" if resto == ["--tsv"] else "{:<22} {:<22} {:<14} {}"
        for p in programas:
            print(formato.format(p.capitulo.nombre, p.nombre, p.ref, p.titulo))
    elif orden == "resuelve":
        for p in resuelve(programas, *resto):
            print(p.capitulo.nombre, p.nombre, "texto" if p.consola else "imagen", p.titulo, sep="\t")
    elif orden == "casos":
        todos = [c for p in programas if not p.consola for c in p.casos]
        for caso in [c for pedido in resto for c in casos(programas, pedido)] or todos:
            print(caso.programa.nombre, caso.nombre)


if __name__ == "__main__":
    principal(main)
