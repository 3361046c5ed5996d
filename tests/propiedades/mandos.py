"""Lo que se cumple con los mandos de un programa: las teclas, el ratón, el menú."""
import itertools
import re
import subprocess
from pathlib import Path
from typing import NamedTuple

from programa import APARTE, CONTRARIAS

DE_TODOS = 6  # teclas que dice -ayuda de todos los programas
LETRA = 23  # alto de las mayúsculas de F1 en 720 píxeles
LEJOS = 40, 300  # veces que se pulsa una tecla para llegar a su límite: si no bastan las primeras, las otras
VUELTAS = 6  # un modo de tres, dos veces
GOLDEN = Path(__file__).parents[1] / "golden/topes.tsv"
TOPES = dict(fila.rsplit("\t", 1) for fila in GOLDEN.read_text().splitlines())  # lo que dice el título en cada límite
PIXELES = (0, 0), (60, 45), (119, 89), (31, 70)


def nombres(p):
    """Lo que se nombra y lo que se atiende: las teclas, el ratón, la rueda, el menú."""
    atiende = {"ratón": {"raton", "arrastre"} & p.rasgos, "rueda": {"rueda"} & p.rasgos, "menú": p.opciones}
    dicen = {"ratón": ("ratón", "rrastra", "clic", "botón"), "rueda": ("rueda",), "menú": ("menú",)}
    if p.sin_linea:
        yield "línea", "falta «// Controles: … .», en las líneas que haga falta"
    filas = [] if p.nada_cambia(p.ajenas) else p.diario(p.ajenas)
    for orden, antes, fila in zip(p.ajenas, filas, filas[1:]):
        if fila.distinta(antes):
            yield "ajena", f"«{orden}» hace algo y no está en «// Controles:»"
    dice = p.dice.replace("botón derecho menú", "menú").replace("ratón orbita", "ratón orbita, rueda acerca")
    if p.cualquiera:
        dice += ", rueda"
    for que, palabras in dicen.items():
        nombra = any(palabra in dice for palabra in palabras)
        if nombra and not atiende[que]:
            yield que, f"«// Controles:» nombra {que} y el programa no lo atiende"
        if atiende[que] and not nombra:
            yield que, f"«// Controles:» no nombra {que} y el programa lo atiende"


def se_deshacen(nada, sube, baja, otra_vez, vuelve):
    """Si de dos teclas, una y otra por turno, una deshace la otra. El título puede decir cuál ha sido la última."""
    if sube != nada:
        return baja[0] == nada[0] and vuelve == baja
    return baja == nada or otra_vez[0] == nada[0]  # se empieza en el límite de la primera


class Extremo(NamedTuple):
    """Lo que se ve tras pulsar muchas veces una tecla, ella, su contraria y ella."""

    alli: tuple
    otra_mas: tuple
    de_vuelta: tuple
    otra_vez: tuple

    @property
    def es_limite(self):  # si no, da la vuelta
        return self.otra_mas == self.alli

    def mal(self, hacia, desde):
        if self.es_limite and self.de_vuelta == self.alli:
            yield hacia, f"pasado el límite de «{hacia}», «{desde}» no hace nada"
        if self.es_limite and self.otra_vez != self.alli:
            yield hacia, f"al límite de «{hacia}» no se vuelve por donde se fue"


def limites(p):
    """De dos teclas contrarias una deshace la otra, y pasado un rato. O dan la vuelta o llegan a un límite."""
    for c in p.controles:
        if set(c.teclas) not in CONTRARIAS or c.termina or None in map(p.antes_de, c.ordenes):
            continue
        mas, menos = c.ordenes
        antes = max(map(p.antes_de, c.ordenes), key=len)
        for veces in LEJOS:
            por_turno, arriba = [mas, menos, mas, menos], [f"{mas} ×{veces}", mas, menos, mas]
            abajo, otra_vez_arriba = [f"{menos} ×{2 * veces}", menos, mas, menos], [f"{mas} ×{2 * veces}", menos]
            filas = p.diario([*antes, *por_turno, *arriba, *abajo, *otra_vez_arriba])
            vistas = [fila.se_ve() for fila in filas[len(antes) :]]
            arriba, abajo, otra_vez_arriba = Extremo(*vistas[5:9]), Extremo(*vistas[9:13]), tuple(vistas[13:])
            if arriba.es_limite and abajo.es_limite:
                break
        if not se_deshacen(*vistas[:5]):
            yield mas, f"de «{mas}» y «{menos}» una no deshace la otra"
        yield from arriba.mal(mas, menos)
        yield from abajo.mal(menos, mas)
        for hacia, extremo in (mas, arriba), (menos, abajo):
            if (suyo := extremo.alli[1] if extremo.es_limite else None) != TOPES.get(f"{p.nombre}\t{hacia}"):
                yield hacia, f"el límite de «{hacia}» no es el de {GOLDEN.name}, sino «{suyo}»"
        if arriba.es_limite and abajo.es_limite and otra_vez_arriba != (arriba.alli, arriba.de_vuelta):
            yield mas, f"de un límite al otro de «{mas}» y «{menos}» no se llega donde se estaba"
        un_rato = ["tecla Espacio", "espera 2900", "tecla Espacio"] if p.anima and "tecla Espacio" in p.teclas else []
        filas = p.diario([*antes, *un_rato, *por_turno])[-5:] if un_rato else []
        if filas and not se_deshacen(*(fila.se_ve() for fila in filas)):
            yield mas, f"pasado un rato, de «{mas}» y «{menos}» una no deshace la otra"


