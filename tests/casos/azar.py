"""Escenas al azar, que dibuja usos.cpp: cada orden, unos triángulos que cubren la ventana, con el estado que se le
dice. Lo que ./lab explica debe decir de ellas sale de hacer aquí, con cada fragmento, lo que manda OpenGL."""
import json
import operator
import os
import random
import subprocess
import tempfile
from collections import namedtuple
from pathlib import Path

import explica, preguntado  # noqa: E401

ANCHO, ALTO, ORDENES, PIXELES = 24, 18, 40, 24
CUBRE = (-1, -1), (3, -1), (-1, 3)
GL = {**preguntado.GL, "GL_ZERO": 0, "GL_ONE": 1}
gl = lambda nombres: [f"GL_{nombre}" for nombre in nombres.split()]
IGUALAN = operator.lt, operator.eq, operator.le, operator.gt, operator.ne, operator.ge, lambda a, b: 0, lambda a, b: 1
COMPARA = dict(zip(gl("LESS EQUAL LEQUAL GREATER NOTEQUAL GEQUAL NEVER ALWAYS"), IGUALAN))
OPERA = gl("KEEP REPLACE INCR DECR INVERT INCR_WRAP DECR_WRAP")
FACTORES = gl("ZERO ONE SRC_COLOR DST_COLOR SRC_ALPHA DST_ALPHA ONE_MINUS_SRC_COLOR ONE_MINUS_DST_ALPHA")
ECUACIONES = gl("FUNC_ADD FUNC_SUBTRACT FUNC_REVERSE_SUBTRACT MIN MAX")
# Lo que va en su renglón. `activas`: si quita caras, recorta, mira la plantilla y la profundidad, y mezcla.
Orden = namedtuple("Orden", "activas caras caja plantilla hace profundidad mezcla canales color corta triangulos")


def una_orden(azar):
    una, hasta = azar.choice, azar.randrange
    return Orden(
        activas=[int(azar.random() < cuanto) for cuanto in (0.4, 0.3, 0.5, 0.8, 0.4)],
        caras=[una(gl("FRONT BACK BACK FRONT_AND_BACK")), una(gl("CW CCW"))],
        caja=[hasta(9), hasta(7), 5 + hasta(15), 5 + hasta(10)],
        plantilla=[una([*COMPARA, "GL_ALWAYS"]), hasta(4), una((1, 3, 255))],
        hace=[una(OPERA) for _ in range(3)],
        profundidad=[una([*COMPARA, "GL_LESS", "GL_LESS"]), int(hasta(5) > 0)],
        mezcla=[una(FACTORES), una(FACTORES), una(ECUACIONES)],
        canales=una([(1, 1, 1, 1)] * 4 + [(0, 0, 0, 0), (1, 0, 1, 1)]),
        color=[hasta(256) / 255 for _ in range(4)],
        corta=una((99, 99, 99, 12, 3)),
        triangulos=[
            [(x, y, z) for x, y in CUBRE[:: una((1, -1))]] for z in azar.sample((-0.5, 0, 0.25, 0.5), 1 + hasta(3))
        ],
    )


def en_texto(que):
    return " ".join(map(en_texto, que)) if isinstance(que, (list, tuple)) else str(GL.get(que, que))


def pruebas(orden, x, y, z, antihorario, plantilla, hondo):
    """Cada prueba, en su orden, y si la pasa."""
    quita, recorta, con_plantilla, con_profundidad, _ = orden.activas
    (cuales, frente), (funcion, ref, mascara), (desde, debajo, ancho, alto) = orden.caras, orden.plantilla, orden.caja
    suya = "GL_FRONT" if antihorario == (frente == "GL_CCW") else "GL_BACK"
    return {
        "cara": not (quita and cuales in (suya, "GL_FRONT_AND_BACK")),
        "recorte": not recorta or desde <= x < desde + ancho and debajo <= ALTO - 1 - y < debajo + alto,
        "descartado": x + 0.5 <= orden.corta,
        "plantilla": not con_plantilla or bool(COMPARA[funcion](ref & mascara, plantilla & mascara)),
        "profundidad": not con_profundidad or bool(COMPARA[orden.profundidad[0]](z, hondo)),
        "mascara": any(orden.canales),
    }


