"""Hace jugar, guarda lo jugado por lo propio y dice si dos partidas son la misma."""
import hashlib
import shutil
import tempfile
import threading
import time
import zlib
from pathlib import Path

from base.procesos import escribe, lanza
from ejercicios.corrige.jaula import desempaqueta
from ejercicios.corrige.partidas import TALLA, Guion, Partida

JUEGA = {"segundos": 30, "procesador": 10, "memoria": 1 << 30, "procesos": 8}
VIEJA = 86400  # segundos que se guarda lo jugado por otra versión


def suma(*partes):
    h = hashlib.sha1()
    for parte in partes:
        h.update(hashlib.sha1(parte if isinstance(parte, bytes) else parte.encode()).digest())
    return h.hexdigest()


class Arbitro:
    def __init__(self, build, ref, compilador, recinto, temporal, version):
        self.build, self.compilador, self.recinto, self.temporal = build, compilador, recinto, temporal
        self.iguales_ya = {}
        self.cache = temporal
        primera = desempaqueta(self.juega_de_nuevo(compilador.solucion, Guion("", ()))).get(
            "000.ppm", b""
        )  # con el sello de quién dibuja
        self.cache = self.elige_cache(ref, suma(version, compilador.solucion.programa.read_bytes(), primera))

    # --- jugar ---

    def elige_cache(self, ref, clave):
        """Donde se guardan las partidas de la solución y de los mutantes; las de antes se borran. Si no se puede
        escribir, no duran."""
        cache = self.build / "corrige" / ref / clave
        try:
            cache.mkdir(parents=True, exist_ok=True)
            for vieja in set(cache.parent.iterdir()) - {cache}:
                if time.time() - vieja.stat().st_mtime > VIEJA:  # si no, puede estar usándola otro
                    shutil.rmtree(vieja, ignore_errors=True)
        except OSError:
            cache = self.temporal / "cache"
            cache.mkdir()
        return cache

    @property
    def shaders(self):
        """Los que compila Mesa para la solución y los mutantes."""
        return self.cache / "shaders"

    def juega_de_nuevo(self, jugador, guion):
        """Lo que deja, en un tar."""
        orden = [
            jugador.programa,
            "-geometry",
            "{}x{}".format(*TALLA),
            "-titulos",
            "-ppm",
            "ultima.ppm",
            "-guion",
            guion.texto,
        ]
        entorno = {"LAB_RAIZ": ":".join(map(str, jugador.raices)), **jugador.entorno}
        if not jugador.ajeno:
            return self.recinto.propio(orden, JUEGA, MESA_SHADER_CACHE_DIR=str(self.shaders), **entorno)
        ve = [jugador.programa.parent, *self.compilador.ve, *([self.shaders] if self.shaders.is_dir() else [])]
        return self.recinto.ajeno(
            orden, JUEGA, ve, LAB_SHADERS=str(self.shaders), MESA_SHADER_CACHE_DIR="shaders", **entorno
        )

    def juega(self, jugador, guion):
        """La partida; las de la solución y las de los mutantes se guardan, que son las mismas para toda la clase."""
        if jugador.ajeno:
            return Partida.lee(self.juega_de_nuevo(jugador, guion), guion)
        guardada = self.cache / suma(jugador.nombre, guion.texto)
        try:
            return Partida.lee(zlib.decompress(guardada.read_bytes()), guion)
        except (OSError, zlib.error):
            datos = self.juega_de_nuevo(jugador, guion)
            parcial = guardada.with_name(f"{guardada.name}.{threading.get_ident()}")
            escribe(parcial, zlib.compress(datos, 1))
            parcial.replace(guardada)
            return Partida.lee(datos, guion)

    # --- comparar ---

    def compara(self, una, otra, deja=None):
        """Si el comparador acepta la segunda por la primera, que es la esperada. Con DEJA, y si no, lo que deja
        empieza así."""
        with tempfile.TemporaryDirectory(dir=self.temporal) as aqui:
            for nombre, (ancho, alto, pixeles) in (("a", una), ("b", otra)):
                Path(aqui, nombre).write_bytes(b"P6\n# corrige\n%d %d\n255\n" % (ancho, alto) + pixeles)
            orden = [
                self.build / "herramientas/comparador/compara",
                "a",
                "b",
                "--amplia",
                *(["--deja", deja] if deja else []),
            ]
            return lanza(orden, cwd=aqui).returncode == 0

    def iguales(self, una, otra):
        """Si dos imágenes son la misma, salvo lo que puede mover el redondeo. La primera es la esperada."""
        if una == otra:
            return True
        if una[:2] != otra[:2]:
            return False
        clave = suma(una[2], otra[2])
        if clave not in self.iguales_ya:
            self.iguales_ya[clave] = self.compara(una, otra)
        return self.iguales_ya[clave]

    def difiere(self, esperada, obtenida):
        """En qué imagen se apartan dos partidas, o None. El texto y los títulos cuentan tras la última."""
        for i, imagen in enumerate(esperada.imagenes):
            if i >= len(obtenida.imagenes) or not self.iguales(imagen, obtenida.imagenes[i]):
                return i
        mismo_texto = not esperada.texto or obtenida.texto == esperada.texto
        bien = obtenida.estado == esperada.estado and obtenida.titulos == esperada.titulos and mismo_texto
        return None if bien else len(esperada.imagenes) - 1
