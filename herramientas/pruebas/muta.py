"""muta.py RAÍZ BUILD AL_AZAR SEMILLA COMPRUEBA [QUÉ…]: defectos plantados en los programas y en lo que
llevan dentro, para saber si las pruebas los notan: los de las listas (base/defectos.py dice cómo son) o AL_AZAR, de
las líneas de los programas, sus shaders, common/ y glut/ (azar.py).

Todos se compilan a la vez en una copia del árbol, en BUILD/mutantes; un shader estropeado va en una carpeta, y
$LAB_RAIZ hace que se mire antes que las demás. Primero se ejecutan sin ninguno las pruebas y los casos, que deben pasar
y apuntan lo que usan; después, con cada mutante, los que lo usan, hasta que uno falle: las de su capítulo, las demás y,
si ninguna lo nota, los pasos y los casos: por lo que pintan encima (los .encima) o, si no, solo por su imagen.
"""
import os
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
from pruebas import azar
from pruebas.googletest import pruebas_de

GOLDEN, ENCIMA = "golden", "encima"
DISTINTO_ENCIMA = 4  # con que acaba casos.sh si es distinto lo que se pinta encima
SOBRA = "build", "galeria", "informe", "web", "windows", "mios", ".git"  # de una copia del árbol


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
    return not capitulos or capitulo(prueba) in capitulos or prueba.startswith("dificil_")


def comprueba(raiz, mutantes):
    """De cada fichero, lo primero que impide plantar los suyos; un shader estropeado que no compila lo notaría
    cualquiera."""
    for fichero, grupo in por_fichero(mutantes).items():
        try:
            fuente = (raiz / fichero).read_text()
            for m in grupo:
                if m.en_shader:
                    yield from (f"{m.nombre}: {d}" for d in no_compila_glsl(raiz, fichero, estropea(fuente, m)))
            if not grupo[0].en_shader:
                cambia(fuente, grupo)
        except (OSError, ValueError) as error:
            yield f"{fichero}: {error}"


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


