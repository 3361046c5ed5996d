"""Los ejercicios de quien enseña. Cada uno es una carpeta, ejercicios/NOMBRE o la que se diga por su ruta, con su
solución, NOMBRE.cpp, marcada como los programas del laboratorio (base/marcas.py); los ficheros que usa; ENUNCIADO.md;
y, si acaso, casos.txt, errores.tsv y reglas.txt (docs/ejercicios.md). Para lo demás es un programa del catálogo.
"""
import re
from dataclasses import dataclass
from pathlib import Path

from base import catalogo, fuentes
from base.procesos import Fallo, escribe

EJERCICIO = "ejercicio.txt"  # lo tiene la carpeta de quien aprende; la de un ejercicio, no
CARPETA = "ejercicios"
APUNTADOS = "propios.txt"  # en BUILD, las carpetas que no están ahí: lo lee lee_propios (cmake/programa.cmake)
ENUNCIADO, CASOS, ERRORES = "ENUNCIADO.md", "casos.txt", "errores.tsv"
VENTANA = 960, 720  # la que abre ./lab ver: de ella son las posiciones del ratón de los casos
EN_VENTANA = "escala {} {}; ".format(*VENTANA)
POSICION = re.compile(r"\b(?:mueve|arrastra|boton \S+ \S+|rueda \S+) +(-?\d+) +(-?\d+)")
DADOS = ".cpp", ".h", *fuentes.SHADERS, ".vf"


@dataclass
class Propio(catalogo.Programa):
    carpeta: Path = None

    @property
    def raices(self):
        return [self.carpeta]

    @property
    def objetivo(self):
        return f"propio_{self.nombre}"

    def ficheros(self, raiz):
        """Todos los suyos: a su carpeta no llega nadie más."""
        return sorted(f for f in self.carpeta.iterdir() if f.suffix in DADOS)

    def es(self, pedido):
        return pedido == self.nombre


def lee_texto(fichero):
    try:
        return fichero.read_text()
    except UnicodeDecodeError:
        raise Fallo(f"{fichero} no está en UTF-8: guárdalo así en el editor") from None


def renglones(fichero):
    """(número, texto) de los que dicen algo: los que no son comentarios, que empiezan por #."""
    texto = lee_texto(fichero) if fichero.is_file() else ""
    return [(n, r.strip()) for n, r in enumerate(texto.splitlines(), 1) if r.strip() and not r.lstrip().startswith("#")]


def lee_casos(programa):
    """«Girada: tecla a; tecla d»: cómo se llama y su guion. Sin ninguno, cómo se ve al abrirlo."""
    casos = []
    for n, renglon in renglones(programa.carpeta / CASOS):
        titulo, dos, guion = (parte.strip() for parte in renglon.partition(":"))
        if not dos or not titulo or any(c.nombre == titulo for c in casos):
            raise Fallo(f"{programa.carpeta / CASOS}:{n}: es «nombre: guion», y cada nombre, una vez")
        puntos = [tuple(map(int, punto)) for punto in POSICION.findall(guion)]
        if puntos and "escala" not in guion:
            fuera = [p for p in puntos if not (0 <= p[0] < VENTANA[0] and 0 <= p[1] < VENTANA[1])]
            if fuera:
                raise Fallo(f"{programa.carpeta / CASOS}:{n}: {fuera[0]} cae fuera de la ventana, que mide 960×720")
            guion = EN_VENTANA + guion
        casos.append(catalogo.Caso(programa, titulo, programa.nombre, titulo, guion))
    return casos or [catalogo.Caso(programa, "base", programa.nombre)]


def propio(carpeta):
    nombre, enunciado = carpeta.name, carpeta / ENUNCIADO
    titulo = re.search(r"^# +(.+?)\s*$", lee_texto(enunciado), re.M) if enunciado.is_file() else None
    capitulo = catalogo.Capitulo(f"{CARPETA}/{nombre}", "Ejercicios propios")
    programa = Propio(capitulo, nombre, nombre, titulo[1] if titulo else nombre, carpeta=carpeta)
    programa.casos = lee_casos(programa)
    for f in programa.ficheros(carpeta):
        lee_texto(f)
    return programa


