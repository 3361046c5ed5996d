"""Lo que se cumple al pasar el tiempo."""
import tempfile
from pathlib import Path


def pausa(p):
    """Lo que se anima, sigue; con el reloj parado no pasa nada, y al seguir, el tiempo de la pausa no ha contado. Hay
    programas que empiezan parados."""
    if not p.anima or "tecla Espacio" not in p.teclas:
        return
    nada, luego = p.diario(["espera 960"])
    if luego.temporizadores < nada.temporizadores:
        yield "temporizador", "el temporizador no se vuelve a pedir"
    with tempfile.TemporaryDirectory() as carpeta:  # sin diario no se dibuja si nadie lo pide
        for i, guion in enumerate(("espera 960", "espera 960; especial F5")):
            p.ejecuta(["-guion", guion, "-ppm", f"{carpeta}/{i}"])
        if Path(carpeta, "0").read_bytes() != Path(carpeta, "1").read_bytes():
            yield "temporizador", "el temporizador no pide que se vuelva a dibujar"
    anda = [] if luego.distinta(nada) else ["tecla Espacio"]
    seguido = p.diario([*anda, "espera 960"])[-1]
    otra_pausa = ["tecla Espacio", "espera 640", "tecla Espacio", "espera 320"]
    guion = [*anda, "espera 320", "tecla Espacio", "espera 4960", "tecla Espacio", "espera 320", *otra_pausa]
    filas = p.diario(guion)[len(anda) :]
    if filas[2].titulo == filas[1].titulo:
        yield "título", "el título no dice que está en pausa"
    if filas[3].se_ve() != filas[2].se_ve():
        yield "pausa", "en la pausa cambia algo"
    if filas[9].se_ve() != seguido.se_ve():
        yield "pausa", f"tras dos pausas no se sigue donde se estaba: {seguido.titulo} y {filas[9].titulo}"
    filas = p.diario([*anda, "tecla Espacio ×40", "espera 960"])
    if filas[-1].se_ve() != seguido.se_ve():
        yield "pausa", "parar y seguir muchas veces en el mismo instante cambia algo"


def lento(p):
    """En un ordenador lento, a la misma hora, se ve lo mismo; y aunque todo llegue tarde, no se para."""
    if not p.anima:
        return
    horas = ["espera 4000", "espera 4000"]
    for anda in [], *([["tecla Espacio"]] if "tecla Espacio" in p.teclas else []):
        rapido = p.diario([*anda, *horas])[-2:]
        for cada in (200, 4000):
            despacio = p.diario([*anda, *horas], opciones=["-lento", str(cada)])[-2:]
            for deprisa, tarde in zip(rapido, despacio):
                if tarde.se_ve() != deprisa.se_ve():
                    yield "hora", f"a la misma hora, con -lento {cada}, {deprisa.titulo} es {tarde.titulo}"
            if rapido[0].distinta(rapido[1]) and not despacio[0].distinta(despacio[1]):
                yield "sigue", f"con -lento {cada} se para en {despacio[0].titulo}"


def conmuta(p):
    """En el mismo instante da igual pulsar una tecla y parar que parar y pulsarla. Tras cada dos se sigue, y así las
    dos partidas van a la par hasta la primera que no lo cumple."""
    if not p.anima or "tecla Espacio" not in p.teclas:
        return
    otras = [o for o in p.teclas if o != "tecla Espacio"]
    luego = ["tecla Espacio", "espera 340"]
    partidas = [
        p.diario(["tecla Espacio", "espera 500", *(o for tecla in otras for o in (*par(tecla), *luego))])[3:]
        for par in (lambda t: (t, "tecla Espacio"), lambda t: ("tecla Espacio", t))
    ]
    for i, tecla in enumerate(otras):
        una, otra = (filas[4 * i + 1] for filas in partidas)
        if una.se_ve() != otra.se_ve():
            yield tecla, f"«{tecla}» y parar no es parar y «{tecla}»: {una.titulo} y {otra.titulo}"
            return
