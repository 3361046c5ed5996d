"""Cocientes de tiempos tomados por rondas: su mediana con su intervalo, y lo que se puede decir de ellos.

Un procesador compartido o portátil cambia de paso al doble en segundos: dos tiempos solo se comparan dentro de una
ronda.
"""
import math
from dataclasses import dataclass
from statistics import median

IGUALES = 1.1  # lo que cambia un tiempo según dónde caiga en la memoria: con menos no se distinguen


@dataclass
class Cociente:
    """La mediana y los extremos de su intervalo del 95 %."""

    menor: float
    mediana: float
    mayor: float

    def cumple(self, pide, mayor=True):
        """Si llega a lo que se pide (o no pasa, con mayor=False): sí, no o, si el intervalo no lo dice, None."""
        if self.menor >= pide if mayor else self.mayor <= pide:
            return True
        return False if (self.mayor < pide if mayor else self.menor > pide) else None


def intervalo(valores):
    """Cociente de esos valores, uno por ronda. Los extremos son los estadísticos de orden entre los que cae la
    mediana con probabilidad 0.95 (binomial, sin suponer ninguna distribución ni remuestrear); con menos de seis, el
    menor y el mayor."""
    v, n = sorted(valores), len(valores)
    fuera = 0
    while fuera < (n - 1) // 2 and sum(math.comb(n, k) for k in range(fuera + 1)) <= 0.025 * 2**n:
        fuera += 1
    fuera = max(fuera - 1, 0)
    return Cociente(v[fuera], median(v), v[n - 1 - fuera])


def cociente(tiempos, entre):
    """El de dos series tomadas en las mismas rondas."""
    return intervalo([a / b for a, b in zip(tiempos, entre, strict=True)])


def mas_lento(tiempos, que):
    """Si el primero tarda más que el segundo: sí, no o None, que no se distinguen."""
    c = cociente(tiempos, que)
    return True if c.menor > IGUALES else False if c.mayor < 1 / IGUALES else None