class Vivero:
    """La copia del árbol con todos los mutantes, compilada."""

    def __init__(self, raiz, carpeta, mutantes):
        self.raiz, self.copia, self.build, self.mutantes = raiz, carpeta / "fuente", carpeta / "build", mutantes
        self.notan = Counter()  # de cada fichero, cuántos ha notado cada prueba: la que más, antes

    def copia_arbol(self):
        """Solo se escribe lo que cambia: así se vuelve a compilar solo eso."""
        grupos = por_fichero(self.mutantes)

        def pon(origen, destino):
            fichero, contenido = Path(origen).relative_to(self.raiz), Path(origen).read_bytes()
            suyos = [m for m in grupos[str(fichero)] if not m.en_shader]
            if suyos:
                contenido = cambia(contenido.decode(), suyos).encode()
            if suyos or fichero.match("tests/*/*_test.cpp"):  # una puede incluir un fuente dentro de un namespace
                incluye = (os.path.relpath(f, fichero.parent) for f in (MUTANTE_H, azar.OTRO_FACTOR))
                contenido = "".join(f'#include "{f}"\n' for f in incluye).encode() + contenido
            if not os.path.isfile(destino) or Path(destino).read_bytes() != contenido:
                Path(destino).unlink(missing_ok=True)  # puede ser de solo lectura, como el original
                Path(destino).write_bytes(contenido)
                shutil.copymode(origen, destino)

        sobra = {str(self.raiz): SOBRA}
        como = {"ignore": lambda carpeta, _: sobra.get(carpeta, ["__pycache__"]), "copy_function": pon}
        shutil.copytree(self.raiz, self.copia, dirs_exist_ok=True, **como)
        for viejo in self.copia.rglob("*"):
            if viejo.is_file() and not (self.raiz / viejo.relative_to(self.copia)).is_file():
                viejo.unlink()
        shutil.rmtree(self.build / "glsl", ignore_errors=True)
        for m in self.mutantes:
            if m.en_shader:
                destino = self.build / "glsl" / str(m.numero) / m.fichero
                destino.parent.mkdir(parents=True)
                destino.write_text(estropea((self.raiz / m.fichero).read_text(), m))

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
        finitos = ["finitos"] if self.sin_ventana == "osmesa" else []  # con ello van las propiedades
        programas = (f"{p.nombre}_{self.sin_ventana}" for p in self.programas)
        que = [*(pruebas if capitulos else ["tests/all"]), "compara", *finitos, *programas]
        self.orden("ninja", "-k", "0", "-C", self.build, *que)

    def orden(self, *palabras):
        proceso = lanza(palabras, cwd=self.copia, text=True, stderr=subprocess.STDOUT)
        if proceso.returncode:
            print(*(linea for linea in proceso.stdout.splitlines() if linea[:1] != "["), sep="\n", file=sys.stderr)
            sys.exit("muta: no se ha podido compilar con los mutantes dentro")

    def enumera(self, capitulos):
        """Cada TEST y cada caso de esos capítulos, o todos, que son lo que se ejecuta."""
        pruebas, entorno, casos = [], procesos.entorno(self.build), self.copia / "tests/casos/casos.sh"
        for ejecutable in sorted(self.build / "tests" / f.stem for f in self.copia.glob("tests/*/*_test.cpp")):
            for nombre in pruebas_de(ejecutable) if es_de(ejecutable.name, capitulos) else ():
                orden = [ejecutable, f"--gtest_filter={nombre}"]
                pruebas.append(Prueba(f"{ejecutable.name[:-5]}.{nombre}", orden, {}, False))
        for p in self.programas:
            de = capitulo(p.capitulo.nombre)
            if p.consola or capitulos and de not in capitulos:
                continue
            propiedades = self.copia / "tests/propiedades/propiedades.py"
            orden = [sys.executable, "-B", propiedades, self.copia, self.build, p.nombre]
            pruebas.append(Prueba(f"{de} propiedades.{p.nombre}", orden, entorno, False))
            if (self.copia / f"tests/golden/{p.capitulo.nombre}/{p.nombre}.pasos").exists():
                pruebas.append(Prueba(f"{de} pasos.{p.nombre}", [casos, self.build, "pasos", p.nombre], entorno, True))
            for caso in p.casos:
                orden = [casos, self.build, self.sin_ventana, p.nombre, caso.nombre]
                pruebas.append(Prueba(f"{de} golden {p.nombre}.{caso.nombre}", orden, entorno, True))
        return pruebas

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
            procesos.por_donde(f"{i}/{len(pruebas)}")
            if not pasa:
                malas.append(p)
        procesos.por_donde()
        for p in malas:
            print(f"{p.nombre}: falla sin ningún mutante\n{p.salida[-1000:]}")
        if malas:
            sys.exit(f"muta: {len(malas)} pruebas fallan sin ningún mutante")
        for m in self.mutantes:
            visto = m.fichero if m.en_shader else str(m.numero)
            suyas = (p for p in pruebas if visto in p.vistos)
            m.pruebas = sorted(suyas, key=lambda p: (p.golden, p.capitulo != capitulo(m.fichero), p.segundos))

    def prueba(self, mutante):
        numero = str(mutante.numero)
        entorno = {"LAB_RAIZ": str(self.build / "glsl" / numero)} if mutante.en_shader else {"LAB_MUTANTE": numero}

        for prueba in sorted(mutante.pruebas, key=lambda p: (p.golden, -self.notan[mutante.fichero, p.nombre])):
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
        resultado = "SOBREVIVE" if mutante.pruebas else "SOBREVIVE, nada lo ejecuta"
    motivo = f" ({mutante.motivo})" if mutante.motivo else ""
    return f"{mutante.nombre:<11} {mutante.fichero}, {mutante.imita}: {resultado}{motivo}"


