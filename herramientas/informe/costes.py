"""Lo que cuestan los programas: arrancar, cada imagen, lo que ocupan, compilarlos y probarlos. Y en qué máquina se ha
medido."""
import math
import os
import platform
import random
import re
import resource
import statistics
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

from base import catalogo, evidencia
from base.compilacion import ordenes
from base.procesos import ejecuta, escribe
from informe.cocientes import IGUALES, Cociente

TALLAS = ("960x720", "1920x1080")


@dataclass
class Coste:
    programa: str
    arranque: float  # ms de procesador de arrancar a tener el PPM de 240×180
    primera: float  # los de la primera imagen, con lo que se compila al dibujarla
    veces_suelo: list  # el arranque entre el del suelo, en cada ronda
    ms: list  # por imagen, en cada una de TALLAS
    veces_llenar: float  # la mayor, entre llenarla de un color
    primitivas: int
    buferes: int
    texturas: int
    errores: list  # máximo, RMSE y borde frente a su oráculo: los de docs/exactitud.md


def milisegundos(orden, carpeta):
    """Los de procesador, que no cuentan los ratos en que corre otro."""
    antes = resource.getrusage(resource.RUSAGE_CHILDREN)
    ejecuta(orden, cwd=carpeta)
    despues = resource.getrusage(resource.RUSAGE_CHILDREN)
    return 1000 * (despues.ru_utime + despues.ru_stime - antes.ru_utime - antes.ru_stime)


def avisa(texto, fin="\n"):
    """Por dónde va: en una terminal, en la misma línea."""
    print(
        f"\r\033[K{texto}" if sys.stderr.isatty() else texto,
        end=fin if sys.stderr.isatty() else "\n",
        file=sys.stderr,
        flush=True,
    )


def costes(raiz, build, destino, llenar, rondas=9):
    """Cada programa: lo que tarda en arrancar frente al suelo, por rondas en otro orden cada vez; y por imagen, con
    -mide."""
    suelo = build / "herramientas/mide/suelo_osmesa"
    programas = [p for p in catalogo.lee_programas(build) if not p.consola]
    comprobado = evidencia.lee(raiz)["programas"]
    azar = random.Random(1)
    tabla, suelos, arranques = [], [], {p.nombre: [] for p in programas}
    with tempfile.TemporaryDirectory() as carpeta:
        for ronda in range(1, rondas + 1):
            avisa(f"costes: ronda {ronda} de {rondas}", "")
            suelos.append(
                statistics.median(milisegundos([suelo, "x.ppm"], carpeta) for _ in range(9))
                if suelo.exists()
                else math.nan
            )
            for p in azar.sample(programas, len(programas)):
                arranques[p.nombre].append(
                    milisegundos([p.ejecutable(build), "-geometry", "240x180", "-ppm", "x.ppm"], carpeta)
                )
        for n, p in enumerate(programas, 1):
            avisa(f"costes {n}/{len(programas)}: {p.nombre}", "")
            ms = []
            for talla in TALLAS:
                campos = (
                    ejecuta(
                        [p.ejecutable(build), "-geometry", talla, "-mide", "5", "-ppm", "x.ppm"], cwd=carpeta, text=True
                    )
                    .splitlines()[-1]
                    .split("\t")
                )
                ms.append(float(campos[3]))
            suyos = arranques[p.nombre]
            tabla.append(
                Coste(
                    p.nombre,
                    statistics.median(suyos),
                    float(campos[2]),
                    [a / s for a, s in zip(suyos, suelos)],
                    ms,
                    ms[-1] / llenar,
                    int(campos[6]),
                    int(campos[8]),
                    int(campos[9]),
                    evidencia.errores(comprobado.get(p.nombre, {})),
                )
            )
    avisa(f"costes: {len(tabla)} programas")
    escribe(destino / "costes.tsv", en_tsv(tabla))
    return tabla, suelos if suelo.exists() else []


def en_tsv(tabla):
    filas = [
        (
            "programa",
            "arranque ms",
            "primera ms",
            "veces el suelo",
            *(f"ms {t}" for t in TALLAS),
            "veces llenar",
            "primitivas",
            "bytes de buffers",
            "bytes de texturas",
            "error máximo",
            "error RMSE",
            "borde px",
        )
    ]
    for c in tabla:
        filas.append(
            (
                c.programa,
                f"{c.arranque:.1f}",
                f"{c.primera:.1f}",
                f"{statistics.median(c.veces_suelo):.2f}",
                *(f"{x:.1f}" for x in c.ms),
                f"{c.veces_llenar:.1f}",
                c.primitivas,
                c.buferes,
                c.texturas,
                *(e or "-" for e in c.errores),
            )
        )
    return "".join("\t".join(map(str, fila)) + "\n" for fila in filas)


def compilacion(build, suelo):
    """(qué, cifra con su unidad): compilar un programa, con la cabecera precompilada y sin ella; y pasar los golden.
    Además, el Cociente de lo que cuesta un golden entre el suelo, que es de una sola vez: con un 10 % arriba o abajo.
    """
    de_programas = [
        orden for fuente, orden in ordenes(build).items() if re.fullmatch(r"ch\d\d_\w+", fuente.parent.name)
    ]
    con, sin = [], []
    for orden in de_programas[::9]:
        con.append(milisegundos(orden, build) / 1000)
        i = orden.index("-include")
        sin.append(milisegundos(orden[:i] + orden[i + 2 :], build) / 1000)
    filas = [
        ("compilar un programa", f"{statistics.median(con):.2f} s de procesador"),
        ("sin la cabecera precompilada", f"{statistics.median(sin):.2f} s de procesador"),
        ("fuentes de programas", f"{len(de_programas)}"),
    ]
    golden = None
    sin_ventana = (build / "sin_ventana").read_text().strip()
    orden = ["ctest", "--test-dir", build, "-j", str(os.cpu_count()), "-R", rf"^imagen\.{sin_ventana}\."]
    casos = int(re.search(r"Total Tests: (\d+)", ejecuta([*orden, "-N"], text=True))[1])
    if casos and (build / "herramientas/comparador/compara").exists():
        ms = milisegundos(orden, build) / casos
        filas.append((f"pasar los {casos} golden", f"{ms:.0f} ms de procesador cada uno"))
        veces = ms / statistics.median(suelo) if suelo else math.nan
        golden = Cociente(veces / IGUALES, veces, veces * IGUALES) if suelo else None
    return filas, golden


def entorno(build):
    cpu = (
        re.search(r"model name\s*: (.*)", Path("/proc/cpuinfo").read_text()) if Path("/proc/cpuinfo").exists() else None
    )
    sin_ventana = (build / "sin_ventana").read_text().strip()
    info = ejecuta([build / sin_ventana / "ch01_intro" / "info_opengl"], text=True).splitlines()
    return {
        "procesador": f"{cpu[1] if cpu else platform.machine()}, {os.cpu_count()} núcleos",
        "carga al empezar": f"{os.getloadavg()[0]:.2f}",
        "OpenGL": " · ".join(linea.strip() for linea in info[:3]),
        "sin ventana": sin_ventana,
        "compilador": ejecuta([os.environ.get("CXX", "c++"), "--version"], text=True).splitlines()[0],
        "caché de shaders": "sin ella" if os.environ.get("MESA_SHADER_CACHE_DISABLE") == "true" else "la de Mesa",
        "pares": "sí" if os.environ.get("LAB_PARES") else "no",
        "fecha": time.strftime("%Y-%m-%d %H:%M"),
    }