def comparacion(p):
    """Con la comparación puesta toda tecla hace algo, o la deja."""
    if "tecla v" not in p.teclas:
        return
    for orden in p.teclas:
        if orden == "tecla v" or p.hace_algo(["tecla v"], orden):
            continue
        antes = p.antes_de(orden)
        if antes is None or p.hace_algo([*antes, "tecla v"], orden):
            continue
        if p.diario([*antes, "tecla v", orden])[-1].se_ve() != p.diario([*antes, orden])[-1].se_ve():
            yield orden, f"«{orden}» no hace nada en la comparación, ni la deja"


def vuelta(p):
    """De un modo se sale con la tecla con que se entró: pulsada otra vez, hace algo. Y de lo que se ve, con la misma
    tecla, se va siempre a lo mismo: si no, hay algo puesto que ni la imagen ni el título dicen."""
    mandan = [c for c in p.controles if set(c.teclas) not in CONTRARIAS and not c.termina]
    letras = [o for c in mandan for o in c.ordenes if o in p.teclas and o[-1].isalpha() and o.startswith("tecla ")]
    filas = iter(p.diario([o for orden in letras for o in [orden] * VUELTAS]))
    ultima = next(filas)
    for orden in letras:
        una, otra, *_ = suyas = list(itertools.islice(filas, VUELTAS))
        desde = p.antes_de(orden) or []
        if una.distinta(ultima) and not otra.distinta(una) and not p.hace_algo([*desde, orden], orden):
            yield orden, f"«{orden}» hace algo la primera vez y la segunda no"
        vistas = [fila.se_ve() for fila in (ultima, *suyas)]
        va = {}
        if any(va.setdefault(de, a) != a for de, a in zip(vistas, vistas[1:])):
            yield orden, f"de lo mismo a la vista, «{orden}» lleva a dos sitios"
        ultima = suyas[-1]


def ayuda(p):
    """F1, a 4:3, dice sus controles, lo que se toca en una columna y lo que hace en otra, con la letra de todos."""
    (vista,) = p.vistas(["especial F1", "captura"], talla="960x720")
    mandos, hacen = [q for q in vista.encima if q.tipo == "rotulo"][-2:] if len(vista.encima) > 1 else (None, None)
    columnas = zip(mandos.texto.split("\\n"), hacen.texto.split("\\n")) if mandos else ()
    dichos = " ".join(f"{mando} {hace}" for mando, hace in columnas).split()
    suyos = " ".join(" ".join(c.partes) for c in p.controles).split()
    if dichos[: len(suyos)] != suyos:
        yield "F1", f"F1 no dice sus controles: {' '.join(dichos)}"
    elif (mandos.talla, hacen.talla) != (LETRA, LETRA):
        yield "F1", f"la letra de F1 no es la de todos, {LETRA}: {mandos.talla}, {hacen.talla}"
    fin = {len(m.rstrip()) for m in mandos.texto.split("\\n") if m.strip()} if mandos else set()
    empieza = {len(h) - len(h.lstrip()) for h in hacen.texto.split("\\n") if h.strip()} if mandos else set()
    if len(fin) > 1 or empieza != {f + 2 for f in fin}:
        yield "F1", f"las columnas de F1 se tuercen: acaban en {fin} y empiezan en {empieza}"


