"""pagina.py RAÍZ BUILD GALERÍA DESTINO: la página con todos los programas, en ficheros estáticos que valen sin
servidor.

BUILD es el del enlace web (herramientas/cmake/web.cmake). Lo que no es texto de la página va en
DESTINO/datos/NOMBRE.js, que llama a llega("NOMBRE", "…") con los bytes comprimidos y en base64: así un navegador lo
lee también de file://, y ocupa poco aunque el servidor no comprima.
"""
import base64
import json
import os
import shutil
import sys
import tempfile
import zlib
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from base import catalogo, controles, defectos, fuentes, indice, libro, marcas, paginas
from base.procesos import Fallo, ejecuta, escribe, principal
from ejercicios import en_pagina, propios
from web import taller

PLANTILLA = Path(__file__).with_name("web.html")
CODEMIRROR = Path("/usr/share/javascript/codemirror")
SHADERS, TEXTURAS = (".vert", ".frag", ".glsl"), (".rgb", ".r8")


class ProgramaVivo:
    """Lo que la página tiene que saber de un programa: lo dice el catálogo, lo dicen sus controles o lo dice él,
    ejecutado sin ventana."""

    def __init__(self, raiz, build, programa):
        self.raiz, self.programa = raiz, programa
        suyos = [c for c in controles.lee(raiz, programa) if c.teclas != ["Esc"]]
        self.controles = [c for c in suyos if not c.texto.startswith("sin controles")]
        teclas = [orden for c in self.controles if not c.termina for orden in c.ordenes]
        self.rasgos, self.opciones = set(), []
        with tempfile.NamedTemporaryFile("r") as leidos:  # los ficheros del laboratorio que lee
            # también con sus teclas: una puede poner en marcha un temporizador, o quitarlo
            for guion in () if programa.consola else ("", "; ".join(teclas)):
                rasgos, self.opciones = controles.atiende(build, programa, guion, LAB_LEIDOS=leidos.name)
                self.rasgos |= rasgos
            self.leidos = set(leidos.read().splitlines())

    def datos(self):
        p = self.programa
        return {
            "nombre": p.nombre,
            "capitulo": p.capitulo.nombre,
            "referencia": p.ref,
            "titulo": p.titulo,
            "consola": p.consola,
            "mandos": [
                {"teclas": list(zip(c.teclas, c.ordenes)), "hace": c.hace or c.texto, "menu": c.menu}
                for c in self.controles
            ],
            "cualquiera": any("cualquier tecla" in c.texto for c in self.controles),
            "derecho": not self.opciones and any("derecho" in c.texto for c in self.controles),
            "anima": bool(self.rasgos & {"temporizador", "ocio"}),
            "raton": bool(self.rasgos & {"raton", "rueda", "arrastre"}),
            "sigue": "movimiento" in self.rasgos,
            "casos": [
                {"titulo": c.titulo or "Al empezar", "fichero": c.fichero, "guion": c.guion, "mira": c.mira}
                for c in p.casos
            ],
            "fuentes": [str(f) for f in fuentes.alcanza(self.raiz, p.fuente)] if not p.raices else [],
            "raices": [f"/lab/{p.capitulo.nombre}"] if p.raices else [],
            "texturas": sorted(Path(f).name for f in self.leidos if f.endswith(TEXTURAS)),
            "admite": p.admite,
        }