def es_ejercicio(carpeta):
    return (carpeta / f"{carpeta.name}.cpp").is_file() and not (carpeta / EJERCICIO).exists()


def apuntadas(build):
    fichero = build / APUNTADOS
    return [Path(r) for r in fichero.read_text().splitlines()] if fichero.is_file() else []


def carpetas(raiz, build):
    """Las de ejercicios/ y las apuntadas, por su nombre."""
    hay = {c.name: c for c in reversed([*sorted((raiz / CARPETA).glob("*")), *apuntadas(build)]) if es_ejercicio(c)}
    return dict(reversed(hay.items()))


def lee(raiz, build, pedido=""):
    """Los que se pueden leer: uno a medio hacer no estorba, si no es el que se pide."""
    hay = []
    for nombre, carpeta in carpetas(raiz, build).items():
        try:
            if re.fullmatch("[a-z0-9_]+", nombre):
                hay.append(propio(carpeta))
        except (Fallo, OSError):
            if nombre == pedido:
                raise
    return hay


def los_de_aqui(raiz, build):
    """Los de ejercicios/, que salen en la página."""
    return [p for p in lee(raiz, build) if p.carpeta.parent == raiz / CARPETA]


def comprueba_nombre(raiz, carpeta, programas):
    nombre = carpeta.name
    if (carpeta / EJERCICIO).exists():
        raise Fallo(f"{carpeta} es de quien aprende, que tiene {EJERCICIO}, y no un ejercicio")
    if not re.fullmatch("[a-z0-9_]+", nombre):
        raise Fallo(f"«{nombre}» no vale de nombre de ejercicio: solo minúsculas sin acento, cifras y _")
    if not (carpeta / f"{nombre}.cpp").is_file():
        raise Fallo(f"{carpeta} no es un ejercicio: falta {nombre}.cpp, su solución")
    if any(p.nombre == nombre for p in programas):
        raise Fallo(f"ya hay un programa que se llama «{nombre}»: ponle otro nombre a {carpeta}")
    if re.search(r'[\n;:"\\#\[\]]', str(carpeta)):
        raise Fallo(f'CMake no sabe trabajar en una carpeta con ; : " \\ # [ ] en su ruta: {carpeta}')
    if (otra := raiz / CARPETA / nombre) != carpeta and es_ejercicio(otra):
        raise Fallo(f"ya hay un ejercicio «{nombre}» en {CARPETA}/: ponle otro nombre a {carpeta}")


def busca(raiz, build, pedido, programas):
    """De lo que se pide, si es un ejercicio propio, su nombre; el que no está en ejercicios/ se apunta."""
    if any(p.es(pedido) for p in programas):
        return ""
    es_ruta = "/" in pedido or pedido in (".", "..")
    sitios = (Path(pedido), raiz / pedido) if es_ruta else (raiz / CARPETA / pedido,)
    carpeta = next((s.resolve() for s in sitios if s.is_dir()), None)
    if not carpeta:
        if es_ruta:
            raise Fallo(f"no hay ninguna carpeta «{pedido}»")
        return pedido if pedido in carpetas(raiz, build) else ""
    comprueba_nombre(raiz, carpeta, programas)
    if carpeta.parent != raiz / CARPETA and carpeta not in apuntadas(build):
        otras = [c for c in apuntadas(build) if c.name != carpeta.name]
        escribe(build / APUNTADOS, "".join(f"{c}\n" for c in (*otras, carpeta)))
    return carpeta.name


def resuelve(raiz, build, pedido):
    """Los programas que hay, también los propios, y lo que se pide, de un propio su nombre."""
    programas = catalogo.lee_programas(build)
    nombre = busca(raiz, build, pedido, programas) if pedido else ""
    return [*programas, *lee(raiz, build, nombre)], nombre or pedido
