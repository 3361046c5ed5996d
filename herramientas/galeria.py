#!/usr/bin/env python3
"""galeria.py RAÍZ BUILD DESTINO: dibuja cada caso de build/casos.tsv sin ventana y escribe DESTINO/index.html.

Cada imagen se dibuja al doble de tamaño y se reduce a la mitad, para que los bordes salgan suavizados. De los casos con
ANIMA se hace, además de la imagen, un APNG de tantos cuadros, a la mitad de tamaño. Solo se rehace lo que ha cambiado: DESTINO/.hecho.json recuerda de qué (programa, shaders, guion) salió cada imagen y qué escribió
entonces el programa. Si algún caso falla, la página lleva los demás y el estado es 1.
"""
import hashlib
import json
import os
import re
import signal
import struct
import subprocess
import sys
import tempfile
import zlib
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

import pagina

ANCHO, ALTO = 1920, 1440
ENTRE_CUADROS = 100  # milisegundos
MAYOR_APNG = 1000000  # bytes: el que no cabe se hace con una paleta de 256 colores, o de 128, o de 64
SEGUNDOS = 300  # un programa que no acaba no detiene la galería


class Fallo(Exception):
    pass


def ejecuta(orden, **opciones):
    try:
        proceso = subprocess.run(orden, stdin=subprocess.DEVNULL, capture_output=True, timeout=SEGUNDOS, **opciones)
    except subprocess.TimeoutExpired:
        raise Fallo(f"no ha acabado en {SEGUNDOS} segundos") from None
    if proceso.returncode:
        mensaje = proceso.stderr.decode(errors="replace").strip().splitlines()
        raise Fallo(mensaje[0] if mensaje else f"ha acabado con estado {proceso.returncode}")
    return proceso.stdout


def a_escala(guion, ancho):
    """Los guiones de los casos dan el ratón en una ventana de 240×180, la de los golden."""
    return re.sub(r"\b(boton \w+ \w+|arrastra|mueve|rueda [+-]?1) (-?\d+) (-?\d+)",
                  lambda m: f"{m[1]} {int(m[2]) * ancho // 240} {int(m[3]) * ancho // 240}", guion)


def a_la_mitad(ppm):
    mitad = ppm.with_suffix(".mitad")
    mitad.write_bytes(ejecuta(["pamscale", "-linear", "0.5", ppm]))  # la media de cada 2×2
    ppm.unlink()
    return mitad


def apng(tira, cuadros):
    """El APNG que enseña, uno tras otro y sin fin, los cuadros que el PNG `tira` tiene uno debajo de otro. Sus filas se reparten
    tal cual: ninguna debe estar filtrada con la de encima."""
    def trozo(tipo, datos):
        return struct.pack(">I", len(datos)) + tipo + datos + struct.pack(">I", zlib.crc32(tipo + datos))

    lugar, cabecera, paleta, comprimido = 8, b"", b"", b""
    while lugar < len(tira):
        largo, tipo = struct.unpack_from(">I4s", tira, lugar)
        datos = tira[lugar + 8:lugar + 8 + largo]
        if tipo == b"IHDR":
            cabecera = datos
        elif tipo == b"PLTE":
            paleta = trozo(tipo, datos)
        elif tipo == b"IDAT":
            comprimido += datos
        lugar += 12 + largo
    ancho, alto = struct.unpack(">II", cabecera[:8])
    alto //= cuadros
    filas = zlib.decompress(comprimido)
    largo = len(filas) // cuadros
    salida = [tira[:8], trozo(b"IHDR", struct.pack(">II", ancho, alto) + cabecera[8:]),
              trozo(b"acTL", struct.pack(">II", cuadros, 0)), paleta]
    for i in range(cuadros):  # de orden van 0; 1, 2; 3, 4…: el primer cuadro es un IDAT y los demás, fdAT
        datos = zlib.compress(filas[i * largo:(i + 1) * largo], 9)
        salida.append(trozo(b"fcTL", struct.pack(">IIIIIHHBB", max(2 * i - 1, 0), ancho, alto, 0, 0, ENTRE_CUADROS, 1000, 0, 0)))
        salida.append(trozo(b"fdAT", struct.pack(">I", 2 * i) + datos) if i else trozo(b"IDAT", datos))
    return b"".join([*salida, trozo(b"IEND", b"")])


def escribe(fichero, datos):
    """Entero o nada."""
    fichero.parent.mkdir(parents=True, exist_ok=True)
    parcial = fichero.with_suffix(".parcial")
    parcial.write_bytes(datos)
    parcial.replace(fichero)


