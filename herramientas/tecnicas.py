"""Las técnicas de ./lab mide: sus variantes, cuáles están en el frente de Pareto y cuál usan los programas."""
import math
import os
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

import grafica
from procesos import Fallo, ejecuta, escribe

CABECERA = "variante\tgrupo\tmediana\tmínimo\tmáximo\terror\tnota"


@dataclass
class Variante:
    nombre: str
    grupo: str
    mediana: float
    minimo: float
    maximo: float
    error: float
    nota: str
    elegida: bool = False
    optima: bool = False  # en el frente de Pareto de su grupo: ninguna tan exacta tarda menos que su mejor vuelta
    imagen: str = ""

    @property
    def par(self):
        return self.nombre.startswith("par: ")


@dataclass
class Tecnica:
    nombre: str
    titulo: str
    tiempo: str
    error: str
    elegida: str
    por_que: str
    variantes: list = field(default_factory=list)
    imagenes: list = field(default_factory=list)

    @property
    def frente_a_pares(self):
        """(par, elegida, cuántas veces tarda el par lo que la elegida, cuántas veces se equivoca)."""
        return [(par, v, par.mediana / v.mediana, par.error / v.error if v.error else math.nan)
                for par in self.variantes if par.par for v in self.variantes if v.elegida and v.grupo == par.grupo]

    @property
    def elegida_fuera(self):
        return [v for v in self.variantes if v.elegida and not v.optima]


def lee_variantes(fichero):
    """Una fila por variante, con siete columnas: si no, el TSV está mal formado."""
    variantes = []
    for fila in fichero.read_text().splitlines():
        campos = fila.split("\t")
        if len(campos) != 7 or "" in campos:
            raise Fallo(f"{fichero.name}: una fila no tiene siete columnas: «{fila}»")
        v = Variante(campos[0], "" if campos[1] == "-" else campos[1], *map(float, campos[2:6]), "" if campos[6] == "-" else campos[6])
        if not 0 < v.minimo <= v.mediana <= v.maximo < math.inf or v.error < 0:
            raise Fallo(f"{fichero.name}: los números de «{v.nombre}» no tienen sentido")
        variantes.append(v)
    if len({v.nombre for v in variantes}) != len(variantes) or not variantes:
        raise Fallo(f"{fichero.name}: hay variantes repetidas o ninguna")
    return variantes


def marca(tecnica):
    """Las del frente de Pareto, grupo a grupo, y las que usan los programas."""
    for v in tecnica.variantes:
        v.elegida = bool(tecnica.elegida) and (v.nombre + ",").startswith(tecnica.elegida + ",")
        rivales = [r for r in tecnica.variantes if r.grupo == v.grupo and not r.par]
        v.optima = not math.isnan(v.error) and not any(r.mediana < v.minimo and r.error <= v.error for r in rivales)


def imagenes(tecnica, carpeta, destino):
    """La mejor, la elegida y la peor, cada una con su diferencia con lo exacto por ocho."""
    con_imagen = []
    for n, v in enumerate(tecnica.variantes, 1):
        if (carpeta / f"{tecnica.nombre}-{n}.ppm").exists():
            con_imagen.append((v, n))
    if not con_imagen:
        return
    por_error = sorted(con_imagen, key=lambda vn: vn[0].error)
    ensena = {"la mejor": por_error[0], "la elegida": next((vn for vn in con_imagen if vn[0].elegida), por_error[0]), "la peor": por_error[-1]}
    for papel, (v, n) in ensena.items():
        ficheros = []
        for sufijo in ("", "-diferencia"):
            ppm = carpeta / f"{tecnica.nombre}-{n}{sufijo}.ppm"
            if ppm.exists():
                png = destino / f"{ppm.stem}.png"
                escribe(png, ejecuta(["pnmtopng", "-quiet", ppm]))
                ficheros.append(png.name)
        tecnica.imagenes.append((papel, v, ficheros))


def mide(ejecutable, tecnica, destino, ensayo):
    with tempfile.TemporaryDirectory() as temporal:
        carpeta = Path(temporal)
        ejecuta([ejecutable, *(["--ensayo"] if ensayo else []), carpeta, tecnica.nombre], env={**os.environ, "TMPDIR": temporal})
        tecnica.variantes = lee_variantes(carpeta / f"{tecnica.nombre}.tsv")
        marca(tecnica)
        if tecnica.elegida and not any(v.elegida for v in tecnica.variantes):
            raise Fallo(f"ninguna variante se llama «{tecnica.elegida}»")
        if ensayo:
            return
        escribe(destino / f"{tecnica.nombre}.tsv", CABECERA + "\n" + (carpeta / f"{tecnica.nombre}.tsv").read_text())
        imagenes(tecnica, carpeta, destino)
        grafica.dibuja(tecnica, destino / f"{tecnica.nombre}.svg")
