"""El árbol que ve una entrega, y el programa compilado con ella dentro."""
import functools
import re
import shutil
from pathlib import Path, PurePath, PureWindowsPath

from base import compilacion, llamadas
from base.fuentes import SHADERS
from ejercicios import nuevo
from ejercicios.corrige.entrega import Alcance, Rechazo
from ejercicios.corrige.jaula import NO_ACABA, desempaqueta
from ejercicios.corrige.partidas import Jugador

COMPILA = {"segundos": 120, "procesador": 60, "memoria": 3 << 30, "procesos": 16}
SUYA = "mios/entrega"  # dónde está lo suyo en el árbol que ve: tan hondo como lo de ./lab nuevo
CAIDAS = Path(__file__).with_name("caidas.cpp")
# con lo entregado: un índice que se sale de un vector acaba con él, y se sabe en qué línea
AJENO = "-D_GLIBCXX_ASSERTIONS", "-g"
# de la orden de compilar, cuántas palabras no valen aquí
SIN = {"-MD": 1, "-MT": 2, "-MF": 2, "-o": 2, "-c": 2, "-Werror": 1}


def arbol_visible(raiz, programa, ref):
    """Lo que ve una entrega del laboratorio, además de common/: cabeceras, shaders y modelos, sin los ficheros de la
    solución."""
    patrones = (
        *(f"{donde}/*{tipo}" for donde in ("common", "common/encima", "ch*") for tipo in (".h", *SHADERS)),
        "assets/*.vf",
        "assets/*.txt",
    )
    privados = set(nuevo.privados(raiz, programa, ref))
    rutas = [f.relative_to(raiz) for patron in patrones for f in sorted(raiz.glob(patron))]
    return [ruta for ruta in rutas if ruta not in privados]


