"""dibuja.py RAÍZ BUILD DESTINO: compila los programas, dibuja cada caso del catálogo sin ventana en cuanto se puede y
escribe DESTINO/index.html, que se puede mirar desde el primero. Si no compila, el estado es 3.

Cada imagen se dibuja al tamaño que tendría proyectada, con EGL, que da las muestras que pida el programa, como una
ventana: los escalones que haya son los suyos. La página lleva su miniatura. De los casos con ANIMA se hacen además
tantos cuadros al tamaño de un proyector, que se pueden parar, y una animación más pequeña para la página. Solo se
rehace lo que ha cambiado: DESTINO/.hecho.json recuerda de qué (programa, guion y los ficheros que leyó) salió cada
imagen y qué escribió entonces el programa. Si algún caso falla, la página lleva los demás y el estado es 1.
"""
import functools
import hashlib
import json
import os
import re
import sys
import tempfile
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from base import catalogo, procesos
from base.construye import Taller
from base.procesos import Fallo, escribe
from galeria.pagina import PaginaGaleria

TALLA, PROYECTADA, ANIMADA = "1440x1080", "1280x960", "480x360"
MINIATURA = "-resize", "720", "540", "-q", "78", "-m", "4"
RITMO = "100"  # ms de cada cuadro; los pasa también proyector.mjs
WEBP = "-q", "72", "-m", "4"
CADA = 4  # segundos entre una página a medias y la siguiente
NO_COMPILA = 3
ejecuta = functools.partial(procesos.ejecuta, timeout=300)  # un programa que no acaba no detiene la galería


def lo_suyo(escrito, con_diario=False):
    """De lo que escribe un programa con -titulos, el último título y lo demás; con -diario, solo lo de la última orden
    que haya escrito algo: lo que dice al empezar es de otra imagen."""
    titulo, bloques = "", [""]
    for linea in escrito.splitlines(keepends=True):
        if linea.startswith("título: "):
            titulo = linea.removeprefix("título: ").rstrip()
        elif linea.startswith("diario\t"):
            bloques.append("")
        else:
            bloques[-1] += linea
    return titulo, next((b for b in reversed(bloques[con_diario:]) if b), "")


