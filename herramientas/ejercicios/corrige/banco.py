"""Todo lo que hace falta para corregir un ejercicio: quién compila, quién juega y por qué fallan, y los guiones de
todos."""
from pathlib import Path

from base import procesos
from ejercicios import nuevo
from ejercicios.corrige import partidas
from ejercicios.corrige.arbitro import Arbitro, suma
from ejercicios.corrige.compilador import Compilador
from ejercicios.corrige.jaula import Recinto
from ejercicios.corrige.motivos import Motivos, conocidos


class Banco:
    def __init__(self, raiz, build, ref, programa, temporal, jaula, semilla, n):
        self.ref, self.programa, self.semilla, self.temporal = ref, programa, semilla, temporal
        entorno = procesos.entorno()
        del entorno["MESA_SHADER_CACHE_DISABLE"]
        entorno |= {"LP_NUM_THREADS": "0", "LANG": "C.UTF-8", "PATH": "/usr/bin:/bin"}
        recinto = Recinto(temporal, jaula, entorno)
        self.compilador = Compilador(raiz, build, programa, ref, recinto)
        self.version = self.suma_todo(raiz)
        self.todos = [
            *partidas.de_los_casos(programa),
            *partidas.al_azar(raiz, build, programa, f"{ref} {semilla}", n, entorno),
        ]
        self.arbitro = Arbitro(build, ref, self.compilador, recinto, temporal, self.version)
        self.motivos = Motivos(raiz, programa, ref, self.compilador, self.arbitro)

    def suma_todo(self, raiz):
        """Lo que cambia una corrección, además de lo entregado y de los guiones: quien corrige, lo que se da y lo que
        se ve."""
        ficheros = sorted(nuevo.de_la_carpeta(raiz, self.programa, self.ref).items())
        quien = sorted(Path(__file__).parent.glob("*.py"))
        visto = [raiz / ruta for ruta in self.compilador.visible]
        return suma(
            repr(ficheros), repr(conocidos(raiz, self.programa, self.ref)), *(f.read_bytes() for f in [*quien, *visto])
        )