def puntero(p):
    """F2 dice el píxel que hay bajo el puntero: dónde, como lo da el ratón, y su color en la imagen. Hasta que se mueve
    dice que hay que moverlo, y F3, que vigila."""
    mira = [orden for x, y in PIXELES for orden in (f"mueve {x} {y}", "captura")]
    for (x, y), sin, con in zip(PIXELES, p.vistas(mira), p.vistas(["especial F2", *mira])):
        debe = f"{x}, {y}\\n({', '.join(map(str, sin.filas[y][3 * x : 3 * x + 3]))})"
        dice = [q.texto for q in con.encima if q.tipo == "rotulo"][-1:]
        if dice != [debe]:
            yield "F2", f"F2 no dice «{debe}»: {dice}"
    for tecla, anuncia in ("F2", "mueve el ratón"), ("F3", "vigilo los shaders"):
        vistas = p.vistas([f"especial {tecla}", "captura", "espera 2100", "captura"])
        if [anuncia in [q.texto for q in vista.encima] for vista in vistas] != [True, False]:
            yield "F2", f"{tecla} no dice «{anuncia}» un rato, o no se va"
    orbita = ["boton IZQUIERDO abajo 60 60", "arrastra 90 50", "boton IZQUIERDO arriba 90 50", "captura"]
    if p.vistas(["especial F2 ×2", *orbita])[0].filas != p.vistas(orbita)[0].filas:
        yield "F2", "con F2 puesta y quitada, arrastrar no es lo mismo"


def comunes(p):
    """Lo que cambia con el tiempo se anima; F1 pone la ayuda, que es lo que dice «// Controles:», y la quita; F12
    guarda y lo dice, y Esc termina: tras él no hay fila; lo que sobra se dice. Lo que hace common/ solo, en uno de cada
    capítulo."""
    guion = ["espera 960", "especial F1", "especial F1", "especial F12", "tecla Esc"]
    antes, nada, puesta, quitada, guardada, *mas = p.diario(guion)
    if nada.distinta(antes) and not p.anima:
        yield "tiempo", "cambia con el tiempo y nadie pide que se vuelva a dibujar"
    if puesta.imagen == nada.imagen or quitada.imagen != nada.imagen or puesta.titulo != nada.titulo:
        yield "F1", "F1 no pone la ayuda, o no la quita"
    if not any(linea.startswith("guardado ") for linea in guardada.escrito):
        yield "F12", "F12 no guarda la ventana, o no lo dice"
    if mas:
        yield "Esc", "Esc no termina"
    for dados in (["uno"], ["uno", "dos"], ["uno", "dos", "tres"]):
        r = subprocess.run([p.ejecutable, *dados, "-ppm", "/dev/null"], **APARTE)
        if re.search("sobra|no entiendo", r.stderr):
            break
    if r.returncode != 2 or [dado for dado in dados if f"«{dado}»" in r.stderr] != dados[-1:]:
        yield "argumentos", f"con {' '.join(dados)} no dice que sobra lo último: {r.returncode}, {r.stderr}"
    if not p.ultimo:
        return
    yield from ayuda(p)
    yield from puntero(p)
    suyos = p.dice.split(" · ")
    lineas = p.ejecuta(["-ayuda"]).splitlines()[-len(suyos) - DE_TODOS :]
    if lineas[: len(suyos)] != suyos:
        yield "-ayuda", f"-ayuda no dice sus controles: {lineas}"


def mandos(p):
    """Todo lo que se nombra hace algo: lo ha hecho ya en algo de lo anterior o se busca tras qué."""
    for orden in p.mandos:
        if orden not in p.hechas and p.antes_de(orden) is None:
            yield orden, f"«{orden}» no hace nada, ni tras ninguna otra"


NOMBRADAS = {9, 10, 13, 27, *range(1, 13), *range(100, 109)}  # GLUT_KEY_F1… y las flechas
RARAS = [f"tecla {n}" for n in (*range(14, 27), *range(28, 32), *range(128, 256))]
RARAS += [f"especial {n}" for n in range(256) if n not in NOMBRADAS]
RARAS += [o for n in range(5, 9) for o in (f"boton {n} abajo 60 45", "arrastra 70 50", f"boton {n} arriba 70 50")]


def raras(p):
    """Lo que GLUT puede dar y nadie espera (más botones, teclas con Ctrl o de otros teclados) no hace nada."""
    rueda = [] if "rueda" in p.rasgos else ["rueda +1 60 45"]  # quien no la atiende la recibe como botones 3 y 4
    if p.cualquiera:
        p.diario(RARAS)
    elif not p.nada_cambia([*RARAS, *rueda]):
        yield "raras", "un botón del 5 al 8 o una tecla que no está en los teclados hace algo"
