"""taller.py BUILD: trae el compilador de la página, si no está ya.

Lo que hace falta para compilar y enlazar un programa en ella: el compilador, que es un paquete de npm
(taller/package-lock.json), las cabeceras, los objetos con que se enlaza y el JavaScript de quien hace el trabajo. El
compilador y lo suyo están en una misma carpeta, que él ve como /usr: sis/ y gl/, las cabeceras; obj/, los objetos.
"""
import hashlib
import io
import json
import os
import re
import shutil
import sys
import tarfile
import zlib
from pathlib import Path

from base.procesos import Fallo, ejecuta, lanza, principal

AQUI = Path(__file__).parent
EMSCRIPTEN = Path("/usr/share/emscripten/cache/sysroot/include")
TROZO = 3 << 19  # bytes de cada fichero en que se parte el compilador: la barra avanza con cada uno
NUCLEOS = "llvm.core2.wasm", "llvm.core3.wasm", "llvm.core4.wasm"  # el primero es el compilador
# De cada carpeta, lo que un programa puede incluir; y cómo la ve él.
CABECERAS = [
    ("sis/c++/v1", EMSCRIPTEN / "c++/v1", r"(?!experimental|ext/|.*\.in$|module|barrier|latch|semaphore)"),
    ("sis/compat", EMSCRIPTEN / "compat", r"(?!.*mmintrin|neon|malloc)"),
    ("sis/sys", EMSCRIPTEN / "sys", ""),
    ("sis/bits", EMSCRIPTEN / "bits", ""),
    ("sis/emscripten", EMSCRIPTEN / "emscripten", "(emscripten|em_asm|em_js|em_macros|heap|version|html5|stack).*h$"),
    ("sis/wasi", EMSCRIPTEN / "wasi", ""),
    ("sis", EMSCRIPTEN, r"(?!elf|libunwind|wasm_simd)[^/]*\.h$"),
]
DEL_COMPILADOR = r"include/(__std|std|float|limits|iso646|inttypes|tgmath|__float|__limits|varargs|unwind)[^/]*\.h$"
DE_GL = [f"GL/{h}.h" for h in "freeglut freeglut_std freeglut_ext freeglut_ucall gl glext glu".split()]
DE_GL.append("KHR/khrplatform.h")
COMENTARIO = re.compile(rb"^[ \t]*//.*$|^typedef .*APIENTRYP PFNGL.*$", re.M)  # y los tipos con que se buscaría OpenGL
HACIA_ARRIBA = re.compile(r'(#\s*include\s*)"((?:\.\./)+[^"]+)"')


def paquete(build):
    """Donde está el compilador, si lo hay."""
    carpeta = build.parent / "taller/node_modules/@yowasp/clang/gen"
    return carpeta if carpeta.is_dir() else None


def sin_comentarios(texto):
    """Los que ocupan una línea, que son casi todos, en blanco: lo que se dice de una cabecera es de su línea."""
    return COMENTARIO.sub(b"", texto)


def sin_subir(donde, texto):
    """Quien lo lee no sabe de «..» en una ruta: desde su carpeta de cabeceras."""
    desde = lambda ruta: os.path.normpath(donde.parent / ruta)
    return HACIA_ARRIBA.sub(lambda m: f"{m[1]}<{desde(m[2])}>", texto)


def comprime(datos):
    """Como zlib, y si está libdeflate, un 4 % menos: el mismo formato, pero le pone la cabecera de gzip."""
    if not shutil.which("libdeflate-gzip"):
        return zlib.compress(datos, 9)
    de_gzip = ejecuta(["libdeflate-gzip", "-12", "-c"], input=datos)
    return b"\x78\xda" + de_gzip[10:-8] + zlib.adler32(datos).to_bytes(4, "big")