class Galeria:
    def __init__(self, raiz, build, destino):
        self.build, self.destino = build, destino
        self.sin_ventana = (build / "sin_ventana").read_text().strip()
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
        ejecutable = self.build / self.sin_ventana / programa.capitulo / programa.nombre
        png = self.destino / caso.imagen
        ficheros = [] if programa.consola else [png, self.destino / caso.animada] if caso.anima else [png]
        clave = hashlib.sha1(repr((self.comunes, caso.guion, caso.argumentos, caso.anima)).encode() +
                             ejecutable.read_bytes()).hexdigest()
        anterior = self.hecho.get(caso.imagen, {})
        if anterior.get("clave") == clave and all(f.is_file() and f.stat().st_size for f in ficheros):
            caso.salida = anterior["salida"]
            return False
        for fichero in ficheros:
            fichero.unlink(missing_ok=True)
        self.hecho.pop(caso.imagen, None)
        orden = [ejecutable, *caso.argumentos.split()]
        ppm = temporal / f"{caso.fichero}.ppm"
        if not programa.consola:
            orden += ["-geometry", f"{ANCHO}x{ALTO}", "-ppm", ppm]
        if caso.guion:
            orden += ["-guion", a_escala(caso.guion, ANCHO)]
        caso.salida = ejecuta(orden, cwd=temporal).decode(errors="replace")
        if not programa.consola:
            mitad = a_la_mitad(ppm)
            escribe(png, ejecuta(["pnmtopng", "-quiet", mitad]))
            mitad.unlink()
        if caso.anima:
            with tempfile.TemporaryDirectory(dir=temporal) as carpeta:
                escribe(self.destino / caso.animada, self.anima(ejecutable, caso, Path(carpeta)))
        self.hecho[caso.imagen] = {"clave": clave, "salida": caso.salida}
        return True

    def anima(self, ejecutable, caso, carpeta):
        """El APNG de un caso: desde donde lo deja su guion, ANIMA dice cuántos cuadros y la orden que lleva al siguiente."""
        cuadros, paso = caso.anima.split(maxsplit=1)
        nombres = [f"{i:03}.ppm" for i in range(int(cuadros))]
        guion = "; ".join([a_escala(caso.guion, ANCHO // 2), *(f"captura {nombre}; {paso}" for nombre in nombres)])
        ejecuta([ejecutable, *caso.argumentos.split(), "-geometry", f"{ANCHO // 2}x{ALTO // 2}", "-ppm", "x", "-guion", guion],
                cwd=carpeta)
        tira, mapa, con_paleta = (carpeta / nombre for nombre in ("tira", "mapa", "con_paleta"))
        tira.write_bytes(ejecuta(["pnmcat", "-topbottom", *(a_la_mitad(carpeta / nombre) for nombre in nombres)]))
        resultado = apng(ejecuta(["pnmtopng", "-quiet", "-force", "-sub", tira]), len(nombres))
        for colores in 256, 128, 64:
            if len(resultado) <= MAYOR_APNG:
                break
            mapa.write_bytes(ejecuta(["pnmcolormap", str(colores), tira]))
            con_paleta.write_bytes(ejecuta(["pnmremap", f"-mapfile={mapa}", tira]))
            resultado = apng(ejecuta(["pnmtopng", "-quiet", "-nofilter", con_paleta]), len(nombres))
        return resultado

    def dibuja_programa(self, programa, temporal):
        """Todos los casos de un programa. Devuelve la línea que lo cuenta; cada caso recuerda su fallo."""
        hechas = 0
        for caso in programa.casos:
            try:
                hechas += self.dibuja(programa, caso, temporal)
            except (Fallo, OSError) as fallo:
                caso.fallo = str(fallo)
        fallos = [f"{caso.fichero} ha fallado: {caso.fallo}" for caso in programa.casos if caso.fallo]
        hecho = f"{hechas} {'imagen' if hechas == 1 else 'imágenes'}" if hechas else "sin cambios"
        return "; ".join(fallos) or hecho

    def dibuja_todo(self, programas):
        with tempfile.TemporaryDirectory() as temporal, ThreadPoolExecutor(os.cpu_count()) as hilos:
            pendientes = {hilos.submit(self.dibuja_programa, p, Path(temporal)): p for p in programas}
            try:
                for n, pendiente in enumerate(as_completed(pendientes), 1):
                    programa = pendientes[pendiente]
                    print(f"[{n:2}/{len(programas)}] {programa.capitulo}/{programa.nombre}: {pendiente.result()}",
                          file=sys.stderr)
            except BaseException:
                hilos.shutdown(cancel_futures=True)
                raise
            finally:
                self.registro.write_text(json.dumps(self.hecho, ensure_ascii=False))


def main():
    raiz, build, destino = map(Path, sys.argv[1:])
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    destino.mkdir(parents=True, exist_ok=True)
    capitulos = pagina.lee_catalogo(build)
    programas = [p for capitulo in capitulos for p in capitulo.programas]
    try:
        Galeria(raiz, build, destino).dibuja_todo(programas)
    except KeyboardInterrupt:
        sys.exit(130)
    pagina.escribe(raiz, destino, capitulos)
    print(f"Hecha: {destino}/index.html", file=sys.stderr)
    fallidos = [p.nombre for p in programas if any(caso.fallo for caso in p.casos)]
    if fallidos:
        sys.exit(f"lab: no se ha podido dibujar todo: {', '.join(fallidos)}")


main()
