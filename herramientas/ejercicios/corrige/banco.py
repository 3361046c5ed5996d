"""Todo lo que hace falta para corregir un ejercicio: quién compila, quién juega y por qué fallan, y los guiones de
todos."""
import functools
import os
from pathlib import Path

from base import procesos
from ejercicios import nuevo
from ejercicios.corrige import partidas, shaders
from ejercicios.corrige.arbitro import Arbitro, suma
from ejercicios.corrige.compilador import Compilador
from ejercicios.corrige.cuadro import DELANTE
from ejercicios.corrige.donde import Donde
from ejercicios.corrige.jaula import Recinto
from ejercicios.corrige.motivos import Motivos, conocidos
from ejercicios.corrige.shaders import DeShaders, MotivosDeShaders


class Banco:
    def __init__(self, raiz, build, ref, programa, temporal, jaula, semilla, reglas):
        self.reglas = reglas
        self.ref, self.programa, self.semilla, self.temporal = ref, programa, semilla, temporal
        self.raiz, self.privados = raiz, {*map(str, nuevo.privados(raiz, programa, ref)), str(programa.fuente)}
        entorno = procesos.entorno()
        del entorno["MESA_SHADER_CACHE_DISABLE"]
        entorno |= {"LP_NUM_THREADS": "0", "LANG": "C.UTF-8", "PATH": "/usr/bin:/bin"}
        entorno["MESA_DISK_CACHE_SINGLE_FILE"] = "1"  # que se copia para cada partida
        recinto = Recinto(temporal, jaula, entorno)
        con_shaders = nuevo.es_de_shaders(ref)
        self.compilador = (DeShaders if con_shaders else Compilador)(raiz, build, programa, ref, recinto)
        de = shaders if con_shaders else nuevo
        self.de_partida = de.esqueleto(raiz, programa, ref), "" if con_shaders else programa.fuente.name
        self.dados = self.de_partida[0], de.solucion(raiz, programa, ref)  # lo que no es de nadie (parecidos.py)
        self.version = self.suma_todo(raiz, build)
        todos = [
            *(shaders.guiones(raiz, build, programa, entorno) if con_shaders else partidas.de_los_casos(programa)),
            *partidas.al_azar(raiz, build, programa, f"{ref} {semilla}", reglas.guiones, entorno),
        ]
        self.todos = [g for g in todos if reglas.peso(g)]
        self.arbitro = Arbitro(build, ref, self.compilador, recinto, temporal, self.version, reglas.tolerancia)
        partes = raiz, programa, ref, self.compilador, self.arbitro
        self.motivos = (MotivosDeShaders if con_shaders else Motivos)(*partes)

    @functools.cached_property
    def donde(self):
        return Donde(self)

    def de_otro(self, ruta):
        """Si lo que hay en esa ruta de una entrega, o en el final de ella, ya lo da el laboratorio o el sistema: una copia de
        common/ o de glm/."""
        partes = ruta.split("/")
        finales = ["/".join(partes[i:]) for i in range(len(partes) - 1)]
        return any(
            os.path.isfile(f"/usr/include/{f}")
            or not (f in self.privados or f.startswith(("mios/", "ejercicios/"))) and os.path.isfile(self.raiz / f)
            for f in finales
        )

    def suma_todo(self, raiz, build):
        """Lo que cambia una corrección, además de lo entregado y de los guiones: quien corrige, lo que se da, lo que se
        ve y con qué se enlaza."""
        textos = nuevo.pedidos(raiz, self.programa, self.ref), self.de_partida
        errores = conocidos(raiz, self.programa, self.ref)
        visto = [
            *sorted(Path(__file__).parent.glob("*.py")),
            *sorted((raiz / "herramientas/base").glob("*.py")),
            *(raiz / ruta for ruta in self.compilador.visible),
            *(Path(b) for b in self.compilador.bibliotecas if b.startswith(str(build))),
            build / "herramientas/comparador/compara",
            *([build / DELANTE] if (build / DELANTE).exists() else []),
        ]
        return suma(repr(textos), repr(errores), *(f.read_bytes() for f in visto))
