"""muta.py RAÍZ BUILD [--comprueba | pendientes | QUÉ…]: defectos plantados (base/defectos.py dice cómo son las listas),
para saber si las pruebas los notan.

Todos se compilan a la vez en una copia del árbol, en BUILD/mutantes; un shader estropeado va en una carpeta, y
$LAB_RAIZ hace que se mire antes que las demás. Los de ./lab, de Python y de las páginas se escriben en una copia de
todo ello, con lo demás como está, y los ven las pruebas que dice EN_COPIA. Primero se ejecutan sin ninguno las pruebas
y los casos, que deben pasar y apuntan lo que usan; después, con cada mutante, los que lo usan, hasta que uno falle: las
que han notado otro de su fichero, también en otra ocasión; las de su capítulo, las demás y, si ninguna lo nota, los
pasos y los casos: por lo que pintan encima (los .encima) o, si no, solo por su imagen. Cómo se nota cada uno queda en
docs/plantados.tsv; «pendientes» son los que no se han plantado desde que cambiaron ellos o su fichero.
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from collections import Counter
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass, field
from pathlib import Path

from base import catalogo, procesos
from base.defectos import MUTANTE_H, cambia, estropea, lee, por_fichero
from base.fuentes import SHADERS, con_inclusiones
from base.procesos import lanza, principal
from pruebas.googletest import pruebas_de
from pruebas.plantados import ENCIMA, FICHERO, GOLDEN, Plantados

MINIMO = 150  # mutantes en la lista
SOSPECHOSAS = 8  # las que se prueban antes, de las que no se compilan
NO_HAY = 4, 5  # con lo que acaba pytest si no están las pruebas que se piden
META, META_SIN_IMAGEN, META_INDEPENDIENTE = 98, 95, 90  # por ciento: notados, con lo de encima y sin ello
PYTEST = shutil.which("pytest-3") or "pytest"
DISTINTO_ENCIMA = 4  # con que acaba casos.sh si es distinto lo que se pinta encima
JUECES = "vocabulario", "cota", "oraculo", "mide", "comparador", "pies", "jueces"  # las pruebas de los que juzgan
SOBRA = "build", "galeria", "informe", "web", "windows", "mios", ".git"  # de una copia del árbol
DE_ORDENES = "tests/ordenes/ordenes_test.py", "tests/ordenes/preguntas_test.py"
DE_HERRAMIENTAS = "tests/herramientas/claves_test.py", "tests/herramientas/herramientas_test.py"
# De «LISTA FICHERO», el primero que casa: lo que nota los que no se compilan, de lo que menos tarda a lo que más.
EN_COPIA = {
    "^jueces ": ("tests/jueces/propiedades_mal_test.py", "tests/jueces/jueces_test.py"),
    "^correccion |/corrige/": tuple(
        f"tests/herramientas/{f}_test.py" for f in "donde aula herramientas corrige propios".split()
    ),
    r"^explica |/explica/.*\.py$": ("tests/ordenes/sin_pruebas_test.py",),
    r"^paginas |\.mjs$": ("tests/paginas/partes.mjs",),
    " lab$": DE_ORDENES + DE_HERRAMIENTAS,
    "": DE_HERRAMIENTAS + DE_ORDENES,
}
# Con LAB_NAVEGADOR=1, los de las páginas los nota también, después, lo que se hace en ellas.
EN_NAVEGADOR = {
    "herramientas/web/": "tests/paginas/web.sh",
    "herramientas/galeria/": "tests/paginas/comprueba_galeria.py",
}


@dataclass
class Prueba:
    nombre: str
    orden: list
    entorno: dict
    golden: bool
    segundos: float = 0
    vistos: set = field(default_factory=set)

    @property
    def capitulo(self):
        return capitulo(self.nombre)

    def falla(self, limite, **entorno):
        """Con qué estado acaba en ese entorno: 0 si bien y a tiempo. Lo que escribe queda en self.salida."""
        try:
            proceso = lanza(
                self.orden, timeout=limite, stderr=subprocess.STDOUT, env={**os.environ, **self.entorno, **entorno}
            )
        except subprocess.TimeoutExpired:
            self.salida = "no acaba"
            return 1
        self.salida = proceso.stdout.decode(errors="replace")
        return proceso.returncode


def aviso(texto):
    print(f"muta: {texto}", file=sys.stderr, flush=True)


def capitulo(nombre):
    """El de una prueba o un fichero: ch05, o comun."""
    return nombre[:4] if nombre.startswith("ch") else "comun"


def es_de(prueba, capitulos):
    """Si esa prueba es de alguno de esos capítulos, o si no se piden. Los casos difíciles son de todos."""
    if "jueces" in capitulos and prueba.split("_test")[0].split(".")[0] in JUECES:
        return True
    return not capitulos or capitulo(prueba) in capitulos or prueba.startswith("dificil_") and capitulos != {"jueces"}


def lee_listas(raiz):
    """Todos: los de un estudiante y los de las pruebas."""
    return lee(raiz / "herramientas/ejercicios/errores", raiz / "tests/mutantes")


def comprueba(raiz, programas, mutantes, fallos):
    """Que cada mutante se puede aplicar, que los shaders estropeados compilan y que no falta ningún programa."""
    for fichero, grupo in por_fichero(mutantes).items():
        try:
            fuente = (raiz / fichero).read_text()
        except OSError as error:
            fallos.append(f"{grupo[0].nombre}: no puedo leer {fichero}: {error.strerror}")
            continue
        buenos, primero = [], {}
        for m in grupo:
            try:
                otro = primero.setdefault((m.sitio(fuente), m.estropeado), m)
                buenos.append(m)
                if otro != m:
                    fallos.append(f"{m.nombre}: es el mismo que {otro.nombre}")
            except ValueError as error:
                fallos.append(f"{m.nombre}: {error}")
        if grupo[0].en_copia:
            for m in buenos:
                fallos += compila_guion(m, estropea(fuente, m))
            continue
        if grupo[0].en_shader:
            for m in buenos:
                # si no, cualquiera lo notaría
                fallos += [f"{m.nombre}: {dice}" for dice in no_compila_glsl(raiz, m.fichero, estropea(fuente, m))]
            continue
        try:
            cambia(fuente, buenos)
        except ValueError as error:
            fallos.append(f"{fichero}: {error}")
    if len(mutantes) < MINIMO:
        fallos.append(f"hay {len(mutantes)} mutantes, y deben ser {MINIMO}")
    for p in programas:
        if not any(m.fichero.startswith(f"{p.capitulo.nombre}/{p.nombre}") for m in mutantes):
            fallos.append(f"ningún mutante en {p.capitulo.nombre}/{p.nombre}")
    return fallos


def no_compila_glsl(raiz, fichero, estropeado):
    """Lo que se dice de un shader estropeado que no compila."""
    quien = fichero
    if quien.endswith(".glsl"):
        incluyen = [
            f for f in sorted(raiz.glob("ch*/*.*")) if f.suffix in SHADERS[:2] and f'"{quien}"' in f.read_text()
        ]
        quien = str(incluyen[0].relative_to(raiz))
    if not shutil.which("glslangValidator"):
        return []
    texto = con_inclusiones(raiz, quien, {fichero: estropeado})
    informe = subprocess.run(
        ["glslangValidator", "--stdin", "-S", quien[-4:]], input=texto, text=True, capture_output=True
    )
    return [f"no compila: {informe.stdout.splitlines()[-3:]}"] if informe.returncode else []


def compila_guion(mutante, estropeado):
    """Uno estropeado de Python, de Bash o de JavaScript debe poder leerse."""
    informe = ""
    if mutante.fichero.endswith(".py"):
        try:
            compile(estropeado, mutante.fichero, "exec")
        except SyntaxError as error:
            informe = f"línea {error.lineno}: {error.msg}"
    elif mutante.de_bash or mutante.fichero.endswith(".mjs") and shutil.which("node"):
        lector = ["bash", "-n"] if mutante.de_bash else ["node", "--input-type=module", "--check", "-"]
        informe = subprocess.run(lector, input=estropeado, text=True, capture_output=True).stderr
    return [f"{mutante.nombre}: no se puede leer: {informe.strip()}"] if informe else []


def copia_de_trabajo(raiz, carpeta):
    """El árbol: lo que se estropea y sus pruebas; de lo demás, la carpeta vacía."""
    carpeta.mkdir()
    for que in raiz.iterdir():
        if que.name in ("herramientas", "tests", ".ci"):
            shutil.copytree(que, carpeta / que.name, ignore=shutil.ignore_patterns("__pycache__", "golden"))
        elif que.is_dir() and que.name not in SOBRA:
            (carpeta / que.name).mkdir()
        elif que.is_file():
            shutil.copy2(que, carpeta)
    (carpeta / "tests/golden").mkdir()
    return carpeta


def en_su_sitio(raiz, build, copia):
    """Lo que va delante de una orden para que vea la copia en el sitio del árbol, que es donde build/ sabe compilar, y
    en sus carpetas vacías, las de verdad."""
    if build.is_relative_to(raiz):
        (copia / build.relative_to(raiz)).mkdir(exist_ok=True)
    orden = ["bwrap", "--dev-bind", "/", "/", "--bind", copia, raiz]
    for carpeta in (*copia.iterdir(), copia / "tests/golden"):
        if carpeta.is_dir() and not any(carpeta.iterdir()):
            orden += ["--bind", raiz / carpeta.relative_to(copia), raiz / carpeta.relative_to(copia)]
    return orden


def orden_en_copia(raiz, build, copia, *nombres):
    if nombres[0] in EN_NAVEGADOR.values():
        parte = ["persona"] if nombres[0].endswith(".sh") else []
        return [*en_su_sitio(raiz, build, copia), raiz / nombres[0], raiz, build, *parte]
    if nombres[0].endswith(".mjs"):
        return [*en_su_sitio(raiz, build, copia), "node", raiz / nombres[0], raiz, build]
    return [*en_su_sitio(raiz, build, copia), PYTEST, "-xq", "-p", "no:cacheprovider", *(raiz / n for n in nombres)]


def sospechosas(mutante, pruebas, notan):
    """De esas pruebas de Python, una a una, la que lo notó y las que más han notado de su fichero."""
    en = {Path(p).stem: p for p in pruebas if p.endswith(".py")}
    suyas = Counter({quien: n for (f, quien), n in notan.items() if f == mutante.fichero})
    partes = (quien.partition(".") for quien in dict.fromkeys((mutante.antes, *(q for q, _ in suyas.most_common()))))
    return [f"{en[stem]}::{una}" for stem, _, una in partes if stem in en and una][:SOSPECHOSAS]


def las_que_lo_notan(mutante):
    pruebas = next(suyas for de, suyas in EN_COPIA.items() if re.search(de, f"{mutante.lista} {mutante.fichero}"))
    if mutante.fichero.endswith(".mjs") and os.environ.get("LAB_NAVEGADOR") == "1":
        de_una = [prueba for donde, prueba in EN_NAVEGADOR.items() if mutante.fichero.startswith(donde)]
        pruebas += tuple(de_una or EN_NAVEGADOR.values())
    return pruebas


def prueba_en_copia(raiz, build, temporal, pruebas, mutante=None, notan=()):
    """Esas pruebas en una copia con ese mutante, hasta la que lo nota; antes, las sospechosas."""
    with tempfile.TemporaryDirectory(dir=temporal) as sitio:
        os.chmod(sitio, 0o755)
        copia = copia_de_trabajo(raiz, Path(sitio, "lab"))
        antes = []
        if mutante:
            fichero = copia / mutante.fichero
            fichero.write_text(estropea(fichero.read_text(), mutante))
            antes = sospechosas(mutante, pruebas, notan)
        for nombres in filter(None, [antes, *([nombre] for nombre in pruebas)]):
            limite, entorno = 900, {}  # segundos, con la máquina ocupada
            if nombres[0] in EN_NAVEGADOR.values():
                limite, entorno = 1800, {**procesos.entorno(build), "LAB_AL_PRIMERO": "1"}
            prueba = Prueba(nombres[0], orden_en_copia(raiz, build, copia, *nombres), entorno, False)
            estado = prueba.falla(limite, TMPDIR=sitio, LAB_BUILD=str(build))
            if not mutante and estado:
                sys.exit(f"{prueba.salida[-1000:]}\nmuta: {nombres[0]} falla sin ningún mutante")
            if estado and not (nombres == antes and estado in NO_HAY):
                quien = re.search(
                    r"^(?:FAILED|ERROR) \S*?([^/\s]+)\.py::(.+?)(?: - .*)?$|^(?:not ok \d+ - |falla: )(.+)$",
                    prueba.salida,
                    re.M,
                )
                mutante.notado = (
                    f"{quien[1] or Path(nombres[0]).stem}.{quien[2] or quien[3]}" if quien else Path(nombres[0]).name
                )
                notan[mutante.fichero, mutante.notado] += 1
                break
    return mutante


class Vivero:
    """La copia del árbol con todos los mutantes, compilada."""

    def __init__(self, raiz, carpeta, mutantes, notan):
        """`notan`: de (fichero, prueba), cuántos defectos."""
        self.raiz, self.copia, self.build, self.mutantes = raiz, carpeta / "fuente", carpeta / "build", mutantes
        self.procesos, self.notan = os.cpu_count(), notan

    def copia_arbol(self):
        """Solo se escribe lo que cambia: así se vuelve a compilar solo eso."""
        grupos = por_fichero(self.mutantes)
        nuevos = {}
        for carpeta, carpetas, ficheros in os.walk(self.raiz):
            sobra = SOBRA if carpeta == str(self.raiz) else ["__pycache__"]
            carpetas[:] = [c for c in carpetas if c not in sobra]
            for f in ficheros:
                relativo = str((Path(carpeta) / f).relative_to(self.raiz))
                nuevos[relativo] = (self.raiz / relativo).read_bytes()
        fuentes = [f for f, suyos in grupos.items() if not suyos[0].en_shader]
        for fichero in fuentes:
            nuevos[fichero] = cambia(nuevos[fichero].decode(), grupos[fichero]).encode()
        for relativo in nuevos:  # una prueba puede incluir un fuente dentro de un namespace
            if relativo in fuentes or re.match("tests/.*_test.cpp", relativo):
                mutante_h = os.path.relpath(MUTANTE_H, Path(relativo).parent)
                nuevos[relativo] = f'#include "{mutante_h}"\n'.encode() + nuevos[relativo]
        for viejo in self.copia.rglob("*"):
            if viejo.is_file() and str(viejo.relative_to(self.copia)) not in nuevos:
                viejo.unlink()
        for relativo, contenido in nuevos.items():
            destino = self.copia / relativo
            if not destino.is_file() or destino.read_bytes() != contenido:
                destino.parent.mkdir(parents=True, exist_ok=True)
                destino.unlink(missing_ok=True)  # puede ser de solo lectura, como el original
                destino.write_bytes(contenido)
                shutil.copymode(self.raiz / relativo, destino)
        shutil.rmtree(self.build / "glsl", ignore_errors=True)
        for m in self.mutantes:
            if m.en_shader:
                destino = self.build / "glsl" / str(m.numero) / m.fichero
                destino.parent.mkdir(parents=True)
                destino.write_text(estropea(nuevos[m.fichero].decode(), m))

    def compila(self, capitulos):
        """Las pruebas de esos capítulos, o todas, y los programas sin ventana. Con -O1, que da las mismas imágenes y
        tarda la mitad."""
        opciones = ["-DCMAKE_CXX_FLAGS_RELEASE=-O1 -w", "-DLAB_AVISOS_SON_ERRORES=OFF"]
        if shutil.which("ccache"):
            opciones.append("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache")
        cache = self.build / "CMakeCache.txt"
        if cache.exists() and f"CMAKE_HOME_DIRECTORY:INTERNAL={self.copia}\n" not in cache.read_text():
            shutil.rmtree(self.build)  # el laboratorio se ha movido
        self.orden("cmake", "--preset", "release", "-S", self.copia, "-B", self.build, *opciones)
        self.sin_ventana = (self.build / "sin_ventana").read_text().strip()
        self.programas = catalogo.lee_programas(self.build)
        pruebas = [f.stem for f in self.copia.glob("tests/*/*_test.cpp") if es_de(f.name, capitulos)]
        de_los_jueces, listas = ["borde", "pies", "defectuoso"], {m.lista for m in self.mutantes}
        self.orden(
            "ninja",
            "-k",
            "0",
            "-C",
            self.build,
            *(pruebas if capitulos else ["tests/all"]),
            "compara",
            "explica",
            *(["finitos"] if self.sin_ventana == "osmesa" else ()),  # con ello van las propiedades
            *(["rarezas"] if "explica" in listas else ()),
            *(de_los_jueces if "jueces" in listas and es_de("jueces", capitulos) else ()),
            *(f"{p.nombre}_{self.sin_ventana}" for p in self.programas),
        )

    def orden(self, *palabras):
        proceso = lanza(palabras, cwd=self.copia, text=True, stderr=subprocess.STDOUT)
        if proceso.returncode:
            sys.exit(
                "\n".join(
                    [linea for linea in proceso.stdout.splitlines() if not linea.startswith("[")]
                    + ["muta: no se ha podido compilar con los mutantes dentro"]
                )
            )

    def enumera(self, capitulos):
        """Cada TEST y cada caso de esos capítulos, o todos, que son lo que se ejecuta."""
        pruebas = []
        for ejecutable in sorted(self.build / "tests" / f.stem for f in self.copia.glob("tests/*/*_test.cpp")):
            if not es_de(ejecutable.name, capitulos):
                continue
            for nombre in pruebas_de(ejecutable):
                pruebas.append(
                    Prueba(f"{ejecutable.name[:-5]}.{nombre}", [ejecutable, f"--gtest_filter={nombre}"], {}, False)
                )
        entorno = procesos.entorno(self.build)
        if es_de("jueces", capitulos) and any(m.lista == "jueces" for m in self.mutantes):
            pruebas += self.de_jueces(entorno)
        if not capitulos and any(m.lista == "explica" for m in self.mutantes):
            pruebas += self.de_explica(entorno)
        for programa in self.programas:
            de = capitulo(programa.capitulo.nombre)
            if not programa.consola and (not capitulos or de in capitulos):
                orden = [
                    sys.executable,
                    "-B",
                    self.copia / "tests/propiedades/propiedades.py",
                    self.copia,
                    self.build,
                    programa.nombre,
                ]
                pruebas.append(Prueba(f"{de} propiedades.{programa.nombre}", orden, entorno, False))
            hay_pasos = (self.copia / f"tests/golden/{programa.capitulo.nombre}/{programa.nombre}.pasos").exists()
            if hay_pasos and (not capitulos or de in capitulos):
                orden = [self.copia / "tests/casos/casos.sh", self.build, "pasos", programa.nombre]
                pruebas.append(Prueba(f"{de} pasos.{programa.nombre}", orden, entorno, True))
            for caso in programa.casos:
                if not programa.consola and (not capitulos or de in capitulos):
                    orden = [
                        self.copia / "tests/casos/casos.sh",
                        self.build,
                        self.sin_ventana,
                        programa.nombre,
                        caso.nombre,
                    ]
                    pruebas.append(Prueba(f"{de} golden {programa.nombre}.{caso.nombre}", orden, entorno, True))
        return pruebas

    def de_jueces(self, entorno):
        """Las que no son de GoogleTest y juzgan a lo que se compila."""
        defectos = [sys.executable, "-B", self.copia / "tests/comparador/defectos.py", self.copia, self.build]
        yield Prueba("comparador.defectos", defectos, entorno, False)
        pies = [sys.executable, "-B", self.copia / "tests/casos/pies_mal.py", self.build]
        yield Prueba("pies", pies, entorno, False)
        jueces = [PYTEST, "-xq", "-p", "no:cacheprovider", self.copia / "tests/jueces/jueces_test.py"]
        jueces += ["-k", "borde or queda or numero or casos or pagina"]
        yield Prueba("jueces", jueces, {**entorno, "LAB_BUILD": str(self.build)}, False)

    def de_explica(self, entorno):
        """Las que preguntan a lo que se pone delante de OpenGL."""
        explica = "propiedades/explica", [self.copia, self.build, "--enlace", self.sin_ventana]
        causas = "casos/causas", [self.build]  # con OSMesa
        for nombre, orden in (explica, causas) if self.sin_ventana == "osmesa" else (explica,):
            palabras = [sys.executable, "-B", self.copia / f"tests/{nombre}.py", *orden]
            yield Prueba(nombre.rpartition("/")[2], palabras, entorno, False)

    def sin_mutantes(self, pruebas, hilos):
        """Todo debe pasar sin ninguno, y se apunta cuánto tarda y qué usa."""
        aviso(f"ejecuto {len(pruebas)} pruebas y casos sin ningún mutante…")

        def ejecuta(prueba):
            with tempfile.NamedTemporaryFile() as vistos:
                principio = time.monotonic()
                pasa = not prueba.falla(600, LAB_LEIDOS=vistos.name)
                prueba.segundos = time.monotonic() - principio
                prueba.vistos = set(Path(vistos.name).read_text().split("\n"))
            return pasa

        malas = []
        for i, (p, pasa) in enumerate(zip(pruebas, hilos.map(ejecuta, pruebas)), 1):
            if sys.stderr.isatty():
                print(f"\r{i}/{len(pruebas)}", end="\n" if i == len(pruebas) else "", file=sys.stderr)
            if not pasa:
                malas.append(p)
        for p in malas:
            print(f"{p.nombre}: falla sin ningún mutante\n{p.salida[-1000:]}")
        if malas:
            sys.exit(f"muta: {len(malas)} pruebas fallan sin ningún mutante")
        for m in self.mutantes:
            visto = m.fichero if m.en_shader else str(m.numero)
            m.pruebas = sorted(
                (p for p in pruebas if visto in p.vistos and (m.lista != "jueces" or es_de(p.nombre, {"jueces"}))),
                key=lambda p: (p.golden, p.capitulo != capitulo(m.fichero), p.segundos),
            )

    def prueba(self, mutante):
        numero = str(mutante.numero)
        entorno = {"LAB_RAIZ": str(self.build / "glsl" / numero)} if mutante.en_shader else {"LAB_MUTANTE": numero}

        def orden(prueba):
            return prueba.golden, prueba.nombre != mutante.antes, -self.notan[mutante.fichero, prueba.nombre]

        for prueba in sorted(mutante.pruebas, key=orden):
            estado = prueba.falla(30 + 10 * prueba.segundos, **entorno)
            por = "" if not prueba.golden else ENCIMA if estado == DISTINTO_ENCIMA else GOLDEN
            if estado and not (mutante.notado and por == GOLDEN):
                mutante.notado, mutante.por = prueba.nombre, por
                self.notan[mutante.fichero, prueba.nombre] += 1
            if estado and por != GOLDEN:  # a otro caso puede notársele encima
                break
        return mutante


def cuenta(mutante):
    if mutante.notado:
        resultado = {"": "", ENCIMA: "encima, ", GOLDEN: "solo "}[mutante.por] + mutante.notado
    else:
        resultado = "SOBREVIVE" if mutante.pruebas or mutante.en_copia else "SOBREVIVE, nada lo ejecuta"
    motivo = f" ({mutante.motivo})" if mutante.motivo else ""
    return f"{mutante.nombre:<11} {mutante.fichero}, {mutante.imita}: {resultado}{motivo}"


def resume(listas):
    """La tabla por listas. Devuelve los porcentajes del total: notados, sin mirar los golden y con lo de encima."""
    total = {que: sum(c[que] for c in listas.values()) for que in ("plantados", "notados", "sin_golden", "encima")}
    print(
        "\n| lista | plantados | notados | % | notados sin golden | % | y con lo de encima | % |\n" + "|---" * 8 + "|"
    )
    for lista, c in {**listas, "total": total}.items():
        cuantos = (c["notados"], c["sin_golden"], c["sin_golden"] + c["encima"])
        por_ciento = [100 * n / max(c["plantados"], 1) for n in cuantos]
        celdas = [f"{n} | {p:.1f}" for n, p in zip(cuantos, por_ciento)]
        print(f"| {lista} | {c['plantados']} | {' | '.join(celdas)} |")
    return por_ciento


def elige(todos, plantados, pedidos):
    """Los que se piden."""
    if pedidos == ["pendientes"]:
        return plantados.pendientes()
    for pedido in pedidos:
        if not any(m.es_de(pedido) for m in todos):
            sys.exit(
                f"muta: no hay ningún mutante en «{pedido}»; vale un capítulo (ch05), un programa, un fichero, "
                f"{todos[0].nombre} o «pendientes»"
            )
    return [m for m in todos if not pedidos or any(m.es_de(pedido) for pedido in pedidos)]


def segun_acaban(hilos, prueba, mutantes):
    """Uno que no acaba no retrasa que se apunten los demás."""
    return (hecho.result() for hecho in as_completed([hilos.submit(prueba, m) for m in mutantes]))


def planta(vivero, raiz, build, elegidos, capitulos):
    """Los devuelve según acaban, notados o no. De un capítulo que se pide, solo sus pruebas; lo de common/ lo usan
    todos."""
    en_copia = [m for m in elegidos if m.en_copia]
    compilados = [m for m in elegidos if not m.en_copia]
    if compilados:
        aviso(f"compilo con {len(vivero.mutantes)} mutantes dentro…")
        vivero.copia_arbol()
        vivero.compila(capitulos)
    with tempfile.TemporaryDirectory() as temporal, ThreadPoolExecutor(vivero.procesos) as hilos:
        os.environ["TMPDIR"] = temporal  # lo que deje una prueba que no acaba bien
        os.chmod(temporal, 0o755)  # hay pruebas en que lo lee otro usuario
        if compilados:
            vivero.sin_mutantes(vivero.enumera(capitulos), hilos)
        yield from segun_acaban(hilos, vivero.prueba, compilados)
        if en_copia:
            procesos.ejecuta(["cmake", "--build", build])  # usan lo que hay
        suyas = dict.fromkeys(p for m in en_copia for p in las_que_lo_notan(m))
        list(hilos.map(lambda p: prueba_en_copia(raiz, build, temporal, [p]), suyas))  # sin ninguno

        def en_ella(m):
            return prueba_en_copia(raiz, build, temporal, las_que_lo_notan(m), m, vivero.notan)

        yield from segun_acaban(hilos, en_ella, en_copia)


def juzga(elegidos, plantados):
    """Que no sobreviva ninguno sin motivo y, si ya están todos plantados, que se noten los que se deben."""
    notados, independientes, sin_imagen = resume(plantados.cuentas())
    print("", *(cuenta(m) for m in elegidos if not m.notado), sep="\n")
    aviso(f"apuntado en {FICHERO}; ./lab lista --docs lo lleva a docs/exactitud.md")
    mal = [m.nombre for m in elegidos if bool(m.notado and not m.lo_nota_otro) == bool(m.motivo)]
    if mal:
        sys.exit(f"muta: sobreviven sin motivo, o se notan y tienen uno: {', '.join(mal)}")
    quedan = plantados.pendientes()
    if quedan:
        return aviso(f"quedan {len(quedan)} pendientes: ./lab muta pendientes")
    if notados < META or sin_imagen < META_SIN_IMAGEN or independientes < META_INDEPENDIENTE:
        sys.exit(
            f"muta: se deben notar el {META} %; sin mirar las imágenes, el {META_SIN_IMAGEN} %; y sin lo de encima, el "
            f"{META_INDEPENDIENTE} %"
        )


def main():
    raiz, build = (Path(p).resolve() for p in sys.argv[1:3])
    pedidos = sys.argv[3:]
    todos, fallos = lee_listas(raiz)
    fallos = comprueba(raiz, catalogo.lee_programas(build), todos, fallos)
    if fallos:
        sys.exit("\n".join([*fallos, "muta: la lista de mutantes tiene errores"]))
    plantados = Plantados(raiz, todos)
    if pedidos == ["--comprueba"]:
        print(f"{len(todos)} mutantes, y todos se pueden plantar")
        quedan = " ".join(m.nombre for m in plantados.pendientes())
        return print(
            f"sin plantar desde que cambiaron ellos o su fichero (./lab muta pendientes): {quedan or 'ninguno'}"
        )
    elegidos = elige(todos, plantados, pedidos)
    for m in elegidos:
        m.antes = plantados.quien(m)
    vivero = Vivero(raiz, build / "mutantes", [m for m in todos if not m.en_copia], plantados.lo_notan())
    capitulos = {"jueces" if m.lista == "jueces" else capitulo(m.fichero) for m in elegidos if not m.en_copia}
    if not pedidos or "comun" in capitulos:
        capitulos = set()
    for i, m in enumerate(planta(vivero, raiz, build, elegidos, capitulos), 1):
        plantados.apunta(m)
        print(f"[{i}/{len(elegidos)}] {cuenta(m)}", flush=True)
    juzga(elegidos, plantados)


if __name__ == "__main__":
    principal(main)
