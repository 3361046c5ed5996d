#!/usr/bin/env python3
"""galeria.py RAÍZ BUILD DESTINO: dibuja cada caso del catálogo sin ventana y escribe DESTINO/index.html.

Cada imagen se dibuja al tamaño que tendría proyectada y así se deja, sin reducirla: los escalones que haya son los del programa. De los
casos con ANIMA se hace además un APNG de tantos cuadros, más pequeño. Solo se rehace lo que ha cambiado:
DESTINO/.hecho.json recuerda de qué (programa, shaders, guion) salió cada imagen y qué escribió entonces el programa. Si algún
caso falla, la página lleva los demás y el estado es 1.
"""
import hashlib
import json
import os
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

import catalogo
import pagina
import procesos
from procesos import Fallo, escribe

TALLA, ANIMADA = "1440x1080", "480x360"
RITMO = "1", "10"  # segundos por cuadro, como fracción
SEGUNDOS = 300  # un programa que no acaba no detiene la galería


def ejecuta(orden, **opciones):
    """Del mensaje de un programa que falla, la primera línea."""
    try:
        return procesos.ejecuta(orden, timeout=SEGUNDOS, **opciones)
    except Fallo as fallo:
        raise Fallo(str(fallo).splitlines()[0]) from None


class Galeria:
    def __init__(self, raiz, build, destino):
        self.build, self.destino = build, destino
        self.registro = destino / ".hecho.json"
        try:
            self.hecho = json.loads(self.registro.read_text())
        except (OSError, ValueError):
            self.hecho = {}
        leidos = [*(raiz.glob(f"*/*.{tipo}") for tipo in ("vert", "frag", "glsl")), raiz.glob("assets/*"),
                  build.glob("assets/*.rgb")]
        ficheros = sorted(f for grupo in leidos for f in grupo if f.is_file())
        self.comunes = hashlib.sha1(b"".join(f.name.encode() + f.read_bytes() for f in ficheros)).hexdigest()

    def dibuja(self, programa, caso, temporal):
        """Hace la imagen de un caso si no está al día. Dice si la ha hecho."""
        ejecutable = programa.ejecutable(self.build)
        png = self.destino / caso.imagen
        ficheros = [] if programa.consola else [png, self.destino / caso.animada] if caso.anima else [png]
        clave = hashlib.sha1(repr((self.comunes, caso.guion, caso.anima)).encode() +
                             ejecutable.read_bytes()).hexdigest()
        anterior = self.hecho.get(caso.imagen, {})
        if anterior.get("clave") == clave and all(f.is_file() and f.stat().st_size for f in ficheros):
            caso.salida = anterior["salida"]
            return False
        for fichero in ficheros:
            fichero.unlink(missing_ok=True)
        orden = [ejecutable]
        ppm = temporal / f"{caso.fichero}.ppm"
        if not programa.consola:
            orden += ["-geometry", TALLA, "-ppm", ppm]
        if caso.guion:
            orden += ["-guion", caso.guion]
        caso.salida = ejecuta(orden, cwd=temporal).decode(errors="replace")
        if not programa.consola:
            escribe(png, ejecuta(["pnmtopng", "-quiet", ppm]))
            ppm.unlink()
        if caso.anima:
            with tempfile.TemporaryDirectory(dir=temporal) as carpeta:
                escribe(self.destino / caso.animada, self.anima(ejecutable, caso, Path(carpeta)))
        self.hecho[caso.imagen] = {"clave": clave, "salida": caso.salida}
        return True

    def anima(self, ejecutable, caso, carpeta):
        """El APNG de un caso: desde donde lo deja su guion, ANIMA dice cuántos cuadros y la orden que lleva al siguiente."""
        cuadros, paso = caso.anima.split(maxsplit=1)
        capturas = [carpeta / f"{i:03}.ppm" for i in range(int(cuadros))]
        guion = "; ".join([caso.guion, *(f"captura {c.name}; {paso}" for c in capturas)])
        ejecuta([ejecutable, "-geometry", ANIMADA, "-ppm", "x", "-guion", guion], cwd=carpeta)
        for captura in capturas:
            captura.with_suffix(".png").write_bytes(ejecuta(["pnmtopng", "-quiet", captura]))
        ejecuta(["apngasm", "animada.png", "000.png", *RITMO, "-z0"], cwd=carpeta)
        return (carpeta / "animada.png").read_bytes()

    def dibuja_programa(self, programa, temporal):
        """Todos los casos de un programa. Devuelve la línea que lo cuenta; cada caso recuerda su fallo."""
        hechas = 0
        for caso in programa.casos:
            try:
                hechas += self.dibuja(programa, caso, temporal)
            except Fallo as fallo:
                caso.fallo = str(fallo)
            except OSError as error:
                caso.fallo = f"{error.filename or caso.imagen}: {procesos.motivo(error)}"
        fallos = [f"{caso.fichero} ha fallado: {caso.fallo}" for caso in programa.casos if caso.fallo]
        hecho = f"{hechas} {'imagen' if hechas == 1 else 'imágenes'}" if hechas else "sin cambios"
        return "; ".join(fallos) or hecho

    def dibuja_todo(self, programas):
        try:
            with tempfile.TemporaryDirectory() as temporal, ThreadPoolExecutor(os.cpu_count()) as hilos:
                pendientes = {hilos.submit(self.dibuja_programa, p, Path(temporal)): p for p in programas}
                for n, pendiente in enumerate(as_completed(pendientes), 1):
                    programa = pendientes[pendiente]
                    print(f"[{n:2}/{len(programas)}] {programa.capitulo.nombre}/{programa.nombre}: {pendiente.result()}",
                          file=sys.stderr)
        finally:
            escribe(self.registro, json.dumps(self.hecho, ensure_ascii=False))


def main():
    raiz, build, destino = map(Path, sys.argv[1:])
    destino.mkdir(parents=True, exist_ok=True)
    capitulos = catalogo.lee(build)
    programas = [p for capitulo in capitulos for p in capitulo.programas]
    Galeria(raiz, build, destino).dibuja_todo(programas)
    for programa in programas:
        if programa.captura:
            escribe(destino / programa.fuente.with_suffix(".captura.png"), (raiz / programa.fuente.with_suffix(".png")).read_bytes())
    pagina.escribe(raiz, destino, capitulos)
    print(f"Hecha: {destino}/index.html", file=sys.stderr)
    fallidos = [p.nombre for p in programas if any(caso.fallo for caso in p.casos)]
    if fallidos:
        sys.exit(f"lab: no se ha podido dibujar todo: {', '.join(fallidos)}")


if __name__ == "__main__":
    procesos.principal(main)
