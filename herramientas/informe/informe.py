"""informe.py RAÍZ BUILD DESTINO [--ensayo] [TÉCNICA…]: cronometra las técnicas de herramientas/mide y el coste de los
programas, y escribe DESTINO/index.html, con un TSV y un SVG por técnica.

Sin técnicas se miden todas y la tabla de costes. --ensayo: tallas diminutas; comprueba que cada TSV está bien formado
y que los errores son los de herramientas/mide/ensayo.tsv, y no escribe nada; con --apunta, escribe ese fichero.
LAB_PARES=1 añade los programas con los que se compara.
"""
import math
import shutil
import statistics
import sys
import time
from pathlib import Path

from base import paginas
from base.procesos import Fallo, ejecuta, escribe, principal
from informe import costes
from informe.cocientes import cociente, intervalo
from informe.tecnicas import Tecnica, mide

ESPERADOS = "herramientas/mide/ensayo.tsv"
# Lo que deben ganar los programas: qué, técnica, la variante lenta, la rápida y cuántas veces más rápida se pide
METAS = """
la superficie a 0.5 px, frente a GLU|superficies|par: GLU, pidiendo 0.04 px|cota de la tira, 0.5 px|10
separable de 15×15, frente a la directa|convolucion|directa, 15×15|separable, float, 15×15|5
separable de 15×15, frente a ImageMagick|convolucion|par: ImageMagick, 15×15|separable, float, 15×15|1
el volumen de ruido, frente a libnoise|ruido|par: libnoise|textura de 64³, hacerla|1
un millón, frente a los puntos pelados|particulas|suelo: un millón de puntos quietos|un millón, fórmula en la GPU|0.8
"""


def del_ensayo(tecnica):
    """Las variantes que se miran en él: no las que dependen de LAB_PARES."""
    return [v for v in tecnica.variantes if not v.par or "glm::" in v.nombre]


def comprueba(tecnica, esperados):
    """Los errores del ensayo, en el orden de sus variantes, son siempre los mismos, salvo el redondeo: si no, se ha
    roto una o la cuenta de su error."""
    hay = del_ensayo(tecnica)
    if len(hay) != len(esperados):
        raise Fallo(f"son {len(hay)} variantes y se esperaban {len(esperados)}")
    for v, e in zip(hay, esperados):
        if v.error != e and not abs(v.error - e) <= 0.15 * e + 0.001 and not (math.isnan(v.error) and math.isnan(e)):
            raise Fallo(f"«{v.nombre}» se equivoca {v.error:g} y se esperaba {e:g}")


def metas(tecnicas, tabla):
    """(qué, Cociente, lo que se pide, si debe ser mayor) de cada meta que se ha podido medir."""
    tiempos = {(t.nombre, v.nombre): v.tiempos for t in tecnicas for v in t.variantes}
    filas = [
        (f"{que}, veces más rápido", cociente(tiempos[t, lenta], tiempos[t, rapida]), float(pide), True)
        for que, t, lenta, rapida, pide in (fila.split("|") for fila in METAS.split("\n")[1:-1])
        if (t, lenta) in tiempos and (t, rapida) in tiempos
    ]
    rondas = list(zip(*(c.veces_suelo for c in tabla)))  # de cada ronda, lo de todos los programas
    if rondas:
        mediana = intervalo([statistics.median(r) for r in rondas])
        peor = max(tabla, key=lambda c: statistics.median(c.veces_suelo))
        que = "arranque de un programa entre el suelo"
        filas.append((f"{que}: mediana", mediana, 1.15, False))
        filas.append((f"{que}: el peor, {peor.programa}", intervalo(peor.veces_suelo), 2.5, False))
    return filas


def escribe_pagina(destino, tecnicas, **datos):
    """DESTINO/index.html, al lado de sus gráficas e imágenes."""
    graficas = {t.nombre for t in tecnicas if (destino / f"{t.nombre}.svg").exists()}
    paginas.escribe_pagina(
        destino, Path(__file__).with_name("informe.html"), tecnicas=tecnicas, lento=100, graficas=graficas, **datos
    )


def informa(raiz, build, destino, tecnicas, entorno, todo):
    """La página, con lo que se ha medido; y si es todo, con lo que cuesta cada programa."""
    tabla, suelo = [], []
    if todo:
        nombre = f"llenar {costes.TALLAS[-1].replace('x', '×')}"
        llenar = next((v.mediana for t in tecnicas for v in t.variantes if v.nombre == nombre), math.nan)
        tabla, suelo = costes.costes(raiz, build, destino, llenar)
    suelo = statistics.median(suelo or [math.nan])
    escribe_pagina(destino, tecnicas, metas=metas(tecnicas, tabla), costes=tabla, suelo=suelo, entorno=entorno)
    print(f"Hecho: {destino}/index.html", file=sys.stderr)


def main():
    raiz, build, destino = (Path(a).resolve() for a in sys.argv[1:4])
    apunta, ensayo = "--apunta" in sys.argv[4:], "--ensayo" in sys.argv[4:]
    pedidas = [a for a in sys.argv[4:] if a not in ("--ensayo", "--apunta")]
    if ensayo:
        filas = (fila.split("\t") for fila in (raiz / ESPERADOS).read_text().splitlines())
        esperados = {nombre: [float(error) for error in errores.split()] for nombre, errores in filas}
    ejecutable = build / "herramientas" / "mide" / "mide"
    todas = [Tecnica(*fila.split("\t")) for fila in ejecuta([ejecutable, "--lista"], text=True).splitlines()]
    for nombre in pedidas:
        if nombre not in [t.nombre for t in todas]:
            sys.exit(f"lab: no hay ninguna técnica «{nombre}»; hay {', '.join(t.nombre for t in todas)}")
    tecnicas = [t for t in todas if not pedidas or t.nombre in pedidas]
    if not ensayo:
        if not shutil.which("gnuplot"):
            raise Fallo("no encuentro gnuplot, con que se hacen las gráficas")
        destino.mkdir(parents=True, exist_ok=True)
    datos = {} if ensayo else costes.entorno(build)
    fallos = []
    for n, t in enumerate(tecnicas, 1):
        antes = time.monotonic()
        try:
            mide(ejecutable, t, destino, ensayo)
            if ensayo and not apunta:
                comprueba(t, esperados.get(t.nombre, []))
            hecho = f": {len(t.variantes)} variantes, {time.monotonic() - antes:.1f} s"
        except Fallo as fallo:
            fallos.append(t.nombre)
            hecho = f" ha fallado: {fallo}"
        print(f"[{n:2}/{len(tecnicas)}] {t.nombre}{hecho}", file=sys.stderr)
    if not ensayo:
        informa(raiz, build, destino, [t for t in tecnicas if t.variantes], datos, not pedidas)
    if apunta:
        esperados |= {t.nombre: [v.error for v in del_ensayo(t)] for t in tecnicas}
        filas = (f"{t}\t{' '.join(f'{e:g}' for e in errores)}\n" for t, errores in esperados.items())
        escribe(raiz / ESPERADOS, "".join(filas))
    if fallos:
        sys.exit(f"lab: no se ha podido medir todo: {', '.join(fallos)}")


if __name__ == "__main__":
    principal(main)