class Compilador:
    def __init__(self, raiz, build, programa, ref, recinto):
        self.raiz, self.build, self.programa, self.recinto = raiz, build, programa, recinto
        self.visible = arbol_visible(raiz, programa, ref)
        self.privados = nuevo.privados(raiz, programa, ref)
        self.solucion = Jugador("la solución", programa.ejecutable(build), programa.raices)

    def en_arbol(self, ficheros, carpeta):
        """El árbol que ve una entrega, con ella dentro. Devuelve dónde están sus fuentes."""
        for ruta in self.visible:
            (carpeta / ruta).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(self.raiz / ruta, carpeta / ruta)
        suya = carpeta / SUYA
        suya.mkdir(parents=True)
        for nombre, contenido in ficheros.items():
            (suya / nombre).parent.mkdir(parents=True, exist_ok=True)
            (suya / nombre).write_bytes(contenido if isinstance(contenido, bytes) else contenido.encode())
        return suya

    @functools.cached_property
    def opciones(self):
        """Con qué palabras se compila el programa del ejercicio, sin sus ficheros."""
        palabras = iter(compilacion.compila(self.build, self.raiz / self.programa.fuente))
        quedan = []
        for palabra in palabras:
            if palabra not in SIN:
                quedan.append(palabra)
            for _ in range(SIN.get(palabra, 1) - 1):
                next(palabras)
        return quedan

    @functools.cached_property
    def bibliotecas(self):
        """Con cuáles se enlaza; las de BUILD, con su ruta."""
        palabras = compilacion.enlaza(self.build, self.solucion.programa)
        tras_el_nombre = palabras[palabras.index("-o") + 2 :]
        return [
            str(self.build / p) if (self.build / p).is_file() and not p.startswith("/") else p
            for p in tras_el_nombre
            if not p.endswith(".o") or "controles_" in p  # lo que F1 dice del ejercicio
        ]

    @functools.cached_property
    def ve(self):
        """Lo que de BUILD hace falta para compilarlo y para jugarlo."""
        rutas = [p for p in self.bibliotecas if p.startswith(str(self.build))] + [self.build / "assets"]
        if "-include" in self.opciones:
            rutas.append(Path(self.opciones[self.opciones.index("-include") + 1]).parent)
        return list(dict.fromkeys(map(str, rutas)))

    def compila(self, ficheros, carpeta, ajena=True, intentos=()):
        """El programa de esos ficheros, compilado en esa carpeta: los fuentes del primer intento que compile, o todos
        los que no incluya otro. Si con ninguno, Rechazo con el error del primero."""
        carpeta.mkdir(exist_ok=True)
        arbol = carpeta / "fuentes"
        suya = self.en_arbol(ficheros, arbol)
        sitios = list(dict.fromkeys([suya, *((suya / nombre).parent for nombre in ficheros)]))
        ve = [carpeta, *self.ve]
        ejecuta = functools.partial(self.recinto.ajeno, ve=ve) if ajena else self.recinto.propio
        errores = []
        for fuentes in intentos or [Alcance(ficheros).se_compilan]:
            orden = self.orden(arbol, sitios, [suya / f for f in fuentes])
            if ajena:
                shutil.copy(CAIDAS, arbol)
                orden += [*AJENO, "-x", "c++", arbol / CAIDAS.name]
            hecho = desempaqueta(ejecuta(orden, COMPILA))
            if hecho.get("estado", b"").strip() == b"0":
                ejecutable = carpeta / self.programa.nombre
                ejecutable.write_bytes(hecho["programa"])
                ejecutable.chmod(0o755)
                return Jugador("la entrega", ejecutable, [*sitios, arbol], ajeno=ajena, fuentes=fuentes)
            todo = hecho.get("errores", b"").decode(errors="replace")
            errores.append(Rechazo(primer_error(hecho, suya, ficheros), todo))
            if no_acaba(hecho):
                break
        raise errores[0]

    def linea_en_que_cae(self, ficheros, jugador, escrito):
        """De lo que ha escrito caidas.cpp, la primera línea que es de lo suyo, o nada."""
        llamadas = re.findall(rf"/{re.escape(jugador.programa.name)}\(\+0x([0-9a-f]{{1,16}})\)\[", escrito)
        pasos = [f"0x{max(int(paso, 16) - 1, 0):x}" for paso in llamadas]  # se vuelve a la de después
        if not pasos or not shutil.which("addr2line"):
            return ""
        dicho = self.en_su_ejecutable(["addr2line", "-i", "-e", jugador.programa, *pasos], jugador)
        lineas = re.findall(rf"^{re.escape(self.suya(jugador))}(.+):(\d+)", dicho, re.M)
        return next((f"{f}:{linea}" for f, linea in lineas if f in ficheros), "")

    def linea_de_una_llamada(self, ficheros, jugador, pila):
        """La de lo suyo desde la que se llama a OpenGL, con las funciones en que está, o nada."""
        if not jugador.fuentes or not pila["llamadas"] or not shutil.which("addr2line"):
            return ""
        suya = self.suya(jugador)
        dicho = self.en_su_ejecutable(llamadas.pregunta(jugador.programa, [pila]), jugador)
        [sitio] = llamadas.sitios([pila], dicho, lambda ruta: ruta.removeprefix(suya) in ficheros)
        return sitio["dice"] if sitio else ""

    @staticmethod
    def suya(jugador):
        return f"{jugador.raices[-1] / SUYA}/"

    def en_su_ejecutable(self, orden, jugador):
        """Lo que escribe esa orden, que lo lee, encerrada como él."""
        salida = desempaqueta(self.recinto.ajeno(orden, COMPILA, [jugador.programa.parent])).get("salida", b"")
        return salida.decode(errors="replace")

    def avisos(self, ficheros, jugador):
        """De lo que avisa el compilador en los ficheros de una entrega ya compilada."""
        *sitios, arbol = jugador.raices
        suya = arbol / SUYA
        orden = self.orden(arbol, sitios, [suya / f for f in jugador.fuentes])
        orden = ["-fsyntax-only" if p == "-w" else p for p in orden] + ["-Wall", "-Wextra"]
        errores = desempaqueta(self.recinto.ajeno(orden, COMPILA, [arbol.parent, *self.ve])).get("errores", b"")
        # lo que sobra, al final
        hay = re.findall(r"^(.+?):(\d+):\d+: warning: (.*?)(?: \[-W.*)?$", errores.decode(errors="replace"), re.M)
        lugares = {str(suya / f): f for f in ficheros}
        return [
            f"{lugares[f]}:{linea}: {dice}"
            for f, linea, dice in sorted(dict.fromkeys(hay), key=lambda a: "unused" in a[2])
            if f in lugares
        ]

    def orden(self, arbol, sitios, fuentes):
        """Con qué palabras se compilan y se enlazan esos fuentes."""
        raiz = re.compile(re.escape(str(self.raiz)) + r"(?=$|/(?!build))")  # la de los fuentes, no la de BUILD
        orden = [
            raiz.sub(str(arbol), p) if p.startswith("-I") and not p[2:].startswith(str(self.build)) else p
            for p in self.opciones
        ]
        for sitio in (*sitios, arbol / self.programa.capitulo.nombre):
            orden += ["-I", sitio]
        orden += ["-w", "-fdiagnostics-color=never", "-x", "c++", *fuentes, "-x", "none"]
        return [*orden, "-o", "programa", *self.bibliotecas]