class Taller:
    """`build` es la del enlace web."""

    def __init__(self, raiz, build):
        self.raiz, self.build, self.paquete = raiz, build, paquete(build)

    def de_carpeta(self, destino, carpeta, patron):
        for f in sorted(carpeta.rglob("*")):
            dentro = f.relative_to(carpeta)
            if f.is_file() and re.match(patron, str(dentro)):
                yield f"{destino}/{dentro}", sin_comentarios(f.read_bytes())

    def cabeceras(self):
        for destino, carpeta, patron in CABECERAS:
            yield from self.de_carpeta(destino, carpeta, patron)
        enlaces = self.build / "cabeceras"
        for f in DE_GL:
            yield f"gl/{f}", sin_comentarios((enlaces / f).read_bytes())
        for f, texto in self.de_carpeta("glm", (enlaces / "glm").resolve(), r".*\.(hpp|inl|h)$"):
            yield f"gl/{f}", sin_subir(Path(f), texto.decode()).encode()
        yield "gl/GL/glew.h", (self.raiz / "glut/sin_ventana/web/GL/glew.h").read_bytes()
        with tarfile.open(self.paquete / "llvm-resources.tar") as suyas:
            for m in suyas:
                if m.isfile() and re.match(DEL_COMPILADOR, m.name):
                    yield m.name, sin_comentarios(suyas.extractfile(m).read())

    def objetos(self):
        for nombre in ("fijo.o", "main.o"):
            yield f"obj/{nombre}", (self.build / "taller" / nombre).read_bytes()
        comun = self.build / "CMakeFiles/comun.dir"
        for f in comun.rglob("*.o"):
            yield f"obj/comun/{f.relative_to(comun)}", f.read_bytes()
        for f in self.build.glob("CMakeFiles/controles_*.dir/controles/*.o"):
            yield f"obj/controles/{f.name.replace('.cpp', '').removeprefix('propio_')}", f.read_bytes()

    def arbol(self):
        """Todo en un tar, que es como lo toma el compilador: cada carpeta, antes que lo suyo y sin «/» al final."""
        salida, carpetas = io.BytesIO(), set()
        for nombre, datos in [*self.cabeceras(), *self.objetos()]:
            for carpeta in reversed(Path(nombre).parents[:-1]):
                if carpeta not in carpetas:
                    carpetas.add(carpeta)
                    entrada = bytearray(tarfile.TarInfo(str(carpeta)).tobuf())
                    entrada[156:157] = tarfile.DIRTYPE
                    salida.write(entrada)
            fichero = tarfile.TarInfo(nombre)
            fichero.size = len(datos)
            salida.write(fichero.tobuf(tarfile.USTAR_FORMAT) + datos + bytes(-len(datos) % 512))
        salida.write(bytes(1024))
        return salida.getvalue()

    def guiones(self):
        """El de quien compila, el de los programas compilados y qué funciones da este."""
        junta = (
            "--bundle",
            "--external:node:*",
            "--format=iife",
            "--charset=utf8",
            '--define:import.meta.url="http://taller/"',
        )
        entorno = {**os.environ, "NODE_PATH": str(self.paquete.parents[2])}
        obrero = ejecuta(["esbuild", AQUI / "taller/obrero.mjs", "--minify", *junta], env=entorno).decode()
        programa = (self.build / "taller/taller.js").read_text()
        da = re.findall(r'"(\w+)":', re.search(r"asmLibraryArg = \{(.*?)\};", programa, re.S)[1])
        da += [nombre.removeprefix("emscripten_") for nombre in da if nombre.startswith("emscripten_gl")]
        return {
            "obrero": obrero,
            "programa": ejecuta(["esbuild", self.build / "taller/taller.js", "--minify-whitespace"]).decode(),
            "da": sorted({*da}),
            "objetos": [f"/usr/{nombre}" for nombre, _ in self.objetos()],
        }

    def compilador(self):
        """Comprimido: es siempre el mismo, y tarda unos segundos."""
        origen, hecho = self.paquete / "llvm.core.wasm", self.paquete.parents[2] / "compilador.z"
        if not hecho.exists() or hecho.stat().st_mtime < origen.stat().st_mtime:
            hecho.write_bytes(comprime(origen.read_bytes()))
        return hecho.read_bytes()

    def ficheros(self):
        """(nombre, datos ya comprimidos) de cada uno."""
        yield "taller", zlib.compress(json.dumps(self.guiones(), ensure_ascii=False).encode(), 9)
        yield "taller-arbol", zlib.compress(self.arbol(), 9)
        for nucleo in NUCLEOS:
            yield nucleo, zlib.compress((self.paquete / nucleo).read_bytes(), 9)
        compilador = self.compilador()
        for i, n in enumerate(range(0, len(compilador), TROZO)):
            yield f"taller-{i:02}", compilador[n : n + TROZO]


def resumen(ficheros):
    """Lo que la página tiene que saber antes de pedirlos."""
    huella = hashlib.sha256(b"".join(datos for _, datos in ficheros)).hexdigest()[:16]
    nombres = [nombre for nombre, _ in ficheros]
    return {"ficheros": nombres, "bytes": sum(len(datos) for _, datos in ficheros), "version": huella}


def main():
    carpeta = Path(sys.argv[1]) / "taller"
    puesto = carpeta / "puesto.json"
    fijado = AQUI / "taller/package-lock.json"
    if puesto.exists() and puesto.read_bytes() == fijado.read_bytes():
        return
    if not shutil.which("npm"):
        raise Fallo("falta npm, con que se trae el compilador")
    shutil.rmtree(carpeta, ignore_errors=True)
    carpeta.mkdir(parents=True)
    for f in (fijado, fijado.with_name("package.json")):
        shutil.copy(f, carpeta)
    npm = lanza(["npm", "ci", "--prefix", carpeta, "--ignore-scripts", "--no-audit", "--no-fund"], text=True)
    if npm.returncode:
        raise Fallo("no se puede traer el compilador de npm: ¿hay red, o un registro?")
    shutil.copy(fijado, puesto)


if __name__ == "__main__":
    principal(main)
