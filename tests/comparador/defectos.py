#!/usr/bin/env python3
"""defectos.py RAÍZ BUILD: el comparador acepta lo que debe y rechaza lo demás: textura_objeto con una cosa estropeada
en un shader y, después, su imagen con unos píxeles cambiados, a uno y otro lado de cada límite."""
import math
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

RAIZ, BUILD = map(Path, sys.argv[1:])
MODOS = "", "--amplia", "--otro"
COLOR, SITIO = "colorFragmento = (.*);", "gl_Position = (.*);"
SHADERS = (  # qué se estropea, en qué shader y cómo; nada lo disculpa
    ("la luz gira 5 grados", "frag", r"-5\.0, 2\.5", "-5.199, 2.055"),
    ("sin textura", "frag", r"texture\(Img, nuevaCoordTextura\)\.rgb", "vec3(0.6)"),
    ("rojo por azul", "frag", COLOR, r"colorFragmento = (\1).bgra;"),
    ("un 5 % más oscura", "frag", COLOR, r"colorFragmento = 0.95 * \1;"),
    ("corrida un píxel", "vert", SITIO, r"gl_Position = \1; gl_Position.x += gl_Position.w / 120.0;"),
    ("corrida medio píxel", "vert", SITIO, r"gl_Position = \1; gl_Position.x += gl_Position.w / 240.0;"),
    (
        "falta un trocito de 3×3",
        "frag",
        COLOR,
        r"\g<0> if (distance(gl_FragCoord.xy, vec2(120.5, 50.5)) < 2.0) discard;",
    ),
)
# Un componente de unos cuantos píxeles, los primeros, cambia unos niveles: qué estado da cada opción. 43 píxeles son
# el 0.1 % de 240×180. Allí el fondo es liso, y los 3×3 de alrededor no disculpan nada.
IGUAL_NO, NINGUNO = {"": 1, "--amplia": 0}, {"": 1, "--amplia": 1}
PIXELES = (
    (0, 1, 1, IGUAL_NO),
    *((c, 43200, 3, {**IGUAL_NO, "--otro": 0}) for c in range(3)),
    *((c, 43200, 4, NINGUNO) for c in range(3)),
    (1, 43, 10, IGUAL_NO),
    (2, 44, 4, NINGUNO),
    (0, 86, 10, NINGUNO),
    (2, 1, 32, IGUAL_NO),
    (2, 1, 33, NINGUNO),
    (1, 1, 120, NINGUNO),
    (0, 43200, 1, {"--redondeo": 0}),
    (0, 1, 2, {"--redondeo": 1}),
    (1, 432, 4, {"--otro": 0}),
    (1, 433, 4, {"--otro": 1}),
    (2, 43, 33, {"--otro": 0}),
    (2, 44, 33, {"--otro": 1}),
    # con permiso; con el mismo OpenGL no lo hay: idénticas
    (1, 86, 10, {"--amplia --tolerancia=0.2 3 32": 0, "--tolerancia=0.2 3 32": 1, "--amplia --tolerancia=0.2 3 9": 1}),
    (2, 86, 60, {"--otro --tolerancia=2 3 32": 0, "--otro --tolerancia=1 3 60": 0, "--otro --tolerancia=1 3 59": 1}),
)
NO_SON = "0.2 3", "0.2 3 32 1", "0,2 3 32", "0.2 3.5 32", "-1 3 32", "nan 3 32", ""  # tolerancias
fallos = []


def cambiada(buena, componente, cuantos, niveles):
    """Con esos píxeles niveles más allá; los primeros que se dan son los de abajo."""
    rgb = bytearray(buena[-3 * 43200 :])
    for y, x in (divmod(i, 240) for i in range(cuantos)):
        k = 3 * (240 * (179 - y) + x) + componente
        rgb[k] += niveles if rgb[k] + niveles <= 255 else -niveles
    return buena[: -3 * 43200] + rgb


def mancha(buena, ancho, alto, x0=5, y0=5):
    """Con un rectángulo negro ahí."""
    mala = bytearray(buena)
    for y in range(y0, y0 + alto):
        desde = len(buena) - 3 * 43200 + 3 * (240 * y + x0)
        mala[desde : desde + 3 * ancho] = bytes(3 * ancho)
    return mala


