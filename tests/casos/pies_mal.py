#!/usr/bin/env python3
"""pies_mal.py BUILD: a pies se le enseña una imagen de la que se sabe todo y, de cada clase, lo que es y lo que no; y
dos casos, con lo que es solo de uno y lo que es de los dos."""
import subprocess
import sys
import tempfile
from pathlib import Path

PIES = Path(sys.argv[1], "tests/pies").resolve()
ROJO, AZUL, FONDO = (217, 51, 46), (41, 97, 204), (242, 245, 250)
TALLAS = (480, 360), (960, 720), (960, 1080)
# del 4:3 central, sobre el fondo: x e y desde dónde, hasta dónde y de qué color
LISA = [(0.25, 0.25, 0.5, 0.75, ROJO), (0.5, 0.25, 0.75, 0.5, tuple(c // 2 for c in ROJO)), (0.9, 0.1, 1, 0.2, AZUL)]
OTRA = [*LISA, (0.4, 0.8, 0.5, 0.9, (255, 255, 255)), (0, 0.95, 0.1, 1, tuple(c - 12 for c in FONDO))]
CASI = [*LISA, (0.5, 0.9, 0.5625, 0.95, (255, 255, 255))]  # a tres milésimas
PARTIDA = [(0, 0, 0.5, 1, ROJO)]  # y, en la alta, azul
BIEN, MAL = 0, 1
AFIRMACIONES = (
    ("en 0.3 0.3 ROJO; en 0.3 0.3 (217,51,58); en 0.6 0.3 (108,25,23)", BIEN),
    *((f"en {p} {c}", MAL) for p, c in (("0.3 0.3", "AZUL"), ("0.3 0.3", "(217,51,59)"), ("0.6 0.3", "ROJO"))),
    *((f"en 0.3 0.3 ({r},{g},{b})", MAL) for r, g, b in ((204, 51, 46), (217, 64, 46), (217, 51, 33))),
    ("en 0.3 0.3 como 0.4 0.7; en 0.3 0.3 más claro que 0.6 0.3", BIEN),
    ("en 0.3 0.3 como 0.6 0.3", MAL),
    ("en 0.6 0.3 más claro que 0.3 0.3", MAL),
    ("en 0.3 0.3 más claro que 0.4 0.7", MAL),
    ("ROJO entero; VERDE ausente; AZUL cortado", BIEN),
    *((f"{c} {como}", MAL) for c, como in (("ROJO", "cortado"), ("ROJO", "ausente"), ("AZUL", "entero"))),
    *((f"VERDE {como}", MAL) for como in ("entero", "cortado")),
    ("ROJO 18.7 a 18.8 %; AZUL 0.9 a 1.1 %", BIEN),
    ("ROJO 18.8 a 20 %", MAL),
    ("ROJO 0 a 18.7 %", MAL),
    ("igual que lisa; distinta de otra en 0.9 a 1.1 %", BIEN),
    ("igual que otra", MAL),
    ("distinta de otra en 1.1 a 2 %", MAL),
    ("distinta de lisa en 0.1 a 2 %", MAL),
)
# junto a otro caso: si también es de su imagen, mal, salvo que sean casi iguales
OTRAS = (
    ("partida", "VERDE ausente", MAL),
    ("otra", "en 0.3 0.3 ROJO; VERDE ausente", MAL),
    ("partida", "en 0.6 0.3 (108,25,23); VERDE ausente", BIEN),
    ("casi", "VERDE ausente", BIEN),
)
NO_SON = (
    *("en 0.3 ROJO", "en 1 0.3 ROJO", "en 0.3 0.3", "en 0.3 0.3 PARDO", "en 0.3 0.3 (1,2)", "en 0.3 0.3 ROJO o AZUL"),
    *("ROJO", "ROJO roto", "ROJO 3 %", "ROJO 3 a 4", "ROJO entero a veces", "distinta en 3 a 4 %", "igual que"),
    *("en 0.3 0.3 más oscuro que 0.1 0.1"),
)


def dibuja(fichero, ancho, alto, cajas):
    arriba = (alto - ancho * 3 // 4) // 2
    filas = [[FONDO] * ancho for _ in range(alto)]
    for x0, y0, x1, y1, color in cajas:
        for y in range(round(y0 * (alto - 2 * arriba)), round(y1 * (alto - 2 * arriba))):
            filas[arriba + y][round(x0 * ancho) : round(x1 * ancho)] = [color] * (round(x1 * ancho) - round(x0 * ancho))
    fichero.write_bytes(b"P6\n%d %d\n255\n" % (ancho, alto) + bytes(c for fila in filas for p in fila for c in p))


def main():
    fallos = []
    with tempfile.TemporaryDirectory() as carpeta:
        for ancho, alto in TALLAS:
            partida = PARTIDA if alto < ancho else [(*PARTIDA[0][:4], AZUL)]
            for nombre, cajas in ("lisa", LISA), ("otra", OTRA), ("casi", CASI), ("partida", partida):
                dibuja(Path(carpeta, f"{nombre}-{ancho}x{alto}.ppm"), ancho, alto, cajas)

        def juzga(caso, afirmacion, esperado, *demas):
            hecho = subprocess.run([PIES, caso, afirmacion, *demas], cwd=carpeta, capture_output=True, text=True)
            bien = hecho.returncode == esperado and bool(hecho.stdout) == (esperado == MAL)
            if not bien or bool(hecho.stderr) != (esperado == 2):
                fallos.append(f"«{afirmacion}» de {caso}: {hecho.returncode} {hecho.stdout}{hecho.stderr}")

        for afirmacion, esperado in AFIRMACIONES:
            juzga("lisa", afirmacion, esperado)
        for afirmacion in NO_SON:
            juzga("lisa", afirmacion, 2)
        juzga("partida", "a 4:3: en 0.2 0.2 ROJO", BIEN)
        juzga("partida", "en 0.2 0.2 ROJO", MAL)
        for otra, afirmacion, esperado in OTRAS:
            juzga("lisa", afirmacion, esperado, otra, "")
    sys.exit("\n".join(fallos) or 0)


main()