class Pagina:
    def __init__(self, raiz, build, galeria, destino):
        self.raiz, self.build, self.galeria, self.destino = raiz, build, galeria, destino
        self.nuevos = destino / "datos.parcial"  # hasta que están todos

    def empaqueta(self, nombre, datos):
        datos = datos if isinstance(datos, bytes) else json.dumps(datos, ensure_ascii=False).encode()
        self.escribe_datos(nombre, zlib.compress(datos, 9))

    def escribe_datos(self, nombre, comprimidos):
        escribe(self.nuevos / f"{nombre}.js", f'llega("{nombre}","{base64.b64encode(comprimidos).decode()}")\n')

    def empaqueta_taller(self):
        """Lo de compilar en ella, que solo se pide para compilar, si está el compilador; y lo que se sabe de ello."""
        if not taller.paquete(self.build):
            return None
        ficheros = [*taller.Taller(self.raiz, self.build).ficheros()]
        for fichero in ficheros:
            self.escribe_datos(*fichero)
        self.empaqueta("comun", self.textos("common/**/*.cpp", "common/**/*.h", str(defectos.MUTANTE_H)))
        return taller.resumen(ficheros)

    def textos(self, *patrones):
        ficheros = sorted(f for patron in patrones for f in self.raiz.glob(patron))
        return {str(f.relative_to(self.raiz)): f.read_text() for f in ficheros}

    def shaders(self):
        return self.textos(*(f"c*/**/*{e}" for e in SHADERS))

    def de_quien_ensena(self):
        """Los programas de sus ejercicios, que tienen que estar compilados sin ventana y en lab.wasm."""
        suyos = propios.los_de_aqui(self.raiz, self.build.parent)
        for p in suyos:
            if not p.ejecutable(self.build.parent).is_file():
                raise Fallo(f"{p.capitulo.nombre} no está compilado: lo hace ./lab web")
        return suyos

    def ejercicios(self, capitulos):
        """Los que se hacen en la página: los de shaders y, si en ella se compila, los demás, con su programa."""
        programas = [*(p for c in capitulos for p in c.programas), *self.de_quien_ensena()]
        hay = en_pagina.los_que_hay(self.raiz, programas)
        return hay if taller.paquete(self.build) else {r: p for r, p in hay.items() if r.startswith("L")}

    def guion(self):
        """Los módulos de la página en un solo guion, porque de file:// un navegador no los carga."""
        opciones = "--bundle", "--format=iife", "--global-name=pagina", "--charset=utf8"
        return ejecuta(["esbuild", PLANTILLA.with_name("pagina.mjs"), *opciones]).decode()

    def miniatura(self, caso):
        """La suya de la galería."""
        origen = self.galeria / caso.miniatura
        if caso.programa.consola or not origen.is_file():
            return ""
        escribe(self.destino / caso.miniatura, origen.read_bytes())
        return caso.miniatura

    def escribe(self, capitulos):
        try:
            self.empaqueta_todo(capitulos)
            self.escribe_indice(capitulos, self.cambia_los_datos, self.empaqueta_taller())
        finally:
            shutil.rmtree(self.nuevos, ignore_errors=True)

    def cambia_los_datos(self):
        shutil.rmtree(self.destino / "datos", ignore_errors=True)
        self.nuevos.rename(self.destino / "datos")

    def empaqueta_todo(self, capitulos):
        shutil.rmtree(self.nuevos, ignore_errors=True)
        for parte in ("js", "wasm"):
            self.empaqueta(parte, (self.build / f"lab.{parte}").read_bytes())
        shaders = self.shaders()
        suyos = self.textos(*(f"{propios.CARPETA}/*/*{e}" for e in (*SHADERS, ".vf")))
        self.empaqueta("shaders", {**shaders, **suyos, **self.textos("assets/*.txt", "assets/*.vf")})
        hechos = lambda e: (e[0], en_pagina.datos(self.raiz, self.build.parent, e[1], e[0]))
        with ThreadPoolExecutor(os.cpu_count()) as hilos:
            self.empaqueta("ejercicios", dict(hilos.map(hechos, self.ejercicios(capitulos).items())))
        self.empaqueta("indice", indice.hace(self.raiz, capitulos, libro.Libro(self.raiz)))
        self.empaqueta("codigo", {f: marcas.publico(self.raiz, f) for f in self.textos("ch*/*.cpp", "ch*/*.h")})
        ocultos = {*marcas.ocultos(self.raiz), *(p.nombre for p in self.de_quien_ensena())}
        for codigo in ocultos & set(marcas.que_piden({**shaders, **suyos})):
            print(f"Aviso: {codigo} se hace en un shader, y la página lo lleva resuelto: lo dibuja", file=sys.stderr)
        guiones = ("lib/codemirror.js", "mode/clike/clike.js", "addon/edit/matchbrackets.js")
        self.empaqueta(
            "editor",
            {
                "css": (CODEMIRROR / "lib/codemirror.css").read_text(),
                "js": "\n".join((CODEMIRROR / g).read_text() for g in guiones),
            },
        )
        for textura in (self.build.parent / "assets").iterdir():
            if textura.suffix in TEXTURAS:
                self.empaqueta(textura.name, textura.read_bytes())

    def escribe_indice(self, capitulos, antes=lambda: None, taller=None):
        programas = [p for capitulo in capitulos for p in capitulo.programas]
        self.destino.mkdir(parents=True, exist_ok=True)
        del_libro, hay = libro.Libro(self.raiz, capitulos), self.ejercicios(capitulos)
        ensenados = [p for p in hay.values() if p.raices]
        with ThreadPoolExecutor(os.cpu_count()) as hilos:
            vivos = hilos.map(lambda p: ProgramaVivo(self.raiz, self.build.parent, p), [*programas, *ensenados])
            datos = [p.datos() for p in vivos]
        for p, d in zip([*programas, *ensenados], datos):
            suyos = [c for c in p.referencias if hay.get(c) is p]
            d["ejercicios"] = [en_pagina.resumen(self.raiz, p, c, del_libro) for c in suyos]
        casos = [p.casos[0] for p in programas] + [c.caso_de_portada for c in capitulos if c.caso_de_portada]
        miniaturas = {caso.fichero: self.miniatura(caso) for caso in casos}
        guion = self.guion()
        antes()
        paginas.escribe_pagina(
            self.destino,
            PLANTILLA,
            capitulos=capitulos,
            libro=del_libro,
            programas=datos[: len(programas)],
            ensenados=datos[len(programas) :],
            miniaturas=miniaturas,
            ejercicios={p["nombre"]: p["ejercicios"] for p in datos},
            guion=guion,
            taller=taller,
        )


def main():
    raiz, build, galeria, destino = (Path(ruta).resolve() for ruta in sys.argv[1:])
    Pagina(raiz, build, galeria, destino).escribe(catalogo.lee(build))
    ocupa = sum(f.stat().st_size for f in destino.rglob("*") if f.is_file())
    print(f"Hecha: {destino}/index.html ({ocupa / 1e6:.1f} MB en total)", file=sys.stderr)


if __name__ == "__main__":
    principal(main)
