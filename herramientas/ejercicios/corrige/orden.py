#!/usr/bin/env python3
"""corrige.py RAÍZ BUILD ENTREGA [EJERCICIO] [opciones]: corrige lo que ha hecho un estudiante, o una clase entera.

ENTREGA es mios/NOMBRE, o una carpeta con lo mismo dentro; si dentro hay carpetas y ningún .cpp, es una clase, y cada una, una entrega. Lo
entregado y la solución juegan los mismos guiones, los casos del ejercicio y otros al azar con los controles de su programa, y tras cada
orden se comparan las imágenes y los títulos. El guion que falla se acorta y, si algún defecto plantado en la solución (tests/mutantes)
deja en todos los guiones lo que deja la entrega, se dice cuál.

Lo entregado no es de fiar: se lee con cuidado, se compila y se ejecuta en una jaula (bwrap), y de ella solo sale un tar que se lee hasta un
límite. Cada entrega es un JSON, entero o nada, y de los JSON salen la página y la tabla: lo que ya está corregido no se corrige otra vez.
"""
import argparse
import base64
import csv
import functools
import hashlib
import io
import itertools
import json
import os
import random
import re
import shlex
import shutil
import stat
import subprocess
import sys
import tarfile
import tempfile
import threading
import time
import zlib
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path
from xml.sax.saxutils import quoteattr

import catalogo
import controles
import ejercicios as marcas
import muta
import nuevo
import pagina
import procesos
from procesos import Fallo, ejecuta, en_png, escribe, lanza, motivo, principal

TALLA = 240, 180
TALLAS = "320 180", "180 180", "120 160", "240 180"
GUIONES, LARGO = 24, 10  # al azar, y órdenes de cada uno, al menos
VECES = 1, 1, 1, 2, 5, 30  # que se repite una tecla: a veces, hasta sus límites
MUESTRA = 3  # guiones que fallan, con sus imágenes
INTENTOS = 24  # para acortar un guion
CUELGUES = 2  # tras los que no se juega más
VIEJA = 86400  # segundos que se guarda lo jugado por otra versión

FUENTES = ".cpp", ".h", ".vert", ".frag", ".glsl"
FICHEROS, BYTES = 40, 1 << 20  # de una entrega, y de cada fichero
SALE = 96 << 20  # bytes que se leen de una jaula
NADIE = range(61184, 65520)  # de root no valen los límites: se ejecuta como uno de estos, que no son nadie
COMPILA = {"segundos": 120, "procesador": 60, "memoria": 3 << 30, "procesos": 16}
JUEGA = {"segundos": 30, "procesador": 10, "memoria": 1 << 30, "procesos": 8}
DISCO = 64 << 20  # de la carpeta temporal, que está en memoria

# Lo que se ejecuta en la jaula: SEGUNDOS ORDEN…; lo que deja sale en un tar. Los shaders ya compilados, de LAB_SHADERS, se copian: así lo ajeno
# no los estropea, y cada vez se ahorra tres cuartos de lo que tarda.
ENCIERRA = """segundos=$1; shift
[ ! -d "$LAB_SHADERS" ] || cp -r "$LAB_SHADERS" shaders
timeout -k 1 "$segundos" "$@" >salida 2>errores
echo $? >estado
exec tar -cf - --exclude=./shaders ."""
SENALES = {132: "instrucción ilegal", 134: "abort", 135: "memoria mal alineada", 136: "división por cero", 139: "acceso a memoria que no es suya"}
NO_ACABA = 124, 137, 152  # timeout, timeout -k y el límite de procesador


class Rechazo(Exception):
    """Por qué no se puede ni probar una entrega."""


# --- lo entregado -----------------------------------------------------------------------------------------------------


def lee_fichero(carpeta, nombre):
    """Un fichero corriente y corto de otro: ni enlaces, ni tuberías, ni dispositivos."""
    try:
        f = os.open(nombre, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC, dir_fd=carpeta)
    except OSError as error:
        raise Rechazo(f"no se puede leer «{nombre}»: es un enlace o no hay permiso" if error.errno else str(error)) from None
    with open(f, "rb") as fichero:
        if not stat.S_ISREG(os.fstat(f).st_mode):
            raise Rechazo(f"«{nombre}» no es un fichero corriente")
        datos = fichero.read(BYTES + 1)
    if len(datos) > BYTES:
        raise Rechazo(f"«{nombre}» pasa de {BYTES >> 20} MiB")
    return datos


def lee_entrega(carpeta):
    """{nombre: contenido} de los fuentes de una entrega; lo demás que haya en su carpeta no se mira."""
    try:
        f = os.open(carpeta, os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW | os.O_CLOEXEC)
    except OSError:
        raise Rechazo("no es una carpeta que se pueda leer") from None
    try:
        with os.scandir(f) as hay:
            nombres = sorted(e.name for e in itertools.islice(hay, 1000) if re.fullmatch(r"\w[\w.-]*", e.name, re.A) and e.name.endswith(FUENTES))
        if len(nombres) > FICHEROS:
            raise Rechazo(f"son más de {FICHEROS} ficheros")
        ficheros = {nombre: lee_fichero(f, nombre) for nombre in nombres}
    finally:
        os.close(f)
    if not any(nombre.endswith(".cpp") for nombre in ficheros):
        raise Rechazo("no hay ningún .cpp")
    return ficheros


# --- la jaula ---------------------------------------------------------------------------------------------------------


