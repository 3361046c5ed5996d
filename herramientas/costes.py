"""Lo que cuestan los programas: arrancar, cada imagen, lo que ocupan, compilarlos y probarlos. Y en qué máquina se ha medido."""
import math
import os
import platform
import re
import resource
import statistics
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

import catalogo
import medidas
from procesos import ejecuta, escribe

TALLAS = ("960x720", "1920x1080")


@dataclass
class Coste:
    programa: str
    arranque: float  # ms de arrancar a tener el PPM de 240×180
    primera: float  # los de la primera imagen, con lo que se compila al dibujarla
    veces_suelo: float
    ms: list  # por imagen, en cada una de TALLAS
    veces_llenar: float  # la mayor, entre llenarla de un color
    primitivas: int
    buferes: int
    texturas: int
    errores: list  # máximo, RMSE y borde frente a su oráculo: los de docs/exactitud.md


def cronometra(orden, carpeta):
    antes = time.perf_counter()
    ejecuta(orden, cwd=carpeta)
    return 1000 * (time.perf_counter() - antes)


def avisa(texto, fin="\n"):
    """Por dónde va: en una terminal, en la misma línea."""
    print(f"\r\033[K{texto}" if sys.stderr.isatty() else texto, end=fin if sys.stderr.isatty() else "\n", file=sys.stderr, flush=True)


def costes(raiz, build, destino, llenar, vueltas=5):
    """Cada programa: lo que tarda en arrancar frente al suelo, alternados; y por imagen, con -mide."""
    suelo = build / "herramientas/mide/suelo_osmesa"
    programas = [p for p in catalogo.lee_programas(build) if not p.consola]
    comprobado = medidas.lee(raiz)["programas"]
    tabla, suelos = [], []
    with tempfile.TemporaryDirectory() as carpeta:
        for n, p in enumerate(programas, 1):
            avisa(f"costes {n}/{len(programas)}: {p.nombre}", "")
            ejecutable = p.ejecutable(build)
            arranques, ms = [], []
            for _ in range(vueltas):
                if suelo.exists():
                    suelos.append(cronometra([suelo, "x.ppm"], carpeta))
                arranques.append(cronometra([ejecutable, "-geometry", "240x180", "-ppm", "x.ppm"], carpeta))
            for talla in TALLAS:
                campos = ejecuta([ejecutable, "-geometry", talla, "-mide", "5", "-ppm", "x.ppm"], cwd=carpeta, text=True).splitlines()[-1].split("\t")
                ms.append(float(campos[3]))
            tabla.append(Coste(p.nombre, statistics.median(arranques), float(campos[2]), math.nan, ms, ms[-1] / llenar, int(campos[6]), int(campos[8]),
                               int(campos[9]), medidas.errores(comprobado.get(p.nombre, {}))))
    avisa(f"costes: {len(tabla)} programas")
    suelo = statistics.median(suelos) if suelos else math.nan
    for c in tabla:
        c.veces_suelo = c.arranque / suelo
    escribe(destino / "costes.tsv", en_tsv(tabla))
    return tabla, suelo


def en_tsv(tabla):
    filas = [("programa", "arranque ms", "primera ms", "veces el suelo", *(f"ms {t}" for t in TALLAS), "veces llenar", "primitivas", "bytes de buffers",
              "bytes de texturas", "error máximo", "error RMSE", "borde px")]
    for c in tabla:
        filas.append((c.programa, f"{c.arranque:.1f}", f"{c.primera:.1f}", f"{c.veces_suelo:.2f}", *(f"{x:.1f}" for x in c.ms), f"{c.veces_llenar:.1f}",
                      c.primitivas, c.buferes, c.texturas, *(e or "-" for e in c.errores)))
    return "".join("\t".join(map(str, fila)) + "\n" for fila in filas)


def segundos_de_cpu(orden, carpeta):
    antes = resource.getrusage(resource.RUSAGE_CHILDREN)
    ejecuta(orden, cwd=carpeta)
    despues = resource.getrusage(resource.RUSAGE_CHILDREN)
    return despues.ru_utime + despues.ru_stime - antes.ru_utime - antes.ru_stime


def compilacion(build):
    """(qué, cifra con su unidad): compilar un programa, con la cabecera precompilada y sin ella; y pasar los golden. Además, los ms
    de un núcleo por golden."""
    ordenes = {}
    for linea in ejecuta(["ninja", "-C", build, "-t", "commands", "programas"], text=True).splitlines():
        if re.search(r"-c \S+/ch\d\d_\w+/\w+\.cpp$", linea):
            ordenes[linea.split("/")[-1]] = [x for x in linea.split() if x != "ccache"]
    con, sin = [], []
    for orden in list(ordenes.values())[::9]:
        con.append(segundos_de_cpu(orden, build))
        i = orden.index("-include")
        sin.append(segundos_de_cpu(orden[:i] + orden[i + 2:], build))
    filas = [("compilar un programa", f"{statistics.median(con):.2f} s de procesador"),
             ("sin la cabecera precompilada", f"{statistics.median(sin):.2f} s de procesador"),
             ("fuentes de programas", f"{len(ordenes)}")]
    ms = None
    if (build / "tests" / "compara").exists():
        sin_ventana = (build / "sin_ventana").read_text().strip()
        antes = time.perf_counter()
        salida = ejecuta(["ctest", "--test-dir", build, "-j", str(os.cpu_count()), "-R", rf"^imagen\.{sin_ventana}\."], text=True)
        segundos, casos = time.perf_counter() - antes, int(re.search(r"out of (\d+)", salida)[1])
        ms = 1000 * segundos * os.cpu_count() / casos
        filas.append((f"pasar los {casos} golden", f"{segundos:.1f} s, con {os.cpu_count()} núcleos: {ms:.0f} ms de núcleo cada uno"))
    return filas, ms


def entorno(build):
    cpu = re.search(r"model name\s*: (.*)", Path("/proc/cpuinfo").read_text()) if Path("/proc/cpuinfo").exists() else None
    sin_ventana = (build / "sin_ventana").read_text().strip()
    info = ejecuta([build / sin_ventana / "ch01_intro" / "info_opengl"], text=True).splitlines()
    return {"procesador": f"{cpu[1] if cpu else platform.machine()}, {os.cpu_count()} núcleos", "carga al empezar": f"{os.getloadavg()[0]:.2f}",
            "OpenGL": " · ".join(linea.strip() for linea in info[:3]), "sin ventana": sin_ventana,
            "compilador": ejecuta([os.environ.get("CXX", "c++"), "--version"], text=True).splitlines()[0],
            "caché de shaders": "sin ella" if os.environ.get("MESA_SHADER_CACHE_DISABLE") == "true" else "la de Mesa",
            "pares": "sí" if os.environ.get("LAB_PARES") else "no", "fecha": time.strftime("%Y-%m-%d %H:%M")}