def resume(elegidos):
    """Cuántos se notan, sin mirar las imágenes y sin lo de encima, en tantos por ciento."""
    total = max(len(elegidos), 1)
    notados = [m for m in elegidos if m.notado]
    sin_imagen = [m for m in notados if m.por != GOLDEN]
    independientes = [m for m in sin_imagen if m.por != ENCIMA]
    cuantos = [len(lista) for lista in (notados, sin_imagen, independientes)]
    dice = [f"{n} ({100 * n / total:.1f} %)" for n in cuantos]
    print("\n{} defectos; notados, {}; sin mirar las imágenes, {}; ni lo de encima, {}".format(len(elegidos), *dice))


def elige(todos, pedidos):
    """Los que se piden."""
    for pedido in pedidos:
        if not any(m.es_de(pedido) for m in todos):
            sys.exit(
                f"muta: no hay ningún mutante en «{pedido}»; vale un capítulo (ch05), un programa, un fichero o "
                f"{todos[0].nombre}"
            )
    return [m for m in todos if not pedidos or any(m.es_de(pedido) for pedido in pedidos)]


def planta(vivero, elegidos, capitulos):
    """Los devuelve según acaban, notados o no: uno que no acaba no retrasa que se digan los demás. De un capítulo que
    se pide, solo sus pruebas; lo de common/ lo usan todos."""
    aviso(f"compilo con {len(vivero.mutantes)} mutantes dentro…")
    vivero.copia_arbol()
    vivero.compila(capitulos)
    with tempfile.TemporaryDirectory() as temporal, ThreadPoolExecutor(os.cpu_count()) as hilos:
        os.environ["TMPDIR"] = temporal  # lo que deje una prueba que no acaba bien
        vivero.sin_mutantes(vivero.enumera(capitulos), hilos)
        for hecho in as_completed([hilos.submit(vivero.prueba, m) for m in elegidos]):
            yield hecho.result()


def juzga(elegidos, al_azar):
    """De las listas, que no sobreviva ninguno sin motivo; al azar solo se cuenta."""
    resume(elegidos)
    print("", *(cuenta(m) for m in elegidos if not m.notado), sep="\n")
    if al_azar:
        return
    mal = [m.nombre for m in elegidos if bool(m.notado and not m.lo_nota_otro) == bool(m.motivo)]
    if mal:
        sys.exit(f"muta: sobreviven sin motivo, o se notan y tienen uno: {', '.join(mal)}")


def main():
    raiz, build = (Path(p).resolve() for p in sys.argv[1:3])
    cuantos, semilla, solo_comprueba = map(int, sys.argv[3:6])
    pedidos = sys.argv[6:]
    listas = raiz / "herramientas/ejercicios/errores", raiz / "tests/mutantes"  # los de un estudiante y los demás
    todos, fallos = lee(*() if cuantos else listas)
    fallos += comprueba(raiz, todos)
    if fallos:
        sys.exit("\n".join([*fallos, "muta: la lista de mutantes tiene errores"]))
    if solo_comprueba:
        return print(f"{len(todos)} mutantes, y todos se pueden plantar")
    if cuantos:
        aviso(f"elijo {cuantos} al azar, con la semilla {semilla}…")
        todos = elegidos = azar.elige(raiz, build.parent, cuantos, semilla, no_compila_glsl)
    else:
        elegidos = elige(todos, pedidos)
    vivero = Vivero(raiz, build / "mutantes", todos)
    capitulos = {capitulo(m.fichero) for m in elegidos}
    if cuantos or not pedidos or "comun" in capitulos:
        capitulos = set()
    for i, m in enumerate(planta(vivero, elegidos, capitulos), 1):
        print(f"[{i}/{len(elegidos)}] {cuenta(m)}", flush=True)
    juzga(elegidos, cuantos)


if __name__ == "__main__":
    principal(main)