class Jaula:
    """Donde se ejecuta lo que no es de fiar: sin red, sin más ficheros que los que se le dan y con límites."""

    def __init__(self, raiz):
        self.raiz = raiz
        sistema = ["/usr", "/etc/alternatives", "/etc/ld.so.cache"]
        self.root = os.geteuid() == 0
        aparte = [f"--unshare-{que}" for que in ("ipc", "pid", "net", "uts", "cgroup-try")] if self.root else ["--unshare-all"]
        self.prefijo = ["bwrap", *aparte, "--die-with-parent", "--new-session", "--proc", "/proc", "--dev", "/dev", "--dir", "/etc"]
        for carpeta in map(Path, ("/bin", "/lib", "/lib32", "/lib64", "/libx32")):
            if carpeta.is_symlink():
                self.prefijo += ["--symlink", os.readlink(carpeta), carpeta]
            elif carpeta.is_dir():
                sistema.append(str(carpeta))
        for que in sistema:
            self.prefijo += ["--ro-bind-try", que, que]
        if raiz.is_relative_to("/usr"):  # el laboratorio no es del sistema
            self.prefijo += ["--tmpfs", raiz]
        self.prefijo += ["--perms", "1777", "--size", DISCO, "--tmpfs", "/trabajo", "--chdir", "/trabajo"]

    def comprueba(self):
        try:
            prueba = lanza([*self.orden([]), "true"], text=True)
            dice = prueba.stderr.strip() if prueba.returncode else ""
        except Fallo as fallo:
            dice = str(fallo)
        if dice:
            raise Fallo(f"no se puede encerrar lo que no es de fiar: {dice.splitlines()[0]}. Con --sin-jaula se corrige sin encerrarlo, "
                        "si la máquina es para eso o lo entregado es tuyo")

    def orden(self, ve):
        quien = random.SystemRandom().choice(NADIE)
        otro = ["setpriv", f"--reuid={quien}", f"--regid={quien}", "--clear-groups", "--bounding-set=-all", "--inh-caps=-all", "--no-new-privs", "--"]
        padres = dict.fromkeys(str(p) for que in ve for p in list(Path(que).parents)[-2::-1])  # las que hace bwrap solo las ve su dueño
        monta = [*(p for que in padres for p in ("--dir", que)), *(p for que in ve for p in ("--ro-bind", que, que))]
        # sin ser root, lo que bwrap hace para montar es de quien lo ejecuta, y podría llenar la memoria
        return [*self.prefijo, *monta, "--remount-ro", "/dev", "--remount-ro", "/", "--", *(otro if self.root else [])]


def desempaqueta(datos):
    """Los ficheros corrientes de un tar que ha podido escribir cualquiera, hasta donde se pueda leer."""
    ficheros = {}
    try:
        with tarfile.open(fileobj=io.BytesIO(datos), mode="r|") as tar:
            for miembro in tar:
                nombre = miembro.name.removeprefix("./")
                if miembro.isreg() and not miembro.issparse() and re.fullmatch(r"estado|salida|errores|programa|\d{3}\.ppm", nombre):
                    ficheros.setdefault(nombre, tar.extractfile(miembro).read())
    except Exception:  # pylint: disable=broad-except  # está cortado o estropeado, y puede ser de cualquier manera
        pass
    return ficheros


def lee_ppm(datos):
    """(ancho, alto, píxeles) de un PPM como los que guarda un programa, o None."""
    cabecera = re.match(rb"P6\n((?:#[^\n]{0,1000}\n)*)([1-9]\d{0,3}) ([1-9]\d{0,3})\n255\n", datos)
    if not cabecera:
        return None
    ancho, alto, pixeles = int(cabecera[2]), int(cabecera[3]), datos[cabecera.end():]
    return (ancho, alto, pixeles) if len(pixeles) == 3 * ancho * alto else None


# --- guiones y partidas -----------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Guion:
    nombre: str
    ordenes: tuple
    caso: bool = False

    @property
    def texto(self):
        """Con una captura al empezar y otra tras cada orden."""
        capturas = [f"captura {i:03}.ppm" for i in range(len(self.ordenes) + 1)]
        return "; ".join([capturas[0], *(p for par in zip(self.ordenes, capturas[1:]) for p in par)])


@dataclass
class Partida:
    """Lo que ha dado un programa con un guion: una imagen al empezar y otra tras cada orden, si ha llegado."""
    imagenes: list
    titulos: list
    texto: str
    estado: int
    errores: str

    @classmethod
    def lee(cls, datos, guion):
        ficheros = desempaqueta(datos)
        imagenes = []
        for i in range(len(guion.ordenes) + 1):
            imagen = lee_ppm(ficheros.get(f"{i:03}.ppm", b""))
            if not imagen:
                break
            imagenes.append(imagen)
        lineas = ficheros.get("salida", b"")[:1 << 16].decode(errors="replace").splitlines()
        titulos = [linea.replace("-0°", "0°") for linea in lineas if linea.startswith("título: ")]
        estado = ficheros.get("estado", b"").strip()
        return cls(imagenes, [t for t, _ in itertools.groupby(titulos)], "\n".join(ll.rstrip() for ll in lineas if not ll.startswith("título: ")),
                   int(estado) if estado.isdigit() else -1, ficheros.get("errores", b"")[:4000].decode(errors="replace"))

    @property
    def cuelga(self):
        return self.estado in NO_ACABA


def repite(azar, suceso):
    """Una tecla, a veces muchas veces."""
    veces = azar.choice(VECES)
    return [f"{suceso[0]} ×{veces}"] if veces > 1 and len(suceso) == 1 and suceso[0].startswith(("tecla", "especial")) else suceso


def guiones_al_azar(clave, n, mandos, sucesos):
    """n guiones con sucesos(azar); entre todos empiezan por todos los mandos."""
    for i in range(n):
        azar = random.Random(f"{clave} {i}")
        ordenes = repite(azar, [mandos[i % len(mandos)]]) if mandos else []
        while len(ordenes) < LARGO:
            ordenes += repite(azar, sucesos(azar))
        if i % 2:
            ordenes.insert(azar.randint(1, LARGO), f"tamano {azar.choice(TALLAS)}")
        yield Guion(f"al azar {i + 1}", tuple(ordenes))


