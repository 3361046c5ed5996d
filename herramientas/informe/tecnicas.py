"""Las técnicas de ./lab mide: sus variantes, cuáles están en el frente de Pareto y cuál usan los programas."""
import math
import os
import statistics
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

from base.procesos import Fallo, ejecuta, en_png, escribe
from informe import grafica
from informe.cocientes import mas_lento

CABECERA = "variante\tgrupo\terror\tnota\ttiempo en cada ronda"


@dataclass
class Variante:
    nombre: str
    grupo: str
    error: float
    nota: str
    tiempos: list  # uno por ronda, las mismas para todas las de su técnica
    elegida: bool = False
    # en el frente de Pareto de su grupo: no hay otra tan exacta que tarde menos; None: no se distingue
    optima: bool | None = False

    def __post_init__(self):
        self.mediana, self.minimo, self.maximo = statistics.median(self.tiempos), min(self.tiempos), max(self.tiempos)

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
    def elegida_fuera(self):
        return [v for v in self.variantes if v.elegida and v.optima is False]


def lee_variantes(fichero):
    """Una fila por variante; si no, el TSV está mal formado."""
    variantes = []
    for fila in fichero.read_text().splitlines():
        try:
            nombre, grupo, error, nota, tiempos = ("" if campo == "-" else campo for campo in fila.split("\t"))
            variantes.append(Variante(nombre, grupo, float(error), nota, [float(t) for t in tiempos.split()]))
        except ValueError:
            raise Fallo(f"{fichero.name}: no entiendo «{fila}»") from None
    son_numeros = all(not v.error < 0 and all(0 < t < math.inf for t in v.tiempos) for v in variantes)
    rondas, nombres = {len(v.tiempos) for v in variantes}, {v.nombre for v in variantes}
    if not son_numeros or len(rondas) != 1 or len(nombres) != len(variantes):
        raise Fallo(f"{fichero.name}: sus números no tienen sentido, o hay variantes repetidas o ninguna")
    return variantes


def marca(tecnica):
    """Las del frente de Pareto, grupo a grupo, y las que usan los programas."""
    for v in tecnica.variantes:
        v.elegida = bool(tecnica.elegida) and (v.nombre + ",").startswith(tecnica.elegida + ",")
        pierde = [
            mas_lento(v.tiempos, r.tiempos)
            for r in tecnica.variantes
            if r.grupo == v.grupo and r is not v and not r.par and r.error <= v.error
        ]
        v.optima = False if math.isnan(v.error) or True in pierde else None if None in pierde else True


def imagenes(tecnica, carpeta, destino):
    """La mejor, la elegida y la peor, cada una con su diferencia con lo exacto por ocho."""
    con_imagen = [
        (v, f"{tecnica.nombre}-{n}")
        for n, v in enumerate(tecnica.variantes, 1)
        if (carpeta / f"{tecnica.nombre}-{n}.ppm").exists()
    ]
    if not con_imagen:
        return
    por_error = sorted(con_imagen, key=lambda una: una[0].error)
    elegida = next((una for una in con_imagen if una[0].elegida), por_error[0])
    for papel, (v, base) in ("la mejor", por_error[0]), ("la elegida", elegida), ("la peor", por_error[-1]):
        suyas = [nombre for nombre in (base, f"{base}-diferencia") if (carpeta / f"{nombre}.ppm").exists()]
        for nombre in suyas:
            escribe(destino / f"{nombre}.png", en_png(carpeta / f"{nombre}.ppm"))
        tecnica.imagenes.append((papel, v, [f"{nombre}.png" for nombre in suyas]))


def mide(ejecutable, tecnica, destino, ensayo):
    with tempfile.TemporaryDirectory() as temporal:
        carpeta = Path(temporal)
        como = ["--ensayo"] if ensayo else []
        ejecuta([ejecutable, *como, carpeta, tecnica.nombre], env={**os.environ, "TMPDIR": temporal})
        tecnica.variantes = lee_variantes(carpeta / f"{tecnica.nombre}.tsv")
        marca(tecnica)
        if tecnica.elegida and not any(v.elegida for v in tecnica.variantes):
            raise Fallo(f"ninguna variante se llama «{tecnica.elegida}»")
        if ensayo:
            return
        escribe(destino / f"{tecnica.nombre}.tsv", CABECERA + "\n" + (carpeta / f"{tecnica.nombre}.tsv").read_text())
        imagenes(tecnica, carpeta, destino)
        grafica.dibuja(tecnica, destino / f"{tecnica.nombre}.svg")