SITIO = re.compile(r"^(In file included from | +from )?([^:\n]+):(\d+)[:,](?:\d+[:,])?(.*)$", re.M)
REPETIDO = re.compile(
    r"^(?:\S*ld: )?(?:\S+\.o:)?([^:\n]+):(?:\(.*|\d+: )multiple definition of [`'](.*?)'; (?:\S+\.o:)?([^:\n]+):[(\d]",
    re.M,
)
DE_OPENGL_1 = re.compile("glut(Solid|Wire|Bitmap|Stroke)|glu[A-Z]")
ERROR = re.compile(r"^ (?:fatal )?error: (.*)$")


DE_IMPRENTA = dict.fromkeys("“”‘’", "comillas de imprenta") | dict.fromkeys("–—−", "un guion que no es el menos")
DE_IMPRENTA |= {"\u00a0": "un espacio que no es el del teclado"}


def con_lo_que_es(error, ficheros):
    """De un #include que no está, el que sí y en Windows valdría; de una letra que no vale, cuál: a veces ni se ve."""
    falta = error.removesuffix(": No such file or directory")
    hay = [f for f in ficheros if falta != error and PurePath(f).name.lower() == PureWindowsPath(falta).name.lower()]
    if hay:
        return f"no está «{falta}», y sí «{hay[0]}»: cuentan las mayúsculas, y las carpetas van con /"
    letra = re.search(r"extended character (.) is not valid", error)
    if not letra:
        return error
    que = DE_IMPRENTA.get(letra[1], "una letra que no vale")
    return f"hay {que}, «{letra[1]}» (U+{ord(letra[1]):04X}), fuera de los comentarios: bórralo y escríbelo otra vez"


def no_acaba(hecho):
    return int(hecho.get("estado", b"").strip() or -1) in NO_ACABA


def primer_error(hecho, suya, ficheros):
    """Lo primero de lo que se queja el compilador, y dónde de lo suyo, sin la ruta de la carpeta en que compila."""
    if no_acaba(hecho):
        return f"no compila: el compilador no acaba en {COMPILA['procesador']} s"
    errores = hecho.get("errores", b"")[: 1 << 20].decode(errors="replace")
    for carpeta in (suya, suya.parent.parent, suya.parent.parent.parent):
        errores = errores.replace(f"{carpeta}/", "")
    lugar = ""
    for desde, fichero, linea, dice in SITIO.findall(errores):
        if desde.startswith("In"):
            lugar = ""
        if fichero in ficheros and not (desde and lugar):
            lugar = f"{fichero}:{linea}: "
        if error := ERROR.match(dice):  # el de una plantilla está en su cabecera, y antes se dice quién la usa
            return f"no compila: {lugar or f'{fichero}:{linea}: '}{con_lo_que_es(error[1], ficheros)}"
    if repetido := REPETIDO.search(errores):
        return f"no compila: «{repetido[2]}» está en dos ficheros: {repetido[3]} y {repetido[1]}"
    if falta := re.search(r"undefined reference to [`'](.*)'", errores):
        de_antes = ": es de OpenGL 1, y aquí no está" if DE_OPENGL_1.match(falta[1]) else ""
        return f"no compila: falta «{falta[1]}»{de_antes}"
    lineas = [linea for linea in errores.splitlines() if linea.strip()]
    primera = next((linea for linea in lineas if "error: " in linea.lower() or "ld: " in linea), (lineas or [""])[-1])
    return "no compila: " + (re.sub("(?i)^.*?error: ", "", primera) or "el compilador no ha acabado bien")
