"""Hace jugar, guarda lo jugado por lo propio y dice si dos partidas son la misma."""
import hashlib
import itertools
import tempfile
import threading
import zlib
from contextlib import suppress
from pathlib import Path

from base.procesos import Fallo, escribe, lanza
from ejercicios.corrige.partidas import TALLA, Partida
from ejercicios.reglas import Reglas

JUEGA = {"memoria": 1 << 30, "procesos": 8}
PROCESADOR, VECES = 10, 4  # segundos: tantos, y lo que la solución tarda con ese guion, tantas veces
SIN_PRISA = 200  # los de la solución
ERROR_DE_OPENGL = 3  # con que acaba quien da alguno
BIEN, CASI = 1, 0.5  # cuánto se parecen dos imágenes: lo que vale el guion
DELANTE = 'ln -s "$0" delante.so && LD_PRELOAD=./delante.so exec "$@"'  # que no admite blancos


def suma(*partes):
    h = hashlib.sha1()
    for parte in partes:
        h.update(hashlib.sha1(parte if isinstance(parte, bytes) else parte.encode()).digest())
    return h.hexdigest()


def faltan(esperado, escrito):
    """Las líneas que se esperan y no están, en su orden, entre las escritas, que pueden ser más."""
    escritas = iter(escrito.splitlines())
    return [linea for linea in esperado.splitlines() if linea and not any(linea in otra for otra in escritas)]


def aparte(esperada, obtenida):
    """De lo que no es la imagen ni cuenta en cada guion, en qué se apartan: {qué: cómo se dice}."""
    hay = {}
    if obtenida.titulos != esperada.titulos:
        pares = itertools.zip_longest(esperada.titulos, obtenida.titulos, fillvalue="(ninguno)")
        debia, es = next(p for p in pares if p[0] != p[1])
        hay["título"] = f"el título es «{es}» y debía ser «{debia}»"
    if falta := faltan(esperada.texto, obtenida.texto):
        hay["texto"] = f"debía escribir «{falta[0]}»"
    if obtenida.estado != esperada.estado:
        hay["estado"] = f"acaba con estado {obtenida.estado}"
    return hay


class Arbitro:
    tolerancia = Reglas().tolerancia
    avanza = staticmethod(lambda jugador, guion: None)  # quien enseña por dónde va

    def __init__(self, build, compilador, recinto, temporal, tolerancia=tolerancia):
        self.build, self.compilador, self.recinto, self.temporal = build, compilador, recinto, temporal
        self.tolerancia, self.parecidas = tolerancia, {}
        self.cache = temporal  # dónde se guarda lo jugado

    # --- jugar ---

    @property
    def shaders(self):
        """Los que compila Mesa para la solución y los mutantes."""
        return self.cache / "shaders"

    def juega_de_nuevo(self, jugador, guion, procesador=SIN_PRISA, delante=None, **mas):
        """Lo que deja, en un tar. DELANTE: la biblioteca que se le pone delante."""
        self.avanza(jugador, guion)
        orden = [jugador.programa, "-geometry", "{}x{}".format(*TALLA), "-titulos", "titulos", "-ppm", "ultima.ppm"]
        orden += ["-guion", guion.texto]
        if delante:
            orden = ["sh", "-c", DELANTE, delante, *orden]
        limites = {**JUEGA, "procesador": round(procesador), "segundos": round(3 * procesador)}
        raices = ":".join(map(str, [*jugador.raices, self.build]))
        # los rótulos no se piden: se ven los trazos, que en las curvas son lo que se pide
        entorno = {"LAB_RAIZ": raices, "LAB_SIN_ENCIMA": "rotulo", **jugador.entorno, **mas}
        if not jugador.ajeno:
            return self.recinto.propio(orden, limites, MESA_SHADER_CACHE_DIR=str(self.shaders), **entorno)
        shaders = [self.shaders] if self.shaders.is_dir() else []
        ve = [
            jugador.programa.parent,
            *jugador.raices[-1:],
            *self.compilador.ve,
            *shaders,
            *([delante] if delante else []),
        ]
        # de lo ajeno, en ninguna carpeta más: en el laboratorio está la solución
        entorno |= {"LAB_SOLO_RAIZ": "1", "LAB_SHADERS": str(self.shaders), "MESA_SHADER_CACHE_DIR": "shaders"}
        return self.recinto.ajeno(orden, limites, ve, **entorno)

    def juega(self, jugador, guion, esperada=None):
        """La partida, con tiempo para varias como la esperada; las de la solución y las de los mutantes se guardan, que
        son las mismas para toda la clase."""
        procesador = PROCESADOR + VECES * esperada.segundos if esperada else SIN_PRISA
        if jugador.ajeno:
            return Partida.lee(self.juega_de_nuevo(jugador, guion, procesador), guion, procesador)
        guardada = self.cache / suma(jugador.nombre, guion.texto)
        try:
            return Partida.lee(zlib.decompress(guardada.read_bytes()), guion)
        except (OSError, zlib.error):
            datos = self.juega_de_nuevo(jugador, guion, procesador)
            parcial = guardada.with_name(f"{guardada.name}.{threading.get_ident()}")
            with suppress(Fallo, OSError):  # donde corrige VPL no se puede escribir
                escribe(parcial, zlib.compress(datos, 1))
                parcial.replace(guardada)
            return Partida.lee(datos, guion)

    # --- comparar ---

    def compara(self, una, otra, como, *opciones):
        """Si el comparador acepta la segunda por la primera, que es la esperada."""
        with tempfile.TemporaryDirectory(dir=self.temporal) as aqui:
            for nombre, (ancho, alto, pixeles) in (("a", una), ("b", otra)):
                Path(aqui, nombre).write_bytes(b"P6\n# corrige\n%d %d\n255\n" % (ancho, alto) + pixeles)
            orden = [self.build / "herramientas/comparador/compara", "a", "b", como, *opciones]
            return lanza(orden, cwd=aqui).returncode == 0

    def parecido(self, una, otra):
        """De dos imágenes, la primera la esperada: BIEN, si son la misma salvo lo que puede mover el redondeo; CASI, si
        una persona las tendría por la misma; si no, 0."""
        if una == otra:
            return BIEN
        if una[:2] != otra[:2]:
            return 0
        clave = suma(repr(una[:2]), una[2], otra[2])
        if clave not in self.parecidas:
            como = (BIEN, f"--{self.tolerancia}"), (CASI, "--otro")
            self.parecidas[clave] = next((cuanto for cuanto, c in como if self.compara(una, otra, c)), 0)
        return self.parecidas[clave]

    def difiere(self, esperada, obtenida, basta=BIEN):
        """En qué imagen se apartan dos partidas, o None. Un error de OpenGL cuenta tras la última."""
        for i, imagen in enumerate(esperada.imagenes):
            if i >= len(obtenida.imagenes) or self.parecido(imagen, obtenida.imagenes[i]) < basta:
                return i
        acaba = obtenida.estado == esperada.estado or not (obtenida.cuelga or obtenida.estado == ERROR_DE_OPENGL)
        return None if acaba else len(esperada.imagenes) - 1

    def misma(self, una, otra):
        """Si dos partidas dejan lo mismo en todo."""
        return self.difiere(una, otra) is None and not aparte(una, otra)