def espera(que, estado, buena, mala, opciones="", *dice):
    """Comparar la mala con la buena acaba con ese estado y dice todo eso."""
    Path("buena.ppm").write_bytes(buena)
    Path("mala.ppm").write_bytes(mala)
    palabras = re.split("(?: |^)(?=--)|=", opciones)[1:]
    compara = [BUILD / "herramientas/comparador/compara", "buena.ppm", "mala.ppm", *palabras]
    hecho = subprocess.run(compara, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    print(f"{que:34} {opciones:8} {hecho.stdout.split('; hecha')[0].strip()}")
    if hecho.returncode != estado or not all(d in hecho.stdout for d in dice):
        fallos.append(f"{que} {opciones}: ha acabado con {hecho.returncode}, y debía con {estado} diciendo «{dice}»")


def dibuja(extension="frag", de="", a=""):
    """La imagen de textura_objeto, con eso cambiado en uno de sus shaders."""
    shader = Path(f"ch06_texturas/textura_objeto.{extension}")
    Path("raiz", shader).write_text(re.sub(de, a, (RAIZ / shader).read_text(), count=1))
    programa = BUILD / (BUILD / "sin_ventana").read_text().strip() / "ch06_texturas/textura_objeto"
    subprocess.run(
        [programa, "-geometry", "240x180", "-ppm", "una.ppm"],
        env={**os.environ, "LAB_RAIZ": "raiz"},
        check=True,
        stderr=subprocess.DEVNULL,
    )
    Path("raiz", shader).unlink()
    return Path("una.ppm").read_bytes()


def main():
    Path("raiz/ch06_texturas").mkdir(parents=True)
    buena = dibuja()
    for modo in MODOS:
        espera("nada", 0, buena, dibuja(), modo)
        espera("sobra una raya", 1, buena, mancha(buena, 144, 2), modo)
        espera("falta una raya", 1, mancha(buena, 144, 2), buena, modo)
        for que, *defecto in SHADERS:
            espera(que, 1, buena, dibuja(*defecto), modo)
    for componente, cuantos, niveles, estados in PIXELES:
        mala = cambiada(buena, componente, cuantos, niveles)
        for opciones, estado in estados.items():
            que = f"{cuantos} píxeles a {niveles} niveles, {'RGB'[componente]}"
            psnr = 10 * math.log10(255**2 / (cuantos * niveles**2 / (3 * 43200)))
            medido = f"máximo {niveles} ", f"PSNR {psnr:.1f} dB"
            dice = {"--otro": ["otro OpenGL"], "--redondeo": ["a un nivel"]}.get(opciones[:10], medido)
            espera(que, estado, buena, mala, opciones, *dice)
    for alto in (2, 3):  # se perdona una mancha de 3×2, y no de 3×3, tampoco en los bordes
        for x, y in ((5, 5), (0, 0), (237, 0), (0, 180 - alto), (237, 180 - alto)):
            mala = mancha(buena, 3, alto, x, y)
            espera(f"una mancha de 3×{alto} en {x}, {y}", alto - 2, buena, mala, "--otro", "otro OpenGL")
    for mal in NO_SON:
        espera("tolerancia", 2, buena, buena, f"--amplia --tolerancia={mal}", "son PORCENTAJE NIVELES MAXIMO")
    for ancho, alto in (
        (239, 180),
        (240, 179),
        (241, 180),
        (240, 181),
        (180, 240),
    ):  # la última, con los mismos píxeles
        otra = buena[: -3 * 43200].replace(b"240 180", b"%d %d" % (ancho, alto)) + bytes(3 * ancho * alto)
        for modo in (*MODOS, "--redondeo"):
            espera(f"de {ancho}×{alto}", 2, buena, otra, modo, f"mala.ppm» {ancho}×{alto}")
            espera(f"de {ancho}×{alto}", 2, otra, buena, modo, f"buena.ppm» mide {ancho}×{alto}")
    # Sin sello no se sabe qué exigir. Una captura de una ventana de verdad no lo lleva, y se compara con --amplia.
    sin_sello = re.sub(rb"\n#.*", b"", buena, count=1)
    espera("obtenida sin sello", 2, buena, sin_sello, "", "«mala.ppm» no lleva el sello")
    espera("obtenida sin sello", 0, buena, sin_sello, "--amplia")
    for modo in MODOS[:2]:
        espera("golden sin sello", 2, sin_sello, buena, modo, "«buena.ppm» no lleva el sello")
    sys.exit("\n".join(fallos) or 0)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as carpeta:
        os.chdir(carpeta)
        main()
