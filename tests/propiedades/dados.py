"""Lo que se cumple con los ficheros que se le dan a un programa."""
import shlex
import subprocess
import tempfile
from pathlib import Path

from programa import APARTE

HAY = {"f.ppm": b"P6 7 5 255\n" + bytes(105), "f.rgb": bytes(105), "larga.rgb": bytes(3 * 32768)}
HAY |= {"f.png": b"\x89PNG\r\n", "texto.ppm": b"P3 1 1 255 1 2 3"}
HAY["mala.vf"] = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"
IMAGEN = """
    no_esta.ppm                | 1 | no puedo leer «no_esta.ppm»: no existe
    no_esta.rgb -talla 7x5     | 1 | no puedo leer «no_esta.rgb»: no existe
    f.rgb -talla 7x6           | 1 | una imagen RGB de 7×6 ocupa 126 bytes y hay 105
    f.rgb -talla 99999x1       | 1 | no hay texturas de 99999×1
    larga.rgb -talla 32768x1   | 1 | 32768×1 es demasiado grande: este OpenGL las admite de hasta 16384 de lado
    larga.rgb -talla 1x32768   | 1 | 1×32768 es demasiado grande: este OpenGL las admite de hasta 16384 de lado
    f.rgb                      | 2 | de un fichero RGB sin cabecera hay que decir -talla ANCHOxALTO
    f.rgb -talla               | 2 | detrás de -talla va el tamaño, ANCHOxALTO
    f.rgb -talla 7             | 2 | detrás de -talla va el tamaño
    f.rgb -talla 7x99999999999 | 2 | detrás de -talla va el tamaño
    -talla 7x5                 | 2 | y hay 0
    f.png                      | 1 | «f.png» es un PNG, y aquí se leen PPM binarios (P6) y RGB sin cabecera; se
    texto.ppm                  | 1 | no es un PPM binario (no empieza por P6); se convierte con
    f.rgb -talla 7x5 -talla 7x5| 2 | sobra «-talla»: solo se da
    f.ppm f.ppm                | 2 | sobra «f.ppm»: solo se da
    ''                         | 2 | «»"""
MAL = {  # lo que se le da, con qué estado acaba y lo que dice
    "modelo": "no_esta.vf | 1 | «no_esta.vf»: no existe\nmala.vf | 1 | mala.vf:4: el vértice 4 no existe: hay 3",
    "imagen": IMAGEN,
    "imagenes": IMAGEN + "\n=f.ppm | 2 | se dan 2 imágenes, y hay 1",
}


def pedidos(admite):
    """Qué se le da, con qué estado acaba y qué dice. Cada fichero va las veces que hagan falta."""
    for fila in MAL[admite].strip().splitlines() if admite else ():
        da, estado, dice = map(str.strip, fila.split("|"))
        veces = 2 if admite == "imagenes" and da[0] != "=" else 1
        palabras = [w for p in shlex.split(da.lstrip("=")) for w in [p] * (veces if "." in p else 1)]
        yield palabras, int(estado), dice


def dados(p):
    """Lo que no puede leer lo dice en una línea, y no dibuja nada."""
    with tempfile.TemporaryDirectory() as carpeta:
        for nombre, datos in HAY.items():
            Path(carpeta, nombre).write_bytes(datos)
        for palabras, estado, dice in pedidos(p.admite):
            orden = [p.ejecutable, *palabras, "-geometry", "9x9", "-ppm", "imagen.ppm"]
            r = subprocess.run(orden, cwd=carpeta, **APARTE)
            suya = r.stderr.startswith(f"{p.nombre}: ") and r.stderr.count("\n") == 1 and dice in r.stderr
            if r.returncode != estado or not suya or Path(carpeta, "imagen.ppm").exists():
                yield "dados", f"con {shlex.join(palabras)} acaba con estado {r.returncode} y dice: {r.stderr}"
                Path(carpeta, "imagen.ppm").unlink(missing_ok=True)
