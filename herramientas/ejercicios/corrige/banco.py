"""Todo lo que hace falta para corregir un ejercicio: quién compila, quién juega y por qué fallan, y los guiones de
todos."""
import functools
import os
import shutil
import time
from pathlib import Path

from base import procesos
from ejercicios import nuevo
from ejercicios.corrige import partidas, shaders
from ejercicios.corrige.arbitro import Arbitro, suma
from ejercicios.corrige.compilador import Compilador
from ejercicios.corrige.cuadro import DELANTE
from ejercicios.corrige.donde import Donde
from ejercicios.corrige.jaula import Recinto, desempaqueta
from ejercicios.corrige.motivos import Motivos, conocidos
from ejercicios.corrige.partidas import Guion
from ejercicios.corrige.shaders import DeShaders, MotivosDeShaders

VIEJA = 86400  # segundos que se guarda lo jugado por otra versión


def guiones(raiz, build, programa, ref, semilla, reglas, entorno):
    """Los que juegan todos, si valen algo: los casos y los que son al azar."""
    de_shaders = nuevo.es_de_shaders(ref)
    casos = shaders.guiones(raiz, build, programa, entorno) if de_shaders else partidas.de_los_casos(programa)
    azar = partidas.al_azar(raiz, build, programa, f"{ref} {semilla}", reglas.guiones, entorno)
    return [g for g in (*casos, *azar) if reglas.peso(g)]


class Banco:
    sin_solucion = ""  # lo que se dice, si no está

    def __init__(self, raiz, build, ref, programa, temporal, jaula, semilla, reglas):
        self.reglas, self.piezas = reglas, {}
        self.ref, self.programa, self.semilla, self.temporal = ref, programa, semilla, temporal
        self.raiz, self.privados = raiz, {*map(str, nuevo.privados(raiz, programa, ref)), str(programa.fuente)}
        recinto = self.recinto(jaula)
        entorno = recinto.entorno
        con_shaders = nuevo.es_de_shaders(ref)
        self.compilador = (DeShaders if con_shaders else Compilador)(raiz, build, programa, ref, recinto)
        self.de_partida = nuevo.esqueleto(raiz, programa, ref), "" if con_shaders else programa.fuente.name
        self.dados = self.de_partida[0], nuevo.solucion(raiz, programa, ref)  # lo que no es de nadie (parecidos.py)
        self.todos = guiones(raiz, build, programa, ref, semilla, reglas, entorno)
        self.arbitro = Arbitro(build, self.compilador, recinto, temporal, reglas.tolerancia)
        self.clave = suma(*self.lo_que_lo_cambia(build))
        self.arbitro.cache = self.cache(build / "corrige" / ref)
        partes = raiz, programa, ref, self.compilador, self.arbitro
        self.motivos = (MotivosDeShaders if con_shaders else Motivos)(*partes)
        reglas.de_cada(len(self.motivos.trozos()))

    def recinto(self, jaula):
        entorno = procesos.entorno()
        del entorno["MESA_SHADER_CACHE_DISABLE"]
        entorno |= {"LP_NUM_THREADS": "0", "LANG": "C.UTF-8", "PATH": "/usr/bin:/bin"}
        entorno["MESA_DISK_CACHE_SINGLE_FILE"] = "1"  # que se copia para cada partida
        return Recinto(self.temporal, jaula, entorno)

    def sin_hacer(self):
        """Quien juega el punto de partida."""
        return self.motivos.variantes()[0][1]

    @functools.cached_property
    def donde(self):
        return Donde(self)

    def de_otro(self, ruta):
        """Si lo que hay en esa ruta de una entrega, o en el final de ella, ya lo da el laboratorio o el sistema: una
        copia de common/ o de glm/."""
        partes = ruta.split("/")
        finales = ["/".join(partes[i:]) for i in range(len(partes) - 1)]
        return any(
            os.path.isfile(f"/usr/include/{f}")
            or not (f in self.privados or f.startswith(("mios/", "ejercicios/")))
            and os.path.isfile(self.raiz / f)
            for f in finales
        )

    def lo_que_lo_cambia(self, build):
        """Todo de lo que sale una corrección, además de lo entregado y de los guiones: quien corrige, lo que se da, lo
        que se ve, con qué se enlaza, la solución y quien dibuja, que va en el sello de una imagen."""
        yield repr((nuevo.pedidos(self.raiz, self.programa, self.ref), self.de_partida))
        yield repr(conocidos(self.raiz, self.programa, self.ref))
        yield desempaqueta(self.arbitro.juega_de_nuevo(self.compilador.solucion, Guion("", ()))).get("000.ppm", b"")
        visto = [
            *sorted(Path(__file__).parent.glob("*.[pc]*")),
            *sorted((self.raiz / "herramientas/base").glob("*.py")),
            *(self.raiz / ruta for ruta in self.compilador.visible),
            *(Path(b) for b in self.compilador.bibliotecas if b.startswith(str(build))),
            build / "herramientas/comparador/compara",
            *([build / DELANTE] if (build / DELANTE).exists() else []),
            self.compilador.solucion.programa,
        ]
        yield from (f.read_bytes() for f in visto)

    def huella(self, *entregado):
        """La de la corrección de eso, con estas reglas y estos guiones."""
        guiones = (g.texto for g in self.todos)
        return suma(self.clave, self.semilla, self.reglas.en_palabras, *guiones, *map(repr, entregado))

    def cache(self, sitio):
        """Donde se guardan las partidas de la solución y de los mutantes; las de antes se borran. Si no se puede
        escribir, no duran."""
        cache = sitio / self.clave
        try:
            cache.mkdir(parents=True, exist_ok=True)
            for vieja in set(sitio.iterdir()) - {cache}:
                if time.time() - vieja.stat().st_mtime > VIEJA:  # si no, puede estar usándola otro
                    shutil.rmtree(vieja, ignore_errors=True)
        except OSError:
            cache = self.temporal / "cache"
            cache.mkdir()
        return cache
