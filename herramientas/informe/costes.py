"""Lo que cuestan los programas: arrancar, cada imagen y lo que ocupan. Y en qué máquina se ha medido."""
import math
import os
import platform
import random
import re
import resource
import statistics
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

from base import catalogo, evidencia
from base.procesos import ejecuta, escribe, por_donde

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


def mide_imagen(programa, build, talla, carpeta):
    """Los campos que escribe con -mide."""
    orden = [programa.ejecutable(build), "-geometry", talla, "-mide", "5", "-ppm", "x.ppm"]
    return ejecuta(orden, cwd=carpeta, text=True).splitlines()[-1].split("\t")


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
            por_donde(f"costes: ronda {ronda} de {rondas}")
            veces = [milisegundos([suelo, "x.ppm"], carpeta) for _ in range(9)] if suelo.exists() else [math.nan]
            suelos.append(statistics.median(veces))
            for p in azar.sample(programas, len(programas)):
                orden = [p.ejecutable(build), "-geometry", "240x180", "-ppm", "x.ppm"]
                arranques[p.nombre].append(milisegundos(orden, carpeta))
        for n, p in enumerate(programas, 1):
            por_donde(f"costes {n}/{len(programas)}: {p.nombre}")
            campos = [mide_imagen(p, build, talla, carpeta) for talla in TALLAS]
            ms = [float(c[3]) for c in campos]
            suyos, ultimos = arranques[p.nombre], campos[-1]
            veces_suelo = [a / s for a, s in zip(suyos, suelos)]
            ocupa = (int(ultimos[c]) for c in (6, 8, 9))
            errores = evidencia.errores(comprobado.get(p.nombre, {}))
            arranque, primera = statistics.median(suyos), float(ultimos[2])
            tabla.append(Coste(p.nombre, arranque, primera, veces_suelo, ms, ms[-1] / llenar, *ocupa, errores))
    por_donde()
    escribe(destino / "costes.tsv", en_tsv(tabla))
    return tabla, suelos if suelo.exists() else []


COLUMNAS = "programa,arranque ms,primera ms,veces el suelo,ms 960x720,ms 1920x1080,veces llenar,primitivas,"
COLUMNAS += "bytes de buffers,bytes de texturas,error máximo,error RMSE,borde px"


def en_tsv(tabla):
    filas = [COLUMNAS.split(",")]
    for c in tabla:
        tiempos = f"{c.arranque:.1f}", f"{c.primera:.1f}", f"{statistics.median(c.veces_suelo):.2f}"
        imagen = *(f"{x:.1f}" for x in c.ms), f"{c.veces_llenar:.1f}"
        ocupa = c.primitivas, c.buferes, c.texturas
        filas.append((c.programa, *tiempos, *imagen, *ocupa, *(e or "-" for e in c.errores)))
    return "".join("\t".join(map(str, fila)) + "\n" for fila in filas)


def entorno(build):
    dice = Path("/proc/cpuinfo")
    cpu = re.search(r"model name\s*: (.*)", dice.read_text() if dice.exists() else "")
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
