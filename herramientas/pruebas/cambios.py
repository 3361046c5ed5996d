"""Qué pruebas puede cambiar lo que ha cambiado, para ./lab prueba --cambios.

cambios.py RAÍZ BUILD elige            las que no han pasado con lo que hay ahora, con | entre ellas
cambios.py RAÍZ BUILD apunta FICHERO   en BUILD/pasadas.json, con qué ha pasado cada una: las del informe JUnit de ctest

De cada prueba cuentan su orden, los programas que nombra, su golden, los ficheros que leyeron sus programas la última
vez (BUILD/leidos/PRUEBA) y lo que usan todas; y de las que miran el laboratorio y no los programas, lo que miran.
"""
import functools
import hashlib
import json
import os
import re
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

from base import catalogo
from base.procesos import ejecuta, escribe, principal

DEL_LABORATORIO = (
    "lab",
    "CMakeLists.txt",
    "CMakePresets.json",
    "herramientas",
    "tests/ordenes",
    "tests/herramientas",
    "common",
)
MIRAN = {
    "copia": DEL_LABORATORIO,
    "ordenes": DEL_LABORATORIO,
    "herramientas": DEL_LABORATORIO,
    "enlace_web": DEL_LABORATORIO,
    "comparador.defectos": ("tests/comparador", "herramientas/comparador"),
}
DE_TODAS = (
    "herramientas/base/entorno.txt",
    "tests/casos",
    "tests/ventana",
    "tests/fuzz",
    "assets",
)  # y los ejecutables que no son de ninguna
SALE = "build", "galeria", "informe", "web", "windows", "mios", ".git"  # de la raíz, lo que no es del laboratorio
SIN_MIRAR = "__pycache__", "golden", "mutantes"


class Sumas:
    def __init__(self, raiz, build):
        self.raiz, self.build = raiz, build
        self.destinos = [d.name for d in build.iterdir() if (d / "ch01_intro").is_dir()]
        self.programas = {p.nombre: p for p in catalogo.lee_programas(build)}
        de_las_pruebas = [*(build / "tests").iterdir(), build / "herramientas/comparador/compara"]
        ejecutables = [f for f in de_las_pruebas if f.is_file() and os.access(f, os.X_OK) and "_test" not in f.name]
        self.comunes = self.carpetas(*DE_TODAS) + self.ficheros(ejecutables)

    @functools.cache
    def fichero(self, ruta):
        return hashlib.sha1(ruta.read_bytes()).hexdigest() if ruta.is_file() else ""

    def ficheros(self, rutas):
        return hashlib.sha1("".join(self.fichero(ruta) for ruta in sorted(rutas)).encode()).hexdigest()

    @functools.cache
    def carpetas(self, *nombres):
        """Los fuentes que hay en esas carpetas, y esos ficheros."""
        dentro = (
            f
            for nombre in nombres
            for f in ([self.raiz / nombre] if (self.raiz / nombre).is_file() else (self.raiz / nombre).rglob("*"))
        )
        return self.ficheros(f for f in dentro if f.is_file() and self.se_mira(f.relative_to(self.raiz)))

    def se_mira(self, ruta):
        return ruta.parts[0] not in SALE and not any(parte in SIN_MIRAR for parte in ruta.parts)

    def leidos(self, nombre):
        """Lo que leyeron sus programas: rutas de los fuentes o de BUILD."""
        try:
            rutas = set((self.build / "leidos" / nombre).read_text().splitlines())
        except OSError:
            return []
        return [self.build / ruta if (self.build / ruta).is_file() else self.raiz / ruta for ruta in rutas]

    def prueba(self, nombre, orden):
        """La de todo lo que puede cambiar su resultado."""
        if nombre in MIRAN:
            return self.carpetas(*MIRAN[nombre])
        argumentos = [a for a in orden[1:] if a in self.programas]
        ejecutable = Path(orden[0])
        if not argumentos and self.build not in ejecutable.parents:  # mira el laboratorio entero
            return self.carpetas(".")
        guiones = [Path(a) for a in orden if a.endswith(".py")]
        if guiones:
            guiones += [*(self.raiz / "herramientas").rglob("*.py"), *guiones[0].parent.glob("*.py")]
        suyos = [ejecutable, *guiones, *self.leidos(ejecutable.name if ejecutable.name.endswith("_test") else nombre)]
        for a in argumentos:
            capitulo = self.programas[a].capitulo.nombre
            suyos += [self.build / destino / capitulo / a for destino in self.destinos]
            suyos += [
                self.build / f"casos/{a}.sh",
                *self.programas[a].ficheros(self.raiz),
                *(self.raiz / "tests/golden" / capitulo).glob(f"{a}*"),
            ]
        return hashlib.sha1(repr((orden, self.comunes, self.ficheros(suyos))).encode()).hexdigest()


def main():
    raiz, build = (Path(p).resolve() for p in sys.argv[1:3])
    registro = build / "pasadas.json"
    pasadas = json.loads(registro.read_text()) if registro.exists() else {}
    ordenes = {
        t["name"]: t.get("command", ["NOT_BUILT"])
        for t in json.loads(ejecuta(["ctest", "--test-dir", build, "--show-only=json-v1"], text=True))["tests"]
    }
    sumas = Sumas(raiz, build)
    if sys.argv[3] == "elige":
        elegidas = [re.escape(n) for n, orden in ordenes.items() if pasadas.get(n) != sumas.prueba(n, orden)]
        print(
            "|".join(elegidas) if 2 * len(elegidas) < len(ordenes) else ".*"
        )  # ctest no admite una expresión con todas
        return
    for caso in xml.parse(sys.argv[4]).getroot().iter("testcase"):
        nombre = caso.get("name")
        pasadas.pop(nombre, None)
        if caso.get("status") == "run" and nombre in ordenes:
            pasadas[nombre] = sumas.prueba(nombre, ordenes[nombre])
    escribe(registro, json.dumps({n: s for n, s in pasadas.items() if n in ordenes}, indent=0))


if __name__ == "__main__":
    principal(main)