def acorta(ordenes, falla, intentos=INTENTOS):
    """Las menos órdenes con las que aún falla(ordenes), que con todas falla (delta debugging); después, repetidas menos veces."""
    def prueba(candidatas):
        nonlocal intentos
        intentos -= 1
        return intentos >= 0 and falla(candidatas)

    ordenes = tuple(ordenes)
    if len(ordenes) > 1 and prueba(ordenes[-1:]):  # casi siempre basta la última
        ordenes = ordenes[-1:]
    trozos = 2
    while len(ordenes) > 1 and intentos > 0:
        largo = -(-len(ordenes) // trozos)
        quitadas = (ordenes[:i] + ordenes[i + largo:] for i in range(0, len(ordenes), largo))
        menos = next((q for q in quitadas if prueba(q)), None)
        if menos is not None:
            ordenes, trozos = menos, max(trozos - 1, 2)
        elif largo == 1:
            break
        else:
            trozos = min(2 * trozos, len(ordenes))
    for i, orden in enumerate(ordenes):
        una, por, n = orden.rpartition(" ×")
        for veces in sorted({1, 2, int(n) // 4, int(n) // 2} - {0, int(n)}) if por and n.isdigit() else ():
            candidatas = (*ordenes[:i], f"{una} ×{veces}" if veces > 1 else una, *ordenes[i + 1:])
            if prueba(candidatas):
                ordenes = candidatas
                break
    return ordenes


# --- el banco: todo lo que hace falta para un ejercicio -----------------------------------------------------------------


@dataclass
class Variante:
    """Un programa que juega: la solución, la entrega, un mutante."""
    nombre: str
    programa: Path
    raices: list  # dónde busca sus ficheros, antes que en el laboratorio
    entorno: dict = field(default_factory=dict)
    ajena: bool = False


class Banco:
    def __init__(self, raiz, build, ref, programa, temporal, jaula, semilla, n):
        self.raiz, self.build, self.ref, self.temporal, self.jaula, self.semilla = raiz, build, ref, temporal, jaula, semilla
        self.programa = programa
        self.carpeta = programa.capitulo.nombre
        self.entorno = procesos.entorno(raiz / "tests")
        del self.entorno["MESA_SHADER_CACHE_DISABLE"]
        self.entorno |= {"LP_NUM_THREADS": "0", "LANG": "C.UTF-8", "PATH": "/usr/bin:/bin"}
        self.solucion = Variante("la solución", self.programa.ejecutable(build), [])
        self.visible = self.arbol_visible()
        ficheros = sorted(nuevo.de_la_carpeta(raiz, programa, ref).items())
        self.version = suma(Path(__file__).read_bytes(), repr(ficheros), repr(self.mutantes()), *((raiz / ruta).read_bytes() for ruta in self.visible))
        self.todos = [*self.casos(), *self.al_azar(n)]
        self.turno, self.iguales_ya, self.mutantes_hechos = threading.Lock(), {}, None
        self.cache = temporal
        primera = desempaqueta(self.juega_de_nuevo(self.solucion, Guion("", ()))).get("000.ppm", b"")  # con el sello de quién dibuja
        self.cache = self.elige_cache(suma(self.version, self.solucion.programa.read_bytes(), primera))

    def elige_cache(self, clave):
        """Donde se guardan las partidas de la solución y de los mutantes; las de antes se borran. Si no se puede escribir, no duran."""
        cache = self.build / "corrige" / self.ref / clave
        try:
            cache.mkdir(parents=True, exist_ok=True)
            for vieja in set(cache.parent.iterdir()) - {cache}:
                if time.time() - vieja.stat().st_mtime > VIEJA:  # si no, puede estar usándola otro
                    shutil.rmtree(vieja, ignore_errors=True)
        except OSError:
            cache = self.temporal / "cache"
            cache.mkdir()
        return cache

    # --- lo que se ve y con qué se compila ---

    def arbol_visible(self):
        """Lo que ve una entrega del laboratorio, además de common/: cabeceras, shaders y modelos, sin los ficheros de la solución."""
        patrones = *(f"{donde}/*{tipo}" for donde in ("common", "ch*") for tipo in (".h", *muta.SHADERS)), "assets/*.vf", "assets/*.txt"
        privados = set(nuevo.privados(self.raiz, self.programa, self.ref))
        return [ruta for patron in patrones for f in sorted(self.raiz.glob(patron)) if (ruta := f.relative_to(self.raiz)) not in privados]

    def en_arbol(self, ficheros, carpeta):
        """El árbol que ve una entrega, con ella dentro. Devuelve dónde están sus fuentes."""
        for ruta in self.visible:
            (carpeta / ruta).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(self.raiz / ruta, carpeta / ruta)
        suya = carpeta / "mios"
        suya.mkdir()
        for nombre, contenido in ficheros.items():
            (suya / nombre).write_bytes(contenido if isinstance(contenido, bytes) else contenido.encode())
        return suya

    @functools.cached_property
    def compilador(self):
        """Con qué palabras se compila y se enlaza el programa del ejercicio, sin sus ficheros; y qué ve de BUILD."""
        def palabras(objetivo):
            dice = ejecuta(["ninja", "-C", self.build, "-t", "commands", "-s", objetivo], text=True)
            return [p for p in shlex.split(dice) if p not in (":", "&&")]

        nombre = self.programa.nombre
        compila = palabras(f"{self.carpeta}/CMakeFiles/{nombre}.dir/{nombre}.cpp.o")
        compila = compila[next(i for i, p in enumerate(compila) if p.startswith("-")) - 1:]  # delante puede ir ccache
        sin = {"-MD": 1, "-MT": 2, "-MF": 2, "-o": 2, "-c": 2, "-Werror": 1}
        quedan, i = [], 0
        while i < len(compila):
            if compila[i] not in sin:
                quedan.append(compila[i])
            i += sin.get(compila[i], 1)
        enlaza = palabras(os.path.relpath(self.solucion.programa, self.build))
        bibliotecas = [str(self.build / p) if (self.build / p).is_file() and not p.startswith("/") else p
                       for p in enlaza[enlaza.index("-o") + 2:] if not p.endswith(".o")]
        ve = [p for p in bibliotecas if p.startswith(str(self.build))] + [self.build / "assets"]
        if "-include" in quedan:
            ve.append(Path(quedan[quedan.index("-include") + 1]).parent)
        return quedan, bibliotecas, list(dict.fromkeys(map(str, ve)))

    def compila(self, ficheros, carpeta, ajena=True):
        """El programa de esos ficheros, compilado en esa carpeta. Si no compila, Rechazo con el primer error."""
        carpeta.mkdir(exist_ok=True)
        suya = self.en_arbol(ficheros, carpeta / "fuentes")
        opciones, bibliotecas, _ = self.compilador
        raiz = re.compile(re.escape(str(self.raiz)) + r"(?=$|/(?!build))")  # la de los fuentes, no la de BUILD
        orden = [raiz.sub(str(carpeta / "fuentes"), p) if p.startswith("-I") and not p[2:].startswith(str(self.build)) else p for p in opciones]
        orden += ["-w", "-fdiagnostics-color=never", "-I", suya, "-I", carpeta / "fuentes" / self.carpeta]
        orden += [suya / n for n in ficheros if n.endswith(".cpp")]
        hecho = desempaqueta(self.encierra([*orden, "-o", "programa", *bibliotecas], carpeta, COMPILA, ajena))
        if hecho.get("estado", b"").strip() != b"0":
            raise Rechazo(self.primer_error(hecho, suya))
        (carpeta / self.programa.nombre).write_bytes(hecho["programa"])
        (carpeta / self.programa.nombre).chmod(0o755)
        return Variante("la entrega", carpeta / self.programa.nombre, [suya, carpeta / "fuentes"], ajena=ajena)

    def primer_error(self, hecho, suya):
        if int(hecho.get("estado", b"").strip() or -1) in NO_ACABA:
            return f"no compila: el compilador no acaba en {COMPILA['procesador']} s"
        errores = hecho.get("errores", b"")[:1 << 20].decode(errors="replace").replace(f"{suya}/", "").replace(f"{suya.parent}/", "")
        if error := re.search(r"^([^:\n]+):(\d+):(?:\d+:)? (?:fatal )?error: (.*)$", errores, re.M):
            return f"no compila: {error[1]}:{error[2]}: {error[3]}"
        if falta := re.search(r"undefined reference to [`'](.*)'", errores):
            return f"no compila: falta «{falta[1]}»"
        return "no compila: " + (next(iter(errores.strip().splitlines()[-1:]), "") or "el compilador no ha acabado bien")

    # --- ejecutar ---

    def encierra(self, orden, carpeta, limites, ajena, **entorno):
        """Lo que deja una orden, en un tar: en la jaula, si es ajena, o en una carpeta temporal."""
        prlimit = ["prlimit", f"--cpu={limites['procesador']}", f"--as={limites['memoria']}", f"--nproc={limites['procesos']}",
                   f"--fsize={DISCO}", "--core=0", "--"] if ajena else []
        dentro = [*prlimit, "sh", "-c", ENCIERRA, "sh", limites["segundos"], *orden]
        jaula = self.jaula if ajena else None
        with tempfile.TemporaryDirectory(dir=self.temporal) as aqui:
            opciones = {"cwd": aqui, "env": {**self.entorno, "HOME": "/trabajo" if jaula else aqui, "TMPDIR": "/trabajo" if jaula else aqui, **entorno}}
            if jaula:
                dentro = [*jaula.orden([carpeta, *self.compilador[2], *([self.shaders] if self.shaders.is_dir() else [])]), *dentro]
                opciones["cwd"] = "/"
            try:  # de lo ajeno se lee hasta un límite, aunque escriba donde no debe
                return lanza(["sh", "-c", f'"$@" | head -c {SALE}', "sh", *dentro], timeout=limites["segundos"] + 10, stderr=subprocess.DEVNULL, **opciones).stdout
            except subprocess.TimeoutExpired:
                return b""

    def juega_de_nuevo(self, variante, guion):
        orden = [variante.programa, "-geometry", "{}x{}".format(*TALLA), "-titulos", "-ppm", "ultima.ppm", "-guion", guion.texto]
        shaders = {"LAB_SHADERS": str(self.shaders), "MESA_SHADER_CACHE_DIR": "shaders"} if variante.ajena else {"MESA_SHADER_CACHE_DIR": str(self.shaders)}
        return self.encierra(orden, variante.programa.parent, JUEGA, variante.ajena, LAB_RAIZ=":".join(map(str, variante.raices)), **shaders, **variante.entorno)

    @property
    def shaders(self):
        """Los que compila Mesa para la solución y los mutantes."""
        return self.cache / "shaders"

    def juega(self, variante, guion):
        """La partida; las de la solución y las de los mutantes se guardan, que son las mismas para toda la clase."""
        if variante.ajena:
            return Partida.lee(self.juega_de_nuevo(variante, guion), guion)
        guardada = self.cache / suma(variante.nombre, guion.texto)
        try:
            return Partida.lee(zlib.decompress(guardada.read_bytes()), guion)
        except (OSError, zlib.error):
            datos = self.juega_de_nuevo(variante, guion)
            escribe(guardada.with_name(f"{guardada.name}.{threading.get_ident()}"), zlib.compress(datos, 1))
            guardada.with_name(f"{guardada.name}.{threading.get_ident()}").replace(guardada)
            return Partida.lee(datos, guion)

    # --- guiones ---

    def casos(self):
        for caso in self.programa.casos:
            yield Guion(caso.nombre, tuple(o.strip() for o in caso.guion.split(";") if o.strip()), True)

    def al_azar(self, n):
        suyos = controles.lee(self.raiz, self.programa)
        rasgos, opciones = controles.atiende(self.build, self.programa, **self.entorno)
        mandos = [o for c in suyos if not c.termina for o in c.ordenes if o not in controles.COMUNES] + [f"menu {o}" for o in opciones]
        return guiones_al_azar(f"{self.ref} {self.semilla}", n, mandos,
                               lambda azar: controles.sucesos_al_azar(azar, suyos, rasgos, opciones, *TALLA))

    # --- comparar ---

    def iguales(self, una, otra, deja=None):
        """Si dos imágenes son la misma, salvo lo que puede mover el redondeo. La primera es la esperada."""
        if una == otra:
            return True
        if una[:2] != otra[:2]:
            return False
        clave = suma(una[2], otra[2])
        if clave not in self.iguales_ya or deja:
            with tempfile.TemporaryDirectory(dir=self.temporal) as aqui:
                for nombre, (ancho, alto, pixeles) in (("a", una), ("b", otra)):
                    Path(aqui, nombre).write_bytes(b"P6\n# corrige\n%d %d\n255\n" % (ancho, alto) + pixeles)
                orden = [self.build / "tests/compara", "a", "b", "--amplia", *(["--deja", deja] if deja else [])]
                self.iguales_ya[clave] = lanza(orden, cwd=aqui).returncode == 0
        return self.iguales_ya[clave]

    def difiere(self, esperada, obtenida):
        """En qué imagen se apartan dos partidas, o None. El texto y los títulos cuentan tras la última."""
        for i, imagen in enumerate(esperada.imagenes):
            if i >= len(obtenida.imagenes) or not self.iguales(imagen, obtenida.imagenes[i]):
                return i
        bien = obtenida.estado == esperada.estado and obtenida.titulos == esperada.titulos and (not esperada.texto or obtenida.texto == esperada.texto)
        return None if bien else len(esperada.imagenes) - 1

    # --- por qué ---

    def mutantes(self):
        """Los defectos plantados en los ficheros que tiene quien hace el ejercicio, salvo en lo que pide otro."""
        textos = {f"{self.carpeta}/{f}": texto for f, texto in nuevo.de_la_carpeta(self.raiz, self.programa, self.ref).items()}
        ajenos = {f: [t.span() for t in marcas.TROZO.finditer(texto) if t["codigo"][0] == "E" and t["codigo"] != self.ref] for f, texto in textos.items()}

        def es_de_otro(m):
            return any(desde <= m.sitio(textos[m.fichero])[0] < hasta for desde, hasta in ajenos[m.fichero])
        try:
            return [m for m in muta.lee(self.raiz)[0] if m.fichero in textos and not es_de_otro(m)]
        except ValueError as error:
            raise Fallo(f"tests/mutantes: {error}") from None

    def huecos(self):
        """De cada cosa que pide el ejercicio, si son varias: qué es, y los ficheros con todo menos eso."""
        textos = nuevo.de_la_carpeta(self.raiz, self.programa, self.ref)
        trozos = [(f, t) for f in textos for t in marcas.TROZO.finditer(textos[f]) if t["codigo"] == self.ref]
        return [(t["pide"], {**textos, f: textos[f][:t.start()] + marcas.esqueleto(t[0]) + textos[f][t.end():]}) for f, t in trozos if len(trozos) > 1]

    def variantes(self):
        """(qué se le diría a quien la entregara, Variante): el esqueleto y la solución con cada defecto, todos en un binario."""
        with self.turno:
            if self.mutantes_hechos is None:
                try:
                    self.mutantes_hechos = self.compila_variantes()
                except (ValueError, Rechazo) as error:
                    raise Fallo(f"los defectos plantados de {self.ref} no valen: {error}") from None
        return self.mutantes_hechos

    def compila_variantes(self):
        sitio = self.cache / "variantes"
        if not sitio.is_dir():
            parcial = Path(tempfile.mkdtemp(dir=self.cache))
            self.compila(nuevo.esqueleto(self.raiz, self.programa, self.ref), parcial / "esqueleto", ajena=False)
            for i, (_, con_hueco) in enumerate(self.huecos()):
                try:
                    self.compila(self.limpio(con_hueco), parcial / f"hueco{i}", ajena=False)
                except Rechazo:  # lo demás lo necesita
                    shutil.rmtree(parcial / f"hueco{i}")
            textos = nuevo.de_la_carpeta(self.raiz, self.programa, self.ref)
            for fichero, suyos in muta.por_fichero(self.mutantes()).items():
                nombre, fuente = Path(fichero).name, (self.raiz / fichero).read_text()
                if fichero.endswith(muta.SHADERS):
                    for m in suyos:
                        estropeado = {**textos, nombre: muta.estropea(fuente, m)}
                        escribe(parcial / str(m.numero) / nombre, self.limpio(estropeado)[nombre])
                else:
                    textos[nombre] = f'#include "{self.raiz}/tests/mutantes/mutante.h"\n{muta.cambia(fuente, suyos)}'
            self.compila(self.limpio(textos), parcial / "mutantes", ajena=False)
            try:
                parcial.replace(sitio)
            except OSError:  # otro lo ha hecho mientras
                shutil.rmtree(parcial)
        def en(nombre):
            return sitio / nombre / self.programa.nombre, [sitio / nombre / "fuentes/mios", sitio / nombre / "fuentes"]

        variantes = [("", Variante("esqueleto", *en("esqueleto")))]
        variantes += [(f"parece que falta: {pide}", Variante(f"hueco{i}", *en(f"hueco{i}"))) for i, (pide, _) in enumerate(self.huecos()) if (sitio / f"hueco{i}").is_dir()]
        programa, raices = en("mutantes")
        for m in self.mutantes():
            suyas = [sitio / str(m.numero), *raices]  # si es de un shader, el estropeado; si no, no hay nada
            dice = f"parece que {m.dice}" if m.dice else f"parece este error: {m.imita}"
            variantes.append((dice, Variante(m.nombre, programa, suyas, {"LAB_MUTANTE": str(m.numero)})))
        return variantes

    def limpio(self, textos):
        """Los ficheros de quien hace el ejercicio, sin las marcas, con esos textos."""
        return nuevo.aqui({fichero: nuevo.deja(texto) for fichero, texto in textos.items()}, self.programa)

    def por_que(self, partidas, fallan):
        """Lo que deja en todos los guiones lo mismo que la entrega, en palabras; del esqueleto, ninguna."""
        def las_que_dan_lo_mismo(vivas):
            for guion in sorted(partidas, key=lambda g: g not in fallan):
                vivas = [v for v in vivas if self.difiere(self.juega(v[1], guion), partidas[guion]) is None]
                if not vivas:
                    break
            return vivas

        esqueleto, *otras = self.variantes()
        vivas = las_que_dan_lo_mismo([esqueleto]) or las_que_dan_lo_mismo(otras)
        exactas = [v for v in vivas if all(self.juega(v[1], g).imagenes == p.imagenes for g, p in partidas.items())]
        return list(dict.fromkeys(dice for dice, _ in exactas or vivas))  # vacío, si no hay ninguna


def suma(*partes):
    h = hashlib.sha1()
    for parte in partes:
        h.update(hashlib.sha1(parte if isinstance(parte, bytes) else parte.encode()).digest())
    return h.hexdigest()


# --- corregir ---------------------------------------------------------------------------------------------------------


def sin_veces(orden):
    """«tecla d ×7» es «tecla d», y de lo del ratón basta qué es."""
    palabras = re.sub(" ×\\d+$", "", orden).split()
    return " ".join(palabras) if palabras[0] in ("tecla", "especial", "menu") else palabras[0]


def no_responden(partidas, esperadas):
    """Las órdenes que en la solución cambian la imagen y en lo entregado, nunca."""
    cambia, responde = {}, set()
    for guion, p in partidas.items():
        e = esperadas[guion]
        for i, orden in enumerate(guion.ordenes[:max(len(p.imagenes) - 1, 0)]):
            if e.imagenes[i] != e.imagenes[i + 1]:
                cambia.setdefault(sin_veces(orden))
                if p.imagenes[i] != p.imagenes[i + 1]:
                    responde.add(sin_veces(orden))
    return [o for o in cambia if o not in responde], bool(responde)


def como_acaba(p, guion):
    """Lo que hay que decir de una partida que no ha acabado como debe."""
    tras = f" tras «{guion.ordenes[len(p.imagenes) - 2]}»" if 1 < len(p.imagenes) <= len(guion.ordenes) else "" if p.imagenes else " sin dibujar nada"
    dice = next((linea for linea in p.errores.splitlines() if linea.strip()), "")
    if p.cuelga:
        return f"se queda colgado{tras}"
    if p.estado == 3:
        return dice.partition(": ")[2] or "error de OpenGL"
    if p.estado == -1:
        return "no ha dejado nada: ha llenado su disco o ha acabado con quien lo ejecutaba"
    if p.estado > 128:
        return f"se cae{tras}: {SENALES.get(p.estado, f'señal {p.estado - 128}')}"
    if p.estado:
        return f"acaba con un error{tras}: {dice or f'estado {p.estado}'}"
    return f"acaba por su cuenta{tras}" if len(p.imagenes) <= len(guion.ordenes) else ""


def png(imagen, deja):
    ancho, alto, pixeles = imagen
    (deja / "i.ppm").write_bytes(b"P6\n%d %d\n255\n" % (ancho, alto) + pixeles)
    return base64.b64encode(en_png(deja / "i.ppm", 9)).decode()


class Correccion:
    """La de una entrega, en un diccionario que va tal cual a su JSON."""

    def __init__(self, banco, ficheros):
        self.banco, self.ficheros = banco, ficheros

    def hazla(self):
        with tempfile.TemporaryDirectory(dir=self.banco.temporal) as carpeta:
            os.chmod(carpeta, 0o755)  # lo lee quien está en la jaula
            try:
                self.variante = self.banco.compila(self.ficheros, Path(carpeta))
            except Rechazo as rechazo:
                return {"nota": 0, "dice": [str(rechazo)], "fallos": []}
            return self.compara()

    def compara(self):
        banco = self.banco
        self.esperadas = {g: banco.juega(banco.solucion, g) for g in banco.todos}
        self.partidas = {}
        for guion in banco.todos:
            self.partidas[guion] = banco.juega(self.variante, guion)
            if sum(p.cuelga for p in self.partidas.values()) >= CUELGUES:
                break
        donde = {g: banco.difiere(self.esperadas[g], p) for g, p in self.partidas.items()}
        fallan = {g: i for g, i in donde.items() if i is not None}
        valen = {g: 2 if g.caso else 1 for g in banco.todos}
        bien = [g for g in banco.todos if g in self.partidas and g not in fallan]
        nota = 100 * sum(valen[g] for g in bien) / sum(valen.values())
        acaban = list(dict.fromkeys(filter(None, (como_acaba(p, g) for g, p in self.partidas.items()))))
        dice = acaban[:3]
        muestra = self.muestra(fallan)
        if fallan and not acaban:
            dice += self.explica(fallan, muestra)
        return {"nota": min(round(nota, 1), 100 if len(bien) == len(banco.todos) else 99.9), "bien": len(bien), "guiones": len(banco.todos), "dice": dice,
                "fallos": muestra}

    def explica(self, fallan, muestra):
        porque = self.banco.por_que(self.partidas, fallan)
        if porque == [""]:
            return ["se ve lo mismo que en el punto de partida"]
        dice = ["; o ".join(filter(None, porque[:2]))] if porque else []
        callan, alguna = no_responden(self.partidas, self.esperadas)
        if callan and not alguna:
            dice.append("no responde a nada de lo que debería")
        else:
            dice += [f"«{orden}» no hace nada" for orden in callan[:5]]
        for fallo in muestra:
            if fallo["tras"] and fallo["tras"][-1].startswith("tamano"):
                dice.append("está mal al cambiar el tamaño de la ventana")
        return list(dict.fromkeys(dice))

    def muestra(self, fallan):
        """De los guiones que antes fallan, sin repetir: qué órdenes bastan, en palabras y en imágenes."""
        vistos, fallos = [], []
        for guion in sorted(fallan, key=lambda g: (fallan[g], not g.caso))[:4 * MUESTRA]:
            if len(fallos) == MUESTRA or [] in vistos:
                break
            if [sin_veces(o) for o in guion.ordenes[:fallan[guion]][-1:]] in vistos:  # ya se sabe que con eso basta
                continue
            tras, esperada, obtenida = self.acortado(guion, fallan[guion])
            bastan = [sin_veces(o) for o in tras]
            if bastan not in vistos:
                vistos.append(bastan)
                fallos.append({"guion": guion.nombre, "tras": list(tras), "que": self.que(tras, esperada, obtenida), "imagenes": self.imagenes(esperada, obtenida)})
        return fallos

    def acortado(self, guion, hasta):
        """Las órdenes de ese guion que bastan para que falle, y las dos partidas."""
        banco, ordenes = self.banco, guion.ordenes[:hasta]
        jugadas = {guion.ordenes: (self.esperadas[guion], self.partidas[guion])}

        def falla(candidatas):
            g = Guion("", tuple(candidatas))
            jugadas[g.ordenes] = Partida.lee(banco.juega_de_nuevo(banco.solucion, g), g), banco.juega(self.variante, g)
            return banco.difiere(*jugadas[g.ordenes]) is not None

        if self.partidas[guion].cuelga:
            return ordenes, *jugadas[guion.ordenes]
        if ordenes:
            ordenes = acorta(ordenes, falla)
        if ordenes not in jugadas:
            falla(ordenes)
        return ordenes, *jugadas[ordenes]

    def que(self, tras, esperada, obtenida):
        donde = "tras " + ", ".join(f"«{o}»" for o in tras) if tras else "ya al empezar"
        i = self.banco.difiere(esperada, obtenida)
        if i is None or i >= len(obtenida.imagenes):
            return f"falla {donde}"
        if self.banco.iguales(esperada.imagenes[i], obtenida.imagenes[i]):
            for e, o in itertools.zip_longest(esperada.titulos, obtenida.titulos, fillvalue="título: (ninguno)"):
                if e != o:
                    return f"falla {donde}: el título es «{o[8:]}» y debía ser «{e[8:]}»"
            if esperada.texto and esperada.texto != obtenida.texto:
                e, o = next(p for p in itertools.zip_longest(esperada.texto.split("\n"), obtenida.texto.split("\n"), fillvalue="") if p[0] != p[1])
                return f"falla {donde}: escribe «{o}» y debía escribir «{e}»"
        return f"falla {donde}"

    def imagenes(self, esperada, obtenida):
        """La entregada, la esperada y su diferencia donde se apartan, en PNG."""
        i = self.banco.difiere(esperada, obtenida)
        if i is None or i >= len(obtenida.imagenes):
            return []
        una, otra = esperada.imagenes[i], obtenida.imagenes[i]
        with tempfile.TemporaryDirectory(dir=self.banco.temporal) as aqui:
            aqui = Path(aqui)
            if self.banco.iguales(una, otra, deja=aqui / "d"):
                return []
            imagenes = [otra, una]
            if (aqui / "d-diferencia.ppm").exists():
                imagenes.append(lee_ppm((aqui / "d-diferencia.ppm").read_bytes()))
            return [png(imagen, aqui) for imagen in imagenes]


def corrige(banco, carpeta, resultado=None):
    """La corrección de una carpeta; si RESULTADO ya es la de lo mismo, esa."""
    nombre = os.fsencode(carpeta.name).decode(errors="replace")
    comun = {"entrega": nombre, "ejercicio": banco.ref, "semilla": banco.semilla}
    try:
        ficheros = lee_entrega(carpeta)
        comun["huella"] = suma(banco.version, str(banco.semilla), str(len(banco.todos)), repr(sorted(ficheros.items())))
    except Rechazo as rechazo:
        ficheros = None
        comun["huella"] = suma(banco.version, str(rechazo))
        hecha = {"nota": 0, "dice": [str(rechazo)], "fallos": []}
    if resultado and (anterior := lee_resultado(resultado)) and anterior["huella"] == comun["huella"]:
        return anterior
    if ficheros is not None:
        hecha = Correccion(banco, ficheros).hazla()
    datos = {**comun, "bien": 0, "guiones": len(banco.todos), **hecha}
    if resultado:
        escribe(resultado, json.dumps(datos, ensure_ascii=False, indent=1))
    return datos


def lee_resultado(fichero):
    try:
        return json.loads(fichero.read_text())
    except (OSError, ValueError):
        return None


# --- escribirla -------------------------------------------------------------------------------------------------------


def lineas(c):
    """Lo que hay que decirle a quien la entregó."""
    return [*c["dice"], *(f["que"] for f in c["fallos"])] or ["todo bien"]


def en_texto(c):
    frases = "\n".join(f"  {linea}" for linea in lineas(c))
    return f"{c['entrega']}, {c['ejercicio']}: {c['nota']:g} de 100 ({c['bien']} de {c['guiones']} guiones; semilla {c['semilla']})\n{frases}"


def en_una_linea(texto):
    return "".join(letra if letra.isprintable() else " " for letra in texto)


def en_vpl(c):
    """Como lo lee el Virtual Programming Lab de Moodle: los comentarios y, la última, la nota, en la escala que tenga la actividad."""
    desde, hasta = (float(os.environ.get(f"VPL_GRADE{que}") or vale) for que, vale in (("MIN", 0), ("MAX", 100)))
    comentarios = [f"Comment :=>>{en_una_linea(linea)}" for linea in (f"-{c['ejercicio']}: {c['bien']} de {c['guiones']} guiones, semilla {c['semilla']}", *lineas(c))]
    return "\n".join([*comentarios, f"Grade :=>> {desde + (hasta - desde) * c['nota'] / 100:.5g}"])


def en_junit(correcciones):
    """Una prueba por entrega, que falla si no está todo bien."""
    pruebas = []
    for c in correcciones:
        mal = "" if c["nota"] == 100 else f"<failure message={quoteattr(en_una_linea('; '.join(lineas(c))))}/>"
        pruebas.append(f'  <testcase classname="corrige.{c["ejercicio"]}" name={quoteattr(en_una_linea(c["entrega"]))}>{mal}</testcase>')
    fallan = sum(c["nota"] < 100 for c in correcciones)
    return "\n".join(['<?xml version="1.0" encoding="UTF-8"?>', f'<testsuite name="corrige" tests="{len(correcciones)}" failures="{fallan}">', *pruebas, "</testsuite>\n"])


def en_csv(correcciones):
    """La tabla. Una celda que empieza como una fórmula no debe serlo."""
    def celda(texto):
        return "'" + texto if texto[:1] in tuple("=+-@") else texto
    tabla = io.StringIO()
    filas = csv.writer(tabla)
    filas.writerow(["entrega", "ejercicio", "nota", "bien", "guiones", "semilla", "dice"])
    for c in correcciones:
        filas.writerow([celda(en_una_linea(c["entrega"])), c["ejercicio"], c["nota"], c["bien"], c["guiones"], c["semilla"], celda(en_una_linea("; ".join(lineas(c))))])
    return tabla.getvalue()


def fichero_de(carpeta):
    nombre = carpeta.name if re.fullmatch(r"\w[\w .@+-]{0,99}", carpeta.name) else suma(os.fsencode(carpeta.name))
    return f"{nombre}.json"


def clase(banco, carpetas, destino, a_la_vez):
    """Cada carpeta, una entrega. Lo que no se pueda corregir por algo que no es suyo se dice y queda para la próxima vez."""
    correcciones, fallos = {}, []

    def una(carpeta):
        try:
            c = correcciones[carpeta] = corrige(banco, carpeta, destino / fichero_de(carpeta))
            dice = f"{c['entrega']}: {c['nota']:g}; {en_una_linea(lineas(c)[0])}"
        except (Fallo, OSError) as fallo:
            dice = f"{carpeta.name}: {motivo(fallo) if isinstance(fallo, OSError) else fallo}"
            fallos.append(dice)
        print(f"[{len(correcciones) + len(fallos):3}/{len(carpetas)}] {dice}", file=sys.stderr)

    with ThreadPoolExecutor(a_la_vez) as hilos:
        list(hilos.map(una, carpetas))
    return [correcciones[carpeta] for carpeta in carpetas if carpeta in correcciones], fallos


class Analizador(argparse.ArgumentParser):
    def error(self, message):
        raise Fallo(f"corrige: no entiendo «{' '.join(self.palabras)}»; ./lab ayuda dice sus opciones")


def opciones(palabras):
    """Las de docs/corrige.md."""
    analizador = Analizador(add_help=False, allow_abbrev=False)
    analizador.palabras = palabras
    analizador.add_argument("entrega")
    analizador.add_argument("ejercicio", nargs="?")
    analizador.add_argument("--semilla", default="1")
    analizador.add_argument("--guiones", type=int, default=GUIONES)
    for opcion in ("--deja", "--json", "--junit"):
        analizador.add_argument(opcion, type=Path)
    analizador.add_argument("-j", type=int, default=os.cpu_count())
    for opcion in ("--vpl", "--sin-jaula", "--programa"):  # --programa: solo escribe cuál es
        analizador.add_argument(opcion, action="store_true")
    que = analizador.parse_args(palabras)
    if que.guiones < 0 or que.j < 1:
        analizador.error("")
    return que


def busca(build, entrega):
    """Su carpeta y, si es una clase, las de dentro."""
    carpeta = next((c for c in (build.parent / "mios" / entrega, Path(entrega)) if c.is_dir()), None)
    if not carpeta:
        raise Fallo(f"no hay ninguna carpeta «{entrega}», ni mios/{entrega}")
    carpeta = carpeta.absolute()
    if any(f.suffix == ".cpp" for f in carpeta.iterdir()):
        return carpeta, None
    dentro = sorted(c for c in carpeta.iterdir() if (c.is_dir() or c.is_symlink()) and not c.name.startswith("."))
    return carpeta, dentro or None


def ejercicio(raiz, programas, pedido):
    hay = nuevo.ejercicios(raiz, programas)
    ref = (pedido or "").upper()
    if ref not in hay:
        raise Fallo(f"{f'«{pedido}» no es un ejercicio que se pueda corregir' if pedido else 'di qué ejercicio es'}: {', '.join(hay)}")
    return ref, hay[ref]


def main():
    raiz, build = (Path(p).resolve() for p in sys.argv[1:3])
    que = opciones(sys.argv[3:])
    carpeta, dentro = busca(build, que.entrega)
    programas = catalogo.lee_programas(build)
    ref, programa = ejercicio(raiz, programas, que.ejercicio) if que.ejercicio or dentro else nuevo.ejercicio_de(carpeta, programas)
    if not ref:
        raise Fallo(f"{que.entrega} es una copia de {programa.nombre}: no hay ejercicio que corregir")
    if que.programa:
        return print(programa.nombre)
    jaula = None if que.sin_jaula else Jaula(raiz)
    if jaula:
        jaula.comprueba()
    with tempfile.TemporaryDirectory() as temporal:
        os.chmod(temporal, 0o755)
        banco = Banco(raiz, build, ref, programa, Path(temporal), jaula, que.semilla, que.guiones)
        if dentro:
            destino = que.deja or carpeta.with_name(f"{carpeta.name}-corregida")
            correcciones, fallos = clase(banco, dentro, destino, que.j)
            escribe(destino / "notas.csv", en_csv(correcciones))
        else:
            destino = que.deja or (None if que.json or que.vpl else carpeta / "correccion")
            correcciones, fallos = [corrige(banco, carpeta, que.json and que.json.absolute())], []
            print(en_vpl(correcciones[0]) if que.vpl else en_texto(correcciones[0]))
    if que.junit:
        escribe(que.junit, en_junit(correcciones))
    if destino:
        pagina.escribe_pagina(destino, "corrige.html", correcciones=correcciones, lineas=lineas, programa=banco.programa, ref=ref)
        print(f"Hecha: {destino}/index.html", file=sys.stderr)
    if fallos:
        raise Fallo(f"no se han podido corregir {len(fallos)}: {'; '.join(fallos)}")
    return 0 if all(c["nota"] == 100 for c in correcciones) else 1


if __name__ == "__main__":
    principal(main)