def historia(escena, x, y):
    """De cada triángulo, qué prueba pasa y qué se debe decir de él."""
    s, hondo = 0, 1
    for n, orden in enumerate(escena, 2):
        for cual, triangulo in enumerate(orden.triangulos):
            z, ref = triangulo[0][2] / 2 + 0.5, orden.plantilla[1]
            pasa = pruebas(orden, x, y, z, triangulo[0][1] == -1, s, hondo)
            que = next((prueba for prueba, bien in pasa.items() if not bien), "escrito")
            dice = {
                "cara": f"quitado por su cara ({orden.caras[0]})",
                "recorte": "fuera del recorte (glScissor)",
                "descartado": "el shader lo descarta (discard)",
                "plantilla": f"no pasa la plantilla: hay {s} y se pide {orden.plantilla[0]} {ref}",
                "profundidad": f"oculto: su profundidad es {z:g} y había {hondo:g} ({orden.profundidad[0]})",
                "mascara": "no escribe color (glColorMask)",
            }.get(que, que)
            if orden.activas[2] and que not in ("cara", "recorte", "descartado"):
                dan = s, ref, min(s + 1, 255), max(s - 1, 0), 255 - s, (s + 1) % 256, (s - 1) % 256
                hace = {"plantilla": 0, "profundidad": 1}.get(que, 2)
                s = dan[OPERA.index(orden.hace[hace])]
            if que in ("escrito", "mascara") and orden.activas[3] and orden.profundidad[1]:
                hondo = z
            sola = que != "escrito" and sum(pasa.values()) == len(pasa) - 1
            z = z if pasa["descartado"] else None
            yield pasa, [n, cual, que, dice, sola, z, [3 * cual, 3 * cual + 1, 3 * cual + 2], s, hondo]


def por_que_nada(orden, todas):
    """De las pruebas de todos sus fragmentos, la primera que no pasa ninguno; nada, si alguno las pasa."""
    motivos = {
        "cara": f"todas sus caras se quitan ({orden.caras[0]})",
        "descartado": "el shader descarta todos sus fragmentos (discard)",
        "recorte": "queda toda fuera del recorte (glScissor)",
        "plantilla": "ningún fragmento pasa la plantilla",
        "profundidad": f"ningún fragmento pasa el test de profundidad ({orden.profundidad[0]})",
    }
    for prueba, motivo in motivos.items():
        todas = [pasa for pasa in todas if pasa[prueba]]
        if not todas:
            return 0, motivo
    return len(todas), ""


def fallos(build, semilla):
    azar = random.Random(semilla)
    escena = [una_orden(azar) for _ in range(ORDENES)]
    deben = {(x, y): [*historia(escena, x, y)] for x in range(ANCHO) for y in range(ALTO)}
    elegidos = azar.sample([*deben], PIXELES)
    with tempfile.TemporaryDirectory() as carpeta:
        suyo = {"USO": "azar", "ORDENES": "\n".join(en_texto([*orden]) for orden in escena)}
        pone = {"LAB_EXPLICA": "e.json", "LAB_EXPLICA_PIXELES": " ".join(f"{x},{y}" for x, y in elegidos)}
        pone |= {**suyo, "LD_PRELOAD": str(build / "herramientas/explica/libexplica.so")}
        dibuja = [build / "osmesa/casos/usos", "-geometry", f"{ANCHO}x{ALTO}", "-ppm", "i.ppm"]
        subprocess.run(dibuja, env={**os.environ, **pone}, cwd=carpeta, check=True)
        cuadro = json.loads(Path(carpeta, "e.json").read_text())
        hallados = [*preguntado.fallos(cuadro, preguntado.pregunta(dibuja, build, Path(carpeta), **suyo))]
    for sitio, explicado in zip(elegidos, cuadro["pixeles"]):
        hallados += explica.fallos_de_historia(explicado["historia"])
        for suceso in explicado["historia"]:
            for que in ("profundidad", "profundidadDespues"):
                suceso[que] = round(suceso[que], 6) if que in suceso else None
        cosas = "orden primitiva veredicto dice soloEsa profundidad vertices plantillaDespues profundidadDespues"
        dichos = [[suceso.get(que) for que in cosas.split()] for suceso in explicado["historia"][1:]]
        for dicho, (_, debe) in zip(dichos, deben[sitio]):
            if dicho != debe:
                hallados.append(f"en {sitio} se dice {dicho} y es {debe}")
        if len(dichos) != len(deben[sitio]):
            hallados.append(f"en {sitio} se dicen {len(dichos)} sucesos y son {len(deben[sitio])}")
    for n, (dicha, orden) in enumerate(zip(cuadro["ordenes"][1:], escena), 2):
        debe = por_que_nada(orden, [pasa for suyos in deben.values() for pasa, suceso in suyos if suceso[0] == n])
        if len(orden.triangulos) > 1 and orden.activas[2]:  # lo que hace uno en la plantilla le vale al siguiente
            debe = debe[0], dicha["nada"]
        if (dicha["fragmentos"], dicha["nada"]) != debe:
            hallados.append(f"la orden {n} escribe {debe} fragmentos, y se dice {dicha['fragmentos'], dicha['nada']}")
    return [f"azar {semilla}: {fallo}" for fallo in hallados]