class Galeria:
    def __init__(self, raiz, build, destino, capitulos):
        self.raiz, self.build, self.destino = raiz, build, destino
        self.pagina = PaginaGaleria(raiz, destino, capitulos)
        self.programas = [p for capitulo in capitulos for p in capitulo.programas]
        self.registro = destino / ".hecho.json"
        self.turno, self.escrita, self.dibujados, self.a_medias = threading.Lock(), 0, 0, False
        try:
            self.hecho = json.loads(self.registro.read_text())
        except (OSError, ValueError):
            self.hecho = {}

    @functools.cache
    def suma(self, ruta):
        """La de un fichero que leen los programas, de los hechos al compilar o de los fuentes; vacía, si ya no está."""
        for carpeta in (self.build, self.raiz):
            if (carpeta / ruta).is_file():
                return hashlib.sha1((carpeta / ruta).read_bytes()).hexdigest()
        return ""

    def al_dia(self, caso, clave, ficheros):
        anterior = self.hecho.get(caso.imagen, {})
        return (
            anterior.get("clave") == clave
            and all(self.suma(ruta) == suma for ruta, suma in anterior["leidos"].items())
            and all(f.is_file() and f.stat().st_size for f in ficheros)
        )

    def dibuja(self, programa, caso, temporal):
        """Hace la imagen de un caso si no está al día. Dice si la ha hecho."""
        ejecutable = programa.ejecutable(self.build, "egl")
        png, miniatura = self.destino / caso.imagen, self.destino / caso.miniatura
        animada, cuadros = self.destino / caso.animada, [self.destino / c for c in caso.cuadros]
        ficheros = [] if programa.consola else [png, miniatura, *([animada, *cuadros] if caso.anima else [])]
        como = TALLA, MINIATURA, caso.guion, caso.anima and (PROYECTADA, ANIMADA, RITMO, WEBP, caso.anima)
        clave = hashlib.sha1(repr(como).encode() + ejecutable.read_bytes()).hexdigest()
        if self.al_dia(caso, clave, ficheros):
            caso.ventana, caso.salida = (self.hecho[caso.imagen][dato] for dato in ("ventana", "salida"))
            return False
        for fichero in ficheros:
            fichero.unlink(missing_ok=True)
        orden = [ejecutable]
        ppm, leidos = temporal / f"{caso.fichero}.ppm", temporal / f"{caso.fichero}.leidos"
        if not programa.consola:
            orden += ["-titulos", "-", "-geometry", TALLA, "-ppm", ppm]
        if caso.guion:
            orden += ["-guion", caso.guion]
        suyo = {"LAB_LEIDOS": leidos, "LAB_SUAVIZA": "1"}
        escrito = ejecuta(orden, cwd=temporal, env={**os.environ, **suyo}).decode(errors="replace")
        caso.ventana, caso.salida = lo_suyo(escrito)
        if caso.guion and caso.salida:
            caso.salida = lo_suyo(ejecuta([*orden, "-diario"], cwd=temporal).decode(errors="replace"), True)[1]
        if not programa.consola:
            escribe(png, procesos.en_png(ppm, 3))
            escribe(miniatura, ejecuta(["cwebp", "-quiet", *MINIATURA, ppm, "-o", "-"]))
            ppm.unlink()
        if caso.anima:
            with tempfile.TemporaryDirectory(dir=temporal) as carpeta:
                self.anima(ejecutable, caso, Path(carpeta), animada, cuadros)
        rutas = [str(f.relative_to(self.raiz)) for f in programa.ficheros(self.raiz)]
        rutas += leidos.read_text().splitlines() if leidos.exists() else []
        dice = {"ventana": caso.ventana, "salida": caso.salida}
        self.hecho[caso.imagen] = {"clave": clave, "leidos": {ruta: self.suma(ruta) for ruta in rutas}, **dice}
        return True

    def anima(self, ejecutable, caso, carpeta, animada, cuadros):
        """Los cuadros de un caso y su animación: desde donde lo deja su guion, ANIMA dice cuántos son y la orden que
        lleva al siguiente."""
        paso = caso.anima.split(maxsplit=1)[1]
        capturas = [carpeta / f"{i:03}.ppm" for i in range(len(cuadros))]
        guion = "; ".join([caso.guion, *(f"captura {c.name}; {paso}" for c in capturas)])

        def dibuja(talla):
            orden = [ejecutable, "-geometry", talla, "-ppm", "x", "-guion", guion]
            ejecuta(orden, cwd=carpeta, env={**os.environ, "LAB_SUAVIZA": "1"})

        dibuja(PROYECTADA)
        for captura, cuadro in zip(capturas, cuadros):
            escribe(cuadro, ejecuta(["cwebp", "-quiet", *WEBP, captura, "-o", "-"]))
        dibuja(ANIMADA)
        ejecuta(["img2webp", "-lossy", *WEBP, "-d", RITMO, *capturas, "-o", carpeta / "animada.webp"])
        escribe(animada, (carpeta / "animada.webp").read_bytes())

    def dibuja_programa(self, programa, temporal):
        """Todos los casos de un programa, y cuenta lo que ha hecho; cada caso recuerda su fallo."""
        hechas = 0
        for caso in programa.casos:
            try:
                hechas += self.dibuja(programa, caso, temporal)
            except Fallo as fallo:
                caso.fallo = str(fallo).splitlines()[0]
            except OSError as error:
                caso.fallo = f"{error.filename or caso.imagen}: {procesos.motivo(error)}"
            caso.hecho = True
        fallos = [f"{caso.fichero} ha fallado: {caso.fallo}" for caso in programa.casos if caso.fallo]
        hecho = f"{hechas} {'imagen' if hechas == 1 else 'imágenes'}" if hechas else "sin cambios"
        with self.turno:
            self.dibujados += 1
            n, todos = self.dibujados, len(self.programas)
            procesos.por_donde()  # donde iba el compilador
            cual = f"{programa.capitulo.nombre}/{programa.nombre}"
            print(f"[{n:2}/{todos}] {cual}: {'; '.join(fallos) or hecho}", file=sys.stderr)
            if n < todos and time.monotonic() > self.escrita + CADA:
                self.pagina.escribe(todos - n)
                self.escrita = time.monotonic()
                self.a_medias = True

    def dibuja_todo(self):
        """Cada programa, en cuanto se enlaza; los que ya lo estaban, al acabar de compilar."""
        if (self.destino / "index.html").exists():
            self.escrita = time.monotonic()
        por_compilar = {p.ejecutable(self.build, "egl"): p for p in self.programas}
        try:
            with tempfile.TemporaryDirectory() as temporal, ThreadPoolExecutor(os.cpu_count()) as hilos:
                trabajos = []
                try:
                    for linea in Taller.compilando(self.build, "galeria"):
                        enlazado = re.match(r"\[\d+/\d+\] Linking CXX executable (\S+)$", linea)
                        if programa := enlazado and por_compilar.pop(self.build / enlazado[1], None):
                            trabajos.append(hilos.submit(self.dibuja_programa, programa, Path(temporal)))
                except Fallo:
                    hilos.shutdown(cancel_futures=True)
                    sys.exit(NO_COMPILA)
                trabajos += [hilos.submit(self.dibuja_programa, p, Path(temporal)) for p in por_compilar.values()]
                for trabajo in trabajos:
                    trabajo.result()
        finally:
            escribe(self.registro, json.dumps(self.hecho, ensure_ascii=False))
            if self.a_medias:  # si se ha interrumpido, así queda
                self.pagina.escribe(len(self.programas) - self.dibujados, sigue=False)


def main():
    raiz, build, destino = map(Path, sys.argv[1:])
    destino.mkdir(parents=True, exist_ok=True)
    galeria = Galeria(raiz, build, destino, catalogo.lee(build))
    for programa in galeria.programas:
        if programa.captura:
            captura = (raiz / programa.fuente.with_suffix(".png")).read_bytes()
            escribe(destino / programa.fuente.with_suffix(".captura.png"), captura)
    galeria.dibuja_todo()
    galeria.pagina.escribe()
    print(f"Hecha: {destino}/index.html", file=sys.stderr)
    fallidos = [p.nombre for p in galeria.programas if any(caso.fallo for caso in p.casos)]
    if fallidos:
        sys.exit(f"lab: no se ha podido dibujar todo: {', '.join(fallidos)}")


if __name__ == "__main__":
    procesos.principal(main)
